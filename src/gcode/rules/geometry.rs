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
            "Through two points there are arcs without number.";
        example Example::program("linuxcnc", "G21 G90 F100|G2 X1 Y1|M2", "2");
    "G0402" ArcTwoForms Stop {}
        es "arco con centro y con radio R"
        en "arc with a centre and with radius R"
        remedy "deje uno de los dos", "leave one of the two";
        why "El centro y el radio pueden no concordar: unos controles toman uno, otros el otro.",
            "Centre and radius may not agree: some controls take the one, others the other.";
        example Example::program("linuxcnc", "G21 G90 F100|G2 X1 Y1 I1 R1|M2", "2:13");
    "G0403" HelixPitch Stop { word: char, plane: &'static str, axis: char }
        es "{word} es en {plane} el paso de una hélice, que no está implementado"
        en "{word} is the pitch of a helix in {plane}, which is not supported"
        remedy "escriba la hélice vuelta a vuelta, con su {axis} y sin {word}", "write the helix turn by turn, with its {axis} and without {word}";
        why "Una hélice de varias vueltas se escribe así en este control; rodete no la sigue.",
            "That is how this control writes a helix of several turns; rodete does not follow it.";
        example Example::program("fagor-8055", "G17 G90 G1 X0 Y0 F100|G2 X10 Y0 Z5 I5 J0 K2|M30", "2:20");
    "G0404" HelixPitchNotPositive Stop { word: char, value: f64, plane: &'static str }
        es "{word}{value}: en {plane} {word} es el paso de una hélice, mayor que 0 (error 0054)"
        en "{word}{value}: {word} is the pitch of a helix in {plane}, above 0 (error 0054)"
        remedy "quite {word}", "take {word} out";
        why "El control se para con su error 0054.",
            "The control stops with its error 0054.";
        example Example::program("fagor-8055", "G17 G90 G1 X0 Y0 F100|G2 X10 Y0 I5 J0 K0|M30", "2:17");
    "G0405" CentreWordOfOtherPlane Caution { word: char, plane: &'static str }
        es "{word}0 en un arco de {plane}: leído como si no estuviera; lo que hace el control no se ha podido consultar"
        en "{word}0 in an arc of {plane}: read as if it were not there; what the control does could not be looked up"
        remedy "quite {word}", "take {word} out";
        why "Un 0 no cambia el arco, pero el control puede pararse en él.",
            "A 0 does not change the arc, but the control may stop at it.";
        example Example::program("fagor-8055-t", "G1 X20 Z0 F100|G2 X30 Z-5 I5 K0 J0|M30", "2:18");
    "G0406" CentreWordForeign Stop { word: char, plane: &'static str, first: char, second: char }
        es "{word} no pertenece al plano {plane}"
        en "{word} does not belong to the plane {plane}"
        remedy "use {first} y {second}, o cambie de plano", "use {first} and {second}, or change the plane";
        why "El centro se mide en los ejes del plano: otra letra no dice dónde está.",
            "The centre is measured along the axes of the plane: another letter does not say where it is.";
        example Example::program("linuxcnc", "G21 G90 F100|G2 X1 Y1 I1 K1|M2", "2:13");
    "G0407" RadiusWithoutEnd Stop { first: char, second: char }
        es "arco con R sin {first} ni {second}"
        en "arc with R without {first} or {second}"
        remedy "dé el punto final", "give the end point";
        why "Con el radio solo no se sabe dónde acaba el arco.",
            "With the radius alone nothing says where the arc ends.";
        example Example::program("linuxcnc", "G21 G90 F100|G2 R1|M2", "2:4");
    "G0408" TurnsNotWhole Stop { turns: f64 }
        es "P{turns} no es un número de vueltas"
        en "P{turns} is no number of turns"
        remedy "P es un número entero de 1 en adelante", "P is a whole number from 1 on";
        why "Un arco da vueltas enteras más el resto hasta su final.",
            "An arc makes whole turns and what is left to its end.";
        example Example::program("linuxcnc", "G21 G90 F100|G2 X1 Y0 I0.5 P1.5|M2", "2:15");
    "G0409" AbsoluteCentreHalf Stop { word: char }
        es "falta {word} en un arco de centro absoluto"
        en "{word} is missing in an arc with absolute centre"
        remedy "dé las dos coordenadas del centro", "give both coordinates of the centre";
        why "Con centros absolutos una coordenada que falta no es 0: no se sabe cuál es.",
            "With absolute centres a coordinate that is missing is not 0: nothing says what it is.";
        example Example::program("linuxcnc", "G21 G90 F100|G90.1|G2 X1 Y0 I0.5|M2", "3");
    "G0410" RadiusOfFullCircle Stop {}
        es "arco con R cuyo final es su principio"
        en "arc with R that ends where it starts"
        remedy "programe el círculo con I, J o K", "program the circle with I, J or K";
        why "Por un punto pasan infinitos círculos de ese radio.",
            "Through one point there are circles of that radius without number.";
        example Example::program("linuxcnc", "G21 G90 F100|G2 X0 Y0 R1|M2", "2:10");
    "G0411" RadiusTooSmall Stop { radius: Size, half: Size }
        es "radio {radius} demasiado pequeño: media cuerda {half}"
        en "radius {radius} too small to reach the end: half the chord is {half}"
        remedy "R de al menos {half}", "R of at least {half}";
        why "Un arco de ese radio no llega de un punto al otro.",
            "An arc of that radius does not reach from one point to the other.";
        example Example::program("linuxcnc", "G21 G90 F100|G2 X10 Y0 R1|M2", "2:11");
    "G0412" ArcOfNoRadius Stop { start: Size, end: Size }
        es "arco de radio cero: r1 {start}, r2 {end}"
        en "zero-radius arc: r1 {start}, r2 {end}"
        remedy "compruebe el centro", "check the centre";
        why "Un arco sin radio no es un movimiento: el centro está donde la herramienta.",
            "An arc without a radius is no motion: its centre is where the tool stands.";
        example Example::program("linuxcnc", "G21 G90 F100|G2 X0 Y0 I0 J0|M2", "2");
    "G0413" EndOffCircle Stop { start: Size, end: Size, difference: Size }
        es "el final no está en el círculo: r1 {start}, r2 {end}, diferencia {difference}"
        en "the end is not on the circle: r1 {start}, r2 {end}, difference {difference}"
        remedy "compruebe el final y el centro", "check the end and the centre";
        why "El control se para, o llega al final con un escalón que queda en la pieza.",
            "The control stops, or reaches the end with a step that is left in the part.";
        example Example::program("linuxcnc", "G21 G90 F100|G2 X1 Y1 I1 J0.5|M2", "2");
    "G0414" ToolTableLoaded Note {}
        es "G10 L0 carga de nuevo la tabla de herramientas: aquí sigue la que se ha dado"
        en "G10 L0 loads the tool table again: here the one that was given stays"
        remedy "", "";
        why "La tabla del control puede haber cambiado entretanto.",
            "The control's table may have changed meanwhile.";
        example Example::program("linuxcnc", "G21 G90 F100|G10 L0|M2", "2:1");
    "G0415" OffsetsWithoutL Stop {}
        es "G10 sin L1, L2, L10, L11 o L20"
        en "G10 without L1, L2, L10, L11 or L20"
        remedy "dé L", "give L";
        why "L dice qué tabla se cambia.",
            "L says which table is changed.";
        example Example::program("linuxcnc", "G21 G90 F100|G10 P1 X0|M2", "2:1");
    "G0416" OffsetsWithoutP Stop {}
        es "G10 sin P"
        en "G10 without P"
        remedy "dé P", "give P";
        why "P dice qué fila de la tabla se cambia.",
            "P says which row of the table is changed.";
        example Example::program("linuxcnc", "G21 G90 F100|G10 L2 X0|M2", "2:1");
    "G0417" OffsetsPNotWhole Stop { number: f64 }
        es "P{number} de G10 no es un número entero desde 0"
        en "P{number} of G10 is not a whole number from 0 on"
        remedy "dé un número entero", "give a whole number";
        why "Las filas de la tabla se cuentan con números enteros.",
            "The rows of the table are counted by whole numbers.";
        example Example::program("linuxcnc", "G21 G90 F100|G10 L2 P1.5 X0|M2", "2:1");
    "G0418" OffsetsPTooGreat Stop { number: u32 }
        es "P{number} en G10 L2 o L20"
        en "P{number} in G10 L2 or L20"
        remedy "P va de 1 a 9, o 0 para el activo", "P goes from 1 to 9, or 0 for the active one";
        why "El control solo tiene nueve orígenes.",
            "The control has nine work offsets only.";
        example Example::program("linuxcnc", "G21 G90 F100|G10 L2 P10 X0|M2", "2:1");
    "G0419" OffsetsWithTurning Stop {}
        es "I, J o Q en G10 L2 o L20"
        en "I, J or Q in G10 L2 or L20"
        remedy "quítelas", "take them out";
        why "I, J y Q son de las herramientas de torno, no de los orígenes.",
            "I, J and Q belong to turning tools, not to work offsets.";
        example Example::program("linuxcnc", "G21 G90 F100|G10 L2 P1 I5|M2", "2:1");
    "G0420" OffsetsRotation Stop {}
        es "R en G10 L20"
        en "R in G10 L20"
        remedy "gire el sistema con G10 L2 R", "rotate the system with G10 L2 R";
        why "L20 mide desde donde está la herramienta, y ahí un giro no tiene sentido.",
            "L20 measures from where the tool stands, and a rotation has no meaning there.";
        example Example::program("linuxcnc", "G21 G90 F100|G10 L20 P1 X0 R5|M2", "2:1");
    "G0421" RotationWithG92 Caution {}
        es "G10 L2 R del sistema activo con G92 en vigor: LinuxCNC 2.9 olvida G92 en el movimiento siguiente y llega a otro sitio"
        en "G10 L2 R of the active system while G92 is in force: LinuxCNC 2.9 forgets G92 in the next motion and goes elsewhere"
        remedy "leído con G92 en vigor; programe G92.1 antes y G92 después", "read with G92 in force; program G92.1 before it and G92 behind it";
        why "El control y el programa no acaban en el mismo sitio.",
            "Control and program do not end in the same place.";
        example Example::program("linuxcnc", "G21 G90 F100|G92 X5|G10 L2 P1 R5|G92.1|M2", "3:11");
    "G0422" AxesOrSpeed Stop {}
        es "se esperan o palabras de eje o S, no ambas"
        en "either axis words or S are wanted, not both and not none"
        remedy "escriba dos bloques", "write two blocks";
        why "Con ambas no se sabe si se pone la posición o el límite de giro.",
            "With both nothing says whether the position or the speed limit is set.";
        example Example::program("fanuc-lathe-a", "G21 G98|G50 X100. S2000|M30", "2:1");
    "G0423" SetPositionLeftOfLathe Caution {}
        es "G50 con X o Z sigue activo al final: vale también para el programa siguiente"
        en "G50 with X or Z is left active at the end: it holds for the next program too"
        remedy "use los orígenes G54 a G59", "use the work offsets G54 to G59";
        why "El programa siguiente trabaja en otro sitio sin que su texto lo diga.",
            "The next program works in another place without its text saying so.";
        example Example::program("fanuc-lathe-a", "G21 G98|G50 X100. Z50.|M30", "3");
    "G0424" SetPositionLeft Caution {}
        es "G92 o G52 sigue activo al final: vale también para el programa siguiente"
        en "G92 or G52 is left active at the end: it holds for the next program too"
        remedy "programe G92.1 antes del final", "program G92.1 before the end";
        why "El programa siguiente trabaja en otro sitio sin que su texto lo diga.",
            "The next program works in another place without its text saying so.";
        example Example::program("linuxcnc", "G21 G90 F100|G92 X5|M2", "3");
    "G0425" CompensationTwice Stop {}
        es "G41 o G42 con la compensación ya en vigor"
        en "G41 or G42 with compensation already in force"
        remedy "programe G40 antes", "program G40 before it";
        why "El control no sabe desde qué lado salir al otro.",
            "The control does not know how to go from one side to the other.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D2 G1 X10|G42.1 D2 X20|G40 X30|M2", "3:1");
    "G0426" CutterPlane Stop { plane: &'static str }
        es "la compensación de radio en {plane} no está implementada"
        en "cutter radius compensation in {plane} is not supported"
        remedy "programe G17", "program G17";
        why "En otro plano la fresa no está al lado del contorno, sino encima.",
            "In another plane the cutter is not beside the contour but above it.";
        example Example::program("linuxcnc", "G21 G90 F100|G18|G41.1 D2 G1 X10|M2", "3:1");
    "G0427" CompensationWithL Stop {}
        es "L con G41.1 o G42.1 en G17"
        en "L with G41.1 or G42.1 in G17"
        remedy "L es de los tornos: quítela", "L is for lathes: take it out";
        why "L es la orientación de la placa de un torno.",
            "L is the orientation of a turning insert.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D2 L1 G1 X10|M2", "2:1");
    "G0428" CompensationWithoutD Stop {}
        es "G41.1 o G42.1 sin D"
        en "G41.1 or G42.1 without D"
        remedy "D es el diámetro de la fresa", "D is the diameter of the cutter";
        why "Sin el diámetro no se sabe cuánto se ha de apartar la fresa.",
            "Without the diameter nothing says how far the cutter stands aside.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 G1 X10|M2", "2:1");
    "G0429" CompensationOfNothing Caution {}
        es "G41 o G42 con diámetro 0: la fresa sigue el programa"
        en "G41 or G42 with diameter 0: the cutter follows the program"
        remedy "compruebe el diámetro en la tabla de herramientas", "check the diameter in the tool table";
        why "Con diámetro 0 el centro de la fresa va por el contorno y se come la mitad de su ancho.",
            "With diameter 0 the centre of the cutter follows the contour and takes half its width off it.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D0 G1 X10|G40 X20|M2", "2:1");
    "G0430" CompensationOfTurningTool Stop { tool: u32 }
        es "G41 o G42 en G17 con la herramienta {tool}, que es de torno (orientación Q)"
        en "G41 or G42 in G17 with tool {tool}, which is a lathe's (orientation Q)"
        remedy "quite Q de la tabla de herramientas", "take Q out of the tool table";
        why "El diámetro de una herramienta de torno es el de su punta.",
            "The diameter of a turning tool is that of its nose.";
        example Example::Program { control: "linuxcnc", program: "G21 G90 F100|T2 M6|G41 G1 X10|M2", at: "3:1", given: &[("--tools", "T1 P1 Z50 D10|T2 P2 Z50 D10 Q2")] };
    "G0431" CompensationOfNoTool Stop {}
        es "G41 o G42, y no se sabe qué herramienta está en el husillo"
        en "G41 or G42, and it is not known which tool is in the spindle"
        remedy "llámela con T y M6, o dé D", "call it with T and M6, or give D";
        why "Sin herramienta no hay diámetro.",
            "Without a tool there is no diameter.";
        example Example::program("linuxcnc", "G21 G90 F100|G41 G1 X10|M2", "2:1");
    "G0432" CompensationDiameterUnknown Stop { tool: u32 }
        es "G41 o G42, y el diámetro de la herramienta {tool} no se conoce"
        en "G41 or G42, and the diameter of tool {tool} is not known"
        remedy "indique la tabla de herramientas con --tools", "name the tool table with --tools";
        why "Con otro diámetro la pieza sale mayor o menor.",
            "With another diameter the part comes out larger or smaller.";
        example Example::program("linuxcnc", "G21 G90 F100|T1 M6|G41 G1 X10|M2", "3:1");
    "G0433" BesideCompensation Stop {}
        es "este código no puede estar con G41 o G42 en vigor"
        en "this code cannot stand with G41 or G42 in force"
        remedy "programe antes G40 y un movimiento recto", "program G40 and a straight motion before it";
        why "Cambiaría por dónde va la fresa en medio del contorno.",
            "It would change where the cutter goes in the middle of the contour.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D2 G1 X10|G55|G40 X20|M2", "3:1");
    "G0434" PositionUnderCompensation Stop {}
        es "la posición no puede leerse con G41 o G42 en vigor"
        en "the position cannot be read with G41 or G42 in force"
        remedy "léala antes de G41 o detrás de G40", "read it before G41 or behind G40";
        why "La fresa está al lado de donde dice el programa.",
            "The cutter stands beside where the program says.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D2 G1 X10|#1=#5420|G40 X20|M2", "3:4");
    "G0435" RotaryUnderCompensation Stop {}
        es "ejes giratorios o U, V, W con G41 o G42 en vigor no están implementados"
        en "rotary axes or U, V, W with G41 or G42 in force are not supported"
        remedy "muévalos antes de G41 o detrás de G40", "move them before G41 or behind G40";
        why "El contorno se compensa en el plano: un giro lo cambia de sitio.",
            "The contour is compensated in the plane: a turn moves it elsewhere.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D2 G1 X10|X20 A5|G40 X30|M2", "3");
    "G0436" ArcBehindCompensation Stop {}
        es "el primer movimiento detrás de G40 es un arco"
        en "the first motion behind G40 is an arc"
        remedy "debe ser recto: G0 o G1", "it must be straight: G0 or G1";
        why "La fresa está al lado del contorno: un arco desde ahí no es el del programa.",
            "The cutter stands beside the contour: an arc from there is not the one of the program.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D2 G1 X10|X20|G40|G2 X30 I5|M2", "5");
    "G0437" EntryTooShort Stop { length: Size, radius: Size }
        es "la entrada de la compensación mide {length}, y ha de ser mayor que el radio {radius}"
        en "the entry into compensation is {length} long, and must be longer than the radius {radius}"
        remedy "alargue en el plano el primer movimiento detrás de G41 o G42", "lengthen the first motion behind G41 or G42 in the plane";
        why "En tan poco camino la fresa no puede ponerse al lado del contorno.",
            "On so short a way the cutter cannot get beside the contour.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D20 G1 X5|X50|G40 X80|M2", "2");
    "G0438" EntryArc Stop {}
        es "el arco de entrada de la compensación no puede ser tangente en su final"
        en "the arc of the entry into compensation cannot be made tangential at its end"
        remedy "entre con una recta", "enter along a line";
        why "La fresa no quedaría al lado del contorno al acabar el arco.",
            "The cutter would not be beside the contour at the end of the arc.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D6|G3 X10 Y2.679 J20|G1 X50|G40 X80|M2", "3");
    "G0439" CutterInArc Stop { radius: Size, arc: Size }
        es "el radio {radius} de la fresa no cabe en el arco de radio {arc}"
        en "the cutter's radius {radius} does not fit into the arc of radius {arc}"
        remedy "use una fresa menor, o cambie el contorno", "use a smaller cutter, or change the contour";
        why "La fresa cortaría al otro lado del contorno.",
            "The cutter would cut beyond the contour.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D20 G1 X30|G3 X30 Y10 I0 J5|G1 X0|G40 X-30|M2", "3");
    "G0440" CutterInCorner Stop { radius: Size }
        es "el radio {radius} de la fresa no cabe en el rincón"
        en "the cutter's radius {radius} does not fit into the corner"
        remedy "use una fresa menor, o cambie el contorno", "use a smaller cutter, or change the contour";
        why "La fresa cortaría al otro lado del contorno.",
            "The cutter would cut beyond the contour.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D6|G1 X10|G3 X2 I-4|G1 X0|G40 X-30|M2", "4");
    "G0441" CompensationHeld Stop { most: usize }
        es "más de {most} bloques sin movimiento en el plano con G41 o G42 en vigor"
        en "more than {most} blocks without motion in the plane with G41 or G42 in force"
        remedy "programe antes G40", "program G40 before them";
        why "El control mira el bloque siguiente que se mueva para trazar la esquina, y no mira tan lejos.",
            "The control looks for the next block that moves to follow the corner, and does not look so far.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D2 G1 X10|O1 REPEAT [5001]|G1 Z1|G1 Z0|O1 ENDREPEAT|G40 X20|M2", "4");
    "G0442" CutterInShortPiece Stop { radius: Size }
        es "el radio {radius} de la fresa no cabe: los rincones ocupan más que el tramo anterior"
        en "the cutter's radius {radius} does not fit: corners take more than the piece before has"
        remedy "use una fresa menor, o cambie el contorno", "use a smaller cutter, or change the contour";
        why "La fresa cortaría al otro lado del contorno.",
            "The cutter would cut beyond the contour.";
        example Example::program("linuxcnc", "G21 G90 F100|G41.1 D20 G1 X30|X32|Y30|G40 X-30|M2", "4");
    "G0443" PolarTooGreat Stop {}
        es "cota polar de más de 99 999.999"
        en "polar coordinate of more than 99,999.999"
        remedy "escriba X e Y, o el bloque aparte", "write X and Y, or a block of its own";
        why "Ninguna máquina llega ahí: será un número equivocado.",
            "No machine goes there: it will be a wrong number.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 @100000 ^0|M2", "2:4");
    "G0444" PolarTwice Stop {}
        es "dos cotas polares iguales en un bloque"
        en "the same polar word twice in one block"
        remedy "escriba X e Y, o el bloque aparte", "write X and Y, or a block of its own";
        why "No se sabe cuál de las dos vale.",
            "Nothing says which of the two holds.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 @1 @2|M2", "2:7");
    "G0445" PolarBesideAxes Stop {}
        es "cotas polares junto a X o Y"
        en "polar words beside X or Y"
        remedy "escriba X e Y, o el bloque aparte", "write X and Y, or a block of its own";
        why "X e Y son lo mismo que las cotas polares dicen de otra manera.",
            "X and Y are what polar words say in another way.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 @1 X1|M2", "2:4");
    "G0446" PolarPlane Stop {}
        es "cotas polares fuera de G17"
        en "polar words outside G17"
        remedy "escriba X e Y, o el bloque aparte", "write X and Y, or a block of its own";
        why "Las cotas polares se cuentan en el plano XY.",
            "Polar words are counted in the XY plane.";
        example Example::program("linuxcnc", "G21 G90 F100|G18|G0 @1 ^0|M2", "3:4");
    "G0447" PolarBesideCode Stop {}
        es "cotas polares junto a otro código G"
        en "polar words beside another G code"
        remedy "escriba X e Y, o el bloque aparte", "write X and Y, or a block of its own";
        why "Lo que ese código hace con X e Y no está escrito.",
            "What that code does with X and Y is not written.";
        example Example::program("linuxcnc", "G21 G90 F100|G53 G0 @1 ^0|M2", "2:8");
    "G0448" PolarRepeated Stop {}
        es "cotas polares repetidas con L en G91 no están implementadas"
        en "polar words repeated by L under G91 are not supported"
        remedy "escriba X e Y, o el bloque aparte", "write X and Y, or a block of its own";
        why "Cada repetición contaría desde otro ángulo.",
            "Each repetition would count from another angle.";
        example Example::program("linuxcnc", "G21 G90 F100|G91|G81 @1 ^10 Z-1 R1 L3|M2", "3:5");
    "G0449" PolarAtOrigin Stop {}
        es "cota polar sin ángulo conocido: la herramienta está en el origen"
        en "polar word without a known angle: the tool stands at the origin"
        remedy "escriba X e Y, o el bloque aparte", "write X and Y, or a block of its own";
        why "En el origen no hay dirección de la que partir.",
            "At the origin there is no direction to start from.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 @1|M2", "2:4");
    "G0450" RolloverPreset Stop { axis: char, angle: f64 }
        es "0199: {axis}{angle} como cota de un eje rotativo rollover: va de 0 a 359.9999"
        en "0199: {axis}{angle} to preset a rollover axis: it goes from 0 to 359.9999"
        remedy "escriba el mismo ángulo entre 0 y 359.9999", "write the same angle from 0 to 359.9999";
        why "El control se para con su error 0199.",
            "The control stops with its error 0199.";
        example Example::program("fagor-8055", "G90|G92 B400|M30", "2:5");
    "G0451" WrappedInMachine Stop { axis: char }
        es "{axis} con G53 en un eje con WRAPPED_ROTARY: el control toma el signo de la palabra y el destino sin el traslado"
        en "{axis} with G53 on an axis with WRAPPED_ROTARY: the control takes the sign of the word and the target without the offset"
        remedy "mueva el eje sin G53", "move the axis without G53";
        why "El eje no llega a donde dice la palabra.",
            "The axis does not come to where the word says.";
        example Example::Program { control: "linuxcnc", program: "G21 G90 F100|G53 G0 A90|M2", at: "2:8", given: &[("--rotary", "rollover")] };
    "G0452" RolloverBeyondTurn Stop { alarm: &'static str, axis: char, angle: f64 }
        es "{alarm}{axis}{angle} en G90: en un eje rollover el número es el destino, de 0 a 359.9999, y el signo el sentido"
        en "{alarm}{axis}{angle} in G90: on a rollover axis the number is the target, 0 to 359.9999, and the sign the direction"
        remedy "escriba el giro en G91; si el eje de la máquina no es rollover, dígalo con --rotary linear", "write the turn in G91; if the machine's axis is not rollover say so with --rotary linear";
        why "El control se para, o gira menos de lo que el número dice.",
            "The control stops, or turns less than the number says.";
        example Example::program("fagor-8055", "G90|G0 B400|M30", "2:4");
    "G0453" RolloverReached Caution { axis: char }
        es "{axis} ya está en el ángulo de su palabra en G90: no está definido en este control"
        en "{axis} stands at the angle of its word in G90 already: undefined on this control"
        remedy "quite la palabra de un eje que no gira, o escriba el giro en G91", "take out the word of an axis that does not turn, or write the turn in G91";
        why "Un control puede quedarse quieto y otro dar la vuelta entera.",
            "One control may stand still and another make the whole turn.";
        example Example::program("fagor-8055", "G90|G0 B90|G0 B90|M30", "3:4");
    "G0454" RolloverMinusZero Caution { axis: char }
        es "{axis}-0 en G90: no está definido en este control; leído como giro negativo hasta 0"
        en "{axis}-0 in G90: undefined on this control; read as a turn in minus to 0"
        remedy "quite la palabra de un eje que no gira, o escriba el giro en G91", "take out the word of an axis that does not turn, or write the turn in G91";
        why "El signo dice el sentido, y de −0 el manual no dice ninguno.",
            "The sign says the direction, and of −0 the manual says none.";
        example Example::program("fagor-8055", "G90|G0 B90|G0 B-0|M30", "3:4");
    "G0455" HalfTurn Caution { axis: char, degrees: Size, count: u64, line: usize, more: Text }
        es "más de media vuelta de un eje rotativo en un bloque en avance: {axis} gira {degrees}°{more}"
        en "more than half a turn of a rotary axis in one block at feed: {axis} turns {degrees}°{more}"
        remedy "compruebe el sentido del giro y si el eje de la máquina es rollover (--rotary)",
            "check which way the axis is to turn, and whether the machine's axis is rollover (--rotary)";
        why "Un eje que cuenta de otra manera da la vuelta por el otro lado, con la herramienta en la pieza.",
            "An axis that counts in another way turns about the other side, with the tool in the work.";
        example Example::program("linuxcnc", "G21 G90 F100|G1 A200|M2", "2");
}
