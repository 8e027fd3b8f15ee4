//! A verdict as a person reads it.

use anstyle::{AnsiColor, Style};

use super::delivery::{REPORT, RESULTS, SETUP};
use super::terminal::Terminal;
use super::verdict::Verdict;
use super::{finding, quantity};
use crate::escape::printable_path;
use crate::finding::{Exit, Finding, Grade, Place};
use crate::text::{Language, Text, t};

/// Prints what is to say about one workbook: derived values, findings, files, and a closing line. What needs
/// attention, stops and cautions, goes to standard error, the rest to standard output. `writes`: the command is one that
/// writes files.
pub(super) fn verdict(verdict: &Verdict, writes: bool, language: Language, terminal: &mut Terminal) {
    let workbook = printable_path(&verdict.workbook);
    let width = terminal.width;
    let bold = Style::new().bold();
    if let Some(schema) = verdict.schema {
        let sha256 = short(verdict.sha256.as_deref().unwrap_or_default());
        terminal.out(&format!("{bold}{workbook}{bold:#}  {schema}  SHA-256 {sha256}\n"));
        terminal.out(&quantity::table(&verdict.quantities, language, width));
    }
    finding::faults(&verdict.findings, &workbook, language, terminal);
    finding::notes(&verdict.findings, &workbook, language, terminal);
    terminal.out(&files(verdict));
    let closing = closing(verdict, writes, &workbook, language);
    let program = terminal.program.clone();
    terminal.next(|| next(verdict, writes, [&program, &workbook], language));
    if matches!(verdict.exit, Exit::Done | Exit::ReportFailed) {
        terminal.out(&closing)
    } else {
        terminal.err(&closing)
    }
}

/// The files with size and SHA-256, one a line.
pub(super) fn files(verdict: &Verdict) -> String {
    let longest =
        verdict.files.iter().map(|file| textwrap::core::display_width(&printable_path(&file.path))).max().unwrap_or(0);
    verdict
        .files
        .iter()
        .map(|file| {
            let name = printable_path(&file.path);
            let blanks = " ".repeat(longest - textwrap::core::display_width(&name));
            format!("  {name}{blanks}  {:>9}  SHA-256 {}\n", size(file.bytes), short(&file.sha256))
        })
        .collect()
}

fn closing(verdict: &Verdict, writes: bool, workbook: &str, language: Language) -> String {
    let colour = match verdict.exit {
        Exit::Done if verdict.count(Grade::Caution) == 0 => AnsiColor::Green,
        Exit::Done | Exit::ReportFailed => AnsiColor::Yellow,
        _ => AnsiColor::Red,
    };
    let style = Style::new().bold().fg_color(Some(colour.into()));
    let folder = verdict.folder.as_deref().map(printable_path).unwrap_or_default();
    let count = verdict.files.iter().filter(|file| !verdict.is_beside(&file.path)).count();
    let (es, en) = match verdict.book() {
        Some(book) => {
            (format!(", resultados en {}", printable_path(book)), format!(", results in {}", printable_path(book)))
        }
        None => Default::default(),
    };
    let report = verdict.files.iter().any(|file| file.name.to_string_lossy().ends_with(REPORT));
    let end = match (verdict.exit, count) {
        (Exit::Done, 0) if !writes => t("se puede generar", "can be built"),
        (Exit::Done, _) => {
            Text::new(format!("{count} archivos en {folder}{es}"), format!("{count} files in {folder}{en}"))
        }
        (Exit::ReportFailed, _) if report => Text::new(
            format!("{count} archivos en {folder}{es}, sin todas las plantillas en PDF"),
            format!("{count} files in {folder}{en}, without all templates in PDF"),
        ),
        (Exit::ReportFailed, _) => Text::new(
            format!("{count} archivos en {folder}{es}, sin informe"),
            format!("{count} files in {folder}{en}, without a report"),
        ),
        _ if !writes => t("no se puede generar", "cannot be built"),
        (Exit::Refused, _) => t("rechazado; no se ha escrito nada", "rejected; nothing was written"),
        _ => t("no se ha escrito nada", "nothing was written"),
    };
    let found: Vec<_> = [
        (Grade::Stop, t("error", "error"), t("errores", "errors")),
        (Grade::Caution, t("precaución", "caution"), t("precauciones", "cautions")),
        (Grade::Note, t("nota", "note"), t("notas", "notes")),
    ]
    .into_iter()
    .filter_map(|(grade, one, many)| match verdict.count(grade) {
        0 => None,
        1 => Some(format!("1 {}", one.get(language))),
        count => Some(format!("{count} {}", many.get(language))),
    })
    .collect();
    let found = if found.is_empty() { String::new() } else { format!(" ({})", found.join(", ")) };
    format!("{style}{workbook}{style:#}: {}{found}\n", end.get(language))
}

/// True of a stop that names cells or parameters.
fn in_cells(finding: &Finding) -> bool {
    finding.grade == Grade::Stop && matches!(finding.place, Place::Cells(_) | Place::Parameters(_))
}

/// What to do now, with the name of the binary and that of the workbook.
fn next(verdict: &Verdict, writes: bool, [program, workbook]: [&str; 2], language: Language) -> String {
    let written = |ending: &str| {
        let file = verdict.files.iter().find(|file| file.name.to_string_lossy().ends_with(ending));
        file.map(|file| printable_path(&file.path))
    };
    let cautions = match verdict.count(Grade::Caution) {
        0 => t("", ""),
        _ => t("atienda las precauciones; ", "see to the cautions; "),
    };
    let results = || written(RESULTS).or_else(|| verdict.book().map(printable_path));
    let next = match (verdict.exit, written(REPORT).or_else(results)) {
        (Exit::Done | Exit::ReportFailed, Some(file)) => {
            let sheet = written(SETUP);
            let [es, en] = sheet.map_or_else(Default::default, |sheet| {
                [format!("lleve {sheet} a la máquina; "), format!("take {sheet} to the machine; ")]
            });
            Text::new(
                format!("{}lea {file}; {es}antes de cortar, una prueba en vacío", cautions.es),
                format!("{}read {file}; {en}make a dry run before you cut", cautions.en),
            )
        }
        (Exit::Done, None) if !writes => {
            let word =
                if workbook.contains(char::is_whitespace) { format!("\"{workbook}\"") } else { workbook.to_owned() };
            let into = if verdict.put_in { " --into" } else { "" };
            let [es, en] = [cautions.es, cautions.en].map(|first| format!("{first}{program} build {word}{into}"));
            Text::new(es, en)
        }
        (Exit::Refused, _) if !verdict.findings.iter().any(in_cells) => {
            t("siga las sugerencias de arriba", "follow the hints above")
        }
        (Exit::Refused, _) => t(
            "corrija las celdas indicadas, guarde el libro y repita",
            "correct the cells named above, save the workbook and run this again",
        ),
        _ => return String::new(),
    };
    format!("{}: {}\n", t("después", "next").get(language), next.get(language))
}

/// The first characters of a SHA-256.
pub(super) fn short(sha256: &str) -> &str {
    sha256.get(..16).unwrap_or(sha256)
}

/// A size with a unit, at least three digits.
fn size(bytes: u64) -> String {
    match bytes {
        0..10_000 => format!("{bytes} B"),
        10_000..10_000_000 => format!("{} kB", bytes.div_ceil(1000)),
        _ => format!("{} MB", bytes.div_ceil(1_000_000)),
    }
}
