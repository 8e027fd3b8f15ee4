//! Polar coordinates: `@` is the distance from the origin of the program's XY plane, `^` the angle in degrees.
//!
//! # References
//! LinuxCNC, "Polar Coordinates": G17 alone, not beside X or Y, not with G53; under G91 `@` and `^` are added to the distance and
//! the angle of where the tool stands, which must not be the origin.

use crate::gcode::code::{G, Group};
use crate::gcode::interpreter::Interpreter;
use crate::gcode::interpreter::block::letter;
use crate::gcode::interpreter::cursor::Cursor;
use crate::gcode::interpreter::fault::{Fault, Outcome};
use crate::gcode::motion::Plane;
use crate::machine::axis::Axis;
use crate::number::grid::LIMIT;
use crate::number::trig;
use crate::text::Text;

/// The polar words of a block: distance and angle, each with its column.
pub(super) type Polar = [Option<(f64, usize)>; 2];

/// Groups beside which polar words stand: motion, distance mode, what F means and how cycles return.
const BESIDE: [Group; 5] = [Group::Motion, Group::Distance, Group::Feed, Group::Retract, Group::Path];

fn refused(column: usize, es: &'static str, en: &'static str) -> Box<Fault> {
    Fault::at(
        &[column],
        Text::fixed(es, en),
        Text::fixed("escriba X e Y, o el bloque aparte", "write X and Y, or a block of its own"),
    )
}

impl Interpreter<'_> {
    /// Reads `@` or `^`, on which the cursor stands.
    pub(super) fn read_polar(&mut self, cursor: &mut Cursor<'_>) -> Outcome<()> {
        let (column, angle) = (cursor.column(), cursor.peek() == b'^');
        cursor.pass();
        let value = self.value(cursor)?.value;
        if value.abs() > f64::from(LIMIT) / 1000.0 {
            return Err(refused(column, "cota polar de más de 99 999.999", "polar coordinate of more than 99,999.999"));
        }
        match self.block.polar[usize::from(angle)].replace((value, column)) {
            None => Ok(()),
            Some(_) => {
                Err(refused(column, "dos cotas polares iguales en un bloque", "the same polar word twice in one block"))
            }
        }
    }

    /// Puts the X and the Y in place of the polar words of the block.
    pub(super) fn settle_polar(&mut self) -> Outcome<()> {
        let [radius, angle] = self.block.polar;
        let Some((_, column)) = radius.or(angle) else { return Ok(()) };
        if self.block.has(letter::X) || self.block.has(letter::Y) {
            return Err(refused(column, "cotas polares junto a X o Y", "polar words beside X or Y"));
        }
        if self.modal.plane != Plane::XY {
            return Err(refused(column, "cotas polares fuera de G17", "polar words outside G17"));
        }
        let others = BESIDE.iter().fold(self.block.groups, |groups, group| groups & !(1 << *group as u16));
        if others != 0 {
            return Err(refused(column, "cotas polares junto a otro código G", "polar words beside another G code"));
        }
        let motion = self.block.g(Group::Motion).unwrap_or(self.modal.motion);
        let incremental = match self.block.g(Group::Distance) {
            Some(code) => code == G::Incremental,
            None => self.modal.incremental,
        };
        if incremental && matches!(motion, G::Cycle(_)) && self.block.get(letter::L).is_some_and(|holes| holes != 1.0) {
            return Err(refused(
                column,
                "cotas polares repetidas con L en G91 no están implementadas",
                "polar words repeated by L under G91 are not supported",
            ));
        }
        let unit = self.modal.unit;
        let at = [Axis::X, Axis::Y].map(|axis| unit.from_mm(self.current.get(axis)));
        let [here, turned] = [trig::hypot(at[0], at[1]), trig::atan2(at[1], at[0])];
        if (incremental || angle.is_none()) && at == [0.0; 2] {
            return Err(refused(
                column,
                "cota polar sin ángulo conocido: la herramienta está en el origen",
                "polar word without a known angle: the tool stands at the origin",
            ));
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
