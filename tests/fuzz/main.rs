//! Inputs by chance, from a fixed seed: whatever is read, rodete comes back with a result or with a reason, within the
//! work that its limits allow. The inputs start from the corpora of the other tests and from `corpus/`, where every
//! input is kept that once brought something down.
//!
//! The count is small here; `RODETE_FUZZ=1000000` runs as many of every target. Sums that run over are told.

#![allow(clippy::disallowed_methods, reason = "tests read and write files, and ask other programs")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, non_snake_case, missing_docs)]

mod chance;
#[path = "../common/workbook.rs"]
#[allow(dead_code, reason = "the fuzzer takes only some of what tests share")]
mod package;
mod targets;

use std::fs;
use std::io::Write as _;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

use chance::{Chance, changed};
use targets::Work;

const TESTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests");

/// Words of programs, of every dialect.
const WORDS: [&str; 60] = [
    "\n",
    "G0 ",
    "G1 ",
    "G2 ",
    "G3 ",
    "G4 ",
    "G10 L2 P1 ",
    "G20 ",
    "G21 ",
    "G28 ",
    "G32 ",
    "G33 ",
    "G41 ",
    "G42 ",
    "G40 ",
    "G43 H1 ",
    "G50 S3000 ",
    "G53 ",
    "G54 ",
    "G70 P10 Q20 ",
    "G71 U1 R1\n",
    "G71 P10 Q20 U0.2 W0.1 F0.2\n",
    "G76 ",
    "G81 ",
    "G83 ",
    "G84 ",
    "G90 ",
    "G91 ",
    "G92 ",
    "G93 ",
    "G95 ",
    "G96 ",
    "G98 ",
    "G99 ",
    "M2\n",
    "M30\n",
    "M98 P1 ",
    "M99 ",
    "X",
    "Z",
    "U",
    "W",
    "I",
    "K",
    "R",
    "F",
    "S",
    "T0101\n",
    "N10 ",
    "#1=",
    "[",
    "]",
    "o1 while [1]\n",
    "o1 endwhile\n",
    "(",
    ")",
    "%\n",
    "/",
    "(RPT N1,N2) N9\n",
    ";",
];

/// Pieces of a package.
const XML: [&str; 28] = [
    "<",
    ">",
    "\"",
    "&",
    "&#0;",
    "&#x110000;",
    "</c>",
    "<c>",
    "<v>",
    "<f>",
    "9999999999",
    "-",
    "inf",
    "XFD1048577",
    "t=\"s\" ",
    "t=\"n\" ",
    "t=\"e\" ",
    "r=\"A1\" ",
    "<row>",
    "<!--",
    "]]>",
    "\u{0}",
    "_xD800_",
    "[",
    "s=\"77\" ",
    "../",
    "=== ",
    "\n",
];

/// How many inputs each target is given.
fn count(usual: u64) -> u64 {
    std::env::var("RODETE_FUZZ").ok().and_then(|count| count.parse().ok()).unwrap_or(usual)
}

/// The texts of all files below a folder, in the order of their names.
fn files(folder: &str) -> Vec<(PathBuf, Vec<u8>)> {
    fn into(found: &mut Vec<PathBuf>, folder: &Path) {
        let Ok(entries) = fs::read_dir(folder) else { return };
        for entry in entries.flatten() {
            if entry.path().is_dir() { into(found, &entry.path()) } else { found.push(entry.path()) }
        }
    }
    let mut found = Vec::new();
    into(&mut found, &Path::new(TESTS).join(folder));
    found.sort();
    found.into_iter().map(|path| (path.clone(), fs::read(path).unwrap())).collect()
}

/// Runs a target on the kept inputs as they are, then on as many changed ones. What brings it down is written beside
/// the build, to be kept.
fn run(name: &str, seeds: &[(PathBuf, Vec<u8>)], words: &[&str], count: u64, target: fn(&[u8]) -> Work) {
    assert!(!seeds.is_empty(), "{name}: no inputs to begin with");
    let mut sum = Work::default();
    let mut one = |bytes: &[u8], which: &str| match catch_unwind(AssertUnwindSafe(|| target(bytes))) {
        Ok(work) => {
            sum.read += work.read;
            sum.motions += work.motions;
        }
        Err(panic) => {
            let kept = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}-down"));
            fs::write(&kept, bytes).unwrap();
            eprintln!("{name}: {which} brings it down; kept as {}", kept.display());
            std::panic::resume_unwind(panic);
        }
    };
    for (path, bytes) in seeds {
        one(bytes, &path.display().to_string());
    }
    let mut chance = Chance::new(2021);
    for number in 0..count {
        let [seed, other] = [chance.below(seeds.len()), chance.below(seeds.len())];
        let bytes = changed(&seeds[seed].1, &seeds[other].1, words, &mut chance);
        one(&bytes, &format!("input {number} (from {})", seeds[seed].0.display()));
        if count >= 100_000 && number % 10_000 == 0 {
            let _ = writeln!(std::io::stderr(), "{name}: {number}");
        }
    }
    println!("{name}: {count} inputs, {} read, {} motions", sum.read, sum.motions);
}

#[test]
fn programs_by_chance_are_read_or_refused_under_every_dialect() {
    let mut seeds = files("controls");
    seeds.extend(files("fuzz/corpus/program"));
    seeds.retain(|(path, bytes)| bytes.len() < 20_000 && path.extension().is_none_or(|ending| ending != "rs"));
    run("program", &seeds, &WORDS, count(3_000), targets::program);
}

#[test]
fn turning_programs_by_chance_are_followed_or_refused() {
    let mut seeds = files("fuzz/corpus/simulate");
    for (path, bytes) in files("controls/fanuc-lathe-a/bad") {
        if bytes.len() < 4_000 {
            seeds.push((path, [b"60 120 0\n".as_slice(), &bytes].concat()));
        }
    }
    run("simulate", &seeds, &WORDS, count(800), targets::simulate);
}

#[test]
fn parameter_files_by_chance_are_read_or_refused() {
    run(
        "var_file",
        &files("fuzz/corpus/var_file"),
        &["\n", "\t", "5220", "5601", "1e99", "-"],
        count(5_000),
        targets::var_file,
    );
}

#[test]
fn tool_tables_by_chance_are_read_or_refused() {
    let mut seeds = files("fuzz/corpus/tools");
    seeds.extend(
        files("controls").into_iter().filter(|(path, _)| path.extension().is_some_and(|ending| ending == "tbl")),
    );
    run(
        "tool_table",
        &seeds,
        &["\n", "T1 ", "P1 ", "Z1 ", "D3 ", "Q3 ", "I95 ", "J5 ", ";", "X"],
        count(5_000),
        targets::tools,
    );
}

#[test]
fn workbooks_by_chance_are_computed_or_refused() {
    let mut seeds = files("fuzz/corpus/package");
    for kind in rodete::kinds::KINDS {
        for case in kind.cases() {
            let parts = package::Parts::of(&package::written(*kind, case, rodete::text::Language::Es)).0;
            let mut laid_out = Vec::new();
            for (name, content) in parts {
                laid_out.extend_from_slice(format!("=== {name}\n").as_bytes());
                laid_out.extend_from_slice(&content);
                laid_out.push(b'\n');
            }
            seeds.push((PathBuf::from(case.name), laid_out));
        }
    }
    run("workbook", &seeds, &XML, count(700), targets::package);
}
