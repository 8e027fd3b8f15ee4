//! Whatever surrounds the process: same bytes, plain text, a quiet end.

use std::fs;
use std::io::Read;
use std::process::{Command, Stdio};

use predicates::prelude::*;

use super::common::{OUTPUTS, contents, names, rodete, with_impeller};

#[test]
fn the_same_workbook_gives_the_same_bytes_in_any_environment() {
    let folder = with_impeller();
    let environments: [&[(&str, &str)]; 4] = [
        &[],
        &[("LANG", "C"), ("LC_ALL", "C"), ("HOME", "/nonexistent"), ("TZ", "Pacific/Kiritimati")],
        &[("LANG", "es_ES.UTF-8"), ("LC_ALL", "es_ES.UTF-8"), ("TZ", "America/St_Johns"), ("SOURCE_DATE_EPOCH", "0")],
        &[("LANG", "de_DE"), ("LC_NUMERIC", "de_DE.UTF-8"), ("TZ", ":no/such/zone"), ("COLUMNS", "40")],
    ];
    let built: Vec<_> = environments
        .iter()
        .enumerate()
        .map(|(at, variables)| {
            let out = format!("out-{at}");
            rodete(&folder)
                .env_clear()
                .envs(variables.iter().copied())
                .args(["build", "impeller.xlsx", "--no-report", "-o", &out])
                .assert()
                .code(0);
            contents(&folder.path().join(out))
        })
        .collect();
    assert_eq!(built[0].len(), OUTPUTS.len());
    for other in &built {
        assert!(*other == built[0], "the bytes differ between environments");
    }
}

#[test]
fn several_workbooks_at_once_give_the_same_bytes_as_one() {
    let folder = with_impeller();
    let copies: Vec<_> = (0..5).map(|at| format!("copy-{at}.xlsx")).collect();
    for copy in &copies {
        fs::copy(folder.path().join("impeller.xlsx"), folder.path().join(copy)).expect("a copy");
    }
    rodete(&folder).arg("build").args(&copies).args(["--no-report", "-o", "together"]).assert().code(0);
    for copy in &copies {
        rodete(&folder).args(["build", copy, "--no-report", "-o", "alone"]).assert().code(0);
    }
    assert!(contents(&folder.path().join("together")) == contents(&folder.path().join("alone")));
}

#[test]
fn text_is_plain_where_there_is_no_terminal() {
    let folder = with_impeller();
    rodete(&folder)
        .args(["check", "impeller.xlsx", "missing.xlsx"])
        .assert()
        .code(4)
        .stdout(predicate::str::contains("\u{1b}").not())
        .stderr(predicate::str::contains("\u{1b}").not());
}

#[test]
fn a_reader_that_goes_away_ends_the_printing_and_nothing_else() {
    let folder = with_impeller();
    for arguments in [vec!["build", "impeller.xlsx", "--no-report"], vec!["--help"], vec!["--version"]] {
        let run = || {
            let mut command = Command::new(env!("CARGO_BIN_EXE_rodete"));
            command.args(&arguments).current_dir(folder.path()).stdout(Stdio::piped()).stderr(Stdio::piped());
            command
        };
        let heard = run().output().expect("ended");
        let mut child = run().spawn().expect("started");
        drop(child.stdout.take());
        let done = child.wait_with_output().expect("ended");
        assert_eq!(done.status.code(), Some(0), "{arguments:?}");
        let said = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        assert_eq!(said(&done.stderr), said(&heard.stderr), "{arguments:?}");
    }
    assert_eq!(names(folder.path().join("impeller-out")), OUTPUTS);
}

#[cfg(target_os = "linux")]
#[test]
fn standard_output_on_a_full_disk_is_said() {
    let folder = with_impeller();
    let full = fs::OpenOptions::new().write(true).open("/dev/full").expect("/dev/full");
    let mut child = Command::new(env!("CARGO_BIN_EXE_rodete"))
        .args(["check", "impeller.xlsx"])
        .current_dir(folder.path())
        .stdout(full)
        .stderr(Stdio::piped())
        .spawn()
        .expect("started");
    let mut said = String::new();
    child.stderr.take().expect("stderr").read_to_string(&mut said).expect("text");
    assert_eq!(child.wait().expect("ended").code(), Some(5));
    let told: Vec<_> = said.lines().filter(|line| line.contains("standard output")).collect();
    assert!(matches!(told[..], [told] if told.starts_with("error U0142: cannot write to standard output: ")), "{said}");
}

#[test]
fn a_new_form_is_in_the_language_of_the_locale_or_in_the_one_asked_for() {
    let asked: [(&str, &[&str], &str); 4] = [
        ("es_ES.UTF-8", &[], "DATOS"),
        ("es_ES.UTF-8", &["--lang", "en"], "DATA"),
        ("de_DE.UTF-8", &[], "DATA"),
        ("C", &["--lang", "es"], "DATOS"),
    ];
    for (locale, language, sheet) in asked {
        let folder = tempfile::tempdir().unwrap();
        rodete(&folder).env("LC_ALL", locale).args(["new", "pipe-insert", "a.xlsx"]).args(language).assert().code(0);
        let place = format!("\"{sheet}\"");
        rodete(&folder).args(["check", "a.xlsx"]).assert().code(0).stdout(predicate::str::contains(place));
    }
}
