//! The cases that a new pipe-hole workbook can start from.

use crate::figure::Paper;
use crate::gcode::chosen::Codes;
use crate::gcode::control::POST_LINUXCNC;
use crate::gcode::fields;
use crate::kinds::pipe::form::{
    BLOCK_STEP, BRANCH_SCHEDULE, BRANCH_SIZE, DIALECT, E, END_CODES, HEADER_SCHEDULE, HEADER_SIZE, MATERIAL, NUMBER,
    PAPER, PART, PIERCE_DELAY, THETA, TORCH_OFF, TORCH_ON,
};
use crate::kinds::pipe::hole::parameters::{
    ARC_TOLERANCE, B, D_MAX, D0, F, F_MAX, G0, GAMMA, H, LEAD_IN, M, N, NOZZLE_R_G, OVERCUT, PSI, SCHEMA,
    TORCH_BODY_RADIUS, Z_S,
};
use crate::kinds::pipe::size::{Schedule, Size};
use crate::parameter::{Case, Cell};
use crate::text::{Language, t};

/// The cases, the usual one first.
pub static CASES: [Case; 1] = [Case::new(
    "set-in",
    t(
        "Injerto de 3\" metido en un tubo de 6\", cédula 40, con bisel de 30°. Las medidas de la antorcha, F y la espera son de ejemplo: compruébelas para su equipo.",
        "A 3\" branch set into a 6\" header, schedule 40, with a groove of 30°. The sizes of the torch, F and the delay are examples: check them for your equipment.",
    ),
    filled,
)];

fn filled(language: Language) -> Vec<Cell> {
    vec![
        fields::SCHEMA.is(SCHEMA.to_owned()),
        BRANCH_SIZE.is(&Size::NPS_3),
        BRANCH_SCHEDULE.is(Schedule::S40),
        HEADER_SIZE.is(&Size::NPS_6),
        HEADER_SCHEDULE.is(Schedule::S40),
        THETA.is(90.0),
        E.is(0.0),
        GAMMA.is(30.0),
        B.is(2.0),
        H.is(1.0),
        N.is(72),
        NOZZLE_R_G.is(6.0),
        TORCH_BODY_RADIUS.is(15.0),
        PSI.is(30.0),
        M.is(0.8),
        D0.is(4.0),
        G0.is(2.0),
        D_MAX.is(15.0),
        F.is(1500.0),
        F_MAX.is(15_000.0),
        PIERCE_DELAY.is(0.8),
        LEAD_IN.is(8.0),
        OVERCUT.is(4.0),
        ARC_TOLERANCE.is(0.05),
        Z_S.is(60.0),
        PAPER.is(Paper::A4),
        PART.says(&t("Tubo 6 con agujero de 3", "Pipe 6 with a hole for 3"), language),
        MATERIAL.says(&t("Acero al carbono", "Carbon steel"), language),
        NUMBER.is(1),
        DIALECT.is(POST_LINUXCNC),
        TORCH_ON.is(Codes::m([3])),
        TORCH_OFF.is(Codes::m([5])),
        END_CODES.is(Codes::m([30])),
        BLOCK_STEP.is(10),
    ]
}
