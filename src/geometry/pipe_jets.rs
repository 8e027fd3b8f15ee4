//! Two pipes that meet, as jets of the angle: what the curve and its directions are over a span of it.
//!
//! # Derivation
//! With δ = φ − π/2, q = r cos δ + e. So R² − q² is the product of R − q = m₁ + r (1 − cos δ) and R + q = m₂ + r (1 + cos δ),
//! where m₁ = R − r − e and m₂ = R − r + e are what is left to the header's sides, and the root w = √(R² − q²) is
//! √(m₁ + 2r sin² δ/2)·√(m₂ + 2r cos² δ/2): so written it stays smooth where the branch touches a side (m = 0), on each half
//! of the corner.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::FRAC_PI_2;

use crate::geometry::pipe_pair::PipePair;
use crate::number::interval::Interval;
use crate::number::jet::{Jet, Vector};

impl PipePair {
    /// q.
    fn q_jet(&self, phi: Jet) -> Jet {
        phi.sin() * self.r + Jet::of(self.e)
    }

    /// √(R² − q²) and q′/√(R² − q²); at a corner those of the half in which `inside` lies. A span over both halves of a corner
    /// has none: the whole line.
    fn root_jets(&self, phi: Jet, inside: f64) -> [Jet; 2] {
        let half = (phi - Jet::of(FRAC_PI_2)) * 0.5;
        let middle = 0.5 * (inside - FRAC_PI_2);
        let factor = |left: f64, part: Jet, sign: f64| {
            if left > 1e-14 * self.R {
                let root = (Jet::of(left) + part.square() * (2.0 * self.r)).sqrt();
                return [root, part / root];
            }
            let slope = sign * (2.0 * self.r).sqrt();
            let root = part * slope;
            let one_half = root.value.low >= -1e-9 * self.R.sqrt();
            if one_half { [root, Jet::of(1.0 / slope)] } else { [WHOLE; 2] }
        };
        let (sin, cos) = crate::number::trig::sin_cos(middle);
        let [one, sine] = factor(self.R - self.r - self.e, half.sin(), sin.signum());
        let [other, cosine] = factor(self.R + self.e - self.r, half.cos(), cos.signum());
        [one * other, sine * cosine * (-2.0 * self.r)]
    }

    /// The depth and the slope of the curve, as [`PipePair::depth`] and [`PipePair::slope`].
    #[must_use]
    pub fn depth_jets(&self, phi: Jet, inside: f64) -> [Jet; 2] {
        let [w, towards] = self.root_jets(phi, inside);
        let [sin, cos] = self.angle();
        let level = self.level();
        let depth = (Jet::of(1.0) - phi.cos()) * (self.r * cos / sin) + (Jet::of(level) - w) * (1.0 / sin);
        let slope = phi.sin() * (self.r * cos / sin) + self.q_jet(phi) * towards * (1.0 / sin);
        [depth, slope]
    }

    /// The point of the branch's surface at an angle and a depth, as [`PipePair::on_branch`].
    #[must_use]
    pub fn on_branch_jets(&self, phi: Jet, depth: Jet) -> Vector {
        let [sin, cos] = self.angle();
        let along = Jet::of((self.level() + self.r * cos) / sin) - depth;
        let across = phi.cos() * self.r;
        [along * cos + across * sin, self.q_jet(phi), along * sin - across * cos]
    }

    /// The point of the curve, the direction out of the header and that out of the branch there, each of length 1.
    #[must_use]
    pub fn frame_jets(&self, phi: Jet) -> [Vector; 3] {
        let [sin, cos] = self.angle();
        let [w, _] = self.root_jets(phi, phi.value.low);
        let q = self.q_jet(phi);
        let (sin_phi, cos_phi) = (phi.sin(), phi.cos());
        let s = (w + cos_phi * (self.r * cos)) * (1.0 / sin);
        let point = [s * cos + cos_phi * (self.r * sin), q, w];
        let header = [Jet::of(0.0), q * (1.0 / self.R), w * (1.0 / self.R)];
        let branch = [cos_phi * sin, sin_phi, cos_phi * -cos];
        [point, header, branch]
    }
}

const WHOLE: Jet = Jet { value: Interval::WHOLE, first: Interval::WHOLE, second: Interval::WHOLE };

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use proptest::prelude::*;

    use super::*;
    use crate::geometry::pipe_pair::Side;

    fn near(interval: Interval, value: f64, slack: f64) -> bool {
        interval.low <= value + slack && value - slack <= interval.high
    }

    proptest! {
        #[test]
        fn jets_enclose_curve_slope_and_their_derivatives(
            R in 5.0..500.0_f64, part in 0.05..1.0_f64, theta in 15.0..165.0_f64, off in -1.0..1.0_f64, phi in 0.0..TAU,
            wide in 0.0..0.01_f64, share in 0.0..1.0_f64, touching in any::<bool>(),
        ) {
            let r = R * part;
            let pair = PipePair::new(r, R, theta, if touching { R - r } else { (R - r) * off * 0.99 });
            let (low, high) = (phi, phi + wide);
            let crosses = pair.corners().iter().any(|corner| low - 1e-3 < *corner && *corner < high + 1e-3);
            prop_assume!(!crosses);
            let at = low + wide * share;
            let [depth, slope] = pair.depth_jets(Jet::parameter(low, high), f64::midpoint(low, high));
            let scale = 1e-9 * R / crate::number::trig::sin(theta.to_radians());
            prop_assert!(near(depth.value, pair.depth(at), scale), "{depth:?} {}", pair.depth(at));
            let true_slope = pair.slope(at, Side::After);
            prop_assert!(near(depth.first, true_slope, 1e3 * scale) && near(slope.value, true_slope, 1e3 * scale));
            let point = pair.point(at);
            let [jets, ..] = pair.frame_jets(Jet::parameter(low, high));
            prop_assert!((0..3).all(|axis| near(jets[axis].value, point[axis], scale)), "{jets:?} {point}");
            let depth = pair.depth(at);
            let on = pair.on_branch_jets(Jet::parameter(low, high), Jet::of(depth));
            let exact = pair.on_branch(at, depth);
            prop_assert!((0..3).all(|axis| near(on[axis].value, exact[axis], scale)));
        }
    }

    #[test]
    fn a_span_over_both_halves_of_a_corner_has_no_bound() {
        let pair = PipePair::new(40.0, 40.0, 70.0, 0.0);
        let [depth, _] = pair.depth_jets(Jet::parameter(1.5, 1.6), 1.5);
        assert!(depth.second.high.is_infinite());
        let [depth, slope] = pair.depth_jets(Jet::parameter(1.5, FRAC_PI_2), 1.5);
        assert!(depth.second.high.is_finite() && slope.second.high.is_finite());
    }
}
