//! Outside text made safe to print: no character of it can steer a terminal or reorder a line.

use std::path::Path;

/// The text with every character that is not seen as itself written out, as `\u{1b}`.
///
/// Written out are control characters (line ends and tabs among them), marks that change the direction of reading,
/// characters without width, line and paragraph separators, and what Unicode keeps out of interchange.
#[must_use]
pub fn printable(text: &str) -> String {
    let mut printed = String::with_capacity(text.len());
    for character in text.chars() {
        if hidden(character) {
            printed.extend(character.escape_unicode());
        } else {
            printed.push(character);
        }
    }
    printed
}

/// The beginning of a text, made printable: at most `most` characters of it, with `…` where it goes on.
#[must_use]
pub fn excerpt(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        None => printable(text),
        Some((end, _)) => format!("{}…", printable(text.get(..end).unwrap_or_default())),
    }
}

/// A path, made printable. What is not UTF-8 in it is shown as U+FFFD.
#[must_use]
pub fn printable_path(path: &Path) -> String {
    printable(&path.to_string_lossy())
}

/// True for a character that a terminal does not show as itself.
#[must_use]
pub fn hidden(character: char) -> bool {
    character.is_control()
        || matches!(character,
            '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}' | '\u{200e}' | '\u{200f}'
            | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}'
            | '\u{e0000}'..='\u{e007f}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_of_a_terminal_sequence_or_a_bidirectional_override_is_left() {
        assert_eq!(
            printable("A\u{1b}[31mB\r\n\u{202e}C\u{9b}D\u{7f}"),
            "A\\u{1b}[31mB\\u{d}\\u{a}\\u{202e}C\\u{9b}D\\u{7f}"
        );
    }

    #[test]
    fn letters_of_any_script_stay() {
        assert_eq!(printable("Álabe рабочее 叶轮 ⚙\u{fe0f} 'x'"), "Álabe рабочее 叶轮 ⚙\u{fe0f} 'x'");
    }

    #[test]
    fn an_excerpt_is_cut_between_characters_and_says_so() {
        assert_eq!(excerpt("ñandú", 2), "ña…");
        assert_eq!(excerpt("ñandú", 5), "ñandú");
    }
}
