//! Dialects: what one control calls what another calls otherwise. A named type with a table, never a flag.
//!
//! # References
//! Fagor CNC 8055 M and 8055 T programming manuals (header `%name,MX--,`, comment `;`, no empty lines, block order
//! G, axes, F, S, T, D, M, numbers ±5.4, N 0–99999999, G70 inch and G71 millimetre, G43/G44 tool length on and off, G94 F
//! of an interpolation of linear and rotary axes along the resultant with degrees taken as millimetres);
//! Fagor CNC 8070 (G93 machining time in seconds); LinuxCNC G-code reference (G93 inverse time, comments in
//! parentheses, G21, G49).

use crate::gcode::word::Word;

/// How the control takes the F word of a move that linear and rotary axes make together. In each form the move takes
/// the time that the tool tip needs over the part at the wanted feed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FeedLaw {
    /// G94: F along the resultant of all axes, degrees taken as millimetres.
    Resultant,
    /// G93: F is the time of the move in seconds.
    Seconds,
    /// G93: F is the inverse of the time of the move in minutes.
    InverseTime,
}

impl FeedLaw {
    /// True where F is not modal: it belongs to its own move.
    #[must_use]
    pub const fn in_every_block(self) -> bool {
        !matches!(self, Self::Resultant)
    }

    /// The G code that selects it.
    #[must_use]
    pub const fn code(self) -> u32 {
        match self {
            Self::Resultant => 94,
            Self::Seconds | Self::InverseTime => 93,
        }
    }

    /// The F word of a move that is to take some seconds, whose resultant over all axes (mm and degrees) is given.
    #[must_use]
    pub fn word(self, seconds: f64, resultant: f64) -> f64 {
        match self {
            Self::Resultant => resultant * 60.0 / seconds,
            Self::Seconds => seconds,
            Self::InverseTime => 60.0 / seconds,
        }
    }

    /// The time in seconds that a move takes with an F word.
    #[must_use]
    pub fn seconds(self, word: f64, resultant: f64) -> f64 {
        match self {
            Self::Resultant => resultant * 60.0 / word,
            Self::Seconds => word,
            Self::InverseTime => 60.0 / word,
        }
    }
}

/// How comments are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CommentForm {
    /// `;text`
    Semicolon,
    /// `(text)`
    Parentheses,
}

/// The first line of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Opening {
    /// None.
    None,
    /// `%name,MX--,`: name and attributes (modifiable, executable).
    NameAndAttributes,
    /// `%name`
    Name,
}

/// A dialect.
#[derive(Debug, PartialEq, Eq)]
pub struct Dialect {
    /// The name in workbooks and on the command line.
    pub name: &'static str,
    /// The first line.
    pub opening: Opening,
    /// The form of comments.
    pub comment: CommentForm,
    /// The end of a line.
    pub end_of_line: &'static str,
    /// The greatest block number.
    pub greatest_number: u32,
    /// The block that puts the control into a known state: plane, units, no compensation, absolute, work offset.
    pub safety: &'static [(char, u32)],
    /// True where tool and offset are called in one block with the change (`T1 D1 M6`), false where M6 follows.
    pub change_in_tool_block: bool,
    /// True where the tool block carries the D word.
    pub offset_word: bool,
    /// How feed is programmed.
    pub feed: FeedLaw,
    /// The M codes that the control knows; `None` where the machine's builder defines them freely up to M9999.
    pub machine_codes: Option<&'static [u32]>,
    /// Memory for one program in bytes, beyond which a Caution is given.
    pub memory: u64,
}

/// Fagor CNC 8055, milling.
pub static FAGOR_8055: Dialect = Dialect {
    name: "fagor-8055",
    safety: &[('G', 17), ('G', 40), ('G', 44), ('G', 54), ('G', 71), ('G', 90), ('G', 94)],
    change_in_tool_block: false,
    ..FAGOR_8055_BASE
};

/// Fagor CNC 8055 T, turning.
pub static FAGOR_8055_T: Dialect = Dialect { name: "fagor-8055-t", ..FAGOR_8055_BASE };

/// What milling and turning have in common.
const FAGOR_8055_BASE: Dialect = Dialect {
    name: "",
    opening: Opening::NameAndAttributes,
    comment: CommentForm::Semicolon,
    end_of_line: "\r\n",
    greatest_number: 99_999_999,
    safety: &[],
    change_in_tool_block: true,
    offset_word: true,
    feed: FeedLaw::Resultant,
    machine_codes: None,
    memory: 1 << 20,
};

/// Fagor CNC 8070, milling.
pub static FAGOR_8070: Dialect = Dialect {
    name: "fagor-8070",
    opening: Opening::Name,
    comment: CommentForm::Semicolon,
    end_of_line: "\r\n",
    greatest_number: 99_999_999,
    safety: &[('G', 17), ('G', 40), ('G', 54), ('G', 71), ('G', 90), ('G', 94)],
    change_in_tool_block: true,
    offset_word: true,
    feed: FeedLaw::Seconds,
    machine_codes: None,
    memory: 1 << 30,
};

/// LinuxCNC, milling.
pub static LINUXCNC: Dialect = Dialect {
    name: "linuxcnc",
    opening: Opening::None,
    comment: CommentForm::Parentheses,
    end_of_line: "\n",
    greatest_number: 99_999,
    safety: &[('G', 17), ('G', 21), ('G', 40), ('G', 49), ('G', 54), ('G', 80), ('G', 90), ('G', 94), ('G', 97)],
    change_in_tool_block: true,
    offset_word: false,
    feed: FeedLaw::InverseTime,
    machine_codes: Some(&[0, 1, 2, 3, 4, 5, 7, 8, 9, 30, 48, 49, 50, 51, 53, 60]),
    memory: 1 << 30,
};

/// The milling dialects.
pub static MILLING: [&Dialect; 3] = [&FAGOR_8055, &FAGOR_8070, &LINUXCNC];

impl Dialect {
    /// The milling dialect with a name.
    #[must_use]
    pub fn milling(name: &str) -> Option<&'static Self> {
        MILLING.into_iter().find(|dialect| dialect.name == name)
    }

    /// The safety block.
    #[must_use]
    pub fn safety_block(&self) -> Vec<Word> {
        self.safety.iter().map(|&(letter, number)| Word::whole(letter, number)).collect()
    }

    /// The blocks that bring a tool into the spindle.
    #[must_use]
    pub fn tool_blocks(&self, T: u32, D: u32) -> Vec<Vec<Word>> {
        let mut block = vec![Word::whole('T', T)];
        if self.offset_word {
            block.push(Word::whole('D', D));
        }
        if self.change_in_tool_block {
            block.push(Word::whole('M', 6));
            vec![block]
        } else {
            vec![block, vec![Word::whole('M', 6)]]
        }
    }

    /// True where the control knows an M code.
    #[must_use]
    pub fn knows_machine_code(&self, number: u32) -> bool {
        self.machine_codes.is_none_or(|known| known.contains(&number) || (100..=199).contains(&number))
    }

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
