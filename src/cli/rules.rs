//! What is told of a command line and of what stands around it: one row for each finding.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::t;

/// A command by itself, or over files: each its name and its lines, joined with `|`.
macro_rules! line {
    ($($word:literal)+) => {
        Example::Command { files: &[], words: &[$($word),+] }
    };
    ($($word:literal)+; $($name:literal = $text:literal),+) => {
        Example::Command { files: &[$(($name, $text)),+], words: &[$($word),+] }
    };
}

/// A folder that no text shows.
macro_rules! made {
    ($key:literal, $es:literal, $en:literal) => {
        Example::Made { key: $key, how: t($es, $en) }
    };
}

rules! {
    /// The rows of commands.
    RULES;

    "U0101" NoSuchCase Stop { kind: &'static str, case: String, cases: String }
        es "{kind} no tiene el caso {case}"
        en "{kind} has no case {case}"
        remedy "casos de {kind}: {cases}", "cases of {kind}: {cases}";
        why "Cada caso es un libro ya rellenado.", "Each case is a workbook filled in already.";
        example line!("new" "impeller" "--case" "shaft");
    "U0102" NotAWorkbookName Stop { path: String }
        es "{path} no es el nombre de un libro .xlsx"
        en "{path} is not the name of an .xlsx workbook"
        remedy "dé un nombre como rodete.xlsx", "give a name like impeller.xlsx";
        why "Excel no abre un libro con otra terminación.", "Excel does not open a workbook of another ending.";
        example line!("new" "impeller" "impeller.xls");
    "U0103" NotAPageName Stop { path: String }
        es "{path} no es el nombre de una página .html"
        en "{path} is not the name of an .html page"
        remedy "dé un nombre como rodete.html", "give a name like impeller.html";
        why "Con otra terminación ningún navegador la toma por página.", "With another ending no browser takes it for a page.";
        example line!("view" "part.nc" "-o" "part.txt"; "part.nc" = "G0 X1|M30");
    "U0111" NamedTwice Stop { path: String }
        es "{path} se da dos veces"
        en "{path} is given twice"
        remedy "dé cada libro una sola vez", "give every workbook once";
        why "Los resultados del segundo borrarían los del primero.", "The results of the second would wipe out those of the first.";
        example line!("build" "impeller.xlsx" "impeller.xlsx");
    "U0112" SameFile Stop { one: String, other: String }
        es "{one} y {other} son el mismo archivo"
        en "{one} and {other} are the same file"
        remedy "dé cada libro una sola vez", "give every workbook once";
        why "Los resultados del segundo borrarían los del primero.", "The results of the second would wipe out those of the first.";
        example line!("build" "impeller.xlsx" "./impeller.xlsx");
    "U0113" SameOutputs Stop { one: String, other: String }
        es "las salidas de {one} y {other} tendrían los mismos nombres"
        en "the outputs of {one} and {other} would have the same names"
        remedy "cambie el nombre de uno de los libros o constrúyalos en carpetas distintas",
            "rename one of the workbooks or build them into different folders";
        why "Un resultado borraría otro.", "One result would wipe out another.";
        example line!("build" "a.xlsx" "a.xlsm");
    "U0114" SameOutputsBeside Stop { one: String, other: String }
        es "las salidas de {one} y {other} tendrían los mismos nombres"
        en "the outputs of {one} and {other} would have the same names"
        remedy "cambie el nombre de uno de los dos o indique otra salida (opción -o)",
            "rename one of the two or name another output (option -o)";
        why "Junto a este archivo está otro cuyos resultados se llamarían igual: uno borraría los del otro.",
            "Beside this file stands another whose results would have the same names: one would wipe out the other's.";
        example line!("view" "a?.nc"; "a?.nc" = "G0 X1|M30", "a*.nc" = "G0 X2|M30");
    "U0115" LeftFromEarlier Caution { path: String }
        es "{path} queda de una construcción anterior y no pertenece a este conjunto"
        en "{path} is left from an earlier build and does not belong to this set"
        remedy "no lo use; bórrelo o apártelo", "do not use it; delete it or move it away";
        why "Un programa de antes podría tomarse por uno de este libro.", "A program of before might be taken for one of this workbook.";
        example made!("leftover", "una carpeta con un resultado que la construcción ya no escribe",
            "a folder with a result that the build does not write any more");
    "U0116" NotOpened Caution { path: String, reason: String }
        es "no se puede abrir {path}: {reason}"
        en "cannot open {path}: {reason}"
        remedy "ábralo usted; los archivos están escritos", "open it yourself; the files are written";
        why "Lo abre el escritorio, con el programa que tiene para ello.", "The desktop opens it, with the program that it has for it.";
        example Example::Never(t("depende del escritorio, no de la entrada", "it hangs on the desktop, not on the input"));
    "U0121" StockWithoutTurning Stop {}
        es "--stock vale para un programa de torno, no para esta entrada"
        en "--stock is for a turning program, not for this input"
        remedy "quite --stock, o indique el control con --dialect; el bruto de un libro está en su hoja DATOS",
            "leave --stock out, or name the control with --dialect; the stock of a workbook is on its sheet DATA";
        why "Solo en el torno se sigue el material que queda.", "Only on the lathe is the metal followed that is left.";
        example line!("view" "part.ngc" "--stock" "D50xL100"; "part.ngc" = "G0 X1|M30");
    "U0122" WorkbookInPlaceOfProgram Stop { path: String }
        es "{path} es un libro, no un programa"
        en "{path} is a workbook, not a program"
        remedy "constrúyalo con rodete build {path}, o indíquelo con --tools",
            "build it with rodete build {path}, or name it with --tools";
        why "Un libro lleva su programa en una hoja, junto a la máquina y las herramientas.",
            "A workbook carries its program on a sheet, beside the machine and the tools.";
        example made!("workbook-as-program", "simulate lathe.xlsx", "simulate lathe.xlsx");
    "U0123" StockAssumed Note { stock: String }
        es "el bruto no se ha indicado: se toma {stock}, que encierra el recorrido en avance"
        en "no stock given: {stock} is taken, which encloses the path at feed"
        remedy "", "";
        why "De otro bruto se quita otro material: la profundidad de corte y los avisos cambian.",
            "Of another stock other metal is taken: depth of cut and alarms change.";
        example line!("simulate" "part.nc"; "part.nc" = "G50 S2500|T0101|G97 S900 M3|G0 X54. Z2.|G1 X48. F0.2|Z-20.|X54.|G0 X100. Z50.|M30");
    "U0124" ExampleMachine Note {}
        es "sin --tools: máquina y torreta son las del libro de ejemplo (rodete new lathe)"
        en "no --tools: machine and turret are those of the example workbook (rodete new lathe)"
        remedy "", "";
        why "Otra máquina tiene otros recorridos, otro plato y otras herramientas.",
            "Another machine has other travels, another chuck and other tools.";
        example line!("simulate" "part.nc"; "part.nc" = "G50 S2500|T0101|G97 S900 M3|G0 X54. Z2.|G1 X48. F0.2|Z-20.|X54.|G0 X100. Z50.|M30");
    "U0125" SubprogramUnreadable Stop { name: String, reason: String }
        es "no se puede leer el subprograma {name}: {reason}"
        en "cannot read subprogram {name}: {reason}"
        remedy "compruebe el archivo", "check the file";
        why "Lo que hace el subprograma es parte de lo que hace el programa.",
            "What the subprogram does is part of what the program does.";
        example made!("large-subprogram", "un programa que llama a un subprograma de más de 64 MiB",
            "a program that calls a subprogram of more than 64 MiB");
    "U0126" LatheToolsForMill Stop { control: &'static str }
        es "--tools es un libro de torno, y el programa se lee como {control}"
        en "--tools is a lathe workbook, and the program is read as {control}"
        remedy "indique el control del torno con --dialect, o una tabla de herramientas de LinuxCNC",
            "name the lathe's control with --dialect, or a tool table of LinuxCNC";
        why "Una fresadora no tiene torreta: las longitudes y los radios de sus herramientas están en otra tabla.",
            "A milling machine has no turret: the lengths and radii of its tools are in another table.";
        example made!("lathe-tools", "verify part.ngc --tools lathe.xlsx --dialect linuxcnc", "verify part.ngc --tools lathe.xlsx --dialect linuxcnc");
    "U0127" ControlGuessed Note { control: &'static str }
        es "dialecto no indicado: leído como {control}"
        en "dialect not named: read as {control}"
        remedy "", "";
        why "Otro control lee de otro modo los mismos bloques.", "Another control reads the same blocks in another way.";
        example line!("verify" "part.ngc"; "part.ngc" = "G0 X1|M30");
    "U0131" NoPreamble Caution { parameters: String }
        es "no hay bloques G10: ningún programa lleva los valores de {parameters}"
        en "there are no G10 blocks: no program may carry the values of {parameters}"
        remedy "corrija los valores: de −99999.999 a 99999.999 mm o grados",
            "correct the values: −99999.999 to 99999.999 mm or degrees";
        why "Un programa lleva cinco cifras y tres decimales.", "A program carries five digits and three decimals.";
        example line!("offsets" "linuxcnc.var"; "linuxcnc.var" = "5220 1|5221 1000000");
    "U0132" ControlRunning Note {}
        es "si LinuxCNC está en marcha, al cerrarse escribe sus propios parámetros en el archivo: ciérrelo y repita"
        en "if LinuxCNC is running, it writes its own parameters over the file when it ends: close it and do this again"
        remedy "", "";
        why "LinuxCNC guarda el archivo entero al terminar.", "LinuxCNC saves the whole file when it ends.";
        example line!("offsets" "linuxcnc.var" "--set" "G55 X2"; "linuxcnc.var" = "5220 1");
    "U0141" NoSuchCode Stop { code: String }
        es "{code} no es un código de rodete"
        en "{code} is no code of rodete"
        remedy "rodete explain sin código los lista", "rodete explain without a code lists them";
        why "Un código es una letra y cuatro cifras, como W0424.", "A code is a letter and four digits, as W0424.";
        example line!("explain" "Z9999");
}
