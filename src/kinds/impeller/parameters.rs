//! The form of the impeller workbook: every parameter with its meaning, unit, limits and note.
//!
//! Source: the design parameters of the thesis (its section 4.4.1, first group of cells), the machine (section 4.2 and
//! 5.2), the turning of the blank (section 4.1); what the source leaves to the operator (feed, speed, dialect, travel)
//! is added here. Limits are those of the machines the method is meant for; they catch metres typed for millimetres.

use crate::finding::Raise;
use crate::gcode::chosen::Codes;
use crate::gcode::control::RotaryMode;
use crate::gcode::fields;
pub(super) use crate::gcode::fields::{DIALECT, MATERIAL, PART};
use crate::gcode::program::Style;
use crate::gcode::word::{Distance, Retract};
use crate::kinds::impeller::clear::fields as cut;
use crate::kinds::impeller::fade::Fade;
use crate::kinds::impeller::operation::Operation;
use crate::kinds::impeller::rules::HeightCalledLength;
use crate::parameter::field::{Field, Optional, Required, Usual, WithSheet};
use crate::parameter::{Earlier, FieldKind, Form, Parameter, Section, Sheet, title_block};
use crate::table::Unit;
use crate::text::{Text, t};

/// Name and version of the form.
pub const SCHEMA: &str = "rodete-impeller 2";

const MM: Unit = Unit::Millimetre;
const TRAVEL: [f64; 2] = [-10_000.0, 10_000.0];
const TRAVEL_NOTE: Text =
    t("En coordenadas de programa; vacío: no se comprueba", "In program coordinates; empty: not checked");

pub(super) static R: Field<f64, Required> = Field::real(
    "R",
    "torus_R",
    MM,
    [5.0, 1000.0],
    t("Radio del toro, del eje al centro del meridiano", "Torus radius, axis to the centre of the meridian"),
    t("Mayor que r", "Larger than r"),
);
pub(super) static MERIDIAN_R: Field<f64, Required> = Field::real(
    "r",
    "meridian_r",
    MM,
    [1.0, 900.0],
    t("Radio del meridiano del toro", "Radius of the torus meridian"),
    t("Menor que R", "Less than R"),
);
pub(super) static INTERVALS_N: Field<u32, Required> = Field::whole(
    "n",
    "intervals_n",
    Unit::Count,
    [2, 100_000],
    t("Número de intervalos de la discretización", "Number of intervals of the discretisation"),
    t(
        "n + 1 puntos por pasada; con method = canal cuenta solo en las tablas de la fibra media",
        "n + 1 points per pass; with method = clear it counts only for the tables of the mean line",
    ),
);
pub(super) static EPS_V: Field<f64, Required> = Field::real(
    "eps_v",
    "end_backoff_eps_v",
    Unit::Step,
    [0.0, 0.5],
    t("Retroceso del último punto, en pasos", "Distance of the last point from the end, in steps"),
    t(
        "0: llega hasta el final; 1e-5: como en los anexos publicados",
        "0: goes to the end; 1e-5: as in the published annexes",
    ),
);
pub(super) static N: Field<u32, Required> = Field::whole(
    "N",
    "blades_N",
    Unit::Count,
    [1, 60],
    t("Número de álabes", "Number of blades"),
    t(
        "Como mucho N_max; con method = canal, mientras pasen las fresas",
        "At most N_max; with method = clear, as long as the tools pass",
    ),
);
pub(super) static E: Field<f64, Required> = Field::real(
    "e",
    "thickness_e",
    MM,
    [0.05, 100.0],
    t("Espesor del álabe", "Blade thickness"),
    t(
        "Como mucho e_max; con method = canal, mientras pasen las fresas",
        "At most e_max; with method = clear, as long as the tools pass",
    ),
);
pub(super) static A_P: Field<f64, Required> = Field::real(
    "a_p",
    "depth_a_p",
    MM,
    [0.01, 100.0],
    t("Profundidad del canal (publicado: la de su única pasada)", "Depth of the channel (published: of its only pass)"),
    t("Menor que R − r", "Less than R − r"),
);
pub(super) static SPLITTERS: Field<bool, Required> =
    Field::choice("splitters", "splitters", t("Álabes intermedios", "Splitter blades"), t("sí o no", "yes or no"));
pub(super) static SPLITTER_FADE: Field<Fade, Usual> = Field::choice_or(
    Fade::Published,
    "splitter_fade",
    "splitter_fade",
    t("Cómo empiezan los álabes intermedios", "How splitter blades begin"),
    t(
        "Solo con method = publicado. cada lado: la herramienta libra los álabes vecinos; publicado, o vacía: como en la publicación, los corta",
        "Only with method = published. each-side: the tool clears the neighbouring blades; published, or empty: as published, the tool cuts into them",
    ),
);

const GEOMETRY: &[&Parameter] = &[
    &R.row,
    &MERIDIAN_R.row,
    &INTERVALS_N.row,
    &EPS_V.row,
    &N.row,
    &E.row,
    &A_P.row,
    &SPLITTERS.row,
    &SPLITTER_FADE.row,
];

pub(super) static D_T: Field<f64, Required> = Field::real(
    "d_t",
    "tool_diameter_d_t",
    MM,
    [0.2, 100.0],
    t("Diámetro de la herramienta", "Tool diameter"),
    t("Fresa frontal; como mucho 2·r", "Flat end mill; at most 2·r"),
);
pub(super) static T: Field<u32, Required> =
    Field::whole("T", "tool_T", Unit::Count, [1, 9999], t("Número de herramienta", "Tool number"), t("", ""));
pub(super) static D: Field<u32, Required> = Field::whole(
    "D",
    "tool_offset_D",
    Unit::Count,
    [1, 999],
    t("Número de corrector", "Tool offset number"),
    t("", ""),
);

const TOOL: &[&Parameter] = &[&D_T.row, &T.row, &D.row];

pub(super) static R_B: Field<f64, Required> = Field::real(
    "R_B",
    "spindle_height_R_B",
    MM,
    [1.0, 5000.0],
    t("Altura de la nariz del husillo portapieza sobre el eje B", "Height of the work spindle nose above the B axis"),
    t("De la calibración", "From the calibration"),
);
pub(super) static H: Field<f64, Required> = Field::real(
    "H",
    "height_H",
    MM,
    [1.0, 1000.0],
    t(
        "Altura de la cara torneada (plano del centro del toro) sobre la nariz del husillo portapieza",
        "Height of the turned face (torus centre plane) above the work spindle nose",
    ),
    t(
        "L = R_B + H; no es la longitud de la herramienta, que va solo en el cero de Z",
        "L = R_B + H; not the tool length, which goes only into the Z zero",
    ),
);
pub(super) static ROTARY: Field<RotaryMode, Optional> = Field::choice(
    "rotary",
    "rotary_axes",
    t("Cómo cuentan los ejes B y C de la máquina en G90", "How the machine's axes B and C count in G90"),
    t(
        "rollover: de 0 a 360, el signo es el sentido; lineal: como un eje lineal; vacía: como se entrega el control de dialect",
        "rollover: from 0 to 360, the sign is the direction; linear: like a linear axis; empty: as the control of dialect is delivered",
    ),
);
pub(super) static B_MIN: Field<f64, Required> = Field::real(
    "B_min",
    "B_min",
    Unit::Degree,
    [-360.0, 360.0],
    t("Límite inferior de B", "Lower limit of B"),
    t("Menor que B_max", "Less than B_max"),
);
pub(super) static B_MAX: Field<f64, Required> = Field::real(
    "B_max",
    "B_max",
    Unit::Degree,
    [-360.0, 360.0],
    t("Límite superior de B", "Upper limit of B"),
    t("Mayor que B_min", "Larger than B_min"),
);
pub(super) static X_MIN: Field<f64, Optional> =
    Field::real("X_min", "X_min", MM, TRAVEL, t("Límite inferior de X", "Lower limit of X"), TRAVEL_NOTE);
pub(super) static X_MAX: Field<f64, Optional> =
    Field::real("X_max", "X_max", MM, TRAVEL, t("Límite superior de X", "Upper limit of X"), TRAVEL_NOTE);
pub(super) static Y_MIN: Field<f64, Optional> =
    Field::real("Y_min", "Y_min", MM, TRAVEL, t("Límite inferior de Y", "Lower limit of Y"), TRAVEL_NOTE);
pub(super) static Y_MAX: Field<f64, Optional> =
    Field::real("Y_max", "Y_max", MM, TRAVEL, t("Límite superior de Y", "Upper limit of Y"), TRAVEL_NOTE);
pub(super) static Z_MIN: Field<f64, Optional> =
    Field::real("Z_min", "Z_min", MM, TRAVEL, t("Límite inferior de Z", "Lower limit of Z"), TRAVEL_NOTE);
pub(super) static Z_MAX: Field<f64, Optional> =
    Field::real("Z_max", "Z_max", MM, TRAVEL, t("Límite superior de Z", "Upper limit of Z"), TRAVEL_NOTE);
pub(super) static F_MAX: Field<f64, Optional> = Field::real(
    "F_max",
    "feed_limit_F_max",
    Unit::MillimetrePerMinute,
    [1.0, 200_000.0],
    t("Velocidad máxima de cada eje (°/min en B y C)", "Maximum speed of each axis (°/min in B and C)"),
    t("Vacía: no se comprueba", "Empty: not checked"),
);

const MACHINE: &[&Parameter] = &[
    &R_B.row,
    &H.row,
    &ROTARY.row,
    &B_MIN.row,
    &B_MAX.row,
    &X_MIN.row,
    &X_MAX.row,
    &Y_MIN.row,
    &Y_MAX.row,
    &Z_MIN.row,
    &Z_MAX.row,
    &F_MAX.row,
    &fields::RAPID_LINEAR.row,
    &fields::RAPID_ROTARY.row,
    &fields::TOOL_CHANGE.row,
];

pub(super) static D_S: Field<f64, Required> = Field::real(
    "d_s",
    "safety_d_s",
    MM,
    [0.1, 500.0],
    t("Distancia de seguridad", "Safety distance"),
    t("Del filo de la herramienta a la pieza", "From the cutting edge to the part"),
);
pub(super) static F: Field<f64, Optional> = Field::real(
    "F",
    "feed_F",
    Unit::MillimetrePerMinute,
    [0.1, 50_000.0],
    t("Avance de la punta sobre la pieza", "Feed of the tool tip over the part"),
    t(
        "Obligatorio con style = completo; con anexo puede quedar vacía",
        "Required with style = full; with annex it may stay empty",
    ),
);
pub(super) static S: Field<u32, Optional> = Field::whole(
    "S",
    "speed_S",
    Unit::RevolutionPerMinute,
    [1, 200_000],
    t("Velocidad del husillo", "Spindle speed"),
    t(
        "Obligatorio con style = completo; con anexo puede quedar vacía",
        "Required with style = full; with annex it may stay empty",
    ),
);
pub(super) static TOL: Field<f64, Optional> = Field::real(
    "tol",
    "tip_tolerance_tol",
    MM,
    [0.0005, 10.0],
    t("Tolerancia de la trayectoria de la punta entre bloques", "Tolerance of the tip path between blocks"),
    t(
        "Vacía: con method = canal, 0.01 (con 0.0102 el acabado de un libro nuevo cabe en 1 MiB); con publicado el informe da la desviación sin límite",
        "Empty: 0.01 with method = clear (with 0.0102 the finishing program of a new workbook stays below 1 MiB); with published the report gives the deviation without a limit",
    ),
);

const CUTTING: &[&Parameter] = &[&D_S.row, &F.row, &S.row, &TOL.row];

/// The greatest program number: the headers write four digits.
pub(super) const NUMBERS: u32 = 9999;

pub(super) static NUMBER: Field<u32, Required> = Field::whole(
    "program",
    "program_number",
    Unit::Count,
    [1, NUMBERS],
    t("Número de programa", "Program number"),
    t(
        "Va en la cabecera de los programas; con method = canal, el de acabado lleva el siguiente",
        "Goes into the header of the programs; with method = clear the finishing program has the next one",
    ),
);
pub(super) static STYLE: Field<Style, Required> = Field::choice(
    "style",
    "style",
    t("Estilo de los programas", "Style of the programs"),
    t(
        "anexo: como los anexos publicados; completo: con herramienta, avance y fin de programa",
        "annex: as in the published annexes; full: complete",
    ),
);
pub(super) static DISTANCE: Field<Distance, Required> = Field::choice(
    "distance",
    "distance",
    t("Coordenadas: G90 absolutas, G91 incrementales", "Coordinates: G90 absolute, G91 incremental"),
    t(
        "Solo con style = completo; anexo es siempre G91. Con ejes rollover (rotary), solo G91",
        "Only with style = full; annex is always G91. On rollover axes (rotary), G91 only",
    ),
);
pub(super) static START_CODES: Field<Codes, Required> = Field::other(
    "start_codes",
    "start_codes",
    FieldKind::Codes,
    t("Códigos de máquina al empezar", "Machine codes at the start"),
    t(
        "Publicado: M3 M11 M13. M11 y M13 son códigos de fabricante para los frenos de los ejes giratorios de aquella máquina; busque los de la suya en su manual",
        "Published: M3 M11 M13. M11 and M13 are builder's codes for the rotary axis clamps of that machine; look up the codes of yours in its manual",
    ),
);
pub(super) static COOLANT: Field<Codes, Optional> = Field::other(
    "coolant",
    "coolant",
    FieldKind::Codes,
    t("Códigos de refrigerante, antes de cortar", "Coolant codes, before the cut"),
    t("Como M8; vacía: sin refrigerante", "Such as M8; empty: no coolant"),
);
pub(super) static RETRACT: Field<Retract, Optional> = Field::other(
    "retract",
    "retract",
    FieldKind::Block,
    t(
        "Bloque que retira la herramienta antes de que gire ningún eje",
        "Block that retracts the tool before any axis turns",
    ),
    t(
        "Solo con style = completo. G0 G53 Z0 si el cero máquina está en lo alto de Z: compruébelo. Vacía: rodete avisa",
        "Only with style = full. G0 G53 Z0 if machine zero is at the top of Z: check this. Empty: rodete gives a caution",
    ),
);
pub(super) static END_CODES: Field<Codes, Required> = Field::other(
    "end_codes",
    "end_codes",
    FieldKind::Codes,
    t("Códigos de máquina al terminar", "Machine codes at the end"),
    t("Publicado: M30", "Published: M30"),
);
pub(super) static BLOCK_STEP: Field<u32, Required> = Field::whole(
    "block_step",
    "block_step",
    Unit::Count,
    [1, 1000],
    t("Paso de la numeración de bloques", "Increment of the block numbers"),
    t("Publicado: 10", "Published: 10"),
);

const PROGRAM: &[&Parameter] = &[
    &PART.row,
    &MATERIAL.row,
    &NUMBER.row,
    &DIALECT.row,
    &STYLE.row,
    &DISTANCE.row,
    &START_CODES.row,
    &COOLANT.row,
    &RETRACT.row,
    &END_CODES.row,
    &BLOCK_STEP.row,
];

pub(super) static C: Field<f64, Required> = Field::real(
    "C",
    "blank_step_C",
    MM,
    [0.01, 20.0],
    t("Paso C del ciclo G85, en Z, y demasía de refrentado", "Step C of the G85 cycle, along Z, and facing allowance"),
    t("Publicado: 1", "Published: 1"),
);
pub(super) static F_B: Field<f64, Required> = Field::real(
    "F_b",
    "blank_feed_F_b",
    Unit::MillimetrePerRevolution,
    [0.001, 5.0],
    t("Avance en el torno", "Lathe feed"),
    t("Publicado: 0.1", "Published: 0.1"),
);
pub(super) static S_B: Field<u32, Required> = Field::whole(
    "S_b",
    "blank_speed_S_b",
    Unit::MetrePerMinute,
    [1, 5000],
    t("Velocidad de corte constante del torno", "Constant surface speed of the lathe"),
    t("Publicado: 300", "Published: 300"),
);
pub(super) static S_M: Field<u32, Optional> = Field::whole(
    "S_m",
    "blank_speed_limit_S_m",
    Unit::RevolutionPerMinute,
    [1, 20_000],
    t("Límite de giro del husillo del torno", "Speed limit of the lathe spindle"),
    t(
        "Con velocidad de corte constante el husillo se acelera hacia el centro. Solo con style = completo. Vacía: sin límite",
        "At constant surface speed the spindle speeds up towards the centre. Only with style = full. Empty: no limit",
    ),
);
pub(super) static T_B: Field<u32, Required> =
    Field::whole("T_b", "blank_tool_T_b", Unit::Count, [1, 9999], t("Herramienta del torno", "Lathe tool"), t("", ""));
pub(super) static D_B: Field<u32, Required> = Field::whole(
    "D_b",
    "blank_tool_offset_D_b",
    Unit::Count,
    [1, 999],
    t("Corrector del torno", "Lathe tool offset"),
    t("", ""),
);
pub(super) static L_B: Field<f64, Required> = Field::real(
    "L_b",
    "blank_length_L_b",
    MM,
    [1.0, 5000.0],
    t("Longitud del bruto", "Stock length"),
    t("Mayor que r; diámetro 2·R", "Larger than r; diameter 2·R"),
);
pub(super) static Z_B: Field<f64, Required> = Field::real(
    "Z_b",
    "blank_start_Z_b",
    MM,
    [1.0, 5000.0],
    t("Z de aproximación", "Approach Z"),
    t("Publicado: 50", "Published: 50"),
);
pub(super) static C_F: Field<f64, Required> = Field::real(
    "c_f",
    "blank_facing_c_f",
    MM,
    [0.1, 100.0],
    t("Holgura en diámetro al refrentar", "Clearance on the diameter for facing"),
    t("Publicado: 1", "Published: 1"),
);
pub(super) static C_O: Field<f64, Required> = Field::real(
    "c_o",
    "blank_overrun_c_o",
    MM,
    [0.0, 10.0],
    t("Rebase del centro al refrentar, en diámetro", "Overrun past the centre when facing, on the diameter"),
    t("Publicado: 0.4", "Published: 0.4"),
);
pub(super) static C_C: Field<f64, Required> = Field::real(
    "c_c",
    "blank_cycle_c_c",
    MM,
    [0.1, 100.0],
    t("Holgura en diámetro antes del ciclo", "Clearance on the diameter before the cycle"),
    t("Publicado: 5", "Published: 5"),
);
pub(super) static X_E: Field<f64, Optional> = Field::real(
    "X_e",
    "blank_end_X_e",
    MM,
    [1.0, 5000.0],
    t("X final, en diámetro", "End X, on the diameter"),
    t("Mayor que 2·R; vacía: 2·R + 30. Publicado: 80", "Larger than 2·R; empty: 2·R + 30. Published: 80"),
);
pub(super) static Z_E: Field<f64, Required> =
    Field::real("Z_e", "blank_end_Z_e", MM, [1.0, 5000.0], t("Z final", "End Z"), t("Publicado: 80", "Published: 80"));

const BLANK: &[&Parameter] = &[
    &C.row, &F_B.row, &S_B.row, &S_M.row, &T_B.row, &D_B.row, &L_B.row, &Z_B.row, &C_F.row, &C_O.row, &C_C.row,
    &X_E.row, &Z_E.row,
];

pub(super) static CALIBRATION_H: Field<f64, WithSheet> = Field::real(
    "calibration/H",
    "calibration_H",
    MM,
    [0.0, 5000.0],
    t("Altura de la pieza sobre el husillo", "Height of the part above the spindle"),
    t("De la nariz del husillo a la cara del extremo", "From the spindle nose to the end face"),
);
pub(super) static CALIBRATION_D_W: Field<f64, WithSheet> = Field::real(
    "calibration/d_w",
    "calibration_d_w",
    MM,
    [0.0, 5000.0],
    t("Anchura de la pieza por su centro", "Width of the part through its centre"),
    t("De lado a lado, por el eje de C", "From side to side, through the axis of C"),
);
pub(super) static CALIBRATION_E_Z: Field<f64, WithSheet> = Field::real(
    "calibration/e_z",
    "calibration_e_z",
    MM,
    [-1000.0, 1000.0],
    t("Profundidad de la ranura en Z", "Depth of the slot in Z"),
    t("Desde el lado que queda arriba con B = 90°", "From the side that is up at B = 90°"),
);
pub(super) static CALIBRATION_E_X: Field<f64, WithSheet> = Field::real(
    "calibration/e_x",
    "calibration_e_x",
    MM,
    [-1000.0, 1000.0],
    t("Profundidad de la ranura en X", "Depth of the slot in X"),
    t("Desde la cara del extremo", "From the end face"),
);
pub(super) static CALIBRATION_D_T: Field<f64, WithSheet> = Field::real(
    "calibration/d_t",
    "calibration_d_t",
    MM,
    [0.2, 100.0],
    t("Diámetro de la herramienta", "Tool diameter"),
    t("", ""),
);
pub(super) static CALIBRATION_X0: Field<f64, WithSheet> = Field::real(
    "calibration/x0",
    "calibration_x0",
    MM,
    TRAVEL,
    t("X programada con B = 90°", "X programmed at B = 90°"),
    t("Centro de la herramienta, con X0 en el eje de C", "Centre of the tool, with X0 on the axis of C"),
);
pub(super) static CALIBRATION_Z0: Field<f64, WithSheet> = Field::real(
    "calibration/z0",
    "calibration_z0",
    MM,
    TRAVEL,
    t("Z programada con B = 90°", "Z programmed at B = 90°"),
    t(
        "Punta de la herramienta, con Z0 en la cara del extremo a B = 0°",
        "Tip of the tool, with Z0 on the end face at B = 0°",
    ),
);

const CALIBRATION: &[&Parameter] = &[
    &CALIBRATION_H.row,
    &CALIBRATION_D_W.row,
    &CALIBRATION_E_Z.row,
    &CALIBRATION_E_X.row,
    &CALIBRATION_D_T.row,
    &CALIBRATION_X0.row,
    &CALIBRATION_Z0.row,
];

/// The impeller workbook.
pub static FORM: Form = Form {
    kind: "impeller",
    schema: SCHEMA,
    earlier: &[Earlier {
        schema: "rodete-impeller 1",
        renamed: &[(R_B.key(), "R_p"), (H.key(), "L_t")],
        told: |place| HeightCalledLength {}.at(place),
    }],
    part: &PART,
    material: Some(&MATERIAL),
    programs: &Operation::KEYS,
    sheets: &[
        Sheet {
            name: t("DATOS", "DATA"),
            title: t("Parámetros de diseño del rodete", "Design parameters of the impeller"),
            optional: false,
            sections: &[
                Section { title: t("Esquema", "Schema"), parameters: &[&fields::SCHEMA.row], optional: false },
                Section { title: t("Geometría", "Geometry"), parameters: GEOMETRY, optional: false },
                Section { title: t("Herramienta", "Tool"), parameters: TOOL, optional: false },
                Section { title: t("Método de corte", "Method of cutting"), parameters: cut::CELLS, optional: false },
                Section { title: t("Máquina", "Machine"), parameters: MACHINE, optional: false },
                Section { title: t("Corte", "Cutting"), parameters: CUTTING, optional: false },
                Section { title: t("Programa", "Program"), parameters: PROGRAM, optional: false },
                Section { title: t("Torneado del bruto", "Turning of the blank"), parameters: BLANK, optional: false },
                title_block::SECTION,
            ],
        },
        Sheet {
            name: t("CALIBRACION", "CALIBRATION"),
            title: t("Calibración del eje B", "Calibration of the B axis"),
            optional: true,
            sections: &[Section {
                title: t("Ranuras de prueba", "Test slots"),
                parameters: CALIBRATION,
                optional: false,
            }],
        },
    ],
    ..Form::PLAIN
};
