//! One turning program followed from its first block to its last.

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::{FRAC_PI_2, PI};
use std::ops::ControlFlow;

use super::drawn::Drawn;
use super::findings::{
    Faults, Reached, alarms, assumed, at_line, not_repeated, too_many, too_much_work, unjudged_from,
};
use super::rules::{CutsBehindParting, FeedBeyondRapid, InInches, NoMotion, NothingCut, ToolCutsNothing};
use super::setup::Given;
use super::setup_sheet::CuttingConditions;
use super::tables::Rows;
use super::text::SheetProgram;
use super::{Raised, SimulationEvent, outside};
use crate::finding::{Exit, Finding, Place, Raise, Rule, Size};
use crate::gcode::in_force::InForce;
use crate::gcode::interpreter::Interpreter;
use crate::gcode::interpreter::Refused;
use crate::gcode::motion::{Arc, Motion, MotionKind};
use crate::gcode::program::Program;
use crate::gcode::rules::lexis::MoreRefusals;
use crate::gcode::rules::modes::{CutsBeforeSpindle, GreatFeedPerTurn};
use crate::gcode::rules::turned::{
    CutsWithoutOffset, NoOffsetAnywhere, PassFarDeeper, SpindleNeverStarts, ThreadAtSurfaceSpeed, ThreadBeyondRapid,
};
use crate::gcode::turning::pace::peak;
use crate::gcode::word::NumberFormat;
use crate::kind::{Duration, Proved};
use crate::limits::FOLLOWED_MOTIONS;
use crate::machine::axis::{Axis, Pose, Position};
use crate::number::trig;
use crate::proof::account::Account;
use crate::removal::turning::alarm::Cause;
use crate::removal::turning::in_force::InForceWatch;
use crate::removal::turning::second_removal::AGREE;
use crate::removal::turning::simulation::Simulation;
use crate::removal::turning::step::Step;
use crate::text::Text;

/// A program followed to its end.
pub(super) struct Followed<'a> {
    pub(super) program: Program,
    pub(super) source: &'a SheetProgram,
    /// The names of its subprograms' files, by their numbers from 1.
    pub(super) files: Vec<String>,
    pub(super) simulation: Simulation,
    pub(super) rows: Rows,
    /// How its tools cut.
    pub(super) conditions: CuttingConditions,
    pub(super) alarms: Vec<Raised>,
    pub(super) findings: Vec<Finding>,
    /// A budget ended before the program did.
    pub(super) endless: bool,
    /// A block of it was refused, or one of a program before it.
    pub(super) lost: bool,
    /// A turning cycle was refused, and nothing after it was made.
    pub(super) uncut: bool,
    /// How far a library of polygons is from the contours, mm.
    pub(super) repeated: f64,
    pub(super) drawn: Drawn,
    pub(super) account: Account,
}

impl Followed<'_> {
    /// The program with what it came to.
    pub(super) fn proved(self) -> Proved {
        let all = self.simulation.totals().all;
        Proved {
            program: self.program,
            account: self.account,
            duration: Some(Duration { seconds: all.seconds, timeless: all.timeless }),
        }
    }
}

/// The program as it stands on its sheet; its subprograms are not known before it has been read.
fn listed(key: &'static str, title: Text, source: &SheetProgram, given: &Given) -> Program {
    Program {
        key,
        title,
        control: given.control,
        law: given.control.feed.law,
        format: NumberFormat::Fixed,
        block_step: None,
        start: Position::default(),
        parts: source.whole(std::iter::empty()),
    }
}

/// What a program begins with.
pub(super) struct Begins {
    pub(super) simulation: Simulation,
    /// The program before it went wrong, or nothing holds the part.
    pub(super) lost: bool,
    /// The part that it needs was not made, or nothing holds it.
    pub(super) uncut: bool,
    /// How the part is held.
    pub(super) held: Option<Finding>,
}

impl Begins {
    pub(super) const fn new(simulation: Simulation) -> Self {
        Self { simulation, lost: false, uncut: false, held: None }
    }
}

/// What goes on while a program is followed.
struct Following<'f, 'a> {
    one: Followed<'a>,
    given: &'f Given,
    in_force: InForceWatch,
    faults: Faults,
    /// The tools that have moved at feed, with where they first did.
    fed: BTreeMap<u32, Place>,
    /// Those whose feed has been told to be faster than an axis.
    too_fast: BTreeSet<u32>,
    /// The work offsets that are not known and have been told.
    without_zero: BTreeSet<u8>,
    /// Where following stopped to be judged.
    last: Option<Place>,
    /// Whether anything was still followed there.
    unjudged: bool,
    before: Pose,
    /// The turret's place.
    place: u32,
    /// The file and line of the block that has changed it without a motion.
    turned: Option<(usize, usize)>,
}

/// Follows one program over a set-up, of which it is said whether the program before it went wrong.
///
/// The motions behind a block that was refused are not those that the program means: they are followed for what the
/// interpreter has to say about the blocks, and their alarms, which would follow from that block, are not raised.
///
/// Behind a cycle that was refused, and with `uncut` from the start, the program is read and not made, for the part that it
/// needs was not.
pub(super) fn follow<'a>(
    key: &'static str,
    title: Text,
    source: &'a SheetProgram,
    given: &Given,
    Begins { mut simulation, lost, uncut, held }: Begins,
    watch: &mut dyn FnMut(SimulationEvent<'_>),
) -> Followed<'a> {
    let program = listed(key, title, source, given);
    simulation.repeat();
    watch(SimulationEvent::Begin(&program, source, &simulation));
    let stock = simulation.contours();
    let mounted = simulation.setup().turret.tools.iter();
    let slow = mounted.filter(|(_, tool)| tool.fed_slowly()).map(|(&place, _)| place).collect();
    let one = Followed {
        program,
        source,
        files: Vec::new(),
        simulation,
        rows: Rows::default(),
        conditions: CuttingConditions::default(),
        alarms: Vec::new(),
        findings: Vec::new(),
        endless: false,
        lost,
        uncut,
        repeated: 0.0,
        drawn: Drawn { stock, ..Drawn::default() },
        account: Account::default(),
    };
    let mut interpreter = source.read(given.setting());
    let mut following = Following {
        one,
        given,
        in_force: InForceWatch::new(given.own.clone(), slow),
        faults: Faults::default(),
        fed: BTreeMap::new(),
        too_fast: BTreeSet::new(),
        without_zero: BTreeSet::new(),
        last: lost.then_some(Place::File),
        unjudged: false,
        before: interpreter.position().1,
        place: interpreter.in_force().tool,
        turned: None,
    };
    interpreter.keep_stood();
    watch(SimulationEvent::Stood(&interpreter.stands(), &following.one.simulation, None));
    loop {
        let item = interpreter.next();
        following.one.uncut |= interpreter.uncut();
        following.stood(&mut interpreter, watch);
        match item {
            Some(Ok(motion)) => {
                if following.motion(&motion, &interpreter, watch).is_break() {
                    break;
                }
            }
            Some(Err(fault)) => following.refused(*fault),
            None => break,
        }
    }
    following.ended(&interpreter, held, watch)
}

/// The greatest part of the feed along an arc that an axis of its plane takes: all of it where the arc runs along the axis, else that of
/// one of its ends.
fn greatest_part(arc: &Arc, motion: &Motion, axis: Axis) -> f64 {
    let [first, second, _] = arc.plane.axes();
    let [a, b] = [(first, 0), (second, 1)].map(|(axis, at)| motion.from.get(axis) - arc.centre[at]);
    // The arc runs along its first axis where it is a quarter of a turn away from it, seen from the centre.
    let shift = if axis == first { FRAC_PI_2 } else { 0.0 };
    let from = trig::atan2(b, a) - shift;
    let to = from + arc.sweep;
    if (from / PI).floor() != (to / PI).floor() {
        1.0
    } else {
        trig::sin_cos(from).1.abs().max(trig::sin_cos(to).1.abs())
    }
}

/// The remarks that alarms or findings of the simulation say with more of the machine, the tool or the part.
fn told_apart(alarms: &[Raised], told: &[Finding]) -> Vec<&'static Rule> {
    let raised = |cause: fn(Cause) -> bool| alarms.iter().any(|one| cause(one.alarm.cause));
    let offset = raised(|cause| matches!(cause, Cause::OtherOffset { .. }));
    let stopped = raised(|cause| matches!(cause, Cause::SpindleStopped | Cause::FeedStands));
    let said = [
        // Alarm 172 says it with the tool's own limits.
        (true, GreatFeedPerTurn::RULE),
        (told.iter().any(|one| one.is(FeedBeyondRapid::RULE)), ThreadBeyondRapid::RULE),
        (raised(|cause| matches!(cause, Cause::ThreadSpeed { .. })), ThreadAtSurfaceSpeed::RULE),
        (stopped, SpindleNeverStarts::RULE),
        (stopped, CutsBeforeSpindle::RULE),
        (offset, CutsWithoutOffset::RULE),
        (offset, NoOffsetAnywhere::RULE),
        (raised(|cause| matches!(cause, Cause::ThreadPassTooDeep { .. })), PassFarDeeper::RULE),
    ];
    said.into_iter().filter(|(said, _)| *said).map(|(_, rule)| rule).collect()
}

impl<'a> Following<'_, 'a> {
    /// What blocks without a motion have put in force.
    fn stood(&mut self, interpreter: &mut Interpreter<'_>, watch: &mut dyn FnMut(SimulationEvent<'_>)) {
        for stood in interpreter.stood().into_iter().filter(|_| !self.one.uncut) {
            if stood.control.tool != self.place {
                (self.place, self.turned) = (stood.control.tool, Some((stood.control.file, stood.line)));
                self.one.conditions.call(stood.control.tool);
            }
            watch(SimulationEvent::Stood(&stood, &self.one.simulation, interpreter.file(stood.control.file)));
        }
    }

    /// Makes a motion; breaks off where a budget ends.
    fn motion(
        &mut self,
        motion: &Motion,
        interpreter: &Interpreter<'_>,
        watch: &mut dyn FnMut(SimulationEvent<'_>),
    ) -> ControlFlow<()> {
        let control = *interpreter.in_force();
        let file = interpreter.file(control.file);
        if self.one.rows.len() == FOLLOWED_MOTIONS {
            return self.break_off(too_many(file, motion.line));
        }
        if self.one.uncut {
            self.unjudged = true;
            return ControlFlow::Continue(());
        }
        self.one.account.take(motion, &self.before);
        self.before = motion.machine;
        if let Some(fault) = self.given.without_zero(motion, &control)
            && self.without_zero.insert(control.system)
        {
            let fault = fault.placed(at_line(file, motion.line));
            self.last.get_or_insert_with(|| fault.place.clone());
            self.faults.told.push(fault);
        }
        let mut step = self.one.simulation.take(motion, &control);
        if self.one.simulation.is_spent() {
            return self.break_off(too_much_work(file, motion, self.one.rows.len()));
        }
        self.judge(&mut step, &control, interpreter);
        if !matches!(motion.kind, MotionKind::Rapid | MotionKind::Dwell(_)) {
            self.fed.entry(control.tool).or_insert_with(|| at_line(file, motion.line));
            self.see_feed(&step, file);
        }
        let drawn = &mut self.one.drawn;
        let paths = if motion.kind == MotionKind::Rapid { &mut drawn.rapid } else { &mut drawn.feed };
        if step.way.len() > 1 {
            paths.push(step.way.clone());
        }
        let source = self.one.source;
        self.one.conditions.take(&step);
        self.one.rows.push(&step, source.text(file).unwrap_or(&source.main));
        watch(SimulationEvent::Step(&step, &self.one.simulation, file));
        ControlFlow::Continue(())
    }

    /// The alarms of a motion, each at its block; none behind a block that was refused.
    fn judge(&mut self, step: &mut Step, control: &InForce, interpreter: &Interpreter<'_>) {
        self.in_force.judge(step);
        self.place = control.tool;
        // A change of tool is reported at its block.
        if let Some((file, line)) = self.turned.take() {
            let changes = step.alarms.iter_mut().filter(|one| matches!(one.cause, Cause::ToolChange(_)));
            changes.for_each(|one| (one.file, one.line, one.n) = (file, line, None));
        }
        if self.last.is_some() {
            step.alarms.clear();
            self.unjudged = true;
        }
        let other_offset = self.in_force.other_offset(control);
        for alarm in &step.alarms {
            let place = self.one.source.place(interpreter.file(alarm.file), alarm.line, Vec::new());
            self.one.alarms.push(Raised { alarm: *alarm, place, other_offset });
        }
    }

    /// A feed that an axis cannot follow, once for each tool.
    fn see_feed(&mut self, step: &Step, file: Option<&str>) {
        let (motion, Some(seconds)) = (&step.motion, step.seconds.filter(|&seconds| seconds > 0.0)) else { return };
        let by = motion.to.differences(&motion.from);
        let [x, z] = self.one.simulation.setup().lathe.rapid;
        let rates = [(Axis::X, x), (Axis::Z, z)];
        let beyond = rates.into_iter().find_map(|(axis, rapid)| {
            let way = match motion.kind {
                MotionKind::Arc(arc, _) => arc.length(0.0) * greatest_part(&arc, motion, axis),
                MotionKind::Thread(thread) => {
                    let distance = by[Axis::X as usize].abs().max(by[Axis::Z as usize].abs());
                    by[axis as usize].abs() * peak(distance, &thread)
                }
                _ => by[axis as usize].abs(),
            };
            let feed = way * 60.0 / seconds;
            (feed > rapid * (1.0 + 1e-9)).then_some((axis, feed, rapid))
        });
        if let Some((axis, feed, rapid)) = beyond
            && self.last.is_none()
            && self.too_fast.insert(step.control.tool)
        {
            let [feed, rapid] = [feed, rapid].map(|value| Size::feed(value, 0));
            self.faults.told.push(FeedBeyondRapid { feed, axis: axis.letter(), rapid }.at(at_line(file, motion.line)));
        }
    }

    fn break_off(&mut self, limit: Finding) -> ControlFlow<()> {
        self.one.endless = true;
        self.faults.told.insert(0, limit);
        ControlFlow::Break(())
    }

    /// A block that the control does not take.
    fn refused(&mut self, fault: Refused) {
        self.one.endless |= fault.exit == Exit::Limit;
        self.one.uncut |= fault.uncut;
        let in_cells = self.one.source.refused_together(&fault);
        let fault = Finding::from(fault);
        self.last.get_or_insert_with(|| fault.place.clone());
        self.faults.refused(fault, in_cells);
    }

    /// What can be told only when the program has ended.
    fn ended(
        self,
        interpreter: &Interpreter<'_>,
        held: Option<Finding>,
        watch: &mut dyn FnMut(SimulationEvent<'_>),
    ) -> Followed<'a> {
        let Following { mut one, given, mut faults, fed, last, unjudged, .. } = self;
        let source = one.source;
        if faults.more > 0 {
            faults.told.push(MoreRefusals { count: faults.more }.at(Place::File));
        }
        one.account.from_start = interpreter.from_start();
        one.files = (1..).map_while(|number| interpreter.file(number)).map(str::to_owned).collect();
        one.program.parts = source.whole(one.files.iter().map(String::as_str));
        let apart = told_apart(&one.alarms, &faults.told);
        faults.told.extend(interpreter.remarks().into_iter().filter(|one| !apart.iter().any(|rule| one.is(rule))));
        faults.told.extend(assumed(given, &Reached::by(interpreter)));
        faults.told.extend(interpreter.in_inches().then(|| InInches {}.at(Place::File)));
        if one.account.program.is_none() && last.is_none() && !one.endless && !one.uncut {
            faults.told.push(NoMotion {}.at(Place::File));
        }
        if last.is_none() && !one.endless && !one.uncut {
            let along = one
                .drawn
                .stock
                .iter()
                .flatten()
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[left, right], at| [left.min(at[0]), right.max(at[0])]);
            faults.told.extend(outside::contours(interpreter, &one.simulation, given, along));
        }
        let all = one.simulation.totals().all;
        let in_air = all.volume + all.parted <= 0.0 && all.seconds > all.rapid_seconds;
        if in_air && last.is_none() && !one.endless {
            faults.told.push(NothingCut {}.at(Place::File));
        }
        let tools = &one.simulation.totals().tools;
        let idle = |tool: &u32| tools.get(tool).is_some_and(|total| total.volume + total.parted <= 0.0);
        for (tool, place) in fed.into_iter().filter(|(tool, _)| idle(tool)) {
            if !in_air && last.is_none() && !one.endless {
                faults.told.push(ToolCutsNothing { tool }.at(place));
            }
        }
        if let Some(place) = last {
            one.lost = true;
            if unjudged {
                faults.told.push(unjudged_from(place));
            }
        }
        if let Some((file, line)) = one.simulation.cuts_on().filter(|_| !one.lost && !one.endless) {
            faults.told.push(CutsBehindParting {}.at(at_line(interpreter.file(file), line)));
        }
        faults.told.extend(held);
        one.repeated = one.simulation.repeated().unwrap_or_default();
        faults.told.extend((one.repeated > AGREE).then(|| not_repeated(one.repeated)));
        watch(SimulationEvent::End(&faults.told, &one.simulation));
        one.findings = faults.placed(source);
        one.drawn.part = one.simulation.product();
        one
    }
}

/// Tells the alarms that can be reported only when all programs have ended, and makes all alarms findings.
///
/// What a refused block left undone, or what lies behind the end of a budget, may have been what takes a mark away: of such a
/// program's marks, and of those on the part that it began with, none is reported.
pub(super) fn late(followed: &mut [Followed], given: &Given, watch: &mut dyn FnMut(SimulationEvent<'_>)) {
    let whole = |one: &Followed| !one.lost && !one.endless;
    for number in 0..followed.len() {
        let Some((one, behind)) = followed[number..].split_first_mut() else { continue };
        let lasting = match behind.first() {
            _ if !whole(one) => Vec::new(),
            None => one.simulation.lasting(),
            Some(next) => one.simulation.lasting_in(whole(next).then_some(&next.simulation)),
        };
        for alarm in lasting {
            let file = alarm.file.checked_sub(1).and_then(|at| one.files.get(at)).map(String::as_str);
            one.rows.late(&alarm);
            watch(SimulationEvent::Late(number, &alarm, file));
            let place = one.source.place(file, alarm.line, Vec::new());
            one.alarms.push(Raised { alarm, place, other_offset: None });
        }
        one.alarms.sort_by_key(|raised| raised.alarm.motion);
        one.findings.extend(alarms(&one.alarms, given));
    }
}
