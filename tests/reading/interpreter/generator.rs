//! Programs by chance that a control should take: each step is one thing to do with dice for its numbers, and the
//! writer keeps as much of the state as it takes to make most blocks valid.

use std::fmt::Write;

use proptest::prelude::*;
use proptest::strategy::Union;
use rodete::gcode::motion::Plane;
use rodete::machine::axis::Axis;
use rodete::number::trig::{hypot, sin_cos};

/// Numbers by chance; they shrink towards 0.
pub type Dice = [u16; 16];

#[derive(Clone, Copy, Debug)]
enum What {
    Rapid,
    Linear,
    ArcByCentre,
    ArcByRadius,
    Dwell,
    Plane,
    Distance,
    CentreMode,
    Units,
    FeedMode,
    Speed,
    SetPosition,
    LocalOffset,
    SetPositionState,
    SetWorkOffset,
    SetWorkOffsetHere,
    WorkOffset,
    ToolLength,
    ToolTable,
    ToolChange,
    Reference,
    KeepReference,
    MachineCoordinates,
    Cycle,
    CycleAgain,
    Retract,
    Cancel,
    Parameter,
    Repeat,
    Idle,
}

/// How often each comes, of the sum.
const WEIGHTS: [(u32, What); 30] = [
    (8, What::Rapid),
    (10, What::Linear),
    (10, What::ArcByCentre),
    (6, What::ArcByRadius),
    (2, What::Dwell),
    (3, What::Plane),
    (5, What::Distance),
    (1, What::CentreMode),
    (2, What::Units),
    (3, What::FeedMode),
    (2, What::Speed),
    (4, What::SetPosition),
    (3, What::LocalOffset),
    (3, What::SetPositionState),
    (5, What::SetWorkOffset),
    (4, What::SetWorkOffsetHere),
    (4, What::WorkOffset),
    (4, What::ToolLength),
    (2, What::ToolTable),
    (2, What::ToolChange),
    (3, What::Reference),
    (2, What::KeepReference),
    (3, What::MachineCoordinates),
    (8, What::Cycle),
    (4, What::CycleAgain),
    (2, What::Retract),
    (2, What::Cancel),
    (4, What::Parameter),
    (1, What::Repeat),
    (2, What::Idle),
];

/// A program as text, and a variable file to start from.
#[derive(Clone, Debug)]
pub struct Program {
    pub text: String,
    pub var: String,
}

prop_compose! {
    /// Programs of up to so many steps.
    pub fn programs(most: usize)(
        start in any::<Dice>(),
        steps in prop::collection::vec((Union::new_weighted(WEIGHTS.map(|(weight, what)| (weight, Just(what))).to_vec()), any::<Dice>()), 1..most),
    ) -> Program {
        let mut writer = Writer::new(start);
        for (what, dice) in steps {
            writer.step(what, Roll::new(dice));
        }
        Program { text: writer.text + "M2\n", var: var(Roll::new(start)) }
    }
}

/// A variable file: some work offsets and reference points, G92 on or off.
fn var(mut roll: Roll) -> String {
    let mut var = String::new();
    // rs274 wants the numbers in order.
    for number in [5161, 5163, 5182, 5210, 5211, 5212, 5220, 5221, 5223, 5241, 5242, 5264] {
        let value = match number {
            5210 => f64::from(roll.below(2)),
            5220 => f64::from(1 + roll.below(3)),
            _ => roll.number(-8, 8),
        };
        let _ = writeln!(var, "{number}\t{value:.6}");
    }
    var
}

/// The dice of one step, taken one after another.
pub struct Roll {
    dice: Dice,
    at: usize,
}

impl Roll {
    pub const fn new(dice: Dice) -> Self {
        Self { dice, at: 0 }
    }

    /// A number below `end`, 0 where the die is 0.
    pub fn below(&mut self, end: i32) -> i32 {
        let die = i32::from(self.dice[self.at % self.dice.len()]);
        self.at += 1;
        (die * end) >> 16
    }

    /// True in one of so many cases.
    pub fn one_in(&mut self, cases: i32) -> bool {
        self.below(cases) == cases - 1
    }

    pub fn of<T: Copy>(&mut self, choice: &[T]) -> T {
        choice[usize::try_from(self.below(i32::try_from(choice.len()).unwrap())).unwrap()]
    }

    /// A number with two decimals; bounds in whole units.
    pub fn number(&mut self, low: i32, high: i32) -> f64 {
        let span = (high - low) * 100;
        let die = i64::from(self.dice[self.at % self.dice.len()]);
        self.at += 1;
        // From the middle outwards, so that it shrinks to what is plain.
        let offset = (die * i64::from(span)) >> 16;
        let signed = if offset % 2 == 0 { offset / 2 } else { -(offset + 1) / 2 };
        f64::from(low + high) / 2.0 + f64::from(i32::try_from(signed).unwrap()) / 100.0
    }
}

struct Writer {
    text: String,
    dice: Roll,
    inch: bool,
    absolute: bool,
    centre_absolute: bool,
    plane: Plane,
    inverse_time: bool,
    /// A feed that counts in the present unit and mode is in force.
    feed: bool,
    spindle: bool,
    /// The tool offset turns rotary axes too.
    turning_offset: bool,
    /// A cycle that goes on with the next axis words.
    cycle: bool,
    labels: u32,
}

impl Writer {
    fn new(start: Dice) -> Self {
        let mut dice = Roll { dice: start, at: 5 };
        let inch = dice.one_in(3);
        // The place from the variable file is left at once: rs274's own model of the machine forgets the rotation.
        let text = format!("G17 G40 G49 G80 G90 G94 G{}\nG53 G0 X0 Y0 Z0 A0 B0 C0\n", if inch { 20 } else { 21 });
        Self {
            text,
            dice,
            inch,
            absolute: true,
            centre_absolute: false,
            plane: Plane::XY,
            inverse_time: false,
            feed: false,
            spindle: false,
            turning_offset: false,
            cycle: false,
            labels: 0,
        }
    }

    fn line(&mut self, line: &str) {
        let _ = writeln!(self.text, "{line}");
    }

    /// A length in the active unit, some of them written as expressions.
    fn length(&mut self, low: i32, high: i32) -> String {
        let number = if self.inch { self.dice.number(low, high) / 10.0 } else { self.dice.number(low, high) };
        match self.dice.below(12) {
            10 => format!("[{}+{}]", plain(number - 1.0), 1),
            11 => format!("[{}*2]", plain(number / 2.0)),
            9 => format!("{number:+.3}"),
            _ => plain(number),
        }
    }

    /// Some axis words.
    fn axes(&mut self, letters: &str, low: i32, high: i32) -> String {
        let mut words = String::new();
        for letter in letters.chars() {
            if self.dice.below(2) == 0 {
                let number =
                    if "ABC".contains(letter) { plain(self.dice.number(-90, 90)) } else { self.length(low, high) };
                let _ = write!(words, " {letter}{number}");
            }
        }
        if words.is_empty() { format!(" X{}", self.length(low, high)) } else { words }
    }

    /// An F word where the next move at feed needs one, or by chance.
    fn feed_word(&mut self) -> String {
        if self.inverse_time || !self.feed || self.dice.one_in(6) {
            self.feed = true;
            let number = if self.inverse_time { self.dice.number(1, 20) } else { self.dice.number(1, 900) };
            return format!(" F{}", plain(number.abs().max(0.5)));
        }
        String::new()
    }

    /// LinuxCNC forgets G92 where it turns the system in force, until all axes have been named in a move.
    fn settle(&mut self, turned: bool) {
        if turned {
            let back = if self.absolute { "" } else { "\nG91" };
            self.motion_ends_cycle(format!("G90 G0 X1 Y2{back}"));
        }
    }

    /// The axes that can go to a machine position: with G28, G30 and G53 LinuxCNC leaves the tool's offset in A, B and C in,
    /// where rodete goes to the position that its reference promises.
    const fn machine_axes(&self) -> &'static str {
        if self.turning_offset { "XYZ" } else { "XYZABC" }
    }

    fn motion_ends_cycle(&mut self, line: String) {
        self.cycle = false;
        self.line(&line);
    }

    fn step(&mut self, what: What, roll: Roll) {
        self.dice = roll;
        match what {
            What::Rapid => {
                let axes = self.axes("XYZABC", -100, 100);
                self.motion_ends_cycle(format!("G0{axes}"));
            }
            What::Linear => {
                let letters = self.dice.of(&["XYZ", "XYZ", "XYZABC", "ABC"]);
                let (axes, feed) = (self.axes(letters, -100, 100), self.feed_word());
                self.motion_ends_cycle(format!("G1{axes}{feed}"));
            }
            What::ArcByCentre => self.arc_by_centre(),
            What::ArcByRadius => self.arc_by_radius(),
            What::Dwell => {
                let seconds = plain(self.dice.number(0, 4).abs());
                self.line(&format!("G4 P{seconds}"));
            }
            What::Plane => {
                self.plane = self.dice.of(&[Plane::XY, Plane::ZX, Plane::YZ]);
                self.cycle = false;
                self.line(&format!("G80 {}", self.plane.name()));
            }
            What::Distance => {
                self.absolute = !self.absolute;
                self.line(if self.absolute { "G90" } else { "G91" });
            }
            What::CentreMode => {
                self.centre_absolute = !self.centre_absolute;
                self.line(if self.centre_absolute { "G90.1" } else { "G91.1" });
            }
            What::Units => {
                // rs274 alone keeps the numbers of tool offset and feed in the old unit.
                self.inch = !self.inch;
                self.feed = false;
                self.cycle = false;
                self.turning_offset = false;
                self.line(&format!("G80 G49\nG{}", if self.inch { 20 } else { 21 }));
            }
            What::FeedMode => {
                self.inverse_time = !self.inverse_time && self.dice.below(2) == 0;
                self.feed = false;
                self.cycle = false;
                let per_turn = !self.inverse_time && self.spindle && self.dice.one_in(3);
                self.line(&format!(
                    "G80 G{}",
                    if self.inverse_time {
                        93
                    } else if per_turn {
                        95
                    } else {
                        94
                    }
                ));
            }
            What::Speed => {
                self.spindle = true;
                let (speed, code) = (self.dice.below(5000) + 100, self.dice.of(&[3, 4]));
                self.line(&format!("S{speed} M{code}"));
            }
            What::SetPosition => {
                let axes = self.axes("XYZABC", -50, 50);
                self.line(&format!("G92{axes}"));
            }
            What::LocalOffset => {
                let axes = self.axes("XYZABC", -50, 50);
                self.line(&format!("G52{axes}"));
            }
            What::SetPositionState => {
                let code = self.dice.of(&["G92.1", "G92.2", "G92.3"]);
                self.line(code);
            }
            What::SetWorkOffset => {
                let (system, axes) = (self.dice.below(10), self.axes("XYZABC", -100, 100));
                let rotation = if self.dice.below(3) == 0 {
                    format!(" R{}", plain(self.dice.number(-180, 180)))
                } else {
                    String::new()
                };
                self.line(&format!("G10 L2 P{system}{axes}{rotation}"));
                self.settle(!rotation.is_empty());
            }
            What::SetWorkOffsetHere => {
                let (system, axes) = (self.dice.below(10), self.axes("XYZABC", -50, 50));
                self.line(&format!("G10 L20 P{system}{axes}"));
            }
            What::WorkOffset => {
                let code = self.dice.of(&["54", "55", "56", "57", "58", "59", "59.1", "59.2", "59.3"]);
                self.line(&format!("G{code}"));
            }
            What::ToolLength => {
                let line = match self.dice.below(4) {
                    0 => format!("G43 H{}", self.dice.of(&[1, 2, 3, 7, 12])),
                    1 => format!("G43.1{}", self.axes("XYZA", -20, 20)),
                    2 => format!("G43.2 H{}", self.dice.of(&[1, 2, 3])),
                    _ => "G49".to_owned(),
                };
                self.turning_offset = line.contains("H3")
                    || (line.contains('A') || self.turning_offset) && (line.contains("43.1") || line.contains("43.2"));
                self.line(&line);
            }
            What::ToolTable => {
                let (l, tool, axes) = (self.dice.of(&[1, 10, 11]), self.dice.of(&[1, 2, 7]), self.axes("XYZ", -20, 20));
                self.line(&format!("G10 L{l} P{tool}{axes}"));
            }
            What::ToolChange => {
                // rs274's model of the machine is true again after a move of all axes.
                let tool = self.dice.of(&[1, 2, 7, 12]);
                self.cycle = false;
                let back = if self.absolute { "" } else { "\nG91" };
                self.line(&format!("G90 G0 X1 Y2 Z3 A4 B5 C6{back}\nT{tool} M6"));
                self.spindle = false;
                if self.dice.below(2) == 0 {
                    self.line("G43");
                }
            }
            What::Reference => {
                let code = self.dice.of(&[28, 30]);
                let axes = self.axes(self.machine_axes(), -50, 50);
                let axes = if self.dice.one_in(3) && !self.turning_offset { String::new() } else { axes };
                self.line(&format!("G{code}{axes}"));
            }
            What::KeepReference => {
                let code = self.dice.of(&["G28.1", "G30.1"]);
                self.line(code);
            }
            What::MachineCoordinates => {
                let axes = self.axes(self.machine_axes(), -100, 100);
                if self.absolute {
                    self.motion_ends_cycle(format!("G53 G0{axes}"));
                }
            }
            What::Cycle => self.cycle(),
            What::CycleAgain => {
                if self.cycle {
                    let words = self.hole();
                    let times = self.dice.below(4);
                    let times = if times > 1 { format!(" L{times}") } else { String::new() };
                    self.line(&format!("{}{times}", words.trim_start()));
                }
            }
            What::Retract => {
                let code = self.dice.of(&["G98", "G99"]);
                self.line(code);
            }
            What::Cancel => self.motion_ends_cycle("G80".to_owned()),
            What::Parameter => {
                let (value, axis) = (plain(self.dice.number(-30, 30)), self.dice.of(&['X', 'Y', 'Z']));
                let line = match self.dice.below(4) {
                    0 => format!("#1={value} #2=[#1/2]\nG0 {axis}#1 A#2"),
                    1 => format!("#<n>={value}\nG0 {axis}[#<n>*2] B-#<n>"),
                    2 => format!("#3={value} G0 {axis}#3\n{axis}#3"),
                    _ => format!("G0 X[#5420*1.5] Y[#5421+{value}] Z[#<_z>-#5221]"),
                };
                self.motion_ends_cycle(line);
            }
            What::Repeat => {
                self.labels += 1;
                let (label, times, axes) = (self.labels, self.dice.below(4), self.axes("XYZ", -5, 5));
                self.cycle = false;
                self.line(&format!("o{label} repeat [{times}]\n  G0{axes}\no{label} endrepeat"));
            }
            What::Idle => {
                let line =
                    self.dice.of(&["M8", "M9", "G64 P0.01", "G61", "(a comment)", "N10", "/M7", "; text", "G40", "M1"]);
                self.line(line);
            }
        }
    }

    /// A place for a hole in the plane.
    fn hole(&mut self) -> String {
        let [first, second, _] = self.plane.axes().map(Axis::letter);
        let axes: String = [first, second].iter().collect();
        let words = self.axes(&axes, -100, 100);
        // The fallback of `axes` is X, which in G19 lies across the plane.
        if words.contains(first) || words.contains(second) { words } else { format!(" {first}1") }
    }

    fn cycle(&mut self) {
        if self.inverse_time {
            return;
        }
        let across = self.plane.axes()[2].letter();
        let code = self.dice.of(&[81, 82, 83, 73, 85, 89, 86, 84, 87, 88]);
        if matches!(code, 84 | 86..=88) && !self.spindle {
            return;
        }
        // LinuxCNC mixes up the axes of tapping in G18 and G19.
        if code == 84 && self.plane != Plane::XY {
            return;
        }
        let code = if code == 84 {
            self.line("S500 M3");
            84
        } else {
            code
        };
        let feed = self.feed_word();
        let words = self.hole();
        let r = self.dice.number(-10, 10);
        let deep = self.dice.number(0, 40).abs() + 0.5;
        let (r, deep) = if self.inch { (r / 10.0, deep / 10.0) } else { (r, deep) };
        // With G91 the depth counts from R.
        let z = if self.absolute { r - deep } else { -deep };
        // No whole number of pecks: whether the last one is still made would be up to the last digit.
        let own = match code {
            82 | 86 | 88 | 89 => format!(" P{}", plain(self.dice.number(0, 3).abs())),
            83 | 73 => format!(" Q{}", plain((deep / f64::from(1 + self.dice.below(5)) * 0.93).max(0.0213))),
            87 => {
                let [i, j, k] = [(-4, 4), (-4, 4), (-10, 10)].map(|(low, high)| self.length(low, high));
                format!(" I{i} J{j} K{k}")
            }
            _ => String::new(),
        };
        self.cycle = true;
        self.line(&format!("G{code}{words} {across}{} R{}{own}{feed}", plain(z), plain(r)));
    }

    /// An arc about a chosen centre by a chosen angle, its words rounded.
    fn arc_by_centre(&mut self) {
        let [first, second, across] = self.plane.axes().map(Axis::letter);
        let (i, j) = (self.dice.number(-40, 40), self.dice.number(-40, 40));
        let (i, j) = if hypot(i, j) < 1.0 { (3.0, 4.0) } else { (i, j) };
        let (i, j) = if self.inch { (i / 10.0, j / 10.0) } else { (i, j) };
        let clockwise = self.dice.below(2) == 0;
        let angle = f64::from(self.dice.below(24)) * 15.0;
        let (sin, cos) = sin_cos(angle.to_radians());
        let (end1, end2) = (i - i * cos + j * sin, j - i * sin - j * cos);
        let centre = |first: char| match first {
            'X' => 'I',
            'Y' => 'J',
            _ => 'K',
        };
        let (c1, c2) = (centre(first), centre(second));
        // Absolute words need a place that is known.
        let (from1, from2) = (f64::from(self.dice.below(20)), f64::from(self.dice.below(20)));
        let known = self.absolute || self.centre_absolute;
        if known {
            let back = if self.absolute { "" } else { "\nG91" };
            self.line(&format!("G90 G0 {first}{from1} {second}{from2}{back}"));
        }
        let base = |from: f64, needed: bool| if needed { from } else { 0.0 };
        let mut words = String::new();
        if angle > 0.0 {
            let (e1, e2) = (base(from1, self.absolute) + end1, base(from2, self.absolute) + end2);
            let _ = write!(words, " {first}{} {second}{}", plain(e1), plain(e2));
        }
        let (i, j) = (base(from1, self.centre_absolute) + i, base(from2, self.centre_absolute) + j);
        let _ = write!(words, " {c1}{} {c2}{}", plain(i), plain(j));
        if self.dice.one_in(3) {
            let _ = write!(words, " {across}{}", self.length(-20, 20));
        }
        if self.dice.one_in(5) {
            let _ = write!(words, " P{}", 1 + self.dice.below(3));
        }
        if self.dice.one_in(6) {
            let _ = write!(words, " C{}", plain(self.dice.number(-90, 90)));
        }
        let feed = self.feed_word();
        self.motion_ends_cycle(format!("G{}{words}{feed}", if clockwise { 2 } else { 3 }));
    }

    fn arc_by_radius(&mut self) {
        let [first, second, across] = self.plane.axes().map(Axis::letter);
        let unit = if self.inch { 0.1 } else { 1.0 };
        let (d1, d2) = (self.dice.number(-40, 40) * unit, self.dice.number(-40, 40) * unit);
        let (d1, d2) = if hypot(d1, d2) < unit { (3.0 * unit, 4.0 * unit) } else { (d1, d2) };
        let radius = hypot(d1, d2) / 2.0 * (1.02 + f64::from(self.dice.below(30)) / 10.0);
        let radius = if self.dice.one_in(3) { -radius } else { radius };
        let (from1, from2) = (f64::from(self.dice.below(20)), f64::from(self.dice.below(20)));
        if self.absolute {
            self.line(&format!("G0 {first}{from1} {second}{from2}"));
        }
        let (e1, e2) = if self.absolute { (from1 + d1, from2 + d2) } else { (d1, d2) };
        let helix = if self.dice.one_in(3) { format!(" {across}{}", self.length(-20, 20)) } else { String::new() };
        let turns = if self.dice.one_in(6) { " P2" } else { "" };
        let (code, feed) = (self.dice.of(&[2, 3]), self.feed_word());
        let words = format!("G{code} {first}{} {second}{} R{}", plain(e1), plain(e2), plain(radius));
        self.motion_ends_cycle(format!("{words}{helix}{turns}{feed}"));
    }
}

/// A number as a program has it: four decimals at most, without an exponent.
pub fn plain(number: f64) -> String {
    let text = format!("{number:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}
