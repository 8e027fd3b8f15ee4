//! Every row of every room is raised by its own example, and by nothing graver.

#![allow(clippy::unwrap_used, missing_docs)]

use std::collections::BTreeSet;

use rodete::cli::RULES;
use rodete::finding::{Datum, Example, Finding, Grade, Rule};
use rodete::gcode::control::Control;
use rodete::gcode::interpreter::{Interpreter, Setting};
use rodete::parameter::Value;
use rodete::text::Text;

use super::lathe_inputs::bench::{Book, build};

fn rules() -> impl Iterator<Item = &'static Rule> {
    RULES.into_iter().flatten().copied()
}

/// Code and grade of what a build says of an example.
fn turned(program: &str, machine: &[(&'static str, &'static str)]) -> Vec<(String, Grade)> {
    let lines: Vec<String> = program.split('|').map(str::to_owned).collect();
    let book = machine.iter().fold(Book::new(&lines), |book, &(symbol, value)| {
        book.put(symbol, value.parse().map_or(Value::Choice(value), Value::Real))
    });
    let (_folder, document, _) = build(&book.bytes());
    let findings = document["findings"].as_array().unwrap();
    let grade = |text: &str| match text {
        "stop" => Grade::Stop,
        "caution" => Grade::Caution,
        _ => Grade::Note,
    };
    let coded = |one: &serde_json::Value| {
        let code = one["code"].as_str().unwrap_or_default().to_owned();
        if !code.is_empty() {
            let carried: BTreeSet<_> = one["data"].as_object().unwrap().keys().cloned().collect();
            let rule = rules().find(|rule| rule.code == code).unwrap();
            assert!(rule.fields.iter().all(|field| carried.contains(*field)), "{one}");
            assert_eq!(one["name"], rule.name(), "{one}");
        }
        (code, grade(one["grade"].as_str().unwrap()))
    };
    findings.iter().map(coded).collect()
}

/// What reading a program under a control says.
fn read(control: &str, program: &str) -> Vec<Finding> {
    let program = program.replace('|', "\n");
    let mut interpreter = Interpreter::over(program.as_bytes(), Setting::new(Control::named(control).unwrap()));
    let mut findings: Vec<Finding> =
        interpreter.by_ref().filter_map(Result::err).map(|fault| (*fault).into()).collect();
    findings.extend(interpreter.remarks());
    findings
}

/// Code and grade of a finding, which is told in both languages and carries what its row says.
fn coded(finding: &Finding) -> (String, Grade) {
    let Text { es, en } = &finding.what;
    assert!(!es.is_empty() && !en.is_empty() && es != en, "{finding:?}");
    if let Some(rule) = finding.rule {
        let carried: Vec<&str> = finding.data.iter().map(|(name, _)| *name).collect();
        assert_eq!(carried, rule.fields, "{finding:?}");
        assert_eq!(finding.remedy.is_empty(), rule.remedy.is_empty(), "{finding:?}");
    }
    (finding.rule.map(|rule| rule.code.to_owned()).unwrap_or_default(), finding.grade)
}

/// Code and grade of what an example raises; none where no input raises its row.
fn raised(example: &Example) -> Option<Vec<(String, Grade)>> {
    match example {
        Example::Turning { program, machine, .. } => Some(turned(program, machine)),
        Example::Program { control, program } => Some(read(control, program).iter().map(coded).collect()),
        Example::Never(_) => None,
    }
}

#[test]
fn the_example_of_every_row_raises_it_and_nothing_graver() {
    let mut wrong = Vec::new();
    for rule in rules() {
        let Some(found) = raised(&rule.example) else { continue };
        let own = found.iter().any(|(code, grade)| code == rule.code && *grade <= rule.grade);
        let graver = found.iter().any(|(_, grade)| *grade > rule.grade);
        if !own || graver {
            wrong.push(format!("{} {}: {found:?}", rule.code, rule.ident));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_refusal_carries_its_row_and_the_alarm_of_a_control_that_has_one() {
    let found = read("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G1 X20. K-1. R-1.|M30");
    let twice = found.iter().find(|one| one.rule.is_some_and(|rule| rule.code == "G0604")).unwrap();
    assert!(twice.is(rodete::gcode::turning::rules::CornerTwice::RULE));
    assert_eq!(twice.alarm.map(|(family, number)| family.shown(number)).as_deref(), Some("PS0053"));
    assert_eq!(twice.what.en, "PS0053: 'K' and 'R' in one block");
    let word = |text: &str| Datum::Word(text.to_owned());
    assert_eq!(twice.data, [("first", word("K")), ("second", word("R"))]);
}

#[test]
fn codes_are_one_rows_alone_and_their_texts_whole() {
    let mut codes = BTreeSet::new();
    for rule in rules() {
        assert!(codes.insert(rule.code), "{} is given twice", rule.code);
        let (letter, digits) = rule.code.split_at(1);
        assert!(letter.chars().all(|one| one.is_ascii_uppercase()) && digits.len() == 4, "{}", rule.code);
        assert!(digits.chars().all(|one| one.is_ascii_digit()), "{}", rule.code);
        for text in [&rule.what, &rule.why] {
            assert!(!text.es.is_empty() && !text.en.is_empty() && text.es != text.en, "{}", rule.code);
        }
    }
    let never: Vec<_> =
        rules().filter(|rule| matches!(rule.example, Example::Never(_))).map(|rule| rule.code).collect();
    assert_eq!(never, ["L0141"], "what no input raises is counted");
}
