//! The turning of the blank: what passes, and one fault at a time.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use proptest::prelude::*;
use rodete::finding::Grade;
use rodete::gcode::program::Program;
use rodete::gcode::word::NumberFormat;
use rodete::kind::method::Method;
use rodete::kinds::impeller::design::Design;
use rodete::kinds::impeller::{Impeller, Model};
use rodete::parameter::Value;
use rodete::proof::check::Check;

use super::common;

/// The design of a case with its blank's program.
fn blank(case: &str, changes: &[(&'static str, Value)]) -> (Design, Program) {
    let design = Design::new(&common::fields(case, changes)).unwrap();
    let mut programs = common::outcome(case, changes).programs.into_iter().map(|proved| proved.program);
    (design, programs.find(|program| program.key == "blank").unwrap())
}

/// The blades, of which the judges of the blank ask nothing.
static BLADES: LazyLock<Model> = LazyLock::new(|| {
    let design = Design::new(&common::fields("full", &[])).unwrap();
    Impeller::model(&design).unwrap()
});

/// The checks on a text in the place of a design's program of the blank.
fn checks(design: &Design, program: &Program, text: &str) -> BTreeMap<&'static str, Check> {
    let checks = common::checks::<Impeller>(design, &BLADES, program, text);
    for check in &checks {
        if check.grade() > Some(Grade::Note) {
            let finding = check.finding().unwrap_or_else(|| panic!("{check:?}"));
            assert!(!finding.what.es.is_empty() && !finding.remedy.es.is_empty());
        }
    }
    checks.into_iter().map(|check| (check.key(), check)).collect()
}

/// The checks beyond what passed or informs.
fn raised(checks: &BTreeMap<&'static str, Check>) -> Vec<(&'static str, Option<Grade>)> {
    let raised = checks.values().filter(|check| check.grade() > Some(Grade::Note));
    raised.map(|check| (check.key(), check.grade())).collect()
}

fn millimetres(check: &Check) -> f64 {
    check.value().en.strip_suffix(" mm").unwrap().parse().unwrap()
}

#[test]
fn the_shipped_cases_leave_the_torus() {
    let (design, program) = blank("full", &[]);
    let found = checks(&design, &program, &program.text());
    assert_eq!(raised(&found), []);
    assert_eq!(found.len(), 10, "{found:?}");
    assert_eq!(found["blank-time"].value().en, "64.1 s");
    assert_eq!(found["blank-depth"].value().en, "1 mm");
    // Tool and offset have numbers of their own.
    let (design, program) = blank("full", &[("T_b", Value::Whole(3)), ("D_b", Value::Whole(1))]);
    assert!(program.text().contains("T3 D1"), "{}", program.text());
    assert_eq!(raised(&checks(&design, &program, &program.text())), []);
    // What the published layout lacks is said; of its missing S a caution of the form speaks (P1021), and the reading does not repeat it.
    let (design, program) = blank("tfg-2021", &[]);
    let lacks = [("blank-speed-limit", Some(Grade::Caution))];
    assert_eq!(raised(&checks(&design, &program, &program.text())), lacks);
}

#[test]
fn the_printed_program_leaves_the_torus_within_a_micrometre() {
    let (design, program) = blank("tfg-2021", &[]);
    let found = checks(&design, &program, include_str!("../../golden/lathe-g85-as-printed.nc"));
    for side in ["blank-metal-left", "blank-metal-missing"] {
        assert_eq!(found[side].grade(), None);
        assert!(millimetres(&found[side]) < 0.001);
    }
    assert_eq!(found["blank-rapid"].grade(), None);
    assert_eq!(found["blank-alarms"].value().en, "0");
    assert_eq!(found["blank-time"].value().en, "60.4 s");
}

#[test]
fn one_fault_in_the_text_is_found_by_its_check() {
    let (design, program) = blank("full", &[]);
    let text = program.text();
    for (good, bad, key) in [
        // A digit of the cycle: what the control refuses, and what it does not.
        ("G85 X50.000", "G85 X51.000", "reading"),
        ("Z-15.000", "Z-16.000", "reading"),
        ("K15.000", "K16.000", "reading"),
        ("Q20.000", "Q21.000", "reading"),
        ("R0.000", "R1.000", "reading"),
        ("R0.000", "R-1.000", "reading"),
        ("I0.000", "I1.000", "reading"),
        ("I0.000 K15.000", "I15.000 K0.000", "reading"),
        ("K15.000", "K-15.000", "reading"),
        ("C1.000", "C0.000", "reading"),
        ("G85 X50.000", "G85 X50.016", "blank-metal-left"),
        ("Z-15.000", "Z-15.008", "blank-metal-missing"),
        ("Z-15.000", "Z-14.992", "blank-metal-left"),
        ("Q20.000", "Q20.010", "blank-metal-left"),
        ("K15.000", "K15.008", "blank-metal-missing"),
        // The arc about the other centre, as G3 in the place of G2.
        ("I0.000 K15.000", "I-15.000 K0.000", "blank-metal-left"),
        ("G85 X50.000 Z-15.000 Q20.000 R0.000 C1.000 I0.000 K15.000", "G4 K0", "blank-metal-left"),
        ("C1.000", "C2.000", "blank-depth"),
        // The facing, its height and its end.
        ("G1 X-0.400 F0.100", "G4 K0", "blank-metal-left"),
        ("G0 X51.000 Z0.000", "G0 X51.000 Z1.000", "blank-metal-left"),
        ("G0 X51.000 Z0.000", "G0 X51.000 Z-0.010", "blank-metal-missing"),
        ("G1 X-0.400", "G1 X0.400", "blank-metal-left"),
        ("G0 X51.000 Z0.000", "G4 K0", "blank-metal-left"),
        // Rapid into the part: down to it, across it, out through it, and by a control that brings Z there first.
        ("G0 X51.000 Z0.000", "G0 X31.000 Z0.000", "blank-rapid"),
        ("G1 X-0.400", "G0 X-0.400", "blank-rapid"),
        ("G0 X80.000 Z80.000", "G0 X40.000 Z-20.000", "blank-rapid"),
        ("G0 X50.000 Z50.000", "G0 X20.000 Z50.000", "blank-rapid"),
        ("G0 X55.000 Z0.000", "G4 K0", "reading"),
        ("G0 X55.000 Z0.000", "G0 X45.000 Z0.000", "reading"),
        // Under other terms.
        ("F0.100", "F1.000", "blank-terms"),
        ("G96 S300", "G96 S3000", "blank-terms"),
        ("G96 S300", "G97 S300", "blank-terms"),
        ("M4", "M3", "blank-terms"),
        ("M4", "M5", "blank-terms"),
        ("G90 G95", "G90 G94", "blank-terms"),
        ("N20 T1 D1", "N20 T2 D1", "reading"),
        ("N20 T1 D1", "N20 T1 D2", "reading"),
        ("G92 S3000", "G92 S5000", "blank-speed-limit"),
        ("G92 S3000", "G4 K0", "blank-speed-limit"),
        ("M30", "G4 K0", "reading"),
    ] {
        assert_eq!(text.matches(good).count(), 1, "{good}");
        let found = checks(&design, &program, &text.replace(good, bad));
        let stopped = found.get(key).is_some_and(|check| check.grade() == Some(Grade::Stop));
        assert!(stopped, "{bad}: {key} is not among {:?}", raised(&found));
    }
}

#[test]
fn a_way_that_is_clear_only_straight_is_told_from_one_that_is_clear_on_any() {
    let (design, program) = blank("full", &[]);
    let text = program.text();
    // From X20 Z50 straight to X51 Z0 the tool passes the corner of the stock; with Z there first it is in the face.
    let found = checks(&design, &program, &text.replace("G0 X50.000 Z50.000", "G0 X20.000 Z50.000"));
    assert_eq!(raised(&found), [("blank-rapid", Some(Grade::Stop))]);
    let found = checks(&design, &program, &text.replace("G0 X50.000 Z50.000", "G0 X60.000 Z90.000"));
    assert_eq!(raised(&found), []);
}

#[test]
fn a_stock_beyond_what_is_followed_is_a_caution() {
    let mut design = Design::new(&common::fields("full", &[])).unwrap();
    design.torus.R = 501.0;
    design.blank.X_e = 1100.0;
    let program = design.blank.program(design.torus, NumberFormat::Fixed, 10).unwrap();
    assert_eq!(raised(&checks(&design, &program, &program.text())), [("blank-followed", Some(Grade::Caution))]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn every_blank_leaves_its_torus(
        R in 5.0..500.0_f64, part in 0.2..0.95_f64, step in 0.02..1.0_f64, long in 1.001..20.0_f64,
        (Z_b, c_f, c_o, c_c) in (1.0..60.0_f64, 0.1..20.0_f64, 0.0..10.0_f64, 0.1..20.0_f64),
        (X_e, Z_e) in (0.1..100.0_f64, 1.0..60.0_f64), fixed in any::<bool>(),
    ) {
        let mut design = Design::new(&common::fields("full", &[])).unwrap();
        let r = (R * part).max(1.0);
        design.torus = rodete::geometry::torus::Torus { R, r };
        let blank = &mut design.blank;
        (blank.C, blank.L_b) = ((r * step).clamp(0.01, 20.0), (r * long).min(5000.0));
        (blank.Z_b, blank.c_f, blank.c_o, blank.c_c) = (Z_b, c_f, c_o, c_c);
        (blank.X_e, blank.Z_e) = (2.0 * R + X_e, Z_e);
        let format = if fixed { NumberFormat::Fixed } else { NumberFormat::Trimmed };
        let program = design.blank.program(design.torus, format, 10).unwrap();
        let text = program.text();
        let found = checks(&design, &program, &text);
        let stops: Vec<_> = found.values().filter(|check| {
            check.grade() == Some(Grade::Stop) && (fixed || check.key() != "blank-speed-limit")
        }).collect();
        prop_assert!(stops.is_empty(), "{stops:?}\n{text}");
        prop_assert_eq!(found["blank-alarms"].grade(), None, "{:?}\n{}", found["blank-alarms"], text);
    }
}
