//! A diagram: what the symbols of a form mean, drawn once and to no scale, with dimensions in any direction. What is drawn to scale
//! is a [`Sketch`](super::Sketch).
//!
//! # Units
//! Millimetres of paper; y goes up. Angles in degrees, anticlockwise from the x axis.

use crate::figure::{Figure, Ink, Label, Stroke};
use crate::number::trig::sin_cos;
use crate::text::Text;

/// From a dimension line to the middle of its symbol.
const BESIDE: f64 = 2.6;
/// An extension line begins this far from the part and ends this far behind the dimension line.
const EXTENSION: [f64; 2] = [0.8, 1.2];
/// A dimension shorter than this has its arrows outside, and its symbol behind the second.
const SHORT: f64 = 6.0;
/// The length of an arrow that points at a short dimension from outside.
const OUTSIDE: f64 = 4.0;

/// A diagram in the making.
#[derive(Debug, Default)]
pub struct Diagram {
    strokes: Vec<Stroke>,
    labels: Vec<Label>,
}

/// The point at an angle on a circle.
#[must_use]
pub fn on_circle([x, y]: [f64; 2], radius: f64, degrees: f64) -> [f64; 2] {
    let (sin, cos) = sin_cos(degrees.to_radians());
    [x + radius * cos, y + radius * sin]
}

/// The points of an arc.
#[must_use]
pub fn arc(centre: [f64; 2], radius: f64, [from, to]: [f64; 2]) -> Vec<[f64; 2]> {
    const PARTS: u8 = 36;
    (0..=PARTS).map(|at| on_circle(centre, radius, from + (to - from) * f64::from(at) / f64::from(PARTS))).collect()
}

/// A rectangle by two opposite corners.
#[must_use]
pub fn rectangle([x0, y0]: [f64; 2], [x1, y1]: [f64; 2]) -> Vec<[f64; 2]> {
    vec![[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]]
}

/// The point so far from another along a direction of unit length.
fn towards([x, y]: [f64; 2], [dx, dy]: [f64; 2], by: f64) -> [f64; 2] {
    [x + dx * by, y + dy * by]
}

/// The direction from one point to another, and how far it is.
fn direction(from: [f64; 2], to: [f64; 2]) -> ([f64; 2], f64) {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let length = (dx * dx + dy * dy).sqrt();
    if length > 0.0 { ([dx / length, dy / length], length) } else { ([1.0, 0.0], 0.0) }
}

/// How far the middle of a symbol stands from what it is beside of, in a direction: it is wider than it is high.
fn beside(symbol: &str, [dx, _]: [f64; 2]) -> f64 {
    BESIDE + 0.8 * symbol.chars().fold(0.0, |count, _| count + 1.0) * dx.abs()
}

impl Diagram {
    /// A line.
    pub fn line(&mut self, ink: Ink, points: impl Into<Vec<[f64; 2]>>) {
        self.strokes.push(Stroke::line(ink, points.into()));
    }

    /// Metal: a filled shape with its outline.
    pub fn metal(&mut self, points: impl Into<Vec<[f64; 2]>>) {
        let mut points = points.into();
        self.strokes.push(Stroke { filled: true, ..Stroke::line(Ink::Outline, points.clone()) });
        points.extend(points.first().copied());
        self.line(Ink::Outline, points);
    }

    /// Something that is not the part, such as a chuck: filled more faintly.
    pub fn other(&mut self, points: impl Into<Vec<[f64; 2]>>) {
        let mut points = points.into();
        self.strokes.push(Stroke { filled: true, ..Stroke::line(Ink::Thin, points.clone()) });
        points.extend(points.first().copied());
        self.line(Ink::Thin, points);
    }

    /// An arrow.
    pub fn arrow(&mut self, ink: Ink, from: [f64; 2], to: [f64; 2]) {
        self.strokes.push(Stroke { arrow: true, ..Stroke::line(ink, vec![from, to]) });
    }

    /// A word about a point.
    pub fn word(&mut self, at: [f64; 2], text: Text) {
        self.labels.push(Label { at, text });
    }

    /// A symbol of the form.
    pub fn symbol(&mut self, at: [f64; 2], symbol: &'static str) {
        self.word(at, Text::same(symbol));
    }

    /// A dimension between two points, its line `aside` of them to the left of the way from the first to the second; the
    /// symbol stands beyond the line.
    pub fn dimension(&mut self, from: [f64; 2], to: [f64; 2], aside: f64, symbol: &'static str) {
        let (along, length) = direction(from, to);
        let left = [-along[1], along[0]];
        let [a, b] = [from, to].map(|point| towards(point, left, aside));
        let sign = if aside < 0.0 { -1.0 } else { 1.0 };
        if aside.abs() > EXTENSION[0] {
            for point in [from, to] {
                let [begin, end] = [sign * EXTENSION[0], aside + sign * EXTENSION[1]];
                self.line(Ink::Thin, [towards(point, left, begin), towards(point, left, end)]);
            }
        }
        if length < SHORT {
            self.arrow(Ink::Dimension, towards(a, along, -OUTSIDE), a);
            self.arrow(Ink::Dimension, towards(b, along, OUTSIDE), b);
            self.symbol(towards(b, along, OUTSIDE + beside(symbol, along)), symbol);
        } else {
            let middle = towards(a, along, length / 2.0);
            self.arrow(Ink::Dimension, middle, a);
            self.arrow(Ink::Dimension, middle, b);
            self.symbol(towards(middle, left, sign * beside(symbol, left)), symbol);
        }
    }

    /// A radius, from the centre to a circle; the symbol stands `aside` of the arrow's middle, to its left.
    pub fn radius(&mut self, centre: [f64; 2], radius: f64, degrees: f64, aside: f64, symbol: &'static str) {
        let end = on_circle(centre, radius, degrees);
        self.arrow(Ink::Dimension, centre, end);
        let (along, length) = direction(centre, end);
        self.symbol(towards(towards(centre, along, length / 2.0), [-along[1], along[0]], aside), symbol);
    }

    /// An angle between two directions about a point, with its symbol beyond the arc.
    pub fn angle(&mut self, centre: [f64; 2], radius: f64, [from, to]: [f64; 2], symbol: &'static str) {
        let way = arc(centre, radius, [from, to]);
        let (first, second) = way.split_at(way.len() / 2);
        self.strokes.push(Stroke { arrow: true, ..Stroke::line(Ink::Dimension, second.to_vec()) });
        let back: Vec<[f64; 2]> = second.iter().take(1).chain(first.iter().rev()).copied().collect();
        self.strokes.push(Stroke { arrow: true, ..Stroke::line(Ink::Dimension, back) });
        let middle = on_circle(centre, 1.0, (from + to) / 2.0);
        let room = beside(symbol, direction(centre, middle).0);
        self.symbol(on_circle(centre, radius + room, (from + to) / 2.0), symbol);
    }

    /// A symbol with an arrow from it to what it is of.
    pub fn pointer(&mut self, from: [f64; 2], to: [f64; 2], symbol: &'static str) {
        let (along, _) = direction(from, to);
        self.symbol(from, symbol);
        self.arrow(Ink::Dimension, towards(from, along, beside(symbol, along)), to);
    }

    /// The diagram as a figure.
    #[must_use]
    pub fn figure(self, caption: Text) -> Figure {
        let Self { strokes, labels } = self;
        Figure { key: "sketch", height: Figure::HEIGHT, caption, axes: None, strokes, labels, legend: Vec::new() }
    }
}
