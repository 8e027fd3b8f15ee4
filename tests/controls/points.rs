//! What a decimal point makes of a number is asked of the control, for words, M codes and corners.

use rodete::gcode::control::{Control, DimensionPoint, FANUC_LATHE_A, Lexis};
use rodete::gcode::interpreter::{DecimalPoint, Interpreter, Setting};
use rodete::gcode::motion::Motion;
use rodete::machine::axis::Axis;

/// A lathe of the same words whose numbers are what they say.
static PLAIN: Control =
    Control { lexis: Lexis { point: DimensionPoint::Free, ..FANUC_LATHE_A.lexis }, ..FANUC_LATHE_A };

/// The motions of a program, or the message of its first refusal.
fn read(control: &'static Control, decimal_point: Option<DecimalPoint>, text: &str) -> Result<Vec<Motion>, String> {
    let setting = Setting { decimal_point, ..Setting::new(control) };
    Interpreter::over(text.as_bytes(), setting)
        .collect::<Result<_, _>>()
        .map_err(|fault| fault.message().en.into_owned())
}

#[test]
fn a_number_without_a_point_is_what_its_control_makes_of_it() {
    let text = "G0 X40000 Z0\nG1 Z-30000 F0.2\nM30\n";
    let farthest =
        |motions: Vec<Motion>| motions.last().map(|motion| [Axis::X, Axis::Z].map(|axis| motion.to.get(axis)));
    let of = |control, setting| read(control, setting, text).map(farthest);
    let unknown = of(&FANUC_LATHE_A, None).expect_err("the setting is not known");
    assert!(unknown.contains("X40000"), "{unknown}");
    assert_eq!(of(&FANUC_LATHE_A, Some(DecimalPoint::Micrometre)), Ok(Some([20.0, -30.0])));
    for (control, setting) in [(&FANUC_LATHE_A, Some(DecimalPoint::Calculator)), (&PLAIN, None)] {
        assert_eq!(of(control, setting), Ok(Some([20_000.0, -30_000.0])));
    }
}

#[test]
fn a_corner_without_a_point_is_a_length_as_any_other() {
    let text = "G0 X40. Z2.\nG1 Z-30. ,C2 F0.2\nX60.\nM30\n";
    let corners = |control, setting| read(control, setting, text).map(|motions| motions.len());
    assert!(corners(&FANUC_LATHE_A, None).expect_err("the setting is not known").contains(",C2"));
    let pointed = read(&FANUC_LATHE_A, None, &text.replace(",C2", ",C2.")).map(|motions| motions.len());
    assert_eq!(corners(&PLAIN, None), pointed);
    assert!(pointed.is_ok());
}

#[test]
fn a_point_where_a_control_takes_none_is_rejected_by_that_control_alone() {
    let text = "G0 X40. Z2.\nM8.\nM30\n";
    assert!(read(&FANUC_LATHE_A, None, text).expect_err("M8. is not taken").contains("M8."));
    assert!(read(&PLAIN, None, text).is_ok());
}
