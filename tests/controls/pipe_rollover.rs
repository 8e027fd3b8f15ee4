//! Programs of branches and holes for a control whose rotary axes may be rollover.

use crate::common;
use crate::common::change::{Change, real};

use rodete::finding::Grade;
use rodete::gcode::control::RotaryMode;
use rodete::gcode::interpreter::Setting;
use rodete::gcode::motion::{Motion, MotionKind};
use rodete::gcode::program::{Part, Program};
use rodete::gcode::word::Word;
use rodete::kind::method::Method;
use rodete::kind::{Outcome, Provenance};
use rodete::kinds;
use rodete::kinds::pipe::{hole, insert};
use rodete::machine::axis::Axis;
use rodete::parameter::field::Fields;
use rodete::parameter::{Value, Values};
use rodete::proof::check::Check;
use rodete::proof::rollover;
use rodete::text::Language;

const KINDS: [&str; 2] = ["hole", "insert"];

/// Joints square, leaning and off the middle: the last begin at an angle of A that is not 0.
fn joints() -> [Vec<Change>; 3] {
    [
        vec![],
        vec![real("theta", 75.0), real("e", 9.0), real("D_max", 40.0)],
        vec![real("theta", 100.0), real("e", -9.0), real("D_max", 40.0)],
    ]
}

fn values(kind: &str, dialect: &'static str, changes: &[Change]) -> Values {
    let mut values = Values { language: Language::En, ..Values::default() };
    if kind == "hole" {
        values.values.extend(hole::cases::CASES[0].values(Language::En));
    } else {
        values.values.extend(insert::cases::CASES[0].values(Language::En));
        values.values.insert("mode", Value::Choice("rotary"));
    }
    values.values.extend(changes.iter().filter(|(key, _)| kind == "hole" || *key != "D_max").cloned());
    values.values.insert("dialect", Value::Choice(dialect));
    values
}

fn outcome(kind: &str, dialect: &'static str, changes: &[Change]) -> Outcome {
    let form = if kind == "hole" { &hole::parameters::FORM } else { &insert::parameters::FORM };
    let source = Provenance { workbook: "case.xlsx".to_owned(), sha256: "0".repeat(64), version: "test" };
    let outcome = kinds::run(form, values(kind, dialect, changes), source)
        .unwrap_or_else(|refusal| panic!("{kind} {dialect} {changes:?}: {:?}", refusal.findings));
    assert!(!outcome.stopped(), "{kind} {dialect} {changes:?}: {:?}", outcome.findings);
    outcome
}

fn motions(program: &Program, rotary: RotaryMode) -> Vec<Motion> {
    let setting = Setting { rotary, ..program.setting() };
    program.read_back_with(setting).collect::<Result<_, _>>().expect("it is read")
}

/// The motions at feed: where each ends.
fn cuts(motions: &[Motion]) -> Vec<[f64; 6]> {
    let feeds = motions.iter().filter(|motion| matches!(motion.kind, MotionKind::Feed(_)));
    feeds.map(|motion| [Axis::X, Axis::Y, Axis::Z, Axis::A, Axis::B, Axis::C].map(|axis| motion.to.get(axis))).collect()
}

fn notes(outcome: &Outcome) -> String {
    outcome.findings.iter().filter(|one| one.grade == Grade::Note).map(|one| format!("{}\n", one.what.en)).collect()
}

#[test]
fn on_a_fagor_8055_both_kinds_of_rotary_axes_make_the_motions_of_the_plan() {
    for kind in KINDS {
        for joint in joints() {
            let made = outcome(kind, "fagor-8055", &joint);
            let program = &made.programs[0];
            let [rollover, linear] = [RotaryMode::Rollover, RotaryMode::Linear].map(|rotary| motions(program, rotary));
            assert_eq!(rollover.len(), linear.len(), "{kind} {joint:?}");
            for (one, other) in rollover.iter().zip(&linear) {
                assert_eq!((one.line, one.from, one.to), (other.line, other.from, other.to), "{kind} {joint:?}");
                for by in &one.to.differences(&one.from)[3..6] {
                    assert!(matches!(one.kind, MotionKind::Rapid) || by.abs() <= 180.0, "{kind} line {}", one.line);
                }
            }
            // The plan of the dialect whose axes are linear: the feeds do not bear on it here.
            let theirs = outcome(kind, "fagor-8070", &joint);
            let [ours, theirs] = [cuts(&rollover), cuts(&motions(&theirs.programs[0], RotaryMode::Linear))];
            assert!(ours.len() > 20 && ours.len() == theirs.len(), "{kind} {joint:?}");
            for (ours, theirs) in ours.iter().zip(&theirs) {
                assert!(ours.iter().zip(theirs).all(|(one, other)| (one - other).abs() < 1e-6), "{ours:?} {theirs:?}");
            }
        }
    }
}

/// Word by word, without the interpreter: under G90 no rotary axis has a word, and a hole leaves them at 0 for the next run.
#[test]
fn rotary_words_stand_in_blocks_of_g91_only() {
    for kind in KINDS {
        for joint in joints() {
            let text = outcome(kind, "fagor-8055", &joint).programs[0].text();
            let (mut incremental, mut sums, mut most) = (false, [0.0_f64; 3], 0.0_f64);
            for line in text.lines().filter(|line| line.starts_with('N')) {
                for word in line.split(' ').skip(1) {
                    match word {
                        "G90" => incremental = false,
                        "G91" => incremental = true,
                        _ => {
                            let Some(axis) = word.chars().next().and_then(|letter| "ABC".find(letter)) else {
                                continue;
                            };
                            assert!(incremental, "{kind} {joint:?}: {line}");
                            let by: f64 = word[1..].parse().expect("a number");
                            assert!(by != 0.0, "{kind} {joint:?}: {line}");
                            sums[axis] += by;
                            most = most.max(sums[axis].abs());
                        }
                    }
                }
            }
            assert!(!incremental && most > 300.0, "{kind} {joint:?}: {most}");
            let rest = sums.map(f64::abs).into_iter().fold(0.0, f64::max);
            assert!(if kind == "hole" { rest < 1e-6 } else { rest > 360.0 }, "{kind} {joint:?}: {sums:?}");
        }
    }
}

#[test]
fn header_notes_and_checks_say_which_rotary_axes_a_program_is_true_for() {
    for (kind, before) in [("hole", "A B C MUST SHOW 0 BEFORE"), ("insert", "A MUST SHOW 0 BEFORE")] {
        for (dialect, header, note, row) in [
            (
                "fagor-8055",
                "VALID FOR ROLLOVER AND LINEAR ROTARY AXES",
                "suits rollover and linear axes",
                "rollover and linear: ",
            ),
            ("fagor-8070", "ROLLOVER AX", "right only if A", "linear axes only"),
            ("linuxcnc", "ROLLOVER AX", "right only if A", "linear axes only"),
        ] {
            let outcome = outcome(kind, dialect, &[]);
            let text = outcome.programs[0].text();
            assert!(text.contains(header), "{kind} {dialect}");
            assert_eq!(text.contains(before), dialect == "fagor-8055", "{kind} {dialect}");
            assert_eq!(text.contains("VALID ONLY IF A"), dialect != "fagor-8055", "{kind} {dialect}");
            assert!(notes(&outcome).contains(note), "{kind} {dialect}: {}", notes(&outcome));
            let table = outcome.table("verification").expect("the table");
            assert!(format!("{:?}", table.columns).contains(row), "{kind} {dialect}");
        }
    }
    let flat = outcome("insert", "fagor-8055", &[("mode", Value::Choice("flat"))]);
    assert!(!flat.programs[0].text().contains("G91") && !notes(&flat).contains("rollover"));
}

/// What these programs were before: the absolute words of the other dialect turn a rollover axis the wrong way.
#[test]
fn an_absolute_program_is_stopped_where_the_axes_may_be_rollover() {
    for kind in KINDS {
        let absolute = outcome(kind, "fagor-8070", &[]).programs.remove(0).program;
        let check = rollover::check(&absolute, RotaryMode::Rollover);
        assert_eq!(check.grade(), Some(Grade::Stop), "{kind}");
        let mut words = outcome(kind, "fagor-8055", &[]).programs.remove(0).program;
        assert_eq!(rollover::check(&words, RotaryMode::Rollover).grade(), None, "{kind}");
        let incremental = [Word::whole('G', 91)];
        words.parts.retain(|part| !matches!(part, Part::Block(words) if *words == incremental));
        assert_eq!(rollover::check(&words, RotaryMode::Rollover).grade(), Some(Grade::Stop), "{kind}");
    }
}

/// The checks on a text in the place of a program's own.
fn judged<M: Method>(values: &Values, program: &Program, text: &str) -> Vec<Check> {
    let design = M::design(&Fields::of(M::FORM, values.clone()).unwrap()).expect("a design");
    common::checks::<M>(&design, &M::model(&design).expect("a model"), program, text)
}

/// One increment half a degree wrong, or one that is missing, in a sound text.
#[test]
fn a_wrong_increment_is_caught() {
    for kind in KINDS {
        let values = values(kind, "fagor-8055", &[]);
        let program = outcome(kind, "fagor-8055", &[]).programs.remove(0).program;
        let text = program.text();
        let agreement = |text: &str| {
            let checks = if kind == "hole" {
                judged::<hole::Hole>(&values, &program, text)
            } else {
                judged::<insert::Insert>(&values, &program, text)
            };
            checks.iter().find(|check| check.key() == "agreement").expect("the row").grade()
        };
        assert_eq!(agreement(&text), None, "{kind}");
        let turning = |line: &&str| line.contains(" G1 ") && line.contains(" A");
        let line = text.lines().filter(turning).nth(7).expect("a turn");
        let word = line.split(' ').find(|word| word.starts_with('A')).expect("a word");
        let by: f64 = word[1..].parse().expect("a number");
        for wrong in [line.replace(word, &format!("A{:.3}", by + 0.5)), line.replace(&format!(" {word}"), "")] {
            assert_eq!(agreement(&text.replace(line, &wrong)), Some(Grade::Stop), "{kind}: {wrong}");
        }
    }
}
