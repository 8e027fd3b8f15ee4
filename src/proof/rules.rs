//! What judges say of the program of any kind, one row each: V0001 to V0099. The kinds' own rows follow: V0100 the impeller's,
//! V0200 the branch's, V0300 the hole's, V0400 the blank's.

use crate::finding::{Example, Key, Size};
use crate::text::{Text, t};

crate::finding::rule::rules! {
    /// The rows of this room.
    RULES;
    "V0001" NothingSeen Stop { check: Text, program: Text }
        es "«{check}» de «{program}»: la comprobación no ha mirado nada"
        en "\"{check}\" of \"{program}\": the check looked at nothing"
        remedy fault;
        why "Una comprobación que no ha mirado nada no demuestra nada.",
            "A check that looked at nothing proves nothing.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blade", from: "N60 G0 X0.000 Y0.000", to: "N60 M30" };
    "V0002" NotAnswered Stop { check: &'static str, program: Text }
        es "falta la comprobación «{check}» de «{program}»"
        en "the check \"{check}\" of \"{program}\" is missing"
        remedy fault;
        why "Cada programa tiene una lista de comprobaciones: la que no tiene respuesta no se ha hecho.",
            "Every program has a list of checks: a check without an answer was not made.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blade", from: "N60 G0 X0.000 Y0.000", to: "N60 M30" };
    "V0005" MemoryExceeded Caution { program: Text, bytes: u64, fewer: Text }
        es "el programa «{program}» ocupa {bytes} bytes, más que la memoria habitual del control"
        en "program \"{program}\" takes {bytes} bytes, more than the control's usual memory"
        remedy "ejecútelo desde disco o red, o pida menos bloques: {fewer}",
            "run it from disk or network, or ask for fewer blocks: {fewer}";
        why "El control corta un programa que no cabe en su memoria, o no lo carga.",
            "The control cuts off a program that does not fit into its memory, or does not load it.";
        example Example::Made { key: "program-beyond-memory", how: t("un programa de más de 1 MiB para el Fagor 8055: un rodete con n = 1500", "a program of more than 1 MiB for the Fagor 8055: an impeller with n = 1500") };
    "V0006" NotAsPlanned Stop { program: Text, at: Text, difference: Text }
        es "«{program}» se aparta del plan en la {at}: {difference}"
        en "\"{program}\" differs from the plan at {at}: {difference}"
        remedy fault;
        why "rodete compara el texto con el plan movimiento a movimiento: una cifra distinta da otra pieza.",
            "rodete compares the text with the plan motion by motion: a wrong digit makes another part.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blade", from: "X1.169 Z9.517", to: "X1.170 Z9.517" };
    "V0007" NotClosed Stop { program: Text }
        es "el programa «{program}» no vuelve a donde empieza"
        en "program \"{program}\" does not return to where it starts"
        remedy fault;
        why "Un programa incremental que no vuelve a su inicio se desplaza cada vez que se ejecuta.",
            "An incremental program that does not return to its start shifts at every run.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blade", from: "X1.169 Z9.517", to: "X1.170 Z9.517" };
    "V0008" AxisLeavesTravel Stop { axis: char, position: Size, program: Text, line: usize, limit: Size, key: Key, beyond: Text, and: Text }
        es "el eje {axis} llega a {position} en «{program}», desde la línea {line}; su límite es {limit}{beyond}"
        en "axis {axis} goes to {position} in \"{program}\", from line {line} on; its limit is {limit}{beyond}"
        remedy "compruebe {key}{and}, la longitud de pivote y el cero pieza, o mecanice en otra máquina", "check {key}{and}, the pivot length and the part zero, or use another machine";
        why "El control se para en el límite, con la herramienta quizá en la pieza.",
            "The control stops at the limit, perhaps with the tool in the part.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blade", from: "N1000 G0 B-90.000", to: "N1000 G0 B-191.000" };
    "V0009" TurnJumps Stop { step: Size, line: usize, program: Text }
        es "C salta {step} en la línea {line} de «{program}»"
        en "C jumps by {step} in line {line} of \"{program}\""
        remedy fault;
        why "La herramienta corta mientras avanza un eje lineal: un salto de C la arrastraría por la pieza.",
            "The tool cuts while a linear axis moves: a jump of C would sweep it through the part.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blade", from: "N970 G0 Y-13.333", to: "N970 G0 Y-13.333 C200.000" };
    "V0010" OtherwiseOnRollover Stop { program: Text, at: Text }
        es "«{program}» gira de otra manera en ejes rollover, desde la {at}"
        en "\"{program}\" turns differently on rollover axes, from {at} on"
        remedy fault;
        why "En un eje rollover el número absoluto es un ángulo y su signo el sentido: el mismo texto puede girar al revés.",
            "On a rollover axis the absolute number is an angle and its sign the direction: the same text may turn the other way.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blade", from: "N1000 G0 B-90.000", to: "N1000 G90 G0 B-90.000" };
    "V0011" AxisTooFast Stop { axis: char, speed: Size, line: usize, program: Text, limit: Size }
        es "el eje {axis} va a {speed} en la línea {line} de «{program}»; F_max es {limit}"
        en "axis {axis} moves at {speed} in line {line} of \"{program}\"; F_max is {limit}"
        remedy fault;
        why "Por encima de su límite, el eje se queda atrás o la máquina se para.",
            "Above its limit an axis lags behind, or the machine stops.";
        example Example::Slip { kind: "impeller --case full", cells: &[("F_max", "3300")], program: "blade", from: "Y14.933 F300.000", to: "Y14.933 F30000.000" };
    "V0012" TipTooFast Stop { speed: Size, line: usize, program: Text, limit: Size }
        es "la punta va a {speed} en la línea {line} de «{program}»; F es {limit}"
        en "the tip moves at {speed} in line {line} of \"{program}\"; F is {limit}"
        remedy fault;
        why "Por encima de F cada diente corta más de lo pedido.",
            "Above F each tooth cuts more than asked.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blade", from: "Y14.933 F300.000", to: "Y14.933 F30000.000" };
    "V0013" CutWithoutFeed Stop { line: usize, program: Text }
        es "la línea {line} de «{program}» corta sin avance F"
        en "line {line} of \"{program}\" cuts without a feed F"
        remedy fault;
        why "Sin F el control usa el avance que esté en vigor, o no se mueve.",
            "Without F the control uses whatever feed is in force, or does not move.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blade", from: "Y14.933 F300.000", to: "Y14.933" };
    "V0014" FeedWordSlows Caution { line: usize, part: Size, program: Text }
        es "el redondeo de F frena la línea {line} de «{program}» un {part}"
        en "the rounding of F slows line {line} of \"{program}\" by {part}"
        remedy "elija una F menor, o tramos más largos", "choose a smaller F, or longer moves";
        why "rodete redondea F hacia lo lento: en tramos cortos eso puede frenar mucho y quemar el corte.",
            "rodete rounds F to the slow side: on short moves this may slow the cut a lot and burn it.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blade", from: "Y14.933 F300.000", to: "Y14.933 F200.000" };
    "V0015" DecimalsAssumed Note {}
        es "F en G93 lleva cuatro decimales (0.0001 s), un supuesto: el manual del 8070 no da el formato; un control de tres decimales acortaría un bloque hasta 0.0009 s"
        en "F in G93 has four decimals (0.0001 s), an assumption: the 8070's manual gives no format; a control with three decimals would shorten a block by up to 0.0009 s"
        remedy "haga una prueba en vacío en el control antes de cortar", "make a dry run on the control before cutting";
        why "Un bloque acortado va más rápido que F.",
            "A shortened block runs faster than F.";
        example Example::Slip { kind: "impeller --case full", cells: &[("dialect", "fagor-8070"), ("retract", "")], program: "blade", from: "", to: "" };
    "V0016" RadiiDiffer Stop { line: usize, difference: Size, most: Size, program: Text }
        es "los radios del arco de la línea {line} de «{program}» difieren en {difference}; el máximo es {most}"
        en "the radii of the arc in line {line} of \"{program}\" differ by {difference}; the limit is {most}"
        remedy fault;
        why "Un arco con dos radios distintos es una espiral, y cada control la recorre a su manera.",
            "An arc with two radii is a spiral, and each control runs it in its own way.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blade", from: "N120 G1 X11.200 Y14.933", to: "N120 G3 X11.200 Y14.933 I-74.220 J67.707" };
    "V0017" CharactersRefused Stop { line: usize, program: Text, fault: Text }
        es "el control no admite la línea {line} de «{program}»: {fault}"
        en "the control does not accept line {line} of \"{program}\": {fault}"
        remedy fault;
        why "Cada control tolera cosas distintas: rodete escribe la forma que admiten todos.",
            "Each control forgives different slips: rodete writes the form that all of them accept.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blade", from: "N90 G91", to: "N90  G91" };
    "V0018" TorchNotAsDue Stop { line: usize }
        es "la antorcha está encendida o apagada cuando no debe en la línea {line}"
        en "the torch is on or off at the wrong time in line {line}"
        remedy fault;
        why "Encendida en rápido marca la pieza; apagada en el corte la deja sin cortar.",
            "A torch lit during a rapid marks the part; a torch off during the cut leaves it uncut.";
        example Example::Slip { kind: "pipe-hole", cells: &[], program: "hole", from: "N60 M3", to: "N60 M5" };
    "V0019" ChecksPassed Note { program: Text }
        es "comprobaciones superadas por «{program}», en la tabla Verificación"
        en "checks passed by \"{program}\", in the table Verification"
        remedy "", "";
        why "La tabla da cada comprobación con su valor y su límite.",
            "The table gives each check with its value and limit.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blade", from: "", to: "" };
    "V0020" IncrementsShift Caution {}
        es "el programa incremental no vuelve a donde empieza: se desplaza en cada ejecución"
        en "the incremental program does not return to where it starts: it shifts at every run"
        remedy "haga que la suma de los incrementos sea 0 en cada eje lineal", "make the increments of each linear axis add up to 0";
        why "Cada ejecución empieza donde acabó la anterior: la segunda pieza sale desplazada.",
            "Each run starts where the last one ended: the second part is cut out of place.";
        example Example::Program { control: "linuxcnc", program: "G21 G91|G0 X10|G0 X-9|M2", at: "", given: &[] };
    "V0021" IncrementsTurn Note {}
        es "el programa incremental vuelve a donde empieza, con los ejes giratorios en otro ángulo"
        en "the incremental program returns to where it starts, with the rotary axes at another angle"
        remedy "", "";
        why "Un programa puede pasar así al álabe siguiente: compruebe que es a propósito.",
            "A program may move on to the next blade this way: check that this is intended.";
        example Example::Program { control: "linuxcnc", program: "G21 G91|G0 X10|G0 X-10 C90|M2", at: "", given: &[] };
    "V0022" IncrementsClose Note {}
        es "el programa incremental vuelve a donde empieza"
        en "the incremental program returns to where it starts"
        remedy "", "";
        why "El programa se puede repetir sin mover nada.",
            "The program can run again without moving anything.";
        example Example::Program { control: "linuxcnc", program: "G21 G91|G0 X10|G0 X-10|M2", at: "", given: &[] };
    "V0023" OffTolerance Stop { what: Text, off: Size, limit: Size, of: Text }
        es "{what} {off}; la tolerancia es {limit}{of}"
        en "{what} {off}; the tolerance is {limit}{of}"
        remedy fault;
        why "rodete acota el corte en todo su recorrido: fuera de la tolerancia la pieza no encaja.",
            "rodete bounds the cut along its whole path: beyond the tolerance the part does not fit.";
        example Example::Slip { kind: "pipe-hole", cells: &[], program: "hole", from: "N120 G1 A-5.506", to: "N120 G1 A-3.506" };
    "V0024" OffByN Stop { what: Text, off: Size, limit: Size, of: Text, N: Text }
        es "{what} {off}; la tolerancia es {limit}{of}"
        en "{what} {off}; the tolerance is {limit}{of}"
        remedy "elija {N}", "choose {N}";
        why "Con pocos puntos los arcos son largos y se apartan de la curva entre punto y punto; también cuenta dónde caen. En style = anexo, el programa publicado, es solo una precaución.",
            "With few points the arcs are long and leave the curve between the points; where the points fall counts, too. In style = annex, the published program, it is only a caution.";
        example Example::Slip { kind: "pipe-insert", cells: &[("mode", "flat"), ("N", "8")], program: "insert", from: "", to: "" };
    "V0025" NotEnclosed Caution { what: Text, off: Size, most: Size, limit: Size }
        es "{what} {off} en los puntos comprobados; entre ellos solo está demostrado que no pasa de {most}; la tolerancia es {limit}"
        en "{what} {off} at the points checked; between them it is only proved to stay within {most}; the tolerance is {limit}"
        remedy "elija una arc_tolerance mayor, u otro N", "choose a larger arc_tolerance, or another N";
        why "rodete no da por bueno lo que no está demostrado.",
            "rodete does not pass what is not proved.";
        example Example::Made {
            key: "given-path",
            how: t("límites de la desviación, dados, que no llegan a cerrarse", "bounds of the deviation, given, that do not close"),
        };
}
