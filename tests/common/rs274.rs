//! LinuxCNC's own interpreter, `rs274` of the Debian package linuxcnc-uspace, as an independent judge of programs. A
//! black box: private HOME, fresh variable file, a deadline.
//!
//! Its machine unit is the inch (variable file and tool table), the program's first unit the millimetre. It prints
//! program coordinates with four decimals in the active unit; [`Canon`] has them in mm, and in machine coordinates:
//! machine = Rz(rotation)·(program + G92) + work offset + tool offset.

use std::io::Write;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use rodete::gcode::motion::Plane;
use rodete::number::trig::sin_cos;

/// X, Y, Z in mm and A, B, C in degrees.
pub type Six = [f64; 6];

/// Half of the last decimal that is printed, in the unit it is printed in.
pub const HALF: f64 = 0.000_05;
const INCH: f64 = 25.4;

/// How F is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FeedMode {
    PerMinute,
    PerRevolution,
    /// The rate is what the move's length and F come to: units per minute.
    InverseTime,
}

/// A feed: the rate as it is printed, in the active unit.
#[derive(Clone, Copy, Debug)]
pub struct Feed {
    pub mode: FeedMode,
    pub rate: f64,
}

#[derive(Clone, Copy, Debug)]
pub enum Kind {
    Rapid,
    Feed(Feed),
    /// Centre in program coordinates along the plane's first and second axis, mm.
    Arc {
        plane: Plane,
        centre: [f64; 2],
        turns: i32,
        feed: Feed,
    },
    Dwell(f64),
}

/// A canonical motion.
#[derive(Clone, Copy, Debug)]
pub struct Motion {
    /// The N word at the start of the block.
    pub n: Option<u32>,
    pub kind: Kind,
    /// Where it starts, in the program coordinates of `program`.
    pub from: Six,
    /// Where it ends in program coordinates.
    pub program: Six,
    /// Where it ends in machine coordinates.
    pub machine: Six,
    /// The active unit in mm.
    pub unit: f64,
    /// By how much rounding can have moved the machine coordinates, and `from`.
    pub doubt: f64,
    /// The program has stopped since the last motion, and the operator may have moved the axes (G88): `from` is where they
    /// were before.
    pub by_hand: bool,
}

/// What rs274 made of a program.
#[derive(Clone, Debug)]
pub struct Canon {
    pub motions: Vec<Motion>,
    /// The calls that are no motions and change no coordinates: name and arguments.
    pub calls: Vec<(String, String)>,
    /// All of them, line by line as rs274 prints them.
    pub text: String,
    /// The variable file as it was left, in inches.
    pub var: String,
}

/// Why there is no [`Canon`].
#[derive(Clone, Debug)]
pub enum Refused {
    /// The message, and what was done before it.
    Error(String, Box<Canon>),
    /// It did not come to an end in time.
    Deadline,
}

/// How rs274 is started.
#[derive(Clone, Copy, Debug)]
pub struct Judge<'a> {
    /// The variable file.
    pub var: Option<&'a str>,
    /// The tool table.
    pub tools: Option<&'a str>,
    /// Whether blocks that begin with `/` are skipped.
    pub block_delete: bool,
    /// Whether G92 outlives a program: not where the INI file has DISABLE_G92_PERSISTENCE = 1.
    pub keep_g92: bool,
    pub deadline: Duration,
}

impl Default for Judge<'_> {
    fn default() -> Self {
        Self { var: None, tools: None, block_delete: false, keep_g92: true, deadline: Duration::from_secs(30) }
    }
}

/// True where rs274 is installed. Where it is not, says so loudly; in CI that is a failure.
pub fn is_here() -> bool {
    let here = Command::new("rs274").arg("-h").stdin(Stdio::null()).output().is_ok();
    if !here {
        // Not through the macros, whose output a passing test keeps to itself.
        let _ = writeln!(
            std::io::stderr(),
            "\n*** rs274 is not installed: programs are NOT JUDGED by LinuxCNC. Install linuxcnc-uspace. ***\n"
        );
        assert!(std::env::var_os("CI").is_none(), "rs274 is missing in CI");
    }
    here
}

/// What rs274 makes of a program, with a variable file and a tool table.
pub fn run(program: &[u8], var: Option<&str>, tools: Option<&str>) -> Result<Canon, Refused> {
    Judge { var, tools, ..Judge::default() }.run(program)
}

impl Judge<'_> {
    pub fn run(&self, program: &[u8]) -> Result<Canon, Refused> {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        std::fs::write(path("p.ngc"), program).unwrap();
        std::fs::write(path("t.tbl"), self.tools.unwrap_or_default()).unwrap();
        if let Some(var) = self.var {
            std::fs::write(path("v.var"), var).unwrap();
        }
        let mut command = Command::new("rs274");
        command.args(["-g", "-t"]).arg(path("t.tbl")).arg("-v").arg(path("v.var"));
        if self.block_delete {
            command.arg("-b");
        }
        if !self.keep_g92 {
            std::fs::write(path("g92.ini"), "[RS274NGC]\nDISABLE_G92_PERSISTENCE = 1\n").unwrap();
            command.arg("-i").arg(path("g92.ini"));
        }
        let child = command
            .arg(path("p.ngc"))
            .arg(path("out"))
            .env("HOME", folder.path())
            .current_dir(folder.path())
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(std::fs::File::create(path("err")).unwrap())
            .spawn()
            .unwrap();
        let well = self.ends_well(child)?;
        let mut reading = Reading::default();
        let text = lossy(&path("out"));
        for line in text.lines() {
            reading.line(line);
        }
        let canon = Canon { motions: reading.motions, calls: reading.calls, text, var: lossy(&path("v.var")) };
        if well { Ok(canon) } else { Err(Refused::Error(lossy(&path("err")), Box::new(canon))) }
    }

    /// Whether it ends with success before the deadline.
    fn ends_well(&self, mut child: Child) -> Result<bool, Refused> {
        let start = Instant::now();
        loop {
            if let Some(status) = child.try_wait().unwrap() {
                return Ok(status.success());
            }
            if start.elapsed() > self.deadline {
                child.kill().unwrap();
                child.wait().unwrap();
                return Err(Refused::Deadline);
            }
            std::thread::sleep(Duration::from_millis(2));
        }
    }
}

fn lossy(path: &Path) -> String {
    String::from_utf8_lossy(&std::fs::read(path).unwrap_or_default()).into_owned()
}

/// An offset in mm and degrees, with the unit that its last printed decimal counts in.
#[derive(Clone, Copy, Debug, Default)]
struct Offset {
    by: Six,
    unit: f64,
}

/// The state that the calls leave.
#[derive(Debug)]
struct Reading {
    unit: f64,
    work: Offset,
    g92: Offset,
    tool: Offset,
    rotation: f64,
    plane: Plane,
    mode: FeedMode,
    rate: f64,
    machine: Six,
    /// The doubt of `machine`.
    doubt: f64,
    stopped: bool,
    motions: Vec<Motion>,
    calls: Vec<(String, String)>,
}

impl Default for Reading {
    fn default() -> Self {
        Self {
            unit: 1.0,
            work: Offset::default(),
            g92: Offset::default(),
            tool: Offset::default(),
            rotation: 0.0,
            plane: Plane::XY,
            mode: FeedMode::PerMinute,
            rate: 0.0,
            machine: [0.0; 6],
            doubt: 0.0,
            stopped: false,
            motions: Vec::new(),
            calls: Vec::new(),
        }
    }
}

impl Reading {
    /// Takes in one line: a counter, the N word, a call.
    fn line(&mut self, line: &str) {
        let Some((head, arguments)) = line.split_once('(') else { return };
        let arguments = arguments.trim_end().trim_end_matches(')');
        // The name follows an N word of more than five digits without a blank.
        let Some((_, head)) = head.split_once(" N") else { return };
        let end = head.find(|digit: char| !digit.is_ascii_digit() && digit != '.').unwrap_or(head.len());
        let (n, name) = (head[..end].parse().ok(), head[end..].trim());
        let numbers: Vec<f64> =
            arguments.split([',', ' ']).filter(|number| !number.is_empty()).filter_map(|n| n.parse().ok()).collect();
        match (name, numbers.as_slice()) {
            ("USE_LENGTH_UNITS", _) => self.unit = if arguments.ends_with("INCHES") { INCH } else { 1.0 },
            ("SELECT_PLANE", _) => {
                self.plane = match arguments {
                    "CANON_PLANE_XY" => Plane::XY,
                    "CANON_PLANE_XZ" => Plane::ZX,
                    "CANON_PLANE_YZ" => Plane::YZ,
                    other => panic!("plane {other}"),
                };
            }
            ("SET_G5X_OFFSET", [_, by @ ..]) => self.work = self.offset(by),
            ("SET_G92_OFFSET", by) => self.g92 = self.offset(by),
            ("USE_TOOL_LENGTH_OFFSET", [by @ .., _, _, _]) => self.tool = self.offset(by),
            ("SET_XY_ROTATION", &[degrees]) => self.rotation = degrees,
            // The mode of G93 and G94 is the same number; only the comment tells them apart.
            ("COMMENT", _) if arguments.contains("feed mode set to inverse time") => self.mode = FeedMode::InverseTime,
            ("COMMENT", _) if arguments.contains("feed mode set to units per minute") => {
                self.mode = FeedMode::PerMinute;
            }
            ("COMMENT", _) if arguments.contains("feed mode set to units per revolution") => {
                self.mode = FeedMode::PerRevolution;
            }
            ("SET_FEED_MODE", _) => {}
            ("SET_FEED_RATE", &[rate]) => self.rate = rate,
            ("DWELL", &[seconds]) => self.motion(n, Kind::Dwell(seconds), None),
            ("STRAIGHT_TRAVERSE", by) => self.motion(n, Kind::Rapid, Some(self.offset(by).by)),
            ("STRAIGHT_FEED", by) => self.motion(n, Kind::Feed(self.feed()), Some(self.offset(by).by)),
            ("ARC_FEED", &[first, second, c1, c2, turns, across, a, b, c]) => {
                let mut to = [0.0, 0.0, 0.0, a, b, c];
                for (axis, end) in self.plane.axes().into_iter().zip([first, second, across]) {
                    to[axis as usize] = end * self.unit;
                }
                #[expect(clippy::cast_possible_truncation, reason = "printed as a whole number")]
                let turns = turns as i32;
                let centre = [c1 * self.unit, c2 * self.unit];
                self.motion(n, Kind::Arc { plane: self.plane, centre, turns, feed: self.feed() }, Some(to));
            }
            ("PROGRAM_STOP", _) => self.stopped = true,
            _ => self.calls.push((name.to_owned(), arguments.to_owned())),
        }
    }

    fn offset(&self, by: &[f64]) -> Offset {
        let by: Six = by.try_into().expect("six numbers");
        let unit = self.unit;
        Offset { by: std::array::from_fn(|axis| if axis < 3 { by[axis] * unit } else { by[axis] }), unit }
    }

    fn feed(&self) -> Feed {
        Feed { mode: self.mode, rate: self.rate }
    }

    fn motion(&mut self, n: Option<u32>, kind: Kind, to: Option<Six>) {
        let offsets = HALF * 1.5 * (self.work.unit + self.g92.unit + self.tool.unit);
        let from = self.program(self.machine);
        let doubt = self.doubt + offsets;
        let program = to.unwrap_or(from);
        if to.is_some() {
            self.machine = self.machine(program);
            let far = program.iter().zip(self.g92.by).map(|(p, o)| (p + o).abs()).fold(0.0, f64::max);
            // The angle too has four decimals.
            let turned = if self.rotation == 0.0 { 0.0 } else { 2.0 * far * HALF.to_radians() };
            self.doubt = offsets + HALF * 1.5 * self.unit.max(1.0) + turned;
        }
        let doubt = doubt.max(self.doubt);
        let by_hand = self.stopped;
        self.stopped &= to.is_none();
        self.motions.push(Motion { n, kind, from, program, machine: self.machine, unit: self.unit, doubt, by_hand });
    }

    fn machine(&self, program: Six) -> Six {
        let [x, y] = turned(program[0] + self.g92.by[0], program[1] + self.g92.by[1], self.rotation);
        std::array::from_fn(|axis| {
            let local = match axis {
                0 => x,
                1 => y,
                _ => program[axis] + self.g92.by[axis],
            };
            local + self.work.by[axis] + self.tool.by[axis]
        })
    }

    fn program(&self, machine: Six) -> Six {
        let local: Six = std::array::from_fn(|axis| machine[axis] - self.work.by[axis] - self.tool.by[axis]);
        let [x, y] = turned(local[0], local[1], -self.rotation);
        std::array::from_fn(|axis| {
            let local = match axis {
                0 => x,
                1 => y,
                _ => local[axis],
            };
            local - self.g92.by[axis]
        })
    }
}

fn turned(x: f64, y: f64, degrees: f64) -> [f64; 2] {
    let (sin, cos) = sin_cos(degrees.to_radians());
    [x * cos - y * sin, x * sin + y * cos]
}
