//! The only place that opens a path for writing.
//!
//! Outputs come in sets: the files of one workbook in one folder. A [`Folder`] is checked before anything is computed;
//! a [`Set`] streams every file into a temporary file beside its final name and renames all of them at the end, so
//! that there is either the old set whole or the new set whole, whatever happens meanwhile: a full disk, an
//! interruption, a killed process.
//!
//! What was decided:
//! - Temporary files are named `.rodete-XXXXXX.tmp` and locked while they are written. Those of a run that was killed
//!   are removed at the next run in the folder, when they are older than a minute and nobody holds their lock.
//! - The renames of a set happen under the lock file `.rodete.lock`, which names its owner. Two runs in one folder do
//!   not mix their sets: the last one wins as a whole. On a file system without locks each file is still whole.
//! - If a rename fails, the files already replaced are put back, and the message says which set stands.
//! - Before the first rename of a set a notice with the names and sums of its files, and of those that they replace, is
//!   on the disk (`.rodete-delivery.json`), and after the last one it is removed. Where a run was killed in between,
//!   whoever comes next into the folder, reading or writing ([`settle`]), completes the set from its drafts, or puts back
//!   what was there; where neither can be done, the files that do not belong together are named.
//! - Every change goes through the [`Disk`], which shows each step to whoever watches: that is how it is tried what
//!   stands in the folder when any one of them fails or is the last.
//! - An output that is a symbolic link, a folder or a device is refused; a folder may be reached through a link.
//! - A workbook that is input and output at once ([`Set::replace`]) is replaced in its own folder, with the set or not at all: the
//!   notice tells of it where that folder is the set's or the one above. It must still be the one that was read.
//! - New files get the mode that the umask gives, not that of a temporary file.
//! - On a refusal, folders that were made for the outputs are removed again if they are empty.

mod disk;
mod draft;
mod folder;
mod lock;
mod name;
mod notice;
mod reason;
mod replaced;
pub mod rules;
mod set;
mod summed;
mod target;

pub use disk::{Disk, Step};
pub use draft::{Output, abandon, sha256};
pub use folder::Folder;
pub use name::{file_name, namesake, stem};
pub use notice::{settle, settle_on, sum_of};
pub use replaced::{copy_of, replaceable};
pub use set::{Existing, Set, WrittenFile};
pub use summed::{Sum, Summed};
