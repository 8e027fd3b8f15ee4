//! The numbers of a finding's value and limit, as they were compared: unrounded, for a program that reads them.

/// What a value was held against.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Limit {
    /// It may be no more.
    AtMost(f64),
    /// It may be no less.
    AtLeast(f64),
    /// It must be this.
    Exactly(f64),
    /// It must lie between the two, where they are known.
    Between {
        /// It may be no less.
        least: Option<f64>,
        /// It may be no more.
        most: Option<f64>,
    },
}

/// The value that was found and the limit that it was held against, both in the unit that they are printed with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figures {
    /// The least and the greatest that was found; the same twice of one value, none where it is no number.
    pub found: Option<[f64; 2]>,
    /// The limit; none where there is none.
    pub limit: Option<Limit>,
}

/// A count as a number: of lines, blocks, bytes.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "counts are far below 2^53")]
pub const fn count(number: u64) -> f64 {
    number as f64
}

impl Figures {
    /// No numbers.
    pub const NONE: Self = Self { found: None, limit: None };

    /// One value.
    #[must_use]
    pub const fn of(value: f64, limit: Option<Limit>) -> Self {
        Self { found: Some([value; 2]), limit }
    }

    /// The value that misses the limit, and the limit: of two ends the one that is farthest out. A limit that is one number
    /// stands there though nothing is known that missed it; without a limit the value is the least that was found.
    #[must_use]
    pub fn missed(&self) -> [Option<f64>; 2] {
        let finite = |value: f64| value.is_finite().then_some(value);
        let [low, high] = self.found.map_or([None; 2], |found| found.map(finite));
        let Some(limit) = self.limit else { return [low.or(high), None] };
        let beyond = |value: Option<f64>, limit: Option<f64>, out: fn(f64) -> f64| {
            let limit = limit.and_then(finite);
            value.zip(limit).map(|(value, limit)| (out(value - limit), value, limit))
        };
        let over: fn(f64) -> f64 = |by| by;
        let under: fn(f64) -> f64 = |by| -by;
        let (pairs, alone) = match limit {
            Limit::AtMost(most) => ([beyond(high, Some(most), over), None], finite(most)),
            Limit::AtLeast(least) => ([beyond(low, Some(least), under), None], finite(least)),
            Limit::Exactly(due) => ([low, high].map(|value| beyond(value, Some(due), f64::abs)), finite(due)),
            Limit::Between { least, most } => ([beyond(low, least, under), beyond(high, most, over)], None),
        };
        let farthest = pairs.into_iter().flatten().reduce(|one, other| if other.0 > one.0 { other } else { one });
        farthest.map_or([low.or(high), alone], |(_, value, limit)| [Some(value), Some(limit)])
    }
}

#[cfg(test)]
mod tests {
    use super::{Figures, Limit};

    #[test]
    fn the_end_that_is_farthest_out_is_told_with_the_limit_that_it_misses() {
        let missed = |found: [f64; 2], limit| {
            Figures { found: Some(found), limit: Some(limit) }.missed().map(|one| one.unwrap_or(f64::NAN))
        };
        let between = |least, most| Limit::Between { least: Some(least), most: Some(most) };
        assert_eq!(missed([0.0, 90.0], between(-10.0, 85.0)), [90.0, 85.0]);
        assert_eq!(missed([-250.9, 32.370_41], between(-1000.0, 20.0)), [32.370_41, 20.0]);
        assert_eq!(missed([-12.0, 40.0], between(-10.0, 45.0)), [-12.0, -10.0]);
        assert_eq!(missed([-12.0, 40.0], Limit::Between { least: None, most: Some(10.0) }), [40.0, 10.0]);
        assert_eq!(missed([1990.0, 2050.0], Limit::Exactly(2000.0)), [2050.0, 2000.0]);
        assert_eq!(missed([7.0; 2], between(1.0, 5.0)), [7.0, 5.0]);
        assert_eq!(missed([0.4; 2], Limit::AtMost(0.2)), [0.4, 0.2]);
        assert_eq!(missed([-0.15, 0.3], Limit::AtLeast(0.0)), [-0.15, 0.0]);
    }

    #[test]
    fn what_is_no_number_or_endless_is_not_told() {
        let missed = |found, limit| Figures { found, limit }.missed();
        assert_eq!(missed(None, Some(Limit::AtMost(0.0))), [None, Some(0.0)]);
        assert_eq!(missed(None, Some(Limit::Between { least: Some(0.0), most: Some(5.0) })), [None, None]);
        assert_eq!(missed(Some([2.0, 3.0]), None), [Some(2.0), None]);
        assert_eq!(missed(Some([f64::INFINITY; 2]), Some(Limit::AtMost(1.0))), [None, Some(1.0)]);
        assert_eq!(missed(Some([1.0; 2]), Some(Limit::AtMost(f64::NAN))), [Some(1.0), None]);
        assert_eq!(Figures::NONE.missed(), [None, None]);
    }
}
