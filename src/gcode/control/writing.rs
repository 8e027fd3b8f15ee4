//! How a program is written: its text, and the blocks that every program needs.

use super::{Control, HeightHold, TURNING, ToolBlocks};
use crate::gcode::code::LetterCycle;
use crate::gcode::word::Word;
use crate::text::Text;

/// How comments are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CommentForm {
    /// `;text`
    Semicolon,
    /// `(text)`
    Parentheses,
}

impl CommentForm {
    /// True of a line without a block: a comment alone, the mark of a tape's end, nothing.
    #[must_use]
    pub fn is_no_block(self, line: &str) -> bool {
        let line = line.trim();
        let comment = match self {
            Self::Parentheses => line.starts_with('(') && line.find(')') == line.len().checked_sub(1),
            Self::Semicolon => line.starts_with(';'),
        };
        comment || line.is_empty() || line == "%"
    }
}

/// A line before the first block of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OpeningLine {
    /// `%` alone.
    Percent,
    /// `O1234`: the program's number.
    Number,
    /// `%1234-NAME`
    Name,
    /// `%1234-NAME,MX--,`: name and attributes (modifiable, executable).
    NameAndAttributes,
}

/// The attributes behind the name of a program.
const ATTRIBUTES: &str = ",MX--,";

impl OpeningLine {
    /// The line of a program with a number and a name, which is written in capitals.
    #[must_use]
    pub fn text(self, number: u32, name: &str) -> String {
        let name = name.to_uppercase();
        match self {
            Self::Percent => "%".to_owned(),
            Self::Number => format!("O{number:04}"),
            Self::Name => format!("%{number:04}-{name}"),
            Self::NameAndAttributes => format!("%{number:04}-{name}{ATTRIBUTES}"),
        }
    }

    /// The program's number in a line that has this form; `None` in any other, or where the form has none.
    #[must_use]
    pub fn number(self, line: &str) -> Option<u32> {
        let numbered = match self {
            Self::Percent => None,
            Self::Number => line.strip_prefix('O'),
            Self::Name | Self::NameAndAttributes => line.strip_prefix('%'),
        };
        let digits = numbered.filter(|_| self.is(line))?;
        digits.split('-').next()?.parse().ok()
    }

    /// True of a line that has this form, whatever the number and the name.
    #[must_use]
    pub fn is(self, line: &str) -> bool {
        let numbered = |text: &str| text.len() >= 4 && text.bytes().all(|byte| byte.is_ascii_digit());
        let named = |text: &str| {
            let parts = text.strip_prefix('%').and_then(|text| text.split_once('-'));
            parts.is_some_and(|(number, name)| {
                numbered(number) && !name.is_empty() && !name.contains([',', '%']) && name.to_uppercase() == name
            })
        };
        match self {
            Self::Percent => line == "%",
            Self::Number => line.strip_prefix('O').is_some_and(numbered),
            Self::Name => named(line),
            Self::NameAndAttributes => line.strip_suffix(ATTRIBUTES).is_some_and(named),
        }
    }

    /// True where attributes follow the name, without which the control runs no program.
    #[must_use]
    pub const fn attributes(self) -> bool {
        match self {
            Self::NameAndAttributes => true,
            Self::Percent | Self::Number | Self::Name => false,
        }
    }

    /// True where `%L` opens a subroutine before the program and LL calls it.
    #[must_use]
    pub const fn local_subroutines(self) -> bool {
        match self {
            Self::Name => true,
            Self::Percent | Self::Number | Self::NameAndAttributes => false,
        }
    }
}

/// How the control wants the file of a program named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileName {
    /// No page was at hand that names a form.
    Any,
    /// Six digits and an ending: it does not list another file.
    SixDigits(&'static str),
}

impl FileName {
    /// The name of a program's file at the control, by the program's number, or its form where the program has none of up to six digits;
    /// `None` where any name will do.
    #[must_use]
    pub fn told(self, number: Option<u32>) -> Option<Text> {
        match self {
            Self::Any => None,
            Self::SixDigits(ending) => Some(match number.filter(|&number| number < 1_000_000) {
                Some(number) => Text::same(format!("{number:06}.{ending}")),
                None => Text::new(format!("seis cifras y .{ending}"), format!("six digits and .{ending}")),
            }),
        }
    }
}

/// What the text of a program looks like on the control, whoever wrote it.
#[derive(Clone, Copy, Debug)]
pub struct TextForm {
    /// The lines before the first block and its comments; none where a program begins with them.
    pub opening: &'static [OpeningLine],
    /// The lines behind the last block of a program that has the opening, as `%`; none where the last block ends the text.
    pub ending: &'static [&'static str],
    /// How comments are marked where rodete writes them.
    pub comment: CommentForm,
    /// What ends a line: LF, or CR and LF.
    pub end_of_line: &'static str,
    /// The greatest block number N that rodete writes.
    pub greatest_number: u32,
    /// Memory for one program in bytes, beyond which a Caution is given.
    pub memory: u64,
    /// The name of its file at the control.
    pub file: FileName,
}

impl TextForm {
    /// True where attributes follow the name of a program, without which the control does not run it.
    #[must_use]
    pub fn attributes(&self) -> bool {
        self.opening.iter().any(|line| line.attributes())
    }

    /// True where `%L` opens a subroutine before the program and LL calls it.
    #[must_use]
    pub fn local_subroutines(&self) -> bool {
        self.opening.iter().any(|line| line.local_subroutines())
    }
}

/// The post-processor of a control that rodete writes for.
#[derive(Clone, Copy, Debug)]
pub struct Post {
    /// The control that is written for.
    pub control: &'static Control,
    /// How rodete writes for it.
    pub writing: &'static Writing,
}

impl Post {
    /// The control, where rodete writes for it.
    #[must_use]
    pub fn of(control: &'static Control) -> Option<Self> {
        control.written.map(|writing| Self { control, writing })
    }

    /// The first lathe of [`TURNING`] that rodete writes for and that has a turning cycle. For a cycle that none of them has no constant
    /// compiles.
    #[must_use]
    pub const fn turning_with(cycle: LetterCycle) -> Self {
        let mut at = 0;
        while at < TURNING.len() {
            let control = TURNING[at];
            if let Some(writing) = control.written
                && control.codes.turn_by(cycle)
            {
                return Self { control, writing };
            }
            at += 1;
        }
        panic!("no lathe that rodete writes for has the cycle")
    }
}

/// Whether it has been read that G53 counts from machine zero whatever tool offset is in force, as a block that takes the tool away needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MachineZero {
    /// It has been read.
    Read,
    /// No page was at hand: it is taken so, and told.
    Assumed,
}

impl MachineZero {
    /// True where a block that takes the tool away by it is told.
    #[must_use]
    pub const fn told_of(self) -> bool {
        match self {
            Self::Read => false,
            Self::Assumed => true,
        }
    }
}

/// How rodete writes for a control.
#[derive(Clone, Copy, Debug)]
pub struct Writing {
    /// The block that puts the control into a known state: plane, units, no compensation, absolute, work offset.
    pub safety: &'static [(char, u32)],
    /// In which blocks a tool is called.
    pub tool: ToolBlocks,
    /// The height control of a torch.
    pub height: HeightHold,
    /// The M codes by which published programs for this control release the clamps of the rotary axes, the builder's of that machine;
    /// none where no such program was published.
    pub clamps: &'static [u32],
    /// What a retract by G53 counts from.
    pub zero: MachineZero,
}

impl Writing {
    /// The words of [`Self::safety`], in one block.
    #[must_use]
    pub fn safety_block(&self) -> Vec<Word> {
        self.safety.iter().map(|&(letter, number)| Word::whole(letter, number)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::OpeningLine;
    use crate::gcode::control::{ALL, FAGOR_8055, FAGOR_8055_T, FAGOR_8070, LINUXCNC};

    #[test]
    fn a_fagor_8055_lists_files_of_six_digits_and_its_ending() {
        let told = [
            (&FAGOR_8055, Some(1)),
            (&FAGOR_8055_T, Some(123_456)),
            (&FAGOR_8055, None),
            (&FAGOR_8055, Some(1_000_000)),
        ]
        .map(|(control, number)| control.text.file.told(number).expect("a form").en.into_owned());
        assert_eq!(told, ["000001.PIM", "123456.PIT", "six digits and .PIM", "six digits and .PIM"]);
        assert!([&FAGOR_8070, &LINUXCNC].iter().all(|control| control.text.file.told(Some(1)).is_none()));
    }

    #[test]
    fn the_lines_of_an_opening_have_their_own_form_alone() {
        use OpeningLine::{Name, NameAndAttributes, Number, Percent};
        let all = [Percent, Number, Name, NameAndAttributes];
        let texts = all.map(|line| line.text(42, "hole"));
        assert_eq!(texts, ["%", "O0042", "%0042-HOLE", "%0042-HOLE,MX--,"]);
        assert_eq!([0, 1, 2, 3].map(|at| all[at].number(&texts[at])), [None, Some(42), Some(42), Some(42)]);
        assert_eq!(all.map(|line| line.number("G0 X42")), [None; 4]);
        for (line, own) in all.iter().zip(&texts) {
            for text in &texts {
                assert_eq!(line.is(text), text == own, "{line:?}: {text}");
            }
            for text in
                ["", "O42", "O00x2", "%42-HOLE", "%0042-", "%0042-hole", "%0042-HOLE,M---,", "G0 X1", "% ", "O0042 "]
            {
                assert!(!line.is(text), "{line:?}: {text}");
            }
        }
    }

    #[test]
    fn a_text_that_has_an_ending_has_an_opening() {
        for control in ALL {
            assert!(control.text.ending.is_empty() || !control.text.opening.is_empty(), "{}", control.name);
        }
    }
}
