//! What is refused or remarked of turning programs: cycles, threads, corners, the nose, the turret.
//!
//! # References
//! Fanuc Series 0i/30i, list of alarms (CNC): PS0051 to PS0055, PS0061 to PS0066, PS0313 to PS0329. The texts are rodete's own.

pub mod contour;
pub mod corner;
pub mod cycles;
pub mod fagor;
pub mod holes;
pub mod lathe;
pub mod nose;

pub use self::contour::{
    BlocksBeforeContour, ContourBegins, ContourBlockNotNamed, ContourDwellAndMotion, ContourEndsBeforeItBegins,
    ContourEndsWithCorner, ContourStandsStill, ContourTooLong, ContourToolChange, ContourWithoutEnd,
    ContourWordsPassedOver, NoBlockNumber, NotInContour,
};
pub use self::corner::{
    CornerBeforeNoMotion, CornerBeforeOtherMotion, CornerInContour, CornerLineWithoutLength, CornerNotSquare,
    CornerRunsBack, CornerSignAgainstLine, CornerTooLong, CornerTwice, CornerWithoutLine,
};
pub use self::cycles::{
    AllowanceIntoMetal, AllowanceIntoWall, ContourBackAlongX, ContourBackAlongZ, ContourBeginsWithArc,
    ContourBeyondStart, ContourDoesNotAdvance, ContourEntersAside, ContourNotFound, CycleNotFinite, FirstBlockMissing,
    FirstBlockUnused, FirstBlockWordMissing, GrooveReliefNegative, GrooveStepNegative, GrooveStepZero,
    GrooveWithoutDepth, NoDepthOfCut, PlungesApart, RepeatIntoMetal, RepeatPassesNotWhole, RepeatWithoutPasses,
    RetractionNegative, ThreadAllowance, ThreadAngle, ThreadDigits, ThreadFirstBlockDigits, ThreadInOnePass,
    ThreadLeadNotPositive, ThreadLeastCut, ThreadStartsInside, ThreadTooShort, ThreadWithoutHeight, ThreadWordMissing,
    TooManyGrooveSteps, TooManyRepeats, TooManyRoughingPasses, TooManyThreadPasses,
};
pub use self::fagor::{
    FagorArcHalf, FagorArcRadii, FagorArcTurnsBack, FagorDrillFactor, FagorDrillNegative, FagorGrooveNegative,
    FagorGroovePoint, FagorGrooveStepMissing, FagorGrooveWithoutDepth, FagorHoleWithoutDepth, FagorLetterMissing,
    FagorLetterNotSupported, FagorNegative, FagorStartInside, FagorStepNotPositive, FagorTapping, FagorTaps,
    FagorThreadExit, FagorThreadLastPass, FagorThreadTooShort, FagorThreadWithoutDepth, FagorThreadWithoutLead,
    TooManyFagorDrillSteps, TooManyFagorPasses, TooManyFagorThreadPasses,
};
pub use self::holes::{
    BareG90, CycleMovesOtherAxis, CycleRepeats, CycleSpindle, CycleUnderInverseTime, CycleWordMissing,
    HoleDwellNegative, HolePlaneBelowBottom, HolePlaneNotSaid, LeadChangeMissing, LeadMissing, LeadRunsOut, LeadZero,
    MillHolePlaneBelowBottom, MillPeckNotPositive, PassBeginsBeyondStart, PassEndMissing, PeckNotPositive,
    PeckWithoutDepth, ReturnHeightNotSaid, SpeedLimitWithPass, StartAngle, StartAngleForgotten, TakenOutByHand,
    TappingOutsideG17, TooManyLathePecks, TooManyPecks,
};
pub use self::lathe::{
    AddedLength, AxisNotFollowed, AxisNotOfLathe, BeyondAxis, ChangeWithoutTool, EndlessLoop, G91InSystemA,
    IncrementNotFollowed, IncrementNotOfLathe, LengthWithoutAxes, MachineMoveByIncrements, NoOrientation, NoToolNumber,
    NoToolTable, NoTurretPlace, NoWordOfToolTable, OffsetAlone, OffsetMeasuredAtMachine, OffsetNotInTable,
    ReferencePointNotKnown, ReferencePointNotSupported, ReferenceWithoutAxes, RefusedInLoop, SecondPointNotKnown,
    SetToolWithoutQ, StaleFeed, SystemShifted, TooManyCycleMotions, ToolNotInTable, ToolNotInTurret,
    ToolOffsetWithoutValues, ToolTableNotKnown, ToolTwiceInTable, TwoWordsAnAxis,
};
pub use self::nose::{
    ArcOfOtherPlane, CompensationBeginsOnArc, CompensationEndsOnArc, CompensationPlane, CompensationWithoutOffset,
    MachineMoveCancelsNose, MotionNotSeen, NoseChanges, NoseCutsContour, NoseInArc, NoseInCorner, NoseInShortPiece,
    NoseNotInTable, NoseTaken, NoseWithoutTable, PassTip, PassesNeverCompensated, PassesNotCompensated, SharpNose,
    ThreadUnderCompensation, TooManyStillBlocks,
};
