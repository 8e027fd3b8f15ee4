//! Every row of what a turning program is told of is raised by its own example, and by nothing graver.

use std::collections::BTreeSet;

use rodete::cli::rows;
use rodete::finding::{Example, Grade, Rule};
use rodete::kinds::KINDS;
use rodete::parameter::Value;

use super::bench::{Book, build};

fn rules() -> impl Iterator<Item = &'static Rule> {
    rows(KINDS).into_iter()
}

/// Code and grade of what a build says of an example.
fn raised(program: &str, machine: &[(&'static str, &'static str)]) -> Vec<(String, Grade)> {
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

#[test]
fn the_example_of_every_row_raises_it_and_nothing_graver() {
    let mut wrong = Vec::new();
    for rule in rules() {
        let Example::Turning { program, machine, .. } = &rule.example else { continue };
        let found = raised(program, machine);
        let own = found.iter().any(|(code, grade)| code == rule.code && *grade <= rule.grade);
        let graver = found.iter().any(|(_, grade)| *grade > rule.grade);
        if !own || graver {
            wrong.push(format!("{} {}: {found:?}", rule.code, rule.ident));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
