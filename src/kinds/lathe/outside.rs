//! A contour of the program that lies outside the bar: no tool leaves there what the bar does not have.
//!
//! # Units
//! Millimetres; `[z, r]` from W1.

use crate::finding::{Bare, Finding, Limit, Raise, Said, Size};
use crate::gcode::interpreter::{Interpreter, TurnedContour};
use crate::kinds::lathe::findings::at_line;
use crate::kinds::lathe::rules::ContourOutsideBar;
use crate::kinds::lathe::setup::Given;
use crate::number::shown;
use crate::removal::turning::alarm::TOUCH;
use crate::removal::turning::simulation::Simulation;
use crate::text::Language;

/// The least length along Z, mm: less is an edge that is broken beside the bar.
const LEAST: f64 = 0.1;

/// The greatest length along Z, mm, of what leads out of the bar or into it at an angle, as a chamfer or a rounding that ends beside it: more
/// is a part of the shape. Our choice.
const LEADS: f64 = 5.0;

/// What of a contour is outside the bar.
struct Outside {
    /// Along Z, mm; what of a leg whose other end is within it does not count.
    length: f64,
    /// The greatest radius of it, mm, and the line of its block.
    greatest: (f64, usize),
}

/// The cautions of contours that a cycle names and that lie outside the bar, where they pass the part that the program begins with,
/// from one of these Z to the other. What only leads from outside into the bar, and from it out again, is no part of the shape: it
/// does not count.
pub(super) fn contours(
    interpreter: &Interpreter<'_>,
    simulation: &Simulation,
    given: &Given,
    along: [f64; 2],
) -> Vec<Finding> {
    let setup = simulation.setup();
    let D = setup.stock.diameter;
    let mounted = |contour: &&TurnedContour| setup.turret.tools.contains_key(&contour.tool);
    let told = |contour: &TurnedContour| {
        let point = |machine| simulation.point(contour.tool, machine);
        let legs = contour.legs.iter().map(|(line, ends)| (*line, [point(&ends[0]), point(&ends[1])]));
        let Outside { length, greatest: (radius, line) } = outside(legs, D / 2.0, along);
        if length < LEAST {
            return None;
        }
        let [first, last] = contour.ends;
        let X = Bare::mm(2.0 * radius, 3);
        let (bar, cell) = (Size::mm(D), given.bar_cell());
        let told = ContourOutsideBar { first, last, X, bar, cell };
        let told = told.at(at_line(interpreter.file(contour.file), line));
        let told = told.with(Size::mm(2.0 * radius).said(Language::En), format!("≤ {} mm", shown(D, 3)));
        Some(told.measuring(2.0 * radius, Limit::AtMost(D)))
    };
    interpreter.contours().iter().filter(mounted).filter_map(told).collect()
}

/// What of a contour is farther out than a radius, between two Z: the legs both of whose ends are, and what of one that crosses it is longer
/// than what leads out of the bar. One that goes along the axis before the contour has come to the bar leads to it, unless the contour has
/// come towards the axis before.
fn outside(legs: impl Iterator<Item = (usize, [[f64; 2]; 2])>, radius: f64, [left, right]: [f64; 2]) -> Outside {
    let mut found = Outside { length: 0.0, greatest: (0.0, 0) };
    let mut leads = true;
    for (line, [from, to]) in legs {
        let [r, R] = [from, to].map(|end| end[1].abs());
        let over = |one: f64, two: f64| (one.max(two).min(right) - one.min(two).max(left)).max(0.0);
        let mut along = over(from[0], to[0]);
        if r.min(R) <= radius + TOUCH {
            leads = false;
            if r.max(R) <= radius + TOUCH {
                continue;
            }
            let crosses = from[0] + (to[0] - from[0]) * (radius - r) / (R - r);
            along = over(crosses, if R > r { to[0] } else { from[0] });
            if along <= LEADS {
                continue;
            }
        }
        if along < TOUCH || (leads && (R - r).abs() < TOUCH) {
            leads &= R > r - TOUCH;
            continue;
        }
        leads = false;
        found.length += along;
        if r.max(R) > found.greatest.0 {
            found.greatest = (r.max(R), line);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::{Outside, outside};

    /// Length and greatest diameter of what is outside a bar of D 30 from Z-100 to Z1; points are diameters and Z.
    fn of(points: &[[f64; 2]]) -> [f64; 2] {
        let legs = points.windows(2).zip(1..).map(|(pair, line)| (line, [pair[0], pair[1]].map(|[X, Z]| [Z, X / 2.0])));
        let Outside { length, greatest } = outside(legs, 15.0, [-100.0, 1.0]);
        [length, 2.0 * greatest.0]
    }

    #[test]
    fn a_shoulder_outside_the_bar_counts_and_what_leads_in_and_out_does_not() {
        for (points, expected) in [
            (
                &[[20.0, 2.0], [20.0, -30.0], [30.0, -45.0], [38.0, -49.0], [44.0, -49.0], [48.0, -51.0]][..],
                [2.0, 48.0],
            ),
            (&[[20.0, 2.0], [20.0, -30.0], [40.0, -30.0], [40.0, -50.0]], [20.0, 40.0]),
            // The chamfer leads out of the bar, and the tool goes away along X.
            (&[[20.0, 2.0], [20.0, -30.0], [28.0, -30.0], [34.0, -33.0], [50.0, -33.0]], [0.0, 0.0]),
            (&[[20.0, 2.0], [20.0, -30.0], [30.0, -30.0], [30.0, -60.0], [32.0, -60.0]], [0.0, 0.0]),
            // To the right of the bar, and along it before the first cut.
            (&[[40.0, 5.0], [40.0, 2.0], [20.0, 2.0], [20.0, -9.0]], [0.0, 0.0]),
            (&[[40.0, 5.0], [40.0, -20.0], [20.0, -20.0], [20.0, -30.0]], [0.0, 0.0]),
            // A cone leaves the bar for good in one leg, or comes into it.
            (&[[20.0, 2.0], [20.0, -10.0], [60.0, -50.0], [64.0, -50.0]], [30.0, 60.0]),
            (&[[64.0, -50.0], [60.0, -50.0], [20.0, -10.0], [20.0, 2.0]], [30.0, 60.0]),
            // Facing from outside: a shoulder along the axis, behind a leg towards it.
            (&[[84.0, -40.0], [60.0, -40.0], [60.0, -20.0], [20.0, -20.0], [20.0, 2.0]], [20.0, 60.0]),
            // Facing, from the shoulder outside to the middle.
            (&[[52.0, -30.0], [48.0, -30.0], [44.0, -28.0], [20.0, -28.0], [20.0, 2.0]], [2.0, 48.0]),
        ] {
            assert_eq!(of(points), expected, "{points:?}");
        }
    }
}
