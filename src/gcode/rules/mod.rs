//! What a program is told of where it is read, one row each, by subject.
//!
//! Codes G0001 on are of the text, G0101 on of words, G0201 on of expressions, G0301 on of the flow, G0401 on of the geometry,
//! G0501 on of what is in force.

pub mod expressions;
pub mod flow;
pub mod geometry;
pub mod lexis;
pub mod modes;
pub mod words;
