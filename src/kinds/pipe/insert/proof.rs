//! The verification of a branch's program: what the torch would do, held against plan, curve and both pipes.
//!
//! Every motion of the cut is looked at in some points. From each the nearest point of the exact torch path is sought,
//! which gives how far the torch leaves it; half a kerf back across the curve lies the edge that is cut, and that edge, put
//! on the branch's surface, must lie on the header's. Between two looks the error e, taken between points that run evenly from
//! look to look, is nowhere greater than at them by more than an eighth of its greatest second derivative (as jets enclose it),
//! nor, where the curve has a corner, than the way between them allows. Motions are parted until that decides.

use std::f64::consts::TAU;

use nalgebra::Vector2;

use crate::gcode::control::FeedLaw;
use crate::gcode::feed_word::step;
use crate::gcode::interpreter::{Interpreter, Setting};
use crate::gcode::motion::{Motion, MotionKind};
use crate::gcode::program::{Program, Style};
use crate::geometry::pipe_pair::Side;
use crate::kinds::pipe::insert::arcs::triples;
use crate::kinds::pipe::insert::cut::{Cut, Follows};
use crate::kinds::pipe::insert::design::{Design, Mode};
use crate::kinds::pipe::insert::outline::Outline;
use crate::kinds::pipe::insert::program::{approach, template_points};
use crate::machine::axis::{Axis, Pose};
use crate::number::grid::Milli;
use crate::number::jet::{Jet, bow};
use crate::number::root::golden;
use crate::number::shown;
use crate::number::trig::{atan2, hypot, sin_cos};
use crate::proof::account::Account;
use crate::proof::check::{At, Check, FAULT, Verdict, mm};
use crate::proof::enclosed::{Enclosed, row, within};
use crate::proof::feed::{feed_word, timely};
use crate::proof::rollover;
use crate::proof::verification::{Verification, as_planned, reading, torch};
use crate::text::Text;

/// How far a position may be from the plan: what the decimals of the published program leave.
const SAME: f64 = 1e-6;
/// What rounding an end and a radius to 0.001 takes, beside the tolerance.
const ROUNDING: f64 = 0.002;

/// A motion of the plan.
#[derive(Clone, Copy, Debug)]
pub struct Planned {
    to: [f64; 2],
    /// Clockwise or not, and the radius; `None` for a straight one.
    bend: Option<(bool, f64)>,
    follows: Follows,
}

/// The plan of a program: where it pierces and the motions from there on.
#[must_use]
pub fn plan(design: &Design, cut: Option<&Cut>) -> ([f64; 2], Vec<Planned>) {
    let value = |to: [Milli; 2]| to.map(Milli::value);
    match cut {
        Some(cut) => {
            let legs = cut.legs.iter().map(|leg| Planned {
                to: value(leg.to),
                bend: leg.bend.map(|bend| (bend.clockwise, bend.radius.value())),
                follows: leg.follows,
            });
            (value(cut.pierce), legs.collect())
        }
        None => {
            let points = template_points(design);
            let turn = |j: usize| {
                #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
                let j = j as f64;
                TAU * j / f64::from(design.N)
            };
            let mut from = 0;
            let legs = triples(&points, design.arc_tolerance).into_iter().map(|triple| {
                let follows = Follows::Curve([turn(from), turn(triple.j)]);
                from = triple.j;
                let bend = triple.circle.map(|circle| (!circle.left, circle.radius));
                Planned { to: triple.to.into(), bend, follows }
            });
            let legs = legs.collect();
            (points.first().map_or([0.0; 2], |first| (*first).into()), legs)
        }
    }
}

/// The deviation along the curve, to be drawn: φ in degrees and mm, positive into the waste.
pub type Curve = Vec<[f64; 2]>;

/// Watches the motions of a branch's program.
struct Watch<'d> {
    design: &'d Design,
    outline: Outline,
    agreed: usize,
    different: Option<(At, Text)>,
    /// How far the torch leaves its path, and the edge that is cut the header.
    errors: Enclosed<2>,
    speed: Option<(f64, At)>,
    slowest: Option<f64>,
    off_speed: Option<(f64, At)>,
    rounded: Option<(f64, At)>,
    untimed: bool,
    curve: Curve,
    length: f64,
}

/// The two coordinates of a pose that the program moves.
fn axes(mode: Mode, pose: &Pose) -> [f64; 2] {
    match mode {
        Mode::Flat => [pose.get(Axis::X), pose.get(Axis::Y)],
        Mode::Rotary => [pose.get(Axis::A), pose.get(Axis::X)],
    }
}

impl Watch<'_> {
    fn development(&self, [first, second]: [f64; 2]) -> Vector2<f64> {
        match self.design.mode {
            Mode::Flat => Vector2::new(first, second),
            Mode::Rotary => Vector2::new(first.to_radians() * self.outline.radius, second),
        }
    }

    /// The way of a motion over the surface that is cut.
    fn way(&self, motion: &Motion) -> Way {
        let [from, to] = [&motion.from, &motion.to].map(|pose| axes(self.design.mode, pose));
        match motion.kind {
            MotionKind::Arc(arc, _) => {
                let centre = Vector2::from(arc.centre);
                let [start, end] = [from, to].map(|place| Vector2::from(place) - centre);
                let angle = atan2(start.y, start.x);
                // The radius runs over from that of the start to that of the end.
                Way::Arc { centre, angle, sweep: arc.sweep, radii: [start.norm(), end.norm()] }
            }
            _ => Way::Straight([self.development(from), self.development(to)]),
        }
    }

    fn compare(&mut self, motion: &Motion, planned: Option<&Planned>) {
        let at = At::motion(motion);
        let Some(planned) = planned else {
            let what = Text::fixed("hay un movimiento que no está en el plan", "there is a motion beyond the plan");
            self.different.get_or_insert((at, what));
            return;
        };
        let to = axes(self.design.mode, &motion.to);
        let bend = match motion.kind {
            MotionKind::Arc(arc, _) => Some((arc.turns < 0, arc.radius)),
            _ => None,
        };
        let alike = match (bend, planned.bend) {
            (None, None) => true,
            // A radius given to three or six decimals moves the centre, and so the radius read back, by rounding only.
            (Some((turn, radius)), Some((planned_turn, planned))) => {
                turn == planned_turn && (radius - planned).abs() <= 1e-6 * planned.max(1.0)
            }
            _ => false,
        };
        let same = (0..2).all(|axis| (to[axis] - planned.to[axis]).abs() <= SAME);
        if alike && same && !matches!(motion.kind, MotionKind::Rapid) {
            self.agreed += 1;
        } else {
            let show = |to: [f64; 2]| format!("{} {}", shown(to[0], 4), shown(to[1], 4));
            let (read, plan) = (show(to), show(planned.to));
            let what = Text::new(
                format!("llega a {read} y el plan dice {plan}"),
                format!("it goes to {read} where the plan has {plan}"),
            );
            self.different.get_or_insert((at, what));
        }
    }

    /// Looks at a motion of the cut.
    fn look(&mut self, motion: &Motion, follows: Follows) {
        let way = self.way(motion);
        let length = if let MotionKind::Arc(arc, _) = motion.kind { arc.length(0.0) } else { way.length() };
        self.length += length;
        self.look_at_speed(motion, length);
        let at = At::motion(motion);
        match follows {
            Follows::Curve(leg) => self.look_along(&way, leg, at),
            Follows::Corner(phi) => {
                let off = way.off_circle(self.outline.curve(phi), self.outline.beside);
                self.errors.take(at, &[off], |off| [*off, 0.0], |one, other| [one.max(*other), 0.0], |one, _| *one);
            }
            Follows::WayIn | Follows::Beyond => {}
        }
    }

    fn look_at_speed(&mut self, motion: &Motion, length: f64) {
        let Some(seconds) = motion.seconds.filter(|seconds| *seconds > 0.0) else {
            self.untimed = true;
            return;
        };
        let at = At::motion(motion);
        let speed = length * 60.0 / seconds;
        if self.speed.is_none_or(|(most, _)| speed > most) {
            self.speed = Some((speed, at));
        }
        self.slowest = Some(self.slowest.map_or(speed, |least: f64| least.min(speed)));
        let word = match motion.kind {
            MotionKind::Feed(feed) | MotionKind::Arc(_, feed) => feed.value,
            MotionKind::Rapid | MotionKind::Thread(_) | MotionKind::Dwell(_) => 0.0,
        };
        let F = self.design.F.unwrap_or(speed);
        let planned = length * 60.0 / F;
        let good = match self.design.mode {
            // F is the speed over the sheet itself; a word within a billionth of a whole step is that step.
            Mode::Flat => (F - step(FeedLaw::Resultant, F)..=F * (1.0 + 1e-9)).contains(&word),
            Mode::Rotary => timely(self.design.control.feed.law, motion, word, planned),
        };
        if !good || seconds < planned * (1.0 - 1e-6) {
            self.off_speed.get_or_insert((speed, at));
        }
        let slower = seconds / planned - 1.0;
        if self.rounded.is_none_or(|(most, _)| slower > most) {
            self.rounded = Some((slower, at));
        }
    }

    /// Holds a motion against the curve between two angles.
    fn look_along(&mut self, way: &Way, leg: [f64; 2], at: At) {
        let outline = self.outline;
        let [from, to] = leg;
        let inside = f64::midpoint(from, to);
        let side = |phi: f64| if phi < inside { Side::After } else { Side::Before };
        let curve = &mut self.curve;
        let mut look = |part: f64, span: [f64; 2], steps: u32| {
            let point = way.at(part);
            let near = side(f64::midpoint(span[0], span[1]));
            // Sideways to a small part of the span: the distance, which is square in it, far better.
            let phi = golden(span, steps, |phi| (outline.torch(phi, near) - point).norm_squared()).1;
            let across = outline.across(phi, near);
            let off = point - outline.torch(phi, near);
            curve.push([phi.to_degrees(), off.dot(&across)]);
            Look { part, phi, off: off.norm(), edge: off_header(&outline, point - across * outline.beside).abs() }
        };
        let margin = (to - from) * 0.5 + 1e-9;
        let first = [0.0, 0.5, 1.0].map(|part| {
            let near = from + (to - from) * part;
            look(part, [(near - margin).max(from), (near + margin).min(to)], 25)
        });
        self.errors.take(
            at,
            &first,
            |look| [look.off, look.edge],
            |one, other| over(&outline, way, inside, one, other),
            |one, other| {
                let (low, high) = (one.phi.min(other.phi), one.phi.max(other.phi));
                let wider = 0.25 * (high - low) + 1e-9;
                look(f64::midpoint(one.part, other.part), [(low - wider).max(from), (high + wider).min(to)], 20)
            },
        );
    }
}

/// What the arithmetic of a look may lose.
const ARITHMETIC: f64 = 1e-9;

/// Looks that a program may take beyond the first three at each motion.
const WORK: u32 = 100_000;

/// What path and edge may be off.
fn limits(design: &Design) -> [f64; 2] {
    let tolerance = design.arc_tolerance + if design.style == Style::Full { ROUNDING } else { 0.0 };
    // An error over the development is one of the edge, longer by as much as the branch's curve is than the development.
    [tolerance, tolerance * (design.r / design.outline().radius).max(1.0) + SAME]
}

/// A look at a motion.
#[derive(Clone, Copy, Debug)]
struct Look {
    /// What part of the motion lies before it.
    part: f64,
    /// The angle at which the torch's path is nearest.
    phi: f64,
    /// How far that is.
    off: f64,
    /// How far the edge that is cut is from the header.
    edge: f64,
}

/// The way of a motion over the surface that is cut.
#[derive(Clone, Copy, Debug)]
enum Way {
    Straight([Vector2<f64>; 2]),
    Arc { centre: Vector2<f64>, angle: f64, sweep: f64, radii: [f64; 2] },
}

impl Way {
    fn at(&self, part: f64) -> Vector2<f64> {
        match *self {
            Self::Straight([from, to]) => from + (to - from) * part,
            Self::Arc { centre, angle, sweep, radii: [first, last] } => {
                let (sin, cos) = sin_cos(angle + sweep * part);
                centre + Vector2::new(cos, sin) * (first + (last - first) * part)
            }
        }
    }

    /// What its length is at most.
    fn length(&self) -> f64 {
        match *self {
            Self::Straight([from, to]) => (to - from).norm(),
            Self::Arc { sweep, radii: [first, last], .. } => hypot(sweep * first.max(last), last - first),
        }
    }

    /// The way between two parts of it, while a parameter runs from 0 to 1.
    fn jets(&self, [one, other]: [f64; 2]) -> [Jet; 2] {
        match *self {
            Self::Straight(_) => {
                let (from, to) = (self.at(one), self.at(other));
                [Jet::running(from.x, to.x, [0.0, 1.0]), Jet::running(from.y, to.y, [0.0, 1.0])]
            }
            Self::Arc { centre, angle, sweep, radii: [first, last] } => {
                let running = |from: f64, by: f64| Jet::running(from + by * one, from + by * other, [0.0, 1.0]);
                let (angle, radius) = (running(angle, sweep), running(first, last - first));
                [Jet::of(centre.x) + radius * angle.cos(), Jet::of(centre.y) + radius * angle.sin()]
            }
        }
    }

    /// How far the way leaves a circle.
    fn off_circle(&self, middle: Vector2<f64>, radius: f64) -> f64 {
        match *self {
            Self::Straight([from, to]) => {
                let chord = to - from;
                let part = ((middle - from).dot(&chord) / chord.norm_squared()).clamp(0.0, 1.0);
                let nearest = if part.is_nan() { from } else { self.at(part) };
                let far = [from, to].map(|end| (end - middle).norm() - radius);
                far[0].abs().max(far[1].abs()).max(radius - (nearest - middle).norm())
            }
            Self::Arc { centre, radii, .. } => {
                (centre - middle).norm() + radii.map(|own| (own - radius).abs()).into_iter().fold(0.0, f64::max)
            }
        }
    }
}

/// How far a point of the edge that is cut, on the development, is from the header.
fn off_header(outline: &Outline, edge: Vector2<f64>) -> f64 {
    outline.pair.off_header(&outline.pair.on_branch(edge.x / outline.radius, edge.y - outline.Z))
}

/// What the errors nowhere exceed between two looks.
fn over(outline: &Outline, way: &Way, inside: f64, one: &Look, other: &Look) -> [f64; 2] {
    let point = way.jets([one.part, other.part]);
    let phi = Jet::running(one.phi, other.phi, [0.0, 1.0]);
    let [torch, across] = outline.torch_jets(phi, inside);
    let bends = bow(&[point[0] - torch[0], point[1] - torch[1]], 1.0);
    let edge = [0, 1].map(|k| point[k] - across[k] * outline.beside);
    let place = outline.pair.on_branch_jets(edge[0] * (1.0 / outline.radius), edge[1] - Jet::of(outline.Z));
    let rises = bow(&[(place[1].square() + place[2].square()).sqrt()], 1.0);
    // However the curve runs, the torch comes nearer to it or leaves it by no more than it goes.
    let goes = 0.5 * way.length() * (other.part - one.part);
    let path = (one.off.max(other.off) + bends).min(f64::midpoint(one.off, other.off) + goes);
    let longer = if outline.beside > 0.0 { f64::INFINITY } else { (outline.pair.r / outline.radius).max(1.0) };
    let header = (one.edge.max(other.edge) + rises).min(f64::midpoint(one.edge, other.edge) + longer * goes);
    [path + ARITHMETIC, header + ARITHMETIC]
}

/// Reads the program of a branch back and judges it. Beside the verification: the deviation along the curve.
#[must_use]
pub fn verify(design: &Design, cut: Option<&Cut>, program: &Program) -> (Verification, Curve, Account) {
    let setting = Setting { part: design.style == Style::Annex, ..program.setting() };
    let mut text = program.read_back_with(setting);
    let (mut checks, curve, account) = judge(design, cut, program, &mut text);
    if design.mode == Mode::Rotary {
        checks.push(rollover::check(program, design.control.rotary.delivered));
    }
    let mut verification = Verification::default();
    verification.add(program, checks);
    (verification, curve, account)
}

/// Judges what a text gives.
pub fn judge(
    design: &Design,
    cut: Option<&Cut>,
    program: &Program,
    text: &mut Interpreter<'_>,
) -> (Vec<Check>, Curve, Account) {
    let (pierce, legs) = plan(design, cut);
    let mut watch = Watch {
        design,
        outline: design.outline(),
        agreed: 0,
        different: None,
        errors: Enclosed::new([1e-3 * design.arc_tolerance; 2], limits(design), WORK),
        speed: None,
        slowest: None,
        off_speed: None,
        rounded: None,
        untimed: false,
        curve: Curve::new(),
        length: 0.0,
    };
    let (mut account, mut before) = (Account::default(), Pose::default());
    let rapids = cut.map_or(1, |cut| approach(design, cut.pierce));
    let (mut rapid, mut done, mut fault) = (0, 0, None);
    for motion in &mut *text {
        let motion = match motion {
            Ok(motion) => motion,
            Err(found) => {
                fault = Some(found);
                break;
            }
        };
        if rapid > 0 || matches!(motion.kind, MotionKind::Rapid) {
            account.take(&motion, &before);
        }
        before = motion.machine;
        if matches!(motion.kind, MotionKind::Dwell(_)) {
            continue;
        }
        if rapid < rapids {
            rapid += 1;
            let to = axes(design.mode, &motion.to);
            let same = rapid < rapids || (0..2).all(|axis| (to[axis] - pierce[axis]).abs() <= SAME);
            if !same || !matches!(motion.kind, MotionKind::Rapid) {
                let what = Text::fixed("no va en rápido a la perforación", "it is no rapid move to the pierce");
                watch.different.get_or_insert((At::motion(&motion), what));
            }
            continue;
        }
        let planned = legs.get(done);
        watch.compare(&motion, planned);
        if let Some(planned) = planned {
            watch.look(&motion, planned.follows);
        }
        done += 1;
    }
    let mut checks = vec![reading(program, text, fault.as_deref())];
    if fault.is_none() {
        checks.extend(answers(design, program, &mut watch, legs.len()));
        let codes = (design.style == Style::Full).then_some([&design.torch_on[..], &design.torch_off[..]]);
        checks.push(torch(program, codes));
    }
    (checks, watch.curve, account)
}

fn answers(design: &Design, program: &Program, watch: &mut Watch<'_>, planned: usize) -> Vec<Check> {
    let agreement = as_planned(program, watch.agreed, planned, watch.different.take());
    let [tolerance, limit] = limits(design);
    let name = Text::fixed("Trayectoria contra la curva exacta", "Path against the exact curve");
    let path = row("path", name, program, watch.errors.at_most(0), tolerance).of_parameters(vec!["arc_tolerance", "N"]);
    let remedy = if design.mode == Mode::Flat { Text::fixed("un N mayor", "a greater N") } else { FAULT };
    let words = ["los arcos se apartan de la curva exacta", "the arcs leave the exact curve by"];
    let path = within(path, (&watch.errors, 0), tolerance, words, remedy);
    let name = Text::fixed("Borde cortado, sobre el tubo base", "Edge that is cut, on the header");
    let edge = row("edge", name, program, watch.errors.at_most(1), limit).at(watch.errors.at[1]);
    let words = ["el borde cortado queda fuera del tubo base por", "the edge that is cut is off the header by"];
    let edge = if path.verdict > Verdict::Note { edge } else { within(edge, (&watch.errors, 1), limit, words, FAULT) };
    let name = Text::fixed("Longitud del corte", "Length of the cut");
    let length = Check::passed("length", name, program, Text::same(mm(watch.length)), Text::same("")).informing();
    vec![agreement, path, edge, length, feed(design, program, watch), feed_word(program, watch.rounded)]
}

fn feed(design: &Design, program: &Program, watch: &Watch<'_>) -> Check {
    let name = Text::fixed("Velocidad de corte", "Cutting speed");
    let Some(F) = design.F.filter(|_| design.style == Style::Full) else {
        let none = Text::fixed("sin palabra F", "no F word");
        return Check::passed("feed", name, program, none, Text::same("")).informing();
    };
    let most = watch.speed.map_or(0.0, |(most, _)| most);
    let least = watch.slowest.unwrap_or(most);
    let show = |speed: f64| shown(speed, 1);
    let value = Text::same(format!("{} … {} mm/min", show(least), show(most)));
    let check = Check::passed("feed", name, program, value, Text::same(format!("{} mm/min", shown(F, 3))));
    let check = check.at(watch.speed.map(|(_, at)| at));
    let F = shown(F, 3);
    match watch.off_speed {
        None if !watch.untimed => check,
        None => check.found(
            Verdict::Stop,
            Text::fixed("hay un movimiento de corte sin avance", "there is a cutting motion without feed"),
            FAULT,
        ),
        Some((speed, at)) => {
            let speed = show(speed);
            check.at(Some(at)).found(
                Verdict::Stop,
                Text::new(
                    format!("la velocidad de corte es {speed} mm/min en la línea {}, y F es {F}", at.line),
                    format!("the cutting speed is {speed} mm/min at line {} where F is {F}", at.line),
                ),
                FAULT,
            )
        }
    }
}
