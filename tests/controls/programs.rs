//! The programs of every control, in the folder that has its name. `good/NAME` is read without a refusal. `bad/NAME` says in a
//! comment on its first line, or behind `%`, what rodete says of it, `expected: LINE:COLUMN PART OF THE MESSAGE`, without a
//! column where the block as a whole is refused. All have the control's `tools.tbl` and `machine.var` where there are any, in millimetres, or the
//! parameters in `good/NAME.var`. Nothing else that stands there is asked here: LinuxCNC's are held against LinuxCNC in
//! `tests/reading/interpreter/corpus.rs`, `clean` is followed over its stock in `tests/turning/lathe.rs`.

use std::fs;
use std::path::{Path, PathBuf};

use rodete::gcode::control::{ALL, Control};
use rodete::gcode::interpreter::{Interpreter, Refused, Setting, tool_table};
use rodete::machine::length_unit::LengthUnit;
use rodete::machine::var_file::VarFile;

fn folder(control: &Control) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/controls").join(control.name)
}

fn programs(control: &Control, of: &str) -> Vec<PathBuf> {
    let folder = folder(control).join(of);
    let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut found: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    found.retain(|path| path.extension().is_some_and(|ending| ending == "nc" || ending == "ngc"));
    found.sort();
    assert!(!found.is_empty(), "{} holds no program", folder.display());
    found
}

fn setting(control: &'static Control, program: &Path) -> Setting {
    let mut setting = Setting::new(control);
    // A debug build takes its time.
    setting.budget.repeated_blocks = 20_000;
    let tools = fs::read(folder(control).join("tools.tbl")).ok();
    setting.tools = tools.map(|tools| tool_table::parse(&tools, LengthUnit::Millimetre).unwrap());
    let var = fs::read(program.with_extension("var")).or_else(|_| fs::read(folder(control).join("machine.var")));
    setting.var_file = var.map_or_else(|_| VarFile::default(), |var| VarFile::parse(&var).unwrap());
    setting
}

/// How many motions a program has, and its refusals.
fn read(control: &'static Control, program: &Path) -> (usize, Vec<Refused>) {
    let (mut motions, mut faults) = (0, Vec::new());
    for item in Interpreter::over(&fs::read(program).unwrap(), setting(control, program)) {
        match item {
            Ok(_) => motions += 1,
            Err(fault) => faults.push(*fault),
        }
    }
    (motions, faults)
}

/// Place and part of the message that the first line of a bad program says.
fn expected(program: &Path) -> (String, String) {
    let text = fs::read(program).unwrap();
    let first = String::from_utf8_lossy(&text).lines().find(|line| *line != "%").unwrap_or_default().to_owned();
    let said = first
        .trim_start_matches(['\u{feff}', ';', '(', ' '])
        .strip_prefix("expected: ")
        .and_then(|said| said.split_once(' '));
    let (place, message) = said.unwrap_or_else(|| panic!("{}: {first}", program.display()));
    // A parenthesis that the comment opened.
    let message = if first.starts_with('(') { message.strip_suffix(')').unwrap_or(message) } else { message };
    assert!(message.trim().len() > 3, "{}: a part of the message", program.display());
    (place.to_owned(), message.trim_end().to_owned())
}

#[test]
fn good_programs_of_every_control_are_read() {
    for control in ALL {
        for program in programs(control, "good") {
            let (_, faults) = read(control, &program);
            assert!(faults.is_empty(), "{}: {faults:?}", program.display());
        }
        let moving = |program: &PathBuf| read(control, program).0 > 0;
        assert!(programs(control, "good").iter().any(moving), "{}: none of its programs moves", control.name);
    }
}

#[test]
fn bad_programs_of_every_control_are_refused_at_the_place_and_with_the_message_that_they_say() {
    let (mut faults, mut programs_read) = (Vec::new(), 0);
    for control in ALL {
        for program in programs(control, "bad") {
            programs_read += 1;
            let (place, message) = expected(&program);
            let (_, refused) = read(control, &program);
            let Some(fault) = refused.first() else {
                faults.push(format!("{}: taken", program.display()));
                continue;
            };
            let column = fault.columns.first().map(|column| format!(":{column}")).unwrap_or_default();
            let (at, what) = (format!("{}{column}", fault.line), fault.message());
            let said = format!("{}; {}", what.en, fault.remedy.en);
            if at != place || !said.contains(&message) {
                faults.push(format!("{}: {at} {said}", program.display()));
            }
            for text in [&what, &fault.remedy] {
                assert!(!text.es.is_empty() && !text.en.is_empty(), "{}: both languages", program.display());
            }
            assert_ne!(fault.what.es, fault.what.en, "{}: Spanish", program.display());
        }
    }
    assert!(programs_read > 350, "{programs_read} programs");
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults.join("\n"));
}
