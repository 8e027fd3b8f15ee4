//! What the cells of a form become where they speak of programs: codes, blocks, and the settings of a control.

use crate::gcode::control::{Control, MILLING, Post, RotaryMode, TURNING};
use crate::gcode::program::Style;
use crate::gcode::word::{Distance, NumberFormat, Retract, Word, block, codes};
use crate::parameter::field::{Stated, Typed, choices};
use crate::parameter::{Choice, Value};

/// Machine codes, as `M3 M11 M13`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Codes(pub Vec<Word>);

impl Codes {
    /// The M codes of these numbers, in their order.
    #[must_use]
    pub fn m<const N: usize>(numbers: [u32; N]) -> Self {
        Self(numbers.map(|number| Word::whole('M', number)).to_vec())
    }
}

/// Words as they are typed: `M3 M11 M13`, `G0 G53 Z0`.
fn line(words: &[Word]) -> Value {
    let mut line = String::new();
    words.iter().for_each(|word| word.write(NumberFormat::Trimmed, &mut line));
    Value::Line(line)
}

impl Typed for Codes {
    fn typed(value: &Value) -> Option<Self> {
        if let Value::Line(line) = value { codes(line).map(Self) } else { None }
    }
}

impl Stated for Codes {
    fn stated(self) -> Value {
        line(&self.0)
    }
}

impl Typed for Retract {
    fn typed(value: &Value) -> Option<Self> {
        if let Value::Line(line) = value { block(line).map(Self) } else { None }
    }
}

impl Stated for Retract {
    fn stated(self) -> Value {
        line(&self.0)
    }
}

/// The mills that a form of programs offers: all of [`MILLING`].
pub static MILLS: [Choice; MILLING.len()] = choices_of(&MILLING);

/// The lathes that a form of programs offers: all of [`TURNING`].
pub static LATHES: [Choice; TURNING.len()] = choices_of(&TURNING);

/// A choice for each of some controls, by its name.
const fn choices_of<const N: usize>(controls: &[&Control; N]) -> [Choice; N] {
    let mut choices = [const { Choice::named("") }; N];
    let mut at = 0;
    while at < N {
        // What is replaced has a destructor, and none is run where constants are made.
        std::mem::forget(std::mem::replace(&mut choices[at], Choice::named(controls[at].name)));
        at += 1;
    }
    choices
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

impl Stated for Post {
    fn stated(self) -> Value {
        self.control.stated()
    }
}

choices! { for Style; "annex" ("anexo", "annex") => Style::Annex, "full" ("completo", "full") => Style::Full }

choices! { for Distance; "G90" ("G90", "G90") => Distance::Absolute, "G91" ("G91", "G91") => Distance::Incremental }

choices! { for RotaryMode;
    "rollover" ("rollover", "rollover") => RotaryMode::Rollover,
    "linear" ("lineal", "linear") => RotaryMode::Linear
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gcode::control::{POST_8055, POST_LINUXCNC};

    #[test]
    fn what_is_put_into_a_cell_is_read_from_it() {
        for text in ["M3 M11 M13", "G8 M30", ""] {
            let value = Value::Line(text.to_owned());
            assert_eq!(Codes::typed(&value).map(Codes::stated), Some(value));
        }
        assert_eq!(Codes::m([3, 11]).stated(), Value::Line("M3 M11".to_owned()));
        for text in ["G0 G53 Z0", "G0 Z-12.5 M9", ""] {
            let value = Value::Line(text.to_owned());
            assert_eq!(Retract::typed(&value).map(Retract::stated), Some(value));
        }
        for post in MILLING.into_iter().filter_map(Post::of).chain([POST_8055, POST_LINUXCNC]) {
            let read = Post::typed(&post.stated()).map(|read| (read.control.name, std::ptr::from_ref(read.writing)));
            assert_eq!(read, Some((post.control.name, std::ptr::from_ref(post.writing))));
        }
    }
}
