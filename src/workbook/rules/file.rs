//! The file itself: that it is there, may be read, and is no larger than is read.

use super::made;
use crate::finding::rule::rules;
use crate::text::Text;

rules! {
    /// The rows of files that are opened.
    RULES;

    "W0101" InputIsFolder Stop { path: String, wanted: Text }
        es "no se puede abrir {path}: es una carpeta"
        en "cannot open {path}: it is a folder"
        remedy "indique {wanted} de dentro de la carpeta", "give the name of {wanted} inside the folder";
        why "rodete lee un archivo, no una carpeta entera.", "rodete reads one file, not a whole folder.";
        example made!("folder", "una carpeta en lugar del libro", "a folder in place of the workbook");
    "W0102" NoRegularFile Stop { path: String, wanted: Text }
        es "no se puede abrir {path}: no es un archivo normal"
        en "cannot open {path}: it is not a regular file"
        remedy "indique {wanted}, guardado en disco", "give {wanted} stored on disk";
        why "Un dispositivo o una tubería puede no tener fin y no se puede leer dos veces.",
            "A device or a pipe may have no end, and cannot be read twice.";
        example made!("device", "un dispositivo, como /dev/zero, en lugar del libro", "a device, as /dev/zero, in place of the workbook");
    "W0103" HeldByProgram Stop { path: String }
        es "no se puede abrir {path}: otro programa lo tiene abierto"
        en "cannot open {path}: another program has it open"
        remedy "ciérrelo en Excel o LibreOffice y repita el comando", "close it in Excel or LibreOffice and run the command again";
        why "En Windows, un programa puede bloquear el archivo que tiene abierto.",
            "On Windows a program that has a file open can lock it.";
        example made!("held-open", "un libro que otro programa retiene: el sistema responde que está ocupado",
            "a workbook that another program holds: the system answers that it is busy");
    "W0104" NoSuchFile Stop { path: String }
        es "no se puede abrir {path}: no existe"
        en "cannot open {path}: no such file"
        remedy "compruebe el nombre y la carpeta", "check the name and the folder";
        why "Sin el archivo no hay nada que calcular.", "Without the file there is nothing to compute.";
        example made!("missing", "el nombre de un libro que no existe, en una carpeta sin libros",
            "the name of a workbook that does not exist, in a folder without workbooks");
    "W0105" NoSuchFileButAlike Stop { path: String, near: String }
        es "no se puede abrir {path}: no existe"
        en "cannot open {path}: no such file"
        remedy "¿quiere decir {near}?", "did you mean {near}?";
        why "La carpeta tiene un archivo de nombre parecido: será una errata.",
            "The folder has a file with a similar name: this is probably a typing error.";
        example made!("misspelt", "impeler.xlsx, donde está impeller.xlsx", "impeler.xlsx where impeller.xlsx is");
    "W0106" NoSuchFileAmong Stop { path: String, there: String }
        es "no se puede abrir {path}: no existe"
        en "cannot open {path}: no such file"
        remedy "use uno de los archivos de la carpeta: {there}", "use one of the files in the folder: {there}";
        why "Los archivos de la carpeta tienen otros nombres.", "The files in the folder have other names.";
        example made!("other-name", "otro.xlsx, donde está impeller.xlsx", "another.xlsx where impeller.xlsx is");
    "W0107" PathThroughFile Stop { path: String }
        es "no se puede abrir {path}: una parte de la ruta no es una carpeta"
        en "cannot open {path}: a part of the path is not a folder"
        remedy "compruebe la ruta", "check the path";
        why "Un archivo no puede contener otros archivos.", "A file cannot contain other files.";
        example made!("through-file", "impeller.xlsx/libro.xlsx, donde impeller.xlsx es un archivo",
            "impeller.xlsx/book.xlsx where impeller.xlsx is a file");
    "W0108" NoPermissionToRead Stop { path: String }
        es "no se puede abrir {path}: falta el permiso de lectura"
        en "cannot open {path}: no permission to read it"
        remedy "dé permiso de lectura o copie el archivo", "allow reading it, or copy the file";
        why "El sistema no le permite leer el archivo.", "The system does not allow you to read the file.";
        example made!("unreadable", "un libro sin permiso de lectura", "a workbook without permission to read it");
    "W0109" NoPermissionWhileOpen Stop { path: String }
        es "no se puede abrir {path}: falta el permiso de lectura"
        en "cannot open {path}: no permission to read it"
        remedy "ciérrelo en Excel o LibreOffice y repita el comando", "close it in Excel or LibreOffice and run the command again";
        why "Junto al libro hay un archivo que Excel crea mientras lo tiene abierto.",
            "Beside the workbook is a file that Excel creates while the workbook is open.";
        example made!("unreadable-and-open", "un libro sin permiso de lectura y junto a él un ~$impeller.xlsx",
            "a workbook without permission to read it, and a ~$impeller.xlsx beside it");
    "W0110" CannotOpen Stop { path: String, reason: Text }
        es "no se puede abrir {path}: {reason}"
        en "cannot open {path}: {reason}"
        remedy "compruebe la ruta", "check the path";
        why "El sistema no puede abrir el archivo, por la razón indicada.", "The system cannot open the file, for the reason given.";
        example made!("long-name", "un nombre de 300 letras", "a name of 300 letters");
    "W0111" CannotOpenWhileOpen Stop { path: String, reason: Text }
        es "no se puede abrir {path}: {reason}"
        en "cannot open {path}: {reason}"
        remedy "ciérrelo en Excel o LibreOffice y repita el comando", "close it in Excel or LibreOffice and run the command again";
        why "Junto al libro hay un archivo que Excel crea mientras lo tiene abierto.",
            "Beside the workbook is a file that Excel creates while the workbook is open.";
        example made!("fails-and-open", "un disco que falla al leer un libro con el ~$ de Excel a su lado",
            "a disk that fails in reading a workbook with Excel's ~$ beside it");
    "W0112" WorkbookTooLarge Stop { path: String, most: u64 }
        es "{path} ocupa más de {most} MiB"
        en "{path} is larger than {most} MiB"
        remedy "deje en el libro solo las hojas de entrada", "keep only the input sheets in the workbook";
        why "Un formulario ocupa unos kilobytes: un archivo mil veces mayor contiene otra cosa.",
            "A form takes a few kilobytes: a file a thousand times larger holds something else.";
        example made!("large", "un libro de más de 64 MiB", "a workbook of more than 64 MiB");
    "W0113" FileTooLarge Stop { path: String, most: u64, wanted: Text }
        es "{path} ocupa más de {most} MiB"
        en "{path} is larger than {most} MiB"
        remedy "indique {wanted}", "name {wanted}";
        why "rodete lee el archivo entero en memoria, y ninguno de su clase es tan grande.",
            "rodete reads the whole file into memory, and no file of its kind is that large.";
        example made!("large-var", "un archivo .var de más de 64 MiB", "a .var file of more than 64 MiB");
}
