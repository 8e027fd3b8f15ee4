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
        en "{name}: its cell lies inside the merged cells {range}, whose value stands in {corner}"
        remedy "separe las celdas {range} y escriba el valor en {cell}", "unmerge {range} and write the value in {cell}";
        why "De unas celdas combinadas solo la primera tiene valor.", "Of merged cells only the first holds a value.";
        example made!("merged", "las celdas B7:C7 combinadas", "the cells B7:C7 merged");
    "W0402" FormulaNotCalculated Stop { name: Text, cell: String }
        es "{name}: {cell} tiene una fórmula sin valor guardado"
        en "{name}: {cell} holds a formula without a stored value"
        remedy "abra el libro en Excel o LibreOffice y guárdelo", "open the workbook in Excel or LibreOffice and save it";
        why "Se lee el valor que la hoja de cálculo guardó junto a la fórmula; aquí no lo hay.",
            "What is read is the value that the spreadsheet stored with the formula; here is none.";
        example book!("impeller", "R" = "=20+5");
    "W0403" ValueMissing Stop { name: Text, cell: String, expected: Text }
        es "{name} falta"
        en "{name} is missing"
        remedy "escriba en {cell} {expected}", "write {expected} in {cell}";
        why "Sin este valor no hay cálculo, y ninguno se supone.", "Without this value there is no calculation, and none is assumed.";
        example book!("impeller", "R" = "");
    "W0404" ValueIsError Stop { name: Text, error: String, cell: String, expected: Text }
        es "{name} es el error {error}"
        en "{name} is the error {error}"
        remedy "escriba en {cell} {expected}", "write {expected} in {cell}";
        why "La fórmula de la celda no dio ningún valor.", "The formula of the cell gave no value.";
        example book!("impeller", "R" = "#DIV/0!");
    "W0405" ValueIsTruth Stop { name: Text, truth: Text, cell: String, expected: Text }
        es "{name} es el valor lógico {truth}"
        en "{name} is the truth value {truth}"
        remedy "escriba en {cell} {expected}", "write {expected} in {cell}";
        why "Verdadero podría leerse como 1: se pide lo que se quiere decir.", "True might be read as 1: what is meant is asked for.";
        example book!("impeller", "R" = "TRUE");
    "W0406" ValueIsDate Stop { name: Text, cell: String }
        es "{name}: su celda tiene formato de fecha"
        en "{name}: its cell is formatted as a date"
        remedy "dé a {cell} formato General y escriba de nuevo el valor",
            "set the format of {cell} to General and type the value again";
        why "Una fecha se guarda como los días desde 1900: 3/4 sería un número de cinco cifras.",
            "A date is stored as the days since 1900: 3/4 would be a number of five digits.";
        example made!("date", "una fecha en la celda de R", "a date in the cell of R");
    "W0407" LikelyRadians Caution { name: Text, angle: f64, degrees: f64 }
        es "{name} es {angle}°, muy poco para un ángulo en grados"
        en "{name} is {angle}°, very little for an angle in degrees"
        remedy "si {angle} son radianes, escriba {degrees}", "if {angle} is in radians, write {degrees}";
        why "Los ángulos del libro van en grados; en radianes se calcularía otra pieza.",
            "Angles of the workbook are in degrees; in radians another part would be computed.";
        example book!("impeller", "B_max" = "1.7453");
    "W0408" NotWhole Stop { name: Text, value: Typed, cell: String, expected: Text }
        es "{name} es {value} y debe ser un número entero"
        en "{name} is {value}, must be a whole number"
        remedy "escriba en {cell} {expected}", "write {expected} in {cell}";
        why "Medio álabe o medio punto no existe, y no se redondea por usted.",
            "There is no half blade and no half point, and nothing is rounded for you.";
        example book!("impeller", "n" = "39.5");
    "W0409" NumberFormattedAsText Stop { name: Text, text: String, number: String }
        es "{name} es el texto \"{text}\", no un número"
        en "{name} is the text \"{text}\", not a number"
        remedy "la celda tiene formato de texto: dele formato General y escriba de nuevo {number}",
            "the cell is formatted as text: set its format to General and type {number} again";
        why "Un texto no es un número aunque lo parezca: la hoja de cálculo tampoco cuenta con él.",
            "A text is no number although it looks like one: the spreadsheet does not count with it either.";
        example book!("impeller", "R" = "'12.5");
    "W0410" NumberWithMarks Stop { name: Text, text: String, number: String, unit: Text, sign: Text }
        es "{name} es el texto \"{text}\", no un número"
        en "{name} is the text \"{text}\", not a number"
        remedy "escriba {number}{unit}{sign}", "use {number}{unit}{sign}";
        why "Lo que se quiso decir se sugiere, y nunca se toma por el valor.",
            "What was probably meant is suggested, and never taken for the value.";
        example book!("impeller", "R" = "'12,5");
    "W0411" NumberOfTwoReadings Stop { name: Text, text: String, one: String, other: String, sign: Text }
        es "{name} es el texto \"{text}\", no un número"
        en "{name} is the text \"{text}\", not a number"
        remedy "escriba {one} o {other}, según lo que quiera decir{sign}", "use {one} or {other}, whichever is meant{sign}";
        why "La coma separa decimales en unos países y millares en otros.",
            "The comma stands before decimals in some countries and between thousands in others.";
        example book!("impeller", "R" = "'1,234");
    "W0412" NotANumber Stop { name: Text, text: String, sign: Text }
        es "{name} es el texto \"{text}\", no un número"
        en "{name} is the text \"{text}\", not a number"
        remedy "escriba un número decimal con punto, como 12.5{sign}", "write a decimal number with a point, such as 12.5{sign}";
        why "Con un texto no se puede calcular.", "Nothing can be computed with a text.";
        example book!("impeller", "R" = "'0x10");
    "W0413" HiddenCharacters Caution { name: Text, text: String }
        es "{name} lleva caracteres que no se ven: \"{text}\""
        en "{name} has characters that are not seen: \"{text}\""
        remedy "escríbalo de nuevo sin ellos", "type it again without them";
        why "El texto sale en el informe y en los programas: lo que no se ve puede cambiar lo que se lee.",
            "The text goes into the report and the programs: what is not seen may change what is read.";
        example book!("impeller", "part" = "a\u{202e}b");
    "W0414" NoSuchChoice Stop { name: Text, text: String, choices: Text, cell: String }
        es "{name} es \"{text}\" y debe ser {choices}"
        en "{name} is \"{text}\", must be {choices}"
        remedy "escriba en {cell} {choices}", "write {choices} in {cell}";
        why "Cada palabra de la lista es un modo de calcular; las demás no dicen ninguno.",
            "Each word of the list is a way to compute; others name none.";
        example book!("impeller", "style" = "pretty");
    "W0415" ChoiceMisspelt Stop { name: Text, text: String, choices: Text, label: Text }
        es "{name} es \"{text}\" y debe ser {choices}"
        en "{name} is \"{text}\", must be {choices}"
        remedy "¿quiere decir {label}?", "did you mean {label}?";
        why "Lo que se quiso decir se sugiere, y nunca se toma por el valor.",
            "What was probably meant is suggested, and never taken for the value.";
        example book!("impeller", "dialect" = "Fagor 8055");
    "W0416" WrongCode Stop { name: Text, wrong: String, cell: String, expected: Text }
        es "{name} lleva \"{wrong}\", que no es un código de máquina (G o M y un número entero)"
        en "{name} has \"{wrong}\", which is not a machine code (G or M and a whole number)"
        remedy "escriba en {cell} {expected}", "write {expected} in {cell}";
        why "Estos códigos se copian en los programas tal como están.", "These codes are copied into the programs as they stand.";
        example book!("impeller", "start_codes" = "M3 X100");
    "W0417" WrongBlock Stop { name: Text, wrong: String, cell: String, expected: Text }
        es "{name} lleva \"{wrong}\", que no es un código o X, Y, Z con su número, por este orden: G, ejes, M; aquí no gira nada"
        en "{name} has \"{wrong}\", which is not a code or X, Y, Z with its number, in this order: G, axes, M; nothing turns here"
        remedy "escriba en {cell} {expected}", "write {expected} in {cell}";
        why "Este bloque se copia en los programas tal como está, y la máquina lo ejecuta.",
            "This block is copied into the programs as it stands, and the machine runs it.";
        example book!("impeller", "retract" = "G0 B90");
    "W0418" UnitNotSaid Stop { name: Text, cell: String, unit: &'static str }
        es "{name}: la celda {cell} no dice su unidad; se da en {unit}"
        en "{name}: cell {cell} does not say its unit; it is given in {unit}"
        remedy "compruebe que el valor está en {unit} y escriba {unit} en {cell}",
            "check that the value is in {unit} and write {unit} in {cell}";
        why "Quien borra la unidad puede haber escrito el valor en otra.", "Whoever clears the unit may have typed the value in another one.";
        example book!("impeller", "R:unit" = "");
    "W0419" UnitWhereNone Stop { name: Text, written: String, cell: String }
        es "{name} no tiene unidad y su celda de unidad dice \"{written}\""
        en "{name} has no unit, and its unit cell says \"{written}\""
        remedy "vacíe la celda {cell}", "empty cell {cell}";
        why "Un número de álabes no va en milímetros: quizá el valor sea de otra fila.",
            "A number of blades is not in millimetres: the value may be that of another row.";
        example book!("impeller", "N:unit" = "mm");
    "W0420" OtherUnit Stop { name: Text, unit: &'static str, written: String, cell: String }
        es "{name} se da en {unit} y su celda de unidad dice \"{written}\""
        en "{name} is given in {unit}, and its unit cell says \"{written}\""
        remedy "convierta el valor a {unit} y escriba {unit} en {cell}", "convert the value to {unit} and write {unit} in {cell}";
        why "Las unidades se comparan y no se convierten: una pulgada leída como milímetro es otra pieza.",
            "Units are compared and not converted: an inch read as a millimetre is another part.";
        example book!("impeller", "R:unit" = "inch");
    "W0421" UnitNotRead Note { name: Text, written: String }
        es "{name} no tiene unidad; \"{written}\" no se lee"
        en "{name} has no unit; \"{written}\" is not read"
        remedy "", "";
        why "Un texto o una palabra de una lista no se mide.", "A text or a word of a list is not measured.";
        example book!("impeller", "part:unit" = "mm");
    "W0422" Percentage Caution { name: Text, read: Typed, shown: Typed }
        es "{name} está en una celda con formato de porcentaje: se lee {read}, y la hoja muestra {shown} %"
        en "{name} stands in a cell formatted as a percentage: {read} is read, and the sheet shows {shown} %"
        remedy "dé a la celda formato General y compruebe el valor", "set its format to General and check the value";
        why "Con tal formato 2 puede haberse guardado como 0.02.", "In such a format 2 may have been stored as 0.02.";
        example made!("percentage", "la celda de e con formato de porcentaje", "the cell of e formatted as a percentage");
    "W0423" TextTooLong Stop { name: Text, counted: Text, most: usize }
        es "{name} tiene {counted} caracteres"
        en "{name} is {counted} characters long"
        remedy "acórtelo a {most} caracteres", "shorten it to {most} characters";
        why "El texto va en una línea del informe y en un comentario de cada programa.",
            "The text goes into a line of the report and a comment of every program.";
        example made!("long-text", "un nombre de pieza de 40000 letras", "a name of the part of 40000 letters");
    "W0424" OutOfLimits Stop { name: Text, value: Typed, min: Typed, max: Typed, cell: String, expected: Text }
        es "{name} es {value} y debe estar entre {min} y {max}"
        en "{name} is {value}, must be from {min} to {max}"
        remedy "escriba en {cell} {expected}", "write {expected} in {cell}";
        why "Fuera de estos límites la pieza o la máquina no existe.", "Beyond these limits there is no such part or machine.";
        example book!("impeller", "R" = "-25");
    "W0425" LikelyOtherUnit Stop { name: Text, value: Typed, min: Typed, max: Typed, meant: Text }
        es "{name} es {value} y debe estar entre {min} y {max}"
        en "{name} is {value}, must be from {min} to {max}"
        remedy "¿quiere decir {meant}?", "did you mean {meant}?";
        why "En otra unidad el valor estaría dentro de sus límites: quizá se midió en ella.",
            "In another unit the value would be within its limits: it may have been measured in that.";
        example book!("impeller", "R" = "0.025");
}
