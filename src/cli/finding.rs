//! The door through which findings are printed: each in three parts, what, where, what to do.

use anstyle::{AnsiColor, Style};
use textwrap::{Options, fill};

use super::terminal::Terminal;
use crate::escape::printable;
use crate::finding::{CellPlace, Finding, Grade, Place, gravest_first};
use crate::limits::LISTED_FINDINGS;
use crate::text::{Language, Text, t};

/// The names that places are reported with.
#[derive(Clone, Copy, Debug)]
pub(super) struct Names<'a> {
    /// The name of the input, as it was given.
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

/// Prints the stops and cautions of one workbook or program to standard error, gravest first.
pub(super) fn faults<'a>(
    findings: &[Finding],
    names: impl Into<Names<'a>>,
    language: Language,
    terminal: &mut Terminal,
) {
    let text = list(findings, |grade| grade > Grade::Note, names.into(), language, terminal.width);
    remember(findings, language, terminal);
    terminal.err(&text);
}

/// Prints the notes of one workbook or program to standard output.
pub(super) fn notes<'a>(
    findings: &[Finding],
    names: impl Into<Names<'a>>,
    language: Language,
    terminal: &mut Terminal,
) {
    terminal.out(&list(findings, |grade| grade == Grade::Note, names.into(), language, terminal.width));
}

/// Prints findings that concern the whole command and not one workbook to standard error, with their place where it names its file.
pub(super) fn general<'f>(
    findings: impl IntoIterator<Item = &'f Finding> + Clone,
    language: Language,
    terminal: &mut Terminal,
) {
    beside(findings, None, language, terminal);
}

/// The same, with the workbook that was named beside the programs: sheets and cells are those of it.
pub(super) fn beside<'f>(
    findings: impl IntoIterator<Item = &'f Finding> + Clone,
    workbook: Option<&str>,
    language: Language,
    terminal: &mut Terminal,
) {
    let width = terminal.width;
    let at = |finding: &Finding| match (&finding.place, workbook) {
        (Place::Beside { .. }, _) => arrow(finding, "".into(), language, width),
        (Place::Part(_) | Place::Sheet(_) | Place::Cells(_), Some(name)) => {
            arrow(finding, name.into(), language, width)
        }
        _ => String::new(),
    };
    let one = |finding: &Finding| head(finding, language, width) + &at(finding) + &hint(finding, language, width);
    let text: String = findings.clone().into_iter().map(one).collect();
    remember(findings, language, terminal);
    terminal.err(&text);
}

/// Prints how to learn more of the first code that needs attention, as the last line; nothing where none was printed.
pub(super) fn more(terminal: &mut Terminal) {
    let Some((code, language)) = terminal.told else { return };
    let program = &terminal.program;
    let text = Text::new(
        format!("{program} explain {code} dice qué significa, con un ejemplo"),
        format!("{program} explain {code} says what it means, with an example"),
    );
    let text = wrapped(text.get(language), 2, terminal.width);
    terminal.err(&text);
}

/// Keeps the first code of a command that is printed of a stop or caution: that of the gravest.
fn remember<'f>(findings: impl IntoIterator<Item = &'f Finding>, language: Language, terminal: &mut Terminal) {
    if terminal.told.is_none() {
        let mut faults: Vec<_> = findings.into_iter().filter(|finding| finding.grade > Grade::Note).collect();
        gravest_first(&mut faults);
        let printed = faults.into_iter().take(LISTED_FINDINGS);
        terminal.told = printed.map(|finding| (finding.rule().code, language)).next();
    }
}

/// Findings as text, those of `grades` only, gravest first; then how many more there are.
fn list(
    findings: &[Finding],
    grades: impl Fn(Grade) -> bool,
    names: Names<'_>,
    language: Language,
    width: Option<usize>,
) -> String {
    let mut wanted: Vec<_> = findings.iter().filter(|finding| grades(finding.grade)).collect();
    gravest_first(&mut wanted);
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

/// One finding as text.
fn one(finding: &Finding, names: Names<'_>, language: Language, width: Option<usize>) -> String {
    let mut text = head(finding, language, width);
    // A note on a result names it in its sentence.
    if finding.grade == Grade::Note && matches!(finding.place, Place::File | Place::Point { .. } | Place::Block { .. })
    {
        return text;
    }
    text.push_str(&arrow(finding, names, language, width));
    text.push_str(&hint(finding, language, width));
    text
}

/// Where a finding belongs, on a line of its own.
fn arrow(finding: &Finding, names: Names<'_>, language: Language, width: Option<usize>) -> String {
    let arrow = Style::new().fg_color(Some(AnsiColor::Blue.into()));
    wrapped(&format!("  {arrow}-->{arrow:#} {}", place(&finding.place, names, language)), 6, width)
}

/// The grade's word with the code, by which `rodete explain` knows the finding, and the sentence.
fn head(finding: &Finding, language: Language, width: Option<usize>) -> String {
    let (word, colour) = grade(finding.grade);
    let style = Style::new().bold().fg_color(Some(colour.into()));
    let code = finding.code();
    wrapped(&format!("{style}{} {code}{style:#}: {}", word.get(language), sentence(finding, language)), 2, width)
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
    // A compiler's lines stay lines.
    let what = finding.what.get(language).split('\n').map(printable).collect::<Vec<_>>().join("\n");
    if let Some(count) = finding.counted() {
        return format!("{what}, {count} {}", t("veces", "times").get(language));
    }
    let limit = t("límite", "limit");
    let [value, bound] = finding.shown(language).map(|text| if what.contains(text) { "" } else { text });
    // A range is named where both of its ends are.
    let ends = bound.split_once(" … ").filter(|(low, high)| names(&what, low) && names(&what, high));
    let bound = if ends.is_some() { "" } else { bound };
    let bound = if bound.is_empty() { String::new() } else { format!("{} {}", limit.get(language), printable(bound)) };
    match (value.is_empty(), bound.is_empty()) {
        (true, true) => what,
        (false, true) => format!("{what}: {}", printable(value)),
        (true, false) => format!("{what} ({bound})"),
        (false, false) => format!("{what}: {} ({bound})", printable(value)),
    }
}

/// True for a sentence in which a number, with its unit if it has one, stands by itself.
fn names(what: &str, number: &str) -> bool {
    let part = |letter: char| letter.is_alphanumeric() || matches!(letter, '.' | '-');
    what.match_indices(number).any(|(at, _)| {
        let (before, after) = (&what[..at], &what[at + number.len()..]);
        let goes_on = after.strip_prefix('.').unwrap_or(after).starts_with(char::is_alphanumeric);
        !before.ends_with(part) && !goes_on
    })
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
    let word = |text: Text| text.take(language);
    match place {
        Place::File => input.to_owned(),
        Place::Part(part) => format!("{workbook}, {} {}", word(t("parte", "part")), printable(part)),
        Place::Sheet(sheet) => format!("{workbook}, {} \"{}\"", word(t("hoja", "sheet")), printable(sheet)),
        Place::Cells(cells) => format!("{workbook}{}", addresses(cells, language)),
        Place::Parameters(keys) => {
            let noun =
                if keys.len() == 1 { word(t("parámetro", "parameter")) } else { word(t("parámetros", "parameters")) };
            format!("{workbook}, {noun} {}", keys.join(", "))
        }
        Place::Point { table, index } => {
            format!("{input}, {} {table}, i = {index}", word(t("tabla", "table")))
        }
        Place::Block { program, line } => {
            format!("{input}, {} {program}, {} {line}", word(t("programa", "program")), word(t("línea", "line")))
        }
        Place::Subprogram { file, line, columns } => {
            let file = printable(file);
            let column = columns.first().map_or(String::new(), |column| format!(":{column}"));
            format!("{input}, {} {file}:{line}{column}", word(t("subprograma", "subprogram")))
        }
        Place::Beside { file, line: None, .. } => printable(file),
        Place::Beside { file, line: Some(line), columns } => on_line(&printable(file), *line, columns),
        Place::Line { line, columns } => on_line(input, *line, columns),
    }
}

/// A line of a file as compilers and editors write it.
fn on_line(file: &str, line: usize, columns: &[usize]) -> String {
    match columns.first() {
        Some(column) => format!("{file}:{line}:{column}"),
        None => format!("{file}:{line}"),
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
    use super::super::rules::{ControlRunning, LeftFromEarlier};
    use super::*;
    use crate::finding::Raise;
    use crate::finding::sample::{Noted, Stopped};

    fn plain(finding: &Finding, language: Language, width: Option<usize>) -> String {
        anstream::adapter::strip_str(&one(finding, "impeller.xlsx".into(), language, width)).to_string()
    }

    fn thick(sheet: &str) -> Finding {
        let what = t(
            "el espesor e es 12 mm y debe ser menor que 9.71 mm con 4 álabes",
            "blade thickness e is 12 mm, must be below 9.71 mm for 4 blades",
        );
        let todo = t("menos álabes", "fewer blades, a thinner blade, or a smaller tool");
        Stopped { what, todo }.at(Place::Cells(vec![CellPlace { sheet: sheet.into(), cell: "C9".into() }]))
    }

    #[test]
    fn a_finding_has_three_parts() {
        assert_eq!(
            plain(&thick("DATOS").with("12 mm", "9.71 mm"), Language::En, None),
            "error T9001: blade thickness e is 12 mm, must be below 9.71 mm for 4 blades\n  --> impeller.xlsx, sheet \
             \"DATOS\", cell C9\nhint: fewer blades, a thinner blade, or a smaller tool\n"
        );
        assert!(plain(&thick("DATOS"), Language::Es, None).contains("--> impeller.xlsx, hoja \"DATOS\", celda C9\n"));
    }

    #[test]
    fn a_finding_of_a_row_carries_its_code_behind_the_word_of_its_grade() {
        let path = || "a.xlsx".to_owned();
        let finding = LeftFromEarlier { path: path() }.at(Place::File);
        assert!(plain(&finding, Language::En, None).starts_with("caution U0115: a.xlsx is left"));
        assert!(plain(&finding, Language::Es, None).starts_with("precaución U0115: a.xlsx queda"));
        let finding = finding.graded(Grade::Stop);
        assert!(plain(&finding, Language::Es, None).starts_with("error U0115: "));
        let finding = ControlRunning {}.at(Place::File);
        assert!(plain(&finding, Language::En, None).starts_with("note U0132: if LinuxCNC"));
        assert!(plain(&finding, Language::Es, None).starts_with("nota U0132: si LinuxCNC"));
    }

    #[test]
    fn a_range_is_named_once_where_the_sentence_has_both_ends() {
        for (what, told) in [
            ("R is -25 mm; it must be from 5 to 1000 mm", "R is -25 mm; it must be from 5 to 1000 mm\n"),
            ("R is 5.5 mm of 1000 mm", "R is 5.5 mm of 1000 mm (limit 5 … 1000 mm)\n"),
            ("R is -5 mm of 1000 mm", "R is -5 mm of 1000 mm (limit 5 … 1000 mm)\n"),
        ] {
            let finding = Noted { what: Text::same(what) }.at(Place::File).with("", "5 … 1000 mm");
            let shown = plain(&finding, Language::En, None);
            assert!(shown.contains(told), "{shown}");
        }
    }

    #[test]
    fn value_and_limit_are_named_once() {
        let finding = Noted { what: t("cierre", "closure") }.at(Place::File).with("0.000 mm", "0.001 mm");
        assert!(plain(&finding, Language::En, None).starts_with("note T9003: closure: 0.000 mm (limit 0.001 mm)\n"));
    }

    #[test]
    fn how_often_something_was_seen_is_said_in_words() {
        let finding = Noted { what: t("X negativa", "negative X") }.at(Place::File).repeated(2);
        assert!(plain(&finding, Language::En, None).starts_with("note T9003: negative X, 2 times\n"));
        assert!(plain(&finding, Language::Es, None).starts_with("nota T9003: X negativa, 2 veces\n"));
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
        let mut findings = vec![Noted { what: t("leve", "slight") }.at(Place::File); 60];
        findings.push(thick("DATOS"));
        let text = list(&findings, |_| true, "impeller.xlsx".into(), Language::En, None);
        let text = anstream::adapter::strip_str(&text).to_string();
        assert!(text.starts_with("error T9001: blade"));
        assert_eq!(text.matches("note T9003: slight").count(), 49);
        assert!(text.ends_with("… 50 of 61 are shown\n"));
    }
}
