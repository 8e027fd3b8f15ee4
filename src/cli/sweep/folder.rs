//! The rows of a plan in a folder: one file a chunk, and what the plan says beside them.
//!
//! A chunk that is there with its plan and all its rows is done; one that is torn is not. Its name and its bytes follow from plan and
//! number, so that two who write the same one do no harm. What is worked out of a chunk before it is whole is saved beside it, so that
//! an interruption costs a minute at most.

#![expect(clippy::disallowed_methods, reason = "the door to the files of a sweep")]

use std::ffi::{OsStr, OsString};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::super::fault;
use super::Study;
use super::record::Record;
use crate::escape::{printable, printable_path};
use crate::finding::{Exit, Finding, Place, Raise, Refusal};
use crate::store::{self, Existing, Folder, Set};
use crate::sweep::file;
use crate::sweep::plan::WORKBOOK_SUM;
use crate::sweep::rules::{ChunkTorn, ChunksMissing, OtherChunks, OtherPlan, OtherWorkbook};
use crate::sweep::table::Table;

const PLAN: &str = "plan.json";
/// The key in the plan's file of the workbook's name: whose rows and sheets are in the folder.
const WORKBOOK: &str = "workbook";
/// The ending of rows that are not yet a chunk.
const PART: &str = ".part";
/// The ending of what working a chunk out took.
const LOG: &str = "log.json";

/// How a folder is opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Opening {
    /// What an earlier run left is removed.
    Anew,
    /// What is there is gone on with.
    GoOn,
    /// What is there is read: nothing says in how many chunks an empty folder will be divided.
    Merge,
}

/// The folder of a plan's rows.
pub(super) struct Rows<'a> {
    study: &'a Study<'a>,
    place: PathBuf,
    chunks: u64,
    /// What the plan says, for files and for comparison.
    told: String,
    /// The plan's name: the first digits of its sum.
    name: String,
    table: Table,
    folder: Folder,
}

impl<'a> Rows<'a> {
    /// The folder at a path, made where it is not there. In how many chunks the plan is divided is what the folder says already,
    /// what is `wanted`, or what is `usual`.
    ///
    /// # Errors
    /// Exit 3 where the folder holds another plan, or another division, or, to begin anew, what another workbook left; exit 5 where
    /// nothing can be written, or where what is to be removed was changed by somebody.
    pub(super) fn open(
        place: &Path,
        study: &'a Study<'a>,
        wanted: Option<u64>,
        usual: impl FnOnce() -> Result<u64, Refusal>,
        opening: Opening,
    ) -> Result<Self, Refusal> {
        let outer = Folder::open(place)?;
        let mut known: Option<Value> =
            fs::read(place.join(PLAN)).ok().map(|bytes| serde_json::from_slice(&bytes).unwrap_or(Value::Null));
        let mut told: Value = serde_json::from_str(&study.told).unwrap_or(Value::Null);
        let path = || printable_path(place);
        let own = study.workbook.file_name().unwrap_or_default().to_string_lossy();
        if let Some(known) = &known {
            // A copy under another name has the same plan and rows; what is to be removed must be of this very name.
            let same = opening != Opening::Anew && known.get("plan") == Some(&told);
            let named = known.get(WORKBOOK).and_then(Value::as_str);
            // What is of no named workbook may be of this one.
            if let Some(named) = named.filter(|named| !same && *named != own) {
                let other = printable(named);
                return Err(OtherWorkbook { path: path(), other }.refused(Exit::Refused, Place::File));
            }
        }
        if opening == Opening::Anew {
            clear(&outer, place)?;
            known = None;
        }
        // A workbook that was saved again with the same values has the same rows: they go on under the sum that they began with.
        if let Some(began) = known.as_ref().and_then(|known| known.get("plan")).filter(|began| same(began, &told)) {
            told = began.clone();
        }
        let chunks = match known {
            Some(known) => {
                if known.get("plan") != Some(&told) {
                    return Err(OtherPlan { path: path() }.refused(Exit::Refused, Place::File));
                }
                let chunks = known.get("chunks").and_then(Value::as_u64).unwrap_or_default();
                if wanted.is_some_and(|wanted| wanted != chunks) || chunks == 0 {
                    return Err(OtherChunks { path: path(), chunks }.refused(Exit::Refused, Place::File));
                }
                chunks
            }
            None => {
                // More chunks than designs are as good as any: an array of so many tasks finds some of them empty.
                let chunks = wanted.map_or_else(usual, Ok)?.max(1);
                if opening != Opening::Merge {
                    // Beside the plan: rows do not depend on the workbook's name.
                    let stated = serde_json::json!({ "plan": told, "chunks": chunks, WORKBOOK: own });
                    let text = format!("{stated:#}\n");
                    write(&outer, OsStr::new(PLAN), text.as_bytes())?;
                }
                chunks
            }
        };
        let folder = Folder::open(&place.join("chunks"))?;
        let table = Table::of(study.kind, &study.plan);
        let told = told.to_string();
        let name: String = store::sha256(told.as_bytes()).chars().take(8).collect();
        Ok(Self { study, place: place.to_owned(), chunks, told, name, table, folder })
    }

    /// In how many chunks the plan is divided.
    pub(super) const fn chunks(&self) -> u64 {
        self.chunks
    }

    /// The columns of the rows, without any.
    pub(super) const fn table(&self) -> &Table {
        &self.table
    }

    /// What the plan says, as the rows have it.
    pub(super) fn told(&self) -> &str {
        &self.told
    }

    /// The folder.
    pub(super) fn place(&self) -> &Path {
        &self.place
    }

    fn name(&self, number: u64) -> OsString {
        format!("{}-{number:05}-of-{:05}.parquet", self.name, self.chunks).into()
    }

    fn part(&self, number: u64) -> OsString {
        format!(".{}-{number:05}-of-{:05}{PART}", self.name, self.chunks).into()
    }

    fn path(&self, name: &OsStr) -> PathBuf {
        self.place.join("chunks").join(name)
    }

    /// The rows of a chunk that is there; some columns alone where only these are `wanted`. `Err` says that something else is there.
    pub(super) fn read(&self, number: u64, wanted: &dyn Fn(&str) -> bool) -> Result<Option<Table>, ()> {
        let Ok(bytes) = fs::read(self.path(&self.name(number))) else { return Ok(None) };
        let rows = self.rows_of(bytes, wanted).ok_or(())?;
        let range = self.study.plan.chunk(number, self.chunks);
        let whole = u64::try_from(rows.rows()).is_ok_and(|count| count == range.end - range.start);
        if whole && (range.is_empty() || rows.ids().next() == Some(range.start)) { Ok(Some(rows)) } else { Err(()) }
    }

    /// The rows of a file; none of one that is torn, damaged or of another plan. What the library for these files trips over in a
    /// damaged one is damage, too.
    fn rows_of(&self, bytes: Vec<u8>, wanted: &dyn Fn(&str) -> bool) -> Option<Table> {
        fault::guarded(|| file::read(bytes, &self.table, &self.told, wanted)).ok()?.ok()
    }

    /// The chunks that are not there, or of which not all of these columns can be read.
    pub(super) fn missing(&self, wanted: &dyn Fn(&str) -> bool) -> Vec<u64> {
        (0..self.chunks).filter(|number| !matches!(self.read(*number, wanted), Ok(Some(_)))).collect()
    }

    /// The stop for chunks that are missing or damaged: all of them, whatever was seen first.
    pub(super) fn lacking(&self) -> Refusal {
        let missing = self.missing(&|_| true);
        let (list, chunks) = (super::ranges(&missing), self.chunks);
        let missing = u64::try_from(missing.len()).unwrap_or(u64::MAX);
        ChunksMissing { list, missing, chunks }.refused(Exit::Incomplete, Place::File)
    }

    /// The finding for a chunk that is torn.
    pub(super) fn torn(&self, number: u64) -> Finding {
        ChunkTorn { path: printable_path(&self.path(&self.name(number))) }.at(Place::File)
    }

    /// The rows of a chunk that an interrupted run has saved; none where there are none.
    pub(super) fn saved(&self, number: u64) -> Table {
        let rows = fs::read(self.path(&self.part(number))).ok();
        let rows = rows.and_then(|bytes| self.rows_of(bytes, &|_| true));
        let range = self.study.plan.chunk(number, self.chunks);
        let fits = |rows: &Table| {
            rows.ids().next() == Some(range.start)
                && u64::try_from(rows.rows()).is_ok_and(|count| count <= range.end - range.start)
        };
        rows.filter(fits).unwrap_or_else(|| self.table.emptied())
    }

    /// Saves the first rows of a chunk.
    pub(super) fn save(&self, number: u64, rows: Table) -> Result<(), Refusal> {
        write(&self.folder, &self.part(number), &self.bytes(rows)?)
    }

    /// Writes a chunk, whole, and beside it what working it out took: that is not the same on every machine, and no part of the rows.
    pub(super) fn write(&self, number: u64, rows: Table, log: &Value) -> Result<(), Refusal> {
        write(&self.folder, &self.name(number), &self.bytes(rows)?)?;
        let beside = Path::new(&self.name(number)).with_extension(LOG);
        write(&self.folder, beside.as_os_str(), format!("{log:#}\n").as_bytes())?;
        self.folder.remove(&self.part(number))
    }

    fn bytes(&self, rows: Table) -> Result<Vec<u8>, Refusal> {
        file::bytes(rows, &self.told).map_err(|error| fault::refusal(&error.to_string()))
    }
}

/// Writes a file, whole or not at all.
fn write(folder: &Folder, name: &OsStr, bytes: &[u8]) -> Result<(), Refusal> {
    let mut set = Set::new(folder, &[], Existing::Replace);
    set.write(name, |out| out.write_all(bytes))?;
    set.commit().map(drop)
}

/// Whether two plans have the same rows: they may come of two files that hold the same values.
fn same(one: &Value, other: &Value) -> bool {
    let values = |plan: &Value| {
        let mut plan = plan.clone();
        plan.as_object_mut().map(|plan| plan.remove(WORKBOOK_SUM));
        plan
    };
    values(one) == values(other)
}

/// Removes what earlier runs left: the plan, its chunks, and what was made of them. A folder that holds no plan holds nothing of
/// the kind, and a file that no sweep has written is somebody else's.
fn clear(outer: &Folder, place: &Path) -> Result<(), Refusal> {
    if !place.join(PLAN).is_file() {
        return Ok(());
    }
    Record::open(place).clear(outer)?;
    let chunk = |file: &str| {
        let sum = file.trim_start_matches('.').split_once('-').map(|(sum, _)| sum);
        let of_plan = sum.is_some_and(|sum| sum.len() == 8 && sum.bytes().all(|one| one.is_ascii_hexdigit()));
        of_plan && file.contains("-of-") && [".parquet", PART, LOG].iter().any(|end| file.ends_with(end))
    };
    let path = place.join("chunks");
    if let Ok(entries) = fs::read_dir(&path) {
        let folder = Folder::open(&path)?;
        let names = entries.flatten().map(|entry| entry.file_name());
        names.filter(|name| chunk(&name.to_string_lossy())).try_for_each(|name| folder.remove(&name))?;
    }
    outer.remove(OsStr::new(PLAN))
}
