//! How a program is written: its text, and the blocks that every program needs.

use super::{Control, HeightHold, ToolBlocks};
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

/// The first line of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Opening {
    /// There is none: the program begins with its first block.
    None,
    /// `%name,MX--,`: name and attributes (modifiable, executable).
    NameAndAttributes,
    /// `%name`
    Name,
}

impl Opening {
    /// True where attributes follow the name, without which the control runs no program.
    #[must_use]
    pub const fn attributes(self) -> bool {
        match self {
            Self::NameAndAttributes => true,
            Self::None | Self::Name => false,
        }
    }

    /// True where `%L` opens a subroutine before the program and LL calls it.
    #[must_use]
    pub const fn local_subroutines(self) -> bool {
        match self {
            Self::Name => true,
            Self::None | Self::NameAndAttributes => false,
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
    /// The first line.
    pub opening: Opening,
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
    /// The first line of a program with a number and a name; `None` where there is none.
    #[must_use]
    pub fn opening_line(&self, number: u32, name: &str) -> Option<String> {
        let name = name.to_uppercase();
        match self.opening {
            Opening::None => None,
            Opening::Name => Some(format!("%{number:04}-{name}")),
            Opening::NameAndAttributes => Some(format!("%{number:04}-{name},MX--,")),
        }
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
    use crate::gcode::control::{FAGOR_8055, FAGOR_8055_T, FAGOR_8070, LINUXCNC};

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
}
