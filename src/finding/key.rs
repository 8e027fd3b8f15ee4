//! The keys of a form's parameters, as findings name them.

use std::borrow::{Borrow, Cow};

use serde::Serialize;

use crate::finding::{Datum, Said};
use crate::text::Language;

/// The key of a parameter: [`crate::parameter::Parameter::key`] makes it, and nothing else does, so that a finding names no
/// parameter that is not in a form. A place says it whole, a sentence by its symbol.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(transparent)]
pub struct Key(&'static str);

impl Key {
    /// That of a parameter's row.
    pub(crate) const fn of_row(key: &'static str) -> Self {
        Self(key)
    }

    /// The key as it stands in the row.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.0
    }

    /// The symbol that stands in column A: the key without its sheet.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        self.0.rsplit_once('/').map_or(self.0, |(_, symbol)| symbol)
    }
}

impl Borrow<str> for Key {
    fn borrow(&self) -> &str {
        self.0
    }
}

impl Said for Key {
    fn said(&self, _: Language) -> Cow<'_, str> {
        self.symbol().into()
    }

    fn datum(&self) -> Datum {
        Datum::Word(self.symbol().to_owned())
    }
}
