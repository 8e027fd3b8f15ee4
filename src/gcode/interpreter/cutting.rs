//! What should be in force where a tool cuts: its length, a spindle that turns, a feed per revolution that can be one.
//!
//! A control asks for none of it, and cuts: each is a caution. What a lathe alone needs stands in `turned`.

use crate::finding::Size;
use crate::gcode::code::{G, Group, M};
use crate::gcode::in_force::Spindle;
use crate::gcode::interpreter::block::letter;
use crate::gcode::interpreter::library::Spot;
use crate::gcode::interpreter::{Reader, doubt};
use crate::gcode::motion::{FeedMode, MotionKind};
use crate::gcode::rules::modes::{
    CutsBeforeSpindle, CutsWithoutSpeed, FeedWordInRapid, GreatFeedPerTurn, LengthNotInForce, LengthOfAnother,
    SpindleStopped,
};
use crate::limits::GREATEST_FEED_PER_TURN;
use crate::machine::axis::{Axis, Pose};

/// A height that is the machine's 0, mm.
const SAME: f64 = 1e-9;

/// What a program has said of its spindle.
#[derive(Debug, Default)]
pub(super) struct SpindleSeen {
    /// M3, M4 or M5 has been programmed.
    pub(super) said: bool,
    /// S has been programmed.
    speed: bool,
    /// The first motion at feed before any of the three.
    cut_before: Option<Spot>,
    /// The first motion at feed, or along a thread, under M3 or M4 at a speed of 0.
    cut_still: Option<Spot>,
    /// What has come since the last M3, M4 or M5.
    run: SpindleRun,
    /// The last S was 0.
    zero: bool,
    /// What turns at it is a spindle, and no torch that M3 lights.
    no_torch: bool,
    /// M5 has been programmed.
    off: bool,
}

/// What a program has done since an M3, M4 or M5. A laser is on with S and off with S0 while M3 or M4 stays: in one run it is put off, on and
/// off again, or on, off and on. The spindle of a cutter never is. No laser goes down at feed without its beam, and none has a tool.
#[derive(Clone, Copy, Debug, Default)]
struct SpindleRun {
    /// The first cut at a speed of 0, and the first that goes down.
    still: Option<Spot>,
    down: Option<Spot>,
    /// The last that was seen of S: true where a cut was made with it, false where it was 0.
    lit: Option<bool>,
    /// How often the one has come behind the other.
    switched: u32,
}

impl SpindleRun {
    fn see(&mut self, lit: bool) {
        self.switched += u32::from(self.lit.replace(lit) == Some(!lit));
    }

    /// The first cut at a speed of 0, where it is no laser's.
    fn cut_still(self, cutter: bool) -> Option<Spot> {
        if cutter || self.switched < 2 { self.still } else { self.down }
    }
}

impl Reader<'_, '_> {
    /// Sees S in the block in hand. Beside M5 it puts out what M5 does.
    pub(super) fn see_speed(&mut self) {
        let zero = self.state.modal.speed <= 0.0;
        self.memory.seen.spindle.zero = zero;
        if zero && !matches!(self.block.m(7), Some((M::SpindleOff, _))) {
            self.memory.seen.spindle.run.see(false);
        }
    }

    /// A run of the spindle has ended.
    fn end_run_of_spindle(&mut self) {
        let modal = &self.state.modal;
        let cutter = self.memory.control.turns() || modal.tool != 0 || modal.lengthened;
        let still = std::mem::take(&mut self.memory.seen.spindle.run).cut_still(cutter);
        self.memory.seen.spindle.cut_still = self.memory.seen.spindle.cut_still.or(still);
    }

    /// Sees the codes of the spindle in the block in hand.
    pub(super) fn see_spindle(&mut self) {
        let code = self.block.m(7).map(|(code, _)| code);
        self.see_start_of_spindle(code);
        self.memory.seen.spindle.speed |= self.state.modal.speed > 0.0;
        self.memory.seen.spindle.off |= code == Some(M::SpindleOff);
        self.memory.seen.spindle.no_torch |= self.block.has(letter::S);
        if matches!(code, Some(M::Spindle(_) | M::SpindleOff)) {
            self.memory.seen.spindle.said = true;
            self.end_run_of_spindle();
            self.memory.seen.spindle.run.lit = self.memory.seen.spindle.zero.then_some(false);
        }
        if matches!(code, Some(M::Spindle(_))) {
            self.remark_cut_before_spindle();
        }
    }

    /// A cut that came before the program's first M3 or M4, where there is one, or an S. A program that speaks of no spindle at all is
    /// one of a machine without it, or with a switch for it.
    fn remark_cut_before_spindle(&mut self) {
        if let Some(spot) = self.memory.seen.spindle.cut_before.take() {
            self.memory.remarks.row(&CutsBeforeSpindle {}, spot, None);
        }
    }

    /// The program has ended: as a `whole`, or with a block that the control does not take and behind which nothing is known. What has been
    /// told at one end is not told at another.
    pub(super) fn end_spindle(&mut self, whole: bool) {
        let turns = self.memory.control.turns();
        // An S behind which no M stands has not been seen yet.
        self.memory.seen.spindle.speed |= self.state.modal.speed > 0.0;
        // Of a lathe whose spindle starts nowhere another caution speaks.
        let before = if turns { !whole && !self.memory.seen.turned.started } else { true };
        if self.memory.seen.spindle.speed && before {
            self.remark_cut_before_spindle();
        }
        self.memory.seen.spindle.cut_before = None;
        self.remark_cut_still(whole);
        self.end_turned(self.memory.seen.spindle.speed, whole);
    }

    /// A cut under M3 or M4 without a speed. A torch or a laser is lit by M3 for its cuts alone and put out by M5: a program without any S that
    /// makes no rapid motion with it on is one of those, and has no speed to say. No lathe is.
    fn remark_cut_still(&mut self, whole: bool) {
        self.end_run_of_spindle();
        let cut_still = self.memory.seen.spindle.cut_still.take();
        let SpindleSeen { no_torch, off, speed, .. } = &self.memory.seen.spindle;
        if let Some(spot) = cut_still
            && (*no_torch || *speed || whole && !*off || self.memory.control.turns())
        {
            self.memory.remarks.row(&CutsWithoutSpeed {}, spot, None);
        }
    }

    /// True where the spindle turns at no speed that the program has said. Of G96 without S another caution speaks.
    fn turns_without_speed(&self) -> bool {
        let modal = &self.state.modal;
        modal.spindle != Spindle::Stopped
            && modal.speed <= 0.0
            && !modal.constant_surface_speed
            && !self.in_doubt(doubt::SPINDLE | doubt::SPEED)
    }

    /// Sees a cut of a lathe before a spindle is started: the tool rams into the part at rest, or the control waits there for ever for
    /// the revolutions that the feed is per. What a bar is drawn out by comes behind M5.
    fn see_waiting_cut(&mut self) {
        if self.state.modal.spindle == Spindle::Stopped
            && !self.in_doubt(doubt::SPINDLE)
            && !self.memory.seen.turned.started
        {
            let spot = self.block.spot;
            self.memory.seen.spindle.cut_before.get_or_insert(spot);
        }
    }

    /// Sees a cut for its speed.
    fn see_cut_still(&mut self, to: &Pose) {
        if self.turns_without_speed() {
            let (spot, run) = (self.block.spot, &mut self.memory.seen.spindle.run);
            run.still.get_or_insert(spot);
            if to.get(Axis::Z) < self.state.at.get(Axis::Z) {
                run.down.get_or_insert(spot);
            }
        } else if self.state.modal.spindle != Spindle::Stopped && self.state.modal.speed > 0.0 {
            self.memory.seen.spindle.run.see(true);
        }
    }

    /// A block that gives F and goes in rapid because of a code of an earlier block may be meant at feed. It is told where it goes towards
    /// the part, or runs sideways below Z0, where the part is: a mill in X and Y, a lathe away from the axis as in a bore. Elsewhere F is
    /// often set for the next block.
    fn see_feed_word(&mut self, to: &Pose) {
        let block = &self.block;
        let bare = block.g(Group::Motion).is_none() && block.g(Group::NonModal).is_none();
        let modes = doubt::MOTION | doubt::UNIT | doubt::DISTANCE;
        if !bare || !block.has(letter::F) || self.state.modal.motion != G::Rapid || self.in_doubt(modes) {
            return;
        }
        // Where the tool stands is not known of an axis that a rejected block would have moved.
        let [by_x, by_y, by_z] = [Axis::X, Axis::Y, Axis::Z].map(|axis| !self.in_doubt(doubt::axis(axis)));
        let [from, to] = [&self.state.at, to].map(|pose| [Axis::X, Axis::Y, Axis::Z].map(|axis| pose.get(axis)));
        let [[x, y, z], [X, Y, Z]] = [from, to];
        let into = if self.memory.control.turns() {
            // The part is on either side of the axis.
            by_x && (X.abs() < x.abs() || x * X < 0.0 || X.abs() > x.abs() && by_z && z.max(Z) < 0.0)
        } else {
            by_z && z.min(Z) < 0.0 && (by_x && x != X || by_y && y != Y)
        };
        if by_z && Z < z || into {
            self.memory.remarks.row(&FeedWordInRapid {}, self.block.spot, None);
        }
    }

    /// Sees whether Z comes to stand at the machine's 0, or leaves it.
    fn see_home(&mut self, kind: MotionKind, to: &Pose) {
        let goes_home = kind == MotionKind::Rapid
            && matches!(self.block.g(Group::NonModal), Some(G::MachineCoordinates | G::Reference(_)))
            && (self.block.has(letter::Z) || !self.has_axes());
        if goes_home {
            self.state.modal.z_home = self.state.frame.to_machine(to).get(Axis::Z).abs() < SAME;
        } else if to.get(Axis::Z) != self.state.at.get(Axis::Z) {
            self.state.modal.z_home = false;
        }
    }

    /// True for a line in X and Y alone with Z at the machine's 0: the tool goes to its place there, and cuts nothing.
    fn goes_to_place(&self, kind: MotionKind, to: &Pose) -> bool {
        let across = |axis: &Axis| !matches!(axis, Axis::X | Axis::Y);
        matches!(kind, MotionKind::Feed(_))
            && self.state.modal.z_home
            && Axis::ALL.iter().filter(|axis| across(axis)).all(|axis| to.get(*axis) == self.state.at.get(*axis))
    }

    /// Sees whether what a motion at feed needs is in force.
    pub(super) fn see_cut(&mut self, kind: MotionKind, to: &Pose) {
        self.see_home(kind, to);
        let feed = match kind {
            MotionKind::Feed(feed) | MotionKind::Arc(_, feed) => feed,
            MotionKind::Rapid => {
                self.memory.seen.spindle.no_torch |= self.turns_without_speed();
                self.see_feed_word(to);
                return;
            }
            MotionKind::Thread(thread) => {
                self.see_cut_still(to);
                self.see_waiting_cut();
                self.see_thread(&thread, to);
                return;
            }
            MotionKind::Dwell(_) => return,
        };
        let moves = |rotary: bool| {
            let mut axes = Axis::ALL.iter().filter(|axis| axis.rotary() == rotary);
            axes.any(|axis| to.get(*axis) != self.state.at.get(*axis))
        };
        // A whole circle ends where it began.
        let along = moves(false) || matches!(kind, MotionKind::Arc(..));
        let turns = self.memory.control.turns();
        // The tool of a mill cuts the part that a rotary axis turns past it, too.
        if !along && (turns || !moves(true)) {
            return;
        }
        let spot = self.block.spot;
        if along
            && feed.mode == FeedMode::PerRevolution
            && feed.value > GREATEST_FEED_PER_TURN
            && !self.in_doubt(doubt::FEED)
        {
            let row = GreatFeedPerTurn { feed: Size { value: feed.value, unit: "mm/rev", decimals: 3 } };
            self.memory.remarks.row(&row, spot, None);
        }
        self.see_cut_still(to);
        if turns {
            self.see_waiting_cut();
            self.see_turned();
            return;
        }
        if self.state.modal.spindle == Spindle::Stopped && !self.in_doubt(doubt::SPINDLE) {
            if !self.memory.seen.spindle.said {
                self.memory.seen.spindle.cut_before.get_or_insert(spot);
            } else if feed.mode != FeedMode::PerRevolution {
                self.memory.remarks.row(&SpindleStopped {}, spot, None);
            }
        }
        if self.in_doubt(doubt::TOOL | doubt::LENGTH) || self.goes_to_place(kind, to) {
            return;
        }
        if self.length_waits() {
            self.see_waiting_length(spot);
        } else {
            self.see_length(spot);
        }
    }

    /// Sees whether the length in force is the tool's own, as the tool table has it.
    fn see_length(&mut self, spot: Spot) {
        let tool = self.state.modal.tool;
        let Some(own) = self.memory.tools.get(&tool).map(|own| own.offset) else { return };
        if self.state.frame.tool == own {
            return;
        }
        match self.state.modal.length_of {
            Some(other) if other != tool => {
                self.memory.remarks.row(&LengthOfAnother { tool, other }, spot, None);
            }
            None if !self.state.modal.lengthened => self.memory.remarks.row(&LengthNotInForce { tool }, spot, None),
            // G43.1 and G43.2 say lengths of the program's own.
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::gcode::control::LINUXCNC;
    use crate::gcode::interpreter::{Interpreter, Setting, ToolOffset, Tools};
    use crate::machine::axis::Axis;

    /// The codes of what is remarked of a program, over a table of T1, 50 mm long, T2, 80 mm, and T3 without a length.
    fn remarked(program: &str) -> Vec<&'static str> {
        let tool = |length: f64| {
            let mut tool = ToolOffset::default();
            tool.offset.set(Axis::Z, length);
            tool
        };
        let mut setting = Setting::new(&LINUXCNC);
        setting.tools = Some(Tools::from([(1, tool(50.0)), (2, tool(80.0)), (3, tool(0.0))]));
        let mut interpreter = Interpreter::over(program.as_bytes(), setting);
        assert!(interpreter.by_ref().all(|motion| motion.is_ok()), "{program}");
        interpreter.remarks().iter().map(|finding| finding.code()).filter(|code| code.starts_with("G05")).collect()
    }

    #[test]
    fn a_tool_of_the_table_cuts_with_its_own_length_or_it_is_told() {
        for (blocks, told) in [
            ("T1 M6|M3|G43|G0 Z5|G1 Z-2", &[][..]),
            ("T1 M6|M3|G43 H0|G0 Z5|G1 Z-2", &[]),
            ("T3 M6|M3|G0 Z5|G1 Z-2", &[]),
            ("T1 M6|M3|G43.1 Z12|G0 Z5|G1 Z-2", &[]),
            ("T1 M6|M3|G0 Z5|G1 Z-2", &["G0528"]),
            // At the machine's 0 of Z a feed in X and Y is on its way to the part.
            ("G53 G0 Z0|T1 M6|M3|G1 X50 Y5|G0 G43 Z5 H1|G1 Z-2", &[]),
            ("G91 G28 Z0|G90|T1 M6|M3|G1 X50|Y5|G43 H1|G0 Z5|G1 Z-2|G53 G0 Z0|T2 M6|M3|G1 X9|G0 G43 H2 Z5|G1 Z-2", &[]),
            ("G28|T1 M6|M3|G1 X50", &[]),
            ("G53 G0 Z0|T1 M6|M3|G1 X50 Z-1", &["G0528"]),
            ("G53 G0 Z0|T1 M6|M3|G2 X2 Y0 I1 J0", &["G0528"]),
            ("G53 G0 Z0|T1 M6|M3|G0 Z5|G1 X50", &["G0528"]),
            ("G53 G0 Z-1|T1 M6|M3|G1 X50", &["G0528"]),
            ("G53 G0 X0|T1 M6|M3|G1 X50", &["G0528"]),
            ("G0 Z0|T1 M6|M3|G1 X50", &["G0528"]),
            ("T1 M6|M3|G43|G0 Z5|G49|G1 Z-2", &["G0528"]),
            ("T1 M6|M3|G0 Z5|G81 X9 R2 Z-3", &["G0528"]),
            ("T1 M6|M3|G0 Z-2|G1 A90", &["G0528"]),
            ("T1 M6|M3|G43 H2|G0 Z5|G1 Z-2", &["G0529"]),
            ("T1 M6|M3|G43|G0 Z5|T2 M6|M3|G1 Z-2", &["G0529"]),
            ("T1 M6|M3|G43|G0 Z5|T2 M6|M3|G43|G1 Z-2", &[]),
            ("T1 M6|M3|G43.1 Z50|G0 Z5|T2 M6|M3|G1 Z-2", &["G0529"]),
            ("T1 M6|M3|G43|G0 Z5|T2 M6|M3|G43.2 H1|G1 Z-2", &["G0529"]),
            ("T1 M6|M3|G43|G43.2 H3|G0 Z5|G1 Z-2", &[]),
            // M72 gives back whether a length is taken up.
            ("T1 M6|M3|M70|G43 H1|G0 Z50|M72|G1 Z-2", &["G0528"]),
            ("T1 M6|M3|G43|M70|G49|M72|G1 Z-2", &[]),
            ("T1 M6|M3|G43|M70|G49|M72|T2 M6|M3|G1 Z-2", &["G0529"]),
        ] {
            let program = format!("G21 G90 G98 S900 F100\n{}\nM2\n", blocks.replace('|', "\n"));
            assert_eq!(remarked(&program), told, "{blocks}");
        }
    }

    #[test]
    fn a_block_with_f_that_goes_in_rapid_towards_the_part_is_told() {
        for (blocks, told) in [
            ("G0 X5 Z2|Z-3 F50", &["G0570"][..]),
            ("G0 X5 Z2 F50|Z-3", &[]),
            ("G0 X5 Z2|G0 Z-3 F50", &[]),
            ("G0 X5 Z2|X9 F50|Z4 F50", &[]),
            ("G0 X5 Z2|F50|Z-3", &[]),
            ("G0 X5 Z2|G91 Z-3 F50", &["G0570"]),
            ("G0 X5 Z2|G53 G0 Z-3 F50", &[]),
            ("S900 M3|G0 Z2|G81 X1 Z-3 R1 F50|X2 F60", &[]),
            ("S900 M3|G1 X5 Z2|Z-3 F50", &[]),
            // Sideways below the part's zero.
            ("G0 X-10 Y0 Z5|Z-3|X60 F300", &["G0570"]),
            ("G0 X-10 Y0 Z5|Z-3|Y60 F300", &["G0570"]),
            ("G0 X-10 Y0 Z5|Z-3|X60 Z5 F300", &["G0570"]),
            ("G0 X-10 Y0 Z5|Z-3|G0 X60 F300", &[]),
            ("G0 X-10 Y0 Z5|Z-3|Z5 F300", &[]),
            ("G0 X-10 Y0 Z5|Z-3|F300|X60", &[]),
            ("G0 X-10 Y0 Z0|X60 F300", &[]),
        ] {
            let program = format!("G21 G90 G98 S900 F100\n{}\nM2\n", blocks.replace('|', "\n"));
            assert_eq!(remarked(&program), told, "{blocks}");
        }
    }

    #[test]
    fn dwells_beyond_a_minute_are_told_once_with_the_longest_of_them() {
        for blocks in ["G4 P60", "S900 M3|G0 Z5|G82 Z-1 R2 P0.5"] {
            assert!(remarked(&format!("G21 G90 F100\n{}\nM2\n", blocks.replace('|', "\n"))).is_empty(), "{blocks}");
        }
        let program = b"G21 G90 F100\nG4 P500\nS900 M3\nG0 Z5\nG82 Z-1 R2 P1000\nX5\nG80\nM2\n";
        let mut interpreter = Interpreter::over(program, Setting::new(&LINUXCNC));
        assert!(interpreter.by_ref().all(|motion| motion.is_ok()));
        let told: Vec<_> = interpreter.remarks().into_iter().filter(|finding| finding.code() == "G0533").collect();
        assert_eq!(told.len(), 1, "{told:?}");
        let expected = "dwell of 1000 s: P counts seconds on this control; 3 such dwells, the longest in line 5";
        assert_eq!(told[0].what.en, expected);
    }

    #[test]
    fn a_cut_asks_for_a_spindle_that_turns() {
        for (blocks, told) in [
            ("S900 M3|G1 X1", &[][..]),
            ("G1 X1", &[]),
            ("S900 M3|G0 X1|M5|G0 X2|M3|G1 X3", &[]),
            ("S900|G1 X1", &["G0530"]),
            ("G1 X1|M3 S900|G1 X2", &["G0530"]),
            ("M3|G0 X1|M5|G0 X2|M3|G1 X3", &["G0538"]),
            ("M3|G1 X1", &["G0538"]),
            ("S0 M3|G1 X1|M5", &["G0538"]),
            ("M4 S0|G1 X1|S900|G1 X2|M5", &["G0538"]),
            ("S900 M3|G1 X1|S0|G1 X2|M5", &["G0538"]),
            ("M3|S900|G1 X1", &[]),
            // A laser is put off by S0 while M3 or M4 stays.
            ("M4 S0|G0 X0|G1 X1 S500|G0 X2 S0|G1 X3 S500|G1 X4 S0|M5", &[]),
            ("M3 S0|G0 X0|G1 X1 S200|G1 X2 S0|G1 X3 S200|M5", &[]),
            ("M3|S0|G0 X0|G1 Y5|S900|G1 X1|S0|G0 Y6|G1 Y5|S900|G1 X2|S0|G0 Y6", &[]),
            ("M3 S0|G0 X0|G1 Y5|S900|G1 X1|S0|M5", &[]),
            // No laser goes down without its beam, or has a tool or its length.
            ("M3|S0|G0 X0|G1 Z-5|S900|G1 X1|S0|G0 Z6|G1 Z-5|S900|G1 X2|S0|G0 Z6", &["G0538"]),
            ("M3 S0|G0 X0|G1 Z-5|S900|G1 X1|S0|M5", &["G0538"]),
            ("S900 M3|G1 X1|S0 M0|G0 X2|G1 Z-5|X3|G0 Z6|S900|G1 X4|M5", &["G0538"]),
            ("T1 M6|M3 S900|G1 X1|S0|G1 X2|S900|G1 X3|M5", &["G0528", "G0538"]),
            ("G43.1 Z9|M3 S900|G1 X1|S0|G1 X2|S900|G1 X3|M5", &["G0538"]),
            ("M3 S0|G0 X0|G1 Z-5|S900|G1 X1|S0|M5|M3|G1 X2|M5", &["G0538"]),
            ("M3 S0|G0 X0|G1 Z-5|S900|G1 X1|S0 M5", &["G0538"]),
            ("M3|G0 X0|G1 Z-5|S900|G1 X1|S0|M5", &["G0538"]),
            ("S900 M3|G1 X1|M5|S0 M3|G1 X2|M5|S900 M3|G1 X3|M5", &["G0538"]),
            ("S900 M3|G1 X1|S0|G0 X2|G1 X3|M5", &["G0538"]),
            // The tool may stand in the part that turns.
            ("M3|G0 X1|G1 A90", &["G0538"]),
            ("M3|S900|G0 Z-2|G1 A90", &[]),
            ("S900|G0 Z-2|G1 A90|M3", &["G0530"]),
            ("S900 M3|G95 F12|G1 A90", &[]),
            ("M3|G0 X1|G2 I5", &["G0538"]),
            // A torch: lit for its cuts alone.
            ("G0 X1|M3|G4 P1|G1 X2|M5|G0 X9|M3|G1 X3|M5", &[]),
            ("G0 X1|M3|G4 P1|G1 X2|G0 X9|G1 X3|M5", &["G0538"]),
            ("S900 M3|G1 X1|M5|G1 X2", &["G0531"]),
            ("S900 M3|G1 X1|M19 R0|G1 X2", &["G0531"]),
            ("S900 M3|G1 X1|T1 M6|G43|G1 X2", &["G0531"]),
            ("S900 M3|G1 X1|M5|G0 A90", &[]),
            ("S900 M3|G1 X1|M5|G1 A90", &["G0531"]),
            ("S900 M3|G95 F12|G1 X1", &["G0532"]),
            ("S900 M3|G95 F6|G1 X1", &[]),
        ] {
            let program = format!("G21 G90 F100\n{}\nM2\n", blocks.replace('|', "\n"));
            assert_eq!(remarked(&program), told, "{blocks}");
        }
    }
}
