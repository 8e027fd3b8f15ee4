//! Why a report could not be made, told so that it can be mended.

use std::io;
use std::path::PathBuf;
use std::process::ExitStatus;
use std::time::Duration;

use thiserror::Error;

use super::rules::*;
use crate::finding::answer::answer;
use crate::finding::rules::NotSerialized;
use crate::finding::{Finding, Place, Raise};
use crate::limits::DIAGNOSTIC_LINES;
use crate::text::{Text, t};

/// The version of typst that the templates are written for.
pub const TYPST_VERSION: &str = "0.15";

/// Most characters of such a line.
const WIDTH: usize = 200;

/// How a compilation ended that gave no report.
#[derive(Debug)]
pub enum Ending {
    /// The compiler ended with another status than 0.
    Status(ExitStatus),
    /// It was killed at the deadline.
    Deadline(Duration),
    /// It was killed because the user interrupted.
    Interrupted,
    /// It cannot be waited for.
    Lost(io::Error),
    /// It ended with 0 and its output cannot be read.
    Output(io::Error),
    /// It ended with 0 and its output is not a whole PDF.
    NotPdf {
        /// The output's length in bytes.
        length: u64,
    },
}

/// Why there is no report. Sheets and programs are not touched by it.
#[derive(Debug, Error)]
pub enum ReportFailure {
    /// The private folder cannot be made or filled.
    #[error("the report's temporary folder cannot be written: {0}")]
    Folder(#[from] io::Error),
    /// The outcome cannot be turned into JSON.
    #[error("the report's contents cannot be written as JSON: {0}")]
    Json(#[from] serde_json::Error),
    /// The typst command line cannot be started.
    #[error("{} cannot be started: {error}", program.display())]
    NotStarted {
        /// The path tried.
        program: PathBuf,
        /// Why.
        error: io::Error,
    },
    /// The compiler refused a document of templates that are the user's own.
    #[error("typst rejects a template: {}", first_lines(diagnostics))]
    OwnTemplate {
        /// What it wrote on standard error, as it came.
        diagnostics: Vec<u8>,
    },
    /// A document of templates that are the user's own was not finished in time.
    #[error("templates were not finished within {} s", time.as_secs_f64())]
    OwnTemplateEndless {
        /// The deadline.
        time: Duration,
    },
    /// The typst command line gave no report.
    #[error("{} gave no report: {ending:?}", program.display())]
    Failed {
        /// The program that was started.
        program: PathBuf,
        /// It is the compiler inside the binary.
        built_in: bool,
        /// How it ended.
        ending: Ending,
        /// What it wrote on standard error, as it came.
        diagnostics: Vec<u8>,
    },
}

impl ReportFailure {
    /// True where the user interrupted.
    #[must_use]
    pub const fn interrupted(&self) -> bool {
        matches!(self, Self::Failed { ending: Ending::Interrupted, .. })
    }

    /// True where the compiler ran to its end and refused what it was given.
    #[must_use]
    pub(crate) const fn refused(&self) -> bool {
        matches!(self, Self::Failed { ending: Ending::Status(_), .. })
    }

    /// The same, of a document with templates that are the user's own: what is refused, or does not end, is most likely theirs.
    #[must_use]
    pub(crate) fn of_own_templates(self) -> Self {
        match self {
            Self::Failed { ending: Ending::Status(_), diagnostics, .. } => Self::OwnTemplate { diagnostics },
            Self::Failed { ending: Ending::Deadline(time), .. } => Self::OwnTemplateEndless { time },
            other => other,
        }
    }

    /// The failure as a finding: the path tried, how it ended, its first lines, and what to do.
    #[must_use]
    pub fn finding(&self) -> Finding {
        self.finding_on(&t("el informe", "the report"))
    }

    /// The failure of a document with a name, as `the report`, as a finding.
    #[must_use]
    pub fn finding_on(&self, document: &Text) -> Finding {
        let document = document.clone();
        match self {
            Self::Folder(error) => NoTemporaryFolder { document, reason: answer(error) }.at(Place::File),
            Self::Json(error) => NotSerialized { document, reason: error.to_string() }.at(Place::File),
            Self::NotStarted { program, error } => {
                let (program, reason) = (clean(&program.to_string_lossy()), answer(error));
                CompilerNotStarted { document, program, reason, version: TYPST_VERSION }.at(Place::File)
            }
            Self::OwnTemplate { diagnostics } => {
                TemplateRefused { document, lines: first_lines(diagnostics) }.at(Place::File)
            }
            Self::OwnTemplateEndless { time } => {
                TemplateEndless { document, seconds: time.as_secs_f64() }.at(Place::File)
            }
            Self::Failed { ending: Ending::Status(_), diagnostics, .. } if of_kind(diagnostics) => {
                let lines = first_lines(diagnostics);
                KindTemplateRefused { document, lines, version: TYPST_VERSION }.at(Place::File)
            }
            Self::Failed { built_in: true, ending, diagnostics, .. } => {
                BuiltInFailed { document, how: ending.how(), lines: first_lines(diagnostics) }.at(Place::File)
            }
            Self::Failed { program, ending, diagnostics, .. } => {
                let (program, lines) = (clean(&program.to_string_lossy()), first_lines(diagnostics));
                let (how, version) = (ending.how(), TYPST_VERSION);
                CompilerFailed { document, program, how, lines, version }.at(Place::File)
            }
        }
    }
}

impl Ending {
    /// What the compiler did, to follow its name.
    fn how(&self) -> Text {
        match self {
            Self::Status(status) => match status.code() {
                Some(code) => {
                    Text::new(format!("terminó con el código {code}"), format!("ended with exit code {code}"))
                }
                None => Text::new(format!("se interrumpió ({status})"), format!("broke off ({status})")),
            },
            Self::Deadline(time) => {
                let seconds = time.as_secs_f64();
                Text::new(
                    format!("no terminó en {seconds} s y se ha detenido"),
                    format!("did not end within {seconds} s and was killed"),
                )
            }
            Self::Interrupted => t("se ha detenido a petición del usuario", "was stopped by the user"),
            Self::Lost(error) => {
                let Text { es, en } = answer(error);
                Text::new(format!("no responde ({es})"), format!("cannot be waited for ({en})"))
            }
            Self::Output(error) => {
                let Text { es, en } = answer(error);
                Text::new(format!("no dejó ningún PDF legible ({es})"), format!("left no readable PDF ({en})"))
            }
            Self::NotPdf { length } => Text::new(
                format!("dejó {length} bytes que no son un PDF completo"),
                format!("left {length} bytes that are not a complete PDF"),
            ),
        }
    }
}

/// True where an error is in a file that the workbook kind brings, or names one.
fn of_kind(diagnostics: &[u8]) -> bool {
    let text = String::from_utf8_lossy(diagnostics);
    text.lines().any(|line| line.contains("error: ") && (line.contains("kind/") || line.starts_with("kind\\")))
}

/// The first lines of diagnostics, safe for a terminal, each behind a line feed and indented.
fn first_lines(diagnostics: &[u8]) -> String {
    let text = String::from_utf8_lossy(diagnostics);
    let lines: Vec<&str> = text.lines().filter(|line| !line.trim().is_empty()).collect();
    let mut told: String = lines.iter().take(DIAGNOSTIC_LINES).map(|line| format!("\n  {}", clean(line))).collect();
    if lines.len() > DIAGNOSTIC_LINES {
        told.push_str(&format!("\n  … (+{})", lines.len() - DIAGNOSTIC_LINES));
    }
    told
}

/// A line without control and direction characters, at most [`WIDTH`] characters.
fn clean(line: &str) -> String {
    let mut text: String = line
        .chars()
        .take(WIDTH)
        .map(|one| if one.is_control() || super::characters::steers(one) { '\u{FFFD}' } else { one })
        .collect();
    if line.chars().nth(WIDTH).is_some() {
        text.push('…');
    }
    text
}
