//! The house: what each room may use, what stands where.
//!
//! That nothing below the walls reaches files, clock, environment or processes is `.clippy.toml`'s: a door says so there
//! where it stands.

#![allow(clippy::expect_used)]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use rodete::gcode::control::ALL;

const TOP: [&str; 16] = [
    "Cargo.toml",
    "Cargo.lock",
    "README.md",
    "CHANGELOG.md",
    "CONTRIBUTING.md",
    "LICENSE-APACHE",
    "LICENSE-MIT",
    "README.es.md",
    "SECURITY.md",
    "THIRD-PARTY.md",
    "src",
    "tests",
    "benches",
    "docs",
    "workbooks",
    "report-templates",
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Every Rust file under a folder of `src`, by its path in `src`, with its lines of code.
fn sources(folder: &str) -> Vec<(PathBuf, Vec<String>)> {
    let (src, mut found) = (root().join("src"), Vec::new());
    let mut folders = vec![src.join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a folder of sources") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let text = fs::read_to_string(&path).expect("a source file");
                let code = text.lines().map(str::trim_start).filter(|line| !line.starts_with("//")).map(str::to_owned);
                found.push((path.strip_prefix(&src).expect("a path in src").to_owned(), code.collect()));
            }
        }
    }
    found
}

/// The lines above the tests of a file.
fn above_tests(code: &[String]) -> impl Iterator<Item = &String> {
    code.iter().take_while(|line| *line != "#[cfg(test)]")
}

/// The rooms that a line of code names from the crate's root.
fn named(line: &str) -> impl Iterator<Item = &str> {
    line.split("crate::")
        .skip(1)
        .map(|rest| rest.split(|one: char| !(one.is_alphanumeric() || one == '_')).next().unwrap_or(""))
}

/// The rooms and the group of each in `lib.rs`, from the ground up.
fn floors() -> BTreeMap<String, usize> {
    let text = fs::read_to_string(root().join("src/lib.rs")).expect("lib.rs");
    let rooms = text.split("\n\n").enumerate().flat_map(|(floor, group)| {
        group
            .lines()
            .filter_map(move |line| Some((line.strip_prefix("pub mod ")?.strip_suffix(';')?.to_owned(), floor)))
    });
    rooms.collect()
}

#[test]
fn every_room_uses_those_below_it_alone() {
    let floors = floors();
    assert!(floors.len() > 20, "the rooms are found: {floors:?}");
    let (mut faults, mut arrows) = (Vec::new(), 0);
    for (path, code) in sources("") {
        let own =
            path.with_extension("").iter().next().map(|room| room.to_string_lossy().into_owned()).expect("a name");
        // The binary, and what is linked into it alone, stands above all.
        let floor = floors.get(&own).copied().unwrap_or(usize::MAX);
        // `super` as often as the file lies deep leads out of its room.
        let up = "super::".repeat(path.iter().count() + 1 - usize::from(path.ends_with("mod.rs")));
        for line in code {
            let above =
                named(&line).filter(|other| *other != own && floors.get(*other).is_none_or(|other| *other >= floor));
            faults.extend(above.map(|other| format!("{} uses {other}: {line}", path.display())));
            if line.contains(&up) {
                faults.push(format!("{} leaves its room by super: {line}", path.display()));
            }
            arrows += named(&line).filter(|other| *other != own).count();
        }
    }
    assert!(arrows > 1000, "the arrows are found: {arrows}");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn walls_show_what_came_of_any_kind_and_name_none() {
    for wall in ["drawing", "report", "store", "view", "workbook"] {
        for (path, code) in sources(wall) {
            let kinds = code.iter().flat_map(|line| named(line)).find(|room| matches!(*room, "kinds" | "removal"));
            assert_eq!(kinds, None, "{}", path.display());
        }
    }
}

#[test]
fn the_store_changes_files_through_its_disk_alone() {
    const CHANGES: [&str; 8] = [
        "fs::write(",
        "fs::rename(",
        "fs::copy(",
        "fs::create_dir",
        "fs::hard_link(",
        "fs::remove_",
        "fs::set_permissions(",
        "File::create",
    ];
    let (mut disk, mut others) = (0, Vec::new());
    for (path, code) in sources("store") {
        let changes = above_tests(&code).filter(|line| CHANGES.iter().any(|one| line.contains(one)));
        if path.ends_with("disk.rs") {
            disk = changes.count();
        } else {
            others.extend(changes.map(|line| (path.clone(), line.clone())));
        }
    }
    assert!(disk >= 6, "the disk is seen to change files: {disk}");
    // A process that is about to end removes what it leaves unfinished, whatever disk it was begun on.
    let abandoned = ["let _ = fs::remove_file(file);", "let _ = fs::remove_dir(folder);"];
    assert_eq!(others, abandoned.map(|line| (PathBuf::from("store/draft.rs"), line.to_owned())));
}

#[test]
fn only_a_parameter_makes_its_key() {
    let makes = |(path, code): (PathBuf, Vec<String>)| {
        code.iter().any(|line| line.contains("Key::of_row(")).then(|| path.to_string_lossy().into_owned())
    };
    assert_eq!(sources("").into_iter().filter_map(makes).collect::<Vec<_>>(), ["parameter/mod.rs"]);
}

#[test]
fn the_top_of_the_repository_holds_what_it_should() {
    for entry in fs::read_dir(root()).expect("the repository") {
        let name = entry.expect("an entry").file_name().to_string_lossy().into_owned();
        let built = name == "target";
        assert!(built || name.starts_with('.') || TOP.contains(&name.as_str()), "{name} has no place here");
    }
}

/// What a control does is data: code that asks for its name or identity would do something else for the next control. Whether a
/// program is for the control of its design is asked of two that are given, at one place; and no code names a control to hold
/// another against it.
#[test]
fn no_code_asks_which_control_it_is() {
    let asks = |line: &str| {
        ["control.name", "dialect.name"].into_iter().any(|name| {
            let (before, behind) = line.split_once(name).unwrap_or_default();
            let before = before.trim_end_matches(|one: char| one.is_alphanumeric() || "_.&*".contains(one)).trim_end();
            let behind = behind.trim_start();
            ["==", "!=", ".", "{"].into_iter().any(|one| behind.starts_with(one))
                || ["==", "!=", "match"].into_iter().any(|one| before.ends_with(one))
        }) || (line.contains("ptr::eq") || line.contains(".is("))
            && (line.contains("control") || line.contains("dialect"))
    };
    assert!(asks("if design.control.name == \"linuxcnc\" {") && asks("match dialect.name {"));
    assert!(asks("control.name.starts_with(\"fanuc\")") && asks("\"linuxcnc\" != self.control.name"));
    assert!(asks("if program.control.is(control) {"));
    assert!(!asks("format!(\"{}\", program.control.name)") && !asks("let name = self.control.name;"));
    let mut found = Vec::new();
    for (path, code) in sources("").into_iter().filter(|(path, _)| !path.starts_with("gcode/control")) {
        found.extend(above_tests(&code).filter(|line| asks(line)).map(|line| (path.clone(), line.clone())));
    }
    let is_for = "std::ptr::eq(self.control, control)".to_owned();
    assert_eq!(found, [(PathBuf::from("gcode/program.rs"), is_for)]);

    let word = |one: char| one.is_alphanumeric() || one == '_';
    let own = sources("gcode/control");
    let statics = own.iter().flat_map(|(_, code)| code).filter_map(|line| {
        let (name, of) = line.strip_prefix("pub static ")?.split_once(':')?;
        of.trim_start().starts_with("Control ").then_some(name)
    });
    let statics: BTreeSet<&str> = statics.collect();
    assert_eq!(statics.len(), ALL.len(), "every control is seen: {statics:?}");
    // A case states the control in its cell, `DIALECT.is(..)`, which asks nothing; anywhere else it may not name one either.
    let stated = |path: &Path, line: &str| {
        path.ends_with("cases.rs") && (line.contains("DIALECT.is(") || line.starts_with("use "))
    };
    for (path, code) in sources("").iter().filter(|(path, _)| !path.starts_with("gcode/control")) {
        let names = |line: &str| without_literals(line).split(|one| !word(one)).any(|name| statics.contains(name));
        let named = above_tests(code).find(|line| names(line) && !stated(path, line));
        assert_eq!(named, None, "{}", path.display());
    }
}

/// What a value of a control does stands beside its enum, in a `match` without a wildcard. A comparison with one value elsewhere, as
/// `==`, `matches!`, a pattern of `let`, `.eq(` or a `match` with a wildcard, would give a new value the answer of the others, and nobody
/// would be asked. Enums that share their name with one of another room are not looked for.
#[test]
fn no_code_compares_with_a_value_of_a_control() {
    let word = |one: char| one.is_alphanumeric() || one == '_';
    let named = |(_, code): &(PathBuf, Vec<String>)| -> Vec<String> {
        let names = code.iter().filter_map(|line| {
            line.split_once("enum ")
                .filter(|(before, _)| before.is_empty() || before.starts_with("pub"))
                .map(|(_, rest)| rest)
        });
        names.map(|rest| rest.chars().take_while(|one| word(*one)).collect()).collect()
    };
    let (of_controls, others): (Vec<_>, Vec<_>) =
        sources("").into_iter().partition(|(path, _)| path.starts_with("gcode/control"));
    let elsewhere: BTreeSet<String> = others.iter().flat_map(named).collect();
    let enums: BTreeSet<String> = of_controls.iter().flat_map(named).filter(|name| !elsewhere.contains(name)).collect();
    assert!(enums.len() > 30 && enums.contains("RotaryMode") && enums.contains("CallBy"), "{enums:?}");
    // Either side of a comparison, with or without a path before the enum.
    let value = |side: &str| {
        side.split(|one: char| !word(one) && one != ':').any(|path| {
            let mut names = path.rsplit("::").skip(1);
            path.contains("::") && names.next().is_some_and(|name| enums.contains(name))
        })
    };
    let compares = |line: &str| {
        line.split("&&").flat_map(|part| part.split("||")).any(|part| {
            let sides = part.split_once("==").or_else(|| part.split_once("!="));
            sides.is_some_and(|(left, right)| {
                // A method of a value, as its name, is no value.
                let (left, right) = (left.trim_end(), right.trim_start());
                let first = right.split(|one: char| !word(one) && !":.(&*".contains(one)).next().unwrap_or_default();
                let last = left.rsplit(|one: char| !word(one) && !":.)&*".contains(one)).next().unwrap_or_default();
                [first, last].into_iter().any(|side| !side.contains('.') && value(side))
            })
        })
    };
    // Over lines, as a macro or a pattern may be broken.
    let asks = |code: &str| {
        let called = [".eq(", ".ne(", ".is(", "matches!("]
            .into_iter()
            .any(|call| code.match_indices(call).any(|(at, _)| value(within(&code[at + call.len()..], ['(', ')']))));
        let bound = code.match_indices("let ").any(|(at, _)| {
            let rest = &code[at + 4..];
            value(rest.split_once('=').map_or("", |(pattern, _)| pattern))
        });
        called || bound || matches_by_wildcard(code, &value)
    };
    assert!(compares("if self.memory.control.calls.by != CallBy::Label {"));
    assert!(
        compares("self.ready && self.counting == RotaryMode::Rollover {") && compares("control::CallBy::Label == by")
    );
    assert!(!compares("let by = CallBy::Label;") && !compares("rule == RotaryMode::Rollover.name()"));
    assert!(!compares("Self { by: CallBy::Label, deep: depth == 4 }") && !compares("grade == Grade::Stop"));
    assert!(asks("called && matches!(\nself.memory.control.tool,\nToolCall::Digits\n)"));
    assert!(asks("if let CallBy::Label = calls.by {") && asks("let Some(CallBy::Label) = by else {"));
    assert!(asks("by.eq(&CallBy::Label)") && asks("by.is(&CallBy::Label)"));
    assert!(asks("match calls.by {\nCallBy::Label => call(),\n_ => {}\n}"));
    assert!(!asks("match calls.by {\nCallBy::Label => match code {\n_ => {}\n}\nCallBy::Number => {}\n}"));
    assert_eq!(without_literals(r#"match b'(' { "a\"{" => '\'', x: &'a str"#), "match b {  => , x: &a str");
    assert!(!asks("let by = CallBy::Label;") && !asks("match grade {\nGrade::Stop => CallBy::Label,\n_ => by,\n}"));
    for (path, code) in &others {
        // `FIELD.is(value)` of a case states the value of a cell; whatever else a case does is looked at.
        let stating = path.ends_with("cases.rs");
        let read = |line: &String| if stating { line.replace(".is(", ".states(") } else { line.clone() };
        let code: Vec<String> = above_tests(code).map(read).collect();
        let found = code.iter().find(|line| compares(line));
        assert_eq!(found, None, "{}: give the enum a method that says what is done", path.display());
        assert!(
            !asks(&without_literals(&code.join("\n"))),
            "{}: give the enum a method that says what is done",
            path.display()
        );
    }
}

/// Code without what stands in quotes.
fn without_literals(code: &str) -> String {
    let (mut bare, mut rest) = (String::new(), code);
    while let Some((at, quote)) = rest.char_indices().find(|(_, one)| ['"', '\''].contains(one)) {
        let (before, behind) = (&rest[..at], &rest[at + 1..]);
        bare.push_str(before);
        let (mut escaped, mut ends) = (false, None);
        for (at, one) in behind.char_indices() {
            if one == quote && !escaped {
                ends = Some(at);
                break;
            }
            escaped = one == '\\' && !escaped;
        }
        // A lifetime has no second quote near it.
        let literal = |end: &usize| quote == '"' || behind.starts_with('\\') || behind[..*end].chars().count() == 1;
        rest = ends.filter(literal).map_or(behind, |end| &behind[end + 1..]);
    }
    bare + rest
}

/// The text up to the bracket that closes what stands open before it.
fn within(text: &str, [open, close]: [char; 2]) -> &str {
    let mut depth = 1_u32;
    let end = text.char_indices().find(|(_, one)| {
        depth = if *one == open { depth + 1 } else { depth - u32::from(*one == close) };
        depth == 0
    });
    end.map_or(text, |(at, _)| &text[..at])
}

/// True where a `match` has a value in one of its patterns and `_` for another.
fn matches_by_wildcard(code: &str, value: &impl Fn(&str) -> bool) -> bool {
    code.match_indices("match ").any(|(at, _)| {
        let Some((_, arms)) = code[at..].split_once('{') else { return false };
        // The patterns alone, without what the arms do.
        let (mut depth, mut patterns, mut pattern) = (0_u32, Vec::new(), String::new());
        let mut body = false;
        for (place, one) in within(arms, ['{', '}']).char_indices() {
            match one {
                '(' | '[' | '{' => depth += 1,
                ')' | ']' | '}' => {
                    depth = depth.saturating_sub(1);
                    if one == '}' && depth == 0 {
                        body = false;
                        continue;
                    }
                }
                ',' if depth == 0 => body = false,
                '=' if depth == 0 && !body && arms[place..].starts_with("=>") => {
                    patterns.push(std::mem::take(&mut pattern));
                    body = true;
                }
                _ => {}
            }
            if !body {
                pattern.push(one);
            }
        }
        let bare = |pattern: &String| pattern.trim_matches(|one: char| one == ',' || one.is_whitespace()) == "_";
        patterns.iter().any(bare) && patterns.iter().any(|pattern| value(pattern))
    })
}

/// A formula asks for a control as code does: it takes the names from the data of the controls.
#[test]
fn no_live_form_asks_which_control_it_is() {
    let mut forms = 0;
    for (path, code) in sources("kinds") {
        if path.ends_with("live_form.rs") {
            forms += 1;
            let asks = |line: &&String| ALL.iter().any(|control| line.contains(control.name));
            assert_eq!(above_tests(&code).find(asks), None, "{}", path.display());
        }
    }
    assert!(forms >= 6, "the live forms are found");
}

/// The door prints a finding with its code; a sentence that is printed elsewhere would have none.
#[test]
fn commands_print_findings_through_their_door_alone() {
    let reads = |line: &str| {
        [".what", ".remedy"].into_iter().any(|field| {
            line.match_indices(field).any(|(at, _)| {
                let (before, behind) = (&line[..at], &line[at + field.len()..]);
                // A row, which `explain` shows, is no finding.
                !before.ends_with("rule") && !behind.starts_with(|one: char| one.is_alphanumeric() || one == '_')
            })
        })
    };
    assert!(reads("terminal.err(finding.what.get(language))") && reads("let Text { es, en } = &finding.what;"));
    assert!(!reads("rule.what.get(language)") && !reads("Finding { what, remedy, .. }"));
    let worded = |line: &str| {
        ["error", "caution", "precaución", "note", "nota"].iter().any(|word| line.contains(&format!("\"{word}: ")))
    };
    assert!(worded("terminal.err(&format!(\"error: {what}\"))") && !worded("fn said(error: &Error) {"));
    let mut seen = 0;
    for (path, code) in sources("cli") {
        let read = above_tests(&code).find(|line| reads(line));
        let worded = above_tests(&code).find(|line| worded(line));
        if path.ends_with("finding.rs") {
            assert!(read.is_some(), "the door is found");
            seen += 1;
        } else {
            assert_eq!((read, worded), (None, None), "{}", path.display());
        }
    }
    assert_eq!(seen, 1);
}

/// A finding names its row, or it does not compile. What it says is its row's: only a refused block, which keeps what its row has
/// said until its place is known, writes it into a finding; and nothing gives one another remedy.
#[test]
fn what_a_finding_says_is_its_rows() {
    let written = ["Finding::of(", ".what = ", ".what =\n", ".remedy = ", ".remedy =\n"];
    let beside = |line: &String| written.iter().any(|one| format!("{line}\n").contains(one));
    assert!(beside(&"let mut finding = Finding::of(rule, data, place, what, remedy);".to_owned()));
    assert!(beside(&"                finding.what =".to_owned()) && !beside(&"if one.what == other.what {".to_owned()));
    let beside = sources("").into_iter().filter(|(path, code)| !path.starts_with("finding") && code.iter().any(beside));
    let files: Vec<_> = beside.map(|(path, _)| path).collect();
    assert_eq!(files, [Path::new("gcode/interpreter/refused.rs")]);
}
