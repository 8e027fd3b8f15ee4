//! Values of a function in one variable, kept as parabolas: what is asked for thousands of times is worked out some tens
//! of times.
//!
//! # Derivation
//! Over a panel the parabola through its ends and its middle is taken; where it misses the function by more than the
//! tolerance at a quarter or at three quarters, the panel is halved. A bend of the function so takes a few narrow panels,
//! and no more.

/// How often a panel is halved before anything is looked at, and at most.
const HALVINGS: std::ops::Range<u8> = 2..14;

#[derive(Clone, Copy, Debug, PartialEq)]
struct Panel<const N: usize> {
    ends: [f64; 2],
    /// At its beginning, its middle and its end.
    at: [[f64; N]; 3],
}

impl<const N: usize> Panel<N> {
    fn at(&self, x: f64) -> [f64; N] {
        let [begin, end] = self.ends;
        let t = if end > begin { (x - begin) / (end - begin) } else { 0.0 };
        let weights = [(1.0 - t) * (1.0 - 2.0 * t), 4.0 * t * (1.0 - t), t * (2.0 * t - 1.0)];
        let mut value = [0.0; N];
        for (k, value) in value.iter_mut().enumerate() {
            *value = (0..3).map(|node: usize| weights[node] * self.at[node][k]).sum();
        }
        value
    }
}

/// A function with N values.
#[derive(Clone, Debug, PartialEq)]
pub struct Table<const N: usize> {
    panels: Vec<Panel<N>>,
}

impl<const N: usize> Table<N> {
    /// The function over some pieces that follow each other, given by where they end (two places at least, in order), to
    /// the tolerance of each value at about all x.
    #[must_use]
    pub fn new(pieces: &[f64], tolerance: [f64; N], value: impl Fn(f64) -> [f64; N]) -> Self {
        let mut table = Self { panels: Vec::new() };
        for piece in pieces.windows(2) {
            let ends = [piece[0], piece[1]];
            let middle = f64::midpoint(ends[0], ends[1]);
            let panel = Panel { ends, at: [value(ends[0]), value(middle), value(ends[1])] };
            table.fill(panel, 0, &tolerance, &value);
        }
        table
    }

    fn fill(&mut self, panel: Panel<N>, halved: u8, tolerance: &[f64; N], value: &impl Fn(f64) -> [f64; N]) {
        let [begin, end] = panel.ends;
        let quarter = |part: f64| begin + (end - begin) * part;
        let quarters = [quarter(0.25), quarter(0.75)];
        let found = [value(quarters[0]), value(quarters[1])];
        let close = quarters.iter().zip(&found).all(|(&x, found)| {
            let near = panel.at(x);
            (0..N).all(|k| (near[k] - found[k]).abs() <= tolerance[k])
        });
        if close && halved >= HALVINGS.start || halved + 1 >= HALVINGS.end {
            self.panels.push(panel);
            return;
        }
        let middle = f64::midpoint(begin, end);
        let halves = [
            Panel { ends: [begin, middle], at: [panel.at[0], found[0], panel.at[1]] },
            Panel { ends: [middle, end], at: [panel.at[1], found[1], panel.at[2]] },
        ];
        for half in halves {
            self.fill(half, halved + 1, tolerance, value);
        }
    }

    /// The values at x; those of the nearer end beyond both.
    #[must_use]
    pub fn at(&self, x: f64) -> [f64; N] {
        let after = self.panels.partition_point(|panel| panel.ends[1] < x).min(self.panels.len().saturating_sub(1));
        self.panels.get(after).map_or([0.0; N], |panel| panel.at(x.clamp(panel.ends[0], panel.ends[1])))
    }

    /// Where its panels begin and end.
    pub fn nodes(&self) -> impl Iterator<Item = f64> {
        self.panels.iter().take(1).map(|panel| panel.ends[0]).chain(self.panels.iter().map(|panel| panel.ends[1]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_function_is_kept_to_its_tolerance_bends_and_all() {
        let function = |x: f64| [1.0 / (1.2 + x), (x - 0.3).abs(), x * x];
        let table = Table::new(&[-1.0, 0.5, 2.0], [1e-7, 1e-4, 1e-12], function);
        for step in 0..=3000 {
            let x = -1.0 + f64::from(step) / 1000.0;
            let (near, exact) = (table.at(x), function(x));
            assert!((near[0] - exact[0]).abs() < 3e-7, "{x}");
            assert!((near[1] - exact[1]).abs() < 3e-4, "{x}");
            assert!((near[2] - exact[2]).abs() < 1e-12, "{x}");
        }
        assert!(table.nodes().count() < 400, "{}", table.nodes().count());
        assert_eq!(table.at(9.0), table.at(2.0));
        assert_eq!(table.at(-9.0), table.at(-1.0));
    }
}
