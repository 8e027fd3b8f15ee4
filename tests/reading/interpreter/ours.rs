//! rodete's interpreter as the tests call it: LinuxCNC's dialect, the inch as the machine's unit.

use std::fmt;

use rodete::gcode::control::LINUXCNC;
use rodete::gcode::interpreter::{Interpreter, Setting, ToolOffset, Tools};
use rodete::gcode::motion::Motion;
use rodete::gcode::turning::nose::{Nose, Tip};
use rodete::machine::axis::Axis;
use rodete::machine::length_unit::LengthUnit;
use rodete::machine::var_file::VarFile;

use super::common::rs274::Judge;

/// Where and why a program is refused.
#[derive(Clone, Debug)]
pub struct Fault {
    pub line: usize,
    pub columns: Vec<usize>,
    pub message: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}:{:?} {}", self.line, self.columns, self.message)
    }
}

pub fn setting(judge: &Judge) -> Setting {
    let mut setting = Setting::new(&LINUXCNC);
    setting.unit = LengthUnit::Inch;
    setting.block_delete = judge.block_delete;
    setting.keep_g92 = judge.keep_g92;
    // A debug build takes its time.
    setting.budget.repeated_blocks = 20_000;
    setting.tools = Some(tools(judge.tools.unwrap_or_default()));
    if let Some(var) = judge.var {
        setting.var_file = VarFile::parse(var.as_bytes()).expect("a variable file");
    }
    setting
}

/// LinuxCNC's tool table: `T1 P1 Z1.5 D0.25 ; remark`, in inches.
fn tools(table: &str) -> Tools {
    let mut tools = Tools::new();
    for line in table.lines() {
        let mut number = 0;
        let mut tool = ToolOffset::default();
        for word in line.split(';').next().unwrap_or_default().split_whitespace() {
            let (letter, value) = word.split_at(1);
            match letter {
                "T" => number = value.parse().unwrap(),
                "P" => {}
                "Q" => tool.nose = Tip::of_linuxcnc(value.parse().unwrap()).map(|tip| Nose { radius: 0.0, tip }),
                "D" => tool.diameter = LengthUnit::Inch.to_mm(value.parse().unwrap()),
                letter => {
                    let axis = Axis::ALL.into_iter().find(|axis| letter.starts_with(axis.letter())).unwrap();
                    let value = value.parse().unwrap();
                    tool.offset.set(axis, if axis.rotary() { value } else { LengthUnit::Inch.to_mm(value) });
                }
            }
        }
        tools.insert(number, tool);
    }
    tools
}

/// The motions and the variable file up to the end or to the first fault.
pub fn until_fault(program: &[u8], judge: &Judge) -> (Vec<Motion>, VarFile, Option<Fault>) {
    let mut interpreter = Interpreter::over(program, setting(judge));
    let mut motions = Vec::new();
    let mut fault = None;
    for item in interpreter.by_ref() {
        match item {
            Ok(motion) => motions.push(motion),
            Err(refused) => {
                let message = format!("{}; {}", refused.what.en, refused.remedy.en);
                fault = Some(Fault { line: refused.line, columns: refused.columns, message });
                break;
            }
        }
    }
    (motions, interpreter.var_file(), fault)
}

/// The motions and the variable file left behind.
pub fn run(program: &[u8], judge: &Judge) -> Result<(Vec<Motion>, VarFile), Fault> {
    match until_fault(program, judge) {
        (motions, var, None) => Ok((motions, var)),
        (_, _, Some(fault)) => Err(fault),
    }
}
