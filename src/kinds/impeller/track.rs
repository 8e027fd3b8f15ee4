//! The tracks that the tool cuts along: both sides of a blade, and the way out and back along a splitter.

use crate::text::{Text, t};

/// One of the published paths along which the tool cuts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Track {
    /// The obverse of a blade, from the entry to the exit.
    Obverse,
    /// The reverse of a blade, run back from the exit.
    Reverse,
    /// Path 1 of a splitter, from the entry to the exit.
    Out,
    /// Path 2 of a splitter, run back from the exit.
    Back,
}

impl Track {
    /// All of them, in the order of the programs.
    pub const ALL: [Self; 4] = [Self::Obverse, Self::Reverse, Self::Out, Self::Back];

    /// The name in programs and findings.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Obverse => "obverse",
            Self::Reverse => "reverse",
            Self::Out => "splitter-out",
            Self::Back => "splitter-back",
        }
    }

    /// The track whose [`Self::key`] this is; `None` for any other text.
    #[must_use]
    pub fn from_key(key: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|track| track.key() == key)
    }

    /// What it is called.
    #[must_use]
    pub const fn name(self) -> &'static Text {
        const NAMES: &[Text; 4] = &[
            t("anverso", "obverse"),
            t("reverso", "reverse"),
            t("intermedio, ida", "splitter, out"),
            t("intermedio, vuelta", "splitter, back"),
        ];
        match self {
            Self::Obverse => &NAMES[0],
            Self::Reverse => &NAMES[1],
            Self::Out => &NAMES[2],
            Self::Back => &NAMES[3],
        }
    }

    /// On which side of the mean line it lies: 1 towards +b, −1 towards −b. The blade lies on the other side.
    #[must_use]
    pub const fn side(self) -> f64 {
        match self {
            Self::Obverse | Self::Back => 1.0,
            Self::Reverse | Self::Out => -1.0,
        }
    }

    /// True for the tracks of a splitter.
    #[must_use]
    pub const fn of_splitter(self) -> bool {
        matches!(self, Self::Out | Self::Back)
    }

    /// True where it is run from the last point to the first.
    #[must_use]
    pub const fn backwards(self) -> bool {
        matches!(self, Self::Reverse | Self::Back)
    }
}
