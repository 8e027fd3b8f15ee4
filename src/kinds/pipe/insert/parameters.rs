//! The form of the pipe-insert workbook: every parameter with its meaning, unit, limits and note.
//!
//! Source: the inputs of the published program (its figure 13): radii, wall, angle, eccentricity, divisions; what a
//! machine needs beside them is added here. The published form asks for an inside and an outside radius; this one asks for
//! what is stamped on a pipe, and keeps the radii as an override.

use crate::kinds::pipe::form::{
    BLOCK_STEP, DIALECT, E, END_CODES, MATERIAL, NUMBER, PAPER, PART, PIERCE_DELAY, PIPES, THETA, TORCH_OFF, TORCH_ON,
};
use crate::kinds::pipe::insert::cases::CASES;
use crate::parameter::{Choice, FieldKind, Form, Parameter, Section, Sheet, other, real, t, whole};
use crate::table::Unit;

/// Name and version of the form.
pub const SCHEMA: &str = "rodete-pipe-insert 1";

const MM: Unit = Unit::Millimetre;
const CONTACT: &[Choice] = &[
    Choice { key: "inside", label: t("interior", "inside") },
    Choice { key: "outside", label: t("exterior", "outside") },
];
const SHEETS: &[Choice] = &[
    Choice { key: "outside", label: t("exterior", "outside") },
    Choice { key: "mean", label: t("media", "mean") },
    Choice { key: "inside", label: t("interior", "inside") },
];
const MODES: &[Choice] =
    &[Choice { key: "flat", label: t("plano", "flat") }, Choice { key: "rotary", label: t("giratorio", "rotary") }];
const STYLES: &[Choice] =
    &[Choice { key: "annex", label: t("annex", "annex") }, Choice { key: "full", label: t("full", "full") }];

const JOINT: &[Parameter] = &[
    other(
        "contact",
        "contact",
        FieldKind::Choice(CONTACT),
        true,
        t("Curva del injerto que apoya en el tubo base", "Curve of the branch that rests on the header"),
        t("interior o exterior", "inside or outside"),
    ),
    THETA,
    E,
    real(
        "Z",
        "offset_Z",
        MM,
        [0.0, 10_000.0],
        true,
        t("Z, del borde de la plantilla a la curva en φ = 0", "Z, from the template's edge to the curve at φ = 0"),
        t("Publicado: 20", "Published: 20"),
    ),
    whole(
        "N",
        "divisions_N",
        Unit::Count,
        [3, 10_000],
        true,
        t("Número de divisiones de la circunferencia", "Number of divisions of the circumference"),
        t("Par: arcos por ternas; impar: acaba en recta", "Even: arcs through triples; odd: ends in a line"),
    ),
    real(
        "r",
        "expert_branch_r",
        MM,
        [1.0, 1500.0],
        false,
        t("Experto: r, radio de la curva del injerto", "Expert: r, radius of the branch's curve"),
        t("Sustituye al que sale de D, t y contacto", "In place of that from D, t and contact"),
    ),
    real(
        "R",
        "expert_header_R",
        MM,
        [1.0, 1500.0],
        false,
        t("Experto: R, radio del tubo base", "Expert: R, radius of the header"),
        t("Sustituye a D/2", "In place of D/2"),
    ),
    real(
        "r_dev",
        "expert_sheet_r_dev",
        MM,
        [1.0, 1700.0],
        false,
        t("Experto: radio del desarrollo", "Expert: radius of the development"),
        t("Sustituye al que sale de la chapa", "In place of that from the sheet"),
    ),
];

const CUTTING: &[Parameter] = &[
    other(
        "mode",
        "mode",
        FieldKind::Choice(MODES),
        true,
        t("Máquina: chapa plana (X, Y) o tubo que gira (A, X)", "Machine: flat sheet (X, Y) or turning pipe (A, X)"),
        t("plano o giratorio", "flat or rotary"),
    ),
    other(
        "sheet",
        "sheet",
        FieldKind::Choice(SHEETS),
        true,
        t("Superficie del desarrollo", "Surface of the development"),
        t("exterior: plantilla que envuelve el tubo", "outside: a template wrapped round the pipe"),
    ),
    real(
        "kerf",
        "kerf",
        MM,
        [0.0, 20.0],
        true,
        t("Ancho del corte", "Kerf"),
        t("0: sin compensar", "0: not compensated"),
    ),
    real(
        "F",
        "feed_F",
        Unit::MillimetrePerMinute,
        [1.0, 50_000.0],
        false,
        t("Velocidad de corte", "Cutting speed"),
        t("Obligatorio con style = full", "Required with style = full"),
    ),
    PIERCE_DELAY,
    real(
        "lead_in",
        "lead_in",
        MM,
        [0.0, 200.0],
        true,
        t("Entrada, de la perforación a la curva", "Lead-in, from the pierce to the curve"),
        t("Por el lado del sobrante", "On the side of the waste"),
    ),
    real(
        "overcut",
        "overcut",
        MM,
        [0.0, 200.0],
        true,
        t("Salida más allá del final de la curva", "Overcut beyond the end of the curve"),
        t("En el tubo, sobre el principio del corte", "On the pipe, over the beginning of the cut"),
    ),
    real(
        "arc_tolerance",
        "arc_tolerance",
        MM,
        [0.004, 5.0],
        true,
        t("Tolerancia de la trayectoria a la curva exacta", "Tolerance of the path against the exact curve"),
        t("giratorio: fija los tramos; plano: se comprueba", "rotary: sets the moves; flat: is checked"),
    ),
];

const PROGRAM: &[Parameter] = &[
    PAPER,
    PART,
    MATERIAL,
    NUMBER,
    DIALECT,
    other(
        "style",
        "style",
        FieldKind::Choice(STYLES),
        true,
        t("Estilo del programa", "Style of the program"),
        t("annex: como el publicado; full: completo", "annex: as published; full: complete"),
    ),
    TORCH_ON,
    TORCH_OFF,
    END_CODES,
    BLOCK_STEP,
];

/// The pipe-insert workbook.
pub static FORM: Form = Form {
    kind: "pipe-insert",
    schema: SCHEMA,
    earlier: &[],
    cases: &CASES,
    programs: &["insert"],
    drawings: &["template"],
    solids: &[],
    sheets: &[Sheet {
        name: t("DATOS", "DATA"),
        title: t("Injerto de tubo: parámetros", "Branch pipe: parameters"),
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
            Section { title: t("Corte", "Cut"), parameters: CUTTING },
            Section { title: t("Programa", "Program"), parameters: PROGRAM },
        ],
    }],
    lists: &[],
};
