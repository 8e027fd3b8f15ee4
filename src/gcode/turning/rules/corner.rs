//! The rows of corners between two lines.

use crate::finding::rule::rules;
use crate::finding::{Example, Size};

/// A program for a Fanuc lathe that stands in front of the turning bar, its blocks joined with `|`; the first of them is line 3.
macro_rules! fanuc {
    ($blocks:literal, $at:literal) => {
        Example::program("fanuc-lathe-a", concat!("S500 M3 F.2|G0 X50. Z5.|", $blocks, "|M30"), $at)
    };
}

rules! {
    /// The rows of this file.
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
    "G0610" CornerLineWithoutLength Stop alarm Fanuc 51 {}
        es "una de las rectas de la esquina no tiene longitud"
        en "a line of the corner has no length"
        remedy "dé dos rectas que se corten en la esquina", "give two lines that meet in the corner";
        why "Sin una dirección antes y otra después no hay ángulo que romper.",
            "Without a direction before it and one behind it there is no angle to break.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G1 X20.|G1 X20. ,R3.|Z-9.|M30", "4:9");
    "G0611" CornerSignAgainstLine Stop alarm Fanuc 51 {}
        es "el signo de la esquina va al revés que la recta siguiente"
        en "the sign of the corner leads the other way than the next line"
        remedy "dé dos rectas que se corten en la esquina", "give two lines that meet in the corner";
        why "I, K y R llevan el signo de la recta que sigue.", "I, K and R carry the sign of the line that follows.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G1 X20. K1.|Z-9.|M30", "3:9");
    "G0612" CornerNotSquare Stop alarm Fanuc 54 {}
        es "la esquina no está entre una recta a lo largo de un eje y otra a lo largo del otro"
        en "the corner is not between a line along one axis and one along the other"
        remedy "I va en una recta a lo largo de Z, K en una de X, R en cualquiera de ellas; si no, use «,C» o «,R»",
            "I stands on a line along Z, K on one along X, R on either; else use ',C' or ',R'";
        why "I, K y R sin coma solo rompen un ángulo recto entre los ejes.",
            "I, K and R without a comma break a right angle between the axes alone.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G1 X20. I-1.|Z-9.|M30", "3:9");
    "G0613" CornerTooLong Stop alarm Fanuc 55 { taken: Size, shortest: Size }
        es "la esquina ocupa {taken} de cada recta, y la más corta mide {shortest}"
        en "the corner takes {taken} of either line, and the shorter is {shortest} long"
        remedy "disminuya el chaflán o el radio, o alargue las rectas",
            "make the chamfer or the radius smaller, or the lines longer";
        why "La herramienta tendría que volver atrás por la recta.", "The tool would have to go back along the line.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G1 X20. ,C3.|Z3.|M30", "3:9");
    "G0629" CornerRunsBack Stop {}
        es "las dos rectas van y vuelven: no hay esquina"
        en "the two lines run back along each other: there is no corner"
        remedy "compruebe los dos bloques", "check the two blocks";
        why "Dos rectas que se recorren al revés no forman ángulo.",
            "Two lines that run the one back over the other make no angle.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G1 X20. ,R3.|X30.|M30", "3:9");
}
