//! The command `offsets`.

use std::fs;

use predicates::prelude::*;
use serde_json::Value;
use tempfile::TempDir;

use super::common::{contents, folder, names, rodete};

const FILE: &str = "31\t1.23456789\n5210\t0.000000\n5220\t1.000000\n5241\t0.1234567891\n5250\t30.000000\n";

fn with_file() -> TempDir {
    let folder = folder();
    fs::write(folder.path().join("a.var"), FILE).expect("a file");
    folder
}

fn held(folder: &TempDir, name: &str) -> String {
    fs::read_to_string(folder.path().join(name)).expect("a file")
}

fn json(folder: &TempDir, arguments: &[&str], code: i32) -> Value {
    let done = rodete(folder).arg("offsets").args(arguments).arg("--json").assert().code(code).stderr("");
    serde_json::from_slice(&done.get_output().stdout).expect("one JSON document")
}

#[test]
fn without_options_the_offsets_are_shown_and_nothing_is_written() {
    let folder = with_file();
    let shown = "\
a.var  mm, °

              X      Y      Z       R
G54       0.000  0.000  0.000   0.000  active
";
    let blocks = "\
G21 G90
G92.1
G10 L2 P1 X0.000 Y0.000 Z0.000 R0.000
G10 L2 P2 X0.123457 Y0.000 Z0.000 R30.000
";
    rodete(&folder)
        .args(["offsets", "a.var"])
        .assert()
        .code(0)
        .stderr("")
        .stdout(predicate::str::starts_with(shown))
        .stdout(predicate::str::contains("\nG55    0.123457  0.000  0.000  30.000\n"))
        .stdout(predicate::str::contains(blocks))
        .stdout(predicate::str::ends_with("G10 L2 P9 X0.000 Y0.000 Z0.000 R0.000\nG54\n\n"));
    assert_eq!((names(&folder), held(&folder, "a.var").as_str()), (vec!["a.var".to_owned()], FILE));
    rodete(&folder).args(["offsets", "a.var", "--inch", "--lang", "es"]).assert().code(0).stdout(
        predicate::str::contains("a.var  in, °\n")
            .and(predicate::str::contains("G20 G90\n"))
            .and(predicate::str::contains("activo\n").and(predicate::str::contains("no está en vigor\n"))),
    );
}

#[test]
fn set_and_use_rewrite_what_they_name_and_keep_the_rest() {
    let folder = with_file();
    rodete(&folder)
        .args(["offsets", "a.var", "--set", "G55 Y1 Z-2", "--set", "G55 Y2", "--set", "G52 X1", "--use", "G55"])
        .assert()
        .code(0)
        .stderr("")
        .stdout(predicate::str::ends_with("a.var was written\n").and(predicate::str::contains("close it")));
    let text = held(&folder, "a.var");
    for line in [
        "31\t1.23456789",
        "5210\t1.000000",
        "5211\t1.000000",
        "5220\t2.000000",
        "5241\t0.1234567891",
        "5242\t2.000000",
        "5243\t-2.000000",
        "5250\t30.000000",
    ] {
        assert!(text.lines().any(|other| other == line), "{line} in {text}");
    }
    rodete(&folder).args(["offsets", "a.var", "--set", "G92.1"]).assert().code(0);
    let text = held(&folder, "a.var");
    assert!(text.contains("5210\t0.000000\n5211\t0.000000\n"), "{text}");
    assert_eq!(names(&folder), ["a.var"], "no other file is left");
}

#[test]
fn a_file_that_is_not_there_is_made_only_with_something_in_it() {
    let folder = folder();
    for arguments in [&["a.var"][..], &["a.var", "--workbook", "o.xlsx"]] {
        rodete(&folder)
            .arg("offsets")
            .args(arguments)
            .assert()
            .code(4)
            .stderr(predicate::str::starts_with("error W0104: cannot open a.var: no such file\n"));
        assert!(names(&folder).is_empty());
    }
    rodete(&folder).args(["offsets", "a.var", "--use", "G59.3"]).assert().code(0).stderr("");
    let text = held(&folder, "a.var");
    assert_eq!(text.lines().count(), 119);
    assert!(text.starts_with("5161\t0.000000\n") && text.contains("\n5220\t9.000000\n"));
}

#[test]
fn wrong_words_end_with_2_all_at_once_and_write_nothing() {
    let folder = with_file();
    rodete(&folder)
        .args(["offsets", "a.var", "--set", "G55 X1,5", "--set", "G92 X1", "--set", "G54 X1"])
        .assert()
        .code(2)
        .stdout("")
        .stderr(
            "error G1113: 'G55 X1,5': '1,5' is not a number\nhint: write the decimal of X with a point, not a comma\n\
             error G1103: 'G92 X1': G92 depends on the machine's position, which the file does not contain\n\
             hint: write G52 with the offsets, which use the same registers, or G92.1 to clear them\n\
             rodete explain G1113 says what it means, with an example\n",
        );
    for arguments in [&["--use", "G53"][..], &["--use", "2"], &["--workbook", "a.var"], &["--workbook", "o.ods"]] {
        rodete(&folder).args(["offsets", "a.var"]).args(arguments).assert().code(2).stdout("");
    }
    assert_eq!((names(&folder).len(), held(&folder, "a.var").as_str()), (1, FILE));
}

#[test]
fn a_bad_file_is_refused_line_by_line() {
    let folder = folder();
    fs::write(folder.path().join("a.var"), "5161\t0\n5221\t1,5\n5220\t1\nx\n").expect("a file");
    rodete(&folder).args(["offsets", "a.var", "--set", "G54 X1"]).assert().code(3).stdout("").stderr(
        predicate::str::contains(
            "error G1009: '1,5' is not a number\n  --> a.var:2:6\nhint: write the decimal with a point, not a comma",
        )
        .and(predicate::str::contains("error G1005: 'x' is not a parameter number\n  --> a.var:4:1\n"))
        .and(predicate::str::ends_with(
            "a.var: nothing was written\nrodete explain G1009 says what it means, with an example\n",
        )),
    );
    fs::write(folder.path().join("a.var"), vec![b'\n'; 300_000]).expect("a file");
    rodete(&folder).args(["offsets", "a.var"]).assert().code(7).stdout("");
    fs::create_dir(folder.path().join("d.var")).expect("a folder");
    rodete(&folder).args(["offsets", "d.var"]).assert().code(4).stdout("");
}

#[test]
fn an_active_system_that_is_none_is_a_caution() {
    let folder = folder();
    fs::write(folder.path().join("a.var"), "5220\t3.5\n").expect("a file");
    rodete(&folder).args(["offsets", "a.var"]).assert().code(0).stderr(
        predicate::str::starts_with(
            "caution G1202: parameter 5220 is not a whole number from 1 to 9: rodete takes offset 1, G54",
        )
        .and(predicate::str::contains(": 3.5\n")),
    );
    rodete(&folder).args(["offsets", "a.var", "--use", "G56"]).assert().code(0).stderr("");
    assert_eq!(held(&folder, "a.var"), "5220\t3.000000\n");
}

#[test]
fn a_workbook_goes_out_and_comes_back_in() {
    for (language, out, read) in [
        ("en", "o.xlsx was written from a.var and is ready to edit\n", "o.xlsx was read and written into a.var\n"),
        (
            "es",
            "o.xlsx se ha escrito desde a.var y está listo para editar\n",
            "o.xlsx se ha leído y se ha escrito en a.var\n",
        ),
    ] {
        let folder = with_file();
        let command = |more: &[&str]| {
            rodete(&folder).args(["offsets", "a.var", "--workbook", "o.xlsx", "--lang", language]).args(more).assert()
        };
        command(&[]).code(0).stderr("").stdout(predicate::str::ends_with(out));
        assert_eq!(held(&folder, "a.var"), FILE, "a workbook that goes out changes nothing");
        fs::write(folder.path().join("a.var"), "5220\t9.000000\n5599\t7\n").expect("a file");
        // The sheet first, then --set.
        command(&["--set", "G55 Y5"]).code(0).stderr("").stdout(predicate::str::ends_with(read));
        let text = held(&folder, "a.var");
        assert!(text.contains("5220\t1.000000\n") && text.ends_with("5599\t7\n"), "{text}");
        assert!(text.contains("5241\t0.123457\n5242\t5.000000\n"), "{text}");
    }
}

#[test]
fn set_with_a_workbook_that_goes_out_changes_both() {
    let folder = folder();
    fs::create_dir(folder.path().join("sheets")).expect("a folder");
    for out in ["o.xlsx", "sheets/o.xlsx"] {
        rodete(&folder)
            .args(["offsets", "a.var", "--set", "G57 X8", "--use", "G57", "--workbook", out])
            .assert()
            .code(0);
        fs::remove_file(folder.path().join("a.var")).expect("the file");
        rodete(&folder).args(["offsets", "a.var", "--workbook", out]).assert().code(0);
        let text = held(&folder, "a.var");
        assert!(text.contains("5220\t4.000000\n") && text.contains("5281\t8.000000\n"), "{text}");
    }
}

#[test]
fn a_wrong_workbook_or_folder_changes_no_file() {
    let folder = with_file();
    rodete(&folder).args(["offsets", "a.var", "--workbook", "o.xlsx"]).assert().code(0);
    let before = contents(folder.path());
    rodete(&folder)
        .args(["offsets", "a.var", "--workbook", "o.xlsx", "--inch", "--set", "G54 X1"])
        .assert()
        .code(3)
        .stderr(
            predicate::str::contains(
                "error W0708: X is in \"mm\", but the file is in in\n  --> o.xlsx, sheet \"OFFSETS\", cell B5\n",
            )
            .and(predicate::str::contains("leave out --inch if the machine works in millimetres")),
        );
    rodete(&folder).args(["offsets", "a.var", "--workbook", "a.var/o.xlsx", "--set", "G54 X1"]).assert().code(5);
    fs::write(folder.path().join("no.xlsx"), "hello").expect("a file");
    rodete(&folder).args(["offsets", "a.var", "--workbook", "no.xlsx"]).assert().code(4).stdout("");
    fs::remove_file(folder.path().join("no.xlsx")).expect("the file");
    assert!(contents(folder.path()) == before);
}

#[cfg(unix)]
#[test]
fn nothing_is_written_through_a_link() {
    let folder = with_file();
    std::os::unix::fs::symlink("a.var", folder.path().join("link.var")).expect("a link");
    rodete(&folder).args(["offsets", "link.var"]).assert().code(0);
    rodete(&folder).args(["offsets", "link.var", "--set", "G54 X1"]).assert().code(5).stdout("");
    assert_eq!(held(&folder, "a.var"), FILE);
}

#[test]
fn json_is_one_document_with_offsets_blocks_and_files() {
    let folder = with_file();
    let shown = json(&folder, &["a.var", "--inch"], 0);
    assert_eq!((&shown["command"], &shown["unit"]), (&"offsets".into(), &"in".into()));
    assert_eq!(shown["offsets"]["systems"]["G55"]["X"], 0.123_456_789_1);
    assert_eq!(shown["offsets"]["systems"]["G55"]["R"], 30.0);
    assert_eq!(shown["offsets"]["active"], "G54");
    assert_eq!(shown["preamble"][0], "G20 G90");
    assert_eq!((shown["files"].as_array().map(Vec::len), &shown["workbook"]), (Some(0), &Value::Null));
    let set = json(&folder, &["a.var", "--set", "G52 Z3", "--workbook", "o.xlsx"], 0);
    assert_eq!((&set["offsets"]["g92_in_force"], &set["offsets"]["g92"]["Z"]), (&true.into(), &3.0.into()));
    assert_eq!((&set["workbook"]["way"], &set["files"][1]["name"]), (&"written".into(), &"o.xlsx".into()));
    let refused = json(&folder, &["a.var", "--inch", "--workbook", "o.xlsx"], 3);
    assert_eq!((&refused["status"], &refused["offsets"]), (&"refused".into(), &Value::Null));
    assert_eq!(refused["workbook"]["findings"][0]["place"]["cells"][0]["cell"], "B5");
}
