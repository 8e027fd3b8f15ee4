//! A chunk is there whole or not at all, wherever the writing of it ends.

use std::io::{ErrorKind, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use rodete::store::{Disk, Existing, Folder, Set};
use rodete::sweep::file;
use rodete::sweep::table::{Cells, Column, Table};

/// Some rows.
fn rows(count: u32) -> Table {
    let numbers = (0..count).map(|at| (at % 3 > 0).then(|| f64::from(at) / 7.0)).collect();
    let texts = (0..count).map(|at| (at % 2 > 0).then(|| format!("P{at}").into())).collect();
    let truths = (0..count).map(|at| Some(at % 5 == 0)).collect();
    let column = |name: &str, cells| Column { name: name.to_owned(), unit: "mm", cells };
    Table {
        columns: vec![
            column("id", Cells::Whole((0..count).map(|at| Some(at.into())).collect())),
            column("a", Cells::Number(numbers)),
            column("b", Cells::Text(texts)),
            column("c", Cells::Truth(truths)),
        ],
    }
}

#[test]
fn rows_are_read_back_as_they_were_written_and_the_same_rows_give_the_same_bytes() {
    for count in [0, 1, 5, 70_000] {
        let table = rows(count);
        let bytes = file::bytes(table.clone(), "plan").unwrap();
        assert!(bytes == file::bytes(table.clone(), "plan").unwrap());
        assert!(file::read(bytes, &table, "plan", &|_| true).unwrap() == table, "{count}");
    }
}

#[test]
fn a_file_that_is_torn_or_of_another_plan_is_not_read() {
    let table = rows(40);
    let bytes = file::bytes(table.clone(), "plan").unwrap();
    assert!(file::read(bytes.clone(), &table, "other", &|_| true).is_err());
    for length in 0..bytes.len() {
        assert!(file::read(bytes[..length].to_vec(), &table, "plan", &|_| true).is_err(), "{length}");
    }
}

#[test]
fn a_bit_that_turned_over_is_never_read_as_another_row() {
    let table = rows(40);
    let bytes = file::bytes(table.clone(), "plan").unwrap();
    for at in 0..8 * bytes.len() {
        let mut spoilt = bytes.clone();
        spoilt[at / 8] ^= 1 << (at % 8);
        // The library may trip over it, which the folder of chunks takes for damage.
        let read = catch_unwind(AssertUnwindSafe(|| file::read(spoilt, &table, "plan", &|_| true)));
        let read = read.ok().and_then(Result::ok);
        assert!(read.is_none_or(|read| read == table), "bit {} of byte {}", at % 8, at / 8);
    }
}

/// Writes a chunk on a disk whose step of a number fails, and gives how many steps there were.
fn write(folder: &Path, bytes: &[u8], fails: usize) -> (bool, usize) {
    let seen = Arc::new(AtomicUsize::new(0));
    let counted = Arc::clone(&seen);
    let disk = Disk::watched(move |_, _| {
        if counted.fetch_add(1, Ordering::SeqCst) == fails { Err(ErrorKind::StorageFull.into()) } else { Ok(()) }
    });
    let whole = Folder::open_on(folder, &disk).and_then(|folder| {
        let mut set = Set::new(&folder, &[], Existing::Replace);
        set.write("chunk.parquet".as_ref(), |out| out.write_all(bytes))?;
        set.commit().map(drop)
    });
    (whole.is_ok(), seen.load(Ordering::SeqCst))
}

#[test]
fn a_chunk_is_whole_or_as_before_wherever_the_disk_fails_and_however_often_it_is_written() {
    let [old, new] = [rows(10), rows(20)].map(|table| file::bytes(table, "plan").unwrap());
    let place = tempfile::tempdir().unwrap();
    let at = place.path().join("chunk.parquet");
    std::fs::write(&at, &old).unwrap();
    let (_, steps) = write(place.path(), &old, usize::MAX);
    assert!(steps > 5, "{steps}");
    for fails in 0..steps {
        std::fs::write(&at, &old).unwrap();
        let (whole, _) = write(place.path(), &new, fails);
        let there = std::fs::read(&at).unwrap();
        assert!(if whole { there == new } else { there == old || there == new }, "step {fails}");
    }
    // Two who write the same chunk at once.
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| assert!(write(place.path(), &new, usize::MAX).0));
        }
    });
    assert!(std::fs::read(&at).unwrap() == new);
}
