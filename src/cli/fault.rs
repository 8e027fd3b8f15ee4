//! Faults in rodete itself: a panic becomes one sentence and exit code 1, and nothing is written.

use std::cell::{Cell, RefCell};
use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind, set_hook, take_hook};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use crate::escape::printable;
use crate::finding::rules::BrokeOff;
use crate::finding::{Exit, Place, Raise, Refusal};

thread_local! {
    /// What the last panic of this thread said, and where.
    static SAID: RefCell<Option<String>> = const { RefCell::new(None) };
    /// How deep in guarded work this thread is.
    static GUARDED: Cell<usize> = const { Cell::new(0) };
}

/// The same for threads that guarded work has started.
static SAID_ELSEWHERE: Mutex<Option<String>> = Mutex::new(None);
/// Command lines being run: their panics, in whatever thread, are not printed.
static RUNNING: AtomicUsize = AtomicUsize::new(0);

/// Has panics of a command line noted instead of printed, from here on.
pub(super) fn note_panics() {
    RUNNING.fetch_add(1, Ordering::SeqCst);
    hook();
}

fn hook() {
    let before = take_hook();
    set_hook(Box::new(move |panic| {
        if GUARDED.get() > 0 {
            SAID.with(|said| {
                if let Ok(mut said) = said.try_borrow_mut() {
                    *said = Some(sentence(panic));
                }
            });
        } else if RUNNING.load(Ordering::SeqCst) > 0 {
            *SAID_ELSEWHERE.lock().unwrap_or_else(PoisonError::into_inner) = Some(sentence(panic));
        } else {
            before(panic);
        }
    }));
}

fn sentence(panic: &PanicHookInfo<'_>) -> String {
    let message = panic.payload_as_str().unwrap_or("no message");
    let line = message.lines().next().unwrap_or_default();
    let place = panic.location().map(|at| format!(", {}:{}", at.file(), at.line())).unwrap_or_default();
    printable(&format!("{line}{place}"))
}

/// Does a piece of work; a panic in it becomes a refusal of exit 1.
///
/// # Errors
/// Exit 1 if the work panics.
pub(super) fn guarded<T>(work: impl FnOnce() -> T) -> Result<T, Refusal> {
    GUARDED.set(GUARDED.get() + 1);
    let done = catch_unwind(AssertUnwindSafe(work));
    GUARDED.set(GUARDED.get().saturating_sub(1));
    done.map_err(|_| {
        let here = SAID.with(|said| said.try_borrow_mut().ok().and_then(|mut said| said.take()));
        let elsewhere = || SAID_ELSEWHERE.lock().unwrap_or_else(PoisonError::into_inner).take();
        refusal(&here.or_else(elsewhere).unwrap_or_else(|| "no message".to_owned()))
    })
}

/// A refusal for a fault, in its own words.
pub(super) fn refusal(said: &str) -> Refusal {
    BrokeOff { version: env!("CARGO_PKG_VERSION"), said: said.to_owned() }.refused(Exit::Fault, Place::File)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_becomes_one_sentence_with_its_place() {
        hook();
        let caught = guarded(|| {
            let none: Option<u8> = std::hint::black_box(None);
            none.expect("a point\nmore")
        });
        let refusal = caught.expect_err("it panicked");
        assert_eq!(refusal.exit, Exit::Fault);
        let what = &refusal.findings[0].what.en;
        assert!(what.contains("a point") && what.contains("fault.rs:") && !what.contains('\n'), "{what}");
        assert_eq!(guarded(|| 5), Ok(5));
    }
}
