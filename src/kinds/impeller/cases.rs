//! The cases that a new impeller workbook can start from.

use crate::kinds::impeller::clear::fields::{self as cut, Method};
use crate::kinds::impeller::parameters::SCHEMA;
use crate::parameter::{Case, Value};
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

fn published(language: Language) -> Vec<(&'static str, Value)> {
    let line = |es: &str, en: &str| {
        Value::Line(match language {
            Language::Es => es.to_owned(),
            Language::En => en.to_owned(),
        })
    };
    vec![
        ("schema", Value::Line(SCHEMA.to_owned())),
        ("R", Value::Real(25.0)),
        ("r", Value::Real(15.0)),
        ("n", Value::Whole(40)),
        ("eps_v", Value::Real(1e-5)),
        ("N", Value::Whole(4)),
        ("e", Value::Real(2.0)),
        ("a_p", Value::Real(2.0)),
        ("splitters", Value::Choice("yes")),
        ("splitter_fade", Value::Choice("published")),
        ("d_t", Value::Real(6.0)),
        ("T", Value::Whole(1)),
        ("D", Value::Whole(1)),
        ("R_B", Value::Real(147.5)),
        ("H", Value::Real(95.4)),
        ("B_min", Value::Real(-10.0)),
        ("B_max", Value::Real(100.0)),
        ("d_s", Value::Real(5.0)),
        ("part", line("Rodete TFG 2021", "Impeller TFG 2021")),
        ("material", line("Aluminio", "Aluminium")),
        ("program", Value::Whole(1)),
        ("dialect", Value::Choice("fagor-8055")),
        ("style", Value::Choice("annex")),
        ("distance", Value::Choice("G91")),
        ("start_codes", line("M3 M11 M13", "M3 M11 M13")),
        ("end_codes", line("M30", "M30")),
        ("block_step", Value::Whole(10)),
        ("C", Value::Real(1.0)),
        ("F_b", Value::Real(0.1)),
        ("S_b", Value::Whole(300)),
        ("T_b", Value::Whole(1)),
        ("D_b", Value::Whole(1)),
        ("L_b", Value::Real(40.0)),
        ("Z_b", Value::Real(50.0)),
        ("c_f", Value::Real(1.0)),
        ("c_o", Value::Real(0.4)),
        ("c_c", Value::Real(5.0)),
        ("X_e", Value::Real(80.0)),
        ("Z_e", Value::Real(80.0)),
        cut::METHOD.is(Method::Published),
    ]
}

fn full(language: Language) -> Vec<(&'static str, Value)> {
    let mut values = published(language);
    for (key, value) in
        [("eps_v", Value::Real(0.0)), ("splitter_fade", Value::Choice("each-side")), ("style", Value::Choice("full"))]
    {
        if let Some(entry) = values.iter_mut().find(|entry| entry.0 == key) {
            entry.1 = value;
        }
    }
    // It follows R.
    values.retain(|entry| entry.0 != "X_e");
    values.extend([
        ("F", Value::Real(300.0)),
        ("S", Value::Whole(6000)),
        ("F_max", Value::Real(6000.0)),
        ("G_lin", Value::Real(6000.0)),
        ("G_rot", Value::Real(6000.0)),
        ("rotary", Value::Choice("rollover")),
        ("retract", Value::Line("G0 G53 Z0".to_owned())),
        ("S_m", Value::Whole(3000)),
    ]);
    values
}

fn clear(language: Language) -> Vec<(&'static str, Value)> {
    let mut values = full(language);
    // How the published splitters begin, and the part of the thesis.
    values.retain(|entry| !["splitter_fade", "part", cut::METHOD.row.key].contains(&entry.0));
    let part = match language {
        Language::Es => "Rodete 50",
        Language::En => "Impeller 50",
    };
    values.extend([
        ("part", Value::Line(part.to_owned())),
        // With the usual 0.01 the finishing program would be larger than 1 MiB, the memory of a Fagor 8055.
        ("tol", Value::Real(0.0102)),
        cut::METHOD.is(Method::Clear),
        ("d_f", Value::Real(3.0)),
        ("T_f", Value::Whole(2)),
        ("D_f", Value::Whole(2)),
        ("F_f", Value::Real(300.0)),
        ("S_f", Value::Whole(12_000)),
        cut::ALLOWANCE.is(0.3),
        cut::STEP.is(0.7),
        // So would finer ridges.
        cut::SCALLOP.is(0.025),
        // Some blocks more in the pass round a splitter's nose, whose feed would else change by 63 % within a block.
        cut::FEED_CHANGE.is(0.1),
    ]);
    values
}
