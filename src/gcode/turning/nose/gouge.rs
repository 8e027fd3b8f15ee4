//! How near two pieces of paths come: whether the nose on one piece cuts into another that is not its neighbour.
//!
//! # Derivation
//! The distance of two pieces is 0 where they cross. Else it is that of an end to the other piece, or, where an arc takes part, that
//! along the line from its centre at right angles to the other piece: there the
//! derivative of the distance along the arc is 0.

use std::collections::VecDeque;
use std::f64::consts::TAU;

use crate::gcode::turning::nose::ROUNDING;
use crate::gcode::turning::nose::element::{Element, Path, Point, cross, distance, dot, plus};
use crate::limits::GOUGE_PIECES;
use crate::number::trig;

/// The nose cuts into a piece of the programmed path that is not a neighbour of the one it follows, which a control's check
/// of neighbouring pieces does not see.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gouge<T> {
    /// How deep, mm.
    pub depth: f64,
    /// The nose radius, mm.
    pub radius: f64,
    /// The piece that the nose follows.
    pub along: T,
    /// The piece that it cuts into.
    pub into: T,
}

/// The last pieces, each with the ways of the nose's centre along it.
pub(super) struct Trail<T> {
    pieces: VecDeque<(Element, Vec<Element>, T)>,
    pub(super) cuts: Vec<Gouge<T>>,
}

impl<T: Clone> Trail<T> {
    pub(super) const fn new() -> Self {
        Self { pieces: VecDeque::new(), cuts: Vec::new() }
    }

    /// Another contour begins.
    pub(super) fn clear(&mut self) {
        self.pieces.clear();
    }

    /// The next piece of the contour, with the ways of the nose's centre along it.
    pub(super) fn add(&mut self, piece: Element, ways: Vec<Element>, radius: f64, tag: &T) {
        let depth = |ways: &[Element], into: &Element| {
            radius - ways.iter().map(|way| nearest(way, into)).fold(f64::INFINITY, f64::min)
        };
        for (earlier, trodden, of) in &self.pieces {
            let (now, then) = (depth(&ways, earlier), depth(trodden, &piece));
            if now.max(then) <= 2.0 * ROUNDING {
                continue;
            }
            let (along, into) = if now >= then { (tag, of) } else { (of, tag) };
            self.cuts.push(Gouge { depth: now.max(then), radius, along: along.clone(), into: into.clone() });
        }
        if self.pieces.len() == GOUGE_PIECES {
            self.pieces.pop_front();
        }
        self.pieces.push_back((piece, ways, tag.clone()));
    }
}

/// The least distance of two pieces, mm.
pub(super) fn nearest(one: &Element, other: &Element) -> f64 {
    if crossings(one, other).into_iter().flatten().any(|point| holds(one, point) && holds(other, point)) {
        return 0.0;
    }
    let mut least = f64::INFINITY;
    for (piece, ends) in [(one, [other.from, other.to]), (other, [one.from, one.to])] {
        for end in ends {
            least = least.min(distance(end, piece.from)).min(distance(end, piece.to));
            for foot in feet(piece, end).into_iter().filter(|&foot| holds(piece, foot)) {
                least = least.min(distance(end, foot));
            }
        }
    }
    for (arc, piece) in [(one, other), (other, one)] {
        let Path::Arc { centre, .. } = arc.path else { continue };
        for foot in feet(piece, centre).into_iter().filter(|&foot| holds(piece, foot)) {
            for on in feet(arc, foot).into_iter().filter(|&on| holds(arc, on)) {
                least = least.min(distance(foot, on));
            }
        }
    }
    least
}

/// Whether a point of the line or circle that a piece is part of lies on the piece.
fn holds(piece: &Element, point: Point) -> bool {
    match piece.path {
        Path::Arc { centre, sweep } => {
            let [from, there] = [piece.from, point].map(|point| plus(point, centre, -1.0));
            let angle = trig::atan2(cross(from, there), dot(from, there));
            let past = if sweep < 0.0 { -angle } else { angle };
            (if past < 0.0 { past + TAU } else { past }) <= sweep.abs()
        }
        _ => {
            let along = plus(piece.to, piece.from, -1.0);
            let way = dot(plus(point, piece.from, -1.0), along);
            (0.0..=dot(along, along)).contains(&way)
        }
    }
}

/// The points of the line or circle that a piece is part of where the way to a point is at right angles to it.
fn feet(piece: &Element, point: Point) -> [Point; 2] {
    match piece.path {
        Path::Arc { centre, .. } => {
            let out = plus(point, centre, -1.0);
            let share = distance(piece.from, centre) / distance(point, centre);
            [plus(centre, out, share), plus(centre, out, -share)]
        }
        _ => {
            let along = plus(piece.to, piece.from, -1.0);
            let share = dot(plus(point, piece.from, -1.0), along) / dot(along, along);
            [plus(piece.from, along, share); 2]
        }
    }
}

/// The points that the lines or circles of two pieces have in common.
fn crossings(one: &Element, other: &Element) -> [Option<Point>; 2] {
    match (one.path, other.path) {
        (Path::Arc { centre, .. }, Path::Arc { centre: second, .. }) => {
            // Both are on the line on which the powers to the two circles are equal.
            let (r, R) = (distance(one.from, centre), distance(other.from, second));
            let apart = distance(centre, second);
            let along = plus(second, centre, -1.0).map(|share| share / apart);
            let way = (apart * apart + r * r - R * R) / (2.0 * apart);
            let half = r * r - way * way;
            if !(half >= 0.0 && apart > 0.0) {
                return [None; 2];
            }
            let middle = plus(centre, along, way);
            [1.0, -1.0].map(|side| Some(plus(middle, [-along[1], along[0]], side * half.sqrt())))
        }
        (Path::Arc { centre, .. }, _) => on_circle(other, centre, distance(one.from, centre)),
        (_, Path::Arc { centre, .. }) => on_circle(one, centre, distance(other.from, centre)),
        _ => {
            let [first, second] = [one, other].map(|piece| plus(piece.to, piece.from, -1.0));
            let share = cross(plus(other.from, one.from, -1.0), second) / cross(first, second);
            [share.is_finite().then(|| plus(one.from, first, share)), None]
        }
    }
}

fn on_circle(line: &Element, centre: Point, radius: f64) -> [Option<Point>; 2] {
    let [foot, _] = feet(line, centre);
    let away = distance(foot, centre);
    let length = distance(line.from, line.to);
    let half = radius * radius - away * away;
    if !(half >= 0.0 && length > 0.0) {
        return [None; 2];
    }
    let along = plus(line.to, line.from, -1.0).map(|share| share / length);
    [1.0, -1.0].map(|side| Some(plus(foot, along, side * half.sqrt())))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(from: Point, to: Point) -> Element {
        Element { from, to, path: Path::Line }
    }

    fn arc(centre: Point, radius: f64, start: f64, sweep: f64) -> Element {
        let at = |angle: f64| plus(centre, [trig::cos(angle), trig::sin(angle)], radius);
        Element { from: at(start), to: at(start + sweep), path: Path::Arc { centre, sweep } }
    }

    fn points(piece: &Element) -> Vec<Point> {
        (0..=400)
            .map(|step| {
                let part = f64::from(step) / 400.0;
                match piece.path {
                    Path::Arc { centre, sweep } => {
                        let out = plus(piece.from, centre, -1.0);
                        let (sin, cos) = trig::sin_cos(sweep * part);
                        plus(centre, [out[0] * cos - out[1] * sin, out[0] * sin + out[1] * cos], 1.0)
                    }
                    _ => plus(piece.from, plus(piece.to, piece.from, -1.0), part),
                }
            })
            .collect()
    }

    /// Against all pairs of 401 points on each: near to half a step.
    #[test]
    fn the_distance_is_that_of_the_nearest_points() {
        let mut state = 1_u64;
        let mut next = |from: f64, to: f64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            #[expect(clippy::cast_precision_loss, reason = "a number by chance")]
            let share = (state >> 40) as f64 / (1_u64 << 24) as f64;
            from + (to - from) * share
        };
        let mut apart = 0;
        for case in 0..300 {
            let mut piece = |straight: bool| {
                if straight {
                    line([next(-5.0, 5.0), next(-5.0, 5.0)], [next(-5.0, 5.0), next(-5.0, 5.0)])
                } else {
                    arc([next(-5.0, 5.0), next(-5.0, 5.0)], next(0.5, 4.0), next(-3.0, 3.0), next(-6.2, 6.2))
                }
            };
            let (one, other) = (piece(case % 2 == 0), piece(case % 3 == 0));
            let found = nearest(&one, &other);
            let theirs = points(&one)
                .iter()
                .flat_map(|&p| points(&other).into_iter().map(move |q| distance(p, q)))
                .fold(f64::INFINITY, f64::min);
            let step = (one.length() + other.length()) / 800.0;
            assert!(found <= theirs + 1e-12 && found >= theirs - step, "{one:?} {other:?}: {found}, {theirs}");
            apart += usize::from(found > 0.0);
        }
        assert!((50..280).contains(&apart), "{apart}");
    }
}
