//! What is wrong with subprograms, loops and branches, and with the end of a program.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::Text;

rules! {
    /// The rows of this file.
    RULES;

}
