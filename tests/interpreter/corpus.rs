//! The programs of `tests/gcode`. `good/NAME.ngc` runs with `NAME.var` where there is one; `bad/NAME.ngc` says on its
//! first lines what rodete says of it, `; expected: LINE:COLUMN PART OF THE MESSAGE` (column, or both, may be missing), and
//! what rs274 does, `; rs274: refuses`, `accepts` or `hangs`. All have the tool table `tools.tbl`.

use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::agreement::agree;
use crate::common::rs274::{self, Judge, Refused};
use crate::ours;

/// The offsets that outlive a program: G28 and G30, G92, the work offsets.
const KEPT: std::ops::RangeInclusive<u16> = 5161..=5390;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/gcode")
}

pub fn tools() -> String {
    std::fs::read_to_string(folder().join("tools.tbl")).unwrap()
}

/// A program by its name in `good`, with its variable file.
pub fn good(name: &str) -> (Vec<u8>, Option<String>) {
    let path = folder().join("good").join(name);
    (std::fs::read(path.with_extension("ngc")).unwrap(), std::fs::read_to_string(path.with_extension("var")).ok())
}

/// The names of the programs in a folder.
pub fn names(of: &str) -> Vec<String> {
    let mut names: Vec<_> = std::fs::read_dir(folder().join(of))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "ngc"))
        .map(|path| path.file_stem().unwrap().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

/// Runs a program with both: the same motions, and the same offsets left behind.
pub fn judge(program: &[u8], judge: Judge) -> Result<(), String> {
    let theirs = judge.run(program).map_err(|refused| format!("rs274: {refused:?}"))?;
    let (motions, var) = ours::run(program, &judge).map_err(|fault| format!("ours: {fault}"))?;
    agree(&motions, &theirs.motions)?;
    for (number, theirs) in theirs.var.range(KEPT) {
        let ours = var.get(number).copied().unwrap_or_default();
        // rs274 writes six decimals.
        if (ours - theirs).abs() > 0.000_001 {
            return Err(format!("#{number} is left at {ours}, by rs274 at {theirs}"));
        }
    }
    Ok(())
}

#[test]
fn good_programs_move_as_in_linuxcnc() {
    if !rs274::is_here() {
        return;
    }
    let tools = tools();
    let names = names("good");
    assert!(names.len() > 80, "{} programs", names.len());
    let mut faults = Vec::new();
    for name in names {
        let (program, var) = good(&name);
        for block_delete in [false, true] {
            let with = Judge { var: var.as_deref(), tools: Some(&tools), block_delete, ..Judge::default() };
            if let Err(fault) = judge(&program, with) {
                faults.push(format!("{name}{}: {fault}", if block_delete { " without /" } else { "" }));
            }
        }
    }
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults.join("\n"));
}

/// What the first lines of a bad program say.
struct Expected {
    line: Option<usize>,
    column: Option<usize>,
    message: String,
    rs274: String,
}

impl Expected {
    fn of(program: &[u8]) -> Self {
        let text = String::from_utf8_lossy(program);
        let mut lines = text.lines();
        let expected = lines.next().and_then(|line| line.strip_prefix("; expected: ")).expect("; expected: …");
        let rs274 = lines.next().and_then(|line| line.strip_prefix("; rs274: ")).expect("; rs274: …");
        let (place, message) = expected.split_once(' ').unwrap_or((expected, ""));
        let mut numbers = place.split(':').map(str::parse);
        let (line, message) = match numbers.next() {
            Some(Ok(line)) => (Some(line), message),
            _ => (None, expected),
        };
        let column = line.and_then(|_| numbers.next()).map(|column| column.expect("a column"));
        assert!(!message.is_empty(), "a part of the message");
        Self { line, column, message: message.to_owned(), rs274: rs274.to_owned() }
    }
}

#[test]
fn bad_programs_are_refused_at_their_place() {
    let tools = tools();
    let names = names("bad");
    assert!(names.len() > 150, "{} programs", names.len());
    let mut faults = Vec::new();
    for name in names {
        let program = std::fs::read(folder().join("bad").join(&name).with_extension("ngc")).unwrap();
        let expected = Expected::of(&program);
        match ours::run(&program, &Judge { tools: Some(&tools), ..Judge::default() }) {
            Ok((motions, _)) => faults.push(format!("{name}: taken, with {} motions", motions.len())),
            Err(fault) => {
                let elsewhere = expected.line.is_some_and(|line| line != fault.line)
                    || expected.column.is_some_and(|column| fault.columns.first() != Some(&column));
                if elsewhere || !fault.message.contains(&expected.message) {
                    faults.push(format!("{name}: {fault}"));
                }
            }
        }
    }
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn what_is_said_of_rs274_and_bad_programs_is_true() {
    if !rs274::is_here() {
        return;
    }
    let tools = tools();
    let mut faults = Vec::new();
    for name in names("bad") {
        let program = std::fs::read(folder().join("bad").join(&name).with_extension("ngc")).unwrap();
        let expected = Expected::of(&program).rs274;
        // Long enough for what ends at all, short for what writes without end.
        let deadline = Duration::from_millis(if expected == "hangs" { 500 } else { 10_000 });
        let said = match (Judge { tools: Some(&tools), deadline, ..Judge::default() }).run(&program) {
            Ok(_) => "accepts",
            Err(Refused::Error(..)) => "refuses",
            Err(Refused::Deadline) => "hangs",
        };
        if said != expected {
            faults.push(format!("{name}: rs274 {said}"));
        }
    }
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults.join("\n"));
}
