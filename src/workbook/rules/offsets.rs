//! The sheet of work offsets.

use super::made;
use crate::finding::rule::rules;
use crate::text::Text;

rules! {
    /// The rows of work offsets on a sheet.
    RULES;

    "W0701" OffsetsSheetNotFound Stop { wanted: Text, there: String }
        es "no se encuentra la hoja {wanted}; hay: {there}"
        en "sheet {wanted} not found; there are: {there}"
        remedy "dé el nombre de un libro que no exista: rodete lo escribe con los decalajes del archivo",
            "give the name of a workbook that does not exist: rodete writes it with the file's offsets";
        why "rodete lee los decalajes de una hoja con este nombre.", "rodete reads the offsets from a sheet with this name.";
        example made!("offsets-none", "el libro de un rodete en lugar de uno de orígenes", "an impeller workbook in place of one of offsets");
    "W0702" OffsetsSchemaMissing Stop { known: &'static str }
        es "la hoja no indica su esquema; rodete lee \"{known}\""
        en "the sheet does not name its schema; rodete reads \"{known}\""
        remedy "dé el nombre de un libro que no exista, para que rodete lo escriba, y pase a él los valores",
            "give the name of a workbook that does not exist, so that rodete writes it, and copy the values into it";
        why "El esquema fija qué significa cada columna.", "The schema fixes what each column means.";
        example made!("offsets-no-schema", "una hoja ORIGENES sin su esquema", "a sheet OFFSETS without its schema");
    "W0703" OffsetsOtherSchema Stop { found: String, known: &'static str }
        es "el esquema es \"{found}\"; rodete lee \"{known}\""
        en "the schema is \"{found}\"; rodete reads \"{known}\""
        remedy "dé el nombre de un libro que no exista, para que rodete lo escriba, y pase a él los valores",
            "give the name of a workbook that does not exist, so that rodete writes it, and copy the values into it";
        why "En otra versión una misma columna puede significar otra cosa.", "In another version the same column may mean something else.";
        example made!("offsets-schema", "una hoja ORIGENES del esquema rodete-offsets 9", "a sheet OFFSETS of the schema rodete-offsets 9");
    "W0704" SeveralTables Stop {}
        es "hay varias filas de títulos"
        en "there are several rows of headings"
        remedy "deje una sola tabla en la hoja", "keep only one table on the sheet";
        why "No se sabe cuál de las tablas vale.", "It is not clear which table counts.";
        example made!("offsets-tables", "una hoja ORIGENES con dos filas de títulos", "a sheet OFFSETS with two rows of headings");
    "W0705" OffsetsUnitNotSaid Stop { column: &'static str, unit: &'static str, cell: String }
        es "{column} no indica su unidad"
        en "{column} does not give its unit"
        remedy "escriba {unit} en {cell}", "write {unit} in {cell}";
        why "Unos decalajes en pulgadas leídos como milímetros llevan la herramienta contra la pieza.",
            "Offsets in inches read as millimetres take the tool into the work.";
        example made!("offsets-unit-empty", "una hoja ORIGENES con la unidad de X borrada", "a sheet OFFSETS with the unit of X cleared");
    "W0706" OffsetsOtherUnit Stop { column: &'static str, written: String, unit: &'static str, cell: String }
        es "{column} está en \"{written}\", pero el archivo está en {unit}"
        en "{column} is in \"{written}\", but the file is in {unit}"
        remedy "escriba {unit} en {cell}", "write {unit} in {cell}";
        why "rodete compara las unidades y no las convierte.", "rodete compares units and does not convert them.";
        example made!("offsets-unit", "una hoja ORIGENES con X en cm", "a sheet OFFSETS with X in cm");
    "W0707" OffsetsInInches Stop { column: &'static str, written: String, unit: &'static str, cell: String }
        es "{column} está en \"{written}\", pero el archivo está en {unit}"
        en "{column} is in \"{written}\", but the file is in {unit}"
        remedy "dé --inch si la máquina trabaja en pulgadas; si no, convierta los valores y escriba {unit} en {cell}",
            "give --inch if the machine works in inches; otherwise convert the values and write {unit} in {cell}";
        why "El archivo de parámetros no indica su unidad: la indica la opción.",
            "The parameter file does not give its unit: the option does.";
        example made!("offsets-inches", "una hoja ORIGENES con X en inch, leída sin --inch", "a sheet OFFSETS with X in inch, read without --inch");
    "W0708" OffsetsInMillimetres Stop { column: &'static str, written: String, unit: &'static str, cell: String }
        es "{column} está en \"{written}\", pero el archivo está en {unit}"
        en "{column} is in \"{written}\", but the file is in {unit}"
        remedy "quite --inch si la máquina trabaja en milímetros; si no, convierta los valores y escriba {unit} en {cell}",
            "leave out --inch if the machine works in millimetres; otherwise convert the values and write {unit} in {cell}";
        why "El archivo de parámetros no indica su unidad: la indica la opción.",
            "The parameter file does not give its unit: the option does.";
        example made!("offsets-millimetres", "una hoja ORIGENES en mm, leída con --inch", "a sheet OFFSETS in mm, read with --inch");
    "W0709" NoSystems Stop {}
        es "no hay ningún decalaje bajo los títulos"
        en "there is no work offset below the headings"
        remedy "escriba G54 a G59.3 en la columna A", "write G54 to G59.3 in column A";
        why "Sin su nombre no se sabe a qué decalaje pertenecen los valores.", "Without its name it is not clear which offset the values belong to.";
        example made!("offsets-empty", "una hoja ORIGENES sin filas", "a sheet OFFSETS without rows");
    "W0710" G92Rotation Stop { cell: String }
        es "G92 no tiene giro"
        en "G92 has no rotation"
        remedy "vacíe la celda {cell}", "empty cell {cell}";
        why "LinuxCNC guarda un giro con cada decalaje de G54 a G59.3, pero no con G92.",
            "LinuxCNC keeps a rotation with each offset from G54 to G59.3, but not with G92.";
        example made!("offsets-g92", "una hoja ORIGENES con un giro en la fila G92", "a sheet OFFSETS with a rotation in the row G92");
    "W0711" NoActiveSystem Stop {}
        es "ningún decalaje está activo"
        en "no work offset is active"
        remedy "escriba sí en uno de ellos, o quite la columna", "write yes for one of them, or delete the column";
        why "La máquina arranca siempre con un decalaje activo.", "The machine always starts with one active offset.";
        example made!("offsets-inactive", "una hoja ORIGENES con no en todos los sistemas", "a sheet OFFSETS with no for every system");
    "W0712" SeveralActiveSystems Stop { names: String }
        es "hay varios decalajes activos: {names}"
        en "several work offsets are active: {names}"
        remedy "deje sí en uno solo", "keep yes for only one";
        why "La máquina arranca con un solo decalaje activo.", "The machine starts with only one active offset.";
        example made!("offsets-active", "una hoja ORIGENES con sí en G54 y en G55", "a sheet OFFSETS with yes for G54 and for G55");
    "W0713" NotOnSheet Note { names: String }
        es "la hoja no lo nombra y queda como en el archivo: {names}"
        en "not on the sheet, so unchanged in the file: {names}"
        remedy "", "";
        why "rodete no borra lo que la hoja no nombra.", "rodete does not clear what the sheet does not name.";
        example made!("offsets-left", "una hoja ORIGENES sin la fila G59.3", "a sheet OFFSETS without the row G59.3");
    "W0714" LabelMistyped Stop { label: String, name: &'static str }
        es "\"{label}\" no es de esta tabla, a la que le falta {name}"
        en "\"{label}\" does not belong to this table, which lacks {name}"
        remedy "escriba {name} si es lo que quiere decir; si no, llámelo de otra manera o bórrelo",
            "write {name} if that is what is meant; if not, give it another name or delete it";
        why "Los valores junto a un nombre mal escrito no llegarían al archivo, y la máquina se movería con el cero de antes.",
            "The values beside a mistyped name would not get into the file, and the machine would move with the zero of before.";
        example made!("offsets-mistyped", "una hoja ORIGENES con G 55 en la columna A", "a sheet OFFSETS with G 55 in column A");
}
