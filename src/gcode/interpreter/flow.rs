//! Subprograms, loops and branches.

use std::collections::{BTreeMap, BTreeSet};

use crate::gcode::code::{G, Group, M};
use crate::gcode::control::CallBy;
use crate::gcode::interpreter::block::letter;
use crate::gcode::interpreter::context::Context;
use crate::gcode::interpreter::cursor::Cursor;
use crate::gcode::interpreter::expression::whole;
use crate::gcode::interpreter::library::LineStart;
use crate::gcode::interpreter::parameters::LOCAL;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::interpreter::round::Rounds;
use crate::gcode::interpreter::source::Position;
use crate::gcode::interpreter::structure::{OWord, Structure, Word, label, shown, word};
use crate::gcode::interpreter::{Reader, Stage};
use crate::gcode::rules::flow::{
    ArgumentsTooMany, BehindOWord, CallNotFirst, CallWithWords, CallWithoutP, CallsTooDeep, DefinedBehindCall,
    MainReturns, NotCalled, OWordUnknown, ProgramMissing, RepeatsTooMany, ReturnInsideSub, SubprogramBefore,
    SubprogramMissing, SubprogramOutside, SubprogramTooLarge, SubprogramUnreadable, WithoutCounterpart,
};
use crate::limits::{CALL_REPEATS, SUBPROGRAM_BYTES};

/// What the last subprogram gave back, and whether it gave a value.
pub(super) const VALUES: [&str; 2] = ["_value", "_value_returned"];

/// A call that has not returned.
#[derive(Debug)]
pub(super) struct Call {
    label: String,
    back: LineStart,
    /// It has #1 to #30 of its own; M98 shares the caller's.
    own: bool,
    /// How often M98 still runs it, and where it begins.
    again: i64,
    start: LineStart,
    /// What M70 or M73 has kept in it.
    context: Context,
}

impl Call {
    /// A call that shares its parameters with the caller and runs some times.
    pub(super) fn of(label: String, back: LineStart, times: i64, start: LineStart) -> Self {
        Self { label, back, own: false, again: times - 1, start, context: Context::default() }
    }

    /// Where it begins once more, if it does; that is counted.
    pub(super) fn repeat(&mut self) -> Option<LineStart> {
        self.again -= 1;
        (self.again >= 0).then_some(self.start)
    }
}

/// Where the program is, in its subprograms and loops too.
#[derive(Debug, Default)]
pub(super) struct Flow {
    pub(super) stage: Stage,
    /// A `%` has opened the program.
    pub(super) percent: bool,
    /// A comment has ended the program.
    pub(super) aborted: bool,
    /// Blocks that have been read again.
    pub(super) repeated: u64,
    /// What is watched of loops, so that each comes to an end.
    pub(super) loops: Rounds,
    /// Where the next line begins.
    pub(super) next: LineStart,
    pub(super) frames: Vec<Call>,
    /// How many rounds are left to a REPEAT that has begun, by text and O-word: whatever call it stands in, one left by RETURN
    /// goes on where it was.
    rounds: BTreeMap<(usize, usize), i64>,
    /// The line in hand was reached as the next clause of an IF.
    clause: bool,
    /// The line in hand ends the SUB that the control has just passed over.
    passed: bool,
    /// A SUB is passed over: to the control a name that nothing has set is 0 there.
    pub(super) defining: bool,
    /// The subprograms that the control has met, by text and O-word.
    met: BTreeSet<(usize, usize)>,
    /// What M70 or M73 has kept outside of all calls.
    main: Context,
}

impl Flow {
    /// What the call in hand has kept, or the program where there is none.
    pub(super) fn context(&mut self) -> &mut Context {
        self.frames.last_mut().map_or(&mut self.main, |call| &mut call.context)
    }
}

impl Reader<'_, '_> {
    /// The O-words of the file in hand.
    fn structure(&mut self) -> Result<&Structure> {
        let at = self.memory.flow.next.text;
        self.memory.library.structure(at, &self.memory.control.lexis)
    }

    fn mark(&mut self, index: Option<usize>) -> Result<OWord> {
        let structure = self.structure()?;
        index
            .and_then(|index| structure.o_word(index))
            .cloned()
            .ok_or_else(|| Refused::of(&WithoutCounterpart {}, &[]).fatal())
    }

    /// Goes on with a line of the text in hand.
    pub(super) const fn go_to(&mut self, position: Position) {
        self.memory.flow.next.line = position;
    }

    /// Goes on with a line of any text.
    pub(super) const fn open(&mut self, mark: LineStart) {
        self.memory.flow.next = mark;
    }

    /// An O-word line; the cursor stands on O.
    pub(super) fn o_word(&mut self, cursor: &mut Cursor<'_>) -> Result<()> {
        let result = self.steer(cursor);
        // Where the flow is not known, nothing after it is.
        result.map_err(Refused::fatal)
    }

    fn steer(&mut self, cursor: &mut Cursor<'_>) -> Result<()> {
        let clause = std::mem::take(&mut self.memory.flow.clause);
        let passed = std::mem::take(&mut self.memory.flow.passed);
        let column = cursor.column();
        cursor.pass();
        let name = match label(cursor)? {
            Some(name) => name,
            None => self.computed_label(cursor, column)?,
        };
        let place = cursor.column();
        let Some(kind) = word(cursor) else {
            return Err(Refused::of(&OWordUnknown {}, &[place]));
        };
        if kind == Word::Call {
            return self.call(cursor, &name);
        }
        let line = self.block.spot.line;
        let index = self.structure()?.on_line(line);
        let mark = self.mark(index)?;
        match kind {
            Word::Sub => self.pass_subprogram(cursor, (index, &mark), &name),
            Word::EndSub if passed => self.end_passed(cursor),
            Word::EndSub => self.give_back(cursor, &name),
            Word::Return => {
                // It ends the subprogram that it stands in, whatever label it names.
                let around = self.structure()?.around(index);
                let around = self.mark(around)?.label;
                self.give_back(cursor, &around)
            }
            Word::If => self.clause(cursor, &mark),
            Word::ElseIf if clause => self.clause(cursor, &mark),
            Word::ElseIf => self.leave_clauses(index),
            Word::Else => {
                self.nothing_more(cursor)?;
                if clause { Ok(()) } else { self.leave_clauses(index) }
            }
            Word::While => self.while_true(cursor, &mark),
            Word::EndWhile => {
                self.nothing_more(cursor)?;
                self.round_again()?;
                let start = self.mark(mark.opens)?;
                self.go_to(start.at);
                Ok(())
            }
            Word::Repeat => self.repeat(cursor, &mark, index),
            Word::EndRepeat => {
                self.nothing_more(cursor)?;
                let start = self.mark(mark.opens)?;
                self.go_to(start.at);
                Ok(())
            }
            Word::Break | Word::Continue => {
                self.nothing_more(cursor)?;
                self.leave_round(&mark, kind == Word::Break)
            }
            // The number of a program that the flow runs into: the program's own, or that of the next one.
            Word::Program => {
                self.nothing_more(cursor)?;
                self.structure()?.run_into(index)
            }
            Word::EndIf | Word::Do | Word::Call => self.nothing_more(cursor),
        }
    }

    /// Passes over a subprogram, which the control has now met.
    fn pass_subprogram(
        &mut self,
        cursor: &mut Cursor<'_>,
        (index, mark): (Option<usize>, &OWord),
        name: &str,
    ) -> Result<()> {
        let end = self.mark(mark.next)?;
        self.nothing_more(cursor)?;
        // Within a call the control would run it as it stands.
        if !self.memory.flow.frames.is_empty() {
            return Err(Refused::of(&NotCalled { label: shown(name) }, &[]));
        }
        let known = |index| !self.memory.flow.met.insert((self.block.spot.text, index));
        if index.is_some_and(known) {
            return Err(Refused::of(&DefinedBehindCall { label: shown(name) }, &[]));
        }
        // The control reads what the end gives back even here.
        self.memory.flow.passed = true;
        self.memory.flow.defining = true;
        let result = self.pass_to(end.at);
        self.memory.flow.defining = false;
        result
    }

    /// ENDSUB of a SUB that is passed over: the control keeps its value like that of a call. Computed from what the call would
    /// give it, it is not known here, and a program that reads it before a call is refused.
    fn end_passed(&mut self, cursor: &mut Cursor<'_>) -> Result<()> {
        if cursor.peek() == b'[' {
            VALUES.into_iter().for_each(|name| self.memory.parameters.forget_named(name));
            return Ok(());
        }
        self.nothing_more(cursor)?;
        self.keep_value(None);
        Ok(())
    }

    /// What `#<_value>` and `#<_value_returned>` hold from here on.
    fn keep_value(&mut self, value: Option<f64>) {
        for (name, held) in VALUES.into_iter().zip([value.unwrap_or(0.0), f64::from(u8::from(value.is_some()))]) {
            self.memory.parameters.set_named(name.to_owned(), held);
        }
    }

    /// The condition of an IF or ELSEIF.
    fn clause(&mut self, cursor: &mut Cursor<'_>, mark: &OWord) -> Result<()> {
        let truth = self.condition(cursor)?;
        if truth { Ok(()) } else { self.next_clause(mark) }
    }

    /// WHILE, at the beginning of its loop or at the end of one that a DO opens.
    fn while_true(&mut self, cursor: &mut Cursor<'_>, mark: &OWord) -> Result<()> {
        let truth = self.condition(cursor)?;
        match (mark.opens, truth) {
            // The WHILE that closes a DO.
            (Some(opens), true) => {
                self.round_again()?;
                let start = self.mark(Some(opens))?;
                self.go_to(start.after);
            }
            (Some(_), false) | (None, true) => {}
            (None, false) => {
                let end = self.mark(mark.next)?;
                self.pass_to(end.after)?;
            }
        }
        Ok(())
    }

    fn nothing_more(&self, cursor: &mut Cursor<'_>) -> Result<()> {
        if cursor.peek() == 0 {
            return Ok(());
        }
        Err(Refused::of(&BehindOWord {}, &[cursor.column()]))
    }

    fn condition(&mut self, cursor: &mut Cursor<'_>) -> Result<bool> {
        let value = self.expression(cursor)?;
        self.nothing_more(cursor)?;
        Ok(value != 0.0)
    }

    fn next_clause(&mut self, mark: &OWord) -> Result<()> {
        let next = self.mark(mark.next)?;
        self.memory.flow.clause = next.word != Word::EndIf;
        self.pass_to(if next.word == Word::EndIf { next.after } else { next.at })
    }

    fn leave_clauses(&mut self, index: Option<usize>) -> Result<()> {
        let structure = self.structure()?;
        let end = index.and_then(|index| structure.end_of_clauses(index));
        let end = self.mark(end)?;
        self.pass_to(end.after)
    }

    fn repeat(&mut self, cursor: &mut Cursor<'_>, mark: &OWord, index: Option<usize>) -> Result<()> {
        let value = self.expression(cursor)?;
        self.nothing_more(cursor)?;
        let Some(index) = index else { return Ok(()) };
        // As the control rounds: halves to the even number.
        #[expect(clippy::cast_possible_truncation, reason = "clamped; the budget ends more rounds than that")]
        let asked = value.round_ties_even().clamp(0.0, 1e12) as i64;
        let place = (self.block.spot.text, index);
        let left = self.memory.flow.rounds.entry(place).or_insert(asked);
        if *left > 0 {
            *left -= 1;
            return Ok(());
        }
        self.memory.flow.rounds.remove(&place);
        let end = self.mark(mark.next)?;
        self.pass_to(end.after)
    }

    /// BREAK and CONTINUE of a WHILE or DO.
    fn leave_round(&mut self, mark: &OWord, leave: bool) -> Result<()> {
        let opens = self.mark(mark.opens)?;
        let closes = self.mark(opens.next)?;
        if !leave && opens.word != Word::Do {
            self.round_again()?;
        }
        match (leave, opens.word) {
            (true, _) => self.pass_to(closes.after),
            // The condition of a DO stands at its end, that of a WHILE at its beginning.
            (false, Word::Do) => self.pass_to(closes.at),
            (false, _) => {
                self.go_to(opens.at);
                Ok(())
            }
        }
    }

    fn call(&mut self, cursor: &mut Cursor<'_>, name: &str) -> Result<()> {
        let mut arguments = Vec::new();
        while cursor.peek() == b'[' {
            if arguments.len() == LOCAL {
                return Err(Refused::of(&ArgumentsTooMany { most: LOCAL }, &[cursor.column()]));
            }
            let value = self.expression(cursor)?;
            arguments.push(value);
        }
        self.nothing_more(cursor)?;
        let back = self.memory.flow.next;
        let found = self.structure()?.sub(name);
        let start = match found {
            Some(index) => self.sought(index, back)?,
            None => {
                let found = self.file_of(name, Structure::sub)?;
                found.ok_or_else(|| Refused::of(&SubprogramMissing { label: shown(name) }, &[]))?
            }
        };
        self.enter(Call { label: name.to_owned(), back, own: true, again: 0, start, context: Context::default() })?;
        self.memory.parameters.enter(&arguments);
        self.open(start);
        Ok(())
    }

    pub(super) fn enter(&mut self, call: Call) -> Result<()> {
        let most = self.memory.setting.budget.call_depth.min(self.memory.control.calls.depth);
        if self.memory.flow.frames.len() >= most {
            let mut stack: Vec<String> = self.memory.flow.frames.iter().map(|call| shown(&call.label)).collect();
            stack.push(shown(&call.label));
            let stack = stack.join(" → ");
            return Err(Refused::ended(&CallsTooDeep { most, stack }));
        }
        self.memory.flow.frames.push(call);
        self.memory.parameters.enter_names();
        Ok(())
    }

    /// Where the subprogram or the program of a file of its own begins, if there is one.
    fn file_of(&mut self, name: &str, sought: fn(&Structure, &str) -> Option<usize>) -> Result<Option<LineStart>> {
        let plain =
            !name.starts_with('.') && name.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"_-.".contains(&byte));
        if !plain {
            return Err(Refused::of(&SubprogramOutside { name: name.to_owned() }, &[]));
        }
        let known = self.memory.library.find(|file| file == name);
        let text =
            match known {
                Some(text) => text,
                None => {
                    let bytes =
                        self.memory.setting.files.find(name).map_err(|reason| {
                            Refused::of(&SubprogramUnreadable { name: name.to_owned(), reason }, &[])
                        })?;
                    let Some(bytes) = bytes else { return Ok(None) };
                    if bytes.len() > SUBPROGRAM_BYTES {
                        return Err(Refused::ended(&SubprogramTooLarge { name: name.to_owned() }));
                    }
                    self.memory.library.add(bytes, name.to_owned())
                }
            };
        let structure = self.memory.library.structure(text, &self.memory.control.lexis)?;
        let sub = sought(structure, name).and_then(|index| Some((index, structure.o_word(index)?.after)));
        let Some((index, line)) = sub else { return Ok(None) };
        self.memory.flow.met.insert((text, index));
        Ok(Some(LineStart { text, line }))
    }

    /// ENDSUB and RETURN, with their value.
    fn give_back(&mut self, cursor: &mut Cursor<'_>, name: &str) -> Result<()> {
        let value = if cursor.peek() == b'[' { Some(self.expression(cursor)?) } else { None };
        self.nothing_more(cursor)?;
        let fits = self.memory.flow.frames.last().is_some_and(|call| call.own && call.label == name);
        if !fits {
            return Err(Refused::of(&NotCalled { label: shown(name) }, &[]));
        }
        self.leave();
        self.keep_value(value);
        Ok(())
    }

    pub(super) fn leave(&mut self) {
        let Some(call) = self.memory.flow.frames.pop() else { return };
        if call.own {
            self.memory.parameters.leave();
        }
        self.memory.parameters.leave_names();
        self.open(call.back);
        self.leave_context(&call.context);
    }

    /// M98 and M99 of the block in hand.
    #[deny(clippy::wildcard_enum_match_arm)]
    pub(super) fn call_or_return(&mut self) -> Result<()> {
        let result = match self.memory.control.calls.by {
            CallBy::Number => self.call_by_number(),
            CallBy::Label => match self.block.m(4) {
                Some((M::Call, _)) => self.call_program(),
                Some((M::Return, _)) => self.return_from_program(),
                Some(_) | None => Ok(()),
            },
            CallBy::Nothing => {
                let number = self.block.m(4).map_or(98, |(_, number)| number);
                Err(self.unknown('M', number.into(), self.block.m_column(4)))
            }
        };
        result.map_err(Refused::fatal)
    }

    fn call_program(&mut self) -> Result<()> {
        let column = self.block.m_column(4);
        let Some(P) = self.block.get(letter::P) else {
            return Err(Refused::of(&CallWithoutP {}, &[column]));
        };
        let repeats = match self.block.get(letter::L) {
            None => 1,
            Some(L) => whole(L).filter(|repeats| (0..=CALL_REPEATS).contains(repeats)).ok_or_else(|| {
                Refused::of(&RepeatsTooMany { repeats: L, most: CALL_REPEATS }, &[self.block.column(letter::L)])
            })?,
        };
        let name = whole(P).map_or_else(|| P.to_string(), |number| number.to_string());
        if repeats == 0 {
            return Ok(());
        }
        let back = self.memory.flow.next;
        let start = match self.structure()?.program(&name) {
            Some(index) => self.sought(index, back)?,
            None => {
                let found = self.file_of(&name, Structure::program)?;
                let (number, column) = (name.clone(), self.block.column(letter::P));
                found.ok_or_else(|| Refused::of(&ProgramMissing { number }, &[column]))?
            }
        };
        self.enter(Call::of(name, back, repeats, start))?;
        self.open(start);
        Ok(())
    }

    /// Where the SUB or program at an O-word begins, as a call finds it from the line behind its own: where the control has met
    /// it, or from the call on.
    fn sought(&mut self, index: usize, back: LineStart) -> Result<LineStart> {
        let mark = self.mark(Some(index))?;
        if mark.at.lines < back.line.lines && !self.memory.flow.met.contains(&(back.text, index)) {
            return Err(Refused::of(&SubprogramBefore { label: shown(&mark.label), line: mark.at.lines + 1 }, &[]));
        }
        if self.memory.flow.met.insert((back.text, index)) {
            self.read_passed(back, mark.after)?;
        }
        Ok(LineStart { line: mark.after, ..back })
    }

    fn return_from_program(&mut self) -> Result<()> {
        match self.memory.flow.frames.last_mut() {
            None => {
                self.end_spindle(true);
                Err(Refused::ended(&MainReturns {}))
            }
            Some(call) if call.own => Err(Refused::of(&ReturnInsideSub {}, &[self.block.m_column(4)])),
            Some(call) => match call.repeat() {
                Some(start) => {
                    // Each round keeps its own state.
                    let context = std::mem::take(&mut call.context);
                    self.leave_context(&context);
                    self.memory.parameters.leave_names();
                    self.memory.parameters.enter_names();
                    self.keep_value(None);
                    self.open(start);
                    Ok(())
                }
                None => {
                    self.leave();
                    self.keep_value(None);
                    Ok(())
                }
            },
        }
    }

    /// Refuses M98 and M99 where the control, which looks for them in the text of the line, does not see them or sees more: they
    /// stand first, in three characters, and no parameter is set beside them.
    pub(super) fn calls_spelled(&self, line: &[u8], start: usize) -> Result<()> {
        if !self.memory.control.calls.by.spelled_in_text() {
            return Ok(());
        }
        let Some((code @ (M::Call | M::Return), _)) = self.block.m(4) else { return Ok(()) };
        if !self.block.settings.is_empty() {
            return Err(Refused::of(&CallWithWords {}, &[self.block.m_column(4)]).fatal());
        }
        let number: &[u8] = if code == M::Call { b"98" } else { b"99" };
        let [before, text] = [&line[..start], &line[start..]];
        let text: Vec<u8> = text.iter().copied().filter(|byte| !matches!(byte, b' ' | b'\t')).collect();
        let rest = match &text[..] {
            [b'm' | b'M', b'#', digit, rest @ ..] if digit.is_ascii_digit() => Some(rest),
            [b'm' | b'M', rest @ ..] => rest.strip_prefix(number),
            _ => None,
        };
        let whole = rest.is_some_and(|rest| !rest.first().is_some_and(|next| next.is_ascii_digit() || *next == b'.'));
        if whole && !before.contains(&b'(') {
            return Ok(());
        }
        Err(Refused::of(&CallNotFirst {}, &[self.block.m_column(4)]).fatal())
    }

    /// Refuses words beside M98 and M99 that are not theirs.
    pub(super) fn calls_alone(&self) -> Result<()> {
        let words = self.block.present & !((1 << letter::P) | (1 << letter::L));
        if words == 0 && self.block.groups == 0 {
            return Ok(());
        }
        // A lathe makes a plain motion of the block before it.
        let motion = self.block.g(Group::Motion).unwrap_or(self.state.modal.motion);
        if self.memory.control.calls.by.beside_motion()
            && matches!(motion, G::Rapid | G::Linear | G::Arc(_))
            && self.block.g(Group::NonModal).is_none()
        {
            return Ok(());
        }
        Err(Refused::of(&CallWithWords {}, &[self.block.m_column(4)]))
    }
}

#[cfg(test)]
mod tests {
    use crate::gcode::control::LINUXCNC;
    use crate::gcode::interpreter::{Files, Interpreter, Refused, Setting};
    use crate::text::Text;

    /// A folder with `deep.ngc`, which calls itself, and with a subprogram before it that it calls.
    struct Deep;

    impl Files for Deep {
        fn find(&mut self, name: &str) -> Result<Option<Vec<u8>>, Text> {
            let text = "o<before> sub\nG0 Y1\no<before> endsub\no<deep> sub\nG0 X#1\no1 if [#1 GT 1]\no<deep> call [#1-1]\n\
                        o1 endif\no2 if [#1 LT 0]\no<before> call\no2 endif\no<deep> endsub\n";
            Ok((name == "deep").then(|| text.as_bytes().to_vec()))
        }
    }

    /// A folder with `50.ngc`, which holds the program O50.
    struct Fifty;

    impl Files for Fifty {
        fn find(&mut self, name: &str) -> Result<Option<Vec<u8>>, Text> {
            Ok((name == "50").then(|| b"O50\nG0 X5\nM99\n".to_vec()))
        }
    }

    #[test]
    fn m98_finds_a_program_in_a_file_of_its_number() {
        for (called, expected) in [(50, Ok(vec![5.0, 6.0])), (51, Err("there is no subprogram O51"))] {
            let program = format!("G21 G90\nM98 P{called}\nG0 X6\nM2\n");
            let mut setting = Setting::new(&LINUXCNC);
            setting.files = Box::new(Fifty);
            let read: Result<Vec<f64>, Box<Refused>> =
                Interpreter::over(program.as_bytes(), setting).map(|item| item.map(|motion| motion.to.0[0])).collect();
            assert_eq!(read.map_err(|fault| fault.what.en.into_owned()), expected.map_err(str::to_owned));
        }
    }

    #[test]
    fn a_file_of_its_own_knows_its_subprogram_and_none_before_it() {
        for (argument, expected) in [
            (3, Ok(vec![3.0, 2.0, 1.0])),
            (-1, Err("O<before> is before the call, in line 1, and the control does not know of it yet")),
        ] {
            let program = format!("G21 G90\no<deep> call [{argument}]\nM2\n");
            let mut setting = Setting::new(&LINUXCNC);
            setting.files = Box::new(Deep);
            let read: Result<Vec<f64>, Box<Refused>> =
                Interpreter::over(program.as_bytes(), setting).map(|item| item.map(|motion| motion.to.0[0])).collect();
            assert_eq!(read.map_err(|fault| fault.what.en.into_owned()), expected.map_err(str::to_owned));
        }
    }
}
