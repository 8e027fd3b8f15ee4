//! Lathe programs and their motions in a short form that a table can hold.

use std::collections::BTreeMap;

use rodete::finding::Finding;
use rodete::gcode::control::FANUC_LATHE_A;
use rodete::gcode::in_force::InForce;
use rodete::gcode::interpreter::{Files, Interpreter, Refused, Setting, ToolOffset, Tools};
use rodete::gcode::motion::{Motion, MotionKind};
use rodete::machine::axis::{Axis, Pose};
use rodete::machine::var_file::VarFile;
use rodete::number::shown;
use rodete::text::Text;

/// A pose with X as a diameter.
pub fn pose(x: f64, z: f64) -> Pose {
    let mut pose = Pose::default();
    pose.set(Axis::X, x / 2.0);
    pose.set(Axis::Z, z);
    pose
}

/// Six turret places; offset 1 is nothing, 2 lies 10 mm further in X (diameter) and −5 in Z.
pub fn tools() -> Tools {
    let offset = |number| if number == 2 { pose(10.0, -5.0) } else { Pose::default() };
    (1..=6).map(|number| (number, ToolOffset { offset: offset(number), ..ToolOffset::default() })).collect()
}

/// G54 at the machine's zero, G55 at X 20 (diameter) Z 100, the reference points at X 300 Z 400 and X 200 Z 250.
pub fn var_file() -> VarFile {
    let mut file = VarFile::default();
    file.complete();
    for (number, value) in
        [(5220, 1.0), (5241, 10.0), (5243, 100.0), (5161, 150.0), (5163, 400.0), (5181, 100.0), (5183, 250.0)]
    {
        file.set(number, value).unwrap();
    }
    file
}

/// Subprograms by the name of their file.
pub struct Folder(pub BTreeMap<String, String>);

impl Files for Folder {
    fn find(&mut self, name: &str) -> Result<Option<Vec<u8>>, Text> {
        Ok(self.0.get(name).map(|text| text.clone().into_bytes()))
    }
}

pub fn setting() -> Setting {
    let mut setting = Setting::new(&FANUC_LATHE_A);
    setting.tools = Some(tools());
    setting.var_file = var_file();
    setting.keep_g92 = false;
    setting.budget.repeated_blocks = 20_000;
    setting
}

/// What came of a program.
pub struct Read {
    pub motions: Vec<Motion>,
    pub controls: Vec<InForce>,
    pub faults: Vec<Refused>,
    pub remarks: Vec<Finding>,
}

pub fn read_with(program: &str, setting: Setting) -> Read {
    let mut interpreter = Interpreter::over(program.as_bytes(), setting);
    let mut read = Read { motions: Vec::new(), controls: Vec::new(), faults: Vec::new(), remarks: Vec::new() };
    while let Some(item) = interpreter.next() {
        match item {
            Ok(motion) => {
                read.motions.push(motion);
                read.controls.push(*interpreter.in_force());
            }
            Err(fault) => read.faults.push(*fault),
        }
    }
    read.remarks = interpreter.remarks();
    read
}

/// A program that is taken, without its end.
pub fn read(program: &str) -> Read {
    let read = read_with(&format!("{program}\nM30\n"), setting());
    assert!(read.faults.is_empty(), "{program}\n{:?}", read.faults);
    read
}

/// A motion as a block in diameters: the code, where it ends, the centre of an arc, the feed, the lead.
pub fn line(motion: &Motion) -> String {
    let number = |value: f64| shown(value, 4);
    let to = format!("X{} Z{}", number(2.0 * motion.to.get(Axis::X)), number(motion.to.get(Axis::Z)));
    match motion.kind {
        MotionKind::Rapid => format!("G0 {to}"),
        MotionKind::Feed(feed) => format!("G1 {to} F{}", number(feed.value)),
        MotionKind::Arc(arc, feed) => {
            let code = if arc.sweep < 0.0 { 2 } else { 3 };
            let [z, x] = arc.centre;
            format!("G{code} {to} C{},{} F{}", number(2.0 * x), number(z), number(feed.value))
        }
        MotionKind::Thread(thread) if thread.angle != 0.0 => {
            format!("G32 {to} F{} Q{}", number(thread.lead), number(thread.angle))
        }
        MotionKind::Thread(thread) if thread.change == 0.0 => format!("G32 {to} F{}", number(thread.lead)),
        MotionKind::Thread(thread) => format!("G34 {to} F{} K{}", number(thread.lead), number(thread.change)),
        MotionKind::Dwell(seconds) => format!("G4 {}", number(seconds)),
    }
}

/// Holds the motions of a program against a table; the program begins at X50 Z5 with 1000 rpm and 0.2 mm a revolution.
pub fn moves(program: &str, wanted: &[&str]) {
    let read = read(&format!("T0101 M3 S1000 F0.2\nG0 X50. Z5.\n{program}"));
    let lines: Vec<String> = read.motions.iter().skip(1).map(line).collect();
    assert_eq!(lines, wanted, "\n{program}");
}

/// The machine positions of a program, X as a diameter.
pub fn machine(program: &str) -> Vec<[f64; 2]> {
    let round = |value: f64| (value * 1e6).round() / 1e6;
    let at = |motion: &Motion| [round(2.0 * motion.machine.get(Axis::X)), round(motion.machine.get(Axis::Z))];
    read(program).motions.iter().map(at).collect()
}

/// The first refusal of a program, as `line:column message; remedy`.
pub fn refusal(program: &str) -> String {
    refusal_with(program, setting())
}

pub fn refusal_with(program: &str, setting: Setting) -> String {
    let read = read_with(program, setting);
    let Some(fault) = read.faults.first() else { panic!("taken: {program}") };
    let column = fault.columns.first().map(|column| format!(":{column}")).unwrap_or_default();
    format!("{}{column} {}; {}", fault.line, fault.message().en, fault.remedy.en)
}

/// Whether a remark holds a text.
pub fn remarked(read: &Read, text: &str) -> bool {
    read.remarks.iter().any(|remark| remark.what.en.contains(text))
}
