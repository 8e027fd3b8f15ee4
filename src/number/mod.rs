//! Numbers: trigonometry that is the same on every machine, the output grid, roots, intervals and bounds.

pub mod bisection;
pub mod bound;
pub mod grid;
pub mod interval;
pub mod jet;
pub mod queue;
pub mod root;
pub mod trig;

/// A number for people: at most so many decimals, no trailing zeros, no negative zero.
#[must_use]
pub fn shown(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let text = if decimals > 0 { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// A number in the fewest digits that give it back; with an exponent where it is very large or very small.
#[must_use]
pub fn decimal(number: f64) -> String {
    let size = number.abs();
    if size == 0.0 {
        "0".to_owned()
    } else if (1e-4..1e15).contains(&size) {
        format!("{number}")
    } else {
        format!("{number:e}")
    }
}

/// A time in seconds as `1 h 02 min 03.4 s`, rounded down to the tenth, below a minute to the hundredth, for what stands as a least time
/// must not be above it; empty for a time that is none.
#[must_use]
pub fn duration(seconds: f64) -> String {
    if !seconds.is_finite() || seconds < 0.0 {
        return String::new();
    }
    // Text is the one way from a float to a whole number that cannot wrap.
    let Ok(hundredths) = format!("{:.0}", (seconds * 100.0 + 1e-6).floor()).parse::<u64>() else {
        return String::new();
    };
    let (total, tenth) = (hundredths / 100, hundredths / 10 % 10);
    match (total / 3600, total / 60 % 60, total % 60) {
        (0, 0, second) => format!("{second}.{:02} s", hundredths % 100),
        (0, minute, second) => format!("{minute} min {second:02}.{tenth} s"),
        (hour, minute, second) => format!("{hour} h {minute:02} min {second:02}.{tenth} s"),
    }
}

/// The greater of two numbers, the first of which is one: [`f64::max`] asks that of both, and takes six instructions for one.
#[must_use]
pub const fn greater(one: f64, other: f64) -> f64 {
    if other > one { other } else { one }
}

/// The lesser of two numbers, the first of which is one.
#[must_use]
pub const fn lesser(one: f64, other: f64) -> f64 {
    if other < one { other } else { one }
}

#[cfg(test)]
mod tests {
    use super::{decimal, duration, shown};

    #[test]
    fn times_are_readable() {
        assert_eq!(duration(3.2), "3.20 s");
        assert_eq!(duration(59.969), "59.96 s");
        assert_eq!(duration(64.1), "1 min 04.1 s");
        assert_eq!(duration(125.04), "2 min 05.0 s");
        assert_eq!(duration(3725.0), "1 h 02 min 05.0 s");
        assert_eq!(duration(f64::NAN), "");
    }

    #[test]
    fn numbers_for_people_are_short() {
        for (value, text) in [(2.0, "2"), (-0.0001, "0"), (4.5664, "4.566"), (100.0, "100"), (0.05, "0.05")] {
            assert_eq!(shown(value, 3), text);
        }
        assert_eq!(shown(100.0, 0), "100");
    }

    #[test]
    fn a_number_is_shown_in_its_shortest_form() {
        for (number, shown) in [
            (0.0, "0"),
            (-0.0, "0"),
            (1e308, "1e308"),
            (1e-320, "1e-320"),
            (0.1 + 0.2, "0.30000000000000004"),
            (-25.0, "-25"),
        ] {
            assert_eq!(decimal(number), shown);
        }
    }
}
