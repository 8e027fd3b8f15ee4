//! Complete programs for a control whose rotary axes may be rollover, and how they begin.
#![allow(non_snake_case, reason = "symbols as in the source")]

use crate::common;

use common::{absolute, outcome, parameters, program, read_back};
use rodete::finding::{Finding, Grade, Place};
use rodete::gcode::control::RotaryMode;
use rodete::gcode::interpreter::Setting;
use rodete::gcode::motion::{Motion, MotionKind};
use rodete::gcode::program::Program;
use rodete::kind::Outcome;
use rodete::kinds;
use rodete::kinds::impeller::parameters::FORM;
use rodete::machine::axis::{Axis, Position};
use rodete::parameter::Value;
use rodete::proof::rollover;

const MILLED: [&str; 3] = ["blade", "splitter", "impeller"];

fn milled<'a>(outcome: &'a Outcome, key: &str) -> &'a Program {
    outcome.programs.iter().find(|program| program.key == key).expect("the program")
}

fn motions(program: &Program, rotary: RotaryMode) -> Vec<Motion> {
    let setting = Setting { rotary, ..program.setting() };
    program.read_back_with(setting).collect::<Result<_, _>>().expect("it is read")
}

fn line(text: &str) -> Value {
    Value::Line(text.to_owned())
}

fn refusals(changes: &[(&'static str, Value)]) -> Vec<Finding> {
    kinds::run(&FORM, common::values("full", changes), common::source()).expect_err("it is refused").findings
}

/// The cautions on how the programs begin; those on what they leave of the part are not looked at here.
fn cautions(changes: &[(&'static str, Value)]) -> Vec<(Place, String)> {
    let begins = ["rotary", "distance", "retract", "start_codes", "coolant"];
    let ours =
        |place: &Place| matches!(place, Place::Parameters(keys) if keys.iter().any(|key| begins.contains(&key.name())));
    let found = outcome("full", changes).findings.into_iter();
    let found = found.filter(|finding| finding.grade == Grade::Caution && ours(&finding.place));
    found.map(|finding| (finding.place, finding.what.en.to_string())).collect()
}

#[test]
fn the_usual_programs_make_the_same_motions_on_rollover_and_on_linear_axes() {
    let outcome = outcome("full", &[]);
    for key in MILLED {
        let program = milled(&outcome, key);
        let [rollover, linear] = [RotaryMode::Rollover, RotaryMode::Linear].map(|rotary| motions(program, rotary));
        assert_eq!(rollover.len(), linear.len(), "{key}");
        for (one, other) in rollover.iter().zip(&linear) {
            assert_eq!((one.line, one.from, one.to), (other.line, other.from, other.to), "{key}");
            let turned = one.to.differences(&one.from)[Axis::C as usize].abs();
            assert!(matches!(one.kind, MotionKind::Rapid) || turned <= 180.0, "{key} line {}", one.line);
        }
        let last = rollover.last().expect("a motion").to;
        for axis in [Axis::X, Axis::Y, Axis::B, Axis::C] {
            assert!(last.get(axis).abs() < 1e-9, "{key}: {} ends at {}", axis.letter(), last.get(axis));
        }
    }
}

#[test]
fn one_absolute_block_turns_and_all_else_is_increments_without_words_that_stand_still() {
    for key in MILLED {
        let text = program(&outcome("full", &[]), key);
        let blocks: Vec<&str> = text.lines().filter(|line| line.starts_with('N')).collect();
        let switch = blocks.iter().position(|block| block.ends_with(" G91")).expect("G91");
        let turning: Vec<&&str> =
            blocks[..switch].iter().filter(|block| block.contains([' '].as_slice()) && block.contains(" B")).collect();
        let C = if key == "splitter" { "C135.000" } else { "C90.000" };
        assert_eq!(turning.len(), 1, "{key}");
        assert!(turning[0].ends_with(&format!("G0 B90.000 {C}")), "{key}: {}", turning[0]);
        for block in &blocks[switch + 1..] {
            let still = block.split(' ').any(|word| {
                word.starts_with(['X', 'Y', 'Z', 'B', 'C']) && word.ends_with("0.000") && word[1..].parse() == Ok(0.0)
            });
            assert!(!still, "{key}: {block}");
        }
        assert_eq!(blocks.iter().filter(|block| block.contains("G90")).count(), 2, "{key}: safety block and end");
    }
}

/// The increments lead to the positions of the absolute program, block for block, C but for one whole turn: nothing drifts.
#[test]
fn increments_lead_to_the_rounded_positions_to_the_last_block() {
    for key in MILLED {
        let [by_increments, by_positions] = [vec![], absolute(&[("start_codes", line("M3 M11 M13"))])].map(|changes| {
            let text = program(&outcome("full", &changes), key);
            let cutting = |line: &&str| line.contains(" G1 ") || line.contains(" G0 ") && !line.contains("G53");
            let kept: Vec<bool> = text
                .lines()
                .filter(|line| {
                    line.starts_with('N') && line.contains([' '].as_slice()) && line.contains(|c| "XYZBC".contains(c))
                })
                .filter(cutting)
                .map(|line| line.contains(" G1 "))
                .collect();
            let text = text.replace("G0 G53 Z0.000", "G54");
            let positions = read_back(&text, Position::default());
            assert_eq!(positions.len(), kept.len(), "{key}");
            let fed = positions.into_iter().zip(kept).filter(|(_, fed)| *fed);
            fed.map(|(position, _)| position).collect::<Vec<Position>>()
        });
        assert_eq!(by_increments.len(), by_positions.len(), "{key}");
        for (one, other) in by_increments.iter().zip(&by_positions) {
            for axis in [Axis::X, Axis::Y, Axis::Z, Axis::B] {
                assert_eq!(one.get(axis), other.get(axis), "{key}");
            }
            assert_eq!((one.get(Axis::C) - other.get(Axis::C)).thousandths(), 360_000, "{key}");
        }
    }
}

#[test]
fn positions_on_rollover_axes_are_refused_at_their_cells() {
    let findings = refusals(&[("distance", Value::Choice("G90"))]);
    let [finding] = findings.as_slice() else { panic!("{findings:?}") };
    assert_eq!(parameters(&finding.place), ["distance", "rotary", "dialect"]);
    assert!(finding.what.en.starts_with("distance = G90 with rollover axes"), "{}", finding.what.en);
    assert!(finding.remedy.en.contains("rotary = linear"), "{}", finding.remedy.en);
    // A workbook without the cell is one of a control as it is delivered.
    let mut values = common::values("full", &[("distance", Value::Choice("G90"))]);
    values.values.remove("rotary");
    let refusal = kinds::run(&FORM, values, common::source()).expect_err("it is refused");
    assert_eq!(refusal.findings.len(), 1);
}

#[test]
fn positions_are_written_where_the_axes_are_linear_and_it_is_told() {
    let changes = absolute(&[("start_codes", line("M3 M11 M13")), ("retract", line("G0 G53 Z0"))]);
    let told = cautions(&changes);
    let outcome = outcome("full", &changes);
    // The other one is on G53.
    assert_eq!(told.len(), 2, "{told:?}");
    assert!(told[0].1.starts_with("the programs are right only if B and C count as linear axes"), "{told:?}");
    let blade = milled(&outcome, "blade");
    assert!(blade.text().contains("VALID ONLY IF B AND C ARE NOT ROLLOVER AXES"));
    assert_eq!(rollover::check(blade, RotaryMode::Linear).grade(), Some(Grade::Note));
    // The same program is none for an axis that is rollover.
    let check = rollover::check(blade, RotaryMode::Rollover);
    assert_eq!(check.grade(), Some(Grade::Stop));
    assert!(check.finding().expect("a finding").what.en.contains("turns differently on rollover axes"));
}

#[test]
fn every_program_says_which_rotary_axes_it_is_true_for() {
    for (case, dialect, says) in [
        ("full", "fagor-8055", "rollover and linear: the same "),
        ("tfg-2021", "fagor-8055", "rollover and linear: the same "),
        ("tfg-2021", "fagor-8070", "rollover and linear: the same "),
    ] {
        let outcome = outcome(case, &[("dialect", Value::Choice(dialect))]);
        for key in MILLED {
            let check = rollover::check(milled(&outcome, key), RotaryMode::Rollover);
            assert_eq!(check.grade(), None, "{case} {dialect} {key}");
            assert!(check.value().en.starts_with(says), "{case} {dialect} {key}: {}", check.value().en);
        }
        let table = outcome.table("verification").expect("the table");
        assert!(format!("{:?}", table.columns).contains(says), "{case}");
    }
    let linear = outcome("full", &absolute(&[("dialect", Value::Choice("linuxcnc"))]));
    assert_eq!(rollover::check(milled(&linear, "blade"), RotaryMode::Linear).value().en, "linear axes only");
}

#[test]
fn the_tool_is_taken_away_before_anything_moves() {
    for key in MILLED {
        let text = program(&outcome("full", &[]), key);
        let moves = |line: &&str| {
            line.starts_with('N') && line.split(' ').skip(1).any(|word| word.starts_with(['X', 'Y', 'Z', 'B', 'C']))
        };
        let first: Vec<&str> =
            text.lines().filter(moves).take(4).map(|line| line.split_once(' ').map_or("", |one| one.1)).collect();
        assert_eq!(first[..3], ["G0 G53 Z0.000", "G0 X0.000 Y0.000", "G0 Z6.284"], "{key}");
        assert!(first[3].starts_with("G0 B90.000"), "{key}: {}", first[3]);
    }
    let assumed = cautions(&[]);
    let [(place, what)] = assumed.as_slice() else { panic!("{assumed:?}") };
    assert_eq!(parameters(place), ["retract"]);
    assert!(what.starts_with("retract with G53 assumes that machine zero is at the top of Z"), "{what}");

    let without = [("retract", line(""))];
    let missing = cautions(&without);
    let [(place, what)] = missing.as_slice() else { panic!("{missing:?}") };
    assert_eq!(parameters(place), ["retract"]);
    assert!(what.starts_with("retract is empty: the first motion takes Z to its retract height"), "{what}");
    let text = program(&outcome("full", &without), "blade");
    assert!(text.contains("NO BLOCK TAKES THE TOOL AWAY"), "{text}");
}

#[test]
fn a_block_that_takes_the_tool_away_is_refused_where_it_does_something_else() {
    for (dialect, block, what) in [
        ("fagor-8055", "G53 Z0", "the control does not take the block of retract: G53 without G0 or G1 in force"),
        ("linuxcnc", "G53 Z0", "the control does not take the block of retract: G53 without G0 or G1 in force"),
        ("fagor-8070", "Z100", "the control does not take the block of retract: axis words without a motion in force"),
        ("fagor-8055", "G74", "retract holds G74: the dialect fagor-8055 does not allow it there"),
        ("fagor-8055", "G28 Z0", "retract holds G28: the dialect fagor-8055 does not allow it there"),
        ("fagor-8055", "G91 Z100", "retract holds G91: the dialect fagor-8055 does not allow it there"),
        ("fagor-8055", "G0 Z100 M30", "retract holds M30: the dialect fagor-8055 does not allow it there"),
        ("fagor-8055", "G0 G53 X0", "retract moves axes but not Z: the tool does not leave the part"),
        ("fagor-8070", "G0 G53 Z0", "retract holds G53: the dialect fagor-8070 does not allow it there"),
        ("linuxcnc", "G28 Z0", "retract holds G28: the dialect linuxcnc does not allow it there"),
    ] {
        let start_codes = ("start_codes", line(if dialect == "linuxcnc" { "M3" } else { "M3 M11 M13" }));
        let findings = refusals(&[("dialect", Value::Choice(dialect)), ("retract", line(block)), start_codes]);
        assert_eq!(findings.len(), 1, "{block}: {findings:?}");
        assert_eq!(parameters(&findings[0].place), ["retract", "dialect"], "{block}");
        assert_eq!(findings[0].what.en, what, "{block}");
    }
    // Up alone, and high enough: what the block does is judged as well.
    for (dialect, block, what) in [
        ("fagor-8055", "G0 G53 X0 Z0", "retract moves X as well: the cutter may cross the part sideways"),
        ("linuxcnc", "G0 G53 Y0 Z0", "retract moves Y as well: the cutter may cross the part sideways"),
        ("fagor-8070", "G0 X0 Z100", "retract moves X as well: the cutter may cross the part sideways"),
        ("fagor-8070", "G0 Z-20", "retract takes Z to -20 mm, below the retract height Z_r of "),
        (
            "linuxcnc",
            "G0 Z100",
            "retract moves Z in program coordinates, which hold for the tip of the tool that will cut: ",
        ),
    ] {
        let start_codes = ("start_codes", line(if dialect == "linuxcnc" { "M3" } else { "M3 M11 M13" }));
        let findings = refusals(&[("dialect", Value::Choice(dialect)), ("retract", line(block)), start_codes]);
        assert_eq!(findings.len(), 1, "{block}: {findings:?}");
        assert!(findings[0].what.en.starts_with(what), "{block}: {}", findings[0].what.en);
    }
    for (dialect, block) in [("linuxcnc", "G0 G53 Z0"), ("fagor-8070", "G0 Z100")] {
        let changes = [("dialect", Value::Choice(dialect)), ("retract", line(block)), ("start_codes", line("M3"))];
        let text = program(&outcome("full", &changes), "blade");
        assert!(text.contains(&block.replace("Z0", "Z0.000").replace("Z100", "Z100.000")), "{dialect} {block}");
    }
}

/// As the chapter and the set-up sheet of an impeller say it.
#[test]
fn the_table_turns_after_z_where_turns_are_increments_and_with_x_and_y_elsewhere() {
    for (dialect, distance, block, order) in [
        (
            "fagor-8055",
            "G91",
            "G0 G53 Z0",
            ["G0 G53 Z0.000", "G0 X0.000 Y0.000", "G0 Z6.284", "G0 B90.000 C90.000"].as_slice(),
        ),
        ("fagor-8055", "G91", "", &["G0 Z6.284", "G0 X0.000 Y0.000", "G0 B90.000 C90.000"]),
        ("fagor-8055", "G90", "G0 G53 Z0", &["G0 G53 Z0.000", "G0 X0.000 Y0.000 B0.000 C0.000", "G0 Z6.284"]),
        ("fagor-8055", "G90", "", &["G0 Z6.284", "G0 X0.000 Y0.000 B0.000 C0.000"]),
        ("fagor-8070", "G91", "G0 Z200", &["G0 Z200.000", "G0 X0.000 Y0.000 B0.000 C0.000", "G0 Z6.284"]),
        ("fagor-8070", "G91", "", &["G0 Z6.284", "G0 X0.000 Y0.000 B0.000 C0.000"]),
        ("linuxcnc", "G91", "G0 G53 Z0", &["G0 G53 Z0.000", "G0 X0.000 Y0.000 B0.000 C0.000", "G0 Z6.284"]),
        ("linuxcnc", "G91", "", &["G0 Z6.284", "G0 X0.000 Y0.000 B0.000 C0.000"]),
        ("linuxcnc", "G90", "G0 G53 Z0", &["G0 G53 Z0.000", "G0 X0.000 Y0.000 B0.000 C0.000", "G0 Z6.284"]),
    ] {
        let mut changes = vec![("dialect", Value::Choice(dialect)), ("retract", line(block))];
        changes.push(("start_codes", line(if dialect == "fagor-8055" { "M3 M11 M13" } else { "M3" })));
        if distance == "G90" {
            changes.extend([("distance", Value::Choice("G90")), ("rotary", Value::Choice("linear"))]);
        }
        let text = program(&outcome("full", &changes), "blade");
        let moves: Vec<&str> =
            text.lines().filter_map(|line| line.find("G0 ").map(|at| line[at..].trim_end())).collect();
        assert_eq!(&moves[..order.len()], order, "{dialect} {distance} {block}");
    }
}

#[test]
fn start_codes_without_the_published_clamps_are_told_and_coolant_is_switched_on_before_the_cut() {
    let told = cautions(&[("start_codes", line("M3 M13"))]);
    assert_eq!(told.len(), 2, "{told:?}");
    assert!(
        told.iter().any(|(place, what)| parameters(place) == ["start_codes"]
            && what.starts_with("start_codes lacks M11: the published programs begin with M11 M13")),
        "{told:?}"
    );
    let text = program(&outcome("full", &[("coolant", line("M8"))]), "blade");
    let [codes, coolant, cut] = ["S6000 M3 M11 M13", " M8", " G1 "].map(|part| text.find(part).expect(part));
    assert!(codes < coolant && coolant < cut);
    let annex = program(&outcome("tfg-2021", &[("coolant", line("M8"))]), "blade");
    assert!(annex.starts_with("N10 G91 M3 M11 M13 M8"), "{annex}");
}
