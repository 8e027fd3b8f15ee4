//! What the judges of a branch's program say beside the common rows: V0201 to V0299.

use crate::finding::{Example, Size};

crate::finding::rule::rules! {
    /// The rows of this room.
    RULES;
    "V0201" CutOffSpeed Stop { speed: Size, line: usize, F: Size }
        es "la velocidad de corte es {speed} en la línea {line}, pero F es {F}"
        en "the cutting speed is {speed} in line {line}, but F is {F}"
        remedy fault;
        why "A otra velocidad el chorro se desvía o no atraviesa la pared.",
            "At another speed the jet bends, or does not go through the wall.";
        example Example::Slip { kind: "pipe-insert", cells: &[], program: "insert", from: "F925.899", to: "F1025.899" };
}
