//! Controls: what one calls what another calls otherwise, and what each does. A control is data, never a flag.
//!
//! What each is read from stands in its `sources`; `rodete explain --controls` prints all of it.

#![deny(clippy::wildcard_enum_match_arm)]

mod axes;
mod codes;
mod dwell;
mod fagor;
mod fagor_8055;
mod fagor_8055_t;
mod fagor_8070;
mod fanuc;
mod feed;
pub mod foreign;
pub mod guess;
mod lexis;
mod linuxcnc;
mod order;
mod output;
mod path;
mod point;
mod rotary;
mod source;
mod spindle;
mod told;
mod tool;
mod word_order;
mod writing;

pub use self::axes::{Across, AcrossWord, ArcWords, AxisWords, Increments, NegativeRadius, Radii};
pub use self::codes::{CODE_LIMIT, Codes, code_name};
pub use self::dwell::{DwellUnit, DwellWord, LoneDwell};
pub use self::fagor_8055::{FAGOR_8055, POST_8055};
pub use self::fagor_8055_t::FAGOR_8055_T;
pub use self::fagor_8070::FAGOR_8070;
pub use self::fanuc::FANUC_LATHE_A;
pub use self::feed::{FeedChange, FeedCodes, FeedLimit, FeedPath, FeedRule, MissingFeed, UnsaidFeed};
pub use self::lexis::{
    BlockDelete, BuilderCodes, ByteOrderMarkRule, Comments, Decimals, EmptyBlock, Language, Lexis, LoneReturn,
    NamesWithDigit, NumberBehind, Percent, PolarWords,
};
pub use self::linuxcnc::{LINUXCNC, POST_LINUXCNC};
pub use self::order::{CallBy, Calls, Cancel, MachineMove, OffsetRule, Order, Reference};
pub use self::output::HeightHold;
pub use self::path::{Corners, Drilling, NoseCorner, RadiusRule, Retract};
pub use self::point::{
    CountedFeed, Counting, DecimalPoint, DimensionPoint, ImpliedPoint, LeastIncrement, Pointing, Quantity, Unpointed,
};
pub use self::rotary::{Rollover, RotaryMode, RotaryRule};
pub use self::source::Source;
pub use self::spindle::{SpeedLimit, SpindleRule, ThreadAngle, Turns};
pub use self::told::Feature;
pub use self::tool::{LengthWord, ToolBlocks, ToolCall, ToolChange};
pub use self::word_order::{Disorder, WordOrder, WordsSeen};
pub use self::writing::{CommentForm, FileName, MachineZero, OpeningLine, Post, TextForm, Writing};
use crate::finding::AlarmFamily;
use crate::gcode::code::{G, M};
pub use crate::gcode::feed_law::{FeedLaw, Slower};
use crate::gcode::motion::{FeedMode, Plane};
use crate::text::{Text, t};

/// What stands in the chuck.
///
/// It is the machine: which sheets, tools and proofs are meant, and that a lathe's X is shown as a diameter. How a word of X counts is
/// the control's, [`AcrossWord`]: a lathe may be programmed by radii as well (LinuxCNC, G7 and G8). No such control is followed yet, as
/// the places where X is shown as it is programmed take it for a diameter; `tests/controls/lists.rs` holds the two together till then.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// The tool: X, Y, Z and more axes.
    Mill,
    /// The part, turned about Z: X is shown as a diameter.
    Lathe,
}

impl Class {
    /// Every one.
    pub const ALL: [Self; 2] = [Self::Mill, Self::Lathe];

    /// What machines of it are called.
    #[must_use]
    pub const fn machines(self) -> Text {
        match self {
            Self::Mill => t("fresadoras", "mills"),
            Self::Lathe => t("tornos", "lathes"),
        }
    }
}

/// What is in force at the start.
#[derive(Clone, Copy, Debug)]
pub struct Start {
    /// The motion code, [`G::Cancel`] for none.
    pub motion: G,
    /// What F means.
    pub feed: FeedMode,
    /// The plane of arcs and cycles.
    pub plane: Plane,
    /// Where canned cycles return to.
    pub retract: Retract,
    /// Where a program may change its unit of length.
    pub units: UnitChange,
}

/// Where a program may change its unit of length.
#[derive(Clone, Copy, Debug)]
pub enum UnitChange {
    /// In any block.
    Anywhere,
    /// Before its first motion: the control's manual warns of it behind that.
    AtBeginning,
}

/// A control: how its programs are read and, where rodete writes for it, how they are written.
///
/// It is data: each behaviour is obeyed at one place, and no code asks which control it is. It has no `==`; that a program is for the
/// control of its design, [`Program::is_for`](crate::gcode::program::Program::is_for) says, of two that are given and of none that is named.
#[derive(Debug)]
pub struct Control {
    /// The name in workbooks and on the command line.
    pub name: &'static str,
    /// The works that it is read from and what of them stands here, and of what no page was at hand.
    pub sources: &'static [Source],
    /// What the text of a program looks like.
    pub text: TextForm,
    /// Mill or lathe.
    pub class: Class,
    /// The characters of a program.
    pub lexis: Lexis,
    /// What each number of a G code means.
    pub codes: &'static Codes,
    /// What the number of an M code means; `None` where the control has no such code.
    pub machine_code: fn(u32) -> Option<M>,
    /// What is in force at the start.
    pub start: Start,
    /// In which order a block is obeyed.
    pub order: Order,
    /// What axis words say.
    pub axes: AxisWords,
    /// What the words of an arc say.
    pub arcs: ArcWords,
    /// How rotary axes count.
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
    /// What G80 does.
    pub cancel: Cancel,
    /// How G53 moves.
    pub machine_move: MachineMove,
    /// G28 and G30.
    pub reference: Reference,
    /// Corners between lines.
    pub corners: Corners,
    /// G41 and G42.
    pub radius: RadiusRule,
    /// G81 to G89.
    pub drilling: Drilling,
    /// How subprograms are called.
    pub calls: Calls,
    /// How rodete writes for it; `None` where it reads only.
    pub written: Option<&'static Writing>,
    /// The family of its alarms, where their numbers are known.
    pub alarms: Option<AlarmFamily>,
}

/// All controls, as they are named on the command line.
pub static ALL: [&Control; 5] = [&LINUXCNC, &FAGOR_8055, &FAGOR_8070, &FAGOR_8055_T, &FANUC_LATHE_A];

/// The milling controls, for all of which rodete writes.
pub static MILLING: [&Control; 3] = [&FAGOR_8055, &FAGOR_8070, &LINUXCNC];

/// The lathes whose programs are followed over their stock.
pub static TURNING: [&Control; 2] = [&FANUC_LATHE_A, &FAGOR_8055_T];

impl Control {
    /// True for a lathe, whose part turns and whose X is shown as a diameter.
    #[must_use]
    pub const fn turns(&self) -> bool {
        match self.class {
            Class::Lathe => true,
            Class::Mill => false,
        }
    }

    /// The control with this [`Self::name`]; `None` for any other text.
    #[must_use]
    pub fn named(name: &str) -> Option<&'static Self> {
        ALL.into_iter().find(|control| control.name == name)
    }

    /// The milling control with a name, to be written for.
    #[must_use]
    pub fn milling(name: &str) -> Option<Post> {
        MILLING.into_iter().find(|control| control.name == name).and_then(Post::of)
    }

    /// True where an M code may stand by itself in a block of the control.
    #[must_use]
    pub fn knows_machine_code(&self, number: u32) -> bool {
        !matches!((self.machine_code)(number), None | Some(M::Refused(_) | M::Call | M::Return | M::SetTool))
    }
}
