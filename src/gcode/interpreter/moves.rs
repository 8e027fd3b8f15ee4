//! Motions that one block makes many of: the holes of a canned cycle, the moves of a turning cycle.

use crate::gcode::control::Compensation;
use crate::gcode::interpreter::Interpreter;
use crate::gcode::interpreter::contour::ContourBlock;
use crate::gcode::interpreter::cycle;
use crate::gcode::interpreter::fault::Outcome;
use crate::gcode::motion::{Arc, Feed, Kind, Plane};
use crate::gcode::turning::{Move, Way};
use crate::machine::axis::{Axis, Pose};
use crate::number::trig;

/// What the block in hand has still to do.
#[derive(Debug)]
pub(super) enum Run {
    /// Holes of a canned cycle.
    Holes(cycle::Run),
    /// Moves of a turning cycle.
    Moves(Moves),
}

/// The moves of a turning cycle that are still to be made.
#[derive(Debug)]
pub(super) struct Moves {
    moves: std::vec::IntoIter<Move>,
    feed: Feed,
    /// The blocks of the contour that the moves may name, in the order of their lines.
    blocks: Vec<ContourBlock>,
    /// The S words of the contour's blocks count.
    speeds: bool,
}

impl Interpreter<'_> {
    /// Turns the moves of a cycle into motions, one after another as they are asked for.
    pub(super) fn make_moves(&mut self, moves: Vec<Move>, feed: Feed) {
        self.remark_uncompensated(&[]);
        self.run = Some(Run::Moves(Moves { moves: moves.into_iter(), feed, blocks: Vec::new(), speeds: false }));
    }

    /// The same for moves that name blocks of a contour; with `speeds` their S words are obeyed.
    pub(super) fn make_contour_moves(&mut self, moves: Vec<Move>, feed: Feed, blocks: Vec<ContourBlock>, speeds: bool) {
        if !speeds {
            self.remark_uncompensated(&blocks);
        }
        self.run = Some(Run::Moves(Moves { moves: moves.into_iter(), feed, blocks, speeds }));
    }

    /// The feed of the moves that do not say their own: it need not be given where there are none.
    pub(super) fn feed_of(&mut self, moves: &[Move]) -> Outcome<Feed> {
        if moves.iter().any(|one| matches!(one.way, Way::Feed(None) | Way::Arc { feed: None, .. })) {
            return self.feed();
        }
        Ok(Feed { mode: self.modal.feed_mode, value: self.modal.feed })
    }

    /// Makes the next motions of the run in hand.
    pub(super) fn go_on(&mut self) -> Outcome<()> {
        match self.run.take() {
            None => Ok(()),
            Some(Run::Holes(run)) => self.next_hole(run),
            Some(Run::Moves(mut run)) => {
                if let Some(next) = run.moves.next() {
                    self.make_move(&next, &run);
                    self.run = Some(Run::Moves(run));
                } else if let Some(S) = run.blocks.last().and_then(|block| block.speed).filter(|_| run.speeds) {
                    self.modal.speed = S;
                }
                Ok(())
            }
        }
    }

    /// Makes all that is left of the run in hand.
    pub(super) fn finish_run(&mut self) -> Outcome<()> {
        while self.run.is_some() {
            self.go_on()?;
        }
        Ok(())
    }

    fn make_move(&mut self, next: &Move, run: &Moves) {
        let (line, n) = (self.line, self.block.n);
        let mut side = Compensation::Off;
        if let Some(of) = next.line {
            self.line = of;
            let block = run.blocks.binary_search_by_key(&of, |block| block.line).ok();
            let block = block.and_then(|at| run.blocks.get(at));
            self.block.n = block.and_then(|block| block.n);
            // Finishing follows the contour with the nose; other passes are made as they are.
            side = block.map(|block| block.side).filter(|_| run.speeds).unwrap_or_default();
            if let Some(S) = block.and_then(|block| block.speed).filter(|_| run.speeds) {
                self.modal.speed = S;
            }
        }
        self.compensator.cycle = Some(side);
        let mut to = self.current;
        to.set(Axis::X, next.to[0]);
        to.set(Axis::Z, next.to[1]);
        let own = |own: Option<f64>| Feed { value: own.unwrap_or(run.feed.value), ..run.feed };
        if run.speeds
            && let Way::Feed(Some(feed)) | Way::Arc { feed: Some(feed), .. } = next.way
        {
            self.modal.feed = feed;
        }
        match next.way {
            Way::Rapid => self.emit(Kind::Rapid, to, None),
            Way::Feed(feed) => {
                let feed = own(feed);
                let seconds = self.straight_seconds(&to, feed);
                self.emit(Kind::Feed(feed), to, seconds);
            }
            Way::Arc { centre, clockwise, feed } => {
                let feed = own(feed);
                let arc = self.arc_to(&to, centre, clockwise);
                let seconds = if self.by_revolution(feed) {
                    self.turned_arc_seconds(&arc, feed)
                } else {
                    self.seconds(arc.length(0.0), feed)
                };
                self.emit(Kind::Arc(arc, feed), to, seconds);
            }
            Way::Thread(thread) => {
                let seconds = self.thread_seconds(&to, &thread);
                self.emit(Kind::Thread(thread), to, seconds);
            }
            Way::Dwell(seconds) => self.emit(Kind::Dwell(seconds), self.current, Some(seconds)),
        }
        self.compensator.cycle = None;
        (self.line, self.block.n) = (line, n);
    }

    /// The arc in the plane ZX from here to a pose about a centre `[X, Z]`.
    fn arc_to(&self, to: &Pose, centre: [f64; 2], clockwise: bool) -> Arc {
        let centre = [centre[1], centre[0]];
        let of = |pose: &Pose| [pose.get(Axis::Z) - centre[0], pose.get(Axis::X) - centre[1]];
        let ([a, b], [c, d]) = (of(&self.current), of(to));
        let between = trig::atan2(a * d - b * c, a * c + b * d);
        let turns = if clockwise { -1 } else { 1 };
        Arc {
            plane: Plane::ZX,
            centre,
            turns,
            radius: trig::hypot(a, b),
            sweep: super::arc::sweep(turns, between),
            rotation: self.frame.work.rotation,
        }
    }
}
