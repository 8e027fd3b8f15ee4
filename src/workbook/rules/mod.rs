//! Findings about a workbook and of any other file that is read: one row each.
//!
//! W01 the file, W02 its package and parts, W03 cells as they are written, W04 values, W05 sheets and symbols (W0540 on: values too), W06 lists, W07 work
//! offsets.

pub mod cell;
pub mod file;
pub mod form;
pub mod offsets;
pub mod package;
pub mod value;

/// A workbook that cells do not show: its key, and what it is.
macro_rules! made {
    ($key:literal, $es:literal, $en:literal) => {
        $crate::finding::Example::Made { key: $key, how: $crate::text::t($es, $en) }
    };
}

pub(crate) use crate::finding::rule::book;
pub(crate) use made;
