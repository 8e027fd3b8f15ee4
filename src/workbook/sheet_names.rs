//! The sheets that a form, or a table, is looked for in, by their names in either language.

use crate::escape::excerpt;
use crate::finding::{Exit, Finding, Place, Raise, Refusal};
use crate::limits::EXCERPT;
use crate::parameter::Form;
use crate::parameter::list::{List, Naming};
use crate::text::{Language, Text, one_of};

use super::listing::{SheetEntry, SheetKind};
use super::rules::form::*;
use super::words;

/// The sheet that a form begins with, and its language.
pub(super) fn first_sheet(
    sheets: &[SheetEntry],
    forms: &[&'static Form],
    is_form: impl FnMut(&SheetEntry) -> bool,
) -> Result<(SheetEntry, Language), Refusal> {
    let mut names: Vec<(&str, Language)> = Vec::new();
    for sheet in forms.iter().filter_map(|form| form.sheets.first()) {
        for language in Language::ALL {
            let name = sheet.name.get(language);
            if names.iter().all(|known| known.0 != name) {
                names.push((name, language));
            }
        }
    }
    sheet_named(sheets, &names, is_form, |wanted, there| SheetNotFound { wanted, there }.at(Place::File))
}

/// The one sheet that bears one of the names, and the language of that name; `is_it` judges one whose name is alike; `otherwise` tells
/// that there is no such sheet and none alike, from the names and from those that are there.
///
/// # Errors
/// [`Exit::Refused`] where there is none, or more than one that a person would take for it.
pub(super) fn sheet_named(
    sheets: &[SheetEntry],
    names: &[(&str, Language)],
    mut is_it: impl FnMut(&SheetEntry) -> bool,
    otherwise: impl FnOnce(Text, String) -> Finding,
) -> Result<(SheetEntry, Language), Refusal> {
    let found: Vec<_> = sheets
        .iter()
        .filter_map(|entry| names.iter().find(|name| name.0 == entry.name).map(|name| (entry, name.1)))
        .collect();
    let alike: Vec<_> =
        sheets.iter().filter(|entry| names.iter().any(|name| same_but_for_case(name.0, &entry.name))).collect();
    match found.as_slice() {
        [] => {
            let wanted = one_of(names.iter().map(|name| Text::same(format!("\"{}\"", name.0))));
            let there = list(sheets);
            let finding = match alike.iter().find(|entry| is_it(entry)) {
                Some(entry) => {
                    let name = excerpt(&entry.name, EXCERPT);
                    let right =
                        names.iter().find(|name| same_but_for_case(name.0, &entry.name)).map_or("", |name| name.0);
                    SheetMisnamed { wanted, there, name, right: right.to_owned() }.at(Place::File)
                }
                None => otherwise(wanted, there),
            };
            Err(Refusal::new(Exit::Refused, finding))
        }
        [(entry, language)] if alike.len() == 1 => {
            if entry.kind == SheetKind::Cells {
                Ok(((*entry).clone(), *language))
            } else {
                Err(no_cells(entry))
            }
        }
        _ => Err(ambiguous(&alike)),
    }
}

/// A further sheet of a form, in either language.
pub(super) fn find(
    sheets: &[SheetEntry],
    name: &'static Text,
    language: Language,
    findings: &mut Vec<Finding>,
) -> Result<Option<SheetEntry>, Refusal> {
    let names = Language::ALL.map(|language| name.get(language));
    let mut alike: Vec<_> =
        sheets.iter().filter(|entry| names.iter().any(|name| same_but_for_case(name, &entry.name))).collect();
    if alike.iter().any(|entry| names.contains(&entry.name.as_str())) {
        // Beside the sheet itself, one whose name has an accent more is another: the table `Calibración` of results.
        let plain = |name: &str| name.trim().to_lowercase();
        alike.retain(|entry| names.iter().any(|name| plain(name) == plain(&entry.name)));
    }
    let [entry] = alike.as_slice() else {
        return if alike.is_empty() { Ok(None) } else { Err(ambiguous(&alike)) };
    };
    if entry.kind != SheetKind::Cells {
        return Err(no_cells(entry));
    }
    if names.contains(&entry.name.as_str()) {
        return Ok(Some((*entry).clone()));
    }
    // The name that it has in a workbook of this language, whatever the language of the message.
    let (right, name) = (name.get(language), excerpt(&entry.name, EXCERPT));
    findings.push(SheetNotRead { name, right }.at(Place::Sheet(entry.name.clone())));
    Ok(None)
}

/// The sheets of a list, in the order of the workbook.
pub(super) fn list_sheets(
    list: &'static List,
    sheets: &[SheetEntry],
    language: Language,
    findings: &mut Vec<Finding>,
) -> Result<Vec<SheetEntry>, Refusal> {
    match &list.naming {
        Naming::One(name) => {
            let found = find(sheets, name, language, findings)?;
            if found.is_none() && !list.optional {
                findings.push(SheetMissing { sheet: name.get(language) }.at(Place::File));
            }
            Ok(found.into_iter().collect())
        }
        Naming::Numbered(_) => Ok(sheets
            .iter()
            .filter(|entry| entry.kind == SheetKind::Cells && is_numbered(&entry.name))
            .cloned()
            .collect()),
    }
}

/// True for `O` and one to four digits.
fn is_numbered(name: &str) -> bool {
    let digits = name.trim().strip_prefix(['O', 'o']).unwrap_or_default();
    (1..=4).contains(&digits.len()) && digits.bytes().all(|byte| byte.is_ascii_digit())
}

fn ambiguous(alike: &[&SheetEntry]) -> Refusal {
    let names =
        alike.iter().map(|entry| format!("\"{}\"", excerpt(&entry.name, EXCERPT))).collect::<Vec<_>>().join(", ");
    SheetAmbiguous { names }.refused(Exit::Refused, Place::File)
}

/// The names of the sheets, ten of them at most.
fn list(sheets: &[SheetEntry]) -> String {
    let mut names: Vec<_> =
        sheets.iter().take(10).map(|entry| format!("\"{}\"", excerpt(&entry.name, EXCERPT))).collect();
    if sheets.len() > 10 {
        names.push("…".to_owned());
    }
    names.join(", ")
}

/// True for names that a person takes for one: alike but for capitals, accents and blanks around.
pub(super) fn same_but_for_case(one: &str, other: &str) -> bool {
    words::fold(one) == words::fold(other)
}

/// Refuses a sheet without cells: a sheet of a chart, or an empty one.
pub(super) fn no_cells(entry: &SheetEntry) -> Refusal {
    let sheet = excerpt(&entry.name, EXCERPT);
    SheetWithoutCells { sheet }.refused(Exit::Refused, Place::Sheet(entry.name.clone()))
}
