//! How fast a machine is where it does not cut: rapid motions and changes of the tool.

use crate::machine::axis::Axis;

/// The rates of rapid motions, and the time of a change of the tool; `None` where nobody says.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rapids {
    /// Of each linear axis, mm/min.
    pub linear: Option<f64>,
    /// Of each rotary axis, °/min.
    pub rotary: Option<f64>,
    /// How long a change of the tool takes, s.
    pub tool_change: Option<f64>,
}

impl Rapids {
    /// How long the axes take to go so far, s: each goes at its own rate, and the last to arrive decides. `None` where an axis
    /// moves that has no rate.
    ///
    /// Axes are at their rate at once: a machine that must accelerate them takes longer.
    #[must_use]
    pub fn seconds(&self, by: &[f64; 9]) -> Option<f64> {
        let mut longest = 0.0_f64;
        // What sums of increments leave is no way.
        for (axis, by) in Axis::ALL.into_iter().zip(by).filter(|(_, by)| by.abs() > 1e-9) {
            let rate = if axis.rotary() { self.rotary } else { self.linear }?;
            longest = longest.max(by.abs() * 60.0 / rate);
        }
        Some(longest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slowest_axis_decides() {
        let rapids = Rapids { linear: Some(6000.0), rotary: Some(1800.0), tool_change: None };
        let by = |x: f64, z: f64, c: f64| {
            let mut by = [0.0; 9];
            (by[Axis::X as usize], by[Axis::Z as usize], by[Axis::C as usize]) = (x, z, c);
            by
        };
        assert_eq!(rapids.seconds(&by(100.0, -200.0, 0.0)), Some(2.0));
        assert_eq!(rapids.seconds(&by(100.0, -200.0, 90.0)), Some(3.0));
        assert_eq!(rapids.seconds(&by(0.0, 0.0, 0.0)), Some(0.0));
        let linear = Rapids { rotary: None, ..rapids };
        assert_eq!(linear.seconds(&by(100.0, 0.0, 0.0)), Some(1.0));
        assert_eq!(linear.seconds(&by(100.0, 0.0, -1.0)), None);
    }
}
