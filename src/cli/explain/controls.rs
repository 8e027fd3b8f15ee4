//! `explain --controls`: what each control reads, refuses and writes, from the data of the controls alone.

use std::fmt::Write as _;

use anstyle::Style;

use super::markdown::{headed, plain, write_head};
use crate::cli::finding::wrapped;
use crate::gcode::code::{G, M};
use crate::gcode::control::{ALL, CODE_LIMIT, Class, Control, code_name};
use crate::text::{Language, Text, t};

/// The greatest M code that a control may know.
const GREATEST_MACHINE_CODE: u32 = 9999;

/// A row: what it is of, and what each control makes of it; `None` where it knows no such thing.
struct Row {
    of: Text,
    cells: [Option<Text>; ALL.len()],
}

/// A table of rows under its title.
struct Chapter {
    title: Text,
    of: Text,
    rows: Vec<Row>,
}

fn features() -> Vec<Row> {
    let mut controls = ALL.map(|control| control.features().into_iter());
    let row = || {
        let row = controls.each_mut().map(Iterator::next);
        let of = row.iter().flatten().next()?.of.clone();
        Some(Row { of, cells: row.map(|feature| feature.map(|feature| feature.does)) })
    };
    std::iter::from_fn(row).collect()
}

fn g_codes() -> Vec<Row> {
    let row = |tenths| {
        let codes = ALL.map(|control| control.codes.get(tenths));
        let known = codes.iter().any(Option::is_some);
        known.then(|| Row { of: Text::same(code_name(tenths)), cells: codes.map(|code| code.map(G::told)) })
    };
    (0..CODE_LIMIT).filter_map(row).collect()
}

/// M codes; those that follow one another and mean the same to every control share a row.
fn m_codes() -> Vec<Row> {
    let mut runs: Vec<([u32; 2], [Option<M>; ALL.len()])> = Vec::new();
    for number in 0..=GREATEST_MACHINE_CODE {
        let codes = ALL.map(|control| (control.machine_code)(number));
        match runs.last_mut() {
            Some(([_, last], same)) if *same == codes => *last = number,
            _ => runs.push(([number; 2], codes)),
        }
    }
    let named =
        |[first, last]: [u32; 2]| if first == last { format!("M{first}") } else { format!("M{first}–M{last}") };
    let row = |(numbers, codes): ([u32; 2], [Option<M>; ALL.len()])| {
        let known = codes.iter().any(Option::is_some);
        known.then(|| Row { of: Text::same(named(numbers)), cells: codes.map(|code| code.map(M::told)) })
    };
    runs.into_iter().filter_map(row).collect()
}

fn chapters() -> [Chapter; 3] {
    [
        Chapter { title: t("Comportamiento", "Behaviour"), of: t("qué", "what"), rows: features() },
        Chapter { title: t("Códigos G", "G codes"), of: t("código", "code"), rows: g_codes() },
        Chapter { title: t("Códigos M", "M codes"), of: t("código", "code"), rows: m_codes() },
    ]
}

fn sources() -> Text {
    t("Fuentes", "Sources")
}

/// Every control on one page in Markdown.
#[must_use]
pub fn controls(language: Language) -> String {
    let title = t("Los controles", "The controls");
    let about = t(
        "Lo que cada control lee, rechaza y escribe, tomado de sus datos. Una casilla vacía significa que el control no conoce el código: rodete rechaza el programa que lo lleve. Esta página es la salida de `rodete explain --controls --markdown --lang es`.",
        "What each control reads, rejects and writes, from its data. An empty cell means that rodete does not know the code on that control, and rejects a program that contains it. This page is the output of `rodete explain --controls --markdown --lang en`.",
    );
    let mut page = headed(&title, &about, language);
    for Chapter { title, of, rows } in chapters() {
        let _ = write!(page, "\n## {}\n", title.get(language));
        // All controls side by side are wider than a page of a book.
        for class in Class::ALL {
            let _ = write!(page, "\n### {}: {}\n", title.get(language), class.machines().get(language));
            write_table(&mut page, class, &of, &rows, language);
        }
    }
    let _ = writeln!(page, "\n## {}", sources().get(language));
    for control in ALL {
        let _ = writeln!(page, "\n### {}\n", control.name);
        for source in control.sources {
            let _ = writeln!(page, "- {}", plain(source.told().get(language)));
        }
    }
    page
}

/// The rows of the controls of a class; those of which none of them knows are left out.
fn write_table(page: &mut String, class: Class, of: &Text, rows: &[Row], language: Language) {
    let own = |control: &&&'static Control| control.class == class;
    let head: Vec<_> =
        std::iter::once(of.get(language)).chain(ALL.iter().filter(own).map(|control| control.name)).collect();
    write_head(page, &format!("| {} |", vec!["---"; head.len()].join(" | ")), &head);
    for Row { of, cells } in rows {
        let cells: Vec<_> = ALL.iter().zip(cells).filter(|(control, _)| own(control)).map(|(_, cell)| cell).collect();
        if cells.iter().all(|cell| cell.is_none()) {
            continue;
        }
        let cells = cells.iter().map(|cell| cell.as_ref().map_or_else(String::new, |text| plain(text.get(language))));
        let cells: Vec<_> = std::iter::once(plain(of.get(language))).chain(cells).collect();
        let _ = writeln!(page, "| {} |", cells.join(" | "));
    }
}

/// The same for a terminal: under each feature the controls that do the same stand together.
pub(super) fn told(language: Language, width: Option<usize>) -> String {
    let bold = Style::new().bold();
    let mut text = String::new();
    for Chapter { title, rows, .. } in chapters() {
        let _ = writeln!(text, "{bold}{}{bold:#}", title.get(language));
        for Row { of, cells } in rows {
            let _ = writeln!(text, "  {}", of.get(language));
            let mut alike: Vec<(&Text, Vec<&str>)> = Vec::new();
            for (control, cell) in ALL.iter().zip(&cells) {
                let Some(cell) = cell else { continue };
                match alike.iter_mut().find(|(text, _)| *text == cell) {
                    Some((_, names)) => names.push(control.name),
                    None => alike.push((cell, vec![control.name])),
                }
            }
            for (cell, names) in alike {
                text.push_str(&wrapped(&format!("    {}: {}", names.join(", "), cell.get(language)), 6, width));
            }
        }
    }
    let _ = writeln!(text, "{bold}{}{bold:#}", sources().get(language));
    for control in ALL {
        let _ = writeln!(text, "  {}", control.name);
        for source in control.sources {
            text.push_str(&wrapped(&format!("    {}", source.told().get(language)), 6, width));
        }
    }
    text
}
