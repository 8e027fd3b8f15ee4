//! `new --into` and `build --into` as they are typed.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use predicates::prelude::*;
use rodete::workbook::gate;
use tempfile::TempDir;

use super::common::workbook::Parts;
use super::made::{BOOKS, book, differing, kept, parts, path};

fn folder() -> TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

fn rodete(folder: &TempDir) -> Command {
    let mut command = Command::cargo_bin("rodete").expect("the binary");
    command.current_dir(folder.path()).env_remove("RODETE_TYPST").env("LC_ALL", "C");
    command
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut names: Vec<_> =
        entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn new_refuses_a_name_that_results_need() {
    let folder = folder();
    let here = folder.path().join("own.xlsx");
    rodete(&folder).args(["new", "impeller", "--case", "full", "own.xlsx"]).assert().code(0);
    rodete(&folder).args(["build", "own.xlsx", "-o", "out", "--no-report"]).assert().code(0);
    let results = Parts::of(&fs::read(folder.path().join("out/own-results.xlsx")).expect("results"));
    let listed = results.text("xl/workbook.xml");
    let names = listed.split("<definedName name=\"").skip(1).filter_map(|one| one.split('"').next());
    let names: Vec<&str> =
        names.filter(|one| ["derived_", "stale_", "build_"].iter().any(|of| one.starts_with(of))).collect();
    assert!(names.len() > 10 && names.contains(&"derived_L"), "{names:?}");
    for name in names {
        let own = book("h1.xlsx");
        let defined = format!("<definedName name=\"{name}\">42</definedName></definedNames>");
        let own = Parts::of(&own).replace("xl/workbook.xml", "</definedNames>", &defined).zip();
        fs::write(&here, &own).expect("a book");
        rodete(&folder).args(["new", "impeller", "--into", "own.xlsx"]).assert().code(3).stderr(
            predicate::str::contains(format!(
                "B0112: the workbook's name {name} already stands for something else: 42"
            )),
        );
        assert_eq!(fs::read(&here).expect("the book"), own);
    }
}

#[test]
fn a_sheet_of_the_owner_is_not_taken_for_the_form_by_its_name() {
    let folder = folder();
    let mut own = rust_xlsxwriter::Workbook::new();
    own.add_worksheet().set_name("Data").expect("a name").write(0, 0, "Prices").expect("a cell");
    own.save(folder.path().join("own.xlsx")).expect("a book");
    rodete(&folder)
        .args(["check", "own.xlsx"])
        .assert()
        .code(3)
        .stderr(predicate::str::contains("W0505").and(predicate::str::contains("rename").not()));
}

/// A sheet of the owner has the name of the form's: what `check` says to do helps.
#[test]
fn beside_a_sheet_of_the_owner_with_the_name_of_the_form_one_is_put_in() {
    let folder = folder();
    let mut own = rust_xlsxwriter::Workbook::new();
    own.add_worksheet().set_name("DATA").expect("a name").write(0, 0, "Prices").expect("a cell");
    own.save(folder.path().join("own.xlsx")).expect("a book");
    rodete(&folder)
        .args(["check", "own.xlsx"])
        .assert()
        .code(3)
        .stderr(predicate::str::contains("W0511").and(predicate::str::contains("rodete new KIND --into BOOK")));
    rodete(&folder).args(["new", "impeller", "--into", "own.xlsx"]).assert().code(0);
    rodete(&folder).args(["check", "own.xlsx"]).assert().code(0);
}

/// What is wrong is told in the language of the form that is read, not in that of a sheet's name that is the owner's.
#[test]
fn a_rejected_form_is_told_in_its_own_language_beside_a_sheet_of_the_owner() {
    for (lang, theirs, said) in [("es", "DATA", "y debe ser"), ("en", "DATOS", "it must be")] {
        let folder = folder();
        let here = folder.path().join("own.xlsx");
        let mut own = rust_xlsxwriter::Workbook::new();
        own.add_worksheet().set_name(theirs).expect("a name").write(0, 0, "Prices").expect("a cell");
        own.save(&here).expect("a book");
        rodete(&folder).args(["new", "pipe-insert", "--into", "own.xlsx", "--lang", lang]).assert().code(0);
        let sound = fs::read(&here).expect("the book");
        let at = super::made::read(&sound).values.cells["contact"].cell.clone();
        let sheets = parts(&sound);
        let is_form = |text: &[u8]| String::from_utf8_lossy(text).contains(">contact</t>");
        let part = sheets.iter().find(|(name, text)| name.starts_with("xl/worksheets/") && is_form(text));
        let cell = format!("<c r=\"{at}\" t=\"inlineStr\"><is><t>xx</t></is></c>");
        fs::write(&here, Parts::of(&sound).cell(part.expect("the form").0, &at, &cell).zip()).expect("written");
        rodete(&folder).args(["check", "own.xlsx"]).assert().code(3).stderr(predicate::str::contains(said));
    }
}

/// The summary names the sheet of what was found as it is called in the book, whatever language it is in.
#[test]
fn the_summary_leads_to_the_sheet_of_the_findings_and_not_to_one_of_the_owner() {
    let folder = folder();
    let here = folder.path().join("own.xlsx");
    let mut own = rust_xlsxwriter::Workbook::new();
    own.add_worksheet().set_name("Avisos").expect("a name").write(0, 0, "Prices").expect("a cell");
    own.save(&here).expect("a book");
    rodete(&folder).args(["new", "impeller", "--case", "full", "--into", "own.xlsx", "--lang", "es"]).assert().code(0);
    for (lang, said) in [("es", "en la hoja Avisos (2)."), ("en", "Remedies and places: sheet Avisos (2).")] {
        rodete(&folder).args(["build", "own.xlsx", "--into", "--no-report", "--lang", lang]).assert().code(0);
        let sheets = parts(&fs::read(&here).expect("the book"));
        assert!(sheets.values().any(|text| String::from_utf8_lossy(text).contains(said)), "{said}");
    }
}

#[test]
fn a_form_and_its_results_go_into_every_hard_book_twice() {
    for name in BOOKS {
        let folder = folder();
        let here = folder.path().join(name);
        fs::copy(path(name), &here).expect("a copy");
        let before = fs::read(&here).expect("the book");
        rodete(&folder).args(["new", "impeller", "--case", "full", "--into", name]).assert().code(0);
        let formed = fs::read(&here).expect("the book");
        let stem = name.split('.').next().expect("a stem");
        let kept_book = format!("{name}.bak");
        let mut last = None;
        for _ in 0..3 {
            rodete(&folder)
                .args(["build", name, "--into", "--no-report"])
                .assert()
                .code(0)
                .stdout(predicate::str::contains(format!("4 files in {stem}-out, results in {name}")));
            let built = fs::read(&here).expect("the book");
            assert_eq!(differing(&kept(&before), &kept(&built)), Vec::<String>::new(), "{name}");
            let sheets = gate(&built).expect("a book").sheets;
            let grown = parts(&built).into_keys().collect::<Vec<_>>();
            if let Some((listed, there)) = last.replace((sheets.clone(), grown.clone())) {
                assert_eq!((listed, there), (sheets, grown), "{name}: nothing is added the next time");
            }
        }
        assert_eq!(fs::read(folder.path().join(&kept_book)).expect("a copy"), before, "{name}: kept once, as it was");
        assert_ne!(formed, before);
        assert_eq!(names(folder.path()), [format!("{stem}-out"), name.to_owned(), kept_book]);
        assert!(!folder.path().join(format!("{stem}-out/{stem}-results.xlsx")).exists());
    }
}

#[test]
fn a_sheet_of_variants_goes_in_with_its_form_and_into_a_form_that_is_there() {
    let folder = folder();
    fs::copy(path("h1.xlsx"), folder.path().join("h1.xlsx")).expect("a copy");
    rodete(&folder).args(["new", "impeller", "full.xlsx", "--case", "full", "--lang", "es"]).assert().code(0);
    for name in ["h1.xlsx", "full.xlsx"] {
        rodete(&folder)
            .args(["new", "impeller", "--sweep", "--into", name])
            .assert()
            .code(0)
            .stdout(predicate::str::ends_with(format!("then: rodete sweep {name}\n")));
        let sheets = gate(&fs::read(folder.path().join(name)).expect("the book")).expect("a book").sheets;
        let names = sheets.iter().map(|one| one.name.as_str()).collect::<Vec<_>>();
        assert_eq!(names.iter().filter(|one| ["SWEEP", "BARRIDO"].contains(one)).count(), 1, "{names:?}");
        assert_eq!(names.contains(&"BARRIDO"), name == "full.xlsx", "in the language of the form: {names:?}");
        rodete(&folder)
            .args(["sweep", name, "--dry-run", "--jobs", "1", "--lang", "en"])
            .assert()
            .code(0)
            .stdout(predicate::str::starts_with("400 designs, 4 inputs:\n  R (10)\n"));
        // A second one, or one of another kind, finds the form in the way.
        let before = fs::read(folder.path().join(name)).expect("the book");
        for kind in ["impeller", "pipe-hole"] {
            let again = rodete(&folder).args(["new", kind, "--sweep", "--into", name]).assert().code(3);
            again.stderr(predicate::str::contains("B011"));
        }
        assert!(fs::read(folder.path().join(name)).expect("the book") == before, "{name}");
    }
}

#[test]
fn an_open_book_is_refused_with_the_name_of_who_has_it_open() {
    let folder = folder();
    let here = |name: &str| folder.path().join(name);
    rodete(&folder).args(["new", "impeller", "a.xlsx", "--case", "full"]).assert().code(0);
    let before = fs::read(here("a.xlsx")).expect("the book");
    let mut excel = vec![3, b'A', b'n', b'a'];
    excel.resize(55, b' ');
    let locks: [(&str, Vec<u8>, &str); 2] = [
        ("~$a.xlsx", excel, "a.xlsx is open in Excel (Ana)"),
        (".~lock.a.xlsx#", b"Ana Gil,ana,taller,x,y;".to_vec(), "a.xlsx is open in LibreOffice (Ana Gil, ana, taller)"),
    ];
    for (lock, owner, told) in locks {
        fs::write(here(lock), owner).expect("a lock");
        for words in [["build", "a.xlsx", "--into"], ["new", "--into=a.xlsx", "lathe"]] {
            rodete(&folder).args(words).assert().code(5).stderr(predicate::str::contains(told));
        }
        fs::remove_file(here(lock)).expect("removed");
        assert_eq!(fs::read(here("a.xlsx")).expect("the book"), before);
        assert_eq!(names(folder.path()), ["a.xlsx"]);
    }
}

#[test]
fn a_rejected_form_changes_nothing() {
    let folder = folder();
    let here = folder.path().join("a.xlsx");
    rodete(&folder).args(["new", "impeller", "a.xlsx", "--case", "full"]).assert().code(0);
    let sheet = super::common::workbook::Parts::of(&fs::read(&here).expect("the book"));
    let values = super::made::read(&fs::read(&here).expect("the book")).values;
    let cell = values.cells["N"].cell.clone();
    let bad = sheet.cell("xl/worksheets/sheet1.xml", &cell, &format!("<c r=\"{cell}\"><v>40</v></c>")).zip();
    fs::write(&here, &bad).expect("written");
    rodete(&folder).args(["build", "a.xlsx", "--into"]).assert().code(3);
    assert_eq!(fs::read(&here).expect("the book"), bad);
    assert_eq!(names(folder.path()), ["a.xlsx"]);
}

#[test]
fn results_go_into_a_book_whose_files_go_elsewhere() {
    let folder = folder();
    fs::create_dir(folder.path().join("books")).expect("a folder");
    rodete(&folder).args(["new", "impeller", "books/a.xlsx", "--case", "full"]).assert().code(0);
    for out in ["out", "books", "."] {
        let line = ["build", "books/a.xlsx", "--into", "--no-report", "-o", out];
        rodete(&folder).args(line).assert().code(0).stdout(predicate::str::contains("results in books/a.xlsx"));
        assert!(folder.path().join(out).join("a-blade.nc").exists());
    }
    assert!(folder.path().join("books/a.xlsx.bak").exists());
    rodete(&folder).args(["check", "books/a.xlsx"]).assert().code(0);
}

#[cfg(unix)]
#[test]
fn the_book_keeps_its_mode() {
    use std::os::unix::fs::PermissionsExt;
    let folder = folder();
    let here = folder.path().join("a.xlsx");
    rodete(&folder).args(["new", "impeller", "a.xlsx", "--case", "full"]).assert().code(0);
    fs::set_permissions(&here, fs::Permissions::from_mode(0o640)).expect("a mode");
    rodete(&folder).args(["build", "a.xlsx", "--into", "--no-report"]).assert().code(0);
    assert_eq!(fs::metadata(&here).expect("the book").permissions().mode() & 0o777, 0o640);
}

#[test]
fn a_program_knows_the_workbook_that_its_results_went_into_until_an_input_changes() {
    let folder = folder();
    let here = folder.path().join("h1.xlsx");
    fs::copy(path("h1.xlsx"), &here).expect("a copy");
    rodete(&folder).args(["new", "impeller", "--case", "full", "--into", "h1.xlsx"]).assert().code(0);
    let verify = |told: &str| {
        let output = rodete(&folder).args(["verify", "h1-out/h1-blade.nc"]).assert().code(0).get_output().clone();
        let text = [output.stdout, output.stderr].map(|text| String::from_utf8(text).expect("UTF-8")).concat();
        assert!(text.contains(told), "{text}");
    };
    for _ in 0..2 {
        rodete(&folder).args(["build", "h1.xlsx", "--into", "--no-report"]).assert().code(0);
        verify("note U0128");
    }
    let bytes = fs::read(&here).expect("the book");
    let cell = super::made::read(&bytes).values.cells["N"].cell.clone();
    let changed = super::common::workbook::Parts::of(&bytes);
    let part = "xl/worksheets/rodete-form.xml";
    let changed = changed.cell(part, &cell, &format!("<c r=\"{cell}\"><v>3</v></c>")).zip();
    fs::write(&here, changed).expect("written");
    verify("caution U0129");
    // What makes its sheets new, too, is what the hint and the next step say.
    let told = predicate::str::contains("hint: build again with \"rodete build --into\"\n");
    let next = predicate::str::contains("rodete build h1.xlsx --into\n");
    rodete(&folder).args(["check", "h1.xlsx"]).assert().code(0).stderr(told).stdout(next);
    rodete(&folder).args(["build", "h1.xlsx", "--into", "--no-report"]).assert().code(0);
    let changed = predicate::str::contains("W0519");
    rodete(&folder).args(["check", "h1.xlsx"]).assert().code(0).stderr(changed.not());
}

#[test]
fn a_logo_that_has_changed_or_is_gone_is_named() {
    let folder = folder();
    let here = |name: &str| folder.path().join(name);
    rodete(&folder).args(["new", "impeller", "a.xlsx", "--case", "full"]).assert().code(0);
    let bytes = fs::read(here("a.xlsx")).expect("the book");
    let logo = |size: u8| format!("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{size}\" height=\"4\"/>");
    let named = super::common::workbook::Parts::of(&bytes);
    let at = named.text("xl/workbook.xml");
    let (_, rest) = at.split_once("<definedName name=\"title_logo\">").expect("the name");
    let cell = rest.split_once('<').expect("its end").0.rsplit_once('!').expect("a sheet").1.replace('$', "");
    let text = format!("<c r=\"{cell}\" t=\"inlineStr\"><is><t>logo.svg</t></is></c>");
    fs::write(here("a.xlsx"), named.cell("xl/worksheets/sheet1.xml", &cell, &text).zip()).expect("written");
    fs::write(here("logo.svg"), logo(4)).expect("a logo");
    let check = || {
        let output = rodete(&folder).args(["check", "a.xlsx"]).assert().code(0).get_output().clone();
        [output.stdout, output.stderr].map(|text| String::from_utf8(text).expect("UTF-8")).concat()
    };
    // Nothing was verified yet, so that nothing has changed.
    assert!(!check().contains("T0206"));
    rodete(&folder).args(["build", "a.xlsx", "--into", "--no-report"]).assert().code(0);
    assert!(!check().contains("T02"), "{}", check());
    fs::write(here("logo.svg"), logo(5)).expect("another logo");
    assert!(
        check().contains("caution T0206: the file logo.svg has changed since the programs were made"),
        "{}",
        check()
    );
    fs::remove_file(here("logo.svg")).expect("removed");
    let told = check();
    assert!(told.contains("T0203: the logo logo.svg could not be read") && !told.contains("T0206"), "{told}");
    fs::write(here("logo.svg"), logo(4)).expect("the first logo");
    assert!(!check().contains("T02"));
    // A new build takes the file as it is.
    fs::write(here("logo.svg"), logo(5)).expect("another logo");
    rodete(&folder).args(["build", "a.xlsx", "--into", "--no-report"]).assert().code(0);
    assert!(!check().contains("T02"));
}

/// Results are delivered into a folder below that of the workbook, which has the logo.
#[test]
fn delivered_results_find_the_logo_of_their_workbook_in_the_folder_above() {
    let folder = folder();
    let here = |name: &str| folder.path().join(name);
    rodete(&folder).args(["new", "impeller", "a.xlsx", "--case", "full"]).assert().code(0);
    let book = super::common::workbook::Parts::of(&fs::read(here("a.xlsx")).expect("the book"));
    let at = book.text("xl/workbook.xml");
    let (_, rest) = at.split_once("<definedName name=\"title_logo\">").expect("the name");
    let cell = rest.split_once('<').expect("its end").0.rsplit_once('!').expect("a sheet").1.replace('$', "");
    let text = format!("<c r=\"{cell}\" t=\"inlineStr\"><is><t>logo.svg</t></is></c>");
    fs::write(here("a.xlsx"), book.cell("xl/worksheets/sheet1.xml", &cell, &text).zip()).expect("written");
    let logo = |size: u8| format!("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{size}\" height=\"4\"/>");
    fs::write(here("logo.svg"), logo(4)).expect("a logo");
    rodete(&folder).args(["build", "a.xlsx", "--no-report"]).assert().code(0);
    let told = |command: &[&str]| {
        let output = rodete(&folder).args(command).output().expect("run");
        [output.stdout, output.stderr].map(|text| String::from_utf8(text).expect("UTF-8")).concat()
    };
    let check = || told(&["check", "a-out/a-results.xlsx"]);
    assert!(!check().contains("T02"), "{}", check());
    let built = told(&["build", "a-out/a-results.xlsx", "-o", "again", "--typst", "no/such/typst"]);
    assert!(!built.contains("T0203") && built.contains("no/such/typst"), "{built}");
    // Another file of that name is not taken from there; that it has changed is what is told.
    fs::write(here("logo.svg"), logo(5)).expect("another logo");
    assert!(!check().contains("T0203") && check().contains("T0206"), "{}", check());
    fs::remove_file(here("logo.svg")).expect("removed");
    assert!(check().contains("T0203") && !check().contains("T0206"), "{}", check());
}

#[test]
fn a_file_that_is_no_workbook_is_refused() {
    let folder = folder();
    fs::write(folder.path().join("a.ods"), "x").expect("a file");
    rodete(&folder).args(["new", "impeller", "--into", "a.ods"]).assert().code(4);
    rodete(&folder).args(["new", "impeller", "--into", "none.xlsx"]).assert().code(4);
    rodete(&folder).args(["new", "impeller", "b.xlsx", "--into", "a.xlsx"]).assert().code(2);
    assert_eq!(names(folder.path()), ["a.ods"]);
}
