//! Changes of a form's values, in short.

use rodete::parameter::Value;

/// A field by its symbol, and what is written into it.
pub type Change = (&'static str, Value);

pub const fn real(key: &'static str, value: f64) -> Change {
    (key, Value::Real(value))
}

pub const fn choice(key: &'static str, value: &'static str) -> Change {
    (key, Value::Choice(value))
}
