//! The programs of `tests/gcode/lathe/bad`: each says on its first line what rodete says of it,
//! `(expected: LINE:COLUMN PART OF THE MESSAGE)`, without a column where the block as a whole is refused.

use std::path::Path;

use super::lines::{read_with, setting};

#[test]
fn bad_programs_are_refused_at_their_place() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/gcode/lathe/bad");
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    assert!(paths.len() > 60, "{} programs", paths.len());
    let mut faults = Vec::new();
    for path in paths {
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        let program = std::fs::read_to_string(&path).unwrap();
        let first = program.lines().next().unwrap_or_default();
        let expected = first.strip_prefix("(expected: ").and_then(|first| first.strip_suffix(')'));
        let (place, message) =
            expected.and_then(|expected| expected.split_once(' ')).unwrap_or_else(|| panic!("{name}: {first}"));
        assert!(message.len() >= 6, "{name}: a part of the message");
        let read = read_with(&program, setting());
        let Some(fault) = read.faults.first() else {
            faults.push(format!("{name}: taken"));
            continue;
        };
        let column = fault.columns.first().map(|column| format!(":{column}")).unwrap_or_default();
        let said = format!("{}; {}", fault.what.en, fault.remedy.en);
        let said = said.replacen(fault.what.en.as_ref(), &fault.message().en, 1);
        if format!("{}{column}", fault.line) != place || !said.contains(message) {
            faults.push(format!("{name}: {}{column} {said}", fault.line));
        }
        for text in [&fault.what, &fault.remedy] {
            assert!(!text.es.is_empty() && !text.en.is_empty(), "{name}: both languages");
        }
        assert_ne!(fault.what.es, fault.what.en, "{name}: Spanish");
    }
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults.join("\n"));
}
