//! What the tool of a clear cut does to the part that was designed: its own faces, those of the neighbours and the
//! splitters, and the floor.
//!
//! A pass is judged where it is run first. The other channels go through the same positions with C turned on, which the
//! agreement with the plan shows, by multiples of a blade's turn that are rounded to 0.001°: what that moves at the rim is
//! counted in.
//!
//! All faces of all blades count, those that the pass is meant to cut among them: the tool may enter them by no more than
//! the tolerance ε and 0.001 mm. Against faces a rounded end counts as a flat one of the same diameter, which holds it;
//! against the floor its true shape counts. Bounds, no samples ([`clearance`](crate::kinds::impeller::clearance),
//! [`floor_depth`](crate::kinds::impeller::floor_depth)).
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::{PI, TAU};

use crate::finding::figures::count;
use crate::finding::{Figures, Finding, Limit, Place, Raise, Size};
use crate::gcode::program::{Program, Role};
use crate::kinds::impeller::clear::asked::ClearCells;
use crate::kinds::impeller::clear::cut::Which;
use crate::kinds::impeller::clear::plan::Plan;
use crate::kinds::impeller::clear::programs::BACK;
use crate::kinds::impeller::clearance::{Bounds, Stand, Until, WORK, Walls};
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::floor_depth::{Deepest, within};
use crate::kinds::impeller::part::Part;
use crate::kinds::impeller::proof::holder;
use crate::kinds::impeller::proof::nose::Nose;
use crate::kinds::impeller::proof::rules::{
    AxisInBlade, AxisInThinBlade, ClearCutsBlade, ClearCutsSplitter, ClearCutsThickBlade, ClearMayCut,
    ClearPassesDiffer, FloorUnder, RoughingLeavesLess,
};
use crate::kinds::impeller::sweep::Sweep;
use crate::machine::axis::{Axis, Pose, Position};
use crate::number::grid::{HALF, Milli, TURN};
use crate::proof::check::{At, Check, Question, bounded, mm, up};
use crate::proof::step::{Judge, Stage, Step};
use crate::text::{Text, t};

/// What is left to ε: the block's error is looked at in eight places, and the nose is not the faces' own.
pub const OVER: f64 = 0.001;
/// Cells that are evaluated at most for a way when another one has taken all of its work; a usual one takes some hundreds.
const LESS: usize = WORK / 40;
/// Nearer to a face than this part of the radius the axis is taken to reach it.
const AT_AXIS: f64 = 0.02;
/// How close the bounds are brought to each other, mm.
const CLOSE: f64 = 0.0005;

/// A pass as it is run.
#[derive(Clone, Debug)]
struct RunPass {
    stands: Vec<Stand>,
    positions: Vec<Position>,
    at: Vec<At>,
}

/// Watches the passes of one program.
#[derive(Debug)]
pub struct ClearCutting<'a> {
    design: &'a Design,
    asked: &'a ClearCells,
    which: Which,
    /// Where splitters begin.
    splitter: Option<f64>,
    /// A stick-out that is enough for any holder.
    stick_out: f64,
    /// How many passes each channel should have.
    due: usize,
    channel: Option<Milli>,
    begun: bool,
    made: usize,
    passes: Vec<RunPass>,
}

impl<'a> ClearCutting<'a> {
    /// The judge of the program of one tool.
    #[must_use]
    pub fn new(design: &'a Design, asked: &'a ClearCells, plan: &Plan, which: Which) -> Self {
        let due = plan.of(which).count() * plan.channels as usize;
        let splitter = plan.told.splitter_from;
        let stick_out = plan.told.tool(which).stick_out;
        Self {
            design,
            asked,
            which,
            splitter,
            stick_out,
            due,
            channel: None,
            begun: false,
            made: 0,
            passes: Vec::new(),
        }
    }

    fn limit(&self) -> f64 {
        self.asked.tolerance + OVER
    }

    /// How near to a face the tool may come: in roughing the allowance stays, less the limit.
    fn least_left(&self) -> f64 {
        match self.which {
            Which::Rough => self.asked.cut.s - self.limit(),
            Which::Finish => -self.limit(),
        }
    }

    /// By how much a rounded turn of C moves the rim.
    fn turned(&self) -> f64 {
        HALF.to_radians() * self.design.torus.R
    }

    /// True where the limit lies between both bounds: then they are brought closer.
    fn straddles(&self, bounds: Bounds) -> bool {
        let limit = self.turned() - self.limit();
        bounds.lower < limit && bounds.upper >= limit
    }

    /// The least clearance of all ways to some walls, and where.
    fn least(&self, walls: &Walls) -> Option<(Bounds, At)> {
        let mut least: Option<(Bounds, At)> = None;
        let (mut work, mut deciding) = (WORK, WORK);
        // The last passes come nearest: of all before them it is then enough to know that they are not nearer still.
        for pass in self.passes.iter().rev() {
            let mut clearance = |until| searched(walls, &pass.stands, until, &mut work);
            let seen = least.map_or(f64::INFINITY, |(bounds, _)| bounds.upper);
            // What is clear by more than was seen need not be known closer.
            let enough = seen.max(self.asked.cut.s / 2.0);
            let mut bounds = clearance(Until::Decided(enough));
            if bounds.lower < enough {
                bounds = clearance(Until::Within(CLOSE));
            }
            if self.straddles(bounds) {
                bounds = clearance(Until::Within(CLOSE / 10.0));
            }
            // Where the work has ended before, on which side of the limit they are takes far less.
            if self.straddles(bounds) {
                let limit = Until::Decided(self.turned() - self.limit());
                bounds = both(bounds, searched(walls, &pass.stands, limit, &mut deciding));
            }
            let place = match bounds.place {
                Some(place) => motion(place.along),
                // Nothing of the walls ever counts.
                None if bounds.lower == f64::INFINITY => continue,
                // The work has ended before anything was seen: what is not known is not left out.
                None => 0,
            };
            lower(&mut least, bounds, pass.place(place));
        }
        self.widened(least)
    }

    /// Bounds with what a rounded turn of C adds.
    fn widened(&self, least: Option<(Bounds, At)>) -> Option<(Bounds, At)> {
        least.map(|(bounds, at)| {
            let turned = self.turned();
            (Bounds { lower: bounds.lower - turned, upper: bounds.upper + turned, ..bounds }, at)
        })
    }

    /// The clearance to the middles of blades from some v on, where a way does not keep out of them: a tool thinner than a
    /// blade would meet no face there.
    fn inside(&self, offset: f64, from: f64) -> Option<(Bounds, At)> {
        let (design, half) = (self.design, self.design.e / 2.0);
        let middle = Part::with(design.torus, 0.0, design.a_p);
        let walls = || Walls::new(middle, design.machine, 0.0, self.turns(offset), from);
        let (one_face, walls) = (walls().one_face(), walls());
        let radius = design.mill(self.which).d / 2.0;
        let (mut least, mut work) = (None, WORK);
        for pass in &self.passes {
            // That a way keeps off from a surface is known from one of its two faces with half the work.
            if one_face.clearance(&pass.stands, Until::Decided(half), LESS / 2).lower >= half {
                continue;
            }
            let bounds = searched(&walls, &pass.stands, Until::Decided(half), &mut work);
            // A tool beside a face that it may enter by the limit keeps its axis farther off.
            if bounds.lower >= half {
                continue;
            }
            let deep = |distance: f64| distance - half - radius;
            let found = Bounds { lower: deep(bounds.lower), upper: deep(bounds.upper), ..bounds };
            lower(&mut least, found, pass.place(bounds.place.map_or(0, |place| motion(place.along))));
        }
        self.widened(least)
    }

    /// The least clearance to the half rounds of the splitters from v_s on.
    fn noses(&self, v_s: f64) -> Option<(Bounds, At)> {
        let half = PI / f64::from(self.design.N);
        let nose = Nose::new(self.design, v_s, self.design.mill(self.which).d / 2.0);
        let mut least: Option<(Bounds, At)> = None;
        for pass in &self.passes {
            let sweep = Sweep::through(0_usize, self.design.machine, &pass.positions, nose.reach());
            let along = (sweep.stretches.as_slice(), &*nose.ways(&sweep.stretches));
            for turn in self.turns(half) {
                let seen = least.map_or(f64::INFINITY, |(bounds, _)| bounds.upper);
                let enough = seen.max(self.asked.cut.s / 2.0);
                let found = nose.clearance(along, turn, [enough, CLOSE]);
                let bounds = match found {
                    Some(bounds) if self.straddles(bounds) => nose.clearance(along, turn, [enough, CLOSE / 10.0]),
                    found => found,
                };
                if let Some(bounds) = bounds {
                    let at = bounds.place.map_or(0, |place| motion(place.along));
                    lower(&mut least, bounds, pass.place(at));
                }
            }
        }
        self.widened(least)
    }

    /// The least clearance to all blades.
    fn to_blades(&self) -> Option<(Bounds, At)> {
        let (faces, inside) = rayon::join(|| self.least(&self.walls(0.0, f64::MIN)), || self.inside(0.0, f64::MIN));
        nearest([faces, inside, None])
    }

    /// The least clearance to all splitters, where there are such.
    fn to_splitters(&self) -> Option<(Bounds, At)> {
        let (v_s, half) = (self.splitter?, PI / f64::from(self.design.N));
        let faces = || rayon::join(|| self.least(&self.walls(half, v_s)), || self.inside(half, v_s));
        let ((faces, inside), noses) = rayon::join(faces, || self.noses(v_s));
        nearest([faces, inside, noses])
    }

    /// The deepest place below the floor, by the number of the way.
    fn to_floor(&self) -> Option<Deepest<usize>> {
        let mill = self.asked.cut.tool(self.which);
        let through =
            |(number, pass): (usize, &RunPass)| Sweep::through(number, self.design.machine, &pass.positions, mill.r_c);
        let sweeps: Vec<Sweep<usize>> = self.passes.iter().enumerate().map(through).collect();
        within(self.design.torus, self.design.a_p, mill, &sweeps, self.limit())
    }

    fn turns(&self, offset: f64) -> Vec<f64> {
        let pitch = TAU / f64::from(self.design.N);
        (0..self.design.N).map(|k| pitch * f64::from(k) + offset).collect()
    }

    fn walls(&self, offset: f64, from: f64) -> Walls {
        let radius = self.design.mill(self.which).d / 2.0;
        Walls::new(Part::new(self.design), self.design.machine, radius, self.turns(offset), from)
    }
}

/// The clearance along a way, with so much work at most. Where that is not enough, little comes of the other ways: they get
/// less of it, so that what cannot be proved does not take minutes.
fn searched(walls: &Walls, pass: &[Stand], until: Until, work: &mut usize) -> Bounds {
    let bounds = walls.clearance(pass, until, *work);
    if bounds.work >= *work {
        *work = LESS;
    }
    bounds
}

/// What two searches of one way have found.
fn both(one: Bounds, other: Bounds) -> Bounds {
    let lower = one.lower.max(other.lower);
    if other.upper < one.upper { Bounds { lower, ..other } } else { Bounds { lower, ..one } }
}

impl RunPass {
    /// Where motion `motion` of the way is, the last one for any beyond it; line 0 for a way without motions.
    fn place(&self, motion: usize) -> At {
        self.at.get(motion.min(self.at.len().saturating_sub(1))).copied().unwrap_or(At::line(0))
    }
}

/// Takes bounds in beside those that are known; the place is that of the least lower one. What is no number stays.
fn lower(least: &mut Option<(Bounds, At)>, bounds: Bounds, at: At) {
    *least = Some(match *least {
        Some((known, place)) if known.lower <= bounds.lower || known.lower.is_nan() => {
            (Bounds { upper: known.upper.min(bounds.upper), ..known }, place)
        }
        Some((known, _)) => (Bounds { upper: known.upper.min(bounds.upper), ..bounds }, at),
        None => (bounds, at),
    });
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

/// The least of some clearances, and where.
fn nearest(found: [Option<(Bounds, At)>; 3]) -> Option<(Bounds, At)> {
    found.into_iter().flatten().reduce(|one, two| {
        let mut least = Some(one);
        lower(&mut least, two.0, two.1);
        least.unwrap_or(one)
    })
}

impl ClearCutting<'_> {
    /// Whether as many passes are run as the plan has.
    fn passes_check(&self, program: &Program) -> Check {
        let (made, due) = (self.made, self.due);
        let asked = Question::new("passes", t("Pasadas", "Passes"), program)
            .showing(Text::same(made.to_string()), Text::same(due.to_string()))
            .seen(due)
            .comparing(Figures::of(count(made as u64), Some(Limit::Exactly(count(due as u64)))));
        asked.holds(made == due, |place| ClearPassesDiffer { program: program.title.clone(), made, due }.at(place))
    }

    /// The answer on bounds of the clearance to the faces of all blades, mm, found where they say.
    #[must_use]
    pub fn faces_check(&self, program: &Program, (bounds, at): (Bounds, At)) -> Check {
        let name = t("Holgura a las caras de todos los álabes", "Clearance to the faces of all blades");
        let asked = self.clearance(Question::new("faces", name, program), bounds, at);
        asked.holds(bounds.lower >= self.least_left(), |place| {
            let (limit, line, program) = (self.limit(), at.line, program.title.clone());
            let d = self.asked.cut.tool(self.which).d;
            // The search for a face that the axis reaches ends at a hundredth of the radius.
            if self.is_into(bounds, self.turned() - (1.0 - AT_AXIS) * d / 2.0) {
                match self.thin_blades() {
                    Some(thin) => AxisInBlade { line, program, thin }.at(place),
                    None => AxisInThinBlade { line, program }.at(place),
                }
            } else if self.is_into(bounds, -limit) {
                let (depth, limit) = (Size::length(-bounds.upper, 4), Size::length(limit, 4));
                match self.thin_blades() {
                    Some(thin) => ClearCutsThickBlade { depth, limit, line, program, thin }.at(place),
                    None => ClearCutsBlade { depth, limit, line, program }.at(place),
                }
            } else {
                self.nearer(bounds, line, program, place)
            }
        })
    }

    /// How thick, mm, blades are surely thin enough for their straight ends to keep apart at the hub; `None` where they are. Along the hub a blade
    /// takes e·R/r, and they keep apart up to the radius of the floor there. Thicker ones may leave room, too; a wide tool may need
    /// thinner ones.
    fn thin_blades(&self) -> Option<Size> {
        let Design { torus, a_p, e, .. } = self.design;
        let thin = ((torus.R - torus.r - a_p) * torus.r / torus.R * 100.0).floor() / 100.0;
        (*e > thin).then(|| Size::length(thin, 2))
    }

    /// How far it keeps from all splitters.
    fn splitters_check(&self, program: &Program, (bounds, at): (Bounds, At)) -> Check {
        let name = t("Holgura a los álabes intermedios", "Clearance to the splitters");
        let asked = self.clearance(Question::new("splitters", name, program), bounds, at);
        asked.holds(bounds.lower >= self.least_left(), |place| {
            let (limit, line, program) = (self.limit(), at.line, program.title.clone());
            if self.is_into(bounds, -limit) {
                let (depth, limit) = (Size::length(-bounds.upper, 4), Size::length(limit, 4));
                ClearCutsSplitter { depth, limit, line, program }.at(place)
            } else {
                self.nearer(bounds, line, program, place)
            }
        })
    }

    /// How far it goes below the floor.
    fn floor_check(&self, program: &Program, found: &Deepest<usize>) -> Check {
        let (most, limit) = (found.most, self.limit());
        let first = self.passes.first().and_then(|pass| pass.at.first()).copied();
        // A stretch counts its positions from the one after the first.
        let at = self.passes.get(found.track).map(|pass| pass.place(motion((found.x + 1.0).max(0.0)))).or(first);
        let name = t("Fondo: lo que más baja de a_p", "Floor: the deepest below a_p");
        let asked = Question::new("floor", name, program)
            .showing(Text::same(format!("≤ {}", mm(up(most)))), Text::same(mm(limit)))
            .at(at)
            .seen(self.passes.len())
            .measuring(most)
            .against(Limit::AtMost(limit));
        asked.holds(most <= limit, |place| {
            let (depth, limit) = (Size::length(up(most), 4), Size::length(limit, 4));
            FloorUnder { depth, limit, program: program.title.clone() }.at(place)
        })
    }

    /// A question of a clearance, with what was found of it and the least there may be.
    fn clearance(&self, asked: Question, bounds: Bounds, at: At) -> Question {
        let least = self.least_left();
        let sign = if least < 0.0 { "-" } else { "" };
        asked
            .showing(bounded(bounds.lower, bounds.upper), Text::same(format!("≥ {sign}{}", mm(least.abs()))))
            .at(Some(at))
            .seen(self.passes.len())
            .measuring(bounds.lower)
            .against(Limit::AtLeast(least))
    }

    /// True where nothing is entered by more than the limit, for certain.
    fn keeps_out(&self, bounds: Bounds) -> bool {
        bounds.lower >= -self.limit()
    }

    /// True where something is entered so far that the clearance is below this one, for certain.
    fn is_into(&self, bounds: Bounds, below: f64) -> bool {
        !self.keeps_out(bounds) && bounds.upper < below
    }

    /// What is said of a clearance that is too small where nothing is entered for certain: less is left than is asked, or something
    /// may be entered.
    fn nearer(&self, bounds: Bounds, line: usize, program: Text, place: Place) -> Finding {
        if self.keeps_out(bounds) {
            let (left, asked) = (Size::length(-up(-bounds.lower.max(0.0)), 4), Size::mm(self.asked.cut.s));
            RoughingLeavesLess { left, asked, line, program }.at(place)
        } else {
            ClearMayCut { limit: Size::length(self.limit(), 4), line, program }.at(place)
        }
    }
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
        let channel = Milli::new(path.turn.thousandths().rem_euclid(TURN));
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
            self.passes.push(RunPass {
                stands: vec![Stand::from(&from)],
                positions: vec![position(&from)],
                at: Vec::new(),
            });
            self.begun = true;
        }
        if let Some(pass) = self.passes.last_mut() {
            let to = own(&motion.to);
            pass.stands.push(Stand::from(&to));
            pass.positions.push(position(&to));
            pass.at.push(At::motion(motion));
        }
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        // Each is a search by itself.
        let walls = || rayon::join(|| self.to_blades(), || self.to_splitters());
        let ((blades, splitters), floor) = rayon::join(walls, || self.to_floor());
        let mut checks = vec![self.passes_check(program)];
        checks.extend(blades.map(|found| self.faces_check(program, found)));
        checks.extend(splitters.map(|found| self.splitters_check(program, found)));
        checks.extend(floor.map(|found| self.floor_check(program, &found)));
        let passes = self.passes.iter().map(|pass| pass.stands.as_slice());
        checks.extend(holder::check((self.design, self.asked, self.which), self.stick_out, passes, program));
        checks
    }
}
