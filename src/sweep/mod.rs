//! Many designs of one workbook: which, what came of each, and which are the best.
//!
//! A [`Plan`](plan::Plan) follows from the sheet SWEEP of a workbook ([`asked`]). Design i is a function of plan and i alone, and its
//! [`Row`](row::Row) of workbook, plan and i: so rows may be worked out in any order, in any chunks and twice. They stand as columns in a
//! [`Table`](table::Table), which a Parquet [`file`](mod@file) holds. A kind is known by its trait alone.

pub mod asked;
pub mod chance;
pub mod csv;
pub mod file;
pub mod form;
pub mod front;
pub mod indices;
pub mod objective;
pub mod plan;
pub mod ranking;
pub mod results;
pub mod row;
pub mod rules;
pub mod sensitivity;
pub mod sobol;
pub mod table;
