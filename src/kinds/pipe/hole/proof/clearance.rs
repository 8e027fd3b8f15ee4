//! How near the torch comes to the pipe on its way, and what to choose where that is too near.
//!
//! # Units
//! Millimetres; directions in radians.

use std::f64::consts::FRAC_PI_2;

use nalgebra::Vector3;

use crate::finding::{Limit, Raise, Said, Size};
use crate::gcode::motion::Motion;
use crate::gcode::program::Program;
use crate::kinds::pipe::hole::cut::{Cut, Follows, Leg, Place, axes, way_in};
use crate::kinds::pipe::hole::design::Design;
use crate::kinds::pipe::hole::parameters::{ARC_TOLERANCE, GAMMA, LEAD_IN, Z_S};
use crate::kinds::pipe::hole::proof::rules::{TorchTooNear, TorchTooNearAbove, TorchTooNearOnWayIn};
use crate::kinds::pipe::hole::proof::{ARITHMETIC, leg, place, retract, rounding};
use crate::limits::CUT_LOOKS;
use crate::machine::axis::Axis;
use crate::machine::torch::{TorchAxes, TorchPose};
use crate::number::grid::Milli;
use crate::number::root::golden;
use crate::number::trig::{atan2, sin_cos};
use crate::proof::check::{At, Check, Question, mm, up};
use crate::proof::enclosed::Enclosed;
use crate::proof::step::{Judge, Stage, Step};
use crate::text::{Language, Text, t};

/// How far behind the tip the discs are between which the torch lies, and their radii. The body counts up to a body's width
/// behind the taper.
fn discs(design: &Design) -> [[f64; 2]; 3] {
    let (r_g, R_g, shoulder) = (design.r_g, design.R_g, design.torch().shoulder());
    [[0.0, r_g], [shoulder, R_g], [shoulder + 2.0 * R_g, R_g]]
}

/// How far each disc of a torch in a pose is from the pipe's axis, seen along a direction across it, less the pipe's radius.
fn along(design: &Design, pose: &TorchPose, direction: f64) -> [f64; 3] {
    let (sin, cos) = sin_cos(direction);
    let u = Vector3::new(0.0, sin, cos);
    let (middle, up, aside) = (u.dot(&pose.tip), u.dot(&pose.axis), u.cross(&pose.axis).norm());
    discs(design).map(|[behind, radius]| middle + behind * up - radius * aside - design.R_o())
}

fn least(of: [f64; 3]) -> f64 {
    of[0].min(of[1]).min(of[2])
}

/// The least distance of a torch in a pose from a pipe of radius R_o about the x axis, and the direction in which it is: none
/// of its points is nearer.
fn nearest(design: &Design, pose: &TorchPose) -> (f64, f64) {
    let over = atan2(pose.tip.y, pose.tip.z);
    let span = [over - FRAC_PI_2, over + FRAC_PI_2];
    let (found, direction) = golden(span, 32, |direction| -least(along(design, pose, direction)));
    (-found, direction)
}

/// The least distance of a torch in a pose from a pipe of radius R_o about the x axis: tip, taper and body, the body up to a
/// body's width behind the taper.
#[must_use]
pub fn clearance(design: &Design, pose: &TorchPose) -> f64 {
    nearest(design, pose).0
}

/// What the torch must keep clear by, mm: g0 less what arcs and rounding take, and half of it however large their tolerance is.
fn clear_limit(design: &Design) -> f64 {
    (design.g0 - design.arc_tolerance - rounding(design)).max(design.g0 / 2.0)
}

/// A look at the torch's clearance.
#[derive(Clone, Copy, Debug)]
struct Near {
    /// What part of the motion lies before it.
    part: f64,
    /// The torch, over a pipe that is not turned.
    pose: TorchPose,
    /// The direction round the pipe in which it is nearest, radians.
    direction: f64,
    /// How near.
    clear: f64,
}

impl Near {
    fn at(design: &Design, motion: &Motion, part: f64) -> Self {
        // The pipe is round: how it is turned does not count.
        let pose = TorchAxes { A: 0.0, ..axes(place(motion, part)) }.pose();
        let (clear, direction) = nearest(design, &pose);
        Self { part, pose, direction, clear }
    }

    /// What the clearance, negative, nowhere exceeds between two looks: along one direction the middle of a disc, and the
    /// torch's axis up to its turns' square, run evenly from the one to the other.
    fn over(&self, design: &Design, motion: &Motion, other: &Self) -> f64 {
        let direction = f64::midpoint(self.direction, other.direction);
        let by = motion.to.differences(&motion.from);
        let turns = (by[Axis::B as usize].abs() + by[Axis::C as usize].abs()).to_radians() * (other.part - self.part);
        let bends = turns * turns / 8.0;
        let (here, there) = (along(design, &self.pose, direction), along(design, &other.pose, direction));
        let clear: [f64; 3] = std::array::from_fn(|disc| {
            let [behind, radius] = discs(design)[disc];
            here[disc].min(there[disc]) - (behind + radius) * bends
        });
        ARITHMETIC - least(clear)
    }
}

/// Holds the torch's way against the pipe.
pub(super) struct Clearance<'a> {
    design: &'a Design,
    cut: &'a Cut,
    /// The clearance, negative, so that the least is the worst.
    near: Enclosed<1>,
    whence: Whence,
    rapids: usize,
}

impl Judge for Clearance<'_> {
    fn see(&mut self, step: &Step<'_>) {
        self.rapids += usize::from(matches!(step.stage, Stage::Positioning));
        // The first two come from where the machine stood, high above the pipe or on the way there.
        if !matches!(step.stage, Stage::Still | Stage::Away) && (step.at_work() || self.rapids > 2) {
            let before = self.near.at(0);
            self.look(&step.motion);
            if self.near.at(0) != before {
                let motion = &step.motion;
                let [from, to] = [0.0, 1.0].map(|part| Near::at(self.design, motion, part).clear);
                self.whence = match (&step.stage, leg(self.cut, step)) {
                    (_, Some(Leg { follows: Follows::Curve(_), .. })) => Whence::Curve,
                    (_, Some(Leg { follows: Follows::WayIn, .. })) => Whence::LeadIn,
                    // To the pierce: nearer to the pipe there than at the height that it comes from.
                    (Stage::Positioning, None) if to < from => Whence::LeadIn,
                    _ => Whence::Above,
                };
            }
        }
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        let name = t("Distancia de la antorcha al tubo", "Distance of the torch from the pipe");
        // A distance below the least that could be ruled out is none to count on.
        let (least, limit) = (-self.near.at_most(0), clear_limit(self.design));
        let down = -up(-least);
        let asked = Question::new("clearance", name, program);
        let asked = asked.showing(Text::same(format!("≥ {}", mm(down))), Text::same(mm(limit)));
        let asked = match self.whence {
            Whence::Curve => asked.of_parameters([GAMMA.key(), ARC_TOLERANCE.key()]),
            Whence::LeadIn => asked.of_parameters([LEAD_IN.key()]),
            Whence::Above => asked.of_parameters([Z_S.key()]),
        };
        let asked = self.near.put(asked, 0).measuring(least).against(Limit::AtLeast(limit));
        vec![asked.holds(least >= limit, |place| {
            let (distance, g0) = (Size::length(down, 4), Size::length(self.design.g0, 4));
            // What is found to do, where a search finds any.
            let found = |length: Option<f64>, [es, en]: [&str; 2]| {
                length.map(|length| Size::length(length, 1)).map_or(t("", ""), |length| {
                    Text::new(
                        format!(", de {} {es}", length.said(Language::Es)),
                        format!(", of {} {en}", length.said(Language::En)),
                    )
                })
            };
            match self.whence {
                Whence::Curve => TorchTooNear { distance, g0 }.at(place),
                Whence::LeadIn => {
                    let most = found(longest_lead_in(self.design), ["como mucho", "at most"]);
                    TorchTooNearOnWayIn { distance, g0, most }.at(place)
                }
                Whence::Above => {
                    let least = found(least_safe_height(self.design, self.cut), ["como mínimo", "at least"]);
                    TorchTooNearAbove { distance, g0, least }.at(place)
                }
            }
        })]
    }
}

/// On which way the torch comes nearest to the pipe.
#[derive(Clone, Copy, Debug)]
enum Whence {
    /// Round the hole.
    Curve,
    /// On the way in from the pierce, or down to that.
    LeadIn,
    /// At the safe height.
    Above,
}

/// Looks at a move, beyond the first.
const SAMPLES: u16 = 64;
/// Lengths that are tried, and from one to the next, mm.
const TRIED: u16 = 1000;
const STEP: f64 = 0.1;

/// The longest lead-in below the given one that keeps the torch clear, as all shorter ones do.
fn longest_lead_in(design: &Design) -> Option<f64> {
    let below = (1..TRIED).map(|step| f64::from(step) * STEP).take_while(|way| *way < design.lead_in);
    below.take_while(|&way| way_in(design, way).is_some_and(|[pierce, onto]| clear(design, pierce, onto))).last()
}

/// The least safe height above the given one at which the torch keeps clear where it turns.
fn least_safe_height(design: &Design, cut: &Cut) -> Option<f64> {
    let above = (1..TRIED).map(|step| (design.Z_s / STEP).floor() * STEP + f64::from(step) * STEP);
    above.into_iter().find(|&Z_s| {
        let way = retract(&Design { Z_s, ..design.clone() }, cut);
        let ([A, X, _, B, C], Some(&[_, _, Z, _, _])) = (cut.pierce, way.first()) else { return false };
        let [over, home] = [[A, X, Z, B, C], [Milli::ZERO, X, Z, Milli::ZERO, Milli::ZERO]];
        let back: Vec<Place> = cut.legs.last().map(|leg| leg.to).into_iter().chain(way).collect();
        clear(design, home, over) && back.windows(2).all(|two| clear(design, two[0], two[1]))
    })
}

/// True where the torch is seen to keep clear of the pipe on a move between two places.
fn clear(design: &Design, from: Place, to: Place) -> bool {
    (0..=SAMPLES).all(|at| {
        let part = f64::from(at) / f64::from(SAMPLES);
        let five = std::array::from_fn(|axis| from[axis].value() + (to[axis] - from[axis]).value() * part);
        clearance(design, &axes(five).pose()) >= clear_limit(design)
    })
}

impl<'a> Clearance<'a> {
    /// The judge of a program.
    pub(super) fn new(design: &'a Design, cut: &'a Cut) -> Self {
        let near = Enclosed::new([1e-3], [-clear_limit(design)], CUT_LOOKS);
        Self { design, cut, near, whence: Whence::Curve, rapids: 0 }
    }

    /// Holds the torch's way along a motion against the pipe. The pipe is round: only height, tilt and swing count.
    fn look(&mut self, motion: &Motion) {
        let design = self.design;
        self.near.take(
            At::motion(motion),
            &[0.0, 1.0].map(|part| Near::at(design, motion, part)),
            |near| [-near.clear],
            |one, other| [one.over(design, motion, other)],
            |one, other| Near::at(design, motion, f64::midpoint(one.part, other.part)),
        );
    }
}
