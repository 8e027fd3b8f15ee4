//! The number of an F word: how many decimals its control takes, and the side to which it is rounded.
//!
//! Rounding never makes a move faster than it may be: a time is rounded up, its inverse and a speed down. What it costs is
//! judged by [`crate::proof::feed::feed_word`].
//!
//! # Decimals
//! Speeds have three. Times in seconds have four: an assumption, since the page of the Fagor 8070 on G93 gives no format; with
//! three, blocks of some milliseconds would lose up to a quarter of their speed. Inverse times have three, and six below 1,
//! where three would lose as much; LinuxCNC reads any number of them, before the point as well: a block of less than 0.6 ms has
//! the six digits and more that it asks for.

use crate::gcode::digits::push_whole;
use crate::gcode::feed_law::FeedLaw;
use crate::number::grid::OutOfFormat;

/// How many decimals an F word about as great as this has.
#[must_use]
pub const fn decimals(law: FeedLaw, word: f64) -> u8 {
    match law {
        FeedLaw::Seconds => 4,
        FeedLaw::InverseTime if word < 1.0 => 6,
        FeedLaw::Resultant | FeedLaw::InverseTime => 3,
    }
}

/// The step between F words about as great as this, by their decimals.
#[must_use]
pub const fn step(law: FeedLaw, word: f64) -> f64 {
    match decimals(law, word) {
        3 => 1e-3,
        4 => 1e-4,
        _ => 1e-6,
    }
}

/// How many millionths a step has, by its decimals.
const MILLIONTHS: [f64; 7] = [1e6, 1e5, 1e4, 1e3, 1e2, 1e1, 1.0];

/// The number of an F word, in millionths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FeedWord {
    millionths: u64,
    decimals: u8,
}

impl FeedWord {
    /// True where a move writes it behind one that wrote another, or none.
    #[must_use]
    pub fn is_written(self, law: FeedLaw, last: Option<Self>) -> bool {
        law.in_every_block() || last != Some(self)
    }

    /// The F word of a move that takes at least some seconds, and longer by what rounding takes at most; the fastest that
    /// there is where no word is so fast. The resultant over all axes is in mm and degrees.
    ///
    /// # Errors
    /// For a move so slow that no word has it.
    pub fn lasting(law: FeedLaw, seconds: f64, resultant: f64) -> Result<Self, OutOfFormat> {
        let wanted = law.word(seconds, resultant);
        let slower = law.slower();
        let fastest = law.fastest();
        // A move of no time and no way has no word of its own.
        let wanted = if wanted.is_nan() { fastest } else { wanted };
        let wanted = slower.of(wanted, fastest);
        let decimals = decimals(law, wanted);
        let steps = wanted / step(law, wanted);
        let whole = if (steps - steps.round()).abs() <= 1e-9 * steps {
            // On the grid but for the arithmetic.
            steps.round()
        } else {
            slower.whole(steps)
        };
        // A whole number times a power of ten: exact, also where a millionth is the last digit that f64 has.
        let millionths = whole * MILLIONTHS[usize::from(decimals)];
        if wanted == slower.endless() || whole < 1.0 || millionths > law.greatest() * 1e6 + 0.5 {
            return Err(OutOfFormat(wanted));
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number up to 4·10^15")]
        let millionths = millionths as u64;
        Ok(Self { millionths, decimals })
    }

    /// True where no word is faster.
    #[must_use]
    pub const fn is_fastest(self, law: FeedLaw) -> bool {
        match law {
            FeedLaw::Seconds => self.millionths == 100,
            FeedLaw::Resultant => self.millionths == 99_999_999_000,
            FeedLaw::InverseTime => self.millionths == 4_000_000_000_000_000,
        }
    }

    /// The number as it is written: mm/min, seconds or 1/min, by the control's law.
    #[must_use]
    pub fn value(self) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "a whole number up to 4·10^15")]
        let millionths = self.millionths as f64;
        millionths / 1e6
    }

    /// Appends the number with its decimals.
    pub fn write(self, text: &mut String) {
        let (whole, mut part) = (self.millionths / 1_000_000, self.millionths % 1_000_000);
        push_whole(text, u32::try_from(whole).unwrap_or(u32::MAX));
        text.push('.');
        for _ in 0..self.decimals {
            let digit = u8::try_from(part / 100_000).unwrap_or(0);
            text.push(char::from(b'0' + digit));
            part = part % 100_000 * 10;
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn written(law: FeedLaw, seconds: f64, resultant: f64) -> String {
        let mut text = String::new();
        FeedWord::lasting(law, seconds, resultant).unwrap().write(&mut text);
        text
    }

    #[test]
    fn each_law_has_its_decimals_and_rounds_to_the_slower_side() {
        for (law, seconds, resultant, text) in [
            (FeedLaw::Seconds, 0.0601, 1.0, "0.0601"),
            (FeedLaw::Seconds, 0.060_11, 1.0, "0.0602"),
            (FeedLaw::Seconds, 0.06, 1.0, "0.0600"),
            (FeedLaw::Seconds, 0.000_01, 1.0, "0.0001"),
            (FeedLaw::Seconds, 0.0, 0.0, "0.0001"),
            (FeedLaw::InverseTime, 7.0, 1.0, "8.571"),
            (FeedLaw::InverseTime, 70.0, 1.0, "0.857142"),
            (FeedLaw::InverseTime, 60.0, 1.0, "1.000"),
            (FeedLaw::InverseTime, 0.000_207_4, 1.0, "289296.046"),
            (FeedLaw::InverseTime, 0.0, 1.0, "4000000000.000"),
            (FeedLaw::InverseTime, 60.0 / 3_257_082_692.18, 1.0, "3257082692.180"),
            (FeedLaw::Resultant, 7.0, 1.0, "8.571"),
            (FeedLaw::Resultant, 0.6, 10.0, "1000.000"),
            (FeedLaw::Resultant, 0.0, 0.0, "99999.999"),
        ] {
            assert_eq!(written(law, seconds, resultant), text, "{law:?} {seconds}");
        }
    }

    #[test]
    fn a_short_block_has_the_number_that_its_text_says() {
        let word = FeedWord::lasting(FeedLaw::InverseTime, 60.0 / 3_257_082_692.18, 1.0).unwrap();
        let mut text = String::new();
        word.write(&mut text);
        assert_eq!(text.parse::<f64>().unwrap().to_bits(), word.value().to_bits());
    }

    #[test]
    fn a_move_slower_than_any_word_is_refused() {
        assert!(FeedWord::lasting(FeedLaw::Seconds, 100_000.0, 1.0).is_err());
        assert!(FeedWord::lasting(FeedLaw::InverseTime, 1e9, 1.0).is_err());
        assert!(FeedWord::lasting(FeedLaw::Resultant, 1e9, 1.0).is_err());
        assert!(FeedWord::lasting(FeedLaw::Resultant, f64::INFINITY, 1.0).is_err());
    }

    proptest! {
        #[test]
        fn no_word_is_faster_than_asked_nor_slower_by_more_than_a_step(
            power in -8.0..4.0_f64, digits in 1.0..10.0_f64, resultant in 0.001..500.0_f64,
        ) {
            let seconds = digits * libm::pow(10.0, power);
            for law in [FeedLaw::Resultant, FeedLaw::Seconds, FeedLaw::InverseTime] {
                let Ok(word) = FeedWord::lasting(law, seconds, resultant) else { continue };
                let takes = law.seconds(word.value(), resultant);
                prop_assert!(takes >= seconds * (1.0 - 2e-9), "{law:?} {seconds} {takes}");
                let (wanted, found) = (law.word(seconds, resultant), word.value());
                prop_assert!(word.is_fastest(law) || (wanted - found).abs() <= step(law, wanted) * (1.0 + 1e-6));
                let mut text = String::new();
                word.write(&mut text);
                prop_assert_eq!(text.parse::<f64>().unwrap(), found);
            }
        }
    }
}
