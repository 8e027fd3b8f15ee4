//! Every command, run on the kind as on the others.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

/// Runs this binary in a folder.
fn run(folder: &Path, words: &[&str]) -> Output {
    Command::new(std::env::current_exe().unwrap()).args(words).current_dir(folder).env("KEPT", folder).output().unwrap()
}

fn done(folder: &Path, words: &[&str]) -> String {
    let output = run(folder, words);
    assert!(output.status.success(), "{words:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

pub fn every_command() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path();
    assert!(done(folder, &["--version"]).contains("workbook bolt-circle: schema bolt-circle 1"));
    done(folder, &["new", "bolt-circle", "flange.xlsx", "--lang", "en"]);
    let checked: Value = serde_json::from_str(&done(folder, &["check", "flange.xlsx", "--json"])).unwrap();
    assert_eq!(checked["workbooks"][0]["quantities"][0]["symbol"], "c");
    let chord = checked["workbooks"][0]["quantities"][0]["value"].as_f64().unwrap();
    assert!((chord - 40.0).abs() < 1e-9, "the chord of a sixth is the radius: {chord}");

    // A stand-in for typst keeps what the report is made of.
    let keeps = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/typst/keeps.sh");
    let report = if cfg!(unix) { ["--typst", keeps.to_str().unwrap()].to_vec() } else { vec!["--no-report"] };
    done(folder, &[vec!["build", "flange.xlsx", "-o", "out"], report].concat());
    let mut names: Vec<_> = fs::read_dir(folder.join("out"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    let report = if cfg!(unix) { vec!["flange-report.pdf"] } else { Vec::new() };
    let others = ["flange-results.xlsx", "flange-viewer.html"];
    assert_eq!(names, [vec!["flange-holes.nc"], report, others.to_vec()].concat());
    let program = fs::read_to_string(folder.join("out/flange-holes.nc")).unwrap();
    assert_eq!(program.matches("G1 Z-12.000").count(), 6, "{program}");
    assert!(program.contains("G0 X34.641 Y20.000") && program.contains("G0 X0.000 Y40.000"), "{program}");
    done(folder, &["verify", "out/flange-holes.nc"]);
    #[cfg(unix)]
    {
        let contents = fs::read(folder.join("report.typ/contents.json")).unwrap();
        let contents: Value = serde_json::from_slice(&contents).unwrap();
        assert_eq!((&contents["kind"], &contents["tables"][0]["key"]), (&"bolt-circle".into(), &"holes".into()));
        let verified = &contents["tables"][1];
        assert_eq!(verified["key"], "verification");
        assert!(verified["head"].to_string().contains("Every hole at its angle"), "{verified}");
        assert!(folder.join("report.typ/kind/setup.typ").exists(), "its chapters stand beside the templates");
    }
    // The compiler inside is that of any binary that is made so.
    if cfg!(feature = "embedded-typst") {
        done(folder, &["build", "flange.xlsx", "-o", "set"]);
        assert!(fs::read(folder.join("set/flange-report.pdf")).unwrap().starts_with(b"%PDF-"));
    }
    done(folder, &["view", "flange.xlsx", "-o", "flange.html"]);
    assert!(fs::read_to_string(folder.join("flange.html")).unwrap().contains("flange.xlsx"));

    // The results are an input again; a workbook of another kind is none.
    done(folder, &["check", "out/flange-results.xlsx"]);
    let other = Path::new(env!("CARGO_MANIFEST_DIR")).join("workbooks/impeller.xlsx");
    assert_eq!(run(folder, &["check", other.to_str().unwrap()]).status.code(), Some(3));
    let explained = done(folder, &["explain", "B0001", "--lang", "en"]);
    assert!(
        explained.contains("holes-meet") && explained.contains("The holes would cut into one another."),
        "{explained}"
    );
    contradictions();
    println!("bolt circle: every command ran");
}

/// Both contradictions, told of the cells that make them, and both edges of each.
fn contradictions() {
    use rodete::kind::method::Of;
    use rodete::kind::{Kind as _, Provenance, Wants};
    use rodete::parameter::field::Fields;
    use rodete::parameter::{Value, Values};
    use rodete::text::Language;
    let codes = |key, value: f64| -> Vec<&str> {
        let mut values = Values { language: Language::En, ..Values::default() };
        values.values.extend(crate::FORM.cases[0].values(Language::En));
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
    assert_eq!((codes("d", 40.1), codes("d", 39.9)), (vec!["B0001"], vec![]));
    assert_eq!((codes("h", 40.1), codes("h", 40.0)), (vec!["B0002"], vec![]));
}
