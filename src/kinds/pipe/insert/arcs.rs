//! Arcs through triples of points, as published: circle, turn and radius, and the columns of table 2.
//!
//! Points 0-1-2, 2-3-4, …: the circle x² + y² + Dx + Ey + F = 0 through three consecutive points, G03 where they turn
//! left and G02 where they turn right (equations 10 to 19). With an odd number of steps the last one is straight.
//!
//! Points that lie on a line, or so nearly that no control takes the radius, are joined by a straight move, and so are those of
//! more than half a circle, which a radius alone does not tell: by one move where it leaves the middle point by no more than the
//! tolerance, else by one to each point.
//!
//! # Slips of the source
//! Table 2 prints half of D and E, and evaluates equation 18 with them; equations 16 and 18 have −2 − (dy/dx)² where
//! −2 − 2(dy/dx)² is right. The signs, and so the codes, are not affected.
//!
//! # Units
//! Millimetres.

use nalgebra::Vector2;

use crate::geometry::circle::{Circle, through};
use crate::number::grid::LIMIT;

/// Three points with the circle through them, or a last single step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triple {
    /// The index of the point where it ends.
    pub j: usize,
    /// The point where it starts.
    pub from: Vector2<f64>,
    /// The point where it ends.
    pub to: Vector2<f64>,
    /// The circle; `None` for a straight move.
    pub circle: Option<Circle>,
}

impl Triple {
    /// D and E of the circle's equation; 0 where there is none.
    #[must_use]
    pub fn D_E(&self) -> [f64; 2] {
        self.circle.map_or([0.0; 2], |circle| [-2.0 * circle.centre.x, -2.0 * circle.centre.y])
    }

    /// F of the circle's equation; 0 where there is none.
    #[must_use]
    pub fn F(&self) -> f64 {
        self.circle.map_or(0.0, |circle| circle.centre.norm_squared() - circle.radius * circle.radius)
    }

    /// The second derivative at the end: −2(1 + y′²)/(2y + E); 0 where there is no circle.
    #[must_use]
    pub fn second_derivative(&self) -> f64 {
        let [D, E] = self.D_E();
        let (below, beside) = (2.0 * self.to.y + E, 2.0 * self.to.x + D);
        if self.circle.is_none() { 0.0 } else { -2.0 * (below * below + beside * beside) / (below * below * below) }
    }

    /// The last column of table 2 as it was printed: equation 18 with its slip, from half of D and E.
    #[must_use]
    pub fn equation_18_as_printed(&self) -> f64 {
        let [D, E] = self.D_E().map(|value| value / 2.0);
        let (below, beside) = (2.0 * self.to.y + E, -2.0 * self.to.x - D);
        if self.circle.is_none() { 0.0 } else { (-2.0 * below * below - beside * beside) / (below * below * below) }
    }

    /// `G03`, `G02`, or `G01` for a straight move.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self.circle {
            Some(Circle { left: true, .. }) => "G03",
            Some(_) => "G02",
            None => "G01",
        }
    }
}

/// The circle of an arc through three points that a control can be given by its radius; `None` where there is none: points on
/// a line, a radius beyond the format, or more than half a circle.
#[must_use]
pub fn arc_through(points: [Vector2<f64>; 3]) -> Option<Circle> {
    let [first, second, third] = points;
    let half = (first - second).dot(&(third - second)) <= 0.0;
    through(points).filter(|circle| half && circle.radius * 1000.0 < f64::from(LIMIT))
}

/// How far a straight move past a point leaves it, mm.
#[must_use]
pub fn bow([first, second, third]: [Vector2<f64>; 3]) -> f64 {
    let (chord, to) = (third - first, second - first);
    let part = to.dot(&chord) / chord.norm_squared();
    if part.is_finite() { (to - chord * part.clamp(0.0, 1.0)).norm() } else { to.norm() }
}

/// The triples along points, and the straight moves where no arc goes through them within a tolerance in mm.
#[must_use]
pub fn triples(points: &[Vector2<f64>], tolerance: f64) -> Vec<Triple> {
    let mut triples = Vec::with_capacity(points.len() / 2 + 1);
    let mut at = 0;
    while let Some(rest) = points.get(at..).filter(|rest| rest.len() > 1) {
        let mut go = |from: usize, to: usize, circle| {
            triples.push(Triple { j: at + to, from: rest[from], to: rest[to], circle });
        };
        at += match *rest {
            [first, second, third, ..] => {
                let points = [first, second, third];
                match arc_through(points) {
                    None if bow(points) > tolerance => {
                        go(0, 1, None);
                        go(1, 2, None);
                    }
                    circle => go(0, 2, circle),
                }
                2
            }
            _ => {
                go(0, 1, None);
                1
            }
        };
    }
    triples
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_radius_beyond_the_format_is_a_straight_move_within_the_tolerance() {
        let points = |up: f64| [Vector2::new(0.0, 0.0), Vector2::new(50.0, up), Vector2::new(100.0, 0.0)];
        // R = (50² + up²)/(2 up): 12 500 mm, 125 000 mm.
        assert!(triples(&points(0.1), 0.05)[0].circle.is_some());
        let moves =
            |tolerance| triples(&points(0.01), tolerance).iter().map(|one| (one.j, one.code())).collect::<Vec<_>>();
        assert_eq!(moves(0.02), [(2, "G01")]);
        assert_eq!(moves(0.005), [(1, "G01"), (2, "G01")]);
    }

    #[test]
    fn more_than_half_a_circle_is_no_arc() {
        let points = [Vector2::new(0.0, 0.0), Vector2::new(1.0, 9.0), Vector2::new(2.0, 0.0)];
        assert_eq!(triples(&points, 0.1).iter().map(Triple::code).collect::<Vec<_>>(), ["G01", "G01"]);
    }
}
