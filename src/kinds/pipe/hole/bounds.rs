//! What holds of the cut over a whole span of angles, not at single places of it.
//!
//! # Derivation
//! The direction along the curve is that of n × o, with n out of the header and o out of the branch, and cos φ = −n·o. So with
//! c = n·o and s = √(1 − c²) the direction away from the hole is (o − c n)/s, and the torch's
//!
//! a = (o − c n)/s · (s sin γ − c cos γ) + n (s cos γ + c sin γ),
//!
//! without an angle that would have to be unwound. [`Groove::at`] gives the same at one place.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::TAU;

use crate::kinds::pipe::hole::cut::TooHigh;
use crate::kinds::pipe::hole::design::Design;
use crate::kinds::pipe::hole::station::Groove;
use crate::limits::HEIGHT_LOOKS;
use crate::number::bound::Enclosure;
use crate::number::jet::{Jet, Vector, bow, difference, dot, scaled, sum};
use crate::number::trig::sin_cos;

/// The beam over a span of the cut.
#[derive(Clone, Copy, Debug)]
pub struct Beam {
    /// The point through which it passes: the root, half a kerf into the waste.
    pub root: Vector,
    /// The torch's direction.
    pub axis: Vector,
}

impl Groove {
    /// The beam over a span of the angle α.
    #[must_use]
    pub fn beam(&self, alpha: Jet) -> Beam {
        let [root, n, o] = self.pair.frame_jets(alpha);
        let (sin, cos) = sin_cos(self.gamma);
        let c = dot(n, o);
        let s = (Jet::of(1.0) - c.square()).sqrt();
        let away = scaled(difference(o, scaled(n, c)), s.inverse());
        let (up, out) = (s * cos + c * sin, s * sin - c * cos);
        let axis = sum(scaled(away, out), scaled(n, up));
        let waste = difference(scaled(n, out), scaled(away, up));
        Beam { root: sum(root, scaled(waste, Jet::of(self.beside))), axis }
    }

    /// sin σ_o over a span of α: the torch's angle where its axis leaves the header's outside.
    fn sine_outside(&self, alpha: Jet) -> Jet {
        let Beam { root, axis } = self.beam(alpha);
        // |root + λ·axis| = R_o across the header's axis.
        let a = axis[1].square() + axis[2].square();
        let b = root[1] * axis[1] + root[2] * axis[2];
        let c = root[1].square() + root[2].square() - Jet::of(self.R_o * self.R_o);
        // There the axis rises from the header's axis by a λ + b.
        (b.square() - a * c).sqrt() * (1.0 / self.R_o)
    }

    /// The height that the torch needs where the sine of its angle is no less than this.
    fn height_at(&self, sine: f64) -> f64 {
        if sine <= 0.0 {
            return f64::INFINITY;
        }
        let sine = sine.min(1.0);
        self.torch.height(crate::number::trig::asin(sine)).0
    }
}

/// A place looked at for its height.
#[derive(Clone, Copy)]
struct HeightSample {
    alpha: f64,
    /// sin σ_o; none where the torch's axis does not leave the header's outside.
    sine: Option<f64>,
    D: f64,
}

/// Within this the greatest height is known, mm.
const HEIGHT_FINE: f64 = 1e-3;

/// The place where the torch would have to be highest, if that is beyond the greatest height anywhere, between the places
/// looked at as well. Where the work ends before it is known, the height counts as too great.
#[must_use]
pub fn too_high(design: &Design) -> Option<TooHigh> {
    let groove = design.groove();
    let look = |alpha: f64| {
        let station = groove.at(alpha);
        HeightSample {
            alpha,
            sine: station.map(|station| sin_cos(station.sigma_o).0),
            D: station.map_or(f64::INFINITY, |station| station.D),
        }
    };
    let over = |one: &HeightSample, other: &HeightSample| {
        let (Some(first), Some(last)) = (one.sine, other.sine) else { return [f64::INFINITY] };
        let sine = groove.sine_outside(Jet::parameter(one.alpha, other.alpha));
        [groove.height_at(first.min(last) - bow(&[sine], other.alpha - one.alpha) - 1e-12)]
    };
    let mut worst = look(0.0);
    let mut found = Enclosure::new([HEIGHT_FINE], [design.D_max], HEIGHT_LOOKS);
    let first: Vec<HeightSample> = (0..=64_u8).map(|at| look(TAU * f64::from(at) / 64.0)).collect();
    let mut keep = |seen: HeightSample| {
        if seen.D > worst.D {
            worst = seen;
        }
        seen
    };
    first.iter().for_each(|seen| {
        keep(*seen);
    });
    found.take(&first, |look| [look.D], over, |one, other| keep(look(f64::midpoint(one.alpha, other.alpha))));
    (found.at_most[0] > design.D_max).then(|| TooHigh {
        alpha: worst.alpha,
        sigma_o: groove.at(worst.alpha).map(|station| station.sigma_o),
        D: if found.reached[0] > design.D_max { worst.D } else { found.at_most[0] },
    })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::geometry::pipe_pair::PipePair;
    use crate::kinds::pipe::hole::cut::root;
    use crate::kinds::pipe::hole::height::Torch;

    proptest! {
        #[test]
        fn a_span_encloses_every_place_in_it(
            R in 30.0..300.0_f64, part in 0.1..0.9_f64, theta in 45.0..135.0_f64, off in -0.8..0.8_f64, gamma in 0.0..0.8_f64,
            alpha in 0.0..TAU, wide in 0.0..0.02_f64, share in 0.0..1.0_f64,
        ) {
            let groove = Groove {
                pair: PipePair::new(R * part, R, theta, R * (1.0 - part) * off),
                R_o: R * 1.1,
                R_i: R,
                gamma,
                beside: 0.8,
                torch: Torch { r_g: 6.0, R_g: 15.0, Psi: 0.5, d0: 4.0, g0: 2.0 },
            };
            let span = Jet::parameter(alpha, alpha + wide);
            let Some(station) = groove.at(alpha + wide * share) else { return Ok(()) };
            let beam = groove.beam(span);
            let (point, axis) = (root(&station, groove.beside), station.pose.axis);
            let slack = 1e-9 * R;
            for k in 0..3 {
                prop_assert!(beam.root[k].value.low <= point[k] + slack && point[k] - slack <= beam.root[k].value.high);
                prop_assert!(beam.axis[k].value.low <= axis[k] + 1e-9 && axis[k] - 1e-9 <= beam.axis[k].value.high);
            }
            let sine = sin_cos(station.sigma_o).0;
            let jet = groove.sine_outside(span).value;
            prop_assert!(jet.low <= sine + 1e-9 && sine - 1e-9 <= jet.high, "{jet:?} {sine}");
        }
    }
}
