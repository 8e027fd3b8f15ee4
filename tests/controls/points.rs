//! What a decimal point makes of a number is asked of the control, for words, M codes and corners.

use rodete::gcode::control::{
    Control, CountedFeed, Counting, DimensionPoint, DwellUnit, DwellWord, FANUC_LATHE_A, LINUXCNC, LeastIncrement,
    Lexis,
};
use rodete::gcode::interpreter::{DecimalPoint, Interpreter, Setting};
use rodete::gcode::letters::Letters;
use rodete::gcode::motion::{Motion, MotionKind};
use rodete::machine::axis::Axis;

/// A lathe of the same words whose numbers are what they say.
static PLAIN: Control =
    Control { lexis: Lexis { point: DimensionPoint::Free, ..FANUC_LATHE_A.lexis }, ..FANUC_LATHE_A };

/// Another lathe of the same words: X alone counts least increments, and any letter takes a point.
static X_ALONE: Control = Control {
    lexis: Lexis {
        point: DimensionPoint::BySetting(Counting {
            letters: Letters::of("X"),
            feed: CountedFeed::AsWritten,
            whole: Letters::of(""),
            increment: LeastIncrement::Thousandth,
        }),
        ..FANUC_LATHE_A.lexis
    },
    ..FANUC_LATHE_A
};

/// A lathe of the same words whose alarms are not known.
static WITHOUT_ALARMS: Control = Control { alarms: None, ..FANUC_LATHE_A };

/// A mill whose dwells count parts of a second.
static IN_PARTS: Control = Control {
    lexis: Lexis {
        dwell: &[DwellWord { letter: 'P', unit: DwellUnit::Hundredth, shared: false }],
        cycle_dwell: DwellUnit::Millisecond,
        ..LINUXCNC.lexis
    },
    ..LINUXCNC
};

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

#[test]
fn which_letters_count_and_which_take_no_point_is_said_by_the_control() {
    let text = "G0 X40000 Z5\nG1 Z-30 F1\nM8.\nM30\n";
    let end = |control, setting| {
        read(control, setting, text)
            .map(|motions| motions.last().map(|to| [Axis::X, Axis::Z].map(|axis| to.to.get(axis))))
    };
    assert_eq!(end(&X_ALONE, Some(DecimalPoint::Micrometre)), Ok(Some([20.0, -30.0])));
    assert_eq!(end(&X_ALONE, Some(DecimalPoint::Calculator)), Ok(Some([20_000.0, -30.0])));
    assert!(end(&X_ALONE, None).expect_err("the setting is not known").contains("X40000"));
    assert!(
        end(&FANUC_LATHE_A, Some(DecimalPoint::Micrometre)).expect_err("F counts what is not known").contains("F1")
    );
}

#[test]
fn a_cycle_counts_its_depths_as_its_control_counts_lengths() {
    let text = "T0101 S500 M3 F.2\nG0 X50. Z5.\nG74 R1.\nG74 Z-20. Q10000\nM30\n";
    let feeds = |control| {
        let motions = read(control, None, text).expect("a groove");
        motions.iter().filter(|motion| matches!(motion.kind, MotionKind::Feed(_))).count()
    };
    assert_eq!([&FANUC_LATHE_A, &X_ALONE, &PLAIN].map(feeds), [3, 3, 1]);
}

#[test]
fn a_corner_shows_the_alarm_of_a_control_whose_alarms_are_known() {
    let text = "G0 X40. Z2.\nG1 Z-30. ,C2. F.2\nG0 X60.\nM30\n";
    let [known, unknown] =
        [&FANUC_LATHE_A, &WITHOUT_ALARMS].map(|control| read(control, None, text).expect_err("no line follows"));
    assert!(known.starts_with("PS") && known.ends_with(&unknown) && !unknown.starts_with("PS"), "{known}; {unknown}");
}

#[test]
fn a_dwell_counts_what_its_control_says() {
    let dwells = |control, text: &str| -> Result<Vec<f64>, String> {
        let seconds = |motion: &Motion| match motion.kind {
            MotionKind::Dwell(seconds) => Some(seconds),
            _ => None,
        };
        read(control, None, text).map(|motions| motions.iter().filter_map(seconds).collect())
    };
    let hole = "G21 G90 F100 S500 M3\nG0 Z5\nG82 X0 Y0 R2 Z-5 P50\nM2\n";
    assert_eq!(dwells(&LINUXCNC, hole), Ok(vec![50.0]));
    assert_eq!(dwells(&IN_PARTS, hole), Ok(vec![0.05]));
    assert_eq!(dwells(&LINUXCNC, "G4 P1.5\nM2\n"), Ok(vec![1.5]));
    assert_eq!(dwells(&IN_PARTS, "G4 P150\nM2\n"), Ok(vec![1.5]));
    assert!(dwells(&IN_PARTS, "G4 P1.5\nM2\n").expect_err("a whole number").contains("P1.5"));
}
