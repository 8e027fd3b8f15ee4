//! Dialects: what one control calls what another calls otherwise. A named type with a table, never a flag.
//!
//! # References
//! Fagor CNC 8055 M and 8055 T programming manuals (header `%name,MX--,`, comment `;`, no empty lines, block order
//! G, axes, F, S, T, D, M, numbers ±5.4, N 0–99999999, G70 inch and G71 millimetre, G43/G44 tool length on and off, G94 F
//! of an interpolation of linear and rotary axes along the resultant with degrees taken as millimetres);
//! Fagor CNC 8070 (G93 machining time in seconds); LinuxCNC G-code reference (G93 inverse time, comments in
//! parentheses, G21, G49).

mod fagor;
mod fanuc;
pub mod guess;
mod linuxcnc;
pub mod reading;

use crate::gcode::code::M;
use crate::gcode::dialect::reading::Reading;
use crate::gcode::word::Word;
use crate::limits::FEED_WORD;

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

    /// The least time in seconds for which there is an F word.
    #[must_use]
    pub fn least_seconds(self, resultant: f64) -> f64 {
        match self {
            Self::Resultant => resultant * 60.0 / FEED_WORD,
            Self::Seconds => 1e-4,
            Self::InverseTime => 60.0 / FEED_WORD,
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

/// What an absolute word of a rotary axis means: a setting of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rotary {
    /// The position, counted on beyond a turn as on a linear axis.
    Linear,
    /// The number is the angle to go to, 0 to 359.9999 degrees, and the sign the direction of the turn.
    Rollover,
}

impl Rotary {
    /// The name on the command line and in JSON.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Rollover => "rollover",
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
#[derive(Debug)]
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
    /// What rotary axes are on a machine as the control is delivered.
    pub rotary: Rotary,
    /// Memory for one program in bytes, beyond which a Caution is given.
    pub memory: u64,
    /// How programs are read.
    pub reading: &'static Reading,
}

/// Fagor CNC 8055, milling.
pub static FAGOR_8055: Dialect = Dialect {
    name: "fagor-8055",
    safety: &[('G', 17), ('G', 40), ('G', 44), ('G', 54), ('G', 71), ('G', 90), ('G', 94)],
    change_in_tool_block: false,
    ..FAGOR_8055_BASE
};

/// Fagor CNC 8055 T, turning.
pub static FAGOR_8055_T: Dialect = Dialect { name: "fagor-8055-t", reading: &fagor::TURNING_8055, ..FAGOR_8055_BASE };

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
    rotary: Rotary::Rollover,
    memory: 1 << 20,
    reading: &fagor::MILLING_8055,
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
    rotary: Rotary::Linear,
    memory: 1 << 30,
    reading: &fagor::MILLING_8070,
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
    rotary: Rotary::Linear,
    memory: 1 << 30,
    reading: &linuxcnc::READING,
};

/// Fanuc, turning, G-code system A. Read only: rodete writes no program in it.
pub static FANUC_LATHE_A: Dialect = Dialect {
    name: "fanuc-lathe-a",
    opening: Opening::None,
    comment: CommentForm::Parentheses,
    end_of_line: "\r\n",
    greatest_number: 99_999,
    safety: &[],
    change_in_tool_block: true,
    offset_word: false,
    feed: FeedLaw::Resultant,
    rotary: Rotary::Linear,
    memory: 1 << 19,
    reading: &fanuc::LATHE_A,
};

/// All dialects, as they are named on the command line.
pub static ALL: [&Dialect; 5] = [&LINUXCNC, &FAGOR_8055, &FAGOR_8070, &FAGOR_8055_T, &FANUC_LATHE_A];

/// The milling dialects.
pub static MILLING: [&Dialect; 3] = [&FAGOR_8055, &FAGOR_8070, &LINUXCNC];

impl PartialEq for Dialect {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for Dialect {}

impl Dialect {
    /// The dialect with a name.
    #[must_use]
    pub fn named(name: &str) -> Option<&'static Self> {
        ALL.into_iter().find(|dialect| dialect.name == name)
    }

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

    /// True where an M code may stand by itself in a block of the dialect.
    #[must_use]
    pub fn knows_machine_code(&self, number: u32) -> bool {
        !matches!((self.reading.machine_code)(number), None | Some(M::Refused(_) | M::Call | M::Return | M::SetTool))
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
