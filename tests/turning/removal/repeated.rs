//! The removal repeated with a library of polygons: it agrees over thousands of cuts, and tells what does not.

use rodete::geometry::exact::convex::Convex;
use rodete::geometry::exact::grid::Point;
use rodete::geometry::exact::meeting::Meeting;
use rodete::geometry::exact::region::{Region, Ring};
use rodete::number::trig::sin;
use rodete::removal::turning::second_removal::{AGREE, Repeat};
use rodete::removal::turning::stock::Stock;

use super::lathe::{Run, bar};

const BAR: [[f64; 2]; 4] = [[-100.0, 0.0], [0.0, 0.0], [0.0, 20.0], [-100.0, 20.0]];

fn rectangle(low: [f64; 2], high: [f64; 2]) -> Convex {
    Convex::hull_mm(&[low, [high[0], low[1]], high, [low[0], high[1]]]).unwrap()
}

fn kernel() -> Region {
    Region::new(&[BAR.map(|corner| Point::near(corner).unwrap()).to_vec()])
}

/// Teeth of a saw over the bar, in passes each a little deeper and further along, so that the contour gets thousands of corners
/// and most of them are cut again.
fn teeth(passes: u32) -> Vec<Convex> {
    let mut polygons = Vec::new();
    for pass in 0..passes {
        for tooth in 0..400 {
            let z = -0.25 * f64::from(tooth) - 0.037 * f64::from(pass);
            let r = 19.5 - 0.3 * f64::from(pass) + 0.2 * sin(z);
            polygons.push(Convex::hull_mm(&[[z, r], [z + 0.31, r + 3.0], [z - 0.17, r + 3.1]]).unwrap());
        }
    }
    polygons
}

fn cut(region: &mut Region, polygon: &Convex) {
    let mut meeting = Meeting::default();
    meeting.find(region, polygon);
    region.cut(polygon, &meeting, &[]);
}

#[test]
fn the_library_leaves_the_same_after_thousands_of_cuts_of_a_contour_of_many_corners() {
    let (mut region, repeat) = (kernel(), Repeat::new(&[BAR.to_vec()]));
    for polygon in teeth(20) {
        cut(&mut region, &polygon);
        repeat.cut(&polygon);
    }
    assert!(region.len() > 1_000, "{} edges", region.len());
    let apart = repeat.apart(&region.rings());
    assert!(apart < 1e-9, "{apart}");
}

#[test]
fn a_cut_that_was_left_out_is_told_with_its_area_by_the_contours_length() {
    let (mut region, repeat) = (kernel(), Repeat::new(&[BAR.to_vec()]));
    for (number, polygon) in teeth(20).into_iter().enumerate() {
        // One of the last pass.
        if number != 7_800 {
            cut(&mut region, &polygon);
        }
        repeat.cut(&polygon);
    }
    let apart = repeat.apart(&region.rings());
    assert!(apart > 1e-5, "{apart}");

    let repeat = Repeat::new(&[BAR.to_vec()]);
    repeat.cut(&rectangle([-10.0, 18.0], [1.0, 21.0]));
    // 10 mm by 2 mm, by the bar's 240 mm.
    assert!((repeat.apart(&[BAR.to_vec()]) - 20.0 / 240.0).abs() < 1e-12);
}

#[test]
fn a_tenth_of_a_micrometre_is_more_than_what_agrees() {
    let repeat = Repeat::new(&[BAR.to_vec()]);
    repeat.cut(&rectangle([-60.0, 15.0], [1.0, 21.0]));
    let r = 15.0001;
    let off = repeat.apart(&[vec![[-100.0, 0.0], [0.0, 0.0], [0.0, r], [-60.0, r], [-60.0, 20.0], [-100.0, 20.0]]]);
    assert!(off > AGREE && (off - 1e-4 * 60.0 / 240.0).abs() < 1e-9, "{off}");
}

#[test]
fn of_pieces_the_leftmost_counts_and_holes_are_held() {
    let repeat = Repeat::new(&[BAR.to_vec()]);
    repeat.cut(&rectangle([-60.0, -1.0], [-50.0, 30.0]));
    repeat.cut(&rectangle([-90.0, 5.0], [-80.0, 10.0]));
    let outer = vec![[-100.0, 0.0], [-60.0, 0.0], [-60.0, 20.0], [-100.0, 20.0]];
    let hole = vec![[-90.0, 5.0], [-90.0, 10.0], [-80.0, 10.0], [-80.0, 5.0]];
    let apart = repeat.apart(&[outer, hole]);
    assert!(apart < 1e-12, "{apart}");
}

#[test]
fn of_a_part_that_is_gone_nothing_is_left() {
    let repeat = Repeat::new(&[BAR.to_vec()]);
    repeat.cut(&rectangle([-101.0, -1.0], [1.0, 21.0]));
    let left: [Ring; 0] = [];
    assert!(repeat.apart(&left) < 1e-12);
}

#[test]
fn of_a_part_that_is_gone_to_its_held_end_what_fell_off_before_does_not_count() {
    let left: [Ring; 0] = [];
    let cut = |to: f64, fallen: Vec<Ring>| {
        let repeat = Repeat::new(&[BAR.to_vec()]);
        repeat.cut(&rectangle([-60.0, -1.0], [-50.0, 30.0]));
        repeat.fell(fallen);
        repeat.cut(&rectangle([-101.0, -1.0], [to, 21.0]));
        repeat.apart(&left)
    };
    let piece = vec![[-50.0, 0.0], [0.0, 0.0], [0.0, 20.0], [-50.0, 20.0]];
    assert!(cut(-59.0, vec![piece.clone()]) < 1e-12);
    // What is there still is told, be it held or not.
    assert!(cut(-59.0, Vec::new()) > 1.0 && cut(-99.0, vec![piece]) > 1.0);
}

/// What is held may lose its left end after a piece has fallen off that reaches farther to the left than what is left.
#[test]
fn what_fell_off_is_gone_when_the_held_piece_loses_its_left_end() {
    let piece = vec![[-98.0, 5.0], [0.0, 5.0], [0.0, 20.0], [-98.0, 20.0]];
    let left = vec![[-50.0, 0.0], [0.0, 0.0], [0.0, 4.0], [-50.0, 4.0]];
    let cut = |fallen: Vec<Ring>, left: &Ring| {
        let repeat = Repeat::new(&[BAR.to_vec()]);
        repeat.cut(&rectangle([-98.0, 4.0], [1.0, 5.0]));
        repeat.cut(&rectangle([-100.0, 4.0], [-98.0, 21.0]));
        repeat.fell(fallen);
        repeat.cut(&rectangle([-101.0, -1.0], [-50.0, 4.5]));
        repeat.apart(std::slice::from_ref(left))
    };
    assert!(cut(vec![piece.clone()], &left) < 1e-12);
    assert!(cut(Vec::new(), &left) > 1.0);
    // The piece that reaches farther to the left is the one that is held.
    let held = vec![[-100.0, 0.0], [0.0, 0.0], [0.0, 4.0], [-100.0, 4.0]];
    assert!((cut(vec![held], &piece) - 2.0).abs() < 1e-5);
    // Half a piece does not fall off, nor more than there is.
    let part = vec![[-58.0, 5.0], [0.0, 5.0], [0.0, 20.0], [-58.0, 20.0]];
    let more = vec![[-98.0, 4.9], [0.0, 4.9], [0.0, 20.0], [-98.0, 20.0]];
    assert!(cut(vec![part], &left) > 1.0 && cut(vec![more], &left) > 0.01);
}

/// A nose that just touches a bore leaves a ring that hangs in a line without thickness: it may be said to be held or not.
#[test]
fn a_nose_that_touches_a_bore_is_no_fault() {
    for x in [40.001, 40.0, 39.999] {
        let mut run = Run::new(Stock { bore: 40.0, ..bar() }).tool(2);
        run.simulation.repeat();
        let mut run = run.rapid(64.0, -5.0).cut(x, -5.0).rapid(64.0, -5.0);
        let apart = run.simulation.repeated().expect("it repeats");
        assert!(apart <= AGREE, "X{x}: {apart}");
    }
}

/// A nose that faces down to X0 touches the axis with one corner. What lies before it hangs by no thickness: it is gone, for both
/// libraries, wherever the tool goes from there.
#[test]
fn facing_to_the_axis_leaves_nothing_before_the_nose() {
    for (x, z) in [(0.0, -1.0), (54.0, -1.0), (60.0, 2.0), (0.0, 2.0)] {
        let mut run = Run::new(bar());
        run.simulation.repeat();
        let nose = run.simulation.setup().turret.tools[&1].nose();
        let mut run = run.rapid(54.0, -1.0).cut(0.0, -1.0).rapid(x, z);
        assert!(nose > 0.1 && !run.alarms().contains(&101), "{:?}", run.alarms());
        let apart = run.simulation.repeated().expect("it repeats");
        assert!(apart <= AGREE, "X{x} Z{z}: {apart}");
        let contours = run.simulation.contours();
        let right = contours.iter().flatten().map(|[z, _]| *z).fold(f64::NEG_INFINITY, f64::max);
        assert!((right - (nose - 1.0)).abs() < 1e-3, "X{x} Z{z}: {right} {nose}");
    }
}
