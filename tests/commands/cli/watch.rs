//! The command `watch`: saves as Excel and LibreOffice make them, many in a row, half of one.

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use rodete::parameter::Value;
use rodete::store::sha256;
use tempfile::TempDir;

use super::common::{names, with_impeller, workbook};

/// For so long a machine with much to do may take.
const PATIENCE: Duration = Duration::from_secs(120);

/// `watch` at work in a folder.
struct Watching {
    child: Child,
    lines: Receiver<String>,
    folder: TempDir,
}

impl Watching {
    /// Begins in a folder with `impeller.xlsx`, and waits until it waits.
    fn begin(more: &[&str]) -> Self {
        let folder = with_impeller();
        let mut child = Command::new(assert_cmd::cargo::cargo_bin("rodete"))
            .args(["watch", "impeller.xlsx", "--no-report"])
            .args(more)
            .current_dir(folder.path())
            .env("LC_ALL", "C")
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("it starts");
        let out = child.stdout.take().expect("its output");
        let (sender, lines) = channel();
        std::thread::spawn(move || {
            for line in BufReader::new(out).lines().map_while(Result::ok) {
                if sender.send(line).is_err() {
                    break;
                }
            }
        });
        let watching = Self { child, lines, folder };
        assert_eq!(watching.line(), "watching impeller.xlsx; the results go to impeller-out");
        let now = watching.line();
        assert!(now.starts_with("building now and with every save: tables and programs"), "{now}");
        assert_eq!(now.contains("viewer's page"), more.contains(&"--view"), "{now}");
        assert!(watching.line().contains("files in impeller-out"));
        assert_eq!(watching.line(), "waiting for saves; Ctrl-C ends");
        watching
    }

    fn line(&self) -> String {
        self.lines.recv_timeout(PATIENCE).expect("a line")
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// The bytes of the workbook with values changed.
    fn made(&self, changes: &[(&'static str, Value)]) -> Vec<u8> {
        let elsewhere = super::common::folder();
        let path = elsewhere.path().join("impeller.xlsx");
        workbook(&path, changes);
        fs::read(path).expect("a workbook")
    }

    /// The SHA-256 that the program's header names.
    fn named(&self) -> String {
        let text = fs::read_to_string(self.path("impeller-out/impeller-impeller.nc")).expect("a program");
        let lines: Vec<&str> = text.lines().map(|line| line.trim_matches([';', '(', ')', '\r'])).collect();
        let at = lines.iter().position(|line| line.starts_with("SHA-256")).expect("a sum");
        format!("{}{}", lines[at].trim_start_matches("SHA-256").trim(), lines[at + 1].trim()).to_lowercase()
    }

    /// Interrupts it, and gives its exit code.
    fn end(mut self) -> (Option<i32>, Vec<String>) {
        let id = rustix::process::Pid::from_child(&self.child);
        rustix::process::kill_process(id, rustix::process::Signal::INT).expect("it is there");
        let status = self.child.wait().expect("it ends");
        (status.code(), names(self.folder.path()))
    }
}

impl Drop for Watching {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Saves as Excel does: a lock file, a temporary file, two renames.
fn as_excel(path: &Path, bytes: &[u8]) {
    let folder = path.parent().expect("a folder");
    let (lock, fresh, old) = (folder.join("~$impeller.xlsx"), folder.join("5A1B0000"), folder.join("8F3C.tmp"));
    fs::write(&lock, "user").expect("a lock file");
    fs::write(&fresh, bytes).expect("a temporary file");
    fs::rename(path, &old).expect("a rename");
    fs::rename(&fresh, path).expect("a rename");
    fs::remove_file(old).expect("it can be removed");
    fs::remove_file(lock).expect("it can be removed");
}

/// Saves as LibreOffice does: a lock file, and bytes over the file.
fn as_libreoffice(path: &Path, bytes: &[u8]) {
    let lock = path.with_file_name(".~lock.impeller.xlsx#");
    fs::write(&lock, "user").expect("a lock file");
    fs::write(path, bytes).expect("a workbook");
    fs::remove_file(lock).expect("it can be removed");
}

#[test]
fn a_save_of_excel_or_libreoffice_is_built_once_and_says_what_changed() {
    for (save, more) in
        [(as_excel as fn(&Path, &[u8]), &[][..]), (as_libreoffice, &[][..]), (as_excel, &["--poll", "0.2"][..])]
    {
        let watching = Watching::begin(more);
        let path = watching.path("impeller.xlsx");
        let fewer = watching.made(&[("N", Value::Whole(3))]);
        save(&path, &fewer);
        let line = watching.line();
        assert!(line.starts_with("impeller.xlsx: N 4 → 3; programs changed: "), "{line}");
        assert!(line.contains(" files in impeller-out; ") && line.ends_with(" s"), "{line}");
        assert_eq!(watching.named(), sha256(&fewer));
        // Another file of the folder, and a save without a change, are none of its business.
        fs::write(watching.path("notes.txt"), "x").expect("a file");
        save(&path, &fewer);
        let back = watching.made(&[]);
        save(&path, &back);
        let line = watching.line();
        assert!(line.starts_with("impeller.xlsx: N 3 → 4; programs changed: "), "{line}");
        let out = names(watching.path("impeller-out"));
        assert!(out.iter().all(|name| name.starts_with("impeller-")), "{out:?}");
        let (code, left) = watching.end();
        assert_eq!(code, Some(130));
        assert_eq!(left, ["impeller-out", "impeller.xlsx", "notes.txt"]);
    }
}

#[test]
fn a_workbook_that_is_renamed_is_missed_once_and_built_when_it_is_back() {
    let watching = Watching::begin(&["--poll", "0.2"]);
    let path = watching.path("impeller.xlsx");
    fs::rename(&path, watching.path("other.xlsx")).expect("renamed");
    let line = watching.line();
    assert_eq!(line, "impeller.xlsx: no longer there; rodete waits for it");
    fs::write(&path, watching.made(&[("N", Value::Whole(3))])).expect("it is back");
    assert_eq!(watching.line(), "impeller.xlsx: it is back");
    let line = watching.line();
    assert!(line.starts_with("impeller.xlsx: N 4 → 3; programs changed: "), "{line}");
    watching.end();
}

#[test]
fn of_two_hundred_saves_in_a_row_the_last_is_built_and_nothing_is_left() {
    let watching = Watching::begin(&[]);
    let path = watching.path("impeller.xlsx");
    let one = watching.made(&[("N", Value::Whole(3))]);
    let two = watching.made(&[("e", Value::Real(1.5))]);
    let last = watching.made(&[("part", Value::Line("last".into()))]);
    for at in 0..200 {
        as_excel(
            &path,
            match at {
                199 => &last,
                _ if at % 2 == 0 => &one,
                _ => &two,
            },
        );
        std::thread::sleep(Duration::from_millis(at % 7));
    }
    let begun = Instant::now();
    while watching.named() != sha256(&last) {
        assert!(begun.elapsed() < PATIENCE, "the last save was not built");
        std::thread::sleep(Duration::from_millis(50));
    }
    // Every build that was brought to its end has a line, and the last one is of the last save.
    std::thread::sleep(Duration::from_secs(3));
    let lines: Vec<String> = watching.lines.try_iter().collect();
    assert!((1..=200).contains(&lines.len()), "{lines:#?}");
    assert!(lines.iter().all(|line| line.contains(" files in impeller-out; ")), "{lines:#?}");
    assert_eq!(watching.named(), sha256(&last));
    let out = names(watching.path("impeller-out"));
    assert!(out.iter().all(|name| name.starts_with("impeller-")), "{out:?}");
    let (_, left) = watching.end();
    assert_eq!(left, ["impeller-out", "impeller.xlsx"]);
}

#[test]
fn half_of_a_file_and_a_rejected_workbook_leave_the_earlier_set_and_the_next_save_is_right_again() {
    let watching = Watching::begin(&["--view"]);
    let (path, before) = (watching.path("impeller.xlsx"), watching.named());
    let whole = watching.made(&[("N", Value::Whole(3))]);
    let page = || fs::read_to_string(watching.path("impeller-out/impeller-viewer.html")).expect("a page");
    let first = page();
    assert!(first.contains("location.reload()"));
    fs::write(&path, &whole[..whole.len() / 2]).expect("half a file");
    let line = watching.line();
    assert!(line.starts_with("impeller.xlsx: nothing was written; "), "{line}");
    assert_eq!(watching.named(), before);
    as_excel(&path, &watching.made(&[("N", Value::Whole(40))]));
    let line = watching.line();
    assert!(line.starts_with("impeller.xlsx: N 4 → 40; new: P"), "{line}");
    assert!(line.contains("rejected; nothing was written: the earlier files are not of this workbook"), "{line}");
    assert_eq!(watching.named(), before);
    as_excel(&path, &whole);
    let line = watching.line();
    assert!(line.starts_with("impeller.xlsx: N 40 → 3; programs changed: "), "{line}");
    assert!(line.contains("gone: P1005"), "{line}");
    assert_eq!(watching.named(), sha256(&whole));
    assert_ne!(page(), first);
    assert_eq!(watching.end().0, Some(130));
}

#[test]
fn a_workbook_that_is_not_there_is_not_waited_for() {
    let folder = super::common::folder();
    super::common::rodete(&folder).args(["watch", "no.xlsx"]).assert().code(4);
    super::common::rodete(&folder).args(["watch", "no.xlsx", "--poll", "0"]).assert().code(2);
}
