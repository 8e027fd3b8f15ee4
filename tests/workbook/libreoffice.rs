//! LibreOffice opens the workbooks, finds no error in any cell, and keeps values and defined names.

use crate::common;

use std::collections::BTreeMap;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use calamine::{Data, Reader, Xlsx, open_workbook};
use rodete::kinds::lathe::{Lathe, cases as lathe_cases, parameters as lathe};
use rodete::machine::length_unit::LengthUnit;
use rodete::machine::var_file::VarFile;
use rodete::parameter::Value;
use rodete::parameter::list::{Row, Rows};
use rodete::text::Language;
use rodete::workbook::offsets_table::OffsetsTable;
use rodete::workbook::results::Tables;
use rodete::workbook::{self, offsets_sheet, results, template};

/// LibreOffice takes a second or two, and less than one a workbook; a hang is ended after this many.
const DEADLINE: &str = "300";
/// The filter for workbooks.
pub const EXCEL: &str = "xlsx:Calc MS Excel 2007 XML";

/// True where LibreOffice can be called. Where it must be there, its absence fails the test.
pub fn libreoffice() -> bool {
    let found = Command::new("soffice").arg("--version").output().is_ok_and(|output| output.status.success());
    if !found {
        assert!(std::env::var_os("CI").is_none(), "LibreOffice (soffice) is needed here and cannot be called");
        // Not through the macros, whose output a passing test keeps to itself.
        let _ = writeln!(
            std::io::stderr(),
            "\n*** LibreOffice (soffice) is not installed: NOT TESTED that it opens the workbooks ***\n"
        );
    }
    found
}

/// Converts the files of a folder, at once, as starting takes most of the time; returns the paths of what was made, in their order.
fn converted(files: &[PathBuf], filter: &str, extension: &str) -> Vec<PathBuf> {
    converted_with(files, filter, extension, None)
}

/// The same with settings of LibreOffice's own.
pub fn converted_with(files: &[PathBuf], filter: &str, extension: &str, settings: Option<&str>) -> Vec<PathBuf> {
    let folder = files[0].parent().expect("a folder");
    let out = folder.join("out");
    if let Some(settings) = settings {
        let user = folder.join("profile/user");
        std::fs::create_dir_all(&user).expect("a profile");
        std::fs::write(user.join("registrymodifications.xcu"), settings).expect("its settings");
    }
    let output = Command::new("timeout")
        .args(["-k", "5", DEADLINE, "soffice"])
        // A profile of its own: a running LibreOffice would take the work over, or a second one wait for it.
        .arg(format!("-env:UserInstallation=file://{}", folder.join("profile").display()))
        .args(["--headless", "--convert-to", filter, "--outdir"])
        .arg(&out)
        .args(files)
        .output()
        .expect("LibreOffice can be called");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let made = files.iter().map(|file| out.join(file.with_extension(extension).file_name().expect("a name")));
    let made: Vec<_> = made.collect();
    for path in &made {
        assert!(path.exists(), "{}: {}", path.display(), String::from_utf8_lossy(&output.stderr));
    }
    made
}

/// The workbooks that rodete writes, by file name.
fn workbooks(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    let mut create = |name: String| {
        let path = folder.join(name);
        files.push(path.clone());
        std::fs::File::create(path).expect("a file")
    };
    let hostile = ("part", Value::Line("=1/0 & <b> \u{7} +álabe".to_owned()));
    // Each case has its form in one language and its results in the other.
    for (kind, case, language) in common::alternating(Language::Es) {
        let to = create(format!("{kind:?}-{}-{}.xlsx", case.name, language.code()));
        let (values, lists) = (case.values(language), (case.listed)(language));
        template::write(kind, &values, &lists, &case.note, language, to).expect("a form");
    }
    for (kind, case, language) in common::alternating(Language::En) {
        let name = format!("{kind:?}-{}-{}", case.name, language.code());
        let outcome = common::outcome_of(kind, case, language, std::slice::from_ref(&hostile));
        results::write(&outcome, &[], Tables::Live, language, create(format!("{name}-results.xlsx"))).expect("results");
    }
    for language in Language::ALL {
        let unit = LengthUnit::Inch;
        let to = create(format!("offsets-{}.xlsx", language.code()));
        offsets_sheet::write(&var_file(), unit, "a.var", language, to).expect("offsets");
    }
    files
}

/// Offsets whose every value is another.
fn var_file() -> VarFile {
    let mut file = VarFile::default();
    file.complete();
    let numbers: Vec<u32> = file.iter().map(|(number, _)| number).filter(|number| *number > 5220).collect();
    for (number, at) in numbers.into_iter().zip(1..) {
        file.set(number, f64::from(at) / 7.0).expect("a parameter");
    }
    file.set(5220, 7.0).expect("a parameter");
    file
}

#[test]
fn offsets_come_back_from_libreoffice_to_the_last_digit() {
    if !libreoffice() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("offsets.xlsx");
    let to = std::fs::File::create(&path).expect("a file");
    let file = var_file();
    offsets_sheet::write(&file, LengthUnit::Inch, "a.var", Language::Es, to).expect("offsets");
    let made = converted(&[path], EXCEL, "xlsx");
    let made = std::fs::read(&made[0]).expect("LibreOffice's workbook");
    let table = OffsetsTable::read(&made, LengthUnit::Inch).expect("the sheet");
    let mut back = VarFile::default();
    back.complete();
    table.apply(&mut back).expect("values of a var file");
    assert_eq!(back.text(), file.text());
}

#[test]
fn the_lists_of_a_lathe_come_back_from_libreoffice_row_by_row() {
    if !libreoffice() {
        return;
    }
    // What a spreadsheet would take for a number, a formula, a date or a share, if it were not text.
    let odd = ["%", "=1/0", "0001", "1E5", "+G1", "-5", "1/2", "12:30", "TRUE", "'N5", "#1=2", "X1,5", "(ángulo φ)"];
    let block = |text: &&str| Row {
        values: [("program/BLOCK", Value::Line((*text).to_owned()))].into(),
        cells: BTreeMap::new(),
    };
    let folder = tempfile::tempdir().expect("a folder");
    let mut files = Vec::new();
    for (case, language) in lathe_cases::CASES.iter().flat_map(|case| Language::ALL.map(|language| (case, language))) {
        let path = folder.path().join(format!("{}-{}.xlsx", case.name, language.code()));
        let mut lists = (case.listed)(language);
        lists.push(Rows { list: "subprogram", sheet: "O0005".to_owned(), rows: odd.iter().map(block).collect() });
        let to = std::fs::File::create(&path).expect("a file");
        template::write(&Lathe, &case.values(language), &lists, &case.note, language, to).expect("a form");
        files.push(path);
    }
    let read = |path: &Path| {
        let bytes = std::fs::read(path).expect("a workbook");
        workbook::read(&bytes, &[&lathe::FORM]).expect("a sound workbook").values
    };
    for (path, made) in files.iter().zip(converted(&files, EXCEL, "xlsx")) {
        let (before, after) = (read(path), read(&made));
        assert_eq!(before.values, after.values);
        assert!(before.lists.len() >= 3 && before.lists.iter().any(|rows| rows.rows.len() == odd.len()));
        assert_eq!(before.lists, after.lists, "{path:?}");
    }
}

#[test]
fn libreoffice_finds_no_error_in_any_workbook() {
    if !libreoffice() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let files = workbooks(folder.path());
    for (file, made) in files.iter().zip(converted(&files, EXCEL, "xlsx")) {
        let mut before: Xlsx<_> = open_workbook(file).expect("our workbook");
        let mut after: Xlsx<_> = open_workbook(made).expect("LibreOffice's workbook");
        assert_eq!(before.sheet_names(), after.sheet_names());
        for name in before.sheet_names() {
            let ours = before.worksheet_range(&name).expect("our sheet");
            let theirs = after.worksheet_range(&name).expect("LibreOffice's sheet");
            for (row, column, cell) in ours.used_cells() {
                let (top, left) = ours.start().expect("a first cell");
                let place = (top + u32::try_from(row).expect("a row"), left + u32::try_from(column).expect("a column"));
                match (cell, theirs.get_value(place)) {
                    // Rows that are prepared for more points show nothing.
                    (Data::String(ours), _) if ours.trim().is_empty() => {}
                    (Data::Float(ours), Some(Data::Float(theirs))) => {
                        assert!((ours - theirs).abs() <= 1e-14 * ours.abs(), "{file:?}, {name}, {place:?}");
                    }
                    (Data::String(ours), Some(Data::String(theirs))) => {
                        // LibreOffice drops control characters.
                        let seen = |text: &str| text.chars().filter(|one| !one.is_control()).collect::<String>();
                        assert_eq!(seen(ours), seen(theirs), "{file:?}, {name}, {place:?}");
                    }
                    (Data::Bool(ours), Some(Data::Bool(theirs))) => {
                        assert_eq!(ours, theirs, "{file:?}, {name}, {place:?}");
                    }
                    (ours, theirs) => panic!("{file:?}, {name}, {place:?}: {ours:?} became {theirs:?}"),
                }
            }
            let wrong = |cell: &Data| match cell {
                Data::Error(_) => true,
                Data::String(text) => text.starts_with("Err:") || text.starts_with("#NAME?"),
                _ => false,
            };
            assert!(!theirs.used_cells().any(|(.., cell)| wrong(cell)), "{file:?}, {name}: an error cell");
        }
        let names = |workbook: &Xlsx<_>| {
            let mut names: Vec<String> = workbook.defined_names().iter().map(|(name, _)| name.clone()).collect();
            names.retain(|name| !name.starts_with("_xlnm"));
            names.sort();
            names
        };
        assert_eq!(names(&before), names(&after), "{file:?}");
    }
}

#[test]
fn libreoffice_prints_the_results() {
    if !libreoffice() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("results.xlsx");
    let outcome = common::outcome("full", &[]);
    results::write(&outcome, &[], Tables::Live, Language::Es, std::fs::File::create(&file).expect("a file"))
        .expect("results");
    let pdf = std::fs::read(&converted(&[file], "pdf", "pdf")[0]).expect("the pages");
    assert!(pdf.starts_with(b"%PDF"));
}
