//! Executing a block: the order of LinuxCNC's reference, and straight motions.
//!
//! # References
//! LinuxCNC, G-code overview, "G-code order of execution".

use crate::finding::Raise;
use crate::gcode::code::{G, Group, M, SinglePassCycle};
use crate::gcode::control::RadiusRule;
use crate::gcode::in_force::{Compensation, Spindle};
use crate::gcode::interpreter::block::{AXES, letter};
use crate::gcode::interpreter::corner::without_line;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::interpreter::{Reader, doubt};
use crate::gcode::letters::Letters;
use crate::gcode::motion::{Feed, FeedMode, Motion, MotionKind};
use crate::gcode::rules::modes::{
    AxesClaimedTwice, AxesWithCancel, AxesWithoutMotion, CycleWithoutAxes, DwellBesideAxes, FeedMissing,
    FeedPerTurnWithoutSpeed, InverseTimeWithoutF, InverseTimeZero, MachineMoveWithoutAxes, MachineMoveWithoutMotion,
    NoFeed, SpindleStill, SpindleStops, ThreadStartAngle, WordWithoutUse,
};
use crate::gcode::rules::words::{CycleInOneBlock, DwellBesideArc, TaperByOtherLetter};
use crate::machine::axis::{Axis, Pose};

const AXIS_WORDS: u32 = Letters::of("ABCUVWXYZ").mask();
const CENTRE_WORDS: u32 = Letters::of("IJK").mask();

/// What the motion word of a block comes to.
struct Plan {
    /// The motion to make, if any.
    motion: Option<G>,
    /// Letters that some code of the block uses.
    used: u32,
}

/// What stands in a block beside its motion code.
struct Beside {
    /// Whether there is any other code.
    other: bool,
    /// The code that is obeyed once.
    at_once: Option<G>,
    /// The code of the tool length.
    length: Option<G>,
    /// It takes the axis words as lengths of the tool.
    given: bool,
    /// Letters that are the time of a dwell.
    dwell: u32,
    /// Axis words.
    axes: u32,
    /// The axis words shift the system.
    shifts: bool,
    /// The axis words are for another code than the motion's.
    takes_axes: bool,
}

impl Reader<'_, '_> {
    /// Executes the block in hand.
    pub(super) fn execute(&mut self) -> Result<()> {
        self.corner_goes_on();
        self.count_block();
        if let Some((M::Call | M::CallBlock | M::Return, _)) = self.block.m(4) {
            self.calls_alone()?;
        }
        if self.memory.control.axes.by_letters() {
            self.one_word_an_axis()?;
            self.no_increments()?;
        }
        self.axes_of_lathe()?;
        let plan = self.plan()?;
        self.rotary_words()?;
        self.take_square_edge(plan.motion)?;
        self.edge_fits(plan.motion)?;
        let idle = self.block.present & !plan.used & !self.memory.control.lexis.free.mask();
        if idle != 0 {
            return Err(self.unused(idle));
        }
        let compensated = self.block.g(Group::CutterCompensation).is_some();
        if self.memory.control.radius.cutter() && (compensated || self.state.modal.compensation != Compensation::Off) {
            self.beside_cutter(plan.motion)?;
        }
        if self.block.groups & !(1 << Group::Motion as u16) != 0 || self.block.has_machine_codes() {
            self.execute_codes(plan.motion)
        } else {
            self.take_feed_and_speed()?;
            self.take_tool()?;
            plan.motion.map_or(Ok(()), |motion| self.make_motion(motion))
        }
    }

    /// The codes that a block obeys first, in their order: what the speed and the feed mean, F and S, T, M, the dwell.
    pub(super) fn begin_codes(&mut self) -> Result<()> {
        self.set_speed_mode()?;
        if let Some(G::Feed(mode)) = self.block.g(Group::Feed) {
            self.set_feed_mode(mode);
        }
        self.take_feed_and_speed()?;
        self.take_tool()?;
        self.machine_codes()?;
        if self.block.g(Group::NonModal) == Some(G::Dwell) {
            self.dwell()?;
        }
        Ok(())
    }

    /// Which motion the block makes, and which letters its codes use.
    fn plan(&self) -> Result<Plan> {
        let block = &self.block;
        let explicit = block.g(Group::Motion);
        let other = block.groups & !(1 << Group::Motion as u16) != 0 || block.has_machine_codes();
        let at_once = if other { block.g(Group::NonModal) } else { None };
        let length = if other { block.g(Group::ToolLength) } else { None };
        // A dwell may carry its time on an axis letter.
        let dwell: u32 = if at_once == Some(G::Dwell) {
            self.memory.control.lexis.dwell.iter().map(|dwell| 1 << dwell.index()).sum::<u32>() & block.present
        } else {
            0
        };
        let axes = block.present & AXIS_WORDS & !dwell;
        if axes != 0
            && self.memory.control.lexis.dwell.iter().any(|word| 1 << word.index() & AXIS_WORDS != 0)
            && at_once == Some(G::Dwell)
        {
            return Err(Refused::of(&DwellBesideAxes {}, &[block.g_column(Group::NonModal)]));
        }
        let shifts = self.shifts_system();
        let takes_axes = at_once.is_some_and(G::takes_axes) || shifts;
        if dwell & (1 << letter::P) != 0
            && matches!(explicit, Some(G::Arc(_)))
            && self.memory.control.arcs.letters.mask() & (1 << letter::P) != 0
        {
            return Err(Refused::of(&DwellBesideArc {}, &[block.g_column(Group::NonModal)]));
        }
        let given = matches!(length, Some(G::ToolLengthGiven | G::ToolLengthAdded));
        let beside = Beside { other, at_once, length, given, dwell, axes, shifts, takes_axes };
        let motion = self.planned_motion(&beside)?;
        if axes == 0 && matches!(at_once, Some(G::LocalOffset | G::SetPosition)) {
            return Err(self.position_without_axes());
        }
        let by_rapid = self.memory.control.machine_move.by_itself()
            && explicit.is_none_or(|code| matches!(code, G::Rapid | G::Linear));
        if at_once == Some(G::MachineCoordinates) && !by_rapid && !matches!(motion, Some(G::Rapid | G::Linear)) {
            let at = [block.g_column(Group::NonModal)];
            if axes == 0 && matches!(self.state.modal.motion, G::Rapid | G::Linear) {
                return Err(Refused::of(&MachineMoveWithoutAxes {}, &at));
            }
            return Err(Refused::of(&MachineMoveWithoutMotion {}, &at).hanging_on(doubt::MOTION));
        }
        Ok(Plan { motion, used: self.letters_used(motion, &beside) })
    }

    /// The motion that the block makes: that of its own code, or the one in force where its words are for one.
    fn planned_motion(&self, beside: &Beside) -> Result<Option<G>> {
        let Beside { at_once, given, dwell, axes, takes_axes, .. } = *beside;
        let block = &self.block;
        Ok(match block.g(Group::Motion) {
            // G80 ends a cycle; the motion code that was in force before it is so again.
            Some(G::Cancel) if axes != 0 && !takes_axes => {
                let under = self.motion_behind_cancel();
                return under.map_or_else(|| Err(self.axes_without_use(&AxesWithCancel {})), |under| Ok(Some(under)));
            }
            Some(G::Cancel) => Some(G::Cancel),
            // The axis words are the one-shot code's; the motion code is in force from here on.
            Some(G::Rapid | G::Linear | G::Arc(_))
                if self.memory.control.order.motion_beside() && at_once.is_some_and(one_shot) =>
            {
                None
            }
            Some(_) if takes_axes => {
                return Err(Refused::of(
                    &AxesClaimedTwice {},
                    &[block.g_column(Group::NonModal), block.g_column(Group::Motion)],
                ));
            }
            Some(G::Cycle(cycle)) if axes == 0 => {
                return Err(Refused::of(&CycleWithoutAxes { cycle: cycle.number() }, &[block.g_column(Group::Motion)]));
            }
            Some(motion) => Some(motion),
            None if takes_axes || (given && axes != 0) => None,
            None if axes != 0 && self.state.modal.motion == G::Cancel && at_once != Some(G::MachineCoordinates) => {
                return Err(self.axes_without_use(&AxesWithoutMotion {}));
            }
            None if axes != 0 => Some(self.state.modal.motion),
            None if block.has(letter::R) && matches!(self.state.modal.motion, G::Pass(_)) && at_once.is_none() => {
                Some(self.state.modal.motion)
            }
            None if block.present & !dwell & CENTRE_WORDS != 0 && matches!(self.state.modal.motion, G::Arc(_)) => {
                Some(self.state.modal.motion)
            }
            None => None,
        })
    }

    /// Letters that the motion uses, and the codes beside it.
    fn letters_used(&self, motion: Option<G>, beside: &Beside) -> u32 {
        let Beside { other, at_once, length, given, dwell, shifts, takes_axes, .. } = *beside;
        let mut used = dwell;
        let turning = matches!(at_once, Some(G::Turning(_)));
        if shifts {
            used |= Letters::of("XZ").mask();
        }
        if motion.is_some_and(|motion| motion != G::Cancel) || (takes_axes && !turning && !shifts) || given {
            used |= AXIS_WORDS;
        }
        used |= match motion {
            Some(G::Arc(_)) => self.memory.control.arcs.letters.mask(),
            Some(G::Cycle(cycle)) => self.memory.control.drilling.letters(cycle).mask(),
            Some(G::Pass(SinglePassCycle::Thread)) => {
                Letters::of("R").mask() | self.memory.control.spindle.thread_angle.letters().mask()
            }
            Some(G::Pass(_)) => Letters::of("R").mask(),
            Some(G::Thread(false)) => self.memory.control.spindle.thread_angle.letters().mask(),
            Some(G::Thread(true)) => Letters::of("K").mask(),
            _ => 0,
        };
        if other {
            used |= self.words_of_codes(at_once, length);
        }
        used
    }

    /// Letters that codes beside the motion use.
    fn words_of_codes(&self, at_once: Option<G>, length: Option<G>) -> u32 {
        let mut used = match at_once {
            Some(G::SetOffsets) => Letters::of("LPRQIJ").mask(),
            Some(G::Turning(cycle)) => cycle.letters().mask(),
            Some(G::Reference(true)) => self.memory.control.reference.letters().mask(),
            _ => 0,
        };
        if matches!(length, Some(G::ToolLength | G::ToolLengthAdded)) {
            used |= self.memory.control.length.letters().mask();
        }
        used |= match self.block.g(Group::CutterCompensation) {
            Some(G::Compensation(side)) if self.memory.control.radius.cutter() && side != Compensation::Off => {
                Letters::of("D").mask()
            }
            Some(G::CompensationGiven(_)) => Letters::of("DL").mask(),
            _ => 0,
        };
        if self.block.g(Group::Path) == Some(G::PathTolerance) {
            used |= Letters::of("PQ").mask();
        }
        if self.block.g(Group::Speed) == Some(G::ConstantSurfaceSpeed) {
            used |= Letters::of("D").mask();
        }
        if let Some((M::User, _)) = self.block.m(10) {
            used |= Letters::of("PQ").mask();
        }
        used |= match self.block.m(5) {
            Some((M::Output, _)) => Letters::of("P").mask(),
            Some((M::Input, _)) => Letters::of("PELQ").mask(),
            Some((M::AnalogOutput, _)) => Letters::of("EQ").mask(),
            _ => 0,
        };
        if let Some((M::Override, 50..)) = self.block.m(9) {
            used |= Letters::of("P").mask();
        }
        if let Some((M::SetTool, _)) = self.block.m(6) {
            used |= Letters::of("Q").mask();
        }
        if let Some((M::SpindleOrient, _)) = self.block.m(7) {
            used |= Letters::of("RPQ").mask();
        }
        match self.block.m(4) {
            Some((M::Call | M::CallBlock, _)) => used |= Letters::of("PL").mask(),
            Some((M::Return, _)) if self.memory.control.calls.by.beside_motion() => used |= Letters::of("P").mask(),
            _ => {}
        }
        used
    }

    fn axes_without_use(&self, row: &dyn Raise) -> Box<Refused> {
        let column = AXES.into_iter().find(|&axis| self.block.has(axis)).map_or(0, |axis| self.block.column(axis));
        Refused::of(row, &[column]).hanging_on(doubt::MOTION)
    }

    pub(super) fn unused(&self, idle: u32) -> Box<Refused> {
        let index = idle.trailing_zeros() as usize;
        let name = char::from(b'A' + u8::try_from(index).unwrap_or(0));
        let motion = self.block.g(Group::Motion).unwrap_or(self.state.modal.motion);
        if let Some(G::Turning(cycle)) = self.block.g(Group::NonModal)
            && matches!(name, 'I' | 'K')
            && !self.in_letter_cycle()
        {
            return Refused::of(&CycleInOneBlock { letter: name, number: cycle.number() }, &[self.block.column(index)]);
        }
        let meant = match (motion, name) {
            (G::Pass(pass), 'I' | 'K') => {
                let row = TaperByOtherLetter { letter: name, number: pass.number() };
                Some(Refused::of(&row, &[self.block.column(index)]))
            }
            (G::Linear, 'I' | 'K' | 'R') if self.memory.control.corners.by_words() => {
                Some(without_line(&name.to_string(), self.block.column(index)))
            }
            // R alone beside X or Z may be a slip; Q is an angle, and R without a coordinate a radius.
            (G::Rapid | G::Linear | G::Arc(_), 'Q' | 'R')
                if self.memory.control.lexis.polar.by_letters()
                    && (idle & Letters::of("Q").mask() != 0 || !self.has_axes()) =>
            {
                Some(self.polar_by_letters(name, self.block.column(index)))
            }
            (G::Thread(_), 'Q') => Some(Refused::of(&ThreadStartAngle {}, &[self.block.column(index)])),
            _ => None,
        };
        if let Some(fault) = meant {
            return fault;
        }
        Refused::of(&WordWithoutUse { letter: name }, &[self.block.column(index)]).hanging_on(doubt::MOTION)
    }

    pub(super) fn make_motion(&mut self, motion: G) -> Result<()> {
        let moves = motion != G::Cancel && self.block.present & AXIS_WORDS != 0;
        self.memory.seen.distances[usize::from(self.state.modal.incremental)] |= moves;
        if !matches!(motion, G::Cycle(_)) {
            self.state.modal.sticky.initial = None;
        }
        self.begin_motion(motion);
        self.straight_behind_cutter(motion);
        if matches!(motion, G::Rapid | G::Linear | G::Arc(_)) {
            self.take_up_length(motion)?;
        }
        match motion {
            _ if self.memory.control.machine_move.by_itself()
                && self.block.g(Group::NonModal) == Some(G::MachineCoordinates) =>
            {
                // Fanuc's G53 moves at rapid whatever is in force, which is so again afterwards.
                self.state.modal.motion = self.block.g(Group::Motion).unwrap_or(self.state.modal.motion);
                if self.block.present & AXIS_WORDS != 0 {
                    let to = self.end_point();
                    self.emit(MotionKind::Rapid, to, None);
                }
                Ok(())
            }
            G::Rapid | G::Linear => {
                let feed = if motion == G::Linear { Some(self.feed()?) } else { None };
                self.state.modal.motion = motion;
                if self.block.present & AXIS_WORDS == 0 && !self.memory.out.milling.takes_bare_lines() {
                    return Ok(());
                }
                let to = self.end_point();
                match feed {
                    None => self.emit(MotionKind::Rapid, to, None),
                    Some(feed) if self.memory.control.corners.by_words() => return self.line_at_feed(to, feed),
                    Some(feed) => {
                        let seconds = self.straight_seconds(&to, feed);
                        self.emit(MotionKind::Feed(feed), to, seconds);
                    }
                }
                Ok(())
            }
            G::Arc(clockwise) => self.arc(clockwise),
            G::Cycle(cycle) => self.drill(cycle),
            G::Thread(changing) => self.thread(changing),
            G::Pass(pass) => self.pass(pass),
            G::Cancel if self.memory.control.cancel.restores() => {
                self.state.modal.motion = self.state.modal.under_cycle();
                Ok(())
            }
            _ => {
                self.state.modal.motion = G::Cancel;
                Ok(())
            }
        }
    }

    /// The feed in force, for a motion at feed.
    pub(super) fn feed(&mut self) -> Result<Feed> {
        self.feed_has_unit()?;
        let mode = self.state.modal.feed_mode;
        match mode {
            FeedMode::InverseTime | FeedMode::Seconds if self.block.get(letter::F).is_none_or(|F| F <= 0.0) => {
                let fault = if self.block.has(letter::F) {
                    Refused::of(&InverseTimeZero {}, &[])
                } else {
                    Refused::of(&InverseTimeWithoutF {}, &[])
                };
                return Err(fault.hanging_on(doubt::FEED));
            }
            FeedMode::PerMinute | FeedMode::PerRevolution if self.state.modal.feed <= 0.0 => {
                if self.memory.control.feed.missing.refused() || self.block.has(letter::F) {
                    return Err(Refused::of(&FeedMissing {}, &[]).hanging_on(doubt::FEED));
                }
                if !self.in_doubt(doubt::FEED | doubt::MOTION) {
                    self.memory.remarks.row(&NoFeed {}, self.block.spot, None);
                }
            }
            FeedMode::PerRevolution if self.state.modal.speed <= 0.0 && self.memory.control.feed.missing.refused() => {
                return Err(Refused::of(&SpindleStill {}, &[]).hanging_on(doubt::SPEED));
            }
            FeedMode::PerRevolution if self.state.modal.speed <= 0.0 && !self.in_doubt(doubt::SPEED) => {
                self.memory.remarks.row(&FeedPerTurnWithoutSpeed {}, self.block.spot, None);
            }
            _ => {}
        }
        if mode == FeedMode::PerRevolution {
            self.remark_standing_spindle();
        }
        if !self.in_doubt(doubt::FEED) {
            self.memory.see_feed(mode, self.block.spot);
        }
        self.remark_feed_before_unit();
        if self.state.modal.feed_stale {
            self.remark_stale_feed();
        }
        Ok(Feed { mode, value: self.state.modal.feed })
    }

    /// A motion that goes by revolutions, with a spindle that the program has stopped. One that it has not spoken of may turn.
    pub(super) fn remark_standing_spindle(&mut self) {
        let stands = self.state.modal.spindle == Spindle::Stopped && self.memory.seen.spindle.said;
        if stands && !self.in_doubt(doubt::SPINDLE) {
            self.memory.remarks.row(&SpindleStops {}, self.block.spot, None);
        }
    }

    /// Where the axis words of the block lead, in program coordinates.
    pub(super) fn end_point(&mut self) -> Pose {
        let unit = self.state.modal.unit;
        let machine = self.block.groups & (1 << Group::NonModal as u16) != 0
            && self.block.g(Group::NonModal) == Some(G::MachineCoordinates);
        self.memory.seen.in_machine |= machine;
        let mut to = if machine { self.state.frame.to_machine(&self.state.at) } else { self.state.at };
        for (letter, axis) in AXES.into_iter().zip(Axis::ALL) {
            if let Some(word) = self.block.get(letter) {
                let value = if axis.rotary() { word } else { unit.to_mm(word) };
                let value = self.memory.control.axes.coordinate(axis, value);
                if let Some(onto) = self.memory.control.axes.increment(axis) {
                    to.set(onto, self.state.at.get(onto) + self.memory.control.axes.coordinate(onto, value));
                } else if self.state.modal.incremental && !machine {
                    to.set(axis, self.state.at.get(axis) + value);
                } else if axis.rotary() {
                    let at = self.turned_to(axis, value, to.get(axis));
                    to.set(axis, at);
                } else {
                    to.set(axis, value);
                }
            }
        }
        if self.memory.control.turns() && !machine && to.get(Axis::X) < 0.0 {
            self.remark_beyond_axis(&to);
        }
        if machine { self.state.frame.to_program(&to) } else { to }
    }

    /// The time of a straight motion at feed.
    pub(super) fn straight_seconds(&self, to: &Pose, feed: Feed) -> Option<f64> {
        if self.by_revolution(feed) {
            return self.turned_seconds(to, feed);
        }
        let length = self.memory.control.feed.path.length(&to.differences(&self.state.at), self.state.modal.unit);
        self.seconds(length, feed)
    }

    /// The time of a path of a length.
    pub(super) fn seconds(&self, length: f64, feed: Feed) -> Option<f64> {
        let value = feed.value;
        let seconds = match feed.mode {
            FeedMode::PerMinute => length * 60.0 / value,
            FeedMode::InverseTime => 60.0 / value,
            FeedMode::Seconds => value,
            FeedMode::PerRevolution if self.state.modal.constant_surface_speed => return None,
            FeedMode::PerRevolution => length * 60.0 / (value * self.state.modal.speed),
        };
        seconds.is_finite().then_some(seconds)
    }

    /// Hands a motion out and stands at its end.
    #[deny(clippy::wildcard_enum_match_arm)]
    pub(super) fn emit(&mut self, kind: MotionKind, to: Pose, seconds: Option<f64>) {
        self.see_turn(kind, &to);
        self.see_start(kind, &to);
        if Axis::ALL.into_iter().any(|axis| !axis.rotary() && to.get(axis) != self.state.at.get(axis)) {
            self.memory.see_unit(self.state.modal.unit, self.block.spot);
        }
        self.see_cut(kind, &to);
        let motion = Motion {
            line: self.block.spot.line,
            n: self.block.spot.n,
            kind,
            from: self.state.at,
            to,
            machine: self.state.frame.to_machine(&to),
            seconds,
        };
        self.state.at = to;
        self.moved();
        match self.memory.control.radius {
            RadiusRule::Nose(_) => self.hand_out(motion),
            RadiusRule::Cutter if !self.memory.out.milling.idle() => self.mill(motion),
            RadiusRule::Cutter | RadiusRule::None => {
                self.memory.out.queue.push_back(Ok((motion, self.state.modal.in_force(), self.made())));
            }
        }
    }
}

/// True for codes of Fanuc beside which a motion code may stand: it comes in force behind them.
pub(super) const fn one_shot(code: G) -> bool {
    matches!(code, G::Reference(_) | G::SetPositionOrSpeed)
}
