//! A row of the findings as text.

use std::fmt::Write;

use anstyle::Style;

use super::cells::Cells;
use super::told::{self, ShownFinding};
use crate::cli::finding::wrapped;
use crate::escape::printable;
use crate::finding::{AlarmFamily, Example, Grade, Rule};
use crate::kind::Kind;
use crate::text::{Language, Text, t};

/// Before a sentence whose figures and names are those of an example.
pub(super) static FOR_EXAMPLE: Text = t("por ejemplo", "for example");

/// Grade and alarms of a row.
pub(super) fn graded(rule: &Rule, language: Language) -> String {
    let alarm = |(family, number): &(AlarmFamily, u16)| {
        format!(", {} {}", t("alarma", "alarm").get(language), family.shown(*number))
    };
    let alarm: String = rule.alarm.iter().map(alarm).collect();
    let grade = match rule.grade {
        Grade::Stop => t("parada", "stop"),
        Grade::Caution => t("precaución", "caution"),
        Grade::Note => t("nota", "note"),
    };
    format!("{}{alarm}", grade.get(language))
}

/// A row, explained; its sentences are broken at the width of the terminal, its example is not.
pub(super) fn told(rule: &Rule, kinds: &[&dyn Kind], language: Language, width: Option<usize>) -> String {
    let bold = Style::new().bold();
    let head = format!("{bold}{} {}{bold:#} ({})", rule.code, rule.name(), graded(rule, language));
    static NONE: Text = t("", "");
    let ShownFinding { what, remedy, example } = told::of(rule);
    let mut text = wrapped(&head, 2, width);
    let mut sentence = |name: &Text, of: &Text| {
        let name = if name.is_empty() { String::new() } else { format!("{}: ", name.get(language)) };
        text.push_str(&wrapped(&format!("  {name}{}", of.get(language)), 4, width));
    };
    sentence(if example { &FOR_EXAMPLE } else { &NONE }, &what);
    sentence(&t("por qué", "why"), &rule.why);
    if !remedy.is_empty() {
        sentence(&t("remedio", "remedy"), &remedy);
    }
    shown(&mut text, rule, kinds, language);
    text
}

/// The example of a row.
pub(super) fn shown(text: &mut String, rule: &Rule, kinds: &[&dyn Kind], language: Language) {
    match &rule.example {
        Example::Turning { control, stock, program, machine } => {
            let cells = Cells::of(kinds, crate::kinds::lathe::parameters::FORM.kind, language);
            let given: String = machine.iter().map(|cell| format!(", {}", typed(*cell, &cells, language))).collect();
            let head = t("ejemplo", "example");
            let _ = writeln!(text, "  {} ({control}, {stock}{given}):", head.get(language));
            blocks(text, program);
        }
        Example::Slip { kind, cells, program, from, to } => {
            let form = Cells::of(kinds, kind, language);
            let given: String = cells.iter().map(|cell| format!(", {}", typed(*cell, &form, language))).collect();
            let head = t("ejemplo", "example");
            let _ = writeln!(text, "  {} ({kind}, {program}{given}):", head.get(language));
            if from.is_empty() {
                let _ = writeln!(
                    text,
                    "    {}",
                    t("el programa como se escribe", "the program as it is written").get(language)
                );
            } else {
                let _ = writeln!(text, "    {from} → {to}");
            }
        }
        Example::Program { control, program, given, .. } => {
            let given: String = given.iter().map(|(option, value)| format!(", {option} {value}")).collect();
            let head = t("ejemplo", "example");
            let _ = writeln!(text, "  {} ({control}{given}):", head.get(language));
            blocks(text, program);
        }
        Example::Repeated { control, word, times } => {
            let head = t("ejemplo", "example");
            let often = t("repetido, veces", "repeated, times");
            let _ = writeln!(text, "  {} ({control}; {}: {times}):", head.get(language), often.get(language));
            blocks(text, word);
        }
        Example::Workbook { kind, cells } => {
            let form = Cells::of(kinds, kind, language);
            let given: Vec<String> = cells.iter().map(|cell| typed(*cell, &form, language)).collect();
            let (head, book) = (t("ejemplo", "example"), t("el libro de rodete new", "the workbook of rodete new"));
            let given = if given.is_empty() { String::new() } else { format!(" ({})", given.join(", ")) };
            let sweep = if cells.iter().any(|(place, _)| place.starts_with("SWEEP!")) { " --sweep" } else { "" };
            let _ = writeln!(text, "  {}: {} {kind}{sweep}{given}", head.get(language), book.get(language));
        }
        Example::Command { files, words } => {
            let quoted = |word: &&str| if word.contains(' ') { format!("\"{word}\"") } else { (*word).to_owned() };
            let line: Vec<String> = words.iter().map(quoted).collect();
            let _ = writeln!(text, "  {}: rodete {}", t("ejemplo", "example").get(language), line.join(" "));
            for (name, lines) in *files {
                let _ = writeln!(text, "    {name}:");
                for line in lines.split('|') {
                    let _ = writeln!(text, "      {}", printable(line));
                }
            }
        }
        Example::Made { how, .. } => {
            let _ = writeln!(text, "  {}: {}", t("ejemplo", "example").get(language), how.get(language));
        }
        Example::Never(why) => {
            let _ = writeln!(text, "  {}: {}", t("sin ejemplo", "no example").get(language), why.get(language));
        }
    }
}

/// What is typed into a cell of an example.
fn typed((place, text): (&str, &str), cells: &Cells, language: Language) -> String {
    let (place, text) = cells.spoken(place, text);
    let text = printable(&text);
    match place.split_once(':') {
        Some((symbol, "unit")) => format!("{} {symbol} = {text}", t("unidad de", "unit of").get(language)),
        Some((symbol, _)) => format!("{symbol} → {text}"),
        None => format!("{place} = {text}"),
    }
}

/// The lines of an example's program.
fn blocks(text: &mut String, program: &str) {
    for block in program.split('|') {
        let _ = writeln!(text, "    {}", printable(block));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::explain::rows;
    use crate::kinds::KINDS;

    #[test]
    fn an_example_shows_no_notes_of_the_tests() {
        let mut seen = 0;
        for rule in rows(KINDS) {
            let mut text = String::new();
            shown(&mut text, rule, KINDS, Language::En);
            assert!(!text.contains("; expected:") && !text.contains("; rs274:"), "{}: {text}", rule.code);
            seen += usize::from(!text.is_empty());
        }
        assert!(seen > 500, "{seen} rows");
    }
}
