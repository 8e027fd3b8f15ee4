//! The rows of what lathes do in their own way, and of tools.

use crate::finding::Example;
use crate::finding::rule::rules;

rules! {
    /// The rows of this file.
    RULES;

    "G0800" TwoWordsAnAxis Stop { axis: char, step: char }
        es "{axis} y {step} en un bloque: las dos mueven el eje {axis}"
        en "{axis} and {step} in one block: both move the axis {axis}"
        remedy "deje una de las dos", "leave one of the two";
        why "El control no sabe cuál de las dos vale.", "The control does not know which of the two holds.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G1 Z-1. W2.|M30", "3:4");
    "G0801" MachineMoveByIncrements Stop {}
        es "G53 con cotas incrementales"
        en "G53 with incremental coordinates"
        remedy "dé X y Z", "give X and Z";
        why "Las cotas de G53 son de la máquina, y son absolutas.", "The dimensions of G53 are the machine's, and absolute.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G53 G0 U5.|M30", "3:8");
    "G0802" G91InSystemA Caution {}
        es "G91 no es un código del sistema A: leído como si no estuviera, X y Z siguen absolutas"
        en "G91 is no code of system A: read as if it were not there, X and Z stay absolute"
        remedy "escriba los incrementos con U y W", "write increments with U and W";
        why "En el sistema A los incrementos son U y W.", "In system A increments are U and W.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G91|G0 X60.|M30", "3:1");
    "G0803" SystemShifted Caution {}
        es "G54 a G59 con X o Z y sin G0 ni G1: se desplaza el sistema desde el cero W1, sin movimiento; un Fanuc se movería"
        en "G54 to G59 with X or Z and without G0 or G1: the system is shifted from the zero W1, without motion; a Fanuc would move"
        remedy "escriba G0 o G1 en el bloque si ha de ser un movimiento", "write G0 or G1 in the block if it is to move";
        why "Según el control el bloque desplaza el cero o mueve la herramienta.",
            "By the control the block shifts the zero or moves the tool.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G54 X30. Z15.|G0 X60.|M30", "3:1");
    "G0804" ReferencePointNotSupported Stop { value: f64 }
        es "G30 P{value}: el tercer y el cuarto punto de referencia no están implementados"
        en "G30 P{value}: the third and fourth reference points are not supported"
        remedy "use G30 P2 o G53", "use G30 P2, or G53";
        why "Dónde están lo dicen parámetros del control.", "Where they lie is told by the control's parameters.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G30 P3 U0|M30", "3:5");
    "G0805" ReferenceWithoutAxes Stop { code: u8 }
        es "G{code} sin ejes"
        en "G{code} without axes"
        remedy "programe G{code} U0 W0", "program G{code} U0 W0";
        why "Sin ejes el control no mueve nada, y el programa cuenta con que está lejos.",
            "Without axes the control moves nothing, and the program reckons that it is far away.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G28|M30", "3:1");
    "G0806" ReferencePointNotKnown Caution { code: u8, first: u32, last: u32 }
        es "punto de referencia de G{code} no conocido: se toma el cero de la máquina"
        en "reference point of G{code} not known: the machine's zero is taken"
        remedy "dé los parámetros {first} y {last} (X como radio, Z)",
            "give the parameters {first} and {last} (X as radius, Z)";
        why "El camino hasta el punto de referencia puede cruzar la pieza.",
            "The way to the reference point may cross the work.";
        example Example::program("fanuc-lathe-a", "(stock D50xL120)|O0015|G50 S2500|T0101|G96 S180 M3|M8|G54|G0 X54. Z2.|X46.|G1 Z-20. F0.25|U3.|G0 Z2.|G28 W0.|G0 Z2.|X42.|G1 Z-15. F0.25|U3.|G0 X100. Z60. M9|G28 U0. W0.|M30", "13:1");
    "G0807" StaleFeed Caution {}
        es "el avance por minuto o por vuelta ha cambiado y F no se ha vuelto a dar: vale el número de antes"
        en "feed per minute or per revolution has changed and F was not given again: its old number holds"
        remedy "dé F con el cambio", "give F with the change";
        why "0.2 mm por vuelta leídos por minuto paran la herramienta; 100 mm por minuto leídos por vuelta la rompen.",
            "0.2 mm a revolution read per minute stops the tool; 100 mm a minute read per revolution breaks it.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G1 X48.|G98|X46.|M30", "5");
    "G0808" BeyondAxis Caution {}
        es "X negativo: el punto programado pasa del eje de giro"
        en "negative X: the programmed point is beyond the axis"
        remedy "compruebe el signo y que X es un diámetro", "check the sign, and that X is a diameter";
        why "Al refrentar se pasa un poco del eje; más lejos es un signo de más.",
            "Facing goes a little beyond the axis; farther is a slip of the sign.";
        example Example::program("fanuc-lathe-a", "(stock D50xL120)|(alarms 151@8)|O0100|T0101|G96 S180 M3|M8|G0 X54. Z0.|G1 X-1.6 F0.1|G0 Z2.|X100. Z50. M9|M30", "8:4");
    "G0809" RefusedInLoop Stop { times: u32 }
        es "el bloque se ha rehusado {times} veces en un bucle; no se lee más"
        en "the block was refused {times} times in a loop; nothing more is read"
        remedy "corrija el bloque", "correct the block";
        why "Cada vuelta diría lo mismo.", "Each round would say the same.";
        example Example::program("linuxcnc", "G21 G90 F100|o1 repeat [200]|  G1 X1 B|o1 endrepeat|M2", "3");
    "G0810" EndlessLoop Stop { rounds: u32 }
        es "bucle sin fin: {rounds} vueltas sin que nada se mueva ni cambie ningún parámetro"
        en "endless loop: {rounds} rounds in which nothing moves and no parameter changes"
        remedy "cambie dentro del bucle lo que su condición compara; las entradas de la máquina no se conocen",
            "change what its condition compares inside the loop; the machine's inputs are not known";
        why "Si nada cambia, la condición tampoco.", "Where nothing changes the condition does not either.";
        example Example::program("linuxcnc", "G21 G90 F100|o1 while [1]|o1 endwhile|M2", "3");
    "G0811" TooManyCycleMotions Stop { most: u64 }
        es "los ciclos fijos del programa pasan de {most} movimientos; no se lee más"
        en "the program's canned cycles come to more than {most} motions; nothing more is read"
        remedy "menos agujeros, o pasadas mayores", "fewer holes, or greater pecks";
        why "Tantos movimientos salen de una cota en otra unidad.", "So many motions come of a dimension in another unit.";
        example Example::program("linuxcnc", "G21 G90 F100 S500 M3|G0 Z5|G91 G99 G81 X1 R-1 Z-1 L9999|L9999|M2", "3");
    "G0812" ToolTwiceInTable Stop { word: String }
        es "{word} está dos veces en la tabla"
        en "{word} stands twice in the tool table"
        remedy "escriba una herramienta por línea: T1 P1 Z10.5 D6", "write one tool a line: T1 P1 Z10.5 D6";
        why "No se sabe cuál de las dos longitudes vale.", "Which of the two lengths holds is not known.";
        example Example::Program { control: "linuxcnc", program: "G21 G90 F100|T1 M6|M2", at: "2:1", given: &[("--tools", "T1 Z10|T1 Z20")] };
    "G0813" NoWordOfToolTable Stop { word: String }
        es "«{word}» no es una palabra de la tabla de herramientas"
        en "'{word}' is no word of a tool table"
        remedy "escriba una herramienta por línea: T1 P1 Z10.5 D6", "write one tool a line: T1 P1 Z10.5 D6";
        why "Una longitud mal leída lleva la herramienta a otra altura.",
            "A length that is read wrongly takes the tool to another height.";
        example Example::Program { control: "linuxcnc", program: "G21 G90 F100|T1 M6|M2", at: "1:4", given: &[("--tools", "T1 Z1,5")] };
    "G0820" NoToolNumber Stop { value: f64 }
        es "{value} no es un número de herramienta"
        en "{value} is no tool number"
        remedy "dé un número entero", "give a whole number";
        why "Las herramientas se numeran con enteros.", "Tools are numbered with whole numbers.";
        example Example::program("linuxcnc", "; expected: 4:1 1.5 is no tool number|; rs274: refuses|G21 G90 F100|T1.5 M6|M2", "4:1");
    "G0821" ToolNotInTable Stop { tool: u32 }
        es "la herramienta {tool} no está en la tabla"
        en "tool {tool} is not in the tool table"
        remedy "añádala a la tabla de herramientas", "add it to the tool table";
        why "Sin sus longitudes la herramienta iría a otra altura.",
            "Without its lengths the tool would go to another height.";
        example Example::Program { control: "linuxcnc", program: "G21 G90 F100|T9 M6|M2", at: "2:1", given: &[("--tools", "T1 Z10")] };
    "G0822" SetToolWithoutQ Stop {}
        es "M61 sin Q"
        en "M61 without Q"
        remedy "dé Q", "give Q";
        why "Q dice qué herramienta está puesta.", "Q says which tool is in the spindle.";
        example Example::program("linuxcnc", "G21 G90 F100|M61|M2", "2:1");
    "G0823" ChangeWithoutTool Stop {}
        es "M6 sin herramienta elegida con T"
        en "M6 without a tool selected by T"
        remedy "programe T antes de M6", "program T before M6";
        why "El control pondría la que T eligió la última vez.", "The control would put in whatever T selected last.";
        example Example::program("linuxcnc", "; expected: 4:1 M6 without a tool selected by T|; rs274: accepts: it unloads the tool, which nobody has asked for|G21 G90 F100|M6|M2", "4:1");
    "G0824" OffsetMeasuredAtMachine Note {}
        es "la cabecera nombra esta herramienta; su corrector, que se mide en la máquina, vale aquí 0"
        en "the header names this tool; its offset, which is measured at the machine, is taken as 0 here"
        remedy "", "";
        why "La longitud de una herramienta se mide al montarla.", "The length of a tool is measured as it is mounted.";
        example Example::program("linuxcnc", "(RODETE 0.1.0 - DIALECT LINUXCNC)|(TOOL T1 D1)|G21 G90 F100|G43 H1|M2", "4");
    "G0825" NoToolTable Caution {}
        es "sin tabla de herramientas: las longitudes valen 0"
        en "no tool table: tool lengths are taken as 0"
        remedy "indique la tabla con --tools", "name the table with --tools";
        why "Las posiciones que se comprueban son las de una herramienta de longitud 0.",
            "The positions that are checked are those of a tool of length 0.";
        example Example::program("fanuc-lathe-a", "T0909|M30", "1");
    "G0826" LengthWithoutAxes Stop {}
        es "G43.1 sin palabras de eje"
        en "G43.1 without axis words"
        remedy "dé la longitud en su eje", "give the length on its axis";
        why "La longitud va en la palabra de su eje.", "The length goes in the word of its axis.";
        example Example::program("linuxcnc", "; expected: 4:1 G43.1 without axis words|; rs274: accepts: it changes nothing, so that the axis word has been forgotten|G21 G90 F100|G43.1|M2", "4:1");
    "G0827" AddedLength Stop {}
        es "G43.2 espera o H o palabras de eje"
        en "G43.2 wants either H or axis words"
        remedy "deje uno de los dos", "leave one of the two";
        why "O la longitud está en la tabla, o está en el bloque.", "The length stands either in the table or in the block.";
        example Example::program("linuxcnc", "; expected: 4:1 G43.2 wants either H or axis words|; rs274: refuses|G21 G90 F100|G43.2|M2", "4:1");
    "G0828" ToolTableNotKnown Stop {}
        es "G10 cambia una tabla de herramientas desconocida"
        en "G10 changes a tool table that is not known"
        remedy "indique la tabla con --tools", "name the table with --tools";
        why "Sin tabla no hay nada que cambiar.", "Without a table there is nothing to change.";
        example Example::program("linuxcnc", "; expected: 4:1 G10 L1, L10 or L11 without values|; rs274: refuses|G21 G90 F100|G10 L1 P1|M2", "4:1");
    "G0829" ToolOffsetWithoutValues Stop {}
        es "G10 L1, L10 o L11 sin valores"
        en "G10 L1, L10 or L11 without values"
        remedy "dé los valores que cambian", "give the values that change";
        why "El bloque no cambiaría nada.", "The block would change nothing.";
        example Example::Program { control: "linuxcnc", program: "G21 G90 F100|G10 L1 P1|M2", at: "2:1", given: &[("--tools", "T1 Z10")] };
    "G0830" NoOrientation Stop { value: f64 }
        es "Q{value} no es una orientación"
        en "Q{value} is no orientation"
        remedy "Q va de 0 a 9", "Q goes from 0 to 9";
        why "La orientación dice hacia dónde mira la punta.", "The orientation says which way the tip looks.";
        example Example::Program { control: "linuxcnc", program: "G21 G90 F100|G10 L1 P1 Q12|M2", at: "2:11", given: &[("--tools", "T1 Z10")] };
    "G0831" NoTurretPlace Stop { value: f64 }
        es "T{value} no es un puesto con su corrector"
        en "T{value} is no place with its offset"
        remedy "escriba T0101: puesto 01, corrector 01", "write T0101: place 01, offset 01";
        why "Las dos primeras cifras son el puesto y las dos últimas el corrector.",
            "The first two digits are the place and the last two the offset.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|T10101|M30", "3:1");
    "G0832" OffsetAlone Stop { value: f64, offset: u32, whole: String }
        es "T{value} no nombra ningún puesto de la torreta, solo el corrector {offset}"
        en "T{value} names no place of the turret, only offset {offset}"
        remedy "escriba T{whole}: puesto y corrector con dos cifras cada uno",
            "write T{whole}: place and offset with two digits each";
        why "Con una sola cifra la torreta no gira: corta la herramienta que está puesta.",
            "With one digit alone the turret does not turn: the tool that is there cuts.";
        example Example::program("fanuc-lathe-a", "T3|M30", "1:1");
    "G0833" OffsetNotInTable Stop { offset: u32 }
        es "el corrector {offset} no está en la tabla"
        en "offset {offset} is not in the tool table"
        remedy "añádalo a una herramienta: en un libro, hoja HERRAMIENTAS, columna D",
            "give it to a tool: in a workbook on the sheet TOOLS, column D";
        why "Sin sus longitudes la punta iría a otro sitio.", "Without its lengths the tip would go elsewhere.";
        example Example::Program { control: "fanuc-lathe-a", program: "T0109 S500 M3|G0 X50. Z5.|M30", at: "1:1", given: &[("--tools", "T1 Z10")] };
    "G0834" ToolNotInTurret Stop { tool: u32 }
        es "la herramienta {tool} no está en la tabla"
        en "tool {tool} is not in the tool table"
        remedy "añádala a la torreta: en un libro, hoja HERRAMIENTAS, columna T",
            "mount it in the turret: in a workbook on the sheet TOOLS, column T";
        why "La torreta giraría a un puesto vacío o a otra herramienta.",
            "The turret would turn to an empty place, or to another tool.";
        example Example::Program { control: "fanuc-lathe-a", program: "T0901 S500 M3|G0 X50. Z5.|M30", at: "1:1", given: &[("--tools", "T1 Z10")] };
}
