//! Sweeps that are interrupted or killed, that find the disk full, and two at once in one folder: what they leave is gone on with, and the
//! summary is that of a run that nothing disturbed.

#![cfg(unix)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use rodete::kinds::KINDS;
use rodete::sweep::asked;
use rodete::sweep::file;
use rodete::sweep::table::{Cells, Table};
use rodete::text::Language;
use rodete::workbook::sweep_sheet;
use rustix::process::{Pid, Signal, kill_process};

use crate::common::workbook::{quick, thick, with_variants_of};

/// A folder with a workbook of 48 designs, judged by their programs.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.xlsx"), book()).unwrap();
    folder
}

fn book() -> Vec<u8> {
    let settings = [("method", "factorial"), ("objectives", "time_s min; clearance_mm max")];
    let inputs = [["R", "24", "30", "2", "", ""], ["N", "", "", "", "4; 5; 6", ""], ["e", "1", "4", "1", "", ""]];
    with_variants_of(&thick(quick()), &settings, &inputs, &[])
}

fn sweep(folder: &Path, words: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rodete"));
    command.current_dir(folder).env("LC_ALL", "C").args(["sweep", "a.xlsx", "--top", "0"]);
    command.args(words.split_whitespace()).stdout(Stdio::null()).stderr(Stdio::null());
    command
}

#[track_caller]
fn done(folder: &Path, words: &str) -> Vec<u8> {
    assert_eq!(sweep(folder, words).status().unwrap().code(), Some(0), "{words}");
    let place = words.split_whitespace().nth(1).unwrap();
    fs::read(folder.join(place).join("summary.parquet")).unwrap()
}

fn send(child: &Child, signal: Signal) {
    let id = Pid::from_raw(i32::try_from(child.id()).unwrap()).unwrap();
    // It may have ended before.
    let _ = kill_process(id, signal);
}

/// Waits until a run listens to Ctrl-C: a signal before ends it as any program, on a busy machine long after its start. Where the
/// system does not say, nothing is waited for.
fn listening(child: &Child) {
    const INTERRUPT: u64 = 1 << 1;
    for _ in 0..10_000 {
        let status = fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap_or_default();
        let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:"));
        match caught.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()) {
            Some(mask) if mask & INTERRUPT == 0 => sleep(Duration::from_millis(1)),
            _ => return,
        }
    }
}

/// The files of the folder of chunks that are neither chunks nor what they took.
fn others(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder.join("s/chunks")) else { return Vec::new() };
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_none_or(|ending| ending != "parquet" && ending != "json"));
    paths
}

#[test]
fn a_run_that_is_interrupted_or_killed_anywhere_is_gone_on_with() {
    let folder = folder();
    let at = folder.path();
    let whole = done(at, "-o whole");
    for (signal, code) in [(Signal::INT, Some(130)), (Signal::TERM, Some(130)), (Signal::KILL, None)] {
        let _ = fs::remove_dir_all(at.join("s"));
        let (mut ended, mut wait) = (0, 30);
        // Until it comes to its end before the signal.
        while ended == 0 {
            let mut child = sweep(at, "-o s --chunks 24 --jobs 1").spawn().unwrap();
            listening(&child);
            sleep(Duration::from_millis(wait));
            send(&child, signal);
            let status = child.wait().unwrap();
            if status.code() == Some(0) {
                ended += 1;
            } else {
                assert_eq!(status.code(), code, "{signal:?} after {wait} ms");
                assert!(code.is_none() || others(at).is_empty(), "{:?}", others(at));
            }
            wait = wait * 3 / 2;
        }
        assert!(fs::read(at.join("s/summary.parquet")).unwrap() == whole, "{signal:?}");
        assert!(done(at, "-o s") == whole, "{signal:?}, once more");
    }
}

#[test]
fn a_run_that_is_interrupted_says_how_to_go_on() {
    let folder = folder();
    let mut command = sweep(folder.path(), "-o s --chunks 24 --jobs 1");
    let child = command.stderr(Stdio::piped()).spawn().unwrap();
    listening(&child);
    send(&child, Signal::INT);
    let ended = child.wait_with_output().unwrap();
    let told = String::from_utf8(ended.stderr).unwrap();
    assert_eq!(ended.status.code(), Some(130), "{told}");
    assert!(told.ends_with("interrupted: run the same command again to go on\n"), "{told}");
}

#[test]
fn what_was_saved_of_a_chunk_is_not_worked_out_again() {
    let folder = folder();
    let at = folder.path();
    let whole = done(at, "-o s --chunks 1");
    let mut there = fs::read_dir(at.join("s/chunks")).unwrap().map(|entry| entry.unwrap().path());
    let chunk = there.find(|path| path.extension().is_some_and(|ending| ending == "parquet")).unwrap();
    // The first 20 rows as an interrupted run saves them, one of them with a mark.
    let bytes = book();
    let sheet = sweep_sheet::read(&bytes, KINDS[0].form(), Language::En).unwrap().unwrap();
    let plan = asked::plan(KINDS[0], &sheet.fields, sheet.designs).unwrap().0;
    let told: serde_json::Value = serde_json::from_slice(&fs::read(at.join("s/plan.json")).unwrap()).unwrap();
    let told = told["plan"].to_string();
    let mut rows = file::read(fs::read(&chunk).unwrap(), &Table::of(KINDS[0], &plan), &told, &|_| true).unwrap();
    let mut saved = rows.split(20);
    for column in &mut saved.columns {
        if let (Cells::Text(cells), "message") = (&mut column.cells, column.name.as_str()) {
            cells[3] = Some("a mark".into());
        }
    }
    let name = chunk.file_stem().unwrap().to_str().unwrap();
    let part = chunk.with_file_name(format!(".{name}.part"));
    fs::write(&part, file::bytes(saved, &told).unwrap()).unwrap();
    fs::remove_file(&chunk).unwrap();
    done(at, "-o s --csv");
    let csv = fs::read_to_string(at.join("s/summary.csv")).unwrap();
    let marked: Vec<&str> = csv.lines().filter(|line| line.contains("a mark")).collect();
    assert!(marked.len() == 1 && marked[0].starts_with("3,"), "{marked:?}");
    assert!(!part.exists(), "what was saved is gone with the chunk");
    // What is saved is torn: it is worked out again.
    fs::write(&part, b"PAR1 torn").unwrap();
    fs::remove_file(&chunk).unwrap();
    assert!(done(at, "-o s") == whole);
}

#[test]
fn two_runs_in_one_folder_at_once_do_each_other_no_harm() {
    let folder = folder();
    let at = folder.path();
    let whole = done(at, "-o whole");
    done(at, "-o s --chunks 12 --limit 48");
    for entry in fs::read_dir(at.join("s/chunks")).unwrap() {
        fs::remove_file(entry.unwrap().path()).unwrap();
    }
    let mut runs: Vec<Child> = (0..2).map(|_| sweep(at, "-o s --jobs 1").spawn().unwrap()).collect();
    for run in &mut runs {
        assert_eq!(run.wait().unwrap().code(), Some(0));
    }
    assert!(fs::read(at.join("s/summary.parquet")).unwrap() == whole);
}

#[test]
fn a_full_disk_leaves_whole_chunks_only_and_the_run_is_gone_on_with() {
    let folder = folder();
    let at = folder.path();
    let whole = done(at, "-o whole");
    // A file may have so many bytes and no more, as a quota has it: none, that of the plan, that of a chunk, but not that of the summary.
    for most in [0, 4096, 24 * 1024] {
        let _ = fs::remove_dir_all(at.join("s"));
        let mut shell = Command::new("sh");
        shell.current_dir(at).env("LC_ALL", "C").stdout(Stdio::null()).stderr(Stdio::piped());
        // A write beyond the limit then fails, and raises no signal.
        shell.args(["-c", "trap '' XFSZ; ulimit -f \"$1\"; exec \"$2\" sweep a.xlsx --top 0 -o s --chunks 4", "sh"]);
        let ended = shell.arg((most / 512).to_string()).arg(env!("CARGO_BIN_EXE_rodete")).output().unwrap();
        assert_eq!(ended.status.code(), Some(5), "{most}: {}", String::from_utf8_lossy(&ended.stderr));
        assert!(others(at).is_empty(), "{most}: {:?}", others(at));
        // It may be the results workbook that does not fit.
        let summary = fs::read(at.join("s/summary.parquet"));
        assert!(summary.is_err() || most > 4096 && summary.unwrap() == whole, "{most}");
        assert!(done(at, "-o s") == whole, "{most}");
    }
}
