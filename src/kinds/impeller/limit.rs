//! Limits of a coordinate over a cell of two others.

/// Limits of h at the corners of a cell, by time and v, and how much they change along each.
#[derive(Clone, Copy, Debug)]
pub struct Limit {
    /// By time, then by v.
    pub h: [[f64; 2]; 2],
    /// In time and in v.
    pub changes: [f64; 2],
}

impl Limit {
    /// The same everywhere.
    #[must_use]
    pub const fn level(h: f64) -> Self {
        Self { h: [[h; 2]; 2], changes: [0.0; 2] }
    }

    /// Straight between four values.
    #[must_use]
    pub fn through(h: [[f64; 2]; 2]) -> Self {
        let in_time = (h[1][0] - h[0][0]).abs().max((h[1][1] - h[0][1]).abs());
        let in_v = (h[0][1] - h[0][0]).abs().max((h[1][1] - h[1][0]).abs());
        Self { h, changes: [in_time, in_v] }
    }

    /// The limits at all four corners, `by` deeper (mm); how they change stays.
    #[must_use]
    pub fn moved(mut self, by: f64) -> Self {
        for h in &mut self.h {
            h[0] += by;
            h[1] += by;
        }
        self
    }

    /// True where all lie within two depths.
    #[must_use]
    pub fn within(&self, depths: [f64; 2]) -> bool {
        let held = |h: f64| h >= depths[0] && h <= depths[1];
        let [[a, b], [c, d]] = self.h;
        held(a) && held(b) && held(c) && held(d)
    }

    /// The sum of the four values, mm: four times their mean, to compare two limits by.
    #[must_use]
    pub fn sum(&self) -> f64 {
        let [[a, b], [c, d]] = self.h;
        a + b + c + d
    }
}
