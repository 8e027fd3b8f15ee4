//! Contradictions of programs that several kinds write.

use crate::finding::Key;
use crate::finding::rule::{book, rules};

rules! {
    /// The rows of what several kinds write.
    RULES;
    "P0101" FullStyleNeeds Stop { symbol: Key }
        es "falta {symbol}: style = full lo exige"
        en "{symbol} is missing: style = full requires it"
        remedy "escriba {symbol}, o elija style = annex", "fill in {symbol}, or choose style = annex";
        why "Un programa completo lleva sus avances y velocidades; sin ellos el control usaría los del programa anterior.",
            "A complete program gives its feeds and speeds; without them the control would use those of the previous program.";
        example book!("impeller", "F" = "");
    "P0102" AnnexCarriesNoFeed Stop { control: &'static str }
        es "style = annex no lleva avance F, y el dialecto {control} no se mueve sin él"
        en "style = annex has no feed F, and the dialect {control} does not move without one"
        remedy "elija style = full", "choose style = full";
        why "Los programas publicados son para un control que usa el avance fijado en su panel.",
            "The published programs are for a control that uses the feed set at its panel.";
        example book!("impeller --case full", "style" = "annex", "dialect" = "linuxcnc");
}
