//! What a shop would see in a turning program before it runs: each slip with its figures, and its near twin in silence.

use std::fs;
use std::process::Command;

use rodete::parameter::Value;
use rodete::text::Language;
use serde_json::Value as Json;

use super::bench::{Book, bilingual, build, line, program};

/// The stops and cautions of a program, each with its value and limit, and the exit code.
fn told(book: &Book) -> (Vec<String>, i32) {
    let (_folder, document, exit) = build(&book.bytes());
    bilingual(&document);
    let text = |one: &Json, key: &str| one[key].as_str().unwrap_or_default().to_owned();
    let findings = document["findings"].as_array().unwrap().iter().filter(|one| one["grade"] != "note");
    let shown = |one: &Json| format!("{} [{}] [{}]", line(one), text(one, "value"), text(one, "limit"));
    (findings.map(shown).collect(), exit)
}

fn of(blocks: &str) -> (Vec<String>, i32) {
    told(&Book::new(&program(blocks)))
}

fn none() -> (Vec<String>, i32) {
    (Vec::new(), 0)
}

fn only(finding: &str, exit: i32) -> (Vec<String>, i32) {
    (vec![finding.to_owned()], exit)
}

#[test]
fn a_change_of_tool_over_the_stock_or_in_it_is_a_stop_at_its_block() {
    let wanted = "stop PROGRAM!A13 184 The turret indexes to place 2 inside the work, inside the clamping or over the stock, X60 Z-20 [] []";
    assert_eq!(of("G0 X60.|Z-20.|T0202|G0 X100. Z50."), only(wanted, 3));
    // To the right of the face, and farther off than any tool needs.
    assert_eq!(of("G0 X60.|Z2.|T0202|G0 X100. Z50."), none());
    // The drill of 120 mm, in a tool change near the face, would stand in the chuck.
    let (found, exit) = of("G0 X54.|Z-60.|X60.|T0505|G0 X100.|Z50.");
    assert!(exit == 3 && found[0].contains(" 184 The turret indexes to place 5 inside the work"), "{found:?}");
}

#[test]
fn a_feed_is_held_against_the_nose_of_0_8_mm() {
    assert_eq!(of("X46.|G1 Z-20. F.64|X54.|G0 Z2."), none());
    let wanted = "caution PROGRAM!A12 173 The feed per revolution is too large for the nose radius: it leaves ridges, X46 Z0 [0.65 mm] [≤ 0.64 mm]";
    assert_eq!(of("X46.|G1 Z-20. F.65|X54.|G0 Z2."), only(wanted, 0));
    // 585 mm/min at 900 rpm.
    assert_eq!(of("X46.|G98 G1 Z-20. F585.|X54.|G0 Z2."), only(wanted, 0));
}

#[test]
fn the_nose_is_kept_off_the_work() {
    let pass = |code: &str| format!("{code} G0 X44.|G1 Z-20. F.2|G40 X54.|G0 Z2.");
    assert_eq!(of(&pass("G42")), none());
    let (found, exit) = of(&pass("G41"));
    let wanted = "185 G41 puts the nose on the wrong side, in the work, ";
    assert!(exit == 0 && found.len() == 1 && found[0].contains(wanted), "{found:?}");
}

#[test]
fn a_thread_has_its_run_in_and_no_more_depth_than_its_lead() {
    let thread = |start: &str, root: &str| {
        format!(
            "X40.|G1 Z-30. F.2|X54.|G0 X100. Z50.|T0404|G97 S900 M3|M8|G0 X54. Z{start}|X{root}|G32 Z-15. F1.5|G0 X54.|Z50."
        )
    };
    // They are cut in one pass, which is told beside what is asked here.
    let of = |program: &str| {
        let (found, exit) = of(program);
        let (deep, found): (Vec<_>, Vec<_>) = found.into_iter().partition(|one| one.contains(" 149 "));
        assert_eq!(deep.len(), 1, "{deep:?}");
        (found, exit)
    };
    assert_eq!(of(&thread("5.", "38.2")), none());
    // 3.2 · 1.5 · 900 / 1800 = 2.4 mm.
    let (found, exit) = of(&thread("1.", "38.2"));
    assert!(exit == 0 && found.len() == 1, "{found:?}");
    assert!(
        found[0].contains(" 147 The thread's run-in is shorter than the control needs")
            && found[0].ends_with("[≥ 2.4 mm]"),
        "{found:?}"
    );
    // 1.5 / (2 tan 30°) − 0.1 (1/sin 30° − 1) = 1.199 mm.
    let (found, exit) = of(&thread("5.", "37.5"));
    assert!(exit == 0 && found.len() == 1, "{found:?}");
    assert!(
        found[0].contains(" 146 The thread is deeper than its lead allows")
            && found[0].ends_with("[1.25 mm] [≤ 1.199 mm]"),
        "{found:?}"
    );
}

#[test]
fn a_boring_bar_needs_a_hole() {
    let bore = |x: &str, drilled: &str| {
        let lines = format!(
            "G50 S2500|T0505|G97 S900 M3|M8|G0 X0. Z3.|{drilled}G0 Z50.|X100.|T0606|G0 X{x} Z2.|G1 Z-12. F.1|G0 Z2.|X100. Z50.|M30"
        );
        let lines: Vec<String> = lines.split('|').map(str::to_owned).collect();
        told(&Book::of(Language::En).put("L5", Value::Real(0.0)).program(&lines))
    };
    let drilled = "G1 Z-25. F.1|";
    assert_eq!(bore("20.", drilled), none());
    let (found, exit) = bore("20.", "");
    let wanted = "stop PROGRAM!A15 105 The boring bar feeds into solid metal, where there is no hole, X";
    assert!(exit == 3 && found[0].starts_with(wanted) && found[0].contains(" [Ø 0 mm] [≥ Ø "), "{found:?}");
    // So is it where the edge reaches over the axis, and the bar touches nothing.
    let (found, exit) = bore("11.", "");
    assert!(exit == 3 && found.len() == 1 && found[0].starts_with(wanted), "{found:?}");
    assert!(found[0].ends_with(" [Ø 0 mm] [≥ Ø 7.5 mm]"), "{found:?}");
    let (found, exit) = bore("26.", drilled);
    let wanted = "stop PROGRAM!A16 105 The boring bar feeds into a hole that is too narrow for it, X";
    assert!(exit == 3 && found[0].starts_with(wanted) && found[0].contains(" [Ø 10 mm] [≥ Ø "), "{found:?}");
}

#[test]
fn the_reference_point_is_where_the_workbook_says() {
    let home = program("G53 G0 X0. Z0.|G28 U0. W0.");
    let given = |X: f64, Z: f64| {
        Book::new(&home)
            .put("R_X", Value::Real(X))
            .put("R_Z", Value::Real(Z))
            .put("X_max", Value::Real(400.0))
            .put("Z_max", Value::Real(500.0))
    };
    assert_eq!(told(&given(400.0, 500.0)), none());
    // Beyond the travel.
    let (found, exit) = told(&given(400.0, 501.0));
    assert!(exit == 3 && found.iter().all(|one| one.contains("121 Axis Z leaves its travel")), "{found:?}");
    // W1 stays where it is: a cut is the same.
    let cut = program("X46.|G1 Z-20. F.2|G0 X54.|Z2.|G28 U0. W0.");
    let volume = |book: &Book| super::bench::quantity(&build(&book.bytes()).1, "V");
    let plain = Book::new(&cut);
    let referred = Book::new(&cut).put("R_X", Value::Real(400.0)).put("R_Z", Value::Real(500.0));
    assert!((volume(&plain) - volume(&referred)).abs() < 1e-6);
    // Nothing given: G53 counts from the face of the spindle, and that is told.
    let (found, exit) = told(&Book::new(&home));
    let wanted = "G53 without a reference point in the workbook: rodete counts from M";
    assert!(exit == 3 && found.iter().any(|one| one.contains(wanted)), "{found:?}");
    let one = Book::new(&cut).put("R_X", Value::Real(400.0));
    let (found, exit) = told(&one);
    assert!(exit == 3 && found[0].contains("the reference point needs R_X and R_Z, and one is missing"), "{found:?}");
}

#[test]
fn r_of_a_hole_is_what_the_workbook_says_and_without_q_nothing_is_cleared() {
    let hole = |words: &str, plane: &'static str| {
        let lines = ["T0505", "G97 S900 M3", "M8", "G0 X0. Z5.", words, "G80", "G0 Z50.", "M30"].map(str::to_owned);
        told(&Book::of(Language::En).put("L5", Value::Real(0.0)).program(&lines).put("hole_R", Value::Choice(plane)))
    };
    assert_eq!(hole("G83 Z-20. R-4. Q5000 F.1", "incremental"), none());
    assert_eq!(hole("G83 Z-20. R1. Q5000 F.1", "absolute"), none());
    let (found, exit) = hole("G83 Z-20. R-4. Q5000 F.1", "absolute");
    assert!(exit == 3 && found.iter().any(|one| one.contains("101 Rapid motion through metal")), "{found:?}");
    let wanted = "caution PROGRAM!A10 G83 without Q drills 21 mm in one go, without clearing the chips [] []";
    assert_eq!(hole("G83 Z-20. R1. F.1", "absolute"), only(wanted, 0));
}

#[test]
fn a_blank_line_before_a_contour_is_no_block_left_out() {
    let folder = tempfile::tempdir().unwrap();
    let text = "T0101\nG97 S900 M3\nM8\nG0 X54. Z2.\nG71 U2. R1.\nG71 P10 Q20 U.5 F.2\n\n(contour)\nN10 G0 X40.\n\nG1 Z-20.\nN20 X54.\nG70 P10 Q20\nG0 X100. Z50.\nM30\n";
    std::fs::write(folder.path().join("p.nc"), text).unwrap();
    let bar = ["--dialect", "fanuc-lathe-a", "--stock", "D50xL100", "--decimal-point", "calculator"];
    let said = super::bench::run(folder.path(), &[&["simulate", "p.nc"], &bar[..]].concat());
    assert_eq!((said.err.as_str(), said.exit), ("", 0));
}

#[test]
fn verify_takes_the_reference_point_from_the_workbook_and_else_assumes_it_as_build_does() {
    let folder = tempfile::tempdir().unwrap();
    let [path, beside] = ["p.nc", "tools.xlsx"].map(|name| folder.path().join(name));
    fs::write(&path, "G21 G40 G97 G99\nT0202 S900 M3\nG0 X30. Z2.\nG28 U0. W0.\nM30\n").unwrap();
    let verified = |book: &Book| {
        fs::write(&beside, book.bytes()).unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_rodete"));
        let output =
            command.args(["verify", "--json", "--decimal-point", "calculator"]).arg(&path).arg("--tools").arg(&beside);
        let document: Json = serde_json::from_slice(&output.output().unwrap().stdout).unwrap();
        document["programs"][0].clone()
    };
    let finding = |program: &Json| {
        let findings = program["findings"].as_array().unwrap();
        findings.iter().find(|one| one["code"] == "G0806").map(|one| one["remedy"]["en"].as_str().unwrap().to_owned())
    };
    let plain = program("G28 U0. W0.");
    let referred = verified(&Book::new(&plain).put("R_X", Value::Real(400.0)).put("R_Z", Value::Real(500.0)));
    assert_eq!((&referred["dialect"], finding(&referred)), (&Json::from("fanuc-lathe-a"), None));
    let grave = referred["findings"].as_array().unwrap().iter().any(|one| one["grade"] != "note");
    assert!(!grave, "{}", referred["findings"]);
    // The control counts from there.
    for axis in ["X", "Z"] {
        assert!(referred["end"]["machine"][axis].as_f64().unwrap().abs() < 1e-9, "{referred}");
    }
    assert!(referred["end"]["program"]["Z"].as_f64().unwrap() > 100.0, "{referred}");
    // With the cells empty it is assumed, and told, as when the workbook is built.
    let code = |findings: &Json, code: &str| {
        findings
            .as_array()
            .unwrap()
            .iter()
            .find(|one| one["code"] == code)
            .map(|one| [&one["grade"], &one["what"]].map(Json::clone))
    };
    let read = verified(&Book::new(&plain));
    assert_eq!(finding(&read), None);
    let (_folder, built, _) = super::bench::build(&Book::new(&plain).bytes());
    let told = code(&read["findings"], "L0211");
    assert!(told.is_some(), "{}", read["findings"]);
    assert_eq!(told, code(&built["findings"], "L0211"), "{built}");
    // Program and machine lie apart by W1 and the tool's offset: 60 mm on the radius and 40 mm along Z.
    let end = |pose: &str| ["X", "Z"].map(|axis| read["end"][pose][axis].as_f64().unwrap());
    let zero = super::bench::quantity(&built, "Z_W1");
    let (machine, program) = (end("machine"), end("program"));
    let apart = [0, 1].map(|axis| machine[axis] - program[axis]);
    assert!((apart[0] - 120.0).abs() < 1e-9 && (apart[1] - zero - 40.0).abs() < 1e-9, "{read}");
    // Beyond the surface and the end of the bar, not behind the axis.
    assert!(program[0] > 50.0 && program[1] > 0.0, "{read}");
    assert!(read["extents"]["program"]["X"][0].as_f64().unwrap() >= 0.0, "{read}");
    for (blocks, wanted) in [("G53 X400. Z400.", "L0210"), ("G50 X54. Z2.\nG28 U0. W0.", "L0235"), ("G0 X60. Z9.", "")]
    {
        fs::write(&path, format!("G21 G40 G97 G99\nT0202 S900 M3\nG0 X30. Z2.\n{blocks}\nM30\n")).unwrap();
        let read = verified(&Book::new(&plain));
        let found = ["L0210", "L0211", "L0235"].into_iter().filter(|one| code(&read["findings"], one).is_some());
        assert_eq!(found.collect::<String>(), wanted, "{read}");
    }
}

#[test]
fn how_long_the_first_set_up_holds_the_bar_is_judged_as_in_the_second() {
    let cut = program("X46.|G1 Z-20. F.2|X54.|G0 Z2.");
    let held = |L4: f64, L2: f64| Book::new(&cut).put("L4", Value::Real(L4)).put("L2", Value::Real(L2));
    let place = "DATA!C19 DATA!C23 DATA!C25 in the first set-up the jaws hold";
    // The lesser of both counts, and a quarter of long jaws.
    for (L4, L2, long, least) in [(0.0, 40.0, "0", "10"), (0.5, 40.0, "0.5", "10"), (30.0, 0.9, "0.9", "5")] {
        let wanted = format!("stop {place} {long} mm of the bar [{long} mm] [≥ {least} mm]");
        assert_eq!(told(&held(L4, L2)), (vec![wanted], 3), "{L4} {L2}");
    }
    for (L4, L2, long, least) in [(1.0, 40.0, "1", "10"), (9.9, 40.0, "9.9", "10"), (4.9, 8.0, "4.9", "5")] {
        let wanted = format!("caution {place} {long} mm of the bar [{long} mm] [≥ {least} mm]");
        assert_eq!(told(&held(L4, L2)), (vec![wanted], 0), "{L4} {L2}");
    }
    assert_eq!(told(&held(10.0, 40.0)), none());
    // A tailstock keeps the bar from tilting, and does not drive it.
    let (found, _) = told(&held(0.0, 40.0).put("tailstock", Value::Choice("yes")));
    let wanted = format!("caution {place} 0 mm of the bar; the tailstock supports it, but does not drive it");
    assert!(found.iter().any(|one| one.starts_with(&wanted)), "{found:?}");
    // Without jaws it is said what is assumed.
    let (_folder, document, exit) = build(&held(30.0, 0.0).bytes());
    let notes: Vec<String> = document["findings"].as_array().unwrap().iter().map(line).collect();
    assert!(exit == 0 && notes.iter().any(|note| note.contains("there are no jaws (L2 is 0)")), "{notes:?}");
}

#[test]
fn a_travel_that_ends_too_early_is_told_first_and_once_and_makes_no_collision() {
    let cut = program("X46.|G1 Z-20. F.2|X54.|G0 Z2.");
    let (found, exit) = told(&Book::new(&cut).put("Z_max", Value::Real(0.0)));
    assert_eq!((found.len(), exit), (1, 3), "{found:?}");
    let wanted = "121 Axis Z leaves its travel, Z_max = 0 mm, X";
    assert!(found[0].contains(wanted) && found[0].contains("; the limit is in DATA!C30"), "{found:?}");
    assert!(found[0].contains("; it leaves it in ") && found[0].ends_with(" [Z ≤ 0 mm]"), "{found:?}");
    // Both ends of an axis are told apart, and come before what else is wrong.
    let both = Book::new(&program("X46.|G1 Z-95. F.2|G0 X54.|Z2.")).put("Z_max", Value::Real(210.0));
    let (found, _) = told(&both.put("Z_min", Value::Real(200.0)));
    let travel = |one: &String| one.contains(" 121 Axis Z leaves its travel");
    assert!(found.iter().take(2).all(travel) && !found.iter().skip(2).any(travel), "{found:?}");
}

#[test]
fn a_contour_outside_the_bar_is_told_with_its_diameter_and_the_cell_of_the_bar() {
    let bar = |D: f64| {
        let (found, exit) = told(&Book::of(Language::En).put("D", Value::Real(D)));
        assert_eq!(exit, 0, "{D}");
        found.into_iter().filter(|one| one.contains("the contour from")).collect::<Vec<_>>()
    };
    for D in [30.0, 36.0, 43.0] {
        let wanted = format!(
            "caution PROGRAM!A26 the contour from N55 to N100 goes to X48, outside the bar: D is {D} mm (DATA!C16) [48 mm] [≤ {D} mm]"
        );
        assert_eq!(bar(D), [wanted]);
    }
    // The last chamfer leads out of the bar.
    for D in [44.0, 46.0, 48.0, 50.0] {
        assert!(bar(D).is_empty(), "{D}: {:?}", bar(D));
    }
    // Internal turning ends far inside the bar.
    let bore = "G0 X60. Z30.|T0505|G97 S900|G0 X0. Z5.|G1 Z-30. F.1|G0 Z30.|X60.|T0606|G0 X9. Z2.|G71 U1. R.5|G71 P10 Q20 U-.2 W.1 F.1|N10 G0 X20.|G1 Z-5.|X16.|N20 Z-20.|G70 P10 Q20|G0 Z30.";
    let (found, _) = of(bore);
    assert!(!found.iter().any(|one| one.contains("the contour from")), "{found:?}");
}
