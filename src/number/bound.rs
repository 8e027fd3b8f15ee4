//! The greatest values of functions over a span, enclosed by branch and bound.
//!
//! Of each span between two looks something is known that it nowhere exceeds. A span that could hold more than was seen so far
//! is looked at in its middle and parted. Nothing between the looks is left unsaid: where the work that may be spent ends
//! first, what is nowhere exceeded stays as great as it was.

/// The greatest values of K functions, over all spans taken in so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enclosure<const K: usize> {
    /// The greatest values seen.
    pub reached: [f64; K],
    /// What is nowhere exceeded.
    pub at_most: [f64; K],
    /// How near the two must come.
    fine: [f64; K],
    /// On which side of these the answer must be known.
    limit: [f64; K],
    /// Looks that may still be taken.
    left: u32,
}

/// How deep a span is parted: below the last digit of its parameter.
const DEEPEST: u32 = 48;

impl<const K: usize> Enclosure<K> {
    /// Of nothing yet: to be known to `fine`, and on which side of `limit`, within so many looks.
    #[must_use]
    pub const fn new(fine: [f64; K], limit: [f64; K], looks: u32) -> Self {
        Self { reached: [f64::NEG_INFINITY; K], at_most: [f64::NEG_INFINITY; K], fine, limit, left: looks }
    }

    /// Looks that may still be taken.
    #[must_use]
    pub const fn left(&self) -> u32 {
        self.left
    }

    /// Takes the spans between looks in. `middle` looks between two, `over` says what their span nowhere exceeds; a look is
    /// turned into its values by `values`.
    pub fn take<N: Copy>(
        &mut self,
        looks: &[N],
        values: impl Fn(&N) -> [f64; K],
        over: impl Fn(&N, &N) -> [f64; K],
        mut middle: impl FnMut(&N, &N) -> N,
    ) {
        for look in looks {
            self.see(values(look));
        }
        let mut spans: Vec<(N, N, u32)> = looks.windows(2).map(|pair| (pair[0], pair[1], 0)).collect();
        while let Some((one, other, depth)) = spans.pop() {
            let over = over(&one, &other).map(|most| if most.is_nan() { f64::INFINITY } else { most });
            let settled = (0..K).all(|k| {
                over[k] <= self.reached[k] + self.fine[k]
                    && (over[k] <= self.limit[k] || self.reached[k] > self.limit[k])
            });
            if settled || self.left == 0 || depth == DEEPEST {
                for (most, over) in self.at_most.iter_mut().zip(over) {
                    *most = most.max(over);
                }
                continue;
            }
            self.left -= 1;
            let between = middle(&one, &other);
            self.see(values(&between));
            spans.push((between, other, depth + 1));
            spans.push((one, between, depth + 1));
        }
    }

    fn see(&mut self, values: [f64; K]) {
        for (k, value) in values.into_iter().enumerate() {
            let value = if value.is_nan() { f64::INFINITY } else { value };
            self.reached[k] = self.reached[k].max(value);
            self.at_most[k] = self.at_most[k].max(value);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::trig::{cos, sin};

    /// sin 7t + t/2 with its true greatest value, second derivative at most 49.
    fn enclosed(looks: u32, limit: f64) -> Enclosure<1> {
        let value = |t: &f64| [sin(7.0 * t) + 0.5 * t];
        let over = |a: &f64, b: &f64| [value(a)[0].max(value(b)[0]) + 49.0 * (b - a) * (b - a) / 8.0];
        let mut found = Enclosure::new([1e-3], [limit], looks);
        found.take(&[0.0, 3.0], value, over, |a, b| f64::midpoint(*a, *b));
        found
    }

    #[test]
    fn the_greatest_value_is_enclosed_and_no_work_is_lost_where_none_can_be() {
        // 7 cos 7t = −1/2 at the third crest.
        let t = (std::f64::consts::TAU * 3.0 + libm::acos(-0.5 / 7.0)) / 7.0;
        let t = if t > 3.0 { t - std::f64::consts::TAU / 7.0 } else { t };
        assert!((7.0 * cos(7.0 * t) + 0.5).abs() < 1e-9);
        let most = sin(7.0 * t) + 0.5 * t;
        let found = enclosed(10_000, 1e9);
        assert!(found.reached[0] <= most && most <= found.at_most[0], "{found:?} {most}");
        assert!(found.at_most[0] - found.reached[0] <= 1e-3);
        assert!(10_000 - found.left() < 200, "{} looks", 10_000 - found.left());
    }

    #[test]
    fn a_limit_within_reach_of_the_bound_is_decided_and_one_without_work_is_not() {
        let most = enclosed(10_000, 1e9).at_most[0];
        for limit in [most + 1e-6, most - 1e-5] {
            let found = enclosed(100_000, limit);
            assert!(found.at_most[0] <= limit || found.reached[0] > limit, "{found:?} {limit}");
        }
        let found = enclosed(3, most + 1e-6);
        assert!(found.reached[0] <= most && found.at_most[0] > most + 1.0, "{found:?}");
    }
}
