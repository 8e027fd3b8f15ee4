//! Sets of address letters.

/// A set of the letters A to Z, one bit each.
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
