//! A turning program in a file, followed over its stock: what `simulate` and `view` have in common.

use std::collections::BTreeMap;
use std::path::Path;

use super::program::{PACKAGE, SubprogramFiles, of_workbook, told_from, told_of, told_other};
use super::rules::*;
use super::stock::Stock;
use super::verdict::Verdict;
use crate::escape::{printable, printable_path};
use crate::finding::{Exit, Finding, Place, Raise, Refusal, gravest_first};
use crate::gcode::control::Control;
use crate::gcode::control::guess::{guess_turning, mills};
use crate::gcode::in_force::Spindle;
use crate::gcode::interpreter::{DecimalPoint, Files, HolePlane, Interpreter, decoded, wide};
use crate::gcode::motion::MotionKind;
use crate::gcode::rules::lexis::{OtherControl, Utf16};
use crate::kind::{Outcome, Provenance, Wants};
use crate::kinds::lathe::cases;
use crate::kinds::lathe::parameters::{
    self as form, FORM, PROFILE_KEY, PROGRAM_KEY, SECOND_KEY, SUBPROGRAM_KEY, TOOLS_KEY,
};
use crate::kinds::lathe::setup::Given;
use crate::kinds::lathe::text;
use crate::kinds::lathe::tool_sheet::{self as tools, ToolType};
use crate::kinds::lathe::{self, Raised, Simulated};
use crate::limits::{FOLLOWED_MOTIONS, SHEET_BLOCKS, STOCK_SIZE};
use crate::machine::axis::Axis;
use crate::number::shown;
use crate::parameter::Values;
use crate::parameter::field::{Field, Fields, Required};
use crate::parameter::list::{Row, Rows};
use crate::removal::turning::machine::Lathe;
use crate::removal::turning::stock::Support;
use crate::store;
use crate::text::{Language, Text, t};
use crate::workbook;

/// Held in the jaws, and faced off, where only the stock's size is given: mm.
const HELD: f64 = 30.0;
/// The radius of a stock in which nothing is cut at feed, mm: thick enough to need no tailstock.
const THICK: f64 = 7.0;
/// What a stock has between its jaws and the path, mm.
const BESIDE_JAWS: f64 = 5.0;
/// The shortest stock that encloses a path, mm.
const SHORTEST: f64 = 40.0;

/// A program to follow, and what it is followed with.
#[derive(Debug)]
pub(super) struct TurningRequest<'a> {
    /// The program's file.
    pub(super) program: &'a Path,
    /// What stands in it.
    pub(super) bytes: &'a [u8],
    /// Its control; `None`: told from the program.
    pub(super) control: Option<&'static Control>,
    /// What a dimension without a decimal point is.
    pub(super) decimal_point: Option<DecimalPoint>,
    /// What R of G81 to G83 is; `None`: what the workbook says.
    pub(super) hole_plane: Option<HolePlane>,
    /// Blocks with `/` are skipped.
    pub(super) block_delete: bool,
    /// The stock; `None`: that of the workbook, or one that encloses the path.
    pub(super) stock: Option<Stock>,
    /// Whether a tailstock supports it; `None`: what the workbook says.
    pub(super) tailstock: Option<Support>,
    /// The lathe workbook; `None`: the example.
    pub(super) tools: Option<&'a Path>,
    /// The language of the example machine, where no workbook is named.
    pub(super) language: Language,
}

/// What was followed.
#[derive(Debug)]
pub(super) struct Followed {
    /// The program's control.
    pub(super) control: &'static Control,
    /// The stock, as `D50xL100`.
    pub(super) stock: String,
    /// What came of it.
    pub(super) outcome: Outcome,
    /// Every alarm, in the order of the motions.
    pub(super) alarms: Vec<Raised>,
    /// The program was followed to its end, without a rejected block.
    pub(super) whole: bool,
}

/// Follows the program and puts what was found into the verdict.
///
/// # Errors
/// Where a file cannot be read, the workbook is refused, or its values contradict each other.
pub(super) fn follow(wanted: &TurningRequest<'_>, verdict: &mut Verdict, wants: Wants) -> Result<Followed, Refusal> {
    let path = wanted.program;
    if wanted.bytes.starts_with(PACKAGE) {
        return Err(is_workbook(path));
    }
    if wide(wanted.bytes) {
        return Err(Refusal::new(Exit::Unreadable, Utf16 {}.at(Place::File)));
    }
    let sha256 = store::sha256(wanted.bytes);
    verdict.sha256 = Some(sha256.clone());
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    if wanted.control.is_none() && wanted.tools.is_none() && mills(wanted.bytes, &ending) {
        return Err(MillingProgram {}.refused(Exit::Refused, Place::File));
    }
    let (values, found) = given(wanted).map_err(|refusal| of_workbook(refusal, wanted.tools))?;
    let before = verdict.findings.len();
    verdict.language = wanted.tools.map(|_| values.language);
    verdict.findings.extend(found.into_iter().map(|finding| told_of(finding, wanted.tools)));
    let control = wanted.control.unwrap_or_else(|| {
        let control = guess_turning(wanted.bytes);
        verdict.findings.push(told_from(control));
        control
    });
    let main = text::Lines::of_file(&decoded(wanted.bytes));
    let subprograms = subprograms(&main.text, &mut SubprogramFiles::of(path))?;
    let program = text::SheetProgram { main, subprograms };
    let turned_over = wanted.tools.is_none() && only_left(&program.main.text);
    if turned_over {
        verdict.findings.push(ToolsTurnedOver {}.at(Place::File));
    }
    let mut values = for_program(values, wanted, control, &program, turned_over);
    if let Some(stock) = wanted.stock {
        put_stock(&mut values, stock, wanted.tools.is_some());
    } else if wanted.tools.is_none() {
        let stock = enclosing(&values, &program).map_err(|refusal| of_workbook(refusal, wanted.tools))?;
        verdict.findings.push(StockAssumed { stock: stock.to_string() }.at(Place::File));
        put_stock(&mut values, stock, false);
    }
    if wanted.tools.is_none() {
        // First of the notes, as what all others rest on.
        let told = ExampleMachine { tailstock: tailstock(&values, wanted.tailstock) }.at(Place::File);
        verdict.findings.insert(before, told);
    }
    let stock = stock_of(&values).to_string();
    let source = Provenance {
        workbook: printable(&path.file_name().unwrap_or_default().to_string_lossy()),
        sha256,
        version: env!("CARGO_PKG_VERSION"),
    };
    let Simulated { outcome, alarms, whole } =
        lathe::simulated(Fields::of(&FORM, values)?, source, Some(program), wants)
            .map_err(|refusal| of_workbook(refusal, wanted.tools))?;
    if wanted.control.is_none() && outcome.findings.iter().all(|one| one.code() != OtherControl::RULE.code) {
        verdict.findings.extend(told_other(path, wanted.bytes, control));
    }
    verdict.findings.extend(outcome.findings.iter().cloned());
    gravest_first(&mut verdict.findings);
    verdict.quantities.clone_from(&outcome.quantities);
    verdict.exit = outcome.exit();
    Ok(Followed { control, stock, outcome, alarms, whole })
}

/// A workbook in place of a program.
pub(super) fn is_workbook(path: &Path) -> Refusal {
    WorkbookInPlaceOfProgram { path: printable_path(path) }.refused(Exit::Unreadable, Place::File)
}

/// The form to start from: the workbook that was named, or the example machine and turret.
fn given(wanted: &TurningRequest<'_>) -> Result<(Values, Vec<Finding>), Refusal> {
    if let Some(tools) = wanted.tools {
        let bytes = workbook::open(tools)?;
        let filled = workbook::read(&bytes, &[&FORM])?;
        return Ok((filled.values, filled.findings));
    }
    let language = wanted.language;
    let mut values = Values { language, ..Values::default() };
    if let Some(case) = cases::CASES.first() {
        values.values.extend(case.values(language));
    }
    values.lists.push(cases::turret(language));
    Ok((values, Vec::new()))
}

/// The form with this program in place of its own.
fn for_program(
    mut values: Values,
    wanted: &TurningRequest<'_>,
    control: &'static Control,
    program: &text::SheetProgram,
    turned_over: bool,
) -> Values {
    values.put(&form::DIALECT, Some(control));
    if wanted.decimal_point.is_some() || wanted.tools.is_none() {
        values.put(&form::POINT, wanted.decimal_point);
    }
    if wanted.hole_plane.is_some() {
        values.put(&form::HOLE_R, wanted.hole_plane);
    }
    if wanted.tailstock.is_some() {
        values.put(&form::TAILSTOCK, wanted.tailstock);
    }
    if wanted.block_delete {
        values.put(&form::BLOCK_DELETE, Some(true));
    }
    if wanted.tools.is_none() {
        let name = wanted.program.file_stem().unwrap_or_default().to_string_lossy();
        values.put(&form::PART, Some(printable(&name).chars().take(60).collect()));
        values.put(&form::MATERIAL, None);
    }
    values.lists.retain(|rows| matches!(rows.list, TOOLS_KEY | PROFILE_KEY));
    if turned_over {
        // Nobody said which face of the example's tools looks up: it is the one that cuts as the program turns. A drill has none.
        let rows = values.lists.iter_mut().filter(|rows| rows.list == TOOLS_KEY).flat_map(|rows| &mut rows.rows);
        let faced =
            rows.filter(|row| !matches!(row.found(&tools::TYPE), Some(ToolType::Drill | ToolType::CentreDrill)));
        faced.for_each(|row| row.put(&tools::M, Spindle::CounterClockwise));
    }
    let mut put = |list: &'static str, sheet: &str, text: &text::Lines| {
        let lines: Vec<&str> = text.text.lines().map(str::trim_end).filter(|line| !line.is_empty()).collect();
        // A longer program does not go on a sheet.
        if lines.len() <= SHEET_BLOCKS {
            let row = |line: &&str| Row::of([form::BLOCK.is((*line).to_owned())]);
            values.lists.push(Rows { list, sheet: sheet.to_owned(), rows: lines.iter().map(row).collect() });
        }
    };
    put(PROGRAM_KEY, "", &program.main);
    for (name, text) in &program.subprograms {
        let number = name.trim_start_matches(['O', 'o']);
        put(SUBPROGRAM_KEY, &format!("O{number:0>4}"), text);
    }
    debug_assert!(values.rows(SECOND_KEY).is_empty());
    values
}

/// True for a program that turns the spindle with M4 and never with M3.
fn only_left(text: &str) -> bool {
    let turns = |way: &str| {
        text.lines().any(|line| {
            let code = line.split(['(', ';']).next().unwrap_or_default().to_uppercase().replace([' ', '\t'], "");
            code.split('M').skip(1).any(|rest| {
                rest.chars().take_while(char::is_ascii_digit).collect::<String>().trim_start_matches('0') == way
            })
        })
    };
    turns("4") && !turns("3")
}

/// Puts another bar into the jaws: of a workbook that was named, what is held and what is faced off stay where they fit.
fn put_stock(values: &mut Values, stock: Stock, of_workbook: bool) {
    let stays = |field: &Field<f64, Required>| values.found(field).filter(|length| of_workbook && *length < stock.L);
    let held = stays(&form::L4).unwrap_or(HELD.min(stock.L / 4.0));
    let faced = stays(&form::L5).filter(|faced| *faced < stock.L - held).unwrap_or(0.0);
    for (field, length) in [(&form::D, stock.D), (&form::L, stock.L), (&form::L4, held), (&form::L5, faced)] {
        values.put(field, Some(length));
    }
    values.put(&form::STOCK_BORE_D, stock.d);
}

/// What is assumed of the tailstock, and by which option it is said otherwise.
fn tailstock(values: &Values, asked: Option<Support>) -> Text {
    match asked {
        Some(Support::Always) => return t("con contrapunto (--tailstock yes)", "with the tailstock (--tailstock yes)"),
        Some(Support::Never) => return t("sin contrapunto (--tailstock no)", "without a tailstock (--tailstock no)"),
        Some(Support::ByOverhang) | None => {}
    }
    let Stock { D, L, .. } = stock_of(values);
    let overhang = L - values.found(&form::L4).unwrap_or_default();
    let beyond = Lathe::default().tailstock.beyond;
    let supported = overhang > beyond * D;
    let [overhang, most, ratio] = [overhang, beyond * D, beyond].map(|number| shown(number, 3));
    if supported {
        Text::new(
            format!(
                "con contrapunto, porque la barra sobresale {overhang} mm de las garras, más de {ratio}·D = {most} mm (si no lo hay: --tailstock no)"
            ),
            format!(
                "with a tailstock, because the bar sticks out of the jaws by {overhang} mm, more than {ratio}·D = {most} mm (if there is none: --tailstock no)"
            ),
        )
    } else {
        Text::new(
            format!(
                "sin contrapunto, porque la barra sobresale {overhang} mm de las garras, no más de {ratio}·D = {most} mm (si lo hay: --tailstock yes)"
            ),
            format!(
                "without a tailstock, because the bar sticks out of the jaws by {overhang} mm, not more than {ratio}·D = {most} mm (if there is one: --tailstock yes)"
            ),
        )
    }
}

fn stock_of(values: &Values) -> Stock {
    let length = |field| values.found(field).unwrap_or_default();
    Stock { D: length(&form::D), L: length(&form::L), d: values.found(&form::STOCK_BORE_D) }
}

/// A stock that holds the path at feed: its greatest diameter and its least Z, rounded up to whole millimetres, and what is
/// held in the jaws.
fn enclosing(values: &Values, program: &text::SheetProgram) -> Result<Stock, Refusal> {
    let given =
        Given::of(&Fields::of(&FORM, values.clone())?).map_err(|findings| Refusal { exit: Exit::Refused, findings })?;
    let (mut X, mut Z): (f64, f64) = (0.0, 0.0);
    let interpreter: Interpreter<'_> = program.read(given.setting());
    // No more than are followed.
    let motions = interpreter.flatten().take(FOLLOWED_MOTIONS);
    for motion in motions.filter(|motion| !matches!(motion.kind, MotionKind::Rapid | MotionKind::Dwell(_))) {
        X = X.max(motion.to.get(Axis::X).abs());
        Z = Z.min(motion.to.get(Axis::Z));
    }
    let X = if X > 0.0 { X } else { THICK };
    let D = (2.0 * X).ceil().clamp(1.0, STOCK_SIZE);
    let L = ((-Z).ceil() + BESIDE_JAWS + HELD).clamp(SHORTEST, STOCK_SIZE);
    Ok(Stock { D, L, d: None })
}

/// The subprograms that stand beside the program: those that its M98 name, and so on.
fn subprograms(main: &str, files: &mut SubprogramFiles) -> Result<BTreeMap<String, text::Lines>, Refusal> {
    let mut found = BTreeMap::new();
    let mut texts = vec![main.to_owned()];
    while let Some(text) = texts.pop() {
        for number in called(&text) {
            // All of them: the interpreter refuses two files of one number.
            for name in [format!("O{number:04}"), format!("o{number:04}"), format!("{number:04}"), number.to_string()] {
                if found.contains_key(&name) {
                    continue;
                }
                let unreadable = |reason: Text| {
                    let name = name.clone();
                    SubprogramUnreadable { name, reason }.refused(Exit::Unreadable, Place::File)
                };
                if let Some(bytes) = files.find(&name).map_err(unreadable)? {
                    let text = text::Lines::of_file(&decoded(&bytes));
                    texts.push(text.text.clone());
                    found.insert(name, text);
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
