//! The command, run as a black box in a folder of its own.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

use tempfile::TempDir;

use crate::motions::{MOVED, tests};

/// The typst that keeps what it is to set.
const TYPST: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/typst/keeps.sh");

/// A folder where commands run. What they name is named by its path in it, so that no output holds a path of the machine.
pub struct Place(TempDir);

impl Place {
    pub fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    /// One in which the programs of the tests stand, by their names in the ledger.
    pub fn with_programs() -> Self {
        let place = Self::new();
        let folders = ["fuzz", "golden", "lathe/alarms", "ledger"].into_iter();
        for name in folders.chain(MOVED.map(|(name, _)| name)) {
            let at = place.path(name);
            fs::create_dir_all(at.parent().unwrap()).unwrap();
            std::os::unix::fs::symlink(tests(name), at).unwrap();
        }
        place
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|why| panic!("{name}: {why}"))
    }

    pub fn write(&self, name: &str, bytes: &[u8]) {
        fs::write(self.path(name), bytes).unwrap();
    }

    /// Every file below a folder by its path in it, sorted; none where there is no such folder.
    pub fn files(&self, folder: &str) -> Vec<String> {
        let root = self.path(folder);
        let (mut found, mut folders) = (Vec::new(), vec![root.clone()]);
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(folder).into_iter().flatten() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    folders.push(path);
                } else {
                    found.push(path.strip_prefix(&root).unwrap().to_str().unwrap().to_owned());
                }
            }
        }
        found.sort();
        found
    }

    /// Runs the command with nothing of the machine's environment but where programs and temporary files are.
    pub fn run(&self, words: &[&str]) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_rodete"));
        command.args(words).current_dir(self.0.path()).stdin(Stdio::null()).env_clear();
        for kept in ["PATH", "TMPDIR"] {
            command.envs(std::env::var_os(kept).map(|value| (kept, value)));
        }
        command.env("LC_ALL", "C").env("RODETE_TYPST", TYPST).env("KEPT", self.path("kept"));
        command.output().unwrap()
    }

    /// The document that a command prints.
    pub fn json(&self, words: &[&str]) -> Vec<u8> {
        let output = self.run(&[words, &["--json"]].concat());
        assert!(!output.stdout.is_empty(), "{words:?}: {}", String::from_utf8_lossy(&output.stderr));
        output.stdout
    }

    /// All that a command prints, and how it ends.
    pub fn said(&self, words: &[&str]) -> Vec<u8> {
        let Output { status, stdout, stderr } = self.run(words);
        let (stdout, stderr) = (uncoded(&stdout), uncoded(&stderr));
        let end = format!("exit {:?}\n", status.code());
        [end.as_bytes(), b"standard output:\n", &stdout, b"standard error:\n", &stderr].concat()
    }
}

/// What was printed, without the codes of its findings and without the line that tells how to learn more of one.
fn uncoded(printed: &[u8]) -> Vec<u8> {
    let is_code = |code: &str| {
        let (letter, number) = code.split_at_checked(1).unwrap_or_default();
        letter.bytes().all(|one| one.is_ascii_uppercase()) && number.len() == 4 && number.parse::<u16>().is_ok()
    };
    let mut plain = String::new();
    for line in str::from_utf8(printed).unwrap().split_inclusive('\n') {
        if line.strip_prefix("rodete explain ").is_some_and(|rest| rest.split(' ').next().is_some_and(is_code)) {
            continue;
        }
        let coded = line.split_once(": ").and_then(|(head, rest)| Some((head.rsplit_once(' ')?, rest)));
        match coded {
            Some(((word, code), rest)) if !word.contains(' ') && is_code(code) => {
                plain.push_str(&format!("{word}: {rest}"));
            }
            _ => plain.push_str(line),
        }
    }
    plain.into_bytes()
}
