//! Contradictions of pipes: their sizes.

use crate::finding::rule::{book, rules};
use crate::finding::{Key, Size, Typed};
use crate::text::Text;

rules! {
    /// The rows of a pipe's size.
    RULES;
    "P2001" NoSchedule Stop { number: &'static str, nps: &'static str, diameter: Key, wall: Key }
        es "ASME B36.10 no tiene cédula {number} en el tamaño {nps}"
        en "ASME B36.10 has no schedule {number} in size {nps}"
        remedy "elija otra cédula, o escriba {diameter} y {wall}", "choose another schedule, or fill in {diameter} and {wall}";
        why "La norma no da espesor para ese par, y rodete no lo adivina.", "The standard gives no wall thickness for this pair, and rodete does not guess one.";
        example book!("pipe-insert", "branch_size" = "1/8 in", "branch_schedule" = "Sch 160");
    "P2002" TwoSizes Stop {
        size: Key, nps: &'static str, number: &'static str, outside: Typed, thick: Typed, diameter: Key, wall: Key,
    }
        es "{size} {nps} cédula {number} es {outside} × {thick}, pero {diameter} o {wall} no coincide"
        en "{size} {nps} schedule {number} is {outside} × {thick}, but {diameter} or {wall} differs"
        remedy "deje vacíos {diameter} y {wall}, o el tamaño nominal", "empty {diameter} and {wall}, or the nominal size";
        why "Con dos medidas distintas no se sabe cuál es la del tubo.", "With two different sizes it is not clear which one the pipe has.";
        example book!("pipe-insert", "D_branch" = "90");
    "P2003" SizeMissing Stop { size: Key, schedule: Key, diameter: Key, wall: Key }
        es "falta el tamaño: {size} y {schedule}, o {diameter} y {wall}"
        en "the size is missing: {size} and {schedule}, or {diameter} and {wall}"
        remedy "rellene uno de los dos pares", "fill in one of the two pairs";
        why "La curva de corte sale del diámetro y la pared.", "The cut depends on the diameter and the wall.";
        example book!("pipe-insert", "branch_schedule" = "");
    "P2004" WallBeyondRadius Stop { pipe: Text, wall: Size, radius: Size }
        es "la pared {pipe} mide {wall} y debe ser menor que el radio, {radius}"
        en "the wall {pipe} is {wall}; it must be less than the radius, {radius}"
        remedy "compruebe diámetro y pared", "check diameter and wall";
        why "Con una pared así el tubo no tendría hueco.", "With such a wall the pipe would have no bore.";
        example book!("pipe-hole", "branch_size" = "", "branch_schedule" = "", "D_branch" = "20", "t_branch" = "15");
    "P2005" NoLeadIn Caution {}
        es "sin entrada: la antorcha perfora sobre la curva"
        en "no lead-in: the torch pierces on the curve"
        remedy "ponga una entrada de unos milímetros", "use a lead-in of a few millimetres";
        why "La perforación deja un cráter más ancho que el corte, y sin entrada queda en la pieza.",
            "Piercing leaves a crater wider than the cut, and without a lead-in it stays in the part.";
        example book!("pipe-hole", "lead_in" = "0");
    "P2006" CodeInBoth Stop { one: Key, other: Key, number: u32 }
        es "{one} y {other} llevan los dos M{number}: el mismo código no puede hacer las dos cosas"
        en "{one} and {other} both hold M{number}: one code cannot do both"
        remedy "escriba en cada celda los códigos de su máquina, como M3 para encender y M5 para apagar",
            "write into each cell the codes of your machine, such as M3 to turn on and M5 to turn off";
        why "Lo que enciende la antorcha no la apaga: quedaría encendida sobre los movimientos rápidos, o el corte se haría sin ella.",
            "What turns the torch on does not turn it off: it would stay on over rapid moves, or be off over the cut.";
        example book!("pipe-insert", "torch_off" = "M3");
    "P2007" TurnsTheOtherWay Stop { key: Key, number: u32, does: Text }
        es "{key} lleva M{number}, que {does} la salida del husillo"
        en "{key} holds M{number}, which turns the spindle output {does}"
        remedy "M3 y M4 van en torch_on, M5 en torch_off", "M3 and M4 belong into torch_on, M5 into torch_off";
        why "Con M3 y M4 la salida que enciende la antorcha queda puesta y con M5 se quita, en todos los controles que rodete escribe.",
            "M3 and M4 set the output that turns the torch on, and M5 clears it, on every control that rodete writes for.";
        example book!("pipe-insert", "torch_off" = "M4");
    "P2008" TorchOnAtEnd Stop { number: u32 }
        es "end_codes lleva M{number}, que enciende la antorcha"
        en "end_codes holds M{number}, which turns the torch on"
        remedy "escriba solo los códigos que acaban el programa, como M30", "write only codes that end the program, such as M30";
        why "La antorcha quedaría encendida y parada al acabar el programa.", "The torch would be left burning where it stands when the program ends.";
        example book!("pipe-insert", "end_codes" = "M3 M30");
    "P2109" KerfZero Caution {}
        es "kerf = 0: el corte no se compensa"
        en "kerf = 0: the cut is not compensated"
        remedy "escriba el ancho que corta la antorcha", "fill in the width that the torch cuts";
        why "Toda antorcha corta un ancho, y la mitad saldría de la pieza.", "Every torch cuts a width, and half of it would come off the part.";
        example book!("pipe-insert", "kerf" = "0");
    "P2119" OvercutPastTurn Stop { overcut: Size, round: Size }
        es "la salida de {overcut} da más de una vuelta: una vuelta son {round}"
        en "the overcut of {overcut} goes more than once round: one turn is {round}"
        remedy "elija una salida más corta", "choose a shorter overcut";
        why "La salida repasa el principio del corte.", "The overcut goes over the beginning of the cut again.";
        example book!("pipe-insert", "branch_size" = "1/2 in", "overcut" = "200");
    "P2130" FasterThanRapid Caution { axis: Text, near: Text, speed: Size, key: Key, rate: Size }
        es "el corte pide al eje {axis}{near} {speed}, más que su rápido: {key} = {rate}"
        en "the cut asks {speed} of axis {axis}{near}, more than its rapid rate: {key} = {rate}"
        remedy "compruebe {key}, y elija una F menor, o una F_max si el formulario la tiene", "check {key}, and choose a smaller F, or an F_max where the form has one";
        why "Ningún eje avanza más deprisa que en rápido: la máquina frenaría el corte o daría una alarma, y el chorro quemaría el borde.",
            "No axis feeds faster than at rapid: the machine would slow the cut or raise an alarm, and the jet would burn the edge.";
        example book!("pipe-insert", "mode" = "rotary", "G_rot" = "10");
}
