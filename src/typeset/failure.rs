//! Why a report could not be made, told so that it can be mended.

use std::io;
use std::path::PathBuf;
use std::process::ExitStatus;
use std::time::Duration;

use thiserror::Error;

use crate::finding::{Finding, Place};
use crate::text::Text;

/// The version of typst that the templates are written for.
pub const TYPST_VERSION: &str = "0.15";

/// Most lines of a compiler's diagnostics that are told.
const LINES: usize = 8;
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
    /// The typst command line gave no report.
    #[error("{} gave no report: {ending:?}", program.display())]
    Failed {
        /// The program.
        program: PathBuf,
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

    /// The failure as a finding: the path tried, how it ended, its first lines, and what to do.
    #[must_use]
    pub fn finding(&self) -> Finding {
        self.finding_on(&Text::fixed("el informe", "the report"))
    }

    /// The failure of a document with a name, as `the report`, as a finding.
    #[must_use]
    pub fn finding_on(&self, document: &Text) -> Finding {
        let Text { es: name_es, en: name_en } = document;
        let whole = Text::fixed(
            "las hojas y los programas están completos; use --no-report para prescindir de los PDF",
            "the sheets and programs are complete; --no-report leaves the PDFs out",
        );
        match self {
            Self::Folder(error) => Finding::caution(
                Place::File,
                Text::new(
                    format!("{name_es} no se ha podido componer: la carpeta temporal no admite escritura ({error})"),
                    format!("{name_en} could not be typeset: the temporary folder cannot be written ({error})"),
                ),
                Text::fixed(
                    "libere espacio o indique otra carpeta temporal con la variable TMPDIR",
                    "free some space, or name another temporary folder with the variable TMPDIR",
                ),
            ),
            Self::Json(error) => Finding::caution(
                Place::File,
                Text::new(
                    format!("{name_es} no se ha podido componer: {error}"),
                    format!("{name_en} could not be typeset: {error}"),
                ),
                whole,
            ),
            Self::NotStarted { program, error } => {
                let program = clean(&program.to_string_lossy());
                Finding::caution(
                    Place::File,
                    Text::new(
                        format!("{name_es} no se ha podido componer: no se puede ejecutar «{program}» ({error})"),
                        format!("{name_en} could not be typeset: cannot run '{program}' ({error})"),
                    ),
                    Text::new(
                        format!(
                            "indique con --typst o RODETE_TYPST un typst {TYPST_VERSION}, o ninguno para usar el incorporado"
                        ),
                        format!(
                            "name a typst {TYPST_VERSION} with --typst or RODETE_TYPST, or none to use the built-in one"
                        ),
                    ),
                )
            }
            Self::Failed { program, ending, diagnostics } => {
                let program = clean(&program.to_string_lossy());
                let (es, en) = ending.sentences();
                let lines = first_lines(diagnostics);
                Finding::caution(
                    Place::File,
                    Text::new(
                        format!("{name_es} no se ha podido componer: «{program}» {es}{lines}"),
                        format!("{name_en} could not be typeset: '{program}' {en}{lines}"),
                    ),
                    Text::new(
                        format!(
                            "las plantillas son para typst {TYPST_VERSION}; sin --typst ni RODETE_TYPST se usa el incorporado; las hojas y los programas están completos"
                        ),
                        format!(
                            "the templates are for typst {TYPST_VERSION}; without --typst and RODETE_TYPST the built-in one is used; the sheets and programs are complete"
                        ),
                    ),
                )
            }
        }
    }
}

impl Ending {
    /// What the compiler did, in Spanish and English, to follow its name.
    fn sentences(&self) -> (String, String) {
        match self {
            Self::Status(status) => match status.code() {
                Some(code) => (format!("terminó con el código {code}"), format!("ended with exit code {code}")),
                None => (format!("se interrumpió ({status})"), format!("broke off ({status})")),
            },
            Self::Deadline(time) => {
                let seconds = time.as_secs_f64();
                (
                    format!("no terminó en {seconds} s y se ha detenido"),
                    format!("did not end within {seconds} s and was killed"),
                )
            }
            Self::Interrupted => {
                ("se ha detenido a petición del usuario".to_owned(), "was stopped by the user".to_owned())
            }
            Self::Lost(error) => (format!("no responde ({error})"), format!("cannot be waited for ({error})")),
            Self::Output(error) => {
                (format!("no dejó ningún PDF legible ({error})"), format!("left no readable PDF ({error})"))
            }
            Self::NotPdf { length } => (
                format!("dejó {length} bytes que no son un PDF completo"),
                format!("left {length} bytes that are no whole PDF"),
            ),
        }
    }
}

/// The first lines of diagnostics, safe for a terminal, each behind a line feed and indented.
fn first_lines(diagnostics: &[u8]) -> String {
    let text = String::from_utf8_lossy(diagnostics);
    let lines: Vec<&str> = text.lines().filter(|line| !line.trim().is_empty()).collect();
    let mut told: String = lines.iter().take(LINES).map(|line| format!("\n  {}", clean(line))).collect();
    if lines.len() > LINES {
        told.push_str(&format!("\n  … (+{})", lines.len() - LINES));
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
