//! What a workbook may ask of a clear cut beside the usual: other ends of the tools, a cut as far as a tool fits, the
//! largest tool for a rest; and where the programs would be too long.

use rodete::finding::Exit;
use rodete::kind::{End, Outcome};
use rodete::kinds;
use rodete::kinds::impeller::parameters::FORM;
use rodete::parameter::Value;

use crate::common;

/// Changes with what makes a plan short beside them.
fn quick(changes: &[(&'static str, Value)]) -> Vec<(&'static str, Value)> {
    let quick = [("splitters", Value::Choice("no")), ("c_s", Value::Real(0.1)), ("tol", Value::Real(0.03))];
    let quick = quick.into_iter().filter(|(key, _)| changes.iter().all(|change| change.0 != *key));
    quick.chain(changes.iter().cloned()).collect()
}

fn outcome(changes: &[(&'static str, Value)]) -> Outcome {
    common::outcome("clear", &quick(changes))
}

/// What a design is refused for; `None` where it is planned.
fn refused(changes: &[(&'static str, Value)]) -> Option<Vec<String>> {
    let refusal = kinds::run(&FORM, common::values("clear", changes), common::source()).err()?;
    Some(refusal.findings.iter().map(|finding| finding.what.en.clone().into_owned()).collect())
}

fn told<'a>(outcome: &'a Outcome, words: &str) -> Option<&'a str> {
    outcome.findings.iter().map(|finding| &*finding.what.en).find(|what| what.contains(words))
}

/// A part on a long blank, in the order R, r, N, e, a_p, d_t, d_f, tol, and whether it has splitters.
fn design(values: [f64; 8], splitters: &'static str) -> Outcome {
    outcome(&cells(values, splitters))
}

/// The cells of such a part.
fn cells(values: [f64; 8], splitters: &'static str) -> Vec<(&'static str, Value)> {
    let keys = ["R", "r", "N", "e", "a_p", "d_t", "d_f", "tol"];
    let whole = |value: f64| Value::Whole((1..100).find(|&whole| f64::from(whole) == value).expect("a whole number"));
    let mut changes: Vec<(&'static str, Value)> = keys
        .into_iter()
        .zip(values)
        .map(|(key, value)| (key, if key == "N" { whole(value) } else { Value::Real(value) }))
        .collect();
    changes.extend([("splitters", Value::Choice(splitters)), ("L_b", Value::Real(80.0))]);
    changes
}

fn quantity(outcome: &Outcome, symbol: &str) -> Option<f64> {
    outcome.quantities.iter().find(|one| one.symbol == symbol).map(|one| one.value)
}

#[test]
fn lanes_that_pass_close_by_a_splitter_do_not_cut_into_its_nose() {
    // With three blades and these depths a lane clears the splitter's faces by less than its nose stands out of them.
    for a_p in [1.7, 1.75, 1.8] {
        let outcome = common::outcome("clear", &[("N", Value::Whole(3)), ("a_p", Value::Real(a_p))]);
        assert_eq!(End::of(&outcome.findings, false), End::Whole, "{a_p} {:?}", outcome.findings);
        assert!(quantity(&outcome, "v_s").is_some());
    }
}

#[test]
fn a_finishing_tool_thinner_than_the_blade_does_not_cut_into_it() {
    // Its axis may lie in the blade and touch no face; and its distance from a face has two valleys close to each other.
    for cells in [[53.2, 31.1, 6.0, 3.9, 6.7, 2.3, 1.07, 0.03], [41.9, 23.4, 5.0, 3.0, 4.3, 2.3, 1.33, 0.01]] {
        let outcome = design(cells, "no");
        assert_eq!(End::of(&outcome.findings, false), End::Whole, "{cells:?} {:?}", outcome.findings);
    }
}

#[test]
fn a_deep_hub_whose_faces_pass_the_axis_is_cut_whole() {
    // Its faces pass the axis of the part beside the floor: as long as their ends were not known no bound closed. The contact of the
    // finishing tool was sought from inside the blade, and its lanes went through it.
    let outcome = design([23.83, 16.0, 2.0, 3.93, 4.49, 4.91, 1.94, 0.016], "no");
    assert_eq!(End::of(&outcome.findings, false), End::Whole, "{:?}", outcome.findings);
}

#[test]
fn a_search_that_takes_all_of_its_work_leaves_the_others_decided() {
    // The first pass looked at runs beside far faces evenly: no bounds of it close, and what was left was too little for the others.
    let real = |key, value: f64| (key, Value::Real(value));
    let cells = [
        real("R", 38.57),
        real("r", 27.588),
        real("e", 1.895),
        real("a_p", 5.628),
        real("d_t", 2.0),
        real("d_f", 2.0),
        real("r_cf", 1.0),
        real("s_w", 0.571),
        real("kappa", 0.625),
        real("c_s", 0.02),
        real("delta", 0.5),
        real("tol", 0.02),
        real("L_b", 58.0),
    ];
    let outcome = common::outcome("clear", &cells);
    assert_eq!(End::of(&outcome.findings, false), End::Whole, "{:?}", outcome.findings);
}

#[test]
fn floor_lanes_overlap_however_thin_the_finishing_tool_is() {
    // By the law of the ridges alone the lanes would be farther apart than the tool is wide, with strips of the floor between.
    for (d_f, c_s) in [(1.0, 0.025), (1.5, 0.1)] {
        let outcome = outcome(&[("d_f", Value::Real(d_f)), ("c_s", Value::Real(c_s)), ("tol", Value::Real(0.02))]);
        let rest = quantity(&outcome, "floor_rest").unwrap();
        assert!(rest <= c_s + 0.02, "{d_f}: {rest}");
        assert!(told(&outcome, "more than the ridge").is_none(), "{d_f}");
    }
}

#[test]
fn the_flank_of_a_deep_blade_is_not_cut_into_where_it_goes_over_into_its_straight_end() {
    let outcome = design([22.0, 8.3, 3.0, 2.4, 6.5, 6.1, 2.9, 0.0145], "no");
    assert_eq!(End::of(&outcome.findings, false), End::Whole, "{:?}", outcome.findings);
}

#[test]
fn the_way_round_a_thick_splitter_keeps_clear_of_its_nose_where_that_stands_out_of_the_faces() {
    for cells in [[35.05, 11.04, 3.0, 3.53, 3.15, 4.17, 2.99, 0.014], [41.6, 15.9, 4.0, 3.67, 6.77, 4.63, 2.05, 0.014]]
    {
        let outcome = design(cells, "yes");
        assert_eq!(End::of(&outcome.findings, false), End::Whole, "{cells:?} {:?}", outcome.findings);
        assert!(quantity(&outcome, "v_s").is_some());
    }
}

#[test]
fn the_figure_of_the_finishing_names_a_splitter_only_where_there_is_one() {
    for (splitters, named) in [("no", false), ("yes", true)] {
        let outcome = outcome(&[("splitters", Value::Choice(splitters))]);
        let figure = outcome.figures.iter().find(|figure| figure.key == "finishing").expect("a figure");
        assert_eq!(figure.caption.en.contains("splitter"), named, "{}", figure.caption.en);
        assert_eq!(figure.caption.es.contains("intermedio"), named, "{}", figure.caption.es);
    }
}

#[test]
fn rounded_ends_are_judged_and_their_rests_told() {
    for (r_c, r_cf, end) in [(0.0, 0.5, "BULL NOSE"), (3.0, 1.5, "BALL")] {
        let outcome = outcome(&[("r_c", Value::Real(r_c)), ("r_cf", Value::Real(r_cf))]);
        assert_eq!(End::of(&outcome.findings, false), End::Whole, "{:?}", outcome.findings);
        let root = outcome.quantities.iter().find(|one| one.symbol == "root_height").unwrap().value;
        assert!(root >= r_cf / 3.0, "{root}");
        assert_eq!(told(&outcome, "rounded end of the finishing tool").is_some(), root >= 2.0);
        // What is left above the corner has no figure where there is nothing above it.
        for symbol in ["rest_above", "rest_obverse", "rest_reverse"] {
            assert_eq!(quantity(&outcome, symbol).is_none(), root >= 2.0, "{symbol}");
        }
        let finish = common::program(&outcome, "finish");
        assert!(finish.contains(end) && finish.contains("CORNER RADIUS"), "{}", &finish[..600]);
        assert_eq!(common::program(&outcome, "rough").contains("FLAT END MILL"), r_c == 0.0);
    }
}

#[test]
fn one_tool_for_both_is_told_of_once_and_sticks_out_alike() {
    let one = |changes: &[(&'static str, Value)]| {
        let usual = [
            ("method", Value::Choice("clear")),
            ("splitters", Value::Choice("no")),
            ("c_s", Value::Real(0.1)),
            ("tol", Value::Real(0.03)),
        ];
        let made = common::outcome("full", &[&usual, changes].concat());
        assert_eq!(End::of(&made.findings, false), End::Whole, "{:?}", made.findings);
        ["P1209", "P1214", "P1230"].map(|code| made.findings.iter().filter(|finding| finding.code() == code).count())
    };
    assert_eq!(one(&[]), [1, 1, 0]);
    assert_eq!(one(&[("l_t", Value::Real(60.0)), ("d_h", Value::Real(30.0))]), [0, 1, 0]);
    // The same corner radius says nothing else.
    assert_eq!(one(&[("r_c", Value::Real(0.5)), ("r_cf", Value::Real(0.5))]), [1, 1, 0]);
    assert_eq!(one(&[("r_cf", Value::Real(0.5))]), [1, 1, 1]);
}

#[test]
fn the_largest_tool_for_a_rest_is_told_when_it_is_asked_for() {
    assert!(told(&outcome(&[]), "left in the corner of face and floor").is_none());
    let asked = outcome(&[("h_r", Value::Real(0.6))]);
    let what = told(&asked, "left in the corner of face and floor").unwrap();
    let d: f64 = what.split("end mill is ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
    assert!((2.0..6.0).contains(&d), "{what}");
    // With that tool the plan leaves no more: the plan has these passes, and others.
    let with = outcome(&[("d_f", Value::Real(d))]);
    let root = quantity(&with, "root_height").unwrap();
    assert!(root <= 0.62, "{root} {what}");
    // A tool that leaves less is an answer to less.
    let asked = outcome(&[("h_r", Value::Real(0.4)), ("d_f", Value::Real(2.0))]);
    let what = told(&asked, "left in the corner of face and floor").unwrap();
    let d: f64 = what.split("end mill is ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
    assert!((2.0..6.0).contains(&d), "{what}");
}

#[test]
fn the_largest_tool_for_a_rest_does_not_depend_on_the_one_that_is_given() {
    let named = |d_f: f64| {
        let asked = outcome(&[("h_r", Value::Real(0.4)), ("d_f", Value::Real(d_f))]);
        let what = told(&asked, "left in the corner of face and floor").unwrap();
        what.split("end mill is ").nth(1).unwrap().split(' ').next().unwrap().parse::<f64>().unwrap()
    };
    let d = named(6.0);
    assert_eq!(named(2.0), d);
    // One as wide as the roughing tool is tried, too.
    let wide = outcome(&[("h_r", Value::Real(3.0)), ("d_f", Value::Real(2.0))]);
    let what = told(&wide, "left in the corner of face and floor").unwrap();
    assert!(what.contains("end mill is 6 mm"), "{what}");
    // It leaves no more, and one a tenth larger does.
    let left = |d_f: f64| quantity(&outcome(&[("d_f", Value::Real(d_f))]), "root_height").unwrap();
    assert!(left(d) <= 0.4 && left(d + 0.1) > 0.4, "{d} {} {}", left(d), left(d + 0.1));
}

#[test]
fn round_splitters_the_largest_tool_for_a_rest_is_the_last_step_that_leaves_no_more() {
    // At their noses more is left than by the passes along the faces alone, from which the search begins.
    let with = |changes: &[(&'static str, Value)]| outcome(&[&[("splitters", Value::Choice("yes"))], changes].concat());
    let named = |h_r: f64, d_f: f64| {
        let what = with(&[("h_r", Value::Real(h_r)), ("d_f", Value::Real(d_f))]);
        told(&what, "left in the corner of face and floor").unwrap().to_owned()
    };
    for h_r in [0.5, 0.3] {
        let what = named(h_r, 3.0);
        let d: f64 = what.split("end mill is ").nth(1).expect(&what).split(' ').next().unwrap().parse().unwrap();
        assert!((d * 20.0 - (d * 20.0).round()).abs() < 1e-9, "{what}");
        let left = |d_f: f64| quantity(&with(&[("d_f", Value::Real(d_f))]), "root_height").unwrap();
        assert!(left(d) <= h_r && left(d + 0.05) > h_r, "{what}");
        // The tool of the form is not asked.
        assert!(named(h_r, d + 0.01).contains(&format!("end mill is {d} mm")), "{what}");
    }
}

#[test]
fn where_no_tool_leaves_as_little_the_smallest_that_can_be_used_is_told() {
    let with = |changes: &[(&'static str, Value)]| {
        let fine = [("splitters", Value::Choice("yes")), ("c_s", Value::Real(0.025)), ("tol", Value::Real(0.0102))];
        quick(&[&fine, changes].concat())
    };
    let made = outcome(&with(&[("h_r", Value::Real(0.03))]));
    let what = told(&made, "none is found that leaves as little").expect("a note");
    let words: Vec<&str> = what.split("that can be used, ").nth(1).unwrap().split(' ').collect();
    let (d, left): (f64, f64) = (words[0].parse().unwrap(), words[5].parse().unwrap());
    let really = quantity(&outcome(&with(&[("d_f", Value::Real(d))])), "root_height").expect("it can be used");
    assert!(really > 0.03 && really <= left && left < really + 0.011, "{what} {really}");
    assert!(refused(&with(&[("d_f", Value::Real(d - 0.05))])).is_some(), "{what}");
}

#[test]
fn the_largest_tool_for_a_rest_finds_room_round_the_splitters() {
    let splitters = ("splitters", Value::Choice("yes"));
    let asked = outcome(&[splitters.clone(), ("h_r", Value::Real(2.0))]);
    let what = told(&asked, "left in the corner of face and floor").unwrap();
    let d: f64 = what.split("end mill is ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
    let with = |d: f64| refused(&quick(&[splitters.clone(), ("d_f", Value::Real(d))]));
    assert!((4.0..6.0).contains(&d) && with(d).is_none() && with(d + 0.05).is_some(), "{what}");
}

#[test]
fn numbers_of_many_passes_in_one_place_fit_into_the_figure() {
    let outcome = common::outcome("clear", &[("r_c", Value::Real(2.9)), ("s_w", Value::Real(0.0))]);
    let figure = outcome.figures.iter().find(|figure| figure.key == "roughing").expect("a figure");
    let longest = figure.labels.iter().map(|label| label.text.en.chars().count()).max();
    assert!(longest.is_some_and(|longest| longest < 20), "{longest:?}");
    assert!(figure.labels.iter().any(|label| label.text.en.contains('…')), "{:?}", figure.labels);
}

#[test]
fn the_tool_that_is_named_as_the_largest_that_passes_does_and_the_next_is_refused() {
    // One that fits at the stations of a quick look alone; one tool for both jobs; and a deep hub.
    for [R, r, N, e, a_p] in [[40.0, 32.0, 2.0, 5.0, 3.0], [30.0, 20.0, 3.0, 2.0, 4.0], [60.0, 27.0, 9.0, 1.5, 12.7]] {
        let with = |d_t: f64| quick(&cells([R, r, N, e, a_p, d_t, d_t, 0.03], "no"));
        let named = |d_t: f64| {
            let whats = refused(&with(d_t))?;
            let passes = whats.iter().find_map(|what| what.split("the largest that passes is ").nth(1));
            passes.and_then(|rest| rest.split(' ').next()).map(|d| d.parse::<f64>().expect("a number"))
        };
        let d = named(0.7 * r).unwrap_or_else(|| panic!("{R} {:?}", refused(&with(0.7 * r))));
        assert_eq!(named(d), None, "{R} {d} {:?}", refused(&with(d)));
        assert!(named(d + 0.02).is_some(), "{R} {d} {:?}", refused(&with(d + 0.02)));
    }
}

#[test]
fn a_tool_that_passes_without_an_allowance_is_said_to() {
    let one = |s_w: f64| refused(&quick(&[("d_t", Value::Real(6.5)), ("s_w", Value::Real(s_w))]));
    let whats = one(0.3).expect("too wide with an allowance");
    assert!(whats.iter().any(|what| what.ends_with("without an allowance (s_w = 0) it would pass")), "{whats:?}");
    assert_eq!(one(0.0), None);
}

#[test]
fn what_a_rounded_roughing_tool_leaves_at_the_foot_of_the_faces_is_told() {
    let left = |r_c: f64| {
        let outcome = outcome(&[("r_c", Value::Real(r_c)), ("c_s", Value::Real(0.1))]);
        let what = told(&outcome, "the rounded end of the roughing tool leaves")?;
        what.split("leaves up to ").nth(1)?.split(' ').next()?.parse::<f64>().ok()
    };
    // In a right angle, s_w from both sides, √2·(r_c + s_w) − r_c; leaning faces make it more on one side.
    let upright = |r_c: f64| std::f64::consts::SQRT_2 * (r_c + 0.3) - r_c;
    for r_c in [1.5, 3.0] {
        let left = left(r_c).expect("a caution");
        assert!((upright(r_c)..2.0).contains(&left), "{r_c} {left}");
    }
    // Of a small corner the twist of the faces leaves more than the rounding does.
    assert_eq!([0.0, 0.2, 0.5].map(left), [None; 3]);
}

#[test]
fn thick_blades_that_close_the_way_at_the_hub_name_the_thickness_that_leaves_room() {
    let cells = |e: f64| {
        let sizes = [("R", 25.0), ("r", 5.0), ("e", e), ("a_p", 0.5), ("d_t", 1.1), ("d_f", 0.66)];
        let rest = [("L_b", 25.0), ("c_s", 0.3), ("tol", 0.05)];
        let mut cells: Vec<_> = sizes.into_iter().chain(rest).map(|(key, value)| (key, Value::Real(value))).collect();
        cells.extend([("N", Value::Whole(1)), ("partly", Value::Choice("yes"))]);
        cells
    };
    let thick = outcome(&cells(6.4));
    let stop = thick.findings.iter().find(|finding| finding.code() == "V0131").expect("the axis in a blade");
    let thin = stop.remedy.en.split("of about ").nth(1).unwrap().split(' ').next().unwrap();
    let thin: f64 = thin.parse().unwrap();
    assert!((2.0..6.0).contains(&thin), "{}", stop.remedy.en);
    let thinner = outcome(&cells(thin));
    assert_eq!(End::of(&thinner.findings, false), End::Whole, "{:?}", thinner.findings);
}

#[test]
fn no_smaller_tool_is_advised_where_the_straight_ends_of_thick_blades_close_the_way() {
    let sizes = [("r", 15.5), ("e", 7.0), ("a_p", 4.0), ("d_t", 4.0), ("d_f", 4.0), ("c_s", 0.2)];
    let mut cells: Vec<_> = sizes.map(|(key, value)| (key, Value::Real(value))).into();
    cells.push(("N", Value::Whole(1)));
    let made = outcome(&cells);
    let stops: Vec<_> =
        made.findings.iter().filter(|finding| ["V0126", "V0131", "V0136", "V0137"].contains(&finding.code())).collect();
    assert!(stops.iter().any(|stop| stop.code() == "V0131"), "{:?}", made.findings);
    for stop in stops {
        let [es, en] = [&stop.remedy.es, &stop.remedy.en];
        assert!(es.starts_with("use álabes más delgados (") && en.starts_with("use thinner blades ("), "{stop:?}");
        let smaller = en.find("a smaller tool in this program");
        let only_where = en.find("where no axis goes through a face");
        assert!(en.contains("more may do") && smaller.is_none_or(|at| only_where.is_some_and(|before| before < at)));
    }
}

#[test]
fn a_tool_that_does_not_fit_at_the_hub_cuts_as_far_as_it_fits_where_the_form_admits_it() {
    let wide = [("d_t", Value::Real(8.0)), ("partly", Value::Choice("yes"))];
    let two = outcome(&wide);
    assert_eq!(End::of(&two.findings, false), End::Whole, "{:?}", two.findings);
    assert!(
        told(&two, "farther in the finishing tool roughs").is_some() && told(&two, "the tools do not reach").is_none()
    );
    let one = outcome(&[wide[0].clone(), wide[1].clone(), ("d_f", Value::Real(7.5))]);
    assert_eq!(End::of(&one.findings, false), End::Whole, "{:?}", one.findings);
    let what = told(&one, "the tools do not reach").unwrap();
    let share: f64 = what.split("the tools do not reach ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
    assert!((1.0..30.0).contains(&share), "{what}");
}

#[test]
fn a_cut_made_partly_begins_where_its_passes_keep_clear_of_all_blades() {
    // The straight end of the blade after the next reaches into the channel; with two blades, faces pass the axis of the part.
    let designs = [
        (3, [20.0, 10.0, 6.0, 6.0, 2.5, 2.5]),
        (3, [20.0, 9.0, 7.0, 7.0, 2.5, 2.5]),
        (2, [36.0, 22.0, 9.0, 11.0, 4.0, 3.3]),
    ];
    for (N, sizes) in designs {
        let keys = ["R", "r", "e", "a_p", "d_t", "d_f"];
        let mut cells: Vec<_> = keys.into_iter().zip(sizes.map(Value::Real)).collect();
        cells.extend([("N", Value::Whole(N)), ("c_s", Value::Real(0.3)), ("L_b", Value::Real(60.0))]);
        cells.push(("partly", Value::Choice("yes")));
        let outcome = outcome(&cells);
        assert_eq!(End::of(&outcome.findings, false), End::Whole, "{sizes:?} {:?}", outcome.findings);
        let what = told(&outcome, "the tools do not reach").unwrap();
        let number =
            |after: &str| -> f64 { what.split(after).nth(1).unwrap().split(' ').next().unwrap().parse().unwrap() };
        let (from, share) = (number("from the rim to "), number("the tools do not reach "));
        assert!((10.0..60.0).contains(&from) && (5.0..60.0).contains(&share), "{what}");
    }
}

#[test]
fn programs_that_would_be_too_long_end_at_a_limit() {
    let changes = [("tol", Value::Real(0.0045)), ("delta", Value::Real(0.005)), ("c_s", Value::Real(0.0005))];
    let refusal = match kinds::run(&FORM, common::values("clear", &changes), common::source()) {
        Ok(_) => panic!("not refused"),
        Err(refusal) => refusal,
    };
    assert_eq!(refusal.exit, Exit::Limit);
    assert!(refusal.findings.iter().all(|finding| finding.remedy.en.contains("larger tol")), "{refusal:?}");
    // What is wrong, too, is refused.
    let changes = [&changes[..], &[("s_w", Value::Real(3.0))]].concat();
    let refusal = kinds::run(&FORM, common::values("clear", &changes), common::source()).err().unwrap();
    assert_eq!(refusal.exit, Exit::Refused);
}

#[test]
fn each_program_has_a_number_of_its_own_and_the_last_number_is_rejected() {
    for (dialect, opening) in [("fagor-8055", "%0042-FINISH,MX--,"), ("fagor-8070", "%0042-FINISH")] {
        let made = outcome(&[
            ("program", Value::Whole(41)),
            ("dialect", Value::Choice(dialect)),
            ("retract", Value::Line(String::new())),
        ]);
        let (rough, finish) = (common::program(&made, "rough"), common::program(&made, "finish"));
        assert!(rough.contains("PROGRAM 0041 ") && finish.contains("PROGRAM 0042 "), "{}", &finish[..200]);
        assert_eq!(finish.lines().next(), Some(opening));
    }
    assert!(common::program(&outcome(&[("program", Value::Whole(9998))]), "finish").contains("PROGRAM 9999 "));
    let refusal = kinds::run(&FORM, common::values("clear", &[("program", Value::Whole(9999))]), common::source());
    let findings = refusal.err().unwrap().findings;
    assert_eq!(findings.iter().map(|one| one.code()).collect::<Vec<_>>(), ["P1223"]);
    assert!(kinds::run(&FORM, common::values("full", &[("program", Value::Whole(9999))]), common::source()).is_ok());
}

#[test]
fn a_program_too_large_for_the_control_is_shortened_by_the_cells_of_its_method() {
    let remedies = |made: &Outcome| -> Vec<String> {
        let large = made.findings.iter().filter(|finding| finding.code() == "V0005");
        large.map(|finding| finding.remedy.en.to_string()).collect()
    };
    let large = common::outcome("clear", &[("c_s", Value::Real(0.02)), ("delta", Value::Real(0.08))]);
    let told = remedies(&large);
    assert!(
        !told.is_empty() && told.iter().all(|one| one.contains("larger tol") && !one.contains("smaller n")),
        "{told:?}"
    );
    let told = remedies(&common::outcome("full", &[("n", Value::Whole(3500)), ("splitters", Value::Choice("no"))]));
    assert!(!told.is_empty() && told.iter().all(|one| one.contains("smaller n") && !one.contains("tol")), "{told:?}");
}

#[test]
fn a_feed_at_the_end_of_its_format_is_mended_by_the_cells_of_its_method() {
    let fast = [("F", Value::Real(50_000.0)), ("F_f", Value::Real(50_000.0)), ("F_max", Value::Real(200_000.0))];
    let told = |made: &Outcome| {
        made.findings.iter().find(|one| one.code() == "P1027").map(|one| one.remedy.en.to_string()).unwrap()
    };
    assert!(told(&outcome(&fast)).ends_with("a larger tol"));
    let published = [&fast[..], &[("n", Value::Whole(100))]].concat();
    assert!(told(&common::outcome("full", &published)).ends_with("a smaller n"));
}

/// Where a reader looks for the tools: behind the first tool.
#[test]
fn the_method_of_cutting_is_filled_in_next_to_the_tool() {
    let holds = |key: &str| {
        let sections = FORM.sheets[0].sections;
        sections.iter().position(|one| one.parameters.iter().any(|parameter| parameter.key == key)).unwrap()
    };
    assert_eq!((holds("method"), holds("d_f")), (holds("d_t") + 1, holds("d_t") + 1));
}

/// The half round of such a splitter stands farther above its faces than its axis was looked at: the design was rejected.
#[test]
fn a_splitter_whose_nose_stands_far_above_its_faces_is_cut_and_proved() {
    let real = |key, value| (key, Value::Real(value));
    let made = common::outcome(
        "clear",
        &[
            real("R", 60.0),
            real("r", 36.0),
            real("e", 14.0),
            real("a_p", 6.0),
            ("N", Value::Whole(2)),
            real("d_t", 3.0),
            real("H", 150.0),
            real("L_b", 160.0),
            real("X_e", 200.0),
            real("Z_b", 65.0),
        ],
    );
    assert!(made.quantities.iter().any(|one| one.symbol == "v_s"), "{:?}", made.quantities);
    assert!(common::program(&made, "finish").contains("G1 "));
}

/// Sums of increments are off by a hair: a machine whose B begins at 0 was rejected.
#[test]
fn a_limit_that_is_just_reached_is_kept_and_one_a_thousandth_inside_is_not() {
    let refused = |limit: f64| {
        let values = common::values("clear", &[("B_min", Value::Real(limit))]);
        let made = kinds::run(&FORM, values, common::source());
        let findings = made.map_or_else(|refusal| refusal.findings, |outcome| outcome.findings);
        findings.iter().any(|finding| finding.code() == "V0008")
    };
    assert!(!refused(0.0) && refused(0.001));
}

/// What is beyond both ends of an axis is told at once, with the cells of both.
#[test]
fn an_axis_that_leaves_its_travel_at_both_ends_names_both() {
    let travel = [("X_min", Value::Real(-0.5)), ("X_max", Value::Real(0.5))];
    let made = kinds::run(&FORM, common::values("full", &travel), common::source());
    let findings = made.map_or_else(|refusal| refusal.findings, |outcome| outcome.findings);
    let told: Vec<_> = findings.iter().filter(|one| one.code() == "V0008").collect();
    assert!(!told.is_empty());
    for one in told {
        let place = format!("{:?}", one.place);
        assert!(place.contains("X_min") && place.contains("X_max"), "{place}");
        let remedy = &one.remedy.en;
        assert!(remedy.contains("check X_min and X_max,") || remedy.contains("check X_max and X_min,"), "{remedy}");
        assert!(one.what.en.contains("as the limit at that end"), "{}", one.what.en);
    }
}

/// The offset that may bring a length is D_f's, and not the diameter d_f.
#[test]
fn an_offset_that_may_bring_a_length_is_named_by_its_own_cell() {
    let tools = [("T_f", Value::Whole(2)), ("D_f", Value::Whole(2)), ("d_f", Value::Real(5.0))];
    let of_control = [("dialect", Value::Choice("fagor-8070")), ("retract", Value::Line("G0 Z400".to_owned()))];
    let changes: Vec<_> = of_control.into_iter().chain(tools).collect();
    let made = outcome(&changes);
    let told = made.findings.iter().find(|one| one.code() == "P1049").expect("a caution");
    let place = format!("{:?}", told.place);
    assert!(place.contains("\"D_f\"") && !place.contains("\"d_f\""), "{place}");
    assert!(told.what.es.starts_with("en este control D1 y D2 pueden activar"), "{}", told.what.es);
    assert!(told.remedy.es.contains("la longitud de esos correctores"), "{}", told.remedy.es);
}

#[test]
fn a_link_that_turns_c_by_half_a_turn_is_no_jump() {
    // From the rim of one lane to the hub of the next C turns by 180.000° here.
    let cells = [("e", 1.476_558_294_125_187_6), ("a_p", 2.420_496_441_464_736_8), ("kappa", 0.706_141_311_410_926_1)];
    let changes: Vec<_> = cells.into_iter().map(|(key, value)| (key, Value::Real(value))).collect();
    let outcome = common::outcome("clear", &changes);
    assert_eq!(End::of(&outcome.findings, false), End::Whole, "{:?}", outcome.findings);
}

#[test]
fn the_distance_of_a_holder_from_the_blank_is_a_row_and_a_caution_where_it_is_little() {
    let with = |l_t: f64| outcome(&[("l_t", Value::Real(l_t)), ("d_h", Value::Real(40.0))]);
    let row = |made: &Outcome, program: &str| {
        let mut rows = made.checks.iter().filter(|check| check.key() == "holder" && check.program() == program);
        rows.next().and_then(rodete::proof::check::Check::measured)
    };
    let near = |made: &Outcome| made.findings.iter().any(|finding| finding.code() == "V0135");
    let [short, long] = [16.75, 18.0].map(with);
    let [less, more] = [&short, &long].map(|made| row(made, "rough").expect("a row"));
    assert!((0.0..0.5).contains(&less) && near(&short), "{less}");
    // The blank lies below the holder: it is as much farther off as the tool sticks out farther.
    assert!((more - less - 1.25).abs() < 0.01 && !near(&long), "{less} {more}");
    // Nothing is known of the other tool's holder.
    assert_eq!(row(&short, "finish"), None);
    // One that sticks out less than is needed enters the blank.
    let what = refused(&quick(&[("l_t", Value::Real(16.75 - less - 0.05)), ("d_h", Value::Real(40.0))]));
    assert!(what.is_some_and(|what| what.iter().any(|what| what.contains("enters the blank by"))));
}
