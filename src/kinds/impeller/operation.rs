//! What the programs of an impeller do, and how they are named after it.

use crate::gcode::program::Program;

/// What a program of an impeller does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operation {
    /// Mills one blade along the published paths.
    Blade,
    /// Mills one splitter along the published paths.
    Splitter,
    /// Mills all blades and splitters along the published paths.
    Whole,
    /// Turns the blank on a lathe with G85.
    Blank,
    /// Roughs a clear cut.
    Rough,
    /// Finishes a clear cut.
    Finish,
}

impl Operation {
    /// All of them, in the order of their sheets.
    pub const ALL: [Self; 6] = [Self::Blade, Self::Splitter, Self::Whole, Self::Blank, Self::Rough, Self::Finish];

    /// The keys of the programs, in the same order.
    pub const KEYS: [&'static str; Self::ALL.len()] = {
        let mut keys = [""; Self::ALL.len()];
        let mut at = 0;
        while at < keys.len() {
            keys[at] = Self::ALL[at].key();
            at += 1;
        }
        keys
    };

    /// The key of its program, which names the sheet and the file.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Blade => "blade",
            Self::Splitter => "splitter",
            Self::Whole => "impeller",
            Self::Blank => "blank",
            Self::Rough => "rough",
            Self::Finish => "finish",
        }
    }

    /// What a program does; `None` for a program that is none of an impeller's.
    #[must_use]
    pub fn of(program: &Program) -> Option<Self> {
        Self::ALL.into_iter().find(|operation| operation.key() == program.key)
    }
}
