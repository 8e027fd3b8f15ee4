//! The command `new`: a ready-to-edit workbook.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use super::args::New;
use super::locale::spoken;
use super::rules::*;
use super::terminal::Terminal;
use super::{fault, finding, into, refused};
use crate::escape::printable_path;
use crate::finding::{Exit, Finding, Place, Raise, Refusal};
use crate::graft::rules::FormThere;
use crate::graft::{Donor, Host};
use crate::kind::Kind;
use crate::parameter::Case;
use crate::store::{self, Existing, Folder, Set, WrittenFile};
use crate::text::{Language, Text};
use crate::workbook::names::Made;
use crate::workbook::{self, sweep_sheet, template};

/// Writes the workbook and says what to do next.
pub(super) fn run(arguments: &New, kinds: &[&dyn Kind], terminal: &mut Terminal) -> Exit {
    let language = spoken(arguments.lang, None);
    super::interrupt::listen(language);
    match write(arguments, language, kinds) {
        Ok((written, told)) => {
            finding::general(&told, language, terminal);
            for file in written {
                let path = printable_path(&file.path);
                let word = if path.contains(char::is_whitespace) { format!("\"{path}\"") } else { path.clone() };
                let (command, end) = match (arguments.sweep, &arguments.into) {
                    (true, _) => ("sweep", ""),
                    (false, Some(_)) => ("build", " --into"),
                    (false, None) => ("build", ""),
                };
                let program = &terminal.program;
                let text = Text::new(
                    format!("{path} está listo para rellenar; después: {program} {command} {word}{end}\n"),
                    format!("{path} is ready to edit; then: {program} {command} {word}{end}\n"),
                );
                terminal.out(text.get(language));
            }
            Exit::Done
        }
        Err(refusal) => refused(&refusal, language, terminal),
    }
}

fn write(
    arguments: &New,
    language: Language,
    kinds: &[&dyn Kind],
) -> Result<(Vec<WrittenFile>, Vec<Finding>), Refusal> {
    let Some((form, kind)) = kinds.iter().map(|kind| (kind.form(), kind)).find(|(form, _)| form.kind == arguments.kind)
    else {
        return Err(fault::refusal("a kind without a form"));
    };
    let suggested = if arguments.sweep { kind.suggested().case } else { None };
    let case = case(kind.cases(), arguments.case.as_deref().or(suggested)).ok_or_else(|| {
        let (kind, cases) = (form.kind, kind.cases().iter().map(|case| case.name).collect::<Vec<_>>().join(", "));
        let case = arguments.case.clone().unwrap_or_default();
        NoSuchCase { kind, case, cases }.refused(Exit::CommandLine, Place::File)
    })?;
    if let Some(book) = &arguments.into {
        return put(book, *kind, case, arguments, language);
    }
    let file = arguments.file.clone().unwrap_or_else(|| PathBuf::from(format!("{}.xlsx", form.kind)));
    let name = workbook_name(&file)?;
    let folder = Folder::open(file.parent().unwrap_or(Path::new("")))?;
    let mut set = Set::new(&folder, &[], Existing::Keep);
    let (values, lists) = (case.values(language), (case.listed)(language));
    set.write(name, |out| {
        if arguments.sweep {
            let variants = sweep_sheet::suggested(kind.suggested(), language);
            let held = (values.as_slice(), lists.as_slice());
            template::write_with_variants(*kind, held, &variants, &case.note, language, out)
        } else {
            template::write(*kind, &values, &lists, &case.note, language, out)
        }
    })?;
    Ok((set.commit()?, folder.settled().cloned().into_iter().collect()))
}

/// Puts the form into a workbook, with its sheet of variants where that is asked for; into one that has the form, that sheet alone.
///
/// # Errors
/// Exit 3 where no form may be put in, 4 where the workbook cannot be read, 5 where it cannot be written.
fn put(
    book: &Path,
    kind: &dyn Kind,
    case: &Case,
    arguments: &New,
    language: Language,
) -> Result<(Vec<WrittenFile>, Vec<Finding>), Refusal> {
    let bytes = workbook::open(book)?;
    store::replaceable(book, &[])?;
    let folder = Folder::open(book.parent().unwrap_or(Path::new("")))?;
    let host = Host::open(&bytes)?;
    let present = host.present();
    let mut told: Vec<Finding> = folder.settled().cloned().into_iter().collect();
    told.extend(host.notes().iter().cloned());
    told.extend(into::copy_there(&host, book));
    let grow = |host: Host<'_>, (donor, sheets): (Vec<u8>, Vec<Made>)| {
        host.put(&Donor { bytes: &donor, sheets: &sheets, inputs: Vec::new(), source: "" })
    };
    let (values, lists) = (case.values(language), (case.listed)(language));
    let variants = arguments.sweep.then(|| sweep_sheet::suggested(kind.suggested(), language));
    let held = (values.as_slice(), lists.as_slice(), variants.as_ref());
    let form = into::composed(book, |out| template::write_into(kind, held, &case.note, language, &present, out))?;
    let grown = match grow(host, form) {
        Err(refusal) if arguments.sweep && refusal.findings.iter().any(|one| one.is(FormThere::RULE)) => {
            // A form that is of another kind, or that cannot be read, is in the way.
            let Ok(filled) = workbook::read(&bytes, &[kind.form()]) else { return Err(refusal) };
            let language = arguments.lang.unwrap_or(filled.values.language);
            let variants = sweep_sheet::suggested(kind.suggested(), language);
            let sheet = into::composed(book, |out| template::write_variants_into(kind, &variants, language, out))?;
            grow(Host::open(&bytes)?, sheet)?
        }
        grown => {
            let grown = grown?;
            Host::open(&bytes)?.has_room_for_results()?;
            grown
        }
    };
    let mut set = Set::new(&folder, &[], Existing::Replace);
    set.replace(book, &bytes, &grown)?;
    let mut written = set.commit()?;
    written.retain(|one| one.path == book);
    Ok((written, told))
}

/// The case with a name, or the usual one; `None` where there is none of that name.
fn case<'a>(cases: &'a [Case], name: Option<&str>) -> Option<&'a Case> {
    match name {
        None => cases.first(),
        Some(name) => cases.iter().find(|case| case.name == name),
    }
}

/// The name of the file to write.
///
/// # Errors
/// Exit 2 where it does not end in `.xlsx`: Excel would not open it.
pub(super) fn workbook_name(file: &Path) -> Result<&OsStr, Refusal> {
    match (file.file_name(), file.extension()) {
        (Some(name), Some(extension)) if extension.eq_ignore_ascii_case("xlsx") => Ok(name),
        _ => Err(NotAWorkbookName { path: printable_path(file) }.refused(Exit::CommandLine, Place::File)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_an_xlsx_can_be_made() {
        for name in ["a.xlsx", "dir/A b.XLSX"] {
            assert!(workbook_name(Path::new(name)).is_ok(), "{name}");
        }
        for name in ["a.xls", "a", "", "..", ".xlsx", "dir/", "a.xlsx.bak"] {
            let refusal = workbook_name(Path::new(name)).expect_err(name);
            assert_eq!(refusal.exit, Exit::CommandLine, "{name}");
        }
    }
}
