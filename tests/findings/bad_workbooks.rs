//! The corpus of workbooks that must be refused, each with the exit code, the place, the message and the remedy
//! expected, and of odd ones that must be read. The rows carry the names of the list of bad inputs.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::common;
use crate::common::workbook;

mod cells;
mod files;
mod paths;
mod random;
mod sound;
