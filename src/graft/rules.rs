//! Findings about a workbook that sheets are put into: one row each.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::{Text, t};

/// A workbook that no text shows.
macro_rules! made {
    ($key:literal, $es:literal, $en:literal) => {
        Example::Made { key: $key, how: t($es, $en) }
    };
}

rules! {
    /// The rows of workbooks that sheets are put into.
    RULES;

    "B0101" BookSigned Stop {}
        es "el libro lleva una firma digital"
        en "the workbook is digitally signed"
        remedy "quite la firma en Excel (Archivo, Información), o prescinda de --into",
            "remove the signature in Excel (File, Info), or do without --into";
        why "Cualquier cambio en el libro rompe la firma.", "Any change to the workbook breaks the signature.";
        example made!("into-signed", "build --into de un libro firmado", "build --into of a signed workbook");
    "B0102" StructureLocked Stop {}
        es "la estructura del libro está protegida: no admite hojas nuevas"
        en "the structure of the workbook is protected: it takes no new sheets"
        remedy "quite la protección del libro (Revisar, Proteger libro), o prescinda de --into",
            "switch off Protect Workbook (Review), or do without --into";
        why "Quien protegió la estructura no quiere que cambien las hojas.", "Whoever protected the structure wants the sheets to stay as they are.";
        example made!("into-locked", "build --into de un libro con la estructura protegida",
            "build --into of a workbook with a protected structure");
    "B0103" RevisionsLocked Stop {}
        es "el libro guarda un historial de cambios protegido"
        en "the workbook keeps a protected history of changes"
        remedy "quite la protección del libro compartido, o prescinda de --into", "switch off the protection of the shared workbook, or do without --into";
        why "El historial debe contener todos los cambios, y rodete no los anota.",
            "The history must hold every change, and rodete does not record any.";
        example made!("into-revisions-locked", "build --into de un libro con lockRevision", "build --into of a workbook with lockRevision");
    "B0104" BookShared Stop {}
        es "el libro es compartido, con historial de cambios"
        en "the workbook is shared, with a history of changes"
        remedy "deje de compartirlo (Revisar, Compartir libro), o prescinda de --into",
            "stop sharing it (Review, Share Workbook), or do without --into";
        why "El historial debe contener todos los cambios, y rodete no los anota.",
            "The history must hold every change, and rodete does not record any.";
        example made!("into-shared", "build --into de un libro compartido", "build --into of a shared workbook");
    "B0105" BookStrict Stop {}
        es "el libro es de la variante estricta del formato"
        en "the workbook is of the strict variant of the format"
        remedy "guárdelo en Excel como \"Libro de Excel (.xlsx)\", o prescinda de --into",
            "save it in Excel as \"Excel Workbook (.xlsx)\", or do without --into";
        why "Sus partes usan otros nombres; mezclados, Excel no abre el libro.",
            "Its parts use other names; mixed, Excel does not open the workbook.";
        example made!("into-strict", "build --into de un libro guardado como \"Libro estricto Open XML\"",
            "build --into of a workbook saved as \"Strict Open XML\"");
    "B0106" BookOfOtherKind Stop { kind: String }
        es "el archivo es una plantilla o un complemento, no un libro ({kind})"
        en "the file is a template or an add-in, not a workbook ({kind})"
        remedy "guárdelo como libro .xlsx o .xlsm", "save it as an .xlsx or .xlsm workbook";
        why "Una plantilla se copia en cada libro nuevo; los resultados de una pieza no deben ir en ella.",
            "A template is copied into every new workbook; the results of one part do not belong there.";
        example made!("into-template", "build --into de una plantilla", "build --into of a template");
    "B0107" CustomViews Stop {}
        es "el libro tiene vistas personalizadas"
        en "the workbook has custom views"
        remedy "bórrelas (Vista, Vistas personalizadas), o prescinda de --into", "delete them (View, Custom Views), or do without --into";
        why "Cada vista guarda el estado de todas las hojas, y las nuevas no están en ella.",
            "Each view keeps the state of every sheet, and new sheets are not in it.";
        example made!("into-views", "build --into de un libro con vistas personalizadas", "build --into of a workbook with custom views");
    "B0108" NoStyles Stop {}
        es "el libro no tiene formatos de celda"
        en "the workbook has no cell formats"
        remedy "ábralo en Excel o LibreOffice y guárdelo", "open it in Excel or LibreOffice and save it";
        why "Las hojas nuevas necesitan formatos, y el libro no tiene dónde ponerlos.",
            "The new sheets need formats, and the workbook has no place for them.";
        example made!("into-no-styles", "build --into de un libro sin la parte de estilos", "build --into of a workbook without the part of styles");
    "B0109" TooManyCellFormats Stop { most: usize }
        es "con las hojas nuevas el libro tendría más de {most} formatos de celda"
        en "with the new sheets the workbook would have more than {most} cell formats"
        remedy "quite formatos que no se usen, o prescinda de --into", "remove formats that are not used, or do without --into";
        why "Excel no admite más.", "Excel does not allow more.";
        example made!("into-formats", "build --into de un libro con 65490 formatos", "build --into of a workbook with 65490 formats");
    "B0110" BookTooLarge Stop {}
        es "con las hojas nuevas el libro sería demasiado grande para volver a leerlo"
        en "with the new sheets the workbook would be too large to be read again"
        remedy "genere los resultados sin --into, o con menos puntos", "build without --into, or with fewer points";
        why "El libro es entrada y resultado a la vez: rodete debe poder leerlo.", "The workbook is input and result at once: rodete must be able to read it.";
        example made!("into-large", "build --into de un libro con 995 hojas propias", "build --into of a workbook with 995 sheets of its own");
    "B0111" MarkLost Stop { sheet: String, mark: String, title: Text }
        es "la hoja \"{sheet}\" ya no parece de rodete, aunque el nombre oculto {mark} lleva a ella"
        en "the sheet \"{sheet}\" no longer looks like one of rodete's, although the hidden name {mark} leads to it"
        remedy "devuelva a su primera celda lo que decía: {title}; si la hoja es ya suya, cópiela en otra nueva y borre esta: rodete hará otra",
            "put back what its first cell said: {title}; if the sheet is yours by now, copy it to a new one and delete this one: rodete then makes another";
        why "rodete no sustituye una hoja que puede ser suya.", "rodete does not replace a sheet that may be yours.";
        example made!("into-mark", "build --into de un libro cuya hoja de resultados tiene otro título",
            "build --into of a workbook whose results sheet has another title");
    "B0112" DefinedNameTaken Stop { name: String, formula: String }
        es "el nombre {name} del libro ya es de otra cosa: {formula}"
        en "the workbook's name {name} already stands for something else: {formula}"
        remedy "cámbiele el nombre en el administrador de nombres, o bórrelo si es un resto de hojas de rodete", "rename it in the name manager, or delete it if it is left over from sheets of rodete";
        why "Las fórmulas de las hojas de rodete usan ese nombre; los que empiezan por derived_ son para sus resultados.",
            "The formulas of rodete's sheets use that name; those that begin with derived_ are for its results.";
        example made!("into-name", "build --into de un libro cuyo torus_R es otra celda", "build --into of a workbook whose torus_R is another cell");
    "B0113" FormThere Stop { sheet: String }
        es "el libro ya tiene un formulario, en la hoja \"{sheet}\""
        en "the workbook has a form already, on the sheet \"{sheet}\""
        remedy "rellene ese, o ponga el nuevo en otro libro", "fill in that one, or put the new one into another workbook";
        why "De dos formularios, rodete no sabría cuál leer.", "Of two forms rodete would not know which to build.";
        example made!("into-form", "new impeller --into de un libro que ya tiene uno", "new impeller --into of a workbook that has one");
    "B0114" SheetNameTaken Stop { sheet: String }
        es "el libro ya tiene una hoja \"{sheet}\""
        en "the workbook already has a sheet \"{sheet}\""
        remedy "cámbiele el nombre", "rename it";
        why "rodete encuentra esta lista por el nombre de su hoja.", "rodete finds this list by the name of its sheet.";
        example made!("into-list", "new lathe --into de un libro con una hoja \"HERRAMIENTAS\"", "new lathe --into of a workbook with a sheet \"TOOLS\"");
    "B0115" PrecisionAsShown Stop {}
        es "el libro calcula con la precisión que muestra: sus fórmulas redondearían las cifras verificadas"
        en "the workbook calculates with the precision as displayed: its formulas would round the verified figures"
        remedy "desactive \"Establecer precisión de pantalla\" (Archivo, Opciones, Avanzadas), o prescinda de --into",
            "switch off \"Set precision as displayed\" (File, Options, Advanced), or do without --into";
        why "Las tablas vivas se redondean entonces a los decimales de sus celdas, y hasta los datos tecleados cambian.",
            "The live tables are then rounded to the decimals of their cells, and even typed inputs change.";
        example made!("into-precision", "build --into de un libro con la precisión de pantalla",
            "build --into of a workbook with the precision as displayed");
    "B0116" ResultsThere Stop {}
        es "el libro es un libro de resultados de rodete: sus hojas de resultados no entraron con --into"
        en "the workbook is a results workbook of rodete: its results sheets did not go in with --into"
        remedy "genere sin --into, o con --into en el libro del formulario", "build without --into, or build the form's own workbook with --into";
        why "Con unas segundas hojas de resultados, los nombres de las primeras quedarían sin dueño.",
            "With second results sheets the names of the first ones would lead nowhere.";
        example made!("into-results", "build --into de un libro …-results.xlsx", "build --into of a …-results.xlsx workbook");
    "B0121" MacrosStay Note {}
        es "las macros del libro siguen como estaban"
        en "the macros of the workbook stay as they were"
        remedy "", "";
        why "rodete no lee ni escribe macros; una que recorra todas las hojas encontrará también las nuevas.",
            "rodete neither reads nor writes macros; one that goes through all sheets will also meet the new ones.";
        example made!("into-macros", "build --into de un libro .xlsm", "build --into of an .xlsm workbook");
    "B0122" ReadOnlyWished Note {}
        es "el libro pide que se abra solo para lectura; rodete lo ha cambiado"
        en "the workbook asks to be opened read-only; rodete changed it"
        remedy "", "";
        why "Es una recomendación de quien lo guardó; la copia de al lado es la anterior.",
            "It is a recommendation of whoever saved it; the copy beside it is the one before.";
        example made!("into-read-only", "build --into de un libro con \"Se recomienda solo lectura\"",
            "build --into of a workbook with \"read-only recommended\"");
    "B0123" CalculationManual Caution {}
        es "el libro se calcula a mano: sus fórmulas sobre las hojas nuevas pueden mostrar valores anteriores"
        en "the workbook calculates by hand: its formulas over the new sheets may show earlier values"
        remedy "pulse F9 al abrirlo, o elija el cálculo automático", "press F9 after opening it, or choose automatic calculation";
        why "rodete no cambia cómo calcula el libro.", "rodete does not change how the workbook calculates.";
        example made!("into-manual", "build --into de un libro con cálculo manual", "build --into of a workbook with manual calculation");
    "B0124" LinksElsewhere Caution {}
        es "el libro toma valores de otros libros; rodete usa los que están guardados en él"
        en "the workbook takes values from other workbooks; rodete uses those that are stored in it"
        remedy "actualice los vínculos antes de generar los resultados", "update the links before you build";
        why "Si el otro libro ha cambiado, los valores guardados son anteriores.",
            "If the other workbook has changed, the stored values are earlier ones.";
        example made!("into-links", "build --into de un libro con vínculos externos", "build --into of a workbook with external links");
    "B0125" CopyThere Note { path: String }
        es "{path} ya estaba: rodete lo deja como está y no guarda otra copia del libro"
        en "{path} was there already: rodete leaves it as it is and keeps no other copy of the workbook"
        remedy "", "";
        why "rodete guarda el libro de antes una sola vez, y no sustituye una copia que puede ser la primera.",
            "rodete keeps the workbook of before once only, and does not replace a copy that may be the first one.";
        example made!("into-kept", "new --into de un libro que ya tiene al lado un archivo .bak",
            "new --into of a workbook that has a .bak file beside it");
    "B0126" SheetCopied Caution { sheet: String }
        es "la hoja {sheet} es una copia de una de rodete: sus cifras se quedan como están"
        en "sheet {sheet} is a copy of one of rodete's: its figures stay as they are"
        remedy "bórrela, o guarde la copia en otro libro", "delete it, or keep the copy in another workbook";
        why "Su línea se pone roja cuando el libro se genera con otros datos; la de una copia hecha con un rodete anterior sigue diciendo «Datos verificados».",
            "Its line turns red when the workbook is built of other inputs; that of a copy from an earlier rodete goes on saying \"Verified inputs\".";
        example made!("into-copied", "build --into de un libro con una copia de una hoja de resultados",
            "build --into of a workbook with a copy of a sheet of the results");
    "B0131" NotPutIn Stop { what: Text }
        es "las hojas no han entrado en el libro como debían: {what}"
        en "the sheets did not go into the workbook as they should: {what}"
        remedy fault "es un fallo de rodete: comuníquelo; genere los resultados sin --into", "this is a fault in rodete: report it; build without --into";
        why "rodete vuelve a leer el libro antes de entregarlo y no entrega uno que no sea como debe.",
            "rodete reads the workbook again before it delivers it, and does not deliver one that is not as it should be.";
        example Example::Never(t("es un fallo de rodete, no de la entrada", "it is a fault in rodete, not in the input"));
}
