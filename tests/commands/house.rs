//! The house: floors, layout and sizes.

#![allow(clippy::expect_used)]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use proc_macro2::{TokenStream, TokenTree};

/// Every top-level module with its floor: a module uses its own floor and those below.
const FLOORS: [(&str, u8); 22] = [
    ("text", 0),
    ("escape", 0),
    ("finding", 0),
    ("table", 0),
    ("parameter", 0),
    ("figure", 0),
    ("number", 0),
    ("limits", 0),
    ("geometry", 1),
    ("machine", 2),
    ("gcode", 3),
    ("scene", 4),
    ("removal", 4),
    ("proof", 5),
    ("kind", 6),
    ("kinds", 7),
    ("workbook", 8),
    ("report", 8),
    ("drawing", 8),
    ("typeset", 8),
    ("view", 8),
    ("store", 8),
];
/// Above all of them: the commands, and what is linked into the binary alone.
const ROOF: [&str; 3] = ["cli", "main", "embedded_typst"];

/// The most lines of a file.
const LINES: usize = 600;

const TOP: [&str; 10] = [
    "Cargo.toml",
    "Cargo.lock",
    "README.md",
    "CHANGELOG.md",
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

/// Every Rust file under a folder of the repository, by its path in it.
fn sources(folder: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![root().join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).into_iter().flatten() {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                found.push(path.strip_prefix(root()).expect("a path in the repository").to_owned());
            }
        }
    }
    found.sort();
    found
}

/// The module path of a source file below the crate: `src/cli/show.rs` is `cli`, `show`.
fn module(path: &Path) -> Vec<String> {
    let mut parts: Vec<_> =
        path.with_extension("").iter().skip(1).map(|part| part.to_string_lossy().into_owned()).collect();
    if parts.last().is_some_and(|last| last == "mod" || last == "lib") {
        parts.pop();
    }
    parts
}

/// The modules that code names: first steps of paths from the crate's root, and their beginnings from any other crate.
#[derive(Debug, Default, PartialEq, Eq)]
struct Uses {
    /// Top-level modules of this crate.
    own: BTreeSet<String>,
    /// Paths of `std` and other crates, three steps at most, as `std::fs::write`.
    foreign: BTreeSet<String>,
}

impl Uses {
    /// The uses of a file at a depth below the crate's root. Comments are no code.
    fn of(code: &str, depth: usize) -> Self {
        let mut uses = Self::default();
        uses.walk(TokenStream::from_str(code).expect("Rust code"), depth);
        uses
    }

    fn walk(&mut self, stream: TokenStream, depth: usize) {
        let tokens: Vec<_> = stream.into_iter().collect();
        let mut at = 0;
        while let Some(token) = tokens.get(at) {
            match token {
                TokenTree::Ident(word) if !follows_colons(&tokens, at) => {
                    let mut up = 0;
                    let mut next = at;
                    while let Some(TokenTree::Ident(word)) = tokens.get(next)
                        && word == "super"
                    {
                        up += 1;
                        next += 3;
                    }
                    let at_root = word == "crate" || word == "rodete" || (up > 0 && up == depth);
                    if at_root {
                        let after = if up > 0 { next } else { at + 3 };
                        self.own.extend(steps(&tokens, after, 1));
                    } else if up == 0 && colons(&tokens, at + 1) {
                        self.foreign.extend(steps(&tokens, at, 3));
                    }
                }
                TokenTree::Group(group) => {
                    let inline_module = at >= 2
                        && matches!(&tokens[at - 2], TokenTree::Ident(word) if word == "mod")
                        && matches!(&tokens[at - 1], TokenTree::Ident(_));
                    self.walk(group.stream(), depth + usize::from(inline_module));
                }
                _ => {}
            }
            at += 1;
        }
    }
}

fn colons(tokens: &[TokenTree], at: usize) -> bool {
    let colon = |at| matches!(tokens.get(at), Some(TokenTree::Punct(mark)) if mark.as_char() == ':');
    colon(at) && colon(at + 1)
}

fn follows_colons(tokens: &[TokenTree], at: usize) -> bool {
    at >= 2 && colons(tokens, at - 2)
}

/// The paths that begin at a token, with at most `most` steps; a `{ … }` gives one for each of its branches.
fn steps(tokens: &[TokenTree], at: usize, most: usize) -> Vec<String> {
    match tokens.get(at) {
        Some(TokenTree::Ident(word)) if most > 1 && colons(tokens, at + 1) => {
            let rest = steps(tokens, at + 3, most - 1);
            if rest.is_empty() {
                return vec![word.to_string()];
            }
            rest.into_iter().map(|rest| format!("{word}::{rest}")).collect()
        }
        Some(TokenTree::Ident(word)) => vec![word.to_string()],
        Some(TokenTree::Group(group)) => {
            let tokens: Vec<_> = group.stream().into_iter().collect();
            tokens
                .split(|token| matches!(token, TokenTree::Punct(mark) if mark.as_char() == ','))
                .flat_map(|branch| steps(branch, 0, most))
                .collect()
        }
        _ => Vec::new(),
    }
}

fn floor(module: &str) -> Option<u8> {
    FLOORS.iter().find(|(name, _)| *name == module).map(|(_, floor)| *floor)
}

fn uses(path: &Path) -> Uses {
    let code = fs::read_to_string(root().join(path)).expect("a source file");
    Uses::of(&code, module(path).len())
}

#[test]
fn uses_are_found_in_every_form() {
    let code = "
        //! crate::comment::Is not code.
        use crate::{text::Text, finding::{self, Finding}};
        use super::table::Unit;
        fn f() { crate::number::round(1.0); println!(\"{} crate::string::x\", crate::gcode::WORD); }
        mod tests { use super::*; use super::super::figure::Ink; use std::fs::{self, File}; }
    ";
    let uses = Uses::of(code, 1);
    let own: Vec<_> = uses.own.iter().map(String::as_str).collect();
    assert_eq!(own, ["figure", "finding", "gcode", "number", "table", "text"]);
    assert!(uses.foreign.contains("std::fs::self") && uses.foreign.contains("std::fs::File"), "{uses:?}");
    // One level further down, `super` is the file's own module.
    assert_eq!(Uses::of("use super::table::Unit; use super::super::text::Text;", 2).own.len(), 1);
}

#[test]
fn every_module_has_a_floor_and_uses_nothing_above_it() {
    let mut faults = Vec::new();
    for path in sources("src") {
        let module = module(&path);
        let Some(top) = module.first() else { continue };
        if ROOF.contains(&top.as_str()) {
            continue;
        }
        let Some(own) = floor(top) else {
            faults.push(format!("{}: module {top} has no floor", path.display()));
            continue;
        };
        for other in uses(&path).own {
            if ROOF.contains(&other.as_str()) || floor(&other).is_some_and(|other| other > own) {
                faults.push(format!("{}: floor {own} uses {other} above it", path.display()));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn no_modules_use_one_another_in_a_circle() {
    let mut edges: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for path in sources("src") {
        if let Some(top) = module(&path).first() {
            let others = uses(&path).own.into_iter().filter(|other| other != top && floor(other).is_some());
            edges.entry(top.clone()).or_default().extend(others);
        }
    }
    // Modules that use nothing that is left are taken away; what cannot be taken away is a circle.
    while let Some(leaf) = edges.iter().find(|(_, others)| others.iter().all(|other| !edges.contains_key(other))) {
        let leaf = leaf.0.clone();
        edges.remove(&leaf);
    }
    assert!(edges.is_empty(), "a circle among {edges:?}");
}

#[test]
fn nothing_below_the_edge_reaches_the_outside_world() {
    const OUTSIDE: [&str; 12] = [
        "std::env",
        "std::fs",
        "std::net",
        "std::os",
        "std::process",
        "std::thread",
        "std::time::Instant",
        "std::time::SystemTime",
        "std::io::stdin",
        "std::io::stdout",
        "std::io::stderr",
        "tempfile",
    ];
    // Its thread gets polygons in their order and is awaited: what comes out hangs on nothing else.
    let awaited =
        |path: &Path, used: &str| path.ends_with("turning/second_removal.rs") && used.starts_with("std::thread::");
    let mut faults = Vec::new();
    for path in sources("src") {
        let module = module(&path);
        if module.first().is_some_and(|top| floor(top).is_some_and(|floor| floor < 8)) {
            for used in uses(&path).foreign {
                let reaches = |outside: &&str| used == **outside || used.starts_with(&format!("{outside}::"));
                if OUTSIDE.iter().any(reaches) && !awaited(&path, &used) {
                    faults.push(format!("{}: {used}", path.display()));
                }
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn files_are_written_by_the_store_alone_and_read_by_the_gate_alone() {
    const FILES: [&str; 3] = ["fs::", "File::", "OpenOptions::"];
    const LOOKS: [&str; 3] = ["fs::metadata", "fs::symlink_metadata", "fs::canonicalize"];
    // The report fills a private temporary folder and the compiler in the child process works in it.
    const MAY: [&str; 5] =
        ["src/store/", "src/workbook/open.rs", "src/report/", "src/typeset/", "src/embedded_typst.rs"];
    let found = uses(Path::new("src/store/disk.rs")).foreign;
    assert!(found.contains("fs::create_dir"), "the store is seen to write: {found:?}");
    let mut faults = Vec::new();
    for path in sources("src") {
        let shown = path.display().to_string().replace('\\', "/");
        if MAY.iter().any(|may| shown.starts_with(may)) {
            continue;
        }
        for used in uses(&path).foreign {
            let used = used.trim_start_matches("std::");
            if FILES.iter().any(|file| used.starts_with(file)) && !LOOKS.contains(&used) {
                faults.push(format!("{shown}: {used}"));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn the_store_changes_files_through_its_disk_alone() {
    const CHANGES: [&str; 9] = [
        "File::create",
        "File::create_new",
        "fs::copy",
        "fs::create_dir",
        "fs::hard_link",
        "fs::remove_dir",
        "fs::remove_file",
        "fs::rename",
        "fs::write",
    ];
    let changes = |path: &Path| {
        let foreign = uses(path).foreign;
        CHANGES.into_iter().filter(|change| foreign.contains(*change)).collect::<Vec<_>>()
    };
    let disk = changes(Path::new("src/store/disk.rs"));
    assert_eq!(disk.len(), 6, "the disk is seen to change files: {disk:?}");
    for path in sources("src/store").into_iter().filter(|path| !path.ends_with("disk.rs")) {
        // The clearing up before a process ends, about whose errors nothing can be done, and the file of a test.
        let found: Vec<_> = changes(&path)
            .into_iter()
            .filter(|change| !(path.ends_with("draft.rs") && *change != "fs::rename"))
            .collect();
        assert!(found.is_empty(), "{}: {found:?}", path.display());
    }
}

#[test]
fn the_top_of_the_repository_holds_what_it_should() {
    for entry in fs::read_dir(root()).expect("the repository") {
        let name = entry.expect("an entry").file_name().to_string_lossy().into_owned();
        let built = name == "target";
        assert!(built || name.starts_with('.') || TOP.contains(&name.as_str()), "{name} has no place here");
    }
}

/// What a control does is data: code that asks for its name or identity would do something else for the next control.
#[test]
fn no_code_asks_which_control_it_is() {
    let asks = |line: &str| {
        ["control.name", "dialect.name"].into_iter().any(|name| {
            let (before, behind) = line.split_once(name).unwrap_or_default();
            let before = before.trim_end_matches(|one: char| one.is_alphanumeric() || "_.&*".contains(one)).trim_end();
            let behind = behind.trim_start();
            ["==", "!=", ".", "{"].into_iter().any(|one| behind.starts_with(one))
                || ["==", "!=", "match"].into_iter().any(|one| before.ends_with(one))
        }) || ["ptr::eq", "system_a", "feed_required"].into_iter().any(|word| line.contains(word))
    };
    assert!(asks("if design.control.name == \"linuxcnc\" {") && asks("match dialect.name {"));
    assert!(asks("control.name.starts_with(\"fanuc\")") && asks("\"linuxcnc\" != self.control.name"));
    assert!(!asks("format!(\"{}\", program.control.name)") && !asks("let name = self.control.name;"));
    for path in sources("src").into_iter().filter(|path| !path.starts_with("src/gcode/control")) {
        let text = fs::read_to_string(root().join(&path)).expect("a source file");
        let found = text.lines().find(|line| asks(line));
        assert_eq!(found, None, "{}", path.display());
    }
}

#[test]
fn no_file_is_too_long() {
    for path in ["src", "tests", "benches"].into_iter().flat_map(sources) {
        let lines = fs::read_to_string(root().join(&path)).expect("a source file").lines().count();
        assert!(lines <= LINES, "{}: {lines} lines, at most {LINES}: split it", path.display());
    }
}
