//! Drilling cycles of a lathe (G80 to G83).
//!
//! # Path of a hole
//! At rapid along X over the hole, at rapid along Z to R, at feed to the bottom, the dwell, at rapid back to R, where the tool
//! stays. G83 pecks by Q: after each peck at rapid back to R and down again to [`PECK_CLEARANCE`] above the depth reached, which
//! is a parameter of the control; without Q it goes to the bottom at one go, and that is reported. Blocks with X or Z alone make further holes; G80 ends the cycle and leaves the motion code in
//! force that was so before it.
//!
//! # References
//! The lathe simulator's figure of G81 to G83: R is the absolute Z of the plane of retraction, P in ms, Q in µm. On other controls
//! R counts from where the tool stands: [`HolePlane`] says which.

use crate::finding::Size;
use crate::gcode::code::{Cycle, G};
use crate::gcode::control::Quantity;
use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block::letter;
use crate::gcode::interpreter::cycle::{NO_PECK, PECK_CLEARANCE, missing};
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::interpreter::setting::HolePlane;
use crate::gcode::turning::rules::{
    HoleDwellNegative, HolePlaneBelowBottom, HolePlaneNotSaid, PeckNotPositive, PeckWithoutDepth, TooManyLathePecks,
};
use crate::gcode::turning::{Move, MoveKind};
use crate::limits::PECKS;
use crate::machine::axis::Axis;
use crate::machine::length_unit::LengthUnit;

impl Reader<'_, '_> {
    /// A drilling cycle of the block in hand.
    pub(in crate::gcode::interpreter) fn hole(&mut self, cycle: Cycle) -> Result<()> {
        let feed = self.feed()?;
        let again = matches!(self.state.modal.motion, G::Cycle(_));
        let (unit, sticky) = (self.state.modal.unit, self.state.modal.sticky);
        let r = match self.block.get(letter::R) {
            Some(R) => match self.memory.setting.hole_plane {
                Some(HolePlane::Incremental) => self.state.at.get(Axis::Z) + unit.to_mm(R),
                Some(HolePlane::Absolute) => unit.to_mm(R),
                None => {
                    let column = self.block.column(letter::R);
                    self.memory.remarks.row(&HolePlaneNotSaid {}, self.block.spot, Some(column));
                    unit.to_mm(R)
                }
            },
            None if again => sticky.r,
            None => return Err(missing('R', cycle)),
        };
        let to = self.end_point();
        let bottom = if self.block.has(letter::Z) || self.block.has(letter::W) {
            to.get(Axis::Z)
        } else if again {
            sticky.bottom
        } else {
            return Err(missing('Z', cycle));
        };
        let q = match self.block.get(letter::Q) {
            Some(Q) => self.increments(Q),
            None if again => sticky.q,
            None => 0.0,
        };
        let p = match self.block.get(letter::P) {
            Some(P) => P * self.memory.control.lexis.cycle_dwell.seconds(),
            None if again => sticky.p,
            None if cycle == Cycle::DrillDwell => return Err(missing('P', cycle)),
            None => 0.0,
        };
        if p < 0.0 {
            return Err(Refused::of(&HoleDwellNegative {}, &[self.block.column(letter::P)]));
        }
        if r < bottom {
            return Err(Refused::of(&HolePlaneBelowBottom { r: Size::mm(r), bottom: Size::mm(bottom) }, &[]));
        }
        if cycle == Cycle::Peck && q <= 0.0 && self.block.has(letter::Q) {
            return Err(Refused::of(&PeckNotPositive {}, &[self.block.column(letter::Q)]));
        }
        // Without Q the control drills to the bottom at one go.
        let pecks = cycle == Cycle::Peck && q > 0.0;
        if cycle == Cycle::Peck && !pecks {
            self.memory.remarks.row(&PeckWithoutDepth { depth: Size::mm(r - bottom) }, self.block.spot, None);
        }
        if pecks && (r - bottom) / q > PECKS {
            return Err(Refused::of(&TooManyLathePecks { most: PECKS }, &[self.block.column(letter::Q)]));
        }
        let sticky = &mut self.state.modal.sticky;
        (sticky.r, sticky.bottom, sticky.p, sticky.q) = (r, bottom, p, q);
        self.state.modal.motion = G::Cycle(cycle);
        let x = to.get(Axis::X);
        let mut at = [self.state.at.get(Axis::X), self.state.at.get(Axis::Z)];
        let mut moves = Vec::new();
        let mut go = |kind: MoveKind, to: [f64; 2]| {
            if to != at {
                moves.push(Move { kind, to, line: None });
            }
            at = to;
        };
        go(MoveKind::Rapid, [x, self.state.at.get(Axis::Z)]);
        go(MoveKind::Rapid, [x, r]);
        let mut depth = r - q;
        while pecks && depth > bottom + NO_PECK {
            go(MoveKind::Feed(None), [x, depth]);
            go(MoveKind::Rapid, [x, r]);
            go(MoveKind::Rapid, [x, (depth + PECK_CLEARANCE).min(r)]);
            depth -= q;
        }
        go(MoveKind::Feed(None), [x, bottom]);
        if p > 0.0 && cycle != Cycle::Drill {
            moves.push(Move { kind: MoveKind::Dwell(p), to: [x, bottom], line: None });
        }
        if bottom < r {
            moves.push(Move { kind: MoveKind::Rapid, to: [x, r], line: None });
        }
        self.make_moves(moves, feed);
        Ok(())
    }

    /// A number of least input increments, as P and Q of cycles are; mm.
    pub(in crate::gcode::interpreter) fn increments(&self, number: f64) -> f64 {
        let unit = self.state.modal.unit;
        let quantity = match unit {
            LengthUnit::Millimetre => Quantity::Millimetre,
            LengthUnit::Inch => Quantity::Inch,
        };
        unit.to_mm(number / self.memory.control.lexis.point.increments(quantity))
    }
}
