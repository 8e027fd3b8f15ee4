//! The fitted axis of a flank: the tool's cylinder touches the face at three depths and cuts into it nowhere.
//!
//! # Derivation
//! The trace of a face is turned against the mean line the more, the deeper it lies, for the rulings are twisted by τ. A
//! cylinder along N cuts into it at both ends. An axis tilted in the plane of the face, towards the asymptotic direction of
//! the offset surface, A ∝ N + σ(aτ/2)·t, cancels the second order. What is left is taken out by a fit: with σ = 1 on the
//! obverse and −1 on the reverse, h the depth of the fit, the axis goes through P + σ(e/2 + a + o)·b − (h/2)·N along N + σβ·b + η·t, and o, β, η
//! and E solve
//!
//! > f_k + σ n_k·b·o + σ λ_k n_k·b·β + λ_k n_k·t·η = (−1)^k·E
//!
//! at the four abscissae λ_k = (h/2)·cos(kπ/3), f_k being the distance of the axis' point from the face less a and n_k the
//! unit vector from there; a few rounds of that are Newton's method. For the fit the face goes on along the circle beyond
//! its ends, so that the angles stay smooth; what is told of the error is that of the face as it is, straight there.
//!
//! Near B = 0 a tilt turns C far. So η fades over the last 15° of B, o and β are fitted again at three abscissae, and β
//! fades over the last 2°. At last o takes as much as leaves no undercut.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Matrix4, Vector3, Vector4};

use crate::geometry::darboux::Darboux;
use crate::geometry::torus::Torus;
use crate::kinds::impeller::part::{Face, HUB, Part, RIM};
use crate::number::trig::sin_cos;

/// cos(kπ/3): where the fit touches, in half depths.
const ABSCISSAE: [f64; 4] = [1.0, 0.5, -0.5, -1.0];
/// Rounds of Newton's method, and after which step there is no next one: its error goes with the square.
const ROUNDS: usize = 6;
const LAST: f64 = 1e-9;
/// The last step towards the nearest ruling, radians: the distance goes with the square of what is left.
const STEP: f64 = 1e-9;
/// Over which last B the tilt along the face fades, and that away from it.
pub const FADES: [f64; 2] = [15.0 * TAU / 360.0, 2.0 * TAU / 360.0];
/// How far beyond an end the tilt away from the face has gone, mm.
pub const FADED: f64 = 0.3;
/// Abscissae at which the error is looked at, between the ends of the fit.
const SAMPLES: u8 = 16;

/// How a face goes on beyond the ends of the blade.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beyond {
    /// Along the circle.
    Round,
    /// Straight, as the part does.
    Straight,
}

/// Where the axis stands against the frame of the mean line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// o, farther from the face than its radius.
    pub o: f64,
    /// β, the tilt away from the face.
    pub beta: f64,
    /// η, the tilt along it.
    pub eta: f64,
    /// E, the error at the ends and between, with alternating sign.
    pub E: f64,
}

/// A point of a face nearest to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// How far it is.
    pub distance: f64,
    /// The unit vector from the face's point to the other one, in the part frame.
    pub out: Vector3<f64>,
    /// v of the ruling on which the face's point lies, radians.
    pub v: f64,
}

/// A tool of the radius a beside a face, to be fitted between two depths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flank {
    part: Part,
    face: Face,
    a: f64,
    /// The depths h of the fit's upper and lower end, mm.
    span: [f64; 2],
}

/// Where the slope of the distance is none, from near there on a face of the radius R; `None` where it is not near.
fn near(mut v: f64, R: f64, slope: impl Fn(f64) -> f64) -> Option<f64> {
    let (mut here, mut bend) = (slope(v), -R * R);
    for _ in 0..10 {
        let step = -here / bend;
        if step.abs() < STEP {
            return Some(v + step);
        }
        let next = slope(v + step);
        let bent = (next - here) / step;
        // NaN counts as far.
        let closer = step.abs() < 0.1 && bent < 0.0;
        if !closer {
            return None;
        }
        (v, here, bend) = (v + step, next, bent);
    }
    None
}

/// Where the slope of the distance changes its sign: a ruling at which the face has an edge counts too.
fn changes(v: f64, seen: impl Fn(f64) -> f64) -> f64 {
    let slope = seen(v);
    let towards = slope.signum();
    let (mut low, mut at_low, mut step) = (v, slope, 0.02);
    let (mut high, mut at_high) = (v + towards * step, seen(v + towards * step));
    for _ in 0..8 {
        if at_high * towards <= 0.0 {
            break;
        }
        (low, at_low) = (high, at_high);
        step *= 2.0;
        high += towards * step;
        at_high = seen(high);
    }
    let mut found = if at_low == 0.0 { low } else { high };
    for _ in 0..80 {
        if at_low == 0.0 || (high - low).abs() < 1e-14 {
            break;
        }
        let part = at_low / (at_low - at_high);
        found = low + (high - low) * if part > 0.0 && part < 1.0 { part } else { 0.5 };
        let here = seen(found);
        if here * towards > 0.0 {
            (low, at_low) = (found, here);
            at_high *= 0.5;
        } else {
            (high, at_high) = (found, here);
            at_low *= 0.5;
        }
        if here.abs() < 1e-12 {
            break;
        }
    }
    found
}

impl Flank {
    /// The face of a part's blade, for a tool of the radius a, fitted from one depth to another; above, too, it may not be
    /// cut into.
    #[must_use]
    pub const fn new(part: &Part, face: Face, a: f64, span: [f64; 2]) -> Self {
        Self { part: *part, face, a, span }
    }

    /// The depth at the abscissa 0.
    const fn middle(&self) -> f64 {
        f64::midpoint(self.span[0], self.span[1])
    }

    /// `of` in half lengths of the fit, as mm along the axis from its middle.
    fn abscissae<const K: usize>(&self, of: [f64; K]) -> [f64; K] {
        of.map(|cos| cos * (self.span[1] - self.span[0]) / 2.0)
    }

    /// The frame of the mean line, and its point.
    fn frame(&self, v: f64, beyond: Beyond) -> (Vector3<f64>, Darboux) {
        if beyond == Beyond::Straight || (HUB..=RIM).contains(&v) {
            return self.part.frame(v);
        }
        let circle = self.part.circle;
        let u = circle.u(v);
        (circle.torus.point(u, v), Darboux::of(circle, u, v))
    }

    /// Foot and normal of the ruling at v, and how both change with v.
    fn ruling(&self, v: f64, beyond: Beyond) -> [Vector3<f64>; 4] {
        let Torus { R, r } = self.part.circle.torus;
        let on_blade = (HUB..=RIM).contains(&v);
        let turned = sin_cos(v);
        let (P, Darboux { N, t, b }) = if on_blade { self.part.frame_at(v, turned) } else { self.frame(v, beyond) };
        let half = self.face.side() * self.part.e / 2.0;
        let foot = P + b * half;
        if beyond == Beyond::Straight && !on_blade {
            return [foot, N, t * R, Vector3::zeros()];
        }
        // R times the curvatures and the torsion: see the derivatives of the frame.
        let k = self.part.circle.k;
        let cos_v = turned.1;
        let rho = R + r * cos_v;
        let along = r / R + k * k / R * cos_v / rho;
        let aside = -(1.0 - along * along).max(0.0).sqrt();
        let twist = k / rho;
        [foot, N, t * R + (t * -aside + N * twist) * half, -t * along - b * twist]
    }

    /// The point of the face nearest to a point, its depth left free, sought from v on; near an end of the blade, where the
    /// face goes over into its straight end, from the other side of it as well.
    #[must_use]
    pub fn nearest(&self, point: &Vector3<f64>, v: f64, beyond: Beyond) -> Nearest {
        let found = self.sought(point, v, beyond);
        let end = if v < f64::midpoint(HUB, RIM) { HUB } else { RIM };
        let reach = (self.a + self.part.e) / self.part.circle.torus.R;
        if beyond != Beyond::Straight || (v - end).abs() > reach {
            return found;
        }
        let aside = (v - end).abs().max(reach / 4.0);
        let other = self.sought(point, if v < end { end + aside } else { end - aside }, beyond);
        if other.distance < found.distance { other } else { found }
    }

    fn sought(&self, point: &Vector3<f64>, v: f64, beyond: Beyond) -> Nearest {
        let seen = |v: f64| {
            let [foot, N, foot_v, N_v] = self.ruling(v, beyond);
            let h = (foot - point).dot(&N);
            let away = point - foot + N * h;
            (away, away.dot(&(foot_v - N_v * h)))
        };
        let found = near(v, self.part.circle.torus.R, |v| seen(v).1);
        let found = found.unwrap_or_else(|| changes(v, |v| seen(v).1));
        let (away, _) = seen(found);
        let distance = away.norm();
        Nearest { distance, out: away / distance, v: found }
    }

    /// The point of the axis at the abscissa 0, and its direction, not of unit length.
    #[must_use]
    pub fn line(&self, v: f64, fit: &Fit, beyond: Beyond) -> [Vector3<f64>; 2] {
        let side = self.face.side();
        let (P, Darboux { N, t, b }) = self.frame(v, beyond);
        let through = P + b * (side * (self.part.e / 2.0 + self.a + fit.o)) - N * self.middle();
        [through, N + b * (side * fit.beta) + t * fit.eta]
    }

    /// How far the axis' points at some abscissae are from the face, less a, and the unit vectors from there; sought from
    /// some v on, which become those where they were found.
    fn errors<const K: usize>(
        &self,
        v: f64,
        fit: &Fit,
        abscissae: [f64; K],
        beyond: Beyond,
        from: &mut [f64; K],
    ) -> [(f64, Vector3<f64>); K] {
        let [through, along] = self.line(v, fit, beyond);
        std::array::from_fn(|k| {
            let nearest = self.nearest(&(through + along * abscissae[k]), from[k], beyond);
            from[k] = nearest.v;
            (nearest.distance - self.a, nearest.out)
        })
    }

    /// The asymptotic direction, in closed form: η = σ·aτ/2.
    #[must_use]
    pub fn closed_form(&self, v: f64) -> Fit {
        let Torus { R, .. } = self.part.circle.torus;
        let twist = self.part.circle.k / self.part.circle.torus.rho(v) / R;
        Fit { o: 0.0, beta: 0.0, eta: self.face.side() * self.a * twist / 2.0, E: 0.0 }
    }

    /// The fit with all of its tilt, at a v of the blade.
    #[must_use]
    pub fn full(&self, v: f64) -> Fit {
        let mut fit = self.closed_form(v);
        let (side, abscissae) = (self.face.side(), self.abscissae(ABSCISSAE));
        let Darboux { t, b, .. } = self.frame(v, Beyond::Round).1;
        let mut from = [v; 4];
        for _ in 0..ROUNDS {
            let errors = self.errors(v, &fit, abscissae, Beyond::Round, &mut from);
            let (mut matrix, mut right) = (Matrix4::zeros(), Vector4::zeros());
            for (row, ((f, n), lambda)) in errors.iter().zip(abscissae).enumerate() {
                let sign = if row % 2 == 0 { 1.0 } else { -1.0 };
                let across = side * n.dot(&b);
                matrix.set_row(row, &Vector4::new(across, lambda * across, lambda * n.dot(&t), -sign).transpose());
                right[row] = -f;
            }
            let Some(step) = matrix.lu().solve(&right) else { break };
            fit = Fit { o: fit.o + step[0], beta: fit.beta + step[1], eta: fit.eta + step[2], E: step[3] };
            if step.fixed_rows::<3>(0).amax() < LAST {
                break;
            }
        }
        fit
    }

    /// The same with its tilt along the face held: o and β at three abscissae.
    fn without_tilt(&self, v: f64, eta: f64) -> Fit {
        let mut fit = Fit { o: 0.0, beta: 0.0, eta, E: 0.0 };
        let (side, abscissae) = (self.face.side(), self.abscissae([1.0, 0.0, -1.0]));
        let Darboux { b, .. } = self.frame(v, Beyond::Round).1;
        let mut from = [v; 3];
        for _ in 0..ROUNDS {
            let errors = self.errors(v, &fit, abscissae, Beyond::Round, &mut from);
            let (mut matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
            for (row, ((f, n), lambda)) in errors.iter().zip(abscissae).enumerate() {
                let sign = if row % 2 == 0 { 1.0 } else { -1.0 };
                let across = side * n.dot(&b);
                matrix.set_row(row, &Vector3::new(across, lambda * across, -sign).transpose());
                right[row] = -f;
            }
            let Some(step) = matrix.lu().solve(&right) else { break };
            fit = Fit { o: fit.o + step[0], beta: fit.beta + step[1], eta, E: step[2] };
            if step.fixed_rows::<2>(0).amax() < LAST {
                break;
            }
        }
        fit
    }

    /// The fit faded near B = 0, at a v of the blade.
    #[must_use]
    pub fn faded(&self, v: f64) -> Fit {
        let (full, B) = (self.full(v), (RIM - v).max(0.0));
        if B >= FADES[0] {
            return full;
        }
        let fit = self.without_tilt(v, full.eta * B / FADES[0]);
        Fit { beta: fit.beta * (B / FADES[1]).min(1.0), ..fit }
    }

    /// The least and the greatest of the distance of the axis from the face less a, between two depths.
    #[must_use]
    pub fn error(&self, v: f64, fit: &Fit, [top, bottom]: [f64; 2]) -> [f64; 2] {
        let [through, along] = self.line(v, fit, Beyond::Straight);
        let mut from = v;
        (0..=SAMPLES).fold([f64::INFINITY, f64::NEG_INFINITY], |[least, greatest], look| {
            let lambda = self.middle() - top - (bottom - top) * f64::from(look) / f64::from(SAMPLES);
            let nearest = self.nearest(&(through + along * lambda), from, Beyond::Straight);
            from = nearest.v;
            let f = nearest.distance - self.a;
            [least.min(f), greatest.max(f)]
        })
    }

    /// The faded fit lifted until it leaves no undercut, at any v, straight on beyond the ends. There the face is plane, and
    /// the tilt away from it fades.
    #[must_use]
    pub fn lifted(&self, v: f64) -> Fit {
        let mut fit = self.faded(v.clamp(HUB, RIM));
        let out = (HUB - v).max(v - RIM).max(0.0) * self.part.circle.torus.R;
        let part = (1.0 - out / FADED).max(0.0);
        (fit.o, fit.beta) = (fit.o * part, fit.beta * part);
        let least = self.error(v, &fit, [0.0, self.span[1]])[0];
        Fit { o: fit.o + (-least).max(0.0), ..fit }
    }

    /// What a fit leaves of the face between its depths at most, as far as the face is in the blank.
    #[must_use]
    pub fn rest(&self, v: f64, fit: &Fit) -> f64 {
        let [through, along] = self.line(v, fit, Beyond::Straight);
        let [top, bottom] = self.span;
        let looks = (0..=SAMPLES).map(|look| {
            let lambda = self.middle() - top - (bottom - top) * f64::from(look) / f64::from(SAMPLES);
            let point = through + along * lambda;
            let nearest = self.nearest(&point, v, Beyond::Straight);
            let inside = self.part.trimmed(&(point - nearest.out * nearest.distance));
            if inside { nearest.distance - self.a } else { 0.0 }
        });
        looks.fold(0.0, f64::max)
    }
}
