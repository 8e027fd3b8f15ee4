//! Every row of a verification is raised by its own example: a program that a workbook writes, judged with a text in it
//! replaced.

use std::collections::{BTreeMap, BTreeSet};

use rayon::prelude::*;
use rodete::cli::rows;
use rodete::finding::{Example, Finding, Rule};
use rodete::gcode::header::Origin;
use rodete::gcode::program::{Part, Program};
use rodete::kind::Wants;
use rodete::kinds::impeller::clear::{self, cut::Job};
use rodete::kinds::impeller::proof::cutting::Known;
use rodete::kinds::impeller::proof::{Geometry, due, judges, setting};
use rodete::kinds::impeller::splitter::Splitter;
use rodete::kinds::impeller::tables::ToolPaths;
use rodete::kinds::pipe::{hole, insert};
use rodete::kinds::{KINDS, impeller};
use rodete::machine::rapids::Rapids;
use rodete::parameter::field::Fields;
use rodete::parameter::{Case, Value, Values};
use rodete::proof::account::Account;
use rodete::proof::step::Plan;
use rodete::proof::verification::Verification;
use rodete::proof::{self, Judged};
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

/// A program whose lines are those of its own text, one of them changed.
fn slipped(program: &Program, from: &str, to: &str) -> Program {
    let text = program.text();
    assert!(text.contains(from), "{from} is not in\n{text}");
    let parts =
        text.replacen(from, &to.replace('|', "\n"), 1).lines().map(|line| Part::Line(line.to_owned())).collect();
    Program { parts, ..program.clone() }
}

/// What is told of the program of an example.
fn told(words: &str, cells: &[(&'static str, &'static str)], key: &str, [from, to]: [&str; 2]) -> Vec<Finding> {
    let (kind, case) = words.split_once(" --case ").map_or((words, None), |(kind, case)| (kind, Some(case)));
    let origin = Origin { workbook: "W.XLSX", sha256: "0", version: "0.0.0", language: Language::En };
    let mut verification = Verification::default();
    match kind {
        "impeller" => {
            let design = match impeller::design::Design::new(
                &Fields::of(&impeller::parameters::FORM, values(&impeller::cases::CASES, case, cells)).unwrap(),
            ) {
                Ok(design) => design,
                Err(refused) => return refused,
            };
            let blade = crate::common::blade(&design);
            let plan =
                design.clear.as_ref().map(|asked| clear::plan::Plan::new(&Job::of(&design), &asked.cut).unwrap());
            let splitter = (design.splitters && plan.is_none()).then(|| Splitter::new(&design, &blade).unwrap());
            let tracks =
                impeller::programs::Tracks::new(&blade, &ToolPaths::new(&design, &blade), splitter.as_ref()).unwrap();
            let made = match &plan {
                Some(plan) => clear::programs::programs(&design, plan, &origin).unwrap(),
                None => impeller::programs::programs(&design, &tracks, &origin).unwrap(),
            };
            let program = made.programs.iter().find(|program| program.key == key).unwrap();
            let geometry =
                Geometry { design: &design, blade: &blade, splitter: splitter.as_ref(), clear: plan.as_ref() };
            let mut known = Known::new(geometry, Wants::default());
            let text = slipped(program, from, to);
            let judges = judges(geometry, &mut known, program);
            let judged = proof::of(
                &text,
                setting(&design, program),
                Plan::of(program),
                judges,
                due(&design, program),
                Rapids::default(),
            );
            verification.add(&text, judged, FEWER);
        }
        "pipe-insert" => {
            let design = insert::design::Design::new(
                &Fields::of(&insert::parameters::FORM, values(&insert::cases::CASES, case, cells)).unwrap(),
            )
            .unwrap();
            let cut = insert::cut::cut(&design).unwrap();
            let program = insert::program::full(&design, &cut, &origin).unwrap();
            let (text, mut curve) = (slipped(&program, from, to), Vec::new());
            let moves = insert::proof::Moves::new(&design, Some(&cut));
            let judges = insert::proof::judges(&design, &moves, &mut curve);
            let setting = insert::proof::setting(&design, &program);
            let due = insert::proof::due(&design);
            verification.add(
                &text,
                proof::of(&text, setting, moves.plan(design.mode), judges, due, Rapids::default()),
                FEWER,
            );
        }
        "pipe-hole" => {
            let design = hole::design::Design::new(
                &Fields::of(&hole::parameters::FORM, values(&hole::cases::CASES, case, cells)).unwrap(),
            )
            .unwrap();
            let cut = hole::cut::cut(&design).unwrap().unwrap();
            let program = hole::program::full(&design, &cut, &origin).unwrap();
            let (text, mut curve) = (slipped(&program, from, to), Vec::new());
            let judges = hole::proof::judges(&design, &cut, &mut curve);
            let plan = hole::proof::plan(&design, &cut);
            verification.add(
                &text,
                proof::of(&text, program.setting(), plan, judges, hole::proof::CHECKS, Rapids::default()),
                FEWER,
            );
        }
        _ => panic!("{kind} is not judged"),
    }
    verification.findings
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
    let cut = hole::cut::cut(&design).unwrap().unwrap();
    let origin = Origin { workbook: "W.XLSX", sha256: "0", version: "0.0.0", language: Language::En };
    let program = hole::program::full(&design, &cut, &origin).unwrap();
    let bytes = program.control.text.memory + 1;
    let mut verification = Verification::default();
    verification.add(&program, Judged { checks: Vec::new(), account: Account::default(), bytes }, FEWER);
    verification.findings
}
