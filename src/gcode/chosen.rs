//! What the cells of a form become where they speak of programs: codes, blocks, and the settings of a control.

use crate::gcode::control::{Control, Post, RotaryMode};
use crate::gcode::program::Style;
use crate::gcode::word::{Distance, Retract, Word, block, codes};
use crate::parameter::Value;
use crate::parameter::field::{Stated, Typed, choices};

/// Machine codes, as `M3 M11 M13`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Codes(pub Vec<Word>);

impl Typed for Codes {
    fn typed(value: &Value) -> Option<Self> {
        if let Value::Line(line) = value { codes(line).map(Self) } else { None }
    }
}

impl Typed for Retract {
    fn typed(value: &Value) -> Option<Self> {
        if let Value::Line(line) = value { block(line).map(Self) } else { None }
    }
}

impl Typed for &'static Control {
    fn typed(value: &Value) -> Option<Self> {
        if let Value::Choice(name) = value { Control::named(name) } else { None }
    }
}

impl Stated for &'static Control {
    fn stated(self) -> Value {
        Value::Choice(self.name)
    }
}

impl Typed for Post {
    fn typed(value: &Value) -> Option<Self> {
        if let Value::Choice(name) = value { Control::milling(name) } else { None }
    }
}

choices! { for Style; "annex" ("anexo", "annex") => Style::Annex, "full" ("completo", "full") => Style::Full }

choices! { for Distance; "G90" ("G90", "G90") => Distance::Absolute, "G91" ("G91", "G91") => Distance::Incremental }

choices! { for RotaryMode;
    "rollover" ("rollover", "rollover") => RotaryMode::Rollover,
    "linear" ("lineal", "linear") => RotaryMode::Linear
}
