//! What is refused or remarked of turning cycles, threads, corners and the compensation of the nose.
//!
//! # References
//! Fanuc Series 0i/30i, list of alarms (CNC): PS0051 to PS0055, PS0061 to PS0066, PS0313 to PS0329. The texts are rodete's own.

use crate::finding::Example;
use crate::finding::rule::rules;

/// A program for a Fanuc lathe that stands in front of the turning bar, its blocks joined with `|`; the first of them is line 3.
macro_rules! fanuc {
    ($blocks:literal, $at:literal) => {
        Example::program("fanuc-lathe-a", concat!("S500 M3 F.2|G0 X50. Z5.|", $blocks, "|M30"), $at)
    };
}

rules! {
    /// The rows of turning programs.
    RULES;

    "G0601" CornerWithoutLine Stop { word: String }
        es "«{word}» sin una recta con G1 no está implementado"
        en "'{word}' without a line with G1 is not supported"
        remedy "escriba el chaflán o el arco en un bloque propio", "write the chamfer or arc as a block of its own";
        why "La esquina se rompe al final de la recta en cuyo bloque está.",
            "A corner is broken at the end of the line in whose block it stands.";
        example fanuc!("G1 ,C1.|Z-9.", "3:4");
    "G0602" CornerBeforeOtherMotion Stop alarm Fanuc 52 { word: &'static str }
        es "detrás de «{word}» no viene una recta con G1"
        en "no line with G1 comes behind '{word}'"
        remedy "ponga detrás la segunda recta de la esquina, o escriba el chaflán o el arco en un bloque propio",
            "let the corner's second line follow, or write the chamfer or arc as a block of its own";
        why "El control solo calcula la esquina entre dos rectas en avance.",
            "The control works a corner out between two lines at feed alone.";
        example fanuc!("G1 X20. ,R1.|G2 X30. Z-5. R5.", "3:9");
    "G0603" CornerBeforeNoMotion Stop alarm Fanuc 51 { word: &'static str }
        es "el bloque siguiente a «{word}» no se mueve con G1"
        en "the block behind '{word}' makes no motion with G1"
        remedy "ponga detrás la segunda recta de la esquina, o escriba el chaflán o el arco en un bloque propio",
            "let the corner's second line follow, or write the chamfer or arc as a block of its own";
        why "El control mira un solo bloque más allá para saber hacia dónde sigue el contorno.",
            "The control looks a single block ahead to know where the contour goes on.";
        example fanuc!("G1 X20. ,C1.|M8|Z-5.", "3:9");
    "G0604" CornerTwice Stop alarm Fanuc 53 { first: &'static str, second: &'static str }
        es "«{first}» y «{second}» en un bloque"
        en "'{first}' and '{second}' in one block"
        remedy "deje uno", "leave one";
        why "Una esquina se rompe de una sola manera.", "A corner is broken in one way only.";
        example fanuc!("G1 X20. K-1. R-1.|Z-9.", "3:9");
    "G0605" CornerInContour Note {}
        es "«,C» o «,R» en un contorno: los Fanuc más antiguos no los admiten entre P y Q"
        en "',C' or ',R' in a contour: the oldest Fanuc controls do not take them between P and Q"
        remedy "", "";
        why "El mismo programa da una alarma en un torno más viejo.", "The same program raises an alarm on an older lathe.";
        example fanuc!("G71 U2. R1.|G71 P10 Q20|N10 G0 X20.|G1 Z-10. ,C1.|N20 X50.", "6:10");
    "G0606" TooManyPecks Stop { most: f64 }
        es "más de {most} pasadas en un agujero"
        en "more than {most} pecks in one hole"
        remedy "aumente Q", "make Q greater";
        why "Tantas pasadas las pide un Q escrito en otra unidad.", "So many pecks come of a Q that is written in another unit.";
        example Example::program("linuxcnc", "G21 G90 F100 S500 M3|G0 Z5|G83 X0 Y0 R2 Z-50 Q0.0001|M2", "3");
}
