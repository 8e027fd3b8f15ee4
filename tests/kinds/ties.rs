//! Angles of B that lie exactly between two thousandths of a degree are rounded by whole numbers, and F follows from them.
#![allow(non_snake_case, reason = "symbols as in the source")]

use crate::common;

use common::{outcome, program, read_back};
use nalgebra::Vector3;
use rodete::machine::axis::{Axis, Position};
use rodete::machine::rotary::TiltingTable;
use rodete::parameter::Value;

/// 90 000·(n − i)/n thousandths, halves away from zero, in whole numbers.
fn away_from_zero(n: i64, i: i64) -> i64 {
    let twice = 180_000 * (n - i);
    (twice + n).div_euclid(2 * n)
}

/// The blocks of a program in G93 with inverse times: positions and F words.
fn blocks(n: i64) -> (Vec<Position>, Vec<Option<f64>>) {
    let changes = common::absolute(&[
        ("n", Value::Whole(u32::try_from(n).expect("a count"))),
        ("dialect", Value::Choice("linuxcnc")),
        ("splitters", Value::Choice("no")),
    ]);
    let text = program(&outcome("full", &changes), "blade");
    let moving =
        |line: &&str| !line.starts_with('(') && line.contains([' ']) && line.contains(['X', 'Y', 'Z', 'B', 'C']);
    let F = |line: &str| line.split_whitespace().find_map(|word| word.strip_prefix('F')?.parse().ok());
    let feeds: Vec<Option<f64>> = text.lines().filter(moving).map(F).collect();
    let positions = read_back(&text, Position::default());
    assert_eq!(positions.len(), feeds.len(), "n {n}");
    (positions, feeds)
}

#[test]
fn ties_of_B_are_rounded_by_whole_numbers_and_F_follows_from_them() {
    for (n, ties) in [(32, 16), (96, 48), (160, 80), (800, 400)] {
        let (positions, feeds) = blocks(n);
        // The obverse is the first n + 1 moves at feed, the reverse comes after the way out and across.
        let first = feeds.iter().position(Option::is_some).expect("a move at feed");
        let points = usize::try_from(n).expect("a count") + 1;
        let mut between = 0;
        for (i, at) in (0..=n).zip(&positions[first..first + points]) {
            assert_eq!(i64::from(at.get(Axis::B).thousandths()), away_from_zero(n, i), "n {n}, obverse, point {i}");
            between += usize::from((180_000 * (n - i)) % (2 * n) == n);
        }
        assert_eq!(between, ties, "n {n}");
        let reverse =
            first + points + 1 + feeds[first + points + 1..].iter().position(Option::is_some).expect("a move");
        for (i, at) in (0..=n).rev().zip(&positions[reverse..reverse + points]) {
            assert_eq!(i64::from(at.get(Axis::B).thousandths()), away_from_zero(n, i), "n {n}, reverse, point {i}");
        }

        let machine = TiltingTable { L: 147.5 + 95.4 };
        // The way of the tip over the part while the axes run evenly, by many chords.
        let way = |from: &Position, to: &Position| {
            let tip = |part: f64| {
                let value = |axis| from.get(axis).value() + (to.get(axis).value() - from.get(axis).value()) * part;
                let machine_at = Vector3::new(value(Axis::X), value(Axis::Y), value(Axis::Z));
                machine.to_part(&machine_at, value(Axis::B).to_radians(), value(Axis::C).to_radians())
            };
            (0..64).map(|k| (tip(f64::from(k + 1) / 64.0) - tip(f64::from(k) / 64.0)).norm()).sum::<f64>()
        };
        for k in first..first + points {
            let (from, to) = (&positions[k - 1], &positions[k]);
            let greatest = to.differences(from).iter().fold(0.0_f64, |most, axis| most.max(axis.abs()));
            let seconds = (way(from, to) * 60.0 / 300.0).max(greatest * 60.0 / 6000.0);
            let F = feeds[k].expect("F in every block");
            let wanted = 60.0 / seconds;
            // The bound that F counts is at most three ten-thousandths more, and chords are a little short.
            let least = wanted * (1.0 - 3e-4) - 0.001_001;
            assert!(F <= wanted * (1.0 + 1e-6) + 2e-6 && F > least, "n {n}, move {k}: F{F} for {wanted}");
        }
    }
}

/// X of the safe points half-way between two thousandths was rounded up on one side and down on the other, and the crossing moves Y alone.
#[test]
fn programs_close_where_safe_points_lie_between_two_thousandths() {
    for d_t in [5.951, 5.963, 5.985, 6.005, 6.035, 6.085] {
        let made = outcome("full", &[("d_t", Value::Real(d_t))]);
        for key in ["blade", "splitter", "impeller"] {
            let text = program(&made, key);
            let start = made.programs.iter().find(|one| one.key == key).expect("the program").start;
            let end = *read_back(&text, start).last().expect("a motion");
            for axis in [Axis::X, Axis::Y, Axis::Z, Axis::B] {
                assert_eq!(end.get(axis), start.get(axis), "d_t {d_t}, {key}, {axis:?}");
            }
        }
        let found: Vec<_> = made.findings.iter().map(|one| one.code()).filter(|code| code.starts_with('V')).collect();
        assert!(!["V0006", "V0007", "V0012"].iter().any(|code| found.contains(code)), "d_t {d_t}: {found:?}");
    }
}
