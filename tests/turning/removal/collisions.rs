//! Each of cutter, holder and turret against each of chuck, jaws and tailstock: how deep and where, and what stays clear.
//!
//! W1 is on the bar's face, D 50, 100 mm out of the jaws: their front stands at Z−100, at radii from 25 up; the body of
//! the chuck stands there where there are no jaws. The tailstock's centre begins at Z−3, its quill of radius 30 goes from
//! Z48.96 to Z197.
//!
//! The tool is programmed at the middle of its front edge: 1.5 mm of it on either side, 26 mm deep, its corners rounded by
//! 0.2; the shank of 25 mm about the same middle above it; the turret from 65 mm above the edge, and from 30 mm to its left.

use super::lathe::{Run, bar};
use rodete::finding::Grade;
use rodete::removal::turning::machine::{Chuck, Lathe};
use rodete::removal::turning::simulation::Setup;
use rodete::removal::turning::stock::{Stock, Support};
use rodete::removal::turning::tool::{Cutter, Hand, Holder, Tip, TurningTool};
use rodete::removal::turning::turret::Turret;
use rodete::text::Text;

#[derive(Clone, Copy)]
enum Stands {
    /// A chuck without jaws, of a radius.
    Chuck(f64),
    /// Jaws up to a radius, on a chuck that is out of reach.
    Jaws(f64),
    Tailstock,
}

fn setup(stands: Stands) -> Setup {
    let tool = TurningTool {
        name: Text::same("T1"),
        cutter: Cutter::Groover { width: 3.0, depth: 26.0, corner: 0.2, face: false },
        hand: Hand::Neutral,
        tip: Tip::Outside,
        holder: Holder::Shank { width: 25.0, length: 60.0 },
        turns: None,
        overhang: [60.0, 0.0],
    };
    let turret = Turret { tools: [(1, tool)].into(), body: Some([[-30.0, 5.0], [100.0, 200.0]]) };
    let chuck = |diameter: f64, jaws: f64, top: f64| Chuck { body: 100.0, jaws, diameter, jaw_height: top - 25.0 };
    let (chuck, support) = match stands {
        Stands::Chuck(radius) => (chuck(2.0 * radius, 0.0, 25.0), Support::Never),
        Stands::Jaws(top) => (chuck(60.0, 40.0, top), Support::Never),
        Stands::Tailstock => (chuck(60.0, 40.0, 30.0), Support::Always),
    };
    Setup::new(Lathe { chuck, ..Lathe::default() }, Stock { support, ..bar() }, turret)
}

/// A motion along Z or along X (a radius) at the other's place, from where nothing is hit to where it just touches.
#[derive(Clone, Copy)]
enum Approach {
    /// At a radius, to a Z.
    Left(f64, f64),
    /// At a Z, to a radius.
    Inwards(f64, f64),
}

fn run(stands: Stands, way: Approach, beyond: f64, feed: bool) -> Run {
    let run = Run::on(setup(stands));
    let (before, [x, z]) = match way {
        Approach::Left(r, z) => (run.rapid(2.0 * r, 50.0), [2.0 * r, z - beyond]),
        Approach::Inwards(z, r) => (run.rapid(200.0, z), [2.0 * (r - beyond), z]),
    };
    before.silent();
    if feed { before.cut(x, z) } else { before.rapid(x, z) }
}

#[test]
fn every_pair_of_what_moves_and_what_stands_is_told_from_its_neighbour() {
    let edges = [
        // The left of the cutter, at its corner's rounding 0.2 above the edge, comes to Z−100 with the tool at Z−98.5.
        (111, Stands::Chuck(35.0), Approach::Left(30.0, -98.5), [60.4, -101.0]),
        (112, Stands::Jaws(35.0), Approach::Left(30.0, -98.5), [60.4, -101.0]),
        // Onto the quill, with the flat of the edge between the roundings.
        (113, Stands::Tailstock, Approach::Inwards(100.0, 30.0), [58.0, 100.0]),
        // The shank stands out 12.5 to the left; over 30 it begins at 56, and what it hits ends at 60.
        (114, Stands::Chuck(60.0), Approach::Left(30.0, -87.5), [116.0, -101.0]),
        (115, Stands::Jaws(60.0), Approach::Left(30.0, -87.5), [116.0, -101.0]),
        // With the cutter beyond the quill's end at 197, the shank over it from 187.5.
        (116, Stands::Tailstock, Approach::Inwards(200.0, 4.0), [58.0, 192.25]),
        // The turret stands out 30, and over 40 it begins at 105, where chuck and jaws go on to 125.
        (117, Stands::Chuck(125.0), Approach::Left(40.0, -70.0), [230.0, -101.0]),
        (118, Stands::Jaws(125.0), Approach::Left(40.0, -70.0), [230.0, -101.0]),
        // Cutter and shank beyond the quill's end, and below the axis; the turret over it from 185.
        (119, Stands::Tailstock, Approach::Inwards(215.0, -35.0), [58.0, 191.0]),
    ];
    for (number, stands, way, place) in edges {
        for feed in [false, true] {
            let alarm = run(stands, way, 1.0, feed).only(number);
            assert!((alarm.depth.unwrap() - 1.0).abs() < 1e-6, "{alarm:?}");
            assert!((0..2).all(|axis| (alarm.place[axis] - place[axis]).abs() < 1e-5), "{alarm:?}");
            assert_eq!(alarm.cause.grade(), Grade::Stop);
            // 0.01 mm clear of it, in contact, and just within what counts as contact.
            run(stands, way, -0.01, feed).silent();
            run(stands, way, 0.0, feed).silent();
            run(stands, way, 0.0009, feed).silent();
            let alarm = run(stands, way, 0.0011, feed).only(number);
            assert!((alarm.depth.unwrap() - 0.0011).abs() < 1e-6, "{alarm:?}");
        }
    }
}

#[test]
fn an_arc_hits_the_jaws_where_it_bulges() {
    // About (r 40, Z−88.5) with 10 mm: the left of the cutter bulges to Z−100 − 1.5 at r 40; about Z−87.49 it stays clear.
    let arc = |z: f64| {
        let run = Run::on(setup(Stands::Jaws(45.0))).rapid(60.0, 50.0).rapid(60.0, z);
        run.silent();
        run.arc(100.0, z, [80.0, z], -180.0)
    };
    let alarm = arc(-89.5).only(112);
    assert!((alarm.depth.unwrap() - 1.0).abs() < 2e-4, "{alarm:?}");
    assert!((alarm.place[0] - 80.4).abs() < 0.5 && (alarm.place[1] + 101.0).abs() < 2e-4, "{alarm:?}");
    arc(-88.49).silent();
}

#[test]
fn a_jaw_comes_round_below_the_axis() {
    // Below the axis the jaws stand at radii from −35 to −25: the edge of a tool at X−52 is 1 mm in them.
    let run = |x: f64| Run::on(setup(Stands::Jaws(35.0))).rapid(x, 50.0).rapid(x, -120.0);
    let collisions = run(-52.0).raised().into_iter().filter(|alarm| alarm.cause.number() == 112);
    let depths: Vec<_> = collisions.map(|alarm| alarm.depth.unwrap()).collect();
    assert!(depths.len() == 1 && (depths[0] - 1.0).abs() < 1e-6, "{depths:?}");
    assert!(!run(-49.98).alarms().contains(&112));
}
