//! Where the rulings of a face end, and how a face changes between two of its rulings: values at one v, bounds between two.
//!
//! # Units
//! Millimetres and radians, in the part frame.

use crate::geometry::torus::Torus;
use crate::kinds::impeller::part::{Change, Face, HUB, Part, Piece, RIM, Ruling};
use crate::number::trig::sin_cos;

/// Steps in which the turned surface or the floor is looked for along a ruling.
pub(super) const STEPS: u8 = 100;
/// How near to either a ruling has come to it, mm.
pub(super) const NEAR: f64 = 1e-11;
/// What is left to the distance from the axis beside its bound, mm.
const COARSE: f64 = 1e-6;
/// How many times what a straight line may be off it is taken deeper.
const FLATTER: [f64; 3] = [2.0, 8.0, 32.0];

impl Part {
    /// h_1, the depth at which a ruling that begins at the depth `top` first comes to the floor.
    ///
    /// T changes no faster than a point moves, so that steps of what T still lacks never go past that depth. A ruling of a
    /// blade so thick that it passes the axis of the part beside the floor goes on to where it leaves the blank on the
    /// other side: as far beyond the point nearest to the axis as it begins before it.
    #[must_use]
    pub fn floor(&self, ruling: &Ruling, top: f64) -> f64 {
        if let Some(end) = self.end {
            return end;
        }
        let (foot, N) = (ruling.foot.xy(), ruling.N.xy());
        let across = 2.0 * foot.dot(&N) / N.norm_squared() - top;
        let far = if across > top { across.min(self.far()) } else { self.far() };
        let mut h = top;
        for _ in 0..STEPS {
            let lacking = self.a_p - self.depth(&ruling.at(h));
            if lacking <= NEAR {
                return h;
            }
            h += lacking;
            if h >= far {
                break;
            }
        }
        far
    }

    /// No ruling ends deeper than this: it leaves the blank before.
    fn far(&self) -> f64 {
        2.0 * self.circle.torus.R
    }

    /// Depths at two v of a piece such that on a straight line between them no ruling ends deeper; with the rulings at
    /// both v, and how they change over the span between, down to the depth [`Piece::bottom`] at least.
    #[must_use]
    pub fn floors(&self, piece: &Piece, v: [f64; 2], rulings: &[Ruling; 2], change: &Change) -> [f64; 2] {
        let found = self.floors_over(v, rulings, change).map(|(ends, out)| ends.map(|end| end + out));
        let found = found.filter(|ends| ends.iter().all(|&end| end <= piece.bottom));
        found.unwrap_or_else(|| [self.through(v, rulings, change).min(piece.bottom); 2])
    }

    /// No ruling between two v goes on deeper, whether it comes to the floor or not: it leaves the blank before, on the other
    /// side of the axis of the part.
    ///
    /// That is at the depth 2·f − h_0 with f = foot·N/N² in plan. Within half of the span foot and N move by no more than half
    /// of what they change; on the straight end at the hub N is level and the foot moves square to it.
    fn through(&self, v: [f64; 2], rulings: &[Ruling; 2], change: &Change) -> f64 {
        let half = (v[1] - v[0]) / 2.0;
        let tops = v.map(|v| self.top(v));
        let mut deepest = 0.0_f64;
        for Ruling { foot, N } in rulings {
            let (foot, N) = (foot.xy(), N.xy());
            let (turned, length) = (change.turn * half, N.norm());
            let moved = if change.turn == 0.0 && v[1] <= HUB { 0.0 } else { change.speed * half };
            let off = moved * (length + turned) + foot.norm() * turned;
            let [least, most] = [length - turned, length + turned];
            let [near, far] = [foot.dot(&N) - off, foot.dot(&N) + off];
            // One that begins beyond the place nearest to the axis goes on as far as any.
            if least <= 0.0 || near / (most * most) <= tops[0].max(tops[1]) {
                return self.far();
            }
            deepest = deepest.max(2.0 * far / (least * least) - tops[0].min(tops[1]));
        }
        deepest.min(self.far())
    }

    /// Where the rulings at two v end, and by how much a straight line between must be deeper for none to end below it.
    ///
    /// T is bent by no less than −1/ρ along any line, ρ being the distance from the axis of the part. On the line it is
    /// therefore below that of both ends by no more than (V²/ρ + W)/8. Where T exceeds r_f by as much at both ends of a
    /// line some times that deeper, the line is nowhere above the floor; where it does not, nothing is known. Twice is enough but
    /// where rulings come to the floor at a flat angle.
    fn floors_over(&self, v: [f64; 2], rulings: &[Ruling; 2], change: &Change) -> Option<([f64; 2], f64)> {
        let ends = [0, 1].map(|at: usize| self.floor(&rulings[at], self.top(v[at])));
        if self.end.is_some() {
            return Some((ends, 0.0));
        }
        let (span, slide) = (v[1] - v[0], (ends[1] - ends[0]).abs());
        let (speed, turn) = (change.speed * span + slide, change.turn * span);
        let rho = |at: usize, h: f64| {
            let point = rulings[at].at(h);
            (point.x * point.x + point.y * point.y).sqrt()
        };
        let nearest = rho(0, ends[0]).min(rho(1, ends[1])) - speed - COARSE;
        if nearest <= 0.0 {
            return None;
        }
        let sag = (speed * speed / nearest + change.acceleration * span * span + 2.0 * turn * slide) / 8.0;
        let clear = |at: usize, out: f64| {
            let h = ends[at] + out;
            self.depth(&rulings[at].at(h)) - self.a_p >= sag && rho(at, h) - speed / 2.0 >= nearest
        };
        let out = FLATTER.into_iter().map(|times| times * (sag + NEAR)).find(|&out| clear(0, out) && clear(1, out));
        out.map(|out| (ends, out))
    }

    /// A depth below which no ruling of a face between two v goes on, to a quarter of a_p.
    pub(super) fn bottom(&self, face: Face, v: [f64; 2], halvings: u8) -> f64 {
        let rulings = v.map(|v| self.ruling(face, v));
        let deep =
            2.0 * rulings.iter().zip(v).map(|(ruling, v)| self.floor(ruling, self.top(v))).fold(self.a_p, f64::max);
        let found = self
            .floors_over(v, &rulings, &self.change(v, deep))
            .filter(|(ends, out)| ends[0].max(ends[1]) + out <= deep);
        match found {
            Some(([one, other], out)) if out + (one - other).abs() <= self.a_p / 4.0 || halvings == 0 => {
                one.max(other) + out
            }
            _ if halvings == 0 => self.through(v, &rulings, &self.change(v, deep)),
            _ => {
                let middle = f64::midpoint(v[0], v[1]);
                self.bottom(face, [v[0], middle], halvings - 1).max(self.bottom(face, [middle, v[1]], halvings - 1))
            }
        }
    }

    /// Bounds of how the rulings between two v of one piece change, down to a depth.
    ///
    /// # Derivation
    /// With S' = dS/ds, ds = R dv, on the face of the side σ: S' = t·(1 − σ(e/2)κ_g + h·κ_t) + τ·(σ(e/2)·N + h·b). Here
    /// R·κ_t = r/R + (k²/R)·cos v/ρ grows with v, (R·κ_g)² = 1 − (R·κ_t)² and R·τ = k/ρ falls. N_v = −(e_v + c·e_u) with
    /// c = k·cos v/ρ, so that N_vv = −(N − (k sin v/ρ + k R sin v/ρ²)·e_u − c(k/ρ)·e_ρ) in size at most
    /// 1 + k|sin v|(1/ρ + R/ρ²) + |cos v|k²/ρ², and |b_vv| ≤ 1 + 2|N_v| + |N_vv|. |cos v| and 1/ρ are greatest at the
    /// beginning, |sin v| at the end.
    #[must_use]
    pub fn change(&self, [low, high]: [f64; 2], depth: f64) -> Change {
        let Torus { R, r } = self.circle.torus;
        if high <= HUB || low >= RIM {
            return Change { speed: R, acceleration: 0.0, turn: 0.0 };
        }
        let (k, half) = (self.circle.k, self.e / 2.0);
        let turned = [low, high].map(|v| sin_cos(v.clamp(HUB, RIM)));
        let (cos, sin) = (turned.map(|(_, cos)| cos), turned[1].0.abs());
        let rho = R + r * cos[0];
        let along = cos.map(|cos| r / R + k * k / R * cos / (R + r * cos));
        let least = if along[0] <= 0.0 && along[1] >= 0.0 { 0.0 } else { along[0].abs().min(along[1].abs()) };
        let aside = (1.0 - least * least).max(0.0).sqrt();
        let forward = R + half * aside + along.map(|along| (along * depth).abs()).into_iter().fold(0.0, f64::max);
        let twist = k / rho;
        let turn = (1.0 + (twist * cos[0]) * (twist * cos[0])).sqrt();
        let turned = 1.0 + k * sin * (1.0 / rho + R / (rho * rho)) + cos[0].abs() * twist * twist;
        Change {
            speed: (forward * forward + twist * twist * (half * half + depth * depth)).sqrt(),
            acceleration: R + half * (1.0 + 2.0 * turn + turned) + depth * turned,
            turn,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;
    use crate::kinds::impeller::part::tests::parts;
    use crate::number::trig::hypot;

    #[test]
    fn no_ruling_of_a_span_ends_below_the_line_between_its_floors() {
        for part in parts() {
            for face in Face::ALL {
                for piece in part.pieces(face) {
                    let span = (piece.v[1] - piece.v[0]) / 32.0;
                    for step in 0..32_u8 {
                        let low = piece.v[0] + span * f64::from(step);
                        let (v, change) = ([low, low + span], part.change([low, low + span], piece.bottom));
                        let rulings = v.map(|v| part.ruling(face, v));
                        let line = part.floors(&piece, v, &rulings, &change);
                        for k in 0..=20 {
                            let at = f64::from(k) / 20.0;
                            let v = low + span * at;
                            let end = part.floor(&part.ruling(face, v), part.top(v));
                            assert!(end <= line[0] + (line[1] - line[0]) * at, "{v} {end} {line:?}");
                        }
                        // With the span it closes up.
                        let near = [low, low + span / 64.0];
                        let rulings = near.map(|v| part.ruling(face, v));
                        let line = part.floors(&piece, near, &rulings, &part.change(near, piece.bottom));
                        let end = part.floor(&rulings[0], part.top(low));
                        assert!(line[0] - end < 1e-4 * part.a_p, "{low} {end} {line:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_ruling_that_passes_the_axis_beside_the_floor_ends_on_the_far_side() {
        // Blades thicker than the hub.
        let part = Part::with(Torus { R: 25.0, r: 17.0 }, 7.0, 4.0);
        let piece = part.pieces(Face::Obverse)[0];
        let edge = part.ruling(Face::Obverse, piece.v[0]);
        let end = part.floor(&edge, part.top(HUB));
        let across = edge.at(end);
        assert!((hypot(across.x, across.y) - hypot(edge.at(part.top(HUB)).x, edge.at(part.top(HUB)).y)).abs() < 1e-9);
        assert!(across.xy().dot(&edge.foot.xy()) < 0.0 && piece.bottom >= end);
    }

    /// Of a blade as thick as the hub, rulings pass the axis beside the floor or come to it at a flat angle.
    #[test]
    fn of_thick_blades_no_ruling_ends_below_what_is_known_and_most_is_known() {
        for (R, r, e, a_p) in
            [(24.868, 17.389, 5.203, 3.923), (14.112, 9.253, 2.885, 3.56), (17.154, 6.952, 4.928, 3.834)]
        {
            let part = Part::with(Torus { R, r }, e, a_p);
            for piece in Face::ALL.into_iter().flat_map(|face| part.pieces(face)) {
                // Farther than across the hub nothing goes.
                assert!(piece.bottom < 2.2 * (R - r), "{piece:?}");
                let (steps, mut loose) = (512_u32, 0);
                let span = (piece.v[1] - piece.v[0]) / f64::from(steps);
                for step in 0..steps {
                    let low = piece.v[0] + span * f64::from(step);
                    let v = [low, low + span];
                    let rulings = v.map(|v| part.ruling(piece.face, v));
                    let line = part.floors(&piece, v, &rulings, &part.change(v, piece.bottom));
                    let mut deepest = f64::MIN;
                    for k in 0..=8 {
                        let at = f64::from(k) / 8.0;
                        let v = low + span * at;
                        let end = part.floor(&part.ruling(piece.face, v), part.top(v));
                        assert!(end <= line[0] + (line[1] - line[0]) * at + 1e-9, "{v} {end} {line:?}");
                        deepest = deepest.max(end);
                    }
                    loose += u32::from(line[0].max(line[1]) > deepest + 0.1 * a_p);
                }
                assert!(loose < 8, "{piece:?} {loose}");
            }
        }
    }

    #[test]
    fn nothing_of_a_face_changes_faster_than_its_bounds() {
        for part in parts() {
            let step = 1e-4;
            for from in 0..16_u8 {
                let low = HUB + f64::from(from) * FRAC_PI_2 / 16.0;
                let deep = part.pieces(Face::Reverse)[0].bottom;
                let bound = part.change([low, low + FRAC_PI_2 / 16.0], deep);
                for (face, h, at) in [
                    (Face::Obverse, 0.0, 0.1),
                    (Face::Obverse, deep, 0.9),
                    (Face::Reverse, 0.0, 0.9),
                    (Face::Reverse, deep, 0.1),
                    (Face::Reverse, deep, 0.5),
                ] {
                    let v = low + at * FRAC_PI_2 / 16.0;
                    let [before, here, after] = [v - step, v, v + step].map(|v| part.ruling(face, v));
                    let speed = (after.at(h) - before.at(h)).norm() / (2.0 * step);
                    let bent = (after.at(h) - here.at(h) * 2.0 + before.at(h)).norm() / (step * step);
                    let turn = (after.N - before.N).norm() / (2.0 * step);
                    assert!(speed <= bound.speed + 1e-6 && speed > 0.6 * bound.speed, "{speed} {bound:?}");
                    assert!(bent <= bound.acceleration + 1e-3, "{bent} {bound:?}");
                    assert!(turn <= bound.turn + 1e-6, "{turn} {bound:?}");
                }
            }
        }
    }
}
