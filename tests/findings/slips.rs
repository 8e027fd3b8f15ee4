//! Every row of a verification is raised by its own example: a program that a workbook writes, judged with a text in it
//! replaced.

use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet};

use rayon::prelude::*;
use rodete::cli::rows;
use rodete::finding::{Example, Finding, Place, Rule};
use rodete::gcode::header::Origin;
use rodete::kinds::KINDS;
use rodete::kinds::pipe::hole;
use rodete::parameter::field::Fields;
use rodete::parameter::{Case, Value, Values};
use rodete::proof::Judged;
use rodete::proof::account::Account;
use rodete::proof::rules::{ChecksPassed, NotAsPlanned, NotClosed};
use rodete::proof::verification::Verification;
use rodete::text::{Language, Text, t};

/// What the slips of cautions break that is graver: the tip is too fast on the longer way, its points are others, the beam leaves
/// the root, the torch comes near the pipe.
const BREAKS: [(&str, &[&str]); 4] = [
    ("V0105", &["V0012", "V0106"]),
    ("V0123", &["V0012", "V0106"]),
    ("V0301", &["V0023", "V0302"]),
    ("V0303", &["V0023"]),
];

/// What makes a program of a test shorter.
const FEWER: Text = t("una arc_tolerance mayor", "a larger arc_tolerance");

/// The values of a kind's case, or of its usual one, some cells changed.
pub fn values(cases: &'static [Case], case: Option<&str>, cells: &[(&'static str, &'static str)]) -> Values {
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

/// What is told of the program of an example, and how many lines the text has; none of a design that is refused.
type Told = (Vec<Finding>, usize);

/// What is told of the program of an example, the first `from` in its text replaced.
fn told(words: &str, cells: &[(&'static str, &'static str)], key: &str, [from, to]: [&str; 2]) -> Told {
    let (name, case) = words.split_once(" --case ").map_or((words, None), |(kind, case)| (kind, Some(case)));
    let kind = KINDS.iter().find(|kind| kind.form().kind == name).expect(name);
    let fields = Fields::of(kind.form(), values(kind.cases(), case, cells)).unwrap();
    let lines = Cell::new(0);
    let edited = |text: &str| {
        assert!(text.contains(from), "{from} is not in\n{text}");
        let text = text.replacen(from, &to.replace('|', "\n"), 1);
        lines.set(text.lines().count());
        text
    };
    let found = kind.judged_text(&fields, key, &edited).unwrap_or_else(|| panic!("{name} judges no {key}"));
    (found, lines.get())
}

/// True where a finding says where it is: a line of the program, or what is to be changed.
fn is_placed(finding: &Finding, key: &str, lines: usize) -> bool {
    match &finding.place {
        Place::Block { program, line } => *program == key && (1..=lines).contains(line),
        Place::Parameters(keys) => !keys.is_empty(),
        // That a program passes is of the program as a whole.
        place => *place == Place::File && finding.is(ChecksPassed::RULE),
    }
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
        let Some(own_slip @ (.., key, from, _)) = slip(rule) else { continue };
        let (findings, lines) = &known[&own_slip];
        let own = findings.iter().find(|finding| finding.is(rule));
        // A slip is none of the plan's, whatever else it is: not as planned, what else it is the example of, and what it breaks.
        let breaks = BREAKS.iter().find(|(code, _)| *code == rule.code).map_or(&[][..], |(_, codes)| codes);
        let beside = |finding: &Finding| {
            let of_slip = [NotAsPlanned::RULE, NotClosed::RULE].contains(&finding.rule());
            let of_row = slip(finding.rule()) == Some(own_slip) || breaks.contains(&finding.code());
            !from.is_empty() && (of_slip || of_row)
        };
        let graver = findings.iter().any(|finding| finding.grade > rule.grade && !beside(finding));
        let whole = own.is_some_and(|own| {
            assert!(own.data.iter().map(|(name, _)| *name).eq(rule.fields.iter().copied()), "{}", rule.code);
            super::told::compare_finding(rule, own);
            let said = !own.what.en.contains(['{', '}']) && own.what.es != own.what.en;
            own.grade <= rule.grade && said && is_placed(own, key, *lines)
        });
        if !whole || graver {
            let said = findings
                .iter()
                .map(|one| format!("    {} {:?} {:?} {}", one.rule().code, one.grade, one.place, one.what.en));
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
