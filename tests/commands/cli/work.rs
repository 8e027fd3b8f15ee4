//! What the commands do when all is well, or nearly.

use std::fs;
use std::process::Command;

use predicates::prelude::*;
use rodete::kinds::KINDS;
use rodete::parameter::Value;
use rodete::store::sha256;
use serde_json::Value as Json;

use crate::every_kind::every_command;

use super::common::{OUTPUTS, contents, folder, names, rodete, with_impeller, with_refused, workbook};

#[test]
fn a_new_workbook_can_be_checked_and_built() {
    let folder = folder();
    rodete(&folder)
        .args(["new", "impeller"])
        .assert()
        .code(0)
        .stdout("impeller.xlsx is ready to edit; then: rodete build impeller.xlsx\n");
    rodete(&folder)
        .args(["check", "impeller.xlsx"])
        .assert()
        .code(0)
        .stdout(predicate::str::is_match("\n  L +=   242.9 mm +Pivot length").expect("a pattern"))
        .stdout(predicate::str::is_match("\n  N_max +=     5 ").expect("a pattern"))
        .stdout(predicate::str::contains("impeller.xlsx: can be built"))
        .stderr(predicate::str::starts_with("caution").and(predicate::str::contains("error").not()));
    assert_eq!(names(&folder), ["impeller.xlsx"]);
    rodete(&folder)
        .args(["build", "impeller.xlsx", "--no-report"])
        .assert()
        .code(0)
        .stdout(predicate::str::contains("impeller.xlsx: 4 files in impeller-out"))
        .stderr(predicate::str::starts_with("caution").and(predicate::str::contains("error").not()));
    assert_eq!(
        names(folder.path().join("impeller-out")),
        ["impeller-blank.nc", "impeller-finish.nc", "impeller-results.xlsx", "impeller-rough.nc"]
    );
    assert_eq!(names(&folder), ["impeller-out", "impeller.xlsx"]);
}

#[test]
fn every_command_runs_on_every_case_of_every_kind_in_both_languages() {
    every_command(KINDS, &|folder, words| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_rodete"));
        command.args(words).current_dir(folder).env("LC_ALL", "C").env("KEPT", folder).output().expect("the command")
    });
}

#[test]
fn a_new_workbook_replaces_nothing() {
    let folder = folder();
    fs::write(folder.path().join("impeller.xlsx"), "mine").expect("a file");
    rodete(&folder)
        .args(["new", "impeller"])
        .assert()
        .code(5)
        .stderr("error S0142: impeller.xlsx already exists\nhint: give another name, or remove that file\nrodete explain S0142 says what it means, with an example\n");
    assert_eq!(fs::read(folder.path().join("impeller.xlsx")).expect("the file"), b"mine");
}

#[test]
fn json_tells_what_was_found_and_written() {
    let folder = with_impeller();
    let done = rodete(&folder).args(["build", "impeller.xlsx", "--no-report", "--json", "-o", "out"]).assert().code(0);
    let document: Json = serde_json::from_slice(&done.get_output().stdout).expect("one JSON document");
    assert_eq!(document["exit"], 0);
    let workbook = &document["workbooks"][0];
    assert_eq!(workbook["sha256"], sha256(&fs::read(folder.path().join("impeller.xlsx")).expect("the workbook")));
    assert_eq!(workbook["schema"], "rodete-impeller 2");
    let quantities = workbook["quantities"].as_array().expect("quantities");
    let length = quantities.iter().find(|one| one["symbol"] == "L").expect("L");
    assert_eq!((&length["value"], &length["unit"]), (&Json::from(242.9), &Json::from("mm")));
    let files = workbook["files"].as_array().expect("files");
    assert_eq!(files.len(), OUTPUTS.len());
    for file in files {
        let path = folder.path().join(file["path"].as_str().expect("a path"));
        let bytes = fs::read(path).expect("a file");
        assert_eq!(file["sha256"], sha256(&bytes));
        assert_eq!(file["bytes"], bytes.len());
    }
}

#[test]
fn a_refused_workbook_leaves_no_folder() {
    let folder = with_refused();
    for command in ["check", "build"] {
        rodete(&folder)
            .args([command, "impeller.xlsx"])
            .assert()
            .code(3)
            .stderr(predicate::str::contains("\n  --> impeller.xlsx, sheet \"DATA\", cell"))
            .stderr(predicate::str::contains("hint: "));
    }
    assert_eq!(names(&folder), ["impeller.xlsx"]);
    let done = rodete(&folder).args(["build", "impeller.xlsx", "--json"]).assert().code(3).stderr("");
    let document: Json = serde_json::from_slice(&done.get_output().stdout).expect("one JSON document");
    assert_eq!((&document["exit"], &document["workbooks"][0]["status"]), (&Json::from(3), &Json::from("refused")));
    assert_eq!(document["workbooks"][0]["findings"][0]["grade"], "stop");
}

#[test]
fn one_bad_workbook_stops_no_other_and_the_gravest_end_counts() {
    let folder = with_refused();
    let good: Vec<_> = (0..6).map(|at| format!("good-{at}.xlsx")).collect();
    for name in &good {
        workbook(&folder.path().join(name), &[]);
    }
    let mut order = vec!["missing.xlsx", "impeller.xlsx"];
    order.extend(good.iter().map(String::as_str));
    let done = rodete(&folder).arg("build").args(&order).args(["--no-report", "-o", "out"]).assert().code(4);
    let stdout = String::from_utf8_lossy(&done.get_output().stdout).into_owned();
    let mentioned: Vec<_> =
        good.iter().map(|name| stdout.find(&format!("{name}: 5 files in out")).expect(name)).collect();
    assert!(mentioned.is_sorted(), "{stdout}");
    assert_eq!(names(folder.path().join("out")).len(), 5 * good.len());
}

#[test]
fn a_program_of_an_earlier_build_is_pointed_out() {
    let folder = with_impeller();
    let build = || rodete(&folder).args(["build", "impeller.xlsx", "--no-report"]).assert().code(0);
    build().stderr(predicate::str::contains("earlier build").not());
    workbook(&folder.path().join("impeller.xlsx"), &[("splitters", Value::Choice("no"))]);
    build().stderr(predicate::str::contains(
        "caution U0115: impeller-out/impeller-splitter.nc is left from an earlier build and does not belong to this set\n  --> \
         impeller.xlsx\nhint: do not use it; delete it or move it away\n",
    ));
}

#[test]
fn messages_are_spanish_where_asked_for() {
    let folder = with_refused();
    rodete(&folder)
        .args(["check", "impeller.xlsx", "--lang", "es"])
        .assert()
        .code(3)
        .stderr(predicate::str::contains(", hoja \"DATA\", celda"))
        .stderr(predicate::str::contains("sugerencia: "))
        .stderr(predicate::str::contains("impeller.xlsx: no se puede generar"));
}

#[test]
fn a_report_that_fails_keeps_nothing_else_from_being_delivered() {
    let folder = with_impeller();
    let expected = rodete(&folder).args(["build", "impeller.xlsx", "--no-report", "-o", "expected"]).assert().code(0);
    drop(expected);
    for (flag, variable) in [(true, false), (false, true)] {
        let mut command = rodete(&folder);
        command.args(["build", "impeller.xlsx"]);
        if flag {
            command.args(["--typst", "no/such/typst"]);
        }
        if variable {
            command.env("RODETE_TYPST", "no/such/typst");
        }
        command
            .assert()
            .code(6)
            .stderr(predicate::str::contains("no/such/typst"))
            .stdout(predicate::str::contains("impeller.xlsx: 5 files in impeller-out, without a report"));
        assert_eq!(contents(&folder.path().join("impeller-out")), contents(&folder.path().join("expected")));
        fs::remove_dir_all(folder.path().join("impeller-out")).expect("removed");
    }
}

/// What a build would leave out of its report is known before.
#[test]
fn check_looks_at_the_logo_as_build_does() {
    let folder = with_impeller();
    let path = |name: &str| folder.path().join(name);
    workbook(&path("impeller.xlsx"), &[("logo", Value::Line("logo.svg".to_owned()))]);
    let told = |commands: &[&[&str]], code: &str| {
        for command in commands {
            let done = rodete(&folder).args(*command).output().expect("run");
            let said = String::from_utf8(done.stderr).expect("text");
            for one in ["T0203", "T0204"] {
                assert_eq!(said.contains(&format!("caution {one}: ")), one == code, "{command:?}: {said}");
            }
        }
    };
    let (check, build) = (["check", "impeller.xlsx"], ["build", "impeller.xlsx", "--typst", "no/such/typst"]);
    told(&[&check, &build], "T0203");
    fs::write(path("logo.svg"), "no picture").expect("a file");
    told(&[&check, &build], "T0204");
    fs::write(path("logo.svg"), "<svg xmlns=\"http://www.w3.org/2000/svg\"/>").expect("a file");
    told(&[&check, &build], "");
}

#[test]
fn any_path_will_do() {
    let folder = folder();
    for name in ["with blank.xlsx", "-dash.xlsx", "колесо 🌀.xlsx", "a.b.c.xlsx"] {
        workbook(&folder.path().join(name), &[]);
        rodete(&folder).args(["build", "--no-report", "--", name]).assert().code(0);
        let stem = name.trim_end_matches(".xlsx");
        assert!(folder.path().join(format!("{stem}-out/{stem}-blade.nc")).is_file(), "{name}");
    }
    let long = format!("{}.xlsx", "n".repeat(250));
    workbook(&folder.path().join(&long), &[]);
    rodete(&folder).args(["build", "--no-report", "-o", "long", &long]).assert().code(0);
    assert!(folder.path().join(format!("long/{}-results.xlsx", "n".repeat(200))).is_file());
}

#[cfg(unix)]
#[test]
fn a_name_that_is_no_utf8_will_do_too() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let folder = folder();
    let name = OsStr::from_bytes(b"a\xff.xlsx");
    workbook(&folder.path().join(name), &[]);
    rodete(&folder).args(["build", "--no-report", "--json"]).arg(name).assert().code(0);
    assert!(folder.path().join(OsStr::from_bytes(b"a\xff-out/a\xff-blade.nc")).is_file());
}

/// A folder with programs, among them an `xdg-open` that writes down what it is to open.
#[cfg(unix)]
fn desktop(folder: &tempfile::TempDir, opener: bool) -> std::path::PathBuf {
    use std::os::unix::fs::PermissionsExt;
    let bin = folder.path().join(if opener { "desktop" } else { "bare" });
    fs::create_dir(&bin).expect("a folder");
    if opener {
        let script = bin.join("xdg-open");
        fs::write(&script, "#!/bin/sh\nprintf '%s' \"$1\" > opened.tmp && /bin/mv opened.tmp opened\n")
            .expect("a script");
        fs::set_permissions(&script, fs::Permissions::from_mode(0o755)).expect("permissions");
    }
    bin
}

/// `--open` gives the desktop the report, or the folder where there is none; that it cannot is a caution, with the files written.
#[cfg(target_os = "linux")]
#[test]
fn what_was_built_is_opened_when_asked_for() {
    let folder = with_impeller();
    let line = ["build", "impeller.xlsx", "--no-report", "--open"];
    let build = |bin| rodete(&folder).args(line).env("PATH", bin).assert().code(0);
    build(desktop(&folder, true));
    let opened = folder.path().join("opened");
    // Nobody waits for what is opened.
    let until = std::time::Instant::now() + std::time::Duration::from_secs(60);
    while !opened.exists() {
        assert!(std::time::Instant::now() < until, "nothing was opened");
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    assert_eq!(fs::read_to_string(&opened).expect("what was opened"), "impeller-out");
    build(desktop(&folder, false)).stderr(predicate::str::contains("cannot open impeller-out: "));
    assert_eq!(names(folder.path().join("impeller-out")), OUTPUTS);
    let bare = folder.path().join("bare");
    let output = rodete(&folder).args(line).arg("--json").env("PATH", bare).output().expect("it runs");
    let read: serde_json::Value = serde_json::from_slice(&output.stdout).expect("one document");
    let told = read["workbooks"][0]["findings"].as_array().expect("findings").iter();
    assert_eq!(told.filter(|one| one["code"] == "U0116").count(), 1, "{read}");
    // A workbook that is refused leaves nothing to open.
    fs::remove_file(&opened).expect("the note");
    let refused = with_refused();
    rodete(&refused).args(line).env("PATH", folder.path().join("desktop")).assert().code(3);
    assert!(!refused.path().join("opened").exists());
}

#[test]
fn the_last_line_says_what_to_do_next() {
    let last = |folder: &tempfile::TempDir, words: &[&str], code: i32| {
        let assert = rodete(folder).args(words).assert().code(code);
        let output = assert.get_output();
        let said = if code == 0 { &output.stdout } else { &output.stderr };
        String::from_utf8_lossy(said).lines().last().unwrap_or_default().to_owned()
    };
    let folder = with_impeller();
    let next = "next: see to the cautions; ";
    assert_eq!(last(&folder, &["check", "impeller.xlsx"], 0), format!("{next}rodete build impeller.xlsx"));
    assert_eq!(
        last(&folder, &["build", "impeller.xlsx", "--no-report"], 0),
        format!("{next}read impeller-out/impeller-results.xlsx; make a dry run before you cut")
    );
    let refused = with_refused();
    for command in ["check", "build"] {
        assert_eq!(
            last(&refused, &[command, "impeller.xlsx", "--lang", "es"], 3),
            "después: corrija las celdas indicadas, guarde el libro y repita"
        );
    }
}
