//! Every command, run on the kind as on the others.

use std::fs;
use std::path::Path;
use std::process::{Command, ExitCode, Output};

use rodete::finding::{Finding, Refusal, Rule};
use rodete::kind::measure::Limits;
use rodete::kind::method::Of;
use rodete::kind::{Chapters, Kind, Outcome, Provenance, Wants};
use rodete::parameter::field::Fields;
use rodete::parameter::{Case, Form};
use serde_json::Value;

use crate::every_kind::every_command;
use crate::form::Sense;

/// Runs this binary in a folder.
fn run(folder: &Path, words: &[&str]) -> Output {
    Command::new(std::env::current_exe().unwrap()).args(words).current_dir(folder).env("KEPT", folder).output().unwrap()
}

fn done(folder: &Path, words: &[&str]) -> String {
    let output = run(folder, words);
    assert!(output.status.success(), "{words:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

pub fn tried() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path();
    every_command(&[&Of::<crate::Kind>::new()], &run);
    done(folder, &["new", "bolt-circle", "flange.xlsx", "--lang", "en"]);
    let checked: Value = serde_json::from_str(&done(folder, &["check", "flange.xlsx", "--json"])).unwrap();
    assert_eq!(checked["workbooks"][0]["quantities"][0]["symbol"], "c");
    let chord = checked["workbooks"][0]["quantities"][0]["value"].as_f64().unwrap();
    assert!((chord - 40.0).abs() < 1e-9, "the chord of a sixth is the radius: {chord}");

    // A stand-in for typst keeps what the report is made of.
    let keeps = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/typst/keeps.sh");
    let report = if cfg!(unix) { ["--typst", keeps.to_str().unwrap()].to_vec() } else { vec!["--no-report"] };
    done(folder, &[vec!["build", "flange.xlsx", "-o", "out"], report].concat());
    let program = fs::read_to_string(folder.join("out/flange-holes.nc")).unwrap();
    assert_eq!(program.matches("G1 Z-12.000").count(), 6, "{program}");
    assert!(program.contains("G0 X34.641 Y20.000") && program.contains("G0 X0.000 Y40.000"), "{program}");
    done(folder, &["verify", "out/flange-holes.nc"]);
    #[cfg(unix)]
    {
        let contents = fs::read(folder.join("report.typ/contents.json")).unwrap();
        let contents: Value = serde_json::from_slice(&contents).unwrap();
        assert_eq!(contents["tables"][0]["key"], "holes");
        for key in ["setup", "circle"] {
            let drawn =
                fs::read_to_string(folder.join("report.typ").join(contents["figures"][key]["file"].as_str().unwrap()));
            assert!(drawn.unwrap().starts_with("<svg"), "{key}");
        }
        let verified = &contents["tables"][1];
        assert_eq!(verified["key"], "verification");
        assert!(verified["head"].to_string().contains("Every hole at its angle"), "{verified}");
        // The program was written along the path, whatever the control's law of rotary axes.
        assert!(program.contains("G94") && !program.contains("G93"), "{program}");
        assert_eq!(contents["feed_law"], "resultant");
    }
    // The compiler inside is that of any binary that is made so.
    if cfg!(feature = "embedded-typst") {
        done(folder, &["build", "flange.xlsx", "-o", "set"]);
        assert!(fs::read(folder.join("set/flange-report.pdf")).unwrap().starts_with(b"%PDF-"));
    }
    // Hints and help name this binary, and its kind.
    let name = std::env::current_exe().unwrap().file_stem().unwrap().to_str().unwrap().to_owned();
    assert!(done(folder, &["check", "flange.xlsx"]).contains(&format!("next: {name} build flange.xlsx")));
    let help = done(folder, &["help", "new"]);
    assert!(help.contains(&format!("{name} new bolt-circle my-bolt-circle.xlsx")), "{help}");
    assert!(!help.contains("rodete new"), "{help}");
    // A workbook of another kind is none, and nor are its rows.
    let other = Path::new(env!("CARGO_MANIFEST_DIR")).join("workbooks/impeller.xlsx");
    assert_eq!(run(folder, &["check", other.to_str().unwrap()]).status.code(), Some(3));
    assert_eq!(run(folder, &["explain", "P1001"]).status.code(), Some(2));
    contradictions();
    // A binary in which a code is two rows' does nothing at all.
    let ended = rodete::cli::run(["flange".into(), "--version".into()], &[&Of::<crate::Kind>::new(), &Again]);
    assert_eq!(format!("{ended:?}"), format!("{:?}", ExitCode::FAILURE));
    println!("bolt circle: every command ran");
}

mod again {
    use rodete::finding::Example;
    use rodete::text::t;

    rodete::rules! {
        /// A code that the bolt circle has.
        RULES;
        "K0001" Again Stop {}
            es "otra vez" en "again" remedy "", ""; why "", "";
            example Example::Never(t("", ""));
    }
}

/// The same kind with rows of its own.
struct Again;

impl Kind for Again {
    fn form(&self) -> &'static Form {
        &crate::FORM
    }
    fn cases(&self) -> &'static [Case] {
        &crate::CASES
    }
    fn chapters(&self) -> &'static Chapters {
        Of::<crate::Kind>::new().chapters()
    }
    fn rules(&self) -> &'static [&'static [&'static Rule]] {
        &[again::RULES]
    }
    fn design(&self, fields: &Fields) -> Result<(), Vec<Finding>> {
        Of::<crate::Kind>::new().design(fields)
    }
    fn limits(&self, fields: &Fields) -> Result<Limits, Refusal> {
        Of::<crate::Kind>::new().limits(fields)
    }
    fn run(&self, fields: Fields, found: Vec<Finding>, source: Provenance, wants: Wants) -> Result<Outcome, Refusal> {
        Of::<crate::Kind>::new().run(fields, found, source, wants)
    }
}

/// Both contradictions, told of the cells that make them, and both edges of each.
fn contradictions() {
    use rodete::parameter::{Value, Values};
    use rodete::text::Language;
    let codes = |key, value: f64| -> Vec<&str> {
        let mut values = Values::of(&crate::form::CASES[0], Language::En);
        values.values.insert(key, Value::Real(value));
        let source = Provenance { workbook: "flange.xlsx".into(), sha256: "0".repeat(64), version: "1" };
        let fields = Fields::of(&crate::FORM, values).unwrap();
        match Of::<crate::Kind>::new().run(fields, Vec::new(), source, Wants::default()) {
            Ok(outcome) => {
                assert_eq!(outcome.programs.len(), 1);
                Vec::new()
            }
            Err(refusal) => refusal.findings.iter().map(|one| one.rule().code).collect(),
        }
    };
    assert_eq!((codes("d", 40.1), codes("d", 39.9)), (vec!["K0001"], vec![]));
    assert_eq!((codes("h", 40.1), codes("h", 40.0)), (vec!["K0002"], vec![]));
    // What is chosen from a list is the type's own word.
    let second = |way| {
        let mut values = Values::of(&crate::form::CASES[0], Language::En);
        values.put(&crate::form::WAY, Some(way));
        let circle = crate::BoltCircle::new(&Fields::of(&crate::FORM, values).unwrap()).unwrap();
        circle.angle(1)
    };
    assert_eq!((second(Sense::Left), second(Sense::Right)), (90.0, -30.0));
}
