//! The findings of an outcome as a table, for sheets and reports.

use crate::finding::{Finding, Grade, Place};
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
        name: t("Comprobaciones", "Checks"),
        title: t("Comprobaciones", "Checks"),
        source: summary(findings),
        index: Index::None,
        print: Print::No,
        columns: vec![
            column(t("Grado", "Grade"), |finding| finding.grade.name()),
            column(t("Código", "Code"), |finding| Text::same(finding.code())),
            column(t("Lugar", "Place"), |finding| place(&finding.place)),
            column(t("Comprobación", "Check"), |finding| finding.what.clone()),
            column(t("Valor", "Value"), |finding| Text::same(finding.value.as_str())),
            column(t("Límite", "Limit"), |finding| Text::same(finding.limit.as_str())),
            column(t("Remedio", "Remedy"), |finding| finding.remedy.clone()),
        ],
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
        line([
            ["parada", "paradas"],
            ["precaución", "precauciones"],
            ["nota o comprobación superada", "notas o comprobaciones superadas"],
        ]),
        line([["stop", "stops"], ["caution", "cautions"], ["note or passed check", "notes or passed checks"]]),
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
            let list = |language: Language| {
                let mut sheet = None;
                let mut list = String::new();
                for cell in cells {
                    if !list.is_empty() {
                        list.push_str(", ");
                    }
                    if sheet != Some(&cell.sheet) {
                        list.push_str(&cell.sheet);
                        list.push_str(match language {
                            Language::Es => ", celda ",
                            Language::En => ", cell ",
                        });
                        sheet = Some(&cell.sheet);
                    }
                    list.push_str(&cell.cell);
                }
                list
            };
            Text::new(list(Language::Es), list(Language::En))
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
        Place::Line { line, columns } => {
            Text::new(on_line("Línea", *line, "columna", columns), on_line("Line", *line, "column", columns))
        }
    }
}

/// A line and its columns.
fn on_line(word: &str, line: usize, before: &str, columns: &[usize]) -> String {
    let columns = columns.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
    if columns.is_empty() { format!("{word} {line}") } else { format!("{word} {line}, {before} {columns}") }
}

#[cfg(test)]
mod tests {
    use super::{place, summary};
    use crate::finding::sample::{Noted, Stopped};
    use crate::finding::{CellPlace, Place, Raise};
    use crate::text::Text;

    fn cell(sheet: &str, cell: &str) -> CellPlace {
        CellPlace { sheet: sheet.to_owned(), cell: cell.to_owned() }
    }

    #[test]
    fn cells_of_one_sheet_are_listed_under_its_name() {
        let cells = Place::Cells(vec![cell("DATOS", "C9"), cell("DATOS", "C12"), cell("CALIBRACION", "C5")]);
        assert_eq!(place(&cells).es, "DATOS, celda C9, C12, CALIBRACION, celda C5");
        assert_eq!(place(&cells).en, "DATOS, cell C9, C12, CALIBRACION, cell C5");
    }

    #[test]
    fn findings_are_counted_by_grade() {
        let text = || Text::same("x");
        let note = || Noted { what: text() }.at(Place::File);
        let findings = [Stopped { what: text(), todo: text() }.at(Place::File), note(), note()];
        assert_eq!(summary(&findings).en, "1 stop, 0 cautions, 2 notes or passed checks");
        assert_eq!(summary(&findings).es, "1 parada, 0 precauciones, 2 notas o comprobaciones superadas");
    }
}
