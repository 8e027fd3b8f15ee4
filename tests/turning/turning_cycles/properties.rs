//! What every contour must keep.

use proptest::prelude::*;
use rodete::gcode::turning::profile::{Element, Profile};
use rodete::gcode::turning::rough::{Rough, axial, radial};
use rodete::gcode::turning::{Move, MoveKind};

use super::lathe::{Metal, arc, count, line, points, profile, rapid};

/// A contour of type I on a grid of half a millimetre: steps out and towards the chuck, straight or as quarter circles.
fn falling() -> impl Strategy<Value = Profile> {
    let step = (0_u8..4, 0_u8..8, 0_u8..8);
    (prop::collection::vec(step, 1..9), 1_u8..10).prop_map(|(steps, first)| {
        let [mut x, mut z] = [f64::from(first), 0.0];
        let mut elements = vec![rapid([x, z])];
        for (kind, dx, dz) in steps {
            let [dx, dz] = [f64::from(dx) / 2.0, f64::from(dz) / 2.0];
            let from = [x, z];
            match kind {
                // Convex (G3 about the corner on the side of the part) and concave quarter circles.
                0 | 1 if dx > 0.0 => {
                    (x, z) = (x + dx, z - dx);
                    let centre = if kind == 0 { [from[0], z] } else { [x, from[1]] };
                    elements.push(arc([x, z], centre, kind == 1));
                }
                _ => {
                    (x, z) = (x + dx, z - dz);
                    elements.push(line([x, z]));
                }
            }
        }
        elements.push(line([x, z - 1.0]));
        elements.push(line([x + 1.0, z - 1.0]));
        profile([x + 1.0, 0.0], elements)
    })
}

/// A contour of type II: Z falls, X goes anywhere below the start.
fn pockets() -> impl Strategy<Value = Profile> {
    prop::collection::vec((2_u8..40, 0_u8..6), 2..12).prop_map(|corners| {
        let mut z = -1.0;
        let mut elements = Vec::new();
        for (x, dz) in corners {
            z -= f64::from(dz) / 2.0;
            let to = [f64::from(x) / 2.0, z];
            elements.push(if elements.is_empty() { rapid(to) } else { line(to) });
        }
        elements.push(line([20.0, z - 1.0]));
        profile([20.0, 1.0], elements)
    })
}

fn parameters() -> impl Strategy<Value = Rough> {
    (5_u8..40, 0_u8..10, 0_u8..5, 0_u8..5, any::<bool>()).prop_map(|(depth, retract, U, W, feed)| Rough {
        depth: f64::from(depth) / 10.0,
        retract: f64::from(retract) / 10.0,
        U: f64::from(U) / 10.0,
        W: f64::from(W) / 10.0,
        feed: feed.then_some(0.2),
        both_axes: None,
    })
}

/// The greatest X that the contour has over a Z, walls left out: nothing of the scan in it.
fn heights(contour: &Profile, by: [f64; 2], metal: &Metal) -> Vec<f64> {
    let mut heights = vec![f64::NEG_INFINITY; metal.height.len()];
    let mut at = contour.elements[0].to;
    for element in &contour.elements[1..] {
        let kind = match element.arc {
            None => MoveKind::Feed(None),
            Some((centre, clockwise)) => MoveKind::Arc { centre, clockwise, feed: None },
        };
        let points = points(at, &Move { kind, to: element.to, line: None });
        for pair in points.windows(2) {
            let [a, b] = [pair[0], pair[1]].map(|p| [p[0] + by[0], p[1] + by[1]]);
            for (index, height) in heights.iter_mut().enumerate() {
                let z = metal.z(index);
                if z < a[1] && z > b[1] {
                    *height = height.max(a[0] + (b[0] - a[0]) * (z - a[1]) / (b[1] - a[1]));
                }
            }
        }
        at = element.to;
    }
    heights
}

/// Turns the contour out of metal that reaches up to the start, and holds every move against metal and contour.
fn turned(contour: &Profile, rough: &Rough) -> Result<(), TestCaseError> {
    let moves = axial(contour, rough).unwrap();
    let by = [rough.U, rough.W];
    let end = contour.elements.last().unwrap().to;
    let high = contour.start[0];
    let mut metal = Metal::new(end[1] + by[1], contour.elements[0].to[1], high);
    let floor = heights(contour, by, &metal);
    let mut at = contour.start;
    for m in &moves {
        let way = points(at, m);
        if m.kind == MoveKind::Rapid {
            prop_assert!(metal.hit(at, m.to) < 1e-6, "rapid through metal from {at:?} to {m:?}");
        } else {
            let deepest = metal.cut(&way);
            prop_assert!(deepest < rough.depth + 1e-3, "{deepest} deep in {m:?}");
        }
        at = m.to;
    }
    for (index, (left, floor)) in metal.height.iter().zip(&floor).enumerate() {
        let floor = floor.min(high);
        prop_assert!((left - floor).abs() < 1e-3, "at Z{} the metal ends at {left}, not {floor}", metal.z(index));
    }
    prop_assert_eq!(at, contour.start, "back at the start");
    Ok(())
}

fn mirrored(contour: &Profile, place: impl Fn([f64; 2]) -> [f64; 2], flips: bool) -> Profile {
    let element = |element: &Element| Element {
        to: place(element.to),
        arc: element.arc.map(|(centre, clockwise)| (place(centre), clockwise ^ flips)),
        ..*element
    };
    Profile { start: place(contour.start), elements: contour.elements.iter().map(element).collect() }
}

fn same_moves(
    plain: &[Move],
    other: &[Move],
    place: impl Fn([f64; 2]) -> [f64; 2],
    flips: bool,
) -> Result<(), TestCaseError> {
    // Where a circle touches a level, rounding moves the end of a pass, and a way of nothing may stand in one of them.
    let long = |moves: &[Move]| {
        let mut at = [f64::NAN; 2];
        let mut moves = moves.to_vec();
        moves.retain(|m| {
            let near = (m.to[0] - at[0]).abs() < 1e-5 && (m.to[1] - at[1]).abs() < 1e-5;
            at = m.to;
            !near
        });
        moves
    };
    let (plain, other) = (long(plain), long(other));
    prop_assert_eq!(plain.len(), other.len());
    for (a, b) in plain.iter().zip(&other) {
        let close = |p: [f64; 2], q: [f64; 2]| (p[0] - q[0]).abs() < 1e-5 && (p[1] - q[1]).abs() < 1e-5;
        prop_assert!(close(place(a.to), b.to), "{:?} {:?}", a, b);
        match (a.kind, b.kind) {
            (MoveKind::Arc { centre, clockwise, feed }, MoveKind::Arc { centre: c, clockwise: d, feed: f }) => {
                prop_assert!(close(place(centre), c));
                prop_assert_eq!((clockwise ^ flips, feed), (d, f));
            }
            (a, b) => prop_assert_eq!(a, b),
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn type_i_leaves_the_contour_moved_by_the_allowance_and_no_pass_is_too_deep(contour in falling(), rough in parameters()) {
        turned(&contour, &rough)?;
    }

    #[test]
    fn type_ii_clears_every_pocket_and_moves_at_rapid_over_cut_ground_alone(contour in pockets(), rough in parameters()) {
        turned(&contour, &Rough { both_axes: Some(true), W: 0.0, ..rough })?;
    }

    #[test]
    fn type_i_makes_the_passes_that_its_depth_takes(contour in falling(), rough in parameters()) {
        let moves = axial(&contour, &rough).unwrap();
        // The moves parallel to Z that follow no block of the contour.
        let mut at = contour.start;
        let mut passes = 0;
        for m in &moves {
            passes += usize::from(matches!(m.kind, MoveKind::Feed(_)) && m.line.is_none() && m.to[0] == at[0]);
            at = m.to;
        }
        // One for each level at which the contour leaves a way of 0.001 mm, the last level as deep as the contour.
        let total = contour.start[0] - contour.elements[0].to[0];
        let levels = count((total / rough.depth - 1e-9).ceil());
        let level = |n: usize| if n == levels { contour.elements[0].to[0] } else { contour.start[0] - rough.depth * n as f64 };
        let mut corner = contour.elements[0].to;
        let mut lowest = vec![0.0_f64; levels];
        for element in &contour.elements[1..] {
            let kind = element.arc.map_or(MoveKind::Feed(None), |(centre, clockwise)| MoveKind::Arc { centre, clockwise, feed: None });
            for pair in points(corner, &Move { kind, to: element.to, line: None }).windows(2) {
                let [a, b] = [pair[0], pair[1]];
                for (n, lowest) in (1..).zip(&mut lowest) {
                    let level = level(n) + 1e-9;
                    if b[0] <= level {
                        *lowest = lowest.min(b[1]);
                    } else if a[0] <= level {
                        *lowest = lowest.min(a[1] + (b[1] - a[1]) * (level - a[0]) / (b[0] - a[0]));
                    }
                }
            }
            corner = element.to;
        }
        let expected = lowest.iter().filter(|&&z| z < -0.001).count();
        prop_assert_eq!(passes, expected);
    }

    #[test]
    fn mirrored_contours_give_mirrored_moves(contour in falling(), rough in parameters()) {
        let plain = axial(&contour, &rough).unwrap();
        let inside = |[x, z]: [f64; 2]| [100.0 - x, z];
        let away = |[x, z]: [f64; 2]| [x, 10.0 - z];
        let both = |[x, z]: [f64; 2]| [100.0 - x, 10.0 - z];
        let swap = |[x, z]: [f64; 2]| [z, x];
        same_moves(&plain, &axial(&mirrored(&contour, inside, true), &Rough { U: -rough.U, ..rough }).unwrap(), inside, true)?;
        same_moves(&plain, &axial(&mirrored(&contour, away, true), &Rough { W: -rough.W, ..rough }).unwrap(), away, true)?;
        same_moves(
            &plain,
            &axial(&mirrored(&contour, both, false), &Rough { U: -rough.U, W: -rough.W, ..rough }).unwrap(),
            both,
            false,
        )?;
        same_moves(
            &plain,
            &radial(&mirrored(&contour, swap, true), &Rough { U: rough.W, W: rough.U, ..rough }).unwrap(),
            swap,
            true,
        )?;
    }

    #[test]
    fn whatever_the_contour_there_is_an_answer_and_it_ends_at_the_start(
        start in prop::array::uniform2(-50.0..50.0_f64),
        corners in prop::collection::vec((prop::array::uniform2(-50.0..50.0_f64), prop::option::of((prop::array::uniform2(-50.0..50.0_f64), any::<bool>()))), 0..8),
        depth in -1.0..20.0_f64, U in -1.0..1.0_f64, W in -1.0..1.0_f64, both in prop::option::of(any::<bool>()),
    ) {
        let contour = profile(start, corners.into_iter().map(|(to, round)| Element { arc: round, ..line(to) }));
        let rough = Rough { depth, retract: 0.5, U, W, feed: None, both_axes: both };
        for moves in [axial(&contour, &rough), radial(&contour, &rough)].into_iter().flatten() {
            let end = moves.last().map_or(start, |m| m.to);
            prop_assert!((end[0] - start[0]).abs() < 1e-9 && (end[1] - start[1]).abs() < 1e-9);
        }
    }
}
