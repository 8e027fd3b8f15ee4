//! Pages of the manual that are written from the code: the parameters of every form, the exit codes.

use std::fmt::Write;

use super::markdown::{headed, plain, write_head};
use crate::cli::verdict::{ENDS, code, meaning, status};
use crate::kind::Kind;
use crate::parameter::list::{List, Naming};
use crate::parameter::{Parameter, Value};
use crate::text::{Language, t};
use crate::workbook::error::WriteError;
use crate::workbook::template::layouts;
use crate::workbook::validation::range_and_note;

/// Every parameter of every form: symbol, cell, meaning, unit, limits, whether it may stay empty, and its value in a new
/// workbook.
///
/// # Errors
/// For a form that a workbook cannot hold.
pub fn parameters(kinds: &[&dyn Kind], language: Language) -> Result<String, WriteError> {
    let mut page = headed(
        &t("Parámetros de cada formulario", "The parameters of every form"),
        &t(
            "Cada parámetro con su celda, unidad y límites (ambos incluidos), y su valor en un libro nuevo. Una celda obligatoria que queda vacía se rechaza. La celda es la de un libro nuevo; `rodete` busca cada parámetro por su símbolo. Esta página es la salida de `rodete explain --parameters --lang es`.",
            "Each parameter with its cell, unit and limits (both included), and its value in a new workbook. rodete rejects a form with an empty required cell. The cell is that of a new workbook; `rodete` finds each parameter by its symbol. This page is the output of `rodete explain --parameters --lang en`.",
        ),
        language,
    );
    for kind in kinds {
        write_form(&mut page, *kind, language)?;
    }
    Ok(page)
}

/// The exit codes, with what has been written when a command ends so.
#[must_use]
pub fn exit_codes(language: Language) -> String {
    let mut page = headed(
        &t("Códigos de salida", "Exit codes"),
        &t(
            "Cómo termina cada comando, para quien lo llama desde un programa. El nombre es el de la clave `status` en JSON. Esta página es la salida de `rodete explain --exit-codes --lang es`.",
            "How every command ends, for programs that call it. The name is that of the key `status` in JSON. This page is the output of `rodete explain --exit-codes --lang en`.",
        ),
        language,
    );
    let heads = [t("código", "code"), t("nombre", "name"), t("significado", "meaning"), t("escrito", "written")];
    write_head(&mut page, "|---:|---|---|---|", &heads.each_ref().map(|head| head.get(language)));
    for exit in ENDS {
        let [meaning, written] = meaning(exit).map(|text| text.get(language).to_owned());
        let _ = writeln!(page, "| {} | `{}` | {meaning} | {written} |", code(exit), status(exit));
    }
    let several = t(
        "Con varios libros cuenta el más grave: 2 antes que 1, 5, 7, 4, 3 y 6.",
        "With several workbooks the gravest counts: 2 before 1, 5, 7, 4, 3 and 6.",
    );
    let _ = write!(page, "\n{}\n", several.get(language));
    page
}

fn write_form(page: &mut String, kind: &dyn Kind, language: Language) -> Result<(), WriteError> {
    let (form, cases) = (kind.form(), kind.cases());
    let _ = write!(page, "\n## {}\n\n{}: `{}`.", form.kind, t("Esquema", "Schema").get(language), form.schema);
    let _ = writeln!(
        page,
        " {}:\n",
        t("Casos de los que parte un libro nuevo", "Cases that a new workbook starts from").get(language)
    );
    for (at, case) in cases.iter().enumerate() {
        let command = if at == 0 {
            format!("rodete new {}", form.kind)
        } else {
            format!("rodete new {} --case {}", form.kind, case.name)
        };
        let _ = writeln!(page, "- `{}` (`{command}`): {}", case.name, plain(case.note.get(language)));
    }
    let note = cases.first().map_or(t("", ""), |case| case.note.clone());
    let values = cases.first().map(|case| case.values(language)).unwrap_or_default();
    let heads = [
        t("símbolo", "symbol"),
        t("celda", "cell"),
        t("significado", "meaning"),
        t("unidad", "unit"),
        t("se admite", "allowed"),
        t("obligatoria", "required"),
        t("libro nuevo", "new workbook"),
    ];
    for (sheet, layout) in form.sheets.iter().zip(layouts(form, &note, language)?) {
        write_sheet_name(page, sheet.name.get(language), sheet.optional, language);
        for section in sheet.sections {
            let _ = write!(page, "\n**{}**\n", plain(section.title.get(language)));
            write_head(page, "|---|---|---|---|---|---|---|", &heads.each_ref().map(|head| head.get(language)));
            for parameter in section.parameters {
                let row = layout.names.iter().find(|(name, _)| *name == parameter.name).map_or(0, |(_, row)| row + 1);
                let value = values.iter().find(|(key, _)| *key == parameter.key).map(|(_, value)| value);
                let _ = writeln!(
                    page,
                    "| {} | C{row} | {} | {} | {} | {} | {} |",
                    symbol(parameter),
                    plain(parameter.meaning.get(language)),
                    parameter.unit.label(),
                    admitted(parameter, language),
                    required(parameter, language),
                    value.map(|value| shown(parameter, value, language)).unwrap_or_default(),
                );
            }
        }
    }
    for list in form.lists {
        write_list(page, list, language);
    }
    Ok(())
}

fn write_sheet_name(page: &mut String, name: &str, optional: bool, language: Language) {
    let optional = if optional { t(" (puede faltar)", " (may be missing)") } else { t("", "") };
    let _ = write!(page, "\n### {} {}{}\n", t("Hoja", "Sheet").get(language), plain(name), optional.get(language));
}

fn write_list(page: &mut String, list: &'static List, language: Language) {
    match &list.naming {
        Naming::One(name) | Naming::Numbered(name) => {
            write_sheet_name(page, name.get(language), list.optional, language);
        }
    }
    let rows = t("filas como máximo", "rows at most");
    let _ = write!(page, "\n{} {} {}.\n", plain(list.note.get(language)), list.most, rows.get(language));
    let heads = [
        t("columna", "column"),
        t("significado", "meaning"),
        t("unidad", "unit"),
        t("se admite", "allowed"),
        t("obligatoria", "required"),
    ];
    write_head(page, "|---|---|---|---|---|", &heads.each_ref().map(|head| head.get(language)));
    for column in list.columns {
        let _ = writeln!(
            page,
            "| {} | {} | {} | {} | {} |",
            symbol(column),
            plain(column.meaning.get(language)),
            column.unit.label(),
            admitted(column, language),
            required(column, language),
        );
    }
}

fn symbol(parameter: &Parameter) -> String {
    format!("`{}`", parameter.symbol())
}

/// Limits and note.
fn admitted(parameter: &Parameter, language: Language) -> String {
    plain(&range_and_note(parameter, language))
}

fn required(parameter: &Parameter, language: Language) -> String {
    if parameter.required { t("sí", "yes") } else { t("no", "no") }.get(language).to_owned()
}

fn shown(parameter: &Parameter, value: &Value, language: Language) -> String {
    match value {
        Value::Real(value) => value.to_string(),
        Value::Whole(value) => value.to_string(),
        Value::Choice(key) => plain(parameter.label(key, language)),
        Value::Line(line) => plain(line),
    }
}
