//! LinuxCNC: its G and M codes as its G-code reference has them.

use crate::gcode::code::{Cycle, G, Group, M};
use crate::gcode::control::codes::{BY_MODE, COMMON, common_machine_code};
use crate::gcode::control::{
    Across, AcrossWord, ArcWords, AxisWords, BlockDelete, BuilderCodes, ByteOrderMarkRule, CallBy, Calls, Cancel,
    Class, Codes, CommentForm, Comments, Control, Corners, Decimals, DimensionPoint, Drilling, DwellUnit, DwellWord,
    EmptyBlock, FeedChange, FeedCodes, FeedLimit, FeedPath, FeedRule, FileName, HeightHold, Increments, Language,
    LengthWord, Lexis, LoneDwell, LoneReturn, MachineMove, MachineZero, MissingFeed, NamesWithDigit, NegativeRadius,
    NumberBehind, OffsetRule, Order, Percent, PolarWords, Post, Radii, RadiusRule, Reference, Retract, Rollover,
    RotaryMode, RotaryRule, Source, SpeedLimit, SpindleRule, Start, TextForm, ThreadAngle, ToolBlocks, ToolCall,
    ToolChange, Turns, UnitChange, UnsaidFeed, WordOrder, Writing,
};
use crate::gcode::feed_law::FeedLaw;
use crate::gcode::in_force::Compensation;
use crate::gcode::letters::Letters;
use crate::gcode::motion::{FeedMode, Plane};
use crate::text::{Text, t};

/// LinuxCNC for mills, with rotary axes.
pub static LINUXCNC: Control = Control {
    name: "linuxcnc",
    sources: &[Source::Manual(t(
        "LinuxCNC, referencia de códigos G: sus códigos G y M; G93, la inversa del tiempo; comentarios entre paréntesis; G21; G49",
        "LinuxCNC, G-code reference: its G and M codes; G93, inverse time; comments in parentheses; G21; G49",
    ))],
    text: TextForm {
        opening: &[],
        ending: &[],
        comment: CommentForm::Parentheses,
        end_of_line: "\n",
        greatest_number: 99_999,
        memory: 1 << 30,
        file: FileName::Any,
    },
    class: Class::Mill,
    lexis: Lexis {
        letters: Letters::of("ABCDEFHIJKLPQRSTUVWXYZ"),
        refused: Letters::of(""),
        free: Letters::of("FST"),
        negative: Letters::of("D"),
        dwell: &[DwellWord { letter: 'P', unit: DwellUnit::Second, shared: true }],
        cycle_dwell: DwellUnit::Second,
        language: Language::OWords,
        comments: Comments::ParenthesesAndSemicolon,
        delete: BlockDelete::Plain,
        percent: Percent::Pair,
        mark: ByteOrderMarkRule::Rejected,
        lone_dwell: LoneDwell::Rejected,
        lone_return: LoneReturn::Rejected,
        words: WordOrder::Free,
        empty: EmptyBlock::Passed,
        greatest_number: 999_999_999,
        decimals: Decimals::Free,
        point: DimensionPoint::Free,
        // The interpreter reads 253 bytes with the end of the line, which may be of two.
        longest_line: 251,
        most_machine_codes: 4,
        builders: BuilderCodes::One,
        behind: NumberBehind::Rejected,
        polar: PolarWords::Signs,
        names: NamesWithDigit::None,
    },
    codes: &CODES,
    machine_code,
    start: Start {
        motion: G::Cancel,
        feed: FeedMode::PerMinute,
        plane: Plane::XY,
        retract: Retract::R,
        units: UnitChange::Anywhere,
    },
    order: Order::Rs274,
    axes: AxisWords { x: AcrossWord::Radius, increments: Increments::ByMode },
    arcs: ArcWords {
        letters: Letters::of("IJKRP"),
        across: Across::Foreign,
        negative: NegativeRadius::LongArc,
        radii: Radii::LinuxCnc,
    },
    rotary: RotaryRule { delivered: RotaryMode::Linear, rollover: Rollover::Wrapped },
    feed: FeedRule {
        law: FeedLaw::InverseTime,
        codes: FeedCodes::G94,
        missing: MissingFeed::Refused,
        change: FeedChange::Forgets,
        path: FeedPath::LinearFirst,
        unsaid: UnsaidFeed::Taken,
        limit: FeedLimit::Number,
    },
    spindle: SpindleRule { turns: Turns::Tool, limit: SpeedLimit::Word, thread_angle: ThreadAngle::None },
    tool: ToolCall::Change,
    change: ToolChange::Selected,
    length: LengthWord::H,
    offsets: OffsetRule::Select,
    cancel: Cancel::LeavesNone,
    machine_move: MachineMove::InForce,
    reference: Reference::NamedOrAll,
    corners: Corners::None,
    radius: RadiusRule::Cutter,
    drilling: Drilling::Rs274,
    calls: Calls { by: CallBy::Label, depth: 10 },
    written: Some(&WRITING),
    alarms: None,
};

/// How rodete writes for LinuxCNC.
static WRITING: Writing = Writing {
    safety: &[('G', 17), ('G', 21), ('G', 40), ('G', 49), ('G', 54), ('G', 80), ('G', 90), ('G', 94), ('G', 97)],
    tool: ToolBlocks::Change,
    // QtPlasmaC, its plasma table, holds the height while output 2 is on.
    height: HeightHold::Output(2),
    clamps: &[],
    zero: MachineZero::Read,
};

/// LinuxCNC as rodete writes for it.
pub const POST_LINUXCNC: Post = Post { control: &LINUXCNC, writing: &WRITING };

static SPLINE: Text = t("curvas spline y NURBS", "spline and NURBS curves");
static LATHE_MODE: Text = t("modo diámetro o radio del torno", "lathe diameter and radius mode");
static UVW_PLANE: Text = t("planos de los ejes U, V y W", "planes of the axes U, V and W");
static SYNCHRONISED: Text = t("movimiento sincronizado con el husillo", "spindle-synchronised motion");
static PROBE: Text = t("palpado", "probing");
static TURNING: Text = t("ciclos de torneado y roscado", "turning and threading cycles");

static CODES: Codes = Codes::new(&[
    COMMON,
    BY_MODE,
    &[
        (&[50, 51, 52], G::Refused(Group::Motion, &SPLINE)),
        (&[53], G::Refused(Group::NonModal, &SPLINE)),
        (&[70, 80], G::Refused(Group::Other, &LATHE_MODE)),
        (&[100], G::SetOffsets),
        (&[171, 181, 191], G::Refused(Group::Plane, &UVW_PLANE)),
        (&[200], G::Inch),
        (&[210], G::Millimetre),
        (&[280], G::Reference(false)),
        (&[281], G::SetReference(false)),
        (&[300], G::Reference(true)),
        (&[301], G::SetReference(true)),
        (&[330, 331], G::Refused(Group::Motion, &SYNCHRONISED)),
        (&[382, 383, 384, 385], G::Refused(Group::Motion, &PROBE)),
        (&[410], G::Compensation(Compensation::Left)),
        (&[411], G::CompensationGiven(Compensation::Left)),
        (&[420], G::Compensation(Compensation::Right)),
        (&[421], G::CompensationGiven(Compensation::Right)),
        (&[430], G::ToolLength),
        (&[431], G::ToolLengthGiven),
        (&[432], G::ToolLengthAdded),
        (&[490], G::ToolLengthOff),
        (&[520], G::LocalOffset),
        (&[530], G::MachineCoordinates),
        (&[580], G::WorkOffset(5)),
        (&[590], G::WorkOffset(6)),
        (&[591], G::WorkOffset(7)),
        (&[592], G::WorkOffset(8)),
        (&[593], G::WorkOffset(9)),
        (&[610, 611], G::PathControl),
        (&[640], G::PathTolerance),
        (&[700, 710, 711, 712, 720, 721, 722, 760], G::Refused(Group::Motion, &TURNING)),
        (&[730], G::Cycle(Cycle::ChipBreak)),
        (&[740], G::Cycle(Cycle::TapLeft)),
        (&[800], G::Cancel),
        (&[810], G::Cycle(Cycle::Drill)),
        (&[820], G::Cycle(Cycle::DrillDwell)),
        (&[830], G::Cycle(Cycle::Peck)),
        (&[840], G::Cycle(Cycle::TapRight)),
        (&[850], G::Cycle(Cycle::Bore)),
        (&[860], G::Cycle(Cycle::BoreStop)),
        (&[870], G::Cycle(Cycle::BackBore)),
        (&[880], G::Cycle(Cycle::BoreManual)),
        (&[890], G::Cycle(Cycle::BoreDwell)),
        (&[901], G::CentreAbsolute),
        (&[911], G::CentreIncremental),
        (&[920], G::SetPosition),
        (&[921], G::ClearPosition),
        (&[922], G::SuspendPosition),
        (&[923], G::RestorePosition),
        (&[930], G::Feed(FeedMode::InverseTime)),
        (&[960], G::ConstantSurfaceSpeed),
        (&[970], G::Rpm),
        (&[980], G::ReturnInitial),
        (&[990], G::ReturnR),
    ],
]);

fn machine_code(number: u32) -> Option<M> {
    common_machine_code(number).or_else(|| {
        Some(match number {
            60 => M::Pause,
            6 => M::ToolChange,
            7 => M::Coolant(true),
            19 => M::SpindleOrient,
            48..=53 => M::Override,
            61 => M::SetTool,
            62..=65 => M::Output,
            66 => M::Input,
            67 | 68 => M::AnalogOutput,
            70 => M::SaveState(false),
            71 => M::ForgetState,
            72 => M::RestoreState,
            73 => M::SaveState(true),
            98 => M::Call,
            99 => M::Return,
            100..=199 => M::User,
            _ => return None,
        })
    })
}
