//! `build --into` killed while it writes: the workbook is the old one or the new one, whole.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use super::made::{book, read, with_form};

use rodete::kinds::KINDS;

const BOOK: &str = "h1.xlsx";

fn build(folder: &Path) -> Child {
    Command::new(assert_cmd::cargo::cargo_bin("rodete"))
        .args(["build", BOOK, "--into", "--no-report"])
        .current_dir(folder)
        .env("LC_ALL", "C")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("it starts")
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut names: Vec<String> =
        entries.filter_map(|entry| Some(entry.ok()?.file_name().to_string_lossy().into_owned())).collect();
    names.sort();
    names
}

/// All names but those of drafts.
fn finished(folder: &Path) -> Vec<String> {
    names(folder).into_iter().filter(|name| !name.starts_with(".rodete-")).collect()
}

/// Waits until a file that is being written stands beside the workbook, or the process has ended.
fn wait_for_a_draft(folder: &Path, child: &mut Child) {
    while child.try_wait().expect("it can be asked").is_none() {
        if names(folder).iter().any(|name| name.starts_with(".rodete") && name.ends_with(".tmp")) {
            return;
        }
        std::thread::sleep(Duration::from_micros(50));
    }
}

#[test]
fn a_build_into_a_workbook_that_is_killed_at_any_moment_leaves_the_old_or_the_new_workbook_whole() {
    const KILLS: u32 = 20;
    let old = with_form(KINDS[0], &book(BOOK));
    let folder = tempfile::tempdir().expect("a temporary folder");
    let here = folder.path().join(BOOK);
    fs::write(&here, &old).expect("the book");
    let begun = Instant::now();
    assert!(build(folder.path()).wait().expect("it ends").success());
    let took = begun.elapsed();
    let new = fs::read(&here).expect("the book");
    assert_ne!(old, new);
    let kept = finished(folder.path());
    let (mut olds, mut cut) = (0, 0);
    for kill in 0..KILLS {
        fs::write(&here, &old).expect("the book");
        let mut child = build(folder.path());
        // Half of them anywhere, half of them while files are written and renamed.
        if kill % 2 == 0 {
            std::thread::sleep(took * kill / KILLS);
        } else {
            wait_for_a_draft(folder.path(), &mut child);
            std::thread::sleep(Duration::from_micros(u64::from(kill * kill) * 40));
        }
        child.kill().expect("it can be killed");
        let ended = child.wait().expect("it ends");
        cut += u32::from(!ended.success());
        let left = fs::read(&here).expect("the workbook is there");
        olds += u32::from(left == old);
        assert!(left == old || left == new, "kill {kill}: {} bytes", left.len());
        // The next build sees to whatever the killed one has left, but for drafts, which are removed when they are old.
        assert!(build(folder.path()).wait().expect("it ends").success(), "kill {kill}");
        assert_eq!(finished(folder.path()), kept, "kill {kill}");
        assert!(!folder.path().join("h1-out/.rodete-delivery.json").exists(), "kill {kill}");
        read(&fs::read(&here).expect("the workbook is there"));
    }
    assert!(cut > KILLS / 3, "{cut} of {KILLS} builds were cut short");
    assert!(olds > 0, "every kill came too late");
}
