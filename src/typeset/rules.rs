//! Findings about a document that typst was to set: one row each.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::{Text, t};

rules! {
    /// The rows of documents that are set.
    RULES;

    "T0101" NoTemporaryFolder Caution { document: Text, reason: Text }
        es "{document} no se ha podido componer: no se puede escribir en la carpeta temporal ({reason})"
        en "{document} could not be typeset: cannot write to the temporary folder ({reason})"
        remedy "libere espacio o indique otra carpeta temporal con la variable TMPDIR",
            "free some space, or name another temporary folder with the variable TMPDIR";
        why "rodete prepara en esa carpeta los archivos que lee el compilador.", "rodete prepares the compiler's input files in that folder.";
        example Example::Made { key: "no-tmpdir", how: t(
            "build con TMPDIR en una carpeta que no existe", "build with TMPDIR in a folder that does not exist") };
    "T0102" CompilerNotStarted Caution { document: Text, program: String, reason: Text, version: &'static str }
        es "{document} no se ha podido componer: no se puede ejecutar «{program}» ({reason})"
        en "{document} could not be typeset: cannot run '{program}' ({reason})"
        remedy "indique con --typst o RODETE_TYPST un typst {version}, o no dé ninguno para usar el incorporado",
            "name a typst {version} with --typst or RODETE_TYPST, or leave both out to use the built-in one";
        why "El programa typst compone los PDF.", "The program typst typesets the PDFs.";
        example Example::Made { key: "no-typst", how: t(
            "build --typst /nowhere/typst", "build --typst /nowhere/typst") };
    "T0103" CompilerFailed Caution { document: Text, program: String, how: Text, lines: String, version: &'static str }
        es "{document} no se ha podido componer: «{program}» {how}{lines}"
        en "{document} could not be typeset: '{program}' {how}{lines}"
        remedy "use typst {version}, o quite --typst y RODETE_TYPST para usar el incorporado; las hojas y los programas están completos",
            "use typst {version}, or drop --typst and RODETE_TYPST to use the built-in one; the sheets and programs are complete";
        why "Otra versión de typst interpreta las plantillas de otra manera.", "Another version of typst reads the templates differently.";
        example Example::Made { key: "false-typst", how: t(
            "build --typst con un programa que termina con error", "build --typst with a program that ends with an error") };
    "T0104" TemplateRefused Caution { document: Text, lines: String }
        es "{document} no se ha podido componer con sus plantillas propias:{lines}"
        en "{document} could not be typeset with templates of your own:{lines}"
        remedy "corrija el archivo en la línea indicada, o genere sin --templates; las hojas y los programas están completos",
            "correct the file at the named line, or build without --templates; the sheets and programs are complete";
        why "Delante de cada mensaje va el archivo con su línea y columna; kind/ es la carpeta del tipo de libro.",
            "In front of each message stand the file, its line and column; kind/ is the folder of the workbook's kind.";
        example Example::Made { key: "false-templates", how: t(
            "build --templates con una plantilla que typst rechaza", "build --templates with a template that typst rejects") };
    "T0105" TemplateEndless Caution { document: Text, seconds: f64 }
        es "{document} no se ha terminado en {seconds} s con sus plantillas propias"
        en "{document} was not finished within {seconds} s with templates of your own"
        remedy "busque en ellas un bucle o una lista muy larga, o genere sin --templates; las hojas y los programas están completos",
            "look for a loop or a very long list in them, or build without --templates; the sheets and programs are complete";
        why "rodete detiene el compilador si no termina.", "rodete stops the compiler if it does not end.";
        example Example::Made { key: "endless-templates", how: t(
            "build --templates con una plantilla que no termina", "build --templates with a template that does not end") };
    "T0106" BuiltInFailed Caution { document: Text, how: Text, lines: String }
        es "{document} no se ha podido componer: el compilador incorporado {how}{lines}"
        en "{document} could not be typeset: the built-in compiler {how}{lines}"
        remedy "si la máquina está muy ocupada o sin memoria, vuelva a generar; si no, es un fallo de rodete: comuníquelo; las hojas y los programas están completos",
            "if the machine is very busy or out of memory, build again; if not, this is a fault in rodete: report it; the sheets and programs are complete";
        why "Las plantillas son las de rodete, y su compilador las conoce.", "The templates are rodete's, and its compiler knows them.";
        example Example::Made { key: "false-built-in", how: t(
            "build en una máquina sin memoria", "build on a machine without memory") };
    "T0107" KindTemplateRefused Caution { document: Text, lines: String, version: &'static str }
        es "{document} no se ha podido componer con los archivos del tipo de libro:{lines}"
        en "{document} could not be typeset with the files of the workbook kind:{lines}"
        remedy "corrija el archivo de kind/ que nombra el mensaje; si el tipo es de rodete, use typst {version} o el incorporado; las hojas y los programas están completos",
            "correct the file of kind/ that the message names; if the kind is rodete's, use typst {version} or the built-in one; the sheets and programs are complete";
        why "En kind/ están los archivos que el tipo de libro aporta al informe: labels.typ, setup.typ, method-es.typ y method-en.typ.",
            "kind/ holds the files that the workbook kind brings to the report: labels.typ, setup.typ, method-es.typ and method-en.typ.";
        example Example::Made { key: "false-kind", how: t(
            "build de un tipo de libro propio a cuyo labels.typ le falta una palabra", "build of a workbook kind of your own whose labels.typ lacks a word") };
}
