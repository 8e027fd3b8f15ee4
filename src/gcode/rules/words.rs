//! What is wrong with the words of a block.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::Text;

rules! {
    /// The rows of this file.
    RULES;

    "G0101" Macros Stop {}
        es "rodete no admite macros (#, IF, WHILE, GOTO)"
        en "rodete does not follow macros (#, IF, WHILE, GOTO)"
        remedy "si el programa es de otro control, indíquelo: con --dialect, o en la hoja DATOS de un libro; si no, escriba lo que hace en bloques sencillos, o compruebe el programa en el control: si solo lo borra, el programa hace otra cosa", "if the program is for another control, name it: with --dialect, or on the sheet DATA of a workbook; if not, write what it does as plain blocks, or check the program at the control: if you only delete it, the program does something else";
        why "Una macro calcula y decide en el control: sin ejecutarla no se sabe qué hace el programa.",
            "A macro computes and decides inside the control: without running it nobody knows what the program does.";
        example Example::program("fanuc-lathe-a", "G21 G98|#1=5|M30", "2:1");
    "G0102" Negative Stop { letter: char, value: f64 }
        es "{letter} negativo: {value}"
        en "negative {letter}: {value}"
        remedy "escriba un número positivo", "write a positive number";
        why "Este número cuenta o mide algo que no puede ser negativo.",
            "This number counts or measures something that cannot be below 0.";
        example Example::program("linuxcnc", "G21 G90 F100|G1 X1 F-5|M2", "2:8");
    "G0103" WordTwice Stop { letter: char }
        es "dos palabras {letter} en un bloque"
        en "two {letter} words in one block"
        remedy "deje una, o escriba dos bloques", "keep one, or write two blocks";
        why "Unos controles usan la primera y otros la última.",
            "Some controls use the first, others the last.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X1 X2|M2", "2:4");
    "G0104" NumberParted Note {}
        es "número con espacios en medio"
        en "number with blanks inside"
        remedy "escríbalo sin espacios", "write it without blanks";
        why "Una persona ve dos números donde el control lee uno.",
            "A person sees two numbers where the control reads one.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X1 2|M2", "2:5");
    "G0105" FeedOrSpeedTooGreat Stop { letter: char, value: f64 }
        es "{letter}{value} supera 99 999.999"
        en "{letter}{value} is above 99,999.999"
        remedy "compruebe el número", "check the number";
        why "Ninguna máquina llega ahí: será un número equivocado.",
            "No machine goes there: it will be a wrong number.";
        example Example::program("linuxcnc", "G21 G90 F100|S100000|M2", "2:1");
    "G0106" CodeNotSupported Stop { code: f64, reason: Text }
        es "G{code} no está implementado: {reason}"
        en "G{code} is not supported: {reason}"
        remedy "si el programa es de otro control, indíquelo: con --dialect, o en la hoja DATOS de un libro; si no, escriba lo que hace en bloques sencillos, o compruebe el programa en el control: si solo lo borra, el programa hace otra cosa", "if the program is for another control, name it: with --dialect, or on the sheet DATA of a workbook; if not, write what it does as plain blocks, or check the program at the control: if you only delete it, the program does something else";
        why "rodete no sabe qué hace el código, así que nada de lo que sigue sería seguro.",
            "rodete does not know what the code does, so nothing after it would be certain.";
        example Example::program("linuxcnc", "G21 G90 F100|G33 Z1 K1|M2", "2:1");
    "G0107" TwoCodesOfGroup Stop { group: Text }
        es "dos códigos G del mismo grupo ({group})"
        en "two G codes of one modal group ({group})"
        remedy "deje uno, o escriba dos bloques", "keep one, or write two blocks";
        why "Los dos códigos se excluyen: no se sabe cuál vale.",
            "The two codes exclude each other: it is not clear which one counts.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 G1 X1|M2", "2:1");
    "G0108" MachineCodeNotSupported Stop { code: u32, reason: Text }
        es "rodete no admite M{code}: {reason}"
        en "rodete does not follow M{code}: {reason}"
        remedy "si el programa es de otro control, indíquelo: con --dialect, o en la hoja DATOS de un libro; si no, escriba lo que hace en bloques sencillos, o compruebe el programa en el control: si solo lo borra, el programa hace otra cosa", "if the program is for another control, name it: with --dialect, or on the sheet DATA of a workbook; if not, write what it does as plain blocks, or check the program at the control: if you only delete it, the program does something else";
        why "rodete no sabe qué hace el código, así que nada de lo que sigue sería seguro.",
            "rodete does not know what the code does, so nothing after it would be certain.";
        example Example::program("fanuc-lathe-a", "G21 G98|M198 P1|M30", "2:1");
    "G0109" MachineCodeOfBuilder Note { code: u32 }
        es "M{code} es un código del fabricante de la máquina: rodete no lo ejecuta"
        en "M{code} is a machine builder's code: rodete does not run it"
        remedy "", "";
        why "El fabricante de la máquina decidió qué hace el código, y rodete no puede saberlo.",
            "The machine builder decided what the code does, and rodete cannot know it.";
        example Example::program("linuxcnc", "G21 G90 F100|M101|M2", "2:1");
    "G0110" TwoMachineCodesOfGroup Stop {}
        es "dos códigos M del mismo grupo"
        en "two M codes of one modal group"
        remedy "deje uno, o escriba dos bloques", "keep one, or write two blocks";
        why "Los dos códigos se excluyen: no se sabe cuál vale.",
            "The two codes exclude each other: it is not clear which one counts.";
        example Example::program("linuxcnc", "G21 G90 F100|M3 M4 S100|M2", "2:1");
    "G0111" MachineCodesTooMany Stop { most: usize }
        es "más de {most} códigos M en un bloque"
        en "more than {most} M codes in one block"
        remedy "repártalos en varios bloques", "spread them over several blocks";
        why "El control no ejecuta más códigos M en un bloque.",
            "The control does not run more M codes in one block.";
        example Example::program("linuxcnc", "G21 G90 F100|S100 M3 M7 M48 M64 P1 M101|M2", "2:23");
    "G0112" Unknown Stop { letter: char, value: f64, dialect: &'static str }
        es "rodete no conoce {letter}{value} en el dialecto {dialect}"
        en "{letter}{value} is not known to rodete in the dialect {dialect}"
        remedy "compruebe el número, o indique el dialecto del programa: con --dialect, o en la hoja DATOS de un libro; si el control tiene el código, compruebe el programa en él", "check the number, or name the program's dialect: with --dialect, or on the sheet DATA of a workbook; if the control has the code, check the program there";
        why "El control se para en un código que no conoce, o lo interpreta de otra manera.",
            "The control stops at a code that it does not know, or reads it differently.";
        example Example::program("linuxcnc", "G21 G90 F100|G32 Z-5|M2", "2:1");
    "G0113" EdgeTwice Stop alarm Fanuc 53 {}
        es "más de un «,C» o «,R» en un bloque"
        en "more than one ',C' or ',R' in one block"
        remedy "deje uno", "keep one";
        why "Una esquina se rompe de una sola manera.",
            "A corner is broken in one way only.";
        example Example::program("fanuc-lathe-a", "G21 G98|G0 X40. Z2.|G1 Z-10. ,C1. ,R1. F100.|X50.|M30", "3:10");
    "G0114" EdgeNoSize Stop { edge: &'static str, value: f64 }
        es "{edge}{value} no es el tamaño de una esquina"
        en "{edge}{value} is not the size of a corner"
        remedy "dé una longitud sin signo", "give a length without a sign";
        why "Un chaflán o un radio no puede ser cero ni negativo.",
            "A chamfer or a radius cannot be zero or negative.";
        example Example::program("fanuc-lathe-a", "G21 G98|G0 X40. Z2.|G1 Z-10. ,C-1. F100.|X50.|M30", "3:12");
    "G0115" CoordinateTooGreat Stop { letter: char, value: f64, most: Text }
        es "{letter}{value} supera ±{most}"
        en "{letter}{value} is beyond ±{most}"
        remedy "compruebe el número", "check the number";
        why "Ninguna máquina llega ahí: será un número equivocado.",
            "No machine goes there: it will be a wrong number.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X100000|M2", "2:5");
    "G0116" WordTooGreat Stop { letter: char, value: f64 }
        es "{letter}{value} supera 9 999 999 999"
        en "{letter}{value} is above 9,999,999,999"
        remedy "compruebe el número", "check the number";
        why "Ningún control admite un número así: será erróneo.",
            "No control accepts such a number: it is probably wrong.";
        example Example::program("linuxcnc", "G21 G90 F100|T10000000000|M2", "2:2");
    "G0117" LetterNotSupported Stop { letter: char, dialect: &'static str }
        es "rodete no admite la letra {letter} del dialecto {dialect}"
        en "rodete does not follow letter {letter} of the dialect {dialect}"
        remedy "si el programa es de otro control, indíquelo: con --dialect, o en la hoja DATOS de un libro; si no, escriba lo que hace en bloques sencillos, o compruebe el programa en el control: si solo lo borra, el programa hace otra cosa", "if the program is for another control, name it: with --dialect, or on the sheet DATA of a workbook; if not, write what it does as plain blocks, or check the program at the control: if you only delete it, the program does something else";
        why "El control conoce esta letra y rodete no: rodete no puede comprobarla.",
            "The control knows this letter but rodete does not, and so cannot verify it.";
        example Example::program("fanuc-lathe-a", "G21 G98|G0 Y5.|M30", "2:4");
    "G0118" LetterUnknown Stop { letter: char, dialect: &'static str }
        es "la letra {letter} no se admite aquí en el dialecto {dialect}"
        en "letter {letter} is not allowed here in the dialect {dialect}"
        remedy "compruebe el bloque, o indique el dialecto: con --dialect, o en la hoja DATOS de un libro; sin la palabra el bloque puede hacer otra cosa",
            "check the block, or name the dialect: with --dialect, or on the sheet DATA of a workbook; without the word the block may do something else";
        why "El control se para en una letra que no conoce.",
            "The control stops at a letter that it does not know.";
        example Example::program("fagor-8055", "G0 X1 H5|M30", "1:7");
    "G0119" PointNotTaken Stop { letter: char, word: String }
        es "{word} lleva punto decimal, que {letter} no admite"
        en "{word} has a decimal point, which {letter} does not allow"
        remedy "escriba un número entero sin punto: P y Q cuentan incrementos mínimos, ms o milésimas de grado", "write a whole number without a point: P and Q count least increments, ms or thousandths of a degree";
        why "El control se para en un punto decimal en estas letras.",
            "The control stops at a decimal point in these letters.";
        example Example::program("fanuc-lathe-a", "G21 G98|G4 P1.5|M30", "2:4");
    "G0120" PointMissing Stop { word: String, reading: Text }
        es "{word} no lleva punto decimal: el control lee {reading}, según su ajuste"
        en "{word} has no decimal point: the control reads it as {reading}, depending on its setting"
        remedy "escriba {word}. o diga con --decimal-point cómo lo lee el control", "write {word}. or say with --decimal-point how the control reads it";
        why "Los controles leen un número entero de dos maneras, y una es mil veces la otra.",
            "Controls read a whole number in two ways, and one is a thousand times the other.";
        example Example::program("fanuc-lathe-a", "G21 G98|G0 X40 Z2.|M30", "2:4");
    "G0121" PointMissingInFeed Stop { word: String }
        es "{word} no lleva punto decimal: la unidad del avance por vuelta depende del control"
        en "{word} has no decimal point: the unit of a feed per revolution depends on the control"
        remedy "escriba {word}.", "write {word}.";
        why "Los controles leen un número entero de dos maneras, y una es mil veces la otra.",
            "Controls read a whole number in two ways, and one is a thousand times the other.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G99|G1 X40. F1|M30", at: "2:9", given: &[("--decimal-point", "micrometre")] };
    "G0122" DwellsWithoutPoint Note { reading: Text }
        es "tiempos de espera sin punto decimal, {reading}"
        en "dwell times without a decimal point, {reading}"
        remedy "", "";
        why "Con el otro ajuste, el control esperaría mil veces más o menos.",
            "With its other setting the control would dwell a thousand times longer or shorter.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98|G4 X2|M30", at: "2:4", given: &[("--decimal-point", "calculator")] };
    "G0123" DimensionsWithoutPoint Note { reading: Text }
        es "cotas sin punto decimal, {reading}"
        en "dimensions without decimal point, {reading}"
        remedy "", "";
        why "Con el otro ajuste, las cotas serían mil veces mayores o menores.",
            "With the control's other setting the dimensions would be a thousand times larger or smaller.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98|G0 X40 Z2.|M30", at: "2:4", given: &[("--decimal-point", "calculator")] };
    "G0124" DecimalsTooMany Caution { letter: char, decimals: usize, most: usize }
        es "{letter} tiene {decimals} decimales: el control admite {most}"
        en "{letter} has {decimals} decimals: the control takes {most}"
        remedy "redondee la cota", "round the dimension";
        why "El manual no dice si el control da una alarma o corta los decimales que sobran.",
            "The manual does not say whether the control raises an alarm or drops the other decimals.";
        example Example::program("fagor-8055", "G71 G90 G94 F100|G1 X10.1234567|M30", "2:4");
    "G0125" DwellNotWhole Stop { letter: char, value: f64, unit: f64, number: u8 }
        es "{letter}{value} en G{number}: {letter} cuenta unidades de {unit} s y admite un número entero"
        en "{letter}{value} in G{number}: {letter} counts units of {unit} s and takes a whole number"
        remedy "escriba el tiempo en esas unidades: 0.5 s son 50 centésimas", "write the time in these units: 0.5 s are 50 hundredths";
        why "Un decimal suele venir de un programa en segundos, y el control esperaría la centésima parte.",
            "A decimal often comes from a program in seconds, and the control would dwell a hundredth of it.";
        example Example::program("fagor-8055", "G71 G90 G94 F100|G4 K0.5|M30", "2:4");
    "G0126" DwellBesideArc Stop {}
        es "G4 con G2 o G3 en un bloque: los dos usan P"
        en "G4 with G2 or G3 in one block: both use P"
        remedy "póngalos en bloques distintos", "put them into blocks of their own";
        why "El control no sabe si P es el tiempo o las vueltas del arco, y se para.",
            "The control cannot know whether P is the time or the turns of the arc, and stops.";
        example Example::program("linuxcnc", "G21 G90 F100|G4 G2 X1 Y1 I1 J0 P1|M2", "2:1");
    "G0127" OrientWord Stop { letter: char, value: f64, range: &'static str }
        es "M19 con {letter}{value}: {letter} es {range}"
        en "M19 with {letter}{value}: {letter} is {range}"
        remedy "corrija {letter}", "correct {letter}";
        why "El control se para ante un ángulo, un sentido o un tiempo de espera que no hay.",
            "The control stops at an angle, a direction or a time limit that does not exist.";
        example Example::program("linuxcnc", "G21 G90 F100|M19 R361|M2", "2:5");
    "G0128" CycleInOneBlock Stop { letter: char, number: u8 }
        es "G{number} con {letter}: el ciclo está escrito en un solo bloque, como lo leen otros controles"
        en "G{number} with {letter}: the cycle is written in one block, as other controls read it"
        remedy "escríbalo en dos bloques: el primero con la profundidad y la retirada, el segundo con P y Q, o X y Z, y F",
            "write it in two blocks: the first with depth and retraction, the second with P and Q, or X and Z, and F";
        why "Este control lee G71 a G76 en dos bloques, con otras letras.", "This control reads G71 to G76 in two blocks, with other letters.";
        example Example::program("fanuc-lathe-a", "G21 G99|G0 X54. Z2.|G71 P10 Q20 U0.4 W0.1 D2000 F0.2|N10 G0 X30.|N20 G1 Z-20.|M30", "3:23");
    "G0129" MacroLanguage Stop { word: &'static str, dialect: &'static str }
        es "{word} pertenece a un lenguaje de macros que el dialecto {dialect} no tiene"
        en "{word} belongs to a macro language that the dialect {dialect} does not have"
        remedy "escriba los bloques sin macros; para LinuxCNC, con palabras O (O1 IF, O1 WHILE)",
            "write the blocks without macros; for LinuxCNC, with O-words (O1 IF, O1 WHILE)";
        why "El control lee las letras de una en una, cada una con su número, y se para.",
            "The control reads the letters one by one, each with its number, and stops.";
        example Example::program("linuxcnc", "G21 G90 F100|WHILE [#1 LT 3] DO1|G91 X1|END1|M2", "2:1");
    "G0130" UnknownToAll Stop { letter: char, value: f64, dialect: &'static str }
        es "rodete no conoce {letter}{value} en el dialecto {dialect}, y no lo ejecuta en ningún otro"
        en "{letter}{value} is not known to rodete in the dialect {dialect}, and rodete runs it in no other"
        remedy "compruebe el número; si el control tiene el código, escriba lo que hace en bloques sencillos, o compruebe el programa en él",
            "check the number; if the control has the code, write what it does as plain blocks, or check the program there";
        why "El control se para en un código que no conoce, y rodete no sabe qué hace en otro.",
            "The control stops at a code that it does not know, and rodete does not know what it does on another.";
        example Example::program("linuxcnc", "G21 G90 F100|G68 X0 Y0 R30|M2", "2:1");
    "G0131" TaperByOtherLetter Stop { letter: char, number: u8 }
        es "G{number} con {letter}: así escriben la conicidad otros controles; este la lee en R"
        en "G{number} with {letter}: other controls write the taper so; this one reads it from R"
        remedy "escriba R: el radio al principio del corte menos el del final; en G94, la Z del principio menos la del final",
            "write R: the radius where the cut begins less the one where it ends; in G94, the Z where it begins less the one where it ends";
        why "Sin R el ciclo corta un cilindro, o una cara plana.", "Without R the cycle cuts a cylinder, or a plane face.";
        example Example::program("fanuc-lathe-a", "G21 G99|G0 X54. Z2.|G92 X50. Z-20. I-1. F2.|M30", "3:16");
    "G0132" WordsOutOfOrder Stop { word: String, behind: char, error: String }
        es "{word} está detrás de {behind}, y el control pide otro orden{error}"
        en "{word} stands behind {behind}, and the control wants another order{error}"
        remedy "escriba las palabras del bloque en el orden G, X Y Z U V W A B C, F S T D, M, y las del centro en el orden I J K",
            "write the words of the block in the order G, X Y Z U V W A B C, F S T D, M, and those of the centre in the order I J K";
        why "El control comprueba el orden de las palabras y no ejecuta un bloque que tenga otro.",
            "The control checks the order of the words and does not run a block that has another.";
        example Example::program("fagor-8055", "G71 G90 G94|G1 A10 X5 F100|M30", "2:8");
    "G0133" MachineCodeNotFollowed Note { code: u32, what: Text }
        es "M{code}: {what}; rodete no lo ejecuta"
        en "M{code}: {what}; rodete does not run it"
        remedy "", "";
        why "El código no mueve los ejes; rodete no cuenta con lo que hace.",
            "The code moves no axis; rodete does not count on what it does.";
        example Example::program("fagor-8055", "G71 G90 G94 F100|S500 M3 M41|M30", "2:9");
    "G0134" PolarByLetters Stop { letter: char, first: char, second: char }
        es "{letter}: programación polar o con ángulo, que rodete no sigue"
        en "{letter}: polar or angle programming, which rodete does not follow"
        remedy "escriba el punto final con {first} y {second}: sin {letter} el bloque iría a otro sitio",
            "write the end point with {first} and {second}: without {letter} the block would go to another place";
        why "R es la distancia al origen polar y Q el ángulo, también junto a una sola cota: quitarlos cambia la trayectoria.",
            "R is the distance from the polar origin and Q the angle, also beside one coordinate: deleting them changes the path.";
        example Example::program("fagor-8055-t", "G71 G95 F0.2 S500 M3|G0 X60 Z5|G1 Z-10 Q150|M30", "3:9");
    "G0135" BlockRepeated Stop {}
        es "N al final del bloque: el número de repeticiones, que rodete no sigue"
        en "N at the end of the block: the number of repetitions, which rodete does not follow"
        remedy "escriba el bloque tantas veces como se hace: la primera, y una por cada repetición",
            "write the block as many times as it is made: once, and once more for each repetition";
        why "El control hace el bloque una vez y lo repite N veces más: quitar N deja trabajo sin hacer.",
            "The control makes the block once and repeats it N times more: deleting N leaves work undone.";
        example Example::program("fagor-8055", "G71 G91 G94 F100|G1 X10 N5|M30", "2:8");
    "G0136" CodeParted Stop { text: String }
        es "rodete lee «{text}» como un solo número, y no conoce tal código"
        en "rodete reads '{text}' as one number, and knows no such code"
        remedy "escriba cada número detrás de su letra y sin espacios", "write each number behind its letter and without blanks";
        why "Los espacios no separan palabras: las separan las letras.", "Blanks do not part words: letters do.";
        example Example::program("fagor-8070", "G71 G90 G94 F100|G4 0.5|M30", "2:1");
    "G0137" NameWithDigit Stop { name: String }
        es "{name}=: un eje o un husillo cuyo nombre lleva una cifra, que rodete no sigue"
        en "{name}=: an axis or a spindle with a digit in its name, which rodete does not follow"
        remedy "no quite «=»: el número sería otro; escriba el bloque con ejes de una sola letra, si la máquina los tiene, o compruebe el programa en el control",
            "do not take '=' out: the number would be another; write the block with axes of one letter, if the machine has them, or check the program at the control";
        why "X1=10 lleva el eje X1 a 10: sin «=» sería X110, otro eje y otra cota.",
            "X1=10 takes the axis X1 to 10: without '=' it would be X110, another axis and another position.";
        example Example::program("fagor-8070", "%A|G71 G90 G94 F100|G1 X1=10|M30", "3:6");
    "G0138" ParameterNotFollowed Stop { what: Text }
        es "{what} en lugar de un número, que rodete no sigue"
        en "{what} in place of a number, which rodete does not follow"
        remedy "escriba el número que tiene en ese bloque, o compruebe el programa en el control; si el programa es de otro control, indíquelo: con --dialect, o en la hoja DATOS de un libro",
            "write the number that it has in that block, or check the program at the control; if the program is for another control, name it: with --dialect, or on the sheet DATA of a workbook";
        why "El número está en el control, o lo calcula el programa allí: sin él no se sabe adónde va el bloque.",
            "The number is at the control, or the program computes it there: without it nobody knows where the block goes.";
        example Example::program("fagor-8055", "G71 G90 G94 F100 S900 M3|G1 XP122|M30", "2:5");
    "G0139" LocalSubroutine Stop {}
        es "subrutina local (%L, LL), que rodete no sigue"
        en "local subroutine (%L, LL), which rodete does not follow"
        remedy "escriba los bloques de la subrutina en el programa principal, en el lugar de cada llamada, o compruebe el programa en el control: si solo borra estas líneas, el programa hace otra cosa",
            "write the blocks of the subroutine into the main program, in the place of each call, or check the program at the control: if you only delete these lines, the program does something else";
        why "El control ejecuta la subrutina en cada llamada: sin seguirla no se sabe qué hace el programa.",
            "The control runs the subroutine at each call: without following it nobody knows what the program does.";
        example Example::program("fagor-8070", "%L CUT|G91 G1 Z-5 F100|M29|%MAIN|G0 X0|LL CUT|M30", "1:1");
    "G0140" ChamferWithoutComma Stop { letter: char, dialect: &'static str, size: String }
        es "rodete no admite la letra {letter} del dialecto {dialect}"
        en "rodete does not follow letter {letter} of the dialect {dialect}"
        remedy "para un chaflán escriba ,{letter}{size} con coma; si el programa es de otro control, indíquelo: con --dialect, o en la hoja DATOS de un libro; si no, escriba lo que hace en bloques sencillos, o compruebe el programa en el control: si solo lo borra, el programa hace otra cosa", "for a chamfer write ,{letter}{size} with a comma; if the program is for another control, name it: with --dialect, or on the sheet DATA of a workbook; if not, write what it does as plain blocks, or check the program at the control: if you only delete it, the program does something else";
        why "C sola es un eje giratorio; tras una coma es el chaflán entre dos líneas.",
            "C by itself is a rotary axis; behind a comma it is the chamfer between two lines.";
        example Example::program("fanuc-lathe-a", "G21 G98|G1 X40. C1.5 F100.|M30", "2:9");
    "G0141" NameNotRead Stop { name: String }
        es "{name}=: el control no lee «=» detrás de una letra y su número"
        en "{name}=: the control does not read '=' behind a letter and its number"
        remedy "no quite «=»: el número sería otro; escriba la letra y el número que quería decir; si el programa es de otro control que rodete lea, indíquelo: con --dialect, o en la hoja DATOS de un libro",
            "do not take '=' out: the number would be another; write the letter and the number that are meant; if the program is for another control that rodete reads, name it: with --dialect, or on the sheet DATA of a workbook";
        why "Otros controles nombran así un eje o un husillo, X1=10: sin «=» sería X110, otra cota.",
            "Other controls name an axis or a spindle so, X1=10: without '=' it would be X110, another position.";
        example Example::program("linuxcnc", "G21 G90 F100|G1 X1=10|M2", "2:6");
}
