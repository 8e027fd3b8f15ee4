//! Short programs that nobody would write, each with what must be said of it.

use rodete::parameter::Value;
use rodete::parameter::list::{Row, Rows};
use serde_json::Value as Json;

use crate::bench::{Book, bilingual, build, line, program, run};

/// The document and the exit code of a program over a bar.
fn simulate(lines: &[&str], stock: &str) -> (Json, i32) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("p.nc"), lines.join("\n")).unwrap();
    let bar = ["--dialect", "fanuc-lathe-a", "--stock", stock, "--decimal-point", "calculator", "--json"];
    let said = run(folder.path(), &[&["simulate", "p.nc"], &bar[..]].concat());
    let document = serde_json::from_str(&said.out).unwrap_or_else(|_| panic!("{}", said.err));
    bilingual(&document);
    (document, said.exit)
}

/// Grade, line, number and depth of every finding of some gravity.
fn grave(document: &Json) -> Vec<String> {
    let findings = document["findings"].as_array().unwrap().iter().filter(|one| one["grade"] != "note");
    findings.map(|one| format!("{} {}", line(one), one["value"].as_str().unwrap_or_default())).collect()
}

#[test]
fn a_rib_of_a_thread_wholly_inside_the_metal_is_judged_as_any_other() {
    // The first rib stands 12 mm behind the face, the blade of 3 by 14 mm under the surface with all it is.
    let lines = ["T0303", "G98 G97 S333 M3", "G0 X33.0 Z2.0", "G32 X43.164 Z-13.325 F3.682", "M30"];
    let (document, exit) = simulate(&lines, "D200xL300");
    let wanted = [
        "stop 4 103 The holder runs into metal, X135.582 Z-13.225 13.225 mm",
        "caution 4 144 A thread is cut with a tool that is not for threads, X33 Z2 ",
    ];
    assert_eq!((grave(&document), exit), (wanted.map(str::to_owned).to_vec(), 3));
    // The farthest out that the blade cuts is the top of its sides, 14 mm out from its tip at r 21.384.
    let fastest = document["totals"]["greatest_cutting_speed_m_min"].as_f64().unwrap();
    let wanted = std::f64::consts::TAU * (21.384 + 14.0) * 0.333;
    assert!((fastest / wanted - 1.0).abs() < 1e-4, "{fastest} {wanted}");
}

#[test]
fn of_a_part_that_is_all_gone_no_deviation_of_0_is_told() {
    // A bar of 8 mm, turned away over its whole length, and the jaws with it.
    let row = |X: f64, Z: f64| Row {
        values: [("profile/G", Value::Choice("1")), ("profile/X", Value::Real(X)), ("profile/Z", Value::Real(Z))]
            .into(),
        cells: std::collections::BTreeMap::new(),
    };
    let rows = vec![row(10.0, 0.0), row(10.0, -20.0)];
    let book = Book::new(&program("G0 X-.4|G1 Z-125. F.2")).put("D", Value::Real(8.0));
    let (_folder, document, exit) = build(&book.list(Rows { list: "profile", sheet: String::new(), rows }).bytes());
    bilingual(&document);
    let wanted =
        "caution file nothing is left of the part to hold against the profile on the workbook's sheet PROFILE ";
    assert!(grave(&document).contains(&wanted.to_owned()), "{:?}", grave(&document));
    assert_eq!(exit, 3);
}
