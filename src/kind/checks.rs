//! The findings of an outcome, for sheets and reports: the verdict in words, and the table of all.

use crate::finding::{CellPlace, Finding, Grade, Place};
use crate::proof::check::Check;
use crate::table::{Column, Index, Law, Print, Table};
use crate::text::{Language, Text, t};

/// The table of all findings, in their order: grade, code, place, what, value, limit, remedy.
#[must_use]
pub fn table(findings: &[Finding]) -> Table {
    let column = |symbol: Text, entry: fn(&Finding) -> Text| {
        Column::texts(symbol, Law::None, findings.iter().map(entry).collect())
    };
    Table {
        key: "checks",
        name: t("Avisos", "Findings"),
        title: t("Avisos", "Findings"),
        source: summary(findings),
        index: Index::None,
        print: Print::No,
        columns: vec![
            column(t("Grado", "Grade"), |finding| finding.grade.name()),
            column(t("Código", "Code"), |finding| Text::same(finding.code())),
            column(t("Lugar", "Place"), |finding| place(&finding.place)),
            column(t("Aviso", "Finding"), |finding| finding.what.clone()),
            column(t("Valor", "Value"), |finding| shown(finding, 0)),
            column(t("Límite", "Limit"), |finding| shown(finding, 1)),
            column(t("Remedio", "Remedy"), |finding| finding.remedy.clone()),
        ],
    }
}

/// Value or limit of a finding.
fn shown(finding: &Finding, at: usize) -> Text {
    let [es, en] = [Language::Es, Language::En].map(|language| finding.shown(language)[at].to_owned());
    Text::new(es, en)
}

/// Whether what came out may be used, in words without a full stop, and the grade of it.
#[must_use]
pub fn verdict<'f>(stopped: bool, found: impl IntoIterator<Item = &'f Finding>) -> (Text, Grade) {
    if stopped {
        return (
            t("Rechazado: rodete no entrega ningún programa", "Rejected: rodete delivers no program"),
            Grade::Stop,
        );
    }
    match found.into_iter().filter(|finding| finding.grade == Grade::Caution).count() {
        0 => (t("Sin precauciones", "No cautions"), Grade::Note),
        1 => {
            (t("1 precaución: léala antes del primer corte", "1 caution: read it before the first cut"), Grade::Caution)
        }
        many => (
            Text::new(
                format!("{many} precauciones: léalas antes del primer corte"),
                format!("{many} cautions: read them before the first cut"),
            ),
            Grade::Caution,
        ),
    }
}

/// How many checks the programs passed that were read back, as a sentence; empty where they were asked none.
#[must_use]
pub fn passed(checks: &[Check]) -> Text {
    match checks.iter().filter(|check| check.grade().is_none()).count() {
        0 => t("", ""),
        1 => t(
            "rodete ha releído lo que ha escrito: 1 comprobación superada.",
            "rodete read back what it wrote: 1 check passed.",
        ),
        many => Text::new(
            format!("rodete ha releído lo que ha escrito: {many} comprobaciones superadas."),
            format!("rodete read back what it wrote: {many} checks passed."),
        ),
    }
}

/// How many findings there are of each grade, as a line to read.
#[must_use]
pub fn summary(findings: &[Finding]) -> Text {
    let count = |grade: Grade| findings.iter().filter(|finding| finding.grade == grade).count();
    let (stops, cautions, notes) = (count(Grade::Stop), count(Grade::Caution), count(Grade::Note));
    let line = |words: [[&str; 2]; 3]| {
        [stops, cautions, notes]
            .iter()
            .zip(words)
            .map(|(count, [one, many])| format!("{count} {}", if *count == 1 { one } else { many }))
            .collect::<Vec<_>>()
            .join(", ")
    };
    Text::new(
        line([["parada", "paradas"], ["precaución", "precauciones"], ["nota", "notas"]]),
        line([["stop", "stops"], ["caution", "cautions"], ["note", "notes"]]),
    )
}

/// A place in words.
#[must_use]
pub fn place(place: &Place) -> Text {
    match place {
        Place::File => t("Libro", "Workbook"),
        Place::Part(part) => Text::same(part.as_str()),
        Place::Sheet(sheet) => Text::new(format!("Hoja {sheet}"), format!("Sheet {sheet}")),
        Place::Cells(cells) => {
            let list = |[one, many]: [&str; 2]| {
                let of_sheet = |cells: &[CellPlace]| {
                    let sheet = cells.first().map_or("", |cell| cell.sheet.as_str());
                    let listed: Vec<&str> = cells.iter().map(|cell| cell.cell.as_str()).collect();
                    format!("{sheet}, {} {}", if cells.len() == 1 { one } else { many }, listed.join(", "))
                };
                cells.chunk_by(|a, b| a.sheet == b.sheet).map(of_sheet).collect::<Vec<_>>().join("; ")
            };
            Text::new(list(["celda", "celdas"]), list(["cell", "cells"]))
        }
        Place::Parameters(keys) => Text::same(keys.join(", ")),
        Place::Point { table, index } => {
            Text::new(format!("{table}, punto {index}"), format!("{table}, point {index}"))
        }
        Place::Block { program, line } => {
            Text::new(format!("Programa {program}, línea {line}"), format!("Program {program}, line {line}"))
        }
        Place::Subprogram { file, line, columns } => Text::new(
            format!("Subprograma {file}, {}", on_line("línea", *line, "columna", columns)),
            format!("Subprogram {file}, {}", on_line("line", *line, "column", columns)),
        ),
        Place::Beside { file, line: None, .. } => Text::same(file.as_str()),
        Place::Beside { file, line: Some(line), columns } => Text::new(
            format!("{file}, {}", on_line("línea", *line, "columna", columns)),
            format!("{file}, {}", on_line("line", *line, "column", columns)),
        ),
        Place::Line { line, columns } => {
            Text::new(on_line("Línea", *line, "columna", columns), on_line("Line", *line, "column", columns))
        }
    }
}

fn on_line(word: &str, line: usize, before: &str, columns: &[usize]) -> String {
    let columns = columns.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
    if columns.is_empty() { format!("{word} {line}") } else { format!("{word} {line}, {before} {columns}") }
}

#[cfg(test)]
mod tests {
    use super::{place, summary, verdict};
    use crate::finding::sample::{Cautioned, Noted, Stopped};
    use crate::finding::{CellPlace, Grade, Place, Raise};
    use crate::text::Text;

    fn cell(sheet: &str, cell: &str) -> CellPlace {
        CellPlace { sheet: sheet.to_owned(), cell: cell.to_owned() }
    }

    #[test]
    fn cells_of_one_sheet_are_listed_under_its_name() {
        let cells = Place::Cells(vec![cell("DATOS", "C9"), cell("DATOS", "C12"), cell("CALIBRACION", "C5")]);
        assert_eq!(place(&cells).es, "DATOS, celdas C9, C12; CALIBRACION, celda C5");
        assert_eq!(place(&cells).en, "DATOS, cells C9, C12; CALIBRACION, cell C5");
    }

    #[test]
    fn the_verdict_counts_the_cautions_and_a_stop_comes_before_them() {
        let text = || Text::same("x");
        let caution = || Cautioned { what: text(), todo: text() }.at(Place::File);
        let note = Noted { what: text() }.at(Place::File);
        let said = |stopped, found: &[_]| {
            let (words, grade) = verdict(stopped, found);
            (words.en.into_owned(), grade)
        };
        assert_eq!(said(false, &[note]), ("No cautions".to_owned(), Grade::Note));
        assert_eq!(said(false, &[caution()]).0, "1 caution: read it before the first cut");
        let two = [caution(), caution()];
        assert_eq!(said(false, &two), ("2 cautions: read them before the first cut".to_owned(), Grade::Caution));
        assert_eq!(said(true, &two), ("Rejected: rodete delivers no program".to_owned(), Grade::Stop));
    }

    #[test]
    fn findings_are_counted_by_grade() {
        let text = || Text::same("x");
        let note = || Noted { what: text() }.at(Place::File);
        let findings = [Stopped { what: text(), todo: text() }.at(Place::File), note(), note()];
        assert_eq!(summary(&findings).en, "1 stop, 0 cautions, 2 notes");
        assert_eq!(summary(&findings).es, "1 parada, 0 precauciones, 2 notas");
    }
}
