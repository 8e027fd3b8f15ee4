//! Branches and holes drawn at random: none ends as a fault of rodete's own, and what a check says is nowhere exceeded is not, by
//! points taken here without it. `RODETE_DESIGNS` says how many of each are drawn.

use crate::common::change::{choice, real};

use std::f64::consts::TAU;

use nalgebra::{Vector2, Vector3};
use proptest::prelude::*;
use rodete::finding::{Exit, Finding, Grade, Refusal};
use rodete::gcode::control::MILLING;
use rodete::gcode::motion::{Motion, MotionKind};
use rodete::gcode::program::Program;
use rodete::geometry::pipe_pair::Side;
use rodete::kind::rules::NotNumbered;
use rodete::kind::{Outcome, Provenance};
use rodete::kinds;
use rodete::kinds::pipe::hole;
use rodete::kinds::pipe::insert;
use rodete::kinds::pipe::insert::rules::{FasterThanFWord, TemplateNotRound, WallInsideHeader};
use rodete::machine::axis::Axis;
use rodete::number::trig::{hypot, sin_cos};
use rodete::parameter::field::Fields;
use rodete::parameter::{Form, Value, Values};
use rodete::proof::rules::OffByN;
use rodete::table::Entry;
use rodete::text::Language;

fn designs(usual: u32) -> ProptestConfig {
    let wanted = std::env::var("RODETE_DESIGNS").ok().and_then(|count| count.parse().ok());
    ProptestConfig { max_global_rejects: 1_000_000, ..ProptestConfig::with_cases(wanted.unwrap_or(usual)) }
}

fn run(form: &'static Form, values: Values) -> Result<Outcome, Refusal> {
    let source = Provenance { workbook: "case.xlsx".to_owned(), sha256: "0".repeat(64), version: "test" };
    kinds::run(form, values, source)
}

/// The values of a case with changes, pipes given by diameter and wall.
fn filled(case: Vec<(&'static str, Value)>, changes: impl IntoIterator<Item = (&'static str, Value)>) -> Values {
    let mut values = Values { language: Language::En, ..Values::default() };
    values.values.extend(case);
    values.values.extend(changes);
    for key in ["branch_size", "branch_schedule", "header_size", "header_schedule"] {
        values.values.remove(key);
    }
    values
}

/// The number in the row of a check.
fn row(outcome: &Outcome, name: &str) -> f64 {
    let table = outcome.table("verification").expect("the table");
    let text = |column: &str, row: usize| match table.column(column).expect(column).values.get(row) {
        Entry::Text(text) => text.en.to_string(),
        Entry::Number(number) => number.to_string(),
    };
    let at = (0..table.rows()).find(|&at| text("Check", at).starts_with(name)).expect(name);
    let value = text("Value", at);
    let digits = |letter: char| !letter.is_ascii_digit() && letter != '-';
    let number = value.trim_start_matches(digits);
    number.split([' ', '°']).next().expect("a value").parse().unwrap_or_else(|_| panic!("{name}: {value}"))
}

/// The motions of the cut, lead-in first.
fn cuts(program: &Program) -> Vec<Motion> {
    let motions = program.read_back().map(|motion| motion.expect("taken"));
    motions.filter(|motion| matches!(motion.kind, MotionKind::Feed(_) | MotionKind::Arc(..))).collect()
}

/// An axis a part of the way along a motion.
fn axis(motion: &Motion, axis: Axis, part: f64) -> f64 {
    let (from, to) = (motion.from.get(axis), motion.to.get(axis));
    from + (to - from) * part
}

/// Tip and direction of the torch, from A, X, Z, B and C: about the pipe by A, tilted by B in the direction C.
fn torch([A, X, Z, B, C]: [f64; 5]) -> [Vector3<f64>; 2] {
    let [(sa, ca), (sb, cb), (sc, cc)] = [A, B, C].map(|angle| sin_cos(angle.to_radians()));
    let about = |x: f64, y: f64, z: f64| Vector3::new(x, y * ca - z * sa, y * sa + z * ca);
    [about(X, 0.0, Z), about(sb * cc, sb * sc, cb)]
}

/// How near points of the torch's surface come to the pipe.
fn nearest_point(design: &hole::design::Design, [tip, up]: [Vector3<f64>; 2]) -> f64 {
    let aside = if up.x.abs() < 0.8 { Vector3::x() } else { Vector3::y() };
    let first = up.cross(&aside).try_normalize(1e-9).expect("not along the torch");
    let second = up.cross(&first);
    let shoulder = (design.R_g - design.r_g) / rodete::number::trig::tan(design.Psi.to_radians());
    let mut least = f64::INFINITY;
    for level in 0..=24_u8 {
        let part = f64::from(level) / 16.0;
        let (behind, radius) = if part <= 1.0 {
            (shoulder * part, design.r_g + (design.R_g - design.r_g) * part)
        } else {
            (shoulder + 4.0 * design.R_g * (part - 1.0), design.R_g)
        };
        for round in 0..48_u8 {
            let (sin, cos) = sin_cos(TAU * f64::from(round) / 48.0);
            let point = tip + up * behind + (first * cos + second * sin) * radius;
            least = least.min(hypot(point.y, point.z) - design.R_o());
        }
    }
    least
}

/// How near points of the torch come on the whole way of a cut.
fn nearest_on_the_way(design: &hole::design::Design) -> f64 {
    let cut = hole::cut::cut(design).expect("a way");
    let places: Vec<[f64; 5]> = std::iter::once(cut.pierce)
        .chain(cut.legs.iter().map(|leg| leg.to))
        .map(|place| place.map(|size| size.value()))
        .collect();
    let between = |pair: &[[f64; 5]], part: f64| {
        nearest_point(design, torch(std::array::from_fn(|k| pair[0][k] + (pair[1][k] - pair[0][k]) * part)))
    };
    places
        .windows(2)
        .flat_map(|pair| [0.0, 0.25, 0.5, 0.75, 1.0].map(|part| between(pair, part)))
        .fold(f64::INFINITY, f64::min)
}

/// Near the vertical C gives way and with it the tilt: here the torch comes nearer than g0, and the design is refused for that.
#[test]
fn a_torch_that_gives_its_tilt_way_too_near_the_pipe_is_stopped() {
    let D = 493.258_407_860_852_7;
    let t = D * 0.096_223_011_759_783_46;
    let d = (D - 2.0 * t) * 0.15;
    let changes = [
        real("D_header", D),
        real("t_header", t),
        real("D_branch", d),
        real("t_branch", d * 0.05),
        real("theta", 55.0),
        real("e", (D / 2.0 - t - d / 2.0) * 0.524_109_373_895_515_3),
        real("gamma", 30.976_590_306_840_82),
        real("b", 0.0),
        real("h", 0.0),
        real("D_max", 40.0),
        real("lead_in", 0.2 * d),
        real("arc_tolerance", 0.02),
    ];
    let values = filled(hole::cases::CASES[0].values(Language::En), changes);
    let design =
        hole::design::Design::new(&Fields::of(&hole::parameters::FORM, values.clone()).unwrap()).expect("a design");
    let outcome = run(&hole::parameters::FORM, values).expect("a hole");
    assert_eq!(outcome.exit(), Exit::Refused);
    let (told, found) = (row(&outcome, "Distance of the torch"), nearest_on_the_way(&design));
    assert!(told < 1.9 && told <= found + 1e-4 && found <= told + 0.05, "{told} {found}");
}

/// A branch as wide as its header, at 25°: a move of 0.02 mm round its corner takes 0.2 ms, which three decimals of five digits do
/// not say. LinuxCNC reads more, and so the move takes its time.
#[test]
fn a_move_of_a_fiftieth_of_a_millimetre_takes_its_time() {
    let F = 5_408.886_188_381_509;
    let changes = [
        real("D_branch", 20.0),
        real("t_branch", 0.4),
        real("D_header", 20.0),
        real("t_header", 1.0),
        real("theta", 25.0),
        real("e", 0.0),
        real("kerf", 0.050_256_315_810_708_84),
        real("arc_tolerance", 0.01),
        real("F", F),
        ("N", Value::Whole(3)),
        ("contact", Value::Choice("outside")),
        ("sheet", Value::Choice("inside")),
    ];
    let outcome = run(&insert::parameters::FORM, filled(insert::cases::CASES[0].values(Language::En), changes));
    let outcome = outcome.expect("a branch");
    assert_eq!(outcome.exit(), Exit::Done, "{:?}", outcome.findings);
    let known =
        |one: &Finding| one.grade == Grade::Note || one.is(WallInsideHeader::RULE) || one.is(TemplateNotRound::RULE);
    assert!(outcome.findings.iter().all(known), "{:?}", outcome.findings);
    assert!(row(&outcome, "F word") < 0.01);
    let way = |motion: &Motion| {
        let round = (motion.to.get(Axis::A) - motion.from.get(Axis::A)).to_radians() * 10.0;
        hypot(round, motion.to.get(Axis::X) - motion.from.get(Axis::X))
    };
    let cuts = cuts(&outcome.programs[0]);
    let shortest = cuts.iter().min_by(|one, other| way(one).total_cmp(&way(other))).expect("moves");
    assert!(way(shortest) < 0.02, "{shortest:?}");
    for motion in &cuts {
        let speed = way(motion) * 60.0 / motion.seconds.expect("a time");
        // A word within a billionth of one of three decimals is that one.
        assert!((0.9999 * F..=F * (1.0 + 2e-9)).contains(&speed), "{speed} {motion:?}");
    }
}

/// LinuxCNC reads N up to 99999.
#[test]
fn pipes_have_no_block_numbers_where_these_would_exceed_what_the_control_reads() {
    let kinds = [
        (&insert::parameters::FORM, insert::cases::CASES[0].values(Language::En)),
        (&hole::parameters::FORM, hole::cases::CASES[0].values(Language::En)),
    ];
    for (form, case) in kinds {
        for (step, numbered) in [(10, true), (1000, false)] {
            let mut values = Values { language: Language::En, ..Values::default() };
            values.values.extend(case.iter().cloned().chain([("block_step", Value::Whole(step))]));
            let outcome = run(form, values).expect("a pipe");
            assert_eq!(outcome.exit(), Exit::Done, "{step} {:?}", outcome.findings);
            assert_eq!(outcome.programs[0].program.block_step.is_some(), numbered, "{step}");
            assert_eq!(outcome.findings.iter().any(|one| one.is(NotNumbered::RULE)), !numbered, "{step}");
        }
    }
}

/// In G94 degrees count as millimetres: on a branch of 5 mm a speed of 5000 mm/min is 114,592 of them, and no F word.
#[test]
fn a_speed_that_no_f_word_says_is_refused_with_the_greatest_that_one_does() {
    let branch = |F: f64| {
        let changes = [
            real("D_branch", 5.0),
            real("t_branch", 0.5),
            real("D_header", 20.0),
            real("t_header", 1.0),
            real("kerf", 0.0),
            real("F", F),
            ("dialect", Value::Choice("fagor-8055")),
        ];
        run(&insert::parameters::FORM, filled(insert::cases::CASES[0].values(Language::En), changes))
    };
    let refusal = branch(5000.0).expect_err("no F word");
    assert_eq!(refusal.exit, Exit::Refused);
    let [told] = &refusal.findings[..] else { panic!("{:?}", refusal.findings) };
    assert!(told.is(FasterThanFWord::RULE), "{told:?}");
    let most = told.remedy.en.split_once("an F of ").and_then(|(_, rest)| rest.split(' ').next()?.parse::<f64>().ok());
    let most = most.expect("the greatest F");
    assert_eq!(branch(most).expect("a branch").exit(), Exit::Done);
    assert_eq!(branch(most + 1.0).expect_err("no F word").exit, Exit::Refused);
}

/// Parts of a motion that no halving looks at.
const PARTS: [f64; 3] = [0.191, 0.456, 0.813];

proptest! {
    #![proptest_config(designs(24))]

    #[test]
    fn random_holes_keep_what_their_checks_say(
        D in 80.0..600.0_f64, wall in 0.02..0.1_f64, part in 0.15..0.85_f64, theta in 55.0..125.0_f64, off in -0.6..0.6_f64,
        gamma in 0.0..45.0_f64, b in 0.0..3.0_f64, h in 0.0..0.9_f64, tolerance in 0.02..0.2_f64, F in 500.0..6000.0_f64,
        dialect in prop::sample::select(MILLING.map(|control| control.name).to_vec()),
    ) {
        let t = D * wall;
        let d = (D - 2.0 * t) * part;
            let changes = [
            real("D_header", D), real("t_header", t), real("D_branch", d), real("t_branch", d * 0.05),
            real("theta", theta), real("e", (D / 2.0 - t - d / 2.0) * off), real("gamma", gamma), real("b", b),
            real("h", h * t), real("D_max", 40.0), real("lead_in", 0.2 * d), real("arc_tolerance", tolerance), real("F", F),
            ("dialect", Value::Choice(dialect)),
        ];
        let values = filled(hole::cases::CASES[0].values(Language::En), changes);
        let design = hole::design::Design::new(&Fields::of(&hole::parameters::FORM, values.clone()).unwrap());
        prop_assume!(design.is_ok());
        let design = design.expect("a design");
        let groove = design.groove();
        let highest = (0..1000_u16)
            .map(|at| groove.at(TAU * f64::from(at) / 1000.0).map_or(f64::INFINITY, |one| one.D))
            .fold(0.0, f64::max);
        let outcome = match run(&hole::parameters::FORM, values) {
            Ok(outcome) => outcome,
            Err(refusal) => {
                prop_assert_eq!(refusal.exit, Exit::Refused);
                prop_assert!(highest > 39.9, "{:?}", refusal.findings);
                return Ok(());
            }
        };
        prop_assert!(highest <= 40.0, "{highest}");
        let stops: Vec<_> = outcome.findings.iter().filter(|one| one.grade == Grade::Stop).collect();
        if let [stop] = stops[..] {
            // Upright the torch gives its tilt way, and may come too near: so it must, then.
            prop_assert_eq!(outcome.exit(), Exit::Refused, "{:?}", outcome.findings);
            prop_assert!(stop.what.en.starts_with("the distance of the torch from the pipe falls "), "{:?}", outcome.findings);
            let told = row(&outcome, "Distance of the torch");
            let found = nearest_on_the_way(&design);
            prop_assert!(told - 1e-4 <= found && found <= told + 0.1, "{found} {told}");
            prop_assert!(told < design.g0 - tolerance);
            return Ok(());
        }
        prop_assert_eq!(outcome.exit(), Exit::Done, "{:?}", outcome.findings);
        let (beam, bevel, clear) = (row(&outcome, "Beam"), row(&outcome, "Bevel"), row(&outcome, "Distance of the torch"));
        let motions = cuts(&outcome.programs[0]);
        let mut found = [0.0_f64, f64::INFINITY];
        let mut alpha = 0.0;
        for motion in motions.iter().skip(1) {
            for part in PARTS {
                let axes = [Axis::A, Axis::X, Axis::Z, Axis::B, Axis::C].map(|letter| axis(motion, letter, part));
                let [tip, up] = torch(axes);
                // The nearest place of the cut, from the one before on.
                let off = |alpha: f64| groove.at(alpha).map_or(f64::INFINITY, |one| {
                    (one.root + one.waste * groove.beside - tip).cross(&up).norm()
                });
                let mut step = 0.05;
                while step > 1e-7 {
                    while off(alpha + step) < off(alpha) {
                        alpha += step;
                    }
                    while off(alpha - step) < off(alpha) {
                        alpha -= step;
                    }
                    step /= 4.0;
                }
                let least = off(alpha);
                let exact = groove.at(alpha).expect("a place").pose.axis;
                let angle = (2.0 * rodete::number::trig::asin((up - exact).norm() / 2.0)).to_degrees();
                prop_assert!(least <= beam + 1e-4, "{least} {beam}");
                prop_assert!(angle <= bevel + 0.05, "{angle} {bevel}");
                found = [found[0].max(least), found[1].min(nearest_point(&design, [tip, up]))];
            }
        }
        prop_assert!(found[1] >= clear - 1e-4, "{} {clear}", found[1]);
        // The bounds say no more than the truth, or hardly.
        prop_assert!(beam <= found[0] * 1.15 + 0.004 && clear >= found[1] - 0.35, "{found:?} {beam} {clear}");
        prop_assert!(clear >= design.g0 - tolerance - 0.05);
    }

    #[test]
    fn random_branches_keep_what_their_checks_say(
        D in 20.0..600.0_f64, part in 0.1..1.0_f64, wall in 0.02..0.2_f64, theta in 25.0..155.0_f64, off in -1.0..1.0_f64,
        kerf in 0.0..3.0_f64, tolerance in 0.01..0.3_f64, N in 3_u32..400, equal in 0..8_u8, F in 100.0..6000.0_f64,
        mode in prop::sample::select(vec!["flat", "rotary"]), style in prop::sample::select(vec!["full", "annex"]),
        dialect in prop::sample::select(MILLING.map(|control| control.name).to_vec()),
        edges in prop::sample::select(vec![
            ["inside", "outside"], ["outside", "inside"], ["outside", "outside"], ["envelope", "outside"], ["envelope", "mean"],
        ]),
    ) {
        let d = if equal == 0 { D } else { D * part };
        let t = d * wall;
            let choice = |key: &'static str, value: &'static str| (key, Value::Choice(value));
        let annex = style == "annex";
        let changes = [
            real("D_branch", d), real("t_branch", t), real("D_header", D), real("t_header", D * 0.05), real("theta", theta),
            real("e", (D - d) / 2.0 * off), real("kerf", kerf), real("arc_tolerance", tolerance), real("F", F),
            choice("mode", if annex { "flat" } else { mode }), choice("style", style),
            choice("dialect", if annex && dialect == "linuxcnc" { "fagor-8055" } else { dialect }),
            choice("contact", edges[0]), choice("sheet", edges[1]),
        ];
        let again = |N: u32| {
            let changes = changes.iter().cloned().chain([("N", Value::Whole(N))]);
            filled(insert::cases::CASES[0].values(Language::En), changes)
        };
        let values = again(N);
        let design = insert::design::Design::new(&Fields::of(&insert::parameters::FORM, values.clone()).unwrap());
        let outcome = match run(&insert::parameters::FORM, values) {
            Ok(outcome) => outcome,
            Err(refusal) => {
                prop_assert_eq!(refusal.exit, Exit::Refused);
                // Of a pipe so thin that once round it is too many degrees for the F word of G94.
                let fast = dialect == "fagor-8055" && F * 360.0 / (TAU / 2.0 * d) > 99_999.999;
                let known = |one: &Finding| one.what.en.contains("kerf") || one.what.en.contains("lead-in") || fast && one.is(FasterThanFWord::RULE);
                prop_assert!(refusal.findings.iter().all(known), "{:?}", refusal.findings);
                return Ok(());
            }
        };
        // A flat cut with too few divisions is stopped, and is cut with as many as the stop names.
        let too_few = outcome.findings.iter().find(|one| one.is(OffByN::RULE) && one.grade == Grade::Stop);
        let named = too_few.map(|one| one.remedy.en.trim_start_matches("choose N = ").parse::<u32>());
        prop_assert_eq!(outcome.exit(), if named.is_some() { Exit::Refused } else { Exit::Done }, "{:?}", outcome.findings);
        let (outcome, design) = match named {
            None => (outcome, design),
            Some(named) => {
                let flat = !annex && mode == "flat";
                prop_assert!(flat && row(&outcome, "Path") > tolerance, "{:?}", outcome.findings);
                // Of a curve with a sharp bend no N within reach may do.
                let Ok(named) = named else { return Ok(()) };
                let values = again(named);
                let design = insert::design::Design::new(&Fields::of(&insert::parameters::FORM, values.clone()).unwrap());
                let outcome = run(&insert::parameters::FORM, values).expect("a branch");
                prop_assert_eq!(outcome.exit(), Exit::Done, "{} {:?}", named, outcome.findings);
                (outcome, design)
            }
        };
        let design = design.expect("a design");
        let outline = design.outline();
        let told = row(&outcome, "Path");
        let program = &outcome.programs[0];
        let setting = rodete::gcode::interpreter::Setting {
            part: annex,
            ..program.setting()
        };
        let mut most = 0.0_f64;
        let flat = design.mode == insert::design::Mode::Flat;
        let spans: Vec<Option<[f64; 2]>> = match insert::cut::cut(&design) {
            Ok(cut) if !annex => cut.legs.iter().map(|leg| match leg.follows {
                insert::cut::Follows::Curve(span) => Some(span),
                _ => None,
            }).collect(),
            _ => insert::arcs::triples(&insert::program::template_points(&design), tolerance)
                .windows(2)
                .map(|pair| Some([pair[0].to.x / outline.radius, pair[1].to.x / outline.radius]))
                .collect(),
        };
        let feeds = program.read_back_with(setting).map(|motion| motion.expect("taken"));
        let feeds = feeds.filter(|motion| matches!(motion.kind, MotionKind::Feed(_) | MotionKind::Arc(..)));
        for (motion, span) in feeds.skip(usize::from(annex)).zip(spans) {
            let Some([from, to]) = span else { continue };
            let [x, y] = if flat { [Axis::X, Axis::Y] } else { [Axis::A, Axis::X] };
            for part in PARTS {
                let point = match motion.kind {
                    MotionKind::Arc(arc, _) => {
                        let centre = Vector2::from(arc.centre);
                        let start = Vector2::new(motion.from.get(x), motion.from.get(y)) - centre;
                        let (sin, cos) = sin_cos(arc.sweep * part);
                        centre + Vector2::new(start.x * cos - start.y * sin, start.x * sin + start.y * cos)
                    }
                    _ => {
                        let round = axis(&motion, x, part);
                        let round = if flat { round } else { round.to_radians() * outline.radius };
                        Vector2::new(round, axis(&motion, y, part))
                    }
                };
                let near = |step: u16| {
                    outline.torch(from + (to - from) * f64::from(step) / 800.0, if step < 400 { Side::After } else { Side::Before })
                };
                let least = (0..=800).map(|step| (near(step) - point).norm()).fold(f64::INFINITY, f64::min);
                // The nearest may lie between two.
                let slack = (0..800).map(|step| (near(step + 1) - near(step)).norm()).fold(0.0, f64::max);
                most = most.max(least - 0.5 * slack);
                prop_assert!(least <= told + 0.5 * slack + 1e-4, "{least} {told} {motion:?}");
            }
        }
        if !annex {
            prop_assert!(most <= tolerance + 0.005, "{most}");
        }
        let grades = outcome.findings.iter().filter(|one| one.grade == Grade::Stop).count();
        prop_assert_eq!(grades, 0);
    }
}

/// A branch cut on LinuxCNC, with changes.
fn branch(changes: Vec<(&'static str, Value)>) -> Outcome {
    run(&insert::parameters::FORM, filled(insert::cases::CASES[0].values(Language::En), changes)).expect("a branch")
}

/// The curve closes on a bore narrower than the header; what of the wall passes its side rests on nothing.
#[test]
fn a_wall_that_passes_the_headers_side_is_told() {
    let over = |D: f64, t: f64, e: f64, contact: &'static str| {
        let sizes = [("D_branch", D), ("t_branch", t), ("D_header", 114.3), ("t_header", 6.0), ("e", e)];
        let mut changes: Vec<_> = sizes.into_iter().map(|(key, value)| real(key, value)).collect();
        changes.push(choice("contact", contact));
        let outcome = branch(changes);
        let told = outcome.findings.iter().find(|one| one.code() == "P2122");
        told.map(|one| (one.what.en.clone().into_owned(), one.remedy.en.clone().into_owned()))
    };
    for contact in ["envelope", "inside"] {
        let (what, remedy) = over(133.0, 16.0, 0.0, contact).expect("told");
        assert!(what.contains("by 9.35 mm: r_o = 66.5 mm, e = 0 mm, R = 57.15 mm"), "{what}");
        assert_eq!(remedy, "choose a smaller branch");
        let (what, remedy) = over(100.0, 8.0, 9.0, contact).expect("told");
        assert!(what.contains("by 1.85 mm"), "{what}");
        assert_eq!(remedy, "choose a smaller branch, or an eccentricity of 7.15 mm at most");
        // As wide as the header, the branch ends at its side.
        assert_eq!(over(114.3, 6.0, 0.0, contact), None);
        assert_eq!(over(100.0, 8.0, 7.1, contact), None);
    }
    assert_eq!(over(100.0, 8.0, 7.1, "outside"), None);
}

/// Where points fall counts as much as how many there are: the N that is named is tried.
#[test]
fn the_division_that_is_named_keeps_to_the_tolerance() {
    let flat = |N: u32| {
        let sizes = [
            ("D_branch", 88.9),
            ("t_branch", 5.6),
            ("D_header", 168.3),
            ("t_header", 7.1),
            ("theta", 60.0),
            ("e", 10.0),
        ];
        let mut changes: Vec<_> = sizes.into_iter().map(|(key, value)| real(key, value)).collect();
        changes.extend([choice("mode", "flat"), ("N", Value::Whole(N))]);
        branch(changes)
    };
    for N in [3, 66, 81] {
        let outcome = flat(N);
        let told = outcome.findings.iter().find(|one| one.code() == "V0024").expect("told");
        assert_eq!(told.grade, Grade::Stop);
        let named: u32 = told.remedy.en.trim_start_matches("choose N = ").parse().expect("an N");
        assert!(named > N && flat(named).findings.iter().all(|one| one.code() != "V0024"), "{N} {named}");
    }
}

/// A template to wrap round the pipe that is shorter than it is round.
#[test]
fn a_template_of_the_bore_does_not_go_round_the_pipe() {
    let told = |sheet: &'static str, mode: &'static str| {
        let sizes = [("D_branch", 88.9), ("t_branch", 5.49), ("D_header", 114.3), ("t_header", 6.02)];
        let mut changes: Vec<_> = sizes.into_iter().map(|(key, value)| real(key, value)).collect();
        changes.extend([choice("sheet", sheet), choice("mode", mode)]);
        let outcome = branch(changes);
        outcome.findings.into_iter().find(|one| one.code() == "P2123").map(|one| one.what.en.into_owned())
    };
    assert!(
        told("inside", "rotary").is_some_and(|what| what.contains("is 244.793 mm long and the pipe 279.288 mm round"))
    );
    assert!(told("mean", "rotary").is_some());
    assert_eq!((told("outside", "rotary"), told("inside", "flat")), (None, None));
}
