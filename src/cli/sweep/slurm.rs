//! Slurm: an array of the chunks that are missing, and a job that merges when it has ended. No server and no protocol of our own.

#![expect(clippy::disallowed_methods, reason = "the door to Slurm: sbatch, and the program that it is to run")]

use std::env;
use std::ffi::{OsStr, OsString};
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use super::super::{fault, terminal::Terminal};
use super::args::Sweep;
use super::folder::Rows;
use super::{Study, absolute, count, ranges, record};
use crate::escape::printable;
use crate::finding::answer::{self, answer};
use crate::finding::{Exit, Place, Raise, Refusal};
use crate::limits::SWEEP_CHUNKS;
use crate::store::{Existing, Folder, Set};
use crate::sweep::rules::NoScheduler;
use crate::text::Text;

/// Seconds of work in a chunk.
const CHUNK_SECONDS: f64 = 300.0;
/// The script, in the folder of the rows.
pub(super) const SCRIPT: &str = "sweep.sbatch";

/// The script of a task. The shell stays beside the program, which may be killed: then the task is queued again, twice at most. What it
/// has saved is gone on with. One task of an array bears the array's own number as its `SLURM_JOB_ID`, and that number stands for all of
/// them: a task is named by array and index.
const TASK: &str = r#"#!/bin/bash
# Written by `rodete sweep --submit slurm`: one chunk of a sweep, or the merge of all.
# sbatch --array=0-@LAST@ sweep.sbatch works out all chunks; sbatch sweep.sbatch merges.
#SBATCH --job-name=rodete-sweep
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --mem=512M
#SBATCH --requeue
#SBATCH --open-mode=append
if [ -n "${SLURM_ARRAY_TASK_ID:-}" ]; then
    part=(--chunk "$SLURM_ARRAY_TASK_ID/@CHUNKS@")
else
    part=(--merge @CSV@@REPORT@--top @TOP@)
fi
@PROGRAM@ sweep @WORKBOOK@ -o @FOLDER@ @LIMIT@@LANG@"${part[@]}" &
wait $!
end=$?
if [ $end -ge 128 ] && [ "${SLURM_RESTART_COUNT:-0}" -lt 2 ]; then
    job=$SLURM_JOB_ID
    if [ -n "${SLURM_ARRAY_TASK_ID:-}" ]; then
        job=${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID
    fi
    scontrol requeue "$job"
    sleep 60
fi
exit $end
"#;

/// In how many chunks a plan is divided so that each takes about five minutes.
pub(super) fn chunks(designs: u64, seconds: f64) -> u64 {
    let wanted = (count(designs) * seconds / CHUNK_SECONDS).ceil();
    let wanted = (1..=SWEEP_CHUNKS).find(|chunks| count(*chunks) >= wanted).unwrap_or(SWEEP_CHUNKS);
    wanted.min(designs.max(1))
}

/// Writes the script, and submits the missing chunks and the merge.
///
/// # Errors
/// Exit 2 where there is no sbatch, or where it does not take the job; exit 5 where the script cannot be written.
pub(super) fn submit(
    arguments: &Sweep,
    study: &Study<'_>,
    place: &Path,
    rows: &Rows<'_>,
    terminal: &mut Terminal,
) -> Result<Exit, Refusal> {
    let program = env::current_exe().map_err(|error| fault::refusal(&error.to_string()))?;
    let script = script(arguments, study, place, rows, &program);
    let folder = Folder::open(place)?;
    let mut set = Set::new(&folder, &[study.workbook], Existing::Replace);
    set.write(OsStr::new(SCRIPT), |out| out.write_all(script.as_bytes()))?;
    record::commit(set, &folder, place)?;
    let (file, logs) = (absolute(&place.join(SCRIPT)), absolute(&place.join("slurm-%A_%a.log")));
    let missing = rows.missing(&|_| true);
    let mut text = String::new();
    let mut after = Vec::new();
    if !missing.is_empty() {
        let list = ranges(&missing);
        let own = [option("--array=", OsStr::new(&list)), option("--output=", logs.as_os_str())];
        let job = sbatch(&own, &arguments.further, &file)?;
        let told = Text::new(
            format!("trabajo {job}: trozos {list} de {}\n", rows.chunks()),
            format!("job {job}: chunks {list} of {}\n", rows.chunks()),
        );
        text.push_str(told.get(study.language));
        after.push(option("--dependency=afterany:", OsStr::new(&job)));
    }
    let logs = absolute(&place.join("slurm-%j.log"));
    after.push(option("--output=", logs.as_os_str()));
    let job = sbatch(&after, &arguments.further, &file)?;
    let told = Text::new(format!("trabajo {job}: resumen\n"), format!("job {job}: merge\n"));
    text.push_str(told.get(study.language));
    terminal.out(&text);
    Ok(Exit::Done)
}

/// The script with what it runs.
fn script(arguments: &Sweep, study: &Study<'_>, place: &Path, rows: &Rows<'_>, program: &Path) -> String {
    let limit = arguments.limit.map_or_else(String::new, |limit| format!("--limit {limit} "));
    let lang = arguments.lang.map_or_else(String::new, |language| format!("--lang {} ", language.code()));
    TASK.replace("@CHUNKS@", &rows.chunks().to_string())
        .replace("@LAST@", &rows.chunks().saturating_sub(1).to_string())
        .replace("@TOP@", &arguments.top.to_string())
        .replace("@CSV@", if arguments.csv { "--csv " } else { "" })
        .replace("@REPORT@", if arguments.report { "--report " } else { "" })
        .replace("@LIMIT@", &limit)
        .replace("@LANG@", &lang)
        .replace("@PROGRAM@", &quoted(program))
        .replace("@WORKBOOK@", &quoted(&absolute(study.workbook)))
        .replace("@FOLDER@", &quoted(&absolute(place)))
}

/// A path as a shell takes it, whatever its characters.
fn quoted(path: &Path) -> String {
    format!("'{}'", path.to_string_lossy().replace('\'', r"'\''"))
}

fn option(name: &str, value: &OsStr) -> OsString {
    let mut option = OsString::from(name);
    option.push(value);
    option
}

/// Submits a job, and gives its number.
fn sbatch(own: &[OsString], further: &[OsString], script: &Path) -> Result<String, Refusal> {
    let told = |reason: Text| NoScheduler { reason }.refused(Exit::CommandLine, Place::File);
    let out = Command::new("sbatch")
        .arg("--parsable")
        .args(own)
        .args(further)
        .arg(script)
        .stdin(Stdio::null())
        .output()
        .map_err(|error| told(answer(&error)))?;
    if !out.status.success() {
        // Its lines stay lines.
        let said = String::from_utf8_lossy(&out.stderr);
        let lines: Vec<String> = said.lines().map(str::trim).filter(|line| !line.is_empty()).map(printable).collect();
        return Err(told(answer::quoted(lines.join("\n"))));
    }
    // With several clusters the number is followed by the cluster's name.
    let text = String::from_utf8_lossy(&out.stdout);
    Ok(text.trim().split(';').next().unwrap_or_default().to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chunks_take_five_minutes_and_an_array_holds_them() {
        assert_eq!([chunks(100, 0.02), chunks(1_000_000, 0.021), chunks(10_000_000, 10.0)], [1, 70, 1000]);
        assert_eq!(chunks(3, 1000.0), 3);
    }

    #[test]
    fn a_path_with_quotes_and_blanks_stays_one_word() {
        assert_eq!(quoted(Path::new("/a b/it's $HOME.xlsx")), r"'/a b/it'\''s $HOME.xlsx'");
    }
}
