//! What is wrong with arcs, planes, axes and work offsets.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::Text;

rules! {
    /// The rows of this file.
    RULES;

}
