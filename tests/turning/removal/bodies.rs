//! The turret's body about each tool: what of it counts, and that it hides nothing else.

use super::lathe::{Run, bar, turret};
use super::tools;
use rodete::removal::turning::machine::Lathe;
use rodete::removal::turning::simulation::Setup;
use rodete::removal::turning::stock::Stock;
use rodete::removal::turning::tool::{Cutter, Hand, Holder, TurningTool};
use rodete::removal::turning::turret::Turret;

/// With the usual tools, and a body about the reference point, `[[z, r], [z, r]]`.
fn with(body: [[f64; 2]; 2], stock: Stock) -> Run {
    Run::on(Setup::new(Lathe::default(), stock, Turret { body: Some(body), ..turret() }))
}

#[test]
fn a_body_hides_not_what_holds_a_boring_bar() {
    // Far out: only what holds the bar of 80 mm, 16 mm thick, can touch the bored bar.
    let tube = || Stock { bore: 24.0, ..bar() };
    let bored = |z: f64| with([[50.0, 50.0], [100.0, 100.0]], tube()).tool(7).rapid(26.0, 2.0).cut(26.0, z);
    bored(-79.9).silent();
    let alarm = bored(-85.0).only(104);
    assert!((alarm.depth.unwrap() - 5.0).abs() < 1e-6, "{alarm:?}");
    // And the body, where it comes before: it begins 60 mm behind the tip, level with the metal.
    let bored = |z: f64| {
        let mut setup = Setup::new(Lathe::default(), tube(), turret());
        let tool = setup.turret.tools.get_mut(&7).unwrap();
        (tool.overhang, tool.holder) = ([-11.0, 60.0], Holder::Bar { diameter: 16.0, length: 80.0, reach: 11.0 });
        setup.turret.body = Some([[0.0, -20.0], [100.0, 100.0]]);
        Run::on(setup).tool(7).rapid(26.0, 2.0).cut(26.0, z)
    };
    bored(-59.9).silent();
    let alarm = bored(-61.0).only(104);
    assert!((alarm.depth.unwrap() - 1.0).abs() < 1e-6, "{alarm:?}");
}

#[test]
fn a_body_that_covers_a_drill_or_a_bar_begins_behind_its_length() {
    // A neighbour reaches 100 mm to the left of the reference point: to 30 mm behind the drill's point, which stands 130 mm
    // before that point and is held from there on; to 20 mm before the bar's tip.
    let body = [[-100.0, -40.0], [100.0, 200.0]];
    let drilled = |z: f64| with(body, bar()).tool(6).rapid(0.0, 3.0).cut(0.0, z);
    drilled(-80.0).silent();
    let tube = Stock { bore: 24.0, ..bar() };
    with(body, tube).tool(7).rapid(26.0, 2.0).cut(26.0, -79.9).silent();
    with(body, tube).tool(7).rapid(26.0, 2.0).cut(26.0, -81.0).only(104);
    // A blade for faces on a shank of 60 mm along Z, too: the neighbour would reach the face before the blade does.
    let grooved = |z: f64, length: f64| {
        let cutter = Cutter::Groover { width: 3.0, depth: 40.0, corner: 0.2, face: true };
        let holder = Holder::Shank { width: 25.0, length };
        let mut setup = Setup::new(Lathe::default(), bar(), Turret { body: Some(body), ..turret() });
        let tool = TurningTool { cutter, hand: Hand::Left, holder, overhang: [0.0, 60.0], ..tools::parter() };
        setup.turret.tools.insert(1, tool);
        Run::on(setup).rapid(30.0, 3.0).cut(30.0, z)
    };
    grooved(-4.0, 60.0).silent();
    grooved(-4.0, 3.9).only(104);
    // A tool along X stands out of it and stays clear.
    with([[-30.0, -10.0], [100.0, 200.0]], bar()).rapid(46.0, 2.0).cut(46.0, -30.0).silent();
}

#[test]
fn what_of_a_body_is_out_of_reach_counts_not_and_the_rest_does() {
    let bodies = |body: [[f64; 2]; 2]| {
        let turret = Turret { body: Some(body), ..turret() };
        turret
            .bodies(&turret.tools[&1])
            .iter()
            .map(|body| (body.extent().0.mm(), body.extent().1.mm()))
            .collect::<Vec<_>>()
    };
    // The reference point stands 60 mm out from the tip, and level with it.
    assert_eq!(bodies([[-20.0, -10.0], [900.0, 900.0]]), [([-20.0, 50.0], [290.0, 290.0])]);
    assert_eq!(bodies([[-20.0, 231.0], [30.0, 900.0]]), []);
    assert_eq!(turret().bodies(&turret().tools[&1]).len(), 0);
    assert_eq!(turret().bodies(&turret().tools[&7]).len(), 1, "what holds the bar");
}
