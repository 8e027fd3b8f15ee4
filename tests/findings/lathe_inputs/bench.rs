//! Programs and workbooks on the bench, and the command over them.

use std::collections::BTreeMap;
use std::fs;
use std::io::Cursor;
use std::path::Path;
use std::process::Command;

use rodete::kinds::lathe::cases::CASES;
use rodete::kinds::lathe::parameters::{PROGRAM_KEY, SECOND_KEY};
use rodete::parameter::Value;
use rodete::parameter::list::{Row, Rows};
use rodete::text::Language;
use rodete::workbook::template;
use serde_json::Value as Json;

/// The start of a program: the roughing tool in front of a bar of 50 mm.
pub const HEAD: [&str; 5] = ["G50 S2500", "T0101", "G97 S900 M3", "M8", "G0 X54. Z2."];
/// Its end.
pub const TAIL: [&str; 2] = ["G0 X100. Z50.", "M30"];

/// A program of these blocks between head and tail, joined with `|`.
pub fn program(blocks: &str) -> Vec<String> {
    HEAD.into_iter().chain(blocks.split('|')).chain(TAIL).map(str::to_owned).collect()
}

/// The rows of a list of blocks.
pub fn blocks(list: &'static str, sheet: &str, lines: &[String]) -> Rows {
    let row = |line: &String| Row {
        values: BTreeMap::from([("program/BLOCK", Value::Line(line.clone()))]),
        cells: BTreeMap::new(),
    };
    Rows { list, sheet: sheet.to_owned(), rows: lines.iter().map(row).collect() }
}

/// A lathe workbook to be filled in: a bar of 50 by 120 mm held on 30 mm, the example machine and turret.
pub struct Book {
    pub values: Vec<(&'static str, Value)>,
    pub lists: Vec<Rows>,
    pub language: Language,
}

impl Book {
    /// With this program.
    pub fn new(lines: &[String]) -> Self {
        Self::of(Language::En).put("L5", Value::Real(0.0)).program(lines)
    }

    /// The shipped case.
    pub fn of(language: Language) -> Self {
        let case = &CASES[0];
        Self { values: case.values(language), lists: (case.listed)(language), language }
    }

    pub fn put(mut self, key: &'static str, value: Value) -> Self {
        self.values.retain(|(other, _)| *other != key);
        self.values.push((key, value));
        self
    }

    pub fn without(mut self, key: &str) -> Self {
        self.values.retain(|(other, _)| *other != key);
        self
    }

    pub fn list(mut self, rows: Rows) -> Self {
        if rows.sheet.is_empty() {
            self.lists.retain(|other| other.list != rows.list);
        }
        self.lists.push(rows);
        self
    }

    pub fn program(self, lines: &[String]) -> Self {
        self.list(blocks(PROGRAM_KEY, "", lines))
    }

    pub fn second(self, lines: &[String]) -> Self {
        self.list(blocks(SECOND_KEY, "", lines))
    }

    pub fn subprogram(self, sheet: &str, lines: &[&str]) -> Self {
        let lines: Vec<String> = lines.iter().map(|line| (*line).to_owned()).collect();
        self.list(blocks("subprogram", sheet, &lines))
    }

    /// Changes the rows of a list.
    pub fn change(mut self, list: &str, change: impl FnOnce(&mut Vec<Row>)) -> Self {
        change(&mut self.lists.iter_mut().find(|rows| rows.list == list).unwrap().rows);
        self
    }

    /// A tool without a nose that leaves square shoulders, in the first place: what it takes away is a matter of cylinders.
    pub fn sharp(self) -> Self {
        self.change("tools", |rows| {
            for (key, value) in [("tools/R", 0.0), ("tools/phi1", 90.0), ("tools/phi2", 10.0)] {
                rows[0].values.insert(key, Value::Real(value));
            }
        })
    }

    pub fn bytes(&self) -> Vec<u8> {
        let mut out = Cursor::new(Vec::new());
        template::write(
            &rodete::kinds::lathe::Lathe,
            &self.values,
            &self.lists,
            &CASES[0].note,
            self.language,
            &mut out,
        )
        .unwrap();
        out.into_inner()
    }
}

/// What a command said.
pub struct Said {
    pub exit: i32,
    pub out: String,
    pub err: String,
}

/// Runs the command in a folder.
pub fn run(folder: &Path, arguments: &[&str]) -> Said {
    let output = Command::new(env!("CARGO_BIN_EXE_rodete")).current_dir(folder).args(arguments).output().unwrap();
    Said {
        exit: output.status.code().unwrap(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// Builds a workbook; the folder, the document of its one workbook, the exit code.
pub fn build(bytes: &[u8]) -> (tempfile::TempDir, Json, i32) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("part.xlsx"), bytes).unwrap();
    let said = run(folder.path(), &["build", "part.xlsx", "--no-report", "--json", "-o", "out"]);
    let document: Json = serde_json::from_str(&said.out).unwrap_or_else(|_| panic!("{}", said.err));
    (folder, document["workbooks"][0].clone(), said.exit)
}

/// A derived value of a build.
pub fn quantity(document: &Json, symbol: &str) -> f64 {
    let all = document["quantities"].as_array().unwrap_or_else(|| panic!("{document}"));
    all.iter().find(|one| one["symbol"] == symbol).unwrap()["value"].as_f64().unwrap()
}

/// A finding as one line: grade, place, English message.
pub fn line(finding: &Json) -> String {
    format!(
        "{} {} {}",
        finding["grade"].as_str().unwrap(),
        place(&finding["place"]),
        finding["what"]["en"].as_str().unwrap()
    )
}

/// A place: `SHEET!A7`, `5:1`, `O0005 2:5`, a sheet, `file`.
pub fn place(place: &Json) -> String {
    if let Some(cells) = place["cells"].as_array() {
        let cell = |one: &Json| format!("{}!{}", one["sheet"].as_str().unwrap(), one["cell"].as_str().unwrap());
        return cells.iter().map(cell).collect::<Vec<_>>().join(" ");
    }
    let of_line = |one: &Json| {
        let columns: Vec<String> =
            one["columns"].as_array().unwrap().iter().map(|column| format!(":{column}")).collect();
        format!("{}{}", one["line"], columns.concat())
    };
    if place["line"].is_object() {
        return of_line(&place["line"]);
    }
    if let Some(file) = place["subprogram"]["file"].as_str() {
        return format!("{file} {}", of_line(&place["subprogram"]));
    }
    place["sheet"].as_str().or(place.as_str()).unwrap_or_else(|| panic!("{place}")).to_owned()
}

/// All findings as lines.
pub fn lines(document: &Json) -> Vec<String> {
    document["findings"].as_array().unwrap().iter().map(line).collect()
}

/// Every refusal and caution must be told in both languages, with a remedy.
pub fn bilingual(document: &Json) {
    for finding in document["findings"].as_array().unwrap().iter().filter(|one| one["grade"] != "note") {
        let [what, remedy] =
            ["what", "remedy"].map(|key| ["es", "en"].map(|code| finding[key][code].as_str().unwrap()));
        assert!(what[0] != what[1] && !what[0].is_empty(), "{finding}");
        assert!(remedy[0] != remedy[1] && !remedy[0].is_empty() && !remedy[1].is_empty(), "{finding}");
    }
}
