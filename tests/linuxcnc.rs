//! LinuxCNC's own interpreter, `rs274` of the Debian package linuxcnc-uspace, as an independent judge of the programs in
//! its dialect. A black box: private HOME, fresh variable file, a deadline.

#[path = "interpreter/agreement.rs"]
mod agreement;
mod common;
#[path = "interpreter/ours.rs"]
mod ours;

use common::rs274::{self, Canon, Judge, Kind, Six};
use rodete::machine::axis::Position;
use rodete::parameter::Value;

/// The machine unit of the stand-alone interpreter is the inch.
const TOOLS: &str = "T1 P1 Z0 D0.23622 ;\n";

fn judge(program: &str) -> Result<Canon, rs274::Refused> {
    rs274::run(program.as_bytes(), None, Some(TOOLS))
}

/// True for a rapid move, and where it ends.
fn moves(canon: &Canon) -> Vec<(bool, Six)> {
    let moves = canon.motions.iter().map(|motion| match motion.kind {
        Kind::Rapid => (true, motion.machine),
        Kind::Feed(_) => (false, motion.machine),
        Kind::Arc { .. } | Kind::Dwell(_) => panic!("not among our programs: {motion:?}"),
    });
    moves.collect()
}

#[test]
fn linuxcnc_moves_as_planned() {
    if !rs274::is_here() {
        return;
    }
    for distance in ["G90", "G91"] {
        for (n, N, splitters) in [(40, 4, "yes"), (17, 3, "yes"), (80, 5, "no")] {
            let outcome = common::outcome(
                "full",
                &[
                    ("dialect", Value::Choice("linuxcnc")),
                    ("distance", Value::Choice(distance)),
                    ("n", Value::Whole(n)),
                    ("N", Value::Whole(N)),
                    ("splitters", Value::Choice(splitters)),
                ],
            );
            for program in outcome.programs.iter().filter(|program| program.key != "blank") {
                let motions = moves(&judge(&program.text()).unwrap());
                let mut planned = Vec::new();
                program.for_each_move(&mut |each| {
                    planned.push((each.path.rapid, each.to.differences(&Position::default())));
                });
                // Before the plan: two positioning blocks. G93 makes no motion, but a null move may be listed.
                let motions: Vec<_> = motions
                    .iter()
                    .enumerate()
                    .filter(|&(at, motion)| at == 0 || motions[at - 1].1 != motion.1)
                    .map(|(_, motion)| *motion)
                    .collect();
                let motions = &motions[motions.len() - planned.len()..];
                for (judged, planned) in motions.iter().zip(&planned) {
                    assert_eq!(judged.0, planned.0, "{}", program.key);
                    let miss = judged.1.iter().zip(planned.1).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                    assert!(miss < 0.000_051, "{}: {judged:?} against {planned:?}", program.key);
                }
            }
        }
    }
}

/// Three that know nothing of one another: the plan that the text was written from, rodete's interpreter of the text, and
/// LinuxCNC's.
#[test]
fn plan_interpreter_and_linuxcnc_agree_on_our_programs() {
    for (distance, n, splitters) in [("G90", 40, "yes"), ("G91", 40, "yes"), ("G90", 23, "no")] {
        let outcome = common::outcome(
            "full",
            &[
                ("dialect", Value::Choice("linuxcnc")),
                ("distance", Value::Choice(distance)),
                ("n", Value::Whole(n)),
                ("splitters", Value::Choice(splitters)),
            ],
        );
        for program in outcome.programs.iter().filter(|program| program.key != "blank") {
            let text = program.text();
            let judge = Judge { tools: Some(TOOLS), ..Judge::default() };
            let (motions, _) =
                ours::run(text.as_bytes(), &judge).unwrap_or_else(|fault| panic!("{}: {fault}", program.key));
            if rs274::is_here() {
                agreement::agree(&motions, &judge.run(text.as_bytes()).unwrap().motions).unwrap();
            }
            let read = motions.iter().filter(|motion| motion.from != motion.to);
            // Positioning blocks come before the plan.
            let mut planned = 0;
            program.for_each_move(&mut |_| planned += 1);
            let before = read.clone().count().checked_sub(planned).expect("every planned move is in the text");
            let mut read = read.skip(before);
            program.for_each_move(&mut |each| {
                let motion = read.next().expect("a motion");
                assert_eq!(motion.line, each.line, "{}", program.key);
                assert_eq!(matches!(motion.kind, rodete::gcode::motion::Kind::Rapid), each.path.rapid);
                let planned = each.to.differences(&Position::default());
                let miss = motion.machine.0.iter().zip(planned).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                assert!(miss < 1e-9, "{} line {}: {motion:?} against {planned:?}", program.key, each.line);
                // F is the inverse of the time, with three decimals.
                if let (Some(seconds), false) = (each.path.seconds(each.step), each.path.rapid) {
                    let read = motion.seconds.expect("a time");
                    assert!(
                        (60.0 / read - 60.0 / seconds).abs() < 0.000_501,
                        "line {}: {read} s, {seconds} s planned",
                        each.line
                    );
                }
            });
        }
    }
}

#[test]
fn the_judge_refuses_what_is_wrong() {
    if rs274::is_here() {
        assert!(judge("G1 X1\nM2\n").is_err(), "a feed move without F");
        assert!(judge("G0 X1 M11 M13\nM2\n").is_err(), "codes of another control");
    }
}

#[test]
fn a_hostile_part_name_makes_no_move() {
    if !rs274::is_here() {
        return;
    }
    let program = |part: &str| {
        let outcome =
            common::outcome("full", &[("dialect", Value::Choice("linuxcnc")), ("part", Value::Line(part.to_owned()))]);
        moves(&judge(&common::program(&outcome, "blade")).unwrap())
    };
    assert_eq!(program("A)G0 Z-500 (x"), program("Impeller"));
    assert_eq!(program("A\nG0 Z-500\r;(MSG,%"), program("Impeller"));
}
