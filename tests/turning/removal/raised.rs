//! Each alarm once, with its block, its place and its depth as they are worked out by hand; and its near twin in silence.

use std::f64::consts::PI;

use super::lathe::{Run, bar, turret};
use super::tools;
use rodete::finding::Grade;
use rodete::gcode::in_force::{Speed, Spindle};
use rodete::number::trig::{hypot, sin_cos, tan};
use rodete::removal::turning::alarm::{Alarm, Cause};
use rodete::removal::turning::machine::Lathe;
use rodete::removal::turning::simulation::Setup;
use rodete::removal::turning::stock::{Stock, turned_about};
use rodete::removal::turning::tool::{Cutter, Hand, Holder, Shape, Tip, TurningTool};
use rodete::removal::turning::turret::Turret;

#[track_caller]
fn near(value: f64, wanted: f64, within: f64) {
    assert!((value - wanted).abs() <= within, "{value} {wanted}");
}

#[track_caller]
fn at(alarm: Alarm, place: [f64; 2], within: f64) {
    assert!((0..2).all(|axis| (alarm.place[axis] - place[axis]).abs() <= within), "{alarm:?} {place:?}");
}

fn sin(degrees: f64) -> f64 {
    sin_cos(degrees.to_radians()).0
}

fn cos(degrees: f64) -> f64 {
    sin_cos(degrees.to_radians()).1
}

/// The roughing tool with a sharp corner: 80°, its main edge at 95°, its auxiliary edge at 5°.
fn rougher() -> TurningTool {
    let cutter = Cutter::Insert { shape: Shape::C, circle: 12.7, main: 95.0, auxiliary: 5.0, nose: 0.0 };
    TurningTool { cutter, ..tools::rougher() }
}

/// Its image, which cuts away from the chuck.
fn leftward() -> TurningTool {
    TurningTool { hand: Hand::Left, tip: Tip::OutsideRight, ..rougher() }
}

fn with(tool: TurningTool) -> Setup {
    Setup::new(Lathe::default(), bar(), Turret { tools: [(1, tool)].into(), body: None })
}

#[test]
fn rapid_through_metal_outside_inside_on_the_axis_and_in_a_groove() {
    // The edge of the parting tool, 3 mm wide with corners of 0.2, 1 mm into the bar.
    let groove = |x: f64| Run::new(bar()).tool(3).rapid(60.0, -40.0).rapid(x, -40.0);
    let alarm = groove(48.0).only(101);
    near(alarm.depth.unwrap(), 1.0, 1e-6);
    near(alarm.place[0], 48.0, 1e-6);
    assert!((-40.0..=-37.0).contains(&alarm.place[1]) && alarm.cause.grade() == Grade::Stop, "{alarm:?}");
    groove(50.0).silent();
    // The boring bar along a bore of D 30: 0.01 too far out, and on the wall.
    let bore = |x: f64| Run::new(Stock { bore: 30.0, ..bar() }).tool(7).rapid(x, 3.0).rapid(x, -20.0);
    let alarm = bore(30.02).only(101);
    near(alarm.depth.unwrap(), 0.01, 1e-6);
    near(alarm.place[0], 30.01, 0.0101);
    bore(30.0).silent();
    // A drill of 118° to 1 mm behind the face: its point is as deep.
    let drill = |z: f64| Run::new(bar()).tool(6).rapid(0.0, 3.0).rapid(0.0, z);
    let alarm = drill(-1.0).only(101);
    near(alarm.depth.unwrap(), 1.0, 1e-6);
    at(alarm, [0.0, -1.0], 1e-6);
    drill(0.0).silent();
    // A second time into a hole that is drilled; and 0.5 mm farther than it goes.
    let again = |z: f64| Run::new(bar()).tool(6).rapid(0.0, 3.0).cut(0.0, -20.0).rapid(0.0, 3.0).rapid(0.0, z);
    again(-20.0).silent();
    again(-20.5).only(101);
}

#[test]
fn a_retraction_that_scrapes_the_wedge_of_its_own_edge_is_a_caution() {
    // The edge at 95° leaves a wedge at the shoulder, as thick at the skin as the depth of cut makes it.
    let wedge = |deep: f64| deep * tan(5_f64.to_radians());
    let cut = |deep: f64| Run::on(with(rougher())).rapid(50.0 - 2.0 * deep, 2.0).cut(50.0 - 2.0 * deep, -20.0);
    let alarm = cut(2.0).rapid(54.0, -20.0).only(101);
    near(alarm.depth.unwrap(), wedge(2.0), 1e-6);
    at(alarm, [50.0, -20.0 + wedge(2.0)], 1e-5);
    assert_eq!((alarm.cause, alarm.cause.grade()), (Cause::RetractionInMetal, Grade::Caution));
    // At 45°, and at feed, it is none.
    cut(2.0).rapid(48.0, -19.0).rapid(54.0, -19.0).silent();
    cut(2.0).cut(54.0, -20.0).silent();
    // Thicker than half a millimetre it is a crash: 5.72 mm deep and more.
    let alarm = cut(5.7).rapid(54.0, -20.0).only(101);
    assert_eq!(alarm.cause, Cause::RetractionInMetal);
    let alarm = cut(5.73).rapid(54.0, -20.0).only(101);
    assert_eq!((alarm.cause, alarm.cause.grade()), (Cause::RapidInMetal, Grade::Stop));
    near(alarm.depth.unwrap(), wedge(5.73), 1e-6);
    // On the way to the intermediate point of a return to reference it has a remedy of its own, under the same number.
    let mut stands = Run::on(with(rougher())).rapid(54.0, -20.0);
    stands.control.to_intermediate = true;
    let alarm = stands.rapid(0.0, 0.0).only(101);
    assert_eq!((alarm.cause, alarm.cause.grade()), (Cause::IntermediateInMetal, Grade::Stop));
    assert!(alarm.cause.remedy().en.contains("G28 U0 W0"), "{}", alarm.cause.remedy().en);
    // Thin as it may be, metal before the tool is no leftover, nor is what it meets after it was taken off.
    assert_eq!(cut(0.2).rapid(49.6, -30.0).only(101).cause, Cause::RapidInMetal);
    let back = cut(2.0).cut(54.0, -20.0).rapid(60.0, -20.1).rapid(49.6, -20.1);
    assert_eq!(back.only(101).cause, Cause::RapidInMetal);
    // The image of it, of a left-hand tool away from the chuck, from a groove to Z−10.
    let ring = [[-150.0, 0.0], [0.0, 0.0], [0.0, 25.0], [-20.0, 25.0], [-20.0, 23.0], [-40.0, 23.0], [-40.0, 25.0]];
    let part = Some(vec![ring.into_iter().chain([[-150.0, 25.0]]).collect()]);
    let left = Run::on(Setup { part, ..with(leftward()) }).rapid(60.0, -21.0).rapid(46.0, -21.0).cut(46.0, -10.0);
    let alarm = left.rapid(54.0, -10.0).only(101);
    near(alarm.depth.unwrap(), wedge(2.0), 1e-6);
    assert_eq!(alarm.cause, Cause::RetractionInMetal);
    // A boring bar with its edge at 93°, 2 mm deep in the wall, taken off it towards the axis.
    let cutter = Cutter::Insert { shape: Shape::D, circle: 9.525, main: 93.0, auxiliary: 32.0, nose: 0.0 };
    let bore = |x: f64| {
        let setup = Setup { stock: Stock { bore: 30.0, ..bar() }, ..with(TurningTool { cutter, ..tools::borer() }) };
        Run::on(setup).rapid(34.0, 3.0).cut(34.0, -20.0).rapid(x, -20.0)
    };
    let alarm = bore(29.0).only(101);
    near(alarm.depth.unwrap(), 2.0 * tan(3_f64.to_radians()), 1e-6);
    assert_eq!(alarm.cause, Cause::RetractionInMetal);
    // Plunged in by 0.4 mm and taken along the skin in rapid, a tool meets no wedge of its own edge: 24 mm² in section, as from the free end.
    let along = |z: f64| Run::on(with(rougher())).rapid(54.0, z).cut(49.2, z).rapid(49.2, 5.0);
    let alarm = along(-60.0).only(101);
    assert_eq!((alarm.cause, alarm.cause.grade()), (Cause::RapidInMetal, Grade::Stop));
    near(alarm.depth.unwrap(), 0.4, 1e-6);
    // A blade leaves no wedge, however little it meets.
    let blade = Run::new(bar()).tool(3).rapid(54.0, -20.0).cut(49.2, -20.0).rapid(49.2, -18.0);
    assert_eq!(blade.only(101).cause, Cause::RapidInMetal);
}

#[test]
fn rapid_through_metal_after_the_part_was_turned_about() {
    // Ends at Z0 and Z−150, turned to D 40 from Z0 to Z−30: about the middle, the neck goes from Z−150 to Z−120.
    let first = Run::new(bar()).rapid(40.0, 2.0).cut(42.0, 0.0).cut(42.0, -30.0).cut(52.0, -30.0);
    first.silent();
    let part = turned_about(&first.simulation.contours(), &bar(), 0.0);
    let stock = Stock { overhang: 149.0, ..bar() };
    let setup = Setup { part: Some(part), ..Setup::new(Lathe::default(), stock, turret()) };
    // The parting tool, programmed at its left corner, ends 1 mm above the neck, or 1 mm in the bar beside it.
    let down = |z: f64| Run::on(setup.clone()).tool(3).rapid(60.0, z).rapid(48.0, z);
    down(-124.0).silent();
    let alarm = down(-119.0).only(101);
    near(alarm.depth.unwrap(), 1.0, 1e-6);
    near(alarm.place[0], 48.0, 1e-6);
}

#[test]
fn the_back_of_a_tool_of_either_hand() {
    // From a groove of r 23 between Z−40 and Z−20 into its side. The 5°-edge rises by `r` to its end; above it the back of the
    // insert meets the side, whose middle there is this far above the edge that has come to stand at its foot.
    let r = 12.7 / sin(80.0) * sin(5.0);
    let deep = f64::midpoint(r, 2.0) * cos(5.0);
    let ring = [[-150.0, 0.0], [0.0, 0.0], [0.0, 25.0], [-20.0, 25.0], [-20.0, 23.0], [-40.0, 23.0], [-40.0, 25.0]];
    let part = || Some(vec![ring.into_iter().chain([[-150.0, 25.0]]).collect()]);
    let grooved = |tool: TurningTool| Run::on(Setup { part: part(), ..with(tool) });
    let right = |to: f64| grooved(rougher()).rapid(60.0, -39.0).rapid(46.0, -39.0).cut(46.0, to);
    let alarm = right(-20.0).only(102);
    near(alarm.depth.unwrap(), deep, 1e-5);
    assert_eq!(alarm.cause, Cause::BackInMetal);
    let left = |to: f64| grooved(leftward()).rapid(60.0, -21.0).rapid(46.0, -21.0).cut(46.0, to);
    let alarm = left(-40.0).only(102);
    near(alarm.depth.unwrap(), deep, 1e-5);
    // Each its own way cuts, the left-hand one away from the chuck.
    right(-60.0).silent();
    left(-5.0).silent();
    // An edge of 32° behind the nose cuts on the way back.
    Run::new(bar()).tool(2).rapid(60.0, -40.0).cut(48.0, -40.0).cut(48.0, -30.0).silent();
}

#[test]
fn the_auxiliary_edge_that_the_profile_runs_under() {
    // Down at 45°: the end of the 5°-edge, 12.9 mm from the nose, runs on a line aside of the nose's.
    let far = 12.7 / sin(80.0);
    let run = |by: f64| Run::on(with(rougher())).rapid(60.0, -30.0).cut(50.0, -30.0).cut(40.0, -30.0 - by);
    // Where the nose's line begins in the skin, the edge has cut 40° below it.
    let alarm = run(5.0).only(132);
    near(alarm.depth.unwrap(), 5.0 / sin(45.0) * tan(40_f64.to_radians()), 1e-5);
    let by = 5.0 * tan(40_f64.to_radians());
    at(alarm, [2.0 * (25.0 - by), -30.0 + by], 1e-5);
    // At 6° its end runs on a line beside the nose's.
    let deep = run(5.0 / tan(6.0_f64.to_radians())).only(132).depth.unwrap();
    near(deep, far * sin(1.0), 1e-5);
    // Into a surface that the nose has made it goes no deeper than the way, 2 mm, however far its end runs beside the nose's line.
    let shoulder = Run::on(with(rougher())).rapid(44.0, 2.0).cut(44.0, -30.0).cut(40.0, -32.0);
    near(shoulder.only(132).depth.unwrap(), 2.0 - 2.0 * tan(5_f64.to_radians()), 0.02);
    // Inside, with an edge of 32° behind the corner: 31° outwards is within, 60° is not.
    let cutter = Cutter::Insert { shape: Shape::D, circle: 9.525, main: 93.0, auxiliary: 32.0, nose: 0.0 };
    let holder = Holder::Bar { diameter: 8.0, length: 80.0, reach: 20.0 };
    let borer = || TurningTool { cutter, holder, ..tools::borer() };
    let bore = |angle: f64| {
        let setup = Setup { stock: Stock { bore: 30.0, ..bar() }, ..with(borer()) };
        let by = 8.0 / tan(angle.to_radians());
        Run::on(setup).rapid(28.0, 3.0).rapid(28.0, -10.0).cut(30.0, -10.0).cut(46.0, -10.0 - by)
    };
    bore(31.0).silent();
    near(bore(60.0).only(132).depth.unwrap(), 8.0 / sin(60.0) * tan(28_f64.to_radians()), 1e-5);
}

#[test]
fn a_descent_steeper_than_the_auxiliary_edge_into_bare_metal() {
    // 32° behind a nose of 0.4, 13° below the way of 45° and 4√2 mm: d from the nose's line where it begins.
    let ramp = |x: f64, by: f64| Run::new(bar()).tool(2).rapid(54.0, -10.0).cut(50.0, -10.0).cut(x, -10.0 - by);
    let (R, L, tan13) = (0.4, 4.0 * 2_f64.sqrt(), tan(13_f64.to_radians()));
    let d = R * cos(13.0) - R + (L + R * sin(13.0)) * tan13;
    let alarms = ramp(42.0, 4.0).cut(42.0, -40.0).cut(54.0, -40.0).raised();
    let [alarm] = alarms[..] else { panic!("{alarms:?}") };
    assert_eq!((alarm.cause.number(), alarm.motion), (132, 2));
    near(alarm.depth.unwrap(), d, 1e-5);
    // In two blocks it is as much; added up by samples beside the ends.
    let halves = Run::new(bar()).tool(2).rapid(54.0, -10.0).cut(50.0, -10.0).cut(46.0, -12.0).cut(42.0, -14.0);
    let alarms = halves.cut(42.0, -40.0).cut(54.0, -40.0).raised();
    let deepest = alarms.iter().filter_map(|alarm| alarm.depth).fold(0.0, f64::max);
    near(deepest, d, 0.02 * d);
    // Less steep, in and out again, straight in, or turned away at once: none.
    ramp(42.0, 8.0).cut(42.0, -40.0).cut(54.0, -40.0).silent();
    ramp(42.0, 4.0).cut(54.0, 2.0).silent();
    ramp(42.0, 0.0).cut(42.0, -40.0).cut(54.0, -40.0).silent();
    let away = ramp(42.0, 4.0).cut(42.0, -40.0).cut(54.0, -40.0).rapid(60.0, 2.0).rapid(42.0, 2.0);
    away.cut(42.0, -40.0).cut(54.0, -40.0).silent();
}

#[test]
fn a_holder_in_metal() {
    // The parting tool is 26 mm deep: 30 mm in, its shank is 4 mm under the skin of D 100.
    let stock = Stock { overhang: 100.0, ..Stock::bar(100.0, 150.0) };
    let deep = |x: f64| Run::new(stock).tool(3).rapid(104.0, -20.0).cut(x, -20.0);
    let alarm = deep(40.0).only(103);
    near(alarm.depth.unwrap(), 4.0, 1e-6);
    near(alarm.place[0], 92.0, 1e-6);
    deep(48.0).silent();
    deep(47.9).only(103);
    // While it parts, the piece is still there beside the shank, until the cut comes through.
    let part = |depth: f64| {
        let cutter = Cutter::Groover { width: 3.0, depth, corner: 0.2, face: false };
        Run::on(with(TurningTool { cutter, ..tools::parter() })).rapid(54.0, -10.0).cut(-0.5, -10.0)
    };
    assert_eq!(part(26.0).alarms(), [191]);
    let alarms = part(20.0).raised();
    assert_eq!(alarms.iter().map(|alarm| alarm.cause.number()).collect::<Vec<_>>(), [103, 191]);
    near(alarms[0].depth.unwrap(), 5.25, 1e-6);
}

#[test]
fn the_depth_of_cut_outside_and_of_a_thread_on_a_cone() {
    let stock = Stock { overhang: 100.0, ..Stock::bar(80.0, 150.0) };
    // The sharp main edge is 12.9 mm long at 85° from the motion.
    let edge = 12.7 / sin(80.0) * sin(85.0);
    let cut = |deep: f64| {
        let setup = Setup { stock, ..with(rougher()) };
        Run::on(setup).rapid(80.0 - 2.0 * deep, 2.0).cut(80.0 - 2.0 * deep, -20.0)
    };
    cut(edge - 0.01).silent();
    let alarm = cut(edge + 0.01).only(131);
    near(alarm.depth.unwrap(), edge + 0.01, 1e-5);
    let Cause::DepthOfCut { edge: has, .. } = alarm.cause else { panic!("{alarm:?}") };
    near(has, edge, 1e-5);
    // The profile of the thread is 2.5 mm deep. On the cone from r0 up 3 mm in 25, its first tooth in metal stands at Z−1,
    // two leads of 3 mm from the start at Z5.
    let deepest = |r: f64| 25.0 - (r + 3.0 * 6.0 / 25.0);
    let thread = |r: f64| Run::new(bar()).tool(4).rapid(2.0 * r, 5.0).thread(2.0 * r + 6.0, -20.0, 3.0);
    let shallow = 25.0 - 3.0 * 6.0 / 25.0 - 2.45;
    // In one pass.
    thread(shallow).only(149);
    near(thread(shallow - 0.1).only(131).depth.unwrap(), deepest(shallow - 0.1), 1e-6);
}

#[test]
fn threads_without_a_lead_out_of_the_inserts_and_of_another_lead() {
    let pass = |run: Run, x: f64, lead: f64| run.rapid(x, 5.0).thread(x, -20.0, lead);
    let back = |run: Run| run.rapid(60.0, -20.0).rapid(60.0, 5.0);
    let first = |lead: f64| pass(Run::new(bar()).tool(4).rapid(60.0, 5.0), 49.6, lead);
    at(first(0.0).only(141), [49.6, 5.0], 1e-9);
    at(first(3.01).only(142), [49.6, 5.0], 1e-9);
    at(first(0.49).only(142), [49.6, 5.0], 1e-9);
    first(0.5).silent();
    first(3.0).silent();
    let second = |lead: f64| pass(back(first(2.0)), 49.2, lead);
    let alarm = second(1.5).only(143);
    at(alarm, [49.2, 5.0], 1e-9);
    assert_eq!(alarm.cause, Cause::LeadDiffers { lead: 1.5, before: 2.0 });
    second(2.0).silent();
    let other = |tool: u32, x: f64| Run::new(bar()).tool(tool).rapid(60.0, 5.0).rapid(x, 5.0).thread(x, -20.0, 2.0);
    at(other(9, 49.8).only(144), [49.8, 5.0], 1e-9);
    other(9, 50.0).silent();
}

#[test]
fn the_spindle_and_its_speed() {
    let cut = |speed: Speed, spindle: Spindle, most: Option<f64>, x: f64| {
        let mut run = Run::new(bar());
        (run.control.speed, run.control.spindle, run.control.greatest_speed) = (speed, spindle, most);
        run.rapid(54.0, -1.0).cut(x, -1.0)
    };
    let n = Speed::Revolutions;
    let clockwise = Spindle::Clockwise;
    // V = 200 m/min asks for 3000 rpm, the machine's most, at D 21.22.
    let d = 200_000.0 / (PI * 3000.0);
    let alarm = cut(Speed::Surface(200.0), clockwise, None, d - 0.01).only(151);
    at(alarm, [d - 0.01, -1.0], 1e-9);
    let Cause::NoGreatestSpeed { asked, most } = alarm.cause else { panic!("{alarm:?}") };
    near(asked, 200_000.0 / (PI * (d - 0.01)), 1e-6);
    near(most, 3000.0, 0.0);
    cut(Speed::Surface(200.0), clockwise, None, d + 0.01).silent();
    cut(Speed::Surface(200.0), clockwise, Some(3000.0), -1.6).silent();
    cut(n(3000.0), clockwise, None, 40.0).silent();
    let mut fast = Run::new(bar());
    fast.control.speed = n(3001.0);
    at(fast.rapid(54.0, 2.0).only(152), [54.0, 2.0], 1e-9);
    // Metal is met at the skin, D 50.
    for (speed, spindle, number) in
        [(n(1000.0), Spindle::Stopped, 153), (n(0.0), clockwise, 153), (n(1000.0), Spindle::CounterClockwise, 154)]
    {
        let alarm = cut(speed, spindle, None, 40.0).only(number);
        assert!(alarm.place[0] <= 50.0 + 1e-6 && (-1.01..=0.01).contains(&alarm.place[1]), "{alarm:?}");
        cut(speed, spindle, None, 50.0).silent();
    }
    cut(n(1000.0), clockwise, None, 40.0).silent();
}

#[test]
fn the_way_of_the_spindle_by_hand_and_by_the_side_of_the_turret() {
    let other = |spindle| match spindle {
        Spindle::Clockwise => Spindle::CounterClockwise,
        _ => Spindle::Clockwise,
    };
    let neutral = || TurningTool { hand: Hand::Neutral, ..rougher() };
    let (m3, m4) = (Spindle::Clockwise, Spindle::CounterClockwise);
    let left = || TurningTool { hand: Hand::Left, ..rougher() };
    let given = |spindle| TurningTool { turns: Some(spindle), ..neutral() };
    for (tool, behind, right) in [
        (rougher(), false, Some(m3)),
        (rougher(), true, Some(m3)),
        (left(), false, Some(m4)),
        (left(), true, Some(m4)),
        (neutral(), false, None),
        (neutral(), true, None),
        (given(m3), true, Some(m3)),
        (given(m4), true, Some(m4)),
        (given(m4), false, Some(m4)),
    ] {
        let cut = |spindle: Spindle| {
            let lathe = Lathe { turret_behind: behind, ..Lathe::default() };
            let mut run = Run::on(Setup { lathe, ..with(tool.clone()) });
            run.control.spindle = spindle;
            run.rapid(46.0, 2.0).cut(46.0, -20.0)
        };
        let Some(right) = right else {
            // Its own mirror image, it may lie either face up.
            [m3, m4].map(cut).iter().for_each(Run::silent);
            cut(Spindle::Stopped).only(153);
            continue;
        };
        cut(right).silent();
        assert_eq!(cut(other(right)).only(154).cause, Cause::SpindleWrongWay, "{:?} {behind}", tool.hand);
    }
    // A drill cuts with M3 on either side.
    for behind in [false, true] {
        let drill = |spindle: Spindle| {
            let lathe = Lathe { turret_behind: behind, ..Lathe::default() };
            let mut run = Run::on(Setup::new(lathe, bar(), turret())).tool(6);
            run.control.spindle = spindle;
            run.rapid(0.0, 3.0).cut(0.0, -10.0)
        };
        drill(m3).silent();
        drill(m4).only(154);
    }
}

#[test]
fn coolant_feed_tool_axis_and_a_piece_that_falls_off() {
    let dry = |x: f64| {
        let mut run = Run::new(bar());
        run.control.coolant = false;
        run.rapid(x, 2.0).cut(x, -20.0)
    };
    let alarm = dry(46.0).only(161);
    assert!((46.0..=50.0).contains(&alarm.place[0]) && (-20.0..=0.0).contains(&alarm.place[1]), "{alarm:?}");
    dry(50.0).silent();
    let still = |feed: f64| {
        let mut run = Run::new(bar()).rapid(54.0, 2.0);
        run.feed = feed;
        run.cut(54.0, -20.0)
    };
    at(still(0.0).only(171), [54.0, 2.0], 1e-9);
    still(0.01).silent();
    at(Run::new(bar()).tool(12).rapid(46.0, 2.0).only(181), [200.0, 50.0], 1e-9);
    Run::new(bar()).tool(0).rapid(46.0, 2.0).silent();
    // The drill's line is off the axis by 0.0011 mm, and by what counts as contact.
    let beside = |r: f64| Run::new(bar()).tool(6).rapid(2.0 * r, 3.0).cut(2.0 * r, -10.0);
    beside(0.0009).silent();
    beside(0.0011).only(182);
    beside(-0.0011).only(182);
    // Parted at Z−10 with 3 mm: 7 mm of the bar fall off.
    let part = |x: f64| Run::new(bar()).tool(3).rapid(54.0, -10.0).cut(x, -10.0);
    let alarm = part(-0.5).only(191);
    let Cause::PartedOff(volume) = alarm.cause else { panic!("{alarm:?}") };
    near(volume, PI * 25.0 * 25.0 * 7.0, 0.01);
    at(alarm, [-0.5, -10.0], 1e-9);
    assert_eq!(alarm.cause.grade(), Grade::Note);
    part(0.5).silent();
    // Of a tube only its wall has to go.
    let tube = |x: f64| Run::new(Stock { bore: 20.0, ..bar() }).tool(3).rapid(54.0, -10.0).cut(x, -10.0);
    let Cause::PartedOff(volume) = tube(19.5).only(191).cause else { panic!() };
    near(volume, PI * (25.0 * 25.0 - 10.0 * 10.0) * 7.0, 0.01);
    tube(20.5).silent();
}

#[test]
fn the_end_of_travel_along_both_axes_and_on_an_arc() {
    // The reference point stands 60 mm above the tip, and W1 at Z240 of the machine.
    let lathe = || Lathe { travel_x: [55.0, 200.0], travel_z: [100.0, 400.0], bent_rapid: false, ..Lathe::default() };
    let run = || Run::on(Setup::new(lathe(), bar(), turret()));
    for (x, z, over, place) in [
        (280.02, 20.0, 0.01, [280.02, 20.0]),
        (60.0, 160.01, 0.01, [60.0, 160.01]),
        (60.0, -140.5, 0.5, [60.0, -140.5]),
        (-10.5, 20.0, 0.25, [-10.5, 20.0]),
    ] {
        let past = run().rapid(x, z).raised();
        let past: Vec<_> = past.iter().filter(|alarm| alarm.cause.number() == 121).collect();
        assert_eq!(past.len(), 1, "{x} {z}");
        near(past[0].depth.unwrap(), over, 1e-9);
        at(*past[0], place, 1e-9);
    }
    run().rapid(280.0, 20.0).silent();
    run().rapid(60.0, 160.0).silent();
    // A half circle of 10 mm outwards from Z140 ends where it began along X, and bulges to Z150 or past Z160.
    let arc = |z: f64| run().rapid(60.0, z).arc(100.0, z, [80.0, z], 180.0);
    arc(150.0).silent();
    let alarm = arc(150.5).only(121);
    near(alarm.depth.unwrap(), 0.5, 2e-4);
    near(alarm.place[1], 160.5, 2e-4);
    let away = hypot(alarm.place[0] / 2.0 - 40.0, alarm.place[1] - 150.5);
    near(away, 10.0, 2e-4);
}
