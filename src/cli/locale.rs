//! The language of messages.

use std::env;

use clap::builder::{PossibleValuesParser, TypedValueParser};

use crate::text::Language;

/// Reads a language that the command line asks for, by its code.
pub(super) fn language() -> impl TypedValueParser<Value = Language> {
    PossibleValuesParser::new(Language::ALL.map(Language::code))
        .map(|code| if code == Language::Es.code() { Language::Es } else { Language::En })
}

/// The language that was asked for, else that of the workbook, else that of the locale.
#[expect(clippy::disallowed_methods, reason = "the door to the environment: the language that is spoken")]
pub(super) fn spoken(asked: Option<Language>, workbook: Option<Language>) -> Language {
    asked.or(workbook).unwrap_or_else(|| {
        let variables = ["LC_ALL", "LC_MESSAGES", "LANG"];
        let locale = variables.into_iter().filter_map(env::var_os).find(|value| !value.is_empty()).unwrap_or_default();
        of(&locale.to_string_lossy())
    })
}

/// The language of a locale as `es_ES.UTF-8`; English for all others.
fn of(locale: &str) -> Language {
    let language = locale.split(['_', '.', '@', '-']).next().unwrap_or_default();
    if language.eq_ignore_ascii_case("es") { Language::Es } else { Language::En }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_locale_is_spanish_or_english() {
        for locale in ["es", "es_ES.UTF-8", "es_MX", "ES-es", "es@euro"] {
            assert_eq!(of(locale), Language::Es, "{locale}");
        }
        for locale in ["", "C", "C.UTF-8", "en_GB", "est_EE", "de_DE.UTF-8", "POSIX"] {
            assert_eq!(of(locale), Language::En, "{locale}");
        }
    }

    #[test]
    fn what_is_asked_for_comes_before_the_workbook() {
        assert_eq!(spoken(Some(Language::En), Some(Language::Es)), Language::En);
        assert_eq!(spoken(None, Some(Language::Es)), Language::Es);
    }
}
