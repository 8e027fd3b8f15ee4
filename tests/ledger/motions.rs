//! The programs of the tests: how each is read, and what its motions are under every control.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use rayon::prelude::*;
use rodete::gcode::control::Control;
use rodete::gcode::in_force::{Compensation, InForce, Speed, Spindle};
use rodete::gcode::interpreter::{DecimalPoint, Files, Interpreter, Setting, tool_table};
use rodete::gcode::motion::{FeedMode, Motion, MotionKind};
use rodete::machine::axis::Pose;
use rodete::machine::length_unit::LengthUnit;
use rodete::machine::var_file::VarFile;
use rodete::text::Text;

use crate::golden::Item;

/// The controls by name.
pub const CONTROLS: [&str; 5] = ["linuxcnc", "fagor-8055", "fagor-8070", "fagor-8055-t", "fanuc-lathe-a"];

/// Programs of a folder, and what they are read with.
pub struct Group {
    /// The folder by its name in the ledger.
    pub folder: &'static str,
    /// The tool table, if there is one.
    pub tools: Option<&'static str>,
    /// The parameter file of those that have none of their own.
    pub var: Option<&'static str>,
    /// The machine counts in inches.
    pub inch: bool,
    /// A dimension without a decimal point is one in millimetres or inches.
    pub calculator: bool,
    /// G92 ends with the program.
    pub forgets: bool,
}

const MILLED: Group =
    Group { folder: "", tools: Some("gcode/tools.tbl"), var: None, inch: true, calculator: false, forgets: false };
const TURNED: Group = Group {
    folder: "",
    tools: Some("ledger/noses.tbl"),
    var: Some("ledger/turret.var"),
    inch: false,
    calculator: true,
    forgets: true,
};
const PLAIN: Group = Group { tools: None, inch: false, calculator: true, ..MILLED };

/// Every program of the tests.
pub const GROUPS: [Group; 10] = [
    Group { folder: "gcode/good", ..MILLED },
    Group { folder: "gcode/bad", ..MILLED },
    Group { folder: "gcode/wider", ..MILLED },
    Group { folder: "gcode/lathe/bad", tools: Some("ledger/turret.tbl"), calculator: false, ..TURNED },
    Group { folder: "lathe/alarms", ..TURNED },
    Group { folder: "lathe/clean/fagor-8055-t", ..TURNED },
    Group { folder: "lathe/clean/fanuc-lathe-a", ..TURNED },
    Group { folder: "golden", ..PLAIN },
    Group { folder: "fuzz/corpus/program", ..PLAIN },
    Group { folder: "fuzz/corpus/simulate", ..PLAIN },
];

/// Blocks that a program may repeat here.
const REPEATED: u64 = 20_000;

/// Where the folders stand whose programs the ledger names as they once stood in `tests`.
const MOVED: [(&str, &str); 7] = [
    ("gcode/good", "controls/linuxcnc/good"),
    ("gcode/bad", "controls/linuxcnc/bad"),
    ("gcode/wider", "controls/linuxcnc/wider"),
    ("gcode/tools.tbl", "controls/linuxcnc/tools.tbl"),
    ("gcode/lathe/bad", "controls/fanuc-lathe-a/bad"),
    ("lathe/clean/fagor-8055-t", "controls/fagor-8055-t/clean"),
    ("lathe/clean/fanuc-lathe-a", "controls/fanuc-lathe-a/clean"),
];

/// What a name of the ledger stands for.
fn tests(name: &str) -> PathBuf {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let moved = MOVED.into_iter().find_map(|(was, is)| name.strip_prefix(was).map(|rest| format!("{is}{rest}")));
    tests.join(moved.as_deref().unwrap_or(name))
}

impl Group {
    /// The programs by their names, sorted.
    pub fn programs(&self) -> Vec<String> {
        let entries = fs::read_dir(tests(self.folder)).unwrap().map(|entry| entry.unwrap().path());
        let programs = entries.filter(|path| path.extension().is_some_and(|ending| ending == "ngc" || ending == "nc"));
        let name = |path: PathBuf| format!("{}/{}", self.folder, path.file_name().unwrap().to_str().unwrap());
        let mut names: Vec<_> = programs.map(name).collect();
        names.sort();
        assert!(!names.is_empty(), "{}", self.folder);
        names
    }

    /// The parameter file of a program.
    pub fn var(&self, program: &str) -> Option<String> {
        let own = Path::new(program).with_extension("var").to_str().unwrap().to_owned();
        if tests(&own).is_file() { Some(own) } else { self.var.map(str::to_owned) }
    }
}

/// Subprograms beside the program.
struct Beside(PathBuf);

impl Files for Beside {
    fn find(&mut self, name: &str) -> Result<Option<Vec<u8>>, Text> {
        let paths = [".ngc", ".nc"].map(|ending| self.0.join(format!("{name}{ending}")));
        Ok(paths.into_iter().find_map(|path| fs::read(path).ok()))
    }
}

fn setting(group: &Group, program: &str, control: &str) -> Setting {
    let read = |name: &str| fs::read(tests(name)).unwrap();
    let mut setting = Setting::new(Control::named(control).unwrap());
    setting.unit = if group.inch { LengthUnit::Inch } else { LengthUnit::Millimetre };
    setting.tools = group.tools.map(|tools| tool_table::parse(&read(tools), setting.unit).unwrap());
    setting.var_file = group.var(program).map_or_else(VarFile::default, |var| VarFile::parse(&read(&var)).unwrap());
    setting.decimal_point = group.calculator.then_some(DecimalPoint::Calculator);
    setting.keep_g92 = !group.forgets;
    setting.files = Box::new(Beside(tests(group.folder)));
    setting.budget.repeated_blocks = REPEATED;
    setting
}

/// What a program does under a control, line by line: motions with what is in force, where something is refused (what, the
/// command's documents say), where it ends, and the parameters left behind. Numbers have as many digits as tell them apart.
fn motions(group: &Group, program: &str, control: &str, skip: bool) -> String {
    let bytes = fs::read(tests(program)).unwrap();
    let mut interpreter = Interpreter::over(&bytes, Setting { block_delete: skip, ..setting(group, program, control) });
    let mut text = String::new();
    while let Some(item) = interpreter.next() {
        match item {
            Ok(motion) => {
                let control = interpreter.in_force();
                let file = interpreter.file(control.file).unwrap_or_default();
                let _ = writeln!(text, "{file}:{}; {}", line(&motion), in_force(control));
            }
            Err(fault) => {
                let _ = writeln!(text, "{}:{} refused", fault.file.unwrap_or_default(), fault.line);
            }
        }
    }
    let (program, machine) = interpreter.position();
    let _ = writeln!(text, "end {} {}\n{}", pose(&program), pose(&machine), interpreter.var_file().text());
    text
}

fn pose(Pose(axes): &Pose) -> String {
    axes.map(|axis| axis.to_string()).join(" ")
}

fn line(motion: &Motion) -> String {
    let kind = match motion.kind {
        MotionKind::Rapid => "rapid".to_owned(),
        MotionKind::Feed(feed) => format!("feed {} {}", feed.value, mode(feed.mode)),
        MotionKind::Arc(arc, feed) => format!(
            "arc {} {} {} {} {} {} {} {} {}",
            arc.plane.name(),
            arc.centre[0],
            arc.centre[1],
            arc.turns,
            arc.radius,
            arc.sweep,
            arc.rotation,
            feed.value,
            mode(feed.mode)
        ),
        MotionKind::Thread(thread) => format!("thread {} {} {}", thread.lead, thread.change, thread.angle),
        MotionKind::Dwell(seconds) => format!("dwell {seconds}"),
    };
    let number = motion.n.map_or_else(String::new, |n| format!(" N{n}"));
    let seconds = motion.seconds.map_or_else(|| "untimed".to_owned(), |seconds| format!("{seconds} s"));
    let [from, to, machine] = [&motion.from, &motion.to, &motion.machine].map(pose);
    format!("{}{number} {kind}; {from}; {to}; {machine}; {seconds}", motion.line)
}

const fn mode(mode: FeedMode) -> &'static str {
    match mode {
        FeedMode::PerMinute => "mm/min",
        FeedMode::PerRevolution => "mm/rev",
        FeedMode::InverseTime => "1/min",
        FeedMode::Seconds => "s",
    }
}

fn in_force(control: &InForce) -> String {
    let spindle = match control.spindle {
        Spindle::Stopped => "stopped",
        Spindle::Clockwise => "clockwise",
        Spindle::CounterClockwise => "counter-clockwise",
    };
    let speed = match control.speed {
        Speed::Revolutions(speed) => format!("{speed} rpm"),
        Speed::Surface(speed) => format!("{speed} m/min"),
    };
    let greatest = control.greatest_speed.map_or_else(|| "without limit".to_owned(), |most| format!("up to {most}"));
    let unit = match control.unit {
        LengthUnit::Inch => "inch",
        LengthUnit::Millimetre => "mm",
    };
    let nose = match control.compensation {
        Compensation::Off => "G40",
        Compensation::Left => "G41",
        Compensation::Right => "G42",
    };
    let (tool, offset, system) = (control.tool, control.offset, control.system);
    let (coolant, feed) = (if control.coolant { "wet" } else { "dry" }, mode(control.feed_mode));
    format!("T{tool} D{offset} {spindle} {speed} {greatest} {coolant} {system} {feed} {unit} {nose}")
}

/// The motions of every program under every control; where it has blocks with `/`, without them too.
pub fn items() -> Vec<Item> {
    let programs: Vec<_> =
        GROUPS.iter().flat_map(|group| group.programs().into_iter().map(move |program| (group, program))).collect();
    let one = |(group, program): &(&Group, String)| {
        let bytes = fs::read(tests(program)).unwrap();
        let skips = bytes.split(|byte| *byte == b'\n').any(|line| line.starts_with(b"/"));
        let item = |control: &str, skip: bool| {
            let name = format!("motions/{program}/{control}{}", if skip { "-without-skipped" } else { "" });
            Item::new(name, motions(group, program, control, skip).as_bytes())
        };
        let skipped = skips.then(|| CONTROLS.map(|control| item(control, true)));
        CONTROLS.map(|control| item(control, false)).into_iter().chain(skipped.into_iter().flatten()).collect()
    };
    programs.par_iter().flat_map_iter(|program| -> Vec<Item> { one(program) }).collect()
}
