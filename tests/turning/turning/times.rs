//! How long motions take.

use std::f64::consts::{PI, TAU};

use super::lines::read;

fn seconds(program: &str) -> Vec<Option<f64>> {
    read(program).motions.iter().map(|motion| motion.seconds).collect()
}

fn last(program: &str) -> f64 {
    seconds(program).pop().flatten().expect("a time")
}

fn near(ours: f64, theirs: f64) {
    assert!((ours / theirs - 1.0).abs() < 1e-9, "{ours} for {theirs}");
}

#[test]
fn feed_per_minute_and_per_revolution() {
    near(last("G98 S1000 M3\nG0 X50. Z0\nG1 Z-60. F120."), 30.0);
    near(last("S1000 M3\nG0 X50. Z0\nG1 Z-60. F.2"), 60.0 * 60.0 / 200.0);
    // Along a slope: 30 in radius, 40 in Z, 50 mm.
    near(last("S1000 M3\nG0 X80. Z0\nG1 X20. Z-40. F.2"), 50.0 * 60.0 / 200.0);
    near(last("S1000 M3\nG0 X40. Z0\nG3 X60. Z-10. R10. F.2"), 10.0 * PI / 2.0 * 60.0 / 200.0);
}

#[test]
fn facing_under_constant_surface_speed_to_the_limit_and_beyond() {
    // 200 m/min, limit 2000 rpm: the corner is at r* = 200000/(2π·2000) = 15.915 mm. From r 50: (50² − r*²)/2 of ∫ r dr, then
    // the rest at 2000 rpm.
    let corner = 200_000.0 / (TAU * 2000.0);
    let wanted = 60.0 * (TAU / 200_000.0 * (2500.0 - corner * corner) / 2.0 / 0.2 + corner / (0.2 * 2000.0));
    near(last("G50 S2000\nG96 S200 M3\nG0 X100. Z0\nG1 X0 F.2"), wanted);
    // In inches S is feet a minute: 200 m/min are 656.168 ft/min.
    let feet = 200.0 / 0.3048;
    near(last(&format!("G20\nG50 S2000\nG96 S{feet} M3\nG0 X{} Z0\nG1 X0 F{}", 100.0 / 25.4, 0.2 / 25.4)), wanted);
}

#[test]
fn turning_along_z_under_constant_surface_speed_is_at_one_speed() {
    // r 20: n = 150000/(2π·20).
    near(last("G50 S5000\nG96 S150 M3\nG0 X40. Z0\nG1 Z-30. F.1"), 30.0 / 0.1 * TAU * 20.0 / 150_000.0 * 60.0);
}

#[test]
fn an_arc_under_constant_surface_speed_takes_its_integral() {
    // A quarter circle of R 10 about X40 Z−10 from X40 Z0 to X60 Z−10: r = 20 + 10 sin φ, φ from 0 to π/2; ∫ r R dφ =
    // 10·(20·π/2 + 10).
    let wanted = TAU / 150_000.0 / 0.1 * 10.0 * (10.0 * PI + 10.0) * 60.0;
    near(last("G50 S5000\nG96 S150 M3\nG0 X40. Z0\nG3 X60. Z-10. R10. F.1"), wanted);
}

#[test]
fn g97_without_s_keeps_the_speed_that_g96_had() {
    // 200 m/min at X50: 1273.24 rpm.
    near(last("G50 S3000\nG96 S200 M3\nG0 X50. Z0\nG97\nG1 Z-10. F.1"), 100.0 / (200_000.0 / (TAU * 25.0)) * 60.0);
}

#[test]
fn threads_take_their_revolutions() {
    near(last("S400 M3\nG0 X30. Z5.\nG32 Z-25. F1.5"), 20.0 / 400.0 * 60.0);
    // On a cone the lead counts along Z, which moves more.
    near(last("S400 M3\nG0 X30. Z5.\nG32 X40. Z-25. F1.5"), 20.0 / 400.0 * 60.0);
    // In the face along X: 10 mm in radius.
    near(last("S400 M3\nG0 X30. Z5.\nG32 X10. Z4. F1."), 10.0 / 400.0 * 60.0);
    // G34: 2ν + 0.1ν²/2 = 30: ν = (√(4 + 6) − 2)/0.1.
    near(last("S400 M3\nG0 X30. Z5.\nG34 Z-25. F2. K.1"), (10.0_f64.sqrt() - 2.0) / 0.1 / 400.0 * 60.0);
}

#[test]
fn a_spindle_that_stands_still_gives_no_time() {
    for program in
        ["G0 X30.\nG1 Z-5. F.1", "S500\nG0 X30.\nG1 Z-5. F.1", "M3\nG0 X30.\nG1 Z-5. F.1", "G0 X30.\nG32 Z-5. F1."]
    {
        assert_eq!(seconds(program).pop(), Some(None), "{program}");
    }
    near(last("G0 X30. Z0\nG98 G1 Z-5. F100."), 3.0);
}
