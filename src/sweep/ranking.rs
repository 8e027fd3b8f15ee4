//! Which designs are the best, and why the others are not: taken from rows that come in parts, in any order.

use std::collections::{BTreeMap, BTreeSet};

use crate::finding::{Finding, Place, Raise};
use crate::limits::FRONT_DESIGNS;
use crate::sweep::front::{Candidate, front};
use crate::sweep::plan::Plan;
use crate::sweep::row::State;
use crate::sweep::rules::FrontCut;
use crate::sweep::table::{FEASIBLE, ID, MARGIN, REASON, STATE, Table, VALUE, whole};

/// Candidates beyond this many are thinned out while they come.
const ROOM: usize = 2;

/// What is known of all rows so far.
#[derive(Debug)]
pub struct Ranking<'a> {
    plan: &'a Plan,
    /// How many of the best are kept.
    most: usize,
    front: Vec<Candidate>,
    cut: bool,
    best: Vec<Candidate>,
    counts: Counts,
    why: BTreeMap<String, Reason>,
}

/// How many rows of each state there are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Done.
    pub done: u64,
    /// Refused.
    pub refused: u64,
    /// Failed.
    pub failed: u64,
    /// Done, with a value for every objective, and no constraint broken.
    pub feasible: u64,
}

/// What came of all rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Ranked {
    /// The front, in the order of the costs; empty without objectives.
    pub front: Vec<Candidate>,
    /// The front was longer, and is cut.
    pub cut: bool,
    /// The best, by the first objective, then the next; without objectives by their index.
    pub best: Vec<Candidate>,
    /// How many rows of each state there are.
    pub counts: Counts,
    /// Why designs are not among the feasible, most first.
    pub why: Vec<Reason>,
}

/// A reason why designs are not among the feasible.
#[derive(Clone, Debug, PartialEq)]
pub struct Reason {
    /// The code of a finding; an objective or a constraint, as their cells say it.
    pub code: String,
    /// How many rows have it.
    pub count: u64,
    /// The first design that has it.
    pub first: u64,
    /// What that design's row has as value.
    pub value: Option<f64>,
    /// By how much it misses the limit: never positive.
    pub margin: Option<f64>,
}

impl<'a> Ranking<'a> {
    /// Of no rows yet; keeps the `most` best.
    #[must_use]
    pub const fn new(plan: &'a Plan, most: usize) -> Self {
        let counts = Counts { done: 0, refused: 0, failed: 0, feasible: 0 };
        Self { plan, most, front: Vec::new(), cut: false, best: Vec::new(), counts, why: BTreeMap::new() }
    }

    /// Takes rows in.
    pub fn take(&mut self, rows: &Table) {
        let column = |name: &str| rows.column(name);
        let (Some(id), Some(state), Some(feasible), Some(reason)) =
            (column(ID), column(STATE), column(FEASIBLE), column(REASON))
        else {
            return;
        };
        let objectives: Vec<_> =
            self.plan.objectives.iter().filter_map(|one| Some((one, column(one.measure.key)?))).collect();
        let mut candidates = Vec::new();
        for row in 0..rows.rows() {
            match state.text(row) {
                Some(word) if word == State::Done.word() => self.counts.done += 1,
                Some(word) if word == State::Refused.word() => self.counts.refused += 1,
                _ => self.counts.failed += 1,
            }
            if let Some(code) = reason.text(row) {
                let first = id.number(row).map_or(u64::MAX, whole);
                let of = |name: &str| column(name).and_then(|cells| cells.number(row));
                let (value, margin) = (of(VALUE), of(MARGIN));
                let here = Reason { code: code.to_owned(), count: 1, first, value, margin };
                match self.why.get_mut(code) {
                    Some(known) if known.first < first => known.count += 1,
                    Some(known) => *known = Reason { count: known.count + 1, ..here },
                    None => drop(self.why.insert(code.to_owned(), here)),
                }
            }
            if !feasible.truth(row) {
                continue;
            }
            self.counts.feasible += 1;
            let costs = objectives.iter().filter_map(|(one, cells)| cells.number(row).map(|value| one.cost(value)));
            candidates.extend(id.number(row).map(|id| Candidate { id: whole(id), costs: costs.collect() }));
        }
        if !self.plan.objectives.is_empty() {
            let (part, cut) = front(candidates.clone());
            let (front, again) = front(std::mem::take(&mut self.front).into_iter().chain(part).collect());
            (self.front, self.cut) = (front, self.cut || cut || again);
        }
        self.best.append(&mut candidates);
        if self.best.len() > ROOM * self.most {
            self.thin();
        }
    }

    /// How many designs are on the front so far.
    #[must_use]
    pub const fn on_front(&self) -> usize {
        self.front.len()
    }

    /// How many rows of each state there are so far.
    #[must_use]
    pub const fn counts(&self) -> Counts {
        self.counts
    }

    fn thin(&mut self) {
        self.best.sort_unstable_by(Candidate::order);
        self.best.truncate(self.most);
    }

    /// What came of them.
    #[must_use]
    pub fn end(mut self) -> Ranked {
        self.thin();
        let mut why: Vec<Reason> = self.why.into_values().collect();
        why.sort_by(|one, other| other.count.cmp(&one.count).then_with(|| one.code.cmp(&other.code)));
        Ranked { front: self.front, cut: self.cut, best: self.best, counts: self.counts, why }
    }
}

impl Ranked {
    /// What a person should know of the front: that it is cut.
    #[must_use]
    pub fn told(&self) -> Option<Finding> {
        self.cut.then(|| FrontCut { most: FRONT_DESIGNS }.at(Place::File))
    }

    /// The designs that are shown: the whole front, then the best, in all at least so many where there are as many.
    #[must_use]
    pub fn top(&self, least: usize) -> Vec<u64> {
        self.followed(self.front.iter().map(|one| one.id).collect(), least)
    }

    /// Those of them that are built, so many at most: the front, spread evenly over its length where it is longer, then the best.
    #[must_use]
    pub fn built(&self, most: usize) -> Vec<u64> {
        let count = self.front.len();
        let spread = |at: usize| if most < 2 { 0 } else { at * (count - 1) / (most - 1) };
        let front: Vec<u64> = if count > most {
            (0..most).filter_map(|at| self.front.get(spread(at))).map(|one| one.id).collect()
        } else {
            self.front.iter().map(|one| one.id).collect()
        };
        self.followed(front, most)
    }

    /// Designs of the front, followed by the best that are not among them, up to so many in all.
    fn followed(&self, front: Vec<u64>, count: usize) -> Vec<u64> {
        let on_front: BTreeSet<u64> = front.iter().copied().collect();
        let rest = self.best.iter().map(|one| one.id).filter(|id| !on_front.contains(id));
        let rest: Vec<u64> = rest.take(count.saturating_sub(front.len())).collect();
        front.into_iter().chain(rest).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ranked(front: &[u64], best: &[u64]) -> Ranked {
        let candidates = |ids: &[u64]| ids.iter().map(|id| Candidate { id: *id, costs: Vec::new() }).collect();
        let counts = Counts::default();
        Ranked { front: candidates(front), cut: false, best: candidates(best), counts, why: Vec::new() }
    }

    #[test]
    fn the_top_is_the_whole_front_and_then_the_best_and_so_many_are_built() {
        let all = ranked(&[3, 5, 9], &[3, 4, 5, 8]);
        assert_eq!((all.top(5), all.built(5)), (vec![3, 5, 9, 4, 8], vec![3, 5, 9, 4, 8]));
        assert_eq!((all.top(2), all.built(2)), (vec![3, 5, 9], vec![3, 9]));
        assert_eq!((all.top(1), all.built(1)), (vec![3, 5, 9], vec![3]));
        assert_eq!((all.top(0), all.built(0)), (vec![3, 5, 9], vec![]));
        assert_eq!(ranked(&[], &[7, 8, 6]).top(2), [7, 8]);
    }
}
