//! A set that a killed run left half delivered: every command that comes into the folder completes it or tells its names.

use std::ffi::OsStr;
use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use predicates::prelude::*;
use rodete::store::{Disk, Existing, Folder, Set, Step};
use tempfile::TempDir;

use super::common::{folder, names, rodete, with_impeller};

const OLD: &str = "G90 G0 X1\nM30\n";
const NEW: &str = "G90 G0 X2\nM30\n";
const FILES: [&str; 2] = ["impeller-blade.nc", "impeller-impeller.nc"];

/// Ends a delivery into `impeller-out` between its two renames: one program is new, the other old.
fn half(folder: &TempDir) -> std::path::PathBuf {
    let out = folder.path().join("impeller-out");
    fs::create_dir(&out).expect("a folder");
    for name in FILES {
        fs::write(out.join(name), OLD).expect("an old program");
    }
    let renames = AtomicUsize::new(0);
    let dead = Disk::watched(move |step, _| {
        // The notice, the first program, and then no more.
        let at = renames.fetch_add(usize::from(step == Step::Rename), Ordering::SeqCst);
        if at > 2 || (at == 2 && step == Step::Rename) { Err(io::Error::from_raw_os_error(5)) } else { Ok(()) }
    });
    {
        let folder = Folder::open_on(&out, &dead).expect("a folder");
        let mut set = Set::new(&folder, &[], Existing::Replace);
        for name in FILES {
            set.write(OsStr::new(name), |to| to.write_all(NEW.as_bytes())).expect("written");
        }
        set.commit().expect_err("ended");
    }
    assert_eq!(programs(&out), [NEW, OLD]);
    out
}

fn programs(out: &Path) -> [String; 2] {
    FILES.map(|name| fs::read_to_string(out.join(name)).expect(name))
}

/// Every command, and the exit code where files are mixed for good.
const COMMANDS: [(&[&str], i32); 6] = [
    (&["check", "impeller.xlsx"], 3),
    (&["view", "impeller.xlsx"], 3),
    (&["view", "impeller-out/impeller-impeller.nc"], 3),
    (&["verify", "impeller-out/impeller-impeller.nc"], 3),
    (&["verify", "impeller-out/impeller-impeller.nc", "--json"], 3),
    (&["build", "impeller.xlsx", "--no-report"], 5),
];

#[test]
fn every_command_completes_a_set_that_a_killed_run_left_half_delivered() {
    for (command, _) in COMMANDS {
        let folder = with_impeller();
        let out = half(&folder);
        let done = rodete(&folder).args(command).output().expect("run");
        assert_eq!(done.status.code(), Some(0), "{command:?}: {}", String::from_utf8_lossy(&done.stderr));
        let said = [done.stderr, done.stdout].map(|text| String::from_utf8_lossy(&text).into_owned()).concat();
        let wanted = "the set was completed: impeller-blade.nc, impeller-impeller.nc";
        assert!(said.contains("a run was interrupted while delivering its files to"), "{command:?}: {said}");
        assert!(said.contains(wanted), "{command:?}: {said}");
        if command[0] != "build" {
            assert_eq!(programs(&out), [NEW, NEW], "{command:?}");
            assert!(names(&out).iter().all(|name| !name.starts_with('.')), "{command:?}: {:?}", names(&out));
        }
        // Once: the next one has nothing to tell.
        rodete(&folder)
            .args(["verify", "impeller-out/impeller-impeller.nc"])
            .assert()
            .stderr(predicate::str::contains("stopped").not());
    }
}

#[test]
fn a_mixed_set_that_cannot_be_mended_is_refused_by_every_command_with_its_names() {
    for (command, code) in COMMANDS {
        let folder = with_impeller();
        let out = half(&folder);
        for name in names(&out).into_iter().filter(|name| name.ends_with(".tmp")) {
            fs::remove_file(out.join(name)).expect("a temporary file");
        }
        let done = rodete(&folder).args(command).output().expect("run");
        assert_eq!(done.status.code(), Some(code), "{command:?}");
        let said = [done.stderr, done.stdout].map(|text| String::from_utf8_lossy(&text).into_owned()).concat();
        let wanted = "do not belong together: a run was interrupted while delivering them; new: impeller-blade.nc; of \
                      before: impeller-impeller.nc";
        assert!(said.contains(wanted), "{command:?}: {said}");
        assert!(said.contains("use none of these files; delete the new ones and build again"), "{command:?}: {said}");
        assert_eq!(programs(&out), [NEW, OLD], "{command:?}");
        fs::remove_file(out.join(FILES[0])).expect("the new one");
        rodete(&folder).args(["verify", "impeller-out/impeller-impeller.nc"]).assert().code(0);
    }
}

#[test]
fn offsets_and_new_see_to_their_folder_too() {
    let folder = folder();
    let out = half(&folder);
    rodete(&folder)
        .args(["new", "impeller", "impeller-out/new.xlsx"])
        .assert()
        .code(0)
        .stderr(predicate::str::contains("the set was completed"));
    assert_eq!(programs(&out), [NEW, NEW]);
    let folder = self::folder();
    let out = half(&folder);
    rodete(&folder)
        .args(["offsets", "impeller-out/linuxcnc.var", "--set", "G55 X1"])
        .assert()
        .code(0)
        .stderr(predicate::str::contains("the set was completed"));
    assert_eq!(programs(&out), [NEW, NEW]);
}
