//! What must be answered: of every kind and program, what a judge leaves out stops the build, and so does what it only tells
//! where it should judge.

use std::collections::BTreeSet;

use rodete::finding::Grade;
use rodete::gcode::header::Origin;
use rodete::gcode::program::Program;
use rodete::kind::Wants;
use rodete::kind::method::{Method, judged};
use rodete::kinds::impeller::Impeller;
use rodete::kinds::pipe::hole::Hole;
use rodete::kinds::pipe::insert::Insert;
use rodete::parameter::field::Fields;
use rodete::parameter::{Value, Values};
use rodete::proof;
use rodete::proof::check::{Answer, Check, Question};
use rodete::proof::rules::NotAnswered;
use rodete::proof::step::{Judge, Step};
use rodete::text::Language;

use super::Prepared;

/// What a program is asked whatever its kind, and what is told beside an answer: nobody would miss it.
const BESIDE: [&str; 3] = ["characters", "needed-n", "reading"];

/// What may be told of a design of which it was judged: arcs that another program has not, the edge of a path that leaves the
/// curve, splitters that a pass is meant to reach, and axes that are linear.
const TOLD: [&str; 4] = ["arcs", "edge", "rotary", "splitters"];

/// Answers as others did before.
struct Replay(Vec<Check>);

impl Judge for Replay {
    fn see(&mut self, _: &Step<'_>) {}

    fn checks(self: Box<Self>, _: &Program) -> Vec<Check> {
        self.0
    }
}

/// The keys that nobody answers where these checks are all there is.
fn missing<M: Method>(
    design: &M::Design,
    model: &M::Model,
    program: &Program,
    checks: Vec<Check>,
) -> Vec<&'static str> {
    let (setting, plan, due) = (M::setting(design, program), M::plan(design, model, program), M::due(design, program));
    let rapids = M::rapids(design, program);
    let judged = proof::of(program, setting, plan, vec![Box::new(Replay(checks))], &due, M::ANSWERED, rapids);
    let unanswered = judged.checks.iter().filter(|check| check.finding().is_some_and(|one| one.is(NotAnswered::RULE)));
    let unanswered = unanswered.inspect(|check| assert_eq!(check.grade(), Some(Grade::Stop)));
    unanswered.map(Check::key).collect()
}

/// Leaves out each answer of each program in turn, or only tells it; the keys that are due by program.
fn every_answer_is_missed<M: Method>(values: Values) -> BTreeSet<(&'static str, &'static str)> {
    let design = M::design(&Fields::of(M::FORM, values).unwrap()).unwrap();
    let model = M::model(&design).unwrap();
    let origin = Origin { workbook: "", sha256: "", version: "", language: Language::En };
    let programs = M::programs(&design, &model, &origin).unwrap().programs;
    assert!(!programs.is_empty());
    let (mut memo, mut keys) = (M::memo(&design, &model, Wants::default()), BTreeSet::new());
    for program in &programs {
        let checks = judged::<M>(&design, &model, &mut memo, program, program).checks;
        let checks: Vec<Check> = checks.into_iter().filter(|check| !BESIDE.contains(&check.key())).collect();
        let missing = |checks: Vec<Check>| missing::<M>(&design, &model, program, checks);
        assert_eq!(missing(checks.clone()), [""; 0], "{}", program.key);
        let due = M::due(&design, program);
        let mut asked: BTreeSet<&str> = checks.iter().map(Check::key).collect();
        let listed: BTreeSet<&str> = due.iter().map(proof::due::Due::key).collect();
        if listed.contains("faces") {
            // A pass of a clear cut begins where a move outside the part ends: that is asked of `clear-moves`.
            asked.remove("safe-points");
        }
        assert_eq!((asked, due.len()), (listed.clone(), listed.len()), "{}", program.key);
        for key in listed {
            let others: Vec<Check> = checks.iter().filter(|check| check.key() != key).cloned().collect();
            assert_eq!(missing(others.clone()), [key], "{}", program.key);
            // Another key with the same beginning is no answer.
            let longer: &'static str = Box::leak(format!("{key}-word").into_boxed_str());
            let alike = [longer, &key[..key.len() - 1]]
                .map(|key| Question::new(key, checks[0].name().clone(), program).seen(1).passes());
            assert_eq!(missing(others.iter().cloned().chain(alike).collect()), [key], "{}", program.key);
            let all_judged =
                checks.iter().filter(|check| check.key() == key).all(|one| *one.answer() != Answer::Informs);
            let told = Question::new(key, checks[0].name().clone(), program).informs();
            let told = missing(others.into_iter().chain([told]).collect());
            if all_judged && !TOLD.contains(&key) {
                assert_eq!(told, [key], "{}", program.key);
            }
            keys.insert((program.key, key));
        }
    }
    keys
}

fn impeller(case: &str, changes: &[(&'static str, Value)]) -> BTreeSet<(&'static str, &'static str)> {
    every_answer_is_missed::<Impeller>(crate::common::values(case, changes))
}

#[test]
fn a_judge_that_leaves_out_an_answer_of_an_impeller_stops_it() {
    let full = impeller("full", &[]);
    for key in ["feed-axis", "feed-tip", "feed-word", "tip-path", "blades"] {
        assert!(full.contains(&("blade", key)), "{key}");
    }
    for program in ["blade", "splitter"] {
        assert!(full.contains(&(program, "splitters")), "{program}");
    }
    let published = impeller("tfg-2021", &[]);
    assert!(published.contains(&("splitter", "splitters")) && published.contains(&("impeller", "feed-tip")));
    let alone = impeller("full", &[("N", Value::Whole(1)), ("splitters", Value::Choice("no"))]);
    assert!(alone.contains(&("blade", "blades")) && !alone.contains(&("blade", "splitters")));
}

#[test]
fn a_judge_that_leaves_out_an_answer_of_a_clear_cut_stops_it_and_its_holder_is_asked_for_where_it_is_given() {
    let few = [("c_s", Value::Real(0.4)), ("kappa", Value::Real(0.95))];
    let without = impeller("clear", &few);
    assert!(without.iter().all(|(_, key)| *key != "holder"), "{without:?}");
    let sizes = [("l_t", 25.0), ("l_f", 12.0), ("d_h", 20.0)].map(|(key, size)| (key, Value::Real(size)));
    let held = impeller("clear", &[few.as_slice(), &sizes].concat());
    for program in ["rough", "finish"] {
        assert!(held.contains(&(program, "holder")) && held.contains(&(program, "feed-tip")), "{program}: {held:?}");
    }
}

#[test]
fn a_judge_that_leaves_out_an_answer_of_a_pipe_stops_it() {
    for case in Hole::CASES {
        let keys = every_answer_is_missed::<Hole>(Values::of(case, Language::En));
        assert!(["feed", "feed-word"].iter().all(|key| keys.iter().any(|(_, own)| own == key)), "{}", case.name);
    }
    for case in Insert::CASES {
        let keys = every_answer_is_missed::<Insert>(Values::of(case, Language::En));
        assert!(
            ["feed", "feed-word", "edge"].iter().all(|key| keys.iter().any(|(_, own)| own == key)),
            "{}",
            case.name
        );
    }
}

/// A text without its F words.
fn without_feed(text: &str) -> String {
    let feedless = |line: &str| {
        let words =
            line.split(' ').filter(|word| word.strip_prefix('F').is_none_or(|rest| rest.parse::<f64>().is_err()));
        words.collect::<Vec<_>>().join(" ")
    };
    text.lines().map(feedless).collect::<Vec<_>>().join("\n")
}

#[test]
fn a_text_in_which_every_cut_lacks_its_feed_is_a_stop_and_a_published_one_is_told() {
    let prepared = Prepared::new("full", &[("dialect", Value::Choice("fagor-8055"))]);
    assert_eq!(prepared.verdicts("blade", str::to_owned).get("feed"), None);
    let worst = prepared.verdicts("blade", without_feed);
    for key in ["feed", "feed-tip", "feed-word"] {
        assert_eq!(worst.get(key), Some(&Some(Grade::Stop)), "{key}: {worst:?}");
    }
    let published = Prepared::new("tfg-2021", &[]);
    let worst = published.verdicts("blade", str::to_owned);
    assert_eq!((worst["feed-tip"], worst.get("feed")), (Some(Grade::Note), None));
}
