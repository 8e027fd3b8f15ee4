//! What is told of a report that was made: one row for each finding.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::t;

rules! {
    /// The rows of reports.
    RULES;

    "T0201" TooLargeToAttach Note { name: String }
        es "{name} es demasiado grande para adjuntarlo al informe; se da su SHA-256"
        en "{name} is too large to be attached to the report; its SHA-256 is given"
        remedy "", "";
        why "Un PDF de decenas de megabytes no se abre ni se envía.", "A PDF of dozens of megabytes is neither opened nor sent.";
        example Example::Made { key: "large-attachment", how: t(
            "un libro de más de 32 MiB", "a workbook of more than 32 MiB") };
    "T0202" CharactersByCode Note {}
        es "el informe muestra por su código los caracteres que sus tipos de letra no tienen"
        en "the report shows by their code the characters that its fonts do not have"
        remedy "", "";
        why "Sin el dibujo de una letra se imprimiría una caja vacía.", "Without a letter's drawing an empty box would be printed.";
        example Example::Made { key: "foreign-letters", how: t(
            "una pieza llamada 中", "a part named 中") };
}
