//! The form of the lathe workbook: stock, machine, tools, program, wanted profile.
//!
//! Source: the lathe simulator's tables of the machine and of the stock (D, L, L1 to L5), in its symbols; what a machine
//! needs beside them is added here. The tools have a file of their own.

use crate::gcode::chosen::LATHES;
use crate::gcode::control::Control;
use crate::gcode::fields;
use crate::gcode::interpreter::{DecimalPoint, HolePlane};
use crate::kinds::lathe::tool_sheet;
pub use crate::kinds::lathe::tool_sheet::KEY as TOOLS_KEY;
use crate::limits::SHEET_BLOCKS;
use crate::parameter::field::{Field, Optional, Required, Usual, choices};
use crate::parameter::list::{List, Naming};
use crate::parameter::{Form, Parameter, Section, Sheet, title_block};
use crate::removal::turning::stock::Support;
use crate::table::Unit;
use crate::text::{Text, t};

/// Name and version of the form.
pub const SCHEMA: &str = "rodete-lathe 1";

const MM: Unit = Unit::Millimetre;
const NONE: Text = t("", "");
const FOUR: Text = t("Vacías las cuatro o ninguna", "All four empty, or none");
const NOT_WATCHED: Text = t("Vacía: no se vigila", "Empty: not watched");
const NOT_KNOWN: Text = t(
    "Vacía: no se conoce; se rechaza el programa que la necesite",
    "Empty: not known; rodete rejects a program that needs it",
);

choices! { for DecimalPoint;
    "calculator" ("calculadora (X100 = 100 mm)", "calculator (X100 = 100 mm)") => DecimalPoint::Calculator,
    "micrometre" ("micras (X100 = 0.1 mm)", "micrometre (X100 = 0.1 mm)") => DecimalPoint::Micrometre
}

choices! { for HolePlane;
    "absolute" ("absoluta", "absolute") => HolePlane::Absolute,
    "incremental" ("incremental", "incremental") => HolePlane::Incremental
}

choices! { for Support;
    "auto" ("según el voladizo", "by the stick-out"; "by the overhang") => Support::ByOverhang,
    "yes" ("sí", "yes") => Support::Always,
    "no" ("no", "no") => Support::Never
}

choices! {
    /// On which side of the axis the turret is.
    pub enum Side {
        /// On the operator's.
        Front = "front" ("delantera", "front"),
        /// Beyond the axis.
        Rear = "rear" ("trasera", "rear"),
    }
}

choices! {
    /// How G0 moves both axes.
    pub enum Rapids {
        /// Straight.
        Straight = "straight" ("recto", "straight"),
        /// Each at its own rate.
        Bent = "bent" ("cada eje a su ritmo", "each axis at its rate"),
    }
}

choices! {
    /// What leads to a point of the wanted profile.
    pub enum Element {
        /// A straight line.
        Line = "1" ("1", "1"),
        /// A clockwise arc.
        Clockwise = "2" ("2", "2"),
        /// A counter-clockwise arc.
        CounterClockwise = "3" ("3", "3"),
    }
}

pub(crate) static PART: Field<String, Required> =
    Field::line("part", "part_name", 60, t("Nombre de la pieza", "Name of the part"), NONE);
pub(crate) static MATERIAL: Field<String, Optional> =
    Field::line("material", "material", 60, t("Material", "Material"), NONE);

const PIECE: &[&Parameter] = &[&PART.row, &MATERIAL.row];

pub(crate) static DIALECT: Field<&'static Control, Required> =
    Field::of_list("dialect", "dialect", &LATHES, t("Control", "Control"), NONE);
pub(crate) static POINT: Field<DecimalPoint, Optional> = Field::choice(
    "point",
    "decimal_point",
    t("Cotas sin punto decimal", "Dimensions without a decimal point"),
    t(
        "Obligatorio si lo decide un parámetro del control; con otro control puede quedar vacía",
        "Required where a parameter of the control decides it; with another control it may stay empty",
    ),
);
pub(crate) static BLOCK_DELETE: Field<bool, Usual> = Field::choice_or(
    false,
    "block_delete",
    "block_delete",
    t("Saltar los bloques que empiezan por /", "Skip blocks that begin with /"),
    t("Vacía: no", "Empty: no"),
);
pub(crate) static EPS: Field<f64, Usual> = Field::real_or(
    0.0002,
    "eps",
    "tolerance_eps",
    MM,
    [0.000_01, 0.01],
    t("Tolerancia de los arcos", "Arc tolerance"),
    t("Vacía: 0.0002", "Empty: 0.0002"),
);

const PROGRAM: &[&Parameter] = &[&DIALECT.row, &POINT.row, &BLOCK_DELETE.row, &EPS.row];

pub(crate) static D: Field<f64, Required> =
    Field::real("D", "stock_D", MM, [1.0, 1000.0], t("Diámetro del bruto D", "Stock diameter D"), NONE);
pub(crate) static L: Field<f64, Required> =
    Field::real("L", "stock_L", MM, [1.0, 1000.0], t("Longitud del bruto L", "Stock length L"), NONE);
pub(crate) static STOCK_BORE_D: Field<f64, Optional> = Field::real(
    "d",
    "stock_bore_d",
    MM,
    [0.5, 999.0],
    t("Agujero del bruto d", "Stock bore d"),
    t("Vacía: macizo", "Empty: solid"),
);
pub(crate) static L4: Field<f64, Required> = Field::real(
    "L4",
    "held_L4",
    MM,
    [0.0, 400.0],
    t("Longitud sujeta en las garras L4", "Length held in the jaws L4"),
    t("El voladizo es L3 = L − L4", "The stick-out is L3 = L − L4"),
);
pub(crate) static L5: Field<f64, Required> = Field::real(
    "L5",
    "facing_L5",
    MM,
    [0.0, 50.0],
    t("Demasía de refrentado L5", "Facing allowance L5"),
    t(
        "El cero pieza W1 (G54) está L5 a la izquierda de la cara",
        "The part zero W1 (G54) is L5 to the left of the face",
    ),
);

const STOCK: &[&Parameter] = &[&D.row, &L.row, &STOCK_BORE_D.row, &L4.row, &L5.row];

pub(crate) static L1: Field<f64, Required> = Field::real(
    "L1",
    "chuck_L1",
    MM,
    [0.0, 1000.0],
    t("Cuerpo del plato L1", "Chuck body L1"),
    t("Desde el cero máquina M, la cara del husillo", "From machine zero M, the spindle face"),
);
pub(crate) static L2: Field<f64, Required> = Field::real(
    "L2",
    "jaws_L2",
    MM,
    [0.0, 500.0],
    t("Garras L2", "Jaws L2"),
    t("Delante del cuerpo", "In front of the body"),
);
pub(crate) static D_C: Field<f64, Required> =
    Field::real("D_c", "chuck_D_c", MM, [1.0, 2000.0], t("Diámetro del plato D_c", "Diameter of the chuck D_c"), NONE);
pub(crate) static TAILSTOCK: Field<Support, Required> = Field::choice(
    "tailstock",
    "tailstock",
    t("Contrapunto", "Tailstock"),
    t("Según el voladizo: si L3 pasa de 3·D", "By the stick-out: if L3 is above 3·D"),
);

const CHUCK: &[&Parameter] = &[&L1.row, &L2.row, &D_C.row, &TAILSTOCK.row];

pub(crate) static X_MIN: Field<f64, Optional> = Field::real(
    "X_min",
    "travel_X_min",
    MM,
    [-5000.0, 5000.0],
    t("Recorrido mínimo en X", "Minimum X travel"),
    t(
        "Punto de referencia de la torreta, en diámetro, desde M. Vacía: no se vigila",
        "Turret reference point, as a diameter, from M. Empty: not watched",
    ),
);
pub(crate) static X_MAX: Field<f64, Optional> = Field::real(
    "X_max",
    "travel_X_max",
    MM,
    [-5000.0, 5000.0],
    t("Recorrido máximo en X", "Maximum X travel"),
    NOT_WATCHED,
);
pub(crate) static Z_MIN: Field<f64, Optional> = Field::real(
    "Z_min",
    "travel_Z_min",
    MM,
    [-5000.0, 5000.0],
    t("Recorrido mínimo en Z", "Minimum Z travel"),
    t(
        "Punto de referencia de la torreta, desde M. Vacía: no se vigila",
        "Turret reference point, from M. Empty: not watched",
    ),
);
pub(crate) static Z_MAX: Field<f64, Optional> = Field::real(
    "Z_max",
    "travel_Z_max",
    MM,
    [-5000.0, 5000.0],
    t("Recorrido máximo en Z", "Maximum Z travel"),
    NOT_WATCHED,
);
pub(crate) static G_X: Field<f64, Required> = Field::real(
    "G_X",
    "rapid_G_X",
    Unit::MillimetrePerMinute,
    [1.0, 200_000.0],
    t("Avance rápido en X", "Rapid rate in X"),
    t("Del carro, en radio", "Of the slide, on the radius"),
);
pub(crate) static G_Z: Field<f64, Required> = Field::real(
    "G_Z",
    "rapid_G_Z",
    Unit::MillimetrePerMinute,
    [1.0, 200_000.0],
    t("Avance rápido en Z", "Rapid rate in Z"),
    NONE,
);
pub(crate) static S_MAX: Field<f64, Required> = Field::real(
    "S_max",
    "spindle_S_max",
    Unit::RevolutionPerMinute,
    [1.0, 100_000.0],
    t("Giro máximo del husillo", "Maximum spindle speed"),
    NONE,
);
pub(crate) static RAPID: Field<Rapids, Required> = Field::choice(
    "rapid",
    "rapid_path",
    t("Trayectoria de G0", "Path of G0"),
    t("Depende de un parámetro del control", "Depends on a parameter of the control"),
);
pub(crate) static TURRET: Field<Side, Required> = Field::choice(
    "turret",
    "turret",
    t("Torreta", "Turret"),
    t(
        "Delantera: X hacia el operario. En una herramienta a izquierdas decide entre M3 y M4",
        "Front: X towards the operator. For a left-hand tool it decides between M3 and M4",
    ),
);

const MACHINE: &[&Parameter] =
    &[&X_MIN.row, &X_MAX.row, &Z_MIN.row, &Z_MAX.row, &G_X.row, &G_Z.row, &S_MAX.row, &RAPID.row, &TURRET.row];

pub(crate) static BX_MIN: Field<f64, Optional> = Field::real(
    "BX_min",
    "body_BX_min",
    MM,
    [-1000.0, 1000.0],
    t("X mínima del cuerpo, en radio", "Minimum X of the body, as a radius"),
    t(
        "Desde el punto de referencia de la torreta, como Q_x. Incluya el alcance del disco y de las herramientas vecinas. Las cuatro vacías: no se vigila",
        "From the turret reference point, like Q_x. Include the reach of the disc and the neighbouring tools. All four empty: not watched",
    ),
);
pub(crate) static BX_MAX: Field<f64, Optional> = Field::real(
    "BX_max",
    "body_BX_max",
    MM,
    [-1000.0, 1000.0],
    t("X máxima del cuerpo, en radio", "Maximum X of the body, as a radius"),
    FOUR,
);
pub(crate) static BZ_MIN: Field<f64, Optional> = Field::real(
    "BZ_min",
    "body_BZ_min",
    MM,
    [-1000.0, 1000.0],
    t("Z mínima del cuerpo", "Minimum Z of the body"),
    t(
        "Una broca o barra sobresale libre hasta su largo l, o hasta el punto de referencia. Vacías las cuatro o ninguna",
        "A drill or bar sticks out free up to its length l, or up to the reference point. All four empty, or none",
    ),
);
pub(crate) static BZ_MAX: Field<f64, Optional> = Field::real(
    "BZ_max",
    "body_BZ_max",
    MM,
    [-1000.0, 1000.0],
    t("Z máxima del cuerpo", "Maximum Z of the body"),
    FOUR,
);

const BODY: &[&Parameter] = &[&BX_MIN.row, &BX_MAX.row, &BZ_MIN.row, &BZ_MAX.row];

pub(crate) static W2_X: Field<f64, Optional> = Field::real(
    "W2_X",
    "zero_W2_X",
    MM,
    [-5000.0, 5000.0],
    t("W2 (G55), X en diámetro, desde M", "W2 (G55), X as a diameter, from M"),
    NOT_KNOWN,
);
pub(crate) static W2_Z: Field<f64, Optional> =
    Field::real("W2_Z", "zero_W2_Z", MM, [-5000.0, 5000.0], t("W2 (G55), Z", "W2 (G55), Z"), NOT_KNOWN);
pub(crate) static W3_X: Field<f64, Optional> =
    Field::real("W3_X", "zero_W3_X", MM, [-5000.0, 5000.0], t("W3 (G56), X", "W3 (G56), X"), NOT_KNOWN);
pub(crate) static W3_Z: Field<f64, Optional> =
    Field::real("W3_Z", "zero_W3_Z", MM, [-5000.0, 5000.0], t("W3 (G56), Z", "W3 (G56), Z"), NOT_KNOWN);
pub(crate) static W4_X: Field<f64, Optional> =
    Field::real("W4_X", "zero_W4_X", MM, [-5000.0, 5000.0], t("W4 (G57), X", "W4 (G57), X"), NOT_KNOWN);
pub(crate) static W4_Z: Field<f64, Optional> =
    Field::real("W4_Z", "zero_W4_Z", MM, [-5000.0, 5000.0], t("W4 (G57), Z", "W4 (G57), Z"), NOT_KNOWN);
pub(crate) static W5_X: Field<f64, Optional> =
    Field::real("W5_X", "zero_W5_X", MM, [-5000.0, 5000.0], t("W5 (G58), X", "W5 (G58), X"), NOT_KNOWN);
pub(crate) static W5_Z: Field<f64, Optional> =
    Field::real("W5_Z", "zero_W5_Z", MM, [-5000.0, 5000.0], t("W5 (G58), Z", "W5 (G58), Z"), NOT_KNOWN);
pub(crate) static W6_X: Field<f64, Optional> =
    Field::real("W6_X", "zero_W6_X", MM, [-5000.0, 5000.0], t("W6 (G59), X", "W6 (G59), X"), NOT_KNOWN);
pub(crate) static W6_Z: Field<f64, Optional> =
    Field::real("W6_Z", "zero_W6_Z", MM, [-5000.0, 5000.0], t("W6 (G59), Z", "W6 (G59), Z"), NOT_KNOWN);

const ZEROS: &[&Parameter] =
    &[&W2_X.row, &W2_Z.row, &W3_X.row, &W3_Z.row, &W4_X.row, &W4_Z.row, &W5_X.row, &W5_Z.row, &W6_X.row, &W6_Z.row];

pub(crate) static Z_S: Field<f64, Optional> = Field::real(
    "Z_s",
    "second_Z_s",
    MM,
    [-1000.0, 1000.0],
    t("Desplazamiento en el segundo amarre", "Shift in the second set-up"),
    t(
        "Se da la vuelta a la pieza por el centro del bruto y se desplaza Z_s; con la hoja PROGRAMA 2. Vacía: 0",
        "The part is turned round about the middle of the stock and shifted by Z_s; with the sheet PROGRAM 2. Empty: 0",
    ),
);

const SECOND: &[&Parameter] = &[&Z_S.row];

pub(crate) static R_X: Field<f64, Optional> = Field::real(
    "R_X",
    "reference_R_X",
    MM,
    [-5000.0, 5000.0],
    t("Punto de referencia, X en diámetro, desde M", "Reference point, X as a diameter, from M"),
    t(
        "Donde G28 y G53 X0 Z0 llevan la torreta. Vacía: G28 la lleva 30 mm más allá del bruto, y G53 cuenta desde M",
        "Where G28 and G53 X0 Z0 take the turret. Empty: G28 takes it 30 mm beyond the stock, and G53 counts from M",
    ),
);
pub(crate) static R_Z: Field<f64, Optional> = Field::real(
    "R_Z",
    "reference_R_Z",
    MM,
    [-5000.0, 5000.0],
    t("Punto de referencia, Z desde M", "Reference point, Z from M"),
    t("Vacías R_X y R_Z, o ninguna", "R_X and R_Z both empty, or neither"),
);
pub(crate) static HOLE_R: Field<HolePlane, Optional> = Field::choice(
    "hole_R",
    "hole_R",
    t("R de G81 a G83", "R of G81 to G83"),
    t(
        "Donde G81 a G83 taladran. Absoluta: la Z del plano. Incremental: desde la posición de la herramienta. Vacía: absoluta",
        "Where G81 to G83 drill. Absolute: the Z of the plane. Incremental: from the tool's position. Empty: absolute",
    ),
);

const CONTROL: &[&Parameter] = &[&R_X.row, &R_Z.row, &HOLE_R.row];

pub(crate) static BLOCK: Field<String, Required> =
    Field::line("program/BLOCK", "", 200, t("un bloque por fila", "one block per row"), NONE);
pub(crate) static NOTE: Field<String, Optional> =
    Field::line("program/NOTE", "", 200, t("no se lee", "not read"), NONE).unread();

const BLOCKS: &[&Parameter] = &[&BLOCK.row, &NOTE.row];

pub(crate) static PROFILE_G: Field<Element, Required> = Field::choice(
    "profile/G",
    "",
    t("1 recta, 2 arco horario, 3 antihorario", "1 straight, 2 clockwise arc, 3 counter-clockwise"),
    NONE,
);
pub(crate) static PROFILE_X: Field<f64, Required> =
    Field::real("profile/X", "", MM, [0.0, 2000.0], t("diámetro", "diameter"), NONE);
pub(crate) static PROFILE_Z: Field<f64, Required> =
    Field::real("profile/Z", "", MM, [-2000.0, 2000.0], t("desde el cero pieza W1", "from the part zero W1"), NONE);
pub(crate) static PROFILE_R: Field<f64, Optional> =
    Field::real("profile/R", "", MM, [0.001, 10_000.0], t("radio del arco", "radius of the arc"), NONE);

const PROFILE: &[&Parameter] = &[&PROFILE_G.row, &PROFILE_X.row, &PROFILE_Z.row, &PROFILE_R.row];

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
    "Escriba un bloque por fila en la columna BLOCK; rodete salta las filas vacías. Ponga los subprogramas externos en hojas llamadas O y su número, como O0005.",
    "Write one block per row in column BLOCK; rodete skips empty rows. Put external subprograms on sheets named O and their number, like O0005.",
);

/// The lathe workbook.
pub static FORM: Form = Form {
    kind: "lathe",
    schema: SCHEMA,
    part: &PART,
    material: Some(&MATERIAL),
    programs: &["program", "program-2"],
    drawings: &["contour"],
    solids: &[("part", t("Pieza torneada, STL en mm", "Turned part, STL in mm"))],
    viewer: true,
    sheets: &[Sheet {
        name: t("DATOS", "DATA"),
        title: t("Datos del torneado", "Turning data"),
        optional: false,
        sections: &[
            Section { title: t("Esquema", "Schema"), parameters: &[&fields::SCHEMA.row], optional: false },
            Section { title: t("Pieza", "Part"), parameters: PIECE, optional: false },
            Section { title: t("Programa", "Program"), parameters: PROGRAM, optional: false },
            Section { title: t("Bruto", "Stock"), parameters: STOCK, optional: false },
            Section { title: t("Plato y contrapunto", "Chuck and tailstock"), parameters: CHUCK, optional: false },
            Section { title: t("Máquina", "Machine"), parameters: MACHINE, optional: false },
            Section {
                title: t(
                    "Cuerpo de la torreta con las herramientas vecinas",
                    "Body of the turret with the neighbouring tools",
                ),
                parameters: BODY,
                optional: true,
            },
            Section {
                title: t("Otros ceros pieza, desde M", "Other part zeros, from M"),
                parameters: ZEROS,
                optional: true,
            },
            Section { title: t("Segundo amarre", "Second set-up"), parameters: SECOND, optional: true },
            Section { title: t("Ajustes del control", "Control settings"), parameters: CONTROL, optional: true },
            title_block::SECTION,
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
            title: t("Programa del segundo amarre", "Program of the second set-up"),
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
                "Los puntos del contorno deseado, en orden; el primero es el comienzo. rodete lo compara con el contorno torneado.",
                "The points of the wanted contour, in order; the first one is its beginning. rodete compares it with the turned contour.",
            ),
            is_program: false,
            optional: true,
            columns: PROFILE,
            widths: &[14.0, 14.0, 14.0, 14.0],
            most: 2_000,
        },
    ],
    ..Form::PLAIN
};
