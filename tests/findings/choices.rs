//! The words of lists: each is read by its key and in both languages, whatever the language of the workbook.

use rodete::gcode::control::RotaryMode;
use rodete::kinds::KINDS;
use rodete::parameter::field::Chosen;
use rodete::parameter::{FieldKind, Value};
use rodete::text::Language;
use rodete::workbook::read;

use crate::common;
use crate::workbook::{Parts, impeller, quick_of, sound, written};

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
            for word in one.words() {
                let same = |other: &rodete::parameter::Choice| other.words().any(|said| said == word);
                assert_eq!(choices.iter().position(same), Some(at), "{}: {word}", parameter.key);
            }
        }
    }
}

/// A workbook of before holds the words of before, which its form finds no fault with either.
#[test]
fn what_a_choice_was_once_called_is_still_read() {
    let lathe = KINDS.iter().find(|kind| kind.form().kind == "lathe").expect("the lathe");
    for (language, now) in [(Language::Es, "según el voladizo"), (Language::En, "by the stick-out")] {
        let parts = Parts::of(&written(*lathe, quick_of(*lathe), language));
        let [now, then] = [now, "by the overhang"].map(|word| format!(">{word}</t>"));
        let filled = read(&parts.replace("xl/sharedStrings.xml", &now, &then).zip(), &[lathe.form()]).expect("read");
        assert_eq!(filled.values.values["tailstock"], Value::Choice("auto"));
    }
    let form = Parts::of(&written(*lathe, quick_of(*lathe), Language::En)).text("xl/worksheets/sheet1.xml");
    assert!(form.contains("=\"by the overhang\"") || form.contains("=&quot;by the overhang&quot;"));
}

#[test]
fn the_verification_says_how_rotary_axes_count_in_both_languages() {
    for mode in [RotaryMode::Linear, RotaryMode::Rollover] {
        let made = common::outcome("full", &[("rotary", Value::Choice(mode.key()))]);
        let row = made.checks.iter().find(|check| check.key() == "rotary").expect("its row");
        assert_eq!(row.limit(), mode.label());
    }
    assert_ne!(RotaryMode::Linear.label().es, RotaryMode::Linear.label().en);
}
