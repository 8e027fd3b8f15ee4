//! Words typed into cells: choices and machine codes.

use crate::gcode::word;
use crate::parameter::Choice;
use crate::text::Text;

/// A word without capitals, accents and blanks around it.
#[must_use]
pub fn fold(word: &str) -> String {
    word.trim()
        .to_lowercase()
        .chars()
        .map(|character| match character {
            'á' => 'a',
            'é' => 'e',
            'í' => 'i',
            'ó' => 'o',
            'ú' | 'ü' => 'u',
            'ñ' => 'n',
            other => other,
        })
        .collect()
}

/// The key of the choice that a word names, by its key, its label in either language or what it was once called.
///
/// # Errors
/// The label of the choice that was probably meant, where one is alike but for blanks and signs.
pub fn choose(choices: &'static [Choice], word: &str) -> Result<&'static str, Option<&'static Text>> {
    let wanted = fold(word);
    if let Some(choice) = choices.iter().find(|choice| choice.words().any(|one| fold(one) == wanted)) {
        return Ok(choice.key);
    }
    let letters = |text: &str| fold(text).chars().filter(|one| one.is_alphanumeric()).collect::<String>();
    let wanted = letters(word);
    let near = choices.iter().find(|choice| choice.words().any(|one| letters(one) == wanted));
    Err(near.map(|choice| &choice.label))
}

/// A block that takes the tool away, in capitals with one blank between its words.
///
/// # Errors
/// The first word that is neither a code nor X, Y or Z with a number; where each is one, the whole, for its order is wrong.
pub fn block(text: &str) -> Result<String, String> {
    let words: Vec<String> = text.split_whitespace().map(str::to_ascii_uppercase).collect();
    let joined = words.join(" ");
    match words.into_iter().find(|one| word::word(one).is_none()) {
        Some(wrong) => Err(wrong),
        None if word::block(&joined).is_none() => Err(joined),
        None => Ok(joined),
    }
}

/// Machine codes in capitals with one blank between them.
///
/// # Errors
/// The first word that is not the letter G or M with a whole number of one to four digits.
pub fn codes(text: &str) -> Result<String, String> {
    let codes: Vec<String> = text.split_whitespace().map(str::to_ascii_uppercase).collect();
    let well_formed = |code: &str| {
        let digits = code.strip_prefix(['G', 'M']).unwrap_or_default();
        (1..=4).contains(&digits.len()) && digits.bytes().all(|byte| byte.is_ascii_digit())
    };
    match codes.iter().find(|code| !well_formed(code)) {
        Some(wrong) => Err(wrong.clone()),
        None => Ok(codes.join(" ")),
    }
}
