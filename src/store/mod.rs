//! The only place that opens a path for writing.
//!
//! Outputs come in sets: the files of one workbook in one folder. A [`Folder`] is checked before anything is computed;
//! a [`Set`] streams every file into a temporary file beside its final name and renames all of them at the end, so
//! that under a final name there is either the old file whole or the new file whole, whatever happens meanwhile: a
//! full disk, an interruption, a killed process.
//!
//! What was decided:
//! - Temporary files are named `.rodete-XXXXXX.tmp` and locked while they are written. Those of a run that was killed
//!   are removed at the next run in the folder, when they are older than a minute and nobody holds their lock.
//! - The renames of a set happen under the lock file `.rodete.lock`, which names its owner. Two runs in one folder do
//!   not mix their sets: the last one wins as a whole. On a file system without locks each file is still whole.
//! - If a rename fails, the files already replaced are put back, and the message says which set stands.
//! - An output that is a symbolic link, a folder or a device is refused; a folder may be reached through a link.
//! - New files get the mode that the umask gives, not that of a temporary file.
//! - On a refusal, folders that were made for the outputs are removed again if they are empty.

mod draft;
mod folder;
mod lock;
mod name;
mod reason;
mod set;
mod target;

pub use draft::{Output, abandon, sha256};
pub use folder::Folder;
pub use name::{file_name, stem};
pub use set::{Existing, Set, Written};
