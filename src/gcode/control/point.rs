//! Numbers without a decimal point, and numbers that take none.
//!
//! # References
//! Fanuc 16i/18i-PB, descriptions (B-63682EN/01), p. 54: pocket calculator type and usual type, with least increments; both may stand
//! in a program. The addresses: Series 0i-T, operator's manual, decimal point programming.

use crate::gcode::letters::Letters;
use crate::text::{Text, t};

/// What a number without a decimal point is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DimensionPoint {
    /// The same as with one, in the program's unit.
    Free,
    /// The same, or a number of least increments: a setting of the control decides.
    BySetting(Counting),
}

/// Which numbers count least increments, where the setting of a control has it so.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Counting {
    /// Addresses of lengths, and of the time of a dwell.
    pub letters: Letters,
    /// F.
    pub feed: CountedFeed,
    /// Addresses that take no decimal point.
    pub whole: Letters,
    /// What is counted.
    pub increment: LeastIncrement,
}

/// What an F without a decimal point is, where lengths count least increments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CountedFeed {
    /// What it says.
    AsWritten,
    /// Per minute what it says; per revolution, and as the lead of a thread, it counts what is not known here.
    LengthUnknown,
}

impl CountedFeed {
    /// True where F may count something.
    const fn counts(self) -> bool {
        match self {
            Self::AsWritten => false,
            Self::LengthUnknown => true,
        }
    }
}

/// The least increment of the input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeastIncrement {
    /// 0.001 mm, 0.0001 inches, 0.001 s.
    Thousandth,
}

impl LeastIncrement {
    /// How many are a mm, an inch or a second.
    const fn per(self, quantity: Quantity) -> f64 {
        match (self, quantity) {
            (Self::Thousandth, Quantity::Millimetre | Quantity::Second) => 1_000.0,
            (Self::Thousandth, Quantity::Inch) => 10_000.0,
        }
    }

    /// What a number may be: so many of the unit, or of these.
    const fn choice(self, quantity: Quantity) -> Text {
        match (self, quantity) {
            (Self::Thousandth, Quantity::Millimetre) => t("mm o µm", "mm or µm"),
            (Self::Thousandth, Quantity::Inch) => t("pulgadas o diezmilésimas", "inches or ten-thousandths"),
            (Self::Thousandth, Quantity::Second) => t("s o ms", "s or ms"),
        }
    }

    /// That numbers were read as so many of these.
    const fn read(self, quantity: Quantity) -> Text {
        match (self, quantity) {
            (Self::Thousandth, Quantity::Millimetre) => {
                t("leídas como incrementos mínimos (0.001 mm)", "read as least increments (0.001 mm)")
            }
            (Self::Thousandth, Quantity::Inch) => {
                t("leídas como incrementos mínimos (0.0001 pulgadas)", "read as least increments (0.0001 inch)")
            }
            (Self::Thousandth, Quantity::Second) => t("leídos como ms", "read as ms"),
        }
    }
}

/// What a number measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// A length in a program in millimetres.
    Millimetre,
    /// A length in a program in inches.
    Inch,
    /// A time in seconds.
    Second,
}

impl Quantity {
    /// That numbers were read as so many of the unit.
    const fn read(self) -> Text {
        match self {
            Self::Millimetre => t("leídas como mm", "read as mm"),
            Self::Inch => t("leídas como pulgadas", "read as inches"),
            Self::Second => t("leídos como s", "read as s"),
        }
    }
}

/// What the setting makes of a number without a decimal point, where one decides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DecimalPoint {
    /// As a pocket calculator does: X100 is 100 mm.
    Calculator,
    /// A number of least input increments: X100 is 0.1 mm (0.01 inch under G20).
    Micrometre,
}

/// What a word's decimal point, or its absence, makes of its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pointing {
    /// The number is what it says.
    AsWritten,
    /// The letter takes no number with a decimal point.
    NotTaken,
    /// The number may have to be divided, by what is known with its whole block: [`DimensionPoint::reading`].
    Divided,
}

impl Pointing {
    /// True where the number may have to be divided.
    #[must_use]
    pub const fn divides(self) -> bool {
        match self {
            Self::Divided => true,
            Self::AsWritten | Self::NotTaken => false,
        }
    }
}

/// How a number without a decimal point is read.
#[derive(Clone, Debug, PartialEq)]
pub struct ImpliedPoint {
    /// By what it is divided.
    pub by: f64,
    /// In words.
    pub told: Text,
}

/// Why a number without a decimal point cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unpointed {
    /// The setting that decides is not known: between these, in words.
    BySettingUnknown(Text),
    /// What the setting makes of a feed is not known.
    FeedUnknown,
}

impl DimensionPoint {
    /// What the decimal point of a word makes of its number, or its absence. It is asked of every number as it is read; the letter
    /// is counted from A = 0, and `,C` and `,R` ask as R does.
    #[inline]
    #[must_use]
    pub const fn of(&self, letter: u8, pointed: bool) -> Pointing {
        match self {
            Self::Free => Pointing::AsWritten,
            Self::BySetting(Counting { whole, .. }) if pointed && whole.has(letter) => Pointing::NotTaken,
            Self::BySetting(Counting { letters, feed, .. })
                if !pointed && (letters.has(letter) || letter == b'F' - b'A' && feed.counts()) =>
            {
                Pointing::Divided
            }
            Self::BySetting(_) => Pointing::AsWritten,
        }
    }

    /// How a number without a decimal point is read that may have to be divided, under a setting of the control; `feed` is true for
    /// an F that is a length: per revolution, or a lead.
    ///
    /// # Errors
    /// Where that is not known.
    pub fn reading(
        &self,
        quantity: Quantity,
        feed: bool,
        setting: Option<DecimalPoint>,
    ) -> Result<ImpliedPoint, Unpointed> {
        let written = ImpliedPoint { by: 1.0, told: quantity.read() };
        match (self, setting) {
            (Self::Free, _) | (Self::BySetting(_), Some(DecimalPoint::Calculator)) => Ok(written),
            (Self::BySetting(counting), None) => Err(Unpointed::BySettingUnknown(counting.increment.choice(quantity))),
            (Self::BySetting(counting), Some(DecimalPoint::Micrometre)) if feed => match counting.feed {
                CountedFeed::AsWritten => Ok(written),
                CountedFeed::LengthUnknown => Err(Unpointed::FeedUnknown),
            },
            (Self::BySetting(Counting { increment, .. }), Some(DecimalPoint::Micrometre)) => {
                Ok(ImpliedPoint { by: increment.per(quantity), told: increment.read(quantity) })
            }
        }
    }

    /// How many of what P and Q of a turning cycle count are a mm or an inch: least increments under any setting.
    #[must_use]
    pub const fn increments(&self, quantity: Quantity) -> f64 {
        match self {
            Self::Free => 1.0,
            Self::BySetting(Counting { increment, .. }) => increment.per(quantity),
        }
    }

    /// True where a form must ask for the setting that decides.
    #[must_use]
    pub const fn by_setting(&self) -> bool {
        match self {
            Self::Free => false,
            Self::BySetting(_) => true,
        }
    }
}
