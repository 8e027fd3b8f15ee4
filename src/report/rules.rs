//! Findings about a report that was made: one row each.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::{Text, t};

rules! {
    /// The rows of reports.
    RULES;

    "T0201" TooLargeToAttach Note { name: String }
        es "{name} es demasiado grande para adjuntarlo al informe, que da en su lugar su SHA-256"
        en "{name} is too large to attach to the report, which gives its SHA-256 instead"
        remedy "", "";
        why "Un PDF de decenas de megabytes es difícil de abrir y de enviar.", "A PDF of dozens of megabytes is hard to open and to send.";
        example Example::Made { key: "large-attachment", how: t(
            "un libro de más de 32 MiB", "a workbook of more than 32 MiB") };
    "T0202" CharactersByCode Note {}
        es "el informe muestra con su código los caracteres que sus tipos de letra no tienen"
        en "the report shows the codes of characters that its fonts lack"
        remedy "", "";
        why "Si no, el informe imprimiría una caja vacía.", "Otherwise the report would print an empty box.";
        example Example::Made { key: "foreign-letters", how: t(
            "una pieza llamada 中", "a part named 中") };
    "T0203" LogoNotRead Caution { name: String, reason: Text }
        es "no se ha podido leer el logotipo {name}: {reason}; el informe va sin él"
        en "the logo {name} could not be read: {reason}; the report goes without it"
        remedy "ponga el archivo junto al libro o en una carpeta de dentro y escriba su nombre en la celda, o déjela vacía",
            "put the file beside the workbook or into a folder below it and write its name into the cell, or leave the cell empty";
        why "El libro nombra el archivo desde su propia carpeta, para que ambos puedan llevarse juntos a otra máquina.",
            "The workbook names the file from its own folder, so that both can be taken to another machine together.";
        example Example::Made { key: "no-logo", how: t(
            "un libro que nombra un logotipo que no está junto a él", "a workbook that names a logo that is not beside it") };
    "T0204" LogoNotDrawn Caution { name: String }
        es "el logotipo {name} no es un SVG, PNG o JPEG que se pueda dibujar; el informe va sin él"
        en "the logo {name} is not an SVG, PNG or JPEG that can be drawn; the report goes without it"
        remedy "guárdelo de nuevo como SVG, PNG o JPEG desde el programa que lo hizo, o deje vacía la celda",
            "save it again as SVG, PNG or JPEG from the program that made it, or leave the cell empty";
        why "Un archivo dañado o de otro formato no puede detener todo el informe.",
            "A damaged file, or one of another format, must not stop the whole report.";
        example Example::Made { key: "false-logo", how: t(
            "un libro que nombra como logotipo un archivo dañado", "a workbook that names a damaged file as its logo") };
    "T0205" TemplatesNotRead Caution { folder: String, reason: Text }
        es "no se han podido leer las plantillas de {folder}: {reason}; no hay informe"
        en "the templates of {folder} could not be read: {reason}; there is no report"
        remedy "dé con --templates una carpeta con archivos propios, sin enlaces; las hojas y los programas están completos",
            "give --templates a folder with files of its own, without links; the sheets and programs are complete";
        why "Un informe con otras plantillas que las pedidas pasaría por bueno.", "A report with other templates than those asked for would pass for the right one.";
        example Example::Made { key: "no-templates", how: t(
            "build --templates con una carpeta que no existe", "build --templates with a folder that does not exist") };
    "T0206" NamedFileChanged Caution { name: String }
        es "el archivo {name} ha cambiado desde que se hicieron los programas"
        en "the file {name} has changed since the programs were made"
        remedy "vuelva a generar con \"rodete build\", o recupere el archivo anterior", "build again with \"rodete build\", or bring back the earlier file";
        why "El libro de resultados guarda el SHA-256 de cada archivo que nombra el libro, y el informe se hizo con el de entonces.",
            "The results workbook keeps the SHA-256 of each file that the workbook names, and the report was made with the file of then.";
        example Example::Made { key: "changed-logo", how: t(
            "un libro de resultados cuyo logotipo ha cambiado", "a results workbook whose logo has changed") };
    "T0207" LogoNotSuited Caution { name: String, reason: Text }
        es "el logotipo {name} no sirve: {reason}; el informe va sin él"
        en "the logo {name} cannot be used: {reason}; the report goes without it"
        remedy "guárdelo en colores RGB, con todo dentro del propio archivo y como mucho 4000 píxeles de lado, o deje vacía la celda",
            "save it in RGB colours, with everything inside the file itself and at most 4000 pixels a side, or leave the cell empty";
        why "El compilador no dibuja colores de imprenta (CMYK) ni lee otros archivos, y una imagen enorme ocupa toda la memoria.",
            "The compiler draws no printing colours (CMYK) and reads no other files, and a huge picture takes all of the memory.";
        example Example::Made { key: "cmyk-logo", how: t(
            "un libro que nombra como logotipo un JPEG en CMYK", "a workbook that names a JPEG in CMYK as its logo") };
    "T0208" TemplatesReplaceNothing Caution {}
        es "ningún archivo de la carpeta de --templates lleva el nombre de una plantilla de este informe, que va con las de rodete"
        en "no file of the folder of --templates has the name of a template of this report, which is set with rodete's own"
        remedy "dé a los archivos los nombres de las plantillas que sustituyen, como cover.typ; las de un tipo van en una carpeta con su nombre",
            "give the files the names of the templates that they replace, such as cover.typ; those of a kind go into a folder with its name";
        why "Un informe con otras plantillas que las pedidas pasaría por bueno.", "A report with other templates than those asked for would pass for the right one.";
        example Example::Made { key: "misnamed-templates", how: t(
            "build --templates con una carpeta que solo tiene cubierta.typ", "build --templates with a folder that has only cubierta.typ") };
}
