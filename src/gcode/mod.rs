//! ISO programs: words, comments, controls, and the program with its text.
//!
//! A [`program::Program`] holds positions on the output grid, not text; its text is made line by line wherever it is
//! needed (file, sheet, report), so that a program of a million blocks costs no more memory than its points.

pub mod chosen;
pub mod code;
pub mod comment;
pub mod control;
pub mod cutter;
mod digits;
pub mod feed_law;
pub mod feed_word;
pub mod fields;
pub mod header;
pub mod in_force;
pub mod interpreter;
pub mod letters;
pub mod lines;
pub mod machine_codes;
mod meaning;
pub mod motion;
pub mod offset_preamble;
pub mod program;
mod read_back;
pub mod rules;
pub mod summary;
pub mod turning;
pub mod word;
pub mod writer;
