//! What keeps outputs from being written, and what then stands in the folder.

use std::fs;
use std::path::Path;

use predicates::prelude::*;
use rodete::parameter::Value;
use rodete::text::Language;
use tempfile::TempDir;

use super::common::{OUTPUTS, contents, names, rodete, with_impeller, workbook, workbook_in};

fn build(folder: &TempDir, output: &str) -> assert_cmd::assert::Assert {
    rodete(folder).args(["build", "impeller.xlsx", "--no-report", "-o", output]).assert()
}

#[test]
fn a_file_where_the_folder_should_be_is_said_before_anything_is_computed() {
    let folder = with_impeller();
    fs::write(folder.path().join("out"), "mine").expect("a file");
    for (output, code) in [("out", "S0122"), ("out/below", "S0106")] {
        let lines = format!(
            "^error {code}: .* is not a folder\nhint: choose another folder \\(for build, option -o\\)\nrodete explain {code} .*\n$"
        );
        build(&folder, output).code(5).stdout("").stderr(predicate::str::is_match(lines).expect("a pattern"));
    }
    assert_eq!(fs::read(folder.path().join("out")).expect("the file"), b"mine");
}

#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_takes_no_files_is_said() {
    let folder = with_impeller();
    build(&folder, "/proc/self/out").code(5).stderr(predicate::str::contains("cannot write to /proc/self/out"));
    build(&folder, "/sys/kernel").code(5).stderr(predicate::str::contains("cannot write to /sys/kernel"));
}

/// Before any workbook is read, too, its language is spoken.
#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_takes_no_files_is_said_in_the_language_of_the_workbook() {
    let folder = with_impeller();
    workbook_in(Language::Es, &folder.path().join("impeller.xlsx"), &[]);
    build(&folder, "/proc/self/out").code(5).stderr(predicate::str::contains("no se puede escribir en /proc/self/out"));
}

#[test]
fn an_output_never_replaces_an_input() {
    let folder = with_impeller();
    let other = folder.path().join("impeller-results.xlsx");
    workbook(&other, &[]);
    let before = fs::read(&other).expect("an input");
    rodete(&folder)
        .args(["build", "impeller.xlsx", "impeller-results.xlsx", "--no-report", "-o", "."])
        .assert()
        .code(2)
        .stderr(predicate::str::contains("impeller-results.xlsx is both input and output"));
    assert_eq!(fs::read(&other).expect("the input"), before);
    assert!(!folder.path().join("impeller-blade.nc").exists());
}

#[cfg(unix)]
#[test]
fn nothing_is_written_through_a_link() {
    let folder = with_impeller();
    fs::create_dir(folder.path().join("out")).expect("a folder");
    fs::write(folder.path().join("precious"), "mine").expect("a file");
    std::os::unix::fs::symlink("../precious", folder.path().join("out/impeller-blank.nc")).expect("a link");
    build(&folder, "out").code(5).stderr(predicate::str::contains("out/impeller-blank.nc is a symbolic link"));
    assert_eq!(fs::read(folder.path().join("precious")).expect("the file"), b"mine");
    assert_eq!(names(folder.path().join("out")), ["impeller-blank.nc"]);
}

#[test]
fn results_open_in_excel_are_refused_and_nothing_changes() {
    let folder = with_impeller();
    build(&folder, "out").code(0);
    let out = folder.path().join("out");
    fs::write(out.join("~$impeller-results.xlsx"), "").expect("a lock file");
    let before = contents(&out);
    workbook(&folder.path().join("impeller.xlsx"), &[("a_p", Value::Real(1.0))]);
    build(&folder, "out")
        .code(5)
        .stderr(predicate::str::contains("impeller-results.xlsx is open in Excel"))
        .stderr(predicate::str::contains("hint: close it in Excel"));
    assert!(contents(&out) == before);
}

/// Runs a build that may write files of 8 kB at most, as on a disk that fills up.
#[cfg(unix)]
#[test]
fn a_full_disk_leaves_the_old_set_and_nothing_else() {
    let folder = with_impeller();
    build(&folder, "out").code(0);
    let out = folder.path().join("out");
    let before = contents(&out);
    workbook(&folder.path().join("impeller.xlsx"), &[("a_p", Value::Real(1.0)), ("n", Value::Whole(2000))]);
    let limited = format!(
        "trap '' XFSZ; ulimit -f 8; exec '{}' build impeller.xlsx --no-report -o out",
        env!("CARGO_BIN_EXE_rodete")
    );
    assert_cmd::Command::new("bash")
        .args(["-c", &limited])
        .current_dir(folder.path())
        .assert()
        .code(5)
        .stderr(predicate::str::starts_with("error S0102: cannot write to out/impeller-results.xlsx: the file exceeds"))
        .stderr(predicate::str::contains("impeller.xlsx: nothing was written"));
    assert!(contents(&out) == before);
}

/// Starts a build that waits for the folder, as it would for another run, and interrupts it there.
#[cfg(unix)]
#[test]
fn an_interruption_leaves_the_old_set_and_nothing_else() {
    use std::process::{Command, Stdio};
    use std::thread::sleep;
    use std::time::Duration;

    for (signal, locale, told) in [("-INT", "C", "interrupted: "), ("-TERM", "es_ES.UTF-8", "interrumpido: ")] {
        let folder = with_impeller();
        build(&folder, "out").code(0);
        let out = folder.path().join("out");
        let held = fs::File::create(out.join(".rodete.lock")).expect("a lock file");
        held.lock().expect("a lock");
        let before = contents(&out);
        let child = Command::new(env!("CARGO_BIN_EXE_rodete"))
            .args(["build", "impeller.xlsx", "--no-report", "-o", "out"])
            .current_dir(folder.path())
            .env("LC_ALL", locale)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("started");
        let drafts = || names(&out).iter().filter(|name| name.ends_with(".tmp")).count();
        for _ in 0..3000 {
            if drafts() == OUTPUTS.len() {
                break;
            }
            sleep(Duration::from_millis(10));
        }
        assert_eq!(drafts(), OUTPUTS.len(), "the build waits with everything written");
        assert!(Command::new("kill").args([signal, &child.id().to_string()]).status().expect("kill").success());
        let done = child.wait_with_output().expect("ended");
        assert_eq!(done.status.code(), Some(130), "{signal}");
        assert!(String::from_utf8_lossy(&done.stderr).starts_with(told), "{signal}");
        assert!(contents(&out) == before, "{signal}");
    }
}

/// Typst runs in a folder of its own, and a path on the command line is meant from where the user is.
#[cfg(unix)]
#[test]
fn a_typst_named_from_here_is_started_from_here() {
    use std::os::unix::fs::PermissionsExt;
    let folder = with_impeller();
    fs::create_dir(folder.path().join("bin")).unwrap();
    let program = folder.path().join("bin/typst");
    fs::write(&program, "#!/bin/sh\ntouch \"$(dirname \"$0\")/started\"\nexit 1\n").unwrap();
    fs::set_permissions(&program, fs::Permissions::from_mode(0o755)).unwrap();
    rodete(&folder).args(["build", "impeller.xlsx", "--typst", "bin/typst"]).assert().code(6);
    assert!(folder.path().join("bin/started").exists());
}

/// Interrupts a build while typst works.
#[cfg(unix)]
#[test]
fn an_interruption_takes_the_report_s_child_and_its_folder_along() {
    use std::os::unix::fs::PermissionsExt;
    use std::process::{Command, Stdio};
    use std::thread::sleep;
    use std::time::Duration;

    let folder = with_impeller();
    let temporary = folder.path().join("temporary");
    fs::create_dir(&temporary).expect("a folder");
    let slow = folder.path().join("typst");
    fs::write(&slow, "#!/bin/sh\necho $$ > \"$PID\"\nexec sleep 50\n").expect("a script");
    fs::set_permissions(&slow, fs::Permissions::from_mode(0o755)).expect("its mode");
    let pid = folder.path().join("pid");
    let child = Command::new(env!("CARGO_BIN_EXE_rodete"))
        .args(["build", "impeller.xlsx", "--typst"])
        .arg(&slow)
        .current_dir(folder.path())
        .env("TMPDIR", &temporary)
        .env("PID", &pid)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("started");
    let running = || fs::read_to_string(&pid).ok().filter(|text| text.ends_with('\n'));
    for _ in 0..1000 {
        if running().is_some() {
            break;
        }
        sleep(Duration::from_millis(10));
    }
    let typst = running().expect("typst was started");
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill").success());
    let done = child.wait_with_output().expect("ended");
    assert_eq!(done.status.code(), Some(130));
    let alive = Command::new("kill").args(["-0", typst.trim()]).stderr(Stdio::null()).status().expect("kill");
    assert!(!alive.success(), "typst is still running");
    assert!(names(&temporary).is_empty());
    assert!(!folder.path().join("impeller-out").exists());
}

/// What a killed process leaves is at most its temporary files; the next run removes them once they are old.
#[cfg(unix)]
#[test]
fn a_killed_run_leaves_the_old_set_whole() {
    use std::process::{Command, Stdio};
    use std::time::{Duration, SystemTime};

    let folder = with_impeller();
    build(&folder, "out").code(0);
    let out = folder.path().join("out");
    let before = contents(&out);
    let held = fs::File::create(out.join(".rodete.lock")).expect("a lock file");
    held.lock().expect("a lock");
    let mut child = Command::new(env!("CARGO_BIN_EXE_rodete"))
        .args(["build", "impeller.xlsx", "--no-report", "-o", "out"])
        .current_dir(folder.path())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("started");
    let drafts = || -> Vec<_> { names(&out).into_iter().filter(|name| name.ends_with(".tmp")).collect() };
    while drafts().len() < OUTPUTS.len() {
        assert_eq!(child.try_wait().expect("a state"), None, "the build waits");
        std::thread::sleep(Duration::from_millis(10));
    }
    child.kill().expect("killed");
    child.wait().expect("ended");
    drop(held);
    for name in OUTPUTS {
        assert_eq!(
            fs::read(out.join(name)).expect(name),
            before.iter().find(|(one, _)| one == Path::new(name)).expect(name).1
        );
    }
    assert_eq!(drafts().len(), OUTPUTS.len());
    for name in drafts() {
        let file = fs::OpenOptions::new().write(true).open(out.join(name)).expect("a leftover");
        file.set_modified(SystemTime::now() - Duration::from_secs(120)).expect("an old date");
    }
    build(&folder, "out").code(0);
    assert!(contents(&out) == before);
}
