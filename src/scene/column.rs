//! Columns of numbers as base64 of little-endian bytes.

use serde::{Serialize, Serializer};

/// A ten-thousandth of a millimetre or degree: the grid on which lengths are kept.
const GRID: f64 = 1e4;
/// The greatest number that the grid holds.
const GREATEST: f64 = 200_000.0;

/// Lengths or angles: whole numbers of 0.0001, or where one is too great or none of the grid holds it, doubles.
pub(crate) fn numbers<S: Serializer>(values: &[f64], serializer: S) -> Result<S::Ok, S::Error> {
    #[derive(Serialize)]
    enum Column {
        /// 32-bit whole numbers of 0.0001.
        #[serde(rename = "i")]
        Grid(String),
        /// Doubles.
        #[serde(rename = "d")]
        Double(String),
    }
    let bytes = |one: &dyn Fn(&f64) -> Vec<u8>| values.iter().flat_map(one).collect::<Vec<u8>>();
    #[expect(clippy::cast_possible_truncation, reason = "below 2·10⁹")]
    let column = if values.iter().all(|value| value.abs() <= GREATEST) {
        Column::Grid(base64(&bytes(&|value| ((value * GRID).round() as i32).to_le_bytes().to_vec())))
    } else {
        Column::Double(base64(&bytes(&|value| value.to_le_bytes().to_vec())))
    };
    column.serialize(serializer)
}

/// Points, as [`numbers`].
pub(crate) fn points<const N: usize, S: Serializer>(points: &[[f64; N]], serializer: S) -> Result<S::Ok, S::Error> {
    numbers(points.as_flattened(), serializer)
}

/// Whole numbers.
pub(crate) fn wholes<S: Serializer>(values: &[u32], serializer: S) -> Result<S::Ok, S::Error> {
    let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
    serializer.serialize_str(&base64(&bytes))
}

/// Whole numbers below 256.
pub(crate) fn bytes<S: Serializer>(values: &[u8], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&base64(values))
}

/// Single-precision numbers, for what is only drawn or played.
pub(crate) fn singles<S: Serializer>(values: &[f32], serializer: S) -> Result<S::Ok, S::Error> {
    let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
    serializer.serialize_str(&base64(&bytes))
}

/// Directions of length 1, as 16-bit shares of 32,767.
pub(crate) fn directions<S: Serializer>(values: &[[f64; 3]], serializer: S) -> Result<S::Ok, S::Error> {
    #[expect(clippy::cast_possible_truncation, reason = "clamped to 16 bits")]
    let share = |value: &f64| ((value * 32_767.0).round().clamp(-32_767.0, 32_767.0) as i16).to_le_bytes();
    let bytes: Vec<u8> = values.as_flattened().iter().flat_map(share).collect();
    serializer.serialize_str(&base64(&bytes))
}

const ALPHABET: [u8; 64] = *b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// RFC 4648, section 4.
fn base64(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let at = |index: usize| u32::from(chunk.get(index).copied().unwrap_or(0));
        let group = at(0) << 16 | at(1) << 8 | at(2);
        for place in 0..4_u32 {
            let letter = ALPHABET[(group >> (18 - 6 * place) & 63) as usize];
            let there = chunk.len() >= place as usize;
            text.push(if there { char::from(letter) } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_is_that_of_the_standards_test_vectors() {
        for (plain, coded) in
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg=="), ("foobar", "Zm9vYmFy")]
        {
            assert_eq!(base64(plain.as_bytes()), coded);
        }
    }

    #[test]
    fn a_number_beyond_the_grid_makes_a_column_of_doubles() {
        let column = |values: &[f64]| {
            let mut text = Vec::new();
            numbers(values, &mut serde_json::Serializer::new(&mut text)).unwrap();
            String::from_utf8(text).unwrap()
        };
        assert_eq!(column(&[1.0, -0.0001]), r#"{"i":"ECcAAP////8="}"#);
        assert!(column(&[1.0, 1e9]).starts_with(r#"{"d":""#));
        assert!(column(&[f64::NAN]).starts_with(r#"{"d":""#));
    }
}
