//! The rows of drilling cycles, threads and passes.

use crate::finding::rule::rules;
use crate::finding::{Bare, Example, Size};
use crate::text::Text;

rules! {
    /// The rows of this file.
    RULES;

    "G0606" TooManyPecks Stop { most: f64 }
        es "más de {most} penetraciones en un agujero"
        en "more than {most} pecks in one hole"
        remedy "aumente Q", "increase Q";
        why "Tantas penetraciones suelen venir de un Q en otra unidad.", "So many pecks usually come from a Q in another unit.";
        example Example::program("linuxcnc", "G21 G90 F100 S500 M3|G0 Z5|G83 X0 Y0 R2 Z-50 Q0.0001|M2", "3");
    "G0730" HolePlaneNotSaid Caution {}
        es "no se ha dicho qué es R en G81 a G83: rodete la lee como la Z absoluta del plano"
        en "the meaning of R in G81 to G83 is not given: rodete reads R as the absolute Z of the plane"
        remedy "rellene hole_R en el libro (hoja DATOS), o dé --hole-r",
            "fill in hole_R in the workbook (sheet DATA), or give --hole-r";
        why "Según el control, R es la Z del plano o una distancia desde la posición de la herramienta: mal leída, la broca entra en rápido en la pieza.",
            "Depending on the control, R is the Z of the plane or a distance from the tool's position: read wrongly, the drill goes into the part at rapid.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G81 X0 Z-12. R2.|M30", "3:14");
    "G0731" HoleDwellNegative Stop {}
        es "tiempo de espera negativo"
        en "negative dwell time"
        remedy "dé un tiempo positivo", "give a positive time";
        why "El control no puede esperar un tiempo negativo.", "The control cannot wait for a negative time.";
        example Example::program("linuxcnc", "G21 G90 F100 S500 M3|G0 Z5|G82 X0 Y0 R2 Z-5 P-1|M2", "3:18");
    "G0732" HolePlaneBelowBottom Stop { r: Size, bottom: Size }
        es "R ({r}) está por debajo del fondo ({bottom})"
        en "R ({r}) is below the bottom ({bottom})"
        remedy "ponga R por encima del fondo del agujero", "put R above the bottom of the hole";
        why "La broca se retiraría hacia abajo, dentro del material.", "The drill would retract downwards, into the metal.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G81 X0 Z-10. R-20.|M30", "3");
    "G0733" PeckNotPositive Stop {}
        es "Q debe ser mayor que 0"
        en "Q must be greater than 0"
        remedy "dé la profundidad de cada penetración en µm", "give the depth of each peck in µm";
        why "Con una penetración de 0 el agujero no acabaría nunca.", "With a peck of 0 the hole would never end.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G83 X0 Z-10. R2.Q0|M30", "3:17");
    "G0734" PeckWithoutDepth Caution { depth: Size }
        es "G83 sin Q: taladra {depth} de una vez, sin evacuar la viruta"
        en "G83 without Q drills {depth} in one go, without clearing the chips"
        remedy "dé con Q la profundidad de cada penetración, en µm, o use G81",
            "give the depth of each peck with Q, in µm, or use G81";
        why "En un agujero hondo la viruta que no sale atasca la broca.",
            "In a deep hole the chips jam the drill if they do not come out.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G83 X0 Z-20. R2.|M30", "3");
    "G0735" TooManyLathePecks Stop { most: f64 }
        es "más de {most} penetraciones en un agujero"
        en "more than {most} pecks in one hole"
        remedy "aumente Q, que va en µm", "increase Q, which is in µm";
        why "El control lee Q en µm: un número pensado en mm es mil veces menor.",
            "The control reads Q in µm: a number meant in mm is a thousand times too small.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G83 X0 Z-10. R2. Q1|M30", "3:18");
    "G0736" CycleWordMissing Stop { letter: char, cycle: f64 }
        es "falta {letter} en G{cycle}"
        en "{letter} is missing in G{cycle}"
        remedy "dé {letter} en el bloque", "give {letter} in the block";
        why "Sin esa palabra el ciclo está incompleto.", "Without this word the cycle is incomplete.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G81 X0 R2.|M30", "3");
    "G0737" CycleUnderInverseTime Stop {}
        es "ciclo fijo con avance por tiempo (G93)"
        en "canned cycle with inverse time feed (G93)"
        remedy "programe G94", "program G94";
        why "G93 da el tiempo de un bloque, pero un ciclo hace muchos movimientos.",
            "G93 gives the time of one block, but a cycle makes many motions.";
        example Example::program("linuxcnc", "G21 G90 F100|G93 G81 X1 Z-1 R1 F2|M2", "2");
    "G0738" CycleMovesOtherAxis Stop {}
        es "un ciclo fijo solo mueve X, Y y Z"
        en "a canned cycle moves only X, Y and Z"
        remedy "coloque los otros ejes antes del ciclo", "position the other axes before the cycle";
        why "El ciclo no dice cuándo se moverían los demás ejes.", "The cycle does not say when the other axes would move.";
        example Example::program("linuxcnc", "G21 G90 F100|G81 X1 Z-1 R1 A5|M2", "2:15");
    "G0739" CycleRepeats Stop { value: f64, most: i64 }
        es "L{value} no es un número de agujeros"
        en "L{value} is not a number of holes"
        remedy "use L de 1 a {most}", "use L from 1 to {most}";
        why "L dice cuántos agujeros se hacen.", "L says how many holes to make.";
        example Example::program("linuxcnc", "G21 G90 F100|G81 X1 Z-1 R1 L0|M2", "2:15");
    "G0740" MillHolePlaneBelowBottom Stop { r: f64, bottom: f64 }
        es "R ({r}) está por debajo del fondo ({bottom})"
        en "R ({r}) is below the bottom ({bottom})"
        remedy "ponga R por encima del fondo del agujero", "put R above the bottom of the hole";
        why "La broca se retiraría hacia abajo, dentro del material.", "The drill would retract downwards, into the metal.";
        example Example::program("linuxcnc", "G21 G90 F100|G81 X1 Z5 R1|M2", "2");
    "G0741" ReturnHeightNotSaid Caution {}
        es "ciclo fijo sin G98 ni G99 antes: la herramienta vuelve a R, o a donde lo dejó fijado el programa anterior"
        en "canned cycle without G98 or G99 before it: the tool returns to R, or as the last program left it"
        remedy "programe G98 o G99", "program G98 or G99";
        why "Si la herramienta solo vuelve a R, puede chocar con una brida entre los agujeros.",
            "If the tool returns only to R, it may hit a clamp between the holes.";
        example Example::program("linuxcnc", "G20 G90|F10|G0 X0 Y0 Z1|G83 X1 Y1 Z-.5 R.1 Q.2|G73 X2 Y1 Z-.5 R.1 Q.2|G80|M2", "4");
    "G0742" MillPeckNotPositive Stop {}
        es "Q debe ser mayor que 0"
        en "Q must be greater than 0"
        remedy "dé la profundidad de cada penetración", "give the depth of each peck";
        why "Con una penetración de 0 el agujero no acabaría nunca.", "With a peck of 0 the hole would never end.";
        example Example::program("linuxcnc", "G21 G90 F100|G83 X1 Z-1 R1 Q0|M2", "2:15");
    "G0743" CycleSpindle Stop { cycle: f64 }
        es "G{cycle}: el husillo está parado o gira al revés"
        en "G{cycle}: the spindle is stopped or turns the wrong way"
        remedy "programe M3 o M4 antes del ciclo", "program M3 or M4 before the cycle";
        why "Un husillo parado o al revés rompe el macho, o arrastra la barra de mandrinar por la pared.",
            "A stopped or reversed spindle breaks the tap, or drags the boring bar along the wall.";
        example Example::program("linuxcnc", "G21 G90 F100|G84 X1 Z-1 R1|M2", "2");
    "G0744" TappingOutsideG17 Caution { cycle: f64 }
        es "G{cycle} fuera de G17: LinuxCNC 2.9 intercambia los ejes y rosca hacia un lado"
        en "G{cycle} outside G17: LinuxCNC 2.9 swaps the axes and taps sideways"
        remedy "rodete rosca según el eje del plano; en ese control, rosque en G17",
            "rodete taps along the axis of the plane; on that control, tap in G17";
        why "Ese control mueve el eje equivocado, y el macho entra de lado.",
            "That control moves the wrong axis, and the tap goes in sideways.";
        example Example::program("linuxcnc", "G21 G90 G18 F100 S500 M3|G0 Y5|G99 G84 X0 Z0 R2 Y-5|M2", "3");
    "G0745" TakenOutByHand Caution {}
        es "G88: el operario saca la herramienta a mano"
        en "G88: the operator takes the tool out by hand"
        remedy "", "";
        why "El programa espera a que el operario la saque.", "The program waits until the operator has done so.";
        example Example::program("linuxcnc", "(G88: down at feed, wait, stop; the operator draws the tool out)|G21 G90|F100|G0 X-5 Y-5 Z20|M3 S100|G99 G88 X1 Y2 Z-10 R5 P0.5|X10 P1|G98 G88 X20 Y5 Z-10 R5 P0|G80|M4|G91 G88 X1 Z-10 R5 P1 L3|G80|M2", "6");
    "G0746" LeadZero Stop {}
        es "rosca de paso 0"
        en "thread with lead 0"
        remedy "dé el paso con F", "give the lead with F";
        why "Sin paso la herramienta no avanza.", "Without a lead the tool does not advance.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G32 Z-20. F0|M30", "3:11");
    "G0747" LeadMissing Stop {}
        es "rosca sin su paso F"
        en "thread without its lead F"
        remedy "dé el paso con F", "give the lead with F";
        why "En una rosca F es el paso, y un avance anterior no lo es.",
            "In a thread F is the lead, and an earlier feed is not a lead.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G32 Z-20.|M30", "3");
    "G0748" StartAngle Stop { value: f64 }
        es "Q{value} no es el ángulo inicial de una rosca"
        en "Q{value} is not the start angle of a thread"
        remedy "use Q de 0 a 360000, en milésimas de grado: Q180000 es media vuelta",
            "use Q from 0 to 360000, in thousandths of a degree: Q180000 is half a turn";
        why "Más de una vuelta suele ser un Q en otra unidad.", "More than one turn usually means a Q in another unit.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G32 Z-20. F1.5 Q400000|M30", "3:16");
    "G0749" StartAngleForgotten Caution {}
        es "esta pasada de la rosca empieza a 0°, y las anteriores en otro ángulo: Q solo vale en su bloque"
        en "this thread pass begins at 0°, and the passes before at another angle: Q counts only in its own block"
        remedy "repita Q en cada pasada", "repeat Q in each pass";
        why "La pasada corta entre los hilos ya hechos.", "The pass cuts between the threads already cut.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G92 X49. Z-20. F2. Q90000|X48. Q90000|X47.|M30", "5");
    "G0750" LeadChangeMissing Stop {}
        es "falta K en G34: cuánto cambia el paso por vuelta"
        en "K is missing in G34: the change of lead per revolution"
        remedy "dé K en el bloque, o use G32", "give K in the block, or use G32";
        why "G34 corta una rosca de paso variable.", "G34 cuts a thread whose lead changes.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G34 Z-20. F2.|M30", "3:1");
    "G0751" LeadRunsOut Stop { length: Size }
        es "el paso llega a 0 a {length} del principio, antes del final"
        en "the lead falls to 0 after {length}, before the end"
        remedy "disminuya K o acorte la rosca", "reduce K, or shorten the thread";
        why "A partir de ese punto la herramienta retrocedería.", "From that point on the tool would go backwards.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G34 Z-20. F2. K-.1|M30", "3:15");
    "G0752" BareG90 Caution {}
        es "G90 sin X ni Z: en el sistema A es el ciclo de torneado; rodete no mueve nada y lo deja en vigor hasta G0 o G1"
        en "G90 without X and Z: in system A this is the turning cycle; rodete moves nothing and keeps it in force until G0 or G1"
        remedy "quite G90: X y Z son siempre absolutas, U y W incrementales",
            "delete G90: X and Z are always absolute, U and W are always increments";
        why "Fuera del sistema A, G90 son cotas absolutas; aquí el bloque siguiente con X y Z haría una pasada de torneado.",
            "Elsewhere G90 means absolute dimensions; here the next block with X and Z would make a turning pass.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G90|G0 X60.|M30", "3:1");
    "G0753" PassEndMissing Stop { words: Text, cycle: u8 }
        es "en G{cycle}, que aquí es un ciclo de torneado, falta: {words}"
        en "{words} missing in G{cycle}, which here is a turning cycle"
        remedy "dé el final de la pasada; las cotas absolutas son X y Z, las incrementales U y W",
            "give the end of the pass; X and Z are absolute, U and W are increments";
        why "Sin el punto final la pasada está incompleta.", "Without its end point the pass is incomplete.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G90 R1.|M30", "3:1");
    "G0754" PassBeginsBeyondStart Stop { taper: Bare, cycle: u8, infeed: Size }
        es "con R{taper}, G{cycle} empieza la pasada más allá del punto de partida"
        en "with R{taper}, G{cycle} begins the pass beyond the start point"
        remedy "si R va contra la entrada, no puede ser mayor que ella: {infeed}",
            "if R points against the infeed, make it no greater than the infeed: {infeed}";
        why "La herramienta pasaría en rápido del punto de partida y entraría en la pieza.",
            "The tool would go in rapid past its start point, into the work.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G90 X40. Z-20. R9.|M30", "3:16");
    "G0755" SpeedLimitWithPass Stop {}
        es "G92 con S no limita aquí el giro: en este sistema de códigos G, G92 es un ciclo de roscado"
        en "G92 with S does not limit the speed here: in this system of G codes, G92 is a threading cycle"
        remedy "limite el giro con G50 S", "limit the speed with G50 S";
        why "Sin límite, con G96 el husillo se embala cerca del eje.",
            "Without a limit, G96 lets the spindle run up near the axis.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G92 S2500|M30", "2:1");
}
