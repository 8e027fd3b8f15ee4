//! The tool as a solid: a measure of distances that shares nothing with the judges.

use nalgebra::Vector3;
use rodete::number::trig::{hypot, sin_cos};

/// A tool in the part: tip, direction from the tip along the axis, radius. It reaches on for ever.
#[derive(Clone, Copy, Debug)]
pub struct Tool {
    /// The middle of its flat end.
    pub tip: Vector3<f64>,
    /// The unit vector along its axis.
    pub axis: Vector3<f64>,
    /// Half its diameter.
    pub radius: f64,
}

impl Tool {
    /// The distance of a point from the tool; negative inside, where it is the shortest way out.
    #[must_use]
    pub fn distance(&self, point: &Vector3<f64>) -> f64 {
        let from = point - self.tip;
        let up = from.dot(&self.axis);
        let out = (from - self.axis * up).norm() - self.radius;
        if out <= 0.0 {
            out.max(-up)
        } else if up >= 0.0 {
            out
        } else {
            hypot(out, up)
        }
    }

    /// The tool turned about the axis of the part.
    #[must_use]
    pub fn turned(&self, angle: f64) -> Self {
        let (sin, cos) = sin_cos(angle);
        let turn = |a: &Vector3<f64>| Vector3::new(a.x * cos - a.y * sin, a.x * sin + a.y * cos, a.z);
        Self { tip: turn(&self.tip), axis: turn(&self.axis), radius: self.radius }
    }
}

#[test]
fn the_distance_from_a_tool_is_that_from_a_flat_cylinder() {
    let tool = Tool { tip: Vector3::new(1.0, 2.0, 3.0), axis: Vector3::z(), radius: 3.0 };
    for (point, distance) in [
        ([6.0, 2.0, 10.0], 2.0),
        ([1.0, 2.0, 1.0], 2.0),
        ([8.0, 2.0, 0.0], 5.0),
        ([1.0, 4.0, 10.0], -1.0),
        ([1.0, 2.0, 3.5], -0.5),
        ([4.0, 2.0, 3.0], 0.0),
    ] {
        assert!((tool.distance(&Vector3::from(point)) - distance).abs() < 1e-12, "{point:?}");
    }
    let turned = tool.turned(std::f64::consts::FRAC_PI_2);
    assert!((turned.tip - Vector3::new(-2.0, 1.0, 3.0)).norm() < 1e-12);
}
