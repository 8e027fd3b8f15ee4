//! Faults in rodete itself: a panic becomes one sentence and exit code 1, and nothing is written.

use std::any::Any;
use std::cell::Cell;
use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind, set_hook, take_hook};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use crate::escape::printable;
use crate::finding::rules::BrokeOff;
use crate::finding::{Exit, Place, Raise, Refusal};
use crate::limits::KEPT_PANICS;

thread_local! {
    /// How deep in guarded work this thread is.
    static GUARDED: Cell<usize> = const { Cell::new(0) };
}

/// What a panic said in one line, and its place in the source.
type Broke = (String, String);

/// What the last panics said, and the same in one line with their place. Guarded work is done by several threads, whose panics end it
/// on the thread that began it: it knows its own again by what they said.
static SAID: Mutex<Vec<(String, Broke)>> = Mutex::new(Vec::new());
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
        if GUARDED.get() > 0 || RUNNING.load(Ordering::SeqCst) > 0 {
            let mut said = SAID.lock().unwrap_or_else(PoisonError::into_inner);
            if said.len() == KEPT_PANICS {
                said.remove(0);
            }
            said.push((message(panic.payload()).to_owned(), broke(panic)));
        } else {
            before(panic);
        }
    }));
}

/// What a panic says.
fn message(payload: &(dyn Any + Send)) -> &str {
    let text = payload.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| payload.downcast_ref::<&str>().copied()).unwrap_or("no message")
}

/// The first line of what is said, for a terminal.
fn first_line(said: &str) -> String {
    printable(said.lines().next().unwrap_or_default())
}

fn broke(panic: &PanicHookInfo<'_>) -> Broke {
    let place = panic.location().map(|at| printable(&format!("{}:{}", at.file(), at.line()))).unwrap_or_default();
    (first_line(message(panic.payload())), place)
}

/// Does a piece of work; a panic in it becomes a refusal of exit 1.
///
/// # Errors
/// Exit 1 if the work panics.
pub(super) fn guarded<T>(work: impl FnOnce() -> T) -> Result<T, Refusal> {
    GUARDED.set(GUARDED.get() + 1);
    let done = catch_unwind(AssertUnwindSafe(work));
    GUARDED.set(GUARDED.get().saturating_sub(1));
    done.map_err(|payload| {
        let own = message(payload.as_ref());
        let mut said = SAID.lock().unwrap_or_else(PoisonError::into_inner);
        let found = said.iter().rposition(|(text, _)| text == own).map(|at| said.remove(at).1);
        refused(found.unwrap_or_else(|| (first_line(own), String::new())))
    })
}

/// A refusal for a fault, in its own words.
pub(super) fn refusal(said: &str) -> Refusal {
    refused((said.to_owned(), String::new()))
}

fn refused((said, at): Broke) -> Refusal {
    BrokeOff::of(said, at).refused(Exit::Fault, Place::File)
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
        assert!(what.contains("a point, ") && what.contains("fault.rs:") && !what.contains('\n'), "{what}");
        assert_eq!(guarded(|| 5), Ok(5));
        // So does one on a thread that works for it.
        let caught = guarded(|| rayon::join(|| 1, || panic!("beside")));
        let what = caught.expect_err("it panicked").findings[0].what.en.to_string();
        assert!(what.contains("beside"), "{what}");
    }
}
