//! The file itself: that it is there, may be read, and is no larger than is read.

use super::made;
use crate::finding::rule::rules;
use crate::text::{Text, t};

rules! {
    /// The rows of files that are opened.
    RULES;

    "W0101" InputIsFolder Stop { path: String, wanted: Text }
        es "no se puede abrir {path}: es una carpeta"
        en "cannot open {path}: it is a folder"
        remedy "indique {wanted} que está dentro de la carpeta", "name {wanted} inside the folder";
        why "Se lee un archivo, no todo lo que hay en una carpeta.", "One file is read, not all that a folder holds.";
        example made!("folder", "una carpeta en lugar del libro", "a folder in place of the workbook");
    "W0102" NoRegularFile Stop { path: String, wanted: Text }
        es "no se puede abrir {path}: no es un archivo normal"
        en "cannot open {path}: it is not a regular file"
        remedy "indique {wanted}, guardado en disco", "name {wanted}, stored on disk";
        why "Un dispositivo o una tubería no tiene fin, y nunca se lee dos veces lo mismo.",
            "A device or a pipe has no end, and never reads the same twice.";
        example made!("device", "un dispositivo, como /dev/zero, en lugar del libro", "a device, as /dev/zero, in place of the workbook");
    "W0103" HeldByProgram Stop { path: String }
        es "no se puede abrir {path}: otro programa lo tiene abierto"
        en "cannot open {path}: another program has it open"
        remedy "ciérrelo en Excel o LibreOffice y repita la orden", "close it in Excel or LibreOffice and run the command again";
        why "En Windows el programa que tiene abierto un archivo puede impedir que otros lo lean.",
            "On Windows the program that has a file open may keep others from reading it.";
        example crate::finding::Example::Never(t("solo Windows lo impide", "only Windows keeps others out"));
    "W0104" NoSuchFile Stop { path: String }
        es "no se puede abrir {path}: no existe"
        en "cannot open {path}: no such file"
        remedy "compruebe el nombre y la carpeta", "check the name and the folder";
        why "Sin archivo no hay nada que calcular.", "Without the file there is nothing to compute.";
        example made!("missing", "el nombre de un libro que no existe, en una carpeta sin libros",
            "the name of a workbook that does not exist, in a folder without workbooks");
    "W0105" NoSuchFileButAlike Stop { path: String, near: String }
        es "no se puede abrir {path}: no existe"
        en "cannot open {path}: no such file"
        remedy "¿quiere decir {near}?", "did you mean {near}?";
        why "En la carpeta hay uno de nombre parecido: suele ser una errata.",
            "There is one of a similar name in the folder: mostly a slip of the keys.";
        example made!("misspelt", "impeler.xlsx, donde está impeller.xlsx", "impeler.xlsx where impeller.xlsx stands");
    "W0106" NoSuchFileAmong Stop { path: String, there: String }
        es "no se puede abrir {path}: no existe"
        en "cannot open {path}: no such file"
        remedy "en la carpeta hay: {there}", "the folder has: {there}";
        why "Los de la carpeta se llaman de otro modo.", "Those in the folder have other names.";
        example made!("other-name", "otro.xlsx, donde está impeller.xlsx", "another.xlsx where impeller.xlsx stands");
    "W0107" PathThroughFile Stop { path: String }
        es "no se puede abrir {path}: una parte de la ruta no es una carpeta"
        en "cannot open {path}: a part of the path is not a folder"
        remedy "compruebe la ruta", "check the path";
        why "Dentro de un archivo no hay otros archivos.", "There are no files inside a file.";
        example made!("through-file", "impeller.xlsx/libro.xlsx, donde impeller.xlsx es un archivo",
            "impeller.xlsx/book.xlsx where impeller.xlsx is a file");
    "W0108" NoPermissionToRead Stop { path: String }
        es "no se puede abrir {path}: falta el permiso de lectura"
        en "cannot open {path}: no permission to read it"
        remedy "dé permiso de lectura o copie el archivo", "allow reading it, or copy the file";
        why "El sistema solo da el archivo a quien tiene permiso.", "The system gives the file only to those who may read it.";
        example made!("unreadable", "un libro sin permiso de lectura", "a workbook without permission to read it");
    "W0109" NoPermissionWhileOpen Stop { path: String }
        es "no se puede abrir {path}: falta el permiso de lectura"
        en "cannot open {path}: no permission to read it"
        remedy "ciérrelo en Excel o LibreOffice y repita la orden", "close it in Excel or LibreOffice and run the command again";
        why "Junto al libro está el archivo que Excel deja mientras lo tiene abierto.",
            "Beside the workbook stands the file that Excel keeps while it has it open.";
        example made!("unreadable-and-open", "un libro sin permiso de lectura y junto a él un ~$impeller.xlsx",
            "a workbook without permission to read it, and a ~$impeller.xlsx beside it");
    "W0110" CannotOpen Stop { path: String, reason: String }
        es "no se puede abrir {path}: {reason}"
        en "cannot open {path}: {reason}"
        remedy "compruebe la ruta", "check the path";
        why "El sistema no abre el archivo, por la razón que da.", "The system does not open the file, for the reason that it gives.";
        example made!("long-name", "un nombre de 300 letras", "a name of 300 letters");
    "W0111" CannotOpenWhileOpen Stop { path: String, reason: String }
        es "no se puede abrir {path}: {reason}"
        en "cannot open {path}: {reason}"
        remedy "ciérrelo en Excel o LibreOffice y repita la orden", "close it in Excel or LibreOffice and run the command again";
        why "Junto al libro está el archivo que Excel deja mientras lo tiene abierto.",
            "Beside the workbook stands the file that Excel keeps while it has it open.";
        example crate::finding::Example::Never(t(
            "el sistema solo responde así donde el disco o la red fallan con el libro abierto",
            "the system answers so only where the disk or the network fails while the workbook is open"));
    "W0112" WorkbookTooLarge Stop { path: String, most: u64 }
        es "{path} ocupa más de {most} MiB"
        en "{path} is larger than {most} MiB"
        remedy "deje en el libro solo las hojas de entrada", "leave only the input sheets in the workbook";
        why "Un formulario ocupa unos kilobytes: lo que es mil veces mayor lleva otra cosa.",
            "A form takes some kilobytes: what is a thousand times larger holds something else.";
        example made!("large", "un libro de más de 64 MiB", "a workbook of more than 64 MiB");
    "W0113" FileTooLarge Stop { path: String, most: u64, wanted: Text }
        es "{path} ocupa más de {most} MiB"
        en "{path} is larger than {most} MiB"
        remedy "indique {wanted}", "name {wanted}";
        why "El archivo se lee entero en memoria, y ninguno de su clase es tan grande.",
            "The file is read into memory as a whole, and none of its kind is so large.";
        example made!("large-var", "un archivo .var de más de 64 MiB", "a .var file of more than 64 MiB");
}
