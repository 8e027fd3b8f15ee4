//! The torch's way round the hole: poses on the output grid.
//!
//! B is signed: it is positive where the torch leans away from the hole, whose direction C follows, so that C goes round
//! once. Where the torch passes the vertical, which it hardly ever meets exactly, C would swing half a turn at once: below
//! [`UPRIGHT`] it gives way to the direction away from the hole, and the torch is off its angle by a part of that tilt; its
//! beam stays on the root.
//!
//! The curve is parted until, halfway between two poses, the beam leaves the exact curve and the tip its exact place by no
//! more than the tolerance: the control moves A, X, Z, B and C linearly.
//!
//! # Units
//! Millimetres; angles in degrees on the grid, in radians elsewhere.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::Vector3;

use crate::kinds::pipe::hole::design::Design;
use crate::kinds::pipe::hole::height::Rule;
use crate::kinds::pipe::hole::program::AXES;
use crate::kinds::pipe::hole::station::{Groove, Station};
use crate::kinds::pipe::rates::CutMove;
use crate::limits::CUT_HALVINGS;
use crate::machine::torch::{TorchAxes, TorchPose};
use crate::number::grid::{Milli, OutOfFormat};
use crate::number::trig::{acos, atan2, hypot, sin_cos};

/// A, X, Z, B and C on the grid.
pub type Place = [Milli; 5];

/// What a leg follows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Follows {
    /// From the pierce to the curve.
    WayIn,
    /// The curve between two angles round the branch, radians.
    Curve([f64; 2]),
}

/// One move of the torch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg {
    /// Where it ends.
    pub to: Place,
    /// The part of the way that it is on.
    pub follows: Follows,
    /// The height is not the wanted one: the height control must be held.
    pub held: bool,
    /// The way of the beam's root, mm.
    pub way: f64,
    /// The time that it should take, s: the way at F, or longer where an axis or the F word would pass its limit.
    pub seconds: f64,
}

/// The whole way.
#[derive(Clone, Debug, PartialEq)]
pub struct Cut {
    /// Where the torch pierces.
    pub pierce: Place,
    /// The height control is held there.
    pub pierce_held: bool,
    /// The moves from there on.
    pub legs: Vec<Leg>,
}

impl Cut {
    /// The moves with the ways of their axes and the time that each is planned to take.
    #[must_use]
    pub fn runs(&self) -> Vec<CutMove> {
        let before = std::iter::once(self.pierce).chain(self.legs.iter().map(|leg| leg.to));
        let run = |(from, leg): (Place, &Leg)| CutMove {
            by: AXES.into_iter().zip(from).zip(leg.to).map(|((axis, from), to)| (axis, (to - from).value())).collect(),
            seconds: leg.seconds,
            at: match leg.follows {
                Follows::Curve([from, _]) => Some(("α", from)),
                Follows::WayIn => None,
            },
        };
        before.zip(&self.legs).map(run).collect()
    }
}

/// A place of the cut that the torch cannot take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TooHigh {
    /// The angle round the branch, radians.
    pub alpha: f64,
    /// The torch's angle to the pipe; `None` where its axis does not leave the header's outside.
    pub sigma_o: Option<f64>,
    /// The height that it would need.
    pub D: f64,
}

/// Why there is no way round the hole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoWay {
    /// A position that no program may carry.
    Format(OutOfFormat),
    /// The torch's axis does not leave the header's outside somewhere.
    LiesDown,
    /// The torch leans sideways by more than half of [`UPRIGHT`] where its tilt turns over: C would swing half a turn at once.
    Swings {
        /// The angle round the branch, radians.
        alpha: f64,
        /// The torch's tilt there, radians.
        tilt: f64,
    },
}

impl From<OutOfFormat> for NoWay {
    fn from(error: OutOfFormat) -> Self {
        Self::Format(error)
    }
}

/// The tilt, in radians, below which C begins to give way; below half of it C has given way.
pub const UPRIGHT: f64 = 2.0 * std::f64::consts::PI / 180.0;

/// How far the torch leans, radians, where the header is turned so that its tip is at the top.
fn tilt(pose: &TorchPose) -> f64 {
    let (sin, cos) = sin_cos(atan2(-pose.tip.y, pose.tip.z));
    acos((pose.axis.z * cos - pose.axis.y * sin).clamp(-1.0, 1.0))
}

/// The axes of a place of the cut, near those before.
///
/// With d the angle from the direction away from the hole to that of the tilt (turned by π where the tilt leans over the
/// hole), C is that direction plus d, or near the vertical plus ½ sin 2d, which goes on smoothly where d turns over. B is
/// the part of the tilt along C. The tip is then put back so that the beam passes through the root.
#[must_use]
pub fn machine_axes(station: &Station, beside: f64, before: Option<&TorchAxes>) -> TorchAxes {
    let through = root(station, beside);
    let reach = (station.pose.tip - through).dot(&station.pose.axis);
    let mut pose = station.pose;
    let mut found = TorchAxes::default();
    for _ in 0..4 {
        let A = atan2(-pose.tip.y, pose.tip.z);
        let turned = |direction: &Vector3<f64>| {
            let (sin, cos) = sin_cos(A);
            Vector3::new(direction.x, direction.y * cos + direction.z * sin, direction.z * cos - direction.y * sin)
        };
        let (axis, away) = (turned(&station.pose.axis), turned(&station.away));
        let tilt = atan2(hypot(axis.x, axis.y), axis.z);
        let guide = atan2(away.y, away.x);
        let mut d = if tilt < 1e-12 { 0.0 } else { atan2(axis.y, axis.x) - guide };
        d -= (d / TAU).round() * TAU;
        let mut sign = 1.0;
        if d.abs() > FRAC_PI_2 {
            sign = -1.0;
            d -= d.signum() * PI;
        }
        let exact = ((tilt / UPRIGHT - 0.5) / 0.5).clamp(0.0, 1.0);
        let exact = exact * exact * (3.0 - 2.0 * exact);
        let turn = d * exact + 0.5 * sin_cos(2.0 * d).0 * (1.0 - exact);
        let B = sign * atan2(sin_cos(tilt).0 * sin_cos(d - turn).1, sin_cos(tilt).1);
        let C = guide + turn;
        found = TorchAxes { A, X: pose.tip.x, Z: hypot(pose.tip.y, pose.tip.z), B, C };
        let axis = found.pose().axis;
        pose = TorchPose { tip: through + axis * reach, axis };
    }
    match before {
        None => found,
        Some(before) => TorchAxes { A: near(found.A, before.A), C: near(found.C, before.C), ..found },
    }
}

/// Turns brought near those before, so that no axis jumps.
fn near(value: f64, before: f64) -> f64 {
    value + ((before - value) / TAU).round() * TAU
}

/// The path of the torch on its grid, put together leg by leg.
struct TorchPath<'d> {
    design: &'d Design,
    groove: Groove,
    at: TorchAxes,
    place: Place,
    legs: Vec<Leg>,
}

fn on_grid(axes: &TorchAxes) -> Result<Place, OutOfFormat> {
    Ok([
        Milli::round(axes.A.to_degrees())?,
        Milli::round(axes.X)?,
        Milli::round(axes.Z)?,
        Milli::round(axes.B.to_degrees())?,
        Milli::round(axes.C.to_degrees())?,
    ])
}

/// The axes of a place in mm and degrees, A, X, Z, B and C in this order: in mm and radians.
#[must_use]
pub fn axes(place: [f64; 5]) -> TorchAxes {
    let [A, X, Z, B, C] = place;
    TorchAxes { A: A.to_radians(), X, Z, B: B.to_radians(), C: C.to_radians() }
}

/// The axes a part of the way from one to another.
#[must_use]
pub fn between(from: &TorchAxes, to: &TorchAxes, part: f64) -> TorchAxes {
    let mix = |one: f64, other: f64| one + (other - one) * part;
    TorchAxes {
        A: mix(from.A, to.A),
        X: mix(from.X, to.X),
        Z: mix(from.Z, to.Z),
        B: mix(from.B, to.B),
        C: mix(from.C, to.C),
    }
}

/// The beam's root: the point of the curve, moved half a kerf into the waste.
#[must_use]
pub fn root(station: &Station, beside: f64) -> Vector3<f64> {
    station.root + station.waste * beside
}

/// How far the beam of a pose passes from the root of a place of the cut.
#[must_use]
pub fn off(pose: &TorchPose, station: &Station, beside: f64) -> f64 {
    let to_root = root(station, beside) - pose.tip;
    (to_root - pose.axis * to_root.dot(&pose.axis)).norm()
}

/// Pieces of the curve before they are halved.
const PIECES: u32 = 32;

impl TorchPath<'_> {
    fn follow(&mut self, from: &Station, to: &Station, depth: u32) -> Result<(), NoWay> {
        let next = machine_axes(to, self.groove.beside, Some(&self.at));
        let middle = self.groove.at(f64::midpoint(from.alpha, to.alpha));
        let beside = self.groove.beside;
        if let Some(middle) = middle {
            let halfway = between(&self.at, &next, 0.5).pose();
            let beam = off(&halfway, &middle, beside);
            let exact = machine_axes(&middle, beside, Some(&self.at)).pose();
            // What lies along the path does no harm; across it the tip counts as the beam does.
            let along = (root(to, beside) - root(from, beside)).try_normalize(1e-12).unwrap_or_else(Vector3::x);
            let by = halfway.tip - exact.tip;
            let aside = (by - along * by.dot(&along)).norm();
            if beam.max(aside) > 0.7 * self.design.arc_tolerance || to.alpha - from.alpha > TAU / 32.0 {
                if depth == CUT_HALVINGS {
                    return Err(NoWay::Swings { alpha: middle.alpha, tilt: tilt(&middle.pose) });
                }
                self.follow(from, &middle, depth + 1)?;
                return self.follow(&middle, to, depth + 1);
            }
        }
        let way = (root(to, beside) - root(from, beside)).norm();
        self.go(
            &next,
            to.rule != Rule::Wanted || from.rule != Rule::Wanted,
            way,
            Follows::Curve([from.alpha, to.alpha]),
        )
    }

    fn go(&mut self, to: &TorchAxes, held: bool, way: f64, follows: Follows) -> Result<(), NoWay> {
        let place = on_grid(to)?;
        self.at = *to;
        if place == self.place {
            return Ok(());
        }
        let by: [f64; 5] = std::array::from_fn(|axis| (place[axis] - self.place[axis]).value());
        let greatest = by.iter().fold(0.0_f64, |most, by| most.max(by.abs()));
        let resultant = by.iter().map(|by| by * by).sum::<f64>().sqrt();
        let word = self.design.post.control.feed.law.least_seconds(resultant);
        let axis = self.design.F_max.map_or(0.0, |F_max| greatest * 60.0 / F_max);
        let seconds = (way * 60.0 / self.design.F).max(axis).max(word);
        self.place = place;
        self.legs.push(Leg { to: place, follows, held, way, seconds });
        Ok(())
    }
}

/// The axes where the torch pierces, with a lead-in of that length, and where it meets the curve.
///
/// It keeps its direction on the way in; at α = 0 or α = π the pipe keeps its turn.
fn lead_in(groove: &Groove, first: &Station, length: f64) -> [TorchAxes; 2] {
    let onto = machine_axes(first, groove.beside, None);
    let pose = onto.pose();
    let moved = TorchPose { tip: pose.tip - first.away * length, axis: pose.axis }.axes();
    [TorchAxes { X: moved.X, Z: moved.Z, A: near(moved.A, onto.A), ..onto }, onto]
}

/// Where the torch pierces and where it meets the curve, with a lead-in of that length; `None` where there is no such place.
#[must_use]
pub fn way_in(design: &Design, lead: f64) -> Option<[Place; 2]> {
    let groove = design.groove();
    let first = groove.at(0.0)?;
    let [pierce, onto] = lead_in(&groove, &first, lead);
    Some([on_grid(&pierce).ok()?, on_grid(&onto).ok()?])
}

/// The way round the hole.
///
/// # Errors
/// As [`NoWay`] says.
pub fn cut(design: &Design) -> Result<Cut, NoWay> {
    let groove = design.groove();
    let at = |alpha| groove.at(alpha).ok_or(NoWay::LiesDown);
    let first = at(0.0)?;
    let [pierce, onto] = lead_in(&groove, &first, design.lead_in);
    let held = first.rule != Rule::Wanted;
    let mut path = TorchPath { design, groove, at: pierce, place: on_grid(&pierce)?, legs: Vec::new() };
    if design.lead_in > 0.0 {
        path.go(&onto, held, design.lead_in, Follows::WayIn)?;
    }
    let mut before = first;
    for j in 1..=PIECES {
        let next = at(TAU * f64::from(j) / f64::from(PIECES))?;
        path.follow(&before, &next, 0)?;
        before = next;
    }
    // Over the beginning once more.
    let (mut left, mut alpha) = (design.overcut, TAU);
    // A last piece that is hardly there would be a move too short for its F word.
    while left > 0.05 && alpha < 2.0 * TAU {
        let step = TAU / 720.0;
        let (here, next) = (at(alpha)?, at(alpha + step)?);
        let length = (root(&next, groove.beside) - root(&here, groove.beside)).norm();
        let part = (left / length).min(1.0);
        alpha += step * part;
        left -= length;
    }
    if alpha > TAU {
        path.follow(&before, &at(alpha)?, 0)?;
    }
    Ok(Cut { pierce: on_grid(&pierce)?, pierce_held: held, legs: path.legs })
}
