//! Text in the two languages that rodete speaks.
//!
//! Everything a person reads on a sheet, in a report or in a finding is a [`Text`]; the language is chosen only where
//! the text is shown.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

/// A language of sheets, reports and findings.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Language {
    /// Spanish.
    Es,
    /// English.
    #[default]
    En,
}

impl Language {
    /// Both languages, Spanish first.
    pub const ALL: [Self; 2] = [Self::Es, Self::En];

    /// The ISO 639-1 code, `es` or `en`.
    #[must_use]
    pub const fn code(self) -> &'static str {
        match self {
            Self::Es => "es",
            Self::En => "en",
        }
    }
}

/// One text in Spanish and English.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Text {
    /// Spanish.
    pub es: Cow<'static, str>,
    /// English.
    pub en: Cow<'static, str>,
}

impl Text {
    /// A text known when rodete was compiled.
    #[must_use]
    pub const fn fixed(es: &'static str, en: &'static str) -> Self {
        Self { es: Cow::Borrowed(es), en: Cow::Borrowed(en) }
    }

    /// A text that carries values.
    #[must_use]
    pub const fn new(es: String, en: String) -> Self {
        Self { es: Cow::Owned(es), en: Cow::Owned(en) }
    }

    /// A text that is the same in both languages: a symbol, a name typed by the user.
    #[must_use]
    pub fn same(text: impl Into<String>) -> Self {
        let text = text.into();
        Self::new(text.clone(), text)
    }

    /// The text in one language.
    #[must_use]
    pub fn get(&self, language: Language) -> &str {
        match language {
            Language::Es => &self.es,
            Language::En => &self.en,
        }
    }

    /// True where there is nothing to read in either language.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.es.is_empty() && self.en.is_empty()
    }
}

/// The text as it may be shown on a terminal, in a report or in a comment: what a terminal would obey and what a
/// reader cannot see is written out as `\u{1b}`.
///
/// Escaped are control characters (line feed and tab among them), marks that turn the direction of writing, blanks
/// without width, separators of lines and paragraphs, and tags. Everything else stays as it is.
#[must_use]
pub fn printable(text: &str) -> Cow<'_, str> {
    if !text.chars().any(unprintable) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 16);
    for character in text.chars() {
        if unprintable(character) {
            shown.extend(character.escape_unicode());
        } else {
            shown.push(character);
        }
    }
    Cow::Owned(shown)
}

/// True for a character that a terminal obeys or a reader cannot see.
#[must_use]
pub fn unprintable(character: char) -> bool {
    character.is_control()
        || matches!(character,
            '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}'
            | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}')
}

#[cfg(test)]
mod tests {
    use super::printable;

    #[test]
    fn what_a_terminal_obeys_is_written_out() {
        for (text, shown) in [
            ("Rodete n.º 1 – Ø50, β", "Rodete n.º 1 – Ø50, β"),
            ("a\u{1b}[2Jb", "a\\u{1b}[2Jb"),
            ("a\r\nb\tc", "a\\u{d}\\u{a}b\\u{9}c"),
            ("\u{9b}31m", "\\u{9b}31m"),
            ("gpj\u{202e}xslx.", "gpj\\u{202e}xslx."),
            ("\u{2066}x\u{2069}", "\\u{2066}x\\u{2069}"),
            ("zero\u{200b}width\u{feff}", "zero\\u{200b}width\\u{feff}"),
            ("família 👨‍👩‍👧", "família 👨‍👩‍👧"),
        ] {
            assert_eq!(printable(text), shown, "{text:?}");
        }
    }
}
