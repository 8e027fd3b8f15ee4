//! The ideal path of the tool tip along a track: the exact curve through the points that the programs visit.
//!
//! Between the points of the tables v runs on, and P, N and b with it: T(v) = P ± w·f·b − a_p·N in the part frame, with
//! f = 1 along a blade and f = ((x+1)/(m+1))⁵ up to the m of its side along a splitter, x being the point index continued between
//! the points.
//!
//! # Units
//! Millimetres and radians; x in steps.

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::Vector3;

use crate::geometry::torus::Torus;
use crate::geometry::villarceau::Villarceau;
use crate::impeller::design::Design;
use crate::impeller::splitter::Splitter;
use crate::impeller::track::Track;
use crate::number::trig::sin_cos;

/// The ideal path of a track.
#[derive(Clone, Copy, Debug)]
pub struct Ideal {
    circle: Villarceau,
    n: f64,
    eps_v: f64,
    a_p: f64,
    /// ±w.
    w: f64,
    /// m of a splitter's side.
    m: Option<f64>,
    /// Which track it is.
    pub track: Track,
}

/// A point of an ideal path, in the part frame.
#[derive(Clone, Copy, Debug)]
pub struct Station {
    /// T, where the tip should be.
    pub tip: Vector3<f64>,
    /// dT/dx, mm a step.
    pub slope: Vector3<f64>,
    /// N, out of the floor: the direction in which the tool stands.
    pub N: Vector3<f64>,
    /// The unit vector ±b that points away from the track's own blade.
    pub away: Vector3<f64>,
}

impl Ideal {
    /// The ideal path of a track of a design; `None` for a splitter's where there is none.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
    pub fn new(design: &Design, splitter: Option<&Splitter>, track: Track) -> Option<Self> {
        let m = if track.of_splitter() { Some(splitter?.side(track)?.m as f64) } else { None };
        Some(Self {
            circle: Villarceau::new(design.torus),
            n: design.n as f64,
            eps_v: design.eps_v,
            a_p: design.a_p,
            w: track.side() * design.w(),
            m,
            track,
        })
    }

    /// The last index n.
    #[must_use]
    pub const fn last(&self) -> f64 {
        self.n
    }

    /// v and dv/dx at the index x; the last step is shorter by the back-off.
    fn v(&self, x: f64) -> (f64, f64) {
        let h = FRAC_PI_2 / self.n;
        let before = self.n - 1.0;
        if x <= before {
            (PI + h * x, h)
        } else {
            let shorter = h * (1.0 - self.eps_v);
            (PI + h * before + shorter * (x - before), shorter)
        }
    }

    /// The fraction f of the full offset and df/dx.
    fn fraction(&self, x: f64) -> (f64, f64) {
        match self.m {
            Some(m) if x < m => {
                let part = (x + 1.0) / (m + 1.0);
                let fourth = part * part * part * part;
                (fourth * part, 5.0 * fourth / (m + 1.0))
            }
            _ => (1.0, 0.0),
        }
    }

    /// The point at the index x (0 … n).
    ///
    /// With X(v) on a circle of radius R run through at |dX/dv| = R about the centre (0, −r, 0), t = X′/R turns by
    /// t′ = −(X − centre)/R; N′ follows from u′ = k/ρ, and b′ = t′ × N + t × N′. Derived here.
    #[must_use]
    pub fn at(&self, x: f64) -> Station {
        let (v, dv) = self.v(x);
        let (f, df) = self.fraction(x);
        let (s, ds) = (self.w * f, self.w * df);
        let Torus { R, r } = self.circle.torus;
        let (sin_v, cos_v) = sin_cos(v);
        let rho = R + r * cos_v;
        let (cos_u, sin_u) = (self.circle.k * sin_v / rho, -(r + R * cos_v) / rho);
        let turn = self.circle.k / rho;
        let P = Vector3::new(rho * cos_u, rho * sin_u, r * sin_v);
        let N = -Vector3::new(cos_v * cos_u, cos_v * sin_u, sin_v);
        let around = Vector3::new(-sin_u, cos_u, 0.0);
        let along_v = Vector3::new(-sin_v * cos_u, -sin_v * sin_u, cos_v);
        let t = (around * (rho * turn) + along_v * r) / R;
        let b = t.cross(&N);
        let N_slope = -(along_v + around * (cos_v * turn));
        let t_slope = -(P + Vector3::new(0.0, r, 0.0)) / R;
        let b_slope = t_slope.cross(&N) + t.cross(&N_slope);
        Station {
            tip: P + b * s - N * self.a_p,
            slope: (t * R + b_slope * s - N_slope * self.a_p) * dv + b * ds,
            N,
            away: b * self.track.side(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::impeller::blade::Blade;
    use crate::impeller::cases::CASES;
    use crate::impeller::tables::Passes;
    use crate::impeller::tool_path::part_path;
    use crate::parameter::Values;
    use crate::text::Language;

    fn published() -> (Design, Blade, Splitter) {
        let mut values = Values::default();
        values.values.extend(CASES[1].values(Language::En));
        let design = Design::new(&values).unwrap();
        let blade = Blade::new(design.torus, design.n, design.eps_v, design.machine);
        let splitter = Splitter::new(&design, &blade).unwrap();
        (design, blade, splitter)
    }

    #[test]
    fn it_goes_through_every_point_of_the_tables() {
        let (design, blade, splitter) = published();
        let passes = Passes::new(&design, &blade);
        for track in Track::ALL {
            let ideal = Ideal::new(&design, Some(&splitter), track).unwrap();
            let points = match track {
                Track::Obverse => &passes.obverse,
                Track::Reverse => &passes.reverse,
                Track::Out => &splitter.out.path,
                Track::Back => &splitter.back.path,
            };
            for (i, point) in points.iter().enumerate() {
                let part = design.machine.to_part(point, blade.B[i], blade.C[i]);
                assert!((ideal.at(i as f64).tip - part).norm() < 1e-9, "{} {i}", track.key());
            }
        }
        let ideal = Ideal::new(&design, None, Track::Obverse).unwrap();
        let part = part_path(&blade, design.w(), design.a_p);
        assert!((ideal.at(7.0).tip - part[7]).norm() < 1e-12);
        assert!(Ideal::new(&design, None, Track::Out).is_none());
    }

    #[test]
    fn its_slope_is_that_of_finite_differences() {
        let (design, _, splitter) = published();
        for track in Track::ALL {
            let ideal = Ideal::new(&design, Some(&splitter), track).unwrap();
            for x in [0.3, 7.7, 18.5, 33.3, 39.6] {
                let step = 1e-5;
                let difference = (ideal.at(x + step).tip - ideal.at(x - step).tip) / (2.0 * step);
                assert!((difference - ideal.at(x).slope).norm() < 1e-7, "{} {x}", track.key());
            }
        }
    }
}
