//! The codes of a block in the order in which they are obeyed, and those beside the motion: feed, speed, spindle, coolant, dwell, units.

use crate::finding::Grade;
use crate::gcode::code::{G, Group, M};
use crate::gcode::control::{DwellUnit, DwellWord, FeedChange, SpeedLimit};
use crate::gcode::in_force::{InForce, Spindle};
use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block::letter;
use crate::gcode::interpreter::doubt;
use crate::gcode::interpreter::execute::one_shot;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::motion::{FeedMode, MotionKind};
use crate::gcode::rules::modes::{
    DwellNegative, DwellOfNoTime, DwellTwice, DwellWithoutTime, MachineMoveIncremental, NoSpeedLimit,
    SurfaceSpeedMissing,
};
use crate::gcode::rules::words::{DwellNotWhole, OrientWord};
use crate::gcode::turning::pace::Pace;
use crate::limits::LONGEST_DWELL;
use crate::machine::axis::Axis;
use crate::machine::length_unit::LengthUnit;

impl Reader<'_, '_> {
    /// Obeys the codes of the block in hand, and its own `motion` behind them, in the order of the control.
    pub(super) fn execute_codes(&mut self, motion: Option<G>) -> Result<()> {
        let unit_first = self.memory.control.order.unit_first();
        if unit_first {
            self.take_unit();
        }
        self.begin_codes()?;
        let at_once = self.block.g(Group::NonModal);
        if let Some(G::Plane(plane)) = self.block.g(Group::Plane) {
            self.state.modal.plane = plane;
        }
        if !unit_first {
            self.doubt_unit(motion)?;
            self.take_unit();
        }
        self.codes_of_the_tool()?;
        self.codes_of_words();
        if let Some(code) = at_once {
            self.code_at_once(code)?;
        }
        if let Some(code) = self.block.g(Group::SetPosition) {
            self.change_position(code);
        }
        if let Some(code) = at_once.filter(|code| *code != G::Dwell) {
            self.behind_code_at_once(code);
        }
        if let Some(motion) = motion {
            self.make_motion(motion)?;
        }
        if self.memory.control.order.off_last() {
            self.machine_codes_after()?;
        }
        self.codes_of_flow()
    }

    /// How the tool is led: compensation of its radius, its length, and the system that its path is told in.
    #[inline]
    fn codes_of_the_tool(&mut self) -> Result<()> {
        match self.block.g(Group::CutterCompensation) {
            Some(code) if self.memory.control.radius.cutter() => self.cutter_compensation(code)?,
            Some(G::Compensation(side)) => self.set_compensation(side)?,
            _ => {}
        }
        self.length_across_plane()?;
        if let Some(code) = self.block.g(Group::ToolLength) {
            self.tool_length(code)?;
        }
        if let Some(G::WorkOffset(system)) = self.block.g(Group::WorkOffset) {
            if self.shifts_system() {
                self.shift_system(system);
            } else {
                if self.memory.control.offsets.preset_ends() {
                    self.end_preset();
                }
                self.select_system(system);
            }
        }
        Ok(())
    }

    /// What words of coordinates, of centres and of a cycle's heights say from here on.
    #[inline]
    fn codes_of_words(&mut self) {
        match self.block.g(Group::Distance) {
            Some(G::Absolute) => self.state.modal.incremental = false,
            Some(G::Incremental) => self.state.modal.incremental = !self.memory.control.axes.by_letters(),
            _ => {}
        }
        match self.block.g(Group::Centre) {
            Some(G::CentreAbsolute) => self.state.modal.centre_absolute = true,
            Some(G::CentreIncremental) => self.state.modal.centre_absolute = false,
            _ => {}
        }
        match self.block.g(Group::Retract) {
            Some(G::ReturnInitial) => self.state.modal.return_initial = Some(true),
            Some(G::ReturnR) => self.state.modal.return_initial = Some(false),
            _ => {}
        }
    }

    /// A code that counts in its own block alone.
    fn code_at_once(&mut self, code: G) -> Result<()> {
        match code {
            G::SetOffsets => self.set_offsets(),
            G::Reference(second) => self.reference_point(second),
            G::SetReference(second) => {
                self.keep_reference(second);
                Ok(())
            }
            G::LocalOffset => {
                self.local_offset();
                Ok(())
            }
            G::SetPosition => {
                self.no_length_due()?;
                self.set_position();
                Ok(())
            }
            G::SetPositionOrSpeed => {
                self.no_length_due()?;
                self.set_position_or_speed()
            }
            G::Turning(cycle) => self.turning(cycle),
            G::MachineCoordinates if self.state.modal.incremental => {
                Err(Refused::of(&MachineMoveIncremental {}, &[self.block.g_column(Group::NonModal)]))
            }
            G::MachineCoordinates => self.no_rotary_length(false),
            _ => Ok(()),
        }
    }

    /// A code that counts in its own block alone ends the passes of a turning cycle; a motion code beside it is in force from here on.
    fn behind_code_at_once(&mut self, code: G) {
        self.state.modal.pass = None;
        let under = self.block.g(Group::Motion).filter(|_| one_shot(code));
        if let Some(under) = under.filter(|_| self.memory.control.order.motion_beside()) {
            self.begin_motion(under);
            self.state.modal.motion = under;
        }
    }

    /// The end of the program, calls and returns.
    #[inline]
    fn codes_of_flow(&mut self) -> Result<()> {
        match self.block.m(4) {
            Some((M::End, _)) => {
                self.finish_run()?;
                self.see_unreached(false);
                self.end()
            }
            Some((M::Call | M::CallBlock | M::Return, _)) => {
                self.finish_run()?;
                self.call_or_return()
            }
            _ => Ok(()),
        }
    }

    pub(super) fn set_speed_mode(&mut self) -> Result<()> {
        match self.block.g(Group::Speed) {
            Some(G::ConstantSurfaceSpeed) => {
                if !self.block.has(letter::S) {
                    self.surface_speed_missing()?;
                }
                self.state.modal.constant_surface_speed = true;
                match self.memory.control.spindle.limit {
                    SpeedLimit::Word => self.state.modal.greatest_speed = self.block.get(letter::D),
                    SpeedLimit::Code => {}
                }
                if self.state.modal.greatest_speed.is_none() && !self.in_doubt(doubt::SPEED) {
                    let spot = self.block.spot;
                    self.memory.remarks.row(&NoSpeedLimit {}, spot, Some(self.block.g_column(Group::Speed)));
                }
            }
            Some(G::Rpm) => {
                if self.memory.control.spindle.turns.part() && self.state.modal.constant_surface_speed {
                    // Without S the spindle keeps the speed that it has.
                    let turning = InForce { spindle: Spindle::Clockwise, ..self.state.modal.in_force() };
                    let pace = Pace::of(&turning, self.memory.setting.greatest_speed);
                    self.state.modal.speed =
                        pace.and_then(|pace| pace.speed(self.state.at.get(Axis::X))).unwrap_or(0.0);
                }
                self.state.modal.constant_surface_speed = false;
            }
            _ => {}
        }
        Ok(())
    }

    /// G96 without S: a lathe takes the S that follows.
    fn surface_speed_missing(&mut self) -> Result<()> {
        let column = self.block.g_column(Group::Speed);
        if !self.memory.control.spindle.turns.part() {
            return Err(Refused::of(&SurfaceSpeedMissing {}, &[column]));
        }
        if !self.state.modal.constant_surface_speed {
            self.state.modal.speed = 0.0;
            let spot = self.block.spot;
            self.memory.remarks.row_as(Grade::Caution, &SurfaceSpeedMissing {}, spot, Some(column));
        }
        Ok(())
    }

    pub(super) fn take_feed_and_speed(&mut self) -> Result<()> {
        // They are parameters of the cycle.
        if self.in_letter_cycle() {
            return Ok(());
        }
        if let Some(F) = self.block.get(letter::F) {
            self.state.modal.feed = match self.state.modal.feed_mode {
                FeedMode::PerMinute | FeedMode::PerRevolution => self.state.modal.unit.to_mm(F),
                FeedMode::InverseTime | FeedMode::Seconds => F,
            };
            self.state.modal.feed_word = F;
            self.state.modal.feed_stale = false;
            self.state.modal.feed_unit = None;
            self.state.modal.feed_earlier = None;
        }
        if let Some(S) = self.block.get(letter::S) {
            let limit = matches!(self.block.g(Group::NonModal), Some(G::SetPositionOrSpeed));
            if !limit {
                self.state.modal.speed = self.surface(S);
                self.see_speed();
            }
        }
        Ok(())
    }

    /// An S word in m/min or rpm: under constant surface speed feet a minute where the unit is the inch.
    pub(super) fn surface(&self, S: f64) -> f64 {
        let by_surface = self.memory.control.spindle.turns.part() && self.state.modal.constant_surface_speed;
        let feet = by_surface && self.state.modal.unit == LengthUnit::Inch;
        if feet { S * 0.3048 } else { S }
    }

    /// G94 and G95, G98 and G99 of a lathe: what F means.
    #[deny(clippy::wildcard_enum_match_arm)]
    pub(super) fn set_feed_mode(&mut self, mode: FeedMode) {
        let changes = mode != self.state.modal.feed_mode;
        self.state.modal.feed_mode = mode;
        self.memory.seen.units.feed_said = true;
        match self.memory.control.feed.change {
            FeedChange::Forgets if mode != FeedMode::InverseTime => {
                (self.state.modal.feed, self.state.modal.feed_word) = (0.0, 0.0);
                self.state.modal.feed_earlier = None;
            }
            FeedChange::Forgets => {}
            FeedChange::KeepsStale => self.state.modal.feed_stale |= changes && self.state.modal.feed > 0.0,
        }
    }

    pub(super) fn machine_codes(&mut self) -> Result<()> {
        self.inputs_and_outputs()?;
        if let Some((code @ (M::ToolChange | M::SetTool), _)) = self.block.m(6) {
            self.change_tool(code)?;
        }
        self.see_spindle();
        match self.block.m(7) {
            Some((M::Spindle(true), _)) => self.state.modal.spindle = Spindle::Clockwise,
            Some((M::Spindle(false), _)) => self.state.modal.spindle = Spindle::CounterClockwise,
            Some((M::SpindleOff, _)) if !self.memory.control.order.off_last() => {
                self.state.modal.spindle = Spindle::Stopped
            }
            Some((code @ (M::SaveState(_) | M::ForgetState | M::RestoreState), _)) => self.context_code(code)?,
            Some((M::SpindleOrient, _)) => {
                self.orient_words()?;
                // It holds the spindle until M3, M4 or M5.
                self.state.modal.spindle = Spindle::Stopped;
            }
            _ => {}
        }
        if let Some((M::Coolant(on), _)) = self.block.m(8)
            && (on || !self.memory.control.order.off_last())
        {
            self.state.modal.coolant = on;
        }
        Ok(())
    }

    /// M19: the angle R, the way round P and the longest wait Q, as LinuxCNC has them.
    fn orient_words(&self) -> Result<()> {
        let block = &self.block;
        let wrong = |letter: usize, range: &'static str, fits: &dyn Fn(f64) -> bool| {
            let value = block.get(letter).filter(|&value| !fits(value))?;
            let row = OrientWord { letter: char::from(b'A' + u8::try_from(letter).unwrap_or(0)), value, range };
            Some(Refused::of(&row, &[block.column(letter)]))
        };
        let fault = wrong(letter::R, "0 … 360", &|R| (0.0..=360.0).contains(&R))
            .or_else(|| wrong(letter::P, "0, 1, 2", &|P| P == 0.0 || P == 1.0 || P == 2.0))
            .or_else(|| wrong(letter::Q, "> 0", &|Q| Q > 0.0));
        fault.map_or(Ok(()), Err)
    }

    /// What a lathe does after the motion of the block: spindle and coolant off.
    pub(super) fn machine_codes_after(&mut self) -> Result<()> {
        let off = matches!(self.block.m(7), Some((M::SpindleOff, _)));
        let dry = matches!(self.block.m(8), Some((M::Coolant(false), _)));
        if off || dry {
            self.finish_run()?;
            self.state.modal.spindle = if off { Spindle::Stopped } else { self.state.modal.spindle };
            self.state.modal.coolant &= !dry;
        }
        Ok(())
    }

    pub(super) fn dwell(&mut self) -> Result<()> {
        if self.dwells_alone() {
            let (spot, column) = (self.block.spot, self.block.g_column(Group::NonModal));
            self.memory.remarks.row(&DwellOfNoTime {}, spot, Some(column));
            self.end_length_by_dwell();
            return Ok(());
        }
        let (word, seconds) = self.dwell_time()?;
        let letter = word.index();
        if seconds == 0.0 && self.memory.control.lexis.lone_dwell.runs() {
            // No page at hand parts it from a lone G4, and it is no dwell.
            self.end_length_by_dwell();
        }
        if !word.shared {
            self.block.take(letter);
        }
        self.see_dwell(word.letter, word.unit, seconds);
        self.emit(MotionKind::Dwell(seconds), self.state.at, Some(seconds));
        Ok(())
    }

    /// True where G4 stands without a time, and without words that could be meant for one, and the control runs it so.
    fn dwells_alone(&self) -> bool {
        let lexis = &self.memory.control.lexis;
        let words = self.block.present & !lexis.free.mask();
        lexis.lone_dwell.runs() && words == 0 && self.block.g(Group::Motion).is_none()
    }

    /// Remarks a dwell beyond a minute whose letter counts seconds: it may be meant in milliseconds.
    pub(super) fn see_dwell(&mut self, letter: char, unit: DwellUnit, seconds: f64) {
        if !unit.whole() && seconds > LONGEST_DWELL {
            self.memory.remarks.dwelt(self.block.spot, letter, seconds);
        }
    }

    /// The word of a dwell's time, and the time in seconds.
    pub(super) fn dwell_time(&self) -> Result<(DwellWord, f64)> {
        let found =
            self.memory.control.lexis.dwell.iter().find_map(|dwell| Some((*dwell, self.block.get(dwell.index())?)));
        let column = self.block.g_column(Group::NonModal);
        let times = self.memory.control.lexis.dwell.iter().filter(|dwell| self.block.has(dwell.index())).count();
        if times > 1 {
            return Err(Refused::of(&DwellTwice {}, &[column]));
        }
        match found {
            None => Err(Refused::of(&DwellWithoutTime {}, &[column])),
            Some((dwell, number)) if number < 0.0 => {
                Err(Refused::of(&DwellNegative {}, &[self.block.column(dwell.index())]))
            }
            Some((dwell @ DwellWord { letter, unit, .. }, value)) if unit.whole() && value.fract() != 0.0 => {
                let at = self.block.column(dwell.index());
                Err(Refused::of(&DwellNotWhole { letter, value, unit: unit.seconds(), number: 4 }, &[at]))
            }
            Some((dwell, number)) => Ok((dwell, dwell.seconds(number))),
        }
    }

    pub(super) fn set_unit(&mut self, unit: LengthUnit) {
        let column = self.block.g_column(Group::Units);
        self.memory.seen.units.tell(self.block.spot, column);
        // The numbers of a cycle in force stay as they are written, and so does the height that it began at: they count in the new
        // unit from here on (LinuxCNC's interp_convert.cc, convert_length_units, scales none of them).
        let scale = unit.to_mm(1.0) / self.state.modal.unit.to_mm(1.0);
        let sticky = &mut self.state.modal.sticky;
        let lengths = [&mut sticky.r, &mut sticky.bottom, &mut sticky.q].into_iter().chain(&mut sticky.ijk);
        lengths.chain(&mut sticky.initial).for_each(|length| *length *= scale);
        self.state.modal.unit = unit;
    }
}
