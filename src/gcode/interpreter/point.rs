//! Numbers without a decimal point in Fanuc's system A: a setting of the control says whether X100 is 100 mm or 0.1 mm.
//!
//! # References
//! Fanuc Series 0i-T operator's manual, decimal point programming: pocket calculator type and usual type; addresses that take a
//! decimal point are lengths, times and feeds; M, T, L, P, Q and others take none.

use crate::gcode::code::{G, Group, SinglePassCycle, TurningCycle};
use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block::{EdgeWord, letter};
use crate::gcode::interpreter::cursor::Decimal;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::interpreter::setting::DecimalPoint;
use crate::gcode::letters::Letters;
use crate::gcode::motion::FeedMode;
use crate::gcode::rules::words::{
    DimensionsWithoutPoint, DwellsWithoutPoint, PointMissing, PointMissingInFeed, PointNotTaken,
};
use crate::machine::length_unit::LengthUnit;
use crate::text::t;

/// Addresses whose number may be scaled where it has no decimal point.
const SCALED: Letters = Letters::of("FIKRUWXZ");
/// Addresses that take no decimal point.
const WHOLE: Letters = Letters::of("LMPQT");

impl Reader<'_, '_> {
    /// Marks a number without a decimal point, and refuses a decimal point where none may be.
    #[inline(never)]
    pub(super) fn see_point(&mut self, index: u8, number: &Decimal, column: usize) -> Result<()> {
        if number.point && WHOLE.has(index) {
            let name = char::from(b'A' + index);
            let value = number.value;
            let word = if value.fract() == 0.0 { format!("{name}{value}.") } else { format!("{name}{value}") };
            return Err(Refused::of(&PointNotTaken { letter: name, word }, &[column]));
        }
        if !number.point && number.value != 0.0 && SCALED.has(index) {
            self.block.pointless |= 1 << index;
        }
        Ok(())
    }

    /// Gives the numbers of the block that have no decimal point their value.
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
        let by = match self.memory.setting.decimal_point {
            None => {
                let (es, en) = match self.inch() {
                    _ if dwell => ("s o ms", "s or ms"),
                    true => ("pulgadas o diezmilésimas", "inches or ten-thousandths"),
                    false => ("mm o µm", "mm or µm"),
                };
                return Err(Refused::of(&PointMissing { word: word.to_owned(), reading: t(es, en) }, &[column]));
            }
            Some(DecimalPoint::Calculator) => 1.0,
            Some(DecimalPoint::Micrometre) if feed => {
                return Err(Refused::of(&PointMissingInFeed { word: word.to_owned() }, &[column]));
            }
            Some(DecimalPoint::Micrometre) => {
                if self.inch() && !dwell {
                    10_000.0
                } else {
                    1_000.0
                }
            }
        };
        let spot = self.block.spot;
        let calculator = self.memory.setting.decimal_point == Some(DecimalPoint::Calculator);
        let (es, en) = match (calculator, self.inch()) {
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
