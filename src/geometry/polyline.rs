//! Plane polylines: where one crosses another.

use nalgebra::Vector2;

/// A crossing of two polylines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Position along the first: segment number plus the fraction of the segment, in [0, points − 1].
    pub along_first: f64,
    /// Position along the second, likewise.
    pub along_second: f64,
    /// Where they cross, in the frame and the unit of their points.
    pub at: Vector2<f64>,
}

#[derive(Clone, Copy)]
struct Extent {
    low: Vector2<f64>,
    high: Vector2<f64>,
}

impl Extent {
    fn of(points: &[Vector2<f64>]) -> Self {
        let (mut low, mut high) = (points[0], points[0]);
        for point in &points[1..] {
            low = low.inf(point);
            high = high.sup(point);
        }
        Self { low, high }
    }

    fn meets(&self, other: &Self) -> bool {
        (0..2).all(|axis| self.low[axis] <= other.high[axis] && other.low[axis] <= self.high[axis])
    }
}

/// Polylines are halved down to this many segments before every pair is tried.
const LEAF: usize = 8;

/// The crossing of two polylines that comes first along the first one; `None` where they do not cross.
///
/// Both are halved again and again while their extents meet, first halves first, so that curves that cross in few
/// places cost about n·log n for n points. Segments that lie along each other do not count as crossing.
#[must_use]
pub fn first_crossing(first: &[Vector2<f64>], second: &[Vector2<f64>]) -> Option<Crossing> {
    if first.len() < 2 || second.len() < 2 {
        return None;
    }
    let mut best = None;
    search((first, 0), (second, 0), &mut best);
    best
}

/// `first` and `second` are pieces of the polylines with the index of their first point.
fn search(first: (&[Vector2<f64>], usize), second: (&[Vector2<f64>], usize), best: &mut Option<Crossing>) {
    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
    if best.is_some_and(|found| found.along_first <= first.1 as f64) {
        return;
    }
    if !Extent::of(first.0).meets(&Extent::of(second.0)) {
        return;
    }
    // The longer one is halved, so that extents are taken of short pieces as soon as possible.
    if first.0.len().max(second.0.len()) > LEAF + 1 {
        if first.0.len() >= second.0.len() {
            let (middle, start) = ((first.0.len() - 1) / 2, first.1);
            search((&first.0[..=middle], start), second, best);
            search((&first.0[middle..], start + middle), second, best);
        } else {
            let (middle, start) = ((second.0.len() - 1) / 2, second.1);
            search(first, (&second.0[..=middle], start), best);
            search(first, (&second.0[middle..], start + middle), best);
        }
    } else {
        for (i, one) in first.0.windows(2).enumerate() {
            for (j, other) in second.0.windows(2).enumerate() {
                if let Some((s, t)) = segments([one[0], one[1]], [other[0], other[1]]) {
                    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
                    let crossing = Crossing {
                        along_first: (first.1 + i) as f64 + s,
                        along_second: (second.1 + j) as f64 + t,
                        at: one[0] + (one[1] - one[0]) * s,
                    };
                    if best.is_none_or(|found| crossing.along_first < found.along_first) {
                        *best = Some(crossing);
                    }
                }
            }
        }
    }
}

/// The fractions at which two segments cross.
fn segments(a: [Vector2<f64>; 2], b: [Vector2<f64>; 2]) -> Option<(f64, f64)> {
    let (p, q) = (a[1] - a[0], b[1] - b[0]);
    let between = b[0] - a[0];
    let turn = p.perp(&q);
    if turn == 0.0 {
        return None;
    }
    let (s, t) = (between.perp(&q) / turn, between.perp(&p) / turn);
    ((0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t)).then_some((s, t))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::trig::sin_cos;

    fn wave(count: u32, phase: f64) -> Vec<Vector2<f64>> {
        (0..count).map(|i| Vector2::new(f64::from(i) / 100.0, sin_cos(f64::from(i) / 100.0 + phase).0)).collect()
    }

    #[test]
    fn the_first_of_many_crossings_is_found() {
        let one = wave(5000, 0.0);
        let axis = [Vector2::new(0.5, 0.0), Vector2::new(100.0, 0.0)];
        let crossing = first_crossing(&one, &axis).unwrap();
        assert!((crossing.at.x - std::f64::consts::PI).abs() < 1e-5);
        assert!((crossing.along_first - 314.159).abs() < 0.01);
    }

    #[test]
    fn lines_apart_do_not_cross() {
        let shifted: Vec<_> = wave(500, 0.0).iter().map(|point| point + Vector2::new(0.0, 3.0)).collect();
        assert_eq!(first_crossing(&wave(500, 0.0), &shifted), None);
        assert_eq!(first_crossing(&[], &[]), None);
    }
}
