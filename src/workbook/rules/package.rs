//! The package and its parts: what a file must be before its cells are read.

use super::made;
use crate::finding::rule::rules;
use crate::text::Text;

rules! {
    /// The rows of packages and their parts.
    RULES;

    "W0201" FileEmpty Stop {}
        es "el archivo está vacío"
        en "the file is empty"
        remedy "vuelva a copiarlo del original", "copy it again from the original";
        why "Una copia o una descarga interrumpida deja a menudo un archivo vacío.",
            "An interrupted copy or download often leaves an empty file.";
        example made!("empty", "un archivo de 0 bytes", "a file of 0 bytes");
    "W0202" OldOrProtected Stop {}
        es "es un .xls antiguo o un libro protegido con contraseña"
        en "old .xls or password-protected workbook"
        remedy "guárdelo como libro de Excel (.xlsx) sin contraseña", "save it as an Excel workbook (.xlsx) without a password";
        why "Ambos empiezan por los mismos bytes, y solo Excel puede leerlos.",
            "Both begin with the same bytes, and only Excel can read them.";
        example made!("old", "un libro guardado como .xls", "a workbook saved as .xls");
    "W0203" NoWorkbook Stop { head: String }
        es "no es un libro .xlsx (empieza por \"{head}\")"
        en "this is not an .xlsx workbook (starts with \"{head}\")"
        remedy "ábralo en Excel o LibreOffice y guárdelo como .xlsx", "open it in Excel or LibreOffice and save it as .xlsx";
        why "Un archivo de texto o una página web con nombre de libro no tiene celdas.",
            "A text file or a web page named like a workbook has no cells.";
        example made!("text", "un texto, «hello», con el nombre de un libro", "a text, \"hello\", under the name of a workbook");
    "W0204" OtherFormat Stop { format: Text }
        es "es un archivo {format}, no un libro .xlsx"
        en "this is an {format} file, not an .xlsx workbook"
        remedy "guárdelo como .xlsx", "save it as .xlsx";
        why "Es un paquete zip como un .xlsx, pero con otras partes.", "It is a zip package like an .xlsx, but with other parts.";
        example made!("zip", "un .zip cualquiera con el nombre de un libro", "any .zip under the name of a workbook");
    "W0205" MacrosNotRead Note {}
        es "el libro lleva macros (.xlsm): rodete ni las ejecuta ni las lee"
        en "the workbook contains macros (.xlsm): rodete neither runs nor reads them"
        remedy "", "";
        why "Las celdas no contienen lo que escribiría una macro hasta que se guarda el libro.",
            "The cells do not hold what a macro would write until the workbook is saved.";
        example made!("macros", "un libro con macros", "a workbook with macros");
    "W0206" ProgramForWorkbook Stop { head: String }
        es "es un programa, no un libro .xlsx (empieza por \"{head}\")"
        en "this is a program, not an .xlsx workbook (starts with \"{head}\")"
        remedy "dé el libro; un programa se comprueba con rodete verify", "give the workbook; rodete verify checks programs";
        why "Este comando lee las celdas de un libro; los programas los lee rodete verify.",
            "This command reads the cells of a workbook; rodete verify reads programs.";
        example made!("g-code", "un programa con el nombre de un libro", "a program under the name of a workbook");
    "W0211" TooManyEntries Stop { most: usize }
        es "el paquete tiene más de {most} partes; un libro .xlsx tiene menos"
        en "the package has more than {most} entries; an .xlsx workbook has fewer"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "rodete lee primero en memoria la lista de partes.", "rodete first reads the list of entries into memory.";
        example made!("many-entries", "un zip de 2000 partes", "a zip of 2000 entries");
    "W0212" ZipEndMissing Stop {}
        es "no es un .xlsx completo (falta el final del zip)"
        en "not a complete .xlsx (zip end missing)"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Al final del paquete está la lista de sus partes: sin la lista no se sabe dónde empieza cada una.",
            "The end of the package lists its parts: without it, it is not clear where each part begins.";
        example made!("half", "la primera mitad de un libro", "the first half of a workbook");
    "W0213" ZipDirectoryDamaged Stop { reason: String }
        es "no es un .xlsx completo (el directorio del zip está dañado: «{reason}»)"
        en "not a complete .xlsx (the zip directory is damaged: {reason})"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "La lista apunta a sitios donde no están las partes.", "The list points to places where the parts are not.";
        example made!("directory", "un libro con bytes cambiados en la lista de sus partes",
            "a workbook with bytes changed in the list of its parts");
    "W0214" EntryTwice Stop {}
        es "dos partes del paquete tienen el mismo nombre"
        en "two entries of the package have the same name"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Cada programa podría leer una distinta.", "Each program might read a different one.";
        example made!("doubled", "un paquete con dos partes xl/aa", "a package with two entries xl/aa");
    "W0215" EntryTwiceButForCapitals Stop { entry: String }
        es "dos partes del paquete se llaman \"{entry}\" (sin distinguir mayúsculas)"
        en "two entries of the package are named \"{entry}\" (apart from upper and lower case)"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Los programas buscan las partes sin distinguir mayúsculas: cada uno podría leer una distinta.",
            "Programs ignore case when they look up parts: each might read a different one.";
        example made!("capitals", "un paquete con xl/workbook.xml y XL/Workbook.xml", "a package with xl/workbook.xml and XL/Workbook.xml");
    "W0216" EntryOutside Stop { entry: String }
        es "una parte del paquete se llama \"{entry}\" y apunta fuera del paquete"
        en "an entry of the package is named \"{entry}\" and points outside the package"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Ninguna hoja de cálculo escribe un nombre así: puede ser un intento de llegar a otros archivos.",
            "No spreadsheet writes such a name: it may be an attempt to reach other files.";
        example made!("outside", "un paquete con la parte xl/../../etc/passwd", "a package with the entry xl/../../etc/passwd");
    "W0217" EntryEncrypted Stop {}
        es "el libro está cifrado; guárdelo como .xlsx sin contraseña"
        en "the workbook is encrypted; save it as .xlsx without a password"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Sin la contraseña no se pueden leer las partes.", "Without the password the parts cannot be read.";
        example made!("encrypted", "un paquete zip con contraseña", "a zip package with a password");
    "W0218" EntryDamaged Stop { entry: String, how: Text }
        es "{entry} está dañado ({how})"
        en "{entry} is damaged ({how})"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "La parte ya no es como se guardó: podría cambiar un valor.", "The part is not as it was saved: a value might be wrong.";
        example made!("checksum", "un libro con un bit cambiado en una hoja", "a workbook with one bit changed in a sheet");
    "W0220" PartTooLarge Stop { part: String, most: u64 }
        es "{part}: el libro ocupa descomprimido más de {most} MiB en una sola parte"
        en "{part}: the workbook unpacks to more than {most} MiB in one part"
        remedy "ponga el formulario en un libro propio con \"rodete new\", o reduzca esa parte, una imagen o una hoja con muchos datos",
            "put the form into a workbook of its own with \"rodete new\", or make that part smaller: an image, or a sheet with much data";
        why "Unos kilobytes comprimidos pueden llenar la memoria al descomprimirse.",
            "A few compressed kilobytes can fill the memory when unpacked.";
        example made!("bomb", "un libro con una imagen de más de 64 MiB de ceros", "a workbook with an image of more than 64 MiB of zeros");
    "W0221" PackageTooLarge Stop { most: u64 }
        es "el libro ocupa descomprimido más de {most} MiB"
        en "the workbook unpacks to more than {most} MiB in all"
        remedy "ponga el formulario en un libro propio con \"rodete new\", o reduzca las imágenes y las hojas con muchos datos",
            "put the form into a workbook of its own with \"rodete new\", or make its images and the sheets with much data smaller";
        why "Unos kilobytes comprimidos pueden llenar la memoria al descomprimirse.",
            "A few compressed kilobytes can fill the memory when unpacked.";
        example made!("bombs", "un libro con cinco imágenes de 60 MiB de ceros", "a workbook with five images of 60 MiB of zeros");
    "W0231" PartUtf16 Stop { part: String }
        es "no se puede leer ninguna celda: la parte {part} está en UTF-16"
        en "no cells can be read: the part {part} is stored as UTF-16"
        remedy "ábralo en Excel o LibreOffice y guárdelo de nuevo como .xlsx", "open it in Excel or LibreOffice and save it again as .xlsx";
        why "El lector tomaría la hoja por vacía.", "The reader would take the sheet for an empty one.";
        example made!("utf16", "un libro con una hoja en UTF-16", "a workbook with a sheet in UTF-16");
    "W0232" PartNotUtf8 Stop { part: String, byte: usize }
        es "la parte {part} está dañada: en el byte {byte} no hay UTF-8 válido"
        en "the part {part} is damaged: byte {byte} is not valid UTF-8"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Esos bytes no son texto: podría cambiar un valor.", "These bytes are not text: a value might be wrong.";
        example made!("latin1", "un libro con una letra de Latin-1 en una hoja", "a workbook with a letter of Latin-1 in a sheet");
    "W0233" PartIllFormed Stop { part: String, byte: u64, reason: String }
        es "la parte {part} está dañada: XML mal formado en el byte {byte} («{reason}»)"
        en "the part {part} is damaged: XML not well formed at byte {byte} ({reason})"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Si las etiquetas no cuadran, no se sabe qué celda es cuál.", "If the tags do not match, it is not clear which cell is which.";
        example made!("entity", "un libro con una entidad &xxe; en una hoja", "a workbook with an entity &xxe; in a sheet");
    "W0234" PartTooDeep Stop { part: String, most: usize }
        es "la parte {part} tiene más de {most} elementos anidados"
        en "the part {part} has more than {most} nested elements"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Una hoja tiene unos cinco niveles; más solo gastan memoria.",
            "A sheet has about five levels; more only cost memory.";
        example made!("deep", "un libro con 300 elementos uno dentro de otro", "a workbook with 300 elements inside one another");
    "W0235" TooManyAttributes Stop { part: String, most: usize }
        es "la parte {part} tiene más de {most} atributos en una etiqueta"
        en "the part {part} has more than {most} attributes in one tag"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "rodete compara cada atributo con todos los demás de su etiqueta.", "rodete compares each attribute with all the others of its tag.";
        example made!("attributes", "un libro con una etiqueta de 100001 atributos", "a workbook with a tag of 100001 attributes");
    "W0236" DocumentType Stop { part: String }
        es "la parte {part} declara un tipo de documento (DTD), que un libro .xlsx no puede tener"
        en "the part {part} declares a document type (DTD), which is not allowed in an .xlsx workbook"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Un tipo de documento puede traer el contenido de otros archivos.", "A document type can bring in the contents of other files.";
        example made!("dtd", "un libro con <!DOCTYPE …> en una hoja", "a workbook with <!DOCTYPE …> in a sheet");
    "W0237" OtherEncoding Stop { part: String, encoding: String }
        es "la parte {part} declara la codificación {encoding}; rodete solo lee UTF-8"
        en "the part {part} declares the encoding {encoding}; rodete reads only UTF-8"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "En otra codificación los mismos bytes son otras letras.", "In another encoding the same bytes are other letters.";
        example made!("encoding", "un libro que declara encoding=\"latin1\" en una hoja", "a workbook that declares encoding=\"latin1\" in a sheet");
    "W0238" PartCutOff Stop { part: String }
        es "la parte {part} está cortada: su XML no está cerrado"
        en "the part {part} is cut off: its XML is not closed"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Puede faltar un valor.", "A value may be missing.";
        example made!("cut", "un libro con una hoja sin su última etiqueta", "a workbook with a sheet without its last tag");
    "W0241" AttributeTooLong Stop { attribute: String, most: usize }
        es "el atributo {attribute} ocupa más de {most} bytes"
        en "the attribute {attribute} is longer than {most} bytes"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "El lector copia estos atributos para cada hoja o formato.", "The reader copies these attributes for every sheet or format.";
        example made!("long-format", "un libro con un formato de número de 5000 letras", "a workbook with a number format of 5000 letters");
    "W0242" TextsAnnounced Stop {}
        es "uniqueCount anuncia más textos de los que caben en la parte"
        en "uniqueCount announces more texts than the part can hold"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "El lector reserva memoria para los textos antes de leerlos.",
            "The reader reserves memory for the texts before it reads them.";
        example made!("announced", "un libro que anuncia 4294967295 textos", "a workbook that announces 4294967295 texts");
    "W0243" TextsDamaged Stop {}
        es "la tabla de textos está dañada"
        en "the table of shared texts is damaged"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Las celdas remiten a los textos por su número: si sobra uno, cambian todos los demás.",
            "Cells refer to texts by number: one text too many shifts all the others.";
        example made!("nested-text", "un libro con un texto dentro de otro en la tabla de textos", "a workbook with a text inside another in the table of texts");
    "W0244" TooManyTexts Stop { most: usize }
        es "el libro tiene más de {most} textos"
        en "the workbook has more than {most} texts"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "rodete guarda todos los textos en memoria.", "rodete keeps all texts in memory.";
        example made!("million-texts", "un libro con 1000001 textos", "a workbook with 1000001 texts");
    "W0245" TooManyFormats Stop { most: usize }
        es "el libro tiene más de {most} formatos"
        en "the workbook has more than {most} cell formats"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Excel tampoco admite más, y el lector los copia todos en memoria.", "Excel does not allow more either, and the reader copies them all into memory.";
        example made!("formats", "un libro con 65537 formatos de celda", "a workbook with 65537 cell formats");
    "W0246" TooManyBrackets Stop {}
        es "un formato de número tiene demasiados corchetes"
        en "a number format has too many brackets"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "El lector cuenta los corchetes con ocho bits y no puede contar más.", "The reader counts brackets with eight bits and cannot count more.";
        example made!("brackets", "un libro con un formato de número de 300 corchetes", "a workbook with a number format of 300 brackets");
    "W0251" NoSheets Stop { part: String }
        es "el libro no tiene hojas: falta {part}, o no nombra ninguna"
        en "there are no sheets: {part} is missing or names none"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Los valores están en las hojas.", "The values are on the sheets.";
        example made!("no-workbook", "un libro sin la parte xl/workbook.xml", "a workbook without the part xl/workbook.xml");
    "W0252" TooManyRelations Stop {}
        es "el libro tiene demasiadas relaciones"
        en "the workbook has too many relationships"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "rodete busca cada hoja en toda la lista de relaciones.", "rodete looks up every sheet in the whole list of relationships.";
        example made!("relations", "un libro con 2001 relaciones", "a workbook with 2001 relationships");
    "W0253" TooManySheets Stop {}
        es "el libro tiene demasiadas hojas"
        en "the workbook has too many sheets"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Un formulario tiene pocas hojas; mil son otra cosa.", "A form has a few sheets; a thousand mean something else.";
        example made!("sheets", "un libro con 1001 hojas", "a workbook with 1001 sheets");
    "W0254" SheetStateUnknown Stop { sheet: String }
        es "la hoja \"{sheet}\" tiene un estado desconocido"
        en "the sheet \"{sheet}\" has an unknown state"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Una hoja está visible u oculta; ningún programa escribe otra cosa.",
            "A sheet is visible or hidden; no program writes anything else.";
        example made!("state", "un libro con state=\"odd\" en una hoja", "a workbook with state=\"odd\" for a sheet");
    "W0255" SheetWithoutPart Stop { sheet: String }
        es "la hoja \"{sheet}\" no tiene parte en el paquete"
        en "the sheet \"{sheet}\" has no part in the package"
        remedy "ábralo en Excel o LibreOffice: si la hoja está entera, guárdelo de nuevo; si falta, vuelva a copiar el libro del original",
            "open it in Excel or LibreOffice: if the sheet is whole, save the workbook again; if it is lost, copy the workbook again from the original";
        why "La lista de hojas nombra una relación que no existe.", "The list of sheets names a relationship that does not exist.";
        example made!("unrelated", "un libro con r:id=\"rId99\" en una hoja", "a workbook with r:id=\"rId99\" for a sheet");
    "W0256" SheetOfOtherKind Stop { sheet: String }
        es "la hoja \"{sheet}\" es de una clase que rodete no lee"
        en "the sheet \"{sheet}\" is of a kind that rodete does not read"
        remedy "ponga el formulario en otro libro con \"rodete new\"; si esa hoja ya no hace falta, basta con borrarla",
            "put the form into another workbook with \"rodete new\"; if that sheet is no longer needed, delete it instead";
        why "rodete solo conoce hojas de celdas, de gráficos y de diálogos.", "rodete knows only sheets of cells, charts and dialogues.";
        example made!("macro-sheet", "un libro con una hoja de macros de Excel 4", "a workbook with a sheet of Excel 4 macros");
    "W0257" SheetOutside Stop { sheet: String, target: String }
        es "la hoja \"{sheet}\" está en \"{target}\", fuera del paquete"
        en "the sheet \"{sheet}\" is in \"{target}\", outside the package"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Ninguna hoja de cálculo escribe una ruta así.", "No spreadsheet writes such a path.";
        example made!("sheet-outside", "un libro con una hoja en ../../sheet1.xml", "a workbook with a sheet in ../../sheet1.xml");
    "W0258" SheetPartMissing Stop { part: String, sheet: String }
        es "falta la parte {part} de la hoja \"{sheet}\""
        en "the part {part} of the sheet \"{sheet}\" is missing"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "Las celdas de la hoja están en esa parte.", "The sheet's cells are in that part.";
        example made!("no-part", "un libro sin la parte de su primera hoja", "a workbook without the part of its first sheet");
    "W0261" WorkbookUnread Stop { reason: String }
        es "el libro no se puede leer: «{reason}»"
        en "the workbook cannot be read: {reason}"
        remedy "ábralo en Excel o LibreOffice, guárdelo de nuevo como .xlsx, o vuelva a copiarlo del original",
            "open it in Excel or LibreOffice and save it again as .xlsx, or copy it again from the original";
        why "El lector de hojas no admite el libro, por la razón indicada.", "The sheet reader does not accept the workbook, for the reason given.";
        example made!("no-texts", "un libro cuya parte de textos no es una lista de textos", "a workbook whose part of texts is no list of texts");
    "W0263" TooManyRows Stop { sheet: String, most: usize, last: String }
        es "la hoja \"{sheet}\" tiene más de {most} filas con contenido en las columnas A a {last}"
        en "the sheet \"{sheet}\" has more than {most} rows with content in columns A to {last}"
        remedy "borre las hojas que no sean de entrada, o parta de un libro nuevo con \"rodete new\"",
            "delete the sheets that are not input, or start from a new workbook with \"rodete new\"";
        why "Un formulario tiene decenas de filas; una hoja de miles es una hoja de resultados.",
            "A form has some dozens of rows; a sheet with thousands is a results sheet.";
        example made!("rows", "un libro con 10001 filas rellenas en su primera hoja", "a workbook with 10001 filled rows on its first sheet");
}
