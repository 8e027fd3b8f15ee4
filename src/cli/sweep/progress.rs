//! How far a sweep is, in one line: on a terminal written over twice a second, elsewhere a line a minute.

#![expect(clippy::disallowed_methods, reason = "the door to the clock: the rate of designs")]

use std::collections::VecDeque;
use std::ops::Range;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use super::super::terminal::Terminal;
use super::{Study, count};
use crate::number::duration;
use crate::sweep::ranking::Ranking;
use crate::sweep::table::Table;
use crate::text::{Language, Text};

/// The rate is the mean of the last so long.
const WINDOW: Duration = Duration::from_secs(30);
const ON_TERMINAL: Duration = Duration::from_millis(500);
const ELSEWHERE: Duration = Duration::from_secs(60);
/// How often it is looked whether work has ended.
const TICK: Duration = Duration::from_millis(5);

/// How far a sweep is.
pub(super) struct Progress<'a> {
    language: Language,
    all: u64,
    done: u64,
    ranking: Ranking<'a>,
    seen: VecDeque<(Instant, u64)>,
    told: Instant,
    on_line: bool,
}

impl<'a> Progress<'a> {
    /// Of a range of designs, at its beginning.
    pub(super) fn new(study: &'a Study<'a>, range: Range<u64>) -> Self {
        let now = Instant::now();
        Self {
            language: study.language,
            all: range.end - range.start,
            done: 0,
            ranking: Ranking::new(&study.plan, 1),
            seen: VecDeque::from([(now, 0)]),
            told: now,
            on_line: false,
        }
    }

    /// Takes in rows that were there before.
    pub(super) fn known(&mut self, rows: &Table) {
        let count = u64::try_from(rows.rows()).unwrap_or_default();
        self.done += count;
        // They took no time.
        self.seen.iter_mut().for_each(|(_, before)| *before += count);
        self.ranking.take(rows);
    }

    /// Takes in rows that were worked out, and says how far it is.
    pub(super) fn take(&mut self, rows: &Table, terminal: &mut Terminal) {
        self.done += u64::try_from(rows.rows()).unwrap_or_default();
        self.ranking.take(rows);
        let now = Instant::now();
        self.seen.push_back((now, self.done));
        while self.seen.len() > 2 && self.seen.front().is_some_and(|(at, _)| now - *at > WINDOW) {
            self.seen.pop_front();
        }
        let live = terminal.overwrites();
        if now - self.told < if live { ON_TERMINAL } else { ELSEWHERE } {
            return;
        }
        self.told = now;
        let line = self.line();
        if live {
            self.on_line = true;
            terminal.err(&format!("\r{line}\u{1b}[K"));
        } else {
            terminal.err(&format!("{line}\n"));
        }
    }

    /// Clears the line.
    pub(super) fn end(&self, terminal: &mut Terminal) {
        if self.on_line {
            terminal.err("\r\u{1b}[K");
        }
    }

    fn line(&self) -> String {
        let (first, last) = (self.seen.front(), self.seen.back());
        let rate = first.zip(last).map_or(0.0, |((from, before), (to, after))| {
            let seconds = (*to - *from).as_secs_f64();
            if seconds > 0.0 { count(after - before) / seconds } else { 0.0 }
        });
        let counts = self.ranking.counts();
        let judged = counts.done + counts.refused + counts.failed;
        let refused = 100.0 * count(counts.refused) / count(judged.max(1));
        let left = if rate > 0.0 { duration(count(self.all - self.done) / rate) } else { "…".to_owned() };
        let [done, all] = [self.done, self.all].map(|number| grouped(number, self.language));
        let front = self.ranking.on_front();
        let rate = if rate < 10.0 { format!("{rate:.1}") } else { format!("{rate:.0}") };
        let text = Text::new(
            format!("{done} de {all} · {refused:.0} % rechazados · {rate} diseños/s · faltan {left} · frente {front}"),
            format!("{done} of {all} · {refused:.0} % refused · {rate} designs/s · {left} left · front {front}"),
        );
        text.get(self.language).to_owned()
    }
}

/// Waits for work that counts what it has done, and says in one line how far it is, as for the rows of a sweep.
///
/// # Panics
/// Where the work does.
pub(super) fn waiting<T: Send>(
    work: impl FnOnce() -> T + Send,
    (done, most): (&AtomicU64, u64),
    language: Language,
    terminal: &mut Terminal,
) -> T {
    let live = terminal.overwrites();
    let mut on_line = false;
    let result = thread::scope(|scope| {
        let working = scope.spawn(work);
        let mut told = Instant::now();
        while !working.is_finished() {
            thread::sleep(TICK);
            if told.elapsed() < if live { ON_TERMINAL } else { ELSEWHERE } {
                continue;
            }
            told = Instant::now();
            let [done, most] = [done.load(Ordering::Relaxed), most].map(|number| grouped(number, language));
            let text = Text::new(
                format!("sensibilidades: {done} diseños, de {most} como mucho"),
                format!("sensitivities: {done} designs of at most {most}"),
            );
            let line = text.get(language);
            on_line |= live;
            terminal.err(&if live { format!("\r{line}\u{1b}[K") } else { format!("{line}\n") });
        }
        working.join()
    });
    if on_line {
        terminal.err("\r\u{1b}[K");
    }
    result.unwrap_or_else(|panic| resume_unwind(panic))
}

/// A number with its digits in groups of three: parted by a comma, in Spanish by a blank that does not break.
fn grouped(number: u64, language: Language) -> String {
    let mark = if language == Language::Es { '\u{a0}' } else { ',' };
    let digits = number.to_string();
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push(mark);
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::grouped;
    use crate::text::Language;

    #[test]
    fn digits_stand_in_groups_of_three() {
        let shown = |number| grouped(number, Language::En);
        assert_eq!([0, 999, 1000, 1_234_567].map(shown), ["0", "999", "1,000", "1,234,567"]);
        assert_eq!(grouped(1_234_567, Language::Es), "1\u{a0}234\u{a0}567");
    }
}
