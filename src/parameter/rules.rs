//! What is found of the values of a form as a whole.

use crate::finding::rule::rules;
use crate::finding::{Example, Key};
use crate::text::t;

/// The values of a form as nothing but a test hands them over: the reading of a workbook tells it before, with the cell.
const fn handed_over(key: &'static str) -> Example {
    Example::Made {
        key,
        how: t(
            "valores que no vienen de un libro: la lectura del libro lo avisa antes, con la celda",
            "values that come from no workbook: the workbook reader reports it first, with the cell",
        ),
    }
}

rules! {
    /// The rows of forms.
    RULES;
    "P0001" Missing Stop { symbol: Key }
        es "falta el valor obligatorio {symbol}"
        en "the required value {symbol} is missing"
        remedy "rellene su celda", "fill in its cell";
        why "Sin ese valor no se puede calcular el diseño.", "Without this value the design cannot be computed.";
        example handed_over("given-missing");
    "P0002" Mistyped Stop { symbol: Key }
        es "{symbol} tiene un valor que el formulario no admite"
        en "{symbol} has a value that the form does not accept"
        remedy "corrija su celda", "correct its cell";
        why "Un número en lugar de una palabra, o al revés, no se puede interpretar.", "A number in place of a word, or a word in place of a number, cannot be used.";
        example handed_over("given-mistyped");
}
