//! Round values along an axis.

use super::number::fixed;

/// About `count` round values from `from` to `to` with their texts; empty for a range that is none.
pub(super) fn ticks(from: f64, to: f64, count: u32) -> Vec<(f64, String)> {
    let range = to - from;
    if !(range.is_finite() && range > 0.0) || count == 0 {
        return Vec::new();
    }
    let (step, decimals) = step(range / f64::from(count));
    let mut found = Vec::new();
    let mut index = (from / step).ceil();
    while index * step <= to + step * 1e-9 && found.len() < 64 {
        found.push((index * step, fixed(index * step, decimals)));
        index += 1.0;
    }
    found
}

/// The least of 1, 2, 5 times a power of ten that is not below `least`, and the decimals to print it with.
fn step(least: f64) -> (f64, usize) {
    let mut power = 1.0;
    let mut decimals = 0;
    while power > least && decimals < 12 {
        power /= 10.0;
        decimals += 1;
    }
    while power * 10.0 <= least && power < 1e12 {
        power *= 10.0;
    }
    for factor in [1.0, 2.0, 5.0] {
        if power * factor >= least {
            return (power * factor, decimals);
        }
    }
    (power * 10.0, decimals.saturating_sub(1))
}

#[cfg(test)]
mod tests {
    use super::ticks;

    #[test]
    fn ticks_are_round_and_within_the_range() {
        let texts = |from, to, count| ticks(from, to, count).into_iter().map(|tick| tick.1).collect::<Vec<_>>();
        assert_eq!(texts(0.0, 40.0, 10), ["0", "5", "10", "15", "20", "25", "30", "35", "40"]);
        assert_eq!(texts(-0.1, 0.1, 4), ["\u{2212}0.10", "\u{2212}0.05", "0.00", "0.05", "0.10"]);
        assert_eq!(texts(0.0, 0.3, 3), ["0.0", "0.1", "0.2", "0.3"]);
        assert!(texts(1.0, 1.0, 4).is_empty());
        assert!(texts(0.0, f64::INFINITY, 4).is_empty());
    }
}
