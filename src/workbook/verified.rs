//! What `check` tells of a results workbook: which inputs differ from those that its programs were verified with, and which of them its
//! formulas do not find.

use crate::escape::excerpt;
use crate::finding::{CellPlace, Finding, Place, Raise, Refusal};
use crate::kind::NamedFile;
use crate::limits::{EXCERPT, LISTED_CELLS, LISTED_SYMBOLS};
use crate::parameter::{Form, Parameter, Values};

use super::address::{self, Position};
use super::book::Book;
use super::guard::{self, CellCopies};
use super::listing::SheetEntry;
use super::names::MARK;
use super::rules::form::{InputsChanged, NamesAstray};
use super::stamp;

/// What the guard of a results workbook tells.
#[derive(Debug, Default)]
pub(super) struct Verified {
    /// What was changed since the programs were made.
    pub(super) stale: Option<Finding>,
    /// The names that do not lead to the inputs.
    pub(super) astray: Option<Finding>,
    /// Its sheets were put into a workbook of somebody's own.
    pub(super) put_in: bool,
    /// The files that the workbook named then.
    pub(super) named_files: Vec<NamedFile>,
}

/// Compares the values of a form with the copies that stand in the same workbook.
///
/// # Errors
/// What the reading of a sheet refuses.
pub(super) fn read(
    book: &mut Book<'_>,
    form: &'static Form,
    values: &Values,
    copies: &CellCopies,
) -> Result<Verified, Refusal> {
    // The sheet that the workbook's own names lead to, whatever it is called now; a copy of it is none.
    let own = book.gated.names.get(stamp::STALE).and_then(|formula| address::cell(formula));
    let named = |entry: &&SheetEntry| match &own {
        Some((sheet, _)) => entry.name.to_lowercase() == sheet.to_lowercase(),
        None => entry.name.starts_with(guard::SHEET),
    };
    let sheets: Vec<SheetEntry> = book.gated.sheets.iter().filter(named).cloned().collect();
    let put_in = book.gated.names.keys().any(|name| name.starts_with(MARK));
    let mut verified = Verified { put_in, ..Verified::default() };
    for entry in sheets {
        let sheet = book.read(&entry, guard::COLUMNS)?;
        let stale = guard::stale(&sheet, form, values, copies).map(|stale| values.locate(changed(stale, put_in)));
        verified.stale = stale.or(verified.stale);
        let astray = astray(&guard::astray(&sheet, form, values, &book.gated.names));
        verified.astray = astray.map(|astray| values.locate(astray)).or(verified.astray);
        verified.named_files.extend(guard::named_files(&sheet));
    }
    Ok(verified)
}

/// The caution on names that do not lead to the inputs that are read; none without such names.
fn astray(lost: &[&'static Parameter]) -> Option<Finding> {
    let shown = lost.iter().take(LISTED_SYMBOLS).map(|parameter| parameter.name).collect::<Vec<_>>().join(", ");
    let names = if lost.len() > LISTED_SYMBOLS { shown + ", …" } else { shown };
    let keys = lost.iter().map(|parameter| parameter.key()).collect();
    (!lost.is_empty()).then(|| NamesAstray { names }.at(Place::Parameters(keys)))
}

/// The caution on what was changed.
fn changed(guard::Stale { inputs, lists, files }: guard::Stale, put_in: bool) -> Finding {
    let symbols = inputs.iter().map(|key| key.name().to_owned());
    let listed = lists.iter().map(|(sheet, cells)| list_told(sheet, cells));
    let inputs_told = symbols.chain(listed).collect::<Vec<_>>().join(", ");
    let programs = files.join(", ");
    let cells: Vec<CellPlace> = lists.iter().flat_map(|(sheet, cells)| places(sheet, cells)).collect();
    let place = match (inputs.is_empty(), cells.is_empty()) {
        (false, _) => Place::Parameters(inputs),
        (true, false) => Place::Cells(cells),
        (true, true) => Place::File,
    };
    InputsChanged { inputs: inputs_told, programs, into: if put_in { " --into" } else { "" } }.at(place)
}

/// The sheet of a list with the first cells of it that were changed.
fn list_told(sheet: &str, cells: &[Position]) -> String {
    let mut told = excerpt(sheet, EXCERPT);
    if !cells.is_empty() {
        let named = cells.iter().take(LISTED_CELLS).map(|cell| address::format(*cell)).collect::<Vec<_>>().join(" ");
        let more = if cells.len() > LISTED_CELLS { " …" } else { "" };
        told.push_str(&format!(" ({named}{more})"));
    }
    told
}

fn places<'a>(sheet: &'a str, cells: &'a [Position]) -> impl Iterator<Item = CellPlace> + 'a {
    cells.iter().take(LISTED_CELLS).map(|cell| CellPlace { sheet: sheet.to_owned(), cell: address::format(*cell) })
}
