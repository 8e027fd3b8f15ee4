//! The form of the pipe-hole workbook: every parameter with its meaning, unit, limits and note.
//!
//! Source: the parameters of the patent, in its symbols: R_o and R_i from the header's size, the groove angle γ, the gap b,
//! the land h, the torch's r_g, R_g, Ψ and m, the heights d₀ and g₀; what a machine needs beside them is added here.

use crate::kinds::pipe::form::{
    BLOCK_STEP, DIALECT, E, END_CODES, MATERIAL, NUMBER, PAPER, PART, PIERCE_DELAY, PIPES, THETA, TORCH_OFF, TORCH_ON,
};
use crate::kinds::pipe::hole::cases::CASES;
use crate::parameter::{FieldKind, Form, Parameter, Section, Sheet, other, real, t, whole};
use crate::table::Unit;

/// Name and version of the form.
pub const SCHEMA: &str = "rodete-pipe-hole 1";

const MM: Unit = Unit::Millimetre;

const JOINT: &[Parameter] = &[
    THETA,
    E,
    real(
        "gamma",
        "groove_gamma",
        Unit::Degree,
        [0.0, 80.0],
        true,
        t("Ángulo del bisel γ", "Groove angle γ"),
        t("0: paralelo a la pared del injerto", "0: along the branch's wall"),
    ),
    real(
        "b",
        "root_gap_b",
        MM,
        [0.0, 50.0],
        true,
        t("Holgura en la raíz b", "Root gap b"),
        t("Entre el injerto y el agujero", "Between branch and hole"),
    ),
    real(
        "h",
        "land_h",
        MM,
        [0.0, 100.0],
        true,
        t("Talón h", "Land h"),
        t("Sobre la pared interior; menor que la pared", "Above the bore; less than the wall"),
    ),
    whole(
        "N",
        "divisions_N",
        Unit::Count,
        [8, 10_000],
        true,
        t("Puntos de las tablas por vuelta", "Points of the tables, once round"),
        t("El programa se parte según su tolerancia", "The program is parted by its tolerance"),
    ),
];

const TORCH: &[Parameter] = &[
    real("r_g", "nozzle_r_g", MM, [0.5, 100.0], true, t("Radio de la punta r_g", "Radius of the tip r_g"), t("", "")),
    real(
        "R_g",
        "torch_body_radius",
        MM,
        [0.5, 200.0],
        true,
        t("Radio del cuerpo R_g", "Radius of the body R_g"),
        t("No menor que r_g", "Not below r_g"),
    ),
    real(
        "Psi",
        "taper_Psi",
        Unit::Degree,
        [1.0, 89.0],
        true,
        t("Semiángulo del cono de la boquilla Ψ", "Half angle of the nozzle's taper Ψ"),
        t("", ""),
    ),
    real(
        "m",
        "beam_m",
        MM,
        [0.0, 10.0],
        true,
        t("Radio del chorro m", "Radius of the beam m"),
        t("El corte es 2·m si kerf está vacío", "The kerf is 2·m where kerf is empty"),
    ),
    real(
        "d0",
        "height_d0",
        MM,
        [0.1, 100.0],
        true,
        t("Altura deseada d0, sobre el eje de la antorcha", "Wanted height d0, along the torch's axis"),
        t("Mayor que g0", "Greater than g0"),
    ),
    real(
        "g0",
        "least_gap_g0",
        MM,
        [0.05, 100.0],
        true,
        t("Distancia mínima de la antorcha al tubo g0", "Least distance from torch to pipe g0"),
        t("Menor que d0", "Less than d0"),
    ),
    real(
        "D_max",
        "greatest_height_D_max",
        MM,
        [0.1, 500.0],
        true,
        t("Altura máxima", "Greatest height"),
        t("Más allá el arco no corta", "Beyond it the arc does not cut"),
    ),
];

const CUTTING: &[Parameter] = &[
    real("kerf", "kerf", MM, [0.0, 20.0], false, t("Ancho del corte", "Kerf"), t("Vacío: 2·m", "Empty: 2·m")),
    real(
        "F",
        "feed_F",
        Unit::MillimetrePerMinute,
        [1.0, 50_000.0],
        true,
        t("Velocidad de corte en la raíz", "Cutting speed at the root"),
        t("", ""),
    ),
    real(
        "F_max",
        "feed_limit_F_max",
        Unit::MillimetrePerMinute,
        [1.0, 200_000.0],
        false,
        t("Velocidad máxima de cada eje (°/min en A, B y C)", "Greatest speed of any axis (°/min in A, B and C)"),
        t("Vacío: no se limita", "Empty: not limited"),
    ),
    PIERCE_DELAY,
    real(
        "lead_in",
        "lead_in",
        MM,
        [0.0, 200.0],
        true,
        t("Entrada, de la perforación a la curva", "Lead-in, from the pierce to the curve"),
        t("Dentro del agujero", "Inside the hole"),
    ),
    real(
        "overcut",
        "overcut",
        MM,
        [0.0, 200.0],
        true,
        t("Salida sobre el principio del corte", "Overcut over the beginning of the cut"),
        t("", ""),
    ),
    real(
        "arc_tolerance",
        "arc_tolerance",
        MM,
        [0.01, 5.0],
        true,
        t("Tolerancia del chorro a la curva exacta", "Tolerance of the beam against the exact curve"),
        t("Fija los tramos", "Sets the moves"),
    ),
    real(
        "Z_s",
        "retract_Z_s",
        MM,
        [1.0, 1000.0],
        true,
        t("Altura de los rápidos sobre el tubo", "Height of rapid moves above the pipe"),
        t("Del tubo a la punta", "From pipe to tip"),
    ),
];

const PROGRAM: &[Parameter] = &[
    PAPER,
    PART,
    MATERIAL,
    NUMBER,
    DIALECT,
    TORCH_ON,
    TORCH_OFF,
    other(
        "hold_on",
        "hold_on",
        FieldKind::Codes,
        false,
        t("Códigos que bloquean el control de altura", "Codes that hold the height control"),
        t("Vacío: en linuxcnc M62 P2; en otro, ninguno", "Empty: M62 P2 in linuxcnc; none in another"),
    ),
    other(
        "hold_off",
        "hold_off",
        FieldKind::Codes,
        false,
        t("Códigos que lo sueltan", "Codes that let it go"),
        t("Vacío: en linuxcnc M63 P2; en otro, ninguno", "Empty: M63 P2 in linuxcnc; none in another"),
    ),
    END_CODES,
    BLOCK_STEP,
];

/// The pipe-hole workbook.
pub static FORM: Form = Form {
    kind: "pipe-hole",
    schema: SCHEMA,
    earlier: &[],
    cases: &CASES,
    programs: &["hole"],
    drawings: &["template"],
    solids: &[],
    sheets: &[Sheet {
        name: t("DATOS", "DATA"),
        title: t("Agujero biselado en un tubo: parámetros", "Bevelled hole in a pipe: parameters"),
        optional: false,
        sections: &[
            Section {
                title: t("Esquema", "Schema"),
                parameters: &[other(
                    "schema",
                    "schema",
                    FieldKind::Schema,
                    true,
                    t("Esquema y versión de este libro", "Schema and version of this workbook"),
                    t("No se cambia", "Not to be changed"),
                )],
            },
            Section { title: t("Tubos", "Pipes"), parameters: PIPES },
            Section { title: t("Unión", "Joint"), parameters: JOINT },
            Section { title: t("Antorcha", "Torch"), parameters: TORCH },
            Section { title: t("Corte", "Cut"), parameters: CUTTING },
            Section { title: t("Programa", "Program"), parameters: PROGRAM },
        ],
    }],
    lists: &[],
};
