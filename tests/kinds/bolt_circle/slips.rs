//! One word of the program changed: the build stops, and the judge whose question it is says so.

use rodete::finding::Grade;
use rodete::gcode::header::Origin;
use rodete::gcode::program::{Part, Program};
use rodete::kind::method::{Method, judged};
use rodete::parameter::Values;
use rodete::parameter::field::Fields;
use rodete::text::Language;

use crate::design::BoltCircle;

/// What is changed, from what to what, and the checks that must stop the build.
type Slip = (&'static str, [&'static str; 2], &'static [&'static str]);

const SLIPS: [Slip; 13] = [
    ("retract left out", ["N60 G0 Z5.000", "N60 M9"], &["agreement", "feed-tip", "clearance"]),
    ("retract half-way", ["N60 G0 Z5.000", "N60 G0 Z-1.000"], &["agreement", "clearance"]),
    ("first retract left out", ["N30 G0 Z5.000", "N30 M9"], &["agreement", "clearance"]),
    ("last retract left out", ["N210 G0 Z5.000", "N210 M9"], &["agreement"]),
    ("feed times 100", ["F120.000", "F12000.000"], &["agreement", "feed-tip"]),
    ("feed a hundredth", ["F120.000", "F1.200"], &["agreement"]),
    ("no feed", [" F120.000", ""], &["reading"]),
    ("rapid plunge", ["G1 Z-12.000", "G0 Z-12.000"], &["agreement", "clearance", "angles"]),
    ("hole skipped", ["N80 G1 Z-12.000", "N80 M9"], &["agreement", "angles"]),
    ("wrong place", ["X34.641", "X34.643"], &["agreement", "angles"]),
    ("wrong depth", ["Z-12.000", "Z-12.100"], &["agreement", "angles"]),
    ("spindle stopped", ["S1200 M3", "S1200"], &["spindle"]),
    ("spindle too fast", ["S1200", "S12000"], &["spindle"]),
];

/// The text of the usual case's program, and the keys of the checks that stop the build where it is read instead.
fn stopped(slip: Option<[&str; 2]>) -> (String, Vec<&'static str>) {
    let fields = Fields::of(&crate::FORM, Values::of(&crate::form::CASES[0], Language::En)).unwrap();
    let circle = BoltCircle::new(&fields).unwrap();
    let origin = Origin { workbook: "flange.xlsx", sha256: "0", version: "1", language: Language::En };
    let program = crate::Kind::programs(&circle, &(), &origin).unwrap().programs.remove(0);
    let mut text = program.text();
    if let Some([from, to]) = slip {
        assert!(text.contains(from), "{from} is not in\n{text}");
        text = text.replacen(from, to, 1);
    }
    let parts = text.lines().map(|line| Part::Line(line.to_owned())).collect();
    let read = Program { parts, ..program.clone() };
    let checks = judged::<crate::Kind>(&circle, &(), &mut (), &program, &read).checks;
    let stops = checks.iter().filter(|check| check.grade() == Some(Grade::Stop));
    (text, stops.map(rodete::proof::check::Check::key).collect())
}

pub fn every_slip_stops_the_build() {
    let (text, stops) = stopped(None);
    assert_eq!(stops, [""; 0], "{text}");
    let other = SLIPS.into_iter().filter_map(|(name, slip, wanted)| {
        let (_, stops) = stopped(Some(slip));
        (stops != wanted).then(|| format!("{name}: {stops:?} stop the build and not {wanted:?}"))
    });
    let other: Vec<_> = other.collect();
    assert!(other.is_empty(), "{}", other.join("\n"));
}
