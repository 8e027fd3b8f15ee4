//! The workbook kinds that the commands know.

use crate::impeller::cases::{CASES, Case};
use crate::impeller::parameters::FORM;
use crate::parameter::{Form, Kind};

/// Every form, the usual one first.
pub(super) static FORMS: [&Form; 1] = [&FORM];

/// The kinds' names.
pub(super) fn names() -> Vec<&'static str> {
    FORMS.iter().map(|form| form.kind).collect()
}

/// The names of the cases that a new workbook can start from.
pub(super) fn cases() -> Vec<&'static str> {
    CASES.iter().map(|case| case.name).collect()
}

/// The case that a new workbook starts from if none is named.
pub(super) fn first_case() -> &'static str {
    CASES.first().map_or("", |case| case.name)
}

/// The case with a name.
pub(super) fn case(name: &str) -> Option<&'static Case> {
    CASES.iter().find(|case| case.name == name)
}

/// What `--version` says: the version, the forms that can be read, the dialects that can be written.
pub(super) fn version() -> String {
    let mut text = format!("rodete {}\n", env!("CARGO_PKG_VERSION"));
    for form in FORMS {
        text.push_str(&format!("workbook {}: schema {}\n", form.kind, form.schema));
        if let Some(Kind::Choice(choices)) = form.parameter("dialect").map(|parameter| &parameter.kind) {
            let keys: Vec<_> = choices.iter().map(|choice| choice.key).collect();
            text.push_str(&format!("dialects: {}\n", keys.join(", ")));
        }
    }
    text
}
