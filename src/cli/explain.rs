//! `explain`: what a code means, why it is told, what to do, and an example that raises it.

use std::fmt::Write;

use super::args::Explain;
use super::locale::spoken;
use super::refused;
use super::rules::{self, NoSuchCode};
use super::terminal::Terminal;
use crate::drawing;
use crate::escape::printable;
use crate::finding::{self, AlarmFamily, Example, Exit, Grade, Place, Raise, Rule};
use crate::gcode::rules::{expressions, flow, geometry, lexis, modes, words};
use crate::gcode::turning::rules::{contour, corner, cycles, fagor, holes, lathe, nose};
use crate::kind::{self, Kind};
use crate::machine;
use crate::parameter::{self, t};
use crate::removal::turning::rules as alarms;
use crate::report;
use crate::scene;
use crate::store;
use crate::text::Language;
use crate::typeset;
use crate::workbook;

/// The rows of every room below the kinds, and of the walls.
pub const RULES: &[&[&Rule]] = &[
    parameter::rules::RULES,
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
    store::rules::RULES,
    rules::RULES,
    typeset::rules::RULES,
    report::rules::RULES,
    drawing::rules::RULES,
    scene::rules::RULES,
    finding::rules::RULES,
    flow::RULES,
    geometry::RULES,
    modes::RULES,
    words::RULES,
];

/// All rows: those of the rooms below the kinds, and those of the kinds.
fn all(kinds: &[&dyn Kind]) -> impl Iterator<Item = &'static Rule> + Clone {
    RULES.iter().copied().chain(kinds.iter().map(|kind| kind.rules())).flatten().copied()
}

pub(super) fn run(arguments: &Explain, kinds: &[&dyn Kind], terminal: &mut Terminal) -> Exit {
    let language = spoken(arguments.lang, None);
    if arguments.codes.is_empty() {
        let lines: String = all(kinds).map(|rule| format!("{}  {}\n", rule.code, rule.what.get(language))).collect();
        terminal.out(&lines);
        return Exit::Done;
    }
    let mut exit = Exit::Done;
    for code in &arguments.codes {
        let found: Vec<_> = all(kinds).filter(|rule| named(rule, code)).collect();
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

/// A row, explained.
fn told(rule: &Rule, language: Language) -> String {
    let mut text = String::new();
    let alarm = |(family, number): &(AlarmFamily, u16)| {
        format!(", {} {}", t("alarma", "alarm").get(language), family.shown(*number))
    };
    let alarm: String = rule.alarm.iter().map(alarm).collect();
    let grade = match rule.grade {
        Grade::Stop => t("parada", "stop"),
        Grade::Caution => t("precaución", "caution"),
        Grade::Note => t("nota", "note"),
    };
    let _ = writeln!(text, "{} {} ({}{alarm})", rule.code, rule.name(), grade.get(language));
    let _ = writeln!(text, "  {}", rule.what.get(language));
    let _ = writeln!(text, "  {}: {}", t("por qué", "why").get(language), rule.why.get(language));
    if !rule.remedy.is_empty() {
        let _ = writeln!(text, "  {}: {}", t("remedio", "remedy").get(language), rule.remedy.get(language));
    }
    match &rule.example {
        Example::Turning { control, stock, program, machine } => {
            let given: String = machine.iter().map(|(symbol, value)| format!(", {symbol} = {value}")).collect();
            let head = t("ejemplo", "example");
            let _ = writeln!(text, "  {} ({control}, {stock}{given}):", head.get(language));
            blocks(&mut text, program);
        }
        Example::Program { control, program, given, .. } => {
            let given: String = given.iter().map(|(option, value)| format!(", {option} {value}")).collect();
            let head = t("ejemplo", "example");
            let _ = writeln!(text, "  {} ({control}{given}):", head.get(language));
            blocks(&mut text, program);
        }
        Example::Repeated { control, word, times } => {
            let head = t("ejemplo", "example");
            let often = t("repetido, veces", "repeated, times");
            let _ = writeln!(text, "  {} ({control}; {}: {times}):", head.get(language), often.get(language));
            blocks(&mut text, word);
        }
        Example::Workbook { kind, cells } => {
            let given: Vec<String> = cells.iter().map(|cell| typed(*cell, language)).collect();
            let (head, book) = (t("ejemplo", "example"), t("el libro de rodete new", "the workbook of rodete new"));
            let _ = writeln!(text, "  {}: {} {kind} ({})", head.get(language), book.get(language), given.join(", "));
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
    text
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
