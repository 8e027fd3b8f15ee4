//! `docs/reference/json.md` names every key of the documents that the commands print, and no other.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

use crate::markdown::{root, text};

/// What an alarm has as every finding.
const OF_A_FINDING: [&str; 11] =
    ["code", "name", "grade", "what", "place", "value", "limit", "remedy", "count", "data", "alarm"];

/// The keys of a document by their paths. What a finding holds, or an alarm as one, is told in a table of its own; axes and
/// systems stand for each other.
fn keys(value: &Value, path: &str, found: &mut BTreeSet<String>) {
    match value {
        Value::Object(members) => {
            let alarm = members.contains_key("x_mm");
            for (key, value) in members.iter().filter(|(key, _)| !(alarm && OF_A_FINDING.contains(&key.as_str()))) {
                let key = match key.as_str() {
                    axis if axis.len() == 1 => "AXIS",
                    system if system.starts_with("G5") => "SYSTEM",
                    key => key,
                };
                let path = if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
                let whole = key == "findings" || value.get("es").is_some();
                found.insert(path.clone());
                if !whole {
                    keys(value, &path, found);
                }
            }
        }
        Value::Array(items) => items.iter().for_each(|item| keys(item, &format!("{path}[]"), found)),
        _ => {}
    }
}

/// The findings of a document, wherever they stand.
fn findings<'a>(value: &'a Value, found: &mut Vec<&'a Value>) {
    match value {
        Value::Object(members) => {
            for (key, value) in members {
                match value {
                    Value::Array(items) if key == "findings" => found.extend(items),
                    _ => findings(value, found),
                }
            }
        }
        Value::Array(items) => items.iter().for_each(|item| findings(item, found)),
        _ => {}
    }
}

/// The keys that a section of the page names.
fn told(page: &str, section: &str) -> BTreeSet<String> {
    let heading = format!("\n## {section}\n");
    let section = page.split_once(&heading).unwrap_or_else(|| panic!("no section {section}")).1;
    let rows = section.split("\n## ").next().unwrap().lines();
    rows.filter_map(|row| row.strip_prefix("| `")?.split('`').next()).map(str::to_owned).collect()
}

fn document(folder: &Path, words: &[&str]) -> Value {
    let output = Command::new(env!("CARGO_BIN_EXE_rodete")).args(words).current_dir(folder).output().unwrap();
    serde_json::from_slice(&output.stdout).unwrap_or_else(|error| panic!("{words:?}: {error}"))
}

#[test]
fn every_key_of_every_document_stands_on_the_page() {
    let page = text(Path::new("docs/reference/json.md"));
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name);
    let taken = [
        ("workbooks/impeller-full.xlsx", "impeller.xlsx"),
        ("workbooks/impeller-tfg-2021.xlsx", "other.xlsx"),
        ("tests/controls/linuxcnc/good/g92-from-file.var", "a.var"),
        ("tests/lathe/alarms/depth-of-cut.nc", "deep.nc"),
        ("tests/golden/annex-09-blade-as-printed.nc", "blade.nc"),
        ("tests/controls/linuxcnc/tools.tbl", "tools.tbl"),
    ];
    for (path, name) in taken {
        fs::copy(root().join(path), place(name)).unwrap();
    }
    let commands: [(&str, &[&[&str]]); 5] = [
        (
            "`check` and `build`",
            &[&["check", "impeller.xlsx", "--json"], &["build", "impeller.xlsx", "--no-report", "--json"]],
        ),
        ("`compare`", &[&["compare", "impeller.xlsx", "other.xlsx", "-o", "compared.xlsx", "--json"]]),
        ("`verify`", &[&["verify", "blade.nc", "--tools", "tools.tbl", "--json"]]),
        (
            "`simulate`",
            &[&["simulate", "deep.nc", "--dialect", "fanuc-lathe-a", "--stock", "D50xL100", "-o", "out", "--json"]],
        ),
        ("`offsets`", &[&["offsets", "a.var", "--set", "G55 X1", "--workbook", "offsets.xlsx", "--json"]]),
    ];
    let common = told(&page, "Every document");
    let mut of_findings = BTreeSet::new();
    for (section, lines) in commands {
        let mut printed = BTreeSet::new();
        for words in lines {
            let document = document(folder.path(), words);
            let mut own = BTreeSet::new();
            keys(&document, "", &mut own);
            assert!(common.is_subset(&own), "{words:?}: {own:?}");
            printed.extend(own.difference(&common).cloned());
            let mut found = Vec::new();
            findings(&document, &mut found);
            for finding in found {
                of_findings.extend(finding.as_object().unwrap().keys().cloned());
            }
        }
        assert_eq!(printed, told(&page, section), "{section}");
    }
    assert_eq!(of_findings, told(&page, "A finding"));
    assert_eq!(of_findings, OF_A_FINDING.map(str::to_owned).into());
}
