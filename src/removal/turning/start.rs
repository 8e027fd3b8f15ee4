//! What a simulation starts from: machine, blank and turret.

use super::machine::Lathe;
use super::stock::{Fixture, Stock};
use super::turret::Turret;
use crate::geometry::exact::region::Ring;
use crate::limits::SIMULATION_WORK;

/// What a simulation starts from.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// Origin, travel, chuck and tailstock.
    pub lathe: Lathe,
    /// The blank and how it is held.
    pub stock: Stock,
    /// The tools by place, and the turret's body.
    pub turret: Turret,
    /// How far chords may be from arcs, mm.
    pub tolerance: f64,
    /// The part to begin with instead of the blank, contours from W1 in mm, as for a second set-up; see
    /// [`super::stock::turned_about`].
    pub part: Option<Vec<Ring>>,
    /// Each step tells how the contour changed.
    pub record: bool,
    /// How many steps of work the simulation may take; see [`is_spent`](super::simulation::Simulation::is_spent).
    pub most_work: u64,
}

impl Setup {
    /// A blank in a lathe with a turret, with the usual tolerance of 0.0002 mm.
    #[must_use]
    pub const fn new(lathe: Lathe, stock: Stock, turret: Turret) -> Self {
        Self { lathe, stock, turret, tolerance: 0.0002, part: None, record: false, most_work: SIMULATION_WORK }
    }

    /// What stands still about the work; the jaws are closed on the part where there is one.
    #[must_use]
    pub fn fixtures(&self) -> Vec<(Fixture, Ring)> {
        let grip = self.part.as_deref().and_then(|part| self.stock.grip(&self.lathe, part));
        self.stock.fixtures(&self.lathe, grip.map_or(self.stock.diameter, |grip| grip.diameter))
    }
}
