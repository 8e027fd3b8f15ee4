//! The form of the impeller workbook: every parameter with its meaning, unit, limits and note.
//!
//! Source: the design parameters of the thesis (its section 4.4.1, first group of cells), the machine (section 4.2 and
//! 5.2), the turning of the blank (section 4.1); what the source leaves to the operator (feed, speed, dialect, travel)
//! is added here. Limits are those of the machines the method is meant for; they catch metres typed for millimetres.

use crate::kinds::impeller::cases::CASES;
use crate::parameter::{Choice, DIALECTS, Earlier, FieldKind, Form, Parameter, Section, Sheet, other, real, t, whole};
use crate::table::Unit;
use crate::text::Text;

/// Name and version of the form.
pub const SCHEMA: &str = "rodete-impeller 2";

const YES_NO: &[Choice] = &[Choice { key: "yes", label: t("sí", "yes") }, Choice { key: "no", label: t("no", "no") }];

const STYLES: &[Choice] =
    &[Choice { key: "annex", label: t("annex", "annex") }, Choice { key: "full", label: t("full", "full") }];

const FADES: &[Choice] = &[
    Choice { key: "published", label: t("published", "published") },
    Choice { key: "each-side", label: t("each-side", "each-side") },
];

const DISTANCES: &[Choice] =
    &[Choice { key: "G90", label: t("G90", "G90") }, Choice { key: "G91", label: t("G91", "G91") }];

const ROTARIES: &[Choice] = &[
    Choice { key: "rollover", label: t("rollover", "rollover") },
    Choice { key: "linear", label: t("linear", "linear") },
];

const MM: Unit = Unit::Millimetre;
const TRAVEL: [f64; 2] = [-10_000.0, 10_000.0];
const TRAVEL_NOTE: Text =
    t("En coordenadas de programa; vacío: no se comprueba", "In program coordinates; empty: not checked");

const GEOMETRY: &[Parameter] = &[
    real(
        "R",
        "torus_R",
        MM,
        [5.0, 1000.0],
        true,
        t("Radio del toro, del eje al centro del meridiano", "Torus radius, axis to the centre of the meridian"),
        t("Mayor que r", "Greater than r"),
    ),
    real(
        "r",
        "meridian_r",
        MM,
        [1.0, 900.0],
        true,
        t("Radio del meridiano del toro", "Radius of the torus's meridian"),
        t("Menor que R", "Less than R"),
    ),
    whole(
        "n",
        "intervals_n",
        Unit::Count,
        [2, 100_000],
        true,
        t("Número de intervalos de la discretización", "Number of intervals of the discretisation"),
        t("n + 1 puntos por pasada", "n + 1 points a pass"),
    ),
    real(
        "eps_v",
        "end_backoff_eps_v",
        Unit::Step,
        [0.0, 0.5],
        true,
        t("Retroceso del último punto, en pasos", "Back-off of the last point, in steps"),
        t(
            "0: llega al final; 1e-5: como los anexos publicados",
            "0: up to the very end; 1e-5: as in the published annexes",
        ),
    ),
    whole(
        "N",
        "blades_N",
        Unit::Count,
        [1, 60],
        true,
        t("Número de álabes", "Number of blades"),
        t("No mayor que N_max", "Not above N_max"),
    ),
    real(
        "e",
        "thickness_e",
        MM,
        [0.05, 100.0],
        true,
        t("Espesor del álabe", "Blade thickness"),
        t("No mayor que e_max", "Not above e_max"),
    ),
    real(
        "a_p",
        "depth_a_p",
        MM,
        [0.01, 100.0],
        true,
        t("Profundidad de mecanizado", "Depth of cut"),
        t("Menor que R − r", "Less than R − r"),
    ),
    other(
        "splitters",
        "splitters",
        FieldKind::Choice(YES_NO),
        true,
        t("Álabes intermedios", "Splitter blades"),
        t("sí o no", "yes or no"),
    ),
    other(
        "splitter_fade",
        "splitter_fade",
        FieldKind::Choice(FADES),
        false,
        t("Cómo nacen los álabes intermedios", "How splitter blades begin"),
        t(
            "each-side: la herramienta libra a los álabes vecinos; published, o vacío: como se publicó, los corta",
            "each-side: the tool clears the neighbouring blades; published, or empty: as published, it cuts into them",
        ),
    ),
];

const TOOL: &[Parameter] = &[
    real(
        "d_t",
        "tool_diameter_d_t",
        MM,
        [0.2, 100.0],
        true,
        t("Diámetro de la herramienta", "Tool diameter"),
        t("Fresa cilíndrica frontal; no mayor que 2·r", "Flat end mill; not above 2·r"),
    ),
    whole("T", "tool_T", Unit::Count, [1, 9999], true, t("Número de herramienta", "Tool number"), t("", "")),
    whole("D", "tool_offset_D", Unit::Count, [1, 999], true, t("Número de corrector", "Tool offset number"), t("", "")),
];

const MACHINE: &[Parameter] = &[
    real(
        "R_B",
        "spindle_height_R_B",
        MM,
        [1.0, 5000.0],
        true,
        t(
            "Altura de la nariz del husillo portapieza sobre el eje de giro B",
            "Height of the work spindle's nose over the B axis of rotation",
        ),
        t("De la calibración", "From the calibration"),
    ),
    real(
        "H",
        "height_H",
        MM,
        [1.0, 1000.0],
        true,
        t(
            "Altura de la cara torneada, el plano del centro del toro, sobre la nariz del husillo portapieza",
            "Height of the turned face, the torus centre plane, over the work spindle's nose",
        ),
        t(
            "L = R_B + H; no es la longitud de la herramienta, que solo entra en el cero o el corrector de Z",
            "L = R_B + H; no tool length, which enters the zero or the length offset of Z alone",
        ),
    ),
    other(
        "rotary",
        "rotary_axes",
        FieldKind::Choice(ROTARIES),
        false,
        t("Cómo cuentan los ejes B y C de la máquina en G90", "How the machine's axes B and C count in G90"),
        t(
            "rollover: de 0 a 360, el signo es el sentido (un Fagor 8055 de fábrica; así si queda vacía); linear: como un eje lineal",
            "rollover: from 0 to 360, the sign is the direction (a Fagor 8055 as delivered; so if empty); linear: as a linear axis",
        ),
    ),
    real(
        "B_min",
        "B_min",
        Unit::Degree,
        [-360.0, 360.0],
        true,
        t("Límite inferior de B", "Lower limit of B"),
        t("Menor que B_max", "Less than B_max"),
    ),
    real(
        "B_max",
        "B_max",
        Unit::Degree,
        [-360.0, 360.0],
        true,
        t("Límite superior de B", "Upper limit of B"),
        t("Mayor que B_min", "Greater than B_min"),
    ),
    real("X_min", "X_min", MM, TRAVEL, false, t("Límite inferior de X", "Lower limit of X"), TRAVEL_NOTE),
    real("X_max", "X_max", MM, TRAVEL, false, t("Límite superior de X", "Upper limit of X"), TRAVEL_NOTE),
    real("Y_min", "Y_min", MM, TRAVEL, false, t("Límite inferior de Y", "Lower limit of Y"), TRAVEL_NOTE),
    real("Y_max", "Y_max", MM, TRAVEL, false, t("Límite superior de Y", "Upper limit of Y"), TRAVEL_NOTE),
    real("Z_min", "Z_min", MM, TRAVEL, false, t("Límite inferior de Z", "Lower limit of Z"), TRAVEL_NOTE),
    real("Z_max", "Z_max", MM, TRAVEL, false, t("Límite superior de Z", "Upper limit of Z"), TRAVEL_NOTE),
    real(
        "F_max",
        "feed_limit_F_max",
        Unit::MillimetrePerMinute,
        [1.0, 200_000.0],
        false,
        t("Velocidad máxima de cada eje (°/min en B y C)", "Greatest speed of any axis (°/min in B and C)"),
        t("Vacío: no se comprueba", "Empty: not checked"),
    ),
];

const CUTTING: &[Parameter] = &[
    real(
        "d_s",
        "safety_d_s",
        MM,
        [0.1, 500.0],
        true,
        t("Distancia de seguridad", "Safety distance"),
        t("Del filo de la herramienta a la pieza", "From the tool's edge to the part"),
    ),
    real(
        "F",
        "feed_F",
        Unit::MillimetrePerMinute,
        [0.1, 50_000.0],
        false,
        t("Avance de la punta sobre la pieza", "Feed of the tool tip over the part"),
        t("Obligatorio con style = full", "Required with style = full"),
    ),
    whole(
        "S",
        "speed_S",
        Unit::RevolutionPerMinute,
        [1, 200_000],
        false,
        t("Velocidad del husillo", "Spindle speed"),
        t("Obligatorio con style = full", "Required with style = full"),
    ),
    real(
        "tol",
        "tip_tolerance_tol",
        MM,
        [0.0005, 10.0],
        false,
        t("Tolerancia de la trayectoria de la punta entre bloques", "Tolerance of the tip path between blocks"),
        t("Vacío: la desviación solo se informa", "Empty: the deviation is reported only"),
    ),
];

const PROGRAM: &[Parameter] = &[
    other("part", "part", FieldKind::Line { max: 200 }, true, t("Pieza", "Part"), t("", "")),
    other("material", "material", FieldKind::Line { max: 200 }, false, t("Material", "Material"), t("", "")),
    whole(
        "program",
        "program_number",
        Unit::Count,
        [1, 9999],
        true,
        t("Número de programa", "Program number"),
        t("En la cabecera de los programas", "In the programs' header"),
    ),
    other(
        "dialect",
        "dialect",
        FieldKind::Choice(DIALECTS),
        true,
        t("Dialecto del control", "Dialect of the control"),
        t("", ""),
    ),
    other(
        "style",
        "style",
        FieldKind::Choice(STYLES),
        true,
        t("Estilo de los programas", "Style of the programs"),
        t("annex: como los anexos publicados; full: completo", "annex: as in the published annexes; full: complete"),
    ),
    other(
        "distance",
        "distance",
        FieldKind::Choice(DISTANCES),
        true,
        t("Coordenadas: G90 absolutas, G91 incrementales", "Coordinates: G90 absolute, G91 incremental"),
        t(
            "Sólo con style = full; annex es siempre G91. En un Fagor 8055, G90 sólo con rotary = linear",
            "With style = full only; annex is always G91. On a Fagor 8055, G90 only with rotary = linear",
        ),
    ),
    other(
        "start_codes",
        "start_codes",
        FieldKind::Codes,
        true,
        t("Códigos de máquina al empezar", "Machine codes at the start"),
        t(
            "Publicado: M3 M11 M13. M11 y M13: códigos del fabricante de la máquina publicada para los frenos de sus ejes giratorios; véalos en el manual de la suya",
            "Published: M3 M11 M13. M11 and M13: codes of the published machine's builder for the clamps of its rotary axes; look up those of yours",
        ),
    ),
    other(
        "coolant",
        "coolant",
        FieldKind::Codes,
        false,
        t("Códigos de refrigerante, antes de cortar", "Codes for coolant, before the cut"),
        t("Como M8; vacía: sin refrigerante", "Such as M8; empty: no coolant"),
    ),
    other(
        "retract",
        "retract",
        FieldKind::Block,
        false,
        t(
            "Bloque que retira la herramienta antes de que gire nada",
            "Block that takes the tool away before anything turns",
        ),
        t(
            "Sólo con style = full. G0 G53 Z0 si el cero de máquina está en lo alto de Z: compruébelo. Vacía: se avisa",
            "With style = full only. G0 G53 Z0 if machine zero is at the top of Z: check that. Empty: a caution",
        ),
    ),
    other(
        "end_codes",
        "end_codes",
        FieldKind::Codes,
        true,
        t("Códigos de máquina al terminar", "Machine codes at the end"),
        t("Publicado: M30", "Published: M30"),
    ),
    whole(
        "block_step",
        "block_step",
        Unit::Count,
        [1, 1000],
        true,
        t("Paso de la numeración de bloques", "Step of the block numbers"),
        t("Publicado: 10", "Published: 10"),
    ),
];

const BLANK: &[Parameter] = &[
    real(
        "C",
        "blank_step_C",
        MM,
        [0.01, 20.0],
        true,
        t("Paso C del ciclo G85, en radios", "Step C of the G85 cycle, on the radius"),
        t("Publicado: 1", "Published: 1"),
    ),
    real(
        "F_b",
        "blank_feed_F_b",
        Unit::MillimetrePerRevolution,
        [0.001, 5.0],
        true,
        t("Avance del torno", "Feed of the lathe"),
        t("Publicado: 0.1", "Published: 0.1"),
    ),
    whole(
        "S_b",
        "blank_speed_S_b",
        Unit::MetrePerMinute,
        [1, 5000],
        true,
        t("Velocidad de corte constante del torno", "Constant surface speed of the lathe"),
        t("Publicado: 300", "Published: 300"),
    ),
    whole(
        "S_m",
        "blank_speed_limit_S_m",
        Unit::RevolutionPerMinute,
        [1, 20_000],
        false,
        t("Límite de velocidad del husillo del torno", "Limit of the lathe's spindle speed"),
        t(
            "Con velocidad de corte constante el husillo se acelera hacia el centro; solo con style = full",
            "Under constant surface speed the spindle speeds up towards the centre; with style = full only",
        ),
    ),
    whole(
        "T_b",
        "blank_tool_T_b",
        Unit::Count,
        [1, 9999],
        true,
        t("Herramienta del torno", "Tool of the lathe"),
        t("", ""),
    ),
    whole(
        "D_b",
        "blank_tool_offset_D_b",
        Unit::Count,
        [1, 999],
        true,
        t("Corrector del torno", "Tool offset of the lathe"),
        t("", ""),
    ),
    real(
        "L_b",
        "blank_length_L_b",
        MM,
        [1.0, 5000.0],
        true,
        t("Longitud del bruto", "Length of the stock"),
        t("Mayor que r; diámetro 2·R", "Greater than r; diameter 2·R"),
    ),
    real(
        "Z_b",
        "blank_start_Z_b",
        MM,
        [1.0, 5000.0],
        true,
        t("Z de aproximación", "Approach Z"),
        t("Publicado: 50", "Published: 50"),
    ),
    real(
        "c_f",
        "blank_facing_c_f",
        MM,
        [0.1, 100.0],
        true,
        t("Holgura en diámetro al refrentar", "Clearance on the diameter for facing"),
        t("Publicado: 1", "Published: 1"),
    ),
    real(
        "c_o",
        "blank_overrun_c_o",
        MM,
        [0.0, 10.0],
        true,
        t("Rebase del centro al refrentar, en diámetro", "Overrun past the centre when facing, on the diameter"),
        t("Publicado: 0.4", "Published: 0.4"),
    ),
    real(
        "c_c",
        "blank_cycle_c_c",
        MM,
        [0.1, 100.0],
        true,
        t("Holgura en diámetro antes del ciclo", "Clearance on the diameter before the cycle"),
        t("Publicado: 5", "Published: 5"),
    ),
    real(
        "X_e",
        "blank_end_X_e",
        MM,
        [1.0, 5000.0],
        true,
        t("X final, en diámetro", "End X, on the diameter"),
        t("Publicado: 80; mayor que 2·R", "Published: 80; greater than 2·R"),
    ),
    real("Z_e", "blank_end_Z_e", MM, [1.0, 5000.0], true, t("Z final", "End Z"), t("Publicado: 80", "Published: 80")),
];

const CALIBRATION: &[Parameter] = &[
    real(
        "calibration/H",
        "calibration_H",
        MM,
        [0.0, 5000.0],
        true,
        t("Altura de la pieza sobre el husillo", "Height of the part above the spindle"),
        t("", ""),
    ),
    real(
        "calibration/d_w",
        "calibration_d_w",
        MM,
        [0.0, 5000.0],
        true,
        t("Anchura de la pieza por su centro", "Width of the part through its centre"),
        t("", ""),
    ),
    real(
        "calibration/e_z",
        "calibration_e_z",
        MM,
        [-1000.0, 1000.0],
        true,
        t("Profundidad de la ranura en Z", "Depth of the slot in Z"),
        t("", ""),
    ),
    real(
        "calibration/e_x",
        "calibration_e_x",
        MM,
        [-1000.0, 1000.0],
        true,
        t("Profundidad de la ranura en X", "Depth of the slot in X"),
        t("", ""),
    ),
    real(
        "calibration/d_t",
        "calibration_d_t",
        MM,
        [0.2, 100.0],
        true,
        t("Diámetro de la herramienta", "Tool diameter"),
        t("", ""),
    ),
    real(
        "calibration/x0",
        "calibration_x0",
        MM,
        TRAVEL,
        true,
        t("X programada con B = 90°", "X programmed at B = 90°"),
        t("", ""),
    ),
    real(
        "calibration/z0",
        "calibration_z0",
        MM,
        TRAVEL,
        true,
        t("Z programada con B = 90°", "Z programmed at B = 90°"),
        t("", ""),
    ),
];

/// The impeller workbook.
pub static FORM: Form = Form {
    kind: "impeller",
    schema: SCHEMA,
    earlier: &[Earlier {
        schema: "rodete-impeller 1",
        renamed: &[("R_B", "R_p"), ("H", "L_t")],
        meaning: t(
            "el libro es del esquema 1, que llamaba longitud de herramienta L_t a la altura H de la cara torneada sobre la nariz del husillo portapieza, y R_p a R_B: aquí L_t se lee como H y L = R_p + L_t. Si en L_t está la longitud de una herramienta, los programas son falsos",
            "the workbook is of schema 1, which called the height H of the turned face over the work spindle's nose a tool length L_t, and R_B it called R_p: L_t is read as H here, and L = R_p + L_t. If L_t holds the length of a tool, the programs are wrong",
        ),
        remedy: t(
            "mida H y compruébela; haga un libro nuevo con \"rodete new\" y escriba en él los valores",
            "measure H and compare; make a new workbook with \"rodete new\" and type the values there",
        ),
    }],
    cases: &CASES,
    programs: &["blade", "splitter", "impeller", "blank"],
    drawings: &[],
    solids: &[],
    sheets: &[
        Sheet {
            name: t("DATOS", "DATA"),
            title: t("Parámetros de diseño del rodete", "Design parameters of the impeller"),
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
                Section { title: t("Geometría", "Geometry"), parameters: GEOMETRY },
                Section { title: t("Herramienta", "Tool"), parameters: TOOL },
                Section { title: t("Máquina", "Machine"), parameters: MACHINE },
                Section { title: t("Corte", "Cutting"), parameters: CUTTING },
                Section { title: t("Programa", "Program"), parameters: PROGRAM },
                Section { title: t("Torneado del bruto", "Turning of the blank"), parameters: BLANK },
            ],
        },
        Sheet {
            name: t("CALIBRACION", "CALIBRATION"),
            title: t("Calibración del eje B", "Calibration of the B axis"),
            optional: true,
            sections: &[Section { title: t("Ranuras de prueba", "Test slots"), parameters: CALIBRATION }],
        },
    ],
    lists: &[],
};
