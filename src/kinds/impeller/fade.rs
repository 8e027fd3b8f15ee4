//! How the offset of a splitter's paths fades out towards the hub.
//!
//! # References
//! The thesis, section 4.3 and annex 10. The text says that the offset grows linearly; the table is the fifth power.

use crate::parameter::field::choices;

choices! {
    /// Which point m each side fades up to.
    pub enum Fade {
        /// One m for both sides, from the crossing on one of them, as published.
        Published = "published" ("publicado", "published"),
        /// Each side its own, from where its tool has room.
        EachSide = "each-side" ("cada lado", "each-side"),
    }
}

/// f_j = ((j+1)/(m+1))⁵ up to the point m, 1 after it.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
pub fn fraction(j: usize, m: usize) -> f64 {
    if j >= m {
        return 1.0;
    }
    let x = (j + 1) as f64 / (m + 1) as f64;
    x * x * x * x * x
}
