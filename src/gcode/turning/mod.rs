//! Turning cycles: what a control makes of one cycle, as plain moves.
//!
//! Each cycle is a pure function from its parameters to moves. The interpreter reads the parameters from the words of a
//! dialect and turns the moves into motions.
//!
//! # Units
//! A point is `[X, Z]` in program coordinates, X the *radius*, mm. Angles count from +Z towards +X, so that G3 is
//! counter-clockwise in a drawing with Z to the right and X up.
//!
//! # What the rules rest on
//! The lathe simulator's text, the published turning program and the figures of LinuxCNC's own lathe programs are tested
//! against. Where the manuals of Fanuc and Fagor are named, their rules stand as they are known among programmers: no copy of
//! them could be compared with this code. What they leave open is named "Left open, and chosen here".

pub mod edge;
pub mod fagor;
pub mod finish;
pub mod groove;
pub mod nose;
pub mod pace;
pub mod pattern_repeating;
pub mod profile;
pub mod rough;
pub mod rules;
mod scan;
pub mod thread_cycle;
mod tool;
pub mod trouble;

use crate::gcode::motion::Thread;

/// How a move goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MoveKind {
    /// At rapid, straight or bent as the machine goes.
    Rapid,
    /// Straight at feed; with its own F (in the units of the feed mode in force, mm) or with the cycle's.
    Feed(Option<f64>),
    /// An arc of less than a full circle at feed.
    Arc {
        /// The centre, `[X, Z]`.
        centre: [f64; 2],
        /// G2.
        clockwise: bool,
        /// Its own F, as for [`MoveKind::Feed`].
        feed: Option<f64>,
    },
    /// A pass of a thread, led by the spindle.
    Thread(Thread),
    /// Not at all, for some seconds.
    Dwell(f64),
}

/// One move of an expanded cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Move {
    /// At rapid, at feed, as a thread, or standing still.
    pub kind: MoveKind,
    /// Where to, `[X, Z]`, mm, X on the radius.
    pub to: [f64; 2],
    /// The line of the block of a contour that it follows; `None` for the moves of the cycle's own block.
    pub line: Option<usize>,
}
