//! What is tried on bytes by chance: each target takes any bytes, and must come back. What it looks at, it asserts.
//!
//! The same functions are run by the ordinary test (`main.rs`, a fixed seed and a count) and by `cargo fuzz`
//! (`fuzz_targets`).

use std::io::{Cursor, Write};

use rodete::escape::hidden;
use rodete::finding::{Exit, Finding, Grade, Refusal};
use rodete::gcode::control::{self, Control};
use rodete::gcode::interpreter::{DecimalPoint, Interpreter, Setting, decoded, findings, tool_table};
use rodete::gcode::motion::{Motion, MotionKind};
use rodete::kind::{Provenance, Wants};
use rodete::kinds::lathe::setup::Given;
use rodete::kinds::lathe::{self, Simulated};
use rodete::kinds::lathe::{cases, parameters, text};
use rodete::kinds::{self, KINDS};
use rodete::machine::axis::Axis;
use rodete::machine::length_unit::LengthUnit;
use rodete::machine::var_file::VarFile;
use rodete::parameter::field::Fields;
use rodete::parameter::{Form, Value, Values};
use rodete::proof::account::Account;
use rodete::removal::turning::simulation::{Setup, Simulation};
use rodete::text::Language;
use rodete::workbook;
use zip::CompressionMethod;
use zip::write::SimpleFileOptions;

/// No coordinate that is handed on is greater, mm or degrees: what is written is bounded, and what is added up as well.
const FARTHEST: f64 = 1e12;

/// What a target counted: so many readings, and the blocks or sweeps that they took.
#[derive(Clone, Copy, Debug, Default)]
pub struct Work {
    /// Programs, workbooks or files that were read.
    pub read: u64,
    /// Motions that came of them.
    pub motions: u64,
}

/// A message in both languages, and of a stop a remedy.
fn said(found: &[Finding]) {
    for finding in found {
        assert!(!finding.what.es.is_empty() && !finding.what.en.is_empty(), "{finding:?}");
        assert!(finding.grade != Grade::Stop || !finding.remedy.en.is_empty(), "{finding:?}");
        for text in [&finding.what.es, &finding.what.en] {
            assert!(text.len() < 4_000, "a message of {} bytes", text.len());
            assert!(!text.chars().any(hidden), "{text:?}");
        }
    }
}

/// A refusal has a reason, and it is not rodete's own fault.
fn reasoned(refusal: &Refusal) {
    assert!(refusal.findings.iter().any(|finding| finding.grade == Grade::Stop), "{refusal:?}");
    assert!(refusal.exit != Exit::Fault, "{refusal:?}");
    said(&refusal.findings);
}

/// What is handed on is a number, and within bounds.
fn sound(motion: &Motion) {
    for axis in Axis::ALL {
        for pose in [&motion.to, &motion.machine] {
            assert!(pose.get(axis).abs() <= FARTHEST, "{motion:?}");
        }
    }
    if let MotionKind::Feed(feed) | MotionKind::Arc(_, feed) = motion.kind {
        assert!(feed.value >= 0.0 && feed.value <= FARTHEST, "{motion:?}");
    }
    assert!(motion.seconds.is_none_or(|seconds| seconds >= 0.0 && seconds.is_finite()), "{motion:?}");
}

fn read(setting: Setting, bytes: &[u8], work: &mut Work) {
    let mut interpreter = Interpreter::new(Box::new(Cursor::new(bytes.to_vec())), setting);
    let start = interpreter.position().1;
    let (mut account, mut before) = (Account::default(), start);
    let (mut faults, mut total) = (Vec::new(), 0);
    let lines = 1 + bytes.iter().filter(|byte| matches!(byte, b'\n' | b'\r')).count();
    for item in interpreter.by_ref() {
        match item {
            Ok(motion) => {
                sound(&motion);
                assert!(motion.line <= lines, "{motion:?}");
                account.take(&motion, &before);
                before = motion.machine;
                work.motions += 1;
            }
            Err(fault) => {
                total += 1;
                if faults.len() < 50 {
                    faults.push(*fault);
                }
            }
        }
    }
    assert!(account.seconds.is_finite() && account.feed_path.is_finite(), "{account:?}");
    said(&findings(faults, total, interpreter.remarks()));
    work.read += 1;
}

/// A program, under every dialect.
pub fn program(bytes: &[u8]) -> Work {
    let mut work = Work::default();
    for control in control::ALL {
        let mut setting = Setting::new(control);
        setting.decimal_point = Some(DecimalPoint::Calculator);
        setting.budget.repeated_blocks = 20_000;
        read(setting, bytes, &mut work);
    }
    work
}

/// A turning program over its stock, shown to the viewer as well. The first line gives diameter and length of the
/// stock in mm and the dialect's place in the list: `50 100 0`.
pub fn simulate(bytes: &[u8]) -> Work {
    let text = decoded(bytes);
    let (first, rest) = text.split_once('\n').unwrap_or((&text, ""));
    let mut words = first.split_whitespace().map(|word| word.parse::<f64>().unwrap_or(0.0));
    let mut size = |most: f64| words.next().filter(|size| *size >= 1.0 && *size <= most);
    let (D, L) = (size(1000.0).unwrap_or(50.0), size(1000.0).unwrap_or(100.0));
    let control: &Control = if first.ends_with('1') { &control::FAGOR_8055_T } else { &control::FANUC_LATHE_A };
    let mut values = Values { language: Language::En, ..Values::default() };
    values.values.extend(cases::CASES[0].values(Language::En));
    values.lists.push(cases::turret(Language::En));
    values.values.insert("dialect", Value::Choice(control.name));
    values.values.insert("point", Value::Choice("calculator"));
    values.values.insert("D", Value::Real(D));
    values.values.insert("L", Value::Real(L));
    values.values.insert("L4", Value::Real(L / 4.0));
    values.values.insert("L5", Value::Real(0.0));
    let program =
        text::SheetProgram { main: text::Lines::of_file(rest), subprograms: std::collections::BTreeMap::new() };
    let Some(motions) = followed(&values, &program) else { return Work { read: 1, motions: 0 } };
    let source = Provenance { workbook: "fuzz.nc".to_owned(), sha256: "0".repeat(64), version: "0" };
    let fields = Fields::of(&parameters::FORM, values).expect("fields");
    match lathe::simulated(fields, source, Some(program), Wants { scene: true, ..Wants::default() }) {
        Ok(Simulated { outcome, .. }) => {
            said(&outcome.findings);
            for quantity in &outcome.quantities {
                assert!(quantity.value.is_finite(), "{quantity:?}");
            }
        }
        Err(refusal) => reasoned(&refusal),
    }
    Work { read: 1, motions }
}

/// What a program over its stock may cost here, in steps of work: a five-hundredth of what a user's program may.
const MOST_WORK: u64 = 800_000;

/// Follows a program within a small budget, and counts its motions. `None` where the budget ends before the program.
fn followed(values: &Values, program: &text::SheetProgram) -> Option<u64> {
    let Ok(fields) = Fields::of(&parameters::FORM, values.clone()) else { return Some(0) };
    let Ok(given) = Given::of(&fields) else { return Some(0) };
    let setup = Setup { most_work: MOST_WORK, ..given.setup.clone() };
    let Ok(mut simulation) = Simulation::new(setup) else { return Some(0) };
    let mut setting = given.setting();
    setting.budget.repeated_blocks = 2_000;
    let mut interpreter = program.read(setting);
    let mut motions = 0;
    while let Some(item) = interpreter.next() {
        let Ok(motion) = item else { continue };
        sound(&motion);
        let step = simulation.take(&motion, &interpreter.in_force().clone());
        assert!(step.removed.volume.is_finite() && step.cutting_speed.is_finite() && step.depth.is_finite());
        motions += 1;
        // The last motion may begin within the budget; a turn of a thread counts twelve times.
        assert!(simulation.work() < 13 * MOST_WORK, "{}", simulation.work());
        if simulation.is_spent() {
            return None;
        }
    }
    Some(motions)
}

/// LinuxCNC's parameter file: what is taken is written as it was read.
pub fn var_file(bytes: &[u8]) -> Work {
    match VarFile::parse(bytes) {
        Ok(file) => {
            let again = VarFile::parse(file.text().as_bytes());
            assert_eq!(again.ok().as_ref(), Some(&file));
        }
        Err(refusal) => reasoned(&refusal),
    }
    Work { read: 1, motions: 0 }
}

/// LinuxCNC's tool table, in both units.
pub fn tools(bytes: &[u8]) -> Work {
    for unit in [LengthUnit::Millimetre, LengthUnit::Inch] {
        match tool_table::parse(bytes, unit) {
            Ok(tools) => {
                for tool in tools.values() {
                    assert!(tool.diameter.is_finite(), "{tool:?}");
                    assert!(Axis::ALL.into_iter().all(|axis| tool.offset.get(axis).is_finite()), "{tool:?}");
                }
            }
            Err(refusal) => reasoned(&refusal),
        }
    }
    Work { read: 2, motions: 0 }
}

/// A workbook's package. Bytes that begin as a ZIP archive does are taken as they are; others are parts with a line
/// `=== name` before each, and are packed, so that chance gets past the checksums.
pub fn package(bytes: &[u8]) -> Work {
    if bytes.starts_with(b"PK") {
        return book(bytes);
    }
    let text = String::from_utf8_lossy(bytes);
    let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
    for part in text.split("=== ").skip(1) {
        let (name, content) = part.split_once('\n').unwrap_or((part, ""));
        if archive.start_file(name, options).is_ok() {
            let _ = archive.write_all(content.as_bytes());
        }
    }
    archive.finish().map_or(Work::default(), |packed| book(&packed.into_inner()))
}

fn book(bytes: &[u8]) -> Work {
    let forms: Vec<_> = KINDS.iter().map(|kind| kind.form()).collect();
    match workbook::read(bytes, &forms) {
        Ok(filled) => {
            said(&filled.findings);
            design(filled.form, filled.values);
        }
        Err(refusal) => reasoned(&refusal),
    }
    Work { read: 1, motions: 0 }
}

/// The values of a form that was read: computed, or refused with a reason.
pub fn design(form: &'static Form, values: Values) {
    let source = Provenance { workbook: "fuzz.xlsx".to_owned(), sha256: "0".repeat(64), version: "0" };
    match kinds::run(form, values, source) {
        Ok(outcome) => {
            said(&outcome.findings);
            assert!(outcome.exit() != Exit::Fault, "{:?}", outcome.findings);
            if !outcome.stopped() {
                for quantity in &outcome.quantities {
                    assert!(quantity.value.is_finite(), "{quantity:?}");
                }
            }
        }
        Err(refusal) => reasoned(&refusal),
    }
}
