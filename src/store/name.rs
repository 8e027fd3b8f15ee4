//! Names of output files: from the workbook's own file name, never from a cell.

#![expect(clippy::disallowed_methods, reason = "the store is the door to files")]

use std::ffi::{OsStr, OsString};
use std::fs;
use std::path::{Path, PathBuf};

use super::disk::here;

use crate::escape::hidden;

/// Most bytes of a stem: with the longest ending it stays below the 255 bytes that file systems allow.
const LONGEST: usize = 200;

/// The stem of a workbook's outputs: its file name without extension, as it may stand in a file name on any system.
///
/// Control characters, marks of direction and `< > : " / \ | ? *` become `_`, and so do dots and blanks at the end; what
/// is longer than 200 bytes is cut at a character. Bytes that are no UTF-8 are kept where the system allows them.
#[must_use]
pub fn stem(workbook: &Path) -> OsString {
    let raw = workbook.file_stem().unwrap_or(OsStr::new("rodete"));
    let mut clean = Vec::with_capacity(raw.len());
    for chunk in raw.as_encoded_bytes().utf8_chunks() {
        for character in chunk.valid().chars() {
            let kept = if forbidden(character) { '_' } else { character };
            if clean.len() + kept.len_utf8() > LONGEST {
                return os_string(end(clean));
            }
            clean.extend_from_slice(kept.encode_utf8(&mut [0; 4]).as_bytes());
        }
        if clean.len() + chunk.invalid().len() > LONGEST {
            break;
        }
        clean.extend_from_slice(chunk.invalid());
    }
    os_string(end(clean))
}

/// Another file beside an input, of the same ending and not of the same name, whose outputs would have the same stem;
/// letter case counts as little as it does to some file systems.
#[must_use]
pub fn namesake(input: &Path) -> Option<PathBuf> {
    let name = input.file_name()?;
    let claimed = |path: &Path| stem(path).to_string_lossy().to_lowercase();
    let ending = |path: &Path| path.extension().map(OsStr::to_ascii_lowercase);
    let own = claimed(input);
    let mut others: Vec<_> = fs::read_dir(here(input.parent().unwrap_or(Path::new(""))))
        .ok()?
        .flatten()
        .map(|entry| entry.file_name())
        .filter(|other| {
            let path = Path::new(other);
            other != name && ending(path) == ending(input) && claimed(path) == own && !is_only_case(other, name)
        })
        .collect();
    others.sort();
    others.into_iter().next().map(|other| input.with_file_name(other))
}

/// True where two names differ in letter case alone: on many systems they are one file.
fn is_only_case(one: &OsStr, other: &OsStr) -> bool {
    one.to_string_lossy().to_lowercase() == other.to_string_lossy().to_lowercase()
}

/// A file name of a stem and an ending, as `impeller` and `-blade.nc`.
#[must_use]
pub fn file_name(stem: &OsStr, ending: &str) -> OsString {
    let mut name = stem.to_owned();
    name.push(ending);
    name
}

fn forbidden(character: char) -> bool {
    matches!(character, '<' | '>' | ':' | '"' | '/' | '\\' | '|' | '?' | '*') || hidden(character)
}

fn end(mut clean: Vec<u8>) -> Vec<u8> {
    for byte in clean.iter_mut().rev() {
        if !matches!(byte, b'.' | b' ') {
            break;
        }
        *byte = b'_';
    }
    clean
}

#[cfg(unix)]
fn os_string(bytes: Vec<u8>) -> OsString {
    std::os::unix::ffi::OsStringExt::from_vec(bytes)
}

#[cfg(not(unix))]
fn os_string(bytes: Vec<u8>) -> OsString {
    String::from_utf8_lossy(&bytes).into_owned().into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stem_may_stand_in_a_file_name_on_any_system() {
        for (workbook, expected) in [
            ("parts/impeller.xlsx", "impeller"),
            ("Rodete nº 1.v2.xlsx", "Rodete nº 1.v2"),
            ("a:b*c?.xlsx", "a_b_c_"),
            ("back\\slash|\"<>.xlsx", "back_slash____"),
            ("esc\u{1b}[2J\n.xlsx", "esc_[2J_"),
            ("bidi\u{202e}xslx.xlsx", "bidi_xslx"),
            ("ends. ..xlsx", "ends___"),
            (".hidden", ".hidden"),
            ("колесо 🌀.xlsx", "колесо 🌀"),
            ("..", "rodete"),
        ] {
            assert_eq!(stem(Path::new(workbook)), OsStr::new(expected), "{workbook:?}");
        }
    }

    #[test]
    fn a_long_stem_is_cut_at_a_character() {
        let long = stem(Path::new(&format!("a{}.xlsx", "é".repeat(150))));
        assert_eq!(long, OsString::from(format!("a{}", "é".repeat(99))));
        assert!(file_name(&long, "-results.xlsx").len() < 255);
    }

    #[cfg(unix)]
    #[test]
    fn bytes_that_are_no_utf8_are_kept() {
        use std::os::unix::ffi::OsStrExt;
        let path = Path::new(OsStr::from_bytes(b"a\xffb:c.xlsx"));
        assert_eq!(file_name(&stem(path), "-blade.nc").as_bytes(), b"a\xffb_c-blade.nc");
    }
}
