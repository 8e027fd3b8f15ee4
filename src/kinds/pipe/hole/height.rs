//! How high the torch must be, so that no part of it comes nearer to the pipe than g₀.
//!
//! # Derivation
//! The torch's axis stands at the angle σ to the pipe's tangent plane and meets it at the distance D from the tip. The tip
//! is a disc of radius r_g square to the axis, whose lowest point is D sin σ − r_g cos σ above the plane; the shoulder, where
//! the taper of half angle Ψ has reached the body's radius R_g, is h_s = (R_g − r_g)/tan Ψ further up, and its lowest point
//! (D + h_s) sin σ − R_g cos σ above it. So
//!
//! D = max(d₀, (g₀ + r_g cos σ)/sin σ, (g₀ + R_g cos σ)/sin σ − h_s).
//!
//! The first and the second are equal at σ₀ = asin(g₀/√(d₀² + r_g²)) + atan(r_g/d₀): D is continuous. Outside of a convex
//! pipe the tangent plane lies between pipe and torch, so that the true distance is greater.
//!
//! # Units
//! Millimetres and radians.

use crate::number::trig::{asin, atan, hypot, sin_cos, tan};

/// The torch and what is asked of its height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torch {
    /// r_g, radius of the nozzle's tip.
    pub r_g: f64,
    /// R_g, radius of the body.
    pub R_g: f64,
    /// Ψ, half angle of the taper.
    pub Psi: f64,
    /// d₀, the height that is wanted, along the axis.
    pub d0: f64,
    /// g₀, the least distance to the pipe.
    pub g0: f64,
}

/// What sets the height.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// d₀: nothing of the torch would come nearer than g₀.
    Wanted,
    /// The tip's lowest point.
    Tip,
    /// The shoulder's lowest point.
    Shoulder,
}

impl Torch {
    /// h_s, from the tip to the shoulder along the axis.
    #[must_use]
    pub fn shoulder(&self) -> f64 {
        (self.R_g - self.r_g) / tan(self.Psi)
    }

    /// σ₀, the angle below which the tip sets the height.
    #[must_use]
    pub fn switch_angle(&self) -> f64 {
        asin(self.g0 / hypot(self.d0, self.r_g)) + atan(self.r_g / self.d0)
    }

    /// D at the angle σ, and what sets it; infinite where the torch lies in the plane.
    #[must_use]
    pub fn height(&self, sigma: f64) -> (f64, Rule) {
        let (sin, cos) = sin_cos(sigma);
        let tip = (self.g0 + self.r_g * cos) / sin;
        let shoulder = (self.g0 + self.R_g * cos) / sin - self.shoulder();
        let (D, rule) = if tip > self.d0 { (tip, Rule::Tip) } else { (self.d0, Rule::Wanted) };
        if shoulder > D { (shoulder, Rule::Shoulder) } else { (D, rule) }
    }

    /// The distance of the torch's lowest point from the tangent plane at the height D and the angle σ.
    #[must_use]
    pub fn gap(&self, D: f64, sigma: f64) -> f64 {
        let (sin, cos) = sin_cos(sigma);
        (D * sin - self.r_g * cos).min((D + self.shoulder()) * sin - self.R_g * cos)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const TORCH: Torch = Torch { r_g: 6.0, R_g: 6.0, Psi: 0.5, d0: 4.0, g0: 2.0 };

    #[test]
    fn the_check_values_of_the_height_law_are_met() {
        assert_eq!(format!("{:.3}", TORCH.switch_angle().to_degrees()), "72.412");
        for (sigma, D, rule) in [
            (90.0, "4.000", Rule::Wanted),
            (60.0, "5.774", Rule::Tip),
            (45.0, "8.828", Rule::Tip),
            (30.0, "14.392", Rule::Tip),
        ] {
            let (found, by) = TORCH.height(f64::to_radians(sigma));
            assert_eq!((format!("{found:.3}").as_str(), by), (D, rule), "{sigma}");
        }
        let wide = Torch { R_g: 15.0, Psi: f64::to_radians(30.0), ..TORCH };
        for (sigma, D) in [(25.0, "21.312"), (20.0, "31.471")] {
            let (found, by) = wide.height(f64::to_radians(sigma));
            assert_eq!((format!("{found:.3}").as_str(), by), (D, Rule::Shoulder), "{sigma}");
        }
        assert_eq!(wide.height(f64::to_radians(30.1)).1, Rule::Tip);
    }

    proptest! {
        #[test]
        fn the_height_is_continuous_and_keeps_the_gap(
            r_g in 1.0..20.0_f64, more in 0.0..30.0_f64, Psi in 0.1..1.4_f64, d0 in 1.0..20.0_f64, part in 0.05..0.95_f64,
            sigma in 0.1..1.57_f64,
        ) {
            let torch = Torch { r_g, R_g: r_g + more, Psi, d0, g0: d0 * part };
            let (D, _) = torch.height(sigma);
            prop_assert!(D >= d0 && torch.gap(D, sigma) >= torch.g0 - 1e-9);
            let (next, _) = torch.height(sigma + 1e-7);
            prop_assert!((next - D).abs() < 1e-2, "{D} {next}");
            let at = torch.switch_angle();
            if at < 1.5 {
                let tip = Torch { R_g: r_g, ..torch };
                prop_assert!((tip.height(at - 1e-9).0 - d0).abs() < 1e-5 && (tip.height(at + 1e-9).0 - d0).abs() < 1e-5);
            }
        }
    }
}
