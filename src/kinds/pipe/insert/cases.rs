//! The cases that a new pipe-insert workbook can start from.

use crate::kinds::pipe::insert::parameters::SCHEMA;
use crate::parameter::{Case, Value};
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

fn line(language: Language, es: &str, en: &str) -> Value {
    Value::Line(match language {
        Language::Es => es.to_owned(),
        Language::En => en.to_owned(),
    })
}

fn square(language: Language) -> Vec<(&'static str, Value)> {
    vec![
        ("schema", Value::Line(SCHEMA.to_owned())),
        ("paper", Value::Choice("a4")),
        ("branch_size", Value::Choice("3")),
        ("branch_schedule", Value::Choice("40")),
        ("header_size", Value::Choice("4")),
        ("header_schedule", Value::Choice("40")),
        ("contact", Value::Choice("envelope")),
        ("theta", Value::Real(90.0)),
        ("e", Value::Real(0.0)),
        ("Z", Value::Real(20.0)),
        ("N", Value::Whole(64)),
        ("mode", Value::Choice("rotary")),
        ("sheet", Value::Choice("outside")),
        ("kerf", Value::Real(1.5)),
        ("F", Value::Real(2000.0)),
        ("pierce_delay", Value::Real(0.4)),
        ("lead_in", Value::Real(5.0)),
        ("overcut", Value::Real(3.0)),
        ("arc_tolerance", Value::Real(0.02)),
        ("part", line(language, "Injerto 3 sobre 4 a 90", "Branch 3 on 4 at 90")),
        ("material", line(language, "Acero al carbono", "Carbon steel")),
        ("program", Value::Whole(1)),
        ("dialect", Value::Choice("linuxcnc")),
        ("style", Value::Choice("full")),
        ("torch_on", Value::Line("M3".to_owned())),
        ("torch_off", Value::Line("M5".to_owned())),
        ("end_codes", Value::Line("M30".to_owned())),
        ("block_step", Value::Whole(10)),
    ]
}

fn published(language: Language) -> Vec<(&'static str, Value)> {
    vec![
        ("schema", Value::Line(SCHEMA.to_owned())),
        ("paper", Value::Choice("a4")),
        ("D_branch", Value::Real(88.9)),
        ("t_branch", Value::Real(5.49)),
        ("D_header", Value::Real(114.3)),
        ("t_header", Value::Real(6.02)),
        ("contact", Value::Choice("inside")),
        ("theta", Value::Real(83.0)),
        ("e", Value::Real(10.0)),
        ("Z", Value::Real(20.0)),
        ("N", Value::Whole(64)),
        ("r", Value::Real(44.45)),
        ("R", Value::Real(57.15)),
        ("r_dev", Value::Real(49.94)),
        ("mode", Value::Choice("flat")),
        ("sheet", Value::Choice("outside")),
        ("kerf", Value::Real(0.0)),
        ("pierce_delay", Value::Real(0.0)),
        ("lead_in", Value::Real(0.0)),
        ("overcut", Value::Real(0.0)),
        ("arc_tolerance", Value::Real(0.1)),
        ("part", line(language, "Injerto 3 sobre 4 excéntrico", "Branch 3 on 4 eccentric")),
        ("material", line(language, "Tubo cédula 40", "Schedule 40 pipe")),
        ("program", Value::Whole(1)),
        ("dialect", Value::Choice("fagor-8055")),
        ("style", Value::Choice("annex")),
        ("torch_on", Value::Line("M3".to_owned())),
        ("torch_off", Value::Line("M5".to_owned())),
        ("end_codes", Value::Line("M30".to_owned())),
        ("block_step", Value::Whole(10)),
    ]
}
