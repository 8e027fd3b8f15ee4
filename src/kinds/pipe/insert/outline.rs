//! The curve to cut on the development, and the path of the torch beside it.
//!
//! # Frame
//! x runs round the pipe, 2πρ long, ρ the radius of the development; y runs along the pipe towards the header. What is
//! kept of the branch lies below the curve, the waste above it.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::TAU;

use nalgebra::Vector2;

use crate::geometry::pipe_pair::Side;
use crate::geometry::pipe_wall::{PipeWall, Seat};
use crate::number::trig::hypot;

/// The curve on a development, and the torch's path at a distance from it on the side of the waste.
#[derive(Clone, Copy, Debug)]
pub struct Outline {
    /// What the end is cut along.
    pub seat: Seat,
    /// The branch's wall over the header.
    pub wall: PipeWall,
    /// ρ, half the diameter of the surface that is developed.
    pub radius: f64,
    /// Z, how far up the branch the sheet's lower edge is from the curve at φ = 0.
    pub Z: f64,
    /// The torch's distance from the curve: half the kerf.
    pub beside: f64,
}

impl Outline {
    /// The length of the development, once round.
    #[must_use]
    pub fn round(&self) -> f64 {
        TAU * self.radius
    }

    /// How long the torch's path along the curve is, once round, mm, to a thousandth of it.
    #[must_use]
    pub fn path_round(&self) -> f64 {
        const STEPS: u16 = 720;
        let angle = |step: u16| TAU * f64::from(step) / f64::from(STEPS);
        let part = |step| self.torch(angle(step + 1), Side::Before) - self.torch(angle(step), Side::After);
        (0..STEPS).map(|step| part(step).norm()).sum()
    }

    /// The point of the curve at φ (radians), mm: x = ρ·φ, y = depth + Z.
    #[must_use]
    pub fn curve(&self, phi: f64) -> Vector2<f64> {
        Vector2::new(self.radius * phi, self.seat.depth(phi) + self.Z)
    }

    /// The direction of the curve at φ, of length 1.
    #[must_use]
    pub fn along(&self, phi: f64, side: Side) -> Vector2<f64> {
        let (round, down) = (self.radius, self.seat.slope(phi, side));
        Vector2::new(round, down) / hypot(round, down)
    }

    /// The direction across the curve into the waste, of length 1.
    #[must_use]
    pub fn across(&self, phi: f64, side: Side) -> Vector2<f64> {
        let along = self.along(phi, side);
        Vector2::new(-along.y, along.x)
    }

    /// The torch's place at φ; at a corner that at the end of one side.
    #[must_use]
    pub fn torch(&self, phi: f64, side: Side) -> Vector2<f64> {
        self.curve(phi) + self.across(phi, side) * self.beside
    }

    /// The angles φ at which the curve has a corner, radians, in one turn from 0 on.
    #[must_use]
    pub fn corners(&self) -> Vec<f64> {
        self.seat.corners()
    }

    /// How far along the branch's axis y is from the point of the axis nearest to the header's, mm: s of [`PipeWall`].
    #[must_use]
    pub fn s(&self, y: f64) -> f64 {
        self.seat.level() - (y - self.Z)
    }
}
