//! The characters of a line as the control sees them: blanks and comments passed over, letters alike in both cases.

use crate::gcode::control::Comments;
use crate::gcode::interpreter::block_number;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::rules::lexis::{
    BlockAfterEnd, Comma, CommentInWord, CommentNested, CommentNotOpened, CommentOpen, EdgeNotSupported, Exponent,
    HighLevel, LetterForZero, NameEmpty, NameOpen, NoNumber, Strange, TooGreat, TwoPoints,
};
use crate::text::{Text, t};

/// A place in a line.
#[derive(Debug)]
pub(super) struct Cursor<'l> {
    line: &'l [u8],
    at: usize,
    parentheses: bool,
    semicolon: bool,
    /// The column of a number with blanks inside, if there is one.
    pub(super) parted: Option<usize>,
    /// An E behind a number begins a word, as on a control whose numbers have no exponents.
    pub(super) e_words: bool,
    /// The column of the first E that stands behind a number without a blank, as an exponent would.
    pub(super) glued: Option<usize>,
    /// How deep the expression in hand is nested.
    pub(super) depth: usize,
}

impl<'l> Cursor<'l> {
    /// The beginning of a line whose comments have been checked by [`comments`].
    pub(super) const fn new(line: &'l [u8], comments: Comments) -> Self {
        Self {
            line,
            at: 0,
            parentheses: comments.in_parentheses(),
            semicolon: true,
            parted: None,
            e_words: false,
            glued: None,
            depth: 0,
        }
    }

    /// The column of the next character, counted from 0.
    pub(super) const fn column(&self) -> usize {
        self.at
    }

    /// The text from a column up to here, in capitals.
    pub(super) fn text_from(&self, column: usize) -> String {
        let text = self.line.get(column..self.at).unwrap_or_default();
        String::from_utf8_lossy(text.trim_ascii()).to_uppercase()
    }

    /// The next character that counts, in lower case, without passing it; 0 at the end of the block, and of a NUL 1, which
    /// no block may hold either.
    #[inline]
    pub(super) fn peek(&mut self) -> u8 {
        loop {
            match self.line.get(self.at) {
                None => return 0,
                Some(b' ' | b'\t') => self.at += 1,
                Some(b'(') if self.parentheses => {
                    let close = memchr::memchr(b')', &self.line[self.at..]);
                    self.at = close.map_or(self.line.len(), |close| self.at + close + 1);
                }
                Some(b';') if self.semicolon => {
                    self.at = self.line.len();
                    return 0;
                }
                Some(0) => return 1,
                Some(character) => return character.to_ascii_lowercase(),
            }
        }
    }

    /// True where a macro's variable or word is next, of Fanuc's custom macros.
    pub(super) fn macro_word(&mut self) -> bool {
        self.next_macro().is_some()
    }

    fn next_macro(&mut self) -> Option<&'static str> {
        const WORDS: [&str; 7] = ["#", "IF", "GOTO", "WHILE", "THEN", "DO", "END"];
        self.peek();
        let rest = self.line.get(self.at..).unwrap_or_default();
        let next = |word: &&str| rest.get(..word.len()).is_some_and(|next| next.eq_ignore_ascii_case(word.as_bytes()));
        WORDS.into_iter().find(next)
    }

    /// The first word of a statement of a macro language, where one is next: no word of a block has two letters.
    pub(super) fn macro_statement(&mut self) -> Option<&'static str> {
        let first = self.peek();
        self.line.get(self.at + 1).filter(|next| first.is_ascii_alphabetic() && next.is_ascii_alphabetic())?;
        self.next_macro()
    }

    /// What stands in place of a number on a control whose parameters are P with a number and whose variables are V with names behind
    /// points; the cursor stands behind the letter of the word and a sign.
    pub(super) fn parameter(&mut self) -> Option<Text> {
        let next = self.peek();
        let behind = |places: usize| self.line.get(self.at + places).copied().unwrap_or(0);
        let letter = self.line.get(..self.at).unwrap_or_default().trim_ascii_end().last();
        match next {
            b'p' if behind(1).is_ascii_digit() => Some(t("parámetro (P…)", "parameter (P…)")),
            b'v' if behind(1) == b'.' => Some(t("variable (V.…)", "variable (V.…)")),
            b'.' if behind(1).is_ascii_alphabetic()
                && letter.is_some_and(|letter| letter.eq_ignore_ascii_case(&b'v')) =>
            {
                Some(t("variable (V.…)", "variable (V.…)"))
            }
            _ => None,
        }
    }

    /// True where the letter in hand stands twice, as LL of a call of a local subroutine.
    pub(super) fn doubled(&self) -> bool {
        let letter = self.line.get(self.at).copied().unwrap_or(0);
        self.line.get(self.at + 1).is_some_and(|next| next.eq_ignore_ascii_case(&letter))
    }

    /// True where the character in hand stands right behind a digit or a decimal point.
    pub(super) fn behind_number(&self) -> bool {
        let before = self.at.checked_sub(1).and_then(|before| self.line.get(before));
        before.is_some_and(|&before| before.is_ascii_digit() || before == b'.')
    }

    /// Passes `,C` or `,R` if it stands next, and says whether it is `,R`; passes nothing else.
    pub(super) fn edge(&mut self) -> Option<bool> {
        let comma = self.at;
        self.accept(b',');
        let round = match self.peek() {
            b'c' => false,
            b'r' => true,
            _ => {
                self.at = comma;
                return None;
            }
        };
        self.pass();
        Some(round)
    }

    /// True where the letter in hand has a whole number and ends the block, but for a comment.
    pub(super) fn ends_block(&self) -> bool {
        let rest = self.line.get(self.at + 1..).unwrap_or_default().trim_ascii_start();
        let digits = rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
        let behind = rest[digits..].trim_ascii_start();
        digits > 0 && behind.first().is_none_or(|byte| b";(".contains(byte))
    }

    /// The number without a sign right behind the letter in hand, as it stands there; empty if there is none.
    pub(super) fn size_behind(&self) -> &'l str {
        let rest = self.line.get(self.at + 1..).unwrap_or_default();
        let end = rest.iter().position(|byte| !byte.is_ascii_digit() && *byte != b'.').unwrap_or(rest.len());
        std::str::from_utf8(&rest[..end])
            .ok()
            .filter(|size| size.contains(|digit: char| digit.is_ascii_digit()))
            .unwrap_or_default()
    }

    /// Refuses a comment here: it would part a word from its number, which controls read in more than one way.
    pub(super) fn no_comment(&self) -> Result<()> {
        let mut column = self.at;
        while let Some(b' ' | b'\t') = self.line.get(column) {
            column += 1;
        }
        if self.parentheses && self.line.get(column) == Some(&b'(') { Err(comment_inside(column)) } else { Ok(()) }
    }

    /// True where the line is not too long for a control, and no comment of it is nested, left open or closed without being open.
    pub(super) fn line_fits(&self, longest: usize, form: Comments) -> bool {
        if self.line.len() > longest {
            return false;
        }
        memchr::memchr3(b'(', b')', b';', self.line).is_none() || comments(self.line, form).is_ok()
    }

    /// Passes a whole number in brackets and gives it; passes nothing of any other expression.
    pub(super) fn bracketed_number(&mut self) -> Option<u32> {
        let start = self.at;
        let number = if self.accept(b'[') { block_number(self).ok() } else { None };
        let found = number.filter(|_| self.accept(b']'));
        if found.is_none() {
            self.at = start;
        }
        found
    }

    /// The column of the first comment in parentheses before a column.
    pub(super) fn comment_before(&self, column: usize) -> Option<usize> {
        if self.parentheses { memchr::memchr(b'(', self.line.get(..column)?) } else { None }
    }

    /// Passes the character that [`Cursor::peek`] has shown.
    pub(super) const fn pass(&mut self) {
        self.at += 1;
    }

    /// Passes a character if it is the next one.
    pub(super) fn accept(&mut self, wanted: u8) -> bool {
        let found = self.peek() == wanted;
        self.at += usize::from(found);
        found
    }

    /// Passes `/` if it stands next, with the number of its switch, as Fanuc and Fagor have them: 0 where there is none.
    pub(super) fn accept_delete(&mut self, numbered: bool) -> Option<u8> {
        if !self.accept(b'/') {
            return None;
        }
        match self.peek() {
            digit @ b'1'..=b'9' if numbered => {
                self.pass();
                Some(digit - b'0')
            }
            _ => Some(0),
        }
    }

    /// Passes a word of lower-case letters if it stands next.
    pub(super) fn accept_word(&mut self, word: &str) -> bool {
        let start = self.at;
        for wanted in word.bytes() {
            if !self.accept(wanted) {
                self.at = start;
                return false;
            }
        }
        true
    }

    /// A decimal number without a sign: digits with at most one point among them.
    pub(super) fn number(&mut self) -> Result<Decimal> {
        self.short_number().map_or_else(|| self.any_number(), Ok)
    }

    /// A number of at most 15 digits that the next word or the end of the line follows, as nearly all are; `None`, without
    /// passing anything, for any other.
    fn short_number(&mut self) -> Option<Decimal> {
        let bytes = self.line.get(self.at..)?;
        let digits = |from: usize, mantissa: &mut u64| {
            let mut at = from;
            while let Some(digit) = bytes.get(at).map(|byte| byte.wrapping_sub(b'0'))
                && digit < 10
                && at < 16
            {
                *mantissa = *mantissa * 10 + u64::from(digit);
                at += 1;
            }
            at
        };
        let mut mantissa = 0;
        let whole = digits(0, &mut mantissa);
        let point = bytes.get(whole) == Some(&b'.');
        let end = if point { digits(whole + 1, &mut mantissa) } else { whole };
        let decimals = end - whole - usize::from(point);
        if whole + decimals == 0 || end >= 16 {
            return None;
        }
        // A blank may stand inside a number: look behind it.
        let next = bytes.get(end..)?.iter().find(|&&byte| byte != b' ').copied();
        if matches!(next, Some(b'0'..=b'9' | b'.' | b'\t' | b'(' | b'e' | b'E')) {
            return None;
        }
        self.at += end;
        Some(Decimal { value: decimal(mantissa, decimals), point, decimals })
    }

    fn any_number(&mut self) -> Result<Decimal> {
        let start = self.at;
        let (mut mantissa, mut digits, mut decimals, mut point, mut long) = (0_u64, 0_usize, 0_usize, false, false);
        loop {
            match self.line.get(self.at) {
                Some(&digit @ b'0'..=b'9') => {
                    digits += 1;
                    decimals += usize::from(point);
                    if mantissa < 1 << 52 {
                        mantissa = mantissa * 10 + u64::from(digit - b'0');
                    } else {
                        long = true;
                    }
                }
                Some(b'.') if point => return Err(two_points(self.at)),
                Some(b'.') => point = true,
                // Blanks do not part a number; whether one goes on is rarely asked.
                Some(b' ' | b'\t' | b'(') => {
                    let behind = self.at;
                    let goes_on = matches!(self.peek(), b'0'..=b'9' | b'.');
                    let commented = self.line[behind..self.at].iter().position(|&byte| byte == b'(');
                    if let (true, Some(comment)) = (goes_on, commented) {
                        return Err(comment_inside(behind + comment));
                    }
                    if !goes_on {
                        self.at = behind;
                        break;
                    }
                    self.parted = Some(start);
                    continue;
                }
                Some(b'e' | b'E') if self.is_exponent() => {
                    if !self.e_words || self.depth > 0 {
                        return Err(exponent(self.at));
                    }
                    self.glued.get_or_insert(self.at);
                    break;
                }
                _ => break,
            }
            self.at += 1;
        }
        if digits == 0 {
            return Err(self.no_number(start));
        }
        let value = if long || mantissa >= 1 << 53 || decimals > 22 {
            // More digits than a number can hold: read them all, rounded once.
            let text: String = self.line[start..self.at]
                .iter()
                .filter(|byte| byte.is_ascii_digit() || **byte == b'.')
                .map(|&byte| char::from(byte))
                .collect();
            let value: f64 = text.parse().map_err(|_| self.no_number(start))?;
            if !value.is_finite() {
                return Err(too_great(start));
            }
            value
        } else {
            decimal(mantissa, decimals)
        };
        Ok(Decimal { value, point, decimals })
    }

    fn is_exponent(&self) -> bool {
        match self.line.get(self.at + 1) {
            Some(b'0'..=b'9') => true,
            Some(b'+' | b'-') => self.line.get(self.at + 2).is_some_and(u8::is_ascii_digit),
            _ => false,
        }
    }

    /// The text inside `<` and `>`, in lower case and without blanks; the cursor stands on `<`.
    pub(super) fn name(&mut self) -> Result<String> {
        let start = self.at;
        self.pass();
        let mut name = String::new();
        loop {
            match self.peek() {
                b'>' => {
                    self.pass();
                    break;
                }
                0 => {
                    return Err(Refused::of(&NameOpen {}, &[start]));
                }
                character if character.is_ascii_graphic() => {
                    name.push(char::from(character));
                    self.pass();
                }
                character => return Err(strange(self.line, self.at, character)),
            }
        }
        if name.is_empty() {
            return Err(Refused::of(&NameEmpty {}, &[start]));
        }
        Ok(name)
    }

    /// The refusal of what stands at a column in place of a number.
    pub(super) fn no_number(&self, column: usize) -> Box<Refused> {
        match self.line.get(column) {
            Some(b'o' | b'O') => letter_for_zero(column),
            _ => Refused::of(&NoNumber {}, &[column]),
        }
    }

    /// The letter and the digits before the character in hand, in capitals; `None` where it stands behind anything else.
    pub(super) fn name_with_digit(&self) -> Option<String> {
        let before = self.line.get(..self.at)?.trim_ascii_end();
        let digits = before.iter().rev().take_while(|byte| byte.is_ascii_digit()).count();
        let letter = before.len().checked_sub(digits + 1)?;
        let named = digits > 0 && before.get(letter).is_some_and(u8::is_ascii_alphabetic);
        named.then(|| String::from_utf8_lossy(&before[letter..]).to_uppercase())
    }

    /// The refusal of the character in hand.
    pub(super) fn refuse_character(&mut self) -> Box<Refused> {
        let character = self.peek();
        strange(self.line, self.at, character)
    }
}

/// A number as it stands in a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Decimal {
    pub(super) value: f64,
    /// It has a decimal point.
    pub(super) point: bool,
    /// How many digits stand behind it.
    pub(super) decimals: usize,
}

/// A whole number below 2^53 divided by a power of ten up to 10^22: both are exact, so that the quotient is the double
/// nearest to the decimal number (Clinger, "How to read floating point numbers accurately", 1990).
fn decimal(mantissa: u64, decimals: usize) -> f64 {
    const POWERS: [f64; 23] = [
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19,
        1e20, 1e21, 1e22,
    ];
    #[expect(clippy::cast_precision_loss, reason = "below 2^53")]
    let whole = mantissa as f64;
    POWERS.get(decimals).map_or(f64::NAN, |power| whole / power)
}

/// The comments of a line, each with its column; refuses what is nested, unclosed or no text.
#[deny(clippy::wildcard_enum_match_arm)]
pub(super) fn comments(line: &[u8], form: Comments) -> Result<Vec<(usize, &[u8])>> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(next) = line.get(at..).and_then(|rest| memchr::memchr3(b'(', b')', b';', rest)) {
        let start = at + next;
        match line[start] {
            b';' => match form {
                Comments::Parentheses if reads_as_words(&line[start + 1..]) => {
                    return Err(Refused::of(&BlockAfterEnd {}, &[start]));
                }
                Comments::ParenthesesAndSemicolon | Comments::Either | Comments::Semicolon | Comments::Parentheses => {
                    found.push((start, &line[start + 1..]));
                    break;
                }
            },
            b'(' => match form {
                Comments::Semicolon => return Err(Refused::of(&HighLevel {}, &[start])),
                Comments::ParenthesesAndSemicolon | Comments::Either | Comments::Parentheses => {
                    let Some(length) = memchr::memchr2(b'(', b')', &line[start + 1..]) else {
                        return Err(Refused::of(&CommentOpen {}, &[start]));
                    };
                    let end = start + 1 + length;
                    if line[end] == b'(' {
                        return Err(Refused::of(&CommentNested {}, &[start, end]));
                    }
                    found.push((start, &line[start + 1..end]));
                    at = end + 1;
                }
            },
            _ => return Err(Refused::of(&CommentNotOpened {}, &[start])),
        }
    }
    match found.iter().find_map(|(start, text)| memchr::memchr(0, text).map(|nul| start + 1 + nul)) {
        Some(nul) => Err(strange(line, nul, 0)),
        None => Ok(found),
    }
}

/// The words of a line as the control sees them, in lower case: without comments, blanks and block number. Empty for a line of comments
/// alone, and for one with the program's name, behind `%` or O.
#[must_use]
pub fn bare(line: &str, form: Comments) -> String {
    let mut cursor = Cursor::new(line.as_bytes(), form);
    let mut words = Vec::new();
    while let letter @ 1.. = cursor.peek() {
        words.push(letter);
        cursor.pass();
    }
    let words = String::from_utf8_lossy(&words).into_owned();
    let digits = |text: &str| text.bytes().take_while(|byte| byte.is_ascii_digit() || *byte == b'.').count();
    if words.starts_with('%') || words.strip_prefix('o').is_some_and(|name| digits(name) == name.len()) {
        return String::new();
    }
    // A block that may be passed over has its number behind the slash.
    let slash = words.strip_prefix('/').map_or(0, |behind| 1 + digits(behind));
    let (before, behind) = words.split_at(slash);
    match behind.strip_prefix('n').map(|number| (number, digits(number))) {
        Some((number, digits)) if digits > 0 => format!("{before}{}", &number[digits..]),
        _ => words,
    }
}

/// True where a text reads as a block: words all through, up to a comment, one of them more than its number.
fn reads_as_words(text: &[u8]) -> bool {
    let end = memchr::memchr2(b'(', b';', text).unwrap_or(text.len());
    let mut rest = text[..end].trim_ascii();
    let mut words = false;
    while let [letter, tail @ ..] = rest {
        let tail = tail.trim_ascii_start();
        let number = tail.iter().take_while(|byte| byte.is_ascii_digit() || b"+-.".contains(byte)).count();
        if !letter.is_ascii_alphabetic() || !tail[..number].iter().any(u8::is_ascii_digit) {
            return false;
        }
        words |= !letter.eq_ignore_ascii_case(&b'N');
        rest = tail[number..].trim_ascii_start();
    }
    words
}

/// A character that no block may hold, by its name.
fn strange(line: &[u8], column: usize, character: u8) -> Box<Refused> {
    if character == b',' {
        let next = line.get(column + 1).map(u8::to_ascii_uppercase);
        if let Some(letter) = next.filter(|letter| b"CRA".contains(letter)) {
            let name = char::from(letter);
            return Refused::of(&EdgeNotSupported { edge: name }, &[column]);
        }
        return Refused::of(&Comma {}, &[column]);
    }
    let rest = line.get(column..).unwrap_or_default();
    let text = rest.utf8_chunks().next().map_or("", |chunk| chunk.valid());
    let name = match text.chars().next() {
        Some('\u{2212}') => "U+2212 (minus sign)".to_owned(),
        Some('\u{00a0}') => "U+00A0 (no-break space)".to_owned(),
        Some('\u{feff}') => "U+FEFF (byte order mark)".to_owned(),
        Some('\0') => "NUL".to_owned(),
        Some(letter) if letter.is_ascii_graphic() => format!("'{letter}'"),
        Some(letter) => format!("U+{:04X}", u32::from(letter)),
        None => format!("byte 0x{:02X}", rest.first().copied().unwrap_or(character)),
    };
    Refused::of(&Strange { character: name }, &[column])
}

/// The letter O stands where a digit should.
pub(super) fn letter_for_zero(column: usize) -> Box<Refused> {
    Refused::of(&LetterForZero {}, &[column])
}

fn too_great(column: usize) -> Box<Refused> {
    Refused::of(&TooGreat {}, &[column])
}

fn comment_inside(column: usize) -> Box<Refused> {
    Refused::of(&CommentInWord {}, &[column])
}

fn two_points(column: usize) -> Box<Refused> {
    Refused::of(&TwoPoints {}, &[column])
}

/// An exponent, which no control's numbers have.
pub(super) fn exponent(column: usize) -> Box<Refused> {
    Refused::of(&Exponent {}, &[column])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_the_same_whatever_number_comment_and_name_stand_beside() {
        let words = |line| bare(line, Comments::Parentheses);
        for line in ["G1 X5 M8", "N10 G1X5M8", "n0020 g1 x5 (a) M8", " N5.1 G1 X 5 M8 (b)"] {
            assert_eq!(words(line), "g1x5m8", "{line}");
        }
        assert_eq!([words("/N115 G0 X1"), words("/N116 G0 X1"), words("/2 N7 G0 X1")], ["/g0x1", "/g0x1", "/2g0x1"]);
        for line in ["(a)", "%", "%0001-ROUGH,MX--,", "O0001", "O0007 (SHAFT)", ""] {
            assert_eq!(words(line), "", "{line}");
        }
        assert_eq!([words("o1 while [#1 LT 3]"), words("N"), words("M98 P5")], ["o1while[#1lt3]", "n", "m98p5"]);
    }
}
