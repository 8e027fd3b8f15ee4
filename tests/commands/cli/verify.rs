//! The command `verify`: what it prints for sound programs, what it refuses, how it ends.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use predicates::prelude::*;
use serde_json::Value as Json;
use tempfile::TempDir;

use super::common::{folder, rodete};

fn with_program(name: &str, text: &[u8]) -> TempDir {
    let folder = folder();
    fs::write(folder.path().join(name), text).expect("a program");
    folder
}

fn golden(name: &str) -> TempDir {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden").join(name);
    with_program("program.nc", &fs::read(path).expect("a published program"))
}

/// The JSON document of a program, and the exit code.
fn document(folder: &TempDir, arguments: &[&str]) -> (Json, i32) {
    let output = rodete(folder).arg("verify").args(arguments).arg("--json").output().expect("an output");
    let read: Json = serde_json::from_slice(&output.stdout).expect("a JSON document");
    (read["programs"][0].clone(), output.status.code().expect("an exit code"))
}

/// The first refusal of a program: its line and first column, and what is wrong, in English.
fn refusal(text: &[u8]) -> (u64, u64, String, i32) {
    let folder = with_program("program.ngc", text);
    let (program, exit) = document(&folder, &["program.ngc"]);
    let finding = &program["findings"][0];
    let place = &finding["place"]["line"];
    let column = place["columns"][0].as_u64().unwrap_or(0);
    (place["line"].as_u64().unwrap_or(0), column, finding["what"]["en"].as_str().unwrap_or("").to_owned(), exit)
}

#[test]
fn the_published_blade_program_does_not_come_back() {
    rodete(&golden("annex-09-blade-as-printed.nc"))
        .args(["verify", "program.nc"])
        .assert()
        .code(0)
        .stdout(predicate::str::contains("net travel: X 535.796  Y 0  Z 435.797  B -180  C 343.742"))
        .stderr(predicate::str::contains("caution V0020: the incremental program does not return to where it starts"))
        .stderr(predicate::str::contains("feed move without F"));
}

#[test]
fn the_published_splitter_program_shifts_the_part_by_3_998_mm_in_y() {
    rodete(&golden("annex-10-splitter-as-printed.nc"))
        .args(["verify", "program.nc", "--lang", "es"])
        .assert()
        .code(0)
        .stdout(predicate::str::contains("recorrido neto: X -0.001  Y 3.998  Z 0  B 0  C 90"))
        .stderr(predicate::str::contains("precaución V0020: el programa incremental no vuelve a donde empieza"));
}

#[test]
fn the_published_turning_program_is_followed_through_its_cycle() {
    rodete(&golden("lathe-g85-as-printed.nc"))
        .args(["verify", "program.nc", "--dialect", "fagor-8055-t"])
        .assert()
        .code(0)
        .stdout(predicate::str::contains("8 lines, 66 motions"))
        .stdout(predicate::str::contains("Z  -15 … 80  program"));
}

#[test]
fn a_turning_cycle_that_is_not_followed_is_refused_by_name() {
    rodete(&with_program("program.nc", b"G68 X0 Z0 C5 S20 E30\nM30\n"))
        .args(["verify", "program.nc", "--dialect", "fagor-8055-t"])
        .assert()
        .code(3)
        .stderr(predicate::str::contains("G68 is not supported: turning cycles"));
}

#[test]
fn a_lathe_program_is_followed_with_its_subprogram_and_the_rule_for_numbers_without_a_point() {
    let folder = with_program("part.nc", b"O0001\nS500 M3\nG0 X50 Z5\nM98 P20005\nM30\n");
    fs::write(folder.path().join("O0005.nc"), "O0005\nG0 W-2\nM99\n").expect("a subprogram");
    let lathe = ["part.nc", "--dialect", "fanuc-lathe-a", "--decimal-point"];
    for (rule, z) in [("calculator", [1.0, 5.0]), ("micrometre", [0.0, 0.005])] {
        let (program, exit) = document(&folder, &[&lathe[..], &[rule]].concat());
        assert_eq!(exit, 0, "{rule}");
        assert_eq!(program["motions"], 3);
        let extents = &program["extents"]["program"]["Z"];
        assert!((extents[1].as_f64().expect("a number") - z[1]).abs() < 1e-12, "{rule}: {extents}");
        let end = program["end"]["program"]["Z"].as_f64().expect("a number");
        assert!((end - if rule == "calculator" { z[0] } else { 0.001 }).abs() < 1e-12, "{rule}: {end}");
    }
    // A motion says the file of its block where that is not the program.
    let canon = rodete(&folder).args(["verify", "--canon"]).args(lathe).arg("calculator").output().expect("it runs");
    let canon = String::from_utf8(canon.stdout).expect("text");
    let motions: Vec<Json> = canon.lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
    let places: Vec<_> = motions.iter().map(|motion| (motion["file"].as_str(), motion["line"].as_u64())).collect();
    assert_eq!(places, [(None, Some(3)), (Some("O0005"), Some(2)), (Some("O0005"), Some(2))]);
    rodete(&folder)
        .args(["verify", "part.nc", "--dialect", "fanuc-lathe-a"])
        .assert()
        .code(3)
        .stderr(predicate::str::contains("X50 has no decimal point"))
        .stderr(predicate::str::contains("--decimal-point"));
}

#[test]
fn a_turning_program_marks_the_axes_whose_extents_count_on_where_the_turret_stood() {
    let marks = |dialect: &str, blocks: &str| {
        let program = format!("{}\nM30\n", blocks.replace('|', "\n"));
        let folder = with_program("part.nc", program.as_bytes());
        let (told, exit) = document(&folder, &["part.nc", "--dialect", dialect]);
        assert_eq!(exit, 0, "{blocks}: {told}");
        let axes = |of: &str| {
            told["assumed_start"][of].as_array().unwrap().iter().map(|one| one.as_str().unwrap()).collect::<String>()
        };
        let shown = rodete(&folder).args(["verify", "part.nc", "--dialect", dialect]).output().expect("it runs");
        let shown = String::from_utf8(shown.stdout).expect("text");
        let both = [axes("program"), axes("machine")];
        for axis in ["X", "Z"] {
            let line = shown.lines().find(|line| line.starts_with(&format!("  {axis}  "))).expect("extents");
            let marked = both.iter().any(|axes| axes.contains(axis));
            assert_eq!(line.contains("counts on the assumed starting position"), marked, "{blocks}: {line}");
        }
        both
    };
    let start = "G21 G98 S500 M3 F100.|";
    for (blocks, program, machine) in [
        ("G0 X50. Z5.|X40.|U-2. W-1.", "", ""),
        // One axis first, increments, and feed from where the turret stood.
        ("G0 X50.|Z5.", "Z", "Z"),
        ("G0 U-5. W-5.|X50. Z5.", "XZ", "XZ"),
        ("G0 Z5.|W-3.", "X", "X"),
        ("G1 X50. Z5.", "XZ", ""),
        // The reference point is a place, over a point of its own or not.
        ("G28 U0. W0.|G0 W-10.", "", ""),
        ("G28 U0.|G0 X50. Z5.", "", ""),
        ("G28 U-5.|G28 W0.|G0 X50. Z5.", "XZ", "XZ"),
        // G50 gives the program a place, and the machine none.
        ("G50 X100. Z100.|G0 X50.|Z5.", "", "XZ"),
    ] {
        assert_eq!(marks("fanuc-lathe-a", &format!("{start}{blocks}")), [program, machine], "{blocks}");
    }
    assert_eq!(marks("fagor-8055-t", "G71 G95 F.1 S500 M3|G91 G0 X-5|G90 X50 Z5"), ["XZ", "XZ"]);
    assert_eq!(marks("fagor-8055-t", "G71 G95 F.1 S500 M3|G92 X100 Z100|G0 X50 Z5|G54|G91 G0 X1"), ["XZ", "XZ"]);
    // Of a mill nothing is told.
    let (told, _) = document(&with_program("a.ngc", b"G21 G0 Z5\nX1\nM2\n"), &["a.ngc"]);
    assert_eq!(told["assumed_start"], serde_json::json!({ "program": [], "machine": [] }));
}

#[test]
fn a_program_is_followed_through_its_offsets() {
    let folder =
        with_program("square.ngc", b"G55\nG0 X0 Y0 Z0\nG1 F2 Z-0.2\nX1\nY1\nX0\nY0\nG0 Z0\nG54\nG0 X0 Y0 Z0\nM2\n");
    fs::write(folder.path().join("m.var"), "5220\t1\n5241\t2\n5242\t1\n5243\t-2\n").expect("a var file");
    let (program, exit) = document(&folder, &["square.ngc", "--var", "m.var"]);
    assert_eq!(exit, 0);
    assert_eq!(program["extents"]["machine"]["X"], serde_json::json!([0.0, 3.0]));
    assert_eq!(program["extents"]["machine"]["Z"], serde_json::json!([-2.2, 0.0]));
    assert_eq!(program["path_mm"]["feed"], serde_json::json!(4.2));
    let output =
        rodete(&folder).args(["verify", "square.ngc", "--var", "m.var", "--canon"]).output().expect("an output");
    let second: Json =
        serde_json::from_str(String::from_utf8_lossy(&output.stdout).lines().nth(1).expect("a motion")).expect("JSON");
    assert_eq!(second["motion"], "feed");
    assert_eq!(second["line"], 3);
    assert_eq!(second["to"]["Z"], serde_json::json!(-0.2));
    assert_eq!(second["machine"], serde_json::json!({"X": 2.0, "Y": 1.0, "Z": -2.2}));
}

#[test]
fn a_program_that_moves_nothing_is_cautioned_and_not_refused() {
    let folder = folder();
    for (name, text, told) in [("words.ngc", "G21 G90\nM2\n", true), ("moves.ngc", "G21 G90\nG0 X1\nM2\n", false)] {
        std::fs::write(folder.path().join(name), text).expect("a program");
        let (program, exit) = document(&folder, &[name]);
        let findings = program["findings"].as_array().expect("findings");
        let caution = findings.iter().find(|one| one["code"] == "U0133");
        assert_eq!((caution.map(|one| one["grade"].as_str()), exit), (told.then_some(Some("caution")), 0), "{name}");
    }
}

#[test]
fn a_program_that_leaves_its_unit_to_the_control_is_told_and_one_in_inches_too() {
    for (dialect, program, options, told) in [
        ("linuxcnc", "G0 X1\nM2\n", &[][..], Some("(G21 or G20): rodete reads it in mm")),
        ("linuxcnc", "G0 X1\nM2\n", &["--inch"], Some("(G21 or G20): rodete reads it in inches")),
        ("fagor-8055", "G0 X1\nM30\n", &[], Some("(G71 or G70): rodete reads it in mm")),
        ("linuxcnc", "G21 G0 X1\nM2\n", &[], None),
        ("fagor-8055", "G70 G0 X1\nM30\n", &[], None),
        ("linuxcnc", "M2\n", &[], None),
        ("linuxcnc", "G0 A1\nM2\n", &[], None),
        ("linuxcnc", "G0 X1\nG20 G0 X2\nM2\n", &[], Some("(G21 or G20): rodete reads it in mm")),
        ("linuxcnc", "G20 G0 X2\nG21\nM2\n", &[], None),
    ] {
        let folder = with_program("program.nc", program.as_bytes());
        let assert =
            rodete(&folder).args(["verify", "program.nc", "--dialect", dialect]).args(options).assert().code(0);
        let output = String::from_utf8_lossy(&assert.get_output().stdout).into_owned();
        assert_eq!(output.contains("note G0534"), told.is_some(), "{program}: {output}");
        assert!(told.is_none_or(|told| output.contains(told)), "{program}: {output}");
        let inches = program.contains("G70") || program.contains("G20") || !options.is_empty();
        assert_eq!(output.contains("has lengths in inches; all lengths here are in mm"), inches, "{program}: {output}");
    }
}

#[test]
fn an_arc_reaches_beyond_its_ends() {
    let folder = with_program("arc.ngc", b"G21 G90 F100\nG0 X10 Y0\nG3 X-10 Y0 I-10 J0\nG3 X10 Y0 I10 J0 Z5 P2\nM2\n");
    let (program, _) = document(&folder, &["arc.ngc"]);
    assert_eq!(program["extents"]["program"]["Y"], serde_json::json!([-10.0, 10.0]));
    let length = program["path_mm"]["feed"].as_f64().expect("a length");
    let pi = std::f64::consts::PI;
    let expected = 10.0 * pi + (30.0 * pi * 30.0 * pi + 25.0_f64).sqrt();
    assert!((length - expected).abs() < 1e-9, "{length} {expected}");
}

#[test]
fn what_is_wrong_is_refused_with_its_line_and_column() {
    for (text, line, column, what) in [
        ("G0 X1,5\nM2\n", 1, 6, "character ','"),
        ("G0 X1.2.3\nM2\n", 1, 8, "two decimal points"),
        ("G0 X--5\nM2\n", 1, 5, "two signs"),
        ("G0 X1e3\nM2\n", 1, 6, "exponent not allowed"),
        ("G0 X99999999999999999999999999999\nM2\n", 1, 5, "beyond ±99,999.999"),
        ("G0 X\u{2212}5\nM2\n", 1, 5, "U+2212 (minus sign)"),
        ("G0 (a (b) c)\nM2\n", 1, 4, "nested comment"),
        ("G0 X1 (open\nM2\n", 1, 7, "unclosed comment"),
        ("G0 G1 X1\nM2\n", 1, 1, "two G codes of one modal group"),
        ("G0 X1 X2\nM2\n", 1, 4, "two X words"),
        ("X1\nM2\n", 1, 1, "axis words without a motion"),
        ("G1 X1\nM2\n", 1, 0, "feed move without F"),
        ("G1 F-1 X1\nM2\n", 1, 5, "negative F"),
        ("F9\nG2 X1 I9\nM2\n", 2, 0, "not on the circle"),
        ("G0 X[1/0]\nM2\n", 1, 7, "division by zero"),
        ("G5.9 X1\nM2\n", 1, 1, "G5.9 is not known to rodete"),
        ("G41 D1\nM2\n", 1, 1, "the diameter of tool 1 is not known"),
        ("G5.2 X1\nM2\n", 1, 1, "spline and NURBS curves"),
        ("M250\nM2\n", 1, 1, "M250 is not known to rodete"),
        ("G0 X1\n", 1, 0, "without M2 or M30"),
        ("", 1, 0, "no program"),
    ] {
        let found = refusal(text.as_bytes());
        assert_eq!((found.0, found.1, found.3), (line, column, 3), "{text}: {}", found.2);
        assert!(found.2.contains(what), "{text}: {}", found.2);
    }
}

#[test]
fn what_does_not_end_is_a_limit() {
    for (text, what) in [
        ("o1 while [1]\no1 endwhile\nM2\n", "endless loop: in 1000 passes"),
        ("G0 X1\nM99\n", "repeats it forever"),
        ("F1\nG83 X1 Z-99 R1 Q0.001\nM2\n", "more than 10000 pecks"),
    ] {
        let found = refusal(text.as_bytes());
        assert_eq!(found.3, 7, "{}", found.2);
        assert!(found.2.contains(what), "{}", found.2);
    }
    let mut long = vec![b'X'; 5_000];
    long.extend_from_slice(b"\nM2\n");
    assert_eq!(refusal(&long).3, 7);
    let deep = format!("G0 X{}1{}\nM2\n", "[".repeat(80), "]".repeat(80));
    assert!(refusal(deep.as_bytes()).2.contains("nested more than 64 deep"));
}

#[test]
fn refusals_are_listed_up_to_fifty_and_counted() {
    let mut text = String::new();
    for _ in 0..80 {
        let _ = writeln!(text, "G0 X1,5");
    }
    text.push_str("M2\n");
    let folder = with_program("program.ngc", text.as_bytes());
    let (program, exit) = document(&folder, &["program.ngc"]);
    assert_eq!(exit, 3);
    let findings = program["findings"].as_array().expect("findings");
    assert_eq!(findings.iter().filter(|finding| finding["grade"] == "stop").count(), 50);
    assert!(findings.iter().any(|finding| finding["what"]["en"] == "and 30 more errors"));
}

#[test]
fn how_rotary_words_were_read_is_told() {
    let folder = with_program("turn.nc", b"G90 G0 C270\r\nG1 C265.502 F100\r\nM30\r\n");
    let verify = |arguments: &[&str]| {
        let output = rodete(&folder).args(["verify", "turn.nc"]).args(arguments).output().expect("an output");
        [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned())
    };
    let [out, err] = verify(&["--dialect", "fagor-8055"]);
    assert!(out.contains("rotary axes rollover: in G90 the number is the angle to go to"), "{out}");
    assert!(err.contains("turn.nc:2\n") && err.contains("one feed block: C turns 355.502°"), "{err}");
    let [out, err] = verify(&["--dialect", "fagor-8055", "--rotary", "linear", "--lang", "es"]);
    assert!(out.contains("ejes giratorios como lineales") && !err.contains("media vuelta"), "{out}{err}");
    for (arguments, rotary) in
        [(&["--dialect", "fagor-8055"][..], "rollover"), (&["--dialect", "fagor-8070"][..], "linear")]
    {
        assert_eq!(document(&folder, &[&["turn.nc"], arguments].concat()).0["rotary"], rotary);
    }
}

#[test]
fn subprograms_are_found_in_named_folders_behind_the_programs_own() {
    let folder = with_program("main.ngc", b"G21\no<one> call\no<two> call\nM2\n");
    for (name, x) in [("one", 1), ("first/two", 2), ("second/two", 3), ("second/one", 4)] {
        let path = folder.path().join(format!("{name}.ngc"));
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        let label = name.rsplit('/').next().expect("a name");
        fs::write(path, format!("o<{label}> sub\nG0 X{x}\no<{label}> endsub\n")).expect("a subprogram");
    }
    let (program, exit) = document(&folder, &["main.ngc", "--subs", "first", "--subs", "second"]);
    assert_eq!((exit, &program["end"]["program"]["X"], &program["motions"]), (0, &Json::from(2.0), &Json::from(2)));
    let (_, exit) = document(&folder, &["main.ngc"]);
    assert_eq!(exit, 3, "without the folders there is no subprogram");
}

/// An axis that comes back to 0 is what one looks for in a program that closes.
#[test]
fn an_axis_that_comes_back_to_0_is_told_as_0() {
    let folder = with_program("program.ngc", b"G21 G90 G94 F500\nG0 X10 C90\nG1 X20 C0\nM2\n");
    rodete(&folder)
        .args(["verify", "program.ngc", "--lang", "en"])
        .assert()
        .success()
        .stdout(predicate::str::contains("net travel: X 20  Y 0  Z 0  C 0\n"));
    let (program, _) = document(&folder, &["program.ngc"]);
    assert_eq!(program["end"]["machine"]["C"], 0.0);
    assert_eq!(program["net_travel"].get("B"), None);
}

/// Extents behind a block that the control does not run would be those of another program.
#[test]
fn of_a_program_with_a_rejected_block_no_figures_are_told() {
    let folder = with_program("program.nc", b"%P,MX,\nG71 G90 G94 F100\nG1 G42 X10\nY30\nM30\n");
    rodete(&folder).args(["verify", "program.nc", "--dialect", "fagor-8055", "--lang", "en"]).assert().code(3).stdout(
        predicate::str::contains("no extents, path or time")
            .and(predicate::str::contains("net travel").not())
            .and(predicate::str::contains("at feed").not()),
    );
}

/// A canonical motion has the axes that it turns back to 0, and the feed of rotary axes alone is in degrees.
#[test]
fn canonical_motions_have_the_axis_that_arrives_at_0_and_degrees_for_what_only_turns() {
    let folder = with_program("program.ngc", b"G21 G90 G94 F500\nG1 A90\nG0 A0\nG1 X1 A5\nM2\n");
    let output = rodete(&folder).args(["verify", "program.ngc", "--canon", "--lang", "en"]).output().expect("it runs");
    let text = String::from_utf8(output.stdout).expect("text");
    let motions: Vec<Json> = text.lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
    assert_eq!((&motions[0]["feed_unit"], &motions[2]["feed_unit"]), (&Json::from("deg/min"), &Json::from("mm/min")));
    assert_eq!(motions[1]["to"]["A"], 0.0);
}

/// Of a file that nobody read there is nothing to be summed up.
#[test]
fn a_file_that_is_not_there_has_no_sum_and_no_figures() {
    let folder = super::common::with_impeller();
    rodete(&folder).args(["verify", "program.ngc", "--lang", "en"]).assert().code(4).stdout("");
    for (name, code) in [("program.ngc", "W0104"), ("impeller.xlsx", "U0122")] {
        let (program, exit) = document(&folder, &[name]);
        assert_eq!((exit, &program["findings"][0]["code"]), (4, &Json::from(code)), "{name}: {program}");
        let nothing = serde_json::json!({});
        for figures in
            [&program["path_mm"], &program["net_travel"], &program["end"]["program"], &program["end"]["machine"]]
        {
            assert_eq!(figures, &nothing, "{name}");
        }
        assert_eq!((&program["feed_time_s"], &program["sha256"]), (&Json::Null, &Json::Null), "{name}");
    }
}

/// What stops the command before a program is read is told of each of them, at its line in the file that is meant.
#[test]
fn a_tool_table_or_a_parameter_file_that_is_wrong_is_told_with_its_line() {
    let folder = with_program("program.ngc", b"G21 G90\nG0 X1\nM2\n");
    fs::write(folder.path().join("bad.tbl"), "T1 Z1\nT2 Z1O.5\n").expect("a table");
    fs::write(folder.path().join("bad.var"), "5161\t0\n5221\t12,5\n").expect("a file");
    for (option, file, code, exit, line, at) in [
        ("--tools", "bad.tbl", "G0813", 3, Json::from(2), "bad.tbl:2:4"),
        ("--var", "bad.var", "G1009", 3, Json::from(2), "bad.var:2:6"),
        ("--tools", "none.tbl", "W0106", 4, Json::Null, "none.tbl"),
        ("--var", "none.var", "W0106", 4, Json::Null, "none.var"),
    ] {
        let (program, ended) = document(&folder, &["program.ngc", option, file]);
        let finding = &program["findings"][0];
        let place = &finding["place"]["beside"];
        assert_eq!((ended, &program["exit"]), (exit, &Json::from(exit)), "{file}");
        assert_eq!(
            (&finding["code"], &place["file"], &place["line"]),
            (&code.into(), &file.into(), &line),
            "{finding}"
        );
        assert_eq!((&program["path_mm"], &program["feed_time_s"]), (&serde_json::json!({}), &Json::Null));
        for command in ["verify", "view"] {
            let told = predicate::str::contains(format!("error {code}: "))
                .and(predicate::str::contains(format!("\n  --> {at}\n")));
            rodete(&folder)
                .args([command, "program.ngc", option, file, "--lang", "en"])
                .assert()
                .code(exit)
                .stderr(told);
        }
    }
    fs::copy(folder.path().join("program.ngc"), folder.path().join("other.ngc")).expect("a program");
    let line = ["verify", "program.ngc", "other.ngc", "--tools", "bad.tbl", "--json"];
    let output = rodete(&folder).args(line).output().expect("an output");
    let read: Json = serde_json::from_slice(&output.stdout).expect("a JSON document");
    let codes: Vec<_> =
        read["programs"].as_array().expect("programs").iter().map(|one| &one["findings"][0]["code"]).collect();
    assert_eq!((&read["exit"], codes), (&Json::from(3), vec![&Json::from("G0813"); 2]));
}

#[test]
fn the_lines_of_a_number_that_stands_twice_are_values_too() {
    let folder = with_program("twice.nc", b"G21 G98\nM97 P50\nM30\nN50 G0 X40.\nM99\nN50 G0 X50.\nM99\n");
    let (program, _) = document(&folder, &["twice.nc", "--dialect", "fanuc-lathe-a"]);
    let found = program["findings"].as_array().expect("findings").iter().find(|one| one["code"] == "G0303");
    let finding = found.expect("the number that stands twice");
    assert!(finding["what"]["en"].as_str().is_some_and(|what| what.ends_with("in lines 4 and 6")), "{finding}");
    assert_eq!(finding["data"], serde_json::json!({ "number": 50, "lines": [4, 6] }));
}

#[test]
fn a_workbook_in_place_of_a_program_is_named_and_not_read_as_one() {
    let folder = super::common::with_impeller();
    let told = predicate::str::starts_with("error U0122: impeller.xlsx is a workbook, not a program\n");
    let one = told.and(predicate::str::contains("hint: build it with rodete build impeller.xlsx"));
    let only = one.and(predicate::str::contains("G0").not());
    rodete(&folder).args(["verify", "impeller.xlsx", "--lang", "en"]).assert().code(4).stderr(only);
}

/// A value that is words is told in the language of the message.
#[test]
fn a_value_in_words_is_in_the_language_of_the_message() {
    let folder = super::common::folder();
    let new = ["new", "impeller", "impeller.xlsx", "--case", "tfg-2021", "--lang", "es"];
    rodete(&folder).args(new).assert().success();
    let told = predicate::str::contains("comprendida entre -1.9378 y -1.9376 mm (límite 0 mm)");
    let spanish = told.and(predicate::str::contains("bounded").not()).and(predicate::str::contains("lines").not());
    rodete(&folder).args(["check", "impeller.xlsx"]).assert().success().stderr(spanish);
}

#[test]
fn a_program_named_as_for_another_control_is_told_whatever_is_refused() {
    // A refusal that no sign explains leaves the ending of the name as the only one.
    let refused = b"G54 S900 M3\nG0 X0 Y0 Z5\nG1 Z-2 F200\nQ\nM30\n";
    let folder = with_program("y.mpf", refused);
    let codes = |program: &Json| {
        let findings = program["findings"].as_array().expect("findings").iter();
        findings.map(|one| one["code"].as_str().unwrap_or_default().to_owned()).collect::<Vec<_>>()
    };
    let (program, exit) = document(&folder, &["y.mpf"]);
    assert!(codes(&program).contains(&"G0011".to_owned()) && codes(&program).contains(&"G0852".to_owned()));
    assert_eq!(exit, 3);
    let named = document(&folder, &["y.mpf", "--dialect", "linuxcnc"]).0;
    assert!(!codes(&named).contains(&"G0852".to_owned()), "{named}");
    // A sign among its blocks says it in place of the refusal, and once.
    let folder = with_program("y.mpf", b"G54 S900 M3\nG0 X0 Y0 Z5\nSPOS=0\nM30\n");
    let (program, exit) = document(&folder, &["y.mpf"]);
    assert_eq!((codes(&program).iter().filter(|code| code.starts_with("G085")).count(), exit), (1, 3), "{program}");
    assert!(codes(&program).contains(&"G0850".to_owned()), "{program}");
    let turned = b"G21 G97 S900 M3\nT0101\nG0 X52. Z2.\nG1 Z-20. F.2\nG0 X60.\nM30\n";
    let folder = with_program("z.mpf", turned);
    for command in ["verify", "simulate"] {
        let output = rodete(&folder).args([command, "z.mpf", "--lang", "en"]).output().expect("an output");
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(told.contains("caution G0852: '.mpf' belongs to programs for Siemens SINUMERIK"), "{command}: {told}");
        assert!(told.contains("post it for a control that rodete reads"), "{command}: {told}");
    }
}
