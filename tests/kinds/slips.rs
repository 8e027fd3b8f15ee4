//! Each slip of the printed source: its form fails against the published figures, ours holds. The list with the
//! explanation is the documentation of `rodete::kinds::impeller::slips`.

use crate::common;

use std::f64::consts::{PI, TAU};

use nalgebra::Vector3;
use rodete::kinds::impeller::blade::Blade;
use rodete::kinds::impeller::design::Design;
use rodete::kinds::impeller::splitter::Splitter;
use rodete::machine::calibration::{Slots, nearest};
use rodete::machine::rotary::TiltingTable;
use rodete::number::trig::{acos, atan, sin_cos};

fn published() -> (Design, Blade) {
    let design = Design::new(&common::fields("tfg-2021", &[])).unwrap();
    let blade = common::blade(&design);
    (design, blade)
}

/// Printed figures of an annex.
fn golden(name: &str) -> Vec<Vec<f64>> {
    let text = std::fs::read_to_string(format!("tests/golden/{name}.csv")).unwrap();
    text.lines().skip(1).map(|line| line.split(',').map(|number| number.parse().unwrap()).collect()).collect()
}

/// The greatest difference between computed points and printed ones.
fn miss(points: impl Iterator<Item = Vector3<f64>>, printed: &[Vec<f64>]) -> f64 {
    points
        .zip(printed)
        .map(|(point, row)| (0..3).map(|axis| (point[axis] - row[axis]).abs()).fold(0.0, f64::max))
        .fold(0.0, f64::max)
}

#[test]
fn equation_5_sign_of_the_plane() {
    let (_, blade) = published();
    let (sin, cos) = sin_cos(blade.circle.alpha());
    let distance = |sign: f64| blade.P.iter().map(|P| (cos * P.z + sign * sin * P.x).abs()).fold(0.0, f64::max);
    assert!(distance(1.0) > 10.0);
    assert!(distance(-1.0) < 1e-12);
}

#[test]
fn equation_6_arccosine_beyond_pi() {
    let (_, blade) = published();
    let printed = |v: f64| acos(blade.circle.k * sin_cos(v).0 / blade.circle.torus.rho(v));
    let rows = golden("annex-01-v-u");
    let wrong = rows.iter().filter(|row| (printed(row[0]) - row[1]).abs() > 1e-6).count();
    let beyond = rows.iter().filter(|row| row[1] > PI).count();
    assert!(wrong >= beyond - 1 && beyond > 10, "the arccosine fails on the {beyond} points beyond π");
    for (row, (&v, &u)) in rows.iter().zip(blade.v.iter().zip(blade.u.iter())) {
        let corrected = if u > PI { TAU - printed(v) } else { printed(v) };
        assert!((corrected - row[1]).abs() < 1e-6 && (u - row[1]).abs() < 1e-8);
    }
}

#[test]
fn equation_7_arctangent_of_c() {
    let (_, blade) = published();
    let rows = golden("annex-04-angles");
    let printed = |N: &Vector3<f64>| atan(N.x / N.y);
    // Not even a whole number of turns saves it.
    let off = |value: f64, row: &[f64]| {
        let difference = (value - row[0]).rem_euclid(TAU);
        difference.min(TAU - difference)
    };
    assert!(blade.N.iter().zip(&rows).filter(|(N, row)| off(printed(N), row) > 0.1).count() > 30);
    assert!(blade.C.iter().zip(&rows).all(|(C, row)| (C - row[0]).abs() < 5e-8));
}

#[test]
fn equations_8_to_12_sense_of_c() {
    let (_, blade) = published();
    let normal = |i: usize, sense: f64| TiltingTable::direction_to_machine(&blade.N[i], blade.B[i], sense * blade.C[i]);
    let up = Vector3::new(0.0, 0.0, 1.0);
    assert!((0..blade.points()).all(|i| (normal(i, 1.0) - up).norm() < 1e-12));
    // `direction_to_machine` applies −C; the printed +C does not bring the normal under the tool.
    assert!((0..blade.points()).any(|i| (normal(i, -1.0) - up).norm() > 0.5));
}

#[test]
fn equation_14_arctangent_of_b() {
    let (_, blade) = published();
    let rows = golden("annex-04-angles");
    let turned = |i: usize| TiltingTable::direction_to_machine(&blade.N[i], 0.0, blade.C[i]);
    let printed = |i: usize| atan(turned(i).z / turned(i).x);
    assert!((0..blade.points()).filter(|&i| (printed(i) - rows[i][1]).abs() > 0.05).count() > 30);
    for (i, row) in rows.iter().enumerate() {
        let N = turned(i);
        assert!((rodete::number::trig::atan2(N.x, N.z) - row[1]).abs() < 1e-8);
    }
}

#[test]
fn equation_16_pivot_length() {
    let (design, blade) = published();
    let printed = golden("annex-06-obverse");
    let path = |L: f64| {
        let shift = blade.b_machine * design.w() - Vector3::new(0.0, 0.0, design.a_p);
        let blade = &blade;
        (0..blade.points()).map(move |i| TiltingTable { L }.to_machine(&blade.P[i], blade.B[i], blade.C[i]) + shift)
    };
    assert!(miss(path(0.0), &printed) > 200.0);
    assert!(miss(path(242.9), &printed) < 5.1e-6);
}

#[test]
fn annex_5_has_its_own_pivot_length() {
    let (_, blade) = published();
    let printed = golden("annex-05-transformed");
    let with = |L: f64| {
        let blade = &blade;
        miss((0..blade.points()).map(|i| TiltingTable { L }.to_machine(&blade.P[i], blade.B[i], blade.C[i])), &printed)
    };
    assert!(with(233.95) < 5.1e-6);
    assert!(with(242.9) > 5.0 && with(147.5) > 50.0);
}

#[test]
fn equations_20_and_21_sides() {
    let (design, blade) = published();
    for (name, sign) in [("annex-06-obverse", 1.0), ("annex-07-reverse", -1.0)] {
        let printed = golden(name);
        let path = |sign: f64| rodete::kinds::impeller::tool_path::tool_path(&blade, sign * design.w(), design.a_p);
        assert!(miss(path(sign).iter().copied(), &printed) < 5.1e-6);
        assert!(miss(path(-sign).iter().copied(), &printed) > 4.0);
    }
}

#[test]
fn equations_23_and_28_tangent() {
    let (obverse, reverse) = (golden("annex-06-obverse"), golden("annex-07-reverse"));
    let ratio = (reverse[0][1] - obverse[0][1]) / (obverse[0][0] - reverse[0][0]);
    assert!((ratio.to_degrees() - 36.869_897_6).abs() > 6.0);
    assert!((atan(ratio).to_degrees() - 36.869_897_6).abs() < 5e-8);
}

#[test]
fn equations_24_to_27_sign_at_the_entry() {
    let (design, _) = published();
    let outcome = common::outcome("tfg-2021", &[]);
    let table = outcome.table("annex-8").unwrap();
    let x = |row: usize| match table.column("x").unwrap().values.get(row) {
        rodete::table::Entry::Number(x) => x,
        rodete::table::Entry::Text(_) => panic!("a number"),
    };
    // The part lies towards +x of the mean line's first point: the printed sign leads into it.
    let start = -design.machine.L;
    let printed = golden("annex-06-obverse")[0][0] + 11.2;
    assert!(printed > start);
    assert!(x(0) < start - design.d_t / 2.0 && x(1) < start - design.d_t / 2.0);
}

#[test]
fn equation_39_sum_of_a_and_b() {
    // Slots as a machine with known R_B and B would have cut them.
    for (k, R_B) in [(0, 120.0), (1, 147.5), (2, 163.2), (3, 180.0)] {
        let B = f64::from(k) * 0.006 - 0.008;
        let mut slots = Slots { H: 60.0, d_w: 50.0, e_z: 3.0, e_x: 4.0, d_t: 6.0, x0: 0.0, z0: 0.0 };
        let (D, E) = (R_B + slots.a(), R_B + slots.b());
        let (sin, cos) = sin_cos(B);
        (slots.x0, slots.z0) = (-(D * cos - E * sin), -(D * sin + E * cos));
        let exact = nearest(slots.exact().unwrap(), R_B);
        assert!((exact.R_B - R_B).abs() < 1e-9 && (exact.B - B).abs() < 1e-12);
        let small = nearest(slots.small_angle().unwrap(), R_B);
        assert!((small.R_B - R_B).abs() < 0.05, "{}", small.R_B - R_B);
        let (a, b) = (slots.a(), slots.b());
        let linear = 2.0 * (b - a) + slots.x0 + slots.z0;
        let constant = a * a + b * b + a * slots.x0 + b * slots.z0;
        let printed = rodete::number::root::quadratic(2.0, linear, constant);
        let off = printed
            .map_or(f64::INFINITY, |roots| roots.iter().map(|root| (root - R_B).abs()).fold(f64::INFINITY, f64::min));
        assert!(off > 30.0, "{off}");
    }
}

#[test]
fn table_of_4_1_start_of_the_profile() {
    let (design, _) = published();
    let printed = std::fs::read_to_string("tests/golden/lathe-g85-as-printed.nc").unwrap();
    let cycle = printed.lines().find(|line| line.contains("G85")).unwrap();
    assert!(cycle.contains("Z-15 ") && !cycle.contains("Z-25 "));
    assert_eq!((design.torus.R, design.torus.r), (25.0, 15.0));
    assert!(common::program(&common::outcome("tfg-2021", &[]), "blank").contains(cycle));
}

#[test]
fn section_4_3_fifth_power() {
    let (design, blade) = published();
    let splitter = Splitter::new(&design, &blade).unwrap();
    // Increments of Y on path 1, from annex 10: N30 … N220.
    let printed: Vec<f64> = std::fs::read_to_string("tests/golden/annex-10-splitter-as-printed.nc")
        .unwrap()
        .lines()
        .skip(2)
        .take(20)
        .map(|line| line.split(" Y").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap())
        .collect();
    let m = f64::from(u32::try_from(splitter.out.m).unwrap());
    let across = design.w() * blade.b_machine.y.abs();
    let worst = |power: f64| {
        (0..20_u32)
            .map(|j| {
                let f = |j: u32| rodete::number::trig::pow((f64::from(j) + 1.0) / (m + 1.0), power);
                (across * (f(j + 1) - f(j)) - printed[j as usize]).abs()
            })
            .fold(0.0, f64::max)
    };
    assert!(worst(1.0) > 0.1);
    assert!(worst(5.0) < 0.000_51);
}

/// The sums of a program's increments: X, Y, Z, B, C.
fn net(name: &str) -> [f64; 5] {
    let text = std::fs::read_to_string(format!("tests/golden/{name}.nc")).unwrap();
    let mut net = [0.0; 5];
    for word in text.lines().filter(|line| line.contains("G1 X")).flat_map(str::split_whitespace) {
        if let Some(axis) = "XYZBC".find(&word[..1]) {
            net[axis] += word[1..].parse::<f64>().unwrap();
        }
    }
    net
}

/// What a program of ours leaves of X, Y, Z, B and C, summed over its text.
fn left(program: &rodete::gcode::program::Program) -> [f64; 5] {
    use rodete::machine::axis::Axis;
    let motions: Vec<_> = program.read_back().map(Result::unwrap).collect();
    let net = motions.last().unwrap().to.differences(&motions.first().unwrap().from);
    [Axis::X, Axis::Y, Axis::Z, Axis::B, Axis::C].map(|axis| (net[axis as usize] * 1000.0).round() / 1000.0 + 0.0)
}

fn close(value: [f64; 5], expected: [f64; 5]) -> bool {
    value.iter().zip(expected).all(|(one, other)| (one - other).abs() < 1e-9)
}

#[test]
fn annex_9_reverse_path_leaves() {
    let net = net("annex-09-blade-as-printed");
    assert!(close(net, [535.796, 0.0, 435.797, -180.0, 253.742]), "{net:?}");
    // With the closing C90: 343.742°.
    let ours = common::outcome("tfg-2021", &[]);
    let blade = ours.programs.iter().find(|program| program.key == "blade").unwrap();
    assert_eq!(left(blade), [0.0, 0.0, 0.0, 0.0, 90.0]);
}

#[test]
fn annex_9_has_two_rounding_rules() {
    let text = std::fs::read_to_string("tests/golden/annex-09-blade-as-printed.nc").unwrap();
    let lines: Vec<&str> = text.lines().collect();
    let words = |line: &str| line.split_once(' ').unwrap().1.to_owned();
    // The same increments on both sides: the mean line's. Printed, they differ in many blocks.
    let differ = (0..40).filter(|k| words(lines[2 + k]) != words(lines[45 + k])).count();
    assert!(differ >= 10, "{differ}");
    let ours = common::program(&common::outcome("tfg-2021", &[]), "blade");
    let sum: i64 = ours
        .lines()
        .flat_map(str::split_whitespace)
        .filter_map(|word| word.strip_prefix('X'))
        .map(|number| i64::from(rodete::number::grid::Milli::round(number.parse().unwrap()).unwrap().thousandths()))
        .sum();
    assert_eq!(sum, 0);
}

#[test]
fn annex_10_shifts_the_part() {
    let printed = net("annex-10-splitter-as-printed");
    assert!((printed[1] - 3.998).abs() < 1e-9, "{printed:?}");
    let ours = common::outcome("tfg-2021", &[]);
    let splitter = ours.programs.iter().find(|program| program.key == "splitter").unwrap();
    assert_eq!(left(splitter)[1], 0.0);
}
