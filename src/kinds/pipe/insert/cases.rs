//! The cases that a new pipe-insert workbook can start from.

use crate::figure::Paper;
use crate::gcode::chosen::Codes;
use crate::gcode::control::{POST_8055, POST_LINUXCNC};
use crate::gcode::fields;
use crate::gcode::program::Style;
use crate::kinds::pipe::form::{
    BLOCK_STEP, BRANCH_SCHEDULE, BRANCH_SIZE, D_BRANCH, D_HEADER, DIALECT, E, END_CODES, HEADER_SCHEDULE, HEADER_SIZE,
    MATERIAL, NUMBER, PAPER, PART, PIERCE_DELAY, T_BRANCH, T_HEADER, THETA, TORCH_OFF, TORCH_ON,
};
use crate::kinds::pipe::insert::parameters::{
    ARC_TOLERANCE, CONTACT, Contact, EXPERT_BRANCH_R, F, KERF, LEAD_IN, MODE, Mode, N, OVERCUT, R, R_DEV, SCHEMA,
    SHEET, STYLE, Surface, Z,
};
use crate::kinds::pipe::size::{Schedule, Size};
use crate::parameter::{Case, Cell};
use crate::text::{Language, t};

/// The cases, the usual one first.
pub static CASES: [Case; 2] = [
    Case::new(
        "square",
        t(
            "Injerto de 3\" sobre 4\", cédula 40, a 90°, cortado en el tubo que gira. F, espera y ancho de corte son de un plasma de 45 A en acero de 5.5 mm: compruébelos para su equipo.",
            "A 3\" branch on a 4\" header, schedule 40, at 90°, cut on the turning pipe. F, delay and kerf are those of a 45 A plasma in 5.5 mm steel: check them for your equipment.",
        ),
        square,
    ),
    Case::new(
        "3on4-2023",
        t(
            "El caso publicado (Universidad de Guanajuato, 2023), con los valores tal como se escribieron: r = 44.45 es ya el radio exterior del tubo de 3\", escrito donde se pide el interior, y el desarrollo sale 5.49 mm demasiado fuera.",
            "The published case (Universidad de Guanajuato, 2023), with the values as they were typed: r = 44.45 is already the outside radius of the 3\" pipe, typed where the inside one is asked for, and the development is 5.49 mm too far out.",
        ),
        published,
    ),
];

fn square(language: Language) -> Vec<Cell> {
    vec![
        fields::SCHEMA.is(SCHEMA.to_owned()),
        PAPER.is(Paper::A4),
        BRANCH_SIZE.is(&Size::NPS_3),
        BRANCH_SCHEDULE.is(Schedule::S40),
        HEADER_SIZE.is(&Size::NPS_4),
        HEADER_SCHEDULE.is(Schedule::S40),
        CONTACT.is(Contact::Envelope),
        THETA.is(90.0),
        E.is(0.0),
        Z.is(20.0),
        N.is(64),
        MODE.is(Mode::Rotary),
        SHEET.is(Surface::Outside),
        KERF.is(1.5),
        F.is(2000.0),
        PIERCE_DELAY.is(0.4),
        LEAD_IN.is(5.0),
        OVERCUT.is(3.0),
        ARC_TOLERANCE.is(0.02),
        PART.says(&t("Injerto 3 sobre 4 a 90", "Branch 3 on 4 at 90"), language),
        MATERIAL.says(&t("Acero al carbono", "Carbon steel"), language),
        NUMBER.is(1),
        DIALECT.is(POST_LINUXCNC),
        STYLE.is(Style::Full),
        TORCH_ON.is(Codes::m([3])),
        TORCH_OFF.is(Codes::m([5])),
        END_CODES.is(Codes::m([30])),
        BLOCK_STEP.is(10),
    ]
}

fn published(language: Language) -> Vec<Cell> {
    vec![
        fields::SCHEMA.is(SCHEMA.to_owned()),
        PAPER.is(Paper::A4),
        D_BRANCH.is(88.9),
        T_BRANCH.is(5.49),
        D_HEADER.is(114.3),
        T_HEADER.is(6.02),
        CONTACT.is(Contact::Inside),
        THETA.is(83.0),
        E.is(10.0),
        Z.is(20.0),
        N.is(64),
        EXPERT_BRANCH_R.is(44.45),
        R.is(57.15),
        R_DEV.is(49.94),
        MODE.is(Mode::Flat),
        SHEET.is(Surface::Outside),
        KERF.is(0.0),
        PIERCE_DELAY.is(0.0),
        LEAD_IN.is(0.0),
        OVERCUT.is(0.0),
        ARC_TOLERANCE.is(0.1),
        PART.says(&t("Injerto 3 sobre 4 excéntrico", "Branch 3 on 4 eccentric"), language),
        MATERIAL.says(&t("Tubo cédula 40", "Schedule 40 pipe"), language),
        NUMBER.is(1),
        DIALECT.is(POST_8055),
        STYLE.is(Style::Annex),
        TORCH_ON.is(Codes::m([3])),
        TORCH_OFF.is(Codes::m([5])),
        END_CODES.is(Codes::m([30])),
        BLOCK_STEP.is(10),
    ]
}
