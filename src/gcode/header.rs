//! The comments at the head of a program: what it is and where it comes from.

use crate::gcode::comment::clean;
use crate::gcode::control::Control;
use crate::gcode::program::Part;
use crate::text::{Language, Text};

/// Where the programs come from, for their headers.
#[derive(Clone, Copy, Debug)]
pub struct Origin<'a> {
    /// The workbook's file name.
    pub workbook: &'a str,
    /// Its SHA-256 in hexadecimal.
    pub sha256: &'a str,
    /// The version of rodete.
    pub version: &'a str,
    /// The language of comments.
    pub language: Language,
}

/// What is made, for the head of a program.
#[derive(Clone, Copy, Debug)]
pub struct Work<'a> {
    /// The part's name.
    pub part: &'a str,
    /// The material.
    pub material: &'a str,
    /// The program number.
    pub number: u32,
}

/// The head of a program under construction, its opening line first, in one language.
#[derive(Debug)]
pub struct Header {
    language: Language,
    /// The lines so far.
    pub parts: Vec<Part>,
}

impl Header {
    /// The opening line and what names program, part, workbook, and rodete.
    #[must_use]
    pub fn new(control: &Control, key: &str, title: &Text, work: Work<'_>, origin: &Origin<'_>) -> Self {
        let Work { part, material, number } = work;
        let opening = control.text.opening_line(number, key).map(Part::Line);
        let mut header = Self { language: origin.language, parts: opening.into_iter().collect() };
        header.line(&format!("PROGRAMA {number:04} - {}", title.es), &format!("PROGRAM {number:04} - {}", title.en));
        header.line(&format!("PIEZA {part}"), &format!("PART {part}"));
        if !material.is_empty() {
            header.line(&format!("MATERIAL {material}"), &format!("MATERIAL {material}"));
        }
        header.line(&format!("LIBRO {}", origin.workbook), &format!("WORKBOOK {}", origin.workbook));
        let (first, second) = origin.sha256.split_at(origin.sha256.len().min(32));
        header.line(&format!("SHA-256 {first}"), &format!("SHA-256 {first}"));
        header.line(&format!("        {second}"), &format!("        {second}"));
        header.line(
            &format!("RODETE {} - DIALECTO {}", origin.version, control.name),
            &format!("RODETE {} - DIALECT {}", origin.version, control.name),
        );
        header
    }

    /// Appends a comment.
    pub fn line(&mut self, es: &str, en: &str) {
        let text = match self.language {
            Language::Es => es,
            Language::En => en,
        };
        self.parts.push(Part::Comment(clean(text)));
    }
}
