//! Fanuc, turning, G-code system A: U and W are the increments, G90, G92 and G94 are cycles, G98 and G99 say what F
//! means.
//!
//! # Comments and block delete
//! `( )`, and text behind `;`, as the simulator takes it; on the screen of a Fanuc `;` ends the block, so that what reads as
//! another block behind it is refused. The simulator takes text behind `/` for a comment too; on a Fanuc `/` at the start of a
//! block is block delete, and so it is here; elsewhere it is refused.

use crate::finding::AlarmFamily;
use crate::gcode::code::{Cycle, G, Group, M, SinglePassCycle, TurningCycle};
use crate::gcode::control::codes::{COMMON, common_machine_code};
use crate::gcode::control::{
    Across, AcrossWord, ArcWords, AxisWords, BlockDelete, BuilderCodes, ByteOrderMarkRule, CallBy, Calls, Cancel,
    Class, Codes, CommentForm, Comments, Control, Corners, CountedFeed, Counting, Decimals, DimensionPoint, Drilling,
    DwellUnit, DwellWord, EmptyBlock, FeedChange, FeedCodes, FeedLimit, FeedPath, FeedRule, FileName, Increments,
    Language, LeastIncrement, LengthWord, Lexis, LoneDwell, LoneReturn, MachineMove, MissingFeed, NamesWithDigit,
    NegativeRadius, NoseCorner, NumberBehind, OffsetRule, Order, Percent, PolarWords, Radii, RadiusRule, Reference,
    Retract, Rollover, RotaryMode, RotaryRule, Source, SpeedLimit, SpindleRule, Start, TextForm, ThreadAngle, ToolCall,
    ToolChange, Turns, UnitChange, UnsaidFeed, WordOrder,
};
use crate::gcode::feed_law::FeedLaw;
use crate::gcode::in_force::Compensation;
use crate::gcode::letters::Letters;
use crate::gcode::motion::{FeedMode, Plane};
use crate::text::{Text, t};

/// Fanuc, turning, G-code system A. Read only: rodete writes no program in it.
pub static FANUC_LATHE_A: Control = Control {
    name: "fanuc-lathe-a",
    sources: &[
        Source::Published(t(
            "la lista de códigos del simulador de torno: rodete interpreta estos; P de los ciclos de taladrado en milisegundos",
            "the lathe simulator's list of codes: rodete reads these; P of drilling cycles in milliseconds",
        )),
        Source::Manual(t(
            "Fanuc Series 0i-T, manual del operador, sistema A de códigos G: rodete rechaza los demás por su nombre, y también las letras que solo usan las opciones del control (C, A, B y otras)",
            "Fanuc Series 0i-T, operator's manual, G-code system A: rodete rejects the others by name, and also letters that only options of the control use (C, A, B and others)",
        )),
        Source::Manual(t(
            "Fanuc Series 16i/18i-PB, descripciones (B-63682EN/01), p. 54: sin punto decimal, una cota es de la unidad o de incrementos mínimos, según un parámetro",
            "Fanuc Series 16i/18i-PB, descriptions (B-63682EN/01), p. 54: without a decimal point a dimension counts units or least increments, by a parameter",
        )),
        Source::NotFound(t(
            "lo que cuentan X, U y P de G4; se toman X y U en segundos y P en milisegundos; una espera por vueltas no se lee",
            "what X, U and P of G4 count; X and U are taken in seconds and P in milliseconds; a dwell by revolutions is not read",
        )),
    ],
    text: TextForm {
        opening: &[],
        ending: &[],
        comment: CommentForm::Parentheses,
        end_of_line: "\r\n",
        greatest_number: 99_999,
        memory: 1 << 19,
        file: FileName::Any,
    },
    class: Class::Lathe,
    lexis: Lexis {
        letters: Letters::of("FIKLPQRSTUWXZ"),
        refused: Letters::of("ABCDEHJVY"),
        free: Letters::of("FST"),
        negative: Letters::of("Q"),
        dwell: &[
            DwellWord { letter: 'X', unit: DwellUnit::Second, shared: false },
            DwellWord { letter: 'U', unit: DwellUnit::Second, shared: false },
            DwellWord { letter: 'P', unit: DwellUnit::Millisecond, shared: false },
        ],
        cycle_dwell: DwellUnit::Millisecond,
        language: Language::Macros,
        comments: Comments::Parentheses,
        delete: BlockDelete::Numbered,
        percent: Percent::Leader,
        mark: ByteOrderMarkRule::Skipped,
        lone_dwell: LoneDwell::Rejected,
        lone_return: LoneReturn::EndsLine,
        words: WordOrder::Free,
        empty: EmptyBlock::Passed,
        greatest_number: 999_999_999,
        decimals: Decimals::Free,
        point: DimensionPoint::BySetting(Counting {
            letters: Letters::of("IKRUWXZ"),
            feed: CountedFeed::LengthUnknown,
            whole: Letters::of("LMPQT"),
            increment: LeastIncrement::Thousandth,
        }),
        longest_line: 4096,
        most_machine_codes: 3,
        builders: BuilderCodes::Several,
        behind: NumberBehind::Rejected,
        polar: PolarWords::None,
        names: NamesWithDigit::AxesAndSpindles,
    },
    codes: &CODES,
    machine_code,
    start: Start {
        motion: G::Rapid,
        feed: FeedMode::PerRevolution,
        plane: Plane::ZX,
        retract: Retract::R,
        units: UnitChange::AtBeginning,
    },
    order: Order::Fanuc,
    axes: AxisWords { x: AcrossWord::Diameter, increments: Increments::ByLetters },
    arcs: ArcWords {
        letters: Letters::of("IKR"),
        across: Across::Foreign,
        negative: NegativeRadius::Refused,
        radii: Radii::Parameter,
    },
    rotary: RotaryRule { delivered: RotaryMode::Linear, rollover: Rollover::Numbered },
    feed: FeedRule {
        law: FeedLaw::Resultant,
        codes: FeedCodes::G98,
        missing: MissingFeed::Cautioned,
        change: FeedChange::KeepsStale,
        path: FeedPath::AllAxes,
        unsaid: UnsaidFeed::Taken,
        limit: FeedLimit::Format,
    },
    spindle: SpindleRule { turns: Turns::Part, limit: SpeedLimit::Code, thread_angle: ThreadAngle::Thousandth },
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

static MACRO: Text =
    t("macros, interrupciones y llamadas a otros dispositivos", "macros, interrupts and calls of other devices");

static SETTING: Text = t("ajuste de datos por programa", "data setting by program");
static POLAR: Text = t("interpolación polar y cilíndrica", "polar and cylindrical interpolation");
static PLANE: Text = t("planos XY e YZ", "planes XY and YZ");
static WATCH: Text = t("vigilancia de carrera y de giro", "stroke check and spindle watch");
static REFERENCE: Text =
    t("comprobación del punto de referencia y retorno desde él", "check of the reference point and return from it");
static PROBE: Text = t("salto por señal y corrector automático", "skip and automatic tool offset");
static LOCAL: Text = t("origen local", "local offset");
static PATH: Text = t("parada exacta y control de la trayectoria", "exact stop and path control");
static TURRETS: Text = t("torretas opuestas y corte equilibrado", "double turrets and balanced cutting");
static TAPPING: Text =
    t("roscado con macho, mandrinado y taladrado lateral", "tapping, boring and drilling from the side");

static CODES: Codes = Codes::new(&[
    COMMON,
    &[
        (&[71, 121, 131], G::Refused(Group::Other, &POLAR)),
        (&[90], G::Refused(Group::Other, &PATH)),
        (&[100, 110], G::Refused(Group::NonModal, &SETTING)),
        (&[170, 190], G::Refused(Group::Plane, &PLANE)),
        (&[200], G::Inch),
        (&[210], G::Millimetre),
        (&[220, 230, 250, 260], G::Refused(Group::Other, &WATCH)),
        (&[270, 290], G::Refused(Group::NonModal, &REFERENCE)),
        (&[280], G::Reference(false)),
        (&[300], G::Reference(true)),
        (&[310, 360, 370], G::Refused(Group::NonModal, &PROBE)),
        (&[320], G::Thread(false)),
        (&[340], G::Thread(true)),
        (&[410], G::Compensation(Compensation::Left)),
        (&[420], G::Compensation(Compensation::Right)),
        (&[500], G::SetPositionOrSpeed),
        (&[520], G::Refused(Group::NonModal, &LOCAL)),
        (&[530], G::MachineCoordinates),
        (&[580], G::WorkOffset(5)),
        (&[590], G::WorkOffset(6)),
        (&[610, 630, 640], G::Refused(Group::Path, &PATH)),
        (&[650, 660, 670], G::Refused(Group::NonModal, &MACRO)),
        (&[680, 690], G::Refused(Group::Other, &TURRETS)),
        (&[700], G::Turning(TurningCycle::Finish)),
        (&[710], G::Turning(TurningCycle::Axial)),
        (&[720], G::Turning(TurningCycle::Radial)),
        (&[730], G::Turning(TurningCycle::Repeat)),
        (&[740], G::Turning(TurningCycle::GrooveFace)),
        (&[750], G::Turning(TurningCycle::GrooveOutside)),
        (&[760], G::Turning(TurningCycle::Thread)),
        (&[800], G::Cancel),
        (&[810], G::Cycle(Cycle::Drill)),
        (&[820], G::Cycle(Cycle::DrillDwell)),
        (&[830], G::Cycle(Cycle::Peck)),
        (&[840, 850, 860, 870, 880, 890], G::RefusedCycle(&TAPPING)),
        (&[900], G::Pass(SinglePassCycle::Axial)),
        (&[920], G::Pass(SinglePassCycle::Thread)),
        (&[940], G::Pass(SinglePassCycle::Radial)),
        (&[960], G::ConstantSurfaceSpeed),
        (&[970], G::Rpm),
        (&[980], G::Feed(FeedMode::PerMinute)),
        (&[990], G::Feed(FeedMode::PerRevolution)),
    ],
]);

fn machine_code(number: u32) -> Option<M> {
    common_machine_code(number).or_else(|| {
        Some(match number {
            7 => M::Coolant(true),
            38 | 39 => M::Door,
            96 | 198 => M::Refused(&MACRO),
            97 => M::CallBlock,
            98 => M::Call,
            99 => M::Return,
            // The machine's builder defines the others: gears, clamps, chuck, spindle orientation.
            6 | 10..=199 => M::User,
            _ => return None,
        })
    })
}
