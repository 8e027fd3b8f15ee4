//! A set whose delivery fails or ends at every step in turn: the next command finds the old set whole or the new one, or
//! tells the names.

use std::ffi::OsStr;
use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use rodete::finding::{Exit, Refusal};
use rodete::store::{Disk, Existing, Folder, Set, Step, settle, settle_on};

use super::{folder, names, said};

const NAMES: [&str; 4] = ["blade.nc", "blank.nc", "impeller.nc", "splitter.nc"];
/// The variables that tell the process to be killed what to do.
const FOLDER: &str = "TEST_FOLDER";
const LAST: &str = "TEST_LAST_STEP";

/// A folder with three of the four files, `blank.nc` the same in every set.
fn with_old() -> tempfile::TempDir {
    let there = folder();
    for name in &NAMES[..3] {
        fs::write(there.path().join(name), contents(name, "old")).expect("an old file");
    }
    there
}

fn contents(name: &str, version: &str) -> String {
    if name == "blank.nc" { "G90\n".into() } else { format!("({version} {name})\nM30\n") }
}

fn deliver(path: &Path, disk: &Disk, version: &str) -> Result<(), Refusal> {
    let folder = Folder::open_on(path, disk)?;
    let mut set = Set::new(&folder, &[], Existing::Replace);
    for name in NAMES {
        set.write(OsStr::new(name), |out| out.write_all(contents(name, version).as_bytes()))?;
    }
    set.commit().map(|_| ())
}

/// The version in which all files of the folder stand; none if they are mixed.
fn whole(path: &Path) -> Option<&'static str> {
    ["old", "new", "third"].into_iter().find(|version| {
        NAMES.iter().all(|name| {
            let found = fs::read_to_string(path.join(name)).ok();
            let there = *version != "old" || *name != "splitter.nc";
            found == there.then(|| contents(name, version))
        })
    })
}

fn lost() -> io::Error {
    io::Error::from_raw_os_error(5)
}

/// A disk that takes `last` steps; the next one fails, and if `dead` every one after it.
fn breaking(last: usize, dead: bool) -> Disk {
    let taken = AtomicUsize::new(0);
    Disk::watched(move |_, _| {
        let at = taken.fetch_add(1, Ordering::SeqCst);
        if at == last || (dead && at > last) { Err(lost()) } else { Ok(()) }
    })
}

/// The steps of a delivery, each with the name of its file.
type Steps = Arc<Mutex<Vec<(Step, String)>>>;

/// A disk that writes down its steps.
fn noting() -> (Disk, Steps) {
    let steps = Arc::new(Mutex::new(Vec::new()));
    let noted = Arc::clone(&steps);
    let disk = Disk::watched(move |step, path| {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        noted.lock().expect("the notes").push((step, name));
        Ok(())
    });
    (disk, steps)
}

/// How many steps the delivery of a new set over an old one has.
fn steps() -> usize {
    let there = with_old();
    let (disk, steps) = noting();
    deliver(there.path(), &disk, "new").expect("delivered");
    assert_eq!(names(there.path()), NAMES);
    let steps = steps.lock().expect("the notes").len();
    assert!(steps > 30, "{steps} steps");
    steps
}

fn stands(path: &Path, what: &str) -> &'static str {
    whole(path).unwrap_or_else(|| panic!("{what}: a mixed set: {:?}", names(path)))
}

/// What the next command finds, after it has seen to the folder.
fn next(path: &Path, what: &str) -> &'static str {
    settle(path).unwrap_or_else(|refusal| panic!("{what}: {}", said(&refusal)));
    assert!(!path.join(".rodete-delivery.json").exists(), "{what}");
    stands(path, what)
}

#[test]
fn a_step_that_fails_leaves_the_set_that_was_told() {
    for step in 0..steps() {
        let there = with_old();
        let told = match deliver(there.path(), &breaking(step, false), "new") {
            Ok(()) => "new",
            Err(refusal) => {
                assert_eq!(refusal.exit, Exit::Unwritable, "step {step}: {}", said(&refusal));
                "old"
            }
        };
        // At once, and after the next command has looked.
        assert_eq!(stands(there.path(), &format!("step {step}")), told);
        assert_eq!(next(there.path(), &format!("step {step}")), told);
        deliver(there.path(), &Disk::default(), "third").expect("delivered");
        assert_eq!(whole(there.path()), Some("third"));
    }
}

#[test]
fn a_run_that_ends_at_any_step_leaves_one_set_whole_to_the_next_command() {
    let mut found = [0, 0];
    for step in 0..steps() {
        let there = with_old();
        let _ = deliver(there.path(), &breaking(step, true), "new");
        let version = next(there.path(), &format!("step {step}"));
        found[usize::from(version == "new")] += 1;
        deliver(there.path(), &Disk::default(), "third").expect("delivered");
        assert_eq!(whole(there.path()), Some("third"));
    }
    assert!(found.iter().all(|count| *count > 5), "{found:?}");
}

#[test]
fn a_process_that_is_killed_at_any_step_leaves_one_set_whole_to_the_next_command() {
    let mut killed = 0;
    for step in 0..steps() {
        let there = with_old();
        let ended = Command::new(std::env::current_exe().expect("the tests"))
            .args(["--exact", "store::killed::the_process_to_be_killed", "--ignored"])
            .env(FOLDER, there.path())
            .env(LAST, step.to_string())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .status()
            .expect("a process");
        killed += usize::from(!ended.success());
        next(there.path(), &format!("step {step}"));
    }
    assert_eq!(killed, steps());
}

#[test]
#[ignore = "ends its process; started by the test above"]
fn the_process_to_be_killed() {
    let there = std::env::var_os(FOLDER).expect("a folder");
    let last: usize = std::env::var(LAST).expect("a step").parse().expect("a number");
    let taken = AtomicUsize::new(0);
    let disk = Disk::watched(move |_, _| {
        if taken.fetch_add(1, Ordering::SeqCst) == last {
            std::process::abort();
        }
        Ok(())
    });
    deliver(Path::new(&there), &disk, "new").expect("delivered");
}

#[test]
fn who_clears_up_may_be_killed_too() {
    let mut cleared = 0;
    for step in 0..steps() {
        let there = with_old();
        let _ = deliver(there.path(), &breaking(step, true), "new");
        let (disk, noted) = noting();
        settle_on(there.path(), &disk).expect("settled");
        let clearing = noted.lock().expect("the notes").len();
        for next_step in 0..clearing {
            let there = with_old();
            let _ = deliver(there.path(), &breaking(step, true), "new");
            let _ = settle_on(there.path(), &breaking(next_step, true));
            next(there.path(), &format!("steps {step} and {next_step}"));
            cleared += 1;
        }
    }
    assert!(cleared > 50, "{cleared}");
}

#[test]
fn a_second_delivery_that_ends_over_a_first_one_leaves_one_set_whole() {
    let steps = steps();
    for step in (0..steps).step_by(7) {
        for next_step in (0..steps).step_by(4) {
            let there = with_old();
            let _ = deliver(there.path(), &breaking(step, true), "new");
            let _ = deliver(there.path(), &breaking(next_step, true), "third");
            next(there.path(), &format!("steps {step} and {next_step}"));
        }
    }
}

#[test]
fn nothing_is_renamed_before_all_that_it_takes_is_on_the_disk() {
    let there = with_old();
    let (disk, steps) = noting();
    deliver(there.path(), &disk, "new").expect("delivered");
    let steps = steps.lock().expect("the notes").clone();
    let at = |wanted: Step, name: &str| {
        let found = steps.iter().position(|(step, path)| *step == wanted && path == name);
        found.unwrap_or_else(|| panic!("{wanted:?} {name} in {steps:#?}"))
    };
    let notice = at(Step::Rename, ".rodete-delivery.json");
    let first = at(Step::Rename, NAMES[0]);
    let (drafts, last) = (steps[..notice].iter(), at(Step::Rename, NAMES[3]));
    // Four drafts and the notice.
    assert_eq!(drafts.filter(|(step, _)| *step == Step::Sync).count(), 5, "{steps:#?}");
    assert!(steps[..notice].iter().filter(|(step, _)| *step == Step::Link).count() == 3, "{steps:#?}");
    assert!(steps[notice..first].iter().any(|(step, _)| *step == Step::SyncFolder), "{steps:#?}");
    let gone = at(Step::Remove, ".rodete-delivery.json");
    assert!(steps[last..gone].iter().any(|(step, _)| *step == Step::SyncFolder), "{steps:#?}");
    assert!(steps[gone..].iter().any(|(step, _)| *step == Step::SyncFolder), "{steps:#?}");
}

/// Ends a delivery between two renames, `blade.nc` new and `impeller.nc` old.
fn half(path: &Path) {
    let renames = AtomicUsize::new(0);
    let dead = Disk::watched(move |step, _| {
        // The notice, `blade.nc`, `blank.nc`, and then no more.
        let at = renames.fetch_add(usize::from(step == Step::Rename), Ordering::SeqCst);
        if at > 3 || (at == 3 && step == Step::Rename) { Err(lost()) } else { Ok(()) }
    });
    deliver(path, &dead, "new").expect_err("ended");
    assert_eq!(whole(path), None);
}

fn remove_temporary(path: &Path) {
    for name in names(path).into_iter().filter(|name| name.ends_with(".tmp")) {
        fs::remove_file(path.join(name)).expect("removed");
    }
}

#[test]
fn a_mixed_set_that_can_be_neither_completed_nor_put_back_is_told_with_its_names() {
    let there = with_old();
    half(there.path());
    remove_temporary(there.path());
    for _ in 0..2 {
        let refusal = settle(there.path()).expect_err("refused");
        assert_eq!(refusal.exit, Exit::Unwritable);
        assert!(
            said(&refusal).contains(
                "do not belong together: a run was interrupted while delivering them; new: blade.nc; of before: \
                 impeller.nc; missing or changed: splitter.nc | use none of these files; delete the new ones and build again"
            ),
            "{}",
            said(&refusal)
        );
        // No new set comes beside them either.
        assert!(said(&deliver(there.path(), &Disk::default(), "third").expect_err("refused")).contains("blade.nc"));
    }
    fs::remove_file(there.path().join("blade.nc")).expect("removed");
    deliver(there.path(), &Disk::default(), "third").expect("delivered");
    assert_eq!(whole(there.path()), Some("third"));
}

#[test]
fn a_draft_that_is_not_what_the_notice_says_is_not_taken() {
    let there = with_old();
    half(there.path());
    // What is left of a draft after a power cut on a disk that did not keep its word.
    for name in names(there.path()).into_iter().filter(|name| name.ends_with(".tmp")) {
        let path = there.path().join(name);
        if fs::read_to_string(&path).expect("a temporary file").contains("new") {
            fs::write(&path, "(new").expect("written");
        }
    }
    let found = settle(there.path()).expect("put back").expect("a finding");
    assert!(found.what.en.contains("was put back as it was before: blade.nc, blank.nc"), "{found:?}");
    assert_eq!(whole(there.path()), Some("old"));
}

#[test]
fn a_file_that_someone_changed_meanwhile_is_not_written_over() {
    let there = with_old();
    half(there.path());
    fs::write(there.path().join("impeller.nc"), "(mine)").expect("written");
    let found = settle(there.path()).expect("put back").expect("a finding");
    assert!(found.what.en.contains("was put back as it was before"), "{found:?}");
    assert_eq!(fs::read_to_string(there.path().join("impeller.nc")).expect("a file"), "(mine)");
    assert_eq!(fs::read_to_string(there.path().join("blade.nc")).expect("a file"), contents("blade.nc", "old"));
}

#[test]
fn a_notice_that_names_files_elsewhere_is_refused_and_nothing_is_touched() {
    let there = with_old();
    half(there.path());
    let notice = there.path().join(".rodete-delivery.json");
    let text = fs::read_to_string(&notice).expect("a notice");
    let outside = |name: &str| {
        let name: Vec<String> = name.bytes().map(|byte| byte.to_string()).collect();
        format!("{{ \"Unix\": [{}] }}", name.join(","))
    };
    let entry = |name: &str, draft: &str| {
        let sum = "0".repeat(64);
        format!(
            "{{\"files\":[{{\"name\":{},\"sha256\":\"{sum}\",\"draft\":{},\"before\":null}}]}}",
            outside(name),
            outside(draft)
        )
    };
    fs::remove_file(there.path().join(".rodete.lock")).expect("the lock of the run that ended");
    let before = names(there.path());
    let cases = [
        text.replace("\"files\"", "\"papers\""),
        text[..text.len() / 2].to_owned(),
        entry("../x.nc", ".rodete-x.tmp"),
        entry("x.nc", "../.rodete-x.tmp"),
        entry("x.nc", "precious"),
    ];
    for case in cases {
        fs::write(&notice, &case).expect("written");
        let refusal = settle(there.path()).expect_err(&case);
        assert!(
            said(&refusal).contains(".rodete-delivery.json shows that a run was interrupted"),
            "{}",
            said(&refusal)
        );
        assert_eq!(names(there.path()), before);
    }
    fs::write(&notice, text).expect("written");
    assert_eq!(next(there.path(), "the notice itself"), "new");
}
