//! Every row is raised by its own example, at its place, and by nothing graver: the test of what the interpreter alone
//! tells, and of what a row must have whatever its room.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::{self, BufRead, Read, Seek, SeekFrom};
use std::path::Path;

use rodete::cli::rows;
use rodete::finding::answer::answer;
use rodete::finding::{Datum, Example, Finding, Grade, Place, Rule};
use rodete::gcode::control::guess::tools_headed;
use rodete::gcode::control::{Control, RotaryMode};
use rodete::gcode::interpreter::{self, DecimalPoint, Files, HolePlane, Interpreter, Setting, tool_table};
use rodete::gcode::rules::flow::FollowingErrors;
use rodete::gcode::rules::lexis::MoreRefusals;
use rodete::gcode::turning::rules::CornerTwice;
use rodete::kinds::KINDS;
use rodete::limits::{BLOCK_NUMBERS, LISTED_REFUSALS, SUBPROGRAM_BYTES};
use rodete::machine::length_unit::LengthUnit;
use rodete::machine::var_file::VarFile;
use rodete::proof::account::drift;
use rodete::text::Text;

fn rules() -> impl Iterator<Item = &'static Rule> {
    rows(KINDS).into_iter()
}

/// Subprograms by the name of their file.
struct Beside(BTreeMap<&'static str, &'static str>);

impl Files for Beside {
    fn find(&mut self, name: &str) -> Result<Option<Vec<u8>>, Text> {
        Ok(self.0.get(name).map(|text| text.replace('|', "\n").into_bytes()))
    }
}

/// What a program is read with.
fn setting(control: &str, given: &[(&'static str, &'static str)]) -> Setting {
    let mut setting = Setting::new(Control::named(control).unwrap());
    setting.budget.repeated_blocks = 20_000;
    let mut files = BTreeMap::new();
    for (option, value) in given {
        match *option {
            "--tools" => {
                let table = value.replace('|', "\n");
                setting.tools = tool_table::parse(table.as_bytes(), setting.unit).ok();
            }
            "--block-delete" => setting.block_delete = true,
            "--var" => setting.var_file = VarFile::parse(value.replace('|', "\n").as_bytes()).unwrap(),
            "--decimal-point" => {
                assert!(["calculator", "micrometre"].contains(value), "{value}");
                let calculator = *value == "calculator";
                setting.decimal_point =
                    Some(if calculator { DecimalPoint::Calculator } else { DecimalPoint::Micrometre });
            }
            "--hole-r" => {
                assert!(["absolute", "incremental"].contains(value), "{value}");
                setting.hole_plane =
                    Some(if *value == "absolute" { HolePlane::Absolute } else { HolePlane::Incremental });
            }
            "--rotary" => {
                assert!(["linear", "rollover"].contains(value), "{value}");
                setting.rotary = if *value == "linear" { RotaryMode::Linear } else { RotaryMode::Rollover };
            }
            file => {
                assert!(!file.starts_with('-'), "{file}");
                files.insert(*option, *value);
            }
        }
    }
    setting.files = Box::new(Beside(files));
    setting
}

/// What a tool table is refused for.
fn refused_table(given: &[(&'static str, &'static str)]) -> Option<Vec<Finding>> {
    let (_, table) = given.iter().find(|(option, _)| *option == "--tools")?;
    let read = tool_table::parse(table.replace('|', "\n").as_bytes(), LengthUnit::Millimetre);
    read.err().map(|refusal| refusal.findings)
}

/// All that is told of a program.
fn told(program: &str, setting: Setting) -> Vec<Finding> {
    told_by(Interpreter::over(program.as_bytes(), setting))
}

/// All that an interpreter tells.
fn told_by(mut interpreter: Interpreter<'_>) -> Vec<Finding> {
    let start = interpreter.position().1;
    let mut faults: Vec<_> = interpreter.by_ref().filter_map(Result::err).map(|fault| *fault).collect();
    let total = faults.len();
    faults.truncate(LISTED_REFUSALS);
    let mut findings = interpreter::findings(faults, total, interpreter.remarks());
    findings.extend(drift(&interpreter, &start));
    findings
}

/// Programs that are read elsewhere.
const OTHERS: [&str; 3] = ["program-beyond-memory", "program-many-alarms", "program-many-motions"];

/// Bytes of a program, line by line alike, from a disk that fails behind so many of them.
struct Disk {
    line: Vec<u8>,
    at: u64,
    fails: u64,
}

impl Read for Disk {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let taken = self.fill_buf()?.read(bytes)?;
        self.consume(taken);
        Ok(taken)
    }
}

impl BufRead for Disk {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        // EIO
        if self.at >= self.fails { Err(io::Error::from_raw_os_error(5)) } else { Ok(&self.line[self.column()..]) }
    }

    fn consume(&mut self, taken: usize) {
        self.at += taken as u64;
    }
}

impl Seek for Disk {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        match to {
            SeekFrom::Start(to) => self.at = to,
            SeekFrom::End(_) | SeekFrom::Current(_) => panic!("{to:?}"),
        }
        Ok(self.at)
    }
}

impl Disk {
    fn column(&self) -> usize {
        usize::try_from(self.at % self.line.len() as u64).unwrap()
    }
}

/// Subprograms of one text, or a disk that fails.
struct Subprogram(Result<Vec<u8>, Text>);

impl Files for Subprogram {
    fn find(&mut self, _: &str) -> Result<Option<Vec<u8>>, Text> {
        self.0.clone().map(Some)
    }
}

/// What is told of the program of an example's key.
fn told_made(key: &str) -> Vec<Finding> {
    let of_disk = |control, line: &[u8], fails| {
        let disk = Disk { line: line.to_owned(), at: 0, fails };
        told_by(Interpreter::new(Box::new(disk), setting(control, &[])))
    };
    let calling = |found| {
        let files = Box::new(Subprogram(found));
        told("G21 G90 F100\nO<hole> CALL\nM2\n", Setting { files, ..setting("linuxcnc", &[]) })
    };
    match key {
        "program-long-contour" => {
            let head = "S500 M3 F.2\nG0 X50. Z5.\nG71 U2. R1.\nG71 P10 Q20\nN10 G0 X20.\n";
            let program = format!("{head}{}N20 X50.\nM30\n", "G1 W-.001\n".repeat(10_000));
            told(&program, setting("fanuc-lathe-a", &[]))
        }
        "program-unreadable" => of_disk("linuxcnc", b"G21 G90 G0 X1\n", 100),
        "program-too-large" => {
            // No longer than LinuxCNC takes a line.
            let mut line = vec![b' '; 251];
            line[250] = b'\n';
            of_disk("linuxcnc", &line, u64::MAX)
        }
        "program-utf16" => {
            let wide: Vec<u8> = "\u{feff}G21\nM2\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
            told_by(Interpreter::over(&wide, setting("linuxcnc", &[])))
        }
        "program-many-numbers" => {
            let numbers: String = (1..=BLOCK_NUMBERS + 1).map(|number| format!("N{number}\n")).collect();
            told(&format!("G21 G98\nM97 P1\nM30\n{numbers}"), setting("fanuc-lathe-a", &[]))
        }
        "program-subprogram-unreadable" => calling(Err(answer(&io::Error::from_raw_os_error(5)))),
        "program-subprogram-large" => calling(Ok(vec![b'\n'; SUBPROGRAM_BYTES + 1])),
        _ => panic!("nobody makes {key}"),
    }
}

/// A place of a program as an example says it.
fn place(finding: &Finding) -> String {
    match &finding.place {
        Place::Line { line, columns } => match columns.first() {
            Some(column) => format!("{line}:{column}"),
            None => line.to_string(),
        },
        Place::Subprogram { file, line, columns } => match columns.first() {
            Some(column) => format!("{file}:{line}:{column}"),
            None => format!("{file}:{line}"),
        },
        _ => String::new(),
    }
}

#[test]
fn the_program_of_every_row_raises_it_at_its_place_and_nothing_graver() {
    let mut wrong = Vec::new();
    for rule in rules() {
        let (findings, at) = match rule.example {
            Example::Program { control, program, at, given } => {
                let program = program.replace('|', "\n");
                let headed = tools_headed(program.as_bytes());
                let read = || told(&program, Setting { headed, ..setting(control, given) });
                (refused_table(given).unwrap_or_else(read), Some(at))
            }
            Example::Repeated { control, word, times } => {
                let program = word.repeat(usize::try_from(times).unwrap()).replace('|', "\n");
                (told(&program, setting(control, &[])), None)
            }
            Example::Made { key, .. } if key.starts_with("program-") && !OTHERS.contains(&key) => {
                (told_made(key), None)
            }
            _ => continue,
        };
        let own = findings.iter().find(|finding| finding.is(rule) && at.is_none_or(|at| at == place(finding)));
        // A count of refusals stands behind them.
        let counts = [MoreRefusals::RULE, FollowingErrors::RULE].contains(&rule);
        let graver = !counts && findings.iter().any(|finding| finding.grade > rule.grade);
        let whole = own.is_some_and(|own| {
            let names: Vec<&str> = own.data.iter().map(|(name, _)| *name).collect();
            // What lies in several lines carries them behind its fields.
            assert!(matches!(names.strip_prefix(rule.fields), Some([] | ["lines"])), "{} {names:?}", rule.code);
            super::told::compare_finding(rule, own);
            own.grade <= rule.grade
                && (at.is_none_or(str::is_empty) || !place(own).is_empty())
                && !own.what.en.contains(['{', '}'])
        });
        if !whole || graver {
            let told: Vec<_> = findings
                .iter()
                .map(|one| {
                    let code = one.rule().code;
                    format!("    {} {code} {:?} {}", place(one), one.grade, one.what.en)
                })
                .collect();
            wrong.push(format!("{} {} at {at:?}:\n{}", rule.code, rule.ident, told.join("\n")));
        }
    }
    assert!(wrong.is_empty(), "{} rows\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn codes_are_one_rows_alone_and_their_texts_whole() {
    let mut codes = BTreeSet::new();
    let mut idents = BTreeMap::new();
    for rule in rules() {
        assert!(codes.insert(rule.code), "{} is given twice", rule.code);
        let (letter, digits) = rule.code.split_at(1);
        assert!(letter.chars().all(|one| one.is_ascii_uppercase()) && digits.len() == 4, "{}", rule.code);
        assert!(digits.chars().all(|one| one.is_ascii_digit()), "{}", rule.code);
        assert_eq!(idents.insert((letter, rule.ident), rule.code), None, "{}", rule.code);
        for text in [&rule.what, &rule.why] {
            assert!(!text.es.is_empty() && !text.en.is_empty(), "{}", rule.code);
        }
        assert!(
            rule.why.es != rule.why.en && rule.why.es.ends_with('.') && rule.why.en.ends_with('.'),
            "{}",
            rule.code
        );
        assert_eq!(rule.remedy.es.is_empty(), rule.remedy.en.is_empty(), "{}", rule.code);
        // Of G0745 nobody is to do anything but stand by.
        let without = rule.grade == Grade::Note || rule.code == "G0745";
        assert!(without || !rule.remedy.is_empty(), "{} says no remedy", rule.code);
    }
    let never = || rules().filter(|rule| matches!(rule.example, Example::Never(_)));
    assert!(
        never().all(|rule| rule.fault || rule.code.starts_with('X')),
        "only a fault in rodete itself has no example"
    );
    let mut never: Vec<_> = never().map(|rule| rule.code).collect();
    never.sort_unstable();
    assert_eq!(
        never,
        [
            "B0131", "X0002", "X0005", "X0006", "X0007", "X0008", "X0009", "X0010", "X0011", "X0012", "X0013", "X0014",
            "X0015", "X0016"
        ],
        "what no input raises is counted"
    );
}

#[test]
fn a_refusal_carries_its_row_and_the_alarm_of_a_control_that_has_one() {
    let program = "T0101 S500 M3 F.2\nG0 X50. Z5.\nG1 X20. K-1. R-1.\nM30";
    let found = told(program, setting("fanuc-lathe-a", &[]));
    let twice = found.iter().find(|one| one.is(CornerTwice::RULE)).unwrap();
    assert_eq!(twice.alarm.map(|(family, number)| family.shown(number)).as_deref(), Some("PS0053"));
    assert_eq!(twice.what.en, "PS0053: 'K' and 'R' in one block");
    let word = |text: &str| Datum::Word(text.to_owned());
    assert_eq!(twice.data, [("first", word("K")), ("second", word("R"))]);
}

/// The fields of rows that hold words, by code and name: what the sources declare them to be.
fn texts() -> BTreeSet<(String, String)> {
    let (mut folders, mut texts) = (vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("src")], BTreeSet::new());
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let source = fs::read_to_string(&path).unwrap();
            for line in source.lines().map(str::trim) {
                let Some((code, rest)) = line.strip_prefix('"').and_then(|line| line.split_once("\" ")) else {
                    continue;
                };
                let Some((_, fields)) = rest.split_once('{').filter(|_| code.len() == 5) else { continue };
                for field in fields.trim_end_matches('}').split(',') {
                    let (name, of) = field.split_once(':').unwrap_or_default();
                    if of.trim() == "Text" {
                        texts.insert((code.to_owned(), name.trim().to_owned()));
                    }
                }
            }
        }
    }
    texts
}

/// The field that a part of a remedy takes its verb from: one that it begins with, or all that is behind a verb that says nothing
/// by itself.
fn verb(part: &str) -> Option<&str> {
    let part = part.trim();
    let bare = ["choose ", "use ", "elija ", "use los ", "take ", "do "];
    let behind = bare.into_iter().find_map(|verb| part.strip_prefix(verb).filter(|rest| rest.ends_with('}')));
    let (name, _) = behind.unwrap_or(part).strip_prefix('{')?.split_once('}')?;
    Some(name)
}

/// A remedy is written in its row, so that one code has one remedy: no row tells another's, and none leaves what to do to a field. A
/// field may name a cell, a letter, an axis, or what a value may be.
#[test]
fn a_code_has_one_remedy() {
    // N = 38, or that it must be larger.
    const NAMED: [&str; 1] = ["V0024"];
    assert_eq!(verb("{advice}, and take the word {axis} out"), Some("advice"));
    assert_eq!((verb("choose {other}"), verb("{todo}")), (Some("other"), Some("todo")));
    assert_eq!((verb("in {cell} write {expected}"), verb("choose N of {n} at least")), (None, None));
    assert_eq!((verb("choose {joint}a slimmer torch"), verb("use {code} to finish")), (None, None));
    let texts = texts();
    assert!(texts.len() > 200, "the words of rows are found: {}", texts.len());
    let left_to_a_field = |rule: &&Rule| {
        [&rule.remedy.es, &rule.remedy.en].into_iter().any(|remedy| {
            let mut verbs = remedy.split("; ").filter_map(verb);
            verbs.any(|name| texts.contains(&(rule.code.to_owned(), name.to_owned())))
        })
    };
    let codes: Vec<_> = rules().filter(left_to_a_field).map(|rule| rule.code).collect();
    assert_eq!(codes, NAMED);
}
