//! Speeds, times and rates: by hand, and the same in every table.

use std::path::Path;

use calamine::{Data, Reader, Xlsx, open_workbook};
use rodete::text::Language;
use serde_json::Value as Json;

use super::bench::{Book, bilingual, build, program, quantity, run};

fn near(value: f64, wanted: f64) {
    assert!((value - wanted).abs() < 1e-6 * wanted.abs().max(1.0), "{value} {wanted}");
}

/// The document of blocks behind the head, over a bar of 50 by 120 mm.
fn simulate(blocks: &str) -> Json {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("p.nc"), program(blocks).join("\n")).unwrap();
    let said = run(
        folder.path(),
        &[
            "simulate",
            "p.nc",
            "--dialect",
            "fanuc-lathe-a",
            "--stock",
            "D50xL120",
            "--decimal-point",
            "calculator",
            "--json",
        ],
    );
    let document = serde_json::from_str(&said.out).unwrap_or_else(|_| panic!("{}", said.err));
    bilingual(&document);
    document
}

/// Number, line, X and Z of every alarm.
fn alarms(document: &Json) -> Vec<(u64, u64, f64, f64)> {
    let one = |alarm: &Json| {
        let real = |key: &str| alarm[key].as_f64().unwrap();
        (alarm["number"].as_u64().unwrap(), alarm["line"].as_u64().unwrap(), real("x_mm"), real("z_mm"))
    };
    document["alarms"].as_array().unwrap().iter().map(one).collect()
}

#[test]
fn a_constant_surface_speed_is_that_at_the_metal() {
    let fastest = |blocks: &str| simulate(blocks)["totals"]["greatest_cutting_speed_m_min"].as_f64().unwrap();
    // Faced from beyond the bar to the axis: the programmed diameter is the one that is cut.
    near(fastest("G96 S180|G0 X80. Z-1.|G1 X-1.6 F0.2"), 180.0);
    near(fastest("G96 S180|G0 X54. Z-1.|G1 X30. F0.2"), 180.0);
    // Turned from 50 to 46 mm: the spindle turns for 46 and the bar's surface is at 50.
    near(fastest("G96 S180|G0 X46.|G1 Z-20. F0.2|U8."), 180.0 * 50.0 / 46.0);
    // 2500 rpm at the most.
    near(fastest("G96 S400|G0 X46.|G1 Z-20. F0.2|U8."), std::f64::consts::PI * 50.0 * 2.5);
    near(fastest("G97 S900|G0 X80. Z-1.|G1 X-1.6 F0.2"), std::f64::consts::PI * 50.0 * 0.9);
}

/// The columns of a sheet of results below its headings.
fn column(path: &Path, sheet: &str, heading: &str) -> Vec<f64> {
    let mut book: Xlsx<_> = open_workbook(path).unwrap();
    let range = book.worksheet_range(sheet).unwrap();
    let cell = |row: &[Data]| row.iter().position(|cell| *cell == Data::String(heading.to_owned()));
    let (row, at) = range.rows().enumerate().find_map(|(row, cells)| Some((row, cell(cells)?))).unwrap();
    let number = |cells: &[Data]| match cells.get(at) {
        Some(Data::Float(value)) => Some(*value),
        _ => None,
    };
    range.rows().skip(row + 1).filter_map(number).collect()
}

#[test]
fn times_volumes_and_rates_are_the_same_in_every_table() {
    let (folder, document, exit) = build(&Book::of(Language::En).bytes());
    assert_eq!(exit, 0);
    let results = folder.path().join("out/part-results.xlsx");
    let column = |sheet: &str, heading: &str| column(&results, sheet, heading);
    let sum = |sheet: &str, heading: &str| column(sheet, heading).iter().sum::<f64>();
    for (heading, symbol) in [("t", "t"), ("t_c", "t_c"), ("V", "V_r")] {
        for sheet in ["By block", "By tool"] {
            near(sum(sheet, heading), quantity(&document, symbol));
        }
    }
    let most = |sheet: &str, heading: &str| column(sheet, heading).into_iter().fold(0.0, f64::max);
    for heading in ["Q", "V_c", "a_p"] {
        for sheet in ["Motions", "By block", "By tool"] {
            near(most(sheet, heading), quantity(&document, heading));
        }
    }
    // The thread's block and its tool are one: what it takes away when it is pulled out at rapid is no cut.
    let (blocks, thread) = (column("By block", "Q"), column("By tool", "Q")[3]);
    assert!(thread > 0.0 && blocks.iter().any(|block| (block - thread).abs() < 1e-9), "{thread} {blocks:?}");
}

#[test]
fn what_is_wrong_in_a_cut_is_told_where_it_begins() {
    let document = simulate("M9|G96 S180 M4|G0 X54. Z-1.|G1 X-1.6 F0.2");
    let found = alarms(&document);
    assert_eq!(found.iter().map(|(number, line, ..)| (*number, *line)).collect::<Vec<_>>(), [(154, 9), (161, 9)]);
    for (_, _, x, z) in found {
        near(x, 50.0);
        near(z, -1.0);
    }
    let stopped = simulate("M5|G98|G0 X46. Z5.|G1 Z-20. F100.");
    let (number, line, x, z) = alarms(&stopped)[0];
    assert_eq!((number, line, x), (153, 9, 46.0));
    assert!((0.0..1.0).contains(&z), "{z}");
}

#[test]
fn a_feed_meant_the_other_way_is_cautioned_and_one_of_turning_is_not() {
    let count = |blocks: &str| alarms(&simulate(blocks)).iter().filter(|(number, ..)| *number == 172).count();
    for (feed, wanted) in [
        ("G98|G1 Z-20. F0.2", 1),
        ("G98|G1 Z-20. F180.", 0),
        ("G98|G1 Z-20. F20.", 0),
        ("G99|G1 Z-20. F180.", 1),
        ("G99|G1 Z-20. F0.02", 0),
        ("G99|G1 Z-20. F1.5", 0),
        // Twice at the same feed is once; out of the cut it is nothing.
        ("G98|G1 Z-20. F0.2|G0 X54.|Z2.|X42.|G1 Z-20.", 1),
        ("G98|G1 Z1.9 F0.2", 0),
    ] {
        assert_eq!(count(&format!("G0 X46.|{feed}|G0 X54.|G99")), wanted, "{feed}");
    }
    let feed = &simulate("G0 X46.|G98|G1 Z-20. F0.2|G0 X54.")["alarms"][0];
    assert_eq!((feed["grade"].as_str(), feed["line"].as_u64()), (Some("caution"), Some(8)));
}

#[test]
fn a_thread_at_a_constant_surface_speed_is_cautioned_once() {
    let numbers = |blocks: &str| alarms(&simulate(blocks)).iter().map(|(number, ..)| *number).collect::<Vec<_>>();
    let passes = "G0 X54. Z6.|G92 X49.5 Z-20. F2.|X49.|X48.6|G0 X60.";
    assert_eq!(numbers(&format!("T0404|G96 S100|{passes}")), [145]);
    assert_eq!(numbers(&format!("T0404|G97 S600|{passes}")), Vec::<u64>::new());
    // The limit holds in all passes: the speed is one.
    assert_eq!(numbers(&format!("G50 S300|T0404|G96 S100|{passes}")), Vec::<u64>::new());
}
