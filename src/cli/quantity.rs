//! Derived limits, angles and lengths as a table: symbol = value unit, meaning.

use textwrap::core::display_width;

use super::finding::wrapped;
use crate::escape::printable;
use crate::table::{Quantity, Unit};
use crate::text::Language;

/// Decimals shown: those that mean something in a shop, and one more. The results workbook has the values whole.
const fn decimals(unit: Unit) -> usize {
    match unit {
        Unit::Count | Unit::RevolutionPerMinute | Unit::CubicMillimetre => 0,
        Unit::MetrePerMinute | Unit::CubicCentimetrePerMinute | Unit::MillimetrePerMinute | Unit::DegreePerMinute => 1,
        Unit::Second => 2,
        Unit::Millimetre
        | Unit::SquareMillimetre
        | Unit::Degree
        | Unit::MillimetrePerRevolution
        | Unit::Radian
        | Unit::Step
        | Unit::One
        | Unit::None => 4,
    }
}

/// The quantities as lines, symbols, decimal points and meanings under one another.
pub(super) fn table(quantities: &[Quantity], language: Language, width: Option<usize>) -> String {
    table_of(quantities, |_| true, language, width)
}

/// The same with a dash in place of each value that is not `known`.
pub(super) fn table_of(
    quantities: &[Quantity],
    known: impl Fn(&Quantity) -> bool,
    language: Language,
    width: Option<usize>,
) -> String {
    let shown = |one: &Quantity| {
        if known(one) { number(one.value, one.unit) } else { ("-".to_owned(), String::new()) }
    };
    let rows: Vec<_> = quantities.iter().map(|one| (one, shown(one))).collect();
    let symbols = rows.iter().map(|(one, _)| display_width(one.symbol)).max().unwrap_or(0);
    let wholes = rows.iter().map(|(_, (whole, _))| whole.len()).max().unwrap_or(0);
    let ends = rows.iter().map(|(one, (_, decimals))| end(one, decimals)).map(|end| display_width(&end)).max();
    let ends = ends.unwrap_or(0);
    let meaning = 2 + symbols + 3 + wholes + ends + 2;
    let indent = if width.is_some_and(|width| meaning * 2 > width) { 6 } else { meaning };
    rows.iter()
        .map(|(one, (whole, decimals))| {
            let end = end(one, decimals);
            let line = format!(
                "  {}{} = {whole:>wholes$}{end}{}  {}",
                one.symbol,
                blanks(symbols - display_width(one.symbol)),
                blanks(ends - display_width(&end)),
                printable(one.meaning.get(language)).replace('\u{2212}', "-"),
            );
            wrapped(line.trim_end(), indent, width)
        })
        .collect()
}

/// What stands right of the decimal point, with the unit.
fn end(one: &Quantity, decimals: &str) -> String {
    match one.unit.label() {
        "" => decimals.to_owned(),
        "°" => format!("{decimals}°"),
        unit => format!("{decimals} {unit}"),
    }
}

/// A value as digits before the point, and the point with what follows it: rounded, without needless zeros.
fn number(value: f64, unit: Unit) -> (String, String) {
    let decimals = decimals(unit);
    let text = format!("{value:.decimals$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    let text = if text == "-0" { "0" } else { text };
    let (whole, rest) = text.split_at(text.find('.').unwrap_or(text.len()));
    (whole.to_owned(), rest.to_owned())
}

fn blanks(count: usize) -> String {
    " ".repeat(count)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::t;

    fn quantity(symbol: &'static str, value: f64, unit: Unit) -> Quantity {
        let text = t("qué es", "what it is");
        Quantity { symbol, meaning: text.clone(), value, unit, source: text, cell: None }
    }

    #[test]
    fn points_and_meanings_stand_under_one_another() {
        let quantities = [
            quantity("N_max", 4.0, Unit::Count),
            quantity("L", 242.9, Unit::Millimetre),
            quantity("β", 36.869_897_6, Unit::Degree),
            quantity("x", -0.000_01, Unit::One),
            quantity("t", 144.0647, Unit::Second),
            quantity("V", 78_444.6, Unit::CubicMillimetre),
        ];
        let expected = [
            "  N_max =     4        what it is",
            "  L     =   242.9 mm   what it is",
            "  β     =    36.8699°  what it is",
            "  x     =     0        what it is",
            "  t     =   144.06 s   what it is",
            "  V     = 78445 mm³    what it is",
        ];
        assert_eq!(table(&quantities, Language::En, None), expected.join("\n") + "\n");
    }

    #[test]
    fn a_narrow_terminal_gets_short_lines() {
        let text = table(&[quantity("N_max", 4.0, Unit::Count)], Language::Es, Some(20));
        assert!(text.lines().all(|line| line.chars().count() <= 20), "{text}");
    }
}
