//! The stamp of a build: a sum of the inputs that its sheets were made from.
//!
//! The guard's sheet holds the one of the workbook's last build, and each sheet of results its own, inside its formulas. A sheet that
//! was copied keeps its stamp: as soon as the workbook is built of other inputs, the two differ.

use std::collections::BTreeMap;
use std::fmt::Write;

use sha2::{Digest, Sha256};

use super::address::{self, Position};
use super::book::Book;
use super::gate::gate;
use super::limits;
use super::listing::SheetKind;
use super::rules::form::SheetsOfAnotherBuild;
use super::sheet_cells::{Content, SheetCells};
use super::xml;
use crate::escape::excerpt;
use crate::finding::{Finding, Place, Raise, Refusal};
use crate::kind::Outcome;
use crate::limits::EXCERPT;
use crate::parameter::Value;

/// The defined name of how many inputs differ.
pub const STALE: &str = "stale_inputs";
/// The defined name of the workbook's stamp.
pub const NAME: &str = "build_stamp";
/// Its digits: those of the beginning of a SHA-256, in hexadecimal.
const DIGITS: usize = 16;
/// How many sheets a message names.
const LISTED: usize = 8;

/// The stamp of an outcome: the same where version, values, lists, and the files that the workbook names are.
#[must_use]
pub fn of(outcome: &Outcome) -> String {
    let values = outcome.fields.values();
    let mut told = format!("{}\n{}\n", outcome.source.version, outcome.fields.form().schema);
    let line = |told: &mut String, key: &str, value: &Value| {
        let _ = match value {
            Value::Real(value) => writeln!(told, "{key} {value}"),
            Value::Whole(value) => writeln!(told, "{key} {value}"),
            Value::Choice(value) => writeln!(told, "{key} {value}"),
            Value::Line(value) => writeln!(told, "{key} {value}"),
        };
    };
    values.values.iter().for_each(|(key, value)| line(&mut told, key, value));
    for rows in &values.lists {
        let _ = writeln!(told, "[{}] {}", rows.list, rows.sheet);
        for row in &rows.rows {
            told.push_str("-\n");
            row.values.iter().for_each(|(key, value)| line(&mut told, key, value));
        }
    }
    for file in &outcome.named_files {
        let _ = writeln!(told, "{} {}", file.sha256, file.name);
    }
    let sum = Sha256::digest(told.as_bytes());
    sum.iter().take(DIGITS / 2).map(|byte| format!("{byte:02x}")).collect()
}

/// True, as a formula, where the workbook's stamp is another, or none, or is not the text of a cell, as it was written: what a formula
/// shows may follow the sheet. A spreadsheet without ISFORMULA does not see that.
pub(super) fn differs(stamp: &str) -> String {
    let formula = format!("_xlfn.ISFORMULA({NAME})");
    format!(
        "IF(ISTEXT({NAME}),IF(ISREF({NAME}),IF(EXACT({NAME},\"{stamp}\"),IF(ISERROR({formula}),FALSE,{formula}),TRUE),TRUE),TRUE)"
    )
}

/// The stamps that the formulas of a sheet's part compare with the workbook's; `<>` is how sheets of before compare them.
pub(crate) fn stamps(text: &str) -> impl Iterator<Item = &str> {
    text.split(NAME).skip(1).filter_map(|rest| {
        let rest = rest.strip_prefix(',').or_else(|| rest.strip_prefix("&lt;&gt;"))?;
        let rest = rest.strip_prefix('"').or_else(|| rest.strip_prefix("&quot;"))?;
        rest.get(..DIGITS).filter(|stamp| stamp.bytes().all(|one| one.is_ascii_hexdigit()))
    })
}

/// True where a workbook has the names of one that was built.
pub(super) fn is_named(names: &BTreeMap<String, String>) -> bool {
    [NAME, STALE].iter().any(|name| names.contains_key(*name))
}

/// The caution on sheets of results that are not of the last build of the workbook that they stand in: copies.
///
/// # Errors
/// What the gate refuses.
pub fn others(bytes: &[u8]) -> Result<Option<Finding>, Refusal> {
    let gated = gate(bytes)?;
    let guard = match gated.names.get(NAME) {
        Some(formula) => address::cell(formula),
        // Results that have lost the name: whatever carries a stamp is told.
        None if gated.names.contains_key(STALE) => None,
        None => return Ok(None),
    };
    let mut book = Book::open(gated)?;
    let sheets: Vec<_> = book.gated.sheets.iter().filter(|one| one.kind == SheetKind::Cells).cloned().collect();
    // The name may lead nowhere, or into another workbook, whose sheet was copied.
    let present = guard.and_then(|(sheet, cell)| {
        let entry = sheets.iter().find(|one| one.name.to_lowercase() == sheet.to_lowercase())?;
        Some((entry, address::parse(&cell)?))
    });
    let present = match present {
        Some((entry, at)) => written(&book.read(entry, at.1 + 1)?, at),
        None => None,
    };
    let mut found = Vec::new();
    for sheet in &sheets {
        let bytes = book.gated.package.part(&sheet.part, limits::PART)?.unwrap_or_default();
        let text = xml::text(&sheet.part, bytes)?;
        if stamps(&text).any(|stamp| Some(stamp) != present.as_deref()) {
            found.push(excerpt(&sheet.name, EXCERPT));
        }
    }
    if found.is_empty() {
        return Ok(None);
    }
    let more = if found.len() > LISTED { ", …" } else { "" };
    found.truncate(LISTED);
    Ok(Some(SheetsOfAnotherBuild { sheets: found.join(", ") + more }.at(Place::File)))
}

/// The text of a cell, blanks and all, as the sheets' formulas compare it; none of a formula.
fn written(sheet: &SheetCells, at: Position) -> Option<String> {
    match &sheet.cell(at)?.content {
        Content::Text(text, _) if !sheet.survey.formulas.contains(&at) => Some(text.clone()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::{differs, stamps};
    use quick_xml::escape::escape;

    #[test]
    fn the_stamp_of_a_sheet_is_read_out_of_its_formulas() {
        let formula = differs("0123456789abcdef");
        let before = escape("build_stamp<>\"0123456789abcdef\"").into_owned();
        for text in [escape(&formula).into_owned(), escape(&formula).replace("&quot;", "\""), before] {
            assert_eq!(stamps(&text).collect::<Vec<_>>(), ["0123456789abcdef"], "{text}");
        }
        assert_eq!(stamps("build_stamp&lt;&gt;\"short\"").count(), 0);
    }
}
