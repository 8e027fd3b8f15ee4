//! The cases that a new lathe workbook can start from.

use std::collections::BTreeMap;

use crate::kinds::lathe::catalogue;
use crate::kinds::lathe::parameters::{PROFILE_KEY, PROGRAM_KEY, SCHEMA, TOOLS_KEY};
use crate::limits::EXAMPLE_RAPID;
use crate::parameter::list::{Row, Rows};
use crate::parameter::{Case, Value};
use crate::text::{Language, t};

/// The cases that a new workbook can start from, the usual one first.
pub static CASES: [Case; 2] = [
    Case {
        name: "shaft",
        note: t(
            "Un eje con desbaste, acabado, ranura, rosca y taladro, para un control Fanuc, sistema A. Velocidades y avances están elegidos para acero de construcción con metal duro; máquina y herramientas son de ejemplo: compruébelas.",
            "A shaft with roughing, finishing, a groove, a thread and a hole, for a Fanuc control, system A. Speeds and feeds are chosen for structural steel with carbide; machine and tools are examples: check them.",
        ),
        filled: shaft,
        listed: shaft_lists,
    },
    Case {
        name: "blank",
        note: t(
            "El bruto del rodete publicado: un cuarto de toro de R = 25 y r = 15 con el ciclo G85 de Fagor. El programa lleva además el límite de giro S, que el publicado no tiene.",
            "The blank of the published impeller: a quarter torus of R = 25 and r = 15 with Fagor's cycle G85. Unlike the published program, it has the spindle speed limit S.",
        ),
        filled: blank,
        listed: blank_lists,
    },
];

fn line(language: Language, es: &str, en: &str) -> Value {
    Value::Line(match language {
        Language::Es => es.to_owned(),
        Language::En => en.to_owned(),
    })
}

/// The example machine, of the size of the source's.
fn machine() -> Vec<(&'static str, Value)> {
    vec![
        ("L1", Value::Real(80.0)),
        ("L2", Value::Real(40.0)),
        ("D_c", Value::Real(250.0)),
        ("tailstock", Value::Choice("auto")),
        ("G_X", Value::Real(EXAMPLE_RAPID[0])),
        ("G_Z", Value::Real(EXAMPLE_RAPID[1])),
        ("S_max", Value::Real(3000.0)),
        ("rapid", Value::Choice("bent")),
        ("turret", Value::Choice("front")),
    ]
}

fn shaft(language: Language) -> Vec<(&'static str, Value)> {
    let mut values = vec![
        ("schema", Value::Line(SCHEMA.to_owned())),
        ("part", line(language, "Eje de ejemplo", "Example shaft")),
        ("material", line(language, "Acero S235", "Steel S235")),
        ("dialect", Value::Choice("fanuc-lathe-a")),
        ("point", Value::Choice("calculator")),
        ("hole_R", Value::Choice("absolute")),
        ("D", Value::Real(50.0)),
        ("L", Value::Real(120.0)),
        ("L4", Value::Real(30.0)),
        ("L5", Value::Real(1.0)),
    ];
    values.extend(machine());
    values
}

fn blank(language: Language) -> Vec<(&'static str, Value)> {
    let mut values = vec![
        ("schema", Value::Line(SCHEMA.to_owned())),
        ("part", line(language, "Bruto del rodete", "Blank of the impeller")),
        ("material", line(language, "Aluminio", "Aluminium")),
        ("dialect", Value::Choice("fagor-8055-t")),
        ("D", Value::Real(50.0)),
        ("L", Value::Real(60.0)),
        ("L4", Value::Real(30.0)),
        ("L5", Value::Real(1.0)),
    ];
    values.extend(machine());
    values
}

/// A tool of the example turret: its name in both languages, its choices, its numbers.
struct Sample {
    name: [&'static str; 2],
    choices: &'static [(&'static str, &'static str)],
    numbers: &'static [(&'static str, f64)],
}

const SHANK: [(&str, f64); 4] = [("tools/b", 25.0), ("tools/l", 150.0), ("tools/Q_x", 60.0), ("tools/Q_z", 40.0)];

const TURRET: [Sample; 6] = [
    Sample {
        name: ["Desbaste CNMG 120408", "Roughing CNMG 120408"],
        choices: &[("tools/type", "external"), ("tools/shape", "C")],
        numbers: &[("tools/IC", 12.7), ("tools/R", 0.8), ("tools/phi1", 95.0), ("tools/phi2", 5.0)],
    },
    Sample {
        name: ["Acabado VBMT 160404", "Finishing VBMT 160404"],
        choices: &[("tools/type", "external"), ("tools/shape", "V")],
        numbers: &[("tools/IC", 9.525), ("tools/R", 0.4), ("tools/phi1", 93.0), ("tools/phi2", 52.0)],
    },
    Sample {
        name: ["Ranurar 3 mm", "Grooving 3 mm"],
        choices: &[("tools/type", "groove")],
        numbers: &[("tools/R", 0.2), ("tools/w", 3.0), ("tools/h", 14.0)],
    },
    Sample {
        name: ["Roscar 60°, 1 a 3 mm", "Threading 60°, 1 to 3 mm"],
        choices: &[("tools/type", "thread")],
        numbers: &[("tools/R", 0.1), ("tools/h", 2.5), ("tools/psi", 60.0), ("tools/p_min", 1.0), ("tools/p_max", 3.0)],
    },
    Sample {
        name: ["Broca de 10 mm", "10 mm drill"],
        choices: &[("tools/type", "drill")],
        numbers: &[
            ("tools/w", 10.0),
            ("tools/h", 60.0),
            ("tools/psi", 118.0),
            ("tools/b", 25.0),
            ("tools/l", 100.0),
            ("tools/Q_x", 0.0),
            ("tools/Q_z", 120.0),
        ],
    },
    Sample {
        name: ["Mandrinar CCMT 060204", "Boring CCMT 060204"],
        choices: &[("tools/type", "internal"), ("tools/shape", "C")],
        numbers: &[
            ("tools/IC", 6.35),
            ("tools/R", 0.4),
            ("tools/phi1", 95.0),
            ("tools/phi2", 5.0),
            ("tools/b", 6.0),
            ("tools/l", 60.0),
            ("tools/c", 4.5),
            ("tools/Q_x", 0.0),
            ("tools/Q_z", 100.0),
        ],
    },
];

fn row(T: u32, sample: &Sample, language: Language) -> Row {
    let mut values = BTreeMap::from([
        ("tools/T", Value::Whole(T)),
        ("tools/hand", Value::Choice("R")),
        ("tools/name", line(language, sample.name[0], sample.name[1])),
    ]);
    values.extend(sample.choices.iter().map(|&(key, choice)| (key, Value::Choice(choice))));
    values.extend(SHANK.iter().chain(sample.numbers).map(|&(key, number)| (key, Value::Real(number))));
    Row { values, cells: BTreeMap::new() }
}

/// The tools of a new workbook: the example turret, and the catalogue.
#[must_use]
pub fn turret(language: Language) -> Rows {
    let mounted = (1..).zip(&TURRET).map(|(T, sample)| row(T, sample, language));
    let rows = mounted.chain(catalogue::rows(language)).collect();
    Rows { list: TOOLS_KEY, sheet: String::new(), rows }
}

fn blocks(lines: &[&str]) -> Rows {
    let rows = lines
        .iter()
        .map(|block| Row {
            values: BTreeMap::from([("program/BLOCK", Value::Line((*block).to_owned()))]),
            cells: BTreeMap::new(),
        })
        .collect();
    Rows { list: PROGRAM_KEY, sheet: String::new(), rows }
}

const SHAFT: &[&str] = &[
    "O0001",
    "N5 G21 G40 G97 G99",
    "N10 G50 S2500",
    "N15 T0101",
    "N20 G96 S180 M3",
    "N25 G0 X54. Z0. M8",
    "N30 G1 X-1.6 F0.15",
    "N35 G0 Z2.",
    "N40 X52.",
    "N45 G71 U2. R0.5",
    "N50 G71 P55 Q100 U0.5 W0.1 F0.25",
    "N55 G0 X14.",
    "N60 G1 Z0. F0.12",
    "N65 X20. Z-3.",
    "N70 Z-30.",
    "N75 X26.",
    "N80 G3 X30. Z-32. R2.",
    "N85 G1 Z-45.",
    "N90 G2 X38. Z-49. R4.",
    "N95 G1 X44.",
    "N100 X48. Z-51.",
    "N105 G0 X100. Z50.",
    "N110 T0202",
    "N115 G96 S220",
    "N120 G0 X52. Z2.",
    "N125 G70 P55 Q100",
    "N130 G0 X100. Z50.",
    "N135 T0303",
    "N140 G97 S800",
    "N145 G0 X32. Z-30.",
    "N150 G1 X16. F0.08",
    "N155 G4 X0.5",
    "N160 G0 X34.",
    "N165 G0 X100. Z50.",
    "N170 T0404",
    "N175 G97 S600",
    "N180 G0 X24. Z6.",
    "N185 G76 P020060 Q50 R0.05",
    "N190 G76 X18.16 Z-27. P920 Q250 F1.5",
    "N195 G0 X100. Z50.",
    "N200 T0505",
    "N205 G97 S1200",
    "N210 G0 X0. Z5.",
    "N215 G83 X0. Z-25. R2. Q6000 F0.12",
    "N220 G80",
    "N225 G0 Z50. M9",
    "N230 G0 X100. M5",
    "N235 M30",
];

fn shaft_lists(language: Language) -> Vec<Rows> {
    vec![turret(language), blocks(SHAFT)]
}

const BLANK: &[&str] = &[
    "N5 G92 S2500",
    "N10 G0 G71 G90 G95 G96 X80 Z50 S300 M3",
    "N20 T1 D1",
    "N25 M8",
    "N30 X55 Z0",
    "N40 G1 X-1.6 F0.1",
    "N50 G0 X55 Z2",
    "N60 G85 X50 Z-15 Q20 R0 C1 I0 K15",
    "N70 G0 X80 Z80 M9",
    "N80 M30",
];

fn blank_lists(language: Language) -> Vec<Rows> {
    // The published program does not compensate the nose: its figures are those of a sharp tool.
    let mut tools = turret(language);
    tools.rows.truncate(1);
    if let Some(first) = tools.rows.first_mut() {
        first.values.insert("tools/R", Value::Real(0.0));
        first.values.insert("tools/name", line(language, "Herramienta de punta viva", "Sharp tool"));
    }
    let point = |G: &'static str, X: f64, Z: f64, R: Option<f64>| {
        let mut values = BTreeMap::from([
            ("profile/G", Value::Choice(G)),
            ("profile/X", Value::Real(X)),
            ("profile/Z", Value::Real(Z)),
        ]);
        values.extend(R.map(|R| ("profile/R", Value::Real(R))));
        Row { values, cells: BTreeMap::new() }
    };
    let profile = Rows {
        list: PROFILE_KEY,
        sheet: String::new(),
        rows: vec![point("1", 20.0, 0.0, None), point("2", 50.0, -15.0, Some(15.0))],
    };
    vec![tools, blocks(BLANK), profile]
}
