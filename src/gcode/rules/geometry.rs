//! What is wrong with arcs, planes, axes and work offsets.

use crate::finding::rule::rules;
use crate::finding::{Example, Size};
use crate::text::Text;

rules! {
    /// The rows of this file.
    RULES;

    "G0401" ArcWithoutCentre Stop {}
        es "arco sin centro (I J K) ni radio R"
        en "arc without a centre (I J K) or radius R"
        remedy "dé el centro o el radio", "give the centre or the radius";
        why "Por dos puntos pasan infinitos arcos.",
            "Infinitely many arcs pass through two points.";
        example Example::program("linuxcnc", "G21 G90 F100|G2 X1 Y1|M2", "2");
    "G0402" ArcTwoForms Stop {}
        es "arco con centro y también con radio R"
        en "arc with both a centre and a radius R"
        remedy "deje uno de los dos", "leave one of the two";
        why "El centro y el radio pueden no coincidir: unos controles usan uno y otros el otro.",
            "Centre and radius may disagree: some controls use one, others the other.";
        example Example::program("linuxcnc", "G21 G90 F100|G2 X1 Y1 I1 R1|M2", "2:13");
    "G0403" HelixPitch Stop { word: char, plane: &'static str, axis: char }
        es "{word} es en {plane} el paso de una hélice, que rodete no admite"
        en "{word} is the pitch of a helix in {plane}, which rodete does not follow"
        remedy "escriba la hélice vuelta a vuelta, con su {axis} y sin {word}; si el arco es de otro plano, prográmelo antes (G17, G18 o G19)", "write the helix turn by turn, with its {axis} and without {word}; if the arc is in another plane, program that plane before it (G17, G18 or G19)";
        why "Este control escribe así una hélice de varias vueltas; rodete no la simula.",
            "This control writes a helix of several turns this way; rodete does not simulate it.";
        example Example::program("fagor-8055", "G17 G90 G1 X0 Y0 F100|G2 X10 Y0 Z5 I5 J0 K2|M30", "2:20");
    "G0404" HelixPitchNotPositive Stop { word: char, value: f64, plane: &'static str }
        es "{word}{value}: en {plane} {word} es el paso de una hélice, mayor que 0 (error 0054)"
        en "{word}{value}: {word} is the pitch of a helix in {plane}, above 0 (error 0054)"
        remedy "quite {word}; si el arco es de otro plano, prográmelo antes (G17, G18 o G19)", "take {word} out; if the arc is in another plane, program that plane before it (G17, G18 or G19)";
        why "El control se para con su error 0054.",
            "The control stops with its error 0054.";
        example Example::program("fagor-8055", "G17 G90 G1 X0 Y0 F100|G2 X10 Y0 I5 J0 K0|M30", "2:17");
    "G0405" CentreWordOfOtherPlane Caution { word: char, plane: &'static str }
        es "{word}0 en un arco de {plane}: rodete lo ignora; no se ha podido consultar qué hace el control"
        en "{word}0 in an arc of {plane}: rodete ignores it; what the control does could not be looked up"
        remedy "quite {word}", "take {word} out";
        why "Un 0 no cambia el arco, pero el control puede pararse en él.",
            "A 0 does not change the arc, but the control may stop at it.";
        example Example::program("fagor-8055-t", "G1 X20 Z0 F100|G2 X30 Z-5 I5 J0 K0|M30", "2:15");
    "G0406" CentreWordForeign Stop { word: char, plane: &'static str, first: char, second: char }
        es "{word} no pertenece al plano {plane}"
        en "{word} does not belong to the plane {plane}"
        remedy "use {first} y {second}, o cambie de plano", "use {first} and {second}, or change the plane";
        why "El centro se da en los ejes del plano: otra letra no lo sitúa.",
            "The centre is given along the axes of the plane: another letter does not locate it.";
        example Example::program("linuxcnc", "G21 G90 F100|G2 X1 Y1 I1 K1|M2", "2:13");
    "G0407" RadiusWithoutEnd Stop { first: char, second: char }
        es "arco con R sin {first} ni {second}"
        en "arc with R without {first} or {second}"
        remedy "dé el punto final", "give the end point";
        why "Con el radio solo no se sabe dónde acaba el arco.",
            "With the radius alone it is not clear where the arc ends.";
        example Example::program("linuxcnc", "G21 G90 F100|G2 R1|M2", "2:4");
    "G0408" TurnsNotWhole Stop { turns: f64 }
        es "P{turns} no es un número de vueltas"
        en "P{turns} is not a number of turns"
        remedy "use un número entero, 1 o más", "use a whole number from 1 up";
        why "Un arco da vueltas enteras y después el resto hasta su final.",
            "An arc makes whole turns, then the rest up to its end.";
        example Example::program("linuxcnc", "G21 G90 F100|G2 X1 Y0 I0.5 P1.5|M2", "2:15");
    "G0409" AbsoluteCentreHalf Stop { word: char }
        es "falta {word} en un arco de centro absoluto"
        en "{word} is missing in an arc with absolute centre"
        remedy "dé las dos coordenadas del centro", "give both coordinates of the centre";
        why "Con centros absolutos, una coordenada que falta no vale 0: su valor no se conoce.",
            "With absolute centres a missing coordinate is not 0, and its value is not known.";
        example Example::program("linuxcnc", "G21 G90 F100|G90.1|G2 X1 Y0 I0.5|M2", "3");
    "G0410" RadiusOfFullCircle Stop {}
        es "arco con R cuyo final es su principio"
        en "arc with R whose end is its start"
        remedy "programe el círculo con I, J o K", "program the circle with I, J or K";
        why "Por un punto pasan infinitos círculos de ese radio.",
            "Infinitely many circles of that radius pass through one point.";
        example Example::program("linuxcnc", "G21 G90 F100|G2 X0 Y0 R1|M2", "2:10");
    "G0411" RadiusTooSmall Stop { radius: Size, half: Size, least: Size }
        es "radio {radius} demasiado pequeño: media cuerda {half}"
        en "radius {radius} too small to reach the end: half the chord is {half}"
        remedy "use un R de {least} como mínimo, o dé el centro", "use an R of at least {least}, or give the centre";
        why "Un arco de ese radio no llega de un punto al otro.",
            "An arc of that radius does not reach from one point to the other.";
        example Example::program("linuxcnc", "G21 G90 F100|G2 X10 Y0 R1|M2", "2:11");
    "G0412" ArcOfNoRadius Stop { start: Size, end: Size }
        es "arco de radio cero: r1 {start}, r2 {end}"
        en "zero-radius arc: r1 {start}, r2 {end}"
        remedy "compruebe el centro", "check the centre";
        why "Un arco sin radio no es un movimiento: su centro está en la herramienta.",
            "An arc without a radius is not a motion: its centre is at the tool.";
        example Example::program("linuxcnc", "G21 G90 F100|G2 X0 Y0 I0 J0|M2", "2");
    "G0413" EndOffCircle Stop { start: Size, end: Size, difference: Size }
        es "el final no está en el círculo: r1 {start}, r2 {end}, diferencia {difference}"
        en "the end is not on the circle: r1 {start}, r2 {end}, difference {difference}"
        remedy "compruebe el final y el centro", "check the end and the centre";
        why "El control se para, o salta al final y deja un escalón en la pieza.",
            "The control stops, or jumps to the end and leaves a step in the part.";
        example Example::program("linuxcnc", "G21 G90 F100|G2 X1 Y1 I1 J0.5|M2", "2");
    "G0414" ToolTableLoaded Note {}
        es "G10 L0 recarga la tabla de herramientas: rodete sigue con la tabla que se le dio"
        en "G10 L0 reloads the tool table: rodete keeps the table that was given"
        remedy "", "";
        why "La tabla del control puede ser ya otra.",
            "The control's table may be different by then.";
        example Example::program("linuxcnc", "G21 G90 F100|G10 L0|M2", "2:1");
    "G0415" OffsetsWithoutL Stop {}
        es "G10 sin L1, L2, L10, L11 o L20"
        en "G10 without L1, L2, L10, L11 or L20"
        remedy "añada L", "add L";
        why "L dice qué tabla hay que cambiar.",
            "L says which table to change.";
        example Example::program("linuxcnc", "G21 G90 F100|G10 P1 X0|M2", "2:1");
    "G0416" OffsetsWithoutP Stop {}
        es "G10 sin P"
        en "G10 without P"
        remedy "añada P", "add P";
        why "P dice qué fila de la tabla hay que cambiar.",
            "P says which row of the table to change.";
        example Example::program("linuxcnc", "G21 G90 F100|G10 L2 X0|M2", "2:1");
    "G0417" OffsetsPNotWhole Stop { number: f64 }
        es "P{number} de G10 no es un número entero desde 0"
        en "P{number} of G10 is not a whole number from 0 up"
        remedy "dé un número entero", "give a whole number";
        why "Las filas de la tabla llevan números enteros.",
            "The table's rows have whole numbers.";
        example Example::program("linuxcnc", "G21 G90 F100|G10 L2 P1.5 X0|M2", "2:1");
    "G0418" OffsetsPTooGreat Stop { number: u32 }
        es "P{number} en G10 L2 o L20 no es un decalaje de origen"
        en "P{number} in G10 L2 or L20 is not a work offset"
        remedy "use de 1 a 9, o 0 para el activo", "use 1 to 9, or 0 for the active offset";
        why "El control solo tiene nueve decalajes de origen.",
            "The control has only nine work offsets.";
        example Example::program("linuxcnc", "G21 G90 F100|G10 L2 P10 X0|M2", "2:1");
    "G0419" OffsetsWithTurning Stop {}
        es "I, J o Q en G10 L2 o L20"
        en "I, J or Q in G10 L2 or L20"
        remedy "quítelas", "take them out";
        why "I, J y Q son de herramientas de torno, no de decalajes de origen.",
            "I, J and Q belong to turning tools, not to work offsets.";
        example Example::program("linuxcnc", "G21 G90 F100|G10 L2 P1 I5|M2", "2:1");
    "G0420" OffsetsRotation Stop {}
        es "R en G10 L20"
        en "R in G10 L20"
        remedy "gire el sistema con G10 L2 R", "rotate the system with G10 L2 R";
        why "L20 mide desde la posición de la herramienta, y ahí un giro no tiene sentido.",
            "L20 measures from the tool's position, and a rotation makes no sense there.";
        example Example::program("linuxcnc", "G21 G90 F100|G10 L20 P1 X0 R5|M2", "2:1");
    "G0421" RotationWithG92 Caution {}
        es "G10 gira el sistema activo con G92 en vigor: LinuxCNC 2.9 olvida G92 en el movimiento siguiente y llega a otro sitio"
        en "G10 rotates the active system while G92 is in force: LinuxCNC 2.9 forgets G92 in the next motion and goes to another place"
        remedy "rodete mantiene G92 en vigor; programe G92.1 antes de este bloque y G92 después", "rodete keeps G92 in force; program G92.1 before this block and G92 after it";
        why "El control va a un sitio distinto del que dice el programa.",
            "The control goes to another place than the program says.";
        example Example::program("linuxcnc", "G21 G90 F100|G92 X5|G10 L2 P1 R5|G92.1|M2", "3:11");
    "G0422" AxesOrSpeed Stop {}
        es "dé palabras de eje o S: una de las dos cosas, no ambas"
        en "give either axis words or S: one of them, not both"
        remedy "escriba dos bloques", "write two blocks";
        why "El bloque fija la posición o el límite de giro, no las dos cosas.",
            "The block sets either the position or the speed limit.";
        example Example::program("fanuc-lathe-a", "G21 G98|G50 X100. S2000|M30", "2:1");
    "G0423" SetPositionLeftOfLathe Caution {}
        es "G50 con X o Z sigue activo al final y desplaza también el programa siguiente"
        en "G50 with X or Z is still active at the end and also shifts the next program"
        remedy "use los decalajes G54 a G59", "use the work offsets G54 to G59";
        why "El programa siguiente trabaja en otro sitio, y su texto no lo dice.",
            "The next program works in another place, and its text does not say so.";
        example Example::program("fanuc-lathe-a", "G21 G98|G50 X100. Z50.|M30", "3");
    "G0424" SetPositionLeft Caution {}
        es "G92 o G52 sigue activo al final y desplaza también el programa siguiente"
        en "G92 or G52 is still active at the end and also shifts the next program"
        remedy "programe G92.1 antes del final", "program G92.1 before the end";
        why "El programa siguiente trabaja en otro sitio, y su texto no lo dice.",
            "The next program works in another place, and its text does not say so.";
        example Example::program("linuxcnc", "G21 G90 F100|G92 X5|M2", "3");
    "G0425" CompensationTwice Stop {}
        es "G41 o G42 con la compensación ya en vigor"
        en "G41 or G42 while compensation is already in force"
        remedy "programe G40 antes", "program G40 before it";
        why "El control no sabe cómo pasar de un lado al otro.",
            "The control does not know how to change from one side to the other.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D2 G1 X10|G42.1 D2 X20|G40 X30|M2", "3:1");
    "G0426" CutterPlane Stop { plane: &'static str }
        es "rodete no admite la compensación de radio en {plane}"
        en "rodete does not follow cutter radius compensation in {plane}"
        remedy "programe G17", "program G17";
        why "En otro plano la fresa está encima del contorno, no al lado.",
            "In another plane the cutter is above the contour, not beside it.";
        example Example::program("linuxcnc", "G21 G90 F100|G18|G41.1 D2 G1 X10|M2", "3:1");
    "G0427" CompensationWithL Stop {}
        es "L con G41.1 o G42.1 en G17"
        en "L with G41.1 or G42.1 in G17"
        remedy "quite L, que es de los tornos", "delete L, which is for lathes";
        why "L es la orientación de la punta de una herramienta de torno.",
            "L is the tip orientation of a turning tool.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D2 L1 G1 X10|M2", "2:1");
    "G0428" CompensationWithoutD Stop {}
        es "G41.1 o G42.1 sin D"
        en "G41.1 or G42.1 without D"
        remedy "añada D, el diámetro de la fresa", "add D, the diameter of the cutter";
        why "Sin el diámetro no se sabe cuánto hay que apartar la fresa.",
            "Without the diameter it is not clear how far to shift the cutter.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 G1 X10|M2", "2:1");
    "G0429" CompensationOfNothing Caution {}
        es "G41 o G42 con diámetro 0: la fresa sigue el programa"
        en "G41 or G42 with diameter 0: the cutter follows the program"
        remedy "compruebe el diámetro en la tabla de herramientas", "check the diameter in the tool table";
        why "Con diámetro 0 el centro de la fresa sigue el contorno y la fresa se come media anchura de la pieza.",
            "With diameter 0 the cutter's centre follows the contour, and the cutter removes half its width from the part.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D0 G1 X10|G40 X20|M2", "2:1");
    "G0430" CompensationOfTurningTool Stop { tool: u32 }
        es "G41 o G42 en G17 con la herramienta {tool}, que es de torno (orientación Q)"
        en "G41 or G42 in G17 with tool {tool}, a turning tool (orientation Q)"
        remedy "quite Q de la tabla de herramientas", "delete Q from the tool table";
        why "El diámetro de una herramienta de torno es el de su punta.",
            "The diameter of a turning tool is that of its nose.";
        example Example::Program { control: "linuxcnc", program: "G21 G90 F100|T2 M6|G41 G1 X10|M2", at: "3:1", given: &[("--tools", "T1 P1 Z50 D10|T2 P2 Z50 D10 Q2")] };
    "G0431" CompensationOfNoTool Stop {}
        es "G41 o G42, pero no se sabe qué herramienta está en el husillo"
        en "G41 or G42, but the tool in the spindle is not known"
        remedy "llámela con T y M6, o dé D", "call it with T and M6, or give D";
        why "Sin herramienta no hay diámetro.",
            "Without a tool there is no diameter.";
        example Example::program("linuxcnc", "G21 G90 F100|G41 G1 X10|M2", "2:1");
    "G0432" CompensationDiameterUnknown Stop { tool: u32 }
        es "G41 o G42, pero no se conoce el diámetro de la herramienta {tool}"
        en "G41 or G42, but the diameter of tool {tool} is not known"
        remedy "indique la tabla de herramientas con --tools", "name the tool table with --tools";
        why "Con un diámetro equivocado la pieza sale grande o pequeña.",
            "With a wrong diameter the part comes out too large or too small.";
        example Example::program("linuxcnc", "G21 G90 F100|T1 M6|G41 G1 X10|M2", "3:1");
    "G0433" BesideCompensation Stop {}
        es "este código no se admite con G41 o G42 en vigor"
        en "this code is not allowed while G41 or G42 is in force"
        remedy "programe antes G40 y un movimiento recto", "program G40 and a straight motion before it";
        why "El código cambiaría la trayectoria de la fresa en medio del contorno.",
            "The code would change the cutter's path in the middle of the contour.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D2 G1 X10|G55|G40 X20|M2", "3:1");
    "G0434" PositionUnderCompensation Stop {}
        es "un programa no puede leer la posición con G41 o G42 en vigor"
        en "a program cannot read the position while G41 or G42 is in force"
        remedy "léala antes de G41 o después de G40", "read it before G41 or after G40";
        why "La fresa está al lado del punto programado.",
            "The cutter is beside the programmed point.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D2 G1 X10|#1=#5420|G40 X20|M2", "3:4");
    "G0435" RotaryUnderCompensation Stop {}
        es "rodete no admite ejes giratorios ni U, V, W con G41 o G42 en vigor"
        en "rodete does not follow rotary axes or U, V, W while G41 or G42 is in force"
        remedy "muévalos antes de G41 o después de G40", "move them before G41 or after G40";
        why "La compensación trabaja en el plano, y un giro saca el contorno de él.",
            "Compensation works in the plane, and a rotary motion moves the contour out of it.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D2 G1 X10|X20 A5|G40 X30|M2", "3");
    "G0436" ArcBehindCompensation Stop {}
        es "el primer movimiento después de G40 es un arco"
        en "the first motion after G40 is an arc"
        remedy "hágalo recto: G0 o G1", "make it straight: G0 or G1";
        why "La fresa está al lado del contorno: un arco desde ahí no es el programado.",
            "The cutter is beside the contour: an arc from there is not the programmed arc.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D2 G1 X10|X20|G40|G2 X30 I5|M2", "5");
    "G0437" EntryTooShort Stop { length: Size, radius: Size }
        es "la entrada de la compensación mide {length}; debe ser mayor que el radio {radius}"
        en "the entry into compensation is {length} long; it must be longer than the radius {radius}"
        remedy "alargue en el plano el primer movimiento después de G41 o G42", "lengthen, in the plane, the first motion after G41 or G42";
        why "En un recorrido tan corto la fresa no puede ponerse al lado del contorno.",
            "On such a short path the cutter cannot reach its place beside the contour.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D20 G1 X5|X50|G40 X80|M2", "2");
    "G0438" EntryArc Stop {}
        es "el arco de entrada de la compensación no puede ser tangente al final"
        en "the entry arc of the compensation cannot be tangential at its end"
        remedy "entre con una recta", "enter along a straight line";
        why "La fresa no quedaría al lado del contorno al acabar el arco.",
            "The cutter would not be beside the contour at the end of the arc.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D6|G3 X10 Y2.679 J20|G1 X50|G40 X80|M2", "3");
    "G0439" CutterInArc Stop { radius: Size, arc: Size }
        es "el radio {radius} de la fresa no cabe en el arco de radio {arc}"
        en "the cutter's radius {radius} does not fit into the arc of radius {arc}"
        remedy "use una fresa menor, o cambie el contorno", "use a smaller cutter, or change the contour";
        why "La fresa cortaría el otro lado del contorno.",
            "The cutter would cut into the other side of the contour.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D20 G1 X30|G3 X30 Y10 I0 J5|G1 X0|G40 X-30|M2", "3");
    "G0440" CutterInCorner Stop { radius: Size }
        es "el radio {radius} de la fresa no cabe en el rincón"
        en "the cutter's radius {radius} does not fit into the corner"
        remedy "use una fresa menor, o cambie el contorno", "use a smaller cutter, or change the contour";
        why "La fresa cortaría el otro lado del contorno.",
            "The cutter would cut into the other side of the contour.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D6|G1 X10|G3 X2 I-4|G1 X0|G40 X-30|M2", "4");
    "G0441" CompensationHeld Stop { most: usize }
        es "más de {most} bloques sin movimiento en el plano con G41 o G42 en vigor"
        en "more than {most} blocks without motion in the plane with G41 or G42 in force"
        remedy "programe antes G40", "program G40 before them";
        why "El control necesita el movimiento siguiente para calcular la esquina, y no mira tan adelante.",
            "The control needs the next motion to work out the corner, and does not look that far ahead.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D2 G1 X10|O1 REPEAT [5001]|G1 Z1|G1 Z0|O1 ENDREPEAT|G40 X20|M2", "4");
    "G0442" CutterInShortPiece Stop { radius: Size }
        es "el radio {radius} de la fresa no cabe: los rincones ocupan más que la longitud del tramo anterior"
        en "the cutter's radius {radius} does not fit: the corners need more length than the element before them has"
        remedy "use una fresa menor, o cambie el contorno", "use a smaller cutter, or change the contour";
        why "La fresa cortaría el otro lado del contorno.",
            "The cutter would cut into the other side of the contour.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D20 G1 X30|X32|Y30|G40 X-30|M2", "4");
    "G0443" PolarTooGreat Stop {}
        es "cota polar mayor que 99 999.999"
        en "polar coordinate above 99,999.999"
        remedy "escriba X e Y, o use un bloque aparte", "write X and Y, or use a separate block";
        why "Ninguna máquina llega ahí: el número será erróneo.",
            "No machine goes that far: the number is probably wrong.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 @100000 ^0|M2", "2:4");
    "G0444" PolarTwice Stop {}
        es "dos cotas polares iguales en un bloque"
        en "the same polar word twice in one block"
        remedy "escriba X e Y, o use un bloque aparte", "write X and Y, or use a separate block";
        why "No se sabe cuál de las dos vale.",
            "It is not clear which of the two counts.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 @1 @2|M2", "2:7");
    "G0445" PolarBesideAxes Stop {}
        es "cotas polares junto a X o Y"
        en "polar words beside X or Y"
        remedy "escriba X e Y, o use un bloque aparte", "write X and Y, or use a separate block";
        why "Las cotas polares y X e Y dan la misma posición de dos maneras.",
            "Polar words and X and Y give the same position in two ways.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 @1 X1|M2", "2:4");
    "G0446" PolarPlane Stop {}
        es "cotas polares fuera de G17"
        en "polar words outside G17"
        remedy "escriba X e Y, o use un bloque aparte", "write X and Y, or use a separate block";
        why "Las cotas polares trabajan en el plano XY.",
            "Polar words work in the XY plane.";
        example Example::program("linuxcnc", "G21 G90 F100|G18|G0 @1 ^0|M2", "3:4");
    "G0447" PolarBesideCode Stop {}
        es "cotas polares junto a otro código G"
        en "polar words beside another G code"
        remedy "escriba X e Y, o use un bloque aparte", "write X and Y, or use a separate block";
        why "El manual no dice qué hace entonces ese código con X e Y.",
            "The manual does not say what that code does with X and Y then.";
        example Example::program("linuxcnc", "G21 G90 F100|G53 G0 @1 ^0|M2", "2:8");
    "G0448" PolarRepeated Stop {}
        es "cotas polares repetidas con L en G91 no están implementadas"
        en "polar words repeated with L in G91 are not supported"
        remedy "escriba X e Y, o use un bloque aparte", "write X and Y, or use a separate block";
        why "Cada repetición empezaría en otro ángulo.",
            "Each repetition would start from another angle.";
        example Example::program("linuxcnc", "G21 G90 F100|G91|G81 @1 ^10 Z-1 R1 L3|M2", "3:5");
    "G0449" PolarAtOrigin Stop {}
        es "cota polar sin ángulo conocido: la herramienta está en el origen"
        en "polar word without a known angle: the tool is at the origin"
        remedy "escriba X e Y, o use un bloque aparte", "write X and Y, or use a separate block";
        why "En el origen no hay ningún ángulo del que partir.",
            "At the origin there is no angle to start from.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 @1|M2", "2:4");
    "G0450" RolloverPreset Stop { axis: char, angle: f64 }
        es "0199: {axis}{angle} preselecciona un eje giratorio rollover, que va de 0 a 359.9999"
        en "0199: {axis}{angle} presets a rollover axis, which goes from 0 to 359.9999"
        remedy "escriba el mismo ángulo entre 0 y 359.9999", "write the same angle within 0 to 359.9999";
        why "El control se para con su error 0199.",
            "The control stops with its error 0199.";
        example Example::program("fagor-8055", "G90|G92 B400|M30", "2:5");
    "G0451" WrappedInMachine Stop { axis: char }
        es "{axis} con G53 en un eje WRAPPED_ROTARY: el control toma el sentido del signo de la palabra y no aplica el decalaje al destino"
        en "{axis} with G53 on a WRAPPED_ROTARY axis: the control takes the direction from the word's sign and ignores the offset in the target"
        remedy "mueva el eje sin G53", "move the axis without G53";
        why "El eje no va a donde dice la palabra.",
            "The axis does not go where the word says.";
        example Example::Program { control: "linuxcnc", program: "G21 G90 F100|G53 G0 A90|M2", at: "2:8", given: &[("--rotary", "rollover")] };
    "G0452" RolloverBeyondTurn Stop { alarm: &'static str, axis: char, angle: f64 }
        es "{alarm}{axis}{angle} en G90: en un eje rollover el número es el destino (0 a 359.9999) y el signo es el sentido"
        en "{alarm}{axis}{angle} in G90: on a rollover axis the number is the target (0 to 359.9999) and the sign is the direction"
        remedy "escriba el giro en G91; si el eje de la máquina no es rollover, dígalo con --rotary linear", "write the turn in G91; if the machine's axis is not rollover, say so with --rotary linear";
        why "El control se para, o gira menos de lo que dice el número.",
            "The control stops, or turns less than the number.";
        example Example::program("fagor-8055", "G90|G0 B400|M30", "2:4");
    "G0453" RolloverReached Caution { axis: char }
        es "{axis} ya está en el ángulo de su palabra en G90: lo que hace este control no está definido"
        en "{axis} is already at the angle of its G90 word: the control's behaviour is undefined"
        remedy "quite la palabra de un eje que no gira, o escriba el giro en G91", "delete the word of an axis that does not turn, or write the turn in G91";
        why "Un control puede no moverse y otro dar una vuelta entera.",
            "One control may not move, another may make a full turn.";
        example Example::program("fagor-8055", "G90|G0 B90|G0 B90|M30", "3:4");
    "G0454" RolloverMinusZero Caution { axis: char }
        es "{axis}-0 en G90: no está definido en este control; rodete lo lee como giro negativo hasta 0"
        en "{axis}-0 in G90: undefined on this control; rodete reads it as a turn in minus to 0"
        remedy "quite la palabra de un eje que no gira, o escriba el giro en G91", "delete the word of an axis that does not turn, or write the turn in G91";
        why "El signo da el sentido, y el manual no dice qué significa -0.",
            "The sign gives the direction, and the manual does not say what -0 means.";
        example Example::program("fagor-8055", "G90|G0 B90|G0 B-0|M30", "3:4");
    "G0455" HalfTurn Caution { axis: char, degrees: Size, count: u64, line: usize, more: Text }
        es "un eje giratorio da más de media vuelta en un bloque en avance: {axis} gira {degrees}{more}"
        en "a rotary axis makes more than half a turn in one feed block: {axis} turns {degrees}{more}"
        remedy "compruebe el sentido del giro y si el eje de la máquina es rollover (--rotary)",
            "check which way the axis must turn, and whether the machine's axis is rollover (--rotary)";
        why "Un eje ajustado de otra manera gira por el otro lado, con la herramienta en la pieza.",
            "An axis set up otherwise turns the other way, with the tool in the work.";
        example Example::program("linuxcnc", "G21 G90 F100|G1 A200|M2", "2");
    "G0456" RadiusNegative Stop { radius: f64 }
        es "R{radius} es negativo: con R este control no hace arcos de 180° o más"
        en "R{radius} is negative: with R this control makes no arcs of 180° or more"
        remedy "dé el centro con I y K", "give the centre with I and K";
        why "En otros controles un R negativo es el arco largo; este se para con una alarma.",
            "On other controls a negative R is the long arc; this one stops with an alarm.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X40. Z0.|G2 X60. Z-10. R-10.|M30", "3:15");
    "G0457" RadiusOfHalfCircle Stop { radius: f64 }
        es "R{radius} llega al final con medio círculo: con R este control no hace arcos de 180° o más"
        en "R{radius} reaches the end by half a circle: with R this control makes no arcs of 180° or more"
        remedy "dé el centro con I y K", "give the centre with I and K";
        why "Junto a medio círculo, un redondeo decide si el arco existe y dónde está su centro.",
            "Near half a circle, rounding decides whether the arc exists and where its centre is.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X20. Z0.|G3 X20. Z-10. R5.|M30", "3:15");
    "G0458" LengthOfRotaryAxis Stop { axis: char }
        es "la herramienta tiene un corrector en {axis}: con G28, G30 y G53 el control no lo cuenta y termina fuera del punto"
        en "the tool has an offset in {axis}: with G28, G30 and G53 the control leaves it out and ends off the point"
        remedy "anule antes el corrector con G49", "cancel the offset with G49 before it";
        why "Se ha visto en LinuxCNC 2.9; su manual promete el punto.",
            "LinuxCNC 2.9 was seen to do so; its manual promises the point.";
        example Example::program("linuxcnc", "G21 G90 F100|G43.1 A3|G28|M2", "3:1");
    "G0459" ToolTableWithTool Stop { tool: u32 }
        es "G10 L0 con la herramienta T{tool} en el husillo"
        en "G10 L0 with tool T{tool} in the spindle"
        remedy "deje el husillo sin herramienta con T0 M6", "leave the spindle without a tool with T0 M6";
        why "El control no recarga la tabla mientras hay una herramienta en el husillo.",
            "The control does not reload the table while a tool is in the spindle.";
        example Example::program("linuxcnc", "G21 G90 F100|T1 M6|G10 L0|M2", "3:1");
    "G0460" PresetEnds Caution {}
        es "el decalaje de origen anula lo que fijó G92: este control no lleva los dos a la vez"
        en "the work offset ends what G92 has set: this control does not have both in force"
        remedy "programe G92 después del decalaje, o quítelo", "program G92 after the work offset, or take it out";
        why "En un LinuxCNC o un Fanuc G92 se suma al decalaje; en un Fagor se anulan uno a otro.",
            "On a LinuxCNC or a Fanuc G92 is added to the work offset; on a Fagor each ends the other.";
        example Example::program("fagor-8055", "G71 G90 G54|G0 X10|G92 X0|G54|G0 X5|G54|M30", "4:1");
    "G0461" PresetLeft Caution {}
        es "G92 sigue activo al final y desplaza también el programa siguiente"
        en "G92 is still active at the end and also shifts the next program"
        remedy "active un decalaje de origen, como G54, antes del final", "select a work offset, such as G54, before the end";
        why "El programa siguiente trabaja en otro sitio, y su texto no lo dice.",
            "The next program works in another place, and its text does not say so.";
        example Example::program("fagor-8055", "G71 G90|G0 X10|G92 X0|M30", "4");
    "G0462" RadiiDiffer Caution { difference: Size }
        es "los radios al principio y al final del arco difieren {difference}: un parámetro de la máquina dice cuánto admite el control, y rodete no lo conoce"
        en "the radii at the start and at the end of the arc differ by {difference}: a machine parameter says how much the control admits, and rodete does not know it"
        remedy "dé el centro con más decimales, o compruebe ese parámetro (CIRINERR en un Fagor 8055)", "give the centre with more decimals, or check that parameter (CIRINERR on a Fagor 8055)";
        why "Con una diferencia mayor que la admitida, el control se para en el arco.", "With a greater difference than admitted the control stops at the arc.";
        example Example::program("fagor-8055", "G71 G90 G94 F100|G1 X0 Y0|G2 X10 Y0 I5.008 J0|M30", "3");
    "G0463" ArcOfAnotherPlane Caution { plane: &'static str, axis: char, missing: char }
        es "un arco de {plane} con {axis} y sin {missing}: el control lo hace en {plane}, como hélice según {axis}"
        en "an arc of {plane} with {axis} and without {missing}: the control makes it in {plane}, as a helix along {axis}"
        remedy "si el arco es de otro plano, prográmelo antes (G17, G18 o G19); si es una hélice, escriba también {missing}", "if the arc is in another plane, program that plane before it (G17, G18 or G19); if it is a helix, write {missing} too";
        why "Con el plano que haya quedado de antes, la fresa baja donde debía ir de lado.",
            "In a plane left over from before, the cutter plunges where it should go sideways.";
        example Example::program("linuxcnc", "G21 G90 F100|G18|G3 X5 Y5 R5|M2", "3:7");
}
