//! A profile that the nose cannot make is told where another edge's mark is on the part, and nowhere else.

use super::lathe::{Run, bar};
use super::tools;
use rodete::number::trig::{hypot, sin_cos, tan};
use rodete::removal::turning::alarm::Alarm;
use rodete::removal::turning::machine::Lathe;
use rodete::removal::turning::simulation::Setup;
use rodete::removal::turning::stock::turned_about;
use rodete::removal::turning::tool::{Hand, Tip, TurningTool};

/// Goes along a path: places at feed `X, Z`, those behind `G0` at rapid, and `T` changes the tool.
fn run(mut run: Run, path: &str) -> Run {
    let mut rapid = false;
    for block in path.split(' ') {
        if let Some(place) = block.strip_prefix('T') {
            run = run.rapid(120.0, 60.0).tool(place.parse().unwrap());
        } else if let Some(code) = block.strip_prefix('G') {
            rapid = code == "0";
        } else {
            let (x, z) = block.split_once(',').unwrap();
            let (x, z) = (x.parse().unwrap(), z.parse().unwrap());
            run = if rapid { run.rapid(x, z) } else { run.cut(x, z) };
        }
    }
    run
}

fn with(tool: TurningTool, path: &str) -> Vec<Alarm> {
    let mut turret = super::lathe::turret();
    turret.tools.insert(1, tool);
    run(Run::on(Setup::new(Lathe::default(), bar(), turret)), path).raised()
}

/// How deep the edge that leans by so many degrees lies below a surface of constant X where the nose of radius R has ceased to pass it: the way goes
/// from one tip's place to another, `[X, Z]`.
fn below(X: f64, R: f64, lean: f64, [from, to]: [[f64; 2]; 2]) -> f64 {
    let centre = |[x, z]: [f64; 2]| [z + R, x / 2.0 + R];
    let ([z1, r1], [z2, r2]) = (centre(from), centre(to));
    let long = hypot(z2 - z1, r2 - r1);
    // The line R beside the centres, on the right of the way, at the surface.
    let [z, r] = [z1 - R * (r2 - r1) / long, r1 + R * (z2 - z1) / long];
    let z = z + (X / 2.0 - r) * (z2 - z1) / (r2 - r1);
    let (sin, cos) = sin_cos(lean.to_radians());
    X / 2.0 - (r2 - R * cos + (z - (z2 + R * sin)) * sin / cos)
}

#[test]
fn a_land_that_the_edge_behind_the_nose_takes_down_is_told_with_its_depth() {
    for (case, path, land, line, way) in [
        // As far as the open face.
        ("collar at the face", "G0 48,2 G1 48,-6 46.6,-7.5 46.6,-25 52,-25", 48.0, 3, [[48.0, -6.0], [46.6, -7.5]]),
        // A land between a way up and a way down.
        (
            "collar in the middle",
            "G0 46,2 G1 46,-15 47,-15 47,-18 46,-19 46,-30 52,-30",
            47.0,
            5,
            [[47.0, -18.0], [46.0, -19.0]],
        ),
        // Made before, with a rapid motion in between.
        (
            "over a rapid motion",
            "G0 48,2 G1 48,-40 52,-40 G0 52,-10 G1 48,-10 46.4,-14 46.4,-30 52,-30",
            48.0,
            6,
            [[48.0, -10.0], [46.4, -14.0]],
        ),
    ] {
        let alarms = with(tools::rougher(), path);
        let told: Vec<_> = alarms.iter().filter(|alarm| alarm.cause.number() == 132).collect();
        let [alarm] = told[..] else { panic!("{case}: {alarms:?}") };
        let deep = below(land, 0.8, 5.0, way);
        assert!(deep > 0.3 && (alarm.depth.unwrap() - deep).abs() < 1e-3, "{case}: {alarm:?} {deep}");
        assert!(alarm.line == line && (alarm.place[0] - land).abs() < 1e-9, "{case}: {alarm:?}");
    }
}

#[test]
fn a_face_that_the_main_edge_takes_down_is_told() {
    // Facing to X30, then deeper at 63 degrees from the axis: the main edge of 95° stands over the face that was made.
    let alarms = with(tools::rougher(), "G0 54,2 54,-1 G1 30,-1 26,-2 -1.6,-2");
    let [alarm] = alarms[..] else { panic!("{alarms:?}") };
    assert!(alarm.cause.number() == 132 && alarm.line == 4 && (alarm.place[1] + 1.0).abs() < 1e-9, "{alarm:?}");
    // The nose's centres are (−0.2, 15.8) and (−1.2, 13.8); the line 0.8 beside them, away from the axis, is at the face at r.
    // There the edge has come to stand this deep: it leans by 5° from its foot on the nose.
    let (sin, cos) = sin_cos(5.0_f64.to_radians());
    let long = 5.0_f64.sqrt();
    let r = 15.8 + 0.8 / long - 2.0 * (0.8 - 0.8 * 2.0 / long);
    let edge = -1.2 - 0.8 * cos + (r - (13.8 + 0.8 * sin)) * sin / cos;
    assert!((alarm.depth.unwrap() - (-1.0 - edge)).abs() < 1e-3, "{alarm:?} {edge} {r}");
    assert!((alarm.place[0] - 2.0 * r).abs() < 1e-3, "{alarm:?} {r}");
}

#[test]
fn what_a_tool_can_make_and_what_is_taken_away_after_it_is_not_told() {
    let (C, D, V) = (tools::rougher, tools::profiler, tools::copier);
    let slope = |angle: f64| format!("G0 48,2 G1 48,-10 44,{} 44,-40 52,-40", -10.0 - 2.0 / tan(angle.to_radians()));
    for (case, tool, path) in [
        ("as steep as the edge", C(), slope(5.0)),
        ("as steep as the edge", D(), slope(32.0)),
        ("as steep as the edge", V(), slope(52.0)),
        ("no steeper than a hundredth tells", D(), slope(32.1)),
        // A face to X30, and along the axis from it.
        ("from a face along the axis", C(), "G0 54,0 G1 30,0 30,-20 54,-20".to_owned()),
        ("from a face down a taper", C(), "G0 54,0 G1 30,0 28,-20 54,-20".to_owned()),
        // One pass below another, and steps.
        (
            "pass below pass",
            C(),
            "G0 48,2 G1 48,-40 50,-40 G0 50,2 46,2 G1 46,-30 48,-30 G0 48,2 44,2 G1 44,-30 54,-30".to_owned(),
        ),
        ("all at feed", C(), "G0 48,2 G1 48,-30 52,-30 52,2 46,2 46,-30 52,-30".to_owned()),
        // Faces one behind the other leave a boss.
        ("faces", C(), "G0 52,-2 G1 20,-2 G0 20,2 52,2 52,-4 G1 20,-4 G0 20,4".to_owned()),
        // A way back whose round nose is all of what stays in the surface.
        ("a shallow way back", V(), "G0 48,2 G1 48,-30 47.6,-30 47.6,-15 54,-15".to_owned()),
        // A plunge that gives the part the insert's form.
        ("a plunge", V(), "G0 48,2 G1 48,-30 52,-30 G0 52,-15 G1 47.95,-15 52,-15".to_owned()),
        (
            "turned away after it",
            C(),
            "G0 48,2 G1 48,-6 46.6,-7.5 46.6,-25 52,-25 G0 52,2 44,2 G1 44,-30 52,-30".to_owned(),
        ),
    ] {
        let alarms = with(tool, &path);
        assert!(alarms.iter().all(|alarm| alarm.cause.number() != 132), "{case}: {path} {alarms:?}");
    }
}

#[test]
fn a_mark_of_roughing_that_finishing_with_another_tool_leaves_is_told() {
    // 0.5 mm are left for the copier; the rougher's mark is deeper, or not.
    let finish = "T8 G0 46,5 G1 46,-12 44,-14.5 44,-30 52,-30";
    let rough = |z: f64| format!("G0 47,2 G1 47,-12 45,{z} 45,-29.5 52,-29.5 {finish}");
    assert!(with(tools::rougher(), &rough(-14.5)).iter().any(|alarm| alarm.cause.number() == 132 && alarm.line == 3));
    let shallow = rough(-12.0 - 1.0 / tan(7.0_f64.to_radians()));
    assert!(with(tools::rougher(), &shallow).iter().all(|alarm| alarm.cause.number() != 132));
}

#[test]
fn a_crown_of_short_chords_whose_ends_lie_off_the_grid_is_a_surface_that_was_made() {
    // A crown of R 100 in chords of 0.1 mm, each end by turns 0.45 nm above and below a place of the grid of nanometres: none
    // of the lines that are cut has the very direction of its way. The plunge to where it begins has not made the crown.
    let place = |at: i32| {
        let along = f64::from(at) / 10.0;
        let off = if at % 2 == 0 { 4.5e-7 } else { -4.5e-7 };
        [2.0 * (24.0 - (along * along / 200.0 * 1e6).round() / 1e6 + off), -2.0 - along]
    };
    let plunged = Run::new(bar()).rapid(60.0, -2.0).cut(48.0, -2.0);
    let crown = (1..=20).map(place).fold(plunged, |run, [x, z]| run.cut(x, z));
    let [X, z] = place(20);
    // At its end it falls by 1°, and the way leads down from it by 25°.
    let alarms = crown.cut(X - 1.4, z - 1.5).cut(X - 1.4, -25.0).cut(52.0, -25.0).raised();
    let told: Vec<_> = alarms.iter().filter(|alarm| alarm.cause.number() == 132).collect();
    let [alarm] = told[..] else { panic!("{alarms:?}") };
    let deep = below(X, 0.8, 5.0, [[X, z], [X - 1.4, z - 1.5]]);
    assert!(alarm.line == 23 && (alarm.depth.unwrap() - deep).abs() < 0.02, "{alarm:?} {deep}");
}

/// A path mirrored along Z, from where it lies in the second set-up.
fn mirrored(path: &str, about: f64) -> String {
    let block = |block: &str| match block.split_once(',') {
        Some((x, z)) => format!("{x},{}", about - z.parse::<f64>().unwrap()),
        None => block.to_owned(),
    };
    path.split(' ').map(block).collect::<Vec<_>>().join(" ")
}

#[test]
fn what_made_the_surfaces_is_known_in_the_second_set_up_as_in_one() {
    let shift = -2.0;
    let about = bar().ends()[0] + bar().ends()[1] + shift;
    let mut setup = Setup::new(Lathe::default(), bar(), super::lathe::turret());
    setup.turret.tools.insert(11, TurningTool { tip: Tip::OutsideRight, hand: Hand::Left, ..tools::rougher() });
    let lying = Setup { part: Some(turned_about(&[bar().contour()], &bar(), shift)), ..setup.clone() };
    let collar = "G0 60,5 48,5 G1 48,-6 46.6,-7.5 46.6,-25 52,-25";
    let rough = "G0 60,5 46.5,5 G1 47,-12 45,-14.5 45,-29.5 52,-29.5";
    // Who tells of a mark.
    let (first, second) = ([true, false], [false, true]);
    for (case, before, after, told) in [
        // The land goes as far as the open face: its sense tells it.
        ("a land", "G0 60,5 48,5 G1 48,-6 52,-6", collar, second),
        ("a mark that stays", collar, "G0 60,5 49,5 G1 49,-10 54,-10", first),
        ("a mark that goes", collar, "G0 52,5 44,5 G1 44,-30 52,-30", [false; 2]),
        // With what was there of it below a cone.
        ("a mark that goes deeper", rough, "G0 60,-6 47,-6 G1 46,-7.5 52,-7.5", [true; 2]),
    ] {
        let marks = |mut alarms: Vec<Alarm>| {
            alarms.retain(|alarm| alarm.cause.number() == 132);
            alarms
        };
        // In one set-up; in two, the first with the mirror image of the tool.
        let one = run(Run::on(lying.clone()), before);
        let length = one.steps.len();
        let (of_first, of_second): (Vec<_>, Vec<_>) =
            marks(run(one, after).simulation.lasting()).into_iter().partition(|alarm| alarm.line <= length);
        let begun = run(Run::on(setup.clone()).tool(11), &mirrored(before, about)).simulation;
        let two = Run { simulation: begun.turned_about(shift).unwrap(), ..Run::on(setup.clone()) };
        let two = run(two, after).simulation;
        // Between lines that are all but parallel, places move by more than the grid.
        let near = |one: f64, two: f64, most: f64| (one - two).abs() < most;
        let same = |(one, two): (&Alarm, &Alarm)| {
            near(one.depth.unwrap(), two.depth.unwrap(), 1e-5)
                && (0..2).all(|axis| near(one.place[axis], two.place[axis], 1e-3))
        };
        let [found, mut left] = [two.lasting(), begun.lasting_in(Some(&two))].map(marks);
        left.iter_mut().for_each(|alarm| alarm.place[1] = about - alarm.place[1]);
        assert_eq!(
            [&of_first, &of_second].map(|alarms| !alarms.is_empty()),
            told,
            "{case}: {of_first:?} {of_second:?}"
        );
        for (one, two) in [(of_first, left), (of_second, found)] {
            assert!(one.len() == two.len() && one.iter().zip(&two).all(same), "{case}: {one:?} {two:?}");
        }
    }
}
