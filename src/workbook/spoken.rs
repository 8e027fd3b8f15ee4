//! The language that a workbook is in, also where its values are refused.

use crate::parameter::Form;
use crate::parameter::list::Naming;
use crate::text::{Language, Text};

use super::gate::gate;
use super::offsets_sheet;
use super::words::fold;

/// The language that the names of a workbook's sheets are of: those of `forms`, and that of work offsets. `None` where no
/// sheet tells, or where the file is no workbook.
#[must_use]
pub fn language(bytes: &[u8], forms: &[&'static Form]) -> Option<Language> {
    let sheets = gate(bytes).ok()?.sheets;
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
