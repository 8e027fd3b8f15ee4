//! One motion of a tool in the metal: what its cutter takes away piece by piece, and where the rest of it goes.

use super::alarm::{Cause, Moving, TOUCH};
use super::boring::Hole;
use super::contact::{Contact, Ride, depth, far_end};
use super::detached::judged;
use super::motion_totals::{Tally, collide};
use super::outline::{Outline, Part};
use super::path::{self, Piece};
use super::retraction::Scraped;
use super::spindle::{begun, extent, revolutions, ribs};
use super::stock::Fixture;
use super::surface_origin::{Chain, SweptPiece};
use super::tool::{Cutter, TurningTool};
use super::workpiece::{Removed, TURN, Workpiece};
use crate::gcode::in_force::InForce;
use crate::gcode::motion::{MotionKind, Thread};
use crate::geometry::exact::convex::Convex;
use crate::geometry::exact::grid::Point;
use crate::number::trig::hypot;

/// Ways of tools are cut off at this distance from the middle of the blank, mm: with what a tool reaches they stay on the
/// grid, and past it no tool reaches the blank.
pub(super) const WITHIN: f64 = 780.0;

/// A tool made ready.
#[derive(Clone, Debug)]
pub(super) struct Ready {
    pub tool: TurningTool,
    pub outline: Outline,
    /// Of the turret, where they move with the tool.
    pub bodies: Vec<Convex>,
}

/// Where a thread's pass has come to.
#[derive(Clone, Copy, Debug)]
pub(super) struct Led {
    tool: u32,
    /// On the grid, `[z, r]`.
    at: [f64; 2],
    /// What is left of the revolution that has begun, as a share.
    left: f64,
}

impl Led {
    /// True where a tool goes on from here.
    pub fn leads(&self, tool: u32, from: [f64; 2]) -> bool {
        self.tool == tool && near(self.at, from)
    }
}

/// A motion of one tool in the part.
pub(super) struct Engagement<'a, 'm> {
    /// The tool's place.
    pub place: u32,
    pub ready: &'a Ready,
    pub fixtures: &'a [(Fixture, Convex)],
    pub part: &'a mut Workpiece,
    /// What made the part's surfaces.
    pub chain: &'a mut Chain,
    pub contact: &'a mut Contact,
    pub tally: &'a mut Tally<'m>,
    /// Kept so as not to allocate for each motion.
    pub swept: &'a mut Convex,
    pub removed: Removed,
    /// The metal that a rapid motion met.
    pub scraped: Option<Scraped>,
}

/// A straight piece of a tool's way.
#[derive(Clone, Copy)]
struct Straight {
    first: Point,
    last: Point,
    /// The same places, mm.
    ends: Piece,
    /// Of length 1, `[z, r]`.
    way: [f64; 2],
}

impl Engagement<'_, '_> {
    /// Cuts the rings of a thread. `led` is where its pass has come to.
    pub fn thread(&mut self, thread: Thread, pieces: &[Piece], led: &mut Option<Led>) {
        for &piece in pieces {
            // Blocks of a thread that follow one another go on in its revolution; a new pass at its angle.
            let goes_on = led.filter(|led| led.leads(self.place, piece[0]));
            let left = goes_on.map_or_else(|| begun(thread), |led| led.left);
            // A place out of the grid is a step too.
            for at in ribs(thread, piece, left) {
                if !self.part.spend(TURN) {
                    break;
                }
                self.ring(at);
            }
            let length = extent(piece);
            let turned = revolutions(thread, length).unwrap_or(0.0) - left;
            let left = if thread.lead > 0.0 { turned.ceil() - turned } else { 0.0 };
            *led = Some(Led { tool: self.place, at: piece[1], left });
        }
    }

    /// Cuts a ring where the tool stands while the spindle turns.
    pub fn ring(&mut self, at: [f64; 2]) {
        let Some(at) = Point::near(at) else { return };
        let Self { ready, part, contact, tally, swept, removed, .. } = self;
        for cutter in &ready.outline.cutter {
            if cutter.polygon.sweep(at, at, swept) {
                removed.add(part.cut_rib(swept, |meeting, mirrored, _| {
                    let ride = Ride { part: cutter, from: at.mm(), way: [1.0, 0.0], mirrored };
                    if let Some(bite) = contact.add_rib(meeting, &ride) {
                        tally.met(bite, [at.mm(); 2], mirrored);
                        tally.weigh(meeting, mirrored);
                    }
                }));
            }
        }
    }

    /// Takes away what the tool sweeps along a piece of its way, and looks where the rest of it goes.
    pub fn along(&mut self, piece: Piece) {
        let [from, to] = piece;
        let Some([first, last]) = path::on_grid(piece, WITHIN) else { return };
        let long = hypot(to[0] - from[0], to[1] - from[1]);
        let way = [(to[0] - from[0]) / long, (to[1] - from[1]) / long];
        let straight = Straight { first, last, ends: [first.mm(), last.mm()], way };
        let ready = self.ready;
        let hole = match self.tally.motion.kind {
            MotionKind::Rapid => None,
            _ => Hole::before(self.part, &ready.tool, &ready.outline, straight.ends),
        };
        if let Some(hole) = hole.filter(Hole::is_solid) {
            self.contact.solid = self.contact.solid.or(hole.cause());
        }
        for cutter in &ready.outline.cutter {
            self.cutter(cutter, &straight);
        }
        let holder = ready.outline.holder.iter().map(|body| (Moving::Holder, body));
        for (moving, body) in holder.chain(ready.bodies.iter().map(|body| (Moving::Turret, body))) {
            self.body(moving, body, &straight, hole);
        }
        let loose = self.part.drop_loose(|ring| judged(&ready.tool.cutter, &ready.outline.cutter, straight.ends, ring));
        self.removed.add(loose);
    }

    /// Takes away what a part of the cutter sweeps. A thread's is cut ring by ring, see [`Self::thread`].
    fn cutter(&mut self, cutter: &Part, &Straight { first, last, ends, way }: &Straight) {
        let Self { ready, fixtures, part, chain, contact, tally, swept, removed, scraped, .. } = self;
        if !cutter.polygon.sweep(first, last, swept) {
            return;
        }
        collide(fixtures, swept, Moving::Cutter, tally);
        if matches!(tally.motion.kind, MotionKind::Thread(_)) {
            return;
        }
        let rapid = tally.motion.kind == MotionKind::Rapid;
        let insert = matches!(ready.tool.cutter, Cutter::Insert { .. });
        removed.add(part.cut(swept, |meeting, mirrored, labels| {
            if rapid {
                let (deep, place) = depth(meeting);
                if deep > TOUCH {
                    let place = if mirrored { [place[0], -place[1]] } else { place };
                    Scraped::take(scraped, meeting, deep, place);
                }
                return;
            }
            let ride = Ride { part: cutter, from: first.mm(), way, mirrored };
            if let Some(bite) = contact.add(meeting, &ride) {
                tally.met(bite, ends, mirrored);
                tally.weigh(meeting, mirrored);
            }
            if insert && !mirrored {
                let pass = SweptPiece { part: cutter, meeting, way, ends };
                let alarm = |deep, place| tally.alarm(Cause::BackCutting, place, Some(deep));
                chain.label(pass, alarm, |at| far_end(meeting, &ride, at), labels);
            }
        }));
    }

    /// Looks where the holder or the turret goes, which cut nothing. `hole` is the one in front of a boring bar.
    fn body(&mut self, moving: Moving, body: &Convex, straight: &Straight, hole: Option<Hole>) {
        let Self { fixtures, part, tally, swept, .. } = self;
        if !body.sweep(straight.first, straight.last, swept) {
            return;
        }
        collide(fixtures, swept, moving, tally);
        part.probe(swept, |meeting, _| {
            let (deep, place) = depth(meeting);
            if deep > TOUCH {
                let ahead = hole.filter(|hole| moving == Moving::Holder && place[0] < hole.end + TOUCH);
                let cause = ahead.and_then(|hole| hole.cause()).unwrap_or(Cause::BodyInMetal(moving));
                tally.raise(cause, place, Some(deep));
            }
        });
    }

    /// Ends it: gives what was taken away, and tells what a rapid motion met; `leaves` is whether the tool leaves its work
    /// along these `pieces`.
    pub fn end(self, leaves: bool, pieces: &[Piece], control: &InForce) -> Removed {
        if let Some(scraped) = self.scraped {
            let cause = scraped.cause(&self.ready.tool, leaves, pieces, control);
            self.tally.raise(cause, scraped.place, Some(scraped.deep));
        }
        self.removed
    }
}

pub(super) fn near(one: [f64; 2], two: [f64; 2]) -> bool {
    hypot(two[0] - one[0], two[1] - one[1]) < TOUCH
}
