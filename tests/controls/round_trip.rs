//! What is written for a control is what the same control reads: plans by chance, over every control that rodete writes for.

use proptest::prelude::*;
use rodete::gcode::code::{Cycle, G};
use rodete::gcode::control::{
    ALL, Codes, Control, FAGOR_8055, FAGOR_8055_T, FAGOR_8070, FeedCodes, FeedRule, HeightHold, LINUXCNC,
    Language as Reads, Lexis, MachineZero, OpeningLine, Percent, Post, RotaryMode, TextForm, ToolBlocks, Writing,
};
use rodete::gcode::feed_word::FeedWord;
use rodete::gcode::header::{Header, NamedWorkbook, Origin, Work};
use rodete::gcode::in_force::{Compensation, InForce, Speed, Spindle};
use rodete::gcode::interpreter::{Interpreter, Setting, ToolOffset};
use rodete::gcode::motion::{Feed, FeedMode, Motion, MotionKind, Plane};
use rodete::gcode::program::{self, Part, Path, Program, Role};
use rodete::gcode::word::{Distance, NumberFormat, Word};
use rodete::gcode::writer::Writer;
use rodete::geometry::torus::Torus;
use rodete::kinds::impeller::blank::BlankTurning;
use rodete::machine::axis::{Axis, Position};
use rodete::machine::length_unit::LengthUnit;
use rodete::number::grid::Milli;
use rodete::text::Language;

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
    /// An arc in XY: the place and the seconds.
    Arc(Vec<f64>, f64),
    /// The place and the seconds of its F word, no fewer than those of the plan.
    Feed(Vec<f64>, f64),
    /// The seconds, and what the word may be off.
    Dwell(f64, f64),
    /// The output of this number is switched on, or off: no motion.
    Hold(bool, u32),
}

/// Moves along a path; places in thousandths of mm and of degrees.
#[derive(Clone, Debug)]
struct Along {
    rapid: bool,
    places: Vec<[i32; 5]>,
    backwards: bool,
    /// How far C is turned on.
    turn: i32,
    moving_only: bool,
    /// Of each move at feed.
    seconds: f64,
}

fn along() -> impl Strategy<Value = Along> {
    let places = prop::collection::vec(prop::array::uniform5(-400_000_i32..400_000), 1..6);
    let rest = (any::<bool>(), any::<bool>(), prop::sample::select(vec![0, 72_000, -144_000, 400_123]), any::<bool>());
    (places, rest, 0.01..60.0).prop_map(|(places, (rapid, backwards, turn, moving_only), seconds)| Along {
        rapid,
        places,
        backwards,
        turn,
        moving_only,
        seconds,
    })
}

/// The axes that a path names.
const ALONG: &[Axis] = &[Axis::X, Axis::Y, Axis::Z, Axis::B, Axis::C];

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

/// What another program may have left in force, which the safety block must end: the block that does so on a control, where the
/// control knows the code.
/// Numbers have a decimal point, for controls that count least increments without one.
const SPOILT: [(G, &str); 10] = [
    (G::Inch, ""),
    (G::Incremental, ""),
    (G::WorkOffset(2), ""),
    (G::Plane(Plane::ZX), ""),
    (G::Plane(Plane::YZ), ""),
    (G::Feed(FeedMode::PerRevolution), ""),
    (G::Feed(FeedMode::InverseTime), ""),
    (G::Feed(FeedMode::Seconds), ""),
    (G::Compensation(Compensation::Left), " G17 D1"),
    (G::Cycle(Cycle::Drill), " X0. Y0. Z-1. R1. F100."),
];

/// A mill whose programs begin with `%` and their number, and end with `%`.
static FRAMED: Control = Control {
    name: "framed",
    text: TextForm { opening: &[OpeningLine::Percent, OpeningLine::Number], ending: &["%"], ..LINUXCNC.text },
    lexis: Lexis { percent: Percent::Leader, language: Reads::Macros, ..LINUXCNC.lexis },
    ..LINUXCNC
};

/// A mill that says a feed per minute by G98.
static BY_G98: Control = Control {
    name: "by-g98",
    codes: &CODES_BY_G98,
    feed: FeedRule { codes: FeedCodes::G98, ..LINUXCNC.feed },
    written: Some(&WRITING_BY_G98),
    ..LINUXCNC
};
static WRITING_BY_G98: Writing = Writing {
    safety: &[('G', 17), ('G', 21), ('G', 40), ('G', 54), ('G', 90), ('G', 98)],
    tool: ToolBlocks::Change,
    height: HeightHold::Output(2),
    clamps: &[],
    zero: MachineZero::Read,
};
static CODES_BY_G98: Codes = Codes::new(&[&[
    (&[0], G::Rapid),
    (&[10], G::Linear),
    (&[20], G::Arc(true)),
    (&[30], G::Arc(false)),
    (&[40], G::Dwell),
    (&[170], G::Plane(Plane::XY)),
    (&[180], G::Plane(Plane::ZX)),
    (&[200], G::Inch),
    (&[210], G::Millimetre),
    (&[400], G::Compensation(Compensation::Off)),
    (&[410], G::Compensation(Compensation::Left)),
    (&[540], G::WorkOffset(1)),
    (&[550], G::WorkOffset(2)),
    (&[900], G::Absolute),
    (&[910], G::Incremental),
    (&[930], G::Feed(FeedMode::InverseTime)),
    (&[980], G::Feed(FeedMode::PerMinute)),
    (&[990], G::Feed(FeedMode::PerRevolution)),
]]);

/// The block that leaves something in force; `None` where the control does not know its code. Of a lathe's program the safety
/// block says unit, dimensions and feed: zero, plane and nose are said with the tool.
fn spoils(control: &Control, (code, words): (G, &str)) -> Option<String> {
    let turned = matches!(code, G::Inch | G::Incremental | G::Feed(_));
    let name = control.codes.names(code).into_iter().next()?;
    (turned || !control.turns()).then(|| format!("{name}{words}"))
}

struct Text {
    program: Program,
    text: String,
    axes: &'static [Axis],
    /// The line of what was left in force, behind the header.
    left: usize,
    made: Vec<Made>,
    tool: Option<(u32, u32)>,
}

/// The head of the program: all that one of a workbook has.
const ORIGIN: Origin<'static> = Origin {
    workbook: "Álabe (nº 1); %O7 G0 Z-500.xlsx",
    sha256: "0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef",
    version: "0.1",
    language: Language::En,
};

/// Writes a plan under a whole header, and a block that leaves something in force between both.
fn write(post: Post, plan: &[Step], distance: Distance, before: Option<&String>) -> Text {
    let control = post.control;
    let title = rodete::text::Text::same("plan");
    let work = Work { part: "Rueda (1); 50%", material: "7075 \u{2014} T6", number: 12 };
    let mut writer = Writer::new(post, Header::new(control, "plan", &title, work, &ORIGIN).parts);
    writer.part(Part::Comment("BEHIND THE HEADER".to_owned()));
    if let Some(block) = before {
        writer.part(Part::Line(block.clone()));
    }
    let (mut made, mut tool) = (Vec::new(), None);
    writer.safety();
    let mut at = [0; 4];
    if !control.turns() {
        // 60° of a radius of 10 mm at 10 mm a second; in another plane another arc, or none.
        let [X, Y, Z, R] = [('X', 6_000), ('Y', 8_000), ('Z', 0), ('R', 10_000)]
            .map(|(letter, size)| Word::size(letter, Milli::new(size)));
        writer.rapid([Word::size('X', Milli::new(0)), Word::size('Y', Milli::new(0)), Z]);
        writer.block([Word::whole('G', 2), X, Y, R, Word::whole('F', 600)]);
        made.extend([Made::Rapid(vec![0.0; 4]), Made::Arc(vec![6.0, 8.0, 0.0, 0.0], std::f64::consts::FRAC_PI_3)]);
        at = [6_000, 8_000, 0, 0];
    }
    if distance == Distance::Incremental {
        writer.distance(distance);
    }
    writer.begin_feed();
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
                    if resultant == 0.0 {
                        // No way has an F along it.
                        continue;
                    }
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
                made.push(Made::Dwell(seconds, if unit.whole() { unit.seconds() / 2.0 } else { 0.0005 } + 1e-9));
            }
            Step::Hold(on) => match post.writing.height {
                HeightHold::Builder => assert_eq!(post.writing.height.words(on), None),
                HeightHold::Output(number) => {
                    writer.block(post.writing.height.words(on).expect("an output that is switched"));
                    made.push(Made::Hold(on, number));
                }
            },
            Step::Tool(T, D) => {
                writer.tool(T, D);
                tool = Some((T, D));
            }
        }
    }
    writer.end_feed();
    writer.block([Word::whole('M', 30)]);
    let program = Program { block_step: Some(1), ..writer.program("plan", title) };
    Text::of(program, axes(control), made, tool)
}

impl Text {
    fn of(program: Program, axes: &'static [Axis], made: Vec<Made>, tool: Option<(u32, u32)>) -> Self {
        let text = program.text();
        let header = text.lines().position(|line| line.contains("BEHIND THE HEADER")).expect("the comment");
        Self { program, text, axes, left: header + 2, made, tool }
    }
}

/// Writes a plan of paths under a whole header.
fn write_along(post: Post, plan: &[Along], distance: Distance) -> Text {
    let title = rodete::text::Text::same("plan");
    let work = Work { part: "Rueda (1); 50%", material: "7075 \u{2014} T6", number: 12 };
    let mut writer = Writer::new(post, Header::new(post.control, "plan", &title, work, &ORIGIN).parts);
    writer.part(Part::Comment("BEHIND THE HEADER".to_owned()));
    writer.safety();
    if distance == Distance::Incremental {
        writer.distance(distance);
    }
    writer.begin_feed();
    let (mut made, mut at) = (Vec::new(), Position::default());
    for one in plan {
        let position = |place: &[i32; 5]| {
            let placed = |at: Position, (&axis, size): (&Axis, &i32)| at.with(axis, Milli::new(*size));
            ALONG.iter().zip(place).fold(Position::default(), placed)
        };
        let positions: Vec<Position> = one.places.iter().map(position).collect();
        let mut ordered = positions.clone();
        if one.backwards {
            ordered.reverse();
        }
        let (mut words, mut times) = (Vec::new(), Vec::new());
        for to in ordered.into_iter().map(|to| to.moved(Axis::C, Milli::new(one.turn))) {
            let resultant = to.differences(&at).iter().map(|by| by * by).sum::<f64>().sqrt();
            let place = || ALONG.iter().map(|&axis| to.get(axis).value()).collect();
            // What goes nowhere is no block.
            let moves = to != at;
            let F = FeedWord::lasting(writer.law(), one.seconds, if moves { resultant } else { 10.0 }).expect("a word");
            let lasts = writer.law().seconds(F.value(), resultant);
            words.push(F);
            times.push(lasts);
            if moves {
                made.push(if one.rapid { Made::Rapid(place()) } else { Made::Feed(place(), lasts) });
            }
            at = to;
        }
        let feed = match one.rapid {
            true => program::Feed::None,
            false => program::Feed::Each { words: words.into(), seconds: times.into() },
        };
        writer.part(Part::Path(Path {
            role: Role::Clear,
            positions: positions.into(),
            backwards: one.backwards,
            turn: Milli::new(one.turn),
            axes: ALONG,
            rapid: one.rapid,
            distance,
            moving_only: one.moving_only,
            feed,
        }));
    }
    writer.end_feed();
    writer.block([Word::whole('M', 30)]);
    let program = Program { block_step: Some(1), ..writer.program("plan", title) };
    Text::of(program, ALONG, made, None)
}

/// The outputs that a text switches, by hand: on with M62, off with M63, each with how many of these lines stand before it.
///
/// LinuxCNC, M-code reference: M62 turns a digital output on and M63 off, at the next motion.
fn holds(text: &str, motions: &[usize]) -> Vec<(usize, bool, u32)> {
    let mut found = Vec::new();
    for (line, block) in (1..).zip(text.lines()) {
        let words: Vec<&str> = block.split(' ').collect();
        let on = if words.contains(&"M62") { Some(true) } else { words.contains(&"M63").then_some(false) };
        if let Some(on) = on {
            let number = words.iter().find_map(|word| word.strip_prefix('P')?.parse().ok()).expect("its number");
            found.push((motions.iter().filter(|motion| **motion < line).count(), on, number));
        }
    }
    found
}

fn near(one: f64, other: f64) -> bool {
    (one - other).abs() <= 1e-6 * (1.0 + one.abs())
}

/// Writes a plan and reads it back after a block that leaves something in force.
///
/// # Errors
/// Where the control reads something else than was written.
fn reads_back(post: Post, plan: &[Step], distance: Distance, spoilt: (G, &str)) -> Result<(), String> {
    let before = spoils(post.control, spoilt);
    agrees(post.control, write(post, plan, distance, before.as_ref()), distance, before.as_deref())
}

/// Reads a text back.
///
/// # Errors
/// Where the control reads something else than was to be made.
fn agrees(control: &'static Control, text: Text, distance: Distance, before: Option<&str>) -> Result<(), String> {
    let Text { program, text, axes, left, made, tool } = text;
    let spoils = before.unwrap_or("nothing");
    let wrong = |what: String| Err(format!("{} after {spoils}: {what}\n{text}", control.name));
    let named = NamedWorkbook::of(text.as_bytes());
    if !named.is_some_and(|named| named.is(ORIGIN.workbook) && named.sha256 == ORIGIN.sha256) {
        return wrong("its workbook is not found in its header".to_owned());
    }
    // Absolute words of a counting plan are true where the axes count.
    let rotary = if distance == Distance::Incremental { control.rotary.delivered } else { RotaryMode::Linear };
    let setting = || {
        let tools = (1..=99).map(|T| (T, ToolOffset { diameter: 4.0, ..ToolOffset::default() }));
        Setting { rotary, tools: Some(tools.collect()), ..Setting::new(control) }
    };
    let mut interpreter = Interpreter::over(text.as_bytes(), setting());
    let mut motions = Vec::new();
    while let Some(motion) = interpreter.next() {
        let motion = match motion {
            Ok(motion) => motion,
            Err(found) => return wrong(format!("{found:?}")),
        };
        if motion.line < left {
            return wrong(format!("the header moves: {motion:?}"));
        }
        if before.is_some() && motion.line == left {
            continue;
        }
        let InForce { unit, system, compensation, .. } = *interpreter.in_force();
        if (unit, system, compensation) != (LengthUnit::Millimetre, 1, Compensation::Off) {
            return wrong("the safety block does not end it".to_owned());
        }
        motions.push(motion);
    }
    let (mut planned, mut held) = (Vec::new(), Vec::new());
    for made in &made {
        match *made {
            Made::Hold(on, number) => held.push((planned.len(), on, number)),
            _ => planned.push(made),
        }
    }
    let lines: Vec<usize> = motions.iter().map(|motion| motion.line).collect();
    let read = holds(&text, &lines);
    if read != held {
        return wrong(format!("outputs {read:?} in the place of {held:?}"));
    }
    if motions.len() != planned.len() {
        return wrong(format!("{} motions of {}", motions.len(), planned.len()));
    }
    for (motion, made) in motions.iter().zip(planned) {
        let place = |wanted: &[f64]| {
            assert_eq!(axes.len(), wanted.len());
            axes.iter().zip(wanted).all(|(&axis, &wanted)| near(wanted, motion.to.get(axis)))
        };
        let lasts = |seconds: f64| motion.seconds.is_some_and(|read| near(seconds, read));
        let agrees = match (motion.kind, made) {
            (MotionKind::Rapid, Made::Rapid(to)) => place(to),
            (MotionKind::Feed(_), Made::Feed(to, seconds)) | (MotionKind::Arc(..), Made::Arc(to, seconds)) => {
                place(to) && lasts(*seconds)
            }
            (MotionKind::Dwell(read), Made::Dwell(seconds, off)) => (read - seconds).abs() <= *off,
            _ => false,
        };
        if !agrees {
            return wrong(format!("{motion:?} is not {made:?}"));
        }
    }
    if let Some((T, D)) = tool {
        let InForce { tool, offset, .. } = *interpreter.in_force();
        if tool != T || !(offset == 0 || offset == D) {
            return wrong(format!("tool {tool}, offset {offset} in the place of T{T} D{D}"));
        }
    }
    // As `build` reads it: line by line as it is made.
    let again: Vec<_> = program.read_back_with(setting()).collect();
    let whole: Vec<_> = Interpreter::over(text.as_bytes(), setting()).collect();
    if again != whole {
        return wrong(format!("read back as it is made it is {again:?}, and not {whole:?}"));
    }
    Ok(())
}

/// A safety block without one of its codes leaves in force what that code ends.
#[test]
fn a_safety_block_that_lacks_a_code_does_not_read_back() {
    let plan = [Step::Rapid([5_000, 6_000, 7_000, 0]), Step::Feed([8_000, 9_000, 0, 0], 3.0)];
    for (control, wanted) in [
        (&LINUXCNC, [("G20", 21), ("G91", 90), ("G55", 54), ("G18", 17), ("G95", 94), ("G41", 40)].as_slice()),
        (&FAGOR_8055, &[("G70", 71), ("G91", 90), ("G55", 54), ("G18", 17), ("G95", 94)]),
        (&FAGOR_8070, &[("G70", 71), ("G91", 90), ("G55", 54), ("G18", 17), ("G95", 94), ("G93", 94)]),
        (&FAGOR_8055_T, &[("G70", 71), ("G91", 90)]),
    ] {
        let whole = Post::of(control).expect("rodete writes for it");
        for &(left, code) in wanted {
            let spoilt = SPOILT
                .into_iter()
                .find(|&spoilt| spoils(control, spoilt).is_some_and(|block| block.split(' ').next() == Some(left)));
            let spoilt = spoilt.unwrap_or_else(|| panic!("{} does not know {left}", control.name));
            assert_eq!(reads_back(whole, &plan, Distance::Absolute, spoilt), Ok(()));
            let safety: Vec<_> = whole.writing.safety.iter().copied().filter(|word| *word != ('G', code)).collect();
            assert!(safety.len() < whole.writing.safety.len(), "{}: no G{code} in the safety block", control.name);
            let lacking: &Writing = Box::leak(Box::new(Writing { safety: safety.leak(), ..*whole.writing }));
            let read = reads_back(Post { control, writing: lacking }, &plan, Distance::Absolute, spoilt);
            assert!(read.is_err(), "{}: {left} stays in force without G{code}, and nothing is told", control.name);
        }
    }
}

/// An output that is not switched, or the other way round, is found in the text.
#[test]
fn a_hold_that_is_dropped_or_swapped_does_not_read_back() {
    let post = Post::of(&LINUXCNC).expect("rodete writes for it");
    let plan = [Step::Hold(true), Step::Feed([8_000, 9_000, 0, 0], 3.0), Step::Hold(false)];
    let whole = || write(post, &plan, Distance::Absolute, None);
    assert_eq!(whole().made.iter().filter(|made| matches!(made, Made::Hold(..))).count(), 2);
    assert_eq!(agrees(&LINUXCNC, whole(), Distance::Absolute, None), Ok(()));
    let without = |code: &str| {
        let lines =
            whole().text.lines().filter(|line| !line.contains(code)).map(|line| line.to_owned() + "\n").collect();
        Text { text: lines, ..whole() }
    };
    let swapped = whole().text.replace("M62", "M0062").replace("M63", "M62").replace("M0062", "M63");
    let other = whole().text.replace("M62 P2", "M62 P3");
    let slips = [swapped, other].map(|text| Text { text, ..whole() });
    for slip in slips.into_iter().chain([without("M62"), without("M63")]) {
        assert_ne!(slip.text, whole().text);
        let read = agrees(&LINUXCNC, slip, Distance::Absolute, None);
        assert!(read.is_err_and(|why| why.contains("outputs [")));
    }
}

/// A word of a path that says another axis or counts from another place is found.
#[test]
fn a_path_of_another_place_does_not_read_back() {
    let post = Post::of(&LINUXCNC).expect("rodete writes for it");
    let places = vec![[5_000, 6_000, 7_000, 10_000, 20_000], [8_000, 6_000, 0, 10_000, 40_000]];
    let one = Along { rapid: false, places, backwards: true, turn: 72_000, moving_only: true, seconds: 2.0 };
    for distance in [Distance::Absolute, Distance::Incremental] {
        let whole = || write_along(post, std::slice::from_ref(&one), distance);
        assert_eq!((whole().made.len(), agrees(&LINUXCNC, whole(), distance, None)), (2, Ok(())));
        let turned = Along { turn: 72_001, ..one.clone() };
        let forwards = Along { backwards: false, ..one.clone() };
        for other in [turned, forwards] {
            let text = write_along(post, std::slice::from_ref(&other), distance).text;
            assert!(agrees(&LINUXCNC, Text { text, ..whole() }, distance, None).is_err(), "{other:?}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_written_for_a_control_is_what_it_reads(
        plan in prop::collection::vec(step(), 1..24),
        incremental in any::<bool>(),
        spoilt in prop::sample::select(SPOILT.to_vec()),
    ) {
        let distance = if incremental { Distance::Incremental } else { Distance::Absolute };
        let mut controls = 0;
        for control in ALL.into_iter().chain([&FRAMED, &BY_G98]) {
            let Some(post) = Post::of(control) else { continue };
            controls += 1;
            if let Err(why) = reads_back(post, &plan, distance, spoilt) {
                return Err(TestCaseError::fail(why));
            }
        }
        prop_assert!(controls >= 6, "{controls} controls are written for");
    }

    #[test]
    fn what_is_written_along_paths_for_a_control_is_what_it_reads(
        plan in prop::collection::vec(along(), 1..6),
        incremental in any::<bool>(),
    ) {
        let distance = if incremental { Distance::Incremental } else { Distance::Absolute };
        let mut controls = 0;
        for control in ALL.into_iter().chain([&FRAMED]).filter(|control| !control.turns()) {
            let Some(post) = Post::of(control) else { continue };
            controls += 1;
            if let Err(why) = agrees(control, write_along(post, &plan, distance), distance, None) {
                return Err(TestCaseError::fail(why));
            }
        }
        prop_assert!(controls >= 4, "{controls} controls are written for");
    }

    /// The turning of a blank, in either layout: every place, the feed, the speed and what turns it.
    #[test]
    fn the_turning_of_a_blank_is_what_its_control_reads(
        (R, share) in (10.0..60.0_f64, 0.1..0.8_f64),
        (C, F_b, S_b, S_m) in (0.2..3.0_f64, 0.05..0.4_f64, 50_u32..300, prop::option::of(500_u32..4_000)),
        (T_b, D_b) in (1_u32..99, 1_u32..99),
        [c_f, c_o, c_c, Z_b, X_e, Z_e] in prop::array::uniform6(0.5..9.0_f64),
        full in any::<bool>(),
    ) {
        let grid = |size: f64| (size * 1000.0).round() / 1000.0;
        let [R, r] = [R, R * share].map(grid);
        let [c_f, c_o, c_c, Z_b] = [c_f, c_o, c_c, Z_b].map(grid);
        let (X_e, Z_e) = (grid(2.0 * R + 10.0 * X_e), grid(10.0 * Z_e));
        let (C, F_b) = (grid(C), grid(F_b));
        let turning = BlankTurning { C, F_b, S_b, T_b, D_b, L_b: 50.0, Z_b, c_f, c_o, c_c, X_e, Z_e, S_m };
        let format = if full { NumberFormat::Fixed } else { NumberFormat::Trimmed };
        let program = turning.program(Torus { R, r }, format, 10).expect("a program");
        let text = program.text();
        let mut interpreter = Interpreter::over(text.as_bytes(), Setting::new(program.control));
        let mut read = Vec::new();
        while let Some(motion) = interpreter.next() {
            prop_assert!(motion.is_ok(), "{motion:?}\n{text}");
            read.extend(motion.map(|motion| (motion, *interpreter.in_force())));
        }
        let (rapid, feed) = (MotionKind::Rapid, MotionKind::Feed(Feed { mode: FeedMode::PerRevolution, value: F_b }));
        let planned = [
            (rapid, [2.0 * R, Z_b]),
            (rapid, [2.0 * R + c_f, 0.0]),
            (feed, [-c_o, 0.0]),
            (rapid, [2.0 * R + c_c, 0.0]),
        ];
        let at = |motion: &Motion, [X, Z]: [f64; 2]| near(X / 2.0, motion.to.get(Axis::X)) && near(Z, motion.to.get(Axis::Z));
        prop_assert!(read.len() > planned.len() + 3, "no cycle\n{text}");
        for ((motion, _), (kind, to)) in read.iter().zip(planned) {
            prop_assert!(motion.kind == kind && at(motion, to), "{motion:?} is not {kind:?} to {to:?}\n{text}");
        }
        let (last, _) = read[read.len() - 1];
        prop_assert!(last.kind == rapid && at(&last, [X_e, Z_e]), "{last:?}\n{text}");
        for (motion, _) in &read[planned.len()..read.len() - 1] {
            let [x, z] = [Axis::X, Axis::Z].map(|axis| motion.to.get(axis));
            let around = R - r - 1e-6 <= x && x <= R + c_c + 1e-6 && -r - 1e-6 <= z && z <= 1e-6;
            prop_assert!(around, "{motion:?} is not of the cycle\n{text}");
        }
        for (motion, in_force) in &read[2..] {
            let InForce { tool, offset, spindle, speed, greatest_speed, .. } = *in_force;
            let greatest = if full { S_m.map(f64::from) } else { None };
            prop_assert_eq!((tool, offset, spindle), (T_b, D_b, Spindle::CounterClockwise), "{:?}\n{}", motion, text);
            prop_assert_eq!((speed, greatest_speed), (Speed::Surface(f64::from(S_b)), greatest), "{:?}\n{}", motion, text);
        }
    }
}
