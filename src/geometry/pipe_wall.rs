//! The wall of a branch over a header, where a torch that points square at the branch's axis cuts its end.
//!
//! # Derivation
//! In the frame of [`pipe_pair`](crate::geometry::pipe_pair) the line of the wall at φ, ρ from the branch's axis, meets the header
//! at s(ρ) = (√(R² − q²) + ρ cos φ cos θ)/sin θ with q = ρ sin φ + e. The torch cuts the wall at one s for every ρ from the bore
//! to the outside; whatever of it is below s(ρ) stands inside the header. The branch comes to rest on the envelope, the greatest
//! s(ρ) of each φ. √(R² − q²) is concave in ρ, and s(ρ) with it: its greatest value is where its slope is 0,
//!   q* = R c/√(sin² φ + c²), ρ* = (q* − e)/sin φ with c = cos φ cos θ, q* with the sign of c sin φ,
//! or at that end of the wall which is nearer to ρ*. Between the ends it is s* = (R √(1 + k²) − e k)/sin θ with k = c/sin φ.
//! As the greatest of smooth functions the envelope slopes as the line that touches; where the touching line jumps through the
//! wall (θ = 90° with e ≠ 0, at φ = 0 and 180°) it has a corner, which points to the header.
//!
//! At one φ and s the wall's points lie on a straight line across the header's axis: their distance from it is convex in ρ, least
//! at the foot of the perpendicular and greatest at bore or outside.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::TAU;

use crate::geometry::pipe_pair::{PipePair, Side, once_round};
use crate::number::interval::Interval;
use crate::number::jet::Jet;
use crate::number::root::halved;
use crate::number::trig::{hypot, sin_cos};

/// The wall of a branch over a header.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PipeWall {
    /// The bore over the header.
    bore: PipePair,
    /// The radius of the outside, mm.
    outside: f64,
    /// The angles at which touching passes from bore or outside into the wall, in ascending order; infinite beyond the last.
    turns: [f64; MOST],
    /// The angles at which it jumps from the one to the other; infinite beyond the last.
    kinks: [f64; MOST],
}

/// As many angles as sin φ·q = c·√(R² − q²) has at most for both ends of the wall: four times sin φ each, at two angles.
const MOST: usize = 16;
/// Two turns nearer to each other than this are a corner, radians.
const SHARP: f64 = 1e-9;

/// Halvings between two looks towards such an angle: until a number has no more digits.
const HALVINGS: u8 = 60;

/// One line of the cut face: how far it is from the header's surface, mm, negative inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallLine {
    /// At its nearest, or deepest.
    pub least: f64,
    /// How far that place is from the branch's axis.
    pub rho: f64,
    /// At the bore and at the outside.
    pub ends: [f64; 2],
}

impl PipeWall {
    /// The wall from bore to outside, with the angle θ between the axes in degrees. A bore that passes the header's side is taken
    /// to end there.
    #[must_use]
    pub fn new([bore, outside]: [f64; 2], R: f64, theta: f64, e: f64) -> Self {
        let bore = if R > e.abs() { bore.min(R - e.abs()) } else { bore };
        let mut wall = Self {
            bore: PipePair::new(bore, R, theta, e),
            outside: outside.max(bore),
            turns: [f64::INFINITY; MOST],
            kinks: [f64::INFINITY; MOST],
        };
        let (mut turns, mut kinks) = (Vec::new(), Vec::new());
        let others = wall.changes(wall.outside);
        for turn in wall.changes(bore) {
            match others.iter().find(|other| (**other - turn).abs() < SHARP) {
                Some(_) => kinks.push(turn),
                None => turns.push(turn),
            }
        }
        let apart = |turn: &f64| !kinks.iter().any(|kink| (kink - turn).abs() < SHARP);
        turns.extend(others.iter().copied().filter(apart));
        turns.sort_by(f64::total_cmp);
        wall.turns.iter_mut().zip(turns).for_each(|(to, turn)| *to = turn);
        wall.kinks.iter_mut().zip(kinks).for_each(|(to, kink)| *to = kink);
        wall
    }

    /// How s(ρ) rises with ρ, times √(R² − q²).
    fn rises(&self, rho: f64, phi: f64) -> f64 {
        let [_, cos] = self.bore.angle();
        let (sin_phi, cos_phi) = sin_cos(phi);
        let q = rho * sin_phi + self.bore.e;
        cos_phi * cos * ((self.bore.R - q) * (self.bore.R + q)).max(0.0).sqrt() - q * sin_phi
    }

    /// The angles at which that changes its sign, in ascending order from 0.
    fn changes(&self, rho: f64) -> Vec<f64> {
        const SAMPLES: u16 = 720;
        let at = |look: u16| TAU * (f64::from(look) - 0.5) / f64::from(SAMPLES);
        let mut found: Vec<f64> = (0..SAMPLES)
            .map(|look| [at(look), at(look + 1)])
            .filter(|ends| (self.rises(rho, ends[0]) > 0.0) != (self.rises(rho, ends[1]) > 0.0))
            .map(|[low, high]| {
                let from = self.rises(rho, low) > 0.0;
                let turn = once_round(halved([high, low], HALVINGS, |phi| (self.rises(rho, phi) > 0.0) != from));
                if turn < SHARP || TAU - turn < SHARP { 0.0 } else { turn }
            })
            .collect();
        found.sort_by(f64::total_cmp);
        found.truncate(MOST / 2);
        found
    }

    /// The radii of bore and outside.
    #[must_use]
    pub const fn ends(&self) -> [f64; 2] {
        [self.bore.r, self.outside]
    }

    /// R, the header's radius.
    #[must_use]
    pub const fn R(&self) -> f64 {
        self.bore.R
    }

    /// The wall's line ρ from the axis over the header.
    #[must_use]
    pub const fn at(&self, rho: f64) -> PipePair {
        self.bore.with_radius(rho)
    }

    /// ρ of the line that touches the header at φ. Of two that touch, that of the bore.
    #[must_use]
    pub fn touch(&self, phi: f64) -> f64 {
        let ([_, cos], [bore, outside]) = (self.bore.angle(), self.ends());
        let (sin_phi, cos_phi) = sin_cos(phi);
        if sin_phi.abs() < SHARP {
            return if self.at(outside).reach(phi) > self.bore.reach(phi) + 1e-9 { outside } else { bore };
        }
        let c = cos_phi * cos;
        let q = self.bore.R * c * sin_phi.signum() / hypot(sin_phi, c);
        ((q - self.bore.e) / sin_phi).max(bore).min(outside)
    }

    /// s of the envelope at φ.
    #[must_use]
    pub fn reach(&self, phi: f64) -> f64 {
        self.at(self.touch(phi)).reach(phi)
    }

    /// How much further down the branch the envelope is at φ than at φ = 0, mm.
    #[must_use]
    pub fn depth(&self, phi: f64) -> f64 {
        self.reach(0.0) - self.reach(phi)
    }

    /// The slope of [`Self::depth`] at φ, mm a radian; at a corner that of one side.
    #[must_use]
    pub fn slope(&self, phi: f64, side: Side) -> f64 {
        let aside = if side == Side::Before { -10.0 * SHARP } else { 10.0 * SHARP };
        let kinked = self.kinks().any(|kink| (once_round(phi - kink + SHARP)) < 2.0 * SHARP);
        self.at(self.touch(if kinked { phi + aside } else { phi })).slope(phi, side)
    }

    /// The corners that are the envelope's own, in one turn from 0 on.
    fn kinks(&self) -> impl Iterator<Item = f64> {
        self.kinks.into_iter().take_while(|kink| kink.is_finite())
    }

    /// The angles φ at which the envelope has a corner, radians, in ascending order in one turn from 0 on: those of the
    /// bore's curve among them.
    #[must_use]
    pub fn corners(&self) -> Vec<f64> {
        let mut corners: Vec<f64> = self.bore.corners().into_iter().chain(self.kinks()).collect();
        corners.sort_by(f64::total_cmp);
        corners
    }

    /// The angles at which another part of the wall begins to touch.
    #[must_use]
    pub fn turns(&self) -> Vec<f64> {
        self.turns.into_iter().take_while(|turn| turn.is_finite()).collect()
    }

    /// The envelope's depth and slope over a span, as [`PipePair::depth_jets`].
    ///
    /// Where more than one part of the wall may touch, the jets enclose those of each; the slope's own second derivative, which
    /// jumps there, is the whole line.
    #[must_use]
    pub fn depth_jets(&self, phi: Jet, inside: f64) -> [Jet; 2] {
        let ([_, cos], [bore, outside], R) = (self.bore.angle(), self.ends(), self.bore.R);
        let (sin_phi, cos_phi) = (phi.value.sin(), phi.value.cos());
        let rises = |rho: f64| {
            let q = sin_phi * rho + Interval::of(self.bore.e);
            let square = Interval::of(R * R) - q.square();
            let root = Interval { low: square.low.max(0.0).sqrt(), high: square.high.max(0.0).sqrt() };
            cos_phi * cos * root - q * sin_phi
        };
        let ([inner, outer], slack) = ([bore, outside].map(rises), 1e-11 * R);
        let mut parts = Vec::with_capacity(3);
        if outer.high > slack {
            parts.push(self.outer_jets(phi));
        }
        if inner.high > slack && outer.low < -slack {
            parts.push(self.middle_jets(phi));
        }
        if inner.low < -slack || parts.is_empty() {
            let [depth, slope] = self.bore.depth_jets(phi, inside);
            parts.push([depth + Jet::of(self.reach(0.0) - self.bore.reach(0.0)), slope]);
        }
        let several = parts.len() > 1;
        let both = |one: [Jet; 2], other: [Jet; 2]| [0, 1].map(|k| one[k].hull(other[k]));
        let [mut depth, mut slope] = parts.into_iter().reduce(both).unwrap_or([WHOLE; 2]);
        if several {
            slope.second = Interval::WHOLE;
        }
        let within = |kink: f64| phi.value.low + SHARP < kink && kink < phi.value.high - SHARP;
        if self.kinks().any(|kink| [kink - TAU, kink, kink + TAU].into_iter().any(within)) {
            depth.second = Interval::WHOLE;
            slope.first = Interval::WHOLE;
        }
        [depth, slope]
    }

    /// Those of the outside's curve.
    fn outer_jets(&self, phi: Jet) -> [Jet; 2] {
        let ([sin, cos], r) = (self.bore.angle(), self.outside);
        let (sin_phi, cos_phi) = (phi.sin(), phi.cos());
        let q = sin_phi * r + Jet::of(self.bore.e);
        let root = (Jet::of(self.bore.R * self.bore.R) - q.square()).sqrt();
        let reach = (root + cos_phi * (r * cos)) * (1.0 / sin);
        let slope = (q * cos_phi / root * r + sin_phi * (r * cos)) * (1.0 / sin);
        [Jet::of(self.reach(0.0)) - reach, slope]
    }

    /// Those where the middle of the wall touches.
    fn middle_jets(&self, phi: Jet) -> [Jet; 2] {
        let ([sin, cos], R, e) = (self.bore.angle(), self.bore.R, self.bore.e);
        let shorter = phi.sin().inverse();
        let k = phi.cos() * shorter * cos;
        let longer = (Jet::of(1.0) + k.square()).sqrt();
        let reach = (longer * R - k * e) * (1.0 / sin);
        // The derivative of k is −cos θ/sin² φ.
        let slope = (k / longer * R - Jet::of(e)) * shorter.square() * (cos / sin);
        [Jet::of(self.reach(0.0)) - reach, slope]
    }

    /// The line of the cut face at φ and s.
    #[must_use]
    pub fn line(&self, phi: f64, s: f64) -> WallLine {
        let ([y, z], [sin, c]) = self.across(phi, s);
        let (square, [bore, outside]) = (sin * sin + c * c, self.ends());
        let foot = -(y * sin + z * c) / square;
        let rho = if foot.is_finite() { foot.max(bore).min(outside) } else { bore };
        let off = |rho: f64| hypot(y + rho * sin, z + rho * c) - self.bore.R;
        WallLine { least: off(rho), rho, ends: [off(bore), off(outside)] }
    }

    /// Across the header's axis: where the line of the cut face begins on the branch's axis, and its direction.
    fn across(&self, phi: f64, s: f64) -> ([f64; 2], [f64; 2]) {
        let [sin, cos] = self.bore.angle();
        let (sin_phi, cos_phi) = sin_cos(phi);
        ([self.bore.e, s * sin], [sin_phi, -cos_phi * cos])
    }

    /// The square of the distance from the header's axis at φ, s and ρ.
    #[must_use]
    pub fn square(&self, phi: f64, s: f64, rho: f64) -> f64 {
        let ([y, z], [sin, c]) = self.across(phi, s);
        let (y, z) = (y + rho * sin, z + rho * c);
        y * y + z * z
    }

    /// [`Self::square`] as a jet, mm², for every ρ of an interval.
    #[must_use]
    pub fn square_jet(&self, phi: Jet, s: Jet, rho: Interval) -> Jet {
        let [sin, cos] = self.bore.angle();
        let rho = Jet { value: rho, ..Jet::of(0.0) };
        let y = Jet::of(self.bore.e) + rho * phi.sin();
        let z = s * sin - rho * phi.cos() * cos;
        y.square() + z.square()
    }
}

/// What the branch's end is cut along.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "there is one of them in a design, and it is copied")]
pub enum Seat {
    /// One curve of the branch, of radius r: equation 9 of the published source.
    Edge(PipePair),
    /// The envelope over the wall: at each φ the line of the wall that touches the header first.
    Envelope(PipeWall),
}

impl Seat {
    /// How much further down the branch the cut is at φ than at φ = 0, mm.
    #[must_use]
    pub fn depth(&self, phi: f64) -> f64 {
        match self {
            Self::Edge(pair) => pair.depth(phi),
            Self::Envelope(wall) => wall.depth(phi),
        }
    }

    /// The slope of that, mm a radian; at a corner that of one side.
    #[must_use]
    pub fn slope(&self, phi: f64, side: Side) -> f64 {
        match self {
            Self::Edge(pair) => pair.slope(phi, side),
            Self::Envelope(wall) => wall.slope(phi, side),
        }
    }

    /// Depth and slope over a span, as [`PipePair::depth_jets`].
    #[must_use]
    pub fn depth_jets(&self, phi: Jet, inside: f64) -> [Jet; 2] {
        match self {
            Self::Edge(pair) => pair.depth_jets(phi, inside),
            Self::Envelope(wall) => wall.depth_jets(phi, inside),
        }
    }

    /// s at φ = 0, from which depths are counted.
    #[must_use]
    pub fn level(&self) -> f64 {
        match self {
            Self::Edge(pair) => pair.reach(0.0),
            Self::Envelope(wall) => wall.reach(0.0),
        }
    }

    /// The angles φ at which the curve has a corner, radians, in one turn from 0 on.
    #[must_use]
    pub fn corners(&self) -> Vec<f64> {
        match self {
            Self::Edge(pair) => pair.corners(),
            Self::Envelope(wall) => wall.corners(),
        }
    }

    /// The angles at which the curve bends otherwise from there on.
    #[must_use]
    pub fn turns(&self) -> Vec<f64> {
        match self {
            Self::Edge(_) => Vec::new(),
            Self::Envelope(wall) => wall.turns(),
        }
    }
}

const WHOLE: Jet = Jet { value: Interval::WHOLE, first: Interval::WHOLE, second: Interval::WHOLE };

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use proptest::prelude::*;

    use super::*;

    /// The greatest reach over the wall, line by line.
    fn brute(wall: &PipeWall, phi: f64) -> f64 {
        let ([bore, outside], R, e) = (wall.ends(), wall.bore.R, wall.bore.e);
        (0..=2000)
            .map(|at| bore + (outside - bore) * f64::from(at) / 2000.0)
            .filter(|rho| (rho * sin_cos(phi).0 + e).abs() <= R)
            .map(|rho| wall.at(rho).reach(phi))
            .fold(f64::NEG_INFINITY, f64::max)
    }

    fn wall(R: f64, part: f64, thick: f64, theta: f64, off: f64) -> PipeWall {
        let r = R * part;
        PipeWall::new([r, r / (1.0 - thick)], R, theta, (R - r) * off)
    }

    proptest! {
        #[test]
        fn the_envelope_is_the_greatest_reach_of_the_wall(
            R in 5.0..500.0_f64, part in 0.05..1.0_f64, thick in 0.01..0.6_f64, theta in 15.0..165.0_f64, off in -1.0..1.0_f64,
            phi in 0.0..TAU, square in any::<bool>(),
        ) {
            let wall = wall(R, part, thick, if square { 90.0 } else { theta }, off);
            let (own, most) = (wall.reach(phi), brute(&wall, phi));
            prop_assert!(most <= own + 1e-9 * R && own <= most + 1e-4 * R, "{own} {most}");
            let line = wall.line(phi, own);
            prop_assert!(line.least.abs() < 1e-7 * R, "{line:?}");
            prop_assert!(line.ends.iter().all(|end| *end >= line.least));
        }

        #[test]
        fn jets_enclose_the_envelope_and_its_derivatives(
            R in 5.0..500.0_f64, part in 0.05..0.99_f64, thick in 0.01..0.6_f64, theta in 15.0..165.0_f64, off in -0.99..0.99_f64,
            phi in 0.0..TAU, wide in 0.0..0.05_f64, share in 0.0..1.0_f64, square in any::<bool>(),
        ) {
            let wall = wall(R, part, thick, if square { 90.0 } else { theta }, off);
            let at = phi + wide * share;
            let [depth, slope] = wall.depth_jets(Jet::parameter(phi, phi + wide), f64::midpoint(phi, phi + wide));
            let scale = 1e-9 * R / crate::number::trig::sin(theta.to_radians());
            let inside = |interval: Interval, value: f64, slack: f64| {
                interval.low <= value + slack && value - slack <= interval.high
            };
            prop_assert!(inside(depth.value, wall.depth(at), scale), "{depth:?} {}", wall.depth(at));
            // A span that ends at a corner has the slope of its own side there.
            prop_assume!(!wall.corners().iter().any(|corner| (corner - at).abs() < 1e-6));
            let true_slope = wall.slope(at, Side::After);
            prop_assert!(inside(depth.first, true_slope, 1e3 * scale) && inside(slope.value, true_slope, 1e3 * scale));
            let (low, high) = (wall.depth(phi), wall.depth(phi + wide));
            let most = crate::number::jet::at_most(low, high, depth, wide);
            prop_assert!(wall.depth(at) <= most + scale, "{} {most}", wall.depth(at));
        }

        #[test]
        fn the_square_of_the_distance_is_that_of_the_line(
            R in 5.0..500.0_f64, part in 0.05..1.0_f64, thick in 0.01..0.6_f64, theta in 15.0..165.0_f64, off in -1.0..1.0_f64,
            phi in 0.0..TAU, wide in 0.0..0.05_f64, share in 0.0..1.0_f64, s in -1.0..3.0_f64, high in 0.0..1.0_f64,
        ) {
            let wall = wall(R, part, thick, theta, off);
            let (s, [bore, outside], at) = (s * R, wall.ends(), phi + wide * share);
            let line = wall.line(at, s);
            let rho = bore + (outside - bore) * high;
            let off = wall.square(at, s, rho).sqrt() - R;
            prop_assert!(line.least <= off + 1e-9 * R && off <= line.ends[0].max(line.ends[1]) + 1e-9 * R);
            prop_assert!((wall.square(at, s, line.rho).sqrt() - R - line.least).abs() < 1e-9 * R);
            let jet = wall.square_jet(Jet::parameter(phi, phi + wide), Jet::of(s), Interval::between(bore, outside));
            let square = wall.square(at, s, rho);
            prop_assert!(jet.value.low <= square * (1.0 + 1e-12) && square * (1.0 - 1e-12) <= jet.value.high);
        }
    }

    #[test]
    fn a_square_branch_off_the_axis_has_corners_of_its_own_where_the_touching_line_jumps() {
        let wall = PipeWall::new([38.96, 44.45], 57.15, 90.0, 10.0);
        let corners = wall.corners();
        assert!(corners.len() == 2 && corners[0] == 0.0 && (corners[1] - PI).abs() < 1e-9, "{corners:?}");
        assert_eq!([wall.touch(1e-6), wall.touch(TAU - 1e-6)], [38.96, 44.45]);
        // e t/√(R² − e²) is the jump of the slope, and the corner points to the header: the depth is greatest there.
        let jump = wall.slope(0.0, Side::Before) - wall.slope(0.0, Side::After);
        assert!((jump.abs() - 10.0 * 5.49 / (57.15_f64 * 57.15 - 100.0).sqrt()).abs() < 1e-6, "{jump}");
        for (corner, side, step) in
            corners.iter().flat_map(|corner| [(*corner, Side::Before, -1e-5), (*corner, Side::After, 1e-5)])
        {
            let difference = (wall.depth(corner + step) - wall.depth(corner)) / step;
            assert!((difference - wall.slope(corner, side)).abs() < 1e-3, "{corner} {side:?}");
        }
        // The middle of the wall touches where the header's crown passes through it.
        assert_eq!(wall.turns().len(), 4);
        let crown = wall.touch(TAU - crate::number::trig::asin(10.0 / 41.0));
        assert!((crown - 41.0).abs() < 1e-9, "{crown}");
    }

    #[test]
    fn a_square_branch_on_the_axis_touches_with_its_bore_all_round() {
        let wall = PipeWall::new([38.96, 44.45], 57.15, 90.0, 0.0);
        assert!(wall.corners().is_empty() && wall.turns().is_empty());
        for at in 0..360 {
            let phi = TAU * f64::from(at) / 360.0;
            assert_eq!(wall.touch(phi), 38.96, "{at}");
            assert!((wall.depth(phi) - wall.bore.depth(phi)).abs() < 1e-12, "{at}");
        }
    }

    #[test]
    fn all_but_square_the_corner_is_as_sharp_as_it_can_be_told() {
        for theta in [90.0 - 1e-7, 90.0 + 1e-7] {
            let wall = PipeWall::new([38.96, 44.45], 57.15, theta, 10.0);
            assert_eq!(wall.corners().len(), 2, "{theta}");
            let corner = wall.corners()[0];
            assert!((wall.slope(corner, Side::Before) - wall.slope(corner, Side::After)).abs() > 0.9);
        }
    }
}
