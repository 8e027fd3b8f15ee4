//! Text in the two languages that rodete speaks.
//!
//! Everything a person reads on a sheet, in a report or in a finding is a [`Text`]; the language is chosen only where
//! the text is shown.

use std::borrow::Cow;
use std::fmt::Display;

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

/// A text known when rodete was compiled, in Spanish and English: how every label is written.
#[must_use]
pub const fn t(es: &'static str, en: &'static str) -> Text {
    Text { es: Cow::Borrowed(es), en: Cow::Borrowed(en) }
}

impl Text {
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

    /// The text in one language, by itself.
    #[must_use]
    pub fn take(self, language: Language) -> Cow<'static, str> {
        match language {
            Language::Es => self.es,
            Language::En => self.en,
        }
    }

    /// True where there is nothing to read in either language.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.es.is_empty() && self.en.is_empty()
    }
}

/// A text of rodete's own as paper has it: with a true minus sign, U+2212, before a number and between two terms. A word of a program,
/// as `X-5`, a range of years and a name keep their hyphens. The terminal, JSON, CSV and programs have the hyphen alone.
#[must_use]
pub fn true_minus(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut before = None;
    let mut rest = text.chars().peekable();
    while let Some(one) = rest.next() {
        let after = rest.peek().copied();
        let opens = before.is_none_or(|before: char| before.is_whitespace() || "([≥≤<>=…~".contains(before));
        let number = after.is_some_and(|after| after.is_ascii_digit() || after == '∞');
        let term = before == Some(' ') && after == Some(' ');
        out.push(if one == '-' && (opens && number || term) { '\u{2212}' } else { one });
        before = Some(one);
    }
    out
}

/// A count with what is counted, in words: `1 move`, `2 moves`. Each pair is the singular and the plural.
#[must_use]
pub fn many(count: impl Display, es: [&str; 2], en: [&str; 2]) -> Text {
    let count = count.to_string();
    let at = usize::from(count != "1");
    Text::new(format!("{count} {}", es[at]), format!("{count} {}", en[at]))
}

/// What to choose one of, in words: `a, b or c`. Empty where there is nothing to choose.
#[must_use]
pub fn one_of(choices: impl IntoIterator<Item = Text>) -> Text {
    listed(choices, ["o", "or"])
}

/// What is meant together, in words: `a, b and c`. Empty where there is nothing.
#[must_use]
pub fn all_of(parts: impl IntoIterator<Item = Text>) -> Text {
    listed(parts, ["y", "and"])
}

fn listed(parts: impl IntoIterator<Item = Text>, [es, en]: [&str; 2]) -> Text {
    let parts: Vec<Text> = parts.into_iter().collect();
    let list = |language: Language, word: &str| {
        let parts: Vec<&str> = parts.iter().map(|part| part.get(language)).collect();
        match parts.split_last() {
            Some((last, others @ [_, ..])) => format!("{} {word} {last}", others.join(", ")),
            _ => parts.concat(),
        }
    };
    Text::new(list(Language::Es, es), list(Language::En, en))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_and_a_difference_have_a_true_minus_on_paper_and_words_of_programs_their_hyphen() {
        for (plain, paper) in [
            ("-5 mm, de -1000 a 1000", "−5 mm, de −1000 a 1000"),
            ("≥ -0.005 mm (-∞)", "≥ −0.005 mm (−∞)"),
            ("R - r - a_p", "R − r − a_p"),
            (
                "X-5 Z-3; 2026-11-23; SHA-256; sobre-plano; --from; \"-5\"",
                "X-5 Z-3; 2026-11-23; SHA-256; sobre-plano; --from; \"-5\"",
            ),
            ("", ""),
        ] {
            assert_eq!(true_minus(plain), paper);
        }
    }

    #[test]
    fn the_last_of_a_list_is_joined_by_a_word_and_those_before_it_by_commas() {
        let letters = |count: usize| ["a", "b", "c"].into_iter().take(count).map(Text::same);
        for (count, es, en) in [(0, "", ""), (1, "a", "a"), (2, "a o b", "a or b"), (3, "a, b o c", "a, b or c")] {
            assert_eq!(one_of(letters(count)), t(es, en));
        }
        assert_eq!(all_of(letters(3)), t("a, b y c", "a, b and c"));
    }

    #[test]
    fn one_is_counted_in_the_singular() {
        let lines = |count| many(count, ["línea", "líneas"], ["line", "lines"]);
        for (count, es, en) in [(0, "0 líneas", "0 lines"), (1, "1 línea", "1 line"), (2, "2 líneas", "2 lines")] {
            assert_eq!(lines(count), t(es, en));
        }
    }
}
