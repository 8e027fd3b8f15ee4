//! A workbook that is replaced together with a set: at every step at which the delivery fails or ends, book and set belong together to the
//! next command.

use std::ffi::OsStr;
use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use rodete::finding::{Exit, Refusal};
use rodete::store::{Disk, Existing, Folder, Set, replaceable, sha256};
use tempfile::TempDir;

use super::{folder, names, said};

const BOOK: &str = "part.xlsx";
const FILES: [&str; 2] = ["part-blade.nc", "part-blank.nc"];

/// Where the files of the set go, seen from the folder of the book: below it, into it, beside it.
const OUTS: [&str; 3] = ["books/part-out", "books", "elsewhere"];

/// A folder with a book, and with the set of an earlier build.
fn there(out: &str) -> TempDir {
    let there = folder();
    fs::create_dir_all(there.path().join("books")).expect("a folder");
    fs::create_dir_all(there.path().join(out)).expect("a folder");
    fs::write(there.path().join("books").join(BOOK), "old book").expect("a book");
    for name in FILES {
        fs::write(there.path().join(out).join(name), format!("old {name}")).expect("a file");
    }
    there
}

fn deliver(there: &Path, out: &str, disk: &Disk) -> Result<(), Refusal> {
    let book = there.join("books").join(BOOK);
    let folder = Folder::open_on(&there.join(out), disk)?;
    let mut set = Set::new(&folder, &[&book], Existing::Replace);
    for name in FILES {
        set.write(OsStr::new(name), |file| file.write_all(format!("new {name}").as_bytes()))?;
    }
    set.replace(&book, b"old book", b"new book")?;
    set.commit().map(|_| ())
}

/// Which version book and files are; the files as one word.
fn stands(there: &Path, out: &str) -> (String, Option<&'static str>) {
    let book = fs::read_to_string(there.join("books").join(BOOK)).expect("a book");
    let whole = ["old", "new"].into_iter().find(|version| {
        FILES.iter().all(|name| {
            fs::read_to_string(there.join(out).join(name)).is_ok_and(|text| text == format!("{version} {name}"))
        })
    });
    (book.strip_suffix(" book").expect("a whole book").to_owned(), whole)
}

fn breaking(last: usize, dead: bool) -> (Disk, Arc<AtomicUsize>) {
    let taken = Arc::new(AtomicUsize::new(0));
    let counted = Arc::clone(&taken);
    let disk = Disk::watched(move |_, _| {
        let at = counted.fetch_add(1, Ordering::SeqCst);
        if at == last || (dead && at > last) { Err(io::Error::from_raw_os_error(5)) } else { Ok(()) }
    });
    (disk, taken)
}

fn steps(out: &str) -> usize {
    let there = there(out);
    let (disk, taken) = breaking(usize::MAX, false);
    deliver(there.path(), out, &disk).expect("delivered");
    assert_eq!(stands(there.path(), out), ("new".to_owned(), Some("new")));
    assert_eq!(fs::read_to_string(there.path().join("books/part.xlsx.bak")).expect("a copy"), "old book");
    taken.load(Ordering::SeqCst)
}

#[test]
fn a_step_that_fails_leaves_book_and_set_as_it_was_told() {
    for out in OUTS {
        for step in 0..steps(out) {
            let there = there(out);
            let told = match deliver(there.path(), out, &breaking(step, false).0) {
                Ok(()) => "new",
                Err(refusal) => {
                    assert_eq!(refusal.exit, Exit::Unwritable, "{out}, step {step}: {}", said(&refusal));
                    "old"
                }
            };
            assert_eq!(stands(there.path(), out), (told.to_owned(), Some(told)), "{out}, step {step}");
        }
    }
}

#[test]
fn a_run_that_ends_at_any_step_leaves_book_and_set_together_to_the_next_command() {
    for out in OUTS {
        let mut found = [0, 0];
        for step in 0..steps(out) {
            let there = there(out);
            let _ = deliver(there.path(), out, &breaking(step, true).0);
            rodete::store::settle(&there.path().join(out)).unwrap_or_else(|refusal| panic!("{}", said(&refusal)));
            let (book, set) = stands(there.path(), out);
            let set = set.unwrap_or_else(|| panic!("{out}, step {step}: a mixed set"));
            // Of a book that is neither in the folder of the set nor above it no notice tells: each is whole by itself.
            assert!(book == set || out == "elsewhere", "{out}, step {step}: {book} book, {set} set");
            assert!(!there.path().join(out).join(".rodete-delivery.json").exists(), "{out}, step {step}");
            found[usize::from(set == "new")] += 1;
        }
        assert!(found.iter().all(|count| *count > 3), "{out}: {found:?}");
    }
}

#[test]
fn a_book_that_was_saved_meanwhile_is_not_replaced() {
    for out in OUTS {
        let there = there(out);
        let book = there.path().join("books").join(BOOK);
        let folder = Folder::open(&there.path().join(out)).expect("a folder");
        let mut set = Set::new(&folder, &[], Existing::Replace);
        set.write(OsStr::new(FILES[0]), |file| file.write_all(b"new")).expect("written");
        set.replace(&book, b"old book", b"new book").expect("written");
        fs::write(&book, "saved meanwhile").expect("saved");
        let refused = set.commit().expect_err("another book");
        assert!(said(&refused).contains("changed while rodete was working on it"), "{}", said(&refused));
        assert_eq!(fs::read_to_string(&book).expect("the book"), "saved meanwhile");
        assert_eq!(names(&there.path().join("books")).iter().filter(|name| name.ends_with(".bak")).count(), 0);
    }
}

#[test]
fn the_book_of_before_is_kept_once() {
    let there = there("books");
    let kept = there.path().join("books/part.xlsx.bak");
    fs::write(&kept, "the first of all").expect("a copy");
    deliver(there.path(), "books", &Disk::default()).expect("delivered");
    assert_eq!(fs::read_to_string(&kept).expect("a copy"), "the first of all");
}

#[test]
fn another_input_of_the_command_is_not_replaced() {
    let there = there("books");
    let book = there.path().join("books").join(BOOK);
    let other = there.path().join("books/other.xlsx");
    fs::hard_link(&book, &other).expect("a second name");
    assert!(replaceable(&book, &[&book]).is_ok(), "itself");
    assert!(replaceable(&book, &[&there.path().join("books/part-blade.nc")]).is_ok());
}

/// A notice is read from a folder that may come from anybody: it must not move files to where it likes.
#[test]
fn a_notice_reaches_no_file_above_but_a_workbook_that_is_replaced() {
    for (name, draft, before, sound) in [
        ("../part.xlsx", "../.rodete-a.tmp", true, true),
        ("../part.xlsx.bak", "../.rodete-a.tmp", false, true),
        ("../part.xlsx", "../.rodete-a.tmp", false, false),
        ("../part.xlsx", ".rodete-a.tmp", true, false),
        ("../part.xlsx", "../other.xlsx", true, false),
        ("../start.sh", "../.rodete-a.tmp", true, false),
        ("../../part.xlsx", "../../.rodete-a.tmp", true, false),
        ("../sub/part.xlsx", "../.rodete-a.tmp", true, false),
        ("/part.xlsx", "../.rodete-a.tmp", true, false),
    ] {
        let there = there("books/part-out");
        let written = |name: &str| serde_json::json!({ "Unix": name.as_bytes() });
        let earlier = serde_json::json!({ "second": written("../.rodete-b.tmp"), "sha256": sha256(b"old book") });
        let entry = serde_json::json!({ "name": written(name), "sha256": sha256(b"new book"), "draft": written(draft),
            "before": if before { earlier } else { serde_json::Value::Null } });
        let out = there.path().join("books/part-out");
        fs::write(out.join(".rodete-delivery.json"), serde_json::json!({ "files": [entry] }).to_string())
            .expect("a notice");
        let settled = rodete::store::settle(&out);
        let refused = settled.as_ref().is_err_and(|refusal| said(refusal).contains("cannot be read"));
        assert_eq!(!refused, sound, "{name} from {draft}: {settled:?}");
    }
}
