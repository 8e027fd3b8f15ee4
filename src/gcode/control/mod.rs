//! Controls: what one calls what another calls otherwise, and what each does. A control is data, never a flag.
//!
//! # References
//! Fagor CNC 8055 M and 8055 T programming manuals (header `%name,MX--,`, comment `;`, no empty lines, block order
//! G, axes, F, S, T, D, M, numbers ±5.4, N 0–99999999, G70 inch and G71 millimetre, G43/G44 tool length on and off, G94 F
//! of an interpolation of linear and rotary axes along the resultant with degrees taken as millimetres);
//! Fagor CNC 8070 (G93 machining time in seconds); LinuxCNC G-code reference (G93 inverse time, comments in
//! parentheses, G21, G49).

pub mod codes;
mod fagor;
mod fanuc;
pub mod feed;
pub mod guess;
mod linuxcnc;

pub use self::codes::{Codes, Letters};
pub use self::fagor::{FAGOR_8055, FAGOR_8055_T, FAGOR_8070};
pub use self::fanuc::FANUC_LATHE_A;
pub use self::feed::FeedLaw;
pub use self::linuxcnc::LINUXCNC;
use crate::gcode::code::{G, M};
use crate::gcode::motion::{FeedMode, Plane};
use crate::gcode::word::Word;

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

/// How a comment is told from words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comments {
    /// `(...)` anywhere, `;` to the end of the line.
    ParenthesesAndSemicolon,
    /// `;` to the end of the line; a parenthesis opens a statement of the control's high-level language.
    Semicolon,
    /// `(...)` anywhere; `;` ends the block, and what stands behind it is a comment unless it reads as another block.
    Parentheses,
}

/// How T is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turret {
    /// T selects the tool that M6 changes in; offsets are taken by codes of their own.
    Change,
    /// T0A0B turns the turret to place A and puts offset B into force, 0 for none.
    Digits,
    /// T turns the turret, D puts an offset into force; without D the one with the tool's number.
    Words,
}

/// What the centre word of the axis across the plane says in an arc, as K in G17.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Across {
    /// It belongs to no arc of the plane.
    Foreign,
    /// The pitch of a helix, above 0.
    Pitch,
    /// Not known. 0 in an arc that does not leave its plane comes to nothing, whether it is a centre or a pitch.
    Unknown,
}

/// A control: how its programs are read and, where rodete writes for it, how they are written.
#[derive(Debug)]
pub struct Control {
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
    /// Addresses that may stand in a block, beside G, M and N.
    pub letters: Letters,
    /// Addresses of the control that are refused by name.
    pub refused_letters: Letters,
    /// Addresses that need no code beside them.
    pub free: Letters,
    /// The G codes.
    pub codes: &'static Codes,
    /// The meaning of an M code.
    pub machine_code: fn(u32) -> Option<M>,
    /// Comments.
    pub comments: Comments,
    /// Parameters, expressions and O-words.
    pub expressions: bool,
    /// Most characters of a line.
    pub longest_line: usize,
    /// A feed move without any F is refused; else it gets a Caution, as the control takes the F it has.
    pub feed_required: bool,
    /// The plane in force at the start.
    pub plane: Plane,
    /// Where canned cycles return to before any code has said so: true for the height that they started from, false for R.
    pub return_initial: bool,
    /// X is a diameter.
    pub diameter: bool,
    /// Fanuc's G-code system A: U and W are increments of X and Z; what a dimension without a decimal point is, mm or µm,
    /// the control's setting decides; subprograms are called by their program's or their block's number.
    pub system_a: bool,
    /// How T is meant.
    pub turret: Turret,
    /// The motion code in force at the start, [`G::Cancel`] for none, and what F means.
    pub start: (G, FeedMode),
    /// Most calls of subprograms inside one another.
    pub call_depth: usize,
    /// The addresses of a dwell, counted from A = 0, each with what its number is multiplied with to give seconds.
    pub dwell: &'static [(u8, f64)],
    /// What the centre word of the axis across the plane says.
    pub across: Across,
    /// Most M codes in one block.
    pub most_machine_codes: usize,
}

/// All controls, as they are named on the command line.
pub static ALL: [&Control; 5] = [&LINUXCNC, &FAGOR_8055, &FAGOR_8070, &FAGOR_8055_T, &FANUC_LATHE_A];

/// The milling controls.
pub static MILLING: [&Control; 3] = [&FAGOR_8055, &FAGOR_8070, &LINUXCNC];

impl PartialEq for Control {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for Control {}

impl Control {
    /// The control with a name.
    #[must_use]
    pub fn named(name: &str) -> Option<&'static Self> {
        ALL.into_iter().find(|control| control.name == name)
    }

    /// The milling control with a name.
    #[must_use]
    pub fn milling(name: &str) -> Option<&'static Self> {
        MILLING.into_iter().find(|control| control.name == name)
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

    /// True where an M code may stand by itself in a block of the control.
    #[must_use]
    pub fn knows_machine_code(&self, number: u32) -> bool {
        !matches!((self.machine_code)(number), None | Some(M::Refused(_) | M::Call | M::Return | M::SetTool))
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
