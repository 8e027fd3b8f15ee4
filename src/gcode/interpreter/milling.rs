//! Cutter radius compensation between the plan of a block and the motions that are handed out: LinuxCNC's, in G17.
//!
//! # What is compensated
//! G0 to G3 under G41, G42, G41.1 and G42.1, by the [stage](crate::gcode::cutter) in program coordinates: what could change them is
//! refused under compensation, as LinuxCNC refuses it.
//!
//! # Refusals
//! Beside what LinuxCNC refuses: G18, another unit, rotary axes and stops of the program (M0, M1) under compensation. After a
//! [`Misfit`](crate::gcode::cutter::Misfit) motions are those of the program until G40.

use crate::finding::{Raise, Size};
use crate::gcode::code::{G, Group, M};
use crate::gcode::cutter::{Misfit, OffsetPiece, Stage, Step};
use crate::gcode::in_force::Compensation;
use crate::gcode::interpreter::block::letter;
use crate::gcode::interpreter::out::NumberedMotion;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::interpreter::{Reader, State};
use crate::gcode::motion::{Arc, Feed, FeedMode, Motion, MotionKind, Plane};
use crate::gcode::rules::geometry::{
    ArcBehindCompensation, BesideCompensation, CompensationDiameterUnknown, CompensationHeld, CompensationOfNoTool,
    CompensationOfNothing, CompensationOfTurningTool, CompensationTwice, CompensationWithL, CompensationWithoutD,
    CutterInArc, CutterInCorner, CutterInShortPiece, CutterPlane, EntryArc, EntryTooShort, PositionUnderCompensation,
    RotaryUnderCompensation,
};
use crate::gcode::turning::nose::{Element, Path, Point};
use crate::limits::HELD_PIECES;
use crate::machine::axis::{Axis, Pose};
use crate::machine::length_unit::LengthUnit;
use crate::number::trig;

/// The compensation of a milling program.
#[derive(Default)]
pub(super) struct Milling {
    stage: Option<Stage<NumberedMotion>>,
    /// Where G40 has left the centre of the cutter, aside of where the program stands; machine coordinates.
    left: Option<Pose>,
    /// No G0 or G1 has come since then: LinuxCNC makes no arc before.
    straight_due: bool,
}

impl Milling {
    /// Motions pass as they are programmed.
    pub(super) const fn idle(&self) -> bool {
        self.stage.is_none() && self.left.is_none()
    }

    /// A G0 or G1 without axis words counts as a motion: as the entry of the compensation, or as the way back from it.
    pub(super) fn takes_bare_lines(&self) -> bool {
        self.left.is_some() || self.stage.as_ref().is_some_and(|stage| stage.aside().is_none())
    }

    /// Where the centre of the cutter is where the program has come to its end.
    pub(super) fn cutter(&self, state: &State) -> Pose {
        let mut tip = state.at;
        if let Some(machine) = self.left {
            place(&mut tip, point(&state.frame.to_program(&machine)));
        }
        tip
    }
}

fn point(pose: &Pose) -> Point {
    [pose.get(Axis::X), pose.get(Axis::Y)]
}

fn place(pose: &mut Pose, [x, y]: Point) {
    pose.set(Axis::X, x);
    pose.set(Axis::Y, y);
}

impl Reader<'_, '_> {
    /// G40 to G42.1 of a milling program.
    pub(super) fn cutter_compensation(&mut self, code: G) -> Result<()> {
        let (side, given) = match code {
            G::CompensationGiven(side) => (side, true),
            G::Compensation(side) => (side, false),
            _ => return Ok(()),
        };
        if side == Compensation::Off {
            self.end_cutter();
            return Ok(());
        }
        let column = self.block.g_column(Group::CutterCompensation);
        if self.state.modal.compensation != Compensation::Off {
            return Err(Refused::of(&CompensationTwice {}, &[column]));
        }
        if self.state.modal.plane != Plane::XY {
            let name = self.state.modal.plane.name();
            return Err(Refused::of(&CutterPlane { plane: name }, &[column]));
        }
        if self.block.has(letter::L) {
            return Err(Refused::of(&CompensationWithL {}, &[column]));
        }
        let diameter = match (given, self.block.get(letter::D)) {
            (true, Some(D)) => self.state.modal.unit.to_mm(D),
            (true, None) => {
                return Err(Refused::of(&CompensationWithoutD {}, &[column]));
            }
            (false, D) => self.cutter_diameter(D)?,
        };
        // A negative diameter is on the other side.
        let left = (side == Compensation::Left) == (diameter >= 0.0);
        self.state.modal.compensation = side;
        if diameter == 0.0 {
            let spot = self.block.spot;
            self.memory.remarks.row(&CompensationOfNothing {}, spot, Some(column));
        } else {
            self.memory.out.milling.stage = Some(Stage::new(left, diameter.abs() / 2.0, self.state.modal.unit));
        }
        Ok(())
    }

    /// The diameter that the tool table gives for D, or for the tool in the spindle; mm.
    fn cutter_diameter(&mut self, D: Option<f64>) -> Result<f64> {
        let number = match D {
            Some(D) => self.tool_number(letter::D, D)?,
            None => 0,
        };
        let number = if number == 0 { self.state.modal.tool } else { number };
        let column = self.block.g_column(Group::CutterCompensation);
        match self.memory.tools.get(&number) {
            Some(tool) if tool.nose.is_some_and(|nose| nose.tip.number() != 9) => {
                Err(Refused::of(&CompensationOfTurningTool { tool: number }, &[column]))
            }
            Some(tool) => Ok(tool.diameter),
            None if number == 0 => Err(Refused::of(&CompensationOfNoTool {}, &[column])),
            None => Err(Refused::of(&CompensationDiameterUnknown { tool: number }, &[column])),
        }
    }

    /// Refuses what LinuxCNC does not do under compensation, beside what rodete does not. Plane and M codes of a block come
    /// before its G40 to G42, all else behind.
    pub(super) fn beside_cutter(&self, motion: Option<G>) -> Result<()> {
        const BEHIND: [Group; 5] =
            [Group::WorkOffset, Group::ToolLength, Group::Path, Group::Retract, Group::SetPosition];
        let block = &self.block;
        let before = self.state.modal.compensation != Compensation::Off;
        let behind = match block.g(Group::CutterCompensation) {
            Some(G::Compensation(side) | G::CompensationGiven(side)) => side != Compensation::Off,
            _ => before,
        };
        let plane = matches!(block.g(Group::Plane), Some(G::Plane(plane)) if plane != self.state.modal.plane);
        let at_once = block.g(Group::NonModal).is_some_and(|code| code != G::Dwell);
        let cycle = matches!(motion, Some(G::Cycle(_)));
        let machine = |group: &u8| match block.m(*group) {
            Some((M::End | M::Call | M::Return | M::Spindle(_) | M::SpindleOff | M::SpindleOrient, _))
            | Some((M::Coolant(_) | M::User | M::NotFollowed(_), _))
            | None => false,
            Some(_) => before,
        };
        let inch = self.state.modal.unit == LengthUnit::Inch;
        let unit = block.g(Group::Units).is_some_and(|code| (code == G::Inch) != inch);
        let others = [
            (Group::Plane, before && plane),
            // LinuxCNC makes the piece held back in the wrong unit then.
            (Group::Units, before && unit),
            (Group::NonModal, behind && at_once),
            (Group::Motion, behind && cycle),
        ];
        let mut groups = BEHIND.into_iter().map(|group| (group, behind && block.g(group).is_some())).chain(others);
        let column = match groups.find(|(_, found)| *found) {
            Some((group, _)) => block.g_column(group),
            None => match (4..=10).find(machine) {
                Some(group) => block.m_column(group),
                None => return Ok(()),
            },
        };
        Err(Refused::of(&BesideCompensation {}, &[column]))
    }

    /// Refuses the position where the cutter is aside of it, as LinuxCNC does.
    pub(super) fn position_is_known(&self, column: usize) -> Result<()> {
        if !self.memory.control.radius.cutter() || self.state.modal.compensation == Compensation::Off {
            return Ok(());
        }
        Err(Refused::of(&PositionUnderCompensation {}, &[column]))
    }

    /// The compensation is over: what is held back is made, and the cutter stays aside of the program.
    pub(super) fn end_cutter(&mut self) {
        self.state.modal.compensation = Compensation::Off;
        let Some(mut stage) = self.memory.out.milling.stage.take() else { return };
        let mut out = Vec::new();
        let result = stage.finish(&mut out);
        self.hand_placed(out);
        match result {
            Ok(Some(end)) => {
                let mut tip = self.state.at;
                place(&mut tip, end);
                self.memory.out.milling.left = Some(self.state.frame.to_machine(&tip));
                self.memory.out.milling.straight_due = true;
            }
            Ok(None) => {}
            Err(misfit) => self.refuse_cutter(&misfit, self.block.spot.line),
        }
    }

    /// Looks at a motion code of the program: what follows G40 is straight, whatever a cycle or a reference point does between.
    pub(super) fn straight_behind_cutter(&mut self, motion: G) {
        if matches!(motion, G::Rapid | G::Linear | G::Arc(_))
            && std::mem::take(&mut self.memory.out.milling.straight_due)
            && matches!(motion, G::Arc(_))
        {
            self.refuse_here(self.block.spot.line, &ArcBehindCompensation {});
        }
    }

    /// Hands a motion out by way of the compensation.
    pub(super) fn mill(&mut self, motion: Motion) {
        let (control, number) = (self.state.modal.in_force(), self.made());
        let carried = NumberedMotion { motion, control, number };
        let dwell = matches!(motion.kind, MotionKind::Dwell(_));
        let Some(mut stage) = self.memory.out.milling.stage.take() else { return self.lead_back(carried) };
        if dwell && stage.aside().is_none() {
            self.memory.out.milling.stage = Some(stage);
            return self.lead_back(carried);
        }
        let by = motion.to.differences(&motion.from);
        let path = match motion.kind {
            MotionKind::Dwell(_) => Path::Still,
            MotionKind::Arc(Arc { centre, sweep, .. }, _) => Path::Arc { centre, sweep },
            _ => Path::Line,
        };
        let element = Element { from: point(&motion.from), to: point(&motion.to), path };
        let mut out = Vec::new();
        let result = if Axis::ALL.into_iter().skip(3).any(|axis| by[axis as usize] != 0.0) {
            Err(None)
        } else {
            stage
                .push(Step { element, rapid: motion.kind == MotionKind::Rapid, tag: carried.clone() }, &mut out)
                .map_err(Some)
        };
        self.hand_placed(out);
        // Where G40 has left the cutter aside, the entry leads from there; its way is that of the programmed one.
        let left = self.memory.out.milling.left.take().map(|machine| point(&self.state.frame.to_program(&machine)));
        match result {
            Ok(()) => {
                left.into_iter().for_each(|point| stage.enter_from(point));
                self.memory.out.milling.stage = Some(stage);
            }
            Err(misfit) => {
                match misfit {
                    Some(misfit) => self.refuse_cutter(&misfit, motion.line),
                    None => self.refuse_here(motion.line, &RotaryUnderCompensation {}),
                }
                self.memory.out.queue.push_back(Ok((motion, control, number)));
            }
        }
    }

    /// A motion without compensation: the first behind G40 leads from where the cutter is.
    fn lead_back(&mut self, carried: NumberedMotion) {
        let NumberedMotion { mut motion, control, number } = carried;
        if let Some(machine) = self.memory.out.milling.left {
            let tip = point(&self.state.frame.to_program(&machine));
            match motion.kind {
                MotionKind::Dwell(_) => {
                    place(&mut motion.from, tip);
                    place(&mut motion.to, tip);
                    motion.machine = self.state.frame.to_machine(&motion.to);
                }
                MotionKind::Arc(..) => self.memory.out.milling.left = None,
                _ => {
                    self.memory.out.milling.left = None;
                    let programmed = motion;
                    place(&mut motion.from, tip);
                    self.take_time(&mut motion, &programmed);
                }
            }
        }
        self.memory.out.queue.push_back(Ok((motion, control, number)));
    }

    fn hand_placed(&mut self, placed: Vec<OffsetPiece<NumberedMotion>>) {
        for OffsetPiece { element, corner, tag: NumberedMotion { motion: programmed, control, number } } in placed {
            let mut motion = programmed;
            if corner {
                motion.to = motion.from;
            }
            place(&mut motion.from, element.from);
            place(&mut motion.to, element.to);
            motion.machine = self.state.frame.to_machine(&motion.to);
            motion.kind = match (programmed.kind, element.path) {
                (MotionKind::Arc(arc, feed), Path::Arc { centre, sweep }) if !corner => {
                    MotionKind::Arc(turned(&arc, element, centre, sweep), feed)
                }
                (MotionKind::Arc(_, feed) | MotionKind::Feed(feed), Path::Arc { centre, sweep }) => {
                    let turns = if sweep < 0.0 { -1 } else { 1 };
                    let rotation = self.state.frame.work.rotation;
                    let arc = Arc { plane: Plane::XY, centre, turns, radius: 0.0, sweep, rotation };
                    MotionKind::Arc(turned(&arc, element, centre, sweep), feed)
                }
                (kind, _) => kind,
            };
            if element.path != Path::Still {
                self.take_time(&mut motion, &programmed);
            }
            self.memory.out.queue.push_back(Ok((motion, control, number)));
        }
    }

    /// The time of a motion at the rate of the programmed one, whose length is another.
    fn take_time(&self, motion: &mut Motion, programmed: &Motion) {
        let (was, made) = (length(programmed), length(motion));
        motion.seconds = match programmed.kind {
            _ if was > 0.0 => programmed.seconds.map(|seconds| seconds * made / was),
            MotionKind::Feed(feed) => self.seconds(made, feed),
            _ => programmed.seconds,
        };
        if let (MotionKind::Feed(feed) | MotionKind::Arc(_, feed), Some(seconds)) = (&mut motion.kind, motion.seconds)
            && feed.mode == FeedMode::InverseTime
        {
            *feed = Feed { value: 60.0 / seconds, ..*feed };
        }
    }

    fn refuse_here(&mut self, line: usize, row: &dyn Raise) {
        let mut fault = Refused::of(row, &[]);
        (fault.line, fault.file) = (line, self.memory.library.file(self.block.spot.text).cloned());
        self.memory.out.queue.push_back(Err(fault));
    }

    fn refuse_cutter(&mut self, misfit: &Misfit, line: usize) {
        match *misfit {
            Misfit::Entry { length, radius } => {
                self.refuse_here(line, &EntryTooShort { length: Size::mm(length), radius: Size::mm(radius) })
            }
            Misfit::EntryArc => self.refuse_here(line, &EntryArc {}),
            Misfit::Arc { radius, arc } => {
                self.refuse_here(line, &CutterInArc { radius: Size::length(radius, 4), arc: Size::length(arc, 4) })
            }
            Misfit::Corner { radius } => self.refuse_here(line, &CutterInCorner { radius: Size::length(radius, 4) }),
            Misfit::Still => self.refuse_here(line, &CompensationHeld { most: HELD_PIECES }),
            Misfit::Short { radius } => self.refuse_here(line, &CutterInShortPiece { radius: Size::length(radius, 4) }),
        }
    }
}

/// An arc with another way.
fn turned(arc: &Arc, element: Element, centre: Point, sweep: f64) -> Arc {
    let radius = trig::hypot(element.from[0] - centre[0], element.from[1] - centre[1]);
    Arc { centre, sweep, radius, ..*arc }
}

/// The length of a motion in X, Y and Z; mm.
fn length(motion: &Motion) -> f64 {
    let by = motion.to.differences(&motion.from);
    match motion.kind {
        MotionKind::Arc(arc, _) => arc.length(by[Axis::Z as usize]),
        _ => (by[0] * by[0] + by[1] * by[1] + by[2] * by[2]).sqrt(),
    }
}
