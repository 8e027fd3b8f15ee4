//! The parameters that forms of programs have in common.

use crate::gcode::chosen::MILLS;
use crate::gcode::control::Post;
use crate::machine::rapids::Rapids;
use crate::parameter::Parameter;
use crate::parameter::field::{Field, Fields, Optional, Required};
use crate::table::Unit;
use crate::text::t;

/// The cell that says which form and version a workbook follows.
pub static SCHEMA: Field<String, Required> = Field::schema();

/// The part's name, for headers and the report: one line of at most 200 characters.
pub static PART: Field<String, Required> = Field::line("part", "part", 200, t("Pieza", "Part"), t("", ""));

/// The material, likewise; empty where it is not said.
pub static MATERIAL: Field<String, Optional> =
    Field::line("material", "material", 200, t("Material", "Material"), t("", ""));

/// The control that programs are written for.
pub static DIALECT: Field<Post, Required> =
    Field::of_list("dialect", "dialect", &MILLS, t("Dialecto del control", "Dialect of the control"), t("", ""));

/// How fast the linear axes are at rapid.
pub static RAPID_LINEAR: Field<f64, Optional> = Field::real(
    "G_lin",
    "rapid_G_lin",
    Unit::MillimetrePerMinute,
    [1.0, 200_000.0],
    t("Avance rápido de los ejes lineales", "Rapid rate of the linear axes"),
    t(
        "El del eje más lento. Vacía: los tiempos no cuentan los rápidos",
        "That of the slowest axis. Empty: the times do not count rapids",
    ),
);

/// How fast the rotary axes are at rapid.
pub static RAPID_ROTARY: Field<f64, Optional> = Field::real(
    "G_rot",
    "rapid_G_rot",
    Unit::DegreePerMinute,
    [1.0, 1_000_000.0],
    t("Avance rápido de los ejes giratorios", "Rapid rate of the rotary axes"),
    t(
        "El del eje más lento. 10 rpm son 3600 °/min. Vacía: los tiempos no cuentan los rápidos",
        "That of the slowest axis. 10 rpm are 3600 °/min. Empty: the times do not count rapids",
    ),
);

/// How long a change of the tool takes.
pub static TOOL_CHANGE: Field<f64, Optional> = Field::real(
    "t_T",
    "tool_change_t_T",
    Unit::Second,
    [0.0, 600.0],
    t("Cambio de herramienta", "Change of the tool"),
    t("De viruta a viruta. Vacía: no se cuenta", "Chip to chip. Empty: not counted"),
);

/// The rates of rapid motions, as forms of programs ask for them.
pub const RAPIDS: &[&Parameter] = &[&RAPID_LINEAR.row, &RAPID_ROTARY.row];

/// How fast the machine is where it does not cut, as a form says that asks for all of it.
#[must_use]
pub fn rapids(fields: &Fields) -> Rapids {
    Rapids { linear: fields.get(&RAPID_LINEAR), rotary: fields.get(&RAPID_ROTARY), tool_change: None }
}
