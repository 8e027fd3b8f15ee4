//! What is wrong with what is in force: feed, spindle, tool, modes.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::Text;

rules! {
    /// The rows of this file.
    RULES;

}
