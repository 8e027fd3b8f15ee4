//! What designs are compared by: every derived value of every case, each with its unit.

use std::collections::BTreeSet;

use rodete::kind::measure::{Level, MeasuredOutcome};
use rodete::kinds::KINDS;
use rodete::parameter::field::Fields;
use rodete::parameter::{Value, Values};
use rodete::sweep::asked;
use rodete::sweep::plan::{Method, Plan};
use rodete::sweep::row::{Row, State, judged};
use rodete::text::Language;
use rodete::workbook::sweep_sheet;

use crate::common;
use crate::common::workbook::with_variants;

/// The most letters of a name beside the upright axis of a chart: that of the report is 52 mm long, and a letter 1.6 mm wide.
const NAME: usize = 28;

#[test]
fn a_chart_calls_a_measure_in_words_that_fit_beside_its_axis() {
    for measure in KINDS.iter().flat_map(|kind| kind.measures()) {
        let name = measure.name();
        for language in Language::ALL {
            let name = name.get(language);
            assert!(name.chars().count() <= NAME, "{name}");
            assert_eq!(name == measure.key, measure.meaning.is_empty(), "{name}");
        }
    }
}

#[test]
fn every_derived_value_of_every_case_is_a_measure_with_its_unit() {
    for (kind, case, language) in common::cases() {
        let outcome = common::outcome_of(kind, case, language, &[]);
        for one in &outcome.quantities {
            let measure = kind.measures().iter().find(|measure| measure.key == one.symbol);
            assert_eq!(measure.map(|measure| measure.unit), Some(one.unit), "{} {}", case.name, one.symbol);
        }
        let known = MeasuredOutcome::of(&outcome);
        for measure in kind.measures().iter().filter(|one| !one.meaning.is_empty()) {
            // A part that is cut as published has no floor to be under, one that is cut clear no path between blocks; a program
            // without feed has no time.
            let untimed = outcome.programs.iter().any(|one| one.time().1.is_none());
            let absent = match measure.key {
                "under_floor_mm" => case.name != "clear",
                "deviation_mm" => case.name == "clear",
                "time_s" => untimed,
                _ => false,
            };
            assert!(outcome.stopped() || measure.of(&known).is_none() == absent, "{} {}", case.name, measure.key);
        }
    }
}

#[test]
fn what_is_known_before_programs_are_read_back_is_what_is_known_after() {
    let mut met = BTreeSet::new();
    for (kind, case, language) in common::cases() {
        let outcome = common::outcome_of(kind, case, language, &[]);
        let fields = Fields::of(kind.form(), Values::of(case, language)).unwrap();
        let limits = kind.limits(&fields).unwrap();
        let before = MeasuredOutcome { quantities: &limits.quantities, ..MeasuredOutcome::default() };
        let after = MeasuredOutcome::of(&outcome);
        for measure in kind.measures().iter().filter(|one| one.level == Level::Limits) {
            let [before, after] = [&before, &after].map(|known| measure.of(known).map(f64::to_bits));
            assert_eq!(before, after, "{} {}", case.name, measure.key);
            // A design without a splitter, or without a bevel, has none of it, neither before nor after.
            let derived = outcome.quantities.iter().any(|one| one.symbol == measure.key);
            assert_eq!(before.is_some(), derived, "{} {}", case.name, measure.key);
            before.map(|_| met.insert((kind.form().kind, measure.key)));
        }
    }
    // And each of them is known of some case.
    let every = KINDS.iter().flat_map(|kind| kind.measures().iter().map(|one| (kind.form().kind, one)));
    let every: BTreeSet<_> =
        every.filter(|(_, one)| one.level == Level::Limits).map(|(kind, one)| (kind, one.key)).collect();
    assert_eq!(met, every);
}

/// A case with values of its own, as a design of a sweep with an objective.
fn design(case: &str, changes: &[(&'static str, Value)], objective: &str) -> Row {
    let kind = KINDS[0];
    let settings = [("method", "factorial"), ("level", "program"), ("objectives", objective)];
    let bytes = with_variants(&settings, &[["e", "", "", "", "2", ""]], &[]);
    let sheet = sweep_sheet::read(&bytes, kind.form(), Language::En).unwrap().unwrap();
    let plan = asked::plan(kind, &sheet.fields, sheet.designs).unwrap().0;
    let base = common::values(case, changes);
    let inputs = vec![base.values["e"].clone()];
    judged(kind, &base, &plan, 0, inputs)
}

#[test]
fn a_clear_design_that_is_refused_tells_by_how_much_it_misses_the_limit() {
    let real = |key, value| (key, Value::Real(value));
    let no = ("splitters", Value::Choice("no"));
    for (code, changes, value, limit) in [
        ("P1204", vec![real("tol", 0.002)], Some(0.002), None),
        ("P1205", vec![real("d_t", 3.0), real("d_f", 6.0)], Some(6.0), Some(3.0)),
        ("P1206", vec![("N", Value::Whole(6))], Some(6.0), None),
        ("P1207", vec![real("s_w", 3.0)], Some(3.0), Some(2.0)),
        ("P1224", vec![no, real("l_t", 8.0)], Some(8.0), None),
        ("P1215", vec![real("tol", 0.0045), real("delta", 0.005)], None, Some(100_000.0)),
        ("P1217", vec![real("r_c", 4.0)], Some(4.0), Some(3.0)),
        ("P1223", vec![("program", Value::Whole(9999))], Some(9999.0), Some(9998.0)),
    ] {
        let row = design("clear", &changes, "time_s min");
        assert_eq!((row.state, row.reason.as_deref()), (State::Refused, Some(code)), "{row:?}");
        let (Some(found), Some(with), Some(margin)) = (row.value, row.limit, row.margin) else { panic!("{row:?}") };
        assert!(value.is_none_or(|value| value == found) && limit.is_none_or(|limit| limit == with), "{row:?}");
        assert!(margin < 0.0 && (margin + (found - with).abs()).abs() < 1e-12, "{row:?}");
    }
}

/// A finding that tells two bounds has its limit, and its margin, as any other; and so has one whose two numbers are inputs.
#[test]
fn a_refused_design_tells_value_limit_and_margin_of_cuts_and_of_torches() {
    let row = design("full", &[("splitters", Value::Choice("no")), ("e", Value::Real(4.0))], "time_s min");
    assert_eq!((row.reason.as_deref(), row.limit), (Some("V0107"), Some(0.0)), "{row:?}");
    assert!(row.value.is_some_and(|value| value < 0.0) && row.margin == row.value, "{row:?}");
    let kind = *KINDS.iter().find(|kind| kind.form().kind == "pipe-hole").unwrap();
    let real = |key, value| (key, Value::Real(value));
    for (code, changes, found) in [
        ("P3001", vec![real("h", 90.0)], [Some(90.0), None]),
        ("P3003", vec![real("g0", 50.0), real("D_max", 500.0)], [Some(50.0), Some(4.0)]),
        ("P3004", vec![real("r_g", 100.0), real("R_g", 90.0)], [Some(90.0), Some(100.0)]),
        ("P3005", vec![real("D_max", 3.0)], [Some(3.0), Some(4.0)]),
        ("P3006", vec![real("kerf", 1.0)], [Some(1.0), None]),
    ] {
        let mut base = Values::default();
        base.values.extend(kind.cases()[0].values(Language::En));
        base.values.extend(changes);
        let plan = Plan::new(kind.form(), Vec::new(), Method::List, (1, 1), Level::Limits, (Vec::new(), Vec::new()));
        let row = judged(kind, &base, &plan, 0, Vec::new());
        assert_eq!((row.state, row.reason.as_deref()), (State::Refused, Some(code)), "{row:?}");
        let (Some(value), Some(limit), Some(margin)) = (row.value, row.limit, row.margin) else { panic!("{row:?}") };
        for (told, wanted) in [value, limit].into_iter().zip(found) {
            assert!(wanted.is_none_or(|wanted| wanted == told), "{row:?}");
        }
        assert!(margin < 0.0 && (margin + (value - limit).abs()).abs() < 1e-12, "{row:?}");
    }
}

#[test]
fn a_design_without_a_value_of_an_objective_says_so() {
    // What is cut as published has no floor to be under.
    let row = design("full", &[], "under_floor_mm min");
    assert_eq!((row.state, row.feasible, row.reason.as_deref()), (State::Done, false, Some("under_floor_mm min")));
    assert_eq!((row.value, row.limit, row.margin), (None, None, None));
    let row = design("full", &[], "time_s min");
    assert_eq!((row.state, row.feasible, row.reason), (State::Done, true, None));
}

#[test]
fn a_design_tells_how_far_its_tools_enter_the_own_faces() {
    let of = |row: &Row, key: &str| {
        let at = KINDS[0].measures().iter().position(|one| one.key == key).expect("a measure");
        row.measures[at].expect("a value")
    };
    // As P1044 says it, which the clearance to other blades does not count.
    let published = design("full", &[], "undercut_mm min");
    assert!(published.feasible && published.codes.contains(&"P1044"), "{published:?}");
    assert!((of(&published, "undercut_mm") - 0.077).abs() < 5e-4 && of(&published, "clearance_mm") > 0.0);
    // The suggested study has designs on either side of its limit.
    assert!(KINDS[0].suggested().constraints.contains("undercut_mm <= 0.05"));
    let shallow = design("full", &[("R", Value::Real(26.0)), ("a_p", Value::Real(1.0))], "undercut_mm min");
    assert!((0.01..0.05).contains(&of(&shallow, "undercut_mm")), "{shallow:?}");
    // The blocks of a part that is cut clear keep to the tolerance.
    let clear = design("clear", &[], "undercut_mm min");
    let tol = common::real(&common::values("clear", &[]), "tol").expect("a tolerance");
    assert!((0.0..=tol).contains(&of(&clear, "undercut_mm")), "{clear:?}");
}
