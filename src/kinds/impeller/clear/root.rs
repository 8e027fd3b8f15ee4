//! What a flat end leaves in the corner between a face and the floor, and the largest tool that leaves no more than is
//! allowed.
//!
//! # Derivation
//! On a flank the axis is parallel to the face and the end lies in the ball of radius r_f. At the rim, where the tube is
//! bent the most across the blade, the end so stands above the floor at the face by
//!
//! > c_r ≤ √(r_f² − ((e/2)·cos α)²) − √(r_f² − (a + w·cos α)²), w = e/2 + a;
//!
//! a corner radius takes the ends of the flat nearer to the axis and adds itself. Own-normal lanes reach the floor but lean
//! against the top edge by about w·κ_b: they stay away from the root by a_p·w·κ_b at most. Both passes leave only what both
//! miss.
//!
//! # Units
//! Millimetres.

use crate::kinds::impeller::clear::tool::Tool;
use crate::kinds::impeller::part::{Part, RIM};

/// What is left in the corner, at most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Root {
    /// Up the face.
    pub height: f64,
    /// Along the floor.
    pub width: f64,
}

/// The smallest tool that is offered.
const SMALLEST: f64 = 0.1;

/// What a tool leaves.
#[must_use]
pub fn root(part: &Part, tool: Tool) -> Root {
    let torus = part.circle.torus;
    let (r_f, cos_alpha) = (torus.r + part.a_p, part.circle.k / torus.R);
    let w = part.e / 2.0 + tool.a();
    let inner = part.e / 2.0 * cos_alpha;
    let (ball, reach) = (r_f - tool.r_c, tool.flat_radius() + w * cos_alpha);
    let floor = (r_f * r_f - inner * inner).max(0.0).sqrt();
    let end = (ball * ball - reach * reach).max(0.0).sqrt() + tool.r_c;
    Root { height: (floor - end).max(0.0) + tool.r_c, width: (part.a_p * w * part.across(RIM)).max(0.0) + tool.r_c }
}

/// The largest flat end mill up to a diameter that leaves no more than `height` up the face; `None` where even the
/// smallest leaves more.
#[must_use]
pub fn largest(part: &Part, height: f64, up_to: f64) -> Option<f64> {
    let leaves = |d: f64| root(part, Tool::flat(d)).height;
    if leaves(SMALLEST) > height {
        return None;
    }
    let (mut low, mut high) = (SMALLEST, up_to.max(SMALLEST));
    if leaves(high) <= height {
        return Some(high);
    }
    for _ in 0..50 {
        let middle = f64::midpoint(low, high);
        if leaves(middle) <= height { low = middle } else { high = middle }
    }
    Some(low)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::torus::Torus;

    #[test]
    fn heights_are_those_of_the_check_values() {
        for (R, r, e, a_p, height) in
            [(25.0, 15.0, 2.0, 2.0, 1.152_079), (25.0, 17.0, 1.0, 4.0, 0.747_925), (50.0, 30.0, 2.0, 3.0, 0.577_958)]
        {
            let part = Part::with(Torus { R, r }, e, a_p);
            let found = root(&part, Tool::flat(6.0));
            assert!((found.height - height).abs() < 5.1e-7, "{found:?}");
            // The largest that leaves as much is the same again.
            assert!((largest(&part, found.height, 20.0).unwrap() - 6.0).abs() < 1e-9);
            assert_eq!(largest(&part, found.height, 4.0), Some(4.0));
            assert_eq!(largest(&part, 1e-9, 4.0), None);
        }
    }

    #[test]
    fn the_usual_finishing_tool_keeps_the_usual_rest() {
        let found = root(&Part::with(Torus { R: 25.0, r: 15.0 }, 2.0, 2.0), Tool::flat(3.0));
        assert!(found.height <= 0.40 && found.width <= 0.35, "{found:?}");
    }
}
