//! The lathe workbook: its lists are written, read back, and refused cell by cell.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeMap;
use std::io::{Cursor, Read};

use calamine::{Reader, Xlsx};
use rodete::figure::Ink;
use rodete::finding::{CellPlace, Exit, Finding, Grade, Place, Refusal};
use rodete::kind::{Outcome, Provenance, Shown};
use rodete::kinds;
use rodete::kinds::lathe::cases::CASES;
use rodete::kinds::lathe::parameters::{FORM, PROFILE_KEY, PROGRAM_KEY, SECOND_KEY, TOOLS_KEY};
use rodete::kinds::lathe::setup::Given;
use rodete::kinds::lathe::{Simulated, catalogue, watched};
use rodete::machine::axis::Axis;
use rodete::parameter::field::Fields;
use rodete::parameter::list::{Row, Rows};
use rodete::parameter::{Value, Values};
use rodete::table::Entry;
use rodete::text::Language;
use rodete::workbook::{self, template};

/// A workbook with the values of a case and lists that `change` has been at.
fn book(case: usize, language: Language, change: impl FnOnce(&mut Vec<Rows>)) -> Vec<u8> {
    let case = &CASES[case];
    let mut lists = (case.listed)(language);
    change(&mut lists);
    let mut out = Cursor::new(Vec::new());
    template::write(&rodete::kinds::lathe::Lathe, &case.values(language), &lists, &case.note, language, &mut out)
        .unwrap();
    out.into_inner()
}

fn line(row: &Row, key: &str) -> String {
    if let Some(Value::Line(line)) = row.values.get(key) { line.clone() } else { String::new() }
}

fn read(bytes: &[u8]) -> Result<Values, Refusal> {
    workbook::read(bytes, &[&FORM]).map(|filled| filled.values)
}

fn list<'a>(lists: &'a mut [Rows], key: &str) -> &'a mut Vec<Row> {
    &mut lists.iter_mut().find(|rows| rows.list == key).unwrap().rows
}

/// Cell and message of every stop.
fn stops(bytes: &[u8]) -> Vec<(String, String)> {
    let refusal = read(bytes).unwrap_err();
    let cells = |place: &Place| match place {
        Place::Cells(cells) => {
            cells.iter().map(|one| format!("{}!{}", one.sheet, one.cell)).collect::<Vec<_>>().join(" ")
        }
        other => format!("{other:?}"),
    };
    refusal.findings.iter().map(|one| (cells(&one.place), one.what.en.to_string())).collect()
}

#[test]
fn every_row_of_every_list_comes_back_with_its_cells() {
    for (index, case) in CASES.iter().enumerate() {
        for language in Language::ALL {
            let values = read(&book(index, language, |_| ())).unwrap();
            let written = (case.listed)(language);
            assert_eq!(values.lists.len(), written.len());
            for (read, written) in values.lists.iter().zip(&written) {
                assert_eq!(read.list, written.list);
                let rows: Vec<_> = read.rows.iter().map(|row| &row.values).collect();
                assert_eq!(rows, written.rows.iter().map(|row| &row.values).collect::<Vec<_>>(), "{}", read.list);
            }
            let block = &values.rows(PROGRAM_KEY)[1];
            let sheet = if language == Language::Es { "PROGRAMA" } else { "PROGRAM" };
            assert_eq!(block.cell("program/BLOCK"), [CellPlace { sheet: sheet.to_owned(), cell: "A7".to_owned() }]);
        }
    }
}

#[test]
fn rows_may_be_left_empty_between_others() {
    let with_gaps = book(0, Language::En, |lists| {
        let rows = list(lists, PROGRAM_KEY);
        rows.insert(3, Row::default());
        rows.insert(3, Row::default());
    });
    let without = read(&book(0, Language::En, |_| ())).unwrap();
    let with_gaps = read(&with_gaps).unwrap();
    let blocks = |values: &Values| -> Vec<String> {
        values.rows(PROGRAM_KEY).iter().map(|row| line(row, "program/BLOCK")).collect()
    };
    assert_eq!(blocks(&with_gaps), blocks(&without));
    assert_eq!(with_gaps.rows(PROGRAM_KEY)[3].cell("program/BLOCK")[0].cell, "A11");
}

#[test]
fn subprograms_are_sheets_called_o_and_their_number() {
    let bytes = book(0, Language::En, |lists| {
        let rows = list(lists, PROGRAM_KEY).clone();
        lists.push(Rows { list: "subprogram", sheet: "O0005".to_owned(), rows });
    });
    let values = read(&bytes).unwrap();
    let found: Vec<_> = values.lists.iter().filter(|rows| rows.list == "subprogram").collect();
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].sheet, "O0005");
    assert_eq!(found[0].rows.len(), values.rows(PROGRAM_KEY).len());
}

#[test]
fn a_wrong_cell_of_a_list_is_refused_by_its_address() {
    let changed = |key: &'static str, row: usize, column: &'static str, value: Option<Value>| {
        stops(&book(1, Language::En, |lists| {
            let values = &mut list(lists, key)[row].values;
            match value {
                Some(value) => values.insert(column, value),
                None => values.remove(column),
            };
        }))
    };
    assert_eq!(
        changed(TOOLS_KEY, 0, "tools/type", None),
        [("TOOLS!D6".to_owned(), "type (type) is missing".to_owned())]
    );
    assert_eq!(
        changed(TOOLS_KEY, 0, "tools/R", Some(Value::Real(-1.0))),
        [("TOOLS!G6".to_owned(), "R (nose radius) is -1 mm; it must be from 0 to 50 mm".to_owned())]
    );
    assert_eq!(
        changed(TOOLS_KEY, 0, "tools/R", Some(Value::Line("0,8".to_owned()))),
        [("TOOLS!G6".to_owned(), "R (nose radius) is the text \"0,8\", not a number".to_owned())]
    );
    assert_eq!(
        changed(PROFILE_KEY, 1, "profile/G", Some(Value::Line("4".to_owned()))),
        [(
            "PROFILE!A7".to_owned(),
            "G (1 straight, 2 clockwise arc, 3 counter-clockwise) is \"4\"; it must be one of: 1, 2, 3".to_owned()
        )]
    );
}

#[test]
fn a_list_without_rows_is_refused_where_it_is_needed() {
    let bytes = book(1, Language::Es, |lists| list(lists, PROGRAM_KEY).clear());
    assert_eq!(stops(&bytes), [("Sheet(\"PROGRAMA\")".to_owned(), "there are no rows below the headings".to_owned())]);
    let values = read(&book(1, Language::Es, |lists| list(lists, PROFILE_KEY).clear())).unwrap();
    assert!(values.rows(PROFILE_KEY).is_empty());
}

#[test]
fn every_tool_of_the_catalogue_can_be_mounted() {
    let language = Language::En;
    let mut values = Values { language, ..Values::default() };
    values.values.extend(CASES[0].values(language));
    let rows = catalogue::rows(language);
    assert!(rows.len() > 80, "{}", rows.len());
    for mut row in rows {
        row.values.insert("tools/T", Value::Whole(1));
        let name = line(&row, "tools/name");
        values.lists = vec![Rows { list: TOOLS_KEY, sheet: "TOOLS".to_owned(), rows: vec![row] }];
        let given = Given::of(&Fields::of(&FORM, values.clone()).unwrap())
            .unwrap_or_else(|findings| panic!("{name}: {findings:?}"));
        assert_eq!(given.setup.turret.tools.len(), 1, "{name}");
    }
}

#[test]
fn what_a_program_comes_to_is_what_its_simulation_says_cycles_of_two_blocks_among_them() {
    for (index, case) in CASES.iter().enumerate() {
        let values = read(&book(index, Language::En, |_| ())).unwrap();
        let source = Provenance { workbook: "case.xlsx".to_owned(), sha256: "0".repeat(64), version: "1" };
        let outcome = kinds::run(&FORM, values, source).unwrap();
        let [program] = outcome.programs.as_slice() else { panic!("{}: one program", case.name) };
        let (run, account) = (program.duration.unwrap(), &program.account);
        let time = outcome.quantities.iter().find(|quantity| quantity.symbol == "t").unwrap().value;
        assert_eq!((program.key, run.seconds.to_bits(), run.timeless), ("program", time.to_bits(), 0), "{}", case.name);
        let motions = outcome.table("blocks").unwrap().rows();
        assert_eq!(usize::try_from(account.motions), Ok(motions), "{}", case.name);
        assert!(account.feed_path > 100.0 && account.rapid_path > 100.0, "{account:?}");
        let reach = account.program.unwrap();
        assert!(reach.of(Axis::Z)[0] < -10.0 && reach.of(Axis::Z)[1] > 30.0, "{reach:?}");
        // What was compared with a profile says how far it is off; else page 1 of the report says that there was none.
        let wanted = !outcome.fields.values().rows("profile").is_empty();
        let [supported, profile, (tools, Shown::Rows(_))] = outcome.setup.as_slice() else {
            panic!("{}: {:?}", case.name, outcome.setup)
        };
        assert_eq!(
            (supported, profile, *tools),
            (&("supported", Shown::Whether(false)), &("profile", Shown::Whether(wanted)), "tools")
        );
        assert_eq!(outcome.quantities.iter().any(|quantity| quantity.symbol == "dev_plus"), wanted, "{}", case.name);
        // The figures of the report: one path, and every key once.
        let keys: Vec<_> = outcome.figures.iter().map(|figure| figure.key).collect();
        assert_eq!(keys, ["cover", "half-section", "setup", "path"]);
    }
}

/// The outcome of the first case with these blocks for its program and, where there are any, for that of the second set-up.
fn turned(first: &[&str], second: &[&str]) -> Outcome {
    let rows = |blocks: &[&str]| -> Vec<Row> {
        let values = |block: &&str| BTreeMap::from([("program/BLOCK", Value::Line((*block).to_owned()))]);
        blocks.iter().map(|block| Row { values: values(block), ..Row::default() }).collect()
    };
    let bytes = book(0, Language::En, |lists| {
        *list(lists, PROGRAM_KEY) = rows(first);
        if !second.is_empty() {
            lists.push(Rows { list: SECOND_KEY, sheet: String::new(), rows: rows(second) });
        }
    });
    let source = Provenance { workbook: "case.xlsx".to_owned(), sha256: "0".repeat(64), version: "1" };
    kinds::run(&FORM, read(&bytes).unwrap(), source).unwrap()
}

/// The rows that the set-up sheet prints under a key, in English, cells joined with ` | `.
fn sheet_rows(outcome: &Outcome, key: &str) -> Vec<String> {
    let found = outcome.setup.iter().find(|(name, _)| *name == key).map(|(_, shown)| shown);
    let Some(Shown::Rows(rows)) = found else { panic!("{key}: {found:?}") };
    rows.iter().map(|row| row.iter().map(|cell| cell.en.to_string()).collect::<Vec<_>>().join(" | ")).collect()
}

#[test]
fn the_set_up_sheet_gives_each_tool_the_conditions_under_which_it_cuts_or_says_that_it_does_not() {
    let outcome = kinds::run(
        &FORM,
        read(&book(0, Language::En, |_| ())).unwrap(),
        Provenance { workbook: "case.xlsx".to_owned(), sha256: "0".repeat(64), version: "1" },
    )
    .unwrap();
    assert_eq!(
        sheet_rows(&outcome, "tools"),
        [
            "G96 180 m/min ≤ 2500 rpm M3 | 0.15, 0.25 mm/rev | yes",
            "G96 220 m/min ≤ 2500 rpm M3 | 0.12 mm/rev | yes",
            "G97 800 rpm M3 | 0.08 mm/rev | yes",
            "G97 600 rpm M3 | lead 1.5 mm | yes",
            "G97 1200 rpm M3 | 0.12 mm/rev | yes",
            "not used",
        ]
    );
    // Without a limit, with many feeds, a feed per minute and coolant in part; a tool that moves and does not cut, one that is only called.
    let blocks = [
        "G21 G40 G97 G99",
        "T0101",
        "G96 S150 M3",
        "G0 X48. Z2.",
        "G1 Z-5. F0.1",
        "Z-10. F0.2",
        "M8",
        "Z-15. F0.3",
        "Z-20. F0.4",
        "G98 G1 Z-25. F80.",
        "G0 X100. Z50.",
        "T0202",
        "G0 X90. Z40.",
        "T0303",
        "T0101",
        "M30",
    ];
    let outcome = turned(&blocks, &[]);
    let rows = sheet_rows(&outcome, "tools");
    assert_eq!(
        rows[0], "G96 150 m/min, no limit, M3 | 0.1 … 0.4 mm/rev; 80 mm/min | yes and no",
        "{:?}",
        outcome.findings
    );
    assert_eq!(rows[1..4], ["called, does not cut", "called, does not cut", "not used"]);
}

#[test]
fn the_set_up_sheet_gives_the_spindles_maximum_where_the_programs_limit_or_speed_is_above_it() {
    let with = |limit: &'static str, speed: &'static str| {
        let program =
            ["G21 G40 G97 G99", "T0101", limit, speed, "M8", "G0 X48. Z2.", "G1 Z-5. F0.1", "G0 X90. Z50.", "M30"];
        let outcome = turned(&program, &[]);
        let codes: Vec<_> = outcome.findings.iter().map(Finding::code).collect();
        let row = sheet_rows(&outcome, "tools")[0].split(" | ").next().unwrap().to_owned();
        (row, codes.contains(&"L0151") || codes.contains(&"L0152"))
    };
    // At 48 mm 150 m/min asks for 995 rpm, 600 m/min for 3979: what the spindle cannot is a caution, too.
    for (limit, speed, row, told) in [
        ("G50 S3500", "G96 S150 M3", "G96 150 m/min ≤ 3000 rpm (machine; program 3500) M3", false),
        ("G50 S3500", "G96 S600 M3", "G96 600 m/min ≤ 3000 rpm (machine; program 3500) M3", true),
        ("G50 S3000", "G96 S600 M3", "G96 600 m/min ≤ 3000 rpm M3", false),
        ("G50 S3000", "G97 S3200 M3", "G97 3200 rpm M3 (machine ≤ 3000 rpm)", true),
    ] {
        assert_eq!(with(limit, speed), (row.to_owned(), told), "{limit} {speed}");
    }
}

#[test]
fn the_set_up_sheet_says_of_which_axes_the_extents_count_on_where_the_turret_stood() {
    let starts = |first: &[&'static str]| {
        let mut program = vec!["G21 G40 G97 G99", "T0101", "G97 S900 M3", "M8"];
        program.extend(first);
        program.extend(["G0 X48. Z2.", "G1 Z-5. F0.1", "G0 X90. Z50.", "M30"]);
        let outcome = turned(&program, &[]);
        let told = outcome.setup.iter().find(|(key, _)| *key == "start-program").map(|(_, shown)| shown.clone());
        told.map(|told| if let Shown::Words(axes) = told { axes } else { panic!("{told:?}") })
    };
    assert_eq!(starts(&[]), None);
    assert_eq!(starts(&["G28 U0. W0."]), None);
    assert_eq!(starts(&["G0 X60."]).as_deref(), Some("Z"));
    assert_eq!(starts(&["G0 W-10."]).as_deref(), Some("X, Z"));
}

#[test]
fn a_tool_of_the_other_set_up_alone_is_not_told_as_unused() {
    let program = |tool| {
        let call: &'static str = tool;
        ["G21 G40 G97 G99", call, "G97 S900 M3", "M8", "G0 X54. Z2.", "X48.", "G1 Z-10. F0.2", "G0 X100. Z50.", "M30"]
    };
    let outcome = turned(&program("T0101"), &program("T0202"));
    let [first, second] = ["tools", "tools-2"].map(|key| sheet_rows(&outcome, key));
    assert_eq!(first[..3], ["G97 900 rpm M3 | 0.2 mm/rev | yes", "only in the other set-up", "not used"]);
    assert_eq!(second[1..3], ["G97 900 rpm M3 | 0.2 mm/rev | yes", "not used"]);
}

#[test]
fn the_set_up_sheet_says_which_program_counts_on_an_assumed_reference_point_and_which_cells_give_it() {
    let goes = ["G21 G40 G97 G99", "T0101", "G97 S900 M3", "M8", "G0 X48. Z2.", "G1 Z-5. F0.1", "G28 U0. W0.", "M30"];
    let stays = ["G21 G40 G97 G99", "T0101", "G97 S900 M3", "M8", "G0 X48. Z2.", "G1 Z-5. F0.1", "G0 X90. Z50.", "M30"];
    let told = |outcome: &Outcome| -> Vec<(&str, Shown)> {
        outcome
            .setup
            .iter()
            .filter(|(key, _)| ["assumed", "zero", "reference"].iter().any(|begins| key.starts_with(begins)))
            .cloned()
            .collect()
    };
    let outcome = turned(&goes, &[]);
    let on_sheet = told(&outcome);
    let [(key, so), (_, Shown::Words(point)), (_, Shown::Words(cells))] = on_sheet.as_slice() else {
        panic!("{on_sheet:?}")
    };
    assert_eq!((*key, so), ("assumed-program", &Shown::Whether(true)));
    let found = outcome.findings.iter().find(|one| one.code() == "L0211").unwrap();
    assert!(found.what.en.contains(point.as_str()), "{point}: {}", found.what.en);
    assert!(cells.starts_with("R_X (DATA!C") && cells.contains(", R_Z (DATA!C"), "{cells}");
    assert_eq!(told(&turned(&stays, &goes))[0].0, "assumed-program-2");
    assert_eq!(told(&turned(&stays, &[])), []);
    // G53 counts from M, whatever is assumed for G28; a comment counts on nothing, a subprogram as the program does.
    let with = |block: &'static str| {
        let mut program = goes;
        program[6] = block;
        turned(&program, &[])
    };
    assert_eq!(told(&with("G53 X200. Z400."))[0].0, "zero-program");
    assert_eq!(told(&with("(NO G28 HERE, G53 NEVER)")), []);
    let mut calls = goes[..6].to_vec();
    calls.extend(["M98 P0005", "M30", "O0005", "G28 U0. W0.", "M99"]);
    assert_eq!(told(&turned(&calls, &[]))[0].0, "assumed-program");
}

#[test]
fn a_build_says_that_no_workbook_gives_the_second_reference_point() {
    let program =
        ["G21 G40 G97 G99", "T0101", "G97 S900 M3", "M8", "G0 X48. Z2.", "G1 Z-5. F0.1", "G30 U0. W0.", "M30"];
    let codes: Vec<_> = turned(&program, &[]).findings.iter().map(Finding::code).collect();
    assert!(codes.contains(&"G0835") && !codes.contains(&"L0211"), "{codes:?}");
}

#[test]
fn a_workbook_whose_program_moves_nothing_is_a_stop() {
    let bytes = book(0, Language::En, |lists| {
        let rows = list(lists, PROGRAM_KEY);
        rows.truncate(3);
        for (row, block) in rows.iter_mut().zip(["O0001", "N5 G21 G40 G97 G99", "N10 M30"]) {
            row.values.insert("program/BLOCK", Value::Line(block.to_owned()));
        }
    });
    let source = Provenance { workbook: "case.xlsx".to_owned(), sha256: "0".repeat(64), version: "1" };
    let outcome = kinds::run(&FORM, read(&bytes).unwrap(), source).unwrap();
    let stops: Vec<_> = outcome.findings.iter().filter(|one| one.grade == Grade::Stop).map(Finding::code).collect();
    assert_eq!((stops, outcome.exit(), outcome.programs.len()), (vec!["L0229"], Exit::Refused, 0));
}

#[test]
fn the_programs_of_a_lathe_stand_once_in_its_results_and_its_profile_on_a_layer_of_its_own() {
    let values = read(&book(1, Language::En, |_| ())).unwrap();
    let source = Provenance { workbook: "case.xlsx".to_owned(), sha256: "0".repeat(64), version: "1" };
    let outcome = kinds::run(&FORM, values, source).unwrap();
    let mut out = Cursor::new(Vec::new());
    workbook::results::write(&outcome, &[], workbook::results::Tables::Live, Language::En, &mut out).unwrap();
    let bytes = out.into_inner();
    let mut styles = String::new();
    let mut package = zip::ZipArchive::new(Cursor::new(&bytes)).unwrap();
    package.by_name("xl/styles.xml").unwrap().read_to_string(&mut styles).unwrap();
    // The blocks beside their lines' numbers: an indent without a side is passed over.
    let alignments = styles.split("<alignment").skip(1).filter_map(|rest| rest.split('>').next());
    let indented = alignments.filter(|one| one.contains("indent=\"1\"") && one.contains("wrapText"));
    assert!(indented.clone().count() > 0 && indented.clone().all(|one| one.contains("horizontal=")), "{styles}");
    let sheets = Xlsx::new(Cursor::new(bytes)).unwrap().sheet_names();
    assert!(sheets.iter().any(|name| name == "PROGRAM"), "{sheets:?}");
    assert!(!sheets.iter().any(|name| name == "INCR" || name == "LISTING"), "{sheets:?}");
    let [template] = outcome.drawings.as_slice() else { panic!("one drawing") };
    assert!(template.arcs.iter().all(|arc| arc.ink == Ink::Profile) && template.arcs[0].radius == 15.0);
    assert!(template.figure.strokes.iter().all(|stroke| matches!(stroke.ink, Ink::Cut | Ink::Profile | Ink::Centre)));
    let along = |pair: &[[f64; 2]]| pair[0][1].abs() < 1e-9 && pair[1][1].abs() < 1e-9;
    let drawn = template.figure.strokes.iter().filter(|stroke| stroke.points.windows(2).any(along));
    assert_eq!(drawn.map(|stroke| stroke.ink).collect::<Vec<_>>(), [Ink::Centre], "the axis is a centre line only");
}

#[test]
fn an_alarm_that_is_told_at_the_end_stands_in_the_row_of_its_motion() {
    // The shoulder's edge at Z−20 is the second edge's, for the way ends in the surface; the rapid motion goes through it.
    let blocks = [
        "G97 S600 M3 T0101",
        "M8",
        "G0 X46. Z2.",
        "G1 Z-20. F0.2",
        "X45.5",
        "G0 Z-22.",
        "X100. Z50.",
        "G1 X99. F0.3",
        "M30",
    ];
    let bytes = book(0, Language::En, |lists| {
        let rows = list(lists, PROGRAM_KEY);
        rows.truncate(blocks.len());
        for (row, block) in rows.iter_mut().zip(blocks) {
            row.values.insert("program/BLOCK", Value::Line(block.to_owned()));
        }
    });
    let source = Provenance { workbook: "case.xlsx".to_owned(), sha256: "0".repeat(64), version: "1" };
    let Simulated { outcome, alarms, .. } =
        watched(Fields::of(&FORM, read(&bytes).unwrap()).unwrap(), source, None, &mut |_| ()).unwrap();
    let table = outcome.table("blocks").unwrap();
    let column = |name: &str| &table.column(name).unwrap().values;
    let told: Vec<_> = (0..table.rows())
        .filter_map(|row| match (column("block").get(row), column("alarms").get(row)) {
            (Entry::Text(block), Entry::Text(alarms)) if !alarms.en.is_empty() => {
                Some((block.en.to_string(), alarms.en.to_string()))
            }
            _ => None,
        })
        .collect();
    assert_eq!(told, [("X45.5".to_owned(), "132".to_owned()), ("G0 Z-22.".to_owned(), "101".to_owned())]);
    let numbers: Vec<_> = alarms.iter().map(|raised| raised.alarm.cause.number()).collect();
    assert_eq!(numbers, [132, 101], "in the order of their motions");
}

/// The results of the shaft, with cells of its program's sheet changed.
fn changed(cells: &[(&str, &str)]) -> Vec<u8> {
    let kind: &dyn rodete::kind::Kind = &rodete::kinds::lathe::Lathe;
    let case = CASES.iter().find(|case| case.name == "shaft").unwrap();
    let outcome = crate::common::outcome_of(kind, case, Language::En, &[]);
    let mut out = Cursor::new(Vec::new());
    let tables = workbook::results::Tables::Live;
    workbook::results::write(&outcome, &[], tables, Language::En, &mut out).unwrap();
    cells.iter().fold(out.into_inner(), |bytes, (cell, text)| {
        let inner = format!(" t=\"inlineStr\"><is><t>{text}</t></is>");
        crate::live::with_on(&bytes, "PROGRAM", cell, &inner)
    })
}

#[test]
fn a_remark_beside_a_block_changes_no_input_and_a_changed_block_is_named_by_its_cell() {
    let stale = |bytes: &[u8]| workbook::read(bytes, &[&FORM]).unwrap().stale;
    assert!(stale(&changed(&[])).is_none());
    let noted = changed(&[("B8", "checked by the shop")]);
    assert!(stale(&noted).is_none());
    let parts = crate::common::workbook::Parts::of(&noted);
    let guard = (1..40)
        .map(|at| format!("xl/worksheets/sheet{at}.xml"))
        .filter(|part| parts.has(part))
        .map(|part| parts.text(&part))
        .find(|text| text.contains("SUMPRODUCT"))
        .unwrap();
    assert!(guard.contains("PROGRAM!$A$") && !guard.contains("PROGRAM!$B$"), "no flag looks at the remarks");
    let finding = stale(&changed(&[("A8", "G99"), ("B8", "why")])).unwrap();
    assert_eq!(finding.code(), "W0519");
    assert!(finding.what.en.contains("PROGRAM (A8);"), "{}", finding.what.en);
    let cell = CellPlace { sheet: "PROGRAM".to_owned(), cell: "A8".to_owned() };
    assert_eq!(finding.place, Place::Cells(vec![cell]));
}

#[test]
fn a_row_of_a_list_is_compared_under_the_name_of_its_sheet_and_its_number() {
    use rodete::kind::comparison::{Comparison, Side};
    let values = [changed(&[]), changed(&[("A8", "G99")])].map(|bytes| read(&bytes).unwrap());
    let side = |at: usize| Side { values: &values[at], findings: &[], outcome: None };
    let told: Vec<_> = Comparison::of(&FORM, [side(0), side(1)]).inputs.into_iter().map(|one| one.symbol).collect();
    assert_eq!(told.len(), 1);
    assert_eq!([&*told[0].es, &*told[0].en], ["BLOCK (PROGRAM, fila 3)", "BLOCK (PROGRAM, row 3)"]);
}

#[test]
fn derived_values_differ_where_a_shown_digit_does_and_are_shown_rounded_where_none_does() {
    use rodete::kind::comparison::{Comparison, Derived};
    use rodete::table::Unit;
    let derived = |one: f64, other: f64| Derived {
        symbol: "y_min",
        meaning: rodete::text::Text::same("y"),
        unit: Unit::Millimetre,
        values: [Some(one), Some(other)],
    };
    let quantities = vec![derived(-12.345_678_912_345, -12.345_678_932_345), derived(1.0, 1.000_002)];
    assert_eq!(quantities.iter().map(Derived::differs).collect::<Vec<_>>(), [false, true]);
    let all = Comparison { inputs: Vec::new(), quantities, findings: Vec::new(), programs: Vec::new() };
    let lines: Vec<_> = all.sheets()[1].lines.iter().map(|line| line.texts(Language::En)).collect();
    assert_eq!(lines[0][1..4], ["-12.345679", "-12.345679", ""].map(str::to_owned));
    assert_eq!(lines[1][3], "0.000002");
}
