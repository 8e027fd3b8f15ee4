//! From a line to what is executed of it: comments, `%`, program numbers, block numbers.

use crate::escape::excerpt;
use crate::gcode::interpreter::block::Parameter;
use crate::gcode::interpreter::cursor::{Cursor, comments};
use crate::gcode::interpreter::library::{LineStart, Spot};
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::interpreter::source::Position;
use crate::gcode::interpreter::tape::{has_code, numbers_program, titled};
use crate::gcode::interpreter::{Reader, Stage, block_number, pass_fraction, without_end};
use crate::gcode::rules::flow::{BlockEmpty, BlockNumberTooGreat, SwitchUnknown};
use crate::gcode::rules::lexis::{
    Aborts, ActiveComment, BeforePercent, EndsWithoutCode, HeaderInvalid, HeaderNotExecutable, HighLevel, LineTooLong,
    NoProgramNumbers, Percent, PercentAgain, ProgramNumber,
};
use crate::gcode::rules::words::LocalSubroutine;
use crate::limits::{COMMENT_EXCERPT, LEADER_LINES};

/// Most characters of a program's name in its header.
const LONGEST_NAME: usize = 20;

impl Reader<'_, '_> {
    /// Counts the line that has just been read, behind which a mark lies; it is the block in hand.
    pub(super) fn count_line(&mut self, behind: LineStart) -> Result<()> {
        let number = behind.line.lines;
        let again = !self.memory.library.text(behind.text).first_time(number);
        (self.block.spot.text, self.block.spot.line) = (behind.text, number);
        if again {
            self.memory.flow.repeated += 1;
            if self.memory.flow.repeated > self.memory.setting.budget.repeated_blocks {
                return Err(self.endless());
            }
        }
        Ok(())
    }

    /// The beginning of a line's words, its block number read; at `%` where the line begins with it. `None` where there is
    /// nothing to execute.
    pub(super) fn open_line<'l>(&mut self, line: &'l [u8]) -> Result<Option<Cursor<'l>>> {
        if line.len() > self.memory.control.lexis.longest_line {
            let most = self.memory.control.lexis.longest_line;
            return Err(Refused::of(&LineTooLong { most }, &[most]));
        }
        if memchr::memchr3(b'(', b')', b';', line).is_some() {
            self.see_comments(line)?;
            if self.memory.flow.aborted {
                return self.end().map(|()| None);
            }
        }
        let mut cursor = Cursor::new(line, self.memory.control.lexis.comments);
        let first = cursor.peek();
        let empty_rejected = self.memory.control.lexis.empty.rejected();
        if first == 0 {
            return if empty_rejected && line.trim_ascii().is_empty() {
                Err(Refused::of(&BlockEmpty {}, &[]))
            } else {
                Ok(None)
            };
        }
        self.block.clear();
        let column = cursor.column();
        let switches = self.memory.control.lexis.delete.switches();
        match cursor.accept_delete(switches > 0) {
            Some(switch) if switch > switches => {
                return Err(Refused::of(&SwitchUnknown { switch: switch.into(), most: switches.into() }, &[column]));
            }
            Some(_) if self.memory.setting.block_delete => return Ok(None),
            switch => self.block.skippable = switch.is_some(),
        }
        let column = cursor.column();
        if cursor.accept(b'n') {
            let number = block_number(&mut cursor)?;
            if self.memory.control.lexis.language.numbers_with_fraction() {
                pass_fraction(&mut cursor);
            }
            let most = self.memory.control.lexis.greatest_number;
            if number > most {
                return Err(Refused::of(&BlockNumberTooGreat { number, most }, &[column]));
            }
            self.block.spot.n = Some(number);
        }
        if empty_rejected && cursor.peek() == 0 {
            return Err(Refused::of(&BlockEmpty {}, &[]));
        }
        Ok(Some(cursor))
    }

    pub(super) fn execute_line(&mut self, line: &[u8]) -> Result<()> {
        let Some(mut cursor) = self.open_line(line)? else { return Ok(()) };
        if cursor.peek() == b'%' && self.block.spot.n.is_none() && !line.trim_ascii_start().starts_with(b"/") {
            return self.percent_line(&mut cursor, line);
        }
        let opening = self.memory.flow.stage == Stage::Opening;
        self.memory.flow.stage = Stage::Running;
        if matches!(cursor.peek(), b'$' | b'#') && self.memory.control.lexis.language.has_words_alone() {
            return Err(Refused::of(&HighLevel {}, &[cursor.column()]));
        }
        if cursor.peek() == b'o' {
            return if self.memory.control.lexis.language.computes() {
                self.o_word(&mut cursor)
            } else {
                self.program_number(&mut cursor, opening)
            };
        }
        let start = cursor.column();
        self.read_words(&mut cursor)?;
        self.calls_spelled(line, start)?;
        for (parameter, value) in self.block.settings.drain(..) {
            match parameter {
                Parameter::Number(number) => self.memory.parameters.set(number, value),
                Parameter::Name(name) => self.memory.parameters.set_named(name, value),
            }
        }
        self.execute()?;
        self.certain();
        Ok(())
    }

    /// `%` begins and ends a program; a Fagor program begins with `%` and its name.
    fn percent_line(&mut self, cursor: &mut Cursor<'_>, line: &[u8]) -> Result<()> {
        let bare = self.memory.control.lexis.percent.bare();
        let opening = self.memory.flow.stage == Stage::Opening
            && !self.memory.flow.percent
            && (!bare || self.only_blank_lines_before()?);
        let start = cursor.column();
        cursor.pass();
        let alone = if bare {
            line.trim_ascii() == b"%"
        } else {
            cursor.peek() == 0 || self.memory.control.lexis.percent.leader() && titled(line)
        };
        if self.memory.control.lexis.percent.named() {
            let form = &self.memory.control.text;
            if form.local_subroutines()
                && cursor.accept(b'l')
                && line.get(cursor.column()).is_none_or(u8::is_ascii_whitespace)
            {
                // What follows is run where it is called, and not as it stands.
                return Err(Refused::of(&LocalSubroutine {}, &[start]).fatal());
            }
            // With attributes the header is the first line of the file, or none.
            if opening && (!form.attributes() || self.block.spot.line == 1) {
                self.memory.flow.percent = true;
                return if form.attributes() { header(line) } else { Ok(()) };
            }
        } else if alone {
            if opening {
                self.memory.flow.percent = true;
                return Ok(());
            }
            if self.memory.flow.percent || self.memory.flow.next.text != 0 || self.memory.control.lexis.percent.leader()
            {
                if self.memory.flow.stage == Stage::Opening || self.memory.flow.next.text != 0 {
                    return self.end_of_file();
                }
                if self.memory.control.lexis.percent.leader() {
                    self.remark_no_end();
                }
                self.see_unreached(true);
                return self.end();
            }
        }
        let at = [start];
        Err(if self.memory.control.lexis.percent.named() {
            Refused::of(&PercentAgain {}, &at)
        } else {
            Refused::of(&Percent {}, &at)
        })
    }

    /// True where no comment stands before the line in hand, which is the first with more than one.
    fn only_blank_lines_before(&mut self) -> Result<bool> {
        let (mut line, mut at) = (Vec::new(), LineStart { line: Position::START, ..self.memory.flow.next });
        while let Some(behind) = self.memory.library.line(at, &mut line)?
            && behind.line.lines < self.block.spot.line
        {
            if !line.trim_ascii().is_empty() {
                return Ok(false);
            }
            at = behind;
        }
        Ok(true)
    }

    /// A lathe's program has come to the end of its text without a code that ends it.
    pub(super) fn remark_no_end(&mut self) {
        self.memory.remarks.row(&EndsWithoutCode {}, self.block.spot, None);
    }

    /// Passes over what stands before the first `%`, as a Fanuc does: text that is no block, or the number of a program alone, with a
    /// program behind it.
    pub(super) fn pass_leader(&mut self) -> Result<()> {
        let comments = self.memory.control.lexis.comments;
        let mut line = Vec::new();
        let (mut text, mut at) = (false, self.memory.flow.next);
        while at.line.lines < LEADER_LINES {
            let Some(behind) = self.memory.library.line(at, &mut line)? else { break };
            let words = line.trim_ascii().to_ascii_uppercase();
            if titled(&words) {
                if text && self.goes_on(behind)? {
                    let first = Spot { line: 1, ..self.block.spot };
                    self.memory.remarks.row(&BeforePercent {}, first, None);
                    self.memory.flow.next = at;
                }
                break;
            }
            if has_code(&words) && !numbers_program(&words, comments) {
                break;
            }
            text |= !words.is_empty() && words != b"\xEF\xBB\xBF";
            at = behind;
        }
        Ok(())
    }

    /// True where the next line behind a place that is not blank is no `%`.
    fn goes_on(&mut self, mut at: LineStart) -> Result<bool> {
        let mut line = Vec::new();
        while at.line.lines < LEADER_LINES {
            let Some(behind) = self.memory.library.line(at, &mut line)? else { break };
            if !line.trim_ascii().is_empty() {
                return Ok(!titled(&line));
            }
            at = behind;
        }
        Ok(false)
    }

    /// The number and name of a program without O-words.
    fn program_number(&mut self, cursor: &mut Cursor<'_>, opening: bool) -> Result<()> {
        let column = cursor.column();
        if self.memory.control.lexis.percent.named() {
            let dialect = self.memory.setting.control.name;
            return Err(Refused::of(&NoProgramNumbers { dialect }, &[column]));
        }
        cursor.pass();
        block_number(cursor)?;
        if opening && cursor.peek() == 0 {
            return Ok(());
        }
        if self.memory.control.lexis.percent.leader() && cursor.peek() == 0 {
            // What follows is another program: whether a control goes on into it is not known.
            let inside = self.memory.flow.next.text != 0 || !self.memory.flow.frames.is_empty();
            return if inside { self.end_of_file().map_err(Refused::fatal) } else { Err(without_end(false).fatal()) };
        }
        Err(Refused::of(&ProgramNumber {}, &[column]))
    }

    /// Shows the comments that a control would obey; none is executed.
    fn see_comments(&mut self, line: &[u8]) -> Result<()> {
        const ACTIVE: [&str; 11] = [
            "MSG,",
            "DEBUG,",
            "PRINT,",
            "LOG,",
            "LOGOPEN,",
            "LOGAPPEND,",
            "LOGCLOSE",
            "PROBEOPEN",
            "PROBECLOSE",
            "PY,",
            "PYRUN,",
        ];
        for (column, text) in comments(line, self.memory.control.lexis.comments)? {
            let text = String::from_utf8_lossy(text);
            let word: String = text.trim_start().chars().take(10).collect::<String>().to_uppercase();
            self.memory.flow.aborted |= self.memory.control.lexis.comments.obeyed() && word.starts_with("ABORT,");
            if self.memory.flow.aborted {
                let shown = excerpt(text.trim(), COMMENT_EXCERPT);
                self.memory.remarks.row(&Aborts { comment: shown }, self.block.spot, Some(column));
                return Ok(());
            }
            if self.memory.control.lexis.comments.obeyed() && ACTIVE.iter().any(|active| word.starts_with(active)) {
                let spot = self.block.spot;
                let shown = excerpt(text.trim(), COMMENT_EXCERPT);
                self.memory.remarks.row(&ActiveComment { comment: shown }, spot, Some(column));
            }
        }
        Ok(())
    }
}

/// Refuses the first line of a Fagor program with which the control would not run it: `%name,attributes,`, the name of at most
/// [`LONGEST_NAME`] characters, the attributes of M, X, H, O and dashes, X among them.
fn header(line: &[u8]) -> Result<()> {
    let text = String::from_utf8_lossy(line.trim_ascii());
    let parts = text.strip_prefix('%').and_then(|text| text.split_once(','));
    let fits = parts
        .map(|(name, attributes)| (name, attributes.strip_suffix(',').unwrap_or(attributes).trim()))
        .filter(|(name, attributes)| {
            name.chars().count() <= LONGEST_NAME
                && !attributes.is_empty()
                && attributes.bytes().all(|letter| b"MXHO-".contains(&letter.to_ascii_uppercase()))
        });
    match fits {
        None => Err(Refused::of(&HeaderInvalid { most: LONGEST_NAME }, &[])),
        Some((_, attributes)) if !attributes.to_ascii_uppercase().contains('X') => {
            Err(Refused::of(&HeaderNotExecutable { attributes: attributes.to_owned() }, &[]))
        }
        Some(_) => Ok(()),
    }
}
