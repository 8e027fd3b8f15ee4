//! What holds for any contour that fits.

use std::f64::consts::{FRAC_PI_2, PI};

use proptest::prelude::*;
use rodete::gcode::in_force::Compensation::{Left, Right};
use rodete::gcode::turning::nose::{Element, Nose, Path, Point, STRAIGHT, Tip};
use rodete::number::trig::sin_cos;

use super::contour::{arc, at, carrier, clearance, cuts, distance, line, run};

/// Pieces whose directions stay within 75 degrees of −Z, so that no piece comes near another but its neighbours. Each is
/// (turn at its start as a share, length, bend as a share; straight where that is small).
pub fn contour(shares: &[(f64, f64, f64)], widest: f64) -> Vec<Element> {
    let mut heading = PI;
    let mut from = [0.0, 0.0];
    let mut out = Vec::new();
    let limit = |angle: f64| angle.clamp(PI - widest, PI + widest);
    for &(turn, length, bend) in shares {
        let start = limit(heading + 2.0 * widest * turn);
        let end = if bend.abs() < 0.4 { start } else { limit(start + bend * widest) };
        let sweep = end - start;
        let chord = if sweep.abs() < 0.1 { start } else { f64::midpoint(start, end) };
        let (sin, cos) = sin_cos(chord);
        let to = [from[0] + length * cos, from[1] + length * sin];
        if sweep.abs() < 0.1 {
            out.push(line(from, to));
            heading = start;
        } else {
            let radius = length / (2.0 * sin_cos(sweep.abs() / 2.0).0);
            let side = sin_cos(start + FRAC_PI_2.copysign(sweep));
            out.push(arc(from, to, [from[0] + radius * side.1, from[1] + radius * side.0], sweep));
            heading = end;
        }
        from = to;
    }
    out
}

pub fn shares() -> impl Strategy<Value = Vec<(f64, f64, f64)>> {
    prop::collection::vec((-1.0..1.0, 4.0..12.0, -1.0..1.0), 2..9)
}

fn mirrored(element: &Element) -> Element {
    let flip = |[z, x]: Point| [z, -x];
    let path = match element.path {
        Path::Arc { centre, sweep } => Path::Arc { centre: flip(centre), sweep: -sweep },
        path => path,
    };
    Element { from: flip(element.from), to: flip(element.to), path }
}

fn entered(mut elements: Vec<Element>) -> Vec<Element> {
    elements.insert(0, line([5.0, 0.0], elements[0].from));
    elements
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// The nose touches what it follows, and cuts into nothing.
    #[test]
    fn the_nose_stays_tangent_to_the_contour(shares in shares(), R in 0.05..0.8, tip in 0_u8..10, left: bool, straight in prop::sample::select(vec![0.0, 2.0, STRAIGHT])) {
        let elements = entered(contour(&shares, 1.3));
        let side = if left { Left } else { Right };
        let nose = Nose { radius: R, tip: Tip::new(tip).unwrap() };
        let Ok(placed) = run(&elements, side, nose, straight, None) else { return Err(TestCaseError::reject("does not fit")) };
        prop_assert!(cuts(&elements, side, nose, straight).is_empty());
        let back = nose.to_tip();
        let mut last = None;
        for (element, tag) in &placed {
            let centre = element.shifted([-back[0], -back[1]]);
            let first = last.replace(*tag) != Some(*tag);
            if *tag == 0 {
                continue;
            }
            for part in 0..=8 {
                let point = at(&centre, f64::from(part) / 8.0);
                if first {
                    let off = carrier(point, &elements[*tag]) - R;
                    prop_assert!(off.abs() < 1e-9, "piece {tag} is {off} off");
                }
                for other in &elements[1..] {
                    let clear = clearance(point, other) - R;
                    prop_assert!(clear > -1e-9, "piece {tag} gouges by {clear}");
                }
            }
        }
    }

    /// Each piece begins where the one before ends, and arcs end where they say.
    #[test]
    fn the_path_has_no_gaps(shares in shares(), R in 0.05..0.8, tip in 0_u8..10, straight in prop::sample::select(vec![0.0, 2.0, STRAIGHT])) {
        let elements = entered(contour(&shares, 1.3));
        let nose = Nose { radius: R, tip: Tip::new(tip).unwrap() };
        let Ok(placed) = run(&elements, Right, nose, straight, Some([9.0, 9.0])) else { return Err(TestCaseError::reject("does not fit")) };
        for pair in placed.windows(2) {
            prop_assert!(distance(pair[0].0.to, pair[1].0.from) < 1e-12);
        }
        for (element, _) in &placed {
            prop_assert!(distance(at(element, 1.0), element.to) < 1e-9, "{element:?}");
        }
        prop_assert_eq!(placed.last().unwrap().0.to, [9.0, 9.0]);
    }

    /// Left is the mirror image of right.
    #[test]
    fn left_is_right_in_the_mirror(shares in shares(), R in 0.05..0.8, tip in 0_u8..10, straight in prop::sample::select(vec![0.0, 2.0, STRAIGHT])) {
        let elements = entered(contour(&shares, 1.3));
        let image: Vec<Element> = elements.iter().map(mirrored).collect();
        let other = [0, 4, 3, 2, 1, 5, 8, 7, 6, 9][usize::from(tip)];
        let one = run(&elements, Left, Nose { radius: R, tip: Tip::new(tip).unwrap() }, straight, None);
        let two = run(&image, Right, Nose { radius: R, tip: Tip::new(other).unwrap() }, straight, None);
        let (Ok(one), Ok(two)) = (&one, &two) else {
            prop_assert_eq!(one.is_err(), two.is_err());
            return Ok(());
        };
        prop_assert_eq!(one.len(), two.len());
        for ((element, tag), (image, other)) in one.iter().zip(two) {
            let back = mirrored(image);
            prop_assert_eq!(tag, other);
            prop_assert!(distance(element.from, back.from) < 1e-12 && distance(element.to, back.to) < 1e-12);
            if let (Path::Arc { centre, sweep }, Path::Arc { centre: image, sweep: swept }) = (element.path, back.path) {
                prop_assert!(distance(centre, image) < 1e-12 && (sweep - swept).abs() < 1e-12);
            }
        }
    }

    /// A nose of radius 0 follows the program.
    #[test]
    fn a_sharp_tool_follows_the_program(shares in shares(), tip in 0_u8..10, left: bool) {
        let elements = entered(contour(&shares, 1.3));
        let nose = Nose { radius: 0.0, tip: Tip::new(tip).unwrap() };
        let placed = run(&elements, if left { Left } else { Right }, nose, STRAIGHT, Some([9.0, 9.0])).unwrap();
        prop_assert_eq!(placed.len(), elements.len() + 1);
        for ((element, _), programmed) in placed.iter().zip(&elements) {
            prop_assert!(distance(element.from, programmed.from) < 1e-12 && distance(element.to, programmed.to) < 1e-12);
            prop_assert!((element.length() - programmed.length()).abs() < 1e-12);
        }
    }

    /// The misfit of an inner arc is found wherever it stands, and its numbers are those of the arc.
    #[test]
    fn an_inner_arc_smaller_than_the_nose_is_always_refused(shares in shares(), small in 0.1..0.7, more in 0.01..2.0) {
        let mut elements = entered(contour(&shares, 0.5));
        let last = *elements.last().unwrap();
        // From the end of the contour, bending right by a quarter from its own direction.
        let heading = match last.path {
            Path::Arc { centre, sweep } => {
                rodete::number::trig::atan2(last.to[1] - centre[1], last.to[0] - centre[0]) + FRAC_PI_2.copysign(sweep)
            }
            _ => rodete::number::trig::atan2(last.to[1] - last.from[1], last.to[0] - last.from[0]),
        };
        let turn = |angle: f64| { let (sin, cos) = sin_cos(heading + angle); [cos, sin] };
        let [forward, right] = [turn(0.0), turn(-FRAC_PI_2)];
        let centre = [0, 1].map(|axis| last.to[axis] + small * right[axis]);
        let to = [0, 1].map(|axis| centre[axis] + small * forward[axis]);
        elements.push(arc(last.to, to, centre, -FRAC_PI_2));
        let refused = run(&elements, Right, Nose { radius: small + more, tip: Tip::new(3).unwrap() }, STRAIGHT, None);
        prop_assert!(refused.is_err());
    }
}
