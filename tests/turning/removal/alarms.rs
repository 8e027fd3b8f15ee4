//! Each alarm is raised by one program, and not by its nearest legal neighbour.

use super::lathe::{Run, bar, turret};
use super::tools;
use rodete::finding::Grade;
use rodete::gcode::in_force::{Speed, Spindle};
use rodete::number::trig::{sin_cos, tan};
use rodete::removal::turning::machine::Lathe;
use rodete::removal::turning::outline::Role;
use rodete::removal::turning::simulation::Setup;
use rodete::removal::turning::stock::{Stock, Support};
use rodete::removal::turning::tool::{Cutter, Holder, Shape, TurningTool};

#[track_caller]
fn raised(run: &Run, number: u16) -> rodete::removal::turning::alarm::Alarm {
    let alarms = run.raised();
    let found = alarms.iter().find(|alarm| alarm.cause.number() == number);
    *found.unwrap_or_else(|| panic!("{number} is not among {alarms:?}"))
}

#[track_caller]
fn silent(run: &Run) {
    run.silent();
}

#[test]
fn a_rapid_motion_through_metal_is_told_from_one_along_it() {
    // Along the bar's surface, along the face, and back over a turned surface.
    let legal = Run::new(bar()).rapid(50.0, 2.0).rapid(50.0, -30.0).rapid(60.0, 2.0).rapid(60.0, 0.0).rapid(0.0, 0.0);
    silent(&legal);
    silent(&legal.rapid(0.0, 2.0).rapid(46.0, 2.0).cut(46.0, -30.0).rapid(46.0, 2.0));
    let crash = Run::new(bar()).rapid(49.99, 2.0).rapid(49.99, -30.0);
    let alarm = raised(&crash, 101);
    assert!((alarm.depth.unwrap() - 0.005).abs() < 1e-9, "{alarm:?}");
    assert_eq!((alarm.line, alarm.cause.grade()), (2, Grade::Stop));
    assert!(alarm.place[1] <= 0.0 && alarm.place[1] >= -30.0 && (alarm.place[0] - 50.0).abs() < 0.02, "{alarm:?}");
    assert!(crash.last().removed.volume > 0.0, "what a rapid motion hits is gone");
    // The bend of a rapid motion: straight it passes beside the corner of the bar; bent, with X the faster, it goes into it.
    let over = |bent: bool| {
        let lathe = Lathe { bent_rapid: bent, rapid: [10_000.0, 5000.0], ..Lathe::default() };
        Run::on(Setup::new(lathe, bar(), turret())).rapid(120.0, -40.0).rapid(20.0, 20.0)
    };
    silent(&over(false));
    assert!(over(true).alarms().contains(&101));
}

#[test]
fn the_back_of_the_insert_is_told_from_its_edges() {
    // A tool that cuts towards the chuck, driven away from it.
    // On its way in, 2 mm deep, it is in metal wider than its edge of 12.9 mm; on its way back its back runs into metal, and
    // no edge that cuts looks ahead.
    let back = Run::new(bar()).rapid(60.0, -40.0).cut(46.0, -40.0);
    assert_eq!(back.alarms(), [131]);
    assert_eq!(back.cut(46.0, -20.0).alarms(), [131, 102]);
    silent(&Run::new(bar()).rapid(46.0, 2.0).cut(46.0, -20.0).cut(54.0, -20.0));
    // Facing inwards is done over the auxiliary edge.
    silent(&Run::new(bar()).rapid(54.0, -1.0).cut(-1.6, -1.0));
}

#[test]
fn a_cut_deeper_than_the_edge_is_told_from_one_as_deep() {
    let stock = Stock { overhang: 100.0, ..Stock::bar(80.0, 150.0) };
    // The main edge of 12.9 mm at 95° reaches 12 mm across the feed, its far corner rounded.
    silent(&Run::new(stock).rapid(57.0, 2.0).cut(57.0, -20.0));
    let deep = Run::new(stock).rapid(54.0, 2.0).cut(54.0, -20.0);
    let alarm = raised(&deep, 131);
    assert!((alarm.depth.unwrap() - 13.0).abs() < 1e-6, "{alarm:?}");
}

#[test]
fn a_profile_out_of_the_auxiliary_edges_reach_is_told_from_one_within() {
    // The finishing tool has 32° behind its nose: 25° down is within, 50° is not.
    let down = |angle: f64| {
        let deep = 20.0 * rodete::number::trig::tan(angle.to_radians()).min(0.4);
        let long = deep / rodete::number::trig::tan(angle.to_radians());
        Run::new(bar()).tool(2).rapid(52.0, -10.0).cut(50.0, -10.0).cut(50.0 - 2.0 * deep, -10.0 - long)
    };
    silent(&down(20.0));
    silent(&down(30.0));
    let alarm = raised(&down(50.0), 132);
    assert!(alarm.depth.unwrap() > 1.0, "{alarm:?}");
    assert_eq!(alarm.cause.grade(), Grade::Caution);
}

#[test]
fn a_holder_in_metal_is_told_from_one_beside_it() {
    // The parting tool reaches 26 mm: on a bar of D 100 it goes 25 mm in, not 30.
    let stock = Stock { overhang: 100.0, ..Stock::bar(100.0, 150.0) };
    silent(&Run::new(stock).tool(3).rapid(104.0, -20.0).cut(50.0, -20.0).rapid(104.0, -20.0));
    let deep = Run::new(stock).tool(3).rapid(104.0, -20.0).cut(40.0, -20.0);
    let alarm = raised(&deep, 103);
    assert!((alarm.depth.unwrap() - 4.0).abs() < 0.01, "{alarm:?}");
    // The bar of 16 mm with its centre 11 mm behind the tip goes into a hole of 20 mm, not of 18.
    silent(
        &Run::new(bar())
            .tool(6)
            .rapid(0.0, 3.0)
            .cut(0.0, -40.0)
            .rapid(0.0, 30.0)
            .tool(7)
            .rapid(20.0, 3.0)
            .cut(20.0, -30.0),
    );
    // At rapid, where it turns nothing.
    let narrow = Run::new(Stock { bore: 18.0, ..bar() }).tool(7).rapid(17.9, 3.0).rapid(17.9, -30.0);
    assert_eq!(narrow.alarms(), [103]);
}

#[test]
fn chuck_jaws_and_tailstock_are_told_from_the_room_beside_them() {
    // The jaws end at Z-100.
    silent(&Run::new(bar()).tool(3).rapid(60.0, -97.0).cut(46.0, -97.0).rapid(60.0, -97.0).rapid(60.0, -99.9));
    let jaws = Run::new(bar()).rapid(60.0, -90.0).rapid(60.0, -101.0);
    let alarm = raised(&jaws, 112);
    assert!((alarm.depth.unwrap() - 1.0).abs() < 1e-6, "{alarm:?}");
    assert_eq!(alarm.cause.grade(), Grade::Stop);
    let chuck = Run::new(bar()).rapid(200.0, -90.0).rapid(200.0, -141.0);
    raised(&chuck, 111);
    // Facing to the axis is free without the tailstock, and hits its centre with it.
    let face = |support: Support| Run::new(Stock { support, ..bar() }).rapid(64.0, -1.0).cut(2.0, -1.0);
    silent(&face(Support::ByOverhang));
    raised(&face(Support::Always), 113);
    let long = Stock { overhang: 160.0, ..Stock::bar(50.0, 200.0) };
    assert!(long.supported(&Lathe::default()) && !bar().supported(&Lathe::default()));
}

#[test]
fn what_the_auxiliary_edge_takes_of_the_surface_just_made_is_told_from_what_it_may_cut() {
    // φ2 = 52°, R 0.4: the cylinder of D 46 is made up to Z−9.6, below the nose's centre. At the end of the way inwards that
    // centre stands at Z−10.1, r 20.4, and the edge 0.4 beside it.
    let steep = |z: f64| {
        Run::new(bar()).tool(8).rapid(46.0, 2.0).cut(46.0, -10.0).cut(40.0, z).cut(40.0, -20.0).cut(54.0, -20.0)
    };
    let alarm = raised(&steep(-10.5), 132);
    // The nose's way is (−0.5, −3), and what it sweeps ends on a line 0.4 beside its centres. Where that comes through r 23 the
    // edge is deepest below the cylinder.
    let (sin, cos) = sin_cos(52.0_f64.to_radians());
    let long = 9.25_f64.sqrt();
    let z = -9.6 + 0.4 * 3.0 / long + (23.0 - (23.4 - 0.4 * 0.5 / long)) * 0.5 / 3.0;
    let right = 23.0 - (20.4 - 0.4 * cos + (z - (-10.1 + 0.4 * sin)) * sin / cos);
    assert!((alarm.depth.unwrap() - right).abs() < 0.005, "{:?} {right}", alarm.depth);
    assert!((alarm.place[0] - 46.0).abs() < 1e-6 && (alarm.place[1] - z).abs() < 0.001, "{:?} {z}", alarm.place);
    // 50 degrees.
    silent(&steep(-10.0 - 3.0 / tan(50.0_f64.to_radians())));
    // An arc inwards that gets steeper than the edge.
    let arc = Run::new(bar()).tool(8).rapid(46.0, 2.0).cut(46.0, -10.0).arc(36.0, -15.0, [36.0, -10.0], 90.0);
    assert!(arc.alarms().contains(&132), "{:?}", arc.alarms());
    // Facing with the same edge, from the outside and from a cut within.
    silent(&Run::new(bar()).tool(1).rapid(54.0, -1.0).cut(20.0, -1.0));
    silent(&Run::new(bar()).tool(1).rapid(44.0, 2.0).cut(44.0, -1.0).cut(20.0, -1.0));
}

#[test]
fn the_auxiliary_edges_mark_that_a_later_motion_takes_away_is_none() {
    // In by 0.25 mm and back along the part: the surface that the edge stands in is cut 0.25 mm deeper.
    let inwards = || Run::new(bar()).rapid(46.0, 2.0).cut(46.0, -20.0).cut(45.5, -20.0);
    let back = |z: f64| inwards().cut(45.5, z);
    silent(&back(2.0));
    // Without the way back the edge of 5° stays as a slope in that surface; told of the block that left it.
    let alarm = inwards().rapid(60.0, 10.0).raised();
    assert_eq!(alarm.iter().map(|alarm| (alarm.cause.number(), alarm.line)).collect::<Vec<_>>(), [(132, 3)]);
    // The nose, R 0.8, covers what is beside its centre in the cylinder; from there on the edge lies this deep.
    let (sin, cos) = sin_cos(5.0_f64.to_radians());
    let beside = (0.8_f64 * 0.8 - 0.55 * 0.55).sqrt();
    let right = 0.25 - (0.8 * (1.0 - cos) + (beside - 0.8 * sin) * sin / cos);
    assert!((alarm[0].depth.unwrap() - right).abs() < 1e-4, "{alarm:?} {right}");
    // So it does where the way back ends in it.
    assert_eq!(raised(&back(-16.0), 132).line, 4);
    // It is gone where another tool finishes the surface after it, and where the piece with the mark is parted off it is on that
    // piece.
    silent(&inwards().rapid(60.0, 10.0).tool(2).rapid(44.0, 2.0).cut(44.0, -25.0));
    let parted = |run: Run| run.rapid(60.0, 10.0).tool(3).rapid(60.0, -40.0).cut(-0.5, -40.0);
    assert_eq!(parted(inwards()).alarms(), [191, 132]);
    assert_eq!(parted(back(2.0)).alarms(), [191]);
}

#[test]
fn a_boring_bar_goes_no_deeper_than_it_is_long() {
    let tube = || Run::new(Stock { bore: 24.0, ..bar() }).tool(7).rapid(26.0, 2.0);
    let Holder::Bar { length, .. } = tube().simulation.setup().turret.tools[&7].holder else { panic!("no bar") };
    silent(&tube().cut(26.0, 0.05 - length));
    let alarm = raised(&tube().cut(26.0, -length - 5.0), 104);
    assert!((alarm.depth.unwrap() - 5.0).abs() < 1e-6, "{:?}", alarm.depth);
}

#[test]
fn the_turret_is_watched_where_it_has_a_body() {
    let mut setup = Setup::new(Lathe::default(), bar(), turret());
    // Its lower edge stands 10 mm farther out than the tip, and it reaches from level with the tip to the right.
    setup.turret.body = Some([[0.0, -50.0], [100.0, 200.0]]);
    let groove = |x: f64| Run::on(setup.clone()).tool(3).rapid(54.0, -40.0).cut(x, -40.0);
    silent(&groove(30.0));
    let alarm = raised(&groove(26.0), 104);
    assert!((alarm.depth.unwrap() - 2.0).abs() < 1e-6, "{alarm:?}");
}

#[test]
fn the_end_of_travel_is_told_from_what_is_past_it() {
    let lathe = || Lathe { travel_x: [55.0, 200.0], travel_z: [100.0, 400.0], ..Lathe::default() };
    let run = || Run::on(Setup::new(lathe(), bar(), turret()));
    // X280 puts the reference point, 60 mm farther out, on 200.
    silent(&run().rapid(280.0, 20.0));
    let alarm = raised(&run().rapid(282.5, 20.0), 121);
    assert!((alarm.depth.unwrap() - 1.25).abs() < 1e-9, "{alarm:?}");
    let arc = run().rapid(60.0, 155.0).arc(60.0, 155.0, [40.0, 155.0], 180.0);
    assert!(!arc.alarms().contains(&121));
    assert!(run().rapid(60.0, 161.0).alarms().contains(&121));
    let both = run().rapid(300.0, 161.0);
    assert_eq!(both.alarms().iter().filter(|number| **number == 121).count(), 2, "each axis");
}

#[test]
fn a_spindle_that_does_not_serve_the_tool_is_told_once() {
    let cut = |spindle: Spindle, place: u32| {
        let mut run = Run::new(bar()).tool(place);
        run.control.spindle = spindle;
        run.rapid(46.0, 2.0).cut(46.0, -20.0).rapid(48.0, 2.0).rapid(44.0, 2.0).cut(44.0, -20.0)
    };
    silent(&cut(Spindle::Clockwise, 1));
    for (spindle, number) in [(Spindle::Stopped, 153), (Spindle::CounterClockwise, 154)] {
        let run = cut(spindle, 1);
        assert_eq!(run.alarms(), [number]);
        assert_eq!(raised(&run, number).cause.grade(), Grade::Stop);
    }
    let mut still = Run::new(bar());
    still.control.speed = Speed::Revolutions(0.0);
    assert_eq!(still.rapid(46.0, 2.0).cut(46.0, -20.0).alarms(), [153], "S0 is no speed");
    // A left-hand tool that feeds towards the chuck wants the other way; a stopped spindle out of the cut is fine.
    let mut setup = Setup::new(Lathe::default(), bar(), turret());
    setup.turret.tools.get_mut(&1).unwrap().hand = rodete::removal::turning::tool::Hand::Left;
    let mut left = Run::on(setup);
    left.control.spindle = Spindle::CounterClockwise;
    silent(&left.rapid(46.0, 2.0).cut(46.0, -20.0));
    let mut air = Run::new(bar());
    air.control.spindle = Spindle::Stopped;
    silent(&air.rapid(54.0, 2.0).cut(54.0, -20.0));
}

#[test]
fn beyond_the_axis_the_spindle_has_to_turn_the_other_way() {
    let wrong = |spindle: Spindle, x: f64| {
        let mut setup = Setup::new(Lathe::default(), bar(), turret());
        let blade = Cutter::Groover { width: 3.0, depth: 10.0, corner: 0.2, face: true };
        setup.turret.tools.get_mut(&3).unwrap().cutter = blade;
        let mut run = Run::on(setup).tool(3);
        run.control.spindle = spindle;
        let run = run.rapid(x, 2.0).cut(x, -4.0);
        assert!(run.steps[1].removed.volume > 1.0, "it cuts");
        run.alarms().contains(&154)
    };
    let (M3, M4) = (Spindle::Clockwise, Spindle::CounterClockwise);
    assert_eq!([wrong(M3, 30.0), wrong(M4, 30.0)], [false, true]);
    assert_eq!([wrong(M3, -30.0), wrong(M4, -30.0)], [true, false]);
    // Facing a little over the axis is one cut, and not judged anew.
    silent(&Run::new(bar()).tool(1).rapid(54.0, -0.5).cut(-1.6, -0.5));
}

#[test]
fn a_cut_this_side_of_the_axis_with_the_programmed_point_beyond_it_is_judged_as_one_this_side() {
    let (M3, M4) = (Spindle::Clockwise, Spindle::CounterClockwise);
    let wrong = |spindle: Spindle, run: fn(Run) -> Run, tool: TurningTool, bore: f64| {
        let mut setup = Setup::new(Lathe::default(), Stock { bore, ..bar() }, turret());
        setup.turret.tools.insert(1, tool);
        let mut start = Run::on(setup);
        start.control.spindle = spindle;
        let run = run(start);
        assert!(run.last().cuts(), "it cuts");
        run.alarms().contains(&154)
    };
    // Faced to 0.2 mm beyond, and on at another feed: the nose of R 0.8 has not left this side.
    let faced: fn(Run) -> Run = |run| run.rapid(54.0, -1.0).cut(-0.4, -1.0).cut(-1.6, -1.0);
    // A round insert of 8 mm plunges with its centre on the axis, and 0.1 mm beyond.
    let round = || {
        let cutter = Cutter::Insert { shape: Shape::R, circle: 8.0, main: 0.0, auxiliary: 0.0, nose: 4.0 };
        TurningTool { cutter, ..tools::rougher() }
    };
    let plunged: fn(Run) -> Run = |run| run.rapid(-8.0, 5.0).cut(-8.0, -2.0);
    let past: fn(Run) -> Run = |run| run.rapid(-8.2, 5.0).cut(-8.2, -2.0);
    // The other side of a bore, and of the solid, where the insert's back reaches over the axis: a cut beyond it.
    let bored: fn(Run) -> Run = |run| run.rapid(-31.0, 5.0).cut(-31.0, -10.0);
    for (run, tool, bore, told) in [
        (faced, tools::rougher(), 0.0, [false, true]),
        (plunged, round(), 0.0, [false, true]),
        (past, round(), 0.0, [false, true]),
        (bored, tools::rougher(), 28.0, [true, false]),
        (bored, tools::rougher(), 0.0, [true, false]),
    ] {
        assert_eq!([M3, M4].map(|spindle| wrong(spindle, run, tool.clone(), bore)), told);
    }
}

#[test]
fn no_coolant_in_the_cut_is_a_note() {
    let mut run = Run::new(bar());
    run.control.coolant = false;
    let run = run.rapid(46.0, 2.0).cut(46.0, -20.0);
    assert_eq!(run.alarms(), [161]);
    assert_eq!(raised(&run, 161).cause.grade(), Grade::Note);
}

#[test]
fn a_constant_surface_speed_without_a_limit_near_the_axis_is_cautioned() {
    let face = |most: Option<f64>, to: f64| {
        let mut run = Run::new(bar());
        run.control.speed = Speed::Surface(200.0);
        run.control.greatest_speed = most;
        run.rapid(54.0, -1.0).cut(to, -1.0)
    };
    // 200 m/min are 3000 rpm at D 21.2.
    silent(&face(None, 22.0));
    silent(&face(Some(2000.0), 0.0));
    assert_eq!(face(None, 20.0).alarms(), [151]);
    let limited = face(Some(2000.0), 0.0);
    assert!((limited.last().speed[1] - 2000.0).abs() < 1e-9);
    let mut fast = Run::new(bar());
    fast.control.speed = Speed::Revolutions(3500.0);
    assert_eq!(fast.rapid(54.0, 2.0).alarms(), [152]);
}

#[test]
fn a_feed_of_nothing_and_a_tool_that_is_not_there_stop() {
    let mut run = Run::new(bar());
    run.feed = 0.0;
    assert!(run.rapid(46.0, 2.0).cut(46.0, -20.0).alarms().contains(&171));
    let missing = Run::new(bar()).tool(12).rapid(46.0, 2.0).cut(46.0, -20.0);
    assert_eq!(missing.alarms(), [181]);
    assert!(missing.last().removed.volume == 0.0);
}

#[test]
fn a_drill_beside_the_axis_stops() {
    silent(&Run::new(bar()).tool(6).rapid(0.0, 3.0).cut(0.0, -10.0));
    assert!(Run::new(bar()).tool(6).rapid(0.2, 3.0).cut(0.2, -10.0).alarms().contains(&182));
}

#[test]
fn threads_are_held_against_the_insert_and_their_earlier_passes() {
    let passes = |leads: &[f64]| {
        let mut run = Run::new(bar()).tool(4).rapid(60.0, 5.0);
        for (pass, &lead) in (1..).zip(leads) {
            run = run
                .rapid(50.0 - 0.2 * f64::from(pass), 5.0)
                .thread(50.0 - 0.2 * f64::from(pass), -20.0, lead)
                .rapid(60.0, -20.0);
            run = run.rapid(60.0, 5.0);
        }
        run
    };
    silent(&passes(&[2.0, 2.0, 2.0]));
    assert_eq!(passes(&[2.0, 1.5, 2.0]).alarms(), [143]);
    assert!(passes(&[4.0]).alarms().contains(&142));
    assert!(passes(&[0.0]).alarms().contains(&141));
    let wrong = Run::new(bar()).tool(9).rapid(49.8, 5.0).thread(49.8, -20.0, 2.0);
    assert!(wrong.alarms().contains(&144), "{:?}", wrong.alarms());
    // The profile is 2.5 mm deep.
    let deep = Run::new(bar()).tool(4).rapid(60.0, 5.0).rapid(44.0, 5.0).thread(44.0, -20.0, 3.0);
    assert_eq!(deep.alarms(), [131]);
}

#[test]
fn alarms_read_in_both_languages_with_number_place_and_remedy() {
    let run = Run::new(bar()).rapid(46.0, -30.0).rapid(46.0, -120.0);
    assert!(run.alarms().contains(&101) && run.alarms().contains(&112), "{:?}", run.alarms());
    for alarm in run.steps.iter().flat_map(|step| &step.alarms) {
        let finding = alarm.finding();
        for text in [&finding.what.es, &finding.what.en] {
            assert!(text.starts_with(&alarm.cause.number().to_string()) && text.contains(" X"), "{text}");
        }
        assert!(!finding.remedy.is_empty() && finding.what.es != finding.what.en);
    }
}

/// The chords of a nose are as far off it as the tolerance lets them be: they cut none the less, and nothing else begins to.
#[test]
fn a_tool_cuts_with_the_same_edges_whatever_the_tolerance_of_its_arcs() {
    let round = TurningTool {
        cutter: Cutter::Insert { shape: Shape::R, circle: 12.0, main: 90.0, auxiliary: 0.0, nose: 0.0 },
        ..tools::rougher()
    };
    let blunt = TurningTool {
        cutter: Cutter::Groover { width: 8.0, depth: 26.0, corner: 3.0, face: false },
        ..tools::parter()
    };
    let wide = TurningTool {
        cutter: Cutter::Insert { shape: Shape::C, circle: 12.7, main: 95.0, auxiliary: 5.0, nose: 2.4 },
        ..tools::rougher()
    };
    let all =
        [tools::rougher(), tools::profiler(), tools::copier(), tools::parter(), tools::threader(), tools::borer()];
    for tool in all.into_iter().chain([round, blunt, wide]) {
        // How long the edges are that do not cut.
        let backs = |tolerance: f64| -> f64 {
            let outline = tool.outline(tolerance, false).unwrap();
            let part = &outline.cutter[0];
            let corners: Vec<[f64; 2]> = part.polygon.corners().iter().map(|corner| corner.mm()).collect();
            let edges = corners.iter().zip(corners.iter().cycle().skip(1)).zip(&part.roles);
            let backs = edges.filter(|(_, role)| **role == Role::Back);
            backs.map(|(([z1, r1], [z2, r2]), _)| (z2 - z1).hypot(r2 - r1)).sum()
        };
        let usual = backs(0.0002);
        for tolerance in [1e-5, 0.001, 0.002, 0.003, 0.005, 0.01, 0.03, 0.1] {
            let found = backs(tolerance);
            assert!((found - usual).abs() < 0.03, "{}: {usual} became {found} at {tolerance}", tool.name.en);
        }
    }
}

#[test]
fn the_widest_tolerance_of_arcs_raises_no_alarm_of_its_own() {
    for tolerance in [0.0002, 0.003, 0.01] {
        let run = || Run::on(Setup { tolerance, ..Setup::new(Lathe::default(), bar(), turret()) });
        silent(&run().rapid(54.0, -1.0).cut(-1.6, -1.0));
        silent(&run().rapid(46.0, 2.0).cut(46.0, -20.0).cut(54.0, -20.0));
        let back = run().rapid(60.0, -40.0).cut(46.0, -40.0);
        assert_eq!(back.cut(46.0, -20.0).alarms(), [131, 102], "{tolerance}");
    }
}
