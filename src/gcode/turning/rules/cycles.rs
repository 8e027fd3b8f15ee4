//! The rows of Fanuc's turning cycles.

use crate::finding::rule::rules;
use crate::finding::{Example, Size};
use crate::text::t;

rules! {
    /// The rows of this file.
    RULES;

    "G0615" NoDepthOfCut Stop alarm Fanuc 62 {}
        es "la profundidad de pasada es 0 o negativa"
        en "the depth of cut is zero or negative"
        remedy "dé una profundidad de pasada mayor que 0", "give a depth of cut above 0";
        why "Con una profundidad de 0 el desbaste no acabaría nunca.", "With a depth of 0 the roughing would never end.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G71 U0 R1.|G71 P10 Q20|N10 G0 X30.|G1 Z-10.|N20 X50.|M30", "4:1");
    "G0616" ContourNotFound Stop alarm Fanuc 63 {}
        es "no se encuentra el bloque del contorno que nombra P o Q"
        en "the block of the contour that P or Q names is not found"
        remedy "numere los bloques del contorno; Q va detrás de P", "number the blocks of the contour; Q comes after P";
        why "Sin contorno el ciclo no sabe qué dejar.", "Without a contour the cycle does not know what to leave.";
        example Example::Never(t(
            "un contorno sin bloques se rehúsa al leerlo",
            "a contour without blocks is refused as it is read",
        ));
    "G0617" ContourBackAlongZ Stop alarm Fanuc 64 {}
        es "el contorno avanza y retrocede en Z"
        en "the contour goes forth and back along Z"
        remedy "en Z el contorno debe ir siempre en un mismo sentido; divida el desbaste en dos",
            "along Z the contour must go one way only; split the roughing in two";
        why "Una pasada cortaría lo que el contorno deja detrás.", "A pass would cut what the contour leaves behind it.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 G0 X30.|G1 Z-10.|X32. Z-5.|N20 X50. Z-12.|M30", "7");
    "G0618" ContourBeginsWithArc Stop alarm Fanuc 65 {}
        es "el primer bloque del contorno no es G0 ni G1"
        en "the first block of the contour is not G0 or G1"
        remedy "lleve la herramienta al contorno con G0 o G1", "lead the tool to the contour with G0 or G1";
        why "El primer bloque solo lleva la herramienta al contorno.",
            "The first block does no more than lead the tool to the contour.";
        example Example::Never(t(
            "el contorno que empieza con un arco se rehúsa al leerlo",
            "a contour that begins with an arc is refused as it is read",
        ));
    "G0619" ThreadLeadNotPositive Stop alarm Fanuc 313 {}
        es "el paso de la rosca es 0 o negativo"
        en "the lead of the thread is zero or negative"
        remedy "dé el paso con F", "give the lead with F";
        why "Sin paso la herramienta no avanza.", "Without a lead the tool does not advance.";
        example Example::Never(t(
            "un paso que no es positivo se rehúsa al leer F",
            "a lead that is not positive is refused as F is read",
        ));
    "G0620" ThreadAngle Stop alarm Fanuc 315 {}
        es "ángulo de la punta no admitido en el roscado"
        en "angle of the tool tip not allowed in threading"
        remedy "el ángulo es 0, 29, 30, 55, 60 u 80 grados", "the angle is 0, 29, 30, 55, 60 or 80 degrees";
        why "El control solo conoce los ángulos de las roscas normalizadas.",
            "The control knows the angles of standard threads alone.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G76 P010045 Q50 R.1|G76 X28. Z-20. P1000 Q300 F1.5|M30", "4:1");
    "G0621" ThreadLeastCut Stop alarm Fanuc 316 {}
        es "la pasada mínima de la rosca es negativa o mayor que su altura"
        en "the least cut of the thread is negative or above its height"
        remedy "dé una pasada mínima menor que la altura", "give a least cut below the height";
        why "La pasada mínima se lee en µm: un punto decimal de más la hace mil veces mayor.",
            "The least cut is read in µm: a decimal point too many makes it a thousand times greater.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G76 P020060 Q9000 R.1|G76 X40. Z-20. P1200 Q300 F2.|M30", "4:1");
    "G0622" ThreadWithoutHeight Stop alarm Fanuc 317 {}
        es "la altura de la rosca o la primera pasada es 0 o negativa"
        en "the height of the thread or its first cut is zero or negative"
        remedy "dé P (altura) y Q (primera pasada) mayores que 0", "give P (height) and Q (first cut) above 0";
        why "De la altura y la primera pasada salen todas las demás.",
            "All other passes come of the height and the first cut.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G76 P010060 Q50 R.1|G76 X28. Z-20. P0 Q300 F1.5|M30", "4:1");
    "G0623" GrooveReliefNegative Stop alarm Fanuc 318 {}
        es "la separación en el fondo es negativa y su sentido ya está dado"
        en "the relief at the bottom is negative though its direction is given"
        remedy "dé R positivo", "give a positive R";
        why "La herramienta se separaría contra la pared que acaba de cortar.",
            "The tool would draw aside against the wall that it has just cut.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G75 R1.|G75 X30. Z-10. P2000 Q2000 R-1.|M30", "4:1");
    "G0624" GrooveStepZero Stop alarm Fanuc 319 {}
        es "el paso es 0 y hay distancia que recorrer en ese eje"
        en "the step is zero and there is a way to go along that axis"
        remedy "dé P y Q mayores que 0", "give P and Q above 0";
        why "Con pasos de 0 el ranurado no llegaría nunca.", "In steps of 0 the grooving would never arrive.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G75 R.5|G75 X40. Z0 P3000 F.1|M30", "4:1");
    "G0625" GrooveStepNegative Stop alarm Fanuc 320 {}
        es "el paso del ranurado es negativo"
        en "the step of the grooving is negative"
        remedy "P y Q van sin signo", "P and Q carry no sign";
        why "El sentido sale de los puntos, no del signo.", "The direction comes of the points, not of the sign.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G75 R1.|G75 X30. Z-10. P-2000 Q2000|M30", "4:1");
    "G0626" RepeatWithoutPasses Stop alarm Fanuc 321 {}
        es "el número de pasadas de G73 es 0 o negativo"
        en "the number of passes of G73 is zero or negative"
        remedy "dé con R cuántas pasadas", "give the number of passes with R";
        why "G73 reparte la demasía entre sus pasadas.", "G73 parts the stock among its passes.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G73 U2. W1. R0|G73 P10 Q20|N10 G0 X30.|G1 Z-10.|N20 X50.|M30", "4:1");
    "G0627" ContourBeyondStart Stop alarm Fanuc 322 {}
        es "el contorno pasa del punto de comienzo del ciclo"
        en "the contour reaches beyond the starting point of the cycle"
        remedy "comience el ciclo fuera del bruto, más allá de todo el contorno",
            "start the cycle outside the stock, beyond all of the contour";
        why "Las pasadas empiezan en ese punto, y las idas en rápido atravesarían el material.",
            "The passes begin at that point, and rapid motions would go through metal.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 G0 X20.|G1 Z-10.|N20 X70. Z-20.|M30", "7");
    "G0628" ContourBackAlongX Stop alarm Fanuc 329 {}
        es "el contorno avanza y retrocede en X"
        en "the contour goes forth and back along X"
        remedy "en X el contorno debe ir siempre en un mismo sentido; con bolsas en G71, mueva X y Z en el primer bloque",
            "along X the contour must go one way only; with pockets in G71, move X and Z in the first block";
        why "Un contorno con bolsas se desbasta de otra manera, que el primer bloque pide.",
            "A contour with pockets is roughed in another way, which the first block asks for.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 G0 X30.|G1 Z-10.|X20. Z-20.|N20 X50.|M30", "7");
    "G0630" ContourDoesNotAdvance Stop {}
        es "el contorno no avanza en el sentido de las pasadas"
        en "the contour does not advance in the direction of the passes"
        remedy "el contorno lleva un bloque que llega a él y los que lo recorren",
            "a contour has a block that leads to it and the blocks that run along it";
        why "Sin avance a lo largo de las pasadas no hay nada que desbastar.",
            "Without an advance along the passes there is nothing to rough.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 G0 X20.|N20 G1 X30.|M30", "6");
    "G0631" CycleNotFinite Stop {}
        es "un parámetro del ciclo no es un número finito"
        en "a parameter of the cycle is not a finite number"
        remedy "dé números que el control admita", "give numbers that the control takes";
        why "Un número así no es ninguna cota.", "Such a number is no dimension.";
        example Example::Never(t(
            "toda cota leída es finita y cabe en la retícula",
            "every dimension that is read is finite and within the grid",
        ));
    "G0632" RetractionNegative Stop {}
        es "la retirada R es negativa"
        en "the retraction R is negative"
        remedy "dé R sin signo", "give R without a sign";
        why "La herramienta se retiraría hacia el material.", "The tool would draw back into metal.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G71 U2. R-1.|G71 P10 Q20|N10 G0 X20.|G1 Z-10.|N20 X50.|M30", "4:1");
    "G0633" AllowanceIntoMetal Stop {}
        es "la demasía de acabado apunta hacia el metal: el desbaste cortaría la pieza"
        en "the finishing allowance points into the metal: roughing would cut the part"
        remedy "cambie el signo de U o de W: la demasía va del contorno hacia el punto de comienzo",
            "change the sign of U or W: the allowance goes from the contour towards the starting point";
        why "El acabado no puede devolver lo que el desbaste ha quitado.",
            "Finishing cannot give back what roughing has taken away.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20 U-1.|N10 G0 X20.|G1 Z-10.|N20 X50.|M30", "4:1");
    "G0634" TooManyRoughingPasses Stop { passes: Size, most: f64 }
        es "el ciclo pide {passes} pasadas; se admiten {most}"
        en "the cycle asks for {passes} passes; {most} are allowed"
        remedy "aumente la profundidad de pasada", "make the depth of cut greater";
        why "Tantas pasadas salen de una cota en otra unidad.", "So many passes come of a dimension in another unit.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X900. Z5.|G71 U.002 R1.|G71 P10 Q20|N10 G0 X1.|G1 Z-10.|N20 X900.|M30", "4:1");
    "G0635" GrooveWithoutDepth Stop {}
        es "el ranurado no tiene profundidad"
        en "the grooving has no depth"
        remedy "el punto final va más allá del punto de comienzo", "the end point lies beyond the starting point";
        why "Sin profundidad la herramienta no corta.", "Without a depth the tool does not cut.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G75 R1.|G75 X50. Z-10. P2000 Q2000|M30", "4:1");
    "G0636" TooManyGrooveSteps Stop { passes: Size, most: f64 }
        es "el ciclo pide {passes} pasadas; se admiten {most}"
        en "the cycle asks for {passes} passes; {most} are allowed"
        remedy "aumente P o Q", "make P or Q greater";
        why "P y Q se leen en µm: un punto decimal los hace mil veces menores.",
            "P and Q are read in µm: a number meant in mm is a thousand times smaller.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G75 R1.|G75 X10. Z-30. P1 Q1|M30", "4:1");
    "G0637" TooManyThreadPasses Stop { passes: Size, most: f64 }
        es "el ciclo pide {passes} pasadas; se admiten {most}"
        en "the cycle asks for {passes} passes; {most} are allowed"
        remedy "aumente la pasada mínima o la primera pasada", "make the least cut or the first cut greater";
        why "La primera pasada se lee en µm, y cada pasada quita la misma sección.",
            "The first cut is read in µm, and each pass takes the same section off.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G76 P020060 Q0 R.1|G76 X40. Z-20. P1200 Q1 F2.|M30", "4:1");
    "G0638" ThreadAllowance Stop {}
        es "la demasía de acabado es negativa o no es menor que la altura de la rosca"
        en "the finishing allowance is negative or not below the height of the thread"
        remedy "dé R del primer bloque menor que P", "give R of the first block below P";
        why "La última pasada de acabado quita esa demasía.", "The finishing passes take that allowance off.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G76 P020060 Q100 R2.|G76 X40. Z-20. P1200 Q300 F2.|M30", "4:1");
    "G0639" ThreadDigits Stop {}
        es "las pasadas de acabado van de 1 a 99 y la salida de 0 a 99 décimas del paso"
        en "the finishing passes go from 1 to 99 and the pull-out from 0 to 99 tenths of the lead"
        remedy "dé P con seis cifras: mmrraa", "give P with six digits: mmrraa";
        why "P lleva tres números de dos cifras; si falta una, los tres cambian.",
            "P holds three numbers of two digits; where one is missing all three change.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G76 P000060 Q100 R.1|G76 X40. Z-20. P1200 Q300 F2.|M30", "4:1");
    "G0640" ThreadStartsInside Stop {}
        es "el ciclo comienza dentro de la rosca: la herramienta volvería a través de ella"
        en "the cycle starts within the thread: the tool would return through it"
        remedy "comience más allá de la cresta, en los dos extremos si la rosca es cónica",
            "start beyond the crest, at both ends if the thread is tapered";
        why "Cada pasada vuelve en rápido al diámetro del comienzo.",
            "Each pass returns at rapid on the diameter of the start.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G76 P020060 Q100 R.1|G76 X50. Z-20. P1200 Q300 F2.|M30", "4:1");
    "G0641" ThreadTooShort Stop {}
        es "la rosca es más corta que su salida y la penetración por el flanco"
        en "the thread is shorter than its pull-out and the infeed along the flank"
        remedy "alargue la rosca o reduzca la salida", "make the thread longer or the pull-out shorter";
        why "La herramienta saldría antes de haber entrado.", "The tool would leave before it has gone in.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G76 P029060 Q100 R.1|G76 X40. Z-5. P1200 Q300 F2.|M30", "4:1");
    "G0642" TooManyRepeats Stop { passes: Size, most: f64 }
        es "el ciclo pide {passes} pasadas; se admiten {most}"
        en "the cycle asks for {passes} passes; {most} are allowed"
        remedy "dé menos pasadas con R", "give fewer passes with R";
        why "R de G73 es un número de pasadas, y no una distancia.", "R of G73 is a number of passes, and no distance.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G73 U2. W2. R99999|G73 P10 Q20|N10 G0 X20.|G1 Z-10.|N20 X50.|M30", "4:1");
    "G0650" RepeatPassesNotWhole Stop { value: f64 }
        es "R{value} del primer bloque de G73 no es un número de pasadas"
        en "R{value} of the first block of G73 is no number of passes"
        remedy "dé un número entero de pasadas", "give a whole number of passes";
        why "R de G73 es un número de pasadas, y no una distancia.", "R of G73 is a number of passes, and no distance.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G73 U2. W1. R2.5|G73 P10 Q20|N10 G0 X30.|G1 Z-10.|N20 X50.|M30", "4:1");
    "G0651" ThreadFirstBlockDigits Stop { value: f64 }
        es "P{value} del primer bloque de G76 no son seis cifras"
        en "P{value} of the first block of G76 is not six digits"
        remedy "dé P con dos cifras de pasadas de acabado, dos de salida y dos del ángulo: P020060",
            "give P with two digits of finishing passes, two of the pull-out and two of the angle: P020060";
        why "P lleva tres números de dos cifras: pasadas de acabado, salida y ángulo.",
            "P holds three numbers of two digits: finishing passes, pull-out and angle.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G76 P1010060 Q50 R.1|G76 X28. Z-20. P1000 Q300 F1.5|M30", "4:1");
    "G0652" ThreadWordMissing Stop { letter: char }
        es "falta {letter} en el segundo bloque de G76"
        en "{letter} is missing in the second block of G76"
        remedy "dé {letter}", "give {letter}";
        why "La altura y la primera pasada solo las dice el programa.",
            "The height and the first cut are told by the program alone.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G76 P010060 Q50 R.1|G76 X28. Z-20. Q300 F1.5|M30", "4:1");
    "G0653" FirstBlockMissing Stop { cycle: u8 }
        es "falta el primer bloque de G{cycle}"
        en "the first block of G{cycle} is missing"
        remedy "escriba G{cycle} en dos bloques: sin el primero valen parámetros del control",
            "write G{cycle} in two blocks: without the first the control's parameters hold";
        why "Los parámetros de un control no se conocen aquí.", "The parameters of a control are not known here.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G74 X40. Z0 P3000 Q1000 F.1|M30", "3:1");
    "G0654" FirstBlockWordMissing Stop { letter: char, cycle: u8 }
        es "falta {letter} en el primer bloque de G{cycle}"
        en "{letter} is missing in the first block of G{cycle}"
        remedy "dé {letter}: sin ella vale un parámetro del control",
            "give {letter}: without it a parameter of the control holds";
        why "Los parámetros de un control no se conocen aquí.", "The parameters of a control are not known here.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G76 P010060 R.1|G76 X28. Z-20. P1000 Q300 F1.5|M30", "4:1");
}
