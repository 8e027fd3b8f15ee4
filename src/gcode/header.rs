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
    /// The material; a header does not name an empty one.
    pub material: &'a str,
    /// The program number, written with four digits at least.
    pub number: u32,
}

/// The head of a program under construction, its opening first, in one language.
#[derive(Debug)]
pub struct Header {
    language: Language,
    /// The lines so far.
    pub parts: Vec<Part>,
}

impl Header {
    /// The opening of the control and what names program, part, workbook, and rodete.
    #[must_use]
    pub fn new(control: &Control, key: &str, title: &Text, work: Work<'_>, origin: &Origin<'_>) -> Self {
        let Work { part, material, number } = work;
        let opening = control.text.opening.iter().map(|line| Part::Opening(line.text(number, key)));
        let mut header = Self { language: origin.language, parts: opening.collect() };
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

    /// Appends the comment of a program that turns by increments: it is true whether its rotary axes roll over or count on.
    pub fn true_for_both(&mut self) {
        self.line("VALE CON EJES GIRATORIOS ROLLOVER Y CON LINEALES", "VALID FOR ROLLOVER AND LINEAR ROTARY AXES");
    }
}

/// The workbook that a header of rodete's names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedWorkbook {
    /// The comment with its name, as the program has it.
    comment: String,
    /// Its SHA-256 in hexadecimal, lower case.
    pub sha256: String,
}

/// The words before a workbook's name.
const WORKBOOK: [&str; 2] = ["WORKBOOK", "LIBRO"];

impl NamedWorkbook {
    /// What the head of a program says of its workbook; `None` where it names none with its whole SHA-256.
    #[must_use]
    pub fn of(head: &[u8]) -> Option<Self> {
        let text = String::from_utf8_lossy(head);
        let comments = text.lines().filter_map(|line| {
            let line = line.trim();
            let inside = line.strip_prefix('(').and_then(|line| line.strip_suffix(')'));
            inside.or_else(|| line.strip_prefix(';')).map(str::trim)
        });
        let mut comments =
            comments.skip_while(|one| !WORKBOOK.iter().any(|word| one.split(' ').next() == Some(word))).fuse();
        let comment = comments.next()?.to_owned();
        let first = comments.next()?.strip_prefix("SHA-256")?.trim();
        let sha256 = format!("{first}{}", comments.next()?).to_ascii_lowercase();
        let whole = sha256.len() == 64 && sha256.bytes().all(|digit| digit.is_ascii_hexdigit());
        whole.then_some(Self { comment, sha256 })
    }

    /// True of a file's name that the header would have as this: in capitals, without accents, cut where it is long.
    #[must_use]
    pub fn is(&self, name: &str) -> bool {
        WORKBOOK.iter().any(|word| clean(&format!("{word} {name}")).trim_end() == self.comment)
    }

    /// The name as the header has it.
    #[must_use]
    pub fn name(&self) -> &str {
        self.comment.split_once(' ').map_or("", |(_, name)| name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gcode::control::LINUXCNC;
    use crate::text::t;

    #[test]
    fn a_header_names_its_workbook_in_both_languages_and_forms_of_comments() {
        let sha256 = "0123456789abcdef".repeat(4);
        let work = Work { part: "a", material: "", number: 1 };
        for language in Language::ALL {
            for name in ["Álabe nº 1.xlsx", "a.xlsx", &format!("{}.xlsx", "long ".repeat(30))] {
                let origin = Origin { workbook: name, sha256: &sha256, version: "1", language };
                let header = Header::new(&LINUXCNC, "a", &t("a", "a"), work, &origin);
                for [open, close] in [["(", ")"], [";", ""]] {
                    let line = |part: &Part| match part {
                        Part::Comment(text) => format!("{open}{text}{close}\r\n"),
                        _ => String::new(),
                    };
                    let text: String = header.parts.iter().map(line).collect();
                    let named = NamedWorkbook::of(text.as_bytes()).expect("a workbook");
                    assert_eq!(named.sha256, sha256);
                    assert!(named.is(name) && named.is(&name.to_uppercase()), "{named:?}");
                    assert!(!named.is("b.xlsx"));
                }
            }
        }
    }

    #[test]
    fn half_a_sum_names_no_workbook() {
        let half = "0123456789ABCDEF".repeat(2);
        for text in [
            String::new(),
            "(WORKBOOK A.XLSX)\nG0 X1\n".to_owned(),
            format!("(WORKBOOK A.XLSX)\n(SHA-256 {half})\n(RODETE)\n"),
            format!("(WORKBOOK A.XLSX)\n(PART A)\n(SHA-256 {half})\n(        {half})\n"),
            format!("(WORKBOOK A.XLSX)\n(SHA-256 {half})\n(        {}G)\n", &half[1..]),
        ] {
            assert_eq!(NamedWorkbook::of(text.as_bytes()), None, "{text}");
        }
        let whole = format!("(WORKBOOK A.XLSX)\n(SHA-256 {half})\n(        {half})\n");
        assert_eq!(NamedWorkbook::of(whole.as_bytes()).map(|named| named.name().to_owned()).as_deref(), Some("A.XLSX"));
    }
}
