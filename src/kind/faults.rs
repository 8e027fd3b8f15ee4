//! What only a kind's own code can be wrong in, whatever the workbook says: its tables, its derived values and the programs
//! that it hands over.

use super::rules::{
    ColumnsUneven, NoProgramWritten, NothingDue, ProgramNotListed, ProgramTwice, ProgramsForOtherControl,
    QuantityNotFinite,
};
use crate::finding::rules::ValueNotFinite;
use crate::finding::{Finding, Place, Raise};
use crate::gcode::control::Control;
use crate::gcode::program::Program;
use crate::parameter::Form;
use crate::proof::due::Due;
use crate::table::{Quantity, Table};

/// The first table with columns of several lengths, or with a value that is no number.
pub(super) fn tables(tables: &[Table]) -> Option<Finding> {
    tables.iter().find_map(|table| {
        let rows = table.rows();
        let uneven = table.columns.iter().find(|column| column.values.len() != rows).map(|column| {
            let (column, count) = (column.symbol.clone(), column.values.len());
            ColumnsUneven { table: table.key, column, count, rows }.at(Place::File)
        });
        let not_finite =
            || table.not_finite().map(|(_, row)| ValueNotFinite {}.at(Place::Point { table: table.key, index: row }));
        uneven.or_else(not_finite)
    })
}

/// The first derived value that is no number.
pub(super) fn quantities(quantities: &[Quantity]) -> Option<Finding> {
    let wrong = quantities.iter().find(|quantity| !quantity.value.is_finite())?;
    Some(QuantityNotFinite { symbol: wrong.symbol }.at(Place::File))
}

/// What is wrong with the programs as they are handed over, `due` being what the judges of one must answer.
pub(super) fn programs(
    form: &Form,
    control: &'static Control,
    programs: &[Program],
    due: impl Fn(&Program) -> Vec<Due>,
) -> Vec<Finding> {
    let mut found = Vec::new();
    if programs.is_empty() {
        found.push(NoProgramWritten {}.at(Place::File));
    } else if !programs.iter().any(|program| program.is_for(control)) {
        found.push(
            ProgramsForOtherControl { control: control.name, programs: programs[0].control.name }.at(Place::File),
        );
    }
    for (at, program) in programs.iter().enumerate() {
        let key = program.key;
        if !form.programs.contains(&key) {
            found.push(ProgramNotListed { program: key, listed: form.programs.join(", ") }.at(Place::File));
        }
        if programs[..at].iter().any(|before| before.key == key) {
            found.push(ProgramTwice { program: key }.at(Place::File));
        }
        if due(program).is_empty() {
            found.push(NothingDue { program: key }.at(Place::File));
        }
    }
    found
}
