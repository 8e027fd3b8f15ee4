//! The values of parameters: what stands in their cells and beside them.

use super::{book, made};
use crate::finding::Typed;
use crate::finding::rule::rules;
use crate::text::Text;

rules! {
    /// The rows of values.
    RULES;

    "W0401" InsideMergedCells Stop { name: Text, range: String, corner: String, cell: String }
        es "{name}: su celda está dentro de las celdas combinadas {range}, cuyo valor está en {corner}"
        en "{name}: its cell is inside the merged cells {range}, whose value is in {corner}"
        remedy "separe las celdas {range} y escriba el valor en {cell}", "unmerge {range} and write the value in {cell}";
        why "En unas celdas combinadas solo la primera tiene valor.", "Only the first of the merged cells holds a value.";
        example made!("merged", "las celdas B7:C7 combinadas", "the cells B7:C7 merged");
    "W0402" FormulaNotCalculated Stop { name: Text, cell: String }
        es "{name}: {cell} tiene una fórmula sin valor guardado"
        en "{name}: {cell} holds a formula without a stored value"
        remedy "abra el libro en Excel o LibreOffice y guárdelo", "open the workbook in Excel or LibreOffice and save it";
        why "rodete lee el valor guardado con la fórmula, y aquí falta.",
            "rodete reads the value stored with the formula, and here there is none.";
        example book!("impeller", "R" = "=20+5");
    "W0403" ValueMissing Stop { name: Text, cell: String, expected: Text }
        es "falta {name}"
        en "{name} is missing"
        remedy "escriba en {cell} {expected}", "in {cell} write {expected}";
        why "El cálculo necesita este valor, y rodete no lo supone.", "The calculation needs this value, and rodete does not assume one.";
        example book!("impeller", "R" = "");
    "W0404" ValueIsError Stop { name: Text, error: String, cell: String, expected: Text }
        es "{name} es el error {error}"
        en "{name} is the error {error}"
        remedy "escriba en {cell} {expected}", "in {cell} write {expected}";
        why "La fórmula de la celda no dio ningún valor.", "The cell's formula gave no value.";
        example book!("impeller", "R" = "#DIV/0!");
    "W0405" ValueIsTruth Stop { name: Text, truth: Text, cell: String, expected: Text }
        es "{name} es el valor lógico {truth}"
        en "{name} is the truth value {truth}"
        remedy "escriba en {cell} {expected}", "in {cell} write {expected}";
        why "Verdadero podría leerse como 1, y rodete no lo adivina.", "True might be read as 1, and rodete does not guess.";
        example book!("impeller", "R" = "TRUE");
    "W0406" ValueIsDate Stop { name: Text, cell: String }
        es "{name}: su celda tiene formato de fecha"
        en "{name}: its cell is formatted as a date"
        remedy "dé a {cell} formato General y escriba de nuevo el valor",
            "set the format of {cell} to General and retype the value";
        why "La hoja guarda una fecha como días desde 1900: 3/4 sería un número de cinco cifras.",
            "A spreadsheet stores a date as days since 1900: 3/4 would be a five-digit number.";
        example made!("date", "una fecha en la celda de R", "a date in the cell of R");
    "W0407" LikelyRadians Caution { name: Text, angle: f64, degrees: f64 }
        es "{name} es {angle}°, muy pequeño para un ángulo en grados"
        en "{name} is {angle}°, very small for an angle in degrees"
        remedy "si {angle} son radianes, escriba {degrees}", "if {angle} is in radians, write {degrees}";
        why "El libro da los ángulos en grados; en radianes saldría otra pieza.",
            "The workbook gives angles in degrees; in radians another part would result.";
        example book!("impeller", "B_max" = "1.7453");
    "W0408" NotWhole Stop { name: Text, value: Typed, cell: String, expected: Text }
        es "{name} es {value} y debe ser un número entero"
        en "{name} is {value}; it must be a whole number"
        remedy "escriba en {cell} {expected}", "in {cell} write {expected}";
        why "No existe medio álabe ni medio punto, y rodete no redondea por usted.",
            "There is no half blade and no half point, and rodete does not round for you.";
        example book!("impeller", "n" = "39.5");
    "W0409" NumberFormattedAsText Stop { name: Text, text: String, number: String }
        es "{name} es el texto \"{text}\", no un número"
        en "{name} is the text \"{text}\", not a number"
        remedy "dé a la celda formato General, si lo tiene de texto, y escriba de nuevo {number}, con el signo decimal de su hoja de cálculo",
            "set the cell's format to General if it is Text, and retype {number}, with the decimal sign of your spreadsheet";
        why "Un texto no es un número aunque lo parezca: la hoja de cálculo tampoco lo usa como número.",
            "A text is not a number even if it looks like one: the spreadsheet does not treat it as one either.";
        example book!("impeller", "R" = "'12.5");
    "W0410" NumberWithMarks Stop { name: Text, text: String, number: String, unit: Text, sign: Text }
        es "{name} es el texto \"{text}\", no un número"
        en "{name} is the text \"{text}\", not a number"
        remedy "dé a la celda formato General, si lo tiene de texto, y escriba el número {number}{sign}, con el signo decimal de su hoja de cálculo{unit}",
            "set the cell's format to General if it is Text, and type the number {number}{sign}, with the decimal sign of your spreadsheet{unit}";
        why "rodete sugiere lo que parece querer decir, pero nunca lo toma por el valor.",
            "rodete suggests what you probably mean, but never takes it for the value.";
        example book!("impeller", "R" = "'12,5");
    "W0411" NumberOfTwoReadings Stop { name: Text, text: String, one: String, other: String, sign: Text }
        es "{name} es el texto \"{text}\", no un número"
        en "{name} is the text \"{text}\", not a number"
        remedy "dé a la celda formato General, si lo tiene de texto, y escriba el número {one} o {other}, según lo que quiera decir{sign}, con el signo decimal de su hoja de cálculo",
            "set the cell's format to General if it is Text, and type the number {one} or {other}, whichever is meant{sign}, with the decimal sign of your spreadsheet";
        why "La coma, el punto y el apóstrofo separan decimales en unos países y millares en otros.",
            "Comma, point and apostrophe separate decimals in some countries and thousands in others.";
        example book!("impeller", "R" = "'1,234");
    "W0412" NotANumber Stop { name: Text, text: String, example: String, sign: Text }
        es "{name} es el texto \"{text}\", no un número"
        en "{name} is the text \"{text}\", not a number"
        remedy "escriba un número, como {example}{sign}, con el signo decimal de su hoja de cálculo",
            "type a number, such as {example}{sign}, with the decimal sign of your spreadsheet";
        why "Con un texto no se puede calcular.", "A text cannot be used in a calculation.";
        example book!("impeller", "R" = "'0x10");
    "W0413" HiddenCharacters Caution { name: Text, text: String }
        es "{name} lleva caracteres invisibles: \"{text}\""
        en "{name} has invisible characters: \"{text}\""
        remedy "escriba el texto de nuevo sin ellos", "retype the text without them";
        why "El texto sale en el informe y en los programas, y un carácter invisible puede cambiarlo.",
            "The text goes into the report and the programs, where an invisible character may change it.";
        example book!("impeller", "part" = "a\u{202e}b");
    "W0414" NoSuchChoice Stop { name: Text, text: String, choices: Text, cell: String }
        es "{name} es \"{text}\" y debe ser {choices}"
        en "{name} is \"{text}\"; it must be {choices}"
        remedy "escriba en {cell} {choices}", "in {cell} write {choices}";
        why "Cada palabra de la lista elige un modo de cálculo; las demás, ninguno.",
            "Each word of the list selects a way to compute; others select none.";
        example book!("impeller", "style" = "pretty");
    "W0415" ChoiceMisspelt Stop { name: Text, text: String, choices: Text, label: Text }
        es "{name} es \"{text}\" y debe ser {choices}"
        en "{name} is \"{text}\"; it must be {choices}"
        remedy "¿quiere decir {label}?", "did you mean {label}?";
        why "rodete sugiere lo que parece querer decir, pero nunca lo toma por el valor.",
            "rodete suggests what you probably mean, but never takes it for the value.";
        example book!("impeller", "dialect" = "Fagor 8055");
    "W0545" ChoiceWithOddBlank Stop { name: Text, text: String, character: String, cell: String }
        es "{name} es \"{text}\" con un carácter que parece un espacio y no lo es ({character})"
        en "{name} is \"{text}\" with a character that looks like a blank and is none ({character})"
        remedy "escriba la palabra de nuevo en {cell}", "type the word anew in {cell}";
        why "Las fórmulas del libro no quitan ese carácter y calcularían otra cosa que rodete.",
            "The workbook's formulas do not drop that character and would compute something else than rodete.";
        example book!("impeller", "style" = "full\u{a0}");
    "W0416" WrongCode Stop { name: Text, wrong: String, cell: String, expected: Text }
        es "{name} lleva \"{wrong}\", que no es un código de máquina (M y un número entero)"
        en "{name} has \"{wrong}\", which is not a machine code (M and a whole number)"
        remedy "escriba en {cell} {expected}", "in {cell} write {expected}";
        why "rodete copia estos códigos tal cual en los programas.", "rodete copies these codes into the programs unchanged.";
        example book!("impeller", "start_codes" = "M3 X100");
    "W0417" WrongBlock Stop { name: Text, wrong: String, cell: String, expected: Text }
        es "{name} lleva \"{wrong}\"; solo admite códigos y X, Y, Z con su número, por este orden: G, ejes, M, y ningún eje giratorio"
        en "{name} has \"{wrong}\"; it allows only codes and X, Y, Z with their numbers, in this order: G, axes, M, and no rotary axis"
        remedy "escriba en {cell} {expected}", "in {cell} write {expected}";
        why "rodete copia este bloque tal cual en los programas, y la máquina lo ejecuta.",
            "rodete copies this block into the programs unchanged, and the machine runs it.";
        example book!("impeller", "retract" = "G0 B90");
    "W0418" UnitNotSaid Stop { name: Text, cell: String, unit: &'static str }
        es "{name}: la celda {cell} no indica la unidad; el valor se da en {unit}"
        en "{name}: cell {cell} does not give the unit; the value is in {unit}"
        remedy "compruebe que el valor está en {unit} y escriba {unit} en {cell}",
            "check that the value is in {unit} and write {unit} in {cell}";
        why "Si falta la unidad, el valor puede estar en otra.", "Without the unit, the value may be in another one.";
        example book!("impeller", "R:unit" = "");
    "W0419" UnitWhereNone Stop { name: Text, written: String, cell: String }
        es "{name} no tiene unidad, pero su celda de unidad dice \"{written}\""
        en "{name} has no unit, but its unit cell says \"{written}\""
        remedy "vacíe la celda {cell}", "empty cell {cell}";
        why "Un número de álabes no se mide en milímetros: el valor puede ser de otra fila.",
            "A number of blades is not measured in millimetres: the value may belong to another row.";
        example book!("impeller", "N:unit" = "mm");
    "W0420" OtherUnit Stop { name: Text, unit: &'static str, written: String, cell: String }
        es "{name} se da en {unit}, pero su celda de unidad dice \"{written}\""
        en "{name} is given in {unit}, but its unit cell says \"{written}\""
        remedy "convierta el valor a {unit} y escriba {unit} en {cell}", "convert the value to {unit} and write {unit} in {cell}";
        why "rodete compara las unidades y no las convierte: una pulgada leída como milímetro da otra pieza.",
            "rodete compares units and does not convert them: an inch read as a millimetre makes another part.";
        example book!("impeller", "R:unit" = "inch");
    "W0421" UnitNotRead Note { name: Text, written: String }
        es "{name} no tiene unidad; rodete no lee \"{written}\""
        en "{name} has no unit; rodete does not read \"{written}\""
        remedy "", "";
        why "Un texto o una palabra de una lista no tiene unidad.", "A text or a word from a list has no unit.";
        example book!("impeller", "part:unit" = "mm");
    "W0422" Percentage Caution { name: Text, read: Typed, shown: Typed }
        es "{name} está en una celda con formato de porcentaje: rodete lee {read}, pero la hoja muestra {shown}"
        en "{name} is in a cell formatted as a percentage: rodete reads {read}, but the sheet shows {shown}"
        remedy "dé a la celda formato General y compruebe el valor", "set the cell's format to General and check the value";
        why "Con ese formato, un 2 puede haberse guardado como 0.02.", "With that format a 2 may have been stored as 0.02.";
        example made!("percentage", "la celda de e con formato de porcentaje", "the cell of e formatted as a percentage");
    "W0423" TextTooLong Stop { name: Text, counted: Text, most: usize }
        es "{name} tiene {counted} caracteres"
        en "{name} is {counted} characters long"
        remedy "acórtelo a {most} caracteres", "shorten it to {most} characters";
        why "El texto debe caber en una línea del informe y en un comentario de cada programa.",
            "The text must fit on a line of the report and in a comment of every program.";
        example made!("long-text", "un nombre de pieza de 40000 letras", "a name of the part of 40000 letters");
    "W0424" OutOfLimits Stop { name: Text, value: Typed, min: Typed, max: Typed, cell: String, expected: Text }
        es "{name} es {value} y debe estar entre {min} y {max}"
        en "{name} is {value}; it must be from {min} to {max}"
        remedy "escriba en {cell} {expected}", "in {cell} write {expected}";
        why "Fuera de estos límites no existe tal pieza ni tal máquina.", "Beyond these limits no such part or machine exists.";
        example book!("impeller", "R" = "-25");
    "W0425" LikelyOtherUnit Stop { name: Text, value: Typed, min: Typed, max: Typed, meant: Text }
        es "{name} es {value} y debe estar entre {min} y {max}"
        en "{name} is {value}; it must be from {min} to {max}"
        remedy "¿quiere decir {meant}?", "did you mean {meant}?";
        why "En otra unidad el valor estaría dentro de los límites: quizá se midió en ella.",
            "In another unit the value would be within the limits: it may have been measured in that unit.";
        example book!("impeller", "R" = "0.025");
    "W0426" NumberInOtherUnit Stop { name: Text, text: String, unit: Text }
        es "{name} es el texto \"{text}\", no un número"
        en "{name} is the text \"{text}\", not a number"
        remedy "conviértalo y escriba solo el número; la unidad de la celda: {unit}", "convert it, and type the number alone; the unit of the cell: {unit}";
        why "Un número en otra unidad no es el de la celda, y rodete no adivina esa unidad.", "A number in another unit is not that of the cell, and rodete does not guess that unit.";
        example book!("impeller", "R" = "'12 kg");
    "W0540" NoSuchDay Stop { name: Text, text: String, cell: String }
        es "{name} es \"{text}\", un día que no existe en ningún calendario"
        en "{name} is \"{text}\", a day that no calendar has"
        remedy "escriba en {cell} un día que exista, como 2026-11-23, o vacíela", "in {cell} write a day that exists, such as 2026-11-23, or empty the cell";
        why "La fecha va en el informe tal como se escribió; con un día que no existe no se sabe de cuándo es.",
            "The report carries the date as it was typed; with a day that does not exist, its age is not known.";
        example book!("impeller", "date" = "'31/02/2026");
}
