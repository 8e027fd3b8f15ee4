//! Fagor CNC 8055 T, a lathe: what it has beside [what Fagor's controls share](super::fagor).

use crate::gcode::code::{G, Group, LetterCycle, TurningCycle};
use crate::gcode::control::codes::{BY_MODE, COMMON};
use crate::gcode::control::fagor::{BASE, BOTH_8055, DWELL, FAGOR, FRAME, LEXIS, NO_HELIX, THREAD};
use crate::gcode::control::{
    Across, AcrossWord, ArcWords, AxisWords, Class, Codes, Control, FeedRule, FileName, HeightHold, Increments, Lexis,
    MachineZero, NoseCorner, Order, RadiusRule, Source, SpindleRule, Start, TextForm, ToolBlocks, ToolCall, Turns,
    UnsaidFeed, Writing,
};
use crate::gcode::in_force::Compensation;
use crate::gcode::letters::Letters;
use crate::gcode::motion::Plane;
use crate::gcode::turning::fagor::Along;
use crate::text::{Text, t};

/// Fagor CNC 8055 T, turning.
pub static FAGOR_8055_T: Control = Control {
    name: "fagor-8055-t",
    sources: &[
        Source::Manual(t(
            "Fagor Automation, CNC 8055 T, manual de programación: lista de funciones G",
            "Fagor Automation, CNC 8055 T, programming manual: list of G functions",
        )),
        Source::NotFound(t(
            "orden de las palabras de un bloque; se toma el del 8055 M, con sus errores 0002 a 0004, 0009, 0012 y 0048",
            "order of the words of a block; that of the 8055 M is taken, with its errors 0002 to 0004, 0009, 0012 and 0048",
        )),
        FRAME,
        DWELL,
        NO_HELIX,
    ],
    class: Class::Lathe,
    text: TextForm { file: FileName::SixDigits("PIT"), ..BASE.text },
    lexis: Lexis { letters: Letters::of("ABCDFIJKQRSTUVWXYZ"), ..LEXIS },
    codes: &CODES,
    start: Start { plane: Plane::ZX, ..BASE.start },
    order: Order::FagorLathe,
    axes: AxisWords { x: AcrossWord::Diameter, increments: Increments::ByMode },
    arcs: ArcWords { across: Across::Unknown, ..BASE.arcs },
    feed: FeedRule { unsaid: UnsaidFeed::Told, ..BASE.feed },
    spindle: SpindleRule { turns: Turns::Part, ..BASE.spindle },
    tool: ToolCall::Words,
    radius: RadiusRule::Nose(NoseCorner::StraightTo120),
    written: Some(&WRITING),
    ..BASE
};

/// How rodete writes for the 8055 T.
static WRITING: Writing = Writing {
    safety: &[('G', 71), ('G', 90), ('G', 94)],
    tool: ToolBlocks::Turret,
    height: HeightHold::Builder,
    clamps: &[],
    zero: MachineZero::Assumed,
};

static CODES: Codes = Codes::new(&[
    COMMON,
    BY_MODE,
    FAGOR,
    BOTH_8055,
    &[
        (&[340], G::Refused(Group::Motion, &THREAD)),
        (&[410], G::Compensation(Compensation::Left)),
        (&[420], G::Compensation(Compensation::Right)),
        (&[660, 680, 690], G::RefusedCycle(&TURNING_CYCLE)),
        (&[810], cycle(LetterCycle::Straight(Along::Cylinder))),
        (&[820], cycle(LetterCycle::Straight(Along::Face))),
        (&[830], cycle(LetterCycle::Drilling)),
        (&[840], cycle(LetterCycle::Curved(Along::Cylinder))),
        (&[850], cycle(LetterCycle::Curved(Along::Face))),
        (&[860], cycle(LetterCycle::Thread(Along::Cylinder))),
        (&[870], cycle(LetterCycle::Thread(Along::Face))),
        (&[880], cycle(LetterCycle::Groove(Along::Cylinder))),
        (&[890], cycle(LetterCycle::Groove(Along::Face))),
        (&[960], G::ConstantSurfaceSpeed),
        (&[970], G::Rpm),
    ],
]);

static TURNING_CYCLE: Text = t("ciclos fijos de torneado", "turning cycles");

/// A turning cycle of one block.
const fn cycle(cycle: LetterCycle) -> G {
    G::Turning(TurningCycle::ByLetters(cycle))
}
