//! Live cells and the guard, judged by LibreOffice, which is made to compute every formula anew.

use crate::common;
use crate::common::workbook::Parts;
use crate::libreoffice::{EXCEL, converted_with, libreoffice};

use std::path::{Path, PathBuf};

use calamine::{Data, Range, Reader, Xlsx, open_workbook};
use rodete::kind::Outcome;
use rodete::kinds::KINDS;
use rodete::parameter::Value;
use rodete::table::{Entry, Index, Table};
use rodete::text::Language;
use rodete::workbook::guard::SHEET;
use rodete::workbook::results::{self, Tables};
use rodete::workbook::stamp::STALE;
use rodete::workbook::{self, template};

/// What LibreOffice keeps of a number in its file, beside what its arithmetic differs by.
const TOLERANCE: f64 = 1e-12;
/// The same of arcs: the centre of a flat one lies far off its three points, whose last digits count many times.
const ARCS: f64 = 1e-10;

pub type Book = Xlsx<std::io::BufReader<std::fs::File>>;

fn written(outcome: &Outcome, tables: Tables, language: Language) -> Vec<u8> {
    let mut out = std::io::Cursor::new(Vec::new());
    results::write(outcome, &[], tables, language, &mut out).expect("results");
    out.into_inner()
}

/// The books as LibreOffice computes them, with a comma for the decimal point where `comma` says so.
pub fn recalculated(folder: &Path, comma: bool, books: &[(String, Vec<u8>)]) -> Vec<Book> {
    let files: Vec<PathBuf> = books
        .iter()
        .map(|(name, bytes)| {
            let path = folder.join(format!("{name}.xlsx"));
            std::fs::write(&path, bytes).expect("a file");
            path
        })
        .collect();
    let locale = if comma { "es-ES" } else { "en-US" };
    let settings = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?><oor:items xmlns:oor=\"http://openoffice.org/2001/registry\">\
        <item oor:path=\"/org.openoffice.Office.Calc/Formula/Load\"><prop oor:name=\"OOXMLRecalcMode\" oor:op=\"fuse\">\
        <value>0</value></prop></item><item oor:path=\"/org.openoffice.Setup/L10N\">\
        <prop oor:name=\"ooSetupSystemLocale\" oor:op=\"fuse\"><value>{locale}</value></prop></item></oor:items>"
    );
    let made = converted_with(&files, EXCEL, "xlsx", Some(&settings));
    made.iter().map(|path| open_workbook(path).expect("LibreOffice's workbook")).collect()
}

pub fn range(book: &mut Book, name: &str) -> Range<Data> {
    book.worksheet_range(name).unwrap_or_else(|error| panic!("sheet {name}: {error}"))
}

/// A number of a sheet; nothing for what shows nothing.
pub fn number(cell: Option<&Data>) -> Option<f64> {
    match cell {
        Some(Data::Float(value)) => Some(*value),
        Some(Data::Int(value)) => Some(f64::from(i32::try_from(*value).expect("a small number"))),
        Some(Data::String(text)) if !text.trim().is_empty() => panic!("{text} where a number stands"),
        _ => None,
    }
}

/// Every live table of an outcome on the sheets of a book; returns how many cells were compared.
fn compared(book: &mut Book, outcome: &Outcome, language: Language, but: impl Fn(&Table, &str) -> bool) -> usize {
    let mut count = 0;
    for table in outcome.tables.iter().filter(|table| table.columns.iter().any(|column| column.live.is_some())) {
        let sheet = range(book, table.name.get(language));
        let offset = usize::from(table.index.counted());
        for (at, column) in table.columns.iter().enumerate() {
            if column.live.is_none() || but(table, &column.symbol.en) {
                continue;
            }
            for row in 0..table.rows() {
                let Entry::Number(value) = column.values.get(row) else { continue };
                let place = (u32::try_from(row + 4).expect("a row"), u32::try_from(at + offset).expect("a column"));
                let told = format!("{}, {}, row {}", table.key, column.symbol.en, row + 5);
                let there = number(sheet.get_value(place)).unwrap_or_else(|| panic!("{told}: nothing"));
                let tolerance = if table.key == "arcs" { ARCS } else { TOLERANCE };
                assert!(
                    (there - value).abs() <= tolerance * value.abs().max(1.0),
                    "{told}: {value}, LibreOffice {there}"
                );
                count += 1;
            }
            // Nothing is shown below the last point.
            let below = u32::try_from(table.rows() + 4).expect("a row");
            let place = (below, u32::try_from(at + offset).expect("a column"));
            if matches!(table.index, Index::Intervals { .. } | Index::Within { .. }) {
                assert_eq!(number(sheet.get_value(place)), None, "{}, row {}", table.key, below + 1);
            }
        }
    }
    count
}

fn stale(book: &mut Book) -> f64 {
    let count = range(book, SHEET);
    number(count.get_value((0, 2))).expect("a count")
}

/// A results workbook with another value in the cell of an input.
fn with(bytes: &[u8], cell: &str, inner: &str) -> Vec<u8> {
    with_on(bytes, "DATA", cell, inner)
}

/// The same on a sheet.
pub fn with_on(bytes: &[u8], sheet: &str, cell: &str, inner: &str) -> Vec<u8> {
    let parts = Parts::of(bytes);
    let listed = parts.text("xl/workbook.xml");
    let before = listed.split(&format!("<sheet name=\"{sheet}\"")).next().expect("a list of sheets");
    let part = format!("xl/worksheets/sheet{}.xml", before.matches("<sheet name=").count() + 1);
    parts.cell(&part, cell, &format!("<c r=\"{cell}\"{inner}</c>")).zip()
}

/// The cell of an input by its defined name.
pub fn cell_of(bytes: &[u8], name: &str) -> String {
    let listed = Parts::of(bytes).text("xl/workbook.xml");
    let (_, rest) = listed.split_once(&format!("<definedName name=\"{name}\">")).expect("the name");
    let (place, _) = rest.split_once('<').expect("its end");
    place.rsplit_once('!').expect("a sheet").1.replace('$', "")
}

#[test]
fn every_live_cell_comes_to_what_the_engine_computed_with_point_and_with_comma() {
    if !libreoffice() {
        return;
    }
    for (language, comma) in [(Language::En, false), (Language::Es, true)] {
        let folder = tempfile::tempdir().expect("a folder");
        let cases: Vec<_> = common::alternating(Language::Es).filter(|(.., one)| *one == language).collect();
        let outcomes: Vec<&Outcome> =
            cases.iter().map(|(kind, case, language)| common::shipped(*kind, case, *language)).collect();
        let mut books: Vec<(String, Vec<u8>)> = outcomes
            .iter()
            .enumerate()
            .map(|(at, outcome)| (format!("case-{at}"), written(outcome, Tables::Live, language)))
            .collect();
        // Were nothing computed, a wrong value would stay.
        let impeller = outcomes.iter().position(|one| one.tables.iter().any(|table| table.key == "annex-2"));
        let impeller = impeller.expect("an impeller");
        let parts = Parts::of(&books[impeller].1);
        let sheet = (1..40).map(|at| format!("xl/worksheets/sheet{at}.xml"));
        let wrong = sheet
            .filter(|part| parts.has(part))
            .find(|part| parts.text(part).contains("(torus_R+meridian_r*COS("))
            .expect("annex 2");
        let text = parts.text(&wrong);
        let (at, tag) = text.match_indices("</f><v>").nth(12).expect("a formula");
        let (before, after) = text.split_at(at + tag.len());
        let (_, rest) = after.split_once('<').expect("the value's end");
        let spoilt = format!("{before}77<{rest}");
        books.push(("wrong".to_owned(), parts.put(&wrong, spoilt).zip()));
        let mut books = recalculated(folder.path(), comma, &books);
        let mut count = 0;
        for (at, outcome) in outcomes.iter().enumerate() {
            count += compared(&mut books[at], outcome, language, |_, _| false);
            assert!(stale(&mut books[at]).abs() < 0.5, "{:?}: the inputs are as verified", cases[at].0);
        }
        assert!(count > 3_000, "{count} cells only");
        let mended = books.last_mut().expect("the book with a wrong value");
        compared(mended, outcomes[impeller], language, |_, _| false);
    }
}

#[test]
fn inputs_changed_in_the_results_give_what_a_new_build_gives_and_turn_the_banner() {
    if !libreoffice() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let bytes = written(&common::outcome("tfg-2021", &[]), Tables::Live, Language::En);
    let changes: [(&'static str, &str, Value); 5] = [
        ("n", "intervals_n", Value::Whole(60)),
        ("n", "intervals_n", Value::Whole(12)),
        ("R", "torus_R", Value::Real(26.5)),
        ("e", "thickness_e", Value::Real(1.75)),
        ("H", "height_H", Value::Real(31.25)),
    ];
    let books: Vec<(String, Vec<u8>)> = changes
        .iter()
        .enumerate()
        .map(|(at, (_, name, value))| {
            let text = match value {
                Value::Real(value) => value.to_string(),
                Value::Whole(value) => value.to_string(),
                _ => unreachable!("numbers alone"),
            };
            (format!("changed-{at}"), with(&bytes, &cell_of(&bytes, name), &format!("><v>{text}</v>")))
        })
        .collect();
    for ((key, _, value), mut book) in changes.into_iter().zip(recalculated(folder.path(), false, &books)) {
        let outcome = common::outcome("tfg-2021", &[(key, value)]);
        // The splitter's m is searched for and stays what it was: that is what the banner is for.
        // And a block of the splitter is another, as none is the one that was verified.
        compared(&mut book, &outcome, Language::En, |table, symbol| match table.key {
            "splitter" => !matches!(symbol, "B" | "C" | "z_1" | "z_2"),
            "live-splitter" => matches!(symbol, "X" | "Y" | "equal"),
            _ => symbol == "equal",
        });
        assert!((stale(&mut book) - 1.0).abs() < 0.5, "{key}");
        let told = range(&mut book, "Annex 6").get_value((1, 0)).map(ToString::to_string).unwrap_or_default();
        assert!(told.starts_with("NOT VERIFIED") && told.contains(": 1;"), "{key}: {told}");
        assert_eq!(told.contains("; the print ends at row 45; "), outcome.tables[0].rows() > 41, "{key}: {told}");
    }
}

#[test]
fn inputs_changed_in_the_results_of_pipes_give_what_a_new_build_gives() {
    if !libreoffice() {
        return;
    }
    // Neither square nor centred: every term of the formulas counts.
    type Change = (&'static str, &'static str, Value);
    let oblique = |e: f64| -> Vec<Change> {
        vec![("theta", "angle_theta", Value::Real(68.5)), ("e", "eccentricity_e", Value::Real(e))]
    };
    let mut hole = oblique(6.25);
    hole.extend([("gamma", "groove_gamma", Value::Real(21.0)), ("N", "divisions_N", Value::Whole(96))]);
    let mut kerf = oblique(-7.5);
    kerf.push(("kerf", "kerf", Value::Real(2.2)));
    let divided = |count| {
        let mut changes = oblique(-4.0);
        changes.push(("N", "divisions_N", Value::Whole(count)));
        changes
    };
    // The last step of an odd count is straight; with few points some lie on no arc of less than half a circle.
    let mut few = divided(9);
    few.push(("theta", "angle_theta", Value::Real(25.0)));
    let changed = [
        ("pipe-hole", hole),
        ("pipe-hole", kerf),
        ("pipe-insert", oblique(9.5)),
        ("pipe-insert", divided(80)),
        ("pipe-insert", divided(63)),
        ("pipe-insert", few),
    ];
    let folder = tempfile::tempdir().expect("a folder");
    let case_of = |kind: &str| {
        let kind = *KINDS.iter().find(|one| one.form().kind == kind).expect("a kind");
        (kind, &kind.cases()[0])
    };
    let books: Vec<(String, Vec<u8>)> = changed
        .iter()
        .enumerate()
        .map(|(at, (kind, changes))| {
            let (kind, case) = case_of(kind);
            let bytes = written(common::shipped(kind, case, Language::En), Tables::Live, Language::En);
            let change = |bytes: Vec<u8>, (_, name, value): &Change| {
                let text = match value {
                    Value::Real(value) => value.to_string(),
                    Value::Whole(value) => value.to_string(),
                    _ => unreachable!("numbers alone"),
                };
                with(&bytes, &cell_of(&bytes, name), &format!("><v>{text}</v>"))
            };
            (format!("pipe-{at}"), changes.iter().fold(bytes, change))
        })
        .collect();
    for ((kind, changes), mut book) in changed.iter().zip(recalculated(folder.path(), false, &books)) {
        let (kind, case) = case_of(kind);
        let own: Vec<_> = changes.iter().map(|(key, _, value)| (*key, value.clone())).collect();
        let outcome = common::outcome_of(kind, case, Language::En, &own);
        let count = compared(&mut book, &outcome, Language::En, |_, _| false);
        assert!(count > 150, "{own:?}: {count} cells");
        let grown = own.contains(&("N", Value::Whole(80)));
        for sheet in ["Template", "Arcs"].into_iter().filter(|_| kind.form().kind == "pipe-insert") {
            let told = range(&mut book, sheet).get_value((1, 0)).map(ToString::to_string).unwrap_or_default();
            assert_eq!(told.contains("the print ends at row"), grown, "{own:?}, {sheet}: {told}");
        }
    }
}

/// The table of the guard: what was changed, and whether it is seen.
#[test]
fn the_guard_sees_every_change_of_an_input_and_none_where_there_is_none() {
    if !libreoffice() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let bytes = written(&common::outcome("tfg-2021", &[]), Tables::Live, Language::En);
    let text = |text: &str| format!(" t=\"inlineStr\"><is><t xml:space=\"preserve\">{text}</t></is>");
    let value = |text: &str| format!("><v>{text}</v>");
    let empty = || ">".to_owned();
    // Each input has a flag of its own: a book holds one change of each.
    let changes: [Vec<(&str, String, f64)>; 5] = [
        vec![
            ("torus_R", value("25"), 0.0),
            ("end_backoff_eps_v", value("0"), 1.0),
            ("X_min", value("0"), 1.0),
            ("splitters", text("Yes"), 1.0),
        ],
        vec![
            ("torus_R", value("25.0000000001"), 1.0),
            ("end_backoff_eps_v", empty(), 1.0),
            ("X_min", text(" "), 1.0),
            ("splitters", text("yes "), 1.0),
        ],
        vec![("torus_R", value("25.0000000000001"), 1.0), ("splitters", text("yes\u{a0}"), 1.0)],
        vec![("torus_R", text("25"), 1.0), ("splitters", text("yes"), 0.0)],
        vec![("torus_R", empty(), 1.0)],
    ];
    let books: Vec<(String, Vec<u8>)> = changes
        .iter()
        .enumerate()
        .map(|(at, changes)| {
            let change =
                |book: Vec<u8>, (name, inner, _): &(&str, String, f64)| with(&book, &cell_of(&bytes, name), inner);
            (format!("guard-{at}"), changes.iter().fold(bytes.clone(), change))
        })
        .chain(std::iter::once((
            "name-gone".to_owned(),
            Parts::of(&bytes)
                .replace("xl/workbook.xml", "<definedName name=\"torus_R\">", "<definedName name=\"torus_Q\">")
                .zip(),
        )))
        .collect();
    let mut books = recalculated(folder.path(), false, &books);
    for (changes, book) in changes.iter().zip(&mut books) {
        let sheet = range(book, SHEET);
        for (name, inner, wanted) in changes {
            let row = sheet.rows().find(|row| row[0] == *name).expect("the input's row");
            assert!(number(row.get(2)).is_some_and(|flag| (flag - wanted).abs() < 0.5), "{name} {inner}: {row:?}");
        }
        let count: f64 = changes.iter().map(|(.., wanted)| wanted).sum();
        assert!((stale(book) - count).abs() < 0.5, "{changes:?}: {}", stale(book));
    }
    assert!(stale(books.last_mut().expect("the last book")) > 0.5, "a name that is gone");
}

#[test]
fn the_form_computes_its_limits_and_names_the_one_that_is_broken() {
    if !libreoffice() {
        return;
    }
    let kind = *KINDS.iter().find(|kind| kind.form().kind == "impeller").expect("the impeller");
    let case = kind.cases().iter().find(|case| case.name == "tfg-2021").expect("the published case");
    for language in Language::ALL {
        let folder = tempfile::tempdir().expect("a folder");
        let mut out = std::io::Cursor::new(Vec::new());
        let (values, lists) = (case.values(language), (case.listed)(language));
        template::write(kind, &values, &lists, &case.note, language, &mut out).expect("a form");
        let form = out.into_inner();
        let data = if language == Language::Es { "DATOS" } else { "DATA" };
        let many = with_on(&form, data, &cell_of(&form, "blades_N"), "><v>9</v>");
        let empty = with_on(&form, data, &cell_of(&form, "meridian_r"), ">");
        let closed = with_on(&form, data, &cell_of(&form, "meridian_r"), "><v>30</v>");
        let names = ["sound", "many", "empty", "closed"].map(str::to_owned);
        let books: Vec<_> = names.into_iter().zip([form.clone(), many, empty, closed]).collect();
        let mut books = recalculated(folder.path(), language == Language::Es, &books);
        let outcome = common::outcome("tfg-2021", &[]);
        for (symbol, name) in [
            ("L", "live_L"),
            ("k", "live_k"),
            ("w", "live_w"),
            ("N_max", "live_N_max"),
            ("e_max", "live_e_max"),
            ("gap", "live_gap"),
        ] {
            let value = outcome.quantities.iter().find(|one| one.symbol == symbol).expect("a quantity").value;
            let place = place_of(&cell_of(&form, name));
            let there = number(range(&mut books[0], data).get_value(place)).expect("a number");
            assert!((there - value).abs() <= TOLERANCE * value.abs().max(1.0), "{name}: {value}, {there}");
        }
        let said = |book: &mut Book| range(book, data).get_value((0, 2)).map(ToString::to_string).unwrap_or_default();
        let told = books.iter_mut().map(said).collect::<Vec<_>>();
        let words = match language {
            Language::En => [
                "rodete check checks the rest",
                "): the gap is too narrow for the tool (+2)",
                "no numbers: 1",
                "): R must be larger than r",
            ],
            Language::Es => [
                "rodete check comprueba lo demás",
                "): la separación es demasiado estrecha para la herramienta (+2)",
                "no son números: 1",
                "): R debe ser mayor que r",
            ],
        };
        for (told, words) in told.iter().zip(words) {
            assert!(told.contains(words), "{told}");
        }
        // The view stays within the circle of the part, however many blades there are.
        for book in &mut books {
            let plan = range(book, "Plan");
            let points = plan.used_cells().filter(|(_, column, _)| *column >= 6);
            for (.., cell) in points {
                assert!(number(Some(cell)).is_none_or(|at| at.abs() < 1.1), "{cell}");
            }
        }
        let taken = workbook::read(&form, &[kind.form()]).expect("the form is an input");
        assert!(taken.findings.is_empty(), "{:?}", taken.findings);
    }
}

/// Row and column of a cell, from 0.
pub fn place_of(cell: &str) -> (u32, u32) {
    let letters = cell.chars().take_while(char::is_ascii_alphabetic);
    let column = letters.fold(0, |sum, one| 26 * sum + u32::from(one) - u32::from('A') + 1);
    let row: u32 = cell.trim_start_matches(|one: char| one.is_ascii_alphabetic()).parse().expect("a row");
    (row - 1, column - 1)
}

#[test]
fn the_names_of_a_results_workbook_are_names_in_every_spreadsheet() {
    for (kind, case, language) in common::cases() {
        let bytes = written(common::shipped(kind, case, language), Tables::Live, language);
        let listed = Parts::of(&bytes).text("xl/workbook.xml");
        let mut names: Vec<String> = listed
            .split("<definedName name=\"")
            .skip(1)
            .filter_map(|rest| rest.split_once('"'))
            .filter(|(name, _)| !name.starts_with("_xlnm."))
            .map(|(name, _)| name.to_lowercase())
            .collect();
        assert!(names.contains(&STALE.to_owned()), "{kind:?}");
        for name in &names {
            let letters = name.chars().take_while(char::is_ascii_alphabetic).count();
            let digits = name.chars().skip(letters).all(|one| one.is_ascii_digit());
            let cell = (1..=3).contains(&letters) && digits && letters < name.len();
            // In a Spanish Excel the words for row and column begin with F and C.
            let mut relative = name.trim_start_matches(['r', 'f', 'c']).chars();
            let row_and_column =
                name.starts_with(['r', 'f', 'c']) && relative.next().is_none_or(|one| one.is_ascii_digit());
            assert!(!cell && !row_and_column, "{kind:?}: {name}");
        }
        let count = names.len();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), count, "{kind:?}: two names differ in capitals alone");
    }
}

#[test]
fn beyond_four_hundred_intervals_and_on_request_the_tables_are_values() {
    let live = |bytes: &[u8]| {
        let parts = Parts::of(bytes);
        (1..60)
            .map(|at| format!("xl/worksheets/sheet{at}.xml"))
            .filter(|part| parts.has(part))
            .map(|part| parts.text(&part).matches("torus_R").count())
            .sum::<usize>()
    };
    let many = common::outcome("tfg-2021", &[("n", Value::Whole(401))]);
    let most = common::outcome("tfg-2021", &[("n", Value::Whole(400))]);
    assert!(live(&written(&most, Tables::Live, Language::En)) > 1_000);
    // The guard's own row stays.
    assert!(live(&written(&many, Tables::Live, Language::En)) < 10);
    assert!(live(&written(&most, Tables::Values, Language::En)) < 10);
}

/// The sheets of a book by their names.
fn sheet_names(bytes: &[u8]) -> Vec<String> {
    let listed = Parts::of(bytes).text("xl/workbook.xml");
    let names = listed.split("<sheet name=\"").skip(1).filter_map(|rest| rest.split('"').next().map(str::to_owned));
    names.collect()
}

#[test]
fn values_say_that_they_are_values_and_no_sheet_computes_blocks() {
    let many = common::outcome("tfg-2021", &[("n", Value::Whole(401))]);
    let few = common::outcome("tfg-2021", &[]);
    let folder = tempfile::tempdir().expect("a folder");
    let told = |bytes: &[u8], language: Language| -> [String; 3] {
        let path = folder.path().join("values.xlsx");
        std::fs::write(&path, bytes).expect("a file");
        let mut book: Book = open_workbook(&path).expect("a workbook");
        let [annex, crossing, first] = match language {
            Language::En => ["Annex 6", "Intersection", "SUMMARY"],
            Language::Es => ["Anexo 6", "Intersección", "RESUMEN"],
        };
        let banner = |range: &Range<Data>| range.get_value((1, 0)).map(ToString::to_string).unwrap_or_default();
        let banners = [annex, crossing].map(|name| banner(&range(&mut book, name)));
        let summary = range(&mut book, first);
        let label = if language == Language::Es { "Tablas" } else { "Tables" };
        let row = summary.rows().find(|row| row[0] == *label);
        let [annex, crossing] = banners;
        [annex, crossing, row.map(|row| row[1].to_string()).unwrap_or_default()]
    };
    for (language, asked, long) in [
        (Language::En, "Values (--values): they do not follow the inputs", "Values (more than 400 intervals)"),
        (Language::Es, "Valores (--values): no siguen a los datos", "Valores (más de 400 intervalos)"),
    ] {
        let lines = |bytes: &[u8]| {
            let names = sheet_names(bytes);
            names.iter().filter(|name| name.starts_with("Lines ") || name.starts_with("Líneas ")).count()
        };
        let live = written(&few, Tables::Live, language);
        assert_eq!(lines(&live), 2);
        assert!(told(&live, language).iter().all(|one| !one.contains("400") && !one.contains("--values")));
        for (bytes, words) in
            [(written(&few, Tables::Values, language), asked), (written(&many, Tables::Live, language), long)]
        {
            assert_eq!(lines(&bytes), 0, "{words}");
            let told = told(&bytes, language);
            assert!(told.iter().all(|one| one.starts_with(words)), "{told:?}");
        }
    }
}

#[test]
fn a_count_of_intervals_that_is_none_or_has_no_rows_leaves_cells_empty_and_without_errors() {
    if !libreoffice() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let typed = |value: &str| match value {
        "" => ">".to_owned(),
        "x" => " t=\"inlineStr\"><is><t>x</t></is>".to_owned(),
        number => format!("><v>{number}</v>"),
    };
    let pipe = |kind: &str| {
        let kind = *KINDS.iter().find(|one| one.form().kind == kind).expect("a kind");
        common::outcome_of(kind, &kind.cases()[0], Language::En, &[])
    };
    let outcomes = [
        ("intervals_n", "Annex 6", common::outcome("tfg-2021", &[])),
        ("divisions_N", "Template", pipe("pipe-insert")),
        ("divisions_N", "Curve", pipe("pipe-hole")),
    ];
    const COUNTS: [&str; 5] = ["0", "", "x", "2.5", "390"];
    let books: Vec<(String, Vec<u8>)> = outcomes
        .iter()
        .enumerate()
        .flat_map(|(at, (name, _, outcome))| {
            let bytes = written(outcome, Tables::Live, Language::En);
            let cell = cell_of(&bytes, name);
            let of = |(number, value): (usize, &&str)| (format!("n-{at}-{number}"), with(&bytes, &cell, &typed(value)));
            COUNTS.iter().enumerate().map(of).collect::<Vec<_>>()
        })
        .collect();
    let mut computed = recalculated(folder.path(), false, &books).into_iter();
    for ((name, _, outcome), books) in outcomes.iter().zip(books.chunks(COUNTS.len())) {
        let tables: Vec<&str> = outcome.tables.iter().map(|table| table.name.get(Language::En)).collect();
        for ((called, _), mut book) in books.iter().zip(computed.by_ref()) {
            let long = called.ends_with("-4");
            let mut ends = 0;
            for table in &tables {
                let sheet = range(&mut book, table);
                let wrong = |cell: &Data| matches!(cell, Data::Error(_)) || cell.to_string().starts_with('#');
                let wrong = sheet.used_cells().find(|(.., cell)| wrong(cell));
                assert_eq!(wrong, None, "{name} {called}: {table}");
                ends += sheet.used_cells().filter(|(.., cell)| cell.to_string().starts_with("the rows end")).count();
            }
            // Every table whose rows follow the count says so.
            let follows = |table: &&Table| matches!(table.index, Index::Intervals { .. } | Index::Within { .. });
            let wanted = if long { outcome.tables.iter().filter(follows).count() } else { 0 };
            assert_eq!(ends, wanted, "{name} {called}");
            // What charts draw is left out by them.
            let curves = range(&mut book, "Curves");
            let drawn = curves.used_cells().filter(|(row, ..)| *row > 0);
            assert!(
                drawn.clone().count() > 0
                    && drawn.clone().map(|(.., cell)| cell.to_string()).all(|cell| cell == "#N/A"),
                "{called}"
            );
            assert!((stale(&mut book) - 1.0).abs() < 0.5, "{called}");
        }
    }
}

/// Of another nominal size no formula knows the diameter: nothing of before is shown in its place.
#[test]
fn a_nominal_size_changed_in_the_results_leaves_no_figure_of_the_old_one() {
    if !libreoffice() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let (mut books, mut places) = (Vec::new(), Vec::new());
    for (kind, derived) in [("pipe-insert", "derived_branch_r"), ("pipe-hole", "derived_hole_r")] {
        let own = *KINDS.iter().find(|one| one.form().kind == kind).expect("a kind");
        let bytes = written(common::shipped(own, &own.cases()[0], Language::En), Tables::Live, Language::En);
        let size = with(&bytes, &cell_of(&bytes, "branch_size"), " t=\"inlineStr\"><is><t>1/2 in</t></is>");
        let typed = with(&size, &cell_of(&size, "branch_diameter_D"), "><v>60.5</v>");
        let typed = with(&typed, &cell_of(&typed, "branch_wall_t"), "><v>4</v>");
        books.extend([(format!("{kind}-size"), size), (format!("{kind}-typed"), typed)]);
        places.push((kind, place_of(&cell_of(&bytes, derived))));
    }
    let mut books = recalculated(folder.path(), false, &books);
    for ((kind, place), books) in places.into_iter().zip(books.chunks_mut(2)) {
        let mut shown = |at: usize| range(&mut books[at], "SUMMARY").get_value(place).cloned().expect("a value");
        assert_eq!(shown(0).to_string(), "#N/A", "{kind}");
        assert!(number(Some(&shown(1))).is_some_and(|radius| (24.0..34.0).contains(&radius)), "{kind}: {}", shown(1));
    }
}

#[test]
fn charts_leave_the_splitters_out_as_soon_as_the_part_has_none() {
    if !libreoffice() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let bytes = written(&common::outcome("tfg-2021", &[]), Tables::Live, Language::En);
    let books = ["yes", "no"].map(|word| {
        let inner = format!(" t=\"inlineStr\"><is><t>{word}</t></is>");
        (word.to_owned(), with(&bytes, &cell_of(&bytes, "splitters"), &inner))
    });
    for ((word, _), mut book) in books.iter().zip(recalculated(folder.path(), false, &books)) {
        let curves = range(&mut book, "Curves");
        let (mut left, mut drawn) = (0, 0);
        for (_, column, cell) in curves.used_cells().filter(|(row, ..)| *row > 0) {
            let name = curves.get_value((0, u32::try_from(column).expect("a column"))).expect("a name").to_string();
            let splitter = ["intersection ", "splitter "].iter().any(|table| name.starts_with(table));
            let shown = cell.to_string();
            let nothing = shown == "#N/A";
            assert_eq!(nothing, splitter && word == "no", "{name}: {shown}");
            if nothing { left += 1 } else { drawn += 1 }
        }
        assert!(drawn > 500 && (left > 500) == (word == "no"), "{word}: {left}, {drawn}");
    }
}
