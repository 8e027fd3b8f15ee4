//! Numbers: trigonometry that is the same on every machine, the output grid, roots, intervals and bounds.

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

#[cfg(test)]
mod tests {
    use super::shown;

    #[test]
    fn numbers_for_people_are_short() {
        for (value, text) in [(2.0, "2"), (-0.0001, "0"), (4.5664, "4.566"), (100.0, "100"), (0.05, "0.05")] {
            assert_eq!(shown(value, 3), text);
        }
        assert_eq!(shown(100.0, 0), "100");
    }
}
