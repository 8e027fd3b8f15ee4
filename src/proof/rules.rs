//! What judges say of the program of any kind, one row each: V0001 to V0099. The kinds' own rows follow: V0100 the impeller's,
//! V0200 the branch's, V0300 the hole's, V0400 the blank's.

use crate::finding::{Example, Size};
use crate::text::{Text, t};

crate::finding::rule::rules! {
    /// The rows of this room.
    RULES;
    "V0001" NothingSeen Stop { check: Text, program: Text }
        es "«{check}» de «{program}»: no se ha mirado nada"
        en "\"{check}\" of \"{program}\": nothing was looked at"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "Una comprobación que no ha mirado nada no demuestra nada: el silencio no es un aprobado.",
            "A check that looked at nothing proves nothing: silence is no pass.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blade", from: "N60 G0 X0.000 Y0.000", to: "N60 M30" };
    "V0002" NotAnswered Stop { check: &'static str, program: Text }
        es "nadie ha contestado a la comprobación «{check}» de «{program}»"
        en "nobody has answered the check \"{check}\" of \"{program}\""
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "Cada programa tiene una lista de lo que se le pregunta: lo que falta en las respuestas no se ha comprobado.",
            "Every program has a list of what it is asked: what is missing among the answers was not checked.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blade", from: "N60 G0 X0.000 Y0.000", to: "N60 M30" };
    "V0005" MemoryExceeded Caution { program: Text, bytes: u64 }
        es "el programa «{program}» ocupa {bytes} bytes, más que la memoria habitual del control"
        en "program \"{program}\" takes {bytes} bytes, more than the control's usual memory"
        remedy "ejecútelo desde disco o red, o un n menor", "run it from disk or network, or a smaller n";
        why "Lo que no cabe en la memoria del control se corta o no se carga.",
            "What does not fit into the control's memory is cut off or not loaded.";
        example Example::Made { key: "program-beyond-memory", how: t("un programa de más de 1 MiB para el Fagor 8055: un impulsor con n = 1500", "a program of more than 1 MiB for the Fagor 8055: an impeller with n = 1500") };
    "V0006" NotAsPlanned Stop { program: Text, at: Text, difference: Text }
        es "«{program}» no es lo planeado en la {at}: {difference}"
        en "\"{program}\" is not what was planned at {at}: {difference}"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "El texto se compara con el plan movimiento a movimiento: una cifra distinta es otra pieza.",
            "The text is held against the plan motion by motion: another digit is another part.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blade", from: "X1.169 Z9.517", to: "X1.170 Z9.517" };
    "V0007" NotClosed Stop { program: Text }
        es "el programa «{program}» no cierra"
        en "program \"{program}\" does not close"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "Un programa incremental que no vuelve a donde empieza se desplaza en cada pasada.",
            "A program by increments that does not come back to where it starts is shifted at each run.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blade", from: "X1.169 Z9.517", to: "X1.170 Z9.517" };
    "V0008" AxisLeavesTravel Stop { axis: char, position: Size, program: Text, line: usize, limit: Size, key: &'static str }
        es "el eje {axis} llega a {position} en «{program}», desde la línea {line}; su límite es {limit}"
        en "axis {axis} goes to {position} in \"{program}\", from line {line} on; its limit is {limit}"
        remedy "compruebe {key}, la longitud de pivote y el cero, o mecanice en otra máquina", "check {key}, the pivot length and the zero, or use another machine";
        why "El control se para en el límite, con la herramienta quizá en la pieza.",
            "The control stops at the limit, perhaps with the tool in the part.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blade", from: "N1000 G0 B-90.000", to: "N1000 G0 B-191.000" };
    "V0009" TurnJumps Stop { step: Size, line: usize, program: Text }
        es "C salta {step} en la línea {line} de «{program}»"
        en "C jumps by {step} at line {line} of \"{program}\""
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "Mientras avanza un eje lineal la herramienta trabaja: un salto de C la barrería por la pieza.",
            "While a linear axis moves the tool is at work: a jump of C would sweep it through the part.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blade", from: "N970 G0 Y-13.333", to: "N970 G0 Y-13.333 C200.000" };
    "V0010" OtherwiseOnRollover Stop { program: Text, at: Text }
        es "«{program}» gira de otro modo con ejes rollover, desde la {at}"
        en "\"{program}\" turns otherwise on rollover axes, from {at} on"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "En un eje rollover el número absoluto es un ángulo y su signo el sentido: el mismo texto gira al revés.",
            "On a rollover axis the absolute number is an angle and its sign the direction: the same text turns the other way.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blade", from: "N1000 G0 B-90.000", to: "N1000 G90 G0 B-90.000" };
    "V0011" AxisTooFast Stop { axis: char, speed: Size, line: usize, program: Text, limit: Size }
        es "{axis} va a {speed} en la línea {line} de «{program}»; F_max es {limit}"
        en "{axis} runs at {speed} at line {line} of \"{program}\"; F_max is {limit}"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "Un eje más rápido que su límite se queda atrás, o la máquina se para.",
            "An axis faster than its limit falls behind, or the machine stops.";
        example Example::Slip { kind: "impeller", cells: &[("F_max", "3300")], program: "blade", from: "Y14.933 F300.000", to: "Y14.933 F30000.000" };
    "V0012" TipTooFast Stop { speed: Size, line: usize, program: Text, limit: Size }
        es "la punta va a {speed} en la línea {line} de «{program}»; F es {limit}"
        en "the tip runs at {speed} at line {line} of \"{program}\"; F is {limit}"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "Por encima de F el diente corta más de lo que se pidió.",
            "Above F the tooth cuts more than was asked for.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blade", from: "Y14.933 F300.000", to: "Y14.933 F30000.000" };
    "V0013" CutWithoutFeed Stop { line: usize, program: Text }
        es "hay un movimiento de corte sin avance en la línea {line} de «{program}»"
        en "there is a cutting motion without feed at line {line} of \"{program}\""
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "Sin F el control usa el avance que tenga, o no se mueve.",
            "Without F the control uses whatever feed it has, or does not move.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blade", from: "Y14.933 F300.000", to: "Y14.933" };
    "V0014" FeedWordSlows Caution { line: usize, part: Size, program: Text }
        es "los decimales de F frenan la línea {line} de «{program}» un {part}"
        en "the decimals of F slow line {line} of \"{program}\" by {part}"
        remedy "menos F, o tramos más largos", "a smaller F, or longer moves";
        why "F se redondea hacia lo lento: en tramos cortos puede frenar mucho y quemar el corte.",
            "F is rounded to the slower side: over short moves that may slow the cut much, and burn it.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blade", from: "Y14.933 F300.000", to: "Y14.933 F200.000" };
    "V0015" DecimalsAssumed Note {}
        es "F en G93 va a 0.0001 s, un supuesto: la página del manual del 8070 no da formato; un control de tres decimales acortaría un bloque hasta 0.0009 s"
        en "F in G93 goes to 0.0001 s, an assumption: the page of the 8070's manual gives no format; a control with three decimals would shorten a block by up to 0.0009 s"
        remedy "pruébelo en el control antes de cortar", "try it on the control before cutting";
        why "Un bloque acortado va más rápido que F.",
            "A block that is shortened runs faster than F.";
        example Example::Slip { kind: "impeller", cells: &[("dialect", "fagor-8070"), ("retract", "")], program: "blade", from: "", to: "" };
    "V0016" RadiiDiffer Stop { line: usize, difference: Size, most: Size, program: Text }
        es "los radios del arco de la línea {line} de «{program}» difieren en {difference}; lo más es {most}"
        en "the radii of the arc at line {line} of \"{program}\" differ by {difference}; the most is {most}"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "Un arco cuyos radios no coinciden es una espiral: cada control la traza a su manera.",
            "An arc whose radii do not agree is a spiral: every control runs it in its own way.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blade", from: "N120 G1 X11.200 Y14.933", to: "N120 G3 X11.200 Y14.933 I-74.220 J67.707" };
    "V0017" CharactersRefused Stop { line: usize, program: Text, fault: Text }
        es "el control no toma la línea {line} de «{program}»: {fault}"
        en "the control does not take line {line} of \"{program}\": {fault}"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "Los controles perdonan cosas distintas: se escribe la forma que toman todos.",
            "Controls forgive different things: the form is written that all of them take.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blade", from: "N90 G91", to: "N90  G91" };
    "V0018" TorchNotAsDue Stop { line: usize }
        es "la antorcha no está como debe en la línea {line}"
        en "the torch is not as it should be at line {line}"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "Encendida en rápido marca la pieza; apagada en el corte la deja unida.",
            "Burning at rapid it marks the part; out in the cut it leaves it joined.";
        example Example::Slip { kind: "pipe-hole", cells: &[], program: "hole", from: "N60 M3", to: "N60 M5" };
    "V0019" ChecksPassed Note { program: Text }
        es "comprobaciones que cumple «{program}», leído de nuevo: vea la tabla Verificación"
        en "checks that \"{program}\", read back, has passed: see the table Verification"
        remedy "", "";
        why "Dice cuántas preguntas se han contestado con un sí; las demás están en la tabla.",
            "It says how many questions were answered with a yes; the others stand in the table.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blade", from: "", to: "" };
    "V0020" IncrementsShift Caution {}
        es "el programa incremental no vuelve a donde empieza: cada ejecución se desplaza"
        en "the incremental program does not come back to where it starts: each run is shifted"
        remedy "haga que la suma de los incrementos sea 0 en cada eje lineal", "make the increments of each linear axis sum up to 0";
        why "Repetido, cada pasada empieza donde acabó la anterior: la segunda pieza sale corrida.",
            "Run again, each pass starts where the last one ended: the second part is cut beside its place.";
        example Example::Program { control: "linuxcnc", program: "G21 G91|G0 X10|G0 X-9|M2", at: "", given: &[] };
    "V0021" IncrementsTurn Note {}
        es "el programa incremental vuelve a donde empieza, con los ejes giratorios en otro ángulo"
        en "the incremental program comes back to where it starts, the rotary axes at another angle"
        remedy "", "";
        why "Así se pasa al siguiente álabe: conviene saber que es a propósito.",
            "So the next blade is reached: it is as well to know that it is meant.";
        example Example::Program { control: "linuxcnc", program: "G21 G91|G0 X10|G0 X-10 C90|M2", at: "", given: &[] };
    "V0022" IncrementsClose Note {}
        es "el programa incremental vuelve a donde empieza"
        en "the incremental program comes back to where it starts"
        remedy "", "";
        why "Se puede repetir sin mover nada.",
            "It may be run again with nothing moved.";
        example Example::Program { control: "linuxcnc", program: "G21 G91|G0 X10|G0 X-10|M2", at: "", given: &[] };
    "V0023" OffTolerance Stop { what: Text, off: Size, limit: Size }
        es "{what} {off}; la tolerancia es {limit}"
        en "{what} {off}; the tolerance is {limit}"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "El corte se encierra entre cotas en todo su recorrido: fuera de la tolerancia la pieza no encaja.",
            "The cut is enclosed by bounds over its whole way: beyond the tolerance the part does not fit.";
        example Example::Slip { kind: "pipe-hole", cells: &[], program: "hole", from: "N120 G1 A-5.506", to: "N120 G1 A-3.506" };
    "V0024" OffByN Caution { what: Text, off: Size, limit: Size }
        es "{what} {off}; la tolerancia es {limit}"
        en "{what} {off}; the tolerance is {limit}"
        remedy "un N mayor", "a greater N";
        why "Pocos puntos dan arcos largos, que se apartan de la curva entre ellos.",
            "Few points make long arcs, which leave the curve between them.";
        example Example::Slip { kind: "pipe-insert", cells: &[("mode", "flat"), ("N", "8")], program: "insert", from: "", to: "" };
    "V0025" NotEnclosed Caution { what: Text, off: Size, most: Size, limit: Size }
        es "{what} {off} donde se ha mirado, y entre medias no se ha podido asegurar más que {most}; la tolerancia es {limit}"
        en "{what} {off} where it was looked at, and between no more than {most} could be made sure of; the tolerance is {limit}"
        remedy "más arc_tolerance, u otro N", "a greater arc_tolerance, or another N";
        why "Lo que no se demuestra no se da por bueno.",
            "What is not proved is not taken as good.";
        example Example::Never(t("las cotas se juntan antes de que se acabe el trabajo que se les da", "the bounds meet before the work that they are given ends"));
}
