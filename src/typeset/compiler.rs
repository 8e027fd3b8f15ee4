//! The typst command line as a child process: started in a private folder, held to a deadline, killed with its
//! children, and believed only when it ends with 0 and leaves a whole PDF.

#![expect(clippy::disallowed_methods, reason = "the door to the compiler: a child process in a folder of its own")]

use std::ffi::OsString;
use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc;
use std::thread;
use std::time::{Duration, Instant};

use super::failure::{Ending, ReportFailure};
use crate::limits::{DIAGNOSTIC_BYTES, PDF_BYTES};

/// The deadline of one compilation.
pub const DEADLINE: Duration = Duration::from_secs(60);

/// The date in the PDF's metadata, 2000-01-01 00:00 UTC: PDF/A wants one, and the same workbook must give the same
/// bytes whenever it is built.
const CREATED: &str = "946684800";

/// Variables that would change what a `typst` command line reads or writes.
const FOREIGN: [&str; 9] = [
    "SOURCE_DATE_EPOCH",
    "TYPST_CERT",
    "TYPST_FEATURES",
    "TYPST_FONT_PATHS",
    "TYPST_IGNORE_EMBEDDED_FONTS",
    "TYPST_IGNORE_SYSTEM_FONTS",
    "TYPST_PACKAGE_CACHE_PATH",
    "TYPST_PACKAGE_PATH",
    "TYPST_ROOT",
];

/// What the memory of GNU's C library is told: the compiler frees and asks again all the time, and pages that go back to the
/// system and come again are a twentieth of its time. Other C libraries do not read it.
const MEMORY: [(&str, &str); 3] = [
    ("MALLOC_MMAP_THRESHOLD_", "1073741824"),
    ("MALLOC_TOP_PAD_", "16777216"),
    ("MALLOC_TRIM_THRESHOLD_", "1073741824"),
];

/// Which typst command line makes the report, and how long it may take.
#[derive(Clone, Debug)]
pub struct Typst {
    program: PathBuf,
    leading: Vec<OsString>,
    deadline: Duration,
    interrupted: Arc<AtomicBool>,
}

impl Typst {
    /// The compiler inside the binary, from the path of rodete's own executable.
    #[must_use]
    pub fn embedded(executable: impl Into<PathBuf>) -> Self {
        Self { leading: vec!["typst".into()], ..Self::installed(executable) }
    }

    /// A `typst` installed on the machine: a path, or a name that is looked up as a command.
    #[must_use]
    pub fn installed(program: impl Into<PathBuf>) -> Self {
        Self {
            program: program.into(),
            leading: Vec::new(),
            deadline: DEADLINE,
            interrupted: Arc::new(AtomicBool::new(false)),
        }
    }

    /// The same with another deadline than [`DEADLINE`].
    #[must_use]
    pub fn with_deadline(mut self, deadline: Duration) -> Self {
        self.deadline = deadline;
        self
    }

    /// The same with a flag that ends the compilation when it becomes true.
    #[must_use]
    pub fn with_interrupt(mut self, interrupted: Arc<AtomicBool>) -> Self {
        self.interrupted = interrupted;
        self
    }

    /// The program that is run, for messages.
    #[must_use]
    pub fn program(&self) -> &Path {
        &self.program
    }

    /// Compiles a file of a folder that it may read, and nothing else, into the bytes of a PDF.
    pub(crate) fn compile(&self, folder: &Path, main: &str) -> Result<Vec<u8>, ReportFailure> {
        let output = Path::new(main).with_extension("pdf");
        let mut child = self
            .start(folder, main, &output)
            .map_err(|error| ReportFailure::NotStarted { program: self.program.clone(), error })?;
        let diagnostics = child.stderr.take().map(listen);
        let ended = self.wait(&mut child);
        let text = diagnostics
            // A grandchild may hold the pipe open: what was read until now is enough.
            .and_then(|receiver| receiver.recv_timeout(Duration::from_secs(1)).ok())
            .unwrap_or_default();
        let failed = |ending| {
            let (program, built_in) = (self.program.clone(), !self.leading.is_empty());
            ReportFailure::Failed { program, built_in, ending, diagnostics: text.clone() }
        };
        let status = ended.map_err(failed)?;
        if !status.success() {
            return Err(failed(Ending::Status(status)));
        }
        whole(&folder.join(output)).map_err(failed)
    }

    fn start(&self, folder: &Path, main: &str, output: &Path) -> io::Result<Child> {
        let mut command = Command::new(&self.program);
        command
            .args(&self.leading)
            .arg("compile")
            .arg("--root")
            .arg(folder)
            .args(["--creation-timestamp", CREATED, "--pdf-standard", "a-3b"])
            .args(["--ignore-system-fonts", "--diagnostic-format", "short"])
            .arg(main)
            .arg(output)
            .current_dir(folder)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::piped());
        for name in FOREIGN {
            command.env_remove(name);
        }
        command.envs(MEMORY);
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        command.spawn()
    }

    /// Waits for the end, or kills the child and all of its group.
    fn wait(&self, child: &mut Child) -> Result<ExitStatus, Ending> {
        let start = Instant::now();
        let mut pause = Duration::from_millis(1);
        loop {
            let ending = match child.try_wait() {
                Ok(Some(status)) => return Ok(status),
                Ok(None) if self.interrupted.load(Ordering::Relaxed) => Ending::Interrupted,
                Ok(None) if start.elapsed() >= self.deadline => Ending::Deadline(self.deadline),
                Ok(None) => {
                    thread::sleep(pause);
                    pause = (pause * 2).min(Duration::from_millis(16));
                    continue;
                }
                Err(error) => Ending::Lost(error),
            };
            kill(child);
            return Err(ending);
        }
    }
}

/// Kills a child that still runs, with everything that it started.
fn kill(child: &mut Child) {
    #[cfg(unix)]
    if let Some(group) = i32::try_from(child.id()).ok().and_then(rustix::process::Pid::from_raw) {
        // It may have ended in this very moment: there is nothing else to do then.
        let _ = rustix::process::kill_process_group(group, rustix::process::Signal::KILL);
    }
    let _ = child.kill();
    let _ = child.wait();
}

/// Reads a pipe to its end in a thread and sends its first bytes.
fn listen(mut pipe: impl Read + Send + 'static) -> mpsc::Receiver<Vec<u8>> {
    let (sender, receiver) = mpsc::channel();
    thread::spawn(move || {
        let mut text = Vec::new();
        // A broken pipe ends the text: what came before it is what there is to tell.
        let _ = pipe.by_ref().take(DIAGNOSTIC_BYTES).read_to_end(&mut text);
        let _ = io::copy(&mut pipe, &mut io::sink());
        let _ = sender.send(text);
    });
    receiver
}

/// The bytes of a PDF with its beginning and its end.
fn whole(path: &Path) -> Result<Vec<u8>, Ending> {
    let length = fs::metadata(path).map_err(Ending::Output)?.len();
    if length > PDF_BYTES {
        return Err(Ending::NotPdf { length });
    }
    let bytes = fs::read(path).map_err(Ending::Output)?;
    let end = bytes.len() - bytes.iter().rev().take_while(|byte| byte.is_ascii_whitespace()).count();
    match bytes.get(..end) {
        Some(text) if text.starts_with(b"%PDF") && text.ends_with(b"%%EOF") => Ok(bytes),
        _ => Err(Ending::NotPdf { length }),
    }
}
