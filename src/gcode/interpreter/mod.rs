//! The interpreter: reads a program as the control would and says what the machine does.
//!
//! Text → words → blocks → modal state → canonical motions, one after another with flat memory: only the block in hand, the
//! motions it makes and, where a program loops or calls, the places of its O-words are kept.
//!
//! # Who holds what
//! A reader has a block in hand and obeys it on a state: what blocks have left in force, and where the program stands. The memory is
//! all else, and there is one of it. A place in a text is a value; whoever reads ahead, as a contour is read, or makes motions of
//! another block, as at a corner that was held back, does so as a reader of its own, and nothing is saved and put back.
//!
//! # Units
//! Motions are in millimetres, degrees and seconds, whatever the program's unit.
//!
//! # Refusals
//! A block that the control does not know, or that says two things at once, is a [`Refused`] with its line and columns; the
//! iterator goes on with the next block unless nothing can be read after it. A word is never passed over in silence.
//!
//! # References
//! LinuxCNC: G-code overview, G-code and M-code reference, O-codes, coordinate systems. Where rodete is stricter it says so in
//! the test corpus, file by file.
//!
//! ```
//! use rodete::gcode::control::LINUXCNC;
//! use rodete::gcode::interpreter::{Interpreter, Setting};
//! use rodete::machine::axis::Axis;
//!
//! let program = b"G21 G90 G54\nG10 L2 P1 X10\nG0 X5\nM2\n";
//! let motions: Vec<_> = Interpreter::over(program, Setting::new(&LINUXCNC)).collect::<Result<_, _>>().unwrap();
//! assert_eq!(motions.len(), 1);
//! assert_eq!((motions[0].to.get(Axis::X), motions[0].machine.get(Axis::X)), (5.0, 15.0));
//! ```

mod arc;
mod block;
mod codes;
mod compensation;
mod context;
mod contour;
mod corner;
mod cursor;
mod cutting;
mod cycle;
mod doubt;
mod execute;
mod expression;
mod flow;
mod foreign;
mod from_start;
mod inputs;
mod lathe;
mod length;
mod letter_cycle;
mod library;
mod line;
mod milling;
mod modal;
mod numbers;
mod offsets;
mod out;
mod parameters;
mod passed;
mod point;
mod polar;
mod read;
mod refused;
mod remarks;
mod rollover;
mod round;
mod run;
mod seen;
mod setting;
mod source;
mod standstill;
mod structure;
mod subprogram;
mod system_parameters;
mod tape;
mod tool;
pub mod tool_table;
mod turned;
mod turning;
mod turret;
mod units;
mod unreached;

pub use self::arc::radii_tolerance;
use self::block::Block;
pub use self::contour::TurnedContour;
use self::cursor::Cursor;
pub use self::cursor::bare;
use self::doubt::Doubts;
use self::flow::Flow;
pub use self::from_start::FromStart;
use self::library::{Library, Spot};
use self::modal::Modal;
use self::out::Out;
use self::parameters::Parameters;
pub use self::refused::Refused;
use self::refused::Result;
use self::remarks::Remarks;
use self::seen::Seen;
pub use self::setting::{Budget, Files, HolePlane, NoFiles, Setting, Start, ToolOffset, Tools};
pub use self::source::{Bytes, decoded, line_feeds, wide};
pub use self::standstill::Standstill;
use self::structure::Structure;
use crate::finding::{Finding, Place, Raise};
use crate::gcode::control::Control;
pub use crate::gcode::control::{DecimalPoint, RotaryMode};
use crate::gcode::in_force::InForce;
use crate::gcode::motion::Motion;
use crate::gcode::rules::flow::{
    BlockNumberInvalid, ByteOrderMark, ByteOrderMarkRejected, EndlessProgram, EndsInSubprogram, NoEnd, NoEndOrPercent,
    NoProgram, SubprogramsAlone,
};
use crate::gcode::rules::lexis::{MoreRefusals, Utf16};
use crate::gcode::turning::rules::FirstBlockUnused;
use crate::machine::axis::Pose;
use crate::machine::var_file::{VarFile, required};
use crate::machine::work_offset::{ACTIVE, ActiveOffsets, G92_FIRST, G92_SWITCH, Offsets};

/// How far the reading has come.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Stage {
    /// No block has been read.
    #[default]
    Opening,
    /// Blocks are being read.
    Running,
    /// The program has ended.
    Ended,
}

/// What is kept of a program beside what its blocks put into force: its texts, parameters and tools, where it is in its
/// flow, what it has made. There is one of it, whichever block is read on whichever state.
struct Memory<'a> {
    control: &'static Control,
    setting: Setting,
    library: Library<'a>,
    parameters: Parameters,
    tools: Tools,
    out: Out,
    flow: Flow,
    doubts: Doubts,
    remarks: Remarks,
    seen: Seen,
}

/// What the blocks so far have left in force, and where the program stands. Small: a contour is read on a clone of it.
#[derive(Clone, Debug)]
struct State {
    modal: Modal,
    frame: ActiveOffsets,
    at: Pose,
}

/// A block in hand, obeyed on a state.
struct Reader<'r, 'a> {
    memory: &'r mut Memory<'a>,
    block: &'r mut Block,
    state: &'r mut State,
}

/// A program being read; an iterator over its canonical motions.
pub struct Interpreter<'a> {
    memory: Memory<'a>,
    /// The line in hand, and its block.
    line: Vec<u8>,
    block: Block,
    state: State,
    /// What was in force when the motion last handed out was made.
    in_force: InForce,
}

impl<'a> Interpreter<'a> {
    /// Reads a program in memory.
    #[must_use]
    pub fn over(program: &'a [u8], setting: Setting) -> Self {
        Self::new(Box::new(std::io::Cursor::new(program)), setting)
    }

    /// Reads a program from bytes that can be read again, as loops and subprograms want.
    #[must_use]
    pub fn new(bytes: Box<dyn Bytes + 'a>, setting: Setting) -> Self {
        let control = setting.control;
        let (mut offsets, found) = Offsets::read(&setting.var_file, setting.unit);
        let mut remarks = Remarks::default();
        // A control without var file starts in its first system.
        for finding in found.into_iter().filter(|_| !setting.var_file.is_empty()) {
            remarks.found(finding);
        }
        let mut parameters = Parameters::new();
        for number in required() {
            parameters.set(number as usize, 0.0);
        }
        for (number, value) in setting.var_file.iter() {
            parameters.set(number as usize, value);
        }
        // What the last subprogram returned; 0 before any has.
        for name in flow::VALUES {
            parameters.set_named(name.to_owned(), 0.0);
        }
        parameters.set(ACTIVE as usize, f64::from(offsets.active.number()));
        if !setting.keep_g92 {
            (offsets.g92, offsets.g92_on) = (Pose::default(), false);
            for number in G92_SWITCH..G92_FIRST + 9 {
                parameters.set(number as usize, 0.0);
            }
        }
        let tools = setting.tools.clone().unwrap_or_default();
        let frame = offsets.frame(tools.get(&setting.start.offset).map_or_else(Pose::default, |tool| tool.offset));
        #[expect(clippy::cast_possible_truncation, reason = "1 to 9")]
        let system = offsets.active.number() as u8;
        let modal = Modal {
            tool: setting.start.tool,
            offset: setting.start.offset,
            ..Modal::new(control, setting.unit, system)
        };
        let memory = Memory {
            control,
            library: Library::new(bytes, control.lexis.lone_return),
            parameters,
            tools,
            out: Out::new(control.radius),
            flow: Flow::default(),
            doubts: Doubts::default(),
            remarks,
            seen: Seen::default(),
            setting,
        };
        let at = frame.to_program(&memory.setting.start.machine);
        let (block, in_force) = (Block::at(Spot::default()), InForce::default());
        Self { memory, line: Vec::new(), block, state: State { modal, frame, at }, in_force }
    }

    /// What is worth saying about the program as far as it has been read.
    #[must_use]
    pub fn remarks(&self) -> Vec<Finding> {
        let Memory { doubts, remarks, library, .. } = &self.memory;
        doubts.left_out().into_iter().chain(remarks.findings(library)).collect()
    }

    /// What was in force when the motion last handed out was made.
    #[must_use]
    pub const fn in_force(&self) -> &InForce {
        &self.in_force
    }

    /// The name of a subprogram's own file by its number in [`InForce::file`]; `None` for the program itself.
    #[must_use]
    pub fn file(&self, number: usize) -> Option<&str> {
        self.memory.library.file(number).map(String::as_str)
    }

    /// The position reached, in program and machine coordinates.
    #[must_use]
    pub fn position(&self) -> (Pose, Pose) {
        let tip = self.memory.out.tip(self.memory.control.radius, &self.state);
        (tip, self.state.frame.to_machine(&tip))
    }

    /// How many lines there are as far as the program, and each file of a subprogram, has been read: up to the last line that it came to,
    /// however often it did.
    #[must_use]
    pub fn lines(&self) -> usize {
        self.memory.library.lines()
    }

    /// The var file as the control would leave it: the parameters that were in it, and those that LinuxCNC keeps.
    #[must_use]
    pub fn var_file(&self) -> VarFile {
        let mut file = self.memory.setting.var_file.clone();
        file.complete();
        let numbers: Vec<u32> = file.iter().map(|(number, _)| number).collect();
        for number in numbers {
            // A value that no var file carries stays as it was.
            let _ = file.set(number, self.memory.parameters.get(number as usize));
        }
        file
    }
}

impl Reader<'_, '_> {
    /// Reads and executes one line.
    fn step(&mut self, line: &mut Vec<u8>) -> Result<()> {
        let result = self.next_line(line);
        if result.is_err() {
            self.leave_corner();
        }
        self.executed();
        result.map_err(|mut fault| {
            let Spot { text, line, .. } = self.block.spot;
            if fault.line == 0 {
                fault.line = line.max(1);
            }
            fault.file = fault.file.or_else(|| self.memory.library.file(text).cloned());
            if fault.fatal {
                self.memory.flow.stage = Stage::Ended;
            }
            if self.memory.flow.stage == Stage::Ended {
                self.end_spindle(false);
            }
            fault
        })
    }

    fn next_line(&mut self, line: &mut Vec<u8>) -> Result<()> {
        if self.memory.control.lexis.percent.leader() && self.block.spot.line == 0 {
            self.pass_leader()?;
        }
        let Some(behind) = self.memory.library.line(self.memory.flow.next, line)? else {
            return self.end_of_file();
        };
        self.memory.flow.next = behind;
        self.count_line(behind)?;
        let first = self.block.spot.line == 1;
        if first && wide(line) {
            return Err(Refused::of(&Utf16 {}, &[]).fatal());
        }
        if first && line.starts_with(b"\xEF\xBB\xBF") {
            line.drain(..3);
            if self.memory.control.lexis.mark.rejected() {
                return Err(Refused::of(&ByteOrderMarkRejected {}, &[]).fatal());
            }
            self.memory.remarks.row(&ByteOrderMark {}, self.block.spot, None);
        }
        self.execute_line(line)
    }

    fn end_of_file(&mut self) -> Result<()> {
        let (stage, percent) = (self.memory.flow.stage, self.memory.flow.percent);
        self.memory.flow.stage = Stage::Ended;
        self.lose_corner(false);
        if self.memory.flow.next.text != 0 || !self.memory.flow.frames.is_empty() {
            return Err(Refused::of(&EndsInSubprogram {}, &[]));
        }
        if stage == Stage::Opening {
            return Err(Refused::of(&NoProgram {}, &[]));
        }
        if self.memory.setting.part {
            return Ok(());
        }
        if self.memory.control.lexis.percent.leader() {
            self.remark_no_end();
            return self.end();
        }
        self.block.spot.line = self.memory.flow.next.line.lines;
        let subprograms = self.memory.library.known_structure().is_some_and(Structure::has_subprograms);
        if subprograms && self.made() == 0 {
            return Err(Refused::of(&SubprogramsAlone {}, &[]));
        }
        self.end_spindle(true);
        Err(without_end(percent && !self.memory.control.lexis.percent.named()))
    }

    /// The program has come to its end: the first work offset is in force again, and what G92 leaves is remarked.
    fn end(&mut self) -> Result<()> {
        self.memory.flow.stage = Stage::Ended;
        self.lose_corner(false);
        for (cycle, spot) in std::mem::take(&mut self.memory.seen.first_blocks) {
            self.memory.remarks.row(&FirstBlockUnused { cycle: cycle.number() }, spot, None);
        }
        if self.memory.control.radius.cutter() {
            self.end_cutter();
        }
        self.end_spindle(true);
        self.end_length();
        self.end_of_program();
        Ok(())
    }

    fn endless(&self) -> Box<Refused> {
        let most = self.memory.setting.budget.repeated_blocks;
        Refused::ended(&EndlessProgram { most })
    }

    /// The switch and the registers of G92.
    fn g92_registers(&self) -> (bool, Pose) {
        let on = self.memory.parameters.get(G92_SWITCH as usize) != 0.0;
        (on, self.pose_of(G92_FIRST))
    }
}

/// The refusal of a program without the code that ends it; `percent` where a `%` opens it that could end it too.
fn without_end(percent: bool) -> Box<Refused> {
    if percent { Refused::of(&NoEndOrPercent {}, &[]) } else { Refused::of(&NoEnd {}, &[]) }
}

/// Passes over the fraction of a block number, which LinuxCNC takes: `N56.78`.
fn pass_fraction(cursor: &mut Cursor<'_>) {
    if cursor.accept(b'.') {
        while cursor.peek().is_ascii_digit() {
            cursor.pass();
        }
    }
}

/// A block number behind its N.
fn block_number(cursor: &mut Cursor<'_>) -> Result<u32> {
    let (mut number, mut digits) = (0_u32, 0);
    let column = cursor.column();
    loop {
        let commented = cursor.no_comment();
        let digit @ b'0'..=b'9' = cursor.peek() else { break };
        commented?;
        cursor.pass();
        digits += 1;
        number = number.saturating_mul(10).saturating_add(u32::from(digit - b'0'));
    }
    if digits == 0 || digits > 9 {
        return Err(Refused::of(&BlockNumberInvalid {}, &[column]));
    }
    Ok(number)
}

impl Iterator for Interpreter<'_> {
    type Item = Result<Motion>;

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            match self.memory.out.queue.pop_front() {
                Some(Ok((motion, control, number))) => {
                    self.in_force = control;
                    self.memory.out.standing.handed_out(Some((&motion, number)));
                    return Some(Ok(motion));
                }
                Some(Err(fault)) => return Some(Err(fault)),
                None => {}
            }
            let Self { memory, line, block, state, .. } = self;
            let mut reader = Reader { memory, block, state };
            let result = if reader.memory.out.run.is_some() {
                let made = reader.made();
                let result = reader.go_on();
                reader.cycle_went_on(made);
                result
            } else if reader.memory.flow.stage == Stage::Ended {
                reader.flush();
                if reader.memory.out.queue.is_empty() {
                    reader.memory.out.standing.handed_out(None);
                    return None;
                }
                continue;
            } else {
                reader.step(line)
            };
            let Err(fault) = result else { continue };
            let fault = reader.or_foreign(fault);
            let lost = reader.loses_cycle(line);
            reader.memory.seen.uncut |= lost || fault.uncut;
            if let Some(mut fault) = reader.told_once(fault, line) {
                fault.uncut |= lost;
                // Behind the refusals that its block has handed out already.
                let queue = &mut reader.memory.out.queue;
                if !queue.iter().any(Result::is_err) {
                    return Some(Err(fault));
                }
                queue.push_back(Err(fault));
            }
        }
    }
}

/// The findings of a program that is read to its end: refusals first (at most `most`, then a count), then remarks.
#[must_use]
pub fn findings(faults: Vec<Refused>, total: usize, remarks: Vec<Finding>) -> Vec<Finding> {
    let shown = faults.len();
    let mut findings: Vec<Finding> = faults.into_iter().map(Finding::from).collect();
    if total > shown {
        findings.push(MoreRefusals { count: total - shown }.at(Place::File));
    }
    findings.extend(remarks);
    findings
}
