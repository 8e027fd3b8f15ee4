//! Clearance to the stock where the tool does not cut: at the safe points, while it crosses from one side to the other,
//! and in rapid moves.
//!
//! The tool is a cylinder of its diameter and as long as any part of it could reach the stock; its holder and what holds the
//! part are not known here. The stock is the turned blank before anything is milled, whatever of it was cut by then. A lower
//! and an upper bound of the distance hold over the whole of a move ([`outside`](crate::kinds::impeller::outside)); a pass is
//! only taken as one where the lower bound says so. The nearest move is told; of the others it is proved that they are farther.
//!
//! What a pass may lack of the safety distance is what rounding to the grid takes: safe points and retract height are made
//! for d_s exactly, and 0.0005 mm in each of X, Y and Z and 0.0005° of B, at the distance of the stock's farthest point from
//! the pivot, may bring the tool nearer. It is reported beside the limit.
//!
//! # Units
//! Millimetres and radians.

use crate::finding::{Figures, Limit, Raise, Size};
use crate::gcode::program::Program;
use crate::kinds::impeller::clearance::Stand;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::outside::{Bounds, CLOSE, Outside, WORK};
use crate::kinds::impeller::proof::rules::{ToolInStock, ToolMayBeInStock, ToolMayBeNearStock, ToolNearStock};
use crate::kinds::impeller::proof::track_step::{TrackStep, clear};
use crate::machine::axis::{Axis, Pose};
use crate::number::grid::HALF;
use crate::proof::check::{At, Check, Question, bounded, mm};
use crate::proof::step::{Judge, Step};
use crate::text::{Text, t};

/// Moves are judged as one whose axes stand this close, mm or degrees: above what sums of increments lose, far below the grid.
const ALIKE: f64 = 1e-6;

/// Places on the tool's end and side from which a move is first looked at.
const GLANCE: usize = 2;

/// A move without C, and what is known of its distance.
pub type BoundedMove = ([f64; 8], Bounds);

/// Watches the moves outside the part. Moves that differ in C alone are judged once, over all programs.
#[derive(Debug)]
pub struct Clear<'a> {
    outside: Outside,
    d_s: f64,
    known: &'a mut Vec<BoundedMove>,
    safe: Option<(Bounds, At)>,
    /// The moves that differ, each where it is met first.
    moves: Vec<(RoundedMove, At)>,
}

/// A move without C, on a grid far finer than that of programs, and its ends.
#[derive(Clone, Copy, Debug)]
struct RoundedMove {
    key: [f64; 8],
    ends: [Stand; 2],
}

impl RoundedMove {
    fn new(from: &Pose, to: &Pose) -> Self {
        let mut key = [0.0; 8];
        let axes = [Axis::X, Axis::Y, Axis::Z, Axis::B];
        for (place, value) in key.iter_mut().zip([from, to].iter().flat_map(|pose| axes.map(|axis| pose.get(axis)))) {
            *place = (value / ALIKE).round();
        }
        Self { key, ends: [from, to].map(Stand::from) }
    }
}

impl<'a> Clear<'a> {
    /// The judge of a design's programs with a tool of a diameter, with what is known from other programs.
    #[must_use]
    pub const fn new(design: &Design, d: f64, known: &'a mut Vec<BoundedMove>) -> Self {
        Self { outside: Outside::of(design, d), d_s: design.d_s, known, safe: None, moves: Vec::new() }
    }

    /// By how much axes that are all off by at most some mm or degrees bring the tool nearer to the stock.
    fn nearer(&self, off: f64) -> f64 {
        off * 3.0_f64.sqrt() + off.to_radians() * self.outside.stock.reach(self.outside.L)
    }

    /// What is known already of the distance along a move.
    fn known(&self, rounded: &RoundedMove) -> Option<Bounds> {
        self.known.iter().find(|(known, _)| *known == rounded.key).map(|(_, bounds)| *bounds)
    }

    fn distance(&mut self, rounded: &RoundedMove) -> Bounds {
        if let Some(bounds) = self.known(rounded) {
            return bounds;
        }
        let [from, to] = &rounded.ends;
        let found = self.outside.along(from, to, WORK);
        let bounds = Bounds { lower: found.lower - self.nearer(ALIKE), ..found };
        self.known.push((rounded.key, bounds));
        bounds
    }

    /// The least distance over all moves, and the first of them that comes so near. Those that seem nearest are looked at first:
    /// of most others it is soon known that they are farther.
    fn nearest(&mut self) -> Option<(Bounds, At)> {
        let moves = std::mem::take(&mut self.moves);
        let glance =
            |(rounded, _): &(RoundedMove, At)| self.outside.along(&rounded.ends[0], &rounded.ends[1], GLANCE).upper;
        let mut order: Vec<(f64, usize)> = moves.iter().map(glance).zip(0..).collect();
        order.sort_by(|one, other| one.0.total_cmp(&other.0));
        let (mut least, mut found) = (f64::INFINITY, vec![None; moves.len()]);
        for (_, at) in order {
            let (rounded, _) = &moves[at];
            let [from, to] = &rounded.ends;
            let known = self.known(rounded).is_some() || least == f64::INFINITY;
            if known || !self.outside.is_farther(from, to, least, WORK) {
                let bounds = self.distance(rounded);
                least = least.min(bounds.lower);
                found[at] = Some(bounds);
            }
        }
        let mut nearest = None;
        for ((_, at), bounds) in moves.into_iter().zip(found) {
            bounds.into_iter().for_each(|bounds| lower(&mut nearest, bounds, at));
        }
        nearest
    }

    /// The answer on the least distance of a program.
    fn judged(&self, asked: Question, program: &Program, bounds: Bounds, line: usize) -> Check {
        let Bounds { lower, upper, .. } = bounds;
        let program = program.title.clone();
        let down = |length: f64| Size::mm((length * 1000.0 + 1e-6).floor() / 1000.0);
        asked.holds(lower >= self.d_s - self.nearer(HALF), |place| {
            if upper < 0.0 {
                ToolInStock { depth: down(-upper), line, program }.at(place)
            } else if lower.is_nan() || lower < 0.0 {
                ToolMayBeInStock { line, program }.at(place)
            } else if upper - lower <= 2.0 * CLOSE {
                ToolNearStock { distance: down(lower), line, program }.at(place)
            } else {
                ToolMayBeNearStock { distance: down(lower), line, program }.at(place)
            }
        })
    }
}

fn lower(least: &mut Option<(Bounds, At)>, bounds: Bounds, at: At) {
    if least.is_none_or(|(known, _)| bounds.lower < known.lower || bounds.lower.is_nan()) {
        *least = Some((bounds, at));
    }
}

impl Judge for Clear<'_> {
    fn see(&mut self, step: &Step<'_>) {
        let (motion, at) = (&step.motion, At::motion(&step.motion));
        if clear(step) {
            let rounded = RoundedMove::new(&motion.from, &motion.to);
            if !self.moves.iter().any(|(known, _)| known.key == rounded.key) {
                self.moves.push((rounded, at));
            }
        } else if let Some(cut) = TrackStep::of(step) {
            let safe = match cut.points {
                [None, Some(_)] => &motion.from,
                [None, None] => &motion.to,
                _ => return,
            };
            let distance = self.distance(&RoundedMove::new(safe, safe));
            lower(&mut self.safe, distance, at);
        }
    }

    fn checks(mut self: Box<Self>, program: &Program) -> Vec<Check> {
        let moves = self.nearest();
        let rows = [
            (
                "safe-points",
                t("Holgura al bruto en los puntos de seguridad", "Clearance to the stock at the safe points"),
                self.safe,
            ),
            (
                "clear-moves",
                t("Holgura al bruto al cruzar y en rápido", "Clearance to the stock in crossing and rapid moves"),
                moves,
            ),
        ];
        let (d_s, rounding) = (mm(self.d_s), mm((self.nearer(HALF) * 1e4).ceil() / 1e4));
        let limit = Text::new(
            format!("{d_s}, menos hasta {rounding} del redondeo"),
            format!("{d_s}, less up to {rounding} of rounding"),
        );
        let found = rows.into_iter().filter_map(|(key, name, found)| Some((key, name, found?)));
        let judged = |(key, name, (bounds, at)): (_, _, (Bounds, At))| {
            let value = bounded(bounds.lower, bounds.upper);
            let asked = Question::new(key, name, program).showing(value, limit.clone()).at(Some(at)).seen(1);
            let asked = asked.comparing(Figures::of(bounds.lower, Some(Limit::AtLeast(self.d_s))));
            self.judged(asked, program, bounds, at.line)
        };
        found.map(judged).collect()
    }
}
