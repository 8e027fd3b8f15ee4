//! LinuxCNC's own interpreter, `rs274` of the Debian package linuxcnc-uspace, as an independent judge of the programs in
//! its dialect. A black box: private HOME, fresh variable file, a deadline.

use crate::common;
use crate::common::agreement;

use common::rs274::{self, Canon, Judge, Kind, Six};
use rodete::gcode::control::LINUXCNC;
use rodete::gcode::interpreter::{Interpreter, Setting};
use rodete::gcode::motion::{self, Motion};
use rodete::gcode::program::Program;
use rodete::machine::axis::Position;
use rodete::parameter::Value;

/// The machine unit of the stand-alone interpreter is the inch.
const TOOLS: &str = "T1 P1 Z0 D0.23622 ;\nT2 P2 Z0 D0.11811 ;\n";

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

/// The designs, as changes to the published one: distance, n, N, splitters.
const DESIGNS: [(&str, u32, u32, &str); 5] =
    [("G90", 40, 4, "yes"), ("G91", 40, 4, "yes"), ("G90", 17, 3, "yes"), ("G91", 23, 3, "no"), ("G90", 80, 2, "no")];

/// Three that know nothing of one another: the plan that the text was written from, rodete's interpreter of the text, and
/// LinuxCNC's. The turning program of the blank is for a lathe, and in no dialect of a mill.
#[test]
fn plan_interpreter_and_linuxcnc_agree_on_our_programs() {
    let judge = Judge { tools: Some(TOOLS), ..Judge::default() };
    for (distance, n, N, splitters) in DESIGNS {
        let outcome = common::outcome(
            "full",
            &[
                ("dialect", Value::Choice("linuxcnc")),
                ("distance", Value::Choice(distance)),
                ("rotary", Value::Choice("linear")),
                ("start_codes", Value::Line("M3".to_owned())),
                ("n", Value::Whole(n)),
                ("N", Value::Whole(N)),
                ("splitters", Value::Choice(splitters)),
            ],
        );
        let programs: Vec<_> = outcome.programs.iter().filter(|program| program.key != "blank").collect();
        assert!(!programs.is_empty(), "{:?}", outcome.findings);
        for program in programs {
            let design = format!("{} {distance} n {n} N {N} splitters {splitters}", program.key);
            assert_eq!(program.control.name, "linuxcnc", "{design}");
            let motions: Vec<Motion> = program
                .read_back()
                .collect::<Result<_, _>>()
                .unwrap_or_else(|fault| panic!("{design}: {}: {}", fault.line, fault.what.en));
            if rs274::is_here() {
                let theirs =
                    judge.run(program.text().as_bytes()).unwrap_or_else(|refused| panic!("{design}: {refused:?}"));
                agreement::agree(&motions, &theirs.motions).unwrap_or_else(|fault| panic!("{design}: {fault}"));
            }
            assert_as_planned(program, &motions, &design);
        }
    }
}

/// The same of a clear cut's two programs, with few lanes: with splitters and without, with both spindles.
#[test]
fn plan_interpreter_and_linuxcnc_agree_on_the_programs_of_a_clear_cut() {
    let judge = Judge { tools: Some(TOOLS), ..Judge::default() };
    for (distance, N, splitters, start) in [("G90", 2, "yes", "M3"), ("G91", 3, "no", "M4")] {
        let outcome = common::outcome(
            "clear",
            &[
                ("dialect", Value::Choice("linuxcnc")),
                ("distance", Value::Choice(distance)),
                ("rotary", Value::Choice("linear")),
                ("start_codes", Value::Line(start.to_owned())),
                ("N", Value::Whole(N)),
                ("splitters", Value::Choice(splitters)),
                ("c_s", Value::Real(0.5)),
                ("tol", Value::Real(0.05)),
                ("kappa", Value::Real(0.95)),
            ],
        );
        for key in ["rough", "finish"] {
            let found = outcome.programs.iter().find(|program| program.key == key);
            let program = found.unwrap_or_else(|| panic!("{key}: {:?}", outcome.findings));
            let design = format!("{key} {distance} N {N} splitters {splitters}");
            assert_eq!(program.control.name, "linuxcnc", "{design}");
            let motions: Vec<Motion> = program
                .read_back()
                .collect::<Result<_, _>>()
                .unwrap_or_else(|fault| panic!("{design}: {}: {}", fault.line, fault.what.en));
            assert!(motions.len() > 300, "{design}: {}", motions.len());
            if rs274::is_here() {
                let theirs =
                    judge.run(program.text().as_bytes()).unwrap_or_else(|refused| panic!("{design}: {refused:?}"));
                agreement::agree(&motions, &theirs.motions).unwrap_or_else(|fault| panic!("{design}: {fault}"));
            }
            assert_as_planned(program, &motions, &design);
        }
    }
}

fn assert_as_planned(program: &Program, motions: &[Motion], design: &str) {
    let read = motions.iter().filter(|motion| motion.from != motion.to);
    // Positioning blocks come before the plan.
    let mut planned = 0;
    program.for_each_move(&mut |_| planned += 1);
    assert!(planned > 0, "{design}");
    let before = read.clone().count().checked_sub(planned).expect("every planned move is in the text");
    let mut read = read.skip(before);
    program.for_each_move(&mut |each| {
        let motion = read.next().expect("a motion");
        assert_eq!(motion.line, each.line, "{design}");
        assert_eq!(matches!(motion.kind, motion::MotionKind::Rapid), each.path.rapid, "{design}");
        let planned = each.to.differences(&Position::default());
        let miss = motion.machine.0.iter().zip(planned).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(miss < 1e-9, "{design} line {}: {motion:?} against {planned:?}", each.line);
        // F is the inverse of the time, with three decimals.
        if let (Some(seconds), false) = (each.path.seconds(each.step), each.path.rapid) {
            let read = motion.seconds.expect("a time");
            assert!(
                (60.0 / read - 60.0 / seconds).abs() < 0.000_501,
                "{design} line {}: {read} s, {seconds} s planned",
                each.line
            );
        }
    });
}

/// The printed annex has no F: LinuxCNC does not feed without one, and no workbook makes such a program for it.
#[test]
fn programs_in_the_style_of_the_annex_are_refused_by_both() {
    let text = common::program(&common::outcome("tfg-2021", &[]), "blade");
    // M11 and M13 are codes of another control, and the first line of another dialect.
    let moves: Vec<&str> = text.lines().skip(1).collect();
    let text = format!("G21 G91 M3\n{}", moves.join("\n"));
    let setting = Setting::new(&LINUXCNC);
    let fault = Interpreter::over(text.as_bytes(), setting).find_map(Result::err).expect("refused");
    assert!(fault.what.en.contains("without F"), "{}", fault.what.en);
    if rs274::is_here() {
        assert!(matches!(judge(&text), Err(rs274::Refused::Error(..))));
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
        let outcome = common::outcome(
            "full",
            &[
                ("dialect", Value::Choice("linuxcnc")),
                ("start_codes", Value::Line("M3".to_owned())),
                ("part", Value::Line(part.to_owned())),
            ],
        );
        moves(&judge(&common::program(&outcome, "blade")).unwrap())
    };
    assert_eq!(program("A)G0 Z-500 (x"), program("Impeller"));
    assert_eq!(program("A\nG0 Z-500\r;(MSG,%"), program("Impeller"));
}
