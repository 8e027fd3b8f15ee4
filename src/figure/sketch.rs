//! A sketch: shapes with dimensions in any direction, angles, pointers, axes and the mark of a zero point. That of a form shows what its
//! symbols mean, to no scale; that of a set-up shows a thing to scale.
//!
//! # Units
//! Millimetres of the thing drawn, or of paper where the sketch is drawn [on paper](Sketch::on_paper); y goes up. What belongs to paper
//! alone, as how far a dimension stands off, is in mm of paper. Angles in degrees, anticlockwise from the x axis.

use super::{Figure, Ink, LETTER, Label, Stroke, letters};
use crate::number::shown;
use crate::number::trig::sin_cos;
use crate::text::Text;

/// How far a label stands off its point; from a dimension line to the middle of its symbol.
const OFF: f64 = 1.2;
const BESIDE: f64 = 2.6;
/// From the foot of a label's letters to their middle.
const MIDDLE: f64 = 1.1;
/// An extension line begins this far from the shape and ends this far behind the dimension line.
const EXTENSION: [f64; 2] = [0.8, 1.2];
/// A dimension shorter than this has its arrows outside, each so long.
const SHORT: f64 = 6.0;
const OUTSIDE: f64 = 4.0;

/// A sketch in the making: strokes and labels in mm of the thing drawn, sizes of words and arrows in mm of paper.
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
    /// Left of the point.
    Left,
    /// Right of the point.
    Right,
    /// Above the point.
    Above,
    /// Below the point.
    Below,
}

impl Sketch {
    /// A sketch in mm of paper.
    #[must_use]
    pub const fn on_paper() -> Self {
        Self { strokes: Vec::new(), labels: Vec::new(), unit: 1.0 }
    }

    /// A sketch of a thing that is so wide and high, mm, on a place of paper that is so wide and high, mm.
    #[must_use]
    pub fn new([wide, high]: [f64; 2], [width, height]: [f64; 2]) -> Self {
        Self { unit: (wide / width).max(high / height), ..Self::on_paper() }
    }

    /// So many mm of paper, in mm of the thing.
    #[must_use]
    pub const fn paper(&self, mm: f64) -> f64 {
        mm * self.unit
    }

    /// An open line through points, mm.
    pub fn line(&mut self, ink: Ink, points: impl Into<Vec<[f64; 2]>>) {
        self.strokes.push(Stroke::line(ink, points.into()));
    }

    /// A line that ends in an arrow head.
    pub fn arrow(&mut self, ink: Ink, points: impl Into<Vec<[f64; 2]>>) {
        self.strokes.push(Stroke { arrow: true, ..Stroke::line(ink, points.into()) });
    }

    /// A shape, filled and with its outline; its last point is joined to its first. Metal is of [`Ink::Outline`], what is not the part,
    /// such as a chuck, of [`Ink::Thin`].
    pub fn shape(&mut self, ink: Ink, points: impl Into<Vec<[f64; 2]>>) {
        let mut points = points.into();
        self.strokes.push(Stroke { filled: true, ..Stroke::line(ink, points.clone()) });
        points.extend(points.first().copied());
        self.line(ink, points);
    }

    /// A rectangle between two corners.
    pub fn rectangle(&mut self, ink: Ink, [x0, y0]: [f64; 2], [x1, y1]: [f64; 2]) {
        self.shape(ink, [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]);
    }

    /// A whole circle of a centre and a radius, mm.
    pub fn ring(&mut self, ink: Ink, centre: [f64; 2], radius: f64) {
        self.line(ink, arc(centre, radius, [0.0, 360.0]));
    }

    /// An arc about a centre between two angles, with an arrow head at the second.
    pub fn turn(&mut self, ink: Ink, centre: [f64; 2], radius: f64, angles: [f64; 2]) {
        self.arrow(ink, arc(centre, radius, angles));
    }

    /// A word about a point.
    pub fn word(&mut self, [x, y]: [f64; 2], text: Text) {
        self.labels.push(Label { at: [x, y - self.paper(MIDDLE)], text });
    }

    /// A word beside a point.
    pub fn label(&mut self, [x, y]: [f64; 2], side: Side, text: Text) {
        let half = self.paper(LETTER / 2.0 * length(&text) + OFF);
        let at = match side {
            Side::Left => [x - half, y],
            Side::Right => [x + half, y],
            Side::Above => [x, y + self.paper(OFF + MIDDLE)],
            Side::Below => [x, y - self.paper(OFF + MIDDLE)],
        };
        self.word(at, text);
    }

    /// The mark of a zero point: a ring of four quarters, two of them dark.
    pub fn zero(&mut self, at: [f64; 2]) {
        let radius = self.paper(1.7);
        let white = Stroke::line(Ink::Face(255), arc(at, radius, [0.0, 360.0]));
        self.strokes.push(Stroke { filled: true, ..white });
        for from in [0.0, 180.0] {
            let mut points = arc(at, radius, [from, from + 90.0]);
            points.push(at);
            self.strokes.push(Stroke { filled: true, ..Stroke::line(Ink::Face(0), points) });
        }
        self.ring(Ink::Outline, at, radius);
    }

    /// A dimension between two points, its line `aside` of them, in mm of paper, to the left of the way from the first to the second; the
    /// symbol stands beyond the line.
    pub fn dimension(&mut self, from: [f64; 2], to: [f64; 2], aside: f64, symbol: &'static str) {
        let (along, long) = direction(from, to);
        let left = [-along[1], along[0]];
        let [one, other] = [from, to].map(|point| towards(point, left, self.paper(aside)));
        let text = Text::same(symbol);
        let at = if self.measure([from, to], [one, other]) {
            let beyond = if aside < 0.0 { -1.0 } else { 1.0 };
            towards(towards(one, along, long / 2.0), left, beyond * self.beside(&text, left))
        } else {
            towards(other, along, self.paper(OUTSIDE) + self.beside(&text, along))
        };
        self.word(at, text);
    }

    /// A level dimension between two points, at the height `y`, with what it says above its line.
    pub fn level(&mut self, from: [f64; 2], to: [f64; 2], y: f64, text: Text) {
        let room = self.measure([from, to], [[from[0], y], [to[0], y]]);
        if self.paper(LETTER * length(&text)) < (to[0] - from[0]).abs() {
            self.label([f64::midpoint(from[0], to[0]), y], Side::Above, text);
        } else {
            // What has no room over its line stands beside it, behind the arrow from outside where there is one.
            let behind = if room { 0.0 } else { self.paper(OUTSIDE) };
            self.label([to[0].max(from[0]) + behind, y], Side::Right, text);
        }
    }

    /// An upright dimension between two points, at the distance `x`, with what it says on one side of its line.
    pub fn upright(&mut self, from: [f64; 2], to: [f64; 2], x: f64, side: Side, text: Text) {
        self.measure([from, to], [[x, from[1]], [x, to[1]]]);
        self.label([x, f64::midpoint(from[1], to[1])], side, text);
    }

    /// A radius, from the centre to a circle; the symbol stands `aside` of the arrow's middle, in mm of paper, to its left.
    pub fn radius(&mut self, centre: [f64; 2], radius: f64, degrees: f64, aside: f64, symbol: &'static str) {
        let end = on_circle(centre, radius, degrees);
        self.arrow(Ink::Dimension, [centre, end]);
        let (along, long) = direction(centre, end);
        let at = towards(towards(centre, along, long / 2.0), [-along[1], along[0]], self.paper(aside));
        self.word(at, Text::same(symbol));
    }

    /// An angle between two directions about a point, with its symbol beyond the arc.
    pub fn angle(&mut self, centre: [f64; 2], radius: f64, [from, to]: [f64; 2], symbol: &'static str) {
        let middle = f64::midpoint(from, to);
        self.turn(Ink::Dimension, centre, radius, [middle, to]);
        self.turn(Ink::Dimension, centre, radius, [middle, from]);
        let (text, (way, _)) = (Text::same(symbol), direction(centre, on_circle(centre, 1.0, middle)));
        let at = on_circle(centre, radius + self.beside(&text, way), middle);
        self.word(at, text);
    }

    /// A symbol with an arrow from it to what it is of.
    pub fn pointer(&mut self, from: [f64; 2], to: [f64; 2], symbol: &'static str) {
        let (text, (along, _)) = (Text::same(symbol), direction(from, to));
        self.arrow(Ink::Dimension, [towards(from, along, self.beside(&text, along)), to]);
        self.word(from, text);
    }

    /// How far the middle of a text stands from what it is beside of, in a direction: a text is wider than it is high.
    fn beside(&self, text: &Text, [dx, _]: [f64; 2]) -> f64 {
        self.paper(BESIDE + LETTER / 2.0 * length(text) * dx.abs())
    }

    /// Extension lines from points to the ends of a dimension line, and that line with its arrow heads. False where there is no
    /// room between them: then they point from outside.
    fn measure(&mut self, of: [[f64; 2]; 2], [one, other]: [[f64; 2]; 2]) -> bool {
        let [gap, behind] = EXTENSION.map(|mm| self.paper(mm));
        for (point, end) in of.into_iter().zip([one, other]) {
            let (way, far) = direction(point, end);
            if far > gap {
                self.line(Ink::Thin, [towards(point, way, gap), towards(end, way, behind)]);
            }
        }
        let (along, long) = direction(one, other);
        let room = long >= self.paper(SHORT);
        if room {
            let middle = towards(one, along, long / 2.0);
            self.arrow(Ink::Dimension, [middle, one]);
            self.arrow(Ink::Dimension, [middle, other]);
        } else {
            let outside = self.paper(OUTSIDE);
            self.arrow(Ink::Dimension, [towards(one, along, -outside), one]);
            self.arrow(Ink::Dimension, [towards(other, along, outside), other]);
            self.line(Ink::Dimension, [one, other]);
        }
        room
    }

    /// The finished figure; `height` is its greatest height in print, mm.
    #[must_use]
    pub fn figure(self, key: &'static str, height: f64, caption: Text) -> Figure {
        let Self { strokes, labels, .. } = self;
        Figure { key, height, letters: Figure::SKETCHED, caption, axes: None, strokes, labels, legend: Vec::new() }
    }
}

/// How many letters a label has in the longer of its languages.
fn length(text: &Text) -> f64 {
    letters(&text.es).max(letters(&text.en))
}

/// The point so far from another along a direction of unit length.
fn towards([x, y]: [f64; 2], [dx, dy]: [f64; 2], by: f64) -> [f64; 2] {
    [x + dx * by, y + dy * by]
}

/// The direction from one point to another, and how far it is.
fn direction(from: [f64; 2], to: [f64; 2]) -> ([f64; 2], f64) {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let long = (dx * dx + dy * dy).sqrt();
    if long > 0.0 { ([dx / long, dy / long], long) } else { ([1.0, 0.0], 0.0) }
}

/// The point at an angle on a circle.
#[must_use]
pub fn on_circle([x, y]: [f64; 2], radius: f64, degrees: f64) -> [f64; 2] {
    let (sin, cos) = sin_cos(degrees.to_radians());
    [x + radius * cos, y + radius * sin]
}

/// The points of an arc between two angles.
#[must_use]
pub fn arc(centre: [f64; 2], radius: f64, [from, to]: [f64; 2]) -> Vec<[f64; 2]> {
    const PARTS: u8 = 48;
    (0..=PARTS).map(|at| on_circle(centre, radius, from + (to - from) * f64::from(at) / f64::from(PARTS))).collect()
}

/// What a dimension says: its symbol, where it has one, and its length in mm.
#[must_use]
pub fn sized(symbol: &str, length: f64) -> Text {
    let number = shown(length, 3);
    Text::same(if symbol.is_empty() { number } else { format!("{symbol} = {number}") })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The points of strokes and labels, in mm of paper.
    fn points(sketch: &Sketch) -> Vec<[f64; 2]> {
        let strokes = sketch.strokes.iter().flat_map(|stroke| &stroke.points);
        strokes.chain(sketch.labels.iter().map(|label| &label.at)).map(|at| at.map(|one| one / sketch.unit)).collect()
    }

    fn drawn(mut sketch: Sketch) -> Sketch {
        let at = |x: f64, y: f64| [x, y].map(|mm| sketch.paper(mm));
        let [a, b, c] = [at(0.0, 0.0), at(30.0, 0.0), at(30.0, 4.0)];
        sketch.dimension(a, b, 5.0, "L");
        sketch.dimension(b, c, -5.0, "h");
        let y = sketch.paper(20.0);
        sketch.level(a, c, y, sized("D", 3.0));
        sketch.upright(b, c, y, Side::Right, sized("", 4.0));
        let radius = sketch.paper(9.0);
        sketch.radius(a, radius, 30.0, 2.0, "r");
        sketch.angle(a, radius, [0.0, 60.0], "theta");
        sketch.pointer(c, a, "e");
        sketch.zero(b);
        sketch
    }

    #[test]
    fn on_paper_a_sketch_is_the_same_whatever_its_scale() {
        let paper = points(&drawn(Sketch::on_paper()));
        let thing = points(&drawn(Sketch::new([700.0, 10.0], [100.0, 50.0])));
        assert_eq!(paper.len(), thing.len());
        for (one, other) in paper.iter().zip(&thing) {
            assert!((one[0] - other[0]).abs() < 1e-9 && (one[1] - other[1]).abs() < 1e-9, "{one:?} {other:?}");
        }
    }

    #[test]
    fn a_dimension_without_room_has_its_arrows_and_its_symbol_outside() {
        let ends = |long: f64| {
            let mut sketch = Sketch::on_paper();
            sketch.dimension([0.0, 0.0], [long, 0.0], 3.0, "a_p");
            let arrows: Vec<_> = sketch.strokes.iter().filter(|one| one.arrow).map(|one| one.points.clone()).collect();
            (arrows, sketch.labels[0].at[0])
        };
        let (arrows, symbol) = ends(20.0);
        assert_eq!(arrows, [[[10.0, 3.0], [0.0, 3.0]], [[10.0, 3.0], [20.0, 3.0]]]);
        assert_eq!(symbol, 10.0);
        let (arrows, symbol) = ends(5.0);
        assert_eq!(arrows, [[[-4.0, 3.0], [0.0, 3.0]], [[9.0, 3.0], [5.0, 3.0]]]);
        assert!(symbol > 9.0);
    }
}
