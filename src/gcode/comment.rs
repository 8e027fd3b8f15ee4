//! Comments: what of a text may reach a program.
//!
//! A part named `A)G0 Z-500 (x` must never become a move. Only A–Z, 0–9, blank, full stop, hyphen and underscore pass;
//! letters with accents lose them, everything else becomes `_`.

/// Most characters of a comment.
pub const LONGEST: usize = 60;

/// The text as a comment may carry it: in capitals, at most [`LONGEST`] characters of the allow-list.
#[must_use]
pub fn clean(text: &str) -> String {
    text.chars().flat_map(char::to_uppercase).take(LONGEST).map(plain).collect()
}

fn plain(letter: char) -> char {
    match letter {
        'A'..='Z' | '0'..='9' | ' ' | '.' | '-' | '_' => letter,
        'Á' | 'À' | 'Â' | 'Ä' => 'A',
        'É' | 'È' | 'Ê' | 'Ë' => 'E',
        'Í' | 'Ì' | 'Î' | 'Ï' => 'I',
        'Ó' | 'Ò' | 'Ô' | 'Ö' => 'O',
        'Ú' | 'Ù' | 'Û' | 'Ü' => 'U',
        'Ñ' => 'N',
        'Ç' => 'C',
        _ => '_',
    }
}

#[cfg(test)]
mod tests {
    use super::clean;

    #[test]
    fn no_text_leaves_its_comment() {
        assert_eq!(clean("A)G0 Z-500 (x"), "A_G0 Z-500 _X");
        assert_eq!(clean("a\nG0 Z-5\r%;\u{2028}M30"), "A_G0 Z-5____M30");
        assert_eq!(clean("MSG, DEBUG,#5"), "MSG_ DEBUG__5");
        assert_eq!(clean("Álabe nº 1: ñandú"), "ALABE N_ 1_ NANDU");
        assert_eq!(clean(&"ß".repeat(100)).len(), 60);
    }
}
