//! What is written for a control is what the same control reads: plans by chance, over every control that rodete writes for.

use proptest::prelude::*;
use rodete::gcode::control::{ALL, Control, Rotary, Written};
use rodete::gcode::feed_word::FeedWord;
use rodete::gcode::interpreter::{Interpreter, Setting};
use rodete::gcode::motion::MotionKind;
use rodete::gcode::program::Program;
use rodete::gcode::word::{Distance, NumberFormat, Word};
use rodete::gcode::writer::Writer;
use rodete::machine::axis::{Axis, Position};
use rodete::number::grid::Milli;

/// One step of a plan; places in thousandths of mm and of degrees.
#[derive(Clone, Debug)]
enum Step {
    Rapid([i32; 4]),
    Feed([i32; 4], f64),
    Dwell(f64),
    Hold(bool),
    Tool(u32, u32),
}

/// What the control is to make of a step.
#[derive(Debug)]
enum Made {
    Rapid(Vec<f64>),
    /// The place and the seconds of its F word, no fewer than those of the plan.
    Feed(Vec<f64>, f64),
    /// The seconds, and what the word may be off.
    Dwell(f64, f64),
}

fn step() -> impl Strategy<Value = Step> {
    let place = || prop::array::uniform4(-400_000_i32..400_000);
    prop_oneof![
        3 => place().prop_map(Step::Rapid),
        6 => (place(), 0.01..60.0).prop_map(|(to, seconds)| Step::Feed(to, seconds)),
        1 => (0.0..50.0).prop_map(Step::Dwell),
        1 => any::<bool>().prop_map(Step::Hold),
        1 => (1_u32..99, 1_u32..99).prop_map(|(T, D)| Step::Tool(T, D)),
    ]
}

/// The axes of a plan: a mill's with a rotary one, a lathe's.
fn axes(control: &Control) -> &'static [Axis] {
    if control.turns() { &[Axis::X, Axis::Z] } else { &[Axis::X, Axis::Y, Axis::Z, Axis::A] }
}

struct Text {
    text: String,
    made: Vec<Made>,
    tool: Option<(u32, u32)>,
}

fn write(written: Written, plan: &[Step], distance: Distance) -> Text {
    let control = written.control;
    let mut writer = Writer::new(written, Vec::new());
    let (mut made, mut tool) = (Vec::new(), None);
    writer.safety();
    if distance == Distance::Incremental {
        writer.distance(distance);
    }
    writer.begin_feed();
    let mut at = [0; 4];
    // The last tool is seen in force in a motion behind it.
    for step in plan.iter().chain([&Step::Rapid([1_000; 4])]) {
        match *step {
            Step::Rapid(to) | Step::Feed(to, _) => {
                let (mut words, mut by) = (Vec::new(), 0.0);
                for (index, &axis) in axes(control).iter().enumerate() {
                    let difference = Milli::new(to[index] - at[index]);
                    by += difference.value().powi(2);
                    let said = if distance == Distance::Incremental { difference } else { Milli::new(to[index]) };
                    words.push(writer.coordinate(axis, said));
                    at[index] = to[index];
                }
                let place = axes(control).iter().zip(at).map(|(_, at)| Milli::new(at).value()).collect();
                if let Step::Feed(_, seconds) = *step {
                    let resultant = by.sqrt();
                    let F = FeedWord::lasting(writer.law(), seconds, resultant).expect("a word");
                    let lasts = writer.law().seconds(F.value(), resultant);
                    assert!(lasts >= seconds * (1.0 - 1e-9), "{seconds} s are written as {lasts} s");
                    writer.feed(std::iter::once(Word::whole('G', 1)).chain(words), F);
                    made.push(Made::Feed(place, lasts));
                } else {
                    writer.rapid(words);
                    made.push(Made::Rapid(place));
                }
            }
            Step::Dwell(seconds) => {
                writer.dwell(seconds).expect("a dwell");
                // Seconds have three decimals; what counts in parts of them is whole.
                let unit = control.lexis.dwell[0].unit;
                made.push(Made::Dwell(seconds, if unit == 1.0 { 0.0005 } else { unit / 2.0 } + 1e-9));
            }
            Step::Hold(on) => {
                if let Some(words) = written.writing.height.words(on) {
                    writer.block(words);
                }
            }
            Step::Tool(T, D) => {
                writer.tool(T, D);
                tool = Some((T, D));
            }
        }
    }
    writer.end_feed();
    writer.block([Word::whole('M', 30)]);
    let program = Program {
        key: "plan",
        title: rodete::text::Text::same("plan"),
        control,
        format: NumberFormat::Fixed,
        block_step: Some(1),
        start: Position::default(),
        parts: writer.finish(),
    };
    Text { text: program.text(), made, tool }
}

fn near(one: f64, other: f64) -> bool {
    (one - other).abs() <= 1e-6 * (1.0 + one.abs())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_written_for_a_control_is_what_it_reads(
        plan in prop::collection::vec(step(), 1..24),
        incremental in any::<bool>(),
    ) {
        let distance = if incremental { Distance::Incremental } else { Distance::Absolute };
        let mut controls = 0;
        for control in ALL {
            let Some(written) = Written::of(control) else { continue };
            controls += 1;
            let Text { text, made, tool } = write(written, &plan, distance);
            // Absolute words of a counting plan are true where the axes count.
            let rotary = if incremental { control.rotary.delivered } else { Rotary::Linear };
            let mut interpreter = Interpreter::over(text.as_bytes(), Setting { rotary, ..Setting::new(control) });
            let mut motions = Vec::new();
            for motion in interpreter.by_ref() {
                prop_assert!(motion.is_ok(), "{}: {:?}\n{text}", control.name, motion);
                motions.extend(motion);
            }
            prop_assert_eq!(motions.len(), made.len(), "{}\n{}", control.name, text);
            for (motion, made) in motions.iter().zip(&made) {
                let place = |wanted: &[f64]| {
                    axes(control).iter().zip(wanted).all(|(&axis, &wanted)| near(wanted, motion.to.get(axis)))
                };
                let agrees = match (motion.kind, made) {
                    (MotionKind::Rapid, Made::Rapid(to)) => place(to),
                    (MotionKind::Feed(_), Made::Feed(to, seconds)) => {
                        place(to) && motion.seconds.is_some_and(|read| near(*seconds, read))
                    }
                    (MotionKind::Dwell(read), Made::Dwell(seconds, off)) => (read - seconds).abs() <= *off,
                    _ => false,
                };
                prop_assert!(agrees, "{}: {motion:?} is not {made:?}\n{text}", control.name);
            }
            if let Some((T, D)) = tool {
                prop_assert_eq!(interpreter.in_force().tool, T, "{}\n{}", control.name, text);
                let offset = interpreter.in_force().offset;
                prop_assert!(offset == 0 || offset == D, "{}: offset {offset}\n{text}", control.name);
            }
        }
        prop_assert!(controls >= 4, "{controls} controls are written for");
    }
}
