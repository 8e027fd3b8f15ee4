//! The splitter blade (annex 10): where its path meets its neighbour's, and how it fades out towards the hub.
//!
//! # References
//! The thesis, section 4.3 and annex 10. The text says that the offset grows linearly; the table is the fifth power.

use std::f64::consts::PI;

use nalgebra::{Vector2, Vector3};

use crate::geometry::polyline::{Crossing, first_crossing};
use crate::impeller::blade::{Blade, Vectors};
use crate::impeller::tool_path::{part_path, tapered};
use crate::number::trig::sin_cos;

/// The splitter blade between two blades.
#[derive(Clone, Debug)]
pub struct Splitter {
    /// Where the path along the splitter crosses the path along its neighbour, in plan (XY of the part).
    pub crossing: Crossing,
    /// m, the first point index at or past the crossing: full offset from there on.
    pub m: usize,
    /// f_j, the fraction of the full offset at each point.
    pub fraction: Vec<f64>,
    /// Path 1, towards the exit: P″ − w·f·b″ − a_p·N″, machine coordinates, mm.
    pub out: Vectors,
    /// Path 2, run back from the exit: P″ + w·f·b″ − a_p·N″, machine coordinates, mm.
    pub back: Vectors,
}

/// Why there is no splitter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoSplitter {
    /// The paths do not cross: the tool passes between the blades over their whole length.
    #[error("the paths do not cross")]
    NoCrossing,
    /// The paths cross before the second point: nothing is left to fade over.
    #[error("the paths cross at the first point")]
    AtFirstPoint,
}

/// The path at +w and the neighbour's at −w, both in plan; the neighbour stands half a blade pitch, π/N, away on the
/// side of +b (towards −C).
#[must_use]
pub fn plan_paths(blade: &Blade, N: u32, w: f64, a_p: f64) -> [Vec<Vector2<f64>>; 2] {
    let (sin, cos) = sin_cos(-PI / f64::from(N));
    let plan = |P: &Vector3<f64>| Vector2::new(P.x, P.y);
    let own = part_path(blade, w, a_p).iter().map(plan).collect();
    let neighbour =
        part_path(blade, -w, a_p).iter().map(|P| Vector2::new(P.x * cos - P.y * sin, P.x * sin + P.y * cos)).collect();
    [own, neighbour]
}

/// f_j = ((j+1)/(m+1))⁵ up to the point m, 1 after it.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
pub fn fraction(j: usize, m: usize) -> f64 {
    if j >= m {
        return 1.0;
    }
    let x = (j + 1) as f64 / (m + 1) as f64;
    x * x * x * x * x
}

impl Splitter {
    /// The splitter between N blades with the half width w and the depth a_p (mm).
    ///
    /// # Errors
    /// Where the paths do not cross, or cross before the second point.
    pub fn new(blade: &Blade, N: u32, w: f64, a_p: f64) -> Result<Self, NoSplitter> {
        let [own, neighbour] = plan_paths(blade, N, w, a_p);
        let crossing = first_crossing(&own, &neighbour).ok_or(NoSplitter::NoCrossing)?;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within the points of the path")]
        let m = crossing.along_first.ceil() as usize;
        if m < 2 {
            return Err(NoSplitter::AtFirstPoint);
        }
        let fraction: Vec<f64> = (0..blade.points()).map(|j| fraction(j, m)).collect();
        let out = tapered(blade, a_p, |i| -w * fraction[i]);
        let back = tapered(blade, a_p, |i| w * fraction[i]);
        Ok(Self { crossing, m, fraction, out, back })
    }
}
