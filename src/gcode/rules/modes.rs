//! What is wrong with what is in force: feed, spindle, tool, modes.

use crate::finding::rule::rules;
use crate::finding::{Example, Size};
use crate::text::Text;

rules! {
    /// The rows of this file.
    RULES;

    "G0501" NoSpeedLimit Caution {}
        es "velocidad de corte constante sin límite de giro: cerca del eje el husillo se acelera hasta su máximo"
        en "constant surface speed without a speed limit: near the axis the spindle runs up to its maximum speed"
        remedy "programe el límite antes de G96", "program the limit before G96";
        why "A esa velocidad la pieza puede soltarse del plato.",
            "At that speed the work may fly out of the chuck.";
        example Example::program("fanuc-lathe-a", "G21 G98|G96 S200 M3|M5|M30", "2:1");
    "G0502" SurfaceSpeedMissing Stop {}
        es "G96 sin S"
        en "G96 without S"
        remedy "dé la velocidad de corte con S", "give the surface speed with S";
        why "Sin S el husillo no sabe a qué velocidad girar.",
            "Without S the spindle does not know how fast to turn.";
        example Example::program("linuxcnc", "G21 G90 F100|G96 D2000|M2", "2:1");
    "G0503" DwellTwice Stop {}
        es "G4 con más de un tiempo"
        en "G4 with more than one time"
        remedy "deje uno", "keep one";
        why "No se sabe qué tiempo vale.",
            "It is not clear which time counts.";
        example Example::program("fanuc-lathe-a", "G21 G98|G4 X1. P500|M30", "2:1");
    "G0504" DwellWithoutTime Stop {}
        es "G4 sin tiempo"
        en "G4 without a time"
        remedy "dé el tiempo de espera", "give the dwell time";
        why "Sin tiempo el control no espera, o se para.",
            "Without a time the control does not dwell, or stops.";
        example Example::program("linuxcnc", "G21 G90 F100|G4|M2", "2:1");
    "G0505" DwellNegative Stop {}
        es "tiempo de espera negativo"
        en "negative dwell time"
        remedy "dé un tiempo positivo", "give a positive time";
        why "No se puede esperar menos que nada.",
            "One cannot wait for less than nothing.";
        example Example::program("linuxcnc", "G21 G90 F100|G4 P-1|M2", "2:4");
    "G0506" UnitsChange Caution {}
        es "las unidades cambian en medio del programa"
        en "the units change in the middle of the program"
        remedy "escriba el programa entero en una unidad, dicha en su primer bloque", "write the whole program in one unit, given in its first block";
        why "El mismo número es otra longitud antes y después del cambio. Fanuc avisa de que no se cambie (B-63944EN/02, pág. 192): también el avance, los correctores y los orígenes cuentan en la otra unidad. Los demás controles lo admiten: allí es una nota.",
            "The same number means another length before and after the change. Fanuc warns not to change it (B-63944EN/02, p. 192): feed, tool offsets and work offsets count in the other unit, too. The other controls allow it: there it is a note.";
        example Example::program("fanuc-lathe-a", "G21 G98|G0 X1.|G20|G0 X2.|M30", "3:1");
    "G0507" MachineMoveIncremental Stop {}
        es "G53 con cotas incrementales"
        en "G53 with incremental coordinates"
        remedy "programe G90 en el bloque", "program G90 in the block";
        why "Un incremento en coordenadas de máquina no tiene un punto de partida conocido.",
            "An increment in machine coordinates has no known starting point.";
        example Example::program("linuxcnc", "G21 G90 F100|G91|G53 G0 X1|M2", "3:1");
    "G0508" AxesWithCancel Stop {}
        es "palabras de eje con G80"
        en "axis words with G80"
        remedy "programe G0, G1, G2 o G3 antes de los ejes", "program G0, G1, G2 or G3 before the axes";
        why "G80 anula el ciclo: no se sabe cómo ir a esa posición.",
            "G80 ends the cycle: it is not clear how to go to that position.";
        example Example::program("linuxcnc", "G21 G90 F100|G80 X1|M2", "2:5");
    "G0509" AxesClaimedTwice Stop {}
        es "dos códigos G que usan las palabras de eje"
        en "two G codes that both use the axis words"
        remedy "escriba dos bloques", "write two blocks";
        why "Las palabras de eje solo pueden ser de uno de los dos.",
            "The axis words can belong to only one of the two.";
        example Example::program("linuxcnc", "G21 G90 F100|G1 G92 X1|M2", "2:4");
    "G0510" CycleWithoutAxes Stop { cycle: f64 }
        es "G{cycle} sin palabras de eje"
        en "G{cycle} without axis words"
        remedy "dé la posición del agujero", "give the hole's position";
        why "Sin posición el ciclo no sabe dónde taladrar.",
            "Without a position the cycle does not know where to drill.";
        example Example::program("linuxcnc", "G21 G90 F100|G81 R1|M2", "2:1");
    "G0511" AxesWithoutMotion Stop {}
        es "palabras de eje sin un movimiento en vigor"
        en "axis words without a motion in force"
        remedy "programe G0, G1, G2 o G3 antes de los ejes", "program G0, G1, G2 or G3 before the axes";
        why "No se sabe si el movimiento es en rápido o en avance: qué hay en vigor al encender lo dice, en algunos controles, un parámetro de máquina.",
            "It is not clear whether the motion is rapid or at feed: what is in force at power-on is, on some controls, a machine parameter.";
        example Example::program("linuxcnc", "G21 G90 F100|G80|X1|M2", "3:1");
    "G0512" SetPositionWithoutAxes Stop { code: &'static str, cancel: Text }
        es "{code} sin palabras de eje"
        en "{code} without axis words"
        remedy "indique los ejes{cancel}", "name the axes{cancel}";
        why "Sin ejes no se sabe qué hay que desplazar.",
            "Without axes it is not clear what to shift.";
        example Example::program("linuxcnc", "G21 G90 F100|G92|M2", "2:1");
    "G0513" MachineMoveWithoutMotion Stop {}
        es "G53 sin G0 ni G1 en vigor"
        en "G53 without G0 or G1 in force"
        remedy "programe G53 G0 y los ejes", "program G53 G0 and the axes";
        why "No se sabe si el movimiento es en rápido o en avance.",
            "It is not clear whether the motion is rapid or at feed.";
        example Example::program("linuxcnc", "G21 G90 F100|G80|G53 X1|M2", "3:1");
    "G0514" ThreadStartAngle Stop {}
        es "rodete no admite en G34 Q, el ángulo inicial de la rosca"
        en "rodete does not follow Q, a thread's start angle, in G34"
        remedy "escriba los movimientos sin ella", "write the motions without it";
        why "La rosca empezaría en otro sitio.",
            "The thread would begin in another place.";
        example Example::program("fanuc-lathe-a", "G21 G98|S500 M3|G0 X40. Z5.|G34 Z-20. F2. K0.1 Q90000|M30", "4:20");
    "G0515" WordWithoutUse Stop { letter: char }
        es "palabra {letter} sin un código que la use"
        en "{letter} word with no code that uses it"
        remedy "quítela, o añada el código", "delete it, or add the code";
        why "Una palabra de más suele indicar que falta un código.",
            "An extra word usually means that a code is missing.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X1 P5|M2", "2:7");
    "G0516" InverseTimeZero Stop {}
        es "movimiento con G93 y F0"
        en "motion under G93 with F0"
        remedy "dé un F mayor que 0 en cada bloque de movimiento", "give an F greater than 0 in every motion block";
        why "Con G93 F fija el tiempo del bloque: con F0 el bloque no acabaría nunca.",
            "Under G93 F sets the time of the block: with F0 the block would never end.";
        example Example::program("linuxcnc", "G21 G90 F100|G93 G1 X1 F0|M2", "2");
    "G0517" InverseTimeWithoutF Stop {}
        es "movimiento con G93 sin F"
        en "motion under G93 without F"
        remedy "dé un F mayor que 0 en cada bloque de movimiento", "give an F greater than 0 in every motion block";
        why "Con G93 F fija el tiempo de cada bloque, y una F anterior no vale.",
            "Under G93 F sets the time of each block, and an earlier F does not count.";
        example Example::program("linuxcnc", "G21 G90 F100|G93 G1 X1|M2", "2");
    "G0518" FeedMissing Stop {}
        es "movimiento de avance sin F, o con F0"
        en "feed move without F, or with F0"
        remedy "dé el avance con F", "give the feed with F";
        why "Sin avance el control no se mueve, o se para.",
            "Without a feed the control does not move, or stops.";
        example Example::program("linuxcnc", "G21 G90|G1 X1|M2", "2");
    "G0519" NoFeed Caution {}
        es "movimiento de avance sin F: el control usa el avance que esté en vigor"
        en "feed move without F: the control uses the feed that is in force"
        remedy "dé el avance con F", "give the feed with F";
        why "El avance que haya quedado puede ser cualquiera.",
            "The feed left over from before may be anything.";
        example Example::program("fagor-8055", "G90 G1 X1|M30", "1");
    "G0520" SpindleStill Stop {}
        es "avance por vuelta con el husillo a 0"
        en "feed per revolution with spindle speed 0"
        remedy "dé la velocidad del husillo con S", "give the spindle speed with S";
        why "Con el husillo parado, un avance por vuelta no mueve la herramienta.",
            "With the spindle stopped a feed per revolution does not move the tool.";
        example Example::program("linuxcnc", "G21 G90 G95 F1|G1 X1|M2", "2");
    "G0521" RestoreWithWords Stop {}
        es "M72 con otras palabras en el bloque"
        en "M72 with other words in the block"
        remedy "escríbalas en otra línea: LinuxCNC las pierde al recuperar el estado", "write them on another line: LinuxCNC loses them when it restores the state";
        why "El control las pierde y no da ninguna alarma.",
            "The control loses them and raises no alarm.";
        example Example::program("linuxcnc", "G21 G90 F100|M70|M72 G0 X1|M2", "3:1");
    "G0522" RestoreWithoutSave Stop {}
        es "M72 sin un estado guardado"
        en "M72 without a saved state"
        remedy "guarde antes el estado con M70 o M73, en el mismo programa o subprograma", "save the state first with M70 or M73, in the same program or subprogram";
        why "No hay nada que recuperar.",
            "There is nothing to restore.";
        example Example::program("linuxcnc", "G21 G90 F100|M72|M2", "2:1");
    "G0523" RestoreRounds Caution { letter: char, was: f64, back: f64 }
        es "{letter}{was} vuelve como {letter}{back}: LinuxCNC lo redondea al recuperar el estado"
        en "{letter}{was} comes back as {letter}{back}: LinuxCNC rounds it when it restores the state"
        remedy "prográmelo de nuevo después de M72; la precaución queda", "program it again after M72; the caution stays";
        why "Después de M72 el avance o el giro no es el guardado.",
            "After M72 the feed or the speed differs from the saved value.";
        example Example::program("linuxcnc", "G20 G90|F1.23|M70|M72|G1 X1|M2", "4");
    "G0524" RestoreOfLength Caution {}
        es "M72 no recupera el corrector de longitud guardado: LinuxCNC recupera G43, pero no el número de la herramienta"
        en "M72 does not restore the saved tool length offset: LinuxCNC restores G43 but not the tool number"
        remedy "prográmelo de nuevo después de M72; la precaución queda", "program it again after M72; the caution stays";
        why "La herramienta se movería a otra altura.",
            "The tool would move at another height.";
        example Example::Program { control: "linuxcnc", program: "G21 G90 F100|T1 M6|G43|M70|G43 H2|M72|G0 Z5|M2", at: "6", given: &[("--tools", "T1 P1 Z50 D10|T2 P2 Z80 D10")] };
    "G0525" DwellBesideAxes Stop {}
        es "G4 con cotas en el mismo bloque"
        en "G4 with dimensions in the same block"
        remedy "escriba el movimiento en otro bloque", "put the motion into another block";
        why "G4 toma una palabra de eje como tiempo: no se sabe qué hace el control con las demás.",
            "G4 takes an axis word as its time: it is not clear what the control does with the others.";
        example Example::program("fanuc-lathe-a", "G21 G98|G0 X52. Z2.|G4 X1. Z-20.|M30", "3:1");
    "G0526" FeedPerTurnWithoutSpeed Caution {}
        es "avance por vuelta sin S: el control usa la velocidad del husillo que esté en vigor, o se para"
        en "feed per revolution without S: the control uses the spindle speed that is in force, or stops"
        remedy "dé la velocidad del husillo con S", "give the spindle speed with S";
        why "De la velocidad que haya quedado depende el avance en mm/min.",
            "The feed in mm/min hangs on whatever speed is left over.";
        example Example::program("fagor-8055", "G71 G90 G95 F.1|G1 X10|M30", "2");
    "G0527" SpindleStops Caution {}
        es "el husillo está parado y el movimiento va por vueltas: el control espera a que gire"
        en "the spindle is stopped and the motion goes by revolutions: the control waits for it to turn"
        remedy "programe M3 o M4 antes de este bloque", "program M3 or M4 before this block";
        why "Con el husillo parado la máquina se queda esperando en ese bloque.", "With the spindle stopped the machine waits in this block for ever.";
        example Example::program("linuxcnc", "G21 G90 G95 S500 M3|G1 X10 F.1|M5|G1 X20|M2", "4");
    "G0528" LengthNotInForce Caution { tool: u32 }
        es "T{tool} corta sin su corrector de longitud: no hay G43 en vigor"
        en "T{tool} cuts without its tool length offset: no G43 is in force"
        remedy "programe G43 detrás de M6", "program G43 behind M6";
        why "La herramienta de la tabla tiene una longitud: sin G43 baja por debajo del programa en toda ella.",
            "The tool of the table has a length: without G43 it goes below the program by all of it.";
        example Example::Program { control: "linuxcnc", program: "G21 G90 S900 M3|T1 M6|M3|G0 Z5|G1 Z-2 F100|M2", at: "5", given: &[("--tools", "T1 P1 Z50 D10")] };
    "G0529" LengthOfAnother Caution { tool: u32, other: u32 }
        es "T{tool} corta con el corrector de longitud de T{other}"
        en "T{tool} cuts with the tool length offset of T{other}"
        remedy "programe G43 con el H de la herramienta", "program G43 with the tool's own H";
        why "LinuxCNC conserva el corrector de longitud después de M6: la herramienta corta demasiado hondo, o en el aire, en la diferencia de las longitudes.",
            "LinuxCNC keeps the tool length offset after M6: the tool cuts too deep, or air, by the difference of the lengths.";
        example Example::Program { control: "linuxcnc", program: "G21 G90 S900|T1 M6|G43 H1|M3|G0 Z5|T2 M6|M3|G1 Z-2 F100|M2", at: "8", given: &[("--tools", "T1 P1 Z50 D10|T2 P2 Z80 D10")] };
    "G0530" CutsBeforeSpindle Caution {}
        es "movimiento de avance antes de que el programa ponga en marcha el husillo"
        en "feed move before the program starts the spindle"
        remedy "programe M3 o M4 antes de este bloque", "program M3 or M4 before this block";
        why "Una fresa que no gira se rompe al entrar en el material; en un torno la herramienta se clava en la pieza parada, y con avance por vuelta el control se queda esperando al husillo.",
            "A cutter that does not turn breaks where it meets the work; on a lathe the tool rams into the work at rest, and under a feed per revolution the control waits for the spindle for ever.";
        example Example::program("linuxcnc", "G21 G90 S900|G0 Z5|G1 Z-2 F100|M3|G1 X9|M2", "3");
    "G0531" SpindleStopped Caution {}
        es "movimiento de avance con el husillo parado"
        en "feed move with the spindle stopped"
        remedy "programe M3 o M4 antes de este bloque: M5 lo ha parado, y en LinuxCNC también M6", "program M3 or M4 before this block: M5 has stopped it, and on LinuxCNC M6 stops it too";
        why "Una fresa que no gira se rompe al entrar en el material.",
            "A cutter that does not turn breaks where it meets the work.";
        example Example::program("linuxcnc", "G21 G90 S900 M3|G1 Z-2 F100|M5|G1 X9|M2", "4");
    "G0532" GreatFeedPerTurn Caution { feed: Size }
        es "avance de {feed}: ¿es por minuto?"
        en "feed of {feed}: is it meant per minute?"
        remedy "programe el avance por minuto (G94; en un torno Fanuc, G98), o un F por vuelta", "program the feed per minute (G94; on a Fanuc lathe G98), or an F per revolution";
        why "Ninguna herramienta aguanta tal avance en cada vuelta.",
            "No tool stands such a feed in each revolution.";
        example Example::program("linuxcnc", "G21 G90 G95 S900 M3|G1 X10 F100|M2", "2");
    "G0533" LongDwell Caution { letter: char, time: Size, count: u64, line: usize, more: Text }
        es "espera de {time}: en este control {letter} cuenta segundos{more}"
        en "dwell of {time}: {letter} counts seconds on this control{more}"
        remedy "compruebe el tiempo: otros controles cuentan milisegundos", "check the time: other controls count milliseconds";
        why "Un tiempo escrito en milisegundos se lee aquí mil veces mayor, con el husillo en marcha.",
            "A time written in milliseconds is read a thousand times longer here, with the spindle running.";
        example Example::program("linuxcnc", "G21 G90 F100|G4 P500|M2", "2");
    "G0534" UnitNotSaid Note { unit: Text, metric: String, inch: String }
        es "el programa se mueve sin haber dicho su unidad ({metric} o {inch}): rodete lo lee en {unit}, el control en la que tenga en vigor"
        en "the program moves before it says its unit ({metric} or {inch}): rodete reads it in {unit}, the control in the one that is in force"
        remedy "dé la unidad en el primer bloque", "give the unit in the first block";
        why "Con la otra unidad la pieza saldría 25.4 veces mayor o menor. El control guarda la unidad del programa anterior, un Fanuc también sin tensión.",
            "In the other unit the part would be 25.4 times larger or smaller. The control keeps the unit of the program before, a Fanuc also with the power off.";
        example Example::program("linuxcnc", "G0 X1|M2", "1");
    "G0535" UnitBesideFeed Caution { words: String, code: String }
        es "{words} en el bloque de {code}, que cambia la unidad: el manual no dice en cuál de las dos unidades se lee; rodete lee en la anterior"
        en "{words} in the block of {code}, which changes the unit: the manual does not say in which of the two units it is read; rodete reads in the earlier one"
        remedy "escriba {code} solo, en un bloque anterior", "write {code} alone, in a block before";
        why "En la otra unidad el avance es 25.4 veces mayor o menor, y la velocidad de corte de G96 3.28 veces.",
            "In the other unit the feed is 25.4 times larger or smaller, and the surface speed of G96 3.28 times.";
        example Example::program("fagor-8055", "G71 G90 G94 S900 M3|G70 F10|G0 X1|M30", "2:1");
    "G0536" FeedUnitNotKnown Stop { word: char, line: usize, code: String }
        es "el avance es la {word} de la línea {line}, escrita en el bloque de {code}, que cambia la unidad: el manual no dice en cuál de las dos unidades se lee"
        en "the feed is the {word} of line {line}, written in the block of {code}, which changes the unit: the manual does not say in which of the two units it is read"
        remedy "escriba {code} solo, en un bloque anterior, o dé {word} otra vez después", "write {code} alone, in a block before, or give {word} again behind it";
        why "En la otra unidad el avance es 25.4 veces mayor o menor.",
            "In the other unit the feed is 25.4 times larger or smaller.";
        example Example::program("fagor-8055", "G71 G90 G94 S900 M3|G70 F10|G1 X1|M30", "3");
    "G0537" FeedMeaningNotSaid Caution { meaning: Text, minute: &'static str, turn: &'static str }
        es "el programa avanza sin haber dicho lo que significa F ({minute} o {turn}): rodete la lee {meaning}, el control como diga un parámetro de la máquina"
        en "the program moves at feed before it says what F means ({minute} or {turn}): rodete reads it {meaning}, the control as a machine parameter says"
        remedy "programe {minute} o {turn} en el primer bloque", "program {minute} or {turn} in the first block";
        why "0.2 mm por vuelta leídos por minuto paran la herramienta; 100 mm por minuto leídos por vuelta la rompen.",
            "0.2 mm per revolution read per minute stops the tool; 100 mm per minute read per revolution breaks it.";
        example Example::program("fagor-8055-t", "G71 G90 S500 M3|G0 X48 Z2|G1 Z-20 F0.2|M30", "3");
    "G0538" CutsWithoutSpeed Caution {}
        es "movimiento de avance con M3 o M4 y sin S, o con S0"
        en "feed move under M3 or M4 without S, or with S0"
        remedy "programe S con M3 o M4", "program S with M3 or M4";
        why "Sin S la fresa o la pieza gira a la velocidad de antes, o no gira.",
            "Without S the cutter or the part turns at the speed of before, or does not turn.";
        example Example::program("linuxcnc", "G21 G90 M3|G0 Z5|G1 Z-2 F100|M5|M2", "3");
    "G0539" MachineMoveWithoutAxes Stop {}
        es "G53 sin palabras de eje"
        en "G53 without axis words"
        remedy "escriba los ejes en el bloque de G53", "write the axes in the block of G53";
        why "G53 vale solo para su bloque, y sin ejes no mueve nada.",
            "G53 counts for its own block only, and without axes it moves nothing.";
        example Example::program("linuxcnc", "G21 G90 F100|G1|G53|M2", "3:1");
    "G0540" DwellOfNoTime Note {}
        es "G4 sin tiempo: el control para la preparación de bloques, anula el corrector de longitud en vigor, y no espera"
        en "G4 without a time: the control stops preparing blocks, cancels the tool length offset in force, and does not dwell"
        remedy "para una espera escriba el tiempo, como G4 K50", "for a dwell write the time, as G4 K50";
        why "Sin tiempo el husillo no da ninguna vuelta más en el sitio, y la herramienta pierde su longitud y su radio.",
            "Without a time the spindle makes no more turns on the spot, and the tool loses its length and its radius.";
        example Example::program("fagor-8055", "G71 G90 G94 F100|G4|M30", "2:1");
    "G0541" LengthPlane Stop { plane: &'static str }
        es "corrector de longitud en {plane}: rodete sigue G43 solo en G17"
        en "tool length offset in {plane}: rodete follows G43 in G17 only"
        remedy "programe G44 antes de cambiar de plano, o compruebe el programa en el control", "program G44 before another plane, or check the program at the control";
        why "La longitud va según el eje perpendicular al plano.",
            "The length goes along the axis across the plane.";
        example Example::program("fagor-8055", "G71 G90 G94 F100|T1 D1|G43|G18|M30", "4:1");
    "G0542" LengthByMotion Stop { what: Text }
        es "{what} cuando la longitud de la herramienta está por tomar: rodete no sabe hasta dónde va"
        en "{what} while the tool's length is still to be taken up: rodete does not know where it goes"
        remedy "detrás de G43, G44, T o D escriba primero Z con G0 o G1 en G90", "behind G43, G44, T or D write Z with G0 or G1 in G90 first";
        why "El control toma la longitud con el siguiente movimiento de Z, y de ella depende adónde llega.",
            "The control takes the length up with the next motion of Z, and where that ends depends on it.";
        example Example::program("fagor-8055", "G71 G90 G94 F100|T1 D1|G43|G91 G0 Z5|M30", "4:8");
    "G0543" MachineMoveWithLength Stop {}
        es "G53 con Z y un corrector de longitud en vigor: rodete no sabe si la longitud cuenta"
        en "G53 with Z and a tool length offset in force: rodete does not know if the length counts"
        remedy "programe G44 y un movimiento de Z antes, o compruebe el programa en el control", "program G44 and a motion of Z before it, or check the program at the control";
        why "Si la longitud cuenta, la herramienta queda más alta o más baja en toda ella.",
            "If the length counts, the tool stops higher or lower by all of it.";
        example Example::program("fagor-8055", "G71 G90 G94 F100|T1 D1|G43|G0 Z50|G53 Z0|M30", "5:5");
    "G0544" LengthChangesLater Caution {}
        es "movimiento de avance antes de que Z tome el cambio de la longitud de la herramienta"
        en "feed move before Z has taken up the change of the tool's length"
        remedy "mueva Z en absoluto detrás de G43, G44, T o D, antes de cortar", "move Z in absolute coordinates behind G43, G44, T or D, before the cut";
        why "El control toma la longitud con el siguiente movimiento de Z: hasta entonces vale la de antes.",
            "The control takes the length up with the next motion of Z: until then that of before counts.";
        example Example::program("fagor-8055", "G71 G90 G94 F100|S900 M3|T1 D1|G43|G1 X5|M30", "5");
    "G0545" LengthLeftOver Caution {}
        es "G43 sin T ni D antes: cuenta la longitud del corrector que quedó del programa anterior, y rodete no la conoce"
        en "G43 without T or D before it: the length of the offset left over from another program counts, and rodete does not know it"
        remedy "dé el corrector con D", "name the offset with D";
        why "Con otro corrector Z queda más alta o más baja.",
            "With another offset Z ends higher or lower.";
        example Example::program("fagor-8055", "G71 G90 G94 F100|G43 G0 Z50|M30", "2:1");
    "G0546" LengthOfSelected Caution { tool: u32 }
        es "Z se mueve con G43 detrás de T{tool} sin D y sin M6: rodete cuenta su longitud solo desde M6"
        en "Z moves under G43 behind T{tool} without D and without M6: rodete counts its length from M6 on only"
        remedy "dé el corrector con D, o la T en el bloque de M6", "name the offset with D, or write T in the block of M6";
        why "Ninguna página leída dice si la longitud cambia con T o con M6.",
            "No page that was read says whether the length changes with T or with M6.";
        example Example::program("fagor-8055", "G71 G90 G94 F100|T1 D1|M6|G43 G0 Z50|T2|Z20|M30", "6:1");
    "G0547" LengthNotKnown Caution { tool: u32 }
        es "T{tool} tiene una longitud en la tabla: rodete no sabe si este control la toma, y cuenta sin ella"
        en "T{tool} has a length in the table: rodete does not know if this control takes it up, and counts without it"
        remedy "compruebe en el control a qué altura va la herramienta", "check at the control at which height the tool moves";
        why "Ninguna página leída dice qué pone en vigor la longitud en este control.",
            "No page that was read says what brings the length into force on this control.";
        example Example::Program { control: "fagor-8070", program: "G71 G90 G94 S900|T1 D1 M6|M3|G0 Z5|G1 Z-2 F100|M30", at: "5", given: &[("--tools", "T1 P1 Z50 D10")] };
    "G0548" LengthOverEnd Note {}
        es "el programa termina con G43: salvo con el parámetro ILCOMP = 0, la longitud sigue en vigor tras M30"
        en "the program ends under G43: unless the parameter ILCOMP = 0, the length stays in force after M30"
        remedy "programe G44 al retirarse en Z", "program G44 as Z retracts";
        why "El programa siguiente empezaría con la longitud de esta herramienta.",
            "The next program would begin with the length of this tool.";
        example Example::program("fagor-8055", "G71 G90 G94 F100|T1 D0|M6|G43 G0 Z50|M30", "5");
    "G0550" LengthEnded Stop {}
        es "Z después de G4 sin tiempo, o con 0, que anula el corrector de longitud de G43: rodete no sabe hasta dónde va"
        en "Z behind G4 without a time, or with 0, which cancels the tool length offset of G43: rodete does not know where it goes"
        remedy "detrás de G4 programe otra vez G43 y Z con G0 o G1 en G90, o G44; para una espera escriba el tiempo, como G4 K50",
            "program G43 again and Z with G0 or G1 in G90 behind G4, or G44; for a dwell write the time, as G4 K50";
        why "Sin su longitud la herramienta baja por debajo del programa en toda ella.",
            "Without its length the tool goes below the program by all of it.";
        example Example::program("fagor-8055", "G71 G90 G94 F100 S900 M3|T1 D1|M6|G43 G0 Z50|G4|G1 Z-5|M30", "6:4");
    "G0551" LengthOfOtherOffset Caution { tool: u32, offset: u32 }
        es "D{offset} de T{tool}: la tabla solo tiene una longitud por herramienta, la de su D1, y rodete cuenta sin ella"
        en "D{offset} of T{tool}: the table has one length for a tool only, that of its D1, and rodete counts without it"
        remedy "compruebe en el control la longitud de ese corrector de la herramienta, y a qué altura va",
            "check the length of that offset of the tool at the control, and at which height it moves";
        why "En este control cada herramienta tiene sus correctores: D2 es el segundo de la herramienta, y no la fila 2 de una tabla.",
            "On this control each tool has offsets of its own: D2 is the tool's second one, and not row 2 of a table.";
        example Example::Program { control: "fagor-8070", program: "G71 G90 G94 S900|T1 D2 M6|M3|G0 Z5|G1 Z-2 F100|M30", at: "5", given: &[("--tools", "T1 P1 Z50 D10")] };
    "G0552" PositionOrSpeedMissing Stop { code: String }
        es "{code} sin ejes ni S"
        en "{code} with neither axes nor S"
        remedy "indique los ejes, para fijar la posición, o S, para el límite de giro", "name the axes, to set the position, or give S, the speed limit";
        why "El código solo no dice qué hay que fijar.", "The code alone does not say what to set.";
        example Example::program("fagor-8055", "G71 G90 G94 F100|G92|M30", "2:1");
    "G0553" FeedInEarlierUnit Caution { code: String, place: Text, taken: Text, unit: Text, option: Text }
        es "F en el bloque de {code}{place}: el control toma F antes, {taken} {unit}"
        en "F in the block of {code}{place}: the control takes F before it, {taken} {unit}"
        remedy "escriba F en un bloque detrás del de {code}{option}", "write F in a block behind the one of {code}{option}";
        why "El control fija el avance antes que la unidad: la F es 25.4 veces mayor o menor que en la unidad del código.",
            "The control sets the feed before the unit: the F is 25.4 times as much or as little as in the unit of the code.";
        example Example::program("linuxcnc", "G21 G90 G94 S900 M3|G20 F10|G1 X1|M2", "2:5");
    "G0570" FeedWordInRapid Caution {}
        es "el bloque da F sin código de movimiento y va en rápido hacia la pieza, o de lado con Z bajo 0: sigue en vigor G0"
        en "the block gives F without a motion code and moves in rapid towards the part, or sideways with Z below 0: G0 is still in force"
        remedy "escriba G1 en el bloque si es de avance; si va en rápido, escriba G0 en él", "write G1 into the block if it is meant at feed; if it is meant in rapid, write G0 into it";
        why "F no cambia el movimiento en vigor: la herramienta entraría en la pieza en rápido.",
            "F does not change the motion in force: the tool would enter the part in rapid.";
        example Example::program("linuxcnc", "G21 G90 S900 M3|G0 X10 Z2|Z-3 F100|M2", "3");
}
