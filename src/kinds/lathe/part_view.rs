//! The turned part in space, as the report's cover shows it.
//!
//! Seen from the free end, along a direction t with t_z > 0. The part is parted at every corner's z into slabs, and these
//! are drawn from the chuck to the free end: on its way to the eye a ray only gains z, so that no slab hides a later one.
//! A slab holds rings, which do not cross. With u the direction of t across the axis, a ray gains u too: on the far side
//! (u < 0) outer rings lie behind inner ones, on the near side inner behind outer, so that rings are drawn by sign(u) r.
//! Where the part is hollow a quarter is cut out about u. At one distance v beside the axis the planes of the cut stand at
//! u = |v|, and what is left of the near side at u ≤ |v|: there too the greater r comes later.

use std::f64::consts::{FRAC_PI_4, TAU};

use nalgebra::Vector3;

use super::drawn::Contour;
use crate::figure::{Figure, Ink, Stroke};
use crate::geometry::scene::{Camera, Scene};
use crate::number::trig::{atan2, cos, hypot, sin_cos};
use crate::text::t;

/// Sectors of the part; the quarter that is cut out is a whole number of them.
const SECTORS: u16 = 72;
/// Most slabs.
const SLABS: usize = 400;
/// Cosine of the least bend at a corner that is drawn as an edge.
const SHARP: f64 = 0.9;

/// A straight piece of a contour within one slab, or between two where it stands across the axis.
#[derive(Clone, Copy, Debug)]
struct Piece {
    from: [f64; 2],
    to: [f64; 2],
    /// The corner at its beginning, at its end, is an edge of the part.
    sharp: [bool; 2],
}

impl Piece {
    fn radius(&self) -> f64 {
        f64::midpoint(self.from[1], self.to[1])
    }

    /// On the axis, where there is no surface.
    fn bare(&self) -> bool {
        self.from[1] <= 0.0 && self.to[1] <= 0.0
    }
}

/// The pieces by slab: those along it, and those that stand where it begins.
#[derive(Clone, Debug, Default)]
struct Slab {
    along: Vec<Piece>,
    across: Vec<Piece>,
}

/// The part in space, its free end to the right, a quarter of it cut out where it is hollow. Contours `[z, r]` in mm,
/// counter-clockwise, those of hollows clockwise.
pub(super) fn cover(part: &[Contour]) -> Figure {
    let camera = Camera::new(-56.0, 24.0);
    Figure {
        letters: Figure::LETTERS,
        key: "cover",
        height: 118.0,
        caption: t("La pieza torneada", "The turned part"),
        axes: None,
        strokes: Drawing { camera, scene: Scene::new(camera), slabs: slabs(part) }.strokes(),
        labels: Vec::new(),
        legend: Vec::new(),
    }
}

struct Drawing {
    camera: Camera,
    scene: Scene,
    slabs: Vec<Slab>,
}

impl Drawing {
    fn strokes(&self) -> Vec<Stroke> {
        let towards = self.camera.towards();
        let near = atan2(towards.z, towards.y);
        let turn = |sector: u16| near + TAU * f64::from(sector) / f64::from(SECTORS);
        let hollow = self.slabs.iter().any(|slab| {
            slab.along.iter().map(Piece::radius).min_by(f64::total_cmp).is_some_and(|innermost| innermost > 0.0)
        });
        let sectors = if hollow { SECTORS / 8..SECTORS - SECTORS / 8 } else { 0..SECTORS };
        let mut strokes = Vec::new();
        for slab in &self.slabs {
            let mut drawn: Vec<(f64, Vec<Stroke>)> = Vec::new();
            for piece in &slab.across {
                for sector in sectors.clone() {
                    strokes.extend(self.facet(piece, turn(sector), turn(sector + 1)));
                }
                if hollow {
                    let lines: Vec<Stroke> = self.cut_lines(piece, near).into();
                    strokes.extend(lines.clone());
                    // The slab's own cut would cover half of their width.
                    drawn.push((piece.from[1].max(piece.to[1]), lines));
                }
            }
            for piece in &slab.along {
                for sector in sectors.clone() {
                    let middle = f64::midpoint(turn(sector), turn(sector + 1));
                    let key = piece.radius() * cos(middle - near).signum();
                    drawn.push((key, self.facet(piece, turn(sector), turn(sector + 1))));
                }
            }
            if hollow {
                let mut layers = slab.along.clone();
                layers.sort_by(|one, other| one.radius().total_cmp(&other.radius()));
                for pair in layers.chunks_exact(2) {
                    let [inner, outer] = pair else { continue };
                    drawn.push((outer.radius(), self.cut(inner, outer, near)));
                }
            }
            drawn.sort_by(|one, other| one.0.total_cmp(&other.0));
            strokes.extend(drawn.into_iter().flat_map(|(_, strokes)| strokes));
        }
        strokes
    }

    /// What a piece makes over a sector: the face with its edges, where it is seen from in front.
    fn facet(&self, piece: &Piece, from: f64, to: f64) -> Vec<Stroke> {
        if piece.bare() {
            return Vec::new();
        }
        let corners = [point(piece.from, from), point(piece.to, from), point(piece.to, to), point(piece.from, to)];
        let Some(face) = self.scene.face(&corners) else { return Vec::new() };
        let mut strokes = vec![face];
        let mut edge = |one: usize, other: usize| {
            strokes.push(self.camera.curve(Ink::Outline, [corners[one], corners[other]]));
        };
        if piece.sharp[0] && piece.from[1] > 0.0 {
            edge(0, 3);
        }
        if piece.sharp[1] && piece.to[1] > 0.0 {
            edge(1, 2);
        }
        // Where the surface turns away from the eye.
        let step = to - from;
        for (at, by, [one, other]) in [(from, -step, [0, 1]), (to, step, [3, 2])] {
            let normal = outward(piece, at + by / 2.0);
            if !self.camera.faces(&normal) {
                strokes.push(self.camera.curve(Ink::Outline, [corners[one], corners[other]]));
            }
        }
        strokes
    }

    /// The metal between two pieces in both planes of the cut.
    fn cut(&self, inner: &Piece, outer: &Piece, near: f64) -> Vec<Stroke> {
        let ends =
            |piece: &Piece| if piece.from[0] < piece.to[0] { [piece.from, piece.to] } else { [piece.to, piece.from] };
        let ([a, b], [d, c]) = (ends(inner), ends(outer));
        let planes = [near - FRAC_PI_4, near + FRAC_PI_4];
        let mut strokes = planes
            .map(|turn| Stroke {
                filled: true,
                ..self.camera.curve(Ink::Obverse, [a, b, c, d].map(|corner| point(corner, turn)))
            })
            .to_vec();
        for piece in [inner, outer].into_iter().filter(|piece| !piece.bare()) {
            strokes.extend(self.cut_lines(piece, near));
        }
        strokes
    }

    fn cut_lines(&self, piece: &Piece, near: f64) -> [Stroke; 2] {
        [near - FRAC_PI_4, near + FRAC_PI_4]
            .map(|turn| self.camera.curve(Ink::Outline, [piece.from, piece.to].map(|end| point(end, turn))))
    }
}

fn point([z, r]: [f64; 2], turn: f64) -> Vector3<f64> {
    let (sin, cos) = sin_cos(turn);
    Vector3::new(z, r * cos, r * sin)
}

/// Out of the metal, which lies to the left of a piece.
fn outward(piece: &Piece, turn: f64) -> Vector3<f64> {
    let (sin, cos) = sin_cos(turn);
    let [dz, dr] = [0, 1].map(|axis| piece.to[axis] - piece.from[axis]);
    Vector3::new(dr, -dz * cos, -dz * sin)
}

/// The contours parted at every corner's z, from the chuck to the free end.
fn slabs(part: &[Contour]) -> Vec<Slab> {
    let points = || part.iter().flatten();
    let [left, right] = points().fold([f64::INFINITY, f64::NEG_INFINITY], |[l, r], at| [l.min(at[0]), r.max(at[0])]);
    let size = points().fold(right - left, |most, at| most.max(2.0 * at[1]));
    if !(size.is_finite() && size > 0.0) {
        return Vec::new();
    }
    let mut within = size / 2000.0;
    let (contours, places) = loop {
        let contours: Vec<Contour> = part.iter().map(|contour| sketched(contour, within)).collect();
        let mut places: Vec<f64> = contours.iter().flatten().map(|at| at[0]).collect();
        places.sort_by(f64::total_cmp);
        places.dedup_by(|one, other| *one - *other < size * 1e-5);
        if places.len() <= SLABS || within > size {
            break (contours, places);
        }
        within *= 1.5;
    };
    // One more than there are slabs: faces at the free end stand where none begins.
    let mut slabs = vec![Slab::default(); places.len()];
    let place = |z: f64| places.partition_point(|&at| at <= z + size * 2e-5).saturating_sub(1);
    for contour in &contours {
        let sharp: Vec<bool> = (0..contour.len()).map(|at| bends(contour, at)).collect();
        for (at, &from) in contour.iter().enumerate() {
            let after = (at + 1) % contour.len();
            let to = contour.get(after).copied().unwrap_or(from);
            let ends = [at, after].map(|at| sharp.get(at).copied().unwrap_or(false));
            let (first, last) = (place(from[0]), place(to[0]));
            if first == last {
                if let Some(slab) = slabs.get_mut(first) {
                    slab.across.push(Piece { from, to, sharp: ends });
                }
                continue;
            }
            let at_place = |index: usize| {
                let z = places.get(index).copied().unwrap_or(to[0]);
                let r = from[1] + (to[1] - from[1]) * (z - from[0]) / (to[0] - from[0]);
                [z, if from[1].max(to[1]) > 0.0 { r.max(0.0) } else { 0.0 }]
            };
            for index in first.min(last)..first.max(last) {
                let (a, b) = if first < last { (index, index + 1) } else { (index + 1, index) };
                let piece = Piece {
                    from: if a == first { from } else { at_place(a) },
                    to: if b == last { to } else { at_place(b) },
                    sharp: [ends[0] && a == first, ends[1] && b == last],
                };
                if let Some(slab) = slabs.get_mut(index) {
                    slab.along.push(piece);
                }
            }
        }
    }
    slabs
}

/// Whether a contour bends at a corner so much that it is an edge of the part.
fn bends(contour: &Contour, at: usize) -> bool {
    let count = contour.len();
    let near = |by: usize| contour.get((at + by) % count).copied().unwrap_or_default();
    let [before, here, next] = [near(count - 1), near(0), near(1)];
    let [[a, b], [c, d]] = [[here[0] - before[0], here[1] - before[1]], [next[0] - here[0], next[1] - here[1]]];
    a * c + b * d < SHARP * hypot(a, b) * hypot(c, d)
}

/// The corners of a contour that are needed to draw it: those left out lie within `within` of the line between their
/// neighbours.
fn sketched(contour: &Contour, within: f64) -> Contour {
    let Some(&first) = contour.first() else { return Vec::new() };
    let mut points = vec![first];
    let mut from = first;
    let mut skipped: Vec<[f64; 2]> = Vec::new();
    for (&at, &next) in contour.iter().skip(1).zip(contour.iter().skip(2).chain([&first])) {
        skipped.push(at);
        let long = hypot(next[0] - from[0], next[1] - from[1]);
        let off = |point: &[f64; 2]| {
            if long == 0.0 {
                return hypot(point[0] - from[0], point[1] - from[1]);
            }
            ((next[0] - from[0]) * (point[1] - from[1]) - (next[1] - from[1]) * (point[0] - from[0])).abs() / long
        };
        if skipped.iter().any(|point| off(point) > within) {
            points.push(at);
            from = at;
            skipped.clear();
        }
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether a point in space is in the metal, or within `near` mm of it: a ray in the half section crosses the contours
    /// an odd number of times.
    fn within(part: &[Contour], cut: Option<f64>, at: &Vector3<f64>, near: f64) -> bool {
        let (r, turn) = (hypot(at.y, at.z), atan2(at.z, at.y));
        let inside = |z: f64, r: f64| {
            let crossed = |contour: &Contour| {
                let pairs = contour.iter().zip(contour.iter().cycle().skip(1));
                pairs
                    .filter(|(a, b)| (a[0] > z) != (b[0] > z) && a[1] + (b[1] - a[1]) * (z - a[0]) / (b[0] - a[0]) > r)
                    .count()
            };
            part.iter().map(crossed).sum::<usize>() % 2 == 1
        };
        let gone = cut.is_some_and(|near| cos(turn - near) > cos(FRAC_PI_4) + 1e-3);
        let places = [[0.0, 0.0], [near, 0.0], [-near, 0.0], [0.0, near], [0.0, -near]];
        !gone && places.iter().any(|[dz, dr]| inside(at.x + dz, (r + dr).abs()))
    }

    fn covers(points: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
        let pairs = points.iter().zip(points.iter().cycle().skip(1));
        pairs.filter(|(a, b)| (a[1] > y) != (b[1] > y) && a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]) > x).count()
            % 2
            == 1
    }

    #[test]
    fn what_is_drawn_last_at_a_place_is_what_a_ray_from_the_eye_meets_first() {
        let shaft = vec![
            [-60.0, 0.0],
            [0.0, 0.0],
            [0.0, 9.0],
            [-1.0, 10.0],
            [-20.0, 10.0],
            [-20.0, 7.0],
            [-24.0, 7.0],
            [-24.0, 15.0],
            [-35.0, 20.0],
            [-35.0, 25.0],
            [-60.0, 25.0],
        ];
        let bored = vec![
            [-50.0, 6.0],
            [-30.0, 6.0],
            [-30.0, 14.0],
            [-26.0, 14.0],
            [-26.0, 8.0],
            [-4.0, 10.0],
            [0.0, 14.0],
            [0.0, 20.0],
            [-3.0, 22.0],
            [-20.0, 22.0],
            [-20.0, 18.0],
            [-25.0, 18.0],
            [-30.0, 24.0],
            [-50.0, 24.0],
        ];
        let grooved = vec![
            [-40.0, 0.0],
            [-12.0, 0.0],
            [-12.0, 8.0],
            [0.0, 8.0],
            [0.0, 12.0],
            [-9.0, 12.0],
            [-9.0, 17.0],
            [-2.0, 17.0],
            [-2.0, 25.0],
            [-40.0, 25.0],
        ];
        for part in [vec![shaft], vec![bored], vec![grooved]] {
            let camera = Camera::new(-56.0, 24.0);
            let drawing = Drawing { camera, scene: Scene::new(camera), slabs: slabs(&part) };
            let strokes = drawing.strokes();
            let towards = camera.towards();
            let near = atan2(towards.z, towards.y);
            let hollow = strokes.iter().any(|stroke| stroke.ink == Ink::Obverse);
            let cut = hollow.then_some(near);
            let mut looked = 0;
            for piece in
                drawing.slabs.iter().flat_map(|slab| slab.along.iter().chain(&slab.across)).filter(|one| !one.bare())
            {
                for sector in 0..SECTORS {
                    let turn = near + TAU * (f64::from(sector) + 0.5) / f64::from(SECTORS);
                    if hollow && cos(turn - near) > cos(FRAC_PI_4) {
                        continue;
                    }
                    let half = TAU / f64::from(SECTORS) / 2.0;
                    let corners = [(piece.from, -half), (piece.to, -half), (piece.to, half), (piece.from, half)]
                        .map(|(at, by)| point(at, turn + by));
                    let Some(face) = drawing.scene.face(&corners) else { continue };
                    let at = corners.iter().sum::<Vector3<f64>>() / 4.0;
                    let hidden =
                        (5..1200).any(|step| within(&part, cut, &(at + towards * (f64::from(step) * 0.1)), 0.2));
                    if hidden {
                        continue;
                    }
                    let seen = camera.see(&at);
                    let last = strokes.iter().rev().find(|stroke| stroke.filled && covers(&stroke.points, seen));
                    assert_eq!(last.map(|stroke| stroke.ink), Some(face.ink), "{piece:?} at {turn}");
                    looked += 1;
                }
            }
            assert!(looked > 200, "{looked} places were looked at");
        }
    }

    #[test]
    fn a_part_is_cut_open_only_where_it_is_hollow() {
        let solid = vec![vec![[-10.0, 0.0], [0.0, 0.0], [0.0, 5.0], [-10.0, 5.0]]];
        let drilled = vec![vec![[-10.0, 0.0], [-4.0, 0.0], [-4.0, 2.0], [0.0, 2.0], [0.0, 5.0], [-10.0, 5.0]]];
        let cut = |part: &[Contour]| cover(part).strokes.iter().any(|stroke| stroke.ink == Ink::Obverse);
        assert!(!cut(&solid) && cut(&drilled));
        assert!(cover(&[]).strokes.is_empty(), "nothing is left of the part");
    }
}
