//! The programs of `tests/controls/linuxcnc` against LinuxCNC. `good/NAME.ngc` runs with `NAME.var` where there is one.
//! `bad/NAME.ngc` says on its second line what rs274 does: `; rs274: refuses`, or `accepts: ` or `hangs: ` and why rodete is
//! stricter. `wider/NAME.ngc` says on its first line why rodete takes what rs274 refuses. All have the tool table `tools.tbl`.
//! What rodete says of each is asked with those of the other controls, in `tests/controls/programs.rs`.

use std::path::{Path, PathBuf};
use std::time::Duration;

use rodete::gcode::motion::Motion;
use rodete::machine::var_file::VarFile;

use super::agreement::agree;
use super::common::rs274::{self, Canon, Judge, Refused};
use super::{kept, ours};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/controls/linuxcnc")
}

pub fn tools() -> String {
    std::fs::read_to_string(folder().join("tools.tbl")).unwrap()
}

/// A program by its name in `good`, with its variable file.
pub fn good(name: &str) -> (Vec<u8>, Option<String>) {
    let file = |extension: &str| folder().join("good").join(format!("{name}.{extension}"));
    (std::fs::read(file("ngc")).unwrap(), std::fs::read_to_string(file("var")).ok())
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
    same(&motions, &var, &theirs)
}

/// Whether the motions and the offsets left behind are the same.
pub fn same(motions: &[Motion], var: &VarFile, theirs: &Canon) -> Result<(), String> {
    agree(motions, &theirs.motions)?;
    kept::same(&kept::offsets(var), &kept::offsets(&kept::parsed(&theirs.var)))
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

/// What the second line of a bad program says of rs274: `; rs274: refuses`, or another word and why rodete is stricter.
fn said_of_rs274(name: &str, program: &[u8]) -> String {
    let text = String::from_utf8_lossy(program);
    let said = text.lines().filter(|line| *line != "%").nth(1).and_then(|line| line.strip_prefix("; rs274: "));
    let said = said.unwrap_or_else(|| panic!("{name}: ; rs274: …")).trim();
    let (rs274, reason) = said.split_once(": ").map_or((said, None), |(rs274, reason)| (rs274, Some(reason)));
    assert_eq!(reason.is_some_and(|reason| reason.len() > 10), rs274 != "refuses", "{name}: why rodete is stricter");
    rs274.to_owned()
}

#[test]
fn what_is_said_of_rs274_and_bad_programs_is_true() {
    let tools = tools();
    let mut faults = Vec::new();
    for name in names("bad") {
        let program = std::fs::read(folder().join("bad").join(format!("{name}.ngc"))).unwrap();
        let expected = said_of_rs274(&name, &program);
        if !rs274::is_here() {
            continue;
        }
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

#[test]
fn what_rodete_takes_and_rs274_refuses_is_named() {
    let tools = tools();
    let judge = Judge { tools: Some(&tools), ..Judge::default() };
    let names = names("wider");
    assert!(!names.is_empty());
    for name in names {
        let program = std::fs::read(folder().join("wider").join(format!("{name}.ngc"))).unwrap();
        assert!(program.starts_with(b"; "), "{name}: why");
        ours::run(&program, &judge).unwrap_or_else(|fault| panic!("{name}: {fault}"));
        if rs274::is_here() {
            assert!(matches!(judge.run(&program), Err(Refused::Error(..))), "{name}: rs274 takes it");
        }
    }
}
