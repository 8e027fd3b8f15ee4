//! Why a workbook could not be written.

use rust_xlsxwriter::XlsxError;

/// Why a workbook could not be written.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// A value that a sheet cannot hold: a fault in rodete, never the user's.
    #[error("{place} is not a finite number")]
    NotFinite {
        /// Where the value stands: table, column and row, or the parameter.
        place: String,
    },
    /// The workbook could not be put together or written out.
    #[error(transparent)]
    Workbook(#[from] XlsxError),
    /// A program's text could not be produced.
    #[error(transparent)]
    Text(#[from] std::io::Error),
}
