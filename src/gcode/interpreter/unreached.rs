//! Blocks behind the one that ends the program, to which the control never comes.

use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block_number;
use crate::gcode::interpreter::cursor::Cursor;
use crate::gcode::interpreter::library::Spot;
use crate::gcode::interpreter::structure::Structure;
use crate::gcode::interpreter::tape::titled;
use crate::gcode::rules::flow::BlocksNeverRun;

/// A line behind the end of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Behind {
    /// Nothing to run: a comment, a block number alone, a `%`.
    Nothing,
    /// The `%` that ends the text of the program.
    Closed,
    /// A block.
    Block,
    /// Something begins that is run where it is called.
    Other,
}

impl Reader<'_, '_> {
    /// M2, M30 or the closing `%` has ended the program: says where the blocks behind it begin that are never run. `closed` for the `%`,
    /// behind which nothing can be called.
    ///
    /// Nothing is said where the end stands in a subprogram or a clause, or behind `/`: another run may go past it. Nor is it where
    /// a block was refused, as that one may be a jump.
    pub(super) fn see_unreached(&mut self, mut closed: bool) {
        let Spot { text, line: end, .. } = self.block.spot;
        let mut at = self.memory.flow.next;
        let within = self.memory.library.known_structure().is_some_and(|structure| structure.is_open(end));
        let sure = text == 0 && at.text == 0 && at.line.lines == end && self.memory.flow.frames.is_empty() && !within;
        if !sure || self.block.skippable || self.memory.doubts.any_refused() {
            return;
        }
        // Blocks behind the end have been run, or read as a contour, by their numbers.
        let numbered = self.memory.library.text(0).furthest() > end;
        let mut line = Vec::new();
        while let Ok(Some(next)) = self.memory.library.line(at, &mut line) {
            match self.behind_end(&line, closed, numbered) {
                Behind::Nothing => at = next,
                Behind::Closed => (at, closed) = (next, true),
                Behind::Block => {
                    let row = BlocksNeverRun { line: next.line.lines, end };
                    let spot = Spot { line: next.line.lines, ..self.block.spot };
                    return self.memory.remarks.row(&row, spot, None);
                }
                Behind::Other => return,
            }
        }
    }

    /// What a line behind the end is; `closed` behind the last `%`, `numbered` where a block number may be one that is called.
    fn behind_end(&self, line: &[u8], closed: bool, numbered: bool) -> Behind {
        let lexis = &self.memory.control.lexis;
        let mut cursor = Cursor::new(line, lexis.comments);
        if cursor.peek() == b'%' {
            let ends = lexis.percent.leader() && titled(line) || lexis.percent.bare() && self.memory.flow.percent;
            return if ends { Behind::Closed } else { Behind::Nothing };
        }
        cursor.accept_delete(lexis.delete.switches() > 0);
        if cursor.accept(b'n') && (block_number(&mut cursor).is_err() || numbered && !closed) {
            return if closed { Behind::Nothing } else { Behind::Other };
        }
        match cursor.peek() {
            b'a'..=b'z' | b'#' if closed => {
                if line.iter().any(u8::is_ascii_digit) {
                    Behind::Block
                } else {
                    Behind::Nothing
                }
            }
            // A subprogram, or another program; the high-level language has subprograms too.
            b'o' => Behind::Other,
            b'(' | b'$' | b'#' if lexis.language.has_words_alone() => Behind::Other,
            b'a'..=b'z' | b'#' if line.iter().any(u8::is_ascii_digit) => Behind::Block,
            _ => Behind::Nothing,
        }
    }
}

impl Structure {
    /// True where an IF or a loop is open on a line, counted from 1.
    fn is_open(&self, line: usize) -> bool {
        let place = |index: usize| self.words.get(index).map_or(0, |word| word.at.lines + 1);
        self.words.iter().any(|word| {
            word.at.lines + 1 < line && word.opens_clause() && word.next.is_some_and(|next| place(next) > line)
        })
    }
}

#[cfg(test)]
mod tests {
    use crate::gcode::control::{Control, FAGOR_8055, FAGOR_8070, FANUC_LATHE_A, LINUXCNC};
    use crate::gcode::interpreter::{Interpreter, Setting};

    /// The first line that is told to be never run, and that of the end.
    fn unreached(control: &'static Control, program: &str) -> Option<String> {
        let mut interpreter = Interpreter::over(program.as_bytes(), Setting::new(control));
        while interpreter.next().is_some() {}
        let told = interpreter.remarks().into_iter().find(|finding| finding.code() == "G0355");
        told.map(|finding| finding.what.en.into_owned())
    }

    /// A control, a program, and where the blocks that are never run begin and the program ends, as lines.
    type Case = (&'static Control, String, Option<(usize, usize)>);

    #[test]
    fn blocks_behind_the_end_are_told_and_what_is_called_is_not() {
        let mill = "G21 G90 S900 M3|G1 X1 F100|";
        let fagor = "%A,MX,|G71 G90 G94 S900 M3|G1 X1 F100|";
        let lathe = "O0001|G21 G98|G0 X40. Z2.|";
        let cases: [Case; 30] = [
            (&LINUXCNC, format!("{mill}M2"), None),
            (&LINUXCNC, format!("{mill}M2||(end)|; end||N90|"), None),
            (&LINUXCNC, format!("{mill}M2||(end)|G0 Z50|M2"), Some((6, 3))),
            (&LINUXCNC, format!("%|{mill}M2|%|G0 Z50"), Some((6, 4))),
            (&LINUXCNC, format!("%|{mill}M2|%||(end)|%"), None),
            (&LINUXCNC, format!("%|{mill}%|G0 Z50|M2"), Some((5, 4))),
            (&LINUXCNC, format!("%|{mill}M2|%|%|O2|G0 X2"), Some((7, 4))),
            (&LINUXCNC, format!("{mill}M98 P7|M2|O7|G1 X2|M99"), None),
            (&LINUXCNC, format!("{mill}O<s> CALL|M2|O<s> SUB|G1 X2|O<s> ENDSUB"), None),
            (&LINUXCNC, format!("{mill}M98 P7|M2|G0 Z50|O7|G1 X2|M99"), Some((5, 4))),
            (&LINUXCNC, format!("{mill}O1 IF [#1 EQ 0]|M2|O1 ENDIF|G0 X2|M2").replace("G21", "#1=0 G21"), None),
            (&LINUXCNC, format!("{mill}O1 IF [1]|G1 X2|O1 ENDIF|M2|G0 X2"), Some((7, 6))),
            (&LINUXCNC, format!("{mill}/M2|G0 Z50|M2"), None),
            (&LINUXCNC, format!("{mill}M2|#1=5"), Some((4, 3))),
            // A refused block may be a jump.
            (&LINUXCNC, format!("{mill}G33 Z1|M2|G0 Z50"), None),
            (&FAGOR_8055, format!("{fagor}M30"), None),
            (&FAGOR_8055, format!("{fagor}M30|G0 X2|M30"), Some((5, 4))),
            (&FAGOR_8055, format!("{fagor}M30|;more|N150 G1 X9999 ZZ Q(((|G999"), Some((6, 4))),
            (&FAGOR_8055, format!("{fagor}M30|%B,MX,|G0 X2|M30"), Some((6, 4))),
            (&FAGOR_8055, format!("{fagor}M30|(SUB 1)|G0 X2|(RET)"), None),
            (&FAGOR_8070, format!("{}M30|G0 X2", fagor.replace(",MX,", "")), Some((5, 4))),
            (&FANUC_LATHE_A, format!("%|{lathe}M30|%"), None),
            (&FANUC_LATHE_A, format!("{lathe}M30|G0 X50."), Some((5, 4))),
            (&FANUC_LATHE_A, format!("{lathe}M98 P2|M30|O0002|G1 X30. F100.|M99"), None),
            (&FANUC_LATHE_A, format!("{lathe}M30|O0002|G0 X1.|M30"), None),
            (&FANUC_LATHE_A, format!("{lathe}M30|%|G0 X50."), Some((6, 4))),
            (&FANUC_LATHE_A, format!("%|{lathe}M30|%|thank you for reading"), None),
            (&FANUC_LATHE_A, format!("{lathe}%|G0 X50.|M30"), Some((5, 4))),
            (&FANUC_LATHE_A, format!("%|{lathe}M30|%|%|O0002|G0 X50.|M30|%"), Some((8, 5))),
            (
                &FANUC_LATHE_A,
                format!("{lathe}S500 M3|G71 U2. R1.|G71 P10 Q20 U1. W.1 F100.|M30|N10 G0 X20.|N20 G1 Z-20."),
                None,
            ),
        ];
        for (control, program, told) in cases {
            let expected = told
                .map(|(line, end)| format!("blocks from line {line} on are never run: the program ends in line {end}"));
            assert_eq!(unreached(control, &program.replace('|', "\n")), expected, "{} {program}", control.name);
        }
    }
}
