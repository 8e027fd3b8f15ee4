//! What is wrong with the cuts of a lathe: the spindle, the offset of the tool, threads, a contour without a cut.

use crate::finding::rule::rules;
use crate::finding::{Example, Size};
use crate::text::Text;

rules! {
    /// The rows of this file.
    RULES;

    "G0580" ThreadBeyondRapid Caution { feed: Size, axis: char, rapid: Size, whose: Text }
        es "la rosca movería el eje {axis} a {feed}, más rápido que el avance rápido de {rapid} {whose}"
        en "the thread would move axis {axis} at {feed}, faster than the rapid rate of {rapid} {whose}"
        remedy "compruebe el paso F, o baje S", "check the lead F, or lower S";
        why "En una rosca el eje sigue al husillo: a ese avance no llega, y el control se para o corta otro paso.",
            "In a thread the axis follows the spindle: it cannot go so fast, and the control stops or cuts another lead.";
        example Example::program("fanuc-lathe-a", "G21 G97 S800 M3|T0404|G0 X49.5 Z6.|G32 Z-20. F200.|M30", "4");
    "G0581" ThreadAtSurfaceSpeed Caution {}
        es "rosca con velocidad de corte constante (G96): el giro cambia con X de una pasada a otra"
        en "thread at constant surface speed (G96): the spindle speed changes with X from pass to pass"
        remedy "programe G97 con S antes de la rosca", "program G97 with S before the thread";
        why "El carro tarda en alcanzar su velocidad: con otro giro la pasada entra en otro ángulo y no sigue el filete.",
            "The carriage takes time to reach its speed: at another spindle speed the pass enters at another angle and does not follow the groove.";
        example Example::program("fanuc-lathe-a", "G21 G50 S2000|T0404|G96 S100 M3|G0 X54. Z6.|G92 X49.5 Z-20. F2.|X49.|M30", "5");
    "G0582" ContourWithoutCut Caution {}
        es "el contorno no tiene ningún movimiento de avance: G70 lo recorrería entero en rápido"
        en "the contour has no motion at feed: G70 would follow all of it in rapid"
        remedy "programe G1 en el primer bloque que corta", "program G1 in the first block that cuts";
        why "G0 sigue en vigor de un bloque a otro: sin G1 la herramienta entra en la pieza en rápido.",
            "G0 stays in force from block to block: without G1 the tool enters the work in rapid.";
        example Example::program("fanuc-lathe-a", "G21 G99|T0101 S500 M3|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20 F.2|N10 G0 X30.|Z-10.|N20 X50.|G70 P10 Q20 F.1|M30", "6");
    "G0583" SpindleNeverStarts Caution {}
        es "el programa corta y no pone en marcha el husillo: no tiene M3 ni M4"
        en "the program cuts and never starts the spindle: it has neither M3 nor M4"
        remedy "programe M3 o M4 con S antes del primer corte", "program M3 or M4 with S before the first cut";
        why "Con la pieza parada la herramienta se clava en ella; con avance por vuelta el control se queda esperando.",
            "With the work at rest the tool rams into it; with a feed per revolution the control waits for ever.";
        example Example::program("fanuc-lathe-a", "G21 G99 G97 S800|T0101|G0 X48. Z2.|G1 Z-20. F.2|M30", "4");
    "G0584" CutsWithoutOffset Caution { word: String, like: String }
        es "corta con {word}: sin el corrector de la herramienta"
        en "cuts under {word}: without the tool's offset"
        remedy "dé el corrector en las dos últimas cifras de T, como {like}", "give the offset in the last two digits of T, as {like}";
        why "El corrector dice dónde está la punta: sin él la herramienta corta donde no debe, en toda su longitud.",
            "The offset says where the tip is: without it the tool cuts in the wrong place, by all of its length.";
        example Example::program("fanuc-lathe-a", "G21 G99 G97 S800 M3|T0101|G0 X48. Z2.|G1 Z-20. F.2|G0 X100. Z100.|T0200|G0 X48. Z2.|G1 X40. F.1|M30", "8");
    "G0585" NoOffsetAnywhere Caution { word: String, like: String }
        es "ninguna T del programa lleva corrector: corta con {word}"
        en "no T of the program has an offset: it cuts under {word}"
        remedy "dé el corrector en las dos últimas cifras de T, como {like}, o compruebe que la máquina mide sus herramientas de otro modo",
            "give the offset in the last two digits of T, as {like}, or check that the machine measures its tools in another way";
        why "Sin corrector el control no sabe dónde está la punta de cada herramienta.",
            "Without an offset the control does not know where the tip of each tool is.";
        example Example::program("fanuc-lathe-a", "G21 G99 G97 S800 M3|T0200|G0 X48. Z2.|G1 X40. F.1|M30", "4");
    "G0586" PassFarDeeper Caution { by: Size, than: Text, lead: Size }
        es "esta pasada de la rosca es {by} más honda que {than}, en radio, más que el paso de {lead}"
        en "this pass of the thread is {by} deeper than {than}, on the radius, more than the lead of {lead}"
        remedy "compruebe X y su punto decimal", "check X and its decimal point";
        why "Toda la rosca es menos honda que su paso: una pasada así rompe la herramienta o corta la pieza.",
            "A whole thread is less deep than its lead: such a pass breaks the tool or cuts the work in two.";
        example Example::program("fanuc-lathe-a", "G21 G97 S500 M3|T0404|G0 X54. Z6.|G92 X49.5 Z-20. F2.|X49.|X4.8|M30", "6");
    "G0587" ContourLegInRapid Caution {}
        es "este bloque del contorno va en rápido, y por la pieza: G70 lo recorrería así"
        en "this block of the contour goes in rapid, and along the part: G70 would follow it so"
        remedy "programe G1 en el bloque", "program G1 in the block";
        why "G0 sigue en vigor de un bloque a otro, y vale solo para el primero, que lleva al contorno: la herramienta corta lo que ha quedado en rápido.",
            "G0 stays in force from block to block, and is for the first one alone, which leads to the contour: the tool cuts what is left in rapid.";
        example Example::program("fanuc-lathe-a", "G21 G99|T0101 S500 M3|G0 X50. Z2.|G71 U2. R1.|G71 P10 Q20 F.2|N10 G0 X30.|Z-10.|G1 X40. Z-15.|N20 X50.|G70 P10 Q20 F.1|M30", "7");
    "G0591" ThreadWithoutSpeedLimit Caution { speed: Size, axis: char, rapid: Size, whose: Text }
        es "rosca con G96 sin límite de giro: por encima de {speed} la rosca movería el eje {axis} más rápido que el avance rápido de {rapid} {whose}, y a esta S el husillo sube hasta donde puede"
        en "thread under G96 without a speed limit: above {speed} the thread would move axis {axis} faster than the rapid rate of {rapid} {whose}, and at this S the spindle runs up as far as it can"
        remedy "programe G97 con S antes de la rosca", "program G97 with S before the thread";
        why "En una rosca el eje sigue al husillo: si no llega, el control se para o corta otro paso.",
            "In a thread the axis follows the spindle: where it cannot, the control stops or cuts another lead.";
        example Example::program("fanuc-lathe-a", "G21 T0404|G96 S3100 M3|G0 X30. Z6.|G92 X25.3 Z-20. F2.|M30", "4");
}
