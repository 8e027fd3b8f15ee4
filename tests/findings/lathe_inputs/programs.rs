//! Programs that a lathe must refuse or warn of: D29 to D46 of the list of bad inputs, by exit code, place and message.

use std::fs;

use serde_json::Value as Json;

use super::bench::{Book, HEAD, TAIL, bilingual, build, line, lines, program, run};
use rodete::gcode::control::FANUC_LATHE_A;
use rodete::gcode::interpreter::{DecimalPoint, Interpreter, Setting};
use rodete::kinds::lathe::rules::TooManyMotions;
use rodete::parameter::Value;

/// The start of a program for a Fagor 8055 T.
pub const FAGOR: [&str; 5] = ["N1 G92 S2500", "N2 T1 D1", "N3 M8", "N4 G97 S900 M3", "N5 G0 X54 Z2"];

/// The document and the exit code of a simulation of a bar of 50 by 120 mm.
pub fn simulate(text: &str, files: &[(&str, &str)], more: &[&str]) -> (Json, i32) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("p.nc"), text).unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    let said = run(folder.path(), &[&["simulate", "p.nc", "--stock", "D50xL120", "--json"], more].concat());
    (serde_json::from_str(&said.out).unwrap_or_else(|_| panic!("{text}: {}", said.err)), said.exit)
}

/// A program's blocks behind the head (the sixth line is the first of them), and what must be found.
struct Case {
    /// The row of the list of bad inputs.
    row: &'static str,
    blocks: &'static str,
    exit: i32,
    /// Grade, place and the beginning of the English message.
    found: &'static str,
}

const fn case(row: &'static str, blocks: &'static str, exit: i32, found: &'static str) -> Case {
    Case { row, blocks, exit, found }
}

/// Follows every program and compares; all differences are shown at once.
fn compare(dialect: &str, head: &[&str], tail: &[&str], cases: &[Case]) {
    let mut wrong = Vec::new();
    for one in cases {
        let blocks: Vec<&str> = one.blocks.split('|').collect();
        let text = [head, &blocks, tail].concat().join("\n");
        let (document, exit) =
            simulate(&text, &[("O0005.nc", "G0 U0.\nM99\n")], &["--dialect", dialect, "--decimal-point", "calculator"]);
        let found = lines(&document);
        bilingual(&document);
        if exit != one.exit || document["exit"] != exit || !found.iter().any(|line| line.starts_with(one.found)) {
            wrong.push(format!("{}: expected {} {:?}, got {exit} {found:#?}", one.row, one.exit, one.found));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn fanuc(cases: &[Case]) {
    compare("fanuc-lathe-a", &HEAD, &TAIL, cases);
}

#[test]
fn calls_and_loops_that_do_not_end_are_refused() {
    fanuc(&[
        case("D30 M99", "M99", 7, "stop 6 M99 in the main program repeats it forever"),
        case("D30 M97", "N10 M97 P10", 7, "stop 6 more than 4 nested calls: N10 → N10 → N10 → N10 → N10"),
        case("D30 GOTO", "N10 G0 U0.|GOTO 10", 3, "stop 7:1 rodete does not follow macros (#, IF, WHILE, GOTO)"),
        case("D31 no P", "M98", 3, "stop 6:1 M98 without P"),
        case("D31 L", "M98 P0005 L1000000000", 3, "stop 6:11 L1000000000 is not a number of repeats"),
        case("D31 missing", "M98 P0006", 3, "stop 6:5 PS0078: there is no subprogram O0006"),
        case("D31 twice", "M98 P0007|M30|O0007|M99|O0007|M99", 3, "stop 6:5 O0007 is defined twice: 8, 10"),
        case("D32 path", "M98 P/etc/passwd", 3, "stop 6:6 character '/' is not allowed"),
    ]);
}

#[test]
fn a_budget_ends_what_repeats_itself_for_too_long() {
    let text = [&HEAD[..], &["M98 P99990005"], &TAIL[..]].concat().join("\n");
    let inner = "M98 P99990006\nM99\n";
    for (moves, found) in [
        ("G99\n", "stop O0006 2 the program has repeated more than 10000000 blocks"),
        ("G1 X51. F0.1\nX52.\n", "stop O0006 2 the program makes more than 1000000 motions"),
    ] {
        let files = [("O0005.nc", inner), ("O0006.nc", &format!("{moves}M99\n"))];
        let (document, exit) = simulate(&text, &files, &["--dialect", "fanuc-lathe-a"]);
        assert_eq!(exit, 7, "{document}");
        let told = document["findings"].as_array().unwrap().iter().find(|one| line(one) == found);
        let told = told.unwrap_or_else(|| panic!("{:?}", lines(&document)));
        assert_eq!(told["code"] == TooManyMotions::RULE.code, found.contains("motions"), "{told}");
        bilingual(&document);
    }
}

#[test]
fn what_the_control_does_not_know_is_refused_and_never_skipped() {
    fanuc(&[
        case("D33 G5.9", "G5.9", 3, "stop 6:1 G5.9 is not known to rodete in the dialect fanuc-lathe-a"),
        case("D33 G123", "G123", 3, "stop 6:1 G123 is not known to rodete in the dialect fanuc-lathe-a"),
        case("D33 M250", "M250", 3, "stop 6:1 M250 is not known to rodete in the dialect fanuc-lathe-a"),
        case("D38 G93", "G93 G1 X40.", 3, "stop 6:1 G93 is not known to rodete in the dialect fanuc-lathe-a"),
        case("D46 G17", "G17", 3, "stop 6:1 G17 is not supported: planes XY and YZ"),
        case("D46 G7.1", "G7.1 C20.", 3, "stop 6:1 G7.1 is not supported: polar and cylindrical interpolation"),
        case("D46 C", "G0 C90.", 3, "stop 6:4 rodete does not follow letter C of the dialect fanuc-lathe-a"),
        case("D46 G65", "G65 P5", 3, "stop 6:1 G65 is not supported: macros"),
        case("D46 #", "#1=5", 3, "stop 6:1 rodete does not follow macros (#, IF, WHILE, GOTO)"),
        case("D46 X#", "G0 X#1", 3, "stop 6:5 rodete does not follow macros (#, IF, WHILE, GOTO)"),
        case("D46 IF", "IF [#1 GT 2] GOTO 10", 3, "stop 6:1 rodete does not follow macros (#, IF, WHILE, GOTO)"),
        case(
            "D46 while",
            "WHILE [1 EQ 1] DO 1|END 1",
            3,
            "stop 7:1 rodete does not follow macros (#, IF, WHILE, GOTO)",
        ),
        case("D35 G92", "G92 X40.", 3, "stop 6:1 Z missing in G92, which here is a turning cycle"),
        case(
            "a milling program",
            "G0 X10. Y5.",
            3,
            "stop 6:9 rodete does not follow letter Y of the dialect fanuc-lathe-a",
        ),
        case("D34 units", "G20|G0 X2.1", 0, "caution 6:1 the units change in the middle of the program"),
        case(
            "grooving in one block",
            "G75 X40. I0.5 F0.1",
            3,
            "stop 6:10 G75 with I: the cycle is written in one block",
        ),
        case(
            "drilling in one block",
            "G74 Z-9. K2. F0.1",
            3,
            "stop 6:10 G74 with K: the cycle is written in one block",
        ),
        case("taper with I", "G92 X50. Z-20. I-1. F2.", 3, "stop 6:16 G92 with I: other controls write the taper so"),
        case("taper with K", "G94 X40. Z-2. K-1. F.1", 3, "stop 6:15 G94 with K: other controls write the taper so"),
        case(
            "thread at once",
            "G97 S500|G76 P020060 Q50 R.05|G76 X47. Z-9. P1000 Q3000 F1.5",
            0,
            "caution 8:21 G76 cuts the thread in one pass: the first one goes in by 3 mm, and the height is 1 mm",
        ),
        case("zero where it stands", "G50 X40. Z2.", 0, "caution file the program gives coordinates to the place"),
    ]);
}

#[test]
fn a_program_in_inches_or_without_a_unit_is_told_wherever_a_lathe_reads_it() {
    let head = HEAD.join("\n");
    let tail = TAIL.join("\n");
    for (unit, told) in [("G21", None), ("G20", Some("L0236")), ("", Some("G0534"))] {
        let text = format!("{unit}\n{head}\nG1 X49. F.1\n{tail}\n");
        let (document, _) = simulate(&text, &[], &["--decimal-point", "calculator"]);
        let codes: Vec<&str> =
            document["findings"].as_array().unwrap().iter().filter_map(|one| one["code"].as_str()).collect();
        for code in ["L0236", "G0534"] {
            assert_eq!(codes.contains(&code), told == Some(code), "{unit} {codes:?}");
        }
    }
}

#[test]
fn tools_and_offsets_that_do_not_fit_are_told() {
    fanuc(&[
        case("D36 T9", "T0909", 3, "stop 6:1 tool 9 is not in the tool table"),
        case("D36 T0", "T0000|G1 X40. F0.1", 3, "stop 7 181 There is no tool in place 0 of the turret"),
        case("D36 offset", "T0177", 3, "stop 6:1 offset 77 is not in the tool table"),
        case("D36 negative", "T-1", 3, "stop 6:2 negative T: -1"),
        case("D36 fraction", "T1.5", 3, "stop 6:1 T1.5 has a decimal point, which T does not allow"),
        case("D36 none", "T0100|G1 X48. F0.1", 0, "caution 7 183 Cutting motion without a tool offset"),
        case("D36 other", "T0102|G1 X51. F0.1", 0, "caution 7 183 The offset in force is not the tool's own"),
        case("D37 arc", "G42 G2 X50. Z0. R5. F0.1", 3, "stop 6 G41 or G42 begins on an arc"),
        case(
            "D37 arc too small",
            "G42 G0 X36.|G1 Z-10. F0.1|G2 X36.6 Z-10.3 R0.3|G1 X54.|G40 G0 X60.",
            3,
            "stop 8 nose radius 0.8 mm does not fit into the arc of radius 0.3 mm",
        ),
        case(
            "D37 corner too small",
            "G42 G0 X50.|G1 Z-10. F0.1|X49.|Z-10.5|X50.|Z-20.|X54.|G40 G0 X60.",
            3,
            "stop 9 nose radius 0.8 mm does not fit: the element is 0.5 mm long and the corners at its ends need 1.6 mm",
        ),
    ]);
}

#[test]
fn an_offset_is_told_of_once_and_the_tools_own_never() {
    let text = [&HEAD[..], &["G1 X53. F0.1", "T0102", "G1 X51.", "X52.", "T0101", "X53.", "T0102", "X54."], &TAIL[..]];
    let (document, _) = simulate(&text.concat().join("\n"), &[], &["--dialect", "fanuc-lathe-a"]);
    let found: Vec<_> = lines(&document).into_iter().filter(|line| line.contains(" 183 ")).collect();
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].starts_with("caution 8 183"), "{found:?}");
}

#[test]
fn what_may_follow_from_another_offset_is_counted_with_it_and_not_told_one_by_one() {
    let followed = |tool: &str| {
        let cuts: String = (0..60).map(|cut| format!("G0 X48. Z-{cut}.\nG0 X53.\n")).collect();
        let text = format!("{}\n{tool}\n{cuts}G1 X52. F0.1\n{}", HEAD.join("\n"), TAIL.join("\n"));
        let (document, exit) = simulate(&text, &[], &["--dialect", "fanuc-lathe-a"]);
        assert_eq!(exit, 3, "{tool}: what is left out is as grave as before");
        bilingual(&document);
        let rapid = document["alarms"].as_array().unwrap().iter().filter(|alarm| alarm["number"] == 101).count();
        assert_eq!(rapid, 59, "{tool}: the list of alarms has them all");
        lines(&document)
    };
    let own = followed("T0101");
    assert!(own.iter().any(|line| line.contains(" 101 ")) && !own.iter().any(|line| line.contains(" 183 ")), "{own:?}");
    let other = followed("T0102");
    assert!(!other.iter().any(|line| line.contains(" 101 ")), "{other:?}");
    assert!(other[0].starts_with("stop 127 183 The offset in force is not the tool's own"), "{other:?}");
    assert!(
        other[0].ends_with("; 59 more alarms with this offset may follow from this and are not listed here"),
        "{other:?}"
    );
    // Without any, 60 mm too deep, the cut lies beyond the axis, where the spindle would have to turn the other way.
    let none = program("G0 X60. Z5.|T0100|G1 X46. Z2. F.2|Z-20.");
    let (_folder, document, exit) = build(&Book::new(&none).bytes());
    let told = lines(&document);
    assert!(exit == 3 && told.iter().any(|line| line.contains(" 183 ")), "{told:?}");
    assert!(!told.iter().any(|line| line.contains(" 154 ")), "{told:?}");
}

#[test]
fn a_spindle_that_stands_still_or_runs_away_is_told() {
    fanuc(&[
        case("D39 G95 in air", "M5|G1 X51. F0.1", 3, "stop 7 155 Feed per revolution with the spindle stopped"),
        case("D39 G95 in metal", "M5|G1 X49. Z-5. F0.1", 3, "stop 7 153 Cutting with the spindle stopped"),
        case("D39 G96 no S", "G96|G1 X53. F0.1", 3, "caution 6:1 G96 without S"),
        case("D39 G96 S0", "G96 S0|G1 X53. F0.1", 3, "stop 7 155 Feed per revolution with the spindle stopped"),
        case("no feed", "G1 X53.", 3, "stop 6 171 Cutting motion with a feed of 0"),
    ]);
    // Without the limit in the head.
    compare(
        "fanuc-lathe-a",
        &["T0101", "M8", "G0 X54. Z0."],
        &TAIL,
        &[
            case(
                "D39 G96",
                "G96 S200 M3|G1 X-1.6 F0.1|G0 Z2.",
                0,
                "caution 4:1 constant surface speed without a speed limit",
            ),
            case(
                "D39 G96",
                "G96 S200 M3|G1 X-1.6 F0.1|G0 Z2.",
                0,
                "caution 5 151 Constant surface speed without a speed limit",
            ),
        ],
    );
}

#[test]
fn a_stopped_spindle_is_one_alarm_until_it_turns_again() {
    let blocks = ["M5", "G1 X53. F0.1", "X52.", "M3", "X51.", "M5", "X52."];
    let text = [&HEAD[..], &blocks, &TAIL[..]].concat().join("\n");
    let (document, _) = simulate(&text, &[], &["--dialect", "fanuc-lathe-a"]);
    let stops: Vec<_> = lines(&document).into_iter().filter(|line| line.contains(" 155 ")).collect();
    let places: Vec<_> = stops.iter().map(|line| line.split(' ').nth(1).unwrap()).collect();
    assert_eq!(places, ["7", "12"], "{stops:?}");
}

#[test]
fn radius_and_diameter_cannot_be_mixed_unseen() {
    fanuc(&[
        case("D40 X and U", "G0 X40. U-1.", 3, "stop 6:4:9 X and U in one block: both move axis X"),
        case("D40 Z and W", "G0 Z1. W1.", 3, "stop 6:4:8 Z and W in one block: both move axis Z"),
        case("D40 negative", "G0 X-20. Z5.", 0, "caution 6:4 negative X: the programmed point is beyond the axis"),
        case(
            "D40 facing",
            "G0 Z0.|G1 X-1.6 F0.1|G0 Z2.",
            0,
            "note 7:4 negative X: the programmed point is beyond the axis",
        ),
    ]);
}

#[test]
fn a_roughing_cycle_is_checked_before_it_is_made() {
    const CONTOUR: &str = "N10 G0 X20.|N20 G1 Z-20. F0.1";
    let rough = |first: &str, second: &str, contour: &str| -> &'static str {
        Box::leak(format!("G71 {first}|G71 {second} U0.5 W0.1 F0.2|{contour}").into_boxed_str())
    };
    let with = |row, depth, ends, contour, exit, found| case(row, rough(depth, ends, contour), exit, found);
    fanuc(&[
        with("D42 no P", "U2. R0.5", "Q20", CONTOUR, 3, "stop 7:1 PS0061: P is missing in G71: the number of a block"),
        with("D42 no Q", "U2. R0.5", "P10", CONTOUR, 3, "stop 7:1 PS0061: Q is missing in G71: the number of a block"),
        with("D42 order", "U2. R0.5", "P20 Q10", CONTOUR, 3, "stop 7:9:5 PS0063: G71: N10 comes before N20"),
        with("D42 no block", "U2. R0.5", "P10 Q30", CONTOUR, 3, "stop 7:9 PS0063: there is no block N30"),
        with("D42 depth 0", "U0. R0.5", "P10 Q20", CONTOUR, 3, "stop 7:1 PS0062: the depth of cut is zero or negative"),
        with("D42 depth below 0", "U-1. R0.5", "P10 Q20", CONTOUR, 3, "stop 7:1 PS0062: the depth of cut is zero"),
        with(
            "D42 endless",
            "U0.001 R0.5",
            "P10 Q20",
            CONTOUR,
            7,
            "stop 7:1 the cycle asks for 17000 passes; the limit is 10000",
        ),
        with(
            "D42 forth and back in Z",
            "U2. R0.5",
            "P10 Q20",
            "N10 G0 X20.|G1 Z-20. F0.1|X30. Z-10.|N20 Z-30.",
            3,
            "stop 10 PS0064: the contour reverses along Z",
        ),
        with(
            "D42 forth and back in X",
            "U2. R0.5",
            "P10 Q20",
            "N10 G0 X20.|G1 Z-20. F0.1|X30. Z-25.|X26. Z-30.|N20 Z-40.",
            3,
            "stop 11 PS0329: the contour reverses along X",
        ),
        with(
            "D42 first block",
            "U2. R0.5",
            "P10 Q20",
            "N10 G2 X20. R40.|N20 G1 Z-20. F0.1",
            3,
            "stop 8 PS0065: the first motion of the contour of G71 has neither G0 nor G1",
        ),
        with(
            "D42 tool",
            "U2. R0.5",
            "P10 Q20",
            "N10 G0 X20.|T0202|N20 G1 Z-20. F0.1",
            3,
            "stop 9:1 rodete does not follow a tool change inside the contour of G71",
        ),
        with(
            "D42 beyond the start",
            "U2. R0.5",
            "P10 Q20",
            "N10 G0 X20.|G1 Z-20. F0.1|N20 X60.",
            3,
            "stop 10 PS0322: the contour reaches beyond the starting point",
        ),
        case(
            "D42 one block",
            "G71 P10 Q20 U0.5 W0.1 F0.2|N10 G0 X20.|N20 G1 Z-20.",
            3,
            "stop 6:1 the first block of G71",
        ),
    ]);
}

#[test]
fn a_refused_cycle_is_one_fault_and_nothing_after_it_is_made() {
    const BACK: &str = "N10 G0 X20.|G1 Z-20. F0.1|X30. Z-10.|N20 Z-30.";
    const TOOL: &str = "N10 G0 X20.|T0202|N20 G1 Z-20. F0.1";
    // What would meet metal that the cycle has left: the contour's own blocks, its finish, a rapid motion, a groove.
    const AFTER: &str = "G70 P10 Q20|G0 X54.|Z-10.|X30.|X54.";
    for (cycle, contour, found) in [
        ("G71 U2. R0.5|G71 P10 Q20 U0.5 F0.2", BACK, "stop 10 PS0064"),
        ("G72 W2. R0.5|G72 P10 Q20 U0.5 F0.2", "N10 G0 Z-20.|G1 X30. F0.1|X40.|N20 X20. Z2.", "stop 10 PS0329"),
        (
            "G71 U2. R0.5|G71 P10 Q20 U0.5 F0.2",
            TOOL,
            "stop 9:1 rodete does not follow a tool change inside the contour of G71",
        ),
        ("G73 U8. W2. R0|G73 P10 Q20 U0.5 F0.2", BACK, "stop 7:1 PS0321"),
        ("G71 R0.5|G71 P10 Q20 U0.5 F0.2", BACK, "stop 7:1 U is missing"),
        ("G71 U0. R0.5|G71 P10 Q20 U0.5 F0.2", BACK, "stop 7:1 PS0062"),
    ] {
        for (more, others) in [("", 0), ("|G5 X1.", 1)] {
            let blocks = format!("{cycle}|{contour}|{AFTER}{more}");
            let text = HEAD.into_iter().chain(blocks.split('|')).chain(TAIL).collect::<Vec<_>>().join("\n");
            let (document, exit) =
                simulate(&text, &[], &["--dialect", "fanuc-lathe-a", "--decimal-point", "calculator"]);
            let lines: Vec<_> = lines(&document).into_iter().filter(|line| !line.starts_with("note")).collect();
            assert_eq!((exit, lines.len()), (3, 1 + others), "{cycle} {lines:?}");
            assert!(lines.iter().any(|line| line.starts_with(found)), "{found} {lines:?}");
            // The one to the bar.
            assert_eq!(document["motions"], 1, "{cycle}");
        }
    }
}

#[test]
fn the_contour_of_a_refused_cycle_is_no_way_of_the_tool() {
    let text = "G0 X54. Z2.\nG71 U2. R0.5\nG71 P10 Q20 U0.5 F0.2\nN10 G0 X20.\nG1 Z-20. F0.1\nX30. Z-10.\nN20 Z-30.\n\
        G70 P10 Q20\nG0 X60.\nM30\n";
    let setting = Setting { decimal_point: Some(DecimalPoint::Calculator), ..Setting::new(&FANUC_LATHE_A) };
    let read: Vec<_> = Interpreter::over(text.as_bytes(), setting).collect();
    let motions: Vec<_> = read.iter().filter_map(|item| item.as_ref().ok()).map(|motion| motion.line).collect();
    let faults: Vec<_> =
        read.iter().filter_map(|item| item.as_ref().err()).map(|fault| (fault.line, fault.uncut)).collect();
    assert_eq!((motions, faults), (vec![1, 9], vec![(6, true)]));
}

#[test]
fn a_threading_cycle_is_checked_before_it_is_made() {
    fanuc(&[
        case(
            "D43 lead 0",
            "T0404|G76 P020060 Q100 R0.05|G76 X20. Z-20. P1200 Q300 F0.",
            3,
            "stop 8:27 thread with lead 0",
        ),
        case(
            "D43 no lead",
            "T0404|G76 P020060 Q100 R0.05|G76 X20. Z-20. P1200 Q300",
            3,
            "stop 8 thread without its lead F",
        ),
        case(
            "D43 height 0",
            "T0404|G76 P020060 Q100 R0.05|G76 X20. Z-20. P0 Q300 F2.",
            3,
            "stop 8:1 PS0317: the height",
        ),
        case(
            "D43 no height",
            "T0404|G76 P020060 Q100 R0.05|G76 X20. Z-20. Q300 F2.",
            3,
            "stop 8:1 P is missing in the",
        ),
        case("D43 no cut", "T0404|G76 P020060 Q100 R0.05|G76 X20. Z-20. P1200 F2.", 3, "stop 8:1 Q is missing in the"),
        case(
            "D43 angle",
            "T0404|G76 P020061 Q100 R0.05|G76 X20. Z-20. P1200 Q300 F2.",
            3,
            "stop 8:1 PS0315: tip angle",
        ),
        case(
            "D43 endless",
            "T0404|G76 P020060 Q0 R0.|G76 X20. Z-20. P12000 Q1 F2.",
            7,
            "stop 8:1 the cycle asks for 144000000 passes; the limit is 10000",
        ),
        case("D43 G92", "T0404|G92 X48. Z-20. F0.", 3, "stop 7:16 thread with lead 0"),
        case("D43 G32", "T0404|G32 Z-20.", 3, "stop 7 thread without its lead F"),
    ]);
}

#[test]
fn what_the_tool_runs_into_is_told() {
    fanuc(&[
        case("D44 rapid", "G0 X40. Z-10.|G0 X54.", 3, "stop 6 101 Rapid motion through metal"),
        case("D44 chuck", "G0 X54. Z-180.", 3, "stop 6 111 The insert or drill hits the chuck"),
    ]);
}

#[test]
fn bare_numbers_are_read_by_the_rule_and_refused_without_one() {
    let text = [&HEAD[..], &["G0 X52", "G1 Z-10000 F0.1", "G0 Z2."], &TAIL[..]].concat().join("\n");
    let with = |more: &[&str]| simulate(&text, &[], &[&["--dialect", "fanuc-lathe-a"], more].concat());
    let (document, exit) = with(&[]);
    assert_eq!(exit, 3);
    for wanted in [
        "stop 6:4 X52 has no decimal point: the control reads it as mm or µm, depending on its setting",
        "stop 7:4 Z-10000 has no decimal point: the control reads it as mm or µm, depending on its setting",
    ] {
        assert!(lines(&document).contains(&wanted.to_owned()), "{:?}", lines(&document));
    }
    assert!(document["findings"][0]["remedy"]["en"].as_str().unwrap().contains("--decimal-point"));
    bilingual(&document);
    for (rule, wanted, z) in [
        ("calculator", "note 6:4 dimensions without decimal point, read as mm", "Z-10000"),
        ("micrometre", "note 6:4 dimensions without decimal point, read as least increments (0.001 mm)", "Z-10"),
    ] {
        let (document, _) = with(&["--decimal-point", rule]);
        let notes = document["findings"].as_array().unwrap();
        let note = notes.iter().find(|one| super::bench::line(one) == wanted).unwrap_or_else(|| panic!("{document}"));
        assert_eq!(note["value"], "2 ×", "{rule} {z}");
    }
    // X52 of a diameter is 0.052 mm by the one rule: the tool is at the axis and the bar is in its way.
    assert!(lines(&with(&["--decimal-point", "micrometre"]).0).iter().any(|line| line.contains("stop 7 ")));
    // A program whose every dimension has its point needs no rule.
    let pointed = [&HEAD[..], &["G0 X52."], &TAIL[..]].concat().join("\n");
    assert_eq!(simulate(&pointed, &[], &["--dialect", "fanuc-lathe-a"]).1, 0);
}

#[test]
fn a_fagor_program_is_refused_in_the_same_way() {
    compare(
        "fagor-8055-t",
        &FAGOR,
        &["N99 M30"],
        &[
            case(
                "D46 statement",
                "(IF P1 EQ 2 GOTO N10)",
                3,
                "stop 6:1 rodete does not run statements of Fagor's high-level language",
            ),
            case(
                "D45 message",
                "(MSG \"HELLO\")",
                3,
                "stop 6:1 rodete does not run statements of Fagor's high-level language",
            ),
            case("D36 T9", "N10 T9 D9", 3, "stop 6:5 tool 9 is not in the tool table"),
            case("D36 D2", "N10 D2|N20 G1 X53 F0.1", 0, "caution 7 183 The offset in force is not the tool's own"),
            case("D37 arc", "N10 G42 G2 X50 Z0 R5 F0.1", 3, "stop 6 G41 or G42 begins on an arc"),
            case("D42 step 0", "N10 G81 X40 Z0 Q40 R-30 C0 D1 L0 M0", 3, "stop 6:5 the step C is not above 0"),
            case("D42 no step", "N10 G81 X40 Z0 Q40 R-30 D1 L0 M0", 3, "stop 6:5 C is missing in G81"),
            case("D43 lead 0", "N10 G86 X40 Z0 Q40 R-30 I2 B0.5 D1 L1 C0", 3, "stop 6:5 the thread has lead 0"),
            case("D46 G37", "N10 G37 R5", 3, "stop 6:5 G37 is not supported: geometric aids"),
            case(
                "D40 negative",
                "N10 X-60|N20 X60",
                0,
                "caution 6:5 negative X: the programmed point is beyond the axis",
            ),
        ],
    );
}

#[test]
fn what_is_no_program_is_refused() {
    for (text, found) in [
        ("", "stop 1 no program: the file has no blocks"),
        ("%\n%\n", "stop 2 no program: the file has no blocks"),
        ("(only words)\n", "stop 1 no program: the file has no blocks"),
        ("\u{1}\u{2}\u{3}\n", "stop 1:1 "),
        ("<html>\n", "stop 1:1 character '<' is not allowed"),
    ] {
        let (document, exit) = simulate(text, &[], &["--dialect", "fanuc-lathe-a"]);
        assert_eq!(exit, 3, "{text:?}");
        assert!(lines(&document).iter().any(|line| line.starts_with(found)), "{text:?} {:?}", lines(&document));
        bilingual(&document);
    }
    // The control runs it, and stops at its end.
    let (document, exit) = simulate("G0 X50.\n", &[], &["--dialect", "fanuc-lathe-a"]);
    let found = lines(&document);
    assert!(
        exit == 0 && found.iter().any(|line| line.contains("the program ends without M2 or M30: rodete takes")),
        "{found:?}"
    );
}

#[test]
fn a_long_program_is_followed_to_its_end() {
    let passes: Vec<String> = (0..25_000_u32)
        .flat_map(|at| {
            [format!("G0 X{:.4}", 50.0 - f64::from(at) * 0.0004), "G1 Z-50. F0.2".into(), "U1.".into(), "G0 Z2.".into()]
        })
        .collect();
    let text = format!("{}\n{}\n{}\n", HEAD.join("\n"), passes.join("\n"), TAIL.join("\n"));
    assert!(text.lines().count() > 100_000);
    let (document, exit) = simulate(&text, &[], &["--dialect", "fanuc-lathe-a"]);
    assert_eq!(exit, 0, "{:?}", lines(&document));
    // To 40.0004 mm along 50 mm, less what the nose leaves in the corner.
    let removed = document["totals"]["removed_volume_mm3"].as_f64().unwrap();
    let ring = std::f64::consts::PI / 4.0 * (2500.0 - 40.0004 * 40.0004) * 50.0;
    assert!(removed < ring && removed > ring - 100.0, "{removed} {ring}");
    assert_eq!(document["motions"], 100_002);
}

#[test]
fn a_place_takes_another_offset_than_its_own_number() {
    let blocks = |tool: &str| {
        program("G0 X46.|G1 Z-20. F0.2|U8.").iter().map(|line| line.replace("T0101", tool)).collect::<Vec<_>>()
    };
    let book = Book::new(&blocks("T0111")).change("tools", |rows| {
        rows[0].values.insert("tools/D", Value::Whole(11));
    });
    let (_folder, document, exit) = build(&book.bytes());
    assert_eq!(exit, 0, "{:?}", lines(&document));
    let (_folder, document, exit) = build(
        &Book::new(&blocks("T0911"))
            .change("tools", |rows| {
                rows[0].values.insert("tools/D", Value::Whole(11));
            })
            .bytes(),
    );
    assert_eq!(exit, 3);
    assert!(
        lines(&document).iter().any(|line| line.contains("tool 9 is not in the tool table")),
        "{:?}",
        lines(&document)
    );
}

#[test]
fn a_part_of_which_nothing_is_left_is_refused_with_its_files() {
    let folder = tempfile::tempdir().unwrap();
    let text = "O1\nG50 S2500\nT0505\nG97 S600 M3\nM8\nG0 X0. Z3.\nG1 Z-14. F0.1\nG0 Z5.\nM30\n";
    std::fs::write(folder.path().join("p.nc"), text).unwrap();
    let dialect = ["--dialect", "fanuc-lathe-a", "--decimal-point", "calculator"];
    let arguments = [&["simulate", "p.nc", "--stock", "D8xL10", "-o", "out"][..], &dialect].concat();
    let said = run(folder.path(), &arguments);
    assert_eq!(said.exit, 3, "{}", said.err);
    assert!(folder.path().join("out/p-results.xlsx").exists());
    assert!(!folder.path().join("out/p-contour.dxf").exists());
}
