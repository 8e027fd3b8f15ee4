//! The form of the lathe workbook: stock, machine, tools, program, wanted profile.
//!
//! Source: the lathe simulator's tables of the machine and of the stock (D, L, L1 to L5), in its symbols; what a machine
//! needs beside them is added here. The tools have a file of their own.

use crate::kinds::lathe::cases::CASES;
use crate::kinds::lathe::tool_sheet;
pub use crate::kinds::lathe::tool_sheet::KEY as TOOLS_KEY;
use crate::limits::SHEET_BLOCKS;
use crate::parameter::list::{List, Naming};
use crate::parameter::{Choice, FieldKind, Form, Parameter, Section, Sheet, other, real, t};
use crate::table::Unit;
use crate::text::Text;

/// Name and version of the form.
pub const SCHEMA: &str = "rodete-lathe 1";

const MM: Unit = Unit::Millimetre;
const NONE: Text = t("", "");

/// The controls that turn.
pub const DIALECTS: &[Choice] = &[
    Choice { key: "fanuc-lathe-a", label: t("fanuc-lathe-a", "fanuc-lathe-a") },
    Choice { key: "fagor-8055-t", label: t("fagor-8055-t", "fagor-8055-t") },
];

const POINTS: &[Choice] = &[
    Choice { key: "calculator", label: t("calculadora (X100 = 100 mm)", "calculator (X100 = 100 mm)") },
    Choice { key: "micrometre", label: t("micras (X100 = 0.1 mm)", "micrometre (X100 = 0.1 mm)") },
];

const YES_NO: &[Choice] = &[Choice { key: "yes", label: t("sí", "yes") }, Choice { key: "no", label: t("no", "no") }];

const TAILSTOCK: &[Choice] = &[
    Choice { key: "auto", label: t("según el voladizo", "by the overhang") },
    Choice { key: "yes", label: t("sí", "yes") },
    Choice { key: "no", label: t("no", "no") },
];

const TURRET: &[Choice] =
    &[Choice { key: "front", label: t("delantera", "front") }, Choice { key: "rear", label: t("trasera", "rear") }];

const RAPIDS: &[Choice] = &[
    Choice { key: "straight", label: t("recto", "straight") },
    Choice { key: "bent", label: t("cada eje a su ritmo", "each axis at its rate") },
];

const PART: &[Parameter] = &[
    other("part", "part_name", FieldKind::Line { max: 60 }, true, t("Nombre de la pieza", "Name of the part"), NONE),
    other("material", "material", FieldKind::Line { max: 60 }, false, t("Material", "Material"), NONE),
];

const PROGRAM: &[Parameter] = &[
    other("dialect", "dialect", FieldKind::Choice(DIALECTS), true, t("Control", "Control"), NONE),
    other(
        "point",
        "decimal_point",
        FieldKind::Choice(POINTS),
        false,
        t("Cotas sin punto decimal", "Dimensions without a decimal point"),
        t(
            "Obligatorio con fanuc-lathe-a: es un parámetro de la máquina",
            "Required with fanuc-lathe-a: a setting of the machine",
        ),
    ),
    other(
        "block_delete",
        "block_delete",
        FieldKind::Choice(YES_NO),
        false,
        t("Salta los bloques con /", "Skip blocks that begin with /"),
        t("Vacío: no", "Empty: no"),
    ),
    real(
        "eps",
        "tolerance_eps",
        MM,
        [0.000_01, 0.01],
        false,
        t("Tolerancia de los arcos", "Tolerance of arcs"),
        t("Vacío: 0.0002", "Empty: 0.0002"),
    ),
];

const STOCK: &[Parameter] = &[
    real("D", "stock_D", MM, [1.0, 1000.0], true, t("Diámetro del bruto D", "Diameter of the stock D"), NONE),
    real("L", "stock_L", MM, [1.0, 1000.0], true, t("Longitud del bruto L", "Length of the stock L"), NONE),
    real(
        "d",
        "stock_bore_d",
        MM,
        [0.5, 999.0],
        false,
        t("Agujero del bruto d", "Bore of the stock d"),
        t("Vacío: macizo", "Empty: solid"),
    ),
    real(
        "L4",
        "held_L4",
        MM,
        [0.0, 400.0],
        true,
        t("Longitud sujeta en las garras L4", "Length held in the jaws L4"),
        t("El voladizo es L3 = L − L4", "The overhang is L3 = L − L4"),
    ),
    real(
        "L5",
        "facing_L5",
        MM,
        [0.0, 50.0],
        true,
        t("Sobremetal de refrentado L5", "Facing allowance L5"),
        t("El origen W1 (G54) está L5 a la izquierda de la cara", "The zero W1 (G54) lies L5 to the left of the face"),
    ),
];

const CHUCK: &[Parameter] = &[
    real(
        "L1",
        "chuck_L1",
        MM,
        [0.0, 1000.0],
        true,
        t("Cuerpo del plato L1", "Chuck body L1"),
        t("Desde el cero máquina M, la cara del husillo", "From machine zero M, the face of the spindle"),
    ),
    real(
        "L2",
        "jaws_L2",
        MM,
        [0.0, 500.0],
        true,
        t("Garras L2", "Jaws L2"),
        t("Delante del cuerpo", "In front of the body"),
    ),
    real("D_c", "chuck_D_c", MM, [1.0, 2000.0], true, t("Diámetro del plato D_c", "Diameter of the chuck D_c"), NONE),
    other(
        "tailstock",
        "tailstock",
        FieldKind::Choice(TAILSTOCK),
        true,
        t("Contrapunto", "Tailstock"),
        t("Según el voladizo: cuando L3 pasa de 3·D", "By the overhang: where L3 is more than 3·D"),
    ),
];

const MACHINE: &[Parameter] = &[
    real(
        "X_min",
        "travel_X_min",
        MM,
        [-5000.0, 5000.0],
        false,
        t("Recorrido X mínimo", "Least X of the travel"),
        t(
            "Diámetro, del punto de referencia de la torreta, desde M",
            "Diameter, of the turret's reference point, from M",
        ),
    ),
    real(
        "X_max",
        "travel_X_max",
        MM,
        [-5000.0, 5000.0],
        false,
        t("Recorrido X máximo", "Greatest X of the travel"),
        NONE,
    ),
    real(
        "Z_min",
        "travel_Z_min",
        MM,
        [-5000.0, 5000.0],
        false,
        t("Recorrido Z mínimo", "Least Z of the travel"),
        t("Del punto de referencia de la torreta, desde M", "Of the turret's reference point, from M"),
    ),
    real(
        "Z_max",
        "travel_Z_max",
        MM,
        [-5000.0, 5000.0],
        false,
        t("Recorrido Z máximo", "Greatest Z of the travel"),
        NONE,
    ),
    real(
        "G_X",
        "rapid_G_X",
        Unit::MillimetrePerMinute,
        [1.0, 200_000.0],
        true,
        t("Avance rápido en X", "Rapid rate in X"),
        t("Del carro, en radio", "Of the slide, on the radius"),
    ),
    real(
        "G_Z",
        "rapid_G_Z",
        Unit::MillimetrePerMinute,
        [1.0, 200_000.0],
        true,
        t("Avance rápido en Z", "Rapid rate in Z"),
        NONE,
    ),
    real(
        "S_max",
        "spindle_S_max",
        Unit::RevolutionPerMinute,
        [1.0, 100_000.0],
        true,
        t("Giro máximo del husillo", "Greatest speed of the spindle"),
        NONE,
    ),
    other(
        "rapid",
        "rapid_path",
        FieldKind::Choice(RAPIDS),
        true,
        t("Recorrido de G0", "Way of G0"),
        t("Lo decide un parámetro del control", "A setting of the control decides"),
    ),
    other(
        "turret",
        "turret",
        FieldKind::Choice(TURRET),
        true,
        t("Torreta", "Turret"),
        t(
            "Delantera: X hacia el operario; decide qué sentido de giro corta",
            "Front: X towards the operator; decides which way the spindle must turn",
        ),
    ),
];

const BODY: &[Parameter] = &[
    real(
        "BX_min",
        "body_BX_min",
        MM,
        [-1000.0, 1000.0],
        false,
        t("Menor X del cuerpo, en radio", "Least X of the body, on the radius"),
        t(
            "Desde el punto de referencia de la torreta, como Q_x; incluya lo que alcanzan el disco y las herramientas vecinas. Los cuatro vacíos: no se vigila",
            "From the turret's reference point, as Q_x; include what the disc and the neighbouring tools reach. All four empty: not watched",
        ),
    ),
    real(
        "BX_max",
        "body_BX_max",
        MM,
        [-1000.0, 1000.0],
        false,
        t("Mayor X del cuerpo, en radio", "Greatest X of the body, on the radius"),
        NONE,
    ),
    real(
        "BZ_min",
        "body_BZ_min",
        MM,
        [-1000.0, 1000.0],
        false,
        t("Menor Z del cuerpo", "Least Z of the body"),
        t(
            "Una broca o una barra queda libre hasta su largo l, o hasta el punto de referencia",
            "A drill or a bar is free up to its length l, or up to the reference point",
        ),
    ),
    real(
        "BZ_max",
        "body_BZ_max",
        MM,
        [-1000.0, 1000.0],
        false,
        t("Mayor Z del cuerpo", "Greatest Z of the body"),
        NONE,
    ),
];

macro_rules! zero {
    ($key:literal, $name:literal, $es:literal, $en:literal) => {
        real($key, $name, MM, [-5000.0, 5000.0], false, t($es, $en), NONE)
    };
}

const ZEROS: &[Parameter] = &[
    zero!("W2_X", "zero_W2_X", "W2 (G55), X en diámetro, desde M", "W2 (G55), X as a diameter, from M"),
    zero!("W2_Z", "zero_W2_Z", "W2 (G55), Z", "W2 (G55), Z"),
    zero!("W3_X", "zero_W3_X", "W3 (G56), X", "W3 (G56), X"),
    zero!("W3_Z", "zero_W3_Z", "W3 (G56), Z", "W3 (G56), Z"),
    zero!("W4_X", "zero_W4_X", "W4 (G57), X", "W4 (G57), X"),
    zero!("W4_Z", "zero_W4_Z", "W4 (G57), Z", "W4 (G57), Z"),
    zero!("W5_X", "zero_W5_X", "W5 (G58), X", "W5 (G58), X"),
    zero!("W5_Z", "zero_W5_Z", "W5 (G58), Z", "W5 (G58), Z"),
    zero!("W6_X", "zero_W6_X", "W6 (G59), X", "W6 (G59), X"),
    zero!("W6_Z", "zero_W6_Z", "W6 (G59), Z", "W6 (G59), Z"),
];

const SECOND: &[Parameter] = &[real(
    "Z_s",
    "second_Z_s",
    MM,
    [-1000.0, 1000.0],
    false,
    t("Desplazamiento de la pieza vuelta", "Shift of the part turned round"),
    t(
        "Se refleja por el centro del bruto y se desplaza Z_s; con la hoja PROGRAMA 2",
        "It is mirrored about the middle of the stock and shifted by Z_s; with the sheet PROGRAM 2",
    ),
)];

const PLANES: &[Choice] = &[
    Choice { key: "absolute", label: t("absoluta", "absolute") },
    Choice { key: "incremental", label: t("incremental", "incremental") },
];

const CONTROL: &[Parameter] = &[
    real(
        "R_X",
        "reference_R_X",
        MM,
        [-5000.0, 5000.0],
        false,
        t("Punto de referencia, X en diámetro, desde M", "Reference point, X as a diameter, from M"),
        t(
            "Donde G28 y G53 X0 Z0 llevan la torreta. Vacío: G28 la lleva 30 mm más allá del bruto, y G53 cuenta desde M",
            "Where G28 and G53 X0 Z0 take the turret. Empty: G28 takes it 30 mm beyond the stock, and G53 counts from M",
        ),
    ),
    real(
        "R_Z",
        "reference_R_Z",
        MM,
        [-5000.0, 5000.0],
        false,
        t("Punto de referencia, Z desde M", "Reference point, Z from M"),
        NONE,
    ),
    other(
        "hole_R",
        "hole_R",
        FieldKind::Choice(PLANES),
        false,
        t("R de G81 a G83", "R of G81 to G83"),
        t(
            "fanuc-lathe-a. Absoluta: la Z del plano. Incremental: desde donde está la herramienta. Vacío: absoluta",
            "fanuc-lathe-a. Absolute: the Z of the plane. Incremental: from where the tool stands. Empty: absolute",
        ),
    ),
];

const BLOCKS: &[Parameter] = &[
    other("program/BLOCK", "", FieldKind::Line { max: 200 }, true, t("un bloque por fila", "one block a row"), NONE),
    other("program/NOTE", "", FieldKind::Line { max: 200 }, false, t("no se lee", "not read"), NONE),
];

const ELEMENTS: &[Choice] = &[
    Choice { key: "1", label: t("1", "1") },
    Choice { key: "2", label: t("2", "2") },
    Choice { key: "3", label: t("3", "3") },
];

const PROFILE: &[Parameter] = &[
    other(
        "profile/G",
        "",
        FieldKind::Choice(ELEMENTS),
        true,
        t("1 recta, 2 arco horario, 3 antihorario", "1 straight, 2 clockwise arc, 3 counter-clockwise"),
        NONE,
    ),
    real("profile/X", "", MM, [0.0, 2000.0], true, t("diámetro", "diameter"), NONE),
    real("profile/Z", "", MM, [-2000.0, 2000.0], true, t("desde el origen W1", "from the zero W1"), NONE),
    real("profile/R", "", MM, [0.001, 10_000.0], false, t("radio del arco", "radius of the arc"), NONE),
];

const BLOCK_WIDTHS: &[f64] = &[52.0, 34.0];

/// The list of the program's blocks.
pub const PROGRAM_KEY: &str = "program";
/// The list of the blocks of the second set-up's program.
pub const SECOND_KEY: &str = "program-2";
/// The lists of subprograms.
pub const SUBPROGRAM_KEY: &str = "subprogram";
/// The list of the wanted profile's points.
pub const PROFILE_KEY: &str = "profile";

const BLOCKS_NOTE: Text = t(
    "Un bloque por fila en la columna BLOCK; las filas vacías se saltan. Los subprogramas externos van en hojas llamadas O y su número, como O0005.",
    "One block a row in column BLOCK; empty rows are skipped. External subprograms go on sheets called O and their number, such as O0005.",
);

/// The lathe workbook.
pub static FORM: Form = Form {
    kind: "lathe",
    schema: SCHEMA,
    earlier: &[],
    cases: &CASES,
    programs: &["program", "program-2"],
    drawings: &["contour"],
    solids: &[("part", t("Pieza torneada, STL en mm", "Turned part, STL in mm"))],
    sheets: &[Sheet {
        name: t("DATOS", "DATA"),
        title: t("Datos del torneado", "Data of the turning"),
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
            Section { title: t("Pieza", "Part"), parameters: PART },
            Section { title: t("Programa", "Program"), parameters: PROGRAM },
            Section { title: t("Bruto", "Stock"), parameters: STOCK },
            Section { title: t("Plato y contrapunto", "Chuck and tailstock"), parameters: CHUCK },
            Section { title: t("Máquina", "Machine"), parameters: MACHINE },
            Section {
                title: t(
                    "Cuerpo de la torreta con las herramientas vecinas",
                    "Body of the turret with the neighbouring tools",
                ),
                parameters: BODY,
            },
            Section { title: t("Otros orígenes, desde M", "Further zeros, from M"), parameters: ZEROS },
            Section { title: t("Segunda colocación", "Second set-up"), parameters: SECOND },
            Section { title: t("Ajustes del control", "Settings of the control"), parameters: CONTROL },
        ],
    }],
    lists: &[
        tool_sheet::LIST,
        List {
            key: PROGRAM_KEY,
            naming: Naming::One(t("PROGRAMA", "PROGRAM")),
            title: t("Programa", "Program"),
            note: BLOCKS_NOTE,
            is_program: true,
            optional: false,
            columns: BLOCKS,
            widths: BLOCK_WIDTHS,
            most: SHEET_BLOCKS,
        },
        List {
            key: SECOND_KEY,
            naming: Naming::One(t("PROGRAMA 2", "PROGRAM 2")),
            title: t("Programa de la segunda colocación", "Program of the second set-up"),
            note: BLOCKS_NOTE,
            is_program: true,
            optional: true,
            columns: BLOCKS,
            widths: BLOCK_WIDTHS,
            most: SHEET_BLOCKS,
        },
        List {
            key: SUBPROGRAM_KEY,
            naming: Naming::Numbered(t("O0001 a O9999", "O0001 to O9999")),
            title: t("Subprograma", "Subprogram"),
            note: BLOCKS_NOTE,
            is_program: false,
            optional: true,
            columns: BLOCKS,
            widths: BLOCK_WIDTHS,
            most: SHEET_BLOCKS,
        },
        List {
            key: PROFILE_KEY,
            naming: Naming::One(t("PERFIL", "PROFILE")),
            title: t("Perfil deseado", "Wanted profile"),
            note: t(
                "Los puntos del contorno que debe quedar, en orden; el primero es el comienzo. Se compara con el contorno torneado.",
                "The points of the contour that is wanted, in order; the first one is its beginning. It is held against the turned contour.",
            ),
            is_program: false,
            optional: true,
            columns: PROFILE,
            widths: &[14.0, 14.0, 14.0, 14.0],
            most: 2_000,
        },
    ],
};
