//! Workbooks: every case in both languages, written for each control that its kind can be written for, and what a
//! machine reads of what `build` makes of it.

use std::fs;

use rayon::prelude::*;
use rodete::kind::Kind;
use rodete::kinds::KINDS;
use rodete::parameter::{FieldKind, Value};
use rodete::text::Language;

use crate::command::Place;
use crate::golden::Item;
use crate::package::Parts;
use crate::plain::Sums;

/// Cells that are given other values: by their defined name, and what stands in them, in Spanish behind `|` where that is
/// another word.
type Edits = &'static [(&'static str, &'static str)];

/// A case as it is written for a control.
struct Variant {
    kind: &'static str,
    case: &'static str,
    control: &'static str,
    /// What tells it from another of the same case and control.
    name: &'static str,
    edits: Vec<(&'static str, &'static str)>,
}

const FAGOR: &str = "fagor-8055";
const FAGOR_8070: &str = "fagor-8070";
const LINUXCNC: &str = "linuxcnc";

/// What a kind's case needs to be written for a control that is not its own, beside the control's name. LinuxCNC knows neither
/// M11 nor M13, and moves only with F: the published layout has none.
const NEEDS: [([&str; 3], Edits); 6] = [
    (["impeller", "full", FAGOR_8070], &[("retract", "")]),
    (["impeller", "full", LINUXCNC], &[("start_codes", "M3")]),
    (["impeller", "clear", FAGOR_8070], &[("retract", "")]),
    (["impeller", "clear", LINUXCNC], &[("start_codes", "M3")]),
    (
        ["impeller", "tfg-2021", LINUXCNC],
        &[("start_codes", "M3"), ("style", "full"), ("feed_F", "300"), ("speed_S", "6000")],
    ),
    (["pipe-insert", "3on4-2023", LINUXCNC], &[("style", "full"), ("feed_F", "2000")]),
];

/// A kind's case in another way under a name of its own, for some controls.
const FURTHER: [([&str; 3], &[&str], Edits); 3] = [
    (["impeller", "full", "absolute"], &[FAGOR], &[("distance", "G90"), ("rotary_axes", "linear")]),
    (["pipe-insert", "square", "flat"], &[LINUXCNC, FAGOR, FAGOR_8070], &[("mode", "flat|plano")]),
    (["lathe", "shaft", "turned-round"], &["fanuc-lathe-a"], &SECOND),
];

/// Every case of a kind for every control that it can be written for.
fn variants(kind: &dyn Kind) -> Vec<Variant> {
    let form = kind.form();
    // A program that stands on a sheet of its own is written by the engineer, for one control.
    let own_alone = form.lists.iter().any(|list| list.is_program);
    let (_, dialect) = form.parameters().find(|(_, one)| one.name == "dialect").unwrap();
    let FieldKind::Choice(controls) = &dialect.kind else { panic!("{}: a list of controls", form.kind) };
    let mut made = Vec::new();
    for case in kind.cases() {
        let values = case.values(Language::En);
        let own = |control| values.contains(&(dialect.key, Value::Choice(control)));
        for control in controls.iter().map(|choice| choice.key).filter(|control| !own_alone || own(control)) {
            let named = (!own(control)).then_some((dialect.name, control));
            let needs =
                NEEDS.iter().find(|(of, _)| *of == [form.kind, case.name, control]).map_or(&[][..], |one| one.1);
            let edits: Vec<_> = named.into_iter().chain(needs.iter().copied()).collect();
            let further = FURTHER.iter().filter(|([of, one, _], controls, _)| {
                *of == form.kind && *one == case.name && controls.contains(&control)
            });
            for ([.., name], _, more) in further {
                let edits = edits.iter().chain(*more).copied().collect();
                made.push(Variant { kind: form.kind, case: case.name, control, name, edits });
            }
            made.push(Variant { kind: form.kind, case: case.name, control, name: "", edits });
        }
    }
    made
}

/// The other end of the shaft is faced, and a wanted profile.
const SECOND: [(&str, &str); 13] = [
    ("PROGRAM 2!A6", "O0002"),
    ("PROGRAM 2!A7", "G21 G40 G97 G99"),
    ("PROGRAM 2!A8", "G50 S2500"),
    ("PROGRAM 2!A9", "T0101"),
    ("PROGRAM 2!A10", "G96 S180 M3"),
    ("PROGRAM 2!A11", "G0 X54. Z0. M8"),
    ("PROGRAM 2!A12", "G1 X-1.6 F0.15"),
    ("PROGRAM 2!A13", "G0 Z2."),
    ("PROGRAM 2!A14", "G0 X100. Z50. M9"),
    ("PROGRAM 2!A15", "M5"),
    ("PROGRAM 2!A16", "M30"),
    ("block_delete", ""),
    ("second_Z_s", "1"),
];

/// The workbook of a variant, and what a machine reads of what is built from it.
fn made(variant: &Variant, language: &str) -> Vec<Item> {
    let Variant { kind, case, control, name, edits } = variant;
    let place = Place::new();
    let stem = "book";
    let (book, other) = (format!("{stem}.xlsx"), format!("{stem}-new.xlsx"));
    place.run(&["new", kind, &other, "--case", case, "--lang", language]);
    let spoken = |value: &'static str| match value.split_once('|') {
        Some((en, es)) => {
            if language == "es" {
                es
            } else {
                en
            }
        }
        None => value,
    };
    let sheet =
        |cell: &'static str| if language == "es" { cell.replace("PROGRAM ", "PROGRAMA ") } else { cell.to_owned() };
    let edits: Vec<(String, &str)> = edits.iter().map(|(cell, value)| (sheet(cell), spoken(value))).collect();
    let edits: Vec<(&str, &str)> = edits.iter().map(|(cell, value)| (cell.as_str(), *value)).collect();
    let new = Parts::of(&place.read(&other));
    let under = format!("{kind}/{case}/{language}/{control}{}{name}", if name.is_empty() { "" } else { "-" });
    let mut items = Vec::new();
    place.write(&book, &new.with(&edits).zip());
    fs::remove_file(place.path(&other)).unwrap();

    let mut sums = Sums::default();
    sums.take(&book, &place.read(&book));
    let built = place.run(&["build", &book, "--no-report", "-o", "out"]);
    let files = place.files("out");
    assert!(
        files.len() > 3,
        "{under} is not built. If this control needs other cells in this case, add a line to NEEDS, as (\
         [\"{kind}\", \"{case}\", \"{control}\"], &[(\"NAME OF THE CELL\", \"VALUE\")]); else mend what build says:\n{}",
        String::from_utf8_lossy(&built.stderr)
    );
    files.iter().for_each(|file| sums.take(file, &place.read(&format!("out/{file}"))));
    for file in files.iter().filter(|file| [".nc", ".dxf", ".stl"].iter().any(|ending| file.ends_with(ending))) {
        let name = file.strip_prefix(stem).unwrap().trim_start_matches('-');
        items.push(Item::new(format!("{under}/{name}"), &sums.named(&place.read(&format!("out/{file}")))));
    }
    items
}

/// Every case of a kind in both languages for every control.
pub fn of(kind: &dyn Kind) -> Vec<Item> {
    let variants = variants(kind);
    let pairs: Vec<_> = variants.iter().flat_map(|variant| ["en", "es"].map(|language| (variant, language))).collect();
    pairs.par_iter().flat_map_iter(|(variant, language)| made(variant, language)).collect()
}

/// Fails where an exception names a case that no kind has.
pub fn every_exception_is_one() {
    let made: Vec<_> = KINDS.iter().flat_map(|kind| variants(*kind)).collect();
    for (of, _) in NEEDS {
        assert!(made.iter().any(|one| [one.kind, one.case, one.control] == of), "{of:?}");
    }
    for (of, controls, _) in FURTHER {
        assert_eq!(made.iter().filter(|one| [one.kind, one.case, one.name] == of).count(), controls.len(), "{of:?}");
    }
}
