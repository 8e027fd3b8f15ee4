//! Contradictions of an impeller, and what a person should know of its plan.

use crate::finding::rule::{book, rules};
use crate::finding::{Example, Size};
use crate::text::{Text, t};

rules! {
    /// The rows of an impeller.
    RULES;
    "P1001" TorusCloses Stop { r: Size, R: Size }
        es "el radio del meridiano r es {r} y debe ser menor que R = {R}: el toro se cierra"
        en "meridian radius r is {r}, must be below R = {R}: the torus closes"
        remedy "un meridiano menor o un toro mayor", "a smaller meridian or a larger torus";
        why "Por un toro cerrado no pasan círculos de Villarceau.", "No Villarceau circles run on a torus that is closed.";
        example book!("impeller", "r" = "25", "R" = "25");
    "P1002" CutThroughHub Stop { a_p: Size, room: Size }
        es "la profundidad a_p es {a_p} y debe ser menor que R − r = {room}"
        en "depth of cut a_p is {a_p}, must be below R − r = {room}"
        remedy "una profundidad menor", "a smaller depth";
        why "El cubo quedaría cortado.", "The hub would be cut through.";
        example book!("impeller", "a_p" = "100");
    "P1003" ToolBeyondHollow Stop { tool: Size, r: Size }
        es "la herramienta de {tool} no cabe en el hueco de radio r = {r}"
        en "a tool of {tool} does not fit into the hollow of radius r = {r}"
        remedy "una herramienta menor", "a smaller tool";
        why "La herramienta quitaría más metal que el hueco.", "The tool would take away more than the hollow.";
        example book!("impeller", "d_t" = "50");
    "P1004" NoBladeFits Stop { e: Size, tool: Size, hub: Size, gap: Size, least: Size }
        es "no cabe ni un álabe de e = {e} con d_t = {tool}: en el cubo hay {hub} en total"
        en "not even one blade fits with e = {e} and d_t = {tool}: there are {hub} round the hub"
        remedy "menos álabes, álabes más delgados o una herramienta menor; entre álabes quedan {gap} y hacen falta {least}",
            "fewer blades, thinner blades, or a smaller tool; {gap} are left between blades and {least} are needed";
        why "Entre dos álabes tiene que pasar la herramienta.", "The tool must pass between two blades.";
        example book!("impeller", "e" = "100");
    "P1005" TooManyBlades Stop { N: u32, most: Size, e: Size, tool: Size, gap: Size, least: Size }
        es "el número de álabes N es {N} y no debe pasar de N_max = {most} con e = {e} y d_t = {tool}"
        en "number of blades N is {N}, must not exceed N_max = {most} for e = {e} and d_t = {tool}"
        remedy "menos álabes, álabes más delgados o una herramienta menor; entre álabes quedan {gap} y hacen falta {least}",
            "fewer blades, thinner blades, or a smaller tool; {gap} are left between blades and {least} are needed";
        why "Entre dos álabes tiene que pasar la herramienta.", "The tool must pass between two blades.";
        example book!("impeller", "N" = "40");
    "P1006" NoThicknessFits Stop { N: u32, e: Size, room: Size, least: Size }
        es "con N = {N} ningún espesor de álabe cabe (e es {e}): por álabe hay {room} en el cubo y la herramienta pide {least}"
        en "with N = {N} no blade thickness fits (e is {e}): there are {room} a blade at the hub, and the tool needs {least}"
        remedy "menos álabes, álabes más delgados o una herramienta menor",
            "fewer blades, a thinner blade, or a smaller tool";
        why "La herramienta sola ya gasta toda la vuelta.", "With the tool alone the turn is used up.";
        example book!("impeller", "N" = "60");
    "P1007" BladeTooThick Stop { e: Size, most: Size, N: u32 }
        es "el espesor del álabe e es {e} y no debe pasar de e_max = {most} con {N} álabes"
        en "blade thickness e is {e}, must not exceed e_max = {most} for {N} blades"
        remedy "menos álabes, álabes más delgados o una herramienta menor",
            "fewer blades, a thinner blade, or a smaller tool";
        why "Entre dos álabes tiene que pasar la herramienta.", "The tool must pass between two blades.";
        example book!("impeller", "e" = "20");
    "P1008" SafePointsInside Stop { d_s: Size, least: Size }
        es "con d_s = {d_s} los puntos de seguridad quedan dentro de las pasadas"
        en "with d_s = {d_s} the safe points lie inside the passes"
        remedy "una distancia de seguridad d_s mayor de {least}", "a safety distance d_s above {least}";
        why "La herramienta giraría o bajaría en rápido dentro del metal.", "The tool would turn or come down at rapid inside the metal.";
        example book!("impeller", "d_s" = "0.1");
    "P1009" PivotInside Stop { L: Size, least: Size }
        es "la longitud de pivote L = R_B + H es {L}: el pivote queda dentro de la pieza"
        en "pivot length L = R_B + H is {L}: the pivot lies inside the part"
        remedy "compruebe R_B y H; L debe pasar de {least}", "check R_B and H; L must exceed {least}";
        why "El eje B gira por debajo de la pieza; dentro de ella no puede estar.", "The B axis turns below the part; it cannot lie inside.";
        example book!("impeller", "R_B" = "1", "H" = "1");
    "P1010" TravelReversed Stop { axis: char, low: Size, high: Size }
        es "el límite inferior de {axis} ({low}) no es menor que el superior ({high})"
        en "the lower limit of {axis} ({low}) is not below the upper one ({high})"
        remedy "intercambie los límites", "exchange the limits";
        why "Entre límites al revés no cabe ninguna posición.", "No position lies between limits that are the wrong way round.";
        example book!("impeller", "X_min" = "100", "X_max" = "-100");
    "P1011" FeedBeyondMachine Stop { F: Size, F_max: Size }
        es "el avance F es {F} y pasa de F_max = {F_max}"
        en "feed F is {F}, beyond F_max = {F_max}"
        remedy "un avance menor", "a smaller feed";
        why "La máquina no llega a ese avance.", "The machine does not reach that feed.";
        example book!("impeller", "F" = "5000", "F_max" = "3000");
    "P1012" AbsoluteOnRollover Stop {}
        es "distance = G90 con ejes rollover: en G90 el signo sería el sentido y el número el ángulo, y en cada bloque B daría casi una vuelta y C giraría al revés"
        en "distance = G90 with rollover axes: in G90 the sign would be the direction and the number the angle, and in each block B would make nearly a whole turn and C turn the wrong way"
        remedy "distance = G91, que vale para unos ejes y otros; o, si B y C de la máquina cuentan como ejes lineales, rotary = linear (fila rotary, valor en la columna C)",
            "distance = G91, which is true for either; or, if B and C of the machine count as linear axes, rotary = linear (row rotary, value in column C)";
        why "La herramienta atravesaría la pieza con la pieza girando.", "The tool would go through the part while the part turns.";
        example book!("impeller", "distance" = "G90", "rotary" = "rollover");
    "P1013" TooManyBlocks Stop { blocks: u64, most: u64 }
        es "el programa del rodete tendría {blocks} bloques, más de {most}"
        en "the program of the whole impeller would have {blocks} blocks, more than {most}"
        remedy "un n menor", "a smaller n";
        why "Ningún control toma tantos bloques, y comprobarlos no acabaría.", "No control takes so many blocks, and checking them would not end.";
        example book!("impeller", "n" = "100000", "N" = "60");
    "P1014" StockTooShort Stop { length: Size, r: Size }
        es "el bruto mide {length} de largo y el toro necesita más de r = {r}"
        en "the stock is {length} long, the torus needs more than r = {r}"
        remedy "un bruto más largo", "a longer stock";
        why "El torneado baja hasta r bajo la cara.", "The turning goes down to r below the face.";
        example book!("impeller", "L_b" = "10");
    "P1015" EndInsideStock Stop { X_e: Size, diameter: Size }
        es "la X final {X_e} queda dentro del bruto de diámetro {diameter}"
        en "the end X of {X_e} lies inside the stock of diameter {diameter}"
        remedy "una X final mayor que 2·R", "an end X above 2·R";
        why "La herramienta acabaría en rápido dentro del metal.", "The tool would end at rapid inside the metal.";
        example book!("impeller", "X_e" = "10");
    "P1016" StepBeyondMeridian Stop { C: Size, r: Size }
        es "el paso C es {C} y pasa de r = {r}"
        en "step C is {C}, beyond r = {r}"
        remedy "un paso menor", "a smaller step";
        why "Una sola pasada cortaría más hondo que el hueco.", "A single pass would cut deeper than the hollow.";
        example book!("impeller", "C" = "20");
    "P1017" NothingCrosses Stop {}
        es "no hay sitio que limite el álabe intermedio: su trayectoria no corta a la del álabe vecino"
        en "nothing limits the splitter blade: its path does not cross that of the neighbouring blade"
        remedy "splitters = no; o más álabes, álabes más gruesos o una herramienta mayor",
            "splitters = no; or more blades, thicker blades, or a larger tool";
        why "El álabe intermedio acaba donde su trayectoria corta a la del vecino: sin ese corte no se sabe dónde.",
            "A splitter ends where its path crosses that of its neighbour: without a crossing it is not known where.";
        example book!("impeller", "N" = "1", "e" = "0.1", "d_t" = "0.5", "d_s" = "5");
    "P1018" SplitterWithoutPoint Stop {}
        es "no queda álabe intermedio: su trayectoria corta a la del álabe vecino en el primer punto"
        en "no splitter blade is left: its path crosses that of the neighbouring blade at the first point"
        remedy "splitters = no; o menos álabes, álabes más delgados, una herramienta menor o un n mayor",
            "splitters = no; or fewer blades, thinner blades, a smaller tool, or a larger n";
        why "Antes del primer punto no hay trayectoria que cortar.", "Before the first point there is no path to cut along.";
        example book!("impeller", "n" = "2", "N" = "5", "splitter_fade" = "published");
    "P1019" NoRoomForSplitter Stop {}
        es "no cabe un álabe intermedio: por mucho que se afine, la herramienta cortaría el álabe vecino"
        en "no splitter blade fits: however it fades out, the tool would cut into the neighbouring blade"
        remedy "splitters = no; o menos álabes, álabes más delgados, una herramienta menor o un n mayor",
            "splitters = no; or fewer blades, thinner blades, a smaller tool, or a larger n";
        why "Lo que la herramienta corta de otro álabe ya no se repone.", "What the tool cuts from another blade is gone.";
        example book!("impeller", "n" = "2", "N" = "5");
    "P1020" SlotsContradict Stop {}
        es "la calibración no tiene solución real: las ranuras no son de una misma máquina"
        en "the calibration has no real solution: the slots cannot come from one machine"
        remedy "compruebe x0, z0 y las medidas de las ranuras", "check x0, z0 and the measures of the slots";
        why "De las dos ranuras salen la altura y el ángulo del eje B por una ecuación de segundo grado; si están mal medidas no tiene raíz.",
            "Height and angle of the B axis follow from both slots by a quadratic equation; measured wrongly they leave it without a root.";
        example book!("impeller", "CALIBRATION!C6" = "60", "CALIBRATION!C7" = "50", "CALIBRATION!C8" = "3", "CALIBRATION!C9" = "4",
            "CALIBRATION!C10" = "6", "CALIBRATION!C11" = "0.1", "CALIBRATION!C12" = "0.1");
    "P1021" AnnexWithoutFeed Caution {}
        es "el estilo annex no lleva avance F ni velocidad S, como los programas publicados"
        en "style annex carries no feed F and no speed S, like the published programs"
        remedy "fíjelos en el control antes de empezar, o style = full", "set them at the control before the start, or style = full";
        why "El control usaría el avance y la velocidad que queden del programa anterior.",
            "The control would use the feed and the speed left by the program before.";
        example book!("impeller", "style" = "annex");
    "P1022" AnnexStartsAnywhere Caution {}
        es "el programa incremental empieza donde esté la máquina: llévela antes al punto de seguridad de entrada, con B y C del Anexo 6"
        en "the incremental program starts wherever the machine stands: bring it to the safe entry point first, with B and C of Annex 6"
        remedy "style = full busca el inicio por sí mismo", "style = full finds the start itself";
        why "Desde otro punto toda la pasada queda desplazada lo mismo, y en rápido.",
            "From another point the whole pass is shifted by as much, and at rapid.";
        example book!("impeller", "style" = "annex");
    "P1023" AnnexIsRepeated Caution { N: u32, half: Size }
        es "los programas de un álabe y de un intermedio se ejecutan {N} veces cada uno; antes del primer intermedio, gire C {half}"
        en "the programs of one blade and of one splitter are run {N} times each; before the first splitter, turn C by {half}"
        remedy "el programa del rodete completo lo hace todo de una vez", "the program of the whole impeller does it all in one run";
        why "Cada programa corta un álabe y deja C en el siguiente; los intermedios van a media distancia.",
            "Each program cuts one blade and leaves C at the next; splitters lie half way between.";
        example book!("impeller", "style" = "annex");
    "P1024" TravelNotChecked Note { limits: String }
        es "sin comprobar, por estar vacíos: {limits}"
        en "not checked, being empty: {limits}"
        remedy "", "";
        why "Sin los límites de la máquina no se sabe si un eje llega a los suyos.",
            "Without the machine's limits it is not known whether an axis comes to its own.";
        example book!("impeller");
    "P1025" SpeedNotChecked Note {}
        es "F_max está vacío: la velocidad de los ejes no se comprueba"
        en "F_max is empty: the speed of the axes is not checked"
        remedy "", "";
        why "Con los cinco ejes a la vez uno lineal puede tener que ir mucho más deprisa que la punta.",
            "With five axes at once a linear one may have to go much faster than the tip.";
        example book!("impeller", "F_max" = "");
    "P1026" FeedReduced Note { moves: usize }
        es "el avance se reduce en {moves} movimientos de álabe e intermedio para que ningún eje pase de F_max"
        en "the feed is reduced in {moves} moves of blade and splitter so that no axis exceeds F_max"
        remedy "", "";
        why "Un eje más rápido de lo que la máquina da se retrasa, y la punta sale de su trayectoria.",
            "An axis faster than the machine allows lags, and the tip leaves its path.";
        example book!("impeller", "F_max" = "1000");
    "P1027" FeedWordAtItsEnd Caution { moves: usize }
        es "en {moves} movimientos la palabra F llega al extremo de su formato: el avance real es otro"
        en "in {moves} moves the F word reaches an end of its format: the true feed differs"
        remedy "un n menor u otro avance", "a smaller n or another feed";
        why "Más allá del extremo no hay palabra que escribir, y el bloque dura otra cosa de lo que debe.",
            "Beyond the end there is no word to write, and the block takes another time than it should.";
        example book!("impeller", "F" = "50000", "F_max" = "", "n" = "100");
    "P1028" NotNumbered Note { greatest: u32 }
        es "los bloques no se numeran: pasarían de N{greatest}"
        en "blocks are not numbered: the numbers would exceed N{greatest}"
        remedy "", "";
        why "Un número con más cifras de las que el control lee lo para.", "A number of more digits than the control reads stops it.";
        example book!("impeller", "dialect" = "linuxcnc", "start_codes" = "M3", "retract" = "", "block_step" = "1000");
    "P1029" BlankForFagor Note {}
        es "el programa del bruto es para un torno con Fagor 8055 T, sea cual sea el dialecto de la fresadora"
        en "the program of the blank is for a lathe with Fagor 8055 T, whatever the dialect of the mill"
        remedy "", "";
        why "Sus ciclos de torneado son de ese control; en otro torno la pieza se tornea con un programa suyo.",
            "Its turning cycles are those of that control; on another lathe the part is turned by a program of its own.";
        example book!("impeller");
    "P1030" CalibrationAgrees Note { found: Size, B: Size, R_B: Size }
        es "la calibración da R_B = {found} y B = {B}; en el libro R_B es {R_B} (se toma la raíz más próxima)"
        en "the calibration gives R_B = {found} and B = {B}; in the workbook R_B is {R_B} (the nearest root is taken)"
        remedy "", "";
        why "Hasta una centésima de diferencia, la décima parte de lo que se ve en una ranura, el libro y las ranuras dicen lo mismo.",
            "Up to a hundredth apart, the tenth part of what a slot shows to the eye, workbook and slots say the same.";
        example book!("impeller", "CALIBRATION!C6" = "60", "CALIBRATION!C7" = "50", "CALIBRATION!C8" = "3", "CALIBRATION!C9" = "4",
            "CALIBRATION!C10" = "6", "CALIBRATION!C11" = "-206.5", "CALIBRATION!C12" = "-185.5");
    "P1031" CalibrationDiffers Caution { found: Size, B: Size, R_B: Size, better: Size }
        es "la calibración da R_B = {found} y B = {B}; en el libro R_B es {R_B} (se toma la raíz más próxima)"
        en "the calibration gives R_B = {found} and B = {B}; in the workbook R_B is {R_B} (the nearest root is taken)"
        remedy "considere R_B = {better}", "consider R_B = {better}";
        why "De R_B sale la longitud de pivote: lo que le sobra o falta desplaza la punta en cada giro de B.",
            "The pivot length follows from R_B: what it is too long or too short shifts the tip at each turn of B.";
        example book!("impeller", "CALIBRATION!C6" = "60", "CALIBRATION!C7" = "50", "CALIBRATION!C8" = "3", "CALIBRATION!C9" = "4",
            "CALIBRATION!C10" = "6", "CALIBRATION!C11" = "-207", "CALIBRATION!C12" = "-185.5");
    "P1032" NoCoolant Note {}
        es "coolant está vacío: los programas no ponen refrigerante"
        en "coolant is empty: the programs switch no coolant on"
        remedy "", "";
        why "Qué código lo pone depende de la máquina, y no se supone ninguno.",
            "Which code switches it on depends on the machine, and none is assumed.";
        example book!("impeller");
    "P1033" AnnexByIncrements Note {}
        es "los programas giran B y C sólo por incrementos (G91): valen con ejes rollover y con lineales, desde los ángulos del Anexo 6"
        en "the programs turn B and C by increments (G91) only: true for rollover axes and for linear ones, from the angles of Annex 6 on"
        remedy "", "";
        why "Por incrementos el número es lo que gira el eje, cuente como cuente; lo que importa es desde dónde.",
            "By increments the number is how far the axis turns, however it counts; what matters is from where.";
        example book!("impeller", "style" = "annex");
    "P1034" TurnsByIncrements Note {}
        es "los programas valen con ejes rollover y con lineales: un bloque G90 con ángulos entre 0 y 360 y todo lo demás en G91; antes de empezar, B y C deben marcar 0, y ahí vuelven al acabar"
        en "the programs are true for rollover axes and for linear ones: one G90 block with angles between 0 and 360 and all else in G91; before the start B and C must show 0, and there they end"
        remedy "", "";
        why "Entre 0 y 360 el número absoluto es el mismo ángulo para unos ejes y otros; desde 0 gira además lo mismo.",
            "Between 0 and 360 an absolute number is the same angle on either axis; from 0 it is the same turn too.";
        example book!("impeller");
    "P1035" IncrementsFromZero Note {}
        es "los programas giran B y C por incrementos (G91) tras un bloque con B0 C0"
        en "the programs turn B and C by increments (G91) after a block with B0 C0"
        remedy "", "";
        why "El control cuenta B y C como ejes lineales: el bloque con B0 C0 deshace las vueltas que lleven.",
            "The control counts B and C as linear axes: the block with B0 C0 undoes the turns that they carry.";
        example book!("impeller", "dialect" = "linuxcnc", "start_codes" = "M3", "retract" = "");
    "P1036" OnLinearAxesUnproved Caution {}
        es "los programas sólo valen donde B y C cuentan como ejes lineales: en un eje rollover el signo sería el sentido y el número el ángulo"
        en "the programs are true only where B and C count as linear axes: on a rollover axis the sign would be the direction and the number the angle"
        remedy "compruebe en la máquina que a G90 C-90 desde 0 gira 90° y no 270°; o distance = G91",
            "check on the machine that from 0 G90 C-90 turns 90° and not 270°; or distance = G91";
        why "El libro dice que cuentan como lineales, y el control se entrega con ellos rollover.",
            "The workbook says that they count as linear ones, and the control is delivered with rollover ones.";
        example book!("impeller", "distance" = "G90", "rotary" = "linear");
    "P1037" OnLinearAxes Note {}
        es "los programas sólo valen donde B y C cuentan como ejes lineales: en un eje rollover el signo sería el sentido y el número el ángulo"
        en "the programs are true only where B and C count as linear axes: on a rollover axis the sign would be the direction and the number the angle"
        remedy "", "";
        why "El mismo número absoluto lleva a un eje rollover a otro ángulo.",
            "The same absolute number takes a rollover axis to another angle.";
        example book!("impeller", "dialect" = "linuxcnc", "start_codes" = "M3", "retract" = "", "rotary" = "linear", "distance" = "G90");
    "P1038" ClampsOfBuilder Note {}
        es "M11 y M13, de los programas publicados, son códigos del fabricante de aquella máquina, para los frenos de sus ejes giratorios: compruébelos en el manual de la suya"
        en "M11 and M13, of the published programs, are codes of that machine's builder, for the clamps of its rotary axes: check them in the manual of yours"
        remedy "", "";
        why "El mismo número es otra cosa en la máquina de otro fabricante.", "The same number is another thing on the machine of another builder.";
        example book!("impeller");
    "P1039" ClampsMissing Caution { missing: String }
        es "start_codes no lleva {missing}: los programas publicados empiezan con M11 M13, códigos del fabricante para los frenos de los ejes giratorios"
        en "start_codes lacks {missing}: the published programs begin with M11 M13, codes of the machine's builder for the clamps of the rotary axes"
        remedy "escriba los códigos con los que su máquina suelta B y C, si los tiene",
            "put in the codes with which your machine lets B and C go, if it has any";
        why "Un eje que gira contra su freno lo gasta, o el control se para.", "An axis that turns against its clamp wears it out, or the control stops.";
        example book!("impeller", "start_codes" = "M3");
    "P1040" NoRetract Caution {}
        es "retract está vacío: el primer movimiento es el de Z a su altura de retirada, con X, Y y B donde estén, y nada retira antes la herramienta"
        en "retract is empty: the first motion takes Z to its retract height with X, Y and B wherever they stand, and nothing takes the tool away before"
        remedy "escriba el bloque con el que su máquina sube Z; o, antes de cada arranque, lleve la herramienta a mano a lo alto de Z",
            "write the block with which your machine raises Z; or, before each start, take the tool to the top of Z by hand";
        why "La altura de retirada se cuenta con B en su sitio; desde otra posición el camino puede pasar por la pieza.",
            "The retract height is reckoned with B in its place; from another position the way may lead through the part.";
        example book!("impeller", "retract" = "");
    "P1041" RetractIsAssumed Caution {}
        es "retract con G53 es una suposición: que el cero de máquina está en lo alto de Z y que G53 cuenta desde él sin corrector (G44); no se tuvo a mano la página de G53 del control"
        en "retract with G53 is an assumption: that machine zero is at the top of Z and that G53 counts from it without a length offset (G44); the page of G53 of the control was not at hand"
        remedy "compruébelo en el manual de la máquina y ejecute ese bloque la primera vez bloque a bloque y con el avance reducido",
            "check it in the machine's manual, and run that block the first time in single block with the feed turned down";
        why "Si el cero de máquina está abajo, ese bloque lleva la herramienta en rápido a la pieza.",
            "Where machine zero is at the bottom, that block takes the tool to the part at rapid.";
        example book!("impeller");
    "P1042" RibsLeft Caution { most: Size, from: Size, width: Size, across: Size }
        es "quedan nervios sin cortar en los canales: hasta un {most} % de la superficie torneada entre dos álabes no lo toca ninguna pasada (cota superior), desde el {from} % del camino del cubo al borde; en el borde el más ancho mide hasta {width} a lo largo del canto ({across} de través)"
        en "ribs stay uncut in the channels: up to {most} % of the turned surface between two blades is touched by no pass (upper bound), from {from} % of the way from the hub to the rim on; at the rim the widest measures up to {width} along the edge ({across} across)"
        remedy "vacíe los canales con un programa propio, o más álabes o una herramienta mayor si la separación real lo permite: el plan solo corta a los lados de cada álabe",
            "clear the channels with a program of your own; or more blades or a larger tool, if the true gap allows: the plan cuts beside each blade only";
        why "El metal que queda cierra el canal entre los álabes.", "The metal that stays closes the channel between the blades.";
        example book!("impeller", "splitters" = "no");
    "P1043" FloorTooDeep Caution { most: Size, track: Text, point: Size, law: Size }
        es "el fondo queda junto a los álabes hasta {most} más hondo que a_p (cota superior; lo peor, {track}, punto {point}): el extremo plano de la fresa no cabe en el fondo cóncavo (la ley √(r_f² + (d_t/2 + w·cos α)²) − r_f da {law}; el resto, los bloques)"
        en "beside the blades the floor becomes up to {most} deeper than a_p (upper bound; worst on {track}, point {point}): the flat end of the tool does not fit the hollow floor (the law √(r_f² + (d_t/2 + w·cos α)²) − r_f gives {law}; the rest is the blocks')"
        remedy "una herramienta menor; o cuente con ese fondo más hondo, en el cubo y donde la pieza es delgada",
            "a smaller tool; or reckon with the deeper floor, at the hub and where the part is thin";
        why "En el cubo lo que queda de pared es R − r − a_p, y esto se lo quita.", "At the hub the wall that stays is R − r − a_p, and this is taken from it.";
        example book!("impeller");
    "P1044" IntoOwnFaces Caution { most: Size, faces: Text, law: Size }
        es "las pasadas entran en las propias caras del álabe hasta {most}, y queda más delgado: {faces} (cotas superiores, bloque a bloque; la ley a·(1 − cos θ) en el cubo, que deja fuera el espesor y los bloques, da {law})"
        en "the passes cut up to {most} into the blade's own faces, which leaves it thinner: {faces} (upper bounds, block by block; the law a·(1 − cos θ) at the hub, which leaves out thickness and blocks, gives {law})"
        remedy "una a_p menor o una herramienta menor; un n mayor quita lo que añaden los bloques; o un e mayor, que cuente con ello",
            "a smaller a_p or a smaller tool; a larger n takes away what the blocks add; or a larger e that reckons with it";
        why "El flanco de una fresa cilíndrica no sigue una cara alabeada: lo que entra sale del espesor.",
            "The side of a cylindrical tool does not follow a twisted face: what it enters comes off the thickness.";
        example book!("impeller");
    "P1045" ToolDoesNotPass Caution { tool: Size, gap: Size, at: Size, blades: Text, thickness: Text }
        es "la herramienta de {tool} no pasa entre los álabes: la mayor que pasa es de {gap}; es lo más estrecho, al {at} % del camino del cubo al borde; {blades}; {thickness}"
        en "the tool of {tool} does not pass between the blades: the largest that does has {gap}; this is the narrowest place, {at} % of the way from the hub to the rim; {blades}; {thickness}"
        remedy "menos álabes, álabes más delgados o una herramienta menor; los límites publicados miden por el paralelo, donde la herramienta no pasa",
            "fewer blades, thinner blades, or a smaller tool; the published limits measure along the parallel, which is not how the tool passes";
        why "Una herramienta más ancha que el canal corta los dos álabes que lo forman.",
            "A tool wider than the channel cuts both blades that form it.";
        example book!("impeller", "N" = "5", "splitters" = "no");
    "P1046" GapBelowPublished Caution { gap: Size, tool: Size, least: Size, at: Size, blades: Text, thickness: Text }
        es "entre los álabes pasa una herramienta de {gap} a lo sumo; para la de {tool} se piden {least}; es lo más estrecho, al {at} % del camino del cubo al borde; {blades}; {thickness}"
        en "a tool of {gap} at most passes between the blades; for the one of {tool}, {least} are asked for; this is the narrowest place, {at} % of the way from the hub to the rim; {blades}; {thickness}"
        remedy "menos álabes, álabes más delgados o una herramienta menor; los límites publicados miden por el paralelo, donde la herramienta no pasa",
            "fewer blades, thinner blades, or a smaller tool; the published limits measure along the parallel, which is not how the tool passes";
        why "El método pide un tercio más que la herramienta, para que flexión y desviaciones no toquen el otro álabe.",
            "The method asks for a third more than the tool, so that bending and deviations do not touch the other blade.";
        example book!("impeller");
    "P1047" HeightCalledLength Caution {}
        es "el libro es del esquema 1, que llamaba longitud de herramienta L_t a la altura H de la cara torneada sobre la nariz del husillo portapieza, y R_p a R_B: aquí L_t se lee como H y L = R_p + L_t. Si en L_t está la longitud de una herramienta, los programas son falsos"
        en "the workbook is of schema 1, which called the height H of the turned face over the work spindle's nose a tool length L_t, and R_B it called R_p: L_t is read as H here, and L = R_p + L_t. If L_t holds the length of a tool, the programs are wrong"
        remedy "mida H y compruébela; haga un libro nuevo con \"rodete new\" y escriba en él los valores",
            "measure H and compare; make a new workbook with \"rodete new\" and type the values there";
        why "Quien leyó longitud de herramienta pudo escribir la de una fresa, y de ella saldría la longitud de pivote.",
            "Who read tool length may have typed that of an end mill, and the pivot length would follow from it.";
        example Example::Made { key: "schema-1", how: t("un libro de rodete-impeller 1", "a workbook of rodete-impeller 1") };
}
