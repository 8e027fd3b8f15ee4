//! The package and its parts: what a file must be before its cells are read.

use super::made;
use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::{Text, t};

rules! {
    /// The rows of packages and their parts.
    RULES;

    "W0201" FileEmpty Stop {}
        es "el archivo está vacío"
        en "the file is empty"
        remedy "vuelva a copiarlo del original", "copy it again from the original";
        why "Una copia o una descarga interrumpida deja a menudo un archivo sin nada.",
            "A copy or a download that broke off often leaves a file with nothing in it.";
        example made!("empty", "un archivo de 0 bytes", "a file of 0 bytes");
    "W0202" OldOrProtected Stop {}
        es "es un .xls antiguo o un libro protegido con contraseña"
        en "old .xls or password-protected workbook"
        remedy "guárdelo como libro de Excel (.xlsx) sin contraseña", "save it as an Excel workbook (.xlsx) without a password";
        why "Ambos empiezan por los mismos bytes, y ninguno se lee sin Excel.",
            "Both begin with the same bytes, and neither is read without Excel.";
        example made!("old", "un libro guardado como .xls", "a workbook saved as .xls");
    "W0203" NoWorkbook Stop { head: String }
        es "no es un libro .xlsx (empieza por \"{head}\")"
        en "this is not an .xlsx workbook (starts with \"{head}\")"
        remedy "ábralo en Excel o LibreOffice y guárdelo como .xlsx", "open it in Excel or LibreOffice and save it as .xlsx";
        why "Un texto o una página web con el nombre de un libro no tiene celdas.",
            "A text or a web page under the name of a workbook has no cells.";
        example made!("text", "un texto, «hello», con el nombre de un libro", "a text, \"hello\", under the name of a workbook");
    "W0204" OtherFormat Stop { format: String }
        es "es un archivo {format}, no un libro .xlsx"
        en "this is an {format} file, not an .xlsx workbook"
        remedy "guárdelo como .xlsx", "save it as .xlsx";
        why "Es un paquete zip como un .xlsx, pero sus partes son otras.", "It is a zip package as an .xlsx is, but its parts are others.";
        example made!("zip", "un .zip cualquiera con el nombre de un libro", "any .zip under the name of a workbook");
    "W0205" MacrosNotRead Note {}
        es "el libro lleva macros (.xlsm): ni se ejecutan ni se leen"
        en "the workbook carries macros (.xlsm): they are neither run nor read"
        remedy "", "";
        why "Lo que una macro escribiría en las celdas no está en ellas hasta que se guarda el libro.",
            "What a macro would write into cells is not in them until the workbook is saved.";
        example made!("macros", "un libro con macros", "a workbook with macros");
    "W0211" TooManyEntries Stop { most: usize }
        es "el paquete tiene más de {most} partes; un libro .xlsx tiene menos"
        en "the package has more than {most} entries; an .xlsx workbook has fewer"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "La lista de las partes se lee en memoria antes que nada.", "The list of entries is read into memory before anything else.";
        example made!("many-entries", "un zip de 2000 partes", "a zip of 2000 entries");
    "W0212" ZipEndMissing Stop {}
        es "no es un .xlsx completo (falta el final del zip)"
        en "not a complete .xlsx (zip end missing)"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Al final del paquete está la lista de sus partes: sin ella no se sabe dónde empieza cada una.",
            "The end of the package lists its parts: without it nobody knows where each begins.";
        example made!("half", "la primera mitad de un libro", "the first half of a workbook");
    "W0213" ZipDirectoryDamaged Stop { reason: String }
        es "no es un .xlsx completo (el directorio del zip está dañado: {reason})"
        en "not a complete .xlsx (the zip directory is damaged: {reason})"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "La lista de las partes señala a donde no están.", "The list of parts points to where they are not.";
        example made!("directory", "un libro con bytes cambiados en la lista de sus partes",
            "a workbook with bytes changed in the list of its parts");
    "W0214" EntryTwice Stop {}
        es "dos partes del paquete tienen el mismo nombre"
        en "two entries of the package have the same name"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Cada programa leería una distinta.", "Each program would read another one of them.";
        example made!("doubled", "un paquete con dos partes xl/aa", "a package with two entries xl/aa");
    "W0215" EntryTwiceButForCapitals Stop { entry: String }
        es "dos partes del paquete se llaman \"{entry}\" (sin mirar mayúsculas)"
        en "two entries of the package are named \"{entry}\" (but for capitals)"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Las partes se buscan sin mirar mayúsculas: cada programa leería una distinta.",
            "Parts are looked up whatever their capitals: each program would read another one.";
        example made!("capitals", "un paquete con xl/workbook.xml y XL/Workbook.xml", "a package with xl/workbook.xml and XL/Workbook.xml");
    "W0216" EntryOutside Stop { entry: String }
        es "una parte del paquete se llama \"{entry}\" y apunta fuera de él"
        en "an entry of the package is named \"{entry}\" and points outside of it"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Ningún programa de hojas de cálculo escribe tal nombre: quien lo pone quiere llegar a otros archivos.",
            "No spreadsheet program writes such a name: whoever does wants to reach other files.";
        example made!("outside", "un paquete con la parte xl/../../etc/passwd", "a package with the entry xl/../../etc/passwd");
    "W0217" EntryEncrypted Stop {}
        es "el libro está cifrado; guárdelo como .xlsx sin contraseña"
        en "the workbook is encrypted; save it as .xlsx without a password"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Sin la contraseña las partes no se pueden leer.", "Without the password the parts cannot be read.";
        example made!("encrypted", "un paquete zip con contraseña", "a zip package with a password");
    "W0218" EntryDamaged Stop { entry: String, how: Text }
        es "{entry} está dañado ({how})"
        en "{entry} is damaged ({how})"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "La parte no es la que se guardó: un valor podría ser otro.", "The part is not the one that was saved: a value might be another.";
        example made!("checksum", "un libro con un bit cambiado en una hoja", "a workbook with one bit changed in a sheet");
    "W0219" EntryWithoutName Stop { number: usize }
        es "el nombre de la parte {number} del paquete no se puede leer"
        en "the name of entry {number} of the package cannot be read"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Una parte sin nombre no se puede buscar ni descartar.", "An entry without a name can neither be looked up nor passed over.";
        example Example::Never(t(
            "el lector de zip toma cualquier nombre por UTF-8 o por CP437",
            "the reader of zips takes every name, as UTF-8 or as CP437"));
    "W0220" PartTooLarge Stop { part: String, most: u64 }
        es "{part}: el libro ocupa descomprimido más de {most} MiB en una sola parte"
        en "{part}: the workbook unpacks to more than {most} MiB in one part"
        remedy "borre del libro las hojas que no sean de entrada, o parta de un libro nuevo con \"rodete new\"",
            "delete the sheets that are not input from the workbook, or start from a new one with \"rodete new\"";
        why "Unos kilobytes comprimidos pueden llenar la memoria al descomprimirse.",
            "Some packed kilobytes may fill the memory when they are unpacked.";
        example made!("bomb", "un libro con una imagen de más de 64 MiB de ceros", "a workbook with an image of more than 64 MiB of zeros");
    "W0221" PackageTooLarge Stop { most: u64 }
        es "el libro ocupa descomprimido más de {most} MiB"
        en "the workbook unpacks to more than {most} MiB in all"
        remedy "borre del libro las hojas que no sean de entrada, o parta de un libro nuevo con \"rodete new\"",
            "delete the sheets that are not input from the workbook, or start from a new one with \"rodete new\"";
        why "Unos kilobytes comprimidos pueden llenar la memoria al descomprimirse.",
            "Some packed kilobytes may fill the memory when they are unpacked.";
        example made!("bombs", "un libro con cinco imágenes de 60 MiB de ceros", "a workbook with five images of 60 MiB of zeros");
    "W0231" PartUtf16 Stop { part: String }
        es "no se encuentra ninguna celda legible: la parte {part} está en UTF-16"
        en "no cells can be read: the part {part} is stored as UTF-16"
        remedy "ábralo en Excel o LibreOffice y guárdelo de nuevo como .xlsx", "open it in Excel or LibreOffice and save it again as .xlsx";
        why "El lector de hojas tomaría tal hoja por vacía.", "The reader of sheets would take such a sheet for an empty one.";
        example made!("utf16", "un libro con una hoja en UTF-16", "a workbook with a sheet in UTF-16");
    "W0232" PartNotUtf8 Stop { part: String, byte: usize }
        es "la parte {part} está dañada: en el byte {byte} no hay UTF-8 válido"
        en "the part {part} is damaged: byte {byte} is not valid UTF-8"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Lo que no es texto no se sabe leer: un valor podría ser otro.", "What is no text cannot be read for sure: a value might be another.";
        example made!("latin1", "un libro con una letra de Latin-1 en una hoja", "a workbook with a letter of Latin-1 in a sheet");
    "W0233" PartIllFormed Stop { part: String, byte: u64, reason: String }
        es "la parte {part} está dañada: XML mal formado en el byte {byte} ({reason})"
        en "the part {part} is damaged: XML not well formed at byte {byte} ({reason})"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Donde las etiquetas no cuadran no se sabe qué celda es cuál.", "Where tags do not match nobody knows which cell is which.";
        example made!("entity", "un libro con una entidad &xxe; en una hoja", "a workbook with an entity &xxe; in a sheet");
    "W0234" PartTooDeep Stop { part: String, most: usize }
        es "la parte {part} tiene más de {most} elementos uno dentro de otro"
        en "the part {part} has more than {most} elements inside one another"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Una hoja tiene unos cinco niveles; más profundidad solo gasta memoria.",
            "A sheet has some five levels; more depth only costs memory.";
        example made!("deep", "un libro con 300 elementos uno dentro de otro", "a workbook with 300 elements inside one another");
    "W0235" TooManyAttributes Stop { part: String, most: usize }
        es "la parte {part} tiene más de {most} atributos en una etiqueta"
        en "the part {part} has more than {most} attributes in one tag"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Cada atributo se compara con todos los demás de su etiqueta.", "Every attribute is compared with all others of its tag.";
        example made!("attributes", "un libro con una etiqueta de 100001 atributos", "a workbook with a tag of 100001 attributes");
    "W0236" DocumentType Stop { part: String }
        es "la parte {part} declara un tipo de documento (DTD), que un libro .xlsx no puede tener"
        en "the part {part} declares a document type (DTD), which an .xlsx workbook may not have"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Un tipo de documento puede traer el contenido de otros archivos.", "A document type can bring in what other files hold.";
        example made!("dtd", "un libro con <!DOCTYPE …> en una hoja", "a workbook with <!DOCTYPE …> in a sheet");
    "W0237" OtherEncoding Stop { part: String, encoding: String }
        es "la parte {part} declara la codificación {encoding}; se lee solo UTF-8"
        en "the part {part} declares the encoding {encoding}; only UTF-8 is read"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Con otra codificación los mismos bytes son otras letras.", "In another encoding the same bytes are other letters.";
        example made!("encoding", "un libro que declara encoding=\"latin1\" en una hoja", "a workbook that declares encoding=\"latin1\" in a sheet");
    "W0238" PartCutOff Stop { part: String }
        es "la parte {part} está cortada: termina antes de cerrar su XML"
        en "the part {part} is cut off: it ends before its XML is closed"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Lo que falta podía ser un valor.", "What is missing might have been a value.";
        example made!("cut", "un libro con una hoja sin su última etiqueta", "a workbook with a sheet without its last tag");
    "W0241" AttributeTooLong Stop { attribute: String, most: usize }
        es "el atributo {attribute} ocupa más de {most} bytes"
        en "the attribute {attribute} is longer than {most} bytes"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Los atributos de estas partes se copian para cada hoja o formato.", "The attributes of these parts are copied for every sheet or format.";
        example made!("long-format", "un libro con un formato de número de 5000 letras", "a workbook with a number format of 5000 letters");
    "W0242" TextsAnnounced Stop {}
        es "uniqueCount anuncia más textos de los que caben en la parte"
        en "uniqueCount announces more texts than the part can hold"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "El lector reserva memoria para los textos anunciados antes de leerlos.",
            "The reader takes memory for the texts announced before it reads them.";
        example made!("announced", "un libro que anuncia 4294967295 textos", "a workbook that announces 4294967295 texts");
    "W0243" TextsDamaged Stop {}
        es "la tabla de textos está dañada"
        en "the table of shared texts is damaged"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Las celdas nombran los textos por su número de orden: si uno sobra, todos los demás cambian.",
            "Cells name texts by their number: where one is too many, all others change.";
        example made!("nested-text", "un libro con un texto dentro de otro en la tabla de textos", "a workbook with a text inside another in the table of texts");
    "W0244" TooManyTexts Stop { most: usize }
        es "el libro tiene más de {most} textos"
        en "the workbook has more than {most} texts"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Los textos se guardan todos en memoria.", "All texts are kept in memory.";
        example made!("million-texts", "un libro con 1000001 textos", "a workbook with 1000001 texts");
    "W0245" TooManyFormats Stop { most: usize }
        es "el libro tiene más de {most} formatos"
        en "the workbook has more than {most} cell formats"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Excel mismo no admite más, y todos se copian en memoria.", "Excel itself takes no more, and all are copied into memory.";
        example made!("formats", "un libro con 65537 formatos de celda", "a workbook with 65537 cell formats");
    "W0246" TooManyBrackets Stop {}
        es "un formato de número tiene demasiados corchetes"
        en "a number format has too many brackets"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "El lector los cuenta en ocho bits y con más se pierde.", "The reader counts them in eight bits and loses its way with more.";
        example made!("brackets", "un libro con un formato de número de 300 corchetes", "a workbook with a number format of 300 brackets");
    "W0251" NoSheets Stop { part: String }
        es "el libro no tiene hojas: falta {part}, o no nombra ninguna"
        en "there are no sheets: {part} is missing or names none"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Los valores están en las hojas.", "The values stand on the sheets.";
        example made!("no-workbook", "un libro sin la parte xl/workbook.xml", "a workbook without the part xl/workbook.xml");
    "W0252" TooManyRelations Stop {}
        es "demasiadas relaciones"
        en "too many relationships"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Cada hoja se busca en toda la lista de relaciones.", "Every sheet is looked up in the whole list of relationships.";
        example made!("relations", "un libro con 2001 relaciones", "a workbook with 2001 relationships");
    "W0253" TooManySheets Stop {}
        es "demasiadas hojas"
        en "too many sheets"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Un formulario tiene unas pocas hojas; mil son de otra cosa.", "A form has a few sheets; a thousand are of something else.";
        example made!("sheets", "un libro con 1001 hojas", "a workbook with 1001 sheets");
    "W0254" SheetStateUnknown Stop { sheet: String }
        es "la hoja \"{sheet}\" tiene un estado desconocido"
        en "the sheet \"{sheet}\" has an unknown state"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Una hoja se ve o está oculta; otra cosa no la escribe ningún programa.",
            "A sheet is shown or hidden; no program writes anything else.";
        example made!("state", "un libro con state=\"odd\" en una hoja", "a workbook with state=\"odd\" for a sheet");
    "W0255" SheetWithoutPart Stop { sheet: String }
        es "la hoja \"{sheet}\" no tiene parte en el paquete"
        en "the sheet \"{sheet}\" has no part in the package"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "La lista de hojas nombra una relación que no existe.", "The list of sheets names a relationship that does not exist.";
        example made!("unrelated", "un libro con r:id=\"rId99\" en una hoja", "a workbook with r:id=\"rId99\" for a sheet");
    "W0256" SheetOfOtherKind Stop { sheet: String }
        es "la hoja \"{sheet}\" es de una clase que no se lee"
        en "the sheet \"{sheet}\" is of a kind that is not read"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Solo hojas de celdas, gráficos y diálogos se conocen.", "Only sheets of cells, charts and dialogues are known.";
        example made!("macro-sheet", "un libro con una hoja de macros de Excel 4", "a workbook with a sheet of Excel 4 macros");
    "W0257" SheetOutside Stop { sheet: String, target: String }
        es "la hoja \"{sheet}\" está en \"{target}\", fuera del paquete"
        en "the sheet \"{sheet}\" stands in \"{target}\", outside of the package"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Ningún programa de hojas de cálculo escribe tal ruta.", "No spreadsheet program writes such a path.";
        example made!("sheet-outside", "un libro con una hoja en ../../sheet1.xml", "a workbook with a sheet in ../../sheet1.xml");
    "W0258" SheetPartMissing Stop { part: String, sheet: String }
        es "falta la parte {part} de la hoja \"{sheet}\""
        en "the part {part} of the sheet \"{sheet}\" is missing"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Las celdas de la hoja están en esa parte.", "The cells of the sheet stand in that part.";
        example made!("no-part", "un libro sin la parte de su primera hoja", "a workbook without the part of its first sheet");
    "W0261" WorkbookUnread Stop { reason: String }
        es "el libro no se puede leer: {reason}"
        en "the workbook cannot be read: {reason}"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "El lector de hojas no toma el libro, por la razón que da.", "The reader of sheets does not take the workbook, for the reason that it gives.";
        example Example::Never(t(
            "lo que el lector no toma se rechaza antes por su nombre; esto guarda lo que falte",
            "what the reader does not take is refused by name before; this keeps what was forgotten"));
    "W0262" SheetUnread Stop { sheet: String, reason: String }
        es "la hoja \"{sheet}\" no se puede leer: {reason}"
        en "the sheet \"{sheet}\" cannot be read: {reason}"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "El lector de hojas no toma la hoja, por la razón que da.", "The reader of sheets does not take the sheet, for the reason that it gives.";
        example Example::Never(t(
            "lo que el lector no toma se rechaza antes por su nombre; esto guarda lo que falte",
            "what the reader does not take is refused by name before; this keeps what was forgotten"));
    "W0263" TooManyRows Stop { sheet: String, most: usize, last: String }
        es "la hoja \"{sheet}\" tiene más de {most} filas con contenido en las columnas A a {last}"
        en "the sheet \"{sheet}\" has more than {most} rows with content in columns A to {last}"
        remedy "borre del libro las hojas que no sean de entrada, o parta de un libro nuevo con \"rodete new\"",
            "delete the sheets that are not input from the workbook, or start from a new one with \"rodete new\"";
        why "Un formulario tiene decenas de filas; una hoja de miles es de resultados.",
            "A form has some dozens of rows; a sheet of thousands is one of results.";
        example made!("rows", "un libro con 10001 filas rellenas en su primera hoja", "a workbook with 10001 filled rows on its first sheet");
}
