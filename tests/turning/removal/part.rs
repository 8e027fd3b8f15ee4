//! Parting, threads, set-ups, edits and the mesh.

use std::collections::HashMap;
use std::f64::consts::PI;

use super::lathe::{Run, bar, turret};
use super::tools;
use rodete::geometry::revolution::volume;
use rodete::removal::turning::machine::Lathe;
use rodete::removal::turning::mesh::{sectors, write_stl};
use rodete::removal::turning::simulation::Setup;
use rodete::removal::turning::stock::{Stock, turned_about};
use rodete::removal::turning::tool::{Cutter, Hand, Shape, Tip, TurningTool};

#[test]
fn what_is_parted_off_falls_and_is_counted() {
    let run = Run::new(bar()).tool(3).rapid(54.0, -23.0).cut(-1.0, -23.0).rapid(54.0, -23.0);
    let all = &run.simulation.totals().all;
    assert!((all.parted / (PI * 625.0 * 20.0) - 1.0).abs() < 0.001, "{}", all.parted);
    let left = run.simulation.volume();
    assert!(((all.parted + all.volume + left) / (PI * 625.0 * 150.0) - 1.0).abs() < 1e-9);
    assert!((left / (PI * 625.0 * 127.0) - 1.0).abs() < 1e-3);
    assert_eq!(run.simulation.contours().len(), 1);
    assert_eq!(run.alarms(), [191]);
    // A slot that stops short of the axis holds the piece.
    let short = Run::new(bar()).tool(3).rapid(54.0, -23.0).cut(1.0, -23.0);
    assert!(short.simulation.totals().all.parted == 0.0 && short.alarms().is_empty());
}

#[test]
fn a_nib_of_a_face_is_chips_and_the_part_is_what_stays() {
    // 4 mm off the face in one cut: before the edge, which leans by 17°, a nib of more than 1 mm³ comes off.
    let cutter = Cutter::Insert { shape: Shape::V, circle: 9.525, main: 107.0, auxiliary: 38.0, nose: 0.8 };
    let setup = |stock: Stock| {
        let mut setup = Setup::new(Lathe::default(), stock, turret());
        setup.turret.tools.insert(1, TurningTool { cutter, ..tools::copier() });
        Run::on(setup)
    };
    // To the axis, in one block and in two, and of a tube to its bore.
    for (bore, to) in [(0.0, &[-1.6][..]), (0.0, &[-0.4, -2.0]), (20.0, &[18.0])] {
        let stock = Stock { bore, ..bar() };
        let run = to.iter().fold(setup(stock).rapid(54.0, -4.0), |run, &x| run.cut(x, -4.0));
        let nib = {
            let faced = setup(stock).rapid(54.0, -4.0).cut(bore + 0.4, -4.0);
            faced.simulation.volume() - run.simulation.volume()
        };
        assert!(nib > 1.0, "{nib} mm³ are cut last");
        let all = &run.simulation.totals().all;
        assert_eq!((all.parted, run.alarms()), (0.0, vec![]), "{to:?}");
        assert_eq!(run.simulation.product(), run.simulation.contours());
        let whole = PI * (625.0 - bore * bore / 4.0) * 150.0;
        assert!(((all.volume + run.simulation.volume()) / whole - 1.0).abs() < 1e-9, "what is gone is chips");
    }
}

/// Rings of up to half a kilogram had counted as chips, without a word.
#[test]
fn a_ring_or_cone_that_is_too_large_for_a_chip_falls_out_and_is_told() {
    let cutter = Cutter::Insert { shape: Shape::V, circle: 9.525, main: 107.0, auxiliary: 38.0, nose: 0.8 };
    for (bore, to, least) in [(40.0, 39.0, 2_000.0), (0.0, -1.6, 100.0)] {
        let mut setup = Setup::new(Lathe::default(), Stock { diameter: 50.0, bore, ..bar() }, turret());
        setup.turret.tools.insert(1, TurningTool { cutter, ..tools::copier() });
        let run = Run::on(setup).rapid(54.0, -8.0).cut(to, -8.0);
        let all = &run.simulation.totals().all;
        assert!(all.parted > least && run.alarms().contains(&191), "{}: {:?}", all.parted, run.alarms());
        assert_eq!(run.simulation.product(), run.simulation.contours(), "the part stays in the chuck");
    }
}

#[test]
fn what_is_cut_loose_beside_the_cut_is_the_part_and_a_core_inside_a_face_groove_is_not() {
    let tube = Stock { bore: 30.0, ..bar() };
    let section = |outer: f64, inner: f64| PI * (outer * outer - inner * inner) / 4.0;
    let made = |run: &Run| run.simulation.parted().map(|rings| rings.iter().map(|ring| volume(ring)).sum::<f64>());
    // A thin ring of a tube, by a blade wider than it is.
    let ring = Run::new(Stock { bore: 46.0, ..bar() }).tool(3).rapid(54.0, -5.0).cut(45.0, -5.0);
    assert!((made(&ring).unwrap() - section(50.0, 46.0) * 2.0).abs() < 0.01);
    assert_eq!(ring.alarms(), [191]);
    // A groove from outside, 5 mm deep of 10; the bore comes to meet it, and the ring before it falls off.
    let grooved = Run::new(tube).tool(3).rapid(54.0, -13.0).cut(40.0, -13.0).rapid(54.0, -13.0);
    let bored = grooved.rapid(54.0, 20.0).tool(7).rapid(40.2, 20.0).cut(40.2, -11.5);
    let found = made(&bored).unwrap();
    assert!((found - section(50.0, 40.2) * 10.0).abs() < 1.0, "{found}");
    // A groove from inside, and one into the face that meets it: inside a core of 500 mm³ and more falls out.
    let cored = {
        let mut setup = Setup::new(Lathe::default(), tube, turret());
        let groover = Cutter::Groover { width: 2.0, depth: 6.0, corner: 0.1, face: false };
        setup.turret.tools.insert(1, TurningTool { cutter: groover, tip: Tip::InsideLeft, ..tools::borer() });
        let face = Cutter::Groover { width: 3.0, depth: 20.0, corner: 0.1, face: true };
        let tool = TurningTool { cutter: face, hand: Hand::Right, ..tools::parter() };
        setup.turret.tools.insert(3, tool);
        let run = Run::on(setup).rapid(28.0, 3.0).rapid(28.0, -10.0).cut(36.0, -10.0).rapid(28.0, -10.0);
        run.rapid(28.0, 5.0).tool(3).rapid(35.0, 5.0).cut(35.0, -9.0)
    };
    assert!(cored.simulation.totals().all.parted > 500.0, "{}", cored.simulation.totals().all.parted);
    assert_eq!(made(&cored), None, "{:?}", cored.alarms());
    assert_eq!(cored.simulation.product(), cored.simulation.contours());
}

#[test]
fn a_piece_that_was_parted_off_stays_the_part_where_the_stub_is_cut_there() {
    let made = |run: &Run| run.simulation.product().iter().map(|ring| volume(ring)).sum::<f64>();
    let drilled = || {
        let mut setup = Setup::new(Lathe::default(), Stock { diameter: 30.0, ..bar() }, turret());
        setup.turret.tools.insert(5, tools::drill(10.0, 60.0));
        Run::on(setup).tool(5).rapid(0.0, 5.0).cut(0.0, -29.0)
    };
    let begun = || drilled().rapid(0.0, 5.0).tool(3).rapid(54.0, -30.0);
    // In one block, and in two: the second one takes what the drill's tip has left in the bar.
    let whole = begun().cut(-1.0, -30.0);
    let first = begun().cut(6.0, -30.0);
    assert!(first.simulation.totals().all.parted > 1000.0);
    let slower = first.cut(-1.0, -30.0);
    assert!(slower.last().removed.volume > 1.0, "the core is cut");
    for run in [&whole, &slower] {
        assert!((made(run) - run.simulation.totals().all.parted).abs() < 1.0, "{}", made(run));
        assert_eq!(run.simulation.cuts_on(), None);
    }
    assert!((made(&whole) - made(&slower)).abs() < 1.0);
    // What is turned of the bar behind it is another part: that is told, with the line.
    let piece = made(&slower);
    let on = slower.rapid(54.0, -30.0).tool(1).rapid(26.0, -25.0).cut(26.0, -45.0);
    assert!(on.last().removed.volume > 100.0);
    assert_eq!(on.simulation.cuts_on(), Some((0, on.steps.len())));
    assert!((made(&on) - on.simulation.volume()).abs() < 1e-9);
    // Once that is parted off too, it is the part.
    let both = on.rapid(54.0, -30.0).tool(3).rapid(54.0, -50.0).cut(-1.0, -50.0);
    assert_eq!(both.simulation.cuts_on(), None);
    assert!((made(&both) + piece - both.simulation.totals().all.parted).abs() < 1.0);
}

#[test]
fn a_thread_has_ribs_of_its_pitch_and_depth_and_passes_meet_in_the_grooves() {
    let pass =
        |run: Run, x: f64, start: f64| run.rapid(60.0, start).rapid(x, start).thread(x, -20.0, 2.0).rapid(60.0, -20.0);
    let mut run = Run::new(bar()).tool(4).rapid(60.0, 4.0);
    for x in [49.4, 48.8, 48.2, 47.6] {
        run = pass(run, x, 4.0);
    }
    let grooves = |run: &Run| -> Vec<f64> {
        let ring = &run.simulation.contours()[0];
        // The lowest points: local least radius between the crests.
        let mut lows: Vec<f64> = Vec::new();
        for &[z, r] in ring {
            if (1.0..23.801).contains(&r)
                && (-30.0..1.0).contains(&z)
                && lows.last().is_none_or(|last| (last - z).abs() > 0.3)
            {
                lows.push(z);
            }
        }
        lows.sort_by(f64::total_cmp);
        lows
    };
    let found = grooves(&run);
    // Grooves at Z 0, -2, … -20: the whole revolutions from Z 4.
    assert_eq!(found.len(), 11, "{found:?}");
    // The one at the face is cut in half.
    for pair in found[..10].windows(2) {
        assert!((pair[1] - pair[0] - 2.0).abs() < 1e-6, "{found:?}");
    }
    assert!((found[0] + 20.0).abs() < 0.03, "{found:?}");
    let ring = run.simulation.contours();
    let deepest = ring[0]
        .iter()
        .filter(|[z, _]| *z > -30.0 && *z < 0.0)
        .fold(f64::INFINITY, |low, [_, r]| if *r > 1.0 { low.min(*r) } else { low });
    assert!((deepest - 23.8).abs() < 1e-6, "{deepest}");
    // Width at the surface: 2 tan 30° times the depth, and the tip's rounding besides.
    let volume = run.simulation.volume();
    let again = pass(run, 47.6, 4.0);
    assert!((again.simulation.volume() - volume).abs() < 1e-9, "the same pass cuts air");
    // Half a lead on, a second start.
    let double = pass(again, 47.6, 5.0);
    assert_eq!(grooves(&double).len(), 22 - 1, "{:?}", grooves(&double));
}

#[test]
fn a_start_angle_is_a_way_of_its_share_of_the_lead() {
    let pass = |run: Run, start: f64, angle: f64| {
        run.rapid(60.0, start).rapid(48.0, start).thread_from(48.0, -20.0, 3.0, angle).rapid(60.0, -20.0)
    };
    let begin = || Run::new(bar()).tool(4).rapid(60.0, 6.0);
    let contours = |run: &Run| run.simulation.contours();
    let one = pass(begin(), 6.0, 0.0);
    // At 120 degrees the same side of the work comes past the tool 240 degrees after it has begun: 2 mm further on.
    assert_eq!(contours(&pass(begin(), 6.0, 120.0)), contours(&pass(begin(), 4.0, 0.0)));
    assert_ne!(contours(&pass(begin(), 6.0, 120.0)), contours(&one));
    // Three starts by their angles, and by their places.
    let by_angle = [120.0, 240.0].into_iter().fold(one, |run, angle| pass(run, 6.0, angle));
    let by_place = [5.0, 4.0].into_iter().fold(pass(begin(), 6.0, 0.0), |run, start| pass(run, start, 0.0));
    assert_eq!(contours(&by_angle), contours(&by_place));
    // Each of them in one pass of 1 mm.
    assert_eq!(by_angle.alarms(), [149]);
    // Once more at one of them: air.
    let volume = by_angle.simulation.volume();
    let again = pass(by_angle, 6.0, 240.0);
    assert!((again.simulation.volume() - volume).abs() < 1e-9);
}

#[test]
fn a_thread_that_goes_on_in_another_block_keeps_its_start_angle() {
    let start = || Run::new(bar()).tool(4).rapid(60.0, 4.0).rapid(49.0, 4.0);
    let one = start().thread_from(49.0, -21.3, 1.5, 90.0);
    for angle in [90.0, 0.0, 200.0] {
        // The second block begins in the first one's revolution, whatever its own angle says.
        let two = start().thread_from(49.0, -7.1, 1.5, 90.0).thread_from(49.0, -21.3, 1.5, angle);
        assert!((one.simulation.volume() - two.simulation.volume()).abs() < 1e-6, "{angle}");
    }
}

#[test]
fn a_thread_in_two_blocks_is_one_thread() {
    let start = || Run::new(bar()).tool(4).rapid(60.0, 4.0).rapid(49.0, 4.0);
    let one = start().thread(49.0, -21.3, 1.5).rapid(60.0, -21.3);
    let two = start().thread(49.0, -7.1, 1.5).thread(49.0, -21.3, 1.5).rapid(60.0, -21.3);
    assert!((one.simulation.volume() - two.simulation.volume()).abs() < 1e-6);
    assert!(one.alarms().is_empty() && two.alarms().is_empty());
    // Out of the thread straight up is free, farther in is not.
    let inward = start().thread(49.0, -21.3, 1.5).rapid(40.0, -21.3);
    assert!(inward.alarms().contains(&101), "{:?}", inward.alarms());
}

#[test]
fn a_part_turned_about_is_its_own_mirror_image_where_it_was_clamped() {
    let first = Run::new(bar()).rapid(46.0, 2.0).cut(46.0, -30.0);
    let rings = first.simulation.contours();
    let about = turned_about(&rings, &bar(), 0.0);
    let of = |rings: &[Vec<[f64; 2]>]| rings.iter().map(|ring| volume(ring)).sum::<f64>();
    assert!((of(&about) - of(&rings)).abs() < 1e-9);
    let ends = |rings: &[Vec<[f64; 2]>]| {
        rings[0].iter().fold([f64::MAX, f64::MIN], |[low, high], point| [low.min(point[0]), high.max(point[0])])
    };
    assert_eq!(ends(&about), [-150.0, 0.0]);
    assert_eq!(ends(&turned_about(&rings, &bar(), -3.5)), [-153.5, -3.5]);
    for (one, two) in turned_about(&about, &bar(), 0.0)[0].iter().zip(&rings[0]) {
        assert!((one[0] - two[0]).abs() < 1e-12 && one[1] == two[1]);
    }
    let mut setup = Setup::new(Lathe::default(), bar(), turret());
    setup.part = Some(about);
    let second = Run::on(setup).rapid(46.0, 2.0).cut(46.0, -30.0);
    assert!((second.last().removed.volume - first.last().removed.volume).abs() < 1e-6);
    assert!(second.alarms().is_empty());
}

#[test]
fn recorded_edits_lead_to_the_final_contour() {
    let mut setup = Setup::new(Lathe::default(), bar(), turret());
    setup.record = true;
    let mut ring = setup.stock.contour();
    let mut run = Run::on(setup).tool(2);
    assert_eq!(run.simulation.contour(), &ring);
    for pass in 1..8 {
        let x = 50.0 - 3.0 * f64::from(pass);
        run = run
            .rapid(60.0, 2.0)
            .rapid(x, 2.0)
            .cut(x, -20.0)
            .arc(x + 6.0, -23.0, [x + 6.0, -20.0], -90.0)
            .cut(56.0, -25.0);
    }
    run = run.rapid(60.0, 5.0).tool(3).rapid(60.0, -40.0).cut(-1.0, -40.0);
    for step in &run.steps {
        if let Some(edit) = &step.edit {
            edit.apply(&mut ring);
        }
        assert_eq!(step.edit.is_some(), step.removed.volume > 0.0, "line {}", step.motion.line);
    }
    assert_eq!(ring, run.simulation.contours()[0]);
}

#[test]
fn totals_are_the_sums_of_the_steps() {
    let run = Run::new(bar()).rapid(46.0, 2.0).cut(46.0, -30.0).cut(54.0, -30.0).rapid(54.0, 2.0);
    let totals = run.simulation.totals();
    assert_eq!((totals.all.motions, totals.blocks.len(), totals.tools.len()), (4, 4, 1));
    // 32 mm at 0.2 mm a revolution and 1000 rpm.
    assert!((run.steps[1].seconds.unwrap() - 32.0 / 200.0 * 60.0).abs() < 1e-9);
    // X at 5 m/min, Z at 10 m/min: 77 mm of X, 48 mm of Z.
    assert!((run.steps[0].seconds.unwrap() - 77.0 / 5000.0 * 60.0).abs() < 1e-9);
    let rate = run.steps[1].rate.unwrap();
    assert!((rate - run.steps[1].removed.volume / 1000.0 / (32.0 / 200.0)).abs() < 1e-9);
    assert!((run.steps[1].cutting_speed - PI * 50.0).abs() < 1e-6);
    let sum: f64 = totals.blocks.values().map(|total| total.volume).sum();
    assert!((sum - totals.all.volume).abs() < 1e-9);
}

#[test]
fn the_depth_of_cut_is_that_of_the_pass_and_not_of_the_fillet_before_it() {
    // Passes of 1 mm to one shoulder with a nose of 0.8: each takes the fillet of the one before with it. On a cone, along
    // the face, and into the metal across.
    let run =
        Run::new(bar()).tool(1).rapid(48.0, 2.0).cut(48.0, -30.0).rapid(49.0, 2.0).rapid(46.0, 2.0).cut(46.0, -30.0);
    let run = run.rapid(47.0, -29.0).rapid(47.0, 2.0).rapid(44.0, 2.0).cut(44.0, -30.0);
    let depths: Vec<f64> = run.steps.iter().map(|step| step.depth).filter(|depth| *depth > 0.0).collect();
    assert_eq!(depths.len(), 3);
    for depth in depths {
        assert!((depth - 1.0).abs() < 0.03, "{depth}");
    }
    let facing = Run::new(bar()).tool(1).rapid(54.0, -0.7).cut(-1.6, -0.7);
    assert!((facing.steps.last().unwrap().depth - 0.7).abs() < 1e-3, "{}", facing.steps.last().unwrap().depth);
    let groove = Run::new(bar()).tool(3).rapid(52.0, -20.0).cut(40.0, -20.0);
    assert!((groove.steps.last().unwrap().depth - 3.0).abs() < 1e-3, "{}", groove.steps.last().unwrap().depth);
}

/// Every edge of a mesh by its ends, how often it is run each way; and the volume, mm³.
fn mesh(rings: &[Vec<[f64; 2]>], tolerance: f64) -> (HashMap<[[u32; 3]; 2], i32>, f64) {
    let mut bytes = Vec::new();
    let count = write_stl(rings, tolerance, &mut bytes).unwrap() as usize;
    assert_eq!(bytes.len(), 84 + 50 * count);
    assert_eq!(u32::from_le_bytes(bytes[80..84].try_into().unwrap()) as usize, count);
    let (mut edges, mut six) = (HashMap::new(), 0.0);
    for record in bytes[84..].chunks_exact(50) {
        let value = |at: usize| f32::from_le_bytes(record[4 * at..4 * at + 4].try_into().unwrap());
        let corner = |at: usize| [value(3 + 3 * at), value(4 + 3 * at), value(5 + 3 * at)];
        let [a, b, c] = [corner(0), corner(1), corner(2)];
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let key = |point: [f32; 3]| point.map(f32::to_bits);
            *edges.entry([key(from), key(to)]).or_insert(0) += 1;
        }
        let [a, b, c] = [a, b, c].map(|point| point.map(f64::from));
        six += a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0]);
        // The face's own direction is that of its corners.
        let normal = [0, 1, 2].map(|at| f64::from(value(at)));
        let side = |from: [f64; 3], to: [f64; 3]| [0, 1, 2].map(|axis| to[axis] - from[axis]);
        let (u, v) = (side(a, b), side(a, c));
        let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        let dot = |p: [f64; 3], q: [f64; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
        let area = dot(cross, cross).sqrt();
        assert!(area < 1e-3 || dot(cross, normal) > 0.99 * area, "{normal:?} {cross:?}");
    }
    (edges, six / 6.0)
}

#[test]
fn the_mesh_is_closed_and_holds_the_volume() {
    let solid = Run::new(bar())
        .tool(2)
        .rapid(20.0, 2.0)
        .cut(30.0, -10.0)
        .arc(40.0, -15.0, [40.0, -10.0], -90.0)
        .cut(52.0, -22.0);
    let tube = Run::new(Stock { bore: 20.0, ..bar() }).rapid(46.0, 2.0).cut(46.0, -30.0);
    let drilled = Run::new(bar()).tool(6).rapid(0.0, 3.0).cut(0.0, -40.0);
    for run in [solid, tube, drilled] {
        let rings = run.simulation.contours();
        let right = run.simulation.volume();
        for tolerance in [0.1, 0.01] {
            let (edges, found) = mesh(&rings, tolerance);
            for ([from, to], count) in &edges {
                assert_eq!(edges.get(&[*to, *from]), Some(count), "{from:?} {to:?}");
            }
            // Chords lie within the tolerance of a radius of 25 mm.
            assert!(found < right && found > right * (1.0 - 3.0 * tolerance / 25.0), "{found} {right}");
        }
    }
    assert!(sectors(25.0, 0.01) < sectors(25.0, 0.001));
}

#[test]
fn a_contour_of_many_corners_makes_a_mesh_of_few_within_its_tolerance() {
    // A cone in steps of a micrometre, and a straight one.
    let steps = 5_000;
    let mut ring = vec![[-10.0, 0.0], [0.0, 0.0]];
    for step in 0..=steps {
        let at = f64::from(step) * 0.001;
        ring.extend([[-at, 10.0 + at], [-at, 10.0 + at + 0.001]]);
    }
    ring.push([-10.0, 10.0 + f64::from(steps + 1) * 0.001]);
    let straight = vec![[-10.0, 0.0], [0.0, 0.0], [0.0, 10.0], [-5.0, 15.0], [-10.0, 15.0]];
    let (edges, found) = mesh(&[ring], 0.01);
    let (wanted, right) = mesh(&[straight], 0.01);
    assert!(edges.len() < 2 * wanted.len(), "{} {}", edges.len(), wanted.len());
    assert!((found - right).abs() < 0.0025 * 2.0 * PI * 15.0 * 20.0, "{found} {right}");
    for ([from, to], count) in &edges {
        assert_eq!(edges.get(&[*to, *from]), Some(count), "{from:?} {to:?}");
    }
}
