//! The moves of a cycle as they are made, one after another.

use crate::gcode::turning::profile::Element;
use crate::gcode::turning::scan::{Leg, PassFrame, same};
use crate::gcode::turning::{Move, MoveKind};

/// The tool of a cycle in its drawing: where it stands, and the moves that brought it there.
pub(super) struct CycleMoves {
    frame: PassFrame,
    /// Where it stands, `[u, v]`.
    pub at: [f64; 2],
    /// The moves, in program coordinates.
    pub moves: Vec<Move>,
}

impl CycleMoves {
    /// A tool that stands at a point, `[X, Z]`.
    pub fn new(frame: PassFrame, at: [f64; 2]) -> Self {
        Self { frame, at: frame.inward(at), moves: Vec::new() }
    }

    /// Goes somewhere, unless it is there.
    fn go(&mut self, to: [f64; 2], kind: MoveKind, line: Option<usize>) {
        if !same(self.at, to) {
            self.moves.push(Move { kind, to: self.frame.outward(to), line });
            self.at = to;
        }
    }

    /// Goes to `[u, v]` at rapid.
    pub fn rapid(&mut self, to: [f64; 2]) {
        self.go(to, MoveKind::Rapid, None);
    }

    /// Goes straight to `[u, v]` at feed, with this F, or with the cycle's where there is none.
    pub fn feed(&mut self, to: [f64; 2], feed: Option<f64>) {
        self.go(to, MoveKind::Feed(feed), None);
    }

    /// Some seconds of standing still.
    pub fn wait(&mut self, seconds: f64) {
        if seconds > 0.0 {
            self.moves.push(Move { kind: MoveKind::Dwell(seconds), to: self.frame.outward(self.at), line: None });
        }
    }

    /// Along the contour.
    pub fn follow(&mut self, legs: &[Leg], lines: &[Element], feed: Option<f64>) {
        for leg in legs {
            let line = lines.get(leg.element).map(|element| element.line);
            let kind = match leg.round {
                None => MoveKind::Feed(feed),
                Some(round) => MoveKind::Arc {
                    centre: self.frame.outward(round.centre),
                    clockwise: round.counter == self.frame.mirrors(),
                    feed,
                },
            };
            self.go(leg.to, kind, line);
        }
    }

    /// An element of a contour, in program coordinates: at its own rapid, or at a feed.
    pub fn element(&mut self, element: &Element, feed: Option<f64>) {
        let kind = match element.arc {
            Some((centre, clockwise)) => MoveKind::Arc { centre, clockwise, feed },
            None if element.rapid => MoveKind::Rapid,
            None => MoveKind::Feed(feed),
        };
        self.go(self.frame.inward(element.to), kind, Some(element.line));
    }
}
