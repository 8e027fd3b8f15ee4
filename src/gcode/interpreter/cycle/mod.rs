//! Drilling cycles, hole by hole.
//!
//! # References
//! LinuxCNC, canned cycles G73, G74 and G81 to G89, G98 and G99.

mod drilling;
pub(super) mod single_pass;

use crate::gcode::code::{Cycle, G, Group};
use crate::gcode::control::Drilling;
use crate::gcode::in_force::Spindle;
use crate::gcode::interpreter::block::{AXES, letter};
use crate::gcode::interpreter::expression::whole;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::interpreter::run::{Holes, Pending};
use crate::gcode::interpreter::{Reader, doubt};
use crate::gcode::motion::{Feed, FeedMode, MotionKind, Plane};
use crate::gcode::turning::rules::{
    CycleMovesOtherAxis, CycleRepeats, CycleSpindle, CycleUnderInverseTime, CycleWordMissing, HoleDwellNegative,
    MillHolePlaneBelowBottom, MillPeckNotPositive, ReturnHeightNotSaid, TakenOutByHand, TappingOutsideG17,
    TooManyPecks,
};
use crate::limits::{BLOCK_HOLES, PECKS};
use crate::machine::axis::{Axis, Pose};

/// How far above the last depth a peck begins again; mm (0.010 inch).
pub(super) const PECK_CLEARANCE: f64 = 0.254;
/// What rounding alone has left above the bottom is no peck; mm.
pub(super) const NO_PECK: f64 = 1e-9;

pub(super) fn missing(letter: char, cycle: Cycle) -> Box<Refused> {
    let number = cycle.number();
    Refused::of(&CycleWordMissing { letter, cycle: number }, &[]).hanging_on(doubt::MOTION)
}

impl Reader<'_, '_> {
    /// The motion of a block with G80 and axis words, on a control whose G80 brings back the motion code from before the cycle; `None` where
    /// there is none.
    pub(super) fn motion_behind_cancel(&self) -> Option<G> {
        let under = self.state.modal.under_cycle();
        (self.memory.control.cancel.restores() && under != G::Cancel).then_some(under)
    }

    /// A canned cycle of the block in hand, as the control drills.
    #[deny(clippy::wildcard_enum_match_arm)]
    pub(super) fn drill(&mut self, cycle: Cycle) -> Result<()> {
        match self.memory.control.drilling {
            Drilling::Rs274 => self.cycle(cycle),
            Drilling::Lathe => self.hole(cycle),
            Drilling::None => Err(self.unknown('G', cycle.number(), self.block.g_column(Group::Motion))),
        }
    }

    /// A canned cycle along the axis across the plane.
    fn cycle(&mut self, cycle: Cycle) -> Result<()> {
        let feed = self.feed()?;
        if matches!(feed.mode, FeedMode::InverseTime | FeedMode::Seconds) {
            return Err(Refused::of(&CycleUnderInverseTime {}, &[]));
        }
        let again = self.state.modal.is_cycle(cycle);
        let [first, second, across] = self.state.modal.plane.axes();
        for axis in AXES.into_iter().skip(3) {
            if self.block.has(axis) {
                return Err(Refused::of(&CycleMovesOtherAxis {}, &[self.block.column(axis)]));
            }
        }
        let unit = self.state.modal.unit;
        let sticky = self.state.modal.sticky;
        let r_word = match self.block.get(letter::R) {
            Some(R) => unit.to_mm(R),
            None if again => sticky.r,
            None => return Err(missing('R', cycle)),
        };
        let bottom_word = match self.block.get(AXES[across as usize]) {
            Some(Z) => unit.to_mm(Z),
            None if again => sticky.bottom,
            None => return Err(missing(across.letter(), cycle)),
        };
        let holes = match self.block.get(letter::L) {
            None => 1,
            Some(L) => whole(L).filter(|holes| (1..=BLOCK_HOLES).contains(holes)).ok_or_else(|| {
                Refused::of(&CycleRepeats { value: L, most: BLOCK_HOLES }, &[self.block.column(letter::L)])
            })?,
        };
        let current = self.state.at.get(across);
        let initial = *self.state.modal.sticky.initial.get_or_insert(current);
        let plane_word = |axis: Axis| self.block.get(AXES[axis as usize]).map(|word| unit.to_mm(word));
        let start = [self.state.at.get(first), self.state.at.get(second)];
        let (r, bottom, at, step) = if self.state.modal.incremental {
            let r = r_word + initial;
            (r, r + bottom_word, start, [plane_word(first).unwrap_or(0.0), plane_word(second).unwrap_or(0.0)])
        } else {
            let at = [plane_word(first).unwrap_or(start[0]), plane_word(second).unwrap_or(start[1])];
            (r_word, bottom_word, at, [0.0; 2])
        };
        if r < bottom {
            return Err(Refused::of(&MillHolePlaneBelowBottom { r, bottom }, &[]));
        }
        let mut run = Holes {
            cycle,
            left: holes,
            first: true,
            step,
            at,
            r,
            bottom,
            clear: r,
            p: 0.0,
            q: 0.0,
            offset: [0.0; 2],
            middle: 0.0,
            feed,
        };
        self.cycle_words(&mut run, again)?;
        // Below R the tool goes straight up first.
        let old = if initial < r {
            let mut up = self.state.at;
            up.set(across, r);
            self.emit(MotionKind::Rapid, up, None);
            r
        } else {
            initial
        };
        if self.returns_initial() {
            run.clear = old;
        }
        if self.state.modal.return_initial.is_none() && !self.memory.control.start.retract.initial() && old > r {
            let spot = self.block.spot;
            self.memory.remarks.row(&ReturnHeightNotSaid {}, spot, None);
        }
        let sticky = &mut self.state.modal.sticky;
        (sticky.r, sticky.bottom) = (r_word, bottom_word);
        self.state.modal.motion = G::Cycle(cycle);
        self.memory.out.run = Some(Pending::Holes(run));
        Ok(())
    }

    /// Whether cycles return to the height that they started from.
    pub(super) fn returns_initial(&self) -> bool {
        self.state.modal.return_initial.unwrap_or(self.memory.control.start.retract.initial())
    }

    /// P, Q, I, J and K of the cycle.
    fn cycle_words(&mut self, run: &mut Holes, again: bool) -> Result<()> {
        let (cycle, unit) = (run.cycle, self.state.modal.unit);
        match cycle {
            Cycle::ChipBreak | Cycle::Peck => {
                run.q = match self.block.get(letter::Q) {
                    Some(Q) => unit.to_mm(Q),
                    None if again => self.state.modal.sticky.q,
                    None => return Err(missing('Q', cycle)),
                };
                self.state.modal.sticky.q = run.q;
                if run.q <= 0.0 {
                    return Err(Refused::of(&MillPeckNotPositive {}, &[self.block.column(letter::Q)]));
                }
                if (run.r - run.bottom) / run.q > PECKS {
                    return Err(Refused::beyond(&TooManyPecks { most: PECKS }, &[]));
                }
            }
            Cycle::DrillDwell
            | Cycle::BoreStop
            | Cycle::BoreManual
            | Cycle::BoreDwell
            | Cycle::TapLeft
            | Cycle::TapRight => {
                let tap = matches!(cycle, Cycle::TapLeft | Cycle::TapRight);
                run.p = match self.block.get(letter::P) {
                    Some(P) => P * self.memory.control.lexis.cycle_dwell.seconds(),
                    None if again || tap => self.state.modal.sticky.p,
                    None => return Err(missing('P', cycle)),
                };
                if run.p < 0.0 {
                    return Err(Refused::of(&HoleDwellNegative {}, &[self.block.column(letter::P)]));
                }
                self.state.modal.sticky.p = run.p;
            }
            Cycle::BackBore => {
                for (at, (letter, name)) in
                    [(letter::I, 'I'), (letter::J, 'J'), (letter::K, 'K')].into_iter().enumerate()
                {
                    let value = match self.block.get(letter) {
                        Some(word) => unit.to_mm(word),
                        None if again => self.state.modal.sticky.ijk[at],
                        None => return Err(missing(name, cycle)),
                    };
                    self.state.modal.sticky.ijk[at] = value;
                }
                let [i, j, k] = self.state.modal.sticky.ijk;
                // I, J, K belong to X, Y, Z in every plane.
                let of = |axis: Axis| [i, j, k].get(axis as usize).copied().unwrap_or(0.0);
                let [first, second, across] = self.state.modal.plane.axes();
                run.offset = [of(first), of(second)];
                run.middle = if self.state.modal.incremental { run.bottom + of(across) } else { of(across) };
            }
            Cycle::Drill | Cycle::Bore => {}
        }
        let wanted = match cycle {
            Cycle::TapRight => Some(Spindle::Clockwise),
            Cycle::TapLeft => Some(Spindle::CounterClockwise),
            _ => None,
        };
        let turns = self.state.modal.spindle;
        let needs = matches!(cycle, Cycle::BoreStop | Cycle::BackBore | Cycle::BoreManual);
        if wanted.is_some_and(|wanted| wanted != turns) || (needs && turns == Spindle::Stopped) {
            return Err(Refused::of(&CycleSpindle { cycle: cycle.number() }, &[]).hanging_on(doubt::SPINDLE));
        }
        if wanted.is_some() && self.state.modal.plane != Plane::XY {
            self.memory.remarks.row(&TappingOutsideG17 { cycle: cycle.number() }, self.block.spot, None);
        }
        if cycle == Cycle::BoreManual {
            let spot = self.block.spot;
            self.memory.remarks.row(&TakenOutByHand {}, spot, None);
        }
        Ok(())
    }

    /// Makes the next hole of a run.
    pub(super) fn next_hole(&mut self, mut run: Holes) -> Result<()> {
        let [first, second, across] = self.state.modal.plane.axes();
        run.at[0] += run.step[0];
        run.at[1] += run.step[1];
        let base = self.state.at;
        let point = |at: [f64; 2], height: f64| -> Pose {
            let mut pose = base;
            pose.set(first, at[0]);
            pose.set(second, at[1]);
            pose.set(across, height);
            pose
        };
        let height = self.state.at.get(across);
        if run.first && height > run.r {
            self.emit(MotionKind::Rapid, point(run.at, height), None);
            self.emit(MotionKind::Rapid, point(run.at, run.r), None);
        } else {
            self.emit(MotionKind::Rapid, point(run.at, run.clear), None);
            if run.clear > run.r {
                self.emit(MotionKind::Rapid, point(run.at, run.r), None);
            }
        }
        run.first = false;
        let at = |height: f64| point(run.at, height);
        match run.cycle {
            Cycle::Drill => {
                self.cut(at(run.bottom), run.feed);
                self.emit(MotionKind::Rapid, at(run.clear), None);
            }
            Cycle::DrillDwell | Cycle::BoreStop => {
                self.cut(at(run.bottom), run.feed);
                self.wait(run.p);
                self.emit(MotionKind::Rapid, at(run.clear), None);
            }
            Cycle::Peck | Cycle::ChipBreak => {
                let mut depth = run.r - run.q;
                while depth > run.bottom + NO_PECK {
                    self.cut(at(depth), run.feed);
                    if run.cycle == Cycle::Peck {
                        self.emit(MotionKind::Rapid, at(run.r), None);
                    }
                    self.emit(MotionKind::Rapid, at(depth + PECK_CLEARANCE), None);
                    depth -= run.q;
                }
                self.cut(at(run.bottom), run.feed);
                self.emit(MotionKind::Rapid, at(run.clear), None);
            }
            Cycle::TapLeft | Cycle::TapRight => {
                self.cut(at(run.bottom), run.feed);
                self.wait(run.p);
                self.cut(at(run.clear), run.feed);
            }
            Cycle::Bore => {
                self.cut(at(run.bottom), run.feed);
                self.cut(at(run.r), run.feed);
                self.emit(MotionKind::Rapid, at(run.clear), None);
            }
            Cycle::BackBore => {
                let aside = [run.at[0] + run.offset[0], run.at[1] + run.offset[1]];
                self.emit(MotionKind::Rapid, point(aside, run.r), None);
                self.emit(MotionKind::Rapid, point(aside, run.bottom), None);
                self.emit(MotionKind::Rapid, at(run.bottom), None);
                self.cut(at(run.middle), run.feed);
                self.cut(at(run.bottom), run.feed);
                self.emit(MotionKind::Rapid, point(aside, run.bottom), None);
                self.emit(MotionKind::Rapid, point(aside, run.clear), None);
                self.emit(MotionKind::Rapid, at(run.clear), None);
            }
            Cycle::BoreManual => {
                self.cut(at(run.bottom), run.feed);
                self.wait(run.p);
                // The operator takes the tool out; the next motion starts from where it then stands.
                self.state.at = at(run.clear);
            }
            Cycle::BoreDwell => {
                self.cut(at(run.bottom), run.feed);
                self.wait(run.p);
                // At feed all the way, unlike G85.
                self.cut(at(run.clear), run.feed);
            }
        }
        run.left -= 1;
        if run.left > 0 {
            self.memory.out.run = Some(Pending::Holes(run));
        }
        Ok(())
    }

    fn cut(&mut self, to: Pose, feed: Feed) {
        let seconds = self.straight_seconds(&to, feed);
        self.emit(MotionKind::Feed(feed), to, seconds);
    }

    fn wait(&mut self, seconds: f64) {
        if seconds > 0.0 {
            self.see_dwell('P', self.memory.control.lexis.cycle_dwell, seconds);
            self.emit(MotionKind::Dwell(seconds), self.state.at, Some(seconds));
        }
    }
}
