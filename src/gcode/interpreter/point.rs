//! Numbers without a decimal point in Fanuc's system A: a setting of the control says whether X100 is 100 mm or 0.1 mm.
//!
//! # References
//! Fanuc Series 0i-T operator's manual, decimal point programming: pocket calculator type and usual type; addresses that take a
//! decimal point are lengths, times and feeds; M, T, L, P, Q and others take none.

use crate::gcode::code::{G, Group, SinglePassCycle, TurningCycle};
use crate::gcode::control::{Measured, Pointing, Unpointed};
use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block::{EdgeWord, letter};
use crate::gcode::interpreter::cursor::Decimal;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::motion::FeedMode;
use crate::gcode::rules::words::{
    DimensionsWithoutPoint, DwellsWithoutPoint, PointMissing, PointMissingInFeed, PointNotTaken,
};
use crate::machine::length_unit::LengthUnit;
use crate::text::t;

impl Reader<'_, '_> {
    /// Marks a number that is to be divided, and refuses a decimal point where none may be.
    #[inline]
    pub(super) fn see_point(&mut self, index: u8, number: &Decimal, column: usize) -> Result<()> {
        match self.memory.control.lexis.point.of(index, number.point) {
            Pointing::AsWritten => Ok(()),
            Pointing::NotTaken => Err(point_not_taken(index, number.value, column)),
            Pointing::Divided => {
                self.block.pointless |= u32::from(number.value != 0.0) << index;
                Ok(())
            }
        }
    }

    /// Gives the numbers of the block that are to be divided their value.
    #[inline(never)]
    pub(super) fn settle_points(&mut self) -> Result<()> {
        if self.block.g(Group::NonModal) == Some(G::Turning(TurningCycle::Repeat)) && !self.block.has(letter::P) {
            // How many times.
            self.block.pointless &= !(1 << letter::R);
        }
        if !self.feed_by_revolution() {
            self.block.pointless &= !(1 << letter::F);
        }
        let words = self.block.pointless;
        for index in (0..26).filter(|index| words & (1 << index) != 0) {
            let value = self.block.get(index).unwrap_or(0.0);
            let name = char::from(b'A' + u8::try_from(index).unwrap_or(0));
            let column = self.block.column(index);
            let by = self.unpointed(&format!("{name}{value}"), column, index == letter::F)?;
            self.block.divide(index, by);
        }
        if let Some(edge) = self.block.edge.filter(|edge| edge.pointless) {
            let by = self.unpointed(&format!("{}{}", edge.name, edge.value), edge.column, false)?;
            self.block.edge = Some(EdgeWord { value: edge.value / by, ..edge });
        }
        Ok(())
    }

    /// By what a number without a decimal point is divided.
    fn unpointed(&mut self, word: &str, column: usize, feed: bool) -> Result<f64> {
        let dwell = self.block.g(Group::NonModal) == Some(G::Dwell);
        let inch = self.inch();
        let measured = match feed {
            true => Measured::Feed,
            false if dwell => Measured::Time,
            false => Measured::Length { inch },
        };
        let by = match self.memory.control.lexis.point.divisor(measured, self.memory.setting.decimal_point) {
            Ok(by) => by,
            Err(Unpointed::BySettingUnknown) => {
                let (es, en) = match inch {
                    _ if dwell => ("s o ms", "s or ms"),
                    true => ("pulgadas o diezmilésimas", "inches or ten-thousandths"),
                    false => ("mm o µm", "mm or µm"),
                };
                return Err(Refused::of(&PointMissing { word: word.to_owned(), reading: t(es, en) }, &[column]));
            }
            Err(Unpointed::FeedUnknown) => {
                return Err(Refused::of(&PointMissingInFeed { word: word.to_owned() }, &[column]));
            }
        };
        let spot = self.block.spot;
        let calculator = by == 1.0;
        let (es, en) = match (calculator, inch) {
            _ if dwell && calculator => ("leídos como s", "read as s"),
            _ if dwell => ("leídos como ms", "read as ms"),
            (true, false) => ("leídas como mm", "read as mm"),
            (true, true) => ("leídas como pulgadas", "read as inches"),
            (false, false) => ("leídas como incrementos mínimos (0.001 mm)", "read as least increments (0.001 mm)"),
            (false, true) => {
                ("leídas como incrementos mínimos (0.0001 pulgadas)", "read as least increments (0.0001 inch)")
            }
        };
        if dwell {
            self.memory.remarks.row(&DwellsWithoutPoint { reading: t(es, en) }, spot, Some(column));
        } else {
            self.memory.remarks.row(&DimensionsWithoutPoint { reading: t(es, en) }, spot, Some(column));
        }
        Ok(by)
    }

    /// True where the block's lengths are inches.
    fn inch(&self) -> bool {
        match self.block.g(Group::Units) {
            Some(unit) => unit == G::Inch,
            None => self.state.modal.unit == LengthUnit::Inch,
        }
    }

    /// True where the block's F is a length: a feed per revolution, or a lead.
    fn feed_by_revolution(&self) -> bool {
        let thread = matches!(
            self.block.g(Group::Motion).unwrap_or(self.state.modal.motion),
            G::Thread(_) | G::Pass(SinglePassCycle::Thread)
        );
        let mode = match self.block.g(Group::Feed) {
            Some(G::Feed(mode)) => mode,
            _ => self.state.modal.feed_mode,
        };
        thread
            || mode == FeedMode::PerRevolution
            || self.block.g(Group::NonModal) == Some(G::Turning(TurningCycle::Thread))
    }
}

#[cold]
fn point_not_taken(index: u8, value: f64, column: usize) -> Box<Refused> {
    let name = char::from(b'A' + index);
    let word = if value.fract() == 0.0 { format!("{name}{value}.") } else { format!("{name}{value}") };
    Refused::of(&PointNotTaken { letter: name, word }, &[column])
}
