//! Controls: what one calls what another calls otherwise, and what each does. A control is data, never a flag.
//!
//! # References
//! Fagor CNC 8055 M and 8055 T programming manuals (header `%name,MX--,`, comment `;`, no empty lines, block order
//! G, axes, F, S, T, D, M, numbers ±5.4, N 0–99999999, G70 inch and G71 millimetre, G43/G44 tool length on and off, G94 F
//! of an interpolation of linear and rotary axes along the resultant with degrees taken as millimetres);
//! Fagor CNC 8070 (G93 machining time in seconds); LinuxCNC G-code reference (G93 inverse time, comments in
//! parentheses, G21, G49).

#![deny(clippy::wildcard_enum_match_arm)]

mod axes;
mod codes;
mod fagor;
mod fanuc;
mod feed;
pub mod guess;
mod lexis;
mod linuxcnc;
mod order;
mod output;
mod path;
mod rotary;
mod spindle;
mod tool;

pub use self::axes::{Across, AcrossWord, ArcWords, AxisWords, Increments};
pub use self::codes::{Codes, Letters};
pub use self::fagor::{FAGOR_8055, FAGOR_8055_T, FAGOR_8070};
pub use self::fanuc::FANUC_LATHE_A;
pub use self::feed::{FeedChange, FeedCodes, FeedLaw, FeedPath, FeedRule, MissingFeed};
pub use self::lexis::{BlockDelete, BuilderCodes, Comments, DimensionPoint, Language, Lexis, Percent};
pub use self::linuxcnc::LINUXCNC;
pub use self::order::{CallBy, Calls, Cancel, MachineMove, OffsetRule, Order, Reference};
pub use self::output::HeightHold;
pub use self::path::{Corners, Drilling, NoseCorner, RadiusRule, Retract};
pub use self::rotary::{Rollover, Rotary, RotaryRule};
pub use self::spindle::{SpeedLimit, SpindleRule, Turns};
pub use self::tool::{LengthWord, ToolCall, ToolChange};
use crate::finding::AlarmFamily;
use crate::gcode::code::{G, M};
use crate::gcode::motion::{FeedMode, Plane};
use crate::gcode::word::Word;

/// What stands in the chuck.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// The tool: X, Y, Z and more axes.
    Mill,
    /// The part, turned about Z: X is written as a diameter and shown so.
    Lathe,
}

/// What is in force at the start.
#[derive(Clone, Copy, Debug)]
pub struct Start {
    /// The motion code, [`G::Cancel`] for none.
    pub motion: G,
    /// What F means.
    pub feed: FeedMode,
    /// The plane.
    pub plane: Plane,
    /// Where canned cycles return to.
    pub retract: Retract,
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

/// A control: how its programs are read and, where rodete writes for it, how they are written.
///
/// It is data: each behaviour is obeyed at one place, and no code asks which control it is. Controls cannot be compared.
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
    /// How F of a move that linear and rotary axes make together is written.
    pub law: FeedLaw,
    /// The height control of a torch.
    pub height: HeightHold,
    /// Memory for one program in bytes, beyond which a Caution is given.
    pub memory: u64,
    /// Mill or lathe.
    pub class: Class,
    /// The characters of a program.
    pub lexis: Lexis,
    /// The G codes.
    pub codes: &'static Codes,
    /// The meaning of an M code.
    pub machine_code: fn(u32) -> Option<M>,
    /// What is in force at the start.
    pub start: Start,
    /// The order of execution.
    pub order: Order,
    /// Axis words.
    pub axes: AxisWords,
    /// Words of arcs.
    pub arcs: ArcWords,
    /// Rotary axes.
    pub rotary: RotaryRule,
    /// F.
    pub feed: FeedRule,
    /// S.
    pub spindle: SpindleRule,
    /// T.
    pub tool: ToolCall,
    /// M6.
    pub change: ToolChange,
    /// The letter of a length offset.
    pub length: LengthWord,
    /// G54 to G59, G50 and G92.
    pub offsets: OffsetRule,
    /// G80.
    pub cancel: Cancel,
    /// G53.
    pub machine_move: MachineMove,
    /// G28 and G30.
    pub reference: Reference,
    /// Corners between lines.
    pub corners: Corners,
    /// G41 and G42.
    pub radius: RadiusRule,
    /// G81 to G89.
    pub drilling: Drilling,
    /// Subprograms.
    pub calls: Calls,
    /// The family of its alarms, where their numbers are known.
    pub alarms: Option<AlarmFamily>,
}

/// All controls, as they are named on the command line.
pub static ALL: [&Control; 5] = [&LINUXCNC, &FAGOR_8055, &FAGOR_8070, &FAGOR_8055_T, &FANUC_LATHE_A];

/// The milling controls.
pub static MILLING: [&Control; 3] = [&FAGOR_8055, &FAGOR_8070, &LINUXCNC];

impl Control {
    /// True for a lathe, whose part turns and whose X is a diameter.
    #[must_use]
    pub const fn turns(&self) -> bool {
        match self.class {
            Class::Lathe => true,
            Class::Mill => false,
        }
    }

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
