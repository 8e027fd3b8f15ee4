//! The end mill, and how deep its end may stand in the tube.
//!
//! # Units
//! Millimetres.

/// An end mill: a flat one has no corner radius, a ball one half its diameter, a bull-nose one something between.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tool {
    /// d, the diameter, mm.
    pub d: f64,
    /// r_c, the corner radius.
    pub r_c: f64,
}

impl Tool {
    /// A flat end mill of the diameter d.
    #[must_use]
    pub const fn flat(d: f64) -> Self {
        Self { d, r_c: 0.0 }
    }

    /// A ball end mill of the diameter d.
    #[must_use]
    pub const fn ball(d: f64) -> Self {
        Self { d, r_c: d / 2.0 }
    }

    /// a = d/2, the radius, mm.
    #[must_use]
    pub const fn a(&self) -> f64 {
        self.d / 2.0
    }

    /// Half the width of the flat of its end: a − r_c.
    #[must_use]
    pub const fn flat_radius(&self) -> f64 {
        self.d / 2.0 - self.r_c
    }

    /// How far below a point c its tip stands when its end touches the ball of radius r_f about c from inside, the axis
    /// passing c at the distance m; negative m where the tool has run out of the blank by −m and only what is still in it
    /// counts: √((r_f − r_c)² − max(a − r_c + m, 0)²) + r_c. `None` for a tool too wide for the ball.
    #[must_use]
    pub fn below(&self, r_f: f64, m: f64) -> Option<f64> {
        let (ball, reach) = (r_f - self.r_c, (self.flat_radius() + m).max(0.0));
        (ball > reach).then(|| (ball * ball - reach * reach).sqrt() + self.r_c)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// r + a_p, r, t*: check values for a tool of diameter 6.
    #[test]
    fn tips_stand_as_deep_as_the_check_values_say() {
        for (r, a_p, flat, cornered) in
            [(15.0, 2.0, 1.733_201, 1.874_508), (17.0, 4.0, 3.784_610, 3.899_749), (30.0, 3.0, 2.863_353, 2.937_439)]
        {
            let t = |tool: Tool| tool.below(r + a_p, 0.0).unwrap() - r;
            assert!((t(Tool::flat(6.0)) - flat).abs() < 5.1e-7);
            assert!((t(Tool { d: 6.0, r_c: 1.0 }) - cornered).abs() < 5.1e-7);
            assert!((t(Tool::ball(6.0)) - a_p).abs() < 1e-12);
        }
    }

    #[test]
    fn a_tool_that_runs_out_sinks_to_the_floor_and_no_deeper() {
        let tool = Tool::flat(6.0);
        let below = |out: f64| tool.below(17.0, -out).unwrap();
        assert!(below(1.0) > below(0.0) && below(3.0) == 17.0 && below(9.0) == 17.0);
        assert_eq!(Tool::flat(34.0).below(17.0, 0.0), None);
        assert_eq!(tool.below(17.0, 14.5), None);
    }
}
