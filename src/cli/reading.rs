//! From a workbook's path to an outcome: what `check` and `build` have in common.

use std::mem;
use std::path::Path;

use super::plan::{self, beside};
use super::verdict::Verdict;
use super::{fault, stationery};
use crate::escape::printable;
use crate::finding::{Exit, Finding, Refusal};
use crate::kind::{Kind, Outcome, Provenance, Wants};
use crate::parameter::field::Fields;
use crate::store;
use crate::sweep::asked;
use crate::workbook::{self, Filled, stamp, sweep_sheet};

/// Reads a workbook and computes what it asks for; writes nothing. The set that an earlier build of it delivered is seen
/// to, too.
pub(super) fn check(workbook: &Path, kinds: &[&dyn Kind]) -> Verdict {
    verdict(workbook, |verdict| {
        verdict.findings.extend(settled([plan::folder(workbook).as_path()])?);
        let (bytes, mut filled) = read(workbook, kinds, verdict)?;
        verdict.put_in = filled.put_in;
        filled.findings.extend(filled.stale.take().into_iter().chain(filled.astray.take()));
        if filled.stamped {
            filled.findings.extend(stamp::others(&bytes)?);
        }
        if let Some(kind) = kinds.iter().find(|kind| kind.form().schema == filled.form.schema) {
            let found = variants(&bytes, &filled, *kind)?;
            filled.findings.extend(found);
        }
        let verified = mem::take(&mut filled.named_files);
        let outcome = compute(workbook, filled, kinds, Wants::default(), verdict)?;
        // What a build would leave out of its report, or would take anew.
        verdict.findings.extend(stationery::named(workbook, &outcome, &verified));
        Ok(())
    })
}

/// The findings of a workbook's sheet of variants; none where it has no such sheet.
///
/// # Errors
/// Everything that is wrong with it.
fn variants(bytes: &[u8], filled: &Filled, kind: &dyn Kind) -> Result<Vec<Finding>, Refusal> {
    if !filled.varied {
        return Ok(Vec::new());
    }
    let Some(sheet) = sweep_sheet::read(bytes, filled.form, filled.values.language)? else { return Ok(Vec::new()) };
    let (_, notes) = asked::plan(kind, &sheet.fields, sheet.designs)
        .map_err(|findings| Refusal { exit: Exit::Refused, findings })?;
    Ok(sheet.findings.into_iter().chain(notes).collect())
}

/// The verdict on one workbook: what `work` puts into it, and how it ended. A panic is a fault of that workbook alone.
pub(super) fn verdict(workbook: &Path, work: impl FnOnce(&mut Verdict) -> Result<(), Refusal>) -> Verdict {
    let mut verdict = Verdict::new(workbook.to_owned());
    let work = |verdict: &mut Verdict| {
        verdict.findings.extend(settled([beside(workbook)])?);
        work(verdict)
    };
    match fault::guarded(|| work(&mut verdict)) {
        Ok(Ok(())) => {}
        Ok(Err(refusal)) => verdict.refuse(refusal),
        Err(mut fault) => {
            if let (Some(sha256), Some(finding)) = (&verdict.sha256, fault.findings.first_mut()) {
                finding.value = format!("SHA-256 {sha256}");
            }
            verdict.refuse(fault);
        }
    }
    verdict
}

/// What was done with sets that killed runs left half delivered in folders that are read.
///
/// # Errors
/// Exit 3 where files of two sets are mixed there: none of them is taken as good.
pub(super) fn settled<'a>(folders: impl IntoIterator<Item = &'a Path>) -> Result<Vec<Finding>, Refusal> {
    let mut found = Vec::new();
    for folder in folders {
        found.extend(store::settle(folder).map_err(|refusal| Refusal { exit: Exit::Refused, ..refusal })?);
    }
    Ok(found)
}

/// The bytes of a workbook and the form that it fills in.
///
/// # Errors
/// Whatever the gate and the schema refuse.
pub(super) fn read(path: &Path, kinds: &[&dyn Kind], verdict: &mut Verdict) -> Result<(Vec<u8>, Filled), Refusal> {
    let forms: Vec<_> = kinds.iter().map(|kind| kind.form()).collect();
    let bytes = workbook::open(path)?;
    verdict.sha256 = Some(store::sha256(&bytes));
    let filled =
        workbook::read(&bytes, &forms).inspect_err(|_| verdict.language = workbook::language(&bytes, &forms))?;
    verdict.schema = Some(filled.form.schema);
    verdict.language = Some(filled.values.language);
    Ok((bytes, filled))
}

/// The outcome of a filled-in form, with what was found when it was read.
///
/// # Errors
/// Whatever the computation refuses. An outcome that a finding stops is no error: its derived values are shown.
pub(super) fn compute(
    path: &Path,
    filled: Filled,
    kinds: &[&dyn Kind],
    wants: Wants,
    verdict: &mut Verdict,
) -> Result<Outcome, Refusal> {
    let Some(kind) = kinds.iter().find(|kind| kind.form().schema == filled.form.schema) else {
        return Err(fault::refusal("a form without a kind"));
    };
    let source = Provenance {
        workbook: printable(&path.file_name().unwrap_or_default().to_string_lossy()),
        sha256: verdict.sha256.clone().unwrap_or_default(),
        version: env!("CARGO_PKG_VERSION"),
    };
    let begun = verdict.findings.len();
    verdict.findings.extend(filled.findings.iter().cloned());
    let outcome = kind.run(Fields::of(filled.form, filled.values)?, filled.findings, source, wants)?;
    verdict.findings.truncate(begun);
    verdict.findings.extend(outcome.findings.iter().cloned());
    verdict.quantities.clone_from(&outcome.quantities);
    verdict.exit = outcome.exit();
    Ok(outcome)
}
