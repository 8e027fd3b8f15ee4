//! What is told of a turning's workbook, and of following its programs beside the alarms.
//!
//! Codes P4001 on are of values that contradict each other, L0205 to L0220 of what was followed.

use crate::finding::rule::{book, rules};
use crate::finding::{Example, Size};
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
        en "L4 is {L4}, must be less than L = {L}"
        remedy "sujete menos, o un bruto más largo", "hold less, or take a longer stock";
        why "De un bruto metido entero en las garras no sale nada que tornear.", "Of a stock that is all in the jaws nothing stands out to be turned.";
        example book!("lathe", "L4" = "130");
    "P4002" FacingBeyondOverhang Stop { L5: Size, overhang: Size }
        es "L5 es {L5} y debe ser menor que el voladizo de {overhang}"
        en "L5 is {L5}, must be less than the overhang of {overhang}"
        remedy "un refrentado menor", "a smaller facing allowance";
        why "El cero W1 quedaría dentro de las garras.", "The zero W1 would lie inside the jaws.";
        example book!("lathe", "L4" = "80", "L5" = "50");
    "P4003" BoreBeyondStock Stop { d: Size, D: Size }
        es "el agujero d es {d} y debe ser menor que D = {D}"
        en "the bore d is {d}, must be less than D = {D}"
        remedy "corrija d o D", "correct d or D";
        why "Entre el agujero y la superficie tiene que quedar pared.", "Between bore and surface a wall must be left.";
        example book!("lathe", "d" = "60");
    "P4004" SlideTravelReversed Stop { low: &'static str, least: Size, high: &'static str, greatest: Size }
        es "{low} es {least} y debe ser menor que {high} = {greatest}"
        en "{low} is {least}, must be less than {high} = {greatest}"
        remedy "corrija el recorrido", "correct the travel";
        why "Entre límites al revés no cabe ninguna posición.", "No position lies between limits that are the wrong way round.";
        example book!("lathe", "X_min" = "100", "X_max" = "-100");
    "P4005" BodyReversed Stop { low: &'static str, least: Size, high: &'static str, greatest: Size }
        es "{low} es {least} y debe ser menor que {high} = {greatest}"
        en "{low} is {least}, must be less than {high} = {greatest}"
        remedy "corrija el cuerpo de la torreta", "correct the turret's body";
        why "Un cuerpo con los lados cambiados no ocupa lugar, y no chocaría con nada.",
            "A body with its sides exchanged takes no room, and would hit nothing.";
        example book!("lathe", "BX_min" = "100", "BX_max" = "-100", "BZ_min" = "0", "BZ_max" = "10");
    "P4006" BodyHalfGiven Stop { lost: String }
        es "el cuerpo de la torreta se da con sus cuatro medidas; faltan: {lost}"
        en "the turret's body is given by all four of its sizes; empty: {lost}"
        remedy "rellene las cuatro, o vacíelas todas para no vigilar el cuerpo",
            "fill in all four, or empty all of them not to watch the body";
        why "Con medidas de menos no se sabe qué ocupa, y quien las escribe cuenta con que se vigile.",
            "With sizes missing it is not known what it takes up, and who fills them in reckons that it is watched.";
        example book!("lathe", "BX_min" = "0");
    "P4007" ReferenceHalfGiven Stop {}
        es "el punto de referencia se da con X y Z, y solo hay una"
        en "the reference point is given by X and Z, and only one of them is"
        remedy "rellene R_X y R_Z, o vacíe las dos", "fill in R_X and R_Z, or empty both";
        why "Los ceros de la máquina se cuentan desde ahí: media referencia los pondría en otra parte.",
            "The machine's zeros count from there: half a reference would put them elsewhere.";
        example book!("lathe", "R_X" = "400");
    "P4008" PointRuleMissing Stop {}
        es "falta decir qué es una cota sin punto decimal: depende de un parámetro del control"
        en "it must be said what a dimension without a decimal point is: a setting of the control decides"
        remedy "escriba calculadora o micras, según el parámetro DPI de su control",
            "write calculator or micrometre, by the parameter DPI of your control";
        why "Según ese ajuste X100 son 100 mm o una décima.", "By that setting X100 is 100 mm or a tenth of one.";
        example book!("lathe", "point" = "");
    "P4009" PlaceTwice Stop { T: u32 }
        es "el puesto {T} de la torreta está dos veces"
        en "place {T} of the turret is given twice"
        remedy "una herramienta por puesto", "one tool for each place";
        why "Con dos herramientas en un puesto no se sabe cuál corta.", "With two tools in one place it is not known which one cuts.";
        example book!("lathe", "TOOLS!A7" = "1");
    "P4010" ToolCannotBe Stop { T: u32, why: Text }
        es "herramienta {T}: {why}"
        en "tool {T}: {why}"
        remedy "compruebe las medidas de la herramienta", "check the sizes of the tool";
        why "De medidas que no van juntas no sale el perfil con el que la herramienta corta.",
            "From sizes that do not go together no outline follows that the tool could cut with.";
        example book!("lathe", "TOOLS!H6" = "90");
    "P4011" OffsetTwice Stop { D: u32 }
        es "el corrector {D} está dos veces"
        en "offset {D} is given twice"
        remedy "un corrector por herramienta", "one offset for each tool";
        why "Un corrector lleva las medidas de una sola herramienta.", "An offset carries the sizes of one tool alone.";
        example book!("lathe", "TOOLS!B7" = "1");
    "P4012" ToolColumnMissing Stop { T: u32, symbol: &'static str }
        es "la herramienta {T} necesita {symbol}"
        en "tool {T} needs {symbol}"
        remedy "la hoja no tiene la columna {symbol}: escriba su título y los valores",
            "the sheet has no column {symbol}: write its heading and the values";
        why "Sin esa medida no se sabe qué forma tiene la herramienta.", "Without that size the tool's shape is not known.";
        example book!("lathe", "TOOLS!F4" = "", "TOOLS!F5" = "");
    "P4013" ToolShapeMissing Stop { T: u32, symbol: &'static str }
        es "la herramienta {T} necesita {symbol}"
        en "tool {T} needs {symbol}"
        remedy "elija la letra de la norma ISO 1832", "choose the letter of ISO 1832";
        why "La letra da el ángulo de la placa.", "The letter gives the insert's angle.";
        example book!("lathe", "TOOLS!E6" = "");
    "P4014" ToolSizeMissing Stop { T: u32, symbol: &'static str }
        es "la herramienta {T} necesita {symbol}"
        en "tool {T} needs {symbol}"
        remedy "rellene la celda", "fill the cell in";
        why "Sin esa medida no se sabe qué forma tiene la herramienta.", "Without that size the tool's shape is not known.";
        example book!("lathe", "TOOLS!F6" = "");
    "P4015" ProfileOfOnePoint Stop {}
        es "el perfil tiene un solo punto"
        en "the profile has one point only"
        remedy "escriba también dónde termina, o borre la fila", "write where it ends too, or delete the row";
        why "Con un punto no se compara ninguna línea.", "One point is no line to compare with.";
        example book!("lathe", "PROFILE!A6" = "'1", "PROFILE!B6" = "20", "PROFILE!C6" = "0");
    "P4016" ArcWithoutRadius Stop {}
        es "el arco del perfil no tiene radio"
        en "the arc of the profile has no radius"
        remedy "escriba el radio", "write the radius";
        why "Por dos puntos pasan todos los arcos que se quiera.", "Any number of arcs lead through two points.";
        example book!("lathe", "PROFILE!A6" = "'1", "PROFILE!B6" = "20", "PROFILE!C6" = "0",
            "PROFILE!A7" = "'3", "PROFILE!B7" = "50", "PROFILE!C7" = "-15");
    "P4017" ArcFallsShort Stop { r: Size, chord: Size, half: Size }
        es "el arco del perfil tiene {r} de radio y su cuerda mide {chord}: no llega a su final"
        en "the arc of the profile has a radius of {r} and a chord of {chord}: it does not reach its end"
        remedy "dé un radio de al menos {half}", "give a radius of at least {half}";
        why "Un arco abarca a lo sumo su diámetro.", "An arc spans its diameter at most.";
        example book!("lathe", "PROFILE!A6" = "'1", "PROFILE!B6" = "20", "PROFILE!C6" = "0",
            "PROFILE!A7" = "'2", "PROFILE!B7" = "50", "PROFILE!C7" = "-20", "PROFILE!D7" = "5");
    "P4018" ArcWithoutChord Stop { r: Size, chord: Size }
        es "el arco del perfil tiene {r} de radio y su cuerda mide {chord}: no llega a su final"
        en "the arc of the profile has a radius of {r} and a chord of {chord}: it does not reach its end"
        remedy "corrija X y Z: el arco termina donde empieza", "correct X and Z: the arc ends where it begins";
        why "Un perfil no da la vuelta entera a un punto.", "A profile does not go a whole turn about a point.";
        example book!("lathe", "PROFILE!A6" = "'1", "PROFILE!B6" = "20", "PROFILE!C6" = "0",
            "PROFILE!A7" = "'2", "PROFILE!B7" = "20", "PROFILE!C7" = "0", "PROFILE!D7" = "5");
    "P4019" SubprogramOnTwoSheets Stop { name: String, first: String, last: String }
        es "el subprograma {name} está dos veces: en las hojas \"{first}\" y \"{last}\""
        en "subprogram {name} is given twice: on the sheets \"{first}\" and \"{last}\""
        remedy "deje una de las dos hojas", "leave one of the two sheets";
        why "O5 y O0005 son un mismo número, y el control solo guarda un subprograma de cada uno.",
            "O5 and O0005 are one number, and the control keeps one subprogram of each.";
        example Example::Made { key: "subprogram-sheets", how: t(
            "un libro de torno con las hojas de subprograma O0005 y O5", "a lathe workbook with the subprogram sheets O0005 and O5") };

    "L0205" NotJudgedFromHere Note {}
        es "desde este bloque no se juzgan los movimientos: sus alarmas serían consecuencia de él"
        en "from this block on motions are not judged: their alarms would follow from it"
        remedy "", "";
        why "Sin ese bloque la herramienta no está donde el programa la quiere, y lo que siga no dice nada de él.",
            "Without that block the tool is not where the program means it to be, and what follows says nothing of it.";
        example blocks!("G1 X4,5|G0 X40.");
    "L0206" ProgramNotJudged Note {}
        es "no se juzgan los movimientos de este programa: la pieza no es la que se pide, o nada la sujeta"
        en "the motions of this program are not judged: the part is not what is meant, or nothing holds it"
        remedy "", "";
        why "El programa de la segunda colocación cuenta con la pieza que el primero deja.",
            "The program of the second set-up reckons with the part that the first one leaves.";
        example book!("lathe", "PROGRAM!A7" = "N5 G199", "PROGRAM 2!A6" = "T0101", "PROGRAM 2!A7" = "G0 X100. Z50.");
    "L0207" TooManyMotions Stop { most: usize }
        es "el programa hace más de {most} movimientos"
        en "the program makes more than {most} motions"
        remedy "divídalo, o repita menos los subprogramas", "split it, or repeat its subprograms less often";
        why "Los movimientos se entregan en una hoja, y más filas no caben en ella.",
            "The motions are delivered on a sheet, and it has no more rows.";
        example Example::Made { key: "program-many-motions", how: t(
            "un programa que llama con M98 P9999 a un subprograma que llama así a otro de dos movimientos",
            "a program that calls with M98 P9999 a subprogram that calls another one of two motions likewise") };
    "L0208" ThreadTooMuchWork Stop { made: usize, lead: Size, turns: Size }
        es "seguir esta rosca pide más trabajo del que se hace; movimientos hechos hasta ella: {made}"
        en "to follow this thread takes more work than is done; motions made before it: {made}"
        remedy "compruebe F: con un paso de {lead} el husillo da {turns} vueltas", "check F: at a lead of {lead} the spindle makes {turns} turns";
        why "Una rosca se sigue vuelta a vuelta; con una F de más decimales no acaba.",
            "A thread is followed turn by turn; with decimals too many in F that does not end.";
        example Example::Turning { control: "fanuc-lathe-a", stock: "D50xL120",
            program: "T0404|G97 S500 M3|G0 X40. Z3000.|G32 Z2000. F0.00001|M30", machine: &[] };
    "L0209" TooMuchWork Stop { made: usize }
        es "seguir el programa pide más trabajo del que se hace; movimientos hechos hasta este bloque: {made}"
        en "to follow the program takes more work than is done; motions made before this block: {made}"
        remedy "divida el programa, o elija una tolerancia eps mayor, o pasadas y pasos mayores",
            "split the program, or choose a greater tolerance eps, or greater passes and leads";
        why "Cada movimiento se corta del contorno entero: con muchas esquinas y muchas pasadas no acaba en un tiempo razonable.",
            "Each motion is cut off the whole contour: with many corners and many passes that does not end in any reasonable time.";
        example Example::Turning { control: "fanuc-lathe-a", stock: "D50xL120",
            program: "G50 S2500|T0404|G97 S500 M3|M8|G0 X54. Z2.|X49.9|G32 Z-80. F.0077|G0 X54.|Z-1.|G1 X51. F.1|M98 P99990005|G0 X100. Z50.|M30|O0005|G1 U-1.3|U1.3 W-.008|M99",
            machine: &[] };
    "L0210" MachineZeroAssumed Caution {}
        es "G53 sin punto de referencia en el libro: se supone que cuenta desde M, la cara del husillo, y no desde el punto de referencia"
        en "G53 without a reference point in the workbook: it is taken to count from M, the face of the spindle, and not from the reference point"
        remedy "rellene R_X y R_Z en el libro (hoja DATOS)", "fill in R_X and R_Z in the workbook (sheet DATA)";
        why "Desde el otro cero la herramienta iría a otro sitio, y en rápido.", "From the other zero the tool would go elsewhere, and at rapid.";
        example blocks!("G53 G0 X400. Z400.");
    "L0211" ReferenceAssumed Note { X: Size, Z: Size }
        es "el libro no da el punto de referencia: se supone en X{X} Z{Z} desde M"
        en "the workbook gives no reference point: it is taken at X{X} Z{Z} from M"
        remedy "rellene R_X y R_Z en el libro (hoja DATOS)", "fill in R_X and R_Z in the workbook (sheet DATA)";
        why "De dónde está depende el camino de G28.", "The way of G28 depends on where it is.";
        example blocks!("G28 U0. W0.");
    "L0212" MoreAlarms Note { count: usize }
        es "y {count} alarmas más: rodete view las muestra en la pieza"
        en "and {count} more alarms: rodete view shows them on the part"
        remedy "", "";
        why "Se listan las más graves: las demás suelen venir de la misma causa.",
            "The gravest are listed: the others mostly come of the same cause.";
        example Example::Made { key: "program-many-alarms", how: t(
            "un programa que entra sesenta veces en rápido en el material, cada vez en otra línea",
            "a program that enters metal at rapid sixty times, in another line each time") };
    "L0213" ZeroNotKnown Stop { code: &'static str, zero: String }
        es "se usa {code}, pero sin libro no se sabe dónde está {zero}"
        en "{code} is used, but without a workbook it is not known where {zero} is"
        remedy "indique con --tools un libro de torno con {zero}, o use G54", "name a lathe workbook with {zero} with --tools, or use G54";
        why "Contados desde el cero de la máquina los movimientos irían contra el plato.",
            "Counted from the machine's zero the motions would run into the chuck.";
        example Example::Command {
            files: &[("p.nc", "T0101|G97 S900 M3|M8|G55|G0 X54. Z2.|G1 X48. F0.2|M30")],
            words: &["simulate", "p.nc", "--stock", "D50xL120", "--dialect", "fanuc-lathe-a"] };
    "L0214" ZeroIsEmpty Stop { code: &'static str, zero: String, cells: String }
        es "se usa {code}, pero {zero} está vacío en el libro: {cells}"
        en "{code} is used, but {zero} is empty in the workbook: {cells}"
        remedy "rellene {cells}, o use G54", "fill in {cells}, or use G54";
        why "Contados desde el cero de la máquina los movimientos irían contra el plato.",
            "Counted from the machine's zero the motions would run into the chuck.";
        example blocks!("G55|G1 X48. F0.2|G54");
    "L0215" NothingInTheJaws Stop { left: Size, right: Size }
        es "en la segunda colocación no hay material entre las garras: nada sujeta la pieza"
        en "in the second set-up there is no metal between the jaws: nothing holds the part"
        remedy "cambie Z_s (o L4) hasta que entre Z{left} y Z{right}, donde están las garras, haya un cilindro",
            "change Z_s (or L4) until a cylinder lies between Z{left} and Z{right}, where the jaws are";
        why "Las garras se cerrarían en el vacío.", "The jaws would close on nothing.";
        example book!("lathe", "Z_s" = "500", "PROGRAM 2!A6" = "M30");
    "L0216" HardlyHeld Stop { X: Size, left: Size, right: Size }
        es "en la segunda colocación las garras, cerradas en X{X}, apenas sujetan la pieza a lo largo de Z"
        en "in the second set-up the jaws, closed on X{X}, hardly hold the part along Z"
        remedy "cambie Z_s (o L4) hasta que entre Z{left} y Z{right}, donde están las garras, haya un cilindro",
            "change Z_s (or L4) until a cylinder lies between Z{left} and Z{right}, where the jaws are";
        why "Sujeta en una línea, la pieza se ladea con la primera pasada y se sale.",
            "Held along a line, the part tilts at the first pass and comes out.";
        example book!("lathe", "Z_s" = "-1", "PROGRAM 2!A6" = "M30");
    "L0217" HeldAlong Note { X: Size, length: Size }
        es "en la segunda colocación las garras se cierran en X{X} y sujetan {length}"
        en "in the second set-up the jaws close on X{X} and hold {length}"
        remedy "", "";
        why "Quien prepara la máquina lo compara con lo que tiene delante.", "Who sets the machine up compares it with what is there.";
        example book!("lathe", "Z_s" = "-40", "PROGRAM 2!A6" = "M30");
    "L0218" NothingToCompare Caution {}
        es "de la pieza no queda nada que comparar con el perfil de la hoja PERFIL del libro"
        en "nothing is left of the part to hold against the profile on the workbook's sheet PROFILE"
        remedy "corrija el programa, o borre el perfil", "correct the program, or delete the profile";
        why "Una desviación de 0 de una pieza que no está no dice nada.", "A deviation of 0 of a part that is not there says nothing.";
        example Example::Made { key: "part-gone", how: t(
            "una barra de 8 mm torneada hasta el eje en toda su longitud, con un perfil",
            "a bar of 8 mm turned down to the axis over its whole length, with a profile") };
    "L0219" ComparisonTooMuchWork Stop { corners: usize, spans: usize }
        es "comparar la pieza ({corners} esquinas) con el perfil de la hoja PERFIL del libro ({spans} tramos) pide más trabajo del que se hace"
        en "to hold the part ({corners} corners) against the profile on the workbook's sheet PROFILE ({spans} spans) takes more work than is done"
        remedy "elija una tolerancia eps mayor, o un perfil de menos tramos", "choose a greater tolerance eps, or a profile of fewer spans";
        why "Cada esquina de la pieza se compara con cada tramo del perfil.", "Every corner of the part is held against every span of the profile.";
        example Example::Made { key: "profile-long", how: t(
            "un libro de torno con un perfil de 400 puntos y arcos de radio 2000",
            "a lathe workbook with a profile of 400 points and arcs of radius 2000") };
    "L0220" Compared Note { over: Size, most: String, under: Size, least: String }
        es "frente al perfil de la hoja PERFIL del libro sobran hasta {over}{most} y faltan hasta {under}{least}"
        en "against the profile on the workbook's sheet PROFILE up to {over} are left{most} and up to {under} are missing{least}"
        remedy "", "";
        why "Lo que sobra se repasa; lo que falta es pieza perdida.", "What is left is turned again; what is missing is a part lost.";
        example book!("lathe", "PROFILE!A6" = "'1", "PROFILE!B6" = "20", "PROFILE!C6" = "-3", "PROFILE!A7" = "'1", "PROFILE!B7" = "20", "PROFILE!C7" = "-29");
}
