//! What is wrong with the characters of a line, its comments and its numbers, and with the text as a whole.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::t;

rules! {
    /// The rows of this file.
    RULES;

    "G0001" NameOpen Stop {}
        es "falta «>» al final del nombre"
        en "'>' is missing at the end of the name"
        remedy "cierre el nombre con «>»", "close the name with '>'";
        why "Sin «>» no se sabe dónde acaba el nombre, y todo lo que sigue sería parte de él.",
            "Without '>' nothing says where the name ends, and all that follows would be part of it.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X#<name|M2", "2:6");
    "G0002" NameEmpty Stop {}
        es "el nombre está vacío"
        en "the name is empty"
        remedy "dé un nombre entre «<» y «>»", "give a name between '<' and '>'";
        why "Un parámetro sin nombre no es ninguno.",
            "A parameter without a name is none.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X#<>|M2", "2:6");
    "G0003" BlockAfterEnd Stop {}
        es "hay un bloque detrás del fin de bloque «;»"
        en "there is a block after the end of block ';'"
        remedy "escriba un bloque por línea, y los comentarios entre paréntesis", "write one block a line, and comments in parentheses";
        why "El control da el bloque por terminado en «;» y no ejecuta lo que va detrás.",
            "The control takes the block as ended at ';' and does not run what follows.";
        example Example::program("fanuc-lathe-a", "G21 G98|G0 X40. Z2.; G1 Z-5. F100.|M30", "2:12");
    "G0004" HighLevel Stop {}
        es "las sentencias en lenguaje de alto nivel de Fagor no están implementadas"
        en "statements of Fagor's high-level language are not supported"
        remedy "escriba los comentarios detrás de «;»", "write comments after ';'";
        why "Estas sentencias calculan y deciden dentro del control: sin ejecutarlas no se sabe qué hace el programa.",
            "These statements compute and decide inside the control: unless they are run nobody knows what the program does.";
        example Example::program("fagor-8055", "G0 X1|(P1 = 2)|M30", "2:1");
    "G0005" CommentOpen Stop {}
        es "comentario sin cerrar"
        en "unclosed comment"
        remedy "ciérrelo con «)»", "close it with ')'";
        why "Lo que sigue al paréntesis no se lee, aunque sea un movimiento.",
            "What follows the parenthesis is not read, though it be a motion.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X1 (a|M2", "2:7");
    "G0006" CommentNested Stop {}
        es "comentario dentro de un comentario"
        en "nested comment"
        remedy "quite el paréntesis interior", "take out the inner parenthesis";
        why "Los controles no están de acuerdo en cuál de los dos cierres acaba el comentario.",
            "Controls do not agree on which of the two closes the comment.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X1 (a (b) c)|M2", "2:7");
    "G0007" CommentNotOpened Stop {}
        es "«)» sin comentario abierto"
        en "')' without an open comment"
        remedy "quítelo o abra el comentario con «(»", "take it out or open the comment with '('";
        why "Falta la mitad de un comentario: puede que la otra esté ejecutándose.",
            "Half of a comment is missing: the other half may be run.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X1 (a))|M2", "2:10");
    "G0008" EdgeNotSupported Stop { edge: char }
        es "«,{edge}» no está implementado: chaflanes, redondeos y ángulos en el bloque"
        en "',{edge}' is not supported: chamfers, corners and angles in a block"
        remedy "escriba el chaflán o el arco en un bloque propio", "write the chamfer or arc as a block of its own";
        why "Un borde que no se traza deja una esquina viva donde se pidió otra cosa.",
            "An edge that is not followed leaves a sharp corner where another was asked for.";
        example Example::program("linuxcnc", "G21 G90 F100|G1 X10,C2|M2", "2:7");
    "G0009" Comma Stop {}
        es "carácter «,» no admitido"
        en "character ',' is not allowed"
        remedy "escriba el decimal con punto: 1.5", "write the decimal with a point: 1.5";
        why "Un control lee 1,5 como 1 seguido de algo que no entiende, o se para.",
            "A control reads 1,5 as 1 and something that it does not know, or stops.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X1,5|M2", "2:6");
    "G0010" Strange Stop { character: String }
        es "carácter {character} no admitido"
        en "character {character} is not allowed"
        remedy "quítelo o escríbalo dentro de un comentario", "take it out, or write it inside a comment";
        why "Un carácter que no es del código ISO puede leerse de otra manera en cada control.",
            "A character that ISO code does not have may be read differently by each control.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X１|M2", "2:5");
    "G0011" NoNumber Stop {}
        es "falta el número"
        en "the number is missing"
        remedy "escriba un número detrás de la letra", "write a number after the letter";
        why "Una letra sin número no dice nada: el control se para en ella.",
            "A letter without a number says nothing: the control stops at it.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X|M2", "2:5");
    "G0012" TooGreat Stop {}
        es "número demasiado grande"
        en "number too great"
        remedy "compruebe el número", "check the number";
        why "Ni el control ni rodete pueden guardar ese número.",
            "Neither the control nor rodete can hold that number.";
        example Example::program("fagor-8055-t", "G0 X9999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999|M30", "1:5");
    "G0013" CommentInWord Stop {}
        es "comentario dentro de una palabra"
        en "comment inside a word"
        remedy "escríbalo delante o detrás de la palabra", "write it before or behind the word";
        why "Unos controles juntan lo que el comentario separa, otros no.",
            "Some controls join what the comment parts, others do not.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X1(one)2|M2", "2:6");
    "G0014" TwoPoints Stop {}
        es "número con dos puntos decimales"
        en "number with two decimal points"
        remedy "deje un solo punto", "leave one point";
        why "De los dos puntos solo uno puede ser el decimal, y no se sabe cuál.",
            "Only one of the two points can be the decimal one, and nothing says which.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X1.2.3|M2", "2:8");
    "G0015" Exponent Stop {}
        es "exponente no admitido"
        en "exponent not allowed"
        remedy "escriba el número entero: 1000 en vez de 1e3", "write the number out: 1000 for 1e3";
        why "En un bloque la E es una letra como las demás: 1e3 no es mil.",
            "In a block E is a letter like the others: 1e3 is not a thousand.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X1e3|M2", "2:6");
    "G0016" Unreadable Stop { reason: String }
        es "no se puede leer el programa: {reason}"
        en "cannot read the program: {reason}"
        remedy "compruebe el archivo y el disco", "check the file and the disk";
        why "Lo que falta del programa no se puede comprobar.",
            "What is missing of the program cannot be verified.";
        example Example::Never(t("falla el disco mientras se lee, no el texto", "a disk fails while it is read, not the text"));
    "G0017" LineEndless Stop { most: usize }
        es "la línea tiene más de {most} caracteres"
        en "the line has more than {most} characters"
        remedy "compruebe que el archivo es un programa ISO", "check that the file is an ISO program";
        why "Una línea así no la escribe nadie: el archivo será otra cosa.",
            "Nobody writes such a line: the file will be something else.";
        example Example::Repeated { control: "linuxcnc", word: "G0 X1 ", times: 800 };
    "G0018" ProgramTooLarge Stop { most: u64 }
        es "el programa tiene más de {most} MB"
        en "the program has more than {most} MB"
        remedy "divida el programa", "split the program";
        why "Más de eso no lo lee rodete, para que un archivo equivocado no llene la memoria.",
            "rodete reads no more than that, lest a wrong file fill the memory.";
        example Example::Never(t("haría falta un archivo de 900 MB", "it would take a file of 900 MB"));
    "G0019" LineTooLong Stop { most: usize }
        es "la línea tiene más de {most} caracteres"
        en "the line has more than {most} characters"
        remedy "divida el bloque", "split the block";
        why "El control lee cada bloque en una memoria de tamaño fijo.",
            "The control reads each block into a memory of fixed size.";
        example Example::Repeated { control: "linuxcnc", word: "G0 X1 ", times: 50 };
    "G0020" Percent Stop {}
        es "«%» no puede estar aquí"
        en "'%' cannot stand here"
        remedy "«%» va solo, en la primera y la última línea", "'%' stands alone, in the first and the last line";
        why "«%» dice dónde empieza y acaba el programa: en otro sitio corta lo que sigue.",
            "'%' says where the program begins and ends: elsewhere it cuts off what follows.";
        example Example::program("linuxcnc", "G21 G90 F100|%|G0 X1|M2", "2:1");
    "G0021" EndsWithoutCode Caution {}
        es "el programa termina sin M2 ni M30: leído como su final; el control se para ahí con una alarma"
        en "the program ends without M2 or M30: read as its end; the control stops there with an alarm"
        remedy "añada M30 al final", "add M30 at the end";
        why "Una alarma al final deja el husillo en marcha y la herramienta donde esté.",
            "An alarm at the end leaves the spindle running and the tool where it is.";
        example Example::program("fanuc-lathe-a", "G21 G98|G0 X40. Z2.|G1 Z-5. F100.", "3");
    "G0022" BeforePercent Caution {}
        es "lo que está delante del primer «%» no se lee, como en el control"
        en "what stands before the first '%' is not read, as on the control"
        remedy "empiece el archivo con «%»", "begin the file with '%'";
        why "Lo que parece un bloque ahí no se ejecuta nunca.",
            "What looks like a block there is never run.";
        example Example::program("fanuc-lathe-a", "the program of the flange|%|O0001|G0 X40. Z2.|M30|%", "1");
    "G0023" ProgramNumber Stop {}
        es "un número de programa solo puede estar al principio"
        en "a program number can only stand at the beginning"
        remedy "guarde cada programa en su archivo", "keep each program in its own file";
        why "Un número en medio puede empezar otro programa: qué se ejecuta depende del control.",
            "A number in the middle may begin another program: what is run depends on the control.";
        example Example::program("fagor-8055", "G0 X1|O5|M30", "2:1");
    "G0024" Aborts Caution { comment: String }
        es "el programa termina aquí: {comment}"
        en "the program ends here: {comment}"
        remedy "quite el comentario si no ha de parar", "take the comment out if it is not to stop";
        why "El control se para ahí y no ejecuta lo que sigue.",
            "The control stops there and does not run what follows.";
        example Example::program("linuxcnc", "G21 G90 F100|(ABORT,check the chuck)|G0 X1|M2", "2:1");
    "G0025" ActiveComment Note { comment: String }
        es "comentario activo, no ejecutado: {comment}"
        en "active comment, not executed: {comment}"
        remedy "", "";
        why "El control obedece este comentario: muestra, anota o calcula algo que aquí no se hace.",
            "The control obeys this comment: it shows, logs or computes something that is not done here.";
        example Example::program("linuxcnc", "G21 G90 F100|(MSG,turn the part)|G0 X1|M2", "2:1");
    "G0026" Utf16 Stop {}
        es "el archivo está en UTF-16"
        en "the file is in UTF-16"
        remedy "guárdelo como texto ASCII o UTF-8", "save it as ASCII or UTF-8 text";
        why "Ningún control lee ese texto: entre cada dos letras ve un carácter nulo.",
            "No control reads such a text: between any two letters it sees a null character.";
        example Example::Never(t("son bytes que no son texto", "it is bytes that are no text"));
    "G0027" MoreRefusals Note { count: usize }
        es "y {count} errores más"
        en "and {count} more errors"
        remedy "", "";
        why "Se listan los primeros: los demás suelen venir de la misma causa.",
            "The first ones are listed: the others mostly come of the same cause.";
        example Example::Repeated { control: "linuxcnc", word: "G77|", times: 60 };
}
