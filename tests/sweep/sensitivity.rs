//! The indices of Sobol: the plan's groups, and the function of Ishigami, whose indices are known.

use std::f64::consts::PI;

use rodete::kinds::KINDS;
use rodete::number::trig::sin_cos;
use rodete::parameter::Value;
use rodete::sweep::asked;
use rodete::sweep::indices::{Index, Indices};
use rodete::sweep::plan::Plan;
use rodete::sweep::row::{Row, State};
use rodete::sweep::sensitivity::Shares;
use rodete::sweep::table::Table;
use rodete::text::Language;
use rodete::workbook::sweep_sheet;

use crate::common::workbook::with_variants;

/// A plan for indices over three inputs.
fn plan(samples: &str, seed: &str) -> Plan {
    let settings = [("method", "saltelli"), ("samples", samples), ("seed", seed), ("objectives", "L min")];
    let inputs = ["R", "r", "a_p"].map(|symbol| [symbol, "10", "20", "", "", ""]);
    let bytes = with_variants(&settings, &inputs, &[]);
    let sheet = sweep_sheet::read(&bytes, KINDS[0].form(), Language::En).unwrap().unwrap();
    asked::plan(KINDS[0], &sheet.fields, sheet.designs).unwrap().0
}

/// Ishigami and Homma, 1990, with a = 7 and b = 0.1.
fn ishigami(x: [f64; 3]) -> f64 {
    let [(one, _), (two, _)] = [x[0], x[1]].map(sin_cos);
    one + 7.0 * two * two + 0.1 * x[2] * x[2] * x[2] * x[2] * one
}

/// The rows of a function over a plan, of the designs that are feasible.
fn rows(plan: &Plan, of: impl Fn([f64; 3]) -> f64, feasible: impl Fn(u64) -> bool) -> Table {
    let mut table = Table::of(KINDS[0], plan);
    let measures = KINDS[0].measures();
    for id in 0..plan.count {
        let at = std::array::from_fn(|input| PI * (2.0 * plan.place(id, input) - 1.0));
        let value = |key: &str| (key == "L").then(|| of(at));
        let measures = measures.iter().map(|one| value(one.key)).collect();
        table.push(Row { measures, ..row(plan, id, feasible(id)) });
    }
    table
}

/// A row without measures.
fn row(plan: &Plan, id: u64, feasible: bool) -> Row {
    Row {
        id,
        inputs: plan.design(id),
        measures: vec![None; KINDS[0].measures().len()],
        state: State::Done,
        feasible,
        stops: 0,
        cautions: 0,
        codes: Vec::new(),
        reason: None,
        value: None,
        limit: None,
        margin: None,
        message: None,
    }
}

fn indices(plan: &Plan, mut rows: Table, part: usize) -> (Vec<Index>, (u64, u64)) {
    let mut indices = Indices::new(plan).unwrap();
    while rows.rows() > 0 {
        let count = part.min(rows.rows());
        indices.take(&rows.split(count));
    }
    let all = indices.end().into_iter().map(|of_input| of_input[0].unwrap()).collect();
    (all, indices.triples())
}

#[test]
fn a_group_holds_two_designs_and_those_with_one_input_of_the_second() {
    let plan = plan("8", "3");
    assert_eq!(plan.count, 8 * 5);
    let number = |value: &Value| if let Value::Real(number) = value { *number } else { panic!("{value:?}") };
    for group in 0..8 {
        let designs: Vec<Vec<f64>> =
            (0..5).map(|at| plan.design(5 * group + at).iter().map(number).collect()).collect();
        assert!((0..3).all(|input| designs[0][input] != designs[1][input]), "{designs:?}");
        for mixed in 0..3 {
            for input in 0..3 {
                let from = usize::from(input == mixed);
                assert_eq!(designs[2 + mixed][input].to_bits(), designs[from][input].to_bits(), "{designs:?}");
            }
        }
    }
}

#[test]
fn the_indices_of_the_function_of_ishigami_are_those_that_are_known() {
    // Of the derivation: V = a²/8 + b·π⁴/5 + b²·π⁸/18 + 1/2; the second input acts alone, the third only with the first.
    let (first, total) = ([0.313_905, 0.442_411, 0.0], [0.557_589, 0.442_411, 0.243_684]);
    for (samples, near) in [("1024", 0.02), ("16384", 0.002)] {
        for seed in ["0", "1", "2"] {
            let plan = plan(samples, seed);
            let (found, _) = indices(&plan, rows(&plan, ishigami, |_| true), 1000);
            for (at, one) in found.iter().enumerate() {
                assert!((one.first - first[at]).abs() < near, "{samples} {seed} {at}: {one:?}");
                assert!((one.total - total[at]).abs() < near, "{samples} {seed} {at}: {one:?}");
                assert!((one.first - first[at]).abs() <= one.off[0] && (one.total - total[at]).abs() <= one.off[1]);
            }
        }
    }
}

#[test]
fn the_indices_are_those_of_scipy_for_the_same_designs() {
    // scipy.stats.sobol_indices of f(A), f(B) and f(A_B,i) on scipy.stats.qmc.Sobol(6, scramble=False).random(1024), SciPy 1.17.1;
    // SALib 1.6 gives the same to 3e-7.
    let (first, total) = ([0.332_955_30, 0.441_313_94, 0.018_578_60], [0.558_179_05, 0.443_284_58, 0.242_149_37]);
    let plan = plan("1024", "0");
    let (found, triples) = indices(&plan, rows(&plan, ishigami, |_| true), 5000);
    assert_eq!(triples, (1024, 1024));
    for (at, one) in found.iter().enumerate() {
        assert!((one.first - first[at]).abs() < 1e-8 && (one.total - total[at]).abs() < 1e-8, "{at}: {one:?}");
    }
}

#[test]
fn a_large_constant_changes_nothing_and_parts_may_end_anywhere() {
    let plan = plan("256", "5");
    let (plain, _) = indices(&plan, rows(&plan, ishigami, |_| true), 10_000);
    let (parted, _) = indices(&plan, rows(&plan, ishigami, |_| true), 7);
    assert_eq!(plain, parted);
    let (moved, _) = indices(&plan, rows(&plan, |x| 1e6 + ishigami(x), |_| true), 10_000);
    for (one, other) in plain.iter().zip(&moved) {
        assert!((one.first - other.first).abs() < 1e-8 && (one.total - other.total).abs() < 1e-8, "{one:?} {other:?}");
    }
}

#[test]
fn triples_with_a_design_that_is_not_feasible_are_left_out() {
    let plan = plan("1024", "1");
    // Of every fourth group one design: the first of all, or the one that has the third input of the second.
    let (found, triples) = indices(&plan, rows(&plan, ishigami, |id| id % 40 != 0 && id % 40 != 24), 999);
    assert_eq!(triples, (1024 - 256, 1024));
    assert!((found[1].total - 0.442_411).abs() < 0.05, "{found:?}");
    let mut none = Indices::new(&plan).unwrap();
    none.take(&rows(&plan, |_| 3.0, |_| true));
    assert!(none.end().iter().flatten().all(Option::is_none), "nothing varies");
}

/// What is asked for follows the first input alone: of a Latin plan the share of the others is what chance gives.
#[test]
fn a_share_is_told_only_from_so_many_designs_that_chance_gives_little() {
    let shares = |samples: &str, feasible: &dyn Fn(u64) -> bool| {
        let settings = [("method", "latin"), ("samples", samples), ("objectives", "L min")];
        let inputs = ["R", "r", "a_p"].map(|symbol| [symbol, "10", "20", "", "", ""]);
        let bytes = with_variants(&settings, &inputs, &[]);
        let sheet = sweep_sheet::read(&bytes, KINDS[0].form(), Language::En).unwrap().unwrap();
        let plan = asked::plan(KINDS[0], &sheet.fields, sheet.designs).unwrap().0;
        let mut shares = Shares::new(&plan);
        shares.take(&rows(&plan, |x| x[0], feasible));
        shares.end().into_iter().map(|of_input| of_input[0]).collect::<Vec<_>>()
    };
    for (samples, feasible) in [("7", 1), ("63", 1), ("126", 2)] {
        assert_eq!(shares(samples, &|id| id % feasible == 0), [None; 3], "{samples}");
    }
    // 64 of 320 would be two in a slice.
    assert_eq!(shares("320", &|id| id % 5 == 0), [None; 3]);
    for (samples, feasible) in [("64", 1), ("128", 2), ("320", 2)] {
        let told = shares(samples, &|id| id % feasible == 0);
        let told: Vec<f64> = told.into_iter().map(Option::unwrap).collect();
        // Two standard deviations of what chance gives.
        assert!(told[0] > 0.95 && told[1] < 0.18 && told[2] < 0.18, "{samples}: {told:?}");
    }
}

#[test]
fn the_shares_of_a_list_follow_its_values_and_not_their_order() {
    // R and a_p spread evenly, neither along the order of the list; what is asked for hangs on R alone.
    let designs: Vec<[String; 2]> = (0..96)
        .map(|at| {
            [(at * 37 % 96, 30.0), (at * 53 % 96, 1.0)].map(|(rank, from)| format!("{}", from + f64::from(rank) / 96.0))
        })
        .collect();
    let mut sorted = designs.clone();
    sorted.sort();
    let shares = |designs: &[[String; 2]]| {
        let rows: Vec<Vec<&str>> = std::iter::once(vec!["R", "a_p"])
            .chain(designs.iter().map(|design| design.iter().map(String::as_str).collect()))
            .collect();
        let rows: Vec<&[&str]> = rows.iter().map(Vec::as_slice).collect();
        let bytes = with_variants(&[("method", "list"), ("objectives", "L min")], &[], &rows);
        let sheet = sweep_sheet::read(&bytes, KINDS[0].form(), Language::En).unwrap().unwrap();
        let plan = asked::plan(KINDS[0], &sheet.fields, sheet.designs).unwrap().0;
        let mut table = Table::of(KINDS[0], &plan);
        let at = KINDS[0].measures().iter().position(|one| one.key == "L").unwrap();
        for id in 0..plan.count {
            let mut row = row(&plan, id, true);
            if let Value::Real(R) = plan.design(id)[0] {
                row.measures[at] = Some(R * R);
            }
            table.push(row);
        }
        let mut shares = Shares::new(&plan);
        shares.take(&table);
        shares.end().into_iter().map(|of_input| of_input[0].unwrap()).collect::<Vec<f64>>()
    };
    let [listed, sorted] = [shares(&designs), shares(&sorted)];
    assert!(listed[0] > 0.98 && listed[1] < 0.05, "{listed:?}");
    assert!(listed.iter().zip(&sorted).all(|(one, other)| (one - other).abs() < 1e-9), "{listed:?} {sorted:?}");
}
