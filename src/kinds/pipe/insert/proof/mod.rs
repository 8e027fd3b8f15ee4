//! The verification of a branch's program: what the torch would do, compared with plan, curve and both pipes.
//!
//! Every motion of the cut is looked at in some points. From each the nearest point of the exact torch path is sought,
//! which gives how far the torch leaves it; half a kerf back across the curve lies the edge that is cut, and that edge, put
//! on the branch's surface, must lie on the header's. Between two looks the error e, taken between points that run evenly from
//! look to look, is nowhere greater than at them by more than an eighth of its greatest second derivative (as jets enclose it),
//! nor, where the curve has a corner, than the way between them allows. Motions are parted until that decides.
//!
//! From that edge the cut goes straight to the branch's axis through the wall. The line of the cut face at each place is held
//! against the header in the same way: no point of it may be inside the header, where the end is cut along the envelope, and at
//! its nearest it is on the header; of a cut along one edge the depth and the gaps are told.

mod greater_n;
pub mod rules;
mod speed;

use std::f64::consts::TAU;

use nalgebra::Vector2;

use crate::finding::Grade;
use crate::gcode::interpreter::Setting;
use crate::gcode::motion::{Motion, MotionKind};
use crate::gcode::program::{Program, Style};
use crate::geometry::pipe_pair::Side;
use crate::geometry::pipe_wall::{Seat, WallLine};
use crate::kinds::pipe::insert::arcs::triples;
use crate::kinds::pipe::insert::bounds::beyond;
use crate::kinds::pipe::insert::cut::{Cut, Follows};
use crate::kinds::pipe::insert::design::{Contact, Design, Mode, ROUNDING};
use crate::kinds::pipe::insert::outline::Outline;
use crate::kinds::pipe::insert::parameters::{ARC_TOLERANCE, N};
use crate::kinds::pipe::insert::program::{approach, template_points};
use crate::kinds::pipe::insert::proof::greater_n::enough;
use crate::kinds::pipe::insert::proof::speed::{CutSpeed, fed};
use crate::limits::CUT_LOOKS;
use crate::machine::axis::{Axis, Pose};
use crate::number::grid::Milli;
use crate::number::interval::Interval;
use crate::number::jet::{Jet, at_most, bow};
use crate::number::root::golden;
use crate::number::trig::{atan2, hypot, sin_cos};
use crate::proof::agreement::Agreement;
use crate::proof::check::{At, Check, Extreme, Question, mm, up};
use crate::proof::due::Due;
use crate::proof::enclosed::{Enclosed, Remedy, Tolerance, bound};
use crate::proof::rollover::{self, Rollover};
use crate::proof::step::{Interpolation, Judge, Plan, Planned, Stage, Step, Time};
use crate::proof::torch::Torch;
use crate::text::{Text, t};

/// What the decimals of the published program leave of a length, mm.
const SAME: f64 = 1e-6;

/// A planned move of the cut: its end on the two axes that the program moves, how it runs there, and what it follows.
#[derive(Clone, Copy, Debug)]
pub struct Move {
    to: [f64; 2],
    interpolation: Interpolation,
    follows: Follows,
}

/// The cut as it is planned: where it pierces, and the moves from there on.
#[derive(Clone, Debug)]
pub struct Moves {
    pierce: [f64; 2],
    moves: Vec<Move>,
    /// How many rapid moves there are to the pierce.
    approach: usize,
}

impl Moves {
    /// Those of a cut or, where there is none, of the published program.
    #[must_use]
    pub fn new(design: &Design, cut: Option<&Cut>) -> Self {
        let value = |to: [Milli; 2]| to.map(Milli::value);
        let interpolation = |bend: Option<(bool, f64)>| {
            bend.map_or(Interpolation::Straight, |(clockwise, radius)| Interpolation::Arc { clockwise, radius })
        };
        if let Some(cut) = cut {
            let moves = cut.legs.iter().map(|leg| Move {
                to: value(leg.to),
                interpolation: interpolation(leg.bend.map(|bend| (bend.clockwise, bend.radius.value()))),
                follows: leg.follows,
            });
            return Self { pierce: value(cut.pierce), moves: moves.collect(), approach: approach(design, cut.pierce) };
        }
        let points = template_points(design);
        let turn = |j: usize| {
            #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
            let j = j as f64;
            TAU * j / f64::from(design.N)
        };
        let mut from = 0;
        let moves = triples(&points, design.arc_tolerance).into_iter().map(|triple| {
            let follows = Follows::Curve([turn(from), turn(triple.j)]);
            from = triple.j;
            let interpolation = interpolation(triple.circle.map(|circle| (!circle.left, circle.radius)));
            Move { to: triple.to.into(), interpolation, follows }
        });
        let moves = moves.collect();
        Self { pierce: points.first().map_or([0.0; 2], |first| (*first).into()), moves, approach: 1 }
    }

    /// The moves from the pierce on, mm, or degrees of A and mm of X where the pipe turns.
    #[must_use]
    pub fn plan(&self, mode: Mode) -> Plan<'_> {
        let pose = move |to: [f64; 2]| {
            let mut pose = Pose::default();
            moved(mode).iter().zip(to).for_each(|(axis, to)| pose.set(*axis, to));
            pose
        };
        let before = std::iter::once(self.pierce).chain(self.moves.iter().map(|one| one.to));
        let moves = before.zip(&self.moves).enumerate().map(move |(leg, (from, one))| Planned {
            from: pose(from),
            to: pose(one.to),
            interpolation: one.interpolation,
            time: Time::Free,
            line: None,
            leg,
            path: None,
        });
        Plan::from_the_pierce(moves)
    }

    /// What a motion follows, where it answers to one of these.
    fn follows(&self, step: &Step<'_>) -> Option<Follows> {
        let Stage::Planned(planned) = &step.stage else { return None };
        self.moves.get(planned.leg).map(|one| one.follows)
    }
}

/// The deviation along the curve, to be drawn: φ in degrees and mm, positive into the waste.
pub type Curve = Vec<[f64; 2]>;

/// The axes that the program moves.
const fn moved(mode: Mode) -> &'static [Axis] {
    match mode {
        Mode::Flat => &[Axis::X, Axis::Y],
        Mode::Rotary => &[Axis::A, Axis::X],
    }
}

/// The two coordinates of a pose that the program moves.
fn axes(mode: Mode, pose: &Pose) -> [f64; 2] {
    match mode {
        Mode::Flat => [pose.get(Axis::X), pose.get(Axis::Y)],
        Mode::Rotary => [pose.get(Axis::A), pose.get(Axis::X)],
    }
}

#[derive(Clone, Copy)]
struct Surface<'a> {
    design: &'a Design,
    outline: Outline,
}

impl Surface<'_> {
    fn development(&self, [first, second]: [f64; 2]) -> Vector2<f64> {
        match self.design.mode {
            Mode::Flat => Vector2::new(first, second),
            Mode::Rotary => Vector2::new(first.to_radians() * self.outline.radius, second),
        }
    }

    /// The way of a motion over the surface that is cut.
    fn way(&self, motion: &Motion) -> SurfacePath {
        let [from, to] = [&motion.from, &motion.to].map(|pose| axes(self.design.mode, pose));
        match motion.kind {
            MotionKind::Arc(arc, _) => {
                let centre = Vector2::from(arc.centre);
                let [start, end] = [from, to].map(|place| Vector2::from(place) - centre);
                let angle = atan2(start.y, start.x);
                // The radius runs over from that of the start to that of the end.
                SurfacePath::Arc { centre, angle, sweep: arc.sweep, radii: [start.norm(), end.norm()] }
            }
            _ => SurfacePath::Straight([self.development(from), self.development(to)]),
        }
    }

    /// The length of a motion over it, and its way.
    fn run(&self, motion: &Motion) -> (f64, SurfacePath) {
        let way = self.way(motion);
        (if let MotionKind::Arc(arc, _) = motion.kind { arc.length(0.0) } else { way.length() }, way)
    }
}

/// Holds the torch's path against the curve, and the edge that is cut against the header.
struct PathOnCurve<'a> {
    surface: Surface<'a>,
    moves: &'a Moves,
    /// How far the torch leaves its path, and the edge that is cut the header.
    errors: Enclosed<2>,
    /// How deep the wall is inside the header, and how far the edges of bore and outside are from it.
    wall: Enclosed<3>,
    curve: &'a mut Curve,
}

impl Judge for PathOnCurve<'_> {
    fn see(&mut self, step: &Step<'_>) {
        let Some(follows) = self.moves.follows(step) else { return };
        let (at, way) = (At::motion(&step.motion), self.surface.way(&step.motion));
        self.follow(&way, follows, at);
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        let design = self.surface.design;
        let [tolerance, limit] = limits(design);
        let asked = |key, name, k, limit| {
            let [value, limit] = bound(self.errors.at_most(k), limit);
            Question::new(key, name, program).showing(value, limit)
        };
        let name = t("Trayectoria contra la curva exacta", "Path against the exact curve");
        let path = asked("path", name, 0, tolerance).of_parameters([ARC_TOLERANCE.key(), N.key()]);
        let off = !self.keeps();
        let remedy = match design.mode {
            Mode::Flat => Remedy::GreaterN {
                enough: off.then(|| enough(design)).flatten(),
                // What was published is told, and stays as it was published.
                grade: if design.style == Style::Annex { Grade::Caution } else { Grade::Stop },
            },
            Mode::Rotary => Remedy::Fault,
        };
        let words = t("los arcos se apartan de la curva exacta", "the arcs leave the exact curve by");
        let path = self.errors.within(path, 0, &of_arcs(design, tolerance), words, remedy);
        let name = t("Borde cortado, sobre el tubo base", "Cut edge, on the header");
        let edge = asked("edge", name, 1, limit);
        let words = t("el borde cortado queda fuera del tubo base por", "the cut edge is off the header by");
        // Of a path that leaves the curve the edge does too: that is said once, and its edge is not passed.
        let edge = if path.grade() > Some(Grade::Note) {
            self.errors.put(edge, 1).informs()
        } else {
            self.errors.within(edge, 1, &of_arcs(design, limit), words, Remedy::Fault)
        };
        let [wall, gap] = self.seat(program, limit, remedy);
        vec![path, edge, wall, gap]
    }
}

impl<'a> PathOnCurve<'a> {
    /// Of no motion yet.
    fn new(design: &'a Design, moves: &'a Moves, curve: &'a mut Curve) -> Self {
        let surface = Surface { design, outline: design.outline() };
        let errors = Enclosed::new([1e-3 * design.arc_tolerance; 2], limits(design), CUT_LOOKS);
        let limit = match design.contact {
            Contact::Inside | Contact::Outside => f64::INFINITY,
            Contact::Envelope => limits(design)[1],
        };
        let wall =
            Enclosed::new([1e-3 * design.arc_tolerance, 1e-3, 1e-3], [limit, f64::INFINITY, f64::INFINITY], CUT_LOOKS);
        Self { surface, moves, errors, wall, curve }
    }

    /// True where the path keeps to its tolerance, and the wall out of the header where it is cut for that.
    fn keeps(&self) -> bool {
        let [tolerance, limit] = limits(self.surface.design);
        let enveloped = self.surface.design.contact == Contact::Envelope;
        self.errors.at_most(0) <= tolerance && (!enveloped || self.wall.at_most(0) <= limit)
    }

    /// How the wall as it is cut stands to the header.
    fn seat(&self, program: &Program, limit: f64, remedy: Remedy) -> [Check; 2] {
        let design = self.surface.design;
        let name = t("Pared dentro del tubo base", "Wall inside the header");
        let [value, limited] = bound(self.wall.at_most(0).max(0.0), limit);
        let asked = |key, name, value, limit| Question::new(key, name, program).showing(value, limit);
        let wall = match design.contact {
            Contact::Envelope => {
                let words = t("la pared queda dentro del tubo base", "the wall is inside the header by");
                let asked = asked("wall", name, value, limited).of_parameters([ARC_TOLERANCE.key(), N.key()]);
                self.wall.within(asked, 0, &of_arcs(design, limit), words, remedy)
            }
            Contact::Inside | Contact::Outside => {
                self.wall.put(asked("wall", name, value, Text::same("")), 0).informs()
            }
        };
        let told = |gap: f64| mm(up(gap.max(0.0)));
        let (inner, outer) = (told(self.wall.at_most(1).max(0.0) + design.cut_back()), told(self.wall.at_most(2)));
        let value =
            Text::new(format!("interior ≤ {inner}, exterior ≤ {outer}"), format!("inner ≤ {inner}, outer ≤ {outer}"));
        let name = t("Separación de los bordes al tubo base", "Gap of the edges to the header");
        [wall, self.wall.put(asked("gap", name, value, Text::same("")), 1).informs()]
    }

    /// Holds a motion against what it follows.
    fn follow(&mut self, way: &SurfacePath, follows: Follows, at: At) {
        let outline = self.surface.outline;
        match follows {
            Follows::Curve(leg) => self.look_along(way, leg, at),
            Follows::Corner(phi) => {
                let off = way.off_circle(outline.curve(phi), outline.beside);
                self.errors.take(at, &[off], |off| [*off, 0.0], |one, other| [one.max(*other), 0.0], |one, _| *one);
            }
            Follows::WayIn | Follows::Beyond => {}
        }
    }

    /// Holds a motion against the curve between two angles.
    fn look_along(&mut self, way: &SurfacePath, leg: [f64; 2], at: At) {
        let outline = self.surface.outline;
        let [from, to] = leg;
        let inside = f64::midpoint(from, to);
        let side = |phi: f64| if phi < inside { Side::After } else { Side::Before };
        let curve = &mut *self.curve;
        let look = |part: f64, span: [f64; 2], steps: u32| {
            let point = way.at(part);
            let near = side(f64::midpoint(span[0], span[1]));
            // Sideways to a small part of the span: the distance, which is square in it, far better.
            let phi = golden(span, steps, |phi| (outline.torch(phi, near) - point).norm_squared()).1;
            let across = outline.across(phi, near);
            let (off, edge) = (point - outline.torch(phi, near), point - across * outline.beside);
            let place = [edge.x / outline.radius, outline.s(edge.y)];
            let line = outline.wall.line(place[0], place[1]);
            let on_header = match outline.seat {
                Seat::Edge(pair) => pair.off_header(&pair.on_branch(place[0], edge.y - outline.Z)),
                Seat::Envelope(_) => line.least,
            };
            EdgeSample { part, phi, off: off.norm(), aside: off.dot(&across), edge: on_header.abs(), place, line }
        };
        let margin = (to - from) * 0.5 + 1e-9;
        let looked = |part: f64| {
            let near = from + (to - from) * part;
            look(part, [(near - margin).max(from), (near + margin).min(to)], 25)
        };
        let first = [0.0, 0.5, 1.0].map(looked);
        let between = |one: &EdgeSample, other: &EdgeSample| {
            let (low, high) = (one.phi.min(other.phi), one.phi.max(other.phi));
            let wider = 0.25 * (high - low) + 1e-9;
            look(f64::midpoint(one.part, other.part), [(low - wider).max(from), (high + wider).min(to)], 20)
        };
        let mut drawn = |look: EdgeSample| {
            curve.push([look.phi.to_degrees(), look.aside]);
            look
        };
        // The bound stops looking where it knows enough, which may be where an arc meets its points: the figure shows what
        // lies between.
        for part in [0.125, 0.25, 0.375, 0.625, 0.75, 0.875] {
            drawn(looked(part));
        }
        self.errors.take(
            at,
            &first.map(&mut drawn),
            |look| [look.off, look.edge],
            |one, other| over(&outline, way, inside, one, other),
            |one, other| drawn(between(one, other)),
        );
        self.wall.take(
            at,
            &first,
            |look| [-look.line.least, look.line.ends[0], look.line.ends[1]],
            |one, other| over_wall(&outline, way, inside, one, other),
            between,
        );
    }
}

/// What the arithmetic of a look may lose.
const ARITHMETIC: f64 = 1e-9;

/// What the limit of a path, or of an edge, is made of.
fn of_arcs(design: &Design, limit: f64) -> Tolerance {
    let rounding =
        t("por el redondeo de extremos y radios a 0.001 mm", "for the rounding of ends and radii to 0.001 mm");
    let longer = t(
        "por el redondeo a 0.001 mm y porque la curva es más larga que el desarrollo",
        "for the rounding to 0.001 mm and because the curve is longer than the development",
    );
    let rest = if limit - limits(design)[0] < 5e-5 { rounding } else { longer };
    Tolerance::of_arcs(design.arc_tolerance, limit, &rest)
}

/// What path and edge may be off.
fn limits(design: &Design) -> [f64; 2] {
    let tolerance = design.arc_tolerance + if design.style == Style::Full { ROUNDING } else { 0.0 };
    let r = match design.contact {
        Contact::Inside | Contact::Outside => design.r,
        Contact::Envelope => design.wall().ends()[1],
    };
    // An error over the development is one of the edge, longer by as much as the branch's curve is than the development.
    [tolerance, tolerance * (r / design.outline().radius).max(1.0) + SAME]
}

#[derive(Clone, Copy, Debug)]
struct EdgeSample {
    /// What part of the motion lies before it.
    part: f64,
    /// The angle at which the torch's path is nearest.
    phi: f64,
    /// How far that is.
    off: f64,
    /// The same across the path, positive into the waste.
    aside: f64,
    /// How far the edge that is cut is from the header.
    edge: f64,
    /// Its angle round the branch, and how far along the axis it is.
    place: [f64; 2],
    /// The line of the cut face from there through the wall.
    line: WallLine,
}

/// The path of a motion over the surface that is cut.
#[derive(Clone, Copy, Debug)]
enum SurfacePath {
    Straight([Vector2<f64>; 2]),
    Arc { centre: Vector2<f64>, angle: f64, sweep: f64, radii: [f64; 2] },
}

impl SurfacePath {
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

/// The edge that is cut between two looks, on the development, and by how much the torch's path bends from its own.
fn edge_jets(
    outline: &Outline,
    way: &SurfacePath,
    inside: f64,
    one: &EdgeSample,
    other: &EdgeSample,
) -> ([Jet; 2], f64) {
    let point = way.jets([one.part, other.part]);
    let phi = Jet::running(one.phi, other.phi, [0.0, 1.0]);
    let [torch, across] = outline.torch_jets(phi, inside);
    let bends = bow(&[point[0] - torch[0], point[1] - torch[1]], 1.0);
    ([0, 1].map(|k| point[k] - across[k] * outline.beside), bends)
}

/// Its angle round the branch, and how far along the axis it is.
fn place_jets(outline: &Outline, edge: [Jet; 2]) -> [Jet; 2] {
    [edge[0] * (1.0 / outline.radius), Jet::of(outline.seat.level() + outline.Z) - edge[1]]
}

/// What the wall's depth inside the header and its gaps nowhere exceed between two looks.
fn over_wall(outline: &Outline, way: &SurfacePath, inside: f64, one: &EdgeSample, other: &EdgeSample) -> [f64; 3] {
    let [phi, s] = place_jets(outline, edge_jets(outline, way, inside, one, other).0);
    let wall = &outline.wall;
    beyond(wall, [&one.line, &other.line], phi, s, 1.0).map(|most| most + ARITHMETIC)
}

/// What the distance of the cut face's nearest point from the header nowhere exceeds between two looks, inside or outside.
fn over_touch(outline: &Outline, edge: [Jet; 2], one: &EdgeSample, other: &EdgeSample) -> f64 {
    let ([phi, s], wall) = (place_jets(outline, edge), &outline.wall);
    let [deep, ..] = beyond(wall, [&one.line, &other.line], phi, s, 1.0);
    // Nearer than any one line through the wall it is everywhere.
    let rho = f64::midpoint(one.line.rho, other.line.rho);
    let [here, there] = [one, other].map(|look| wall.square(look.place[0], look.place[1], rho));
    let jet = wall.square_jet(phi, s, Interval::of(rho));
    deep.max(at_most(here, there, jet, 1.0).sqrt() - wall.R())
}

/// What the errors nowhere exceed between two looks.
fn over(outline: &Outline, way: &SurfacePath, inside: f64, one: &EdgeSample, other: &EdgeSample) -> [f64; 2] {
    let (edge, bends) = edge_jets(outline, way, inside, one, other);
    let (r, header) = match outline.seat {
        Seat::Edge(pair) => {
            let place = pair.on_branch_jets(edge[0] * (1.0 / outline.radius), edge[1] - Jet::of(outline.Z));
            (pair.r, one.edge.max(other.edge) + bow(&[(place[1].square() + place[2].square()).sqrt()], 1.0))
        }
        Seat::Envelope(wall) => (wall.ends()[1], over_touch(outline, edge, one, other)),
    };
    // However the curve runs, the torch comes nearer to it or leaves it by no more than it goes.
    let goes = 0.5 * way.length() * (other.part - one.part);
    let path = (one.off.max(other.off) + bends).min(f64::midpoint(one.off, other.off) + goes);
    let longer = if outline.beside > 0.0 { f64::INFINITY } else { (r / outline.radius).max(1.0) };
    let header = header.min(f64::midpoint(one.edge, other.edge) + longer * goes);
    [path + ARITHMETIC, header + ARITHMETIC]
}

/// What must be answered for the program of a design; what nobody answers is a stop.
#[must_use]
pub fn due(design: &Design) -> Vec<Due> {
    let no_feed = fed(design).is_none();
    let mut due = vec![
        Due::judged("agreement"),
        Due::judged("path"),
        // Where the path is found to leave the curve its edge is told, not judged once more.
        Due::told("edge"),
        Due::told_where(design.contact != Contact::Envelope, "wall"),
        Due::told("gap"),
        Due::told("length"),
        Due::told_where(no_feed, "feed"),
        Due::told_where(no_feed, "feed-word"),
        // The published program is a part of another, which turns the torch on and off.
        Due::told_where(design.style == Style::Annex, "torch"),
    ];
    if design.mode == Mode::Rotary {
        due.push(rollover::due(design.post.control.rotary.delivered));
    }
    due
}

/// What the program is read with: as published it is a part of another.
#[must_use]
pub fn setting(design: &Design, program: &Program) -> Setting {
    Setting { part: design.style == Style::Annex, ..program.setting() }
}

/// The judges of the program. `curve` takes the deviation along the curve.
#[must_use]
pub fn judges<'a>(design: &'a Design, moves: &'a Moves, curve: &'a mut Curve) -> Vec<Box<dyn Judge + 'a>> {
    let path = PathOnCurve::new(design, moves, curve);
    let surface = path.surface;
    let codes = (design.style == Style::Full).then_some([&design.torch_on[..], &design.torch_off[..]]);
    let agreement = Agreement::of_the_torch(moved(design.mode), moves.moves.len(), 0).approached_by(moves.approach);
    let mut judges: Vec<Box<dyn Judge + 'a>> = vec![
        Box::new(agreement),
        Box::new(path),
        Box::new(CutSpeed {
            surface,
            moves,
            fastest: Extreme::nothing(),
            slowest: None,
            off: None,
            rounded: Extreme::nothing(),
            untimed: None,
            length: 0.0,
            seen: 0,
        }),
        Box::new(Torch(codes)),
    ];
    if design.mode == Mode::Rotary {
        judges.push(Box::new(Rollover::new(design.post.control.rotary.delivered)));
    }
    judges
}
