//! That nothing at all brings the lathe's interpreter down, or keeps it going without end.

use proptest::prelude::*;
use rodete::gcode::interpreter::DecimalPoint;

use super::lines::{Folder, read_with, setting};

fn word() -> impl Strategy<Value = String> {
    let number = prop_oneof![
        (-60_000..60_000_i32).prop_map(|number| format!("{:.3}", f64::from(number) / 1000.0)),
        (-20..30_000_i32).prop_map(|number| number.to_string()),
        Just("0".to_owned()),
        Just("1000000".to_owned()),
    ];
    let codes = prop::sample::select(vec![
        "G0", "G1", "G2", "G3", "G4", "G20", "G21", "G28", "G30", "G32", "G34", "G40", "G41", "G42", "G50", "G53",
        "G54", "G55", "G70", "G71", "G72", "G73", "G74", "G75", "G76", "G80", "G81", "G82", "G83", "G90", "G92", "G94",
        "G96", "G97", "G98", "G99", "M3", "M4", "M5", "M8", "M9", "M97", "M98", "M99", "M30", "T0101", "T0202", "T0",
        "P10", "Q20", "P20", "N10", "N20", "O5", "%", "/", ";",
    ])
    .prop_map(str::to_owned);
    let letters = prop::sample::select("XZUWIKRFSPQLKTN".chars().collect::<Vec<_>>());
    prop_oneof![3 => codes, 5 => (letters, number).prop_map(|(letter, number)| format!("{letter}{number}"))]
}

fn block() -> impl Strategy<Value = String> {
    prop_oneof![
        8 => proptest::collection::vec(word(), 1..6).prop_map(|words| words.join(" ")),
        1 => Just("G71 U2. R1.\nG71 P10 Q20 U.5 F.2".to_owned()),
        1 => Just("G72 W2. R1.\nG72 P10 Q20 W.5".to_owned()),
        1 => Just("G73 U5. W2. R3\nG73 P10 Q20".to_owned()),
        1 => Just("G76 P020060 Q100 R.1\nG76 X20. Z-30. P1500 Q400 F2.".to_owned()),
        1 => Just("G75 R1.\nG75 X20. Z-30. P1500 Q2000".to_owned()),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 600, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_program_of_codes_and_numbers_brings_it_down(
        blocks in proptest::collection::vec(block(), 1..25),
        contour in proptest::collection::vec(block(), 0..5),
        point in prop::sample::select(vec![None, Some(DecimalPoint::Calculator), Some(DecimalPoint::Micrometre)]),
    ) {
        let program = format!(
            "S500 M3 F.2 T0101\nG0 X60. Z5.\n{}\nN10 G0 X10.\n{}\nN20 G1 X60. Z-40.\nM30\nN100 W1.\nM99\n",
            blocks.join("\n"),
            contour.join("\n"),
        );
        let mut setting = setting();
        setting.decimal_point = point;
        setting.budget.repeated_blocks = 300;
        let sub = "G0 W1.\nM98 P5\nM99\n".to_owned();
        setting.files = Box::new(Folder([("5".to_owned(), sub)].into()));
        let read = read_with(&program, setting);
        for motion in &read.motions {
            prop_assert!(motion.to.0.iter().chain(&motion.machine.0).all(|at| at.is_finite()), "{program}\n{motion:?}");
            prop_assert!(motion.seconds.is_none_or(|seconds| seconds.is_finite() && seconds >= 0.0), "{program}\n{motion:?}");
        }
    }
}
