//! Contradictions of pipes: their sizes.

use crate::finding::rule::{book, rules};
use crate::finding::{Size, Typed};
use crate::text::Text;

rules! {
    /// The rows of a pipe's size.
    RULES;
    "P2001" NoSchedule Stop { number: &'static str, nps: &'static str, diameter: &'static str, wall: &'static str }
        es "ASME B36.10 no tiene cédula {number} en el tamaño {nps}"
        en "ASME B36.10 has no schedule {number} in size {nps}"
        remedy "elija otra cédula, o escriba {diameter} y {wall}", "choose another schedule, or fill in {diameter} and {wall}";
        why "La norma no da pared para ese par; no se adivina.", "The standard gives no wall for this pair; none is guessed.";
        example book!("pipe-insert", "branch_size" = "1/8 in", "branch_schedule" = "Sch 160");
    "P2002" TwoSizes Stop {
        size: &'static str, nps: &'static str, number: &'static str, outside: Typed, thick: Typed, diameter: &'static str, wall: &'static str,
    }
        es "{size} {nps} cédula {number} es {outside} × {thick}, y {diameter} o {wall} dicen otra cosa"
        en "{size} {nps} schedule {number} is {outside} × {thick}, and {diameter} or {wall} say otherwise"
        remedy "deje vacíos {diameter} y {wall}, o el tamaño nominal", "leave {diameter} and {wall} empty, or the nominal size";
        why "De dos medidas de un tubo no se sabe cuál es la suya.", "Of two sizes of one pipe it is not known which one is its own.";
        example book!("pipe-insert", "D_branch" = "90");
    "P2003" SizeMissing Stop { size: &'static str, schedule: &'static str, diameter: &'static str, wall: &'static str }
        es "falta el tamaño: {size} y {schedule}, o {diameter} y {wall}"
        en "the size is missing: {size} and {schedule}, or {diameter} and {wall}"
        remedy "rellene uno de los dos pares", "fill in one of the two pairs";
        why "Sin diámetro y pared no hay curva.", "Without diameter and wall there is no curve.";
        example book!("pipe-insert", "branch_schedule" = "");
    "P2004" WallBeyondRadius Stop { pipe: Text, wall: Size, radius: Size }
        es "la pared {pipe} es {wall} y debe ser menor que su radio, {radius}"
        en "the wall {pipe} is {wall}, must be below its radius, {radius}"
        remedy "compruebe diámetro y pared", "check diameter and wall";
        why "Un tubo tiene un hueco.", "A pipe has a bore.";
        example book!("pipe-hole", "branch_size" = "", "branch_schedule" = "", "D_branch" = "20", "t_branch" = "15");
    "P2005" NoLeadIn Caution {}
        es "sin entrada: la antorcha perfora sobre la curva"
        en "no lead-in: the torch pierces on the curve"
        remedy "una entrada de unos milímetros", "a lead-in of some millimetres";
        why "Al perforar el arco deja un cráter más ancho que el corte, y ahí quedaría en la pieza.",
            "Where it pierces the arc leaves a crater wider than the cut, and that would stay in the part.";
        example book!("pipe-hole", "lead_in" = "0");
}
