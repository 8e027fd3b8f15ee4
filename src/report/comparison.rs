//! A comparison of two workbooks as a PDF: what differs in inputs, derived values, findings and programs.

use serde::Serialize;

use crate::kind::comparison::Comparison;
use crate::kind::comparison::sheets::{ComparedCell, ComparedRow, Sheet as Table};
use crate::limits::PRINTED_DIFFERENCES;
use crate::text::{Language, Text, t};
use crate::typeset;
use crate::typeset::characters::Words;
use crate::typeset::compiler::Typst;
use crate::typeset::failure::ReportFailure;

/// The typst template.
const TEMPLATE: &str = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/report-templates/comparison.typ"));
/// A column with longer texts than this shares the width that is left.
const WIDE: usize = 44;

/// One of the two workbooks.
#[derive(Clone, Copy, Debug)]
pub struct ComparedWorkbook<'a> {
    /// Its file.
    pub name: &'a str,
    /// The SHA-256 of its bytes.
    pub sha256: &'a str,
    /// True where it is rejected: then it has no programs.
    pub rejected: bool,
}

#[derive(Serialize)]
struct Contents {
    language: &'static str,
    version: &'static str,
    title: String,
    verdict: String,
    same: bool,
    workbooks: Vec<Workbook>,
    sheets: Vec<Sheet>,
}

#[derive(Serialize)]
struct Workbook {
    side: &'static str,
    name: String,
    end: String,
    sha256: String,
}

#[derive(Serialize)]
struct Sheet {
    title: String,
    columns: Vec<Column>,
    rows: Vec<Vec<String>>,
    note: String,
}

#[derive(Serialize)]
struct Column {
    heading: String,
    number: bool,
    wide: bool,
}

/// Sets the comparison of workbooks A and B.
///
/// # Errors
/// A [`ReportFailure`] where typst does not do its work.
pub fn pdf(
    comparison: &Comparison<'_>,
    [a, b]: [ComparedWorkbook<'_>; 2],
    language: Language,
    typst: &Typst,
) -> Result<Vec<u8>, ReportFailure> {
    let mut words = Words::new(language);
    let workbooks = [("A", a), ("B", b)].map(|(side, one)| Workbook {
        side,
        name: words.line(one.name),
        end: if one.rejected { words.text(&t(", rechazado", ", rejected")) } else { String::new() },
        sha256: one.sha256.to_owned(),
    });
    let verdict = if comparison.same() {
        t("No hay diferencias", "No difference")
    } else {
        t("Hay diferencias", "The two differ")
    };
    let contents = Contents {
        language: language.code(),
        version: env!("CARGO_PKG_VERSION"),
        title: words.text(&t("Comparación de dos libros", "Comparison of two workbooks")),
        verdict: words.text(&verdict),
        same: comparison.same(),
        workbooks: workbooks.into(),
        sheets: comparison.sheets().iter().map(|table| sheet(table, &mut words)).collect(),
    };
    let files = [
        ("comparison.typ".to_owned(), TEMPLATE.as_bytes().to_vec()),
        ("contents.json".to_owned(), serde_json::to_vec(&contents)?),
    ];
    typeset::document(&files, typst)
}

/// The rows of a table that differ, and how many are the same.
fn sheet(table: &Table, words: &mut Words) -> Sheet {
    let language = words.language;
    let differing: Vec<&ComparedRow> = table.lines.iter().filter(|line| line.differs).collect();
    let same = table.lines.len() - differing.len();
    let shown: Vec<&ComparedRow> = differing.iter().take(PRINTED_DIFFERENCES).copied().collect();
    let rows: Vec<Vec<String>> =
        shown.iter().map(|line| line.texts(language).iter().map(|cell| words.line(cell)).collect()).collect();
    let column = |(at, heading): (usize, &Text)| {
        let held = || shown.iter().filter_map(|line| line.cells.get(at));
        Column {
            heading: words.text(heading),
            number: held().any(|one| matches!(one, ComparedCell::Number(_)))
                && held().all(|one| !matches!(one, ComparedCell::Text(_))),
            wide: rows.iter().filter_map(|row| row.get(at)).any(|cell| cell.chars().count() > WIDE),
        }
    };
    let columns = table.headings.iter().enumerate().map(column).collect();
    let count = |es: &str, en: &str, count: usize| Text::new(format!("{count} {es}"), format!("{count} {en}"));
    let mut notes = Vec::new();
    if differing.len() > PRINTED_DIFFERENCES {
        notes.push(count("más que difieren", "more that differ", differing.len() - PRINTED_DIFFERENCES));
    }
    if same > 0 {
        notes.push(count("iguales", "the same", same));
    } else if differing.is_empty() {
        notes.push(t("ninguna", "none"));
    }
    let note = notes.iter().map(|note| words.text(note)).collect::<Vec<_>>().join("; ");
    Sheet { title: words.text(&table.title), columns, rows, note }
}
