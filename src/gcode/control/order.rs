//! In which order a block is obeyed, and what its codes do to what is in force.

use crate::gcode::letters::Letters;

/// In which order the words of a block are obeyed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// That of RS274: M codes before the motion, the unit with the other modes, behind F and S.
    Rs274,
    /// M codes before the motion. No manual of Fagor says in which unit F and S are read beside a code that changes it.
    Fagor,
    /// The same, but M5 and M9 behind the motion.
    FagorLathe,
    /// The unit before every word, M5 and M9 behind the motion, and a motion code beside G28, G30 or G50, in force from
    /// there on.
    Fanuc,
}

impl Order {
    /// True where the unit of a block holds for its feed and speed too.
    #[must_use]
    pub const fn unit_first(self) -> bool {
        match self {
            Self::Fanuc => true,
            Self::Rs274 | Self::Fagor | Self::FagorLathe => false,
        }
    }

    /// True where it is not known whether the unit of a block holds for its feed and speed too.
    #[must_use]
    pub const fn unit_open(self) -> bool {
        match self {
            Self::Fagor | Self::FagorLathe => true,
            Self::Rs274 | Self::Fanuc => false,
        }
    }

    /// True where spindle and coolant go off behind the motion.
    #[must_use]
    pub const fn off_last(self) -> bool {
        match self {
            Self::FagorLathe | Self::Fanuc => true,
            Self::Rs274 | Self::Fagor => false,
        }
    }

    /// True where a motion code beside a code for one block is no second use of the axis words.
    #[must_use]
    pub const fn motion_beside(self) -> bool {
        match self {
            Self::Fanuc => true,
            Self::Rs274 | Self::Fagor | Self::FagorLathe => false,
        }
    }
}

/// What is in force behind G80.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cancel {
    /// No motion code.
    LeavesNone,
    /// The motion code that was in force before the cycle.
    RestoresMotion,
}

impl Cancel {
    /// True where the motion code under a cycle comes back.
    #[must_use]
    pub const fn restores(self) -> bool {
        match self {
            Self::LeavesNone => false,
            Self::RestoresMotion => true,
        }
    }
}

/// How G53 moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MachineMove {
    /// By the G0 or G1 in force; nose compensation is off from there on.
    InForce,
    /// At rapid whatever is in force; nose compensation is set aside for the block.
    Rapid,
}

impl MachineMove {
    /// True where it needs no motion code, and sets compensation aside only for itself.
    #[must_use]
    pub const fn by_itself(self) -> bool {
        match self {
            Self::InForce => false,
            Self::Rapid => true,
        }
    }
}

/// Which axes go to the reference point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reference {
    /// No code goes there.
    None,
    /// Those named, or all where none is.
    NamedOrAll,
    /// Those named, by their absolute or incremental words; P tells which point.
    Named,
}

impl Reference {
    /// The letters of G30 beside the axes.
    #[must_use]
    pub const fn letters(self) -> Letters {
        match self {
            Self::None | Self::NamedOrAll => Letters::of(""),
            Self::Named => Letters::of("P"),
        }
    }
}

/// What G54 to G59 and the code that sets a position may say.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OffsetRule {
    /// G54 selects; G92 sets this position to its words.
    Select,
    /// The same, and only one of both is in force: G54 ends what G92 has set. Fagor 8055, programming manual of the M and EN
    /// models, page 58.
    SelectOrPreset,
    /// With axis words and no motion code G54 shifts the system; G50 takes increments too.
    SelectOrShift,
}

impl OffsetRule {
    /// True where words beside G54 shift the system, and G50 takes increments.
    #[must_use]
    pub const fn shifts(self) -> bool {
        match self {
            Self::Select | Self::SelectOrPreset => false,
            Self::SelectOrShift => true,
        }
    }

    /// True where G54 ends what the code that sets a position has set.
    #[must_use]
    pub const fn preset_ends(self) -> bool {
        match self {
            Self::Select | Self::SelectOrShift => false,
            Self::SelectOrPreset => true,
        }
    }
}

/// How subprograms are called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CallBy {
    /// By none of its M codes.
    Nothing,
    /// By the O that stands behind the program, alone in their block.
    Label,
    /// By the number of their program or of their first block, a plain motion beside; M99 may name a block.
    Number,
}

impl CallBy {
    /// True where a plain motion may stand beside a call or a return, and M99 takes P.
    #[must_use]
    pub const fn beside_motion(self) -> bool {
        match self {
            Self::Nothing | Self::Label => false,
            Self::Number => true,
        }
    }

    /// True where the control looks for M98 and M99 in the text of the line, so that their spelling counts; else the codes do,
    /// however they are spelled.
    #[must_use]
    pub const fn spelled_in_text(self) -> bool {
        match self {
            Self::Label => true,
            Self::Nothing | Self::Number => false,
        }
    }
}

/// How subprograms are called.
#[derive(Clone, Copy, Debug)]
pub struct Calls {
    /// How they are called.
    pub by: CallBy,
    /// Most inside one another.
    pub depth: usize,
}
