//! The typst templates, part of the library so that the binary stands alone.

use std::fs;
use std::io;
use std::path::Path;

use super::stationery::Template;
use crate::kind::{Chapters, Kind};

/// The folder of the kind's chapters.
const KIND: &str = "kind";

macro_rules! templates {
    ($($name:literal),+ $(,)?) => {
        /// Every template by its path in the folder.
        const TEMPLATES: &[(&str, &str)] =
            &[$(($name, include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/report-templates/", $name)))),+];
    };
}

templates![
    "report.typ",
    "shortened.typ",
    "style.typ",
    "labels.typ",
    "tables.typ",
    "cover.typ",
    "design.typ",
    "method.typ",
    "annexes.typ",
    "programs.typ",
    "verification.typ",
    "checks.typ",
    "setup.typ",
    "setup-sheet.typ",
    "setup-parts.typ",
];

/// Whether none of an office's files has the name of one of the templates: then the report is rodete's own.
pub(super) fn replace_nothing(kind: &dyn Kind, own: &[Template]) -> bool {
    let chapters = chapters(kind);
    let known = |path: &str| match path.split_once('/') {
        Some((folder, rest)) if folder == kind.form().kind || folder == KIND => {
            chapters.iter().any(|(name, _)| *name == rest)
        }
        _ => TEMPLATES.iter().any(|(name, _)| *name == path),
    };
    !own.iter().any(|one| known(&one.path))
}

/// The chapters of a kind, by their names.
fn chapters(kind: &dyn Kind) -> Vec<(&'static str, &'static str)> {
    let Chapters { labels, method: [es, en], setup, further } = kind.chapters();
    let own = [("labels.typ", *labels), ("method-es.typ", es), ("method-en.typ", en), ("setup.typ", setup)];
    own.into_iter().chain(further.iter().copied()).collect()
}

/// Writes the templates of all kinds into a folder, and the chapters of one into the folder `kind` in it; then those of an
/// office over them, whose folder with the name of the kind is `kind`, too.
#[expect(clippy::disallowed_methods, reason = "the door into the compiler's folder")]
pub(super) fn write(folder: &Path, kind: &dyn Kind, own: &[Template]) -> io::Result<()> {
    TEMPLATES.iter().try_for_each(|(name, text)| fs::write(folder.join(name), text))?;
    fs::create_dir(folder.join(KIND))?;
    chapters(kind).iter().try_for_each(|(name, text)| fs::write(folder.join(KIND).join(name), text))?;
    for Template { path, bytes } in own {
        let path = match path.split_once('/') {
            Some((first, rest)) if first == kind.form().kind => folder.join(KIND).join(rest),
            _ => folder.join(path),
        };
        path.parent().map_or(Ok(()), fs::create_dir_all)?;
        fs::write(path, bytes)?;
    }
    Ok(())
}
