//! The sequence of Sobol, any point of it by its index.
//!
//! Source: I. M. Sobol, 1967, in the order of Antonov and Saleev (Gray code), with the direction numbers of S. Joe and
//! F. Y. Kuo, "Constructing Sobol sequences with better two-dimensional projections", SIAM J. Sci. Comput. 30 (2008). A seed
//! shifts every coordinate digit by digit (exclusive or), which keeps what the sequence promises of powers of two.

use super::chance::drawn;

/// The most coordinates.
pub const MOST: usize = DIRECTIONS.len() + 1;

/// Binary digits of a coordinate.
const DIGITS: u32 = 52;

/// The primitive polynomials, their coefficients as digits, with the first direction numbers; those of the first coordinate
/// are powers of two.
const DIRECTIONS: [(u32, &[u64]); 39] = [
    (3, &[1]),
    (7, &[1, 3]),
    (11, &[1, 3, 1]),
    (13, &[1, 1, 1]),
    (19, &[1, 1, 3, 3]),
    (25, &[1, 3, 5, 13]),
    (37, &[1, 1, 5, 5, 17]),
    (41, &[1, 1, 5, 5, 5]),
    (47, &[1, 1, 7, 11, 19]),
    (55, &[1, 1, 5, 1, 1]),
    (59, &[1, 1, 1, 3, 11]),
    (61, &[1, 3, 5, 5, 31]),
    (67, &[1, 3, 3, 9, 7, 49]),
    (91, &[1, 1, 1, 15, 21, 21]),
    (97, &[1, 3, 1, 13, 27, 49]),
    (103, &[1, 1, 1, 15, 7, 5]),
    (109, &[1, 3, 1, 15, 13, 25]),
    (115, &[1, 1, 5, 5, 19, 61]),
    (131, &[1, 3, 7, 11, 23, 15, 103]),
    (137, &[1, 3, 7, 13, 13, 15, 69]),
    (143, &[1, 1, 3, 13, 7, 35, 63]),
    (145, &[1, 3, 5, 9, 1, 25, 53]),
    (157, &[1, 3, 1, 13, 9, 35, 107]),
    (167, &[1, 3, 1, 5, 27, 61, 31]),
    (171, &[1, 1, 5, 11, 19, 41, 61]),
    (185, &[1, 3, 5, 3, 3, 13, 69]),
    (191, &[1, 1, 7, 13, 1, 19, 1]),
    (193, &[1, 3, 7, 5, 13, 19, 59]),
    (203, &[1, 1, 3, 9, 25, 29, 41]),
    (211, &[1, 3, 5, 13, 23, 1, 55]),
    (213, &[1, 3, 7, 3, 13, 59, 17]),
    (229, &[1, 3, 1, 3, 5, 53, 69]),
    (239, &[1, 1, 5, 5, 23, 33, 13]),
    (241, &[1, 1, 7, 7, 1, 61, 123]),
    (247, &[1, 1, 7, 9, 13, 61, 49]),
    (253, &[1, 3, 3, 5, 3, 55, 33]),
    (285, &[1, 3, 1, 15, 31, 13, 49, 245]),
    (299, &[1, 3, 5, 15, 31, 59, 63, 97]),
    (301, &[1, 3, 1, 11, 11, 11, 77, 249]),
];

/// The points of so many coordinates.
#[derive(Clone, Debug)]
pub struct Sobol {
    directions: Vec<[u64; DIGITS as usize]>,
    shifts: Vec<u64>,
}

impl Sobol {
    /// The sequence, shifted by a seed; with seed 0 as it is. More than [`MOST`] coordinates are cut off.
    #[must_use]
    pub fn new(coordinates: usize, seed: u64) -> Self {
        let shift = |coordinate: u64| if seed == 0 { 0 } else { drawn(seed, coordinate, 0) >> (u64::BITS - DIGITS) };
        Self {
            directions: (0..coordinates.min(MOST)).map(directions).collect(),
            shifts: (0..).take(coordinates.min(MOST)).map(shift).collect(),
        }
    }

    /// A coordinate of a point, from 0 to below 1.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "52 digits are exact")]
    pub fn at(&self, index: u64, coordinate: usize) -> f64 {
        let gray = index ^ (index >> 1);
        let (Some(directions), Some(shift)) = (self.directions.get(coordinate), self.shifts.get(coordinate)) else {
            return 0.0;
        };
        let set = directions.iter().enumerate().filter(|(digit, _)| gray >> digit & 1 == 1);
        set.fold(*shift, |sum, (_, direction)| sum ^ direction) as f64 / (1_u64 << DIGITS) as f64
    }
}

/// The direction numbers of a coordinate, as whole numbers of `2^-DIGITS`.
fn directions(coordinate: usize) -> [u64; DIGITS as usize] {
    let Some((polynomial, first)) = coordinate.checked_sub(1).and_then(|at| DIRECTIONS.get(at)) else {
        return std::array::from_fn(|digit| 1 << (DIGITS as usize - 1 - digit));
    };
    let degree = first.len();
    let mut m = [0_u64; DIGITS as usize];
    m[..degree].copy_from_slice(first);
    for at in degree..m.len() {
        let mut next = m[at - degree];
        for back in 1..=degree {
            let coefficient = u64::from(polynomial >> (degree - back) & 1);
            next ^= (coefficient * m[at - back]) << back;
        }
        m[at] = next;
    }
    std::array::from_fn(|digit| m[digit] << (DIGITS as usize - 1 - digit))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of `scipy.stats.qmc.Sobol(40, scramble=False)`, SciPy 1.17.1: index, and the first four, the tenth and the last coordinate.
    const SCIPY: [(u64, [f64; 6]); 8] = [
        (0, [0.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
        (1, [0.5, 0.5, 0.5, 0.5, 0.5, 0.5]),
        (2, [0.75, 0.25, 0.25, 0.25, 0.75, 0.25]),
        (3, [0.25, 0.75, 0.75, 0.75, 0.25, 0.75]),
        (7, [0.125, 0.625, 0.375, 0.125, 0.875, 0.125]),
        (100, [0.4140625, 0.2578125, 0.7734375, 0.7265625, 0.6953125, 0.1328125]),
        (511, [0.001953125, 0.501953125, 0.408203125, 0.845703125, 0.201171875, 0.236328125]),
        (1023, [0.0009765625, 0.7529296875, 0.6123046875, 0.1455078125, 0.8505859375, 0.6982421875]),
    ];

    #[test]
    fn the_points_are_those_of_scipy() {
        let sobol = Sobol::new(40, 0);
        for (index, point) in SCIPY {
            assert_eq!([0, 1, 2, 3, 9, 39].map(|coordinate| sobol.at(index, coordinate)), point, "{index}");
        }
        assert_eq!(MOST, 40);
    }

    #[test]
    fn powers_of_two_fill_every_interval_once_whatever_the_seed() {
        for seed in [0, 1, 7, u64::MAX] {
            let sobol = Sobol::new(40, seed);
            for coordinate in 0..40 {
                let mut filled = [false; 256];
                for index in 0..256 {
                    let at = (sobol.at(index, coordinate) * 256.0).floor();
                    let slot = (0..256_u32).position(|slot| f64::from(slot) == at).unwrap();
                    assert!(!std::mem::replace(&mut filled[slot], true), "{seed} {coordinate} {index}");
                }
            }
        }
        assert_ne!(Sobol::new(1, 1).at(0, 0).to_bits(), Sobol::new(1, 2).at(0, 0).to_bits());
    }
}
