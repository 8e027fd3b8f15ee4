//! Rows that say what a test gives them, one of each grade.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::{Text, t};

const GIVEN: Example = Example::Made { key: "given", how: t("lo que le da una prueba", "what a test gives it") };

rules! {
    /// The rows.
    RULES;
    "T9001" Stopped Stop { what: Text, todo: Text }
        es "{what}"
        en "{what}"
        remedy "{todo}", "{todo}";
        why "Una prueba lo dice.", "A test says so.";
        example GIVEN;
    "T9002" Cautioned Caution { what: Text, todo: Text }
        es "{what}"
        en "{what}"
        remedy "{todo}", "{todo}";
        why "Una prueba lo dice.", "A test says so.";
        example GIVEN;
    "T9003" Noted Note { what: Text }
        es "{what}"
        en "{what}"
        remedy "", "";
        why "Una prueba lo dice.", "A test says so.";
        example GIVEN;
}
