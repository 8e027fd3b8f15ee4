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
    /// The package could not be written.
    #[error(transparent)]
    Package(#[from] zip::result::ZipError),
    /// The output refused the bytes.
    #[error(transparent)]
    Output(#[from] std::io::Error),
    /// A table does not fit on a sheet.
    #[error("{0} is larger than a sheet can be")]
    TooLarge(&'static str),
    /// A table's columns are not of one length: a fault in rodete.
    #[error("the columns of {0} are not of one length")]
    Uneven(&'static str),
    /// A formula refers to a column that is not there: a fault in rodete.
    #[error("no column for a reference in {0}")]
    Reference(String),
    /// The frame for a long sheet is not as it was made: a fault in rodete.
    #[error("the frame of a long sheet has {0}")]
    Skeleton(&'static str),
}
