//! The form of the pipe-insert workbook: every parameter with its meaning, unit, limits and note.
//!
//! Source: the inputs of the published program (its figure 13): radii, wall, angle, eccentricity, divisions; what a
//! machine needs beside them is added here. The published form asks for an inside and an outside radius; this one asks for
//! what is stamped on a pipe, and keeps the radii as an override.

use crate::figure::PAPERS;
use crate::parameter::{Choice, DIALECTS, Form, Kind, Parameter, Section, Sheet, other, real, t, whole};
use crate::pipe::insert::cases::CASES;
use crate::pipe::size::{NPS, SCHEDULES};
use crate::table::Unit;

/// Name and version of the form.
pub const SCHEMA: &str = "rodete-pipe-insert 1";

const MM: Unit = Unit::Millimetre;
const DIAMETER: [f64; 2] = [5.0, 3000.0];
const WALL: [f64; 2] = [0.3, 200.0];

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

/// The sizes of both pipes.
pub(in crate::pipe) const PIPES: &[Parameter] = &[
    other(
        "branch_size",
        "branch_size",
        Kind::Choice(NPS),
        false,
        t("Tamaño nominal del injerto (NPS)", "Nominal size of the branch (NPS)"),
        t("ASME B36.10; con la cédula, en lugar de D y t", "ASME B36.10; with the schedule, in place of D and t"),
    ),
    other(
        "branch_schedule",
        "branch_schedule",
        Kind::Choice(SCHEDULES),
        false,
        t("Cédula del injerto", "Schedule of the branch"),
        t("ASME B36.10", "ASME B36.10"),
    ),
    real(
        "D_branch",
        "branch_diameter_D",
        MM,
        DIAMETER,
        false,
        t("Diámetro exterior del injerto", "Outside diameter of the branch"),
        t("Vacío si se da el tamaño nominal", "Empty where the nominal size is given"),
    ),
    real(
        "t_branch",
        "branch_wall_t",
        MM,
        WALL,
        false,
        t("Espesor de pared del injerto", "Wall of the branch"),
        t("Menor que el radio", "Less than the radius"),
    ),
    other(
        "header_size",
        "header_size",
        Kind::Choice(NPS),
        false,
        t("Tamaño nominal del tubo base (NPS)", "Nominal size of the header (NPS)"),
        t("ASME B36.10; con la cédula, en lugar de D y t", "ASME B36.10; with the schedule, in place of D and t"),
    ),
    other(
        "header_schedule",
        "header_schedule",
        Kind::Choice(SCHEDULES),
        false,
        t("Cédula del tubo base", "Schedule of the header"),
        t("ASME B36.10", "ASME B36.10"),
    ),
    real(
        "D_header",
        "header_diameter_D",
        MM,
        DIAMETER,
        false,
        t("Diámetro exterior del tubo base", "Outside diameter of the header"),
        t("Vacío si se da el tamaño nominal", "Empty where the nominal size is given"),
    ),
    real(
        "t_header",
        "header_wall_t",
        MM,
        WALL,
        false,
        t("Espesor de pared del tubo base", "Wall of the header"),
        t("Menor que el radio", "Less than the radius"),
    ),
];

const JOINT: &[Parameter] = &[
    other(
        "contact",
        "contact",
        Kind::Choice(CONTACT),
        true,
        t("Curva del injerto que apoya en el tubo base", "Curve of the branch that rests on the header"),
        t("interior o exterior", "inside or outside"),
    ),
    real(
        "theta",
        "angle_theta",
        Unit::Degree,
        [1.0, 179.0],
        true,
        t("Ángulo entre los ejes", "Angle between the axes"),
        t("90: perpendicular", "90: square"),
    ),
    real(
        "e",
        "eccentricity_e",
        MM,
        [-1500.0, 1500.0],
        true,
        t("Excentricidad: distancia entre los ejes", "Eccentricity: distance between the axes"),
        t(
            "Visto inclinado a la derecha, e > 0 pasa por delante; no debe sobresalir",
            "Seen leaning to the right, e > 0 passes in front; it must not overhang",
        ),
    ),
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
        Kind::Choice(MODES),
        true,
        t("Máquina: chapa plana (X, Y) o tubo que gira (A, X)", "Machine: flat sheet (X, Y) or turning pipe (A, X)"),
        t("plano o giratorio", "flat or rotary"),
    ),
    other(
        "sheet",
        "sheet",
        Kind::Choice(SHEETS),
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
    real(
        "pierce_delay",
        "pierce_delay",
        Unit::Second,
        [0.0, 60.0],
        true,
        t("Espera al perforar", "Pierce delay"),
        t("0: sin espera", "0: none"),
    ),
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

/// The paper that templates are printed on.
pub(in crate::pipe) const PAPER: Parameter = other(
    "paper",
    "paper",
    Kind::Choice(PAPERS),
    false,
    t("Papel de la plantilla a tamaño natural", "Paper of the template at full size"),
    t("Vacío: A4", "Empty: A4"),
);

const PROGRAM: &[Parameter] = &[
    PAPER,
    other("part", "part", Kind::Line { max: 200 }, true, t("Pieza", "Part"), t("", "")),
    other("material", "material", Kind::Line { max: 200 }, false, t("Material", "Material"), t("", "")),
    whole(
        "program",
        "program_number",
        Unit::Count,
        [1, 9999],
        true,
        t("Número de programa", "Program number"),
        t("En la cabecera del programa", "In the program's header"),
    ),
    other(
        "dialect",
        "dialect",
        Kind::Choice(DIALECTS),
        true,
        t("Dialecto del control", "Dialect of the control"),
        t("", ""),
    ),
    other(
        "style",
        "style",
        Kind::Choice(STYLES),
        true,
        t("Estilo del programa", "Style of the program"),
        t("annex: como el publicado; full: completo", "annex: as published; full: complete"),
    ),
    other(
        "torch_on",
        "torch_on",
        Kind::Codes,
        true,
        t("Códigos que encienden la antorcha", "Codes that turn the torch on"),
        t("Lo usual: M3", "Usual: M3"),
    ),
    other(
        "torch_off",
        "torch_off",
        Kind::Codes,
        true,
        t("Códigos que la apagan", "Codes that turn it off"),
        t("Lo usual: M5", "Usual: M5"),
    ),
    other(
        "end_codes",
        "end_codes",
        Kind::Codes,
        true,
        t("Códigos al terminar", "Codes at the end"),
        t("Lo usual: M30", "Usual: M30"),
    ),
    whole(
        "block_step",
        "block_step",
        Unit::Count,
        [1, 1000],
        true,
        t("Paso de la numeración de bloques", "Step of the block numbers"),
        t("Lo usual: 10", "Usual: 10"),
    ),
];

/// The pipe-insert workbook.
pub static FORM: Form = Form {
    kind: "pipe-insert",
    schema: SCHEMA,
    cases: &CASES,
    programs: &["insert"],
    templates: &["template"],
    sheets: &[Sheet {
        name: t("DATOS", "DATA"),
        title: t("Injerto de tubo: parámetros", "Branch pipe: parameters"),
        optional: false,
        sections: &[
            Section {
                title: t("Esquema", "Schema"),
                parameters: &[Parameter {
                    key: "schema",
                    name: "schema",
                    meaning: t("Esquema del libro", "Schema of the workbook"),
                    unit: Unit::None,
                    kind: Kind::Schema,
                    required: true,
                    note: t("No lo cambie", "Do not change it"),
                }],
            },
            Section { title: t("Tubos", "Pipes"), parameters: PIPES },
            Section { title: t("Unión", "Joint"), parameters: JOINT },
            Section { title: t("Corte", "Cut"), parameters: CUTTING },
            Section { title: t("Programa", "Program"), parameters: PROGRAM },
        ],
    }],
};
