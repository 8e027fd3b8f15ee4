//! The alarms of a turning program: numbered, with cause, place and depth.

use super::stock::Fixture;
use crate::finding::clause::{AlarmAt, Deep};
use crate::finding::{AlarmFamily, Bare, Figures, Finding, Grade, Limit, Place, Raise, Size};
use crate::gcode::in_force::Compensation;
use crate::machine::axis::Axis;
use crate::number::shown;
use crate::text::{Text, t};

/// Up to this depth a contact is not a collision, mm.
pub const TOUCH: f64 = 0.001;

/// Up to this depth a retraction that scrapes metal is a caution, not a stop, mm.
///
/// # Derivation
/// An edge with a lead angle φ1 > 90° leans away from the shoulder at which it stops, and leaves a wedge of a tan(φ1 − 90°)
/// there at a depth of cut a: 0.44 mm at 95° and 5 mm. If the tool then retracts straight along the shoulder, by the program or
/// by a cycle with a fixed way out, its nose cuts that wedge, and a finishing allowance with it. It cuts metal in rapid, but it
/// does not crash. Anything deeper is not a remnant of its own edge, nor is anything larger in section than a wedge of this depth as
/// long as the insert's inscribed circle is wide: a tool that was plunged in and goes along the skin in rapid takes more.
pub const SCRAPE: f64 = 0.5;

/// What moves with the tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moving {
    /// What cuts, with its back.
    Cutter,
    /// What holds the cutter, up to the turret.
    Holder,
    /// The turret's body.
    Turret,
}

/// Why an alarm is raised. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cause {
    /// A rapid motion goes through metal.
    RapidInMetal,
    /// The same on the way to the intermediate point of a return to reference.
    IntermediateInMetal,
    /// The tool retracts in rapid and scrapes metal, no deeper than [`SCRAPE`].
    RetractionInMetal,
    /// A blade goes straight back in rapid and scrapes the wedge that its inclined side has left.
    BladeWedge,
    /// A non-cutting edge of the cutter runs into metal.
    BackInMetal,
    /// The holder or the turret runs into metal.
    BodyInMetal(Moving),
    /// A boring bar is fed into metal where there is no hole, or none wide enough for it.
    BoreWithoutHole {
        /// The diameter of the hole in front of it; 0 if there is none.
        hole: f64,
        /// The minimum that bar and edge need.
        least: f64,
    },
    /// A moving body runs into a fixed one.
    Collision(Moving, Fixture),
    /// The turret's reference point leaves the travel of an axis.
    Travel {
        /// The axis.
        axis: Axis,
        /// At the greatest end, else at the least.
        greatest: bool,
        /// The limit there, mm; of X as a diameter.
        limit: f64,
    },
    /// The cut is deeper than the cutting edge is long across the motion.
    DepthOfCut {
        /// How deep the cut is, across the motion.
        depth: f64,
        /// The length of the edge across the motion.
        edge: f64,
    },
    /// An edge other than the nose makes the surface: the far end of the auxiliary edge leaves its mark, or an edge cuts into a
    /// surface that a nose has made.
    BackCutting,
    /// A thread without a lead.
    NoLead,
    /// The lead is outside the insert's range.
    Lead {
        /// The lead programmed, mm a revolution.
        lead: f64,
        /// The minimum and the maximum of the insert, mm a revolution.
        leads: [f64; 2],
    },
    /// A pass of a thread with another lead than the passes before.
    LeadDiffers {
        /// The lead of this pass, mm a revolution.
        lead: f64,
        /// The lead of the earlier ones, mm a revolution.
        before: f64,
    },
    /// The tool that cuts a thread is not a threading tool.
    NoThreader,
    /// The spindle's speed is not the same in all passes of a thread.
    ThreadSpeed {
        /// The speed in this pass, rpm.
        speed: f64,
        /// Another in this pass, or that of an earlier one, rpm.
        before: f64,
    },
    /// A deeper pass of a thread does not begin in the groove of the passes before.
    OffGroove {
        /// How far along the thread it begins from there, mm.
        off: f64,
        /// What an infeed along a flank of the insert would come to, mm.
        most: f64,
    },
    /// A constant surface speed without a speed limit asks for more than the spindle's maximum.
    NoGreatestSpeed {
        /// The speed asked for, rpm; infinite on the axis.
        asked: f64,
        /// The machine's greatest, rpm.
        most: f64,
    },
    /// S is above the spindle's maximum.
    TooFast {
        /// The speed asked for, rpm.
        asked: f64,
        /// The machine's greatest, rpm.
        most: f64,
    },
    /// The spindle is stopped while the tool is fed into metal.
    SpindleStopped,
    /// A feed per revolution while the spindle is stopped: the slide does not move.
    FeedStands,
    /// The spindle turns the wrong way for the tool.
    SpindleWrongWay,
    /// A drill works at a constant surface speed.
    DrillAtSurfaceSpeed,
    /// The coolant is off while the tool cuts.
    NoCoolant,
    /// A motion at feed with F 0: the slide does not move.
    NoFeed,
    /// An implausible feed in the cut, in mm per revolution: F is probably meant in the other unit, mm/min or mm per revolution.
    ImplausibleFeed {
        /// What the tool is fed with each revolution, mm.
        feed: f64,
        /// The plausible range, mm.
        limits: [f64; 2],
    },
    /// The turret has no tool in this place.
    UnknownTool(u32),
    /// The offset in force is not the tool's own; 0: there is none.
    OtherOffset {
        /// The number in force.
        offset: u32,
        /// The tool's own.
        own: u32,
    },
    /// A drill works beside the axis.
    OffAxis,
    /// The turret turns to this place over the stock, or where one of its tools has no room.
    ToolChange(u32),
    /// G41 or G42 keeps the nose on the side to which the tip points, in the part.
    NoseInTheWork(Compensation),
    /// The feed is too large for the nose and leaves ridges.
    CoarseFeed {
        /// What the tool is fed with each revolution, mm.
        feed: f64,
        /// The maximum for the nose, mm.
        most: f64,
    },
    /// A thread is deeper than its lead has room for: its crests are gone.
    ThreadTooDeep {
        /// How deep, mm.
        depth: f64,
        /// The greatest depth for its lead, mm.
        most: f64,
    },
    /// A pass of a thread goes deeper at once than its insert is made for.
    ThreadPassTooDeep {
        /// How much deeper than the passes before, mm.
        depth: f64,
        /// The greatest depth of one pass, mm.
        most: f64,
    },
    /// A thread begins in metal before the slide has come up to its speed.
    ShortRunIn {
        /// How far it runs in.
        length: f64,
        /// What it needs.
        least: f64,
    },
    /// A piece is cut off, mm³.
    PartedOff(f64),
}

/// An alarm, as the control would raise it at this motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Alarm {
    /// Why it is raised, with what was measured.
    pub cause: Cause,
    /// The number of the motion in the simulation, from 0.
    pub motion: usize,
    /// The number of the subprogram's file; 0 for the program.
    pub file: usize,
    /// The line of that file, from 1.
    pub line: usize,
    /// The block number.
    pub n: Option<u32>,
    /// Where, in program coordinates: X as a diameter, and Z; mm.
    pub place: [f64; 2],
    /// Depth, mm, if it has one: into metal, into a fixture, past the travel.
    pub depth: Option<f64>,
}

impl Cause {
    /// What distinguishes one alarm from another: its number, and of a travel its axis and its end.
    #[must_use]
    pub fn key(self) -> (u16, Option<(u8, bool)>) {
        let end = if let Self::Travel { axis, greatest, .. } = self { Some((axis as u8, greatest)) } else { None };
        (self.number(), end)
    }

    /// The alarm's number.
    #[must_use]
    pub fn number(self) -> u16 {
        self.row().rule().alarm_of(AlarmFamily::Lathe).unwrap_or_default()
    }

    /// True if it depends on the tool's position: another tool's offset may be its cause.
    #[must_use]
    pub const fn hangs_on_offset(self) -> bool {
        matches!(
            self,
            Self::RapidInMetal
                | Self::IntermediateInMetal
                | Self::RetractionInMetal
                | Self::BladeWedge
                | Self::BackInMetal
                | Self::BodyInMetal(_)
                | Self::BoreWithoutHole { .. }
                | Self::Collision(..)
                | Self::Travel { .. }
                | Self::DepthOfCut { .. }
                | Self::BackCutting
                | Self::ThreadTooDeep { .. }
                | Self::ThreadPassTooDeep { .. }
                | Self::ShortRunIn { .. }
                | Self::OffAxis
                | Self::SpindleWrongWay
        )
    }

    /// Its grade. Another tool's offset is a caution, or as grave as the alarms that follow from it.
    #[must_use]
    pub fn grade(self) -> Grade {
        if matches!(self, Self::OtherOffset { .. }) { Grade::Caution } else { self.row().rule().grade }
    }

    /// The row of the finding that says it, with its values.
    #[must_use]
    pub fn row(self) -> Box<dyn Raise> {
        use crate::removal::turning::rules as row;
        match self {
            Self::RapidInMetal => Box::new(row::RapidInMetal {}),
            Self::IntermediateInMetal => Box::new(row::IntermediateInMetal {}),
            Self::RetractionInMetal => Box::new(row::RetractionInMetal {}),
            Self::BladeWedge => Box::new(row::BladeWedge {}),
            Self::BackInMetal => Box::new(row::BackInMetal {}),
            Self::BodyInMetal(Moving::Turret) => Box::new(row::TurretInMetal {}),
            Self::BodyInMetal(Moving::Cutter | Moving::Holder) => Box::new(row::HolderInMetal {}),
            Self::BoreWithoutHole { hole, least } if hole > TOUCH => {
                Box::new(row::BoreInNarrowHole { hole: Size::mm(hole), least: Size::mm(least) })
            }
            Self::BoreWithoutHole { least, .. } => Box::new(row::BoreInSolid { least: Size::mm(least) }),
            Self::Collision(Moving::Cutter, Fixture::Chuck) => Box::new(row::CutterHitsChuck {}),
            Self::Collision(Moving::Cutter, Fixture::Jaws) => Box::new(row::CutterHitsJaws {}),
            Self::Collision(Moving::Cutter, Fixture::Tailstock) => Box::new(row::CutterHitsTailstock {}),
            Self::Collision(Moving::Holder, Fixture::Chuck) => Box::new(row::HolderHitsChuck {}),
            Self::Collision(Moving::Holder, Fixture::Jaws) => Box::new(row::HolderHitsJaws {}),
            Self::Collision(Moving::Holder, Fixture::Tailstock) => Box::new(row::HolderHitsTailstock {}),
            Self::Collision(Moving::Turret, Fixture::Chuck) => Box::new(row::TurretHitsChuck {}),
            Self::Collision(Moving::Turret, Fixture::Jaws) => Box::new(row::TurretHitsJaws {}),
            Self::Collision(Moving::Turret, Fixture::Tailstock) => Box::new(row::TurretHitsTailstock {}),
            Self::Travel { axis, greatest, limit } => {
                // Its limits are diameters, every depth is one of a radius.
                let on = if axis == Axis::X {
                    t("; el exceso va en radio", "; the excess is given on the radius")
                } else {
                    t("", "")
                };
                let end = format!("{}_{}", axis.letter(), if greatest { "max" } else { "min" });
                Box::new(row::AxisLeavesTravel { axis: axis.letter(), end, limit: Size::mm(limit), on })
            }
            Self::DepthOfCut { depth, edge } => {
                Box::new(row::DepthOfCut { depth: Size::mm(depth), edge: Size::mm(edge) })
            }
            Self::BackCutting => Box::new(row::BackCutting {}),
            Self::NoLead => Box::new(row::NoLead {}),
            Self::Lead { lead, leads: [least, most] } => {
                Box::new(row::LeadNotOfInsert { lead: Size::mm(lead), least: Size::mm(least), most: Size::mm(most) })
            }
            Self::LeadDiffers { lead, before } => {
                Box::new(row::LeadDiffers { lead: Size::mm(lead), before: Size::mm(before) })
            }
            Self::NoThreader => Box::new(row::NoThreader {}),
            Self::ThreadSpeed { speed, before } => {
                Box::new(row::ThreadSpeed { speed: Size::rpm(speed), before: Size::rpm(before) })
            }
            Self::OffGroove { off, most } => Box::new(row::OffGroove { off: Size::mm(off), most: Size::mm(most) }),
            Self::ThreadTooDeep { depth, most } => {
                Box::new(row::ThreadTooDeep { depth: Size::mm(depth), most: Size::mm(most) })
            }
            Self::ThreadPassTooDeep { depth, most } => {
                Box::new(row::ThreadPassTooDeep { depth: Size::mm(depth), most: Size::mm(most) })
            }
            Self::ShortRunIn { length, least } => {
                Box::new(row::ShortRunIn { length: Size::mm(length), least: Size::mm(least) })
            }
            Self::NoGreatestSpeed { asked, most } => {
                Box::new(row::NoGreatestSpeed { asked: Size::rpm(asked), most: Size::rpm(most) })
            }
            Self::TooFast { asked, most } => Box::new(row::TooFast { asked: Size::rpm(asked), most: Size::rpm(most) }),
            Self::SpindleStopped => Box::new(row::SpindleStopped {}),
            Self::SpindleWrongWay => Box::new(row::SpindleWrongWay {}),
            Self::FeedStands => Box::new(row::FeedStands {}),
            Self::DrillAtSurfaceSpeed => Box::new(row::DrillAtSurfaceSpeed {}),
            Self::NoCoolant => Box::new(row::NoCoolant {}),
            Self::NoFeed => Box::new(row::NoFeed {}),
            Self::ImplausibleFeed { feed, limits: [least, most] } => {
                Box::new(row::ImplausibleFeed { feed: Size::mm(feed), least: Size::mm(least), most: Size::mm(most) })
            }
            Self::CoarseFeed { feed, most } => Box::new(row::CoarseFeed { feed: Size::mm(feed), most: Size::mm(most) }),
            Self::UnknownTool(place) => Box::new(row::UnknownTool { place }),
            Self::OffAxis => Box::new(row::OffAxis {}),
            Self::OtherOffset { offset: 0, own } => Box::new(row::NoOffset { offset: 0, own }),
            Self::OtherOffset { offset, own } => Box::new(row::OtherOffset { offset, own }),
            Self::ToolChange(place) => Box::new(row::ToolChange { place }),
            Self::NoseInTheWork(Compensation::Left) => Box::new(row::NoseInTheWorkLeft {}),
            Self::NoseInTheWork(_) => Box::new(row::NoseInTheWorkRight {}),
            Self::PartedOff(volume) => Box::new(row::PartedOff { volume: Size::mm3(volume) }),
        }
    }

    /// What happens, as a sentence without a full stop.
    #[must_use]
    pub fn text(self) -> Text {
        self.row().what()
    }

    /// What to do about it.
    #[must_use]
    pub fn remedy(self) -> Text {
        self.row().remedy()
    }
}

impl Alarm {
    /// The alarm as a finding at a line of the program's file.
    #[must_use]
    pub fn finding(&self) -> Finding {
        let [X, Z] = self.place.map(|at| Bare::mm(at, 3));
        let row = self.cause.row().at(Place::Line { line: self.line, columns: Vec::new() });
        let mut finding = row.graded(self.cause.grade()).with_clause(&AlarmAt { X, Z });
        if let Some(deep) = self.depth {
            finding = finding.with_clause(&Deep { deep: Size::mm(deep) });
        }
        let mm = |value: f64| format!("{} mm", shown(value, 3));
        let rpm = |value: f64| if value.is_finite() { format!("{} rpm", shown(value, 0)) } else { "∞".to_owned() };
        let (value, limit) = match self.cause {
            Cause::DepthOfCut { depth, edge } => (mm(depth), mm(edge)),
            Cause::Travel { axis, greatest, limit } => {
                let sign = if greatest { '≤' } else { '≥' };
                (self.depth.map(mm).unwrap_or_default(), format!("{} {sign} {}", axis.letter(), mm(limit)))
            }
            Cause::BoreWithoutHole { hole, least } => (format!("Ø {}", mm(hole)), format!("≥ Ø {}", mm(least))),
            Cause::OtherOffset { offset, own } => (format!("D{offset}"), format!("D{own}")),
            Cause::ThreadTooDeep { depth, most } | Cause::ThreadPassTooDeep { depth, most } => {
                (mm(depth), format!("≤ {}", mm(most)))
            }
            Cause::ShortRunIn { length, least } => (mm(length), format!("≥ {}", mm(least))),
            Cause::OffGroove { off, most } => (mm(off), format!("≤ {}", mm(most))),
            Cause::CoarseFeed { feed, most } => (mm(feed), format!("≤ {}", mm(most))),
            Cause::Lead { lead, leads: [low, high] } => (mm(lead), format!("{} – {}", shown(low, 3), mm(high))),
            Cause::LeadDiffers { lead, before } => (mm(lead), mm(before)),
            Cause::ThreadSpeed { speed, before } => (rpm(speed), rpm(before)),
            Cause::ImplausibleFeed { feed, limits: [low, high] } => {
                (format!("{} mm", shown(feed, 6)), format!("{} – {}", shown(low, 3), mm(high)))
            }
            Cause::NoGreatestSpeed { asked, most } | Cause::TooFast { asked, most } => (rpm(asked), rpm(most)),
            Cause::PartedOff(volume) => (format!("{} mm³", shown(volume, 1)), String::new()),
            _ => (self.depth.map(mm).unwrap_or_default(), String::new()),
        };
        finding.with(value, limit).comparing(self.figures())
    }

    /// The numbers of its value and its limit. How far an axis leaves its travel is not held against the end of it.
    fn figures(&self) -> Figures {
        let between = |[least, most]: [f64; 2]| Limit::Between { least: Some(least), most: Some(most) };
        let (value, limit) = match self.cause {
            Cause::DepthOfCut { depth, edge } => (depth, Limit::AtMost(edge)),
            Cause::BoreWithoutHole { hole, least } => (hole, Limit::AtLeast(least)),
            Cause::ThreadTooDeep { depth, most } | Cause::ThreadPassTooDeep { depth, most } => {
                (depth, Limit::AtMost(most))
            }
            Cause::ShortRunIn { length, least } => (length, Limit::AtLeast(least)),
            Cause::OffGroove { off, most } => (off, Limit::AtMost(most)),
            Cause::CoarseFeed { feed, most } => (feed, Limit::AtMost(most)),
            Cause::Lead { lead, leads } => (lead, between(leads)),
            Cause::LeadDiffers { lead, before } => (lead, Limit::Exactly(before)),
            Cause::ThreadSpeed { speed, before } => (speed, Limit::Exactly(before)),
            Cause::ImplausibleFeed { feed, limits } => (feed, between(limits)),
            Cause::NoGreatestSpeed { asked, most } | Cause::TooFast { asked, most } => (asked, Limit::AtMost(most)),
            Cause::PartedOff(volume) => return Figures::of(volume, None),
            _ => return Figures { found: self.depth.map(|deep| [deep; 2]), limit: None },
        };
        Figures::of(value, Some(limit))
    }
}
