//! Annexes 2 to 5: the mean line of a blade, its Darboux frame, the rotary angles and the machine position.

use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::Arc;

use nalgebra::Vector3;

use crate::geometry::darboux::Darboux;
use crate::geometry::torus::Torus;
use crate::geometry::villarceau::Villarceau;
use crate::kinds::impeller::discretisation;
use crate::machine::rotary::TiltingTable;

/// Vectors shared by every view of them.
pub type Vectors = Arc<[Vector3<f64>]>;

/// The geometry of one blade, point by point (index i).
#[derive(Clone, Debug)]
pub struct Blade {
    /// The mean line lies on this circle.
    pub circle: Villarceau,
    /// v, angle on the meridian, radians.
    pub v: Arc<[f64]>,
    /// u, angle about the axis, radians.
    pub u: Arc<[f64]>,
    /// P, the mean line in the part frame, mm.
    pub P: Vectors,
    /// N, unit normal of the torus out of the metal.
    pub N: Vectors,
    /// t, unit tangent of the mean line.
    pub t: Vectors,
    /// b = t × N.
    pub b: Vectors,
    /// C = u − 2π, radians.
    pub C: Arc<[f64]>,
    /// B = 3π/2 − v, radians.
    pub B: Arc<[f64]>,
    /// P″, the mean line in machine coordinates, mm.
    pub machine: Vectors,
    /// b″, constant along the blade: (cos α, −sin α, 0).
    pub b_machine: Vector3<f64>,
    /// t″, constant along the blade: (sin α, cos α, 0).
    pub t_machine: Vector3<f64>,
}

impl Blade {
    /// The blade on a torus (0 < r < R), in n intervals, on a machine.
    ///
    /// C is atan2(N_y, N_x) taken continuous: −cos v ≥ 0 on the blade, so that (N_x, N_y) points along u, and u runs
    /// through π without a jump. B = atan2(√(N_x² + N_y²), N_z) = 3π/2 − v.
    ///
    /// b″ and t″ are constant because a Villarceau circle cuts every parallel at the same angle α = asin(r/R).
    #[must_use]
    pub fn new(torus: Torus, n: usize, eps_v: f64, machine: TiltingTable) -> Self {
        let circle = Villarceau::new(torus);
        let v = discretisation::v(n, eps_v);
        let u: Vec<f64> = v.iter().map(|&v| circle.u(v)).collect();
        let angles = || u.iter().zip(&v);
        let P: Vectors = angles().map(|(&u, &v)| torus.point(u, v)).collect();
        let frame = |pick: fn(Darboux) -> Vector3<f64>| -> Vectors {
            angles().map(|(&u, &v)| pick(Darboux::of(circle, u, v))).collect()
        };
        let C: Arc<[f64]> = u.iter().map(|u| u - TAU).collect();
        let B: Arc<[f64]> = v.iter().map(|v| PI + FRAC_PI_2 - v).collect();
        let transformed =
            P.iter().zip(B.iter().zip(C.iter())).map(|(P, (&B, &C))| machine.to_machine(P, B, C)).collect();
        let (sin_alpha, cos_alpha) = (torus.r / torus.R, circle.k / torus.R);
        Self {
            circle,
            N: frame(|darboux| darboux.N),
            t: frame(|darboux| darboux.t),
            b: frame(|darboux| darboux.b),
            P,
            C,
            B,
            machine: transformed,
            b_machine: Vector3::new(cos_alpha, -sin_alpha, 0.0),
            t_machine: Vector3::new(sin_alpha, cos_alpha, 0.0),
            u: u.into(),
            v: v.into(),
        }
    }

    /// How many points there are: n + 1.
    #[must_use]
    pub fn points(&self) -> usize {
        self.v.len()
    }
}
