//! Sheets, symbols and lists: that a form is whole.

use super::{book, made};
use crate::finding::rule::rules;
use crate::text::Text;

rules! {
    /// The rows of sheets, symbols and lists.
    RULES;

    "W0501" SheetMissing Stop { sheet: &'static str }
        es "falta la hoja \"{sheet}\""
        en "the sheet \"{sheet}\" is missing"
        remedy "añada la hoja \"{sheet}\" de un libro nuevo", "add the sheet \"{sheet}\" of a new workbook";
        why "En ella están valores que el cálculo necesita.", "It holds values that the calculation needs.";
        example made!("no-tools", "un libro de torno sin su hoja TOOLS", "a lathe workbook without its sheet TOOLS");
    "W0502" SheetWithoutCells Stop { sheet: String }
        es "la hoja \"{sheet}\" no tiene celdas"
        en "the sheet \"{sheet}\" has no cells"
        remedy "ábralo en Excel o LibreOffice, compruébelo y guárdelo de nuevo como .xlsx",
            "open it in Excel or LibreOffice, check it and save it again as .xlsx";
        why "Un gráfico, o una hoja de la que se borró todo, no tiene valores.",
            "A chart, or a sheet from which all was deleted, has no values.";
        example made!("chart", "un gráfico con el nombre DATA", "a chart of the name DATA");
    "W0503" SheetHidden Note { sheet: String }
        es "la hoja \"{sheet}\" está oculta; se lee igualmente"
        en "the sheet \"{sheet}\" is hidden; it is read all the same"
        remedy "", "";
        why "Los valores de una hoja que no se ve cuentan como los demás.", "The values of a sheet that is not seen count as others do.";
        example made!("hidden", "un libro con la hoja DATA oculta", "a workbook with the sheet DATA hidden");
    "W0504" FormulasRead Note { count: usize, first: Text }
        es "valores de entrada que son resultados de fórmulas: {count}{first}; se lee lo que la hoja de cálculo guardó"
        en "input values that are results of formulas: {count}{first}; what the spreadsheet stored is read"
        remedy "", "";
        why "Si se guardó sin recalcular, el valor es el de antes.", "Where it was saved without being recalculated, the value is that of before.";
        example made!("formula", "=20+5 con su valor guardado en la celda de R", "=20+5 with its value stored in the cell of R");
    "W0505" SheetNotFound Stop { wanted: Text, there: String }
        es "no se encuentra la hoja {wanted}; hay: {there}"
        en "sheet {wanted} not found; there are: {there}"
        remedy "parta de un libro nuevo con \"rodete new\"", "start from a new workbook with \"rodete new\"";
        why "Por el nombre de esta hoja se sabe qué clase de libro es.", "The name of this sheet tells what kind of workbook it is.";
        example made!("other-sheet", "un libro con una sola hoja, Sheet1", "a workbook with one sheet only, Sheet1");
    "W0506" SheetMisnamed Stop { wanted: Text, there: String, name: String, right: String }
        es "no se encuentra la hoja {wanted}; hay: {there}"
        en "sheet {wanted} not found; there are: {there}"
        remedy "cambie el nombre de la hoja \"{name}\" a \"{right}\"", "rename the sheet \"{name}\" to \"{right}\"";
        why "Por el nombre de esta hoja se sabe qué clase de libro es.", "The name of this sheet tells what kind of workbook it is.";
        example made!("case", "un libro con la hoja Data", "a workbook with the sheet Data");
    "W0507" SheetNotRead Caution { name: String, right: &'static str }
        es "la hoja \"{name}\" no se lee: su nombre no es \"{right}\""
        en "the sheet \"{name}\" is not read: its name is not \"{right}\""
        remedy "cambie su nombre a \"{right}\" para que se lea", "rename it to \"{right}\" to have it read";
        why "Lo que está escrito en ella no cuenta.", "What is written there does not count.";
        example made!("second-case", "un libro con la hoja Calibration", "a workbook with the sheet Calibration");
    "W0508" SheetAmbiguous Stop { names: String }
        es "no se sabe qué hoja leer: {names}"
        en "it is not clear which sheet to read: {names}"
        remedy "deje solo una de ellas, o cambie el nombre de las otras", "leave only one of them, or rename the others";
        why "Los valores de una y de otra pueden ser distintos.", "The values of one and the other may differ.";
        example made!("two-sheets", "un libro con las hojas DATA y DATOS", "a workbook with the sheets DATA and DATOS");
    "W0511" SchemaRowMissing Stop { symbol: &'static str, known: String }
        es "falta la fila \"{symbol}\", que dice el esquema del libro (aquí se lee {known})"
        en "the row \"{symbol}\", which names the workbook's schema, is missing (read here: {known})"
        remedy "cree un libro nuevo con \"rodete new\" y pase a él los valores",
            "make a new workbook with \"rodete new\" and copy the values into it";
        why "El esquema dice qué significa cada símbolo.", "The schema tells what each symbol means.";
        example book!("impeller", "schema:symbol" = "");
    "W0512" SchemaRowTwice Stop { symbol: &'static str }
        es "el símbolo \"{symbol}\" está en varias filas"
        en "the symbol \"{symbol}\" stands in several rows"
        remedy "deje una sola fila \"{symbol}\"", "leave one row \"{symbol}\" only";
        why "No se sabe cuál de los esquemas vale.", "Nobody knows which of the schemas holds.";
        example book!("impeller", "part:symbol" = "schema");
    "W0513" SchemaEmpty Stop { symbol: &'static str, known: String }
        es "{symbol} está vacío; aquí rodete lee {known}"
        en "{symbol} is empty; rodete reads {known} here"
        remedy "cree un libro nuevo con \"rodete new\" y pase a él los valores",
            "make a new workbook with \"rodete new\" and copy the values into it";
        why "El esquema dice qué significa cada símbolo.", "The schema tells what each symbol means.";
        example book!("impeller", "schema" = "");
    "W0514" OtherSchema Stop { symbol: &'static str, found: String, known: String }
        es "{symbol} es \"{found}\"; aquí rodete lee {known}"
        en "{symbol} is \"{found}\"; rodete reads {known} here"
        remedy "cree un libro nuevo con \"rodete new\" y pase a él los valores",
            "make a new workbook with \"rodete new\" and copy the values into it";
        why "En otra versión un mismo símbolo puede significar otra cosa.", "In another version the same symbol may mean something else.";
        example book!("impeller", "schema" = "rodete-impeller 3");
    "W0515" SymbolTwice Stop { symbol: &'static str, count: usize }
        es "el símbolo {symbol} está en {count} filas"
        en "the symbol {symbol} stands in {count} rows"
        remedy "deje una sola fila {symbol}", "leave one row {symbol} only";
        why "No se sabe cuál de los valores vale.", "Nobody knows which of the values holds.";
        example book!("impeller", "r:symbol" = "R");
    "W0516" RowMissing Stop { name: Text, symbol: &'static str, expected: Text }
        es "falta la fila de {name}"
        en "the row of {name} is missing"
        remedy "añada una fila con {symbol} en la columna A y {expected} en la columna C",
            "add a row with {symbol} in column A and {expected} in column C";
        why "Sin este valor no hay cálculo, y ninguno se supone.", "Without this value there is no calculation, and none is assumed.";
        example book!("impeller", "R:symbol" = "");
    "W0517" SymbolUnknown Note { symbol: String }
        es "el símbolo \"{symbol}\" no es de este formulario; su valor no se lee"
        en "the symbol \"{symbol}\" is not one of this form; its value is not read"
        remedy "", "";
        why "Quien añade una fila quizá crea que se lee.", "Whoever adds a row may believe that it is read.";
        example book!("impeller", "F_max:symbol" = "foo");
    "W0518" MoreSymbolsUnknown Note { count: usize }
        es "hay otros {count} símbolos desconocidos"
        en "there are {count} more unknown symbols"
        remedy "", "";
        why "Se nombran los primeros; de los demás no se lee ningún valor.", "The first are named; of the others no value is read.";
        example made!("symbols", "un libro con 21 filas de símbolos desconocidos", "a workbook with 21 rows of unknown symbols");
    "W0601" HeadingsMissing Stop { first: Text }
        es "falta la fila de títulos, que empieza por \"{first}\" en la columna A"
        en "the row of headings, which begins with \"{first}\" in column A, is missing"
        remedy "escriba \"{first}\" en la columna A de los títulos", "write \"{first}\" in column A of the headings";
        why "Por los títulos se sabe qué columna es cuál.", "The headings tell which column is which.";
        example book!("lathe", "TOOLS!A5" = "Tool");
    "W0602" ListEmpty Stop {}
        es "bajo los títulos no hay ninguna fila"
        en "there is no row below the headings"
        remedy "escriba al menos una fila", "write one row at least";
        why "De esta lista el cálculo necesita algo.", "The calculation needs something of this list.";
        example made!("no-rows", "un libro de torno con la hoja TOOLS sin filas", "a lathe workbook with the sheet TOOLS without rows");
    "W0603" ListTooLong Stop { count: usize, most: usize }
        es "la hoja tiene {count} filas y admite {most}"
        en "the sheet has {count} rows, must have {most} at most"
        remedy "reparta las filas", "spread the rows";
        why "Más filas de las que caben en una máquina o en un programa son un descuido.",
            "More rows than a machine or a program takes are an oversight.";
        example made!("many-tools", "un libro de torno con más de 500 herramientas", "a lathe workbook with more than 500 tools");
    "W0604" HeadingUnknown Note { heading: String }
        es "\"{heading}\" no se lee: no es de esta tabla"
        en "\"{heading}\" is not read: it is not of this table"
        remedy "", "";
        why "Quien añade una columna o una fila quizá crea que se lee.", "Whoever adds a column or a row may believe that it is read.";
        example made!("heading", "un título «foo» en la hoja TOOLS de un libro de torno", "a heading \"foo\" on the sheet TOOLS of a lathe workbook");
    "W0605" HeadingTwice Stop { heading: String }
        es "\"{heading}\" está dos veces"
        en "\"{heading}\" is given twice"
        remedy "deje un solo \"{heading}\"", "leave one \"{heading}\" only";
        why "No se sabe cuál de los dos vale.", "Nobody knows which of the two holds.";
        example made!("heading-twice", "dos columnas T en la hoja TOOLS de un libro de torno", "two columns T on the sheet TOOLS of a lathe workbook");
    "W0606" ColumnMissing Stop { column: &'static str }
        es "falta la columna \"{column}\""
        en "the column \"{column}\" is missing"
        remedy "escriba \"{column}\" en la fila de títulos", "write \"{column}\" in the row of headings";
        why "Sin ella faltaría un valor en cada fila.", "Without it a value would be missing in every row.";
        example made!("no-column", "la hoja TOOLS de un libro de torno sin el título Q_z", "the sheet TOOLS of a lathe workbook without the heading Q_z");
    "W0607" ColumnUnitEmpty Stop { column: &'static str, unit: &'static str, cell: String }
        es "{column} se da en {unit} y {cell} está vacía"
        en "{column} is given in {unit}, and {cell} is empty"
        remedy "convierta los valores a {unit} y escriba {unit} en {cell}",
            "convert the values to {unit} and write {unit} in {cell}";
        why "Quien borra la unidad puede haber escrito los valores en otra.",
            "Whoever clears the unit may have typed the values in another one.";
        example made!("column-unit-empty", "la hoja TOOLS de un libro de torno con la unidad de Q_z borrada",
            "the sheet TOOLS of a lathe workbook with the unit of Q_z cleared");
    "W0608" ColumnUnitOther Stop { column: &'static str, unit: &'static str, cell: String, written: String }
        es "{column} se da en {unit} y {cell} dice \"{written}\""
        en "{column} is given in {unit}, and {cell} says \"{written}\""
        remedy "convierta los valores a {unit} y escriba {unit} en {cell}",
            "convert the values to {unit} and write {unit} in {cell}";
        why "Las unidades se comparan y no se convierten: una pulgada leída como milímetro es otra pieza.",
            "Units are compared and not converted: an inch read as a millimetre is another part.";
        example made!("column-unit", "la hoja TOOLS de un libro de torno con Q_z en inch", "the sheet TOOLS of a lathe workbook with Q_z in inch");
    "W0609" ColumnUnitWhereNone Stop { column: &'static str, cell: String, written: String }
        es "{column} no tiene unidad y {cell} dice \"{written}\""
        en "{column} has no unit, and {cell} says \"{written}\""
        remedy "vacíe la celda {cell}", "empty cell {cell}";
        why "Un número de herramienta no va en milímetros: quizá los valores sean de otra columna.",
            "A tool's number is not in millimetres: the values may be those of another column.";
        example made!("column-unit-none", "la hoja TOOLS de un libro de torno con T en mm", "the sheet TOOLS of a lathe workbook with T in mm");
}
