//! `explain`: what a code means, why it is reported, what to do, and an example that raises it.

mod cells;
mod clashes;
mod controls;
mod findings;
mod markdown;
mod near;
mod pages;
mod row;
mod told;

use anstyle::Style;

use self::told::ShownFinding;
use super::args::Explain;
use super::fault;
use super::finding::wrapped;
use super::locale::spoken;
use super::refused;
use super::rules::{self, NoSuchCode};
use super::terminal::Terminal;
use crate::drawing;
use crate::escape::printable;
use crate::finding::{self, Exit, Place, Raise, Rule};
use crate::gcode::rules::{codes, expressions, flow, geometry, lexis, modes, turned, words};
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
use crate::sweep;
use crate::text::Language;
use crate::typeset;
use crate::workbook;

pub use self::clashes::codes;
pub use self::controls::controls;
pub use self::pages::{exit_codes, parameters};

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
    sweep::rules::RULES,
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
    turned::RULES,
    words::RULES,
    codes::RULES,
];

/// All rows of a binary with these kinds, by their codes, as often as they are listed.
fn every(kinds: &[&dyn Kind]) -> Vec<&'static Rule> {
    let mut rows: Vec<_> =
        RULES.iter().chain(kinds.iter().flat_map(|kind| kind.rules())).copied().flatten().copied().collect();
    rows.sort_by_key(|rule| (rule.code, rule.ident));
    rows
}

/// All rows of a binary with these kinds, by their codes: those of its rooms, and those of the kinds.
#[must_use]
pub fn rows(kinds: &[&dyn Kind]) -> Vec<&'static Rule> {
    let mut rows = every(kinds);
    // Kinds may share rows.
    rows.dedup_by_key(|rule| (rule.code, rule.ident));
    rows
}

/// Every row on one page in Markdown, by its code.
#[must_use]
pub fn reference(kinds: &[&dyn Kind], language: Language) -> String {
    findings::page(&rows(kinds), kinds, language)
}

pub(super) fn run(arguments: &Explain, kinds: &[&dyn Kind], terminal: &mut Terminal) -> Exit {
    let (language, width) = (spoken(arguments.lang, None), terminal.width);
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
        terminal.out(&if arguments.markdown { controls::controls(language) } else { controls::told(language, width) });
        return Exit::Done;
    }
    if arguments.all {
        let told: String = if arguments.markdown {
            reference(kinds, language)
        } else {
            rows(kinds).into_iter().map(|rule| row::told(rule, kinds, language, width)).collect()
        };
        terminal.out(&told);
        return Exit::Done;
    }
    if arguments.codes.is_empty() {
        let bold = Style::new().bold();
        let line = |rule: &Rule| {
            let indent = rule.code.len() + 2;
            let ShownFinding { what, .. } = told::of(rule);
            wrapped(&format!("{bold}{}{bold:#}  {}", rule.code, what.get(language)), indent, width)
        };
        let lines: String = rows(kinds).into_iter().map(line).collect();
        terminal.out(&lines);
        return Exit::Done;
    }
    let mut exit = Exit::Done;
    for code in &arguments.codes {
        let found: Vec<_> = rows(kinds).into_iter().filter(|rule| named(rule, code)).collect();
        if found.is_empty() {
            let near = near::near(code, &rows(kinds));
            let refusal = NoSuchCode { code: printable(code), near }.refused(Exit::CommandLine, Place::File);
            exit = refused(&refusal, language, terminal);
        }
        for rule in found {
            terminal.out(&row::told(rule, kinds, language, width));
        }
    }
    exit
}

/// True where a row is meant: by its code, whatever the case of its letter, or by the number of its alarm.
fn named(rule: &Rule, code: &str) -> bool {
    rule.code.eq_ignore_ascii_case(code)
        || rule.alarm.iter().any(|(family, number)| family.shown(*number).eq_ignore_ascii_case(code))
}
