//! Volumes against closed forms, and what repeated passes do.

use std::f64::consts::PI;

use super::lathe::{Run, bar};
use rodete::removal::turning::stock::Stock;

fn near(value: f64, right: f64) {
    assert!((value / right - 1.0).abs() < 1e-6, "{value} is not {right}");
}

#[test]
fn a_cylinder_and_a_face_are_taken_off_to_the_last_digit() {
    let run = Run::new(bar()).rapid(46.0, 2.0).cut(46.0, -30.0);
    // The wall at the end has the shape of the insert: 93° with a sharp tip, so leaning back by 3°.
    let step = run.last();
    assert!((step.depth - 2.0).abs() < 1e-9, "{}", step.depth);
    assert!(run.alarms().is_empty(), "{:?}", run.alarms());
    let taken = PI * (625.0 - 529.0) * 30.0;
    assert!(step.removed.volume < taken && step.removed.volume > 0.98 * taken, "{}", step.removed.volume);

    let whole = Run::new(Stock { overhang: 100.0, ..bar() }).tool(9).rapid(54.0, -1.0).cut(-1.0, -1.0);
    near(whole.last().removed.volume, PI * 625.0);
    near(whole.simulation.volume(), PI * 625.0 * 149.0);
    assert!(whole.alarms().is_empty(), "{:?}", whole.alarms());
}

#[test]
fn a_cone_has_the_volume_of_a_cone() {
    // From the point of the cone at the face to D 50 at Z-40: everything outside is taken off in passes of 2 mm.
    let mut run = Run::new(bar()).tool(9);
    for pass in (0..13).rev() {
        let up = 4.0 * f64::from(pass);
        run = run.rapid(60.0 + up, 2.0).rapid(up - 2.5, 2.0).cut(up + 50.0, -40.0);
    }
    let left = run.simulation.volume();
    near(left, PI * 625.0 * 110.0 + PI * 625.0 * 40.0 / 3.0);
    let sum: f64 = run.steps.iter().map(|step| step.removed.volume).sum();
    near(sum + left, PI * 625.0 * 150.0);
    assert_eq!(run.simulation.contours()[0].len(), 4);
}

#[test]
fn a_ball_turned_by_arcs_has_the_volume_of_a_ball() {
    // A half ball of R 25 at the end of the bar, from outside inwards and each pass the same arc farther in.
    let mut run = Run::new(bar()).tool(9);
    for pass in (0..13).rev() {
        let out = 2.0 * f64::from(pass);
        run = run.rapid(80.0, 2.0 + out).rapid(0.0, 2.0 + out).cut(0.0, out).arc(
            50.0,
            out - 25.0,
            [0.0, out - 25.0],
            90.0,
        );
        run = run.rapid(80.0, out - 25.0);
    }
    near(run.simulation.volume(), PI * 625.0 * 125.0 + 2.0 / 3.0 * PI * 15_625.0);
    assert!(!run.alarms().contains(&101), "{:?}", run.alarms());
}

#[test]
fn a_groove_is_as_wide_as_the_insert() {
    let mut setup = rodete::removal::turning::simulation::Setup::new(Default::default(), bar(), super::lathe::turret());
    let parter = setup.turret.tools.get_mut(&3).unwrap();
    parter.cutter =
        rodete::removal::turning::tool::Cutter::Groover { width: 3.0, depth: 20.0, corner: 0.0, face: false };
    let run = Run::on(setup).tool(3).rapid(54.0, -20.0).cut(40.0, -20.0).rapid(54.0, -20.0);
    near(run.simulation.totals().all.volume, PI * (625.0 - 400.0) * 3.0);
    assert!((run.steps[1].depth - 3.0).abs() < 1e-9);
    assert!(run.alarms().is_empty(), "{:?}", run.alarms());
}

#[test]
fn a_drilled_hole_is_a_cylinder_with_a_cone() {
    let run = Run::new(bar()).tool(6).rapid(0.0, 3.0).cut(0.0, -40.0).rapid(0.0, 3.0);
    let cone = 10.0 / rodete::number::trig::tan(59_f64.to_radians());
    near(run.simulation.totals().all.volume, PI * 100.0 * (40.0 - cone) + PI * 100.0 * cone / 3.0);
    assert!(run.alarms().is_empty(), "{:?}", run.alarms());
    // Bored out to D 30, 20 mm deep, by a bar inside.
    let bored = run.tool(7).rapid(30.0, 2.0).cut(30.0, -20.0);
    assert!(bored.alarms().is_empty(), "{:?}", bored.alarms());
    let taken = PI * (225.0 - 100.0) * 20.0;
    let volume = bored.last().removed.volume;
    assert!(volume > 0.95 * taken && volume < taken, "{volume} {taken}");
}

#[test]
fn ten_thousand_passes_over_one_contour_do_not_move_it() {
    let pass = |run: Run| {
        run.rapid(54.0, 2.0)
            .rapid(20.0, 2.0)
            .cut(30.0, -10.3)
            .arc(40.0, -15.3, [30.0, -15.3], 90.0)
            .cut(40.123, -33.333)
            .cut(51.0, -37.0)
            .rapid(54.0, 2.0)
    };
    let mut run = pass(Run::new(bar()).tool(2));
    let first = run.simulation.contours();
    let volume = run.simulation.volume();
    for _ in 0..10_000 {
        run.steps.clear();
        run = pass(run);
    }
    assert_eq!(run.simulation.contours(), first);
    assert!((run.simulation.volume() - volume).abs() < 1e-9);
    assert!(run.steps.iter().all(|step| step.removed.volume.abs() < 1e-12));
}

#[test]
fn the_quarter_torus_of_the_published_blank_is_turned_within_a_thousandth() {
    // R 25, r 15: the hollow quarter from X20 at the face to X50, about (Z 0, X 50), turned in shells with a sharp tip.
    let mut run = Run::new(bar()).tool(9);
    for pass in (0..=15).rev() {
        let out = f64::from(pass);
        run = run.rapid(70.0, 16.0).rapid(20.0 + 2.0 * out, 16.0).cut(20.0 + 2.0 * out, 0.0 + out);
        run = run.arc(50.0 + 2.0 * out, out - 15.0, [50.0 + 2.0 * out, out], -90.0).rapid(70.0 + 2.0 * out, out - 15.0);
    }
    let rings = run.simulation.contours();
    let arc: Vec<_> = rings[0].iter().filter(|[z, r]| *z > -14.99 && *z < -0.01 && *r > 10.01 && *r < 24.99).collect();
    assert!(arc.len() > 50, "{}", arc.len());
    for [z, r] in arc {
        let off = rodete::number::trig::hypot(*z, r - 25.0) - 15.0;
        assert!(off.abs() < 0.001, "{z} {r}: {off}");
    }
}
