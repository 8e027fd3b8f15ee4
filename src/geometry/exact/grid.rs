//! Points on the grid, lines through two of them, and the signs of where lines meet.

use std::cmp::Ordering;

/// Grid units in a millimetre: the grid is one nanometre.
pub const UNITS: f64 = 1e6;

/// Coordinates stay below 2³⁰ units, that is 1073.741824 mm: then every sign fits in the integers used here.
pub const LIMIT: i64 = 1 << 30;

/// A point of the grid, also the step between two: along z and r, in nanometres.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Point {
    /// Along the axis, nm.
    pub z: i64,
    /// Away from the axis, nm.
    pub r: i64,
}

impl Point {
    /// The nearest point of the grid to `[z, r]` in mm; `None` beyond the grid's limit or for what is no number.
    #[must_use]
    pub fn near([z, r]: [f64; 2]) -> Option<Self> {
        let unit = |mm: f64| {
            let units = (mm * UNITS).round();
            #[expect(clippy::cast_possible_truncation, clippy::cast_precision_loss, reason = "2^30 is exact, and held")]
            (units.abs() < LIMIT as f64).then_some(units as i64)
        };
        Some(Self { z: unit(z)?, r: unit(r)? })
    }

    /// `[z, r]` in mm.
    #[must_use]
    pub fn mm(self) -> [f64; 2] {
        [millimetres(self.z), millimetres(self.r)]
    }

    /// True within the grid's limit.
    #[must_use]
    pub const fn on_grid(self) -> bool {
        self.z.abs() < LIMIT && self.r.abs() < LIMIT
    }

    /// The step from here to another point.
    #[must_use]
    pub const fn to(self, other: Self) -> Self {
        Self { z: other.z - self.z, r: other.r - self.r }
    }

    /// The point a step further.
    #[must_use]
    pub const fn plus(self, step: Self) -> Self {
        Self { z: self.z + step.z, r: self.r + step.r }
    }

    /// The longer of a step's two coordinates.
    #[must_use]
    pub fn size(self) -> i64 {
        self.z.abs().max(self.r.abs())
    }

    /// The cross product of two steps: positive where the other one is to the left.
    #[must_use]
    pub const fn cross(self, other: Self) -> i64 {
        self.z * other.r - self.r * other.z
    }

    /// The scalar product of two steps.
    #[must_use]
    pub const fn dot(self, other: Self) -> i64 {
        self.z * other.z + self.r * other.r
    }
}

#[expect(clippy::cast_precision_loss, reason = "below 2^53")]
fn millimetres(units: i64) -> f64 {
    units as f64 / UNITS
}

/// A line through two points of the grid, with a direction: a z + b r + c is positive to its left.
///
/// |a|, |b| < 2³¹ and |c| < 2⁶².
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    a: i64,
    b: i64,
    c: i64,
}

impl Line {
    /// The line from one point to another, which must differ.
    #[must_use]
    pub const fn through(from: Point, to: Point) -> Self {
        let d = from.to(to);
        Self { a: -d.r, b: d.z, c: d.r * from.z - d.z * from.r }
    }

    /// The same line the other way.
    #[must_use]
    pub const fn reversed(self) -> Self {
        Self { a: -self.a, b: -self.b, c: -self.c }
    }

    /// The step from the first of the points that the line goes through to the second.
    #[must_use]
    pub const fn direction(self) -> Point {
        Point { z: self.b, r: -self.a }
    }

    /// Positive for a point to the left, negative to the right, 0 on the line. It fits: 2⁶¹ + 2⁶¹ + 2⁶² = 2⁶³, each of
    /// them below that.
    #[must_use]
    pub const fn at(self, point: Point) -> i64 {
        self.a * point.z + self.b * point.r + self.c
    }

    /// True where a box, of which the least and the greatest corner are given, is to the right of the line as a whole, or on
    /// it.
    #[must_use]
    pub const fn has_right(self, low: Point, high: Point) -> bool {
        let z = if self.a > 0 { high.z } else { low.z };
        let r = if self.b > 0 { high.r } else { low.r };
        self.at(Point { z, r }) <= 0
    }

    /// True where two lines are one, with one direction.
    #[must_use]
    pub fn same(self, other: Self) -> bool {
        let (one, two) = (self.direction(), other.direction());
        if one.cross(two) != 0 || one.dot(two) <= 0 {
            return false;
        }
        // Parallel: c is the distance from the origin by the length of (a, b), and these are in one ratio.
        let share = if self.a.abs() > self.b.abs() { [self.a, other.a] } else { [self.b, other.b] };
        i128::from(self.c) * i128::from(share[1]) == i128::from(other.c) * i128::from(share[0])
    }

    /// On which side the point is where two other lines meet, which must not be parallel: `Greater` to the left.
    ///
    /// Where a₁z + b₁r + c₁ = 0 and a₂z + b₂r + c₂ = 0, (z, r) = (x, y)/w with the cross product (x, y, w) of the two
    /// coefficient vectors, so that the sign is that of (a x + b y + c w)·w. |a x|, |b y|, |c w| < 2¹²⁵: it fits in 128
    /// bits. Most signs are plain in floating point already: each product there is within 8 roundings of 2⁻⁵³, and a
    /// sum beyond 2·10⁻¹⁵ of its terms' sizes has the right sign.
    #[must_use]
    pub fn side(self, one: Self, two: Self) -> Ordering {
        let w = one.a * two.b - two.a * one.b;
        debug_assert!(w != 0, "parallel lines do not meet");
        let sign = self.rough(one, two).unwrap_or_else(|| {
            let [a, b, c] = self.wide();
            let [x, y, w] = meet(one, two);
            (a * x + b * y + c * w).cmp(&0)
        });
        if w < 0 { sign.reverse() } else { sign }
    }

    /// The sign of a x + b y + c w where floating point is sure of it.
    fn rough(self, one: Self, two: Self) -> Option<Ordering> {
        #[expect(clippy::cast_precision_loss, reason = "the bound allows for it")]
        let [a, b, c] = [self, one, two].map(|line| [line.a as f64, line.b as f64, line.c as f64]);
        let products = [
            (a[0] * b[1] * c[2], a[0] * c[1] * b[2]),
            (a[1] * b[2] * c[0], a[1] * c[2] * b[0]),
            (a[2] * b[0] * c[1], a[2] * c[0] * b[1]),
        ];
        let sum: f64 = products.iter().map(|(plus, minus)| plus - minus).sum();
        let size: f64 = products.iter().map(|(plus, minus)| plus.abs() + minus.abs()).sum();
        (sum.abs() > 2e-15 * size).then_some(if sum > 0.0 { Ordering::Greater } else { Ordering::Less })
    }

    const fn wide(self) -> [i128; 3] {
        [self.a as i128, self.b as i128, self.c as i128]
    }

    /// Where two lines meet that are not parallel, `[z, r]` in mm: the exact quotient, rounded to floating point.
    #[must_use]
    pub fn meets(self, other: Self) -> [f64; 2] {
        let [x, y, w] = meet(self, other);
        #[expect(clippy::cast_precision_loss, reason = "a rounding to floating point is what is wanted")]
        let [x, y, w] = [x as f64, y as f64, w as f64];
        // No negative zero.
        [x / w / UNITS + 0.0, y / w / UNITS + 0.0]
    }
}

fn meet(one: Line, two: Line) -> [i128; 3] {
    let ([a1, b1, c1], [a2, b2, c2]) = (one.wide(), two.wide());
    [b1 * c2 - b2 * c1, c1 * a2 - c2 * a1, a1 * b2 - a2 * b1]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(z: i64, r: i64) -> Point {
        Point { z, r }
    }

    #[test]
    fn a_line_knows_its_left_at_the_far_corners_of_the_grid() {
        let far = LIMIT - 1;
        let line = Line::through(point(-far, -far), point(far, far - 1));
        assert!(line.at(point(-far, far)) > 0 && line.at(point(far, -far)) < 0);
        assert_eq!(line.at(point(far, far - 1)), 0);
        assert!(line.has_right(point(0, -9), point(8, -1)) && !line.has_right(point(0, -9), point(8, 9)));
        let other = Line::through(point(-far, far), point(far, -far));
        assert_eq!(Line::through(point(far, -far), point(far, far)).side(line, other), Ordering::Greater);
        assert_eq!(Line::through(point(far, far), point(far, -far)).side(line, other), Ordering::Less);
    }

    #[test]
    fn the_side_of_a_meeting_point_is_right_where_floating_point_is_not() {
        // Two lines that meet a hair beside a third: 1/3 of a unit against a line through the grid's points.
        let flat = Line::through(point(0, 900_000_000), point(3, 900_000_001));
        let upright = Line::through(point(1, 0), point(1, 7));
        let level = Line::through(point(-5, 900_000_000), point(1_000_000_000, 900_000_000));
        assert_eq!(level.side(flat, upright), Ordering::Greater);
        assert_eq!(level.side(upright, flat), Ordering::Greater);
        assert_eq!(level.reversed().side(flat, upright), Ordering::Less);
        let [z, r] = flat.meets(upright);
        assert!((z - 1e-6).abs() < 1e-15 && (r - 900.000_000_333_333_3).abs() < 1e-12);
        // Through the meeting point itself, and past it.
        let rising = Line::through(point(0, 900_000_000), point(9, 900_000_009));
        let past = |low: i64| Line::through(point(-2, 899_999_999 - low), point(4, 900_000_002)).side(flat, rising);
        assert_eq!(past(0), Ordering::Equal);
        assert_eq!(past(1), Ordering::Greater);
        let third = Line::through(point(0, 0), point(2, 2));
        assert_eq!(
            third.side(Line::through(point(0, 2), point(2, 0)), Line::through(point(0, 1), point(2, 1))),
            Ordering::Equal
        );
    }

    #[test]
    fn one_line_is_known_by_any_two_of_its_points() {
        let line = Line::through(point(1, 5), point(4, 11));
        assert!(line.same(Line::through(point(-2, -1), point(0, 3))));
        assert!(!line.same(Line::through(point(0, 3), point(-2, -1))), "the other way");
        assert!(!line.same(Line::through(point(1, 6), point(4, 12))), "beside it");
        assert!(!line.same(Line::through(point(1, 5), point(4, 12))), "turned");
        assert!(Line::through(point(0, 7), point(3, 7)).same(Line::through(point(-9, 7), point(8, 7))));
    }

    #[test]
    fn what_is_off_the_grid_has_no_point() {
        assert_eq!(Point::near([1.234_567_8, -2.0]), Some(point(1_234_568, -2_000_000)));
        assert_eq!(Point::near([1073.8, 0.0]), None);
        assert_eq!(Point::near([f64::NAN, 0.0]), None);
    }
}
