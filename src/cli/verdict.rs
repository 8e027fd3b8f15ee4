//! What a command says about one workbook.

use std::path::{Path, PathBuf};

use crate::finding::{Exit, Finding, Grade, Refusal};
use crate::store::WrittenFile;
use crate::table::Quantity;
use crate::text::{Language, Text, t};

/// What a command says about one workbook.
#[derive(Debug)]
pub(super) struct Verdict {
    /// The workbook, as it was named.
    pub(super) workbook: PathBuf,
    /// The SHA-256 of its bytes, where it could be read.
    pub(super) sha256: Option<String>,
    /// The form that it fills in, where that is known.
    pub(super) schema: Option<&'static str>,
    /// The language that it is in, where that is known.
    pub(super) language: Option<Language>,
    /// Results were put into it before.
    pub(super) put_in: bool,
    /// How its work ended.
    pub(super) exit: Exit,
    /// Derived values.
    pub(super) quantities: Vec<Quantity>,
    /// Everything found.
    pub(super) findings: Vec<Finding>,
    /// The folder that files were written to, as it was given.
    pub(super) folder: Option<PathBuf>,
    /// The files that were written.
    pub(super) files: Vec<WrittenFile>,
}

impl Verdict {
    /// A verdict with nothing found yet.
    pub(super) const fn new(workbook: PathBuf) -> Self {
        Self {
            workbook,
            sha256: None,
            schema: None,
            language: None,
            put_in: false,
            exit: Exit::Done,
            quantities: Vec::new(),
            findings: Vec::new(),
            folder: None,
            files: Vec::new(),
        }
    }

    /// The verdict with a refusal: its exit code, and its findings after those there are.
    pub(super) fn refuse(&mut self, refusal: Refusal) {
        self.exit = gravest(self.exit, refusal.exit);
        self.findings.extend(refusal.findings);
    }

    /// The workbook, where the results went into it.
    pub(super) fn book(&self) -> Option<&Path> {
        self.files.iter().map(|file| file.path.as_path()).find(|path| *path == self.workbook)
    }

    /// True for a file that is not of the folder's set: the workbook that the results went into, and the one that was kept.
    pub(super) fn is_beside(&self, path: &Path) -> bool {
        self.book().is_some_and(|book| {
            path == book || path.parent() == book.parent() && path.extension().is_some_and(|one| one == "bak")
        })
    }

    /// How many findings of a grade there are.
    pub(super) fn count(&self, grade: Grade) -> usize {
        self.findings.iter().filter(|finding| finding.grade == grade).count()
    }
}

/// The graver of two ends. What concerns rodete or the machine it runs on comes before what concerns one workbook:
/// a fault, then outputs that cannot be written, limits, inputs that cannot be read, inputs refused, reports.
pub(super) const fn gravest(one: Exit, other: Exit) -> Exit {
    if gravity(other) > gravity(one) { other } else { one }
}

const fn gravity(exit: Exit) -> u8 {
    match exit {
        Exit::Done => 0,
        Exit::ReportFailed => 1,
        Exit::Refused => 2,
        Exit::Incomplete => 3,
        Exit::Unreadable => 3,
        Exit::Limit => 4,
        Exit::Unwritable => 5,
        Exit::Fault => 6,
        Exit::CommandLine => 7,
        Exit::Interrupted => 8,
    }
}

/// The end's name for scripts.
pub(super) const fn status(exit: Exit) -> &'static str {
    match exit {
        Exit::Done => "done",
        Exit::Fault => "fault",
        Exit::CommandLine => "command-line",
        Exit::Refused => "refused",
        Exit::Unreadable => "unreadable",
        Exit::Unwritable => "unwritable",
        Exit::ReportFailed => "report-failed",
        Exit::Limit => "limit",
        Exit::Incomplete => "incomplete",
        Exit::Interrupted => "interrupted",
    }
}

/// Every end, in the order of the codes.
pub(super) const ENDS: [Exit; 10] = [
    Exit::Done,
    Exit::Fault,
    Exit::CommandLine,
    Exit::Refused,
    Exit::Unreadable,
    Exit::Unwritable,
    Exit::ReportFailed,
    Exit::Limit,
    Exit::Incomplete,
    Exit::Interrupted,
];

/// What an end says, and what has been written then.
pub(super) fn meaning(exit: Exit) -> [Text; 2] {
    let nothing = t("nada", "nothing");
    match exit {
        Exit::Done => [t("hecho", "done"), t("todo", "everything")],
        Exit::Fault => [
            t("fallo del propio rodete", "fault in rodete itself"),
            t(
                "nada; `simulate`, sus resultados, que no deben usarse",
                "nothing; by `simulate` its results, not to be used",
            ),
        ],
        Exit::CommandLine => [t("línea de comandos errónea", "wrong command line"), nothing],
        Exit::Refused => [
            t("rodete ha leído la entrada y la rechaza", "rodete read the input and rejects it"),
            t(
                "nada; `view`, la página de un programa; `simulate`, sus resultados",
                "nothing; by `view` the page of a program; by `simulate` its results",
            ),
        ],
        Exit::Unreadable => [t("la entrada no se puede leer", "the input cannot be read"), nothing],
        Exit::Unwritable => [
            t("la salida no se puede escribir", "the output cannot be written"),
            t("nada; los archivos anteriores siguen ahí", "nothing; the earlier files stay"),
        ],
        Exit::ReportFailed => [
            t(
                "el informe ha fallado; hojas y programas se entregan",
                "the report failed; sheets and programs are delivered",
            ),
            t("todo lo demás", "everything else"),
        ],
        Exit::Limit => [t("se ha alcanzado un límite", "a limit was reached"), nothing],
        Exit::Incomplete => [
            t("`sweep --merge`: faltan trozos del plan", "`sweep --merge`: chunks of the plan are missing"),
            t("nada; los trozos calculados siguen ahí", "nothing; the chunks that were worked out stay"),
        ],
        Exit::Interrupted => [t("interrumpido", "interrupted"), t("solo juegos completos", "finished sets only")],
    }
}

/// The process exit code.
pub(super) const fn code(exit: Exit) -> u8 {
    exit as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_gravest_end_counts() {
        let order = [
            Exit::Done,
            Exit::ReportFailed,
            Exit::Refused,
            Exit::Unreadable,
            Exit::Limit,
            Exit::Unwritable,
            Exit::Fault,
        ];
        for pair in order.windows(2) {
            assert_eq!(gravest(pair[0], pair[1]), pair[1]);
            assert_eq!(gravest(pair[1], pair[0]), pair[1]);
        }
    }

    #[test]
    fn exit_codes_are_those_documented() {
        assert_eq!([Exit::Done, Exit::Fault, Exit::CommandLine, Exit::Refused].map(code), [0, 1, 2, 3]);
        assert_eq!([Exit::Unreadable, Exit::Unwritable, Exit::ReportFailed, Exit::Limit].map(code), [4, 5, 6, 7]);
        assert_eq!(code(Exit::Interrupted), 130);
    }
}
