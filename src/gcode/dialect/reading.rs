//! How programs of a dialect are read: its letters, its codes, its rules.

use crate::gcode::code::{G, M};
use crate::gcode::motion::{FeedMode, Plane};

/// Letters of the alphabet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Letters(u32);

impl Letters {
    /// The capital letters of a text; anything else in it is passed over.
    #[must_use]
    pub const fn of(text: &str) -> Self {
        let bytes = text.as_bytes();
        let (mut mask, mut at) = (0, 0);
        while at < bytes.len() {
            if bytes[at].is_ascii_uppercase() {
                mask |= 1 << (bytes[at] - b'A');
            }
            at += 1;
        }
        Self(mask)
    }

    /// True where a letter, counted from A = 0, is among them.
    #[must_use]
    pub const fn has(self, letter: u8) -> bool {
        letter < 26 && self.0 & (1 << letter) != 0
    }

    /// One bit for each letter, A the lowest.
    #[must_use]
    pub const fn mask(self) -> u32 {
        self.0
    }
}

/// G codes by their number in tenths, below 1000: G54 is 540, G59.3 is 593.
#[derive(Debug)]
pub struct Codes([Option<G>; 1000]);

impl Codes {
    /// The table of codes given by number and tenths.
    #[must_use]
    pub const fn new(list: &[(usize, G)]) -> Self {
        let mut table = [None; 1000];
        let mut at = 0;
        while at < list.len() {
            table[list[at].0] = Some(list[at].1);
            at += 1;
        }
        Self(table)
    }

    /// The meaning of a code, by its number in tenths.
    #[must_use]
    pub fn get(&self, tenths: usize) -> Option<G> {
        self.0.get(tenths).copied().flatten()
    }
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

/// How a dialect's programs are read.
#[derive(Debug)]
pub struct Reading {
    /// Addresses that may stand in a block, beside G, M and N.
    pub letters: Letters,
    /// Addresses of the dialect that are refused by name.
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
