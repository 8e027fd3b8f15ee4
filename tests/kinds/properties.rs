//! What must hold for every valid design.

use crate::common;

use std::f64::consts::FRAC_PI_2;

use nalgebra::Vector3;
use proptest::prelude::*;
use rodete::gcode::control::MILLING;
use rodete::geometry::darboux::Darboux;
use rodete::geometry::torus::Torus;
use rodete::geometry::villarceau::Villarceau;
use rodete::kinds::impeller::blade::Blade;
use rodete::kinds::impeller::blade_count::{N_max, e_max};
use rodete::kinds::impeller::parameters::FORM;
use rodete::machine::axis::Axis;
use rodete::machine::rotary::TiltingTable;
use rodete::number::trig::{asin, atan2, hypot};
use rodete::parameter::{FieldKind, Value};

/// The limits of a parameter, from the form itself.
fn limits(key: &str) -> (f64, f64) {
    match FORM.parameter(key).unwrap().kind {
        FieldKind::Real { min, max } => (min, max),
        FieldKind::Whole { min, max } => (f64::from(min), f64::from(max)),
        _ => panic!("a number"),
    }
}

prop_compose! {
    fn torus()(R in limits("R").0..limits("R").1, part in 0.05..0.95_f64) -> Torus {
        Torus { R, r: (R * part).max(limits("r").0).min(R * 0.99) }
    }
}

prop_compose! {
    fn blade()(torus in torus(), n in 2_usize..200, eps_v in 0.0..0.5_f64, spare in 1.0..500.0_f64) -> (Blade, TiltingTable) {
        let machine = TiltingTable { L: torus.R + spare };
        (Blade::new(torus, n, eps_v, machine), machine)
    }
}

/// A design that no check refuses, with every dialect, complete or in the published layout.
fn design(full: bool) -> impl Strategy<Value = Vec<(&'static str, Value)>> {
    (torus(), 0.02..0.6_f64, 0.1..0.9_f64, 0.2..0.95_f64, 2_u32..60, 1_u32..12, any::<[bool; 2]>(), 0..MILLING.len())
        .prop_map(move |(torus, depth, wide, thick, n, N, [absolute, splitters], dialect)| {
            let a_p = ((torus.R - torus.r) * depth).clamp(0.01, 100.0);
            let hub = e_max(torus, a_p, N, 0.0);
            let d_t = (hub * wide * 0.7).clamp(0.2, 2.0 * torus.r).min(100.0);
            let e = (e_max(torus, a_p, N, d_t) * thick).min(100.0);
            vec![
                ("R", Value::Real(torus.R)),
                ("r", Value::Real(torus.r)),
                ("n", Value::Whole(n)),
                ("N", Value::Whole(N)),
                ("a_p", Value::Real(a_p)),
                ("d_t", Value::Real(d_t)),
                ("e", Value::Real(e)),
                ("d_s", Value::Real((e + d_t).min(500.0))),
                ("H", Value::Real((torus.R * 1.5).min(1000.0))),
                ("R_B", Value::Real(torus.R)),
                ("L_b", Value::Real(torus.r * 2.0)),
                ("X_e", Value::Real(torus.R * 3.0)),
                ("splitters", Value::Choice(if splitters { "yes" } else { "no" })),
                ("style", Value::Choice(if full { "full" } else { "annex" })),
                ("distance", Value::Choice(if absolute { "G90" } else { "G91" })),
                ("dialect", Value::Choice(MILLING[dialect].name)),
                ("start_codes", Value::Line("M3".to_owned())),
                ("rotary", Value::Choice(if absolute { "linear" } else { "rollover" })),
                ("retract", Value::Line(if dialect == 1 { "" } else { "G0 G53 Z0" }.to_owned())),
            ]
        })
}

proptest! {
    #[test]
    fn tangent_and_binormal_are_constant_in_machine_axes((blade, _) in blade()) {
        let Torus { R, r } = blade.circle.torus;
        for i in 0..blade.points() {
            let turned = |a: &Vector3<f64>| TiltingTable::direction_to_machine(a, blade.B[i], blade.C[i]);
            prop_assert!((turned(&blade.t[i]) - blade.t_machine).norm() < 1e-12);
            prop_assert!((turned(&blade.b[i]) - blade.b_machine).norm() < 1e-12);
            prop_assert!((turned(&blade.N[i]) - Vector3::new(0.0, 0.0, 1.0)).norm() < 1e-12);
        }
        // β, the inclination of the end section, is the angle between b″ and x.
        let beta = atan2(-blade.b_machine.y, blade.b_machine.x);
        prop_assert!((beta - asin(r / R)).abs() < 1e-12);
    }

    #[test]
    fn inverse_then_forward_kinematics_returns_the_point((blade, machine) in blade()) {
        for i in 0..blade.points() {
            let back = machine.to_part(&blade.machine[i], blade.B[i], blade.C[i]);
            prop_assert!((back - blade.P[i]).norm() < 1e-9);
        }
    }

    #[test]
    fn the_darboux_frame_is_orthonormal(torus in torus(), v in std::f64::consts::PI..4.7123) {
        let circle = Villarceau::new(torus);
        let Darboux { N, t, b } = Darboux::of(circle, circle.u(v), v);
        for (one, other, product) in [(N, N, 1.0), (t, t, 1.0), (b, b, 1.0), (N, t, 0.0), (N, b, 0.0), (t, b, 0.0)] {
            prop_assert!((one.dot(&other) - product).abs() < 1e-12);
        }
    }

    #[test]
    fn du_dv_agrees_with_finite_differences(torus in torus(), v in 3.15..4.70_f64) {
        let circle = Villarceau::new(torus);
        let h = 1e-5;
        let difference = (circle.u(v + h) - circle.u(v - h)) / (2.0 * h);
        let slope = circle.du_dv(v);
        prop_assert!((difference - slope).abs() < 1e-5 * slope.max(1.0) * torus.R / (torus.R - torus.r), "{difference} {slope}");
    }

    #[test]
    fn angles_are_those_of_the_normal((blade, _) in blade()) {
        for i in 0..blade.points() - 1 {
            let N = blade.N[i];
            prop_assert!((atan2(hypot(N.x, N.y), N.z) - blade.B[i]).abs() < 1e-7);
            let turns = (atan2(N.y, N.x) - blade.C[i]) / std::f64::consts::TAU;
            prop_assert!((turns - turns.round()).abs() < 1e-9);
        }
        prop_assert!((blade.B[0] - FRAC_PI_2).abs() < 1e-12);
        prop_assert!(blade.C.windows(2).all(|pair| pair[1] > pair[0] && pair[1] - pair[0] < std::f64::consts::PI));
    }

    #[test]
    fn limits_of_blades_and_thickness_agree(torus in torus(), d_t in 0.2..20.0_f64, a_p in 0.01..5.0_f64, N in 1_u32..30) {
        let e = e_max(torus, a_p, N, d_t);
        prop_assume!(e > 0.01);
        // At e_max exactly N blades fit, a little thicker and they do not.
        prop_assert!(N_max(torus, a_p, e * (1.0 - 1e-9), d_t) >= f64::from(N));
        prop_assert!(N_max(torus, a_p, e * (1.0 + 1e-9), d_t) < f64::from(N));
    }
}

/// Every program of a design: the text's own increments close to exactly 0, and the text says what was planned.
fn closes_and_reads_back(changes: &[(&'static str, Value)]) -> Result<(), TestCaseError> {
    let values = common::values("full", changes);
    // Some designs have no splitter, or safe points inside the passes: refused with a reason. Too many of them
    // would end the test.
    let outcome = rodete::kinds::run(&FORM, values, common::source());
    prop_assume!(outcome.is_ok());
    let outcome = outcome.unwrap();
    prop_assert!(!outcome.stopped() || outcome.programs.is_empty());
    for program in outcome.programs.iter().filter(|program| program.key != "blank") {
        let positions = common::read_back(&program.text(), program.start);
        let mut planned = vec![program.start];
        program.for_each_move(&mut |each| planned.push(each.to));
        // Reading starts where the program does; positioning blocks before the first move go there too.
        prop_assert_eq!(&positions[positions.len() + 1 - planned.len()..], &planned[1..]);
        let (first, last) = (planned[0], planned[planned.len() - 1]);
        for axis in rodete::machine::axis::Axis::ALL {
            let left = (last.get(axis) - first.get(axis)).thousandths();
            let turn_to_next = program.key != "impeller" && axis == rodete::machine::axis::Axis::C;
            let closes = if axis == rodete::machine::axis::Axis::C { left.rem_euclid(360_000) == 0 } else { left == 0 };
            prop_assert!(closes || turn_to_next);
        }
        for line in program.text().lines() {
            prop_assert!(line.len() <= 255 && line.is_ascii(), "{line}");
            for word in line.split_whitespace().filter(|_| !line.starts_with([';', '(', '%'])) {
                let number = &word[1..];
                prop_assert!(number.bytes().all(|byte| b"-.0123456789".contains(&byte)), "{line}");
                prop_assert!(
                    !(number.starts_with("-0") && number.bytes().all(|byte| b"-.0".contains(&byte))),
                    "{line}"
                );
            }
        }
    }
    Ok(())
}

// Two tests, so that two cores work at them.
proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn complete_programs_of_any_design_close_and_read_back(changes in design(true)) {
        closes_and_reads_back(&changes)?;
    }

    #[test]
    fn programs_of_any_design_in_the_published_layout_close_and_read_back(changes in design(false)) {
        closes_and_reads_back(&changes)?;
    }
}

/// What an axis reaches at feed it reaches in all.
#[test]
fn the_extents_of_a_program_hold_those_at_feed() {
    let mut seen = 0;
    for (kind, case, language) in common::cases() {
        for program in &common::shipped(kind, case, language).programs {
            let (Some(whole), Some(feed)) = (program.account.program, program.account.feed) else { continue };
            for axis in Axis::ALL {
                let ([least, greatest], [low, high]) = (whole.of(axis), feed.of(axis));
                assert!(least <= low && high <= greatest, "{kind:?} {} {} {axis:?}", case.name, program.key);
            }
            seen += 1;
        }
    }
    assert!(seen > 10, "{seen} programs");
}

/// The block that takes the tool away in program coordinates is counted; what it moves with G53 has no place in the program.
#[test]
fn the_extents_of_a_program_hold_where_the_tool_is_taken_away_to() {
    for (dialect, block, high) in [("fagor-8070", "G0 Z400", true), ("linuxcnc", "G0 G53 Z400", false)] {
        let made = common::outcome(
            "full",
            &[
                ("dialect", Value::Choice(dialect)),
                ("start_codes", Value::Line("M3".to_owned())),
                ("retract", Value::Line(block.to_owned())),
            ],
        );
        let blade = made.programs.iter().find(|program| program.key == "blade").unwrap();
        let [_, greatest] = blade.account.program.unwrap().of(Axis::Z);
        assert_eq!(greatest == 400.0, high, "{block}: {greatest}");
        let header = blade.extents().into_iter().find(|extent| extent.0 == 'Z').unwrap();
        assert!((header.2.value() - greatest).abs() < 1e-9, "{block}: {greatest}, {header:?}");
    }
}
