//! G86 and G87.

use rodete::finding::Exit;
use rodete::gcode::motion::Thread;
use rodete::gcode::turning::fagor::Along::{Cylinder, Face};
use rodete::gcode::turning::fagor::thread::{Threading, thread};
use rodete::gcode::turning::{Move, MoveKind};

use super::assert_moves;

/// M40 × 2, 30 mm long, 1.2 deep, in cuts of 0.4·√n.
const M40: Threading = Threading {
    from: [20.0, 0.0],
    to: [20.0, -30.0],
    depth: 1.2,
    step: 0.4,
    least: 0.0,
    safety: 2.0,
    finishing: 0.0,
    lead: 2.0,
    exit: 0.0,
    angle: 30.0,
};

fn depths(threading: Threading) -> Vec<f64> {
    threading.depths().unwrap()
}

fn assert_close(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len(), "{found:?}");
    assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
}

#[test]
fn the_passes_grow_by_the_root_or_by_a_constant() {
    // 0.4·√n to 0.8 in four passes, and the last depth once more.
    let root = |n: f64| 0.4 * n.sqrt();
    assert_close(&depths(Threading { depth: -0.8, ..M40 }), &[0.4, root(2.0), root(3.0), 0.8, 0.8]);
    // Constant: 0.3 to 1.5, less the last pass of 0.1.
    let constant = Threading { depth: 1.5, step: -0.3, finishing: 0.1, ..M40 };
    assert_close(&depths(constant), &[0.3, 0.6, 0.9, 1.2, 1.4, 1.5]);
    // At least 0.25 more each time.
    assert_close(&depths(Threading { least: 0.25, ..M40 }), &[0.4, 0.65, 0.9, 1.15, 1.2, 1.2]);
}

#[test]
fn a_thread_runs_as_drawn() {
    // Two cuts of 0.6 with the angle 30: the begin moves on by 0.6·tan 30° = 0.6/√3. The last depth once more.
    let t = 1.0 / 3.0_f64.sqrt();
    let two = Threading { step: -0.6, ..M40 };
    let moves = thread([25.0, 10.0], Cylinder, &two).unwrap();
    let pass =
        |p: f64| [('r', [22.0, -p * t]), ('r', [20.0 - p, -p * t]), ('t', [20.0 - p, -30.0]), ('r', [22.0, -30.0])];
    let mut expected: Vec<(char, [f64; 2])> = [pass(0.6), pass(1.2), pass(1.2)].concat();
    expected.extend([('r', [22.0, 0.0]), ('r', [25.0, 10.0])]);
    assert_moves(&moves, &expected);
    assert_eq!(moves[2].kind, MoveKind::Thread(Thread { lead: 2.0, change: 0.0, angle: 0.0 }));
    // With J5 it leaves the thread over the last 5 mm.
    let moves = thread([25.0, 10.0], Cylinder, &Threading { exit: 5.0, ..two }).unwrap();
    assert_moves(&moves[2..4], &[('t', [19.4, -25.0]), ('t', [22.0, -30.0])]);
    // Inside, radially: I−1.2, A0.
    let moves = thread([15.0, 10.0], Cylinder, &Threading { depth: -1.2, angle: 0.0, ..two }).unwrap();
    assert_moves(&moves[..3], &[('r', [18.0, 0.0]), ('r', [20.6, 0.0]), ('t', [20.6, -30.0])]);
    // The flanks in turn: the second pass begins at (2·1.2 − 1.2)·tan 30°, the third at 1.2·tan 30° as well.
    let moves = thread([25.0, 10.0], Cylinder, &Threading { angle: -30.0, step: -0.4, ..two }).unwrap();
    let begins: Vec<f64> = starts(&moves, [25.0, 10.0]).iter().map(|p| p[1]).collect();
    assert_close(&begins, &[-0.4 * t, -1.6 * t, -1.2 * t, -1.2 * t]);
}

fn starts(moves: &[Move], start: [f64; 2]) -> Vec<[f64; 2]> {
    let mut at = start;
    let mut starts = Vec::new();
    for m in moves {
        if matches!(m.kind, MoveKind::Thread(_)) {
            starts.push(at);
        }
        at = m.to;
    }
    starts
}

#[test]
fn a_cone_keeps_its_depth_and_its_lead_is_along_the_cone_or_the_axis() {
    // 3 mm in radius over 4 in Z is 5 along the cone: C2.5 along it is 2 along Z; C−2 is 2 along Z itself.
    let cone = Threading { to: [23.0, -4.0], step: -1.2, depth: 0.3, angle: 0.0, ..M40 };
    let moves = thread([30.0, 5.0], Cylinder, &Threading { lead: 2.5, ..cone }).unwrap();
    assert_moves(&moves[..4], &[('r', [22.0, 0.0]), ('r', [19.7, 0.0]), ('t', [22.7, -4.0]), ('r', [25.0, -4.0])]);
    let lead =
        |moves: &[Move]| moves.iter().find_map(|m| if let MoveKind::Thread(t) = m.kind { Some(t.lead) } else { None });
    assert!((lead(&moves).unwrap() - 2.0).abs() < 1e-12);
    let moves = thread([30.0, 5.0], Cylinder, &Threading { lead: -2.0, ..cone }).unwrap();
    assert_eq!(lead(&moves), Some(2.0));
    // Steeper than 45 degrees X moves more, and the lead counts there: 2 in Z is 2·4/3 in X.
    let moves = thread([30.0, 5.0], Cylinder, &Threading { lead: -2.0, to: [24.0, -3.0], ..cone }).unwrap();
    assert!((lead(&moves).unwrap() - 8.0 / 3.0).abs() < 1e-12);
}

#[test]
fn g87_is_g86_on_the_face() {
    let swap = |p: [f64; 2]| [p[1], p[0]];
    let tapered = Threading { to: [21.0, -30.0], exit: 3.0, ..M40 };
    let face = Threading { from: swap(tapered.from), to: swap(tapered.to), ..tapered };
    let expected: Vec<(char, [f64; 2])> =
        thread([25.0, 10.0], Cylinder, &tapered).unwrap().iter().map(super::bare).map(|(w, p)| (w, swap(p))).collect();
    assert_moves(&thread([10.0, 25.0], Face, &face).unwrap(), &expected);
}

#[test]
fn threads_that_cannot_be_cut_are_refused() {
    for wrong in [
        Threading { depth: 0.0, ..M40 },
        Threading { step: 0.0, ..M40 },
        Threading { least: -0.1, ..M40 },
        Threading { finishing: 1.2, ..M40 },
        Threading { lead: 0.0, ..M40 },
        Threading { exit: -1.0, ..M40 },
        Threading { exit: 30.0, ..M40 },
        Threading { angle: 90.0, ..M40 },
        Threading { to: [20.0, 0.0], ..M40 },
        Threading { safety: f64::NAN, ..M40 },
    ] {
        assert_eq!(thread([25.0, 10.0], Cylinder, &wrong).unwrap_err().exit, Exit::Refused, "{wrong:?}");
    }
    for endless in [Threading { step: 1e-3, ..M40 }, Threading { step: -1e-5, ..M40 }] {
        assert_eq!(thread([25.0, 10.0], Cylinder, &endless).unwrap_err().exit, Exit::Limit);
    }
}
