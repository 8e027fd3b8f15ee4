//! How a tool is called, read and written.

use crate::gcode::letters::Letters;
use crate::gcode::word::Word;

/// How T is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToolCall {
    /// T selects the tool that M6 changes in; offsets are taken by codes of their own.
    Change,
    /// T0A0B turns the turret to place A and puts offset B into force, 0 for none. The machine starts without an offset.
    Digits,
    /// T turns the turret, D puts an offset into force; without D the one with the tool's number. Tool and offset stay over the
    /// end of a program.
    Words,
}

impl ToolCall {
    /// True where the offset stays in force over the end of a program.
    #[must_use]
    pub const fn keeps_offset(self) -> bool {
        match self {
            Self::Digits => false,
            Self::Change | Self::Words => true,
        }
    }

    /// True where codes of their own take offsets: T and D alone take up no length.
    #[must_use]
    pub const fn offsets_by_codes(self) -> bool {
        match self {
            Self::Change => true,
            Self::Digits | Self::Words => false,
        }
    }

    /// The word that calls a tool and no offset, where a cut under it is told, and one with the tool's own: a T that names both may
    /// have its 0 by slip. `None` where an offset has a word of its own.
    #[must_use]
    pub fn without_offset(self, tool: u32) -> Option<[String; 2]> {
        match self {
            Self::Digits if tool == 0 => Some(["T0".to_owned(), "T0202".to_owned()]),
            Self::Digits => Some([format!("T{tool:02}00"), format!("T{tool:02}{tool:02}")]),
            Self::Change | Self::Words => None,
        }
    }
}

/// The blocks that call a tool with its offset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToolBlocks {
    /// `T1 M6`
    Change,
    /// `T1 D1 M6`
    OffsetAndChange,
    /// `T1 D1`, then `M6`
    OffsetThenChange,
    /// `T1 D1`
    Turret,
}

impl ToolBlocks {
    /// True where no page says whether D by itself brings the length of the control's table into force.
    #[must_use]
    pub const fn may_bring_length(self) -> bool {
        match self {
            Self::OffsetAndChange => true,
            Self::Change | Self::OffsetThenChange | Self::Turret => false,
        }
    }

    /// The blocks that bring a tool and its offset D to work.
    #[must_use]
    pub fn blocks(self, T: u32, D: u32) -> Vec<Vec<Word>> {
        let [T, D, change] = [('T', T), ('D', D), ('M', 6)].map(|(letter, number)| Word::whole(letter, number));
        match self {
            Self::Change => vec![vec![T, change]],
            Self::OffsetAndChange => vec![vec![T, D, change]],
            Self::OffsetThenChange => vec![vec![T, D], vec![change]],
            Self::Turret => vec![vec![T, D]],
        }
    }
}

/// What M6 wants and does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToolChange {
    /// A tool that T has selected; the spindle stands behind it.
    Selected,
    /// A routine of the machine's: with no tool selected none is changed.
    Routine,
}

/// The letter of a tool's length offset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LengthWord {
    /// H, beside G43.
    H,
    /// D: a row of the table of offsets.
    D,
    /// D: an offset of the tool's own, D1 where none is written (Fagor CNC 8070, programming manual, Ref. 1709, p. 240).
    OfTool,
}

impl LengthWord {
    /// True where G43, G44 and another offset under G43 wait for the next motion of Z: a control with D (Fagor CNC 8055 M, programming
    /// manual, p. 144). With H the length counts at once.
    #[must_use]
    pub const fn waits_for_motion(self) -> bool {
        match self {
            Self::H => false,
            Self::D | Self::OfTool => true,
        }
    }

    /// H or D, as a program writes it.
    #[must_use]
    pub const fn letter(self) -> char {
        match self {
            Self::H => 'H',
            Self::D | Self::OfTool => 'D',
        }
    }

    /// The same as a set.
    #[must_use]
    pub const fn letters(self) -> Letters {
        match self {
            Self::H => Letters::of("H"),
            Self::D | Self::OfTool => Letters::of("D"),
        }
    }

    /// True where the offset is one of the tool's own, and not a row of a table that all tools share.
    #[must_use]
    pub const fn of_tool(self) -> bool {
        match self {
            Self::H | Self::D => false,
            Self::OfTool => true,
        }
    }
}
