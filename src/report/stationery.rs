//! A user's own stationery for reports: a logo, and templates in place of rodete's.

use crate::finding::{Finding, Place, Raise};

use super::rules::{LogoNotDrawn, LogoNotSuited};
use crate::limits::LOGO_PIXELS;
use crate::text::{Text, t};

/// A user's logo and templates; empty by default.
#[derive(Clone, Debug, Default)]
pub struct Stationery<'a> {
    /// The picture for the title block, where there is one.
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
    /// The caution for a file that is neither SVG, PNG nor JPEG, or that typst would not draw: in CMYK, with another file, or huge.
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
        let unsuited = match file {
            "logo.png" => png(&bytes),
            "logo.jpg" => jpeg(&bytes),
            _ => svg(&bytes),
        };
        if let Some(reason) = unsuited {
            return Err(Box::new(LogoNotSuited { name, reason }.at(place)));
        }
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

/// Why a picture of so many pixels is not drawn.
fn too_large(width: u32, height: u32) -> Option<Text> {
    (width.max(height) > LOGO_PIXELS).then(|| {
        Text::new(
            format!("tiene {width} × {height} píxeles, y como mucho valen {LOGO_PIXELS} de lado"),
            format!("it has {width} × {height} pixels, and {LOGO_PIXELS} a side at most will do"),
        )
    })
}

/// Why a PNG is not drawn: the first chunk says how large it is (ISO/IEC 15948, 11.2.2).
fn png(bytes: &[u8]) -> Option<Text> {
    let size = |at: usize| Some(u32::from_be_bytes(bytes.get(at..at + 4)?.try_into().ok()?));
    too_large(size(16)?, size(20)?)
}

/// Why a JPEG is not drawn: its frame header says how large it is and of how many colours (ISO/IEC 10918-1, B.2.2). Four are CMYK.
fn jpeg(bytes: &[u8]) -> Option<Text> {
    let mut rest = bytes.get(2..)?;
    loop {
        let [0xFF, marker, segment @ ..] = rest else { return None };
        let length = usize::from(u16::from_be_bytes([*segment.first()?, *segment.get(1)?]));
        let [_, _, _, high, low, wide, narrow, colours, ..] = *segment else { return None };
        match marker {
            // Filled up with FF.
            0xFF => rest = rest.get(1..)?,
            // Frames; C4, C8 and CC are tables.
            0xC0..=0xCF if ![0xC4, 0xC8, 0xCC].contains(marker) => {
                if colours == 4 {
                    return Some(t(
                        "es un JPEG en colores de imprenta (CMYK)",
                        "it is a JPEG in printing colours (CMYK)",
                    ));
                }
                let size = |high, low| u32::from(u16::from_be_bytes([high, low]));
                return too_large(size(wide, narrow), size(high, low));
            }
            _ => rest = segment.get(length..)?,
        }
    }
}

/// Why an SVG is not drawn: a picture in it that is a file of its own.
fn svg(bytes: &[u8]) -> Option<Text> {
    let text = String::from_utf8_lossy(bytes);
    let outside = text.split("<image").skip(1).any(|image| {
        let image = image.split('>').next().unwrap_or_default();
        let address = image.split("href=").nth(1).map(|rest| rest.trim_start_matches(['"', '\'']));
        address.is_some_and(|address| !address.trim_start().starts_with("data:"))
    });
    outside.then(|| t("enlaza otro archivo", "it links another file"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(bytes: Vec<u8>) -> Option<String> {
        Logo::new("logo".to_owned(), bytes, Place::File).err().map(|finding| finding.what.en.clone().into_owned())
    }

    #[test]
    fn a_picture_that_typst_would_not_draw_is_refused_with_the_reason() {
        let png = |width: u32, height: u32| {
            let head = [b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR".as_slice(), &width.to_be_bytes(), &height.to_be_bytes()];
            head.concat()
        };
        // Behind a comment, a frame of so many colours.
        let jpeg = |marker: u8, wide: u16, colours: u8| {
            let frame =
                [&[0xFF, marker, 0, 17, 8, 0, 40], wide.to_be_bytes().as_slice(), &[colours, 0, 0, 0, 0]].concat();
            [b"\xFF\xD8\xFF\xFE\0\x04ab\xFF".as_slice(), &frame].concat()
        };
        let svg = |inner: &str| format!("<svg xmlns=\"http://www.w3.org/2000/svg\">{inner}</svg>").into_bytes();
        for sound in [
            png(4000, 30),
            jpeg(0xC0, 4000, 3),
            jpeg(0xC2, 20, 1),
            // Cut off, or without a frame: typst says what it makes of it.
            b"\xFF\xD8\xFF".to_vec(),
            svg("<image width='4' href=\"data:image/png;base64,AA\"/>"),
            svg("<rect href='a.png'/>"),
        ] {
            assert_eq!(refused(sound.clone()), None, "{sound:?}");
        }
        for (unsuited, reason) in [
            (png(20_000, 3), "20000 × 3 pixels"),
            (png(3, 4001), "3 × 4001 pixels"),
            (jpeg(0xC0, 20, 4), "CMYK"),
            (jpeg(0xC2, 20, 4), "CMYK"),
            (jpeg(0xC1, 4001, 3), "4001 × 40 pixels"),
            (svg("<image xlink:href='logo.png'/>"), "another file"),
            (svg("<image href=\"data:image/png;base64,AA\"/><image href=\"a.svg\"/>"), "another file"),
        ] {
            assert!(refused(unsuited.clone()).is_some_and(|told| told.contains(reason)), "{reason}");
        }
    }
}
