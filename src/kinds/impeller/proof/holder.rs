//! How far shank and holder of a clear cut stay from the turned blank, where the form gives them.
//!
//! A lower bound of the distance over the blocks of the passes, as they were read back; the channels are alike, for the blank is a
//! body of revolution. A holder that hits the blank has stopped the plan. Here it is told how far the others stay away, and that one
//! that comes nearer than stick-outs are measured may hit it.
//!
//! # Units
//! Millimetres.

use crate::finding::{Limit, Raise, Size};
use crate::gcode::program::Program;
use crate::kinds::impeller::clear::asked::ClearCells;
use crate::kinds::impeller::clear::cut::Which;
use crate::kinds::impeller::clear::fields;
use crate::kinds::impeller::clear::holder::Blank;
use crate::kinds::impeller::clear::remarks::enough;
use crate::kinds::impeller::clear::tables::tool_name;
use crate::kinds::impeller::clearance::Stand;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::proof::rules::HolderNearBlank;
use crate::kinds::impeller::solids::Stock;
use crate::limits::HOLDER_CLEARANCE;
use crate::proof::check::{Check, Question, mm, up};
use crate::text::{Text, t};

/// The row of the tool's holder; `None` where the form does not give it. `stick_out` is enough for any holder.
pub(super) fn check<'w>(
    (design, asked, which): (&Design, &ClearCells, Which),
    stick_out: f64,
    ways: impl ExactSizeIterator<Item = &'w [Stand]>,
    program: &Program,
) -> Option<Check> {
    let stage = asked.cut.stage(which)?;
    let stock = Stock { torus: design.torus, length: design.blank.L_b };
    let blank = Blank { stock, L: design.machine.L };
    let seen = ways.len();
    let found = blank.clearance(stage, ways);
    let least = mm(HOLDER_CLEARANCE);
    let key = match which {
        Which::Finish if asked.given.0.is_some() => fields::STICK_OUT_F.key(),
        Which::Rough | Which::Finish => fields::STICK_OUT.key(),
    };
    let name = t("Portaherramientas: distancia al bruto torneado", "Holder: distance from the turned blank");
    let asked = Question::new("holder", name, program)
        .showing(Text::same(format!("≥ {}", mm(-up(-found)))), Text::same(format!("≥ {least}")))
        .of_parameters([key, fields::HOLDER.key()])
        .seen(seen)
        .measuring(found)
        .against(Limit::AtLeast(HOLDER_CLEARANCE));
    Some(asked.holds(found >= HOLDER_CLEARANCE, |place| {
        let near = Size::length((found * 1000.0).floor() / 1000.0, 3);
        HolderNearBlank { tool: tool_name(which), near, enough: enough(stick_out) }.at(place)
    }))
}
