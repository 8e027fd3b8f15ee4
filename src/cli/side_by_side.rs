//! Several workbooks at once, their verdicts in the order in which they were given.

use std::collections::BTreeMap;
use std::sync::mpsc;
use std::thread::available_parallelism;

use indicatif::{ProgressBar, ProgressStyle};
use rayon::ThreadPoolBuilder;

use super::terminal::Terminal;
use super::verdict::Verdict;
use crate::limits::WORKBOOKS_AT_ONCE;

/// Does `work` for every item; `show` gets the verdicts one by one, in the order of the items, as soon as all before
/// them are there. With more than one item, a bar on standard error shows the progress if that is a terminal.
#[expect(clippy::disallowed_methods, reason = "the door to the processors: how many workbooks are computed at once")]
pub(super) fn run<T: Sync>(
    items: &[T],
    work: impl Fn(&T) -> Verdict + Sync,
    terminal: &mut Terminal,
    mut show: impl FnMut(Verdict, &mut Terminal),
) {
    let threads = available_parallelism().map_or(1, usize::from).min(items.len()).min(WORKBOOKS_AT_ONCE);
    let pool = if threads > 1 { ThreadPoolBuilder::new().num_threads(threads).build().ok() } else { None };
    let bar = bar(items.len());
    let Some(pool) = pool else {
        for item in items {
            let verdict = work(item);
            bar.inc(1);
            bar.suspend(|| show(verdict, terminal));
        }
        bar.finish_and_clear();
        return;
    };
    let (sender, receiver) = mpsc::channel();
    pool.in_place_scope(|scope| {
        for (at, item) in items.iter().enumerate() {
            let (sender, work) = (sender.clone(), &work);
            scope.spawn(move |_| {
                // The receiver waits for every sender.
                let _ = sender.send((at, work(item)));
            });
        }
        drop(sender);
        let mut early = BTreeMap::new();
        let mut next = 0;
        for (at, verdict) in receiver {
            bar.inc(1);
            early.insert(at, verdict);
            while let Some(verdict) = early.remove(&next) {
                bar.suspend(|| show(verdict, terminal));
                next += 1;
            }
        }
    });
    bar.finish_and_clear();
}

fn bar(count: usize) -> ProgressBar {
    if count < 2 {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(u64::try_from(count).unwrap_or(u64::MAX));
    if let Ok(style) = ProgressStyle::with_template("{bar:32} {pos}/{len} {elapsed}") {
        bar.set_style(style);
    }
    bar.tick();
    bar
}
