//! Fagor CNC 8055 M: what it has beside [what Fagor's controls share](super::fagor).

use crate::gcode::code::{G, Group, M};
use crate::gcode::control::codes::{BY_MODE, COMMON};
use crate::gcode::control::fagor::{BASE, BOTH_8055, CYCLE, DWELL, FAGOR, FRAME, LEXIS, MILLS, TRANSFORMATION};
use crate::gcode::control::{
    Cancel, Codes, Control, HeightHold, Lexis, LoneDwell, MachineZero, Post, Source, ToolBlocks, Writing, fagor,
};
use crate::text::{Text, t};

/// Fagor CNC 8055, milling.
pub static FAGOR_8055: Control = Control {
    name: "fagor-8055",
    sources: &[
        Source::Manual(t(
            "Fagor Automation, CNC 8055 M, manual de programación: lista de funciones G; cabecera %nombre,MX--,; comentario ;, ninguna línea vacía; orden de un bloque G, ejes, F, S, T, D, M; números ±5.4; N de 0 a 99999999; G70 pulgadas y G71 milímetros; G43 y G44; G94, F a lo largo de la resultante de los ejes, los grados como milímetros",
            "Fagor Automation, CNC 8055 M, programming manual: list of G functions; header %name,MX--,; comment ;, no empty lines; order of a block G, axes, F, S, T, D, M; numbers ±5.4; N 0 to 99999999; G70 inch and G71 millimetre; G43 and G44; G94, F along the resultant of the axes, degrees taken as millimetres",
        )),
        Source::Manual(t(
            "Fagor Automation, CNC 8055 M, solución de errores (Ref. 1310), errores 0054 y 1085: en un arco de G17 K es el paso de una hélice, siempre positivo; 0002 a 0004, 0009, 0012 y 0048: orden G, ejes X Y Z U V W A B C, F S T D, M (manual de programación, p. 47 y 65)",
            "Fagor Automation, CNC 8055 M, error solution (Ref. 1310), errors 0054 and 1085: in an arc of G17 K is the pitch of a helix, always positive; 0002 to 0004, 0009, 0012 and 0048: order G, axes X Y Z U V W A B C, F S T D, M (programming manual, p. 47 and 65)",
        )),
        Source::Manual(t(
            "Fagor Automation, CNC 8055 M, manual de programación, p. 144: G43 cuenta desde el siguiente movimiento del eje longitudinal, con L y K del corrector D, o del de la herramienta sin D; G44 la anula; p. 109: G4 sola para la preparación de bloques y anula la compensación de radio y de longitud en vigor; 5.7.8 y 5.7.9: M41 a M44 y M45",
            "Fagor Automation, CNC 8055 M, programming manual, p. 144: G43 counts from the next motion of the longitudinal axis, with L and K of offset D, or of the tool's own without D; G44 cancels it; p. 109: G4 alone stops the preparation of blocks and cancels the compensation of radius and length in force; 5.7.8 and 5.7.9: M41 to M44 and M45",
        )),
        Source::Manual(t(
            "Fagor Automation, CNC 8055 M, solución de errores (Ref. 1310), errores 0013, 0016, 0017, 0025, 0029 a 0036, 0116, 0200, 0213 y 1029: G15, G16, G28 a G30, G52, G60 a G68, G77, G78, G159; manual de programación, p. 419: G47 a G49; p. 88: I, J y K en el orden de sus ejes; errores 0007 y 0028: un ciclo corre con G0 o G1 activa; manual de ejemplos (Ref. 1010): tras G80 se mueve sin código de movimiento",
            "Fagor Automation, CNC 8055 M, error solution (Ref. 1310), errors 0013, 0016, 0017, 0025, 0029 to 0036, 0116, 0200, 0213 and 1029: G15, G16, G28 to G30, G52, G60 to G68, G77, G78, G159; programming manual, p. 419: G47 to G49; p. 88: I, J and K in the order of their axes; errors 0007 and 0028: a cycle runs with G0 or G1 active; examples manual (Ref. 1010): behind G80 a block moves without a motion code",
        )),
        FRAME,
        DWELL,
    ],
    lexis: Lexis { lone_dwell: LoneDwell::StopsPreparation, ..LEXIS },
    machine_code,
    cancel: Cancel::RestoresMotion,
    codes: &CODES,
    written: Some(&WRITING),
    ..BASE
};

/// How rodete writes for the 8055 M.
static WRITING: Writing = Writing {
    safety: &[('G', 17), ('G', 40), ('G', 44), ('G', 54), ('G', 71), ('G', 90), ('G', 94)],
    tool: ToolBlocks::OffsetThenChange,
    height: HeightHold::Builder,
    clamps: &[11, 13],
    zero: MachineZero::Assumed,
};

/// The Fagor 8055 as rodete writes for it.
pub const POST_8055: Post = Post { control: &FAGOR_8055, writing: &WRITING };

static CODES: Codes = Codes::new(&[
    COMMON,
    BY_MODE,
    FAGOR,
    BOTH_8055,
    MILLS,
    &[
        (&[150], G::Refused(Group::Plane, &LONGITUDINAL)),
        (&[160], G::Refused(Group::Plane, &PLANE_OF_AXES)),
        (&[280, 290], G::Refused(Group::Other, &SECOND_SPINDLE)),
        (&[300], G::Refused(Group::Other, &SPINDLE_ANGLE)),
        (&[320], G::Refused(Group::Feed, &INVERSE)),
        (&[430], G::ToolLength),
        (&[440], G::ToolLengthOff),
        (&[480, 490], G::Refused(Group::Other, &TRANSFORMATION)),
        (&[470], G::Refused(Group::Other, &TOOL_AXIS)),
        (&[520], G::Refused(Group::NonModal, &HARD_STOP)),
        (&[600, 610, 620, 630, 640, 650], G::Refused(Group::Motion, &MULTIPLE)),
        (&[660, 670, 680], G::Refused(Group::Motion, &ISLANDS)),
        (&[690, 790], G::Refused(Group::Motion, &CYCLE)),
        (&[770, 780], G::Refused(Group::Other, &COUPLING)),
        (&[1590], G::Refused(Group::WorkOffset, &TABLE_OFFSETS)),
        (&[960], G::Refused(Group::Speed, &CUTTING_POINT)),
        (&[970], G::PathControl),
    ],
]);

/// The 8055 M names some codes that the other two leave to the machine's builder.
fn machine_code(number: u32) -> Option<M> {
    match number {
        41..=44 => Some(M::NotFollowed(&GEAR)),
        45 => Some(M::NotFollowed(&LIVE_TOOL)),
        _ => fagor::machine_code(number),
    }
}

static CUTTING_POINT: Text = t("avance constante del punto de corte", "constant feed of the cutting point");
static INVERSE: Text = t("avance como inversa del tiempo", "feed as inverse of the time");
static LONGITUDINAL: Text = t("elección del eje longitudinal", "choice of the longitudinal axis");
static PLANE_OF_AXES: Text = t("plano de dos ejes", "plane of two axes");
static SECOND_SPINDLE: Text = t("segundo husillo, o intercambio de ejes", "second spindle, or exchange of axes");
static SPINDLE_ANGLE: Text = t("desfase de husillos sincronizados", "angle between synchronised spindles");
static TOOL_AXIS: Text = t("movimiento según el eje de la herramienta", "motion along the tool's axis");
static HARD_STOP: Text = t("movimiento contra tope", "motion against a hard stop");
static MULTIPLE: Text = t("mecanizado múltiple", "multiple machining");
static ISLANDS: Text = t("cajeras con islas", "pockets with islands");
static COUPLING: Text = t("ejes o husillos acoplados", "coupled axes or spindles");
static TABLE_OFFSETS: Text = t("traslados de origen de la tabla, con N", "work offsets of the table, by N");
static GEAR: Text = t("gama de velocidad del husillo", "speed range of the spindle");
static LIVE_TOOL: Text = t("herramienta motorizada, con S propia", "live tool, with an S of its own");
