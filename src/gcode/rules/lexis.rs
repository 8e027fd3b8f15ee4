//! What is wrong with the characters of a line, its comments and its numbers, and with the text as a whole.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::{Text, t};

rules! {
    /// The rows of this file.
    RULES;

    "G0001" NameOpen Stop {}
        es "falta «>» al final del nombre"
        en "'>' is missing at the end of the name"
        remedy "cierre el nombre con «>»", "close the name with '>'";
        why "Sin «>» el nombre seguiría por el resto de la línea.",
            "Without '>' the name would run on into the rest of the line.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X#<name|M2", "2:6");
    "G0002" NameEmpty Stop {}
        es "el nombre está vacío"
        en "the name is empty"
        remedy "dé un nombre entre «<» y «>»", "give a name between '<' and '>'";
        why "Un parámetro necesita un nombre.",
            "A parameter needs a name.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X#<>|M2", "2:6");
    "G0003" BlockAfterEnd Stop {}
        es "hay un bloque después de «;», que termina el bloque"
        en "there is a block after ';', which ends the block"
        remedy "escriba un bloque por línea, y los comentarios entre paréntesis", "write one block per line, and comments in parentheses";
        why "El bloque termina en «;», y el control no ejecuta lo que sigue.",
            "The block ends at ';', and the control does not run what follows.";
        example Example::program("fanuc-lathe-a", "G21 G98|G0 X40. Z2.; G1 Z-5. F100.|M30", "2:12");
    "G0004" HighLevel Stop {}
        es "rodete no ejecuta sentencias en lenguaje de alto nivel de Fagor: no puede comprobar este programa"
        en "rodete does not run statements of Fagor's high-level language: it cannot verify this program"
        remedy "escriba lo que hace la sentencia en bloques sencillos, o compruebe el programa en el control; si es una simple nota, póngala detrás de «;»; si el programa es de otro control, indíquelo con --dialect",
            "write what the statement does as plain blocks, or check the program at the control; if it is a mere remark, put it after ';'; if the program is for another control, name it with --dialect";
        why "Estas sentencias calculan y deciden dentro del control: sin ejecutarlas no se sabe qué hace el programa.",
            "These statements compute and decide inside the control: without running them nobody knows what the program does.";
        example Example::program("fagor-8055", "G0 X1|(P1 = 2)|M30", "2:1");
    "G0005" CommentOpen Stop {}
        es "comentario sin cerrar"
        en "unclosed comment"
        remedy "ciérrelo con «)»", "close it with ')'";
        why "El control no lee lo que sigue al paréntesis, aunque sea un movimiento.",
            "The control does not read what follows the parenthesis, even if it is a motion.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X1 (a|M2", "2:7");
    "G0006" CommentNested Stop {}
        es "comentario dentro de un comentario"
        en "nested comment"
        remedy "quite el paréntesis interior", "take out the inner parenthesis";
        why "Según el control, cierra el comentario un paréntesis o el otro.",
            "Controls disagree on which of the two brackets closes the comment.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X1 (a (b) c)|M2", "2:7");
    "G0007" CommentNotOpened Stop {}
        es "«)» sin comentario abierto"
        en "')' without an open comment"
        remedy "quítelo, o abra el comentario con «(»", "delete it, or open the comment with '('";
        why "Falta el principio del comentario: el control puede ejecutar su texto.",
            "The beginning of the comment is missing: the control may run its text.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X1 (a))|M2", "2:10");
    "G0008" EdgeNotSupported Stop { edge: char }
        es "rodete no admite «,{edge}» como chaflán, redondeo o ángulo en el bloque"
        en "rodete does not follow ',{edge}' as a chamfer, corner radius or angle in a block"
        remedy "escriba el chaflán o el arco en un bloque propio", "write the chamfer or arc as a block of its own";
        why "Ignorarlo dejaría una esquina viva donde el programa pide otra cosa.",
            "Ignoring it would leave a sharp corner where the program asks for another.";
        example Example::program("linuxcnc", "G21 G90 F100|G1 X10,C2|M2", "2:7");
    "G0009" Comma Stop {}
        es "carácter «,» no admitido"
        en "character ',' is not allowed"
        remedy "escriba el decimal con punto, no con coma", "write the decimal with a point, not a comma";
        why "Un control lee 1,5 como 1 seguido de algo que no entiende, o se para.",
            "A control reads 1,5 as 1 followed by something unknown, or stops.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X1,5|M2", "2:6");
    "G0010" Strange Stop { character: String }
        es "carácter {character} no admitido"
        en "character {character} is not allowed"
        remedy "escriba en su lugar, con caracteres ASCII, lo que quería decir, o póngalo dentro de un comentario; no lo quite sin más: dos cifras, o un signo y su número, dirían otra cosa",
            "write in its place, in ASCII characters, what is meant, or put it inside a comment; do not just take it out: two digits, or a number without its sign, would say something else";
        why "Cada control puede leer a su manera un carácter que no es del código ISO.",
            "Each control may read a character outside the ISO code differently.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X１|M2", "2:5");
    "G0011" NoNumber Stop {}
        es "falta el número"
        en "the number is missing"
        remedy "escriba un número después de la letra", "write a number after the letter";
        why "El control se para en una letra sin número.",
            "The control stops at a letter without a number.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X|M2", "2:5");
    "G0012" TooGreat Stop {}
        es "número demasiado grande"
        en "number too large"
        remedy "compruebe el número", "check the number";
        why "Ni el control ni rodete pueden guardar ese número.",
            "Neither the control nor rodete can hold that number.";
        example Example::program("fagor-8055-t", "G0 X9999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999|M30", "1:5");
    "G0013" CommentInWord Stop {}
        es "comentario dentro de una palabra"
        en "comment inside a word"
        remedy "escríbalo antes o después de la palabra", "write it before or after the word";
        why "Unos controles unen las dos partes de la palabra y otros no.",
            "Some controls join the two parts of the word, others do not.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X1(one)2|M2", "2:6");
    "G0014" TwoPoints Stop {}
        es "número con dos puntos decimales"
        en "number with two decimal points"
        remedy "deje un solo punto", "leave one point";
        why "No se sabe cuál de los dos es el punto decimal.",
            "It is not clear which of the two points is the decimal point.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X1.2.3|M2", "2:8");
    "G0015" Exponent Stop {}
        es "exponente no admitido"
        en "exponent not allowed"
        remedy "escriba el número completo: 1000 en vez de 1e3", "write the number in full: 1000 instead of 1e3";
        why "En un bloque la E es la letra de una palabra: 1e3 no es mil.",
            "In a block E is a word letter: 1e3 is not a thousand.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X1e3|M2", "2:6");
    "G0016" Unreadable Stop { reason: Text }
        es "no se puede leer el programa: {reason}"
        en "cannot read the program: {reason}"
        remedy "compruebe el archivo y el disco", "check the file and the disk";
        why "rodete no puede comprobar la parte que no lee.",
            "rodete cannot verify the part that it cannot read.";
        example Example::Made { key: "program-unreadable", how: t("un disco que falla mientras se lee el programa", "a disk that fails while the program is read") };
    "G0017" LineEndless Stop { most: usize }
        es "la línea tiene más de {most} caracteres"
        en "the line is longer than {most} characters"
        remedy "compruebe que el archivo es un programa ISO", "check that the file is an ISO program";
        why "Ningún programa tiene una línea así: el archivo será otra cosa.",
            "No program has such a line: the file is probably something else.";
        example Example::Repeated { control: "linuxcnc", word: "G0 X1 ", times: 800 };
    "G0018" ProgramTooLarge Stop { most: u64 }
        es "el programa ocupa más de {most} MB"
        en "the program is larger than {most} MB"
        remedy "divida el programa", "split the program";
        why "El límite evita que un archivo equivocado llene la memoria.",
            "The limit keeps a wrong file from filling the memory.";
        example Example::Made { key: "program-too-large", how: t("un programa de más de 900 MB", "a program of more than 900 MB") };
    "G0019" LineTooLong Stop { most: usize }
        es "la línea tiene más de {most} caracteres"
        en "the line is longer than {most} characters"
        remedy "divida el bloque", "split the block";
        why "El control reserva una memoria fija para cada bloque.",
            "The control has a fixed amount of memory for one block.";
        example Example::Repeated { control: "linuxcnc", word: "G0 X1 ", times: 50 };
    "G0020" Percent Stop {}
        es "«%» no se admite aquí"
        en "'%' is not allowed here"
        remedy "escriba «%» solo, en la primera y la última línea", "write '%' alone on the first and the last line";
        why "«%» marca el principio y el final del programa: en otro sitio corta lo que sigue.",
            "'%' marks the beginning and the end of the program: elsewhere it cuts off the rest.";
        example Example::program("linuxcnc", "G21 G90 F100|%|G0 X1|M2", "2:1");
    "G0021" EndsWithoutCode Caution {}
        es "el programa termina sin M2 ni M30: rodete lo toma como el final; el control se para aquí con una alarma"
        en "the program ends without M2 or M30: rodete takes this as the end; the control stops here with an alarm"
        remedy "compruebe que el programa completo está en el archivo; si lo está, añada M30 al final", "check that the whole program is in the file; if it is, add M30 at the end";
        why "Una alarma al final deja el husillo en marcha y la herramienta donde esté.",
            "An alarm at the end leaves the spindle running and the tool where it is.";
        example Example::program("fanuc-lathe-a", "G21 G98|G0 X40. Z2.|G1 Z-5. F100.", "3");
    "G0022" BeforePercent Caution {}
        es "el texto anterior al primer «%» no se lee, como en el control"
        en "text before the first '%' is not read, as on the control"
        remedy "empiece el archivo con «%»", "begin the file with '%'";
        why "El control no ejecuta nunca un bloque que esté ahí.",
            "The control never runs a block there.";
        example Example::program("fanuc-lathe-a", "the program of the flange|%|O0001|G0 X40. Z2.|M30|%", "1");
    "G0023" ProgramNumber Stop {}
        es "un número de programa solo se admite al principio y solo en su bloque"
        en "a program number is allowed only at the beginning, alone in its block"
        remedy "guarde cada programa en su archivo; lo que siga al número, en el bloque siguiente",
            "keep each program in its own file; write what follows the number in the next block";
        why "Un número en medio puede empezar otro programa: lo que se ejecuta depende del control.",
            "A number in the middle may begin another program: the control decides what runs.";
        example Example::program("fanuc-lathe-a", "G21 G98|G0 X40. Z2.|O5 G0 X50.|M30", "3:1");
    "G0024" Aborts Caution { comment: String }
        es "el programa termina aquí: {comment}"
        en "the program ends here: {comment}"
        remedy "quite el comentario si el programa debe seguir", "delete the comment if the program should go on";
        why "El control se para ahí y no ejecuta lo que sigue.",
            "The control stops there and does not run what follows.";
        example Example::program("linuxcnc", "G21 G90 F100|(ABORT,check the chuck)|G0 X1|M2", "2:1");
    "G0025" ActiveComment Note { comment: String }
        es "comentario activo, no ejecutado: {comment}"
        en "active comment, not executed: {comment}"
        remedy "", "";
        why "El control obedece este comentario: muestra, anota o calcula algo. rodete no lo hace.",
            "The control obeys this comment: it shows, logs or computes something. rodete does not.";
        example Example::program("linuxcnc", "G21 G90 F100|(MSG,turn the part)|G0 X1|M2", "2:1");
    "G0026" Utf16 Stop {}
        es "el archivo está en UTF-16"
        en "the file is in UTF-16"
        remedy "guárdelo como texto ASCII o UTF-8", "save it as ASCII or UTF-8 text";
        why "Ningún control lee UTF-16: entre cada dos letras ve un carácter nulo.",
            "No control reads UTF-16: it sees a null character between any two letters.";
        example Example::Made { key: "program-utf16", how: t("un programa guardado en UTF-16", "a program saved as UTF-16") };
    "G0027" MoreRefusals Note { count: usize }
        es "y {count} errores más"
        en "and {count} more errors"
        remedy "", "";
        why "rodete lista los primeros: los demás suelen tener la misma causa.",
            "rodete lists the first ones: the others usually have the same cause.";
        example Example::Repeated { control: "linuxcnc", word: "G77|", times: 60 };
    "G0028" HeaderInvalid Stop { most: usize }
        es "la primera línea no es %nombre,atributos, con un nombre de hasta {most} caracteres"
        en "the first line is not %name,attributes, with a name of up to {most} characters"
        remedy "escriba por ejemplo %0001-BRIDA,MX--,", "write for example %0001-FLANGE,MX--,";
        why "Con otra cabecera el control da al programa solo el atributo M: no lo ejecuta.",
            "With another header the control gives the program the attribute M alone: it does not run it.";
        example Example::program("fagor-8055", "%0001 FLANGE MX|G71 G90 G94 F100|G1 X10|M30", "1");
    "G0029" HeaderNotExecutable Stop { attributes: String }
        es "los atributos {attributes} de la cabecera no llevan X"
        en "the attributes {attributes} of the header are without X"
        remedy "añada X: MX--", "add X: MX--";
        why "Sin el atributo X el programa no es ejecutable: el control da el error 0172.",
            "Without the attribute X the program is not executable: the control gives error 0172.";
        example Example::program("fagor-8055", "%FLANGE,M,|G71 G90 G94 F100|G1 X10|M30", "1");
    "G0030" PercentAgain Stop {}
        es "«%» no se admite aquí"
        en "'%' is not allowed here"
        remedy "si es la cabecera, póngala en la primera línea; si cierra el programa, bórrela: el final es M30; si empieza otro programa, compruébelo en su propio archivo",
            "if it is the header, write it in the first line; if it closes the program, delete it: the end is M30; if another program begins here, verify that in a file of its own";
        why "«%» abre la cabecera con el nombre del programa; el final es M30.",
            "'%' opens the header with the program's name; the end is M30.";
        example Example::program("fagor-8055", "%FLANGE,MX,|G71 G90 G94 F100|G1 X10|%", "4:1");
    "G0031" LoneReturnRejected Stop {}
        es "un CR sin LF detrás no termina la línea: el control lo toma por un espacio"
        en "a CR without an LF behind it does not end the line: the control takes it for a blank"
        remedy "guarde el archivo con finales de línea LF o CR LF", "save the file with line ends LF or CR LF";
        why "Para el control, lo que sigue al CR está en el mismo bloque, o en el mismo comentario, aunque el editor muestre otra línea.",
            "For the control, what stands behind the CR is in the same block, or in the same comment, though the editor shows another line.";
        example Example::program("linuxcnc", "G21 G90 F100|G1 X10\rY5|M2", "2:7");
    "G0032" LetterForZero Stop {}
        es "hay una letra O donde va una cifra"
        en "a letter O stands where a digit should"
        remedy "¿es la cifra 0? Escriba 0", "is it the digit 0? Write 0";
        why "La letra O y la cifra 0 se parecen, y el control se para en la letra.",
            "The letter O and the digit 0 look alike, and the control stops at the letter.";
        example Example::program("linuxcnc", "G21 G90 F100|GO X1|M2", "2:2");
    "G0850" OtherControl Stop { control: Text, sign: String }
        es "el programa está escrito para {control}, que rodete no lee: lo dice «{sign}»"
        en "the program is written for {control}, which rodete does not read: '{sign}' says so"
        remedy "compruebe el programa en su control, o genérelo con el posprocesador de un control que rodete lea", "verify the program at its control, or post it for a control that rodete reads";
        why "Ninguno de los controles de rodete tiene esta palabra, y los demás bloques tampoco significan lo mismo en ellos.",
            "None of rodete's controls has this word, and the other blocks do not mean the same on them either.";
        example Example::program("linuxcnc", "0 BEGIN PGM PLATE MM|1 L X+5 R0 FMAX|2 END PGM PLATE MM", "1");
    "G0851" NoProgramNumbers Stop { dialect: &'static str }
        es "O no es una letra del dialecto {dialect}: el nombre del programa va detrás de «%», en la primera línea"
        en "O is not a letter of the dialect {dialect}: a program's name stands behind '%', in the first line"
        remedy "si el programa es de otro control, indíquelo con --dialect; si no, borre el bloque", "if the program is for another control, name it with --dialect; if not, delete the block";
        why "El control da error ante la O; un número O es de un Fanuc o un Haas, que leen otros códigos de otra manera.",
            "The control gives an error at the O; an O number is of a Fanuc or a Haas, which read other codes differently.";
        example Example::program("fagor-8055", "O1000|G71 G90 G94 F100|G1 X10|M30", "1:1");
    "G0852" OtherControlLikely Caution { control: Text, sign: String, dialect: &'static str }
        es "«{sign}» es propio de programas para {control}, que rodete no lee: ha leído el programa como {dialect}"
        en "'{sign}' belongs to programs for {control}, which rodete does not read: it has read the program as {dialect}"
        remedy "si es de ese control, compruébelo en él, o genérelo con el posprocesador de un control que rodete lea; nombre un dialecto con --dialect solo si el programa es de verdad para él",
            "if it is for that control, verify it there, or post it for a control that rodete reads; name a dialect with --dialect only if the program is in truth for it";
        why "Los bloques sencillos se parecen en todos los controles, y arcos, longitudes y unidades no siempre significan lo mismo.",
            "Plain blocks look alike on all controls, and arcs, lengths and units do not always mean the same.";
        example Example::Command { files: &[("shaft.mpf", "G54 S900 M3|G0 X0 Y0 Z5|G1 Z-2 F200|M30")], words: &["verify", "shaft.mpf"] };
}
