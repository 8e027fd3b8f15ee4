//! The catalogue of usual tools for the sheet of a new workbook: to be mounted by giving one a place.
//!
//! Sizes are those of common indexable inserts (ISO 1832: inscribed circles of 6.35, 9.525 and 12.7 mm, nose radii of 0.4,
//! 0.8 and 1.2 mm) and of drills by their usual diameters. Cutting-edge angle, minor cutting-edge angle and the angle of the insert's corner make
//! 180°.

use crate::kinds::lathe::tool_sheet::{
    B, C, H, HAND, IC, L, NAME, P_MAX, P_MIN, PHI1, PHI2, PSI, Q_X, Q_Z, R, SHAPE, TYPE, ToolType, W,
};
use crate::parameter::Cell;
use crate::parameter::field::Chosen;
use crate::parameter::list::Row;
use crate::removal::turning::tool::{Hand, Shape};
use crate::text::{Language, Text};

/// Shape, inscribed circle, cutting-edge angle and minor cutting-edge angle of outside turning tools.
const OUTSIDE: [(Shape, f64, f64, f64); 8] = [
    (Shape::C, 12.7, 95.0, 5.0),
    (Shape::W, 12.7, 95.0, 5.0),
    (Shape::D, 12.7, 93.0, 32.0),
    (Shape::K, 9.525, 93.0, 32.0),
    (Shape::V, 9.525, 93.0, 52.0),
    (Shape::T, 9.525, 91.0, 29.0),
    (Shape::S, 12.7, 75.0, 15.0),
    (Shape::S, 12.7, 45.0, 45.0),
];
/// The same of boring bars, with the bar's diameter and from the tip to its centre.
const INSIDE: [(Shape, f64, f64, f64, f64, f64); 3] = [
    (Shape::C, 6.35, 95.0, 5.0, 8.0, 5.5),
    (Shape::T, 9.525, 91.0, 29.0, 16.0, 11.0),
    (Shape::D, 9.525, 93.0, 32.0, 20.0, 13.0),
];
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

/// A tool of a new workbook: its name and its other cells.
pub(super) struct NewTool {
    /// The name in both languages.
    pub(super) name: Text,
    /// Every cell but the name.
    pub(super) cells: Vec<Cell>,
}

impl NewTool {
    /// The row of the sheet, with the name in a language.
    pub(super) fn row(self, language: Language) -> Row {
        Row::of([NAME.says(&self.name, language)].into_iter().chain(self.cells))
    }
}

/// A square shank of 25 mm.
pub(super) fn shank() -> [Cell; 4] {
    [B.is(25.0), L.is(150.0), Q_X.is(60.0), Q_Z.is(40.0)]
}

/// A product such as 6 · 3.3 as the decimal it stands for: a spreadsheet keeps no more than 15 digits.
fn decimal(number: f64) -> f64 {
    (number * 1000.0).round() / 1000.0
}

fn tools() -> Vec<NewTool> {
    let hands = [Hand::Right, Hand::Left];
    (hands.into_iter().flat_map(outside))
        .chain(ROUND.map(round))
        .chain(INSIDE.into_iter().flat_map(boring))
        .chain(GROOVES.map(|w| grooving(ToolType::Groove, ["Ranurar", "Grooving"], w)))
        .chain(GROOVES.map(|w| grooving(ToolType::FaceGroove, ["Ranurar en la cara", "Face grooving"], w)))
        .chain(THREADS.into_iter().flat_map(|range| hands.map(|hand| threading(range, hand))))
        .chain(DRILLS.map(drill))
        .chain(CENTRES.map(centre_drill))
        .collect()
}

/// Outside turning tools of a hand.
fn outside(hand: Hand) -> impl Iterator<Item = NewTool> {
    let tool = move |(shape, inscribed, main, auxiliary): (Shape, f64, f64, f64), nose: f64| {
        let (form, side) = (shape.key(), hand.key());
        let mut cells = vec![TYPE.is(ToolType::External), SHAPE.is(shape), HAND.is(hand)];
        cells.extend(shank());
        cells.extend([IC.is(inscribed), R.is(nose), PHI1.is(main), PHI2.is(auxiliary)]);
        NewTool {
            name: Text::new(
                format!("Exterior {form} {main}° R{nose} {side}"),
                format!("External {form} {main}° R{nose} {side}"),
            ),
            cells,
        }
    };
    OUTSIDE.into_iter().flat_map(move |form| NOSES.map(|nose| tool(form, nose)))
}

fn round(inscribed: f64) -> NewTool {
    let mut cells = vec![TYPE.is(ToolType::External), SHAPE.is(Shape::R), HAND.is(Hand::Neutral), IC.is(inscribed)];
    cells.extend(shank());
    NewTool {
        name: Text::new(format!("Placa redonda de {inscribed} mm"), format!("{inscribed} mm round insert")),
        cells,
    }
}

fn boring((shape, inscribed, main, auxiliary, bar, reach): (Shape, f64, f64, f64, f64, f64)) -> [NewTool; 2] {
    let form = shape.key();
    [0.4, 0.8].map(|nose| NewTool {
        name: Text::new(format!("Mandrinar {form} {main}° R{nose}"), format!("Boring {form} {main}° R{nose}")),
        cells: vec![
            TYPE.is(ToolType::Internal),
            SHAPE.is(shape),
            HAND.is(Hand::Right),
            IC.is(inscribed),
            R.is(nose),
            PHI1.is(main),
            PHI2.is(auxiliary),
            B.is(bar),
            L.is(decimal(8.0 * bar)),
            C.is(reach),
            Q_X.is(0.0),
            Q_Z.is(decimal(8.0 * bar + 40.0)),
        ],
    })
}

fn grooving(kind: ToolType, [es, en]: [&str; 2], w: f64) -> NewTool {
    let mut cells = vec![TYPE.is(kind), HAND.is(Hand::Right), W.is(w), R.is(0.2), H.is(decimal(6.0 * w))];
    cells.extend(shank());
    NewTool { name: Text::new(format!("{es} {w} mm"), format!("{en} {w} mm")), cells }
}

fn threading((angle, least, greatest, nose): (f64, f64, f64, f64), hand: Hand) -> NewTool {
    let side = hand.key();
    let mut cells = vec![TYPE.is(ToolType::Thread), HAND.is(hand), PSI.is(angle), P_MIN.is(least), P_MAX.is(greatest)];
    cells.extend([R.is(nose), H.is(decimal(0.9 * greatest))]);
    cells.extend(shank());
    NewTool {
        name: Text::new(
            format!("Roscar {angle}°, {least} a {greatest} mm, {side}"),
            format!("Threading {angle}°, {least} to {greatest} mm, {side}"),
        ),
        cells,
    }
}

fn drill(w: f64) -> NewTool {
    let flutes = 6.0 * w;
    NewTool {
        name: Text::new(format!("Broca de {w} mm"), format!("{w} mm drill")),
        cells: vec![
            TYPE.is(ToolType::Drill),
            W.is(w),
            H.is(decimal(flutes)),
            PSI.is(118.0),
            B.is(decimal((w + 15.0).max(25.0))),
            L.is(decimal(flutes + 40.0)),
            Q_X.is(0.0),
            Q_Z.is(decimal(flutes + 60.0)),
        ],
    }
}

fn centre_drill([pilot, reach, body]: [f64; 3]) -> NewTool {
    NewTool {
        name: Text::new(format!("Broca de centrar de {pilot} mm"), format!("{pilot} mm centre drill")),
        cells: vec![
            TYPE.is(ToolType::CentreDrill),
            W.is(pilot),
            H.is(reach),
            IC.is(body),
            B.is(25.0),
            L.is(50.0),
            Q_X.is(0.0),
            Q_Z.is(70.0),
        ],
    }
}

/// The rows of the catalogue, none of them mounted.
#[must_use]
pub fn rows(language: Language) -> Vec<Row> {
    tools().into_iter().map(|tool| tool.row(language)).collect()
}
