//! The rows of what lathes do in their own way, and of tools.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::Text;

rules! {
    /// The rows of this file.
    RULES;

    "G0800" TwoWordsAnAxis Stop { axis: char, step: char }
        es "{axis} y {step} en un bloque: las dos mueven el eje {axis}"
        en "{axis} and {step} in one block: both move axis {axis}"
        remedy "deje una de las dos", "keep one of the two";
        why "El control no sabe cuál de las dos vale.", "It is not clear which of the two counts.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G1 Z-1. W2.|M30", "3:4");
    "G0801" MachineMoveByIncrements Stop {}
        es "G53 con cotas incrementales"
        en "G53 with incremental coordinates"
        remedy "dé X y Z", "give X and Z";
        why "Las cotas de G53 son de máquina, y absolutas.", "G53 takes absolute machine coordinates.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G53 G0 U5.|M30", "3:8");
    "G0802" G91InSystemA Caution {}
        es "G91 no es un código del sistema A: rodete lo ignora, X y Z siguen absolutas"
        en "G91 is not a code of system A: rodete ignores it, X and Z stay absolute"
        remedy "escriba los incrementos con U y W", "write increments with U and W";
        why "En el sistema A los incrementos son U y W.", "In system A increments are U and W.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G91|G0 X60.|M30", "3:1");
    "G0803" SystemShifted Caution {}
        es "G54 a G59 con X o Z y sin G0 ni G1: desplaza el sistema desde el cero W1 y no mueve nada; un Fanuc se movería"
        en "G54 to G59 with X or Z but without G0 or G1: this shifts the system from zero W1 and moves nothing; a Fanuc would move"
        remedy "escriba G0 o G1 en el bloque si la herramienta debe moverse", "write G0 or G1 in the block if the tool should move";
        why "Según el control el bloque desplaza el cero o mueve la herramienta.",
            "Depending on the control, the block shifts the zero or moves the tool.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G54 X30. Z15.|G0 X60.|M30", "3:1");
    "G0804" ReferencePointNotSupported Stop { value: f64 }
        es "G30 P{value}: rodete no admite el tercer ni el cuarto punto de referencia"
        en "G30 P{value}: rodete does not follow the third and fourth reference points"
        remedy "use G30 P2 o G53", "use G30 P2, or G53";
        why "Su posición está en los parámetros del control.", "Their positions are in the control's parameters.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G30 P3 U0|M30", "3:5");
    "G0805" ReferenceWithoutAxes Stop { code: u8 }
        es "G{code} sin ejes"
        en "G{code} without axes"
        remedy "programe G{code} U0 W0", "program G{code} U0 W0";
        why "Sin ejes el control no mueve nada, pero el programa cuenta con que la herramienta está lejos.",
            "Without axes the control moves nothing, but the program counts on the tool being clear.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G28|M30", "3:1");
    "G0806" ReferencePointNotKnown Caution {}
        es "no se conoce el punto de referencia de G28: rodete usa el cero máquina"
        en "the reference point of G28 is not known: rodete uses machine zero"
        remedy "indique con --tools un libro de torno que tenga R_X y R_Z", "give with --tools a lathe workbook that has R_X and R_Z";
        why "El camino hasta el punto de referencia puede cruzar la pieza.",
            "The path to the reference point may cross the work.";
        example Example::program("fanuc-lathe-a", "(stock D50xL120)|O0015|G50 S2500|T0101|G96 S180 M3|M8|G54|G0 X54. Z2.|X46.|G1 Z-20. F0.25|U3.|G0 Z2.|G28 W0.|G0 Z2.|X42.|G1 Z-15. F0.25|U3.|G0 X100. Z60. M9|G28 U0. W0.|M30", "13:1");
    "G0835" SecondPointNotKnown Caution { first: u32, last: u32 }
        es "no se conoce el segundo punto de referencia, de G30: rodete usa el cero máquina"
        en "the second reference point, of G30, is not known: rodete uses machine zero"
        remedy "use G28, o dé a verify los parámetros {first} y {last} (X como radio, Z) con --var",
            "use G28, or give verify parameters {first} and {last} (X as a radius, Z) with --var";
        why "El camino hasta el punto de referencia puede cruzar la pieza.",
            "The path to the reference point may cross the work.";
        example Example::program("fanuc-lathe-a", "G21 G98|G0 X40. Z2.|G30 U0. W0.|M30", "3:1");
    "G0836" AxisNotOfLathe Stop { axis: char }
        es "el torno no tiene el eje {axis}"
        en "the lathe has no axis {axis}"
        remedy "escriba la cota con X o Z, y quite la palabra {axis}", "write the end point with X or Z, and take the word {axis} out";
        why "El control se para con una alarma, o mueve otro eje.",
            "The control stops with an alarm, or moves another axis.";
        example Example::Turning { control: "fagor-8055-t", stock: "D50xL120",
            program: "G71 G90 G95 F0.2|G92 S2500|T1 D1|G97 S800 M3 M8|G0 X54 Z2|X48|G1 Y5|G0 X100 Z50|M30",
            machine: &[("dialect", "fagor-8055-t")] };
    "G0837" AxisNotFollowed Caution { axis: char }
        es "rodete no sabe si el torno tiene el eje {axis}, y no simula lo que mueve"
        en "rodete does not know whether the lathe has an axis {axis}, and does not simulate what it moves"
        remedy "escriba la cota con X o Z; si el torno tiene ese eje, compruebe en la máquina lo que mueve",
            "write the end point with X or Z; if the lathe has that axis, check on the machine what it moves";
        why "Sin ese eje el control se para con una alarma.",
            "Without that axis the control stops with an alarm.";
        example Example::program("fagor-8055-t", "G71 G90 G95 F0.2 S500 M3|G0 X48 Z2|G1 Y5|M30", "3:4");
    "G0838" IncrementNotOfLathe Stop { axis: char, along: char }
        es "el torno no tiene el eje {axis}"
        en "the lathe has no axis {axis}"
        remedy "escriba la cota con {along}, o el incremento con G91 y {along}, y quite la palabra {axis}",
            "write the end point with {along}, or the increment with G91 and {along}, and take the word {axis} out";
        why "El control se para con una alarma, o mueve otro eje; un Fanuc leería U y W como incrementos de X y Z.",
            "The control stops with an alarm, or moves another axis; a Fanuc would read U and W as increments of X and Z.";
        example Example::Turning { control: "fagor-8055-t", stock: "D50xL120",
            program: "G71 G90 G95 F0.2|G92 S2500|T1 D1|G97 S800 M3 M8|G0 X54 Z2|X48|G1 W-22|G0 X100 Z50|M30",
            machine: &[("dialect", "fagor-8055-t")] };
    "G0839" IncrementNotFollowed Caution { axis: char, along: char }
        es "rodete no sabe si el torno tiene el eje {axis}, y no simula lo que mueve"
        en "rodete does not know whether the lathe has an axis {axis}, and does not simulate what it moves"
        remedy "escriba la cota con {along}, o el incremento con G91 y {along}; si el torno tiene ese eje, compruebe en la máquina lo que mueve",
            "write the end point with {along}, or the increment with G91 and {along}; if the lathe has that axis, check on the machine what it moves";
        why "Sin ese eje el control se para con una alarma; un Fanuc leería U y W como incrementos de X y Z.",
            "Without that axis the control stops with an alarm; a Fanuc would read U and W as increments of X and Z.";
        example Example::program("fagor-8055-t", "G71 G90 G95 F0.2 S500 M3|G0 X48 Z2|G1 W-22|M30", "3:4");
    "G0807" StaleFeed Caution {}
        es "el programa cambia entre avance por minuto y por vuelta y no da una F nueva: vale el número anterior"
        en "the program changes between feed per minute and per revolution and gives no new F: the old number stays"
        remedy "dé F con el cambio", "give F with the change";
        why "0.2 mm por vuelta leídos por minuto paran la herramienta; 100 mm por minuto leídos por vuelta la rompen.",
            "0.2 mm per revolution read per minute stops the tool; 100 mm per minute read per revolution breaks it.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G1 X48.|G98|X46.|M30", "5");
    "G0808" BeyondAxis Caution {}
        es "X negativo: el punto programado pasa del eje de giro"
        en "negative X: the programmed point is beyond the axis"
        remedy "compruebe el signo y que X es un diámetro", "check the sign, and that X is a diameter";
        why "Al refrentar se pasa un poco del eje; más lejos es un error de signo.",
            "Facing goes a little beyond the axis; farther is a sign error.";
        example Example::program("fanuc-lathe-a", "(stock D50xL120)|(alarms 151@8)|O0100|T0101|G96 S180 M3|M8|G0 X54. Z0.|G1 X-1.6 F0.1|G0 Z2.|X100. Z50. M9|M30", "8:4");
    "G0809" RefusedInLoop Stop { times: u32 }
        es "el bloque se ha rechazado {times} veces en un bucle; rodete deja de leer aquí"
        en "the block was rejected {times} times in a loop; rodete stops reading here"
        remedy "corrija el bloque", "correct the block";
        why "Cada vuelta del bucle daría el mismo error.", "Each pass of the loop would give the same error.";
        example Example::program("linuxcnc", "G21 G90 F100|o1 repeat [200]|  G1 X1 B|o1 endrepeat|M2", "3");
    "G0810" EndlessLoop Stop { rounds: u32 }
        es "bucle sin fin: en {rounds} vueltas no se mueve nada ni cambia ningún parámetro"
        en "endless loop: in {rounds} passes nothing moves and no parameter changes"
        remedy "cambie dentro del bucle lo que compara su condición; rodete no conoce las entradas de la máquina",
            "inside the loop, change what its condition compares; rodete does not know the machine's inputs";
        why "Si nada cambia, la condición tampoco.", "If nothing changes, the condition does not change either.";
        example Example::program("linuxcnc", "G21 G90 F100|o1 while [1]|o1 endwhile|M2", "3");
    "G0811" TooManyCycleMotions Stop { most: u64 }
        es "los ciclos fijos del programa suman más de {most} movimientos; rodete deja de leer aquí"
        en "the program's canned cycles make more than {most} motions; rodete stops reading here"
        remedy "programe menos agujeros, o penetraciones mayores", "program fewer holes, or larger pecks";
        why "Tantos movimientos suelen venir de una cota en otra unidad.", "So many motions usually come from a dimension in another unit.";
        example Example::program("linuxcnc", "G21 G90 F100 S500 M3|G0 Z5|G91 G99 G81 X1 R-1 Z-1 L9999|L9999|M2", "3");
    "G0812" ToolTwiceInTable Stop { word: String }
        es "la tabla de herramientas lista {word} dos veces"
        en "the tool table lists {word} twice"
        remedy "escriba una herramienta por línea: T1 P1 Z10.5 D6", "write one tool per line: T1 P1 Z10.5 D6";
        why "No se sabe cuál de las dos longitudes vale.", "It is not clear which of the two lengths counts.";
        example Example::Program { control: "linuxcnc", program: "G21 G90 F100|T1 M6|M2", at: "2:1", given: &[("--tools", "T1 Z10|T1 Z20")] };
    "G0813" NoWordOfToolTable Stop { word: String }
        es "«{word}» no es una palabra de la tabla de herramientas"
        en "'{word}' is not a word of a tool table"
        remedy "escriba una herramienta por línea: T1 P1 Z10.5 D6", "write one tool per line: T1 P1 Z10.5 D6";
        why "Una longitud mal leída lleva la herramienta a otra altura.",
            "A misread length takes the tool to another height.";
        example Example::Program { control: "linuxcnc", program: "G21 G90 F100|T1 M6|M2", at: "1:4", given: &[("--tools", "T1 Z1,5")] };
    "G0820" NoToolNumber Stop { value: f64 }
        es "{value} no es un número de herramienta"
        en "{value} is not a tool number"
        remedy "dé un número entero", "give a whole number";
        why "El número de una herramienta es entero.", "A tool number is a whole number.";
        example Example::program("linuxcnc", "G21 G90 F100|T1.5 M6|M2", "2:1");
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
        remedy "añada Q", "add Q";
        why "Q dice qué herramienta está puesta.", "Q says which tool is in the spindle.";
        example Example::program("linuxcnc", "G21 G90 F100|M61|M2", "2:1");
    "G0823" ChangeWithoutTool Stop {}
        es "M6 sin herramienta elegida con T"
        en "M6 without a tool selected by T"
        remedy "programe T antes de M6", "program T before M6";
        why "El control pondría la que T eligió la última vez.", "The control would put in whatever T selected last.";
        example Example::program("linuxcnc", "G21 G90 F100|M6|M2", "2:1");
    "G0824" OffsetMeasuredAtMachine Note {}
        es "la cabecera nombra esta herramienta; rodete toma como 0 su corrector, que se mide en la máquina"
        en "the header names this tool; rodete takes its offset, which is measured at the machine, as 0"
        remedy "", "";
        why "La longitud de la herramienta se mide al montarla.", "The tool length is measured when the tool is mounted.";
        example Example::program("linuxcnc", "(RODETE 0.1.0 - DIALECT LINUXCNC)|(TOOL T1 D1)|G21 G90 F100|G43 H1|M2", "4");
    "G0825" NoToolTable Caution {}
        es "sin tabla de herramientas: rodete toma las longitudes como 0"
        en "no tool table: rodete takes the tool lengths as 0"
        remedy "indique la tabla con --tools", "name the table with --tools";
        why "rodete comprueba las posiciones de una herramienta de longitud 0.",
            "rodete checks the positions of a tool of length 0.";
        example Example::program("fanuc-lathe-a", "T0909|M30", "1");
    "G0826" LengthWithoutAxes Stop {}
        es "G43.1 sin palabras de eje"
        en "G43.1 without axis words"
        remedy "dé la longitud en su eje", "give the length on its axis";
        why "La palabra del eje da la longitud.", "The axis word gives the length.";
        example Example::program("linuxcnc", "G21 G90 F100|G43.1|M2", "2:1");
    "G0827" AddedLength Stop {}
        es "G43.2 necesita H, sin palabras de eje"
        en "G43.2 needs H, without axis words"
        remedy "dé H, o la longitud con G43.1", "give H, or the length with G43.1";
        why "LinuxCNC 2.9 busca una herramienta aunque haya palabras de eje; versiones posteriores las suman.",
            "LinuxCNC 2.9 looks for a tool even beside axis words; later versions add them.";
        example Example::program("linuxcnc", "G21 G90 F100|G43.2|M2", "2:1");
    "G0828" ToolTableNotKnown Stop {}
        es "G10 cambia una tabla de herramientas que rodete no conoce"
        en "G10 changes a tool table that rodete does not know"
        remedy "indique la tabla con --tools", "name the table with --tools";
        why "Sin tabla no hay nada que cambiar.", "Without a table there is nothing to change.";
        example Example::program("linuxcnc", "G21 G90 F100|G10 L1 P1|M2", "2:1");
    "G0829" ToolOffsetWithoutValues Stop {}
        es "G10 L1, L10 o L11 sin valores"
        en "G10 L1, L10 or L11 without values"
        remedy "dé los valores nuevos", "give the new values";
        why "El bloque no cambiaría nada.", "The block would change nothing.";
        example Example::Program { control: "linuxcnc", program: "G21 G90 F100|G10 L1 P1|M2", at: "2:1", given: &[("--tools", "T1 Z10")] };
    "G0830" NoOrientation Stop { value: f64 }
        es "Q{value} no es una orientación de punta"
        en "Q{value} is not a tip orientation"
        remedy "use Q de 0 a 9", "use Q from 0 to 9";
        why "La orientación dice hacia dónde apunta la punta.", "The orientation says which way the tip points.";
        example Example::Program { control: "linuxcnc", program: "G21 G90 F100|G10 L1 P1 Q12|M2", at: "2:11", given: &[("--tools", "T1 Z10")] };
    "G0831" NoTurretPlace Stop { value: f64 }
        es "T{value} no es un puesto de la torreta con su corrector"
        en "T{value} is not a turret place with its offset"
        remedy "escriba T0101: puesto 01, corrector 01", "write T0101: place 01, offset 01";
        why "Las dos primeras cifras son el puesto y las dos últimas el corrector.",
            "The first two digits are the place and the last two the offset.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|T10101|M30", "3:1");
    "G0832" OffsetAlone Stop { value: f64, offset: u32, readings: Text }
        es "T{value} no da ningún puesto de la torreta, solo el corrector {offset}"
        en "T{value} gives no turret place, only offset {offset}"
        remedy "escriba dos cifras para el puesto y dos para el corrector: {readings}",
            "write two digits for the place and two for the offset: {readings}";
        why "Con una o dos cifras la torreta no gira y corta la herramienta que está puesta.",
            "With one or two digits the turret does not turn, and the present tool cuts.";
        example Example::program("fanuc-lathe-a", "T3|M30", "1:1");
    "G0833" OffsetNotInTable Stop { offset: u32 }
        es "el corrector {offset} no está en la tabla"
        en "offset {offset} is not in the tool table"
        remedy "asigne el corrector a una herramienta: en un libro, hoja HERRAMIENTAS, columna D",
            "give the offset to a tool: in a workbook, sheet TOOLS, column D";
        why "Sin sus longitudes la punta iría a otro sitio.", "Without its lengths the tip would go to another place.";
        example Example::Program { control: "fanuc-lathe-a", program: "T0109 S500 M3|G0 X50. Z5.|M30", at: "1:1", given: &[("--tools", "T1 Z10")] };
    "G0834" ToolNotInTurret Stop { tool: u32 }
        es "la herramienta {tool} no está en la tabla"
        en "tool {tool} is not in the tool table"
        remedy "añádala a la torreta: en un libro, hoja HERRAMIENTAS, columna T",
            "add it to the turret: in a workbook, sheet TOOLS, column T";
        why "La torreta giraría a un puesto vacío o a otra herramienta.",
            "The turret would turn to an empty place, or to another tool.";
        example Example::Program { control: "fanuc-lathe-a", program: "T0901 S500 M3|G0 X50. Z5.|M30", at: "1:1", given: &[("--tools", "T1 Z10")] };
}
