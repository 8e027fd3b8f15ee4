//! Lanes of the floor with the tool leaning off a wall, where upright ones leave too much.
//!
//! # Derivation
//! The flat end of an upright tool touches the hollow floor with its two points farthest along the tube alone, at the stations
//! v ± θ. Before the nose of a splitter the blade shuts the one and the splitter the other, and a ridge stays. Along the
//! parallel the floor bends away: a point of the edge abreast of the axis stands a²/2·(1/r_t − cos v/ρ_t) above it, to second
//! order, as far as K bends off and the tip stands short of the tube. A tool that leans across the tube by more than that over a
//! touches with that point, at its own station. The tip is as deep as the disc stays in the ball of the tube's radius about
//! the point of K nearest to the axis, so that no point of it is below the floor; and a tool that leans off a wall it touches with
//! the edge of its end stays clear of it. An outermost lane is tried first, once more along its wall; then one whose point abreast
//! runs through the place where most is left: beside the nose, where neither end of an upright tool comes to.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::Vector3;

use crate::kinds::impeller::clear::body::Obstacles;
use crate::kinds::impeller::clear::contact::Contacts;
use crate::kinds::impeller::clear::cut::Which;
use crate::kinds::impeller::clear::draft::{Draft, Wanted};
use crate::kinds::impeller::clear::flank::{passing, stand};
use crate::kinds::impeller::clear::floor_rest::{FloorLook, FloorRest};
use crate::kinds::impeller::clear::lane::{OwnNormal, v_at};
use crate::kinds::impeller::clear::pass::{Cutting, Direction};
use crate::kinds::impeller::clear::pieces::parts;
use crate::kinds::impeller::clear::poses::Poses;
use crate::kinds::impeller::clearance::Stand;
use crate::kinds::impeller::nearest::Axis;
use crate::kinds::impeller::part::{Face, HUB};
use crate::machine::rotary::TiltingTable;
use crate::number::trig::sin_cos;

/// The most such lanes of a channel.
const LANES: u8 = 8;
/// How much of the tolerance upright lanes may leave on top of their ridges.
const SHARE: f64 = 0.5;
/// Where on its edge a leaning tool may touch the place, from the point abreast, radians.
const AROUND: [f64; 5] = [0.0, -0.25, 0.25, -0.5, 0.5];
/// How much more than it takes the tool leans.
const MORE: f64 = 1.6;
/// How far past a place of the floor a leaning tool is run, in parts of the way, and to which station at most: farther on the
/// axis comes upright, and a lean would turn C.
const PAST: f64 = 0.05;
const LEANS_TO: f64 = 0.8;
/// By how much a leaning tool may be nearer to a face that it touches, mm: what the search of contacts leaves, and more.
const TOUCHED: f64 = 5e-4;

/// By how much the tool leans at a station.
fn angle(lane: &OwnNormal, q: f64) -> f64 {
    let (r_t, cos_v) = (lane.below(q), sin_cos(v_at(q)).1);
    let rho = lane.torus.R + r_t * cos_v;
    MORE * lane.tool.flat_radius() / 2.0 * (1.0 / r_t - cos_v / rho).max(0.0)
}

/// The axis of the tool at a station and an angle about the part, leaning off the wall of a face; as high as an upright one.
fn axis(lane: &OwnNormal, face: Face, q: f64, psi: f64, reach: f64) -> Axis {
    let upright = lane.axis(q, psi, reach);
    let ((sin, cos), (sin_psi, cos_psi)) = (sin_cos(angle(lane, q)), sin_cos(psi));
    // The obverse stands on the side of growing ψ.
    let off = Vector3::new(-sin_psi, cos_psi, 0.0) * -face.side();
    let (foot, along) = (upright.foot + upright.along * upright.range[0], upright.along * cos + off * sin);
    let low = passing(&foot, &along, lane.torus.R, psi).tip(&lane.tool, lane.r_f);
    Axis { foot, along, range: [low, low + upright.range[1] - upright.range[0]] }
}

/// Where the machine's axes stand for it.
fn stand_at(lane: &OwnNormal, machine: TiltingTable, face: Face, q: f64, psi: f64) -> Stand {
    let axis = axis(lane, face, q, psi, lane.tool.a());
    stand(machine, &axis, &axis.along, psi - TAU, 0.0)
}

/// A lane with a leaning tool, from the hub to a station.
#[derive(Clone, Copy, Debug)]
struct Leaning {
    /// The face off which the tool leans.
    face: Face,
    /// Which part of the way it is from the obverse to the reverse, as in [`Contacts::psi`].
    lambda: f64,
    to: f64,
}

impl Leaning {
    /// The outermost lanes, to a little past a place.
    fn outermost(lane: &OwnNormal, place: &FloorRest) -> [Self; 2] {
        let to = (place.v - HUB + lane.spread()) / FRAC_PI_2 + PAST;
        [(Face::Obverse, 0.0), (Face::Reverse, 1.0)].map(|(face, lambda)| Self { face, lambda, to })
    }

    /// Lanes that end where the low side of the tool comes to a place.
    fn through(contacts: &Contacts, place: &FloorRest) -> Vec<Self> {
        let lane = contacts.lane;
        let rho = lane.torus.R + lane.r_f * sin_cos(place.v).1;
        let through = |face: Face, around: f64| {
            let (sin, cos) = sin_cos(around);
            let to = (place.v - HUB + lane.spread() * sin) / FRAC_PI_2;
            let [obverse, reverse] = contacts.at(to);
            let psi = place.psi + face.side() * lane.tool.flat_radius() * cos / rho;
            Self { face, lambda: (psi - obverse) / (reverse - obverse), to }
        };
        let all = Face::ALL.into_iter().flat_map(|face| AROUND.map(|around| through(face, around)));
        all.filter(|one| (0.0..=1.0).contains(&one.lambda)).collect()
    }
}

impl Draft<'_> {
    /// Where more is left on the floor than ridges and tolerance are, runs a lane with the tool leaning off a wall, from the hub
    /// to a little past that place and back, if that takes it away and the holder stays clear; what is left in the end.
    pub(super) fn lean(&mut self, contacts: &Contacts, look: &mut Option<FloorLook>) -> FloorRest {
        let Some(look) = look else {
            return FloorRest { beside: self.beside(), most: self.job.part.a_p, v: HUB, psi: 0.0 };
        };
        let wanted = self.cut.scallop + SHARE * self.cut.tolerance;
        let mut floor = look.most();
        let lane = contacts.lane;
        let may = lane.tool.flat_radius() > 0.0 && self.finish_from <= 0.0;
        let (blank, holder) = (self.blank(), self.cut.stage(Which::Finish));
        let holder_clear = |points: &Vec<Stand>| {
            holder.is_none_or(|stage| blank.clearance(stage, std::iter::once(points.as_slice())) >= 0.0)
        };
        for _ in 0..LANES {
            if !may || floor.most <= wanted || self.full() {
                break;
            }
            let left = |leaning: &Leaning| {
                let points = self.leaning(contacts, leaning).filter(holder_clear)?;
                let poses = Poses::along(self.job.machine, std::iter::once(points.as_slice()));
                let left = look.left_by(&poses, &floor);
                (left <= wanted).then_some((left, leaning.face, points, poses))
            };
            // Along a wall a lane takes the whole ridge.
            let outermost = Leaning::outermost(&lane, &floor);
            let through = || Leaning::through(contacts, &floor);
            let found = outermost.iter().find_map(left);
            let least = || through().iter().filter_map(left).min_by(|one, other| one.0.total_cmp(&other.0));
            let Some((_, face, points, poses)) = found.or_else(least) else { break };
            let (cutting, direction) = (Cutting::Leaning { face }, Direction::Outwards);
            self.add(Wanted {
                mode: self.mode(face, direction),
                dead_end: true,
                ..Wanted::new(cutting, Which::Finish, direction, points)
            });
            self.done();
            look.cut_by(poses, wanted);
            floor = look.most();
        }
        floor
    }

    /// The points of such a lane; `None` where it does not keep clear all the way.
    fn leaning(&self, contacts: &Contacts, leaning: &Leaning) -> Option<Vec<Stand>> {
        let Leaning { face, lambda, to } = *leaning;
        let (lane, machine, a) = (contacts.lane, self.job.machine, contacts.lane.tool.a());
        let obstacles = Obstacles::new(&self.job.part, self.pitch, a, self.v_s);
        let (m, reach, asked) = (self.cut.run_out(Which::Finish), a + self.job.part.overhang(), a - TOUCHED);
        let keeps = |q: f64| {
            let axis = axis(&lane, face, q, contacts.psi(lambda, q), reach);
            obstacles.keeps_obverse(&axis, asked)
                && obstacles.keeps_reverse(&axis, asked)
                && obstacles.keeps_splitter(&axis, asked)
        };
        // Out of the hub the tool has left the part.
        if to > LEANS_TO || parts(&[-a, 0.0, to], keeps) != [[-a, to]] {
            return None;
        }
        let mut pieces = vec![-m, -a, -lane.tool.flat_radius(), 0.0, to];
        pieces.dedup();
        let way = |q: f64| stand_at(&lane, machine, face, q, contacts.psi(lambda, q));
        let tolerance = self.tolerance(Which::Finish, self.height(Which::Finish, lane.r_f - lane.torus.r));
        let placed = tolerance.place(&way, &pieces, self.most());
        Some(placed.into_iter().map(|(_, stand)| stand).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::torus::Torus;
    use crate::kinds::impeller::clear::tool::Tool;
    use crate::number::trig::hypot;

    #[test]
    fn no_point_of_a_leaning_end_is_below_the_floor_and_the_one_abreast_reaches_it() {
        for (R, r, a_p) in [(25.0, 15.0, 2.0), (25.0, 17.0, 4.0), (50.0, 30.0, 3.0), (60.0, 12.0, 5.0)] {
            for (tool, face) in
                [Tool::flat(3.0), Tool::flat(6.0)].into_iter().flat_map(|tool| Face::ALL.map(|face| (tool, face)))
            {
                let lane = OwnNormal::new(Torus { R, r }, tool, r + a_p).unwrap();
                for q in [-0.5, 0.0, 0.1, 0.3, 0.5, 0.8] {
                    let psi = 1.3;
                    let (axis, upright) = (axis(&lane, face, q, psi, 3.0), lane.axis(q, psi, 3.0));
                    let pass = passing(&axis.foot, &axis.along, R, psi);
                    // Beyond that place it is no nearer to the blank than r less what it passes at.
                    for step in 0..60 {
                        let point = axis.foot + axis.along * (pass.at + f64::from(step));
                        assert!(
                            point.z >= -pass.m - 1e-9 && hypot(point.x, point.y) >= R - pass.m - 1e-9,
                            "{R} {q} {point}"
                        );
                    }
                    let tip = axis.foot + axis.along * axis.range[0];
                    let forward = (upright.along.cross(&axis.along)).try_normalize(1e-12).unwrap();
                    let abreast = axis.along.cross(&forward);
                    let depth = |turn: f64| {
                        let (sin, cos) = sin_cos(turn);
                        let point = tip + (abreast * cos + forward * sin) * tool.a();
                        hypot(hypot(point.x, point.y) - R, point.z) - r - a_p
                    };
                    let around: Vec<f64> = (0..720).map(|step| depth(TAU * f64::from(step) / 720.0)).collect();
                    let deepest = around.iter().copied().fold(f64::MIN, f64::max);
                    assert!(deepest <= 1e-9, "{R} {r} {tool:?} {face:?} {q} {deepest}");
                    // Off the wall: the end is low on its other side, and there it is nearer to the floor than where it was.
                    let upright_tip = upright.foot + upright.along * upright.range[0];
                    let was = upright_tip + abreast * tool.a();
                    let was = hypot(hypot(was.x, was.y) - R, was.z) - r - a_p;
                    let low = depth(0.0).max(depth(TAU / 2.0));
                    assert!(low > was / 2.0 - 1e-9, "{R} {r} {tool:?} {face:?} {q} {low} {was}");
                }
            }
        }
    }
}
