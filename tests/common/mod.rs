//! What the tests share: the published design and designs like it.
#![allow(dead_code, reason = "each test binary uses a part of it")]

pub mod agreement;
pub mod change;
pub mod rs274;
pub mod turned;
pub mod workbook;

use std::sync::{LazyLock, OnceLock};

use rodete::finding::Place;
use rodete::gcode::program::{Part, Program};
use rodete::kind::method::{self, Method};
use rodete::kind::{Kind, Outcome, Provenance, Wants};
use rodete::kinds;
use rodete::kinds::KINDS;
use rodete::kinds::impeller::blade::Blade;
use rodete::kinds::impeller::cases::CASES;
use rodete::kinds::impeller::design::Design;
use rodete::kinds::impeller::parameters::FORM;
use rodete::machine::axis::{Axis, Position};
use rodete::number::grid::Milli;
use rodete::parameter::field::Fields;
use rodete::parameter::{Case, Value, Values};
use rodete::proof::check::Check;
use rodete::text::Language;

/// Every case of every kind in every language.
pub fn cases() -> impl Iterator<Item = (&'static dyn Kind, &'static Case, Language)> {
    let cases = KINDS.iter().flat_map(|kind| kind.cases().iter().map(move |case| (*kind, case)));
    cases.flat_map(|(kind, case)| Language::ALL.map(|language| (kind, case, language)))
}

/// Every case in one language and the next in the other, each kind in both: for what differs in words and names alone, where a
/// judge from outside takes its time over each book.
pub fn alternating(first: Language) -> impl Iterator<Item = (&'static dyn Kind, &'static Case, Language)> {
    let from = Language::ALL.iter().position(|one| *one == first).expect("a language");
    let languages = Language::ALL.into_iter().cycle().skip(from);
    KINDS.iter().flat_map(move |kind| {
        let cases = kind.cases().iter().cycle().take(kind.cases().len().max(Language::ALL.len()));
        cases.zip(languages.clone()).map(move |(case, language)| (*kind, case, language))
    })
}

/// The outcome of a case as it is shipped, computed once for all tests of a binary.
pub fn shipped(kind: &dyn Kind, case: &'static Case, language: Language) -> &'static Outcome {
    static MADE: LazyLock<Vec<OnceLock<Outcome>>> = LazyLock::new(|| cases().map(|_| OnceLock::new()).collect());
    let at = cases().position(|(_, one, of)| std::ptr::eq(one, case) && of == language).expect("a shipped case");
    MADE[at].get_or_init(|| outcome_of(kind, case, language, &[]))
}

/// The outcome of a case of any kind, some of its values replaced.
pub fn outcome_of(kind: &dyn Kind, case: &Case, language: Language, changes: &[(&'static str, Value)]) -> Outcome {
    let mut values = Values::of(case, language);
    values.values.extend(changes.iter().cloned());
    kinds::run(kind.form(), values, source()).unwrap_or_else(|refusal| panic!("{}: {refusal:?}", case.name))
}

/// The values of a shipped case of the impeller, some of them replaced.
pub fn values(case: &str, changes: &[(&'static str, Value)]) -> Values {
    let case = CASES.iter().find(|one| one.name == case).expect("a shipped case");
    let mut values = Values { language: Language::En, ..Values::default() };
    values.values.extend(case.values(Language::En));
    values.values.extend(changes.iter().cloned());
    values
}

/// A real number of a filled-in form.
#[allow(dead_code, reason = "not every test reads forms")]
pub fn real(values: &Values, key: &str) -> Option<f64> {
    if let Value::Real(value) = values.values.get(key)? { Some(*value) } else { None }
}

/// A whole number of a filled-in form.
#[allow(dead_code, reason = "not every test reads forms")]
pub fn whole(values: &Values, key: &str) -> Option<u32> {
    if let Value::Whole(value) = values.values.get(key)? { Some(*value) } else { None }
}

/// The values of a shipped case, some of them replaced, proved.
#[allow(dead_code, reason = "not every test builds designs")]
pub fn fields(case: &str, changes: &[(&'static str, Value)]) -> Fields {
    Fields::of(&FORM, values(case, changes)).expect("all that the form requires")
}

/// Changes to the case `full` that write positions instead of increments, for a machine whose rotary axes are linear, and
/// hold no code of a machine's builder and no place of a machine; then some more.
pub fn absolute(changes: &[(&'static str, Value)]) -> Vec<(&'static str, Value)> {
    let mut all = vec![
        ("distance", Value::Choice("G90")),
        ("rotary", Value::Choice("linear")),
        ("retract", Value::Line(String::new())),
        ("start_codes", Value::Line("M3".to_owned())),
    ];
    all.extend_from_slice(changes);
    all
}

pub fn source() -> Provenance {
    Provenance { workbook: "impeller.xlsx".to_owned(), sha256: "0123456789abcdef".repeat(4), version: "0.0.0" }
}

/// The outcome of a shipped case, some of its values replaced.
pub fn outcome(case: &str, changes: &[(&'static str, Value)]) -> Outcome {
    match kinds::run(&FORM, values(case, changes), source()) {
        Ok(outcome) => outcome,
        Err(refusal) => panic!("refused: {:?}", refusal.findings),
    }
}

/// The text of a program of an outcome.
pub fn program(outcome: &Outcome, key: &str) -> String {
    outcome.programs.iter().find(|program| program.key == key).expect("the program").text()
}

/// A program with other lines in the place of its own.
pub fn with_text(program: &Program, text: &str) -> Program {
    Program { parts: text.lines().map(|line| Part::Line(line.to_owned())).collect(), ..program.clone() }
}

/// The checks on a program with other lines in the place of its own.
pub fn checks<M: Method>(design: &M::Design, model: &M::Model, program: &Program, text: &str) -> Vec<Check> {
    let mut memo = M::memo(design, model, Wants::default());
    method::judged::<M>(design, model, &mut memo, program, &with_text(program, text)).checks
}

/// The parameters of a place, by their keys.
pub fn parameters(place: &Place) -> Vec<&'static str> {
    match place {
        Place::Parameters(keys) => keys.iter().map(|key| key.name()).collect(),
        place => panic!("{place:?}"),
    }
}

/// The blade of a design.
pub fn blade(design: &Design) -> Blade {
    Blade::new(design.torus, design.n, design.eps_v, design.machine)
}

/// The positions that a program's text goes through, read word by word on the output grid: a second opinion on the
/// text, independent of what wrote it.
pub fn read_back(text: &str, start: Position) -> Vec<Position> {
    let mut at = start;
    let mut absolute = true;
    let mut positions = Vec::new();
    for line in text.lines().filter(|line| !line.starts_with([';', '(', '%'])) {
        let mut moves = false;
        for word in line.split_whitespace() {
            let (letter, number) = word.split_at(1);
            match (letter, number) {
                ("G", "90") => absolute = true,
                ("G", "91") => absolute = false,
                _ => {}
            }
            let Some(axis) = Axis::ALL.into_iter().find(|axis| letter.starts_with(axis.letter())) else { continue };
            let size = Milli::round(number.parse().expect("a number")).expect("on the grid");
            at = if absolute { at.with(axis, size) } else { at.moved(axis, size) };
            moves = true;
        }
        if moves {
            positions.push(at);
        }
    }
    positions
}
