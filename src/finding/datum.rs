//! What a finding carries beside its sentence: numbers with their unit, whole numbers and words.

use std::borrow::Cow;

use serde::Serialize;

use crate::number::{decimal, shown};
use crate::text::{Language, Text};

/// A value of a finding for a program that reads the JSON: the number itself, not its rounded text.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Datum {
    /// A number with its unit; `null` where it has no bound.
    Number {
        /// The number itself; `null` where it is not finite.
        value: Option<f64>,
        /// Its unit as it is printed, empty for none.
        unit: &'static str,
        /// The most decimals that it is said with; none where it is said with every digit.
        #[serde(skip)]
        decimals: Option<usize>,
    },
    /// A whole number.
    Whole(i64),
    /// Whole numbers, as lines.
    Wholes(Vec<i64>),
    /// A word that is the same in both languages: a code, a symbol, a name that the user typed.
    Word(String),
    /// A word that has a Spanish and an English form.
    Words(Text),
}

impl Datum {
    /// The number that it is; none of what is none, or has no bound.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "counts of lines and blocks are far below 2^53")]
    pub const fn number(&self) -> Option<f64> {
        match self {
            Self::Number { value, .. } => *value,
            Self::Whole(value) => Some(*value as f64),
            _ => None,
        }
    }

    /// True where both are said alike: of numbers what their last decimal shows is no difference.
    #[must_use]
    pub fn alike(&self, other: &Self) -> bool {
        match (self, other) {
            (
                Self::Number { value: Some(one), unit, decimals: Some(decimals) },
                Self::Number { value: Some(other), unit: other_unit, decimals: Some(other_decimals) },
            ) => (unit, decimals) == (other_unit, other_decimals) && shown(*one, *decimals) == shown(*other, *decimals),
            _ => self == other,
        }
    }
}

/// A type whose values stand in the sentences of a rule.
pub trait Said {
    /// How the value is said in a language.
    fn said(&self, language: Language) -> Cow<'_, str>;
    /// The value itself.
    fn datum(&self) -> Datum;
}

/// A number with its unit, said with at most so many decimals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// The number; infinite where there is no bound.
    pub value: f64,
    /// The unit as it is printed, empty for none.
    pub unit: &'static str,
    /// The most decimals that it is said with.
    pub decimals: usize,
}

impl Size {
    /// A length in mm, said to the thousandth.
    #[must_use]
    pub const fn mm(value: f64) -> Self {
        Self { value, unit: "mm", decimals: 3 }
    }

    /// A length in mm, said with at most so many decimals.
    #[must_use]
    pub const fn length(value: f64, decimals: usize) -> Self {
        Self { value, unit: "mm", decimals }
    }

    /// A number without a unit, said with at most so many decimals.
    #[must_use]
    pub const fn number(value: f64, decimals: usize) -> Self {
        Self { value, unit: "", decimals }
    }

    /// An angle in degrees, said with at most so many decimals.
    #[must_use]
    pub const fn degrees(value: f64, decimals: usize) -> Self {
        Self { value, unit: "°", decimals }
    }

    /// A share in percent, said with at most so many decimals.
    #[must_use]
    pub const fn percent(value: f64, decimals: usize) -> Self {
        Self { value, unit: "%", decimals }
    }

    /// A feed in mm/min, said with at most so many decimals.
    #[must_use]
    pub const fn feed(value: f64, decimals: usize) -> Self {
        Self { value, unit: "mm/min", decimals }
    }

    /// A speed of a spindle in revolutions a minute, said to the whole one.
    #[must_use]
    pub const fn rpm(value: f64) -> Self {
        Self { value, unit: "rpm", decimals: 0 }
    }

    /// A volume in mm³, said to the tenth.
    #[must_use]
    pub const fn mm3(value: f64) -> Self {
        Self { value, unit: "mm³", decimals: 1 }
    }
}

impl Said for Size {
    fn said(&self, _: Language) -> Cow<'_, str> {
        if self.value.is_infinite() {
            return if self.value > 0.0 { "∞".into() } else { "-∞".into() };
        }
        let number = shown(self.value, self.decimals);
        match self.unit {
            "" => number.into(),
            "°" => format!("{number}°").into(),
            unit => format!("{number} {unit}").into(),
        }
    }

    fn datum(&self) -> Datum {
        Datum::Number {
            value: self.value.is_finite().then_some(self.value),
            unit: self.unit,
            decimals: Some(self.decimals),
        }
    }
}

/// A number with its unit whose sentence does without the unit, as behind the letter of an axis: said as the number alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bare(pub Size);

impl Bare {
    /// A length in mm, said with at most so many decimals.
    #[must_use]
    pub const fn mm(value: f64, decimals: usize) -> Self {
        Self(Size::length(value, decimals))
    }
}

impl Said for Bare {
    fn said(&self, language: Language) -> Cow<'_, str> {
        let number = Size { unit: "", ..self.0 };
        number.said(language).into_owned().into()
    }

    fn datum(&self) -> Datum {
        self.0.datum()
    }
}

/// A number as somebody typed it, with its unit: in the fewest digits that give it back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Typed {
    /// The number, in the unit.
    pub value: f64,
    /// The unit as it is printed, empty for none.
    pub unit: &'static str,
}

impl Said for Typed {
    fn said(&self, _: Language) -> Cow<'_, str> {
        let number = decimal(self.value);
        match self.unit {
            "" => number.into(),
            "°" => format!("{number}°").into(),
            unit => format!("{number} {unit}").into(),
        }
    }

    fn datum(&self) -> Datum {
        Datum::Number { value: self.value.is_finite().then_some(self.value), unit: self.unit, decimals: None }
    }
}

/// A number as it stands in the program, or as it was computed from it, with every digit.
impl Said for f64 {
    fn said(&self, _: Language) -> Cow<'_, str> {
        self.to_string().into()
    }

    fn datum(&self) -> Datum {
        Datum::Number { value: self.is_finite().then_some(*self), unit: "", decimals: None }
    }
}

impl Said for i64 {
    fn said(&self, _: Language) -> Cow<'_, str> {
        self.to_string().into()
    }

    fn datum(&self) -> Datum {
        Datum::Whole(*self)
    }
}

impl Said for u8 {
    fn said(&self, _: Language) -> Cow<'_, str> {
        self.to_string().into()
    }

    fn datum(&self) -> Datum {
        Datum::Whole(i64::from(*self))
    }
}

impl Said for u32 {
    fn said(&self, _: Language) -> Cow<'_, str> {
        self.to_string().into()
    }

    fn datum(&self) -> Datum {
        Datum::Whole(i64::from(*self))
    }
}

impl Said for u64 {
    fn said(&self, _: Language) -> Cow<'_, str> {
        self.to_string().into()
    }

    fn datum(&self) -> Datum {
        Datum::Whole(i64::try_from(*self).unwrap_or(i64::MAX))
    }
}

impl Said for usize {
    fn said(&self, _: Language) -> Cow<'_, str> {
        self.to_string().into()
    }

    fn datum(&self) -> Datum {
        Datum::Whole(i64::try_from(*self).unwrap_or(i64::MAX))
    }
}

impl Said for char {
    fn said(&self, _: Language) -> Cow<'_, str> {
        self.to_string().into()
    }

    fn datum(&self) -> Datum {
        Datum::Word(self.to_string())
    }
}

impl Said for &'static str {
    fn said(&self, _: Language) -> Cow<'_, str> {
        Cow::Borrowed(self)
    }

    fn datum(&self) -> Datum {
        Datum::Word((*self).to_owned())
    }
}

impl Said for String {
    fn said(&self, _: Language) -> Cow<'_, str> {
        Cow::Borrowed(self)
    }

    fn datum(&self) -> Datum {
        Datum::Word(self.clone())
    }
}

impl Said for Text {
    fn said(&self, language: Language) -> Cow<'_, str> {
        Cow::Borrowed(self.get(language))
    }

    fn datum(&self) -> Datum {
        Datum::Words(self.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::{Said, Size, Typed};

    #[test]
    fn numbers_are_alike_where_their_last_decimal_shows_no_difference() {
        let alike = |one: f64, other: f64| Size::mm(one).datum().alike(&Size::mm(other).datum());
        assert!(alike(1.000_1, 1.000_2) && !alike(1.0, 1.001) && alike(f64::INFINITY, f64::INFINITY));
        assert!(!alike(1.0, f64::INFINITY) && !Size::mm(1.0).datum().alike(&Size::rpm(1.0).datum()));
        let typed = |value| Typed { value, unit: "mm" }.datum();
        assert!(!typed(1.000_1).alike(&typed(1.000_2)) && 3_u32.datum().alike(&3_u32.datum()));
        assert_ne!(Size::mm(1.000_1).datum(), Size::mm(1.000_2).datum());
    }
}
