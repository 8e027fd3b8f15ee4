//! The words of `sweep`.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::Args;
use clap::builder::PossibleValuesParser;

use super::super::locale::language;
use crate::limits::ASKED_CHUNKS;
use crate::text::Language;

/// Arguments of `sweep`.
#[derive(Debug, Args)]
pub(in crate::cli) struct Sweep {
    /// Workbook with a sheet SWEEP
    pub(in crate::cli) workbook: PathBuf,
    /// Folder for rows and results [default: <stem>-sweep beside the workbook]
    #[arg(short, long, value_name = "DIR")]
    pub(in crate::cli) output: Option<PathBuf>,
    /// Designs worked out at once [default: SLURM_CPUS_PER_TASK, or one for each processor]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub(in crate::cli) jobs: Option<u16>,
    /// Take the first N designs of the plan only
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub(in crate::cli) limit: Option<u64>,
    /// Work out a few designs, and print how many there are and how long all would take; write nothing
    #[arg(long, conflicts_with_all = ["chunk", "merge", "submit", "fresh"])]
    pub(in crate::cli) dry_run: bool,
    /// How many of the best designs are written as workbooks
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u16).range(0..=1000))]
    pub(in crate::cli) top: u16,
    /// Write all rows as DIR/summary.csv, too
    #[arg(long, conflicts_with_all = ["chunk", "dry_run"])]
    pub(in crate::cli) csv: bool,
    /// Typeset what came out as DIR/<stem>-sweep.pdf, too
    #[arg(long, conflicts_with_all = ["chunk", "dry_run"])]
    pub(in crate::cli) report: bool,
    /// Begin anew: remove what an earlier run left in the folder
    #[arg(long, conflicts_with = "merge")]
    pub(in crate::cli) fresh: bool,
    /// Work out one chunk of N and nothing else; I from 0. Of more chunks than designs some are empty
    #[arg(long, value_name = "I/N", conflicts_with_all = ["merge", "submit", "chunks", "fresh"])]
    pub(in crate::cli) chunk: Option<String>,
    /// Make summary, workbook and best designs from all chunks, which must be there
    #[arg(long, conflicts_with = "submit")]
    pub(in crate::cli) merge: bool,
    /// Submit the missing chunks as an array of jobs, and the merge after them
    #[arg(long, value_name = "SCHEDULER", value_parser = PossibleValuesParser::new(["slurm"]))]
    pub(in crate::cli) submit: Option<String>,
    /// In how many chunks the plan is divided [default: one for each 1000 designs, at most 1000; for Slurm of five minutes each]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=ASKED_CHUNKS))]
    pub(in crate::cli) chunks: Option<u64>,
    /// Language of results and messages [default: the workbook's]
    #[arg(long, value_name = "LANGUAGE", value_parser = language())]
    pub(in crate::cli) lang: Option<Language>,
    /// Options for sbatch
    #[arg(last = true, value_name = "SBATCH", requires = "submit")]
    pub(in crate::cli) further: Vec<OsString>,
}
