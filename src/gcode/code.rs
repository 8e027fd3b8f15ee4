//! What G and M codes mean, whatever number a control gives them, and which of them exclude each other.

use crate::gcode::in_force::Compensation;
use crate::gcode::letters::Letters;
use crate::gcode::motion::{FeedMode, Plane};
use crate::gcode::turning::fagor::Along;
use crate::text::{Text, t};

/// A modal group: of one group a block may name one code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Group {
    /// Codes for one block: dwell, work offsets by program, reference points, machine coordinates.
    NonModal,
    /// Motion and canned cycles.
    Motion,
    /// The plane of arcs and cycles (G17 to G19).
    Plane,
    /// Absolute or incremental coordinates.
    Distance,
    /// Absolute or incremental arc centres.
    Centre,
    /// What F means.
    Feed,
    /// Inches or millimetres.
    Units,
    /// Cutter or nose radius compensation (G40 to G42).
    CutterCompensation,
    /// Tool length offset, on or off.
    ToolLength,
    /// Where canned cycles retract to.
    Retract,
    /// Work offset, as G54.
    WorkOffset,
    /// Exact stop or blending.
    Path,
    /// Constant surface speed or revolutions per minute.
    Speed,
    /// G92 set aside and taken up again.
    SetPosition,
    /// Anything else that rodete refuses by its name.
    Other,
}

/// How many groups there are.
pub const GROUPS: usize = Group::Other as usize + 1;

impl Group {
    /// The group's name.
    #[must_use]
    pub const fn name(self) -> Text {
        match self {
            Self::NonModal => t("códigos de un solo bloque", "codes for one block"),
            Self::Motion => t("movimiento", "motion"),
            Self::Plane => t("plano", "plane"),
            Self::Distance => t("cotas absolutas o incrementales", "distance mode"),
            Self::Centre => t("centros absolutos o incrementales", "arc centre mode"),
            Self::Feed => t("modo de avance", "feed mode"),
            Self::Units => t("unidades", "units"),
            Self::CutterCompensation => t("compensación de radio", "cutter radius compensation"),
            Self::ToolLength => t("compensación de longitud", "tool length offset"),
            Self::Retract => t("retirada de los ciclos fijos", "canned cycle return"),
            Self::WorkOffset => t("decalaje de origen", "work offset"),
            Self::Path => t("control de la trayectoria", "path control"),
            Self::Speed => t("modo del husillo", "spindle speed mode"),
            Self::SetPosition => t("estado de G92", "G92 state"),
            Self::Other => t("otros códigos", "other codes"),
        }
    }
}

/// A drilling cycle, by what it does at the bottom and on the way out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cycle {
    /// Peck drilling with chip breaking (G73).
    ChipBreak,
    /// Left-hand tapping with a floating chuck (G74).
    TapLeft,
    /// Drilling (G81).
    Drill,
    /// Drilling with dwell (G82).
    DrillDwell,
    /// Peck drilling (G83).
    Peck,
    /// Right-hand tapping with a floating chuck (G84).
    TapRight,
    /// Boring, out at feed (G85).
    Bore,
    /// Boring, dwell, spindle stop, out at rapid (G86).
    BoreStop,
    /// Back boring (G87).
    BackBore,
    /// Boring, dwell, spindle stop, out by hand (G88).
    BoreManual,
    /// Boring, dwell, out at feed (G89).
    BoreDwell,
}

impl Cycle {
    /// The number of its G code in LinuxCNC.
    #[must_use]
    pub const fn number(self) -> f64 {
        match self {
            Self::ChipBreak => 73.0,
            Self::TapLeft => 74.0,
            Self::Drill => 81.0,
            Self::DrillDwell => 82.0,
            Self::Peck => 83.0,
            Self::TapRight => 84.0,
            Self::Bore => 85.0,
            Self::BoreStop => 86.0,
            Self::BackBore => 87.0,
            Self::BoreManual => 88.0,
            Self::BoreDwell => 89.0,
        }
    }
}

/// A turning cycle that a block calls and that is over with the block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TurningCycle {
    /// Finishing along the contour (G70).
    Finish,
    /// Stock removal along Z (G71).
    Axial,
    /// Stock removal along X (G72).
    Radial,
    /// Stock removal along the contour (G73).
    Repeat,
    /// Grooving and drilling along Z, with chip breaking (G74).
    GrooveFace,
    /// Grooving along X, with chip breaking (G75).
    GrooveOutside,
    /// A thread in several passes (G76).
    Thread,
    /// One whose block is its own whole: its letters are all its parameters.
    ByLetters(LetterCycle),
}

/// A turning cycle of one block whose letters are all its own: F, S and M of the block are parameters too, and none is in force behind it
/// (Fagor 8055 T, G81 to G89).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LetterCycle {
    /// A straight section: turning (G81), facing (G82).
    Straight(Along),
    /// A curved section: turning (G84), facing (G85).
    Curved(Along),
    /// Drilling in the axis, and tapping (G83).
    Drilling,
    /// A thread in several passes: longitudinal (G86), face (G87).
    Thread(Along),
    /// Grooving: along X (G88), along Z (G89).
    Groove(Along),
}

impl LetterCycle {
    /// The number of its G code.
    #[must_use]
    pub const fn number(self) -> u8 {
        match self {
            Self::Straight(Along::Cylinder) => 81,
            Self::Straight(Along::Face) => 82,
            Self::Drilling => 83,
            Self::Curved(Along::Cylinder) => 84,
            Self::Curved(Along::Face) => 85,
            Self::Thread(Along::Cylinder) => 86,
            Self::Thread(Along::Face) => 87,
            Self::Groove(Along::Cylinder) => 88,
            Self::Groove(Along::Face) => 89,
        }
    }

    /// The letters that are its parameters, whether they are followed or not.
    pub const LETTERS: Letters = Letters::of("ABCDEFHIJKLMPQRSUVWXZ");

    /// The letters that it must have.
    #[must_use]
    pub const fn needed(self) -> Letters {
        match self {
            Self::Straight(_) | Self::Groove(_) => Letters::of("CQRXZ"),
            Self::Drilling => Letters::of("BIXZ"),
            Self::Curved(_) => Letters::of("CIKQRXZ"),
            Self::Thread(_) => Letters::of("BCDIQRXZ"),
        }
    }

    /// The letters that it may have beside them, of those that rodete follows.
    #[must_use]
    pub const fn optional(self) -> Letters {
        match self {
            Self::Straight(_) | Self::Curved(_) => Letters::of("DFHLM"),
            Self::Drilling => Letters::of("CDHKLR"),
            Self::Thread(_) => Letters::of("AEJL"),
            Self::Groove(_) => Letters::of("DK"),
        }
    }

    /// The letters of the feeds that it has of its own.
    #[must_use]
    pub const fn feeds(self) -> &'static [u8] {
        match self {
            Self::Straight(_) | Self::Curved(_) => b"FH",
            Self::Drilling | Self::Thread(_) | Self::Groove(_) => b"",
        }
    }
}

impl TurningCycle {
    /// The number of its G code.
    #[must_use]
    pub const fn number(self) -> u8 {
        match self {
            Self::Finish => 70,
            Self::Axial => 71,
            Self::Radial => 72,
            Self::Repeat => 73,
            Self::GrooveFace => 74,
            Self::GrooveOutside => 75,
            Self::Thread => 76,
            Self::ByLetters(cycle) => cycle.number(),
        }
    }

    /// The letters that it may have beside those that need no code.
    #[must_use]
    pub const fn letters(self) -> Letters {
        match self {
            Self::Finish => Letters::of("PQ"),
            Self::Axial | Self::Radial | Self::Repeat => Letters::of("PQRUW"),
            Self::GrooveFace | Self::GrooveOutside | Self::Thread => Letters::of("PQRUWXZ"),
            Self::ByLetters(_) => LetterCycle::LETTERS,
        }
    }

    /// The letters of its first block, the one without P, whose number is how many times: no length, wherever lengths are counted.
    #[must_use]
    pub const fn times(self) -> Letters {
        match self {
            Self::Repeat => Letters::of("R"),
            Self::Finish
            | Self::Axial
            | Self::Radial
            | Self::GrooveFace
            | Self::GrooveOutside
            | Self::Thread
            | Self::ByLetters(_) => Letters::of(""),
        }
    }
}

/// A turning cycle of one pass, which every block with X, Z or R repeats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SinglePassCycle {
    /// Along Z, or along a cone (G90).
    Axial,
    /// A pass of a thread, along Z or along a cone (G92).
    Thread,
    /// Along X, or along a cone (G94).
    Radial,
}

impl SinglePassCycle {
    /// The number of its G code.
    #[must_use]
    pub const fn number(self) -> u8 {
        match self {
            Self::Axial => 90,
            Self::Thread => 92,
            Self::Radial => 94,
        }
    }
}

/// The meaning of a G code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum G {
    /// Rapid move (G0).
    Rapid,
    /// Straight move at feed.
    Linear,
    /// Arc or helix; true for clockwise.
    Arc(bool),
    /// Dwell (G4).
    Dwell,
    /// Work offset or tool table by program (G10).
    SetOffsets,
    /// Plane of arcs and cycles.
    Plane(Plane),
    /// Lengths in inches (G20, G70).
    Inch,
    /// Lengths in millimetres (G21, G71).
    Millimetre,
    /// To a reference point: false G28, true G30.
    Reference(bool),
    /// Keep this position as a reference point: false G28.1, true G30.1.
    SetReference(bool),
    /// On which side of the path the tool's radius is kept (G40, G41, G42).
    Compensation(Compensation),
    /// G41.1 and G42.1: the same with the diameter of the cutter in D.
    CompensationGiven(Compensation),
    /// Tool length offset from the tool table.
    ToolLength,
    /// Tool length offset given in the block.
    ToolLengthGiven,
    /// Tool length offset added to the one in force.
    ToolLengthAdded,
    /// No tool length offset.
    ToolLengthOff,
    /// Local offset (G52).
    LocalOffset,
    /// This block in machine coordinates (G53).
    MachineCoordinates,
    /// Work offset 1 to 9 (G54 to G59.3).
    WorkOffset(u8),
    /// Path control without effect on the programmed path.
    PathControl,
    /// The same, with tolerances P and Q (G64).
    PathTolerance,
    /// Canned cycle for holes.
    Cycle(Cycle),
    /// Turning cycle of one call.
    Turning(TurningCycle),
    /// Turning cycle of one pass, repeated until another motion code.
    Pass(SinglePassCycle),
    /// A thread along a straight line; true where its lead changes (G32, G34).
    Thread(bool),
    /// No canned cycle, no motion.
    Cancel,
    /// Words are coordinates (G90).
    Absolute,
    /// Words are increments (G91).
    Incremental,
    /// Arc centres are coordinates (G90.1).
    CentreAbsolute,
    /// Arc centres from the start of the arc.
    CentreIncremental,
    /// This position gets these coordinates (G92).
    SetPosition,
    /// G92 off and its registers cleared (G92.1).
    ClearPosition,
    /// G92 off, its registers kept (G92.2).
    SuspendPosition,
    /// G92 on again (G92.3).
    RestorePosition,
    /// What F means.
    Feed(FeedMode),
    /// Cycles return to the height before the cycle (G98).
    ReturnInitial,
    /// Cycles return to R (G99).
    ReturnR,
    /// S is the cutting speed at the tool, m/min or feet a minute (G96).
    ConstantSurfaceSpeed,
    /// Revolutions per minute.
    Rpm,
    /// This position gets these coordinates or, with S alone, S is the greatest speed under constant surface speed.
    SetPositionOrSpeed,
    /// Known to the control and refused by name.
    Refused(Group, &'static Text),
    /// A cycle: known to the control and refused by name.
    RefusedCycle(&'static Text),
}

impl G {
    /// The modal group; a block may name one code of it.
    #[must_use]
    pub const fn group(self) -> Group {
        match self {
            Self::Rapid
            | Self::Linear
            | Self::Arc(_)
            | Self::Thread(_)
            | Self::Pass(_)
            | Self::Cycle(_)
            | Self::RefusedCycle(_)
            | Self::Cancel => Group::Motion,
            Self::Dwell
            | Self::SetOffsets
            | Self::Reference(_)
            | Self::SetReference(_)
            | Self::LocalOffset
            | Self::MachineCoordinates
            | Self::SetPosition
            | Self::SetPositionOrSpeed
            | Self::Turning(_) => Group::NonModal,
            Self::Plane(_) => Group::Plane,
            Self::Inch | Self::Millimetre => Group::Units,
            Self::Compensation(_) | Self::CompensationGiven(_) => Group::CutterCompensation,
            Self::ToolLength | Self::ToolLengthGiven | Self::ToolLengthAdded | Self::ToolLengthOff => Group::ToolLength,
            Self::WorkOffset(_) => Group::WorkOffset,
            Self::PathControl | Self::PathTolerance => Group::Path,
            Self::Absolute | Self::Incremental => Group::Distance,
            Self::CentreAbsolute | Self::CentreIncremental => Group::Centre,
            Self::ClearPosition | Self::SuspendPosition | Self::RestorePosition => Group::SetPosition,
            Self::Feed(_) => Group::Feed,
            Self::ReturnInitial | Self::ReturnR => Group::Retract,
            Self::ConstantSurfaceSpeed | Self::Rpm => Group::Speed,
            Self::Refused(group, _) => group,
        }
    }

    /// True of a cycle: it cuts more than its own block says, and a lathe that rejects it cuts none of that.
    #[must_use]
    pub const fn is_cycle(self) -> bool {
        matches!(self, Self::Cycle(_) | Self::Turning(_) | Self::Pass(_) | Self::RefusedCycle(_))
    }

    /// The turning cycle of the code to which all letters of its block belong; `None` of any other code.
    #[inline]
    #[must_use]
    pub const fn by_letters(self) -> Option<LetterCycle> {
        match self {
            Self::Turning(TurningCycle::ByLetters(cycle)) => Some(cycle),
            _ => None,
        }
    }

    /// True of a cycle that may wait at the bottom for a time that its block says.
    #[must_use]
    pub const fn waits(self) -> bool {
        matches!(
            self,
            Self::Cycle(Cycle::DrillDwell | Cycle::BoreStop | Cycle::BoreManual | Cycle::BoreDwell)
                | Self::Turning(TurningCycle::ByLetters(LetterCycle::Drilling | LetterCycle::Groove(_)))
        )
    }

    /// True where the code takes the block's axis words for itself, so that no motion may stand beside it.
    #[must_use]
    pub const fn takes_axes(self) -> bool {
        matches!(
            self,
            Self::SetOffsets
                | Self::Reference(_)
                | Self::LocalOffset
                | Self::SetPosition
                | Self::SetPositionOrSpeed
                | Self::Turning(_)
        )
    }
}

/// The meaning of an M code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum M {
    /// Stop until the operator goes on (M0, M1, M60).
    Pause,
    /// End of the program (M2, M30).
    End,
    /// Spindle on: true for clockwise (M3, M4).
    Spindle(bool),
    /// Spindle off (M5).
    SpindleOff,
    /// Spindle to an angle (M19).
    SpindleOrient,
    /// Tool change (M6).
    ToolChange,
    /// The loaded tool gets a number (M61).
    SetTool,
    /// Coolant: true for on (M7, M8), false for off (M9).
    Coolant(bool),
    /// Override switches (M48 to M53).
    Override,
    /// A digital output P, with the motion or at once (M62 to M65).
    Output,
    /// An input is read or waited for (M66).
    Input,
    /// An analog output E gets the value Q (M67, M68).
    AnalogOutput,
    /// The modal state is kept; true where the end of the call gives it back (M70, M73).
    SaveState(bool),
    /// What was kept is taken back (M71).
    ForgetState,
    /// What was kept is in force again (M72).
    RestoreState,
    /// Call of a subprogram (M98).
    Call,
    /// Call of a subprogram of the same program by the number of its first block (M97).
    CallBlock,
    /// Return from a subprogram (M99).
    Return,
    /// The machine's doors (M38, M39).
    Door,
    /// A code of the machine's builder or user: not run, and said so.
    User,
    /// Of no motion, known to the control: not run, and said by its name.
    NotFollowed(&'static Text),
    /// Known to the control and refused by name.
    Refused(&'static Text),
}

impl M {
    /// The group: of one group a block may name one code. User codes and what is refused stand alone.
    #[must_use]
    pub const fn group(self) -> u8 {
        match self {
            Self::Pause | Self::End | Self::Call | Self::CallBlock | Self::Return => 4,
            Self::ToolChange | Self::SetTool => 6,
            Self::Spindle(_)
            | Self::SpindleOff
            | Self::SpindleOrient
            | Self::SaveState(_)
            | Self::ForgetState
            | Self::RestoreState => 7,
            Self::Coolant(_) => 8,
            Self::Override => 9,
            Self::User | Self::NotFollowed(_) | Self::Door => 10,
            Self::Output | Self::Input | Self::AnalogOutput | Self::Refused(_) => 5,
        }
    }
}
