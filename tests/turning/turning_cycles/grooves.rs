//! G74 and G75.

use rodete::finding::{AlarmFamily, Exit};
use rodete::gcode::turning::groove::{Groove, face, radial};

use super::assert_moves;

const GROOVE: Groove = Groove { retract: 0.5, to: [10.0, -5.0], step: [3.0, 2.0], relief: 0.0, feed: Some(0.1) };

#[test]
fn g75_grooves_in_steps_from_place_to_place() {
    // From (15, 0) down to radius 10 in steps of 3: 12, 10. Along Z to −5 in steps of 2: 0, −2, −4, −5.
    let mut expected = Vec::new();
    for (place, z) in [0.0, -2.0, -4.0, -5.0].into_iter().enumerate() {
        if place > 0 {
            expected.push(('r', [15.0, z]));
        }
        expected.extend([('f', [12.0, z]), ('r', [12.5, z]), ('f', [10.0, z]), ('r', [15.0, z])]);
    }
    expected.push(('r', [15.0, 0.0]));
    assert_moves(&radial([15.0, 0.0], &GROOVE).unwrap(), &expected);
}

#[test]
fn g74_grooves_the_face_and_moves_aside_at_the_bottom() {
    // From (16, 1) to Z−5 in steps of 2: −1, −3, −5. Along X to 10 in steps of 3: 16, 13, 10. Relief 0.2 back towards 16.
    let mut expected = Vec::new();
    for (place, x) in [16.0, 13.0, 10.0].into_iter().enumerate() {
        if place > 0 {
            expected.push(('r', [x, 1.0]));
        }
        expected.extend([('f', [x, -1.0]), ('r', [x, -0.5]), ('f', [x, -3.0]), ('r', [x, -2.5]), ('f', [x, -5.0])]);
        expected.extend([('r', [x + 0.2, -5.0]), ('r', [x + 0.2, 1.0])]);
    }
    expected.push(('r', [16.0, 1.0]));
    assert_moves(&face([16.0, 1.0], &Groove { relief: 0.2, ..GROOVE }).unwrap(), &expected);
}

#[test]
fn g74_on_the_axis_drills_in_steps() {
    let drill = Groove { to: [0.0, -7.0], step: [0.0, 3.0], retract: 1.0, ..GROOVE };
    assert_moves(
        &face([0.0, 2.0], &drill).unwrap(),
        &[
            ('f', [0.0, -1.0]),
            ('r', [0.0, 0.0]),
            ('f', [0.0, -4.0]),
            ('r', [0.0, -3.0]),
            ('f', [0.0, -7.0]),
            ('r', [0.0, 2.0]),
        ],
    );
}

#[test]
fn a_step_that_is_a_whole_part_of_the_way_leaves_no_step_of_nothing() {
    // 0.3 is not a binary number: 0.9 is to be three steps.
    let drill = Groove { to: [0.0, -0.9], step: [0.0, 0.3], retract: 0.0, ..GROOVE };
    assert_eq!(face([0.0, 0.0], &drill).unwrap().len(), 4);
}

#[test]
fn grooves_that_a_control_refuses_are_refused() {
    let alarm = |groove: Groove| radial([15.0, 0.0], &groove).unwrap_err().alarm(AlarmFamily::Fanuc);
    assert_eq!(alarm(Groove { step: [-1.0, 2.0], ..GROOVE }), Some(320));
    assert_eq!(alarm(Groove { step: [3.0, 0.0], ..GROOVE }), Some(319));
    assert_eq!(alarm(Groove { step: [0.0, 2.0], ..GROOVE }), Some(319));
    assert_eq!(alarm(Groove { relief: -0.1, ..GROOVE }), Some(318));
    assert_eq!(alarm(Groove { to: [15.0, -5.0], ..GROOVE }), None);
    assert_eq!(alarm(Groove { retract: -0.1, ..GROOVE }), None);
    assert_eq!(alarm(Groove { retract: f64::INFINITY, ..GROOVE }), None);
    assert_eq!(radial([15.0, 0.0], &Groove { step: [1e-9, 2.0], ..GROOVE }).unwrap_err().exit, Exit::Limit);
}
