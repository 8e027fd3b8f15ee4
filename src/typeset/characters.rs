//! The characters that the report's fonts can show.
//!
//! A character without a glyph would print as an empty box, or stop a PDF/A altogether: it is found here and shown as
//! its code point instead, `[U+4E2D]`.

use unicode_normalization::UnicodeNormalization;

use crate::text::{Language, Text};

/// Ranges of characters that the fonts inside typst (Libertinus Serif, New Computer Modern, DejaVu Sans Mono) have
/// glyphs for, first and last, ascending: Latin, Greek, Cyrillic, punctuation, arrows, mathematics and the geometric
/// and technical signs. Combining marks and right-to-left scripts are left out: their shaping needs more than a glyph.
pub const SHOWN: &[(char, char)] = &[
    ('\u{20}', '\u{7E}'),
    ('\u{A0}', '\u{AC}'),
    ('\u{AE}', '\u{2FF}'),
    ('\u{370}', '\u{377}'),
    ('\u{37A}', '\u{37F}'),
    ('\u{384}', '\u{38A}'),
    ('\u{38C}', '\u{38C}'),
    ('\u{38E}', '\u{3A1}'),
    ('\u{3A3}', '\u{482}'),
    ('\u{48A}', '\u{4FF}'),
    ('\u{1E00}', '\u{1EFF}'),
    ('\u{2000}', '\u{200A}'),
    ('\u{2010}', '\u{2027}'),
    ('\u{202F}', '\u{205F}'),
    ('\u{2070}', '\u{2071}'),
    ('\u{2074}', '\u{208E}'),
    ('\u{2090}', '\u{209C}'),
    ('\u{20A0}', '\u{20BF}'),
    ('\u{2100}', '\u{2151}'),
    ('\u{2153}', '\u{2184}'),
    ('\u{2190}', '\u{23FF}'),
    ('\u{2460}', '\u{262F}'),
];

/// True for a character that the report can show as it is.
#[must_use]
pub fn shown(character: char) -> bool {
    SHOWN.iter().any(|&(first, last)| (first..=last).contains(&character))
}

/// True for an invisible character that changes the direction or the joining of its neighbours.
pub(crate) const fn steers(character: char) -> bool {
    matches!(character, '\u{AD}' | '\u{61C}' | '\u{200B}'..='\u{200F}' | '\u{2028}'..='\u{202E}' | '\u{2060}'..='\u{206F}' | '\u{FEFF}' | '\u{FFF9}'..='\u{FFFB}')
}

/// A text as the report shows it, composed (NFC), with every character that has no glyph as its code point.
/// The characters replaced are added to `missing`, each once.
fn show(text: &str, missing: &mut Vec<char>) -> String {
    let mut out = String::with_capacity(text.len());
    for one in text.nfc() {
        if shown(one) {
            out.push(one);
        } else {
            out.push_str(&code_point(one));
            if !missing.contains(&one) {
                missing.push(one);
            }
        }
    }
    out
}

/// Chooses the language and minds the characters.
pub(crate) struct Words {
    /// The report's language.
    pub language: Language,
    /// Characters without a glyph, each once.
    pub missing: Vec<char>,
}

impl Words {
    /// Nothing missing yet.
    pub fn new(language: Language) -> Self {
        Self { language, missing: Vec::new() }
    }

    /// A text in the report's language.
    pub fn text(&mut self, text: &Text) -> String {
        show(text.get(self.language), &mut self.missing)
    }

    /// A line that is the same in both languages.
    pub fn line(&mut self, text: &str) -> String {
        show(text, &mut self.missing)
    }
}

/// A character's code point in brackets.
pub(crate) fn code_point(character: char) -> String {
    format!("[U+{:04X}]", u32::from(character))
}

#[cfg(test)]
mod tests {
    use super::{SHOWN, show, steers};

    #[test]
    fn characters_without_a_glyph_are_shown_by_their_code_point() {
        let mut missing = Vec::new();
        assert_eq!(
            show("Rodete 中\u{1B}[31m\u{202E} ñ ″ Ø", &mut missing),
            "Rodete [U+4E2D][U+001B][31m[U+202E] ñ ″ Ø"
        );
        assert_eq!(missing, ['中', '\u{1B}', '\u{202E}']);
    }

    #[test]
    fn decomposed_letters_are_composed() {
        let mut missing = Vec::new();
        assert_eq!(show("disen\u{303}o a\u{301}labe", &mut missing), "diseño álabe");
        assert!(missing.is_empty());
    }

    #[test]
    fn the_ranges_ascend_and_steer_nothing() {
        for pair in SHOWN.windows(2) {
            assert!(pair[0].0 <= pair[0].1 && pair[0].1 < pair[1].0, "{pair:?}");
        }
        assert!(SHOWN.iter().all(|&(first, last)| (first..=last).all(|one| !steers(one) && !one.is_control())));
    }
}
