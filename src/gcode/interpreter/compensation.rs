//! Nose radius compensation between the plan of a block and the motions that are handed out.
//!
//! A control looks a few blocks ahead and overcuts a corner behind which more blocks without motion stand: a Fanuc holds two blocks
//! beside the one that it makes (16i, operator's manual for lathes, B-62754EN page 225). The stage
//! looks on until the next motion, over dwells and over any number of blocks that only change a mode, and warns where the
//! control would not have seen it.
//!
//! Motions under G41 and G42 pass through the [stage](crate::gcode::turning::nose), which holds one of them back; their
//! times come from the path that it makes. The stage works in machine coordinates, in which the path has no jumps when an
//! offset changes.
//!
//! # What is compensated
//! G0, G1, G2 and G3 of the program, and the contour that G70 follows. The passes of other turning cycles and of drilling cycles
//! are made as they are, those of G90 and G94 with the cone shifted ([`Reader::pass_aside`]); so are moves to a reference
//! point and to machine coordinates. The compensation ends before them and starts up again behind them; on a Fagor G53 ends it
//! for good.
//!
//! # Refusals
//! What the nose does not fit into, an arc as the first or the last motion, a thread, another plane than ZX, an offset whose nose
//! radius is not known; each once, then the motions are those of the program until the compensation ends.

use std::f64::consts::PI;

use crate::finding::Size;
use crate::gcode::code::{G, Group, SinglePassCycle, TurningCycle};
use crate::gcode::control::{NoseCorner, RadiusRule};
use crate::gcode::in_force::{Compensation, InForce};
use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::contour::ContourBlock;
use crate::gcode::interpreter::library::Spot;
use crate::gcode::interpreter::out::NumberedMotion;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::motion::{Arc, FeedMode, Motion, MotionKind, Plane};
use crate::gcode::turning::nose::{Element, Misfit, Nose, Path, Point, STRAIGHT, Stage, Step};
use crate::gcode::turning::pace::Pace;
use crate::gcode::turning::rules::{
    ArcOfOtherPlane, CompensationBeginsOnArc, CompensationEndsOnArc, CompensationPlane, CompensationWithoutOffset,
    MachineMoveCancelsNose, MotionNotSeen, NoseChanges, NoseCutsContour, NoseInArc, NoseInCorner, NoseInShortPiece,
    NoseNotInTable, NoseTaken, NoseWithoutTable, PassTip, PassesNeverCompensated, PassesNotCompensated, SharpNose,
    ThreadUnderCompensation, TooManyStillBlocks,
};
use crate::limits::STILL_PIECES;
use crate::machine::axis::{Axis, Pose};

/// The sharpest outer corner that a Fagor goes round straight: 300 degrees between the paths, a turn of 120.
const STRAIGHT_TO_120: f64 = PI * 2.0 / 3.0;

/// The compensation of an interpreter.
pub(super) struct Compensator {
    stage: Stage<NumberedMotion>,
    straight: f64,
    /// From the programmed point to the tip, `[Z, X]`; mm.
    aside: Point,
    /// The compensation in force has been refused.
    refused: bool,
    /// Blocks begun since the last motion in the plane.
    blocks: u32,
}

impl Compensator {
    /// Nothing compensated.
    #[deny(clippy::wildcard_enum_match_arm)]
    pub(super) const fn new(rule: RadiusRule) -> Self {
        let straight = match rule {
            RadiusRule::Nose(NoseCorner::StraightTo120) => STRAIGHT_TO_120,
            RadiusRule::Nose(NoseCorner::Straight) | RadiusRule::Cutter | RadiusRule::None => STRAIGHT,
        };
        Self { stage: Stage::new(straight), straight, aside: [0.0; 2], refused: false, blocks: 0 }
    }

    /// Motions pass as they are programmed.
    pub(super) const fn idle(&self) -> bool {
        self.stage.idle()
    }

    /// The tip's pose where the program has come to a pose.
    pub(super) fn tip(&self, pose: &Pose) -> Pose {
        let mut pose = *pose;
        pose.set(Axis::Z, pose.get(Axis::Z) + self.aside[0]);
        pose.set(Axis::X, pose.get(Axis::X) + self.aside[1]);
        pose
    }
}

fn point(pose: &Pose) -> Point {
    [pose.get(Axis::Z), pose.get(Axis::X)]
}

fn place(pose: &mut Pose, [z, x]: Point) {
    pose.set(Axis::Z, z);
    pose.set(Axis::X, x);
}

impl Reader<'_, '_> {
    /// G40, G41 and G42.
    pub(super) fn set_compensation(&mut self, side: Compensation) -> Result<()> {
        if side != Compensation::Off && self.state.modal.plane != Plane::ZX {
            return Err(Refused::of(
                &CompensationPlane { plane: self.state.modal.plane.name() },
                &[self.block.g_column(Group::CutterCompensation)],
            ));
        }
        if side != Compensation::Off && self.state.modal.offset == 0 {
            let (spot, column) = (self.block.spot, self.block.g_column(Group::CutterCompensation));
            self.memory.remarks.row(&CompensationWithoutOffset {}, spot, Some(column));
        }
        self.state.modal.compensation = side;
        if side != Compensation::Off
            && self.state.modal.offset != 0
            && let Ok(nose) = self.known_nose()
        {
            let (offset, tip, q) = (self.state.modal.offset, nose.tip.number(), nose.tip.in_linuxcnc());
            let taken = NoseTaken { offset, radius: Size::mm(nose.radius), tip, q };
            self.memory.remarks.row(&taken, self.block.spot, Some(self.block.g_column(Group::CutterCompensation)));
        }
        Ok(())
    }

    /// How far aside of what is programmed the tip makes the cut of a pass under G90 or G94, along the axis across the cut; mm.
    /// `slope` is the cone's rise across per mm along the cut's axis, both positive along their axes.
    ///
    /// # Derivation
    /// From the rule of Fanuc Series 0i-T, operator's manual, tool nose radius compensation, canned cycles:
    /// the nose is kept on the side of each line that lies away from the tip, whatever G41 and G42 say: a cut along an axis with a
    /// tip that touches it is made as programmed, and so are the moves across. On a cone of slope m, with tᵢ the shares of the
    /// vector from the nose's centre to the tip along the cut and tₐ across it, the centre is at R √(1 + m²) from the cone along
    /// the axis across, and the tip, tᵢ R and tₐ R from the centre, is aside by −R (m tᵢ + tₐ (√(1 + m²) − 1)).
    ///
    /// # Errors
    /// For a tip that lies neither before nor behind the cut, and without a nose in the table.
    pub(super) fn pass_aside(&mut self, pass: SinglePassCycle, slope: f64) -> Result<f64> {
        if self.state.modal.compensation == Compensation::Off
            || self.state.modal.offset == 0
            || pass == SinglePassCycle::Thread
        {
            return Ok(0.0);
        }
        let nose = self.known_nose()?;
        let [z, x] = nose.tip.vector();
        let (along, across) = if pass == SinglePassCycle::Radial { (x, z) } else { (z, x) };
        if across == 0.0 && nose.radius > 0.0 {
            let (number, tip) = (pass.number(), nose.tip.number());
            return Err(Refused::of(&PassTip { cycle: number, tip }, &[self.block.g_column(Group::Motion)]));
        }
        let aside = -nose.radius * (slope * along + across * ((1.0 + slope * slope).sqrt() - 1.0));
        Ok(if slope == 0.0 || !aside.is_finite() { 0.0 } else { aside })
    }

    /// Says that the passes of a cycle are made as they are, where its block or its contour asks for compensation.
    pub(super) fn remark_uncompensated(&mut self, blocks: &[ContourBlock]) {
        let pass = matches!(self.state.modal.motion, G::Pass(SinglePassCycle::Axial | SinglePassCycle::Radial));
        let asked = blocks.iter().any(|block| block.side != Compensation::Off);
        if (self.state.modal.compensation == Compensation::Off && !asked) || pass {
            return;
        }
        let spot = self.block.spot;
        match self.memory.control.codes.names(G::Turning(TurningCycle::Finish)).into_iter().next() {
            Some(finish) => self.memory.remarks.row(&PassesNotCompensated { finish }, spot, None),
            None => self.memory.remarks.row(&PassesNeverCompensated {}, spot, None),
        }
    }

    /// Counts a block, by which it is seen how far ahead the control would have to look.
    pub(super) fn count_block(&mut self) {
        self.memory.out.compensator.blocks = self.memory.out.compensator.blocks.saturating_add(1);
    }

    /// Warns where the control has not seen a motion that follows others under compensation: it puts the nose at right angles to
    /// the end of the one before, and the corner may be cut.
    fn remark_unseen(&mut self, motion: &Motion, side: Compensation) {
        let still = std::mem::take(&mut self.memory.out.compensator.blocks).saturating_sub(1);
        if let Some(sees) = self.memory.control.radius.sees().filter(|&sees| still >= sees)
            && side != Compensation::Off
            && !self.memory.out.compensator.stage.idle()
        {
            let spot = Spot { line: motion.line, n: motion.n, ..self.block.spot };
            self.memory.remarks.row(&MotionNotSeen { still, sees }, spot, None);
        }
    }

    /// Hands a motion out, by way of the stage where a compensation is in force.
    pub(super) fn hand_out(&mut self, motion: Motion) {
        let mut control = InForce { file: self.block.spot.text, ..self.state.modal.in_force() };
        let number = self.made();
        let side = self.side(&motion);
        control.compensation = side;
        if side == Compensation::Off {
            self.memory.out.compensator.refused = false;
            if self.memory.out.compensator.stage.idle() {
                self.memory.out.queue.push_back(Ok((motion, control, number)));
                return;
            }
        }
        if self.memory.out.compensator.refused {
            self.memory.out.queue.push_back(Ok((motion, control, number)));
            return;
        }
        let [was, is] = [point(&motion.from), point(&motion.to)];
        if was != is {
            self.remark_unseen(&motion, side);
        }
        let nose = match self.nose(side, &motion) {
            Ok(nose) => nose,
            Err(mut fault) => {
                self.flush();
                self.memory.out.compensator.refused = true;
                self.memory.out.compensator.stage = Stage::new(self.memory.out.compensator.straight);
                fault.line = motion.line;
                fault.file = self.memory.library.file(control.file).cloned();
                self.memory.out.queue.push_back(Err(fault));
                self.memory.out.queue.push_back(Ok((motion, control, number)));
                return;
            }
        };
        let to = point(&motion.machine);
        let shift = [0, 1].map(|axis| to[axis] - point(&motion.to)[axis]);
        let from = [0, 1].map(|axis| point(&motion.from)[axis] + shift[axis]);
        let path = match motion.kind {
            MotionKind::Dwell(_) => Path::Still,
            MotionKind::Arc(arc, _) => {
                Path::Arc { centre: [0, 1].map(|axis| arc.centre[axis] + shift[axis]), sweep: arc.sweep }
            }
            _ => Path::Line,
        };
        let tag = NumberedMotion { motion, control, number };
        let rapid = motion.kind == MotionKind::Rapid;
        let mut placed = Vec::new();
        let step = Step { element: Element { from, to, path }, side, nose, rapid, tag };
        let result = self.memory.out.compensator.stage.push(step, &mut placed);
        self.take_placed(placed, result);
    }

    /// Hands out what the stage still holds: the program has ended, or goes on without it.
    pub(super) fn flush(&mut self) {
        let mut placed = Vec::new();
        let result = self.memory.out.compensator.stage.finish(&mut placed);
        self.take_placed(placed, result);
    }

    /// The side on which a motion is compensated.
    fn side(&mut self, motion: &Motion) -> Compensation {
        let at_once = self.block.groups & (1 << Group::NonModal as u16) != 0
            && matches!(self.block.g(Group::NonModal), Some(G::Reference(_) | G::MachineCoordinates));
        let dwell = matches!(motion.kind, MotionKind::Dwell(_));
        if at_once
            && !dwell
            && !self.memory.control.machine_move.by_itself()
            && self.state.modal.compensation != Compensation::Off
        {
            self.state.modal.compensation = Compensation::Off;
            self.memory.remarks.row(&MachineMoveCancelsNose {}, self.block.spot, None);
        }
        if (at_once && !dwell) || self.state.modal.offset == 0 {
            return Compensation::Off;
        }
        self.block.side.unwrap_or(self.state.modal.compensation)
    }

    /// The nose of the offset in force, for a motion on a side.
    fn nose(&mut self, side: Compensation, motion: &Motion) -> Result<Nose> {
        if side == Compensation::Off {
            return Ok(Nose::default());
        }
        if let MotionKind::Thread(_) = motion.kind {
            return Err(Refused::of(&ThreadUnderCompensation {}, &[]));
        }
        if matches!(motion.kind, MotionKind::Arc(arc, _) if arc.plane != Plane::ZX) {
            return Err(Refused::of(&ArcOfOtherPlane {}, &[]));
        }
        let nose = self.known_nose()?;
        if nose.radius == 0.0 {
            let offset = self.state.modal.offset;
            self.memory.remarks.row(&SharpNose { offset }, self.block.spot, None);
        }
        Ok(nose)
    }

    /// The nose that the table gives the offset in force.
    fn known_nose(&self) -> Result<Nose> {
        let offset = self.state.modal.offset;
        self.memory.tools.get(&offset).and_then(|tool| tool.nose).ok_or_else(|| {
            if self.memory.setting.tools.is_some() {
                Refused::of(&NoseNotInTable { offset }, &[])
            } else {
                Refused::of(&NoseWithoutTable { offset }, &[])
            }
        })
    }

    fn take_placed(&mut self, placed: Vec<(Element, NumberedMotion)>, result: Result<(), (Misfit, NumberedMotion)>) {
        let mut last = 0;
        for (element, carried) in placed {
            let first = std::mem::replace(&mut last, carried.number) != carried.number;
            self.memory.out.compensator.aside =
                [0, 1].map(|axis| element.to[axis] - point(&carried.motion.machine)[axis]);
            let motion = self.placed(&element, &carried, first);
            self.memory.out.queue.push_back(Ok((motion, carried.control, carried.number)));
        }
        for cut in self.memory.out.compensator.stage.cuts() {
            self.memory.remarks.row(
                &NoseCutsContour {
                    radius: Size::length(cut.radius, 4),
                    depth: Size::mm(cut.depth),
                    into: cut.into.motion.line,
                },
                cut.along.spot(),
                None,
            );
        }
        if let Err((misfit, carried)) = result {
            let mut fault = refusal(&misfit);
            (fault.line, fault.file) = (carried.motion.line, self.memory.library.file(carried.control.file).cloned());
            self.memory.out.queue.push_back(Err(fault));
        }
    }

    /// A motion along a piece of the compensated path; the first of its block makes the way of the other axes.
    fn placed(&self, element: &Element, carried: &NumberedMotion, first: bool) -> Motion {
        let programmed = carried.motion;
        let shift = [0, 1].map(|axis| point(&programmed.to)[axis] - point(&programmed.machine)[axis]);
        let element_in_program = element.shifted(shift);
        if first && element_in_program.from == point(&programmed.from) && element.to == point(&programmed.machine) {
            return programmed;
        }
        let mut motion = programmed;
        if !first {
            motion.from = motion.to;
        }
        place(&mut motion.from, element_in_program.from);
        place(&mut motion.to, element_in_program.to);
        place(&mut motion.machine, element.to);
        motion.kind = match (programmed.kind, element_in_program.path) {
            (MotionKind::Arc(arc, feed), Path::Arc { centre, sweep }) => {
                MotionKind::Arc(Arc { centre, sweep, radius: radius(&motion.from, centre), ..arc }, feed)
            }
            (MotionKind::Arc(_, feed), _) => MotionKind::Feed(feed),
            (MotionKind::Feed(feed), Path::Arc { centre, sweep }) => {
                let turns = if sweep < 0.0 { -1 } else { 1 };
                let radius = radius(&motion.from, centre);
                MotionKind::Arc(Arc { plane: Plane::ZX, centre, turns, radius, sweep, rotation: 0.0 }, feed)
            }
            (kind, _) => kind,
        };
        motion.seconds = time(&motion, &carried.control, self.memory.setting.greatest_speed);
        motion
    }
}

fn radius(from: &Pose, centre: Point) -> f64 {
    crate::number::trig::hypot(from.get(Axis::Z) - centre[0], from.get(Axis::X) - centre[1])
}

/// The time that a motion takes with what is in force, and with the machine's greatest speed of the spindle, s; `None` at rapid.
fn time(motion: &Motion, control: &InForce, greatest_speed: Option<f64>) -> Option<f64> {
    let by = motion.to.differences(&motion.from);
    let straight = by.iter().map(|share| share * share).sum::<f64>().sqrt();
    let (feed, length) = match motion.kind {
        MotionKind::Rapid => return None,
        MotionKind::Dwell(seconds) => return Some(seconds),
        MotionKind::Thread(_) => return motion.seconds,
        MotionKind::Feed(feed) => (feed, straight),
        MotionKind::Arc(arc, feed) => (feed, arc.length(by[Axis::Y as usize])),
    };
    let seconds = match feed.mode {
        FeedMode::PerMinute => length * 60.0 / feed.value,
        FeedMode::InverseTime => 60.0 / feed.value,
        FeedMode::Seconds => feed.value,
        FeedMode::PerRevolution => {
            let pace = Pace::of(control, greatest_speed)?;
            let [from, to] = [&motion.from, &motion.to].map(|pose| pose.get(Axis::X));
            match motion.kind {
                MotionKind::Arc(arc, _) => pace.arc(&arc, [from, motion.from.get(Axis::Z)], feed.value)?,
                _ => pace.straight([from, to], length, feed.value)?,
            }
        }
    };
    seconds.is_finite().then_some(seconds)
}

fn refusal(misfit: &Misfit) -> Box<Refused> {
    match *misfit {
        Misfit::ArcEntry => Refused::of(&CompensationBeginsOnArc {}, &[]),
        Misfit::ArcExit => Refused::of(&CompensationEndsOnArc {}, &[]),
        Misfit::Arc { radius, arc } => {
            Refused::of(&NoseInArc { radius: Size::length(radius, 4), arc: Size::length(arc, 4) }, &[])
        }
        Misfit::Corner { radius, turn } => Refused::of(
            &NoseInCorner { radius: Size::length(radius, 4), turn: Size::degrees(turn.to_degrees(), 2) },
            &[],
        ),
        Misfit::Short { radius, length, taken } => Refused::of(
            &NoseInShortPiece {
                radius: Size::length(radius, 4),
                length: Size::length(length, 4),
                taken: Size::length(taken, 4),
                most: Size::length(radius * length / taken, 4),
            },
            &[],
        ),
        Misfit::Changed => Refused::of(&NoseChanges {}, &[]),
        Misfit::Still => Refused::of(&TooManyStillBlocks { most: STILL_PIECES }, &[]),
    }
}
