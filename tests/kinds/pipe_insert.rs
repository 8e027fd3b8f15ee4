//! The branch pipe: the published figures to their last digit, and what must hold for every branch.

use crate::common;
use crate::common::agreement;
use crate::common::change::{choice, real};

use common::rs274;
use proptest::prelude::*;
use rodete::finding::{Exit, Finding, Grade, Place};
use rodete::gcode::control::MILLING;
use rodete::kind::method::Method;
use rodete::kind::{Outcome, Provenance};
use rodete::kinds;
use rodete::kinds::pipe::insert::Insert;
use rodete::kinds::pipe::insert::cases::CASES;
use rodete::kinds::pipe::insert::design::Design;
use rodete::kinds::pipe::insert::parameters::FORM;
use rodete::kinds::pipe::insert::program::{published, template_points};
use rodete::kinds::pipe::insert::rules::{FinerThanAngle, WallInsideHeader};
use rodete::kinds::pipe::insert::tables;
use rodete::parameter::field::Fields;
use rodete::parameter::{Value, Values};
use rodete::proof::rules::OffTolerance;
use rodete::table::Entry;
use rodete::text::Language;

/// The values of a case with changes.
fn values(case: &str, changes: &[(&'static str, Value)]) -> Values {
    let case = CASES.iter().find(|one| one.name == case).expect("a shipped case");
    let mut values = Values { language: Language::En, ..Values::default() };
    values.values.extend(case.values(Language::En));
    values.values.extend(changes.iter().cloned());
    values
}

fn golden(name: &str) -> String {
    std::fs::read_to_string(format!("{}/tests/golden/{name}", env!("CARGO_MANIFEST_DIR"))).expect("a published figure")
}

fn published_design() -> Design {
    Design::new(&Fields::of(&FORM, values("3on4-2023", &[])).unwrap()).expect("the published case")
}

#[test]
fn the_published_program_is_reproduced_to_the_character() {
    let design = published_design();
    let ours: Vec<String> = published(&design).expect("within the format").text().lines().map(str::to_owned).collect();
    let printed: Vec<String> = golden("pipe-insert-3in-on-4in.nc").lines().map(str::to_owned).collect();
    assert_eq!(ours, printed);
}

/// The source rounded x and cut y off: 31.856273, as its own program has it, is printed 31.8562.
#[test]
fn table_1_is_reproduced_to_its_last_digit() {
    let points = template_points(&published_design());
    let printed = golden("pipe-insert-table-1.csv");
    let mut rows = 0;
    for row in printed.lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        let point = points[cells[0].parse::<usize>().expect("j")];
        assert_eq!(
            [format!("{:.4}", point.x), format!("{:.4}", (point.y * 1e4).floor() / 1e4)],
            [cells[1], cells[2]],
            "{row}"
        );
        rows += 1;
    }
    assert_eq!(rows, 13);
}

/// Table 2 was computed from the printed table 1, four decimals: its D, E and last column hang on the rounding.
#[test]
fn table_2_is_reproduced_with_its_slips_named() {
    let table = tables::arcs(&published_design());
    let number = |symbol: &str, row: usize| match table.column(symbol).expect(symbol).values.get(row) {
        Entry::Number(value) => value,
        Entry::Text(_) => panic!("{symbol} is text"),
    };
    let printed = golden("pipe-insert-table-2.csv");
    let mut rows = 0;
    for row in printed.lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        let j: usize = cells[0].parse().expect("j");
        let at = j / 2 - 1;
        assert_eq!(format!("{}", number("j", at)), cells[0]);
        let parse = |cell: &str| cell.parse::<f64>().expect("a number");
        let close = |symbol: &str, cell: &str, part: f64| {
            let (ours, printed) = (number(symbol, at), parse(cell));
            assert!((ours - printed).abs() <= part * printed.abs(), "{j} {symbol}: {ours} {printed}");
        };
        close("D as printed", cells[3], 2e-3);
        close("E as printed", cells[4], 2e-3);
        close("eq. 18 as printed", cells[5], 2e-2);
        let Entry::Text(code) = table.column("code").expect("code").values.get(at) else { panic!("a code") };
        assert_eq!(code.en, cells[6]);
        assert_eq!(number("y″", at) > 0.0, code.en == "G03", "the right second derivative has the same sign");
        rows += 1;
    }
    assert_eq!(rows, 6);
}

/// What comes of a case with changes.
fn outcome(case: &str, changes: &[(&'static str, Value)]) -> Outcome {
    let source = Provenance { workbook: "case.xlsx".to_owned(), sha256: "0".repeat(64), version: "test" };
    kinds::run(&FORM, values(case, changes), source).unwrap_or_else(|refusal| panic!("refused: {:?}", refusal.findings))
}

fn refused(changes: &[(&'static str, Value)]) -> Vec<Finding> {
    let source = Provenance { workbook: "case.xlsx".to_owned(), sha256: "0".repeat(64), version: "test" };
    match kinds::run(&FORM, values("square", changes), source) {
        Err(refusal) => {
            assert_eq!(refusal.exit, Exit::Refused);
            refusal.findings
        }
        Ok(outcome) => panic!("{changes:?}: {:?}", outcome.findings),
    }
}

/// Joints of many shapes: angle, eccentricity, contact, equal pipes, odd and even N.
fn joints() -> Vec<Vec<(&'static str, Value)>> {
    let equal = [choice("branch_size", "4"), choice("contact", "outside")];
    vec![
        vec![],
        vec![choice("contact", "inside")],
        vec![real("e", -9.0), real("theta", 80.0), ("N", Value::Whole(61))],
        vec![real("theta", 60.0), choice("contact", "inside")],
        vec![real("theta", 35.0), choice("branch_size", "4")],
        vec![real("theta", 75.0), real("e", -2.0), choice("branch_size", "3-1/2")],
        vec![real("theta", 45.0), real("e", 9.0)],
        vec![real("theta", 120.0), real("e", -9.0), choice("contact", "outside")],
        vec![real("theta", 83.0), ("N", Value::Whole(63))],
        vec![real("e", 12.7), choice("contact", "outside")],
        equal.to_vec(),
        [&equal[..], &[real("theta", 60.0), ("N", Value::Whole(150))]].concat(),
    ]
}

#[test]
fn every_joint_passes_its_verification_in_every_mode_and_dialect() {
    for joint in joints() {
        for mode in ["flat", "rotary"] {
            for dialect in MILLING.map(|control| control.name) {
                let mut changes = joint.clone();
                changes.extend([choice("mode", mode), choice("dialect", dialect), real("arc_tolerance", 0.1)]);
                // So high that the curve is nowhere behind the edge of the template.
                changes.push(real("Z", 200.0));
                let outcome = outcome("square", &changes);
                let worst: Vec<_> = outcome.findings.iter().filter(|finding| finding.grade > Grade::Note).collect();
                // Along one edge alone the wall of an oblique branch does not seat, and that is said.
                let edge = changes.iter().any(|(key, value)| *key == "contact" && *value != Value::Choice("envelope"));
                let square =
                    changes.iter().all(|(key, _)| *key != "theta") && changes.contains(&choice("contact", "inside"));
                let expected = usize::from(edge && !square);
                assert!(
                    worst.len() == expected && worst.iter().all(|one| one.is(WallInsideHeader::RULE)),
                    "{changes:?}: {worst:?}"
                );
                assert_eq!(outcome.programs.len(), 1);
            }
        }
    }
}

/// The rounding of A, 0.007 mm on a pipe of 1.6 m, had passed for a fault of rodete.
#[test]
fn on_a_large_pipe_the_rounding_of_a_stays_within_the_tolerance() {
    let run = |[branch, header, theta, tolerance]: [f64; 4]| {
        let pipes = [("D_branch", branch), ("t_branch", 20.0), ("D_header", header), ("t_header", 20.0)];
        let mut changes: Vec<_> = pipes.into_iter().map(|(key, value)| real(key, value)).collect();
        changes.extend([real("theta", theta), real("arc_tolerance", tolerance), choice("mode", "rotary")]);
        let mut values = values("square", &changes);
        let sizes = ["branch_size", "branch_schedule", "header_size", "header_schedule"];
        values.values.retain(|key, _| !sizes.contains(key));
        let source = Provenance { workbook: "case.xlsx".to_owned(), sha256: "0".repeat(64), version: "test" };
        kinds::run(&FORM, values, source)
    };
    for pipes in [[1600.0, 2000.0, 90.0, 0.007], [2400.0, 3000.0, 90.0, 0.011], [3000.0, 3000.0, 168.61, 0.02]] {
        let outcome = run(pipes).unwrap_or_else(|refusal| panic!("{pipes:?}: {:?}", refusal.findings));
        let off = outcome.findings.iter().find(|finding| finding.is(OffTolerance::RULE));
        assert!(off.is_none() && outcome.programs.len() == 1, "{pipes:?}: {off:?}");
    }
    let refusal = run([1600.0, 2000.0, 90.0, 0.004]).expect_err("A cannot be so fine");
    assert!(refusal.findings.iter().any(|finding| finding.is(FinerThanAngle::RULE)), "{:?}", refusal.findings);
}

/// rs274 reads millimetres from the program itself; its arcs must end where ours do, with the same centre and turn.
#[test]
fn linuxcnc_makes_the_same_motions_of_our_programs() {
    if !rs274::is_here() {
        return;
    }
    for joint in joints() {
        for mode in ["flat", "rotary"] {
            let mut changes = joint.clone();
            changes.extend([choice("mode", mode), real("arc_tolerance", 0.1)]);
            let program = outcome("square", &changes).programs.remove(0);
            let theirs = rs274::run(program.text().as_bytes(), None, None)
                .unwrap_or_else(|refused| panic!("{changes:?}: {refused:?}"));
            let ours: Vec<_> = program.read_back().map(Result::unwrap).collect();
            agreement::agree(&ours, &theirs.motions).unwrap_or_else(|fault| panic!("{changes:?}: {fault}"));
        }
    }
}

#[test]
fn contradictions_are_refused_with_the_amount() {
    for (changes, what, remedy) in [
        (
            vec![real("e", 20.0)],
            "the branch overhangs the header by 1.81 mm: r = 38.96 mm, e = 20 mm, R = 57.15 mm",
            "choose an eccentricity of 12.7 mm at most",
        ),
        (
            vec![choice("branch_size", "6")],
            "the branch is larger than the header: r = 77.04 mm, R = 57.15 mm",
            "swap the pipes, or choose a smaller branch",
        ),
        (
            vec![choice("branch_schedule", "5"), choice("branch_size", "30")],
            "ASME B36.10 has no schedule 5 in size 30",
            "choose another schedule, or fill in D_branch and t_branch",
        ),
        (
            vec![real("D_branch", 89.0)],
            "branch_size 3 schedule 40 is 88.9 × 5.49 mm, but D_branch or t_branch differs",
            "empty D_branch and t_branch, or the nominal size",
        ),
        (
            vec![choice("style", "annex"), choice("mode", "flat")],
            "style = annex has no feed F, and the dialect linuxcnc does not move without one",
            "choose style = full",
        ),
        (
            vec![choice("style", "annex"), choice("dialect", "fagor-8055")],
            "style = annex is the published program, on flat sheet",
            "choose style = full, or mode = flat",
        ),
        (
            vec![("torch_on", Value::Line("M30".to_owned()))],
            "torch_on holds M30, which ends the program",
            "take M30 out",
        ),
        (
            vec![("end_codes", Value::Line("M3 M30".to_owned()))],
            "end_codes holds M3, which turns the torch on",
            "write only codes that end the program, such as M30",
        ),
        (
            vec![
                ("torch_on", Value::Line("M101".to_owned())),
                ("torch_off", Value::Line("M102".to_owned())),
                ("end_codes", Value::Line("M101 M30".to_owned())),
            ],
            "end_codes holds M101, which turns the torch on",
            "write only codes that end the program, such as M30",
        ),
        (
            vec![("torch_on", Value::Line("M62".to_owned()))],
            "the control does not take the codes of torch_on: digital output without a number P",
            "keep in torch_on only M codes that the control takes together in one block and without other words",
        ),
        (
            vec![("torch_on", Value::Line("M6".to_owned()))],
            "the control does not take the codes of torch_on: M6 without a tool selected by T",
            "keep in torch_on only M codes that the control takes together in one block and without other words",
        ),
    ] {
        let findings = refused(&changes);
        assert_eq!(findings.len(), 1, "{findings:?}");
        assert!(matches!(findings[0].place, Place::Parameters(_)), "{findings:?}");
        assert_eq!((findings[0].what.en.as_ref(), findings[0].remedy.en.as_ref()), (what, remedy));
    }
    // With the eccentricity that is named the wall stays on the header, too.
    let whole = outcome("square", &[real("e", 12.7)]);
    assert!(whole.findings.iter().all(|finding| finding.code() != "P2122"), "{:?}", whole.findings);
    let narrow = refused(&[real("kerf", 20.0), real("theta", 35.0), choice("branch_size", "1/2")]);
    assert!(
        narrow[0].what.en.starts_with("the kerf of 20 mm is wider than the gap of the curve at φ = "),
        "{narrow:?}"
    );
}

#[test]
fn a_wall_beyond_the_radius_is_refused() {
    let mut typed = values("square", &[real("D_branch", 80.0), real("t_branch", 40.0)]);
    typed.values.remove("branch_size");
    typed.values.remove("branch_schedule");
    let findings = Design::new(&Fields::of(&FORM, typed.clone()).unwrap()).expect_err("a wall as thick as the radius");
    assert_eq!(findings[0].what.en, "the wall of the branch is 40 mm; it must be less than the radius, 40 mm");
    typed.values.remove("D_branch");
    let findings = Design::new(&Fields::of(&FORM, typed.clone()).unwrap()).expect_err("no diameter");
    assert_eq!(findings[0].what.en, "the size is missing: branch_size and branch_schedule, or D_branch and t_branch");
}

/// Without a kerf the torch goes along the curve itself: no head of a program and no table says that anything is compensated.
#[test]
fn what_is_not_compensated_is_nowhere_said_to_be() {
    let kinds = rodete::kinds::KINDS.iter().filter(|kind| kind.form().kind.starts_with("pipe"));
    let ways = kinds.flat_map(|kind| {
        let modes = if kind.form().kind == FORM.kind { &["rotary", "flat"][..] } else { &[""][..] };
        modes.iter().map(move |mode| (*kind, *mode))
    });
    for (kind, mode) in ways {
        for (kerf, compensated) in [(1.5, true), (0.0, false)] {
            for language in Language::ALL {
                let mut changes = vec![real("kerf", kerf)];
                match mode {
                    "" => changes.push(real("m", kerf / 2.0)),
                    mode => changes.push(choice("mode", mode)),
                }
                let outcome = common::outcome_of(kind, &kind.cases()[0], language, &changes);
                let told = format!("{} {mode} {kerf}", kind.form().kind);
                let head = outcome.programs[0].text();
                let heads = |words: [&str; 2]| words.iter().any(|words| head.contains(words));
                assert_eq!(heads(["COMPENSADO", "KERF 1.500 COMPENSATED"]), compensated, "{told}: {head}");
                assert_eq!(heads(["SIN COMPENSAR", "KERF NOT COMPENSATED"]), !compensated, "{told}: {head}");
                let way = outcome.table("way").expect("the way");
                assert_eq!(
                    way.title.en.ends_with("with the kerf compensated"),
                    compensated,
                    "{told}: {}",
                    way.title.en
                );
                let codes: Vec<&str> = outcome.findings.iter().map(Finding::code).collect();
                assert_eq!(codes.contains(&"P2109"), !compensated, "{told}: {codes:?}");
                assert_eq!(codes.contains(&"P2110"), compensated && mode == "rotary", "{told}: {codes:?}");
            }
        }
    }
}

#[test]
fn the_published_case_says_that_its_radius_is_the_outside_one() {
    let outcome = outcome("3on4-2023", &[]);
    assert!(!outcome.stopped());
    let cautions: Vec<_> = outcome.findings.iter().filter(|finding| finding.grade == Grade::Caution).collect();
    // The radius, the wall, the published layout, and its six decimals where the control takes four.
    assert_eq!(cautions.len(), 4, "{cautions:?}");
    assert!(cautions.iter().any(|finding| finding.code() == "P2124"));
    let told = cautions.iter().find(|finding| finding.is(WallInsideHeader::RULE)).expect("the wall");
    assert_eq!(
        told.what.en,
        "with contact = inside the branch does not seat: the inner edge of its wall is up to 5.207 mm inside the header, at φ = 91.4°"
    );
    assert!(
        cautions.iter().any(|finding| finding.what.en.starts_with("r = 44.45 mm is the outside radius (D = 88.9 mm)"))
    );
    assert!(cautions.iter().any(|finding| finding.what.en.contains("no feed, no torch and no program end")));
}

/// The arcs of the published program against the exact curve: what dense sampling of the circles themselves measures.
#[test]
fn the_deviation_reported_is_that_of_dense_sampling() {
    let design = published_design();
    let outline = design.template();
    let triples = rodete::kinds::pipe::insert::arcs::triples(&template_points(&design), design.arc_tolerance);
    let mut most = 0.0_f64;
    for triple in &triples {
        let circle = triple.circle.expect("an arc");
        let angle = |point: nalgebra::Vector2<f64>| {
            rodete::number::trig::atan2(point.y - circle.centre.y, point.x - circle.centre.x)
        };
        let (from, to) = (angle(triple.from), angle(triple.to));
        let sweep =
            rodete::number::trig::atan2(rodete::number::trig::sin(to - from), rodete::number::trig::cos(to - from));
        for part in 0..=200 {
            let (sin, cos) = rodete::number::trig::sin_cos(from + sweep * f64::from(part) / 200.0);
            let point = circle.centre + nalgebra::Vector2::new(cos, sin) * circle.radius;
            let near = point.x / design.r_dev;
            let least = (-400..=400)
                .map(|step| (outline.curve(near + f64::from(step) * 5e-5) - point).norm())
                .fold(f64::INFINITY, f64::min);
            most = most.max(least);
        }
    }
    let outcome = outcome("3on4-2023", &[]);
    let table = outcome.table("verification").expect("the table");
    let row = (0..table.rows())
        .find(|&row| matches!(table.column("Check").unwrap().values.get(row), Entry::Text(text) if text.en.starts_with("Path")))
        .expect("the check");
    let Entry::Text(value) = table.column("Value").unwrap().values.get(row) else { panic!("text") };
    let reported: f64 = value.en.trim_start_matches("≤ ").trim_end_matches(" mm").parse().expect("a length");
    assert!((reported - most).abs() < 2e-4, "{reported} {most}");
}

/// Points nearly on a line need radii that no control takes: there the published arcs are straight moves within the
/// tolerance, and no variation of the case is a fault of rodete's own.
#[test]
fn variations_of_the_published_case_are_no_fault() {
    let mut straight = 0;
    for theta in [30.0, 45.0, 60.0, 75.0, 83.0, 90.0, 105.0, 120.0] {
        for e in [0.0, 5.0, 10.0, -12.7, 12.7] {
            for N in [3, 16, 61, 64, 180, 360] {
                let changes = [real("theta", theta), real("e", e), ("N", Value::Whole(N))];
                let outcome = outcome("3on4-2023", &changes);
                assert!(!outcome.stopped(), "{changes:?}: {:?}", outcome.findings);
                let even = outcome.programs[0].text().matches("G01").count() - (N as usize % 2);
                straight += usize::from(N >= 16 && even > 0);
                if N == 360 {
                    let off = outcome.findings.iter().find(|finding| finding.what.en.starts_with("the arcs leave"));
                    assert!(off.is_none() || e.abs() > 12.0, "{changes:?}: {off:?}");
                }
            }
        }
    }
    assert!(straight > 5, "{straight} variations hold straight moves");
    let square = [real("theta", 90.0), real("e", 5.0), ("N", Value::Whole(360))];
    assert!(outcome("3on4-2023", &square).programs[0].text().contains("G01 X"));
}

/// A steep branch reaches farther than a program may: the input is refused, and rodete is not to blame.
#[test]
fn a_position_beyond_the_format_is_refused_in_the_published_style_too() {
    let source = Provenance { workbook: "case.xlsx".to_owned(), sha256: "0".repeat(64), version: "test" };
    let changes = [real("theta", 1.0), real("r", 1000.0), real("R", 1500.0)];
    let refusal = kinds::run(&FORM, values("3on4-2023", &changes), source).expect_err("beyond the format");
    assert_eq!(refusal.exit, Exit::Refused);
    let what = refusal.findings[0].what.en.as_ref();
    assert!(what.ends_with("does not fit into a program (five digits and three decimals)"), "{what}");
    assert_eq!(refusal.findings[0].remedy.en, "check D_branch, D_header and Z");
}

/// One fault at a time in the text of a sound program.
#[test]
fn faults_in_the_text_are_caught() {
    for mode in ["flat", "rotary"] {
        let changes = [choice("mode", mode), real("arc_tolerance", 0.1)];
        let design = Design::new(&Fields::of(&FORM, values("square", &changes)).unwrap()).expect("a design");
        let model = Insert::model(&design).expect("a model");
        let program = outcome("square", &changes).programs.remove(0);
        let text = program.text();
        let worst = |text: &str| {
            let checks = common::checks::<Insert>(&design, &model, &program, text);
            checks.iter().map(|check| (check.key(), check.grade())).collect::<std::collections::BTreeMap<_, _>>()
        };
        let sound = worst(&text);
        assert!(sound.values().all(|verdict| *verdict <= Some(Grade::Note)), "{sound:?}");
        let cuts: Vec<usize> = (0..text.lines().count())
            .filter(|&at| text.lines().nth(at).is_some_and(|line| line.contains(" G1 ") || line.contains(" G3 ")))
            .collect();
        let line = cuts[cuts.len() / 2];
        let change = |from: char, by: f64| -> String {
            let changed = text.lines().enumerate().map(|(at, found)| {
                let words = found.split(' ').map(|word| match word.strip_prefix(from) {
                    Some(number) if at == line => format!("{from}{:.3}", number.parse::<f64>().unwrap() + by),
                    _ => word.to_owned(),
                });
                words.collect::<Vec<_>>().join(" ") + "\n"
            });
            changed.collect()
        };
        for (letter, by) in [('X', 0.001), ('X', -0.5), (if mode == "flat" { 'Y' } else { 'A' }, 0.5)] {
            let worst = worst(&change(letter, by));
            assert_eq!(worst["agreement"], Some(Grade::Stop), "{mode} {letter}{by}");
            assert!(by.abs() < 0.1 || worst["path"] > Some(Grade::Note), "{mode} {letter}{by}");
        }
        let dropped: String =
            text.lines().enumerate().filter(|(at, _)| *at != line).map(|(_, line)| format!("{line}\n")).collect();
        assert_eq!(worst(&dropped)["agreement"], Some(Grade::Stop), "{mode}");
        if mode == "rotary" {
            assert_eq!(worst(&change('F', 100.0))["feed"], Some(Grade::Stop));
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn random_branches_are_cut_within_their_tolerance(
        D in 20.0..600.0_f64, part in 0.1..0.98_f64, wall in 0.02..0.2_f64, theta in 25.0..155.0_f64,
        off in -0.95..0.95_f64, kerf in 0.0..3.0_f64, tolerance in 0.01..0.2_f64,
    ) {
        let d = D * part;
        let t = d * wall;
        let changes = [
            real("D_branch", d), real("t_branch", t), real("D_header", D), real("t_header", D * 0.05),
            real("theta", theta), real("e", (D - d) / 2.0 * off), real("kerf", kerf), real("arc_tolerance", tolerance),
        ];
        let mut values = values("square", &changes);
        for key in ["branch_size", "branch_schedule", "header_size", "header_schedule"] {
            values.values.remove(key);
        }
        let source = Provenance { workbook: "case.xlsx".to_owned(), sha256: "0".repeat(64), version: "test" };
        match kinds::run(&FORM, values, source) {
            Ok(outcome) => prop_assert!(!outcome.stopped(), "{:?}", outcome.findings),
            Err(refusal) => prop_assert!(
                refusal.findings.iter().all(|finding| finding.what.en.contains("kerf")), "{:?}", refusal.findings
            ),
        }
    }
}

/// The measures of a pipe typed in place of its nominal size.
fn typed(changes: &[(&'static str, Value)]) -> Result<Outcome, rodete::finding::Refusal> {
    let mut values = values(CASES[0].name, &[]);
    for key in ["branch_size", "branch_schedule", "header_size", "header_schedule", "r", "R", "r_dev"] {
        values.values.remove(key);
    }
    values.values.extend(changes.iter().cloned());
    let source = Provenance { workbook: "case.xlsx".to_owned(), sha256: "0".repeat(64), version: "test" };
    kinds::run(&FORM, values, source)
}

fn slanted() -> Vec<(&'static str, Value)> {
    vec![
        real("D_branch", 60.3),
        real("t_branch", 4.0),
        real("D_header", 114.3),
        real("t_header", 6.0),
        choice("contact", "envelope"),
        choice("mode", "rotary"),
        choice("dialect", "linuxcnc"),
        choice("style", "full"),
        real("theta", 40.0),
        real("e", 26.0),
        real("kerf", 6.0),
        real("F", 2000.0),
        real("lead_in", 20.0),
    ]
}

/// One turn of the curve is 269.1 mm, computed apart from this code; the pipe is 189.4 mm round.
#[test]
fn an_overcut_is_held_against_the_curve_and_not_the_pipe_round() {
    let with = |overcut: f64| typed(&[slanted(), vec![real("overcut", overcut)]].concat());
    let accepted = with(200.0).unwrap_or_else(|refusal| panic!("refused: {:?}", refusal.findings));
    assert!(!accepted.stopped(), "{:?}", accepted.findings);
    let refusal = with(300.0).expect_err("more than once round");
    let told = refusal.findings.iter().find(|one| one.code() == "P2119").expect("told");
    let [Some(value), Some(limit)] = told.figures().missed() else { panic!("{told:?}") };
    assert!((value - 300.0).abs() < 1e-9 && (limit - 269.1).abs() < 1.0, "{limit}");
}

#[test]
fn a_rotary_axis_slower_at_rapid_than_the_cut_asks_is_told_with_its_place() {
    let with = |rate: f64| typed(&[slanted(), vec![real("overcut", 0.0), real("G_rot", rate)]].concat());
    let codes =
        |outcome: Outcome| outcome.findings.iter().filter(|one| one.code() == "P2130").cloned().collect::<Vec<_>>();
    // 2000 mm/min round 30.15 mm are 3800 °/min at most.
    assert!(codes(with(3900.0).expect("a program")).is_empty());
    let told = codes(with(1000.0).expect("a program"));
    let [one] = &told[..] else { panic!("{told:?}") };
    assert!(one.grade == Grade::Caution && one.what.en.contains("of axis A near φ = "), "{}", one.what.en);
}

/// A development typed for another radius does not roll to the pipe: that it seats without grinding is not said.
#[test]
fn a_branch_whose_development_does_not_roll_to_its_pipe_is_not_said_to_seat() {
    let with = |changes: Vec<(&'static str, Value)>| {
        let changes = [slanted(), vec![choice("mode", "flat"), real("e", 0.0), real("theta", 90.0)], changes].concat();
        let outcome = typed(&changes).unwrap_or_else(|refusal| panic!("refused: {:?}", refusal.findings));
        outcome.findings.iter().map(Finding::code).filter(|code| ["P2115", "P2120"].contains(code)).collect::<Vec<_>>()
    };
    assert_eq!(with(vec![]), ["P2115"]);
    assert_eq!(with(vec![real("r_dev", 40.0)]), ["P2120"]);
}

/// An outside radius typed for the inside one, with a development that is the pipe's own: nothing lies 0 mm outside.
#[test]
fn a_development_that_fits_is_not_said_to_lie_outside() {
    let changes = [
        slanted(),
        vec![
            choice("contact", "inside"),
            real("r", 30.15),
            choice("mode", "flat"),
            real("e", 0.0),
            real("theta", 90.0),
        ],
    ]
    .concat();
    let said = |changes: &[(&'static str, Value)]| {
        let outcome = typed(changes).unwrap_or_else(|refusal| panic!("refused: {:?}", refusal.findings));
        let told = outcome.findings.iter().find(|one| one.code() == "P2106").expect("told");
        told.what.en.to_string()
    };
    let own = said(&changes);
    assert!(!own.contains("outside the pipe"), "{own}");
    let other = said(&[changes, vec![real("r_dev", 32.15)]].concat());
    assert!(other.contains("; the development is 2 mm outside the pipe"), "{other}");
}

#[test]
fn a_branch_that_overhangs_is_refused_with_its_eccentricity_and_the_greatest() {
    let told = refused(&[real("e", 20.0)]);
    let one = told.iter().find(|one| one.code() == "P2102").expect("told");
    assert_eq!(one.figures().missed(), [Some(20.0), Some(12.7)]);
}
