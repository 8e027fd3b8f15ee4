//! Findings about the programs of every kind of workbook: one row each.

use crate::finding::Example;
use crate::finding::rule::{book, rules};
use crate::text::{Text, t};

rules! {
    /// The rows of every kind.
    RULES;

    "C1001" PositionOutOfFormat Stop { position: f64, parameters: Text }
        es "la posición {position} no cabe en un programa (cinco cifras y tres decimales)"
        en "position {position} does not fit into a program (five digits and three decimals)"
        remedy "compruebe {parameters}", "check {parameters}";
        why "El control lee cinco cifras antes del punto y perdería las demás.",
            "The control reads five digits before the point and would lose the rest.";
        example Example::Never(t(
            "los límites de las celdas impiden posiciones así", "the limits of the cells prevent such positions"));
    "P1028" NotNumbered Note { greatest: u32 }
        es "los bloques van sin número: pasarían de N{greatest}"
        en "the blocks have no numbers: they would exceed N{greatest}"
        remedy "", "";
        why "El control se para en un número con demasiadas cifras.", "The control stops at a number with too many digits.";
        example book!("impeller --case full", "dialect" = "linuxcnc", "start_codes" = "M3", "retract" = "", "block_step" = "1000");
}
