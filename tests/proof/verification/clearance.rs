//! The clearance to the faces of other blades is bounded: the published bounds, what the text's own motions make of them,
//! and what becomes of a pass that is not proved clear.

use std::f64::consts::TAU;

use nalgebra::Vector3;
use rodete::finding::Grade;
use rodete::geometry::torus::Torus;
use rodete::kinds::impeller::blade::Blade;
use rodete::kinds::impeller::clearance::{Bounds, CLOSE, Stand, Until, WORK, Walls};
use rodete::kinds::impeller::part::Part;
use rodete::kinds::impeller::proof::flanks::{Clearance, Clearances, checks};
use rodete::kinds::impeller::tool_path::tool_path;
use rodete::kinds::impeller::track::Track;
use rodete::machine::rotary::TiltingTable;
use rodete::parameter::Value;
use rodete::proof::check::At;

use super::{common, published as design, real};

const MACHINE: TiltingTable = TiltingTable { L: 242.9 };

/// The published path of 40 blocks along one side of a blade, d_t = 6, a_p = 2, not rounded.
fn published(e: f64, side: f64) -> Vec<Stand> {
    let blade = Blade::new(Torus { R: 25.0, r: 15.0 }, 40, 1e-5, MACHINE);
    let path = tool_path(&blade, side * (e + 6.0) / 2.0, 2.0);
    let stands = path.iter().zip(blade.B.iter().zip(blade.C.iter()));
    stands.map(|(&at, (&B, &C))| Stand { at, B, C }).collect()
}

fn part(e: f64) -> Part {
    Part::with(Torus { R: 25.0, r: 15.0 }, e, 2.0)
}

/// The part whose rulings all end at a_p + (e/2)²/(2(R − r − a_p)), as that of the published bounds does.
fn level(e: f64) -> Part {
    part(e).ending_at(2.0 + e * e / 4.0 / (2.0 * 8.0))
}

fn beside(part: Part) -> Walls {
    Walls::new(part, MACHINE, 3.0, (1..4).map(|k| TAU * f64::from(k) / 4.0).collect(), f64::MIN)
}

fn neighbours(e: f64) -> Walls {
    beside(part(e))
}

/// A search of 33 × 33 places, zoomed in on 14 times, that shares nothing with this.
const DENSE: [(f64, f64); 2] = [(2.0, 1.404_946_1), (3.7, -0.619_530_2)];

#[test]
fn faces_are_held_against_the_tool_down_to_the_floor_that_is_there() {
    for (e, dense) in DENSE {
        let found = neighbours(e).clearance(&published(e, -1.0), Until::Within(CLOSE), WORK);
        assert!(found.lower <= dense && dense <= found.upper + 1e-7, "{e} {found:?}");
        assert!(found.upper - found.lower <= 1.01 * CLOSE && found.work < 2000, "{found:?}");
        let limited = beside(level(e)).clearance(&published(e, -1.0), Until::Within(CLOSE), WORK);
        assert!(found.upper < limited.lower, "a limit alike for all rulings is too kind on the straight ends");
    }
}

/// The printed bounds were 1e-4 apart before they were rounded to four decimals.
#[test]
fn the_clearance_to_the_next_blade_is_that_of_the_published_bounds() {
    for (e, low, high, block) in [(2.0, 1.4058, "1.4059", 9.0), (3.7, -0.5906, "-0.5905", 8.0)] {
        let [obverse, reverse] =
            [1.0, -1.0].map(|side| beside(level(e)).clearance(&published(e, side), Until::Within(CLOSE), WORK));
        assert!(reverse.upper < obverse.lower);
        let Bounds { lower, upper, place, work } = reverse;
        assert!(low <= lower && lower <= upper && upper - lower <= 1.01 * CLOSE, "{e} {reverse:?}");
        assert_eq!(format!("{upper:.4}"), high, "{e} {reverse:?}");
        assert_eq!(place.unwrap().along.floor(), block);
        // It is counted work: before, 4344 and 3864 times some 260 rulings.
        assert!(work < 2000, "{work}");
        // A dense search along the ruling at the hub plane, which shares nothing with this, gives 1.40593 and -0.59048.
        assert!((upper - if e < 3.0 { 1.40593 } else { -0.59048 }).abs() < 1e-5, "{reverse:?}");
    }
}

#[test]
fn work_that_ends_too_early_leaves_a_bound_that_holds() {
    let way = published(3.7, -1.0);
    let mut before = f64::NEG_INFINITY;
    for budget in [1, 20, 100, 300, 600, 2000] {
        let Bounds { lower, upper, .. } = neighbours(3.7).clearance(&way, Until::Within(CLOSE), budget);
        assert!(before <= lower && lower <= DENSE[1].1 && DENSE[1].1 - 1e-6 <= upper, "{budget}: {lower} {upper}");
        before = lower;
    }
    assert!(before > DENSE[1].1 - 1e-4);
}

#[test]
fn what_is_decided_is_decided_as_the_bounds_say() {
    let way = published(2.0, -1.0);
    for (asked, clear) in [(0.0, true), (1.4, true), (1.4049, true), (1.405, false), (3.0, false)] {
        let found = neighbours(2.0).clearance(&way, Until::Decided(asked), WORK);
        assert_eq!(found.lower >= asked, clear, "{asked}: {found:?}");
        assert!(clear || found.upper < asked, "{asked}: {found:?}");
    }
}

#[test]
fn a_run_of_many_short_blocks_gives_the_same_as_its_few_long_ones() {
    let long = published(3.7, -1.0);
    let short: Vec<Stand> = long
        .windows(2)
        .flat_map(|pair| (0..64).map(|part| pair[0].towards(&pair[1], f64::from(part) / 64.0)))
        .chain(long.last().copied())
        .collect();
    let [few, many] = [&long, &short].map(|way| neighbours(3.7).clearance(way, Until::Within(CLOSE), WORK));
    assert!(few.lower <= many.upper && many.lower <= few.upper && many.work < 2 * few.work, "{few:?} {many:?}");
}

#[test]
fn a_tool_that_stands_still_or_has_nothing_beside_it_is_judged_too() {
    let way = published(2.0, -1.0);
    let walls = neighbours(2.0);
    let one = walls.clearance(&way[9..10], Until::Within(CLOSE), WORK);
    let along = walls.clearance(&way, Until::Within(CLOSE), WORK);
    assert!(one.lower >= along.lower && one.upper < 2.0, "{one:?}");
    // Far above the part nothing is above the plane of the end.
    let up = Stand { at: way[0].at + Vector3::z() * 500.0, ..way[0] };
    let none = walls.clearance(&[up, up], Until::Within(CLOSE), WORK);
    assert_eq!((none.lower, none.place), (f64::INFINITY, None));
    assert_eq!(walls.clearance(&[], Until::Within(CLOSE), WORK).lower, f64::INFINITY);
}

/// Of the rounded words that the program carries, from one safe point to the other: three thousandths of a millimetre
/// off in B, as seen from the pivot, move it by two tenths of a micrometre.
#[test]
fn a_pass_that_poses_told_to_be_clear_is_stopped() {
    let no = ("splitters", Value::Choice("no"));
    let narrow = common::outcome("tfg-2021", &[real("e", 3.7), no.clone()]);
    let stop = narrow.findings.iter().find(|finding| finding.grade == Grade::Stop).unwrap();
    assert!(stop.what.en.starts_with("the tool cuts into the neighbouring blade (at its point -"), "{}", stop.what.en);
    assert!(stop.what.en.contains("by 0.6194 mm across the tool, in line"), "{}", stop.what.en);
    assert!(stop.what.es.contains("0.6194 mm a lo ancho de la herramienta, en la línea"), "{}", stop.what.es);
    assert_eq!(stop.value, "bounded between -0.6194 and -0.6193 mm");
    assert!(narrow.programs.is_empty());
    let wide = common::outcome("tfg-2021", &[no]);
    assert!(wide.findings.iter().all(|finding| finding.grade < Grade::Stop));
    let table = wide.tables.iter().find(|table| table.key == "verification").unwrap();
    let shown = format!("{table:?}");
    assert!(shown.contains("bounded between 1.4051 and 1.4052 mm"), "{shown}");
    assert!(shown.contains("comprendida entre 1.4051 y 1.4052 mm"), "{shown}");
}

#[test]
fn a_pass_whose_clearance_is_not_proved_is_not_passed() {
    let program = &common::outcome("full", &[]).programs[0];
    let at = At::line(7);
    let verdict = |lower: f64, upper: f64| {
        let bounds = Bounds { lower, upper, place: None, work: WORK };
        let blades = Some(Clearance { bounds, other: 3.0, at });
        let known = Clearances { blades, ..Clearances::default() };
        let check = checks(&design(40), program, &[(Track::Obverse, known)]).remove(0);
        (check.grade(), check.finding().map(|finding| finding.what.en.to_string()).unwrap_or_default())
    };
    assert_eq!(verdict(0.0, 0.1).0, None);
    let (undecided, what) = verdict(-1e-5, 1e-5);
    assert_eq!(undecided, Some(Grade::Stop));
    assert!(
        what.starts_with("it is not proved that the tool clears the neighbouring blade (at its point 3)"),
        "{what}"
    );
    assert_eq!(verdict(-0.2, -0.1).0, Some(Grade::Stop));
}
