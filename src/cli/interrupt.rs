//! Ctrl-C and requests to end: unfinished files are removed, finished sets stay whole.

#![expect(clippy::disallowed_methods, reason = "the door by which an interrupted process ends")]

use std::io::Write;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread::sleep;
use std::time::Duration;

use super::verdict::code;
use crate::finding::Exit;
use crate::store;
use crate::text::{Language, Text, t};

/// Reports whose child process has not ended yet.
static CHILDREN: AtomicUsize = AtomicUsize::new(0);

/// Ends the process with exit code 130 when it is interrupted; gives a flag that becomes true then, for whoever waits
/// for a child process. Where the system offers no such signal, nothing changes.
pub(super) fn listen(language: Language) -> Arc<AtomicBool> {
    static TOLD: Text = t(
        "interrumpido: los archivos a medias se borran; los juegos completos se quedan",
        "interrupted: unfinished files are removed, finished sets stay",
    );
    listen_saying(TOLD.get(language))
}

/// The same, with what is said at the end.
pub(super) fn listen_saying(told: &'static str) -> Arc<AtomicBool> {
    let flag = Arc::new(AtomicBool::new(false));
    let raised = Arc::clone(&flag);
    let _ = ctrlc::set_handler(move || {
        raised.store(true, Ordering::SeqCst);
        store::abandon();
        // Children are killed, and their folders removed, by those who started them.
        for _ in 0..100 {
            if CHILDREN.load(Ordering::SeqCst) == 0 {
                break;
            }
            sleep(Duration::from_millis(10));
        }
        let _ = writeln!(std::io::stderr(), "{told}");
        std::process::exit(code(Exit::Interrupted).into());
    });
    flag
}

/// A child process at work: an interruption waits until it is gone.
#[derive(Debug)]
pub(super) struct AtWork;

impl AtWork {
    /// Counts a child from here until the value is dropped.
    pub(super) fn begin() -> Self {
        CHILDREN.fetch_add(1, Ordering::SeqCst);
        Self
    }
}

impl Drop for AtWork {
    fn drop(&mut self) {
        CHILDREN.fetch_sub(1, Ordering::SeqCst);
    }
}
