//! The form of the pipe-insert workbook: every parameter with its meaning, unit, limits and note.
//!
//! Source: the inputs of the published program (its figure 13): radii, wall, angle, eccentricity, divisions; what a
//! machine needs beside them is added here. The published form asks for an inside and an outside radius; this one asks for
//! what is stamped on a pipe, and keeps the radii as an override.

use crate::gcode::fields;
use crate::gcode::program::Style;
use crate::kinds::pipe::form::{
    BLOCK_STEP, DIALECT, E, END_CODES, MATERIAL, NUMBER, PAPER, PART, PIERCE_DELAY, PIPES, THETA, TORCH_OFF, TORCH_ON,
};
use crate::parameter::field::{Field, Optional, Required, choices};
use crate::parameter::{Form, Parameter, Section, Sheet, title_block};
use crate::table::Unit;
use crate::text::t;

/// Name and version of the form.
pub const SCHEMA: &str = "rodete-pipe-insert 1";

const MM: Unit = Unit::Millimetre;

choices! {
    /// On what the torch cuts.
    pub enum Mode {
        /// A flat sheet: X and Y.
        Flat = "flat" ("plano", "flat"),
        /// The pipe, turning: A and X.
        Rotary = "rotary" ("giratorio", "rotary"),
    }
}

choices! {
    /// What of the branch rests on the header.
    pub enum Contact {
        /// The edge of its bore.
        Inside = "inside" ("interior", "inside"),
        /// The edge of its outside.
        Outside = "outside" ("exterior", "outside"),
        /// The envelope over the wall: at each angle the line of the wall that touches first.
        Envelope = "envelope" ("envolvente", "envelope"),
    }
}

choices! {
    /// The surface of the branch that the template is developed on.
    pub enum Surface {
        /// The outside of the branch.
        Outside = "outside" ("exterior", "outside"),
        /// The middle of its wall.
        Mean = "mean" ("media", "mean"),
        /// Its bore.
        Inside = "inside" ("interior", "inside"),
    }
}

pub(super) static CONTACT: Field<Contact, Required> = Field::choice(
    "contact",
    "contact",
    t("Qué apoya del injerto en el tubo base", "What of the branch rests on the header"),
    t(
        "envolvente: toda la pared; interior o exterior: un borde",
        "envelope: the whole wall; inside or outside: one edge",
    ),
);
pub(super) static Z: Field<f64, Required> = Field::real(
    "Z",
    "offset_Z",
    MM,
    [0.0, 10_000.0],
    t("Z, del borde de la plantilla a la curva en φ = 0", "Z, from the template edge to the curve at φ = 0"),
    t("Publicado: 20", "Published: 20"),
);
/// The greatest N.
pub(super) const MOST_N: u32 = 10_000;
pub(super) static N: Field<u32, Required> = Field::whole(
    "N",
    "divisions_N",
    Unit::Count,
    [3, MOST_N],
    t("Número de divisiones de la circunferencia", "Number of divisions of the circumference"),
    t(
        "Par: arcos de tres en tres puntos; impar: acaba en recta",
        "Even: arcs through three points each; odd: ends in a line",
    ),
);
pub(super) static EXPERT_BRANCH_R: Field<f64, Optional> = Field::real(
    "r",
    "expert_branch_r",
    MM,
    [1.0, 1500.0],
    t("Experto: r, radio de la curva del injerto", "Expert: r, radius of the branch's curve"),
    t(
        "En lugar del que sale de D, t y el contacto. Vacía: el que resulta",
        "Replaces the radius from D, t and contact. Empty: the derived one",
    ),
);
pub(super) static R: Field<f64, Optional> = Field::real(
    "R",
    "expert_header_R",
    MM,
    [1.0, 1500.0],
    t("Experto: R, radio del tubo base", "Expert: R, radius of the header"),
    t("Vacía: D/2", "Empty: D/2"),
);
pub(super) static R_DEV: Field<f64, Optional> = Field::real(
    "r_dev",
    "expert_sheet_r_dev",
    MM,
    [1.0, 1700.0],
    t("Experto: radio del desarrollo", "Expert: radius of the development"),
    t(
        "En lugar del que sale de la superficie del desarrollo. Vacía: el que resulta",
        "Replaces the radius from the surface of the development. Empty: the derived one",
    ),
);

const JOINT: &[&Parameter] =
    &[&CONTACT.row, &THETA.row, &E.row, &Z.row, &N.row, &EXPERT_BRANCH_R.row, &R.row, &R_DEV.row];

pub(super) static MODE: Field<Mode, Required> = Field::choice(
    "mode",
    "mode",
    t("Máquina: chapa plana (X, Y) o tubo que gira (A, X)", "Machine: flat sheet (X, Y) or turning pipe (A, X)"),
    t("plano o giratorio", "flat or rotary"),
);
pub(super) static SHEET: Field<Surface, Required> = Field::choice(
    "sheet",
    "sheet",
    t("Superficie del desarrollo", "Surface of the development"),
    t("exterior: plantilla que envuelve el tubo", "outside: a template wrapped round the pipe"),
);
pub(super) static KERF: Field<f64, Required> = Field::real(
    "kerf",
    "kerf",
    MM,
    [0.0, 20.0],
    t("Ancho de corte", "Kerf"),
    t("0: sin compensación", "0: no compensation"),
);
pub(super) static F: Field<f64, Optional> = Field::real(
    "F",
    "feed_F",
    Unit::MillimetrePerMinute,
    [1.0, 50_000.0],
    t("Velocidad de corte", "Cutting speed"),
    t(
        "Obligatorio con style = completo; con anexo puede quedar vacía",
        "Required with style = full; with annex it may stay empty",
    ),
);
pub(super) static LEAD_IN: Field<f64, Required> = Field::real(
    "lead_in",
    "lead_in",
    MM,
    [0.0, 200.0],
    t("Entrada, de la perforación a la curva", "Lead-in, from the pierce to the curve"),
    t("Por el lado del sobrante", "On the side of the waste"),
);
pub(super) static OVERCUT: Field<f64, Required> = Field::real(
    "overcut",
    "overcut",
    MM,
    [0.0, 200.0],
    t("Salida más allá del final de la curva", "Overcut beyond the end of the curve"),
    t("En el tubo, sobre el principio del corte", "On the pipe, over the beginning of the cut"),
);
pub(super) static ARC_TOLERANCE: Field<f64, Required> = Field::real(
    "arc_tolerance",
    "arc_tolerance",
    MM,
    [0.004, 5.0],
    t("Tolerancia de la trayectoria a la curva exacta", "Tolerance from the path to the exact curve"),
    t("giratorio: fija los tramos; plano: solo se comprueba", "rotary: sets the moves; flat: only checked"),
);

const CUTTING: &[&Parameter] =
    &[&MODE.row, &SHEET.row, &KERF.row, &F.row, &PIERCE_DELAY.row, &LEAD_IN.row, &OVERCUT.row, &ARC_TOLERANCE.row];

pub(super) static STYLE: Field<Style, Required> = Field::choice(
    "style",
    "style",
    t("Estilo del programa", "Style of the program"),
    t(
        "anexo: como el publicado; completo: con avance, antorcha y fin de programa",
        "annex: as published; full: complete",
    ),
);

const PROGRAM: &[&Parameter] = &[
    &PAPER.row,
    &PART.row,
    &MATERIAL.row,
    &NUMBER.row,
    &DIALECT.row,
    &STYLE.row,
    &TORCH_ON.row,
    &TORCH_OFF.row,
    &END_CODES.row,
    &BLOCK_STEP.row,
];

/// The pipe-insert workbook.
pub static FORM: Form = Form {
    kind: "pipe-insert",
    schema: SCHEMA,
    part: &PART,
    material: Some(&MATERIAL),
    programs: &["insert"],
    drawings: &["template"],
    sheets: &[Sheet {
        name: t("DATOS", "DATA"),
        title: t("Injerto de tubo: parámetros", "Branch pipe: parameters"),
        optional: false,
        sections: &[
            Section { title: t("Esquema", "Schema"), parameters: &[&fields::SCHEMA.row], optional: false },
            Section { title: t("Tubos", "Pipes"), parameters: PIPES, optional: false },
            Section { title: t("Unión", "Joint"), parameters: JOINT, optional: false },
            Section { title: t("Corte", "Cut"), parameters: CUTTING, optional: false },
            Section { title: t("Máquina", "Machine"), parameters: fields::RAPIDS, optional: true },
            Section { title: t("Programa", "Program"), parameters: PROGRAM, optional: false },
            title_block::SECTION,
        ],
    }],
    ..Form::PLAIN
};
