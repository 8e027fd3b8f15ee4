//! Fanuc, turning, G-code system A: U and W are the increments, G90, G92 and G94 are cycles, G98 and G99 say what F
//! means.
//!
//! # Comments and block delete
//! `( )`, and text behind `;`, as the simulator takes it; on the screen of a Fanuc `;` ends the block, so that what reads as
//! another block behind it is refused. The simulator takes text behind `/` for a comment too; on a Fanuc `/` at the start of a
//! block is block delete, and so it is here; elsewhere it is refused.

use crate::finding::AlarmFamily;
use crate::gcode::code::{Cycle, G, Group, M, Name, SinglePassCycle, TurningCycle};
use crate::gcode::control::{
    Across, AcrossWord, ArcWords, AxisWords, BlockDelete, BuilderCodes, CallBy, Calls, Cancel, Class, Codes,
    CommentForm, Comments, Control, Corners, DimensionPoint, Drilling, DwellWord, FeedChange, FeedCodes, FeedLaw,
    FeedPath, FeedRule, Increments, Language, LengthWord, Letters, Lexis, MachineMove, MissingFeed, NoseCorner,
    OffsetRule, Opening, Order, Percent, RadiusRule, Reference, Retract, Rollover, Rotary, RotaryRule, SpeedLimit,
    SpindleRule, Start, TextForm, ToolCall, ToolChange, Turns,
};
use crate::gcode::in_force::Compensation;
use crate::gcode::motion::{FeedMode, Plane};
use crate::text::t;

/// Fanuc, turning, G-code system A. Read only: rodete writes no program in it.
pub static FANUC_LATHE_A: Control = Control {
    name: "fanuc-lathe-a",
    sources: &[
        t(
            "la lista de códigos del simulador de torno: estos se siguen",
            "the lathe simulator's list of codes: these are followed",
        ),
        t(
            "Fanuc Series 0i-T, manual del operador, sistema A de códigos G: los demás se rechazan por su nombre, y las letras que solo toman opciones del control (C, A, B y otras)",
            "Fanuc Series 0i-T, operator's manual, G-code system A: the others are refused by name, and so are letters that only options of the control take (C, A, B and others)",
        ),
    ],
    text: TextForm {
        opening: Opening::None,
        comment: CommentForm::Parentheses,
        end_of_line: "\r\n",
        greatest_number: 99_999,
        memory: 1 << 19,
    },
    class: Class::Lathe,
    lexis: Lexis {
        letters: Letters::of("FIKLPQRSTUWXZ"),
        refused: Letters::of("ABCDEHJVY"),
        free: Letters::of("FST"),
        negative: Letters::of("Q"),
        dwell: &[
            DwellWord { letter: 'X', unit: 1.0 },
            DwellWord { letter: 'U', unit: 1.0 },
            DwellWord { letter: 'P', unit: 0.001 },
        ],
        language: Language::Macros,
        comments: Comments::Parentheses,
        delete: BlockDelete::Numbered,
        percent: Percent::Leader,
        point: DimensionPoint::BySetting,
        longest_line: 4096,
        most_machine_codes: 3,
        builders: BuilderCodes::Several,
    },
    codes: &CODES,
    machine_code,
    start: Start { motion: G::Rapid, feed: FeedMode::PerRevolution, plane: Plane::ZX, retract: Retract::Initial },
    order: Order::Fanuc,
    axes: AxisWords { x: AcrossWord::Diameter, increments: Increments::ByLetters },
    arcs: ArcWords { letters: Letters::of("IKR"), across: Across::Foreign },
    rotary: RotaryRule { delivered: Rotary::Linear, rollover: Rollover::Numbered },
    feed: FeedRule {
        law: FeedLaw::Resultant,
        codes: FeedCodes::G98,
        missing: MissingFeed::Cautioned,
        change: FeedChange::KeepsStale,
        path: FeedPath::AllAxes,
    },
    spindle: SpindleRule { turns: Turns::Part, limit: SpeedLimit::Code },
    tool: ToolCall::Digits,
    change: ToolChange::Routine,
    length: LengthWord::D,
    offsets: OffsetRule::SelectOrShift,
    cancel: Cancel::RestoresMotion,
    machine_move: MachineMove::Rapid,
    reference: Reference::Named,
    corners: Corners::Drawing,
    radius: RadiusRule::Nose(NoseCorner::Straight),
    drilling: Drilling::Lathe,
    calls: Calls { by: CallBy::Number, depth: 4 },
    written: None,
    alarms: Some(AlarmFamily::Fanuc),
};

const MACRO: Name =
    ("macros, interrupciones y llamadas a otros dispositivos", "macros, interrupts and calls of other devices");

const SETTING: Name = ("ajuste de datos por programa", "data setting by program");
const POLAR: Name = ("interpolación polar y cilíndrica", "polar and cylindrical interpolation");
const PLANE: Name = ("planos XY e YZ", "planes XY and YZ");
const WATCH: Name = ("vigilancia de carrera y de giro", "stroke check and spindle watch");
const REFERENCE: Name =
    ("comprobación del punto de referencia y retorno desde él", "check of the reference point and return from it");
const PROBE: Name = ("salto por señal y corrector automático", "skip and automatic tool offset");
const LOCAL: Name = ("origen local", "local offset");
const PATH: Name = ("parada exacta y control de la trayectoria", "exact stop and path control");
const TURRETS: Name = ("torretas opuestas y corte equilibrado", "double turrets and balanced cutting");
const TAPPING: Name =
    ("roscado con macho, mandrinado y taladrado lateral", "tapping, boring and drilling from the side");

static CODES: Codes = Codes::new(&[
    (0, G::Rapid),
    (10, G::Linear),
    (20, G::Arc(true)),
    (30, G::Arc(false)),
    (40, G::Dwell),
    (180, G::Plane(Plane::ZX)),
    (200, G::Inch),
    (210, G::Millimetre),
    (280, G::Reference(false)),
    (300, G::Reference(true)),
    (320, G::Thread(false)),
    (340, G::Thread(true)),
    (400, G::Compensation(Compensation::Off)),
    (410, G::Compensation(Compensation::Left)),
    (420, G::Compensation(Compensation::Right)),
    (500, G::SetPositionOrSpeed),
    (530, G::MachineCoordinates),
    (540, G::WorkOffset(1)),
    (550, G::WorkOffset(2)),
    (560, G::WorkOffset(3)),
    (570, G::WorkOffset(4)),
    (580, G::WorkOffset(5)),
    (590, G::WorkOffset(6)),
    (650, G::Refused(Group::NonModal, &MACRO)),
    (700, G::Turning(TurningCycle::Finish)),
    (710, G::Turning(TurningCycle::Axial)),
    (720, G::Turning(TurningCycle::Radial)),
    (730, G::Turning(TurningCycle::Repeat)),
    (740, G::Turning(TurningCycle::GrooveFace)),
    (750, G::Turning(TurningCycle::GrooveOutside)),
    (760, G::Turning(TurningCycle::Thread)),
    (800, G::Cancel),
    (810, G::Cycle(Cycle::Drill)),
    (820, G::Cycle(Cycle::DrillDwell)),
    (830, G::Cycle(Cycle::Peck)),
    (900, G::Pass(SinglePassCycle::Axial)),
    // No code of the system; alone in a block it is passed over.
    (910, G::Incremental),
    (920, G::Pass(SinglePassCycle::Thread)),
    (940, G::Pass(SinglePassCycle::Radial)),
    (960, G::ConstantSurfaceSpeed),
    (970, G::Rpm),
    (980, G::Feed(FeedMode::PerMinute)),
    (990, G::Feed(FeedMode::PerRevolution)),
    (71, G::Refused(Group::Other, &POLAR)),
    (90, G::Refused(Group::Other, &PATH)),
    (100, G::Refused(Group::NonModal, &SETTING)),
    (110, G::Refused(Group::NonModal, &SETTING)),
    (121, G::Refused(Group::Other, &POLAR)),
    (131, G::Refused(Group::Other, &POLAR)),
    (170, G::Refused(Group::Plane, &PLANE)),
    (190, G::Refused(Group::Plane, &PLANE)),
    (220, G::Refused(Group::Other, &WATCH)),
    (230, G::Refused(Group::Other, &WATCH)),
    (250, G::Refused(Group::Other, &WATCH)),
    (260, G::Refused(Group::Other, &WATCH)),
    (270, G::Refused(Group::NonModal, &REFERENCE)),
    (290, G::Refused(Group::NonModal, &REFERENCE)),
    (310, G::Refused(Group::NonModal, &PROBE)),
    (360, G::Refused(Group::NonModal, &PROBE)),
    (370, G::Refused(Group::NonModal, &PROBE)),
    (520, G::Refused(Group::NonModal, &LOCAL)),
    (610, G::Refused(Group::Path, &PATH)),
    (630, G::Refused(Group::Path, &PATH)),
    (640, G::Refused(Group::Path, &PATH)),
    (660, G::Refused(Group::NonModal, &MACRO)),
    (670, G::Refused(Group::NonModal, &MACRO)),
    (680, G::Refused(Group::Other, &TURRETS)),
    (690, G::Refused(Group::Other, &TURRETS)),
    (840, G::Refused(Group::Motion, &TAPPING)),
    (850, G::Refused(Group::Motion, &TAPPING)),
    (860, G::Refused(Group::Motion, &TAPPING)),
    (870, G::Refused(Group::Motion, &TAPPING)),
    (880, G::Refused(Group::Motion, &TAPPING)),
    (890, G::Refused(Group::Motion, &TAPPING)),
]);

fn machine_code(number: u32) -> Option<M> {
    Some(match number {
        0 | 1 => M::Pause,
        2 | 30 => M::End,
        3 => M::Spindle(true),
        4 => M::Spindle(false),
        5 => M::SpindleOff,
        7 | 8 => M::Coolant(true),
        9 => M::Coolant(false),
        38 | 39 => M::Door,
        96 | 198 => M::Refused(&MACRO),
        97 => M::CallBlock,
        98 => M::Call,
        99 => M::Return,
        // The machine's builder defines the others: gears, clamps, chuck, spindle orientation.
        6 | 10..=199 => M::User,
        _ => return None,
    })
}
