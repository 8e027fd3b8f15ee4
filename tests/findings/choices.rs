//! The words of lists: each is read by its key and in both languages, whatever the language of the workbook.

use rodete::kinds::KINDS;
use rodete::parameter::{FieldKind, Value};
use rodete::text::Language;

use crate::workbook::{Parts, impeller, sound};

#[test]
fn the_words_of_either_language_mean_the_same_in_both_workbooks() {
    let cells = [
        ("method", ["clear", "canal"]),
        ("method", ["published", "publicado"]),
        ("style", ["full", "completo"]),
        ("style", ["annex", "anexo"]),
        ("splitter_fade", ["each-side", "cada lado"]),
        ("rotary", ["linear", "lineal"]),
    ];
    for language in Language::ALL {
        for (key, words) in cells {
            for word in words {
                let filled = impeller(&Parts::of(&sound(language)).string(key, word).zip()).expect(word);
                assert_eq!(filled.values.values[key], Value::Choice(words[0]), "{word}");
            }
        }
    }
}

/// A word that two choices of a list have would be read as the first of them.
#[test]
fn no_word_of_a_list_means_two_things() {
    let fields = KINDS.iter().flat_map(|kind| kind.form().parameters());
    for (_, parameter) in fields {
        let FieldKind::Choice(choices) = parameter.kind else { continue };
        for (at, one) in choices.iter().enumerate() {
            for word in [one.key, &one.label.es, &one.label.en] {
                let same =
                    |other: &rodete::parameter::Choice| [other.key, &other.label.es, &other.label.en].contains(&word);
                assert_eq!(choices.iter().position(same), Some(at), "{}: {word}", parameter.key);
            }
        }
    }
}
