//! Axis travel: no position of a program may lie beyond the machine's limits.

use crate::finding::{Finding, Place};
use crate::gcode::axis::Axis;
use crate::gcode::program::Program;
use crate::machine::travel::{Travel, excess};
use crate::number::shown;
use crate::text::Text;

/// Holds a program against the travel of its axes (program coordinates, mm and degrees): one stop for each axis that
/// leaves its travel, with the greatest excess and the first block that leaves it.
#[must_use]
pub fn travel(program: &Program, limits: &[(char, Travel)]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for &(letter, limit) in limits {
        let Some(axis) = Axis::ALL.into_iter().find(|axis| axis.letter() == letter) else { continue };
        let mut first = None;
        let mut worst: Option<crate::machine::travel::Excess> = None;
        let mut judge = |position: f64, line: usize| {
            if let Some(found) = excess(limit, position) {
                first.get_or_insert(line);
                let size = |one: &crate::machine::travel::Excess| (one.position - one.limit).abs();
                if worst.as_ref().is_none_or(|worst| size(worst) < size(&found)) {
                    worst = Some(found);
                }
            }
        };
        judge(program.start.get(axis).value(), 1);
        program.for_each_move(&mut |each| judge(each.to.get(axis).value(), each.line));
        if let (Some(line), Some(worst)) = (first, worst) {
            let unit = if axis.rotary() { "°" } else { "mm" };
            let (value, limit) = (shown(worst.position, 3), shown(worst.limit, 3));
            findings.push(
                Finding::stop(
                    Place::Block { program: program.key, line },
                    Text::new(
                        format!(
                            "el eje {letter} llega a {value} {unit} en «{}»; su límite es {limit} {unit}",
                            program.title.es
                        ),
                        format!(
                            "axis {letter} goes to {value} {unit} in \"{}\"; its limit is {limit} {unit}",
                            program.title.en
                        ),
                    ),
                    Text::new(
                        format!("compruebe los límites de {letter}, la longitud de pivote y el cero"),
                        format!("check the limits of {letter}, the pivot length and the zero"),
                    ),
                )
                .with(format!("{value} {unit}"), format!("{limit} {unit}")),
            );
        }
    }
    findings
}
