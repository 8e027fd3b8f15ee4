//! The programs of a clear cut: one for each tool, over all channels.
//!
//! Positions are rounded to 0.001 first, for one channel; the others are the same with C turned on.

use std::sync::Arc;

use crate::gcode::header::Origin;
use crate::gcode::program::Feed;
use crate::kinds::impeller::assembly::{Assembly, Limited, feeds};
use crate::kinds::impeller::clear::cut::Which;
use crate::kinds::impeller::clear::pass::{Cutting, Pass, SLOT_FEED};
use crate::kinds::impeller::clear::plan::Plan;
use crate::kinds::impeller::clearance::Stand;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::header::header;
use crate::kinds::impeller::operation::Operation;
use crate::kinds::impeller::part::Face;
use crate::kinds::impeller::programs::{Programs, blank, part_of_turn};
use crate::machine::axis::{Axis, Position};
use crate::number::grid::{Milli, OutOfFormat};
use crate::text::{Text, t};

/// The feed that a pass into the full metal may be run at, as a part of F: what its name ends with says which these are.
pub const SLOT: (&str, f64) = ("-slot", SLOT_FEED);

impl Cutting {
    /// The name of such a pass in programs and findings.
    #[must_use]
    pub const fn key(self, slot: bool) -> &'static str {
        match (self, slot) {
            (Self::Rough { .. }, false) => "rough",
            (Self::Rough { .. }, true) => "rough-slot",
            (Self::RoughContour { .. }, _) => "rough-contour",
            (Self::Rest { .. }, false) => "rest",
            (Self::Rest { .. }, true) => "rest-slot",
            (Self::RestContour { .. }, _) => "rest-contour",
            (Self::Floor { .. }, false) => "floor",
            (Self::Floor { .. }, true) => "floor-slot",
            (Self::Leaning { .. }, _) => "floor-leaning",
            (Self::Flank { face: Face::Obverse, .. }, _) => "obverse",
            (Self::Flank { face: Face::Reverse, .. }, _) => "reverse",
            (Self::Contour, _) => "contour",
            (Self::SplitterFlanks { .. }, _) => "splitter",
        }
    }
}

impl Pass {
    /// Its name in programs and findings.
    #[must_use]
    pub fn key(&self) -> &'static str {
        self.cutting.key(self.feed < 1.0)
    }
}

/// What the program of a tool is called.
#[must_use]
pub const fn title(which: Which) -> Text {
    match which {
        Which::Rough => t("Desbaste del rodete", "Roughing of the impeller"),
        Which::Finish => t("Acabado del rodete", "Finishing of the impeller"),
    }
}

/// A stand on the output grid.
///
/// # Errors
/// For a position that no program may carry.
pub fn position(stand: &Stand) -> Result<Position, OutOfFormat> {
    Ok(Position::default()
        .with(Axis::X, Milli::round(stand.at.x)?)
        .with(Axis::Y, Milli::round(stand.at.y)?)
        .with(Axis::Z, Milli::round(stand.at.z)?)
        .with(Axis::B, Milli::round(stand.B.to_degrees())?)
        .with(Axis::C, Milli::round(stand.C.to_degrees())?))
}

/// A pass on the output grid, C of the first channel.
struct Placed {
    key: &'static str,
    approach: Vec<Position>,
    points: Arc<[Position]>,
    feed: Feed,
    /// Back along itself, at feed.
    back: Arc<[Position]>,
    back_feed: Feed,
    up: Vec<Position>,
}

impl Placed {
    fn new(design: &Design, which: Which, pass: &Pass, limited: &mut Limited) -> Result<Self, OutOfFormat> {
        let mill = design.mill(which);
        let placed = |stands: &mut dyn Iterator<Item = &Stand>| stands.map(position).collect::<Result<Vec<_>, _>>();
        let approach = placed(&mut pass.approach.iter().map(|one| &one.to))?;
        let points = placed(&mut pass.points.iter().skip(1))?;
        let back = placed(&mut pass.leave.iter().filter(|one| !one.rapid).map(|one| &one.to))?;
        let up = placed(&mut pass.leave.iter().filter(|one| one.rapid).map(|one| &one.to))?;
        let begin = approach.last().copied().unwrap_or_default();
        let end = points.last().copied().unwrap_or(begin);
        let feed = feeds(design, mill.F.map(|F| F * pass.feed), begin, &points, limited)?;
        let back_feed = feeds(design, mill.F, end, &back, limited)?;
        Ok(Self { key: pass.key(), approach, points: points.into(), feed, back: back.into(), back_feed, up })
    }

    /// Runs it, C turned on by some angle and by whole turns, so that C goes the shorter way to its begin.
    fn run(&self, assembly: &mut Assembly<'_>, turn: Milli) {
        let begin = self.approach.last().copied().unwrap_or_default();
        let turn = assembly.nearest(begin.moved(Axis::C, turn), turn);
        // The first of three goes up from where the last pass has ended.
        let up = usize::from(self.approach.len() > 2);
        for to in self.approach.iter().take(up) {
            assembly.up(to.get(Axis::Z));
        }
        for to in self.approach.iter().skip(up) {
            assembly.over(*to, turn);
        }
        assembly.through(self.key, &self.points, &self.feed, turn);
        if !self.back.is_empty() {
            assembly.through(BACK, &self.back, &self.back_feed, turn);
        }
        for to in &self.up {
            assembly.over(*to, turn);
        }
    }
}

/// The name of the way back out along a pass that ends inside the part.
pub const BACK: &str = "back";

/// Makes the programs of a design that is cut clear.
///
/// # Errors
/// For a position or feed that no program may carry.
pub fn programs(design: &Design, plan: &Plan, origin: &Origin<'_>) -> Result<Programs, OutOfFormat> {
    let (mut made, mut limited) = (Vec::new(), Limited::default());
    for which in [Which::Rough, Which::Finish] {
        let placed: Vec<Placed> =
            plan.of(which).map(|pass| Placed::new(design, which, pass, &mut limited)).collect::<Result<_, _>>()?;
        let Some(first) = placed.first().and_then(|pass| pass.approach.first()) else { continue };
        let mut assembly = Assembly::with(design, design.mill(which), *first)?;
        for channel in 0..plan.channels {
            let turn = Milli::ZERO - part_of_turn(channel, plan.channels)?;
            for pass in &placed {
                pass.run(&mut assembly, turn);
            }
        }
        let operation = match which {
            Which::Rough => Operation::Rough,
            Which::Finish => Operation::Finish,
        };
        let mut program = assembly.finish(operation, title(which));
        let mut parts = header(design, &program, which, None, origin);
        parts.append(&mut program.parts);
        program.parts = parts;
        made.push(program);
    }
    made.push(blank(design, origin)?);
    Ok(Programs { programs: made, limited: limited.times(plan.channels) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_named_otherwise_as_a_slot_is_what_the_judge_lets_run_at_the_feed_of_a_slot() {
        let [level, lane] = [0; 2];
        let flat = [
            Cutting::Rough { level, lane },
            Cutting::RoughContour { level },
            Cutting::Rest { level, lane },
            Cutting::RestContour { level },
            Cutting::Floor { lane },
            Cutting::Contour,
            Cutting::SplitterFlanks { level },
        ];
        let faces = Face::ALL.into_iter().flat_map(|face| [Cutting::Leaning { face }, Cutting::Flank { face, level }]);
        let (ending, part) = SLOT;
        assert_eq!(part, SLOT_FEED);
        let mut slots = Vec::new();
        for cutting in flat.into_iter().chain(faces) {
            let [plain, slot] = [false, true].map(|slot| cutting.key(slot));
            assert!(!plain.ends_with(ending), "{plain}");
            if slot != plain {
                assert_eq!(slot, format!("{plain}{ending}"));
                slots.push(slot);
            }
        }
        assert_eq!(slots, ["rough-slot", "rest-slot", "floor-slot"]);
    }
}
