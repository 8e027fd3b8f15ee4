//! What waits in a heap that gives the least bound first.

use std::cmp::Ordering;

/// Something that waits, with a lower bound and its age.
#[derive(Clone, Copy, Debug)]
pub struct Waiting<T> {
    /// The lower bound, by which it is taken out.
    pub bound: f64,
    /// Its age: of those with equal bounds the one with the lowest comes first.
    pub order: usize,
    /// The thing that waits.
    pub what: T,
}

impl<T> PartialEq for Waiting<T> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl<T> Eq for Waiting<T> {}

impl<T> PartialOrd for Waiting<T> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }

    // What a heap asks.
    #[inline]
    fn le(&self, other: &Self) -> bool {
        self.cmp(other).is_le()
    }
}

impl<T> Ord for Waiting<T> {
    // The least bound is the greatest, so that the heap gives it first.
    #[inline]
    fn cmp(&self, other: &Self) -> Ordering {
        other.bound.total_cmp(&self.bound).then(other.order.cmp(&self.order))
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BinaryHeap;

    use super::*;

    #[test]
    fn the_least_bound_comes_first_and_of_equal_ones_the_older() {
        let bounds = [0.5, -1.0, 0.5, f64::INFINITY, -1.0];
        let mut heap: BinaryHeap<Waiting<()>> =
            bounds.into_iter().enumerate().map(|(order, bound)| Waiting { bound, order, what: () }).collect();
        let given: Vec<usize> = std::iter::from_fn(|| heap.pop().map(|one| one.order)).collect();
        assert_eq!(given, [1, 4, 0, 2, 3]);
    }
}
