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

/// A time in seconds as `1 h 02 min 03.4 s`, to the tenth, below a minute to the hundredth; empty for a time that is none.
#[must_use]
pub fn duration(seconds: f64) -> String {
    spelt(seconds, f64::round)
}

/// The same rounded down, for what stands as a least time must not be above it.
#[must_use]
pub fn least_duration(seconds: f64) -> String {
    spelt(seconds, |parts| (parts + 1e-6).floor())
}

fn spelt(seconds: f64, to_whole: fn(f64) -> f64) -> String {
    if !seconds.is_finite() || seconds < 0.0 {
        return String::new();
    }
    // Text is the one way from a float to a whole number that cannot wrap.
    let parts = |parts: f64| format!("{:.0}", to_whole(seconds * parts)).parse::<u64>();
    let (Ok(hundredths), Ok(tenths)) = (parts(100.0), parts(10.0)) else { return String::new() };
    if hundredths < 6000 {
        return format!("{}.{:02} s", hundredths / 100, hundredths % 100);
    }
    let (total, tenth) = (tenths / 10, tenths % 10);
    match (total / 3600, total / 60 % 60, total % 60) {
        (0, minute, second) => format!("{minute} min {second:02}.{tenth} s"),
        (hour, minute, second) => format!("{hour} h {minute:02} min {second:02}.{tenth} s"),
    }
}

/// A whole number in groups of three, separated by narrow spaces.
#[must_use]
pub fn grouped(value: u64) -> String {
    let digits = value.to_string();
    let mut out = String::with_capacity(digits.len() * 2);
    for (at, digit) in digits.char_indices() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            out.push('\u{202F}');
        }
        out.push(digit);
    }
    out
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
    use super::{decimal, duration, grouped, least_duration, shown};

    #[test]
    fn times_are_readable() {
        assert_eq!(duration(3.2), "3.20 s");
        assert_eq!(duration(7.308), "7.31 s");
        assert_eq!(duration(59.969), "59.97 s");
        assert_eq!(duration(59.996), "1 min 00.0 s");
        assert_eq!(duration(64.1), "1 min 04.1 s");
        assert_eq!(duration(125.07), "2 min 05.1 s");
        assert_eq!(duration(3725.0), "1 h 02 min 05.0 s");
        assert_eq!(duration(f64::NAN), "");
    }

    #[test]
    fn a_least_time_is_never_above_the_time() {
        assert_eq!(least_duration(7.308), "7.30 s");
        assert_eq!(least_duration(59.999), "59.99 s");
        assert_eq!(least_duration(3.2), "3.20 s");
        assert_eq!(least_duration(125.09), "2 min 05.0 s");
        assert_eq!(least_duration(-1.0), "");
    }

    #[test]
    fn numbers_for_people_are_short() {
        for (value, text) in [(2.0, "2"), (-0.0001, "0"), (4.5664, "4.566"), (100.0, "100"), (0.05, "0.05")] {
            assert_eq!(shown(value, 3), text);
        }
        assert_eq!(shown(100.0, 0), "100");
    }

    #[test]
    fn large_whole_numbers_are_in_groups_of_three() {
        assert_eq!(grouped(1_234_567), "1\u{202F}234\u{202F}567");
        assert_eq!(grouped(12), "12");
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
