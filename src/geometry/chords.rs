//! Arcs as chords whose errors in area cancel.

use crate::limits::ARC_CHORDS;
use crate::number::trig::{atan2, hypot, sin_cos};

/// The widest angle of a chord, however great the tolerance.
const WIDEST: f64 = 0.25;

/// How many chords an arc takes to stay within a tolerance.
///
/// # Derivation
/// A chord over the angle h on a circle R lies R (1 − cos(h/2)), to h⁴ R h²/8, inside at its middle. The arc over it is a
/// parabola to that order, whose mean is two thirds of it: R h²/12. With the chord's ends R h²/12 outside, the areas outside
/// and inside are equal, to h⁴, and the greatest error is R h²/12, at the ends.
fn count(radius: f64, sweep: f64, tolerance: f64) -> u32 {
    let widest = (12.0 * tolerance / radius.max(tolerance)).sqrt().min(WIDEST);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 1 and ARC_CHORDS")]
    let count = (sweep.abs() / widest - 1e-9).ceil().clamp(1.0, ARC_CHORDS) as u32;
    count
}

/// The corners of an arc's chords after its start, in order, the last of them `end` itself; visits `[u, v]`.
///
/// `centre` and `start` as `[u, v]` in mm, `sweep` in radians from u towards v, `tolerance` in mm. Both ends are on the
/// arc, the corners between lie R h²/12 outside. Where the end is not as far from the centre as the start, the radius
/// changes evenly along the way.
pub fn corners(
    centre: [f64; 2],
    [start, end]: [[f64; 2]; 2],
    sweep: f64,
    tolerance: f64,
    mut visit: impl FnMut([f64; 2]),
) {
    let [du, dv] = [start[0] - centre[0], start[1] - centre[1]];
    let (radius, last) = (hypot(du, dv), hypot(end[0] - centre[0], end[1] - centre[1]));
    let angle = atan2(dv, du);
    let count = count(radius.max(last), sweep, tolerance);
    let h = sweep / f64::from(count);
    for at in 1..count {
        let part = f64::from(at) / f64::from(count);
        let (sin, cos) = sin_cos(angle + sweep * part);
        let out = (radius + (last - radius) * part) * (1.0 + h * h / 12.0);
        visit([centre[0] + out * cos, centre[1] + out * sin]);
    }
    visit(end);
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    #[test]
    fn chords_stay_within_the_tolerance_and_hold_the_arcs_area() {
        for tolerance in [0.01, 0.0002] {
            let mut corners_of = vec![[25.0, 0.0]];
            corners([0.0, 0.0], [[25.0, 0.0], [-25.0, 0.0]], PI, tolerance, |corner| corners_of.push(corner));
            let mut area = 0.0;
            for pair in corners_of.windows(2) {
                area += (pair[0][0] * pair[1][1] - pair[1][0] * pair[0][1]) / 2.0;
                let middle = hypot((pair[0][0] + pair[1][0]) / 2.0, (pair[0][1] + pair[1][1]) / 2.0);
                assert!((middle - 25.0).abs() <= tolerance * 1.001);
                assert!((hypot(pair[1][0], pair[1][1]) - 25.0).abs() <= tolerance * 1.001);
            }
            // The two chords at the ends are off by a third of the tolerance or so.
            let whole = PI * 625.0 / 2.0;
            assert!(((area - whole) / whole).abs() < tolerance * 0.002, "{area}");
        }
    }

    #[test]
    fn an_arc_ends_where_it_is_told() {
        let mut last = [0.0; 2];
        corners([1.0, 2.0], [[2.0, 2.0], [1.0, 3.001]], FRAC_PI_2, 0.001, |corner| last = corner);
        assert_eq!(last, [1.0, 3.001]);
    }
}
