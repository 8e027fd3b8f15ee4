//! The catalogue of usual tools for the sheet of a new workbook: to be mounted by giving one a place.
//!
//! Sizes are those of common indexable inserts (ISO 1832: inscribed circles of 6.35, 9.525 and 12.7 mm, nose radii of 0.4,
//! 0.8 and 1.2 mm) and of drills by their usual diameters. Cutting-edge angle, minor cutting-edge angle and the angle of the insert's corner make
//! 180°.

use std::collections::BTreeMap;

use crate::parameter::Value;
use crate::parameter::list::Row;
use crate::text::Language;

/// Shape, inscribed circle, cutting-edge angle and minor cutting-edge angle of outside turning tools.
const OUTSIDE: [(&str, f64, f64, f64); 8] = [
    ("C", 12.7, 95.0, 5.0),
    ("W", 12.7, 95.0, 5.0),
    ("D", 12.7, 93.0, 32.0),
    ("K", 9.525, 93.0, 32.0),
    ("V", 9.525, 93.0, 52.0),
    ("T", 9.525, 91.0, 29.0),
    ("S", 12.7, 75.0, 15.0),
    ("S", 12.7, 45.0, 45.0),
];
/// The same of boring bars, with the bar's diameter and from the tip to its centre.
const INSIDE: [(&str, f64, f64, f64, f64, f64); 3] =
    [("C", 6.35, 95.0, 5.0, 8.0, 5.5), ("T", 9.525, 91.0, 29.0, 16.0, 11.0), ("D", 9.525, 93.0, 32.0, 20.0, 13.0)];
const NOSES: [f64; 3] = [0.4, 0.8, 1.2];
/// Diameters of round inserts.
const ROUND: [f64; 3] = [6.0, 8.0, 10.0];
const GROOVES: [f64; 6] = [2.0, 2.5, 3.0, 4.0, 5.0, 6.0];
/// Angle, least and greatest pitch and nose radius of threading inserts.
const THREADS: [(f64, f64, f64, f64); 3] = [(60.0, 0.5, 1.5, 0.05), (60.0, 1.0, 3.0, 0.1), (55.0, 0.9, 3.2, 0.15)];
const DRILLS: [f64; 18] =
    [2.5, 3.3, 4.0, 4.2, 5.0, 6.0, 6.8, 8.0, 8.5, 10.0, 10.2, 12.0, 14.0, 16.0, 18.0, 20.0, 25.0, 30.0];
/// Pilot, its length, and body of centre drills, form A.
const CENTRES: [[f64; 3]; 3] = [[2.0, 2.5, 5.0], [3.15, 3.9, 8.0], [4.0, 5.0, 10.0]];

struct CatalogueTool {
    name: [String; 2],
    choices: Vec<(&'static str, &'static str)>,
    numbers: Vec<(&'static str, f64)>,
}

/// On a square shank of 25 mm.
fn shank() -> Vec<(&'static str, f64)> {
    vec![("tools/b", 25.0), ("tools/l", 150.0), ("tools/Q_x", 60.0), ("tools/Q_z", 40.0)]
}

fn tools() -> Vec<CatalogueTool> {
    let hands = ["R", "L"];
    (hands.into_iter().flat_map(outside))
        .chain(ROUND.map(round))
        .chain(INSIDE.into_iter().flat_map(boring))
        .chain(GROOVES.map(|w| grooving("groove", ["Ranurar", "Grooving"], w)))
        .chain(GROOVES.map(|w| grooving("face-groove", ["Ranurar en la cara", "Face grooving"], w)))
        .chain(THREADS.into_iter().flat_map(|range| hands.map(|hand| threading(range, hand))))
        .chain(DRILLS.map(drill))
        .chain(CENTRES.map(centre_drill))
        .collect()
}

/// Outside turning tools of a hand.
fn outside(hand: &'static str) -> impl Iterator<Item = CatalogueTool> {
    let tool = move |(shape, IC, main, auxiliary): (&'static str, f64, f64, f64), R: f64| {
        let mut numbers = shank();
        numbers.extend([("tools/IC", IC), ("tools/R", R), ("tools/phi1", main), ("tools/phi2", auxiliary)]);
        CatalogueTool {
            name: [format!("Exterior {shape} {main}° R{R} {hand}"), format!("External {shape} {main}° R{R} {hand}")],
            choices: vec![("tools/type", "external"), ("tools/shape", shape), ("tools/hand", hand)],
            numbers,
        }
    };
    OUTSIDE.into_iter().flat_map(move |form| NOSES.map(|R| tool(form, R)))
}

fn round(IC: f64) -> CatalogueTool {
    let mut numbers = shank();
    numbers.push(("tools/IC", IC));
    CatalogueTool {
        name: [format!("Placa redonda de {IC} mm"), format!("{IC} mm round insert")],
        choices: vec![("tools/type", "external"), ("tools/shape", "R"), ("tools/hand", "N")],
        numbers,
    }
}

fn boring((shape, IC, main, auxiliary, bar, reach): (&'static str, f64, f64, f64, f64, f64)) -> [CatalogueTool; 2] {
    [0.4, 0.8].map(|R| CatalogueTool {
        name: [format!("Mandrinar {shape} {main}° R{R}"), format!("Boring {shape} {main}° R{R}")],
        choices: vec![("tools/type", "internal"), ("tools/shape", shape), ("tools/hand", "R")],
        numbers: vec![
            ("tools/IC", IC),
            ("tools/R", R),
            ("tools/phi1", main),
            ("tools/phi2", auxiliary),
            ("tools/b", bar),
            ("tools/l", 8.0 * bar),
            ("tools/c", reach),
            ("tools/Q_x", 0.0),
            ("tools/Q_z", 8.0 * bar + 40.0),
        ],
    })
}

fn grooving(kind: &'static str, names: [&str; 2], w: f64) -> CatalogueTool {
    let mut numbers = shank();
    numbers.extend([("tools/w", w), ("tools/R", 0.2), ("tools/h", 6.0 * w)]);
    CatalogueTool {
        name: names.map(|name| format!("{name} {w} mm")),
        choices: vec![("tools/type", kind), ("tools/hand", "R")],
        numbers,
    }
}

fn threading((angle, least, greatest, nose): (f64, f64, f64, f64), hand: &'static str) -> CatalogueTool {
    let mut numbers = shank();
    numbers.extend([
        ("tools/psi", angle),
        ("tools/p_min", least),
        ("tools/p_max", greatest),
        ("tools/R", nose),
        ("tools/h", 0.9 * greatest),
    ]);
    CatalogueTool {
        name: [
            format!("Roscar {angle}°, {least} a {greatest} mm, {hand}"),
            format!("Threading {angle}°, {least} to {greatest} mm, {hand}"),
        ],
        choices: vec![("tools/type", "thread"), ("tools/hand", hand)],
        numbers,
    }
}

fn drill(w: f64) -> CatalogueTool {
    let flutes = 6.0 * w;
    CatalogueTool {
        name: [format!("Broca de {w} mm"), format!("{w} mm drill")],
        choices: vec![("tools/type", "drill")],
        numbers: vec![
            ("tools/w", w),
            ("tools/h", flutes),
            ("tools/psi", 118.0),
            ("tools/b", (w + 15.0).max(25.0)),
            ("tools/l", flutes + 40.0),
            ("tools/Q_x", 0.0),
            ("tools/Q_z", flutes + 60.0),
        ],
    }
}

fn centre_drill([pilot, reach, body]: [f64; 3]) -> CatalogueTool {
    CatalogueTool {
        name: [format!("Broca de centrar de {pilot} mm"), format!("{pilot} mm centre drill")],
        choices: vec![("tools/type", "centre-drill")],
        numbers: vec![
            ("tools/w", pilot),
            ("tools/h", reach),
            ("tools/IC", body),
            ("tools/b", 25.0),
            ("tools/l", 50.0),
            ("tools/Q_x", 0.0),
            ("tools/Q_z", 70.0),
        ],
    }
}

/// The rows of the catalogue, none of them mounted.
#[must_use]
pub fn rows(language: Language) -> Vec<Row> {
    let row = |tool: CatalogueTool| {
        let [es, en] = tool.name;
        let name = match language {
            Language::Es => es,
            Language::En => en,
        };
        let mut values = BTreeMap::from([("tools/name", Value::Line(name))]);
        values.extend(tool.choices.into_iter().map(|(key, choice)| (key, Value::Choice(choice))));
        // Products such as 6 · 3.3 as the decimals they stand for: a spreadsheet keeps no more than 15 digits.
        let decimal = |number: f64| Value::Real((number * 1000.0).round() / 1000.0);
        values.extend(tool.numbers.into_iter().map(|(key, number)| (key, decimal(number))));
        Row { values, cells: BTreeMap::new() }
    };
    tools().into_iter().map(row).collect()
}
