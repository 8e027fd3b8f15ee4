//! The verification of a hole's program: what the torch would do, held against plan, curve, pipes and torch.
//!
//! Every motion of the cut is looked at in several poses, put back onto the pipe by the machine's forward kinematics. From
//! each the nearest place of the exact cut is sought: how far the beam passes from its root is how far the cut is off. Half
//! a kerf back across the cut face lies the edge that is cut, which is off the branch, grown by its gap, by no more than the beam
//! is off the root, since the root's own edge lies on it.
//!
//! The torch is the convex body about its tip, its shoulder and the end of its body, three discs square to its axis. For any
//! direction u across the pipe's axis no point of it comes nearer to that axis than the least of u·c − ρ|u × a| over the discs
//! (middle c, radius ρ), and for one direction that is the distance itself: so the torch keeps clear of the round pipe, not of a
//! tangent plane or of points on it.
//!
//! Between two poses all of these leave what runs evenly from the one to the other by no more than an eighth of their second
//! derivative, as jets enclose it. Motions are parted until that decides.

use std::f64::consts::FRAC_PI_2;

use nalgebra::Vector3;

use crate::gcode::interpreter::Interpreter;
use crate::gcode::motion::{Motion, MotionKind};
use crate::gcode::program::Program;
use crate::kinds::pipe::hole::cut::{Cut, Follows, Leg, axes, off};
use crate::kinds::pipe::hole::design::Design;
use crate::kinds::pipe::hole::program::AXES;
use crate::kinds::pipe::hole::station::Groove;
use crate::machine::axis::{Axis, Pose};
use crate::machine::torch::{TorchAxes, TorchPose};
use crate::number::grid::Milli;
use crate::number::jet::{Jet, Vector, bow, cross, difference};
use crate::number::root::golden;
use crate::number::shown;
use crate::number::trig::{asin, atan2, sin_cos};
use crate::proof::account::Account;
use crate::proof::check::{At, Check, FAULT, Verdict, mm};
use crate::proof::enclosed::{Enclosed, row, within};
use crate::proof::feed::{feed_word, timely};
use crate::proof::rollover;
use crate::proof::verification::{Verification, as_planned, reading, torch};
use crate::text::Text;

/// How far a position may be from the plan.
const SAME: f64 = 1e-6;
/// What rounding to 0.001 mm and 0.001° takes, beside the tolerance: a thousandth of a degree at the pipe's radius.
fn rounding(design: &Design) -> f64 {
    0.002 + 0.001_f64.to_radians() * (design.R_o() + design.D_max)
}

/// By how much the bevel may be off before a person must judge it, degrees: a fifth of what welding procedures allow
/// for a groove angle (AWS D1.1, −5°).
const BEVEL: f64 = 1.0;

/// Looks that a program may take at its cut, and at the torch's clearance, beyond the first at each motion.
const WORK: u32 = 100_000;
/// What the arithmetic of a look may lose.
const ARITHMETIC: f64 = 1e-9;

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

/// The deviation along the curve, to be drawn: α in degrees and mm.
pub type Curve = Vec<[f64; 2]>;

struct Watch<'d> {
    design: &'d Design,
    groove: Groove,
    agreed: usize,
    different: Option<(At, Text)>,
    /// How far the beam passes from the root, and the chord of the angle by which the torch is off.
    errors: Enclosed<2>,
    /// The clearance, negative, so that the least is the worst.
    near: Enclosed<1>,
    tilt: [f64; 2],
    speed: [f64; 2],
    off_speed: Option<(f64, At)>,
    slowed: Option<(f64, At)>,
    rounded: Option<(f64, At)>,
    turn: Option<(f64, At)>,
    curve: Curve,
    length: f64,
}

fn five(pose: &Pose) -> [f64; 5] {
    AXES.map(|axis| pose.get(axis))
}

impl Watch<'_> {
    fn compare(&mut self, motion: &Motion, planned: Option<[Milli; 5]>) {
        let at = At::motion(motion);
        let Some(planned) = planned else {
            let what = Text::fixed("hay un movimiento que no está en el plan", "there is a motion beyond the plan");
            self.different.get_or_insert((at, what));
            return;
        };
        let (read, plan) = (five(&motion.to), planned.map(Milli::value));
        let same = (0..5).all(|axis| (read[axis] - plan[axis]).abs() <= SAME) && motion.to.get(Axis::Y) == 0.0;
        if same && matches!(motion.kind, MotionKind::Feed(_)) {
            self.agreed += 1;
        } else {
            let show = |place: [f64; 5]| place.map(|value| shown(value, 4)).join(" ");
            let (read, plan) = (show(read), show(plan));
            let what = Text::new(
                format!("llega a A X Z B C {read} y el plan dice {plan}"),
                format!("it goes to A X Z B C {read} where the plan has {plan}"),
            );
            self.different.get_or_insert((at, what));
        }
    }

    fn look(&mut self, motion: &Motion, leg: &Leg) {
        let Leg { follows, way, .. } = *leg;
        let at = At::motion(motion);
        self.look_at_clearance(motion);
        if let Follows::Curve(angles) = follows {
            self.look_at_cut(motion, angles);
        }
        self.length += way;
        let by = motion.to.differences(&motion.from);
        let turn = by[Axis::C as usize].abs();
        if self.turn.is_none_or(|(most, _)| turn > most) {
            self.turn = Some((turn, at));
        }
        self.tilt = [self.tilt[0].min(motion.to.get(Axis::B)), self.tilt[1].max(motion.to.get(Axis::B))];
        if let Some(seconds) = motion.seconds.filter(|seconds| *seconds > 0.0) {
            let speed = way * 60.0 / seconds;
            self.speed = [self.speed[0].min(speed), self.speed[1].max(speed)];
            let word = if let MotionKind::Feed(feed) = motion.kind { feed.value } else { 0.0 };
            if !timely(self.design.control.feed.law, motion, word, leg.seconds) {
                self.off_speed.get_or_insert((speed, at));
            }
            let slower = seconds / leg.seconds - 1.0;
            if self.rounded.is_none_or(|(most, _)| slower > most) {
                self.rounded = Some((slower, at));
            }
            let wanted = way * 60.0 / self.design.F;
            if leg.seconds > wanted * 1.01 && self.slowed.is_none_or(|(least, _)| speed < least) {
                self.slowed = Some((speed, at));
            }
        } else {
            self.off_speed.get_or_insert((0.0, at));
        }
    }

    /// Holds the torch's way along a motion against the pipe. The pipe is round: only height, tilt and swing count.
    fn look_at_clearance(&mut self, motion: &Motion) {
        let design = self.design;
        self.near.take(
            At::motion(motion),
            &[0.0, 1.0].map(|part| Near::at(design, motion, part)),
            |near| [-near.clear],
            |one, other| [one.over(design, motion, other)],
            |one, other| Near::at(design, motion, f64::midpoint(one.part, other.part)),
        );
    }

    /// Holds the beam along a motion against the cut between two angles.
    fn look_at_cut(&mut self, motion: &Motion, [from, to]: [f64; 2]) {
        let groove = self.groove;
        let beside = groove.beside;
        let curve = &mut self.curve;
        let mut look = |part: f64, span: [f64; 2], steps: u32| {
            let pose = axes(place(motion, part)).pose();
            let beam = |alpha: f64| groove.at(alpha).map_or(f64::INFINITY, |station| off(&pose, &station, beside));
            let (_, alpha) = golden(span, steps, beam);
            let station = groove.at(alpha);
            let [beam, bevel] = station.map_or([f64::INFINITY; 2], |station| {
                [off(&pose, &station, beside), (pose.axis - station.pose.axis).norm()]
            });
            curve.push([alpha.to_degrees(), beam]);
            Look { part, alpha, beam, bevel }
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

/// A look at the torch's clearance.
#[derive(Clone, Copy, Debug)]
struct Near {
    /// What part of the motion lies before it.
    part: f64,
    /// The torch, over a pipe that is not turned.
    pose: TorchPose,
    /// The direction in which it is nearest.
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

/// A look at the cut.
#[derive(Clone, Copy, Debug)]
struct Look {
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
fn over(groove: &Groove, motion: &Motion, one: &Look, other: &Look) -> [f64; 2] {
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

/// What the torch must keep clear by.
fn clear_limit(design: &Design) -> f64 {
    design.g0 - design.arc_tolerance - rounding(design)
}

/// Reads the program of a hole back and judges it. Beside the verification: the deviation along the curve, and what the
/// program comes to.
#[must_use]
pub fn verify(design: &Design, cut: &Cut, program: &Program) -> (Verification, Curve, Account) {
    let (mut checks, curve, account) = judge(design, cut, program, &mut program.read_back());
    checks.push(rollover::check(program, design.control.rotary.delivered));
    let mut verification = Verification::default();
    verification.add(program, checks);
    (verification, curve, account)
}

/// Judges what a text gives.
pub fn judge(
    design: &Design,
    cut: &Cut,
    program: &Program,
    text: &mut Interpreter<'_>,
) -> (Vec<Check>, Curve, Account) {
    let legs = &cut.legs;
    let mut watch = Watch {
        design,
        groove: design.groove(),
        agreed: 0,
        different: None,
        errors: Enclosed::new(
            [1e-3 * design.arc_tolerance, 1e-5],
            [design.arc_tolerance + rounding(design), chord(BEVEL)],
            WORK,
        ),
        near: Enclosed::new([1e-3], [-clear_limit(design)], WORK),
        tilt: [f64::INFINITY, f64::NEG_INFINITY],
        speed: [f64::INFINITY, 0.0],
        off_speed: None,
        slowed: None,
        rounded: None,
        turn: None,
        curve: Curve::new(),
        length: 0.0,
    };
    let (mut account, mut before, mut done, mut fault) = (Account::default(), None, 0, None);
    let (mut rapids, mut last) = (0, None);
    for motion in &mut *text {
        let motion = match motion {
            Ok(motion) => motion,
            Err(found) => {
                fault = Some(found);
                break;
            }
        };
        if let Some(before) = before {
            account.take(&motion, &before);
        }
        before = Some(motion.machine);
        match motion.kind {
            MotionKind::Dwell(_) => {}
            MotionKind::Rapid => {
                rapids += 1;
                // The first two come from where the machine stood, high above the pipe or on the way there.
                if rapids > 2 {
                    watch.look_at_clearance(&motion);
                }
                if done == 0 {
                    last = Some(five(&motion.to));
                }
            }
            _ => {
                let planned = legs.get(done);
                watch.compare(&motion, planned.map(|leg| leg.to));
                if let Some(leg) = planned {
                    watch.look(&motion, leg);
                }
                done += 1;
            }
        }
    }
    let pierce = cut.pierce.map(Milli::value);
    if last.is_none_or(|last| (0..5).any(|axis| (last[axis] - pierce[axis]).abs() > SAME)) {
        let what = Text::fixed("no perfora donde dice el plan", "it does not pierce where the plan has it");
        watch.different.get_or_insert((At { line: 1, n: None, point: None }, what));
    }
    let mut checks = vec![reading(program, text, fault.as_deref())];
    if fault.is_none() {
        checks.extend(answers(design, program, &mut watch, legs.len()));
        checks.push(torch(program, Some([&design.torch_on, &design.torch_off])));
    }
    watch.curve.sort_by(|one, other| one[0].total_cmp(&other[0]));
    (checks, watch.curve, account)
}

fn answers(design: &Design, program: &Program, watch: &mut Watch<'_>, planned: usize) -> Vec<Check> {
    let agreement = as_planned(program, watch.agreed, planned, watch.different.take());
    let tolerance = design.arc_tolerance + rounding(design);
    let beam = watch.errors.at_most(0);
    let name = Text::fixed("Chorro contra la raíz exacta", "Beam against the exact root");
    let words = ["el chorro se aparta de la raíz exacta", "the beam leaves the exact root by"];
    let beam_check = within(row("beam", name, program, beam, tolerance), (&watch.errors, 0), tolerance, words, FAULT);
    let name =
        Text::fixed("Borde cortado, sobre el injerto con su holgura", "Edge that is cut, on the branch with its gap");
    // No farther than the beam from the root.
    let words = [
        "el borde cortado se aparta del injerto con su holgura",
        "the edge that is cut is off the branch with its gap by",
    ];
    let branch = within(row("branch", name, program, beam, tolerance), (&watch.errors, 0), tolerance, words, FAULT);
    let name = Text::fixed("Bisel: mayor error de ángulo", "Bevel: greatest error of angle");
    let most = degrees(watch.errors.at_most(1));
    let value = Text::same(format!("≤ {}°", shown(most, 3)));
    let bevel = Check::passed("bevel", name, program, value, Text::same(format!("{BEVEL}°"))).at(watch.errors.at[1]);
    let bevel = if watch.errors.at_most(1) <= chord(BEVEL) {
        bevel
    } else {
        let angle = shown(most, 2);
        bevel.of_parameters(vec!["gamma"]).found(
            Verdict::Caution,
            Text::new(
                format!("el bisel se aparta hasta {angle}° donde la antorcha pasa cerca de la vertical"),
                format!("the bevel is off by up to {angle}° where the torch passes near the vertical"),
            ),
            Text::fixed("otro ángulo de bisel", "another groove angle"),
        )
    };
    let name = Text::fixed("Distancia de la antorcha al tubo", "Distance of the torch from the pipe");
    // A distance below the least that could be ruled out is none to count on.
    let (least, limit) = (-watch.near.at_most(0), clear_limit(design));
    let near = Check::passed("clearance", name, program, Text::same(format!("≥ {}", mm(least))), Text::same(mm(limit)));
    let near = near.at(watch.near.at[0]);
    let near = if least >= limit {
        near
    } else {
        near.of_parameters(vec!["g0", "arc_tolerance"]).found(
            Verdict::Stop,
            Text::new(
                format!("la antorcha llega a {} del tubo; lo menos es g0 = {}", mm(least), mm(design.g0)),
                format!("the torch comes to {} from the pipe; the least is g0 = {}", mm(least), mm(design.g0)),
            ),
            Text::fixed("una tolerancia más fina, o más g0", "a finer tolerance, or a greater g0"),
        )
    };
    let name = Text::fixed("Inclinación B", "Tilt B");
    let value = Text::same(format!("{} … {}°", shown(watch.tilt[0], 3), shown(watch.tilt[1], 3)));
    let tilt = Check::passed("tilt", name, program, value, Text::same("")).informing();
    let name = Text::fixed("Continuidad de C: mayor paso", "Continuity of C: greatest step");
    let most = watch.turn.map_or(0.0, |(most, _)| most);
    let value = Text::same(format!("{}°", shown(most, 3)));
    let turn = Check::passed("turning", name, program, value, Text::same("90°")).at(watch.turn.map(|(_, at)| at));
    let turn = if most <= 90.0 {
        turn
    } else {
        let step = shown(most, 3);
        turn.found(
            Verdict::Caution,
            Text::new(
                format!("C gira {step}° de golpe, donde la antorcha pasa por la vertical"),
                format!("C turns by {step}° at once, where the torch passes the vertical"),
            ),
            Text::fixed("otro ángulo de bisel", "another groove angle"),
        )
    };
    let name = Text::fixed("Longitud del corte en la raíz", "Length of the cut at the root");
    let length = Check::passed("length", name, program, Text::same(mm(watch.length)), Text::same("")).informing();
    vec![
        agreement,
        beam_check,
        branch,
        bevel,
        near,
        tilt,
        turn,
        length,
        feed(design, program, watch),
        feed_word(program, watch.rounded),
    ]
}

fn feed(design: &Design, program: &Program, watch: &Watch<'_>) -> Check {
    let name = Text::fixed("Velocidad de corte en la raíz", "Cutting speed at the root");
    let [least, most] = watch.speed.map(|speed| shown(speed, 1));
    let F = shown(design.F, 3);
    let value = Text::same(format!("{least} … {most} mm/min"));
    let check = Check::passed("feed", name, program, value, Text::same(format!("{F} mm/min")));
    match (watch.off_speed, watch.slowed) {
        (None, None) => check,
        (None, Some((speed, at))) => {
            let speed = shown(speed, 0);
            check.at(Some(at)).of_parameters(vec!["F_max", "gamma"]).found(
                Verdict::Caution,
                Text::new(
                    format!("el corte baja a {speed} mm/min en la línea {}: un eje llegaría a su límite", at.line),
                    format!("the cut slows to {speed} mm/min at line {}: an axis would pass its limit", at.line),
                ),
                Text::fixed(
                    "más F_max si la máquina lo permite, u otro bisel",
                    "a greater F_max if the machine allows it, or another groove",
                ),
            )
        }
        (Some((speed, at)), _) => {
            let speed = shown(speed, 1);
            check.at(Some(at)).found(
                Verdict::Stop,
                Text::new(
                    format!("el movimiento de la línea {} no dura lo planeado: {speed} mm/min", at.line),
                    format!("the motion at line {} does not take its planned time: {speed} mm/min", at.line),
                ),
                FAULT,
            )
        }
    }
}
