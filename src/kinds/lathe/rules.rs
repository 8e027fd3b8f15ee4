//! Findings about a turning workbook, and about the simulation of its programs besides the alarms.
//!
//! Codes P4001 on are of values that contradict each other, L0205 to L0220, L0229 to L0232 and from L0234 on of what was followed.

use crate::finding::rule::{book, rules};
use crate::finding::{Bare, Example, Key, Size};
use crate::text::{Text, t};

/// A program between the usual first and last blocks for the bar of D 50: the roughing tool in front of it, and away again.
macro_rules! blocks {
    ($blocks:literal) => {
        Example::Turning {
            control: "fanuc-lathe-a",
            stock: "D50xL120",
            program: concat!("G50 S2500|T0101|G97 S900 M3|M8|G0 X54. Z2.|", $blocks, "|G0 X100. Z50.|M30"),
            machine: &[],
        }
    };
}

rules! {
    /// The rows of a turning's workbook.
    RULES;

    "P4001" HeldBeyondStock Stop { L4: Size, L: Size }
        es "L4 es {L4} y debe ser menor que L = {L}"
        en "L4 is {L4}; it must be less than L = {L}"
        remedy "use un L4 menor, o un bruto más largo", "use a smaller L4, or longer stock";
        why "Si las garras cubren todo el bruto, no queda nada que tornear.", "If the jaws cover the whole stock, nothing is left to turn.";
        example book!("lathe", "L4" = "130");
    "P4002" FacingBeyondOverhang Stop { L5: Size, overhang: Size }
        es "L5 es {L5} y debe ser menor que el voladizo, {overhang}"
        en "L5 is {L5}; it must be less than the stick-out of {overhang}"
        remedy "use una demasía de refrentado menor", "use a smaller facing allowance";
        why "El cero pieza W1 quedaría dentro de las garras.", "The part zero W1 would be inside the jaws.";
        example book!("lathe", "L4" = "80", "L5" = "50");
    "P4003" BoreBeyondStock Stop { d: Size, D: Size }
        es "el agujero d es {d} y debe ser menor que D = {D}"
        en "the bore d is {d}; it must be less than D = {D}"
        remedy "corrija d o D", "correct d or D";
        why "Entre el agujero y la superficie debe quedar pared.", "There must be a wall between the bore and the surface.";
        example book!("lathe", "d" = "60");
    "P4004" SlideTravelReversed Stop { low: Key, least: Bare, high: Key, greatest: Bare }
        es "{low} es {least} y debe ser menor que {high} = {greatest}"
        en "{low} is {least}; it must be less than {high} = {greatest}"
        remedy "corrija el recorrido", "correct the travel";
        why "Con los límites al revés no vale ninguna posición.", "With the limits reversed no position is allowed.";
        example book!("lathe", "X_min" = "100", "X_max" = "-100");
    "P4005" BodyReversed Stop { low: Key, least: Bare, high: Key, greatest: Bare }
        es "{low} es {least} y debe ser menor que {high} = {greatest}"
        en "{low} is {least}; it must be less than {high} = {greatest}"
        remedy "corrija el cuerpo de la torreta", "correct the turret's body";
        why "Un cuerpo con los lados cambiados no ocupa espacio y no chocaría con nada.",
            "A body with its sides swapped takes up no space and would hit nothing.";
        example book!("lathe", "BX_min" = "100", "BX_max" = "-100", "BZ_min" = "0", "BZ_max" = "10");
    "P4006" BodyHalfGiven Stop { lost: String }
        es "el cuerpo de la torreta necesita sus cuatro medidas; faltan: {lost}"
        en "the turret's body needs all four sizes; missing: {lost}"
        remedy "rellene las cuatro, o vacíe las cuatro para no vigilar el cuerpo",
            "fill in all four, or empty all four if the body need not be watched";
        why "Sin las cuatro medidas no se sabe qué espacio ocupa el cuerpo, y no se vigilaría.",
            "Without all four sizes the body's space is not known, and it would not be watched.";
        example book!("lathe", "BX_min" = "0");
    "P4007" ReferenceHalfGiven Stop {}
        es "el punto de referencia necesita R_X y R_Z, y falta una"
        en "the reference point needs R_X and R_Z, and one is missing"
        remedy "rellene R_X y R_Z, o vacíe las dos", "fill in R_X and R_Z, or empty both";
        why "Los ceros de la máquina se cuentan desde ese punto: con una sola cota estarían en otro sitio.",
            "The machine's zeros count from that point: with one coordinate they would be in the wrong place.";
        example book!("lathe", "R_X" = "400");
    "P4008" PointRuleMissing Stop { choices: Text }
        es "falta decir cómo lee el control una cota sin punto decimal"
        en "the form does not say how the control reads a dimension without a decimal point"
        remedy "escriba {choices}, según el parámetro DPI de su control",
            "write {choices}, according to parameter DPI of your control";
        why "Según ese ajuste, X100 son 100 mm o 0.1 mm.", "Depending on that setting, X100 is 100 mm or 0.1 mm.";
        example book!("lathe", "point" = "");
    "P4009" PlaceTwice Stop { T: u32 }
        es "hay dos herramientas en el puesto {T} de la torreta"
        en "two tools are in place {T} of the turret"
        remedy "dé a cada herramienta un puesto", "give each tool its own place";
        why "No se sabe cuál de las dos corta.", "It is not clear which of the two cuts.";
        example book!("lathe", "TOOLS!A7" = "1");
    "P4010" ToolCannotBe Stop { T: u32, why: Text }
        es "herramienta {T}: {why}"
        en "tool {T}: {why}"
        remedy "compruebe las medidas de la herramienta", "check the sizes of the tool";
        why "Con medidas que se contradicen no se puede trazar el perfil de la herramienta.",
            "Sizes that contradict each other give no tool outline.";
        example book!("lathe", "TOOLS!H6" = "90");
    "P4011" OffsetTwice Stop { D: u32 }
        es "dos herramientas tienen el corrector {D}"
        en "two tools have offset {D}"
        remedy "dé a cada herramienta su corrector", "give each tool its own offset";
        why "Un corrector lleva las medidas de una sola herramienta.", "An offset holds the sizes of one tool only.";
        example book!("lathe", "TOOLS!B7" = "1");
    "P4012" ToolColumnMissing Stop { T: u32, symbol: Key }
        es "la herramienta {T} necesita {symbol}"
        en "tool {T} needs {symbol}"
        remedy "la hoja no tiene la columna {symbol}: escriba su título y los valores",
            "the sheet has no column {symbol}: write its heading and the values";
        why "Sin esa medida no se conoce la forma de la herramienta.", "Without that size the tool's shape is not known.";
        example book!("lathe", "TOOLS!F4" = "", "TOOLS!F5" = "");
    "P4013" ToolShapeMissing Stop { T: u32, symbol: Key }
        es "la herramienta {T} necesita {symbol}"
        en "tool {T} needs {symbol}"
        remedy "elija la letra de forma de la norma ISO 1832", "choose the shape letter of ISO 1832";
        why "La letra da el ángulo de la placa.", "The letter gives the insert's angle.";
        example book!("lathe", "TOOLS!E6" = "");
    "P4014" ToolSizeMissing Stop { T: u32, symbol: Key, meaning: Text }
        es "la herramienta {T} necesita {symbol} ({meaning})"
        en "tool {T} needs {symbol} ({meaning})"
        remedy "rellene la celda", "fill in the cell";
        why "Sin esa medida no se conoce la forma de la herramienta.", "Without that size the tool's shape is not known.";
        example book!("lathe", "TOOLS!F6" = "");
    "P4015" ProfileOfOnePoint Stop {}
        es "el perfil tiene un solo punto"
        en "the profile has only one point"
        remedy "añada el punto final, o borre la fila", "add the end point, or delete the row";
        why "Un punto no es un contorno con el que comparar.", "One point is not a contour to compare with.";
        example book!("lathe", "PROFILE!A6" = "'1", "PROFILE!B6" = "20", "PROFILE!C6" = "0");
    "P4016" ArcWithoutRadius Stop {}
        es "el arco del perfil no tiene radio"
        en "the arc of the profile has no radius"
        remedy "escriba el radio", "write the radius";
        why "Por dos puntos pasan infinitos arcos.", "Infinitely many arcs pass through two points.";
        example book!("lathe", "PROFILE!A6" = "'1", "PROFILE!B6" = "20", "PROFILE!C6" = "0",
            "PROFILE!A7" = "'3", "PROFILE!B7" = "50", "PROFILE!C7" = "-15");
    "P4017" ArcFallsShort Stop { r: Size, chord: Size, half: Size }
        es "el arco del perfil tiene {r} de radio y su cuerda mide {chord}: no llega a su final"
        en "the profile's arc has a radius of {r} and a chord of {chord}: it does not reach its end"
        remedy "dé un radio de al menos {half}", "give a radius of at least {half}";
        why "La cuerda de un arco mide como mucho su diámetro.", "The chord of an arc is at most its diameter.";
        example book!("lathe", "PROFILE!A6" = "'1", "PROFILE!B6" = "20", "PROFILE!C6" = "0",
            "PROFILE!A7" = "'2", "PROFILE!B7" = "50", "PROFILE!C7" = "-20", "PROFILE!D7" = "5");
    "P4018" ArcWithoutChord Stop { r: Size, chord: Size }
        es "el arco del perfil tiene {r} de radio y su cuerda mide {chord}: no llega a su final"
        en "the profile's arc has a radius of {r} and a chord of {chord}: it does not reach its end"
        remedy "corrija X y Z: el arco termina donde empieza", "correct X and Z: the arc ends where it begins";
        why "Un perfil no puede dar una vuelta entera alrededor de un punto.", "A profile cannot make a full turn about a point.";
        example book!("lathe", "PROFILE!A6" = "'1", "PROFILE!B6" = "20", "PROFILE!C6" = "0",
            "PROFILE!A7" = "'2", "PROFILE!B7" = "20", "PROFILE!C7" = "0", "PROFILE!D7" = "5");
    "P4019" SubprogramOnTwoSheets Stop { name: String, first: String, last: String }
        es "hay dos subprogramas {name}: en las hojas \"{first}\" y \"{last}\""
        en "there are two subprograms {name}: on the sheets \"{first}\" and \"{last}\""
        remedy "quite una de las dos hojas", "remove one of the two sheets";
        why "O5 y O0005 son el mismo número, y el control guarda un solo subprograma con cada número.",
            "O5 and O0005 are the same number, and the control keeps one subprogram per number.";
        example Example::Made { key: "subprogram-sheets", how: t(
            "un libro de torno con las hojas de subprograma O0005 y O5", "a lathe workbook with the subprogram sheets O0005 and O5") };

    "L0205" NotJudgedFromHere Note {}
        es "los movimientos que siguen a este bloque rechazado no se comprueban"
        en "motions after this rejected block are not checked"
        remedy "", "";
        why "Sin ese bloque la herramienta no está donde el programa cree, y las alarmas siguientes serían falsas.",
            "Without that block the tool is not where the program expects it, and later alarms would be false.";
        example blocks!("G1 X4,5|G0 X40.");
    "L0206" ProgramNotJudged Note {}
        es "los movimientos de este programa no se comprueban: la pieza no es la prevista, o nada la sujeta"
        en "the motions of this program are not checked: the part is not the intended one, or nothing holds it"
        remedy "", "";
        why "El programa del segundo amarre cuenta con la pieza que deja el primero.",
            "The second set-up's program counts on the part that the first one leaves.";
        example book!("lathe", "PROGRAM!A7" = "N5 G199", "PROGRAM 2!A6" = "T0101", "PROGRAM 2!A7" = "G0 X100. Z50.");
    "L0207" TooManyMotions Stop { most: usize }
        es "el programa hace más de {most} movimientos"
        en "the program makes more than {most} motions"
        remedy "divídalo, o repita menos los subprogramas", "split it, or repeat its subprograms less often";
        why "rodete entrega los movimientos en una hoja, y en ella no caben más filas.",
            "rodete lists the motions on a sheet, and a sheet has no more rows.";
        example Example::Made { key: "program-many-motions", how: t(
            "un programa que llama con M98 P9999 a un subprograma que llama así a otro de dos movimientos",
            "a program that calls with M98 P9999 a subprogram that calls another one of two motions likewise") };
    "L0208" ThreadTooMuchWork Stop { made: usize, lead: Size, turns: Size }
        es "simular esta rosca supera el límite de cálculo; movimientos hechos hasta ella: {made}"
        en "simulating this thread exceeds the limit of the computation; motions made before it: {made}"
        remedy "compruebe F: con un paso de {lead} el husillo da {turns} vueltas", "check F: with a lead of {lead} the spindle makes {turns} turns";
        why "rodete simula la rosca vuelta a vuelta; con una F demasiado pequeña no acaba.",
            "rodete simulates a thread turn by turn; with too small an F that does not end.";
        example Example::Turning { control: "fanuc-lathe-a", stock: "D50xL120",
            program: "T0404|G97 S500 M3|G0 X40. Z3000.|G32 Z2000. F0.00001|M30", machine: &[] };
    "L0209" TooMuchWork Stop { made: usize }
        es "simular el programa supera el límite de cálculo; movimientos hechos hasta este bloque: {made}"
        en "simulating the program exceeds the limit of the computation; motions made before this block: {made}"
        remedy "divida el programa, o elija una tolerancia eps mayor, o pasadas y pasos mayores",
            "split the program, or choose a larger tolerance eps, or larger passes and leads";
        why "rodete recorta cada movimiento del contorno entero: con muchas esquinas y pasadas no acaba en un tiempo razonable.",
            "rodete cuts each motion from the whole contour: with many corners and passes that does not end in a reasonable time.";
        example Example::Turning { control: "fanuc-lathe-a", stock: "D50xL120",
            program: "G50 S2500|T0404|G97 S500 M3|M8|G0 X54. Z2.|X49.9|G32 Z-80. F.0077|G0 X54.|Z-1.|G1 X51. F.1|M98 P99990005|G0 X100. Z50.|M30|O0005|G1 U-1.3|U1.3 W-.008|M99",
            machine: &[] };
    "L0210" MachineZeroAssumed Caution {}
        es "G53 sin punto de referencia en el libro: rodete cuenta desde M, la cara del husillo, y no desde el punto de referencia"
        en "G53 without a reference point in the workbook: rodete counts from M, the spindle face, and not from the reference point"
        remedy "rellene R_X y R_Z en el libro (hoja DATOS)", "fill in R_X and R_Z in the workbook (sheet DATA)";
        why "Si el control cuenta desde el otro cero, la herramienta va en rápido a otro sitio.", "If the control counts from the other zero, the tool goes to another place, in rapid.";
        example blocks!("G53 G0 X400. Z400.");
    "L0211" ReferenceAssumed Note { X: Bare, Z: Bare }
        es "el libro no da el punto de referencia: rodete lo supone en X{X} Z{Z} desde M"
        en "the workbook gives no reference point: rodete assumes X{X} Z{Z} from M"
        remedy "rellene R_X y R_Z en el libro (hoja DATOS)", "fill in R_X and R_Z in the workbook (sheet DATA)";
        why "El camino de G28 depende de ese punto.", "The path of G28 depends on that point.";
        example blocks!("G28 U0. W0.");
    "L0212" MoreAlarms Note { count: usize }
        es "y {count} alarmas más: rodete view las muestra en la pieza"
        en "and {count} more alarms: rodete view shows them on the part"
        remedy "", "";
        why "rodete lista las más graves: las demás suelen tener la misma causa.",
            "rodete lists the gravest: the others usually have the same cause.";
        example Example::Made { key: "program-many-alarms", how: t(
            "un programa que entra sesenta veces en rápido en el material, cada vez en otra línea",
            "a program that enters metal at rapid sixty times, in another line each time") };
    "L0213" ZeroNotKnown Stop { code: &'static str, zero: String }
        es "el programa usa {code}, pero sin libro no se sabe dónde está {zero}"
        en "the program uses {code}, but without a workbook the place of {zero} is not known"
        remedy "indique con --tools un libro de torno que tenga {zero}, o use G54", "give with --tools a lathe workbook that has {zero}, or use G54";
        why "Contados desde el cero máquina, los movimientos irían contra el plato.",
            "Counted from machine zero, the motions would run into the chuck.";
        example Example::Command {
            files: &[("p.nc", "T0101|G97 S900 M3|M8|G55|G0 X54. Z2.|G1 X48. F0.2|M30")],
            words: &["simulate", "p.nc", "--stock", "D50xL120", "--dialect", "fanuc-lathe-a"] };
    "L0214" ZeroIsEmpty Stop { code: &'static str, zero: String, cells: String }
        es "el programa usa {code}, pero {zero} está vacío en el libro: {cells}"
        en "the program uses {code}, but {zero} is empty in the workbook: {cells}"
        remedy "rellene {cells}, o use G54", "fill in {cells}, or use G54";
        why "Contados desde el cero máquina, los movimientos irían contra el plato.",
            "Counted from machine zero, the motions would run into the chuck.";
        example blocks!("G55|G1 X48. F0.2|G54");
    "L0215" NothingInTheJaws Stop { left: Bare, right: Bare }
        es "en el segundo amarre no hay material entre las garras: nada sujeta la pieza"
        en "in the second set-up there is no metal between the jaws: nothing holds the part"
        remedy "cambie Z_s (o L4) para que haya un cilindro entre Z{left} y Z{right}, donde están las garras",
            "change Z_s (or L4) so that a cylinder lies between Z{left} and Z{right}, where the jaws are";
        why "Las garras se cerrarían en el vacío.", "The jaws would close on nothing.";
        example book!("lathe", "Z_s" = "500", "PROGRAM 2!A6" = "M30");
    "L0216" HardlyHeld Stop { X: Bare, left: Bare, right: Bare }
        es "en el segundo amarre las garras, cerradas en X{X}, apenas sujetan longitud en Z"
        en "in the second set-up the jaws, closed on X{X}, hold hardly any length along Z"
        remedy "cambie Z_s (o L4) para que haya un cilindro entre Z{left} y Z{right}, donde están las garras",
            "change Z_s (or L4) so that a cylinder lies between Z{left} and Z{right}, where the jaws are";
        why "Sujeta por una línea, la pieza se ladea con la primera pasada y se sale.",
            "A part held along a line tilts at the first pass and comes out.";
        example book!("lathe", "Z_s" = "-1", "PROGRAM 2!A6" = "M30");
    "L0217" HeldAlong Note { X: Bare, length: Size }
        es "en el segundo amarre las garras se cierran en X{X} y sujetan {length}"
        en "in the second set-up the jaws close on X{X} and hold {length}"
        remedy "", "";
        why "Compare el diámetro y la longitud con lo que hay en la máquina.", "Compare the diameter and the length with what is on the machine.";
        example book!("lathe", "Z_s" = "-40", "PROGRAM 2!A6" = "G0 X200. Z100.", "PROGRAM 2!A7" = "M30");
    "L0218" NothingToCompare Caution {}
        es "de la pieza no queda nada que comparar con el perfil de la hoja PERFIL del libro"
        en "nothing is left of the part to compare with the profile on the workbook's sheet PROFILE"
        remedy "corrija el programa, o borre el perfil", "correct the program, or delete the profile";
        why "Una desviación de 0 sin pieza no significa nada.", "A deviation of 0 without a part means nothing.";
        example Example::Made { key: "part-gone", how: t(
            "una barra de 8 mm torneada hasta el eje en toda su longitud, con un perfil",
            "a bar of 8 mm turned down to the axis over its whole length, with a profile") };
    "L0219" ComparisonTooMuchWork Stop { corners: usize, spans: usize }
        es "comparar la pieza ({corners} esquinas) con el perfil de la hoja PERFIL del libro ({spans} tramos) supera el límite de cálculo"
        en "comparing the part ({corners} corners) with the profile on the workbook's sheet PROFILE ({spans} elements) exceeds the limit of the computation"
        remedy "elija una tolerancia eps mayor, o un perfil de menos tramos", "choose a larger tolerance eps, or a profile with fewer elements";
        why "rodete compara cada esquina de la pieza con cada tramo del perfil.", "rodete compares every corner of the part with every element of the profile.";
        example Example::Made { key: "profile-long", how: t(
            "un libro de torno con un perfil de 400 puntos y arcos de radio 2000",
            "a lathe workbook with a profile of 400 points and arcs of radius 2000") };
    "L0220" Compared Note { held: Text, over: Size, most: String, under: Size, least: String }
        es "respecto al perfil de la hoja PERFIL del libro{held}, sobran hasta {over}{most} y faltan hasta {under}{least}"
        en "compared with the profile on the workbook's sheet PROFILE{held}, up to {over} is left{most} and up to {under} is missing{least}"
        remedy "", "";
        why "El metal que sobra se puede repasar; el que falta deja la pieza inservible.", "Metal that is left can be turned again; missing metal scraps the part.";
        example book!("lathe", "PROFILE!A6" = "'1", "PROFILE!B6" = "18", "PROFILE!C6" = "-3", "PROFILE!A7" = "'1", "PROFILE!B7" = "18", "PROFILE!C7" = "-24");
    "L0229" NoMotion Stop {}
        es "el programa no hace ningún movimiento: no se ha simulado nada"
        en "the program makes no motion: nothing was simulated"
        remedy "compruebe que está el programa completo", "check that the whole program is there";
        why "Si no se ha visto ningún movimiento, que no haya alarmas no dice nada.", "Where no motion was seen, the absence of alarms says nothing.";
        example Example::Turning { control: "fanuc-lathe-a", stock: "D50xL120", program: "O0001|G21 G40 G97 G99|M30", machine: &[] };
    "L0230" NothingCut Caution {}
        es "el programa no arranca material en ningún movimiento de trabajo"
        en "no cutting motion of the program removes metal"
        remedy "compruebe el bruto, el cero W1 y los correctores de las herramientas, y X y Z de los ciclos",
            "check the stock, the zero W1 and the tool offsets, and X and Z of the cycles";
        why "Un programa que corta en el aire no da alarmas, y la pieza no se hace.",
            "A program that cuts air raises no alarm, and the part is not made.";
        example Example::Turning { control: "fanuc-lathe-a", stock: "D50xL120", program: "G50 S2500|T0101|G97 S900 M3|M8|G0 X60. Z2.|G1 Z-20. F0.2|G0 X100. Z50.|M30", machine: &[] };
    "L0231" ToolCutsNothing Caution { tool: u32 }
        es "la herramienta T{tool} no arranca material en ningún movimiento de trabajo"
        en "no cutting motion of tool T{tool} removes metal"
        remedy "compruebe X y Z (y sus signos) de sus bloques y ciclos, y su corrector",
            "check X and Z (and their signs) of its blocks and cycles, and its offset";
        why "Una operación en el aire no da alarmas, y falta en la pieza.",
            "An operation in air raises no alarm, and the part lacks it.";
        example Example::Turning { control: "fanuc-lathe-a", stock: "D50xL120", program: "G50 S2500|T0101|G97 S900 M3|M8|G0 X48. Z2.|G1 Z-20. F0.2|G0 X100. Z50.|T0202|G0 X60. Z2.|G1 Z-10. F0.2|G0 X100. Z50.|M30", machine: &[] };
    "L0232" FeedBeyondRapid Stop { feed: Size, axis: char, rapid: Size }
        es "el avance movería el eje {axis} a {feed}, más rápido que su avance rápido de {rapid}"
        en "the feed would move axis {axis} at {feed}, faster than its rapid rate of {rapid}"
        remedy "compruebe F y S (en una rosca, baje S), y si F es por vuelta (G99; Fagor G95) o por minuto (G98; Fagor G94)",
            "check F and S (of a thread, lower S), and whether F is per revolution (G99; Fagor G95) or per minute (G98; Fagor G94)";
        why "El eje no llega a ese avance: la máquina se para o va más despacio, y ni tiempo ni viruta son los calculados.",
            "The axis cannot feed so fast: the machine stops or goes slower, and neither time nor chip is what was computed.";
        example blocks!("X46.|G1 Z-20. F60.|X54.|G0 Z2.");
    "L0234" MetalMissing Caution { held: Text, under: Size, least: String }
        es "respecto al perfil de la hoja PERFIL del libro{held}, faltan hasta {under}{least}"
        en "compared with the profile on the workbook's sheet PROFILE{held}, up to {under} is missing{least}"
        remedy "corrija allí el programa (X, Z, G41 o G42, la punta en HERRAMIENTAS), o el perfil",
            "correct the program there (X, Z, G41 or G42, the nose in TOOLS), or the profile";
        why "El metal que falta deja la pieza inservible: no se puede volver a poner.",
            "Missing metal scraps the part: it cannot be put back.";
        example book!("lathe", "PROGRAM!A43" = "(no thread)", "PROGRAM!A44" = "(no thread)", "PROFILE!A6" = "'1", "PROFILE!B6" = "22", "PROFILE!C6" = "-3", "PROFILE!A7" = "'1", "PROFILE!B7" = "22", "PROFILE!C7" = "-24");
    "L0235" PositionAssumed Caution { X: Bare, Z: Bare }
        es "el programa da coordenadas al sitio en que está la torreta (G50, G92), y el libro no lo da: rodete la supone en X{X} Z{Z} desde M"
        en "the program gives coordinates to the place where the turret stands (G50, G92), and the workbook does not give it: rodete assumes X{X} Z{Z} from M"
        remedy "rellene R_X y R_Z en el libro (hoja DATOS) con el sitio en que empieza el programa",
            "fill in R_X and R_Z in the workbook (sheet DATA) with the place where the program starts";
        why "De ese sitio depende dónde queda la pieza: si no es el de verdad, todos los movimientos y sus alarmas están corridos.",
            "Where the work lies depends on that place: if it is not the true one, all motions and their alarms are shifted.";
        example blocks!("G50 X54. Z2.");
    "L0236" InInches Note {}
        es "el programa tiene cotas en pulgadas: rodete da todas las longitudes en mm"
        en "the program has lengths in inches: rodete gives all lengths in mm"
        remedy "", "";
        why "Los recorridos, correctores y decalajes de las hojas y del informe están en mm; en la pantalla del control, en pulgadas.",
            "Travels, tool offsets and work offsets of sheets and report are in mm; on the control's screen, in inches.";
        example Example::Turning { control: "fanuc-lathe-a", stock: "D50xL120",
            program: "G20 G50 S2500|T0101|G97 S900 M3|M8|G0 X2.2 Z.1|G1 X1.9 F.008|Z-.8|X2.2|G0 X4. Z2.|M30", machine: &[] };
    "L0238" BarHardlyHeld Stop { held: Size, support: Text, least: Size }
        es "en el primer amarre las garras sujetan {held} de la barra{support}"
        en "in the first set-up the jaws hold {held} of the bar{support}"
        remedy "sujete al menos {least}: aumente L4 y, si las garras son cortas, compruebe L2",
            "clamp at least {least}: increase L4 and, if the jaws are short, check L2";
        why "Sujeta por una línea, la barra se ladea con la primera pasada y se sale. Vale el menor de L4 y L2.",
            "A bar held along a line tilts at the first pass and comes out. The lesser of L4 and L2 counts.";
        example book!("lathe", "L4" = "0.5");
    "L0239" BarInTheBody Note { held: Size }
        es "no hay garras (L2 es 0): se supone que el plato sujeta los {held} de L4, como una pinza"
        en "there are no jaws (L2 is 0): the chuck is taken to hold the {held} of L4, as a collet does"
        remedy "", "";
        why "Con garras, escriba L2: lo que sobresalen se vigila, y sujetan como mucho esa longitud.",
            "With jaws, fill in L2: what stands out is watched, and they hold that length at most.";
        example book!("lathe", "L2" = "0");
    "L0240" ContourOutsideBar Caution { first: u32, last: u32, X: Bare, bar: Size, cell: String }
        es "el contorno de N{first} a N{last} llega a X{X}, fuera de la barra: D es {bar}{cell}"
        en "the contour from N{first} to N{last} goes to X{X}, outside the bar: D is {bar}{cell}"
        remedy "tome una barra de {X} mm o más (D del libro, o --stock), o corrija el contorno",
            "take a bar of {X} mm or more (D of the workbook, or --stock), or correct the contour";
        why "Lo que la barra no tiene no se puede tornear: la pieza sale sin ese escalón, y la herramienta pasa allí por el aire.",
            "What the bar does not have cannot be turned: the part comes out without that shoulder, and the tool passes through air there.";
        example Example::Turning { control: "fanuc-lathe-a", stock: "D50xL120",
            program: "G21 G99 G50 S2500|T0101|G97 S900 M3|M8|G0 X64. Z2.|G71 U2. R.5|G71 P10 Q20 U.5 W.1 F.25|N10 G0 X44.|G1 Z-20. F.1|X60.|Z-40.|N20 X64.|G70 P10 Q20|G0 X100. Z50.|M30", machine: &[] };
    "L0253" CutsBehindParting Caution {}
        es "tras tronzar una pieza el programa sigue cortando en la barra: los resultados son los de lo que queda en el plato, no los de la pieza tronzada"
        en "after parting a piece off the program goes on cutting the bar: the results are those of what stays in the chuck, not of the piece that was parted off"
        remedy "si la pieza es la tronzada, simule lo que sigue al tronzado como otro programa, con su bruto",
            "if the part is the piece that was parted off, simulate what follows the parting-off as another program, with its own stock";
        why "rodete da una sola pieza de cada programa, y aquí puede ser una u otra.",
            "rodete gives one part for each program, and here it may be either.";
        example Example::Turning { control: "fanuc-lathe-a", stock: "D26xL120",
            program: "G50 S2500|T0303|G97 S600 M3|M8|G0 X30. Z-10.|G1 X-0.5 F0.06|G0 X30.|X100. Z50.|T0101|G97 S900 M3|G0 X22. Z-8.|G1 Z-20. F0.2|X30.|G0 X100. Z50.|M30", machine: &[("D", "26"), ("tailstock", "no")] };
}
