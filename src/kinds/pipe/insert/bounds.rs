//! What holds of the curve and of the torch's path over a whole span of angles, not at single places of it.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::TAU;

use crate::geometry::pipe_wall::{PipeWall, Seat, WallLine};
use crate::kinds::pipe::insert::outline::Outline;
use crate::limits::CURVE_LOOKS;
use crate::number::bound::Enclosure;
use crate::number::interval::Interval;
use crate::number::jet::{Jet, at_most, bow};

/// Looks a turn that every search begins with.
const FIRST: u8 = 64;

impl Outline {
    /// The torch's place over a span of φ, and the direction across the curve; at a corner those of the half in which `inside`
    /// lies.
    #[must_use]
    pub fn torch_jets(&self, phi: Jet, inside: f64) -> [[Jet; 2]; 2] {
        let [depth, slope] = self.seat.depth_jets(phi, inside);
        let shorter = (slope.square() + Jet::of(self.radius * self.radius)).sqrt().inverse();
        let across = [-(slope * shorter), shorter * self.radius];
        let curve = [phi * self.radius, depth + Jet::of(self.Z)];
        [[curve[0] + across[0] * self.beside, curve[1] + across[1] * self.beside], across]
    }

    /// The angles of a turn between which the curve has no corner, and within them the first looks.
    pub(super) fn pieces(&self) -> Vec<Vec<f64>> {
        Self::pieces_between(self.corners())
    }

    /// The same for corners of more than one curve.
    fn pieces_between(mut corners: Vec<f64>) -> Vec<Vec<f64>> {
        corners.sort_by(f64::total_cmp);
        let mut ends = vec![0.0];
        ends.extend(corners.into_iter().filter(|corner| *corner > 0.0));
        ends.push(TAU);
        ends.dedup_by(|one, other| *one - *other < 1e-9);
        let piece = |ends: &[f64]| {
            let [low, high] = [ends[0], ends[1]];
            (0..=FIRST).map(|at| low + (high - low) * f64::from(at) / f64::from(FIRST)).collect()
        };
        ends.windows(2).map(piece).collect()
    }

    /// The least and greatest y of the curve, to a ten-millionth of a millimetre and outwards.
    #[must_use]
    pub fn extent(&self) -> [f64; 2] {
        let mut found = Enclosure::new([1e-7; 2], [f64::INFINITY; 2], CURVE_LOOKS);
        for piece in self.pieces() {
            found.take(
                &piece,
                |phi| {
                    let y = self.curve(*phi).y;
                    [y, -y]
                },
                |one, other| {
                    let [depth, _] = self.seat.depth_jets(Jet::parameter(*one, *other), f64::midpoint(*one, *other));
                    let (first, last, bow) = (self.curve(*one).y, self.curve(*other).y, bow(&[depth], other - one));
                    [first.max(last) + bow, bow - first.min(last)]
                },
                |one, other| f64::midpoint(*one, *other),
            );
        }
        [-found.at_most[1], found.at_most[0]]
    }

    /// How much the curve bends to the left, round the waste, over a span: 1/radius, with its first derivative.
    fn bend(&self, low: f64, high: f64, inside: f64) -> Jet {
        let [_, slope] = self.seat.depth_jets(Jet::parameter(low, high), inside);
        let shorter = (slope.square() + Jet::of(self.radius * self.radius)).sqrt().inverse();
        let curving = Jet { value: slope.first, first: slope.second, second: Interval::WHOLE };
        curving * shorter * shorter * shorter * self.radius
    }

    /// Where the curve bends round the waste more tightly than with a radius, the least radius with which it does, and where: a
    /// kerf of twice that cuts into what is kept. Told where it could not be ruled out, too.
    #[must_use]
    pub fn tighter_than(&self, radius: f64) -> Option<(f64, f64)> {
        if radius <= 0.0 {
            return None;
        }
        let limit = 1.0 / radius;
        let mut found = Enclosure::new([1e-3 * limit], [limit], CURVE_LOOKS);
        let mut worst = (f64::NEG_INFINITY, 0.0);
        for piece in self.pieces() {
            let inside = f64::midpoint(piece[0], piece[piece.len() - 1]);
            let at = |phi: f64| (phi, self.bend(phi, phi, inside).value.high);
            let looks: Vec<(f64, f64)> = piece.into_iter().map(at).collect();
            let mut keep = |look: (f64, f64)| {
                if look.1 > worst.0 {
                    worst = (look.1, look.0);
                }
                look
            };
            for look in &looks {
                keep(*look);
            }
            found.take(
                &looks,
                |look| [look.1],
                |one, other| {
                    let bend = self.bend(one.0, other.0, inside);
                    let even = f64::midpoint(one.1, other.1) + bend.first.size() * 0.5 * (other.0 - one.0);
                    [if even.is_nan() { bend.value.high } else { even.min(bend.value.high) }]
                },
                |one, other| keep(at(f64::midpoint(one.0, other.0))),
            );
        }
        let most = found.reached[0].max(if found.at_most[0] > limit { found.at_most[0] } else { 0.0 });
        (most > limit).then(|| (1.0 / most, worst.1))
    }

    /// How the wall stands to the header where its end is cut straight to the branch's axis along the curve.
    #[must_use]
    pub fn rest(&self) -> Rest {
        let (wall, level) = (self.wall, self.seat.level());
        let mut corners = self.corners();
        corners.extend(wall.corners());
        let mut found = Enclosure::new([1e-4; 4], [f64::INFINITY; 4], CURVE_LOOKS);
        let mut worst = [Worst { most: 0.0, seen: f64::NEG_INFINITY, phi: 0.0 }; 4];
        let (mut deepest, short) = (f64::NEG_INFINITY, wall.reach(0.0) - level);
        let mut edge = wall.ends()[1];
        for piece in Self::pieces_between(corners) {
            let inside = f64::midpoint(piece[0], piece[piece.len() - 1]);
            let mut look = |phi: f64| {
                let s = level - self.seat.depth(phi);
                let grind = match self.seat {
                    Seat::Edge(_) => wall.reach(phi) - s,
                    Seat::Envelope(_) => 0.0,
                };
                let look = WallSample { phi, line: wall.line(phi, s), grind };
                for (worst, value) in worst.iter_mut().zip(look.values()) {
                    // Of two angles that are as bad but for the arithmetic, the first.
                    if value > worst.seen + 1e-9 {
                        (worst.seen, worst.phi) = (value, phi);
                    }
                }
                if -look.line.least > deepest + 1e-9 {
                    (deepest, edge) = (-look.line.least, look.line.rho);
                }
                look
            };
            let looks: Vec<WallSample> = piece.into_iter().map(&mut look).collect();
            let over = |one: &WallSample, other: &WallSample| {
                let (span, phi) = (other.phi - one.phi, Jet::parameter(one.phi, other.phi));
                let [depth, _] = self.seat.depth_jets(phi, inside);
                let s = Jet::of(level) - depth;
                let grind = match self.seat {
                    Seat::Edge(_) => {
                        let [envelope, _] = wall.depth_jets(phi, inside);
                        at_most(one.grind, other.grind, Jet::of(short) + depth - envelope, span)
                    }
                    Seat::Envelope(_) => 0.0,
                };
                let [deep, gaps @ ..] = beyond(&wall, [&one.line, &other.line], phi, s, span);
                [deep, grind, gaps[0], gaps[1]]
            };
            found.take(&looks, WallSample::values, over, |one, other| look(f64::midpoint(one.phi, other.phi)));
        }
        for (worst, most) in worst.iter_mut().zip(found.at_most) {
            worst.most = most + ARITHMETIC;
        }
        let [inside, grind, bore, outside] = worst;
        Rest { inside, rho: edge, grind, gaps: [bore, outside] }
    }
}

/// What the arithmetic of a look may lose, mm.
const ARITHMETIC: f64 = 1e-8;

/// The greatest of a length over a turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Worst {
    /// What it is nowhere more than, mm.
    pub most: f64,
    /// The greatest that was seen, mm.
    pub seen: f64,
    /// Where that was, φ in radians.
    pub phi: f64,
}

/// How the wall of a branch stands to the header.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rest {
    /// How deep the wall stands inside the header.
    pub inside: Worst,
    /// How far from the branch's axis it does so most.
    pub rho: f64,
    /// How much of it does, along the branch: what is to be ground.
    pub grind: Worst,
    /// How far the edges of bore and outside are from the header.
    pub gaps: [Worst; 2],
}

#[derive(Clone, Copy, Debug)]
struct WallSample {
    phi: f64,
    line: WallLine,
    grind: f64,
}

impl WallSample {
    /// How deep inside, how much to grind, and the gaps of bore and outside.
    const fn values(&self) -> [f64; 4] {
        [-self.line.least, self.grind, self.line.ends[0], self.line.ends[1]]
    }
}

/// What a wall's depth inside the header and its gaps are nowhere more than between two lines of the cut face.
///
/// # Derivation
/// The least square over ρ of distances with |f″| ≤ M is nowhere below its chord by more than M/8 of the span's square, as f − M φ²/2
/// is concave for each ρ, and so is the least of them. The same holds of what falls with |f′|.
#[must_use]
pub fn beyond(wall: &PipeWall, [one, other]: [&WallLine; 2], phi: Jet, s: Jet, span: f64) -> [f64; 3] {
    let ([bore, outside], R) = (wall.ends(), wall.R());
    let square = |off: f64| (R + off) * (R + off);
    let within = -wall.square_jet(phi, s, Interval::between(bore, outside));
    let least = -at_most(-square(one.least), -square(other.least), within, span);
    let gap = |end: usize, rho: f64| {
        let jet = wall.square_jet(phi, s, Interval::of(rho));
        at_most(square(one.ends[end]), square(other.ends[end]), jet, span).sqrt() - R
    };
    [R - least.max(0.0).sqrt(), gap(0, bore), gap(1, outside)]
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::geometry::pipe_pair::{PipePair, Side};

    fn outline(R: f64, part: f64, theta: f64, off: f64, beside: f64, envelope: bool) -> Outline {
        let (r, e) = (R * part, R * (1.0 - part) * off);
        let wall = PipeWall::new([r, r * 1.1], R, theta, e);
        let seat = if envelope { Seat::Envelope(wall) } else { Seat::Edge(PipePair::new(r, R, theta, e)) };
        Outline { seat, wall, radius: r * 1.1, Z: 20.0, beside }
    }

    proptest! {
        #[test]
        fn a_span_encloses_every_place_of_the_path(
            R in 5.0..500.0_f64, part in 0.05..1.0_f64, theta in 20.0..160.0_f64, off in -0.99..0.99_f64, beside in 0.0..3.0_f64,
            phi in 0.0..TAU, wide in 0.0..0.02_f64, share in 0.0..1.0_f64, envelope in any::<bool>(),
        ) {
            let outline = outline(R, part, theta, off, beside, envelope);
            let [torch, across] = outline.torch_jets(Jet::parameter(phi, phi + wide), phi);
            let at = phi + wide * share;
            let (place, direction) = (outline.torch(at, Side::After), outline.across(at, Side::After));
            let inside = |jet: Jet, value: f64, slack: f64| jet.value.low <= value + slack && value - slack <= jet.value.high;
            for k in 0..2 {
                prop_assert!(inside(torch[k], place[k], 1e-8 * R.max(50.0)), "{:?} {}", torch[k], place[k]);
                prop_assert!(inside(across[k], direction[k], 1e-8));
            }
        }

        #[test]
        fn no_place_of_the_curve_is_beyond_its_extent_nor_bends_more_than_told(
            R in 5.0..500.0_f64, part in 0.05..1.0_f64, theta in 20.0..160.0_f64, off in -0.99..0.99_f64,
            envelope in any::<bool>(),
        ) {
            let outline = outline(R, part, theta, off, 0.0, envelope);
            let [least, most] = outline.extent();
            let ys: Vec<f64> = (0..=4000).map(|at| outline.curve(TAU * f64::from(at) / 4000.0).y).collect();
            let (low, high) = (ys.iter().copied().fold(f64::MAX, f64::min), ys.iter().copied().fold(f64::MIN, f64::max));
            prop_assert!(least <= low && high <= most);
            prop_assert!(low - least < 1e-3 * R && most - high < 1e-3 * R, "{least} {low} {high} {most}");
            let step = TAU / 4000.0;
            let mut tightest = f64::INFINITY;
            for at in 0..4000 {
                let phi = TAU * (f64::from(at) + 0.37) / 4000.0;
                let near = |corner: &f64| (corner - phi).abs() < 3.0 * step;
                let points = [phi - step, phi, phi + step].map(|phi| outline.curve(phi));
                if let Some(circle) = crate::geometry::circle::through(points).filter(|circle| circle.left)
                    && !outline.corners().iter().any(near)
                {
                    tightest = tightest.min(circle.radius);
                }
            }
            prop_assume!(tightest.is_finite());
            // A circle through neighbours bends no more than the curve bends somewhere between them.
            let (told, _) = outline.tighter_than(tightest * 1.01).expect("told");
            prop_assert!(told <= tightest * 1.01, "{told} {tightest}");
            prop_assert!(outline.tighter_than(tightest * 0.9).is_none() || part > 0.98, "{tightest}");
        }
    }
}
