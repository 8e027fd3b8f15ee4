//! A dimensioned sketch: shapes to scale with dimension lines, axes and the mark of a zero point.

use std::f64::consts::TAU;

use super::{Figure, Ink, LETTER, Label, Stroke, letters};
use crate::number::shown;
use crate::number::trig::sin_cos;
use crate::text::Text;

/// How far a label stands off its line, in mm of paper.
const OFF: f64 = 1.2;
/// How far an extension line begins off the shape and goes beyond the dimension line, mm of paper.
const EXTENSION: f64 = 1.2;
/// How long a dimension line must be for its arrows to stand inside, and how long those from outside are, mm of paper.
const ROOM: f64 = 6.0;
const OUTSIDE: f64 = 5.0;

/// A sketch in the making. What belongs to paper, as where a dimension stands off its shape, is reported in mm of paper.
#[derive(Debug)]
pub struct Sketch {
    strokes: Vec<Stroke>,
    labels: Vec<Label>,
    /// What one mm of paper is of the thing drawn, mm.
    unit: f64,
}

/// On which side of its point a label stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// To its left.
    Left,
    /// To its right.
    Right,
    /// Above it.
    Above,
    /// Below it.
    Below,
}

impl Sketch {
    /// A sketch of a thing that is so wide and high, mm, on a place of paper that is so wide and high, mm.
    #[must_use]
    pub fn new([wide, high]: [f64; 2], [width, height]: [f64; 2]) -> Self {
        Self { strokes: Vec::new(), labels: Vec::new(), unit: (wide / width).max(high / height) }
    }

    /// So many mm of paper, in mm of the thing.
    #[must_use]
    pub const fn paper(&self, mm: f64) -> f64 {
        mm * self.unit
    }

    /// A line through points.
    pub fn line(&mut self, ink: Ink, points: Vec<[f64; 2]>) {
        self.strokes.push(Stroke::line(ink, points));
    }

    /// A line that ends in an arrow head.
    pub fn arrow(&mut self, ink: Ink, points: Vec<[f64; 2]>) {
        self.strokes.push(Stroke { ink, points, filled: false, arrow: true });
    }

    /// A shape, filled and with its outline; its last point is joined to its first.
    pub fn shape(&mut self, ink: Ink, points: &[[f64; 2]]) {
        self.strokes.push(Stroke { ink, points: points.to_vec(), filled: true, arrow: false });
        self.line(ink, points.iter().chain(points.first()).copied().collect());
    }

    /// A rectangle between two corners.
    pub fn rectangle(&mut self, ink: Ink, [left, low]: [f64; 2], [right, high]: [f64; 2]) {
        self.shape(ink, &[[left, low], [right, low], [right, high], [left, high]]);
    }

    /// A circle.
    pub fn ring(&mut self, ink: Ink, centre: [f64; 2], radius: f64) {
        self.line(ink, arc(centre, radius, [0.0, 360.0]));
    }

    /// An arc about a centre between two angles in degrees, with an arrow head at the second.
    pub fn turn(&mut self, ink: Ink, centre: [f64; 2], radius: f64, angles: [f64; 2]) {
        self.arrow(ink, arc(centre, radius, angles));
    }

    /// A word beside a point.
    pub fn label(&mut self, at: [f64; 2], side: Side, text: Text) {
        let half = self.paper(LETTER / 2.0 * length(&text) + OFF);
        let by = match side {
            Side::Left => [-half, self.paper(-1.1)],
            Side::Right => [half, self.paper(-1.1)],
            Side::Above => [0.0, self.paper(OFF)],
            Side::Below => [0.0, self.paper(-OFF - 2.2)],
        };
        self.labels.push(Label { at: [at[0] + by[0], at[1] + by[1]], text });
    }

    /// The mark of a zero point: a ring of four quarters, two of them dark.
    pub fn zero(&mut self, at: [f64; 2]) {
        let radius = self.paper(1.7);
        let white = Stroke { ink: Ink::Face(255), points: arc(at, radius, [0.0, 360.0]), filled: true, arrow: false };
        self.strokes.push(white);
        for from in [0.0, 180.0] {
            let mut points = arc(at, radius, [from, from + 90.0]);
            points.push(at);
            self.strokes.push(Stroke { ink: Ink::Face(0), points, filled: true, arrow: false });
        }
        self.ring(Ink::Outline, at, radius);
    }

    /// A level dimension between two points, at the height `y`, with what it says above its line.
    pub fn level(&mut self, from: [f64; 2], to: [f64; 2], y: f64, text: Text) {
        self.dimension([from, to], [[from[0], y], [to[0], y]], [0.0, 1.0]);
        let long = (to[0] - from[0]).abs();
        if self.paper(LETTER * length(&text)) < long {
            self.label([f64::midpoint(from[0], to[0]), y], Side::Above, text);
        } else {
            // What has no room over its line stands beside it, behind the arrow from outside where there is one.
            let behind = if long < self.paper(ROOM) { self.paper(OUTSIDE) } else { 0.0 };
            self.label([to[0].max(from[0]) + behind, y], Side::Right, text);
        }
    }

    /// An upright dimension between two points, at the distance `x`, with what it says on one side of its line.
    pub fn upright(&mut self, from: [f64; 2], to: [f64; 2], x: f64, side: Side, text: Text) {
        self.dimension([from, to], [[x, from[1]], [x, to[1]]], [1.0, 0.0]);
        self.label([x, f64::midpoint(from[1], to[1])], side, text);
    }

    /// Extension lines from points to the ends of a dimension line, and that line with its two arrow heads.
    fn dimension(&mut self, of: [[f64; 2]; 2], ends: [[f64; 2]; 2], across: [f64; 2]) {
        for (point, end) in of.into_iter().zip(ends) {
            let by = [end[0] - point[0], end[1] - point[1]];
            let way = by[0] * across[0] + by[1] * across[1];
            let sign = if way < 0.0 { -1.0 } else { 1.0 };
            let gap = self.paper(EXTENSION) * sign;
            let at = |from: [f64; 2], by: f64| [from[0] + across[0] * by, from[1] + across[1] * by];
            if way.abs() > self.paper(EXTENSION) {
                self.line(Ink::Thin, vec![at(point, gap), at(end, gap)]);
            }
        }
        let [one, other] = ends;
        let middle = [0, 1].map(|axis| f64::midpoint(one[axis], other[axis]));
        let long = (one[0] - other[0]).abs() + (one[1] - other[1]).abs();
        if long >= self.paper(ROOM) {
            self.arrow(Ink::Outline, vec![middle, one]);
            self.arrow(Ink::Outline, vec![middle, other]);
        } else {
            // Arrows from outside where there is no room between.
            for (end, other) in [(one, other), (other, one)] {
                let by = [0, 1].map(|axis| end[axis] - other[axis]);
                let share = if long > 0.0 { self.paper(OUTSIDE) / long } else { 0.0 };
                self.arrow(Ink::Outline, vec![[end[0] + by[0] * share, end[1] + by[1] * share], end]);
            }
            self.line(Ink::Outline, vec![one, other]);
        }
    }

    /// The figure of it.
    #[must_use]
    pub fn figure(self, key: &'static str, height: f64, caption: Text) -> Figure {
        let Self { strokes, labels, .. } = self;
        Figure { key, height, caption, axes: None, strokes, labels, legend: Vec::new() }
    }
}

/// How many letters a label has in the longer of its languages.
fn length(text: &Text) -> f64 {
    letters(&text.es).max(letters(&text.en))
}

/// Points of an arc between two angles in degrees.
fn arc(centre: [f64; 2], radius: f64, [from, to]: [f64; 2]) -> Vec<[f64; 2]> {
    (0..=48_u16)
        .map(|at| {
            let angle = (from + (to - from) * f64::from(at) / 48.0) / 360.0 * TAU;
            let (sin, cos) = sin_cos(angle);
            [centre[0] + radius * cos, centre[1] + radius * sin]
        })
        .collect()
}

/// What a dimension says: its symbol, where it has one, and its length in mm.
#[must_use]
pub fn sized(symbol: &str, length: f64) -> Text {
    let number = shown(length, 3);
    Text::same(if symbol.is_empty() { number } else { format!("{symbol} = {number}") })
}
