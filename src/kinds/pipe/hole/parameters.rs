//! The form of the pipe-hole workbook: every parameter with its meaning, unit, limits and note.
//!
//! Source: the parameters of the patent, in its symbols: R_o and R_i from the header's size, the groove angle γ, the gap b,
//! the land h, the torch's r_g, R_g, Ψ and m, the heights d₀ and g₀; what a machine needs beside them is added here.

use crate::gcode::chosen::Codes;
use crate::gcode::fields;
use crate::kinds::pipe::form::{
    BLOCK_STEP, DIALECT, E, END_CODES, MATERIAL, NUMBER, PAPER, PART, PIERCE_DELAY, PIPES, THETA, TORCH_OFF, TORCH_ON,
};
use crate::parameter::field::{Field, Optional, Required};
use crate::parameter::{FieldKind, Form, Parameter, Section, Sheet, title_block};
use crate::table::Unit;
use crate::text::t;

/// Name and version of the form.
pub const SCHEMA: &str = "rodete-pipe-hole 1";

const MM: Unit = Unit::Millimetre;

pub(super) static GAMMA: Field<f64, Required> = Field::real(
    "gamma",
    "groove_gamma",
    Unit::Degree,
    [0.0, 80.0],
    t("Ángulo del bisel γ", "Groove angle γ"),
    t("0: paralelo a la pared del injerto", "0: parallel to the branch wall"),
);
pub(super) static B: Field<f64, Required> = Field::real(
    "b",
    "root_gap_b",
    MM,
    [0.0, 50.0],
    t("Holgura en la raíz b", "Root gap b"),
    t("Entre el injerto y el agujero", "Between branch and hole"),
);
pub(super) static H: Field<f64, Required> = Field::real(
    "h",
    "land_h",
    MM,
    [0.0, 100.0],
    t("Talón h", "Land h"),
    t("Sobre la pared interior; menor que la pared", "Above the bore; less than the wall"),
);
pub(super) static N: Field<u32, Required> = Field::whole(
    "N",
    "divisions_N",
    Unit::Count,
    [8, 10_000],
    t("Puntos de las tablas por vuelta", "Points of the tables per turn"),
    t("Los tramos del programa salen de su tolerancia", "The program's moves follow from its tolerance"),
);

const JOINT: &[&Parameter] = &[&THETA.row, &E.row, &GAMMA.row, &B.row, &H.row, &N.row];

pub(super) static NOZZLE_R_G: Field<f64, Required> =
    Field::real("r_g", "nozzle_r_g", MM, [0.5, 100.0], t("Radio de la punta r_g", "Radius of the tip r_g"), t("", ""));
pub(super) static TORCH_BODY_RADIUS: Field<f64, Required> = Field::real(
    "R_g",
    "torch_body_radius",
    MM,
    [0.5, 200.0],
    t("Radio del cuerpo R_g", "Radius of the body R_g"),
    t("Como mínimo r_g", "At least r_g"),
);
pub(super) static PSI: Field<f64, Required> = Field::real(
    "Psi",
    "taper_Psi",
    Unit::Degree,
    [1.0, 89.0],
    t("Semiángulo del cono de la boquilla Ψ", "Half angle of the nozzle taper Ψ"),
    t("", ""),
);
pub(super) static M: Field<f64, Required> = Field::real(
    "m",
    "beam_m",
    MM,
    [0.0, 10.0],
    t("Radio del chorro m", "Radius of the beam m"),
    t("El ancho de corte es 2·m si kerf está vacío", "The kerf is 2·m if kerf is empty"),
);
pub(super) static D0: Field<f64, Required> = Field::real(
    "d0",
    "height_d0",
    MM,
    [0.1, 100.0],
    t("Altura deseada d0, sobre el eje de la antorcha", "Wanted height d0, along the torch axis"),
    t("Mayor que g0", "Larger than g0"),
);
pub(super) static G0: Field<f64, Required> = Field::real(
    "g0",
    "least_gap_g0",
    MM,
    [0.05, 100.0],
    t("Distancia mínima de la antorcha al tubo g0", "Minimum distance from torch to pipe g0"),
    t("Menor que d0", "Less than d0"),
);
pub(super) static D_MAX: Field<f64, Required> = Field::real(
    "D_max",
    "greatest_height_D_max",
    MM,
    [0.1, 500.0],
    t("Altura máxima", "Maximum height"),
    t("Más allá el arco no corta", "Beyond it the arc does not cut"),
);

const TORCH: &[&Parameter] = &[&NOZZLE_R_G.row, &TORCH_BODY_RADIUS.row, &PSI.row, &M.row, &D0.row, &G0.row, &D_MAX.row];

pub(super) static KERF: Field<f64, Optional> =
    Field::real("kerf", "kerf", MM, [0.0, 20.0], t("Ancho de corte", "Kerf"), t("Vacía: 2·m", "Empty: 2·m"));
pub(super) static F: Field<f64, Required> = Field::real(
    "F",
    "feed_F",
    Unit::MillimetrePerMinute,
    [1.0, 50_000.0],
    t("Velocidad de corte en la raíz", "Cutting speed at the root"),
    t("", ""),
);
pub(super) static F_MAX: Field<f64, Optional> = Field::real(
    "F_max",
    "feed_limit_F_max",
    Unit::MillimetrePerMinute,
    [1.0, 200_000.0],
    t("Velocidad máxima de cada eje (°/min en A, B y C)", "Maximum speed of each axis (°/min in A, B and C)"),
    t("Vacía: no se limita", "Empty: not limited"),
);
pub(super) static LEAD_IN: Field<f64, Required> = Field::real(
    "lead_in",
    "lead_in",
    MM,
    [0.0, 200.0],
    t("Entrada, de la perforación a la curva", "Lead-in, from the pierce to the curve"),
    t("Dentro del agujero", "Inside the hole"),
);
pub(super) static OVERCUT: Field<f64, Required> = Field::real(
    "overcut",
    "overcut",
    MM,
    [0.0, 200.0],
    t("Salida sobre el principio del corte", "Overcut past the beginning of the cut"),
    t("", ""),
);
pub(super) static ARC_TOLERANCE: Field<f64, Required> = Field::real(
    "arc_tolerance",
    "arc_tolerance",
    MM,
    [0.01, 5.0],
    t("Tolerancia del chorro a la curva exacta", "Tolerance from the beam to the exact curve"),
    t("Fija los tramos", "Sets the moves"),
);
pub(super) static Z_S: Field<f64, Required> = Field::real(
    "Z_s",
    "retract_Z_s",
    MM,
    [1.0, 1000.0],
    t("Altura de los rápidos sobre el tubo", "Height of rapid moves above the pipe"),
    t("Del tubo a la punta", "From pipe to tip"),
);

const CUTTING: &[&Parameter] =
    &[&KERF.row, &F.row, &F_MAX.row, &PIERCE_DELAY.row, &LEAD_IN.row, &OVERCUT.row, &ARC_TOLERANCE.row, &Z_S.row];

pub(super) static HOLD_ON: Field<Codes, Optional> = Field::other(
    "hold_on",
    "hold_on",
    FieldKind::Codes,
    t("Códigos que bloquean el control de altura", "Codes that hold the height control"),
    t(
        "Vacía: M62 P2 si el control tiene esa salida; si no, ninguno",
        "Empty: M62 P2 where the control has that output; else none",
    ),
);
pub(super) static HOLD_OFF: Field<Codes, Optional> = Field::other(
    "hold_off",
    "hold_off",
    FieldKind::Codes,
    t("Códigos que lo liberan", "Codes that release it"),
    t(
        "Vacía: M63 P2 si el control tiene esa salida; si no, ninguno",
        "Empty: M63 P2 where the control has that output; else none",
    ),
);

const PROGRAM: &[&Parameter] = &[
    &PAPER.row,
    &PART.row,
    &MATERIAL.row,
    &NUMBER.row,
    &DIALECT.row,
    &TORCH_ON.row,
    &TORCH_OFF.row,
    &HOLD_ON.row,
    &HOLD_OFF.row,
    &END_CODES.row,
    &BLOCK_STEP.row,
];

/// The pipe-hole workbook.
pub static FORM: Form = Form {
    kind: "pipe-hole",
    schema: SCHEMA,
    part: &PART,
    material: Some(&MATERIAL),
    programs: &["hole"],
    drawings: &["template"],
    sheets: &[Sheet {
        name: t("DATOS", "DATA"),
        title: t("Agujero biselado en un tubo: parámetros", "Bevelled hole in a pipe: parameters"),
        optional: false,
        sections: &[
            Section { title: t("Esquema", "Schema"), parameters: &[&fields::SCHEMA.row], optional: false },
            Section { title: t("Tubos", "Pipes"), parameters: PIPES, optional: false },
            Section { title: t("Unión", "Joint"), parameters: JOINT, optional: false },
            Section { title: t("Antorcha", "Torch"), parameters: TORCH, optional: false },
            Section { title: t("Corte", "Cut"), parameters: CUTTING, optional: false },
            Section { title: t("Máquina", "Machine"), parameters: fields::RAPIDS, optional: true },
            Section { title: t("Programa", "Program"), parameters: PROGRAM, optional: false },
            title_block::SECTION,
        ],
    }],
    ..Form::PLAIN
};
