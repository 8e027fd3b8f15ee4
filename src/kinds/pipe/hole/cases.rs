//! The cases that a new pipe-hole workbook can start from.

use crate::kinds::pipe::hole::parameters::SCHEMA;
use crate::parameter::{Case, Value};
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

fn filled(language: Language) -> Vec<(&'static str, Value)> {
    let line = |es: &str, en: &str| {
        Value::Line(match language {
            Language::Es => es.to_owned(),
            Language::En => en.to_owned(),
        })
    };
    vec![
        ("schema", Value::Line(SCHEMA.to_owned())),
        ("branch_size", Value::Choice("3")),
        ("branch_schedule", Value::Choice("40")),
        ("header_size", Value::Choice("6")),
        ("header_schedule", Value::Choice("40")),
        ("theta", Value::Real(90.0)),
        ("e", Value::Real(0.0)),
        ("gamma", Value::Real(30.0)),
        ("b", Value::Real(2.0)),
        ("h", Value::Real(1.0)),
        ("N", Value::Whole(72)),
        ("r_g", Value::Real(6.0)),
        ("R_g", Value::Real(15.0)),
        ("Psi", Value::Real(30.0)),
        ("m", Value::Real(0.8)),
        ("d0", Value::Real(4.0)),
        ("g0", Value::Real(2.0)),
        ("D_max", Value::Real(15.0)),
        ("F", Value::Real(1500.0)),
        ("F_max", Value::Real(15_000.0)),
        ("pierce_delay", Value::Real(0.8)),
        ("lead_in", Value::Real(8.0)),
        ("overcut", Value::Real(4.0)),
        ("arc_tolerance", Value::Real(0.05)),
        ("Z_s", Value::Real(60.0)),
        ("paper", Value::Choice("a4")),
        ("part", line("Tubo 6 con agujero de 3", "Pipe 6 with a hole for 3")),
        ("material", line("Acero al carbono", "Carbon steel")),
        ("program", Value::Whole(1)),
        ("dialect", Value::Choice("linuxcnc")),
        ("torch_on", Value::Line("M3".to_owned())),
        ("torch_off", Value::Line("M5".to_owned())),
        ("end_codes", Value::Line("M30".to_owned())),
        ("block_step", Value::Whole(10)),
    ]
}
