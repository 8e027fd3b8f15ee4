//! Rows as a Parquet file: written row group by row group, and read back.
//!
//! Columns may be empty in any row but for `id`: what a design does not have is null, never 0. The units, what the plan says and a
//! checksum of each column stand in the file's key-value data. The same rows and data give the same bytes.

use std::io::Write;
use std::sync::Arc;

use bytes::Bytes;
use crc32fast::Hasher;
use parquet::basic::{Compression, ConvertedType, LogicalType, Repetition, Type as Physical};
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::column::writer::{ColumnWriter, ColumnWriterImpl};
use parquet::data_type::{ByteArray, DataType};
use parquet::errors::{ParquetError, Result};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{Type, TypePtr};

use super::table::{Cells, Table};

/// Rows of a row group: groups of a summary do not depend on the chunks that it comes from.
pub const GROUP: usize = 65_536;

/// The key of what the plan says.
pub const PLAN: &str = "rodete.plan";
/// The keys of the columns' checksums begin so.
const SUM: &str = "crc32.";

/// A file that is being written.
pub struct RowFile<W: Write + Send> {
    writer: SerializedFileWriter<W>,
    pending: Table,
    /// The names of the columns, each with the checksum of what was written of it.
    sums: Vec<(String, Hasher)>,
}

impl<W: Write + Send> RowFile<W> {
    /// A file with the columns of a table, whose rows are not taken in.
    ///
    /// # Errors
    /// What the output refuses.
    pub fn new(out: W, table: &Table, plan: &str) -> Result<Self> {
        let units = table.columns.iter().filter(|one| !one.unit.is_empty());
        let told = units.map(|one| KeyValue::new(format!("unit.{}", one.name), one.unit.to_owned()));
        let told = std::iter::once(KeyValue::new(PLAN.to_owned(), plan.to_owned())).chain(told).collect();
        let properties = WriterProperties::builder()
            .set_created_by(format!("rodete {}", env!("CARGO_PKG_VERSION")))
            .set_compression(Compression::SNAPPY)
            .set_statistics_enabled(EnabledStatistics::Chunk)
            .set_key_value_metadata(Some(told))
            .build();
        let writer = SerializedFileWriter::new(out, schema(table)?, Arc::new(properties))?;
        let sums = table.columns.iter().map(|one| (one.name.clone(), Hasher::new())).collect();
        Ok(Self { writer, pending: table.emptied(), sums })
    }

    /// Takes rows in.
    ///
    /// # Errors
    /// What the output refuses.
    pub fn write(&mut self, rows: Table) -> Result<()> {
        self.pending.append(rows);
        while self.pending.rows() >= GROUP {
            let group = self.pending.split(GROUP);
            self.group(&group)?;
        }
        Ok(())
    }

    /// Ends the file.
    ///
    /// # Errors
    /// What the output refuses.
    pub fn end(mut self) -> Result<()> {
        if self.pending.rows() > 0 {
            let group = std::mem::replace(&mut self.pending, Table { columns: Vec::new() });
            self.group(&group)?;
        }
        for (name, sum) in self.sums {
            self.writer.append_key_value_metadata(KeyValue::new(format!("{SUM}{name}"), told_sum(sum)));
        }
        self.writer.close().map(drop)
    }

    fn group(&mut self, rows: &Table) -> Result<()> {
        let mut group = self.writer.next_row_group()?;
        for ((_, sum), column) in self.sums.iter_mut().zip(&rows.columns) {
            column.cells.add_to(sum);
        }
        for (at, column) in rows.columns.iter().enumerate() {
            let Some(mut out) = group.next_column()? else { return Err(uneven()) };
            let optional = at > 0;
            match (out.untyped(), &column.cells) {
                (ColumnWriter::Int64ColumnWriter(out), Cells::Whole(cells)) => put(out, cells, optional, |one| *one)?,
                (ColumnWriter::DoubleColumnWriter(out), Cells::Number(cells)) => put(out, cells, optional, |one| *one)?,
                (ColumnWriter::BoolColumnWriter(out), Cells::Truth(cells)) => put(out, cells, optional, |one| *one)?,
                (ColumnWriter::ByteArrayColumnWriter(out), Cells::Text(cells)) => {
                    put(out, cells, optional, |one| ByteArray::from(one.as_bytes().to_vec()))?;
                }
                _ => return Err(uneven()),
            }
            out.close()?;
        }
        group.close().map(drop)
    }
}

/// A checksum as the file says it.
fn told_sum(sum: Hasher) -> String {
    format!("{:08x}", sum.finalize())
}

fn put<D: DataType, T>(
    out: &mut ColumnWriterImpl<'_, D>,
    cells: &[Option<T>],
    optional: bool,
    value: impl Fn(&T) -> D::T,
) -> Result<()> {
    let values: Vec<D::T> = cells.iter().flatten().map(value).collect();
    let levels: Vec<i16> = cells.iter().map(|one| i16::from(one.is_some())).collect();
    out.write_batch(&values, optional.then_some(levels.as_slice()), None).map(drop)
}

fn uneven() -> ParquetError {
    ParquetError::General("columns of another plan".to_owned())
}

/// The schema of a table; the first column has a value in every row.
fn schema(table: &Table) -> Result<TypePtr> {
    let fields = table.columns.iter().enumerate().map(|(at, column)| {
        let physical = match column.cells {
            Cells::Whole(_) => Physical::INT64,
            Cells::Number(_) => Physical::DOUBLE,
            Cells::Text(_) => Physical::BYTE_ARRAY,
            Cells::Truth(_) => Physical::BOOLEAN,
        };
        let field = Type::primitive_type_builder(&column.name, physical).with_repetition(if at == 0 {
            Repetition::REQUIRED
        } else {
            Repetition::OPTIONAL
        });
        let field = if physical == Physical::BYTE_ARRAY {
            field.with_converted_type(ConvertedType::UTF8).with_logical_type(Some(LogicalType::String))
        } else {
            field
        };
        field.build().map(Arc::new)
    });
    let fields = fields.collect::<Result<Vec<_>>>()?;
    Type::group_type_builder("rodete").with_fields(fields).build().map(Arc::new)
}

/// The bytes of a file of these rows.
///
/// # Errors
/// Never for rows of one plan.
pub fn bytes(rows: Table, plan: &str) -> Result<Vec<u8>> {
    let mut out = Vec::new();
    let mut file = RowFile::new(&mut out, &rows, plan)?;
    file.write(rows)?;
    file.end()?;
    Ok(out)
}

/// The rows of a file with the columns of a table; of columns that are not wanted, nothing but the first is read.
///
/// # Errors
/// For a file that is torn, for one of another plan, and where what is read of a column has not the checksum of what was written.
pub fn read(bytes: Vec<u8>, table: &Table, plan: &str, wanted: &dyn Fn(&str) -> bool) -> Result<Table> {
    let file = SerializedFileReader::new(Bytes::from(bytes))?;
    let told = file.metadata().file_metadata();
    let stated = |key: &str| {
        let mut all = told.key_value_metadata().into_iter().flatten();
        all.find(|one| one.key == key).and_then(|one| one.value.as_deref())
    };
    if stated(PLAN) != Some(plan) || told.schema_descr().num_columns() != table.columns.len() {
        return Err(uneven());
    }
    let reads = |at: usize, name: &str| at == 0 || wanted(name);
    let mut rows = table.emptied();
    for group in 0..file.num_row_groups() {
        let group = file.get_row_group(group)?;
        let count = usize::try_from(group.metadata().num_rows()).map_err(|_| uneven())?;
        for (at, column) in rows.columns.iter_mut().enumerate() {
            if !reads(at, &column.name) {
                continue;
            }
            let optional = at > 0;
            match (group.get_column_reader(at)?, &mut column.cells) {
                (ColumnReader::Int64ColumnReader(from), Cells::Whole(cells)) => {
                    take(from, count, optional, cells, Some)?
                }
                (ColumnReader::DoubleColumnReader(from), Cells::Number(cells)) => {
                    take(from, count, optional, cells, Some)?
                }
                (ColumnReader::BoolColumnReader(from), Cells::Truth(cells)) => {
                    take(from, count, optional, cells, Some)?
                }
                (ColumnReader::ByteArrayColumnReader(from), Cells::Text(cells)) => {
                    take(from, count, optional, cells, |one: ByteArray| one.as_utf8().ok().map(Into::into))?;
                }
                _ => return Err(uneven()),
            }
        }
    }
    for (_, column) in rows.columns.iter().enumerate().filter(|(at, column)| reads(*at, &column.name)) {
        let mut sum = Hasher::new();
        column.cells.add_to(&mut sum);
        if stated(&format!("{SUM}{}", column.name)) != Some(&told_sum(sum)) {
            return Err(ParquetError::General(format!("{} is not what was written", column.name)));
        }
    }
    Ok(rows)
}

fn take<D: DataType, T>(
    mut from: ColumnReaderImpl<D>,
    count: usize,
    optional: bool,
    cells: &mut Vec<Option<T>>,
    value: impl Fn(D::T) -> Option<T>,
) -> Result<()> {
    let (mut values, mut levels) = (Vec::with_capacity(count), Vec::with_capacity(count));
    let (records, _, _) = from.read_records(count, optional.then_some(&mut levels), None, &mut values)?;
    if records != count {
        return Err(uneven());
    }
    let mut values = values.into_iter();
    if optional {
        cells.extend(levels.into_iter().map(|level| if level == 1 { values.next().and_then(&value) } else { None }));
    } else {
        cells.extend(values.map(value));
    }
    Ok(())
}
