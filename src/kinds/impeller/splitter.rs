//! The splitter blade (annex 10): where its paths meet its neighbours', and how it fades out towards the hub.
//!
//! As published, one m and one fraction serve both sides: m is the first point at or past the crossing of the path at +w,
//! which `back` runs, with its neighbour's. By symmetry the path at −w, which `out` runs, crosses that of the neighbour
//! on its own side where the neighbour's path crosses the one at +w, many points later; there `out` stands in full too
//! early. With [`Fade::EachSide`] each side has an m of its own, from which its tool has [`room`](super::room).
//!
//! # References
//! The thesis, section 4.3 and annex 10. The text says that the offset grows linearly; the table is the fifth power.
//! The fade of each side is derived in [`room`](super::room).

use std::f64::consts::PI;

use nalgebra::{Vector2, Vector3};

use crate::geometry::polyline::{Crossing, first_crossing};
use crate::kinds::impeller::blade::{Blade, Vectors};
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::fade::{Fade, fraction};
use crate::kinds::impeller::room::Room;
use crate::kinds::impeller::tool_path::{part_path, tapered};
use crate::kinds::impeller::track::Track;
use crate::number::trig::sin_cos;

/// One side of a splitter, with the path beside it.
#[derive(Clone, Debug)]
pub struct Side {
    /// Where its path crosses that of the neighbour on its side, in plan: the index along it.
    pub crossing: f64,
    /// m, the point from which on the offset is full.
    pub m: usize,
    /// f_j, the fraction of the full offset at each point.
    pub fraction: Vec<f64>,
    /// The path, P″ ± w·f·b″ − a_p·N″, machine coordinates, mm.
    pub path: Vectors,
}

/// The splitter blade between two blades.
#[derive(Clone, Debug)]
pub struct Splitter {
    /// How its sides fade.
    pub fade: Fade,
    /// Where the path at +w crosses the neighbour's at −w, in plan (XY of the part); seen from the neighbour, where the
    /// path at −w crosses that of the blade on its side.
    pub crossing: Crossing,
    /// Path 1, towards the exit, at −w.
    pub out: Side,
    /// Path 2, run back from the exit, at +w.
    pub back: Side,
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
    /// Even a side that stands in full at the last point only leaves the tool no room beside the neighbour.
    #[error("the tool has no room beside the neighbouring blade")]
    NoRoom,
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

impl Splitter {
    /// The splitter of a design between two of its blades.
    ///
    /// # Errors
    /// Where the paths do not cross, or cross before the second point; with [`Fade::EachSide`] also where a side has no
    /// room however it fades.
    pub fn new(design: &Design, blade: &Blade) -> Result<Self, NoSplitter> {
        let [own, neighbour] = plan_paths(blade, design.N, design.w(), design.a_p);
        let crossing = first_crossing(&own, &neighbour).ok_or(NoSplitter::NoCrossing)?;
        let first = at_or_past(crossing.along_first);
        let [out, back] = match design.splitter_fade {
            Fade::Published => [first; 2],
            Fade::EachSide => {
                let room = Room::new(design, blade);
                let least = |track, from| room.least(track, from).ok_or(NoSplitter::NoRoom);
                [least(Track::Out, at_or_past(crossing.along_second))?, least(Track::Back, first)?]
            }
        };
        if out.min(back) < 2 {
            return Err(NoSplitter::AtFirstPoint);
        }
        let side = |track: Track, crossing: f64, m: usize| {
            let fraction: Vec<f64> = (0..blade.points()).map(|j| fraction(j, m)).collect();
            let path = tapered(blade, design.a_p, |i| track.side() * design.w() * fraction[i]);
            Side { crossing, m, fraction, path }
        };
        Ok(Self {
            fade: design.splitter_fade,
            crossing,
            out: side(Track::Out, crossing.along_second, out),
            back: side(Track::Back, crossing.along_first, back),
        })
    }

    /// The side that a track runs along; `None` for those of a blade.
    #[must_use]
    pub const fn side(&self, track: Track) -> Option<&Side> {
        match track {
            Track::Out => Some(&self.out),
            Track::Back => Some(&self.back),
            Track::Obverse | Track::Reverse => None,
        }
    }

    /// The index from which on it stands in full: past the crossings and the fades of both sides.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
    pub fn full_from(&self) -> f64 {
        [&self.out, &self.back].into_iter().fold(0.0, |most, side| side.crossing.max(side.m as f64).max(most))
    }
}

/// The first point at or past an index along a path.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within the points of the path")]
fn at_or_past(index: f64) -> usize {
    index.ceil() as usize
}
