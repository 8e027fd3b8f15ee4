//! What is seen of a program's unit of length.

use crate::finding::Grade;
use crate::gcode::code::{G, Group};
use crate::gcode::control::UnitChange;
use crate::gcode::interpreter::block::letter;
use crate::gcode::interpreter::doubt::UNIT;
use crate::gcode::interpreter::library::Spot;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::interpreter::{Memory, Reader, doubt};
use crate::gcode::motion::FeedMode;
use crate::gcode::rules::modes::{
    FeedInEarlierUnit, FeedMeaningNotSaid, FeedUnitNotKnown, UnitBesideFeed, UnitNotSaid, UnitsChange,
};
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
    /// A code has said what F means, or it was told that none has.
    pub(super) feed_said: bool,
}

/// An F that the control has taken before the code beside it changed the unit.
#[derive(Clone, Copy, Debug)]
pub(super) struct FeedEarlier {
    /// The code.
    code: G,
    /// The unit before it.
    unit: LengthUnit,
    /// That unit is said: by an earlier code, or by the option.
    said: bool,
    /// The block of both, and the column of F.
    spot: Spot,
    column: usize,
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
        match (self.seen.units.moved_in.replace(unit), self.seen.units.told_at) {
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
        self.seen.units.inches |= unit == LengthUnit::Inch;
    }

    /// A motion goes at feed: remarked where no code has said what F means, and the machine may start with the other meaning.
    pub(super) fn see_feed(&mut self, mode: FeedMode, spot: Spot) {
        let rule = self.control.feed;
        if std::mem::replace(&mut self.seen.units.feed_said, true) || !rule.unsaid.told_of() {
            return;
        }
        let meaning = match mode {
            FeedMode::PerMinute => t("por minuto", "per minute"),
            FeedMode::PerRevolution => t("por vuelta", "per revolution"),
            FeedMode::InverseTime | FeedMode::Seconds => t("como tiempo", "as a time"),
        };
        let [minute, turn, ..] = rule.codes.names();
        self.remarks.row(&FeedMeaningNotSaid { meaning, minute, turn }, spot, None);
    }
}

impl Reader<'_, '_> {
    /// F and S beside a code that changes the unit. Where the control takes F in the earlier unit, that is told. Where no source says in
    /// which of the two they count, that is told, and a feed that hangs on it is refused. `motion` is the block's own. To be asked before the unit is taken, and behind F and S.
    pub(super) fn doubt_unit(&mut self, motion: Option<G>) -> Result<()> {
        let inch = self.state.modal.unit == LengthUnit::Inch;
        let changes = |code: &G| matches!(code, G::Inch | G::Millimetre) && (*code == G::Inch) != inch;
        let Some(code) = self.block.g(Group::Units).filter(changes) else { return Ok(()) };
        if !self.memory.control.order.unit_open() {
            self.see_feed_before_unit(code);
            return Ok(());
        }
        let at_once = self.block.g(Group::NonModal);
        if let Some(cycle) = at_once.and_then(G::by_letters) {
            let line = self.block.spot.line;
            let feed = cycle.feeds().iter().find(|&&feed| self.block.has(usize::from(feed - b'A')));
            return feed.map_or(Ok(()), |&feed| Err(self.feed_without_unit(char::from(feed), line, code)));
        }
        let by_length = matches!(self.state.modal.feed_mode, FeedMode::PerMinute | FeedMode::PerRevolution);
        let feed = self.block.has(letter::F) && by_length;
        if feed {
            self.state.modal.feed_unit = Some((self.block.spot.line, code));
        }
        let limit = at_once == Some(G::SetPositionOrSpeed);
        let surface = self.memory.control.spindle.turns.part() && self.state.modal.constant_surface_speed && !limit;
        let speed = self.block.has(letter::S) && surface;
        // A motion at feed of the block itself is refused.
        let told = feed && !matches!(motion, Some(G::Linear | G::Arc(_) | G::Cycle(_)));
        let words = [("F", told), ("S", speed)];
        let words: Vec<&str> = words.into_iter().filter(|(_, so)| *so).map(|(word, _)| word).collect();
        if !words.is_empty() {
            let row = UnitBesideFeed { words: words.join(", "), code: self.unit_code(code) };
            let (spot, column) = (self.block.spot, self.block.g_column(Group::Units));
            self.memory.remarks.row(&row, spot, Some(column));
        }
        Ok(())
    }

    /// Sees an F that the control takes before the code beside it changes the unit: told where a motion goes at it.
    fn see_feed_before_unit(&mut self, code: G) {
        // A time hangs on no unit.
        let by_length = matches!(self.state.modal.feed_mode, FeedMode::PerMinute | FeedMode::PerRevolution);
        if self.block.has(letter::F) && by_length && !self.in_doubt(UNIT) {
            let unit = self.state.modal.unit;
            // An option alone says that the control starts in inches.
            let said = self.memory.seen.units.told_at.is_some() || unit == LengthUnit::Inch;
            let (spot, column) = (self.block.spot, self.block.column(letter::F));
            self.state.modal.feed_earlier = Some(FeedEarlier { code, unit, said, spot, column });
        }
    }

    /// A motion goes at the feed in force: told where that was taken in an earlier unit than the code's beside it.
    pub(super) fn remark_feed_before_unit(&mut self) {
        let Some(FeedEarlier { code, unit, said, spot, column }) = self.state.modal.feed_earlier.take() else { return };
        let per_turn = self.state.modal.feed_mode == FeedMode::PerRevolution;
        let unit = match (per_turn, unit) {
            (false, LengthUnit::Millimetre) => t("mm/min", "mm/min"),
            (false, LengthUnit::Inch) => t("pulgadas/min", "inches/min"),
            (true, LengthUnit::Millimetre) => t("mm por vuelta", "mm per revolution"),
            (true, LengthUnit::Inch) => t("pulgadas por vuelta", "inches per revolution"),
        };
        let (place, taken, option) = if said {
            (t(", que cambia la unidad", ", which changes the unit"), t("en", "in"), t("", ""))
        } else {
            (
                t(", el primero que dice la unidad", ", the first that says the unit"),
                t(
                    "en la unidad que tenga en vigor, que rodete no sabe; la lee en",
                    "in the unit that is in force, which rodete does not know; it reads it in",
                ),
                t("; si el control empieza en pulgadas, dé --inch", "; if the control starts in inches, give --inch"),
            )
        };
        let row = FeedInEarlierUnit { code: self.unit_code(code), place, taken, unit, option };
        self.memory.remarks.row(&row, spot, Some(column));
    }

    /// Refuses a motion at a feed whose unit is in doubt. What comes behind it in the same feed follows from that.
    pub(super) fn feed_has_unit(&self) -> Result<()> {
        let Some((line, code)) = self.state.modal.feed_unit else { return Ok(()) };
        Err(self.feed_without_unit('F', line, code))
    }

    fn feed_without_unit(&self, word: char, line: usize, code: G) -> Box<Refused> {
        Refused::of(&FeedUnitNotKnown { word, line, code: self.unit_code(code) }, &[]).hanging_on(doubt::FEED)
    }

    /// The control's own code for a unit.
    fn unit_code(&self, code: G) -> String {
        self.memory.control.codes.names(code).into_iter().next().unwrap_or_default()
    }
}
