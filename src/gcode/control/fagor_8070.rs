//! Fagor CNC 8070: what it has beside [what Fagor's controls share](super::fagor).

use crate::gcode::code::{G, Group};
use crate::gcode::control::codes::{BY_MODE, COMMON};
use crate::gcode::control::fagor::{BASE, FAGOR, LEXIS, MILLS, NO_HELIX, POLAR, THREAD, TRANSFORMATION};
use crate::gcode::control::{
    Across, ArcWords, BlockDelete, Codes, Comments, Control, Decimals, DwellUnit, DwellWord, EmptyBlock, FeedRule,
    FileName, HeightHold, LengthWord, Lexis, MachineZero, NamesWithDigit, NumberBehind, OpeningLine, RotaryMode,
    RotaryRule, Source, TextForm, ToolBlocks, WordOrder, Writing,
};
use crate::gcode::feed_law::FeedLaw;
use crate::gcode::motion::FeedMode;
use crate::text::{Text, t};

/// Fagor CNC 8070, milling.
pub static FAGOR_8070: Control = Control {
    name: "fagor-8070",
    sources: &[
        Source::Manual(t(
            "Fagor Automation, CNC 8070, manual de programación: lista de funciones G; G93, el tiempo de mecanizado en segundos; p. 204, comentarios entre paréntesis en los ejemplos; Ref. 1709, p. 240: la longitud es la de la herramienta elegida, con su corrector D, o D1 si no se elige ninguno",
            "Fagor Automation, CNC 8070, programming manual: list of G functions; G93, machining time in seconds; p. 204, comments in parentheses in the examples; Ref. 1709, p. 240: the length is the selected tool's, of its offset D, or of D1 where none is selected",
        )),
        Source::NotFound(t(
            "números de bloque, líneas vacías, interruptores de /, decimales y orden de las palabras; se admite cualquiera",
            "block numbers, empty lines, switches of /, decimals and the order of words; any is taken",
        )),
        Source::NotFound(t("K de G4; se toma en segundos", "K of G4; taken to count seconds")),
        NO_HELIX,
    ],
    text: TextForm { opening: &[OpeningLine::Name], memory: 1 << 30, file: FileName::Any, ..BASE.text },
    feed: FeedRule { law: FeedLaw::Seconds, ..BASE.feed },
    written: Some(&WRITING),
    codes: &CODES,
    lexis: Lexis {
        comments: Comments::Either,
        dwell: &[DwellWord { letter: 'K', unit: DwellUnit::Second, shared: false }],
        delete: BlockDelete::Numbered,
        words: WordOrder::Free,
        empty: EmptyBlock::Passed,
        greatest_number: 999_999_999,
        decimals: Decimals::Free,
        behind: NumberBehind::Rejected,
        names: NamesWithDigit::AxesAndSpindles,
        ..LEXIS
    },
    arcs: ArcWords { across: Across::Unknown, ..BASE.arcs },
    length: LengthWord::OfTool,
    rotary: RotaryRule { delivered: RotaryMode::Linear, ..BASE.rotary },
    ..BASE
};

/// How rodete writes for the 8070.
static WRITING: Writing = Writing {
    safety: &[('G', 17), ('G', 40), ('G', 54), ('G', 71), ('G', 90), ('G', 94)],
    tool: ToolBlocks::OffsetAndChange,
    height: HeightHold::Builder,
    clamps: &[],
    zero: MachineZero::Assumed,
};

static CODES: Codes = Codes::new(&[
    COMMON,
    BY_MODE,
    FAGOR,
    MILLS,
    &[
        (&[200], G::Refused(Group::Plane, &TRANSFORMATION)),
        (&[300, 310], G::Refused(Group::Other, &POLAR)),
        (&[530], G::Refused(Group::WorkOffset, &CANCEL_ZERO)),
        (&[580], G::WorkOffset(5)),
        (&[590], G::WorkOffset(6)),
        (&[600, 610], G::PathControl),
        (&[630], G::Refused(Group::Motion, &THREAD)),
        (&[920], G::SetPosition),
        (&[930], G::Feed(FeedMode::Seconds)),
        (&[960], G::ConstantSurfaceSpeed),
        (&[970], G::Rpm),
    ],
]);

static CANCEL_ZERO: Text = t("anulación del traslado de origen", "zero offset cancellation");
