//! Findings about a report that was made: one row each.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::t;

rules! {
    /// The rows of reports.
    RULES;

    "T0201" TooLargeToAttach Note { name: String }
        es "{name} es demasiado grande para adjuntarlo al informe, que da en su lugar su SHA-256"
        en "{name} is too large to attach to the report, which gives its SHA-256 instead"
        remedy "", "";
        why "Un PDF de decenas de megabytes es difícil de abrir y de enviar.", "A PDF of dozens of megabytes is hard to open and to send.";
        example Example::Made { key: "large-attachment", how: t(
            "un libro de más de 32 MiB", "a workbook of more than 32 MiB") };
    "T0202" CharactersByCode Note {}
        es "el informe muestra con su código los caracteres que sus tipos de letra no tienen"
        en "the report shows the codes of characters that its fonts lack"
        remedy "", "";
        why "Si no, el informe imprimiría una caja vacía.", "Otherwise the report would print an empty box.";
        example Example::Made { key: "foreign-letters", how: t(
            "una pieza llamada 中", "a part named 中") };
}
