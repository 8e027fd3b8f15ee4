//! Numbers: trigonometry that is the same on every machine, the output grid, roots, intervals and bounds.

pub mod bisection;
pub mod bound;
pub mod grid;
pub mod interval;
pub mod jet;
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

#[cfg(test)]
mod tests {
    use super::{decimal, shown};

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
