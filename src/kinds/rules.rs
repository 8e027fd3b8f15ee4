//! Contradictions of programs that several kinds write.

use crate::finding::rule::{book, rules};

rules! {
    /// The rows of what several kinds write.
    RULES;
    "P0101" FullStyleNeeds Stop { symbol: &'static str }
        es "falta {symbol}: el estilo full lo exige"
        en "{symbol} is missing: style full requires it"
        remedy "escriba {symbol}, o style = annex", "fill in {symbol}, or style = annex";
        why "Un programa completo lleva sus avances y velocidades; sin ellos el control usaría los que queden del anterior.",
            "A complete program carries its feeds and speeds; without them the control would use what is left of the one before.";
        example book!("impeller", "F" = "");
    "P0102" AnnexCarriesNoFeed Stop { control: &'static str }
        es "el estilo annex no lleva avance F y el dialecto {control} no mueve sin él"
        en "style annex carries no feed F, and dialect {control} does not move without it"
        remedy "style = full", "style = full";
        why "Los programas publicados son para un control que se mueve con el avance del panel.",
            "The published programs are for a control that moves at the feed of its panel.";
        example book!("impeller", "style" = "annex", "dialect" = "linuxcnc");
}
