//! Roots of equations.

/// The real roots of a·x² + b·x + c = 0, the smaller first; none where they are complex or a is 0.
///
/// The root of larger size is computed first and the other from the product c/a, so that neither loses digits to
/// cancellation.
#[inline]
#[must_use]
pub fn quadratic(a: f64, b: f64, c: f64) -> Option<[f64; 2]> {
    let discriminant = b * b - 4.0 * a * c;
    if a == 0.0 || discriminant.is_nan() || discriminant < 0.0 {
        return None;
    }
    let q = -0.5 * (b + discriminant.sqrt().copysign(b));
    let (one, other) = if q == 0.0 { (0.0, 0.0) } else { (q / a, c / q) };
    Some(if one <= other { [one, other] } else { [other, one] })
}

/// The least value of a function with one minimum in an interval, and where, by
/// golden section: each step shrinks the interval to 0.618 of it.
#[must_use]
pub fn golden([low, high]: [f64; 2], steps: u32, value: impl Fn(f64) -> f64) -> (f64, f64) {
    let ratio = (5.0_f64.sqrt() - 1.0) / 2.0;
    let (mut low, mut high) = (low, high);
    let (mut left, mut right) = (high - ratio * (high - low), low + ratio * (high - low));
    let (mut at_left, mut at_right) = (value(left), value(right));
    for _ in 0..steps {
        if at_left < at_right {
            (high, right, at_right) = (right, left, at_left);
            left = high - ratio * (high - low);
            at_left = value(left);
        } else {
            (low, left, at_left) = (left, right, at_right);
            right = low + ratio * (high - low);
            at_right = value(right);
        }
    }
    if at_left < at_right { (at_left, left) } else { (at_right, right) }
}

/// The last open place on the way from one to a shut one, by halvings: so many, and so close.
#[inline]
#[must_use]
pub fn halved([mut open, mut shut]: [f64; 2], halvings: u8, mut is_open: impl FnMut(f64) -> bool) -> f64 {
    for _ in 0..halvings {
        let middle = f64::midpoint(open, shut);
        if is_open(middle) { open = middle } else { shut = middle }
    }
    open
}

/// The last open whole number on the way up from one to a shut one.
#[inline]
#[must_use]
pub fn last_whole([mut open, mut shut]: [f64; 2], mut is_open: impl FnMut(f64) -> bool) -> f64 {
    while shut - open > 1.0 {
        let middle = f64::midpoint(open, shut).floor();
        if is_open(middle) { open = middle } else { shut = middle }
    }
    open
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quadratic_keeps_its_digits_where_the_roots_are_far_apart() {
        let [small, large] = quadratic(1.0, -1e9, 1.0).unwrap();
        assert!((small - 1e-9).abs() < 1e-24);
        assert!((large - 1e9).abs() < 1e-6);
    }

    #[test]
    fn quadratic_without_real_roots_has_none() {
        assert_eq!(quadratic(1.0, 0.0, 1.0), None);
        assert_eq!(quadratic(0.0, 1.0, 1.0), None);
        assert_eq!(quadratic(1.0, f64::NAN, 1.0), None);
        assert_eq!(quadratic(1.0, 0.0, 0.0), Some([0.0, 0.0]));
    }

    #[test]
    fn a_golden_section_finds_the_least() {
        let (value, at) = golden([-3.0, 5.0], 14, |x| (x - 1.25) * (x - 1.25) + 2.0);
        assert!((value - 2.0).abs() < 1e-4 && (at - 1.25).abs() < 0.02);
        let (value, at) = golden([0.0, 1.0], 14, |x| x);
        assert!(value < 1e-3 && at < 1e-3);
    }

    #[test]
    fn a_halving_ends_at_the_last_open_place_up_as_well_as_down() {
        let up = halved([0.0, 8.0], 20, |x| x < 2.3);
        assert!(up < 2.3 && up > 2.3 - 8.0 / f64::from(1 << 20), "{up}");
        let down = halved([8.0, 0.0], 20, |x| x > 2.3);
        assert!(down > 2.3 && down < 2.3 + 8.0 / f64::from(1 << 20), "{down}");
        // What is open is left only for what is open itself.
        assert_eq!(halved([0.0, 8.0], 20, |_| false), 0.0);
        assert_eq!(halved([0.0, 8.0], 2, |_| true), 6.0);
    }

    #[test]
    fn the_last_open_whole_number_lies_next_to_a_shut_one() {
        for last in 0..9_u8 {
            assert_eq!(last_whole([0.0, 9.0], |x| x <= f64::from(last)), f64::from(last));
        }
        assert_eq!(last_whole([4.0, 3.0], |_| true), 4.0);
    }
}
