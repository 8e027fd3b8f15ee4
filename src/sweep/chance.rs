//! Numbers by chance that are the same for ever: those of a plan must not change with the version of a library.
//!
//! SplitMix64 (Steele, Lea and Flood, 2014): each output is a fixed mixing of a counter.

/// What the counter of SplitMix64 goes on by: 2⁶⁴ over the golden ratio, odd.
const GOLDEN: u64 = 0x9E37_79B9_7F4A_7C15;

/// The output of SplitMix64 for a state.
#[must_use]
pub const fn mixed(state: u64) -> u64 {
    let z = state.wrapping_add(GOLDEN);
    let z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

/// The number of a seed for a purpose and an index in it.
#[must_use]
pub const fn drawn(seed: u64, purpose: u64, index: u64) -> u64 {
    mixed(mixed(mixed(seed) ^ purpose) ^ index)
}

/// A number as one from 0 to below 1: its highest 53 bits.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "53 bits are exact")]
pub const fn unit(number: u64) -> f64 {
    (number >> 11) as f64 / (1_u64 << 53) as f64
}

/// The place of an index in a permutation of `0..count` that a key decides: a Feistel network over the next even power of two,
/// walked until it is inside. So no permutation is kept, however many designs there are.
#[must_use]
pub fn permuted(index: u64, count: u64, key: u64) -> u64 {
    if count < 2 {
        return 0;
    }
    let bits = u64::BITS - (count - 1).leading_zeros();
    let half = bits.div_ceil(2);
    let mask = (1_u64 << half) - 1;
    let mut at = index;
    loop {
        let (mut left, mut right) = (at >> half, at & mask);
        for round in 0..6 {
            (left, right) = (right, left ^ (drawn(key, round, right) & mask));
        }
        at = (left << half) | right;
        if at < count {
            return at;
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn the_stream_is_that_of_the_published_generator() {
        // The first outputs of SplitMix64 from state 0, as in its authors' reference.
        let stream: Vec<u64> = (0..3).map(|step| mixed(GOLDEN.wrapping_mul(step))).collect();
        assert_eq!(stream, [0xE220_A839_7B1D_CDAF, 0x6E78_9E6A_A1B9_65F4, 0x06C4_5D18_8009_454F]);
        assert!(unit(u64::MAX) < 1.0 && unit(0) == 0.0);
    }

    #[test]
    fn a_permutation_gives_every_place_once_and_another_key_another_order() {
        for count in [1, 2, 3, 7, 64, 1000, 4097] {
            let places: Vec<u64> = (0..count).map(|index| permuted(index, count, 5)).collect();
            assert!(places.iter().copied().collect::<BTreeSet<_>>().into_iter().eq(0..count), "{count}");
            if count > 64 {
                assert_ne!(places, (0..count).map(|index| permuted(index, count, 6)).collect::<Vec<_>>());
            }
        }
    }
}
