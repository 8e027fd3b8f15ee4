//! G71, G72 and G70 against LinuxCNC's own G71, G72 and G70 of the same figure.
//!
//! What both mean alike: the levels, one depth of cut after another; where a pass of a level ends on the contour; the finished
//! contour. What differs, and is taken out or bounded here:
//! - LinuxCNC cuts a first pass at the level of its start, Fanuc one depth of cut below C.
//! - Its passes begin on the straight way from the start to the first point of the contour, Fanuc's at the level of C.
//! - It leaves every pass at 45 degrees by R, as Fanuc's type I, and returns R short of where it began; Fanuc's type II follows
//!   the contour after each pass.
//! - D keeps a distance square to the contour, U and W shift the contour. With D the start stays, with U and W it moves by them:
//!   where levels are compared, Fanuc's start lies by U/2 lower.

use std::collections::BTreeMap;

use super::common::rs274;
use super::lines::refusal;
use super::linuxcnc::{
    Arc, Block, Figure, Line, NEAR, Rounded, TracedMotion, assert_same, fanuc, linuxcnc, near, ours, theirs,
};

/// The pawn: pockets, a rounded corner, arcs of both hands.
const PAWN: Figure = (
    [0.202, 3.041],
    &[
        Arc(true, [1.081, 0.919], [3.0, 0.0]),
        Line([3.0, -1.0]),
        Line([3.0, -4.0]),
        Line([2.268, -5.268]),
        Arc(true, [2.0, -6.268], [1.732_05, -1.0]),
        Line([2.0, -6.732]),
        Arc(true, [4.0, -8.732], [2.0, 0.0]),
        Line([4.5, -8.732]),
        Arc(false, [6.285, -12.982], [0.0, -2.5]),
        Arc(true, [6.285, -19.982], [3.570_71, -3.5]),
        Rounded([10.0, -19.982], 0.2),
        Line([8.5, -22.58]),
        Line([10.0, -25.178]),
        Line([10.0, -27.178]),
        Arc(true, [11.014, -35.1], [5.707_35, -3.295_14]),
        Line([12.0, -36.1]),
        Line([12.0, -38.1]),
        Line([15.0, -38.1]),
    ],
);

/// A Fanuc cycle over a figure from `[X, Z]`, X a radius.
fn cycle(code: u8, start: [f64; 2], depth: f64, allowance: [f64; 2], figure: Figure) -> String {
    let [u, w] = allowance;
    let way = if code == 71 { "U" } else { "W" };
    format!(
        "S500 M3 G98 F400.\nG0 X{:.6} Z{:.6}\nG{code} {way}{depth:.4} R.3\nG{code} P10 Q20 U{:.4} W{w:.4}\n{}",
        2.0 * start[0],
        start[1],
        2.0 * u,
        fanuc(figure)
    )
}

/// The same of LinuxCNC's: from `[X, Z]`, with the words behind Q, X and Z.
fn their_cycle(code: &str, [x, z]: [f64; 2], words: &str, figure: Figure) -> String {
    format!("G54 G18 G21 G8 F400\nO100 SUB\n{}O100 ENDSUB\n{code} Q100 X{x} Z{z} {words}\nM2\n", linuxcnc(figure))
}

/// The ways at feed parallel to an axis (0: X, 1: Z), by their level in micrometres, joined where they meet.
fn passes(cuts: &[TracedMotion], along: usize) -> BTreeMap<i64, Vec<[f64; 2]>> {
    let mut levels: BTreeMap<i64, Vec<[f64; 2]>> = BTreeMap::new();
    for cut in cuts.iter().filter(|cut| !cut.rapid && cut.arc.is_none()) {
        let (level, other) = (cut.from[1 - along], cut.to[1 - along]);
        let [a, b] = [cut.from[along], cut.to[along]];
        if (level - other).abs() < 1e-6 && (a - b).abs() > NEAR {
            #[expect(clippy::cast_possible_truncation, reason = "micrometres of a small part")]
            levels.entry((level * 1e3).round() as i64).or_default().push([a.min(b), a.max(b)]);
        }
    }
    for ways in levels.values_mut() {
        ways.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut joined: Vec<[f64; 2]> = Vec::new();
        for &way in ways.iter() {
            match joined.last_mut() {
                Some(last) if way[0] < last[1] + NEAR => last[1] = last[1].max(way[1]),
                _ => joined.push(way),
            }
        }
        *ways = joined;
    }
    levels
}

/// The straight pieces of all that is cut at feed.
fn pieces(cuts: &[TracedMotion]) -> Vec<[[f64; 2]; 2]> {
    let points = cuts.iter().filter(|cut| !cut.rapid).map(TracedMotion::points);
    points.flat_map(|points| points.windows(2).map(|pair| [pair[0], pair[1]]).collect::<Vec<_>>()).collect()
}

/// The least X over a Z.
fn height(pieces: &[[[f64; 2]; 2]], z: f64) -> f64 {
    let over = pieces.iter().filter(|[a, b]| (a[1].min(b[1])..a[1].max(b[1])).contains(&z));
    over.map(|[a, b]| a[0] + (b[0] - a[0]) * (z - a[1]) / (b[1] - a[1])).fold(f64::INFINITY, f64::min)
}

/// Levels in micrometres.
fn levels(from: i64, to: i64, by: i64) -> Vec<i64> {
    (0..=(from - to) / by).map(|at| from - at * by).collect()
}

/// What is cut at feed: of G70 the contour from its first point on.
fn fed(cuts: &[TracedMotion]) -> Vec<TracedMotion> {
    cuts.iter().filter(|cut| !cut.rapid).copied().collect()
}

fn close(ours: &[[f64; 2]], theirs: &[[f64; 2]]) -> bool {
    ours.len() == theirs.len() && ours.iter().zip(theirs).all(|(our, their)| near(*our, *their, NEAR))
}

#[test]
fn the_passes_over_the_pawn_and_into_its_pockets_are_theirs() {
    if !rs274::is_here() {
        return;
    }
    let start = [15.0, 3.041];
    let our = passes(&ours(&cycle(71, start, 1.0, [0.0; 2], PAWN)), 1);
    let mut their = passes(&theirs(&their_cycle("G71", start, "D0 I1 R0.3", PAWN)), 1);
    assert!(their.remove(&15_000).is_some(), "the pass at the level of the start is theirs alone");
    assert_eq!(our.keys().rev().copied().collect::<Vec<_>>(), levels(14_000, 1_000, 1_000));
    assert_eq!(our.keys().collect::<Vec<_>>(), their.keys().collect::<Vec<_>>());
    for (level, ways) in &our {
        assert!(close(ways, &their[level]), "{level}: {ways:?} {:?}", their[level]);
    }
    // A pocket stands apart from the way that is open to the right at 9, 6, 5 and 2; at 10, 7 and 3 the way runs over a brim.
    let apart: Vec<i64> = our.iter().filter(|(_, ways)| ways.len() == 2).map(|(level, _)| *level).collect();
    assert_eq!(apart, [2_000, 5_000, 6_000, 9_000]);
}

#[test]
fn the_finished_pawn_is_their_polyline() {
    if !rs274::is_here() {
        return;
    }
    let program = format!("S500 M3 G98 F400.\nG0 X30. Z3.041\nG70 P10 Q20\nM30\n{}", fanuc(PAWN));
    let our = ours(&program);
    let mut their = theirs(&their_cycle("G70", [15.0, 3.041], "E0 D0.5 P2", PAWN));
    // They finish twice, first 0.25 mm off: from their start to the first point each time.
    let second = their.iter().rposition(|cut| cut.rapid && cut.length() > 1.0).unwrap();
    their.drain(..second);
    let back = our.len() - 1;
    assert!(our[back].rapid && our[back].to == [15.0, 3.041], "G70 returns to the start, theirs stays");
    assert_same(&our[1..back], &their, NEAR, "G70");
    assert_eq!(their.len(), 20, "18 blocks, one rounded, and the way to the first point");
}

#[test]
fn roughing_the_pawn_leaves_the_allowance_between_their_contour_and_their_distance() {
    if !rs274::is_here() {
        return;
    }
    let start = [15.0, 3.041];
    let our = pieces(&ours(&cycle(71, start, 1.0, [0.51, 0.0], PAWN)));
    // As in their file: first without the pockets at a distance of 1, then the pockets, and the whole at 0.51.
    let words = "D1 I1 R0.3\nG71.2 Q100 X15 Z3.041 D0.51 I0.5 R0.3";
    let off = pieces(&theirs(&their_cycle("G71.1", start, words, PAWN)));
    let finished = pieces(&theirs(&their_cycle("G70", start, "D0 P1", PAWN)));
    let mut level = 0;
    for step in 0..770 {
        let z = 2.5 - 0.0513 * f64::from(step);
        let left = height(&our, z);
        assert!((left - height(&finished, z) - 0.51).abs() < NEAR, "{z}: U/2 over the contour, not {left}");
        // A distance square to the contour reaches at least as far along X, and no farther than over the contour 0.51 mm beside.
        let theirs = height(&off, z);
        let beside = (-26..=26).map(|at| height(&finished, z + f64::from(at) * 0.02)).fold(0.0, f64::max);
        assert!(theirs > left - NEAR && theirs < beside + 0.51 + NEAR, "{z}: {left} {theirs} {beside}");
        level += usize::from((theirs - left).abs() < NEAR);
    }
    assert!(level > 60, "on cylinders both leave the same: {level}");
}

/// The quarter of `lathe_g7x_quadrants` between Z −12 and 2, from the face to the bore, X as a radius.
const QUARTER: [Block; 5] = [
    Line([14.0, -10.0]),
    Line([10.0, -10.0]),
    Arc(false, [5.0, -5.0], [0.0, 5.0]),
    Line([5.0, 0.0]),
    Line([-1.0, 0.0]),
];
/// The same from the bore to the face.
const BACK: [Block; 5] =
    [Line([-1.0, 0.0]), Line([5.0, 0.0]), Line([5.0, -5.0]), Arc(true, [10.0, -10.0], [5.0, 0.0]), Line([14.0, -10.0])];

/// A figure mirrored at Z 0 where it is asked for, with its last block.
fn mirrored(first: [f64; 2], blocks: &[Block], last: [f64; 2], mirror: bool) -> ([f64; 2], Vec<Block>) {
    let point = |[x, z]: [f64; 2]| if mirror { [x, -z] } else { [x, z] };
    let block = |block: &Block| match *block {
        Line(to) => Line(point(to)),
        Rounded(to, radius) => Rounded(point(to), radius),
        Arc(clockwise, to, centre) => Arc(clockwise != mirror, point(to), point(centre)),
    };
    (point(first), blocks.iter().chain(&[Line(last)]).map(block).collect())
}

#[test]
fn every_quadrant_is_roughed_along_either_axis_as_theirs_is() {
    if !rs274::is_here() {
        return;
    }
    let mut ends = 0;
    for mirror in [false, true] {
        let there = mirrored([14.0, -12.0], &QUARTER, [-1.0, 2.0], mirror);
        let back = mirrored([-1.0, 2.0], &BACK, [14.0, -12.0], mirror);
        let z = |z: f64| if mirror { -z } else { z };
        // The code, the start, the figure, and whether the passes run towards + or −.
        let runs = [
            (71, [-5.0, z(-14.0)], &there, z(1.0)),
            (72, [15.0, z(4.0)], &there, -1.0),
            (72, [-5.0, z(-14.0)], &back, 1.0),
            (71, [15.0, z(4.0)], &back, z(-1.0)),
        ];
        for (code, start, (first, blocks), way) in runs {
            let figure = (*first, blocks.as_slice());
            let along = usize::from(code == 71);
            let our = passes(&ours(&cycle(code, start, 1.0, [0.0; 2], figure)), along);
            let their = passes(&theirs(&their_cycle(&format!("G{code}"), start, "D0 I1 R0.3", figure)), along);
            let micrometres = |value: f64| (value * 1e3).round();
            let only = |one: &BTreeMap<i64, Vec<[f64; 2]>>, other: &BTreeMap<i64, Vec<[f64; 2]>>, but: f64| {
                one.keys().filter(|level| !other.contains_key(level)).all(|&level| level as f64 == micrometres(but))
            };
            assert!(only(&their, &our, start[1 - along]), "G{code} {start:?}\n{our:?}\n{their:?}");
            assert!(only(&our, &their, first[1 - along]), "G{code} {start:?}\n{our:?}\n{their:?}");
            for (level, ways) in our.iter().filter(|(level, _)| their.contains_key(level)) {
                let end = |ways: &[[f64; 2]]| ways.iter().flatten().map(|end| way * end).fold(f64::MIN, f64::max);
                assert!((end(ways) - end(&their[level])).abs() < NEAR, "G{code} {level}: {ways:?} {:?}", their[level]);
                ends += 1;
            }
        }
        let (first, blocks) = &there;
        let figure = (*first, blocks.as_slice());
        let start = [15.0, z(4.0)];
        let our = ours(&format!("S500 M3 G98 F400.\nG0 X30. Z{:.3}\nG70 P10 Q20\nM30\n{}", start[1], fanuc(figure)));
        let their = theirs(&their_cycle("G70", start, "D1 P1", figure));
        assert_same(&fed(&our), &fed(&their), NEAR, "G70");
    }
    // X −4 to 14, Z 3 to −11, Z −13 to 1 and X 14 to −1, on both sides.
    assert_eq!(ends, 2 * (19 + 15 + 15 + 16), "levels that both have");
}

#[test]
fn a_stepped_bore_is_faced_as_theirs_is() {
    if !rs274::is_here() {
        return;
    }
    let points = [[5.0, -7.0], [10.0, -7.0], [15.0, -4.0], [20.0, -4.0], [25.0, -1.0], [30.0, -1.0]];
    let blocks = points.map(Line);
    let figure = ([0.0, -10.0], blocks.as_slice());
    // They start at X1, beyond the contour, and go to X0 themselves; Fanuc's start has to lie there.
    let our = passes(&ours(&cycle(72, [0.0, 1.0], 1.0, [0.0; 2], figure)), 0);
    let mut their = passes(&theirs(&their_cycle("G72", [1.0, 1.0], "D0 I1 R0.3", figure)), 0);
    assert!(their.remove(&1_000).is_some());
    assert_eq!(our.keys().rev().copied().collect::<Vec<_>>(), levels(0, -9_000, 1_000));
    assert_eq!(our.len(), their.len(), "{our:?}\n{their:?}");
    for (level, ways) in &our {
        assert!(close(ways, &their[level]), "{level}: {ways:?} {:?}", their[level]);
    }
    let program = format!("S500 M3 G98 F400.\nG0 X0. Z1.\nG70 P10 Q20\nM30\n{}", fanuc(figure));
    let our = ours(&program);
    let their = theirs(&their_cycle("G70", [1.0, -10.0], "D0 P1", figure));
    assert_same(&fed(&our), &fed(&their), NEAR, "G70");
}

#[test]
fn no_pass_of_a_facing_is_missing() {
    if !rs274::is_here() {
        return;
    }
    // By hand: −3, −6 … −39 from X50 to X100.
    let wanted = levels(-3_000, -39_000, 3_000);
    let faced = |end: f64| {
        let blocks = [Line([100.0, end])];
        let figure = ([50.0, -40.0], blocks.as_slice());
        let our = ours(
            &cycle(72, [50.0, 0.0], 3.0, [0.0; 2], figure)
                .replace("R.3", "R.1")
                .replace("N10 G0 X100.000000", "N10 G0"),
        );
        // Fanuc's type I leaves a pass as they do, at 45 degrees by R.
        let left: Vec<[f64; 2]> =
            our.windows(2).filter(|pair| !pair[0].rapid && pair[1].rapid).map(|pair| pair[1].to).collect();
        // Each pass is left once, and so is the way along the contour behind them.
        assert_eq!(left.len(), passes(&our, 0).len() + 1, "{left:?}");
        for (place, level) in left.iter().zip(&wanted) {
            assert!(near(*place, [99.9, *level as f64 / 1e3 + 0.1], NEAR), "{place:?} {level}");
        }
        let their = theirs(&their_cycle("G72", [50.0, 0.0], "I3 R0.1", figure));
        let leaves = their.windows(2).filter(|pair| !pair[0].rapid && pair[1].length() < 0.2);
        let leaves: Vec<_> = leaves.collect();
        // Theirs as often, where it has them.
        let their_passes = passes(&their, 0).len();
        assert!(their_passes == 1 || leaves.len() >= wanted.len(), "{leaves:?}");
        for pair in leaves {
            assert!(
                pair[0].to[1] == 0.0 || left.iter().any(|place| near(*place, pair[1].to, NEAR)),
                "{pair:?} {left:?}"
            );
        }
        let (our, their) = (passes(&our, 0), passes(&their, 0));
        assert!(our.values().all(|ways| close(ways, &[[50.0, 100.0]])), "{our:?}");
        (our.into_keys().rev().collect::<Vec<_>>(), their.into_keys().rev().collect::<Vec<_>>())
    };
    // The bottom rises by 1 µm: both have the 13 passes, theirs one at the start besides.
    let (our, their) = faced(-39.999);
    assert_eq!(our, wanted);
    assert_eq!(their[1..], wanted);
    // A level bottom: LinuxCNC once lost all passes here; its file has them, and −40 along the contour.
    let (our, their) = faced(-40.0);
    assert_eq!(our[..13], wanted);
    assert_eq!(our[13..], [-40_000]);
    assert!(their.len() == 1 || their[1..] == our, "{their:?}");
}

#[test]
fn the_figure_that_ran_for_ever_ends_with_the_passes_counted_by_hand() {
    // A cylinder of X10 to Z−14, down to X3, and a cone to X7 at Z−22; depth 0.5 from X15.
    let blocks = [Line([10.0, -14.0]), Line([3.0, -14.0]), Line([7.0, -22.0])];
    let figure = ([10.0, 0.0], blocks.as_slice());
    let our = passes(&ours(&cycle(71, [15.0, 0.0], 0.5, [0.0; 2], figure)), 1);
    // 14.5 to 10.5 over all, 10 over all as well (it lies on the cylinder), 9.5 to 3.5 in the pocket; at 3 it is a point.
    assert_eq!(our.keys().rev().copied().collect::<Vec<_>>(), levels(14_500, 3_500, 500));
    let mut pocket = 0;
    for (&level, ways) in &our {
        let x = level as f64 / 1e3;
        let from = if x < 10.0 { -14.0 } else { 0.0 };
        // The cone: 2 mm of Z for each of X.
        let to = if x < 7.0 { -14.0 - 2.0 * (x - 3.0) } else { -22.0 };
        assert!(close(ways, &[[to, from]]), "{x}: {ways:?}");
        pocket += usize::from(x < 10.0);
    }
    assert_eq!((our.len() - pocket, pocket), (10, 13));
    // The ends in their file, at levels 0.04 higher and D 0.04 square to the cone: 2·0.04 further, 0.04·√5 shorter.
    for (level, z) in [(6_500, -20.9906), (5_000, -17.9906), (3_500, -14.9906)] {
        let end = our[&level][0][0] - 2.0 * 0.04 + 0.04 * 5.0_f64.sqrt();
        assert!((end - z).abs() < NEAR, "{level}: {end} {z}");
    }
    // With the allowances in X and Z and C at their start: their levels 14.5 to 10.5, their end −21.96, their bottom 10.04.
    let our = ours(&cycle(71, [14.96, 0.0], 0.5, [0.04, 0.04], figure));
    let all = passes(&our, 1);
    for level in levels(14_500, 10_500, 500) {
        assert!(close(&all[&level], &[[-21.96, 0.04]]), "{level}: {:?}", all[&level]);
    }
    assert!(
        all.contains_key(&10_040) && all.keys().all(|level| *level < 10_040 || *level >= 10_500 || *level == 10_040)
    );
}

#[test]
fn a_contour_beyond_its_start_is_refused_or_is_a_bore_and_ends_from_outside() {
    // A step from X168 to X170 from a start at X168: they run along it. To Fanuc it lies outwards: a recess of a bore, taken
    // out by two passes; an allowance outwards, as of a shaft, is refused.
    let blocks = [Line([168.0, -333.0]), Line([170.0, -333.0]), Line([170.0, -415.0])];
    let figure = ([168.0, 0.0], blocks.as_slice());
    let all = passes(&ours(&cycle(71, [168.0, 0.0], 1.0, [0.0; 2], figure)), 1);
    assert_eq!(all.keys().copied().collect::<Vec<_>>(), [168_000, 169_000, 170_000]);
    assert!(close(&all[&168_000], &[[-333.0, 0.0]]), "the contour: {all:?}");
    assert!(close(&all[&169_000], &[[-415.0, -333.0]]) && close(&all[&170_000], &[[-415.0, -333.0]]), "{all:?}");
    let refused = refusal(&(cycle(71, [168.0, 0.0], 1.0, [0.1, 0.0], figure) + "M30\n"));
    assert!(refused.contains("the finishing allowance points into the metal"), "{refused}");
    // The sign may be right, and the start wrong.
    assert!(refused.contains("check the starting point and the contour's first block"), "{refused}");
    let our = ours(&cycle(71, [170.0, 0.0], 1.0, [0.0; 2], figure));
    let all = passes(&our, 1);
    assert_eq!(all.keys().copied().collect::<Vec<_>>(), [168_000, 169_000, 170_000]);
    assert!(close(&all[&169_000], &[[-333.0, 0.0]]) && close(&all[&168_000], &[[-333.0, 0.0]]), "{all:?}");
    assert!(close(&all[&170_000], &[[-415.0, -333.0]]), "the contour: {all:?}");
    // A diameter of 20, finished at 19.726 with a chamfer of 0.5 and a step to 20.226: beyond the start at 20.
    let x = |diameter: f64| diameter / 2.0;
    let blocks = [
        Line([x(19.726 - 1.000_05), 0.0]),
        Line([x(19.726), -0.5]),
        Line([x(19.726), -5.0]),
        Line([x(20.226), -5.0]),
        Line([x(20.226), -25.0]),
        Line([10.0, -25.0]),
    ];
    let figure = ([x(19.726 - 1.000_05), 1.0], &blocks[..5]);
    let refused = refusal(&(cycle(71, [10.0, 1.0], 2.0, [0.0; 2], figure) + "M30\n"));
    assert!(refused.contains("PS0322"), "{refused}");
    // From X21 with a depth of 2 the first pass is the last: at the face of the chamfer.
    let all = passes(&ours(&cycle(71, [10.5, 1.0], 2.0, [0.0; 2], figure)), 1);
    assert!(close(&all[&9_363], &[[0.0, 1.0]]), "{all:?}");
    // The finished contour is that of their file.
    let program = |figure| format!("S500 M3 G98 F400.\nG0 X20. Z1.\nG70 P10 Q20\nM30\n{}", fanuc(figure));
    let our = ours(&program((figure.0, &blocks)));
    let wanted =
        [[9.363, 1.0], [9.363, 0.0], [9.863, -0.5], [9.863, -5.0], [10.113, -5.0], [10.113, -25.0], [10.0, -25.0]];
    for (cut, wanted) in our[1..].iter().zip(wanted) {
        assert!(near(cut.to, wanted, NEAR), "{cut:?} {wanted:?}");
    }
    assert_eq!(our.len(), wanted.len() + 2, "and back to the start");
}
