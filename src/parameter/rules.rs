//! What is found of the values of a form as a whole.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::t;

const READ: Example = Example::Never(t(
    "la lectura del libro lo dice antes, con la celda",
    "the reading of the workbook tells it before, with the cell",
));

rules! {
    /// The rows of forms.
    RULES;
    "P0001" Missing Stop { symbol: &'static str }
        es "falta el valor obligatorio {symbol}"
        en "the required value {symbol} is missing"
        remedy "rellene su celda", "fill in its cell";
        why "Sin él no hay diseño que calcular.", "Without it there is no design to compute.";
        example READ;
    "P0002" Mistyped Stop { symbol: &'static str }
        es "{symbol} no es un valor de los que admite el formulario"
        en "{symbol} is no value that the form admits"
        remedy "corrija su celda", "correct its cell";
        why "Un número donde va una palabra, o al revés, no dice nada.", "A number in the place of a word, or the other way about, says nothing.";
        example READ;
}
