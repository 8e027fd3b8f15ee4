//! Clearance to the other blades while the tool cuts.
//!
//! The tool, a cylinder along its axis in the pose that the text gives, is held against both flanks of the blades and
//! splitters on either side; those further round lie behind them. It is looked at in at least [`POSES`] poses a pass,
//! evenly along it; between two of them, and between the straight lines of a flank, the true distance is smaller by
//! less than R/5000.
//!
//! A splitter's flanks count from the point at which it stands in full: the paths on both of its sides have crossed its
//! neighbours' and have their whole offset. Before it the splitter ends in its neighbours' channels, which were cut before
//! it and are meant to cut it off. How far they still reach into it past the crossing, which is that of the tips in plan,
//! is said and not held against them. Its own passes must leave the blades alone, and where each side fades by itself
//! they do. One fraction for both sides, as published, is made for the side on which the paths cross first, and on the
//! other side the tool reaches the neighbour. That is for a person to judge, since it belongs to the published method;
//! anything else that cuts into a blade, or a splitter into a splitter, stops the work.

use std::f64::consts::{PI, TAU};

use nalgebra::Vector3;

use crate::impeller::blade::Blade;
use crate::impeller::design::Design;
use crate::impeller::solids::{Flanks, Tool};
use crate::impeller::splitter::Splitter;
use crate::impeller::track::Track;
use crate::machine::axis::{Axis, Pose};
use crate::machine::rotary::Rotary;
use crate::number::grid::Milli;
use crate::verify::agreement::tip;
use crate::verify::check::At;

/// Poses of a pass that are looked at.
pub const POSES: usize = 96;

/// The least clearance that was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clearance {
    /// The distance, mm; negative where the tool cuts into the flank.
    pub distance: f64,
    /// The point index along the other blade.
    pub other: f64,
    /// Where the tool is.
    pub at: At,
}

/// What the tool of a track may meet.
#[derive(Clone, Copy, Debug, Default)]
pub struct Clearances {
    /// The least to the neighbouring blades; `None` where there are none.
    pub blades: Option<Clearance>,
    /// The least to the neighbouring splitters.
    pub splitters: Option<Clearance>,
}

/// The blades and splitters about one.
#[derive(Clone, Debug)]
pub struct Neighbours {
    flanks: Flanks,
    machine: Rotary,
    radius: f64,
    N: u32,
    /// From which point index on a splitter stands in full.
    full: Option<f64>,
}

impl Neighbours {
    /// The neighbours in a design.
    #[must_use]
    pub fn new(design: &Design, blade: &Blade, splitter: Option<&Splitter>) -> Self {
        Self {
            flanks: Flanks::new(blade, design.n, design.e, design.a_p),
            machine: design.machine,
            radius: design.d_t / 2.0,
            N: design.N,
            full: splitter.map(Splitter::full_from),
        }
    }

    /// Lowers the clearances to what the tool has in a pose on a track, its C turned back by `turn`.
    pub fn look(&self, pose: &Pose, turn: Milli, track: Track, at: At, found: &mut Clearances) {
        let mut own = *pose;
        own.set(Axis::C, pose.get(Axis::C) - turn.value());
        let angle = |axis: Axis| own.get(axis).to_radians();
        let axis = Rotary::direction_to_part(&Vector3::z(), angle(Axis::B), angle(Axis::C));
        let tool = Tool { tip: tip(self.machine, &own), axis, radius: self.radius };
        let pitch = TAU / f64::from(self.N);
        let (like, other) = ((self.N > 1).then_some(pitch), Some(PI / f64::from(self.N)));
        let (to_blades, to_splitters) = if track.of_splitter() { (other, like) } else { (like, other) };
        let lower = |known: &mut Option<Clearance>, angle: Option<f64>, from: f64| {
            for angle in angle.into_iter().flat_map(|angle| [angle, -angle]) {
                let least = known.map_or(f64::INFINITY, |known| known.distance);
                if let Some(nearest) = self.flanks.nearest(&tool.turned(angle), from, least) {
                    *known = Some(Clearance { distance: nearest.distance, other: nearest.x, at });
                }
            }
        };
        lower(&mut found.blades, to_blades, 0.0);
        if let Some(full) = self.full {
            lower(&mut found.splitters, to_splitters, full);
        }
    }
}
