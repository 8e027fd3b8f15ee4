//! The typeset report: its bytes, its literal texts, and what happens when typst does not do its work.

use crate::common;

use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::time::{Duration, Instant};

use rodete::figure::{Axes, Figure, Ink, Stroke};
use rodete::finding::{Grade, Place, Raise};
use rodete::gcode::control::Control;
use rodete::gcode::program::Style;
#[cfg(feature = "embedded-typst")]
use rodete::kind::Kind;
use rodete::kind::{End, Outcome, Provenance};
use rodete::kinds::KINDS;
use rodete::kinds::impeller::cases::CASES;
use rodete::kinds::impeller::parameters::FORM;
use rodete::kinds::impeller::rules::NoRetract;
#[cfg(feature = "embedded-typst")]
use rodete::parameter::Case;
use rodete::parameter::field::Fields;
use rodete::parameter::{Value, Values};
use rodete::report::stationery::Stationery;
use rodete::report::typeset;
#[cfg(feature = "embedded-typst")]
use rodete::report::{Attachment, Content, Report, Role};
use rodete::table::{Column, Index, Law, Print, Quantity, Table, Unit};
use rodete::text::{Language, t};
use rodete::typeset::compiler::Typst;
use rodete::typeset::failure::ReportFailure;

/// A small outcome with every kind of content but programs.
fn outcome(part: &str, rows: usize) -> Outcome {
    let mut values = Values { language: Language::En, ..Values::default() };
    let case = CASES.iter().find(|case| case.name == "tfg-2021").expect("a case");
    values.values = case.values(Language::En).into_iter().collect();
    values.values.insert("part", Value::Line(part.to_owned()));
    let steps: Vec<f64> = (0..rows).map(|at| f64::from(u32::try_from(at).unwrap()) * -0.125).collect();
    let line: Vec<[f64; 2]> =
        steps.iter().enumerate().map(|(at, &y)| [f64::from(u32::try_from(at).unwrap()), y]).collect();
    Outcome {
        kind: KINDS[0],
        control: Control::named("fagor-8055").expect("a control"),
        style: Some(Style::Annex),
        fields: Fields::of(&FORM, values).expect("all that the form requires"),
        source: Provenance {
            workbook: "impeller & co.xlsx".to_owned(),
            sha256: "0123456789abcdef".repeat(4),
            version: "0.1.0",
        },
        end: End::Whole,
        quantities: vec![Quantity {
            symbol: "L",
            meaning: t("Longitud de pivote", "Pivot length"),
            value: 242.9,
            unit: Unit::Millimetre,
            source: t("R_B + H", "R_B + H"),
            cell: None,
        }],
        tables: vec![Table {
            key: "annex-1",
            name: t("Anexo 1", "Annex 1"),
            title: t("Discretización", "Discretisation"),
            source: t("Anexo 1", "Annex 1"),
            index: Index::Point,
            print: Print::Short,
            columns: vec![Column::numbers("v", Unit::Radian, Law::Told("v"), steps)],
        }],
        programs: Vec::new(),
        charts: Vec::new(),
        figures: LazyLock::new(Box::new(move || {
            vec![Figure {
                letters: Figure::LETTERS,
                key: "angles",
                height: Figure::HEIGHT,
                caption: t("Ángulos", "Angles"),
                axes: Some(Axes { x: t("i", "i"), y: t("v (rad)", "v (rad)") }),
                strokes: vec![Stroke { ink: Ink::Safe, points: line, filled: false, arrow: true }],
                labels: Vec::new(),
                legend: vec![(Ink::Safe, t("v", "v"))],
            }]
        })),
        drawings: Vec::new(),
        named_files: Vec::new(),
        solids: Vec::new(),
        scene: None,
        setup: Vec::new(),
        checks: Vec::new(),
        findings: vec![NoRetract {}.at(Place::File).with("1 mm", "2 mm")],
    }
}

/// True for what is set as a symbol, as `x`, `N_x`, `y″`; words say themselves what they mean.
fn is_symbol(name: &str) -> bool {
    let mut letters = name.trim_start_matches('Δ').chars().skip(1);
    letters.next().is_none_or(|second| second == '_' || second == '″' || second.is_ascii_digit())
}

#[test]
fn no_symbol_stands_over_a_column_without_its_meaning() {
    let mut seen = 0;
    for (kind, case, language) in common::cases() {
        let outcome = common::shipped(kind, case, language);
        let labels = kind.chapters().labels;
        let own = labels.split(&format!("\n  {}: (", language.code())).nth(1).expect("words of the language");
        for table in outcome
            .tables
            .iter()
            .filter(|table| !matches!(table.print, Print::No | Print::Formulas) && table.key != "verification")
        {
            let line = own.lines().find(|line| line.trim_start().starts_with(&format!("{}: \"", table.key)));
            for column in table.columns.iter().map(|column| column.symbol.get(language)).filter(|one| is_symbol(one)) {
                let told = line
                    .is_some_and(|line| line.contains(&format!("{column}:")) || line.contains(&format!("{column},")));
                assert!(told, "{kind:?} {}: {column} of {} ({language:?})", case.name, table.key);
                seen += 1;
            }
        }
    }
    assert!(seen > 100, "{seen} symbols");
}

fn script(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/typst").join(name)
}

/// The failure of a script that stands for typst.
#[cfg(unix)]
fn failure(name: &str, deadline: Duration) -> ReportFailure {
    let typst = Typst::installed(script(name)).with_deadline(deadline);
    typeset(&outcome("part", 5), &[], &Stationery::default(), Language::En, &typst)
        .expect_err("the script gives no report")
}

#[test]
fn a_missing_typst_is_named_with_the_version_wanted() {
    let typst = Typst::installed("/nowhere/typst");
    let finding = typeset(&outcome("part", 5), &[], &Stationery::default(), Language::Es, &typst)
        .expect_err("no such program")
        .finding();
    assert!(
        finding.what.en.starts_with("the report could not be typeset: cannot run '/nowhere/typst'"),
        "{}",
        finding.what.en
    );
    assert!(finding.remedy.es.contains("typst 0.15"), "{}", finding.remedy.es);
    assert_eq!(finding.grade, Grade::Caution);
}

#[cfg(unix)]
#[test]
fn a_failing_typst_tells_its_first_lines_without_control_characters() {
    let finding = failure("fails.sh", Duration::from_secs(20)).finding();
    assert!(
        finding.what.en.ends_with(
            "ended with exit code 1\n  report.typ:12:7: error: unknown variable: contnets \u{FFFD}[31m\n  error: second line"
        ),
        "{:?}",
        finding.what.en
    );
}

#[cfg(unix)]
#[test]
fn a_hanging_typst_is_killed_with_its_children_at_the_deadline() {
    let start = Instant::now();
    let failure = failure("hangs.sh", Duration::from_millis(300));
    // The pipe of standard error is held by the script's child: only its death lets the text arrive at once.
    assert!(start.elapsed() < Duration::from_millis(1200), "{:?}", start.elapsed());
    let finding = failure.finding();
    assert!(finding.what.en.contains("did not end within 0.3 s and was killed"), "{}", finding.what.en);
    assert!(finding.what.en.contains("report.typ:1:1: warning: still thinking"), "{}", finding.what.en);
}

#[cfg(unix)]
#[test]
fn an_interrupted_typst_is_killed() {
    let flag = std::sync::Arc::new(std::sync::atomic::AtomicBool::new(true));
    let typst = Typst::installed(script("hangs.sh")).with_interrupt(flag);
    let failure =
        typeset(&outcome("part", 5), &[], &Stationery::default(), Language::En, &typst).expect_err("it is interrupted");
    assert!(failure.interrupted(), "{failure}");
}

#[cfg(unix)]
#[test]
fn half_a_pdf_no_pdf_and_a_crash_give_no_report() {
    for (name, told) in [
        ("truncates.sh", "left 15 bytes that are not a complete PDF"),
        ("silent.sh", "left no readable PDF"),
        ("crashes.sh", "broke off"),
    ] {
        let finding = failure(name, Duration::from_secs(20)).finding();
        assert!(finding.what.en.contains(told), "{name}: {}", finding.what.en);
    }
}

/// Says loudly that a judge is not here; where it must be, fails.
#[cfg(feature = "embedded-typst")]
fn missing(tool: &str) {
    use std::io::Write;
    assert!(std::env::var_os("CI").is_none(), "{tool} (poppler-utils) is missing");
    // Not through the macros, whose output a passing test keeps to itself.
    let _ = writeln!(std::io::stderr(), "\n*** {tool} is not installed: what a report shows is NOT TESTED ***\n");
}

#[cfg(feature = "embedded-typst")]
mod embedded {
    use super::*;
    use std::process::Command;

    fn typst() -> Typst {
        Typst::embedded(env!("CARGO_BIN_EXE_rodete"))
    }

    fn workbook() -> Attachment<'static> {
        Attachment {
            name: "impeller & co.xlsx".to_owned(),
            role: Role::Input,
            mime: "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet",
            description: t("Libro de datos", "Workbook"),
            content: Content::Bytes(b"PK not really a workbook"),
        }
    }

    /// The text of a PDF by poppler's pdftotext, pages parted by form feeds; `None` where it is not installed, which
    /// only a machine that is not CI may be.
    fn text(pdf: &[u8]) -> Option<String> {
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(file.path(), pdf).unwrap();
        let Ok(output) = Command::new("pdftotext").arg("-layout").arg(file.path()).arg("-").output() else {
            super::missing("pdftotext");
            return None;
        };
        assert!(output.status.success());
        Some(String::from_utf8(output.stdout).unwrap())
    }

    #[test]
    fn the_same_outcome_gives_the_same_bytes() {
        let outcome = outcome("part", 70);
        let once = typeset(&outcome, &[workbook()], &Stationery::default(), Language::Es, &typst()).unwrap().pdf;
        let again = typeset(&outcome, &[workbook()], &Stationery::default(), Language::Es, &typst()).unwrap().pdf;
        assert!(once == again);
        assert!(once.starts_with(b"%PDF-1.7"));
    }

    /// A report and what it was made of.
    struct Made {
        name: String,
        kind: &'static dyn Kind,
        outcome: Outcome,
        language: Language,
        report: Report,
    }

    /// The reports of every kind, case and language, typeset once for all tests that read them.
    static EVERY: LazyLock<Vec<Made>> = LazyLock::new(|| {
        let made = |(kind, case, language): (&'static dyn Kind, &'static Case, Language)| {
            let outcome = common::outcome_of(kind, case, language, &[]);
            let report =
                typeset(&outcome, &[workbook()], &Stationery::default(), language, &typst()).expect("a report");
            Made { name: format!("{kind:?} {}", case.name), kind, outcome, language, report }
        };
        // Typst takes one core most of its time.
        let cases: Vec<_> = common::cases().collect();
        std::thread::scope(|scope| {
            let (one, other) = cases.split_at(cases.len() / 2);
            let one = scope.spawn(move || one.iter().copied().map(made).collect::<Vec<_>>());
            let mut all: Vec<Made> = other.iter().copied().map(made).collect();
            all.extend(one.join().expect("reports"));
            all
        })
    });

    /// Each has words, method and set-up sheet of its own.
    #[test]
    fn every_kind_of_workbook_has_its_report() {
        for Made { name, kind, outcome, language, report } in EVERY.iter() {
            assert!(report.findings.is_empty(), "{name}: {:?}", report.findings);
            let Some(text) = text(&report.pdf) else { continue };
            let first = text.split('\u{C}').next().unwrap_or_default();
            let first = first.split_whitespace().collect::<Vec<_>>().join(" ");
            let red = match language {
                Language::Es => "está en rojo",
                Language::En => "is red",
            };
            assert!(first.contains(red), "{name}: page 1 says what a red banner means");
            assert!(!first.contains(" -"), "{name}: page 1 has hyphens for minus signs: {first}");
            for caution in outcome.findings.iter().filter(|finding| finding.grade == Grade::Caution) {
                let begins: Vec<&str> = caution.what.get(*language).split_whitespace().take(3).collect();
                let shown = format!("{} {}", caution.code(), begins.join(" "));
                assert!(first.contains(&shown), "{name}: page 1 has no {shown}: {first}");
            }
            // What the kind calls a table in the report, if not by the name of its sheet.
            let own = kind.chapters().labels.split(&format!("\n  {}: (", language.code())).nth(1).unwrap_or_default();
            let headings = own.lines().find(|line| line.trim_start().starts_with("headings: (")).unwrap_or_default();
            for table in outcome
                .tables
                .iter()
                .filter(|table| !matches!(table.print, Print::No | Print::Formulas) && table.rows() > 0)
            {
                let heading =
                    headings.split(&format!("{}: \"", table.key)).nth(1).and_then(|rest| rest.split('"').next());
                let called = heading.unwrap_or(table.name.get(*language));
                assert!(text.contains(called), "{name} {}", table.key);
                assert!(!text.contains(&format!("{called}. {called} ")), "{name} {}: its name twice", table.key);
            }
        }
    }

    #[test]
    fn markup_in_a_name_is_shown_and_not_run() {
        let part = r##"#read("/etc/passwd") $x^2$ *b* #import "a.typ": * \u{41} <label> @ref // /* `c` = h"##;
        let report = typeset(&outcome(part, 5), &[], &Stationery::default(), Language::En, &typst()).unwrap();
        if let Some(text) = text(&report.pdf) {
            let flat = text.split_whitespace().collect::<Vec<_>>().join(" ").replace('\u{200B}', "");
            assert!(flat.contains(part), "{flat}");
        }
    }

    #[test]
    fn characters_without_a_glyph_are_shown_by_code_with_a_note() {
        let report =
            typeset(&outcome("部品 \u{1B}[31m\u{202E} ñ ⌀ 😀", 5), &[], &Stationery::default(), Language::En, &typst())
                .unwrap();
        let [note] = report.findings.as_slice() else { panic!("{:?}", report.findings) };
        assert_eq!(note.grade, Grade::Note);
        assert_eq!(note.value, "[U+90E8] [U+54C1] [U+001B] [U+202E] [U+1F600]");
        if let Some(text) = text(&report.pdf) {
            assert!(text.contains("[U+90E8][U+54C1] [U+001B][31m[U+202E] ñ ⌀ [U+1F600]"), "{text}");
        }
    }

    #[test]
    fn a_name_of_two_hundred_characters_without_a_blank_is_set() {
        let report =
            typeset(&outcome(&"W".repeat(200), 5), &[], &Stationery::default(), Language::En, &typst()).unwrap();
        assert!(report.findings.is_empty());
    }

    #[test]
    fn long_tables_lose_their_middle_and_say_so() {
        let report = typeset(&outcome("part", 61), &[], &Stationery::default(), Language::En, &typst()).unwrap();
        if let Some(text) = text(&report.pdf) {
            assert!(text.contains("21 rows are omitted here"), "{text}");
        }
    }

    /// What a PDF says, page by page.
    fn pages(text: &str) -> Vec<&str> {
        text.trim_end_matches('\u{C}').split('\u{C}').collect()
    }

    /// Every kind, case and language, and the longest of names: the machinist has one page to carry, one more for a second
    /// set-up, and the same behind the cover of the report.
    #[test]
    fn the_set_up_sheet_is_one_page_a_file_of_its_own_and_behind_the_cover() {
        let long = "Rodete de ensayo ".repeat(11);
        let many = [("N", Value::Whole(3)), ("part", Value::Line(long.trim().to_owned()))];
        let outcome = common::outcome("full", &many);
        let report = typeset(&outcome, &[workbook()], &Stationery::default(), Language::Es, &typst()).unwrap();
        let long = Made { name: "a long name".to_owned(), kind: KINDS[0], outcome, language: Language::Es, report };
        for Made { name: case, outcome, language, report, .. } in EVERY.iter().chain([&long]) {
            let language = *language;
            let (head, foot) = match language {
                Language::Es => ("Hoja de preparación", "Operario"),
                Language::En => ("Set-up sheet", "Machinist"),
            };
            let (Some(sheet), Some(whole)) = (text(&report.setup), text(&report.pdf)) else { return };
            let setups = outcome.figures.iter().filter(|figure| ["setup", "setup-2"].contains(&figure.key)).count();
            let sheet = pages(&sheet);
            assert_eq!(sheet.len(), setups.max(1), "{case}");
            assert!(sheet.iter().all(|page| page.contains(head) && page.contains(foot)), "{case}: {sheet:?}");
            // What reads the page may set two blanks where the columns beside want it.
            let plain = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
            for program in &outcome.programs {
                let title = program.title.get(language);
                assert!(sheet.iter().any(|page| plain(page).contains(title)), "{case}: {}", program.key);
            }
            assert!(!sheet.concat().contains("SHA-256"), "{case}: nobody compares sums by eye");
            let whole = pages(&whole);
            assert!(whole[1..=sheet.len()].iter().all(|page| page.contains(foot)), "{case}");
            assert_eq!(whole.iter().filter(|page| page.contains(foot)).count(), sheet.len(), "{case}");
        }
    }

    /// Down to where each page of a PDF is inked, in % of the room between head and foot.
    fn filled(pdf: &[u8]) -> Option<Vec<usize>> {
        /// Foot of the head, top of the foot and height of a page, mm.
        const ROOM: [usize; 3] = [27, 275, 297];
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(file.path(), pdf).unwrap();
        let Ok(output) = Command::new("pdftoppm").args(["-r", "36", "-gray"]).arg(file.path()).output() else {
            super::missing("pdftoppm");
            return None;
        };
        assert!(output.status.success());
        // One picture after the other: P5, width, height and greatest value, then a byte for each of its points.
        let (mut rest, mut found) = (output.stdout.as_slice(), Vec::new());
        while !rest.is_empty() {
            let head: Vec<&[u8]> = rest.splitn(5, u8::is_ascii_whitespace).collect();
            let [width, height] = [1, 2].map(|at| std::str::from_utf8(head[at]).unwrap().parse::<usize>().unwrap());
            let (page, further) = head[4].split_at(width * height);
            let [top, foot, _] = ROOM.map(|mm| mm * height / ROOM[2]);
            let mut rows = page.chunks(width).enumerate().take(foot).skip(top);
            let last = rows.rfind(|(_, row)| row.iter().any(|&light| light < 225));
            found.push(last.map_or(0, |(row, _)| (row - top) * 100 / (foot - top)));
            rest = further;
        }
        Some(found)
    }

    /// Behind the set-up sheet no page is half empty, the last one neither.
    #[test]
    fn every_page_of_a_report_is_filled() {
        assert_eq!(EVERY.len(), common::cases().count());
        for Made { name, outcome, language, report, .. } in EVERY.iter() {
            let setups = outcome.figures.iter().filter(|figure| ["setup", "setup-2"].contains(&figure.key)).count();
            let Some(pages) = filled(&report.pdf) else { return };
            // Behind the first page and the set-up sheet each has tables, method and programs.
            assert!(pages.len() > 1 + setups.max(1), "{name} {language:?}: {} pages", pages.len());
            for (at, part) in pages.iter().enumerate().skip(1 + setups.max(1)) {
                assert!(*part > 70, "{name} {language:?}: page {} is filled to {part} %", at + 1);
            }
        }
    }

    /// The machinist sets the tools as they were checked, and is not told of axes that the form says the machine has not.
    #[test]
    fn the_set_up_sheet_of_an_impeller_tells_stick_outs_and_how_the_machine_counts() {
        let sheet = |changes: &[(&'static str, Value)]| {
            let outcome = common::outcome("clear", changes);
            let report = typeset(&outcome, &[workbook()], &Stationery::default(), Language::En, &typst()).unwrap();
            text(&report.setup).map(|text| text.split_whitespace().collect::<Vec<_>>().join(" "))
        };
        let held = [("l_t", 25.0), ("l_f", 12.0), ("d_h", 20.0)].map(|(key, size)| (key, Value::Real(size)));
        let Some(sticking) = sheet(&held) else { return };
        for told in ["Stick-out lt 25 mm", "Stick-out lf 12 mm", "Diameter of the holder dh 20 mm"] {
            assert!(sticking.contains(told), "{told}: {sticking}");
        }
        assert!(sticking.contains("Diameter 2·R 50 mm"), "{sticking}");
        assert!(sticking.contains("B and C show 0 before each program"), "{sticking}");
        // A rounded end has a name, too.
        assert!(sticking.contains("Roughing tool: Flat end mill"), "{sticking}");
        let round =
            [("r_c", 3.0), ("r_cf", 0.5), ("c_s", 0.1), ("tol", 0.03)].map(|(key, size)| (key, Value::Real(size)));
        let Some(round) = sheet(&round) else { return };
        for told in ["Roughing tool: Ball end mill", "Finishing tool: Bull-nose end mill"] {
            assert!(round.contains(told), "{told}: {round}");
        }
        let linuxcnc = |rotary: &'static str| {
            sheet(&[
                ("dialect", Value::Choice("linuxcnc")),
                ("start_codes", Value::Line("M3".to_owned())),
                ("rotary", Value::Choice(rotary)),
            ])
        };
        let (Some(rollover), Some(linear)) = (linuxcnc("rollover"), linuxcnc("linear")) else { return };
        assert!(!rollover.contains("not rollover") && rollover.contains("C counts past 360°"), "{rollover}");
        assert!(linear.contains("B and C are not rollover axes"), "{linear}");
        // The way to the first safe point, as the control's programs go it.
        assert!(sticking.contains("then Z down to Zr = ") && sticking.contains("only then B and C turn"), "{sticking}");
        assert!(linear.contains("the table turns at once, in the block X0 Y0 B0 C0"), "{linear}");
        let Some(by_hand) = sheet(&[("retract", Value::Line(String::new()))]) else { return };
        assert!(
            by_hand.contains("First Z goes to Zr = ") && by_hand.contains("then X0 Y0, and only then"),
            "{by_hand}"
        );
        // What depends on the machine is a box: its clamps where the program writes them, and a path that may be blended.
        let (clamps, blended) = ("M11 and M13 release the clamps", "G61, or G64 with a small P, is in force");
        assert!(sticking.contains(clamps) && !sticking.contains(blended), "{sticking}");
        assert!(linear.contains(blended) && !linear.contains(clamps), "{linear}");
    }

    /// The cut with its lead-in and its kerf lies beyond the development: the plate must be as large as the cut.
    #[test]
    fn the_set_up_sheet_of_a_flat_branch_tells_how_much_plate_the_cut_needs() {
        let kind = *KINDS.iter().find(|kind| kind.form().kind == "pipe-insert").expect("the kind");
        let case = kind.cases().first().expect("a case");
        let sheet = |changes: &[(&'static str, Value)]| {
            let outcome = common::outcome_of(kind, case, Language::En, changes);
            let report = typeset(&outcome, &[workbook()], &Stationery::default(), Language::En, &typst()).unwrap();
            let text = text(&report.setup).map(|text| text.split_whitespace().collect::<Vec<_>>().join(" "));
            text.map(|text| (outcome, text))
        };
        for (lead_in, kerf) in [(5.0, 1.5), (8.0, 2.5)] {
            let flat =
                [("mode", Value::Choice("flat")), ("lead_in", Value::Real(lead_in)), ("kerf", Value::Real(kerf))];
            let Some((outcome, text)) = sheet(&flat) else { return };
            let W = outcome.quantities.iter().find(|one| one.symbol == "W").expect("W").value;
            let extents = outcome.programs[0].extents();
            let reach = |letter, kept: f64| {
                let (_, low, high) = extents.iter().find(|(of, ..)| *of == letter).expect("an axis");
                let (low, high) = (low.value() - kerf / 2.0, high.value() + kerf / 2.0);
                let (from, to) = (low.min(0.0).floor(), high.max(kept).ceil());
                format!("{letter}{from:.0} to {letter}{to:.0}").replace('-', "−")
            };
            // The sheet has two columns: its lines are looked for one by one.
            let [x, y] = [reach('X', W), reach('Y', 0.0)];
            let told = [format!("The plate reaches at least from {x} and"), format!("from {y}: lead-in")];
            assert!(x.contains("X−") && told.iter().all(|told| text.contains(told)), "{told:?}: {text}");
        }
        let Some((_, turned)) = sheet(&[("mode", Value::Choice("rotary"))]) else { return };
        assert!(!turned.contains("The plate"), "{turned}");
    }

    /// Without a kerf the torch goes along the curve: its set-up sheet says so, and does not say that G41 is not wanted. The hold of a
    /// hole's height is let go in the middle of the cut.
    #[test]
    fn the_set_up_sheet_of_a_torch_tells_whether_its_kerf_is_compensated() {
        let kinds = KINDS.iter().filter(|kind| kind.form().kind.starts_with("pipe"));
        for (kind, kerf) in kinds.flat_map(|kind| [(kind, 1.5), (kind, 0.0)]) {
            let mut changes = vec![("kerf", Value::Real(kerf))];
            if kind.form().kind == "pipe-hole" {
                changes.push(("m", Value::Real(kerf / 2.0)));
            }
            let case = kind.cases().first().expect("a case");
            let outcome = common::outcome_of(*kind, case, Language::En, &changes);
            let report = typeset(&outcome, &[workbook()], &Stationery::default(), Language::En, &typst()).unwrap();
            let Some(text) = text(&report.setup) else { return };
            let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
            assert_eq!(text.contains("The kerf is already compensated"), kerf > 0.0, "{kerf}: {text}");
            assert_eq!(text.contains("The kerf is not compensated"), kerf == 0.0, "{kerf}: {text}");
            let hole = kind.form().kind == "pipe-hole";
            assert_eq!(text.contains("in the middle of the cut"), hole, "{kerf}: {text}");
            assert!(!text.contains("during the cut"), "{kerf}: {text}");
        }
    }

    /// What no page holds goes on, and says so on top: more tools than a page has lines.
    #[test]
    fn a_set_up_sheet_that_is_too_long_says_that_it_goes_on() {
        let (kind, case, language) = common::cases()
            .find(|(kind, _, language)| kind.form().kind == "lathe" && *language == Language::En)
            .unwrap();
        let mut outcome = common::outcome_of(kind, case, language, &[]);
        let turret = outcome.tables.iter_mut().find(|table| table.key == "turret").unwrap();
        turret.print = Print::Whole;
        for column in &mut turret.columns {
            column.values = match &column.values {
                rodete::table::Cells::Numbers(numbers) => {
                    rodete::table::Cells::Numbers(numbers.iter().copied().cycle().take(90).collect())
                }
                rodete::table::Cells::Texts(texts) => {
                    rodete::table::Cells::Texts(texts.iter().cloned().cycle().take(90).collect())
                }
                other => other.clone(),
            };
        }
        let report = typeset(&outcome, &[workbook()], &Stationery::default(), language, &typst()).unwrap();
        let Some(text) = text(&report.setup) else { return };
        let pages = pages(&text);
        assert!(pages.len() > 1 && pages[0].contains("this sheet continues"), "{text}");
    }

    #[test]
    fn a_design_of_many_points_gives_a_report_of_bounded_length() {
        let outcome = common::outcome("full", &[("n", Value::Whole(5000))]);
        let report = typeset(&outcome, &[workbook()], &Stationery::default(), Language::En, &typst()).unwrap();
        if let Some(text) = text(&report.pdf) {
            assert!(
                text.contains("4 961 rows are omitted here") || text.contains("4961 rows are omitted here"),
                "{text}"
            );
            assert!(text.matches('\u{C}').count() < 32, "{} pages", text.matches('\u{C}').count());
        }
    }

    #[test]
    fn the_report_carries_the_workbook_and_every_program() {
        let workbook = Path::new(env!("CARGO_MANIFEST_DIR")).join("workbooks/impeller-full.xlsx");
        let folder = tempfile::tempdir().unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_rodete"));
        command.arg("build").arg(&workbook).arg("-o").arg(folder.path()).env_remove("RODETE_TYPST");
        assert!(command.output().unwrap().status.success());
        let kept = tempfile::tempdir().unwrap();
        let mut detach = Command::new("pdfdetach");
        detach.args(["-saveall", "-o"]).arg(kept.path()).arg(folder.path().join("impeller-full-report.pdf"));
        let Ok(output) = detach.output() else {
            super::missing("pdfdetach");
            return;
        };
        assert!(output.status.success());
        let same = |name: &str, original: &Path| {
            assert!(std::fs::read(kept.path().join(name)).unwrap() == std::fs::read(original).unwrap(), "{name}");
        };
        same("impeller-full.xlsx", &workbook);
        for program in ["blade", "splitter", "impeller", "blank"] {
            let name = format!("impeller-full-{program}.nc");
            same(&name, &folder.path().join(&name));
        }
    }

    /// The whole way, in two odd environments and in a plain one: locale, time zone and typst's own variables do not show.
    #[test]
    fn no_environment_shows_in_the_bytes() {
        let workbook = Path::new(env!("CARGO_MANIFEST_DIR")).join("workbooks/impeller-tfg-2021.xlsx");
        let environments: [&[(&str, &str)]; 3] = [
            &[("LANG", "C"), ("TZ", "UTC")],
            &[
                ("LANG", "es_ES.UTF-8"),
                ("LC_ALL", "es_ES.UTF-8"),
                ("TZ", "Pacific/Chatham"),
                ("SOURCE_DATE_EPOCH", "1"),
            ],
            &[("LANG", "de_DE.UTF-8"), ("TZ", "XYZ-13:37"), ("TYPST_ROOT", "/nowhere"), ("TYPST_FEATURES", "html")],
        ];
        let reports: Vec<Vec<u8>> = environments
            .iter()
            .map(|environment| {
                let folder = tempfile::tempdir().unwrap();
                let mut command = Command::new(env!("CARGO_BIN_EXE_rodete"));
                command.arg("build").arg(&workbook).arg("-o").arg(folder.path()).env_remove("RODETE_TYPST");
                let output = command.envs(environment.iter().copied()).output().unwrap();
                assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
                std::fs::read(folder.path().join("impeller-tfg-2021-report.pdf")).unwrap()
            })
            .collect();
        assert!(reports[0] == reports[1] && reports[0] == reports[2]);
    }

    #[test]
    fn a_fault_in_a_document_is_placed_by_file_line_and_column() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("a.typ"), "one\n  #read(\"/etc/passwd\")\n").unwrap();
        let output = Command::new(env!("CARGO_BIN_EXE_rodete"))
            .args(["typst", "compile", "--root"])
            .arg(folder.path())
            .args(["a.typ", "a.pdf"])
            .current_dir(folder.path())
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(1));
        let text = String::from_utf8(output.stderr).unwrap();
        assert!(text.starts_with("a.typ:2:8: error: file not found"), "{text}");
        assert!(!folder.path().join("a.pdf").exists());
    }
}
