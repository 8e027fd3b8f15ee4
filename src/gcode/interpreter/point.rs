//! Numbers without a decimal point: the control says which letters count what, and a setting of it whether they do.

use crate::gcode::code::{G, Group, SinglePassCycle, TurningCycle};
use crate::gcode::control::{ImpliedPoint, Pointing, Quantity, Unpointed};
use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block::{EdgeWord, letter};
use crate::gcode::interpreter::cursor::Decimal;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::motion::FeedMode;
use crate::gcode::rules::words::{
    DimensionsWithoutPoint, DwellsWithoutPoint, PointMissing, PointMissingInFeed, PointNotTaken,
};
use crate::machine::length_unit::LengthUnit;

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
        if let Some(G::Turning(cycle)) = self.block.g(Group::NonModal)
            && !self.block.has(letter::P)
        {
            self.block.pointless &= !cycle.times().mask();
        }
        if !self.feed_by_revolution() {
            self.block.pointless &= !(1 << letter::F);
        }
        self.block.pointless &= !self.counted_dwell();
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
        let quantity = match (dwell, self.inch()) {
            (true, _) => Quantity::Second,
            (false, true) => Quantity::Inch,
            (false, false) => Quantity::Millimetre,
        };
        let ImpliedPoint { by, told: reading } =
            match self.memory.control.lexis.point.reading(quantity, feed, self.memory.setting.decimal_point) {
                Ok(reading) => reading,
                Err(Unpointed::BySettingUnknown(reading)) => {
                    return Err(Refused::of(&PointMissing { word: word.to_owned(), reading }, &[column]));
                }
                Err(Unpointed::FeedUnknown) => {
                    return Err(Refused::of(&PointMissingInFeed { word: word.to_owned() }, &[column]));
                }
            };
        let spot = self.block.spot;
        if dwell {
            self.memory.remarks.row(&DwellsWithoutPoint { reading }, spot, Some(column));
        } else {
            self.memory.remarks.row(&DimensionsWithoutPoint { reading }, spot, Some(column));
        }
        Ok(by)
    }

    /// The letters of the block's dwell whose number counts parts of a second, whatever a setting makes of a length.
    fn counted_dwell(&self) -> u32 {
        if self.block.g(Group::NonModal) != Some(G::Dwell) {
            return 0;
        }
        let words = self.memory.control.lexis.dwell.iter().filter(|word| word.unit.whole());
        words.map(|word| 1 << word.index()).sum()
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

#[cfg(test)]
mod tests {
    use crate::gcode::control::{Control, DecimalPoint, DwellUnit, DwellWord, FANUC_LATHE_A, Lexis};
    use crate::gcode::interpreter::{Interpreter, Setting};
    use crate::gcode::motion::MotionKind;

    /// A lathe whose dwell counts X in hundredths of a second, though X is a letter of lengths.
    static HUNDREDTHS: Control = Control {
        lexis: Lexis {
            dwell: &[DwellWord { letter: 'X', unit: DwellUnit::Hundredth, shared: false }],
            ..FANUC_LATHE_A.lexis
        },
        ..FANUC_LATHE_A
    };

    #[test]
    fn a_dwell_in_parts_of_a_second_is_not_divided() {
        let dwelt = |control: &'static Control, point: DecimalPoint| -> Vec<f64> {
            let setting = Setting { decimal_point: Some(point), ..Setting::new(control) };
            let motions = Interpreter::over(b"G4 X150\nM30\n", setting).flatten().collect::<Vec<_>>();
            let time = |kind: MotionKind| if let MotionKind::Dwell(seconds) = kind { Some(seconds) } else { None };
            motions.into_iter().filter_map(|motion| time(motion.kind)).collect()
        };
        for (point, seconds) in [(DecimalPoint::Calculator, 150.0), (DecimalPoint::Micrometre, 0.15)] {
            assert_eq!(dwelt(&FANUC_LATHE_A, point), [seconds]);
            assert_eq!(dwelt(&HUNDREDTHS, point), [1.5]);
        }
    }
}
