//! Motions that one block makes many of: the holes of a canned cycle, the moves of a turning cycle.

use crate::gcode::code::{Cycle, G, Group};
use crate::gcode::in_force::Compensation;
use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block::Block;
use crate::gcode::interpreter::contour::ContourBlock;
use crate::gcode::interpreter::library::Spot;
use crate::gcode::interpreter::refused::Result;
use crate::gcode::motion::{Arc, Feed, MotionKind, Plane};
use crate::gcode::turning::{Move, MoveKind};
use crate::machine::axis::{Axis, Pose};
use crate::number::trig;

/// What the block in hand has still to do.
#[derive(Debug)]
pub(super) enum Pending {
    /// Holes of a canned cycle.
    Holes(Holes),
    /// Moves of a turning cycle.
    Moves(Box<Moves>),
}

/// The holes of a block that are still to be made. Lengths are mm; heights lie on the axis across the plane.
#[derive(Clone, Debug)]
pub(super) struct Holes {
    pub(super) cycle: Cycle,
    /// How many holes are left.
    pub(super) left: i64,
    /// None has been made.
    pub(super) first: bool,
    /// From one hole to the next, in the plane.
    pub(super) step: [f64; 2],
    /// Where the hole in hand is, in the plane; before the first one a step short of it.
    pub(super) at: [f64; 2],
    /// The height of R.
    pub(super) r: f64,
    /// The height of the bottom.
    pub(super) bottom: f64,
    /// The height that the tool goes back to.
    pub(super) clear: f64,
    /// The dwell at the bottom, s; 0 for none.
    pub(super) p: f64,
    /// The depth of a peck; 0 in a cycle without.
    pub(super) q: f64,
    /// G87: how far aside the tool enters, in the plane.
    pub(super) offset: [f64; 2],
    /// G87: the height of the upper face.
    pub(super) middle: f64,
    /// The feed in force.
    pub(super) feed: Feed,
}

/// The moves of a turning cycle that are still to be made.
#[derive(Debug)]
pub(super) struct Moves {
    moves: std::vec::IntoIter<Move>,
    /// The feed of those that do not say their own; `None` for finishing, which goes at what is in force.
    feed: Option<Feed>,
    /// The cycle's own block, whose moves are not compensated.
    own: Block,
    /// The blocks of the contour that the moves may name, in the order of their lines.
    blocks: Vec<ContourBlock>,
    /// How many of them have been obeyed.
    obeyed: usize,
    /// The next of them has been obeyed up to its motions, of which one is made.
    begun: bool,
}

impl<'a> Reader<'_, 'a> {
    /// Turns the moves of a cycle into motions, one after another as they are asked for.
    pub(super) fn make_moves(&mut self, moves: Vec<Move>, feed: Feed) {
        self.make_contour_moves(moves, feed, Vec::new());
    }

    /// The same for moves that name blocks of a contour, whose words are passed over.
    pub(super) fn make_contour_moves(&mut self, moves: Vec<Move>, feed: Feed, blocks: Vec<ContourBlock>) {
        self.remark_uncompensated(&blocks);
        self.run_moves(moves, Some(feed), blocks);
    }

    /// The same for moves along a contour whose blocks are obeyed on the way.
    pub(super) fn finish_contour(&mut self, moves: Vec<Move>, blocks: Vec<ContourBlock>) {
        self.run_moves(moves, None, blocks);
    }

    fn run_moves(&mut self, moves: Vec<Move>, feed: Option<Feed>, blocks: Vec<ContourBlock>) {
        let own = self.block.of_cycle(Compensation::Off);
        let moves = Moves { moves: moves.into_iter(), feed, own, blocks, obeyed: 0, begun: false };
        self.memory.out.run = Some(Pending::Moves(Box::new(moves)));
    }

    /// The feed of the moves that do not say their own: it need not be given where there are none.
    pub(super) fn feed_of(&mut self, moves: &[Move]) -> Result<Feed> {
        if moves.iter().any(|one| matches!(one.kind, MoveKind::Feed(None) | MoveKind::Arc { feed: None, .. })) {
            return self.feed();
        }
        Ok(Feed { mode: self.state.modal.feed_mode, value: self.state.modal.feed })
    }

    /// Makes the next motions of the run in hand.
    pub(super) fn go_on(&mut self) -> Result<()> {
        match self.memory.out.run.take() {
            None => Ok(()),
            Some(Pending::Holes(run)) => self.next_hole(run),
            Some(Pending::Moves(mut run)) => {
                let Some(next) = run.moves.next() else { return Ok(()) };
                match run.feed {
                    Some(feed) => self.make_move(&next, feed, &run)?,
                    None => self.finish_move(&next, &mut run)?,
                }
                self.memory.out.run = Some(Pending::Moves(run));
                Ok(())
            }
        }
    }

    /// Makes all that is left of the run in hand.
    pub(super) fn finish_run(&mut self) -> Result<()> {
        while self.memory.out.run.is_some() {
            self.go_on()?;
        }
        Ok(())
    }

    /// Reads on with another block in hand, on the same state.
    fn with<'s>(&'s mut self, block: &'s mut Block) -> Reader<'s, 'a> {
        Reader { memory: &mut *self.memory, block, state: &mut *self.state }
    }

    /// A move at the cycle's feed, and as it is: only finishing follows a contour with the nose.
    fn make_move(&mut self, next: &Move, feed: Feed, run: &Moves) -> Result<()> {
        let mut own = run.own.clone();
        if let Some(line) = next.line {
            let block = run.blocks.binary_search_by_key(&line, ContourBlock::line).ok();
            let n = block.and_then(|at| run.blocks.get(at)).and_then(|block| block.words.spot.n);
            own.spot = Spot { line, n, ..own.spot };
        }
        self.with(&mut own).make_way(next, Some(feed))
    }

    /// A move along the contour: the blocks up to its own are obeyed first. The last move is the cycle's own and goes back.
    fn finish_move(&mut self, next: &Move, run: &mut Moves) -> Result<()> {
        let until = next.line.unwrap_or(usize::MAX);
        while let Some(block) = run.blocks.get(run.obeyed).filter(|block| block.line() < until) {
            self.of_contour(block, |reader| {
                reader.obey_before()?;
                reader.obey_after()
            })?;
            run.obeyed += 1;
        }
        let Some(block) = run.blocks.get(run.obeyed).filter(|block| block.line() == until) else {
            return if next.line.is_none() { self.with(&mut run.own).make_way(next, None) } else { Ok(()) };
        };
        let begun = run.begun;
        // A corner makes more than one motion of a block.
        run.begun = run.moves.as_slice().first().is_some_and(|more| more.line == next.line);
        let whole = !run.begun;
        run.obeyed += usize::from(whole);
        self.of_contour(block, |reader| {
            if !begun {
                reader.obey_before()?;
            }
            reader.make_way(next, None)?;
            if whole { reader.obey_after() } else { Ok(()) }
        })
    }

    /// Does something with a block of a contour in hand. What is refused of it leaves the contour uncut.
    fn of_contour(&mut self, block: &ContourBlock, obey: impl FnOnce(&mut Reader<'_, 'a>) -> Result<()>) -> Result<()> {
        let mut words = block.words.of_cycle(block.side);
        obey(&mut self.with(&mut words)).map_err(|mut fault| {
            fault.line = if fault.line == 0 { block.line() } else { fault.line };
            fault.file = fault.file.or_else(|| self.memory.library.file(block.words.spot.text).cloned());
            fault.uncut = true;
            fault
        })
    }

    /// What a block of a contour puts into force before its motion, in the order of a block of the program.
    fn obey_before(&mut self) -> Result<()> {
        self.begin_codes()?;
        if let Some(G::Compensation(side)) = self.block.g(Group::CutterCompensation) {
            self.set_compensation(side)?;
        }
        Ok(())
    }

    /// What it puts out of force behind its motion.
    fn obey_after(&mut self) -> Result<()> {
        self.machine_codes_after()?;
        self.executed();
        Ok(())
    }

    /// The motion of a move, at a feed or at the one in force.
    pub(super) fn make_way(&mut self, next: &Move, feed: Option<Feed>) -> Result<()> {
        let mut to = self.state.at;
        to.set(Axis::X, next.to[0]);
        to.set(Axis::Z, next.to[1]);
        match next.kind {
            MoveKind::Rapid => self.emit(MotionKind::Rapid, to, None),
            MoveKind::Feed(own) => {
                let feed = self.feed_of_move(feed, own)?;
                let seconds = self.straight_seconds(&to, feed);
                self.emit(MotionKind::Feed(feed), to, seconds);
            }
            MoveKind::Arc { centre, clockwise, feed: own } => {
                let feed = self.feed_of_move(feed, own)?;
                let arc = self.arc_to(&to, centre, clockwise);
                let seconds = if self.by_revolution(feed) {
                    self.turned_arc_seconds(&arc, feed)
                } else {
                    self.seconds(arc.length(0.0), feed)
                };
                self.emit(MotionKind::Arc(arc, feed), to, seconds);
            }
            MoveKind::Thread(thread) => {
                self.remark_standing_spindle();
                let seconds = self.thread_seconds(&to, &thread);
                self.emit(MotionKind::Thread(thread), to, seconds);
            }
            MoveKind::Dwell(seconds) => self.emit(MotionKind::Dwell(seconds), self.state.at, Some(seconds)),
        }
        Ok(())
    }

    /// The feed of a move: its own in the meaning of the cycle's, the cycle's, or the one in force.
    fn feed_of_move(&mut self, feed: Option<Feed>, own: Option<f64>) -> Result<Feed> {
        let feed = feed.map_or_else(|| self.feed(), Ok)?;
        Ok(Feed { value: own.unwrap_or(feed.value), ..feed })
    }

    /// The arc in the plane ZX from here to a pose about a centre `[X, Z]`.
    fn arc_to(&self, to: &Pose, centre: [f64; 2], clockwise: bool) -> Arc {
        let centre = [centre[1], centre[0]];
        let of = |pose: &Pose| [pose.get(Axis::Z) - centre[0], pose.get(Axis::X) - centre[1]];
        let ([a, b], [c, d]) = (of(&self.state.at), of(to));
        let between = trig::atan2(a * d - b * c, a * c + b * d);
        let turns = if clockwise { -1 } else { 1 };
        Arc {
            plane: Plane::ZX,
            centre,
            turns,
            radius: trig::hypot(a, b),
            sweep: super::arc::sweep(turns, between),
            rotation: self.state.frame.work.rotation,
        }
    }
}
