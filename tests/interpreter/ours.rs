//! rodete's interpreter as the tests call it.

use std::collections::BTreeMap;
use std::fmt;

use rodete::gcode::motion::Motion;

use crate::common::rs274::Judge;

/// The parameters left at the end, in inches: what a variable file keeps.
pub type Var = BTreeMap<u16, f64>;

/// Where and why a program is refused.
#[derive(Clone, Debug)]
pub struct Fault {
    pub line: usize,
    pub column: usize,
    pub message: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}:{} {}", self.line, self.column, self.message)
    }
}

/// The motions up to the end or to the first fault.
pub fn motions(_program: &[u8], _judge: &Judge) -> (Vec<Motion>, Option<Fault>) {
    (vec![], None)
}

/// The motions and the parameters left behind.
pub fn run(_program: &[u8], _judge: &Judge) -> Result<(Vec<Motion>, Var), Fault> {
    Ok((vec![], Var::new()))
}
