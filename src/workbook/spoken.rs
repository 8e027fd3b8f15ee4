//! The language that a workbook is in, also where its values are refused.

use crate::parameter::Form;
use crate::parameter::list::Naming;
use crate::text::{Language, Text};

use super::book::Book;
use super::gate::gate;
use super::words::fold;
use super::{offsets_sheet, schema};

/// The language of the form that is read in a workbook; where none is, the one that the names of its sheets are of: those of `forms`,
/// and that of work offsets. `None` where no sheet tells, or where the file is no workbook.
#[must_use]
pub fn language(bytes: &[u8], forms: &[&'static Form]) -> Option<Language> {
    let gated = gate(bytes).ok()?;
    let sheets = gated.sheets.clone();
    // A sheet of somebody else's may have the name of a form in the other language: the form that is read says it.
    let of_form = Book::open(gated).ok().and_then(|mut book| schema::language(&mut book, forms));
    if of_form.is_some() {
        return of_form;
    }
    let mut names: Vec<&Text> = vec![&offsets_sheet::NAME];
    for form in forms {
        names.extend(form.sheets.iter().map(|sheet| &sheet.name));
        names.extend(form.lists.iter().filter_map(|list| match &list.naming {
            Naming::One(name) => Some(name),
            Naming::Numbered(_) => None,
        }));
    }
    let told = |entry: &str| {
        let is = |name: &&Text, language| fold(name.get(language)) == fold(entry);
        let of = |language| names.iter().any(|name| is(name, language));
        match Language::ALL.map(of) {
            [true, false] => Some(Language::Es),
            [false, true] => Some(Language::En),
            _ => None,
        }
    };
    sheets.iter().find_map(|entry| told(&entry.name))
}
