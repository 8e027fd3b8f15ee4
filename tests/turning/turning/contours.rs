//! What the blocks of a contour say beside their motions: roughing passes it over, finishing obeys it in its place.

use rodete::gcode::in_force::{Compensation, InForce, Speed, Spindle};
use rodete::gcode::interpreter::Interpreter;
use rodete::gcode::motion::{FeedMode, MotionKind};

use super::lines::{line, read, remarked, setting};

const HEAD: &str = "T0101 M3 S1000 F0.2\nG0 X50. Z5.\n";
const PLAIN: &str = "N10 G0 X30.\nG1 Z-10. F0.1\nN20 X50.\n";
/// The same contour with a word of every kind that is no motion.
const FULL: &str =
    "N10 G0 X30. G96 S150\n(a comment)\nM8\nN15\nG1 Z-10. F0.1\nG4 P1500\nG98 F80. M4\nN20 X50. M9\nN25 M5\n";

#[test]
fn roughing_makes_the_same_motions_whatever_else_the_contour_s_blocks_say() {
    for (first, second) in [("G71 U4. R1.", "G71 P10 U1. W.2 F.3"), ("G73 U4. W2. R3", "G73 P10 U1. W.1 F.3")] {
        let plain = read(&format!("{HEAD}{first}\n{second} Q20\n{PLAIN}"));
        let full = read(&format!("{HEAD}{first}\n{second} Q25\n{FULL}"));
        let [wanted, found] = [&plain, &full].map(|read| read.motions.iter().map(line).collect::<Vec<_>>());
        assert!(found.len() > 10);
        assert_eq!(found, wanted, "no block without motion is a point of the contour");
        assert!(full.controls.iter().skip(1).all(|control| {
            *control == InForce { feed_mode: FeedMode::PerRevolution, ..plain.controls[1] }
                && control.speed == Speed::Revolutions(1000.0)
                && control.spindle == Spindle::Clockwise
                && !control.coolant
        }));
        let cycle = &first[..3];
        assert!(remarked(&full, &format!("{cycle} ignores M, T, G4, G96 to G99, F and S within the contour")));
        assert!(!remarked(&plain, "passes over"));
    }
}

#[test]
fn finishing_obeys_the_blocks_of_the_contour_in_their_places() {
    let read = read(&format!("{HEAD}G71 U20. R1.\nG71 P10 Q25 F.3\n{FULL}G70 P10 Q25\nG0 X60."));
    let from = read.motions.iter().rposition(|motion| motion.line == 5).unwrap();
    let lines: Vec<_> = read.motions[from..].iter().map(line).collect();
    // G1 Z−10 at 0.1 a revolution, 1.5 s there, X50 at 80 mm/min, back to the start.
    assert_eq!(lines, ["G0 X30 Z5", "G1 X30 Z-10 F0.1", "G4 1.5", "G1 X50 Z-10 F80", "G0 X50 Z5", "G0 X60 Z5"]);
    let named: Vec<_> = read.motions[from..].iter().map(|motion| (motion.line, motion.n)).collect();
    assert_eq!(named, [(5, Some(10)), (9, None), (10, None), (12, Some(20)), (14, None), (15, None)]);
    let seen: Vec<_> = read.controls[from..]
        .iter()
        .map(|control| {
            let Speed::Surface(speed) = control.speed else { panic!("{control:?}") };
            (speed, control.spindle, control.coolant, control.feed_mode)
        })
        .collect();
    let (turn, minute) = (FeedMode::PerRevolution, FeedMode::PerMinute);
    let (on, back, off) = (Spindle::Clockwise, Spindle::CounterClockwise, Spindle::Stopped);
    assert_eq!(
        seen,
        [
            (150.0, on, false, turn),
            (150.0, on, true, turn),
            (150.0, on, true, turn),
            // M9 is obeyed behind the motion of its block, M5 in its own.
            (150.0, back, true, minute),
            (150.0, off, false, minute),
            (150.0, off, false, minute),
        ]
    );
    // 20 mm on the diameter at 80 mm/min.
    assert!((read.motions[from + 3].seconds.unwrap() - 10.0 * 60.0 / 80.0).abs() < 1e-9);
}

#[test]
fn revolutions_without_s_keep_the_speed_of_the_place_in_the_contour() {
    // G97 behind X30 under G96 S94.2477796 (1000 · 94.2477796 / (π · 30) = 1000 rpm).
    let contour = "N10 G0 X30. G96 S94.2477796\nG97\nG1 Z-10. F0.1\nN20 X50.\n";
    let read = read(&format!("{HEAD}G50 S3000\nG70 P10 Q20\nM30\n{contour}"));
    let Speed::Revolutions(speed) = read.controls[2].speed else { panic!("{:?}", read.controls[2]) };
    assert_eq!(line(&read.motions[2]), "G1 X30 Z-10 F0.1");
    assert!((speed - 1000.0).abs() < 1e-5, "{speed}");
}

#[test]
fn a_feed_from_before_the_contour_is_told_where_the_contour_changes_its_meaning() {
    let read = read(&format!("{HEAD}G70 P10 Q20\nM30\nN10 G0 X30. G98\nG1 Z-10.\nN20 X50.\n"));
    assert!(remarked(&read, "the program changes between feed per minute and per revolution"));
    assert!(
        matches!(read.motions[2].kind, MotionKind::Feed(feed) if feed.mode == FeedMode::PerMinute && feed.value == 0.2)
    );
}

#[test]
fn a_tool_in_the_first_block_is_finishing_s_own() {
    // Offset 2 is X 10, Z −5: the machine is that much further for the same program point.
    let contour = "N10 G0 X30. T0202\nG1 Z-10. F0.1\nN20 X50.\n";
    let read = read(&format!("{HEAD}G71 U20. R1.\nG71 P10 Q20 F.3\n{contour}G70 P10 Q20\nG0 X60."));
    let from = read.motions.iter().rposition(|motion| motion.line == 5).unwrap();
    assert!(read.controls[..from].iter().all(|control| (control.tool, control.offset) == (1, 1)));
    assert!(read.controls[from..].iter().all(|control| (control.tool, control.offset) == (2, 2)));
    let lines: Vec<_> = read.motions[from..].iter().map(line).collect();
    // The start lies at X50 Z5 of the program, whatever the offset.
    assert_eq!(lines, ["G0 X30 Z5", "G1 X30 Z-10 F0.1", "G1 X50 Z-10 F0.1", "G0 X50 Z5", "G0 X60 Z5"]);
    let shift: Vec<_> = read.motions[from..]
        .iter()
        .map(|motion| {
            let [to, machine] = [&motion.to, &motion.machine];
            [0, 2].map(|axis| machine.0[axis] - to.0[axis])
        })
        .collect();
    assert!(shift.iter().all(|shift| (shift[0] - 5.0).abs() < 1e-9 && (shift[1] + 5.0).abs() < 1e-9), "{shift:?}");
}

#[test]
fn blocks_without_motion_in_a_contour_are_shown_between_its_motions() {
    let program = format!("{HEAD}G70 P10 Q25\nG0 X60.\nM30\n{FULL}");
    let mut interpreter = Interpreter::over(program.as_bytes(), setting());
    interpreter.keep_stood();
    let mut seen = Vec::new();
    loop {
        let item = interpreter.next();
        seen.extend(interpreter.stood().into_iter().map(|stood| (stood.line, "stands", stood.control.coolant)));
        let Some(motion) = item else { break };
        seen.push((motion.unwrap().line, "moves", interpreter.in_force().coolant));
    }
    assert_eq!(
        seen,
        [
            (1, "stands", false),
            (2, "moves", false),
            (6, "moves", false),
            (8, "stands", true),
            (10, "moves", true),
            (11, "moves", true),
            (12, "stands", true),
            (13, "moves", true),
            // M9 behind the motion of its block, then M5.
            (13, "stands", false),
            (14, "stands", false),
            (3, "moves", false),
            (4, "moves", false),
            (5, "stands", false),
        ]
    );
}

#[test]
fn compensation_in_a_block_of_its_own_begins_there() {
    let contour = "N10 G0 X30.\nG42\nG1 Z-10. F0.1\nX40.\nG40\nN20 X50.\n";
    let mut with = setting();
    let tools = with.tools.as_mut().unwrap();
    let tool = tools.get_mut(&1).unwrap();
    tool.nose = Some(rodete::gcode::turning::nose::Nose::default());
    let read = super::lines::read_with(&format!("{HEAD}G70 P10 Q20\nG0 X60.\nM30\n{contour}"), with);
    assert!(read.faults.is_empty(), "{:?}", read.faults);
    let sides: Vec<_> = read.controls[1..].iter().map(|control| control.compensation).collect();
    let (off, right) = (Compensation::Off, Compensation::Right);
    assert_eq!(sides, [off, right, right, off, off, off]);
}

#[test]
fn a_feed_of_nothing_in_a_contour_ends_finishing_there() {
    let read = super::lines::read_with(
        &format!("{HEAD}G70 P10 Q20\nG0 X60.\nM30\nN10 G0 X30.\nG1 Z-10. F0.\nN20 X50.\n"),
        setting(),
    );
    assert_eq!(read.faults.len(), 1);
    let fault = &read.faults[0];
    assert!((fault.line, fault.uncut) == (7, true) && fault.what.en.contains("F0"), "{fault:?}");
    assert_eq!(read.motions.last().map(line).unwrap(), "G0 X60 Z5", "the rest of the program is read");
}
