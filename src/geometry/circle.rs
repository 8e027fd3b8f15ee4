//! The circle through three points of a plane.

use nalgebra::Vector2;

/// A circle with the direction in which it is run through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// The centre, in the frame and the unit of the three points.
    pub centre: Vector2<f64>,
    /// The radius, in their unit.
    pub radius: f64,
    /// True where the three points turn left, that is counter-clockwise.
    pub left: bool,
}

/// The cross product of two steps.
fn cross(one: Vector2<f64>, other: Vector2<f64>) -> f64 {
    one.x * other.y - one.y * other.x
}

/// The circle through three points in order; `None` where they lie on a line within the precision of numbers.
///
/// With the steps d = P₁ − P₀ and f = P₂ − P₀ the centre is
/// P₀ + (d²·(f_y, −f_x) − f²·(d_y, −d_x))/(2 d×f).
///
/// # Derivation
/// With c the centre less P₀, |c − d| = |c| and |c − f| = |c|: 2 c·d = d² and 2 c·f = f², solved by Cramer's rule.
#[must_use]
pub fn through([first, second, third]: [Vector2<f64>; 3]) -> Option<Circle> {
    let (d, f) = (second - first, third - first);
    let turn = cross(d, f);
    let (d2, f2) = (d.norm_squared(), f.norm_squared());
    if turn.abs() <= 1e-14 * (d2 * f2).sqrt() || turn == 0.0 {
        return None;
    }
    let to_centre = Vector2::new(f.y * d2 - d.y * f2, d.x * f2 - f.x * d2) / (2.0 * turn);
    let radius = to_centre.norm();
    let centre = first + to_centre;
    (radius.is_finite()).then_some(Circle { centre, radius, left: turn > 0.0 })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_points_of_a_circle_give_it_back_with_its_direction() {
        let at = |degrees: f64| {
            let (sin, cos) = crate::number::trig::sin_cos(degrees.to_radians());
            Vector2::new(3.0 + 5.0 * cos, -2.0 + 5.0 * sin)
        };
        for (angles, left) in [([0.0, 40.0, 100.0], true), ([100.0, 40.0, 0.0], false), ([350.0, 10.0, 200.0], true)] {
            let found = through(angles.map(at)).unwrap();
            assert!((found.centre - Vector2::new(3.0, -2.0)).norm() < 1e-12, "{found:?}");
            assert!((found.radius - 5.0).abs() < 1e-12);
            assert_eq!(found.left, left);
        }
    }

    #[test]
    fn points_of_a_line_have_no_circle() {
        let line = |x: f64| Vector2::new(x, 2.0 * x);
        assert_eq!(through([line(0.0), line(1.0), line(3.0)]), None);
        assert_eq!(through([line(1.0), line(1.0), line(3.0)]), None);
    }
}
