//! Contradictions of an impeller.

use crate::finding::Size;
use crate::finding::rule::{book, rules};

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
}
