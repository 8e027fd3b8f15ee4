//! The command `simulate`: a turning program followed over its stock.

use std::collections::BTreeMap;
use std::io::BufRead;
use std::path::{Path, PathBuf};

use serde_json::json;

use super::args::Simulate;
use super::delivery::{self, Delivery};
use super::plan::Item;
use super::program::{Beside, told_from};
use super::stock::Stock;
use super::terminal::Terminal;
use super::verdict::{Verdict, code, status};
use super::{finding, interrupt, json, quantity, reading, refused, show};
use crate::escape::printable;
use crate::finding::{Exit, Finding, Grade, Place, Refusal};
use crate::gcode::dialect::told::told;
use crate::gcode::dialect::{Dialect, FAGOR_8055_T, FANUC_LATHE_A};
use crate::gcode::interpreter::{DecimalPoint, Files, Interpreter};
use crate::gcode::motion::Kind;
use crate::job::{Outcome, Source, lathe};
use crate::lathe::cases;
use crate::lathe::parameters::{BLOCKS_MOST, FORM, PROFILE_KEY, PROGRAM_KEY, SECOND_KEY, SUBPROGRAM_KEY, TOOLS_KEY};
use crate::lathe::setup::Given;
use crate::lathe::text;
use crate::machine::axis::Axis;
use crate::parameter::list::{Row, Rows};
use crate::parameter::{Value, Values};
use crate::store::{self, Existing, Folder, Set};
use crate::text::Text;
use crate::view::lathe::Watching;
use crate::workbook::{self, Input};

/// Held in the jaws, and faced off, where only the stock's size is given: mm.
const HELD: f64 = 30.0;

/// Follows the program and says what it comes to.
pub(super) fn run(arguments: &Simulate, terminal: &mut Terminal) -> Exit {
    let language = arguments.lang.unwrap_or_default();
    interrupt::listen();
    let mut followed = None;
    let verdict = reading::verdict(&arguments.program, |verdict| {
        followed = Some(simulate(arguments, verdict)?);
        Ok(())
    });
    if verdict.exit == Exit::CommandLine && followed.is_none() {
        return refused(&Refusal { exit: verdict.exit, findings: verdict.findings }, language, terminal);
    }
    if arguments.json {
        terminal.out(&json::laid_out(&document(arguments, &verdict, followed.as_ref())));
        return verdict.exit;
    }
    let (name, width) = (show::path(&arguments.program), terminal.width);
    if let Some(followed) = &followed {
        terminal.out(&format!("{name}: {}, {}\n", followed.dialect.name, followed.stock));
        terminal.out(&quantity::table(&verdict.quantities, language, width));
    }
    terminal.err(&finding::list(&verdict.findings, |grade| grade != Grade::Note, &name, language, width));
    terminal.out(&finding::list(&verdict.findings, |grade| grade == Grade::Note, &name, language, width));
    terminal.out(&show::files(&verdict));
    verdict.exit
}

/// What the simulation was of.
struct Followed {
    dialect: &'static Dialect,
    stock: String,
    outcome: Outcome,
}

fn simulate(arguments: &Simulate, verdict: &mut Verdict) -> Result<Followed, Refusal> {
    let path = &arguments.program;
    let bytes = workbook::open_as(Input::Program, path)?;
    verdict.sha256 = Some(store::sha256(&bytes));
    let folder = arguments.output.as_deref().map(Folder::open).transpose()?;
    let (values, found) = given(arguments)?;
    verdict.findings.extend(found);
    let ending = path.extension().unwrap_or_default().to_string_lossy().into_owned();
    let mut head = bytes.as_slice();
    let dialect = match arguments.dialect.as_deref().and_then(Dialect::named) {
        Some(dialect) => dialect,
        None => {
            let told = told(head.fill_buf().unwrap_or_default(), &ending);
            let dialect = if *told == FAGOR_8055_T { &FAGOR_8055_T } else { &FANUC_LATHE_A };
            verdict.findings.push(told_from(dialect));
            dialect
        }
    };
    let main = text::Text::of_file(String::from_utf8_lossy(&bytes).into_owned());
    let subprograms = subprograms(&main.text, &mut Beside::of(path))?;
    let program = text::Source { main, subprograms };
    let mut values = for_program(values, arguments, dialect, &program);
    if let Some(stock) = arguments.stock {
        put_stock(&mut values, stock);
    } else if arguments.tools.is_none() {
        let stock = enclosing(&values, &program)?;
        verdict.findings.push(Finding::note(
            Place::File,
            Text::new(
                format!("el bruto no se ha indicado: se toma {stock}, que encierra el recorrido en avance"),
                format!("no stock given: {stock} is taken, which encloses the path at feed"),
            ),
        ));
        put_stock(&mut values, stock);
    }
    let stock = stock_of(&values).to_string();
    let source = Source {
        workbook: printable(&path.file_name().unwrap_or_default().to_string_lossy()),
        sha256: verdict.sha256.clone().unwrap_or_default(),
        version: env!("CARGO_PKG_VERSION"),
    };
    let mut watching = Watching::default();
    let language = arguments.lang.unwrap_or_default();
    let watch = folder.is_some();
    let outcome = lathe::watched(&FORM, values, source, Some(program), &mut |seen| {
        if watch {
            watching.see(seen);
        }
    })?;
    verdict.findings.extend(outcome.findings.iter().cloned());
    verdict.findings.sort_by_key(|finding| std::cmp::Reverse(finding.grade));
    verdict.quantities.clone_from(&outcome.quantities);
    if outcome.stopped() {
        verdict.exit = Exit::Refused;
    }
    if let (Some(folder), Some(output)) = (&folder, &arguments.output) {
        let inputs: Vec<&Path> = std::iter::once(path).chain(&arguments.tools).map(PathBuf::as_path).collect();
        let mut set = Set::new(folder, &inputs, Existing::Replace);
        let item = Item { workbook: path.clone(), stem: store::stem(path), folder: output.clone() };
        Delivery { item: &item, outcome: &outcome, language }.write(Some(watching), &mut set)?;
        verdict.files = set.commit()?;
        verdict.folder = Some(output.clone());
        verdict.findings.extend(delivery::leftovers(&item, verdict));
    }
    Ok(Followed { dialect, stock, outcome })
}

/// The form to start from: the workbook that was named, or the example machine and turret.
fn given(arguments: &Simulate) -> Result<(Values, Vec<Finding>), Refusal> {
    if let Some(tools) = &arguments.tools {
        let bytes = workbook::open(tools)?;
        let filled = workbook::read(&bytes, &[&FORM])?;
        return Ok((filled.values, filled.findings));
    }
    let language = arguments.lang.unwrap_or_default();
    let mut values = Values { language, ..Values::default() };
    if let Some(case) = FORM.cases.first() {
        values.values.extend(case.values(language));
    }
    values.lists.push(cases::turret(language));
    let note = Finding::note(
        Place::File,
        Text::fixed(
            "sin --tools: máquina y torreta son las del libro de ejemplo (rodete new lathe)",
            "no --tools: machine and turret are those of the example workbook (rodete new lathe)",
        ),
    );
    Ok((values, vec![note]))
}

/// The form with this program in place of its own.
fn for_program(mut values: Values, arguments: &Simulate, dialect: &'static Dialect, program: &text::Source) -> Values {
    values.values.insert("dialect", Value::Choice(dialect.name));
    match arguments.decimal_point {
        Some(DecimalPoint::Calculator) => values.values.insert("point", Value::Choice("calculator")),
        Some(DecimalPoint::Micrometre) => values.values.insert("point", Value::Choice("micrometre")),
        None if arguments.tools.is_none() => values.values.remove("point"),
        None => None,
    };
    if arguments.block_delete {
        values.values.insert("block_delete", Value::Choice("yes"));
    }
    if arguments.tools.is_none() {
        let name = arguments.program.file_stem().unwrap_or_default().to_string_lossy();
        values.values.insert("part", Value::Line(printable(&name).chars().take(60).collect()));
        values.values.remove("material");
    }
    values.lists.retain(|rows| matches!(rows.list, TOOLS_KEY | PROFILE_KEY));
    let mut put = |list: &'static str, sheet: &str, text: &text::Text| {
        let lines: Vec<&str> = text.text.lines().map(str::trim_end).filter(|line| !line.is_empty()).collect();
        // A longer program does not go on a sheet.
        if lines.len() <= BLOCKS_MOST {
            let row = |line: &&str| Row {
                values: BTreeMap::from([("program/BLOCK", Value::Line((*line).to_owned()))]),
                cells: BTreeMap::new(),
            };
            values.lists.push(Rows { list, sheet: sheet.to_owned(), rows: lines.iter().map(row).collect() });
        }
    };
    put(PROGRAM_KEY, "", &program.main);
    for (name, text) in &program.subprograms {
        put(SUBPROGRAM_KEY, name, text);
    }
    debug_assert!(values.rows(SECOND_KEY).is_empty());
    values
}

fn put_stock(values: &mut Values, stock: Stock) {
    let held = HELD.min(stock.L / 4.0);
    values.values.insert("D", Value::Real(stock.D));
    values.values.insert("L", Value::Real(stock.L));
    values.values.insert("L4", Value::Real(held));
    values.values.insert("L5", Value::Real(0.0));
    match stock.d {
        Some(d) => values.values.insert("d", Value::Real(d)),
        None => values.values.remove("d"),
    };
}

fn stock_of(values: &Values) -> Stock {
    let real = |key| values.real(key).unwrap_or_default();
    Stock { D: real("D"), L: real("L"), d: values.real("d") }
}

/// A stock that holds the path at feed: its greatest diameter and its least Z, rounded up to whole millimetres, and what is
/// held in the jaws.
fn enclosing(values: &Values, program: &text::Source) -> Result<Stock, Refusal> {
    let given = Given::of(values).map_err(|findings| Refusal { exit: Exit::Refused, findings })?;
    let (mut X, mut Z): (f64, f64) = (0.0, 0.0);
    let interpreter: Interpreter<'_> = program.read(given.setting());
    for motion in interpreter.flatten().filter(|motion| !matches!(motion.kind, Kind::Rapid | Kind::Dwell(_))) {
        X = X.max(motion.to.get(Axis::X).abs());
        Z = Z.min(motion.to.get(Axis::Z));
    }
    let (D, L) = ((2.0 * X).ceil().clamp(1.0, 1000.0), ((-Z).ceil() + 5.0 + HELD).clamp(40.0, 1000.0));
    Ok(Stock { D, L, d: None })
}

/// The subprograms that stand beside the program: those that its M98 name, and so on.
fn subprograms(main: &str, files: &mut Beside) -> Result<BTreeMap<String, text::Text>, Refusal> {
    let mut found = BTreeMap::new();
    let mut texts = vec![main.to_owned()];
    while let Some(text) = texts.pop() {
        for number in called(&text) {
            let name = format!("O{number:04}");
            if found.contains_key(&name) {
                continue;
            }
            let names = [name.clone(), format!("o{number:04}"), format!("{number:04}"), number.to_string()];
            let unreadable = |reason: String| {
                let what = Text::same(format!("{name}: {reason}"));
                Refusal::new(Exit::Unreadable, Finding::stop(Place::File, what, Text::fixed("", "")))
            };
            for one in names {
                if let Some(bytes) = files.find(&one).map_err(unreadable)? {
                    let text = String::from_utf8_lossy(&bytes).into_owned();
                    texts.push(text.clone());
                    found.insert(name.clone(), text::Text::of_file(text));
                    break;
                }
            }
        }
    }
    Ok(found)
}

/// The numbers that M98 calls: the last four digits of its P.
fn called(text: &str) -> Vec<u32> {
    let calls = text.lines().filter(|line| line.to_uppercase().replace(' ', "").contains("M98"));
    calls
        .filter_map(|line| {
            let line = line.to_uppercase();
            let (_, behind) = line.split_once('P')?;
            let digits: String = behind.trim_start().chars().take_while(char::is_ascii_digit).collect();
            digits.parse::<u32>().ok().map(|number| number % 10_000)
        })
        .collect()
}

fn document(arguments: &Simulate, verdict: &Verdict, followed: Option<&Followed>) -> serde_json::Value {
    let totals: serde_json::Map<String, serde_json::Value> = verdict
        .quantities
        .iter()
        .filter_map(|one| {
            let name = match one.symbol {
                "V_r" => "removed_volume_mm3",
                "V_t" => "parted_volume_mm3",
                "V" => "part_volume_mm3",
                "t" => "time_s",
                "t_c" => "cutting_time_s",
                "t_G0" => "rapid_time_s",
                "a_p" => "greatest_depth_mm",
                "V_c" => "greatest_cutting_speed_m_min",
                "Q" => "greatest_removal_rate_cm3_min",
                "alarms" => "alarms",
                "stops" => "stops",
                "dev_plus" => "deviation_plus_mm",
                "dev_minus" => "deviation_minus_mm",
                _ => return None,
            };
            Some((name.to_owned(), json!(one.value)))
        })
        .collect();
    let motions = followed.and_then(|followed| followed.outcome.table("blocks")).map(crate::table::Table::rows);
    json!({
        "rodete": env!("CARGO_PKG_VERSION"),
        "command": "simulate",
        "exit": code(verdict.exit),
        "status": status(verdict.exit),
        "program": arguments.program.to_string_lossy(),
        "sha256": verdict.sha256,
        "dialect": followed.map(|followed| followed.dialect.name),
        "stock": followed.map(|followed| followed.stock.clone()),
        "motions": motions,
        "totals": totals,
        "findings": verdict.findings,
        "files": json::files(verdict),
    })
}
