//! Roots of equations.

/// The real roots of a·x² + b·x + c = 0, the smaller first; none where they are complex or a is 0.
///
/// The root of larger size is computed first and the other from the product c/a, so that neither loses digits to
/// cancellation.
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
}
