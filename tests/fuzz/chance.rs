//! Inputs by chance from those that are kept: a fixed seed gives the same ones on every machine.

/// Steele, Lea and Flood's SplitMix64 (OOPSLA 2014): small, and the same for ever.
#[derive(Clone, Debug)]
pub struct Chance(u64);

impl Chance {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// A whole number below `end`, 0 where there is none.
    pub fn below(&mut self, end: usize) -> usize {
        let end = u64::try_from(end).unwrap_or(u64::MAX).max(1);
        usize::try_from(self.next() % end).unwrap_or(0)
    }

    pub fn of<'a, T: ?Sized>(&mut self, list: &[&'a T]) -> &'a T {
        list[self.below(list.len())]
    }
}

/// Numbers as people and machines get them wrong.
const NUMBERS: [&str; 30] = [
    "0",
    "-0",
    "1",
    "-1",
    "2",
    "0.001",
    "-0.0005",
    ".5",
    "5.",
    "90",
    "-270",
    "359.9999",
    "360",
    "99999999999.",
    "1e9",
    "1e999",
    "-1e-320",
    "0.1e",
    "--1",
    "1.2.3",
    "1,5",
    "inf",
    "nan",
    "2147483648",
    "4294967295",
    "18446744073709551616",
    "100000",
    "33.333333333333333333",
    "+7",
    "",
];

/// Changes an input in one to eight places: bytes, lines, numbers, words of the dictionary, a piece of another input.
pub fn changed(seed: &[u8], other: &[u8], words: &[&str], chance: &mut Chance) -> Vec<u8> {
    let mut bytes = seed.to_vec();
    for _ in 0..=chance.below(8) {
        let at = chance.below(bytes.len() + 1);
        match chance.below(12) {
            0 if at < bytes.len() => bytes[at] ^= 1 << chance.below(8),
            1 => {
                let end = (at + 1 + chance.below(12)).min(bytes.len());
                bytes.drain(at..end);
            }
            2 => bytes.truncate(at),
            3..=5 => insert(&mut bytes, at, chance.of(words).as_bytes()),
            6..=8 => number(&mut bytes, at, chance),
            9 => {
                let [from, to] = line(&bytes, at);
                let copy = bytes[from..to].to_vec();
                let into = chance.below(bytes.len() + 1);
                let [into, _] = line(&bytes, into);
                insert(&mut bytes, into, &copy);
            }
            10 => {
                let [from, to] = line(&bytes, at);
                bytes.drain(from..to);
            }
            _ => {
                let from = chance.below(other.len() + 1);
                let to = (from + chance.below(200)).min(other.len());
                insert(&mut bytes, at, &other[from..to]);
            }
        }
    }
    bytes
}

fn insert(bytes: &mut Vec<u8>, at: usize, piece: &[u8]) {
    bytes.splice(at..at, piece.iter().copied());
}

/// Replaces the first number behind a place by another, or by a long one.
fn number(bytes: &mut Vec<u8>, at: usize, chance: &mut Chance) {
    let part_of = |byte: &u8| byte.is_ascii_digit() || *byte == b'.';
    let Some(from) = bytes[at..].iter().position(part_of).map(|behind| at + behind) else { return };
    let to = bytes[from..].iter().position(|byte| !part_of(byte)).map_or(bytes.len(), |behind| from + behind);
    let with = match chance.below(6) {
        0 => "9".repeat(1 + chance.below(400)),
        1 => format!("{:.3}", f64::from(u32::try_from(chance.below(200_000)).unwrap_or(0)) / 1000.0 - 100.0),
        2 => chance.below(100).to_string(),
        _ => chance.of(&NUMBERS).to_owned(),
    };
    bytes.splice(from..to, with.bytes());
}

/// The line that a place stands in, with its end.
fn line(bytes: &[u8], at: usize) -> [usize; 2] {
    let from = bytes[..at].iter().rposition(|byte| *byte == b'\n').map_or(0, |end| end + 1);
    let to = bytes[at..].iter().position(|byte| *byte == b'\n').map_or(bytes.len(), |end| at + end + 1);
    [from, to]
}
