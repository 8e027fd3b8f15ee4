//! Cells as they are written in a sheet's part, before their values are read.

use super::made;
use crate::finding::rule::rules;

rules! {
    /// The rows of cells as they are written.
    RULES;

    "W0301" CellsFarOut Note { cell: String }
        es "hay celdas rellenas lejos del formulario (la primera, {cell}): rodete no las lee"
        en "there are filled cells far from the form (the first is {cell}): rodete does not read them"
        remedy "", "";
        why "Un valor escrito tan lejos no cuenta.", "A value written so far away does not count.";
        example made!("far", "un valor en la celda XFD1048576", "a value in cell XFD1048576");
    "W0302" DimensionNotValid Stop { sheet: String }
        es "la hoja \"{sheet}\" está dañada: su extensión no es válida"
        en "the sheet \"{sheet}\" is damaged: its dimension is not valid"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "El lector reserva memoria para la extensión que declara la hoja.",
            "The reader reserves memory for the dimension that the sheet declares.";
        example made!("dimension", "una hoja con <dimension ref=\"ZZZZZZZZ9:A1\"/>", "a sheet with <dimension ref=\"ZZZZZZZZ9:A1\"/>");
    "W0303" ForeignElement Stop { sheet: String, element: String }
        es "la hoja \"{sheet}\" está dañada: el elemento {element} no corresponde a una hoja"
        en "the sheet \"{sheet}\" is damaged: the element {element} does not belong to a sheet"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Si sobra un elemento, no se sabe a qué celda pertenece cada valor.",
            "With an extra element it is not clear which value belongs to which cell.";
        example made!("foreign", "una hoja con un elemento <x/> entre las filas", "a sheet with an element <x/> among the rows");
    "W0304" CellsGivenTwice Stop { sheet: String }
        es "la hoja \"{sheet}\" está dañada: sus datos están repetidos"
        en "the sheet \"{sheet}\" is damaged: its cells are given twice"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Cada programa podría leer celdas distintas.", "Each program might read different cells.";
        example made!("cells-twice", "una hoja con dos <sheetData>", "a sheet with two <sheetData>");
    "W0305" MergedRangeNotValid Stop { sheet: String }
        es "la hoja \"{sheet}\" está dañada: una combinación de celdas no es válida"
        en "the sheet \"{sheet}\" is damaged: a range of merged cells is not valid"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Unas celdas combinadas pueden tapar un valor.", "Merged cells may hide a value.";
        example made!("merge-not-valid", "una hoja con <mergeCell ref=\"?\"/>", "a sheet with <mergeCell ref=\"?\"/>");
    "W0306" CellOutsideGrid Stop { address: String }
        es "hay una celda fuera de la hoja (\"{address}\"; la última es XFD1048576)"
        en "there is a cell outside the sheet grid (\"{address}\"; the last is XFD1048576)"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Ninguna hoja de cálculo tiene tal celda: la dirección es falsa.", "No spreadsheet has such a cell: the address is wrong.";
        example made!("outside-grid", "una hoja con la celda XFE200", "a sheet with the cell XFE200");
    "W0311" CellInOtherRow Stop { cell: String, row: u64 }
        es "la celda {cell} está escrita en la fila {row}"
        en "cell {cell} is written in row {row}"
        remedy "borre la celda {cell}, escriba de nuevo su valor y guarde el libro",
            "clear cell {cell}, retype its value and save the workbook";
        why "Cada programa podría ponerla en una fila distinta.", "Each program might put the cell in a different row.";
        example made!("other-row", "la celda A201 escrita en la fila 200", "cell A201 written in row 200");
    "W0312" CellGivenTwice Stop { cell: String }
        es "el archivo contiene dos veces la celda {cell}"
        en "the file contains cell {cell} twice"
        remedy "borre la celda {cell}, escriba de nuevo su valor y guarde el libro",
            "clear cell {cell}, retype its value and save the workbook";
        why "Cada programa podría leer un valor distinto.", "Each program might read a different value.";
        example made!("cell-twice", "la celda de R dos veces en el archivo", "the cell of R twice in the file");
    "W0313" CellNotSafelyRead Stop { cell: String }
        es "la celda {cell} está escrita de una forma que no se puede leer con seguridad"
        en "cell {cell} is written in a way that cannot be read safely"
        remedy "borre la celda {cell}, escriba de nuevo su valor y guarde el libro",
            "clear cell {cell}, retype its value and save the workbook";
        why "El lector tomaría solo parte del valor: 1&#50; sería 1.", "The reader would take only part of the value: 1&#50; would be 1.";
        example made!("reference", "1&#50; en la celda de R", "1&#50; in the cell of R");
    "W0314" NoSuchText Stop { cell: String, text: String, texts: usize }
        es "la celda {cell} remite al texto {text}, pero el libro solo tiene {texts}"
        en "cell {cell} refers to shared text {text}, but the workbook has only {texts}"
        remedy "borre la celda {cell}, escriba de nuevo su valor y guarde el libro",
            "clear cell {cell}, retype its value and save the workbook";
        why "La tabla de textos del libro no tiene ese número.",
            "The workbook's table of texts does not have that number.";
        example made!("no-text", "una celda con el texto 99999", "a cell with the text 99999");
    "W0315" NoTruthValue Stop { cell: String, value: String }
        es "la celda {cell} guarda \"{value}\" como valor lógico"
        en "cell {cell} holds \"{value}\" as a truth value"
        remedy "borre la celda {cell}, escriba de nuevo su valor y guarde el libro",
            "clear cell {cell}, retype its value and save the workbook";
        why "Un valor lógico es verdadero o falso.", "A truth value is true or false.";
        example made!("no-truth", "una celda con el valor lógico 2", "a cell with the truth value 2");
    "W0316" UnknownError Stop { cell: String, error: String }
        es "la celda {cell} contiene el error {error}"
        en "cell {cell} holds the error {error}"
        remedy "borre la celda {cell}, escriba de nuevo su valor y guarde el libro",
            "clear cell {cell}, retype its value and save the workbook";
        why "El lector no admite un error desconocido y dejaría la hoja entera sin leer.", "The reader does not accept an unknown error and would give up the whole sheet.";
        example made!("spill", "una celda con #SPILL!", "a cell with #SPILL!");
    "W0317" UnknownType Stop { cell: String, kind: String }
        es "la celda {cell} es de la clase desconocida {kind}"
        en "cell {cell} is of the unknown type {kind}"
        remedy "borre la celda {cell}, escriba de nuevo su valor y guarde el libro",
            "clear cell {cell}, retype its value and save the workbook";
        why "Sin la clase no se sabe si 25 es un número o el texto número 25.",
            "Without the type it is not clear whether 25 is a number or text number 25.";
        example made!("unknown-type", "una celda con t=\"q\"", "a cell with t=\"q\"");
    "W0318" NotFinite Stop { cell: String, value: String }
        es "la celda {cell} guarda {value}, que no es un número finito"
        en "cell {cell} holds {value}, which is not a finite number"
        remedy "borre la celda {cell}, escriba de nuevo su valor y guarde el libro",
            "clear cell {cell}, retype its value and save the workbook";
        why "Con NaN o infinito toda cuenta da NaN.", "With NaN or infinity every calculation gives NaN.";
        example made!("nan", "una celda con NaN", "a cell with NaN");
    "W0319" NotANumberInFile Stop { cell: String, value: String }
        es "la celda {cell} guarda \"{value}\" como número"
        en "cell {cell} stores \"{value}\" as a number"
        remedy "borre la celda {cell}, escriba de nuevo su valor y guarde el libro",
            "clear cell {cell}, retype its value and save the workbook";
        why "El archivo dice que es un número y no lo es: no lo escribió una hoja de cálculo.",
            "The file says that this is a number, but it is not: no spreadsheet wrote it.";
        example made!("abc", "una celda con abc guardado como número", "a cell with abc stored as a number");
}
