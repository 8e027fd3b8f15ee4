//! The verification of a hole's program: what the torch would do, held against plan, curve, pipes and torch.
//!
//! Every motion of the cut is looked at in several poses, put back onto the pipe by the machine's forward kinematics. From
//! each the nearest place of the exact cut is sought: how far the beam passes from its root is how far the cut is off; half
//! a kerf back across the cut face lies the edge that is cut, which must lie on the branch, grown by its gap. The torch's
//! tip, taper and body, point by point, must keep their distance from the pipe itself, not from a tangent plane.

use std::f64::consts::TAU;

use nalgebra::Vector3;

use crate::gcode::interpreter::Interpreter;
use crate::gcode::motion::{Kind, Motion};
use crate::gcode::program::Program;
use crate::machine::axis::{Axis, Pose};
use crate::machine::torch::TorchPose;
use crate::number::grid::Milli;
use crate::number::root::golden;
use crate::number::shown;
use crate::number::trig::{hypot, sin_cos};
use crate::pipe::hole::cut::{Cut, Follows, Leg, axes, off, root};
use crate::pipe::hole::design::Design;
use crate::pipe::hole::program::AXES;
use crate::pipe::hole::station::{Groove, Station};
use crate::text::Text;
use crate::verify::account::Account;
use crate::verify::check::{At, Check, FAULT, Verdict, mm};
use crate::verify::feed::{feed_word, timely};
use crate::verify::verification::{Verification, as_planned, reading, torch};

/// Poses of a motion that are looked at.
const LOOKS: u16 = 8;
/// How far a position may be from the plan.
const SAME: f64 = 1e-6;
/// What rounding to 0.001 mm and 0.001° takes, beside the tolerance: a thousandth of a degree at the pipe's radius.
fn rounding(design: &Design) -> f64 {
    0.002 + 0.001_f64.to_radians() * (design.R_o() + design.D_max)
}

/// By how much the bevel may be off before a person must judge it, degrees: a fifth of what welding procedures allow
/// for a groove angle (AWS D1.1, −5°).
const BEVEL: f64 = 1.0;

/// Points round the torch's tip and body.
const ROUND: u16 = 36;

/// The least distance of a torch in a pose from a pipe of radius R_o about the x axis: tip, taper and body are looked at
/// point by point, the body up to as far as the taper is long and a body's width more.
#[must_use]
pub fn clearance(design: &Design, pose: &TorchPose) -> f64 {
    let (r_g, R_g, shoulder) = (design.r_g, design.R_g, design.torch().shoulder());
    let aside = if pose.axis.x.abs() < 0.9 { Vector3::x() } else { Vector3::y() };
    let Some(first) = pose.axis.cross(&aside).try_normalize(1e-9) else { return f64::NEG_INFINITY };
    let second = pose.axis.cross(&first);
    let levels = (0..=8_u16)
        .map(|at| {
            let part = f64::from(at) / 8.0;
            (shoulder * part, r_g + (R_g - r_g) * part)
        })
        .chain((1..=4_u16).map(|at| (shoulder + 0.5 * R_g * f64::from(at), R_g)));
    let mut least = f64::INFINITY;
    for (up, radius) in levels {
        for at in 0..ROUND {
            let (sin, cos) = sin_cos(TAU * f64::from(at) / f64::from(ROUND));
            let point = pose.tip + pose.axis * up + (first * cos + second * sin) * radius;
            least = least.min(hypot(point.y, point.z) - design.R_o());
        }
    }
    least
}

/// A greatest value and its place.
#[derive(Clone, Copy, Debug)]
struct Worst {
    value: f64,
    at: Option<At>,
}

impl Worst {
    const fn from(value: f64) -> Self {
        Self { value, at: None }
    }

    fn raise(&mut self, value: f64, at: At) {
        if value > self.value {
            *self = Self { value, at: Some(at) };
        }
    }
}

/// The deviation along the curve, to be drawn: α in degrees and mm.
pub type Curve = Vec<[f64; 2]>;

struct Watch<'d> {
    design: &'d Design,
    groove: Groove,
    agreed: usize,
    different: Option<(At, Text)>,
    beam: Worst,
    branch: Worst,
    bevel: Worst,
    /// The clearance, negative, so that the least is the worst.
    near: Worst,
    tilt: [f64; 2],
    speed: [f64; 2],
    off_speed: Option<(f64, At)>,
    slowed: Option<(f64, At)>,
    rounded: Option<(f64, At)>,
    turn: Worst,
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
        if same && matches!(motion.kind, Kind::Feed(_)) {
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

    fn pose(motion: &Motion, part: f64) -> TorchPose {
        let (from, to) = (five(&motion.from), five(&motion.to));
        axes(std::array::from_fn(|axis| from[axis] + (to[axis] - from[axis]) * part)).pose()
    }

    fn look(&mut self, motion: &Motion, leg: &Leg) {
        let Leg { follows, way, .. } = *leg;
        let at = At::motion(motion);
        for part in (0..=LOOKS).map(|at| f64::from(at) / f64::from(LOOKS)) {
            let pose = Self::pose(motion, part);
            self.near.raise(-clearance(self.design, &pose), at);
            let Follows::Curve([from, to]) = follows else { continue };
            let margin = 0.5 * (to - from) + 1e-9;
            let middle = from + (to - from) * part;
            let groove = self.groove;
            let beside = groove.beside;
            let beam = |alpha: f64| groove.at(alpha).map_or(f64::INFINITY, |station| off(&pose, &station, beside));
            let (_, alpha) = golden([middle - margin, middle + margin], 25, beam);
            let Some(station) = groove.at(alpha) else { continue };
            self.look_at(&pose, &station, at);
        }
        self.length += way;
        let by = motion.to.differences(&motion.from);
        self.turn.raise(by[Axis::C as usize].abs(), at);
        self.tilt = [self.tilt[0].min(motion.to.get(Axis::B)), self.tilt[1].max(motion.to.get(Axis::B))];
        if let Some(seconds) = motion.seconds.filter(|seconds| *seconds > 0.0) {
            let speed = way * 60.0 / seconds;
            self.speed = [self.speed[0].min(speed), self.speed[1].max(speed)];
            let word = if let Kind::Feed(feed) = motion.kind { feed.value } else { 0.0 };
            if !timely(self.design.dialect.feed, motion, word, leg.seconds) {
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

    fn look_at(&mut self, pose: &TorchPose, station: &Station, at: At) {
        let beside = self.groove.beside;
        let beam = off(pose, station, beside);
        self.beam.raise(beam, at);
        self.curve.push([station.alpha.to_degrees(), beam]);
        // The place of the beam nearest to the root, and half a kerf back from it the edge that is cut.
        let to_root = root(station, beside) - pose.tip;
        let edge = pose.tip + pose.axis * to_root.dot(&pose.axis) - station.waste * beside;
        self.branch.raise(self.groove.pair.off_branch(&edge).abs(), at);
        self.bevel.raise(pose.axis.cross(&station.pose.axis).norm().to_degrees(), at);
    }
}

/// Reads the program of a hole back and judges it. Beside the verification: the deviation along the curve, and what the
/// program comes to.
#[must_use]
pub fn verify(design: &Design, cut: &Cut, program: &Program) -> (Verification, Curve, Account) {
    let (checks, curve, account) = judge(design, cut, program, &mut program.read_back());
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
        beam: Worst::from(0.0),
        branch: Worst::from(0.0),
        bevel: Worst::from(0.0),
        near: Worst::from(f64::NEG_INFINITY),
        tilt: [f64::INFINITY, f64::NEG_INFINITY],
        speed: [f64::INFINITY, 0.0],
        off_speed: None,
        slowed: None,
        rounded: None,
        turn: Worst::from(0.0),
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
            Kind::Dwell(_) => {}
            Kind::Rapid => {
                rapids += 1;
                // The first two come from where the machine stood, high above the pipe or on the way there.
                if rapids > 2 {
                    let ends = [0.0, 0.5, 1.0].map(|part| Watch::pose(&motion, part));
                    for pose in ends {
                        watch.near.raise(-clearance(design, &pose), At::motion(&motion));
                    }
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
    let within = |key, name: Text, worst: Worst, es: &str, en: &str| {
        let check = Check::passed(key, name, program, Text::same(mm(worst.value)), Text::same(mm(tolerance)));
        let check = check.at(worst.at);
        if worst.value <= tolerance {
            return check;
        }
        let (off, limit) = (mm(worst.value), mm(tolerance));
        check.found(
            Verdict::Stop,
            Text::new(format!("{es} {off}; la tolerancia es {limit}"), format!("{en} {off}; the tolerance is {limit}")),
            FAULT,
        )
    };
    let beam = within(
        "beam",
        Text::fixed("Chorro contra la raíz exacta", "Beam against the exact root"),
        watch.beam,
        "el chorro se aparta de la raíz exacta",
        "the beam leaves the exact root by",
    );
    let branch = within(
        "branch",
        Text::fixed("Borde cortado, sobre el injerto con su holgura", "Edge that is cut, on the branch with its gap"),
        watch.branch,
        "el borde cortado se aparta del injerto con su holgura",
        "the edge that is cut is off the branch with its gap by",
    );
    let name = Text::fixed("Bisel: mayor error de ángulo", "Bevel: greatest error of angle");
    let value = Text::same(format!("{}°", shown(watch.bevel.value, 3)));
    let bevel = Check::passed("bevel", name, program, value, Text::same(format!("{BEVEL}°"))).at(watch.bevel.at);
    let bevel = if watch.bevel.value <= BEVEL {
        bevel
    } else {
        let angle = shown(watch.bevel.value, 2);
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
    let (least, limit) = (-watch.near.value, design.g0 - tolerance);
    let near = Check::passed("clearance", name, program, Text::same(mm(least)), Text::same(mm(limit)));
    let near = near.at(watch.near.at);
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
    let value = Text::same(format!("{}°", shown(watch.turn.value, 3)));
    let turn = Check::passed("turning", name, program, value, Text::same("90°")).at(watch.turn.at);
    let turn = if watch.turn.value <= 90.0 {
        turn
    } else {
        let step = shown(watch.turn.value, 3);
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
        beam,
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
