//! Files that are no programs, or too much of one; and that nothing at all brings the interpreter down.

use proptest::prelude::*;
use rodete::finding::Exit;
use rodete::gcode::control::{ALL, Control, FAGOR_8055_T, LINUXCNC};
use rodete::gcode::interpreter::{Budget, Interpreter, Refused, Setting};
use rodete::gcode::motion::Motion;

use super::common::rs274::Judge;
use super::ours::setting;

fn read(program: &[u8]) -> Vec<Result<Motion, Box<Refused>>> {
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
    for end in ["\n", "\r\n", "\n\r\n"] {
        let program = ["G21 G90", "G0 X1", "X2 (c)", "X3 ; c", "M2"].join(end);
        assert_eq!(ends(program.as_bytes()), [1.0, 2.0, 3.0], "{end:?}");
        assert_eq!(ends((program + end).as_bytes()), [1.0, 2.0, 3.0], "{end:?}");
    }
}

#[test]
fn a_lone_return_ends_a_line_and_is_rejected_by_linuxcnc() {
    let program = b"G0 X1.\rX2.\rM30\r";
    for control in ALL {
        let read: Vec<_> = Interpreter::over(program, Setting::new(control)).collect();
        if control.name == "linuxcnc" {
            let [Err(fault)] = read.as_slice() else { panic!("{read:?}") };
            assert_eq!((fault.rule.code, fault.line, fault.columns.as_slice()), ("G0031", 1, &[7][..]));
        } else {
            let lines: Vec<_> = read.into_iter().map(|motion| motion.unwrap().line).collect();
            assert_eq!(lines, [1, 2], "{}", control.name);
        }
    }
}

#[test]
fn a_byte_order_mark_is_passed_over_and_said_but_for_linuxcnc() {
    let program = "\u{feff}G0 X1.\nM30\n";
    for control in ALL.into_iter().filter(|control| control.name != "linuxcnc") {
        let mut interpreter = Interpreter::over(program.as_bytes(), Setting::new(control));
        assert!(interpreter.next().unwrap().is_ok(), "{}", control.name);
        assert!(interpreter.next().is_none());
        assert!(interpreter.remarks().iter().any(|remark| remark.what.en.contains("byte order mark")));
    }
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

/// The refusals of a program: line, end and text.
fn refusals(program: &str, control: &'static Control) -> Vec<(usize, Exit, String)> {
    let read = Interpreter::over(program.as_bytes(), Setting::new(control));
    read.filter_map(Result::err).map(|fault| (fault.line, fault.exit, fault.what.en.to_string())).collect()
}

#[test]
fn a_block_that_a_loop_repeats_is_refused_once_and_ends_the_program_at_the_hundredth_time() {
    let program = "G21 G90\n#1=0\no1 while [#1 LT 1000000]\nG38.2 Z-1 F100\n#1=[#1+1]\no1 endwhile\nM2\n";
    let [first, last] = refusals(program, &LINUXCNC).try_into().expect("two refusals");
    assert_eq!((first.0, first.1), (4, Exit::Refused));
    assert_eq!(
        last,
        (4, Exit::Limit, "the block was rejected 100 times in a loop; rodete stops reading here".to_owned())
    );
    let ends = program.replace("1000000", "99");
    assert_eq!(refusals(&ends, &LINUXCNC).len(), 1, "99 times are told once, and the program is read on");
}

#[test]
fn a_loop_whose_rounds_change_nothing_is_stopped_and_one_that_counts_is_not() {
    let told = |program: &str| refusals(program, &LINUXCNC);
    let idle = "endless loop: in 1000 passes nothing moves and no parameter changes";
    for program in [
        "o1 while [1]\no1 endwhile\nM2\n",
        "o1 while [#5399 EQ 0]\nM3 S100\nM5\n#1=7\no1 endwhile\nM2\n",
        "o1 do\no2 call [5]\no1 while [1]\no2 sub\no2 endsub\nM2\n",
        "o1 while [1]\no1 continue\no1 endwhile\nM2\n",
    ] {
        let told = told(program);
        assert!(told.len() == 1 && told[0].1 == Exit::Limit && told[0].2 == idle, "{program}: {told:?}");
    }
    let counts = "#1=0\no1 while [#1 LT 5000]\n#1=[#1+1]\no1 endwhile\nM2\n";
    assert!(told(counts).is_empty());
    let repeats = "o1 repeat [5000]\nM64 P1\no1 endrepeat\nG21 G0 X1\nM2\n";
    assert!(told(repeats).is_empty());
}

#[test]
fn the_motions_of_cycles_are_counted_too() {
    let mut setting = Setting::new(&LINUXCNC);
    setting.budget.repeated_blocks = 10_000;
    let program = b"G21 G90 G17 F100\nG0 Z5\nG98 G83 X0 Y0 Z-100 R1 Q0.1 L9999\nG0 X1\nM2\n";
    let read: Vec<_> = Interpreter::over(program, setting).collect();
    let Some(Err(fault)) = read.last() else { panic!("taken") };
    assert_eq!((fault.exit, fault.line), (Exit::Limit, 3), "{}", fault.what.en);
    assert!(read.len() < 20_000, "{} motions", read.len());
}

#[test]
fn every_word_is_bounded_in_every_dialect() {
    let digits = "9".repeat(310);
    for control in ALL {
        for word in ["F", "S", "F-", "T", "X", "Z"] {
            let told = refusals(&format!("G1 X1. {word}{digits}\nM30\n"), control);
            let wanted = ["number too large", "the line is longer than 251 characters"];
            assert!(
                told.first().is_some_and(|one| wanted.contains(&one.2.as_str())),
                "{} {word}: {told:?}",
                control.name
            );
        }
        for (word, message) in [
            ("F99999999999.", "F99999999999 is above 9,999,999,999"),
            ("F100000.", "F100000 is above 99,999.999"),
            ("S100000", "S100000 is above 99,999.999"),
            ("T10000000000", "T10000000000 is above 9,999,999,999"),
        ] {
            let told = refusals(&format!("G1 X1. Z1. F0.1 S100\n{word}\nM30\n"), control);
            let told: Vec<&str> = told.iter().filter(|one| one.0 == 2).map(|one| one.2.as_str()).collect();
            // A control without a limit of its own takes an F that a number holds.
            let taken = word == "F100000." && !control.feed.limit.as_coordinate();
            let expected: &[&str] = if taken { &[] } else { &[message] };
            assert_eq!(told, expected, "{} {word}", control.name);
        }
    }
    assert!(refusals("G21 G93 G1 X1 F1000000\nM2\n", &LINUXCNC).is_empty(), "an inverse time in minutes");
    let cycle = "T1 D1 S100 M3\nG83 X0 Z0 I-10 B5 D1 K9999999\nM30\n";
    assert!(refusals(cycle, &FAGOR_8055_T).iter().any(|one| one.2.contains("K9999999 is beyond")));
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
    fn no_damage_to_a_good_program_brings_it_down(which in 0..super::corpus::names("good").len(), at in any::<prop::sample::Index>(), byte in any::<u8>()) {
        let name = super::corpus::names("good").swap_remove(which);
        let (mut program, _) = super::corpus::good(&name);
        let at = at.index(program.len());
        program[at] = byte;
        for motion in read(&program).into_iter().flatten() {
            prop_assert!(motion.machine.0.iter().chain(&motion.to.0).all(|axis| axis.is_finite()), "{motion:?}");
        }
    }
}
