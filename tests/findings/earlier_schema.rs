//! Workbooks of schema 1 called the height H a tool length L_t, and R_B they called R_p: they are read, and told about.

use crate::common;
use crate::common::workbook;

use common::{outcome, program, source};
use rodete::finding::{Grade, Place};
use rodete::kind;
use rodete::kinds;
use rodete::kinds::impeller::parameters::FORM;
use rodete::parameter::Value;
use workbook::{DATA, Parts};

/// The published case as it was shipped under schema 1, in Spanish, with the defined names of then.
const OLD: &[u8] = include_bytes!("../golden/impeller-schema-1.xlsx");

#[test]
fn a_workbook_of_schema_1_gives_the_same_figures_and_a_caution_at_its_cells() {
    let filled = rodete::workbook::read(OLD, &[&FORM]).expect("it is read");
    assert_eq!(common::real(&filled.values, "H"), Some(95.4));
    assert_eq!(common::real(&filled.values, "R_B"), Some(147.5));
    let [told] = filled.findings.as_slice() else { panic!("{:?}", filled.findings) };
    assert_eq!(told.grade, Grade::Caution);
    assert!(told.what.en.contains("rodete reads L_t as H and takes L = R_p + L_t"), "{}", told.what.en);
    assert!(told.what.es.contains("rodete lee L_t como H"), "{}", told.what.es);
    assert!(told.remedy.en.contains("rodete new"), "{}", told.remedy.en);
    let Place::Cells(cells) = &told.place else { panic!("{:?}", told.place) };
    let cells: Vec<&str> = cells.iter().map(|cell| cell.cell.as_str()).collect();
    assert_eq!(cells, ["C23", "C19", "C6"]);

    let old = kinds::run(&FORM, filled.values, source()).expect("it is computed");
    let new = outcome("tfg-2021", &[]);
    for key in ["blade", "splitter", "impeller", "blank"] {
        assert_eq!(program(&old, key), program(&new, key), "{key}");
    }
    let L = |outcome: &kind::Outcome| outcome.quantities.iter().find(|one| one.symbol == "L").map(|one| one.value);
    assert_eq!(L(&old), Some(242.9));
    assert_eq!(L(&new), L(&old));
}

#[test]
fn both_symbols_beside_each_other_are_one_too_many() {
    let part = Parts::of(OLD);
    let data = part.text(DATA);
    let free = data.replace(">d_s<", ">H<");
    let shared = part.0.iter().find(|one| one.0 == "xl/sharedStrings.xml").map(|_| part.text("xl/sharedStrings.xml"));
    let changed = match shared {
        Some(strings) => part.put("xl/sharedStrings.xml", strings.replace(">d_s<", ">H<")),
        None => part.put(DATA, free),
    };
    let refusal = rodete::workbook::read(&changed.zip(), &[&FORM]).expect_err("it is refused");
    let what: Vec<&str> = refusal.findings.iter().map(|finding| &*finding.what.en).collect();
    assert!(what.contains(&"2 rows have the symbol H"), "{what:?}");
}

/// A tool length has no part in the datum: neither form, nor header of a program, nor figures name one.
#[test]
fn no_tool_length_is_part_of_the_datum() {
    assert!(FORM.parameter("L_t").is_none() && FORM.parameter("R_p").is_none());
    let names: Vec<&str> = FORM.parameters().map(|(_, parameter)| parameter.name).collect();
    assert!(names.contains(&"height_H") && names.contains(&"spindle_height_R_B"), "{names:?}");
    assert!(names.iter().all(|name| !name.contains("tool_length")), "{names:?}");
    let text = program(&outcome("full", &[("H", Value::Real(60.0))]), "blade");
    assert!(text.contains("PIVOT LENGTH L 207.500 FROM B AXIS TO TORUS CENTRE"), "{text}");
    assert!(text.contains("L IS R_B 147.500 PLUS H 60.000"), "{text}");
    assert!(!text.contains("LENGTH 60.000") && !text.contains("L_T"), "{text}");
}
