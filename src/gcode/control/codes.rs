//! The letters and G codes that a control knows.

use crate::gcode::code::G;

/// Letters of the alphabet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Letters(u32);

impl Letters {
    /// The capital letters of a text; anything else in it is passed over.
    #[must_use]
    pub const fn of(text: &str) -> Self {
        let bytes = text.as_bytes();
        let (mut mask, mut at) = (0, 0);
        while at < bytes.len() {
            if bytes[at].is_ascii_uppercase() {
                mask |= 1 << (bytes[at] - b'A');
            }
            at += 1;
        }
        Self(mask)
    }

    /// True where a letter, counted from A = 0, is among them.
    #[must_use]
    pub const fn has(self, letter: u8) -> bool {
        letter < 26 && self.0 & (1 << letter) != 0
    }

    /// One bit for each letter, A the lowest.
    #[must_use]
    pub const fn mask(self) -> u32 {
        self.0
    }
}

/// G codes by their number in tenths, below 1000: G54 is 540, G59.3 is 593.
#[derive(Debug)]
pub struct Codes([Option<G>; 1000]);

impl Codes {
    /// The table of codes given by number and tenths.
    #[must_use]
    pub const fn new(list: &[(usize, G)]) -> Self {
        let mut table = [None; 1000];
        let mut at = 0;
        while at < list.len() {
            table[list[at].0] = Some(list[at].1);
            at += 1;
        }
        Self(table)
    }

    /// The meaning of a code, by its number in tenths.
    #[must_use]
    pub fn get(&self, tenths: usize) -> Option<G> {
        self.0.get(tenths).copied().flatten()
    }

    /// The codes of some meaning, by their names.
    #[must_use]
    pub fn names(&self, meaning: G) -> Vec<String> {
        let of = |(tenths, code): (usize, &Option<G>)| (*code == Some(meaning)).then(|| code_name(tenths));
        self.0.iter().enumerate().filter_map(of).collect()
    }

    /// True where a code has some meaning.
    #[must_use]
    pub fn has(&self, meaning: G) -> bool {
        self.0.contains(&Some(meaning))
    }
}

/// The name of a code by its number in tenths.
#[must_use]
pub fn code_name(tenths: usize) -> String {
    match tenths % 10 {
        0 => format!("G{}", tenths / 10),
        tenth => format!("G{}.{tenth}", tenths / 10),
    }
}
