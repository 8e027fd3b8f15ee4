//! Programs by chance through both interpreters.
//!
//! The seed is fixed, so that every run judges the same programs; `PROPTEST_RNG_SEED=N` takes another, and
//! `PROPTEST_CASES=N` more of them.

use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{RngSeed, TestRunner};

use super::agreement::begins;
use super::common::rs274::{self, Judge, Refused};
use super::{corpus, expressions, generator, ours, soup};

/// Where rodete refuses on purpose what rs274 takes: a part of the message, and why.
const STRICTER: [(&str, &str); 9] = [
    ("beyond ±99,999.999", "numbers beyond what any machine reaches are slips"),
    ("not a finite number", "infinity is no number, whatever is made of it afterwards"),
    ("G43.1 without axis words", "it changes nothing, so that the axis word has been forgotten"),
    ("motion under G93 with F0", "a move that takes for ever means nothing"),
    ("negative D", "a negative speed limit means nothing"),
    ("negative Q", "a negative tolerance means nothing"),
    ("of G10 is not a whole number", "half a tool means nothing"),
    ("G10 without L1", "L0 has a tool table read again that rodete reads once"),
    ("division by zero", "what is no number stays none, whatever is made of it afterwards"),
];

fn config() -> ProptestConfig {
    let asked = ProptestConfig::default();
    ProptestConfig {
        cases: if std::env::var_os("PROPTEST_CASES").is_some() { asked.cases } else { 200 },
        rng_seed: if asked.rng_seed == RngSeed::Random { RngSeed::Fixed(274) } else { asked.rng_seed },
        failure_persistence: None,
        ..asked
    }
}

fn stricter(fault: &ours::Fault) -> bool {
    STRICTER.iter().any(|(part, _)| fault.message.contains(part))
}

/// Both take it with the same motions and offsets, or both refuse the same block after the same motions.
fn compare(program: &str, judge: &Judge) -> Result<(), TestCaseError> {
    let (ours, var, fault) = ours::until_fault(program.as_bytes(), judge);
    let outcome = match (judge.run(program.as_bytes()), fault) {
        (Err(Refused::Deadline), _) => Err("rs274 does not end".to_owned()),
        (Ok(theirs), None) => corpus::same(&ours, &var, &theirs),
        (Err(Refused::Error(message, done)), Some(fault)) => {
            let block = program.lines().nth(fault.line - 1).unwrap_or_default();
            if message.lines().any(|line| line == block) || stricter(&fault) {
                begins(&ours, &done.motions).map(|_| ())
            } else {
                Err(format!("ours refuses {block:?}: {fault}\nrs274 another block: {message}"))
            }
        }
        (Ok(done), Some(fault)) if stricter(&fault) => begins(&ours, &done.motions).map(|_| ()),
        (Ok(_), Some(fault)) => Err(format!("refused by ours alone: {fault}")),
        (Err(Refused::Error(message, _)), None) => Err(format!("refused by rs274 alone: {message}")),
    };
    outcome.map_err(|fault| TestCaseError::fail(format!("{fault}\n{program}")))
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn programs_by_chance_move_as_in_linuxcnc(program in generator::programs(30)) {
        if rs274::is_here() {
            let tools = corpus::tools();
            compare(&program.text, &Judge { var: Some(&program.var), tools: Some(&tools), ..Judge::default() })?;
        }
    }

    #[test]
    fn blocks_by_chance_are_taken_or_refused_as_in_linuxcnc(program in soup::soups()) {
        if rs274::is_here() {
            let tools = corpus::tools();
            compare(&program, &Judge { tools: Some(&tools), ..Judge::default() })?;
        }
    }

    #[test]
    fn expressions_by_chance_come_to_the_same(program in expressions::programs()) {
        if rs274::is_here() {
            compare(&program, &Judge::default())?;
        }
    }
}

/// How many of a hundred programs rs274 takes.
fn taken<T>(programs: impl Strategy<Value = T>, run: impl Fn(&T) -> Result<rs274::Canon, Refused>) -> usize {
    let mut runner = TestRunner::new(config());
    (0..100).filter(|_| run(&programs.new_tree(&mut runner).unwrap().current()).is_ok()).count()
}

#[test]
fn most_programs_by_chance_are_good_and_blocks_by_chance_are_good_and_bad() {
    if !rs274::is_here() {
        return;
    }
    let tools = corpus::tools();
    let judge = Judge { tools: Some(&tools), ..Judge::default() };
    let programs = taken(generator::programs(30), |program| {
        Judge { var: Some(&program.var), ..judge }.run(program.text.as_bytes())
    });
    assert!(programs > 80, "{programs} of 100 programs");
    let soups = taken(soup::soups(), |program| judge.run(program.as_bytes()));
    assert!((10..60).contains(&soups), "{soups} of 100 soups");
    let expressions = taken(expressions::programs(), |program| judge.run(program.as_bytes()));
    assert!((20..90).contains(&expressions), "{expressions} of 100 expressions");
}
