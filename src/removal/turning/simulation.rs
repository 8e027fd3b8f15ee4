//! A turning program, motion by motion: what each takes away from the part, how long it takes, and what goes wrong.

use std::collections::BTreeMap;

use super::alarm::{Alarm, Cause, TOUCH};
use super::change;
use super::contact::Contact;
use super::engagement::{Engagement, Led, Ready, WITHIN};
use super::motion_totals::{Tally, travel};
use super::once::Watch;
use super::path::{self, Piece};
use super::retraction::{retracts, straight_back};
use super::rules::{ArcTolerance, PartBeyondSpace, ToolWithoutOutline};
use super::spindle::SpindleUse;
pub use super::start::Setup;
use super::step::{Edit, Step, Totals};
use super::stock::{Fixture, turned_about};
use super::surface_origin::{self, Chain};
use super::thread_groove::ThreadGroove;
use super::workpiece::{CHIP, Removed, Workpiece};
use crate::finding::{Exit, Place, Raise, Refusal};
use crate::gcode::in_force::{InForce, Speed};
use crate::gcode::motion::{Feed, Motion, MotionKind};
use crate::geometry::exact::convex::Convex;
use crate::geometry::exact::grid::{LIMIT, Point, UNITS};
use crate::geometry::exact::region::{Labelled, Ring};
use crate::machine::axis::{Axis, Pose};

/// The tolerances of arcs that can be followed, mm.
const TOLERANCE: [f64; 2] = [1e-5, 0.1];
/// How far from the middle of the stock a fixture is followed, mm: to just within the grid, whose limit is 1073.74 mm. Neither part
/// nor tool is beyond it.
const FAR: f64 = 1070.0;
const _: () = assert!(FAR * UNITS < LIMIT as f64);

/// A simulation under way.
#[derive(Clone, Debug)]
pub struct Simulation {
    setup: Setup,
    tools: BTreeMap<u32, Ready>,
    fixtures: Vec<(Fixture, Convex)>,
    part: Workpiece,
    /// What the grid's origin is along z from W1, mm.
    middle: f64,
    watch: Watch,
    totals: Totals,
    steps: usize,
    contour: Ring,
    /// Where the piece was parted off that came off last.
    parting: Option<Parting>,
    /// The thread that the last motion cut.
    led: Option<Led>,
    /// The tool that stands where it worked last, or straight behind that, `[z, r]` on the grid.
    stands: Option<(u32, [f64; 2])>,
    /// What made the part's surfaces.
    chain: Chain,
    /// The place of the turret at the last motion.
    place: Option<u32>,
    // Kept so as not to allocate for each motion.
    pieces: Vec<Piece>,
    swept: Convex,
}

/// A piece has come off.
#[derive(Clone, Copy, Debug)]
struct Parting {
    /// The tool's place.
    tool: u32,
    /// Where the programmed point ended, z on the grid.
    z: f64,
    /// See [`Simulation::cuts_on`].
    cuts_on: Option<(usize, usize)>,
}

impl Simulation {
    /// Makes everything ready. Refused, with all reasons: a blank or a tool that cannot be, a tolerance out of 10 nm to
    /// 0.1 mm, a part beyond the grid.
    pub fn new(setup: Setup) -> Result<Self, Refusal> {
        Self::begun(setup, &[], Chain::default())
    }

    /// The second set-up of what this program makes: turned about and shifted, see [`turned_about`]. What made its surfaces is
    /// known there, and the work that was done counts.
    pub fn turned_about(&self, shift: f64) -> Result<Self, Refusal> {
        let (rings, labels): (Vec<Ring>, Vec<Vec<u32>>) = self.made().into_iter().unzip();
        let stock = &self.setup.stock;
        let part = Some(turned_about(&self.shifted(rings), stock, shift));
        // The edge that began at a corner ends there now.
        let about = |of: Vec<u32>| {
            of.iter().rev().cycle().skip(1).take(of.len()).copied().map(surface_origin::turned_about).collect()
        };
        let labels: Vec<Vec<u32>> = labels.into_iter().map(about).collect();
        let [left, right] = stock.ends();
        let chain = self.chain.turned_about(left + right + shift - 2.0 * self.middle);
        let most_work = self.work_left();
        let mut second = Self::begun(Setup { part, most_work, ..self.setup.clone() }, &labels, chain)?;
        let about = |groove: ThreadGroove| groove.mirrored(left + right + shift).shifted(-second.middle);
        let grooves = self.thread_grooves().into_iter().map(about).collect();
        second.watch.begin_with(grooves);
        Ok(second)
    }

    fn begun(setup: Setup, labels: &[Vec<u32>], chain: Chain) -> Result<Self, Refusal> {
        let mut faults = setup.stock.faults();
        let [finest, coarsest] = TOLERANCE;
        if !(finest..=coarsest).contains(&setup.tolerance) {
            faults.push(ArcTolerance {}.at(Place::File));
        }
        let tolerance = setup.tolerance.clamp(finest, coarsest);
        let mut tools = BTreeMap::new();
        for (&place, tool) in &setup.turret.tools {
            match tool.outline(tolerance, setup.lathe.turret_behind) {
                Ok(outline) => {
                    let bodies = setup.turret.bodies(tool);
                    tools.insert(place, Ready { tool: tool.clone(), outline, bodies });
                }
                Err(why) => faults.push(ToolWithoutOutline { place, why }.at(Place::File)),
            }
        }
        let middle = ((setup.stock.ends()[0] + setup.stock.ends()[1]) / 2.0).round();
        let grid = |rings: &[Ring]| -> Option<Vec<Vec<Point>>> {
            let place = |&[z, r]: &[f64; 2]| Point::near([z - middle, r]);
            rings.iter().map(|ring| ring.iter().map(place).collect()).collect()
        };
        let part = grid(setup.part.as_deref().unwrap_or(&[setup.stock.contour()]));
        if part.is_none() {
            faults.push(PartBeyondSpace {}.at(Place::File));
        }
        let (Some(part), true) = (part, faults.is_empty()) else {
            return Err(Refusal { exit: Exit::Refused, findings: faults });
        };
        let fixtures = (setup.fixtures().into_iter())
            .filter_map(|(fixture, ring)| {
                let near = |at: f64| at.clamp(-FAR, FAR);
                let ring: Vec<_> = ring.iter().map(|&[z, r]| [near(z - middle), near(r)]).collect();
                Some((fixture, Convex::hull_mm(&ring)?))
            })
            .collect();
        let part = Workpiece::new(&part, labels, setup.most_work);
        let mut made = Self {
            setup,
            tools,
            fixtures,
            part,
            middle,
            watch: Watch::default(),
            totals: Totals::default(),
            steps: 0,
            contour: Ring::new(),
            parting: None,
            led: None,
            stands: None,
            chain,
            place: None,
            pieces: Vec::new(),
            swept: Convex::default(),
        };
        made.contour = made.contours().into_iter().next().unwrap_or_default();
        Ok(made)
    }

    /// What it started from.
    #[must_use]
    pub const fn setup(&self) -> &Setup {
        &self.setup
    }

    /// The part's contours as they are, `[z, r]` from W1 in mm: counter-clockwise, holes clockwise.
    #[must_use]
    pub fn contours(&self) -> Vec<Ring> {
        self.shifted(self.part.rings())
    }

    fn shifted(&self, mut rings: Vec<Ring>) -> Vec<Ring> {
        rings.iter_mut().flatten().for_each(|point| point[0] += self.middle);
        rings
    }

    /// What the program makes: the piece that it has parted off last, also where it still cuts the stub there; else, and where it goes on
    /// cutting elsewhere, what is in the chuck; see [`super::detached::judged`].
    #[must_use]
    pub fn product(&self) -> Vec<Ring> {
        self.shifted(self.made().into_iter().map(|(ring, _)| ring).collect())
    }

    /// The same on the grid, with the labels of its edges.
    fn made(&self) -> Vec<Labelled> {
        let piece = self.piece();
        if piece.is_empty() { self.part.labelled_rings() } else { piece.to_vec() }
    }

    /// The piece that was parted off last, where it is what the program makes.
    fn piece(&self) -> &[Labelled] {
        if self.cuts_on().is_some() { &[] } else { self.part.fallen() }
    }

    /// The same; `None` where there is none, and of a program that goes on cutting the bar: it makes what is left.
    #[must_use]
    pub fn parted(&self) -> Option<Vec<Ring>> {
        (!self.piece().is_empty()).then(|| self.product())
    }

    /// How many pieces were parted off.
    #[must_use]
    pub const fn partings(&self) -> usize {
        self.part.partings()
    }

    /// The first motion behind the last parting-off that cuts the rest of the bar elsewhere, or with another tool: the file and the line.
    /// It may be that the program means to make another part of it, and that is taken as what it makes.
    #[must_use]
    pub fn cuts_on(&self) -> Option<(usize, usize)> {
        self.parting.and_then(|parting| parting.cuts_on)
    }

    /// The part's outer contour when the simulation started, or where the last recorded edit has left it.
    #[must_use]
    pub const fn contour(&self) -> &Ring {
        &self.contour
    }

    /// The part's volume, mm³.
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.part.volume()
    }

    /// The alarms that can be reported only when the program has ended: where an edge has taken away again what the nose had
    /// made, and no later motion has taken that surface; and passes of a thread that no later pass brings into its groove.
    #[must_use]
    pub fn lasting(&self) -> Vec<Alarm> {
        [self.chain.alarms(self.labels().into_iter()), self.watch.off_groove()].concat()
    }

    /// The same where what the program made has been turned about and a second program has ended: of the marks those that are
    /// on what the second one left. With `None` those alone that are on what it did not begin with: what had fallen off, or
    /// what stayed in the chuck.
    #[must_use]
    pub fn lasting_in(&self, second: Option<&Self>) -> Vec<Alarm> {
        let rest = if self.piece().is_empty() { self.part.fallen() } else { &self.part.labelled_rings() };
        let left = second.map(Self::labels).unwrap_or_default();
        let marks = self.chain.alarms(self.part.gone().chain(labels(rest)).chain(left));
        [marks, self.watch.off_groove()].concat()
    }

    /// The labels of everything: in the chuck, or fallen off.
    fn labels(&self) -> Vec<u32> {
        let part = &self.part;
        labels(&part.labelled_rings()).chain(labels(part.fallen())).chain(part.gone()).collect()
    }

    /// From now on a library of polygons takes away the same beside; see [`super::second_removal`].
    pub fn repeat(&mut self) {
        self.part.repeat();
    }

    /// How far what the library has left is from the part's contours, mm; `None` where it was not asked for. It ends with this.
    pub fn repeated(&mut self) -> Option<f64> {
        self.part.repeated()
    }

    /// True where the work that the set-up allows was used up: the last motion was not made as a whole, and none can be made
    /// any more.
    #[must_use]
    pub const fn is_spent(&self) -> bool {
        self.part.is_spent()
    }

    /// The steps of work so far: stretches of outlines looked at.
    #[must_use]
    pub const fn work(&self) -> u64 {
        self.part.work()
    }

    /// The steps that are left of those that the set-up allows.
    #[must_use]
    pub const fn work_left(&self) -> u64 {
        self.setup.most_work.saturating_sub(self.part.work())
    }

    /// The sums so far.
    #[must_use]
    pub const fn totals(&self) -> &Totals {
        &self.totals
    }

    /// Where the programmed point of a turret's place stands with the turret at a place of the machine, `[z, r]` from W1,
    /// mm.
    #[must_use]
    pub fn point(&self, tool: u32, machine: &Pose) -> [f64; 2] {
        let [over_x, over_z] = self.tools.get(&tool).map_or([0.0, 0.0], |ready| ready.tool.overhang);
        let zero = self.setup.stock.zero(&self.setup.lathe);
        let [origin_x, origin_z] = self.setup.lathe.origin;
        [machine.get(Axis::Z) + origin_z - over_z - zero, machine.get(Axis::X) + origin_x - over_x]
    }

    /// True where a rapid motion leaves the same part with each axis at its own of these rates, X and Z, as straight: where both
    /// ways are one, or neither goes through metal.
    pub fn leaves_alike(&mut self, motion: &Motion, control: &InForce, rates: [f64; 2]) -> bool {
        let Some(ready) = self.tools.get(&control.tool) else { return true };
        let [z, r] = self.point(control.tool, &motion.machine);
        let [straight, bent] = [None, Some(rates)].map(|bent| {
            path::pieces(motion, [z - self.middle, r], bent, self.setup.tolerance, &mut self.pieces);
            let ends = self.pieces.iter().filter_map(|&piece| path::on_grid(piece, WITHIN));
            ends.filter(|[first, last]| first != last).collect::<Vec<_>>()
        });
        let mut cutters = ready.outline.cutter.iter().map(|cutter| &cutter.polygon);
        straight == bent
            || !cutters.any(|cutter| {
                let mut ends = straight.iter().chain(&bent);
                ends.any(|[first, last]| cutter.sweep(*first, *last, &mut self.swept) && self.part.meets(&self.swept))
            })
    }

    /// The grooves of the threads of the part, also of those cut before it was turned about.
    #[must_use]
    pub fn thread_grooves(&self) -> Vec<ThreadGroove> {
        self.watch.grooves().iter().map(|groove| groove.shifted(self.middle)).collect()
    }

    /// The same work on from here, but in rapid motions each axis goes at its own of these rates, X and Z.
    #[must_use]
    pub fn bent(&self, rates: [f64; 2]) -> Self {
        let mut other = self.clone();
        (other.setup.lathe.bent_rapid, other.setup.lathe.rapid) = (true, rates);
        other
    }

    /// Makes one motion with what is in force in it: moves the tool, takes the metal away, and says what that comes to.
    pub fn take(&mut self, motion: &Motion, control: &InForce) -> Step {
        let origin = self.setup.lathe.origin;
        let reference = [motion.machine.get(Axis::Z) + origin[1], motion.machine.get(Axis::X) + origin[0]];
        // Where the programmed point ends on the grid.
        let [z, r] = self.point(control.tool, &motion.machine);
        let to = [z - self.middle, r];
        let shift = [motion.to.get(Axis::Z) - to[0], motion.to.get(Axis::X) - to[1]];
        let lathe = &self.setup.lathe;
        let mut pieces = std::mem::take(&mut self.pieces);
        path::pieces(motion, to, lathe.bent_rapid.then_some(lathe.rapid), self.setup.tolerance, &mut pieces);

        self.part.spend(pieces.len());
        let turning = SpindleUse::new(control, lathe);
        let (index, file) = (self.steps, control.file);
        let (begins, sides, speed, alarms) = (None, [0.0; 2], 0.0, Vec::new());
        let mut tally = Tally { motion, index, file, shift, turning, begins, sides, speed, alarms };
        let seconds = match motion.kind {
            MotionKind::Rapid => None,
            _ => motion.seconds,
        };
        let seconds = seconds.or_else(|| turning.seconds(motion, &pieces, lathe));
        travel(&mut tally, &pieces, [reference[0] - to[0], reference[1] - to[1]], lathe);
        let start = pieces.first().map_or(to, |piece| piece[0]);
        if let Some(old) = self.place.replace(control.tool).filter(|old| *old != control.tool) {
            let zero = self.setup.stock.zero(lathe) + self.middle;
            let stands = [reference[0] - zero - to[0] + start[0], reference[1] - to[1] + start[1]];
            let tools = self.tools.iter().map(|(place, ready)| (*place, &ready.tool, &ready.outline));
            change::judge((&mut self.part, &self.fixtures), tools, [old, control.tool], stands, &mut tally);
        }

        let mut contact = Contact::default();
        let begins = !self.led.is_some_and(|led| led.leads(control.tool, start));
        let leaves = self.tools.get(&control.tool).zip(self.stands).map(|(ready, stands)| {
            let leaves = retracts(&ready.tool, stands, control.tool, &pieces);
            (leaves, leaves && straight_back(&ready.tool, &pieces))
        });
        let (leaves, back) = leaves.unwrap_or_default();
        let partings = self.part.partings();
        let removed = if pieces.is_empty() {
            Removed::default()
        } else {
            self.cut(&pieces, leaves, control, &mut contact, &mut tally)
        };
        self.judge(control, &pieces, begins, &contact, &mut tally);
        if begins && contact.real && motion.kind != MotionKind::Rapid {
            self.watch.run_in(control.tool, &pieces, &mut tally);
        }
        if removed.parted > 0.0 {
            tally.raise(Cause::PartedOff(removed.parted), to, None);
            if self.part.partings() != partings {
                self.parting = Some(Parting { tool: control.tool, z: to[0], cuts_on: None });
            }
        } else if let Some(parting) = &mut self.parting
            && motion.kind != MotionKind::Rapid
            && removed.volume > CHIP
            && (control.tool != parting.tool || (to[0] - parting.z).abs() > TOUCH)
        {
            parting.cuts_on.get_or_insert((control.file, motion.line));
        }

        let (program_start, program_end) = (start[1] + shift[1], to[1] + shift[1]);
        let speed = [turning.at(program_start), turning.at(program_end)];
        let cuts = contact.real && motion.kind != MotionKind::Rapid;
        if !pieces.is_empty() {
            // A blade that goes straight back in several rapids meets in each of them what its own sides have left.
            self.stands = (motion.kind != MotionKind::Rapid || back).then_some((control.tool, to));
        }
        let cutting_speed = if cuts { tally.speed } else { 0.0 };
        let rate = match seconds {
            Some(seconds) if seconds > 0.0 => Some(removed.volume / 1000.0 / (seconds / 60.0)),
            _ => None,
        };
        let mut way: Vec<_> = pieces.first().map(|piece| piece[0]).into_iter().collect();
        way.extend(pieces.iter().map(|piece| piece[1]));
        way.iter_mut().for_each(|point| point[0] += self.middle);
        let mut step = Step {
            index: self.steps,
            motion: *motion,
            control: *control,
            way,
            seconds,
            speed,
            cutting_speed,
            depth: if cuts { contact.across } else { 0.0 },
            removed,
            rate,
            alarms: tally.alarms,
            edit: None,
        };
        if self.setup.record && removed != Removed::default() && self.part.spend(self.contour.len()) {
            let after = self.contours().into_iter().next().unwrap_or_default();
            step.edit = Edit::between(&self.contour, &after);
            self.contour = after;
        }
        self.pieces = pieces;
        self.steps += 1;
        self.totals.add(&step);
        step
    }

    /// Takes away what the tool sweeps, and looks where the rest of it goes.
    fn cut(
        &mut self,
        pieces: &[Piece],
        leaves: bool,
        control: &InForce,
        contact: &mut Contact,
        tally: &mut Tally,
    ) -> Removed {
        let removed = Removed::default();
        let Some(ready) = self.tools.get(&control.tool) else { return removed };
        let kind = tally.motion.kind;
        if !matches!(kind, MotionKind::Feed(_) | MotionKind::Arc(..)) {
            self.chain.end();
        }
        let mut engagement = Engagement {
            place: control.tool,
            ready,
            fixtures: &self.fixtures,
            part: &mut self.part,
            chain: &mut self.chain,
            contact,
            tally,
            swept: &mut self.swept,
            removed,
            scraped: None,
        };
        if let MotionKind::Thread(thread) = kind {
            engagement.thread(thread, pieces, &mut self.led);
        } else if let Some(led) = self.led.take()
            && let Some(&[from, _]) = pieces.first()
            && led.leads(control.tool, from)
        {
            // Where the thread ends in metal, the spindle turns on while the tool stands: there it cuts a ring.
            engagement.ring(from);
        }
        for &piece in pieces {
            if engagement.part.is_spent() {
                break;
            }
            engagement.along(piece);
        }
        engagement.end(leaves, pieces, control)
    }

    /// What the motion's contact with metal, and what is in force, give rise to.
    fn judge(&mut self, control: &InForce, pieces: &[Piece], begins: bool, contact: &Contact, tally: &mut Tally) {
        let Some(&[start, end]) = pieces.last() else { return };
        let start = pieces.first().map_or(start, |piece| piece[0]);
        let kind = tally.motion.kind;
        let ready = self.tools.get(&control.tool);
        let lathe = &self.setup.lathe;
        let cuts = contact.real && kind != MotionKind::Rapid;
        let watch = &mut self.watch;
        if let MotionKind::Feed(Feed { value, .. }) | MotionKind::Arc(_, Feed { value, .. }) = kind
            && value <= 0.0
        {
            tally.raise(Cause::NoFeed, start, None);
        }
        // A turret may be moved about before the first tool is called.
        let missing = ready.is_none() && (control.tool != 0 || kind != MotionKind::Rapid);
        if watch.begins(Cause::UnknownTool(0), missing, control.tool) {
            tally.raise(Cause::UnknownTool(control.tool), start, None);
        }
        if let MotionKind::Thread(thread) = kind {
            self.part.spend(watch.passes());
            // What is deeper than its edge is reported for that.
            let deep = if contact.edge.is_some() { 0.0 } else { contact.across };
            let met = cuts.then(|| (deep, contact.ribs.unwrap_or([start; 2])));
            let tool = (control.tool, ready.map(|ready| &ready.tool));
            watch.thread(thread, [start, end], tool, (begins, met), tally);
        }
        let turning = SpindleUse::new(control, lathe);
        let asked = [start, end].map(|at| turning.asked(at[1] + tally.shift[1])).into_iter().fold(0.0, f64::max);
        let most = lathe.greatest_speed;
        match control.speed {
            Speed::Surface(_) => {
                // A limit above the spindle's maximum limits nothing.
                let races = control.greatest_speed.is_none_or(|limit| limit > most) && asked > most;
                if watch.begins(Cause::NoGreatestSpeed { asked, most }, races, control.tool) {
                    tally.raise(Cause::NoGreatestSpeed { asked, most }, end, None);
                }
            }
            Speed::Revolutions(_) => {
                if watch.begins(Cause::TooFast { asked, most }, asked > most, control.tool) {
                    tally.raise(Cause::TooFast { asked, most }, end, None);
                }
            }
        }
        let Some(ready) = ready else { return };
        if !cuts {
            return;
        }
        let stopped = turning.at(start[1] + tally.shift[1]) <= 0.0;
        let right = ready.tool.spindle(lathe.turret_behind, tally.beyond([start, end]));
        for (cause, holds) in [
            (Cause::SpindleStopped, stopped),
            (Cause::SpindleWrongWay, !stopped && right.is_some_and(|right| control.spindle != right)),
            (Cause::DrillAtSurfaceSpeed, ready.tool.axial() && matches!(control.speed, Speed::Surface(_))),
            (Cause::NoCoolant, !control.coolant),
            (Cause::OffAxis, ready.tool.axial() && start[1].abs().max(end[1].abs()) > TOUCH),
        ] {
            if watch.begins(cause, holds, control.tool) {
                tally.raise(cause, tally.begins.unwrap_or(start), None);
            }
        }
        // What is deeper than its edge is reported for that.
        let deep = if contact.edge.is_some() { 0.0 } else { contact.across };
        watch.edge(&ready.tool, control, pieces, (deep, contact.place), tally);
        let back = contact.back.or(contact.beside.filter(|_| !contact.dragged));
        if let Some(cause) = contact.solid {
            tally.raise(cause, contact.place, Some(contact.across));
        }
        // What a boring bar meets and leaves besides where there is no hole for it follows from that.
        if tally.alarms.iter().any(|alarm| matches!(alarm.cause, Cause::BoreWithoutHole { .. })) {
            self.chain.forget(tally.index);
            return;
        }
        if let Some(edge) = contact.edge {
            tally.raise(Cause::DepthOfCut { depth: contact.across, edge }, contact.place, Some(contact.across));
        }
        // Where the auxiliary edge's far end left the surface, the back beside it has been in metal with it.
        if let Some(deep) = back {
            tally.raise(Cause::BackInMetal, contact.place, Some(deep));
        }
    }
}

fn labels(rings: &[Labelled]) -> impl Iterator<Item = u32> + '_ {
    rings.iter().flat_map(|(_, labels)| labels.iter().copied())
}
