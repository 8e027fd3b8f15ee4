//! Every row of a verification is raised by its own example: a program that a workbook writes, judged with a text in it
//! replaced.

use std::collections::{BTreeMap, BTreeSet};

use rayon::prelude::*;
use rodete::cli::rows;
use rodete::finding::{Example, Finding, Rule};
use rodete::gcode::header::Origin;
use rodete::kinds::KINDS;
use rodete::kinds::pipe::hole;
use rodete::parameter::field::Fields;
use rodete::parameter::{Case, Value, Values};
use rodete::proof::Judged;
use rodete::proof::account::Account;
use rodete::proof::verification::Verification;
use rodete::text::{Language, Text, t};

/// What makes a program of a test shorter.
const FEWER: Text = t("una arc_tolerance mayor", "a larger arc_tolerance");

/// The values of a kind's case, or of its usual one, some cells changed.
fn values(cases: &'static [Case], case: Option<&str>, cells: &[(&'static str, &'static str)]) -> Values {
    let mut values = Values { language: Language::En, ..Values::default() };
    let case = cases.iter().find(|one| case.is_none_or(|case| one.name == case)).expect("a case of the kind");
    values.values.extend(case.values(Language::En));
    for (symbol, text) in cells {
        let value = match values.values.get(symbol) {
            _ if text.is_empty() => None,
            Some(Value::Whole(_)) => Some(Value::Whole(text.parse().unwrap())),
            Some(Value::Line(_)) => Some(Value::Line((*text).to_owned())),
            _ => Some(text.parse().map_or(Value::Choice(text), Value::Real)),
        };
        match value {
            Some(value) => drop(values.values.insert(symbol, value)),
            None => drop(values.values.remove(symbol)),
        }
    }
    values
}

/// What is told of the program of an example, the first `from` in its text replaced.
fn told(words: &str, cells: &[(&'static str, &'static str)], key: &str, [from, to]: [&str; 2]) -> Vec<Finding> {
    let (name, case) = words.split_once(" --case ").map_or((words, None), |(kind, case)| (kind, Some(case)));
    let kind = KINDS.iter().find(|kind| kind.form().kind == name).expect(name);
    let fields = Fields::of(kind.form(), values(kind.cases(), case, cells)).unwrap();
    let edited = |text: &str| {
        assert!(text.contains(from), "{from} is not in\n{text}");
        text.replacen(from, &to.replace('|', "\n"), 1)
    };
    kind.judged_text(&fields, key, &edited).unwrap_or_else(|| panic!("{name} judges no {key}"))
}

#[test]
fn the_slip_of_every_row_raises_it() {
    let slip = |rule: &Rule| match rule.example {
        Example::Slip { kind, cells, program, from, to } => Some((kind, cells, program, from, to)),
        _ => None,
    };
    let rules = rows(KINDS);
    let slips: BTreeSet<_> = rules.iter().filter_map(|rule| slip(rule)).collect();
    let known = slips
        .into_par_iter()
        .map(|slip @ (kind, cells, program, from, to)| (slip, told(kind, cells, program, [from, to])));
    let known: BTreeMap<_, _> = known.collect();
    let mut wrong = Vec::new();
    for rule in rules {
        let Some(slip @ (.., from, _)) = slip(rule) else { continue };
        let findings = &known[&slip];
        let own = findings.iter().find(|finding| finding.is(rule));
        // A slip is none of the plan's, whatever else it is.
        let graver = from.is_empty() && findings.iter().any(|finding| finding.grade > rule.grade);
        let whole = own.is_some_and(|own| {
            assert!(own.data.iter().map(|(name, _)| *name).eq(rule.fields.iter().copied()), "{}", rule.code);
            super::told::compare_finding(rule, own);
            own.grade <= rule.grade && !own.what.en.contains(['{', '}']) && own.what.es != own.what.en
        });
        if !whole || graver {
            let said = findings.iter().map(|one| format!("    {} {:?} {}", one.rule().code, one.grade, one.what.en));
            wrong.push(format!("{} {}:\n{}", rule.code, rule.ident, said.collect::<Vec<_>>().join("\n")));
        }
    }
    assert!(wrong.is_empty(), "{} rows\n{}", wrong.len(), wrong.join("\n"));
}

/// What is told of a program that takes more than the control's memory.
pub fn beyond_memory() -> Vec<Finding> {
    let design = hole::design::Design::new(
        &Fields::of(&hole::parameters::FORM, values(&hole::cases::CASES, None, &[])).unwrap(),
    )
    .unwrap();
    let cut = hole::cut::cut(&design).unwrap();
    let origin = Origin { workbook: "W.XLSX", sha256: "0", version: "0.0.0", language: Language::En };
    let program = hole::program::full(&design, &cut, &origin).unwrap();
    let bytes = program.control.text.memory + 1;
    let mut verification = Verification::default();
    verification.add(&program, Judged { checks: Vec::new(), account: Account::default(), bytes }, FEWER);
    verification.findings
}
