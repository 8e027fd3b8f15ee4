//! `THIRD-PARTY.md` names what the binary is made of, as `Cargo.lock` has it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use crate::markdown::root;

/// Packages of the lock: name and version with the packages that each needs.
type Locked = BTreeMap<(String, String), Vec<String>>;

fn locked() -> Locked {
    let text = fs::read_to_string(root().join("Cargo.lock")).unwrap();
    let packages = text.split("[[package]]").skip(1).map(|package| {
        let value = |key: &str| {
            let line = package.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(" = ")).unwrap();
            line.trim_matches('"').to_owned()
        };
        let needs = package.split_once("dependencies = [").map_or("", |(_, rest)| rest.split(']').next().unwrap());
        let needs = needs.split('"').skip(1).step_by(2).map(str::to_owned).collect();
        ((value("name"), value("version")), needs)
    });
    packages.collect()
}

/// The names under `[dependencies]`, of every platform.
fn wanted() -> BTreeSet<String> {
    let (mut names, mut inside) = (BTreeSet::new(), false);
    for line in fs::read_to_string(root().join("Cargo.toml")).unwrap().lines() {
        if line.starts_with('[') {
            inside = line == "[dependencies]" || (line.starts_with("[target.") && line.ends_with(".dependencies]"));
        } else if let Some((name, _)) = line.split_once(" = ").filter(|_| inside && !line.starts_with('#')) {
            names.insert(name.to_owned());
        }
    }
    names
}

/// All that the binary is made of or built with.
fn carried() -> BTreeSet<(String, String)> {
    let (locked, wanted) = (locked(), wanted());
    let own = locked.iter().find(|((name, _), _)| name == "rodete").unwrap().1;
    let mut to_do: Vec<String> =
        own.iter().filter(|need| wanted.contains(need.split(' ').next().unwrap())).cloned().collect();
    let mut found = BTreeSet::new();
    while let Some(need) = to_do.pop() {
        let mut words = need.split(' ');
        let (name, version) = (words.next().unwrap(), words.next());
        let meant = |(other, of): &(String, String)| other == name && version.is_none_or(|version| version == of);
        let (package, needs) = locked.iter().find(|(package, _)| meant(package)).unwrap();
        if found.insert(package.clone()) {
            to_do.extend(needs.iter().cloned());
        }
    }
    found
}

#[test]
fn every_crate_of_the_binary_stands_with_its_licence() {
    let page = fs::read_to_string(root().join("THIRD-PARTY.md")).unwrap();
    let mut told = BTreeSet::new();
    for row in page.lines().filter(|line| line.starts_with("| [")) {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        let name = cells[1].trim_start_matches('[').split(']').next().unwrap();
        told.insert((name.to_owned(), cells[2].to_owned()));
        for licence in cells[4].split(", ") {
            let heading = |line: &str| line.strip_prefix("### ").is_some_and(|rest| rest.starts_with(licence));
            assert!(page.lines().any(heading), "{name}: the text of {licence} is not there");
        }
    }
    let carried = carried();
    assert!(carried.len() > 100, "the lock is read: {}", carried.len());
    let missing: Vec<_> = carried.difference(&told).collect();
    let gone: Vec<_> = told.difference(&carried).collect();
    assert!(missing.is_empty() && gone.is_empty(), "missing {missing:?}, gone {gone:?}: run .ci/third-party");
}

#[test]
fn the_fonts_inside_the_binary_stand_with_their_licences() {
    let page = fs::read_to_string(root().join("THIRD-PARTY.md")).unwrap();
    let of_fonts = page.split("### typst-assets").nth(1).expect("the notice of the fonts");
    for said in ["Libertinus Serif", "SIL OPEN FONT LICENSE", "GUST Font License", "Bitstream Vera", "Foxit"] {
        assert!(of_fonts.contains(said), "{said}");
    }
}

#[test]
fn the_licence_of_the_crate_is_there_in_full() {
    for (name, said) in [("LICENSE-MIT", "The rodete authors"), ("LICENSE-APACHE", "END OF TERMS AND CONDITIONS")] {
        assert!(fs::read_to_string(root().join(name)).unwrap().contains(said), "{name}");
    }
}
