//! What the plan of an impeller leaves or spoils is told.

mod common;

use rodete::finding::{Finding, Grade};
use rodete::job::Outcome;
use rodete::parameter::Value;

type Changes = Vec<(&'static str, Value)>;

/// The three check designs: the shipped one, a deep one with two blades, a larger one with five; none with splitters.
fn designs() -> [Changes; 3] {
    let design = |R: f64, r: f64, N: u32, e: f64, a_p: f64| {
        vec![
            ("R", Value::Real(R)),
            ("r", Value::Real(r)),
            ("N", Value::Whole(N)),
            ("e", Value::Real(e)),
            ("a_p", Value::Real(a_p)),
            ("d_t", Value::Real(6.0)),
            ("splitters", Value::Choice("no")),
            ("L_b", Value::Real(2.0 * r)),
            ("X_e", Value::Real(3.0 * R)),
        ]
    };
    [design(25.0, 15.0, 4, 2.0, 2.0), design(25.0, 17.0, 2, 1.0, 4.0), design(50.0, 30.0, 5, 2.0, 3.0)]
}

fn quantity(outcome: &Outcome, symbol: &str) -> Option<f64> {
    outcome.quantities.iter().find(|one| one.symbol == symbol).map(|one| one.value)
}

fn caution<'a>(outcome: &'a Outcome, words: &str) -> Option<&'a Finding> {
    let found = outcome.findings.iter().find(|finding| finding.what.en.contains(words));
    if let Some(found) = found {
        assert_eq!(found.grade, Grade::Caution);
        assert!(!found.remedy.en.is_empty() && !found.remedy.es.is_empty() && !found.what.es.is_empty());
    }
    found
}

#[test]
fn the_true_gap_and_its_limits_stand_beside_the_published_ones() {
    let checks = [(6.900_679, 3.0, 0.836), (10.043_482, 2.0, 3.232), (12.418_203, 7.0, 6.465)];
    for (design, (gap, N_max, e_max)) in designs().into_iter().zip(checks) {
        let outcome = common::outcome("tfg-2021", &design);
        let value = |symbol| quantity(&outcome, symbol).unwrap_or_else(|| panic!("{symbol} {design:?}"));
        assert!((value("gap_true") - gap).abs() < 0.0015, "{}", value("gap_true"));
        assert_eq!(value("N_max_true"), N_max);
        assert!((value("e_max_true") - e_max).abs() < 0.0015, "{}", value("e_max_true"));
        assert!(value("N_max") >= N_max && value("e_max") > e_max, "the published ones stay");
    }
}

#[test]
fn blades_nearer_than_the_published_limits_say_are_a_caution_with_the_true_ones() {
    let [shipped, deep, large] = designs();
    let outcome = common::outcome("tfg-2021", &shipped);
    let found = caution(&outcome, "passes between the blades").unwrap();
    assert!(found.what.en.contains("true N_max = 3 (published: 5)"), "{}", found.what.en);
    assert!(found.what.en.contains("true e_max = 0.836 mm for 4 blades"), "{}", found.what.en);
    assert_eq!((found.value.as_str(), found.limit.as_str()), ("6.9 mm", "8 mm"));
    assert!(!outcome.programs.is_empty(), "it is told, not refused");
    for kept in [deep, large] {
        assert!(caution(&common::outcome("tfg-2021", &kept), "passes between the blades").is_none());
    }
}

#[test]
fn a_limit_that_does_not_exist_is_said_to_be_none() {
    let mut design = designs()[0].clone();
    design.extend([("e", Value::Real(1.0)), ("N", Value::Whole(5))]);
    let outcome = common::outcome("tfg-2021", &design);
    assert_eq!(quantity(&outcome, "e_max_true"), None);
    let found = caution(&outcome, "between the blades").unwrap();
    assert!(
        found.what.en.contains("true e_max: none, 5 blades leave no room however thin they are"),
        "{}",
        found.what.en
    );
    assert!(found.what.es.contains("e_max real: ninguno"), "{}", found.what.es);
}
