//! Typed fields: key, defined name, unit, limits, meaning and Rust type of a parameter in one row.

use std::marker::PhantomData;

use crate::finding::Key;
pub use crate::parameter::fields::{Entry, Fields};
use crate::parameter::{Cell, Choice, FieldKind, Parameter, Value};
use crate::table::Unit;
use crate::text::{Language, Text, t};

/// What an empty cell means.
pub trait Presence {
    /// What a field gives.
    type Of<T>;
    /// An empty cell is refused.
    const REQUIRED: bool;
    /// What the field gives; `None` where it can give nothing.
    fn of<T: Clone>(found: Option<T>, usual: Option<&T>) -> Option<Self::Of<T>>;
}

/// A presence without a usual value.
pub trait Bare: Presence {}

/// The value must be there.
#[derive(Debug)]
pub struct Required;

/// The cell may be empty.
#[derive(Debug)]
pub struct Optional;

/// An empty cell means the usual value.
#[derive(Debug)]
pub struct Usual;

/// The value must be there where anything is on its sheet, which may be missing.
#[derive(Debug)]
pub struct WithSheet;

impl Presence for Required {
    type Of<T> = T;
    const REQUIRED: bool = true;

    fn of<T: Clone>(found: Option<T>, _: Option<&T>) -> Option<T> {
        found
    }
}

impl Presence for Optional {
    type Of<T> = Option<T>;
    const REQUIRED: bool = false;

    fn of<T: Clone>(found: Option<T>, _: Option<&T>) -> Option<Option<T>> {
        Some(found)
    }
}

impl Presence for Usual {
    type Of<T> = T;
    const REQUIRED: bool = false;

    fn of<T: Clone>(found: Option<T>, usual: Option<&T>) -> Option<T> {
        found.or_else(|| usual.cloned())
    }
}

impl Presence for WithSheet {
    type Of<T> = Option<T>;
    const REQUIRED: bool = true;

    fn of<T: Clone>(found: Option<T>, _: Option<&T>) -> Option<Option<T>> {
        Some(found)
    }
}

impl Bare for Required {}
impl Bare for Optional {}
impl Bare for WithSheet {}

/// A type that the value of a cell becomes.
pub trait Typed: Clone + 'static {
    /// The value as this type; `None` where it is none.
    fn typed(value: &Value) -> Option<Self>;

    /// True where the value is one of this type.
    fn admits(value: &Value) -> bool {
        Self::typed(value).is_some()
    }
}

impl Typed for f64 {
    fn typed(value: &Value) -> Option<Self> {
        if let Value::Real(number) = value { Some(*number).filter(|number| number.is_finite()) } else { None }
    }
}

impl Typed for u32 {
    fn typed(value: &Value) -> Option<Self> {
        if let Value::Whole(number) = value { Some(*number) } else { None }
    }
}

impl Typed for String {
    fn typed(value: &Value) -> Option<Self> {
        if let Value::Line(line) = value { Some(line.clone()) } else { None }
    }
}

/// A type that is chosen from a list: an enum whose variants, keys and labels stand in one place (see
/// `choices!`).
pub trait Chosen: Copy + 'static {
    /// The keys with their labels in both languages, in the order in which a cell offers them.
    const CHOICES: &'static [Choice];

    /// What the key of a choice stands for.
    fn of(key: &str) -> Option<Self>;

    /// What stands in a cell for the choice, in both languages.
    fn label(self) -> &'static Text
    where
        Self: PartialEq,
    {
        const NONE: &Text = &t("", "");
        Self::CHOICES.iter().find(|choice| Self::of(choice.key) == Some(self)).map_or(NONE, |choice| &choice.label)
    }

    /// The key of the choice, as [`Self::of`] takes it.
    fn key(self) -> &'static str
    where
        Self: PartialEq,
    {
        Self::CHOICES.iter().map(|choice| choice.key).find(|key| Self::of(key) == Some(self)).unwrap_or_default()
    }
}

impl<T: Chosen> Typed for T {
    fn typed(value: &Value) -> Option<Self> {
        if let Value::Choice(key) = value { Self::of(key) } else { None }
    }
}

/// A type whose values can be put into a cell.
pub trait Stated: Typed {
    /// What the cell holds.
    fn stated(self) -> Value;
}

impl Stated for f64 {
    fn stated(self) -> Value {
        Value::Real(self)
    }
}

impl Stated for u32 {
    fn stated(self) -> Value {
        Value::Whole(self)
    }
}

impl Stated for String {
    fn stated(self) -> Value {
        Value::Line(self)
    }
}

impl<T: Chosen + PartialEq> Stated for T {
    fn stated(self) -> Value {
        Value::Choice(self.key())
    }
}

/// An enum with the keys of its choices and their labels in Spanish and English; or these for a type that is there, each with the
/// words that were once its label, as `("A", "B"; "once B")`.
#[macro_export]
macro_rules! choices {
    (
        $(#[$about:meta])*
        $vis:vis enum $name:ident {
            $($(#[$each:meta])* $variant:ident = $key:literal ($es:literal, $en:literal)),+ $(,)?
        }
    ) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        $vis enum $name {
            $($(#[$each])* $variant),+
        }

        $crate::parameter::field::choices! { for $name; $($key ($es, $en) => $name::$variant),+ }
    };
    (for $type:ty; $($key:literal ($es:literal, $en:literal $(; $($once:literal),+)?) => $value:expr),+ $(,)?) => {
        impl $crate::parameter::field::Chosen for $type {
            const CHOICES: &'static [$crate::parameter::Choice] = &[$(
                $crate::parameter::Choice { key: $key, label: $crate::text::t($es, $en), once: &[$($($once),+)?] }
            ),+];

            fn of(key: &str) -> Option<Self> {
                match key {
                    $($key => Some($value),)+
                    _ => None,
                }
            }
        }
    };
}

#[doc(hidden)]
pub use choices;

choices! { for bool; "yes" ("sí", "yes") => true, "no" ("no", "no") => false }

/// One parameter with its type.
#[derive(Debug)]
pub struct Field<T, P> {
    /// The row of the form.
    pub row: Parameter,
    pub(super) usual: Option<T>,
    presence: PhantomData<P>,
}

impl<T: Typed, P: Presence> Field<T, P> {
    const fn new(
        (key, name): (&'static str, &'static str),
        (unit, kind): (Unit, FieldKind),
        usual: Option<T>,
        meaning: Text,
        note: Text,
    ) -> Self {
        let (required, admits) = (P::REQUIRED, T::admits);
        let row = Parameter { key, name, meaning, unit, kind, required, read: true, admits, note, given_by: None };
        Self { row, usual, presence: PhantomData }
    }

    /// The same for what nothing follows from: a remark of its author.
    #[must_use]
    pub const fn unread(mut self) -> Self {
        self.row.read = false;
        self
    }

    /// The same for what another cell gives where its own is empty.
    #[must_use]
    pub const fn given_by(mut self, key: &'static str) -> Self {
        self.row.given_by = Some(key);
        self
    }

    /// Its key in the form.
    #[must_use]
    pub const fn key(&self) -> Key {
        self.row.key()
    }

    /// Its cell with a value, for a case or a row.
    #[must_use]
    pub fn is(&self, value: T) -> Cell
    where
        T: Stated,
    {
        (self.row.key, value.stated())
    }

    /// Puts a value into its cell among those of a case: in place of what is there, else behind them.
    pub fn set(&self, cells: &mut Vec<Cell>, value: T)
    where
        T: Stated,
    {
        let cell = self.is(value);
        match cells.iter_mut().find(|one| one.0 == cell.0) {
            Some(one) => *one = cell,
            None => cells.push(cell),
        }
    }

    /// Takes its cell from those of a case: it stays empty.
    pub fn clear(&self, cells: &mut Vec<Cell>) {
        cells.retain(|one| one.0 != self.row.key);
    }
}

impl<P: Presence> Field<String, P> {
    /// Its cell with a text in a language, for a case or a row.
    #[must_use]
    pub fn says(&self, text: &Text, language: Language) -> Cell {
        self.is(text.get(language).to_owned())
    }
}

impl<T: Typed, P: Bare> Field<T, P> {
    /// One of a list, whose key is the value.
    #[must_use]
    pub const fn of_list(
        key: &'static str,
        name: &'static str,
        list: &'static [Choice],
        meaning: Text,
        note: Text,
    ) -> Self {
        Self::new((key, name), (Unit::None, FieldKind::Choice(list)), None, meaning, note)
    }

    /// What has a type of its own and no unit.
    #[must_use]
    pub const fn other(key: &'static str, name: &'static str, kind: FieldKind, meaning: Text, note: Text) -> Self {
        Self::new((key, name), (Unit::None, kind), None, meaning, note)
    }
}

impl<T: Chosen, P: Bare> Field<T, P> {
    /// One of the choices of a type.
    #[must_use]
    pub const fn choice(key: &'static str, name: &'static str, meaning: Text, note: Text) -> Self {
        Self::of_list(key, name, T::CHOICES, meaning, note)
    }
}

impl<T: Chosen> Field<T, Usual> {
    /// One of the choices of a type, or the usual one.
    #[must_use]
    pub const fn choice_or(usual: T, key: &'static str, name: &'static str, meaning: Text, note: Text) -> Self {
        Self::new((key, name), (Unit::None, FieldKind::Choice(T::CHOICES)), Some(usual), meaning, note)
    }
}

impl<P: Bare> Field<f64, P> {
    /// A real number within limits, both included.
    #[must_use]
    pub const fn real(
        key: &'static str,
        name: &'static str,
        unit: Unit,
        [min, max]: [f64; 2],
        meaning: Text,
        note: Text,
    ) -> Self {
        Self::new((key, name), (unit, FieldKind::Real { min, max }), None, meaning, note)
    }
}

impl Field<f64, Usual> {
    /// A real number within limits, both included, or the usual one.
    #[must_use]
    pub const fn real_or(
        usual: f64,
        key: &'static str,
        name: &'static str,
        unit: Unit,
        [min, max]: [f64; 2],
        meaning: Text,
        note: Text,
    ) -> Self {
        Self::new((key, name), (unit, FieldKind::Real { min, max }), Some(usual), meaning, note)
    }
}

impl<P: Bare> Field<u32, P> {
    /// A whole number within limits, both included.
    #[must_use]
    pub const fn whole(
        key: &'static str,
        name: &'static str,
        unit: Unit,
        [min, max]: [u32; 2],
        meaning: Text,
        note: Text,
    ) -> Self {
        Self::new((key, name), (unit, FieldKind::Whole { min, max }), None, meaning, note)
    }
}

impl<P: Bare> Field<String, P> {
    /// One line of text of at most `max` characters.
    #[must_use]
    pub const fn line(key: &'static str, name: &'static str, max: usize, meaning: Text, note: Text) -> Self {
        Self::other(key, name, FieldKind::Line { max }, meaning, note)
    }
}

impl Field<String, Required> {
    /// The cell that says which form and version the workbook follows.
    #[must_use]
    pub const fn schema() -> Self {
        Self::other(
            "schema",
            "schema",
            FieldKind::Schema,
            t("Esquema y versión de este libro", "Schema and version of this workbook"),
            t("No se cambia", "Not to be changed"),
        )
    }
}
