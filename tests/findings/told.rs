//! What each example is told, as `explain` shows it: sentence and remedy with real figures.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

use rodete::cli::rows;
use rodete::finding::{Example, Finding, Rule};
use rodete::kinds::KINDS;

/// What is told of these hangs on the machine or on the run, or takes a million motions: their lines are written by hand.
const BY_HAND: [&str; 4] = ["D0205", "D0208", "L0207", "U0142"];

const FILE: &str = "src/cli/explain/told.tsv";

/// The tests of the rows run side by side.
static WRITING: Mutex<()> = Mutex::new(());

/// The lines of the file, by the code.
fn held() -> BTreeMap<String, String> {
    let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(FILE)).unwrap();
    let line = |line: &str| line.split_once('\t').map(|(code, told)| (code.to_owned(), told.to_owned()));
    text.lines().map(|text| line(text).unwrap()).collect()
}

/// True of a row whose sentence or remedy carries something.
fn carries(rule: &Rule) -> bool {
    [&rule.what, &rule.remedy].iter().any(|text| text.en.contains('{') || text.es.contains('{'))
}

/// A text without the names of the folders that a test works in, and with the long names of the examples cut.
fn as_shown(text: &str) -> String {
    let folder = format!("{}/.tmp", std::env::temp_dir().display());
    let text = text.replace(&"x".repeat(300), "xxx…xxx");
    let mut parts = text.split(&folder);
    let first = parts.next().unwrap_or_default().to_owned();
    // Six characters by chance follow.
    parts.fold(first, |shown, part| match part[6..].strip_prefix('/') {
        Some(rest) => shown + rest,
        None => shown + "parts" + &part[6..],
    })
}

/// Names of sheets in English and in Spanish.
const SHEETS: [[&str; 2]; 7] = [
    ["DATA", "DATOS"],
    ["CALIBRATION", "CALIBRACION"],
    ["TOOLS", "HERRAMIENTAS"],
    ["PROGRAM", "PROGRAMA"],
    ["PROFILE", "PERFIL"],
    ["SWEEP", "BARRIDO"],
    ["OFFSETS", "ORIGENES"],
];

/// What is told in Spanish of an English workbook, as it is told of a Spanish one: its sheets have Spanish names. A text that has a name in
/// both languages speaks of both.
fn of_a_spanish_book(told: [String; 2]) -> [String; 2] {
    let word = |letter: char| letter.is_alphanumeric() || letter == '_';
    let is_name = |text: &str, at: usize, name: &str| {
        !text[..at].chars().next_back().is_some_and(word) && !text[at + name.len()..].chars().next().is_some_and(word)
    };
    let whole = told.concat();
    told.map(|mut text| {
        for [en, es] in SHEETS.into_iter().filter(|[_, es]| !whole.contains(es)) {
            let found = text.match_indices(en).map(|(at, _)| at).filter(|&at| is_name(&text, at, en));
            for at in found.collect::<Vec<_>>().into_iter().rev() {
                text.replace_range(at..at + en.len(), es);
            }
        }
        text
    })
}

/// Compares sentence and remedy, each in Spanish and English, of a row's example with what `explain` shows; writes them where
/// that is meant.
pub fn compare(rule: &Rule, what: [&str; 2], remedy: [&str; 2]) {
    if !carries(rule) || BY_HAND.contains(&rule.code) {
        return;
    }
    let shown = |text: &str| as_shown(text).replace(['\n', '\t'], " ");
    let [es, en] = [0, 1].map(|language| [shown(what[language]), shown(remedy[language])]);
    let told = [of_a_spanish_book(es), en].concat().join("\t");
    let _writing = WRITING.lock().unwrap_or_else(PoisonError::into_inner);
    let mut all = held();
    if super::reference::write() {
        all.insert(rule.code.to_owned(), told);
        let text: String = all.iter().map(|(code, told)| format!("{code}\t{told}\n")).collect();
        fs::write(Path::new(env!("CARGO_MANIFEST_DIR")).join(FILE), text).unwrap();
        return;
    }
    let held = all.get(rule.code).map(String::as_str);
    assert_eq!(held, Some(told.as_str()), "{}: {}", rule.code, super::reference::HOW);
}

/// As [`compare`], of a finding.
pub fn compare_finding(rule: &Rule, own: &Finding) {
    compare(rule, [&own.what.es, &own.what.en], [&own.remedy.es, &own.remedy.en]);
}

#[test]
fn a_spanish_sentence_names_the_sheets_of_a_spanish_book() {
    let told = |what: &str| of_a_spanish_book([what.to_owned(), "rellene DATA!C42".to_owned()]);
    assert_eq!(told("W2 está vacío: DATA!C42"), ["W2 está vacío: DATOS!C42", "rellene DATOS!C42"]);
    assert_eq!(told("\"DATA (2)\", como \"DATA\", de MY_DATA")[0], "\"DATOS (2)\", como \"DATOS\", de MY_DATA");
    assert_eq!(told("no se sabe cuál: \"DATA\", \"DATOS\"")[0], "no se sabe cuál: \"DATA\", \"DATOS\"");
}

#[test]
fn every_row_with_fields_and_an_example_is_shown_with_figures_and_no_other() {
    if super::reference::write() {
        return;
    }
    let wanted = |rule: &&&Rule| carries(rule) && !matches!(rule.example, Example::Never(_));
    let rows = rows(KINDS);
    let wanted: BTreeSet<String> = rows.iter().filter(wanted).map(|rule| rule.code.to_owned()).collect();
    let held: BTreeSet<String> = held().into_keys().collect();
    let missing: Vec<_> = wanted.symmetric_difference(&held).collect();
    assert!(missing.is_empty(), "{missing:?}; {}", super::reference::HOW);
}
