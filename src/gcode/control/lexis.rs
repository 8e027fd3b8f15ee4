//! The characters of a program: letters, comments, expressions, `/` and `%`.

use super::{DimensionPoint, DwellUnit, DwellWord, LoneDwell, WordOrder};
use crate::gcode::letters::Letters;

/// What a control reads beside letters with numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// Nothing: words alone.
    Words,
    /// Parameters `#`, expressions, and O-words that steer the program.
    OWords,
    /// A macro language (IF, WHILE, GOTO, `#`), which is refused by name.
    Macros,
}

impl Language {
    /// True where numbers may be computed and O steers the program; else O numbers a program.
    #[must_use]
    pub const fn computes(self) -> bool {
        match self {
            Self::OWords => true,
            Self::Words | Self::Macros => false,
        }
    }

    /// True where a block number may have a fraction, which is passed over.
    #[must_use]
    pub const fn numbers_with_fraction(self) -> bool {
        match self {
            Self::OWords => true,
            Self::Words | Self::Macros => false,
        }
    }

    /// True where a block has words alone: `$` and `#` begin a statement of the control's high-level language.
    #[must_use]
    pub const fn has_words_alone(self) -> bool {
        match self {
            Self::Words => true,
            Self::OWords | Self::Macros => false,
        }
    }

    /// True where words of a macro language are refused by name.
    #[must_use]
    pub const fn refuses_macros(self) -> bool {
        match self {
            Self::Macros => true,
            Self::Words | Self::OWords => false,
        }
    }
}

/// How a comment is told from words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comments {
    /// `(...)` anywhere, `;` to the end of the line. Some comments are orders to the control.
    ParenthesesAndSemicolon,
    /// The same, and none is obeyed.
    Either,
    /// `;` to the end of the line; a parenthesis opens a statement of the control's high-level language.
    Semicolon,
    /// `(...)` anywhere; `;` ends the block, and what stands behind it is a comment unless it reads as another block.
    Parentheses,
}

impl Comments {
    /// True where a parenthesis opens a comment.
    #[must_use]
    pub const fn in_parentheses(self) -> bool {
        match self {
            Self::ParenthesesAndSemicolon | Self::Either | Self::Parentheses => true,
            Self::Semicolon => false,
        }
    }

    /// True where the control obeys some comments: `(ABORT,...)`, `(MSG,...)`.
    #[must_use]
    pub const fn obeyed(self) -> bool {
        match self {
            Self::ParenthesesAndSemicolon => true,
            Self::Either | Self::Semicolon | Self::Parentheses => false,
        }
    }
}

/// What `/` before a block is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlockDelete {
    /// `/`
    Plain,
    /// `/`, or `/1` to `/9` for one of nine switches.
    Numbered,
    /// `/`, or `/1` to `/3` for one of three switches.
    Three,
}

impl BlockDelete {
    /// The greatest digit behind `/` that names a switch; 0 where none does.
    #[must_use]
    pub const fn switches(self) -> u8 {
        match self {
            Self::Plain => 0,
            Self::Numbered => 9,
            Self::Three => 3,
        }
    }
}

/// Where the text of a file begins and ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Percent {
    /// A first line `%` with the program's name; no other.
    Named,
    /// `%` opens and ends the text where it opens it; without it M2 or M30 is wanted.
    Pair,
    /// Text before the first `%` is passed over, the next one ends the program, and so does the end of the file; a second
    /// program number begins another program.
    Leader,
}

impl Percent {
    /// True where `%` is followed by the program's name.
    #[must_use]
    pub const fn named(self) -> bool {
        match self {
            Self::Named => true,
            Self::Pair | Self::Leader => false,
        }
    }

    /// True where nothing may stand before the first `%` or beside any, not even a comment.
    #[must_use]
    pub const fn bare(self) -> bool {
        match self {
            Self::Pair => true,
            Self::Named | Self::Leader => false,
        }
    }

    /// True where text may stand before the first `%`, and a program may end with its text.
    #[must_use]
    pub const fn leader(self) -> bool {
        match self {
            Self::Leader => true,
            Self::Named | Self::Pair => false,
        }
    }
}

/// What a byte order mark at the beginning of a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ByteOrderMarkRule {
    /// Passed over, with a remark.
    Skipped,
    /// Characters that the control does not know.
    Rejected,
}

impl ByteOrderMarkRule {
    /// True where the control does not read a file with it.
    #[must_use]
    pub const fn rejected(self) -> bool {
        match self {
            Self::Skipped => false,
            Self::Rejected => true,
        }
    }
}

/// What a carriage return is that no line feed follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoneReturn {
    /// The end of a line, as a line feed is.
    EndsLine,
    /// Rejected: the control takes it for a blank, where an editor shows the end of a line.
    Rejected,
}

impl LoneReturn {
    /// True where a file with one is not read.
    #[must_use]
    pub const fn rejected(self) -> bool {
        match self {
            Self::EndsLine => false,
            Self::Rejected => true,
        }
    }
}

/// What a block without words is: an empty line, a block number alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EmptyBlock {
    /// Passed over: nothing is done.
    Passed,
    /// Rejected; a comment may stand alone.
    Rejected,
}

impl EmptyBlock {
    /// True where the control does not take it.
    #[must_use]
    pub const fn rejected(self) -> bool {
        match self {
            Self::Passed => false,
            Self::Rejected => true,
        }
    }
}

/// How many decimals a dimension may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decimals {
    /// Any number.
    Free,
    /// Four; five in inches, and of a centre or a radius.
    FourOrFive,
}

impl Decimals {
    /// The greatest coordinate of a linear axis in inches; `None` where no page names one. Fagor CNC 8055 M, programming manual, p. 65:
    /// the same length as 99999.9999 mm.
    #[must_use]
    pub const fn greatest_inches(self) -> Option<f64> {
        match self {
            Self::Free => None,
            Self::FourOrFive => Some(3937.00787),
        }
    }

    /// Most decimals of a dimension, in inches or not, and of a centre or a radius; `None` where any number will do.
    #[must_use]
    pub const fn most(self, inch: bool, centre: bool) -> Option<usize> {
        match self {
            Self::Free => None,
            Self::FourOrFive => Some(if inch || centre { 5 } else { 4 }),
        }
    }
}

/// Whether M codes of the machine's builder exclude one another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BuilderCodes {
    /// They do: one in a block.
    One,
    /// Several in a block: clamps M11 and M13 stand together.
    Several,
}

impl BuilderCodes {
    /// True where several may stand in a block.
    #[must_use]
    pub const fn stand_together(self) -> bool {
        match self {
            Self::One => false,
            Self::Several => true,
        }
    }
}

/// What an N behind the words of a block is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NumberBehind {
    /// No word: N stands first.
    Rejected,
    /// How many times more the block is made, which is refused by name.
    Repeats,
}

impl NumberBehind {
    /// True where the control makes the block several times.
    #[must_use]
    pub const fn repeats(self) -> bool {
        match self {
            Self::Rejected => false,
            Self::Repeats => true,
        }
    }
}

/// Words of polar coordinates, or of an angle beside one coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PolarWords {
    /// None of the words that rodete knows.
    None,
    /// `@` and `^`, which are read.
    Signs,
    /// R and Q, which are refused by name.
    RadiusAndAngle,
}

impl PolarWords {
    /// True where `@` and `^` are read.
    #[must_use]
    pub const fn by_signs(self) -> bool {
        match self {
            Self::Signs => true,
            Self::None | Self::RadiusAndAngle => false,
        }
    }

    /// True where R and Q of a motion are refused as polar words.
    #[must_use]
    pub const fn by_letters(self) -> bool {
        match self {
            Self::None | Self::Signs => false,
            Self::RadiusAndAngle => true,
        }
    }
}

/// Names of axes and spindles that are a letter and a digit, with `=` before the number: `X1=10`, `S2=500`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NamesWithDigit {
    /// None: `=` is no character of a block.
    None,
    /// Of axes and spindles, which are refused by name.
    AxesAndSpindles,
}

impl NamesWithDigit {
    /// True where a name, in capitals, may be of an axis or a spindle: its letter, and a digit from 1 to 9. Fagor CNC 8070, programming
    /// manual, elements of a program: `Xn=`, `Sn=`, n from 1 to 9.
    #[must_use]
    pub fn has(self, name: &str) -> bool {
        match self {
            Self::None => false,
            Self::AxesAndSpindles => {
                matches!(name.as_bytes(), [letter, b'1'..=b'9'] if b"ABCSUVWXYZ".contains(letter))
            }
        }
    }
}

/// What a program's text is made of.
#[derive(Clone, Copy, Debug)]
pub struct Lexis {
    /// Addresses that may stand in a block, beside G, M and N.
    pub letters: Letters,
    /// Addresses of the control that are refused by name.
    pub refused: Letters,
    /// Addresses that need no code beside them.
    pub free: Letters,
    /// Addresses of F, S, T, D, L and Q whose number may be negative.
    pub negative: Letters,
    /// The addresses of a dwell; the first is written.
    pub dwell: &'static [DwellWord],
    /// What the dwell of a drilling or turning cycle counts.
    pub cycle_dwell: DwellUnit,
    /// G4 without a time.
    pub lone_dwell: LoneDwell,
    /// Beside letters with numbers.
    pub language: Language,
    /// How comments are marked.
    pub comments: Comments,
    /// `/`
    pub delete: BlockDelete,
    /// `%`
    pub percent: Percent,
    /// A byte order mark.
    pub mark: ByteOrderMarkRule,
    /// A carriage return without a line feed behind it.
    pub lone_return: LoneReturn,
    /// The order of the words of a block, as read and as written.
    pub words: WordOrder,
    /// A block without words.
    pub empty: EmptyBlock,
    /// The greatest block number N that is read.
    pub greatest_number: u32,
    /// How many decimals a dimension may have.
    pub decimals: Decimals,
    /// Dimensions without a decimal point.
    pub point: DimensionPoint,
    /// Most characters of a line.
    pub longest_line: usize,
    /// Most M codes in one block.
    pub most_machine_codes: usize,
    /// M codes of the machine's builder.
    pub builders: BuilderCodes,
    /// An N behind the words of a block.
    pub behind: NumberBehind,
    /// Polar coordinates, and angles of lines.
    pub polar: PolarWords,
    /// Names of axes and spindles with a digit.
    pub names: NamesWithDigit,
}
