//! The designs that no other betters in every objective.

use crate::limits::FRONT_DESIGNS;
use std::cmp::Ordering;

/// A design with the costs of its objectives: less is better in each.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// Its index.
    pub id: u64,
    /// The costs, on the grid on which they are compared: [`Objective::cost`](super::objective::Objective::cost).
    pub costs: Vec<f64>,
}

impl Candidate {
    /// The order of the costs, then of the indices.
    #[must_use]
    pub fn order(&self, other: &Self) -> Ordering {
        let costs = self.costs.iter().zip(&other.costs).map(|(one, other)| one.total_cmp(other));
        costs.fold(Ordering::Equal, Ordering::then).then(self.id.cmp(&other.id))
    }

    /// True where it is nowhere worse than another and somewhere better.
    fn betters(&self, other: &Self) -> bool {
        let pairs = || self.costs.iter().zip(&other.costs);
        pairs().all(|(one, other)| one <= other) && pairs().any(|(one, other)| one < other)
    }
}

/// The front of candidates, in the order of their costs; and whether it was longer than [`FRONT_DESIGNS`]. Designs with the same costs
/// stay together. The front of fronts is the front, so that candidates may come in parts.
#[must_use]
pub fn front(mut candidates: Vec<Candidate>) -> (Vec<Candidate>, bool) {
    // What betters a design comes before it in this order.
    candidates.sort_unstable_by(Candidate::order);
    let mut kept: Vec<Candidate> = Vec::new();
    for one in candidates {
        let bettered = if one.costs.len() <= 2 {
            // The last one kept has the least second cost so far.
            kept.last().is_some_and(|last| last.betters(&one))
        } else {
            kept.iter().rev().any(|other| other.betters(&one))
        };
        if !bettered {
            kept.push(one);
        }
        if kept.len() > FRONT_DESIGNS {
            kept.pop();
            return (kept, true);
        }
    }
    (kept, false)
}

#[cfg(test)]
mod tests {
    use super::super::chance::{drawn, unit};
    use super::*;
    use crate::kind::measure::Measure;
    use crate::table::Unit;

    /// Every candidate against every other.
    fn by_force(candidates: &[Candidate]) -> Vec<u64> {
        let kept = candidates.iter().filter(|one| !candidates.iter().any(|other| other.betters(one)));
        let mut ids: Vec<u64> = kept.map(|one| one.id).collect();
        ids.sort_unstable();
        ids
    }

    fn ids(front: &[Candidate]) -> Vec<u64> {
        let mut ids: Vec<u64> = front.iter().map(|one| one.id).collect();
        ids.sort_unstable();
        ids
    }

    fn random(count: u64, objectives: u64, seed: u64, grid: f64) -> Vec<Candidate> {
        // On a grid there are designs with the same costs.
        let cost = |id, at| (unit(drawn(seed, id, at)) * grid).floor();
        (0..count).map(|id| Candidate { id, costs: (0..objectives).map(|at| cost(id, at)).collect() }).collect()
    }

    #[test]
    fn the_front_is_that_of_every_pair_and_that_of_fronts() {
        for (seed, (objectives, grid)) in (0..).zip([(1, 50.0), (2, 8.0), (2, 1e6), (3, 8.0), (3, 1e6), (4, 20.0)]) {
            for count in [0, 1, 2, 17, 300] {
                let all = random(count, objectives, seed, grid);
                let (whole, cut) = front(all.clone());
                assert_eq!((ids(&whole), cut), (by_force(&all), false), "{objectives} {grid} {count}");
                let parts = all.chunks(7).flat_map(|part| front(part.to_vec()).0).collect();
                assert_eq!(front(parts).0, whole);
            }
        }
    }

    /// Designs that are mirrored or turned come to the same but for the last digits.
    #[test]
    fn designs_that_differ_by_rounding_alone_stay_together_and_none_betters_in_a_circle() {
        static MEASURE: Measure = Measure::read_back("V", Unit::CubicMillimetre);
        let objectives = [false, true].map(|most| crate::sweep::objective::Objective { measure: &MEASURE, most });
        let of = |id: u64, values: [f64; 2]| {
            let costs = objectives.iter().zip(values).map(|(one, value)| one.cost(value)).collect();
            Candidate { id, costs }
        };
        let off = |id: u64, at: u64| 1.0 + 1e-14 * (unit(drawn(7, id, at)) - 0.5);
        let equal: Vec<_> = (0..24).map(|id| of(id, [10.973_142 * off(id, 0), 0.006_81 * off(id, 1)])).collect();
        assert_eq!(ids(&front(equal.clone()).0), (0..24).collect::<Vec<_>>());
        assert!(equal.iter().all(|one| equal.iter().all(|other| !one.betters(other))));
        // What is better by more than that betters them all, in whatever order they come.
        let better = of(24, [10.973_141, 0.006_81]);
        assert_eq!(ids(&front(std::iter::once(better).chain(equal).collect()).0), [24]);
    }

    #[test]
    fn a_long_front_is_cut_and_says_so() {
        let line = |id: u32| Candidate { id: id.into(), costs: vec![f64::from(id), -f64::from(id)] };
        let (kept, cut) = front((0..10_001).map(line).collect());
        assert_eq!((kept.len(), cut), (FRONT_DESIGNS, true));
    }
}
