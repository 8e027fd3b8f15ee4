//! What is seen of a program's unit of length.

use crate::finding::Grade;
use crate::gcode::code::G;
use crate::gcode::control::UnitChange;
use crate::gcode::interpreter::Memory;
use crate::gcode::interpreter::doubt::UNIT;
use crate::gcode::interpreter::library::Spot;
use crate::gcode::rules::modes::{UnitNotSaid, UnitsChange};
use crate::machine::length_unit::LengthUnit;
use crate::text::t;

/// How a program tells its unit, and what it moves in.
#[derive(Debug, Default)]
pub(super) struct UnitsSeen {
    /// Where it told it last: the block and its column.
    told_at: Option<(Spot, usize)>,
    /// What the last motion was made in.
    moved_in: Option<LengthUnit>,
    /// A motion has been made in inches.
    pub(super) inches: bool,
}

impl UnitsSeen {
    /// The program tells its unit.
    pub(super) const fn tell(&mut self, spot: Spot, column: usize) {
        self.told_at = Some((spot, column));
    }
}

impl Memory<'_> {
    /// A linear axis moves in a unit.
    pub(super) fn see_unit(&mut self, unit: LengthUnit, spot: Spot) {
        let control = self.control;
        match (self.units.moved_in.replace(unit), self.units.told_at) {
            (Some(before), _) if before == unit => return,
            // A rejected block may have told it.
            (None, None) if self.doubts.holds(UNIT) => {}
            (None, None) => {
                let code = |unit: G| control.codes.names(unit).into_iter().next().unwrap_or_default();
                let name = match unit {
                    LengthUnit::Millimetre => t("mm", "mm"),
                    LengthUnit::Inch => t("pulgadas", "inches"),
                };
                let row = UnitNotSaid { unit: name, metric: code(G::Millimetre), inch: code(G::Inch) };
                self.remarks.row(&row, spot, None);
            }
            (Some(_), Some((spot, column))) => {
                let grade = match control.start.units {
                    UnitChange::Anywhere => Grade::Note,
                    UnitChange::AtBeginning => Grade::Caution,
                };
                self.remarks.row_as(grade, &UnitsChange {}, spot, Some(column));
            }
            (None, Some(_)) | (Some(_), None) => {}
        }
        self.units.inches |= unit == LengthUnit::Inch;
    }
}
