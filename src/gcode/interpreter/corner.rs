//! `,C` and `,R`, and I, K and R on a line along one axis: the corner between the line of a block and that of the next is chamfered
//! or rounded.
//!
//! The line is held back until the next block says where the path goes on; then it is made as far as the corner's edge, and the edge
//! with the words of its own block. Increments of the next block count from the corner itself.
//!
//! # What may follow
//! The next block with words is a line at feed: no arc, no rapid motion, nothing without motion. Else the control would raise an
//! alarm, or guess.
//!
//! # References
//! Fanuc Series 0i-T, operator's manual, direct drawing dimensions programming; see [`crate::gcode::turning::edge`].

use crate::finding::{AlarmFamily, Raise};
use crate::gcode::code::{G, Group, M};
use crate::gcode::interpreter::block::{Block, EdgeWord, letter};
use crate::gcode::interpreter::library::Spot;
use crate::gcode::interpreter::modal::Modal;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::interpreter::{Reader, State};
use crate::gcode::letters::Letters;
use crate::gcode::motion::Feed;
use crate::gcode::turning::edge::{Broken, Edge, Square, broken};
use crate::gcode::turning::rules::{CornerBeforeNoMotion, CornerBeforeOtherMotion, CornerTwice, CornerWithoutLine};
use crate::gcode::turning::trouble::Trouble;
use crate::gcode::turning::{Move, MoveKind};
use crate::machine::axis::{Axis, Pose};
use crate::machine::length_unit::LengthUnit;
use crate::text::Text;

const AXES: u32 = Letters::of("UWXZ").mask();

/// A line whose end is to be broken.
#[derive(Debug)]
pub(super) struct Corner {
    word: EdgeWord,
    edge: Edge,
    spot: Spot,
    from: Pose,
    feed: Feed,
    /// What was in force in its block.
    modal: Modal,
}

impl EdgeWord {
    /// How the corner is broken; mm.
    pub(super) const fn edge(&self, unit: LengthUnit) -> Edge {
        let size = unit.to_mm(self.value);
        if self.round { Edge::Round(size) } else { Edge::Chamfer(size) }
    }

    /// A refusal at the corner's own line, with the alarm of the control's family.
    pub(super) fn refusal(&self, line: usize, row: &dyn Raise, family: Option<AlarmFamily>) -> Box<Refused> {
        let fault = Refused::of(row, &[self.column]).as_alarm_of(family);
        Box::new(Refused { line, ..*fault })
    }

    /// The refusal of a corner that cannot be broken.
    pub(super) fn trouble(&self, line: usize, trouble: &Trouble, family: Option<AlarmFamily>) -> Box<Refused> {
        let (name, Text { es, en }) = (self.name, &trouble.what);
        let what = Text::new(format!("{es} ({name})"), format!("{en} ({name})"));
        let fault = Refused::from(Trouble { what, line: Some(line), ..trouble.clone() });
        Box::new(Refused { columns: vec![self.column + 1], ..fault }).as_alarm_of(family)
    }

    /// The refusal of a corner behind which no line at feed comes.
    pub(super) fn alone(&self, line: usize, motion: bool, family: Option<AlarmFamily>) -> Box<Refused> {
        let word = self.name;
        if motion {
            self.refusal(line, &CornerBeforeOtherMotion { word }, family)
        } else {
            self.refusal(line, &CornerBeforeNoMotion { word }, family)
        }
    }
}

impl Block {
    /// True where the block says nothing.
    pub(super) const fn says_nothing(&self) -> bool {
        self.present == 0 && self.groups == 0 && self.machine_codes == 0 && self.edge.is_none()
    }
}

impl Reader<'_, '_> {
    /// Refuses `,C` and `,R` of the block in hand beside anything but a line at feed.
    pub(super) fn edge_fits(&self, motion: Option<G>) -> Result<()> {
        let Some(word) = self.block.edge else { return Ok(()) };
        let line = motion == Some(G::Linear) && self.block.present & AXES != 0;
        if line && self.block.g(Group::NonModal).is_none() {
            return Ok(());
        }
        Err(without_line(word.name, word.column))
    }

    /// I, K or R of a line at feed in hand becomes its edge.
    pub(super) fn take_square_edge(&mut self, motion: Option<G>) -> Result<()> {
        let line = motion == Some(G::Linear) && self.block.present & AXES != 0;
        if !self.memory.control.corners.by_words() || !line || self.block.g(Group::NonModal).is_some() {
            return Ok(());
        }
        for (letter, name, axis) in [(letter::I, "I", Some(0)), (letter::K, "K", Some(1)), (letter::R, "R", None)] {
            let column = self.block.column(letter);
            let Some(value) = self.block.take(letter).filter(|&value| value != 0.0) else { continue };
            let square = Some(Square { axis, toward: 1.0_f64.copysign(value) });
            let word = EdgeWord { name, round: axis.is_none(), value: value.abs(), square, column, pointless: false };
            if let Some(first) = self.block.edge.replace(word) {
                let twice = CornerTwice { first: first.name, second: name };
                return Err(Refused::of(&twice, &[first.column, column]).as_alarm_of(self.alarms()));
            }
        }
        Ok(())
    }

    /// Refuses the corner where the block in hand does not go on from it with a line at feed; the block itself is executed.
    pub(super) fn corner_goes_on(&mut self) {
        let block = &self.block;
        if self.memory.out.corner.is_none() || block.says_nothing() {
            return;
        }
        let allowed = [Group::Motion, Group::CutterCompensation, Group::Speed, Group::Feed];
        let other = block.groups & !allowed.into_iter().fold(0, |groups, group| groups | 1 << group as u16);
        let moves = other == 0 && block.present & AXES != 0;
        let goes_on = moves
            && block.g(Group::Motion).unwrap_or(self.state.modal.motion) == G::Linear
            && !block.has(letter::T)
            && matches!(block.m(4), None | Some((M::Pause, _)));
        if !goes_on {
            self.lose_corner(moves);
        }
    }

    /// The program does not go on from a corner: its line is made whole, and the corner refused.
    pub(super) fn lose_corner(&mut self, motion: bool) {
        if let Some(corner) = self.memory.out.corner.take() {
            let fault = corner.word.alone(corner.spot.line, motion, self.alarms());
            self.refuse_corner(corner, fault);
        }
    }

    /// Hands out the refusal of a corner, and its line, which is made whole. The program goes on.
    fn refuse_corner(&mut self, corner: Corner, mut fault: Box<Refused>) {
        fault.file = self.memory.library.file(corner.spot.text).cloned();
        self.memory.out.queue.push_back(Err(fault));
        self.make_corner(corner, None);
    }

    /// The line of a corner is made whole, as what should follow it is refused.
    pub(super) fn leave_corner(&mut self) {
        if let Some(corner) = self.memory.out.corner.take() {
            self.make_corner(corner, None);
        }
    }

    /// A line at feed, behind a corner and before one.
    pub(super) fn line_at_feed(&mut self, to: Pose, feed: Feed) -> Result<()> {
        if let Some(corner) = self.memory.out.corner.take() {
            let points = [corner.from, self.state.at, to].map(|pose| point(&pose));
            match broken(points, corner.edge, corner.word.square) {
                Ok(broken) => self.make_corner(corner, broken),
                Err(trouble) => {
                    let fault = corner.word.trouble(corner.spot.line, &trouble, self.alarms());
                    self.refuse_corner(corner, fault);
                }
            }
        }
        let way = Move { kind: MoveKind::Feed(None), to: point(&to), line: None };
        let Some(word) = self.block.edge else { return self.make_way(&way, Some(feed)) };
        self.memory.out.corner = Some(Corner {
            word,
            edge: word.edge(self.state.modal.unit),
            spot: self.block.spot,
            from: self.state.at,
            feed,
            modal: self.state.modal.clone(),
        });
        self.state.at = to;
        Ok(())
    }

    /// Makes the line up to a corner that was held back, and its edge, as in its own block and with what was in force there.
    fn make_corner(&mut self, corner: Corner, broken: Option<Broken>) {
        let whole = point(&self.state.at);
        let mut block = Block::at(corner.spot);
        let mut state = State { modal: corner.modal, frame: self.state.frame, at: corner.from };
        let mut reader = Reader { memory: &mut *self.memory, block: &mut block, state: &mut state };
        let straight = |to| Move { kind: MoveKind::Feed(None), to, line: None };
        let end = broken.map_or(whole, |broken| broken.from);
        let edge = broken.map(|Broken { to, arc, .. }| match arc {
            None => straight(to),
            Some((centre, clockwise)) => Move { kind: MoveKind::Arc { centre, clockwise, feed: None }, to, line: None },
        });
        let line_before = (end != point(&corner.from)).then(|| straight(end));
        for way in line_before.into_iter().chain(edge) {
            // A motion at a feed that is given is never refused.
            let _ = reader.make_way(&way, Some(corner.feed));
        }
        self.state.at = state.at;
    }
}

/// The refusal of a word of a corner whose block is no line at feed.
pub(super) fn without_line(name: &str, column: usize) -> Box<Refused> {
    Refused::of(&CornerWithoutLine { word: name.to_owned() }, &[column])
}

/// A pose as `[X, Z]`.
fn point(pose: &Pose) -> [f64; 2] {
    [pose.get(Axis::X), pose.get(Axis::Z)]
}
