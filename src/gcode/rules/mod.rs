//! Findings about a program as it is read, one row each, by subject.
//!
//! Codes G0001 on are of the text, G0101 on of words, G0201 on of expressions, G0301 on of the flow, G0401 on of the geometry,
//! G0501 on of what is in force, G0580 on of the cuts of a lathe; C1002 on of the codes that a workbook puts into programs.

pub mod codes;
pub mod expressions;
pub mod flow;
pub mod geometry;
pub mod lexis;
pub mod modes;
pub mod turned;
pub mod words;
