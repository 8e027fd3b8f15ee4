//! How long the lead-in on a turning pipe may be: up to there the torch keeps off what stays, at every place of the way.
//!
//! # Derivation
//! The torch leaves the curve c(φ) square to it at φ = 0, half a kerf b from it: what it cuts lies within b of the line from
//! c(0) + b n to c(0) + (b + w) n, n being the direction into the waste. No part of the curve may lie there. The line begins
//! above the curve and comes no nearer to it than b, so it stays above.
//!
//! At its beginning the two touch. Along n the curve is v and along its own direction u, v(0) = v′(0) = 0 and v″ = n_y y″. With
//! u′ ≥ u₁ and v″ ≤ v₂ up to an angle δ, v ≤ v₂ φ²/2 and u² ≥ u₁² φ². Where b v₂ ≤ u₁², 2 b v ≤ u²: where |u| < b, v is less than
//! b, so the line's beginning is its nearest place, and u² + (v − b)² ≥ b². Elsewhere the curve is more than b aside.
//!
//! Farther on, a piece of the curve leaves its chord by no more than an eighth of its second derivative: chord and line are as
//! far apart as their ends, or cross. Pieces are parted until that decides. The curve goes round again and again, and so may the
//! line.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::TAU;

use nalgebra::Vector2;

use crate::geometry::pipe_pair::Side;
use crate::kinds::pipe::insert::outline::Outline;
use crate::limits::LEAD_IN_LOOKS;
use crate::number::jet::{Jet, bow};
use crate::number::root::last_whole;

/// How deep the angle is halved within which the curve leaves the beginning as it bends there.
const DEEPEST: usize = 24;
/// Without a kerf, how near the torch may come to the curve: the grid of the program, mm.
const LEAST: f64 = 1e-3;
/// The lead-in that is told, in parts of a millimetre.
const TOLD: f64 = 10.0;

/// A line between two points.
type Segment = [Vector2<f64>; 2];

impl Outline {
    /// The longest lead-in for which it is proved that the torch keeps off what stays: the one that is asked for, else to a
    /// tenth of a millimetre.
    #[must_use]
    pub fn longest_lead_in(&self, asked: f64) -> f64 {
        if self.lead_in_clears(asked) {
            return asked;
        }
        last_whole([0.0, (asked * TOLD).ceil()], |way| self.lead_in_clears(way / TOLD)) / TOLD
    }

    /// Whether it is proved of a lead-in.
    fn lead_in_clears(&self, way: f64) -> bool {
        let beside = self.beside.max(LEAST);
        let (first, across) = (self.curve(0.0), self.across(0.0, Side::After));
        let line = [first + across * beside, first + across * beside.max(self.beside + way)];
        let (Some(before), Some(after)) = (self.leaves(Side::Before, beside), self.leaves(Side::After, beside)) else {
            return false;
        };
        let round = self.round();
        let aside = [line[0].x.min(line[1].x) - beside, line[0].x.max(line[1].x) + beside];
        let mut looks = LEAD_IN_LOOKS;
        let mut turn = (aside[0] / round).floor();
        while turn * round <= aside[1] {
            let shift = Vector2::new(turn * round, 0.0);
            // The curve begins at turn 0, and the turn before ends there.
            let least = if turn == 0.0 { after } else { 0.0 };
            let most = if turn == -1.0 { TAU - before } else { TAU };
            for piece in self.pieces() {
                let inside = f64::midpoint(piece[0], piece[piece.len() - 1]);
                for pair in piece.windows(2) {
                    let span = [pair[0].max(least), pair[1].min(most)];
                    let [from, to] = span.map(|phi| self.radius * phi + shift.x);
                    let off = span[0] >= span[1] || to < aside[0] || from > aside[1];
                    if !off && !self.piece_clears(span, inside, shift, line, beside, &mut looks) {
                        return false;
                    }
                }
            }
            turn += 1.0;
        }
        true
    }

    /// The angle on one side of φ = 0 within which the curve keeps off the lead-in by the way it bends.
    fn leaves(&self, side: Side, beside: f64) -> Option<f64> {
        let (along, across) = (self.along(0.0, Side::After), self.across(0.0, Side::After));
        if side == Side::Before {
            // At a corner it must come from below.
            let rises = across.x * self.radius + across.y * self.seat.slope(TAU, Side::Before);
            if rises < -1e-9 * self.radius {
                return None;
            }
        }
        std::iter::successors(Some(TAU / 64.0), |delta| Some(delta / 2.0)).take(DEEPEST).find(|delta| {
            let [low, high] = if side == Side::Before { [TAU - delta, TAU] } else { [0.0, *delta] };
            let [depth, _] = self.seat.depth_jets(Jet::parameter(low, high), f64::midpoint(low, high));
            let runs = (Jet { value: depth.first, ..Jet::of(0.0) } * along.y).value.low + along.x * self.radius;
            let bends = beside * across.y * depth.second.high.max(0.0);
            runs > 0.0 && bends <= runs * runs * (1.0 - 1e-9)
        })
    }

    /// Whether a span of the curve, a whole number of turns on, keeps off a line.
    fn piece_clears(
        &self,
        [low, high]: [f64; 2],
        inside: f64,
        shift: Vector2<f64>,
        line: Segment,
        beside: f64,
        looks: &mut u32,
    ) -> bool {
        let mut spans = vec![[low, high]];
        while let Some([low, high]) = spans.pop() {
            let ends = [low, high].map(|phi| self.curve(phi) + shift);
            let [depth, _] = self.seat.depth_jets(Jet::parameter(low, high), inside);
            if apart(ends, line) - bow(&[depth], high - low) >= beside {
                continue;
            }
            if *looks == 0 || ends.into_iter().any(|end| off(end, line) < beside - 1e-9) {
                return false;
            }
            *looks -= 1;
            let middle = f64::midpoint(low, high);
            spans.extend([[low, middle], [middle, high]]);
        }
        true
    }
}

/// How far a point is from a line.
fn off(point: Vector2<f64>, [from, to]: Segment) -> f64 {
    let (chord, by) = (to - from, point - from);
    let square = chord.norm_squared();
    let part = if square > 0.0 { (by.dot(&chord) / square).clamp(0.0, 1.0) } else { 0.0 };
    (by - chord * part).norm()
}

/// How far two lines are from each other; 0 where they cross.
fn apart(one: Segment, other: Segment) -> f64 {
    let side = |[from, to]: Segment, point: Vector2<f64>| (to - from).perp(&(point - from));
    let parted = |line: Segment, [first, last]: Segment| side(line, first) * side(line, last) < 0.0;
    if parted(one, other) && parted(other, one) {
        return 0.0;
    }
    let ends = [off(one[0], other), off(one[1], other), off(other[0], one), off(other[1], one)];
    ends.into_iter().fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::geometry::pipe_pair::PipePair;
    use crate::geometry::pipe_wall::{PipeWall, Seat};

    /// How far the curve is from the torch at a part of the lead-in, by 20,000 places of each turn; negative below it.
    fn nearest(outline: &Outline, way: f64) -> f64 {
        let point = outline.torch(0.0, Side::After) + outline.across(0.0, Side::After) * way;
        let reach = 2.0 * outline.beside + 1.0;
        let step = (TAU / 20_000.0).min(1e-3 / outline.radius);
        let from = (point.x - reach) / outline.radius;
        let mut least = f64::INFINITY;
        let mut phi = from;
        while phi * outline.radius < point.x + reach {
            least = least.min((outline.curve(phi) - point).norm());
            phi += step;
        }
        if outline.curve(point.x / outline.radius).y > point.y { -least } else { least }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(96))]

        #[test]
        fn a_lead_in_keeps_off_what_stays_and_none_is_refused_that_does(
            r in 5.0..30.0_f64, wide in 1.0..3.0_f64, theta in 20.0..160.0_f64, off in -1.0..1.0_f64, beside in 0.4..1.2_f64,
            long in 1.0..12.0_f64, envelope in any::<bool>(), touching in any::<bool>(), part in 0.0..1.0_f64,
        ) {
            let R = r * wide;
            let e = (R - r) * if touching { off.signum() } else { off * 0.99 };
            let wall = PipeWall::new([r, r * 1.1], R, theta, e);
            let seat = if envelope { Seat::Envelope(wall) } else { Seat::Edge(PipePair::new(r, R, theta, e)) };
            let outline = Outline { seat, wall, radius: r * 1.1, Z: 20.0, beside };
            prop_assume!(outline.tighter_than(beside * 1.01).is_none());
            let asked = r * long;
            let longest = outline.longest_lead_in(asked);
            for way in [longest, longest * part] {
                prop_assert!(nearest(&outline, way) >= beside - 1e-6, "{longest} of {asked}, at {way}");
            }
            if longest < asked {
                let touched = (0..=40).map(|at| longest + 0.11 * f64::from(at) / 40.0).any(|way| nearest(&outline, way) < beside + 2e-3);
                prop_assert!(touched, "{longest} of {asked} could be longer");
            }
        }
    }

    /// The curve is steep there: at 21.4 mm it comes within 1.11 mm, between places a tenth of a millimetre apart.
    #[test]
    fn a_lead_in_that_touches_between_two_looks_is_not_clear() {
        let (r, R, theta, e, beside) = (11.413_163, 17.376_105, 20.133_064, -4.357_537, 1.170_557);
        let wall = PipeWall::new([r, r * 1.1], R, theta, e);
        let seat = Seat::Edge(PipePair::new(r, R, theta, e));
        let outline = Outline { seat, wall, radius: r * 1.1, Z: 20.0, beside };
        assert!(nearest(&outline, 21.4) < 1.115);
        let longest = outline.longest_lead_in(21.4);
        assert!((21.0..21.4).contains(&longest) && outline.longest_lead_in(longest) == longest, "{longest}");
    }

    #[test]
    fn lines_that_cross_are_not_apart() {
        let line = |one: [f64; 2], other: [f64; 2]| [Vector2::from(one), Vector2::from(other)];
        assert_eq!(apart(line([0.0, 0.0], [2.0, 2.0]), line([0.0, 2.0], [2.0, 0.0])), 0.0);
        assert_eq!(apart(line([0.0, 0.0], [2.0, 0.0]), line([1.0, 1.0], [1.0, 3.0])), 1.0);
        assert_eq!(apart(line([0.0, 0.0], [2.0, 0.0]), line([5.0, 4.0], [9.0, 4.0])), 5.0);
    }
}
