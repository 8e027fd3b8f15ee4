//! The torch's way on the output grid: the pierce, the way in, the cut, and a little beyond it.
//!
//! On a flat sheet the cut is made of arcs through triples of points. Each starts from the rounded end of the one before
//! and is the circle through that end, the exact point in the middle and its own rounded end, so that no control finds
//! start, end and radius at odds. Where an arc bends less than the grid can show it is a straight line, and where no control
//! takes its radius it is one within the tolerance, else one to each of its points.
//!
//! On the turning pipe an arc would be none, since one of its axes is an angle: there the curve is parted until no straight
//! move of both axes leaves it by more than the tolerance.
//!
//! # Units
//! Flat: X round the development, Y along the pipe, mm. Turning: A in degrees, X along the pipe in mm.

use std::f64::consts::TAU;

use nalgebra::Vector2;

use crate::geometry::pipe_pair::Side;
use crate::kinds::pipe::insert::arcs::{arc_through, bow};
use crate::kinds::pipe::insert::design::{Design, Mode, ROUNDING};
use crate::kinds::pipe::insert::outline::Outline;
use crate::number::grid::{Milli, OutOfFormat};
use crate::number::trig::{acos, atan2, sin_cos};

/// How a leg bends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bend {
    /// To the right: G2.
    pub clockwise: bool,
    /// The radius, in thousandths of a mm.
    pub radius: Milli,
}

/// What a leg follows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Follows {
    /// From the pierce to the curve.
    WayIn,
    /// The curve between two angles.
    Curve([f64; 2]),
    /// Round the corner of the curve at an angle.
    Corner(f64),
    /// Beyond the end of the curve, straight on.
    Beyond,
}

/// One move of the torch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg {
    /// Where it ends: X and Y, or A and X.
    pub to: [Milli; 2],
    /// An arc; `None` for a straight move.
    pub bend: Option<Bend>,
    /// The part of the way that it is on.
    pub follows: Follows,
}

/// The whole way.
#[derive(Clone, Debug, PartialEq)]
pub struct Cut {
    /// Where the torch pierces.
    pub pierce: [Milli; 2],
    /// The moves from there on.
    pub legs: Vec<Leg>,
}

/// Half the output grid: an arc that bends less is a line.
const FLAT: f64 = 0.0005;

/// The angles of the template's points, with the curve's corners and the turns of its bend between them, parted at those.
///
/// A piece of one step has its middle as well, as what lies between two turns may be of any shape.
#[must_use]
pub fn pieces(outline: &Outline, N: u32) -> Vec<Vec<f64>> {
    let mut angles: Vec<f64> = (0..=N).map(|j| TAU * f64::from(j) / f64::from(N)).collect();
    let (corners, turns) = (outline.corners(), outline.seat.turns());
    let ends: Vec<f64> = corners.iter().chain(&turns).copied().filter(|end| *end > 0.0).collect();
    for &end in &ends {
        match angles.iter_mut().find(|angle| (**angle - end).abs() < 1e-9) {
            Some(angle) => *angle = end,
            None => angles.push(end),
        }
    }
    angles.sort_by(f64::total_cmp);
    let mut pieces: Vec<Vec<f64>> = vec![Vec::new()];
    for angle in angles {
        if let Some(piece) = pieces.last_mut() {
            piece.push(angle);
        }
        if ends.contains(&angle) && angle < TAU {
            pieces.push(vec![angle]);
        }
    }
    for piece in &mut pieces {
        if let [from, to] = piece[..]
            && !turns.is_empty()
        {
            *piece = vec![from, f64::midpoint(from, to), to];
        }
    }
    pieces
}

/// The path of the torch on its grid, put together leg by leg.
struct GridPath {
    at: Vector2<f64>,
    legs: Vec<Leg>,
}

fn on_grid(point: Vector2<f64>) -> Result<[Milli; 2], OutOfFormat> {
    Ok([Milli::round(point.x)?, Milli::round(point.y)?])
}

fn point([x, y]: [Milli; 2]) -> Vector2<f64> {
    Vector2::new(x.value(), y.value())
}

impl GridPath {
    fn go(&mut self, to: [Milli; 2], bend: Option<Bend>, follows: Follows) {
        if point(to) != self.at {
            self.legs.push(Leg { to, bend, follows });
            self.at = point(to);
        }
    }

    fn straight(&mut self, to: Vector2<f64>, follows: Follows) -> Result<(), OutOfFormat> {
        self.go(on_grid(to)?, None, follows);
        Ok(())
    }

    /// An arc through a point, or straight moves where it is none.
    fn arc(&mut self, by: Vector2<f64>, to: Vector2<f64>, angles: [f64; 3], tolerance: f64) -> Result<(), OutOfFormat> {
        let end = on_grid(to)?;
        let points = [self.at, by, point(end)];
        let [from, middle, last] = angles;
        let bows = bow(points);
        let Some(circle) = arc_through(points).filter(|_| bows >= FLAT) else {
            // The grid takes its part of the tolerance.
            if bows > 0.7 * tolerance {
                self.straight(by, Follows::Curve([from, middle]))?;
                self.go(end, None, Follows::Curve([middle, last]));
            } else {
                self.go(end, None, Follows::Curve([from, last]));
            }
            return Ok(());
        };
        let chord = (point(end) - self.at).norm();
        let radius = Milli::round(circle.radius.max(chord / 2.0))?;
        // Rounded down, the radius might not reach the end.
        let radius = if radius.value() < chord / 2.0 { radius + Milli::new(1) } else { radius };
        self.go(end, Some(Bend { clockwise: !circle.left, radius }), Follows::Curve([from, last]));
        Ok(())
    }
}

/// The torch's way over a flat sheet or round the pipe.
///
/// # Errors
/// For a position that no program may carry.
pub fn cut(design: &Design) -> Result<Cut, OutOfFormat> {
    match design.mode {
        Mode::Flat => flat(design),
        Mode::Rotary => rotary(design),
    }
}

fn flat(design: &Design) -> Result<Cut, OutOfFormat> {
    let outline = design.outline();
    let first = outline.torch(0.0, Side::After);
    let pierce = on_grid(first - outline.along(0.0, Side::After) * design.lead_in)?;
    let mut path = GridPath { at: point(pierce), legs: Vec::new() };
    path.straight(first, Follows::WayIn)?;
    let corners = outline.corners();
    for (at, piece) in pieces(&outline, design.N).iter().enumerate() {
        let last = piece.len() - 1;
        let torch = |i: usize| outline.torch(piece[i], if i == last { Side::Before } else { Side::After });
        if at > 0 && outline.beside > 0.0 && corners.contains(&piece[0]) {
            let to = on_grid(torch(0))?;
            let chord = (point(to) - path.at).norm();
            let radius = Milli::round(outline.beside.max(chord / 2.0))?;
            let radius = if radius.value() < chord / 2.0 { radius + Milli::new(1) } else { radius };
            path.go(to, Some(Bend { clockwise: true, radius }), Follows::Corner(piece[0]));
        }
        let mut i = 0;
        while i < last {
            if i + 2 <= last {
                let angles = [piece[i], piece[i + 1], piece[i + 2]];
                path.arc(torch(i + 1), torch(i + 2), angles, design.arc_tolerance)?;
                i += 2;
            } else {
                path.straight(torch(i + 1), Follows::Curve([piece[i], piece[i + 1]]))?;
                i += 1;
            }
        }
    }
    let beyond = path.at + outline.along(TAU, Side::Before) * design.overcut;
    path.straight(beyond, Follows::Beyond)?;
    Ok(Cut { pierce, legs: path.legs })
}

/// Of the bow of a curve that bends one way its quarter points see so much at least.
const SEEN: f64 = 0.75;

/// By how much the rounding of A moves the torch round a pipe of that radius at most, mm.
#[must_use]
pub fn half_step(radius: f64) -> f64 {
    FLAT.to_radians() * radius
}

/// The bow that may be seen of a move round a pipe, mm: 0.7 of the tolerance, and on a large pipe what half a thousandth of a degree,
/// which is 0.009 mm at a radius of 1 m, and the rounding of the other axis leave of it.
#[must_use]
pub fn most_bow(tolerance: f64, radius: f64) -> f64 {
    (0.7 * tolerance).min(SEEN * (tolerance + ROUNDING - FLAT - half_step(radius)))
}

/// The finest tolerance that leaves moves round a pipe of that radius a bow, mm: a tenth of it.
#[must_use]
pub fn finest(radius: f64) -> f64 {
    let grid = FLAT + half_step(radius) - ROUNDING;
    (grid.max(0.0) / (1.0 - 0.1 / SEEN) * 1000.0).ceil() / 1000.0
}

/// How deep the halving of a piece of the curve may go: far below the grid.
const DEEPEST: u32 = 24;

/// The way on the turning pipe, in development coordinates until it is put on the grid.
struct Round<'d> {
    design: &'d Design,
    outline: Outline,
    path: GridPath,
}

impl Round<'_> {
    fn place(&self, development: Vector2<f64>) -> Vector2<f64> {
        Vector2::new((development.x / self.outline.radius).to_degrees(), development.y)
    }

    fn bow(&self) -> f64 {
        most_bow(self.design.arc_tolerance, self.outline.radius)
    }

    /// Follows the curve from one angle to another, with straight moves that leave it by no more than the tolerance less
    /// what rounding takes.
    fn follow(&mut self, from: f64, to: f64, sides: [Side; 2], depth: u32) -> Result<(), OutOfFormat> {
        let [start, end] = [self.outline.torch(from, sides[0]), self.outline.torch(to, sides[1])];
        let chord = end - start;
        let length = chord.norm();
        let off = |part: f64| {
            let point = self.outline.torch(from + (to - from) * part, Side::After) - start;
            if length > 0.0 { (chord.x * point.y - chord.y * point.x).abs() / length } else { point.norm() }
        };
        let most = [0.25, 0.5, 0.75].map(off).into_iter().fold(0.0, f64::max);
        if depth < DEEPEST && most > self.bow() || to - from > TAU / 32.0 {
            let middle = f64::midpoint(from, to);
            self.follow(from, middle, [sides[0], Side::Before], depth + 1)?;
            self.follow(middle, to, [Side::After, sides[1]], depth + 1)
        } else {
            let place = self.place(end);
            self.path.straight(place, Follows::Curve([from, to]))
        }
    }

    /// Turns round a corner of the curve.
    fn corner(&mut self, phi: f64) -> Result<(), OutOfFormat> {
        let [before, after] = [Side::Before, Side::After].map(|side| self.outline.across(phi, side));
        let turn = atan2(before.x * after.y - before.y * after.x, before.dot(&after));
        let beside = self.outline.beside;
        let most = 2.0 * acos((1.0 - self.bow() / beside).clamp(-1.0, 1.0));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small count")]
        let steps = (turn.abs() / most).ceil().clamp(1.0, 1000.0) as u32;
        for step in 1..=steps {
            let (sin, cos) = sin_cos(turn * f64::from(step) / f64::from(steps));
            let across = Vector2::new(before.x * cos - before.y * sin, before.x * sin + before.y * cos);
            let place = self.place(self.outline.curve(phi) + across * beside);
            self.path.straight(place, Follows::Corner(phi))?;
        }
        Ok(())
    }
}

fn rotary(design: &Design) -> Result<Cut, OutOfFormat> {
    let outline = design.outline();
    let first = outline.torch(0.0, Side::After);
    let mut round = Round { design, outline, path: GridPath { at: first, legs: Vec::new() } };
    let pierce = on_grid(round.place(first + outline.across(0.0, Side::After) * design.lead_in))?;
    round.path.at = point(pierce);
    let place = round.place(first);
    round.path.straight(place, Follows::WayIn)?;
    let corners = outline.corners();
    for (at, piece) in pieces(&outline, 4).iter().enumerate() {
        if at > 0 && outline.beside > 0.0 && corners.contains(&piece[0]) {
            round.corner(piece[0])?;
        }
        for pair in piece.windows(2) {
            round.follow(pair[0], pair[1], [Side::After, Side::Before], 0)?;
        }
    }
    // Over the beginning of the cut once more, as far along the torch's path.
    let speed = |phi: f64| {
        let step = 1e-6;
        (outline.torch(phi + step, Side::After) - outline.torch(phi, Side::After)).norm() / step
    };
    if design.overcut > 0.0 {
        let (mut phi, mut left) = (TAU, design.overcut);
        let step = TAU / 3600.0;
        while left > 0.0 && phi < 2.0 * TAU {
            let way = speed(phi - TAU) * step;
            phi += step * (left / way).min(1.0);
            left -= way;
        }
        // Parted as the cut was: at a turn the torch may go round all but a corner within a billionth of the angle.
        let mut ends: Vec<f64> = corners.iter().chain(&outline.seat.turns()).copied().collect();
        ends.retain(|end| TAU + end < phi);
        ends.sort_by(f64::total_cmp);
        let mut from = TAU;
        for end in ends {
            if TAU + end > from {
                round.follow(from, TAU + end, [Side::After, Side::Before], 0)?;
                from = TAU + end;
            }
            if outline.beside > 0.0 && corners.contains(&end) {
                round.corner(from)?;
            }
        }
        round.follow(from, phi, [Side::After, Side::Before], 0)?;
    }
    Ok(Cut { pierce, legs: round.path.legs })
}
