//! Plans: the designs of each method, against SciPy's figures where it has the same.

use std::collections::BTreeSet;

use rodete::finding::Grade;
use rodete::kinds::KINDS;
use rodete::kinds::impeller::parameters::FORM;
use rodete::limits::SWEEP_INPUTS;
use rodete::parameter::{FieldKind, Value};
use rodete::sweep::asked;
use rodete::sweep::plan::Plan;
use rodete::sweep::row::judged;
use rodete::text::Language;
use rodete::workbook::{self, sweep_sheet};

use crate::common::workbook::{Parts, place, with_variants, written_with_variants};

/// The plan of a workbook.
fn plan(bytes: &[u8]) -> Plan {
    let sheet = sweep_sheet::read(bytes, KINDS[0].form(), Language::En).unwrap().unwrap();
    asked::plan(KINDS[0], &sheet.fields, sheet.designs).unwrap().0
}

fn number(value: &Value) -> f64 {
    match value {
        Value::Real(number) => *number,
        Value::Whole(whole) => f64::from(*whole),
        other => panic!("{other:?}"),
    }
}

/// Values of the form's inputs R, r, a_p and e as points of the unit cube.
fn points(method: &str, samples: &str, seed: &str) -> Vec<[f64; 4]> {
    let settings = [("method", method), ("samples", samples), ("seed", seed)];
    let inputs = ["R", "r", "a_p", "e"].map(|symbol| [symbol, "10", "20", "", "", ""]);
    let plan = plan(&with_variants(&settings, &inputs, &[]));
    (0..plan.count).map(|id| std::array::from_fn(|at| (number(&plan.design(id)[at]) - 10.0) / 10.0)).collect()
}

#[test]
fn a_factorial_plan_has_every_level_with_every_other_by_its_index() {
    let book = with_variants(
        &[("method", "factorial")],
        &[["a_p", "1", "1.3", "0.1", "", ""], ["N", "", "", "", "4; 5", ""], ["splitters", "", "", "", "yes; no", ""]],
        &[],
    );
    let plan = plan(&book);
    assert_eq!(plan.count, 16);
    let word = |key| Value::Choice(key);
    assert_eq!(plan.design(0), [Value::Real(1.0), Value::Whole(4), word("yes")]);
    assert_eq!(plan.design(1), [Value::Real(1.0), Value::Whole(4), word("no")]);
    assert_eq!(plan.design(2), [Value::Real(1.0), Value::Whole(5), word("yes")]);
    // The number that a person would type, not 1.3000000000000003; and the last level counts.
    assert_eq!(plan.design(15), [Value::Real(1.3), Value::Whole(5), word("no")]);
    let all: BTreeSet<String> = (0..16).map(|id| format!("{:?}", plan.design(id))).collect();
    assert_eq!(all.len(), 16);
}

#[test]
fn the_points_of_sobol_are_those_of_scipy() {
    let points = points("sobol", "8", "0");
    // scipy.stats.qmc.Sobol(4, scramble=False).random(8), SciPy 1.17.1.
    let scipy = [
        [0.0, 0.0, 0.0, 0.0],
        [0.5, 0.5, 0.5, 0.5],
        [0.75, 0.25, 0.25, 0.25],
        [0.25, 0.75, 0.75, 0.75],
        [0.375, 0.375, 0.625, 0.875],
        [0.875, 0.875, 0.125, 0.375],
        [0.625, 0.125, 0.875, 0.625],
        [0.125, 0.625, 0.375, 0.125],
    ];
    assert_eq!(points.len(), scipy.len());
    for (point, scipy) in points.iter().zip(scipy) {
        assert!(point.iter().zip(scipy).all(|(one, other)| (one - other).abs() < 1e-12), "{point:?} {scipy:?}");
    }
}

#[test]
fn a_latin_plan_uses_every_slice_once_and_a_seed_gives_one_plan() {
    let latin = points("latin", "64", "3");
    for axis in 0..4 {
        let slices: BTreeSet<u64> = latin.iter().map(|point| (point[axis] * 64.0).floor().to_bits()).collect();
        assert_eq!(slices.len(), 64, "axis {axis}");
    }
    assert_eq!(latin, points("latin", "64", "3"));
    assert_ne!(latin, points("latin", "64", "4"));
}

/// The centred discrepancy of Hickernell, as `scipy.stats.qmc.discrepancy` gives it.
fn discrepancy(points: &[[f64; 4]]) -> f64 {
    let n = points.len() as f64;
    let away = |x: f64| (x - 0.5).abs();
    let one: f64 = points
        .iter()
        .map(|point| point.iter().map(|x| 1.0 + 0.5 * away(*x) - 0.5 * away(*x) * away(*x)).product::<f64>())
        .sum();
    let pair = |one: &[f64; 4], other: &[f64; 4]| -> f64 {
        one.iter().zip(other).map(|(x, y)| 1.0 + 0.5 * away(*x) + 0.5 * away(*y) - 0.5 * (x - y).abs()).product()
    };
    let two: f64 = points.iter().map(|one| points.iter().map(|other| pair(one, other)).sum::<f64>()).sum();
    let cube = (13.0_f64 / 12.0) * (13.0 / 12.0) * (13.0 / 12.0) * (13.0 / 12.0);
    cube - 2.0 / n * one + two / (n * n)
}

#[test]
fn plans_are_as_even_as_scipy_makes_them() {
    // SciPy's own of 256 points in 4 dimensions: random 0.0029, Latin 0.0010, Sobol 0.0001.
    for seed in ["1", "2", "3"] {
        let (latin, sobol) = (discrepancy(&points("latin", "256", seed)), discrepancy(&points("sobol", "256", seed)));
        assert!((0.0005..0.0020).contains(&latin), "Latin, seed {seed}: {latin}");
        assert!(sobol < 0.0003, "Sobol, seed {seed}: {sobol}");
    }
}

#[test]
fn a_cut_normal_distribution_is_that_of_scipy() {
    let settings = [("method", "sobol"), ("samples", "4"), ("seed", "0")];
    let book = with_variants(&settings, &[["a_p", "1.9", "2.1", "", "", "normal 2 0.05"]], &[]);
    let plan = plan(&book);
    let values: Vec<f64> = (0..4).map(|id| number(&plan.design(id)[0])).collect();
    // scipy.stats.truncnorm(-2, 2, loc=2, scale=0.05).ppf of 0, 1/2, 3/4, 1/4.
    for (value, scipy) in values.iter().zip([1.9, 2.0, 2.031_955_595_543_563_8, 1.968_044_404_456_436_2]) {
        assert!((value - scipy).abs() < 1e-12, "{values:?}");
    }
}

#[test]
fn whole_inputs_stay_whole_and_every_one_has_its_share() {
    let settings = [("method", "sobol"), ("samples", "1024"), ("seed", "5")];
    let plan = plan(&with_variants(&settings, &[["N", "3", "6", "", "", ""]], &[]));
    let mut counts = [0; 4];
    for id in 0..1024 {
        let Value::Whole(blades) = plan.design(id)[0] else { panic!("not whole") };
        counts[blades as usize - 3] += 1;
    }
    assert_eq!(counts, [256; 4]);
}

#[test]
fn a_list_gives_its_designs_in_their_order() {
    let settings = [("method", "list")];
    let rows: [&[&str]; 3] = [&["N", "e", "splitters"], &["4", "2", "yes"], &["5", "1.5", "no"]];
    let plan = plan(&with_variants(&settings, &[], &rows));
    assert_eq!(plan.count, 2);
    assert_eq!(plan.design(1), [Value::Whole(5), Value::Real(1.5), Value::Choice("no")]);
}

#[test]
fn chunks_of_any_number_cover_the_plan_once() {
    let plan = plan(&written_with_variants(KINDS[0], Language::En));
    assert_eq!(plan.count, 400, "the shipped plan");
    for chunks in [1, 3, 40, 400, 1000] {
        let ids: Vec<u64> = (0..chunks).flat_map(|number| plan.chunk(number, chunks)).collect();
        assert!(ids.into_iter().eq(0..400), "{chunks}");
    }
}

#[test]
fn every_kind_suggests_a_plan_that_is_read_as_it_is_written() {
    for kind in KINDS.iter().filter(|kind| !kind.suggested().inputs.is_empty()) {
        for language in Language::ALL {
            let bytes = written_with_variants(*kind, language);
            let sheet = sweep_sheet::read(&bytes, kind.form(), language).unwrap().unwrap();
            assert!(sheet.findings.is_empty(), "{:?}", sheet.findings);
            let (plan, notes) = asked::plan(*kind, &sheet.fields, sheet.designs).unwrap();
            assert!(notes.is_empty() && plan.count > 10 && plan.objectives.len() == 2, "{}", kind.form().kind);
        }
    }
}

#[test]
fn a_list_of_values_that_holds_none_is_refused_at_its_cells() {
    let book = with_variants(&[("method", "factorial")], &[["N", "", "", "", "; ;", ""]], &[]);
    let sheet = sweep_sheet::read(&book, KINDS[0].form(), Language::En).unwrap().unwrap();
    let findings = asked::plan(KINDS[0], &sheet.fields, sheet.designs).unwrap_err();
    assert_eq!(findings.iter().map(rodete::finding::Finding::code).collect::<Vec<_>>(), ["D0106"]);
}

#[test]
fn the_first_designs_of_a_sample_are_those_of_the_whole_sample() {
    let settings = [("method", "latin"), ("samples", "50"), ("seed", "7")];
    let book = with_variants(&settings, &[["R", "10", "20", "", "", ""], ["a_p", "1", "2", "", "", ""]], &[]);
    let (whole, first) = (plan(&book), plan(&book).limited(Some(8)));
    assert_eq!(first.count, 8);
    assert!((0..8).all(|id| whole.design(id) == first.design(id)));
    // It is another plan than one of eight.
    let eight = [("method", "latin"), ("samples", "8"), ("seed", "7")];
    let eight = plan(&with_variants(&eight, &[["R", "10", "20", "", "", ""], ["a_p", "1", "2", "", "", ""]], &[]));
    assert_ne!(first.told("0", "2", "1"), eight.told("0", "2", "1"));
}

#[test]
fn a_step_as_wide_as_the_range_has_two_levels() {
    // 0.3 − 0.1 is a little less than 0.2.
    let plan = plan(&with_variants(&[("method", "factorial")], &[["a_p", "0.1", "0.3", "0.2", "", ""]], &[]));
    let levels: Vec<f64> = (0..plan.count).map(|id| number(&plan.design(id)[0])).collect();
    assert_eq!(levels, [0.1, 0.3]);
}

/// What is wrong with a list, by code and cell.
fn list_findings(change: impl Fn(Parts, &str) -> Parts, rows: &[&[&str]]) -> Vec<(&'static str, String)> {
    let parts = Parts::of(&with_variants(&[("method", "list")], &[], rows));
    let last =
        (1..).map(|at| format!("xl/worksheets/sheet{at}.xml")).take_while(|part| parts.has(part)).last().unwrap();
    let bytes = change(parts, &last).zip();
    let findings = match sweep_sheet::read(&bytes, KINDS[0].form(), Language::En) {
        Ok(sheet) => {
            let sheet = sheet.unwrap();
            asked::plan(KINDS[0], &sheet.fields, sheet.designs).map_or_else(|findings| findings, |_| Vec::new())
        }
        Err(refusal) => refusal.findings,
    };
    findings.iter().filter(|one| one.grade == Grade::Stop).map(|one| (one.code(), place(one))).collect()
}

#[test]
fn whatever_of_a_list_would_be_left_out_of_its_designs_is_refused_by_its_cell() {
    let same = |parts: Parts, _: &str| parts;
    let formula = |address: &'static str| {
        move |parts: Parts, sheet: &str| parts.cell(sheet, address, &format!("<c r=\"{address}\"><f>20+7</f></c>"))
    };
    let told = |code, place: &str| vec![(code, place.to_owned())];
    assert_eq!(list_findings(same, &[&["R"], &["26"], &["27"]]), []);
    // A formula whose value no spreadsheet has worked out: alone in its row, beside another, in a column without a symbol, as a symbol.
    assert_eq!(list_findings(formula("A3"), &[&["R"], &["26"], &["27"]]), told("W0402", "A3"));
    assert_eq!(list_findings(formula("B2"), &[&["R", "e"], &["26", "1"]]), told("W0402", "B2"));
    assert_eq!(list_findings(formula("B2"), &[&["R"], &["26", "1"]]), told("D0126", "B2"));
    assert_eq!(list_findings(formula("B1"), &[&["R", "e"], &["26", "1"]]), told("D0126", "B1"));
    // Values below no symbol, each column once.
    assert_eq!(list_findings(same, &[&["R", "", "e"], &["26", "4", "1"], &["27", "5", "1"]]), told("D0126", "B2"));
    assert_eq!(list_findings(same, &[&["R", "e"], &["26", "1"], &["27", "1", "99"]]), told("D0126", "C3"));
    let wide: [&str; 41] = std::array::from_fn(|at| if at == 0 || at == 40 { "26" } else { "" });
    assert_eq!(list_findings(same, &[&["R"], &wide]), told("D0128", "AO2"));
    let wide: [&str; 40] = std::array::from_fn(|at| if at == 0 || at == 39 { "26" } else { "" });
    assert_eq!(list_findings(same, &[&["R"], &wide]), told("D0126", "AN2"), "the last column that is read");
    // Symbols alone: the sheet is there, and has no design.
    assert_eq!(list_findings(same, &[&["R", "e"]]), told("D0127", "DESIGNS"));
}

/// As many inputs as a plan may vary: 40, or as many as the form has.
#[test]
fn a_list_has_a_column_for_every_input_that_a_plan_may_vary() {
    let numbers = FORM.parameters().filter_map(|(_, one)| match one.kind {
        FieldKind::Real { min, .. } => Some((one.symbol(), min.to_string())),
        FieldKind::Whole { min, .. } => Some((one.symbol(), min.to_string())),
        _ => None,
    });
    let columns: Vec<(&str, String)> = numbers.take(SWEEP_INPUTS as usize).collect();
    assert!(columns.len() > 24, "{}", columns.len());
    let symbols: Vec<&str> = columns.iter().map(|(symbol, _)| *symbol).collect();
    let design: Vec<&str> = columns.iter().map(|(_, value)| value.as_str()).collect();
    let plan = plan(&with_variants(&[("method", "list")], &[], &[&symbols, &design]));
    assert_eq!((plan.inputs.len(), plan.count), (columns.len(), 1));
}

#[test]
fn a_normal_distribution_far_from_its_range_is_that_of_scipy_or_refused_by_its_cell() {
    let book = |normal: &str| {
        with_variants(
            &[("method", "sobol"), ("samples", "4"), ("seed", "0")],
            &[["a_p", "1.9", "2.1", "", "", normal]],
            &[],
        )
    };
    // scipy.stats.truncnorm(a, b, loc, scale).ppf of 1/2, 3/4, 1/4, 10 deviations above the mean, then below it.
    let figures = [
        ("normal 0.9 0.1", [1.906_841_183_605_849_2, 1.913_637_059_380_176_2, 1.902_844_905_536_155_8]),
        ("normal 3.1 0.1", [2.093_158_816_394_150_4, 2.097_155_094_463_844_6, 2.086_362_940_619_838_3]),
    ];
    for (normal, scipy) in figures {
        let plan = plan(&book(normal));
        for (id, scipy) in (1..).zip(scipy) {
            let value = number(&plan.design(id)[0]);
            assert!((value - scipy).abs() < 1e-9, "{normal} {id}: {value}");
        }
    }
    for normal in ["normal 100 1", "normal -100 1", "normal 2 1e30"] {
        let sheet = sweep_sheet::read(&book(normal), KINDS[0].form(), Language::En).unwrap().unwrap();
        let findings = asked::plan(KINDS[0], &sheet.fields, sheet.designs).unwrap_err();
        let told: Vec<_> = findings.iter().map(|one| (one.code(), place(one))).collect();
        assert_eq!(told, [("D0129", "B7,C7,F7".to_owned())], "{normal}");
    }
}

/// What is told of a plan over one row of inputs: codes with their cells, and the sentences.
fn told(settings: &[(&str, &str)], input: [&str; 6]) -> Vec<(&'static str, String, String)> {
    let sheet = sweep_sheet::read(&with_variants(settings, &[input], &[]), KINDS[0].form(), Language::En).unwrap();
    let sheet = sheet.unwrap();
    let findings =
        asked::plan(KINDS[0], &sheet.fields, sheet.designs).map_or_else(|findings| findings, |(_, notes)| notes);
    findings.iter().map(|one| (one.code(), place(one), one.what.en.to_string())).collect()
}

#[test]
fn what_contradicts_or_repeats_itself_in_a_plan_is_told_by_its_cell() {
    let one = |settings: &[(&str, &str)], input: [&str; 6]| {
        let told = told(settings, input);
        assert_eq!(told.len(), 1, "{told:?}");
        (told[0].0, told[0].1.clone(), told[0].2.clone())
    };
    let blades = ["N", "", "", "", "4; 5", ""];
    for objectives in ["time_s min; time_s max", "time_s min; clearance_mm max; time_s min"] {
        let (code, cell, _) = one(&[("method", "factorial"), ("objectives", objectives)], blades);
        assert_eq!((code, cell.as_str()), ("D0130", "C3"));
    }
    let (code, cell, _) = one(&[("method", "factorial")], ["N", "", "", "", "4; 5; 4.0", ""]);
    assert_eq!((code, cell.as_str()), ("D0131", "E5"));
    let (code, cell, _) = one(&[("method", "factorial"), ("samples", "64")], blades);
    assert_eq!((code, cell.as_str()), ("D0132", "C3"));
    let (code, cell, what) = one(&[("method", "factorial")], ["R", "21", "30", "2", "", ""]);
    assert_eq!((code, cell.as_str()), ("D0133", "C5,D5"));
    assert!(what.contains("29 mm") && what.contains("30 mm"), "{what}");
    assert_eq!(told(&[("method", "factorial")], ["a_p", "0.1", "0.7", "0.1", "", ""]), []);
}

#[test]
fn every_input_that_the_example_of_the_lathe_varies_changes_what_it_asks_for() {
    for kind in KINDS.iter().filter(|kind| kind.form().kind == "lathe") {
        let bytes = written_with_variants(*kind, Language::En);
        let base = workbook::read(&bytes, &[kind.form()]).unwrap().values;
        let sheet = sweep_sheet::read(&bytes, kind.form(), Language::En).unwrap().unwrap();
        let plan = asked::plan(*kind, &sheet.fields, sheet.designs).unwrap().0;
        let own: Vec<Value> = plan.inputs.iter().map(|one| base.values[one.parameter.key].clone()).collect();
        for (at, input) in plan.inputs.iter().enumerate() {
            let asked = |level: u64| {
                let mut inputs = own.clone();
                inputs[at] = input.level(level)?;
                let row = judged(*kind, &base, &plan, 0, inputs);
                let of =
                    |key: &str| kind.measures().iter().position(|one| one.key == key).and_then(|at| row.measures[at]);
                let costs = plan.objectives.iter().map(|one| of(one.measure.key).map(f64::to_bits)).collect::<Vec<_>>();
                Some((row.feasible, costs))
            };
            let seen: BTreeSet<_> = (0..input.levels.count().unwrap()).filter_map(asked).collect();
            assert!(seen.len() > 1, "{} {}: {seen:?}", kind.form().kind, input.symbol());
        }
    }
}
