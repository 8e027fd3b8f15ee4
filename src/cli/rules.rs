//! Findings about a command line and of what stands around it: one row each.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::{Text, t};

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
        remedy "elija uno de los casos de {kind}: {cases}", "choose a case of {kind}: {cases}";
        why "Cada caso es un libro ya rellenado.", "Each case is a workbook already filled in.";
        example line!("new" "impeller" "--case" "shaft");
    "U0102" NotAWorkbookName Stop { path: String }
        es "{path} no es el nombre de un libro .xlsx"
        en "{path} is not the name of an .xlsx workbook"
        remedy "dé un nombre como rodete.xlsx", "give a name like impeller.xlsx";
        why "Excel no abre un libro con otra extensión.", "Excel does not open a workbook with another extension.";
        example line!("new" "impeller" "impeller.xls");
    "U0103" NotAPageName Stop { path: String }
        es "{path} no es el nombre de una página .html"
        en "{path} is not the name of an .html page"
        remedy "dé un nombre como rodete.html", "give a name like impeller.html";
        why "Un navegador no reconoce una página con otra extensión.", "A browser does not recognise a page with another extension.";
        example line!("view" "part.nc" "-o" "part.txt"; "part.nc" = "G0 X1|M30");
    "U0111" NamedTwice Stop { path: String }
        es "{path} se da dos veces"
        en "{path} is given twice"
        remedy "dé cada libro una sola vez", "give each workbook once";
        why "Los resultados del segundo sobrescribirían los del primero.", "The second set of results would overwrite the first.";
        example line!("build" "impeller.xlsx" "impeller.xlsx");
    "U0112" SameFile Stop { one: String, other: String }
        es "{one} y {other} son el mismo archivo"
        en "{one} and {other} are the same file"
        remedy "dé cada libro una sola vez", "give each workbook once";
        why "Los resultados del segundo sobrescribirían los del primero.", "The second set of results would overwrite the first.";
        example line!("build" "impeller.xlsx" "./impeller.xlsx");
    "U0113" SameOutputs Stop { one: String, other: String }
        es "las salidas de {one} y {other} tendrían los mismos nombres"
        en "the outputs of {one} and {other} would have the same names"
        remedy "cambie el nombre de uno de los libros o constrúyalos en carpetas distintas",
            "rename one of the workbooks or build them into different folders";
        why "Un resultado sobrescribiría el otro.", "One result would overwrite the other.";
        example line!("build" "a.xlsx" "a.xlsm");
    "U0114" SameOutputsBeside Stop { one: String, other: String }
        es "las salidas de {one} y {other} tendrían los mismos nombres"
        en "the outputs of {one} and {other} would have the same names"
        remedy "cambie el nombre de uno de los dos o indique otra salida (opción -o)",
            "rename one of the two or name another output (option -o)";
        why "En la misma carpeta hay otro archivo cuyos resultados se llamarían igual, y se sobrescribirían.",
            "Another file in this folder has results of the same names, and one set would overwrite the other.";
        example line!("view" "a?.nc"; "a?.nc" = "G0 X1|M30", "a*.nc" = "G0 X2|M30");
    "U0115" LeftFromEarlier Caution { path: String }
        es "{path} queda de una vez anterior y no es de este juego"
        en "{path} is left from an earlier build and does not belong to this set"
        remedy "no lo use; bórrelo o apártelo", "do not use it; delete it or move it away";
        why "Alguien podría tomar un programa anterior por uno de este libro.", "An old program could be mistaken for one of this workbook.";
        example made!("leftover", "una carpeta con un resultado que build ya no escribe",
            "a folder with a result that the build does not write any more");
    "U0116" NotOpened Caution { path: String, reason: Text }
        es "no se puede abrir {path}: {reason}"
        en "cannot open {path}: {reason}"
        remedy "ábralo usted; los archivos están escritos", "open it yourself; the files are written";
        why "El escritorio abre el archivo con su programa predeterminado.", "The desktop opens the file with its default program.";
        example made!("no-desktop", "build --open en un sistema sin xdg-open", "build --open on a system without xdg-open");
    "U0117" OtherKind Stop { one: String, kind: &'static str, other: String, other_kind: &'static str }
        es "{one} es un libro de {kind} y {other} de {other_kind}"
        en "{one} is a workbook of {kind}, {other} of {other_kind}"
        remedy "compare dos libros del mismo tipo", "compare two workbooks of one kind";
        why "Los libros de dos tipos no tienen las mismas entradas.", "Workbooks of two kinds do not have the same inputs.";
        example made!("two-kinds", "compare impeller.xlsx lathe.xlsx", "compare impeller.xlsx lathe.xlsx");
    "U0118" BookInTheWay Stop { path: String }
        es "{path} es otro libro: la comparación lo sustituiría"
        en "{path} is another workbook: the comparison would replace it"
        remedy "dé otro nombre con -o", "give another name with -o";
        why "Puede ser un diseño; rodete solo sustituye una comparación anterior.",
            "It may be a design; rodete replaces nothing but an earlier comparison.";
        example made!("compare-over-book", "compare a.xlsx b.xlsx -o c.xlsx, y c.xlsx es de rodete new", "compare a.xlsx b.xlsx -o c.xlsx where c.xlsx is of rodete new");
    "U0121" StockWithoutTurning Stop { option: &'static str }
        es "{option} vale para un programa de torno, no para esta entrada"
        en "{option} is for a turning program, not for this input"
        remedy "quite {option}, o indique el control con --dialect; un libro da su bruto en la hoja DATOS",
            "leave out {option}, or name the control with --dialect; a workbook gives its stock on the sheet DATA";
        why "rodete simula el material que queda solo en el torno.", "rodete simulates the remaining metal only on the lathe.";
        example line!("view" "part.ngc" "--stock" "D50xL100"; "part.ngc" = "G0 X1|M30");
    "U0122" WorkbookInPlaceOfProgram Stop { path: String }
        es "{path} es un libro, no un programa"
        en "{path} is a workbook, not a program"
        remedy "genérelo con rodete build {path}; con un programa de torno, indíquelo con --tools",
            "build it with rodete build {path}; with a lathe program, name it with --tools";
        why "Un libro lleva su programa en una hoja, con la máquina y las herramientas.",
            "A workbook holds its program on a sheet, with the machine and the tools.";
        example made!("workbook-as-program", "simulate lathe.xlsx", "simulate lathe.xlsx");
    "U0123" StockAssumed Note { stock: String }
        es "no se ha indicado el bruto: rodete toma {stock}, que contiene todo el recorrido en avance"
        en "no stock given: rodete takes {stock}, which encloses all motions at feed"
        remedy "", "";
        why "Con otro bruto cambian la profundidad de pasada y las alarmas.",
            "With other stock the depth of cut and the alarms change.";
        example line!("simulate" "part.nc"; "part.nc" = "G50 S2500|T0101|G97 S900 M3|G0 X54. Z2.|G1 X48. F0.2|Z-20.|X54.|G0 X100. Z50.|M30");
    "U0124" ExampleMachine Note { tailstock: Text }
        es "sin --tools: rodete toma la máquina y la torreta del libro de ejemplo (rodete new lathe), {tailstock}, y la barra ya refrentada, con la cara en Z0: la demasía de una barra aserrada va en L5 de un libro de torno (--tools)"
        en "no --tools: rodete takes the machine and turret of the example workbook (rodete new lathe), {tailstock}, and the bar already faced, its face at Z0: the allowance of a sawn bar goes into L5 of a lathe workbook (--tools)"
        remedy "", "";
        why "Su máquina puede tener otros recorridos, otro plato y otras herramientas. Una barra aserrada sobresale de Z0: allí rodete no ve metal si no conoce L5.",
            "Your machine may have other travels, another chuck and other tools. A sawn bar stands proud of Z0: there rodete sees no metal unless it knows L5.";
        example line!("simulate" "part.nc"; "part.nc" = "G50 S2500|T0101|G97 S900 M3|G0 X54. Z2.|G1 X48. F0.2|Z-20.|X54.|G0 X100. Z50.|M30");
    "U0125" SubprogramUnreadable Stop { name: String, reason: Text }
        es "no se puede leer el subprograma {name}: {reason}"
        en "cannot read subprogram {name}: {reason}"
        remedy "compruebe el archivo", "check the file";
        why "El subprograma es parte del programa.",
            "The subprogram is part of the program.";
        example made!("large-subprogram", "un programa que llama a un subprograma de más de 64 MiB",
            "a program that calls a subprogram of more than 64 MiB");
    "U0126" LatheToolsForMill Stop { control: &'static str }
        es "--tools es un libro de torno, pero el programa se lee como {control}"
        en "--tools is a lathe workbook, but the program is read as {control}"
        remedy "indique el control del torno con --dialect, o dé una tabla de herramientas de LinuxCNC",
            "name the lathe's control with --dialect, or give a LinuxCNC tool table";
        why "Una fresadora no tiene torreta: las longitudes y los radios de sus herramientas van en otra clase de tabla.",
            "A mill has no turret: its tool lengths and radii are in another kind of table.";
        example made!("lathe-tools", "verify part.ngc --tools lathe.xlsx --dialect linuxcnc", "verify part.ngc --tools lathe.xlsx --dialect linuxcnc");
    "U0127" ControlGuessed Note { control: &'static str }
        es "dialecto no indicado: rodete lee el programa como {control}"
        en "no dialect given: rodete reads the program as {control}"
        remedy "", "";
        why "Otro control lee los mismos bloques de otra manera.", "Another control reads the same blocks differently.";
        example line!("verify" "part.ngc"; "part.ngc" = "G0 X1|M30");
    "U0128" WorkbookUnchanged Note { workbook: String }
        es "generado con {workbook}, que no ha cambiado; los bloques del programa no se comparan con él"
        en "made from {workbook}, which has not changed; the blocks of the program are not compared with it"
        remedy "", "";
        why "El programa lleva la suma SHA-256 de su libro, y el libro todavía la tiene.",
            "The program carries the SHA-256 of its workbook, and the workbook still has it.";
        example line!("verify" "a.ngc";
            "a.ngc" = "(WORKBOOK A.XLSX)|(SHA-256 73CB3858A687A8494CA3323053016282)|(        F3DAD39D42CF62CA4E79DDA2AAC7D9AC)|G0 X1|M2", "a.xlsx" = "x");
    "U0129" WorkbookChanged Caution { workbook: String }
        es "{workbook} ha cambiado desde que se generó este programa"
        en "{workbook} has changed since this program was made"
        remedy "genere los programas de nuevo con rodete build", "build the programs again with rodete build";
        why "El programa corta la pieza de antes del cambio.", "The program cuts the part as it was before the change.";
        example line!("verify" "a.ngc";
            "a.ngc" = "(WORKBOOK A.XLSX)|(SHA-256 0123456789ABCDEF0123456789ABCDEF)|(        0123456789ABCDEF0123456789ABCDEF)|G0 X1|M2",
            "a.xlsx" = "x");
    "U0130" WorkbookNotThere Note { workbook: String }
        es "generado con {workbook}, que no está junto al programa ni en la carpeta de encima: rodete no sabe si ha cambiado"
        en "made from {workbook}, which is neither beside the program nor in the folder above: rodete does not know whether it has changed"
        remedy "", "";
        why "rodete busca el libro con el nombre que lleva el programa, sin distinguir mayúsculas.",
            "rodete looks for the workbook by the name in the program; capitals do not matter.";
        example line!("verify" "a.ngc";
            "a.ngc" = "(WORKBOOK A.XLSX)|(SHA-256 0123456789ABCDEF0123456789ABCDEF)|(        0123456789ABCDEF0123456789ABCDEF)|G0 X1|M2");
    "U0131" NoPreamble Caution { parameters: String }
        es "no se escriben bloques G10: no admiten los valores de {parameters}"
        en "no G10 blocks are written: they cannot hold the values of {parameters}"
        remedy "corrija los valores: el margen es de -99999.999 a 99999.999 mm o grados",
            "correct the values: the range is -99999.999 to 99999.999 mm or degrees";
        why "Un número de un programa tiene cinco cifras y tres decimales.", "A number in a program has five digits and three decimals.";
        example line!("offsets" "linuxcnc.var"; "linuxcnc.var" = "5220 1|5221 1000000");
    "U0132" ControlRunning Note {}
        es "si LinuxCNC está en marcha, sobrescribe el archivo al cerrarse: ciérrelo y repita el comando"
        en "if LinuxCNC is running, it overwrites the file when it closes: close it and repeat the command"
        remedy "", "";
        why "LinuxCNC guarda el archivo entero al cerrarse.", "LinuxCNC saves the whole file when it closes.";
        example line!("offsets" "linuxcnc.var" "--set" "G55 X2"; "linuxcnc.var" = "5220 1");
    "U0133" NothingMoves Caution {}
        es "el programa no hace ningún movimiento: no hay nada que comprobar en él"
        en "the program makes no motion: there is nothing in it to verify"
        remedy "compruebe que el programa completo está en el archivo", "check that the whole program is in the file";
        why "Un archivo cortado se lee sin errores hasta donde llega.", "A file that was cut off reads without errors as far as it goes.";
        example line!("verify" "part.ngc"; "part.ngc" = "G21 G90|M2");
    "U0134" ToolsTurnedOver Note {}
        es "el programa gira el husillo solo con M4: rodete toma las herramientas del ejemplo montadas para ese giro y no busca la alarma 154"
        en "the program turns the spindle with M4 alone: rodete takes the example's tools as mounted for it and does not look for alarm 154"
        remedy "", "";
        why "Con las herramientas del ejemplo tal como están, ese programa daría la alarma 154 en cada corte.",
            "With the example's tools as they are, this program would raise alarm 154 at every cut.";
        example line!("simulate" "part.nc"; "part.nc" = "G50 S2500|T0101|G97 S900 M4|M8|G0 X54. Z2.|G1 X48. F0.2|Z-20.|X54.|G0 X100. Z50.|M30");
    "U0136" MillingProgram Stop {}
        es "es un programa de fresado: simulate lee programas de torno"
        en "this is a milling program: simulate reads turning programs"
        remedy "compruébelo con rodete verify o véalo con rodete view; si es de un torno, indique su control con --dialect",
            "use rodete verify or rodete view; if it is for a lathe, name its control with --dialect";
        why "Leído como el de un torno, sus palabras serían otras y no cortaría nada.", "Read as a lathe's, its words would be others, and it would cut nothing.";
        example line!("simulate" "plate.nc"; "plate.nc" = "G21 G90 G17|T1 M6|G43 H1|G0 X10 Y10|M30");
    "U0141" NoSuchCode Stop { code: String, near: Text }
        es "{code} no es un código de rodete{near}"
        en "{code} is not a rodete code{near}"
        remedy "ejecute rodete explain, que lista los códigos", "run rodete explain, which lists the codes";
        why "Un código es una letra y cuatro cifras, como W0424.", "A code is a letter and four digits, like W0424.";
        example line!("explain" "Z9999");
    "U0142" OutputNotWritten Stop { reason: Text }
        es "no se puede escribir en la salida estándar: {reason}"
        en "cannot write to standard output: {reason}"
        remedy "compruebe adónde va la salida: el disco puede estar lleno", "check where the output goes: the disk may be full";
        why "El texto de la salida estándar se ha perdido; los archivos se escriben aparte.",
            "The text on standard output was lost; files are written separately.";
        example Example::Made { key: "stdout-full", how: t("rodete explain > /dev/full", "rodete explain > /dev/full") };
}
