//! A program for a control that rodete does not read: it is told once, in place of what each of its blocks would be refused for.

use crate::finding::Exit;
use crate::gcode::control::foreign::sign;
use crate::gcode::interpreter::library::LineStart;
use crate::gcode::interpreter::refused::Refused;
use crate::gcode::interpreter::{Reader, Stage};
use crate::gcode::rules::lexis::OtherControl;
use crate::limits::LEADER_LINES;

impl Reader<'_, '_> {
    /// In place of the first refusal, that the program is for another control, where a line at its beginning says so: behind it
    /// nothing is read. A program without a refusal is read as what it is.
    pub(super) fn or_foreign(&mut self, fault: Box<Refused>) -> Box<Refused> {
        if std::mem::replace(&mut self.memory.seen.foreign_sought, true) || fault.exit == Exit::Limit {
            return fault;
        }
        let (mut line, mut at) = (Vec::new(), LineStart::default());
        while at.line.lines < LEADER_LINES
            && let Ok(Some(behind)) = self.memory.library.line(at, &mut line)
        {
            if let Some(found) = sign(&String::from_utf8_lossy(&line)) {
                self.memory.flow.stage = Stage::Ended;
                let row = OtherControl { control: found.control, sign: found.sign };
                let mut fault = Refused::of(&row, &[]).fatal();
                fault.line = behind.line.lines;
                return fault;
            }
            at = behind;
        }
        fault
    }
}

#[cfg(test)]
mod tests {
    use crate::gcode::control::{ALL, Control, FAGOR_8055, LINUXCNC};
    use crate::gcode::interpreter::{Interpreter, Setting};

    /// The code and the line of each refusal.
    fn refused(control: &'static Control, program: &str) -> Vec<(&'static str, usize)> {
        let read = Interpreter::over(program.as_bytes(), Setting::new(control));
        read.filter_map(|item| item.err()).map(|fault| (fault.rule.code, fault.line)).collect()
    }

    #[test]
    fn a_program_for_another_control_is_told_once() {
        for program in [
            "0 BEGIN PGM A MM\n1 BLK FORM 0.1 Z X-1 Y-1 Z-4\n2 L X+5 R0 FMAX\n3 END PGM A MM\n",
            "%_N_A_MPF\nN10 T=\"MILL\"\nN20 R1=5\nN30 M30\n",
        ] {
            for control in ALL {
                assert_eq!(refused(control, program), [("G0850", 1)], "{} {program}", control.name);
            }
        }
        let siemens = ";SHAFT\nG21 G40 G800\nG0 X1\nT=\"MILL\"\nG1 Z5 CR=3\n";
        assert_eq!(refused(&LINUXCNC, siemens), [("G0850", 4)]);
        // Its own blocks are refused one by one, and a program that reads is read.
        assert_eq!(refused(&LINUXCNC, "G21 G90\nG0 X1 YY\nG0 ZZ\nM2\n"), [("G0011", 2), ("G0011", 3)]);
        assert_eq!(refused(&FAGOR_8055, ";%_N_A_MPF\nG71 G90\nG0 X1\nM30\n"), []);
    }
}
