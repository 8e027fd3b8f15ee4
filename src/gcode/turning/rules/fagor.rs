//! The rows of Fagor's turning cycles.

use crate::finding::rule::rules;
use crate::finding::{Example, Size};
use crate::text::Text;

rules! {
    /// The rows of this file.
    RULES;

    "G0670" FagorStepNotPositive Stop { letter: char }
        es "el paso {letter} no es mayor que 0"
        en "the step {letter} is not above 0"
        remedy "dé {letter} mayor que 0", "give {letter} above 0";
        why "Con un paso de 0 el ciclo no acabaría nunca.", "With a step of 0 the cycle would never end.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G81 X20 Z0 Q20 R-20 C0|M30", "3:1");
    "G0671" FagorStartInside Stop {}
        es "el ciclo no puede empezar aquí: la herramienta está dentro de la zona que se mecaniza"
        en "the cycle cannot start here: the tool is inside the material to cut"
        remedy "llame al ciclo desde fuera del bruto, más allá de los dos puntos del perfil y de la demasía",
            "call the cycle from outside the stock, beyond both points of the profile and the stock to leave";
        why "El ciclo empieza con un rápido desde la posición de la herramienta.", "The cycle starts with a rapid motion from the tool's position.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G81 X10 Z0 Q60 R-20 C5|M30", "3:1");
    "G0672" FagorNegative Stop { letter: &'static str }
        es "{letter} negativo en el ciclo"
        en "negative {letter} in the cycle"
        remedy "dé {letter} sin signo", "give {letter} without a sign";
        why "Estas palabras son magnitudes: el sentido lo dan los puntos.",
            "These words are magnitudes: the points give the direction.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G81 X20 Z0 Q20 R-20 C5 L-1|M30", "3:1");
    "G0673" FagorArcRadii Stop { near: Size, far: Size }
        es "el arco tiene dos radios: {near} al principio y {far} al final"
        en "the arc has two radii: {near} at its start and {far} at its end"
        remedy "mida I y K del punto inicial al centro; I en radios",
            "measure I and K from the initial point to the centre; I as a radius";
        why "Ningún círculo con ese centro pasa por los dos puntos.",
            "No circle with that centre passes through both points.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G85 X20 Z-10 Q0 R0 C1 I0 K1|M30", "3:1");
    "G0674" FagorArcHalf Stop {}
        es "el arco abarca 0 o 180 grados: no se sabe por qué lado va"
        en "the arc spans 0 or 180 degrees: it is not clear which way it goes"
        remedy "programe el arco en dos tramos", "program the arc in two parts";
        why "Los dos medios círculos tienen los mismos extremos y el mismo centro.",
            "Both half circles have the same ends and the same centre.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G84 X20 Z0 Q20 R-20 C1 I0 K-10|M30", "3:1");
    "G0675" FagorArcTurnsBack Stop {}
        es "el arco cambia de sentido en un eje: pasa de un cuadrante de su círculo a otro"
        en "the arc reverses along an axis: it passes from one quadrant of its circle into another"
        remedy "programe un ciclo por cuadrante", "program one cycle per quadrant";
        why "Las pasadas solo pueden ir en un sentido en cada eje.", "The passes can go only one way along each axis.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G84 X10 Z0 Q10 R-16 C1 I6 K-8|M30", "3:1");
    "G0676" TooManyFagorPasses Stop { passes: Size, most: f64 }
        es "el ciclo pide {passes} pasadas; el límite es {most}"
        en "the cycle asks for {passes} passes; the limit is {most}"
        remedy "aumente C", "increase C";
        why "Tantas pasadas suelen venir de un C en otra unidad.", "So many passes usually come from a C in another unit.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G81 X20 Z0 Q20 R-20 C0.0001|M30", "3:1");
    "G0677" FagorGrooveWithoutDepth Stop {}
        es "la ranura tiene profundidad 0"
        en "the groove has depth 0"
        remedy "dé el fondo con Q (G88) o R (G89)", "give the bottom with Q (G88) or R (G89)";
        why "Sin profundidad la herramienta no corta.", "Without a depth the tool does not cut.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G88 X30 Z-5 Q30 R-9 C2 D1|M30", "3:1");
    "G0678" FagorGrooveNegative Stop {}
        es "D o K negativo en el ranurado"
        en "negative D or K in the grooving"
        remedy "dé D y K sin signo", "give D and K without a sign";
        why "D es una distancia y K un tiempo.", "D is a distance and K is a time.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G88 X30 Z-5 Q20 R-9 C2 D1 K-1|M30", "3:1");
    "G0679" FagorThreadWithoutDepth Stop {}
        es "la rosca tiene profundidad 0"
        en "the thread has depth 0"
        remedy "dé I distinto de 0", "give an I other than 0";
        why "La profundidad determina todas las pasadas.", "The depth determines all the passes.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G86 X40 Z0 Q40 R-20 I0 B1 D3 C2 A0|M30", "3:1");
    "G0680" FagorThreadLastPass Stop {}
        es "E es negativo o L no es menor que la profundidad I"
        en "E is negative, or L is not below the depth I"
        remedy "dé E sin signo y L menor que I", "give E without a sign and L below I";
        why "La última pasada no puede ser más honda que la rosca.", "The last pass cannot be deeper than the thread.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G86 X40 Z0 Q40 R-20 I1 B1 D3 C2 L2 A0|M30", "3:1");
    "G0681" TooManyFagorThreadPasses Stop { passes: Size, most: f64 }
        es "el ciclo pide {passes} pasadas; el límite es {most}"
        en "the cycle asks for {passes} passes; the limit is {most}"
        remedy "aumente B o E", "increase B or E";
        why "Tantas pasadas suelen venir de un B en otra unidad.", "So many passes usually come from a B in another unit.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G86 X40 Z0 Q40 R-20 I1 B0.0001 D3 C2 A0|M30", "3:1");
    "G0682" FagorThreadWithoutLead Stop {}
        es "la rosca tiene paso 0"
        en "the thread has lead 0"
        remedy "dé el paso con C", "give the lead with C";
        why "Sin paso la herramienta no avanza.", "Without a lead the tool does not advance.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G86 X40 Z0 Q40 R-20 I1 B1 D3 C0 A0|M30", "3:1");
    "G0683" FagorThreadExit Stop {}
        es "J es negativo o el ángulo A no es menor que 90 grados"
        en "J is negative, or the angle A is not below 90 degrees"
        remedy "dé J sin signo y A menor que 90", "give J without a sign and A below 90";
        why "La salida es una distancia, y a 90 grados la herramienta no penetra nunca.",
            "The run-out is a distance, and at 90 degrees the tool never goes in.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G86 X40 Z0 Q40 R-20 I1 B1 D3 C2 A90|M30", "3:1");
    "G0684" FagorThreadTooShort Stop {}
        es "la rosca es más corta que su salida más la penetración por el flanco"
        en "the thread is shorter than its run-out plus the infeed along the flank"
        remedy "alargue la rosca o reduzca J", "make the thread longer or J shorter";
        why "La herramienta saldría antes de haber entrado.", "The tool would pull out before it has gone in.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G86 X40 Z0 Q40 R-2 I1 B1 D3 C2 J3|M30", "3:1");
    "G0685" FagorHoleWithoutDepth Stop {}
        es "el agujero tiene profundidad 0"
        en "the hole has depth 0"
        remedy "dé I, positivo hacia -Z", "give I, positive towards -Z";
        why "Sin profundidad la broca no corta.", "Without a depth the drill does not cut.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G83 X0 Z0 I0 B5 D1|M30", "3:1");
    "G0686" FagorDrillNegative Stop { letter: char }
        es "{letter} negativo en G83"
        en "negative {letter} in G83"
        remedy "dé {letter} sin signo", "give {letter} without a sign";
        why "Estas palabras son magnitudes: el sentido lo da I.", "These words are magnitudes: I gives the direction.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G83 X0 Z0 I10 B-5 D1|M30", "3:1");
    "G0687" FagorDrillFactor Stop {}
        es "el factor R de G83 no está entre 0 y 1"
        en "the factor R of G83 is not between 0 and 1"
        remedy "dé R mayor que 0 y hasta 1", "give R above 0 and up to 1";
        why "Cada penetración es R veces la anterior: con más de 1 crecerían.",
            "Each peck is R times the one before: above 1 they would grow.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G83 X0 Z0 I10 B5 D1 R2|M30", "3:1");
    "G0688" TooManyFagorDrillSteps Stop { passes: Size, most: f64 }
        es "el ciclo pide {passes} pasadas; el límite es {most}"
        en "the cycle asks for {passes} passes; the limit is {most}"
        remedy "aumente B, R o L", "increase B, R or L";
        why "Con un factor pequeño y sin L las penetraciones se hacen tan cortas que no llegan al fondo.",
            "With a small factor and no L the pecks become so short that they never reach the bottom.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G83 X0 Z0 I10 B5 D1 R0.1|M30", "3:1");
    "G0690" FagorLetterNotSupported Stop { letter: char, number: u8 }
        es "{letter} en G{number} no está implementado"
        en "{letter} in G{number} is not supported"
        remedy "quite {letter}, o escriba los movimientos sin el ciclo",
            "take {letter} out, or write the motions without the cycle";
        why "rodete no simula lo que la letra cambia en los movimientos.",
            "rodete does not simulate what this letter changes in the motions.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G81 X20 Z0 Q20 R-20 C5 A1|M30", "3:24");
    "G0691" FagorTapping Stop { letter: char }
        es "{letter} en G83 con B0 (roscado con macho) no está implementado"
        en "{letter} in G83 with B0 (tapping) is not supported"
        remedy "quite {letter}", "take {letter} out";
        why "Con B0 el ciclo rosca con macho, y esta palabra significa otra cosa.",
            "With B0 the cycle taps, and this word means something else.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G83 X0 Z0 I10 B0 D1 H3|M30", "3:21");
    "G0692" FagorGroovePoint Caution { number: u8 }
        es "G{number}: rodete recorre la ranura con el punto programado; el control resta el ancho de la herramienta de ranurar"
        en "G{number}: rodete moves the programmed point along the groove; the control subtracts the width of the grooving tool"
        remedy "compruebe el ancho de la herramienta de ranurar (NOSEW) en la tabla del control",
            "check the width of the grooving tool (NOSEW) in the control's table";
        why "El ancho de la herramienta de ranurar está en la tabla del control, no en el programa.",
            "The width of the grooving tool is in the control's table, not in the program.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G88 X30 Z-5 Q20 R-9 C2 D1|M30", "3:1");
    "G0693" FagorLetterMissing Stop { letter: char, number: u8 }
        es "falta {letter} en G{number}"
        en "{letter} is missing in G{number}"
        remedy "dé {letter} en el bloque", "give {letter} in the block";
        why "El control da una alarma si falta la palabra.", "The control raises an alarm if the word is missing.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G81 X20 Z0 Q20 R-20|M30", "3:1");
    "G0694" FagorGrooveStepMissing Stop { number: u8 }
        es "falta C en G{number}"
        en "C is missing in G{number}"
        remedy "añada C: sin ella el control usa el ancho de la herramienta de ranurar, que no está en el programa",
            "add C: without it the control uses the width of the grooving tool, which is not in the program";
        why "El ancho de la herramienta de ranurar está en la tabla del control.",
            "The width of the grooving tool is in the control's table.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G88 X30 Z-5 Q20 R-9 D1|M30", "3:1");
    "G0695" FagorTaps Caution { with: Text }
        es "G83 con B0 rosca con macho{with}: entra hasta el fondo y sale con avance, sin sacar la viruta"
        en "G83 with B0 taps{with}: it goes to the bottom and comes back at feed, and clears no chips"
        remedy "si es una broca, dé en B la profundidad de cada penetración",
            "if the tool is a drill, give the depth of each peck in B";
        why "Una B que ha perdido una cifra convierte un taladrado en un roscado: la broca se atasca y se rompe.",
            "A B that has lost a digit turns drilling into tapping: the drill jams and breaks.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G83 X0 Z0 I10 B0 D1|M30", "3:15");
}
