//! The workbook of an example in the language that is spoken: its sheets, and the words of its choices.

use crate::kind::Kind;
use crate::parameter::list::{List, Naming};
use crate::parameter::{FieldKind, Form, Parameter};
use crate::sweep;
use crate::text::{Language, Text};

/// The forms of an example's workbook.
pub(super) struct Cells {
    forms: Vec<&'static Form>,
    language: Language,
}

impl Cells {
    /// Of a workbook of this kind, of which a case may be named behind it; the sheet of variants may be in it.
    pub(super) fn of(kinds: &[&dyn Kind], kind: &str, language: Language) -> Self {
        let named = |one: &&&dyn Kind| kind.split(' ').next() == Some(one.form().kind);
        let forms = kinds.iter().find(named).map(|one| one.form()).into_iter().chain([&sweep::form::FORM]).collect();
        Self { forms, language }
    }

    /// A place, as `SYMBOL` or `DATA!D7`, and what is typed there; each as it is in an English workbook.
    pub(super) fn spoken(&self, place: &str, text: &str) -> (String, String) {
        if let Some((sheet, cell)) = place.split_once('!') {
            let found = self.sheets().find(|(name, _)| name.en == sheet);
            let name = found.as_ref().map_or(sheet, |(name, _)| name.get(self.language));
            let word = found.as_ref().and_then(|(_, parameters)| self.word(parameters, text));
            return (format!("{name}!{cell}"), word.unwrap_or(text).to_owned());
        }
        let all = self.forms.iter().flat_map(|form| form.parameters());
        let named: Vec<_> = all.map(|(_, parameter)| parameter).filter(|one| one.symbol() == place).collect();
        (place.to_owned(), self.word(&named, text).unwrap_or(text).to_owned())
    }

    /// What stands for a choice of one of these.
    fn word(&self, parameters: &[&Parameter], text: &str) -> Option<&'static str> {
        parameters.iter().find_map(|parameter| match parameter.kind {
            FieldKind::Choice(choices) => {
                let choice = choices.iter().find(|choice| choice.key == text || choice.label.en == text)?;
                Some(choice.label.get(self.language))
            }
            _ => None,
        })
    }

    /// Every sheet with one name, and what is filled in on it.
    fn sheets(&self) -> impl Iterator<Item = (&'static Text, Vec<&'static Parameter>)> {
        let named = |list: &'static List| match &list.naming {
            Naming::One(name) => Some((name, list.columns.to_vec())),
            Naming::Numbered(_) => None,
        };
        self.forms.iter().flat_map(move |form| {
            let sheets = form.sheets.iter().map(|sheet| {
                let parameters = sheet.sections.iter().flat_map(|section| section.parameters);
                (&sheet.name, parameters.copied().collect())
            });
            sheets.chain(form.lists.iter().filter_map(named))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kinds::KINDS;

    #[test]
    fn an_example_names_sheets_and_words_of_the_language() {
        for (kind, given, es) in [
            ("lathe", ("PROGRAM!A7", "N5 G199"), ("PROGRAMA!A7", "N5 G199")),
            ("lathe", ("PROGRAM 2!A6", "T0101"), ("PROGRAMA 2!A6", "T0101")),
            ("lathe", ("tailstock", "yes"), ("tailstock", "sí")),
            ("pipe-insert --case square", ("mode", "rotary"), ("mode", "giratorio")),
            ("impeller", ("SWEEP!C9", "limits"), ("BARRIDO!C9", "límites")),
            ("impeller", ("R", "'12,5"), ("R", "'12,5")),
        ] {
            let spoken = |language| Cells::of(KINDS, kind, language).spoken(given.0, given.1);
            assert_eq!(spoken(Language::Es), (es.0.to_owned(), es.1.to_owned()));
            assert_eq!(spoken(Language::En), (given.0.to_owned(), given.1.to_owned()));
        }
    }
}
