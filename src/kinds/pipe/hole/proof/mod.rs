//! The verification of a hole's program: what the torch would do, compared with plan, curve, pipes and torch.
//!
//! Every motion of the cut is looked at in several poses, put back onto the pipe by the machine's forward kinematics. From
//! each the nearest place of the exact cut is sought: how far the beam passes from its root is how far the cut is off. Half
//! a kerf back across the cut face lies the edge that is cut, which is off the branch, grown by its gap, by no more than the beam
//! is off the root, since the root's own edge lies on it. The face that is cut is off its angle by what the torch is off, and by
//! what the beams of neighbouring places open it (see `crossing.rs`).
//!
//! The torch is the convex body about its tip, its shoulder and the end of its body, three discs square to its axis. For any
//! direction u across the pipe's axis no point of it comes nearer to that axis than the least of u·c − ρ|u × a| over the discs
//! (middle c, radius ρ), and for one direction that is the distance itself: so the torch keeps clear of the round pipe, not of a
//! tangent plane or of points on it.
//!
//! Between two poses all of these leave what runs evenly from the one to the other by no more than an eighth of their second
//! derivative, as jets enclose it. Motions are parted until that decides.

mod clearance;
mod crossing;
pub mod rules;

use crate::kinds::pipe::form::E;
use crate::kinds::pipe::hole::parameters::{self, ARC_TOLERANCE, F_MAX, GAMMA, H};
use crate::limits::CUT_LOOKS;

use crate::finding::{Figures, Limit, Raise, Size};
use crate::gcode::motion::{Motion, MotionKind};
use crate::gcode::program::Program;
use crate::gcode::word::Distance;
use crate::kinds::pipe::hole::cut::{Cut, Follows, Leg, Place, axes, off};
use crate::kinds::pipe::hole::design::Design;
use crate::kinds::pipe::hole::program::{AXES, distance};
use crate::kinds::pipe::hole::proof::clearance::Clearance;
pub use crate::kinds::pipe::hole::proof::clearance::clearance;
use crate::kinds::pipe::hole::proof::crossing::Crossing;
use crate::kinds::pipe::hole::proof::rules::{
    BeamsOpen, BevelOff, BevelOffOverLand, CutSlows, NotItsTime, SwingsAtOnce, WordSlows,
};
use crate::kinds::pipe::hole::rules::GapWithinTolerance;
use crate::kinds::pipe::hole::station::Groove;
use crate::machine::axis::{Axis, Pose};
use crate::number::grid::Milli;
use crate::number::jet::{Jet, Vector, bow, cross, difference};
use crate::number::root::golden;
use crate::number::shown;
use crate::number::trig::{asin, sin_cos};
use crate::proof::agreement::Agreement;
use crate::proof::check::{At, Check, Extreme, Question, mm};
use crate::proof::due::Due;
use crate::proof::enclosed::{Enclosed, Remedy, Tolerance, bound};
use crate::proof::feed::{feed_word, timely};
use crate::proof::rollover::{self, Rollover};
use crate::proof::step::{Interpolation, Judge, Plan, Planned, Stage, Step, Time};
use crate::proof::torch::Torch;
use crate::text::{Text, t};

/// By how much the beam may pass from the root, and so the cut edge from the branch with its gap, mm.
fn tolerance(design: &Design) -> f64 {
    design.arc_tolerance + rounding(design)
}

/// What rounding to 0.001 mm and 0.001° takes, beside the tolerance: a thousandth of a degree at the pipe's radius.
fn rounding(design: &Design) -> f64 {
    0.002 + 0.001_f64.to_radians() * (design.R_o() + design.D_max)
}

/// By how much the bevel may be off before a person must judge it, degrees: a fifth of what welding procedures allow
/// for a groove angle (AWS D1.1, −5°).
const BEVEL: f64 = 1.0;

/// Below which part of the wall a groove is a thin one.
const THIN: f64 = 0.1;

/// What the arithmetic of a look may lose.
const ARITHMETIC: f64 = 1e-9;

/// The deviation along the curve, to be drawn: α in degrees and mm.
pub type Curve = Vec<[f64; 2]>;

fn five(pose: &Pose) -> [f64; 5] {
    AXES.map(|axis| pose.get(axis))
}

/// The pose of a place: the axes that the program moves, Y at 0.
fn pose(place: Place) -> Pose {
    let mut pose = Pose::default();
    AXES.into_iter().zip(place).for_each(|(axis, to)| pose.set(axis, to.value()));
    pose
}

/// The axes that are compared with the plan: Y must not move.
const HELD: &[Axis] = &[Axis::A, Axis::X, Axis::Y, Axis::Z, Axis::B, Axis::C];

/// Where the torch goes from the end of the cut: up to the safe height and, by increments, back to where A, B and C show 0.
fn retract(design: &Design, cut: &Cut) -> Vec<Place> {
    let Ok(safe) = Milli::round(design.R_o() + design.Z_s) else { return Vec::new() };
    let [A, X, _, B, C] = cut.legs.last().map_or(cut.pierce, |leg| leg.to);
    let over = [A, X, safe, B, C];
    let home = [Milli::ZERO, X, safe, Milli::ZERO, Milli::ZERO];
    let back = distance(design) == Distance::Incremental && home != over;
    std::iter::once(over).chain(back.then_some(home)).collect()
}

/// What the program is meant to do, from the pierce on.
#[must_use]
pub fn plan<'a>(design: &Design, cut: &Cut) -> Plan<'a> {
    let cuts = cut.legs.iter().map(|leg| (leg.to, Interpolation::Straight));
    let back = retract(design, cut).into_iter().map(|to| (to, Interpolation::Rapid));
    let mut from = pose(cut.pierce);
    let moves: Vec<_> = cuts
        .chain(back)
        .enumerate()
        .map(|(leg, (to, interpolation))| {
            let to = pose(to);
            let planned = Planned { from, to, interpolation, time: Time::Free, line: None, leg, path: None };
            from = to;
            planned
        })
        .collect();
    Plan::from_the_pierce(moves.into_iter())
}

/// The leg of the cut to which a motion answers.
fn leg<'c>(cut: &'c Cut, step: &Step<'_>) -> Option<&'c Leg> {
    if let Stage::Planned(planned) = &step.stage { cut.legs.get(planned.leg) } else { None }
}

/// Holds the beam against the cut.
struct BeamOnRoot<'a> {
    design: &'a Design,
    cut: &'a Cut,
    groove: Groove,
    /// How far the beam passes from the root, and the chord of the angle by which the torch is off.
    errors: Enclosed<2>,
    /// How the lines of the face stand to their neighbours.
    crossing: Crossing,
    curve: &'a mut Curve,
}

impl Judge for BeamOnRoot<'_> {
    fn see(&mut self, step: &Step<'_>) {
        if let Some(Leg { follows: Follows::Curve(angles), .. }) = leg(self.cut, step) {
            self.look(&step.motion, *angles);
            self.crossing.take(At::motion(&step.motion), *angles);
        }
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        let tolerance = tolerance(self.design);
        let rest = t("por el redondeo a 0.001 mm y 0.001°", "for the rounding to 0.001 mm and 0.001°");
        let tolerated = Tolerance::of_arcs(self.design.arc_tolerance, tolerance, &rest);
        let errors = &self.errors;
        let asked = |key, name| {
            let [value, limit] = bound(errors.at_most(0), tolerance);
            Question::new(key, name, program).showing(value, limit)
        };
        let off = |asked, what| errors.within(asked, 0, &tolerated, what, Remedy::Fault);
        let beam = off(
            asked("beam", t("Chorro contra la raíz exacta", "Beam against the exact root")),
            t("el chorro se aparta de la raíz exacta", "the beam leaves the exact root by"),
        );
        // No farther than the beam from the root.
        let edge = asked(
            "branch",
            t("Borde cortado, sobre el injerto con su holgura", "Cut edge, on the branch with its gap"),
        );
        let branch = match self.gap() {
            Some(told) => {
                let asked = errors
                    .put(edge, 0)
                    .measuring(errors.at_most(0))
                    .against(Limit::AtMost(tolerance))
                    .of_parameters([parameters::B.key(), ARC_TOLERANCE.key()]);
                asked.holds(false, |place| told.at(place))
            }
            None => off(
                edge,
                t(
                    "el borde cortado se aparta del injerto con su holgura",
                    "the cut edge is off the branch with its gap by",
                ),
            ),
        };
        let name = t("Bisel: error máximo de ángulo", "Bevel: maximum angle error");
        let Some(opening) = self.crossing.opening().map(f64::to_degrees) else {
            return vec![beam, branch, self.opened(program, name), self.crossing.check(program)];
        };
        let angle = degrees(errors.at_most(1)) + opening;
        let thin = 2.0 * opening > angle && self.thin();
        let key = if thin { H.key() } else { GAMMA.key() };
        let most = (angle * 1e3 - 1e-6).ceil() / 1e3;
        let value = Text::same(format!("≤ {}°", shown(most, 3)));
        let asked = Question::new("bevel", name, program).showing(value, Text::same(format!("{BEVEL}°")));
        let asked = asked.comparing(Figures::of(angle, Some(Limit::AtMost(BEVEL))));
        let asked = errors.put(asked.of_parameters([key, ARC_TOLERANCE.key()]), 1);
        let bevel = asked.holds(angle <= BEVEL, |place| {
            let angle = Size::degrees(most, 2);
            if thin { BevelOffOverLand {}.at(place) } else { BevelOff { angle }.at(place) }
        });
        vec![beam, branch, bevel, self.crossing.check(program)]
    }
}

impl BeamOnRoot<'_> {
    /// Over a land nearly as high as the wall a groove is hardly there, and every angle opens it.
    fn thin(&self) -> bool {
        let design = self.design;
        design.header.t - design.h < THIN * design.header.t
    }

    /// The check of the bevel where what neighbouring beams open it is not bounded: never passed.
    fn opened(&self, program: &Program, name: Text) -> Check {
        let [opening, alpha] = self.crossing.seen();
        let angle = opening.to_degrees().max(degrees(self.errors.reached(1)));
        let least = (angle * 1e3).floor() / 1e3;
        let value = Text::same(format!("≥ {}°", shown(least, 3)));
        let asked = Question::new("bevel", name, program).showing(value, Text::same(format!("{BEVEL}°")));
        let asked = asked.comparing(Figures::of(angle, Some(Limit::AtMost(BEVEL))));
        if self.thin() {
            let asked = self.errors.put(asked.of_parameters([H.key()]), 1);
            return asked.holds(false, |place| BevelOffOverLand {}.at(place));
        }
        let asked = self.errors.put(asked.of_parameters([GAMMA.key(), E.key()]), 1);
        let told = BeamsOpen { alpha: Size::degrees(alpha.to_degrees(), 0), angle: Size::degrees(least, 3) };
        asked.holds(false, |place| told.at(place))
    }

    /// What is told of a gap that is smaller than what a cut within its tolerance is off.
    fn gap(&self) -> Option<GapWithinTolerance> {
        let (b, tolerance, off) = (self.design.b, tolerance(self.design), self.errors.at_most(0));
        // None is told too small. A larger gap makes a larger hole, whose chords may be off a little more.
        let told = |value: f64| Size::mm((value * 1e3 - 1e-6).ceil() / 1e3);
        let least = told((1.1 * off).min(tolerance));
        // Bound and tolerance as the row of the verification shows them.
        let [bound, allowed] = bound(off, tolerance);
        let (b, into) = (Size::mm(b), told(off - b));
        (self.design.b < off && off <= tolerance).then_some(GapWithinTolerance { b, into, off: bound, allowed, least })
    }

    /// Holds the beam along a motion against the cut between two angles.
    fn look(&mut self, motion: &Motion, [from, to]: [f64; 2]) {
        let groove = self.groove;
        let beside = groove.beside;
        let curve = &mut *self.curve;
        let mut look = |part: f64, span: [f64; 2], steps: u32| {
            let pose = axes(place(motion, part)).pose();
            let beam = |alpha: f64| groove.at(alpha).map_or(f64::INFINITY, |station| off(&pose, &station, beside));
            let (_, alpha) = golden(span, steps, beam);
            let station = groove.at(alpha);
            let [beam, bevel] = station.map_or([f64::INFINITY; 2], |station| {
                [off(&pose, &station, beside), (pose.axis - station.pose.axis).norm()]
            });
            curve.push([alpha.to_degrees(), beam]);
            BeamSample { part, alpha, beam, bevel }
        };
        let margin = 0.5 * (to - from) + 1e-9;
        let first = [0.0, 0.5, 1.0].map(|part| {
            let middle = from + (to - from) * part;
            look(part, [middle - margin, middle + margin], 25)
        });
        self.errors.take(
            At::motion(motion),
            &first,
            |look| [look.beam, look.bevel],
            |one, other| over(&groove, motion, one, other),
            |one, other| {
                let (low, high) = (one.alpha.min(other.alpha), one.alpha.max(other.alpha));
                let wider = 0.25 * (high - low) + 1e-9;
                look(f64::midpoint(one.part, other.part), [low - wider, high + wider], 20)
            },
        );
    }
}

/// Watches how the torch tilts, and how far C turns at once.
struct Swing<'a> {
    cut: &'a Cut,
    tilt: [f64; 2],
    turn: Extreme,
}

/// By how much C may turn at once before a person must judge it, degrees.
const SWING: f64 = 90.0;

impl Judge for Swing<'_> {
    fn see(&mut self, step: &Step<'_>) {
        if leg(self.cut, step).is_none() {
            return;
        }
        let motion = &step.motion;
        self.turn.take(motion.to.differences(&motion.from)[Axis::C as usize].abs(), At::motion(motion));
        let B = motion.to.get(Axis::B);
        self.tilt = [self.tilt[0].min(B), self.tilt[1].max(B)];
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        let name = t("Inclinación B", "Tilt B");
        let value = Text::same(format!("{} … {}°", shown(self.tilt[0], 3), shown(self.tilt[1], 3)));
        let tilt = Question::new("tilt", name, program).showing(value, Text::same("")).informs();
        let name = t("Continuidad de C: paso máximo", "Continuity of C: largest step");
        let degrees = |value: f64| Text::same(format!("{}°", shown(value, 3)));
        let asked = Question::new("turning", name, program).showing(degrees(self.turn.value()), degrees(SWING));
        let turning = asked
            .within(&self.turn, SWING, |found, place| SwingsAtOnce { step: Size::degrees(found.value(), 3) }.at(place));
        vec![tilt, turning]
    }
}

/// Adds up the way of the beam's root and the time: is each move run at F, or as slow as planned?
struct CutSpeed<'a> {
    design: &'a Design,
    cut: &'a Cut,
    speed: [f64; 2],
    off: Option<(f64, At)>,
    /// The slowest move that is planned slower than F, and whether its F word is what slows it.
    slowed: Option<(f64, At, bool)>,
    rounded: Extreme,
    length: f64,
    seen: usize,
}

impl Judge for CutSpeed<'_> {
    fn see(&mut self, step: &Step<'_>) {
        let Some(leg) = leg(self.cut, step) else { return };
        let (motion, way) = (&step.motion, leg.way);
        let at = At::motion(motion);
        self.seen += 1;
        self.length += way;
        let Some(seconds) = motion.seconds.filter(|seconds| *seconds > 0.0) else {
            self.off.get_or_insert((0.0, at));
            return;
        };
        let speed = way * 60.0 / seconds;
        self.speed = [self.speed[0].min(speed), self.speed[1].max(speed)];
        let word = if let MotionKind::Feed(feed) = motion.kind { feed.value } else { 0.0 };
        if !timely(self.design.post.control.feed.law, motion, word, leg.seconds) {
            self.off.get_or_insert((speed, at));
        }
        self.rounded.take(seconds / leg.seconds - 1.0, at);
        let wanted = way * 60.0 / self.design.F;
        if leg.seconds > wanted * 1.01 && self.slowed.is_none_or(|(least, ..)| speed < least) {
            let by = motion.to.differences(&motion.from);
            let greatest = by.iter().fold(0.0_f64, |most, by| most.max(by.abs()));
            let by_axis = self.design.F_max.is_some_and(|F_max| leg.seconds <= greatest * 60.0 / F_max * (1.0 + 1e-6));
            self.slowed = Some((speed, at, !by_axis));
        }
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        let name = t("Longitud del corte en la raíz", "Length of the cut at the root");
        let length = Question::new("length", name, program).showing(Text::same(mm(self.length)), Text::same(""));
        vec![length.informs(), self.feed(program), feed_word(program, &self.rounded, true)]
    }
}

impl CutSpeed<'_> {
    fn feed(&self, program: &Program) -> Check {
        let name = t("Velocidad de corte en la raíz", "Cutting speed at the root");
        let [least, most] = self.speed.map(|speed| shown(speed, 1));
        // F is what was asked for, and no limit.
        let F = shown(self.design.F, 3);
        let value = Text::new(
            format!("{least} … {most} mm/min, con F = {F} mm/min"),
            format!("{least} … {most} mm/min, with F = {F} mm/min"),
        );
        let asked = Question::new("feed", name, program).showing(value, Text::same("")).seen(self.seen);
        let asked = asked.comparing(Figures { found: Some(self.speed), limit: None });
        if let Some((speed, at)) = self.off {
            let speed = Size::feed(speed, 1);
            return asked.at(Some(at)).holds(false, |place| NotItsTime { line: at.line, speed }.at(place));
        }
        let Some((speed, at, by_word)) = self.slowed else { return asked.passes() };
        let speed = Size::feed(speed, 0);
        if by_word {
            let control = self.design.post.control;
            let word = Size::number(control.feed.law.fastest(), 4);
            let asked = asked.at(Some(at)).of_parameters([parameters::F.key(), GAMMA.key()]);
            let told = WordSlows { speed, line: at.line, control: control.name, word };
            return asked.holds(false, |place| told.at(place));
        }
        let asked = asked.at(Some(at)).of_parameters([F_MAX.key(), GAMMA.key()]);
        asked.holds(false, |place| CutSlows { speed, line: at.line }.at(place))
    }
}

#[derive(Clone, Copy, Debug)]
struct BeamSample {
    /// What part of the motion lies before it.
    part: f64,
    /// The angle of the place to which the beam is nearest.
    alpha: f64,
    /// How far the beam passes from the root there.
    beam: f64,
    /// The chord of the angle between the torch and its true direction.
    bevel: f64,
}

/// What the errors nowhere exceed between two looks.
fn over(groove: &Groove, motion: &Motion, one: &BeamSample, other: &BeamSample) -> [f64; 2] {
    let (from, to) = (axes(place(motion, one.part)), axes(place(motion, other.part)));
    let running = |from: f64, to: f64| Jet::running(from, to, [0.0, 1.0]);
    let (A, B, C) = (running(from.A, to.A), running(from.B, to.B), running(from.C, to.C));
    let (X, Z) = (running(from.X, to.X), running(from.Z, to.Z));
    let about = |[x, y, z]: Vector| [x, y * A.cos() - z * A.sin(), y * A.sin() + z * A.cos()];
    let tip = about([X, Jet::of(0.0), Z]);
    let axis = about([B.sin() * C.cos(), B.sin() * C.sin(), B.cos()]);
    let exact = groove.beam(running(one.alpha, other.alpha));
    let beam = bow(&cross(axis, difference(exact.root, tip)), 1.0);
    let bevel = bow(&difference(axis, exact.axis), 1.0);
    [one.beam.max(other.beam) + beam + ARITHMETIC, one.bevel.max(other.bevel) + bevel + ARITHMETIC]
}

/// The five axes a part of the way along a motion.
fn place(motion: &Motion, part: f64) -> [f64; 5] {
    let (from, to) = (five(&motion.from), five(&motion.to));
    std::array::from_fn(|axis| from[axis] + (to[axis] - from[axis]) * part)
}

/// The chord of an angle in degrees, of a circle of radius 1; and back.
fn chord(degrees: f64) -> f64 {
    2.0 * sin_cos(degrees.to_radians() / 2.0).0
}

fn degrees(chord: f64) -> f64 {
    2.0 * asin((chord / 2.0).clamp(0.0, 1.0)).to_degrees()
}

/// What must be answered for the program of a design; what nobody answers is a stop.
#[must_use]
pub fn due(design: &Design) -> Vec<Due> {
    let mut due = ["agreement", "beam", "branch", "bevel", "crossing", "clearance"].map(Due::judged).to_vec();
    due.extend([Due::told("tilt"), Due::judged("turning"), Due::told("length")]);
    due.extend(["feed", "feed-word", "torch"].map(Due::judged));
    due.push(rollover::due(design.post.control.rotary.delivered));
    due
}

/// The judges of the program. `curve` takes the deviation along the curve.
#[must_use]
pub fn judges<'a>(design: &'a Design, cut: &'a Cut, curve: &'a mut Curve) -> Vec<Box<dyn Judge + 'a>> {
    let limits = [tolerance(design), chord(BEVEL)];
    let errors = Enclosed::new([1e-3 * design.arc_tolerance, 1e-5], limits, CUT_LOOKS);
    let groove = design.groove();
    let crossing = Crossing::new(groove, BEVEL.to_radians());
    let back = retract(design, cut).len();
    vec![
        Box::new(Agreement::of_the_torch(HELD, cut.legs.len() + back, back)),
        Box::new(BeamOnRoot { design, cut, groove, errors, crossing, curve }),
        Box::new(Clearance::new(design, cut)),
        Box::new(Swing { cut, tilt: [f64::INFINITY, f64::NEG_INFINITY], turn: Extreme::nothing() }),
        Box::new(CutSpeed {
            design,
            cut,
            speed: [f64::INFINITY, 0.0],
            off: None,
            slowed: None,
            rounded: Extreme::nothing(),
            length: 0.0,
            seen: 0,
        }),
        Box::new(Torch(Some([&design.torch_on, &design.torch_off]))),
        Box::new(Rollover::new(design.post.control.rotary.delivered)),
    ]
}
