//! A new workbook: the form of a workbook kind, ready to be filled in.

use std::io::{Seek, Write};

use rust_xlsxwriter::Workbook;

use super::drawn::Drawn;
use super::error::WriteError;
use super::form_sheet::{Filling, Layout};
use super::guard::Guard;
use super::list_sheet::ListSheet;
use super::live_form::{self, LivePart};
use super::names::{Made, Present, Role, SheetNames};
use super::page::{Page, SheetStyle, properties};
use super::save::{Additions, save};
use super::style::Styles;
use super::sweep_sheet;
use crate::kind::Kind;
use crate::parameter::list::{List, Naming, Rows};
use crate::parameter::{Cell, Form, Sheet, Value, Values};
use crate::text::{Language, Text, t};

/// How the sheets are filled in; stands under the title of every form.
pub(super) static HOW: Text = t(
    "Escriba solo en las celdas amarillas de la columna C; al seleccionar una se ve qué admite. Los signos + y − del margen izquierdo abren y pliegan los grupos; un grupo opcional que está vacío viene plegado.",
    "Write only in the yellow cells of column C; selecting one shows what it admits. The signs + and − at the left edge open and fold the groups; an optional group that is empty comes folded.",
);

/// What stands under the title of a sheet that may be left out.
pub(super) static OPTIONAL: Text = t(
    "Esta hoja es opcional: si todos sus valores quedan vacíos, no se calcula nada con ella.",
    "This sheet is optional: if all its values stay empty, nothing is computed from it.",
);

/// Writes a new workbook with one sheet for each sheet and each list of the kind's form. `values` are by key, parameters
/// without one stay empty; `lists` are the rows of its lists; `note` says where the values come from. The same input gives the same bytes.
///
/// # Errors
/// For a value that is not finite, for a form that a workbook cannot hold, and for what `out` refuses.
pub fn write<W: Write + Seek + Send>(
    kind: &dyn Kind,
    values: &[Cell],
    lists: &[Rows],
    note: &Text,
    language: Language,
    out: W,
) -> Result<(), WriteError> {
    write_all(kind, (values, lists, None), note, language, &Present::default(), out).map(|_| ())
}

/// The same with a sheet of variants, filled in with what `variants` holds.
///
/// # Errors
/// As [`write()`].
pub fn write_with_variants<W: Write + Seek + Send>(
    kind: &dyn Kind,
    (values, lists): (&[Cell], &[Rows]),
    variants: &Values,
    note: &Text,
    language: Language,
    out: W,
) -> Result<(), WriteError> {
    write_all(kind, (values, lists, Some(variants)), note, language, &Present::default(), out).map(|_| ())
}

/// The same for sheets that are put into a workbook: a form's sheet whose name is taken there gets another. Gives the sheets that
/// were written.
///
/// # Errors
/// As [`write()`].
pub fn write_into<W: Write + Seek + Send>(
    kind: &dyn Kind,
    values: TemplateValues<'_>,
    note: &Text,
    language: Language,
    present: &Present,
    out: W,
) -> Result<Vec<Made>, WriteError> {
    write_all(kind, values, note, language, present, out)
}

/// The sheet of variants alone, for a workbook that has the form. Gives the sheet that was written.
///
/// # Errors
/// As [`write()`].
pub fn write_variants_into<W: Write + Seek + Send>(
    kind: &dyn Kind,
    variants: &Values,
    language: Language,
    out: W,
) -> Result<Vec<Made>, WriteError> {
    let styles = Styles::default();
    let page = Page { part: "", origin: kind.form().schema, repeat: (0, 0), landscape: false, single: false };
    let mut workbook = Workbook::new();
    let made = sweep_sheet::write(&mut workbook, variants, &SheetStyle { styles: &styles, page: &page, language })?;
    save(&mut workbook, Additions::default(), out)?;
    Ok(made.into_iter().collect())
}

/// The values of a workbook: those by key, the rows of its lists, and its sheet of variants.
pub type TemplateValues<'a> = (&'a [Cell], &'a [Rows], Option<&'a Values>);

fn write_all<W: Write + Seek + Send>(
    kind: &dyn Kind,
    (values, lists, variants): TemplateValues<'_>,
    note: &Text,
    language: Language,
    present: &Present,
    out: W,
) -> Result<Vec<Made>, WriteError> {
    let (mut names, mut made) = (SheetNames::beside(present), Vec::new());
    let form = kind.form();
    let find = |key: &str| values.iter().find(|(one, _)| *one == key).map(|(_, value)| value);
    let part = match find(form.part.row.key) {
        Some(Value::Line(part)) => part.as_str(),
        _ => "",
    };
    let styles = Styles::default();
    let page = Page { part, origin: form.schema, repeat: (0, 0), landscape: false, single: false };
    let mut workbook = Workbook::new();
    if let Some(first) = form.sheets.first() {
        workbook.set_properties(&properties(first.title.get(language))?);
    }
    let sketch = kind.sketch();
    let drawn = sketch.as_ref().map(|figure| Drawn { figure, language });
    // In a workbook of one's own there may be names that are the same, and other things beside the inputs.
    let live = kind.live().filter(|_| present.taken.is_empty());
    let charts = live.iter().map(|form| live_form::size(&form.view)).collect();
    let additions = Additions { drawn, uncomputed: live.is_some(), charts, ..Additions::default() };
    for (index, sheet) in form.sheets.iter().enumerate() {
        let (notes, sketch) = (notes(sheet, note, language), drawn.filter(|_| index == 0));
        let worksheet = workbook.add_worksheet();
        let live = live.as_ref().filter(|_| index == 0);
        let layout = Filling { sheet, values: find, notes: &notes, guard: None, live, sketch, language }
            .write(worksheet, &styles)?;
        let name = names.take(sheet.name.get(language));
        worksheet.set_name(&name)?;
        layout.finish(worksheet, &page, language)?;
        for (defined, cell) in layout.defined_names(&name) {
            workbook.define_name(defined, &cell)?;
        }
        for (defined, cell) in &layout.live {
            workbook.define_name(defined, cell)?;
        }
        made.push(Made { name, role: Role::Form });
    }
    let look = SheetStyle { styles: &styles, page: &page, language };
    write_lists(&mut workbook, form, lists, &look, None, |name, _| {
        made.push(Made { name: name.to_owned(), role: Role::Form });
        name.to_owned()
    })?;
    if let Some(variants) = variants {
        made.extend(sweep_sheet::write(&mut workbook, variants, &look)?);
    }
    if let (Some(live), Some(sheet)) = (&live, form.sheets.first()) {
        LivePart { form: live, sheet, column: 0, language }.write_hidden(&mut workbook, form)?;
    }
    save(&mut workbook, additions, out)?;
    Ok(made)
}

/// What stands under the title of a sheet.
fn notes<'a>(sheet: &Sheet, note: &'a Text, language: Language) -> [&'a str; 2] {
    [if sheet.optional { &OPTIONAL } else { note }.get(language), HOW.get(language)]
}

/// Where the cells of a new workbook's sheets stand, in the order of the form; `note` as in [`write()`].
///
/// # Errors
/// For a form that a workbook cannot hold.
pub fn layouts(form: &'static Form, note: &Text, language: Language) -> Result<Vec<Layout>, WriteError> {
    let (mut workbook, styles) = (Workbook::new(), Styles::default());
    let layout = |sheet| {
        let notes = notes(sheet, note, language);
        let filling =
            Filling { sheet, values: |_: &str| None, notes: &notes, guard: None, live: None, sketch: None, language };
        filling.write(workbook.add_worksheet(), &styles)
    };
    form.sheets.iter().map(layout).collect()
}

/// Writes the sheets of a form's lists, watched by a guard where there is one; `take` gives a sheet the name nearest to the one wanted that is free.
///
/// # Errors
/// For a value that is not finite, and for a list that a workbook cannot hold.
pub(super) fn write_lists(
    workbook: &mut Workbook,
    form: &'static Form,
    lists: &[Rows],
    look: &SheetStyle<'_>,
    mut guard: Option<&mut Guard>,
    mut take: impl FnMut(&str, &List) -> String,
) -> Result<(), WriteError> {
    let SheetStyle { styles, page, language } = *look;
    for list in form.lists {
        let filled: Vec<&Rows> = lists.iter().filter(|rows| rows.list == list.key).collect();
        match &list.naming {
            Naming::One(name) => {
                let name = take(name.get(language), list);
                let rows = filled.first().map_or(&[][..], |rows| &rows.rows);
                let sheet = ListSheet { list, name: &name, rows, language };
                sheet.write(workbook.add_worksheet(), styles, page, guard.as_deref_mut())?;
            }
            Naming::Numbered(_) => {
                for rows in filled {
                    let name = take(&rows.sheet, list);
                    let sheet = ListSheet { list, name: &name, rows: &rows.rows, language };
                    sheet.write(workbook.add_worksheet(), styles, page, guard.as_deref_mut())?;
                }
            }
        }
    }
    Ok(())
}
