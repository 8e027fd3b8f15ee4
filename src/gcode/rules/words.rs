//! What is wrong with the words of a block.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::Text;

rules! {
    /// The rows of this file.
    RULES;

}
