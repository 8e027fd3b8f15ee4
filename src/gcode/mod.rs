//! ISO programs: words, blocks, dialects, and the writer.

pub mod program;
