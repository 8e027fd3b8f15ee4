//! Other programs open the books and save them; the next build finds its sheets again.

use std::io::Write;
use std::path::Path;
use std::process::Command;

use calamine::Data;
use rodete::kinds::KINDS;

use super::made::{BOOKS, Results, book, differing, host, kept, read, values, with_form};

/// A hang is ended after this many seconds.
const DEADLINE: &str = "300";

/// True where LibreOffice can be called. Where it must be there, its absence fails the test.
pub fn libreoffice() -> bool {
    let found = Command::new("soffice").arg("--version").output().is_ok_and(|output| output.status.success());
    if !found {
        assert!(std::env::var_os("CI").is_none(), "LibreOffice (soffice) is needed here and cannot be called");
        let _ = writeln!(
            std::io::stderr(),
            "\n*** LibreOffice (soffice) is not installed: NOT TESTED that it opens books with sheets put in ***\n"
        );
    }
    found
}

/// Books as LibreOffice saves them, every formula computed again.
pub fn saved(books: &[(&str, Vec<u8>)]) -> Vec<Vec<u8>> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let profile = folder.path().join("profile/user");
    std::fs::create_dir_all(&profile).expect("a profile");
    let settings = "<?xml version=\"1.0\" encoding=\"UTF-8\"?><oor:items xmlns:oor=\"http://openoffice.org/2001/registry\"><item \
                    oor:path=\"/org.openoffice.Office.Calc/Formula/Load\"><prop oor:name=\"OOXMLRecalcMode\" oor:op=\"fuse\"><value>0</value></prop></item></oor:items>";
    std::fs::write(profile.join("registrymodifications.xcu"), settings).expect("settings");
    let files: Vec<_> = books
        .iter()
        .map(|(name, bytes)| {
            let path = folder.path().join(name).with_extension("xlsx");
            std::fs::write(&path, bytes).expect("a book");
            path
        })
        .collect();
    let output = Command::new("timeout")
        .args(["-k", "5", DEADLINE, "soffice"])
        .arg(format!("-env:UserInstallation=file://{}", folder.path().join("profile").display()))
        .args(["--headless", "--convert-to", "xlsx:Calc MS Excel 2007 XML", "--outdir"])
        .arg(folder.path().join("out"))
        .args(&files)
        .output()
        .expect("LibreOffice can be called");
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{told}");
    let made = |file: &std::path::PathBuf| folder.path().join("out").join(file.file_name().expect("a name"));
    files
        .iter()
        .map(|file| std::fs::read(made(file)).unwrap_or_else(|_| panic!("{}: {told}", file.display())))
        .collect()
}

/// True where two values are the same to the digits that LibreOffice writes.
fn same(one: &Data, other: &Data) -> bool {
    match (one, other) {
        (Data::Float(one), Data::Float(other)) => (one - other).abs() <= 1e-12 * one.abs().max(1.0),
        (Data::String(one), Data::Empty) | (Data::Empty, Data::String(one)) => one.is_empty(),
        // An end of line is written one way here and another there.
        (Data::String(one), Data::String(other)) => one.replace("\r\n", "\n") == other.replace("\r\n", "\n"),
        (one, other) => one == other,
    }
}

fn compare(book: &str, saved: &[u8], results: &Results) {
    let mut compared = 0;
    for ((sheet, was), (_, is)) in values(&results.bytes, results.sheets()).iter().zip(&values(saved, results.sheets()))
    {
        for (row, column, value) in was.used_cells() {
            let (top, left) = was.start().expect("a cell");
            let at = (top + u32::try_from(row).expect("a row"), left + u32::try_from(column).expect("a column"));
            let found = is.get_value(at).unwrap_or(&Data::Empty);
            // Rows that are prepared for more points show nothing.
            if value.to_string().trim().is_empty() {
                continue;
            }
            assert!(same(value, found), "{book}, {sheet}, {at:?}: {value:?} and {found:?}");
            compared += 1;
        }
    }
    assert!(compared > 1000, "{book}: {compared} values");
}

#[test]
fn libreoffice_finds_every_value_and_the_next_build_finds_its_sheets() {
    if !libreoffice() {
        return;
    }
    let built: Vec<(&str, Vec<u8>, Results)> = BOOKS
        .into_iter()
        .map(|name| {
            let formed = with_form(KINDS[0], &book(name));
            let results = Results::of(&formed);
            (name, results.put_into(&formed), results)
        })
        .collect();
    let books: Vec<(&str, Vec<u8>)> = built.iter().map(|(name, bytes, _)| (*name, bytes.clone())).collect();
    for ((name, bytes, results), saved) in built.iter().zip(saved(&books)) {
        compare(name, &saved, results);
        assert_eq!(host(&saved).present().taken, host(bytes).present().taken, "{name}");
        assert_eq!(read(&saved).values.values, read(bytes).values.values, "{name}");
        let again = Results::of(&saved);
        assert_eq!(again.made, results.made, "{name}: each sheet is found again");
        replaced_in(name, &saved, &again);
    }
}

/// Builds into a book that another program saved, twice, and compares.
fn replaced_in(name: &str, saved: &[u8], again: &Results) {
    let once = again.put_into(saved);
    let twice = again.put_into(&once);
    // Books that were saved before results had them get the sheets of the guard, of the charts' points and of a branch's seat.
    let without = |bytes: &[u8]| {
        let mut taken = host(bytes).present().taken;
        taken.retain(|sheet| !["Verified", "Curves", "Seat"].contains(&sheet.as_str()));
        taken
    };
    assert_eq!(without(&once), without(saved), "{name}: no sheet twice");
    assert_eq!(values(&once, again.sheets()), values(&again.bytes, again.sheets()), "{name}");
    assert!(once == twice, "{name}: nothing grows after another program has saved it");
    // What was not made by rodete keeps its bytes; the parts of its sheets have other names then.
    let ours = differing(&kept(saved), &kept(&once));
    let own = |part: &String| {
        part.starts_with("xl/worksheets/sheet") || part.starts_with("xl/drawings/") || part.starts_with("xl/charts/")
    };
    assert!(ours.iter().all(|part| own(part) || part.starts_with("xl/worksheets/_rels/")), "{name}: {ours:?}");
}

#[test]
fn a_book_that_openpyxl_saved_is_built_again() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/graft/books/openpyxl.xlsx");
    let saved = std::fs::read(path).expect("the book");
    let again = Results::of(&saved);
    assert!(host(&saved).present().ours.len() > 5, "its sheets are found");
    replaced_in("openpyxl", &saved, &again);
}
