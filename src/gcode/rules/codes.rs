//! Findings about the codes that a workbook puts into programs.

use crate::finding::Key;
use crate::finding::rule::{book, rules};
use crate::text::Text;

rules! {
    /// The rows of machine codes and of the block that takes the tool away.
    RULES;

    "C1002" NoMachineCode Stop { key: Key, letter: char, number: u32 }
        es "{key} lleva {letter}{number}: aquí solo valen códigos M"
        en "{key} holds {letter}{number}: only M codes may stand here"
        remedy "quite el código G", "take the G code out";
        why "Un código G cambia cómo se leen los bloques que siguen, y el plan no cuenta con ello.",
            "A G code changes how the control reads the blocks after it, and the plan does not take that into account.";
        example book!("impeller", "start_codes" = "M3 G0");
    "C1003" MachineCodeNotKnown Stop { control: &'static str, number: u32, key: Key }
        es "el dialecto {control} no conoce M{number}"
        en "the dialect {control} does not know M{number}"
        remedy "quite M{number} de {key}, o elija el dialecto del control", "take M{number} out of {key}, or choose the control's dialect";
        why "El control se para en un código que no conoce y deja la pieza a medio hacer.",
            "The control stops at a code that it does not know and leaves the part half made.";
        example book!("impeller", "dialect" = "linuxcnc", "retract" = "");
    "C1004" EndsTooSoon Stop { key: Key, number: u32 }
        es "{key} lleva M{number}, que termina el programa"
        en "{key} holds M{number}, which ends the program"
        remedy "quite M{number}", "take M{number} out";
        why "Lo que sigue al final de un programa no se ejecuta.", "The control does not run what comes after the end of a program.";
        example book!("impeller", "start_codes" = "M30");
    "C1005" EndMissing Stop { key: Key }
        es "{key} no acaba con M2 ni M30: el programa no tendría final"
        en "{key} does not end with M2 or M30: the program would have no end"
        remedy "escriba M30 al final", "put M30 at the end";
        why "Sin un final, el control sigue con lo que haya después en su memoria o se para con un error.",
            "Without an end the control goes on into whatever follows in its memory, or stops with an error.";
        example book!("impeller", "end_codes" = "M5");
    "C1006" NotInRetract Stop { letter: char, number: u32, control: &'static str }
        es "retract lleva {letter}{number}: el dialecto {control} no lo admite ahí"
        en "retract holds {letter}{number}: the dialect {control} does not allow it there"
        remedy "escriba el bloque con el que su máquina sube Z, o deje la celda vacía y retire la herramienta a mano",
            "write the block that raises Z on your machine, or leave the cell empty and retract the tool by hand";
        why "El bloque solo debe subir Z: si cambia cómo se leen los demás o termina el programa, el plan deja de ser cierto.",
            "The block must only raise Z: a block that changes how the others are read, or that ends the program, would make the plan false.";
        example book!("impeller", "retract" = "G1 G53 Z0");
    "C1007" RetractWithoutZ Stop {}
        es "retract mueve ejes pero no Z: la herramienta no se retira de la pieza"
        en "retract moves axes but not Z: the tool does not leave the part"
        remedy "escriba solo Z en el bloque (G0 G53 Z0)", "write Z alone in the block (G0 G53 Z0)";
        why "La herramienta se movería de lado, a la altura a la que esté, y puede atravesar la pieza.",
            "The tool would move sideways at its present height and may go through the part.";
        example book!("impeller", "retract" = "G0 G53 X0");
    "C1008" RetractInProgram Stop {}
        es "retract mueve Z en coordenadas de programa, que valen para la punta de la fresa que va a cortar: en el husillo puede haber aún otra"
        en "retract moves Z in program coordinates, which hold for the tip of the tool that will cut: another one may still be in the spindle"
        remedy "escriba G53 en el bloque (G0 G53 Z0), o deje la celda vacía y retire la herramienta a mano",
            "write G53 in the block (G0 G53 Z0), or leave the cell empty and retract the tool by hand";
        why "La punta de una fresa más larga llega más abajo, quizá hasta la pieza.", "The tip of a longer cutter reaches lower, perhaps into the part.";
        example book!("impeller", "retract" = "G0 Z100");
    "C1009" SpindleCode Stop { key: Key, number: u32 }
        es "{key} lleva M{number}, que cambia el giro del husillo"
        en "{key} holds M{number}, which changes how the spindle turns"
        remedy "deje M3 o M4 en start_codes, uno de los dos, y ningún otro código del husillo en ninguna celda", "leave M3 or M4 in start_codes, one of the two, and no other spindle code in any cell";
        why "La fresa cortaría parada o girando al revés.", "The cutter would cut at a standstill or turning backwards.";
        example book!("impeller", "coolant" = "M5");
    "C1010" CodesRefused Stop { key: Key, why: Text }
        es "el control no admite los códigos de {key}: {why}"
        en "the control does not take the codes of {key}: {why}"
        remedy "deje en {key} solo códigos M que el control admita juntos en un bloque y sin más palabras", "keep in {key} only M codes that the control takes together in one block and without other words";
        why "Los códigos de la celda van juntos en un bloque del programa.", "The codes of the cell stand together in one block of the program.";
        example book!("pipe-insert", "torch_on" = "M62");
    "C1011" RetractRefused Stop { why: Text }
        es "el control no admite el bloque de retract: {why}"
        en "the control does not take the block of retract: {why}"
        remedy "escriba el bloque con el que su máquina sube Z en rápido, con G0, o deje la celda vacía y retire la herramienta a mano",
            "write the block that raises Z at rapid on your machine, with G0, or leave the cell empty and retract the tool by hand";
        why "El bloque va en el programa como está en la celda, y el control se para en lo que no admite.",
            "The block stands in the program as it stands in the cell, and the control stops at what it does not take.";
        example book!("impeller", "retract" = "G53 Z0");
}
