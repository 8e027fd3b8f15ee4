//! The verdicts as one JSON document for scripts.

use serde::Serialize;
use serde_json::{Value, json};

use super::verdict::{Verdict, code, status};
use crate::finding::Exit;
use crate::text::unprintable;

/// The document: version, command, exit code, and for every workbook its end, findings, derived values and files.
/// Characters that a terminal would obey are escaped, which changes no value.
pub(super) fn document(command: &str, exit: Exit, verdicts: &[Verdict]) -> String {
    let workbooks: Vec<_> = verdicts.iter().map(workbook).collect();
    let document = json!({
        "rodete": env!("CARGO_PKG_VERSION"),
        "command": command,
        "exit": code(exit),
        "status": status(exit),
        "workbooks": workbooks,
    });
    let mut text = format!("{document:#}");
    // Outside of strings there is none but the line feed that lays the document out; inside it is escaped already.
    if text.chars().any(|character| character != '\n' && unprintable(character)) {
        text = text.chars().fold(String::new(), |mut text, character| {
            if character != '\n' && unprintable(character) {
                let mut units = [0; 2];
                for unit in character.encode_utf16(&mut units) {
                    text.push_str(&format!("\\u{unit:04x}"));
                }
            } else {
                text.push(character);
            }
            text
        });
    }
    text.push('\n');
    text
}

fn workbook(verdict: &Verdict) -> Value {
    let quantities: Vec<_> = verdict
        .quantities
        .iter()
        .map(|one| {
            json!({
                "symbol": one.symbol,
                "value": one.value,
                "unit": one.unit.label(),
                "meaning": one.meaning,
                "source": one.source,
            })
        })
        .collect();
    let files: Vec<_> = verdict
        .files
        .iter()
        .map(|file| {
            json!({
                "name": file.name.to_string_lossy(),
                "path": file.path.to_string_lossy(),
                "bytes": file.bytes,
                "sha256": file.sha256,
            })
        })
        .collect();
    json!({
        "workbook": verdict.workbook.to_string_lossy(),
        "sha256": verdict.sha256,
        "schema": verdict.schema,
        "exit": code(verdict.exit),
        "status": status(verdict.exit),
        "findings": plain(&verdict.findings),
        "quantities": quantities,
        "folder": verdict.folder.as_ref().map(|folder| folder.to_string_lossy()),
        "files": files,
    })
}

/// A value as JSON. The types given here have only string keys, which is all that could fail.
fn plain(value: &impl Serialize) -> Value {
    serde_json::to_value(value).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::finding::{Finding, Place};
    use crate::text::Text;

    #[test]
    fn the_document_holds_what_was_found_and_written() {
        let mut verdict = Verdict::new("a\u{202e}\u{1b}.xlsx".into());
        verdict.exit = Exit::Refused;
        verdict.findings.push(Finding::stop(
            Place::Sheet("DATA\u{9b}".into()),
            Text::fixed("falta", "missing"),
            Text::fixed("", ""),
        ));
        let text = document("check", Exit::Refused, &[verdict]);
        assert!(text.chars().all(|character| character == '\n' || !unprintable(character)), "{text}");
        let read: Value = serde_json::from_str(&text).expect("a JSON document");
        assert_eq!(read["exit"], 3);
        assert_eq!(read["workbooks"][0]["workbook"], "a\u{202e}\u{1b}.xlsx");
        assert_eq!(read["workbooks"][0]["findings"][0]["place"]["sheet"], "DATA\u{9b}");
        assert_eq!(read["workbooks"][0]["findings"][0]["what"]["es"], "falta");
        assert_eq!(read["workbooks"][0]["files"], json!([]));
    }
}
