//! Annex 1: the angle v along the meridian.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::number::grid::Milli;

/// v_i = π + i·h for i = 0 … n with h = (π/2)/n; the last point is backed off by `eps_v` steps.
///
/// The published tables end at v_n = 3π/2 − 1e-5·h, because an arctangent has a pole at 3π/2; with `eps_v` 0 the blade
/// goes up to the rim. Radians. n ≥ 1.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
pub fn v(n: usize, eps_v: f64) -> Vec<f64> {
    let h = FRAC_PI_2 / n as f64;
    (0..=n).map(|i| PI + h * if i == n { n as f64 - eps_v } else { i as f64 }).collect()
}

/// B at the point i of n on the output grid, halves away from zero: 90 000·(n − i)/n thousandths of a degree in whole
/// numbers. For n = 32, 96, 160, 800 … many of these lie exactly between two thousandths, and the last bit of an angle in
/// radians must not decide. The last point with a back-off is none of them. n ≥ 1; `None` for i > n and beyond the grid.
#[must_use]
pub fn B_on_grid(n: usize, i: usize) -> Option<Milli> {
    let twice = 2 * 90_000 * u64::try_from(n.checked_sub(i)?).ok()?;
    let n = u64::try_from(n).ok()?;
    let thousandths = (twice + n).checked_div(2 * n)?;
    Some(Milli::new(i32::try_from(thousandths).ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A tie in thousandths is 90 000·j/n = m + 1/2; its place on the grid is m + 1.
    #[test]
    fn ties_of_B_go_away_from_zero_whatever_a_sine_says() {
        let mut ties = 0;
        for n in [32_u32, 96, 160, 224, 800] {
            for i in 0..=n {
                let at = |count: u32| usize::try_from(count).unwrap_or(usize::MAX);
                let Some(B) = B_on_grid(at(n), at(i)) else { panic!("n {n}, i {i}") };
                let n = i64::from(n);
                let over = 2 * i64::from(B.thousandths()) * n - 180_000 * (n - i64::from(i));
                assert!(over.abs() <= n && over != -n, "n {n}, i {i}: {B:?}");
                ties += usize::from(over == n);
            }
        }
        assert_eq!(ties, 16 + 48 + 80 + 16 + 400);
    }

    #[test]
    fn what_is_no_point_has_no_B() {
        assert_eq!(B_on_grid(0, 0), None);
        assert_eq!(B_on_grid(4, 5), None);
    }
}
