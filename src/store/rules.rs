//! Findings about written files: one row each.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::{Text, t};

/// A folder that no text shows.
macro_rules! made {
    ($key:literal, $es:literal, $en:literal) => {
        Example::Made { key: $key, how: t($es, $en) }
    };
}

rules! {
    /// The rows of written files.
    RULES;

    "S0101" DiskFull Stop { path: String, after: Text }
        es "no se puede escribir en {path}: no queda espacio en el disco{after}"
        en "cannot write to {path}: no space left on the disk{after}"
        remedy "libere espacio o elija otra carpeta (en build, opción -o); los archivos anteriores siguen intactos",
            "free some space or choose another folder (for build, option -o); the earlier files are untouched";
        why "rodete entrega el juego entero o nada.", "rodete delivers the whole set or nothing.";
        example made!("given-disk-full", "un disco sin espacio, que responde ENOSPC", "a disk without space, which answers ENOSPC");
    "S0102" FileOverLimit Stop { path: String, after: Text }
        es "no se puede escribir en {path}: el archivo supera el tamaño permitido{after}"
        en "cannot write to {path}: the file exceeds the allowed size{after}"
        remedy "elija otra carpeta (en build, opción -o) o pida un límite mayor (ulimit -f)",
            "choose another folder (for build, option -o) or ask for a higher limit (ulimit -f)";
        why "rodete entrega el juego entero o nada.", "rodete delivers the whole set or nothing.";
        example made!("given-disk-limit", "un archivo mayor que el límite de ulimit -f: el disco responde EFBIG",
            "a file beyond the limit of ulimit -f: the disk answers EFBIG");
    "S0103" NoPermissionToWrite Stop { path: String, after: Text }
        es "no se puede escribir en {path}: permiso denegado{after}"
        en "cannot write to {path}: permission denied{after}"
        remedy "elija otra carpeta (en build, opción -o)", "choose another folder (for build, option -o)";
        why "El sistema no le permite escribir aquí.", "The system does not allow you to write here.";
        example made!("closed-folder", "una carpeta sin permiso de escritura", "a folder without permission to write");
    "S0104" ReadOnly Stop { path: String, after: Text }
        es "no se puede escribir en {path}: el sistema de archivos es de solo lectura{after}"
        en "cannot write to {path}: the file system is read-only{after}"
        remedy "elija otra carpeta (en build, opción -o)", "choose another folder (for build, option -o)";
        why "No se puede escribir en un disco protegido o montado de solo lectura.",
            "A protected disk, or one mounted read-only, cannot be written.";
        example made!("given-disk-read-only", "un disco montado de solo lectura, que responde EROFS", "a disk mounted read-only, which answers EROFS");
    "S0105" NowhereToWrite Stop { path: String, after: Text }
        es "no se puede escribir en {path}: no existe{after}"
        en "cannot write to {path}: it does not exist{after}"
        remedy "elija otra carpeta (en build, opción -o)", "choose another folder (for build, option -o)";
        why "La carpeta desapareció durante la escritura, o el enlace no lleva a ninguna parte.",
            "The folder disappeared during writing, or the link leads nowhere.";
        example made!("given-folder-gone", "una carpeta que otro programa borra durante la escritura",
            "a folder that another program deletes during writing");
    "S0106" FileInPlaceOfFolder Stop { path: String, after: Text }
        es "no se puede escribir en {path}: una parte de la ruta no es una carpeta{after}"
        en "cannot write to {path}: a part of the path is not a folder{after}"
        remedy "elija otra carpeta (en build, opción -o)", "choose another folder (for build, option -o)";
        why "Un archivo no puede contener otros archivos.", "A file cannot contain other files.";
        example made!("file-as-folder", "una carpeta de salida out/part, donde out es un archivo", "an output folder out/part where out is a file");
    "S0107" FolderInPlaceOfFile Stop { path: String, after: Text }
        es "no se puede escribir en {path}: hay una carpeta con ese nombre{after}"
        en "cannot write to {path}: there is a folder with that name{after}"
        remedy "renombre esa carpeta o elija otra (en build, opción -o)", "rename that folder or choose another (for build, option -o)";
        why "rodete no sustituye una carpeta por un archivo.", "rodete does not replace a folder with a file.";
        example made!("given-folder-there", "una carpeta que otro programa crea con el nombre del resultado durante la escritura",
            "a folder that another program makes under the name of the result during writing");
    "S0108" NameNotAllowed Stop { path: String, after: Text }
        es "no se puede escribir en {path}: el nombre no es válido o es demasiado largo{after}"
        en "cannot write to {path}: the name is invalid or too long{after}"
        remedy "acorte el nombre del libro", "give the workbook a shorter name";
        why "El nombre de cada resultado empieza por el del libro.", "The name of each result begins with the workbook's name.";
        example made!("long-output", "una carpeta de salida con un nombre de 300 letras", "an output folder with a name of 300 letters");
    "S0109" FileBusy Stop { path: String, after: Text }
        es "no se puede escribir en {path}: está en uso{after}"
        en "cannot write to {path}: it is in use{after}"
        remedy "ciérrelo en los demás programas", "close it in the other programs";
        why "Otro programa tiene abierto el archivo, y el sistema no deja sustituirlo.",
            "Another program has the file open, and the system does not let rodete replace it.";
        example made!("given-disk-busy", "un archivo que otro programa retiene: el disco responde EBUSY",
            "a file that another program holds: the disk answers EBUSY");
    "S0110" CannotWrite Stop { path: String, reason: Text, after: Text }
        es "no se puede escribir en {path}: {reason}{after}"
        en "cannot write to {path}: {reason}{after}"
        remedy "elija otra carpeta (en build, opción -o)", "choose another folder (for build, option -o)";
        why "El sistema no puede escribir el archivo, por la razón indicada.", "The system cannot write the file, for the reason given.";
        example made!("link-to-nothing", "una carpeta de salida que es un enlace a una que no existe",
            "an output folder that is a link to one that does not exist");
    "S0111" SetMixed Stop { failure: Text, stuck: String }
        es "{failure}; de este juego ya son de la versión nueva: {stuck}"
        en "{failure}; of this set, these files are already the new version: {stuck}"
        remedy "no use ningún programa de esta carpeta hasta haber repetido el comando",
            "use no program from this folder until the command has run again";
        why "Un programa nuevo con una hoja anterior corta otra pieza.", "A new program with an old sheet cuts another part.";
        example made!("given-disk-stuck", "un disco que falla a mitad de la entrega y tampoco deja devolver lo anterior",
            "a disk that fails halfway through a delivery and does not let the earlier files be put back");
    "S0121" FolderHeld Stop { lock: String, owner: String }
        es "otra ejecución está escribiendo en la misma carpeta ({lock}: {owner})"
        en "another run is writing to the same folder ({lock}: {owner})"
        remedy "espere a que termine y repita el comando", "wait until it ends and repeat the command";
        why "Dos ejecuciones a la vez mezclarían sus archivos.", "Two runs at the same time would mix their files.";
        example made!("held", "una carpeta cuyo .rodete.lock tiene otra ejecución", "a folder whose .rodete.lock another run holds");
    "S0122" NotAFolder Stop { path: String }
        es "{path} no es una carpeta"
        en "{path} is not a folder"
        remedy "elija otra carpeta (en build, opción -o)", "choose another folder (for build, option -o)";
        why "rodete escribe los resultados en una carpeta, cada uno en su archivo.", "rodete writes the results into a folder, each in its own file.";
        example made!("no-folder", "una carpeta de salida out, donde out es un archivo", "an output folder out where out is a file");
    "S0131" OutputIsLink Stop { path: String }
        es "{path} es un enlace simbólico, y rodete no escribe a través de enlaces"
        en "{path} is a symbolic link, and rodete does not write through links"
        remedy "cámbiele el nombre, quítelo o elija otra carpeta (en build, opción -o)",
            "rename it, remove it or choose another folder (for build, option -o)";
        why "El archivo al que lleva el enlace puede ser de otra persona.", "The file behind the link may be somebody else's.";
        example made!("output-link", "un enlace con el nombre de un resultado", "a link under the name of a result");
    "S0132" OutputIsNoFile Stop { path: String }
        es "{path} no es un archivo ordinario"
        en "{path} is not an ordinary file"
        remedy "cámbiele el nombre, quítelo o elija otra carpeta (en build, opción -o)",
            "rename it, remove it or choose another folder (for build, option -o)";
        why "rodete no sustituye una carpeta ni un dispositivo por un resultado.",
            "rodete does not replace a folder or a device with a result.";
        example made!("output-folder", "una carpeta con el nombre de un resultado", "a folder under the name of a result");
    "S0133" OutputIsInput Stop { path: String }
        es "{path} es a la vez entrada y salida: se perdería el libro"
        en "{path} is both input and output: the workbook would be lost"
        remedy "elija otra carpeta (en build, opción -o)", "choose another folder (for build, option -o)";
        why "rodete no sobrescribe su libro con los resultados.", "rodete does not overwrite your workbook with results.";
        example made!("input-as-output", "view part.html -o part.html", "view part.html -o part.html");
    "S0134" OutputIsOpen Stop { path: String, program: &'static str, owner: Text, lock: String }
        es "{path} está abierto en {program}{owner}"
        en "{path} is open in {program}{owner}"
        remedy "ciérrelo en {program}; si no está abierto en ninguna parte, borre {lock}",
            "close it in {program}; if it is not open anywhere, delete {lock}";
        why "Quien lo tiene abierto lo guardaría después encima del nuevo.", "Whoever has it open could later save it over the new one.";
        example made!("open-output", "un resultado junto al que está su ~$ de Excel", "a result with Excel's ~$ of it beside it");
    "S0135" BookReadOnly Stop { path: String }
        es "{path} está protegido contra escritura"
        en "{path} is write-protected"
        remedy "quite la protección del archivo, o prescinda de --into", "remove the file's protection, or do without --into";
        why "Quien lo protegió no quiere que cambie.", "Whoever protected it does not want it to change.";
        example made!("into-protected", "build --into de un libro sin permiso de escritura",
            "build --into of a workbook without permission to write");
    "S0136" BookChanged Stop { path: String }
        es "{path} ha cambiado mientras rodete trabajaba con él"
        en "{path} changed while rodete was working on it"
        remedy "repita la orden", "run the command again";
        why "Alguien lo guardó entretanto, y sus cambios se perderían.", "Somebody saved it meanwhile, and those changes would be lost.";
        example made!("given-book-changed", "un libro que otro programa guarda entre la lectura y la escritura",
            "a workbook that another program saves between reading and writing");
    "S0141" WrittenTwice Stop { path: String }
        es "{path} se escribiría dos veces"
        en "{path} would be written twice"
        remedy "dé un nombre distinto a cada libro", "give each workbook its own name";
        why "El segundo archivo sobrescribiría el primero.", "The second file would overwrite the first.";
        example made!("given-name-twice", "un mismo nombre dado dos veces a la biblioteca: los comandos lo rechazan antes de empezar",
            "one name given twice to the library: the commands reject it before they begin");
    "S0142" ExistsAlready Stop { path: String }
        es "{path} ya existe"
        en "{path} already exists"
        remedy "dé otro nombre, o quite ese archivo", "give another name, or remove that file";
        why "rodete no sustituye un libro rellenado por uno nuevo.", "rodete does not replace a filled-in workbook with a new one.";
        example Example::Command { files: &[("impeller.xlsx", "x")], words: &["new", "impeller", "impeller.xlsx"] };
    "S0151" SetsMixed Stop { folder: String, files: Text }
        es "los archivos de {folder} no son del mismo juego: una ejecución se interrumpió mientras los entregaba{files}"
        en "the files in {folder} do not belong together: a run was interrupted while delivering them{files}"
        remedy "no use ninguno de estos archivos; borre los nuevos y vuelva a generar", "use none of these files; delete the new ones and build again";
        why "Un programa nuevo con una hoja anterior corta otra pieza.", "A new program with an old sheet cuts another part.";
        example made!("mixed", "un aviso de entrega con un archivo nuevo y otro que falta",
            "a notice of a delivery with one new file and another that is missing");
    "S0152" SetSettled Caution { folder: String, done: Text, files: String }
        es "una ejecución se interrumpió mientras entregaba sus archivos en {folder}; el juego {done}: {files}"
        en "a run was interrupted while delivering its files to {folder}; the set {done}: {files}"
        remedy "vuelva a generar si no está seguro de qué libro son", "build again if you are not sure which workbook they belong to";
        why "Los archivos ya no están mezclados, pero pueden ser los anteriores.",
            "The files are no longer mixed, but may be the earlier ones.";
        example made!("settled", "un aviso de entrega cuyos archivos están todos", "a notice of a delivery whose files are all there");
    "S0153" NoticeIllegible Stop { path: String }
        es "{path} indica que una ejecución se interrumpió mientras entregaba sus archivos, y no se puede leer"
        en "{path} shows that a run was interrupted while delivering its files, but cannot be read"
        remedy "no use ningún archivo de esa carpeta; bórrelos junto con {path} y vuelva a generar",
            "use no file in that folder; delete them together with {path} and build again";
        why "Sin el aviso no se sabe qué archivos son de un mismo juego.",
            "Without the notice nobody knows which files belong together.";
        example made!("illegible", "un .rodete-delivery.json que no es un aviso", "a .rodete-delivery.json that is not a notice");
}
