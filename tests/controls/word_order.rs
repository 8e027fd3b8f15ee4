//! The order of the words of a block: read as a control wants it, and written so.

use proptest::prelude::*;
use proptest::sample::{select, subsequence};
use rodete::gcode::control::{Control, FAGOR_8055, FAGOR_8055_T, FAGOR_8070, LINUXCNC, Post};
use rodete::gcode::interpreter::{Interpreter, Setting};
use rodete::gcode::word::Word;
use rodete::gcode::writer::Writer;
use rodete::kinds::KINDS;
use rodete::number::grid::Milli;
use rodete::parameter::Value;
use rodete::text::{Language, Text};

use crate::common;

/// A block of every word that a Fagor 8055 may have, in its order: error solution, errors 0004 and 0048.
const ORDERED: [&str; 19] = [
    "G90", "G1", "G94", "G71", "X1", "Y2", "Z3", "U4", "V5", "W6", "A7", "B8", "C9", "F100", "S500", "T1", "D2", "M3",
    "M8",
];

/// The errors of a program that rodete rejects for the order of its words: of each block the error's number, empty where the manuals
/// name none.
fn disorders(control: &'static Control, blocks: &[String]) -> Vec<String> {
    let program = format!("%A,MX,\nG71 G90 G94 F100\nT1 D1\nG1\n{}\nM30\n", blocks.join("\n"));
    let faults = Interpreter::over(program.as_bytes(), Setting::new(control)).filter_map(Result::err);
    faults
        .map(|fault| {
            assert_eq!(fault.rule.code, "G0132", "{}: {:?}\n{program}", control.name, fault.what);
            let what = fault.what.en.into_owned();
            what.rsplit_once("(error ").map_or_else(String::new, |(_, error)| error.trim_end_matches(')').to_owned())
        })
        .collect()
}

/// The errors that the first word out of order may have, by the letters of a block: asked of all pairs, where rodete goes from word to
/// word.
fn errors(words: &[&str]) -> Option<Vec<&'static str>> {
    let order = "GXYZUVWABCFSTDM";
    let place = |word: &str| order.find(&word[..1]).expect("a letter");
    for (at, word) in words.iter().enumerate() {
        let behind: Vec<&&str> = words[..at].iter().filter(|before| place(before) > place(word)).collect();
        if behind.is_empty() {
            continue;
        }
        let kind =
            |word: &str| ["G", "XYZUVWABC", "FSTD", "M"].iter().position(|of| of.contains(&word[..1])).expect("a kind");
        return Some(
            behind
                .into_iter()
                .map(|before| match (kind(word), kind(before)) {
                    (0, 1) => "0004",
                    (0, 2) => "0009",
                    (0, _) => "",
                    (1, 1) => "0048",
                    (1, _) => "0002",
                    (_, 2) => "0003",
                    _ => "0012",
                })
                .collect(),
        );
    }
    None
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    /// Blocks by chance in the control's order are read, whatever is left out of them.
    #[test]
    fn blocks_in_the_order_of_a_fagor_8055_are_read(words in subsequence(ORDERED.to_vec(), 1..=ORDERED.len())) {
        for control in [&FAGOR_8055, &FAGOR_8055_T] {
            prop_assert!(disorders(control, &[words.join(" ")]).is_empty(), "{words:?}");
        }
    }

    /// Blocks in any other order are rejected with the error of the first word that stands wrong; of the other mills none is.
    #[test]
    fn blocks_in_another_order_are_rejected_by_a_fagor_8055_alone(
        words in subsequence(ORDERED.to_vec(), 2..=6).prop_shuffle(),
    ) {
        let block = words.join(" ");
        let expected = errors(&words);
        for control in [&FAGOR_8055, &FAGOR_8055_T] {
            let found = disorders(control, std::slice::from_ref(&block));
            match &expected {
                None => prop_assert!(found.is_empty(), "{block}"),
                Some(errors) => prop_assert!(found.len() == 1 && errors.contains(&found[0].as_str()), "{block}: {found:?}"),
            }
        }
        prop_assert!(disorders(&FAGOR_8070, &[block]).is_empty());
    }

    /// Words that a kind hands over in any order are written as each control takes them.
    #[test]
    fn a_writer_puts_words_into_the_order_of_its_control(
        letters in subsequence("XYZUVWABCFSTDM".chars().collect::<Vec<_>>(), 1..=14).prop_shuffle(),
        post in select(
            [&FAGOR_8055, &FAGOR_8070, &LINUXCNC, &FAGOR_8055_T].map(|control| Post::of(control).expect("written")).to_vec()
        ),
    ) {
        let mut writer = Writer::new(post, Vec::new());
        writer.rapid(letters.iter().map(|letter| Word::size(*letter, Milli::ZERO)));
        let program = writer.program("plan", Text::same("plan"));
        let written: String = program.text().split_whitespace().skip(2).filter_map(|word| word.chars().next()).collect();
        let given: String = letters.iter().collect();
        if post.control.name.starts_with("fagor-8055") {
            let sorted: String = "XYZUVWABCFSTDM".chars().filter(|letter| given.contains(*letter)).collect();
            prop_assert_eq!(written, sorted);
        } else {
            prop_assert_eq!(written, given);
        }
    }
}

/// The words of an axis in the blocks of a program, letters alone, each set once.
fn axis_words(text: &str) -> Vec<String> {
    let blocks = text.lines().filter(|line| line.starts_with('N'));
    let letters = |line: &str| -> String {
        let letters = line.split_whitespace().filter_map(|word| word.chars().next());
        letters.filter(|letter| "XYZUVWABC".contains(*letter)).collect()
    };
    let mut found: Vec<String> = blocks.map(letters).filter(|letters| letters.len() > 1).collect();
    found.sort();
    found.dedup();
    found
}

#[test]
fn programs_of_every_kind_for_a_fagor_8055_have_their_axes_in_its_order() {
    let mut seen = Vec::new();
    for kind in KINDS.iter().filter(|kind| kind.form().lists.iter().all(|list| !list.is_program)) {
        for case in kind.cases() {
            let changes = [("dialect", Value::Choice("fagor-8055"))];
            for program in &common::outcome_of(*kind, case, Language::En, &changes).programs {
                let text = program.text();
                for letters in axis_words(&text) {
                    let ordered: String = "XYZUVWABC".chars().filter(|letter| letters.contains(*letter)).collect();
                    assert_eq!(letters, ordered, "{} {} {}", kind.form().kind, case.name, program.program.key);
                    seen.push(letters);
                }
                let read = program.program.read_back().filter_map(Result::err).find(|fault| fault.rule.code == "G0132");
                assert!(read.is_none(), "{} {}: {read:?}", kind.form().kind, case.name);
            }
        }
    }
    // A block of each kind that has more than one axis: hole, branch, impeller.
    for letters in ["XZABC", "XA", "XYZBC"] {
        assert!(seen.iter().any(|one| one == letters), "{letters}: {seen:?}");
    }
}

#[test]
fn the_words_of_a_hole_stay_where_they_were_on_the_other_mills() {
    for (dialect, letters) in [("fagor-8070", "AXZBC"), ("linuxcnc", "AXZBC"), ("fagor-8055", "XZABC")] {
        let kind = KINDS.iter().find(|kind| kind.form().kind == "pipe-hole").expect("the hole");
        let outcome = common::outcome_of(*kind, &kind.cases()[0], Language::En, &[("dialect", Value::Choice(dialect))]);
        let found = axis_words(&outcome.programs[0].text());
        assert!(found.iter().any(|one| one == letters), "{dialect}: {found:?}");
    }
}
