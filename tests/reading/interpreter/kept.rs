//! What outlives a program: the variable file that rodete leaves against the one that rs274 leaves.

use std::collections::BTreeMap;

use rodete::machine::var_file::VarFile;

use super::agreement::agree;
use super::common::rs274::{self, Judge};
use super::ours;

/// The parameters that LinuxCNC documents as kept: G28, G30, the switch and the registers of G92 and G52, the active system,
/// and the nine systems with their rotation.
fn documented() -> impl Iterator<Item = u32> {
    (5161..=5169).chain(5181..=5189).chain(5210..=5219).chain(5220..=5220).chain((0..9).flat_map(|system| {
        let first = 5221 + 20 * system;
        first..=first + 9
    }))
}

/// The values of these parameters.
pub type Offsets = BTreeMap<u32, f64>;

pub fn parsed(text: &str) -> VarFile {
    VarFile::parse(text.as_bytes()).expect("a variable file")
}

/// The offsets of a variable file.
///
/// # Panics
/// Where one is missing.
pub fn offsets(file: &VarFile) -> Offsets {
    documented().map(|number| (number, file.get(number).unwrap_or_else(|| panic!("#{number} is missing")))).collect()
}

/// # Errors
/// Says which parameter differs by more than the last of the six decimals that rs274 writes.
pub fn same(ours: &Offsets, theirs: &Offsets) -> Result<(), String> {
    assert_eq!(ours.len(), theirs.len());
    for ((number, ours), (_, theirs)) in ours.iter().zip(theirs) {
        if (ours - theirs).abs() > 0.000_001 {
            return Err(format!("#{number} is left at {ours}, by rs274 at {theirs}"));
        }
    }
    Ok(())
}

/// Both run the program from the same file; the files that they leave.
fn leave(program: &str, judge: &Judge) -> (String, String) {
    let (motions, ours) = ours::run(program.as_bytes(), judge).unwrap_or_else(|fault| panic!("{program}{fault}"));
    let theirs = judge.run(program.as_bytes()).unwrap_or_else(|refused| panic!("{program}{refused:?}"));
    agree(&motions, &theirs.motions).unwrap_or_else(|fault| panic!("{program}{fault}"));
    let (ours, theirs) = (ours.text(), theirs.var);
    same(&offsets(&parsed(&ours)), &offsets(&parsed(&theirs))).unwrap_or_else(|fault| panic!("{program}{fault}"));
    (ours, theirs)
}

/// A program, and parameters worked out by hand that it leaves, in inches.
const PROGRAMS: [(&str, &[(u32, f64)]); 8] = [
    // The tool stands on 2, and 2 is to read 5: 2 = 5 + (-3).
    ("G20 G90 G0 X2 Y1\nG92 X5 Y0\nM2\n", &[(5210, 1.0), (5211, -3.0), (5212, 1.0), (5213, 0.0), (5220, 1.0)]),
    // G52 has the registers of G92, axis by axis.
    ("G20 G90 G0 X2\nG92 X5 Z1\nG52 X0.5 A30\nM2\n", &[(5210, 1.0), (5211, 0.5), (5213, -1.0), (5214, 30.0)]),
    // Off, and kept.
    ("G20 G90 G92 X-4\nG92.2\nG0 X1\nM2\n", &[(5210, 0.0), (5211, 4.0)]),
    // On again.
    ("G20 G90 G52 Y2\nG92.2\nG0 X1 Y1\nG92.3\nG0 Y1\nM2\n", &[(5210, 1.0), (5212, 2.0)]),
    // Gone.
    ("G20 G90 G92 X-4 C5\nG92.1\nG0 X1\nM2\n", &[(5210, 0.0), (5211, 0.0), (5216, 0.0)]),
    // Millimetres come out in inches; a rotation is in degrees, ten parameters after X.
    (
        "G21 G90\nG10 L2 P3 X25.4 Z-50.8 B45 R30\nG10 L2 P9 Y12.7 R-90\nG56 G0 X25.4 Y0\nM2\n",
        &[(5261, 1.0), (5263, -2.0), (5265, 45.0), (5270, 30.0), (5382, 0.5), (5390, -90.0), (5220, 1.0)],
    ),
    // Machine coordinates, whatever the offsets: with G55 at 10 the tool goes to 11.
    (
        "G20 G90\nG10 L2 P2 X10\nG55 G0 X1 Y2 Z3 A40\nG28.1\nG52 X5\nG0 X1 Y0\nG30.1\nG52 X0\nM2\n",
        &[(5161, 11.0), (5162, 2.0), (5163, 3.0), (5164, 40.0), (5181, 16.0), (5182, 0.0), (5241, 10.0), (5210, 1.0)],
    ),
    // The system counts so that this position reads what is said.
    ("G20 G90 G0 X3 Y4\nG10 L20 P6 X1 Y-1\nG59\nM30\n", &[(5321, 2.0), (5322, 5.0), (5220, 1.0)]),
];

#[test]
fn the_variable_file_is_left_as_linuxcnc_leaves_it() {
    for (program, by_hand) in PROGRAMS {
        let (_, left) = ours::run(program.as_bytes(), &Judge::default()).unwrap();
        for &(number, expected) in by_hand {
            let value = left.get(number).unwrap();
            assert!((value - expected).abs() < 1e-9, "{program}#{number} is {value}, not {expected}");
        }
        if rs274::is_here() {
            leave(program, &Judge::default());
        }
    }
}

/// Whichever of the two has written the file, both go on from it alike.
#[test]
fn each_goes_on_from_the_file_that_the_other_left() {
    if !rs274::is_here() {
        return;
    }
    let next = "G20 G90 G0 X1 Y1 Z1\nG28 Z2\nG92.3\nG0 X1 Y2\nG56 G0 X1 Y1\nG30\nG59.3 G0 X0 Y0\nM2\n";
    for (program, _) in PROGRAMS {
        let (ours, theirs) = leave(program, &Judge::default());
        let files = [ours, theirs].map(|file| leave(next, &Judge { var: Some(&file), ..Judge::default() }).0);
        same(&offsets(&parsed(&files[0])), &offsets(&parsed(&files[1]))).unwrap();
    }
}

#[test]
fn the_active_system_of_the_file_is_in_force_from_the_start() {
    // What is no whole number from 1 to 9 counts as 1.
    for (active, x) in [("1", 1.0), ("2", 2.0), ("9", 9.0), ("0", 1.0), ("10", 1.0), ("-1", 1.0), ("2.5", 1.0)] {
        let file = format!("5220\t{active}\n5221\t1\n5241\t2\n5381\t9\n");
        let judge = Judge { var: Some(&file), ..Judge::default() };
        let program = "G20 G90 G0 X0\nM2\n";
        let (motions, _) = ours::run(program.as_bytes(), &judge).unwrap();
        assert!((motions[0].machine.0[0] - x * 25.4).abs() < 1e-9, "#5220 = {active}: {motions:?}");
        if rs274::is_here() && active != "2.5" {
            leave(program, &judge);
        }
    }
}

#[test]
fn without_persistence_g92_neither_comes_from_the_file_nor_stays_in_it() {
    let file = "5210\t1\n5211\t3\n5212\t-1\n5220\t1\n";
    for program in ["G20 G90 G0 X1\nM2\n", "G20 G90 G0 X1\nG92 X5\nG0 X1\nM2\n", "G20 G90 G92.3\nG0 X1\nG52 Y3\nM30\n"]
    {
        let judge = Judge { var: Some(file), keep_g92: false, ..Judge::default() };
        let (motions, left) = ours::run(program.as_bytes(), &judge).unwrap();
        assert!((motions[0].machine.0[0] - 25.4).abs() < 1e-9, "{program}{motions:?}");
        for number in 5210..=5219 {
            assert!(left.get(number).unwrap().abs() < 1e-12, "{program}#{number}");
        }
        if rs274::is_here() {
            leave(program, &judge);
        }
    }
}
