//! The distance of the tool from the stock is bounded: against points of the tool looked at by chance, and where a grid of
//! points on it told too much.

use std::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::Vector3;
use proptest::prelude::*;
use rodete::finding::Grade;
use rodete::geometry::torus::Torus;
use rodete::kinds::impeller::clearance::Stand;
use rodete::kinds::impeller::outside::{CLOSE, Outside, WORK};
use rodete::kinds::impeller::solids::Stock;
use rodete::number::trig::{hypot, sin_cos};

use super::{common, verdicts, with};

/// The distance of a point of the tool from the stock: angle, part of the radius, part of the reach.
fn at(outside: &Outside, stand: &Stand, [angle, part, height]: [f64; 3]) -> f64 {
    let ((sin, cos), (sin_B, cos_B)) = (sin_cos(angle), sin_cos(stand.B));
    let x = stand.at.x + outside.radius * part * cos;
    let y = stand.at.y + outside.radius * part * sin;
    let z = stand.at.z + outside.L + outside.reach * height;
    outside.stock.distance(hypot(x * cos_B + z * sin_B, y), z * cos_B - x * sin_B - outside.L)
}

/// Numbers from 0 to 1, the same in every run.
fn chance(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed | 1;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(state >> 33).unwrap()) / f64::from(1_u32 << 31)
    }
}

/// A tool of 5 mm beside a blank of R 25, r 11, L_b 14 at L 60, and another of the same over one of R 60, r 21, L_b 27: on
/// a grid of 24 directions and 9 heights, and down from its nearest point, they were 7.714 and 0.875 mm away.
#[test]
fn a_tool_that_is_nearest_between_directions_and_heights_is_not_told_farther() {
    for (R, r, length, B, tip, reach, told, true_distance) in [
        (25.0, 11.0, 14.0, FRAC_PI_2, [-61.7, -25.6, -89.0], 84.0, 7.714, 6.7243),
        (60.0, 21.0, 27.0, 1.397_466_938_596_943_4, [-69.9, 24.2, -105.1], 167.0, 0.8746, 0.4762),
    ] {
        let stock = Stock { torus: Torus { R, r }, length };
        let outside = Outside { stock, L: 60.0, radius: 5.0, reach };
        let stand = Stand { at: Vector3::from(tip), B, C: 0.0 };
        let mut grid = f64::INFINITY;
        for direction in 0..24 {
            for height in [0.0, 0.01, 0.03, 0.06, 0.12, 0.25, 0.45, 0.7, 1.0] {
                grid = grid.min(at(&outside, &stand, [TAU * f64::from(direction) / 24.0, 1.0, height]));
            }
        }
        let found = outside.along(&stand, &stand, WORK);
        assert!(grid > told && found.upper < true_distance && found.lower > true_distance - 1e-3, "{grid} {found:?}");
        assert!(found.upper - found.lower < 1.1 * CLOSE, "{found:?}");
    }
}

#[test]
fn bounds_hold_where_the_work_ends_before_they_meet() {
    let outside = Outside {
        stock: Stock { torus: Torus { R: 25.0, r: 15.0 }, length: 40.0 },
        L: 242.9,
        radius: 3.0,
        reach: 110.0,
    };
    let from = Stand { at: Vector3::new(40.0, -9.0, -20.0), B: 0.0, C: 0.0 };
    let to = Stand { at: Vector3::new(-240.0, 30.0, -230.0), B: 1.2, C: 4.0 };
    let whole = outside.along(&from, &to, WORK);
    let mut before = f64::NEG_INFINITY;
    for budget in [1, 5, 20, 60, 200] {
        let found = outside.along(&from, &to, budget);
        assert!(
            before <= found.lower && found.lower <= whole.upper && whole.lower <= found.upper,
            "{budget}: {found:?}"
        );
        before = found.lower;
    }
}

/// A crossing that runs beside the stock and grazes it in the middle alone, for a thousandth of its way.
#[test]
fn a_graze_in_the_middle_of_a_long_move_is_found() {
    let outside = Outside {
        stock: Stock { torus: Torus { R: 25.0, r: 15.0 }, length: 40.0 },
        L: 242.9,
        radius: 3.0,
        reach: 110.0,
    };
    let stand = |y: f64, x: f64| Stand { at: Vector3::new(x, y, -30.0), B: 0.0, C: 0.0 };
    let found = outside.along(&stand(-3000.0, 28.25), &stand(2000.0, 28.25), WORK);
    assert!((found.lower - 0.25).abs() < 1.1 * CLOSE, "{found:?}");
    let found = outside.along(&stand(-3000.0, 27.999), &stand(2000.0, 27.999), WORK);
    assert!(found.upper < 0.0 && found.lower > -0.0012, "{found:?}");
}

#[test]
fn a_rapid_move_nearer_than_the_safety_distance_is_a_caution_and_one_on_it_passes() {
    // Out of the last pass to a safe point that much nearer. A twentieth of d_s used to pass, which is 0.25 mm.
    for (nearer, verdict) in [(0.0, None), (0.1, Some(Grade::Caution))] {
        let worst = verdicts("tfg-2021", &[], "blade", |text| with(text, 86, 'X', |value| value + nearer));
        assert_eq!((worst["safe-points"], worst["clear-moves"]), (verdict, verdict), "{nearer}");
    }
}

#[test]
fn the_clearance_to_the_stock_is_told_with_both_bounds_and_what_rounding_takes() {
    let outcome = common::outcome("full", &[]);
    let shown = format!("{:?}", outcome.tables.iter().find(|table| table.key == "verification").unwrap());
    assert!(shown.contains("bounded between 4.9999 and 5.0001 mm"), "{shown}");
    assert!(shown.contains("less up to 0.003 mm of rounding"), "{shown}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn no_point_of_a_moving_tool_is_nearer_to_the_stock_than_the_lower_bound(
        (R, part, high) in (10.0..200.0_f64, 0.2..0.95_f64, 0.5..3.0_f64), L in 0.1..6.0_f64, thick in 0.01..0.4_f64,
        from in [-1.0..1.0_f64, -1.0..1.0, -1.0..1.0, -0.2..1.6], by in [-1.0..1.0_f64, -1.0..1.0, -1.0..1.0, -1.5..1.5],
        turning in any::<bool>(), seed in any::<u64>(),
    ) {
        let (r, L) = (R * part, R * L);
        let outside = Outside { stock: Stock { torus: Torus { R, r }, length: r * high }, L, radius: R * thick, reach: 4.0 * R };
        // A tip about where the stock is when B stands so.
        let stand = |[x, y, z, B]: [f64; 4]| {
            let (sin, cos) = sin_cos(B);
            let middle = Vector3::new(-L * sin, 0.0, L * cos - L);
            Stand { at: middle + Vector3::new(x, y, z + 0.5) * (1.6 * R), B, C: 0.0 }
        };
        let end = stand([0, 1, 2, 3].map(|axis| from[axis] + if axis == 3 && !turning { 0.0 } else { by[axis] }));
        let (from, to) = (stand(from), end);
        let found = outside.along(&from, &to, WORK);
        prop_assert!(found.lower <= found.upper);
        prop_assert!(found.work >= WORK || found.upper < 0.0 || found.upper - found.lower < 1.1 * CLOSE, "{:?}", found);
        let mut next = chance(seed);
        for _ in 0..10_000 {
            let stand = from.towards(&to, next());
            let (angle, on_end) = (TAU * next(), next() < 0.4);
            let place = if on_end { [angle, next(), 0.0] } else { [angle, 1.0, next()] };
            let distance = at(&outside, &stand, place);
            // Of a tool in the stock the depth told is one that is reached, to a hundredth.
            prop_assert!(found.upper < 0.0 || distance >= found.lower, "{} {:?}", distance, found);
        }
    }
}
