//! The judges: the published figures, what must hold for every design, and programs with one fault each.

use crate::common;
use crate::common::change::real;

mod blank;
mod clear_cut;
mod clearance;
mod due;
mod outside;
mod tip_path;
mod tool;

use std::collections::BTreeMap;

use proptest::prelude::*;
use rodete::finding::{Grade, Place};
use rodete::gcode::control::MILLING;
use rodete::gcode::header::Origin;
use rodete::gcode::interpreter::Interpreter;
use rodete::gcode::program::Program;
use rodete::kind::method::Method;
use rodete::kinds::impeller::blade::Blade;
use rodete::kinds::impeller::blade_count::e_max;
use rodete::kinds::impeller::design::Design;
use rodete::kinds::impeller::ideal::Ideal;
use rodete::kinds::impeller::programs::{Tracks, programs};
use rodete::kinds::impeller::proof::refinement::{greatest, needed};
use rodete::kinds::impeller::proof::tip_path::{between, deviation};
use rodete::kinds::impeller::splitter::Splitter;
use rodete::kinds::impeller::tables::ToolPaths;
use rodete::kinds::impeller::track::Track;
use rodete::kinds::impeller::{self, Impeller};
use rodete::machine::axis::{Axis, Pose};
use rodete::number::grid::Milli;
use rodete::parameter::Value;
use rodete::parameter::field::Fields;
use rodete::proof::agreement::Agreement;
use rodete::proof::rules::NotAnswered;
use rodete::proof::step::{Judge, Plan, Steps};
use rodete::proof::text::Characters;
use rodete::table::Entry;
use rodete::text::Language;
use tool::Tool;

fn published(n: u32) -> Design {
    Design::new(&common::fields("tfg-2021", &[("n", Value::Whole(n))])).unwrap()
}

/// The greatest deviation and the farthest into the metal along a track of a blade, from positions that are not
/// rounded.
fn exact(design: &Design, track: Track) -> [f64; 2] {
    let blade = common::blade(design);
    let passes = ToolPaths::new(design, &blade);
    let points = if track == Track::Obverse { &passes.obverse } else { &passes.reverse };
    let ideal = Ideal::new(design, None, track).unwrap();
    let pose = |i: usize| {
        let mut pose = Pose::default();
        let angles = [(Axis::B, blade.B[i].to_degrees()), (Axis::C, blade.C[i].to_degrees())];
        let lines = [Axis::X, Axis::Y, Axis::Z].into_iter().zip(points[i].iter().copied());
        lines.chain(angles).for_each(|(axis, value)| pose.set(axis, value));
        pose
    };
    let mut most = [0.0_f64; 2];
    for i in 0..design.n {
        for part in 0..=16 {
            let fraction = f64::from(part) / 16.0;
            let at = between(&pose(i), &pose(i + 1), fraction);
            let off = deviation(&ideal, design.machine, &at, Milli::ZERO, i as f64 + fraction);
            most = [most[0].max(off.total), most[1].max(off.into_metal())];
        }
    }
    most
}

#[test]
fn the_tip_leaves_its_path_as_published() {
    let shown = |n: u32| exact(&published(n), Track::Obverse).map(|value| format!("{value:.3}"));
    assert_eq!(shown(40), ["0.047", "0.046"]);
    assert_eq!(shown(80)[0], "0.012");
    // 0.0030 before and 0.0037 after rounding to the grid; the published figure, 0.0031, lies between.
    let before = exact(&published(160), Track::Obverse)[0];
    let after = greatest(&published(160), 160, f64::INFINITY).unwrap();
    assert!(before > 0.0029 && before < 0.0031 && after > 0.0031 && after < 0.0038, "{before} {after}");
    let [total, metal] = exact(&published(40), Track::Reverse);
    assert!((total - 0.0470).abs() < 5e-5 && (metal - 0.0465).abs() < 5e-5, "{total} {metal}");
}

#[test]
fn the_n_that_meets_a_tolerance_is_the_least_about_it() {
    for tolerance in [0.02, 0.01, 0.004] {
        let design = published(40);
        let n = needed(&design, greatest(&design, 40, f64::INFINITY).unwrap(), tolerance).unwrap();
        assert!(greatest(&design, n, f64::INFINITY).unwrap() <= tolerance, "{n}");
        assert!(greatest(&design, n - 1, f64::INFINITY).unwrap() > tolerance, "{n}");
    }
    // What the grid leaves is above a tenth of a micrometre at any n.
    assert_eq!(needed(&published(40), 0.047, 1e-4), None);
}

#[test]
fn a_stated_tolerance_stops_the_work_and_names_the_n() {
    let outcome = common::outcome("full", &[real("tol", 0.01)]);
    assert!(outcome.stopped() && outcome.programs.is_empty());
    let stop = outcome.findings.iter().find(|finding| finding.grade == Grade::Stop).unwrap();
    assert_eq!(
        stop.what.en,
        "between blocks the tip deviates from its path by 0.0476 mm in \"One blade\"; the tolerance is 0.01 mm"
    );
    assert_eq!(stop.remedy.en, "choose n of at least 90: the deviation then falls to 0.01 mm");
    assert!(!common::outcome("full", &[real("tol", 0.01), ("n", Value::Whole(90))]).stopped());
    assert!(common::outcome("full", &[real("tol", 0.01), ("n", Value::Whole(89))]).stopped());
}

#[test]
fn coarse_steps_are_a_caution_that_names_the_n() {
    let outcome = common::outcome("full", &[("n", Value::Whole(30))]);
    let caution = outcome.findings.iter().find(|finding| finding.what.en.contains("into the metal")).unwrap();
    assert_eq!(caution.grade, Grade::Caution);
    assert_eq!(caution.remedy.en, "choose n of at least 90: the deviation then falls to 0.01 mm");
}

#[test]
fn shipped_programs_pass_but_for_the_published_splitter() {
    for case in ["tfg-2021", "full"] {
        for dialect in MILLING.map(|control| control.name) {
            // LinuxCNC does not move without F, which style annex does not carry.
            if case == "tfg-2021" && dialect == "linuxcnc" {
                continue;
            }
            for distance in ["G90", "G91"] {
                let changes = [
                    ("dialect", Value::Choice(dialect)),
                    ("distance", Value::Choice(distance)),
                    ("start_codes", Value::Line("M3".to_owned())),
                ];
                let prepared = Prepared::new(case, &changes);
                for program in ["blade", "splitter", "impeller"] {
                    let worst = prepared.verdicts(program, str::to_owned);
                    for (key, verdict) in worst {
                        // Its pass cuts into a blade, and the pass of a blade into it.
                        let met = program != "blade" && key == "blades" || program != "splitter" && key == "splitters";
                        let known = case == "tfg-2021" && met;
                        assert_eq!(verdict > Some(Grade::Note), known, "{case} {dialect} {distance} {program}: {key}");
                    }
                }
            }
        }
    }
}

#[test]
fn the_usual_design_gives_nothing_to_judge_but_its_part_and_where_machine_zero_is() {
    let outcome = common::outcome("full", &[]);
    // What the plan leaves of the part has tests of its own.
    let of_part = |place: &Place| matches!(place, Place::Parameters(keys) if keys.iter().any(|key| ["N", "e", "d_t", "a_p"].contains(&key.name())));
    let above = outcome.findings.iter().filter(|finding| finding.grade > Grade::Note && !of_part(&finding.place));
    let above: Vec<_> = above.collect();
    assert_eq!(above.len(), 1, "{above:?}");
    assert!(above[0].what.en.starts_with("retract with G53 assumes"), "{above:?}");
}

/// The least distance of the tip at a point of a splitter's path from the foot of the neighbouring blade's mean line, the
/// neighbour on the side of the path: a measure that shares nothing with the judge.
fn tip_to_neighbour(design: &Design, splitter: &Splitter, track: Track, i: usize) -> f64 {
    let blade = common::blade(design);
    let tip = design.machine.to_part(&splitter.side(track).unwrap().path[i], blade.B[i], blade.C[i]);
    let (sin, cos) = rodete::number::trig::sin_cos(-track.side() * std::f64::consts::PI / f64::from(design.N));
    let dense = Blade::new(design.torus, 4000, 0.0, design.machine);
    (0..dense.points())
        .map(|i| dense.P[i] - dense.N[i] * design.a_p)
        .map(|foot| nalgebra::Vector3::new(foot.x * cos - foot.y * sin, foot.x * sin + foot.y * cos, foot.z))
        .map(|foot| (foot - tip).norm())
        .fold(f64::INFINITY, f64::min)
}

/// The published splitter's path 1 reaches its full offset where the paths on its *other* side cross, eleven points too
/// early for this one.
#[test]
fn the_published_splitter_cuts_into_its_neighbour() {
    let design = published(40);
    let splitter = Splitter::new(&design, &common::blade(&design)).unwrap();
    assert!(splitter.crossing.along_first < 20.0 && splitter.crossing.along_second > 27.0);
    assert_eq!([splitter.out.m, splitter.back.m], [20, 20]);
    let nearest = tip_to_neighbour(&design, &splitter, Track::Out, 20);
    // A tool that clears the blade stands (e + d_t)/2 = 4 mm from its mean line.
    assert!((nearest - 2.25).abs() < 0.01, "{nearest}");
    let caution = common::outcome("tfg-2021", &[]);
    let caution = caution.findings.iter().find(|finding| finding.what.en.contains("the splitter's pass cuts")).unwrap();
    // 1.93755 mm; rulings are taken to begin up to 0.00085 mm above the turned surface, which adds 0.0002.
    assert_eq!((caution.grade, caution.value.as_str()), (Grade::Caution, "bounded between -1.9378 and -1.9376 mm"));
    assert!(caution.remedy.en.starts_with("set splitter_fade = each-side or "), "{}", caution.remedy.en);
    assert!(
        !common::outcome("tfg-2021", &[("splitters", Value::Choice("no"))])
            .findings
            .iter()
            .any(|finding| { finding.what.en.contains("neighbouring blade") })
    );
}

#[test]
fn a_splitter_whose_sides_fade_by_themselves_leaves_its_neighbours_alone() {
    let design = Design::new(&common::fields("full", &[])).unwrap();
    let splitter = Splitter::new(&design, &common::blade(&design)).unwrap();
    assert_eq!([splitter.out.m, splitter.back.m], [32, 21]);
    for track in [Track::Out, Track::Back] {
        for i in 0..=design.n {
            let nearest = tip_to_neighbour(&design, &splitter, track, i);
            assert!(nearest >= 4.0, "{} {i}: {nearest}", track.key());
        }
    }
    // One point earlier each side would cut in, at the crossing in plan all the more.
    for (track, m) in [(Track::Out, 32), (Track::Back, 21)] {
        let at = |i: usize| touching(&design, track, i, 1.0);
        assert!(at(m - 1) < 0.0 && at(m) >= 0.0, "{}: {} {}", track.key(), at(m - 1), at(m));
    }
    assert!(touching(&design, Track::Out, 29, 1.0) < -0.4);
}

#[test]
fn a_splitter_that_cuts_into_a_blade_stops_the_work_where_each_side_fades_by_itself() {
    let aside = |text: &str| with(text, line_of(text, "B47.250 "), 'Y', |value| value + 4.0);
    let wide = real("tol", 10.0);
    assert_eq!(verdicts("full", std::slice::from_ref(&wide), "splitter", aside)["blades"], Some(Grade::Stop));
    let changes = [wide, ("splitter_fade", Value::Choice("published"))];
    assert_eq!(verdicts("full", &changes, "splitter", aside)["blades"], Some(Grade::Caution));
}

/// The distance of the tool from the neighbouring blade on a splitter track's side, at the point i with a fraction of the
/// full offset: over points of the flanks, without the judge's search.
fn touching(design: &Design, track: Track, i: usize, fraction: f64) -> f64 {
    let blade = common::blade(design);
    let w = track.side() * design.w() * fraction;
    let tip = blade.P[i] + blade.b[i] * w - blade.N[i] * design.a_p;
    let tool = Tool { tip, axis: blade.N[i], radius: design.d_t / 2.0 };
    let tool = tool.turned(track.side() * std::f64::consts::PI / f64::from(design.N));
    let dense = Blade::new(design.torus, 400, 0.0, design.machine);
    let mut least = f64::INFINITY;
    for j in 0..dense.points() {
        for side in [0.5, -0.5] {
            for h in 0..=8 {
                let point =
                    dense.P[j] + dense.b[j] * (side * design.e) - dense.N[j] * (design.a_p * f64::from(h) / 8.0);
                least = least.min(tool.distance(&point));
            }
        }
    }
    least
}

#[test]
fn a_blade_that_cuts_into_a_blade_stops_the_work() {
    // Within N_max, which counts the gap along the circumference; across the blades it is narrower by sin α = r/R.
    let changes = [real("r", 8.0), real("a_p", 1.0), ("N", Value::Whole(8)), ("splitters", Value::Choice("no"))];
    let narrow = common::outcome("full", &changes);
    let stop = narrow.findings.iter().find(|finding| finding.grade == Grade::Stop).unwrap();
    assert!(stop.what.en.contains("into the neighbouring blade"), "{}", stop.what.en);
    assert!(narrow.programs.is_empty());
}

/// A design with its programs.
struct Prepared {
    design: Design,
    model: impeller::Model,
    programs: Vec<Program>,
}

impl Prepared {
    /// The case `full` with positions, whose text is changed line by line: increments have tests of their own.
    fn new(case: &str, changes: &[(&'static str, Value)]) -> Self {
        let changes = &if case == "full" { common::absolute(changes) } else { changes.to_vec() };
        let design = Design::new(&common::fields(case, changes)).unwrap();
        let model = Impeller::model(&design).unwrap();
        let outcome = common::outcome(case, changes);
        let stops: Vec<_> = outcome.findings.iter().filter(|finding| finding.grade == Grade::Stop).collect();
        assert!(stops.is_empty(), "{stops:?}");
        let programs = outcome.programs.into_iter().map(|proved| proved.program).collect();
        Self { design, model, programs }
    }

    /// The worst verdict of each check on a program's text after a change.
    fn verdicts(&self, key: &str, change: impl Fn(&str) -> String) -> BTreeMap<&'static str, Option<Grade>> {
        let program = self.programs.iter().find(|program| program.key == key).unwrap();
        let checks = common::checks::<Impeller>(&self.design, &self.model, program, &change(&program.text()));
        let mut worst = BTreeMap::new();
        for check in checks {
            let known = worst.entry(check.key()).or_insert(check.grade());
            *known = check.grade().max(*known);
            if check.grade() > Some(Grade::Note) {
                let finding = check.finding().unwrap_or_else(|| panic!("{check:?}"));
                assert!(!finding.what.es.is_empty() && !finding.remedy.es.is_empty());
            }
        }
        worst
    }
}

/// The worst verdict of each check on the text of one program of a case after a change.
fn verdicts(
    case: &str,
    changes: &[(&'static str, Value)],
    key: &str,
    change: impl Fn(&str) -> String,
) -> BTreeMap<&'static str, Option<Grade>> {
    Prepared::new(case, changes).verdicts(key, change)
}

/// The text with one word of one line changed by a function of its number.
fn with(text: &str, line: usize, letter: char, change: impl Fn(f64) -> f64) -> String {
    let lines = text.lines().enumerate().map(|(at, found)| {
        if at + 1 != line {
            return found.to_owned();
        }
        assert!(found.contains(letter), "{found}");
        let words = found.split(' ').map(|word| match word.strip_prefix(letter) {
            Some(number) => format!("{letter}{:.3}", change(number.parse().unwrap())),
            None => word.to_owned(),
        });
        words.collect::<Vec<_>>().join(" ")
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// A line by what it holds.
fn line_of(text: &str, part: &str) -> usize {
    text.lines().position(|line| line.contains(part)).expect("the line") + 1
}

#[test]
fn one_wrong_digit_is_caught() {
    let prepared = Prepared::new("tfg-2021", &[]);
    for line in [2, 3, 17, 43, 44, 60, 87] {
        for letter in ['X', 'Y', 'Z', 'B', 'C'] {
            let worst = prepared.verdicts("blade", |text| with(text, line, letter, |value| value + 0.001));
            assert_eq!(worst["agreement"], Some(Grade::Stop), "{line} {letter}");
            assert_eq!(worst["closure"], Some(Grade::Stop), "{line} {letter}");
        }
    }
}

#[test]
fn a_full_circle_beyond_the_plan_is_caught_though_it_ends_where_it_begins() {
    let circle = |text: &str| text.replacen("N970 ", "N965 G2 X0.000 Y0.000 I1.000 J0.000 F300.000\nN970 ", 1);
    let outcome = common::outcome("full", &[]);
    let program = &outcome.programs[0];
    let text = circle(&program.text());
    assert_ne!(text, program.text());
    let design =
        Design::new(&Fields::of(&rodete::kinds::impeller::parameters::FORM, common::values("full", &[])).unwrap())
            .unwrap();
    let mut agreement: Box<dyn Judge> = Box::new(Agreement::of_the_tip(design.machine, program));
    let mut steps = Steps::new(Plan::of(program));
    let mut read = Interpreter::over(text.as_bytes(), program.setting());
    while let Some(motion) = read.next() {
        let step = steps.next(motion.unwrap(), *read.in_force());
        agreement.see(&step);
    }
    assert_eq!(agreement.checks(program).remove(0).grade(), Some(Grade::Stop));
}

/// What is due of it is due, and nobody answers.
#[test]
fn a_program_that_is_not_known_is_judged_as_no_other() {
    let Prepared { design, model, programs } = Prepared::new("tfg-2021", &[]);
    let program = Program { key: "contour", ..programs[0].clone() };
    let checks = common::checks::<Impeller>(&design, &model, &program, &program.text());
    for due in Impeller::due(&design, &program) {
        let answer = checks.iter().find(|check| check.key() == due.key()).unwrap_or_else(|| panic!("{}", due.key()));
        assert!(answer.grade() == Some(Grade::Stop) && answer.finding().unwrap().is(NotAnswered::RULE), "{answer:?}");
    }
}

#[test]
fn a_wrong_sign_is_caught() {
    let worst = verdicts("tfg-2021", &[], "blade", |text| with(text, 20, 'Z', |value| -value));
    assert_eq!((worst["agreement"], worst["closure"]), (Some(Grade::Stop), Some(Grade::Stop)));
    assert!(worst["into-metal"] > Some(Grade::Note) || worst["tip-path"] > Some(Grade::Note));
}

#[test]
fn a_dropped_and_a_doubled_block_are_caught() {
    let drop = |text: &str| {
        text.lines().enumerate().filter(|(at, _)| *at != 19).map(|(_, line)| line.to_owned() + "\n").collect()
    };
    let worst = verdicts("tfg-2021", &[], "blade", drop);
    assert_eq!((worst["agreement"], worst["closure"]), (Some(Grade::Stop), Some(Grade::Stop)));
    assert_eq!(worst["characters"], Some(Grade::Stop), "the block numbers have a gap");
    let double = |text: &str| {
        text.lines()
            .enumerate()
            .flat_map(|(at, line)| vec![line.to_owned() + "\n"; 1 + usize::from(at == 86)])
            .collect()
    };
    let worst = verdicts("tfg-2021", &[], "blade", double);
    assert_eq!((worst["agreement"], worst["closure"]), (Some(Grade::Stop), Some(Grade::Stop)));
}

#[test]
fn a_doubled_feed_is_caught() {
    for dialect in MILLING.map(|control| control.name) {
        let faster = move |value: f64| if dialect == "fagor-8070" { value / 2.0 } else { value * 2.0 };
        let worst = verdicts("full", &[("dialect", Value::Choice(dialect))], "blade", |text| {
            with(text, line_of(text, "B78.750 "), 'F', faster)
        });
        assert_eq!((worst["feed-tip"], worst["agreement"]), (Some(Grade::Stop), Some(Grade::Stop)), "{dialect}");
        assert_eq!(worst["closure"], None);
    }
    // And where the tip may run so fast, the axes may not.
    let worst = verdicts("full", &[real("F_max", 3300.0)], "blade", |text| {
        with(text, line_of(text, "B2.250 "), 'F', |value| value * 2.0)
    });
    assert_eq!(worst["feed-axis"], Some(Grade::Stop));
}

#[test]
fn a_jump_of_c_is_caught() {
    let worst =
        verdicts("full", &[], "blade", |text| with(text, line_of(text, "B45.000 "), 'C', |value| value + 360.0));
    assert_eq!((worst["turning"], worst["agreement"]), (Some(Grade::Stop), Some(Grade::Stop)));
}

#[test]
fn a_motion_two_millimetres_lower_is_caught() {
    let lower = |text: &str| with(text, line_of(text, "B45.000 "), 'Z', |value| value - 2.0);
    let worst = verdicts("full", &[], "blade", lower);
    assert_eq!((worst["agreement"], worst["into-metal"]), (Some(Grade::Stop), Some(Grade::Caution)));
    let worst = verdicts("full", &[real("tol", 0.05)], "blade", lower);
    assert_eq!(worst["tip-path"], Some(Grade::Stop));
}

#[test]
fn a_crossing_move_through_the_stock_is_caught() {
    // 12 mm towards the part before the crossing at the exit, and 12 mm back after it.
    let nearer = |text: &str| {
        let text = with(text, 43, 'X', |value| value - 12.0);
        with(&text, 45, 'X', |value| value + 12.0)
    };
    let worst = verdicts("tfg-2021", &[], "blade", nearer);
    assert_eq!((worst["safe-points"], worst["clear-moves"]), (Some(Grade::Stop), Some(Grade::Stop)));
    assert_eq!(worst["closure"], None);
}

#[test]
fn an_axis_beyond_its_travel_is_caught_in_the_text() {
    let worst = verdicts("full", &[], "blade", |text| with(text, line_of(text, "B45.000 "), 'B', |_| 101.0));
    assert_eq!((worst["travel"], worst["agreement"]), (Some(Grade::Stop), Some(Grade::Stop)));
}

#[test]
fn a_tool_that_cuts_into_the_next_blade_is_caught() {
    let aside = |text: &str| with(text, line_of(text, "B87.750 "), 'Y', |value| value - 4.0);
    assert_eq!(verdicts("full", &[], "blade", aside)["blades"], Some(Grade::Stop));
}

#[test]
fn characters_that_no_control_takes_are_caught() {
    let outcome = common::outcome("full", &common::absolute(&[]));
    let program = &outcome.programs[0];
    for (good, bad) in [
        ("X-250.900", "X-250,900"),
        ("B45.000", "B45"),
        ("C0.000", "C-0.000"),
        ("B45.000", "B4.5e1"),
        ("B45.000", "B45.0000"),
        ("G1 X", "G1  X"),
        ("G1 X", "g1 X"),
        ("G1 X", "G1 µX"),
        (";PART ", ";(MSG, "),
        ("N100 ", "N101 "),
        ("N100 ", ""),
        ("M30", "M30 ;END"),
    ] {
        let text = program.text().replacen(good, bad, 1);
        assert_ne!(text, program.text(), "{good} is in the text");
        let mut characters = Characters::new(program);
        text.lines().for_each(|line| characters.line(line));
        assert_eq!(characters.check().grade(), Some(Grade::Stop), "{bad}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Beside the ways in and out, which are those of a blade and stop the work where they are too narrow.
    #[test]
    fn a_splitter_whose_sides_fade_by_themselves_clears_its_neighbours_in_any_design(
        (R, part) in (8.0..900.0_f64, 0.35..0.93_f64), n in 4_u32..160, N in 2_u32..10,
        (depth, wide, thick) in (0.03..0.5_f64, 0.1..0.6_f64, 0.05..0.9_f64), L in 0.2..4.0_f64,
    ) {
        let torus = rodete::geometry::torus::Torus { R, r: R * part };
        let a_p = ((torus.R - torus.r) * depth).min(100.0);
        let d_t = (e_max(torus, a_p, N, 0.0) * wide).clamp(0.2, 2.0 * torus.r).min(100.0);
        let e = (e_max(torus, a_p, N, d_t) * thick).min(100.0);
        let values = common::values("full", &[
            real("R", R), real("r", torus.r), ("n", Value::Whole(n)), ("N", Value::Whole(N)), real("a_p", a_p),
            real("d_t", d_t), real("e", e), real("d_s", (e + d_t).min(500.0)), real("R_B", R * L), real("H", R),
            real("L_b", 2.0 * R), real("X_e", 3.0 * R),
        ]);
        prop_assume!(e >= 0.05);
        // Of the tip's path nothing is asked here, nor the n for it.
        let design = Design { tol: Some(f64::INFINITY), ..Design::new(&Fields::of(&rodete::kinds::impeller::parameters::FORM, values.clone()).unwrap()).unwrap() };
        let blade = common::blade(&design);
        let splitter = Splitter::new(&design, &blade);
        // Some designs have no splitter, and are refused.
        prop_assume!(splitter.is_ok());
        let splitter = splitter.unwrap();
        let tracks = Tracks::new(&blade, &ToolPaths::new(&design, &blade), Some(&splitter)).unwrap();
        let origin = Origin { workbook: "", sha256: "", version: "", language: Language::En };
        let made = programs(&design, &tracks, &origin).unwrap();
        let program = made.programs.iter().find(|program| program.key == "splitter").unwrap();
        let checks = common::checks::<Impeller>(&design, &Impeller::model(&design).unwrap(), program, &program.text());
        let blades = checks.iter().find(|check| check.key() == "blades").unwrap();
        let on_the_way = blades.at().unwrap().along.is_none();
        prop_assert_eq!(blades.grade(), if on_the_way && blades.value().en.starts_with('-') { Some(Grade::Stop) } else { None }, "{:?}", blades);
        for track in [Track::Out, Track::Back] {
            let side = splitter.side(track).unwrap();
            prop_assert!(side.m >= 2 && side.m as f64 >= side.crossing && side.fraction[side.m..].iter().all(|&f| f == 1.0));
            for i in (0..=design.n).step_by(design.n.div_ceil(12)).chain([side.m - 1, side.m]) {
                let distance = touching(&design, track, i, side.fraction[i]);
                prop_assert!(distance >= 0.0, "{} {i}: {distance}", track.key());
            }
        }
    }

    #[test]
    fn the_deviation_falls_with_the_square_of_n(
        R in 10.0..500.0_f64, part in 0.2..0.8_f64, n in 24_u32..80, L in 0.6..3.0_f64, w in 0.01..0.1_f64,
    ) {
        let mut design = published(n);
        design.torus = rodete::geometry::torus::Torus { R, r: R * part };
        design.machine.L = R * L;
        design.eps_v = 0.0;
        (design.e, design.d_t, design.a_p) = (R * w, R * w, R * w);
        let once = exact(&design, Track::Obverse)[0];
        design.n *= 2;
        let twice = exact(&design, Track::Obverse)[0];
        prop_assert!((once / twice - 4.0).abs() < 0.1, "{once} {twice}");
    }
}

/// Blocks of a few milliseconds: rounded up to whole ones, they ran far below F.
#[test]
fn small_blocks_keep_their_feed_on_a_control_that_takes_seconds() {
    let retract = ("retract", Value::Line(String::new()));
    let changes = [("dialect", Value::Choice("fagor-8070")), retract, real("F", 600.0), ("n", Value::Whole(1500))];
    let outcome = common::outcome("full", &changes);
    assert!(!outcome.stopped(), "{:?}", outcome.findings);
    let table = outcome.table("verification").expect("the table");
    let text = |column: &str, row: usize| match table.column(column).expect(column).values.get(row) {
        Entry::Text(text) => text.en.to_string(),
        Entry::Number(number) => number.to_string(),
    };
    let rows = (0..table.rows()).filter(|&row| text("Check", row).starts_with("F word"));
    let slower: Vec<f64> =
        rows.map(|row| text("Value", row).trim_end_matches(" %").parse().unwrap_or(f64::NAN)).collect();
    // 0.0001 s of about 0.002 s; of a whole millisecond it was half.
    assert!(slower.iter().take(2).all(|slower| (0.0..5.0).contains(slower)), "{slower:?}");
}
