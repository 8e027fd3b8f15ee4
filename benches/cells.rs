//! The results workbook of a long blade against the library that writes workbooks, writing as many cells alone.
//!
//! `cargo bench --bench cells` prints both times, in turn, and their ratio.

#![allow(clippy::disallowed_methods, reason = "benchmarks read files and the clock")]

use std::io::{Cursor, Seek, Write};
use std::time::{Duration, Instant};

use rodete::kind::{Outcome, Provenance};
use rodete::kinds;
use rodete::kinds::impeller::cases::CASES;
use rodete::kinds::impeller::parameters::FORM;
use rodete::parameter::{Value, Values};
use rodete::table::Entry;
use rodete::text::Language;
use rodete::workbook::results::{self, Tables};
use rust_xlsxwriter::{ColNum, RowNum, Workbook, XlsxError};

const INTERVALS: u32 = 100_000;
const ROUNDS: usize = 5;
/// Rows of a sheet.
const SHEET: u64 = 1_048_576;

fn outcome() -> Outcome {
    let mut values = Values { language: Language::En, ..Values::default() };
    let case = CASES.iter().find(|case| case.name == "full").expect("a case");
    values.values.extend(case.values(Language::En));
    values.values.insert("n", Value::Whole(INTERVALS));
    let source = Provenance { workbook: "impeller.xlsx".to_owned(), sha256: "0".repeat(64), version: "bench" };
    match kinds::run(&FORM, values, source) {
        Ok(outcome) => outcome,
        Err(refusal) => panic!("refused: {:?}", refusal.findings),
    }
}

/// As many cells with the same contents, without titles, formats and charts, in the library's constant-memory mode.
fn alone(outcome: &Outcome, out: impl Write + Seek + Send) -> Result<u64, XlsxError> {
    let mut cells = 0;
    let mut workbook = Workbook::new();
    for table in &outcome.tables {
        let sheet = workbook.add_worksheet_with_constant_memory()?;
        for row in 0..table.rows() {
            let at = RowNum::try_from(row).map_err(|_| XlsxError::RowColumnLimitError)?;
            sheet.write_number(at, 0, f64::from(at))?;
            cells += 1;
            for (column, one) in (1..).zip(&table.columns) {
                match one.values.get(row) {
                    Entry::Number(value) => sheet.write_number(at, column, value)?,
                    Entry::Text(text) => sheet.write_string(at, column, text.en.as_ref())?,
                };
                cells += 1;
            }
        }
    }
    // Programs side by side; a long one goes on in further columns, as in the results.
    let sheet = workbook.add_worksheet_with_constant_memory()?;
    let mut columns: Vec<_> = Vec::new();
    for program in &outcome.programs {
        let lines = program.blocks();
        for part in 0..lines.div_ceil(SHEET) {
            let mut lines = program.lines();
            for _ in 0..part * SHEET {
                let _ = lines.next();
            }
            columns.push(lines);
        }
    }
    for row in 0..u32::try_from(SHEET).unwrap_or(u32::MAX) {
        let mut any = false;
        for (pair, lines) in (0..).zip(&mut columns) {
            if let Some((number, text)) = lines.next() {
                let column: ColNum = pair * 3;
                let number = number.map_or_else(String::new, |number| format!("N{number}"));
                sheet.write_string(row, column, number)?;
                sheet.write_string(row, column + 1, text)?;
                cells += 2;
                any = true;
            }
        }
        if !any {
            break;
        }
    }
    workbook.save_to_writer(out)?;
    Ok(cells)
}

fn median(mut times: Vec<Duration>) -> f64 {
    times.sort();
    times[times.len() / 2].as_secs_f64()
}

fn main() {
    let outcome = outcome();
    let (mut ours, mut theirs, mut cells) = (Vec::new(), Vec::new(), 0);
    for _ in 0..ROUNDS {
        let start = Instant::now();
        if let Err(error) = results::write(&outcome, &[], Tables::Live, Language::En, Cursor::new(Vec::new())) {
            panic!("{error}");
        }
        ours.push(start.elapsed());
        let start = Instant::now();
        match alone(&outcome, Cursor::new(Vec::new())) {
            Ok(count) => cells = count,
            Err(error) => panic!("{error}"),
        }
        theirs.push(start.elapsed());
    }
    let (ours, theirs) = (median(ours), median(theirs));
    println!("n = {INTERVALS}: {cells} cells");
    println!("results workbook {ours:.2} s, the library alone {theirs:.2} s, ratio {:.2}", ours / theirs);
}
