//! Sheets that are laid out like one of the form's, and are not read: copies of it, and those whose name was mistyped.

use crate::escape::excerpt;
use crate::finding::{Finding, Place, Raise};
use crate::limits::EXCERPT;
use crate::parameter::Form;
use crate::parameter::list::{List, Naming};
use crate::text::{Language, Text, one_of};

use super::book::Book;
use super::list_rows;
use super::listing::SheetKind;
use super::rules::form::{SheetOfUnknownPlace, SheetPassedOver, SheetUnderOtherName};
use super::schema::rows_by_symbol;
use super::sheet_cells::SheetCells;
use super::survey::COLUMNS;
use super::words::fold;

/// Letters by which a mistyped name may differ.
const MISTYPED: usize = 2;

/// A caution for each sheet beside those that were read whose name is nearly that of one of the form's, or that has defined names of
/// its own, as a copy has, and that holds what such a sheet holds. A sheet that cannot be read is passed over.
pub(super) fn cautions(book: &mut Book<'_>, form: &'static Form, language: Language, read: &[String]) -> Vec<Finding> {
    let sheets = form.sheets.iter().map(|one| one.name.get(language));
    let lists = form.lists.iter().filter_map(|list| match &list.naming {
        Naming::One(name) => Some(name.get(language)),
        Naming::Numbered(_) => None,
    });
    let names: Vec<&'static str> = sheets.chain(lists).collect();
    let named = |entry: &str| Language::ALL.iter().any(|&language| is_named(form, entry, language));
    let candidates = book.gated.sheets.iter().enumerate().filter(|(place, entry)| {
        let alike = || names.iter().any(|name| is_alike(name, &entry.name));
        let other = entry.kind == SheetKind::Cells && !read.contains(&entry.name) && !named(&entry.name);
        other && (book.gated.own.contains(place) || alike())
    });
    let candidates: Vec<_> = candidates.map(|(_, entry)| entry.clone()).collect();
    let mut findings = Vec::new();
    for entry in candidates {
        let Ok(sheet) = book.read(&entry, COLUMNS) else { continue };
        // A name that is missing is meant before all if it is close; else a copy is one of the sheet whose name it bears with a number.
        let copied = fold(of_copy(&entry.name));
        let taken = |name: &str| read.iter().any(|one| one == name);
        let near = |name: &&str| {
            let letters = strsim::damerau_levenshtein(&fold(name), &fold(&entry.name));
            let missing = !taken(name) && letters <= MISTYPED;
            (!missing, fold(name) != copied, taken(name), letters)
        };
        let alike = laid_out(form, language, &sheet);
        let Some(likeliest) = alike.iter().copied().min_by_key(near) else { continue };
        let name = excerpt(&entry.name, EXCERPT);
        // Of several sheets with one layout, all of them there, nothing but the name of a copy says which one this may replace.
        let certain = !taken(likeliest) || fold(likeliest) == copied || alike.len() == 1;
        let (place, like) = (Place::Sheet(entry.name.clone()), likeliest.to_owned());
        findings.push(match (taken(likeliest), certain) {
            (false, _) => SheetUnderOtherName { name, like }.at(place),
            (true, true) => SheetPassedOver { name, like }.at(place),
            (true, false) => {
                let like = one_of(alike.iter().map(|name| Text::same(format!("\"{name}\""))));
                SheetOfUnknownPlace { name, like }.at(place)
            }
        });
    }
    findings
}

/// True for the very name of one of the form's sheets: of one in another language more is said elsewhere.
fn is_named(form: &Form, name: &str, language: Language) -> bool {
    let is = |of: &Text| of.get(language).eq_ignore_ascii_case(name.trim());
    let list = |one: &List| matches!(&one.naming, Naming::One(of) if is(of));
    form.sheets.iter().any(|one| is(&one.name)) || form.lists.iter().any(list)
}

/// The name of which a spreadsheet makes this one for a copy: `DATA (2)`, `DATA_2`.
fn of_copy(name: &str) -> &str {
    let name = name.trim();
    let bare = name
        .strip_suffix(')')
        .and_then(|rest| Some(rest.trim_end_matches(|one: char| one.is_ascii_digit()).strip_suffix('(')?.trim_end()));
    bare.or_else(|| name.trim_end_matches(|one: char| one.is_ascii_digit()).strip_suffix('_')).unwrap_or(name)
}

/// True for a name with the other in it, or with a few letters more or less: `DATA (2)`, `Copy of DATA`, `PROFIL`.
fn is_alike(name: &str, other: &str) -> bool {
    let (name, other) = (fold(name), fold(other));
    let most = if name.chars().count() > 4 { MISTYPED } else { 1 };
    other.contains(&name) || strsim::damerau_levenshtein(&name, &other) <= most
}

/// The names of the form's sheets and lists that a sheet is laid out like: it has half of the symbols, or the headings and a row.
fn laid_out(form: &'static Form, language: Language, sheet: &SheetCells) -> Vec<&'static str> {
    let symbols = rows_by_symbol(sheet);
    let sheets = form.sheets.iter().filter(|one| {
        let parameters: Vec<_> = one.sections.iter().flat_map(|section| section.parameters).collect();
        let there = parameters.iter().filter(|one| symbols.contains_key(one.symbol())).count();
        there > 0 && 2 * there >= parameters.len()
    });
    let lists = form.lists.iter().filter_map(|list| match &list.naming {
        Naming::One(name) => list_rows::read(list, sheet, &mut Vec::new()).map(|_| name.get(language)),
        Naming::Numbered(_) => None,
    });
    sheets.map(|one| one.name.get(language)).chain(lists).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_copy_is_one_of_the_sheet_that_it_was_made_of() {
        for (name, of) in
            [("DATA (2)", "DATA"), ("PROGRAM 2_3", "PROGRAM 2"), ("PROGRAM2", "PROGRAM2"), ("TOOLS (b)", "TOOLS (b)")]
        {
            assert_eq!(of_copy(name), of);
        }
    }

    #[test]
    fn names_of_copies_and_mistyped_ones_are_alike_and_others_are_not() {
        for (name, other) in [
            ("DATA", "Copy of Data"),
            ("DATA", "DATA (2)"),
            ("DATA", "data_3"),
            ("PROFILE", "PROFIL"),
            ("PROGRAM 2", "PROGRAM  2"),
        ] {
            assert!(is_alike(name, other), "{other}");
        }
        for (name, other) in [("DATA", "DISC"), ("DATA", "Annex 2"), ("TOOLS", "Notes"), ("PROGRAM", "SUMMARY")] {
            assert!(!is_alike(name, other), "{other}");
        }
    }
}
