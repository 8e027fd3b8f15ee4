//! The typst templates, part of the library so that the binary stands alone.

use std::fs;
use std::io;
use std::path::Path;

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
    "method-impeller.typ",
    "method-impeller-es.typ",
    "method-impeller-en.typ",
    "method-lathe.typ",
    "method-lathe-es.typ",
    "method-lathe-en.typ",
    "method-pipe-hole.typ",
    "method-pipe-hole-es.typ",
    "method-pipe-hole-en.typ",
    "method-pipe-insert.typ",
    "method-pipe-insert-es.typ",
    "method-pipe-insert-en.typ",
    "annexes.typ",
    "programs.typ",
    "verification.typ",
    "checks.typ",
    "setup.typ",
    "setup-parts.typ",
    "setup-impeller.typ",
    "setup-lathe.typ",
    "setup-pipe-hole.typ",
    "setup-pipe-insert.typ",
];

/// Writes the templates into a folder.
#[expect(clippy::disallowed_methods, reason = "the door into the compiler's folder")]
pub(super) fn write(folder: &Path) -> io::Result<()> {
    TEMPLATES.iter().try_for_each(|(name, text)| fs::write(folder.join(name), text))
}
