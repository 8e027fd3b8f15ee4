//! What is told of the programs of every kind of workbook: one row for each finding.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::{Text, t};

rules! {
    /// The rows of every kind.
    RULES;

    "C1001" PositionOutOfFormat Stop { position: f64, parameters: Text }
        es "la posición {position} no cabe en un programa (cinco cifras y tres decimales)"
        en "position {position} does not fit into a program (five digits and three decimals)"
        remedy "compruebe {parameters}", "check {parameters}";
        why "El control lee cinco cifras delante del punto: lo demás se perdería.",
            "The control reads five digits before the point: the rest would be lost.";
        example Example::Never(t(
            "los límites de las celdas no dejan llegar a tales posiciones", "the limits of the cells do not let positions come so far"));
}
