//! The stock on the command line: `D50xL100`, with a bore `D50xL100xd20`.

/// The stock's diameter, length and bore in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stock {
    /// D.
    pub(super) D: f64,
    /// L.
    pub(super) L: f64,
    /// d, of a tube.
    pub(super) d: Option<f64>,
}

/// Reads the stock: the letters D, L and d with decimal numbers in mm, each once, with `x` between. Small letters do as well:
/// without a capital D the first d is the diameter.
///
/// # Errors
/// What is wrong, as the end of a sentence that names the argument.
pub(super) fn parse(text: &str) -> Result<Stock, String> {
    let (mut D, mut L, mut d) = (None, None, None);
    for part in text.split(['x', 'X']) {
        let wrong = || format!("'{part}' is not a size: write D, L or d and a number in mm, as D50xL100");
        let mut letters = part.chars();
        let letter = match letters.next() {
            Some('d') if D.is_none() && !text.contains('D') => 'D',
            Some(letter @ ('D' | 'd')) => letter,
            Some('L' | 'l') => 'L',
            _ => return Err(wrong()),
        };
        let digits = letters.as_str();
        if digits.contains(',') {
            return Err(format!("'{part}': write the decimal with a point, {}", part.replace(',', ".")));
        }
        let plain = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
        let value: f64 = digits.parse().ok().filter(|_| plain).ok_or_else(wrong)?;
        let slot = match letter {
            'D' => &mut D,
            'L' => &mut L,
            _ => &mut d,
        };
        if !(0.1..=1000.0).contains(&value) {
            return Err(format!("{part} is out of range: from 0.1 to 1000 mm"));
        }
        if slot.replace(value).is_some() {
            return Err(format!("{letter} is given twice"));
        }
    }
    let (Some(D), Some(L)) = (D, L) else {
        return Err("D and L must both be given, as D50xL100".to_owned());
    };
    if d.is_some_and(|d| d >= D) {
        return Err("the bore d must be less than D".to_owned());
    }
    Ok(Stock { D, L, d })
}

impl std::fmt::Display for Stock {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(out, "D{}xL{}", self.D, self.L)?;
        self.d.map_or(Ok(()), |d| write!(out, "xd{d}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stock_is_read_in_any_order() {
        assert_eq!(parse("D50xL100"), Ok(Stock { D: 50.0, L: 100.0, d: None }));
        assert_eq!(parse("L100.5XD50xd20"), Ok(Stock { D: 50.0, L: 100.5, d: Some(20.0) }));
        assert_eq!(parse("d20xD50xL100"), Ok(Stock { D: 50.0, L: 100.0, d: Some(20.0) }));
        assert_eq!(parse("d50xl100"), Ok(Stock { D: 50.0, L: 100.0, d: None }));
        assert_eq!(parse("d50xl100xd20"), Ok(Stock { D: 50.0, L: 100.0, d: Some(20.0) }));
    }

    #[test]
    fn what_is_no_stock_says_why() {
        for (text, why) in [
            ("50x100", "'50' is not a size: write D, L or d and a number in mm, as D50xL100"),
            ("D50", "D and L must both be given, as D50xL100"),
            ("D50xL1e3", "'L1e3' is not a size: write D, L or d and a number in mm, as D50xL100"),
            ("D50,5xL100", "'D50,5': write the decimal with a point, D50.5"),
            ("D50xL-3", "'L-3' is not a size: write D, L or d and a number in mm, as D50xL100"),
            ("D50xL100xL3", "L is given twice"),
            ("D50xL100xd50", "the bore d must be less than D"),
            ("D50xL0", "L0 is out of range: from 0.1 to 1000 mm"),
            ("", "'' is not a size: write D, L or d and a number in mm, as D50xL100"),
        ] {
            assert_eq!(parse(text), Err(why.to_owned()), "{text}");
        }
    }
}
