//! Nose radius compensation: G41 and G42 on a lathe.
//!
//! A turning tool ends in a circle, the nose; the program moves its imaginary tip. [`Stage`] takes the programmed path piece
//! by piece with the compensation in force and hands out the path of the imaginary tip on which the nose stays tangent to what is
//! programmed: the centre of the nose runs along the path offset by the nose radius R, and the tip is the centre plus R by
//! the vector of its [`Tip`]. It holds one piece back, since the next one says where it ends.
//!
//! # The rules
//! - Start-up: the first straight piece with a side ends with the nose at right angles to the start of the next piece.
//!   An arc cannot begin.
//! - Arcs keep their centre; the radius of the nose's centre is r ± R.
//! - Inner corners end where the offsets meet; outer corners go on straight or round ([`Stage::new`]), as [`corner`] says.
//! - The last piece before the end, and before a change of side, ends with the nose at right angles to its own end. A change
//!   of side goes straight from there to the other side of the next piece's start.
//! - End: the first piece without a side goes straight from there to its programmed end; an arc cannot end it.
//! - Rapid moves are compensated as straight ones. What makes no way in the plane is carried along in order.
//!
//! These are Fanuc's with start-up and cancel of type A and the linear connection of outer corners, and Fagor's with
//! COMPTYPE x1. Where both sides of a change have crossing offsets Fanuc ends the first at the crossing instead.
//!
//! # Units
//! Millimetres and radians; points `[Z, X]` with X the radius.
//!
//! # Refusals
//! [`Misfit`]: what cannot be cut with this nose. After one, pieces pass as programmed until the compensation ends.
//!
//! # References
//! Fanuc Series 0i-T and 16/18-T operator's manuals, tool nose radius compensation; Fagor CNC 8055 T programming manual, tool
//! radius compensation, and machine parameters COMPTYPE and COMPMODE; LinuxCNC, cutter compensation.

pub mod corner;
pub mod element;
mod gouge;
pub mod tip;

use std::f64::consts::PI;

pub use self::element::{Element, Path, Point};
pub use self::gouge::Gouge;
pub use self::tip::{Nose, Tip};
use crate::gcode::in_force::Compensation;
use crate::gcode::turning::nose::corner::{Corner, corner, offset_radius};
use crate::gcode::turning::nose::element::{distance, plus};
use crate::gcode::turning::nose::gouge::Trail;
use crate::limits::STILL_PIECES;

/// By how much the nose may be larger than an arc or a piece allows: the least increment of a program's coordinates, whose
/// rounding does not make a contour wrong; mm.
pub const ROUNDING: f64 = 0.001;

/// What keeps the nose from following the path. Lengths in mm, angles in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Misfit {
    /// The compensation begins on an arc.
    ArcEntry,
    /// The compensation ends on an arc.
    ArcExit,
    /// An inner arc is smaller than the nose.
    Arc {
        /// The nose radius.
        radius: f64,
        /// The radius of the arc.
        arc: f64,
    },
    /// The offsets of the pieces before and after an inner corner do not meet.
    Corner {
        /// The nose radius.
        radius: f64,
        /// By how much the path turns.
        turn: f64,
    },
    /// The nose would run backwards along a piece.
    Short {
        /// The nose radius.
        radius: f64,
        /// The length of the piece.
        length: f64,
        /// The length that the corners at its ends take.
        taken: f64,
    },
    /// The nose changes under compensation.
    Changed,
    /// More than [`STILL_PIECES`] pieces without way in a row.
    Still,
}

/// A piece of the programmed path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step<T> {
    /// The piece; its start is the end of the piece before.
    pub element: Element,
    /// The side of the path on which the nose is kept.
    pub side: Compensation,
    /// The nose of the tool that makes it.
    pub nose: Nose,
    /// It is made at rapid, which no arc is: the corner behind it is made of straight lines.
    pub rapid: bool,
    /// What the caller knows it by.
    pub tag: T,
}

/// A piece that is held back until the next one says where it ends.
struct PendingPiece<T> {
    step: Step<T>,
    /// 1 for left, −1 for right.
    s: f64,
    /// It brings the nose to the path.
    entry: bool,
    /// Where the offset begins; of the tip for an entry, else of the nose's centre.
    start: Point,
    /// How much of the element's start the offset leaves out: mm, radians for an arc.
    trim: f64,
    /// What follows without way.
    stills: Vec<Step<T>>,
}

enum State<T> {
    /// Nothing is compensated. The tip where it is not at the end of the last piece.
    Off(Option<Point>),
    Held(Box<PendingPiece<T>>),
    /// A misfit has been found: pieces pass as they are.
    Broken,
}

/// Nose radius compensation: pieces of the programmed path go in, pieces of the way of the imaginary tip come out.
pub struct Stage<T> {
    straight: f64,
    state: State<T>,
    trail: Trail<T>,
}

impl<T: Clone> Stage<T> {
    /// A stage with the compensation off. Outer corners that turn by up to `straight` (radians) are made of straight lines
    /// (π: all of them, as on a Fanuc as delivered), others of arcs about the corner (0: all of them).
    #[must_use]
    pub const fn new(straight: f64) -> Self {
        Self { straight, state: State::Off(None), trail: Trail::new() }
    }

    /// The cuts into pieces that are no neighbours, found since the last time they were asked for.
    pub fn cuts(&mut self) -> Vec<Gouge<T>> {
        std::mem::take(&mut self.trail.cuts)
    }

    /// True where a piece would pass as it is if it had no side.
    #[must_use]
    pub const fn idle(&self) -> bool {
        matches!(self.state, State::Off(None))
    }

    /// Takes in a piece and puts what can be placed behind `out`, in order. More than one piece can come of one; the moves
    /// round a corner belong to the piece before it.
    ///
    /// # Errors
    /// The misfit that the piece brings to light, with the tag of the piece that is wrong.
    pub fn push(&mut self, step: Step<T>, out: &mut Vec<(Element, T)>) -> Result<(), (Misfit, T)> {
        match std::mem::replace(&mut self.state, State::Broken) {
            State::Broken => {
                if step.side == Compensation::Off {
                    self.state = State::Off(None);
                }
                out.push((step.element, step.tag));
                Ok(())
            }
            State::Off(tip) => {
                let misfit;
                (self.state, misfit) = begin(step, tip, out);
                misfit.map_or(Ok(()), Err)
            }
            State::Held(held) => self.follow(*held, step, out),
        }
    }

    /// Places what is held back; the tip stays where that ends.
    ///
    /// # Errors
    /// As for [`Stage::push`].
    pub fn finish(&mut self, out: &mut Vec<(Element, T)>) -> Result<(), (Misfit, T)> {
        match std::mem::replace(&mut self.state, State::Off(None)) {
            State::Held(held) => {
                let before = out.len();
                let watched = held.watched();
                let (tip, misfit) = held.release_to_normal(out);
                self.watch(watched, out, before);
                self.trail.clear();
                self.state = State::Off(Some(tip));
                misfit.map_or(Ok(()), Err)
            }
            State::Off(tip) => {
                self.state = State::Off(tip);
                Ok(())
            }
            State::Broken => Ok(()),
        }
    }

    /// The piece after one that is held back.
    fn follow(
        &mut self,
        mut held: PendingPiece<T>,
        step: Step<T>,
        out: &mut Vec<(Element, T)>,
    ) -> Result<(), (Misfit, T)> {
        let Some(start) = step.element.start() else {
            if held.stills.len() < STILL_PIECES {
                held.stills.push(step);
                self.state = State::Held(Box::new(held));
                return Ok(());
            }
            return Err(broken(held, step, Misfit::Still, out));
        };
        let Some(s) = sign(step.side) else {
            let (before, watched) = (out.len(), held.watched());
            let (tip, late) = held.release_to_normal(out);
            self.watch(watched, out, before);
            self.trail.clear();
            let misfit;
            (self.state, misfit) = begin(step, Some(tip), out);
            return late.or(misfit).map_or(Ok(()), Err);
        };
        let R = step.nose.radius;
        if step.nose != held.step.nose {
            return Err(broken(held, step, Misfit::Changed, out));
        }
        if start.curvature != 0.0 && offset_radius(start.curvature, s, R) < -ROUNDING {
            return Err(broken(held, step, Misfit::Arc { radius: R, arc: 1.0 / start.curvature.abs() }, out));
        }
        let normal = plus(start.at, start.left(), s * R);
        let straight = if held.step.rapid { STRAIGHT } else { self.straight };
        let round = match held.step.element.end() {
            Some(end) if !held.entry && held.s == s => match corner(&end, &start, s, R, straight) {
                Ok(round) => round,
                Err(misfit) => return Err(broken(held, step, misfit, out)),
            },
            Some(end) if !held.entry => Corner::straight(plus(end.at, end.left(), held.s * R), normal),
            _ => Corner::straight(normal, normal),
        };
        let (before, watched, turned) = (out.len(), held.watched(), held.s != s);
        let (_, misfit) = held.release(&round, out);
        self.watch(watched, out, before);
        if turned {
            self.trail.clear();
        }
        if let Some(misfit) = misfit {
            out.push((step.element, step.tag));
            return Err(misfit);
        }
        let [_, trim] = round.trims;
        let next = PendingPiece { step, s, entry: false, start: round.last(), trim, stills: Vec::new() };
        self.state = State::Held(Box::new(next));
        Ok(())
    }
}

impl<T: Clone> Stage<T> {
    /// Holds what has been placed of a piece against the pieces before it.
    fn watch(&mut self, watched: Option<(Element, Nose, T)>, out: &[(Element, T)], before: usize) {
        let Some((piece, nose, tag)) = watched else { return self.trail.clear() };
        let back = nose.to_tip().map(|share| -share);
        let placed = out.get(before..).unwrap_or_default().iter();
        let ways = placed.filter(|(way, _)| way.path != Path::Still).map(|(way, _)| way.shifted(back)).collect();
        self.trail.add(piece, ways, nose.radius, &tag);
    }
}

/// Places what is held back and the piece that does not fit, and gives the misfit.
fn broken<T: Clone>(held: PendingPiece<T>, step: Step<T>, misfit: Misfit, out: &mut Vec<(Element, T)>) -> (Misfit, T) {
    let (_, earlier) = held.release_to_normal(out);
    out.push((step.element, step.tag.clone()));
    earlier.unwrap_or((misfit, step.tag))
}

impl<T: Clone> PendingPiece<T> {
    /// What is watched for cuts: a piece of the contour, which neither an entry nor a rapid move is.
    fn watched(&self) -> Option<(Element, Nose, T)> {
        let step = &self.step;
        (!self.entry && !step.rapid).then(|| (step.element, step.nose, step.tag.clone()))
    }

    /// Places the piece up to a corner, the moves round it and what follows without way. Where the tip is then, and whether
    /// the piece is too short for its corners.
    fn release(self, round: &Corner, out: &mut Vec<(Element, T)>) -> (Point, Option<(Misfit, T)>) {
        let Step { element, nose, tag, .. } = self.step;
        let by = nose.to_tip();
        let misfit =
            if self.entry { None } else { reversed(&element, self.s, nose.radius, self.trim + round.trims[0]) };
        let offset = Element { from: self.start, to: round.first(), path: Path::Line };
        let placed = match element.path {
            // Its start is the tip's already.
            _ if self.entry => Element { to: plus(offset.to, by, 1.0), ..offset },
            Path::Arc { centre, sweep } if distance(centre, offset.to) > ROUNDING => {
                let left = (sweep.abs() - self.trim - round.trims[0]).max(0.0);
                Element { path: Path::Arc { centre, sweep: left.copysign(sweep) }, ..offset }.shifted(by)
            }
            _ => offset.shifted(by),
        };
        out.push((placed, tag.clone()));
        out.extend(round.between().filter(|piece| piece.length() > 0.0).map(|piece| (piece.shifted(by), tag.clone())));
        let tip = plus(round.last(), by, 1.0);
        out.extend(self.stills.into_iter().map(|still| (Element { from: tip, to: tip, path: Path::Still }, still.tag)));
        (tip, misfit.map(|misfit| (misfit, tag)))
    }

    /// Places the piece with the nose at right angles to its end.
    fn release_to_normal(self, out: &mut Vec<(Element, T)>) -> (Point, Option<(Misfit, T)>) {
        let element = &self.step.element;
        let end = element.end().map_or(element.to, |end| plus(end.at, end.left(), self.s * self.step.nose.radius));
        self.release(&Corner::straight(end, end), out)
    }
}

/// Whether the corners at both ends of an element take more of its offset than there is.
fn reversed(element: &Element, s: f64, radius: f64, trims: f64) -> Option<Misfit> {
    let (length, taken, scale) = match element.path {
        Path::Arc { sweep, .. } => {
            let curvature = element.start()?.curvature;
            let arc = 1.0 / curvature.abs();
            (sweep.abs() * arc, trims * arc, offset_radius(curvature, s, radius).max(0.0) / arc)
        }
        _ => (element.length(), trims, 1.0),
    };
    ((taken - length) * scale > ROUNDING).then_some(Misfit::Short { radius, length, taken })
}

/// A piece that comes while nothing is compensated, the tip being at its start or elsewhere.
fn begin<T: Clone>(step: Step<T>, tip: Option<Point>, out: &mut Vec<(Element, T)>) -> (State<T>, Option<(Misfit, T)>) {
    let element = step.element;
    let from = tip.unwrap_or(element.from);
    if element.start().is_none() {
        let path = match element.path {
            Path::Still => Path::Still,
            _ => Path::Line,
        };
        // Where the tip stands aside, it stays there.
        let still = tip.map_or(element, |tip| Element { from: tip, to: tip, path });
        out.push((still, step.tag));
        return (State::Off(tip), None);
    }
    let curved = matches!(element.path, Path::Arc { .. });
    match sign(step.side) {
        Some(_) if curved => {
            out.push((element, step.tag.clone()));
            (State::Broken, Some((Misfit::ArcEntry, step.tag)))
        }
        Some(s) => (
            State::Held(Box::new(PendingPiece { step, s, entry: true, start: from, trim: 0.0, stills: Vec::new() })),
            None,
        ),
        None if curved && tip.is_some() => {
            out.push((element, step.tag.clone()));
            (State::Off(None), Some((Misfit::ArcExit, step.tag)))
        }
        None => {
            out.push((Element { from, ..element }, step.tag));
            (State::Off(None), None)
        }
    }
}

const fn sign(side: Compensation) -> Option<f64> {
    match side {
        Compensation::Off => None,
        Compensation::Left => Some(1.0),
        Compensation::Right => Some(-1.0),
    }
}

/// Outer corners of straight lines whatever their turn.
pub const STRAIGHT: f64 = PI;
