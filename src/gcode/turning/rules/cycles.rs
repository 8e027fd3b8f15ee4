//! The rows of Fanuc's turning cycles.

use crate::finding::rule::rules;
use crate::finding::{Example, Size};
use crate::text::t;

/// What the interpreter rejects before the cycle is worked out.
const fn given(key: &'static str) -> Example {
    Example::Made {
        key,
        how: t(
            "un ciclo que no viene de un programa: al leerlo, el intérprete lo rechaza antes",
            "a cycle that comes from no program: the interpreter rejects it first, on reading it",
        ),
    }
}

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
        remedy "numere los bloques del contorno; Q va después de P", "number the blocks of the contour; Q comes after P";
        why "Sin contorno el ciclo no sabe qué cortar.", "Without a contour the cycle does not know what to cut.";
        example given("given-no-contour");
    "G0617" ContourBackAlongZ Stop alarm Fanuc 64 {}
        es "el contorno cambia de sentido en Z"
        en "the contour reverses along Z"
        remedy "haga que el contorno vaya siempre en un mismo sentido en Z, o divida el desbaste en dos",
            "make the contour go one way along Z, or split the roughing in two";
        why "Una pasada cortaría material que el contorno debe dejar.", "A pass would cut material that the contour must leave.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 G0 X30.|G1 Z-10.|X32. Z-5.|N20 X50. Z-12.|M30", "7");
    "G0618" ContourBeginsWithArc Stop alarm Fanuc 65 {}
        es "el primer bloque del contorno no es G0 ni G1"
        en "the first block of the contour is not G0 or G1"
        remedy "lleve la herramienta al contorno con G0 o G1", "take the tool to the contour with G0 or G1";
        why "El primer bloque solo lleva la herramienta al contorno.",
            "The first block only takes the tool to the contour.";
        example given("given-arc-first");
    "G0619" ThreadLeadNotPositive Stop alarm Fanuc 313 {}
        es "el paso de la rosca es 0 o negativo"
        en "the lead of the thread is zero or negative"
        remedy "dé el paso con F", "give the lead with F";
        why "Sin paso la herramienta no avanza.", "Without a lead the tool does not advance.";
        example given("given-cycle-lead");
    "G0620" ThreadAngle Stop alarm Fanuc 315 {}
        es "ángulo de la punta no admitido en el roscado"
        en "tip angle not allowed in threading"
        remedy "use un ángulo de 0, 29, 30, 55, 60 u 80 grados", "use an angle of 0, 29, 30, 55, 60 or 80 degrees";
        why "El control solo conoce los ángulos de las roscas normalizadas.",
            "The control knows only the angles of standard threads.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G76 P010045 Q50 R.1|G76 X28. Z-20. P1000 Q300 F1.5|M30", "4:1");
    "G0621" ThreadLeastCut Stop alarm Fanuc 316 {}
        es "la pasada mínima de la rosca es negativa o mayor que su altura"
        en "the thread's minimum depth of cut is negative or greater than its height"
        remedy "dé una pasada mínima menor que la altura", "give a minimum depth of cut below the height";
        why "El control lee la pasada mínima en µm: un punto decimal de más la hace mil veces mayor.",
            "The control reads the minimum depth of cut in µm: an extra decimal point makes it a thousand times larger.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G76 P020060 Q9000 R.1|G76 X40. Z-20. P1200 Q300 F2.|M30", "4:1");
    "G0622" ThreadWithoutHeight Stop alarm Fanuc 317 {}
        es "la altura de la rosca o la primera pasada es 0 o negativa"
        en "the height of the thread or its first cut is zero or negative"
        remedy "dé P (altura) y Q (primera pasada) mayores que 0", "give P (height) and Q (first cut) above 0";
        why "La altura y la primera pasada determinan todas las demás.",
            "The height and the first cut determine all the other passes.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G76 P010060 Q50 R.1|G76 X28. Z-20. P0 Q300 F1.5|M30", "4:1");
    "G0623" GrooveReliefNegative Stop alarm Fanuc 318 {}
        es "la separación en el fondo es negativa, pero su sentido ya está dado"
        en "the relief at the bottom is negative, but its direction is already given"
        remedy "dé R positivo", "give a positive R";
        why "La herramienta se movería contra la pared que acaba de cortar.",
            "The tool would move against the wall that it has just cut.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G75 R1.|G75 X30. Z-10. P2000 Q2000 R-1.|M30", "4:1");
    "G0624" GrooveStepZero Stop alarm Fanuc 319 {}
        es "el paso es 0, pero el ciclo debe recorrer una distancia en ese eje"
        en "the step is zero, but the cycle has a distance to cover along that axis"
        remedy "dé P y Q mayores que 0", "give P and Q above 0";
        why "Con pasos de 0 el ranurado no acabaría nunca.", "With steps of 0 the grooving would never end.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G75 R.5|G75 X40. Z0 P3000 F.1|M30", "4:1");
    "G0625" GrooveStepNegative Stop alarm Fanuc 320 {}
        es "el paso del ranurado es negativo"
        en "the step of the grooving is negative"
        remedy "escriba P y Q sin signo", "write P and Q without a sign";
        why "El sentido lo dan los puntos, no el signo.", "The points give the direction, not the sign.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G75 R1.|G75 X30. Z-10. P-2000 Q2000|M30", "4:1");
    "G0626" RepeatWithoutPasses Stop alarm Fanuc 321 {}
        es "el número de pasadas de G73 es 0 o negativo"
        en "the number of passes of G73 is zero or negative"
        remedy "dé con R el número de pasadas", "give the number of passes with R";
        why "G73 reparte la demasía entre las pasadas.", "G73 divides the stock among its passes.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G73 U2. W1. R0|G73 P10 Q20|N10 G0 X30.|G1 Z-10.|N20 X50.|M30", "4:1");
    "G0627" ContourBeyondStart Stop alarm Fanuc 322 {}
        es "el contorno pasa del punto de comienzo del ciclo"
        en "the contour reaches beyond the starting point of the cycle"
        remedy "comience el ciclo fuera del bruto, más allá de todo el contorno",
            "start the cycle outside the stock, beyond the whole contour";
        why "Las pasadas empiezan en ese punto, y las idas en rápido atravesarían el material.",
            "The passes begin at that point, and the rapid motions would go through metal.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 G0 X20.|G1 Z-10.|N20 X70. Z-20.|M30", "7");
    "G0628" ContourBackAlongX Stop alarm Fanuc 329 {}
        es "el contorno cambia de sentido en X"
        en "the contour reverses along X"
        remedy "haga que el contorno vaya siempre en un mismo sentido en X; con bolsas en G71, mueva X y Z en el primer bloque",
            "make the contour go one way along X; for pockets in G71, move X and Z in the first block";
        why "El primer bloque le dice al ciclo que el contorno tiene bolsas.",
            "The first block tells the cycle that the contour has pockets.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 G0 X30.|G1 Z-10.|X20. Z-20.|N20 X50.|M30", "7");
    "G0630" ContourDoesNotAdvance Stop {}
        es "el contorno no avanza en el sentido de las pasadas"
        en "the contour does not advance in the direction of the passes"
        remedy "programe un bloque que llegue al contorno y los bloques que lo recorren",
            "program a block that leads to the contour and the blocks that run along it";
        why "Si el contorno no avanza a lo largo de las pasadas, no hay nada que desbastar.",
            "A contour that does not advance along the passes leaves nothing to rough.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20|N10 G0 X20.|N20 G1 X30.|M30", "6");
    "G0631" CycleNotFinite Stop {}
        es "un parámetro del ciclo no es un número finito"
        en "a parameter of the cycle is not a finite number"
        remedy "dé números que el control admita", "give numbers that the control accepts";
        why "Un número infinito no es una cota.", "An infinite number is not a dimension.";
        example given("given-endless-depth");
    "G0632" RetractionNegative Stop {}
        es "la retirada R es negativa"
        en "the retraction R is negative"
        remedy "dé R sin signo", "give R without a sign";
        why "La herramienta se retiraría hacia el material.", "The tool would retract into the metal.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G71 U2. R-1.|G71 P10 Q20|N10 G0 X20.|G1 Z-10.|N20 X50.|M30", "4:1");
    "G0633" AllowanceIntoMetal Stop {}
        es "la demasía de acabado apunta hacia el metal, tal como están el punto de comienzo y el contorno: el desbaste cortaría la pieza"
        en "the finishing allowance points into the metal, as starting point and contour lie: roughing would cut the part"
        remedy "compruebe el punto de comienzo y el primer bloque del contorno, que va de él al contorno; si son los debidos, cambie el signo de U o W: la demasía va del contorno hacia el punto de comienzo",
            "check the starting point and the contour's first block, which leads from there to the contour; if both are right, change the sign of U or W: the allowance goes from the contour towards the starting point";
        why "El acabado no puede reponer lo que el desbaste ha quitado.",
            "Finishing cannot put back what roughing has removed.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20 U-1.|N10 G0 X20.|G1 Z-10.|N20 X50.|M30", "4:1");
    "G0634" TooManyRoughingPasses Stop { passes: Size, most: f64 }
        es "el ciclo pide {passes} pasadas; el límite es {most}"
        en "the cycle asks for {passes} passes; the limit is {most}"
        remedy "aumente la profundidad de pasada", "increase the depth of cut";
        why "Tantas pasadas suelen venir de una cota en otra unidad.", "So many passes usually come from a dimension in another unit.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X900. Z5.|G71 U.002 R1.|G71 P10 Q20|N10 G0 X1.|G1 Z-10.|N20 X900.|M30", "4:1");
    "G0635" GrooveWithoutDepth Stop {}
        es "el ranurado no tiene profundidad"
        en "the grooving has no depth"
        remedy "ponga el punto final más allá del punto de comienzo", "put the end point beyond the starting point";
        why "Sin profundidad la herramienta no corta.", "Without a depth the tool does not cut.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G75 R1.|G75 X50. Z-10. P2000 Q2000|M30", "4:1");
    "G0636" TooManyGrooveSteps Stop { passes: Size, most: f64 }
        es "el ciclo pide {passes} pasadas; el límite es {most}"
        en "the cycle asks for {passes} passes; the limit is {most}"
        remedy "aumente P o Q", "increase P or Q";
        why "El control lee P y Q en µm: un número pensado en mm es mil veces menor.",
            "The control reads P and Q in µm: a number meant in mm is a thousand times too small.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G75 R1.|G75 X10. Z-30. P1 Q1|M30", "4:1");
    "G0637" TooManyThreadPasses Stop { passes: Size, most: f64 }
        es "el ciclo pide {passes} pasadas; el límite es {most}"
        en "the cycle asks for {passes} passes; the limit is {most}"
        remedy "aumente la pasada mínima o la primera pasada", "increase the minimum depth of cut or the first cut";
        why "El control lee la primera pasada en µm, y cada pasada quita la misma sección.",
            "The control reads the first cut in µm, and each pass removes the same section.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G76 P020060 Q0 R.1|G76 X40. Z-20. P1200 Q1 F2.|M30", "4:1");
    "G0638" ThreadAllowance Stop {}
        es "la demasía de acabado es negativa o no es menor que la altura de la rosca"
        en "the finishing allowance is negative, or not below the thread's height"
        remedy "dé en el primer bloque una R menor que P", "give an R below P in the first block";
        why "Las pasadas de acabado quitan esa demasía.", "The finishing passes remove that allowance.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G76 P020060 Q100 R2.|G76 X40. Z-20. P1200 Q300 F2.|M30", "4:1");
    "G0639" ThreadDigits Stop {}
        es "P del primer bloque de G76 se sale de sus límites: pasadas de acabado de 1 a 99, salida de 0 a 99 décimas del paso"
        en "P of the first G76 block is out of range: 1 to 99 finishing passes, pull-out of 0 to 99 tenths of the lead"
        remedy "dé P con seis cifras: mmrraa", "give P with six digits: mmrraa";
        why "P lleva tres números de dos cifras: si falta una cifra, cambian los tres.",
            "P holds three numbers of two digits: if one digit is missing, all three change.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G76 P000060 Q100 R.1|G76 X40. Z-20. P1200 Q300 F2.|M30", "4:1");
    "G0640" ThreadStartsInside Stop {}
        es "el ciclo comienza dentro de la rosca: la herramienta volvería a través de ella"
        en "the cycle starts inside the thread: the tool would return through it"
        remedy "comience más allá de la cresta, en los dos extremos si la rosca es cónica",
            "start beyond the crest, at both ends if the thread is tapered";
        why "Cada pasada vuelve en rápido por el diámetro de comienzo.",
            "Each pass returns in rapid at the starting diameter.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G76 P020060 Q100 R.1|G76 X50. Z-20. P1200 Q300 F2.|M30", "4:1");
    "G0641" ThreadTooShort Stop {}
        es "la rosca es más corta que su salida más la penetración por el flanco"
        en "the thread is shorter than its pull-out plus the infeed along the flank"
        remedy "alargue la rosca o reduzca la salida", "make the thread longer or the pull-out shorter";
        why "La herramienta saldría antes de haber entrado.", "The tool would pull out before it has gone in.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G76 P029060 Q100 R.1|G76 X40. Z-5. P1200 Q300 F2.|M30", "4:1");
    "G0642" TooManyRepeats Stop { passes: Size, most: f64 }
        es "el ciclo pide {passes} pasadas; el límite es {most}"
        en "the cycle asks for {passes} passes; the limit is {most}"
        remedy "dé menos pasadas con R", "give fewer passes with R";
        why "R de G73 es un número de pasadas, no una distancia.", "R of G73 is a number of passes, not a distance.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G73 U2. W2. R99999|G73 P10 Q20|N10 G0 X20.|G1 Z-10.|N20 X50.|M30", "4:1");
    "G0643" ContourEntersAside Stop alarm Fanuc 65 { cycle: u8, axis: char, other: u8 }
        es "el primer bloque del contorno tiene que mover {axis}: G{cycle} entra en {axis}"
        en "the first block of the contour must move {axis}: G{cycle} goes in along {axis}"
        remedy "mueva {axis} en ese bloque, o use G{other}", "move {axis} in that block, or use G{other}";
        why "G71 desbasta a lo largo de Z y entra en X; G72 desbasta a lo largo de X y entra en Z.",
            "G71 roughs along Z and goes in along X; G72 roughs along X and goes in along Z.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G72 W2. R1.|G72 P10 Q20 U.4 W.1|N10 G0 X20.|G1 Z-10.|N20 X50.|M30", "5");
    "G0644" PlungesApart Caution { number: u8, step: Size, width: Size }
        es "G{number}: la herramienta entra cada {step} y mide {width} de ancho: entre las entradas queda material"
        en "G{number}: the tool goes in every {step} and the blade is {width} wide: metal stays between the plunges"
        remedy "reduzca el paso por debajo del ancho de la herramienta de ranurar, o llame a una más ancha",
            "make the step smaller than the blade is wide, or call a wider one";
        why "Entre dos entradas queda un anillo: si es delgado se rompe, y lo que debía ser una ranura no lo es. Si quiere varias ranuras, está bien.",
            "Between two plunges a ring stays: a thin one breaks off, and what was meant as one groove is not one. If several grooves are meant, all is well.";
        example Example::Turning { control: "fanuc-lathe-a", stock: "D50xL120",
            program: "G50 S2500|T0303|G97 S500 M3|M8|G0 X54. Z-20.|G75 R1.|G75 X40. Z-28. P2000 Q8000 F0.1|G0 X100. Z50. M9|M30", machine: &[] };
    "G0650" RepeatPassesNotWhole Stop { value: f64 }
        es "R{value} del primer bloque de G73 no es un número de pasadas"
        en "R{value} in the first block of G73 is not a number of passes"
        remedy "dé un número entero de pasadas", "give a whole number of passes";
        why "R de G73 es un número de pasadas, no una distancia.", "R of G73 is a number of passes, not a distance.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G73 U2. W1. R2.5|G73 P10 Q20|N10 G0 X30.|G1 Z-10.|N20 X50.|M30", "4:1");
    "G0651" ThreadFirstBlockDigits Stop { value: f64 }
        es "P{value} del primer bloque de G76 no tiene seis cifras"
        en "P{value} in the first block of G76 does not have six digits"
        remedy "dé P con dos cifras para las pasadas de acabado, dos para la salida y dos para el ángulo: P020060",
            "give P with two digits each for finishing passes, pull-out and angle: P020060";
        why "P lleva tres números de dos cifras: pasadas de acabado, salida y ángulo.",
            "P holds three numbers of two digits: finishing passes, pull-out and angle.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G76 P1010060 Q50 R.1|G76 X28. Z-20. P1000 Q300 F1.5|M30", "4:1");
    "G0652" ThreadWordMissing Stop { letter: char }
        es "falta {letter} en el segundo bloque de G76"
        en "{letter} is missing in the second block of G76"
        remedy "añada {letter}", "add {letter}";
        why "Solo el programa da la altura y la primera pasada.",
            "Only the program gives the height and the first cut.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G76 P010060 Q50 R.1|G76 X28. Z-20. Q300 F1.5|M30", "4:1");
    "G0653" FirstBlockMissing Stop { cycle: u8 }
        es "falta el primer bloque de G{cycle}"
        en "the first block of G{cycle} is missing"
        remedy "escriba G{cycle} en dos bloques: sin el primero, el control usa sus parámetros",
            "write G{cycle} in two blocks: without the first one the control uses its parameters";
        why "rodete no conoce los parámetros del control.", "rodete does not know the control's parameters.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G74 X40. Z0 P3000 Q1000 F.1|M30", "3:1");
    "G0654" FirstBlockWordMissing Stop { letter: char, cycle: u8 }
        es "falta {letter} en el primer bloque de G{cycle}"
        en "{letter} is missing in the first block of G{cycle}"
        remedy "añada {letter}: sin ella el control usa un parámetro suyo",
            "add {letter}: without it the control uses one of its parameters";
        why "rodete no conoce los parámetros del control.", "rodete does not know the control's parameters.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G76 P010060 R.1|G76 X28. Z-20. P1000 Q300 F1.5|M30", "4:1");
    "G0655" FirstBlockUnused Caution { cycle: u8 }
        es "a este primer bloque de G{cycle} no le sigue el segundo: no se mecaniza nada"
        en "no second block follows this first block of G{cycle}: nothing is cut"
        remedy "escriba el segundo bloque de G{cycle}: G71 a G73 con P y Q, G74 a G76 con X o Z",
            "write the second block of G{cycle}: G71 to G73 with P and Q, G74 to G76 with X or Z";
        why "Si el bloque debía mecanizar, lo que sigue avanza sin desbaste, a toda la profundidad.",
            "If the block was meant to cut, what follows goes in without roughing, at the full depth.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 U.4 W.1 F.2|G0 X60.|M30", "3");
    "G0656" AllowanceIntoWall Caution {}
        es "la demasía lleva el desbaste dentro de esta pared, que mira hacia el otro lado"
        en "the allowance moves roughing into this wall, which faces the other way"
        remedy "deje sin demasía el eje de las pasadas (W0 en G71, U0 en G72) donde el contorno tiene una cavidad",
            "leave no allowance along the passes (W0 in G71, U0 in G72) where the contour has a pocket";
        why "La demasía desplaza todo el contorno hacia el punto de comienzo: la pared del otro lado de una cavidad queda cortada por debajo de su medida.",
            "The allowance moves the whole contour towards the starting point: the far wall of a pocket is cut below its size.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X62. Z2.|G71 U4. R.5|G71 P10 Q20 U.4 W.1|N10 G0 X40. Z2.|G1 Z-10.|X50.|Z-20.|X42.|Z-30.|N20 X62.|M30", "8");
    "G0657" RepeatIntoMetal Stop {}
        es "la primera o la última pasada de G73 va por debajo del contorno"
        en "the first or the last pass of G73 runs below the contour"
        remedy "compruebe los signos de U y W en los dos bloques: retirada y demasía van del contorno hacia el punto de comienzo",
            "check the signs of U and W in both blocks: relief and allowance go from the contour towards the starting point";
        why "El acabado no puede reponer lo que el desbaste ha quitado.",
            "Finishing cannot put back what roughing has removed.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X62. Z2.|G73 U5. W2. R2|G73 P10 Q20 U-.4 W-.1|N10 G0 X40. Z0|G1 Z-10.|N20 X62.|M30", "4:1");
    "G0658" ThreadInOnePass Caution { first: Size, height: Size }
        es "G76 corta la rosca en una pasada: la primera entra {first}, y la altura es de {height}"
        en "G76 cuts the thread in one pass: the first one goes in by {first}, and the height is {height}"
        remedy "compruebe P (altura) y Q (primera pasada): sin punto, cuentan incrementos mínimos",
            "check P (height) and Q (first cut): without a point they count least increments";
        why "Un cero de más o de menos en P o Q, y la herramienta entra de una vez en toda la rosca y se rompe.",
            "A zero too many or too few in P or Q, and the tool goes into the whole thread at once and breaks.";
        example Example::program("fanuc-lathe-a", "G21 T0101 S500 M3|G0 X24. Z4.|G76 P020060 Q50 R.05|G76 X17.84 Z-20. P1080 Q4000 F1.75|M30", "4:24");
}
