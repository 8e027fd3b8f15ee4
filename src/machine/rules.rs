//! Findings about a machine's own files and of edits to them: one row each.
//!
//! G10 LinuxCNC's parameter file, G11 edits of offsets, G12 what the file comes to.

use crate::finding::Example;
use crate::finding::rule::rules;

/// The parameter file of an example, its lines joined with `|`.
macro_rules! file {
    ($lines:literal) => {
        Example::Command { files: &[("linuxcnc.var", $lines)], words: &["offsets", "linuxcnc.var"] }
    };
}

/// An edit of an example.
macro_rules! set {
    ($edit:literal) => {
        Example::Command { files: &[("linuxcnc.var", "5220 1")], words: &["offsets", "linuxcnc.var", "--set", $edit] }
    };
}

rules! {
    /// The rows of a machine's files.
    RULES;

    "G1001" ParameterFileTooLong Stop {}
        es "el archivo de parámetros es más largo que los de LinuxCNC"
        en "the parameter file is longer than any LinuxCNC writes"
        remedy "indique el archivo .var que nombra PARAMETER_FILE en el archivo INI",
            "give the .var file named by PARAMETER_FILE in the INI file";
        why "LinuxCNC tiene unos miles de parámetros, uno por línea: este será otro archivo.",
            "LinuxCNC has a few thousand parameters, one per line: this is probably another file.";
        example Example::Made { key: "long-var", how: crate::text::t(
            "un archivo .var de más de 256 KiB", "a .var file of more than 256 KiB") };
    "G1002" ParameterLineTooLong Stop {}
        es "la línea es demasiado larga: LinuxCNC la leería como dos"
        en "the line is too long: LinuxCNC would read it as two"
        remedy "deje en la línea un número y un valor", "keep one number and one value on the line";
        why "LinuxCNC reserva una memoria fija para cada línea.", "LinuxCNC has a fixed amount of memory for a line.";
        example Example::Made { key: "long-line", how: crate::text::t(
            "un archivo .var con una línea de 300 letras", "a .var file with a line of 300 letters") };
    "G1003" ParameterWithoutValue Stop { parameter: u32 }
        es "el parámetro {parameter} no tiene valor"
        en "parameter {parameter} has no value"
        remedy "escriba en cada línea un número de parámetro y su valor, como «5221 12.500000»",
            "write a parameter number and its value on each line, like '5221 12.500000'";
        why "LinuxCNC no arranca con un archivo así.", "LinuxCNC does not start with such a file.";
        example file!("5220 1|5221");
    "G1004" TextAfterValue Stop { text: String }
        es "sobra texto después del valor: '{text}'"
        en "there is text after the value: '{text}'"
        remedy "escriba en cada línea un número de parámetro y su valor, como «5221 12.500000»",
            "write a parameter number and its value on each line, like '5221 12.500000'";
        why "LinuxCNC leería solo la mitad de un valor con un espacio dentro.", "LinuxCNC would read only half of a value with a space in it.";
        example file!("5220 1|5221 1 000");
    "G1005" NoParameterNumber Stop { text: String }
        es "«{text}» no es un número de parámetro"
        en "'{text}' is not a parameter number"
        remedy "escriba en cada línea un número de parámetro y su valor, como «5221 12.500000»",
            "write a parameter number and its value on each line, like '5221 12.500000'";
        why "Sin el número no se sabe a qué parámetro pertenece el valor.", "Without the number it is not clear which parameter the value belongs to.";
        example file!("5220 1|X 5");
    "G1006" NoSuchParameter Stop {}
        es "no hay parámetro con este número"
        en "there is no parameter with this number"
        remedy "corrija el número o quite la línea", "correct the number or delete the line";
        why "LinuxCNC tiene los parámetros 1 a 5601.", "LinuxCNC has parameters 1 to 5601.";
        example file!("5220 1|9999 5");
    "G1007" ParameterTooGreat Stop {}
        es "el valor es demasiado grande o no es finito"
        en "the value is too large or not finite"
        remedy "escriba un número decimal, como «-12.5»", "write a decimal number, like '-12.5'";
        why "Con ese valor todo cálculo del intérprete da infinito.", "With such a value every calculation in the interpreter gives infinity.";
        example file!("5220 1|5221 1e300");
    "G1008" ParameterNoNumber Stop { text: String }
        es "«{text}» no es un número"
        en "'{text}' is not a number"
        remedy "escriba un número decimal, como «-12.5»", "write a decimal number, like '-12.5'";
        why "LinuxCNC tomaría la parte que entienda, o 0.", "LinuxCNC would take the part that it understands, or 0.";
        example file!("5220 1|5221 abc");
    "G1009" ParameterWithComma Stop { text: String }
        es "«{text}» no es un número"
        en "'{text}' is not a number"
        remedy "escriba el decimal con punto, no con coma", "write the decimal with a point, not a comma";
        why "LinuxCNC dejaría de leer en la coma: 12,5 sería 12.", "LinuxCNC would stop reading at the comma: 12,5 would be 12.";
        example file!("5220 1|5221 12,5");
    "G1010" ParameterTwice Stop { parameter: u32, first: usize }
        es "el parámetro {parameter} aparece dos veces, la primera en la línea {first}"
        en "parameter {parameter} appears twice, first in line {first}"
        remedy "borre una de las dos líneas", "delete one of the two lines";
        why "LinuxCNC no lee un archivo que no está en orden.", "LinuxCNC does not read a file that is not in order.";
        example file!("5220 1|5221 5|5221 6");
    "G1011" ParameterOutOfOrder Stop { parameter: u32, last: u32, first: usize }
        es "el parámetro {parameter} viene después del {last} de la línea {first}"
        en "parameter {parameter} comes after {last} in line {first}"
        remedy "ordene las líneas por número, de menor a mayor; si no, LinuxCNC no lee el archivo",
            "sort the lines by number, in ascending order; otherwise LinuxCNC does not read the file";
        why "LinuxCNC lee los parámetros por orden y se para en el primero que no lo sigue.",
            "LinuxCNC reads the parameters in order and stops at the first one out of order.";
        example file!("5220 1|5222 5|5221 6");
    "G1012" ParameterFileIsPackage Stop {}
        es "es un libro (un paquete zip), no un archivo de parámetros .var"
        en "this is a workbook (a zip package), not a .var parameter file"
        remedy "dé aquí el archivo .var de LinuxCNC; un libro de orígenes va en --workbook (offsets), y uno de torno, en --tools (verify, view, simulate)",
            "give LinuxCNC's .var file here; a workbook of offsets goes to --workbook (offsets), and one of a lathe to --tools (verify, view, simulate)";
        why "Un archivo .var es texto, con un número de parámetro y un valor por línea.", "A .var file is text, with the number of a parameter and a value on each line.";
        example Example::Made { key: "workbook-as-var", how: crate::text::t("offsets lathe.xlsx", "offsets lathe.xlsx") };
    "G1101" EditWithoutCode Stop { edit: String }
        es "«{edit}»: falta el código"
        en "'{edit}': the code is missing"
        remedy "escriba de G54 a G59.3 con X Y Z A B C U V W R, como «G55 X2 Y1 Z-2», G52 con los ejes, o solo G92.1, G92.2 o G92.3",
            "write G54 to G59.3 with X Y Z A B C U V W R, like 'G55 X2 Y1 Z-2', G52 with axes, or G92.1, G92.2 or G92.3 alone";
        why "Sin el código no se sabe qué decalaje cambia.", "Without the code it is not clear which offset changes.";
        example set!("X5");
    "G1102" EditTakesNoAxes Stop { edit: String, code: String }
        es "«{edit}»: {code} no lleva palabras de ejes"
        en "'{edit}': {code} takes no axis words"
        remedy "escriba de G54 a G59.3 con X Y Z A B C U V W R, como «G55 X2 Y1 Z-2», G52 con los ejes, o solo G92.1, G92.2 o G92.3",
            "write G54 to G59.3 with X Y Z A B C U V W R, like 'G55 X2 Y1 Z-2', G52 with axes, or G92.1, G92.2 or G92.3 alone";
        why "Estos códigos borran, suspenden o restauran los registros enteros.", "These codes clear, suspend or restore all the registers.";
        example set!("G92.1 X5");
    "G1103" EditOfG92 Stop { edit: String }
        es "«{edit}»: G92 depende de la posición de la máquina, que el archivo no contiene"
        en "'{edit}': G92 depends on the machine's position, which the file does not contain"
        remedy "escriba G52 con los desplazamientos, que ocupan los mismos registros, o G92.1 para borrarlos",
            "write G52 with the offsets, which use the same registers, or G92.1 to clear them";
        why "G92 da la posición actual de la máquina, y un archivo no tiene posición.",
            "G92 gives the machine's present position, and a file has no position.";
        example set!("G92 X5");
    "G1104" CodeNotEdited Stop { edit: String, code: String }
        es "«{edit}»: {code} no se puede fijar"
        en "'{edit}': {code} cannot be set"
        remedy "escriba de G54 a G59.3 con X Y Z A B C U V W R, como «G55 X2 Y1 Z-2», G52 con los ejes, o solo G92.1, G92.2 o G92.3",
            "write G54 to G59.3 with X Y Z A B C U V W R, like 'G55 X2 Y1 Z-2', G52 with axes, or G92.1, G92.2 or G92.3 alone";
        why "El archivo guarda los decalajes y los registros de G92, y ningún otro código.",
            "The file holds the work offsets and the G92 registers, and no other code.";
        example set!("G17 X5");
    "G1105" AxisTwice Stop { edit: String, letter: char }
        es "«{edit}»: {letter} aparece dos veces"
        en "'{edit}': {letter} appears twice"
        remedy "deje una de las dos", "keep one of the two";
        why "No se sabe cuál de los dos valores vale.", "It is not clear which of the two values counts.";
        example set!("G55 X5 X6");
    "G1106" NoAxisToSet Stop { edit: String }
        es "«{edit}»: no hay ningún eje que fijar"
        en "'{edit}': there is no axis to set"
        remedy "escriba de G54 a G59.3 con X Y Z A B C U V W R, como «G55 X2 Y1 Z-2», G52 con los ejes, o solo G92.1, G92.2 o G92.3",
            "write G54 to G59.3 with X Y Z A B C U V W R, like 'G55 X2 Y1 Z-2', G52 with axes, or G92.1, G92.2 or G92.3 alone";
        why "Solo cambian los ejes que se nombran.", "Only the axes named change.";
        example set!("G55");
    "G1107" WordWithoutLetter Stop { edit: String, word: String }
        es "«{edit}»: «{word}» no empieza por una letra"
        en "'{edit}': '{word}' does not begin with a letter"
        remedy "escriba cada palabra sin espacios, como X2.5", "write each word without spaces, like X2.5";
        why "Sin letra no se sabe de qué eje es el número.", "Without a letter it is not clear which axis the number belongs to.";
        example set!("G55 5");
    "G1108" EditExponent Stop { edit: String }
        es "«{edit}»: no se admiten exponentes"
        en "'{edit}': exponents are not allowed"
        remedy "escriba el número completo, como 1000", "write the number in full, like 1000";
        why "En un bloque, una E sería otra palabra.", "In a block an E would be another word.";
        example set!("G55 X1E3");
    "G1109" G52WithoutRotation Stop { edit: String }
        es "«{edit}»: G52 no tiene giro"
        en "'{edit}': G52 has no rotation"
        remedy "dé R con un decalaje, como «G55 R30»", "give R with a work offset, like 'G55 R30'";
        why "LinuxCNC guarda un giro con cada decalaje de G54 a G59.3, pero no con G52.",
            "LinuxCNC keeps a rotation with each offset from G54 to G59.3, but not with G52.";
        example set!("G52 R30");
    "G1110" NotAnAxis Stop { edit: String, letter: char }
        es "«{edit}»: {letter} no es un eje"
        en "'{edit}': {letter} is not an axis"
        remedy "use los ejes X Y Z A B C U V W, o R para el giro", "use the axes X Y Z A B C U V W, or R for the rotation";
        why "LinuxCNC no guarda nada con esa letra.", "LinuxCNC stores nothing under that letter.";
        example set!("G55 Q5");
    "G1111" AxisWithoutNumber Stop { edit: String, letter: char }
        es "«{edit}»: {letter} no tiene número"
        en "'{edit}': {letter} has no number"
        remedy "escriba el número junto a la letra, como {letter}-12.5", "write the number next to the letter, like {letter}-12.5";
        why "Un eje sin número no da ninguna posición.", "An axis without a number gives no position.";
        example set!("G55 X");
    "G1112" OffsetNotANumber Stop { edit: String, text: String, letter: char }
        es "«{edit}»: «{text}» no es un número"
        en "'{edit}': '{text}' is not a number"
        remedy "escriba el número junto a la letra, como {letter}-12.5", "write the number next to the letter, like {letter}-12.5";
        why "Una posición es un número.", "A position is a number.";
        example set!("G55 X1.2.3");
    "G1113" OffsetWithComma Stop { edit: String, text: String, letter: char }
        es "«{edit}»: «{text}» no es un número"
        en "'{edit}': '{text}' is not a number"
        remedy "escriba el decimal de {letter} con punto, no con coma", "write the decimal of {letter} with a point, not a comma";
        why "La coma podría separar decimales o millares.", "The comma might separate decimals or thousands.";
        example set!("G55 X2,5");
    "G1114" OffsetTooGreat Stop { edit: String, letter: char, text: String, most: f64 }
        es "«{edit}»: {letter}{text} pasa de ±{most}"
        en "'{edit}': {letter}{text} is beyond ±{most}"
        remedy "compruebe el número y la unidad", "check the number and the unit";
        why "Ningún programa admite ese número, y ninguna máquina llega tan lejos.",
            "No program can hold such a number, and no machine goes that far.";
        example set!("G55 X100000");
    "G1115" TooManyDecimals Stop { edit: String, letter: char, text: String, most: usize }
        es "«{edit}»: {letter}{text} tiene más decimales que los {most} del archivo"
        en "'{edit}': {letter}{text} has more decimals than the file's {most}"
        remedy "redondee el número", "round the number";
        why "Los decimales sobrantes se perderían sin aviso.", "The extra decimals would be lost without warning.";
        example set!("G55 X0.1234567");
    "G1201" NoActiveSystemGiven Caution {}
        es "falta el parámetro 5220: rodete toma como activo el decalaje 1, G54"
        en "parameter 5220 is missing: rodete takes offset 1, G54, as active"
        remedy "escriba en el parámetro 5220 el número del decalaje activo: de 1 (G54) a 9 (G59.3)",
            "write the number of the active offset in parameter 5220: 1 (G54) to 9 (G59.3)";
        why "La máquina arranca con el decalaje que indica este parámetro.", "The machine starts with the offset that this parameter names.";
        example file!("5221 5");
    "G1202" ActiveSystemNotOne Caution {}
        es "el parámetro 5220 no es un número entero de 1 a 9: rodete toma el decalaje 1, G54, como dice el manual de LinuxCNC; su intérprete puede tomar la parte entera"
        en "parameter 5220 is not a whole number from 1 to 9: rodete takes offset 1, G54, as LinuxCNC's manual says; its interpreter may take the whole part"
        remedy "escriba en el parámetro 5220 el número del decalaje activo: de 1 (G54) a 9 (G59.3)",
            "write the number of the active offset in parameter 5220: 1 (G54) to 9 (G59.3)";
        why "La máquina podría arrancar con otro decalaje.",
            "The machine might start with another offset.";
        example file!("5220 2.5");
}
