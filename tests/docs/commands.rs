//! Every `rodete` command on the pages is run, and what it prints and its exit code are compared.
//!
//! A page's blocks ` ```console ` are run from above in one folder, which holds the repository's `workbooks`. In them
//! - `$ rodete …` is a command, and so is `$ cargo run --release -- …`; the lines up to the next are what it prints;
//! - `? 3` as the first of these lines is its exit code, 0 where there is none;
//! - `...` stands for any lines, `[..]` for anything within a line.
//!
//! Comments before a block make its inputs: `<!-- edit: FILE.xlsx SHEET!C9 = 3.1 -->` writes a cell (nothing behind `=` empties
//! it), `<!-- copy: PATH NAME -->` copies a file of the repository, `<!-- file: NAME -->` takes the fenced block that follows.
//! `RODETE_DOCS=write cargo test --test docs` writes what is printed now where it is something else.
//!
//! A binary without the typst compiler runs `build` without the report, and its output is not compared.

use std::fs::{self, File};
use std::io::{Cursor, Read, Write};
use std::path::{Path, PathBuf};
use std::process::Command;

use rayon::prelude::*;
use snapbox::{Assert, IntoData};
use zip::write::SimpleFileOptions;

use crate::markdown::{Piece, pages, pieces, root, text};

/// A command of a page: its line from 1, its words, exit code and output.
#[derive(Debug, PartialEq)]
struct Step<'a> {
    line: usize,
    command: &'a str,
    exit: i32,
    printed: Vec<&'a str>,
}

/// The commands of a block that begins at a line.
fn steps<'a>(first: usize, block: &[&'a str]) -> Result<Vec<Step<'a>>, String> {
    let mut steps: Vec<Step<'_>> = Vec::new();
    for (line, text) in (first..).zip(block) {
        if let Some(command) = text.strip_prefix("$ ") {
            steps.push(Step { line, command, exit: 0, printed: Vec::new() });
        } else if let Some(step) = steps.last_mut() {
            match text.strip_prefix("? ").and_then(|code| code.parse().ok()) {
                Some(code) if step.printed.is_empty() => step.exit = code,
                _ => step.printed.push(text),
            }
        } else {
            return Err(format!("{line}: a line before the first command"));
        }
    }
    Ok(steps)
}

/// The words of a command behind the program's name; `"…"` is one word.
fn words(command: &str) -> Option<Vec<String>> {
    let rest = ["rodete", "cargo run --release --"].into_iter().find_map(|program| command.strip_prefix(program))?;
    let mut words = Vec::new();
    for (at, part) in rest.split('"').enumerate() {
        if at % 2 == 1 {
            words.push(part.to_owned());
        } else {
            words.extend(part.split_whitespace().map(str::to_owned));
        }
    }
    Some(words)
}

/// What a command prints, both streams as a terminal shows them, and its exit code.
fn run(words: &[String], folder: &Path) -> (String, Option<i32>) {
    // Beside the folder: what is printed is none of its files.
    let path = folder.with_extension("printed");
    let printed = File::create(&path).unwrap();
    let status = Command::new(env!("CARGO_BIN_EXE_rodete"))
        .args(words)
        .current_dir(folder)
        .env("LC_ALL", "C")
        .env_remove("RODETE_TYPST")
        .stdout(printed.try_clone().unwrap())
        .stderr(printed)
        .status()
        .unwrap();
    (fs::read_to_string(path).unwrap(), status.code())
}

/// Gives a cell of a workbook another value; an empty one empties it.
fn edit(path: &Path, sheet: &str, cell: &str, value: &str) {
    let mut archive = zip::ZipArchive::new(Cursor::new(fs::read(path).unwrap())).unwrap();
    let mut parts: Vec<(String, Vec<u8>)> = Vec::new();
    for at in 0..archive.len() {
        let mut part = archive.by_index(at).unwrap();
        let mut bytes = Vec::new();
        part.read_to_end(&mut bytes).unwrap();
        parts.push((part.name().unwrap().into_owned(), bytes));
    }
    let book = parts.iter().find(|(name, _)| name == "xl/workbook.xml").unwrap();
    let book = String::from_utf8(book.1.clone()).unwrap();
    let at = book.split("<sheet ").skip(1).position(|one| one.starts_with(&format!("name=\"{sheet}\"")));
    let name = format!("xl/worksheets/sheet{}.xml", at.unwrap_or_else(|| panic!("no sheet {sheet}")) + 1);
    let part = &mut parts.iter_mut().find(|(one, _)| *one == name).unwrap().1;
    let xml = String::from_utf8(part.clone()).unwrap();
    let (before, rest) = xml.split_once(&format!("<c r=\"{cell}\"")).unwrap_or_else(|| panic!("no cell {cell}"));
    let (opening, behind) = rest.split_once('>').unwrap();
    let behind = if opening.ends_with('/') { behind } else { behind.split_once("</c>").unwrap().1 };
    let style = opening.split("s=\"").nth(1).and_then(|rest| rest.split('"').next()).unwrap_or("0");
    let held = value.replace('&', "&amp;").replace('<', "&lt;");
    let typed = match value {
        "" => String::from("/>"),
        _ if value.parse::<f64>().is_ok() => format!("><v>{value}</v></c>"),
        _ => format!(" t=\"inlineStr\"><is><t>{held}</t></is></c>"),
    };
    *part = format!("{before}<c r=\"{cell}\" s=\"{style}\"{typed}{behind}").into_bytes();
    let mut writer = zip::ZipWriter::new(File::create(path).unwrap());
    for (name, bytes) in parts {
        writer.start_file(name, SimpleFileOptions::default()).unwrap();
        writer.write_all(&bytes).unwrap();
    }
    writer.finish().unwrap();
}

/// What a page is run in.
struct Bench {
    folder: tempfile::TempDir,
    /// The file that the next fenced block is.
    awaited: Option<String>,
}

impl Bench {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let desk = folder.path().join("desk");
        fs::create_dir_all(desk.join("workbooks")).unwrap();
        for entry in fs::read_dir(root().join("workbooks")).unwrap() {
            let path = entry.unwrap().path();
            if path.is_file() {
                fs::copy(&path, desk.join("workbooks").join(path.file_name().unwrap())).unwrap();
            }
        }
        Self { folder, awaited: None }
    }

    fn desk(&self) -> PathBuf {
        self.folder.path().join("desk")
    }

    /// Does what a comment says; false where it says nothing to do.
    fn obey(&mut self, comment: &str) -> bool {
        let Some(said) = comment.trim().strip_prefix("<!-- ").and_then(|rest| rest.strip_suffix(" -->")) else {
            return false;
        };
        match said.split_once(": ") {
            Some(("edit", what)) => {
                let (place, value) = what.split_once(" =").expect("FILE SHEET!CELL = VALUE");
                let (file, place) = place.split_once(' ').expect("FILE SHEET!CELL");
                let (sheet, cell) = place.split_once('!').expect("SHEET!CELL");
                edit(&self.desk().join(file.trim_end_matches(':')), sheet, cell, value.trim());
            }
            Some(("copy", what)) => {
                let (path, name) = what.split_once(' ').expect("PATH NAME");
                fs::copy(root().join(path), self.desk().join(name)).unwrap();
            }
            Some(("file", name)) => self.awaited = Some(name.to_owned()),
            _ => return false,
        }
        true
    }
}

/// What is said of a step that fails, with the lines that would be right.
fn judge(step: &Step<'_>, bench: &Bench) -> Result<(), (String, Vec<String>)> {
    let mut words = words(step.command).ok_or((format!("{} is no command of rodete", step.command), Vec::new()))?;
    let lean = !cfg!(feature = "embedded-typst") && words.first().is_some_and(|first| first == "build");
    let lean = lean && !words.iter().any(|word| word == "--no-report");
    if lean {
        words.push("--no-report".to_owned());
    }
    let (printed, code) = run(&words, &bench.desk());
    let expected = step.printed.iter().map(|line| format!("{line}\n")).collect::<String>();
    let told =
        if lean { Ok(()) } else { Assert::new().try_eq(None, printed.as_str().into_data(), expected.into_data()) };
    let mut wrong = String::new();
    if code != Some(step.exit) {
        wrong.push_str(&format!("exit {code:?} instead of {}\n{printed}", step.exit));
    }
    if let Err(error) = told {
        wrong.push_str(&error.to_string());
    }
    if wrong.is_empty() {
        return Ok(());
    }
    let mut lines = vec![format!("$ {}", step.command)];
    lines.extend(code.filter(|code| *code != 0).map(|code| format!("? {code}")));
    lines.extend(rewritten(&step.printed, printed.lines().map(unsummed).collect()));
    Err((wrong, lines))
}

/// True where a line is what a page has for it.
fn fits(line: &str, told: &str) -> bool {
    let mut rest = line;
    let mut pieces = told.split("[..]").enumerate().peekable();
    while let Some((at, piece)) = pieces.next() {
        let found = match (at, pieces.peek()) {
            (0, None) => return line == told,
            (0, _) => rest.starts_with(piece).then_some(0),
            (_, None) => return rest.ends_with(piece),
            _ => rest.find(piece),
        };
        let Some(from) = found else { return false };
        rest = &rest[from + piece.len()..];
    }
    true
}

/// What is printed now, left out where the page leaves it out.
fn rewritten(told: &[&str], printed: Vec<String>) -> Vec<String> {
    let (mut lines, mut next, mut left_out) = (Vec::new(), 0, false);
    for line in told {
        if *line == "..." {
            left_out = true;
        } else if let Some(at) = (next..printed.len()).find(|at| fits(&printed[*at], line)) {
            if left_out {
                lines.push("...".to_owned());
            } else {
                lines.extend_from_slice(&printed[next..at]);
            }
            lines.push((*line).to_owned());
            (next, left_out) = (at + 1, false);
        }
    }
    if left_out {
        lines.push("...".to_owned());
    } else {
        lines.extend_from_slice(&printed[next..]);
    }
    lines
}

/// A line without what another version or machine would print otherwise: sums of files, and their sizes.
fn unsummed(line: &str) -> String {
    let Some((before, behind)) = line.split_once("SHA-256 ") else { return line.to_owned() };
    let sum = behind.chars().take_while(char::is_ascii_hexdigit).count();
    let file = before.starts_with("  ").then(|| before.trim().split("  ").next()).flatten();
    match file {
        Some(name) => format!("  {name} [..]"),
        None => format!("{before}SHA-256 [..]{}", &behind[sum..]),
    }
}

/// Runs a page; gives its faults, and the page as it should be.
fn proved(page: &Path) -> (Vec<String>, String, usize) {
    let (text, mut bench) = (text(page), Bench::new());
    let lines: Vec<&str> = text.lines().collect();
    let (mut faults, mut kept, mut written, mut run) = (Vec::new(), 0, Vec::new(), 0);
    for piece in pieces(&text) {
        match piece {
            Piece::Line(_, line) => drop(bench.obey(line)),
            Piece::Fence(first, "console", block) => {
                let steps = steps(first, &block).unwrap_or_else(|fault| panic!("{}:{fault}", page.display()));
                for (at, step) in steps.iter().enumerate() {
                    run += 1;
                    if let Err((wrong, right)) = judge(step, &bench) {
                        faults.push(format!("{}:{}: $ {}\n{wrong}", page.display(), step.line, step.command));
                        let end = steps.get(at + 1).map_or(first + block.len(), |next| next.line);
                        written.extend(lines[kept..step.line - 1].iter().map(|line| (*line).to_owned()));
                        written.extend(right);
                        kept = end - 1;
                    }
                }
            }
            Piece::Fence(first, kind, block) => {
                if let Some(name) = bench.awaited.take() {
                    fs::write(bench.desk().join(name), block.join("\n") + "\n").unwrap();
                }
                // A synopsis says that it is text.
                let typed = |line: &&&str| line.starts_with("rodete ") || line.starts_with("$ rodete ");
                if let Some(line) = block.iter().find(typed).filter(|_| kind != "text") {
                    faults.push(format!("{}:{first}: {line}: stands in no block that is run", page.display()));
                }
            }
        }
    }
    written.extend(lines[kept..].iter().map(|line| (*line).to_owned()));
    (faults, written.join("\n") + "\n", run)
}

#[test]
fn every_command_on_a_page_prints_what_stands_there() {
    let write = std::env::var_os("RODETE_DOCS").is_some_and(|value| value == "write");
    let proved: Vec<_> = pages().into_par_iter().map(|page| (proved(&page), page)).collect();
    let (mut faults, mut run) = (Vec::new(), 0);
    for ((wrong, right, steps), page) in proved {
        run += steps;
        if write && !wrong.is_empty() {
            fs::write(root().join(&page), right).unwrap();
        }
        faults.extend(wrong);
    }
    assert!(run > 50, "commands are found: {run}");
    assert!(
        write || faults.is_empty(),
        "{}\nwhere that is meant: RODETE_DOCS=write cargo test --test docs",
        faults.join("\n")
    );
}

#[test]
fn commands_are_read_with_their_codes_and_words() {
    let block = ["$ rodete check \"a b.xlsx\"", "? 4", "error: x", "$ rodete --version"];
    let read = steps(7, &block).unwrap();
    assert_eq!(read[0], Step { line: 7, command: "rodete check \"a b.xlsx\"", exit: 4, printed: vec!["error: x"] });
    assert_eq!((read[1].line, read[1].exit), (10, 0));
    assert_eq!(words(read[0].command), Some(vec!["check".to_owned(), "a b.xlsx".to_owned()]));
    assert_eq!(words("rm -r x"), None);
    assert!(steps(1, &["lost"]).is_err());
}

#[test]
fn another_output_another_code_and_a_command_that_is_not_run_are_told() {
    let bench = Bench::new();
    let step =
        |printed: &'static str, exit| Step { line: 1, command: "rodete explain L0131", exit, printed: vec![printed] };
    assert!(judge(&step("...", 0), &bench).is_ok());
    assert!(judge(&step("L0131 [..]", 0), &bench).is_err(), "one line is not all");
    assert!(judge(&step("...", 3), &bench).is_err());
    let printed = ["a", "b 12 c", "d", "e", "f"].map(str::to_owned).to_vec();
    assert_eq!(rewritten(&["...", "b [..] c", "x", "..."], printed.clone()), ["...", "b [..] c", "..."]);
    assert_eq!(rewritten(&["a", "...", "d"], printed), ["a", "...", "d", "e", "f"]);
    assert!(fits("a 1 b 2 c", "a [..] b [..] c") && !fits("a b", "a [..] c") && fits("x", "[..]") && !fits("ab", "a"));
    assert_eq!(unsummed("  a-out/a.nc      14 kB  SHA-256 0123456789abcdef"), "  a-out/a.nc [..]");
}
