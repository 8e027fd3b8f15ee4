//! Rows that say what a test gives them, one of each grade.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::{Text, t};

rules! {
    /// The rows.
    RULES;
    "T9001" Stopped Stop { what: Text, todo: Text }
        es "{what}"
        en "{what}"
        remedy "{todo}", "{todo}";
        why "Una prueba lo dice.", "A test says so.";
        example Example::Never(t("", ""));
    "T9002" Cautioned Caution { what: Text, todo: Text }
        es "{what}"
        en "{what}"
        remedy "{todo}", "{todo}";
        why "Una prueba lo dice.", "A test says so.";
        example Example::Never(t("", ""));
    "T9003" Noted Note { what: Text }
        es "{what}"
        en "{what}"
        remedy "", "";
        why "Una prueba lo dice.", "A test says so.";
        example Example::Never(t("", ""));
}
