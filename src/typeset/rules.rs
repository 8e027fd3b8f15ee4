//! What is told of a document that typst was to set: one row for each finding.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::{Text, t};

rules! {
    /// The rows of documents that are set.
    RULES;

    "T0101" NoTemporaryFolder Caution { document: Text, reason: String }
        es "{document} no se ha podido componer: la carpeta temporal no admite escritura ({reason})"
        en "{document} could not be typeset: the temporary folder cannot be written ({reason})"
        remedy "libere espacio o indique otra carpeta temporal con la variable TMPDIR",
            "free some space, or name another temporary folder with the variable TMPDIR";
        why "El compilador lee lo que se le deja en una carpeta propia.", "The compiler reads what is left for it in a folder of its own.";
        example Example::Made { key: "no-tmpdir", how: t(
            "build con TMPDIR en una carpeta que no existe", "build with TMPDIR in a folder that does not exist") };
    "T0102" CompilerNotStarted Caution { document: Text, program: String, reason: String, version: &'static str }
        es "{document} no se ha podido componer: no se puede ejecutar «{program}» ({reason})"
        en "{document} could not be typeset: cannot run '{program}' ({reason})"
        remedy "indique con --typst o RODETE_TYPST un typst {version}, o ninguno para usar el incorporado",
            "name a typst {version} with --typst or RODETE_TYPST, or none to use the built-in one";
        why "Los PDF los compone el programa typst.", "The PDFs are set by the program typst.";
        example Example::Made { key: "no-typst", how: t(
            "build --typst /nowhere/typst", "build --typst /nowhere/typst") };
    "T0103" CompilerFailed Caution { document: Text, program: String, how: Text, lines: String, version: &'static str }
        es "{document} no se ha podido componer: «{program}» {how}{lines}"
        en "{document} could not be typeset: '{program}' {how}{lines}"
        remedy "las plantillas son para typst {version}; sin --typst ni RODETE_TYPST se usa el incorporado; las hojas y los programas están completos",
            "the templates are for typst {version}; without --typst and RODETE_TYPST the built-in one is used; the sheets and programs are complete";
        why "Otra versión de typst entiende las plantillas de otro modo.", "Another version of typst takes the templates in another way.";
        example Example::Made { key: "false-typst", how: t(
            "build --typst con un programa que termina con error", "build --typst with a program that ends with an error") };
    "T0104" TemplateRefused Caution { document: Text, lines: String }
        es "{document} no se ha podido componer con sus plantillas propias:{lines}"
        en "{document} could not be typeset with templates of your own:{lines}"
        remedy "corrija el archivo en la línea que se nombra, o construya sin --templates; las hojas y los programas están completos",
            "mend the file at the line that is named, or build without --templates; the sheets and programs are complete";
        why "Delante de cada mensaje va el archivo con su línea y columna; kind/ es la carpeta de la clase del libro.",
            "In front of each message stand the file, its line and column; kind/ is the folder of the workbook's kind.";
        example Example::Made { key: "false-templates", how: t(
            "build --templates con una plantilla que typst rechaza", "build --templates with a template that typst refuses") };
}
