//! The indices of Sobol: which part of an objective's variance each input explains, alone and with all others.
//!
//! Source: A. Saltelli and others, "Variance based sensitivity analysis of model output", Computer Physics Communications 181
//! (2010), table 2: estimator (b) for the first-order index, and that of M. J. W. Jansen (1999), estimator (f), for the total one.
//! With f(A), f(B) and f(A with input i of B) of n triples, V the variance of all f(A) and f(B), and m their mean,
//!
//! - S_i = Σ (f(B) − m)·(f(A_B,i) − f(A))/(n·V);
//! - T_i = Σ (f(A) − f(A_B,i))²/(2·n·V).

use crate::sweep::plan::{Method, Plan};
use crate::sweep::table::{Cells, FEASIBLE, ID, Table, whole};

/// The fewest triples from which an index is told.
pub const LEAST: f64 = 16.0;
/// The half width of the interval in which an estimate lies in 19 of 20 cases, in standard errors.
const SURE: f64 = 1.96;

/// The two indices of an input for an objective.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Index {
    /// The part of the variance that this input explains alone.
    pub first: f64,
    /// The part that it explains alone and together with others.
    pub total: f64,
    /// By how much each may be off, in 19 of 20 cases, as if the designs had been drawn by chance: those of Sobol's sequence are more
    /// even, so that it is usually less.
    pub off: [f64; 2],
}

/// Sums over triples, each value less the first one: so nothing is lost where values are large and differ little.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    count: f64,
    /// Of a and b, and of their squares.
    values: f64,
    squares: f64,
    /// Of d = f(A_B,i) − f(A): d, b·d, (b·d)², b·d², d², d⁴.
    d: f64,
    bd: f64,
    bd_squared: f64,
    bdd: f64,
    dd: f64,
    dddd: f64,
}

impl Sums {
    fn take(&mut self, a: f64, b: f64, d: f64) {
        self.count += 1.0;
        self.values += a + b;
        self.squares += a * a + b * b;
        self.d += d;
        self.bd += b * d;
        self.bd_squared += b * d * b * d;
        self.bdd += b * d * d;
        self.dd += d * d;
        self.dddd += d * d * d * d;
    }

    fn index(&self) -> Option<Index> {
        let n = self.count;
        if n < LEAST {
            return None;
        }
        let mean = self.values / (2.0 * n);
        let variance = self.squares / (2.0 * n) - mean * mean;
        // What rounding leaves of values that are all the same.
        if variance <= 1e-24 * (self.squares / (2.0 * n)).max(f64::MIN_POSITIVE) {
            return None;
        }
        let (first, total) = ((self.bd - mean * self.d) / n / variance, self.dd / (2.0 * n) / variance);
        let of_first = (self.bd_squared - 2.0 * mean * self.bdd + mean * mean * self.dd) / n / (variance * variance);
        let of_total = self.dddd / n / (4.0 * variance * variance);
        let off = |square: f64, mean: f64| SURE * ((square - mean * mean).max(0.0) / n).sqrt();
        Some(Index { first, total, off: [off(of_first, first), off(of_total, total)] })
    }
}

/// The indices, from the rows of a plan that was made for them. Triples with a design that is not feasible are left out.
#[derive(Debug)]
pub struct Indices<'a> {
    plan: &'a Plan,
    /// By input, then objective.
    sums: Vec<Vec<Sums>>,
    /// The value that is taken off, by objective.
    shift: Vec<Option<f64>>,
    /// The group that is not yet whole: its number, and values by objective, of A, B and each A_B,i.
    group: (u64, Vec<Vec<Option<f64>>>),
}

impl<'a> Indices<'a> {
    /// Of no rows yet; `None` for a plan that was not made for them.
    #[must_use]
    pub fn new(plan: &'a Plan) -> Option<Self> {
        let objectives = plan.objectives.len();
        (plan.method == Method::Saltelli).then(|| Self {
            plan,
            sums: vec![vec![Sums::default(); objectives]; plan.inputs.len()],
            shift: vec![None; objectives],
            group: (0, Vec::new()),
        })
    }

    /// Takes rows in, in the order of their indices.
    pub fn take(&mut self, rows: &Table) {
        let (Some(id), Some(feasible)) = (rows.column(ID), rows.column(FEASIBLE)) else { return };
        let objectives: Vec<_> = self.plan.objectives.iter().map(|one| rows.column(one.measure.key)).collect();
        for row in 0..rows.rows() {
            let Some(id) = id.number(row) else { continue };
            let (number, _) = self.plan.group(whole(id));
            if number != self.group.0 {
                self.group = (number, Vec::new());
            }
            let good = feasible.truth(row);
            let value = |cells: &Option<&Cells>| cells.filter(|_| good)?.number(row);
            self.group.1.push(objectives.iter().map(value).collect());
            if self.group.1.len() == self.plan.inputs.len() + 2 {
                self.whole();
            }
        }
    }

    /// Takes a whole group in.
    fn whole(&mut self) {
        let values = std::mem::take(&mut self.group.1);
        let of = |design: usize, objective: usize| values.get(design)?.get(objective).copied().flatten();
        for (input, sums) in self.sums.iter_mut().enumerate() {
            for (objective, (sums, shift)) in sums.iter_mut().zip(&mut self.shift).enumerate() {
                let triple = (of(0, objective), of(1, objective), of(input + 2, objective));
                if let (Some(a), Some(b), Some(mixed)) = triple {
                    let shift = *shift.get_or_insert(a);
                    sums.take(a - shift, b - shift, mixed - a);
                }
            }
        }
    }

    /// The indices by input, then objective; `None` where there are too few triples, or nothing varies.
    #[must_use]
    pub fn end(&self) -> Vec<Vec<Option<Index>>> {
        self.sums.iter().map(|of_input| of_input.iter().map(Sums::index).collect()).collect()
    }

    /// How many triples there are for the input and objective that have the fewest, of how many there could be.
    #[must_use]
    pub fn triples(&self) -> (u64, u64) {
        let counts = self.sums.iter().flatten().map(|one| whole(one.count));
        (counts.min().unwrap_or_default(), self.plan.group(self.plan.count).0)
    }
}
