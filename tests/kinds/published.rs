//! The published figures, to their last printed digit.
//!
//! Figures in `golden/` are those printed in the annexes of the thesis (UPCT, 2021).

use crate::common;

use rodete::kinds::impeller::design::Design;
use rodete::parameter::Value;
use rodete::table::Entry;

/// The printed figures of an annex: rows of numbers as text.
fn golden(name: &str) -> Vec<Vec<String>> {
    let text = std::fs::read_to_string(format!("tests/golden/{name}.csv")).unwrap();
    text.lines().skip(1).map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

/// Half a unit of the last printed digit, and a little for the spreadsheet's own noise near 0.
fn tolerance(printed: &str) -> f64 {
    let decimals: usize = printed.split(['E', 'e']).next().unwrap().split('.').nth(1).map_or(0, str::len);
    let exponent: i32 = printed.split(['E', 'e']).nth(1).map_or(0, |exponent| exponent.parse().unwrap());
    // A figure printed with an exponent below the precision of the rest is the spreadsheet's rounding noise.
    if exponent < -9 { 1e-14 } else { 0.51 * rodete::number::trig::pow(10.0, f64::from(exponent) - decimals as f64) }
}

fn compare(table: &str, columns: &[&str], name: &str, changes: &[(&'static str, Value)]) {
    let outcome = common::outcome("tfg-2021", changes);
    let table = outcome.table(table).unwrap();
    let rows = golden(name);
    assert_eq!(table.rows(), rows.len(), "rows of {name}");
    for (i, row) in rows.iter().enumerate() {
        assert_eq!(row.len(), columns.len());
        for (symbol, printed) in columns.iter().zip(row) {
            let Entry::Number(value) = table.column(symbol).unwrap().values.get(i) else { panic!("a number") };
            let expected: f64 = printed.parse().unwrap();
            assert!(
                (value - expected).abs() <= tolerance(printed),
                "{name}, i = {i}, {symbol}: computed {value}, printed {printed}"
            );
        }
    }
}

#[test]
fn annex_1_is_reproduced_to_its_last_digit() {
    compare("annex-1", &["v", "u"], "annex-01-v-u", &[]);
}

#[test]
fn annex_2_is_reproduced_to_its_last_digit() {
    compare("annex-2", &["x", "y", "z"], "annex-02-midline", &[]);
}

#[test]
fn annex_3_is_reproduced_to_its_last_digit() {
    compare("annex-3", &["N_x", "N_y", "N_z"], "annex-03-normal", &[]);
    compare("annex-3", &["t_x", "t_y", "t_z"], "annex-03-tangent", &[]);
    compare("annex-3", &["b_x", "b_y", "b_z"], "annex-03-binormal", &[]);
}

#[test]
fn annex_4_is_reproduced_to_its_last_digit() {
    compare("annex-4", &["C", "B"], "annex-04-angles", &[]);
}

#[test]
fn annex_5_is_reproduced_to_its_last_digit_with_its_own_pivot_length() {
    compare("annex-5", &["x", "y", "z"], "annex-05-transformed", &[("H", Value::Real(233.95 - 147.5))]);
}

#[test]
fn annex_6_is_reproduced_to_its_last_digit() {
    compare("annex-6", &["x", "y", "z", "B", "C"], "annex-06-obverse", &[]);
}

#[test]
fn annex_7_is_reproduced_to_its_last_digit() {
    compare("annex-7", &["x", "y", "z", "B", "C"], "annex-07-reverse", &[]);
}

/// That the published turning has no S is said with style = annex, by a cell that can be changed.
#[test]
fn of_a_published_program_nothing_is_asked_that_no_cell_gives() {
    let outcome = common::outcome("tfg-2021", &[]);
    let codes: Vec<_> = outcome.findings.iter().map(rodete::finding::Finding::code).collect();
    assert!(codes.contains(&"P1021") && !codes.contains(&"G0502"), "{codes:?}");
}

#[test]
fn annex_8_is_reproduced_to_its_last_digit() {
    let outcome = common::outcome("tfg-2021", &[]);
    let table = outcome.table("annex-8").unwrap();
    for (i, row) in golden("annex-08-safety").iter().enumerate() {
        for (symbol, printed) in [("β", &row[1]), ("Δx", &row[3]), ("Δy", &row[4]), ("x", &row[5]), ("y", &row[6])] {
            let Entry::Number(value) = table.column(symbol).unwrap().values.get(i) else { panic!("a number") };
            let expected: f64 = printed.parse().unwrap();
            assert!((value - expected).abs() <= tolerance(printed), "row {i}, {symbol}: {value}, printed {printed}");
        }
        for (column, printed) in [(0, &row[0]), (1, &row[2])] {
            let Entry::Text(text) = table.columns[column].values.get(i) else { panic!("a text") };
            assert_eq!(&text.en, printed);
        }
    }
}

fn printed(name: &str) -> Vec<String> {
    std::fs::read_to_string(format!("tests/golden/{name}.nc")).unwrap().lines().map(str::to_owned).collect()
}

fn lines(text: &str) -> Vec<String> {
    text.lines().map(str::to_owned).collect()
}

/// The words of a block by letter.
fn words(block: &str) -> Vec<(char, f64)> {
    block.split_whitespace().map(|word| (word.chars().next().unwrap(), word[1..].parse().unwrap())).collect()
}

#[test]
fn annex_9_is_reproduced_to_the_character_on_its_sound_blocks() {
    let ours = lines(&common::program(&common::outcome("tfg-2021", &[]), "blade"));
    let theirs = printed("annex-09-blade-as-printed");
    assert_eq!(ours.len(), theirs.len());
    // N10–N450 and N860–N890.
    for at in (0..45).chain(85..89) {
        assert_eq!(ours[at], theirs[at]);
    }
}

#[test]
fn annex_9_runs_the_reverse_backwards_with_signs_changed() {
    let ours = lines(&common::program(&common::outcome("tfg-2021", &[]), "blade"));
    // N30–N420 is the obverse, N460–N850 the reverse: the same increments, backwards.
    for k in 0..40 {
        let (obverse, reverse) = (words(&ours[2 + k]), words(&ours[84 - k]));
        assert_eq!(obverse.len(), 7);
        for (one, other) in obverse.iter().zip(&reverse).skip(2) {
            assert_eq!(one.0, other.0);
            assert!((one.1 + other.1).abs() < 1e-9, "{} against {}", ours[2 + k], ours[84 - k]);
        }
    }
}

/// Blocks of annex 10 whose printed increment was subtracted first and rounded after; ours rounds first.
const ROUNDED_LAST: &[&str] = &[
    "N50", "N60", "N70", "N100", "N130", "N140", "N150", "N160", "N180", "N190", "N200", "N220", "N270", "N330",
    "N340", "N360", "N390", "N400", "N410", "N470", "N480", "N490", "N520", "N540", "N550", "N610", "N670", "N680",
    "N690", "N700", "N720", "N730", "N750", "N780", "N790", "N820", "N830", "N840",
];

#[test]
fn annex_10_is_reproduced_but_for_the_blocks_that_were_rounded_last() {
    let ours = lines(&common::program(&common::outcome("tfg-2021", &[]), "splitter"));
    let theirs = printed("annex-10-splitter-as-printed");
    assert_eq!(ours.len(), theirs.len());
    let mut differ = Vec::new();
    for (one, other) in ours.iter().zip(&theirs) {
        if one == other {
            continue;
        }
        let (number, closing) = (one.split(' ').next().unwrap(), "N860");
        if number == closing {
            assert_eq!((one.as_str(), other.as_str()), ("N860 G1 X-8 Y-4 Z0 B0 C0", "N860 G1 X-8 Y0 Z0 B0 C0"));
            continue;
        }
        for (a, b) in words(one).iter().zip(&words(other)) {
            assert!(a.0 == b.0 && (a.1 - b.1).abs() < 0.00101, "{one} against {other}");
        }
        differ.push(number.to_owned());
    }
    assert_eq!(differ, ROUNDED_LAST);
}

#[test]
fn annex_10_printed_its_increments_subtracted_first_and_rounded_after() {
    let outcome = common::outcome("tfg-2021", &[]);
    let table = outcome.table("splitter").unwrap();
    let value = |symbol: &str, i: usize| match table.column(symbol).unwrap().values.get(i) {
        Entry::Number(value) => value,
        Entry::Text(_) => panic!("a number"),
    };
    let theirs = printed("annex-10-splitter-as-printed");
    for k in 0..40 {
        for (path, from, to, line) in [("1", k, k + 1, 2 + k), ("2", 40 - k, 39 - k, 45 + k)] {
            let block = words(&theirs[line]);
            for (at, axis) in ["x", "y", "z"].into_iter().enumerate() {
                let symbol = format!("{axis}_{path}");
                let difference = value(&symbol, to) - value(&symbol, from);
                assert!((difference - block[2 + at].1).abs() < 0.000_51, "{}, {axis}: {difference}", theirs[line]);
            }
        }
    }
}

#[test]
fn the_turning_program_is_reproduced_to_the_character() {
    let ours = lines(&common::program(&common::outcome("tfg-2021", &[]), "blank"));
    assert_eq!(ours, printed("lathe-g85-as-printed"));
}

#[test]
fn limits_of_the_published_case_are_those_printed() {
    let outcome = common::outcome("tfg-2021", &[]);
    let value = |symbol: &str| outcome.quantities.iter().find(|one| one.symbol == symbol).unwrap().value;
    assert_eq!(value("N_max"), 5.0);
    assert!((value("L") - 242.9).abs() < 1e-12);
    assert!((value("beta") - 36.869_897_6).abs() < 5e-8);
    assert!((value("crossing") - 19.13).abs() < 0.005);
    assert_eq!(value("m"), 20.0);
    assert!((value("e_max") - (4.0 * std::f64::consts::PI - 8.0)).abs() < 1e-12);
    let design = Design::new(&common::fields("tfg-2021", &[])).unwrap();
    assert_eq!(common::blade(&design).points(), 41);
}
