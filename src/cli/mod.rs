//! The commands: what is typed, what is printed, how it ends.
//!
//! Standard output carries what was asked for, standard error what needs attention. The exit codes are those of
//! [`Exit`]; of several workbooks the gravest counts.

mod args;
mod build;
mod called;
mod compare;
mod completions;
mod delivery;
mod drawings;
mod explain;
mod fault;
mod finding;
mod interrupt;
mod into;
mod json;
mod locale;
mod made;
mod made_from;
mod new;
mod offsets;
mod offsets_view;
mod opened;
mod plan;
mod program;
mod quantity;
mod reading;
mod rules;
mod show;
mod side_by_side;
mod simulate;
mod stationery;
mod stock;
mod sweep;
mod terminal;
mod turning;
mod verdict;
mod verify;
mod view;
mod watch;

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::error::{Error, ErrorKind};

use self::args::{Arguments, Check, Command};
pub use self::explain::{codes, controls, exit_codes, parameters, reference, rows};
use self::locale::spoken;
use self::rules::OutputNotWritten;
use self::terminal::Terminal;
use self::verdict::{Verdict, code, gravest};
use crate::escape::printable;
use crate::finding::answer::answer;
use crate::finding::{Exit, Finding, Place, Raise, Refusal};
use crate::kind::Kind;
use crate::parameter::FieldKind;
use crate::text::Language;
#[cfg(not(feature = "embedded-typst"))]
use crate::typeset::failure::TYPST_VERSION;

/// The commands' names in JSON.
const CHECK: &str = "check";
const BUILD: &str = "build";
const OFFSETS: &str = "offsets";

/// Runs a command line, the program's name first, for these kinds of workbooks, and gives the process exit code. The usual
/// kind stands first; [`KINDS`](crate::kinds::KINDS) are those of `rodete`. It refuses kinds of which a code is another
/// row's already ([`codes`]).
///
/// With the typst compiler inside, the command `typst` is that compiler: a report is typeset by a process of the binary itself.
pub fn run(arguments: impl IntoIterator<Item = OsString>, kinds: &[&dyn Kind]) -> ExitCode {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    #[cfg(feature = "embedded-typst")]
    if arguments.get(1).is_some_and(|first| first == "typst") {
        return crate::typeset::embedded::compile(&arguments[2..]);
    }
    fault::note_panics();
    let mut terminal = Terminal::new(called::called(arguments.first()));
    let mut exit = match fault::guarded(|| command(arguments, kinds, &mut terminal)) {
        Ok(exit) => exit,
        Err(refusal) => refused(&refusal, spoken(None, None), &mut terminal),
    };
    finding::more(&mut terminal);
    terminal.end(matches!(exit, Exit::Done | Exit::ReportFailed));
    if let Some(error) = terminal.fault() {
        let told = OutputNotWritten { reason: answer(&error) }.at(Place::File);
        finding::general(&[told], spoken(None, None), &mut terminal);
        exit = gravest(exit, Exit::Unwritable);
    }
    ExitCode::from(code(exit))
}

fn command(arguments: impl IntoIterator<Item = OsString>, kinds: &[&dyn Kind], terminal: &mut Terminal) -> Exit {
    if let Err(refusal) = codes(kinds) {
        return refused(&refusal, spoken(None, None), terminal);
    }
    let arguments = match Arguments::read(arguments, kinds) {
        Ok(arguments) => arguments,
        Err(error) => return misunderstood(&error, kinds, terminal),
    };
    match arguments.command {
        Command::New(new) => new::run(&new, kinds, terminal),
        Command::Check(arguments) => check(&arguments, kinds, terminal),
        Command::Build(arguments) => build::run(&arguments, kinds, terminal),
        Command::Watch(arguments) => watch::run(&arguments, kinds, terminal),
        Command::Compare(arguments) => compare::run(&arguments, kinds, terminal),
        Command::Sweep(arguments) => sweep::run(&arguments, kinds, terminal),
        Command::Simulate(arguments) => simulate::run(&arguments, kinds, terminal),
        Command::Verify(arguments) => verify::run(&arguments, terminal),
        Command::View(arguments) => view::run(&arguments, kinds, terminal),
        Command::Offsets(arguments) => offsets::run(&arguments, terminal),
        Command::Explain(arguments) => explain::run(&arguments, kinds, terminal),
        Command::Completions(arguments) => completions::completions(&arguments, kinds, terminal),
        Command::Man(arguments) => completions::man(&arguments, kinds, terminal),
    }
}

/// Help, version, or what is wrong with the command line.
fn misunderstood(error: &Error, kinds: &[&dyn Kind], terminal: &mut Terminal) -> Exit {
    match error.kind() {
        ErrorKind::DisplayVersion => terminal.out(&version(kinds)),
        ErrorKind::DisplayHelp => terminal.out(&error.render().ansi().to_string()),
        _ => {
            // The message repeats what was typed.
            let text = error.render().to_string();
            let lines: String = text.lines().map(|line| format!("{}\n", printable(line))).collect();
            terminal.err(&lines);
            return Exit::CommandLine;
        }
    }
    Exit::Done
}

/// What `--version` says: the version, what sets the reports, the forms that can be read, the controls that can be written.
fn version(kinds: &[&dyn Kind]) -> String {
    let mut text = format!("rodete {}\n", env!("CARGO_PKG_VERSION"));
    #[cfg(feature = "embedded-typst")]
    text.push_str(&format!("features: embedded-typst (typst {})\n", crate::typeset::embedded::version()));
    #[cfg(not(feature = "embedded-typst"))]
    text.push_str(&format!("features: none (an installed typst {} sets the reports)\n", TYPST_VERSION));
    for form in kinds.iter().map(|kind| kind.form()) {
        text.push_str(&format!("workbook {}: schema {}\n", form.kind, form.schema));
        if let Some(FieldKind::Choice(choices)) = form.parameter("dialect").map(|parameter| &parameter.kind) {
            let keys: Vec<_> = choices.iter().map(|choice| choice.key).collect();
            text.push_str(&format!("dialects: {}\n", keys.join(", ")));
        }
    }
    text
}

fn check(arguments: &Check, kinds: &[&dyn Kind], terminal: &mut Terminal) -> Exit {
    let language = spoken(arguments.lang, None);
    if let Err(refusal) = plan::twice(&arguments.workbooks) {
        return refused(&refusal, language, terminal);
    }
    interrupt::listen(language);
    let mut sink = Sink::new(CHECK, arguments.lang, arguments.json);
    let work = |workbook: &PathBuf| reading::check(workbook, kinds);
    side_by_side::run(&arguments.workbooks, work, terminal, |verdict, terminal| sink.take(verdict, terminal));
    sink.end(terminal)
}

/// Says why a command was not begun.
fn refused(refusal: &Refusal, language: Language, terminal: &mut Terminal) -> Exit {
    finding::general(&refusal.findings, language, terminal);
    refusal.exit
}

/// Where the verdicts of a command go, one by one.
struct Sink {
    command: &'static str,
    /// The language that was asked for.
    language: Option<Language>,
    /// The verdicts so far, if they are to be printed as one document.
    kept: Option<Vec<Verdict>>,
    exit: Exit,
}

impl Sink {
    const fn new(command: &'static str, language: Option<Language>, json: bool) -> Self {
        Self { command, language, kept: if json { Some(Vec::new()) } else { None }, exit: Exit::Done }
    }

    fn take(&mut self, verdict: Verdict, terminal: &mut Terminal) {
        self.exit = gravest(self.exit, verdict.exit);
        match &mut self.kept {
            Some(kept) => kept.push(verdict),
            None => {
                let language = spoken(self.language, verdict.language);
                show::verdict(&verdict, self.command == BUILD, language, terminal);
            }
        }
    }

    /// Adds what was found of a workbook afterwards to its part of the document.
    fn add(&mut self, workbook: &Path, finding: &Finding) {
        let verdict = self.kept.iter_mut().flatten().find(|verdict| verdict.workbook == workbook);
        if let Some(verdict) = verdict {
            verdict.findings.push(finding.clone());
        }
    }

    fn end(self, terminal: &mut Terminal) -> Exit {
        if let Some(kept) = &self.kept {
            terminal.out(&json::document(self.command, self.exit, kept));
        }
        self.exit
    }
}
