//! Blocks by chance: any words beside one another, most of them wrong, so that what is refused is compared too.

use std::fmt::Write;

use proptest::prelude::*;

use super::generator::{Dice, Roll, plain};

const G: [&str; 58] = [
    "0", "1", "2", "3", "4", "10", "17", "18", "19", "28", "28.1", "30", "30.1", "40", "43", "43.1", "43.2", "49",
    "52", "53", "54", "55", "59.3", "61", "61.1", "64", "73", "74", "80", "81", "82", "83", "84", "85", "86", "89",
    "90", "90.1", "91", "91.1", "92", "92.1", "92.2", "92.3", "93", "94", "95", "96", "97", "98", "99", "0", "1", "2",
    "3", "81", "16", "5.9",
];
const M: [&str; 12] = ["3", "4", "5", "7", "8", "9", "48", "49", "0", "1", "2", "60"];

/// One or two codes with some of the words that belong to them, and now and then one that does not.
fn block(mut roll: Roll) -> String {
    let mut line = String::new();
    let code = roll.of(&G);
    if !roll.one_in(8) {
        let _ = write!(line, " G{code}");
    }
    if roll.one_in(8) {
        let _ = write!(line, " G{}", roll.of(&G));
    }
    if roll.one_in(10) {
        let _ = write!(line, " M{}", roll.of(&M));
    }
    let fitting = match code {
        "0" | "1" | "28" | "30" | "52" | "53" | "92" | "43.1" => "XYZXA",
        "2" | "3" => roll.of(&["XYIJ", "XYR", "XYIJZ", "XYRZ", "IJP", "XYIJKR"]),
        "4" => "P",
        "10" => "LPXYZR",
        "43" | "43.2" => "H",
        "96" => "DS",
        "64" => "PQ",
        "82" | "86" | "89" => roll.of(&["XYZRP", "XYZRP", "XRPL"]),
        "73" | "83" => roll.of(&["XYZRQ", "XYZRQ", "XRQL"]),
        "74" | "81" | "84" | "85" => roll.of(&["XYZR", "XYZR", "XRPQ"]),
        "61" | "61.1" | "80" | "98" | "99" => "",
        _ => "X",
    };
    for letter in fitting.chars() {
        if !roll.one_in(4) && !line.contains(letter) {
            word(&mut line, letter, &mut roll);
        }
    }
    if roll.one_in(9) {
        let letter =
            roll.of(&['X', 'Y', 'Z', 'A', 'I', 'J', 'K', 'R', 'P', 'Q', 'L', 'F', 'S', 'H', 'D', 'T', 'E', 'N']);
        word(&mut line, letter, &mut roll);
    }
    if matches!(code, "1" | "93" | "95") && !line.contains('F') && roll.one_in(2) {
        word(&mut line, 'F', &mut roll);
    }
    line.trim_start().to_owned() + "\n"
}

fn word(line: &mut String, letter: char, roll: &mut Roll) {
    let number = match letter {
        'L' => roll.of(&["1", "2", "2", "10", "11", "20", "20", "0", "-1", "3"]).to_owned(),
        'P' => roll.of(&["1", "2", "1", "2", "3", "0", "0.5", "10", "-1"]).to_owned(),
        'H' | 'T' | 'D' => roll.of(&["1", "2", "1", "2", "7", "0", "99", "-1", "1.5"]).to_owned(),
        'F' | 'S' => roll.of(&["100", "250.5", "100", "80", "0", "-5"]).to_owned(),
        'N' => "7".to_owned(),
        'Q' => roll.of(&["1", "2.5", "4", "0", "-1"]).to_owned(),
        _ => plain(roll.number(-20, 20)),
    };
    let _ = write!(line, " {letter}{number}");
}

prop_compose! {
    /// A state that most words can act on, and blocks by chance.
    pub fn soups()(
        blocks in prop::collection::vec(any::<Dice>(), 1..5),
        feed in any::<bool>(),
    ) -> String {
        let mut text = String::from("G21 G90 G17 S500 M3 T1\n");
        if feed {
            text.push_str("F200\n");
        }
        text.push_str("G0 X1 Y2 Z3\n");
        for dice in blocks {
            text.push_str(&block(Roll::new(dice)));
        }
        text + "M2\n"
    }
}
