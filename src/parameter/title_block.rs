//! The title block: who a part is for and who answers for its drawing. One section of every form, every cell optional.
//!
//! Nothing is computed from it. The date is what the user writes: no clock is asked.

use super::field::{Field, Optional};
use super::{FieldKind, Parameter, Section};
use crate::text::{Text, t};

/// Most characters of a name, so that it stays on its line of the block.
const NAME: usize = 60;

const NONE: Text = t("", "");

/// Who the part is for.
pub static CUSTOMER: Field<String, Optional> =
    Field::line("customer", "title_customer", NAME, t("Cliente", "Customer"), NONE);
/// The number of the drawing.
pub static DRAWING: Field<String, Optional> =
    Field::line("drawing", "title_drawing", NAME, t("Número de plano", "Drawing number"), NONE);
/// The revision of that drawing, as text.
pub static REVISION: Field<String, Optional> =
    Field::line("revision", "title_revision", 20, t("Revisión", "Revision"), NONE);
/// The date of the report.
pub static DATE: Field<String, Optional> = Field::other(
    "date",
    "title_date",
    FieldKind::Date,
    t("Fecha del informe", "Date of the report"),
    t("Como deba imprimirse; vacía: sin fecha", "As it is to be printed; empty: no date"),
);
/// Who made it.
pub static AUTHOR: Field<String, Optional> = Field::line("author", "title_author", NAME, t("Autor", "Author"), NONE);
/// Who checked it.
pub static CHECKER: Field<String, Optional> =
    Field::line("checker", "title_checker", NAME, t("Revisado por", "Checked by"), NONE);
/// The picture of the office.
pub static LOGO: Field<String, Optional> = Field::line(
    "logo",
    "title_logo",
    200,
    t("Archivo del logotipo", "File of the logo"),
    t(
        "SVG, PNG o JPEG junto a este libro o en una carpeta de dentro, como logo.svg; vacía: ninguno",
        "SVG, PNG or JPEG beside this workbook or in a folder below it, such as logo.svg; empty: none",
    ),
);

/// The parameters of the title block, in their order.
pub const PARAMETERS: &[&Parameter] =
    &[&CUSTOMER.row, &DRAWING.row, &REVISION.row, &DATE.row, &AUTHOR.row, &CHECKER.row, &LOGO.row];

/// The section that a form ends its first sheet with.
pub const SECTION: Section =
    Section { title: t("Cajetín del informe", "Title block of the report"), parameters: PARAMETERS, optional: true };

/// True for a parameter of the title block.
#[must_use]
pub fn holds(parameter: &Parameter) -> bool {
    PARAMETERS.iter().any(|own| std::ptr::eq(*own, parameter))
}
