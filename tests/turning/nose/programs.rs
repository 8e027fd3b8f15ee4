//! Programs: the compensation as the interpreter of the lathe dialects makes it.

use rodete::finding::Grade;
use rodete::gcode::control::{Control, FAGOR_8055, FAGOR_8055_T, FAGOR_8070, FANUC_LATHE_A};
use rodete::gcode::in_force::{Compensation, InForce};
use rodete::gcode::interpreter::{Interpreter, Refused, Setting, ToolOffset, Tools};
use rodete::gcode::motion::{Motion, MotionKind};
use rodete::machine::axis::{Axis, Pose};
use rodete::number::trig::tan;

use super::contour::nose;

pub struct Run {
    pub motions: Vec<(Motion, InForce)>,
    pub faults: Vec<Refused>,
    pub remarks: Vec<(Grade, String)>,
    pub end: (Pose, Pose),
}

/// Tools 1 (R 0.8, tip 3), 2 (R 0), 3 (no nose) and 4 (R 0.4, tip 2), all of length 0 but the first.
pub fn run(control: &'static Control, text: &str) -> Run {
    let mut tools = Tools::new();
    let mut offset = Pose::default();
    offset.set(Axis::X, 30.0);
    offset.set(Axis::Z, 70.0);
    tools.insert(1, ToolOffset { offset, nose: Some(nose(0.8, 3)), ..ToolOffset::default() });
    tools.insert(2, ToolOffset { nose: Some(nose(0.0, 3)), ..ToolOffset::default() });
    tools.insert(3, ToolOffset::default());
    tools.insert(4, ToolOffset { nose: Some(nose(0.4, 2)), ..ToolOffset::default() });
    let mut setting = Setting::new(control);
    setting.tools = Some(tools);
    let mut reader = Interpreter::over(text.as_bytes(), setting);
    let (mut motions, mut faults) = (Vec::new(), Vec::new());
    while let Some(item) = reader.next() {
        match item {
            Ok(motion) => motions.push((motion, *reader.in_force())),
            Err(fault) => faults.push(*fault),
        }
    }
    let remarks = reader.remarks().into_iter().map(|finding| (finding.grade, finding.what.en.to_string())).collect();
    Run { motions, faults, remarks, end: reader.position() }
}

/// The same without a fault.
pub fn clean(control: &'static Control, text: &str) -> Run {
    let run = run(control, text);
    assert!(run.faults.is_empty(), "{:?}", run.faults);
    run
}

/// `[Z, X]` of the end, X the radius.
pub fn end(motion: &Motion) -> [f64; 2] {
    [motion.to.get(Axis::Z), motion.to.get(Axis::X)]
}

pub fn near(found: [f64; 2], expected: [f64; 2]) {
    let off = (found[0] - expected[0]).abs().max((found[1] - expected[1]).abs());
    assert!(off < 1e-9, "{found:?}, {expected:?} expected");
}

/// Face, chamfer, cylinder, shoulder.
const FANUC: &str = "O1\nG21 G98 G97\nT0101\nM3 S500\nG0 X40. Z5.\nN10 G42 G1 X0. Z0. F120.\nN20 X16.\nN30 X20. Z-2.\n\
    G4 P500\nN40 Z-20.\nN50 G2 X30. Z-25. R5.\nN60 G1 X38.\nN70 G40 X50. Z5.\nM30\n";

/// The tips of that contour for R 0.8, tip 3: the corrections of the chamfer, the fillet's arc of 4.2.
fn tips() -> [[f64; 2]; 7] {
    let correction = 0.8 * (1.0 - tan(std::f64::consts::PI / 8.0));
    [
        [0.0, -0.8],
        [0.0, 8.0 - correction],
        [-2.0 - correction, 10.0],
        [-20.8, 10.0],
        [-25.0, 14.2],
        [-25.0, 18.2],
        [5.0, 25.0],
    ]
}

#[test]
fn a_fanuc_program_moves_the_tip_so_that_the_nose_cuts_the_contour() {
    let run = clean(&FANUC_LATHE_A, FANUC);
    let moved: Vec<&Motion> = run
        .motions
        .iter()
        .map(|(motion, _)| motion)
        .filter(|motion| !matches!(motion.kind, MotionKind::Dwell(_)))
        .skip(1)
        .collect();
    assert_eq!(moved.len(), 7);
    for (motion, expected) in moved.iter().zip(tips()) {
        near(end(motion), expected);
    }
    assert_eq!(moved.iter().filter_map(|motion| motion.n).collect::<Vec<_>>(), [10, 20, 30, 40, 50, 60, 70]);
    assert_eq!(moved.iter().map(|motion| motion.line).collect::<Vec<_>>(), [6, 7, 8, 10, 11, 12, 13]);
    let MotionKind::Arc(arc, _) = moved[4].kind else { panic!("{:?}", moved[4]) };
    near(arc.centre, [-20.8, 14.2]);
    assert!((arc.radius - 4.2).abs() < 1e-12 && (arc.sweep + std::f64::consts::FRAC_PI_2).abs() < 1e-12);
    for pair in moved.windows(2) {
        near(end(pair[0]), [pair[1].from.get(Axis::Z), pair[1].from.get(Axis::X)]);
    }
}

#[test]
fn machine_positions_and_times_are_those_of_the_compensated_path() {
    let run = clean(&FANUC_LATHE_A, FANUC);
    let plain = clean(&FANUC_LATHE_A, &FANUC.replace("G42 ", "").replace("G40 ", ""));
    assert_eq!(run.motions.len(), plain.motions.len());
    let mut differ = 0;
    let shift = |motion: &Motion| [Axis::X, Axis::Z].map(|axis| motion.machine.get(axis) - motion.to.get(axis));
    for ((motion, _), (other, _)) in run.motions.iter().zip(&plain.motions) {
        let (one, two) = (shift(motion), shift(other));
        near(one, two);
        let length = match motion.kind {
            MotionKind::Arc(arc, _) => arc.radius * arc.sweep.abs(),
            MotionKind::Rapid | MotionKind::Dwell(_) => continue,
            _ => rodete::number::trig::hypot(
                motion.to.get(Axis::Z) - motion.from.get(Axis::Z),
                motion.to.get(Axis::X) - motion.from.get(Axis::X),
            ),
        };
        assert!((motion.seconds.unwrap() - length * 60.0 / 120.0).abs() < 1e-9, "{motion:?}");
        differ += usize::from(motion.seconds != other.seconds);
    }
    assert!(differ >= 4);
    let dwell = run.motions.iter().position(|(motion, _)| matches!(motion.kind, MotionKind::Dwell(_))).unwrap();
    assert_eq!(dwell, 4, "between the chamfer and the cylinder");
    assert_eq!(run.motions[dwell].0.seconds, Some(0.5));
    near(end(&run.motions[dwell].0), tips()[2]);
}

#[test]
fn the_control_shows_the_side_of_each_motion() {
    let run = clean(&FANUC_LATHE_A, FANUC);
    let sides: Vec<Compensation> = run.motions.iter().map(|(_, control)| control.compensation).collect();
    let mut expected = vec![Compensation::Right; 9];
    (expected[0], expected[8]) = (Compensation::Off, Compensation::Off);
    assert_eq!(sides, expected);
    // The state of its own block goes with each motion, though it is held back until the next one is read.
    let feeds: Vec<u32> = run.motions.iter().map(|(_, control)| control.tool).collect();
    assert_eq!(feeds, [1; 9]);
}

#[test]
fn a_fagor_program_moves_the_same_tip() {
    let text = "%LATHE,MX--,\nG18 G71 G90 G94 G97 G40\nT1 D1\nS500 M3\nG0 X40 Z5\nG42 G1 X0 Z0 F120\nX16\nX20 Z-2\nG4 K50\nZ-20\n\
        G2 X30 Z-25 R5\nG1 X38\nG40 X50 Z5\nM30\n";
    let run = clean(&FAGOR_8055_T, text);
    let moved: Vec<&Motion> = run
        .motions
        .iter()
        .map(|(motion, _)| motion)
        .filter(|motion| !matches!(motion.kind, MotionKind::Dwell(_)))
        .skip(1)
        .collect();
    for (motion, expected) in moved.iter().zip(tips()) {
        near(end(motion), expected);
    }
    assert_eq!(moved.len(), 7);
}

/// Per revolution under constant surface speed the time is the integral over the radius, here of the compensated path: a cylinder
/// of radius 10 at 100 m/min turns at 100000/(20π) rpm.
#[test]
fn times_under_constant_surface_speed_come_from_the_compensated_radius() {
    let text = "O1\nG21 G99\nT0101\nG50 S9000\nG96 S100 M3\nG0 X40. Z5.\nG42 G1 X20. Z2. F0.1\nZ-20.\nX30.\nG40 X40. Z5.\nM30\n";
    let run = clean(&FANUC_LATHE_A, text);
    let motion = run.motions[2].0;
    near(end(&motion), [-20.0, 10.0]);
    let length = motion.from.get(Axis::Z) - motion.to.get(Axis::Z);
    assert!((length - (1.2 + 20.0)).abs() < 1e-12);
    let rpm = 100_000.0 / (20.0 * std::f64::consts::PI);
    assert!((motion.seconds.unwrap() - 60.0 * length / (0.1 * rpm)).abs() < 1e-9);
}

fn refused(text: &str) -> Refused {
    let run = run(&FANUC_LATHE_A, text);
    assert_eq!(run.faults.len(), 1, "{:?}", run.faults);
    run.faults.into_iter().next().unwrap()
}

const HEAD: &str = "O1\nG21 G98 G97\nT0101\nM3 S500 F120.\nG0 X40. Z5.\n";

#[test]
fn an_arc_as_entry_and_one_as_exit_are_refused_by_name() {
    let fault = refused(&format!("{HEAD}G42 G2 X50. Z0. R5.\nG1 Z-10.\nG40 X60.\nM30\n"));
    assert_eq!((fault.line, fault.what.en.as_ref()), (6, "G41 or G42 begins on an arc"));
    let fault = refused(&format!("{HEAD}G42 G1 Z0.\nZ-10.\nG40 G2 X50. Z-15. R5.\nG1 X60.\nM30\n"));
    assert_eq!((fault.line, fault.what.en.as_ref()), (8, "G40 ends the compensation on an arc"));
}

#[test]
fn a_nose_that_does_not_fit_is_refused_at_its_block_with_its_numbers() {
    let fault = refused(&format!("{HEAD}G42 G1 X20. Z2.\nZ-10.\nG2 X21. Z-10.5 R0.5\nG1 X30.\nG40 X40.\nM30\n"));
    assert_eq!(
        (fault.line, fault.what.en.as_ref()),
        (8, "nose radius 0.8 mm does not fit into the arc of radius 0.5 mm")
    );
    let fault = refused(&format!("{HEAD}G42 G1 X20. Z2.\nZ-10.\nX10.\nZ-11.5\nX20.\nZ-20.\nG40 X40.\nM30\n"));
    assert_eq!(fault.line, 9);
    assert_eq!(
        fault.what.en.as_ref(),
        "nose radius 0.8 mm does not fit: the element is 1.5 mm long and the corners at its ends need 1.6 mm"
    );
    assert_eq!(fault.remedy.en.as_ref(), "use a nose radius of 0.75 mm or less, or change the contour");
}

#[test]
fn an_offset_without_a_nose_is_refused_once_and_radius_0_follows_the_program() {
    let text = format!("{HEAD}G42 G1 X20. Z2.\nZ-10.\nX30.\nG40 X40.\nM30\n");
    let fault = refused(&text.replace("T0101", "T0303"));
    assert_eq!(fault.line, 6);
    assert_eq!(fault.what.en.as_ref(), "G41 or G42, but offset 3 has no nose radius in the tool table");
    let sharp = clean(&FANUC_LATHE_A, &text.replace("T0101", "T0202"));
    let plain = clean(&FANUC_LATHE_A, &text.replace("T0101", "T0202").replace("G42 ", ""));
    let only = |run: &Run| run.motions.iter().map(|(motion, _)| *motion).collect::<Vec<_>>();
    assert_eq!(only(&sharp), only(&plain));
    assert!(
        sharp.remarks.iter().any(|(grade, what)| *grade == Grade::Note && what.contains("nose radius 0 (offset 2)"))
    );
}

#[test]
fn without_an_offset_in_force_nothing_is_compensated_and_it_is_said() {
    let text = format!("{HEAD}G42 G1 X20. Z2.\nZ-10.\nG40 X40.\nM30\n").replace("T0101", "T0100");
    let run = clean(&FANUC_LATHE_A, &text);
    near(end(&run.motions[1].0), [2.0, 10.0]);
    assert!(
        run.remarks.iter().any(|(grade, what)| *grade == Grade::Caution && what.contains("without an offset in force"))
    );
}

#[test]
fn threads_and_tool_changes_under_compensation_are_refused_by_name() {
    let fault = refused(&format!("{HEAD}G42 G1 X20. Z2.\nZ0.\nG32 Z-10. F1.5\nG40 G0 X40.\nM30\n"));
    assert_eq!((fault.line, fault.what.en.as_ref()), (8, "thread with G41 or G42 in force"));
    let fault = refused(&format!("{HEAD}G42 G1 X20. Z2.\nZ-10.\nT0404\nX30.\nG40 X40.\nM30\n"));
    assert_eq!((fault.line, fault.what.en.as_ref()), (9, "the tool nose changes with G41 or G42 in force"));
}

#[test]
fn a_fagor_mill_refuses_compensation_by_its_name() {
    for control in [&FAGOR_8055, &FAGOR_8070] {
        let run = run(control, "G71 G41 G1 X10 F100\nM30\n");
        assert!(run.faults.iter().any(|fault| fault.what.en.contains("tool radius compensation")), "{:?}", run.faults);
    }
}

/// The program ends with the compensation in force: the last motion ends at right angles to itself, and that is the position.
#[test]
fn a_program_may_end_under_compensation() {
    let run = clean(&FANUC_LATHE_A, &format!("{HEAD}G42 G1 X20. Z2.\nZ-10.\nM30\n"));
    let last = run.motions.last().unwrap().0;
    near(end(&last), [-10.8, 10.0]);
    assert_eq!(run.end.1.get(Axis::Z), last.machine.get(Axis::Z));
}

/// A work offset may change under compensation: the contour goes on in the machine, without a jump.
#[test]
fn a_work_offset_that_changes_keeps_the_path_whole() {
    let one = clean(&FANUC_LATHE_A, &format!("{HEAD}G42 G1 X20. Z2.\nZ-10.\nX30.\nG40 X40.\nM30\n"));
    let text = format!("{HEAD}G42 G1 X20. Z2.\nZ-10.\nG50 X40. Z0.\nX50. Z0.\nG40 X60.\nM30\n");
    let two = clean(&FANUC_LATHE_A, &text);
    for ((one, _), (two, _)) in one.motions.iter().zip(&two.motions) {
        near(
            [one.machine.get(Axis::Z), one.machine.get(Axis::X)],
            [two.machine.get(Axis::Z), two.machine.get(Axis::X)],
        );
    }
    assert_eq!(one.motions.len(), two.motions.len());
    near(end(&two.motions[3].0), [0.0, 24.2]);
}

/// A pass of G90 or G94 leaves the nose tangent to its cone, on the side away from the tip; along an axis it is made as it is.
#[test]
fn the_cone_of_a_pass_is_touched_by_the_nose() {
    // Tip 3 at [Z, X] = [−R, −R] from the centre; the cones rise towards the chuck, fall, and face.
    for (block, on, slope_of_x) in [
        ("G90 X30. Z-20. R-3. F120.", [-20.0, 15.0], -3.0 / 25.0),
        ("G90 X30. Z-20. R2. F120.", [-20.0, 15.0], 2.0 / 25.0),
        ("G94 X20. Z-5. R-2. F120.", [-5.0, 10.0], 10.0 / -2.0),
    ] {
        let run = clean(&FANUC_LATHE_A, &format!("{HEAD}G42\n{block}\nG40 G0 X60.\nM30\n"));
        let cut = run.motions.iter().find(|(motion, _)| matches!(motion.kind, MotionKind::Feed(_))).unwrap().0;
        assert_eq!(cut.line, 7);
        for pose in [&cut.from, &cut.to] {
            let centre = [pose.get(Axis::Z) + 0.8, pose.get(Axis::X) + 0.8];
            // From the centre to the cone, at right angles to it.
            let along = rodete::number::trig::hypot(1.0, slope_of_x);
            let off = (slope_of_x * (centre[0] - on[0]) - (centre[1] - on[1])) / along;
            assert!((off.abs() - 0.8).abs() < 1e-9, "{block}: {off}");
        }
    }
    for block in ["G90 X30. Z-20. F120.", "G94 X20. Z-5. F120."] {
        let moves = |head: &str| {
            let run = clean(&FANUC_LATHE_A, &format!("{HEAD}{head}\n{block}\nG40 G0 X60.\nM30\n"));
            run.motions.into_iter().map(|(motion, _)| motion).collect::<Vec<_>>()
        };
        assert_eq!(moves("G42"), moves("G40"), "{block}");
    }
}

#[test]
fn moves_to_the_reference_point_end_the_compensation_and_it_starts_up_again() {
    let text = format!("{HEAD}G42 G1 X20. Z2.\nZ-10.\nG28 U0. W0.\nG0 X20. Z2.\nG1 Z-5.\nX30.\nG40 X60.\nM30\n");
    let run = clean(&FANUC_LATHE_A, &text);
    let of = |line: usize| {
        run.motions.iter().filter(|(motion, _)| motion.line == line).map(|(motion, _)| *motion).collect::<Vec<_>>()
    };
    near(end(&of(7)[0]), [-10.8, 10.0]);
    let home = *of(8).last().unwrap();
    assert_eq!((home.machine.get(Axis::X), home.machine.get(Axis::Z)), (0.0, 0.0));
    near(end(&of(9)[0]), [1.2, 10.0]);
    near(end(&of(10)[0]), [-5.0, 10.0]);
}

#[test]
fn a_fagor_program_loses_its_compensation_at_g53_and_is_told() {
    let text = "%LATHE,MX--,\nG18 G71 G90 G94 G97 G40\nT1 D1\nS500 M3\nG0 X40 Z5\nG42 G1 X20 Z2 F120\nZ-10\nG0 G53 X200 Z100\n\
        G0 X40 Z5\nG1 Z-3\nM30\n";
    let run = clean(&FAGOR_8055_T, text);
    near(end(&run.motions.last().unwrap().0), [-3.0, 20.0]);
    assert!(run.remarks.iter().any(|(grade, what)| *grade == Grade::Caution && what == "G53 cancels G41 and G42"));
}

/// Only one motion is kept waiting, however long the contour.
#[test]
fn a_long_contour_is_handed_out_as_it_is_read() {
    let mut text = format!("{HEAD}G42 G1 X20. Z2.\n");
    for block in 1..=20_000 {
        text += &format!("G1 Z-{}.{} X{}.\n", block / 10, block % 10, 20 + 4 * (block % 2));
    }
    text += "G40 X60.\nM30\n";
    let mut setting = Setting::new(&FANUC_LATHE_A);
    setting.tools = Some(Tools::from([(1, ToolOffset { nose: Some(nose(0.01, 3)), ..ToolOffset::default() })]));
    let mut reader = Interpreter::over(text.as_bytes(), setting);
    let mut last = 0;
    while let Some(item) = reader.next() {
        let motion = item.unwrap();
        assert!(
            motion.line <= reader.lines() && reader.lines() <= motion.line + 2,
            "{} at {}",
            motion.line,
            reader.lines()
        );
        last = motion.line;
    }
    assert_eq!(last, 20_007);
}

const CONTOUR: &str = "N10 G42 G0 X0.\nN20 G1 Z0.\nN30 X16.\nN40 X20. Z-2.\nN50 Z-20.\nN60 G2 X30. Z-25. R5.\nN70 G1 X38.\nN80 G40 X44.\n";

/// G70 makes the same motions as the contour's blocks would, then goes back; the passes of G71 are those without compensation, and
/// that is said.
#[test]
fn g70_follows_the_contour_with_the_nose_and_g71_does_not() {
    let head = "O1\nG21 G98 G97\nT0101\nM3 S500\nG0 X44. Z2.\n";
    let plain = clean(&FANUC_LATHE_A, &format!("{head}F120.\n{CONTOUR}M30\n"));
    let cycle = |contour: &str| {
        clean(&FANUC_LATHE_A, &format!("{head}G71 U2. R0.5\nG71 P10 Q80 U0. W0. F120.\n{contour}G70 P10 Q80\nM30\n"))
    };
    let run = cycle(CONTOUR);
    let finishing = run.motions.len() - 9;
    for ((one, own), (other, control)) in run.motions[finishing..].iter().zip(&plain.motions[1..]) {
        near(end(one), end(other));
        assert_eq!((one.n, own.compensation), (other.n, control.compensation));
        assert!(one.seconds.is_none() == other.seconds.is_none());
        assert!((one.seconds.unwrap_or(0.0) - other.seconds.unwrap_or(0.0)).abs() < 1e-9);
    }
    near(end(&run.motions.last().unwrap().0), [2.0, 22.0]);
    assert!(
        run.remarks
            .iter()
            .any(|(grade, what)| *grade == Grade::Note && what.contains("have no nose radius compensation"))
    );
    let bare = cycle(&CONTOUR.replace("G42 ", "").replace("G40 ", ""));
    let roughing = |run: &Run| run.motions.iter().map(|(motion, _)| *motion).take(finishing).collect::<Vec<_>>();
    assert_eq!(roughing(&run), roughing(&bare));
    assert!(finishing > 20);
    assert!(!bare.remarks.iter().any(|(_, what)| what.contains("compensation")));
}

/// What does not fit in the contour is refused at its block, not at the cycle.
#[test]
fn g70_refuses_at_the_block_of_the_contour() {
    let contour = CONTOUR.replace("G2 X30. Z-25. R5.", "G2 X21. Z-20.5 R0.5");
    let text = format!("O1\nG21 G98 G97\nT0101\nM3 S500 F120.\nG0 X44. Z2.\nG70 P10 Q80\nM30\n{contour}");
    let fault = refused(&text);
    assert_eq!(
        (fault.line, fault.what.en.as_ref()),
        (13, "nose radius 0.8 mm does not fit into the arc of radius 0.5 mm")
    );
}

/// G70 finishes on a Fanuc, and puts inches into force on a Fagor.
#[test]
fn the_remedy_for_passes_without_compensation_names_only_what_the_control_has() {
    for (control, text, finish) in [
        (
            &FANUC_LATHE_A,
            "G21 G98 G97\nT0101\nM3 S500 F120.\nG0 X40. Z5.\nG42\nG71 U2. R1.\nG71 P10 Q20\nN10 G0 X20.\nG1 Z-10.\nN20 X40.\nG40 G0 X50.\nM30\n",
            Some("use G70"),
        ),
        (
            &FAGOR_8055_T,
            "G71 G95 F0.2 S500 M3\nT1 D1\nG0 X60 Z5\nG42 G1 X54 Z3\nG81 X20 Z0 Q30 R-30 C2 D1\nG40 G0 X100 Z50\nM30\n",
            None,
        ),
    ] {
        let mut setting = Setting::new(control);
        setting.tools = Some(Tools::from([(1, ToolOffset { nose: Some(nose(0.8, 3)), ..ToolOffset::default() })]));
        let mut reader = Interpreter::over(text.as_bytes(), setting);
        assert_eq!(reader.by_ref().filter_map(Result::err).count(), 0, "{text}");
        let remarks = reader.remarks();
        let told = remarks.iter().find(|finding| ["G0773", "G0790"].contains(&finding.rule().code)).unwrap();
        let remedy = told.remedy.en.to_string();
        match finish {
            Some(finish) => assert!(remedy.starts_with(finish), "{remedy}"),
            None => assert!(!remedy.contains("G70") && remedy.contains("G1, G2 and G3"), "{remedy}"),
        }
    }
}
