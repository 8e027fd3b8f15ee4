//! What designs are compared by: every derived value of every case, each with its unit.

use rodete::kind::measure::{Known, Level};
use rodete::parameter::Values;
use rodete::parameter::field::Fields;

use crate::common;

#[test]
fn every_derived_value_of_every_case_is_a_measure_with_its_unit() {
    for (kind, case, language) in common::cases() {
        let outcome = common::outcome_of(kind, case, language, &[]);
        for one in &outcome.quantities {
            let measure = kind.measures().iter().find(|measure| measure.key == one.symbol);
            assert_eq!(measure.map(|measure| measure.unit), Some(one.unit), "{} {}", case.name, one.symbol);
        }
        let known = Known::of(&outcome);
        for measure in kind.measures().iter().filter(|one| !one.meaning.is_empty()) {
            // A part that is cut as published has no floor to be under, one that is cut clear no path between blocks; a program
            // without feed has no time.
            let untimed = outcome.programs.iter().any(|one| one.time().1.is_none());
            let absent = match measure.key {
                "under_floor_mm" => true,
                "deviation_mm" => case.name == "clear",
                "time_s" => untimed,
                _ => false,
            };
            assert!(absent || measure.of(&known).is_some() || outcome.stopped(), "{} {}", case.name, measure.key);
        }
    }
}

#[test]
fn what_is_known_before_programs_are_read_back_is_what_is_known_after() {
    for (kind, case, language) in common::cases() {
        let outcome = common::outcome_of(kind, case, language, &[]);
        let fields = Fields::of(kind.form(), Values::of(case, language)).unwrap();
        let limits = kind.limits(&fields).unwrap();
        let before = Known { quantities: &limits.quantities, ..Known::default() };
        let after = Known::of(&outcome);
        for measure in kind.measures().iter().filter(|one| one.level == Level::Limits) {
            let [before, after] = [&before, &after].map(|known| measure.of(known).map(f64::to_bits));
            assert_eq!(before, after, "{} {}", case.name, measure.key);
        }
    }
}
