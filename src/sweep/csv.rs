//! Rows as comma-separated values (RFC 4180, lines end with a line feed).

use std::fmt::Write as _;

use crate::number::decimal;
use crate::sweep::table::{Cells, Table};

/// The names of the columns, as a line.
#[must_use]
pub fn head(table: &Table) -> String {
    let names: Vec<String> = table.columns.iter().map(|one| quoted(&one.name)).collect();
    names.join(",") + "\n"
}

/// The rows, one a line; an empty cell is nothing between two commas.
#[must_use]
pub fn rows(table: &Table) -> String {
    let mut text = String::new();
    for row in 0..table.rows() {
        for (at, column) in table.columns.iter().enumerate() {
            if at > 0 {
                text.push(',');
            }
            match &column.cells {
                Cells::Whole(cells) => {
                    if let Some(Some(whole)) = cells.get(row) {
                        let _ = write!(text, "{whole}");
                    }
                }
                Cells::Number(cells) => {
                    cells.get(row).into_iter().flatten().for_each(|one| text.push_str(&decimal(*one)))
                }
                Cells::Text(cells) => {
                    cells.get(row).into_iter().flatten().for_each(|one| text.push_str(&quoted(one)));
                }
                Cells::Truth(cells) => {
                    cells
                        .get(row)
                        .into_iter()
                        .flatten()
                        .for_each(|one| text.push_str(if *one { "true" } else { "false" }));
                }
            }
        }
        text.push('\n');
    }
    text
}

fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}
