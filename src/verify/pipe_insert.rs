//! The verification of a branch's program: what the torch would do, held against plan, curve and both pipes.
//!
//! Every motion of the cut is looked at in many points. From each the nearest point of the exact torch path is sought,
//! which gives how far the torch leaves it; half a kerf back across the curve lies the edge that is cut, and that edge, put
//! on the branch's surface, must lie on the header's.

use std::f64::consts::TAU;

use nalgebra::Vector2;

use crate::gcode::dialect::FeedLaw;
use crate::gcode::feed_word::step;
use crate::gcode::interpreter::{Interpreter, Setting};
use crate::gcode::motion::{Kind, Motion};
use crate::gcode::program::{Program, Style};
use crate::geometry::pipe_pair::Side;
use crate::machine::axis::{Axis, Pose};
use crate::number::grid::Milli;
use crate::number::root::golden;
use crate::number::shown;
use crate::number::trig::{atan2, sin_cos};
use crate::pipe::insert::arcs::triples;
use crate::pipe::insert::cut::{Cut, Follows};
use crate::pipe::insert::design::{Design, Mode};
use crate::pipe::insert::outline::Outline;
use crate::pipe::insert::program::template_points;
use crate::text::Text;
use crate::verify::account::Account;
use crate::verify::check::{At, Check, FAULT, Verdict, mm};
use crate::verify::feed::{feed_word, timely};
use crate::verify::verification::{Verification, as_planned, reading, torch};

/// Points of a motion that are looked at.
const LOOKS: u16 = 64;
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

/// A greatest value and its place.
#[derive(Clone, Copy, Debug, Default)]
struct Most {
    value: f64,
    at: Option<At>,
}

impl Most {
    fn raise(&mut self, value: f64, at: At) {
        if value > self.value || self.at.is_none() {
            *self = Self { value, at: Some(at) };
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
    path: Most,
    header: Most,
    speed: Most,
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

/// The angle of a span at which a path is nearest to a point.
fn nearest(path: &dyn Fn(f64) -> Vector2<f64>, point: Vector2<f64>, span: [f64; 2]) -> f64 {
    // Sideways to a hundred thousandth of the span: the distance, which is square in it, far better.
    golden(span, 25, |phi| (path(phi) - point).norm_squared()).1
}

impl Watch<'_> {
    fn development(&self, [first, second]: [f64; 2]) -> Vector2<f64> {
        match self.design.mode {
            Mode::Flat => Vector2::new(first, second),
            Mode::Rotary => Vector2::new(first.to_radians() * self.outline.radius, second),
        }
    }

    /// The points of a motion over the surface that is cut.
    fn points(&self, motion: &Motion) -> Vec<Vector2<f64>> {
        let [from, to] = [&motion.from, &motion.to].map(|pose| axes(self.design.mode, pose));
        (0..=LOOKS)
            .map(|at| {
                let part = f64::from(at) / f64::from(LOOKS);
                let straight = [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * part);
                match motion.kind {
                    Kind::Arc(arc, _) => {
                        let centre = Vector2::from(arc.centre);
                        let start = Vector2::from(from) - centre;
                        let (sin, cos) = sin_cos(atan2(start.y, start.x) + arc.sweep * part);
                        // The radius runs over from that of the start to that of the end.
                        let radius = start.norm() + ((Vector2::from(to) - centre).norm() - start.norm()) * part;
                        centre + Vector2::new(cos, sin) * radius
                    }
                    _ => self.development(straight),
                }
            })
            .collect()
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
            Kind::Arc(arc, _) => Some((arc.turns < 0, arc.radius)),
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
        if alike && same && !matches!(motion.kind, Kind::Rapid) {
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
        let points = self.points(motion);
        let length = match motion.kind {
            Kind::Arc(arc, _) => arc.length(0.0),
            _ => points.first().zip(points.last()).map_or(0.0, |(first, last)| (last - first).norm()),
        };
        self.length += length;
        match motion.seconds {
            Some(seconds) if seconds > 0.0 => {
                let speed = length * 60.0 / seconds;
                self.speed.raise(speed, At::motion(motion));
                self.slowest = Some(self.slowest.map_or(speed, |least: f64| least.min(speed)));
                let word = match motion.kind {
                    Kind::Feed(feed) | Kind::Arc(_, feed) => feed.value,
                    Kind::Rapid | Kind::Thread(_) | Kind::Dwell(_) => 0.0,
                };
                let F = self.design.F.unwrap_or(speed);
                let planned = length * 60.0 / F;
                let good = match self.design.mode {
                    // F is the speed over the sheet itself.
                    Mode::Flat => (F - step(FeedLaw::Resultant, F)..=F).contains(&word),
                    Mode::Rotary => timely(self.design.dialect.feed, motion, word, planned),
                };
                if !good || seconds < planned * (1.0 - 1e-6) {
                    self.off_speed.get_or_insert((speed, At::motion(motion)));
                }
                let slower = seconds / planned - 1.0;
                if self.rounded.is_none_or(|(most, _)| slower > most) {
                    self.rounded = Some((slower, At::motion(motion)));
                }
            }
            _ => self.untimed = true,
        }
        let outline = self.outline;
        let at = At::motion(motion);
        match follows {
            Follows::Curve([from, to]) => {
                let margin = (to - from) * 0.5 + 1e-9;
                for (i, point) in points.iter().enumerate() {
                    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
                    let part = i as f64 / f64::from(LOOKS);
                    let near = from + (to - from) * part;
                    let span = [(near - margin).max(from), (near + margin).min(to)];
                    let side = if near * 2.0 < from + to { Side::After } else { Side::Before };
                    let phi = nearest(&|phi| outline.torch(phi, side), *point, span);
                    let off = point - outline.torch(phi, side);
                    let across = outline.across(phi, side);
                    self.path.raise(off.norm(), at);
                    if i.is_multiple_of(16) {
                        self.curve.push([phi.to_degrees(), off.dot(&across)]);
                    }
                    let edge = point - across * outline.beside;
                    self.edge(edge, at);
                }
            }
            Follows::Corner(phi) => {
                let corner = outline.curve(phi);
                for point in &points {
                    self.path.raise(((point - corner).norm() - outline.beside).abs(), at);
                }
            }
            Follows::WayIn | Follows::Beyond => {}
        }
    }

    /// How far a point of the edge that is cut is from the header.
    fn edge(&mut self, edge: Vector2<f64>, at: At) {
        let pair = self.outline.pair;
        let point = pair.on_branch(edge.x / self.outline.radius, edge.y - self.outline.Z);
        self.header.raise(pair.off_header(&point).abs(), at);
    }
}

/// Reads the program of a branch back and judges it. Beside the verification: the deviation along the curve.
#[must_use]
pub fn verify(design: &Design, cut: Option<&Cut>, program: &Program) -> (Verification, Curve, Account) {
    let setting = Setting { part: design.style == Style::Annex, ..program.setting() };
    let mut text = program.read_back_with(setting);
    let (checks, curve, account) = judge(design, cut, program, &mut text);
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
        path: Most::default(),
        header: Most::default(),
        speed: Most::default(),
        slowest: None,
        off_speed: None,
        rounded: None,
        untimed: false,
        curve: Curve::new(),
        length: 0.0,
    };
    let (mut account, mut before) = (Account::default(), Pose::default());
    let (mut pierced, mut done, mut fault) = (false, 0, None);
    for motion in &mut *text {
        let motion = match motion {
            Ok(motion) => motion,
            Err(found) => {
                fault = Some(found);
                break;
            }
        };
        if pierced || matches!(motion.kind, Kind::Rapid) {
            account.take(&motion, &before);
        }
        before = motion.machine;
        if matches!(motion.kind, Kind::Dwell(_)) {
            continue;
        }
        if !pierced {
            pierced = true;
            let to = axes(design.mode, &motion.to);
            let same = (0..2).all(|axis| (to[axis] - pierce[axis]).abs() <= SAME);
            if !same || !matches!(motion.kind, Kind::Rapid) {
                let what = Text::fixed("no va en rápido a la perforación", "it is no rapid move to the pierce");
                watch.different = Some((At::motion(&motion), what));
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
    let tolerance = design.arc_tolerance + if design.style == Style::Full { ROUNDING } else { 0.0 };
    let name = Text::fixed("Trayectoria contra la curva exacta", "Path against the exact curve");
    let path = Check::passed("path", name, program, Text::same(mm(watch.path.value)), Text::same(mm(tolerance)));
    let path = path.at(watch.path.at);
    let path = if watch.path.value <= tolerance {
        path
    } else {
        let (off, limit) = (mm(watch.path.value), mm(tolerance));
        let verdict = if design.mode == Mode::Flat { Verdict::Caution } else { Verdict::Stop };
        path.of_parameters(vec!["arc_tolerance", "N"]).found(
            verdict,
            Text::new(
                format!("los arcos se apartan {off} de la curva exacta; la tolerancia es {limit}"),
                format!("the arcs leave the exact curve by {off}; the tolerance is {limit}"),
            ),
            if design.mode == Mode::Flat { Text::fixed("un N mayor", "a greater N") } else { FAULT },
        )
    };
    let name = Text::fixed("Borde cortado, sobre el tubo base", "Edge that is cut, on the header");
    // Down the branch a deviation of the path is at most a deviation of the edge from the header.
    let limit = tolerance + SAME;
    let edge = Check::passed("edge", name, program, Text::same(mm(watch.header.value)), Text::same(mm(limit)));
    let edge = edge.at(watch.header.at);
    let edge = if watch.header.value <= limit || path.verdict > Verdict::Note {
        edge
    } else {
        edge.found(
            Verdict::Stop,
            Text::new(
                format!("el borde cortado queda a {} del tubo base", mm(watch.header.value)),
                format!("the edge that is cut is {} off the header", mm(watch.header.value)),
            ),
            FAULT,
        )
    };
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
    let (most, least) = (watch.speed.value, watch.slowest.unwrap_or(watch.speed.value));
    let show = |speed: f64| shown(speed, 1);
    let value = Text::same(format!("{} … {} mm/min", show(least), show(most)));
    let check = Check::passed("feed", name, program, value, Text::same(format!("{} mm/min", shown(F, 3))));
    let check = check.at(watch.speed.at);
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
