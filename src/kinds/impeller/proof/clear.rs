//! What the tool of a clear cut does to the part that was designed: its own faces, those of the neighbours and the
//! splitters, and the floor.
//!
//! A pass is judged where it is run first. The other channels go through the same positions with C turned on, which the
//! agreement with the plan shows, by multiples of a blade's turn that are rounded to 0.001°: what that moves at the rim is
//! counted in.
//!
//! All faces of all blades count, those that the pass is meant to cut among them: the tool may enter them by no more than
//! the tolerance ε and 0.001 mm. Bounds, no samples ([`clearance`](crate::kinds::impeller::clearance),
//! [`floor_depth`](crate::kinds::impeller::floor_depth)).
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::{PI, TAU};

use crate::finding::{Place, Raise, Size};
use crate::gcode::program::{Program, Role};
use crate::kinds::impeller::clear::asked::Asked;
use crate::kinds::impeller::clear::cut::Which;
use crate::kinds::impeller::clear::plan::Plan;
use crate::kinds::impeller::clear::programs::BACK;
use crate::kinds::impeller::clearance::{Bounds, Stand, Until, WORK, Walls};
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::floor_depth::within;
use crate::kinds::impeller::part::Part;
use crate::kinds::impeller::proof::rules::{
    ClearCutsBlade, ClearCutsSplitter, ClearMayCut, ClearPassesDiffer, FloorUnder,
};
use crate::kinds::impeller::sweep::Sweep;
use crate::machine::axis::{Axis, Pose, Position};
use crate::number::grid::Milli;
use crate::proof::check::{At, Check, Question, bounded, mm, up};
use crate::proof::step::{Judge, Stage, Step};
use crate::text::{Text, t};

/// What is left to ε: the block's error is looked at in eight places, and the nose is not the faces' own.
const OVER: f64 = 0.001;
/// A whole turn, thousandths of a degree.
const WHOLE: i32 = 360_000;
/// How close the bounds are brought to each other, mm.
const CLOSE: f64 = 0.0005;

/// A pass as it is run.
#[derive(Clone, Debug)]
struct Way {
    stands: Vec<Stand>,
    positions: Vec<Position>,
    at: Vec<At>,
}

/// Watches the passes of one program.
#[derive(Debug)]
pub struct ClearCutting<'a> {
    design: &'a Design,
    asked: &'a Asked,
    which: Which,
    /// Where splitters begin.
    splitter: Option<f64>,
    /// How many passes each channel should have.
    due: usize,
    channel: Option<Milli>,
    begun: bool,
    made: usize,
    ways: Vec<Way>,
}

impl<'a> ClearCutting<'a> {
    /// The judge of the program of one tool.
    #[must_use]
    pub fn new(design: &'a Design, asked: &'a Asked, plan: &Plan, which: Which) -> Self {
        let due = plan.of(which).count() * plan.channels as usize;
        let splitter = plan.told.splitter_from;
        Self { design, asked, which, splitter, due, channel: None, begun: false, made: 0, ways: Vec::new() }
    }

    fn limit(&self) -> f64 {
        self.asked.tolerance + OVER
    }

    /// By how much a rounded turn of C moves the rim.
    fn turned(&self) -> f64 {
        0.0005_f64.to_radians() * self.design.torus.R
    }

    /// The least clearance of all ways to some walls, and where.
    fn least(&self, walls: &Walls) -> Option<(Bounds, At)> {
        let mut least: Option<(Bounds, At)> = None;
        for way in &self.ways {
            let seen = least.map_or(f64::INFINITY, |(bounds, _)| bounds.upper);
            // What is clear by more than was seen need not be known closer.
            let mut bounds = walls.clearance(&way.stands, Until::Decided(seen.max(self.asked.cut.s / 2.0)), WORK);
            if bounds.lower < seen.max(self.asked.cut.s / 2.0) {
                bounds = walls.clearance(&way.stands, Until::Within(CLOSE), WORK);
            }
            let Some(place) = bounds.place else { continue };
            let at = way.at.get(motion(place.along)).copied().unwrap_or(At::line(0));
            least = Some(match least {
                Some((known, place)) if known.lower <= bounds.lower => {
                    (Bounds { upper: known.upper.min(bounds.upper), ..known }, place)
                }
                Some((known, _)) => (Bounds { upper: known.upper.min(bounds.upper), ..bounds }, at),
                None => (bounds, at),
            });
        }
        least.map(|(bounds, at)| {
            let turned = self.turned();
            (Bounds { lower: bounds.lower - turned, upper: bounds.upper + turned, ..bounds }, at)
        })
    }

    fn walls(&self, offset: f64, from: f64, nose: bool) -> Walls {
        let design = self.design;
        let pitch = TAU / f64::from(design.N);
        let turns: Vec<f64> = (0..design.N).map(|k| pitch * f64::from(k) + offset).collect();
        let radius = design.mill(self.which).d / 2.0;
        let make = if nose { Walls::noses } else { Walls::new };
        make(Part::new(design), design.machine, radius, turns, from)
    }

    /// The half round and the faces of a splitter are not the same surface where they meet.
    fn seam(&self, v_s: f64) -> f64 {
        let circle = Part::new(self.design).circle;
        // τ = k/(R·ρ): how fast the rulings turn about the mean line.
        let tau = circle.k / (circle.torus.R * circle.torus.rho(v_s));
        let turned = self.design.a_p * tau;
        self.design.e / 2.0 * turned * turned / 2.0
    }
}

/// The number of the motion at a position along a way.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a position along a way")]
fn motion(along: f64) -> usize {
    along.floor() as usize
}

/// The position that a motion ends at.
fn position(pose: &Pose) -> Position {
    let milli = |axis: Axis| Milli::round(pose.get(axis)).unwrap_or(Milli::ZERO);
    [Axis::X, Axis::Y, Axis::Z, Axis::B, Axis::C]
        .into_iter()
        .fold(Position::default(), |position, axis| position.with(axis, milli(axis)))
}

impl Judge for ClearCutting<'_> {
    fn see(&mut self, step: &Step<'_>) {
        let Stage::Planned(planned) = &step.stage else { return };
        let Some((path, number)) = planned.path else { return };
        let Role::Cut(key) = path.role else {
            self.begun = false;
            return;
        };
        if number == 0 && key != BACK {
            self.made += 1;
        }
        // Whole turns of C are no other channel.
        let channel = Milli::new(path.turn.thousandths().rem_euclid(WHOLE));
        if *self.channel.get_or_insert(channel) != channel {
            return;
        }
        let motion = &step.motion;
        let own = |pose: &Pose| {
            let mut own = *pose;
            own.set(Axis::C, pose.get(Axis::C) - path.turn.value());
            own
        };
        if !self.begun {
            let from = own(&motion.from);
            self.ways.push(Way { stands: vec![Stand::from(&from)], positions: vec![position(&from)], at: Vec::new() });
            self.begun = true;
        }
        if let Some(way) = self.ways.last_mut() {
            let to = own(&motion.to);
            way.stands.push(Stand::from(&to));
            way.positions.push(position(&to));
            way.at.push(At::motion(motion));
        }
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        let name = t("Pasadas", "Passes");
        let (made, due) = (self.made, self.due);
        let asked = Question::new("passes", name, program)
            .showing(Text::same(made.to_string()), Text::same(due.to_string()))
            .seen(due);
        let mut checks = vec![
            asked.holds(made == due, |place| ClearPassesDiffer { program: program.title.clone(), made, due }.at(place)),
        ];
        let limit = self.limit();
        let shown = Text::same(format!("≥ −{}", mm(limit)));
        let size = |value: f64| Size { value, unit: "mm", decimals: 4 };
        if let Some((bounds, at)) = self.least(&self.walls(0.0, f64::MIN, false)) {
            let name = t("Holgura a las caras de todos los álabes", "Clearance to the faces of all blades");
            let asked = Question::new("faces", name, program)
                .showing(bounded(bounds.lower, bounds.upper), shown.clone())
                .at(Some(at))
                .seen(self.ways.len())
                .measuring(bounds.lower);
            checks.push(asked.holds(bounds.lower >= -limit, |place: Place| {
                let (line, program) = (at.line, program.title.clone());
                if bounds.upper < -limit {
                    ClearCutsBlade { depth: size(-bounds.upper), limit: size(limit), line, program }.at(place)
                } else {
                    ClearMayCut { limit: size(limit), line, program }.at(place)
                }
            }));
        }
        if let Some(v_s) = self.splitter {
            let half = PI / f64::from(self.design.N);
            let seam = self.seam(v_s);
            let faces = self.least(&self.walls(half, v_s, false));
            let noses = self
                .least(&self.walls(half, v_s, true))
                .map(|(bounds, at)| (Bounds { lower: bounds.lower + seam, upper: bounds.upper + seam, ..bounds }, at));
            let found = [faces, noses].into_iter().flatten().min_by(|one, two| one.0.lower.total_cmp(&two.0.lower));
            if let Some((bounds, at)) = found {
                let name = t("Holgura a los álabes intermedios", "Clearance to the splitters");
                let asked = Question::new("splitters", name, program)
                    .showing(bounded(bounds.lower, bounds.upper), shown)
                    .at(Some(at))
                    .seen(self.ways.len())
                    .measuring(bounds.lower);
                checks.push(asked.holds(bounds.lower >= -limit, |place| {
                    let (line, program) = (at.line, program.title.clone());
                    if bounds.upper < -limit {
                        ClearCutsSplitter { depth: size(-bounds.upper), limit: size(limit), line, program }.at(place)
                    } else {
                        ClearMayCut { limit: size(limit), line, program }.at(place)
                    }
                }));
            }
        }
        let sweeps: Vec<Sweep<usize>> = self
            .ways
            .iter()
            .enumerate()
            .map(|(number, way)| Sweep::through(number, self.design.machine, &way.positions, 0.0))
            .collect();
        let d = self.design.mill(self.which).d;
        let at = self.ways.first().and_then(|way| way.at.first()).copied();
        if let Some(found) = within(self.design.torus, self.design.a_p, d, &sweeps, limit) {
            let at = self
                .ways
                .get(found.track)
                .and_then(|way| way.at.get(motion(found.x.max(0.0)).min(way.at.len().saturating_sub(1))).copied())
                .or(at);
            let name = t("Fondo: lo más hondo por debajo", "Floor: the deepest below it");
            let value = Text::same(format!("≤ {}", mm(up(found.most))));
            let asked = Question::new("floor", name, program)
                .showing(value, Text::same(mm(limit)))
                .at(at)
                .seen(self.ways.len())
                .measuring(found.most);
            checks.push(asked.holds(found.most <= limit, |place| {
                let program = program.title.clone();
                FloorUnder { depth: size(up(found.most)), limit: size(limit), program }.at(place)
            }));
        }
        checks
    }
}
