//! What Slurm is given, and what it answers: other programs stand in its place.

#![cfg(unix)]

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Command, Output};

use crate::common::workbook::with_variants;

/// A folder with a workbook of three designs, and programs in the place of others.
fn folder(programs: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let settings = [("method", "factorial"), ("level", "limits")];
    let book = with_variants(&settings, &[["N", "", "", "", "3; 4; 5", ""]], &[]);
    fs::write(folder.path().join("a.xlsx"), book).unwrap();
    for (name, does) in programs {
        let path = folder.path().join(name);
        fs::write(&path, format!("#!/bin/sh\n{does}\n")).unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
    }
    folder
}

/// A command that finds these programs first.
fn command(folder: &Path, program: &str) -> Command {
    let path = format!("{}:{}", folder.display(), std::env::var("PATH").unwrap());
    let mut command = Command::new(program);
    command.current_dir(folder).env("LC_ALL", "C").env("PATH", path);
    command
}

fn submitted(folder: &Path) -> Output {
    let words = ["sweep", "a.xlsx", "-o", "s", "--submit", "slurm", "--chunks", "2"];
    command(folder, env!("CARGO_BIN_EXE_rodete")).args(words).output().unwrap()
}

/// In the last task of an array `SLURM_JOB_ID` is the number of the array, which stands for all its tasks.
#[test]
fn a_task_whose_program_is_killed_is_queued_again_alone_and_twice_at_most() {
    let folder = folder(&[
        ("sbatch", "echo 70"),
        ("scontrol", "echo \"$@\" >> told"),
        ("sleep", "exit 0"),
        ("killed", "kill -9 $$"),
    ]);
    let at = folder.path();
    let output = submitted(at);
    assert_eq!(String::from_utf8_lossy(&output.stdout), "job 70: chunks 0-1 of 2\njob 70: merge\n");
    let script = fs::read_to_string(at.join("s/sweep.sbatch")).unwrap();
    let script = script.replace(env!("CARGO_BIN_EXE_rodete"), at.join("killed").to_str().unwrap());
    fs::write(at.join("task"), script).unwrap();
    let array = [("SLURM_ARRAY_JOB_ID", "70"), ("SLURM_ARRAY_TASK_ID", "1")];
    for (job, array, restarts, told) in [
        ("70", &array[..], "0", "requeue 70_1\n"),
        ("93", &array[..], "1", "requeue 70_1\n"),
        ("71", &[], "0", "requeue 71\n"),
        ("93", &array[..], "2", ""),
    ] {
        fs::write(at.join("told"), "").unwrap();
        let mut task = command(at, "bash");
        task.arg("task").env("SLURM_JOB_ID", job).env("SLURM_RESTART_COUNT", restarts).envs(array.iter().copied());
        assert_eq!(task.output().unwrap().status.code(), Some(137));
        assert_eq!(fs::read_to_string(at.join("told")).unwrap(), told, "{job} {array:?} {restarts}");
    }
}

/// What another program answers keeps its lines, and nothing in them moves a cursor.
#[test]
fn what_sbatch_says_in_several_lines_is_told_in_as_many() {
    let answer =
        "printf 'sbatch: error: no such partition\\r\\n\\nsbatch: error: \\033[1mjob not submitted\\n' >&2; exit 1";
    let folder = folder(&[("sbatch", answer)]);
    let output = submitted(folder.path());
    let told = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{told}");
    let said = "sbatch: error: no such partition\nsbatch: error: \\u{1b}[1mjob not submitted\nhint: ";
    assert!(told.contains(said) && !told.contains("\\u{a}"), "{told}");
}
