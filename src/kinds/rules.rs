//! Contradictions of programs that several kinds write.

use crate::finding::rule::{book, rules};
use crate::finding::{Finding, Key, Raise};
use crate::gcode::code::G;
use crate::gcode::control::Control;
use crate::gcode::fields::DIALECT;
use crate::parameter::at;

rules! {
    /// The rows of what several kinds write.
    RULES;
    "P0101" FullStyleNeeds Stop { symbol: Key }
        es "falta {symbol}: style = completo lo exige"
        en "{symbol} is missing: style = full requires it"
        remedy "escriba {symbol}, o elija style = anexo", "fill in {symbol}, or choose style = annex";
        why "Un programa completo lleva sus avances y velocidades; sin ellos el control usaría los del programa anterior.",
            "A complete program gives its feeds and speeds; without them the control would use those of the previous program.";
        example book!("impeller", "F" = "");
    "P0102" AnnexCarriesNoFeed Stop { control: &'static str }
        es "style = anexo no lleva avance F, y el dialecto {control} no se mueve sin él"
        en "style = annex has no feed F, and the dialect {control} does not move without one"
        remedy "elija style = completo", "choose style = full";
        why "Los programas publicados son para un control que usa el avance fijado en su panel.",
            "The published programs are for a control that uses the feed set at its panel.";
        example book!("impeller --case full", "style" = "annex", "dialect" = "linuxcnc");
    "P0103" PathMayBeBlended Caution {}
        es "los programas no llevan G61 ni G64 P, y entre bloques este control puede apartarse de la trayectoria: lo verificado es la trayectoria exacta"
        en "the programs set neither G61 nor G64 P, and between blocks this control may leave the path: what is proved is the exact path"
        remedy "active G61, o G64 con una P pequeña, en la máquina antes del programa", "have G61, or G64 with a small P, in force on the machine before the program";
        why "Con G64 sin P, LinuxCNC mantiene el avance y redondea las esquinas cuanto haga falta.",
            "With G64 without P, LinuxCNC keeps the feed and rounds corners by whatever that takes.";
        example book!("impeller --case full", "dialect" = "linuxcnc", "start_codes" = "M3");
}

/// The caution about corners between blocks, for a control that has a tolerance for them.
#[must_use]
pub fn corners_between_blocks(control: &Control) -> Option<Finding> {
    control.codes.has(G::PathTolerance).then(|| PathMayBeBlended {}.at(at([DIALECT.key()])))
}
