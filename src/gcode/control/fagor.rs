//! Fagor CNC 8055 M, 8055 T and 8070: the codes whose motion rodete follows, and the others by name.

use crate::gcode::code::{G, Group, M, TurningCycle};
use crate::gcode::control::codes::{BY_MODE, COMMON, Row, common_machine_code};
use crate::gcode::control::{
    Across, AcrossWord, ArcWords, AxisWords, BlockDelete, BuilderCodes, CallBy, Calls, Cancel, Class, Codes,
    CommentForm, Comments, Control, Corners, Decimals, DimensionPoint, Drilling, DwellUnit, DwellWord, EmptyBlock,
    FeedChange, FeedCodes, FeedLimit, FeedPath, FeedRule, FileName, HeightHold, Increments, Language, LengthWord,
    Lexis, LoneDwell, LoneReturn, MachineMove, MachineZero, Mark, MissingFeed, NamesWithDigit, NegativeRadius,
    NoseCorner, NumberBehind, OffsetRule, OpeningLine, Order, Percent, PolarWords, Post, Radii, RadiusRule, Reference,
    Retract, Rollover, RotaryMode, RotaryRule, Source, SpeedLimit, SpindleRule, Start, TextForm, ToolBlocks, ToolCall,
    ToolChange, Turns, UnitChange, UnsaidFeed, WordOrder, Writing,
};
use crate::gcode::feed_law::FeedLaw;
use crate::gcode::in_force::Compensation;
use crate::gcode::letters::Letters;
use crate::gcode::motion::{FeedMode, Plane};
use crate::text::{Text, t};

/// Fagor CNC 8055, milling.
pub static FAGOR_8055: Control = Control {
    name: "fagor-8055",
    sources: &[
        Source::Manual(t(
            "Fagor Automation, CNC 8055 M, manual de programación: lista de funciones G; cabecera %nombre,MX--,; comentario ;, ninguna línea vacía; orden de un bloque G, ejes, F, S, T, D, M; números ±5.4; N de 0 a 99999999; G70 pulgadas y G71 milímetros; G43 y G44; G94, F a lo largo de la resultante de los ejes, los grados como milímetros",
            "Fagor Automation, CNC 8055 M, programming manual: list of G functions; header %name,MX--,; comment ;, no empty lines; order of a block G, axes, F, S, T, D, M; numbers ±5.4; N 0 to 99999999; G70 inch and G71 millimetre; G43 and G44; G94, F along the resultant of the axes, degrees taken as millimetres",
        )),
        Source::Manual(t(
            "Fagor Automation, CNC 8055 M, solución de errores (Ref. 1310), errores 0054 y 1085: en un arco de G17 K es el paso de una hélice, siempre positivo; 0002 a 0004, 0009, 0012 y 0048: orden G, ejes X Y Z U V W A B C, F S T D, M (manual de programación, p. 47 y 65)",
            "Fagor Automation, CNC 8055 M, error solution (Ref. 1310), errors 0054 and 1085: in an arc of G17 K is the pitch of a helix, always positive; 0002 to 0004, 0009, 0012 and 0048: order G, axes X Y Z U V W A B C, F S T D, M (programming manual, p. 47 and 65)",
        )),
        Source::Manual(t(
            "Fagor Automation, CNC 8055 M, manual de programación, p. 144: G43 cuenta desde el siguiente movimiento del eje longitudinal, con L y K del corrector D, o del de la herramienta sin D; G44 la anula; p. 109: G4 sola para la preparación de bloques y anula la compensación de radio y de longitud en vigor; 5.7.8 y 5.7.9: M41 a M44 y M45",
            "Fagor Automation, CNC 8055 M, programming manual, p. 144: G43 counts from the next motion of the longitudinal axis, with L and K of offset D, or of the tool's own without D; G44 cancels it; p. 109: G4 alone stops the preparation of blocks and cancels the compensation of radius and length in force; 5.7.8 and 5.7.9: M41 to M44 and M45",
        )),
        Source::Manual(t(
            "Fagor Automation, CNC 8055 M, solución de errores (Ref. 1310), errores 0013, 0016, 0017, 0025, 0029 a 0036, 0116, 0200, 0213 y 1029: G15, G16, G28 a G30, G52, G60 a G68, G77, G78, G159; manual de programación, p. 419: G47 a G49; p. 88: I, J y K en el orden de sus ejes; errores 0007 y 0028: un ciclo corre con G0 o G1 activa; manual de ejemplos (Ref. 1010): tras G80 se mueve sin código de movimiento",
            "Fagor Automation, CNC 8055 M, error solution (Ref. 1310), errors 0013, 0016, 0017, 0025, 0029 to 0036, 0116, 0200, 0213 and 1029: G15, G16, G28 to G30, G52, G60 to G68, G77, G78, G159; programming manual, p. 419: G47 to G49; p. 88: I, J and K in the order of their axes; errors 0007 and 0028: a cycle runs with G0 or G1 active; examples manual (Ref. 1010): behind G80 a block moves without a motion code",
        )),
        FRAME,
        DWELL,
    ],
    lexis: Lexis { lone_dwell: LoneDwell::StopsPreparation, ..LEXIS },
    machine_code: machine_code_8055,
    cancel: Cancel::RestoresMotion,
    ..FAGOR_8055_BASE
};

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
    text: TextForm { file: FileName::SixDigits("PIT"), ..FAGOR_8055_BASE.text },
    lexis: Lexis { letters: Letters::of("ABCDFIJKQRSTUVWXYZ"), ..LEXIS },
    codes: &CODES_8055_T,
    start: Start { plane: Plane::ZX, ..FAGOR_8055_BASE.start },
    order: Order::FagorLathe,
    axes: AxisWords { x: AcrossWord::Diameter, increments: Increments::ByMode },
    arcs: ArcWords { across: Across::Unknown, ..FAGOR_8055_BASE.arcs },
    feed: FeedRule { unsaid: UnsaidFeed::Told, ..FAGOR_8055_BASE.feed },
    spindle: SpindleRule { turns: Turns::Part, limit: SpeedLimit::Code },
    tool: ToolCall::Words,
    radius: RadiusRule::Nose(NoseCorner::StraightTo120),
    written: Some(&WRITING_8055_T),
    ..FAGOR_8055_BASE
};

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
    text: TextForm { opening: &[OpeningLine::Name], memory: 1 << 30, file: FileName::Any, ..FAGOR_8055_BASE.text },
    feed: FeedRule { law: FeedLaw::Seconds, ..FAGOR_8055_BASE.feed },
    written: Some(&WRITING_8070),
    codes: &CODES_8070,
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
    arcs: ArcWords { across: Across::Unknown, ..FAGOR_8055_BASE.arcs },
    length: LengthWord::OfTool,
    rotary: RotaryRule { delivered: RotaryMode::Linear, ..FAGOR_8055_BASE.rotary },
    ..FAGOR_8055_BASE
};

const FRAME: Source = Source::Manual(t(
    "Fagor Automation, CNC 8055/8055i, nuevas prestaciones, p. 11: un archivo de seis cifras, .PIM de fresadora o .PIT de torno, otro no se lista; cabecera %nombre, en la primera línea, de hasta 20 caracteres, una coma y los atributos M, X, H, O; con otra forma, o sin X, el programa no es ejecutable. CNC 8055 M, solución de errores, 0001: ningún bloque vacío ni con solo la etiqueta; 0002: /1 a /3, N de 0 a 99999999; manual de programación, p. 65 y 88: ±5.4 en milímetros, ±4.5 en pulgadas, I, J, K y R ±6.5",
    "Fagor Automation, CNC 8055/8055i, new features, p. 11: a file of six digits, .PIM of a mill or .PIT of a lathe, another is not listed; header %name, in the first line, of up to 20 characters, a comma and the attributes M, X, H, O; in another form, or without X, the program is not executable. CNC 8055 M, error solution, 0001: no block empty or with a label alone; 0002: /1 to /3, N 0 to 99999999; programming manual, p. 65 and 88: ±5.4 in millimetres, ±4.5 in inches, I, J, K and R ±6.5",
));

const DWELL: Source = Source::NotFound(t(
    "K de G4; se toma en centésimas de segundo, como la de los ciclos (CNC 8055 M, manual de programación, p. 162 y 177)",
    "K of G4; taken to count hundredths of a second, as that of cycles does (CNC 8055 M, programming manual, p. 162 and 177)",
));

const NO_HELIX: Source =
    Source::NotFound(t("palabra de centro a través del plano de un arco", "centre word across the plane of an arc"));

/// What milling and turning have in common.
const FAGOR_8055_BASE: Control = Control {
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
    codes: &CODES_8055,
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
    spindle: SpindleRule { turns: Turns::Tool, limit: SpeedLimit::Code },
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
    written: Some(&WRITING_8055),
    alarms: None,
};

/// How rodete writes for the 8055 M.
static WRITING_8055: Writing = Writing {
    safety: &[('G', 17), ('G', 40), ('G', 44), ('G', 54), ('G', 71), ('G', 90), ('G', 94)],
    tool: ToolBlocks::OffsetThenChange,
    height: HeightHold::Builder,
    clamps: &[11, 13],
    zero: MachineZero::Assumed,
};

/// The Fagor 8055 as rodete writes for it.
pub const POST_8055: Post = Post { control: &FAGOR_8055, writing: &WRITING_8055 };

/// How rodete writes for the 8055 T.
static WRITING_8055_T: Writing = Writing {
    safety: &[('G', 71), ('G', 90), ('G', 94)],
    tool: ToolBlocks::Turret,
    height: HeightHold::Builder,
    clamps: &[],
    zero: MachineZero::Assumed,
};

/// The Fagor 8055 T, a lathe, as rodete writes for it.
pub const POST_8055_T: Post = Post { control: &FAGOR_8055_T, writing: &WRITING_8055_T };

/// How rodete writes for the 8070.
static WRITING_8070: Writing = Writing {
    safety: &[('G', 17), ('G', 40), ('G', 54), ('G', 71), ('G', 90), ('G', 94)],
    tool: ToolBlocks::OffsetAndChange,
    height: HeightHold::Builder,
    clamps: &[],
    zero: MachineZero::Assumed,
};

/// What the text of an 8055 M is made of.
const LEXIS: Lexis = Lexis {
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
    mark: Mark::Skipped,
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

static GEOMETRY: Text = t(
    "ayudas geométricas (redondeos, chaflanes, arcos tangentes)",
    "geometric aids (corner rounding, chamfers, tangent arcs)",
);
static MIRROR: Text = t("imagen espejo, escala y giro de coordenadas", "mirror image, scaling and pattern rotation");
static ZONE: Text = t("zonas de trabajo", "work zones");
static THREAD: Text = t("roscado electrónico", "electronic threading");
static COMPENSATION: Text = t("compensación de radio de herramienta", "tool radius compensation");
static TRANSFORMATION: Text = t("transformación de coordenadas y TCP", "coordinate transformation and TCP");
static ADDITIVE: Text = t("traslado de origen aditivo", "additive zero offset");
static CYCLE: Text = t("ciclos fijos", "canned cycles");
static TURNING_CYCLE: Text = t("ciclos fijos de torneado", "turning cycles");
static PROBE: Text = t("búsqueda de referencia y palpado", "home search and probing");
static POLAR: Text = t("origen polar", "polar origin");
/// Its A is a share of the acceleration and not an axis (error manual, 0118 and 0208).
static LOOK_AHEAD: Text = t("anticipación de bloques, con A y E", "look-ahead, with A and E");
static CUTTING_POINT: Text = t("avance constante del punto de corte", "constant feed of the cutting point");
static INVERSE: Text = t("avance como inversa del tiempo", "feed as inverse of the time");
static LONGITUDINAL: Text = t("elección del eje longitudinal", "choice of the longitudinal axis");
static PLANE_OF_AXES: Text = t("plano de dos ejes", "plane of two axes");
static SECOND_SPINDLE: Text = t("segundo husillo, o intercambio de ejes", "second spindle, or exchange of axes");
static SPINDLE_ANGLE: Text = t("desfase de husillos sincronizados", "angle between synchronised spindles");
static TOOL_AXIS: Text = t("movimiento según el eje de la herramienta", "motion along the tool's axis");
static HARD_STOP: Text = t("movimiento contra tope", "motion against a hard stop");
static MULTIPLE: Text = t("mecanizado múltiple", "multiple machining");
static ISLANDS: Text = t("cajeras con islas", "pockets with islands");
static COUPLING: Text = t("ejes o husillos acoplados", "coupled axes or spindles");
static TABLE_OFFSETS: Text = t("traslados de origen de la tabla, con N", "work offsets of the table, by N");
static GEAR: Text = t("gama de velocidad del husillo", "speed range of the spindle");
static LIVE_TOOL: Text = t("herramienta motorizada, con S propia", "live tool, with an S of its own");
static CANCEL_ZERO: Text = t("anulación del traslado de origen", "zero offset cancellation");

/// What 8055 M, 8055 T and 8070 have in common.
const FAGOR: &[Row] = &[
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
const BOTH_8055: &[Row] = &[
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
const MILLS: &[Row] = &[
    (&[410, 420], G::Refused(Group::CutterCompensation, &COMPENSATION)),
    (&[800], G::Cancel),
    (&[810, 820, 830, 840, 850, 860, 870, 880, 890], G::Refused(Group::Motion, &CYCLE)),
    (&[980], G::ReturnInitial),
    (&[990], G::ReturnR),
];

static CODES_8055: Codes = Codes::new(&[
    COMMON,
    BY_MODE,
    FAGOR,
    BOTH_8055,
    MILLS,
    &[
        (&[150], G::Refused(Group::Plane, &LONGITUDINAL)),
        (&[160], G::Refused(Group::Plane, &PLANE_OF_AXES)),
        (&[280, 290], G::Refused(Group::Other, &SECOND_SPINDLE)),
        (&[300], G::Refused(Group::Other, &SPINDLE_ANGLE)),
        (&[320], G::Refused(Group::Feed, &INVERSE)),
        (&[430], G::ToolLength),
        (&[440], G::ToolLengthOff),
        (&[480, 490], G::Refused(Group::Other, &TRANSFORMATION)),
        (&[470], G::Refused(Group::Other, &TOOL_AXIS)),
        (&[520], G::Refused(Group::NonModal, &HARD_STOP)),
        (&[600, 610, 620, 630, 640, 650], G::Refused(Group::Motion, &MULTIPLE)),
        (&[660, 670, 680], G::Refused(Group::Motion, &ISLANDS)),
        (&[690, 790], G::Refused(Group::Motion, &CYCLE)),
        (&[770, 780], G::Refused(Group::Other, &COUPLING)),
        (&[1590], G::Refused(Group::WorkOffset, &TABLE_OFFSETS)),
        (&[960], G::Refused(Group::Speed, &CUTTING_POINT)),
        (&[970], G::PathControl),
    ],
]);

static CODES_8055_T: Codes = Codes::new(&[
    COMMON,
    BY_MODE,
    FAGOR,
    BOTH_8055,
    &[
        (&[340], G::Refused(Group::Motion, &THREAD)),
        (&[410], G::Compensation(Compensation::Left)),
        (&[420], G::Compensation(Compensation::Right)),
        (&[660, 680, 690], G::RefusedCycle(&TURNING_CYCLE)),
        (&[810], G::Turning(TurningCycle::Fagor(81))),
        (&[820], G::Turning(TurningCycle::Fagor(82))),
        (&[830], G::Turning(TurningCycle::Fagor(83))),
        (&[840], G::Turning(TurningCycle::Fagor(84))),
        (&[850], G::Turning(TurningCycle::Fagor(85))),
        (&[860], G::Turning(TurningCycle::Fagor(86))),
        (&[870], G::Turning(TurningCycle::Fagor(87))),
        (&[880], G::Turning(TurningCycle::Fagor(88))),
        (&[890], G::Turning(TurningCycle::Fagor(89))),
        (&[960], G::ConstantSurfaceSpeed),
        (&[970], G::Rpm),
    ],
]);

static CODES_8070: Codes = Codes::new(&[
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

/// The 8055 M names some codes that the other two leave to the machine's builder.
fn machine_code_8055(number: u32) -> Option<M> {
    match number {
        41..=44 => Some(M::NotFollowed(&GEAR)),
        45 => Some(M::NotFollowed(&LIVE_TOOL)),
        _ => machine_code(number),
    }
}

fn machine_code(number: u32) -> Option<M> {
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
