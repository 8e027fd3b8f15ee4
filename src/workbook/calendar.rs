//! Whether a date that was typed as text names a day that no calendar has.
//!
//! A date is free text: it is printed as it was typed. So only what can be read as a date and is one in no order of day and
//! month is wrong; a text of another kind, such as `November 2026`, is not judged.

/// A piece of a text: digits, letters, or what is between them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Piece<'a> {
    Digits(&'a str),
    Letters(&'a str),
    Between(&'a str),
}

/// The months in Spanish and English; the first three letters of each, and more, count as the month.
const MONTHS: [[&str; 2]; 12] = [
    ["enero", "january"],
    ["febrero", "february"],
    ["marzo", "march"],
    ["abril", "april"],
    ["mayo", "may"],
    ["junio", "june"],
    ["julio", "july"],
    ["agosto", "august"],
    ["septiembre", "september"],
    ["octubre", "october"],
    ["noviembre", "november"],
    ["diciembre", "december"],
];

/// Words that may stand between day, month and year.
const JOINING: [&str; 8] = ["de", "del", "of", "the", "st", "nd", "rd", "th"];

/// Words before a number that is not a day: a week.
const WEEK: [&str; 5] = ["semana", "sem", "week", "wk", "cw"];

/// True of a text with a date in it that no calendar has, such as `31/02/2026`, `29 Feb 2026` or `2026-13-40`.
///
/// A date in figures is right where one order of day and month makes it a day: `12/31/2026` is. Where the year comes first the month
/// comes before the day. Of two figures a year is of this century; it comes first only between hyphens. False of a text without a date.
#[must_use]
pub fn never(text: &str) -> bool {
    let pieces = pieces(text);
    (0..pieces.len()).any(|at| in_figures(&pieces, at) || in_words(&pieces, at))
}

/// True as a formula where a cell's whole text is a date in figures that [`never`] is true of, with strokes, full stops or hyphens;
/// false of dates in words and of a date within a text, which are left to `rodete check`.
///
/// # Derivation
/// Without its figures such a text is two strokes, or the like. Of two numbers the lesser is a month wherever one of them is; and a day
/// that its month has not, a month 0 or 13, a day 0: DATE makes a day of another month of each. After 400 years the calendar is the same.
#[must_use]
pub fn never_in_figures(cell: &str) -> String {
    let text = format!("TRIM({cell})");
    let signs = (0..=9).fold(text.clone(), |text, figure| format!("SUBSTITUTE({text},{figure},\"\")"));
    // Wider than any of the three numbers that count.
    let wide = ["/", ".", "-"].iter().fold(text, |text, sign| format!("SUBSTITUTE({text},\"{sign}\",REPT(\" \",9))"));
    let part = |number: u8| format!("TRIM(MID({wide},{},9))", 9 * number + 1);
    let long = |number| format!("LEN({})", part(number));
    let value = |number| format!("VALUE({})", part(number));
    let short = |number| format!("({0}-1)*({0}-2)=0", long(number));
    let no_day =
        |year: &str, month: &str, day: &str| format!("MONTH(DATE(2000+MOD({year},400),{month},{day}))<>{month}");
    let year_first = no_day(&value(0), &value(1), &value(2));
    let either = {
        let [low, high] = ["MIN", "MAX"].map(|of| format!("{of}({},{})", value(0), value(1)));
        no_day(&value(2), &low, &high)
    };
    // Of two figures the year comes first between hyphens alone.
    let hyphens = format!("IF({signs}=\"--\",IF({0}=2,IF({1}=2,{year_first},TRUE),TRUE),TRUE)", long(0), long(2));
    let last = format!("IF({},IF(({1}-2)*({1}-4)=0,IF({either},{hyphens},FALSE),FALSE),FALSE)", short(0), long(2));
    let first = format!("IF({},{year_first},FALSE)", short(2));
    format!(
        "IF(OR({signs}=\"//\",{signs}=\"..\",{signs}=\"--\"),IF({},IF({}=4,{first},{last}),FALSE),FALSE)",
        short(1),
        long(0)
    )
}

/// True of a day of the calendar with all its figures, as `2026-11-23`.
#[must_use]
pub fn is_day_in_full(text: &str) -> bool {
    let [Piece::Digits(year), Piece::Between("-"), Piece::Digits(month), Piece::Between("-"), Piece::Digits(day)] =
        pieces(text)[..]
    else {
        return false;
    };
    let number = |digits: &str, figures| digits.parse::<u32>().ok().filter(|_| digits.len() == figures);
    let all = (number(year, 4), number(month, 2), number(day, 2));
    matches!(all, (Some(year), Some(month), Some(day)) if is_day(Some(year), month, day))
}

fn pieces(text: &str) -> Vec<Piece<'_>> {
    let sort = |one: char| (one.is_ascii_digit(), one.is_alphabetic() && !"ºª".contains(one));
    let mut pieces = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let end = rest.find(|one| sort(one) != sort(first)).unwrap_or(rest.len());
        let (piece, after) = rest.split_at(end);
        pieces.push(match sort(first) {
            (true, _) => Piece::Digits(piece),
            (_, true) => Piece::Letters(piece),
            _ => Piece::Between(piece),
        });
        rest = after;
    }
    pieces
}

/// The last day of a month; `None` where there is no such month. Without a year February has 29.
fn last_day(year: Option<u32>, month: u32) -> Option<u32> {
    let leap = year.is_none_or(|year| year % 4 == 0 && (year % 100 != 0 || year % 400 == 0));
    match month {
        1 | 3 | 5 | 7 | 8 | 10 | 12 => Some(31),
        4 | 6 | 9 | 11 => Some(30),
        2 => Some(if leap { 29 } else { 28 }),
        _ => None,
    }
}

fn is_day(year: Option<u32>, month: u32, day: u32) -> bool {
    last_day(year, month).is_some_and(|last| (1..=last).contains(&day))
}

/// A year of four figures, or of two in this century.
fn year_of(digits: &str) -> Option<u32> {
    let year = digits.parse().ok()?;
    match digits.len() {
        4 => Some(year),
        2 => Some(2000 + year),
        _ => None,
    }
}

/// What parts three figures: a stroke, a hyphen, a full stop, or blanks alone.
fn parting(between: &str) -> Option<char> {
    match between.trim() {
        "" => Some(' '),
        "/" => Some('/'),
        "." => Some('.'),
        "-" | "\u{2010}" | "\u{2011}" | "\u{2013}" | "\u{2212}" => Some('-'),
        _ => None,
    }
}

/// True of three numbers from `at` on, as of a date, that are a day in no order.
fn in_figures(pieces: &[Piece<'_>], at: usize) -> bool {
    let Some([Piece::Digits(a), Piece::Between(one), Piece::Digits(b), Piece::Between(other), Piece::Digits(c)]) =
        pieces.get(at..).and_then(|rest| rest.first_chunk())
    else {
        return false;
    };
    let Some(parting_them) = parting(one) else { return false };
    // Four numbers, or a letter beside, are of something else: a version, an address.
    let piece = |at: Option<usize>| at.and_then(|at| pieces.get(at));
    let chained = |beside: Option<usize>, beyond: Option<usize>| match (piece(beside), piece(beyond)) {
        (Some(Piece::Between(between)), Some(Piece::Digits(_))) => parting(between) == Some(parting_them),
        (Some(Piece::Letters(letters)), _) => !letters.eq_ignore_ascii_case("t"),
        _ => false,
    };
    let chained = chained(at.checked_sub(1), at.checked_sub(2)) || chained(Some(at + 5), Some(at + 6));
    if parting(other) != Some(parting_them) || chained {
        return false;
    }
    let number = |digits: &str| digits.parse::<u32>().ok().filter(|_| digits.len() <= 2);
    let either = |year: &str, one: &str, other: &str| {
        let (year, one, other) = (year_of(year)?, number(one)?, number(other)?);
        Some(is_day(Some(year), one, other) || is_day(Some(year), other, one))
    };
    // Nobody writes the day between year and month.
    let year_first =
        |year: &str, month: &str, day: &str| Some(is_day(Some(year_of(year)?), number(month)?, number(day)?));
    let found = match (a.len(), c.len()) {
        (4, _) => year_first(a, b, c),
        (_, 4) => either(c, a, b),
        _ if parting_them == ' ' => None,
        (2, 2) if parting_them == '-' => either(c, a, b).map(|so| so || year_first(a, b, c) == Some(true)),
        (_, 2) => either(c, a, b),
        _ => None,
    };
    found == Some(false)
}

/// The number of a month, 1 to 12, from its name or three letters of it or more.
fn month(piece: Option<&Piece<'_>>) -> Option<u32> {
    let Some(Piece::Letters(word)) = piece else { return None };
    let word = word.to_lowercase();
    let is = |names: &[&str; 2]| word.len() >= 3 && names.iter().any(|name| name.starts_with(&word));
    let spelt = if word == "set" || word == "setiembre" { Some(8) } else { None };
    let index = spelt.or_else(|| MONTHS.iter().position(is))?;
    u32::try_from(index + 1).ok()
}

/// The first piece from `at` on that joins nothing; `None` where something else comes before.
fn joined(pieces: &[Piece<'_>], mut at: usize, comma: bool) -> Option<usize> {
    loop {
        match pieces.get(at)? {
            Piece::Between(between) => {
                let may = |one: char| one.is_whitespace() || "./-\u{2013}ºª°'".contains(one) || comma && one == ',';
                if !between.chars().all(may) {
                    return None;
                }
            }
            Piece::Letters(word) if JOINING.contains(&word.to_lowercase().as_str()) => {}
            _ => return Some(at),
        }
        at += 1;
    }
}

/// True of a date from `at` on whose month is a word: day, month and perhaps year; month, day and year; or year, month and day.
fn in_words(pieces: &[Piece<'_>], at: usize) -> bool {
    let digits = |at: Option<usize>, most: usize| match pieces.get(at?)? {
        Piece::Digits(digits) if digits.len() <= most => Some(*digits),
        _ => None,
    };
    let after = |at: usize, comma| joined(pieces, at + 1, comma);
    let year_at = |at: usize| after(at, true).and_then(|at| year_of(digits(Some(at), 4)?));
    let day_at = |at: Option<usize>| digits(at, 2).and_then(|day| day.parse::<u32>().ok());
    match pieces.get(at) {
        Some(Piece::Digits(first)) => {
            let Some(next) = after(at, false) else { return false };
            let Some(month) = month(pieces.get(next)) else { return false };
            let week = at.checked_sub(2).and_then(|at| pieces.get(at)).is_some_and(
                |piece| matches!(piece, Piece::Letters(word) if WEEK.contains(&word.to_lowercase().as_str())),
            );
            match day_at(Some(at)) {
                Some(day) if !week => {
                    let year = year_at(next);
                    (year.is_some() || day <= 31) && !is_day(year, month, day)
                }
                _ if first.len() == 4 => {
                    day_at(after(next, false)).is_some_and(|day| !is_day(year_of(first), month, day))
                }
                _ => false,
            }
        }
        Some(piece @ Piece::Letters(_)) => {
            let Some(month) = month(Some(piece)) else { return false };
            let Some(next) = after(at, false) else { return false };
            let year = after(next, true).and_then(|at| digits(Some(at), 4)).filter(|year| year.len() == 4);
            // After a day, as in 1 Feb 30 2026, the number is not the day of this month.
            let (Some(day), Some(year)) = (day_at(Some(next)), year.and_then(year_of)) else { return false };
            !is_day(Some(year), month, day)
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::{is_day_in_full, never};

    #[test]
    fn a_day_that_no_calendar_has_is_known_in_every_form() {
        for text in [
            "31/02/2026",
            "29/02/2026",
            "29/02/1900",
            "29-2-2100",
            "31.04.2026",
            "31.04.2026.",
            "31 / 04 / 2026",
            "31 04 2026",
            "31\u{2013}04\u{2013}2026",
            "31/02/26",
            "29.02.26",
            "02/30/2026",
            "2026-02-30",
            "2026/13/13",
            "2026-13-01",
            "2026/31/12",
            "2026.13.01",
            "26-13-01",
            "2026-02-29T10:00:00",
            "2026-02-30 10:30",
            "00/05/2026",
            "32/01/2026",
            "Cartagena, 31/11/2026",
            "31 de febrero de 2026",
            "Cartagena, a 31 de noviembre de 2026",
            "29 de febrero del 2026",
            "31 de septiembre, 2026",
            "31 setiembre 2026",
            "30 febrero",
            "31-feb-26",
            "31st of November 2026",
            "Nov 31st, 2026",
            "February 29, 2026",
            "Feb. 30, 2026",
            "2026 Feb 30",
            "2026-feb-30",
            "45 de mayo de 2026",
        ] {
            assert!(never(text), "{text}");
        }
    }

    #[test]
    fn a_day_in_full_has_four_two_and_two_figures_and_is_one() {
        for text in ["2026-11-23", "1904-01-01", "2028-02-29", "9999-12-31"] {
            assert!(is_day_in_full(text), "{text}");
        }
        for text in ["", "-5", "10000000", "1900-02-29", "2026-13-01", "26-11-23", "2026-1-1", "2026-11-23T10", "2026"]
        {
            assert!(!is_day_in_full(text), "{text}");
        }
    }

    #[test]
    fn every_other_text_stays_a_date() {
        for text in [
            "",
            "-",
            "2026-11-23",
            "23/11/2026",
            "11/23/2026",
            "12/31/2026",
            "31/12/26",
            "26-11-23",
            "31-12-26",
            "29/02/2028",
            "29/02/2000",
            "29/2/00",
            "29 de febrero",
            "29 Feb 2028",
            "Nov 23rd, 2026",
            "23rd of November, 2026",
            "23 nov. 2026",
            "1º de mayo de 2026",
            "lunes, 23 de noviembre de 2026",
            "noviembre de 2026",
            "November 2026",
            "11/2026",
            "2026",
            "46349",
            "20260231",
            "semana 45 noviembre 2026",
            "semana 45, noviembre 2026",
            "week 45 Nov 2026",
            "2026-W45",
            "31.02.2026.4",
            "v31.02.2026",
            "1.31.02.2026",
            "3/4/5",
            "31 02 26",
            "10:31:26",
            "May 45",
            "a determinar",
            "2026-11-23T31:02:26",
            "２３/１１/２０２６",
        ] {
            assert!(!never(text), "{text}");
        }
    }
}
