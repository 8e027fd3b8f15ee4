//! What the part is: faces, tops and floor of its blades, as they are judged. In one place, whatever asks.
//!
//! - A blade's mean surface is made of rulings P(v) − h·N(v); blade i stands 2π·i/N further about Z.
//! - Faces: S±(v, h) = P(v) ± (e/2)·b(v) − h·N(v), obverse + and reverse −. The thickness is e, measured along b, at
//!   every depth.
//! - Ends: v runs over [π, 3π/2]; beyond, a face goes straight on along t with the frame of the end point. What is not in
//!   the blank is cut off: z ≤ 0 at the hub, x² + y² ≤ R² at the rim. So the obverse goes on at the hub and the reverse at
//!   the rim, about (e/2)·cot α each, and the other two begin inside.
//! - Tops: the turned surface T = r, T being the distance from the circle in the middle of the tube. Floor: T = r + a_p.
//! - A ruling runs from the depth h_0 = −(e/2)²·κ_b/2 − δ, since the torus rises above its tangent plane, to h_1, where it first
//!   comes to the floor. The first term is that of second order; δ is the most by which a ruling between the hub and there truly begins
//!   higher: on the obverse, the thicker the blade the more (0.001 mm for R 25, e 2; 0.44 mm for R 100, e 40). With it no metal is left
//!   out, and h_0 does not grow with v. Between the ends of the blade that is near a_p; on the straight ends, where the floor falls away
//!   from the tangent plane, it is deeper, the thicker the blade the more.
//!
//! # Units
//! Millimetres and radians, in the part frame.

mod ends;

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::Vector3;

use crate::geometry::darboux::{Darboux, opposite};
use crate::geometry::torus::Torus;
use crate::geometry::villarceau::Villarceau;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::part::ends::{NEAR, STEPS};
use crate::number::root::quadratic;
use crate::number::trig::sin_cos;

/// v where a blade begins, at the hub.
pub const HUB: f64 = PI;
/// v where a blade ends, at the rim.
pub const RIM: f64 = PI + FRAC_PI_2;

/// The two faces of a blade, seen from its mean surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Face {
    /// On the side of +b.
    Obverse,
    /// On the side of −b.
    Reverse,
}

impl Face {
    /// Both of them.
    pub const ALL: [Self; 2] = [Self::Obverse, Self::Reverse];

    /// On which side of the mean surface it lies: 1 towards +b, −1 towards −b.
    #[must_use]
    pub const fn side(self) -> f64 {
        match self {
            Self::Obverse => 1.0,
            Self::Reverse => -1.0,
        }
    }
}

/// A straight line of a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ruling {
    /// Where it meets the tangent plane of the mean line: h = 0.
    pub foot: Vector3<f64>,
    /// N, out of the metal.
    pub N: Vector3<f64>,
}

impl Ruling {
    /// The point at the depth h.
    #[must_use]
    pub fn at(&self, h: f64) -> Vector3<f64> {
        self.foot - self.N * h
    }
}

/// A part of a face over which it is smooth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// The face of which it is a part.
    pub face: Face,
    /// Where it begins and ends: v, run on beyond the ends of the blade at R a radian.
    pub v: [f64; 2],
    /// No ruling of it ends deeper than here, mm.
    pub bottom: f64,
}

/// How fast the rulings between two v change, for each radian of v.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change {
    /// No point of the face moves faster, mm.
    pub speed: f64,
    /// And none is accelerated more, mm.
    pub acceleration: f64,
    /// N turns no faster.
    pub turn: f64,
}

/// The part of a design: one blade and the turned surfaces between which it stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// The mean line's circle, with the torus.
    pub circle: Villarceau,
    /// e, the thickness, mm along b.
    pub e: f64,
    /// a_p, how deep the floor lies.
    pub a_p: f64,
    /// The depth at which all rulings end instead of at the floor.
    end: Option<f64>,
    /// δ at even steps from the hub to the rim.
    rise: [f64; RISES + 1],
}

/// Steps between hub and rim at whose ends δ is known.
const RISES: usize = 32;
/// Places of each of them at which it is looked how high a ruling begins, and the part that may be missed between them: with the square of
/// their distance, far less than this.
const PLACES: u8 = 4;
const MISSED: f64 = 0.01;

/// Steps of f at whose ends it is looked how high the half round of a splitter begins.
const NOSE_PLACES: u8 = 64;

/// How often a piece is halved at most to find how deep its rulings end.
const HALVINGS: u8 = 8;

impl Part {
    /// The part of a design: torus, e and a_p. How many blades there are is not asked.
    #[must_use]
    pub fn new(design: &Design) -> Self {
        Self::with(design.torus, design.e, design.a_p)
    }

    /// The part on a torus (0 < r < R) with blades of the thickness e, the floor a_p deep.
    #[must_use]
    pub fn with(torus: Torus, e: f64, a_p: f64) -> Self {
        let mut part = Self { circle: Villarceau::new(torus), e, a_p, end: None, rise: [0.0; RISES + 1] };
        if e > 0.0 {
            part.rise = part.rises();
        }
        part
    }

    /// δ at the steps from the hub to the rim: at each the most up to the next one, so that a straight line between two is nowhere less.
    fn rises(&self) -> [f64; RISES + 1] {
        let mut rises = [0.0; RISES + 1];
        let (mut most, mut v) = (0.0_f64, HUB);
        let place = (RIM - HUB) / (RISES as f64 * f64::from(PLACES));
        for rise in &mut rises {
            for _ in 0..PLACES {
                most = Face::ALL.iter().fold(most, |most, &face| most.max(self.above(face, v)));
                v = (v + place).min(RIM);
            }
            *rise = most.max(self.above(Face::Obverse, v)).max(self.above(Face::Reverse, v)) * (1.0 + MISSED);
        }
        rises
    }

    /// How far above the depth that the curvature gives it a ruling begins.
    fn above(&self, face: Face, v: f64) -> f64 {
        self.rise_of(&self.ruling(face, v), self.top(v))
    }

    /// How far above a depth a ruling begins, if it does; else 0. One that does not enter the tube within half its radius is of a blade
    /// nearly as thick as the tube is wide: of that the curvature tells all.
    fn rise_of(&self, ruling: &Ruling, top: f64) -> f64 {
        let r = self.circle.torus.r;
        // T falls no faster than a point moves: from there up to where the tube is entered, never past it.
        let mut h = top;
        for _ in 0..STEPS {
            let above = self.depth(&ruling.at(h));
            if above <= NEAR {
                return top - h;
            }
            h -= above;
            if top - h > r / 2.0 {
                break;
            }
        }
        0.0
    }

    /// The ruling of the half round with which a splitter begins at v_s, on the side −cos f·t + sin f·b of the mean one, f from −π/2 to π/2.
    #[must_use]
    pub fn nose(&self, v_s: f64, f: f64) -> Ruling {
        let (P, Darboux { N, t, b }) = self.frame(v_s);
        let (sin, cos) = sin_cos(f);
        Ruling { foot: P + (b * sin - t * cos) * (self.e / 2.0), N }
    }

    /// The depth at which the ruling of a half round begins: along the tube the torus bends more than across the blade.
    #[must_use]
    pub fn nose_top(&self, v_s: f64, f: f64) -> f64 {
        let top = self.top(v_s);
        if self.end.is_some() { top } else { top - self.rise_of(&self.nose(v_s, f), top) }
    }

    /// Depths above which no ruling of the half round begins, and below which none goes on: out of the tube's bend the floor falls away.
    /// What may lie between the places that are looked at is of second order in their distance.
    #[must_use]
    pub fn noses_ends(&self, v_s: f64) -> [f64; 2] {
        let ends = (0..=NOSE_PLACES).map(|place| {
            let f = PI * (f64::from(place) / f64::from(NOSE_PLACES) - 0.5);
            [self.nose_top(v_s, f), self.floor(&self.nose(v_s, f), self.top(v_s))]
        });
        let mut range = [[f64::MAX, f64::MIN]; 2];
        for end in ends {
            for (range, end) in range.iter_mut().zip(end) {
                *range = [range[0].min(end), range[1].max(end)];
            }
        }
        let [tops, bottoms] = range;
        let missed = |[least, most]: [f64; 2]| (most - least) * MISSED;
        [tops[0] - missed(tops), bottoms[1] + missed(bottoms)]
    }

    /// The same part, but its rulings all end at the depth h and not at the floor: what published figures with a limit of
    /// h alike for all are compared with; they begin where the curvature says. On the straight ends the floor may lie deeper.
    #[must_use]
    pub const fn ending_at(self, h: f64) -> Self {
        Self { end: Some(h), rise: [0.0; RISES + 1], ..self }
    }

    /// The frame at v, and the point of the mean line; straight on beyond the ends.
    #[inline]
    #[must_use]
    pub fn frame(&self, v: f64) -> (Vector3<f64>, Darboux) {
        self.frame_at(v, sin_cos(v.clamp(HUB, RIM)))
    }

    /// The same, and h_0 there: both need one sine and cosine.
    #[inline]
    #[must_use]
    pub fn frame_and_top(&self, v: f64) -> (Vector3<f64>, Darboux, f64) {
        let turned = sin_cos(v.clamp(HUB, RIM));
        let (P, frame) = self.frame_at(v, turned);
        (P, frame, self.top_at(v, turned.1))
    }

    /// The same where sine and cosine of v, or of the end that it is beyond, are known.
    #[inline]
    #[must_use]
    pub fn frame_at(&self, v: f64, (sin_v, cos_v): (f64, f64)) -> (Vector3<f64>, Darboux) {
        let Torus { R, r } = self.circle.torus;
        let end = v.clamp(HUB, RIM);
        let (rho, k) = (R + r * cos_v, self.circle.k);
        let (cos_u, sin_u) = (k * sin_v / rho, -(r + R * cos_v) / rho);
        let N = opposite(Vector3::new(cos_v * cos_u, cos_v * sin_u, sin_v));
        // X_u·k/ρ + X_v, over R.
        let along = |around: f64, along_v: f64| (around * k + along_v * r) / R;
        let t = Vector3::new(along(-sin_u, -sin_v * cos_u), along(cos_u, -sin_v * sin_u), along(0.0, cos_v));
        let on = R * (v - end);
        let P = Vector3::new(rho * cos_u + t.x * on, rho * sin_u + t.y * on, r * sin_v + t.z * on);
        (P, Darboux { N, t, b: t.cross(&N) })
    }

    /// The ruling of a face at v (radians); beyond the blade's ends v runs on at R a radian.
    #[inline]
    #[must_use]
    pub fn ruling(&self, face: Face, v: f64) -> Ruling {
        let (P, Darboux { N, b, .. }) = self.frame(v);
        Ruling { foot: P + b * (face.side() * self.e / 2.0), N }
    }

    /// κ_b at v, the curvature of the torus across the mean line: cos²α/r + sin²α·cos v/ρ. It grows with v.
    #[must_use]
    pub fn across(&self, v: f64) -> f64 {
        self.across_at(sin_cos(v.clamp(HUB, RIM)).1)
    }

    fn across_at(&self, cos_v: f64) -> f64 {
        let Torus { R, r } = self.circle.torus;
        let (sin2, cos2) = (r * r / (R * R), self.circle.k * self.circle.k / (R * R));
        cos2 / r + sin2 * cos_v / (R + r * cos_v)
    }

    /// h_0, the depth at which the ruling at v begins. It does not grow with v.
    #[inline]
    #[must_use]
    pub fn top(&self, v: f64) -> f64 {
        self.top_at(v, sin_cos(v.clamp(HUB, RIM)).1)
    }

    fn top_at(&self, v: f64, cos_v: f64) -> f64 {
        let at = ((v - HUB) / (RIM - HUB)).clamp(0.0, 1.0) * RISES as f64;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a step of δ, from 0 on")]
        let step = (at as usize).min(RISES - 1);
        let rise = self.rise[step] + (self.rise[step + 1] - self.rise[step]) * (at - step as f64);
        -self.e * self.e / 8.0 * self.across_at(cos_v) - rise
    }

    /// How far the upper ends of its rulings stand above the turned surface at most, at the hub, where the blade goes straight
    /// on by (e/2)·cot α: (e/2)²/(2(R − r)·sin²α), and δ. Nothing for a part whose rulings all end alike.
    #[must_use]
    pub fn overhang(&self) -> f64 {
        let Torus { R, r } = self.circle.torus;
        let out = self.e / 2.0 * R / r;
        if self.end.is_some() { 0.0 } else { out * out / (2.0 * (R - r)) + self.rise[RISES] }
    }

    /// True for a point between the hub plane and the rim cylinder.
    #[must_use]
    pub fn trimmed(&self, point: &Vector3<f64>) -> bool {
        let R = self.circle.torus.R;
        point.z <= 0.0 && point.x * point.x + point.y * point.y <= R * R
    }

    /// How deep a point lies below the tops, T − r; the floor has the depth a_p.
    #[must_use]
    pub fn depth(&self, point: &Vector3<f64>) -> f64 {
        let Torus { R, r } = self.circle.torus;
        // Roots and not hypot: no square of a length of the part runs over, and this is where most of the time goes.
        let beside = (point.x * point.x + point.y * point.y).sqrt() - R;
        (beside * beside + point.z * point.z).sqrt() - r
    }

    /// The pieces of a face, from the hub to the rim.
    ///
    /// At the hub N is level, so that a whole ruling comes out of the blank at once: where z + x·t_z = 0. At the rim N is
    /// upright, and one does where |foot + x·t| = R in plan.
    #[must_use]
    pub fn pieces(&self, face: Face) -> Vec<Piece> {
        let piece = |v: [f64; 2]| Piece { face, v, bottom: self.bottom(face, v, HALVINGS) };
        self.stretches(face).into_iter().map(piece).collect()
    }

    /// The v of the same.
    #[must_use]
    pub fn stretches(&self, face: Face) -> Vec<[f64; 2]> {
        let R = self.circle.torus.R;
        let straight = |v: f64| {
            let t = self.frame(v).1.t;
            (self.ruling(face, v).foot, t)
        };
        let mut stretches = Vec::with_capacity(2);
        let (foot, t) = straight(HUB);
        if foot.z < 0.0 && t.z < 0.0 {
            stretches.push([HUB - foot.z / t.z / R, HUB]);
        }
        stretches.push([HUB, RIM]);
        let (foot, t) = straight(RIM);
        let (square, along) = (t.x * t.x + t.y * t.y, foot.x * t.x + foot.y * t.y);
        if let Some([_, x]) = quadratic(square, 2.0 * along, foot.x * foot.x + foot.y * foot.y - R * R)
            && x > 0.0
        {
            stretches.push([RIM, RIM + x / R]);
        }
        stretches
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::trig::hypot;

    const DESIGNS: [(f64, f64, f64, f64); 4] =
        [(25.0, 15.0, 2.0, 2.0), (25.0, 15.0, 3.7, 2.0), (25.0, 17.0, 1.0, 4.0), (50.0, 30.0, 2.0, 3.0)];

    pub(super) fn parts() -> impl Iterator<Item = Part> {
        DESIGNS.into_iter().map(|(R, r, e, a_p)| Part::with(Torus { R, r }, e, a_p))
    }

    #[test]
    fn the_frame_is_that_of_the_tables_and_goes_straight_on_beyond_the_ends() {
        for part in parts() {
            for v in [HUB, 3.4, 4.0, RIM] {
                let u = part.circle.u(v);
                let (P, frame) = part.frame(v);
                let table = Darboux::of(part.circle, u, v);
                assert!((P - part.circle.torus.point(u, v)).norm() < 1e-12);
                assert!((frame.t - table.t).norm() < 1e-12 && (frame.N - table.N).norm() < 1e-12);
            }
            let ((P, frame), (end, at_end)) = (part.frame(HUB - 0.1), part.frame(HUB));
            assert_eq!(frame, at_end);
            assert!((P - end + frame.t * (0.1 * part.circle.torus.R)).norm() < 1e-12);
        }
    }

    #[test]
    fn faces_go_on_by_half_the_thickness_over_the_tangent_of_alpha_and_end_in_the_blank() {
        for part in parts() {
            let Torus { R, r } = part.circle.torus;
            let straight = part.e / 2.0 * part.circle.k / r;
            let [obverse, reverse] = Face::ALL.map(|face| part.pieces(face));
            assert_eq!((obverse.len(), reverse.len()), (2, 2));
            assert!(((HUB - obverse[0].v[0]) * R - straight).abs() < 1e-9, "the hub plane cuts it off there");
            // The rim is round: there it is a little shorter.
            let at_rim = (reverse[1].v[1] - RIM) * R;
            assert!(at_rim <= straight && at_rim > 0.85 * straight, "{at_rim} {straight}");
            let (deep, edge) = (obverse[0].bottom, part.ruling(Face::Obverse, obverse[0].v[0]));
            assert!([0.0, deep].iter().all(|&h| edge.at(h).z.abs() < 1e-12));
            let edge = part.ruling(Face::Reverse, reverse[1].v[1]);
            assert!([0.0, deep].iter().all(|&h| (hypot(edge.at(h).x, edge.at(h).y) - R).abs() < 1e-12));
            // The other two come out of the blank before their ends.
            assert!(!part.trimmed(&part.ruling(Face::Reverse, HUB).foot));
            assert!(!part.trimmed(&part.ruling(Face::Obverse, RIM).foot));
        }
    }

    /// Recomputed from outside: a nose of 50 mm was cut 0.10 mm too deep, where the height of the faces' rulings was taken for its own.
    #[test]
    fn no_metal_of_a_half_round_stands_above_its_highest_ruling() {
        let thick = [(60.0, 36.0, 14.0, 6.0), (100.0, 65.0, 24.0, 8.0), (200.0, 140.0, 50.0, 12.0)];
        for (R, r, e, a_p) in DESIGNS.into_iter().chain(thick) {
            let part = Part::with(Torus { R, r }, e, a_p);
            for v_s in [HUB + 0.2, 3.7, 4.2, RIM - 0.2] {
                let [highest, deepest] = part.noses_ends(v_s);
                let mut least = f64::MAX;
                for step in 0..=777_u16 {
                    let f = PI * (f64::from(step) / 777.0 - 0.5);
                    let ruling = part.nose(v_s, f);
                    // From far up down to the first metal, in small steps.
                    let first = (0..4000_u16)
                        .map(|k| highest - 1.0 + f64::from(k) * 0.001)
                        .find(|&h| part.depth(&ruling.at(h)) > 1e-9);
                    least = least.min(first.unwrap_or(f64::MAX));
                    assert!(part.floor(&ruling, part.top(v_s)) <= deepest, "{R} {v_s}: {deepest}");
                }
                assert!((highest - 1e-9..highest + 0.05 * e).contains(&least), "{R} {v_s}: {highest} {least}");
            }
        }
    }

    /// A simulation found 0.23 mm cut off the upper edge of a blade of 40 mm, where the curvature alone says how high it is.
    #[test]
    fn no_metal_of_a_blade_stands_above_its_rulings() {
        let thick = [(100.0, 40.0, 40.0, 10.0), (200.0, 60.0, 60.0, 20.0), (96.0, 39.0, 18.0, 5.0)];
        for (R, r, e, a_p) in DESIGNS.into_iter().chain(thick) {
            let part = Part::with(Torus { R, r }, e, a_p);
            let mut highest = f64::MIN;
            for step in 0..=997_u16 {
                let v = HUB + (RIM - HUB) * f64::from(step) / 997.0;
                for face in Face::ALL {
                    highest = highest.max(part.depth(&part.ruling(face, v).at(part.top(v))));
                }
            }
            // It begins in the air, and at the highest place just at the turned surface.
            assert!(highest <= 0.0 && highest > -0.02 * part.rise[RISES] - 1e-9, "{R} {e}: {highest} {:?}", part.rise);
        }
        let shipped = Part::with(Torus { R: 25.0, r: 15.0 }, 2.0, 2.0);
        assert!((shipped.rise[RISES] - 0.00085).abs() < 2e-5, "{:?}", shipped.rise);
    }

    #[test]
    fn rulings_run_from_the_tops_to_the_floor_that_is_there() {
        for part in parts() {
            for face in Face::ALL {
                for piece in part.pieces(face) {
                    for step in 0..=40 {
                        let v = piece.v[0] + (piece.v[1] - piece.v[0]) * f64::from(step) / 40.0;
                        let (ruling, top) = (part.ruling(face, v), part.top(v));
                        if (HUB..=RIM).contains(&v) {
                            // In the air, of third order in e over r.
                            let above = -part.depth(&ruling.at(top));
                            assert!((-1e-9..0.02).contains(&above), "{v} {above}");
                        }
                        let end = part.floor(&ruling, top);
                        assert!((part.depth(&ruling.at(end)) - part.a_p).abs() < 1e-9, "{v} {end}");
                        assert!((0..200).all(|k| {
                            let h = top + (end - top) * f64::from(k) / 200.0;
                            part.depth(&ruling.at(h)) < part.a_p
                        }));
                        assert!(end <= piece.bottom && piece.bottom < end + part.a_p, "{v} {end} {piece:?}");
                        assert_eq!(part.ending_at(1.5).floor(&ruling, top), 1.5);
                    }
                }
            }
        }
        // The straight ends go on below a limit of h alike for all, a_p + (e/2)²/(2(R − r − a_p)).
        for (e, deep, limit) in [(2.0, 2.176, 2.0625), (3.7, 2.618, 2.2139)] {
            let part = Part::with(Torus { R: 25.0, r: 15.0 }, e, 2.0);
            let edge = part.ruling(Face::Obverse, part.pieces(Face::Obverse)[0].v[0]);
            let end = part.floor(&edge, part.top(HUB));
            assert!((end - deep).abs() < 5e-4 && end > limit + 0.1, "{e} {end}");
        }
    }

    #[test]
    fn the_curvature_across_the_mean_line_is_that_of_the_check_values() {
        // Check values of κ_b for R 25, r 15: at the hub, in the middle, at the rim.
        let part = Part::with(Torus { R: 25.0, r: 15.0 }, 2.0, 2.0);
        let found = [HUB, HUB + FRAC_PI_2 / 2.0, RIM].map(|v| format!("{:.6}", part.across(v)));
        assert_eq!(found, ["0.006667", "0.024981", "0.042667"]);
    }
}
