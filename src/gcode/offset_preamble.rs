//! The blocks that give a control the work offsets of a var file, in LinuxCNC's words.
//!
//! # References
//! The LinuxCNC manual, chapter "Coordinate systems": `G10 L2 P…` sets a system's origin and rotation from machine
//! coordinates, whatever is active; `G52` sets the registers of G92 axis by axis; `G92.1` clears them, `G92.2` takes
//! them out of force and keeps them.

use crate::machine::axis::Axis;
use crate::machine::length_unit::LengthUnit;
use crate::machine::offset_edit::greatest;
use crate::machine::var_file::VarFile;
use crate::machine::work_offset::{G92_FIRST, Offsets, System};

/// The axes that a table of offsets shows: X, Y, Z, and every other one that is not 0 somewhere among the parameters
/// whose first one, that of X, is given.
#[must_use]
pub fn axes(file: &VarFile, firsts: &[u32]) -> Vec<Axis> {
    let used = |axis: &Axis| firsts.iter().any(|first| value(file, *first, *axis) != 0.0);
    Axis::ALL.into_iter().filter(|axis| matches!(axis, Axis::X | Axis::Y | Axis::Z) || used(axis)).collect()
}

/// The value of an axis among the nine parameters that begin with `first`, as it stands in the file.
#[must_use]
pub fn value(file: &VarFile, first: u32, axis: Axis) -> f64 {
    file.get(first + axis as u32).unwrap_or(0.0)
}

/// A number with at least three decimals and at most the six that a var file has, never −0.
#[must_use]
pub fn decimals(value: f64) -> String {
    let text = format!("{value:.6}");
    let kept = text.trim_end_matches('0').len().max(text.len() - 3);
    let text = text.get(..kept).unwrap_or(&text);
    if text == "-0.000" { "0.000".to_owned() } else { text.to_owned() }
}

/// The blocks, one a line: unit and distance mode, every system, the one that is active, and G92 as in the file.
///
/// X, Y, Z and R stand in every block, so that nothing of what the control held is left in them; the other axes where
/// one system uses them, since a machine may not have them.
///
/// # Errors
/// Parameters whose values no program may carry: beyond ±99 999.999 mm or degrees.
pub fn preamble(file: &VarFile, unit: LengthUnit) -> Result<Vec<String>, Vec<u32>> {
    let (offsets, _) = Offsets::read(file, unit);
    let firsts: Vec<u32> = System::ALL.into_iter().map(System::first_parameter).collect();
    let mut beyond = Vec::new();
    let mut words = |first: u32, axes: &[Axis]| {
        let mut words = String::new();
        for axis in axes {
            let size = value(file, first, *axis);
            if size.abs() > greatest(*axis, unit) {
                beyond.push(first + *axis as u32);
            }
            words.push_str(&format!(" {}{}", axis.letter(), decimals(size)));
        }
        words
    };
    let mut blocks = vec![match unit {
        LengthUnit::Inch => "G20 G90".to_owned(),
        LengthUnit::Millimetre => "G21 G90".to_owned(),
    }];
    // Whatever was in force before is cleared, so that no axis keeps a register that the file does not have.
    blocks.push("G92.1".to_owned());
    let shown = axes(file, &firsts);
    for (system, first) in System::ALL.into_iter().zip(firsts) {
        let origin = words(first, &shown);
        let rotation = file.get(system.rotation_parameter()).unwrap_or(0.0);
        blocks.push(format!("G10 L2 P{}{origin} R{}", system.number(), decimals(rotation)));
    }
    let g92 = offsets.g92.0.iter().any(|offset| *offset != 0.0);
    let registers = g92.then(|| format!("G52{}", words(G92_FIRST, &axes(file, &[G92_FIRST]))));
    for system in System::ALL {
        if file.get(system.rotation_parameter()).unwrap_or(0.0).abs() > greatest(Axis::C, unit) {
            beyond.push(system.rotation_parameter());
        }
    }
    blocks.push(offsets.active.name().to_owned());
    // Last: while G92 is in force, G10 must not rotate the active system.
    if let Some(registers) = registers {
        blocks.push(registers);
        if !offsets.g92_on {
            blocks.push("G92.2".to_owned());
        }
    }
    if beyond.is_empty() { Ok(blocks) } else { Err(beyond) }
}
