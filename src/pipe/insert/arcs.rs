//! Arcs through triples of points, as published: circle, turn and radius, and the columns of table 2.
//!
//! Points 0-1-2, 2-3-4, …: the circle x² + y² + Dx + Ey + F = 0 through three consecutive points, G03 where they turn
//! left and G02 where they turn right (equations 10 to 19). With an odd number of steps the last one is straight.
//!
//! # Slips of the source
//! Table 2 prints half of D and E, and evaluates equation 18 with them; equations 16 and 18 have −2 − (dy/dx)² where
//! −2 − 2(dy/dx)² is right. The signs, and so the codes, are not affected.
//!
//! # Units
//! Millimetres.

use nalgebra::Vector2;

use crate::geometry::circle::{Circle, through};

/// Three points with the circle through them, or a last single step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triple {
    /// The index of the point where it ends.
    pub j: usize,
    /// The point where it starts.
    pub from: Vector2<f64>,
    /// The point where it ends.
    pub to: Vector2<f64>,
    /// The circle; `None` for a straight move: points on a line, or the last step of an odd number.
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

/// The triples along points.
#[must_use]
pub fn triples(points: &[Vector2<f64>]) -> Vec<Triple> {
    let mut triples = Vec::with_capacity(points.len() / 2 + 1);
    let mut at = 0;
    while let Some(rest) = points.get(at..).filter(|rest| rest.len() > 1) {
        let (steps, circle) = match *rest {
            [first, second, third, ..] => (2, through([first, second, third])),
            _ => (1, None),
        };
        at += steps;
        triples.push(Triple { j: at, from: rest[0], to: rest[steps], circle });
    }
    triples
}
