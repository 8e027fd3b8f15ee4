//! Every row of what a turning program is told of is raised by its own example, and by nothing graver.

use std::collections::BTreeSet;

use rodete::cli::rows;
use rodete::finding::{Example, Grade, Rule};
use rodete::kinds::KINDS;
use rodete::kinds::lathe::rules::{MoreAlarms, NotJudgedFromHere};
use rodete::parameter::Value;

use super::bench::{Book, build};

fn rules() -> impl Iterator<Item = &'static Rule> {
    rows(KINDS).into_iter()
}

/// Code and grade of what a build says of an example of a row.
fn raised(of: &Rule, program: &str, machine: &[(&'static str, &'static str)]) -> Vec<(String, Grade)> {
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
    if let Some(own) = findings.iter().find(|one| one["code"] == of.code) {
        let text = |key: &str| ["es", "en"].map(|language| own[key][language].as_str().unwrap_or_default());
        crate::told::compare(of, text("what"), text("remedy"));
    }
    findings.iter().map(coded).collect()
}

#[test]
fn the_example_of_every_row_raises_it_and_nothing_graver() {
    let mut wrong = Vec::new();
    for rule in rules() {
        let found = match &rule.example {
            Example::Turning { program, machine, .. } => raised(rule, program, machine),
            Example::Made { key: "program-many-alarms", .. } => {
                let passes: String =
                    (0..60).map(|at| format!("G0 X{:.1} Z-10.|G0 X54.|", 40.0 - 0.3 * f64::from(at))).collect();
                raised(rule, &format!("G50 S2500|T0101|G97 S900 M3|M8|G0 X54. Z2.|{passes}G0 X100. Z50.|M30"), &[])
            }
            _ => continue,
        };
        let own = found.iter().any(|(code, grade)| code == rule.code && *grade <= rule.grade);
        let graver = found.iter().any(|(_, grade)| *grade > rule.grade);
        // These stand behind what went wrong.
        let behind = [NotJudgedFromHere::RULE, MoreAlarms::RULE].contains(&rule);
        if !own || graver && !behind {
            wrong.push(format!("{} {}: {found:?}", rule.code, rule.ident));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
