//! From a line to a block.

use crate::gcode::code::{G, Group, LetterCycle, M};
use crate::gcode::control::{ALL, Disorder};
use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block::{EdgeWord, letter};
use crate::gcode::interpreter::cursor::{Cursor, Decimal, exponent, letter_for_zero};
use crate::gcode::interpreter::expression::whole;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::letters::Letters;
use crate::gcode::motion::FeedMode;
use crate::gcode::rules::words::{
    BlockRepeated, ChamferWithoutComma, CodeNotSupported, CodeParted, CoordinateTooGreat, CycleInOneBlock,
    DecimalsTooMany, EdgeNoSize, EdgeTwice, FeedOrSpeedTooGreat, LetterNotSupported, LetterUnknown, LocalSubroutine,
    MachineCodeNotFollowed, MachineCodeNotSupported, MachineCodeOfBuilder, MachineCodesTooMany, MacroLanguage, Macros,
    NameNotRead, NameWithDigit, Negative, NumberParted, TwoCodesOfGroup, TwoMachineCodesOfGroup, Unknown, UnknownToAll,
    WordTooGreat, WordTwice, WordsOutOfOrder,
};
use crate::limits::COUNT;
use crate::machine::length_unit::LengthUnit;
use crate::number::grid::LIMIT;
use crate::text::{Text, t};

/// Addresses whose numbers are lengths or angles on the part.
const DIMENSIONS: Letters = Letters::of("ABCIJKRUVWXYZ");
/// The letter E, counted from A = 0.
const E: u8 = b'E' - b'A';

fn macros(column: usize) -> Box<Refused> {
    Refused::of(&Macros {}, &[column])
}

fn name(letter: u8) -> char {
    char::from(letter.to_ascii_uppercase())
}

#[cold]
fn negative(name: char, value: f64, column: usize) -> Box<Refused> {
    Refused::of(&Negative { letter: name, value }, &[column])
}

#[cold]
fn twice(letter: char, first: usize, second: usize) -> Box<Refused> {
    Refused::of(&WordTwice { letter }, &[first, second])
}

/// The number of a G code in tenths.
fn tenths(value: f64) -> Option<usize> {
    whole(value * 10.0).and_then(|tenths| usize::try_from(tenths).ok())
}

/// The number of an M code.
fn machine_number(value: f64) -> Option<u32> {
    whole(value).and_then(|number| u32::try_from(number).ok())
}

/// True where a control has a G or M code that is not refused.
fn read_by_any(letter: char, value: f64) -> bool {
    ALL.iter().any(|control| match letter {
        'G' => {
            let code = tenths(value).and_then(|tenths| control.codes.get(tenths));
            code.is_some_and(|code| !matches!(code, G::Refused(..) | G::RefusedCycle(_)))
        }
        _ => {
            let code = machine_number(value).and_then(|number| (control.machine_code)(number));
            code.is_some_and(|code| !matches!(code, M::Refused(_)))
        }
    })
}

impl Reader<'_, '_> {
    /// Reads the words of a line behind its block number into the block in hand.
    pub(super) fn read_words(&mut self, cursor: &mut Cursor<'_>) -> Result<()> {
        cursor.e_words = self.memory.control.lexis.letters.has(E);
        if !self.memory.control.lexis.language.refuses_macros()
            && let Some(word) = cursor.macro_statement()
        {
            let dialect = self.memory.setting.control.name;
            return Err(Refused::of(&MacroLanguage { word, dialect }, &[cursor.column()]));
        }
        loop {
            match cursor.peek() {
                0 => break,
                _ if self.memory.control.lexis.language.refuses_macros() && cursor.macro_word() => {
                    return Err(macros(cursor.column()));
                }
                b'g' => self.read_g(cursor)?,
                b',' if self.memory.control.corners.by_words() => self.read_edge(cursor)?,
                b'm' if !self.in_letter_cycle() => self.read_m(cursor)?,
                letter @ b'a'..=b'z' => self.read_word(cursor, letter)?,
                b'#' if self.memory.control.lexis.language.computes() => {
                    self.begin_number();
                    let setting = self.setting(cursor)?;
                    self.see_setting(&setting.0);
                    self.block.settings.push(setting);
                }
                b'@' | b'^' if self.memory.control.lexis.polar.by_signs() => self.read_polar(cursor)?,
                b'=' => return Err(self.equals_sign(cursor)),
                _ => return Err(cursor.refuse_character()),
            }
        }
        if let Some(column) = cursor.glued
            && !matches!(self.block.m(5), Some((M::Input | M::AnalogOutput, _)))
        {
            return Err(exponent(column));
        }
        if let Some(D) = self.block.get(letter::D).filter(|D| *D < 0.0)
            && !matches!(self.block.g(Group::CutterCompensation), Some(G::CompensationGiven(_)))
            && !self.in_letter_cycle()
        {
            return Err(negative('D', D, self.block.column(letter::D)));
        }
        if self.block.polar != [None; 2] {
            self.settle_polar()?;
        }
        if let Some(column) = cursor.parted {
            let spot = self.block.spot;
            self.memory.remarks.row(&NumberParted {}, spot, Some(column));
        }
        if self.block.pointless != 0 || self.block.edge.is_some() {
            self.settle_points()?;
        }
        self.feed_and_speed_in_bounds()
    }

    /// Refuses an F or S beyond what a coordinate may be; an F may be greater that is an inverse time, or whose control sets no limit.
    fn feed_and_speed_in_bounds(&self) -> Result<()> {
        for index in [letter::F, letter::S] {
            let Some(value) = self.block.get(index).filter(|value| *value > f64::from(LIMIT) / 1000.0) else {
                continue;
            };
            let mode = match self.block.g(Group::Feed) {
                Some(G::Feed(mode)) => mode,
                _ => self.state.modal.feed_mode,
            };
            if index == letter::F && (mode == FeedMode::InverseTime || !self.memory.control.feed.limit.as_coordinate())
            {
                continue;
            }
            let name = if index == letter::F { 'F' } else { 'S' };
            return Err(Refused::of(&FeedOrSpeedTooGreat { letter: name, value }, &[self.block.column(index)]));
        }
        Ok(())
    }

    /// True behind the code of a turning cycle that takes all letters for itself: M, S, L and others are its parameters.
    pub(super) fn in_letter_cycle(&self) -> bool {
        self.block.g(Group::NonModal).is_some_and(|code| code.by_letters().is_some())
    }

    /// The refusal of `=` behind a word: a name of an axis or a spindle on a control that has such names.
    #[cold]
    fn equals_sign(&self, cursor: &mut Cursor<'_>) -> Box<Refused> {
        let Some(name) = cursor.name_with_digit() else { return cursor.refuse_character() };
        let at = [cursor.column()];
        if self.memory.control.lexis.names.has(&name) {
            Refused::of(&NameWithDigit { name }, &at)
        } else {
            Refused::of(&NameNotRead { name }, &at)
        }
    }

    fn read_g(&mut self, cursor: &mut Cursor<'_>) -> Result<()> {
        let column = cursor.column();
        cursor.pass();
        let value = self.value(cursor)?.value;
        let found = tenths(value).and_then(|tenths| self.memory.control.codes.get(tenths));
        match found {
            Some(G::Refused(_, name) | G::RefusedCycle(name)) => {
                Err(Refused::of(&CodeNotSupported { code: value, reason: name.clone() }, &[column]))
            }
            Some(g) => {
                self.in_order('G', value, column)?;
                self.block.put_g(g, column).map_err(|first| {
                    let group = g.group().name();
                    Refused::of(&TwoCodesOfGroup { group }, &[first, column])
                })
            }
            None if cursor.parted.is_some_and(|parted| parted > column) => {
                Err(Refused::of(&CodeParted { text: cursor.text_from(column) }, &[column]))
            }
            None => Err(self.unknown('G', value, column)),
        }
    }

    fn read_m(&mut self, cursor: &mut Cursor<'_>) -> Result<()> {
        let column = cursor.column();
        cursor.pass();
        let number = self.value(cursor)?;
        self.see_point(b'm' - b'a', &number, column)?;
        let value = number.value;
        let found =
            machine_number(value).and_then(|number| Some((number, (self.memory.control.machine_code)(number)?)));
        match found {
            Some((number, M::Refused(name))) => {
                Err(Refused::of(&MachineCodeNotSupported { code: number, reason: name.clone() }, &[column]))
            }
            Some((number, m)) => {
                self.in_order('M', value, column)?;
                if let M::NotFollowed(name) = m {
                    self.memory.seen.turned.started = true;
                    let row = MachineCodeNotFollowed { code: number, what: name.clone() };
                    let spot = self.block.spot;
                    self.memory.remarks.row(&row, spot, Some(column));
                }
                if m == M::User {
                    self.memory.seen.turned.started = true;
                    let spot = self.block.spot;
                    self.memory.remarks.row(&MachineCodeOfBuilder { code: number }, spot, Some(column));
                    // Codes of the builder do not exclude each other everywhere: clamps M11 and M13 stand in one block.
                    if self.memory.control.lexis.builders.stand_together() {
                        self.block.machine_codes += 1;
                        return self.machine_code_count(column);
                    }
                }
                self.block
                    .put_m(m, number, column)
                    .map_err(|first| Refused::of(&TwoMachineCodesOfGroup {}, &[first, column]))?;
                self.machine_code_count(column)
            }
            None => Err(self.unknown('M', value, column)),
        }
    }

    fn machine_code_count(&self, column: usize) -> Result<()> {
        let most = self.memory.control.lexis.most_machine_codes;
        if self.block.machine_codes <= most {
            return Ok(());
        }
        Err(Refused::of(&MachineCodesTooMany { most }, &[column]))
    }

    #[cold]
    pub(super) fn unknown(&self, letter: char, value: f64, column: usize) -> Box<Refused> {
        let dialect = self.memory.setting.control.name;
        if read_by_any(letter, value) {
            Refused::of(&Unknown { letter, value, dialect }, &[column])
        } else {
            Refused::of(&UnknownToAll { letter, value, dialect }, &[column])
        }
    }

    /// `,C` and `,R`.
    fn read_edge(&mut self, cursor: &mut Cursor<'_>) -> Result<()> {
        let column = cursor.column();
        let Some(round) = cursor.edge() else { return Err(cursor.refuse_character()) };
        cursor.no_comment()?;
        cursor.peek();
        let number_column = cursor.column();
        if cursor.macro_word() {
            return Err(macros(number_column));
        }
        let Decimal { value, point, .. } = self.value(cursor)?;
        let pointing = self.memory.control.lexis.point.of(b'r' - b'a', point);
        let edge = EdgeWord {
            name: if round { ",R" } else { ",C" },
            round,
            value,
            square: None,
            column,
            pointless: pointing.divides() && value != 0.0,
        };
        if let Some(first) = self.block.edge.replace(edge) {
            return Err(Refused::of(&EdgeTwice {}, &[first.column, column]).as_alarm_of(self.alarms()));
        }
        if value.abs() > f64::from(LIMIT) / 1000.0 || value < 0.0 {
            let name = edge.name;
            return Err(Refused::of(&EdgeNoSize { edge: name, value }, &[number_column]));
        }
        Ok(())
    }

    fn read_word(&mut self, cursor: &mut Cursor<'_>, letter: u8) -> Result<()> {
        let column = cursor.column();
        let index = letter - b'a';
        let known = self.memory.control.lexis.letters.has(index);
        if letter == b'o' && cursor.behind_number() {
            return Err(letter_for_zero(column));
        }
        if !(known || (self.in_letter_cycle() && LetterCycle::LETTERS.has(index))) {
            return Err(self.unknown_letter(letter, cursor));
        }
        cursor.pass();
        cursor.no_comment()?;
        cursor.peek();
        let number_column = cursor.column();
        if self.memory.control.lexis.language.refuses_macros() && cursor.macro_word() {
            return Err(macros(number_column));
        }
        self.begin_number();
        let number = self.value(cursor)?;
        self.see_word(letter);
        let value = number.value;
        if DIMENSIONS.has(index) || self.in_letter_cycle() {
            if let Some(most) = self.beyond(letter, value) {
                return Err(Refused::of(&CoordinateTooGreat { letter: name(letter), value, most }, &[number_column]));
            }
        } else if value.abs() > COUNT {
            return Err(Refused::of(&WordTooGreat { letter: name(letter), value }, &[number_column]));
        } else if value < 0.0
            && matches!(letter, b'f' | b's' | b't' | b'd' | b'l' | b'q')
            && !self.memory.control.lexis.negative.has(index)
            && !(letter == b'q' && matches!(self.block.m(5), Some((M::AnalogOutput, _))))
            && !self.in_letter_cycle()
            && !(letter == b'q' && self.memory.control.lexis.polar.by_letters())
        {
            return Err(negative(name(letter), value, number_column));
        }
        if number.decimals > 4 && DIMENSIONS.has(index) {
            self.see_decimals(letter, number.decimals, column);
        }
        self.see_point(index, &number, column)?;
        if self.in_letter_cycle() {
            self.memory.control.lexis.words.take_of_cycle(&mut self.block.seen, name(letter), column);
        } else {
            self.in_order(name(letter), value, column)?;
        }
        self.block.put(index.into(), value, column).map_err(|first| match cursor.glued {
            Some(column) if index == E => exponent(column),
            _ => twice(name(letter), first, column),
        })
    }

    /// Refuses a word behind one that the control wants it to stand before.
    fn in_order(&mut self, letter: char, number: f64, column: usize) -> Result<()> {
        let order = self.memory.control.lexis.words;
        order.take(&mut self.block.seen, letter, number, column).map_err(|Disorder { behind, column: first, error }| {
            let error = error.map_or_else(String::new, |error| format!(" (error {error})"));
            let row = WordsOutOfOrder { word: format!("{letter}{number}"), behind, error };
            Refused::of(&row, &[column, first])
        })
    }

    /// True where the dimensions of the block in hand are inches, as far as it has been read.
    fn in_inch(&self) -> bool {
        self.block.g(Group::Units).map_or(self.state.modal.unit == LengthUnit::Inch, |unit| unit == G::Inch)
    }

    /// The greatest value of a dimension, where a value is beyond it.
    fn beyond(&self, letter: u8, value: f64) -> Option<Text> {
        if value.abs() > f64::from(LIMIT) / 1000.0 {
            return Some(t("99 999.999", "99,999.999"));
        }
        let length = b"uvwxyz".contains(&letter) && !self.in_letter_cycle();
        let most = self.memory.control.lexis.decimals.greatest_inches().filter(|_| length && self.in_inch())?;
        (value.abs() > most).then(|| Text::new(format!("{most} pulgadas"), format!("{most} inches")))
    }

    /// Remarks a dimension with more decimals than the control's manual gives it.
    fn see_decimals(&mut self, letter: u8, decimals: usize, column: usize) {
        let inch = self.in_inch();
        let most = self.memory.control.lexis.decimals.most(inch, b"ijkr".contains(&letter));
        if let Some(most) = most.filter(|&most| decimals > most) {
            let spot = self.block.spot;
            self.memory.remarks.row(&DecimalsTooMany { letter: name(letter), decimals, most }, spot, Some(column));
        }
    }

    #[cold]
    fn unknown_letter(&self, letter: u8, cursor: &Cursor<'_>) -> Box<Refused> {
        let column = cursor.column();
        let (name, dialect) = (name(letter), self.memory.setting.control.name);
        let lexis = &self.memory.control.lexis;
        if letter == b'n' && lexis.behind.repeats() && cursor.ends_block() {
            return Refused::of(&BlockRepeated {}, &[column]);
        }
        if letter == b'q' && lexis.polar.by_letters() {
            return self.polar_by_letters(name, column);
        }
        if letter == b'l' && cursor.doubled() && self.memory.control.text.local_subroutines() {
            return Refused::of(&LocalSubroutine {}, &[column]);
        }
        if let Some(G::Turning(cycle)) = self.block.g(Group::NonModal)
            && matches!(name, 'A' | 'D')
            && !self.in_letter_cycle()
        {
            return Refused::of(&CycleInOneBlock { letter: name, number: cycle.number() }, &[column]);
        }
        if self.memory.control.lexis.refused.has(letter - b'a') {
            match self.without_comma(letter, cursor) {
                Some(size) => Refused::of(&ChamferWithoutComma { letter: name, dialect, size }, &[column]),
                None => Refused::of(&LetterNotSupported { letter: name, dialect }, &[column]),
            }
        } else {
            Refused::of(&LetterUnknown { letter: name, dialect }, &[column])
        }
    }

    /// The size of a C that stands as a chamfer without its comma; `None` where it can be none: the control breaks no corners by
    /// words, or the block is no line at feed.
    fn without_comma(&self, letter: u8, cursor: &Cursor<'_>) -> Option<String> {
        let line = self.block.g(Group::Motion).unwrap_or(self.state.modal.motion) == G::Linear;
        let size = cursor.size_behind();
        let chamfer = letter == b'c' && self.memory.control.corners.by_words() && line && !size.is_empty();
        chamfer.then(|| size.to_owned())
    }
}

#[cfg(test)]
mod tests {
    use crate::gcode::control::{Control, FAGOR_8055, FANUC_LATHE_A, LINUXCNC};
    use crate::gcode::interpreter::{Interpreter, Setting};

    /// The codes of the refusals.
    fn refused(control: &'static Control, program: &str) -> Vec<&'static str> {
        let read = Interpreter::over(program.as_bytes(), Setting::new(control));
        read.filter_map(|item| item.err()).map(|fault| fault.rule.code).collect()
    }

    #[test]
    fn a_feed_is_as_great_as_its_control_takes_it() {
        let program = |feed: &str| format!("G21 G90 S900 M3\nG1 X1 F{feed}\nM2\n");
        assert_eq!(refused(&LINUXCNC, &program("9991300.0")), [""; 0]);
        assert_eq!(refused(&LINUXCNC, &program("9999999999")), [""; 0]);
        assert_eq!(refused(&LINUXCNC, &program("10000000000")), ["G0116"]);
        assert_eq!(refused(&FAGOR_8055, "G71 G90 G94\nG1 X1 F100000\nM30\n"), ["G0105"]);
        assert_eq!(refused(&FANUC_LATHE_A, "G21 G98\nG1 X1. F100000.\nM30\n"), ["G0105"]);
        assert_eq!(refused(&LINUXCNC, "G21 G90\nS100000\nM2\n"), ["G0105"]);
    }

    #[test]
    fn a_parameter_whose_number_is_a_function_is_no_macro() {
        assert_eq!(refused(&LINUXCNC, "G21 G90\n#atan[1]/[1]=3\nG0 X#45\nM2\n"), [""; 0]);
        assert_eq!(refused(&LINUXCNC, "G21 G90\n#foo=3\nM2\n").len(), 1);
        assert!(!refused(&LINUXCNC, "G21 G90\n#foo=3\nM2\n").contains(&"G0129"));
        assert_eq!(refused(&LINUXCNC, "G21 G90\nIF [#1 EQ 1] GOTO 10\nM2\n"), ["G0129"]);
    }

    #[test]
    fn an_o_number_is_refused_by_a_control_that_has_none() {
        for program in ["O1000\nG71 G90\nG0 X1\nM30\n", "%A,MX,\nO1000\nG71 G90\nG0 X1\nM30\n"] {
            assert_eq!(refused(&FAGOR_8055, program), ["G0851"], "{program}");
        }
        assert_eq!(refused(&FANUC_LATHE_A, "O1000\nG21 G98\nG0 X1. Z1.\nM30\n"), [""; 0]);
    }
}
