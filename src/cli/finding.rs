//! A finding in three parts: what, where, what to do.

use anstyle::{AnsiColor, Style};
use textwrap::{Options, fill};

use crate::escape::printable;
use crate::finding::{CellPlace, Finding, Grade, Place};
use crate::limits::LISTED_FINDINGS;
use crate::text::{Language, Text, t};

/// The names that places are told with.
#[derive(Clone, Copy, Debug)]
pub(super) struct Names<'a> {
    /// The input.
    pub(super) input: &'a str,
    /// The workbook in which sheets and cells stand, where it is another file than the input.
    pub(super) workbook: &'a str,
}

impl<'a> From<&'a String> for Names<'a> {
    fn from(input: &'a String) -> Self {
        Self::from(input.as_str())
    }
}

impl<'a> From<&'a str> for Names<'a> {
    fn from(input: &'a str) -> Self {
        Self { input, workbook: input }
    }
}

/// The findings of one workbook as text, those of `grades` only, gravest first; then how many more there are.
pub(super) fn list<'a>(
    findings: &[Finding],
    grades: impl Fn(Grade) -> bool,
    names: impl Into<Names<'a>>,
    language: Language,
    width: Option<usize>,
) -> String {
    let names = names.into();
    let mut wanted: Vec<_> = findings.iter().filter(|finding| grades(finding.grade)).collect();
    wanted.sort_by_key(|finding| std::cmp::Reverse(finding.grade));
    let mut text: String =
        wanted.iter().take(LISTED_FINDINGS).map(|finding| one(finding, names, language, width)).collect();
    if wanted.len() > LISTED_FINDINGS {
        let more = Text::new(
            format!("… se muestran {LISTED_FINDINGS} de {}\n", wanted.len()),
            format!("… {LISTED_FINDINGS} of {} are shown\n", wanted.len()),
        );
        text.push_str(more.get(language));
    }
    text
}

/// A finding that concerns the whole command and not one workbook.
pub(super) fn general(finding: &Finding, language: Language, width: Option<usize>) -> String {
    let mut text = head(finding, language, width);
    text.push_str(&hint(finding, language, width));
    text
}

/// One finding as text.
pub(super) fn one(finding: &Finding, names: Names<'_>, language: Language, width: Option<usize>) -> String {
    let arrow = Style::new().fg_color(Some(AnsiColor::Blue.into()));
    let mut text = head(finding, language, width);
    // A note on a result names it in its sentence.
    if finding.grade == Grade::Note && matches!(finding.place, Place::File | Place::Point { .. } | Place::Block { .. })
    {
        return text;
    }
    text.push_str(&wrapped(&format!("  {arrow}-->{arrow:#} {}", place(&finding.place, names, language)), 6, width));
    text.push_str(&hint(finding, language, width));
    text
}

fn head(finding: &Finding, language: Language, width: Option<usize>) -> String {
    let (word, colour) = grade(finding.grade);
    let style = Style::new().bold().fg_color(Some(colour.into()));
    wrapped(&format!("{style}{}{style:#}: {}", word.get(language), sentence(finding, language)), 2, width)
}

fn hint(finding: &Finding, language: Language, width: Option<usize>) -> String {
    let remedy = printable(finding.remedy.get(language));
    if remedy.is_empty() {
        return String::new();
    }
    let style = Style::new().bold().fg_color(Some(AnsiColor::Green.into()));
    let word = t("sugerencia", "hint");
    wrapped(&format!("{style}{}{style:#}: {remedy}", word.get(language)), 2, width)
}

/// What was found, with value and limit where the sentence does not name them already.
fn sentence(finding: &Finding, language: Language) -> String {
    let what = printable(finding.what.get(language));
    if let Some(count) = finding.value.strip_suffix(" ×") {
        return format!("{what}, {count} {}", t("veces", "times").get(language));
    }
    let limit = t("límite", "limit");
    let value = if what.contains(finding.value.as_str()) { "" } else { finding.value.as_str() };
    let bound = if what.contains(finding.limit.as_str()) { "" } else { finding.limit.as_str() };
    let bound = if bound.is_empty() { String::new() } else { format!("{} {}", limit.get(language), printable(bound)) };
    match (value.is_empty(), bound.is_empty()) {
        (true, true) => what,
        (false, true) => format!("{what}: {}", printable(value)),
        (true, false) => format!("{what} ({bound})"),
        (false, false) => format!("{what}: {} ({bound})", printable(value)),
    }
}

const fn grade(grade: Grade) -> (Text, AnsiColor) {
    match grade {
        Grade::Stop => (t("error", "error"), AnsiColor::Red),
        Grade::Caution => (t("precaución", "caution"), AnsiColor::Yellow),
        Grade::Note => (t("nota", "note"), AnsiColor::Cyan),
    }
}

/// Where a finding belongs, beginning with the file.
fn place(place: &Place, names: Names<'_>, language: Language) -> String {
    let Names { input, workbook } = names;
    let word = |es: &'static str, en: &'static str| match language {
        Language::Es => es,
        Language::En => en,
    };
    match place {
        Place::File => input.to_owned(),
        Place::Part(part) => format!("{workbook}, {} {}", word("parte", "part"), printable(part)),
        Place::Sheet(sheet) => format!("{workbook}, {} \"{}\"", word("hoja", "sheet"), printable(sheet)),
        Place::Cells(cells) => format!("{workbook}{}", addresses(cells, language)),
        Place::Parameters(keys) => {
            let noun =
                if keys.len() == 1 { word("parámetro", "parameter") } else { word("parámetros", "parameters") };
            format!("{workbook}, {noun} {}", keys.join(", "))
        }
        Place::Point { table, index } => {
            format!("{input}, {} {table}, i = {index}", word("tabla", "table"))
        }
        Place::Block { program, line } => {
            format!("{input}, {} {program}, {} {line}", word("programa", "program"), word("línea", "line"))
        }
        Place::Subprogram { file, line, columns } => {
            let file = printable(file);
            let column = columns.first().map_or(String::new(), |column| format!(":{column}"));
            format!("{input}, {} {file}:{line}{column}", word("subprograma", "subprogram"))
        }
        // As compilers and editors write it.
        Place::Line { line, columns } => match columns.first() {
            Some(column) => format!("{input}:{line}:{column}"),
            None => format!("{input}:{line}"),
        },
    }
}

/// Cells, those that follow one another in one sheet under one mention of it.
fn addresses(cells: &[CellPlace], language: Language) -> String {
    let (sheet, cell, many) = match language {
        Language::Es => ("hoja", "celda", "celdas"),
        Language::En => ("sheet", "cell", "cells"),
    };
    cells
        .chunk_by(|one, next| one.sheet == next.sheet)
        .map(|chunk| {
            let name = chunk.first().map_or("", |one| one.sheet.as_str());
            let noun = if chunk.len() == 1 { cell } else { many };
            let list = chunk.iter().map(|one| printable(&one.cell)).collect::<Vec<_>>().join(", ");
            format!(", {sheet} \"{}\", {noun} {list}", printable(name))
        })
        .collect()
}

/// A paragraph broken at the width of the terminal, with a line feed at its end.
pub(super) fn wrapped(paragraph: &str, indent: usize, width: Option<usize>) -> String {
    let mut text = match width {
        Some(width) => fill(paragraph, Options::new(width).subsequent_indent(&" ".repeat(indent)).break_words(false)),
        None => paragraph.to_owned(),
    };
    text.push('\n');
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain(finding: &Finding, language: Language, width: Option<usize>) -> String {
        anstream::adapter::strip_str(&one(finding, "impeller.xlsx".into(), language, width)).to_string()
    }

    fn thick(sheet: &str) -> Finding {
        Finding::stop(
            Place::Cells(vec![CellPlace { sheet: sheet.into(), cell: "C9".into() }]),
            t(
                "el espesor e es 12 mm y debe ser menor que 9.71 mm con 4 álabes",
                "blade thickness e is 12 mm, must be below 9.71 mm for 4 blades",
            ),
            t("menos álabes", "fewer blades, a thinner blade, or a smaller tool"),
        )
    }

    #[test]
    fn a_finding_has_three_parts() {
        assert_eq!(
            plain(&thick("DATOS").with("12 mm", "9.71 mm"), Language::En, None),
            "error: blade thickness e is 12 mm, must be below 9.71 mm for 4 blades\n  --> impeller.xlsx, sheet \
             \"DATOS\", cell C9\nhint: fewer blades, a thinner blade, or a smaller tool\n"
        );
        assert!(plain(&thick("DATOS"), Language::Es, None).contains("--> impeller.xlsx, hoja \"DATOS\", celda C9\n"));
    }

    #[test]
    fn value_and_limit_are_named_once() {
        let finding = Finding::note(Place::File, t("cierre", "closure")).with("0.000 mm", "0.001 mm");
        assert!(plain(&finding, Language::En, None).starts_with("note: closure: 0.000 mm (limit 0.001 mm)\n"));
    }

    #[test]
    fn how_often_something_was_seen_is_said_in_words() {
        let finding = Finding::note(Place::File, t("X negativa", "negative X")).with("2 ×", "");
        assert!(plain(&finding, Language::En, None).starts_with("note: negative X, 2 times\n"));
        assert!(plain(&finding, Language::Es, None).starts_with("nota: X negativa, 2 veces\n"));
    }

    #[test]
    fn cells_of_one_sheet_are_listed_together() {
        let cell = |sheet: &str, cell: &str| CellPlace { sheet: sheet.into(), cell: cell.into() };
        let cells = [cell("DATA", "C5"), cell("DATA", "C6"), cell("CALIBRATION", "C3")];
        assert_eq!(addresses(&cells, Language::En), ", sheet \"DATA\", cells C5, C6, sheet \"CALIBRATION\", cell C3");
    }

    #[test]
    fn what_the_user_typed_cannot_steer_the_terminal() {
        let text = one(&thick("\u{1b}]0;x\u{7}\u{202e}"), "impeller.xlsx".into(), Language::En, None);
        assert!(text.contains("\\u{1b}]0;x\\u{7}\\u{202e}"));
        assert!(!text.contains(['\u{7}', '\u{202e}']) && !text.contains("\u{1b}]"));
    }

    #[test]
    fn lines_fit_forty_columns() {
        let text = plain(&thick("DATOS"), Language::En, Some(40));
        assert!(text.lines().count() > 3);
        assert!(text.lines().all(|line| line.chars().count() <= 40), "{text}");
    }

    #[test]
    fn the_fifty_gravest_are_shown_and_the_rest_counted() {
        let mut findings = vec![Finding::note(Place::File, t("leve", "slight")); 60];
        findings.push(thick("DATOS"));
        let text = list(&findings, |_| true, "impeller.xlsx", Language::En, None);
        let text = anstream::adapter::strip_str(&text).to_string();
        assert!(text.starts_with("error: blade"));
        assert_eq!(text.matches("note: slight").count(), 49);
        assert!(text.ends_with("… 50 of 61 are shown\n"));
    }
}
