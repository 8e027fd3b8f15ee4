//! The turning cycles of the Fagor 8055 T: as plain moves against positions derived by hand, and in programs.

use crate::common::rs274;
use crate::common::turned as lathe;

mod programs;
mod threads;

use lathe::{Metal, assert_moves, bare, points};
use proptest::prelude::*;
use rodete::finding::Exit;
use rodete::gcode::turning::MoveKind;
use rodete::gcode::turning::fagor::Along::{self, Cylinder, Face};
use rodete::gcode::turning::fagor::drill::{Drill, drill};
use rodete::gcode::turning::fagor::groove::{Groove, groove};
use rodete::gcode::turning::fagor::section::{Section, section};
use rodete::number::trig::{atan2, hypot};

/// The published torus: G85 X50 Z-15 Q20 R0 C1 I0 K15 from X55 Z0.
const TORUS: Section = Section {
    from: [25.0, -15.0],
    to: [10.0, 0.0],
    centre: Some([0.0, 15.0]),
    step: 1.0,
    back: None,
    stock: [0.0; 2],
    roughing: None,
    finishing: None,
};

/// A step to radius 10 from Z0 to Z−20, by passes of 4 from radius 20.
const STEP: Section = Section {
    from: [10.0, 0.0],
    to: [10.0, -20.0],
    centre: None,
    step: 4.0,
    back: Some(1.0),
    stock: [0.0; 2],
    roughing: None,
    finishing: None,
};

/// Where the torus ends at the depth k: 25 − √(15² − k²).
fn torus(k: f64) -> [f64; 2] {
    [25.0 - (225.0 - k * k).sqrt(), -k]
}

#[test]
fn g85_of_the_publication_leaves_a_quarter_torus() {
    // Fifteen facing passes at Z−1 to Z−15 from X55 to the circle, each followed along the circle up to the one before.
    let moves = section([27.5, 0.0], Face, &TORUS).unwrap();
    let mut expected = Vec::new();
    for k in (1..=15).map(f64::from) {
        let end = if k == 1.0 { [10.0, 0.0] } else { torus(k - 1.0) };
        expected.extend([('r', [27.5, -k]), ('f', torus(k)), ('a', end), ('r', [27.5, 1.0 - k])]);
    }
    expected.push(('r', [27.5, 0.0]));
    assert_moves(&moves, &expected);
    // The arcs are about (25, 0), G3: with Z to the right and X up they go from the deep pass inwards and to the face.
    let mut at = [27.5, 0.0];
    let mut turned = 0.0;
    for m in &moves {
        if let MoveKind::Arc { centre, clockwise, .. } = m.kind {
            assert_eq!((centre, clockwise), ([25.0, 0.0], false));
            let angle = |p: [f64; 2]| atan2(p[0] - 25.0, p[1]);
            turned += (angle(m.to) - angle(at)).rem_euclid(std::f64::consts::TAU);
        }
        at = m.to;
    }
    assert!((turned - std::f64::consts::FRAC_PI_2).abs() < 1e-9, "the arcs make the whole quarter: {turned}");
    // Nothing else touches the torus, and what is cut in one pass is at most 1 mm thick.
    let mut metal = Metal::new(10.0, 25.0, 0.0);
    let mut at = [27.5, 0.0];
    let swap = |p: [f64; 2]| [p[1], p[0]];
    for m in &moves {
        let way: Vec<[f64; 2]> = points(at, m).into_iter().map(swap).collect();
        if m.kind == MoveKind::Rapid {
            assert!(metal.hit(swap(at), swap(m.to)) < 1e-4, "{m:?}");
        } else {
            assert!(metal.cut(&way) < 1.0 + 1e-4, "{m:?}");
        }
        at = m.to;
    }
    for (index, z) in metal.height.iter().enumerate() {
        let x = 25.0 - metal.z(index);
        assert!((z + (225.0 - x * x).sqrt()).abs() < 1e-4, "{z} at X{}", metal.z(index));
    }
}

#[test]
fn g84_follows_the_arc_about_the_centre_from_the_initial_point() {
    // A ball end of radius 50 about X−22 Z−48.775: from X0 Z0 to X78 Z−48.775, I−11 K−48.775.
    let ball = Section {
        from: [0.0, 0.0],
        to: [39.0, -48.775],
        centre: Some([-11.0, -48.775]),
        step: 2.0,
        back: Some(1.0),
        ..TORUS
    };
    let moves = section([45.0, 20.0], Cylinder, &ball).unwrap();
    let ends: Vec<[f64; 2]> = moves.iter().filter(|m| matches!(m.kind, MoveKind::Feed(_))).map(|m| m.to).collect();
    // 45 mm in 23 steps; the first three lie above the final point and end over it.
    assert_eq!(ends.len(), 23);
    for (n, [x, z]) in (1..).zip(&ends) {
        assert!((x - (45.0 - 45.0 / 23.0 * f64::from(n))).abs() < 1e-9);
        if n <= 3 {
            assert!((z + 48.775).abs() < 1e-9);
        } else {
            assert!((hypot(x + 11.0, z + 48.775) - 50.0).abs() < 1e-4, "{x} {z}");
        }
    }
    assert_eq!(moves.last().map(|m| m.to), Some([45.0, 20.0]));
}

#[test]
fn g81_runs_as_drawn_with_each_way_out() {
    // Ten millimetres in three steps of 10/3: levels 50/3, 40/3, 10.
    let levels = [50.0 / 3.0, 40.0 / 3.0, 10.0];
    // D1: out at 45 degrees.
    let mut expected = Vec::new();
    for x in levels {
        expected.extend([('r', [x, 2.0]), ('f', [x, -20.0]), ('r', [x + 1.0, -19.0]), ('r', [x + 1.0, 2.0])]);
    }
    expected.push(('r', [20.0, 2.0]));
    assert_moves(&section([20.0, 2.0], Cylinder, &STEP).unwrap(), &expected);
    // D0: back the way it came.
    let mut expected = Vec::new();
    for x in levels {
        expected.extend([('r', [x, 2.0]), ('f', [x, -20.0]), ('r', [x, 2.0])]);
    }
    expected.push(('r', [20.0, 2.0]));
    assert_moves(&section([20.0, 2.0], Cylinder, &Section { back: Some(0.0), ..STEP }).unwrap(), &expected);
    // No D: up the face to the level of the pass before.
    let mut expected = Vec::new();
    let mut before = 20.0;
    for x in levels {
        expected.extend([('r', [x, 2.0]), ('f', [x, -20.0]), ('f', [before, -20.0]), ('r', [before, 2.0])]);
        before = x;
    }
    expected.push(('r', [20.0, 2.0]));
    assert_moves(&section([20.0, 2.0], Cylinder, &Section { back: None, ..STEP }).unwrap(), &expected);
}

#[test]
fn g82_with_stock_and_both_last_passes_runs_as_drawn() {
    // Facing a taper: from X40 Z−6 (deep, outside) to X20 Z0; start X50 Z2, C4, L1 M0.5, D absent, F and H given.
    // The moved profile goes from (21, −5.5) to (11, 0.5), 10 mm by 6. From Z2 to Z−5.5: 7.5 mm in two steps of 3.75.
    // Level −1.75: 2.25 under 0.5, so X = 11 + 2.25/0.6 = 14.75.
    let taper = Section {
        from: [20.0, -6.0],
        to: [10.0, 0.0],
        centre: None,
        step: 4.0,
        back: None,
        stock: [1.0, 0.5],
        roughing: Some(0.2),
        finishing: Some(0.1),
    };
    let moves = section([25.0, 2.0], Face, &taper).unwrap();
    assert_moves(
        &moves,
        &[
            ('r', [25.0, -1.75]),
            ('f', [14.75, -1.75]),
            ('f', [11.0, 0.5]),
            ('f', [11.0, 2.0]),
            ('r', [25.0, 2.0]),
            ('r', [25.0, -5.5]),
            ('f', [21.0, -5.5]),
            ('f', [14.75, -1.75]),
            ('r', [25.0, -1.75]),
            // The last roughing pass, at F.
            ('r', [25.0, 2.0]),
            ('r', [25.0, -5.5]),
            ('f', [21.0, -5.5]),
            ('f', [11.0, 0.5]),
            ('r', [11.0, 2.0]),
            ('r', [25.0, 2.0]),
            // The finishing pass, at H.
            ('r', [25.0, -6.0]),
            ('f', [20.0, -6.0]),
            ('f', [10.0, 0.0]),
            ('r', [10.0, 2.0]),
            ('r', [25.0, 2.0]),
        ],
    );
    let feeds: Vec<Option<f64>> =
        moves.iter().filter_map(|m| if let MoveKind::Feed(feed) = m.kind { Some(feed) } else { None }).collect();
    assert_eq!(feeds[..5], [None; 5]);
    assert_eq!(feeds[5..], [Some(0.2), Some(0.2), Some(0.1), Some(0.1)]);
    // H alone, or F0, leave their passes out.
    let finished = section([25.0, 2.0], Face, &Section { roughing: Some(0.0), ..taper }).unwrap();
    assert_eq!(finished.len(), 15);
}

#[test]
fn g83_drills_in_steps_as_drawn() {
    // I35.141 B9 D4 C1 without H: approach at Z4; 9, 18, 27, 35.141.
    let hole = Drill {
        at: [0.0, 0.0],
        depth: 35.141,
        step: 9.0,
        safety: 4.0,
        dwell: 0.5,
        back: None,
        near: None,
        least: 0.0,
        factor: 1.0,
    };
    let expected = [
        ('r', [0.0, 4.0]),
        ('f', [0.0, -9.0]),
        ('r', [0.0, 4.0]),
        ('r', [0.0, -8.0]),
        ('f', [0.0, -18.0]),
        ('r', [0.0, 4.0]),
        ('r', [0.0, -17.0]),
        ('f', [0.0, -27.0]),
        ('r', [0.0, 4.0]),
        ('r', [0.0, -26.0]),
        ('f', [0.0, -35.141]),
        ('d', [0.0, -35.141]),
        ('r', [0.0, 4.0]),
        ('r', [15.0, 50.0]),
    ];
    assert_moves(&drill([15.0, 50.0], &hole).unwrap(), &expected);
    // Back by H3 alone, then to 1 mm before the depth; steps shrink to a half but not under 2.
    let broken = Drill { depth: 10.0, step: 5.0, back: Some(3.0), dwell: 0.0, least: 2.0, factor: 0.5, ..hole };
    assert_moves(
        &drill([0.0, 4.0], &broken).unwrap(),
        &[
            ('f', [0.0, -5.0]),
            ('r', [0.0, -2.0]),
            ('r', [0.0, -4.0]),
            ('f', [0.0, -7.5]),
            ('r', [0.0, -4.5]),
            ('r', [0.0, -6.5]),
            ('f', [0.0, -9.5]),
            ('r', [0.0, -6.5]),
            ('r', [0.0, -8.5]),
            ('f', [0.0, -10.0]),
            ('r', [0.0, 4.0]),
        ],
    );
    // Tapping, and a hole in the other face.
    let tap = Drill { step: 0.0, depth: -12.0, dwell: 0.0, ..hole };
    assert_moves(
        &drill([0.0, -30.0], &tap).unwrap(),
        &[('r', [0.0, -4.0]), ('f', [0.0, 12.0]), ('f', [0.0, -4.0]), ('r', [0.0, -30.0])],
    );
    for wrong in [
        Drill { depth: 0.0, ..hole },
        Drill { step: -1.0, ..hole },
        Drill { safety: -1.0, ..hole },
        Drill { factor: 0.0, ..hole },
        Drill { factor: 1.5, ..hole },
        Drill { depth: f64::NAN, ..hole },
    ] {
        assert_eq!(drill([0.0, 50.0], &wrong).unwrap_err().exit, Exit::Refused);
    }
    // Steps that shrink to nothing never reach the bottom.
    assert_eq!(drill([0.0, 50.0], &Drill { factor: 0.5, ..hole }).unwrap_err().exit, Exit::Limit);
    assert_eq!(drill([0.0, 50.0], &Drill { step: 1e-6, ..hole }).unwrap_err().exit, Exit::Limit);
}

#[test]
fn g88_and_g89_groove_as_drawn() {
    // X20 Z−10 to Q10 R−14, C1.5: 4 mm in three steps of 4/3; D1; a dwell.
    let ring = Groove { from: [10.0, -10.0], to: [5.0, -14.0], step: 1.5, safety: 1.0, dwell: 0.2 };
    let mut expected = vec![('r', [15.0, -10.0])];
    for (n, z) in [-10.0, -10.0 - 4.0 / 3.0, -10.0 - 8.0 / 3.0, -14.0].into_iter().enumerate() {
        if n > 0 {
            expected.push(('r', [11.0, z]));
        }
        expected.extend([('r', [11.0, z]), ('f', [5.0, z]), ('d', [5.0, z]), ('r', [11.0, z])]);
        if n > 0 {
            // Already over the brim.
            let at = expected.len() - 4;
            expected.remove(at);
        }
    }
    expected.extend([('r', [15.0, -14.0]), ('r', [15.0, 5.0])]);
    assert_moves(&groove([15.0, 5.0], Cylinder, &ring).unwrap(), &expected);
    // The same with X and Z exchanged.
    let swap = |p: [f64; 2]| [p[1], p[0]];
    let faced = groove([5.0, 15.0], Face, &Groove { from: swap(ring.from), to: swap(ring.to), ..ring }).unwrap();
    let swapped: Vec<(char, [f64; 2])> = expected.iter().map(|(way, p)| (*way, swap(*p))).collect();
    assert_moves(&faced, &swapped);
    // One plunge where the groove is as wide as the cutter.
    let single = groove([15.0, -10.0], Cylinder, &Groove { to: [5.0, -10.0], dwell: 0.0, ..ring }).unwrap();
    assert_moves(&single, &[('r', [11.0, -10.0]), ('f', [5.0, -10.0]), ('r', [11.0, -10.0]), ('r', [15.0, -10.0])]);
    for wrong in [
        Groove { to: [10.0, -14.0], ..ring },
        Groove { step: 0.0, ..ring },
        Groove { safety: -1.0, ..ring },
        Groove { dwell: -1.0, ..ring },
        Groove { from: [16.0, -10.0], ..ring },
    ] {
        assert_eq!(groove([15.0, 5.0], Cylinder, &wrong).unwrap_err().exit, Exit::Refused);
    }
    assert_eq!(groove([15.0, 5.0], Cylinder, &Groove { step: 1e-5, ..ring }).unwrap_err().exit, Exit::Limit);
}

#[test]
fn sections_that_cannot_be_made_are_refused() {
    for (start, wrong) in [
        ([27.5, 0.0], Section { step: 0.0, ..TORUS }),
        ([27.5, 0.0], Section { step: -1.0, ..TORUS }),
        ([27.5, 0.0], Section { back: Some(-1.0), ..TORUS }),
        ([27.5, 0.0], Section { stock: [-0.1, 0.0], ..TORUS }),
        ([27.5, 0.0], Section { finishing: Some(-0.1), ..TORUS }),
        // I and K from another point: 5 mm at one end.
        ([27.5, 0.0], Section { centre: Some([0.0, 5.0]), ..TORUS }),
        // The centre in the middle between both ends.
        ([27.5, 0.0], Section { centre: Some([-7.5, 7.5]), ..TORUS }),
        // A start within the torus, and one too near for the stock to leave.
        ([20.0, 0.0], TORUS),
        ([27.5, -1.0], TORUS),
        ([27.5, 0.0], Section { stock: [3.0, 0.0], ..TORUS }),
        ([27.5, 0.0], Section { stock: [0.0, 0.5], ..TORUS }),
        // An arc over its crest: from (10, 0) to (10, −16) about (4, −8), out to 14.
        ([20.0, 2.0], Section { from: [10.0, 0.0], to: [10.0, -16.0], centre: Some([-6.0, -8.0]), ..TORUS }),
        ([27.5, f64::NAN], TORUS),
        ([27.5, 0.0], Section { step: f64::INFINITY, ..TORUS }),
    ] {
        let along = if start == [20.0, 2.0] { Cylinder } else { Face };
        assert_eq!(section(start, along, &wrong).unwrap_err().exit, Exit::Refused, "{wrong:?}");
    }
    assert_eq!(section([27.5, 0.0], Face, &Section { step: 1e-6, ..TORUS }).unwrap_err().exit, Exit::Limit);
}

/// A section with its start, outside and towards the chuck: straight, or a quarter circle.
fn sections() -> impl Strategy<Value = ([f64; 2], Section)> {
    let numbers = (1_u8..30, 0_u8..20, 1_u8..20, 1_u8..30, 0_u8..3, 0_u8..10, 0_u8..4);
    numbers.prop_map(|(x, dx, dz, step, kind, clear, stock)| {
        let [x, dx, dz, clear, stock] = [x, dx, dz, clear, stock].map(|n| f64::from(n) / 2.0);
        let (to, centre) = match kind {
            0 => ([x + dx, -dz], None),
            1 => ([x + dz, -dz], Some([dz, 0.0])),
            _ => ([x + dz, -dz], Some([0.0, -dz])),
        };
        let back = (clear > 1.0).then_some(clear - 1.5);
        let parameters = Section {
            from: [x, 0.0],
            to,
            centre,
            step: f64::from(step) / 10.0,
            back,
            stock: [stock / 10.0, stock / 20.0],
            roughing: None,
            finishing: (stock > 0.5).then_some(0.1),
        };
        ([to[0] + stock / 10.0 + clear, stock / 20.0 + clear / 2.0], parameters)
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn a_section_is_cut_no_deeper_than_its_profile_and_ends_where_it_began((start, parameters) in sections()) {
        let moves = section(start, Cylinder, &parameters).unwrap();
        let mut metal = Metal::new(parameters.to[1], 0.0, start[0]);
        let finish = parameters.finishing.unwrap_or(0.0) > 0.0;
        let mut at = start;
        for m in &moves {
            if m.kind == MoveKind::Rapid {
                prop_assert!(metal.hit(at, m.to) < 1e-4, "rapid through metal to {:?}", m);
            } else {
                let last = matches!(m.kind, MoveKind::Feed(Some(_)) | MoveKind::Arc { feed: Some(_), .. });
                let deepest = metal.cut(&points(at, m));
                // Without following the profile the corners between the passes are left to the finishing pass.
                prop_assert!(last || deepest < parameters.step + 1e-3, "{} deep in {:?}", deepest, m);
            }
            at = m.to;
        }
        prop_assert_eq!(at, start);
        // The profile, from the section itself.
        let profile = |z: f64| {
            let ([x, _], [q, r]) = (parameters.from, parameters.to);
            match parameters.centre {
                None => x + (q - x) * z / r,
                Some([i, k]) => {
                    let half = (i * i + k * k - (z - k) * (z - k)).sqrt();
                    if i > 0.0 { x + i - half } else { x + half }
                }
            }
        };
        for (index, left) in metal.height.iter().enumerate() {
            let z = metal.z(index);
            let over = left - profile(z);
            prop_assert!(over > -1e-3, "cut into the profile by {} at Z{}", -over, z);
            if finish || (parameters.back.is_none() && parameters.stock == [0.0; 2]) {
                prop_assert!(over < 1e-3, "{} left at Z{}", over, z);
            }
        }
    }

    #[test]
    fn mirrored_sections_give_mirrored_moves((start, parameters) in sections()) {
        let plain = section(start, Cylinder, &parameters).unwrap();
        let check = |along: Along, place: &dyn Fn([f64; 2]) -> [f64; 2], turn: &dyn Fn([f64; 2]) -> [f64; 2], stock: [f64; 2]| {
            let mirrored = Section {
                from: place(parameters.from),
                to: place(parameters.to),
                centre: parameters.centre.map(turn),
                stock,
                ..parameters
            };
            let moves = section(place(start), along, &mirrored).unwrap();
            prop_assert_eq!(moves.len(), plain.len());
            for (a, b) in plain.iter().zip(&moves) {
                let to = place(a.to);
                prop_assert!((to[0] - b.to[0]).abs() < 1e-6 && (to[1] - b.to[1]).abs() < 1e-6, "{:?} {:?}", a, b);
                let turns = |kind: MoveKind| if let MoveKind::Arc { clockwise, .. } = kind { Some(clockwise) } else { None };
                prop_assert_eq!(turns(a.kind).map(|clockwise| !clockwise), turns(b.kind));
            }
            Ok(())
        };
        let [L, M] = parameters.stock;
        check(Cylinder, &|[x, z]| [100.0 - x, z], &|[x, z]| [-x, z], [L, M])?;
        check(Cylinder, &|[x, z]| [x, 10.0 - z], &|[x, z]| [x, -z], [L, M])?;
        check(Face, &|[x, z]| [z, x], &|[x, z]| [z, x], [M, L])?;
    }
}
