//! What holds of the curve and of the torch's path over a whole span of angles, not at single places of it.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::TAU;

use crate::kinds::pipe::insert::outline::Outline;
use crate::number::bound::Enclosure;
use crate::number::interval::Interval;
use crate::number::jet::{Jet, bow};

/// Looks that a search over the whole curve may take.
const LOOKS: u32 = 50_000;
/// Looks a turn that every search begins with.
const FIRST: u8 = 64;

impl Outline {
    /// The torch's place over a span of φ, and the direction across the curve; at a corner those of the half in which `inside`
    /// lies.
    #[must_use]
    pub fn torch_jets(&self, phi: Jet, inside: f64) -> [[Jet; 2]; 2] {
        let [depth, slope] = self.pair.depth_jets(phi, inside);
        let shorter = (slope.square() + Jet::of(self.radius * self.radius)).sqrt().inverse();
        let across = [-(slope * shorter), shorter * self.radius];
        let curve = [phi * self.radius, depth + Jet::of(self.Z)];
        [[curve[0] + across[0] * self.beside, curve[1] + across[1] * self.beside], across]
    }

    /// The angles of a turn between which the curve has no corner, and within them the first looks.
    fn pieces(&self) -> Vec<Vec<f64>> {
        let mut ends = vec![0.0];
        ends.extend(self.corners());
        ends.push(TAU);
        let piece = |ends: &[f64]| {
            let [low, high] = [ends[0], ends[1]];
            (0..=FIRST).map(|at| low + (high - low) * f64::from(at) / f64::from(FIRST)).collect()
        };
        ends.windows(2).map(piece).collect()
    }

    /// The least and greatest y of the curve, to a ten-millionth of a millimetre and outwards.
    #[must_use]
    pub fn extent(&self) -> [f64; 2] {
        let mut found = Enclosure::new([1e-7; 2], [f64::INFINITY; 2], LOOKS);
        for piece in self.pieces() {
            found.take(
                &piece,
                |phi| {
                    let y = self.curve(*phi).y;
                    [y, -y]
                },
                |one, other| {
                    let [depth, _] = self.pair.depth_jets(Jet::parameter(*one, *other), f64::midpoint(*one, *other));
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
        let [_, slope] = self.pair.depth_jets(Jet::parameter(low, high), inside);
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
        let mut found = Enclosure::new([1e-3 * limit], [limit], LOOKS);
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
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::geometry::pipe_pair::{PipePair, Side};

    fn outline(R: f64, part: f64, theta: f64, off: f64, beside: f64) -> Outline {
        let r = R * part;
        Outline { pair: PipePair::new(r, R, theta, (R - r) * off), radius: r * 1.1, Z: 20.0, beside }
    }

    proptest! {
        #[test]
        fn a_span_encloses_every_place_of_the_path(
            R in 5.0..500.0_f64, part in 0.05..1.0_f64, theta in 20.0..160.0_f64, off in -0.99..0.99_f64, beside in 0.0..3.0_f64,
            phi in 0.0..TAU, wide in 0.0..0.02_f64, share in 0.0..1.0_f64,
        ) {
            let outline = outline(R, part, theta, off, beside);
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
        ) {
            let outline = outline(R, part, theta, off, 0.0);
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
