//! The turret of a lathe: T turns it to a place, and an offset goes into force.
//!
//! The offset says where the tip lies against the turret's reference point: the machine stays where it is, and the program's
//! coordinates of this place change. No motion is made; where a machine goes to its reference point to turn the turret, its
//! program says so.
//!
//! # References
//! The lathe simulator's description of T0A0B; Fanuc Series 0i-T operator's manual: the last two digits are the offset, 0 for
//! none. Fagor 8055 T: T the tool, D the offset.

use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block::letter;
use crate::gcode::interpreter::expression::whole;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::turning::rules::{NoTurretPlace, OffsetAlone, OffsetNotInTable, ToolNotInTurret};
use crate::machine::axis::Pose;
use crate::machine::work_offset::ActiveOffsets;
use crate::text::{Text, one_of};

impl Reader<'_, '_> {
    /// T and D of a lathe.
    pub(super) fn turn_by_words(&mut self) -> Result<()> {
        let T = self.block.get(letter::T);
        let D = self.block.get(letter::D).filter(|_| !self.has_turning_cycle());
        let place = T.map(|T| self.tool_number(letter::T, T)).transpose()?;
        // An offset is a number of its own: T3 D1 works with the first offset.
        let (offset, column) = match D {
            Some(D) => (Some(self.number_of(letter::D, D)?), self.block.column(letter::D)),
            None => (place, self.block.column(letter::T)),
        };
        self.known(column, offset.unwrap_or_default(), true)?;
        if place.is_some() || offset.is_some() {
            self.put_in(place.unwrap_or(self.state.modal.tool), offset.unwrap_or(self.state.modal.offset));
        }
        Ok(())
    }

    /// T0A0B.
    pub(super) fn turn_by_digits(&mut self) -> Result<()> {
        if let Some((place, offset)) = self.turret_place()? {
            self.put_in(place, offset);
        }
        Ok(())
    }

    /// The place and the offset of the T0A0B of the block in hand.
    pub(super) fn turret_place(&self) -> Result<Option<(u32, u32)>> {
        let Some(T) = self.block.get(letter::T) else { return Ok(None) };
        let column = self.block.column(letter::T);
        let Some(digits) = whole(T).and_then(|digits| u32::try_from(digits).ok()).filter(|digits| *digits <= 9999)
        else {
            return Err(Refused::of(&NoTurretPlace { value: T }, &[column]));
        };
        let (place, offset) = (digits / 100, digits % 100);
        if place == 0 && offset != 0 {
            return Err(Refused::of(&OffsetAlone { value: T, offset, readings: readings(offset) }, &[column]));
        }
        self.known(column, place, false)?;
        self.known(column, offset, true)?;
        Ok(Some((place, offset)))
    }

    /// Refuses a place or an offset that the table does not hold.
    fn known(&self, column: usize, number: u32, offset: bool) -> Result<()> {
        let there = if offset {
            number == 0 || self.memory.setting.tools.is_none() || self.memory.tools.contains_key(&number)
        } else {
            self.has_place(number)
        };
        if there {
            return Ok(());
        }
        Err(if offset {
            Refused::of(&OffsetNotInTable { offset: number }, &[column])
        } else {
            Refused::of(&ToolNotInTurret { tool: number }, &[column])
        })
    }

    /// True for a place or a tool that is there, and where none is known.
    pub(super) fn has_place(&self, number: u32) -> bool {
        let known = match &self.memory.setting.places {
            Some(places) => places.contains(&number),
            None => self.memory.setting.tools.is_none() || self.memory.tools.contains_key(&number),
        };
        number == 0 || known
    }

    fn put_in(&mut self, place: u32, offset: u32) {
        (self.state.modal.selected, self.state.modal.tool, self.state.modal.offset) = (Some(place), place, offset);
        self.memory.seen.turned.offset |= offset != 0;
        let tool = if offset == 0 { Pose::default() } else { self.offset_of(offset) };
        self.reframe(ActiveOffsets { tool, ..self.state.frame });
    }
}

/// What one or two digits behind T may have been meant for: a place with the offset of its own number, or one digit for each. The
/// program does not say which.
fn readings(digits: u32) -> Text {
    let reading = |place: u32, offset: u32| {
        let (es, en) = match offset {
            0 => ("sin corrector".to_owned(), "without an offset".to_owned()),
            offset => (format!("con el corrector {offset}"), format!("with offset {offset}")),
        };
        let word = format!("T{place:02}{offset:02}");
        Text::new(format!("{word} es el puesto {place} {es}"), format!("{word} is place {place} {en}"))
    };
    let own = reading(digits, digits);
    if digits < 10 { own } else { one_of([own, reading(digits / 10, digits % 10)]) }
}
