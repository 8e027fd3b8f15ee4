//! What is wrong with subprograms, loops and branches, and with the end of a program.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::{Text, t};

rules! {
    /// The rows of this file.
    RULES;

    "G0301" BlockNumbersTooMany Stop { most: usize }
        es "más de {most} números de bloque"
        en "more than {most} block numbers"
        remedy "divida el programa", "split the program";
        why "Cada número se guarda para poder ir a su bloque; más no caben.",
            "Each number is kept so that its block can be found; more are not held.";
        example Example::Never(t("haría falta un millón de bloques, cada uno con su número", "it would take a million blocks, each with a number of its own"));
    "G0302" BlockMissing Stop alarm Fanuc 78 { number: u32 }
        es "no hay bloque N{number}"
        en "there is no block N{number}"
        remedy "compruebe el número del bloque", "check the number of the block";
        why "La llamada no tiene adónde ir.",
            "The call has nowhere to go.";
        example Example::program("fanuc-lathe-a", "G21 G98|M97 P50|M30", "2:5");
    "G0303" BlockTwice Stop { number: u32 }
        es "N{number} está dos veces"
        en "N{number} stands twice"
        remedy "numere de nuevo uno de los dos bloques", "renumber one of the two blocks";
        why "Con el número dos veces no se sabe a qué bloque se va.",
            "With the number twice nothing says which block is meant.";
        example Example::program("fanuc-lathe-a", "G21 G98|M97 P50|M30|N50 G0 X40.|M99|N50 G0 X50.|M99", "2:5");
    "G0304" LabelMissing Stop {}
        es "falta la etiqueta detrás de O"
        en "the label after O is missing"
        remedy "dé un número o un <nombre>", "give a number or a <name>";
        why "Sin etiqueta no se sabe con qué otra palabra O hace pareja.",
            "Without a label nothing says which other O-word it belongs to.";
        example Example::program("linuxcnc", "G21 G90 F100|O SUB|M2", "2:3");
    "G0305" ClauseBehindElse Stop { label: String, word: String, first: String, line: usize }
        es "{label} {word} detrás del {first} de la línea {line}"
        en "{label} {word} behind the {first} of line {line}"
        remedy "ELSE va una sola vez y en último lugar; cierre con {label} ENDIF", "ELSE stands once and last; close with {label} ENDIF";
        why "Lo que va detrás de ELSE no se ejecutaría nunca.",
            "What stands behind ELSE would never be run.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 IF [1]|O1 ELSE|O1 ELSE|O1 ENDIF|M2", "4");
    "G0306" Stray Stop { label: String, word: String, home: &'static str, open: Text }
        es "{label} {word} fuera de {home}{open}"
        en "{label} {word} outside of {home}{open}"
        remedy "abra antes {label} {home}, o quítelo; lo que se abre dentro se cierra dentro", "open {label} {home} before it, or take it out; what opens inside closes inside";
        why "El control no sabe a dónde ir con una palabra que no está dentro de la suya.",
            "The control does not know where to go from a word that does not stand inside its own.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 ENDIF|M2", "2");
    "G0307" SubprogramInside Stop { label: String, around: String, word: String, line: usize, close: &'static str }
        es "subprograma {label} dentro de {around} {word} de la línea {line}"
        en "subprogram {label} inside {around} {word} of line {line}"
        remedy "cierre antes {around} con {close}", "close {around} before it with {close}";
        why "Un subprograma dentro de otra cosa se ejecutaría al pasar por él.",
            "A subprogram inside something else would be run in passing.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 IF [1]|O2 SUB|O2 ENDSUB|O1 ENDIF|M2", "3");
    "G0308" OWordsTooMany Stop { most: usize }
        es "más de {most} palabras O"
        en "more than {most} O-words"
        remedy "divida el programa", "split the program";
        why "Cada palabra se guarda para poder volver a ella; más no caben.",
            "Each word is kept so that it can be gone back to; more are not held.";
        example Example::Repeated { control: "linuxcnc", word: "O1 CALL|", times: 100_001 };
    "G0309" NotClosed Stop { label: String, word: String, close: &'static str }
        es "{label} {word} sin cerrar"
        en "{label} {word} is not closed"
        remedy "ciérrelo con {label} {close}", "close it with {label} {close}";
        why "Sin el cierre no se sabe hasta dónde llega.",
            "Without its end nothing says how far it goes.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 WHILE [0]|M2", "2");
    "G0310" LabelTwice Stop { label: String, line: usize }
        es "{label} está definido dos veces: también en la línea {line}"
        en "{label} is defined twice: in line {line} too"
        remedy "dé a uno de los dos otra etiqueta", "give one of the two another label";
        why "La llamada no sabría cuál de los dos se quiere.",
            "A call would not know which of the two is meant.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 SUB|O1 ENDSUB|O1 SUB|O1 ENDSUB|M2", "4");
    "G0311" WithoutCounterpart Stop {}
        es "palabra O sin pareja"
        en "O-word without its counterpart"
        remedy "compruebe los pares de palabras O", "check that the O-words pair up";
        why "Una etiqueta calculada no se encuentra antes de ejecutarla.",
            "A label that is computed cannot be found before it is run.";
        example Example::program("linuxcnc", "G21 G90 F100|O[1] ENDIF|M2", "2");
    "G0312" LabelNotWhole Stop { label: f64 }
        es "etiqueta O{label}"
        en "label O{label}"
        remedy "la etiqueta es un número entero", "the label is a whole number";
        why "Las etiquetas son números enteros o nombres.",
            "Labels are whole numbers or names.";
        example Example::program("linuxcnc", "G21 G90 F100|O[1.5] CALL|M2", "2:1");
    "G0313" OWordUnknown Stop {}
        es "palabra O desconocida"
        en "unknown O-word"
        remedy "use SUB, CALL, IF, WHILE, DO, REPEAT y sus cierres", "use SUB, CALL, IF, WHILE, DO, REPEAT and what closes them";
        why "El control no sabe qué hacer con ella.",
            "The control does not know what to do with it.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 JUMP|M2", "2:4");
    "G0314" BehindOWord Stop {}
        es "hay algo detrás de la palabra O"
        en "there is something after the O-word"
        remedy "escríbalo en otra línea", "write it on another line";
        why "Un bloque con una palabra O no ejecuta nada más.",
            "A block with an O-word runs nothing else.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 IF [1] G0 X1|O1 ENDIF|M2", "2:11");
    "G0315" ArgumentsTooMany Stop { most: usize }
        es "más de {most} argumentos"
        en "more than {most} arguments"
        remedy "use parámetros con nombre", "use named parameters";
        why "El subprograma solo recibe los parámetros locales.",
            "The subprogram receives the local parameters alone.";
        example Example::program("linuxcnc", "O1 SUB|O1 ENDSUB|O1 CALL [1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1]|M2", "3:99");
    "G0316" CallsTooDeep Stop { most: usize, stack: String }
        es "más de {most} llamadas una dentro de otra: {stack}"
        en "more than {most} calls inside one another: {stack}"
        remedy "llame a menos subprogramas uno dentro de otro, o ponga fin a la recursión con IF", "call fewer subprograms inside one another, or end the recursion with IF";
        why "El control guarda el camino de vuelta de pocas llamadas, y una recursión no acaba.",
            "The control holds the way back of few calls, and a recursion does not end.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 SUB|O1 CALL|O1 ENDSUB|O1 CALL|M2", "3");
    "G0317" SubprogramMissing Stop { label: String }
        es "no hay subprograma {label}"
        en "there is no subprogram {label}"
        remedy "defínalo en el programa, o en un archivo con su nombre en la misma carpeta", "define it in the program, or in a file of its name in the same folder";
        why "La llamada no tiene adónde ir.",
            "The call has nowhere to go.";
        example Example::program("linuxcnc", "G21 G90 F100|O5 CALL|M2", "2");
    "G0318" SubprogramOutside Stop { name: String }
        es "el subprograma «{name}» está fuera de la carpeta del programa"
        en "subprogram '{name}' lies outside of the program's folder"
        remedy "use un nombre sin ruta", "use a name without a path";
        why "Un programa no ha de leer archivos de otro sitio.",
            "A program is not to read files from elsewhere.";
        example Example::program("linuxcnc", "G21 G90 F100|O</etc/hole> CALL|M2", "2");
    "G0319" SubprogramUnreadable Stop { name: String, reason: String }
        es "no se puede leer el subprograma «{name}»: {reason}"
        en "cannot read subprogram '{name}': {reason}"
        remedy "compruebe el archivo", "check the file";
        why "Sin él no se sabe qué hace el programa.",
            "Without it nobody knows what the program does.";
        example Example::Never(t("falla el disco mientras se lee, no el texto", "a disk fails while it is read, not the text"));
    "G0320" SubprogramTooLarge Stop { name: String }
        es "el subprograma «{name}» tiene más de 16 MiB"
        en "subprogram '{name}' has more than 16 MiB"
        remedy "divídalo", "split it";
        why "Un subprograma se lee entero a la memoria.",
            "A subprogram is read into memory whole.";
        example Example::Never(t("haría falta un archivo de 16 MiB", "it would take a file of 16 MiB"));
    "G0321" NotCalled Stop { label: String }
        es "{label} no ha sido llamado con CALL"
        en "{label} was not called by CALL"
        remedy "un SUB se llama con CALL, un O a secas con M98", "a SUB is called by CALL, a bare O by M98";
        why "El final de un subprograma al que nadie ha llamado no tiene adónde volver.",
            "The end of a subprogram that nobody called has nowhere to go back to.";
        example Example::Program { control: "linuxcnc", program: "/O2 SUB|G21 G90|O2 ENDSUB|M2", at: "3", given: &[("--block-delete", "")] };
    "G0322" CallWithoutP Stop {}
        es "M98 sin P"
        en "M98 without P"
        remedy "dé el número del subprograma con P", "give the subprogram's number with P";
        why "No se sabe a qué subprograma se llama.",
            "Nothing says which subprogram is called.";
        example Example::program("linuxcnc", "G21 G90 F100|M98|M2", "2:1");
    "G0323" RepeatsTooMany Stop { repeats: f64, most: i64 }
        es "L{repeats} repeticiones"
        en "L{repeats} repeats"
        remedy "L va de 0 a {most}", "L goes from 0 to {most}";
        why "Tantas veces no se repite un subprograma: será un número equivocado.",
            "No subprogram is repeated that often: it will be a wrong number.";
        example Example::program("linuxcnc", "G21 G90 F100|M98 P1 L10000|M2|O1|M99", "2:8");
    "G0324" ProgramMissing Stop { number: String }
        es "no hay subprograma O{number}"
        en "there is no subprogram O{number}"
        remedy "defínalo detrás del programa, con su O y M99", "define it after the program, with its O and M99";
        why "La llamada no tiene adónde ir.",
            "The call has nowhere to go.";
        example Example::program("linuxcnc", "G21 G90 F100|M98 P5|M2", "2:5");
    "G0325" MainReturns Stop {}
        es "M99 en el programa principal lo repite sin fin"
        en "M99 in the main program repeats it without end"
        remedy "termine el programa con M30", "end the program with M30";
        why "El control empezaría otra vez, pieza tras pieza, sin parar.",
            "The control would begin again, part after part, without a stop.";
        example Example::program("fanuc-lathe-a", "G21 G98|G0 X40. Z2.|M99", "3");
    "G0326" ReturnInsideSub Stop {}
        es "M99 dentro de un SUB"
        en "M99 inside a SUB"
        remedy "un SUB termina con ENDSUB o RETURN", "a SUB ends with ENDSUB or RETURN";
        why "M99 vuelve de una llamada M98, y esta no lo era.",
            "M99 goes back from a call by M98, which this one was not.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 SUB|M99|O1 ENDSUB|O1 CALL|M2", "3:1");
    "G0327" CallWithWords Stop {}
        es "M98 o M99 con otras palabras en el bloque"
        en "M98 or M99 with other words in the block"
        remedy "escríbalas en otra línea", "write them on another line";
        why "Los controles no están de acuerdo en si se ejecutan antes o después de la llamada.",
            "Controls do not agree on whether they are run before the call or after it.";
        example Example::program("linuxcnc", "G21 G90 F100|M98 P1 X5|M2|O1|M99", "2:1");
    "G0328" BlockCallWithoutP Stop {}
        es "M97 sin P"
        en "M97 without P"
        remedy "dé el número de su primer bloque con P", "give the number of its first block with P";
        why "No se sabe a qué bloque se llama.",
            "Nothing says which block is called.";
        example Example::program("fanuc-lathe-a", "G21 G98|M97|M30", "2:1");
    "G0329" NotAProgramNumber Stop { number: f64 }
        es "P{number} no es un número de subprograma"
        en "P{number} is no subprogram number"
        remedy "dé un número entero", "give a whole number";
        why "Los subprogramas se llaman por su número, entero y mayor que 0.",
            "Subprograms are called by their number, whole and above 0.";
        example Example::program("fanuc-lathe-a", "G21 G98|M98 P0|M30", "2:5");
    "G0330" RepeatsTwice Stop { number: u32 }
        es "P{number} ya dice cuántas veces, y L también"
        en "P{number} says how often, and so does L"
        remedy "deje P con cuatro cifras, o quite L", "leave four digits in P, or take L out";
        why "P dice ya las veces con sus primeras cifras: los dos números pueden no ser el mismo.",
            "P says the times with its first digits already: the two numbers may differ.";
        example Example::program("fanuc-lathe-a", "G21 G98|M98 P30005 L2|M30", "2:5");
    "G0331" RepeatsOfP Stop { number: u32, repeats: i64, most: i64 }
        es "P{number}: {repeats} repeticiones"
        en "P{number}: {repeats} repeats"
        remedy "como mucho {most}", "at most {most}";
        why "Tantas veces no se repite un subprograma: será un número equivocado.",
            "No subprogram is repeated that often: it will be a wrong number.";
        example Example::program("fanuc-lathe-a", "G21 G98|M98 P990000007|M30", "2:5");
    "G0332" ProgramTwice Stop { number: String, places: String }
        es "O{number} está definido dos veces: {places}"
        en "O{number} is defined twice: {places}"
        remedy "deje uno de los dos", "leave one of the two";
        why "La llamada no sabría cuál de los dos se quiere.",
            "A call would not know which of the two is meant.";
        example Example::program("fanuc-lathe-a", "G21 G98|M98 P5|M30|O0005|M99|O0005|M99", "2:5");
    "G0333" ProgramNowhere Stop alarm Fanuc 78 { number: String }
        es "no hay subprograma O{number}"
        en "there is no subprogram O{number}"
        remedy "póngalo junto al programa, en un archivo O{number}.nc (de un libro, en una hoja O{number}), o detrás de M30", "put it beside the program, in a file O{number}.nc (of a workbook, on a sheet O{number}), or behind M30";
        why "La llamada no tiene adónde ir.",
            "The call has nowhere to go.";
        example Example::program("fanuc-lathe-a", "G21 G98|M98 P5|M30", "2:5");
    "G0334" FileOfAnother Stop { name: String, other: String, number: String }
        es "el archivo «{name}» contiene O{other}, no O{number}"
        en "the file '{name}' holds O{other}, not O{number}"
        remedy "corrija el número o el nombre del archivo", "correct the number or the file's name";
        why "El control llama por el número que lleva dentro, no por el nombre del archivo.",
            "The control calls by the number inside, not by the name of the file.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98|M98 P5|M30", at: "2:5", given: &[("O0005", "O0006|M99")] };
    "G0335" ByteOrderMark Note {}
        es "marca de orden de bytes (BOM) pasada por alto"
        en "byte order mark (BOM) passed over"
        remedy "", "";
        why "Algún control lee estos bytes como caracteres del primer bloque.",
            "Some controls read these bytes as characters of the first block.";
        example Example::program("linuxcnc", "﻿G21 G90|G0 X1|M2", "1");
    "G0336" EndsInSubprogram Stop {}
        es "el archivo termina dentro de un subprograma"
        en "the file ends inside a subprogram"
        remedy "termine el subprograma con ENDSUB o M99", "end the subprogram with ENDSUB or M99";
        why "El programa que llama no vuelve a ejecutarse.",
            "The program that calls is never gone back to.";
        example Example::program("linuxcnc", "G21 G90 F100|M98 P1|M2|O1|G0 X1", "5");
    "G0337" NoProgram Stop {}
        es "no hay programa: el archivo no tiene bloques, 0 movimientos"
        en "no program: the file has no block, 0 moves"
        remedy "compruebe que es el archivo correcto", "check that it is the right file";
        why "Un archivo vacío no mueve nada: será otro el que se quería.",
            "An empty file moves nothing: another will have been meant.";
        example Example::program("linuxcnc", "(a comment)", "1");
    "G0338" SubprogramsAlone Stop {}
        es "el programa termina sin M2 ni M30"
        en "the program ends without M2 or M30"
        remedy "si el archivo solo tiene subprogramas, compruebe el programa que los llama, con --subs; si no, añada M30", "where the file holds subprograms alone verify the program that calls them, with --subs; else add M30";
        why "El control se para al final con una alarma, o espera más bloques con el husillo en marcha.",
            "The control stops at the end with an alarm, or waits for more blocks with the spindle running.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 SUB|G0 X1|O1 ENDSUB", "4");
    "G0339" EndlessProgram Stop { most: u64 }
        es "el programa ha repetido más de {most} bloques"
        en "the program has repeated more than {most} blocks"
        remedy "compruebe las condiciones de sus bucles: puede que no terminen nunca", "check the conditions of its loops: they may never end";
        why "Un bucle que no acaba repite los movimientos hasta que alguien para la máquina.",
            "A loop that does not end repeats its motions until somebody stops the machine.";
        example Example::program("linuxcnc", "G21 G90 F100|#1=0|O1 WHILE [1]|#1=[#1+1]|O1 ENDWHILE|M2", "5");
    "G0340" NoEndOrPercent Stop {}
        es "el programa termina sin M2 ni M30"
        en "the program ends without M2 or M30"
        remedy "añada M30 o «%» al final", "add M30 or '%' at the end";
        why "El control se para al final con una alarma, o espera más bloques con el husillo en marcha.",
            "The control stops at the end with an alarm, or waits for more blocks with the spindle running.";
        example Example::program("linuxcnc", "%|G21 G90|G0 X1", "3");
    "G0341" NoEnd Stop {}
        es "el programa termina sin M2 ni M30"
        en "the program ends without M2 or M30"
        remedy "añada M30 al final", "add M30 at the end";
        why "El control se para al final con una alarma, o espera más bloques con el husillo en marcha.",
            "The control stops at the end with an alarm, or waits for more blocks with the spindle running.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X1", "2");
    "G0342" BlockNumberInvalid Stop {}
        es "número de bloque no válido"
        en "block number is not valid"
        remedy "escriba N y de una a nueve cifras", "write N and one to nine digits";
        why "El control no puede buscar un bloque por un número así.",
            "The control cannot look a block up by such a number.";
        example Example::program("linuxcnc", "G21 G90 F100|N-5 G0 X1|M2", "2:2");
    "G0343" ContourBlockMissing Stop alarm Fanuc 63 { number: u32 }
        es "no hay bloque N{number}"
        en "there is no block N{number}"
        remedy "compruebe el número del bloque", "check the number of the block";
        why "El ciclo no encuentra el contorno que ha de tornear.",
            "The cycle does not find the contour that it is to turn.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20 U1. W.1 F.2|N10 G0 X20.|M30", "4:9");
    "G0344" FollowingErrors Caution { count: u64, errors: Text, unknown: Text }
        es "{errors} de bloques rehusados, sin decir: desde aquí no se conoce {unknown}"
        en "{errors} from refused blocks, left out: from here on not known: {unknown}"
        remedy "corrija primero los bloques rehusados", "correct the refused blocks first";
        why "Un error que sale de otro se va con él.", "An error that comes of another one goes with it.";
        example Example::program("linuxcnc", "G21 G90 G80|G1 F100 X1,5|X2|M2", "2");
}
