//! Whether the workbook of a program is still the same, as `verify` says it.

use std::fs;

use predicates::prelude::*;
use tempfile::TempDir;

use super::common::{folder, rodete};

/// A folder with the workbook of a kind, and the programs that it is built to.
fn built(kind: &str, name: &str) -> TempDir {
    let folder = folder();
    let case: &[&str] = if kind == "impeller" { &["--case", "full"] } else { &[] };
    rodete(&folder).args(["new", kind, name]).args(case).assert().code(0);
    rodete(&folder).args(["build", name, "--no-report"]).assert().code(0);
    folder
}

#[test]
fn a_program_knows_its_workbook_in_the_folder_above_until_it_changes() {
    for (name, program) in [
        ("Álabe nº 1.xlsx", "Álabe nº 1-out/Álabe nº 1-impeller.nc"),
        ("impeller.xlsx", "impeller-out/impeller-impeller.nc"),
    ] {
        let folder = built("impeller", name);
        let verify = |language: &str| {
            let mut command = rodete(&folder);
            command.args(["verify", program, "--lang", language]);
            command
        };
        let same = format!(
            "note U0128: made from {name}, which has not changed; the blocks of the program are not compared with it"
        );
        verify("en").assert().code(0).stdout(predicate::str::contains(same));
        // The same bytes under a name in other letters are the same workbook.
        let upper = folder.path().join(name.to_uppercase());
        fs::rename(folder.path().join(name), &upper).expect("it can be renamed");
        verify("es").assert().code(0).stdout(predicate::str::contains("nota U0128: generado con"));
        let mut bytes = fs::read(&upper).expect("a workbook");
        bytes.push(0);
        fs::write(&upper, bytes).expect("a workbook");
        verify("en").assert().code(0).stderr(predicate::str::contains(format!(
            "caution U0129: {} has changed since this program was made",
            name.to_uppercase()
        )));
        fs::remove_file(&upper).expect("it can be removed");
        let told = "which is neither beside the program nor in the folder above";
        verify("en")
            .assert()
            .code(0)
            .stdout(predicate::str::contains("note U0130: made from"))
            .stdout(predicate::str::contains(told));
    }
}

#[test]
fn beside_the_program_a_workbook_counts_and_one_that_is_the_same_counts_before_one_that_is_not() {
    let folder = built("pipe-insert", "pipe.xlsx");
    let out = folder.path().join("pipe-out");
    let program = fs::read_dir(&out)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").file_name().into_string().expect("a name"))
        .find(|name| name.ends_with(".nc"))
        .expect("a program");
    fs::write(out.join("pipe.xlsx"), "another").expect("a file");
    let path = format!("pipe-out/{program}");
    let output = rodete(&folder).args(["verify", &path, "--json"]).output().expect("it runs");
    let read: serde_json::Value = serde_json::from_slice(&output.stdout).expect("a document");
    let codes = |read: &serde_json::Value| {
        let findings = read["programs"][0]["findings"].as_array().expect("findings").clone();
        findings.iter().filter_map(|one| one["code"].as_str().map(str::to_owned)).collect::<Vec<_>>()
    };
    assert!(codes(&read).contains(&"U0128".to_owned()), "{:?}", codes(&read));
    fs::remove_file(folder.path().join("pipe.xlsx")).expect("it can be removed");
    // From inside its folder, too.
    let mut command = rodete(&folder);
    let output = command.current_dir(&out).args(["verify", &program, "--json"]).output().expect("it runs");
    let read: serde_json::Value = serde_json::from_slice(&output.stdout).expect("a document");
    assert!(codes(&read).contains(&"U0129".to_owned()), "{:?}", codes(&read));
}

#[test]
fn a_program_of_others_names_no_workbook() {
    let folder = folder();
    fs::write(folder.path().join("a.ngc"), "(WORKBOOK A.XLSX)\nG0 X1\nM2\n").expect("a program");
    rodete(&folder).args(["verify", "a.ngc"]).assert().code(0).stdout(predicate::str::contains("A.XLSX").not());
}
