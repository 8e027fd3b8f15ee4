//! The parameters that the forms of both pipe workbooks share.

use crate::figure::Paper;
use crate::gcode::chosen::Codes;
pub(in crate::kinds) use crate::gcode::fields::{DIALECT, MATERIAL, PART};
use crate::kinds::pipe::size::{NPS, SCHEDULES, Schedule, Size};
use crate::parameter::field::{Field, Optional, Required, Usual};
use crate::parameter::{FieldKind, Parameter};
use crate::table::Unit;
use crate::text::t;

const MM: Unit = Unit::Millimetre;
const DIAMETER: [f64; 2] = [5.0, 3000.0];
const WALL: [f64; 2] = [0.3, 200.0];

pub(in crate::kinds) static BRANCH_SIZE: Field<&'static Size, Optional> = Field::of_list(
    "branch_size",
    "branch_size",
    NPS,
    t("Tamaño nominal del injerto (NPS)", "Nominal size of the branch (NPS)"),
    t(
        "ASME B36.10, con la cédula; vacía: valen D_branch y t_branch",
        "ASME B36.10, with the schedule; empty: D_branch and t_branch apply",
    ),
);
pub(in crate::kinds) static BRANCH_SCHEDULE: Field<Schedule, Optional> = Field::of_list(
    "branch_schedule",
    "branch_schedule",
    SCHEDULES,
    t("Cédula del injerto", "Schedule of the branch"),
    t("ASME B36.10; vacía si lo está el tamaño nominal", "ASME B36.10; empty if the nominal size is empty"),
);
pub(in crate::kinds) static D_BRANCH: Field<f64, Optional> = Field::real(
    "D_branch",
    "branch_diameter_D",
    MM,
    DIAMETER,
    t("Diámetro exterior del injerto", "Outside diameter of the branch"),
    t("Vacío si se da el tamaño nominal", "Empty if the nominal size is given"),
)
.given_by("branch_size");
pub(in crate::kinds) static T_BRANCH: Field<f64, Optional> = Field::real(
    "t_branch",
    "branch_wall_t",
    MM,
    WALL,
    t("Espesor de pared del injerto", "Wall of the branch"),
    t(
        "Menor que el radio; vacío si se da el tamaño nominal",
        "Less than the radius; empty if the nominal size is given",
    ),
)
.given_by("branch_schedule");
pub(in crate::kinds) static HEADER_SIZE: Field<&'static Size, Optional> = Field::of_list(
    "header_size",
    "header_size",
    NPS,
    t("Tamaño nominal del tubo base (NPS)", "Nominal size of the header (NPS)"),
    t(
        "ASME B36.10, con la cédula; vacía: valen D_header y t_header",
        "ASME B36.10, with the schedule; empty: D_header and t_header count",
    ),
);
pub(in crate::kinds) static HEADER_SCHEDULE: Field<Schedule, Optional> = Field::of_list(
    "header_schedule",
    "header_schedule",
    SCHEDULES,
    t("Cédula del tubo base", "Schedule of the header"),
    t("ASME B36.10; vacía si lo está el tamaño nominal", "ASME B36.10; empty if the nominal size is empty"),
);
pub(in crate::kinds) static D_HEADER: Field<f64, Optional> = Field::real(
    "D_header",
    "header_diameter_D",
    MM,
    DIAMETER,
    t("Diámetro exterior del tubo base", "Outside diameter of the header"),
    t("Vacío si se da el tamaño nominal", "Empty if the nominal size is given"),
)
.given_by("header_size");
pub(in crate::kinds) static T_HEADER: Field<f64, Optional> = Field::real(
    "t_header",
    "header_wall_t",
    MM,
    WALL,
    t("Espesor de pared del tubo base", "Wall of the header"),
    t(
        "Menor que el radio; vacío si se da el tamaño nominal",
        "Less than the radius; empty if the nominal size is given",
    ),
)
.given_by("header_schedule");

/// The sizes of both pipes.
pub(super) const PIPES: &[&Parameter] = &[
    &BRANCH_SIZE.row,
    &BRANCH_SCHEDULE.row,
    &D_BRANCH.row,
    &T_BRANCH.row,
    &HEADER_SIZE.row,
    &HEADER_SCHEDULE.row,
    &D_HEADER.row,
    &T_HEADER.row,
];

/// The angle between the axes.
pub(in crate::kinds) static THETA: Field<f64, Required> = Field::real(
    "theta",
    "angle_theta",
    Unit::Degree,
    [1.0, 179.0],
    t("Ángulo entre los ejes", "Angle between the axes"),
    t("90: perpendicular", "90: square"),
);

/// How far the axes pass each other.
pub(in crate::kinds) static E: Field<f64, Required> = Field::real(
    "e",
    "eccentricity_e",
    MM,
    [-1500.0, 1500.0],
    t("Excentricidad: distancia entre los ejes", "Eccentricity: distance between the axes"),
    t(
        "Visto inclinado a la derecha, e > 0 pasa por delante; no debe sobresalir",
        "Seen leaning to the right, e > 0 passes in front; it must not overhang",
    ),
);

/// How long the torch stands after it pierces, s; 0 for no dwell.
pub(in crate::kinds) static PIERCE_DELAY: Field<f64, Required> = Field::real(
    "pierce_delay",
    "pierce_delay",
    Unit::Second,
    [0.0, 60.0],
    t("Tiempo de espera al perforar", "Pierce delay"),
    t("0: sin espera", "0: none"),
);

pub(in crate::kinds) static NUMBER: Field<u32, Required> = Field::whole(
    "program",
    "program_number",
    Unit::Count,
    [1, 9999],
    t("Número de programa", "Program number"),
    t("En la cabecera del programa", "In the program's header"),
);

pub(in crate::kinds) static TORCH_ON: Field<Codes, Required> = Field::other(
    "torch_on",
    "torch_on",
    FieldKind::Codes,
    t("Códigos que encienden la antorcha", "Codes that turn the torch on"),
    t("Lo usual: M3", "Usual: M3"),
);

pub(in crate::kinds) static TORCH_OFF: Field<Codes, Required> = Field::other(
    "torch_off",
    "torch_off",
    FieldKind::Codes,
    t("Códigos que la apagan", "Codes that turn it off"),
    t("Lo usual: M5", "Usual: M5"),
);

pub(in crate::kinds) static END_CODES: Field<Codes, Required> = Field::other(
    "end_codes",
    "end_codes",
    FieldKind::Codes,
    t("Códigos al terminar", "Codes at the end"),
    t("Lo usual: M30", "Usual: M30"),
);

pub(in crate::kinds) static BLOCK_STEP: Field<u32, Required> = Field::whole(
    "block_step",
    "block_step",
    Unit::Count,
    [1, 1000],
    t("Paso de la numeración de bloques", "Step of the block numbers"),
    t("Lo usual: 10", "Usual: 10"),
);

/// The paper that templates are printed on.
pub(in crate::kinds) static PAPER: Field<Paper, Usual> = Field::choice_or(
    Paper::A4,
    "paper",
    "paper",
    t("Papel de la plantilla a tamaño real", "Paper of the template at full size"),
    t("Vacía: A4", "Empty: A4"),
);
