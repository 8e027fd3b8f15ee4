//! Cutter radius compensation of milling programs: the motions are those of LinuxCNC, and what it refuses is refused.

use super::agreement::agree;
use super::common::rs274::{self, Judge, Refused};
use super::ours;
use rodete::gcode::control::LINUXCNC;
use rodete::gcode::interpreter::{Interpreter, Setting};

/// Lengths of the table are in inches: diameters 6 mm, 10 mm and −4 mm, and a lathe's tool.
const TOOLS: &str =
    "T1 P1 D0.2362204724409449\nT2 P2 D0.3937007874015748\nT3 P3 D-0.15748031496062992\nT4 P4 D0.1 Q2\n";

fn judge() -> Judge<'static> {
    Judge { tools: Some(TOOLS), ..Judge::default() }
}

fn program(body: &str) -> String {
    format!("G21\nG17 G90 G94 G40 F500\nG0 X0 Y0 Z5\n{}\nM2\n", body.replace("; ", "\n"))
}

/// Programs that both run. What stands in the way of LinuxCNC's checks lies elsewhere.
const GOOD: [&str; 40] = [
    // Entry and exit, on both sides.
    "G41.1 D6; G1 X10; X20; G40; X30",
    "G42.1 D6; G1 X10; X20; G40; X30",
    "G41.1 D6 G1 X10; X20; G40 X30 Y5",
    "G41.1 D6; G0 X10; G1 X20; G40 G0 X30 Y5",
    // Outer corners.
    "G41.1 D6; G1 X10; X20; Y-10; X5; G40; G0 Z10",
    "G42.1 D6; G1 X10; X20; Y10; X5 Y20; G40; X0",
    "G41.1 D6; G1 X10; X20; G0 Y-10; G1 X5; G40; G0 Y-30",
    "G41.1 D6; G1 X10; X20; X10.5 Y-0.2; G40; Y-30",
    // The path goes back on itself.
    "G41.1 D6; G1 X10; X20; X5; G40; Y-30",
    // Inner corners.
    "G41.1 D6; G1 X10; X30; Y20; X10; G40; X0",
    "G42.1 D6; G1 X10; X30; X20 Y-30; G40; X0",
    "G41.1 D6; G1 X10; Y20; G40; X0",
    // In inches an arc may grow by less.
    "G41.1 D6; G1 X10; X20; G2 X22.54 Y-2.54 I-0.0254 J-2.54; G40; G1 X30",
    "G20; F20; G1 X0 Y0; G41.1 D0.25; G1 X1; X2; G2 X3 Y-1 J-1; G1 Y-2; G40; X0",
    // Corners that are nearly none.
    "G41.1 D6; G1 X10; X20 Y0.3; X30 Y0.4; X40 Y0.9; G40; X50",
    "G42.1 D6; G1 X10; X20 Y0.3; X30 Y0.4; G2 X40 Y-9.6 J-10; G40; G1 X50",
    // What stands in the block of G40 comes behind it.
    "G10 L2 P2 X3 Y4 Z1; G41.1 D6; G1 X10; X20; G40 G55; X30; G28",
    "G41.1 D6; G1 X10; X20; G40 G81 X30 Y5 Z-1 R1; G18 G80; G17 G41.1 D6 G1 X60; Y20",
    // Arcs: tangential, outside and inside, in outer and inner corners, whole circles.
    "G41.1 D6; G1 X10; X20; G2 X30 Y-10 J-10; G1 Y-20; G40; X0",
    "G41.1 D6; G1 X10; X20; G3 X30 Y10 J10; G1 Y20; G40; X0",
    "G42.1 D6; G1 X10; X20; G3 X30 Y10 J10; G2 X40 Y20 I10; G1 X50; G40; X0",
    "G41.1 D6; G1 X10; X20; G3 X40 I10; G1 X60; G40; X0",
    "G41.1 D6; G1 X10; X20; G2 X40 I10; G1 X60; G40; X0",
    "G42.1 D6; G1 X10; X20; G2 X40 I10; G1 X60; G40; X0",
    "G42.1 D6; G1 X10; X20; G3 X40 I10; G1 X60; G40; X0",
    "G42.1 D6; G1 X10; X20; G2 X40 I10; G2 X60 I10; G3 X80 I10; G40; G1 X0",
    "G41.1 D6; G1 X10; X20; G2 X40 I10; G2 X60 I10; G3 X80 I10; G40; G1 X0",
    "G41.1 D6; G1 X10; X20; G2 X40 Y0 R10; G3 X60 R15; G3 X90 R16; G40; G1 X0",
    "G42.1 D6; G1 X20 Y10; G2 X20 Y10 I10 J0; G40; G1 X0",
    "G41.1 D6; G1 X20 Y10; G3 X20 Y10 I-12 J0 P2; G40; G1 X0",
    // Entry along an arc.
    "G41.1 D6; G3 X20 Y20 J20; G1 Y30; G40; X0",
    "G42.1 D6; G3 X20 Y20 J20; G1 Y30; X0; G40; X-10",
    "G41.1 D6; G2 X20 Y-20 J-20; G1 Y-30; X0; G40; X-10",
    // A diameter below 0 is on the other side.
    "G41.1 D-6; G1 X10; X20; Y-10; G40; X0",
    "G1 G42.1 X10 D-6; X20; Y-10 X19; G40; X0",
    // Ways along Z, dwells and speeds between.
    "G41.1 D6; G1 X10 Z1; X30; Z0; G4 P1; Y20; F200; G0 Z5; X10 Y-5; G1 Z1; X0 Y-6; G40; X-10 Z9",
    "G42.1 D6; G1 X10; X30; G0 Z3; M3 S100; G1 Z0 F300; Y10; G2 X40 Y20 Z-2 I10; G1 X50; G40; G0 Z5; X0",
    // The tool table; what is negative is on the other side; increments, inches, G93, G95, shifts and turns.
    "T2 M6; G41; G1 X10; X20; Y-10; G40; X0; G41 D1; Y10; X-20; G40; X-30; G42 D3; X-40; Y0; G40; X0",
    "G10 L2 P1 X5 Y6 Z7 R30; G92 X1; G41.1 D6; G91 G1 X10 Y5; X20; G3 X10 Y10 J10; G1 Y5; G40; X-10; G90 G54 G0 Z50",
    "G93 G41.1 D6; G1 X10 F10; X20 F5; Y-10 F6; G2 X10 Y-20 I-10 F2; G40; G1 X0 F3",
];

/// How many contours by chance are tried.
const CONTOURS: u64 = 80;

/// What both refuse, with what is told.
const BAD: [(&str, &str); 24] = [
    (
        "G41.1 D6; G1 X2.9; X20; G40; X30",
        "the entry into compensation is 2.9 mm long; it must be longer than the radius 3 mm",
    ),
    ("G41.1 D6; G1 Z-1; X10; X20", "the entry into compensation is 0 mm long"),
    ("G41.1 D6; G1 X10; X30; G3 X34 I2; G1 X50", "the cutter's radius 3 mm does not fit into the arc of radius 2 mm"),
    ("G41.1 D6; G1 X10; X30; Y2; X10", "the corners need more length than the element before them has"),
    ("G41.1 D6; G1 X10; G3 X2 I-4", "the cutter's radius 3 mm does not fit into the corner"),
    (
        "G20 F20; G1 X0 Y0; G41.1 D0.25; G1 X1; X2; G2 X2.1 Y-0.1 I-0.001 J-0.1; G40; G1 X5",
        "the corners need more length than the element before them has",
    ),
    ("G41.1 D6; G1 X10; X20; G40; G2 X40 I10", "the first motion after G40 is an arc"),
    ("G41.1 D6; G1 X10; G42.1 D6; X20", "G41 or G42 while compensation is already in force"),
    ("G19 G41.1 D6; G1 X10", "rodete does not follow cutter radius compensation in G19"),
    ("G41.1 G1 X10", "G41.1 or G42.1 without D"),
    ("G41.1 D6 L2 G1 X10", "L with G41.1 or G42.1 in G17"),
    ("G41 D4 G1 X10", "G41 or G42 in G17 with tool 4, a turning tool"),
    ("G41 D9 G1 X10", "tool 9 is not in the tool table"),
    ("G41.1 D6 G43 H1; G1 X10", "this code is not allowed while G41 or G42 is in force"),
    ("G41.1 D6 G55; G1 X10", "this code is not allowed while G41 or G42 is in force"),
    ("G41.1 D6 G81 X10 Z-1 R1", "this code is not allowed while G41 or G42 is in force"),
    ("G41.1 D6; G1 X10; G55", "this code is not allowed while G41 or G42 is in force"),
    ("G41.1 D6; G1 X10; G28", "this code is not allowed while G41 or G42 is in force"),
    ("G41.1 D6; G1 X10; G53 G1 X20", "this code is not allowed while G41 or G42 is in force"),
    ("G41.1 D6; G1 X10; G81 X20 Z-1 R1", "this code is not allowed while G41 or G42 is in force"),
    ("G41.1 D6; G1 X10; T1 M6", "this code is not allowed while G41 or G42 is in force"),
    ("G41.1 D6; G1 X10; G18", "this code is not allowed while G41 or G42 is in force"),
    ("G41.1 D6; G1 X10; M66 P0 L0", "this code is not allowed while G41 or G42 is in force"),
    ("G41.1 D6; G1 X10; G1 X[#5420 + 10]", "a program cannot read the position while G41 or G42 is in force"),
];

#[test]
fn cutter_compensation_moves_as_in_linuxcnc() {
    let mut faults = Vec::new();
    for body in GOOD {
        let text = program(body);
        match ours::run(text.as_bytes(), &judge()) {
            Err(fault) => faults.push(format!("{body}: {}: {}", fault.line, fault.message)),
            Ok((motions, _)) if rs274::is_here() => match judge().run(text.as_bytes()) {
                Ok(theirs) => {
                    if let Err(fault) = agree(&motions, &theirs.motions) {
                        faults.push(format!("{body}: {fault}"));
                    }
                }
                Err(refused) => faults.push(format!("{body}: {refused:?}")),
            },
            Ok(_) => {}
        }
    }
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults.join("\n"));
}

/// A contour by chance: lines and arcs, rapid moves and ways along Z; now and then nearly tangential.
fn contour(seed: u64) -> String {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    let mut chance = move |below: u32| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        u32::try_from(state >> 40).expect("24 bits") % below
    };
    let mut body = format!("G{}.1 D{}; G1 X{} Y{}", 41 + chance(2), 1 + chance(8), 20 + chance(10), chance(8));
    let (mut x, mut y) = (30.0, 4.0);
    for _ in 0..3 + chance(7) {
        let by = |share: u32| f64::from(share) - 15.0;
        let (to_x, to_y) = (x + by(chance(31)), y + by(chance(31)));
        let far = ((to_x - x) * (to_x - x) + (to_y - y) * (to_y - y)).sqrt();
        match chance(8) {
            0 => body += &format!("; G0 Z{}; G1 Z0", 1 + chance(3)),
            1 => body += &format!("; G0 X{to_x} Y{to_y}"),
            2 => body += &format!("; G1 X{} Y{}", to_x, y + (to_x - x) * 0.03),
            arc @ 3..=5 if far > 0.0 => {
                let radius = far * (0.51 + f64::from(chance(30)) / 20.0);
                body += &format!("; G{} X{to_x} Y{to_y} Z-1 R{radius:.4}", 2 + arc % 2);
            }
            _ => body += &format!("; G1 X{to_x} Y{to_y}"),
        }
        (x, y) = (to_x, to_y);
    }
    body + "; G40; G1 X-40 Y-40"
}

#[test]
fn contours_by_chance_are_compensated_as_in_linuxcnc() {
    if !rs274::is_here() {
        return;
    }
    let (mut alike, mut stricter) = (0, 0);
    for seed in 1..=CONTOURS {
        let body = contour(seed);
        let text = program(&body);
        match (ours::run(text.as_bytes(), &judge()), judge().run(text.as_bytes())) {
            (Ok((motions, _)), Ok(theirs)) => {
                agree(&motions, &theirs.motions).unwrap_or_else(|fault| panic!("{seed} {body}: {fault}"));
                alike += 1;
            }
            (Ok(_), Err(refused)) => panic!("{seed} {body}: {refused:?}"),
            (Err(fault), Ok(_)) => {
                println!("{seed} {body}: {fault}");
                stricter += 1;
            }
            (Err(_), Err(_)) => {}
        }
    }
    println!("{alike} alike, {stricter} stricter");
    assert!(alike * 3 > CONTOURS && stricter * 20 < CONTOURS, "{alike} alike, {stricter} stricter of {CONTOURS}");
}

#[test]
fn what_linuxcnc_refuses_under_cutter_compensation_is_refused() {
    for (body, told) in BAD {
        let text = program(body);
        let fault = ours::run(text.as_bytes(), &judge()).expect_err(body);
        assert!(fault.message.contains(told), "{body}: {}", fault.message);
        if rs274::is_here() {
            assert!(matches!(judge().run(text.as_bytes()), Err(Refused::Error(..))), "{body}");
        }
    }
}

#[test]
fn what_is_not_followed_under_cutter_compensation_is_refused() {
    for (body, told) in [
        ("G18 G41.1 D6; G1 X10", "rodete does not follow cutter radius compensation in G18"),
        ("G41.1 D6; G1 X10; X20 A5; X30", "rodete does not follow rotary axes or U, V, W while G41 or G42 is in force"),
        (&*format!("G41.1 D6; G1 X10; G1{}; X20", "\nZ1\nZ0".repeat(5_001)), "more than 10000 blocks without motion"),
        ("G41; G1 X10", "the tool in the spindle is not known"),
        ("G41.1 D6; G1 X10; X20; M0; X30", "this code is not allowed while G41 or G42 is in force"),
    ] {
        let fault = ours::run(program(body).as_bytes(), &judge()).expect_err(body);
        assert!(fault.message.contains(told), "{body}: {}", fault.message);
    }
    let text = program("T1 M6; G41; G1 X10");
    let mut interpreter = Interpreter::over(text.as_bytes(), Setting::new(&LINUXCNC));
    let fault = interpreter.find_map(Result::err).expect("without a tool table");
    assert!(fault.what.en.contains("the diameter of tool 1 is not known"), "{}", fault.what.en);
}
