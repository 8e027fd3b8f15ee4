//! Polar coordinates: `@` is the distance from the origin of the program's XY plane, `^` the angle in degrees.
//!
//! # References
//! LinuxCNC, "Polar Coordinates": G17 alone, not beside X or Y, not with G53; under G91 `@` and `^` are added to the distance and
//! the angle of where the tool stands, which must not be the origin.

use crate::gcode::code::{G, Group};
use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block::letter;
use crate::gcode::interpreter::cursor::Cursor;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::motion::Plane;
use crate::gcode::rules::geometry::{
    PolarAtOrigin, PolarBesideAxes, PolarBesideCode, PolarPlane, PolarRepeated, PolarTooGreat, PolarTwice,
};
use crate::gcode::rules::words::PolarByLetters;
use crate::machine::axis::Axis;
use crate::number::grid::LIMIT;
use crate::number::trig;

/// Groups beside which polar words stand: motion, distance mode, what F means and how cycles return.
const BESIDE: [Group; 5] = [Group::Motion, Group::Distance, Group::Feed, Group::Retract, Group::Path];

impl Reader<'_, '_> {
    /// Reads `@` or `^`, on which the cursor stands.
    pub(super) fn read_polar(&mut self, cursor: &mut Cursor<'_>) -> Result<()> {
        let (column, angle) = (cursor.column(), cursor.peek() == b'^');
        cursor.pass();
        let value = self.value(cursor)?.value;
        if value.abs() > f64::from(LIMIT) / 1000.0 {
            return Err(Refused::of(&PolarTooGreat {}, &[column]));
        }
        match self.block.polar[usize::from(angle)].replace((value, column)) {
            None => Ok(()),
            Some(_) => Err(Refused::of(&PolarTwice {}, &[column])),
        }
    }

    /// The refusal of R or Q as a polar word of a motion, by the plane in force.
    pub(super) fn polar_by_letters(&self, letter: char, column: usize) -> Box<Refused> {
        let plane = match self.block.g(Group::Plane) {
            Some(G::Plane(plane)) => plane,
            _ => self.state.modal.plane,
        };
        let [first, second] = match plane {
            Plane::XY => ['X', 'Y'],
            Plane::ZX => ['X', 'Z'],
            Plane::YZ => ['Y', 'Z'],
        };
        Refused::of(&PolarByLetters { letter, first, second }, &[column])
    }

    /// Puts the X and the Y in place of the polar words of the block.
    pub(super) fn settle_polar(&mut self) -> Result<()> {
        let [radius, angle] = self.block.polar;
        let Some((_, column)) = radius.or(angle) else { return Ok(()) };
        if self.block.has(letter::X) || self.block.has(letter::Y) {
            return Err(Refused::of(&PolarBesideAxes {}, &[column]));
        }
        if self.state.modal.plane != Plane::XY {
            return Err(Refused::of(&PolarPlane {}, &[column]));
        }
        let others = BESIDE.iter().fold(self.block.groups, |groups, group| groups & !(1 << *group as u16));
        if others != 0 {
            return Err(Refused::of(&PolarBesideCode {}, &[column]));
        }
        let motion = self.block.g(Group::Motion).unwrap_or(self.state.modal.motion);
        let incremental = match self.block.g(Group::Distance) {
            Some(code) => code == G::Incremental,
            None => self.state.modal.incremental,
        };
        if incremental && matches!(motion, G::Cycle(_)) && self.block.get(letter::L).is_some_and(|holes| holes != 1.0) {
            return Err(Refused::of(&PolarRepeated {}, &[column]));
        }
        let unit = self.state.modal.unit;
        let at = [Axis::X, Axis::Y].map(|axis| unit.from_mm(self.state.at.get(axis)));
        let [here, turned] = [trig::hypot(at[0], at[1]), trig::atan2(at[1], at[0])];
        if (incremental || angle.is_none()) && at == [0.0; 2] {
            return Err(Refused::of(&PolarAtOrigin {}, &[column]));
        }
        let [radius, angle] = [radius, angle].map(|word| word.map(|(value, _)| value));
        let (radius, angle) = if incremental {
            (here + radius.unwrap_or(0.0), turned + angle.unwrap_or(0.0).to_radians())
        } else {
            (radius.unwrap_or(here), angle.map_or(turned, f64::to_radians))
        };
        let (sin, cos) = trig::sin_cos(angle);
        for (word, (to, at)) in [letter::X, letter::Y].into_iter().zip([radius * cos, radius * sin].into_iter().zip(at))
        {
            // Neither stands there: looked at above.
            let _ = self.block.put(word, if incremental { to - at } else { to }, column);
        }
        Ok(())
    }
}
