//! How a program is written: its text, and the blocks that every program needs.

use super::{Control, HeightHold, ToolBlocks};
use crate::gcode::word::Word;

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
