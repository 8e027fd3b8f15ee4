//! Contradictions of an impeller, and what a person should know of its plan.

use crate::finding::rule::{book, rules};
use crate::finding::{Bare, Example, Size, Typed};
use crate::kinds::impeller::clear::rules::Largest;
use crate::text::{Text, t};

rules! {
    /// The rows of an impeller.
    RULES;
    "P1001" TorusCloses Stop { r: Typed, R: Typed }
        es "el radio del meridiano r es {r} y debe ser menor que R = {R} en más de una millonésima: si no, el toro se cierra"
        en "meridian radius r is {r}; it must be less than R = {R} by more than a millionth, or the torus closes"
        remedy "elija un meridiano menor o un toro mayor", "choose a smaller meridian or a larger torus";
        why "Un toro cerrado no tiene círculos de Villarceau.", "A closed torus has no Villarceau circles.";
        example book!("impeller", "r" = "25", "R" = "25");
    "P1002" CutThroughHub Stop { a_p: Size, room: Size }
        es "la profundidad a_p es {a_p} y debe ser menor que R - r = {room}"
        en "depth of cut a_p is {a_p}; it must be less than R - r = {room}"
        remedy "elija una profundidad menor", "choose a smaller depth";
        why "La herramienta atravesaría el cubo.", "The tool would cut through the hub.";
        example book!("impeller", "a_p" = "100");
    "P1003" ToolBeyondHollow Stop { tool: Size, r: Size }
        es "la herramienta de {tool} no cabe en el hueco de radio r = {r}"
        en "a tool of {tool} does not fit into the hollow of radius r = {r}"
        remedy "elija una herramienta menor", "choose a smaller tool";
        why "La herramienta quitaría más metal que el del hueco.", "The tool would remove more metal than the hollow.";
        example book!("impeller", "d_t" = "50");
    "P1004" NoBladeFits Stop { e: Size, tool: Size, need: Size, hub: Size, gap: Size, least: Size }
        es "no cabe ni un álabe con e = {e} y d_t = {tool}: él y su separación necesitan {need}, y el contorno del cubo mide {hub}"
        en "not even one blade fits with e = {e} and d_t = {tool}: it and its gap need {need}, and the hub measures {hub} all round"
        remedy "use menos álabes, álabes más delgados o una herramienta menor; entre álabes quedan {gap} y hacen falta {least}",
            "use fewer blades, thinner blades, or a smaller tool; the gap between blades is {gap}, and {least} is needed";
        why "La herramienta debe pasar entre dos álabes.", "The tool must pass between two blades.";
        example book!("impeller", "e" = "100");
    "P1005" TooManyBlades Stop { N: u32, most: Size, e: Size, tool: Size, gap: Size, least: Size }
        es "el número de álabes N es {N} y no debe pasar de N_max = {most} con e = {e} y d_t = {tool}"
        en "number of blades N is {N}; it must not exceed N_max = {most} for e = {e} and d_t = {tool}"
        remedy "use menos álabes, álabes más delgados o una herramienta menor; entre álabes quedan {gap} y hacen falta {least}",
            "use fewer blades, thinner blades, or a smaller tool; the gap between blades is {gap}, and {least} is needed";
        why "La herramienta debe pasar entre dos álabes.", "The tool must pass between two blades.";
        example book!("impeller --case full", "N" = "40");
    "P1006" NoThicknessFits Stop { N: u32, e: Size, room: Size, least: Size }
        es "con N = {N} no cabe ningún espesor de álabe (e es {e}): el cubo da {room} por álabe y la herramienta necesita {least}"
        en "with N = {N} no blade thickness fits (e is {e}): the hub gives {room} per blade, and the tool needs {least}"
        remedy "use menos álabes, álabes más delgados o una herramienta menor",
            "use fewer blades, a thinner blade, or a smaller tool";
        why "La herramienta sola ocupa ya todo el contorno del cubo.", "The tool alone takes up the whole turn.";
        example book!("impeller --case full", "N" = "60");
    "P1007" BladeTooThick Stop { e: Size, most: Size, blades: Text, N: u32 }
        es "el espesor del álabe e es {e} y no debe pasar de e_max = {most} con {blades}"
        en "blade thickness e is {e}; it must not exceed e_max = {most} for {blades}"
        remedy "use menos álabes, álabes más delgados o una herramienta menor",
            "use fewer blades, a thinner blade, or a smaller tool";
        why "La herramienta debe pasar entre dos álabes.", "The tool must pass between two blades.";
        example book!("impeller --case full", "e" = "20");
    "P1008" SafePointsInside Stop { d_s: Size, least: Size }
        es "con d_s = {d_s} los puntos de seguridad quedan dentro de las pasadas"
        en "with d_s = {d_s} the safe points are inside the passes"
        remedy "elija una distancia de seguridad d_s mayor que {least}", "choose a safety distance d_s above {least}";
        why "La herramienta giraría o bajaría en rápido dentro del metal.", "The tool would swivel or come down in rapid inside the metal.";
        example book!("impeller --case full", "d_s" = "0.1");
    "P1009" PivotInside Stop { L: Size, least: Size }
        es "la longitud de pivote L = R_B + H es {L}: el pivote queda dentro de la pieza"
        en "pivot length L = R_B + H is {L}: the pivot is inside the part"
        remedy "compruebe R_B y H; L debe ser mayor que {least}", "check R_B and H; make L greater than {least}";
        why "El eje B gira por debajo de la pieza y no puede estar dentro de ella.", "The B axis swivels below the part and cannot be inside it.";
        example book!("impeller", "R_B" = "1", "H" = "1");
    "P1010" TravelReversed Stop { axis: char, low: Bare, high: Bare }
        es "el límite inferior de {axis} ({low}) no es menor que el superior ({high})"
        en "the lower limit of {axis} ({low}) is not below the upper limit ({high})"
        remedy "intercambie los límites", "swap the limits";
        why "Con los límites al revés no vale ninguna posición.", "With the limits reversed no position is allowed.";
        example book!("impeller", "X_min" = "100", "X_max" = "-100");
    "P1011" FeedBeyondMachine Stop { F: Size, F_max: Size }
        es "el avance F es {F} y supera F_max = {F_max}"
        en "feed F is {F}; it must not exceed F_max = {F_max}"
        remedy "elija un avance menor", "choose a lower feed";
        why "La máquina no llega a ese avance.", "The machine does not reach that feed.";
        example book!("impeller", "F" = "5000", "F_max" = "3000");
    "P1012" AbsoluteOnRollover Stop {}
        es "distance = G90 con ejes rollover: en G90 el signo es el sentido y el número el ángulo; en cada bloque B daría casi una vuelta y C giraría al revés"
        en "distance = G90 with rollover axes: in G90 the sign is the direction and the number is the angle; in each block B would make nearly a full turn and C would turn the wrong way"
        remedy "elija distance = G91, que vale para los dos tipos de eje; o, si B y C de la máquina cuentan como ejes lineales, rotary = lineal (fila rotary, valor en la columna C)",
            "choose distance = G91, which suits both types of axis; or, if B and C of the machine count as linear axes, rotary = linear (row rotary, value in column C)";
        why "La herramienta atravesaría la pieza mientras esta gira.", "The tool would go through the part while the part turns.";
        example book!("impeller", "distance" = "G90", "rotary" = "rollover");
    "P1013" TooManyBlocks Stop { blocks: u64, most: u64 }
        es "el programa del rodete tendría {blocks} bloques; el límite es {most}"
        en "the program of the whole impeller would have {blocks} blocks; the limit is {most}"
        remedy "elija un n menor", "choose a smaller n";
        why "Ningún control admite tantos bloques, y comprobarlos no acabaría nunca.", "No control accepts so many blocks, and checking them would never end.";
        example book!("impeller --case full", "n" = "100000", "N" = "60");
    "P1014" StockTooShort Stop { length: Size, r: Size }
        es "el bruto mide {length} de largo; el toro necesita más de r = {r}"
        en "the stock is {length} long; the torus needs more than r = {r}"
        remedy "use un bruto más largo", "use longer stock";
        why "El torneado baja r por debajo de la cara.", "Turning goes down to r below the face.";
        example book!("impeller", "L_b" = "10");
    "P1015" EndInsideStock Stop { X_e: Size, diameter: Size }
        es "la X final X_e de {X_e} queda dentro del bruto de diámetro {diameter}"
        en "the end position X_e of {X_e} is inside the stock of diameter {diameter}"
        remedy "elija una X final mayor que 2·R", "choose an X_e above 2·R";
        why "La herramienta acabaría en rápido dentro del metal.", "The tool would end in rapid inside the metal.";
        example book!("impeller", "X_e" = "10");
    "P1016" StepBeyondMeridian Stop { C: Size, r: Size }
        es "el paso C es {C} y supera r = {r}"
        en "step C is {C}; it must not exceed r = {r}"
        remedy "elija un paso menor", "choose a smaller step";
        why "Una sola pasada cortaría más hondo que el hueco.", "A single pass would cut deeper than the hollow.";
        example book!("impeller", "C" = "20");
    "P1017" NothingCrosses Stop {}
        es "nada limita el álabe intermedio: su trayectoria no cruza la del álabe vecino"
        en "nothing limits the splitter: its path does not cross the neighbouring blade's path"
        remedy "ponga splitters = no, o use más álabes, álabes más gruesos o una herramienta mayor",
            "set splitters = no, or use more blades, thicker blades, or a larger tool";
        why "El álabe intermedio acaba donde su trayectoria cruza la del vecino.",
            "A splitter ends where its path crosses its neighbour's path.";
        example book!("impeller --case full", "N" = "1", "e" = "0.1", "d_t" = "0.5", "d_s" = "5");
    "P1018" SplitterWithoutPoint Stop {}
        es "no queda álabe intermedio: su trayectoria cruza la del álabe vecino ya en el primer punto"
        en "no splitter is left: its path crosses the neighbouring blade's path at the very first point"
        remedy "ponga splitters = no, o use menos álabes, álabes más delgados, una herramienta menor o un n mayor",
            "set splitters = no, or use fewer blades, thinner blades, a smaller tool, or a larger n";
        why "Antes del primer punto no hay trayectoria por la que cortar.", "Before the first point there is no path to cut along.";
        example book!("impeller --case full", "n" = "2", "N" = "5", "splitter_fade" = "published");
    "P1019" NoRoomForSplitter Stop {}
        es "no cabe un álabe intermedio: por más que se aparte, la herramienta cortaría el álabe vecino"
        en "no splitter fits: however it fades out, the tool would cut into the neighbouring blade"
        remedy "ponga splitters = no, o use menos álabes, álabes más delgados, una herramienta menor o un n mayor",
            "set splitters = no, or use fewer blades, thinner blades, a smaller tool, or a larger n";
        why "El metal que la herramienta quita a otro álabe no se recupera.", "Metal cut from another blade is lost.";
        example book!("impeller --case full", "n" = "2", "N" = "5");
    "P1020" SlotsContradict Stop {}
        es "la calibración no tiene solución real: las ranuras no son de una misma máquina"
        en "the calibration has no real solution: the slots cannot come from one machine"
        remedy "compruebe x0, z0 y las medidas de las ranuras", "check x0, z0 and the measured slots";
        why "La altura y el ángulo del eje B salen de las dos ranuras por una ecuación de segundo grado; con medidas erróneas no tiene raíz.",
            "The height and angle of the B axis follow from both slots by a quadratic equation, which has no root if the slots are measured wrongly.";
        example book!("impeller --case full", "CALIBRATION!C6" = "60", "CALIBRATION!C7" = "50", "CALIBRATION!C8" = "3", "CALIBRATION!C9" = "4",
            "CALIBRATION!C10" = "6", "CALIBRATION!C11" = "0.1", "CALIBRATION!C12" = "0.1");
    "P1021" AnnexWithoutFeed Caution {}
        es "style = anexo no lleva avance F ni velocidad S, como los programas publicados"
        en "style = annex has no feed F and no speed S, like the published programs"
        remedy "fíjelos en el control antes de empezar, o elija style = completo", "set them at the control before the start, or choose style = full";
        why "El control usaría el avance y la velocidad del programa anterior.",
            "The control would use the feed and speed of the previous program.";
        example book!("impeller --case full", "style" = "annex");
    "P1022" AnnexStartsAnywhere Caution {}
        es "el programa incremental empieza en la posición actual de la máquina: llévela antes al punto de seguridad de entrada, con B y C del Anexo 6"
        en "the incremental program starts from the machine's present position: first move to the safe entry point, with B and C of Annex 6"
        remedy "elija style = completo, que va por sí mismo al punto de inicio", "choose style = full, which goes to its start point by itself";
        why "Desde otro punto, toda la pasada se desplaza lo mismo, también en rápido.",
            "From another point the whole pass shifts by the same distance, also in rapid.";
        example book!("impeller --case full", "style" = "annex");
    "P1023" AnnexIsRepeated Caution { N: u32, half: Size }
        es "ejecute {N} veces el programa del álabe y {N} veces el del intermedio; antes del primer intermedio, gire C {half}"
        en "run the blade program {N} times and the splitter program {N} times; before the first splitter, turn C by {half}"
        remedy "ejecute mejor el programa del rodete completo, que lo hace todo de una vez", "rather run the program of the whole impeller, which does it all in one run";
        why "Cada programa corta un álabe y deja C en el siguiente; los intermedios van a mitad de camino.",
            "Each program cuts one blade and leaves C at the next one; splitters are half way between.";
        example book!("impeller --case full", "style" = "annex");
    "P1024" TravelNotChecked Note { limits: String }
        es "no se comprueban los límites vacíos: {limits}"
        en "empty limits are not checked: {limits}"
        remedy "", "";
        why "Sin sus límites no se sabe si un eje llega al final de su recorrido.",
            "Without its limits it is not known whether an axis reaches the end of its travel.";
        example book!("impeller --case full");
    "P1025" SpeedNotChecked Note {}
        es "F_max está vacío: la velocidad de los ejes no se comprueba"
        en "F_max is empty: axis speeds are not checked"
        remedy "", "";
        why "Con los cinco ejes a la vez, un eje lineal puede tener que ir mucho más deprisa que la punta.",
            "With five axes moving together, a linear axis may have to go much faster than the tip.";
        example book!("impeller --case full", "F_max" = "");
    "P1026" FeedReduced Note { counted: Text, moves: usize, most: Size }
        es "rodete reduce el avance en {counted} de toda la pieza para que ningún eje pase de F_max = {most}"
        en "rodete reduces the feed in {counted} of the whole part so that no axis exceeds F_max = {most}"
        remedy "", "";
        why "Un eje al que se pide demasiado se retrasa, y la punta se sale de su trayectoria.",
            "An axis that is asked to go too fast lags, and the tip leaves its path.";
        example book!("impeller --case full", "F_max" = "1000");
    "P1027" FeedWordAtItsEnd Caution { counted: Text, moves: usize, longer: Text }
        es "en {counted} de toda la pieza la palabra F llega al límite de su formato: el avance real es otro"
        en "in {counted} of the whole part the F word reaches the limit of its format: the true feed differs"
        remedy "elija otro avance, o bloques más largos: {longer}", "choose another feed, or longer blocks: {longer}";
        why "El formato no permite escribir la F necesaria, y el bloque dura otro tiempo.",
            "The format cannot hold the F needed, so the block takes another time.";
        example book!("impeller --case full", "F" = "50000", "F_max" = "", "n" = "100");
    "P1029" BlankForFagor Note {}
        es "el programa del bruto es para un torno con Fagor 8055 T, sea cual sea el control de la fresadora"
        en "the blank's program is for a lathe with a Fagor 8055 T, whatever the mill's control"
        remedy "", "";
        why "Sus ciclos de torneado son de ese control; en otro torno, tornee la pieza con otro programa.",
            "Its turning cycles belong to that control; on another lathe, turn the part with another program.";
        example book!("impeller --case full");
    "P1030" CalibrationAgrees Note { found: Size, B: Size, R_B: Size }
        es "la calibración da R_B = {found} y B = {B}; el libro dice R_B = {R_B} (de dos soluciones, la más próxima)"
        en "the calibration gives R_B = {found} and B = {B}; the workbook says R_B = {R_B} (the nearer one of two solutions)"
        remedy "", "";
        why "Hasta una centésima de diferencia, la décima parte de lo que se ve en una ranura, el libro y las ranuras coinciden.",
            "Up to a hundredth apart, a tenth of what the eye sees in a slot, workbook and slots agree.";
        example book!("impeller --case full", "CALIBRATION!C6" = "60", "CALIBRATION!C7" = "50", "CALIBRATION!C8" = "3", "CALIBRATION!C9" = "4",
            "CALIBRATION!C10" = "6", "CALIBRATION!C11" = "-206.5", "CALIBRATION!C12" = "-185.5");
    "P1031" CalibrationDiffers Caution { found: Size, B: Size, R_B: Size, better: Bare }
        es "la calibración da R_B = {found} y B = {B}; el libro dice R_B = {R_B} (de dos soluciones, la más próxima)"
        en "the calibration gives R_B = {found} and B = {B}; the workbook says R_B = {R_B} (the nearer one of two solutions)"
        remedy "compruebe las ranuras y valore poner R_B = {better}", "check the slots and consider R_B = {better}";
        why "R_B da la longitud de pivote: un error en ella desplaza la punta en cada giro de B.",
            "R_B sets the pivot length: an error in it shifts the tip at every swivel of B.";
        example book!("impeller --case full", "CALIBRATION!C6" = "60", "CALIBRATION!C7" = "50", "CALIBRATION!C8" = "3", "CALIBRATION!C9" = "4",
            "CALIBRATION!C10" = "6", "CALIBRATION!C11" = "-207", "CALIBRATION!C12" = "-185.5");
    "P1032" NoCoolant Note {}
        es "coolant está vacío: los programas no conectan el refrigerante"
        en "coolant is empty: the programs do not switch on coolant"
        remedy "", "";
        why "El código depende de la máquina, y rodete no supone ninguno.",
            "The code depends on the machine, and rodete assumes none.";
        example book!("impeller --case full");
    "P1033" AnnexByIncrements Note {}
        es "los programas giran B y C solo en incremental (G91): valen con ejes rollover y lineales, desde los ángulos del Anexo 6"
        en "the programs turn B and C only in increments (G91): they suit rollover and linear axes, from the angles of Annex 6"
        remedy "", "";
        why "En incremental el número es lo que gira el eje, cuente como cuente; solo importa el ángulo de partida.",
            "In increments the number is how far the axis turns, however it counts; only the starting angle matters.";
        example book!("impeller --case full", "style" = "annex");
    "P1034" TurnsByIncrements Note {}
        es "los programas valen con ejes rollover y lineales: un bloque G90 con ángulos entre 0 y 360 y todo lo demás en G91; antes de empezar, B y C deben marcar 0, y a 0 vuelven al acabar"
        en "the programs suit rollover and linear axes: one G90 block with angles between 0 and 360, the rest in G91; before the start B and C must show 0, and they end at 0"
        remedy "", "";
        why "Entre 0 y 360 el número absoluto es el mismo ángulo en los dos tipos de eje; desde 0, también el mismo giro.",
            "Between 0 and 360 an absolute number is the same angle on both types of axis; from 0 it is also the same turn.";
        example book!("impeller --case full");
    "P1035" IncrementsFromZero Note {}
        es "los programas giran B y C en incremental (G91) tras un bloque con B0 C0: valen con ejes lineales; con otros, pruébelos antes bloque a bloque"
        en "the programs turn B and C in increments (G91) after a block with B0 C0: they suit linear axes; on others try them in single block first"
        remedy "", "";
        why "El control cuenta B y C como ejes lineales: el bloque con B0 C0 deshace las vueltas acumuladas.",
            "The control counts B and C as linear axes: the block with B0 C0 unwinds the turns made so far.";
        example book!("impeller --case full", "dialect" = "linuxcnc", "start_codes" = "M3", "retract" = "");
    "P1036" OnLinearAxesUnproved Caution {}
        es "los programas solo valen si B y C cuentan como ejes lineales: en un eje rollover el signo es el sentido y el número el ángulo"
        en "the programs are right only if B and C count as linear axes: on a rollover axis the sign is the direction and the number is the angle"
        remedy "compruebe en la máquina que G90 C-90 desde 0 gira 90° y no 270°; o elija distance = G91",
            "check on the machine that G90 C-90 from 0 turns 90° and not 270°; or choose distance = G91";
        why "El libro dice que cuentan como lineales, pero el control se entrega con ellos como rollover.",
            "The workbook says that they count as linear, but the control is delivered with rollover axes.";
        example book!("impeller --case full", "distance" = "G90", "rotary" = "linear");
    "P1037" OnLinearAxes Note {}
        es "los programas solo valen si B y C cuentan como ejes lineales: en un eje rollover el signo es el sentido y el número el ángulo"
        en "the programs are right only if B and C count as linear axes: on a rollover axis the sign is the direction and the number is the angle"
        remedy "", "";
        why "El mismo número absoluto lleva a un eje rollover a otro ángulo.",
            "The same absolute number takes a rollover axis to another angle.";
        example book!("impeller --case full", "dialect" = "linuxcnc", "start_codes" = "M3", "retract" = "", "rotary" = "linear", "distance" = "G90");
    "P1038" ClampsOfBuilder Note {}
        es "M11 y M13, de los programas publicados, son códigos de fabricante para los frenos de los ejes giratorios de aquella máquina: compruébelos en el manual de la suya"
        en "M11 and M13, from the published programs, are builder's codes for the rotary axis clamps of that machine: check them in your machine's manual"
        remedy "", "";
        why "El mismo código hace otra cosa en la máquina de otro fabricante.", "The same code does something else on another builder's machine.";
        example book!("impeller --case full");
    "P1039" ClampsMissing Caution { missing: String }
        es "start_codes no lleva {missing}: los programas publicados empiezan con M11 M13, códigos de fabricante para los frenos de los ejes giratorios"
        en "start_codes lacks {missing}: the published programs begin with M11 M13, builder's codes for the rotary axis clamps"
        remedy "escriba los códigos con los que su máquina suelta B y C, si los tiene; la precaución queda, pues rodete no los conoce",
            "add the codes that release B and C on your machine, if it has any; the caution stays, as rodete does not know them";
        why "Un eje que gira con el freno puesto lo gasta, o el control se para.", "An axis that turns against its clamp wears it out, or the control stops.";
        example book!("impeller --case full", "start_codes" = "M3");
    "P1040" NoRetract Caution {}
        es "retract está vacío: el primer movimiento lleva Z a su altura de retirada con X, Y y B en su posición actual, y nada retira antes la herramienta"
        en "retract is empty: the first motion takes Z to its retract height with X, Y and B in their present position, and nothing retracts the tool before"
        remedy "escriba el bloque con el que su máquina sube Z; o, antes de cada arranque, lleve la herramienta a mano a lo alto de Z",
            "write the block that raises Z on your machine; or, before each start, move the tool by hand to the top of Z";
        why "La altura de retirada vale con B en su sitio; desde otra posición el camino puede atravesar la pieza.",
            "The retract height holds with B in its place; from another position the path may go through the part.";
        example book!("impeller --case full", "retract" = "");
    "P1041" RetractIsAssumed Caution {}
        es "retract con G53 supone que el cero máquina está en lo alto de Z y que G53 no cuenta correctores (G44); rodete no lo ha contrastado con el manual del control"
        en "retract with G53 assumes that machine zero is at the top of Z and that G53 ignores tool offsets (G44); rodete did not check this in the control's manual"
        remedy "compruébelo en el manual de la máquina y la primera vez ejecute ese bloque en modo bloque a bloque y con el avance reducido",
            "check it in the machine's manual, and the first time run that block in single block with the feed turned down";
        why "Si el cero máquina está abajo, ese bloque lleva la herramienta en rápido contra la pieza.",
            "If machine zero is at the bottom, that block takes the tool into the part in rapid.";
        example book!("impeller --case full");
    "P1042" RibsLeft Caution { most: Size, from: Size, width: Size, across: Size }
        es "quedan nervios sin cortar en los canales: ninguna pasada toca hasta un {most} de la superficie torneada entre dos álabes (valor máximo), desde el {from} del camino del cubo al borde; en el borde el más ancho mide hasta {width} a lo largo del canto ({across} de través)"
        en "ribs stay uncut in the channels: no pass touches up to {most} of the turned surface between two blades (upper bound), from {from} of the way from hub to rim; at the rim the widest rib measures up to {width} along the edge ({across} across)"
        remedy "vacíe los canales con un programa propio, o use más álabes o una herramienta mayor si la separación real lo permite: el plan solo corta a los lados de cada álabe",
            "clear the channels with a program of your own, or use more blades or a larger tool if the true gap allows: the plan cuts only beside each blade";
        why "El metal que queda obstruye el canal entre los álabes.", "The metal left blocks the channel between the blades.";
        example book!("impeller --case full", "splitters" = "no");
    "P1043" FloorTooDeep Caution { most: Size, track: Text, point: Size, law: Size }
        es "junto a los álabes el fondo queda hasta {most} más hondo que a_p (valor máximo; lo peor, {track}, punto {point}): el extremo plano de la fresa no cabe en el fondo cóncavo (eso solo da {law}; el resto viene de los bloques)"
        en "beside the blades the floor is up to {most} deeper than a_p (upper bound; worst on {track}, point {point}): the flat end of the tool does not fit the concave floor (that alone gives {law}; the rest comes from the blocks)"
        remedy "elija una herramienta menor, o cuente con ese fondo más hondo en el cubo y donde la pieza es delgada",
            "choose a smaller tool, or allow for the deeper floor at the hub and where the part is thin";
        why "En el cubo la pared mide R - r - a_p, menos lo que el fondo tenga de más. El extremo plano solo da √(r_f² + (d_t/2 + w·cos α)²) - r_f: r_f es el radio del arco del fondo, r + a_p; w, lo que el eje se aparta de la línea media; α, el ángulo entre la línea media y el paralelo.",
            "At the hub the wall is R - r - a_p, less the extra depth of the floor. The flat end alone gives √(r_f² + (d_t/2 + w·cos α)²) - r_f: r_f is the radius of the arc of the floor, r + a_p; w is how far the axis is from the mean line; α is the angle between the mean line and the parallel.";
        example book!("impeller --case full");
    "P1044" IntoOwnFaces Caution { most: Size, faces: Text, law: Size }
        es "las pasadas entran hasta {most} en las propias caras del álabe, que queda más delgado: {faces} (valores máximos, bloque a bloque; solo por el alabeo en el cubo, sin contar el espesor ni los bloques, {law})"
        en "the passes cut up to {most} into the blade's own faces and leave the blade thinner: {faces} (upper bounds, block by block; from the twist at the hub alone, without thickness and blocks, {law})"
        remedy "elija una a_p menor, una herramienta menor o un e mayor que lo compense; un n mayor reduce lo que añaden los bloques",
            "choose a smaller a_p, a smaller tool, or a larger e to make up for it; a larger n reduces what the blocks add";
        why "El flanco recto de una fresa no sigue una cara alabeada: lo que entra en ella reduce el espesor. El alabeo solo da d_t/2·(1 - cos θ): θ es lo que la cara gira de la superficie torneada al fondo.",
            "The side of a cylindrical cutter does not follow a twisted face: where it enters the face, the blade gets thinner. The twist alone gives d_t/2·(1 - cos θ): θ is how far the face turns from the turned surface to the floor.";
        example book!("impeller --case full");
    "P1045" ToolDoesNotPass Caution { tool: Size, largest: Largest, at: Size, blades: Text, thickness: Text }
        es "la herramienta de {tool} no pasa entre los álabes; la mayor que pasa: {largest}; el paso más estrecho está al {at} del camino del cubo al borde; {blades}; {thickness}"
        en "the tool of {tool} does not pass between the blades; the largest that does: {largest}; the narrowest place is {at} of the way from hub to rim; {blades}; {thickness}"
        remedy "use menos álabes, álabes más delgados o una herramienta menor; los límites publicados miden a lo largo del paralelo, que no es por donde pasa la herramienta",
            "use fewer blades, thinner blades, or a smaller tool; the published limits measure along the parallel, which is not where the tool passes";
        why "Una herramienta más ancha que el canal corta los dos álabes.",
            "A tool wider than the channel cuts into both blades.";
        example book!("impeller --case full", "N" = "5", "splitters" = "no");
    "P1046" GapBelowPublished Caution { gap: Size, tool: Size, least: Size, at: Size, blades: Text, thickness: Text }
        es "entre los álabes pasa como mucho una herramienta de {gap}; para la de {tool} la regla publicada pide {least}; el paso más estrecho está al {at} del camino del cubo al borde; {blades}; {thickness}"
        en "a tool of {gap} at most passes between the blades; for the tool of {tool} the published rule asks for {least}; the narrowest place is {at} of the way from hub to rim; {blades}; {thickness}"
        remedy "use menos álabes, álabes más delgados o una herramienta menor; los límites publicados miden a lo largo del paralelo, que no es por donde pasa la herramienta",
            "use fewer blades, thinner blades, or a smaller tool; the published limits measure along the parallel, which is not where the tool passes";
        why "La regla publicada pide un tercio más que la herramienta, para que ni la flexión ni las desviaciones toquen el otro álabe.",
            "The published rule asks for a third more than the tool, so that a bent tool or a deviation does not touch the other blade.";
        example book!("impeller --case full");
    "P1047" HeightCalledLength Caution {}
        es "el libro es del esquema 1. Allí la altura H de la cara torneada sobre la nariz del husillo portapieza se llamaba longitud de herramienta L_t, y R_B se llamaba R_p: rodete lee L_t como H y toma L = R_p + L_t. Si en L_t está la longitud de una herramienta, los programas son erróneos"
        en "the workbook has schema 1. There the height H of the turned face above the work spindle nose was called tool length L_t, and R_B was called R_p: rodete reads L_t as H and takes L = R_p + L_t. If L_t holds the length of a tool, the programs are wrong"
        remedy "mida H y compárela; cree un libro nuevo con \"rodete new\" y escriba en él los valores",
            "measure H and compare; make a new workbook with \"rodete new\" and type the values there";
        why "Quien leyó ese nombre pudo escribir la de una fresa, y la longitud de pivote saldría de ella.",
            "A reader of that name may have typed the length of an end mill, and the pivot length would follow from it.";
        example Example::Made { key: "schema-1", how: t("un libro de rodete-impeller 1", "a workbook of rodete-impeller 1") };
    "P1048" SpindleNotStarted Caution {}
        es "start_codes no lleva M3 ni M4: ningún bloque de los programas arranca el husillo"
        en "start_codes has neither M3 nor M4: no block of the programs starts the spindle"
        remedy "escriba M3 en start_codes, o arranque el husillo antes de cada programa",
            "write M3 into start_codes, or start the spindle before each program";
        why "Una fresa que no gira se rompe en el primer corte.", "A cutter that does not turn breaks in the first cut.";
        example book!("impeller --case full", "start_codes" = "M11 M13");
    "P1049" LengthByOffset Caution { offsets: Text, may: Text, those: Text }
        es "en este control {offsets} {may} activar la longitud de la tabla de herramientas, y los programas la ponen en el cero de Z"
        en "on this control {offsets} {may} bring the length of the tool table into force, and the programs take it from the zero of Z"
        remedy "ponga a 0 en la tabla la longitud de {those}, y tome el cero de Z con la herramienta", "set the length of {those} to 0 in the table, and set the Z zero with the tool";
        why "Con la longitud en la tabla y en el cero, la punta queda baja o alta en toda la longitud de la fresa.",
            "With the length both in the table and in the zero, the tip is too low or too high by the whole length of the tool.";
        example book!("impeller --case full", "dialect" = "fagor-8070", "retract" = "");
    "P1050" RetractTooLow Stop { z: Size, height: Size }
        es "retract lleva Z a {z}, por debajo de la altura de retirada Z_r de {height}"
        en "retract takes Z to {z}, below the retract height Z_r of {height}"
        remedy "escriba esa altura o una mayor, o deje la celda vacía y retire la herramienta a mano",
            "write that height or a greater one, or leave the cell empty and retract the tool by hand";
        why "Por debajo de Z_r la fresa puede entrar en la pieza, según cómo esté B.", "Below Z_r the cutter may go into the part, depending on B.";
        example book!("impeller", "dialect" = "fagor-8070", "start_codes" = "M3", "retract" = "G0 Z-20");
    "P1051" RetractSideways Stop { axis: char }
        es "retract mueve también {axis}: la fresa puede cruzar la pieza de lado"
        en "retract moves {axis} as well: the cutter may cross the part sideways"
        remedy "deje solo Z en el bloque", "leave only Z in the block";
        why "Un movimiento rápido en diagonal no sube antes de ir de lado.", "A diagonal rapid move does not go up before it goes sideways.";
        example book!("impeller", "dialect" = "fagor-8070", "start_codes" = "M3", "retract" = "G0 X0 Z100");
    "P1052" RetractOutside Stop { z: Size, limit: Size }
        es "retract lleva Z a {z}, fuera de su recorrido (límite {limit})"
        en "retract takes Z to {z}, beyond its travel (limit {limit})"
        remedy "escriba una altura dentro del recorrido", "write a height within the travel";
        why "El control se para en el final de carrera, con el programa a medio empezar.", "The control stops at the limit switch with the program hardly begun.";
        example book!("impeller", "dialect" = "fagor-8070", "start_codes" = "M3", "retract" = "G0 Z100", "Z_max" = "50");
    "P1053" RetractByProgram Caution { z: Size }
        es "retract lleva Z a {z} en coordenadas de programa: cuenta con el cero y el corrector que estén activos en ese momento, y rodete no los conoce"
        en "retract takes Z to {z} in program coordinates: it counts with the zero and the tool offset that are in force at that moment, and rodete does not know them"
        remedy "compruébelo antes de cada arranque con la herramienta que esté en el husillo, o deje la celda vacía y retire la herramienta a mano",
            "check this before each start with the tool that is in the spindle, or leave the cell empty and retract the tool by hand";
        why "Con otro corrector la punta llega más abajo.", "With another offset the tip reaches lower.";
        example book!("impeller", "dialect" = "fagor-8070", "start_codes" = "M3", "retract" = "G0 Z100");
    "P1054" RetractElsewhere Caution { z: Size }
        es "retract lleva Z a {z} en coordenadas de máquina: rodete no sabe si la fresa libra ahí la pieza"
        en "retract takes Z to {z} in machine coordinates: rodete does not know whether the cutter clears the part there"
        remedy "compruebe esa posición en la máquina, o escriba Z0 si el cero máquina está en lo alto de Z",
            "check that position on the machine, or write Z0 if machine zero is at the top of Z";
        why "El bloque va en rápido y con B en cualquier ángulo.", "The block is rapid, with B at whatever angle.";
        example book!("impeller", "retract" = "G0 G53 Z-300");
}
