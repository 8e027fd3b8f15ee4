//! The command `simulate`: its document, its files, its arguments.

use std::fs;
use std::path::Path;

use rodete::parameter::Value;
use rodete::text::Language;
use serde_json::Value as Json;
use tempfile::TempDir;

use super::bench::{Book, Said, lines, program, run};

const TURNS: &str = "G0 X46.|G1 Z-20. F0.2|U8.|G0 Z2.";
const RAPID: &str = "G0 X40. Z-10.|G0 X54.";
const DIALECT: [&str; 4] = ["simulate", "p.nc", "--dialect", "fanuc-lathe-a"];

fn bench(blocks: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("p.nc"), program(blocks).join("\n")).unwrap();
    folder
}

fn simulate(folder: &Path, more: &[&str]) -> Said {
    run(folder, &[&DIALECT, more].concat())
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn the_document_has_these_keys_and_these_units() {
    let folder = bench(TURNS);
    let said = simulate(folder.path(), &["--stock", "D50xL120", "--json"]);
    assert_eq!((said.exit, said.err.as_str()), (0, ""));
    let document: Json = serde_json::from_str(&said.out).unwrap();
    let keys: Vec<_> = document.as_object().unwrap().keys().map(String::as_str).collect();
    assert_eq!(
        keys,
        [
            "alarms", "command", "dialect", "exit", "files", "findings", "motions", "program", "rodete", "schema",
            "sha256", "status", "stock", "totals"
        ]
    );
    for (key, wanted) in
        [("command", "simulate"), ("dialect", "fanuc-lathe-a"), ("status", "done"), ("stock", "D50xL120")]
    {
        assert_eq!(document[key], wanted);
    }
    let totals = document["totals"].as_object().unwrap();
    assert_eq!(
        totals.keys().collect::<Vec<_>>(),
        [
            "alarms",
            "cutting_time_s",
            "greatest_cutting_speed_m_min",
            "greatest_depth_mm",
            "greatest_removal_rate_cm3_min",
            "other_library_apart_mm",
            "part_volume_mm3",
            "parted_volume_mm3",
            "rapid_time_s",
            "removed_volume_mm3",
            "stops",
            "time_s"
        ]
    );
    let total = |key: &str| totals[key].as_f64().unwrap();
    let bar = std::f64::consts::PI / 4.0 * 2500.0 * 120.0;
    assert!((total("part_volume_mm3") + total("removed_volume_mm3") - bar).abs() < 1e-3);
    // S 900 1/min: 20 mm of cut and 2 mm before it at 0.2 mm a revolution.
    assert!((total("greatest_cutting_speed_m_min") - std::f64::consts::PI * 0.05 * 900.0).abs() < 1e-6);
    assert!((total("greatest_depth_mm") - 2.0).abs() < 1e-6, "{}", total("greatest_depth_mm"));
    assert!(total("cutting_time_s") > 6.6 && total("cutting_time_s") < 9.0, "{}", total("cutting_time_s"));
    assert!(total("time_s") > total("cutting_time_s") + total("rapid_time_s"));
    // Seven to the bar and along it, one away, and a pass of four.
    assert_eq!(document["motions"], 6);
}

#[test]
fn the_totals_of_a_rejected_program_are_not_known() {
    let folder = bench("N10 G0 X46.|N20 G1 Z-20. F.2|N30 G2 X60. Z-40. R1.|N40 G0 X54.");
    let said = simulate(folder.path(), &["--stock", "D50xL120", "--json"]);
    let document: Json = serde_json::from_str(&said.out).unwrap();
    assert_eq!(document["status"], "refused");
    let totals = document["totals"].as_object().unwrap();
    assert!(totals.len() > 10 && totals.values().all(Json::is_null), "{totals:?}");
}

#[test]
fn the_alarms_of_the_document_are_figures() {
    let folder = bench("N10 G0 X40. Z-10.|N20 X54.");
    let said = simulate(folder.path(), &["--stock", "D50xL120", "--json"]);
    let document: Json = serde_json::from_str(&said.out).unwrap();
    let alarms = document["alarms"].as_array().unwrap();
    assert_eq!(
        (&document["totals"]["alarms"], &document["totals"]["stops"]),
        (&Json::from(alarms.len()), &Json::from(alarms.len()))
    );
    let first = &alarms[0];
    let keys: Vec<_> = first.as_object().unwrap().keys().map(String::as_str).collect();
    let figures = ["block", "depth_mm", "file", "line", "number", "text", "x_mm", "z_mm"];
    let finding = ["alarm", "code", "count", "data", "grade", "limit", "name", "place", "remedy", "value", "what"];
    let mut both = [&figures[..], &finding].concat();
    both.sort_unstable();
    assert_eq!(keys, both);
    // An alarm is told as every finding is, beside its figures.
    let told = &document["findings"].as_array().unwrap().iter().find(|one| one["place"] == first["place"]).unwrap();
    assert_eq!(told.as_object().unwrap().keys().collect::<Vec<_>>(), finding);
    for key in finding {
        assert_eq!(first[key], told[key], "{key}");
    }
    assert_eq!((&first["code"], &first["place"]["line"]["line"]), (&Json::from("L0101"), &first["line"]));
    assert_eq!(
        (&first["number"], &first["line"], &first["block"]),
        (&Json::from(101), &Json::from(6), &Json::from(10))
    );
    assert_eq!((&first["grade"], &first["file"]), (&Json::from("stop"), &Json::Null));
    assert_eq!(first["text"]["es"], "Avance rápido a través del material");
    assert!(first["depth_mm"].as_f64().unwrap() > 4.0 && first["z_mm"].as_f64().unwrap() < 0.0, "{first}");
    assert!((40.0..=50.0).contains(&first["x_mm"].as_f64().unwrap()), "{first}");
}

/// Numbers of the stops of a program with the example's tools, or a workbook's.
fn stopped(program: &str, more: &[&str]) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("p.nc"), program.replace('|', "\n")).unwrap();
    fs::write(folder.path().join("lathe.xlsx"), Book::of(Language::En).bytes()).unwrap();
    let said = simulate(folder.path(), &[&["--stock", "D50xL120", "--json"], more].concat());
    let document: Json = serde_json::from_str(&said.out).unwrap();
    let stops = document["alarms"].as_array().unwrap().iter().filter(|one| one["grade"] == "stop");
    stops.map(|one| format!("{} at {}", one["number"], one["line"])).collect()
}

#[test]
fn without_a_workbook_the_bar_is_faced_and_the_note_says_so_and_names_the_cell_of_its_allowance() {
    let across = program("G0 Z.5|X20.|Z5.").join("|");
    let none: [&str; 0] = [];
    assert_eq!(stopped(&across, &[]), none);
    // The workbook's bar is 1 mm longer: a rapid in front of Z0 meets it.
    let sawn = stopped(&across, &["--tools", "lathe.xlsx"]);
    assert!(sawn.iter().any(|one| one.starts_with("101 ")), "{sawn:?}");
    let folder = bench(TURNS);
    for (language, wanted) in
        [("en", ["already faced", "Z0", "L5", "--tools"]), ("es", ["ya refrentada", "Z0", "L5", "--tools"])]
    {
        let said = simulate(folder.path(), &["--stock", "D50xL120", "--lang", language]);
        let note = said.out.lines().find(|line| line.contains("U0124")).unwrap();
        for part in wanted {
            assert!(note.contains(part), "{part}: {note}");
        }
    }
}

#[test]
fn the_note_names_the_tailstock_that_is_assumed_and_an_alarm_of_it_the_option() {
    let folder = bench("G0 X22.|G0 Z.5|X-1.|Z5.");
    let note = |said: &Said| said.out.lines().find(|line| line.contains("U0124")).unwrap().to_owned();
    let on = |more: &[&str]| simulate(folder.path(), &[&["--stock", "D20xL100", "--lang", "en"], more].concat());
    let said = on(&[]);
    assert!(
        note(&said)
            .contains("with a tailstock, because the bar sticks out of the jaws by 75 mm, more than 3·D = 60 mm")
    );
    assert!(
        said.exit == 3
            && said.err.contains("L0113")
            && said
                .err
                .contains("withdraw the tailstock (in the workbook, tailstock: no; without one, --tailstock no)")
    );
    let said = on(&["--tailstock", "no"]);
    assert!(note(&said).contains("without a tailstock (--tailstock no)"), "{}", said.out);
    assert!(!said.err.contains("L0113") && !said.err.contains("L0116"), "{}", said.err);
    let said = simulate(folder.path(), &["--stock", "D50xL100", "--lang", "en"]);
    assert!(note(&said).contains("without a tailstock, because") && !said.err.contains("L0113"), "{}", said.out);
    let said = simulate(folder.path(), &["--stock", "D50xL100", "--tailstock", "yes", "--lang", "en"]);
    assert!(note(&said).contains("with the tailstock (--tailstock yes)") && said.err.contains("L0113"), "{}", said.err);
    // The workbook's own word is in its cell, and the option goes before it.
    fs::write(folder.path().join("t.xlsx"), Book::of(Language::En).bytes()).unwrap();
    let tools = ["--tools", "t.xlsx", "--tailstock", "yes", "--stock", "D50xL120", "--lang", "en"];
    let said = simulate(folder.path(), &tools);
    assert!(said.err.contains("L0113") && said.err.contains("in the workbook, tailstock: no"), "{}", said.err);
}

#[test]
fn a_chamfer_without_its_comma_is_told_with_it_and_any_other_c_is_not() {
    let remedy = |blocks: &str, code: &str| {
        let folder = bench(blocks);
        let said = simulate(folder.path(), &["--stock", "D50xL120", "--json"]);
        let document: Json = serde_json::from_str(&said.out).unwrap();
        let findings = document["findings"].as_array().unwrap();
        let found = findings.iter().find(|one| one["code"] == code).unwrap();
        ["es", "en"].map(|language| found["remedy"][language].as_str().unwrap().to_owned())
    };
    for blocks in ["G1 X40. C1.5 F.2|Z-20.", "G1 Z0. F.2|X40. C1.5|Z-20."] {
        let [es, en] = remedy(blocks, "G0140");
        assert!(es.starts_with("para un chaflán escriba ,C1.5 con coma; si "), "{es}");
        assert!(en.starts_with("for a chamfer write ,C1.5 with a comma; if "), "{en}");
    }
    // In rapid, of another letter, or with a sign it is no chamfer.
    for blocks in ["G0 X40. C1.5", "G1 X40. B1.5 F.2", "G1 X40. C-1.5 F.2"] {
        let [es, en] = remedy(blocks, "G0117");
        assert!(es.starts_with("si el programa") && en.starts_with("if the program"), "{es} {en}");
    }
}

#[test]
fn of_a_rejected_program_no_figure_is_shown_and_of_a_whole_one_each_is() {
    let figures = |blocks: &str| {
        let folder = bench(blocks);
        let said = simulate(folder.path(), &["--stock", "D50xL120", "--lang", "en"]);
        let figure = |line: &str| {
            let (symbol, rest) = line.strip_prefix("  ")?.split_once(" = ")?;
            Some((symbol.trim().to_owned(), rest.split_whitespace().next()?.to_owned()))
        };
        said.out.lines().filter_map(figure).collect::<Vec<_>>()
    };
    let rejected = figures("G1 X46. C1. F.2|Z-20.");
    let dashes = rejected.iter().filter(|(symbol, value)| {
        assert_eq!(value == "-", !["L3", "Z_W1"].contains(&symbol.as_str()), "{symbol} {value}");
        value == "-"
    });
    assert!(dashes.count() > 10, "{rejected:?}");
    for symbol in ["alarms", "stops", "V_r", "V_c"] {
        assert!(rejected.iter().any(|(one, _)| one == symbol), "{symbol}");
    }
    // An alarm rejects no block.
    let whole = figures("G0 X40. Z-10.|X54.");
    assert!(whole.len() > 12 && whole.iter().all(|(_, value)| value != "-"), "{whole:?}");
    assert!(whole.iter().any(|(symbol, value)| symbol == "alarms" && value != "0"), "{whole:?}");
}

#[test]
fn the_example_s_tools_cut_as_a_program_of_m4_alone_turns_and_a_drill_never_does() {
    let none: [&str; 0] = [];
    let turned =
        |spindle: &str| format!("G50 S2500|T0101|G97 S900 {spindle}|M8|G0 X46. Z2.|G1 Z-20. F.2|G0 X100. Z50.|M30");
    assert_eq!(stopped(&turned("M3"), &[]), none);
    for left in ["M4", "M04", "M4 (NOT M3)", "m4"] {
        assert_eq!(stopped(&turned(left), &[]), none, "{left}");
    }
    // It has both, or another code that begins alike: the tools stay as they are.
    assert_eq!(stopped(&turned("M3|M4"), &[]), ["154 at 7"]);
    assert_eq!(stopped(&turned("M41|M4|M03|M4"), &[]), ["154 at 9"]);
    // Of a workbook's tools its cells tell.
    assert_eq!(stopped(&turned("M4"), &["--tools", "lathe.xlsx"]), ["154 at 6"]);
    let drilled = "G50 S2500|T0505|G97 S900 M4|M8|G0 X0. Z2.|G1 Z-20. F.1|G0 Z50.|X100.|M30";
    assert_eq!(stopped(drilled, &[]), ["154 at 6"]);
    assert_eq!(stopped(&drilled.replace("M4", "M3"), &[]), none);
}

#[test]
fn r_of_a_hole_is_what_the_option_says_before_the_workbook() {
    let hole = "T0505|G97 S900 M3|M8|G0 X0. Z5.|G83 Z-20. R-4. Q5000 F.1|G80|G0 Z50.|M30";
    let none: [&str; 0] = [];
    assert_eq!(stopped(hole, &["--hole-r", "incremental"]), none);
    assert_eq!(stopped(hole, &["--hole-r", "incremental", "--tools", "lathe.xlsx"]), none);
    let absolute = stopped(hole, &["--hole-r", "absolute"]);
    assert!(absolute.iter().any(|one| one.starts_with("101 ")), "{absolute:?}");
    // Verify reads it so, with the workbook's word where the option has none; said where neither has.
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("p.nc"), hole.replace('|', "\n")).unwrap();
    let book = Book::of(Language::En).put("hole_R", Value::Choice("incremental"));
    fs::write(folder.path().join("own.xlsx"), book.bytes()).unwrap();
    let rapid = |more: &[&str]| {
        let given = ["verify", "p.nc", "--dialect", "fanuc-lathe-a", "--lang", "en"];
        let said = run(folder.path(), &[&given[..], more].concat());
        assert_eq!(said.exit, 0, "{}", said.err);
        let canon = run(folder.path(), &[&given[..], more, &["--canon"]].concat()).out;
        let first = canon.lines().filter(|line| line.contains("\"rapid\"")).nth(1).unwrap().to_owned();
        let motion: Json = serde_json::from_str(&first).unwrap();
        (motion["to"]["Z"].as_f64().unwrap(), said.err.contains("the meaning of R in G81 to G83 is not given"))
    };
    assert_eq!(rapid(&[]), (-4.0, true));
    assert_eq!(rapid(&["--hole-r", "absolute"]), (-4.0, false));
    assert_eq!(rapid(&["--hole-r", "incremental"]), (1.0, false));
    assert_eq!(rapid(&["--tools", "own.xlsx"]), (1.0, false));
    assert_eq!(rapid(&["--tools", "own.xlsx", "--hole-r", "absolute"]), (-4.0, false));
    // The viewer shows it so.
    let page = |rule: &str| {
        let bar = ["view", "p.nc", "--dialect", "fanuc-lathe-a", "--stock", "D50xL120", "--hole-r", rule];
        run(folder.path(), &bar).exit
    };
    assert_eq!((page("incremental"), page("absolute")), (0, 3));
}

#[test]
fn nothing_is_written_without_a_folder() {
    let folder = bench(TURNS);
    assert_eq!(simulate(folder.path(), &["--stock", "D50xL120"]).exit, 0);
    assert_eq!(names(folder.path()), ["p.nc"]);
}

#[test]
fn a_program_that_an_alarm_stops_is_delivered_with_what_shows_why() {
    let folder = bench(RAPID);
    let said = simulate(folder.path(), &["--stock", "D50xL120", "-o", "out", "--json"]);
    assert_eq!(said.exit, 3);
    let document: Json = serde_json::from_str(&said.out).unwrap();
    assert_eq!(document["status"], "refused");
    // All but the program: it is not to be run.
    let wanted = ["p-contour.dxf", "p-contour.svg", "p-part.stl", "p-results.xlsx", "p-viewer.html"];
    assert_eq!(names(&folder.path().join("out")), wanted);
    let mut told: Vec<_> =
        document["files"].as_array().unwrap().iter().map(|file| file["name"].as_str().unwrap()).collect();
    told.sort_unstable();
    assert_eq!(told, wanted);
    let page = fs::read_to_string(folder.path().join("out/p-viewer.html")).unwrap();
    assert!(page.contains("\"number\":101"));
}

#[test]
fn the_same_program_gives_the_same_files() {
    let folder = bench(TURNS);
    for out in ["one", "two"] {
        assert_eq!(simulate(folder.path(), &["--stock", "D50xL120", "-o", out]).exit, 0);
    }
    let names = names(&folder.path().join("one"));
    assert_eq!(names.len(), 6);
    for name in names {
        let read = |out: &str| fs::read(folder.path().join(out).join(&name)).unwrap();
        assert_eq!(read("one"), read("two"), "{name}");
    }
}

#[test]
fn a_stock_that_is_none_is_refused_before_anything_is_read() {
    let folder = bench(TURNS);
    for (stock, why) in [
        ("50x100", "'50' is not a size"),
        ("D50", "D and L must both be given"),
        ("D50xL0", "L0 is out of range"),
        ("D5000xL100", "D5000 is out of range"),
        ("D50xL100xd50", "the bore d must be less than D"),
        ("D50xL100xL2", "L is given twice"),
        ("D50,5xL100", "'D50,5': write the decimal with a point, D50.5"),
        ("DnanxL100", "'Dnan' is not a size"),
        ("D-50xL100", "'D-50' is not a size"),
    ] {
        let said = simulate(folder.path(), &["--stock", stock, "-o", "out"]);
        assert_eq!((said.exit, said.out.as_str()), (2, ""), "{stock}");
        assert!(said.err.contains("--stock <STOCK>") && said.err.contains(why), "{stock}: {}", said.err);
    }
    assert_eq!(names(folder.path()), ["p.nc"]);
}

#[test]
fn a_workbook_of_tools_is_named_where_it_is_wrong() {
    let folder = bench(TURNS);
    assert_eq!(run(folder.path(), &["new", "impeller", "other.xlsx"]).exit, 0);
    let comma = Book::of(Language::En).change("tools", |rows| {
        rows[0].values.insert("tools/R", rodete::parameter::Value::Line("0,8".to_owned()));
    });
    fs::write(folder.path().join("comma.xlsx"), comma.bytes()).unwrap();
    let long = Book::of(Language::En).put("L4", rodete::parameter::Value::Real(200.0));
    fs::write(folder.path().join("held.xlsx"), long.bytes()).unwrap();
    for (tools, exit, what) in [
        ("other.xlsx", 3, "error W0514: other.xlsx: schema is \"rodete-impeller 2\"; rodete reads \"rodete-lathe 1\""),
        ("p.nc", 4, "error W0206: p.nc: this is a program, not an .xlsx workbook"),
        ("missing.xlsx", 4, "error W0106: cannot open missing.xlsx: no such file"),
        (".", 4, "error W0101: cannot open .: it is a folder"),
        ("held.xlsx", 3, "error P4001: held.xlsx: L4 is 200 mm; it must be less than L = 120 mm"),
        ("comma.xlsx", 3, "error W0410: comma.xlsx: R (nose radius) is the text \"0,8\", not a number"),
    ] {
        let said = simulate(folder.path(), &["--tools", tools, "-o", "out"]);
        assert_eq!(said.exit, exit, "{tools}");
        assert!(said.err.starts_with(what) && said.err.contains("hint: "), "{tools}: {}", said.err);
    }
    assert!(!folder.path().join("out").exists());
}

#[test]
fn the_workbook_of_tools_gives_stock_machine_and_rule() {
    let folder = bench("G0 X46|G1 Z-20. F0.2|U8.|G0 Z2.");
    fs::write(folder.path().join("part.xlsx"), Book::of(Language::En).bytes()).unwrap();
    let with = |more: &[&str]| {
        let said = simulate(folder.path(), &[&["--tools", "part.xlsx", "--json"], more].concat());
        serde_json::from_str::<Json>(&said.out).unwrap()
    };
    let document = with(&[]);
    assert_eq!(
        (document["exit"].as_u64(), document["stock"].as_str()),
        (Some(0), Some("D50xL120")),
        "{:?}",
        lines(&document)
    );
    assert!(lines(&document).contains(&"note 6:4 dimensions without decimal point, read as mm".to_owned()));
    assert_eq!(with(&["--stock", "D50xL90"])["stock"], "D50xL90");
    assert!(lines(&with(&["--decimal-point", "micrometre"])).iter().any(|line| line.contains("least increments")));
}

#[test]
fn no_input_is_written_over() {
    let folder = bench(TURNS);
    // The results of one program would replace the workbook that its machine is read from.
    fs::write(folder.path().join("p-results.xlsx"), Book::of(Language::En).bytes()).unwrap();
    let before = fs::read(folder.path().join("p-results.xlsx")).unwrap();
    let said = simulate(folder.path(), &["--tools", "p-results.xlsx", "-o", "."]);
    assert_eq!(said.exit, 2, "{}", said.err);
    assert!(said.err.contains("p-results.xlsx"), "{}", said.err);
    assert_eq!(fs::read(folder.path().join("p-results.xlsx")).unwrap(), before);
    assert_eq!(names(folder.path()), ["p-results.xlsx", "p.nc"]);
    let said = simulate(folder.path(), &["--stock", "D50xL120", "-o", "p.nc"]);
    assert_eq!(said.exit, 5, "{}", said.err);
    assert_eq!(names(folder.path()), ["p-results.xlsx", "p.nc"]);
}

#[test]
fn what_is_no_program_file_is_refused_by_what_it_is() {
    let folder = bench(TURNS);
    fs::write(folder.path().join("part.xlsx"), Book::of(Language::En).bytes()).unwrap();
    for (input, exit, what) in [
        ("part.xlsx", 4, "error U0122: part.xlsx is a workbook, not a program"),
        ("missing.nc", 4, "error W0106: cannot open missing.nc: no such file"),
        (".", 4, "error W0101: cannot open .: it is a folder"),
    ] {
        let said = run(folder.path(), &["simulate", input, "--dialect", "fanuc-lathe-a", "-o", "out"]);
        assert_eq!(said.exit, exit, "{input}");
        assert!(said.err.starts_with(what) && said.err.contains("hint: "), "{input}: {}", said.err);
    }
    assert!(!folder.path().join("out").exists());
}

#[test]
fn the_messages_are_in_the_language_asked_for() {
    let folder = bench(RAPID);
    let said = simulate(folder.path(), &["--stock", "D50xL120", "--lang", "es"]);
    for wanted in [
        "error L0101: 101 Avance rápido a través del material",
        "--> p.nc:6\n",
        "sugerencia: aleje el punto de partida",
    ] {
        assert!(said.err.contains(wanted), "{wanted}: {}", said.err);
    }
    assert!(said.out.contains("Volumen arrancado"), "{}", said.out);
}

#[test]
fn the_dialect_is_told_where_nobody_names_it() {
    let folder = bench(TURNS);
    fs::write(folder.path().join("f.nc"), "N5 G92 S2500\nN10 T1 D1\nN20 G97 S900 M3\nN30 G0 X54 Z2\nN40 M30\n")
        .unwrap();
    for (input, dialect) in [("p.nc", "fanuc-lathe-a"), ("f.nc", "fagor-8055-t")] {
        let said = run(folder.path(), &["simulate", input, "--stock", "D50xL120", "--json"]);
        let document: Json = serde_json::from_str(&said.out).unwrap();
        assert_eq!(document["dialect"], dialect, "{document}");
        assert!(
            lines(&document).contains(&format!("note file no dialect given: rodete reads the program as {dialect}"))
        );
    }
}

#[test]
fn another_bar_is_held_and_faced_as_the_workbook_says() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("p.nc"), program("G0 X46.|G1 Z-20. F0.2|U8.").join("\n")).unwrap();
    let book = Book::of(Language::En).put("L4", Value::Real(41.0)).put("L5", Value::Real(1.5));
    fs::write(folder.path().join("part.xlsx"), book.bytes()).unwrap();
    let overhang = |more: &[&str]| {
        let arguments = [
            &["simulate", "p.nc", "--stock", "D50xL120", "--dialect", "fanuc-lathe-a", "--decimal-point"][..],
            &["calculator"],
            more,
        ]
        .concat();
        let said = run(folder.path(), &arguments);
        let line =
            said.out.lines().find(|line| line.contains("L3")).unwrap_or_else(|| panic!("{}", said.err)).to_owned();
        line.split_whitespace().find_map(|word| word.parse::<f64>().ok()).unwrap()
    };
    assert_eq!(overhang(&["--tools", "part.xlsx"]), 79.0);
    assert_eq!(overhang(&[]), 90.0);
}

#[test]
fn a_cell_of_the_workbook_beside_the_program_is_told_with_the_workbooks_name() {
    let folder = bench(TURNS);
    fs::write(folder.path().join("part.xlsx"), Book::of(Language::En).without("D").bytes()).unwrap();
    for command in ["simulate", "view"] {
        let said = run(folder.path(), &[command, "p.nc", "--dialect", "fanuc-lathe-a", "--tools", "part.xlsx"]);
        assert_eq!(said.exit, 3, "{command}");
        assert!(said.err.contains("--> part.xlsx, sheet \"DATA\", cell "), "{command}: {}", said.err);
    }
}

#[test]
fn a_comment_in_latin_1_is_read_and_utf_16_is_named() {
    let folder = bench(TURNS);
    let text = format!("(A\u{f1}o)\n{}", program(TURNS).join("\n"));
    let latin: Vec<u8> = text.chars().map(|character| u8::try_from(u32::from(character)).unwrap()).collect();
    fs::write(folder.path().join("p.nc"), latin).unwrap();
    let said = simulate(folder.path(), &["--stock", "D50xL120", "-o", "out"]);
    assert_eq!((said.exit, said.err.as_str()), (0, ""));
    let out = |name: &str| fs::read_to_string(folder.path().join("out").join(name)).unwrap();
    assert!(out("p-program.nc").starts_with("(A\u{f1}o)\r\n") && out("p-viewer.html").contains("[\"(A\u{f1}o)\""));
    let wide: Vec<u8> = [0xFEFF].into_iter().chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    fs::write(folder.path().join("p.nc"), wide).unwrap();
    for (command, exit) in [("simulate", 4), ("view", 4), ("verify", 3)] {
        let said = run(folder.path(), &[command, "p.nc", "--dialect", "fanuc-lathe-a"]);
        assert_eq!(said.exit, exit, "{command}");
        assert_eq!(said.err.lines().filter(|line| line.starts_with("error ")).count(), 1, "{command}: {}", said.err);
        assert!(said.err.contains(": the file is in UTF-16"), "{command}: {}", said.err);
    }
}

#[test]
fn a_milling_program_is_named_as_one_unless_the_control_is_given() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("p.nc"), "%\nO1001\nG21 G17 G90\nT1 M6\nG43 Z50. H1\nG0 X10. Y10.\nM30\n%\n").unwrap();
    let said = run(folder.path(), &["simulate", "p.nc"]);
    assert_eq!((said.exit, said.out.as_str()), (3, ""));
    let errors: Vec<_> = said.err.lines().filter(|line| line.starts_with("error ")).collect();
    assert_eq!(errors, ["error U0136: this is a milling program: simulate reads turning programs"]);
    let said = simulate(folder.path(), &[]);
    assert!(said.err.contains("error G0106: G17") && !said.err.contains("U0136"), "{}", said.err);
}
