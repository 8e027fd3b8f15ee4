//! Which outputs there are, and of what they were made.

use std::fs;

use predicates::prelude::*;
use rodete::store::sha256;
use serde_json::Value as Json;

use super::common::{folder, names, rodete, with_impeller};

#[test]
fn a_program_that_is_given_up_at_a_limit_leaves_no_page() {
    let folder = folder();
    let deep = format!("G0 X{}1{}\nM2\n", "[".repeat(100), "]".repeat(100));
    fs::write(folder.path().join("deep.ngc"), deep).expect("a program");
    rodete(&folder).args(["view", "deep.ngc"]).assert().code(7).stdout("");
    assert_eq!(names(&folder), ["deep.ngc"]);
    // One that is refused is shown with its faults.
    fs::write(folder.path().join("deep.ngc"), "G0 X1 Q\nM2\n").expect("a program");
    rodete(&folder).args(["view", "deep.ngc"]).assert().code(3);
    assert_eq!(names(&folder), ["deep.html", "deep.ngc"]);
}

#[cfg(unix)]
#[test]
fn inputs_whose_names_clean_to_one_do_not_share_their_outputs() {
    let folder = with_impeller();
    let path = |name: &str| folder.path().join(name);
    for name in ["a?.ngc", "a_.ngc"] {
        fs::write(path(name), "G0 X1\nM2\n").expect("a program");
    }
    for name in ["b?.xlsx", "b_.xlsx"] {
        fs::copy(path("impeller.xlsx"), path(name)).expect("a workbook");
    }
    let before = names(&folder);
    for (command, one, two) in [
        (["view", "a?.ngc"], "a?.ngc", "a_.ngc"),
        (["view", "a_.ngc"], "a_.ngc", "a?.ngc"),
        (["build", "b_.xlsx"], "b_.xlsx", "b?.xlsx"),
    ] {
        rodete(&folder).args(command).assert().code(2).stdout("").stderr(format!(
            "error U0114: the outputs of {one} and {two} would have the same names\nhint: rename one of the two or name another \
             output (option -o)\nrodete explain U0114 says what it means, with an example\n"
        ));
    }
    assert_eq!(names(&folder), before);
    rodete(&folder).args(["view", "a?.ngc", "-o", "one.html"]).assert().code(0);
    fs::remove_file(path("a_.ngc")).expect("removed");
    rodete(&folder).args(["view", "a?.ngc"]).assert().code(0).stdout(predicate::str::contains("a_.html is ready"));
}

#[test]
fn the_document_of_verify_tells_the_sums_of_all_that_was_read() {
    let folder = folder();
    let files = [
        ("main.ngc", "o<sub> call\no<sub> call\nM2\nG0 X9\n"),
        ("sub.ngc", "o<sub> sub\nG0 X1\no<sub> endsub\n"),
        ("tool.tbl", "T1 P1 Z10\n"),
        ("plain.ngc", "G0 X1\nM2\n"),
    ];
    for (name, text) in files {
        fs::write(folder.path().join(name), text).expect("a file");
    }
    let done = rodete(&folder)
        .args(["verify", "main.ngc", "plain.ngc", "missing.ngc", "--tools", "tool.tbl", "--json"])
        .output()
        .expect("run");
    let document: Json = serde_json::from_slice(&done.stdout).expect("a document");
    let sum = |name: &str| {
        let text = files.iter().find(|file| file.0 == name).expect(name).1;
        serde_json::json!(sha256(text.as_bytes()))
    };
    let programs = &document["programs"];
    assert_eq!(programs[0]["sha256"], sum("main.ngc"), "{document:#}");
    assert_eq!(
        programs[0]["read"],
        serde_json::json!([
            { "path": "tool.tbl", "sha256": sum("tool.tbl") },
            { "path": "sub.ngc", "sha256": sum("sub.ngc") },
        ])
    );
    assert_eq!(programs[1]["sha256"], sum("plain.ngc"));
    assert_eq!(programs[1]["read"], serde_json::json!([{ "path": "tool.tbl", "sha256": sum("tool.tbl") }]));
    assert_eq!(programs[2]["sha256"], Json::Null);
}

/// The turning of the blank is told by its header, and its spindle turns as it says.
#[test]
fn the_viewer_takes_rodete_s_own_blank_program_as_it_is() {
    let folder = with_impeller();
    rodete(&folder).args(["build", "impeller.xlsx", "--no-report"]).assert().code(0);
    rodete(&folder).args(["view", "impeller-out/impeller-blank.nc"]).assert().code(0).stderr("");
    let page = fs::read_to_string(folder.path().join("impeller-out/impeller-blank.html")).expect("a page");
    assert!(!page.contains("name the table with --tools") && !page.contains("G96 is not supported"));
    let done = rodete(&folder).args(["verify", "impeller-out/impeller-blank.nc", "--json"]).output().expect("run");
    let document: Json = serde_json::from_slice(&done.stdout).expect("a document");
    assert_eq!(
        (document["exit"].as_u64(), &document["programs"][0]["dialect"]),
        (Some(0), &Json::from("fagor-8055-t"))
    );
    let told = |document: &Json| {
        let findings = document["programs"][0]["findings"].as_array().expect("findings").iter();
        let shown = |one: &Json| format!("{} {}", one["grade"].as_str()?, one["what"]["en"].as_str()?).into();
        findings.map(shown).collect::<Option<Vec<String>>>().expect("graded findings")
    };
    let named = "note the header names this tool; rodete takes its offset, which is measured at the machine, as 0";
    let found = told(&document);
    assert!(found.iter().all(|one| one.starts_with("note ")) && found.iter().any(|one| one == named), "{found:?}");
    // The same blocks of somebody else's, and another tool than the header's.
    let own = fs::read_to_string(folder.path().join("impeller-out/impeller-blank.nc")).expect("a program");
    for other in [own.replace(";RODETE", ";COPIED FROM"), own.replace("N20 T1 D1", "N20 T1 D2")] {
        fs::write(folder.path().join("other.nc"), other).expect("a program");
        let done = rodete(&folder).args(["verify", "other.nc", "--json"]).output().expect("run");
        let found = told(&serde_json::from_slice(&done.stdout).expect("a document"));
        let asks = "caution no tool table: rodete takes the tool lengths as 0";
        assert!(found.iter().any(|one| one == asks), "{found:?}");
    }
}
