//! The parameters that forms of programs have in common.

use crate::gcode::control::Written;
use crate::parameter::DIALECTS;
use crate::parameter::field::{Field, Optional, Required};
use crate::text::t;

/// The cell that says which form and version a workbook follows.
pub static SCHEMA: Field<String, Required> = Field::schema();

/// The part.
pub static PART: Field<String, Required> = Field::line("part", "part", 200, t("Pieza", "Part"), t("", ""));

/// The material.
pub static MATERIAL: Field<String, Optional> =
    Field::line("material", "material", 200, t("Material", "Material"), t("", ""));

/// The control that programs are written for.
pub static DIALECT: Field<Written, Required> =
    Field::of_list("dialect", "dialect", DIALECTS, t("Dialecto del control", "Dialect of the control"), t("", ""));
