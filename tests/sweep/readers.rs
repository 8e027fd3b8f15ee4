//! The rows as others read them: DuckDB and pandas.

use std::path::Path;
use std::process::Command;

use crate::common::workbook::with_variants;

/// The Python with DuckDB and pandas.
const PYTHON: &str = "RODETE_ROWS_PYTHON";

#[test]
fn duckdb_and_pandas_read_the_rows() {
    let python = std::env::var(PYTHON).unwrap_or_else(|_| "python3".to_owned());
    let has = Command::new(&python).args(["-c", "import duckdb, pandas, pyarrow"]).output();
    if !has.is_ok_and(|output| output.status.success()) {
        assert!(std::env::var_os("CI").is_none(), "{python} has no duckdb, pandas and pyarrow");
        eprintln!("skipped: {python} has no duckdb, pandas and pyarrow; {PYTHON} names one that has");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let settings = [("method", "factorial"), ("level", "limits"), ("objectives", "gap_true max")];
    let inputs = [["R", "22", "30", "4", "", ""], ["e", "1", "4", "1", "", ""]];
    std::fs::write(folder.path().join("a.xlsx"), with_variants(&settings, &inputs, &[])).unwrap();
    let swept = Command::new(env!("CARGO_BIN_EXE_rodete"))
        .current_dir(folder.path())
        .args(["sweep", "a.xlsx", "-o", "s", "--chunks", "3", "--top", "0"])
        .output()
        .unwrap();
    assert!(swept.status.success(), "{}", String::from_utf8_lossy(&swept.stderr));
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/sweep/readers.py");
    let read = Command::new(python).arg(script).arg(folder.path().join("s")).output().unwrap();
    assert!(read.status.success(), "{}", String::from_utf8_lossy(&read.stderr));
    assert_eq!(String::from_utf8_lossy(&read.stdout).trim(), "12 rows");
}
