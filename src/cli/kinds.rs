//! The workbook kinds that the commands know.

use crate::kinds::impeller;
use crate::kinds::lathe;
use crate::kinds::pipe;
use crate::parameter::{Case, FieldKind, Form};

/// Every form, the usual one first.
pub(super) static FORMS: [&Form; 4] = [
    &impeller::parameters::FORM,
    &pipe::insert::parameters::FORM,
    &pipe::hole::parameters::FORM,
    &lathe::parameters::FORM,
];

/// The kinds' names.
pub(super) fn names() -> Vec<&'static str> {
    FORMS.iter().map(|form| form.kind).collect()
}

/// The names of the cases that new workbooks can start from, of all kinds.
pub(super) fn cases() -> Vec<&'static str> {
    FORMS.iter().flat_map(|form| form.cases).map(|case| case.name).collect()
}

/// The case of a kind with a name, or its usual one; `None` where it has none of that name.
pub(super) fn case(form: &Form, name: Option<&str>) -> Option<&'static Case> {
    match name {
        None => form.cases.first(),
        Some(name) => form.cases.iter().find(|case| case.name == name),
    }
}

/// What `--version` says: the version, the forms that can be read, the dialects that can be written.
pub(super) fn version() -> String {
    let mut text = format!("rodete {}\n", env!("CARGO_PKG_VERSION"));
    for form in FORMS {
        text.push_str(&format!("workbook {}: schema {}\n", form.kind, form.schema));
        if let Some(FieldKind::Choice(choices)) = form.parameter("dialect").map(|parameter| &parameter.kind) {
            let keys: Vec<_> = choices.iter().map(|choice| choice.key).collect();
            text.push_str(&format!("dialects: {}\n", keys.join(", ")));
        }
    }
    text
}
