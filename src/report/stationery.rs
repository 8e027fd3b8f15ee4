//! A user's own stationery for reports: a logo, and templates in place of rodete's.

use crate::finding::{Finding, Place, Raise};

use super::rules::LogoNotDrawn;

/// A user's logo and templates; empty by default.
#[derive(Clone, Debug, Default)]
pub struct Stationery<'a> {
    /// The logo.
    pub logo: Option<Logo>,
    /// The templates; each replaces rodete's of the same name.
    pub templates: &'a [Template],
}

/// A typst file, or a file that one reads.
#[derive(Clone, Debug)]
pub struct Template {
    /// Its path below the folder of templates, as `cover.typ` or `impeller/setup.typ`.
    pub path: String,
    /// Its contents.
    pub bytes: Vec<u8>,
}

/// A picture for the title block.
#[derive(Clone, Debug)]
pub struct Logo {
    /// Its name in the workbook.
    name: String,
    /// Its name for the templates.
    file: &'static str,
    bytes: Vec<u8>,
    /// The cell that names it.
    place: Place,
}

impl Logo {
    /// A file as a picture, by its first bytes, not by its name; `place` is the cell that names it.
    ///
    /// # Errors
    /// The caution for a file that is neither SVG, PNG nor JPEG.
    pub fn new(name: String, bytes: Vec<u8>, place: Place) -> Result<Self, Box<Finding>> {
        /// How far the root of an SVG is searched for, after its declaration and comments.
        const HEAD: usize = 4096;
        let head = bytes.get(..HEAD.min(bytes.len())).unwrap_or_default();
        let file = if head.starts_with(b"\x89PNG\r\n\x1a\n") {
            "logo.png"
        } else if head.starts_with(b"\xFF\xD8\xFF") {
            "logo.jpg"
        } else if String::from_utf8_lossy(head).contains("<svg") {
            "logo.svg"
        } else {
            return Err(Box::new(LogoNotDrawn { name }.at(place)));
        };
        Ok(Self { name, file, bytes, place })
    }

    pub(super) const fn file(&self) -> &'static str {
        self.file
    }

    pub(super) fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// The caution for a picture that typst cannot draw.
    pub(super) fn not_drawn(&self) -> Finding {
        LogoNotDrawn { name: self.name.clone() }.at(self.place.clone())
    }
}
