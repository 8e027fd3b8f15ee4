//! The pure job of an impeller, and its programs as text.

#![allow(clippy::disallowed_methods, reason = "benchmarks read files and the clock")]

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use rodete::kind::{Outcome, Provenance};
use rodete::kinds;
use rodete::kinds::impeller::cases::CASES;
use rodete::kinds::impeller::clear::cut::Job;
use rodete::kinds::impeller::clear::plan::Plan;
use rodete::kinds::impeller::design::Design;
use rodete::kinds::impeller::parameters::FORM;
use rodete::parameter::field::Fields;
use rodete::parameter::{Value, Values};
use rodete::text::Language;

/// The shipped complete case with n intervals.
fn values(n: u32) -> Values {
    let mut values = Values { language: Language::En, ..Values::default() };
    let case = CASES.iter().find(|case| case.name == "full").expect("a case");
    values.values.extend(case.values(Language::En));
    values.values.insert("n", Value::Whole(n));
    values
}

fn outcome(n: u32) -> Outcome {
    computed(values(n))
}

fn computed(values: Values) -> Outcome {
    let source = Provenance { workbook: "impeller.xlsx".to_owned(), sha256: "0".repeat(64), version: "bench" };
    match kinds::run(&FORM, values, source) {
        Ok(outcome) => outcome,
        Err(refusal) => panic!("refused: {:?}", refusal.findings),
    }
}

fn computation(c: &mut Criterion) {
    let mut group = c.benchmark_group("compute");
    for n in [40, 1_000, 100_000] {
        group.throughput(Throughput::Elements(u64::from(n)));
        if n > 10_000 {
            group.sample_size(10);
        }
        group.bench_with_input(BenchmarkId::from_parameter(n), &n, |b, &n| b.iter(|| black_box(outcome(n))));
    }
    group.finish();
}

fn text(c: &mut Criterion) {
    let mut group = c.benchmark_group("text of the impeller program");
    for n in [40, 10_000] {
        let outcome = outcome(n);
        let Some(program) = outcome.programs.iter().find(|program| program.key == "impeller") else { continue };
        group.throughput(Throughput::Bytes(program.summary().bytes));
        group.bench_function(BenchmarkId::from_parameter(n), |b| {
            b.iter(|| program.write(&mut std::io::sink()).is_ok());
        });
    }
    group.finish();
}

/// The shipped case that is cut as designed: its plan alone, and all that `check` computes of it.
fn clear(c: &mut Criterion) {
    let Some(case) = CASES.iter().find(|case| case.name == "clear") else { return };
    let mut values = Values { language: Language::En, ..Values::default() };
    values.values.extend(case.values(Language::En));
    let Ok(fields) = Fields::of(&FORM, values.clone()) else { return };
    let Ok(design) = Design::new(&fields) else { return };
    let Some(asked) = &design.clear else { return };
    let mut group = c.benchmark_group("clear cut");
    group.sample_size(20);
    group.bench_function("plan", |b| b.iter(|| black_box(Plan::new(&Job::of(&design), &asked.cut)).is_ok()));
    group.bench_function("check", |b| b.iter(|| black_box(computed(values.clone()))));
    group.finish();
}

criterion_group!(benches, computation, text, clear);
criterion_main!(benches);
