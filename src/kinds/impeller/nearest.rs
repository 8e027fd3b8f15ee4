//! How near the axis of a tool comes to a face that goes straight on beyond its ends and is not cut off there.
//!
//! A face is made of rulings, the tool's axis is a stretch of a line: over each ruling the distance is that of two
//! stretches, in closed form; over v it is looked for from lines close to each other on, every valley between them to its
//! bottom. Those lines are the same for every axis and are kept; of the face between them they give a bound, which often
//! answers already.
//!
//! # Units
//! Millimetres and radians, in the part frame.

use std::sync::OnceLock;

use nalgebra::Vector3;

use crate::geometry::darboux::opposite;
use crate::kinds::impeller::part::{Face, HUB, Part, RIM};
use crate::number::lesser;
use crate::number::root::golden;

/// Lines of a face that are looked at first: steps between them, and they themselves.
const LINES: u8 = 40;
const ROW: usize = 41;

/// Every so many of them are looked at for each axis; those between them only where they may be near.
const APART: u8 = 4;

/// The same about each of the nearest of them.
const FINER: std::ops::RangeInclusive<u8> = 12..=120;
const FINER_ROW: usize = 121;
/// No farther from each other than this part of what a tool's radius takes of the tube's circle: the thinner the tool, the narrower
/// are the valleys of its distance from a face.
const NARROW: f64 = 0.25;

/// Places beside each of the nearest of those, on either side, and how many of them there are to a step: of two valleys that are
/// nearer to each other than two steps, the row shows one.
const BESIDE: i8 = 8;
const BESIDE_ROW: usize = 17;
const A_STEP: f64 = 4.0;

/// Steps of a golden section about the nearest of those, where parabolas do not lead to a bottom.
const STEPS: u32 = 24;
/// How far from an end of a face it is asked whether the distance falls, in parts of those lines' spacing.
const NEXT: f64 = 1e-3;

/// Lines of each piece of a face whose lower ends are known.
const KNOTS: u8 = 12;

/// What the arithmetic may lose, mm.
const ARITHMETIC: f64 = 1e-9;

/// A stretch of a tool's axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// A point of the axis, mm, in the part frame: heights count from it.
    pub foot: Vector3<f64>,
    /// Out of the metal, a unit vector.
    pub along: Vector3<f64>,
    /// From and to, above the foot, mm.
    pub range: [f64; 2],
}

/// A line of the mean surface, with its place in the blade's frame.
#[derive(Clone, Copy, Debug, PartialEq)]
struct MeanRuling {
    v: f64,
    /// Where it meets the tangent plane of the mean line.
    P: Vector3<f64>,
    b: Vector3<f64>,
    /// Into the metal.
    down: Vector3<f64>,
    /// h_0 there.
    top: f64,
    /// Where the lines of obverse and reverse there end: at the floor.
    bottoms: [f64; 2],
    /// That of the mean surface comes to the floor at a_p; its lower end is no higher than those of the faces.
    middle: f64,
}

/// A face as far as a tool beside it needs it.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall {
    part: Part,
    /// From and to which v it goes, radians; run on beyond the ends of the blade at R a radian.
    v: [f64; 2],
    /// Where lines of obverse and reverse end: v and depth, straight between, and as deep as the last beyond.
    knots: [Vec<[f64; 2]>; 2],
    /// How far the upper ends of its lines stand above the turned surface, mm: where it goes straight on, they do.
    overhang: f64,
    /// The lines that are looked at first.
    lines: Vec<MeanRuling>,
    /// Steps between the lines about each of the nearest of them.
    finer: u8,
    /// Those lines: the same for every axis, they are computed when the first one needs them.
    rows: Vec<OnceLock<Vec<MeanRuling>>>,
    /// Between two of them no distance is less than at the nearer by more than this, mm.
    between: f64,
    /// The same between two that are looked at for each axis.
    between_apart: f64,
}

/// What the lines that are looked at first say of an axis.
#[derive(Clone, Debug)]
pub struct Scan<'a> {
    wall: &'a Wall,
    aside: f64,
    axis: Axis,
    /// Infinite where the line is farther than the nearest by more than [`Wall::valley_reach`], or than asked.
    apart: [f64; ROW],
    /// The least distance is not more than this.
    pub most: f64,
    /// It is not less than this, which is no more than asked.
    pub least: f64,
}

/// The least of a function about a place that is near to it, by parabolas through three points each; `None` where it is
/// not near. The first parabola has points `width` apart, the last ones a 256th of that.
fn valley(guess: f64, mut width: f64, value: impl Fn(f64) -> f64) -> Option<(f64, f64)> {
    let (mut at, mut closer) = (guess, 0);
    for _ in 0..6 {
        let [before, here, after] = [value(at - width), value(at), value(at + width)];
        let bend = before - 2.0 * here + after;
        let shift = width * (before - after) / (2.0 * bend);
        // NaN counts as far.
        let near = bend > 0.0 && shift.abs() <= 4.0 * width;
        if !near {
            return None;
        }
        at += shift;
        if shift.abs() <= width {
            closer += 1;
            if closer == 3 {
                return Some((value(at), at));
            }
            width /= 16.0;
        }
    }
    None
}

/// The places of a row that are no farther than their neighbours, and within `reach` of the least: where in the row.
fn bottoms(row: &[(f64, f64)], reach: f64) -> impl Iterator<Item = usize> {
    let least = row.iter().fold(f64::INFINITY, |least, line| least.min(line.0));
    (0..row.len()).filter(move |&line| {
        let below =
            |other: Option<usize>| other.and_then(|other| row.get(other)).is_some_and(|one| one.0 < row[line].0);
        row[line].0 <= least + reach && !below(Some(line + 1)) && !below(line.checked_sub(1))
    })
}

/// Where the lines of a face end: where the blank cuts it off, they go on as deep as the last one.
fn knots(part: &Part, face: Face) -> Vec<[f64; 2]> {
    let stretches = part.stretches(face);
    let ends = [stretches.first().map_or(HUB, |v| v[0]), stretches.last().map_or(RIM, |v| v[1])];
    let mut knots = Vec::new();
    for [from, to] in [[ends[0], HUB], [HUB, RIM], [RIM, ends[1]]] {
        // The floor falls away from the tangent plane with the square of what the straight ends go on.
        let steps = if from == to { 0 } else { KNOTS };
        for step in 0..steps {
            let v = from + (to - from) * f64::from(step) / f64::from(KNOTS);
            knots.push([v, part.floor(&part.ruling(face, v), part.top(v))]);
        }
    }
    knots.push([ends[1], part.floor(&part.ruling(face, ends[1]), part.top(ends[1]))]);
    // Of lines that all end alike, two say as much.
    if knots.iter().all(|knot| knot[1] == knots[0][1]) {
        knots.truncate(2);
    }
    knots
}

impl Wall {
    /// The faces of a part's blade beside a tool of the radius a: (e/2 + a)·cot α + a/sin α + 0.5 mm longer than the blade
    /// at both ends, which a tool that runs out beside it needs, and down to the floor.
    #[must_use]
    pub fn new(part: &Part, a: f64) -> Self {
        let torus = part.circle.torus;
        let (sin, cos) = (torus.r / torus.R, part.circle.k / torus.R);
        let beyond = ((part.e / 2.0 + a) * cos / sin + a / sin + 0.5) / torus.R;
        let mut wall = Self::over(part, [HUB - beyond, RIM + beyond]);
        let finer = (3.0 * wall.step() * torus.R / (NARROW * a)).ceil();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "held within what a byte takes")]
        let finer = finer.clamp(f64::from(*FINER.start()), f64::from(*FINER.end())) as u8;
        wall.finer = finer;
        wall
    }

    /// The same faces, but beginning at v.
    #[must_use]
    pub fn from(&self, v: f64) -> Self {
        Self { finer: self.finer, ..Self::over(&self.part, [v, self.v[1]]) }
    }

    fn over(part: &Part, v: [f64; 2]) -> Self {
        let torus = part.circle.torus;
        let mut wall = Self {
            part: *part,
            v,
            knots: Face::ALL.map(|face| knots(part, face)),
            overhang: part.overhang(),
            lines: Vec::new(),
            finer: *FINER.start(),
            rows: vec![OnceLock::new(); ROW],
            between: 0.0,
            between_apart: 0.0,
        };
        wall.lines = (0..=LINES).map(|line| wall.line(v[0] + wall.step() * f64::from(line))).collect();
        // A point of a ruling moves no faster with v than the face's points do and its upper end along it, which goes one way.
        let tops = [HUB, RIM].map(|v| part.top(v));
        let bottoms = wall.knots.iter().flatten().map(|knot| knot[1]);
        let deep = tops.into_iter().chain(bottoms).map(f64::abs).fold(0.0, f64::max);
        let speed = part.change([HUB, RIM], deep).speed.max(torus.R);
        // The lower ends go down to the middle of a face, or of the straight ends, and up again.
        let rises = wall.knots.iter().map(|knots| {
            let all = || knots.iter().map(|knot| knot[1]);
            all().fold(f64::MIN, f64::max) - all().fold(f64::MAX, f64::min)
        });
        let slides = rises.fold((tops[0] - tops[1]).abs(), f64::max);
        let between = |steps: f64| speed * wall.step() * steps / 2.0 + slides + ARITHMETIC;
        (wall.between, wall.between_apart) = (between(1.0), between(f64::from(APART)));
        wall
    }

    /// In a valley the least is no farther below a line than the line is from it.
    fn valley_reach(&self) -> f64 {
        self.step() * self.part.circle.torus.R * 1.5
    }

    /// From one of the lines that are looked at first to the next.
    fn step(&self) -> f64 {
        (self.v[1] - self.v[0]) / f64::from(LINES)
    }

    /// The lines closer to each other about one of those that are looked at first.
    fn row(&self, about: usize) -> &[MeanRuling] {
        self.rows[about].get_or_init(|| {
            // Two valleys, one of the upper edge and one of the tool's end, may be nearer to each other than two lines.
            let [from, to] = self.within(self.lines[about].v, self.step() * 1.5);
            let finer = (to - from) / f64::from(self.finer);
            (0..=self.finer).map(|line| self.line(from + finer * f64::from(line))).collect()
        })
    }

    /// What is no farther from a v of the face.
    fn within(&self, v: f64, aside: f64) -> [f64; 2] {
        [(v - aside).max(self.v[0]), (v + aside).min(self.v[1])]
    }

    fn line(&self, v: f64) -> MeanRuling {
        let (P, frame, top) = self.part.frame_and_top(v);
        let bottoms = self.bottoms(v);
        let middle = self.part.a_p.max(bottoms[0]).max(bottoms[1]);
        MeanRuling { v, P, b: frame.b, down: opposite(frame.N), top, bottoms, middle }
    }

    /// Where the lines of obverse and reverse at v end.
    fn bottoms(&self, v: f64) -> [f64; 2] {
        [self.bottom(v, 0), self.bottom(v, 1)]
    }

    /// Where the line of obverse (0) or reverse (1) at v ends.
    fn bottom(&self, v: f64, side: usize) -> f64 {
        let knots = &self.knots[side];
        let after = knots.partition_point(|knot| knot[0] < v).clamp(1, knots.len().max(2) - 1);
        match (knots.get(after - 1), knots.get(after)) {
            (Some([v_0, h_0]), Some([v_1, h_1])) => h_0 + (h_1 - h_0) * ((v - v_0) / (v_1 - v_0)).clamp(0.0, 1.0),
            _ => 0.0,
        }
    }

    /// The distance of an axis from the line at v that stands `aside` of that of the mean surface.
    fn apart(&self, v: f64, aside: f64, axis: &Axis) -> f64 {
        if aside == 0.0 {
            return self.line(v).apart(aside, axis);
        }
        let (P, frame, top) = self.part.frame_and_top(v);
        stretches(
            P + frame.b * aside,
            opposite(frame.N),
            [top, self.bottom(v, usize::from(aside < 0.0)).max(top)],
            axis,
        )
    }

    /// The least distance of an axis from a face, and the v where it is; sought about a guess first.
    #[must_use]
    pub fn nearest(&self, face: Face, axis: &Axis, guess: Option<f64>) -> (f64, f64) {
        let aside = self.aside(face);
        let high = self.high(axis);
        if let Some(found) = guess.and_then(|guess| valley(guess, self.step() / 8.0, |v| self.apart(v, aside, &high)))
            && (self.v[0]..=self.v[1]).contains(&found.1)
        {
            return found;
        }
        self.scan(aside, axis, f64::INFINITY).nearest()
    }

    /// On which side of the mean surface a face lies, and how far.
    fn aside(&self, face: Face) -> f64 {
        face.side() * self.part.e / 2.0
    }

    /// What is known of the distance of an axis from a face before it is sought; whether it is less than `asked`, at least.
    #[must_use]
    pub fn seen(&self, face: Face, axis: &Axis, asked: f64) -> Scan<'_> {
        self.scan(self.aside(face), axis, asked)
    }

    /// The same of the blade's mean surface.
    #[must_use]
    pub fn seen_from_middle(&self, axis: &Axis) -> Scan<'_> {
        self.scan(0.0, axis, f64::INFINITY)
    }

    /// An axis as high as the lines beside it that it is to be seen from.
    fn high(&self, axis: &Axis) -> Axis {
        Axis { range: [axis.range[0], axis.range[1] + self.overhang], ..*axis }
    }

    /// Lines between which nothing is nearer than `asked` are not looked at.
    fn scan(&self, aside: f64, axis: &Axis, asked: f64) -> Scan<'_> {
        let axis = self.high(axis);
        let mut apart = [f64::INFINITY; ROW];
        let mut most = f64::INFINITY;
        let step = usize::from(APART);
        for (line, apart) in apart.iter_mut().enumerate().step_by(step) {
            *apart = self.lines[line].apart(aside, &axis);
            most = lesser(most, *apart);
        }
        let reach = self.valley_reach();
        for first in (0..ROW - 1).step_by(step) {
            if apart[first].min(apart[first + step]) - self.between_apart > lesser(most + reach, asked) {
                continue;
            }
            let between = first + 1..first + step;
            for (apart, line) in apart[between.clone()].iter_mut().zip(&self.lines[between]) {
                *apart = line.apart(aside, &axis);
                most = lesser(most, *apart);
            }
        }
        Scan { wall: self, aside, axis, apart, most, least: lesser(most - self.between, asked) }
    }

    /// The half round of the radius e/2 with which a splitter begins at v.
    #[must_use]
    pub fn half_round(&self, v: f64) -> HalfRound {
        let (line, [top, bottom]) = (self.line(v), self.part.noses_ends(v));
        HalfRound { line: MeanRuling { top, middle: line.middle.max(bottom), ..line }, radius: self.part.e / 2.0 }
    }
}

/// The half round with which a splitter begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfRound {
    /// The ruling of the mean line that it stands about.
    line: MeanRuling,
    radius: f64,
}

impl HalfRound {
    /// The direction of its ruling, down.
    #[must_use]
    pub const fn down(&self) -> Vector3<f64> {
        self.line.down
    }

    /// The distance of an axis from it. Points of it stand up to the radius times the sine of the lean higher over the tool's end, or
    /// lower, than those of the ruling.
    #[must_use]
    pub fn apart(&self, axis: &Axis) -> f64 {
        let upright = self.line.down.dot(&axis.along);
        let shift = self.radius * (1.0 - upright * upright).max(0.0).sqrt();
        self.line.apart(0.0, &Axis { range: [axis.range[0] - shift, axis.range[1] + shift], ..*axis }) - self.radius
    }
}

impl MeanRuling {
    /// The distance of an axis from the line that stands `aside` of this one.
    #[inline]
    fn apart(&self, aside: f64, axis: &Axis) -> f64 {
        let [obverse, reverse] = self.bottoms;
        let bottom = if aside > 0.0 {
            obverse
        } else if aside < 0.0 {
            reverse
        } else {
            self.middle
        };
        // A ruling that begins below the floor is a point.
        stretches(self.P + self.b * aside, self.down, [self.top, bottom.max(self.top)], axis)
    }
}

impl Scan<'_> {
    /// The least distance, and the v where it is.
    #[must_use]
    pub fn nearest(&self) -> (f64, f64) {
        self.sought(f64::NEG_INFINITY)
    }

    /// The least distance, and the v where it is; or the first that is less than asked.
    fn sought(&self, asked: f64) -> (f64, f64) {
        let (wall, [begin, end]) = (self.wall, self.wall.v);
        let at = |v: f64| wall.apart(v, self.aside, &self.axis);
        let step = wall.step();
        let reach = wall.valley_reach();
        let nearer = |one: (f64, f64), other: (f64, f64)| if other.0 < one.0 { other } else { one };
        let mut first = [(f64::INFINITY, begin); ROW];
        for ((place, apart), line) in first.iter_mut().zip(self.apart).zip(&wall.lines) {
            *place = (apart, line.v);
        }
        let mut least = (f64::INFINITY, begin);
        for about in bottoms(&first, reach) {
            let around = wall.within(first[about].1, step * 1.5);
            let finer = (around[1] - around[0]) / f64::from(wall.finer);
            let mut row = [(f64::INFINITY, begin); FINER_ROW];
            let row = &mut row[..=usize::from(wall.finer)];
            for (line, place) in wall.row(about).iter().zip(&mut *row) {
                *place = (line.apart(self.aside, &self.axis), line.v);
            }
            for at_row in bottoms(row, reach) {
                let (apart, about) = row[at_row];
                least = nearer(least, (apart, about));
                if least.0 < asked {
                    return least;
                }
                let ends = wall.within(about, finer);
                // At an end of the face the distance may still be falling: then the end is the nearest.
                let inwards = if about == begin { ends[1] } else { ends[0] };
                let at_end = about == begin || about == end;
                if at_end && at(about + (inwards - about) * NEXT) >= apart {
                    continue;
                }
                let bottom = valley(about, finer / 4.0, at).filter(|(_, v)| (ends[0]..=ends[1]).contains(v));
                let found = bottom.unwrap_or_else(|| golden(ends, STEPS, at));
                least = nearer(least, found);
                if least.0 < asked {
                    return least;
                }
                // Another valley beside that one.
                let mut beside = [(f64::INFINITY, about); BESIDE_ROW];
                for (place, line) in beside.iter_mut().zip(-BESIDE..=BESIDE) {
                    let v = (about + finer * f64::from(line) / A_STEP).clamp(begin, end);
                    *place = (at(v), v);
                }
                for place in bottoms(&beside, reach) {
                    let about = beside[place].1;
                    if (about - found.1).abs() > finer / A_STEP {
                        let ends = wall.within(about, finer / A_STEP);
                        let bottom = valley(about, finer / A_STEP / 4.0, at);
                        let bottom = bottom.filter(|(_, v)| (ends[0]..=ends[1]).contains(v));
                        least = nearer(least, bottom.unwrap_or_else(|| golden(ends, STEPS, at)));
                    }
                }
            }
        }
        least
    }

    /// The least distance, or any that there is and is less than asked.
    #[must_use]
    pub fn least_or_less(&self, asked: f64) -> f64 {
        self.sought(asked).0
    }

    /// True where the least distance is no less than asked.
    #[must_use]
    pub fn keeps(&self, asked: f64) -> bool {
        self.most >= asked && (self.least >= asked || self.sought(asked).0 >= asked)
    }
}

/// The distance of an axis from the stretch of the line from `foot` along the unit vector `down`, between two h.
#[inline(always)]
fn stretches(foot: Vector3<f64>, down: Vector3<f64>, [low, high]: [f64; 2], axis: &Axis) -> f64 {
    let from = foot - axis.foot;
    let [near, far] = axis.range;
    let (b, down_from, along_from) = (down.dot(&axis.along), down.dot(&from), axis.along.dot(&from));
    let slant = 1.0 - b * b;
    let h = if slant > 1e-14 { ((b * along_from - down_from) / slant).clamp(low, high) } else { low };
    let l = (along_from + b * h).clamp(near, far);
    let h = (b * l - down_from).clamp(low, high);
    (from + down * h - axis.along * l).norm()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bottom_of_a_valley_is_found_from_near_it_only() {
        let function = |x: f64| {
            let off = x - 1.25;
            off * off * (1.0 + 0.1 * off) + 2.0
        };
        let (value, at) = valley(1.1, 0.05, function).unwrap();
        assert!((value - 2.0).abs() < 1e-9 && (at - 1.25).abs() < 1e-4, "{value} {at}");
        assert_eq!(valley(0.0, 0.05, |x| (x - 1.25) * (x - 1.25)), None);
        assert_eq!(valley(0.0, 0.05, |x| -x * x), None);
        assert_eq!(valley(0.0, 0.05, |_| f64::NAN), None);
    }

    #[test]
    fn the_lines_looked_at_first_bound_what_a_dense_search_finds() {
        use crate::geometry::torus::Torus;
        for (R, r, e, a_p) in [(25.0, 15.0, 2.0, 2.0), (25.0, 17.0, 1.0, 4.0), (400.0, 300.0, 9.0, 30.0)] {
            let part = Part::with(Torus { R, r }, e, a_p);
            let wall = Wall::new(&part, 3.0);
            for step in 0..24_u8 {
                let v = HUB - 0.1 + f64::from(step) * 0.08;
                let (P, frame) = part.frame(v);
                let tilt = f64::from(step % 5) * 0.15 - 0.3;
                let along = (frame.N + frame.t * tilt + frame.b * (tilt / 2.0)).try_normalize(1e-9).unwrap();
                let axis =
                    Axis { foot: P + frame.b * (e / 2.0 + 2.0 + f64::from(step % 3)), along, range: [-a_p * 0.9, 1.0] };
                let seen = wall.seen(Face::Obverse, &axis, f64::INFINITY);
                let found = seen.nearest().0;
                let dense = (0..=20_000).map(|line| {
                    let v = wall.v[0] + (wall.v[1] - wall.v[0]) * f64::from(line) / 20_000.0;
                    wall.line(v).apart(e / 2.0, &axis)
                });
                let dense = dense.fold(f64::INFINITY, f64::min);
                assert!(seen.least <= dense && found <= seen.most, "{R} {step}");
                assert!(found <= dense + 1e-9 && found > dense - 1e-5 * R, "{R} {step} {found} {dense}");
                for off in [-2.0, -1e-3, 1e-3, 2.0] {
                    assert_eq!(seen.keeps(found + off), off < 0.0, "{R} {step} {off}");
                    let asked = wall.seen(Face::Obverse, &axis, found + off);
                    assert!(asked.least <= dense && asked.least <= found + off, "{R} {step} {off}");
                    assert_eq!(asked.keeps(found + off), off < 0.0, "{R} {step} {off}");
                }
            }
        }
    }
}
