//! Wrong command lines, help and version.

use predicates::prelude::*;

use rodete::kinds::KINDS;
use rodete::parameter::FieldKind;

use super::common::{folder, names, rodete, with_impeller};

/// The words of a list, as the command line says them.
fn possible<'a>(words: impl IntoIterator<Item = &'a str>) -> String {
    format!("[possible values: {}]", words.into_iter().collect::<Vec<_>>().join(", "))
}

#[test]
fn a_wrong_command_line_ends_with_2_and_says_how_it_is_meant() {
    let kinds = possible(KINDS.iter().map(|kind| kind.form().kind));
    let of_kinds = possible(KINDS.iter().flat_map(|kind| kind.cases()).map(|case| case.name));
    let cases: [(&[&str], &str); 13] = [
        (&[], "Usage: rodete"),
        (&["new", "pipe-hole", "--case", "full"], "a case of pipe-hole: set-in"),
        (&["bild"], "build"),
        (&["build"], "<WORKBOOK>..."),
        (&["check"], "<WORKBOOK>..."),
        (&["build", "a.xlsx", "--jason"], "--json"),
        (&["build", "a.xlsx", "--lang"], "--lang <LANGUAGE>"),
        (&["build", "a.xlsx", "--lang", "de"], "[possible values: es, en]"),
        (&["build", "a.xlsx", "--json", "--json"], "cannot be used multiple times"),
        (&["build", "a.xlsx", "-o", "x", "-o", "y"], "cannot be used multiple times"),
        (&["new", "propeller"], &kinds),
        (&["new", "impeller", "a.xlsx", "--case", "x"], &of_kinds),
        (&["new", "impeller", "a.ods"], "give a name like impeller.xlsx"),
    ];
    for (arguments, hint) in cases {
        let folder = folder();
        rodete(&folder).args(arguments).assert().code(2).stdout("").stderr(predicate::str::contains(hint));
        assert!(names(&folder).is_empty(), "{arguments:?}");
    }
}

#[test]
fn what_was_typed_cannot_steer_the_terminal() {
    let folder = folder();
    for arguments in [["--\u{1b}[2J\u{202e}", "x"], ["check", "\u{1b}]0;x\u{7}.xlsx"], ["new", "\u{9b}2J"]] {
        rodete(&folder)
            .args(arguments)
            .assert()
            .failure()
            .stderr(predicate::str::is_match("[\u{1b}\u{9b}\u{7}\u{202e}]").expect("a pattern").not())
            .stderr(predicate::str::contains("\\u{"));
    }
}

#[cfg(unix)]
#[test]
fn arguments_that_are_no_utf8_are_refused_where_words_are_wanted() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let folder = folder();
    rodete(&folder).args(["check", "a.xlsx", "--lang"]).arg(OsStr::from_bytes(b"e\xff")).assert().code(2);
}

#[test]
fn a_code_or_the_number_of_an_alarm_is_explained() {
    let folder = folder();
    let text = |arguments: &[&str]| {
        let assert = rodete(&folder).arg("explain").args(arguments).assert().code(0).stderr("");
        String::from_utf8(assert.get_output().stdout.clone()).expect("text")
    };
    let depth = text(&["L0131"]);
    assert!(depth.starts_with("L0131 depth-of-cut (stop, alarm 131)\n  The depth of cut is greater"), "{depth}");
    assert!(depth.contains("\n  remedy: divide the cut into more passes\n"), "{depth}");
    assert!(depth.contains("\n  example (fanuc-lathe-a, D50xL120):\n    G50 S2500\n"), "{depth}");
    assert_eq!(text(&["l0131"]), depth);
    // Two rows are told under 101.
    let rapid = text(&["101", "--lang", "es"]);
    assert!(rapid.contains("L0101 ") && rapid.contains("L0201 ") && rapid.contains("remedio: "), "{rapid}");
    assert!(text(&[]).lines().any(|line| line.starts_with("L0119  ")));
    rodete(&folder)
        .args(["explain", "Q9999"])
        .assert()
        .code(2)
        .stdout("")
        .stderr("error U0141: Q9999 is not a rodete code\nhint: run rodete explain, which lists the codes\nrodete explain U0141 says what it means, with an example\n");
    for (typed, told) in [
        (["L131", "--lang", "en"], "error U0141: L131 is not a rodete code; did you mean L0131?\n"),
        (["PS64", "--lang", "es"], "error U0141: PS64 no es un código de rodete; ¿quería decir PS0064?\n"),
    ] {
        let told = predicates::str::starts_with(told);
        rodete(&folder).arg("explain").args(typed).assert().code(2).stdout("").stderr(told);
    }
}

#[test]
fn the_controls_are_told_in_text_and_as_a_page() {
    let folder = folder();
    let text = |arguments: &[&str]| {
        let assert = rodete(&folder).args(["explain", "--controls"]).args(arguments).assert().code(0).stderr("");
        String::from_utf8(assert.get_output().stdout.clone()).expect("text")
    };
    let told = text(&["--lang", "es"]);
    // Another control may share a meaning.
    let line = |control: &str, meaning: &str| told.lines().any(|line| line.contains(control) && line.contains(meaning));
    assert!(
        told.contains("\n  G10\n") && line("linuxcnc", ": orígenes o tabla de herramientas por programa"),
        "{told}"
    );
    for control in ["fagor-8055", "fagor-8070", "fagor-8055-t"] {
        assert!(line(control, ": se rechaza: imagen espejo"), "{control}: {told}");
    }
    let page = text(&["--markdown", "--lang", "en"]);
    assert!(page.starts_with("# The controls\n") && page.contains("\n| G0 | rapid move |"), "{page}");
    for refused in [["--controls", "--all"], ["--controls", "L0131"], ["--markdown", "L0131"]] {
        rodete(&folder).arg("explain").args(refused).assert().code(2).stdout("");
    }
}

#[test]
fn help_and_version_end_with_0() {
    let folder = folder();
    let of_kinds: String = KINDS
        .iter()
        .map(|kind| {
            let form = kind.form();
            let dialect = form.parameter("dialect").expect("a control");
            let FieldKind::Choice(list) = dialect.kind else { panic!("{}: a list of controls", form.kind) };
            let controls = list.iter().map(|choice| choice.key).collect::<Vec<_>>().join(", ");
            format!("workbook {}: schema {}\ndialects: {controls}\n", form.kind, form.schema)
        })
        .collect();
    assert!(of_kinds.starts_with("workbook impeller: schema rodete-impeller 2\ndialects: fagor-8055, "), "{of_kinds}");
    for flag in ["--version", "-V"] {
        rodete(&folder).arg(flag).assert().code(0).stderr("").stdout(format!(
            "rodete {}\n{}\n{of_kinds}",
            env!("CARGO_PKG_VERSION"),
            if cfg!(feature = "embedded-typst") {
                "features: embedded-typst (typst 0.15.1)"
            } else {
                "features: none (an installed typst 0.15 sets the reports)"
            }
        ));
    }
    for (arguments, wanted) in [
        (vec!["--help"], "130  interrupted"),
        (vec!["-h"], "Commands:"),
        (vec!["build", "--help"], "RODETE_TYPST"),
        (vec!["help", "check"], "--lang <LANGUAGE>"),
    ] {
        rodete(&folder).args(&arguments).assert().code(0).stderr("").stdout(predicate::str::contains(wanted));
    }
}

#[test]
fn shells_and_man_are_told_the_whole_command_line() {
    let folder = folder();
    let said = |arguments: &[&str]| {
        let assert = rodete(&folder).args(arguments).assert().code(0).stderr("");
        String::from_utf8(assert.get_output().stdout.clone()).expect("text")
    };
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = said(&["completions", shell]);
        for word in ["simulate", "no-report"] {
            assert!(script.contains(word), "{shell}: {word}");
        }
        // The others complete words and not what they take.
        if ["bash", "zsh"].contains(&shell) {
            assert!(script.contains("pipe-insert") && script.contains("fagor-8055"), "{shell}");
        }
    }
    let page = said(&["man"]);
    assert!(page.contains(".TH rodete 1") && page.contains("interrupted"), "{page}");
    let page = said(&["man", "build"]);
    assert!(page.contains(".TH rodete\\-build 1") || page.contains(".TH rodete-build 1"), "{page}");
    assert!(page.contains("Example: rodete build"), "{page}");
    rodete(&folder).args(["man", "bild"]).assert().code(2).stdout("");
}

#[test]
fn one_workbook_twice_is_refused_before_anything_is_done() {
    let folder = with_impeller();
    let mut cases = vec![["impeller.xlsx", "impeller.xlsx"], ["impeller.xlsx", "./impeller.xlsx"]];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("impeller.xlsx", folder.path().join("link.xlsx")).expect("a link");
        cases.push(["impeller.xlsx", "link.xlsx"]);
    }
    let before = names(&folder);
    for command in ["check", "build"] {
        for workbooks in &cases {
            rodete(&folder)
                .arg(command)
                .args(workbooks)
                .assert()
                .code(2)
                .stdout("")
                .stderr(predicate::str::contains("hint: give each workbook once"));
        }
    }
    assert_eq!(names(&folder), before);
}

#[test]
fn outputs_that_would_bear_one_name_are_refused() {
    let folder = folder();
    rodete(&folder).args(["build", "a/rotor.xlsx", "b/Rotor.xlsx", "-o", "out"]).assert().code(2).stderr(
        "error U0113: the outputs of a/rotor.xlsx and b/Rotor.xlsx would have the same names\nhint: rename one of the \
                 workbooks or build them into different folders\nrodete explain U0113 says what it means, with an example\n",
    );
    assert!(names(&folder).is_empty());
}
