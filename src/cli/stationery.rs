//! What an office brings to its reports, read from its files: the logo that a workbook names, the folder of templates.

#![expect(clippy::disallowed_methods, reason = "the door to the files that a workbook and a command line name")]

use std::fs;
use std::io::{self, Read};
use std::path::{Component, Path};

use super::plan::beside;
use crate::escape::printable_path;
use crate::escape::{excerpt, printable};
use crate::finding::answer::answer;
use crate::finding::{Finding, Place, Raise};
use crate::kind::{NamedFile, Outcome};
use crate::limits::{LOGO_BYTES, LOGO_EXCERPT, TEMPLATE_BYTES, TEMPLATE_FILES, TEMPLATE_FOLDERS};
use crate::parameter::{Values, at, title_block};
use crate::report::rules::{LogoNotRead, NamedFileChanged, TemplatesNotRead};
use crate::report::stationery::{Logo, Template};
use crate::store;
use crate::text::{Text, t};

/// The logo that a workbook names, with the SHA-256 of its file; `None` where it names none. Results stand in a folder beside the
/// workbook that they are of: the very file that they were `verified` with is found in the folder above theirs, too.
///
/// # Errors
/// A caution at its cell, where there is no such file beside the workbook or below its folder, or it is no picture.
pub(super) fn logo(
    workbook: &Path,
    values: &Values,
    verified: &[NamedFile],
) -> Result<Option<(Logo, NamedFile)>, Box<Finding>> {
    let name = values.line(&title_block::LOGO);
    if name.is_empty() {
        return Ok(None);
    }
    let located = |finding| Box::new(values.locate(finding));
    let shown = || excerpt(name, LOGO_EXCERPT);
    let place = || at([title_block::LOGO.key()]);
    let not_read = |reason| located(LogoNotRead { name: shown(), reason }.at(place()));
    // Windows writes folders with a backslash; workbooks go from one machine to another.
    let path = name.replace('\\', "/");
    let path = Path::new(&path);
    if !path.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir)) {
        return Err(not_read(t("queda fuera de la carpeta del libro", "it is outside of the workbook's folder")));
    }
    let same = |bytes: &Vec<u8>| verified.iter().any(|then| then.name == name && then.sha256 == store::sha256(bytes));
    let above = || bytes(&beside(workbook).join("..").join(path), LOGO_BYTES).ok().filter(same);
    let bytes =
        bytes(&beside(workbook).join(path), LOGO_BYTES).or_else(|reason| above().ok_or(reason)).map_err(not_read)?;
    let file = NamedFile { name: name.to_owned(), sha256: store::sha256(&bytes) };
    let logo = Logo::new(shown(), bytes, place()).map_err(|finding| located(*finding))?;
    Ok(Some((logo, file)))
}

/// The cautions of the files that a workbook names: those that cannot be read, and those that are not what they were when its
/// programs were `verified`. One that has changed is told in the folder above that of the results, too.
pub(super) fn named(workbook: &Path, outcome: &Outcome, verified: &[NamedFile]) -> Vec<Finding> {
    let name = outcome.fields.values().line(&title_block::LOGO);
    let mut findings = Vec::new();
    let now = match logo(workbook, outcome.fields.values(), verified) {
        Ok(now) => now.map(|(_, now)| now.sha256),
        Err(caution) => {
            let above = beside(workbook).join("..").join(name.replace('\\', "/"));
            // Beside results alone a file of that name may stand above.
            let known = verified.iter().any(|then| then.name == name);
            let found = known.then(|| bytes(&above, LOGO_BYTES).ok()).flatten().map(|bytes| store::sha256(&bytes));
            // The file is there: only that it is another is told.
            if found.is_none() {
                findings.push(*caution);
            }
            found
        }
    };
    let changed = |then: &&NamedFile| then.name == name && now.as_ref().is_some_and(|now| *now != then.sha256);
    if verified.iter().any(|then| changed(&then)) {
        let place = at([title_block::LOGO.key()]);
        findings.push(outcome.fields.locate(NamedFileChanged { name: excerpt(name, LOGO_EXCERPT) }.at(place)));
    }
    findings
}

/// The bytes of a file of at most so many.
fn bytes(path: &Path, most: u64) -> Result<Vec<u8>, Text> {
    let unread = |error: io::Error| answer(&error);
    if !fs::metadata(path).map_err(unread)?.is_file() {
        return Err(t("no es un archivo", "it is not a file"));
    }
    let mut bytes = Vec::new();
    fs::File::open(path).map_err(unread)?.take(most + 1).read_to_end(&mut bytes).map_err(unread)?;
    if u64::try_from(bytes.len()).is_ok_and(|length| length <= most) {
        return Ok(bytes);
    }
    let most = most / (1024 * 1024);
    Err(Text::new(format!("pasa de {most} MiB"), format!("it is larger than {most} MiB")))
}

/// Every file of a folder of templates and of the folders below it. What is no file and no folder, a link among them, is
/// refused: a template reads what lies in its folder and nothing else.
///
/// # Errors
/// Why there is no report with them.
pub(super) fn templates(folder: &Path) -> Result<Vec<Template>, Box<Finding>> {
    let mut found = Vec::new();
    let (mut left, mut open) = (TEMPLATE_BYTES, vec![(folder.to_path_buf(), String::new(), 0)]);
    let refused = |reason| Box::new(TemplatesNotRead { folder: printable_path(folder), reason }.at(Place::File));
    let named = |name: &str, reason: Text| {
        Text::new(format!("{}: {}", printable(name), reason.es), format!("{}: {}", printable(name), reason.en))
    };
    while let Some((path, below, depth)) = open.pop() {
        let unread = |error: io::Error| refused(answer(&error));
        for entry in fs::read_dir(&path).map_err(unread)? {
            let entry = entry.map_err(unread)?;
            let name = format!("{below}{}", entry.file_name().to_string_lossy());
            let kind = entry.file_type().map_err(unread)?;
            if kind.is_dir() && depth < TEMPLATE_FOLDERS {
                open.push((entry.path(), format!("{name}/"), depth + 1));
            } else if kind.is_file() && found.len() < TEMPLATE_FILES {
                let bytes = bytes(&entry.path(), left).map_err(|reason| refused(named(&name, reason)))?;
                left = left.saturating_sub(u64::try_from(bytes.len()).unwrap_or(u64::MAX));
                if name.ends_with(".typ") && std::str::from_utf8(&bytes).is_err() {
                    return Err(refused(named(&name, t("no está en UTF-8", "it is not in UTF-8"))));
                }
                found.push(Template { path: name, bytes });
            } else if kind.is_dir() || kind.is_file() {
                return Err(refused(t("tiene demasiados archivos o carpetas", "it has too many files or folders")));
            } else {
                return Err(refused(named(&name, t("no es un archivo", "it is not a file"))));
            }
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn templates_are_the_files_of_their_folder_by_their_paths() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("impeller")).unwrap();
        fs::write(folder.path().join("cover.typ"), "a").unwrap();
        fs::write(folder.path().join("impeller/setup.typ"), "b").unwrap();
        let mut read: Vec<_> = templates(folder.path()).unwrap().into_iter().map(|one| (one.path, one.bytes)).collect();
        read.sort();
        assert_eq!(read, [("cover.typ".to_owned(), b"a".to_vec()), ("impeller/setup.typ".to_owned(), b"b".to_vec())]);
    }

    #[cfg(unix)]
    #[test]
    fn a_template_in_another_coding_is_refused_by_its_name() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("cover.typ"), b"caf\xE9").unwrap();
        let told = templates(folder.path()).unwrap_err().what.en.clone().into_owned();
        assert!(told.contains("cover.typ: it is not in UTF-8"), "{told}");
    }

    #[test]
    fn a_template_that_leads_out_of_its_folder_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        std::os::unix::fs::symlink("/etc/passwd", folder.path().join("cover.typ")).unwrap();
        let refused = templates(folder.path()).unwrap_err();
        assert!(refused.what.en.contains("cover.typ: it is not a file"), "{}", refused.what.en);
    }

    #[test]
    fn a_file_is_read_up_to_its_limit() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("logo.svg");
        fs::write(&path, vec![0; 1025]).unwrap();
        assert_eq!(bytes(&path, 1024).unwrap_err().en, "it is larger than 0 MiB");
        assert_eq!(bytes(&path, 1025).unwrap().len(), 1025);
        assert_eq!(bytes(folder.path(), 1024).unwrap_err().en, "it is not a file");
    }
}
