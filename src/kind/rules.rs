//! Findings about the programs of every kind of workbook: one row each.

use crate::finding::Example;
use crate::finding::rule::{book, rules};
use crate::text::{Text, t};

/// No workbook brings it about.
macro_rules! code {
    () => {
        Example::Never(t(
            "solo lo provoca el código de un tipo de libro, no un libro",
            "only the code of a workbook kind causes it, no workbook",
        ))
    };
}

rules! {
    /// The rows of every kind.
    RULES;

    "C1001" PositionOutOfFormat Stop { position: f64, parameters: Text }
        es "la posición {position} no cabe en un programa (cinco cifras y tres decimales)"
        en "position {position} does not fit into a program (five digits and three decimals)"
        remedy "compruebe {parameters}", "check {parameters}";
        why "El control lee cinco cifras antes del punto y perdería las demás.",
            "The control reads five digits before the point and would lose the rest.";
        example Example::Made {
            key: "given-far",
            how: t("una X_e de 150 m que no viene de un libro: los límites de las celdas la impiden",
                "an X_e of 150 m that comes from no workbook: the limits of the cells prevent it"),
        };
    "P1028" NotNumbered Note { greatest: u32 }
        es "los bloques van sin número: pasarían de N{greatest}"
        en "the blocks have no numbers: they would exceed N{greatest}"
        remedy "", "";
        why "El control se para en un número con demasiadas cifras.", "The control stops at a number with too many digits.";
        example book!("impeller --case full", "dialect" = "linuxcnc", "start_codes" = "M3", "retract" = "", "block_step" = "1000");
    "X0008" ColumnsUneven Stop { table: &'static str, column: Text, count: usize, rows: usize }
        es "fallo del tipo de libro: la columna «{column}» de la tabla {table} tiene {count} valores, y la primera columna {rows}"
        en "fault in the workbook kind: column \"{column}\" of table {table} has {count} values, and the first column {rows}"
        remedy fault "quien escribe el tipo: en tables() o lines(), dé a cada columna un valor por fila",
            "the kind's author: in tables() or lines(), give every column one value a row";
        why "A la tabla le faltarían filas o celdas.", "The table would lack rows or cells.";
        example code!();
    "X0009" QuantityNotFinite Stop { symbol: &'static str }
        es "fallo del tipo de libro: el valor calculado {symbol} no es finito"
        en "fault in the workbook kind: the derived value {symbol} is not finite"
        remedy fault "quien escribe el tipo: rechace en design() o model() los valores que llevan ahí",
            "the kind's author: in design() or model(), reject the values that lead there";
        why "NaN e infinito no son una medida, y ninguna hoja los admite.",
            "NaN and infinity are no measure, and no sheet takes them.";
        example code!();
    "X0010" NoProgramWritten Stop {}
        es "fallo del tipo de libro: no ha escrito ningún programa ni ha dicho por qué"
        en "fault in the workbook kind: it wrote no program, and did not say why"
        remedy fault "quien escribe el tipo: en programs(), entregue al menos un programa, o devuelva la parada que lo impide",
            "the kind's author: in programs(), hand over at least one program, or return the stop that prevents it";
        why "Una carpeta sin programas parecería un trabajo terminado.", "A folder without programs would look like finished work.";
        example code!();
    "X0011" ProgramNotListed Stop { program: &'static str, listed: String }
        es "fallo del tipo de libro: el programa {program} no está entre los de su formulario: {listed}"
        en "fault in the workbook kind: program {program} is not among those of its form: {listed}"
        remedy fault "quien escribe el tipo: añada la clave a Form::programs, o corrija la del programa",
            "the kind's author: add the key to Form::programs, or correct that of the program";
        why "Por esa lista se sabe qué archivos son de rodete.", "That list tells which files are rodete's.";
        example code!();
    "X0012" ProgramTwice Stop { program: &'static str }
        es "fallo del tipo de libro: dos programas tienen la clave {program}"
        en "fault in the workbook kind: two programs have the key {program}"
        remedy fault "quien escribe el tipo: dé a cada programa su propia clave, y póngala en Form::programs",
            "the kind's author: give each program a key of its own, and list it in Form::programs";
        why "Los dos irían al mismo archivo.", "Both would go to the same file.";
        example code!();
    "X0013" NothingDue Stop { program: &'static str }
        es "fallo del tipo de libro: al programa {program} no se le exige ninguna comprobación"
        en "fault in the workbook kind: no check is due for program {program}"
        remedy fault "quien escribe el tipo: en due(), dé las claves de las comprobaciones de sus jueces",
            "the kind's author: in due(), name the keys of the checks that its judges make";
        why "Un programa que nadie juzga no está verificado.", "A program that nobody judges is not verified.";
        example code!();
    "X0014" ProgramsForOtherControl Stop { control: &'static str, programs: &'static str }
        es "fallo del tipo de libro: dice que sus programas son para {control}, y los ha escrito para {programs}"
        en "fault in the workbook kind: it says that its programs are for {control}, and wrote them for {programs}"
        remedy fault "quien escribe el tipo: en control(), devuelva el control del Writer",
            "the kind's author: in control(), return the control of the Writer";
        why "El resumen y el informe nombrarían otro control.", "The summary and the report would name another control.";
        example code!();
    "X0015" CodeTwice Stop { code: &'static str, one: Text, other: Text }
        es "el código {code} es de dos mensajes: {one} y {other}"
        en "code {code} belongs to two findings: {one} and {other}"
        remedy fault "quien escribe el tipo: dé a los mensajes de sus rules.rs otros códigos; para los tipos de fuera de rodete es la letra K",
            "the kind's author: give the findings of its rules.rs other codes; the letter of kinds outside rodete is K";
        why "Por su código, explain contaría otro mensaje.", "By its code, explain would tell another finding.";
        example code!();
    "X0016" CodeWithoutRoom Stop { code: &'static str, letters: String }
        es "el código {code} no es una de las letras {letters} y cuatro cifras"
        en "code {code} is not one of the letters {letters} and four digits"
        remedy fault "quien escribe el tipo: dé un código como K0001; para los tipos de fuera de rodete es la letra K",
            "the kind's author: give a code like K0001; the letter of kinds outside rodete is K";
        why "La letra dice de qué trata un código.", "The letter says what a code is about.";
        example code!();
}
