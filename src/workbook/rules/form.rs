//! Sheets, symbols and lists: that a form is whole.

use super::{book, made};
use crate::finding::Key;
use crate::finding::rule::rules;
use crate::text::Text;

rules! {
    /// The rows of sheets, symbols and lists.
    RULES;

    "W0501" SheetMissing Stop { sheet: &'static str }
        es "falta la hoja \"{sheet}\""
        en "the sheet \"{sheet}\" is missing"
        remedy "si la hoja está con otro nombre, llámela \"{sheet}\"; si no, cópiela de un libro nuevo",
            "if the sheet is there under another name, call it \"{sheet}\"; if not, copy it from a new workbook";
        why "La hoja contiene valores que el cálculo necesita.", "The sheet holds values that the calculation needs.";
        example made!("no-tools", "un libro de torno sin su hoja HERRAMIENTAS", "a lathe workbook without its sheet TOOLS");
    "W0502" SheetWithoutCells Stop { sheet: String }
        es "la hoja \"{sheet}\" no tiene celdas"
        en "the sheet \"{sheet}\" has no cells"
        remedy "ábralo en Excel o LibreOffice, compruébelo y guárdelo de nuevo como .xlsx",
            "open it in Excel or LibreOffice, check it and save it again as .xlsx";
        why "Una hoja de gráfico o una hoja vacía no tiene valores.",
            "A chart sheet or an emptied sheet has no values.";
        example made!("chart", "un gráfico con el nombre DATOS", "a chart of the name DATA");
    "W0503" SheetHidden Note { sheet: String }
        es "la hoja \"{sheet}\" está oculta; rodete la lee igualmente"
        en "the sheet \"{sheet}\" is hidden; rodete reads it all the same"
        remedy "", "";
        why "Los valores de una hoja oculta cuentan como los demás.", "The values of a hidden sheet count like any others.";
        example made!("hidden", "un libro con la hoja DATOS oculta", "a workbook with the sheet DATA hidden");
    "W0504" FormulasRead Note { count: usize, first: Text }
        es "valores de entrada que son resultados de fórmulas: {count}{first}; rodete lee el valor guardado"
        en "input values that are results of formulas: {count}{first}; rodete reads the stored value"
        remedy "", "";
        why "Si el libro se guardó sin recalcular, el valor es antiguo.", "If the workbook was saved without recalculation, the value is old.";
        example made!("formula", "=20+5 con su valor guardado en la celda de R", "=20+5 with its value stored in the cell of R");
    "W0505" SheetNotFound Stop { wanted: Text, there: String }
        es "no se encuentra la hoja {wanted}; hay: {there}"
        en "sheet {wanted} not found; there are: {there}"
        remedy "si es la hoja de los datos con otro nombre, póngale uno de estos; si el libro no tiene formulario, póngalo con \"rodete new ... --into\", o parta de uno nuevo con \"rodete new\"",
            "if it is the sheet of the data under another name, give it one of these; if the workbook has no form, put one in with \"rodete new ... --into\", or start from a new workbook with \"rodete new\"";
        why "El nombre de esta hoja indica el tipo de libro.", "The name of this sheet tells the kind of workbook.";
        example made!("other-sheet", "un libro con una sola hoja, Sheet1", "a workbook with one sheet only, Sheet1");
    "W0506" SheetMisnamed Stop { wanted: Text, there: String, name: String, right: String }
        es "no se encuentra la hoja {wanted}; hay: {there}"
        en "sheet {wanted} not found; there are: {there}"
        remedy "cambie el nombre de la hoja \"{name}\" a \"{right}\"", "rename the sheet \"{name}\" to \"{right}\"";
        why "El nombre de esta hoja indica el tipo de libro.", "The name of this sheet tells the kind of workbook.";
        example made!("case", "un libro con la hoja Data", "a workbook with the sheet Data");
    "W0507" SheetNotRead Caution { name: String, right: &'static str }
        es "rodete no lee la hoja \"{name}\": su nombre no es \"{right}\""
        en "rodete does not read the sheet \"{name}\": its name is not \"{right}\""
        remedy "cambie el nombre de la hoja a \"{right}\" para que rodete la lea", "rename the sheet to \"{right}\" if rodete should read it";
        why "Los valores de esa hoja no cuentan.", "The values on that sheet do not count.";
        example made!("second-case", "un libro con la hoja Calibration", "a workbook with the sheet Calibration");
    "W0508" SheetAmbiguous Stop { names: String }
        es "no se sabe qué hoja leer: {names}"
        en "it is not clear which sheet to read: {names}"
        remedy "deje solo una de esas hojas, o cambie el nombre de las otras", "keep only one of these sheets, or rename the others";
        why "Sus valores pueden ser distintos.", "Their values may differ.";
        example made!("two-sheets", "un libro con las hojas DATA y DATOS", "a workbook with the sheets DATA and DATOS");
    "W0511" SchemaRowMissing Stop { symbol: Key, known: String }
        es "falta la fila \"{symbol}\", que indica el esquema del libro (rodete lee {known})"
        en "the row \"{symbol}\", which names the workbook's schema, is missing (rodete reads {known})"
        remedy "si la hoja es un formulario, cree un libro nuevo con \"rodete new\" y pase a él los valores; si es otra hoja suya, ponga un formulario en el libro con \"rodete new TIPO --into LIBRO\"",
            "if the sheet is a form, make a new workbook with \"rodete new\" and copy the values into it; if it is another sheet of yours, put a form into the workbook with \"rodete new KIND --into BOOK\"";
        why "El esquema fija qué significa cada símbolo.", "The schema fixes what each symbol means.";
        example book!("impeller", "schema:symbol" = "");
    "W0512" SchemaRowTwice Stop { symbol: Key }
        es "varias filas tienen el símbolo \"{symbol}\""
        en "several rows have the symbol \"{symbol}\""
        remedy "deje una sola fila \"{symbol}\"", "keep only one row \"{symbol}\"";
        why "No se sabe cuál de los esquemas vale.", "It is not clear which schema counts.";
        example book!("impeller", "part:symbol" = "schema");
    "W0513" SchemaEmpty Stop { symbol: Key, known: String }
        es "{symbol} está vacío; rodete lee {known}"
        en "{symbol} is empty; rodete reads {known}"
        remedy "cree un libro nuevo con \"rodete new\" y pase a él los valores",
            "make a new workbook with \"rodete new\" and copy the values into it";
        why "El esquema fija qué significa cada símbolo.", "The schema fixes what each symbol means.";
        example book!("impeller", "schema" = "");
    "W0514" OtherSchema Stop { symbol: Key, found: String, known: String }
        es "{symbol} es \"{found}\"; rodete lee {known}"
        en "{symbol} is \"{found}\"; rodete reads {known}"
        remedy "cree un libro nuevo con \"rodete new\" y pase a él los valores",
            "make a new workbook with \"rodete new\" and copy the values into it";
        why "En otra versión un mismo símbolo puede significar otra cosa.", "In another version the same symbol may mean something else.";
        example book!("impeller", "schema" = "rodete-impeller 3");
    "W0515" SymbolTwice Stop { symbol: Key, count: usize }
        es "{count} filas tienen el símbolo {symbol}"
        en "{count} rows have the symbol {symbol}"
        remedy "deje una sola fila {symbol}", "keep only one row {symbol}";
        why "No se sabe cuál de los valores vale.", "It is not clear which value counts.";
        example book!("impeller", "r:symbol" = "R");
    "W0516" RowMissing Stop { name: Text, symbol: Key, expected: Text }
        es "falta la fila {name}"
        en "the row {name} is missing"
        remedy "añada una fila con {symbol} en la columna A y {expected} en la columna C",
            "add a row with {symbol} in column A and {expected} in column C";
        why "El cálculo necesita este valor, y rodete no lo supone.", "The calculation needs this value, and rodete does not assume one.";
        example book!("impeller", "R:symbol" = "");
    "W0517" SymbolUnknown Note { symbol: String }
        es "el símbolo \"{symbol}\" no es de este formulario; rodete no lee su valor"
        en "the symbol \"{symbol}\" does not belong to this form; rodete does not read its value"
        remedy "", "";
        why "El valor de una fila añadida no cuenta.", "The value of an added row does not count.";
        example book!("impeller", "F_max:symbol" = "foo");
    "W0518" MoreSymbolsUnknown Note { count: usize }
        es "símbolos desconocidos que no se nombran: {count}"
        en "unknown symbols that are not named: {count}"
        remedy "", "";
        why "rodete nombra los primeros y no lee el valor de ninguno.", "rodete names the first ones and reads the value of none.";
        example made!("symbols", "un libro con 21 filas de símbolos desconocidos", "a workbook with 21 rows of unknown symbols");
    "W0519" InputsChanged Caution { inputs: String, programs: String, into: &'static str }
        es "datos cambiados desde que se hicieron los programas: {inputs}; no valen ya: {programs}"
        en "inputs changed since the programs were made: {inputs}; out of date: {programs}"
        remedy "vuelva a generar con \"rodete build{into}\"", "build again with \"rodete build{into}\"";
        why "Los programas de la carpeta cortan la pieza de los datos anteriores.",
            "The programs in the folder cut the part of the earlier inputs.";
        example made!("changed-results", "un libro de resultados con R cambiado", "a results workbook with R changed");
    "W0520" SheetsOfAnotherBuild Caution { sheets: String }
        es "estas hojas no son de la última generación del libro: {sheets}; sus cifras son de otra"
        en "these sheets are not of the workbook's last build: {sheets}; their figures are of another one"
        remedy "genere el libro otra vez; lo que sea copia, bórrelo o guárdelo en otro libro", "build the workbook again; delete what is a copy, or keep it in another workbook";
        why "Una copia de una hoja de resultados conserva las cifras del día en que se hizo.",
            "A copy of a sheet of results keeps the figures of the day that it was made.";
        example made!("copied-results", "un libro de resultados con una hoja copiada de otro, hecho con otro R",
            "a results workbook with a sheet copied from another one, made with another R");
    "W0521" NamesAstray Caution { names: String }
        es "nombres definidos borrados, o que llevan a otra celda: {names}; las hojas de resultados no encuentran esos datos"
        en "defined names that are deleted or lead to another cell: {names}; the sheets of results do not find these inputs"
        remedy "devuelva cada nombre a su celda, o vuelva a generar con \"rodete build\"", "give each name its cell again, or build again with \"rodete build\"";
        why "rodete lee los datos por su símbolo; las hojas de resultados los leen por estos nombres.",
            "rodete reads the inputs by their symbols; the sheets of results read them by these names.";
        example made!("lost-name", "un libro de resultados sin el nombre thickness_e", "a results workbook without the name thickness_e");
    "W0522" SheetPassedOver Caution { name: String, like: String }
        es "rodete no lee la hoja \"{name}\", que está hecha como \"{like}\""
        en "rodete does not read the sheet \"{name}\", which is laid out like \"{like}\""
        remedy "si es la que vale, borre la hoja \"{like}\" y dé a esta su nombre; si no, bórrela o guárdela en otro libro",
            "if it is the one that counts, delete the sheet \"{like}\" and give this one its name; if not, delete it or keep it in another workbook";
        why "rodete lee las hojas por su nombre: lo que se cambia en una copia no llega a ningún programa, y la línea de la copia habla de la hoja leída.",
            "rodete reads sheets by their names: what is changed on a copy gets into no program, and the line on the copy speaks of the sheet that is read.";
        example made!("copied-form", "un libro con la hoja DATOS (2), copia de DATOS", "a workbook with the sheet DATA (2), a copy of DATA");
    "W0523" SheetOfUnknownPlace Caution { name: String, like: Text }
        es "rodete no lee la hoja \"{name}\", que está hecha como {like}"
        en "rodete does not read the sheet \"{name}\", which is laid out like {like}"
        remedy "si es la que vale, decida a cuál de ellas sustituye, borre esa y dé a esta su nombre; si no, bórrela o guárdela en otro libro",
            "if it is the one that counts, decide which of them it replaces, delete that one and give this one its name; if not, delete it or keep it in another workbook";
        why "rodete lee las hojas por su nombre: lo que se cambia en otra no llega a ningún programa, y nada dice a cuál de varias hechas igual sustituye.",
            "rodete reads sheets by their names: what is changed on another gets into no program, and nothing says which of several with one layout it replaces.";
        example made!("third-program", "un libro de torno con la hoja PROGRAMA 3, hecha como PROGRAMA y PROGRAMA 2", "a lathe workbook with the sheet PROGRAM 3, laid out like PROGRAM and PROGRAM 2");
    "W0524" SheetUnderOtherName Caution { name: String, like: String }
        es "rodete no lee la hoja \"{name}\", que está hecha como \"{like}\""
        en "rodete does not read the sheet \"{name}\", which is laid out like \"{like}\""
        remedy "si es la que vale, llámela \"{like}\"; si no, bórrela o guárdela en otro libro",
            "if it is the one that counts, name it \"{like}\"; if not, delete it or keep it in another workbook";
        why "rodete lee las hojas por su nombre: lo que hay en una que se llama de otro modo no llega a ningún programa.",
            "rodete reads sheets by their names: what stands on one of another name gets into no program.";
        example made!("renamed-form", "un libro de torno con la hoja PROGRAMA 2 llamada PROGRAMA2", "a lathe workbook with the sheet PROGRAM 2 named PROGRAM2");
    "W0525" SymbolMistyped Stop { name: Text, cell: String, found: String, symbol: Key, expected: Text }
        es "falta la fila {name}"
        en "the row {name} is missing"
        remedy "corrija {cell}, que dice \"{found}\", a \"{symbol}\"; si esa fila es otra, añada una fila con {symbol} en la columna A y {expected} en la columna C",
            "correct {cell}, which says \"{found}\", to \"{symbol}\"; if that row is another one, add a row with {symbol} in column A and {expected} in column C";
        why "El cálculo necesita este valor, y rodete no lo supone.", "The calculation needs this value, and rodete does not assume one.";
        example book!("impeller", "R:symbol" = "RR");
    "W0601" HeadingsMissing Stop { first: Text }
        es "falta la fila de títulos, que empieza por \"{first}\" en la columna A"
        en "the row of headings, which begins with \"{first}\" in column A, is missing"
        remedy "escriba \"{first}\" en la columna A de los títulos", "write \"{first}\" in column A of the headings";
        why "Los títulos indican qué es cada columna.", "The headings tell what each column is.";
        example book!("lathe", "TOOLS!A5" = "Tool");
    "W0602" ListEmpty Stop {}
        es "bajo los títulos no hay ninguna fila"
        en "there are no rows below the headings"
        remedy "escriba al menos una fila", "write at least one row";
        why "El cálculo necesita al menos una fila de esta lista.", "The calculation needs at least one row of this list.";
        example made!("no-rows", "un libro de torno con la hoja HERRAMIENTAS sin filas", "a lathe workbook with the sheet TOOLS without rows");
    "W0603" ListTooLong Stop { count: usize, most: usize }
        es "la hoja tiene {count} filas; el máximo es {most}"
        en "the sheet has {count} rows; the maximum is {most}"
        remedy "quite filas, o repártalas en varios libros", "remove rows, or spread them over several workbooks";
        why "Una máquina o un programa no admite tantas filas: será un descuido.",
            "No machine or program takes so many rows: this is probably an oversight.";
        example made!("many-tools", "un libro de torno con más de 500 herramientas", "a lathe workbook with more than 500 tools");
    "W0604" HeadingUnknown Note { heading: String }
        es "rodete no lee \"{heading}\": no es de esta tabla"
        en "rodete does not read \"{heading}\": it does not belong to this table"
        remedy "", "";
        why "Una columna o una fila añadida no cuenta.", "An added column or row does not count.";
        example made!("heading", "un título «foo» en la hoja HERRAMIENTAS de un libro de torno", "a heading \"foo\" on the sheet TOOLS of a lathe workbook");
    "W0605" HeadingTwice Stop { heading: String }
        es "\"{heading}\" aparece dos veces"
        en "\"{heading}\" appears twice"
        remedy "deje un solo \"{heading}\"", "keep only one \"{heading}\"";
        why "No se sabe cuál de los dos vale.", "It is not clear which of the two counts.";
        example made!("heading-twice", "dos columnas T en la hoja HERRAMIENTAS de un libro de torno", "two columns T on the sheet TOOLS of a lathe workbook");
    "W0606" ColumnMissing Stop { column: Key }
        es "falta la columna \"{column}\""
        en "the column \"{column}\" is missing"
        remedy "escriba \"{column}\" en la fila de títulos", "write \"{column}\" in the row of headings";
        why "Sin esa columna faltaría un valor en cada fila.", "Without that column every row would lack a value.";
        example made!("no-column", "la hoja HERRAMIENTAS de un libro de torno sin el título Q_z", "the sheet TOOLS of a lathe workbook without the heading Q_z");
    "W0607" ColumnUnitEmpty Stop { column: Key, unit: &'static str, cell: String }
        es "{column} se da en {unit}, pero {cell} está vacía"
        en "{column} is given in {unit}, but {cell} is empty"
        remedy "convierta los valores a {unit} y escriba {unit} en {cell}",
            "convert the values to {unit} and write {unit} in {cell}";
        why "Si falta la unidad, los valores pueden estar en otra.",
            "Without the unit, the values may be in another one.";
        example made!("column-unit-empty", "la hoja HERRAMIENTAS de un libro de torno con la unidad de Q_z borrada",
            "the sheet TOOLS of a lathe workbook with the unit of Q_z cleared");
    "W0608" ColumnUnitOther Stop { column: Key, unit: &'static str, cell: String, written: String }
        es "{column} se da en {unit}, pero {cell} dice \"{written}\""
        en "{column} is given in {unit}, but {cell} says \"{written}\""
        remedy "convierta los valores a {unit} y escriba {unit} en {cell}",
            "convert the values to {unit} and write {unit} in {cell}";
        why "rodete compara las unidades y no las convierte: una pulgada leída como milímetro da otra pieza.",
            "rodete compares units and does not convert them: an inch read as a millimetre makes another part.";
        example made!("column-unit", "la hoja HERRAMIENTAS de un libro de torno con Q_z en inch", "the sheet TOOLS of a lathe workbook with Q_z in inch");
    "W0609" ColumnUnitWhereNone Stop { column: Key, cell: String, written: String }
        es "{column} no tiene unidad, pero {cell} dice \"{written}\""
        en "{column} has no unit, but {cell} says \"{written}\""
        remedy "vacíe la celda {cell}", "empty cell {cell}";
        why "Un número de herramienta no se mide en milímetros: los valores pueden ser de otra columna.",
            "A tool number is not measured in millimetres: the values may belong to another column.";
        example made!("column-unit-none", "la hoja HERRAMIENTAS de un libro de torno con T en mm", "the sheet TOOLS of a lathe workbook with T in mm");
}
