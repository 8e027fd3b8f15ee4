//! A text for every value of the enums of a control, and of those of other places that it is made of.

use crate::gcode::control::{
    Across, AcrossWord, BlockDelete, BuilderCodes, ByteOrderMarkRule, CallBy, Cancel, Class, CommentForm, Comments,
    Corners, CountedFeed, Decimals, DimensionPoint, Drilling, DwellUnit, EmptyBlock, FeedChange, FeedLimit, FeedPath,
    Increments, Language, LeastIncrement, LengthWord, LoneDwell, LoneReturn, MachineMove, MachineZero, MissingFeed,
    NamesWithDigit, NegativeRadius, NoseCorner, NumberBehind, OffsetRule, OpeningLine, Order, Percent, PolarWords,
    Radii, RadiusRule, Reference, Retract, Rollover, RotaryMode, ToolCall, ToolChange, Turns, UnitChange, UnsaidFeed,
    WordOrder,
};
use crate::gcode::feed_law::FeedLaw;
use crate::text::{Text, t};

/// A text for every value of an enum.
macro_rules! told {
    ($($of:ident { $($value:pat => $es:literal, $en:literal;)+ })+) => {
        $(impl $of {
            pub(super) fn told(&self) -> Text {
                match self { $($value => t($es, $en),)+ }
            }
        })+
    };
}

told! {
    FeedLimit {
        Self::Format => "99 999.999; la inversa del tiempo puede ser mayor", "99,999.999; an inverse time may be greater";
        Self::Number => "la que quepa en un número", "what a number holds";
    }
    Class {
        Self::Mill => "fresadora", "mill";
        Self::Lathe => "torno", "lathe";
    }
    OpeningLine {
        Self::Percent => "%", "%";
        Self::Number => "Onúmero", "Onumber";
        Self::NameAndAttributes => "%nombre,MX--,", "%name,MX--,";
        Self::Name => "%nombre", "%name";
    }
    CommentForm {
        Self::Semicolon => ";texto", ";text";
        Self::Parentheses => "(texto)", "(text)";
    }
    Language {
        Self::Words => "nada", "nothing";
        Self::OWords => "parámetros #, expresiones, palabras polares y palabras O", "parameters #, expressions, polar words and O-words";
        Self::Macros => "un lenguaje de macros (IF, WHILE, GOTO, #), que rodete rechaza", "a macro language (IF, WHILE, GOTO, #), which rodete rejects";
    }
    Comments {
        Self::Either => "(texto), y ; hasta el fin de la línea", "(text), and ; to the end of the line";
        Self::ParenthesesAndSemicolon => "(texto), y ; hasta el fin de la línea; algunos son órdenes al control", "(text), and ; to the end of the line; some are orders to the control";
        Self::Semicolon => "; hasta el fin de la línea; un paréntesis abre una sentencia de alto nivel", "; to the end of the line; a parenthesis opens a high-level statement";
        Self::Parentheses => "(texto); ; termina el bloque, y lo que sigue es comentario salvo que se lea como otro bloque", "(text); ; ends the block, and the text after it is a comment unless it reads as another block";
    }
    BlockDelete {
        Self::Plain => "/", "/";
        Self::Numbered => "/, o /1 a /9", "/, or /1 to /9";
        Self::Three => "/, o /1 a /3", "/, or /1 to /3";
    }
    Percent {
        Self::Named => "una primera línea % con el nombre; ningún otro %", "a first line % with the name; no other %";
        Self::Pair => "% solo en su línea, y sin comentario antes, abre el texto y, si lo abre, también lo termina; sin % el programa necesita M2 o M30", "% alone on its line, with no comment before it, opens the text and, if it opens it, ends it; without % the program needs M2 or M30";
        Self::Leader => "el texto antes del primer % se pasa por alto; el siguiente %, el fin del archivo u otro número de programa lo terminan", "text before the first % is passed over; the next %, the end of the file or another program number ends it";
    }
    ByteOrderMarkRule {
        Self::Skipped => "se omite, con una nota", "skipped, with a note";
        Self::Rejected => "se rechaza", "rejected";
    }
    UnitChange {
        Self::Anywhere => "en cualquier bloque", "in any block";
        Self::AtBeginning => "antes del primer movimiento; después, aviso", "before the first motion; a caution behind it";
    }
    DwellUnit {
        Self::Second => "segundos", "seconds";
        Self::Hundredth => "centésimas de segundo, un número entero", "hundredths of a second, a whole number";
        Self::Millisecond => "milisegundos, un número entero", "milliseconds, a whole number";
    }
    LoneDwell {
        Self::Rejected => "se rechaza", "rejected";
        Self::StopsPreparation => "para la preparación de bloques y anula el corrector de longitud en vigor; no espera", "stops the preparation of blocks and cancels the length in force; does not dwell";
    }
    LoneReturn {
        Self::EndsLine => "termina la línea", "ends the line";
        Self::Rejected => "se rechaza: el control lo toma por un espacio", "rejected: the control takes it for a blank";
    }
    WordOrder {
        Self::Free => "cualquiera", "any";
        Self::Ranked => "G, ejes X Y Z U V W A B C, F S T D, M: otro se rechaza; I, J, K y R, donde estén, y I, J, K en ese orden", "G, axes X Y Z U V W A B C, F S T D, M: another is rejected; I, J, K and R anywhere, and I, J, K in this order";
    }
    EmptyBlock {
        Self::Passed => "se pasa por alto", "passed over";
        Self::Rejected => "se rechaza; un comentario solo, no", "rejected, but not a comment alone";
    }
    Decimals {
        Self::Free => "los que haya", "as many as there are";
        Self::FourOrFive => "4; en pulgadas, y en I, J, K y R, 5; más allá una precaución; en pulgadas ±3937.00787 como mucho", "4; in inches, and of I, J, K and R, 5; a caution beyond; in inches ±3937.00787 at most";
    }
    DimensionPoint {
        Self::Free => "lo mismo que con él", "the same as with one";
        Self::BySetting(_) => "lo mismo, o incrementos mínimos, según un ajuste del control", "the same, or least increments, by a setting of the control";
    }
    LeastIncrement {
        Self::Thousandth => "0.001 mm, 0.0001 pulgadas, 0.001 s", "0.001 mm, 0.0001 inches, 0.001 s";
    }
    CountedFeed {
        Self::AsWritten => "lo que dice", "what it says";
        Self::LengthUnknown => "por minuto lo que dice; por vuelta y como paso no se sabe", "per minute what it says; per revolution and as a lead not known";
    }
    BuilderCodes {
        Self::One => "uno", "one";
        Self::Several => "varios", "several";
    }
    NumberBehind {
        Self::Rejected => "se rechaza", "rejected";
        Self::Repeats => "cuántas veces más se repite el bloque; rodete lo rechaza por su nombre", "how many times more the block is made; rodete rejects it by name";
    }
    PolarWords {
        Self::None => "ninguna", "none";
        Self::Signs => "@ y ^", "@ and ^";
        Self::RadiusAndAngle => "R y Q; rodete las rechaza por su nombre", "R and Q; rodete rejects them by name";
    }
    NamesWithDigit {
        Self::None => "ninguno", "none";
        Self::AxesAndSpindles => "de ejes y husillos; rodete los rechaza por su nombre", "of axes and spindles; rodete rejects them by name";
    }
    UnsaidFeed {
        Self::Taken => "como al empezar", "as at the start";
        Self::Told => "como al empezar, y una precaución: la máquina puede empezar con lo otro", "as at the start, and a caution: the machine may start with the other";
    }
    Retract {
        Self::Initial => "a la altura de la que salieron", "to the height that they started from";
        Self::R => "a R", "to R";
    }
    Order {
        Self::Rs274 => "el de RS274: los códigos M antes del movimiento", "that of RS274: M codes before the motion";
        Self::Fagor => "los códigos M antes del movimiento; no se sabe en qué unidad se leen F y S junto a G70 o G71", "M codes before the motion; it is not known in which unit F and S are read beside G70 or G71";
        Self::FagorLathe => "los códigos M antes del movimiento, M5 y M9 después; no se sabe en qué unidad se leen F y S junto a G70 o G71", "M codes before the motion, M5 and M9 after it; it is not known in which unit F and S are read beside G70 or G71";
        Self::Fanuc => "la unidad antes que toda palabra, M5 y M9 después del movimiento; junto a G28, G30 o G50 puede ir un código de movimiento", "the unit before every word, M5 and M9 after the motion; a motion code may be beside G28, G30 or G50";
    }
    MachineZero {
        Self::Read => "G53 no cuenta correctores", "G53 ignores tool offsets";
        Self::Assumed => "se supone que G53 no cuenta correctores; una precaución", "G53 is assumed to ignore tool offsets; a caution";
    }
    AcrossWord {
        Self::Radius => "la coordenada", "the coordinate";
        Self::Diameter => "el diámetro", "the diameter";
    }
    Increments {
        Self::ByMode => "por G91", "by G91";
        Self::ByLetters => "por U y W; G91 no es un código", "by U and W; G91 is not a code";
    }
    Across {
        Self::Foreign => "no es de ningún arco del plano", "belongs to no arc of the plane";
        Self::Pitch => "el paso de una hélice, mayor que 0; se rechaza", "the pitch of a helix, above 0; rejected";
        Self::Unknown => "no se sabe; un 0 en un arco que no sale de su plano es una precaución", "not known; 0 in an arc that does not leave its plane is a caution";
    }
    NegativeRadius {
        Self::LongArc => "el arco de más de 180°", "the arc of more than 180°";
        Self::Refused => "se rechaza", "rejected";
    }
    Radii {
        Self::LinuxCnc => "0.028 mm o una milésima del radio; 2.8 mm como mucho", "0.028 mm or a thousandth of the radius; 2.8 mm at most";
        Self::Parameter => "lo dice un parámetro de la máquina; más de 0.01 mm es una precaución", "a machine parameter says it; more than 0.01 mm is a caution";
    }
    RotaryMode {
        Self::Linear => "cuentan más allá de una vuelta", "count on beyond a turn";
        Self::Rollover => "rollover: el número es el ángulo y el signo el sentido", "rollover: the number is the angle, the sign the direction";
    }
    Rollover {
        Self::Numbered => "de 0 a 359,9999, más allá los errores 0168 y 0199; lo que los manuales no dicen es una precaución", "0 to 359.9999, beyond it the errors 0168 and 0199; what the manuals do not say is a caution";
        Self::Wrapped => "como WRAPPED_ROTARY; no con G53", "as WRAPPED_ROTARY; not with G53";
    }
    FeedLaw {
        Self::Resultant => "G94: a lo largo de la resultante de todos los ejes, los grados como milímetros", "G94: along the resultant of all axes, degrees as millimetres";
        Self::Seconds => "G93: el tiempo del movimiento en segundos", "G93: the time of the move in seconds";
        Self::InverseTime => "G93: la inversa del tiempo del movimiento en minutos", "G93: the inverse of the time of the move in minutes";
    }
    MissingFeed {
        Self::Refused => "se rechaza", "rejected";
        Self::Cautioned => "una precaución: el control toma la F que tiene", "a caution: the control takes the F that it has";
    }
    FeedChange {
        Self::Forgets => "se pierde", "is lost";
        Self::KeepsStale => "conserva su número; moverse con él es una precaución", "keeps its number; moving with it is a caution";
    }
    FeedPath {
        Self::AllAxes => "todos los que se mueven", "all that move";
        Self::LinearFirst => "X, Y y Z; si están quietos U, V y W; si no, los giratorios", "X, Y and Z; if they do not move, U, V and W; otherwise the rotary axes";
    }
    Turns {
        Self::Tool => "la herramienta", "the tool";
        Self::Part => "la pieza", "the part";
    }
    ToolCall {
        Self::Change => "T la elige, M6 la cambia", "T selects it, M6 changes it in";
        Self::Digits => "T0A0B: puesto A, corrector B, 0 ninguno; se empieza sin corrector", "T0A0B: place A, offset B, 0 for none; the machine starts without an offset";
        Self::Words => "T el puesto, D el corrector, sin D el del número de la herramienta; siguen tras el fin del programa", "T the place, D the offset, without D the one with the tool's number; both stay over the end of a program";
    }
    ToolChange {
        Self::Selected => "la herramienta que T ha elegido; después el husillo está parado", "the tool selected by T; afterwards the spindle is stopped";
        Self::Routine => "una rutina de la máquina; sin herramienta elegida no cambia ninguna", "a routine of the machine's; with no tool selected none is changed";
    }
    LengthWord {
        Self::H => "H, junto a G43", "H, with G43";
        Self::D => "D", "D";
        Self::OfTool => "D, un corrector de la propia herramienta; sin D, su D1", "D, an offset of the tool's own; without D its D1";
    }
    OffsetRule {
        Self::Select => "G54 elige; G92 da a esta posición sus palabras", "G54 selects; G92 sets this position to its words";
        Self::SelectOrPreset => "G54 elige y anula lo que fijó G92; G92 da a esta posición sus palabras", "G54 selects, and ends what G92 has set; G92 sets this position to its words";
        Self::SelectOrShift => "G54 con palabras de ejes y sin código de movimiento desplaza el sistema; G50 toma también incrementos", "G54 with axis words and no motion code shifts the system; G50 takes increments too";
    }
    Cancel {
        Self::LeavesNone => "ningún código de movimiento", "no motion code";
        Self::RestoresMotion => "el código de movimiento de antes del ciclo", "the motion code from before the cycle";
    }
    MachineMove {
        Self::InForce => "con el G0 o G1 en vigor; la compensación de punta queda anulada", "by the G0 or G1 in force; nose compensation is off from there on";
        Self::Rapid => "siempre en rápido; la compensación de punta se aparta para el bloque", "always in rapid; nose compensation is suspended for the block";
    }
    Reference {
        Self::None => "ningún código va a él", "no code goes there";
        Self::NamedOrAll => "los ejes que se nombran, o todos si no se nombra ninguno", "the axes named, or all where none is";
        Self::Named => "los ejes que se nombran; P dice cuál de los puntos", "the axes named; P tells which point";
    }
    Corners {
        Self::None => "no por palabras de la línea", "not by words of the line";
        Self::Drawing => "C y R tras una coma, o I, K y R de una línea a lo largo de un eje", "C and R after a comma, or I, K and R of a line along an axis";
    }
    RadiusRule {
        Self::None => "se rechazan", "rejected";
        Self::Cutter => "el radio de la fresa, de la tabla o del bloque", "the cutter's radius, from the table or the block";
        Self::Nose(NoseCorner::Straight) => "el radio de punta; una esquina exterior se rodea recto", "the nose radius; an outer corner is gone round straight";
        Self::Nose(NoseCorner::StraightTo120) => "el radio de punta; una esquina exterior se rodea recto hasta 120°, si no en arco", "the nose radius; an outer corner is gone round straight up to 120°, else round";
    }
    Drilling {
        Self::None => "ninguno que rodete simule", "none that rodete simulates";
        Self::Rs274 => "a través del plano, con R y L", "across the plane, with R and L";
        Self::Lathe => "a lo largo de Z o X del torno, con R", "along Z or X of the lathe, with R";
    }
    CallBy {
        Self::Nothing => "ningún código M los llama", "no M code calls them";
        Self::Label => "por la O que está tras el programa, solos en su bloque", "by the O after the program, alone in their block";
        Self::Number => "por el número de su programa o de su primer bloque, también junto a un movimiento", "by the number of their program or of their first block, also together with a motion";
    }
}
