//! G76.

use rodete::finding::{AlarmFamily, Exit};
use rodete::gcode::motion::Thread;
use rodete::gcode::turning::MoveKind;
use rodete::gcode::turning::thread_cycle::{Threading, thread};

use super::assert_moves;
use super::rs274;

/// M30 × 2 of height 1.2: first cut 0.4.
const M30: Threading = Threading {
    finishing: 2,
    chamfer: 0,
    angle: 60.0,
    least: 0.0,
    allowance: 0.0,
    to: [13.8, -30.0],
    taper: 0.0,
    height: 1.2,
    first: 0.4,
    lead: 2.0,
};

#[test]
fn each_pass_takes_the_same_area_and_never_less_than_the_least_cut() {
    // 0.4·√n up to 1.2: n = 9 passes; then two at 1.2.
    let depths = M30.depths().unwrap();
    assert_eq!(depths.len(), 11);
    for (n, depth) in (1..=9).zip(&depths) {
        assert!((depth - 0.4 * f64::from(n).sqrt()).abs() < 1e-12);
    }
    // Least cut 0.15: 0.4, 0.5657, 0.7157 (0.6928 would be 0.127 more), 0.8657, 1.0157, then 1.1 as the height less 0.1.
    let depths = Threading { least: 0.15, allowance: 0.1, ..M30 }.depths().unwrap();
    let second = 0.4 * 2.0_f64.sqrt();
    let expected = [0.4, second, second + 0.15, second + 0.3, second + 0.45, 1.1, 1.2, 1.2];
    assert_eq!(depths.len(), expected.len());
    assert!(depths.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{depths:?}");
}

#[test]
fn a_thread_runs_as_drawn_with_its_pull_out() {
    // One cut to 0.8 (allowance 0.4) and one to 1.2; crest at radius 15. tan 30° = 0.57735. Pull-out over 5 tenths of 2 mm:
    // it begins at Z−29 and rises by 1 to Z−30.
    let t = 1.0 / 3.0_f64.sqrt();
    let moves =
        thread([16.0, 5.0], &Threading { finishing: 1, chamfer: 5, allowance: 0.4, first: 0.8, ..M30 }).unwrap();
    assert_moves(
        &moves,
        &[
            ('r', [16.0, 5.0 - 0.8 * t]),
            ('r', [14.2, 5.0 - 0.8 * t]),
            ('t', [14.2, -29.0]),
            ('t', [15.2, -30.0]),
            ('r', [16.0, -30.0]),
            ('r', [16.0, 5.0]),
            ('r', [16.0, 5.0 - 1.2 * t]),
            ('r', [13.8, 5.0 - 1.2 * t]),
            ('t', [13.8, -29.0]),
            ('t', [14.8, -30.0]),
            ('r', [16.0, -30.0]),
            ('r', [16.0, 5.0]),
        ],
    );
    assert_eq!(moves[2].kind, MoveKind::Thread(Thread { lead: 2.0, change: 0.0, angle: 0.0 }));
}

#[test]
fn a_taper_and_an_inside_thread_run_along_their_cones() {
    // Outside, i = −1.75 over 35 mm: the root rises by 0.05 per mm towards the chuck.
    let straight = Threading { finishing: 1, angle: 0.0, first: 1.2, taper: -1.75, ..M30 };
    let moves = thread([16.0, 5.0], &straight).unwrap();
    assert_moves(&moves[..4], &[('r', [12.05, 5.0]), ('t', [13.8, -30.0]), ('r', [16.0, -30.0]), ('r', [16.0, 5.0])]);
    // Inside: the root lies outside the start; the first cut ends 0.8 outside the crest.
    let inside = Threading { finishing: 1, angle: 0.0, first: 0.8, to: [16.2, -30.0], ..M30 };
    let moves = thread([14.0, 5.0], &inside).unwrap();
    assert_moves(&moves[..2], &[('r', [15.8, 5.0]), ('t', [15.8, -30.0])]);
}

#[test]
fn a_long_pull_out_ends_at_the_level_of_the_start() {
    let moves = thread([15.0, 5.0], &Threading { finishing: 1, chamfer: 20, angle: 0.0, first: 1.2, ..M30 }).unwrap();
    assert_moves(&moves[..4], &[('r', [13.8, 5.0]), ('t', [13.8, -26.0]), ('t', [15.0, -27.2]), ('r', [15.0, 5.0])]);
}

#[test]
fn threads_that_a_control_refuses_are_refused() {
    let alarm = |threading: Threading| thread([16.0, 5.0], &threading).unwrap_err().alarm(AlarmFamily::Fanuc);
    assert_eq!(alarm(Threading { lead: 0.0, ..M30 }), Some(313));
    assert_eq!(alarm(Threading { lead: -2.0, ..M30 }), Some(313));
    assert_eq!(alarm(Threading { angle: 45.0, ..M30 }), Some(315));
    assert_eq!(alarm(Threading { least: 1.3, ..M30 }), Some(316));
    assert_eq!(alarm(Threading { least: -0.1, ..M30 }), Some(316));
    assert_eq!(alarm(Threading { height: 0.0, ..M30 }), Some(317));
    assert_eq!(alarm(Threading { first: 0.0, ..M30 }), Some(317));
    for other in [
        Threading { allowance: 1.2, ..M30 },
        Threading { allowance: -0.1, ..M30 },
        Threading { finishing: 0, ..M30 },
        Threading { finishing: 100, ..M30 },
        Threading { chamfer: 100, ..M30 },
        Threading { to: [15.5, -30.0], ..M30 },
        Threading { to: [13.8, 5.0], ..M30 },
        Threading { to: [13.8, 4.5], ..M30 },
        Threading { taper: 1.2, ..M30 },
        Threading { lead: f64::NAN, ..M30 },
    ] {
        assert_eq!(alarm(other), None, "{other:?}");
    }
    // Without a least cut (1.2 / 0.001)² = 1,440,000 passes.
    let trouble = thread([16.0, 5.0], &Threading { first: 0.001, ..M30 }).unwrap_err();
    assert_eq!(trouble.exit, Exit::Limit);
    assert!(trouble.what.en.contains("1440000"), "{}", trouble.what.en);
}

#[test]
fn linuxcnc_cuts_the_same_depths_and_begins_at_the_same_places() {
    if !rs274::is_here() {
        return;
    }
    // The crest 1 mm under the drive line at 16; degression 2; along the flank at 30 degrees; two passes more at full depth.
    let program = b"G18 G21 G90 G8 G95 F1 S500 M3\nG0 X16 Z5\nG76 P2 Z-30 I-1 J0.4 K1.2 R2 Q30 H2 E0 L0\nM2\n";
    let canon = rs274::run(program, None, None).unwrap();
    let theirs: Vec<[f64; 2]> = canon
        .motions
        .iter()
        .filter(|motion| matches!(motion.kind, rs274::Kind::Feed(_)))
        .map(|motion| [motion.from[0], motion.from[2]])
        .collect();
    let mut ours = Vec::new();
    let mut at = [16.0, 5.0];
    for m in thread([16.0, 5.0], &M30).unwrap() {
        if matches!(m.kind, MoveKind::Thread(_)) {
            ours.push(at);
        }
        at = m.to;
    }
    assert_eq!(ours.len(), theirs.len());
    for (ours, theirs) in ours.iter().zip(&theirs) {
        assert!(ours.iter().zip(theirs).all(|(a, b)| (a - b).abs() < 1e-4), "{ours:?} {theirs:?}");
    }
}
