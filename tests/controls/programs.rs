//! The programs of every control, in the folder that has its name. `good/NAME` is read without a refusal; where a comment
//! of it says `ends: X1 Y2 Z-3`, in the axes' own words and mm or degrees, its last motion ends there. `bad/NAME` says in a
//! comment on its first line, or behind that of `%`, what rodete says of it, `expected: LINE:COLUMN PART OF THE MESSAGE`, without a
//! column where the block as a whole is refused. All have the control's `tools.tbl` and `machine.var` where there are any, in millimetres, or the
//! parameters in `good/NAME.var`. Nothing else that stands there is asked here: LinuxCNC's are held against LinuxCNC in
//! `tests/reading/interpreter/corpus.rs`, `clean` is followed over its stock in `tests/turning/lathe.rs`.

use std::fs;
use std::path::{Path, PathBuf};

use rodete::gcode::control::{ALL, Control};
use rodete::gcode::interpreter::{Interpreter, Refused, Setting, tool_table};
use rodete::gcode::motion::Motion;
use rodete::machine::axis::Axis;
use rodete::machine::length_unit::LengthUnit;
use rodete::machine::var_file::VarFile;
use rodete::number::grid::Milli;

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

/// The motions of a program, and its refusals.
fn read(control: &'static Control, program: &Path) -> (Vec<Motion>, Vec<Refused>) {
    let (mut motions, mut faults) = (Vec::new(), Vec::new());
    for item in Interpreter::over(&fs::read(program).unwrap(), setting(control, program)) {
        match item {
            Ok(motion) => motions.push(motion),
            Err(fault) => faults.push(*fault),
        }
    }
    (motions, faults)
}

/// Place and part of the message that the first line of a bad program says.
fn expected(program: &Path) -> (String, String) {
    let text = fs::read(program).unwrap();
    let first =
        String::from_utf8_lossy(&text).lines().find(|line| !line.starts_with('%')).unwrap_or_default().to_owned();
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

/// Where the last motion of a good program is to end, by the axes' letters; nothing where no comment says it.
fn ends(program: &Path) -> Vec<(Axis, f64)> {
    let text = fs::read(program).unwrap();
    let text = String::from_utf8_lossy(&text).into_owned();
    let said = text.lines().find_map(|line| line.split_once("ends: ")).map(|(_, said)| said).unwrap_or_default();
    let words = said.trim_end().trim_end_matches(')').split_whitespace();
    let word = |word: &str| -> Option<(Axis, f64)> {
        let axis = Axis::ALL.into_iter().find(|axis| word.starts_with(axis.letter()))?;
        Some((axis, word[1..].parse().ok()?))
    };
    words
        .map(|one| word(one).unwrap_or_else(|| panic!("{}: {one} names no axis and place", program.display())))
        .collect()
}

/// What is wrong with the end of a program's motions, by the words of its control: X may be a diameter.
fn elsewhere(control: &Control, motions: &[Motion], ends: &[(Axis, f64)]) -> Vec<String> {
    let Some(last) = motions.last() else { return vec!["no motion".to_owned()] };
    let milli = |value: f64| Milli::round(value).expect("a place that a program may carry");
    ends.iter()
        .filter_map(|&(axis, said)| {
            let at = milli(last.to.get(axis));
            let at = if axis == Axis::X { control.axes.x.word(at) } else { at };
            (at != milli(said)).then(|| format!("{}{} and not {said}", axis.letter(), at.value()))
        })
        .collect()
}

#[test]
fn good_programs_of_every_control_are_read_and_end_where_they_say() {
    for control in ALL {
        let (mut moving, mut ending) = (false, false);
        for program in programs(control, "good") {
            let (motions, faults) = read(control, &program);
            assert!(faults.is_empty(), "{}: {faults:?}", program.display());
            let ends = ends(&program);
            if !ends.is_empty() {
                assert_eq!(elsewhere(control, &motions, &ends), [""; 0], "{} ends elsewhere", program.display());
            }
            moving |= !motions.is_empty();
            ending |= !ends.is_empty();
        }
        assert!(moving, "{}: none of its programs moves", control.name);
        assert!(
            ending,
            "{}: none of its good programs says in a comment where it ends, as ends: X10 Z-5",
            control.name
        );
    }
    // A place that is not reached is told.
    let control = Control::named("fagor-8055-t").expect("a lathe");
    let (motions, _) = read(control, &folder(control).join("good/diameter.nc"));
    assert_eq!(elsewhere(control, &motions, &[(Axis::X, 10.0), (Axis::Z, -10.0)]), ["X20 and not 10"]);
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
