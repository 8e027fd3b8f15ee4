//! Paths: what is opened, what is not, and how it is said.

use std::fs;
use std::path::Path;

use rodete::finding::Exit;
use rodete::text::Language;
use rodete::workbook::open;

use super::workbook::{impeller, sound};

fn said(path: &Path) -> (Exit, String, String) {
    let refusal = open(path).unwrap_err();
    let finding = &refusal.findings[0];
    (refusal.exit, finding.what.en.to_string(), finding.remedy.en.to_string())
}

#[test]
fn a1_a_missing_file_is_refused_with_names_like_it() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["impeller.xlsx", "~$impeller.xlsx", "pump.xlsx", "impeller.txt"] {
        fs::write(folder.path().join(name), "x").unwrap();
    }
    let (exit, what, remedy) = said(&folder.path().join("impeler.xlsx"));
    assert_eq!(exit, Exit::Unreadable);
    assert!(what.starts_with("cannot open ") && what.ends_with("impeler.xlsx: no such file"), "{what}");
    assert_eq!(remedy, "did you mean impeller.xlsx?");
    assert_eq!(
        said(&folder.path().join("something-else.xlsx")).2,
        "use one of the files in the folder: impeller.xlsx, pump.xlsx"
    );
    assert_eq!(said(&folder.path().join("none/x.xlsx")).2, "check the name and the folder");
    assert!(said(&folder.path().join("pump.xlsx/x.xlsx")).1.contains("a part of the path is not a folder"));
    assert_eq!(said(Path::new("impeller-not-here.xlsx")).1, "cannot open impeller-not-here.xlsx: no such file");
}

#[test]
fn a1_a_folder_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let (exit, what, remedy) = said(folder.path());
    assert_eq!(exit, Exit::Unreadable);
    assert!(what.ends_with(": it is a folder"), "{what}");
    assert_eq!(remedy, "give the name of the .xlsx workbook inside the folder");
}

#[cfg(unix)]
#[test]
fn a1_what_is_no_regular_file_is_refused_without_being_read() {
    let (exit, what, _) = said(Path::new("/dev/zero"));
    assert_eq!((exit, what.as_str()), (Exit::Unreadable, "cannot open /dev/zero: it is not a regular file"));
}

#[test]
fn a9_a_file_beyond_the_cap_is_refused_unread() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("large.xlsx");
    fs::File::create(&path).unwrap().set_len(rodete::workbook::limits::FILE + 1).unwrap();
    let (exit, what, _) = said(&path);
    assert_eq!(exit, Exit::Limit);
    assert!(what.ends_with("large.xlsx is larger than 64 MiB"), "{what}");
}

#[test]
fn a27_odd_names_are_opened_and_printed_without_their_sting() {
    let folder = tempfile::tempdir().unwrap();
    let whole = sound(Language::En);
    for name in ["рабочее колесо 叶轮 ⚙.xlsx", "-o.xlsx", "a b\tc.xlsx", "\u{202e}xslx.exe", &"x".repeat(250)]
    {
        let path = folder.path().join(name);
        fs::write(&path, &whole).unwrap();
        assert_eq!(open(&path.parent().unwrap().join(".").join(name)).unwrap(), whole, "{name}");
    }
    let (_, what, _) = said(&folder.path().join("\u{1b}[2J\u{202e}.xlsx"));
    assert!(what.contains("\\u{1b}[2J\\u{202e}.xlsx: no such file"), "{what}");
    assert!(said(&folder.path().join("y".repeat(300))).1.starts_with("cannot open "));
}

#[cfg(unix)]
#[test]
fn a27_a_name_that_is_not_utf8_is_opened() {
    use std::os::unix::ffi::OsStrExt;
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(std::ffi::OsStr::from_bytes(b"rodete-\xe1.xlsx"));
    fs::write(&path, sound(Language::Es)).unwrap();
    assert!(impeller(&open(&path).unwrap()).is_ok());
}
