//! Working designs out: as many at once as there are jobs, batch by batch, each chunk in the order of the plan.

#![expect(
    clippy::disallowed_methods,
    reason = "the door to processors, clock and memory: how many designs at once, when to save, what it took"
)]

use std::env;
use std::thread::available_parallelism;
use std::time::{Duration, Instant};

use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use super::super::terminal::Terminal;
use super::super::{fault, finding};
use super::Study;
use super::folder::Rows;
use super::progress::Progress;
use crate::finding::Refusal;
use crate::limits::{BATCH_DESIGNS, FORECAST_DESIGNS};
use crate::parameter::{Value, Values};
use crate::sweep::chance::permuted;
use crate::sweep::row::{Row, State, judged};

/// How often what is worked out of a chunk is saved.
const SAVED: Duration = Duration::from_secs(60);
/// A batch is about so long.
const BATCH: f64 = 1.0;
/// The fewest designs of a batch for each job.
const LEAST: usize = 4;
/// A forecast tries designs until so many are not refused.
const JUDGED: u64 = 8;
/// The variable in which Slurm says how many processors a task has.
const SLURM: &str = "SLURM_CPUS_PER_TASK";

/// One thread to time a design on: its searches would use all.
fn one_at_once() -> Result<ThreadPool, Refusal> {
    ThreadPoolBuilder::new().num_threads(1).build().map_err(|error| fault::refusal(&error.to_string()))
}

/// What works designs out.
pub(super) struct Workshop<'a> {
    study: &'a Study<'a>,
    pool: ThreadPool,
    jobs: usize,
}

impl<'a> Workshop<'a> {
    /// So many at once; where nothing is asked for, as many as there are processors for this process.
    pub(super) fn open(study: &'a Study<'a>, jobs: Option<u16>) -> Result<Self, Refusal> {
        let told = || env::var(SLURM).ok().and_then(|text| text.parse().ok()).filter(|jobs| *jobs > 0);
        let here = || available_parallelism().map_or(1, usize::from);
        let jobs = jobs.map(usize::from).or_else(told).unwrap_or_else(here);
        let pool = ThreadPoolBuilder::new().num_threads(jobs).build();
        let pool = pool.map_err(|error| fault::refusal(&error.to_string()))?;
        Ok(Self { study, pool, jobs })
    }

    /// How many at once.
    pub(super) fn jobs(&self) -> u64 {
        u64::try_from(self.jobs).unwrap_or(u64::MAX)
    }

    /// A design, worked out; a panic is a failure of that design alone.
    pub(super) fn design(&self, id: u64, inputs: Vec<Value>) -> Row {
        let Study { kind, base, plan, .. } = self.study;
        match fault::guarded(|| judged(*kind, base, plan, id, inputs.clone())) {
            Ok(row) => row,
            Err(refusal) => Row::failed(*kind, id, inputs, &refusal),
        }
    }

    /// A workbook with values that are in no design of the plan, worked out.
    pub(super) fn beside(&self, values: &Values) -> Row {
        let Study { kind, plan, .. } = self.study;
        match fault::guarded(|| judged(*kind, values, plan, 0, Vec::new())) {
            Ok(row) => row,
            Err(refusal) => Row::failed(*kind, 0, Vec::new(), &refusal),
        }
    }

    /// Does work that is divided in parts, so many of them at once.
    pub(super) fn side_by_side<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        self.pool.install(work)
    }

    /// How long the workbook's own design takes on one core, s.
    pub(super) fn own(&self) -> Result<f64, Refusal> {
        let one = one_at_once()?;
        let begun = Instant::now();
        one.install(|| self.beside(&self.study.base));
        Ok(begun.elapsed().as_secs_f64())
    }

    /// Designs of the plan in an order by chance, always the same one, worked out one by one until so many of them are not refused,
    /// with the time that each took: what is refused early costs little, and says nothing of the others.
    pub(super) fn tried(&self) -> Result<Tried, Refusal> {
        let one = one_at_once()?;
        let plan = &self.study.plan;
        let mut tried = Tried::default();
        for at in 0..plan.count.min(FORECAST_DESIGNS) {
            // A stride would meet the same levels of a factorial plan again and again.
            let id = permuted(at, plan.count, 0);
            let begun = Instant::now();
            let row = one.install(|| self.design(id, plan.design(id)));
            tried.seconds.push(begun.elapsed().as_secs_f64());
            match row.state {
                State::Refused => tried.refused += 1,
                State::Done | State::Failed => tried.judged += 1,
            }
            if tried.judged == JUDGED {
                break;
            }
        }
        Ok(tried)
    }

    /// Works a chunk out, from where an interrupted run has come to; nothing where it is there.
    pub(super) fn chunk(
        &self,
        rows: &Rows<'_>,
        number: u64,
        progress: &mut Progress<'_>,
        terminal: &mut Terminal,
    ) -> Result<(), Refusal> {
        match rows.read(number, &|_| true) {
            Ok(Some(done)) => {
                progress.known(&done);
                return Ok(());
            }
            Ok(None) => {}
            Err(()) => finding::general(&[rows.torn(number)], self.study.language, terminal),
        }
        let range = self.study.plan.chunk(number, rows.chunks());
        let mut done = rows.saved(number);
        progress.known(&done);
        let begin = range.start + u64::try_from(done.rows()).unwrap_or_default();
        let (mut next, started) = (begin, Instant::now());
        let (mut size, mut saved) = (LEAST * self.jobs, started);
        while next < range.end {
            let end = range.end.min(next + u64::try_from(size).unwrap_or(1));
            let begun = Instant::now();
            let plan = &self.study.plan;
            let worked: Vec<Row> =
                self.pool.install(|| (next..end).into_par_iter().map(|id| self.design(id, plan.design(id))).collect());
            let seconds = begun.elapsed().as_secs_f64().max(1e-6);
            let mut batch = rows.table().emptied();
            worked.into_iter().for_each(|row| batch.push(row));
            progress.take(&batch, terminal);
            done.append(batch);
            let rate = super::count(end - next) / seconds;
            size = sized(rate * BATCH).clamp(LEAST * self.jobs, BATCH_DESIGNS * self.jobs);
            next = end;
            if next < range.end && saved.elapsed() >= SAVED {
                rows.save(number, done.clone())?;
                saved = Instant::now();
            }
        }
        let log = serde_json::json!({
            "host": host(),
            "jobs": self.jobs,
            "designs": range.end - begin,
            "seconds": (started.elapsed().as_secs_f64() * 1000.0).round() / 1000.0,
            "peak_memory_kib": peak_memory(),
        });
        rows.write(number, done, &log)
    }
}

/// This computer's name in its network; empty where the system does not say it.
fn host() -> String {
    #[cfg(unix)]
    return rustix::system::uname().nodename().to_string_lossy().into_owned();
    #[cfg(not(unix))]
    return env::var("COMPUTERNAME").unwrap_or_default();
}

/// The most memory that this process has held, KiB; `None` where the system does not say it as Linux does: proc(5), `VmHWM`.
fn peak_memory() -> Option<u64> {
    let told = std::fs::read_to_string("/proc/self/status").ok()?;
    let most = told.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    most.trim().strip_suffix(" kB")?.parse().ok()
}

/// Designs that were tried for a forecast.
#[derive(Debug, Default)]
pub(super) struct Tried {
    /// How long each took, s on one core.
    seconds: Vec<f64>,
    /// How many of them were refused.
    pub(super) refused: u64,
    /// How many were not.
    pub(super) judged: u64,
}

impl Tried {
    /// How many there are.
    pub(super) const fn count(&self) -> u64 {
        self.refused + self.judged
    }

    /// The mean time of a design, s on one core.
    pub(super) fn mean(&self) -> f64 {
        self.seconds.iter().sum::<f64>() / super::count(self.count().max(1))
    }

    /// The mean time of a design, less and more than which it is in one of 20 plans, s on one core: two standard errors to both
    /// sides, but never less than the shortest time.
    pub(super) fn range(&self) -> [f64; 2] {
        let (count, mean) = (super::count(self.count()), self.mean());
        let squares: f64 = self.seconds.iter().map(|one| (one - mean) * (one - mean)).sum();
        let off = 2.0 * (squares / (count - 1.0).max(1.0) / count.max(1.0)).sqrt();
        let least = self.seconds.iter().copied().fold(mean, f64::min);
        [(mean - off).max(least), mean + off]
    }
}

/// A number of designs.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a cast stays within the type")]
const fn sized(number: f64) -> usize {
    number as usize
}

#[cfg(test)]
mod tests {
    use super::Tried;

    #[test]
    fn a_forecast_is_a_range_that_holds_the_mean_and_narrows_with_like_times() {
        let tried = |seconds: &[f64]| Tried { seconds: seconds.to_vec(), refused: 1, judged: seconds.len() as u64 - 1 };
        assert_eq!((tried(&[2.0; 9]).mean(), tried(&[2.0; 9]).range()), (2.0, [2.0, 2.0]));
        let mixed = tried(&[1.0, 5.0, 5.0, 5.0]);
        // Mean 4, deviation 2, standard error 1.
        assert_eq!((mixed.mean(), mixed.range()), (4.0, [2.0, 6.0]));
        assert_eq!(tried(&[0.5, 0.5, 0.5, 20.0]).range()[0].to_bits(), 0.5_f64.to_bits());
        assert_eq!(Tried::default().range(), [0.0, 0.0]);
    }
}
