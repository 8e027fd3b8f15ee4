//! The command `view`: what it writes, over what it never writes, how it ends.

use std::fs;

use predicates::prelude::*;
use rodete::kinds::KINDS;
use rodete::parameter::Value;
use rodete::text::Language;
use tempfile::TempDir;

use super::common::{folder, names, rodete, with_impeller, with_refused};

const PROGRAM: &str = "N10 G21 G90 G94\nN20 G0 X10 Y5\nN30 G1 X20 F100 (</script>)\nM2\n";

fn with(name: &str, text: &str) -> TempDir {
    let folder = folder();
    fs::write(folder.path().join(name), text).expect("a program");
    folder
}

#[test]
fn the_same_input_gives_the_same_page_beside_it() {
    let folder = with("part.ngc", PROGRAM);
    let view = || rodete(&folder).args(["view", "part.ngc"]).assert().success();
    view().stdout("part.html is ready: open it in a browser\n").stderr("");
    let read = || fs::read(folder.path().join("part.html")).expect("a page");
    let first = read();
    view();
    assert_eq!(first, read());
    assert_eq!(names(&folder), ["part.html", "part.ngc"]);
    assert_eq!(fs::read_to_string(folder.path().join("part.ngc")).expect("the program"), PROGRAM);
}

#[test]
fn a_program_that_is_refused_is_shown_with_its_faults() {
    let folder = with("part.ngc", "G21 G90\nG1 X5 F100\nG1 X1Q2\nM2\n");
    rodete(&folder)
        .args(["view", "part.ngc", "-o", "page.html", "--lang", "es"])
        .assert()
        .code(3)
        .stdout("page.html está listo: ábralo en un navegador\n")
        .stderr(predicate::str::contains("part.ngc:3"));
    let page = fs::read_to_string(folder.path().join("page.html")).expect("a page");
    assert!(page.contains("\"grade\":\"stop\"") && page.contains("<html lang=\"es\">"));
}

#[test]
fn no_input_is_written_over_and_nothing_but_a_page_is_written() {
    let folder = with("part.html", PROGRAM);
    let before = || fs::read_to_string(folder.path().join("part.html")).expect("the program");
    rodete(&folder).args(["view", "part.html"]).assert().code(2).stdout("");
    rodete(&folder)
        .args(["view", "part.html", "-o", "out.nc"])
        .assert()
        .code(2)
        .stderr(predicate::str::contains(".html"));
    assert_eq!((before().as_str(), names(&folder)), (PROGRAM, vec!["part.html".to_owned()]));
    rodete(&folder).args(["view", "missing.nc"]).assert().code(4).stdout("");
}

#[test]
fn the_page_of_every_kind_is_headed_by_the_name_of_its_part() {
    for kind in KINDS {
        let (folder, form) = (folder(), kind.form());
        rodete(&folder).args(["new", form.kind, "book.xlsx", "--lang", "en"]).assert().success();
        rodete(&folder).args(["view", "book.xlsx"]).assert().success();
        let page = fs::read_to_string(folder.path().join("book.html")).expect("a page");
        let values = kind.cases().first().expect("a case").values(Language::En);
        let part = values.iter().find(|(key, _)| *key == form.part.key().name()).map(|(_, value)| value);
        let Some(Value::Line(part)) = part else { panic!("{}: a part without a name", form.kind) };
        assert!(page.contains(&format!("<title>{part}</title>")), "{}: {part}", form.kind);
    }
    // A program has the name of its file.
    let folder = with("part.ngc", PROGRAM);
    rodete(&folder).args(["view", "part.ngc"]).assert().success();
    assert!(fs::read_to_string(folder.path().join("part.html")).expect("a page").contains("<title>part.ngc</title>"));
}

#[test]
fn a_workbook_is_shown_with_all_its_programs_and_a_refused_one_not_at_all() {
    let folder = with_impeller();
    rodete(&folder).args(["view", "impeller.xlsx"]).assert().success();
    let page = fs::read_to_string(folder.path().join("impeller.html")).expect("a page");
    for title in ["One blade", "One splitter", "The whole impeller", "Turning of the blank", "\"Hub\"", "\"Blades\""] {
        assert!(page.contains(title), "{title}");
    }
    let refused = with_refused();
    rodete(&refused)
        .args(["view", "impeller.xlsx"])
        .assert()
        .code(3)
        .stdout("")
        .stderr(predicate::str::contains("blades"));
    assert_eq!(names(&refused), ["impeller.xlsx"]);
}

#[test]
fn a_bare_program_with_rotary_axes_says_that_they_are_not_applied() {
    let folder = with("part.ngc", "G21 G90\nG0 X1\nG1 X2 B45 F100\nM2\n");
    rodete(&folder).args(["view", "part.ngc"]).assert().success();
    let page = fs::read_to_string(folder.path().join("part.html")).expect("a page");
    assert!(page.contains("Rotary axes are not applied") && page.contains("ejes giratorios no se aplican"));
}
