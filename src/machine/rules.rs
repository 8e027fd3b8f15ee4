//! What is told of a machine's own files and of edits to them: one row for each finding.
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
        es "el archivo de parámetros es más largo que cualquiera de LinuxCNC"
        en "the parameter file is longer than any of LinuxCNC"
        remedy "indique el archivo .var que nombra PARAMETER_FILE en el archivo INI",
            "give the .var file that PARAMETER_FILE in the INI file names";
        why "Hay unos miles de parámetros, una línea cada uno: lo que es mayor es otro archivo.",
            "There are some thousands of parameters, a line each: what is larger is another file.";
        example Example::Made { key: "long-var", how: crate::text::t(
            "un archivo .var de más de 256 KiB", "a .var file of more than 256 KiB") };
    "G1002" ParameterLineTooLong Stop {}
        es "la línea es demasiado larga: LinuxCNC la leería como dos"
        en "the line is too long: LinuxCNC would read it as two"
        remedy "deje en la línea un número y un valor", "leave a number and a value in the line";
        why "LinuxCNC lee cada línea en una memoria de tamaño fijo.", "LinuxCNC reads every line into a memory of fixed size.";
        example Example::Made { key: "long-line", how: crate::text::t(
            "un archivo .var con una línea de 300 letras", "a .var file with a line of 300 letters") };
    "G1003" ParameterWithoutValue Stop { parameter: u32 }
        es "el parámetro {parameter} no tiene valor"
        en "parameter {parameter} has no value"
        remedy "escriba en cada línea el número de un parámetro y su valor, como «5221 12.500000»",
            "write in each line the number of a parameter and its value, as '5221 12.500000'";
        why "LinuxCNC no arranca con un archivo así.", "LinuxCNC does not start with such a file.";
        example file!("5220 1|5221");
    "G1004" TextAfterValue Stop { text: String }
        es "sobra texto después del valor: '{text}'"
        en "there is text after the value: '{text}'"
        remedy "escriba en cada línea el número de un parámetro y su valor, como «5221 12.500000»",
            "write in each line the number of a parameter and its value, as '5221 12.500000'";
        why "Un valor con un blanco dentro se leería a medias.", "A value with a blank inside would be read by half.";
        example file!("5220 1|5221 1 000");
    "G1005" NoParameterNumber Stop { text: String }
        es "«{text}» no es el número de un parámetro"
        en "'{text}' is not the number of a parameter"
        remedy "escriba en cada línea el número de un parámetro y su valor, como «5221 12.500000»",
            "write in each line the number of a parameter and its value, as '5221 12.500000'";
        why "Sin el número no se sabe de qué es el valor.", "Without the number nobody knows what the value is of.";
        example file!("5220 1|X 5");
    "G1006" NoSuchParameter Stop {}
        es "no hay parámetro con este número"
        en "there is no parameter of this number"
        remedy "corrija el número o quite la línea", "correct the number or take the line out";
        why "LinuxCNC tiene los parámetros de 1 a 5601.", "LinuxCNC has the parameters from 1 to 5601.";
        example file!("5220 1|9999 5");
    "G1007" ParameterTooGreat Stop {}
        es "el valor es demasiado grande o no es finito"
        en "the value is too great or not finite"
        remedy "escriba un número decimal, como «-12.5»", "write a decimal number, as '-12.5'";
        why "Con tal valor toda cuenta del intérprete es infinita.", "With such a value every calculation of the interpreter is infinite.";
        example file!("5220 1|5221 1e300");
    "G1008" ParameterNoNumber Stop { text: String }
        es "«{text}» no es un número"
        en "'{text}' is not a number"
        remedy "escriba un número decimal, como «-12.5»", "write a decimal number, as '-12.5'";
        why "LinuxCNC tomaría lo que entienda de él, o 0.", "LinuxCNC would take what it understands of it, or 0.";
        example file!("5220 1|5221 abc");
    "G1009" ParameterWithComma Stop { text: String }
        es "«{text}» no es un número"
        en "'{text}' is not a number"
        remedy "el separador decimal es el punto: «1.5»", "the decimal separator is the point: '1.5'";
        why "LinuxCNC dejaría de leer en la coma: 12,5 sería 12.", "LinuxCNC would stop reading at the comma: 12,5 would be 12.";
        example file!("5220 1|5221 12,5");
    "G1010" ParameterTwice Stop { parameter: u32, first: usize }
        es "el parámetro {parameter} se da dos veces, la primera en la línea {first}"
        en "parameter {parameter} is given twice, first in line {first}"
        remedy "quite una de las dos líneas", "take one of the two lines out";
        why "LinuxCNC no lee un archivo que no está en orden.", "LinuxCNC does not read a file that is not in order.";
        example file!("5220 1|5221 5|5221 6");
    "G1011" ParameterOutOfOrder Stop { parameter: u32, last: u32, first: usize }
        es "el parámetro {parameter} está después del {last} de la línea {first}"
        en "parameter {parameter} stands after {last} of line {first}"
        remedy "ordene las líneas por número, de menor a mayor; LinuxCNC no lee el archivo de otro modo",
            "sort the lines by number, ascending; LinuxCNC does not read the file otherwise";
        why "LinuxCNC busca los parámetros por orden y se para en el que no lo sigue.",
            "LinuxCNC looks parameters up in order and stops at the one that breaks it.";
        example file!("5220 1|5222 5|5221 6");
    "G1101" EditWithoutCode Stop { edit: String }
        es "«{edit}»: falta el código"
        en "'{edit}': the code is missing"
        remedy "escriba de G54 a G59.3 con X Y Z A B C U V W R, como «G55 X2 Y1 Z-2», G52 con los ejes, o solo G92.1, G92.2 o G92.3",
            "write G54 to G59.3 with X Y Z A B C U V W R, as 'G55 X2 Y1 Z-2', G52 with axes, or G92.1, G92.2 or G92.3 alone";
        why "Sin el código no se sabe qué sistema cambia.", "Without the code nobody knows which system changes.";
        example set!("X5");
    "G1102" EditTakesNoAxes Stop { edit: String, code: String }
        es "«{edit}»: {code} no lleva palabras de ejes"
        en "'{edit}': {code} takes no axis words"
        remedy "escriba de G54 a G59.3 con X Y Z A B C U V W R, como «G55 X2 Y1 Z-2», G52 con los ejes, o solo G92.1, G92.2 o G92.3",
            "write G54 to G59.3 with X Y Z A B C U V W R, as 'G55 X2 Y1 Z-2', G52 with axes, or G92.1, G92.2 or G92.3 alone";
        why "Estos códigos borran, quitan o ponen los registros enteros.", "These codes clear, suspend or restore the registers as a whole.";
        example set!("G92.1 X5");
    "G1103" EditOfG92 Stop { edit: String }
        es "«{edit}»: G92 parte de la posición de la máquina, que el archivo no conoce"
        en "'{edit}': G92 starts from the position of the machine, which the file does not know"
        remedy "escriba G52 con los desplazamientos, que ocupan los mismos registros, o G92.1 para borrarlos",
            "write G52 with the offsets, which are kept in the same registers, or G92.1 to clear them";
        why "G92 dice dónde está la máquina ahora, y un archivo no está en ningún sitio.",
            "G92 says where the machine is now, and a file is nowhere.";
        example set!("G92 X5");
    "G1104" CodeNotEdited Stop { edit: String, code: String }
        es "«{edit}»: {code} no se puede fijar"
        en "'{edit}': {code} cannot be set"
        remedy "escriba de G54 a G59.3 con X Y Z A B C U V W R, como «G55 X2 Y1 Z-2», G52 con los ejes, o solo G92.1, G92.2 o G92.3",
            "write G54 to G59.3 with X Y Z A B C U V W R, as 'G55 X2 Y1 Z-2', G52 with axes, or G92.1, G92.2 or G92.3 alone";
        why "El archivo guarda los orígenes y los registros de G92, y ningún otro código.",
            "The file keeps the offsets and the registers of G92, and no other code.";
        example set!("G17 X5");
    "G1105" AxisTwice Stop { edit: String, letter: char }
        es "«{edit}»: {letter} se da dos veces"
        en "'{edit}': {letter} is given twice"
        remedy "deje una de las dos", "leave one of the two";
        why "No se sabe cuál de los dos valores vale.", "Nobody knows which of the two values holds.";
        example set!("G55 X5 X6");
    "G1106" NoAxisToSet Stop { edit: String }
        es "«{edit}»: no hay ningún eje que fijar"
        en "'{edit}': there is no axis to set"
        remedy "escriba de G54 a G59.3 con X Y Z A B C U V W R, como «G55 X2 Y1 Z-2», G52 con los ejes, o solo G92.1, G92.2 o G92.3",
            "write G54 to G59.3 with X Y Z A B C U V W R, as 'G55 X2 Y1 Z-2', G52 with axes, or G92.1, G92.2 or G92.3 alone";
        why "Solo cambia lo que se nombra.", "Only what is named changes.";
        example set!("G55");
    "G1107" WordWithoutLetter Stop { edit: String, word: String }
        es "«{edit}»: «{word}» no empieza por una letra"
        en "'{edit}': '{word}' does not begin with a letter"
        remedy "escriba cada palabra junta, como X2.5", "write every word together, as X2.5";
        why "Sin letra no se sabe de qué eje es el número.", "Without a letter nobody knows of which axis the number is.";
        example set!("G55 5");
    "G1108" EditExponent Stop { edit: String }
        es "«{edit}»: no se admiten exponentes"
        en "'{edit}': exponents are not taken"
        remedy "escriba el número entero, como 1000", "write the number out, as 1000";
        why "En un bloque una E sería otra palabra.", "In a block an E would be another word.";
        example set!("G55 X1E3");
    "G1109" G52WithoutRotation Stop { edit: String }
        es "«{edit}»: G52 no tiene giro"
        en "'{edit}': G52 has no rotation"
        remedy "dé R a un sistema, como «G55 R30»", "give R to a system, as 'G55 R30'";
        why "LinuxCNC guarda un giro con cada sistema de G54 a G59.3, y ninguno con G52.",
            "LinuxCNC keeps a rotation with each system from G54 to G59.3, and none with G52.";
        example set!("G52 R30");
    "G1110" NotAnAxis Stop { edit: String, letter: char }
        es "«{edit}»: {letter} no es un eje"
        en "'{edit}': {letter} is no axis"
        remedy "los ejes son X Y Z A B C U V W; R es el giro", "axes are X Y Z A B C U V W; R is the rotation";
        why "LinuxCNC no guarda nada con esa letra.", "LinuxCNC keeps nothing under that letter.";
        example set!("G55 Q5");
    "G1111" AxisWithoutNumber Stop { edit: String, letter: char }
        es "«{edit}»: {letter} no tiene número"
        en "'{edit}': {letter} has no number"
        remedy "escriba el número junto a la letra, como {letter}-12.5", "write the number next to the letter, as {letter}-12.5";
        why "Un eje sin número no dice a dónde.", "An axis without a number does not say where.";
        example set!("G55 X");
    "G1112" OffsetNotANumber Stop { edit: String, text: String, letter: char }
        es "«{edit}»: «{text}» no es un número"
        en "'{edit}': '{text}' is not a number"
        remedy "escriba el número junto a la letra, como {letter}-12.5", "write the number next to the letter, as {letter}-12.5";
        why "Lo que no es un número no es una posición.", "What is no number is no position.";
        example set!("G55 X1.2.3");
    "G1113" OffsetWithComma Stop { edit: String, text: String, letter: char }
        es "«{edit}»: «{text}» no es un número"
        en "'{edit}': '{text}' is not a number"
        remedy "el separador decimal es el punto: {letter}1.5", "the decimal separator is the point: {letter}1.5";
        why "La coma podría separar decimales o millares.", "The comma might stand before decimals or between thousands.";
        example set!("G55 X2,5");
    "G1114" OffsetTooGreat Stop { edit: String, letter: char, text: String, most: f64 }
        es "«{edit}»: {letter}{text} pasa de ±{most}"
        en "'{edit}': {letter}{text} is beyond ±{most}"
        remedy "compruebe el número y la unidad", "check the number and the unit";
        why "Ningún programa lleva tal número, y ninguna máquina llega tan lejos.",
            "No program carries such a number, and no machine goes so far.";
        example set!("G55 X100000");
    "G1115" TooManyDecimals Stop { edit: String, letter: char, text: String, most: usize }
        es "«{edit}»: {letter}{text} tiene más decimales que los {most} del archivo"
        en "'{edit}': {letter}{text} has more decimals than the file's {most}"
        remedy "redondéelo", "round it";
        why "Lo que no cabe se perdería sin decirlo.", "What does not fit would be lost without a word.";
        example set!("G55 X0.1234567");
    "G1201" NoActiveSystemGiven Caution {}
        es "falta el parámetro 5220: el sistema activo es el 1, G54"
        en "parameter 5220 is missing: the active system is 1, G54"
        remedy "escriba en el parámetro 5220 el número del sistema activo, de 1 (G54) a 9 (G59.3)",
            "write the number of the active system into parameter 5220, 1 (G54) to 9 (G59.3)";
        why "La máquina arranca con el sistema que dice este parámetro.", "The machine starts with the system that this parameter names.";
        example file!("5221 5");
    "G1202" ActiveSystemNotOne Caution {}
        es "el parámetro 5220 no es un número entero de 1 a 9: se toma el sistema 1, G54, como dice el manual de LinuxCNC; su intérprete puede tomar la parte entera"
        en "parameter 5220 is no whole number from 1 to 9: system 1, G54, is taken, as LinuxCNC's manual says; its interpreter may take the whole part"
        remedy "escriba en el parámetro 5220 el número del sistema activo, de 1 (G54) a 9 (G59.3)",
            "write the number of the active system into parameter 5220, 1 (G54) to 9 (G59.3)";
        why "La máquina podría arrancar con otro sistema que el que aquí se toma.",
            "The machine might start with another system than the one taken here.";
        example file!("5220 2.5");
}
