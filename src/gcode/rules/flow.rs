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
        why "rodete guarda cada número para encontrar su bloque, y no guarda más de estos.",
            "rodete keeps each number to find its block again, and keeps no more than these.";
        example Example::Made { key: "program-many-numbers", how: t("un millón de bloques y uno más, cada uno con su número, y una llamada a uno de ellos", "a million blocks and one more, each with a number of its own, and a call of one of them") };
    "G0302" BlockMissing Stop alarm Fanuc 78 { number: u32 }
        es "no hay bloque N{number}"
        en "there is no block N{number}"
        remedy "compruebe el número del bloque", "check the number of the block";
        why "El control no encuentra a qué llamar.",
            "The control finds nothing to call.";
        example Example::program("fanuc-lathe-a", "G21 G98|M97 P50|M30", "2:5");
    "G0303" BlockTwice Stop { number: u32 }
        es "hay dos bloques con el número N{number}"
        en "two blocks have the number N{number}"
        remedy "numere de nuevo uno de los dos bloques", "renumber one of the two blocks";
        why "No se sabe a cuál de los dos bloques se va.",
            "It is not clear which of the two blocks is meant.";
        example Example::program("fanuc-lathe-a", "G21 G98|M97 P50|M30|N50 G0 X40.|M99|N50 G0 X50.|M99", "2:5");
    "G0304" LabelMissing Stop {}
        es "falta la etiqueta después de O"
        en "the label after O is missing"
        remedy "dé un número o un <nombre>", "give a number or a <name>";
        why "Sin etiqueta no se sabe con qué otra palabra O hace pareja.",
            "Without a label it is not clear which other O-word it belongs to.";
        example Example::program("linuxcnc", "G21 G90 F100|O SUB|M2", "2:3");
    "G0305" ClauseBehindElse Stop { label: String, word: String, first: String, line: usize }
        es "{label} {word} después del {first} de la línea {line}"
        en "{label} {word} after the {first} of line {line}"
        remedy "use ELSE una sola vez y en último lugar; cierre con {label} ENDIF", "use ELSE once, as the last clause; close with {label} ENDIF";
        why "Una cláusula después de ELSE no se ejecutaría nunca.",
            "A clause after ELSE would never run.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 IF [1]|O1 ELSE|O1 ELSE|O1 ENDIF|M2", "4");
    "G0306" Stray Stop { label: String, word: String, home: &'static str, open: Text }
        es "{label} {word} fuera de {home}{open}"
        en "{label} {word} outside {home}{open}"
        remedy "abra antes {label} {home}, o bórrelo; cierre dentro lo que abra dentro", "open {label} {home} before it, or delete it; close inside what you open inside";
        why "El control no sabe por dónde seguir desde una palabra que está fuera de su estructura.",
            "The control does not know where to continue from a word outside its own structure.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 ENDIF|M2", "2");
    "G0307" SubprogramInside Stop { label: String, around: String, word: String, line: usize, close: &'static str }
        es "subprograma {label} dentro de {around} {word} de la línea {line}"
        en "subprogram {label} inside {around} {word} of line {line}"
        remedy "cierre antes {around} con {close}", "close {around} before it with {close}";
        why "El control ejecutaría el subprograma al pasar por él, sin ninguna llamada.",
            "The control would run the subprogram when it passes through, without a call.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 IF [1]|O2 SUB|O2 ENDSUB|O1 ENDIF|M2", "3");
    "G0308" OWordsTooMany Stop { most: usize }
        es "más de {most} palabras O"
        en "more than {most} O-words"
        remedy "divida el programa", "split the program";
        why "rodete guarda cada palabra para volver a ella, y no guarda más de estas.",
            "rodete keeps each word to find it again, and keeps no more than these.";
        example Example::Repeated { control: "linuxcnc", word: "O1 CALL|", times: 100_001 };
    "G0309" NotClosed Stop { label: String, word: String, close: &'static str }
        es "{label} {word} sin cerrar"
        en "{label} {word} is not closed"
        remedy "ciérrelo con {label} {close}", "close it with {label} {close}";
        why "Sin la palabra de cierre no se sabe hasta dónde llega.",
            "Without the closing word it is not clear how far it goes.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 WHILE [0]|M2", "2");
    "G0310" LabelTwice Stop { label: String, line: usize }
        es "{label} está definido dos veces: también en la línea {line}"
        en "{label} is defined twice: in line {line} too"
        remedy "dé a uno de los dos otra etiqueta", "give one of the two another label";
        why "No se sabe a cuál de los dos se llama.",
            "It is not clear which of the two a call means.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 SUB|O1 ENDSUB|O1 SUB|O1 ENDSUB|M2", "4");
    "G0311" WithoutCounterpart Stop {}
        es "palabra O sin pareja"
        en "O-word without its partner"
        remedy "escriba la etiqueta con un número o un <nombre>, igual en cada palabra O de la pareja", "write the label as a number or a <name>, the same in each O-word of the pair";
        why "Una etiqueta calculada no se puede emparejar antes de ejecutar el bloque.",
            "A computed label cannot be matched before the block runs.";
        example Example::program("linuxcnc", "G21 G90 F100|O#1 ENDIF|M2", "2");
    "G0312" LabelNotWhole Stop { label: f64 }
        es "O{label} no es una etiqueta"
        en "O{label} is not a label"
        remedy "use un número entero como etiqueta", "use a whole number as the label";
        why "Las etiquetas son números enteros o nombres.",
            "Labels are whole numbers or names.";
        example Example::program("linuxcnc", "G21 G90 F100|O[1.5] CALL|M2", "2:1");
    "G0313" OWordUnknown Stop {}
        es "palabra O desconocida"
        en "unknown O-word"
        remedy "use SUB, CALL, IF, WHILE, DO, REPEAT y sus cierres", "use SUB, CALL, IF, WHILE, DO, REPEAT and their closing words";
        why "El control no sabe qué hacer con ella.",
            "The control does not know what to do with it.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 JUMP|M2", "2:4");
    "G0314" BehindOWord Stop {}
        es "hay más texto después de la palabra O"
        en "there is more text after the O-word"
        remedy "escríbalo en otra línea", "write it on another line";
        why "En un bloque con una palabra O el control no ejecuta nada más.",
            "In a block with an O-word the control runs nothing else.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 IF [1] G0 X1|O1 ENDIF|M2", "2:11");
    "G0315" ArgumentsTooMany Stop { most: usize }
        es "más de {most} argumentos"
        en "more than {most} arguments"
        remedy "use parámetros con nombre", "use named parameters";
        why "Un subprograma solo recibe sus parámetros locales.",
            "A subprogram receives only its local parameters.";
        example Example::program("linuxcnc", "O1 SUB|O1 ENDSUB|O1 CALL [1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1]|M2", "3:99");
    "G0316" CallsTooDeep Stop { most: usize, stack: String }
        es "más de {most} llamadas anidadas: {stack}"
        en "more than {most} nested calls: {stack}"
        remedy "anide menos llamadas, o acabe la recursión con IF", "nest fewer calls, or end the recursion with IF";
        why "El control admite pocas llamadas anidadas, y una recursión puede no acabar.",
            "The control allows few nested calls, and this recursion does not end.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 SUB|O1 CALL|O1 ENDSUB|O1 CALL|M2", "3");
    "G0317" SubprogramMissing Stop { label: String }
        es "no hay subprograma {label}"
        en "there is no subprogram {label}"
        remedy "defínalo en el programa, o en un archivo con ese nombre en la misma carpeta", "define it in the program, or in a file with that name in the same folder";
        why "El control no encuentra a qué llamar.",
            "The control finds nothing to call.";
        example Example::program("linuxcnc", "G21 G90 F100|O5 CALL|M2", "2");
    "G0318" SubprogramOutside Stop { name: String }
        es "el subprograma «{name}» está fuera de la carpeta del programa"
        en "subprogram '{name}' is outside the program's folder"
        remedy "use un nombre sin ruta", "use a name without a path";
        why "Un programa no debe leer archivos de otras carpetas.",
            "A program must not read files from other folders.";
        example Example::program("linuxcnc", "G21 G90 F100|O</etc/hole> CALL|M2", "2");
    "G0319" SubprogramUnreadable Stop { name: String, reason: Text }
        es "no se puede leer el subprograma «{name}»: {reason}"
        en "cannot read subprogram '{name}': {reason}"
        remedy "compruebe el archivo", "check the file";
        why "Sin el subprograma no se sabe qué hace el programa.",
            "Without the subprogram nobody knows what the program does.";
        example Example::Made { key: "program-subprogram-unreadable", how: t("un disco que falla mientras se lee el subprograma", "a disk that fails while the subprogram is read") };
    "G0320" SubprogramTooLarge Stop { name: String }
        es "el subprograma «{name}» ocupa más de 16 MiB"
        en "subprogram '{name}' is larger than 16 MiB"
        remedy "divídalo", "split it";
        why "rodete lee el subprograma entero en memoria.",
            "rodete reads a whole subprogram into memory.";
        example Example::Made { key: "program-subprogram-large", how: t("un subprograma en un archivo de más de 16 MiB", "a subprogram in a file of more than 16 MiB") };
    "G0321" NotCalled Stop { label: String }
        es "{label} no ha sido llamado con CALL"
        en "{label} was not called with CALL"
        remedy "llame a un SUB con CALL, y a un O a secas con M98", "call a SUB with CALL, and a bare O with M98";
        why "Un subprograma al que nadie ha llamado no tiene adónde volver.",
            "A subprogram that was not called has nowhere to return to.";
        example Example::Program { control: "linuxcnc", program: "/O2 SUB|G21 G90|O2 ENDSUB|M2", at: "3", given: &[("--block-delete", "")] };
    "G0322" CallWithoutP Stop {}
        es "M98 sin P"
        en "M98 without P"
        remedy "dé el número del subprograma con P", "give the subprogram's number with P";
        why "No se sabe a qué subprograma se llama.",
            "It is not clear which subprogram is called.";
        example Example::program("linuxcnc", "G21 G90 F100|M98|M2", "2:1");
    "G0323" RepeatsTooMany Stop { repeats: f64, most: i64 }
        es "L{repeats} no es un número de repeticiones"
        en "L{repeats} is not a number of repeats"
        remedy "L va de 0 a {most}", "L goes from 0 to {most}";
        why "Ningún subprograma se repite tantas veces: el número será erróneo.",
            "No subprogram repeats that often: the number is probably wrong.";
        example Example::program("linuxcnc", "G21 G90 F100|M98 P1 L10000|M2|O1|M99", "2:8");
    "G0324" ProgramMissing Stop { number: String }
        es "no hay subprograma O{number}"
        en "there is no subprogram O{number}"
        remedy "defínalo después del programa, con su O y M99, o, en LinuxCNC, en un archivo con ese número en la misma carpeta",
            "define it after the program, with its O and M99, or, on LinuxCNC, in a file with that number in the same folder";
        why "El control no encuentra a qué llamar.",
            "The control finds nothing to call.";
        example Example::program("linuxcnc", "G21 G90 F100|M98 P5|M2", "2:5");
    "G0325" MainReturns Stop {}
        es "M99 en el programa principal lo repite sin fin"
        en "M99 in the main program repeats it forever"
        remedy "termine el programa con M30", "end the program with M30";
        why "El control empezaría otra vez, pieza tras pieza, sin parar.",
            "The control would start again, part after part, without stopping.";
        example Example::program("fanuc-lathe-a", "G21 G98|G0 X40. Z2.|M99", "3");
    "G0345" MainJumps Stop { block: u32 }
        es "M99 P{block} en el programa principal salta al bloque N{block}: rodete no sigue el salto"
        en "M99 P{block} in the main program jumps to block N{block}: rodete does not follow the jump"
        remedy "ponga los bloques en el orden en que se ejecutan, y termine el programa con M30",
            "put the blocks in the order in which they run, and end the program with M30";
        why "El control sigue en ese bloque; si está antes, los repite sin fin.",
            "The control goes on at that block; if it stands before, the blocks repeat forever.";
        example Example::program("fanuc-lathe-a", "G21 G98|G0 X40. Z2.|M99 P60|N60 G0 X100.|M30", "3:5");
    "G0326" ReturnInsideSub Stop {}
        es "M99 dentro de un SUB"
        en "M99 inside a SUB"
        remedy "un SUB termina con ENDSUB o RETURN", "a SUB ends with ENDSUB or RETURN";
        why "M99 vuelve de una llamada con M98; a este subprograma se le llamó con CALL.",
            "M99 returns from a call with M98; this subprogram was called with CALL.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 SUB|M99|O1 ENDSUB|O1 CALL|M2", "3:1");
    "G0327" CallWithWords Stop {}
        es "M98 o M99 con otras palabras en el bloque"
        en "M98 or M99 with other words in the block"
        remedy "escríbalas en otra línea", "write them on another line";
        why "Unos controles las ejecutan antes de la llamada y otros después.",
            "Some controls run them before the call, others after it.";
        example Example::program("linuxcnc", "G21 G90 F100|M98 P1 X5|M2|O1|M99", "2:1");
    "G0328" BlockCallWithoutP Stop {}
        es "M97 sin P"
        en "M97 without P"
        remedy "dé el número de su primer bloque con P", "give the number of its first block with P";
        why "No se sabe a qué bloque se llama.",
            "It is not clear which block is called.";
        example Example::program("fanuc-lathe-a", "G21 G98|M97|M30", "2:1");
    "G0329" NotAProgramNumber Stop { number: f64 }
        es "P{number} no es un número de subprograma"
        en "P{number} is not a subprogram number"
        remedy "dé un número entero", "give a whole number";
        why "El número de un subprograma es entero y mayor que 0.",
            "A subprogram number is a whole number above 0.";
        example Example::program("fanuc-lathe-a", "G21 G98|M98 P0|M30", "2:5");
    "G0330" RepeatsTwice Stop { number: u32 }
        es "P{number} y L dan los dos un número de repeticiones"
        en "P{number} and L both give a number of repeats"
        remedy "escriba P con cuatro cifras, o quite L", "write P with four digits, or delete L";
        why "Las primeras cifras de P ya dan las repeticiones: los dos números pueden no coincidir.",
            "The first digits of P already give the repeats: the two numbers may differ.";
        example Example::program("fanuc-lathe-a", "G21 G98|M98 P30005 L2|M30", "2:5");
    "G0331" RepeatsOfP Stop { number: u32, repeats: i64, most: i64 }
        es "P{number} pide {repeats} repeticiones"
        en "P{number} asks for {repeats} repeats"
        remedy "use como mucho {most}", "use at most {most}";
        why "Ningún subprograma se repite tantas veces: el número será erróneo.",
            "No subprogram repeats that often: the number is probably wrong.";
        example Example::program("fanuc-lathe-a", "G21 G98|M98 P990000007|M30", "2:5");
    "G0332" ProgramTwice Stop { number: String, places: String }
        es "O{number} está definido dos veces: {places}"
        en "O{number} is defined twice: {places}"
        remedy "borre uno de los dos", "delete one of the two";
        why "No se sabe a cuál de los dos se llama.",
            "It is not clear which of the two a call means.";
        example Example::program("fanuc-lathe-a", "G21 G98|M98 P5|M30|O0005|M99|O0005|M99", "2:5");
    "G0333" ProgramNowhere Stop alarm Fanuc 78 { number: String }
        es "no hay subprograma O{number}"
        en "there is no subprogram O{number}"
        remedy "póngalo en un archivo O{number}.nc junto al programa (en un libro: en una hoja O{number}), o después de M30", "put it in a file O{number}.nc beside the program (in a workbook: on a sheet O{number}), or after M30";
        why "El control no encuentra a qué llamar.",
            "The control finds nothing to call.";
        example Example::program("fanuc-lathe-a", "G21 G98|M98 P5|M30", "2:5");
    "G0334" FileOfAnother Stop { name: String, other: String, number: String }
        es "el archivo «{name}» contiene O{other}, no O{number}"
        en "the file '{name}' holds O{other}, not O{number}"
        remedy "corrija el número o el nombre del archivo", "correct the number or the file's name";
        why "El control busca el número que hay dentro del archivo, no el nombre del archivo.",
            "The control looks for the number inside the file, not for the file's name.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98|M98 P5|M30", at: "2:5", given: &[("O0005", "O0006|M99")] };
    "G0335" ByteOrderMark Note {}
        es "marca de orden de bytes (BOM) omitida"
        en "byte order mark (BOM) skipped"
        remedy "", "";
        why "Algún control lee estos bytes como caracteres del primer bloque.",
            "Some controls read these bytes as characters of the first block.";
        example Example::program("fanuc-lathe-a", "﻿G21 G98|G0 X40. Z2.|M30", "1");
    "G0336" EndsInSubprogram Stop {}
        es "el archivo termina dentro de un subprograma"
        en "the file ends inside a subprogram"
        remedy "termine el subprograma con ENDSUB o M99", "end the subprogram with ENDSUB or M99";
        why "El control no vuelve nunca al programa que llama.",
            "The control never returns to the calling program.";
        example Example::program("linuxcnc", "G21 G90 F100|M98 P1|M2|O1|G0 X1", "5");
    "G0337" NoProgram Stop {}
        es "no hay programa: el archivo no tiene bloques"
        en "no program: the file has no blocks"
        remedy "compruebe que es el archivo correcto", "check that it is the right file";
        why "Un archivo vacío no mueve nada: será el archivo equivocado.",
            "An empty file moves nothing: it is probably the wrong file.";
        example Example::program("linuxcnc", "(a comment)", "1");
    "G0338" SubprogramsAlone Stop {}
        es "el programa termina sin M2 ni M30"
        en "the program ends without M2 or M30"
        remedy "si el archivo solo tiene subprogramas, compruebe el programa que los llama, con --subs; si no, añada M30", "if the file holds only subprograms, verify the program that calls them, with --subs; if not, add M30";
        why "Al final el control se para con una alarma, o espera más bloques con el husillo en marcha.",
            "At the end the control stops with an alarm, or waits for more blocks with the spindle running.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 SUB|G0 X1|O1 ENDSUB", "4");
    "G0339" EndlessProgram Stop { most: u64 }
        es "el programa ha repetido más de {most} bloques"
        en "the program has repeated more than {most} blocks"
        remedy "compruebe las condiciones de sus bucles: puede que no terminen nunca", "check the conditions of its loops: they may never end";
        why "Un bucle sin fin repite los movimientos hasta que alguien para la máquina.",
            "An endless loop repeats its motions until somebody stops the machine.";
        example Example::program("linuxcnc", "G21 G90 F100|#1=0|O1 WHILE [1]|#1=[#1+1]|O1 ENDWHILE|M2", "5");
    "G0340" NoEndOrPercent Stop {}
        es "el programa termina sin M2 ni M30"
        en "the program ends without M2 or M30"
        remedy "añada M30 o «%» al final", "add M30 or '%' at the end";
        why "Al final el control se para con una alarma, o espera más bloques con el husillo en marcha.",
            "At the end the control stops with an alarm, or waits for more blocks with the spindle running.";
        example Example::program("linuxcnc", "%|G21 G90|G0 X1", "3");
    "G0341" NoEnd Stop {}
        es "el programa termina sin M2 ni M30"
        en "the program ends without M2 or M30"
        remedy "compruebe que el programa completo está en el archivo; si lo está, añada M30 al final", "check that the whole program is in the file; if it is, add M30 at the end";
        why "Al final el control se para con una alarma, o espera más bloques con el husillo en marcha.",
            "At the end the control stops with an alarm, or waits for more blocks with the spindle running.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X1", "2");
    "G0342" BlockNumberInvalid Stop {}
        es "número de bloque no válido"
        en "invalid block number"
        remedy "escriba N y de una a nueve cifras", "write N and one to nine digits";
        why "El control no puede encontrar un bloque por un número así.",
            "The control cannot find a block by such a number.";
        example Example::program("linuxcnc", "G21 G90 F100|N-5 G0 X1|M2", "2:2");
    "G0343" ContourBlockMissing Stop alarm Fanuc 63 { number: u32 }
        es "no hay bloque N{number}"
        en "there is no block N{number}"
        remedy "compruebe el número del bloque", "check the number of the block";
        why "El ciclo no encuentra el contorno que debe tornear.",
            "The cycle does not find the contour to turn.";
        example Example::program("fanuc-lathe-a", "S500 M3 F.2|G0 X50. Z5.|G71 U2. R1.|G71 P10 Q20 U1. W.1 F.2|N10 G0 X20.|M30", "4:9");
    "G0344" FollowingErrors Caution { count: u64, errors: Text, unknown: Text }
        es "{errors} sin listar, debidos a bloques rechazados; desde aquí no se conoce {unknown}"
        en "{errors} omitted, caused by rejected blocks; unknown from here on: {unknown}"
        remedy "corrija primero los bloques rechazados", "correct the rejected blocks first";
        why "Un error que viene de otro desaparece con él.", "An error caused by another one disappears with it.";
        example Example::program("linuxcnc", "G21 G90 G80|G1 F100 X1,5|X2|M2", "2");
    "G0346" LabelReused Stop { label: String, word: String, line: usize }
        es "{label} {word} usa otra vez la etiqueta de la línea {line}"
        en "{label} {word} uses the label of line {line} again"
        remedy "dé a cada IF, WHILE, DO y REPEAT una etiqueta propia", "give each IF, WHILE, DO and REPEAT a label of its own";
        why "El control recuerda las etiquetas del programa y las de cada subprograma: ante una repetida puede pararse, o volver al primer DO.",
            "The control remembers the labels of the program and of each subprogram: at one used again it may stop, or go back to the first DO.";
        example Example::program("linuxcnc", "G21 G90 F100|O7 IF [1]|O7 ENDIF|O7 IF [1]|O7 ENDIF|M2", "4");
    "G0347" SubprogramBefore Stop { label: String, line: usize }
        es "{label} está antes de la llamada, en la línea {line}, y el control aún no lo conoce"
        en "{label} is before the call, in line {line}, and the control does not know of it yet"
        remedy "póngalo después del subprograma que lo llama, o los SUB al principio del programa", "put it after the subprogram that calls it, or put the SUBs at the beginning of the program";
        why "El control busca desde la llamada hasta el final, y solo vuelve atrás a un subprograma que ya ha encontrado.",
            "The control searches from the call to the end, and goes back only to a subprogram that it has met already.";
        example Example::program("linuxcnc", "G21 G90 F100|M98 P2|M2|O1|M99|O2|M98 P1|M99", "7");
    "G0348" ByteOrderMarkRejected Stop {}
        es "el archivo empieza con una marca de orden de bytes (BOM)"
        en "the file begins with a byte order mark (BOM)"
        remedy "guárdelo como texto ASCII o UTF-8 sin BOM", "save it as ASCII or UTF-8 text without a BOM";
        why "El control no conoce estos caracteres y se para en la primera línea.",
            "The control does not know these characters and stops at the first line.";
        example Example::program("linuxcnc", "﻿G21 G90|G0 X1|M2", "1");
    "G0349" BlockEmpty Stop {}
        es "bloque sin palabras"
        en "block without words"
        remedy "borre la línea; un comentario va detrás de «;», sin número de bloque; si hay una línea vacía detrás de cada línea, los finales de línea están duplicados: guarde el archivo con CR LF",
            "delete the line; a comment stands behind ';', without a block number; if there is an empty line behind each line, the line ends are doubled: save the file with CR LF";
        why "Ante una línea vacía, o con solo el número de bloque, el control da el error 0001.",
            "At an empty line, or one with a block number alone, the control gives error 0001.";
        example Example::program("fagor-8055", "G71 G90 G94 F100|N20|G1 X10|M30", "2");
    "G0350" BlockNumberTooGreat Stop { number: u32, most: u32 }
        es "el número de bloque N{number} es mayor que {most}"
        en "block number N{number} is above {most}"
        remedy "numere de nuevo el programa", "renumber the program";
        why "El control da el error 0002 ante un número mayor.",
            "The control gives error 0002 at a larger number.";
        example Example::program("fagor-8055", "G71 G90 G94 F100|N100000000 G1 X10|M30", "2:1");
    "G0351" SwitchUnknown Stop { switch: u32, most: u32 }
        es "salto de bloque /{switch}: el control tiene los interruptores /1 a /{most}"
        en "block delete /{switch}: the control has the switches /1 to /{most}"
        remedy "use uno de ellos", "use one of them";
        why "No se sabe si el control saltaría el bloque.",
            "It is not clear whether the control would skip the block.";
        example Example::program("fagor-8055", "G71 G90 G94 F100|/4 G1 X10|M30", "2:1");
    "G0352" DefinedBehindCall Stop { label: String }
        es "{label} SUB está detrás de una llamada a {label}, y el control se para al llegar a él"
        en "{label} SUB is behind a call of {label}, and the control stops when it comes to it"
        remedy "ponga los SUB al principio del programa, o detrás de M2", "put the SUBs at the beginning of the program, or behind M2";
        why "La llamada busca el SUB hacia delante y lo recuerda; si el programa llega después a él, es para el control un segundo SUB del mismo nombre.",
            "The call looks ahead for the SUB and remembers it; if the program comes to it later, it is for the control a second SUB of the same name.";
        example Example::program("linuxcnc", "G21 G90 F100|O<s> CALL|O<s> SUB|G1 X1|O<s> ENDSUB|M2", "3");
    "G0353" CommentInOWord Stop {}
        es "hay un comentario delante de la palabra O o dentro de ella"
        en "a comment stands before the O-word or inside it"
        remedy "ponga el comentario al final del bloque", "put the comment at the end of the block";
        why "El control busca la O al principio del bloque y su palabra justo detrás de la etiqueta: con un comentario en medio lee otra cosa.",
            "The control looks for the O at the beginning of the block and for its word right behind the label: with a comment between them it reads something else.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 REPEAT (twice) [2]|O1 ENDREPEAT|M2", "2:11");
    "G0354" CallNotFirst Stop {}
        es "M98 y M99 van al principio del bloque, escritos así, sin nada delante"
        en "M98 and M99 must stand first in the block, written so, with nothing before them"
        remedy "escriba M98 P… o M99 al principio", "write M98 P… or M99 first";
        why "El control los busca en el texto del bloque: escritos de otra forma, o detrás de otra palabra o de un comentario, no los ve.",
            "The control looks for them in the text of the block: written in another way, or behind another word or a comment, it does not see them.";
        example Example::program("linuxcnc", "G21 G90 F100|P2 M98|M2|O2|M99", "2:4");
    "G0355" BlocksNeverRun Caution { line: usize, end: usize }
        es "los bloques desde la línea {line} no se ejecutan nunca: el programa termina en la línea {end}"
        en "blocks from line {line} on are never run: the program ends in line {end}"
        remedy "borre los bloques que sobran, o ponga M2 o M30 detrás de ellos", "delete the blocks that are left over, or put M2 or M30 behind them";
        why "Un M30 de más deja la pieza sin acabar, y rodete no ha leído lo que sigue.",
            "An M30 too many leaves the part unfinished, and rodete has not read what follows.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X1|M2|G0 X5", "4");
}
