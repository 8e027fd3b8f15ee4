//! Words of a block and how their numbers are written.

use crate::gcode::digits::{digit, push_whole};
use crate::gcode::feed_word::FeedWord;
use crate::number::grid::Milli;

/// How dimension words are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NumberFormat {
    /// Up to three decimals without trailing zeros, as the published programs: `X5.67`, `X0`.
    Trimmed,
    /// Three decimals always: `X5.670`, `X0.000`. On some controls `X1` is 0.001 mm.
    Fixed,
    /// Six decimals always, as the published program of a pipe; a number without a point stays as it is. Only lines that
    /// stand as they are have it.
    Six,
}

/// Coordinates that follow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Distance {
    /// Coordinates from the work zero (G90).
    Absolute,
    /// Increments from where the tool is (G91).
    Incremental,
}

/// The number of a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Number {
    /// A whole number without point: codes, tools, speeds.
    Whole(u32),
    /// A dimension or feed on the output grid.
    Size(Milli),
    /// The feed of a move, with the decimals of its law.
    Feed(FeedWord),
}

/// An address letter with its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word {
    /// The address, a capital letter.
    pub letter: char,
    /// The number behind it.
    pub number: Number,
}

impl Word {
    /// A code, tool number or the like.
    #[must_use]
    pub const fn whole(letter: char, number: u32) -> Self {
        Self { letter, number: Number::Whole(number) }
    }

    /// A dimension or feed.
    #[must_use]
    pub const fn size(letter: char, size: Milli) -> Self {
        Self { letter, number: Number::Size(size) }
    }

    /// The feed of a move.
    #[must_use]
    pub const fn feed(feed: FeedWord) -> Self {
        Self { letter: 'F', number: Number::Feed(feed) }
    }

    /// Appends the word to a block.
    pub fn write(self, format: NumberFormat, block: &mut String) {
        if !block.is_empty() {
            block.push(' ');
        }
        block.push(self.letter);
        match (self.number, format) {
            (Number::Whole(number), _) => push_whole(block, number),
            (Number::Feed(feed), _) => feed.write(block),
            (Number::Size(size), NumberFormat::Trimmed) => push_size(block, size, true),
            (Number::Size(size), NumberFormat::Fixed | NumberFormat::Six) => push_size(block, size, false),
        }
    }
}

/// A block that takes the tool away, as `G0 G53 Z0`; no words where there is none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Retract(pub Vec<Word>);

impl Retract {
    /// The axes that it moves, each with the position that is programmed, mm.
    pub fn sizes(&self) -> impl Iterator<Item = (char, f64)> {
        self.0.iter().filter_map(|word| match word.number {
            Number::Size(size) => Some((word.letter, size.value())),
            _ => None,
        })
    }

    /// Z as it is programmed, mm; `None` where it does not move.
    #[must_use]
    pub fn z(&self) -> Option<f64> {
        self.sizes().find(|&(axis, _)| axis == 'Z').map(|(_, z)| z)
    }

    /// True where its positions count from machine zero, with G53: where they are in program coordinates nobody knows.
    #[must_use]
    pub fn by_machine(&self) -> bool {
        self.0.contains(&Word::whole('G', 53))
    }
}

/// Reads codes as `M3 M11 M13`, that is letters G or M with whole numbers separated by blanks.
///
/// `None` where anything else stands there.
#[must_use]
pub fn codes(text: &str) -> Option<Vec<Word>> {
    text.split_whitespace()
        .map(|code| {
            let mut letters = code.chars();
            let letter = letters.next().filter(|letter| matches!(letter, 'G' | 'M'))?;
            let digits = letters.as_str();
            let whole = !digits.is_empty() && digits.len() <= 4 && digits.bytes().all(|digit| digit.is_ascii_digit());
            if whole { digits.parse().ok().map(|number| Word::whole(letter, number)) } else { None }
        })
        .collect()
}

/// Reads a block that moves linear axes, as `G0 G53 Z0`: codes as [`codes`] reads them, and X, Y and Z with numbers of the
/// output grid. In the order that controls ask for: G codes, axes, M codes; each axis once.
///
/// `None` where anything else stands there.
#[must_use]
pub fn block(text: &str) -> Option<Vec<Word>> {
    let words: Vec<Word> = text.split_whitespace().map(word).collect::<Option<_>>()?;
    let place = |word: &Word| match word.letter {
        'G' => 0,
        'X' => 1,
        'Y' => 2,
        'Z' => 3,
        _ => 4,
    };
    let ordered = words.windows(2).all(|pair| {
        let places = [place(&pair[0]), place(&pair[1])];
        places[0] < places[1] || places[0] == places[1] && matches!(places[0], 0 | 4)
    });
    ordered.then_some(words)
}

/// A word of a [`block`].
#[must_use]
pub fn word(text: &str) -> Option<Word> {
    let letter = text.chars().next()?;
    if !matches!(letter, 'X' | 'Y' | 'Z') {
        return codes(text)?.first().copied();
    }
    let signed = text.get(1..)?;
    let number = signed.strip_prefix('-').unwrap_or(signed);
    let (whole, decimals) = number.split_once('.').unwrap_or((number, "0"));
    let digits =
        |text: &str, most| (1..=most).contains(&text.len()) && text.bytes().all(|digit| digit.is_ascii_digit());
    if !digits(whole, 5) || !digits(decimals, 3) {
        return None;
    }
    Some(Word::size(letter, Milli::round(signed.parse().ok()?).ok()?))
}

/// Appends a number of the output grid, with three decimals or without trailing zeros. Zero has no sign.
fn push_size(text: &mut String, size: Milli, trimmed: bool) {
    if size < Milli::ZERO {
        text.push('-');
    }
    let thousandths = size.thousandths().unsigned_abs();
    push_whole(text, thousandths / 1000);
    let part = thousandths % 1000;
    let decimals = [digit(part / 100), digit(part / 10 % 10), digit(part % 10)];
    let shown = match decimals {
        _ if !trimmed => 3,
        [b'0', b'0', b'0'] => 0,
        [_, b'0', b'0'] => 1,
        [_, _, b'0'] => 2,
        _ => 3,
    };
    if shown > 0 {
        text.push('.');
        for &digit in &decimals[..shown] {
            text.push(char::from(digit));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(value: f64, format: NumberFormat) -> String {
        let mut block = String::new();
        Word::size('X', Milli::round(value).unwrap()).write(format, &mut block);
        block
    }

    #[test]
    fn trimmed_numbers_have_no_trailing_zeros_and_no_negative_zero() {
        for (value, text) in [
            (0.0, "X0"),
            (-0.0, "X0"),
            (-0.0004, "X0"),
            (-0.042, "X-0.042"),
            (5.67, "X5.67"),
            (-13.3333, "X-13.333"),
            (90.0, "X90"),
            (8.9, "X8.9"),
            (1e-7, "X0"),
            (0.0005, "X0.001"),
            (100.05, "X100.05"),
            (99_999.999, "X99999.999"),
        ] {
            assert_eq!(written(value, NumberFormat::Trimmed), text);
        }
    }

    #[test]
    fn fixed_numbers_always_have_a_point_and_three_decimals() {
        for (value, text) in
            [(0.0, "X0.000"), (-0.0001, "X0.000"), (-0.042, "X-0.042"), (90.0, "X90.000"), (1e-9, "X0.000")]
        {
            assert_eq!(written(value, NumberFormat::Fixed), text);
        }
    }

    #[test]
    fn codes_are_letters_g_or_m_with_whole_numbers() {
        assert_eq!(codes("M3 M11  M13"), Some(vec![Word::whole('M', 3), Word::whole('M', 11), Word::whole('M', 13)]));
        for bad in ["X5", "M", "M3.5", "M-3", "M3;", "M99999", "m3", "M+3"] {
            assert_eq!(codes(bad), None, "{bad}");
        }
    }

    #[test]
    fn a_block_that_takes_the_tool_away_turns_nothing() {
        let Z = |thousandths| Word::size('Z', Milli::new(thousandths));
        assert_eq!(block("G0 G53 Z0"), Some(vec![Word::whole('G', 0), Word::whole('G', 53), Z(0)]));
        assert_eq!(block("G0 Z-12.5 M9"), Some(vec![Word::whole('G', 0), Z(-12_500), Word::whole('M', 9)]));
        assert_eq!(block(""), Some(Vec::new()));
        for bad in ["G0 B0", "G0 C90", "Z0 G0", "G0 Z0 Z1", "G0 Y0 X0", "Z1.2345", "Z1e3", "Z+1", "Z.5", "Z", "T1"] {
            assert_eq!(block(bad), None, "{bad}");
        }
    }
}
