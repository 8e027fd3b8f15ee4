//! Threads along a line (G32, G34), and the turning cycles of one pass (G90, G92, G94).
//!
//! # Path of a pass
//! From the start S to the end E `(X, Z)`, with R the change of the cone along the pass: G90 and G92 at rapid to the radius of
//! the cut's start, E's and R, along the cut to E, out to S's radius (G90 at feed, G92 at rapid), at rapid back along Z; G94 the
//! same with X and Z exchanged, its R along Z. A block with X, Z or R alone makes another pass; what it does not give stays,
//! from one of the three codes to another too, until another motion code or a one-shot code other than G4.
//!
//! # References
//! The lathe simulator's figures of G90, G92 and G94; Fanuc Series 0i-T operator's manual, single cycles (R against the direction
//! of the infeed may not exceed it), G32 (the lead counts along the axis that moves more) and G34 (K the change of the lead in
//! one revolution), and the start angle Q of G32 and G92 (not modal, 0 where it is not given). How far
//! a thread is pulled out at the end of G92 is a parameter of the control: none is taken here.

use crate::finding::{Bare, Size};
use crate::gcode::code::{G, Group, SinglePassCycle};
use crate::gcode::interpreter::block::letter;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::interpreter::{Reader, doubt};
use crate::gcode::motion::{Feed, MotionKind, Thread};
use crate::gcode::turning::pace::revolutions;
use crate::gcode::turning::rules::{
    BareG90, LeadChangeMissing, LeadMissing, LeadRunsOut, LeadZero, PassBeginsBeyondStart, PassEndMissing,
    SpeedLimitWithPass, StartAngle, StartAngleForgotten,
};
use crate::gcode::turning::{Move, MoveKind};
use crate::machine::axis::Axis;
use crate::text::t;

impl Reader<'_, '_> {
    /// The lead of a thread: F of this block, or of an earlier block of a thread; mm.
    pub(in crate::gcode::interpreter) fn lead(&mut self) -> Result<f64> {
        if let Some(F) = self.block.get(letter::F) {
            self.state.modal.lead = Some(self.state.modal.unit.to_mm(F));
        }
        match self.state.modal.lead {
            Some(lead) if lead > 0.0 => Ok(lead),
            Some(_) => Err(Refused::of(&LeadZero {}, &[self.block.column(letter::F)])),
            None => Err(Refused::of(&LeadMissing {}, &[])),
        }
    }

    /// The spindle's angle at which a pass of a thread begins: Q of this block alone; degrees.
    fn start_angle(&self) -> Result<f64> {
        let Some(per_degree) = self.memory.control.spindle.thread_angle.per_degree() else { return Ok(0.0) };
        let Some(Q) = self.block.get(letter::Q) else { return Ok(0.0) };
        let turn = 360.0 * per_degree;
        if !(0.0..=turn).contains(&Q) {
            return Err(Refused::of(&StartAngle { value: Q }, &[self.block.column(letter::Q)]));
        }
        Ok(if Q == turn { 0.0 } else { Q / per_degree })
    }

    /// Tells a pass of G92 that begins at 0 for want of a Q, where the passes before it began at another angle: Q is not modal.
    /// At the depth of a pass that had a Q it may well be another start.
    fn remark_start_angle(&mut self, first: bool, x: f64, angle: f64) {
        if first {
            self.state.modal.angled = Some(Vec::new());
        }
        let spot = self.block.spot;
        match &mut self.state.modal.angled {
            Some(depths) if angle != 0.0 => depths.push(x),
            Some(depths) if !depths.is_empty() && !self.block.has(letter::Q) && !depths.contains(&x) => {
                self.state.modal.angled = None;
                self.memory.remarks.row(&StartAngleForgotten {}, spot, None);
            }
            _ => self.state.modal.angled = None,
        }
    }

    /// G32 and G34.
    pub(in crate::gcode::interpreter) fn thread(&mut self, changing: bool) -> Result<()> {
        let lead = self.lead()?;
        let change = match self.block.get(letter::K) {
            Some(K) if changing => self.state.modal.unit.to_mm(K),
            None if changing && self.state.modal.motion != G::Thread(true) => {
                return Err(Refused::of(&LeadChangeMissing {}, &[self.block.g_column(Group::Motion)]));
            }
            None if changing => self.state.modal.lead_change,
            _ => 0.0,
        };
        self.state.modal.lead_change = change;
        self.state.modal.motion = G::Thread(changing);
        if !self.has_axes() {
            return Ok(());
        }
        let to = self.end_point();
        let by = |axis: Axis| (to.get(axis) - self.state.at.get(axis)).abs();
        let distance = by(Axis::X).max(by(Axis::Z));
        if distance == 0.0 {
            return Ok(());
        }
        let thread = Thread { lead, change, angle: self.start_angle()? };
        if revolutions(distance, &thread).is_none() {
            return Err(Refused::of(
                &LeadRunsOut { length: Size::mm(-lead * lead / (2.0 * change)) },
                &[self.block.column(letter::K)],
            ));
        }
        self.remark_standing_spindle();
        let seconds = self.thread_seconds(&to, &thread);
        self.emit(MotionKind::Thread(thread), to, seconds);
        Ok(())
    }

    /// G90 alone: the turning cycle is in force and makes nothing yet.
    fn bare_axial_pass(&mut self) {
        self.state.modal.motion = G::Pass(SinglePassCycle::Axial);
        self.memory.remarks.row(&BareG90 {}, self.block.spot, Some(self.block.g_column(Group::Motion)));
    }

    /// G90, G92 and G94.
    pub(in crate::gcode::interpreter) fn pass(&mut self, pass: SinglePassCycle) -> Result<()> {
        let number = pass.number();
        let before = self.state.modal.pass;
        let named = [
            self.block.has(letter::X) || self.block.has(letter::U),
            self.block.has(letter::Z) || self.block.has(letter::W),
        ];
        let bare = self.block.present & !self.memory.control.lexis.free.mask() == 0;
        if pass == SinglePassCycle::Axial && before.is_none() && bare {
            self.bare_axial_pass();
            return Ok(());
        }
        let (mut end, taper) = before.unwrap_or_default();
        let missing = match (before, named) {
            (None, [false, false]) => Some(t("X y Z", "X and Z")),
            (None, [false, true]) => Some(t("X", "X")),
            (None, [true, false]) => Some(t("Z", "Z")),
            (Some(_), [false, false]) if !self.block.has(letter::R) => Some(t("X, Z o R", "X, Z or R")),
            _ => None,
        };
        let limit = pass == SinglePassCycle::Thread && self.block.has(letter::S) && !self.block.has(letter::F);
        if limit && named == [false, false] {
            return Err(Refused::of(&SpeedLimitWithPass {}, &[self.block.g_column(Group::Motion)]));
        }
        if let Some(words) = missing {
            return Err(Refused::of(&PassEndMissing { words, cycle: number }, &[self.block.g_column(Group::Motion)])
                .hanging_on(doubt::MOTION));
        }
        let to = self.end_point();
        let at = [to.get(Axis::X), to.get(Axis::Z)];
        for ((end, named), at) in end.iter_mut().zip(named).zip(at) {
            if named {
                *end = at;
            }
        }
        let taper = self.block.get(letter::R).map_or(taper, |R| self.state.modal.unit.to_mm(R));
        let start = [self.state.at.get(Axis::X), self.state.at.get(Axis::Z)];
        let across = usize::from(pass == SinglePassCycle::Radial);
        let infeed = end[across] - start[across];
        // What the inch leaves in the last digits is no way beyond the start.
        if infeed * (infeed + taper) < 0.0 && (infeed + taper).abs() > 1e-9 {
            let unit = self.state.modal.unit;
            return Err(Refused::of(
                &PassBeginsBeyondStart {
                    taper: Bare(unit.size(taper)),
                    cycle: number,
                    infeed: unit.size(infeed.abs()),
                },
                &[self.block.column(letter::R)],
            )
            .hanging_on(doubt::LATHE));
        }
        let (cut, out, feed) = if pass == SinglePassCycle::Thread {
            let thread = Thread { lead: self.lead()?, change: 0.0, angle: self.start_angle()? };
            let first = before.is_none() || self.state.modal.motion != G::Pass(pass);
            self.remark_start_angle(first, end[0], thread.angle);
            match before.filter(|_| !first) {
                Some((last, _)) => self.remark_far_deeper(start[0], [last[0], end[0]], thread.lead),
                None => self.see_first_pass(),
            }
            (
                MoveKind::Thread(thread),
                MoveKind::Rapid,
                Feed { mode: self.state.modal.feed_mode, value: self.state.modal.feed },
            )
        } else {
            (MoveKind::Feed(None), MoveKind::Feed(None), self.feed()?)
        };
        let mut points = if pass == SinglePassCycle::Radial {
            [[start[0], end[1] + taper], end, [end[0], start[1]], start]
        } else {
            [[end[0] + taper, start[1]], end, [start[0], end[1]], start]
        };
        let aside = self.pass_aside(pass, taper / (start[1 - across] - end[1 - across]))?;
        // The moves across end on the cone, which the nose touches aside of what is programmed.
        let [first, last, ..] = &mut points;
        first[across] += aside;
        last[across] += aside;
        self.state.modal.motion = G::Pass(pass);
        self.state.modal.pass = Some((end, taper));
        let mut moves = Vec::with_capacity(4);
        let mut from = start;
        for (kind, to) in [MoveKind::Rapid, cut, out, MoveKind::Rapid].into_iter().zip(points) {
            if to != from {
                moves.push(Move { kind, to, line: None });
            }
            from = to;
        }
        self.make_moves(moves, feed);
        Ok(())
    }
}
