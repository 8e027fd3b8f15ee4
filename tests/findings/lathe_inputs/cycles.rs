//! Cycles that a lathe rejects, whatever for: what follows them is read and not made.

use super::bench::{Book, HEAD, TAIL, build, lines, program, quantity};
use super::programs::{FAGOR, simulate};
use rodete::gcode::control::FANUC_LATHE_A;
use rodete::gcode::interpreter::{DecimalPoint, Interpreter, Setting};

const CONTOUR: &str = "N10 G0 X30.|G1 Z-15. F0.1|X40. Z-25.|N20 X54.";

/// A program of blocks between the usual ones, simulated: how many motions it made, and the lines with a stop.
fn simulated(dialect: &str, blocks: &str) -> (u64, Vec<u64>) {
    let blocks = blocks.split('|');
    let text: Vec<&str> = match dialect {
        "fagor-8055-t" => FAGOR.into_iter().chain(blocks).chain(["G0 X100 Z50", "M30"]).collect(),
        _ => HEAD.into_iter().chain(blocks).chain(TAIL).collect(),
    };
    let text = text.join("\n");
    let (document, exit) = simulate(&text, &[], &["--dialect", dialect, "--decimal-point", "calculator"]);
    assert_eq!(exit, 3, "{text}");
    let stops = document["findings"].as_array().unwrap().iter().filter(|one| one["grade"] == "stop");
    let lines = stops.map(|one| one["place"]["line"]["line"].as_u64().unwrap()).collect();
    (document["motions"].as_u64().unwrap(), lines)
}

/// Without a stock rodete takes one, which no rejected cycle gives a size.
#[test]
fn a_program_whose_first_cut_is_a_rejected_cycle_is_told_no_collision() {
    let blocks = ["G71 P10 Q20 U0.4 W0.1 D2000 F0.25"].into_iter().chain(CONTOUR.split('|'));
    let text: Vec<&str> =
        HEAD.into_iter().chain(["G0 X52. Z2."]).chain(blocks).chain(["G0 X100. Z100.", "M30"]).collect();
    let (document, exit) = simulate(&text.join("\n"), &[], &["--dialect", "fanuc-lathe-a"]);
    let codes: Vec<&str> = document["findings"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|one| one["grade"] == "stop")
        .filter_map(|one| one["code"].as_str())
        .collect();
    assert_eq!((exit, codes), (3, vec!["G0128"]), "{document}");
}

#[test]
fn nothing_is_made_behind_a_rejected_cycle_whatever_it_is_rejected_for() {
    const FANUC_CYCLES: &[&str] = &[
        "G71 P10 Q20 U0.4 W0.1 D2000 F0.2",
        "D2000 G71 P10 Q20 U0.4 W0.1 F0.2",
        "G71 P10 Q20 U0.4 K0.1 F0.2",
        "G72 P10 Q20 U0.4 W0.1 D2000 F0.2",
        "G73 P10 Q20 I5. K2. U0.4 W0.1 D3 F0.2",
        "G70 P10 Q20 D1",
        "G74 R1.|G74 Z-20. Q5000 F0.1 A1.",
        "G75 R1.|G75 X40. Z-20. P2000 Q2000 F0.1 D1",
        "G76 X48. Z-20. K0.92 D250 F1.5 A60",
        "G90 X46. Z-20. F0.2 D1",
        "G92 X48. Z-20. F1.5 A60",
        "G94 X46. Z-1. F0.2 D1",
        "G83 X0. Z-20. R2. F0.1 A1.",
        "G84 X0. Z-20. R2. F1.",
    ];
    const FAGOR_CYCLES: &[&str] = &[
        "G66 X20 Z0 I5 C2 A0 L0.4 M0.2 H0.1 S100 E200",
        "G68 X20 Z0 C2 D1 L0.4 M0.2 F0.25 H0.1 S100 E200",
        "G69 X20 Z0 C2 D1 L0.4 M0.2 F0.25 H0.1 S100 E200",
        "G81 X40 Z0 Q40 R-20 C1 Y3",
        "G82 X40 Z0 Q40 R-20 C1 Y3",
        "G83 X0 Z0 I20 B5 Y3",
        "G84 X40 Z0 Q40 R-20 C1 I5 K0 Y3",
        "G85 X40 Z0 Q40 R-20 C1 I5 K0 Y3",
        "G86 X48 Z0 Q48 R-20 I1 B0.2 D1 C1.5 Y3",
        "G87 X48 Z0 Q40 R0 I1 B0.2 D1 C1.5 Y3",
        "G88 X54 Z-10 Q40 R-20 C2 Y3",
        "G89 X40 Z0 Q30 R-5 C2 Y3",
    ];
    let of = |dialect: &'static str| move |cycle: &'static &str| (dialect, *cycle);
    let mut wrong = Vec::new();
    let fanuc = FANUC_CYCLES.iter().map(of("fanuc-lathe-a"));
    for (dialect, cycle) in fanuc.chain(FAGOR_CYCLES.iter().map(of("fagor-8055-t"))) {
        let blocks = match dialect {
            "fagor-8055-t" => format!("{cycle}|G0 X40 Z2|G1 Z-30 F0.1|X54"),
            _ => format!("{cycle}|{CONTOUR}|G0 Z2.|X48.|G1 Z-30. F0.1|X54."),
        };
        let (made, lines) = simulated(dialect, &blocks);
        let at = 6 + cycle.matches('|').count() as u64;
        // The one to the bar.
        if made != 1 || lines != [at] {
            wrong.push(format!("{cycle}: made {made}, stops {lines:?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_rejected_repetition_of_a_cycle_of_one_pass_ends_what_is_made() {
    let one = simulated("fanuc-lathe-a", "G90 X46. Z-20. F0.2|G0 X54,1").0;
    // To the bar, a pass of four, and away at the end.
    assert_eq!(one, 6);
    for rejected in ["X44. A1.", "U-2. A1."] {
        let blocks = format!("G90 X46. Z-20. F0.2|{rejected}|X42.|G0 X40.|G1 Z-20.");
        // Not even away.
        assert_eq!(simulated("fanuc-lathe-a", &blocks), (one - 1, vec![7]), "{rejected}");
    }
    // Another block that is rejected leaves the cycle as it is.
    let (made, lines) = simulated("fanuc-lathe-a", "G90 X46. Z-20. F0.2|M3 M4|X44.");
    assert!(made >= one + 4 && lines == [7], "{made} {lines:?}");
}

/// G5 leaves the motion in doubt, and that Z is missing may follow from that: it is not told, and the cycle is not made all the same.
#[test]
fn a_cycle_whose_rejection_follows_from_another_is_not_made_either() {
    assert_eq!(simulated("fanuc-lathe-a", "G5 X1.|G90 X46.|G1 X44. F0.2|Z-20."), (1, vec![6]));
}

#[test]
fn the_contour_of_a_cycle_rejected_for_a_word_is_no_way_of_the_tool() {
    for cycle in ["G71 P10 Q20 D2000 U0.4", "G71 D2000 P10 Q20 U0.4", "D2000 G73 Q20 P10 (P1 Q2)"] {
        let text = format!("G0 X54. Z2.\n{cycle}\n{}\nG70 P10 Q20\nG0 X60.\nM30\n", CONTOUR.replace('|', "\n"));
        let setting = Setting { decimal_point: Some(DecimalPoint::Calculator), ..Setting::new(&FANUC_LATHE_A) };
        let read: Vec<_> = Interpreter::over(text.as_bytes(), setting).collect();
        let motions: Vec<_> = read.iter().filter_map(|item| item.as_ref().ok()).map(|motion| motion.line).collect();
        let faults: Vec<_> =
            read.iter().filter_map(|item| item.as_ref().err()).map(|fault| (fault.line, fault.uncut)).collect();
        assert_eq!((motions, faults), (vec![1, 8], vec![(2, true)]), "{cycle}");
    }
}

/// Those of a workbook's sheet are read through the same door.
#[test]
fn nothing_is_made_behind_a_rejected_cycle_of_a_workbook() {
    let blocks = format!("G71 P10 Q20 U0.4 W0.1 D2000 F0.2|{CONTOUR}");
    let (_folder, document, exit) = build(&Book::new(&program(&blocks)).bytes());
    assert_eq!((exit, quantity(&document, "V_r")), (3, 0.0), "{:?}", lines(&document));
}

/// The blade of T3 is known from the workbook; a blade that is no wider than the step leaves a ring.
#[test]
fn plunges_farther_apart_than_the_blade_is_wide_are_told() {
    for (dialect, blocks, told) in [
        ("fagor-8055-t", "T3 D3|G95 F0.1|G0 X54 Z-50|G88 X50 Z-50 Q40 R-58 C25 D1", true),
        ("fagor-8055-t", "T3 D3|G95 F0.1|G0 X54 Z-50|G88 X50 Z-50 Q40 R-58 C2 D1", false),
        // One plunge, whatever the step.
        ("fagor-8055-t", "T3 D3|G95 F0.1|G0 X54 Z-50|G88 X50 Z-50 Q40 R-50 C25 D1", false),
        ("fanuc-lathe-a", "T0303|G97 S800|G0 X54. Z-50.|G75 R1.|G75 X40. Z-58. P2000 Q8000 F0.1", true),
        ("fanuc-lathe-a", "T0303|G97 S800|G0 X54. Z-50.|G75 R1.|G75 X40. Z-58. P2000 Q2000 F0.1", false),
    ] {
        let blocks = blocks.split('|');
        let text: Vec<&str> = match dialect {
            "fagor-8055-t" => FAGOR.into_iter().chain(blocks).chain(["G0 X100 Z50", "M30"]).collect(),
            _ => HEAD.into_iter().chain(blocks).chain(["G0 X60."]).chain(TAIL).collect(),
        };
        let text = text.join("\n");
        let (document, _) = simulate(&text, &[], &["--dialect", dialect, "--decimal-point", "calculator"]);
        let codes = document["findings"].as_array().unwrap().iter().filter_map(|one| one["code"].as_str());
        assert_eq!(codes.filter(|code| *code == "G0644").count(), usize::from(told), "{text}\n{document}");
    }
}

/// A word of Fanuc habit, where the workbook says which axes the lathe has.
#[test]
fn an_axis_that_the_lathe_of_a_workbook_lacks_stops() {
    let text = [&FAGOR[..], &["G95 F0.2", "X46", "G1 W-22", "X54", "G0 X100 Z50", "M30"]].concat().join("\n");
    let (document, exit) = simulate(&text, &[], &["--dialect", "fagor-8055-t"]);
    let stops: Vec<_> = document["findings"].as_array().unwrap().iter().filter(|one| one["grade"] == "stop").collect();
    assert_eq!((exit, stops.len()), (3, 1), "{document}");
    assert_eq!(stops[0]["code"], "G0838");
    assert!(stops[0]["remedy"]["en"].as_str().unwrap().contains("G91 and Z"), "{document}");
}
