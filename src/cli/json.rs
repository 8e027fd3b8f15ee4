//! The verdicts as one JSON document for scripts.

use serde::Serialize;

use super::verdict::{Verdict, code, status};
use crate::escape::hidden;
use crate::finding::{Exit, Finding};
use crate::store::WrittenFile;
use crate::text::Text;

/// What the documents of every command say of their own form: a key is added without another name, and none is taken away.
pub(super) const SCHEMA: &str = "rodete 2";

/// The whole document.
#[derive(Serialize)]
struct Document<'a> {
    schema: &'static str,
    rodete: &'static str,
    command: &'a str,
    exit: u8,
    status: &'static str,
    workbooks: Vec<Workbook<'a>>,
}

/// One of the workbooks that a command was given, with what came of it.
#[derive(Serialize)]
struct Workbook<'a> {
    workbook: String,
    sha256: Option<&'a str>,
    schema: Option<&'static str>,
    exit: u8,
    status: &'static str,
    findings: &'a [Finding],
    quantities: Vec<Quantity<'a>>,
    folder: Option<String>,
    files: Vec<File<'a>>,
}

/// A derived value, its unit as on the sheets.
#[derive(Serialize)]
struct Quantity<'a> {
    symbol: &'static str,
    value: f64,
    unit: &'static str,
    meaning: &'a Text,
    source: &'a Text,
}

/// A file that was written.
#[derive(Serialize)]
pub(super) struct File<'a> {
    name: String,
    path: String,
    bytes: u64,
    sha256: &'a str,
}

/// The document: version, command, exit code, and for every workbook its end, findings, derived values and files.
/// Characters that a terminal would obey are escaped, which changes no value. A path that is no UTF-8 is shown with
/// U+FFFD in its place.
pub(super) fn document(command: &str, exit: Exit, verdicts: &[Verdict]) -> String {
    let document = Document {
        schema: SCHEMA,
        rodete: env!("CARGO_PKG_VERSION"),
        command,
        exit: code(exit),
        status: status(exit),
        workbooks: verdicts.iter().map(workbook).collect(),
    };
    laid_out(&document)
}

/// A document as text, on lines, with characters that a terminal would obey escaped.
pub(super) fn laid_out(document: &impl Serialize) -> String {
    // Every key is a text and a string takes everything: there is nothing to fail.
    let text = serde_json::to_string_pretty(document).unwrap_or_default();
    // Outside of strings the line feeds lay the document out; inside they are escaped already.
    let mut shown = String::with_capacity(text.len() + 1);
    for character in text.chars() {
        if character != '\n' && hidden(character) {
            for unit in character.encode_utf16(&mut [0; 2]) {
                shown.push_str(&format!("\\u{unit:04x}"));
            }
        } else {
            shown.push(character);
        }
    }
    shown.push('\n');
    shown
}

fn workbook(verdict: &Verdict) -> Workbook<'_> {
    let quantities = verdict.quantities.iter().map(|one| Quantity {
        symbol: one.symbol,
        value: one.value,
        unit: one.unit.label(),
        meaning: &one.meaning,
        source: &one.source,
    });
    Workbook {
        workbook: verdict.workbook.to_string_lossy().into_owned(),
        sha256: verdict.sha256.as_deref(),
        schema: verdict.schema,
        exit: code(verdict.exit),
        status: status(verdict.exit),
        findings: &verdict.findings,
        quantities: quantities.collect(),
        folder: verdict.folder.as_ref().map(|folder| folder.to_string_lossy().into_owned()),
        files: files(&verdict.files),
    }
}

/// The files that were written.
pub(super) fn files(written: &[WrittenFile]) -> Vec<File<'_>> {
    let file = written.iter().map(|file| File {
        name: file.name.to_string_lossy().into_owned(),
        path: file.path.to_string_lossy().into_owned(),
        bytes: file.bytes,
        sha256: &file.sha256,
    });
    file.collect()
}

#[cfg(test)]
mod tests {
    use crate::text::t;
    use serde_json::{Value, json};

    use super::*;
    use crate::finding::sample::Stopped;
    use crate::finding::{Place, Raise};

    #[test]
    fn the_document_holds_what_was_found_and_written() {
        let mut verdict = Verdict::new("a\u{202e}\u{1b}.xlsx".into());
        verdict.exit = Exit::Refused;
        let missing = Stopped { what: t("falta", "missing"), todo: t("", "") };
        verdict.findings.push(missing.at(Place::Sheet("DATA\u{9b}".into())));
        let text = document("check", Exit::Refused, &[verdict]);
        assert!(text.chars().all(|character| character == '\n' || !hidden(character)), "{text}");
        let read: Value = serde_json::from_str(&text).expect("a JSON document");
        assert_eq!((&read["schema"], &read["exit"]), (&json!("rodete 2"), &json!(3)));
        assert_eq!(read["workbooks"][0]["findings"][0]["count"], 1);
        assert_eq!(read["workbooks"][0]["workbook"], "a\u{202e}\u{1b}.xlsx");
        assert_eq!(read["workbooks"][0]["findings"][0]["place"]["sheet"], "DATA\u{9b}");
        assert_eq!(read["workbooks"][0]["findings"][0]["what"]["es"], "falta");
        assert_eq!(read["workbooks"][0]["files"], json!([]));
    }
}
