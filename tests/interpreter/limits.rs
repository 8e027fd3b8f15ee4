//! Files that are no programs, or too much of one; and that nothing at all brings the interpreter down.

use proptest::prelude::*;
use rodete::finding::Exit;
use rodete::gcode::interpreter::{Budget, Fault, Interpreter};
use rodete::gcode::motion::Motion;

use crate::common::rs274::Judge;
use crate::ours::setting;

fn read(program: &[u8]) -> Vec<Result<Motion, Box<Fault>>> {
    let mut setting = setting(&Judge::default());
    setting.budget = Budget { repeated_blocks: 2_000, ..Budget::default() };
    Interpreter::over(program, setting).collect()
}

fn ends(program: &[u8]) -> Vec<f64> {
    read(program).into_iter().map(|motion| motion.unwrap().machine.0[0]).collect()
}

#[test]
fn a_file_without_blocks_is_no_program() {
    for nothing in ["", "\n\n", "(a comment)\n; another\n", "%\n", "%\n%\n"] {
        let read = read(nothing.as_bytes());
        let [Err(fault)] = read.as_slice() else { panic!("{nothing:?}: {read:?}") };
        assert!(fault.what.en.contains("no program"), "{nothing:?}: {}", fault.what.en);
    }
}

#[test]
fn lines_end_in_every_way() {
    for end in ["\n", "\r\n", "\r", "\n\r\n"] {
        let program = ["G21 G90", "G0 X1", "X2 (c)", "X3 ; c", "M2"].join(end);
        assert_eq!(ends(program.as_bytes()), [1.0, 2.0, 3.0], "{end:?}");
        assert_eq!(ends((program + end).as_bytes()), [1.0, 2.0, 3.0], "{end:?}");
    }
}

#[test]
fn a_byte_order_mark_is_passed_over_and_said() {
    let program = "\u{feff}G21 G0 X1\nM2\n";
    let mut interpreter = Interpreter::over(program.as_bytes(), setting(&Judge::default()));
    assert!((interpreter.next().unwrap().unwrap().to.0[0] - 1.0).abs() < 1e-12);
    assert!(interpreter.next().is_none());
    assert!(interpreter.remarks().iter().any(|remark| remark.what.en.contains("byte order mark")));
}

#[test]
fn every_bad_block_is_listed_and_the_good_ones_between_them() {
    let read = read(b"G21 G90\nG0 X1\nG0 X1,5\nG77\nX2\nM2\n");
    let faults: Vec<_> = read.iter().filter_map(|item| item.as_ref().err().map(|fault| fault.line)).collect();
    assert_eq!(faults, [3, 4]);
    assert_eq!(read.iter().filter(|item| item.is_ok()).count(), 2);
}

#[test]
fn a_line_without_end_is_refused_before_it_is_kept() {
    let mut program = b"G21 G0 X1\n".to_vec();
    program.resize(100_000_000, b' ');
    let read = read(&program);
    let Some(Err(fault)) = read.last() else { panic!("{} items", read.len()) };
    assert_eq!(fault.exit, Exit::Limit, "{}", fault.what.en);
}

#[test]
fn an_endless_program_comes_to_its_budget() {
    for program in [
        "o1 while [1]\no1 endwhile\nM2\n",
        "o1 do\nG91 G0 X1\no1 while [1]\nM2\n",
        "o1 repeat [1000000000]\nG4 P0\no1 endrepeat\nM2\n",
    ] {
        let read = read(program.as_bytes());
        let Some(Err(fault)) = read.last() else { panic!("{program}") };
        assert_eq!(fault.exit, Exit::Limit, "{program}: {}", fault.what.en);
    }
}

/// Pieces of programs, so that chance gets further than the first byte.
const PIECES: [&str; 44] = [
    "G", "M", "X", "Y", "Z", "I", "J", "R", "F", "o", "o1 ", "N", "P", "L", "0", "1", "2", "81", "92", "10", ".", "-",
    "+", "[", "]", "#", "#<a>", "=", "sub", "endsub", "call", "if", "endif", "while", "endwhile", "repeat", "return",
    "(", ")", ";", "/", "%", "\n", "\n",
];

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(600) })]

    #[test]
    fn no_bytes_bring_it_down(program in prop::collection::vec(any::<u8>(), 0..400)) {
        read(&program);
    }

    #[test]
    fn no_pieces_of_programs_bring_it_down(pieces in prop::collection::vec(prop::sample::select(PIECES.to_vec()), 0..120)) {
        let _ = read(pieces.concat().as_bytes());
    }

    #[test]
    fn no_damage_to_a_good_program_brings_it_down(which in 0..crate::corpus::names("good").len(), at in any::<prop::sample::Index>(), byte in any::<u8>()) {
        let name = crate::corpus::names("good").swap_remove(which);
        let (mut program, _) = crate::corpus::good(&name);
        let at = at.index(program.len());
        program[at] = byte;
        for motion in read(&program).into_iter().flatten() {
            prop_assert!(motion.machine.0.iter().chain(&motion.to.0).all(|axis| axis.is_finite()), "{motion:?}");
        }
    }
}
