//! How near the axis of a tool comes to a face that goes straight on beyond its ends and is not cut off there.
//!
//! A face is made of rulings, the tool's axis is a stretch of a line: over each ruling the distance is that of two
//! stretches, in closed form; over v it is looked for from lines close to each other on, every valley between them to its
//! bottom.
//!
//! # Units
//! Millimetres and radians, in the part frame.

use nalgebra::Vector3;

use crate::kinds::impeller::part::{Face, HUB, Part, RIM};
use crate::number::root::golden;

/// Lines of a face that are looked at first.
const LINES: u8 = 40;

/// Lines about each of the nearest of them that are looked at next.
const FINER: u8 = 12;

/// Steps of a golden section about the nearest of those.
const STEPS: u32 = 12;

/// A stretch of a tool's axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// A point of it.
    pub foot: Vector3<f64>,
    /// Out of the metal, a unit vector.
    pub along: Vector3<f64>,
    /// From and to, above the foot, mm.
    pub range: [f64; 2],
}

/// A face as far as a tool beside it needs it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall {
    part: Part,
    /// From and to which v it goes.
    v: [f64; 2],
    /// The depth of its lower edge, mm.
    bottom: f64,
}

/// The least of a function about a place that is near to it, by parabolas through three points each; `None` where it is
/// not near. The first parabola has points `width` apart, the last ones a 256th of that.
fn valley(guess: f64, mut width: f64, value: impl Fn(f64) -> f64) -> Option<(f64, f64)> {
    let (mut at, mut closer) = (guess, 0);
    for _ in 0..6 {
        let [before, here, after] = [-width, 0.0, width].map(|aside| value(at + aside));
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

impl Wall {
    /// The faces of a part's blade beside a tool of the radius a: (e/2 + a)·cot α + a/sin α + 0.5 mm longer than the blade
    /// at both ends, which a tool that runs out beside it needs, and down to h_1.
    #[must_use]
    pub fn new(part: &Part, a: f64) -> Self {
        let torus = part.circle.torus;
        let (sin, cos) = (torus.r / torus.R, part.circle.k / torus.R);
        let beyond = ((part.e / 2.0 + a) * cos / sin + a / sin + 0.5) / torus.R;
        let bottom = part.a_p + part.e * part.e / 4.0 / (2.0 * (torus.R - torus.r - part.a_p));
        Self { part: *part, v: [HUB - beyond, RIM + beyond], bottom }
    }

    /// The same faces, but beginning at v.
    #[must_use]
    pub const fn from(self, v: f64) -> Self {
        Self { v: [v, self.v[1]], ..self }
    }

    /// The least distance of an axis from a face, and the v where it is; sought about a guess first.
    #[must_use]
    pub fn nearest(&self, face: Face, axis: &Axis, guess: Option<f64>) -> (f64, f64) {
        self.least(guess, |v| self.apart(face.side() * self.part.e / 2.0, v, axis))
    }

    /// The least distance of an axis from the blade's mean surface, and the v where it is.
    #[must_use]
    pub fn from_middle(&self, axis: &Axis) -> (f64, f64) {
        self.least(None, |v| self.apart(0.0, v, axis))
    }

    fn least(&self, guess: Option<f64>, at: impl Fn(f64) -> f64) -> (f64, f64) {
        let [begin, end] = self.v;
        let step = (end - begin) / f64::from(LINES);
        if let Some(found) = guess.and_then(|guess| valley(guess, step / 8.0, &at))
            && (begin..=end).contains(&found.1)
        {
            return found;
        }
        // In a valley the least is no farther below a line than the line is from it.
        let reach = step * self.part.circle.torus.R * 1.5;
        let nearer = |one: (f64, f64), other: (f64, f64)| if other.0 < one.0 { other } else { one };
        let valleys = |ends: [f64; 2], lines: u8| {
            let apart = (ends[1] - ends[0]) / f64::from(lines);
            let found: Vec<(f64, f64)> =
                (0..=lines).map(|line| ends[0] + apart * f64::from(line)).map(|v| (at(v), v)).collect();
            let least = found.iter().fold(f64::INFINITY, |least, line| least.min(line.0));
            let below = |line: Option<&(f64, f64)>, here: f64| line.is_some_and(|line| line.0 < here);
            let bottoms = (0..found.len()).filter(|&line| {
                let (here, before) = (found[line].0, line.checked_sub(1));
                here <= least + reach
                    && !below(found.get(line + 1), here)
                    && !below(before.and_then(|before| found.get(before)), here)
            });
            bottoms.map(|line| found[line]).collect::<Vec<_>>()
        };
        let within = |v: f64, aside: f64| [(v - aside).max(begin), (v + aside).min(end)];
        let mut least = (f64::INFINITY, begin);
        for (_, about) in valleys([begin, end], LINES) {
            // Two valleys, one of the upper edge and one of the tool's end, may be nearer to each other than two lines.
            let around = within(about, step * 1.5);
            let finer = (around[1] - around[0]) / f64::from(FINER);
            for (apart, about) in valleys(around, FINER) {
                least = nearer(nearer(least, (apart, about)), golden(within(about, finer), STEPS, &at));
            }
        }
        least
    }

    /// The distance of an axis from the line that stands `aside` of the mean line's ruling at v.
    fn apart(&self, aside: f64, v: f64, axis: &Axis) -> f64 {
        let (P, frame) = self.part.frame(v);
        stretches(P + frame.b * aside, -frame.N, [self.part.top(v), self.bottom], axis)
    }

    /// The distance of an axis from the ruling of the mean line at v.
    #[must_use]
    pub fn from_ruling(&self, v: f64, axis: &Axis) -> f64 {
        self.apart(0.0, v, axis)
    }
}

/// The distance of an axis from the stretch of the line from `foot` along the unit vector `down`, between two h.
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
}
