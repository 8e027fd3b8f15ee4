//! The typst templates, part of the library so that the binary stands alone.

use std::fs;
use std::io;
use std::path::Path;

use crate::kind::Chapters;

macro_rules! templates {
    ($($name:literal),+ $(,)?) => {
        /// Every template by its path in the folder.
        const TEMPLATES: &[(&str, &str)] =
            &[$(($name, include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/report-templates/", $name)))),+];
    };
}

templates![
    "report.typ",
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

/// Writes the templates of all kinds into a folder, and the chapters of one into the folder `kind` in it.
#[expect(clippy::disallowed_methods, reason = "the door into the compiler's folder")]
pub(super) fn write(folder: &Path, chapters: &Chapters) -> io::Result<()> {
    TEMPLATES.iter().try_for_each(|(name, text)| fs::write(folder.join(name), text))?;
    let folder = folder.join("kind");
    fs::create_dir(&folder)?;
    let [es, en] = chapters.method;
    let own =
        [("labels.typ", chapters.labels), ("method-es.typ", es), ("method-en.typ", en), ("setup.typ", chapters.setup)];
    own.iter().chain(chapters.further).try_for_each(|(name, text)| fs::write(folder.join(name), text))
}
