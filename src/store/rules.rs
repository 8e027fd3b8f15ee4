//! What is told when files are written: one row for each finding.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::{Text, t};

/// A folder that no text shows.
macro_rules! made {
    ($key:literal, $es:literal, $en:literal) => {
        Example::Made { key: $key, how: t($es, $en) }
    };
}

/// What only the system says, and no input brings about.
macro_rules! by_the_system {
    () => {
        Example::Never(t(
            "lo dice el sistema: depende del disco y no de la entrada",
            "the system says so: it depends on the disk and not on the input",
        ))
    };
}

rules! {
    /// The rows of written files.
    RULES;

    "S0101" DiskFull Stop { path: String, after: Text }
        es "no se puede escribir en {path}: no queda espacio en el disco{after}"
        en "cannot write to {path}: no space left on the disk{after}"
        remedy "libere espacio o elija otra carpeta (opción -o); los archivos anteriores siguen intactos",
            "free some space or choose another folder (option -o); the files that were there are untouched";
        why "Un conjunto se entrega entero o no se entrega.", "A set is delivered whole or not at all.";
        example by_the_system!();
    "S0102" FileOverLimit Stop { path: String, after: Text }
        es "no se puede escribir en {path}: el archivo supera el tamaño permitido{after}"
        en "cannot write to {path}: the file is larger than is allowed here{after}"
        remedy "elija otra carpeta (opción -o) o pida un límite mayor (ulimit -f)",
            "choose another folder (option -o) or ask for a greater limit (ulimit -f)";
        why "Un conjunto se entrega entero o no se entrega.", "A set is delivered whole or not at all.";
        example by_the_system!();
    "S0103" NoPermissionToWrite Stop { path: String, after: Text }
        es "no se puede escribir en {path}: permiso denegado{after}"
        en "cannot write to {path}: permission denied{after}"
        remedy "elija otra carpeta (opción -o)", "choose another folder (option -o)";
        why "El sistema solo deja escribir a quien tiene permiso.", "The system lets only those write who may.";
        example made!("closed-folder", "una carpeta sin permiso de escritura", "a folder without permission to write");
    "S0104" ReadOnly Stop { path: String, after: Text }
        es "no se puede escribir en {path}: el sistema de archivos es de solo lectura{after}"
        en "cannot write to {path}: the file system is read-only{after}"
        remedy "elija otra carpeta (opción -o)", "choose another folder (option -o)";
        why "En un disco protegido o montado para leer no se escribe nada.",
            "Nothing is written on a disk that is protected or mounted for reading.";
        example by_the_system!();
    "S0105" NowhereToWrite Stop { path: String, after: Text }
        es "no se puede escribir en {path}: no existe{after}"
        en "cannot write to {path}: it does not exist{after}"
        remedy "elija otra carpeta (opción -o)", "choose another folder (option -o)";
        why "La carpeta se ha quitado mientras se escribía, o el enlace no lleva a ninguna parte.",
            "The folder was taken away while it was written to, or the link leads nowhere.";
        example by_the_system!();
    "S0106" FileInPlaceOfFolder Stop { path: String, after: Text }
        es "no se puede escribir en {path}: una parte de la ruta no es una carpeta{after}"
        en "cannot write to {path}: a part of the path is not a folder{after}"
        remedy "elija otra carpeta (opción -o)", "choose another folder (option -o)";
        why "Dentro de un archivo no caben otros.", "No file goes inside another.";
        example made!("file-as-folder", "una carpeta de salida out/part, donde out es un archivo", "an output folder out/part where out is a file");
    "S0107" FolderInPlaceOfFile Stop { path: String, after: Text }
        es "no se puede escribir en {path}: hay una carpeta con ese nombre{after}"
        en "cannot write to {path}: there is a folder of that name{after}"
        remedy "renombre esa carpeta o elija otra (opción -o)", "rename that folder or choose another (option -o)";
        why "Una carpeta no se sustituye por un archivo.", "A folder is not replaced with a file.";
        example by_the_system!();
    "S0108" NameNotAllowed Stop { path: String, after: Text }
        es "no se puede escribir en {path}: el nombre no es válido o es demasiado largo{after}"
        en "cannot write to {path}: the name is not valid or is too long{after}"
        remedy "acorte el nombre del libro", "give the workbook a shorter name";
        why "Los nombres de los resultados empiezan por el del libro.", "The names of the results begin with the workbook's.";
        example made!("long-output", "una carpeta de salida con un nombre de 300 letras", "an output folder with a name of 300 letters");
    "S0109" FileBusy Stop { path: String, after: Text }
        es "no se puede escribir en {path}: está en uso{after}"
        en "cannot write to {path}: it is in use{after}"
        remedy "ciérrelo en los demás programas", "close it in the other programs";
        why "Otro programa tiene el archivo y el sistema no deja sustituirlo.",
            "Another program has the file, and the system does not let it be replaced.";
        example by_the_system!();
    "S0110" CannotWrite Stop { path: String, reason: String, after: Text }
        es "no se puede escribir en {path}: {reason}{after}"
        en "cannot write to {path}: {reason}{after}"
        remedy "elija otra carpeta (opción -o)", "choose another folder (option -o)";
        why "El sistema no escribe el archivo, por la razón que da.", "The system does not write the file, for the reason that it gives.";
        example made!("link-to-nothing", "una carpeta de salida que es un enlace a una que no existe",
            "an output folder that is a link to one that does not exist");
    "S0111" SetMixed Stop { failure: Text, stuck: String, mend: Text }
        es "{failure}; de este conjunto quedan en versión nueva: {stuck}"
        en "{failure}; of this set these stand in their new version: {stuck}"
        remedy "no use ningún programa de esta carpeta hasta repetir la orden; {mend}",
            "use no program of this folder before the command has run again; {mend}";
        why "Un programa nuevo junto a una hoja de antes corta otra pieza.", "A new program beside a sheet of before cuts another part.";
        example by_the_system!();
    "S0121" FolderHeld Stop { lock: String, owner: String }
        es "otra ejecución está escribiendo en la misma carpeta ({lock}: {owner})"
        en "another run is writing into the same folder ({lock}: {owner})"
        remedy "espere a que termine y repita la orden", "wait until it ends and give the command again";
        why "Dos ejecuciones a la vez mezclarían sus archivos.", "Two runs at once would mix their files.";
        example made!("held", "una carpeta cuyo .rodete.lock tiene otra ejecución", "a folder whose .rodete.lock another run holds");
    "S0122" NotAFolder Stop { path: String }
        es "{path} no es una carpeta"
        en "{path} is not a folder"
        remedy "elija otra carpeta (opción -o)", "choose another folder (option -o)";
        why "Los resultados van a una carpeta, cada uno en su archivo.", "Results go into a folder, each in its own file.";
        example made!("no-folder", "una carpeta de salida out, donde out es un archivo", "an output folder out where out is a file");
    "S0131" OutputIsLink Stop { path: String }
        es "{path} es un enlace simbólico, y no se escribe a través de enlaces"
        en "{path} is a symbolic link, and nothing is written through links"
        remedy "cámbiele el nombre, quítelo o elija otra carpeta (opción -o)",
            "rename it, remove it or choose another folder (option -o)";
        why "El archivo al que lleva puede ser de otro.", "The file that it leads to may be somebody else's.";
        example made!("output-link", "un enlace con el nombre de un resultado", "a link under the name of a result");
    "S0132" OutputIsNoFile Stop { path: String }
        es "{path} no es un archivo ordinario"
        en "{path} is not an ordinary file"
        remedy "cámbiele el nombre, quítelo o elija otra carpeta (opción -o)",
            "rename it, remove it or choose another folder (option -o)";
        why "Una carpeta o un dispositivo no se sustituye por un resultado.",
            "A folder or a device is not replaced with a result.";
        example made!("output-folder", "una carpeta con el nombre de un resultado", "a folder under the name of a result");
    "S0133" OutputIsInput Stop { path: String }
        es "{path} es a la vez entrada y salida: se perdería el libro"
        en "{path} is both an input and an output: the workbook would be lost"
        remedy "elija otra carpeta (opción -o)", "choose another folder (option -o)";
        why "Lo que escribió usted no se sustituye por lo que se calcula.", "What you wrote is not replaced with what is computed.";
        example made!("input-as-output", "view part.html -o part.html", "view part.html -o part.html");
    "S0134" OutputIsOpen Stop { path: String, program: &'static str, lock: String }
        es "{path} está abierto en {program}"
        en "{path} is open in {program}"
        remedy "ciérrelo en {program}; si no está abierto en ninguna parte, borre {lock}",
            "close it in {program}; if it is not open anywhere, delete {lock}";
        why "Quien lo tiene abierto lo guardaría después encima del nuevo.", "Whoever has it open would later save it over the new one.";
        example made!("open-output", "un resultado junto al que está su ~$ de Excel", "a result with Excel's ~$ of it beside it");
    "S0141" WrittenTwice Stop { path: String }
        es "{path} se escribiría dos veces"
        en "{path} would be written twice"
        remedy "dé un nombre propio a cada libro", "give every workbook a name of its own";
        why "El segundo archivo borraría el primero.", "The second file would wipe out the first.";
        example Example::Never(t(
            "los nombres repetidos se rechazan antes de empezar", "names given twice are refused before anything is begun"));
    "S0142" ExistsAlready Stop { path: String }
        es "{path} ya existe"
        en "{path} exists already"
        remedy "dé otro nombre, o quite ese archivo", "give another name, or remove that file";
        why "Un libro rellenado no se sustituye por uno vacío.", "A workbook that was filled in is not replaced with an empty one.";
        example Example::Command { files: &[("impeller.xlsx", "x")], words: &["new", "impeller", "impeller.xlsx"] };
    "S0151" SetsMixed Stop { folder: String, files: Text }
        es "los archivos de {folder} no son de un mismo conjunto: una ejecución se detuvo mientras los entregaba{files}"
        en "the files in {folder} do not belong together: a run was stopped while it delivered them{files}"
        remedy "no use ninguno; borre los nuevos y repita la construcción", "use none of them; delete the new ones and build again";
        why "Un programa nuevo junto a una hoja de antes corta otra pieza.", "A new program beside a sheet of before cuts another part.";
        example made!("mixed", "un aviso de entrega con un archivo nuevo y otro que falta",
            "a notice of a delivery with one new file and another that is missing");
    "S0152" SetSettled Caution { folder: String, done: Text, files: String }
        es "una ejecución se detuvo mientras entregaba sus archivos en {folder}; el conjunto {done}: {files}"
        en "a run was stopped while it delivered its files into {folder}; the set {done}: {files}"
        remedy "vuelva a construir si no está seguro de qué libro son", "build again if you are not sure which workbook they are of";
        why "Los archivos ya no son una mezcla, pero pueden ser los de antes.",
            "The files are no mixture any more, but may be those of before.";
        example made!("settled", "un aviso de entrega cuyos archivos están todos", "a notice of a delivery whose files are all there");
    "S0153" NoticeIllegible Stop { path: String }
        es "{path} dice que una ejecución se detuvo mientras entregaba sus archivos, y no se puede leer"
        en "{path} says that a run was stopped while it delivered its files, and cannot be read"
        remedy "no use ningún archivo de esa carpeta; bórrelos junto con {path} y repita la construcción",
            "use no file of that folder; delete them together with {path} and build again";
        why "Sin el aviso no se sabe qué archivos son de un mismo conjunto.",
            "Without the notice nobody knows which files belong together.";
        example made!("illegible", "un .rodete-delivery.json que no es un aviso", "a .rodete-delivery.json that is no notice");
}
