//! What a control does, in words: every field of it and every value of its enums.
//!
//! The rows are taken from the control itself. A field without a row, and a value without a text, do not compile.

mod values;

use super::{
    ArcWords, AxisWords, CallBy, Calls, Codes, Control, Counting, DimensionPoint, Drilling, DwellUnit, DwellWord,
    FeedRule, HeightHold, Lexis, OpeningLine, RotaryRule, SpeedLimit, SpindleRule, Start, TextForm, Writing,
};
use crate::finding::AlarmFamily;
use crate::gcode::code::{G, M};
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
        let TextForm { opening, ending, comment, end_of_line, greatest_number, memory, file } = text;
        let [none, opening_lines] = [t("ninguna", "none"), joined(opening.iter().map(OpeningLine::told))];
        self.row(t("primeras líneas", "first lines"), if opening.is_empty() { none.clone() } else { opening_lines });
        self.row(
            t("últimas líneas", "last lines"),
            if ending.is_empty() { none } else { Text::same(ending.join(", ")) },
        );
        self.row(t("comentarios que se escriben", "comments as written"), comment.told());
        self.row(t("fin de línea", "end of a line"), Text::same(end_of_line.replace('\r', "CR ").replace('\n', "LF")));
        self.row(t("mayor número de bloque N", "largest block number N"), Text::same(greatest_number.to_string()));
        self.row(
            t("memoria para un programa", "memory for one program"),
            Text::new(format!("{memory} bytes, más allá una precaución"), format!("{memory} bytes, a caution beyond")),
        );
        self.row(
            t("nombre del archivo en el control", "file name at the control"),
            file.told(None).unwrap_or_else(|| t("cualquiera", "any")),
        );
    }

    fn lexis(&mut self, lexis: &Lexis) {
        let Lexis {
            letters,
            refused,
            free,
            negative,
            dwell,
            // Told with the cycles.
            cycle_dwell: _,
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
            names,
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
        let counting = |told: fn(&Counting) -> Text| match point {
            DimensionPoint::Free => t("no se cuentan", "not counted"),
            DimensionPoint::BySetting(counting) => told(counting),
        };
        self.row(
            t("incrementos mínimos: letras que los cuentan", "least increments: letters that count them"),
            counting(|counting| counting.letters.told()),
        );
        self.row(
            t("incrementos mínimos: F sin punto", "least increments: F without a point"),
            counting(|counting| counting.feed.told()),
        );
        self.row(t("incremento mínimo", "least increment"), counting(|counting| counting.increment.told()));
        self.row(
            t("letras que no admiten punto decimal", "letters that take no decimal point"),
            match point {
                DimensionPoint::Free => t("ninguna", "none"),
                DimensionPoint::BySetting(counting) => counting.whole.told(),
            },
        );
        self.row(t("mayor longitud de una línea", "longest line"), Text::same(longest_line.to_string()));
        self.row(t("códigos M en un bloque", "M codes in a block"), at_most(*most_machine_codes));
        self.row(t("códigos M del fabricante en un bloque", "the builder's M codes in a block"), builders.told());
        self.row(t("N detrás de las palabras de un bloque", "N behind the words of a block"), behind.told());
        self.row(t("coordenadas polares", "polar coordinates"), polar.told());
        self.row(t("nombres con cifra, como X1=", "names with a digit, as X1="), names.told());
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
        // A finding says what the Q of a thread counts, where it is out of range.
        let SpindleRule { turns, limit, thread_angle: _ } = spindle;
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
        let nothing = || t("no se escribe", "nothing is written");
        let told = written.map(|writing| {
            let Writing { safety: _, tool, height, clamps, zero } = writing;
            let codes = clamps.iter().map(|number| Text::same(format!("M{number}")));
            [
                Text::same(block(&writing.safety_block())),
                Text::same(tool.blocks(1, 1).iter().map(|words| block(words)).collect::<Vec<_>>().join(", ")),
                height.told(),
                if clamps.is_empty() { t("ninguno", "none") } else { joined(codes) },
                zero.told(),
            ]
        });
        let rows = [
            t("se escribe: bloque de seguridad", "written: safety block"),
            t("se escribe: llamada de la herramienta", "written: call of a tool"),
            t("se escribe: control de altura", "written: height control"),
            t("frenos de los ejes giratorios en programas publicados", "clamps of rotary axes in published programs"),
            t("retirada con G53", "retract by G53"),
        ];
        let told = told.unwrap_or_else(|| std::array::from_fn(|_| nothing()));
        rows.into_iter().zip(told).for_each(|(of, does)| self.row(of, does));
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
        let waits = codes.any(G::waits);
        features.row(
            t("espera de un ciclo", "dwell of a cycle"),
            if waits { lexis.cycle_dwell.told() } else { t("ninguna que rodete simule", "none that rodete simulates") },
        );
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

/// Texts one behind the other.
fn joined(texts: impl Iterator<Item = Text>) -> Text {
    let (es, en): (Vec<_>, Vec<_>) = texts.map(|text| (text.es, text.en)).unzip();
    Text::new(es.join(", "), en.join(", "))
}

fn at_most(count: usize) -> Text {
    Text::new(format!("{count} como mucho"), format!("{count} at most"))
}

fn dwell_words(words: &[DwellWord]) -> Text {
    let one = |word: &DwellWord| match word.unit {
        DwellUnit::Second => format!("{} (s)", word.letter),
        DwellUnit::Hundredth | DwellUnit::Millisecond => format!("{} ({} s)", word.letter, word.unit.seconds()),
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

impl HeightHold {
    fn told(self) -> Text {
        match self.words(true).zip(self.words(false)) {
            Some((on, off)) => Text::same(format!("{}, {}", block(&on), block(&off))),
            None => t("códigos del fabricante, que nombra el libro", "the builder's codes, which the workbook names"),
        }
    }
}
