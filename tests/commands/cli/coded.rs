//! What is printed carries the code by which `rodete explain` knows it.

use std::collections::BTreeMap;
use std::fs;

use rodete::cli::rows;
use rodete::kinds::KINDS;
use rodete::text::Language;
use serde_json::Value as Json;
use tempfile::TempDir;

use super::common::{rodete, with_refused, workbook};

/// A turning program that crosses its stock at rapid.
const CRASH: &str = "G50 S2500\nT0101\nG97 S900 M3\nG0 X40. Z-10.\nM30\n";

/// Inputs of every kind, good and bad, and the commands that take them.
fn inputs() -> (TempDir, Vec<Vec<&'static str>>) {
    let folder = with_refused();
    workbook(&folder.path().join("good.xlsx"), &[]);
    for (name, text) in [
        ("part.ngc", "G0 X1 Q\nG1 X2\nM2\n"),
        ("crash.nc", CRASH),
        ("a.var", "5220\t3.5\n"),
        ("bad.var", "5161\t0\n5221\t1,5\nx\n"),
        ("text.xlsx", "hello\n"),
    ] {
        fs::write(folder.path().join(name), text).expect("an input");
    }
    let commands = vec![
        vec!["check", "text.xlsx", "impeller.xlsx", "good.xlsx"],
        vec!["build", "impeller.xlsx", "good.xlsx", "--no-report"],
        vec!["verify", "part.ngc"],
        vec!["verify", "part.ngc", "missing.ngc"],
        vec!["simulate", "crash.nc"],
        vec!["offsets", "a.var"],
        vec!["offsets", "bad.var"],
    ];
    (folder, commands)
}

/// Both streams of a command.
fn said(folder: &TempDir, words: &[&str]) -> (String, String) {
    let done = rodete(folder).args(words).output().expect("it ran");
    let [out, err] = [done.stdout, done.stderr].map(|text| String::from_utf8(text).expect("text"));
    (out, err)
}

/// How often each grade is told with each code; an empty one where a finding has none.
type Told = BTreeMap<(String, String), usize>;

/// What is printed: lines that begin with a grade's word.
fn printed(text: &str, language: Language) -> Told {
    let words = match language {
        Language::Es => [("stop", "error"), ("caution", "precaución"), ("note", "nota")],
        Language::En => [("stop", "error"), ("caution", "caution"), ("note", "note")],
    };
    let mut told = Told::new();
    for line in text.lines() {
        for (grade, word) in words {
            let Some((head, _)) = line.strip_prefix(word).and_then(|rest| rest.split_once(": ")) else { continue };
            if head.is_empty() || (head.len() == 6 && head.starts_with(' ')) {
                *told.entry((grade.to_owned(), head.trim_start().to_owned())).or_default() += 1;
            }
        }
    }
    told
}

/// The findings of a document, wherever they stand in it.
fn documented(value: &Json, told: &mut Told) {
    match value {
        Json::Object(object) => {
            for (key, value) in object {
                let list = value.as_array().filter(|_| key == "findings");
                for finding in list.into_iter().flatten() {
                    let text = |key: &str| finding[key].as_str().unwrap_or_default().to_owned();
                    *told.entry((text("grade"), text("code"))).or_default() += 1;
                }
                if list.is_none() {
                    documented(value, told);
                }
            }
        }
        Json::Array(values) => values.iter().for_each(|value| documented(value, told)),
        _ => {}
    }
}

#[test]
fn what_is_printed_carries_the_codes_that_the_document_has() {
    let (folder, commands) = inputs();
    for command in commands {
        let (document, err) = said(&folder, &[command.as_slice(), &["--json"]].concat());
        assert_eq!(err, "", "{command:?}: a document is all that is printed");
        let mut wanted = Told::new();
        documented(&serde_json::from_str(&document).expect("a document"), &mut wanted);
        assert!(wanted.keys().any(|(_, code)| !code.is_empty()), "{command:?}: {wanted:?}");
        for language in Language::ALL {
            let (out, err) = said(&folder, &[command.as_slice(), &["--lang", language.code()]].concat());
            assert_eq!(printed(&(out + &err), language), wanted, "{command:?} in {}", language.code());
        }
    }
}

#[test]
fn the_last_line_tells_how_to_learn_more_of_the_first_code_that_needs_attention() {
    let (folder, mut commands) = inputs();
    // Refused before any input is read, or printed nowhere as a document.
    commands.extend([
        vec!["view", "part.ngc"],
        vec!["check", "good.xlsx", "./good.xlsx"],
        vec!["explain", "Z9999"],
        vec!["new", "impeller", "good.xlsx"],
    ]);
    let mut told = 0;
    let known: Vec<_> = rows(KINDS).into_iter().map(|rule| rule.code).collect();
    for command in commands {
        for (language, more) in
            [("en", "says what it means, with an example"), ("es", "dice qué significa, con un ejemplo")]
        {
            let (out, err) = said(&folder, &[command.as_slice(), &["--lang", language]].concat());
            let head = err.lines().find_map(|line| line.split_once(": ")?.0.split_once(' '));
            let Some(head) = head else {
                assert!(!(out + &err).contains(more), "{command:?}: {err}");
                continue;
            };
            told += 1;
            assert!(known.contains(&head.1), "{command:?}: {err}");
            assert!(err.ends_with(&format!("\nrodete explain {} {more}\n", head.1)), "{command:?}: {err}");
            assert_eq!((out + &err).matches(more).count(), 1, "{command:?}: told once");
            assert!(said(&folder, &["explain", head.1]).0.starts_with(head.1), "{command:?}");
        }
    }
    assert!(told >= 16, "codes are told of: {told}");
}

#[test]
fn notes_alone_tell_no_more() {
    let folder = with_refused();
    fs::write(folder.path().join("part.ngc"), "G0 X1\nM2\n").expect("a program");
    let (out, err) = said(&folder, &["verify", "part.ngc"]);
    assert!(
        out.contains("\nnote U0127: no dialect given: rodete reads the program as linuxcnc\n")
            && !out.contains("explain"),
        "{out}"
    );
    assert_eq!(err, "");
}

#[test]
fn what_is_wrong_with_the_words_of_a_command_has_no_code() {
    let (_, err) = said(&with_refused(), &["check", "--nothing"]);
    assert!(err.starts_with("error: unexpected argument") && !err.contains("rodete explain"), "{err}");
}
