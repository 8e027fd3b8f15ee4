//! Outputs in the form in which they are compared: without the sums of other files.

use std::collections::BTreeMap;

use crate::golden::hexadecimal;

/// The SHA-256 sums that may stand in outputs: whole, or in two halves as at the head of a program.
#[derive(Default)]
pub struct Sums(BTreeMap<String, String>);

impl Sums {
    /// Takes a file's sum.
    pub fn take(&mut self, name: &str, bytes: &[u8]) {
        let sum = hexadecimal(bytes);
        let (first, second) = sum.split_at(32);
        for (part, of) in [(first, "first half of the "), (second, "second half of the "), (sum.as_str(), "")] {
            self.0.insert(part.to_owned(), format!("<{of}sum of {name}>"));
        }
    }

    /// The text with each sum replaced by the name of its file.
    pub fn named(&self, text: &[u8]) -> Vec<u8> {
        // Some controls read capitals alone.
        let digit = |byte: &u8| byte.is_ascii_hexdigit();
        let mut plain = Vec::with_capacity(text.len());
        for run in text.chunk_by(|one, next| digit(one) == digit(next)) {
            let name = if matches!(run.len(), 32 | 64) { str::from_utf8(run).ok() } else { None };
            let name = name.and_then(|run| self.0.get(&run.to_lowercase()));
            plain.extend_from_slice(name.map_or(run, |name| name.as_bytes()));
        }
        plain
    }
}
