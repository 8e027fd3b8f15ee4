//! Short programs that nobody would write, each with what must be said of it.

use rodete::gcode::interpreter::Interpreter;
use rodete::kinds::lathe::cases::CASES;
use rodete::kinds::lathe::parameters::FORM;
use rodete::kinds::lathe::setup::Given;
use rodete::parameter::field::Fields;
use rodete::parameter::list::{Row, Rows};
use rodete::parameter::{Value, Values};
use rodete::removal::turning::simulation::{Setup, Simulation};
use rodete::text::Language;
use serde_json::Value as Json;

use super::bench::{Book, bilingual, build, line, program, run};

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
        "caution 4 144 A tool that is not for threading cuts a thread, X33 Z2 ",
    ];
    assert_eq!((grave(&document), exit), (wanted.map(str::to_owned).to_vec(), 3));
    // The farthest out that the blade cuts is the top of its sides, 14 mm out from its tip at r 21.384.
    let fastest = document["totals"]["greatest_cutting_speed_m_min"].as_f64().unwrap();
    let wanted = std::f64::consts::TAU * (21.384 + 14.0) * 0.333;
    assert!((fastest / wanted - 1.0).abs() < 1e-4, "{fastest} {wanted}");
}

/// The tool goes through the bar and beside the jaws: what is held loses its left end after a piece has fallen off.
#[test]
fn a_held_piece_that_loses_its_left_end_is_no_fault_of_rodete() {
    for (lines, stock) in [
        (
            &["G21 G99", "T0100", "S500 M3 M8", "G0 X129.5 Z1.27", "Z0.", "G1 X127. F.3", "X78.74", "M30"][..],
            "D127xL40",
        ),
        (&["G21 G99", "S500 M3 M8", "T0402", "G0 X129.5 Z1.27", "X20.", "G1 Z-40. F.2", "X130.", "M30"], "D127xL30"),
    ] {
        let (document, exit) = simulate(lines, stock);
        let codes = document["findings"].as_array().unwrap().iter().filter_map(|one| one["code"].as_str());
        assert!(exit == 3 && !codes.into_iter().any(|code| code == "X0006"), "{document}");
        let totals = &document["totals"];
        assert!(totals["parted_volume_mm3"].as_f64().unwrap() > 1000.0, "{totals}");
        assert!(totals["other_library_apart_mm"].as_f64().unwrap() <= 1e-6, "{totals}");
    }
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
        "caution file nothing is left of the part to compare with the profile on the workbook's sheet PROFILE ";
    assert!(grave(&document).contains(&wanted.to_owned()), "{:?}", grave(&document));
    assert_eq!(exit, 3);
}

/// The machine of the shipped case.
fn shaft() -> Given {
    let mut values = Values::default();
    values.values.extend(CASES[0].values(Language::En));
    values.lists.extend((CASES[0].listed)(Language::En));
    Given::of(&Fields::of(&FORM, values).unwrap()).unwrap()
}

/// A program in the words of the interpreter over a bar of 50 mm, with so many steps of work allowed: the motions made, and the
/// work that they took.
fn steps(lines: &[&str], most_work: u64) -> (usize, u64, bool) {
    let given = shaft();
    let mut simulation = Simulation::new(Setup { most_work, ..given.setup.clone() }).unwrap();
    let text = lines.join("\n");
    let mut interpreter = Interpreter::over(text.as_bytes(), given.setting());
    let mut made = 0;
    while let Some(item) = interpreter.next() {
        let motion = item.unwrap_or_else(|fault| panic!("{fault:?}"));
        simulation.take(&motion, &interpreter.in_force().clone());
        if simulation.is_spent() {
            break;
        }
        made += 1;
    }
    (made, simulation.work(), simulation.is_spent())
}

#[test]
fn a_thread_of_too_many_turns_ends_where_its_work_does() {
    let thread = |F: &str| {
        let pass = format!("G32 Z-28. F{F}");
        let lines = ["T0606", "G97 S500 M3", "G0 X40. Z2.", pass.as_str(), "M30"];
        steps(&lines, 2_000_000)
    };
    let (made, work, spent) = thread("0.001");
    assert!(made == 1 && spent && (2_000_000..3_000_000).contains(&work), "{made} {work}");
    // Beyond a hundred thousand turns none is left out without a word.
    let (made, work, spent) = thread("0.00001");
    assert!(made == 1 && spent && (2_000_000..3_000_000).contains(&work), "{made} {work}");
    let (made, work, spent) = thread("2.");
    assert!(made == 2 && !spent && work < 300_000, "{made} {work}");
}

#[test]
fn passes_and_pecks_are_counted_and_an_end_of_the_work_is_told() {
    // Each way of a comb of grooves is gone over again and again.
    let passes = [
        "T0101",
        "G97 S500 M3 F.1",
        "G0 X54. Z2.",
        "G71 U.01 R.1",
        "G71 P10 Q20",
        "N10 G0 X30.",
        "N20 G1 Z-40.",
        "M30",
    ];
    let (made, work, spent) = steps(&passes, 50_000);
    assert!(made > 10 && spent && work < 100_000, "{made} {work}");
    let pecks = ["T0505", "G97 S500 M3 F.1", "G0 X0. Z2.", "G83 Z-40. R-1. Q50", "G80", "M30"];
    let (made, work, spent) = steps(&pecks, 50_000);
    assert!(made > 10 && spent && work < 100_000, "{made} {work}");
    let (document, exit) =
        simulate(&["T0404", "G97 S500 M3", "G0 X40. Z3000.", "G32 Z2000. F0.00001", "M30"], "D50xL100");
    let wanted = "stop 4 simulating this thread exceeds the limit of the computation; motions made before it: 1 ";
    assert_eq!(exit, 7, "{:?}", grave(&document));
    assert!(grave(&document).contains(&wanted.to_owned()), "{:?}", grave(&document));
    let findings = document["findings"].as_array().unwrap();
    let remedies: Vec<_> = findings.iter().filter_map(|one| one["remedy"]["en"].as_str()).collect();
    let wanted = "check F: with a lead of 0.00001 mm the spindle makes 100000000 turns";
    assert!(remedies.contains(&wanted), "{remedies:?}");
}

#[test]
fn a_second_set_up_of_a_part_that_was_not_made_is_not_judged() {
    let endless = ["T0404", "G97 S500 M3", "G0 X40. Z3000.", "G32 Z2000. F0.00001", "M30"].map(str::to_owned);
    let second = ["T0101", "G97 S500 M3", "G0 X20. Z-20.", "M30"].map(str::to_owned);
    let (_folder, document, exit) = build(&Book::new(&endless).second(&second).bytes());
    assert_eq!(exit, 7, "{document}");
    let stops: Vec<_> = grave(&document).into_iter().filter(|one| one.starts_with("stop ")).collect();
    let wanted = "PROGRAM!A9 simulating this thread exceeds the limit of the computation; motions made before it: 1";
    assert!(stops.iter().any(|one| one.contains(wanted)), "{stops:?}");
    assert!(stops.iter().all(|one| one.contains("PROGRAM!")), "{stops:?}");
    let told = "the motions of this program are not checked: the part is not the intended one, or nothing holds it";
    let findings = document["findings"].as_array().unwrap();
    assert!(findings.iter().any(|one| one["what"]["en"] == told), "{findings:?}");
}

#[test]
fn a_profile_with_more_points_than_are_held_is_an_end_of_the_work() {
    let row = |(at, Z): (usize, f64)| Row {
        values: [
            ("profile/G", Value::Choice(if at == 0 { "1" } else { "2" })),
            ("profile/X", Value::Real(40.0)),
            ("profile/Z", Value::Real(Z)),
            ("profile/R", Value::Real(2000.0)),
        ]
        .into(),
        cells: std::collections::BTreeMap::new(),
    };
    let profile = |count: usize| {
        let rows: Vec<Row> = (0..count).map(|at| row((at, if at % 2 == 0 { 0.0 } else { -2000.0 }))).collect();
        let book = Book::new(&program("X46.|G1 Z-20. F.2|X54.|G0 Z2."));
        let (_folder, document, exit) = build(&book.list(Rows { list: "profile", sheet: String::new(), rows }).bytes());
        bilingual(&document);
        (grave(&document), exit)
    };
    // The bar is not as long as the profile: what is missing is told.
    let (found, exit) = profile(3);
    assert!(exit == 0 && found.len() == 1 && found[0].contains("up to 1880 mm is missing (X40 Z-2000)"), "{found:?}");
    let wanted = "stop file comparing the part (35 corners) with the profile on the workbook's sheet PROFILE (399 elements) \
                  exceeds the limit of the computation ";
    assert_eq!(profile(400), (vec![wanted.to_owned()], 7));
}

#[test]
fn verify_reads_the_tool_sheet_of_a_workbook_and_tells_diameters() {
    let folder = tempfile::tempdir().unwrap();
    let book = |name: &str, book: &Book| std::fs::write(folder.path().join(name), book.bytes()).unwrap();
    book("lathe.xlsx", &Book::of(Language::En));
    book("wrong.xlsx", &Book::of(Language::En).put("L4", Value::Real(400.0)));
    let file = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    file("p.nc", "T0101\nG97 S500 M3\nG0 X60 Z2.\nG1 X40. F.2\nZ-30.\nG0 X100. Z50.\nM30\n");
    file("other.nc", "T0909\nG0 X60. Z2.\nM30\n");
    file("mill.nc", "G21 G90\nG0 X1 Y2\nM2\n");
    let verify = |arguments: &[&str]| run(folder.path(), &[&["verify"], arguments].concat());
    let said = verify(&["p.nc", "--dialect", "fanuc-lathe-a", "--tools", "lathe.xlsx"]);
    assert_eq!((said.err.as_str(), said.exit), ("", 0));
    // The offset of T1 is 60 mm on the radius and 40 mm along Z.
    for line in ["  X  40 … 100  program, 160 … 220  machine (diameter)", "  end (program): X 100  Z 50"] {
        assert!(said.out.contains(line), "{}", said.out);
    }
    assert!(!said.out.contains("Y "), "{}", said.out);
    let said = verify(&["p.nc", "--dialect", "fanuc-lathe-a", "--tools", "lathe.xlsx", "--json"]);
    let document: Json = serde_json::from_str(&said.out).unwrap();
    let end = &document["programs"][0]["end"]["program"];
    assert_eq!((end["X"].as_f64(), end["Z"].as_f64(), end["Y"].as_f64()), (Some(100.0), Some(50.0), None));
    let said = verify(&["p.nc", "--dialect", "fanuc-lathe-a", "--tools", "lathe.xlsx", "--canon"]);
    assert!(said.out.contains("\"to\":{\"X\":50.0"), "{}", said.out);
    let said = verify(&["other.nc", "--dialect", "fanuc-lathe-a", "--tools", "lathe.xlsx"]);
    assert!(said.err.contains("tool 9 is not in the tool table"), "{}", said.err);
    let said = verify(&["p.nc", "--dialect", "fanuc-lathe-a", "--tools", "wrong.xlsx"]);
    assert!(
        said.exit == 3 && said.err.contains("wrong.xlsx: L4 is 400 mm; it must be less than L = 120 mm"),
        "{}",
        said.err
    );
    assert!(said.err.contains("\n  --> wrong.xlsx, sheet \"DATA\", cell"), "{}", said.err);
    let said = verify(&["mill.nc", "--dialect", "linuxcnc", "--tools", "lathe.xlsx"]);
    let wanted = "error U0126: --tools is a lathe workbook, but the program is read as linuxcnc";
    assert!(said.exit == 3 && said.err.contains(wanted), "{}", said.err);
}

/// Numbers that look random, the same ones each time (Marsaglia's xorshift).
struct Dice(u64);

impl Dice {
    fn below(&mut self, most: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 % most
    }

    fn of(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.below(1_000_001) as f64 / 1e6
    }
}

/// A short program over a bar of 50 mm: approaches, cuts, arcs, threads and cycles wherever they may be, in metal and out of it.
fn thrown(dice: &mut Dice) -> Vec<String> {
    let mut lines =
        vec![format!("T0{0}0{0}", 1 + dice.below(6)), "G97 S500 M3 F.2".to_owned(), "G0 X54. Z2.".to_owned()];
    for _ in 0..2 + dice.below(7) {
        let (X, Z) = (dice.of(-4.0, 62.0), dice.of(-80.0, 6.0));
        let feed = [0.001, 0.05, 0.3, 2.0, 7.0][usize::try_from(dice.below(5)).unwrap()];
        lines.push(match dice.below(12) {
            0 => format!("T0{0}0{0}", 1 + dice.below(6)),
            1 | 2 => format!("G0 X{X:.3} Z{Z:.3}"),
            3 | 4 => format!("G1 X{X:.3} Z{Z:.3} F{feed}"),
            5 => format!("G{} X{X:.3} Z{Z:.3} R{:.3}", 2 + dice.below(2), dice.of(1.0, 60.0)),
            6 | 7 => format!("G32 X{X:.3} Z{Z:.3} F{feed}"),
            8 => format!("G92 X{X:.3} Z{Z:.3} F{feed}"),
            9 => format!("G90 X{X:.3} Z{Z:.3}"),
            10 => format!("G83 X0. Z{:.3} R1. Q{}\nG80", dice.of(-60.0, -1.0), 20 + dice.below(9_000)),
            _ => format!("G71 U{:.3} R.5\nG71 P10 Q20 U.2\nN10 G0 X{X:.3}\nN20 G1 Z{Z:.3}", dice.of(0.02, 4.0)),
        });
    }
    lines.extend(["G0 X100. Z50.".to_owned(), "M30".to_owned()]);
    lines
}

#[test]
fn no_program_thrown_together_brings_it_down_or_keeps_it_going() {
    let most_work = 300_000;
    let given = shaft();
    let (mut dice, mut ended, mut motions) = (Dice(20_26), 0, 0);
    for number in 0..150 {
        let text = thrown(&mut dice).join("\n");
        let mut setup = Setup { most_work, ..given.setup.clone() };
        setup.record = number % 3 == 0;
        if number % 4 == 0 {
            (setup.stock.diameter, setup.stock.length) = (200.0, 300.0);
        }
        let mut simulation = Simulation::new(setup).unwrap();
        let mut setting = given.setting();
        setting.budget.repeated_blocks = 1_000;
        let mut interpreter = Interpreter::over(text.as_bytes(), setting);
        while let Some(item) = interpreter.next() {
            let Ok(motion) = item else { continue };
            let step = simulation.take(&motion, &interpreter.in_force().clone());
            let finite = step.removed.volume.is_finite() && step.cutting_speed.is_finite() && step.depth.is_finite();
            assert!(finite, "{text}\n{step:?}");
            assert!(step.alarms.iter().all(|one| one.place.iter().all(|at| at.is_finite())), "{text}\n{step:?}");
            motions += 1;
            if simulation.is_spent() {
                break;
            }
        }
        ended += usize::from(simulation.is_spent());
        // No motion takes more than once again what all may take, twelve times of it where its last turn is a rib.
        assert!(simulation.work() < 13 * most_work, "{}\n{text}", simulation.work());
        assert!(simulation.volume().is_finite() && simulation.volume() >= -1e-6, "{text}");
        assert!(simulation.lasting().iter().all(|one| one.place.iter().all(|at| at.is_finite())), "{text}");
    }
    assert!(ended > 3 && motions > 1_000, "{ended} {motions}");
}
