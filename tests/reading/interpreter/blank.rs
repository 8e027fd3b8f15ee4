//! Blank lines count as lines and are nothing else, wherever the program jumps to.

use rodete::gcode::control::{Control, FANUC_LATHE_A};
use rodete::gcode::interpreter::{Interpreter, Setting};
use rodete::gcode::motion::Motion;
use rodete::machine::axis::Pose;

use super::common::rs274::Judge;
use super::{corpus, ours};

/// The motions of a program by their lines, or its first refusal.
fn read(program: &[u8], setting: Setting) -> Result<Vec<(usize, Pose)>, String> {
    let placed = |motion: Motion| (motion.line, motion.machine);
    let refused = |fault: Box<rodete::gcode::interpreter::Refused>| format!("{}: {}", fault.line, fault.what.en);
    Interpreter::over(program, setting).map(|item| item.map(placed).map_err(refused)).collect()
}

/// A text with every line ended in another way, and with blank lines behind it.
fn spread(text: &str, end: &str, times: usize) -> String {
    text.lines().map(|line| line.to_owned() + &end.repeat(times)).collect()
}

#[test]
fn a_blank_line_behind_every_line_changes_nothing_but_the_line_numbers() {
    let tools = corpus::tools();
    let mut jumps = 0;
    for name in corpus::names("good") {
        let (program, var) = corpus::good(&name);
        let text = String::from_utf8_lossy(&program).replace("\r\n", "\n").replace('\r', "\n");
        if text.contains("#<_line>") {
            continue;
        }
        jumps += usize::from(text.contains("endsub") || text.contains("endwhile") || text.contains("M98"));
        let judge = Judge { var: var.as_deref(), tools: Some(&tools), ..Judge::default() };
        let plain = read(text.as_bytes(), ours::setting(&judge)).unwrap_or_else(|fault| panic!("{name}: {fault}"));
        for end in ["\n", "\r\n"] {
            for times in [1, 2, 3] {
                let wanted: Vec<_> = plain.iter().map(|&(line, pose)| ((line - 1) * times + 1, pose)).collect();
                let found = read(spread(&text, end, times).as_bytes(), ours::setting(&judge));
                assert_eq!(found.as_ref(), Ok(&wanted), "{name}: {times} ends {end:?}");
            }
        }
    }
    assert!(jumps > 5, "{jumps} programs that jump");
}

#[test]
fn blank_lines_where_calls_and_returns_of_a_fanuc_lead_are_counted() {
    let text =
        "O0001\nG0 X10. Z10.\nM98 P0002\nG0 X20.\nM97 P100\nG0 X30.\nM30\nN100 G0 Z1.\nM99\nO0002\nG0 X15.\nM99\n";
    let fanuc: &'static Control = &FANUC_LATHE_A;
    let plain = read(text.as_bytes(), Setting::new(fanuc)).expect("a program that is taken");
    assert_eq!(plain.iter().map(|one| one.0).collect::<Vec<_>>(), [2, 11, 4, 8, 6]);
    for end in ["\n", "\r\n", "\r"] {
        for times in [1, 2, 3] {
            let wanted: Vec<_> = plain.iter().map(|&(line, pose)| ((line - 1) * times + 1, pose)).collect();
            assert_eq!(read(spread(text, end, times).as_bytes(), Setting::new(fanuc)), Ok(wanted), "{times} {end:?}");
        }
    }
}

#[test]
fn a_refusal_behind_a_jump_names_its_line() {
    let program = "o1 sub\n\nG0 X1\no1 endsub\n\n\no1 call\n\nG77\nM2\n";
    let found = read(program.as_bytes(), ours::setting(&Judge::default()));
    assert_eq!(
        found,
        Err("9: G77 is not known to rodete in the dialect linuxcnc, and rodete runs it in no other".to_owned())
    );
}
