//! How a tool is called, read and written.

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
    /// D.
    D,
}

impl LengthWord {
    /// The letter.
    #[must_use]
    pub const fn letter(self) -> char {
        match self {
            Self::H => 'H',
            Self::D => 'D',
        }
    }
}
