//! `explain`: what a code means, why it is reported, what to do, and an example that raises it.

use std::fmt::Write;

use super::args::Explain;
use super::controls;
use super::locale::spoken;
use super::refused;
use super::rules::{self, NoSuchCode};
use super::terminal::Terminal;
use super::{fault, pages};
use crate::drawing;
use crate::escape::printable;
use crate::finding::{self, AlarmFamily, Example, Exit, Grade, Place, Raise, Rule};
use crate::gcode::rules::{codes, expressions, flow, geometry, lexis, modes, words};
use crate::gcode::turning::rules::{contour, corner, cycles, fagor, holes, lathe, nose};
use crate::graft;
use crate::kind::{self, Kind};
use crate::machine;
use crate::parameter;
use crate::proof;
use crate::removal::turning::rules as alarms;
use crate::report;
use crate::scene;
use crate::store;
use crate::text::{Language, Text, t};
use crate::typeset;
use crate::workbook;

/// The rows of every room below the kinds, and of the walls.
const RULES: &[&[&Rule]] = &[
    parameter::rules::RULES,
    // `simulate` is a command of every binary.
    crate::kinds::lathe::rules::RULES,
    alarms::RULES,
    corner::RULES,
    cycles::RULES,
    fagor::RULES,
    contour::RULES,
    holes::RULES,
    nose::RULES,
    lathe::RULES,
    lexis::RULES,
    expressions::RULES,
    workbook::rules::file::RULES,
    workbook::rules::package::RULES,
    workbook::rules::cell::RULES,
    workbook::rules::value::RULES,
    workbook::rules::form::RULES,
    workbook::rules::offsets::RULES,
    machine::rules::RULES,
    kind::rules::RULES,
    graft::rules::RULES,
    store::rules::RULES,
    rules::RULES,
    typeset::rules::RULES,
    report::rules::RULES,
    drawing::rules::RULES,
    scene::rules::RULES,
    finding::rules::RULES,
    flow::RULES,
    proof::rules::RULES,
    geometry::RULES,
    modes::RULES,
    words::RULES,
    codes::RULES,
];

/// All rows of a binary with these kinds, by their codes: those of its rooms, and those of the kinds.
#[must_use]
pub fn rows(kinds: &[&dyn Kind]) -> Vec<&'static Rule> {
    let mut rows: Vec<_> =
        RULES.iter().chain(kinds.iter().flat_map(|kind| kind.rules())).copied().flatten().copied().collect();
    rows.sort_by_key(|rule| (rule.code, rule.ident));
    // Kinds may share rows.
    rows.dedup_by_key(|rule| (rule.code, rule.ident));
    rows
}

pub(super) fn run(arguments: &Explain, kinds: &[&dyn Kind], terminal: &mut Terminal) -> Exit {
    let language = spoken(arguments.lang, None);
    if arguments.exit_codes {
        terminal.out(&pages::exit_codes(language));
        return Exit::Done;
    }
    if arguments.parameters {
        return match pages::parameters(kinds, language) {
            Ok(page) => {
                terminal.out(&page);
                Exit::Done
            }
            Err(error) => refused(&fault::refusal(&error.to_string()), language, terminal),
        };
    }
    if arguments.controls {
        terminal.out(&if arguments.markdown { controls::controls(language) } else { controls::told(language) });
        return Exit::Done;
    }
    if arguments.all {
        let told: String = if arguments.markdown {
            reference(kinds, language)
        } else {
            rows(kinds).into_iter().map(|rule| told(rule, language)).collect()
        };
        terminal.out(&told);
        return Exit::Done;
    }
    if arguments.codes.is_empty() {
        let lines: String =
            rows(kinds).iter().map(|rule| format!("{}  {}\n", rule.code, rule.what.get(language))).collect();
        terminal.out(&lines);
        return Exit::Done;
    }
    let mut exit = Exit::Done;
    for code in &arguments.codes {
        let found: Vec<_> = rows(kinds).into_iter().filter(|rule| named(rule, code)).collect();
        if found.is_empty() {
            let refusal = NoSuchCode { code: printable(code) }.refused(Exit::CommandLine, Place::File);
            exit = refused(&refusal, language, terminal);
        }
        for rule in found {
            terminal.out(&told(rule, language));
        }
    }
    exit
}

/// True where a row is meant: by its code, whatever the case of its letter, or by the number of its alarm.
fn named(rule: &Rule, code: &str) -> bool {
    rule.code.eq_ignore_ascii_case(code)
        || rule.alarm.iter().any(|(family, number)| family.shown(*number).eq_ignore_ascii_case(code))
}

/// Every row on one page in Markdown, by its code.
#[must_use]
pub fn reference(kinds: &[&dyn Kind], language: Language) -> String {
    let title = t("Lo que rodete dice", "What rodete tells");
    let about = t(
        "Cada código con su gravedad, lo que dice, por qué, qué hacer y una entrada que lo provoca. Un código no cambia de significado ni se da dos veces. Esta página es la salida de `rodete explain --all --markdown --lang es`.",
        "Each code with its grade, what it says, why, what to do, and an input that raises it. A code never changes its meaning and is never given again. This page is the output of `rodete explain --all --markdown --lang en`.",
    );
    let mut page = format!("# {}\n\n{}\n", title.get(language), about.get(language));
    let mut room = "";
    for rule in rows(kinds) {
        let letter = rule.code.get(..1).unwrap_or_default();
        if letter != room {
            room = letter;
            let _ = write!(page, "\n## {room}: {}\n", room_of(letter).get(language));
        }
        let _ = write!(page, "\n### {} {}\n\n", rule.code, rule.name());
        let _ = writeln!(page, "**{}**: {}", graded(rule, language), plain(rule.what.get(language)));
        let _ = write!(page, "\n{}: {}\n", t("Por qué", "Why").get(language), plain(rule.why.get(language)));
        if !rule.remedy.is_empty() {
            let _ = write!(page, "\n{}: {}\n", t("Remedio", "Remedy").get(language), plain(rule.remedy.get(language)));
        }
        let mut example = String::new();
        shown(&mut example, rule, language);
        let lines: String =
            example.lines().map(|line| format!("{}\n", line.strip_prefix("  ").unwrap_or(line))).collect();
        let _ = write!(page, "\n```text\n{lines}```\n");
    }
    page
}

/// What the codes of a letter are of.
fn room_of(letter: &str) -> Text {
    match letter {
        "C" => t("el control y lo que se escribe para él", "the control, and what is written for it"),
        "G" => t("la lectura de programas", "the reading of programs"),
        "L" => t("el torno", "the lathe"),
        "P" => t("parámetros que se contradicen", "parameters that contradict each other"),
        "S" => t("el almacén de salidas", "the store of outputs"),
        "T" => t("la composición del informe", "the typesetting of the report"),
        "U" => t("el uso del comando", "the use of the command"),
        "V" => t("la verificación", "the proof"),
        "W" => t("el libro", "the workbook"),
        _ => t("rodete mismo", "rodete itself"),
    }
}

/// Text in which nothing is Markdown.
pub(super) fn plain(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for one in printable(text).chars() {
        if matches!(one, '*' | '_' | '<' | '>' | '`' | '[' | ']' | '|' | '\\' | '#') {
            shown.push('\\');
        }
        shown.push(one);
    }
    shown
}

/// Grade and alarms of a row.
fn graded(rule: &Rule, language: Language) -> String {
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

/// A row, explained.
fn told(rule: &Rule, language: Language) -> String {
    let mut text = String::new();
    let _ = writeln!(text, "{} {} ({})", rule.code, rule.name(), graded(rule, language));
    let _ = writeln!(text, "  {}", rule.what.get(language));
    let _ = writeln!(text, "  {}: {}", t("por qué", "why").get(language), rule.why.get(language));
    if !rule.remedy.is_empty() {
        let _ = writeln!(text, "  {}: {}", t("remedio", "remedy").get(language), rule.remedy.get(language));
    }
    shown(&mut text, rule, language);
    text
}

/// The example of a row.
fn shown(text: &mut String, rule: &Rule, language: Language) {
    match &rule.example {
        Example::Turning { control, stock, program, machine } => {
            let given: String = machine.iter().map(|(symbol, value)| format!(", {symbol} = {value}")).collect();
            let head = t("ejemplo", "example");
            let _ = writeln!(text, "  {} ({control}, {stock}{given}):", head.get(language));
            blocks(text, program);
        }
        Example::Slip { kind, cells, program, from, to } => {
            let given: String = cells.iter().map(|(symbol, value)| format!(", {symbol} = {value}")).collect();
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
            let given: Vec<String> = cells.iter().map(|cell| typed(*cell, language)).collect();
            let (head, book) = (t("ejemplo", "example"), t("el libro de rodete new", "the workbook of rodete new"));
            let given = if given.is_empty() { String::new() } else { format!(" ({})", given.join(", ")) };
            let _ = writeln!(text, "  {}: {} {kind}{given}", head.get(language), book.get(language));
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
fn typed((place, text): (&str, &str), language: Language) -> String {
    let text = printable(text);
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
