//! rodete's interpreter of G-code against LinuxCNC's, `rs274`: programs by hand, programs by chance, and programs that
//! must be refused.

use crate::common;
use crate::common::agreement;

mod blank;
mod centre_words;
mod corpus;
mod doubt;
mod expressions;
mod generated;
mod generator;
mod kept;
mod limits;
mod milling;
mod ours;
mod rotary;
mod soup;
mod source;
