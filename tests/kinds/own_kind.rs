//! What the code of a kind of one's own can be wrong in, and how that is told: a small kind with one thing wrong at a time.

use rodete::cli::codes;
use rodete::finding::{Exit, Finding, Refusal, Rule};
use rodete::gcode::control::{Control, FAGOR_8070, Post};
use rodete::gcode::feed_word::FeedWord;
use rodete::gcode::fields::{DIALECT, PART, SCHEMA};
use rodete::gcode::header::Origin;
use rodete::gcode::motion::MotionKind;
use rodete::gcode::program::Program;
use rodete::gcode::rules::modes::{CutsBeforeSpindle, SpindleStopped};
use rodete::gcode::word::Word;
use rodete::gcode::writer::Writer;
use rodete::kind::method::{Method, Of, Unproved};
use rodete::kind::{Chapters, Kind as _, Outcome, Proved, Provenance, Wants};
use rodete::kinds::KINDS;
use rodete::number::grid::Milli;
use rodete::parameter::field::Fields;
use rodete::parameter::{Case, Form, Section, Sheet, Value, Values};
use rodete::proof::check::{Check, Question};
use rodete::proof::due::Due;
use rodete::proof::step::{Judge, Step};
use rodete::table::{Column, Index, Law, Print, Quantity, Table, Unit};
use rodete::text::{Language, Text, t};

mod named {
    use rodete::finding::Example;
    use rodete::text::t;

    rodete::rules! {
        /// Of the letter of such kinds.
        OWN;
        "K0001" Own Stop {}
            es "propio" en "own" remedy "", ""; why "", "";
            example Example::Never(t("", ""));
    }
    rodete::rules! {
        /// The same code again.
        AGAIN;
        "K0001" Again Stop {}
            es "otra vez" en "again" remedy "", ""; why "", "";
            example Example::Never(t("", ""));
    }
    rodete::rules! {
        /// A code of rodete's.
        TAKEN;
        "U0102" Taken Stop {}
            es "ocupado" en "taken" remedy "", ""; why "", "";
            example Example::Never(t("", ""));
    }
    rodete::rules! {
        /// A letter of no room, and too few digits.
        ASTRAY;
        "Q0001" Letter Stop {}
            es "letra" en "letter" remedy "", ""; why "", "";
            example Example::Never(t("", ""));
        "K01" Digits Stop {}
            es "cifras" en "digits" remedy "", ""; why "", "";
            example Example::Never(t("", ""));
    }
}

/// What is wrong with the kind.
mod slip {
    pub const NONE: u8 = 0;
    pub const FIRST_COLUMN: u8 = 1;
    pub const OTHER_COLUMN: u8 = 2;
    pub const QUANTITY: u8 = 3;
    pub const NO_PROGRAM: u8 = 4;
    pub const OTHER_KEY: u8 = 5;
    pub const TWICE: u8 = 6;
    pub const NOTHING_DUE: u8 = 7;
    pub const OTHER_CONTROL: u8 = 8;
    pub const STILL: u8 = 9;
    pub const STILL_AND_ANSWERED: u8 = 10;
    pub const CODE_AGAIN: u8 = 11;
    pub const CODE_TAKEN: u8 = 12;
    pub const CODE_ASTRAY: u8 = 13;
    pub const LINE_COLUMN: u8 = 14;
}

static FORM: Form = Form {
    kind: "slot",
    schema: "slot 1",
    part: &PART,
    programs: &["slot"],
    sheets: &[Sheet {
        name: t("DATOS", "DATA"),
        title: t("Ranura", "Slot"),
        optional: false,
        sections: &[Section {
            title: t("Pieza", "Part"),
            parameters: &[&SCHEMA.row, &PART.row, &DIALECT.row],
            optional: false,
        }],
    }],
    ..Form::PLAIN
};

static CASES: [Case; 1] = [Case::new("one", t("Una ranura.", "A slot."), |_: Language| {
    vec![
        ("schema", Value::Line(FORM.schema.to_owned())),
        ("part", Value::Line("SLOT".to_owned())),
        ("dialect", Value::Choice("linuxcnc")),
    ]
})];

enum Slot<const SLIP: u8> {}

/// Counts the cuts.
struct Cuts(usize);

impl Judge for Cuts {
    fn see(&mut self, step: &Step<'_>) {
        self.0 += usize::from(matches!(step.motion.kind, MotionKind::Feed(_)));
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        vec![Question::new("cuts", t("Cortes", "Cuts"), program).seen(self.0).passes()]
    }
}

fn table(columns: Vec<Column>) -> Table {
    let name = t("PASADAS", "PASSES");
    let (title, source) = (name.clone(), name.clone());
    Table { key: "passes", name, title, source, index: Index::Point, print: Print::Short, columns }
}

impl<const SLIP: u8> Method for Slot<SLIP> {
    type Design = Post;
    type Model = ();
    type Memo = ();

    const FORM: &'static Form = &FORM;
    const CASES: &'static [Case] = &CASES;
    const CHAPTERS: &'static Chapters = &Chapters { labels: "", method: ["", ""], setup: "", further: &[] };
    const RULES: &'static [&'static [&'static Rule]] = match SLIP {
        slip::CODE_AGAIN => &[named::OWN, named::AGAIN],
        slip::CODE_TAKEN => &[named::TAKEN],
        slip::CODE_ASTRAY => &[named::ASTRAY],
        _ => &[named::OWN],
    };
    const ANSWERED: &'static [&'static Rule] =
        if SLIP == slip::STILL_AND_ANSWERED { &[CutsBeforeSpindle::RULE, SpindleStopped::RULE] } else { &[] };
    const PROVED: Text = t("Leída del programa", "Read back from the program");

    fn design(fields: &Fields) -> Result<Post, Vec<Finding>> {
        Ok(fields.get(&DIALECT))
    }

    fn control(post: &Post) -> &'static Control {
        if SLIP == slip::OTHER_CONTROL { &FAGOR_8070 } else { post.control }
    }

    fn model(_: &Post) -> Result<(), Vec<Finding>> {
        Ok(())
    }

    fn tables(_: &Post, (): &()) -> Vec<Table> {
        let column = |symbol, short: bool| {
            let values = [1.0, 2.0, 3.0];
            Column::numbers(symbol, Unit::Millimetre, Law::None, &values[usize::from(short)..])
        };
        vec![table(vec![column("z", SLIP == slip::FIRST_COLUMN), column("x", SLIP == slip::OTHER_COLUMN)])]
    }

    fn lines(_: &Post, (): &(), _: &[Program]) -> Vec<Table> {
        let column = |values: &[f64]| Column::numbers("n", Unit::One, Law::None, values);
        if SLIP == slip::LINE_COLUMN { vec![table(vec![column(&[1.0]), column(&[1.0, 2.0])])] } else { Vec::new() }
    }

    fn programs(post: &Post, (): &(), _: &Origin<'_>) -> Result<Unproved, Vec<Finding>> {
        let size = |letter, value: f64| Word::size(letter, Milli::round(value).unwrap());
        let mut writer = Writer::new(*post, Vec::new()).along_the_path();
        let F = FeedWord::lasting(writer.law(), 6.0, 10.0).unwrap();
        let still = [slip::STILL, slip::STILL_AND_ANSWERED].contains(&SLIP);
        let turn = [Word::whole('S', 900), Word::whole('M', 3)];
        writer.safety();
        if !still {
            writer.block(turn);
        }
        writer.rapid([size('X', 0.0), size('Y', 0.0), size('Z', 5.0)]);
        writer.feed([Word::whole('G', 1), size('Z', -1.0)], F);
        if still {
            writer.block(turn);
            writer.block([Word::whole('M', 5)]);
        }
        writer.feed([Word::whole('G', 1), size('X', 10.0)], F);
        writer.rapid([size('Z', 5.0)]);
        writer.block([Word::whole('M', 30)]);
        let program = writer.program(if SLIP == slip::OTHER_KEY { "slots" } else { "slot" }, t("Ranura", "Slot"));
        let programs = match SLIP {
            slip::NO_PROGRAM => Vec::new(),
            slip::TWICE => vec![program.clone(), program],
            _ => vec![program],
        };
        Ok(Unproved { programs, findings: Vec::new() })
    }

    fn memo(_: &Post, (): &(), _: Wants) {}

    fn fewer(_: &Post, _: &Program) -> Text {
        t("menos", "fewer")
    }

    fn judges<'a>(_: &'a Post, (): &(), (): &mut (), _: &Program) -> Vec<Box<dyn Judge + 'a>> {
        vec![Box::new(Cuts(0))]
    }

    fn due(_: &Post, _: &Program) -> Vec<Due> {
        if SLIP == slip::NOTHING_DUE { Vec::new() } else { vec![Due::judged("cuts")] }
    }

    fn quantities(_: &Post, (): &(), _: &[Proved]) -> Vec<Quantity> {
        let value = if SLIP == slip::QUANTITY { f64::NAN } else { 3.0 };
        let (meaning, source) = (t("Pasadas", "Passes"), t("dadas", "given"));
        vec![Quantity { symbol: "n", meaning, value, unit: Unit::Count, source, cell: None }]
    }
}

fn fields() -> Fields {
    Fields::of(&FORM, Values::of(&CASES[0], Language::En)).unwrap()
}

fn run<const SLIP: u8>() -> Result<Outcome, Refusal> {
    let source = Provenance { workbook: "slot.xlsx".into(), sha256: "0".repeat(64), version: "1" };
    Of::<Slot<SLIP>>::new().run(fields(), Vec::new(), source, Wants::default())
}

fn told(refusal: &Refusal) -> (Exit, Vec<&str>) {
    (refusal.exit, refusal.findings.iter().map(Finding::code).collect())
}

/// How a run ends, and with what.
fn ended<const SLIP: u8>() -> (Exit, Vec<&'static str>) {
    match run::<SLIP>() {
        Ok(outcome) => (outcome.exit(), outcome.findings.iter().map(Finding::code).collect()),
        Err(refusal) => (refusal.exit, refusal.findings.iter().map(Finding::code).collect()),
    }
}

#[test]
fn a_table_with_a_short_column_or_a_derived_value_that_is_no_number_is_a_fault_before_anything_is_written() {
    assert_eq!(ended::<{ slip::NONE }>(), (Exit::Done, vec!["V0019"]));
    for short in
        [ended::<{ slip::FIRST_COLUMN }>(), ended::<{ slip::OTHER_COLUMN }>(), ended::<{ slip::LINE_COLUMN }>()]
    {
        assert_eq!(short, (Exit::Fault, vec!["X0008"]));
    }
    let short = run::<{ slip::OTHER_COLUMN }>().unwrap_err();
    assert!(short.findings[0].what.en.contains("column \"x\" of table passes has 2 values"), "{short:?}");
    assert_eq!(ended::<{ slip::QUANTITY }>(), (Exit::Fault, vec!["X0009"]));
    // As for a design that is judged by its limits alone.
    assert_eq!(
        told(&Of::<Slot<{ slip::QUANTITY }>>::new().limits(&fields()).unwrap_err()),
        (Exit::Fault, vec!["X0009"])
    );
}

#[test]
fn programs_that_are_not_those_of_the_form_or_that_nobody_judges_are_a_fault() {
    assert_eq!(ended::<{ slip::NO_PROGRAM }>(), (Exit::Fault, vec!["X0010"]));
    assert_eq!(ended::<{ slip::OTHER_KEY }>(), (Exit::Fault, vec!["X0011"]));
    assert_eq!(ended::<{ slip::TWICE }>(), (Exit::Fault, vec!["X0012"]));
    assert_eq!(ended::<{ slip::NOTHING_DUE }>(), (Exit::Fault, vec!["X0013"]));
    assert_eq!(ended::<{ slip::OTHER_CONTROL }>(), (Exit::Fault, vec!["X0014"]));
    assert_eq!(
        told(&Of::<Slot<{ slip::OTHER_KEY }>>::new().limits(&fields()).unwrap_err()),
        (Exit::Fault, vec!["X0011"])
    );
}

#[test]
fn cautions_of_the_spindle_are_told_once_each_unless_the_kind_says_that_its_judges_speak_of_them() {
    let cautions = |(exit, codes): (Exit, Vec<&'static str>)| {
        assert_eq!(exit, Exit::Done);
        codes.into_iter().filter(|code| *code != "V0019").collect::<Vec<_>>()
    };
    let both = vec![CutsBeforeSpindle::RULE.code, SpindleStopped::RULE.code];
    assert_eq!(cautions(ended::<{ slip::STILL }>()), both);
    assert!(cautions(ended::<{ slip::STILL_AND_ANSWERED }>()).is_empty());
}

#[test]
fn a_code_is_one_rows_alone_and_has_the_letter_of_a_room() {
    codes(KINDS).unwrap();
    codes(&[&Of::<Slot<{ slip::NONE }>>::new()]).unwrap();
    let wrong = |refusal: Refusal| -> Vec<String> {
        assert_eq!(refusal.exit, Exit::Fault);
        refusal.findings.iter().map(|found| format!("{} {}", found.code(), found.what.en)).collect()
    };
    let again = wrong(codes(&[&Of::<Slot<{ slip::CODE_AGAIN }>>::new()]).unwrap_err());
    assert_eq!(again, ["X0015 code K0001 belongs to two findings: again (\"again\") and own (\"own\")"]);
    let taken = wrong(codes(&[&Of::<Slot<{ slip::CODE_TAKEN }>>::new()]).unwrap_err());
    assert!(taken.len() == 1 && taken[0].starts_with("X0015 code U0102 belongs to two findings"), "{taken:?}");
    let astray = wrong(codes(&[&Of::<Slot<{ slip::CODE_ASTRAY }>>::new()]).unwrap_err());
    assert!(astray.len() == 2 && astray[0].contains("K01") && astray[1].contains("Q0001"), "{astray:?}");
    // Two kinds that share a list are no clash.
    codes(&[&Of::<Slot<{ slip::NONE }>>::new(), &Of::<Slot<{ slip::STILL }>>::new()]).unwrap();
}
