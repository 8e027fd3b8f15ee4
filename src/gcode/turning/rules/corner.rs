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
        es "rodete admite «{word}» solo en una recta con G1"
        en "'{word}' is supported only in a G1 line"
        remedy "escriba el chaflán o el arco en un bloque aparte", "write the chamfer or arc as a separate block";
        why "El control mata la esquina al final de la recta de ese bloque.",
            "The control breaks the corner at the end of that block's line.";
        example fanuc!("G1 ,C1.|Z-9.", "3:4");
    "G0602" CornerBeforeOtherMotion Stop alarm Fanuc 52 { word: &'static str }
        es "después de «{word}» no sigue una recta con G1"
        en "no G1 line follows '{word}'"
        remedy "programe a continuación la segunda recta de la esquina, o escriba el chaflán o el arco en un bloque aparte",
            "program the second line of the corner next, or write the chamfer or arc as a separate block";
        why "El control solo calcula la esquina entre dos rectas en avance.",
            "The control can work out a corner only between two feed lines.";
        example fanuc!("G1 X20. ,R1.|G2 X30. Z-5. R5.", "3:9");
    "G0603" CornerBeforeNoMotion Stop alarm Fanuc 51 { word: &'static str }
        es "el bloque siguiente a «{word}» no se mueve con G1"
        en "the block after '{word}' is not a G1 motion"
        remedy "programe a continuación la segunda recta de la esquina, o escriba el chaflán o el arco en un bloque aparte",
            "program the second line of the corner next, or write the chamfer or arc as a separate block";
        why "El control mira solo un bloque más adelante para saber por dónde sigue el contorno.",
            "The control looks only one block ahead to see where the contour continues.";
        example fanuc!("G1 X20. ,C1.|M8|Z-5.", "3:9");
    "G0604" CornerTwice Stop alarm Fanuc 53 { first: &'static str, second: &'static str }
        es "«{first}» y «{second}» en un bloque"
        en "'{first}' and '{second}' in one block"
        remedy "deje uno", "leave one";
        why "En una esquina solo cabe un chaflán o un radio.", "A corner takes one chamfer or one radius.";
        example fanuc!("G1 X20. K-1. R-1.|Z-9.", "3:9");
    "G0605" CornerInContour Note {}
        es "«,C» o «,R» en un contorno: los Fanuc más antiguos no los admiten entre P y Q"
        en "',C' or ',R' in a contour: the oldest Fanuc controls do not allow them between P and Q"
        remedy "", "";
        why "El mismo programa da una alarma en un torno más viejo.", "The same program gives an alarm on an older lathe.";
        example fanuc!("G71 U2. R1.|G71 P10 Q20|N10 G0 X20.|G1 Z-10. ,C1.|N20 X50.", "6:10");
    "G0610" CornerLineWithoutLength Stop alarm Fanuc 51 {}
        es "una de las rectas de la esquina no tiene longitud"
        en "a line of the corner has no length"
        remedy "programe dos rectas que se corten en la esquina", "program two lines that meet at the corner";
        why "Una esquina necesita una dirección antes y otra después.",
            "A corner needs a direction before it and one after it.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G1 X20.|G1 X20. ,R3.|Z-9.|M30", "4:9");
    "G0611" CornerSignAgainstLine Stop alarm Fanuc 51 {}
        es "el signo de la esquina es contrario al sentido de la recta siguiente"
        en "the sign of the corner points away from the next line"
        remedy "programe dos rectas que se corten en la esquina", "program two lines that meet at the corner";
        why "I, K y R llevan el signo de la recta siguiente.", "I, K and R take the sign of the next line.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G1 X20. K1.|Z-9.|M30", "3:9");
    "G0612" CornerNotSquare Stop alarm Fanuc 54 {}
        es "la esquina no está entre una recta paralela a un eje y otra paralela al otro"
        en "the corner is not between a line along one axis and a line along the other"
        remedy "use I en una recta según Z, K en una según X y R en cualquiera; si no, use «,C» o «,R»",
            "use I on a line along Z, K on a line along X, R on either; otherwise use ',C' or ',R'";
        why "I, K y R sin coma solo valen en un ángulo recto entre los ejes.",
            "I, K and R without a comma work only at a right angle between the axes.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G1 X20. I-1.|Z-9.|M30", "3:9");
    "G0613" CornerTooLong Stop alarm Fanuc 55 { taken: Size, shortest: Size }
        es "la esquina necesita {taken} de cada recta, y la más corta mide {shortest}"
        en "the corner needs {taken} of each line, and the shorter line is {shortest} long"
        remedy "disminuya el chaflán o el radio, o alargue las rectas",
            "make the chamfer or the radius smaller, or the lines longer";
        why "La herramienta tendría que retroceder por la recta.", "The tool would have to go back along the line.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G1 X20. ,C3.|Z3.|M30", "3:9");
    "G0629" CornerRunsBack Stop {}
        es "la segunda recta vuelve por la primera: no hay esquina"
        en "the second line runs back along the first: there is no corner"
        remedy "compruebe los dos bloques", "check the two blocks";
        why "Una recta que vuelve por la anterior no forma ningún ángulo con ella.",
            "A line that runs back over the one before it makes no angle with it.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G1 X20. ,R3.|X30.|M30", "3:9");
}
