//! The command line's words.

use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand};

use super::kinds;
use crate::text::Language;

/// From a workbook of design parameters to checked tables, ISO programs and a report for 5-axis impellers.
#[derive(Debug, Parser)]
#[command(name = "rodete", version, arg_required_else_help = true, max_term_width = 100)]
#[command(after_help = "Start with `rodete new impeller`, edit the workbook, then `rodete build impeller.xlsx`.")]
#[command(after_long_help = "\
How to work with it:
  rodete new impeller           writes impeller.xlsx, ready to edit in Excel
  rodete check impeller.xlsx    says what would stop a build, and the limits
  rodete build impeller.xlsx    writes tables, programs and report into impeller-out

Exit codes:
    0  done
    1  fault in rodete itself
    2  wrong command line
    3  the input was read and is refused
    4  the input cannot be read
    5  the output cannot be written
    6  the report failed; sheets and programs are delivered
    7  a limit was reached
  130  interrupted
With several workbooks the gravest counts: 2 before 1, 5, 7, 4, 3 and 6.")]
pub(super) struct Arguments {
    /// What is to be done.
    #[command(subcommand)]
    pub(super) command: Command,
}

/// A command.
#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Write a ready-to-edit workbook
    New(New),
    /// Validate workbooks and print derived limits and findings; write nothing
    Check(Check),
    /// Build tables, programs and a report from workbooks
    ///
    /// Writes <stem>-results.xlsx, one <stem>-*.nc for each program and <stem>-report.pdf into one folder, all or
    /// nothing: a file appears under its name only when the whole set is complete. Several workbooks are built side
    /// by side, and one that is refused does not stop the others.
    Build(Build),
}

/// Arguments of `new`.
#[derive(Debug, Args)]
pub(super) struct New {
    /// Kind of workbook
    #[arg(value_parser = PossibleValuesParser::new(kinds::names()))]
    pub(super) kind: String,
    /// File to write; one that exists is never replaced
    #[arg(default_value = "impeller.xlsx")]
    pub(super) file: PathBuf,
    /// Language of the workbook
    #[arg(long, value_name = "LANGUAGE", value_parser = language(), default_value = "en")]
    pub(super) lang: Language,
    /// Values to start from
    #[arg(long, value_parser = PossibleValuesParser::new(kinds::cases()), default_value = kinds::first_case())]
    pub(super) case: String,
}

/// Arguments of `check`.
#[derive(Debug, Args)]
pub(super) struct Check {
    /// Workbooks to check
    #[arg(required = true, value_name = "WORKBOOK")]
    pub(super) workbooks: Vec<PathBuf>,
    /// Language of the messages [default: en]
    #[arg(long, value_name = "LANGUAGE", value_parser = language())]
    pub(super) lang: Option<Language>,
    /// Print one JSON document instead of text
    #[arg(long)]
    pub(super) json: bool,
}

/// Arguments of `build`.
#[derive(Debug, Args)]
pub(super) struct Build {
    /// Workbooks to build
    #[arg(required = true, value_name = "WORKBOOK")]
    pub(super) workbooks: Vec<PathBuf>,
    /// Folder for the outputs [default: <stem>-out beside each workbook]
    #[arg(short, long, value_name = "DIR")]
    pub(super) output: Option<PathBuf>,
    /// Language of sheets, report and messages [default: the workbook's, messages in English]
    #[arg(long, value_name = "LANGUAGE", value_parser = language())]
    pub(super) lang: Option<Language>,
    /// Write no report
    #[arg(long)]
    pub(super) no_report: bool,
    /// Typst command line that sets the report [default: RODETE_TYPST, or the typst inside rodete]
    #[arg(long, value_name = "PATH")]
    pub(super) typst: Option<PathBuf>,
    /// Print one JSON document instead of text: findings, derived values, written files with their SHA-256
    #[arg(long)]
    pub(super) json: bool,
}

fn language() -> impl TypedValueParser<Value = Language> {
    PossibleValuesParser::new(Language::ALL.map(Language::code))
        .map(|code| if code == Language::Es.code() { Language::Es } else { Language::En })
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn the_command_line_is_well_formed() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn both_languages_are_read_by_their_codes() {
        for wanted in Language::ALL {
            let read = Arguments::try_parse_from(["rodete", "check", "a.xlsx", "--lang", wanted.code()]);
            assert!(
                matches!(read.map(|read| read.command), Ok(Command::Check(Check { lang: Some(l), .. })) if l == wanted)
            );
        }
    }
}
