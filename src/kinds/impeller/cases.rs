//! The cases that a new impeller workbook can start from.

use crate::gcode::chosen::Codes;
use crate::gcode::control::{POST_8055, RotaryMode};
use crate::gcode::fields;
use crate::gcode::program::Style;
use crate::gcode::word::{Distance, Retract, Word};
use crate::kinds::impeller::clear::fields::{self as cut, Method};
use crate::kinds::impeller::fade::Fade;
use crate::kinds::impeller::parameters::{
    A_P, B_MAX, B_MIN, BLOCK_STEP, C, C_C, C_F, C_O, D, D_B, D_S, D_T, DIALECT, DISTANCE, E, END_CODES, EPS_V, F, F_B,
    F_MAX, H, INTERVALS_N, L_B, MATERIAL, MERIDIAN_R, N, NUMBER, PART, R, R_B, RETRACT, ROTARY, S, S_B, S_M, SCHEMA,
    SPLITTER_FADE, SPLITTERS, START_CODES, STYLE, T, T_B, TOL, X_E, Z_B, Z_E,
};
use crate::number::grid::Milli;
use crate::parameter::{Case, Cell};
use crate::text::{Language, t};

/// The cases that a new workbook can start from, the usual one first.
pub static CASES: [Case; 3] = [
    Case::new(
        "clear",
        t(
            "Un rodete de 50 mm, cortado como se diseñó: desbaste con una fresa de 6 mm y acabado con una de 3 mm, con todo el canal, fondo, caras y álabes intermedios. F, S, F_f, S_f, F_max y los rápidos G_lin y G_rot están elegidos para aluminio (113 m/min con las dos fresas; con dos dientes, 0.025 mm por diente al desbastar y 0.0125 al acabar): compruébelos para su máquina.",
            "An impeller of 50 mm, cut as designed: roughing with a 6 mm and finishing with a 3 mm end mill, the whole channel, floor, faces and splitters. F, S, F_f, S_f, F_max and the rapid rates G_lin and G_rot are chosen for aluminium (113 m/min with both tools; with two teeth, 0.025 mm per tooth in roughing and 0.0125 in finishing): check them for your machine.",
        ),
        clear,
    ),
    Case::new(
        "full",
        t(
            "La misma pieza por el método publicado, con programas completos y álabes intermedios cuyas pasadas libran a sus vecinos. F, S, F_max y los rápidos G_lin y G_rot están elegidos para una fresa de 6 mm en aluminio (113 m/min, 0.025 mm por diente con dos dientes): compruébelos para su máquina.",
            "The same part by the published method, with complete programs and splitters whose passes clear their neighbours. F, S, F_max and the rapid rates G_lin and G_rot are chosen for a 6 mm end mill in aluminium (113 m/min, 0.025 mm per tooth with two teeth): check them for your machine.",
        ),
        full,
    ),
    Case::new(
        "tfg-2021",
        t(
            "El caso publicado (UPCT, 2021). Las tablas fijan e + d_t = 8 y d_s + d_t/2 = 8; aquí d_t = 6, e = 2, d_s = 5. L = R_B + H = 147.5 + 95.4 = 242.9.",
            "The published case (UPCT, 2021). Its tables fix e + d_t = 8 and d_s + d_t/2 = 8; here d_t = 6, e = 2, d_s = 5. L = R_B + H = 147.5 + 95.4 = 242.9.",
        ),
        published,
    ),
];

fn published(language: Language) -> Vec<Cell> {
    vec![
        fields::SCHEMA.is(SCHEMA.to_owned()),
        R.is(25.0),
        MERIDIAN_R.is(15.0),
        INTERVALS_N.is(40),
        EPS_V.is(1e-5),
        N.is(4),
        E.is(2.0),
        A_P.is(2.0),
        SPLITTERS.is(true),
        SPLITTER_FADE.is(Fade::Published),
        D_T.is(6.0),
        T.is(1),
        D.is(1),
        R_B.is(147.5),
        H.is(95.4),
        B_MIN.is(-10.0),
        B_MAX.is(100.0),
        D_S.is(5.0),
        PART.says(&t("Rodete TFG 2021", "Impeller TFG 2021"), language),
        MATERIAL.says(&t("Aluminio", "Aluminium"), language),
        NUMBER.is(1),
        DIALECT.is(POST_8055),
        STYLE.is(Style::Annex),
        DISTANCE.is(Distance::Incremental),
        START_CODES.is(Codes::m([3, 11, 13])),
        END_CODES.is(Codes::m([30])),
        BLOCK_STEP.is(10),
        C.is(1.0),
        F_B.is(0.1),
        S_B.is(300),
        T_B.is(1),
        D_B.is(1),
        L_B.is(40.0),
        Z_B.is(50.0),
        C_F.is(1.0),
        C_O.is(0.4),
        C_C.is(5.0),
        X_E.is(80.0),
        Z_E.is(80.0),
        cut::METHOD.is(Method::Published),
    ]
}

fn full(language: Language) -> Vec<Cell> {
    let mut cells = published(language);
    EPS_V.set(&mut cells, 0.0);
    SPLITTER_FADE.set(&mut cells, Fade::EachSide);
    STYLE.set(&mut cells, Style::Full);
    // It follows R.
    X_E.clear(&mut cells);
    let retract = vec![Word::whole('G', 0), Word::whole('G', 53), Word::size('Z', Milli::ZERO)];
    cells.extend([
        F.is(300.0),
        S.is(6000),
        F_MAX.is(6000.0),
        fields::RAPID_LINEAR.is(6000.0),
        fields::RAPID_ROTARY.is(6000.0),
        ROTARY.is(RotaryMode::Rollover),
        RETRACT.is(Retract(retract)),
        S_M.is(3000),
    ]);
    cells
}

fn clear(language: Language) -> Vec<Cell> {
    let mut cells = full(language);
    // How the published splitters begin.
    SPLITTER_FADE.clear(&mut cells);
    PART.set(&mut cells, t("Rodete 50", "Impeller 50").get(language).to_owned());
    cut::METHOD.set(&mut cells, Method::Clear);
    cells.extend([
        // With the usual 0.01 the finishing program would be larger than 1 MiB, the memory of a Fagor 8055.
        TOL.is(0.0102),
        cut::D_F.is(3.0),
        cut::T_F.is(2),
        cut::OFFSET_F.is(2),
        cut::F_F.is(300.0),
        cut::S_F.is(12_000),
        cut::ALLOWANCE.is(0.3),
        cut::STEP.is(0.7),
        // So would finer ridges.
        cut::SCALLOP.is(0.025),
        // Some blocks more in the pass round a splitter's nose, whose feed would else change by 63 % within a block.
        cut::FEED_CHANGE.is(0.1),
    ]);
    cells
}
