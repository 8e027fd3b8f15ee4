//! The ISO programs of the impeller: one blade (annex 9), one splitter (annex 10), the whole impeller.
//!
//! Positions are rounded to 0.001 first and subtracted after, so that increments do not drift and every program closes.

use std::sync::Arc;

use crate::gcode::header::Origin;
use crate::gcode::program::Program;
use crate::gcode::word::NumberFormat;
use crate::kinds::impeller::assembly::{Assembly, BladePass, Limited};
use crate::kinds::impeller::blade::Blade;
use crate::kinds::impeller::clear::cut::Which;
use crate::kinds::impeller::design::{Design, Style};
use crate::kinds::impeller::discretisation;
use crate::kinds::impeller::fade::Fade;
use crate::kinds::impeller::header::{blank_header, header};
use crate::kinds::impeller::operation::Operation;
use crate::kinds::impeller::splitter::Splitter;
use crate::kinds::impeller::tables::ToolPaths;
use crate::kinds::impeller::track::Track;
use crate::machine::axis::{Axis, Position};
use crate::number::grid::{Milli, OutOfFormat, TURN};
use crate::text::t;

/// Passes and safe points of a blade and of its splitter on the output grid, C of the first blade.
#[derive(Clone, Debug)]
pub struct Tracks {
    obverse: Arc<[Position]>,
    reverse: Arc<[Position]>,
    splitter: Option<[Arc<[Position]>; 2]>,
    /// Where the ways out and back along a splitter have their full offset, if each has a point of its own.
    full_from: Option<[usize; 2]>,
    entry_obverse: Position,
    entry_reverse: Position,
    exit_obverse: Position,
    exit_reverse: Position,
}

impl Tracks {
    /// The positions of a blade and its splitter.
    ///
    /// # Errors
    /// For a position that no program may carry.
    pub fn new(blade: &Blade, passes: &ToolPaths, splitter: Option<&Splitter>) -> Result<Self, OutOfFormat> {
        let last = blade.points() - 1;
        // The last point may be backed off, and lies nowhere else near the middle of two thousandths.
        let B = |i: usize| match discretisation::B_on_grid(last, i) {
            Some(B) if i < last => Ok(B),
            _ => Milli::round(blade.B[i].to_degrees()),
        };
        let position = |i: usize, point: &nalgebra::Vector3<f64>| -> Result<Position, OutOfFormat> {
            Ok(Position::default()
                .with(Axis::X, Milli::round(point.x)?)
                .with(Axis::Y, Milli::round(point.y)?)
                .with(Axis::Z, Milli::round(point.z)?)
                .with(Axis::B, B(i)?)
                .with(Axis::C, Milli::round(blade.C[i].to_degrees())?))
        };
        let track = |points: &[nalgebra::Vector3<f64>]| -> Result<Arc<[Position]>, OutOfFormat> {
            points.iter().enumerate().map(|(i, point)| position(i, point)).collect()
        };
        // From side to side only Y changes. Half-way between two thousandths the arithmetic would round X of one side up and of the other
        // down.
        let across = |from: Position, to: &nalgebra::Vector3<f64>| Milli::round(to.y).map(|Y| from.with(Axis::Y, Y));
        let (entry_obverse, exit_obverse) =
            (position(0, &passes.entry.obverse)?, position(last, &passes.exit.obverse)?);
        Ok(Self {
            obverse: track(&passes.obverse)?,
            reverse: track(&passes.reverse)?,
            splitter: splitter
                .map(|splitter| Ok([track(&splitter.out.path)?, track(&splitter.back.path)?]))
                .transpose()?,
            full_from: splitter
                .filter(|splitter| splitter.fade == Fade::EachSide)
                .map(|splitter| [splitter.out.m, splitter.back.m]),
            entry_obverse,
            entry_reverse: across(entry_obverse, &passes.entry.reverse)?,
            exit_obverse,
            exit_reverse: across(exit_obverse, &passes.exit.reverse)?,
        })
    }
}

impl Tracks {
    /// The positions of a track; `None` for a splitter's where there is none.
    #[must_use]
    pub fn positions(&self, track: Track) -> Option<&[Position]> {
        match track {
            Track::Obverse => Some(&self.obverse),
            Track::Reverse => Some(&self.reverse),
            Track::Out => self.splitter.as_ref().map(|[out, _]| &**out),
            Track::Back => self.splitter.as_ref().map(|[_, back]| &**back),
        }
    }
}

impl Tracks {
    /// The safe points before the first point of a track and after its last, seen from the hub.
    #[must_use]
    pub const fn safe_points(&self, track: Track) -> [Position; 2] {
        match track {
            Track::Obverse => [self.entry_obverse, self.exit_obverse],
            Track::Reverse | Track::Out => [self.entry_reverse, self.exit_reverse],
            // It is run back from the obverse's exit to the reverse's entry.
            Track::Back => [self.entry_reverse, self.exit_obverse],
        }
    }
}

/// The passes of one blade and of one splitter, ready to be put anywhere about the axis.
struct Cuts {
    obverse: BladePass,
    reverse: BladePass,
    splitter: Option<[BladePass; 2]>,
}

impl Cuts {
    fn new(design: &Design, tracks: &Tracks) -> Result<Self, OutOfFormat> {
        let pass = |track: Track, from: Position, points: &Arc<[Position]>, to: Position| {
            BladePass::new(design, track, from, points, to)
        };
        Ok(Self {
            obverse: pass(Track::Obverse, tracks.entry_obverse, &tracks.obverse, tracks.exit_obverse)?,
            reverse: pass(Track::Reverse, tracks.exit_reverse, &tracks.reverse, tracks.entry_reverse)?,
            splitter: tracks
                .splitter
                .as_ref()
                .map(|[out, back]| {
                    Ok([
                        pass(Track::Out, tracks.entry_reverse, out, tracks.exit_reverse)?,
                        pass(Track::Back, tracks.exit_obverse, back, tracks.entry_reverse)?,
                    ])
                })
                .transpose()?,
        })
    }

    /// Obverse, cross, reverse backwards, cross back: starts and ends at the obverse's safe entry.
    fn blade(&self, tracks: &Tracks, assembly: &mut Assembly<'_>, turn: Milli) {
        assembly.cut(&self.obverse, turn);
        assembly.cross(tracks.exit_reverse.moved(Axis::C, turn), &[Axis::Y]);
        assembly.cut(&self.reverse, turn);
        assembly.cross(tracks.entry_obverse.moved(Axis::C, turn), &[Axis::Y]);
    }

    /// Path 1, cross, path 2 backwards: starts and ends at the reverse's safe entry.
    fn splitter(&self, tracks: &Tracks, assembly: &mut Assembly<'_>, turn: Milli) {
        if let Some([out, back]) = &self.splitter {
            assembly.cut(out, turn);
            assembly.cross(tracks.exit_obverse.moved(Axis::C, turn), &[Axis::Y]);
            assembly.cut(back, turn);
        }
    }
}

/// The angle of the `k`th of `count` equal parts of a turn, rounded; the parts sum up to exactly one turn.
///
/// # Errors
/// For more turns than a program may carry.
pub fn part_of_turn(k: u32, count: u32) -> Result<Milli, OutOfFormat> {
    Milli::round(360.0 * f64::from(k) / f64::from(count))
}

/// The programs of a design, in the order of their sheets.
#[derive(Debug)]
pub struct Programs {
    /// `blade`, `splitter` where wanted, `impeller`, `blank`.
    pub programs: Vec<Program>,
    /// Moves whose feed was limited, of all channels or blades.
    pub limited: Limited,
}

/// Makes the programs of a design.
///
/// # Errors
/// For a position or feed that no program may carry.
pub fn programs(design: &Design, tracks: &Tracks, origin: &Origin<'_>) -> Result<Programs, OutOfFormat> {
    let cuts = Cuts::new(design, tracks)?;
    let blade = {
        let mut assembly = Assembly::new(design, tracks.entry_obverse)?;
        cuts.blade(tracks, &mut assembly, Milli::ZERO);
        assembly.turn_on(part_of_turn(1, design.N)?);
        assembly.finish(Operation::Blade, t("Un álabe", "One blade"))
    };
    let mut milled = vec![blade];
    if cuts.splitter.is_some() {
        // Splitters stand half way between blades; the published program is taken there by hand.
        let half = part_of_turn(1, 2 * design.N)?;
        let mut assembly = Assembly::new(design, tracks.entry_reverse.moved(Axis::C, half))?;
        cuts.splitter(tracks, &mut assembly, half);
        assembly.turn_on(part_of_turn(1, design.N)?);
        milled.push(assembly.finish(Operation::Splitter, t("Un álabe intermedio", "One splitter blade")));
    }
    milled.push(impeller(design, tracks, &cuts)?);

    for program in &mut milled {
        if design.style == Style::Full {
            let full_from = tracks.full_from.filter(|_| program.key != Operation::Blade.key());
            let mut parts = header(design, program, Which::Rough, full_from, origin);
            parts.append(&mut program.parts);
            program.parts = parts;
        }
    }
    let mut limited = Limited::default();
    for pass in [&cuts.obverse, &cuts.reverse].into_iter().chain(cuts.splitter.iter().flatten()) {
        limited.by_axis += pass.limited.by_axis;
        limited.by_format += pass.limited.by_format;
    }
    milled.push(blank(design, origin)?);
    Ok(Programs { programs: milled, limited: limited.times(design.N) })
}

/// N blades, then N splitters, with the C turns between; closes in every axis, in C to whole turns.
fn impeller(design: &Design, tracks: &Tracks, cuts: &Cuts) -> Result<Program, OutOfFormat> {
    let N = design.N;
    let turn = Milli::new(TURN);
    let mut assembly = Assembly::new(design, tracks.entry_obverse)?;
    for k in 0..N {
        cuts.blade(tracks, &mut assembly, part_of_turn(k, N)?);
        assembly.turn_to(tracks.entry_obverse, part_of_turn(k + 1, N)?);
    }
    if cuts.splitter.is_some() {
        assembly.cross(tracks.entry_reverse.moved(Axis::C, turn), &[Axis::Y]);
        for k in 0..N {
            let at = turn + part_of_turn(2 * k + 1, 2 * N)?;
            assembly.turn_to(tracks.entry_reverse, at);
            cuts.splitter(tracks, &mut assembly, at);
        }
        assembly.turn_to(tracks.entry_reverse, turn + turn);
        assembly.cross(tracks.entry_obverse.moved(Axis::C, turn + turn), &[Axis::Y]);
    }
    Ok(assembly.finish(Operation::Whole, t("El rodete completo", "The whole impeller")))
}

/// The program that turns the blank.
///
/// # Errors
/// For a position that no program may carry.
pub fn blank(design: &Design, origin: &Origin<'_>) -> Result<Program, OutOfFormat> {
    let format = if design.style == Style::Full { NumberFormat::Fixed } else { NumberFormat::Trimmed };
    let mut program = design.blank.program(design.torus, format, design.block_step)?;
    if design.style == Style::Full {
        let mut parts = blank_header(design, &program, origin);
        parts.append(&mut program.parts);
        program.parts = parts;
    }
    Ok(program)
}
