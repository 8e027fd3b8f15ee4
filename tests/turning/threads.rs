//! What must stay the same from one pass of a thread to the next.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::fs;
use std::process::Command;

use serde_json::Value;

/// The document and exit code of a simulation on a bar of D 30, between the usual first and last blocks of a thread.
fn simulated(program: &str) -> (Value, i32) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p.nc");
    fs::write(&path, program.replace('|', "\n")).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_rodete"))
        .arg("simulate")
        .arg(&path)
        .args(["--dialect", "fanuc-lathe-a", "--decimal-point", "calculator", "--stock", "D30xL60", "--json"])
        .output()
        .unwrap();
    (serde_json::from_slice(&output.stdout).unwrap(), output.status.code().unwrap())
}

/// The alarms of passes of a thread, as number and line.
fn raised(blocks: &str) -> Vec<String> {
    let (document, exit) = simulated(&format!("G21 G40 G97 G99|T0404 S600 M3|{blocks}|G0 X150. Z100. M9|M30"));
    assert_eq!(exit, 0, "{blocks}: {:?}", document["findings"]);
    let alarms = document["alarms"].as_array().unwrap();
    alarms.iter().map(|alarm| format!("{}@{}", alarm["number"], alarm["line"])).collect()
}

#[test]
fn a_spindle_speed_that_changes_between_passes_of_a_thread_under_g97_is_cautioned() {
    for (blocks, expected) in [
        ("G0 X34. Z6. M8|G92 X29. Z-25. F2.|X28.5|G0 S900|G92 X28. Z-25. F2.", vec!["145@7"]),
        ("G0 X29. Z6. M8|G32 Z-20. F2.|G0 X34.|Z6.|S1200|X28.4|G32 Z-20. F2.|G0 X34.", vec!["145@9"]),
        (
            "G0 X34. Z6. M8|G76 P010060 Q100 R0.05|G76 X27.546 Z-25. P1227 Q400 F2.|S300|G76 P010060 Q100 R0.05|G76 X27.446 Z-25. P1277 Q400 F2.",
            vec!["145@8"],
        ),
        // Between them the thread is deburred with the same tool: it is the same thread.
        ("G0 X34. Z6. M8|G92 X29. Z-25. F2.|G1 X30. F.2|G0 X34.|Z6. S500|G92 X28.5 Z-25. F2.", vec!["145@8"]),
        // Another thread may have another speed.
        (
            "G0 X34. Z6. M8|G92 X29. Z-25. F2.|G0 X150. Z100.|T0101 S900|G0 X22. Z3.|G1 Z-12. F.2|X31.|G0 Z3.|X16.|G1 Z-12.|X31.|G0 X150. Z100.|T0404 S300|G0 X20. Z6.|G92 X15. Z-9. F2.",
            vec![],
        ),
        ("G0 X34. Z6. M8|G92 X29. Z-25. F2.|X28.5|G0 S600|G92 X28. Z-25. F2.", vec![]),
    ] {
        assert_eq!(raised(blocks), expected, "{blocks}");
    }
}

#[test]
fn a_deeper_pass_that_begins_in_another_groove_is_cautioned() {
    for (blocks, expected) in [
        ("G0 X34. Z6. M8|G92 X29. Z-25. F2.|X28.5|G0 Z5.|G92 X28. Z-25. F2.|X27.6", vec!["148@7"]),
        ("G0 X34. Z6. M8|G92 X29. Z-25. F2.|G0 Z6.1|G92 X28.9 Z-25. F2.", vec!["148@6"]),
        ("G0 X29. Z6. M8|G32 Z-20. F2.|G0 X34.|Z6.5|X28.4|G32 Z-20. F2.|G0 X34.", vec!["148@8"]),
        // A block of a thread goes on in its revolutions; the run-in of the second pass is longer by half a lead.
        ("G0 X29. Z7. M8|G32 Z3. F2.|Z-20.|G0 X34.|Z8.|X28.4|G32 Z3. F2.|Z-20.|G0 X34.", vec!["148@10"]),
        // Whole leads away it is the same groove.
        ("G0 X34. Z6. M8|G92 X29. Z-25. F2.|G0 Z8.|G92 X28. Z-25. F2.|G0 Z6.|G92 X27.6 Z-25. F2.", vec![]),
        ("G0 X29. Z7. M8|G32 Z3. F2.|Z-20.|G0 X34.|Z9.|X28.4|G32 Z3. F2.|Z-20.|G0 X34.", vec![]),
        // Two starts, by Z and by the angle Q: the second one repeats the depths of the first.
        (
            "G0 X34. Z8. M8|G76 P010060 Q100 R0.05|G76 X28. Z-25. P1000 Q400 F3.|G0 Z9.5|G76 X28. Z-25. P1000 Q400 F3.",
            vec![],
        ),
        ("G0 X34. Z8. M8|G92 X29.2 Z-25. F3. Q0|G92 X29.2 Z-25. F3. Q180000|X28.4 Q0|X28.4 Q180000", vec![]),
        // Half a turn of Q and half a lead of Z are the same groove again.
        ("G0 X34. Z8. M8|G92 X29.2 Z-25. F3.|G0 Z6.5|G92 X28.4 Z-25. F3. Q180000", vec![]),
        ("G0 X34. Z8. M8|G92 X29.2 Z-25. F3.|G0 Z8.|G92 X28.4 Z-25. F3. Q90000", vec!["148@6"]),
        // Along one flank, and from either flank in turn: the last pass takes in those before.
        ("G0 X34. Z6. M8|G92 X29. Z-25. F2.|G0 Z5.856|G92 X28.5 Z-25. F2.|G0 Z5.711|G92 X28. Z-25. F2.", vec![]),
        ("G0 X34. Z6.28 M8|G92 X29. Z-25. F2.|G0 Z5.86|G92 X28.5 Z-25. F2.|G0 Z6.|G92 X28. Z-25. F2.", vec![]),
        ("G0 X34. Z6.28 M8|G92 X29. Z-25. F2.|G0 Z5.86|G92 X28.5 Z-25. F2.", vec!["148@6"]),
        // The shallow first pass of a cycle along one flank leaves room for a pass that the last one does not take in.
        (
            "G0 X40. Z6. M8|G76 P010060 Q100 R0.05|G76 X27.5 Z-25. P1227 Q400 F2.|G0 X40. Z6.|G92 X27.4 Z-25. F2.",
            vec!["148@7"],
        ),
        (
            "G0 X40. Z6. M8|G76 P010060 Q100 R0.05|G76 X27.5 Z-25. P1227 Q400 F2.|G0 X40. Z5.263|G92 X27.4 Z-25. F2.",
            vec![],
        ),
    ] {
        assert_eq!(raised(blocks), expected, "{blocks}");
    }
}

#[test]
fn a_pass_deeper_than_half_a_millimetre_is_cautioned() {
    for (blocks, expected) in [
        // 0.6 and 0.4 on the radius; from 0.5 on it is no more than the makers allow.
        ("G0 X34. Z6. M8|G92 X28.8 Z-25. F2.|X28.", vec!["149@4"]),
        ("G0 X34. Z6. M8|G92 X29. Z-25. F2.|X28.", vec![]),
        ("G0 X34. Z6. M8|G92 X29.4 Z-25. F2.|X28.2|X27.6", vec!["149@5"]),
        ("G0 X29. Z6. M8|G32 Z-20. F2.|G0 X34.|Z6.|X27.8|G32 Z-20. F2.|G0 X34.", vec!["149@8"]),
        // Q600 is the first pass, and the next are less; the same depth in passes of 0.4 √n.
        ("G0 X34. Z6. M8|G76 P010060 Q100 R0.05|G76 X27.546 Z-25. P1227 Q600 F2.", vec!["149@5"]),
        ("G0 X34. Z6. M8|G76 P010060 Q100 R0.05|G76 X27.546 Z-25. P1227 Q400 F2.", vec![]),
        // The last pass takes what R leaves.
        ("G0 X34. Z6. M8|G76 P010060 Q100 R0.6|G76 X27.546 Z-25. P1227 Q400 F2.", vec!["149@5"]),
        // Beyond where the passes before ended it meets the full depth, and what a long one has left; a little farther does not count.
        ("G0 X34. Z6. M8|G92 X29.4 Z-15. F2.|X28.8|X28.2|X27.6 Z-25.", vec!["149@7"]),
        ("G0 X34. Z6. M8|G92 X29.2 Z-25. F2.|X28.4 Z-10.|X27.6|X27. Z-25.", vec!["149@7"]),
        ("G0 X34. Z6. M8|G92 X29.2 Z-20. F2.|X28.4 Z-21.5|X27.6 Z-22.", vec![]),
        // Farther out along the thread, in air.
        ("G0 X34. Z6. M8|G92 X29.2 Z-20. F2.|X28.4|G0 Z16.|G92 X27.6 Z-20. F2.", vec![]),
        // Infeed along the flank moves a pass along the thread, and not the place where all are pulled out over a lead: wherever they start.
        ("G0 X34. Z5. M8|G76 P021060 Q100 R0.02|G76 X26.75 Z-30. P1625 Q350 F2.5", vec![]),
        ("G0 X34. Z5.3 M8|G76 P021060 Q100 R0.02|G76 X26.75 Z-30. P1625 Q350 F2.5", vec![]),
        ("G0 X34. Z5.7 M8|G76 P021060 Q100 R0.02|G76 X26.75 Z-30. P1625 Q350 F2.5", vec![]),
        ("G0 X34. Z6. M8|G76 P021060 Q100 R0.05|G76 X27.546 Z-20. P1227 Q400 F2.", vec![]),
        ("G0 X34. Z6. M8|G76 P011560 Q100 R0.05|G76 X27.546 Z-25. P1227 Q400 F2.", vec![]),
        ("G0 X34. Z6. M8|G76 P012060 Q100 R0.05|G76 X27.546 Z-25. P1227 Q400 F2.", vec![]),
        // Deep passes with a pull-out over a lead: the first one, and the last.
        ("G0 X34. Z6. M8|G76 P011060 Q100 R0.05|G76 X27.546 Z-25. P1227 Q600 F2.", vec!["149@5"]),
        ("G0 X34. Z6. M8|G76 P011060 Q100 R0.6|G76 X27.546 Z-25. P1227 Q400 F2.", vec!["149@5"]),
        // Behind a run-in in a block of its own, and in a second block that goes deeper than the first.
        ("G0 X29.2 Z8. M8|G32 Z4. F2.|Z-20.|G0 X34.|Z8.|X28.|G32 Z4. F2.|Z-20.|G0 X34.", vec!["149@10"]),
        ("G0 X29.2 Z6. M8|G32 Z-10. F2.|Z-25.|G0 X34.|Z6.|X28.6|G32 Z-10. F2.|X27.2 Z-25.|G0 X34.", vec!["149@10"]),
        // In two starts, each in virgin metal.
        ("G0 X34. Z6. M8|G92 X29.2 Z-25. F2.|X28.4|G0 Z7.|G92 X29.2 Z-25. F2.|X28.4", vec![]),
    ] {
        assert_eq!(raised(blocks), expected, "{blocks}");
    }
}

#[test]
fn a_spindle_without_a_limit_turns_no_faster_than_the_lathe_lets_it() {
    let totals = |blocks: &str| {
        let (document, exit) = simulated(&format!("G21 G40 G97 G99|{blocks}|G0 X150. Z100. M9|M30"));
        assert_eq!(exit, 0, "{blocks}: {:?}", document["findings"]);
        let total = |key: &str| document["totals"][key].as_f64().unwrap();
        (total("cutting_time_s"), total("greatest_removal_rate_cm3_min"))
    };
    // A drill on the axis turns at 3000 rpm: 22 mm at 0.1 mm a revolution.
    for limit in ["", "G50 S3000|", "G50 S4500|"] {
        let (seconds, rate) = totals(&format!("{limit}T0505|G96 S80 M3|M8|G0 X0. Z2.|G1 Z-20. F.1|G0 Z2."));
        assert!((seconds - 4.4).abs() < 1e-9 && rate > 10.0, "{limit}: {seconds} s, {rate} cm³/min");
        // At X24 and X20 the S asks for 3316 and 3979 rpm.
        let (seconds, _) =
            totals(&format!("{limit}T0101|G96 S250 M3|M8|G0 X24. Z2.|G1 Z-20. F.3|X30.5|G0 Z2.|X20.|G1 Z-20.|X30.5"));
        assert!(seconds > 2.0 * 22.0 / 0.3 / 3000.0 * 60.0, "{limit}: {seconds} s");
    }
    // A thread too: at 3000 rpm it moves at 6000 mm/min.
    totals("T0404|G96 S3100 M3|M8|G0 X34. Z12.|G92 X29.3 Z-20. F2.|X28.9");
}
