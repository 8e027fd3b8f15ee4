//! The name of the running binary, as hints and help tell it: a binary with kinds of its own is not called `rodete`.

use std::ffi::OsString;
use std::path::Path;

use crate::escape::printable;

/// The name where a command line tells none.
pub(super) const RODETE: &str = "rodete";

/// The name by which a command line was begun, from its first word: the file's without folder and ending.
pub(super) fn called(first: Option<&OsString>) -> String {
    let stem = first.and_then(|first| Path::new(first).file_stem()).and_then(|stem| stem.to_str());
    stem.filter(|stem| !stem.is_empty()).map_or_else(|| RODETE.to_owned(), printable)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_binary_goes_by_its_files_name() {
        let of = |word: &str| called(Some(&word.into()));
        assert_eq!(["rodete", "/usr/bin/flange", "./target/flange.exe"].map(of), ["rodete", "flange", "flange"]);
        assert_eq!([of(""), of(".."), called(None)], [RODETE; 3]);
        assert!(!of("a\u{1b}[2J").contains('\u{1b}'));
    }
}
