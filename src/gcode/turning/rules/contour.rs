//! The rows of the contour that a cycle names.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::{Text, t};

rules! {
    /// The rows of this file.
    RULES;

    "G0700" ContourEndsBeforeItBegins Stop alarm Fanuc 63 { cycle: u8, last: u32, first: u32 }
        es "G{cycle}: N{last} está delante de N{first}"
        en "G{cycle}: N{last} stands before N{first}"
        remedy "nombre primero el primer bloque del contorno y luego el último",
            "name the contour's first block first and its last block last";
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
        en "{letter}{value} is no block number"
        remedy "dé un número entero", "give a whole number";
        why "Los bloques se numeran con enteros.", "Blocks are numbered with whole numbers.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P-10 Q20|N10 G0 X20.|G1 Z-10.|N20 X50.|M30", "4:5");
    "G0703" ContourWithoutEnd Stop { cycle: u8 }
        es "el contorno de G{cycle} no termina"
        en "the contour of G{cycle} does not end"
        remedy "ponga sus bloques seguidos", "write its blocks one after another";
        why "El contorno ha de acabar antes que el programa.", "The contour has to end before the program does.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 G0 X20.|O|N20 X50.|M30", "6:1");
    "G0704" ContourTooLong Stop { cycle: u8, most: usize }
        es "el contorno de G{cycle} tiene más de {most} bloques"
        en "the contour of G{cycle} has more than {most} blocks"
        remedy "compruebe P y Q", "check P and Q";
        why "Los controles admiten muchos menos; más son un P o un Q equivocado.",
            "Controls take far fewer; more come of a wrong P or Q.";
        example Example::Made { key: "program-long-contour", how: t("un contorno de más de 10 000 bloques entre N10 y N20", "a contour of more than 10,000 blocks between N10 and N20") };
    "G0705" ContourEndsWithCorner Stop alarm Fanuc 326 { cycle: u8, word: &'static str }
        es "el contorno de G{cycle} acaba con «{word}», sin la recta que la sigue"
        en "the contour of G{cycle} ends with '{word}', without the line that follows it"
        remedy "ponga en el contorno la segunda recta de la esquina", "let the contour have the corner's second line";
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
            "The first block leads the tool to the contour in a straight line.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 M8|G0 X30.|G1 Z1.|N20 X50.|M30", "5");
    "G0708" ContourDwellAndMotion Stop {}
        es "G4 y un movimiento en un bloque"
        en "G4 and a motion in one block"
        remedy "escriba dos bloques", "write two blocks";
        why "En el bloque de G4 las cotas son su tiempo.", "In the block of G4 dimensions are its time.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 G0 X30.|G4 X1. Z2.|N20 X50.|M30", "6:1");
    "G0709" ContourWordsPassedOver Note { cycle: u8 }
        es "G{cycle} pasa por alto M, T, G4 y G96 a G99 del contorno, como F y S; G70 los obedece"
        en "G{cycle} passes over M, T, G4 and G96 to G99 of the contour, as F and S; G70 obeys them"
        remedy "lo que el desbaste necesite va antes del ciclo", "what roughing needs stands before the cycle";
        why "El desbaste trabaja con lo que está en vigor en el bloque del ciclo.",
            "Roughing works with what is in force in the block of the cycle.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 G0 X20.|G1 Z-10. M8|N20 X50.|M30", "6");
    "G0710" NotInContour Stop alarm Fanuc 325 { code: Text, cycle: u8 }
        es "{code} dentro del contorno de G{cycle}"
        en "{code} inside the contour of G{cycle}"
        remedy "un contorno lleva G0 a G3, sus cotas, G4, G40 a G42, G96 a G99, F, S y M; escriba lo demás fuera",
            "a contour has G0 to G3, their dimensions, G4, G40 to G42, G96 to G99, F, S and M; write the rest outside";
        why "El ciclo lee esos bloques como geometría y no los ejecuta por su orden.",
            "The cycle reads these blocks as geometry and does not run them in their order.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 G0 X30.|M98 P1|N20 X50.|M30", "6:1");
    "G0711" ContourToolChange Stop { cycle: u8 }
        es "un cambio de herramienta dentro del contorno de G{cycle} no está implementado"
        en "a tool change inside the contour of G{cycle} is not supported"
        remedy "escriba T fuera, o en el primer bloque del contorno, que G70 obedece: después la torreta giraría en el corte",
            "write T outside, or in the contour's first block, which G70 obeys: behind it the turret would turn in the cut";
        why "No está dicho qué hace con los arcos el corrector que entra en mitad del contorno.",
            "Nothing says what an offset that comes into force within the contour does to its arcs.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 G0 X30.|G1 Z1. T0202|N20 X50.|M30", "6:8");
    "G0712" BlocksBeforeContour Caution { blocks: usize, cycle: u8 }
        es "{blocks} bloques entre G{cycle} y su contorno no se ejecutan"
        en "{blocks} blocks between G{cycle} and its contour are not executed"
        remedy "ponga el contorno justo detrás del ciclo", "put the contour right behind the cycle";
        why "El programa sigue detrás del contorno.", "The program goes on behind the contour.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|G0 Z6.|N10 G0 X20.|G1 Z-10.|N20 X50.|M30", "4");
}
