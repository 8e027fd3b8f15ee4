//! M97, M98 and M99.

use std::collections::BTreeMap;

use rodete::finding::Exit;

use super::lines::{Folder, Read, line, read_with, refusal, refusal_with, setting};

fn with_files(program: &str, files: &[(&str, &str)]) -> Read {
    let mut setting = setting();
    let files: BTreeMap<_, _> = files.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect();
    setting.files = Box::new(Folder(files));
    read_with(program, setting)
}

fn z(read: &Read) -> Vec<String> {
    assert!(read.faults.is_empty(), "{:?}", read.faults);
    read.motions.iter().map(line).map(|line| line.replace("G0 X0 ", "")).collect()
}

#[test]
fn m97_runs_the_blocks_behind_the_end_of_the_program() {
    let read = read_with("G0 X0 Z0\nM97 P100 L3\nZ50.\nM97 P200\nM30\nN100 W1.\nM99\nN200 W-10.\nM99\n", setting());
    assert_eq!(z(&read), ["Z0", "Z1", "Z2", "Z3", "Z50", "Z40"]);
}

#[test]
fn m98_runs_a_program_of_the_same_file_or_beside_it() {
    let sub = "%\nO0005 (GROOVE)\nG0 W1.\nM99\n%\n";
    for name in ["O0005", "0005", "5"] {
        assert_eq!(z(&with_files("G0 X0 Z0\nM98 P30005\nM30\n", &[(name, sub)])), ["Z0", "Z1", "Z2", "Z3"], "{name}");
    }
    // Without a number of its own, and with L.
    assert_eq!(z(&with_files("M98 P0005 L2\nM30\n", &[("5", "G0 W1.\nM99\n")])), ["Z1", "Z2"]);
    assert_eq!(z(&with_files("M98 P5 L0\nG0 Z7.\nM30\n", &[("5", "%\nG0 W1.\nM99\n%\n")])), ["Z7"]);
    let same = "O0001\nM98 P0007\nM98 P20008\nM30\nO0007\nG0 W1.\nM99\nO0008\nN10 G0 W.5\nM99\n";
    assert_eq!(z(&with_files(same, &[])), ["Z1", "Z1.5", "Z2"]);
}

#[test]
fn a_motion_in_the_block_of_a_call_is_made_before_it() {
    let read = with_files("G0 Z10. M98 P5\nM30\n", &[("5", "G0 W1.\nM99\n")]);
    assert_eq!(z(&read), ["Z10", "Z11"]);
}

#[test]
fn subprograms_call_subprograms_four_deep() {
    let chain: Vec<(String, String)> = (1..=4)
        .map(|n| {
            (n.to_string(), format!("G0 W1.\n{}M99\n", if n < 4 { format!("M98 P{}\n", n + 1) } else { String::new() }))
        })
        .collect();
    let files: Vec<(&str, &str)> = chain.iter().map(|(name, text)| (name.as_str(), text.as_str())).collect();
    assert_eq!(z(&with_files("M98 P1\nM30\n", &files)).len(), 4);
    let read = with_files("M98 P1\nM30\n", &[("1", "M98 P2\nM99\n"), ("2", "M98 P1\nM99\n")]);
    let fault = read.faults.first().unwrap();
    assert_eq!(fault.exit, Exit::Limit);
    assert!(fault.what.en.contains("more than 4 nested calls: O1 → O2 → O1 → O2 → O1"), "{}", fault.what.en);
    let refused = refusal("M97 P100\nM30\nN100 M97 P100\nM99\n");
    assert!(refused.contains("N100 → N100 → N100 → N100 → N100"), "{refused}");
}

#[test]
fn m99_with_p_goes_back_to_a_block_of_the_caller() {
    let read = read_with("G0 X0 Z0\nM97 P100\nZ5.\nN50 Z6.\nM30\nN100 W1.\nM99 P50\n", setting());
    assert_eq!(z(&read), ["Z0", "Z1", "Z6"]);
}

#[test]
fn a_block_that_m99_does_not_find_is_refused_in_its_own_file() {
    for (program, said) in [
        ("M98 P2\nM30\n", "PS0078: there is no block N50 in the program that calls"),
        ("M98 P2\nN50 Z6.\nM30\nN50 Z7.\n", "two blocks have the number N50: in lines 2 and 4 of the program"),
    ] {
        let read = with_files(program, &[("O0002", "G0 X10.\n\nM99 P50\n")]);
        let [fault] = read.faults.as_slice() else { panic!("{:?}", read.faults) };
        assert_eq!((fault.file.as_deref(), fault.line, fault.columns.as_slice()), (Some("O0002"), 3, [5].as_slice()));
        assert_eq!(fault.message().en, said);
    }
    assert!(refusal("M98 P2\nM30\nO2\nM99 P50\n").starts_with("4:5 PS0078: there is no block N50;"));
}

#[test]
fn block_numbers_belong_to_their_program() {
    let program = "O0001\nM97 P10\nM98 P0002\nM30\nN10 G0 W1.\nM99\nO0002\nM97 P10\nM99\nN10 G0 W10.\nM99\n";
    assert_eq!(z(&with_files(program, &[])), ["Z1", "Z11"]);
}

#[test]
fn calls_that_lead_nowhere_are_refused() {
    for (program, message) in [
        ("M98 P7\nM30\n", "1:5 PS0078: there is no subprogram O0007; put it in a file O0007.nc beside the program"),
        ("M98\nM30\n", "1:1 M98 without P"),
        ("M97 L2\nM30\n", "1:1 M97 without P"),
        ("M97 P7\nM30\n", "1:5 PS0078: there is no block N7"),
        ("M97 P7\nM30\nN7 M99\nN7 M99\n", "1:5 two blocks have the number N7: in lines 3 and 4"),
        ("M98 P7 L10000\nM30\n", "1:8 L10000 is not a number of repeats"),
        ("M98 P20007 L2\nM30\n", "1:5 P20007 and L both give a number of repeats"),
        ("M98 P990000007\nM30\n", "1:5 P990000007 asks for 99000 repeats"),
        ("M98 P0\nM30\n", "1:5 P0 is not a subprogram number"),
        ("G0 X1.\nM99\nM30\n", "2 M99 in the main program repeats it forever"),
        ("O1\nM98 P2\nM30\nO2\nM99\nO2\nM99\n", "2:5 O0002 is defined twice: 4, 6"),
        ("O1\nM98 P2\nM30\nO2\nG0 X1.\nO3\nM99\n", "6 the file ends inside a subprogram"),
        ("O1\nG0 X1.\nO2\nM99\n", "3 the program ends without M2 or M30"),
        ("G83 X0 Z-5. R1. Q1000 F.1 M98 P5\nM30\n", "1:27 M98 or M99 with other words in the block"),
    ] {
        let refused = refusal(program);
        assert!(refused.starts_with(message), "{program}\n{refused}");
    }
}

#[test]
fn a_subprogram_in_two_files_or_in_the_wrong_one_is_refused() {
    let files = |files: &[(&str, &str)]| {
        let read = with_files("M98 P5\nM30\n", files);
        read.faults.first().map(|fault| fault.what.en.to_string()).unwrap_or_default()
    };
    assert_eq!(files(&[("O0005", "G0 W1.\nM99\n"), ("5", "G0 W2.\nM99\n")]), "O0005 is defined twice: O0005, 5");
    assert_eq!(files(&[("5", "O0006\nM99\n")]), "the file '5' holds O0006, not O0005");
    assert!(files(&[("5", "%\nO5\nG0 W1.\n%\n")]).contains("the file ends inside a subprogram"));
}

#[test]
fn endless_repeats_come_to_the_budget() {
    let mut setting = setting();
    setting.budget.repeated_blocks = 1_000;
    let refused = refusal_with("M97 P10 L9999\nM30\nN10 G4 P1\nM99\n", setting);
    assert!(refused.contains("the program has repeated more than 1000 blocks"), "{refused}");
}
