//! Values that are valid alone but not together: what is refused, naming which parameters, with which words.

use crate::common;
use crate::common::change::real;

use rodete::cli::rows;
use rodete::finding::rules::ValueNotFinite;
use rodete::finding::{CellPlace, Exit, FAULT, Finding, Grade, Place, Raise};
use rodete::graft::rules::NotPutIn;
use rodete::kind::End;
use rodete::kinds::impeller::design::Design;
use rodete::kinds::impeller::parameters::FORM;
use rodete::kinds::impeller::rules::AbsoluteOnRollover;
use rodete::kinds::{self, KINDS};
use rodete::parameter::Value;
use rodete::table::Entry;

/// The findings of a refused design.
fn refused(case: &str, changes: &[(&'static str, Value)]) -> Vec<Finding> {
    match Design::new(&common::fields(case, changes)) {
        Ok(_) => panic!("accepted: {changes:?}"),
        Err(findings) => findings,
    }
}

/// Exactly one finding, a stop at these parameters with this text.
fn expect(case: &str, changes: &[(&'static str, Value)], keys: &[&'static str], what: &str) {
    let findings = refused(case, changes);
    let texts: Vec<_> = findings.iter().map(|finding| finding.what.en.as_ref()).collect();
    assert_eq!(texts, [what]);
    assert_eq!(findings[0].grade, Grade::Stop);
    assert_eq!(common::parameters(&findings[0].place), keys);
    assert!(!findings[0].remedy.en.is_empty() && !findings[0].remedy.es.is_empty() && !findings[0].what.es.is_empty());
}

#[test]
fn a_torus_that_closes_is_refused() {
    for (r, shown) in [(25.0, "25"), (26.0, "26"), (24.99998, "24.99998"), (25.0 - 1e-9, "24.999999999")] {
        expect(
            "tfg-2021",
            &[real("r", r)],
            &["R", "r"],
            &format!(
                "meridian radius r is {shown} mm; it must be less than R = 25 mm by more than a millionth, or the torus closes"
            ),
        );
    }
}

#[test]
fn a_cut_through_the_hub_is_refused() {
    expect(
        "tfg-2021",
        &[real("a_p", 10.0)],
        &["a_p", "R", "r"],
        "depth of cut a_p is 10 mm; it must be less than R - r = 10 mm",
    );
}

#[test]
fn too_many_blades_are_refused_with_n_max() {
    let findings = refused("tfg-2021", &[("N", Value::Whole(6))]);
    assert_eq!(
        findings[0].what.en,
        "number of blades N is 6; it must not exceed N_max = 5 for e = 2 mm and d_t = 6 mm"
    );
    assert_eq!(
        findings[0].remedy.en,
        "use fewer blades, thinner blades, or a smaller tool; the gap between blades is 6.378 mm, and 8 mm is needed"
    );
    assert!(Design::new(&common::fields("tfg-2021", &[("N", Value::Whole(5))])).is_ok());
}

#[test]
fn too_thick_a_blade_is_refused_with_e_max() {
    let findings = refused("tfg-2021", &[real("e", 12.0), real("d_s", 8.0)]);
    assert_eq!(findings[1].what.en, "blade thickness e is 12 mm; it must not exceed e_max = 4.566 mm for 4 blades");
    assert_eq!(findings[1].remedy.en, "use fewer blades, a thinner blade, or a smaller tool");
    assert_eq!(findings.len(), 2, "and N beyond N_max");
}

#[test]
fn a_tool_wider_than_the_hollow_is_refused() {
    let findings = refused("tfg-2021", &[real("r", 3.0), real("d_t", 6.5), real("C", 0.5), ("N", Value::Whole(2))]);
    assert_eq!(findings[0].what.en, "a tool of 6.5 mm does not fit into the hollow of radius r = 3 mm");
}

#[test]
fn safe_points_inside_the_passes_are_refused() {
    expect(
        "tfg-2021",
        &[real("d_s", 0.1)],
        &["d_s", "d_t", "e"],
        "with d_s = 0.1 mm the safe points are inside the passes",
    );
}

#[test]
fn a_pivot_inside_the_part_is_refused() {
    expect(
        "tfg-2021",
        &[real("R_B", 10.0), real("H", 5.0)],
        &["R_B", "H", "R"],
        "pivot length L = R_B + H is 15 mm: the pivot is inside the part",
    );
}

#[test]
fn limits_the_wrong_way_round_are_refused() {
    expect(
        "tfg-2021",
        &[real("B_min", 100.0), real("B_max", -10.0)],
        &["B_min", "B_max"],
        "the lower limit of B (100) is not below the upper limit (-10)",
    );
}

#[test]
fn full_style_without_feed_or_speed_is_refused() {
    let findings =
        refused("tfg-2021", &[("style", Value::Choice("full")), ("start_codes", Value::Line("M3".to_owned()))]);
    let texts: Vec<_> = findings.iter().map(|finding| finding.what.en.as_ref()).collect();
    assert_eq!(texts, ["F is missing: style = full requires it", "S is missing: style = full requires it"]);
}

#[test]
fn a_feed_beyond_the_machine_is_refused() {
    expect(
        "full",
        &[real("F", 6001.0)],
        &["F", "F_max"],
        "feed F is 6001 mm/min; it must not exceed F_max = 6000 mm/min",
    );
}

#[test]
fn codes_that_the_control_does_not_know_are_refused() {
    let published = ("start_codes", Value::Line("M3 M11 M13".to_owned()));
    let findings = refused("full", &[("dialect", Value::Choice("linuxcnc")), published]);
    let texts: Vec<_> = findings.iter().map(|finding| finding.what.en.as_ref()).collect();
    assert_eq!(texts, ["the dialect linuxcnc does not know M11", "the dialect linuxcnc does not know M13"]);
    let codes = |key, text: &str| [(key, Value::Line(text.to_owned()))];
    expect(
        "full",
        &codes("start_codes", "M3 G0"),
        &["start_codes", "dialect"],
        "start_codes holds G0: only M codes may stand here",
    );
    expect(
        "full",
        &codes("start_codes", "M30"),
        &["start_codes", "dialect"],
        "start_codes holds M30, which ends the program",
    );
    expect(
        "full",
        &codes("end_codes", "M5"),
        &["end_codes"],
        "end_codes does not end with M2 or M30: the program would have no end",
    );
}

#[test]
fn more_blocks_than_any_control_takes_are_refused_before_anything_is_computed() {
    let findings =
        refused("tfg-2021", &[("n", Value::Whole(100_000)), ("N", Value::Whole(15)), real("e", 0.1), real("d_t", 2.0)]);
    assert_eq!(
        findings[0].what.en,
        "the program of the whole impeller would have 6000060 blocks; the limit is 4000000"
    );
}

#[test]
fn a_stock_too_small_for_the_torus_is_refused() {
    expect("full", &[real("L_b", 15.0)], &["L_b", "r"], "the stock is 15 mm long; the torus needs more than r = 15 mm");
    expect(
        "full",
        &[real("X_e", 50.0)],
        &["X_e", "R"],
        "the end position X_e of 50 mm is inside the stock of diameter 50 mm",
    );
    expect("full", &[real("C", 16.0)], &["C", "r"], "step C is 16 mm; it must not exceed r = 15 mm");
}

#[test]
fn an_end_x_left_empty_lies_outside_whatever_stock() {
    for (R, end) in [(25.0, 80.0), (40.0, 110.0), (60.0, 150.0)] {
        let outcome = common::outcome("full", &[real("R", R), real("H", 120.0), ("splitters", Value::Choice("no"))]);
        let derived = outcome.quantities.iter().find(|one| one.symbol == "X_e").unwrap();
        assert!((derived.value - end).abs() < 1e-9, "{R}: {}", derived.value);
        let blank = common::program(&outcome, "blank");
        assert!(blank.contains(&format!("X{end:.3} Z80.000")), "{blank}");
    }
}

#[test]
fn a_splitter_whose_path_crosses_nothing_is_refused() {
    let changes = [("N", Value::Whole(1)), real("e", 0.1), real("d_t", 0.5), real("d_s", 5.0)];
    let refusal = kinds::run(&FORM, common::values("full", &changes), common::source()).unwrap_err();
    assert_eq!(refusal.exit, Exit::Refused);
    assert_eq!(
        refusal.findings[0].what.en,
        "nothing limits the splitter: its path does not cross the neighbouring blade's path"
    );
}

#[test]
fn a_splitter_with_nothing_left_is_refused() {
    for (fade, what) in [
        ("published", "no splitter is left: its path crosses the neighbouring blade's path at the very first point"),
        ("each-side", "no splitter fits: however it fades out, the tool would cut into the neighbouring blade"),
    ] {
        let changes = [("n", Value::Whole(2)), ("N", Value::Whole(5)), ("splitter_fade", Value::Choice(fade))];
        let refusal = kinds::run(&FORM, common::values("full", &changes), common::source()).unwrap_err();
        assert_eq!(refusal.exit, Exit::Refused);
        assert_eq!(refusal.findings[0].what.en, what);
        assert_eq!(
            refusal.findings[0].remedy.en,
            "set splitters = no, or use fewer blades, thinner blades, a smaller tool, or a larger n"
        );
    }
}

#[test]
fn an_axis_beyond_its_travel_stops_the_programs() {
    let mut values = common::values("full", &[real("B_max", 80.0), real("Z_min", -200.0)]);
    let cell = CellPlace { sheet: "DATA".to_owned(), cell: "C24".to_owned() };
    values.cells.insert(FORM.parameter("B_max").unwrap().key(), cell.clone());
    let outcome = kinds::run(&FORM, values, common::source()).unwrap();
    assert!(outcome.stopped() && outcome.programs.is_empty());
    let stops: Vec<_> = outcome.findings.iter().filter(|finding| finding.grade == Grade::Stop).collect();
    // Both axes in blade, splitter and impeller.
    assert_eq!(stops.len(), 6);
    let first =
        stops.iter().find(|stop| stop.what.en.starts_with("axis B") && stop.what.en.contains("One blade")).unwrap();
    assert_eq!(first.what.en, "axis B goes to 90° in \"One blade\", from line 34 on; its limit is 80°");
    assert_eq!(first.place, Place::Cells(vec![cell]));
    let text = common::program(&common::outcome("full", &[]), "blade");
    assert_eq!(text.lines().nth(33), Some("N80 G0 B90.000 C90.000"));
}

fn calibration(x0: f64, z0: f64) -> Vec<(&'static str, Value)> {
    vec![
        real("calibration/H", 60.0),
        real("calibration/d_w", 50.0),
        real("calibration/e_z", 3.0),
        real("calibration/e_x", 4.0),
        real("calibration/d_t", 6.0),
        real("calibration/x0", x0),
        real("calibration/z0", z0),
    ]
}

#[test]
fn a_calibration_without_solution_is_refused() {
    let refusal = kinds::run(&FORM, common::values("full", &calibration(0.1, 0.1)), common::source()).unwrap_err();
    assert_eq!(
        refusal.findings[0].what.en,
        "the calibration has no real solution: the slots cannot come from one machine"
    );
}

#[test]
fn a_calibration_takes_the_root_nearest_the_spindle_height_and_says_so() {
    // Slots cut with R_B = 147.5 and B = 0: D = 206.5, E = 185.5.
    let outcome = common::outcome("full", &calibration(-206.5, -185.5));
    let table = outcome.table("calibration").unwrap();
    assert_eq!(table.rows(), 4);
    let remark = outcome.findings.iter().find(|finding| finding.what.en.starts_with("the calibration gives")).unwrap();
    assert_eq!(
        remark.what.en,
        "the calibration gives R_B = 147.5 mm and B = 0°; the workbook says R_B = 147.5 mm (the nearer one of two solutions)"
    );
    assert_eq!(remark.grade, Grade::Note);
    let off = common::outcome("full", &calibration(-207.0, -185.5));
    assert!(
        off.findings
            .iter()
            .any(|finding| finding.grade == Grade::Caution && finding.what.en.starts_with("the calibration gives"))
    );
}

#[test]
fn annex_style_says_that_it_carries_no_feed() {
    let outcome = common::outcome("tfg-2021", &[]);
    assert!(outcome.findings.iter().any(|finding| {
        finding.grade == Grade::Caution
            && finding.what.en == "style = annex has no feed F and no speed S, like the published programs"
    }));
    assert!(outcome.findings.iter().any(|finding| {
        finding.grade == Grade::Caution
            && finding.what.en.ends_with("run the blade program 4 times and the splitter program 4 times; before the first splitter, turn C by 45°")
    }));
    assert!(
        outcome
            .findings
            .iter()
            .any(|finding| finding.what.en.starts_with("empty limits are not checked: X_min, X_max"))
    );
}

#[test]
fn programs_without_feed_are_refused_where_the_control_needs_one() {
    let known = ("start_codes", Value::Line("M3".to_owned()));
    let found = refused("tfg-2021", &[("dialect", Value::Choice("linuxcnc")), known]);
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0].what.en, "style = annex has no feed F, and the dialect linuxcnc does not move without one");
    assert_eq!(found[0].remedy.en, "choose style = full");
    assert_eq!(common::parameters(&found[0].place), ["style", "dialect"]);
}

#[test]
fn every_program_says_that_it_closes() {
    for case in ["tfg-2021", "full"] {
        let outcome = common::outcome(case, &[]);
        let table = outcome.table("verification").unwrap();
        let texts = |column: &str| table.column(column).unwrap();
        let closed = (0..table.rows())
            .filter(|&row| {
                let is = |column: &str, text: &str| matches!(texts(column).values.get(row), Entry::Text(found) if found.en == text);
                is("Check", "Closure: sum of the increments") && is("Verdict", "Passed")
            })
            .count();
        assert_eq!(closed, 3, "blade, splitter, impeller");
    }
}

#[test]
fn feed_gives_way_where_an_axis_would_be_too_fast() {
    let outcome = common::outcome("full", &[real("F_max", 1000.0)]);
    let note = outcome.findings.iter().find(|finding| finding.what.en.starts_with("rodete reduces the feed")).unwrap();
    assert_eq!(note.grade, Grade::Note);
    for program in &outcome.programs {
        program.for_each_move(&mut |each| {
            if let Some(seconds) = each.path.seconds(each.step) {
                let fastest = each.to.differences(&each.from).iter().fold(0.0_f64, |most, one| most.max(one.abs()));
                assert!(fastest * 60.0 / seconds < 1000.0 * 1.001);
            }
        });
    }
}

/// Every judge's fault, whatever else is found beside it, ends with the code of a fault in rodete.
#[test]
fn a_fault_in_rodete_never_ends_as_a_refused_input() {
    let stop = || AbsoluteOnRollover {}.at(Place::File);
    let fault = || ValueNotFinite {}.at(Place::File);
    let caution = || fault().graded(Grade::Caution);
    let exit = |findings: Vec<Finding>, endless: bool| {
        let mut outcome = common::outcome("full", &[]);
        outcome.findings.extend(findings);
        outcome.end = End::of(&outcome.findings, endless);
        outcome.exit()
    };
    assert_eq!(exit(vec![], false), Exit::Done);
    assert_eq!(exit(vec![caution()], false), Exit::Done);
    assert_eq!(exit(vec![stop(), caution()], false), Exit::Refused);
    assert_eq!(exit(vec![stop()], true), Exit::Limit);
    assert_eq!(exit(vec![fault()], false), Exit::Fault);
    assert_eq!(exit(vec![stop(), fault()], false), Exit::Fault);
    assert_eq!(exit(vec![fault(), stop()], true), Exit::Fault);
}

/// Rows of faults are those of the room of faults, of the proof, and of a workbook that was put together wrongly; their words
/// are written once.
#[test]
fn only_rows_of_faults_and_of_the_proof_say_that_code_is_to_blame() {
    for rule in rows(KINDS) {
        let may = rule.code.starts_with(['X', 'V']) || rule.code == NotPutIn::RULE.code;
        assert!(!rule.fault || may, "{}", rule.code);
        assert!(rule.fault || rule.remedy != FAULT, "{}", rule.code);
        assert!(rule.fault || !(rule.code.starts_with('X') && rule.grade == Grade::Stop), "{}", rule.code);
    }
    assert!(NotPutIn::RULE.fault);
    let words = format!("\"{}\"", FAULT.en);
    let mut found = Vec::new();
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut folders = vec![root.clone()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()) {
            if entry.is_dir() {
                folders.push(entry);
            } else if std::fs::read_to_string(&entry).is_ok_and(|text| text.contains(&words)) {
                found.push(entry.strip_prefix(&root).expect("a path in the folder").to_path_buf());
            }
        }
    }
    assert_eq!(found, [std::path::Path::new("finding/mod.rs")]);
}

#[test]
fn a_greatest_thickness_below_nothing_is_not_named() {
    let findings = refused("tfg-2021", &[("N", Value::Whole(9))]);
    let words: Vec<&str> = findings.iter().map(|finding| finding.what.en.as_ref()).collect();
    assert_eq!(
        words,
        [
            "number of blades N is 9; it must not exceed N_max = 5 for e = 2 mm and d_t = 6 mm",
            "with N = 9 no blade thickness fits (e is 2 mm): the hub gives 5.585 mm per blade, and the tool needs 8 mm",
        ]
    );
    let findings = refused("tfg-2021", &[("N", Value::Whole(1)), real("e", 45.0)]);
    assert_eq!(
        findings[0].what.en,
        "not even one blade fits with e = 45 mm and d_t = 6 mm: it and its gap need 53 mm, and the hub measures 50.265 mm all round"
    );
    // Value and limit are named in it: no number without a name is put behind it.
    assert_eq!((&*findings[0].value, &*findings[0].limit), ("53 mm", "50.265 mm"));
    assert_eq!(findings[1].what.en, "blade thickness e is 45 mm; it must not exceed e_max = 42.265 mm for 1 blade");
}
