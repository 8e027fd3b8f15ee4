//! The store: a file under its final name is whole, old or new, whatever happens.

#![allow(clippy::expect_used)]

use std::ffi::OsStr;
use std::fs::{self, File};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::Path;
use std::time::{Duration, SystemTime};

mod killed;
mod replaced;

use rodete::finding::{Exit, Refusal};
use rodete::store::{Existing, Folder, Set, WrittenFile, namesake, sha256};
use tempfile::TempDir;

fn folder() -> TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

fn set<'f>(folder: &'f Folder) -> Set<'f> {
    Set::new(folder, &[], Existing::Replace)
}

fn write(set: &mut Set<'_>, name: &str, contents: &str) -> Result<WrittenFile, Refusal> {
    set.write(OsStr::new(name), |out| out.write_all(contents.as_bytes())).cloned()
}

/// Every name in a folder, sorted.
fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> = fs::read_dir(folder)
        .expect("a readable folder")
        .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

fn said(refusal: &Refusal) -> String {
    refusal.findings.iter().map(|one| format!("{} | {}\n", one.what.en, one.remedy.en)).collect()
}

#[test]
fn nothing_appears_before_the_set_is_complete() {
    let there = folder();
    let folder = Folder::open(there.path()).expect("a folder");
    let mut set = set(&folder);
    write(&mut set, "a.nc", "N10 G90\n").expect("written");
    assert!(!there.path().join("a.nc").exists());
    write(&mut set, "b.nc", "").expect("written");
    assert!(names(there.path()).iter().all(|name| name.starts_with(".rodete-") && name.ends_with(".tmp")));
    let files = set.commit().expect("committed");
    assert_eq!(names(there.path()), ["a.nc", "b.nc"]);
    assert_eq!(fs::read(there.path().join("a.nc")).expect("a.nc"), b"N10 G90\n");
    assert_eq!(files.iter().map(|file| file.bytes).collect::<Vec<_>>(), [8, 0]);
    assert_eq!(files[0].sha256, sha256(b"N10 G90\n"));
    assert_eq!(files[1].sha256, "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

#[test]
fn the_sum_is_that_of_what_stands_in_the_file_after_seeking() {
    let there = folder();
    let folder = Folder::open(there.path()).expect("a folder");
    let mut set = set(&folder);
    let written = set.write(OsStr::new("a"), |out| {
        out.write_all(b"....tail")?;
        out.seek(SeekFrom::Start(0))?;
        out.write_all(b"head")
    });
    assert_eq!(written.expect("written").sha256, sha256(b"headtail"));
    assert_eq!(fs::read(set.draft(OsStr::new("a")).expect("in the set")).expect("a draft"), b"headtail");
    assert_eq!(set.draft(OsStr::new("b")), None);
}

#[test]
fn a_file_that_is_written_again_keeps_its_place_and_leaves_nothing_of_its_first_version() {
    let there = folder();
    let folder = Folder::open(there.path()).expect("a folder");
    let mut set = set(&folder);
    write(&mut set, "a", "first").expect("written");
    write(&mut set, "b", "b").expect("written");
    set.write_again(OsStr::new("a"), |out| out.write_all(b"second")).expect("written");
    assert_eq!(names(there.path()).len(), 2);
    let files = set.commit().expect("committed");
    assert_eq!(files.iter().map(|file| file.name.to_string_lossy()).collect::<Vec<_>>(), ["a", "b"]);
    assert_eq!(files[0].sha256, sha256(b"second"));
    assert_eq!(fs::read(there.path().join("a")).expect("a"), b"second");
}

#[test]
fn a_set_that_is_dropped_leaves_the_old_files_and_nothing_else() {
    let there = folder();
    fs::write(there.path().join("a.nc"), "old").expect("an old file");
    {
        let folder = Folder::open(there.path()).expect("a folder");
        let mut set = set(&folder);
        write(&mut set, "a.nc", "new").expect("written");
    }
    assert_eq!(names(there.path()), ["a.nc"]);
    assert_eq!(fs::read(there.path().join("a.nc")).expect("a.nc"), b"old");
}

#[test]
fn a_writer_that_gives_up_for_its_own_reason_is_a_fault() {
    let there = folder();
    let folder = Folder::open(there.path()).expect("a folder");
    let mut set = set(&folder);
    write(&mut set, "a.nc", "new").expect("written");
    let full = set.write(OsStr::new("b.nc"), |out| {
        out.write_all(b"part")?;
        Err(io::Error::from(io::ErrorKind::StorageFull))
    });
    // An error of the writer's own is a fault: the disk took everything.
    assert_eq!(full.expect_err("refused").exit, Exit::Fault);
    drop(set);
    assert!(names(there.path()).is_empty());
}

#[test]
fn when_a_rename_fails_the_files_of_before_are_back() {
    let there = folder();
    fs::write(there.path().join("a.nc"), "old a").expect("an old file");
    let folder = Folder::open(there.path()).expect("a folder");
    let mut set = set(&folder);
    for name in ["a.nc", "b.nc", "c.nc"] {
        write(&mut set, name, "new").expect("written");
    }
    // A folder that comes in the way while the set is written.
    fs::create_dir(there.path().join("c.nc")).expect("a folder in the way");
    fs::write(there.path().join("c.nc/x"), "").expect("a file in it");
    let refusal = set.commit().expect_err("refused");
    assert_eq!(refusal.exit, Exit::Unwritable);
    assert!(said(&refusal).contains("c.nc"), "{}", said(&refusal));
    assert_eq!(names(there.path()), ["a.nc", "c.nc"]);
    assert_eq!(fs::read(there.path().join("a.nc")).expect("a.nc"), b"old a");
}

#[test]
fn an_input_is_never_replaced_whatever_its_name() {
    let there = folder();
    let input = there.path().join("input.xlsx");
    fs::write(&input, "precious").expect("an input");
    fs::hard_link(&input, there.path().join("same.xlsx")).expect("a second name");
    let folder = Folder::open(there.path()).expect("a folder");
    let set = Set::new(&folder, &[&input], Existing::Replace);
    for name in ["input.xlsx", "same.xlsx"] {
        let refusal = set.check(OsStr::new(name)).expect_err("refused");
        assert_eq!(refusal.exit, Exit::CommandLine, "{name}");
        assert!(said(&refusal).contains("both input and output"), "{}", said(&refusal));
    }
}

#[test]
fn what_is_no_ordinary_file_is_not_written_to() {
    let there = folder();
    fs::create_dir(there.path().join("dir.nc")).expect("a folder");
    let mut cases = vec![("dir.nc", "not an ordinary file")];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("/dev/null", there.path().join("link.nc")).expect("a link");
        std::os::unix::fs::symlink("nowhere", there.path().join("dangling.nc")).expect("a link");
        cases.extend([("link.nc", "symbolic link"), ("dangling.nc", "symbolic link")]);
    }
    let folder = Folder::open(there.path()).expect("a folder");
    for (name, why) in cases {
        let refusal = set(&folder).check(OsStr::new(name)).expect_err("refused");
        assert_eq!(refusal.exit, Exit::Unwritable, "{name}");
        assert!(said(&refusal).contains(why), "{}", said(&refusal));
    }
}

#[test]
fn no_name_leads_out_of_the_folder() {
    let there = folder();
    let folder = Folder::open(there.path()).expect("a folder");
    for name in ["../x.nc", "/tmp/x.nc", "a/b.nc", "..", ".", "", "a.nc/"] {
        let refusal = set(&folder).check(OsStr::new(name)).expect_err(name);
        assert_eq!(refusal.exit, Exit::Unwritable, "{name}");
    }
}

#[test]
fn one_name_twice_in_a_set_is_refused() {
    let there = folder();
    let folder = Folder::open(there.path()).expect("a folder");
    let mut set = set(&folder);
    write(&mut set, "a.nc", "1").expect("written");
    assert_eq!(write(&mut set, "a.nc", "2").expect_err("refused").exit, Exit::CommandLine);
}

#[test]
fn a_workbook_open_elsewhere_is_refused_with_the_program_to_close() {
    for (lock, program) in [("~$a.xlsx", "close it in Excel"), (".~lock.a.xlsx#", "close it in LibreOffice")] {
        let there = folder();
        fs::write(there.path().join(lock), "").expect("a lock file");
        let folder = Folder::open(there.path()).expect("a folder");
        let refusal = set(&folder).check(OsStr::new("a.xlsx")).expect_err("refused");
        assert_eq!(refusal.exit, Exit::Unwritable);
        assert!(said(&refusal).contains(program) && said(&refusal).contains(lock), "{}", said(&refusal));
        assert!(set(&folder).check(OsStr::new("b.xlsx")).is_ok());
    }
}

#[test]
fn a_file_to_be_kept_is_kept_even_if_it_comes_late() {
    let there = folder();
    let folder = Folder::open(there.path()).expect("a folder");
    let mut set = Set::new(&folder, &[], Existing::Keep);
    write(&mut set, "a.xlsx", "new").expect("written");
    fs::write(there.path().join("a.xlsx"), "late").expect("a late file");
    let refusal = set.commit().expect_err("refused");
    assert_eq!(refusal.exit, Exit::Unwritable);
    assert!(said(&refusal).contains("already exists | give another name"), "{}", said(&refusal));
    assert_eq!(fs::read(there.path().join("a.xlsx")).expect("a.xlsx"), b"late");
    assert_eq!(names(there.path()), ["a.xlsx"]);
}

#[test]
fn folders_are_made_and_go_again_if_nothing_comes_into_them() {
    let there = folder();
    let deep = there.path().join("a/b");
    drop(Folder::open(&deep).expect("a folder"));
    assert!(names(there.path()).is_empty());
    {
        let folder = Folder::open(&deep).expect("a folder");
        let mut set = set(&folder);
        write(&mut set, "x.nc", "").expect("written");
        set.commit().expect("committed");
    }
    assert_eq!(names(&deep), ["x.nc"]);
}

#[test]
fn a_file_where_the_folder_should_be_is_named() {
    let there = folder();
    let file = there.path().join("file");
    fs::write(&file, "kept").expect("a file");
    for path in [file.clone(), file.join("below")] {
        let refusal = Folder::open(&path).expect_err("refused");
        assert_eq!(refusal.exit, Exit::Unwritable);
        assert!(said(&refusal).contains("not a folder"), "{}", said(&refusal));
    }
    assert_eq!(fs::read(&file).expect("the file"), b"kept");
}

#[test]
fn leftovers_of_a_killed_run_are_removed_if_they_are_ours_old_and_unlocked() {
    let there = folder();
    let aged = |name: &str| {
        let file = File::create(there.path().join(name)).expect("a file");
        file.set_modified(SystemTime::now() - Duration::from_secs(3600)).expect("an old date");
        file
    };
    aged(".rodete-dead0000.tmp");
    aged("rodete-theirs.tmp");
    aged(".rodete-theirs.txt");
    let alive = aged(".rodete-alive000.tmp");
    alive.lock().expect("a lock");
    File::create(there.path().join(".rodete-young000.tmp")).expect("a young file");
    Folder::open(there.path()).expect("a folder");
    assert_eq!(
        names(there.path()),
        [".rodete-alive000.tmp", ".rodete-theirs.txt", ".rodete-young000.tmp", "rodete-theirs.tmp"]
    );
}

#[test]
fn two_sets_at_once_do_not_mix() {
    let there = folder();
    let rounds = 20;
    std::thread::scope(|scope| {
        for writer in 0..4 {
            let path = there.path();
            scope.spawn(move || {
                for round in 0..rounds {
                    let folder = Folder::open(path).expect("a folder");
                    let mut set = set(&folder);
                    for name in ["a.nc", "b.nc", "c.nc"] {
                        write(&mut set, name, &format!("{writer} {round}")).expect("written");
                    }
                    set.commit().expect("committed");
                }
            });
        }
    });
    let contents = ["a.nc", "b.nc", "c.nc"].map(|name| fs::read(there.path().join(name)).expect(name));
    assert_eq!(contents[0], contents[1]);
    assert_eq!(contents[1], contents[2]);
    assert_eq!(names(there.path()), ["a.nc", "b.nc", "c.nc"]);
}

#[test]
fn a_folder_held_by_another_run_is_refused_with_its_owner() {
    let there = folder();
    let path = there.path().join(".rodete.lock");
    let mut held = File::create(&path).expect("a lock file");
    held.write_all(b"rodete, process 4711\n").expect("its owner");
    held.lock().expect("a lock");
    let folder = Folder::open(there.path()).expect("a folder");
    let mut set = set(&folder);
    write(&mut set, "a.nc", "new").expect("written");
    let refusal = set.commit().expect_err("refused");
    assert_eq!(refusal.exit, Exit::Unwritable);
    assert!(said(&refusal).contains("process 4711"), "{}", said(&refusal));
    assert_eq!(names(there.path()), [".rodete.lock"]);
}

#[test]
fn a_lock_file_that_nobody_holds_is_in_nobodys_way() {
    let there = folder();
    fs::write(there.path().join(".rodete.lock"), "rodete, process 4711\n").expect("a lock file");
    let folder = Folder::open(there.path()).expect("a folder");
    let mut set = set(&folder);
    write(&mut set, "a.nc", "new").expect("written");
    set.commit().expect("committed");
    assert_eq!(names(there.path()), ["a.nc"]);
}

#[cfg(unix)]
#[test]
fn the_lock_is_not_written_through_a_link() {
    let there = folder();
    fs::write(there.path().join("precious"), "mine").expect("a file");
    std::os::unix::fs::symlink("precious", there.path().join(".rodete.lock")).expect("a link");
    let folder = Folder::open(there.path()).expect("a folder");
    let mut set = set(&folder);
    write(&mut set, "a.nc", "new").expect("written");
    assert_eq!(set.commit().expect_err("refused").exit, Exit::Unwritable);
    assert_eq!(fs::read(there.path().join("precious")).expect("the file"), b"mine");
    assert_eq!(names(there.path()), [".rodete.lock", "precious"]);
}

#[cfg(unix)]
#[test]
fn the_umask_gives_the_mode() {
    use std::os::unix::fs::PermissionsExt;
    let there = folder();
    let folder = Folder::open(there.path()).expect("a folder");
    let mut set = set(&folder);
    write(&mut set, "a.nc", "new").expect("written");
    set.commit().expect("committed");
    // What any other program would make here.
    File::create(there.path().join("b.nc")).expect("a file");
    let mode = |name: &str| fs::metadata(there.path().join(name)).expect(name).permissions().mode();
    assert_eq!(mode("a.nc"), mode("b.nc"));
}

#[cfg(unix)]
#[test]
fn names_that_are_no_utf8_are_written() {
    use std::os::unix::ffi::OsStrExt;
    let there = folder();
    let folder = Folder::open(there.path()).expect("a folder");
    let mut set = set(&folder);
    let name = OsStr::from_bytes(b"a\xff.nc");
    set.write(name, |out| out.write_all(b"x")).expect("written");
    set.commit().expect("committed");
    let mut contents = String::new();
    File::open(there.path().join(name)).and_then(|mut file| file.read_to_string(&mut contents)).expect("the file");
    assert_eq!(contents, "x");
}

#[cfg(unix)]
#[test]
fn an_input_whose_outputs_another_one_claims_is_seen() {
    let there = folder();
    let path = |name: &str| there.path().join(name);
    let long = "é".repeat(110);
    for name in ["a?.xlsx", "a:.ngc", "b.xlsx", "b.xlsm", "B.XLSX", &format!("{long}1.nc"), &format!("{long}2.nc")] {
        fs::write(path(name), "").expect("a file");
    }
    assert_eq!(namesake(&path("a_.xlsx")), Some(path("a?.xlsx")));
    assert_eq!(namesake(&path("a?.xlsx")), None);
    assert_eq!(namesake(&path("b.xlsx")), None);
    assert_eq!(namesake(&path(&format!("{long}2.nc"))), Some(path(&format!("{long}1.nc"))));
    assert_eq!(namesake(Path::new("no/such/a.xlsx")), None);
}
