//! What Fagor's controls share: the frame of a program, its characters, codes that two or three of them have.

use crate::gcode::code::{G, Group, M};
use crate::gcode::control::codes::{BY_MODE, COMMON, Row, common_machine_code};
use crate::gcode::control::{
    Across, AcrossWord, ArcWords, AxisWords, BlockDelete, BuilderCodes, ByteOrderMarkRule, CallBy, Calls, Cancel,
    Class, Codes, CommentForm, Comments, Control, Corners, Decimals, DimensionPoint, Drilling, DwellUnit, DwellWord,
    EmptyBlock, FeedChange, FeedCodes, FeedLimit, FeedPath, FeedRule, FileName, Increments, Language, LengthWord,
    Lexis, LoneDwell, LoneReturn, MachineMove, MissingFeed, NamesWithDigit, NegativeRadius, NumberBehind, OffsetRule,
    OpeningLine, Order, Percent, PolarWords, Radii, RadiusRule, Reference, Retract, Rollover, RotaryMode, RotaryRule,
    Source, SpeedLimit, SpindleRule, Start, TextForm, ThreadAngle, ToolCall, ToolChange, Turns, UnitChange, UnsaidFeed,
    WordOrder,
};
use crate::gcode::feed_law::FeedLaw;
use crate::gcode::letters::Letters;
use crate::gcode::motion::{FeedMode, Plane};
use crate::text::{Text, t};

pub(super) const FRAME: Source = Source::Manual(t(
    "Fagor Automation, CNC 8055/8055i, nuevas prestaciones, p. 11: un archivo de seis cifras, .PIM de fresadora o .PIT de torno, otro no se lista; cabecera %nombre, en la primera línea, de hasta 20 caracteres, una coma y los atributos M, X, H, O; con otra forma, o sin X, el programa no es ejecutable. CNC 8055 M, solución de errores, 0001: ningún bloque vacío ni con solo la etiqueta; 0002: /1 a /3, N de 0 a 99999999; manual de programación, p. 65 y 88: ±5.4 en milímetros, ±4.5 en pulgadas, I, J, K y R ±6.5",
    "Fagor Automation, CNC 8055/8055i, new features, p. 11: a file of six digits, .PIM of a mill or .PIT of a lathe, another is not listed; header %name, in the first line, of up to 20 characters, a comma and the attributes M, X, H, O; in another form, or without X, the program is not executable. CNC 8055 M, error solution, 0001: no block empty or with a label alone; 0002: /1 to /3, N 0 to 99999999; programming manual, p. 65 and 88: ±5.4 in millimetres, ±4.5 in inches, I, J, K and R ±6.5",
));

pub(super) const DWELL: Source = Source::NotFound(t(
    "K de G4; se toma en centésimas de segundo, como la de los ciclos (CNC 8055 M, manual de programación, p. 162 y 177)",
    "K of G4; taken to count hundredths of a second, as that of cycles does (CNC 8055 M, programming manual, p. 162 and 177)",
));

pub(super) const NO_HELIX: Source =
    Source::NotFound(t("palabra de centro a través del plano de un arco", "centre word across the plane of an arc"));

/// What each of them takes over where it says nothing else. It writes nothing, and its codes are those of all three.
pub(super) const BASE: Control = Control {
    name: "",
    sources: &[],
    text: TextForm {
        opening: &[OpeningLine::NameAndAttributes],
        ending: &[],
        comment: CommentForm::Semicolon,
        end_of_line: "\r\n",
        greatest_number: 99_999_999,
        memory: 1 << 20,
        file: FileName::SixDigits("PIM"),
    },
    class: Class::Mill,
    lexis: LEXIS,
    codes: &CODES,
    machine_code,
    start: Start {
        motion: G::Cancel,
        feed: FeedMode::PerMinute,
        plane: Plane::XY,
        retract: Retract::Initial,
        units: UnitChange::Anywhere,
    },
    order: Order::Fagor,
    axes: AxisWords { x: AcrossWord::Radius, increments: Increments::ByMode },
    arcs: ArcWords {
        letters: Letters::of("IJKRP"),
        across: Across::Pitch,
        negative: NegativeRadius::LongArc,
        radii: Radii::Parameter,
    },
    rotary: RotaryRule { delivered: RotaryMode::Rollover, rollover: Rollover::Numbered },
    feed: FeedRule {
        law: FeedLaw::Resultant,
        codes: FeedCodes::G94,
        missing: MissingFeed::Cautioned,
        change: FeedChange::KeepsStale,
        path: FeedPath::AllAxes,
        unsaid: UnsaidFeed::Taken,
        limit: FeedLimit::Format,
    },
    spindle: SpindleRule { turns: Turns::Tool, limit: SpeedLimit::Code, thread_angle: ThreadAngle::None },
    tool: ToolCall::Change,
    change: ToolChange::Routine,
    length: LengthWord::D,
    offsets: OffsetRule::SelectOrPreset,
    cancel: Cancel::LeavesNone,
    machine_move: MachineMove::InForce,
    reference: Reference::None,
    corners: Corners::None,
    radius: RadiusRule::None,
    drilling: Drilling::None,
    calls: Calls { by: CallBy::Nothing, depth: 10 },
    written: None,
    alarms: None,
};

/// What the text of an 8055 M is made of.
pub(super) const LEXIS: Lexis = Lexis {
    letters: Letters::of("ABCDFIJKRSTUVWXYZ"),
    refused: Letters::of("P"),
    free: Letters::of("DFST"),
    negative: Letters::of(""),
    dwell: &[DwellWord { letter: 'K', unit: DwellUnit::Hundredth, shared: false }],
    cycle_dwell: DwellUnit::Hundredth,
    lone_dwell: LoneDwell::Rejected,
    language: Language::Words,
    comments: Comments::Semicolon,
    delete: BlockDelete::Three,
    percent: Percent::Named,
    mark: ByteOrderMarkRule::Skipped,
    lone_return: LoneReturn::EndsLine,
    words: WordOrder::Ranked,
    empty: EmptyBlock::Rejected,
    greatest_number: 99_999_999,
    decimals: Decimals::FourOrFive,
    point: DimensionPoint::Free,
    longest_line: 4096,
    most_machine_codes: 7,
    builders: BuilderCodes::Several,
    behind: NumberBehind::Repeats,
    polar: PolarWords::RadiusAndAngle,
    names: NamesWithDigit::None,
};

static CODES: Codes = Codes::new(&[COMMON, BY_MODE, FAGOR]);

/// The G codes that 8055 M, 8055 T and 8070 have in common.
pub(super) const FAGOR: &[Row] = &[
    (&[50, 70, 500], G::PathControl),
    (&[60, 360, 370, 380, 390], G::Refused(Group::Other, &GEOMETRY)),
    (&[80, 90], G::Refused(Group::Motion, &GEOMETRY)),
    (&[100, 110, 120, 130, 140, 720, 730], G::Refused(Group::Other, &MIRROR)),
    (&[330], G::Refused(Group::Motion, &THREAD)),
    (&[700], G::Inch),
    (&[710], G::Millimetre),
    (&[740], G::Refused(Group::NonModal, &PROBE)),
];

/// What 8055 M and 8055 T have beside it.
pub(super) const BOTH_8055: &[Row] = &[
    (&[200, 210, 220], G::Refused(Group::Other, &ZONE)),
    (&[450], G::Refused(Group::Other, &TRANSFORMATION)),
    (&[510], G::Refused(Group::Other, &LOOK_AHEAD)),
    (&[530], G::MachineCoordinates),
    (&[580, 590], G::Refused(Group::WorkOffset, &ADDITIVE)),
    (&[750, 760], G::Refused(Group::NonModal, &PROBE)),
    (&[920], G::SetPositionOrSpeed),
    (&[930], G::Refused(Group::Other, &POLAR)),
];

/// What 8055 M and 8070 have beside it.
pub(super) const MILLS: &[Row] = &[
    (&[410, 420], G::Refused(Group::CutterCompensation, &COMPENSATION)),
    (&[800], G::Cancel),
    (&[810, 820, 830, 840, 850, 860, 870, 880, 890], G::Refused(Group::Motion, &CYCLE)),
    (&[980], G::ReturnInitial),
    (&[990], G::ReturnR),
];

/// The M codes that they have in common.
pub(super) fn machine_code(number: u32) -> Option<M> {
    common_machine_code(number).or_else(|| {
        Some(match number {
            6 => M::ToolChange,
            19 => M::SpindleOrient,
            // The machine's builder defines the others, the clamps M10 to M13 of the published programs among them.
            7 | 10..=9999 => M::User,
            _ => return None,
        })
    })
}

static GEOMETRY: Text = t(
    "ayudas geométricas (redondeos, chaflanes, arcos tangentes)",
    "geometric aids (corner rounding, chamfers, tangent arcs)",
);
static MIRROR: Text = t("imagen espejo, escala y giro de coordenadas", "mirror image, scaling and pattern rotation");
static ZONE: Text = t("zonas de trabajo", "work zones");
pub(super) static THREAD: Text = t("roscado electrónico", "electronic threading");
static COMPENSATION: Text = t("compensación de radio de herramienta", "tool radius compensation");
pub(super) static TRANSFORMATION: Text = t("transformación de coordenadas y TCP", "coordinate transformation and TCP");
static ADDITIVE: Text = t("traslado de origen aditivo", "additive zero offset");
pub(super) static CYCLE: Text = t("ciclos fijos", "canned cycles");
static PROBE: Text = t("búsqueda de referencia y palpado", "home search and probing");
pub(super) static POLAR: Text = t("origen polar", "polar origin");

/// Its A is a share of the acceleration and not an axis (error manual, 0118 and 0208).
static LOOK_AHEAD: Text = t("anticipación de bloques, con A y E", "look-ahead, with A and E");
