//! Tool lengths of a control whose G43 waits for the next motion of Z.
//!
//! # References
//! Fagor CNC 8055 M, programming manual, p. 144: G43 on, G44 off; the value is L + K of offset D, or of the offset bound to the tool
//! where there is no D; it is applied when the longitudinal axis next moves; the axis is the one across the plane. P. 109: a lone G4
//! cancels the length in force; whether the next motion takes it up again no page says, and G4 of a time of 0 is taken alike. CNC
//! 8070, programming manual (Ref. 1709), p. 240: the length is the selected tool's, of its offset D, or of D1 where none is selected.
//! Of an increment
//! that meets a change of the length, of G53 under G43, and of the moment at which the offset of a T without D counts no page was
//! at hand: they are refused or told.

use crate::gcode::code::{G, Group};
use crate::gcode::interpreter::block::letter;
use crate::gcode::interpreter::library::Spot;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::interpreter::{Reader, doubt};
use crate::gcode::motion::Plane;
use crate::gcode::rules::modes::{
    LengthByMotion, LengthChangesLater, LengthEnded, LengthLeftOver, LengthNotInForce, LengthNotKnown,
    LengthOfOtherOffset, LengthOfSelected, LengthOverEnd, LengthPlane, MachineMoveWithLength,
};
use crate::gcode::turning::rules::OffsetNotInTable;
use crate::machine::axis::{Axis, Pose};
use crate::machine::work_offset::ActiveOffsets;
use crate::text::{Text, t};

/// The offset of a tool that counts where no D names another.
const FIRST_OF_TOOL: u32 = 1;

/// The offset whose length G43 takes up.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Offset {
    /// Its number.
    number: u32,
    /// The program has said it, by D or by a tool.
    said: bool,
    /// The number of a T without D that no M6 has brought yet.
    selected: Option<u32>,
}

/// What a lone G4 has left of the length that was in force.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Left {
    /// All of it: there was no such G4, or Z has taken the length up again since.
    #[default]
    Whole,
    /// It is cancelled, and G43 is not programmed anew.
    Ended,
    /// It is cancelled, and G43 waits for the next motion of Z.
    Anew,
}

impl Reader<'_, '_> {
    /// True where the length of a tool counts from the next motion of Z on.
    pub(super) fn length_waits(&self) -> bool {
        let control = self.memory.control;
        control.tool.offsets_by_codes() && control.length.waits_for_motion()
    }

    /// D and T of the block in hand: D is the offset from here on, a T without D brings its own with M6.
    ///
    /// # Errors
    /// Of a D that is no number of an offset.
    pub(super) fn take_offset(&mut self) -> Result<()> {
        if !self.length_waits() {
            return Ok(());
        }
        match (self.block.get(letter::D), self.block.get(letter::T)) {
            (Some(D), _) => {
                let number = self.number_of(letter::D, D)?;
                self.state.modal.tool_offset = Offset { number, said: true, selected: None };
            }
            (None, Some(_)) => self.state.modal.tool_offset.selected = self.state.modal.selected,
            (None, None) => {}
        }
        Ok(())
    }

    /// M6 has brought the tool that T selected, and with it its offset where no D has named another.
    pub(super) fn bring_offset(&mut self) {
        if let Some(tool) = self.state.modal.tool_offset.selected.take() {
            let number = if self.memory.control.length.of_tool() { FIRST_OF_TOOL } else { tool };
            self.state.modal.tool_offset = Offset { number, said: true, selected: None };
        }
    }

    /// G43 and G44: what the next motion of Z takes up.
    pub(super) fn await_length(&mut self, code: G) {
        let on = code == G::ToolLength;
        self.state.modal.lengthened = on;
        let ended = self.state.modal.length_left != Left::Whole;
        self.state.modal.length_left = if on && ended { Left::Anew } else { Left::Whole };
        if !on || self.state.modal.tool_offset.said {
            return;
        }
        if let Some(number) = self.state.modal.tool_offset.selected {
            (self.state.modal.tool_offset.number, self.state.modal.tool_offset.said) = (number, true);
        } else if !self.in_doubt(doubt::TOOL) {
            let (spot, column) = (self.block.spot, self.block.g_column(Group::ToolLength));
            self.memory.remarks.row(&LengthLeftOver {}, spot, Some(column));
        }
    }

    /// Refuses G43 in a plane other than XY, and another plane under G43: the length would go along another axis.
    pub(super) fn length_across_plane(&self) -> Result<()> {
        let plane = self.state.modal.plane;
        let on = match self.block.g(Group::ToolLength) {
            Some(code) => code == G::ToolLength,
            None => self.state.modal.lengthened && self.block.g(Group::Plane).is_some(),
        };
        if !on || plane == Plane::XY || !self.length_waits() {
            return Ok(());
        }
        let group = if self.block.g(Group::Plane).is_some() { Group::Plane } else { Group::ToolLength };
        Err(Refused::of(&LengthPlane { plane: plane.name() }, &[self.block.g_column(group)]))
    }

    /// The offset that the next motion of Z brings, where it is another than the one in force; 0 for none.
    fn length_due(&self) -> Option<u32> {
        let modal = &self.state.modal;
        let wanted = if modal.lengthened { modal.tool_offset.number } else { 0 };
        (wanted != modal.length_of.unwrap_or(0) || modal.length_left != Left::Whole).then_some(wanted)
    }

    /// A lone G4 cancels the length that is in force or waits for Z, unless it is known to be 0.
    pub(super) fn end_length_by_dwell(&mut self) {
        let modal = &self.state.modal;
        if !self.length_waits() || !modal.lengthened {
            return;
        }
        let lengths = [modal.tool_offset.number, modal.length_of.unwrap_or(0)].map(|number| self.length_of(number));
        if lengths != [Some(Pose::default()); 2] {
            self.state.modal.length_left = Left::Ended;
        }
    }

    /// The length of an offset; `None` where no table says it.
    fn length_of(&self, number: u32) -> Option<Pose> {
        let mut length = Pose::default();
        if number != 0 {
            self.memory.setting.tools.as_ref()?;
            length.set(Axis::Z, self.memory.tools.get(&number)?.offset.get(Axis::Z));
        }
        Some(length)
    }

    /// Takes up the length before a motion with Z; other motions leave it waiting.
    ///
    /// # Errors
    /// Of Z in machine coordinates under G43, and of Z behind a lone G4 that has cancelled the length; and where a length is to be taken
    /// up, of an offset that the table does not hold and of a Z whose end hangs on the length.
    pub(super) fn take_up_length(&mut self, motion: G) -> Result<()> {
        if !self.length_waits() || !self.block.has(letter::Z) {
            return Ok(());
        }
        let (due, at) = (self.length_due(), self.block.column(letter::Z));
        let on = self.state.modal.lengthened || self.state.modal.length_of.is_some();
        if on && self.block.g(Group::NonModal) == Some(G::MachineCoordinates) {
            return Err(Refused::of(&MachineMoveWithLength {}, &[at]));
        }
        if self.state.modal.length_left == Left::Ended {
            return Err(Refused::of(&LengthEnded {}, &[at]).hanging_on(doubt::axis(Axis::Z)));
        }
        if self.state.modal.lengthened
            && let Some(tool) = self.state.modal.tool_offset.selected
        {
            self.memory.remarks.row(&LengthOfSelected { tool }, self.block.spot, Some(at));
        }
        let Some(number) = due else { return Ok(()) };
        let length = self.length_of(number);
        if length.is_none() && self.memory.setting.tools.is_some() {
            return Err(Refused::of(&OffsetNotInTable { offset: number }, &[at]));
        }
        // Without a change of the height it is all one how the control moves.
        let whole = self.state.modal.length_left == Left::Whole;
        let same = whole && length == Some(self.state.frame.tool) && self.length_in_force_is_known();
        let what = match motion {
            G::Arc(_) => Some(t("arco con Z", "arc with Z")),
            _ if self.state.modal.incremental => Some(t("Z incremental", "incremental Z")),
            _ => None,
        };
        if let Some(what) = what.filter(|_| !same) {
            return Err(self.hangs_on_length(what));
        }
        self.offset_of(number);
        self.reframe(ActiveOffsets { tool: length.unwrap_or_default(), ..self.state.frame });
        self.state.modal.length_of = Some(number).filter(|number| *number != 0);
        self.state.modal.length_left = Left::Whole;
        Ok(())
    }

    /// False where the length in force is one that no table says.
    fn length_in_force_is_known(&self) -> bool {
        self.state.modal.length_of.is_none_or(|number| self.length_of(number).is_some())
    }

    /// Refuses G92 with Z where a length is to be taken up.
    pub(super) fn no_length_due(&self) -> Result<()> {
        if self.length_waits() && self.block.has(letter::Z) && self.length_due().is_some() {
            return Err(self.hangs_on_length(t("G92 con Z", "G92 with Z")));
        }
        Ok(())
    }

    /// The program has come to its end under G43.
    pub(super) fn end_length(&mut self) {
        if self.length_waits() && self.state.modal.lengthened {
            self.memory.remarks.row(&LengthOverEnd {}, self.block.spot, None);
        }
    }

    fn hangs_on_length(&self, what: Text) -> Box<Refused> {
        // Behind such a Z it is not known where Z is, and the next one follows from that.
        Refused::of(&LengthByMotion { what }, &[self.block.column(letter::Z)]).hanging_on(doubt::axis(Axis::Z))
    }

    /// Sees whether a motion at feed has the length of its tool.
    pub(super) fn see_waiting_length(&mut self, spot: Spot) {
        let modal = &self.state.modal;
        if let Some(due) = self.length_due() {
            let lengths = (self.length_of(due), self.length_of(modal.length_of.unwrap_or(0)));
            if modal.length_left != Left::Whole || !matches!(lengths, (Some(due), Some(now)) if due == now) {
                self.memory.remarks.row(&LengthChangesLater {}, spot, None);
            }
            return;
        }
        if self.memory.control.length.of_tool() {
            self.see_length_of_tool(spot);
            return;
        }
        let number = if modal.tool_offset.said { modal.tool_offset.number } else { modal.tool };
        if modal.lengthened || self.length_of(number).is_none_or(|own| own == Pose::default()) {
            return;
        }
        let tool = modal.tool;
        self.memory.remarks.row(&LengthNotInForce { tool }, spot, None);
    }

    /// The same on a control whose D is an offset of the tool's own, where no code takes a length up: the table holds one length for
    /// each tool, which is that of D1.
    fn see_length_of_tool(&mut self, spot: Spot) {
        let modal = &self.state.modal;
        // Before the first M6 the tool that T names is the one that the program means.
        let tool = if modal.tool == 0 { modal.selected.unwrap_or(0) } else { modal.tool };
        let offset = if modal.tool_offset.said { modal.tool_offset.number } else { FIRST_OF_TOOL };
        if tool == 0 || offset == 0 || self.memory.setting.tools.is_none() {
            return;
        }
        if offset != FIRST_OF_TOOL {
            self.memory.remarks.row(&LengthOfOtherOffset { tool, offset }, spot, None);
        } else if self.length_of(tool).is_some_and(|own| own != Pose::default()) {
            self.memory.remarks.row(&LengthNotKnown { tool }, spot, None);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::gcode::control::{Control, FAGOR_8055, FAGOR_8070, LINUXCNC, LengthWord, Lexis};
    use crate::gcode::interpreter::{Interpreter, Setting, ToolOffset, Tools};
    use crate::gcode::letters::Letters;
    use crate::machine::axis::Axis;

    /// Blocks parted by `|`, over offsets 1, 50 mm long, 2, 80 mm, and 3 without a length, or over no table: where the machine's Z goes, and
    /// the codes of what is told, rejections first.
    fn read(control: &'static Control, blocks: &str, table: bool) -> (Vec<f64>, Vec<&'static str>) {
        let tool = |length: f64| {
            let mut tool = ToolOffset::default();
            tool.offset.set(Axis::Z, length);
            tool
        };
        let program = format!("G71 G90 G17 G94 F100 S900 M3\n{}\nM30\n", blocks.replace('|', "\n"));
        let mut setting = Setting::new(control);
        setting.tools = table.then(|| Tools::from([(1, tool(50.0)), (2, tool(80.0)), (3, tool(0.0))]));
        let mut interpreter = Interpreter::over(program.as_bytes(), setting);
        let (mut heights, mut codes) = (Vec::new(), Vec::new());
        for item in &mut interpreter {
            match item {
                Ok(motion) => heights.push(motion.machine.get(Axis::Z)),
                Err(fault) => codes.push(fault.rule.code),
            }
        }
        // That a program ends under G43 has a test of its own.
        let remarks = interpreter.remarks();
        codes.extend(remarks.iter().map(crate::finding::Finding::code).filter(|code| *code != "G0548"));
        (heights, codes)
    }

    #[test]
    fn a_length_counts_from_the_next_motion_of_z_on() {
        for (blocks, heights) in [
            ("T1 D1|M6|G43|G0 X5|Z10|X9|G1 Z-2", &[0.0, 60.0, 60.0, 48.0][..]),
            // T and D stand behind the motion of their block, and count for it.
            ("G0 G43 X5 Z10 T1 D1 M6|G1 Z-2", &[60.0, 48.0]),
            ("T1 D1|M6|G43 G0 Z10|G91 Z-3", &[60.0, 57.0]),
            // D alone, and a tool's own offset where there is no D.
            ("T1 D2|M6|G43 G0 Z10|G1 Z-2", &[90.0, 78.0]),
            ("T2 M6|G43 G0 Z10|G1 Z-2", &[90.0, 78.0]),
            ("T1 D1|M6|G43 G0 Z10|T2 D2|M6|G0 X5|Z10|G1 Z-2", &[60.0, 60.0, 90.0, 78.0]),
            ("T1 D1|M6|G43 G0 Z10|T2 M6|Z10|D1|Z10", &[60.0, 90.0, 60.0]),
            ("T1 D1|M6|G43 G0 Z10|G44|X5|Z20", &[60.0, 60.0, 20.0]),
            ("T1 D1|M6|G43 G0 Z10|G44 Z20|G43|D0|Z10", &[60.0, 20.0, 10.0]),
            ("G44|T1 D3|M6|G0 Z10|G1 Z-2", &[10.0, -2.0]),
            // Without a change of the length an increment is what it says.
            ("T1 D3|M6|G43|G91 G0 Z5", &[5.0]),
            ("T1 D1|M6|G43 G0 Z10|G44|G43|G91 Z5", &[60.0, 65.0]),
        ] {
            assert_eq!(read(&FAGOR_8055, blocks, true), (heights.to_vec(), vec![]), "{blocks}");
        }
    }

    #[test]
    fn behind_a_lone_g4_a_length_is_taken_up_anew_or_ended() {
        for (blocks, heights) in [
            ("T1 D1|M6|G43 G0 Z10|G4|G43 Z5|G91 Z-3", &[60.0, 55.0, 52.0][..]),
            ("T1 D1|M6|G43 G0 Z10|G4|G44 Z20", &[60.0, 20.0]),
            ("T1 D1|M6|G43 G0 Z10|G4|G0 X5|G43|Z10", &[60.0, 60.0, 60.0]),
        ] {
            assert_eq!(read(&FAGOR_8055, blocks, true), (heights.to_vec(), vec!["G0540"]), "{blocks}");
        }
    }

    #[test]
    fn what_hangs_on_a_length_that_is_not_known_is_refused_or_told() {
        for (blocks, table, codes) in [
            ("T1 D1|M6|G43 G0 Z10|G1 Z-2", false, &["G0825"][..]),
            ("T1 D0|M6|G43 G0 Z10|G1 Z-2", false, &[]),
            ("T1 D1|M6|G43|G91 G0 Z10", true, &["G0542"]),
            ("T1 D1|M6|G43|G91 G0 Z10", false, &["G0542"]),
            ("T1 D1|M6|G43|G91 G0 Z10|Z5|Z-2", true, &["G0542", "G0344"]),
            ("T1 D1|M6|G43 G0 Z10|G44|G91 Z10", false, &["G0542", "G0825"]),
            ("T1 D1|M6|G43|G0 X0|G2 X10 Y0 Z-1 R5", true, &["G0542"]),
            ("T1 D1|M6|G43|G92 Z10", true, &["G0542"]),
            ("T1 D1|M6|G43|G53 G0 Z10", true, &["G0543"]),
            ("T1 D1|M6|G43|G53 G0 X10", true, &[]),
            ("T1 D1|M6|G18|G43", true, &["G0541"]),
            ("T1 D9|M6|G43 G0 Z10", true, &["G0833"]),
            ("G43 G0 Z10", true, &["G0545"]),
            ("T1 D1|M6|G43 G0 Z10|T2|Z5", true, &["G0546"]),
            ("T1|G43 G0 Z10", true, &["G0546"]),
            // A lone G4 cancels the length; without one there is nothing to cancel.
            ("T1 D1|M6|G43 G0 Z10|G4|G1 Z-2", true, &["G0550", "G0540"]),
            ("T1 D1|M6|G43 G0 Z10|G4|G1 Z-2", false, &["G0550", "G0825", "G0540"]),
            ("T1 D1|M6|G43|G4|G0 Z10", true, &["G0550", "G0540"]),
            ("T1 D1|M6|G43 G0 Z10|G4|D2|G0 Z10", true, &["G0550", "G0540"]),
            ("T1 D1|M6|G43 G0 Z10|G4|G92 Z0", true, &["G0542", "G0540"]),
            ("T1 D1|M6|G43 G0 Z10|G4|G43|G91 Z5", true, &["G0542", "G0540"]),
            ("T1 D1|M6|G43 G0 Z10|G4|G43|G4|Z5", true, &["G0550", "G0540"]),
            ("T1 D1|M6|G43 G0 Z10|G4|G1 X5", true, &["G0544", "G0540"]),
            ("T3 D3|M6|G43 G0 Z10|G4|G1 Z-2", true, &["G0540"]),
            ("T1 D1|M6|G0 Z60|G4|G0 Z50", true, &["G0540"]),
            ("T1 D1|M6|G43 G0 Z10|G4 K50|G0 Z50", true, &[]),
            ("T1 D1|M6|G43 G0 Z10|G4 K0|G0 Z50", true, &["G0550"]),
            // The tool is not in the table: what follows from that is not told beside.
            ("T9|M6|G43 G0 X5", true, &["G0821"]),
        ] {
            assert_eq!(read(&FAGOR_8055, blocks, table).1, codes, "{blocks}");
        }
    }

    #[test]
    fn the_offset_of_a_tool_on_an_8070_is_told_by_its_tool() {
        let program = "%A\nG71 G90 G94 F100 S900 M3\nT2 D1 M6\nG0 Z5\nG1 Z-2\nM30\n";
        let tool = |length: f64| {
            let mut tool = ToolOffset::default();
            tool.offset.set(Axis::Z, length);
            tool
        };
        let setting =
            Setting { tools: Some(Tools::from([(1, tool(0.0)), (2, tool(80.0))])), ..Setting::new(&FAGOR_8070) };
        let mut interpreter = Interpreter::over(program.as_bytes(), setting);
        interpreter.by_ref().for_each(drop);
        let told = interpreter.remarks().iter().map(|one| one.what.en.to_string()).collect::<Vec<_>>().join("|");
        assert!(told.starts_with("T2 has a length in the table"), "{told}");
    }

    #[test]
    fn a_program_that_ends_under_g43_is_told() {
        for (control, blocks, told) in [
            (&FAGOR_8055, "T1 D1\nM6\nG43 G0 Z50\nM30\n", true),
            (&FAGOR_8055, "T1 D1\nM6\nG43 G0 Z50\nG44 Z100\nM30\n", false),
            (&FAGOR_8055, "T1 D1\nM6\nG0 Z50\nM30\n", false),
            (&LINUXCNC, "T1 M6\nG43 H1\nG0 Z50\nM30\n", false),
        ] {
            let mut interpreter = Interpreter::over(blocks.as_bytes(), Setting::new(control));
            interpreter.by_ref().for_each(drop);
            let remarks = interpreter.remarks();
            assert_eq!(remarks.iter().any(|one| one.code() == "G0548"), told, "{} {blocks}", control.name);
        }
    }

    /// Controls that know both letters, of which one alone is that of a length.
    static BY_D: Control = Control {
        lexis: Lexis { letters: Letters::of("DHTXYZFS"), free: Letters::of("FST"), ..FAGOR_8055.lexis },
        ..FAGOR_8055
    };
    static BY_H: Control = Control { length: LengthWord::H, ..BY_D };

    #[test]
    fn a_length_is_taken_by_the_letter_of_its_control_alone() {
        assert_eq!(read(&BY_D, "T1 M6|G43 D2|G0 Z10", true), (vec![90.0], vec![]));
        assert_eq!(read(&BY_D, "T1 M6|G43 H2|G0 Z10", true).1.first(), Some(&"G0515"));
        assert_eq!(read(&BY_H, "T1 M6|G43 H2|G0 Z10", true).0, [90.0]);
        assert_eq!(read(&BY_H, "T1 M6|G43 D2|G0 Z10", true).1.first(), Some(&"G0515"));
    }

    #[test]
    fn a_tool_that_cuts_without_its_length_is_told_once_its_length_is_known() {
        for (control, blocks, table, codes) in [
            (&FAGOR_8055, "T1 D1|M6|G0 Z5|G1 Z-2", true, &["G0528"][..]),
            (&FAGOR_8055, "T1 D3|M6|G0 Z5|G1 Z-2", true, &[]),
            (&FAGOR_8055, "T1 D1|M6|G0 Z5|G1 Z-2", false, &[]),
            (&FAGOR_8055, "T1 D1|M6|G0 Z5|G43 G1 X5", true, &["G0544"]),
            (&FAGOR_8055, "T1 D1|M6|G43 G0 Z5|T2 D2|M6|G1 X5", true, &["G0544"]),
            (&FAGOR_8055, "T1 D1|M6|G43 G0 Z5|D3|G1 X5", true, &["G0544"]),
            // A rejected G43 may have brought it, also of the tool behind it.
            (&FAGOR_8055, "T1 D1|M6|G43 H1|G0 Z5|G1 Z-2|T2 D2|M6|G1 X5", true, &["G0118"]),
            (&FAGOR_8070, "T1 D1 M6|G0 Z5|G1 Z-2", true, &["G0547"]),
            // D of an 8070 is the tool's own, and the table is asked by T.
            (&FAGOR_8070, "T2 M6|G0 Z5|G1 Z-2", true, &["G0547"]),
            (&FAGOR_8070, "T2 D1|G0 Z5|G1 Z-2", true, &["G0547"]),
            (&FAGOR_8070, "T3 D1 M6|G0 Z5|G1 Z-2", true, &[]),
            (&FAGOR_8070, "T3 D2 M6|G0 Z5|G1 Z-2", true, &["G0551"]),
            (&FAGOR_8070, "T3 D2 M6|T3 M6|G0 Z5|G1 Z-2", true, &[]),
            (&FAGOR_8070, "T2 D1 M6|G0 Z5|G1 Z-2", false, &[]),
            (&FAGOR_8070, "T1 D1 M6|G43|G0 Z5|G1 Z-2", true, &["G0112"]),
        ] {
            assert_eq!(read(control, blocks, table).1, codes, "{} {blocks}", control.name);
        }
    }
}
