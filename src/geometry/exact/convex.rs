//! Convex polygons on the grid, and what they sweep.

use super::grid::{Line, Point, UNITS};
use crate::number::trig::hypot;

/// What made an edge of a swept polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// The edge of this number of the polygon that was moved.
    Edge(usize),
    /// The corner of this number, on its way.
    Corner(usize),
}

/// A convex polygon, counter-clockwise, no three corners on a line.
#[derive(Clone, Debug, Default)]
pub struct Convex {
    corners: Vec<Point>,
    lines: Vec<Line>,
    origins: Vec<Origin>,
}

impl Convex {
    /// The hull of points; `None` where they lie on a line or beyond the grid.
    ///
    /// Andrew's monotone chain: sorted by z, the lower and the upper half one after the other.
    #[must_use]
    pub fn hull(points: &[Point]) -> Option<Self> {
        let mut points = points.to_vec();
        points.sort_unstable();
        points.dedup();
        if !points.iter().all(|point| point.on_grid()) {
            return None;
        }
        let half = |points: &mut dyn Iterator<Item = &Point>| {
            let mut chain: Vec<Point> = Vec::new();
            for &next in points {
                while let [.., before, last] = chain[..]
                    && before.to(last).cross(before.to(next)) <= 0
                {
                    chain.pop();
                }
                chain.push(next);
            }
            chain.pop();
            chain
        };
        let mut corners = half(&mut points.iter());
        corners.extend(half(&mut points.iter().rev()));
        (corners.len() >= 3).then(|| Self::of(corners))
    }

    /// The hull of points in mm, `[z, r]`.
    #[must_use]
    pub fn hull_mm(points: &[[f64; 2]]) -> Option<Self> {
        Self::hull(&points.iter().map(|&point| Point::near(point)).collect::<Option<Vec<_>>>()?)
    }

    fn of(corners: Vec<Point>) -> Self {
        let mut made = Self { origins: (0..corners.len()).map(Origin::Edge).collect(), corners, lines: Vec::new() };
        made.draw_lines();
        made
    }

    fn draw_lines(&mut self) {
        self.lines.clear();
        let ends = self.corners.iter().cycle().skip(1);
        self.lines.extend(self.corners.iter().zip(ends).map(|(&from, &to)| Line::through(from, to)));
    }

    /// How many corners, and edges, there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.corners.len()
    }

    /// True for a polygon that was never filled.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.corners.is_empty()
    }

    /// The corners, counter-clockwise, in nanometres.
    #[must_use]
    pub fn corners(&self) -> &[Point] {
        &self.corners
    }

    /// The edges' lines, each from the corner of its number to the next; the polygon is to their left.
    #[must_use]
    pub fn lines(&self) -> &[Line] {
        &self.lines
    }

    /// What made each edge.
    #[must_use]
    pub fn origins(&self) -> &[Origin] {
        &self.origins
    }

    /// The least and the greatest coordinates.
    #[must_use]
    pub fn extent(&self) -> (Point, Point) {
        let low = |pick: fn(&Point) -> i64| self.corners.iter().map(pick).min().unwrap_or(0);
        let high = |pick: fn(&Point) -> i64| self.corners.iter().map(pick).max().unwrap_or(0);
        (Point { z: low(|p| p.z), r: low(|p| p.r) }, Point { z: high(|p| p.z), r: high(|p| p.r) })
    }

    /// How deep this polygon and another are in each other, mm: how far one has to move, straight across one of the edges of
    /// either, until they only touch; and where, `[z, r]` in mm: the middle of what lies deepest behind that edge, of
    /// two as near the other's. `None` where they do not overlap.
    ///
    /// Two convex polygons are apart if and only if an edge of one of them has the other on its outer side.
    #[must_use]
    pub fn overlap(&self, other: &Self) -> Option<(f64, [f64; 2])> {
        let mut least = f64::INFINITY;
        let mut across = None;
        for (one, two) in [(other, self), (self, other)] {
            for (edge, line) in one.lines.iter().enumerate() {
                let deepest = two.corners.iter().map(|&corner| line.at(corner)).max()?;
                if deepest <= 0 {
                    return None;
                }
                let Point { z, r } = line.direction();
                #[expect(clippy::cast_precision_loss, reason = "a depth to show, and to hold against a micrometre")]
                let deep = deepest as f64 / hypot(z as f64, r as f64) / UNITS;
                if deep < least {
                    (least, across) = (deep, Some((one, edge)));
                }
            }
        }
        let (one, edge) = across?;
        let shared = self.shared(other);
        let far: Vec<f64> = shared.iter().map(|&point| one.inside(edge, point)).collect();
        let most = far.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        // Corners of what is shared that lie equally deep are the ends of one edge.
        let ends = || shared.iter().zip(&far).filter(|(_, far)| **far > most - 1e-7).map(|(point, _)| *point);
        let bound = |axis: usize, pick: fn(f64, f64) -> f64| ends().map(|end| end[axis]).reduce(pick);
        let middle = |axis: usize| Some(f64::midpoint(bound(axis, f64::min)?, bound(axis, f64::max)?));
        Some((least, [middle(0)?, middle(1)?]))
    }

    /// How far a point lies to the left of an edge, mm.
    fn inside(&self, edge: usize, [z, r]: [f64; 2]) -> f64 {
        let count = self.corners.len();
        let ([z1, r1], [z2, r2]) = (self.corners[edge % count].mm(), self.corners[(edge + 1) % count].mm());
        ((z2 - z1) * (r - r1) - (r2 - r1) * (z - z1)) / hypot(z2 - z1, r2 - r1)
    }

    /// The corners of what this polygon and another have in common, mm: this one's, cut off at each edge of the other
    /// (Sutherland and Hodgman).
    fn shared(&self, other: &Self) -> Vec<[f64; 2]> {
        let mut corners: Vec<[f64; 2]> = self.corners.iter().map(|corner| corner.mm()).collect();
        for edge in 0..other.len() {
            let next = corners.iter().cycle().skip(1);
            let mut left = Vec::with_capacity(corners.len() + 1);
            for (&from, &to) in corners.iter().zip(next) {
                let (one, two) = (other.inside(edge, from), other.inside(edge, to));
                if one >= 0.0 {
                    left.push(from);
                }
                if (one > 0.0 && two < 0.0) || (one < 0.0 && two > 0.0) {
                    let part = one / (one - two);
                    left.push([0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * part));
                }
            }
            corners = left;
        }
        corners
    }

    /// The polygon's mirror image across the axis r = 0.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let count = self.corners.len();
        let corners = self.corners.iter().rev().map(|point| Point { z: point.z, r: -point.r }).collect();
        // Edge i of the image runs between the images of corners count − 1 − i and count − 2 − i: edge count − 2 − i.
        let origins = (0..count).map(|i| self.origins[(2 * count - 2 - i) % count]).collect();
        let mut made = Self { corners, lines: Vec::new(), origins };
        made.draw_lines();
        made
    }

    /// The polygon with the corners that lie on the axis, below all others, a unit of the grid lower: what only touches the axis
    /// with a corner goes through it. `None` where its lowest corners are not on the axis.
    #[must_use]
    pub fn through_axis(&self) -> Option<Self> {
        let low = self.corners.iter().map(|corner| corner.r).min();
        (low == Some(0)).then(|| {
            let lower = |corner: &Point| Point { r: if corner.r == 0 { -1 } else { corner.r }, ..*corner };
            let corners = self.corners.iter().map(lower).collect();
            let mut made = Self { corners, lines: Vec::new(), origins: self.origins.clone() };
            made.draw_lines();
            made
        })
    }

    /// Fills `swept` with what this polygon covers while its origin moves straight from one point to another: the hull of
    /// both places, edge by edge. False, and `swept` empty, where it would leave the grid.
    ///
    /// Edges that look forward are taken at the end, those that look back at the start; between them runs a corner's
    /// way. An edge along the motion is drawn out.
    pub fn sweep(&self, from: Point, to: Point, swept: &mut Self) -> bool {
        let step = from.to(to);
        swept.corners.clear();
        swept.origins.clear();
        swept.lines.clear();
        let count = self.corners.len();
        // At which end of the motion an edge starts and ends.
        let ends = |edge: usize| {
            let along = self.lines[edge].direction();
            match step.cross(along) {
                0 if step.dot(along) > 0 => (false, true),
                0 if step.dot(along) < 0 => (true, false),
                ahead => (ahead > 0, ahead > 0),
            }
        };
        for edge in 0..count {
            let next = (edge + 1) % count;
            let ((start, end), (then, _)) = (ends(edge), ends(next));
            let place = |late: bool, corner: usize| self.corners[corner].plus(if late { to } else { from });
            swept.corners.push(place(start, edge));
            swept.origins.push(self.origins[edge]);
            if end != then {
                swept.corners.push(place(end, next));
                swept.origins.push(Origin::Corner(next));
            }
        }
        if !swept.corners.iter().all(|point| point.on_grid()) {
            swept.corners.clear();
            swept.origins.clear();
            return false;
        }
        swept.draw_lines();
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square() -> Convex {
        Convex::hull(&[(0, 0), (4, 0), (2, 0), (4, 4), (0, 4), (1, 1)].map(|(z, r)| Point { z, r })).unwrap()
    }

    #[test]
    fn a_hull_has_its_corners_alone_and_runs_counter_clockwise() {
        let square = square();
        assert_eq!(square.corners(), [(0, 0), (4, 0), (4, 4), (0, 4)].map(|(z, r)| Point { z, r }));
        assert!(square.lines().iter().all(|line| line.at(Point { z: 2, r: 2 }) > 0));
        assert!(Convex::hull(&[(0, 0), (2, 2), (5, 5)].map(|(z, r)| Point { z, r })).is_none());
        assert!(Convex::hull_mm(&[[0.0, 0.0], [2000.0, 0.0], [0.0, 1.0]]).is_none(), "off the grid");
    }

    #[test]
    fn a_sweep_is_the_hull_of_both_places_in_every_direction() {
        let shape = Convex::hull(&[(0, 0), (5, 1), (6, 4), (2, 7), (-1, 3)].map(|(z, r)| Point { z, r })).unwrap();
        let from = Point { z: 10, r: -20 };
        let mut swept = Convex::default();
        for z in -7..8 {
            for r in -7..8 {
                for shape in [&shape, &square()] {
                    let to = Point { z: from.z + z, r: from.r + r };
                    assert!(shape.sweep(from, to, &mut swept));
                    let both: Vec<_> =
                        shape.corners().iter().flat_map(|&corner| [corner.plus(from), corner.plus(to)]).collect();
                    let hull = Convex::hull(&both).unwrap();
                    let first = swept.corners().iter().position(|corner| *corner == hull.corners()[0]).unwrap();
                    let mut turned = swept.corners().to_vec();
                    turned.rotate_left(first);
                    assert_eq!(turned, hull.corners(), "{z} {r}");
                    for (line, origin) in swept.lines().iter().zip(swept.origins()) {
                        match *origin {
                            Origin::Edge(edge) => {
                                assert_eq!(line.direction().cross(shape.lines()[edge].direction()), 0)
                            }
                            Origin::Corner(_) => assert_eq!(line.direction().cross(Point { z, r }), 0),
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn polygons_that_touch_do_not_overlap() {
        let at = |z: i64, r: i64| {
            let corners: Vec<_> = square().corners().iter().map(|corner| corner.plus(Point { z, r })).collect();
            Convex::hull(&corners).unwrap()
        };
        assert_eq!(square().overlap(&at(4, 1)), None, "side by side");
        assert_eq!(square().overlap(&at(4, 4)), None, "corner to corner");
        assert_eq!(square().overlap(&at(9, 0)), None, "apart");
        // Behind the left edge of a square 1 nm inside from the right lies deepest this one's right, from (4, 1) to (4, 4).
        for (other, deep, place) in [(at(3, 1), 1e-6, [4e-6, 2.5e-6]), (at(-2, 1), 2e-6, [0.0, 2.5e-6])] {
            let (found, [z, r]) = square().overlap(&other).unwrap();
            assert!((found - deep).abs() < 1e-15, "{found}");
            assert!((z - place[0]).abs() < 1e-15 && (r - place[1]).abs() < 1e-15, "{z} {r}");
        }
    }

    #[test]
    fn a_mirror_image_keeps_what_made_its_edges() {
        let shape = Convex::hull(&[(0, 0), (5, 1), (6, 4), (2, 7)].map(|(z, r)| Point { z, r })).unwrap();
        let image = shape.mirrored();
        for (line, origin) in image.lines().iter().zip(image.origins()) {
            let Origin::Edge(edge) = *origin else { panic!("{origin:?}") };
            let was = shape.lines()[edge].direction();
            assert_eq!(line.direction(), Point { z: -was.z, r: was.r });
        }
    }
}
