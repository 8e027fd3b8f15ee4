//! What a control does, in words: every field of it and every value of its enums.
//!
//! The rows are taken from the control itself. A field without a row, and a value without a text, do not compile.

use super::{
    Across, AcrossWord, ArcWords, AxisWords, BlockDelete, BuilderCodes, CallBy, Calls, Cancel, Class, Codes,
    CommentForm, Comments, Control, Corners, Decimals, DimensionPoint, Drilling, DwellWord, EmptyBlock, FeedChange,
    FeedLimit, FeedPath, FeedRule, HeightHold, Increments, Language, LengthWord, Lexis, LoneDwell, LoneReturn,
    MachineMove, Mark, MissingFeed, NegativeRadius, NoseCorner, NumberBehind, OffsetRule, Opening, Order, Percent,
    PolarWords, Radii, RadiusRule, Reference, Retract, Rollover, RotaryMode, RotaryRule, SpeedLimit, SpindleRule,
    Start, TextForm, ToolCall, ToolChange, Turns, UnitChange, UnsaidFeed, WordOrder, Writing,
};
use crate::finding::AlarmFamily;
use crate::gcode::code::{G, M};
use crate::gcode::feed_law::FeedLaw;
use crate::gcode::letters::Letters;
use crate::gcode::word::{NumberFormat, Word};
use crate::text::{Text, t};

/// One feature of a control, for `rodete explain --controls`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Feature {
    /// What of the control it is, as a heading.
    pub of: Text,
    /// What the control does.
    pub does: Text,
}

/// Features as they are told one after the other.
#[derive(Default)]
struct Features(Vec<Feature>);

impl Features {
    fn row(&mut self, of: Text, does: Text) {
        self.0.push(Feature { of, does });
    }

    fn text(&mut self, text: &TextForm) {
        let TextForm { opening, comment, end_of_line, greatest_number, memory } = text;
        self.row(t("primera línea", "first line"), opening.told());
        self.row(t("comentarios que se escriben", "comments as written"), comment.told());
        self.row(t("fin de línea", "end of a line"), Text::same(end_of_line.replace('\r', "CR ").replace('\n', "LF")));
        self.row(t("mayor número de bloque N", "largest block number N"), Text::same(greatest_number.to_string()));
        self.row(
            t("memoria para un programa", "memory for one program"),
            Text::new(format!("{memory} bytes, más allá una precaución"), format!("{memory} bytes, a caution beyond")),
        );
    }

    fn lexis(&mut self, lexis: &Lexis) {
        let Lexis {
            letters,
            refused,
            free,
            negative,
            dwell,
            lone_dwell,
            language,
            comments,
            delete,
            percent,
            mark,
            lone_return,
            words,
            empty,
            greatest_number,
            decimals,
            point,
            longest_line,
            most_machine_codes,
            builders,
            behind,
            polar,
        } = lexis;
        self.row(t("letras, además de G, M y N", "letters, besides G, M and N"), letters.told());
        self.row(t("letras que rodete rechaza", "letters that rodete rejects"), refused.told());
        self.row(t("letras que no necesitan un código", "letters that need no code"), free.told());
        self.row(
            t(
                "letras de F, S, T, D, L y Q que pueden ser negativas",
                "letters of F, S, T, D, L and Q that may be negative",
            ),
            negative.told(),
        );
        self.row(t("tiempo de espera (G4)", "time of a dwell (G4)"), dwell_words(dwell));
        self.row(t("G4 sin tiempo", "G4 without a time"), lone_dwell.told());
        self.row(t("además de palabras", "besides words"), language.told());
        self.row(t("comentarios que se leen", "comments as read"), comments.told());
        self.row(t("salto de bloque", "block delete"), delete.told());
        self.row(t("principio y fin del texto", "begin and end of the text"), percent.told());
        self.row(t("marca de orden de bytes (BOM)", "byte order mark (BOM)"), mark.told());
        self.row(t("CR sin LF detrás", "CR without an LF behind it"), lone_return.told());
        self.row(t("orden de las palabras de un bloque", "order of the words of a block"), words.told());
        self.row(t("bloque sin palabras", "block without words"), empty.told());
        self.row(
            t("mayor número de bloque que se lee", "largest block number as read"),
            Text::same(greatest_number.to_string()),
        );
        self.row(t("decimales de una cota", "decimals of a dimension"), decimals.told());
        self.row(t("cota sin punto decimal", "dimension without a decimal point"), point.told());
        self.row(t("mayor longitud de una línea", "longest line"), Text::same(longest_line.to_string()));
        self.row(t("códigos M en un bloque", "M codes in a block"), at_most(*most_machine_codes));
        self.row(t("códigos M del fabricante en un bloque", "the builder's M codes in a block"), builders.told());
        self.row(t("N detrás de las palabras de un bloque", "N behind the words of a block"), behind.told());
        self.row(t("coordenadas polares", "polar coordinates"), polar.told());
    }

    fn start(&mut self, start: &Start, drilling: Drilling) {
        let Start { motion, feed, plane, retract, units } = start;
        let retract = match drilling {
            Drilling::None => t("ningún ciclo", "no cycle"),
            Drilling::Rs274 | Drilling::Lathe => retract.told(),
        };
        self.row(t("al empezar: movimiento", "at the start: motion"), motion.told());
        self.row(t("al empezar: avance", "at the start: feed"), feed.told());
        self.row(t("al empezar: plano", "at the start: plane"), Text::same(plane.name()));
        self.row(t("al empezar: retirada de los ciclos", "at the start: retract of cycles"), retract);
        self.row(t("cambio de unidad", "change of unit"), units.told());
    }

    fn geometry(&mut self, axes: &AxisWords, arcs: &ArcWords) {
        let AxisWords { x, increments } = axes;
        let ArcWords { letters, across, negative, radii } = arcs;
        self.row(t("palabra X", "word X"), x.told());
        self.row(t("cotas incrementales", "incremental dimensions"), increments.told());
        self.row(t("letras de un arco, además de los ejes", "letters of an arc, besides the axes"), letters.told());
        self.row(
            t("palabra de centro a través del plano (K en G17)", "centre word across the plane (K in G17)"),
            across.told(),
        );
        self.row(t("R negativo de un arco", "negative R of an arc"), negative.told());
        self.row(t("diferencia de los radios de un arco", "difference of the radii of an arc"), radii.told());
    }

    fn rates(&mut self, rotary: &RotaryRule, feed: &FeedRule, letters: Letters) {
        let RotaryRule { delivered, rollover } = rotary;
        // Codes have tables of their own, those of F among them.
        let FeedRule { law, codes: _, missing, change, path, unsaid, limit } = feed;
        let rotary_axes = ['A', 'B', 'C'].into_iter().any(|axis| letters.has(axis as u8 - b'A'));
        let turned = |does: Text| if rotary_axes { does } else { t("ningún eje giratorio", "no rotary axis") };
        self.row(t("ejes giratorios como se entrega", "rotary axes as delivered"), turned(delivered.told()));
        self.row(t("palabra absoluta de un eje rollover", "absolute word of a rollover axis"), turned(rollover.told()));
        self.row(
            t("F de ejes lineales y giratorios juntos", "F of linear and rotary axes together"),
            turned(law.told()),
        );
        self.row(t("avance sin F", "feed move without F"), missing.told());
        self.row(t("F cuando un código cambia lo que significa", "F where a code changes its meaning"), change.told());
        self.row(t("ejes a los que pertenece F", "axes that F belongs to"), path.told());
        self.row(t("F antes de decir lo que significa", "F before its meaning is said"), unsaid.told());
        self.row(t("mayor F", "greatest F"), limit.told());
    }

    fn spindle(&mut self, spindle: &SpindleRule, codes: &Codes) {
        let SpindleRule { turns, limit } = spindle;
        self.row(t("el husillo gira", "the spindle turns"), turns.told());
        self.row(
            t("límite de giro con velocidad de corte constante", "speed limit under constant surface speed"),
            coded(
                codes,
                G::ConstantSurfaceSpeed,
                match limit {
                    SpeedLimit::Word => t("D de G96", "D of G96"),
                    SpeedLimit::Code => match codes.names(G::SetPositionOrSpeed).as_slice() {
                        [] => no_code(),
                        names => Text::new(
                            format!("{} con S sola", names.join(", ")),
                            format!("{} with S alone", names.join(", ")),
                        ),
                    },
                },
            ),
        );
    }

    fn written(&mut self, written: Option<&Writing>) {
        let writing =
            |told: fn(&Writing) -> Text| written.map_or_else(|| t("no se escribe", "nothing is written"), told);
        self.row(
            t("se escribe: bloque de seguridad", "written: safety block"),
            writing(|writing| Text::same(block(&writing.safety_block()))),
        );
        self.row(
            t("se escribe: llamada de la herramienta", "written: call of a tool"),
            writing(|writing| {
                Text::same(writing.tool.blocks(1, 1).iter().map(|words| block(words)).collect::<Vec<_>>().join(", "))
            }),
        );
        self.row(
            t("se escribe: control de altura", "written: height control"),
            writing(|writing| writing.height.told()),
        );
    }
}

impl Control {
    /// Every feature, in the order of the fields: of every control as many, each at the same place.
    #[must_use]
    pub fn features(&self) -> Vec<Feature> {
        // Sources are a list of their own, codes tables; here these only tell whether a rule is ever asked.
        let Self {
            name: _,
            sources: _,
            codes,
            machine_code,
            text,
            class,
            lexis,
            start,
            order,
            axes,
            arcs,
            rotary,
            feed,
            spindle,
            tool,
            change,
            length,
            offsets,
            cancel,
            machine_move,
            reference,
            corners,
            radius,
            drilling,
            calls: Calls { by, depth },
            written,
            alarms,
        } = self;
        let mut features = Features::default();
        features.row(t("clase", "class"), class.told());
        features.text(text);
        features.lexis(lexis);
        features.start(start, *drilling);
        features.row(t("orden de un bloque", "order of a block"), order.told());
        features.geometry(axes, arcs);
        features.rates(rotary, feed, lexis.letters);
        features.spindle(spindle, codes);
        features.row(t("llamada de la herramienta", "call of a tool"), tool.told());
        features.row(
            t("M6 cambia", "M6 changes in"),
            if machine_code(6) == Some(M::ToolChange) { change.told() } else { t("nada", "nothing") },
        );
        features.row(t("letra del corrector de longitud", "letter of a length offset"), length.told());
        let taken = if length.waits_for_motion() {
            t("con el siguiente movimiento de Z", "with the next motion of Z")
        } else {
            t("en su bloque", "in its block")
        };
        features.row(t("la longitud cuenta (G43)", "the length counts (G43)"), coded(codes, G::ToolLength, taken));
        features.row(t("orígenes", "offsets"), offsets.told());
        features.row(t("en vigor tras G80", "in force after G80"), coded(codes, G::Cancel, cancel.told()));
        features.row(
            t("cotas de máquina (G53)", "machine coordinates (G53)"),
            coded(codes, G::MachineCoordinates, machine_move.told()),
        );
        features.row(t("punto de referencia", "reference point"), reference.told());
        features.row(t("esquinas entre líneas", "corners between lines"), corners.told());
        features.row(t("G41 y G42", "G41 and G42"), radius.told());
        features.row(t("ciclos de taladrado", "drilling cycles"), drilling.told());
        features.row(t("subprogramas", "subprograms"), by.told());
        features.row(
            t("subprogramas, unos dentro de otros", "subprograms inside one another"),
            match by {
                CallBy::Nothing => t("ninguno", "none"),
                CallBy::Label | CallBy::Number => at_most(*depth),
            },
        );
        features.written(*written);
        features.row(
            t("alarmas con su número", "alarms by their numbers"),
            match alarms {
                Some(AlarmFamily::Fanuc) => t("de Fanuc", "Fanuc's"),
                Some(AlarmFamily::Lathe) => t("de rodete", "rodete's"),
                None => t("ninguna", "none"),
            },
        );
        features.0
    }
}

/// What a code does, where a control has it.
fn coded(codes: &Codes, code: G, does: Text) -> Text {
    if codes.has(code) { does } else { no_code() }
}

fn no_code() -> Text {
    t("ningún código", "no code")
}

/// Words as they stand in a block.
fn block(words: &[Word]) -> String {
    let mut text = String::new();
    words.iter().for_each(|word| word.write(NumberFormat::Fixed, &mut text));
    text
}

fn at_most(count: usize) -> Text {
    Text::new(format!("{count} como mucho"), format!("{count} at most"))
}

fn dwell_words(words: &[DwellWord]) -> Text {
    let one = |word: &DwellWord| match word.unit {
        1.0 => format!("{} (s)", word.letter),
        unit => format!("{} ({unit} s)", word.letter),
    };
    Text::same(words.iter().map(one).collect::<Vec<_>>().join(", "))
}

impl Letters {
    /// The letters in their order.
    fn told(self) -> Text {
        let letters: String = (b'A'..=b'Z').filter(|letter| self.has(letter - b'A')).map(char::from).collect();
        if letters.is_empty() { t("ninguna", "none") } else { Text::same(letters) }
    }
}

/// A text for every value of an enum.
macro_rules! told {
    ($($of:ident { $($value:pat => $es:literal, $en:literal;)+ })+) => {
        $(impl $of {
            fn told(&self) -> Text {
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
    Opening {
        Self::None => "ninguna", "none";
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
    Mark {
        Self::Skipped => "se omite, con una nota", "skipped, with a note";
        Self::Rejected => "se rechaza", "rejected";
    }
    UnitChange {
        Self::Anywhere => "en cualquier bloque", "in any block";
        Self::AtBeginning => "antes del primer movimiento; después, aviso", "before the first motion; a caution behind it";
    }
    LoneDwell {
        Self::Rejected => "se rechaza", "rejected";
        Self::StopsPreparation => "para la preparación de bloques; no espera", "stops the preparation of blocks; does not dwell";
    }
    LoneReturn {
        Self::EndsLine => "termina la línea", "ends the line";
        Self::Rejected => "se rechaza: el control lo toma por un espacio", "rejected: the control takes it for a blank";
    }
    WordOrder {
        Self::Free => "cualquiera", "any";
        Self::Ranked => "G, ejes X Y Z U V W A B C, F S T D, M: otro se rechaza; I, J, K y R, donde estén", "G, axes X Y Z U V W A B C, F S T D, M: another is rejected; I, J, K and R anywhere";
    }
    EmptyBlock {
        Self::Passed => "se pasa por alto", "passed over";
        Self::Rejected => "se rechaza; un comentario solo, no", "rejected, but not a comment alone";
    }
    Decimals {
        Self::Free => "los que haya", "as many as there are";
        Self::FourOrFive => "4; en pulgadas, y en I, J, K y R, 5; más allá una precaución", "4; in inches, and of I, J, K and R, 5; a caution beyond";
    }
    DimensionPoint {
        Self::Free => "lo mismo que con él", "the same as with one";
        Self::BySetting => "milímetros o micras, según un ajuste del control", "millimetres or micrometres, by a setting of the control";
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

impl HeightHold {
    fn told(self) -> Text {
        match self.words(true).zip(self.words(false)) {
            Some((on, off)) => Text::same(format!("{}, {}", block(&on), block(&off))),
            None => t("códigos del fabricante, que nombra el libro", "the builder's codes, which the workbook names"),
        }
    }
}
