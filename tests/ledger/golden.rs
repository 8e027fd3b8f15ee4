//! Items, their sums, and the golden file that they are held against.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::{env, fs};

use rodete::kinds::KINDS;
use sha2::{Digest, Sha256};

/// The first words of the items' names, one for each test, beside the kinds: those have an area each.
const AREAS: [&str; 7] = ["help", "motions", "offsets", "refused", "simulate", "verify", "view"];

/// True for the first word of an item's name.
fn is_area(name: &str) -> bool {
    AREAS.contains(&name) || KINDS.iter().any(|kind| kind.form().kind == name)
}

/// Most names that a run prints, whatever its areas.
const SHOWN: usize = 40;

/// Most names that one area prints.
const OF_AREA: usize = 12;

/// How many names are left to be printed; held also while the golden file is rewritten.
static LEFT: Mutex<usize> = Mutex::new(SHOWN);

/// An output under its name.
pub struct Item {
    name: String,
    sum: String,
}

impl Item {
    /// An output in the form in which it is compared; written below the folder that `RODETE_LEDGER_TEXTS` names, if it does.
    pub fn new(name: impl Into<String>, text: &[u8]) -> Self {
        let name = name.into();
        assert!(!name.contains(char::is_whitespace), "{name}");
        if let Some(folder) = env::var_os("RODETE_LEDGER_TEXTS") {
            let path = PathBuf::from(folder).join(format!("{name}.txt"));
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        }
        let mut sum = hexadecimal(text);
        sum.truncate(16);
        Self { name, sum }
    }
}

/// The SHA-256 of bytes, in lower-case hexadecimal.
pub fn hexadecimal(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

fn file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/ledger.txt")
}

/// The lines of the golden file: name and sum.
fn golden() -> BTreeMap<String, String> {
    let text = fs::read_to_string(file()).unwrap_or_default();
    text.lines().filter_map(|line| line.split_once(' ')).map(|(name, sum)| (name.into(), sum.into())).collect()
}

fn area(name: &str) -> &str {
    name.split('/').next().unwrap_or_default()
}

/// Holds every item of an area against the golden file, or writes them into it.
pub fn hold(of: &str, items: Vec<Item>) {
    if let Some(differing) = differing(of, items) {
        panic!("{differing}");
    }
}

/// What differs from the golden file of an area's items, which are written into it where that is asked for.
pub fn differing(of: &str, items: Vec<Item>) -> Option<String> {
    assert!(is_area(of), "{of}");
    let found: BTreeMap<_, _> = items.iter().map(|item| (item.name.clone(), item.sum.clone())).collect();
    assert_eq!(found.len(), items.len(), "{of}: two items of one name");
    assert!(found.len() > 4 && found.keys().all(|name| area(name) == of), "{of}: {} items", found.len());
    let mut left = LEFT.lock().unwrap();
    let mut golden = golden();
    if env::var_os("RODETE_LEDGER").is_some_and(|what| what == "write") {
        golden.retain(|name, _| area(name) != of);
        golden.extend(found);
        let text: String = golden.iter().map(|(name, sum)| format!("{name} {sum}\n")).collect();
        fs::write(file(), text).unwrap();
        return None;
    }
    golden.retain(|name, _| area(name) == of);
    let names: BTreeSet<_> = found.keys().chain(golden.keys()).collect();
    let differing: Vec<_> = names.into_iter().filter(|name| found.get(*name) != golden.get(*name)).collect();
    if differing.is_empty() {
        return None;
    }
    let mut text = format!("{of}: {} of {} items differ from tests/golden/ledger.txt\n", differing.len(), found.len());
    let shown = differing.len().min(OF_AREA).min(*left);
    *left -= shown;
    drop(left);
    for name in &differing[..shown] {
        let how = match (found.contains_key(*name), golden.contains_key(*name)) {
            (true, true) => "changed",
            (true, false) => "new",
            _ => "gone",
        };
        let _ = writeln!(text, "  {how:8}{name}");
    }
    if shown < differing.len() {
        let _ = writeln!(text, "  … and {} more", differing.len() - shown);
    }
    Some(format!(
        "{text}Where that is meant, accept it with\n    RODETE_LEDGER=write cargo test --test ledger\nand say why in the commit. \
         To see what has changed run it with RODETE_LEDGER_TEXTS=FOLDER before and after, then diff -r.\n"
    ))
}

/// Whether the golden file is sorted, and each of its lines a name of a known area and a sum.
pub fn well_formed() {
    let text = fs::read_to_string(file()).unwrap();
    let lines: Vec<_> = text.lines().collect();
    assert!(
        lines.is_sorted_by(|one, next| one.split(' ').next() < next.split(' ').next()),
        "sorted, and no name twice"
    );
    for line in lines {
        let (name, sum) = line.split_once(' ').unwrap();
        assert!(is_area(area(name)) && sum.len() == 16, "{line}");
        assert!(sum.bytes().all(|byte| byte.is_ascii_hexdigit()), "{line}");
    }
}
