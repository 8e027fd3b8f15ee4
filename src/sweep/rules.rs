//! What is found of a sheet of variants: one row each.

use crate::finding::rule::{book, rules};
use crate::finding::{Example, Key, Typed};
use crate::sweep::plan::Method;
use crate::text::{Text, t};

rules! {
    /// The rows of sweeps.
    RULES;

    "D0101" NoSweepSheet Stop { sheet: Text }
        es "el libro no tiene la hoja {sheet}"
        en "the workbook has no sheet {sheet}"
        remedy "póngala con rodete new, el tipo del libro y las opciones --sweep --into LIBRO", "put it in with rodete new, the kind of the workbook, and the options --sweep --into BOOK";
        why "La hoja dice qué entradas varían y cómo.", "The sheet says which inputs vary, and how.";
        example Example::Made { key: "sweep-without-sheet", how: t("rodete sweep impeller.xlsx, de un libro sin hoja BARRIDO", "rodete sweep impeller.xlsx, of a workbook without a sheet SWEEP") };
    "D0102" NothingVaries Stop { sheet: Text }
        es "la hoja {sheet} no dice qué entradas varían"
        en "the sheet {sheet} does not say which inputs vary"
        remedy "escriba una fila por entrada debajo de los encabezados input, from, to", "write one row for each input below the headings input, from, to";
        why "Sin entradas que varíen solo hay un diseño, y para eso está rodete build.", "Without inputs that vary there is one design only, and rodete build does that.";
        example book!("impeller", "SWEEP!A16" = "", "SWEEP!B16" = "", "SWEEP!C16" = "", "SWEEP!D16" = "", "SWEEP!A17" = "", "SWEEP!E17" = "",
            "SWEEP!A18" = "", "SWEEP!B18" = "", "SWEEP!C18" = "", "SWEEP!D18" = "", "SWEEP!A19" = "", "SWEEP!B19" = "", "SWEEP!C19" = "", "SWEEP!D19" = "");
    "D0103" NoSuchInput Stop { symbol: String }
        es "{symbol} no es una entrada de este libro"
        en "{symbol} is not an input of this workbook"
        remedy "escriba un símbolo de la columna A de la hoja de datos, con las mismas mayúsculas", "write a symbol from column A of the sheet of the data, with the same capitals";
        why "Las mayúsculas cuentan: N y n son dos entradas.", "Capitals matter: N and n are two inputs.";
        example book!("impeller", "SWEEP!A16" = "Q");
    "D0104" InputNotVaried Stop { symbol: Key }
        es "{symbol} es un texto y no puede variar"
        en "{symbol} is a text and cannot be varied"
        remedy "elija una entrada que sea un número o una palabra de una lista", "choose an input that is a number or a word of a list";
        why "De un texto no hay intervalo ni lista de palabras admitidas.", "A text has neither a range nor a list of allowed words.";
        example book!("impeller", "SWEEP!A16" = "part");
    "D0105" InputTwice Stop { symbol: Key }
        es "{symbol} está dos veces"
        en "{symbol} is there twice"
        remedy "deje una sola fila de esa entrada", "leave one row of this input";
        why "Una entrada tiene un solo valor en cada diseño.", "An input has one value in each design.";
        example book!("impeller", "SWEEP!A18" = "R", "SWEEP!B18" = "22", "SWEEP!C18" = "25");
    "D0106" RangeOrValues Stop { symbol: Key }
        es "{symbol} necesita desde y hasta, o una lista de valores, pero no ambas cosas"
        en "{symbol} needs from and to, or a list of values, and not both"
        remedy "rellene from y to, o values", "fill in from and to, or values";
        why "rodete no adivina qué valores se quieren.", "rodete does not guess which values are wanted.";
        example book!("impeller", "SWEEP!C16" = "");
    "D0107" RangeReversed Stop { symbol: Key, from: Typed, to: Typed }
        es "{symbol} va de {from} a {to}, y el segundo debe ser mayor"
        en "{symbol} goes from {from} to {to}, and the second must be the larger"
        remedy "intercambie los dos, o dé un solo valor en values", "swap the two, or give one value under values";
        why "Un intervalo va del menor al mayor.", "A range goes from the smaller to the larger value.";
        example book!("impeller", "SWEEP!B16" = "31");
    "D0108" WrongStep Stop { symbol: Key, step: Typed, range: Typed }
        es "el paso de {symbol} es {step}, y debe ser mayor que 0 y como mucho {range}"
        en "the step of {symbol} is {step}, and must be above 0 and at most {range}"
        remedy "corrija el paso", "correct the step";
        why "El paso va de un valor al siguiente dentro del intervalo.", "The step goes from one value to the next within the range.";
        example book!("impeller", "SWEEP!D16" = "10");
    "D0109" BeyondLimits Stop { symbol: Key, value: Typed, min: Typed, max: Typed }
        es "{symbol} llega a {value}, y el formulario admite de {min} a {max}"
        en "{symbol} reaches {value}, and the form allows {min} to {max}"
        remedy "quede dentro de lo que admite el formulario", "stay within what the form allows";
        why "Cada diseño se lee como si su valor estuviera en la celda de la entrada.", "Each design is read as if its value stood in the input's cell.";
        example book!("impeller", "SWEEP!B16" = "1");
    "D0110" ValueUnread Stop { symbol: Key, text: String, expected: Text }
        es "«{text}» no es un valor de {symbol}: debe ser {expected}"
        en "\"{text}\" is not a value of {symbol}: it must be {expected}"
        remedy "corrija el valor; los valores se separan con punto y coma, los decimales con punto", "correct the value; values are parted by semicolons, decimals by a point";
        why "Cada valor de la lista se lee como si estuviera en la celda de la entrada.", "Each value of the list is read as if it stood in the input's cell.";
        example book!("impeller", "SWEEP!E17" = "4; many");
    "D0111" RangeNotWhole Stop { symbol: Key, value: Typed }
        es "{symbol} es un número entero, y {value} no lo es"
        en "{symbol} is a whole number, and {value} is not"
        remedy "dé números enteros en desde, hasta y paso", "give whole numbers under from, to and step";
        why "Un número de álabes o de puntos no tiene decimales.", "A number of blades or of points has no decimals.";
        example book!("impeller", "SWEEP!E17" = "", "SWEEP!B17" = "4", "SWEEP!C17" = "6", "SWEEP!D17" = "0.5");
    "D0112" DistributionUnread Stop { text: String }
        es "«{text}» no es una distribución"
        en "\"{text}\" is not a distribution"
        remedy "escriba uniforme, o normal con media y desviación típica y los decimales con punto, como normal 2 0.05", "write uniform, or normal with mean and standard deviation, decimals with a point, such as normal 2 0.05";
        why "La distribución dice cómo se muestrea el intervalo.", "The distribution says how the range is sampled.";
        example book!("impeller", "SWEEP!C6" = "sobol", "SWEEP!C7" = "64", "SWEEP!D16" = "", "SWEEP!F16" = "gauss");
    "D0113" DistributionWithoutRange Stop { symbol: Key }
        es "{symbol} tiene una distribución, pero no un intervalo que se muestree"
        en "{symbol} has a distribution, but no range that is sampled"
        remedy "quite la distribución; o quite el paso y elija latino o sobol", "remove the distribution; or remove the step and choose latin or sobol";
        why "Con paso o con valores, cada uno cuenta lo mismo.", "With a step or with values each counts the same.";
        example book!("impeller", "SWEEP!F16" = "uniform");
    "D0114" StepNeeded Stop { symbol: Key }
        es "con method = factorial, {symbol} necesita un paso o una lista de valores"
        en "with method = factorial, {symbol} needs a step or a list of values"
        remedy "dé un paso, o elija latino o sobol", "give a step, or choose latin or sobol";
        why "Un plan factorial combina niveles, y un intervalo sin paso no tiene ninguno.", "A factorial plan combines levels, and a range without a step has none.";
        example book!("impeller", "SWEEP!D16" = "");
    "D0115" SamplesNeeded Stop { method: Method }
        es "con method = {method} falta samples, el número de diseños"
        en "with method = {method}, samples is missing: the number of designs"
        remedy "escriba cuántos diseños se quieren", "write how many designs are wanted";
        why "Un plan que muestrea no tiene un número de diseños propio.", "A plan that samples has no number of designs of its own.";
        example book!("impeller", "SWEEP!C6" = "sobol");
    "D0116" TooManyDesigns Stop { count: String, most: u64 }
        es "el plan tiene {count} diseños; rodete admite {most}"
        en "the plan has {count} designs; rodete allows {most}"
        remedy "dé menos niveles o pasos mayores, o elija sobol con menos diseños", "give fewer levels or larger steps, or choose sobol with fewer designs";
        why "Con más diseños los resultados ya no se pueden examinar.", "The results of more designs cannot be looked through.";
        example book!("impeller", "SWEEP!D16" = "0.000001");
    "D0117" TooManySampled Stop { count: usize, method: Method, most: usize }
        es "varían {count} entradas; {method} admite {most}"
        en "{count} inputs vary; {method} allows {most}"
        remedy "elija latino, o varíe menos entradas", "choose latin, or vary fewer inputs";
        why "La sucesión de Sobol tiene aquí esas dimensiones.", "The sequence of Sobol has so many dimensions here.";
        example Example::Made { key: "sweep-many-inputs", how: t("method = saltelli con 21 entradas", "method = saltelli with 21 inputs") };
    "D0118" ObjectiveUnread Stop { text: String }
        es "«{text}» no es un objetivo"
        en "\"{text}\" is not an objective"
        remedy "escriba una magnitud y min o max, separados por un espacio; entre objetivos, punto y coma", "write a measure and min or max, parted by a blank; between objectives, a semicolon";
        why "Un objetivo dice qué magnitud debe ser mínima o máxima.", "An objective says which measure is to be small or large.";
        example book!("impeller", "SWEEP!C10" = "time_s least");
    "D0119" NoSuchMeasure Stop { key: String, known: String }
        es "{key} no es una magnitud de este libro"
        en "{key} is not a measure of this workbook"
        remedy "elija una de estas: {known}", "choose one of these: {known}";
        why "Objetivos y restricciones se refieren a lo que rodete calcula de cada diseño.", "Objectives and constraints refer to what rodete computes of each design.";
        example book!("impeller", "SWEEP!C10" = "cost min");
    "D0120" MeasureAboveLevel Stop { key: &'static str }
        es "{key} solo se conoce cuando los programas se releen, y level es límites"
        en "{key} is known only after programs are read back, and level is limits"
        remedy "ponga level = programa, o elija otra magnitud", "set level = program, or choose another measure";
        why "Con level = límites rodete no relee ningún programa.", "With level = limits rodete reads no program back.";
        example book!("impeller", "SWEEP!C9" = "limits");
    "D0121" ConstraintUnread Stop { text: String }
        es "«{text}» no es una restricción"
        en "\"{text}\" is not a constraint"
        remedy "escriba una magnitud, >= o <=, y un número, como clearance_mm >= 0.5", "write a measure, >= or <=, and a number, such as clearance_mm >= 0.5";
        why "Una restricción es un límite para lo que rodete calcula de cada diseño.", "A constraint is a limit for what rodete computes of each design.";
        example book!("impeller", "SWEEP!C11" = "clearance_mm = 0.5");
    "D0122" NoDesignsSheet Stop { sheet: Text }
        es "con method = lista falta la hoja {sheet}, con un diseño en cada fila"
        en "with method = list, the sheet {sheet} is missing, with one design in each row"
        remedy "añada la hoja: en su primera fila los símbolos, debajo los valores", "add the sheet: symbols in its first row, values below";
        why "Una lista dice cada diseño por separado.", "A list states each design by itself.";
        example book!("impeller", "SWEEP!C6" = "list");
    "D0123" ListAndInputs Caution { sheet: Text }
        es "con method = lista no se leen las entradas de la hoja {sheet}"
        en "with method = list, the inputs on the sheet {sheet} are not read"
        remedy "bórrelas, o elija otro método", "delete them, or choose another method";
        why "Los diseños son los de la hoja de la lista.", "The designs are those on the sheet of the list.";
        example Example::Made { key: "sweep-list", how: t("method = lista con una hoja DISEÑOS y filas de entradas", "method = list with a sheet DESIGNS and rows of inputs") };
    "D0124" DesignCellEmpty Stop { symbol: Key }
        es "falta el valor de {symbol} en un diseño de la lista"
        en "a design of the list has no value of {symbol}"
        remedy "rellene la celda", "fill in the cell";
        why "Cada fila es un diseño completo.", "Each row is a whole design.";
        example Example::Made { key: "sweep-list-gap", how: t("una celda vacía en la hoja DISEÑOS", "an empty cell on the sheet DESIGNS") };
    "D0125" NothingExplained Stop {}
        es "con method = saltelli falta objectives"
        en "with method = saltelli, objectives is missing"
        remedy "escriba un objetivo, como time_s min", "write an objective, such as time_s min";
        why "El plan sirve para saber qué entrada explica la varianza de cada objetivo.", "The plan is there to show which input explains the variance of each objective.";
        example book!("impeller", "SWEEP!C6" = "saltelli", "SWEEP!C7" = "64", "SWEEP!C10" = "");
    "D0126" UnderNoSymbol Stop { column: String, row: u64 }
        es "la columna {column} tiene algo, y ningún símbolo en la fila {row}"
        en "column {column} holds something, and has no symbol in row {row}"
        remedy "escriba en esa fila el símbolo de la entrada, o vacíe la columna", "write the input's symbol in this row, or empty the column";
        why "Un valor sin símbolo no es de ninguna entrada: faltaría en su diseño.", "A value without a symbol belongs to no input: its design would lack it.";
        example Example::Made { key: "sweep-list-bare", how: t("un valor en la hoja DISEÑOS debajo de una celda vacía de la primera fila", "a value on the sheet DESIGNS below an empty cell of the first row") };
    "D0127" NoDesigns Stop { sheet: Text }
        es "la hoja {sheet} no tiene ningún diseño debajo de sus símbolos"
        en "the sheet {sheet} has no design below its symbols"
        remedy "escriba un diseño por fila: en su primera fila los símbolos, debajo los valores", "write one design a row: symbols in its first row, values below";
        why "Una lista sin diseños no es un plan.", "A list without designs is no plan.";
        example Example::Made { key: "sweep-list-empty", how: t("una hoja DISEÑOS con su fila de símbolos y nada más", "a sheet DESIGNS with its row of symbols and nothing else") };
    "D0128" DesignCellBeyond Stop { cell: String, last: String }
        es "{cell} queda fuera de las columnas de los diseños, que van de la A a la {last}"
        en "{cell} is beyond the columns of the designs, which are A to {last}"
        remedy "ponga los diseños en esas columnas, y nada más en la hoja; si varían más entradas, ponga en la hoja de datos las que tienen un solo valor", "put the designs into these columns, and nothing else on the sheet; if more inputs vary, put those with one value alone on the sheet of the data";
        why "rodete no lee lo que hay más allá, y un diseño no debe perder un valor.", "rodete does not read beyond, and a design must not lose a value.";
        example Example::Made { key: "sweep-list-wide", how: t("un valor en la columna AZ de la hoja DISEÑOS", "a value in column AZ of the sheet DESIGNS") };
    "D0129" DistributionElsewhere Stop { text: String }
        es "de «{text}» no hay casi nada entre desde y hasta: no se puede muestrear"
        en "almost nothing of \"{text}\" lies between from and to: it cannot be sampled"
        remedy "acerque el intervalo a la media, o escriba uniforme", "bring the range nearer to the mean, or write uniform";
        why "Lejos de la media queda tan poco que los diseños serían todos el mismo.", "Far from the mean so little is left that all designs would be the same one.";
        example book!("impeller", "SWEEP!C6" = "sobol", "SWEEP!C7" = "64", "SWEEP!D16" = "", "SWEEP!F16" = "normal 5000 1");
    "D0130" ObjectiveTwice Stop { key: &'static str }
        es "{key} es objetivo dos veces"
        en "{key} is an objective twice"
        remedy "deje una sola vez la magnitud, con min o con max", "leave the measure once, with min or with max";
        why "Una magnitud no puede ser a la vez mínima y máxima: todos los diseños estarían en el frente.", "A measure cannot be small and large at once: every design would be on the front.";
        example book!("impeller", "SWEEP!C10" = "time_s min; time_s max");
    "D0131" ValueTwice Stop { symbol: Key, text: String }
        es "«{text}» está dos veces entre los valores de {symbol}"
        en "\"{text}\" is twice among the values of {symbol}"
        remedy "deje cada valor una sola vez", "leave each value once";
        why "Los mismos diseños se calcularían y contarían dos veces.", "The same designs would be worked out and counted twice.";
        example book!("impeller", "SWEEP!E17" = "4; 5; 4");
    "D0132" SamplesUnread Caution { method: Method }
        es "con method = {method} no se lee samples"
        en "with method = {method}, samples is not read"
        remedy "vacíe la celda, o elija latino, sobol o saltelli", "empty the cell, or choose latin, sobol or saltelli";
        why "Cuántos diseños hay se sigue de los niveles, o de la lista.", "How many designs there are follows from the levels, or from the list.";
        example book!("impeller", "SWEEP!C7" = "64");
    "D0133" LastBeforeTo Caution { symbol: Key, last: Typed, to: Typed }
        es "el último valor de {symbol} es {last}: el paso no llega a {to}"
        en "the last value of {symbol} is {last}: the step does not meet {to}"
        remedy "cambie el paso o el extremo, si {to} debe estar en el plan", "change the step or the end, if {to} is to be in the plan";
        why "Los niveles son desde y un número entero de pasos.", "The levels are from, and a whole number of steps.";
        example book!("impeller", "SWEEP!D16" = "2");
    "D0134" LevelWithoutMeasures Stop {}
        es "con level = límites este libro no tiene ninguna magnitud"
        en "with level = limits, this workbook has no measure"
        remedy "ponga level = programa, o vacíe objectives y constraints", "set level = program, or empty objectives and constraints";
        why "De un programa que ya está escrito no se sabe nada antes de leerlo.", "Of a program that is written already nothing is known before it is read.";
        example book!("lathe", "SWEEP!C9" = "limits");

    "D0201" OtherPlan Stop { path: String }
        es "{path} contiene filas de otro plan de este libro, de otros valores en sus celdas, o de otra versión"
        en "{path} holds rows of another plan of this workbook, of other values in its cells, or of another version"
        remedy "elija otra carpeta (opción -o), o empiece de nuevo con --fresh", "choose another folder (option -o), or begin anew with --fresh";
        why "Las filas de dos planes no forman un resultado.", "Rows of two plans do not make one result.";
        example Example::Made { key: "sweep-other-plan", how: t("sweep --limit 2 en una carpeta con las filas de los tres diseños", "sweep --limit 2 into a folder with the rows of all three designs") };
    "D0202" OtherChunks Stop { path: String, chunks: u64 }
        es "el plan de {path} está dividido en {chunks} trozos"
        en "the plan in {path} is divided into {chunks} chunks"
        remedy "pida uno de esos trozos, o elija otra carpeta (opción -o)", "ask for one of these chunks, or choose another folder (option -o)";
        why "Dos divisiones de un plan no encajan.", "Two divisions of one plan do not fit together.";
        example Example::Made { key: "sweep-other-chunks", how: t("sweep --chunk 0/3 en una carpeta con el trozo 0/2", "sweep --chunk 0/3 into a folder with chunk 0/2") };
    "D0203" ChunksMissing Stop { list: String, missing: u64, chunks: u64 }
        es "trozos que faltan: {missing} de {chunks} ({list})"
        en "missing chunks: {missing} of {chunks} ({list})"
        remedy "calcule los que faltan: rodete sweep los completa en esta máquina, --submit slurm los envía", "work out those that are missing: rodete sweep completes them on this machine, --submit slurm submits them";
        why "El resumen tiene todas las filas del plan o no se escribe.", "The summary holds every row of the plan, or is not written.";
        example Example::Made { key: "sweep-missing", how: t("sweep --merge después de sweep --chunk 0/2", "sweep --merge after sweep --chunk 0/2") };
    "D0204" WrongChunk Stop { text: String }
        es "«{text}» no es un trozo"
        en "\"{text}\" is not a chunk"
        remedy "escriba I/N, con I de 0 a N - 1, como 0/40", "write I/N with I from 0 to N - 1, such as 0/40";
        why "Los trozos se cuentan desde 0, como los índices de Slurm.", "Chunks are counted from 0, as the indices of Slurm.";
        example Example::Command { files: &[], words: &["sweep", "impeller.xlsx", "--chunk", "40/40"] };
    "D0205" ChunkTorn Caution { path: String }
        es "{path} está incompleto o dañado: rodete lo calcula de nuevo"
        en "{path} is torn or damaged: rodete computes it again"
        remedy "compruebe el disco si se repite", "check the disk if this happens again";
        why "rodete escribe cada trozo entero o no lo escribe; algo lo cambió después.", "rodete writes a chunk whole or not at all; something changed it afterwards.";
        example Example::Made { key: "sweep-torn", how: t("un trozo al que le faltan los últimos bytes", "a chunk whose last bytes are missing") };
    "D0206" NoneDone Stop { designs: Text, count: u64, code: String, path: String }
        es "rodete rechaza {designs}; el motivo más frecuente es {code}"
        en "rodete rejects {designs}; the most frequent reason is {code}"
        remedy "lea la hoja POR_QUE de {path} y cambie los intervalos", "read the sheet WHY of {path} and change the ranges";
        why "Ninguno de los diseños probados se puede fabricar.", "None of the designs tried can be made.";
        example Example::Made { key: "sweep-none", how: t("un plan cuyos diseños se contradicen todos", "a plan whose designs all contradict themselves") };
    "D0207" FrontCut Caution { most: usize }
        es "el frente tiene más de {most} diseños; se marcan los primeros según el primer objetivo"
        en "the front has more than {most} designs; the first by the first objective are marked"
        remedy "dé menos objetivos, o restricciones", "give fewer objectives, or constraints";
        why "Un frente tan largo no distingue unos diseños de otros.", "So long a front does not tell designs apart.";
        example Example::Made { key: "given-front", how: t("un frente de 10001 diseños", "a front of 10001 designs") };
    "D0208" NoScheduler Stop { reason: Text }
        es "no se puede ejecutar sbatch: {reason}"
        en "sbatch cannot be run: {reason}"
        remedy "envíe los trozos desde un ordenador con Slurm; el guion sweep.sbatch ya está escrito", "submit from a computer that has Slurm; the script sweep.sbatch is written already";
        why "sbatch es el programa de Slurm que recibe los trabajos.", "sbatch is the program of Slurm that takes jobs.";
        example Example::Made { key: "sweep-no-slurm", how: t("sweep --submit slurm sin Slurm instalado", "sweep --submit slurm without Slurm installed") };
    "D0209" RejectedWhole Caution { rejected: usize, built: usize, code: String, path: String }
        es "rodete rechaza {rejected} de los {built} mejores diseños al generarlos enteros; el motivo más frecuente es {code}"
        en "rodete rejects {rejected} of the {built} best designs when it builds them whole; the most frequent reason is {code}"
        remedy "con level = límites, ponga level = programa, que los rechaza antes de elegir los mejores; la hoja MEJORES de {path} dice por qué cada uno", "with level = limits, set level = program, which rejects them before the best are chosen; the sheet TOP of {path} says why each one";
        why "Con level = límites rodete no relee ningún programa: no ve lo que solo un programa muestra, tampoco si corta otro álabe.", "With level = limits rodete reads no program back: it does not see what only a program shows, not even a cut into another blade.";
        example Example::Made { key: "sweep-rejected-whole", how: t("un barrido con level = límites de álabes tan gruesos que la herramienta corta el vecino", "a sweep with level = limits of blades so thick that the tool cuts the neighbour") };
    "D0210" OtherWorkbook Stop { path: String, other: String }
        es "{path} contiene filas de otro libro, {other}"
        en "{path} holds rows of another workbook, {other}"
        remedy "elija otra carpeta (opción -o)", "choose another folder (option -o)";
        why "Las filas de dos libros no caben en una carpeta, y --fresh solo borra lo que dejó este.", "The rows of two workbooks do not fit into one folder, and --fresh removes what this one left alone.";
        example Example::Made { key: "sweep-other-workbook", how: t("sweep --fresh en una carpeta con las filas de otro libro", "sweep --fresh into a folder with the rows of another workbook") };
    "D0211" ChangedSince Stop { path: String }
        es "{path} no es de un barrido, o cambió desde que rodete lo escribió: el barrido lo sustituiría o borraría"
        en "{path} is not of a sweep, or was changed after rodete wrote it: the sweep would replace or remove it"
        remedy "muévalo a otra carpeta y repita el comando: rodete conserva lo ya calculado y sigue; o elija otra carpeta (opción -o)", "move it to another folder and run the command again: rodete keeps what is worked out and goes on; or choose another folder (option -o)";
        why "Los mejores diseños están para editarlos, y un libro del usuario no se pierde por repetir un barrido.", "The best designs are there to be edited, and repeating a sweep must not cost you a workbook.";
        example Example::Made { key: "sweep-changed-since", how: t("sweep en la carpeta de un barrido cuyo mejor diseño se editó", "sweep into the folder of a sweep whose best design was edited") };
    "D0212" NamesInCase Note { one: String, other: String, renamed: String }
        es "las columnas {one} y {other} difieren solo en las mayúsculas: para DuckDB {other} es {renamed}"
        en "the columns {one} and {other} differ in their capitals only: to DuckDB {other} is {renamed}"
        remedy "en DuckDB, vea los nombres con DESCRIBE y escriba {renamed}", "in DuckDB, see the names with DESCRIBE, and write {renamed}";
        why "DuckDB no distingue mayúsculas en los nombres: con {other} daría sin aviso los valores de {one}.", "DuckDB does not tell capitals in names apart: for {other} it would give the values of {one}, without a word.";
        example Example::Made { key: "sweep-names-in-case", how: t("un barrido en que varían N y n", "a sweep in which N and n vary") };
}
