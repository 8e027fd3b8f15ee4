//! A boring bar fed along the axis: into solid metal or a hole too narrow for it, and into one that has room.

use super::lathe::{Run, bar, turret};
use rodete::finding::Grade;
use rodete::geometry::exact::region::Ring;
use rodete::number::trig::sin_cos;
use rodete::removal::turning::alarm::Cause;
use rodete::removal::turning::machine::Lathe;
use rodete::removal::turning::simulation::Setup;
use rodete::removal::turning::stock::Stock;

/// Diameter of the hole and the least, of the one alarm that the last motion alone raises.
#[track_caller]
fn without_hole(run: &Run) -> [f64; 2] {
    let alarm = run.only(105);
    let Cause::BoreWithoutHole { hole, least } = alarm.cause else { panic!("{alarm:?}") };
    assert!(alarm.cause.grade() == Grade::Stop && alarm.depth.is_some_and(|deep| deep > 0.0), "{alarm:?}");
    assert!(hole < least, "{alarm:?}");
    [hole, least]
}

/// The bar of 16 mm with its centre 11 mm from the tip, fed along Z in a blank with a bore.
fn bored(bore: f64, x: f64, z: f64) -> Run {
    Run::new(Stock { bore, ..bar() }).tool(7).rapid(x, 2.0).cut(x, z)
}

/// Into a blind hole of 20 mm, 40 mm deep with a flat bottom.
fn blind(x: f64, z: f64) -> Run {
    let ring: Ring = vec![[-150.0, 0.0], [-40.0, 0.0], [-40.0, 10.0], [0.0, 10.0], [0.0, 25.0], [-150.0, 25.0]];
    Run::on(Setup { part: Some(vec![ring]), ..Setup::new(Lathe::default(), bar(), turret()) })
        .tool(7)
        .rapid(x, 2.0)
        .cut(x, z)
}

#[test]
fn a_boring_bar_fed_into_solid_metal_is_told_as_that_and_nothing_else_is() {
    for (x, z) in [(40.0, -5.0), (30.0, -30.0), (20.0, -1.0), (8.0, -5.0)] {
        let [hole, _] = without_hole(&bored(0.0, x, z));
        assert!(hole.abs() < 1e-9, "{x} {z}");
    }
    // On in the groove that the first plunge has left: its core is solid still.
    let twice = bored(0.0, 40.0, -5.0).cut(40.0, -10.0);
    assert_eq!(twice.alarms(), [105, 105]);
    // On a cone and along an arc.
    assert_eq!(Run::new(bar()).tool(7).rapid(44.0, 2.0).cut(30.0, -12.0).alarms(), [105]);
    let (sin, cos) = sin_cos(110.0_f64.to_radians());
    let arc = Run::new(bar()).tool(7).rapid(40.0, 2.0).arc(40.0 * sin, 2.0 + 20.0 * cos, [0.0, 2.0], 20.0);
    assert_eq!(arc.alarms(), [105]);
    // Facing from the middle out with the bar's end before the face, and a film at the bottom, touch no bar.
    Run::new(bar()).tool(7).rapid(0.5, 2.0).cut(0.5, -0.2).cut(54.0, -0.2).silent();
}

#[test]
fn a_hole_too_narrow_for_the_bar_is_told_with_the_diameter_that_it_needs() {
    // Beyond the axis the bar reaches 11 + 8 − 9.2 mm out.
    let [hole, least] = without_hole(&bored(18.0, 18.4, -30.0));
    assert!((hole - 18.0).abs() < 1e-6 && (least - 19.6).abs() < 1e-6, "{hole} {least}");
    bored(19.6, 19.8, -30.0).silent();
    // The edge reaches e inwards: the bar meets what is left between the hole and it, and the alarm says how wide it has to be.
    let [hole, least] = without_hole(&bored(12.0, 46.0, -10.0));
    assert!((hole - 12.0).abs() < 1e-6 && least > 20.0, "{hole} {least}");
    bored(least, 46.0, -10.0).silent();
    without_hole(&bored(least - 0.2, 46.0, -10.0));
    // A step on the way, and the bottom of a hole.
    blind(22.0, -39.9).silent();
    blind(22.0, -40.0).silent();
    // The edge goes on into the bottom, and the bar's end stays out of it.
    blind(22.0, -40.4).silent();
    let [hole, _] = without_hole(&blind(22.0, -42.0));
    assert!(hole.abs() < 1e-9);
}

#[test]
fn a_bar_beside_metal_or_drawn_out_of_it_keeps_the_alarms_that_it_had() {
    // Its clamp on the face, 80 mm behind the tip.
    bored(24.0, 26.0, -85.0).only(104);
    // Out of the wall of a hole towards the axis the bar touches the other side.
    let out = Run::new(Stock { bore: 24.0, ..bar() }).tool(7).rapid(22.0, 2.0).rapid(22.0, -20.0).cut(13.0, -20.0);
    out.only(103);
    // A shank outside, deeper than its edge.
    let outside = Run::new(Stock { overhang: 100.0, ..Stock::bar(80.0, 150.0) }).rapid(50.0, 2.0).cut(50.0, -20.0);
    assert!(outside.alarms().contains(&131) && !outside.alarms().contains(&105), "{:?}", outside.alarms());
}
