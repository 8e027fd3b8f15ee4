//! Designs a second at each level, on one core and on all; a million rows of a sweep read, ranked and written.

#![allow(clippy::disallowed_methods, reason = "benchmarks read files and the clock")]

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use rayon::ThreadPoolBuilder;
use rayon::prelude::*;
use rodete::kind::Kind;
use rodete::kind::measure::Level;
use rodete::kinds::KINDS;
use rodete::parameter::field::Fields;
use rodete::parameter::{Value, Values};
use rodete::sweep::asked;
use rodete::sweep::file::{self, RowFile};
use rodete::sweep::form::{FORM, LEVEL};
use rodete::sweep::plan::Plan;
use rodete::sweep::ranking::Ranking;
use rodete::sweep::row::judged;
use rodete::sweep::table::Table;
use rodete::text::Language;
use rodete::workbook::sweep_sheet;

/// Designs of a run.
const DESIGNS: u64 = 64;
/// Rows that are merged, and rows of a chunk.
const ROWS: u64 = 1_000_000;
const CHUNK: u64 = 10_000;

/// The shipped impeller and its plan at a level.
fn study(level: Level) -> (&'static dyn Kind, Values, Plan) {
    let kind = KINDS[0];
    let mut sheet = sweep_sheet::suggested(kind.suggested(), Language::En);
    sheet.put(&LEVEL, Some(level));
    if level == Level::Limits {
        sheet.values.insert("objectives", Value::Line("gap_true max; e_max min".to_owned()));
    }
    let plan = Fields::of(&FORM, sheet).ok().and_then(|fields| asked::plan(kind, &fields, None).ok());
    let Some((plan, _)) = plan else { panic!("the suggested plan is refused") };
    let case = kind.cases().iter().find(|case| Some(case.name) == kind.suggested().case);
    (kind, Values::of(case.unwrap_or(&kind.cases()[0]), Language::En), plan)
}

fn designs(c: &mut Criterion) {
    let mut group = c.benchmark_group("designs");
    group.sample_size(10).measurement_time(Duration::from_secs(10)).throughput(Throughput::Elements(DESIGNS));
    for (name, level) in [("limits", Level::Limits), ("program", Level::Program)] {
        let (kind, base, plan) = study(level);
        let one = |at: u64| {
            let id = at * plan.count / DESIGNS;
            judged(kind, &base, &plan, id, plan.design(id)).stops
        };
        for threads in [1, 2] {
            let Ok(pool) = ThreadPoolBuilder::new().num_threads(threads).build() else { return };
            group.bench_function(BenchmarkId::new(name, threads), |b| {
                b.iter(|| pool.install(|| black_box((0..DESIGNS).into_par_iter().map(one).sum::<i64>())));
            });
        }
    }
    group.finish();
}

fn rows(c: &mut Criterion) {
    let mut group = c.benchmark_group("rows");
    group.sample_size(10).measurement_time(Duration::from_secs(30)).throughput(Throughput::Elements(ROWS));
    let (kind, base, plan) = study(Level::Limits);
    let mut chunk = Table::of(kind, &plan);
    let judged: Vec<_> =
        (0..plan.count).into_par_iter().map(|id| judged(kind, &base, &plan, id, plan.design(id))).collect();
    for (at, row) in (0..CHUNK).zip(judged.iter().cycle()) {
        let mut row = row.clone();
        row.id = at;
        chunk.push(row);
    }
    let Ok(bytes) = file::bytes(chunk.clone(), "plan") else { return };
    group.bench_function(format!("{} columns merged and ranked", chunk.columns.len()), |b| {
        b.iter(|| {
            let mut ranking = Ranking::new(&plan, 20_000);
            let Ok(mut summary) = RowFile::new(std::io::sink(), &chunk, "plan") else { return };
            for _ in 0..ROWS / CHUNK {
                let Ok(part) = file::read(bytes.clone(), &chunk, "plan", &|_| true) else { return };
                ranking.take(&part);
                if summary.write(part).is_err() {
                    return;
                }
            }
            black_box((summary.end().is_ok(), ranking.end().front.len()));
        });
    });
    group.finish();
}

criterion_group!(benches, designs, rows);
criterion_main!(benches);
