//! How the number of a rotary axis is read.

/// What an absolute word of a rotary axis means: a setting of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RotaryMode {
    /// The position, counted on beyond a turn as on a linear axis.
    Linear,
    /// The number is the angle to go to, 0 to 359.9999 degrees, and the sign the direction of the turn.
    Rollover,
}

impl RotaryMode {
    /// Every one.
    pub const ALL: [Self; 2] = [Self::Linear, Self::Rollover];

    /// That of a name; `None` where none has it.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|mode| mode.name() == name)
    }

    /// True where an absolute word is an angle inside a turn, so that a position beyond it cannot be said.
    #[must_use]
    pub const fn rolls_over(self) -> bool {
        match self {
            Self::Linear => false,
            Self::Rollover => true,
        }
    }

    /// The name on the command line and in JSON.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Rollover => "rollover",
        }
    }
}

/// What an absolute word of a rollover axis may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rollover {
    /// Beyond 359.9999 the errors 0168 and 0199; what the manuals do not say gets a Caution.
    Numbered,
    /// `WRAPPED_ROTARY`: known from the control's source; not with G53, which takes the word's sign for its own.
    Wrapped,
}

/// How rotary axes count.
#[derive(Clone, Copy, Debug)]
pub struct RotaryRule {
    /// What they are on a machine as the control is delivered.
    pub delivered: RotaryMode,
    /// Where they are rollover axes.
    pub rollover: Rollover,
}
