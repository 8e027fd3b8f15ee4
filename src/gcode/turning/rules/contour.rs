//! The rows of the contour that a cycle names.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::{Text, t};

rules! {
    /// The rows of this file.
    RULES;

    "G0700" ContourEndsBeforeItBegins Stop alarm Fanuc 63 { cycle: u8, last: u32, first: u32 }
        es "G{cycle}: N{last} está antes de N{first}"
        en "G{cycle}: N{last} comes before N{first}"
        remedy "dé con P el primer bloque del contorno y con Q el último",
            "give the first block of the contour with P and the last one with Q";
        why "El contorno va del primer bloque al último.", "The contour runs from the first block to the last.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P20 Q10|N10 G0 X30.|G1 Z-10.|N20 X50.|M30", "4:9");
    "G0701" ContourBlockNotNamed Stop alarm Fanuc 61 { letter: char, cycle: u8 }
        es "falta {letter} en G{cycle}: el número de un bloque del contorno"
        en "{letter} is missing in G{cycle}: the number of a block of the contour"
        remedy "dé {letter} en el bloque", "give {letter} in the block";
        why "P y Q dicen qué bloques son el contorno.", "P and Q say which blocks are the contour.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G70 Q20|N10 G0 X30.|G1 Z-10.|N20 X50.|M30", "3:1");
    "G0702" NoBlockNumber Stop { letter: char, value: f64 }
        es "{letter}{value} no es un número de bloque"
        en "{letter}{value} is not a block number"
        remedy "dé un número entero", "give a whole number";
        why "El número de un bloque es entero.", "A block number is a whole number.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P-10 Q20|N10 G0 X20.|G1 Z-10.|N20 X50.|M30", "4:5");
    "G0703" ContourWithoutEnd Stop { cycle: u8 }
        es "el contorno de G{cycle} no termina"
        en "the contour of G{cycle} does not end"
        remedy "ponga sus bloques seguidos", "write its blocks one after another";
        why "El contorno debe acabar antes que el programa.", "The contour must end before the program does.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 G0 X20.|O|N20 X50.|M30", "6:1");
    "G0704" ContourTooLong Stop { cycle: u8, most: usize }
        es "el contorno de G{cycle} tiene más de {most} bloques"
        en "the contour of G{cycle} has more than {most} blocks"
        remedy "compruebe P y Q", "check P and Q";
        why "Los controles admiten muchos menos: P o Q será erróneo.",
            "Controls allow far fewer: P or Q is probably wrong.";
        example Example::Made { key: "program-long-contour", how: t("un contorno de más de 10 000 bloques entre N10 y N20", "a contour of more than 10,000 blocks between N10 and N20") };
    "G0705" ContourEndsWithCorner Stop alarm Fanuc 326 { cycle: u8, word: &'static str }
        es "el contorno de G{cycle} acaba con «{word}», sin la recta que la sigue"
        en "the contour of G{cycle} ends with '{word}', without the line that follows it"
        remedy "ponga en el contorno la segunda recta de la esquina", "put the second line of the corner into the contour";
        why "La esquina necesita sus dos rectas dentro del contorno.",
            "The corner needs both of its lines within the contour.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 G0 X30.|N20 G1 Z-5. ,R1.|X50.|M30", "6:13");
    "G0706" ContourStandsStill Stop alarm Fanuc 63 { cycle: u8, first: u32, last: u32 }
        es "G{cycle}: no hay movimiento de N{first} a N{last}"
        en "G{cycle}: there is no motion from N{first} to N{last}"
        remedy "dé el contorno con G0, G1, G2 y G3", "give the contour with G0, G1, G2 and G3";
        why "Sin movimientos no hay contorno.", "Without motions there is no contour.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 G0 F.1|N20 S500|M30", "6");
    "G0707" ContourBegins Stop alarm Fanuc 65 { part: Text, cycle: u8 }
        es "el primer {part} del contorno de G{cycle} no lleva G0 ni G1"
        en "the first {part} of the contour of G{cycle} has neither G0 nor G1"
        remedy "programe G0 o G1 en él", "program G0 or G1 in it";
        why "El primer bloque lleva la herramienta al contorno en línea recta.",
            "The first block takes the tool to the contour in a straight line.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 M8|G0 X30.|G1 Z1.|N20 X50.|M30", "5");
    "G0708" ContourDwellAndMotion Stop {}
        es "G4 y un movimiento en un bloque"
        en "G4 and a motion in one block"
        remedy "escriba dos bloques", "write two blocks";
        why "En un bloque con G4 las cotas son el tiempo de espera.", "In a block with G4 the dimensions are the dwell time.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 G0 X30.|G4 X1. Z2.|N20 X50.|M30", "6:1");
    "G0709" ContourWordsPassedOver Note { cycle: u8 }
        es "G{cycle} no tiene en cuenta M, T, G4, G96 a G99, F ni S dentro del contorno; G70 sí"
        en "G{cycle} ignores M, T, G4, G96 to G99, F and S within the contour; G70 obeys them"
        remedy "escriba antes del ciclo lo que necesite el desbaste", "write what roughing needs before the cycle";
        why "El desbaste trabaja con lo que está en vigor en el bloque del ciclo.",
            "Roughing uses what is in force in the cycle's block.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 G0 X20.|G1 Z-10. M8|N20 X50.|M30", "6");
    "G0710" NotInContour Stop alarm Fanuc 325 { code: Text, cycle: u8 }
        es "{code} dentro del contorno de G{cycle}"
        en "{code} inside the contour of G{cycle}"
        remedy "deje en el contorno G0 a G3, sus cotas, G4, G40 a G42, G96 a G99, F, S y M; escriba lo demás fuera",
            "keep G0 to G3, their dimensions, G4, G40 to G42, G96 to G99, F, S and M in the contour; write the rest outside";
        why "El ciclo lee esos bloques como geometría y no los ejecuta por su orden.",
            "The cycle reads these blocks as geometry and does not run them in order.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 G0 X30.|M98 P1|N20 X50.|M30", "6:1");
    "G0711" ContourToolChange Stop { cycle: u8 }
        es "rodete no admite un cambio de herramienta dentro del contorno de G{cycle}"
        en "rodete does not follow a tool change inside the contour of G{cycle}"
        remedy "escriba T fuera, o en el primer bloque del contorno, que G70 obedece: después la torreta giraría en el corte",
            "write T outside, or in the contour's first block, which G70 obeys: later the turret would index in the cut";
        why "No se sabe qué hace con los arcos un corrector que entra en mitad del contorno.",
            "It is not known what a tool offset that changes within the contour does to the arcs.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 G0 X30.|G1 Z1. T0202|N20 X50.|M30", "6:8");
    "G0712" BlocksBeforeContour Caution { blocks: usize, cycle: u8 }
        es "el control no ejecuta los bloques que hay entre G{cycle} y su contorno: {blocks}"
        en "the control does not run the blocks between G{cycle} and its contour: {blocks}"
        remedy "ponga el contorno justo después del ciclo", "put the contour right after the cycle";
        why "Después del ciclo el programa sigue después del contorno.", "After the cycle the program continues after the contour.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|G0 Z6.|N10 G0 X20.|G1 Z-10.|N20 X50.|M30", "4");
}
