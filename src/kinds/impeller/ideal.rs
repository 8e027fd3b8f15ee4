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

use crate::geometry::darboux::opposite;
use crate::geometry::torus::Torus;
use crate::geometry::villarceau::Villarceau;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::splitter::Splitter;
use crate::kinds::impeller::track::Track;
use crate::number::trig::sin_cos;

/// What the derivatives of an ideal path by x are at most between two neighbouring points of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bends {
    /// The second and the third of the tip.
    pub tip: [f64; 2],
    /// The first and the second of N and of the direction away from the blade.
    pub frame: [f64; 2],
}

/// The ideal path of a track.
#[derive(Clone, Copy, Debug)]
pub struct Ideal {
    circle: Villarceau,
    n: f64,
    eps_v: f64,
    a_p: f64,
    /// +w on the side of +b, −w on that of −b, mm.
    w: f64,
    /// m of a splitter's side.
    m: Option<f64>,
    /// The track whose path it is.
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

    /// v and dv/dx at the index x, as they run on from the index `inside`; the last step is shorter by the back-off.
    fn v(&self, x: f64, inside: f64) -> (f64, f64) {
        let h = FRAC_PI_2 / self.n;
        let before = self.n - 1.0;
        if inside <= before {
            (PI + h * x, h)
        } else {
            let shorter = h * (1.0 - self.eps_v);
            (PI + h * before + shorter * (x - before), shorter)
        }
    }

    /// The fraction f of the full offset and df/dx, as they run on from the index `inside`.
    fn fraction(&self, x: f64, inside: f64) -> (f64, f64) {
        match self.m {
            Some(m) if inside < m => {
                let part = (x + 1.0) / (m + 1.0);
                let fourth = part * part * part * part;
                (fourth * part, 5.0 * fourth / (m + 1.0))
            }
            _ => (1.0, 0.0),
        }
    }

    /// What the derivatives are at most between the points `low` and `low` + 1.
    ///
    /// # Derivation
    /// By v the circle and t have derivatives of the size R and 1. N = −(cos v cos u, cos v sin u, sin v) has partial ones of
    /// no more than 1 in v and u, u′ = k/ρ ≤ q = √((R+r)/(R−r)), |u″| ≤ q·g and |u‴| ≤ q·g + 2q·g² with g = r/(R−r); so its own are at
    /// most N₁ = 1 + q, N₂ = N₁² + |u″|, N₃ = N₁³ + 3N₁|u″| + |u‴|, and those of b = t × N at most 1 + N₁, 1 + 2N₁ + N₂,
    /// 1 + 3N₁ + 3N₂ + N₃.
    #[must_use]
    pub fn bends(&self, low: f64) -> Bends {
        let Torus { R, r } = self.circle.torus;
        let h = FRAC_PI_2 / self.n;
        let (q, g) = (((R + r) / (R - r)).sqrt(), r / (R - r));
        let (second, third) = (q * g, q * g + 2.0 * q * g * g);
        let N = [1.0 + q, (1.0 + q) * (1.0 + q) + second];
        let N = [N[0] * h, N[1] * h * h, (N[0] * N[0] * N[0] + 3.0 * N[0] * second + third) * h * h * h];
        let (h_2, h_3) = (h * h, h * h * h);
        let b = [h + N[0], h_2 + 2.0 * h * N[0] + N[1], h_3 + 3.0 * h_2 * N[0] + 3.0 * h * N[1] + N[2]];
        let f = match self.m {
            Some(m) if low < m => {
                let (part, each) = (((low + 2.0) / (m + 1.0)).min(1.0), 1.0 / (m + 1.0));
                let square = part * part;
                [
                    square * square * part,
                    5.0 * square * square * each,
                    20.0 * square * part * each * each,
                    60.0 * square * each * each * each,
                ]
            }
            _ => [1.0, 0.0, 0.0, 0.0],
        };
        let w = self.w.abs();
        let beside =
            [f[0] * b[1] + 2.0 * f[1] * b[0] + f[2], f[0] * b[2] + 3.0 * f[1] * b[1] + 3.0 * f[2] * b[0] + f[3]];
        Bends {
            tip: [R * h_2 + w * beside[0] + self.a_p * N[1], R * h_3 + w * beside[1] + self.a_p * N[2]],
            frame: [b[0], b[1]],
        }
    }

    /// The point at the index x (0 … n).
    #[must_use]
    pub fn at(&self, x: f64) -> Station {
        self.within(x, x)
    }

    /// The point at the index x, as the path runs on from the index `inside`: at the end of a fade its slope is another from
    /// either side.
    ///
    /// # Derivation
    /// With X(v) on a circle of radius R run through at |dX/dv| = R about the centre (0, −r, 0), t = X′/R turns by
    /// t′ = −(X − centre)/R; N′ follows from u′ = k/ρ, and b′ = t′ × N + t × N′.
    #[must_use]
    pub fn within(&self, x: f64, inside: f64) -> Station {
        let (v, dv) = self.v(x, inside);
        let (f, df) = self.fraction(x, inside);
        let (s, ds) = (self.w * f, self.w * df);
        let Torus { R, r } = self.circle.torus;
        let (sin_v, cos_v) = sin_cos(v);
        let rho = R + r * cos_v;
        let (cos_u, sin_u) = (self.circle.k * sin_v / rho, -(r + R * cos_v) / rho);
        let turn = self.circle.k / rho;
        let P = Vector3::new(rho * cos_u, rho * sin_u, r * sin_v);
        let N = opposite(Vector3::new(cos_v * cos_u, cos_v * sin_u, sin_v));
        let around = Vector3::new(-sin_u, cos_u, 0.0);
        let along_v = Vector3::new(-sin_v * cos_u, -sin_v * sin_u, cos_v);
        let t = (around * (rho * turn) + along_v * r) / R;
        let b = t.cross(&N);
        let N_slope = opposite(along_v + around * (cos_v * turn));
        let t_slope = opposite(P + Vector3::new(0.0, r, 0.0)) / R;
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
    use crate::kinds::impeller::blade::Blade;
    use crate::kinds::impeller::cases::CASES;
    use crate::kinds::impeller::tables::ToolPaths;
    use crate::kinds::impeller::tool_path::part_path;
    use crate::parameter::Values;
    use crate::parameter::field::Fields;
    use crate::text::Language;

    fn published() -> (Design, Blade, Splitter) {
        let mut values = Values::default();
        let case = CASES.iter().find(|case| case.name == "tfg-2021").unwrap();
        values.values.extend(case.values(Language::En));
        let design =
            Design::new(&Fields::of(&crate::kinds::impeller::parameters::FORM, values.clone()).unwrap()).unwrap();
        let blade = Blade::new(design.torus, design.n, design.eps_v, design.machine);
        let splitter = Splitter::new(&design, &blade).unwrap();
        (design, blade, splitter)
    }

    #[test]
    fn it_goes_through_every_point_of_the_tables() {
        let (design, blade, splitter) = published();
        let passes = ToolPaths::new(&design, &blade);
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
