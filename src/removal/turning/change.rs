//! A tool change: whether the turret has room to turn.

use super::alarm::{Cause, TOUCH};
use super::contact::depth;
use super::motion_totals::Tally;
use super::outline::Outline;
use super::stock::Fixture;
use super::tool::TurningTool;
use super::workpiece::Workpiece;
use crate::geometry::exact::convex::Convex;
use crate::geometry::exact::grid::Point;

/// The distance from the stock that a turret needs to turn, mm: Z′ and X′ of the source, the clearance of the tools at the
/// reference point.
const ROOM: f64 = 30.0;

/// Raises the alarm of a change to a place, with the turret's reference point at `stands`, `[z, r]` on the grid: if the point of
/// the working tool is over the stock, between its ends and within [`ROOM`] of its surface or inside it; and if any tool of
/// the turret would be in the part or in the bodies about it, because each may pass the working place as the turret turns. The
/// sources do not say what a turret sweeps: every tool is tried at the working place only.
pub(super) fn judge<'a>(
    (part, fixtures): (&mut Workpiece, &[(Fixture, Convex)]),
    tools: impl Iterator<Item = (u32, &'a TurningTool, &'a Outline)>,
    [old, new]: [u32; 2],
    stands: [f64; 2],
    tally: &mut Tally,
) {
    let mut swept = Convex::default();
    let extent = part.extent();
    for (place, tool, outline) in tools {
        let at = [stands[0] - tool.overhang[1], stands[1] - tool.overhang[0]];
        if let Some((low, high)) = extent
            && place == old
            && (low[0]..high[0] - TOUCH).contains(&at[0])
            && at[1].abs() < high[1] + ROOM
        {
            tally.raise(Cause::ToolChange(new), at, None);
        }
        let Some(point) = Point::near(at) else { continue };
        let bodies = outline.cutter.iter().map(|part| &part.polygon).chain(&outline.holder);
        for body in bodies {
            if !body.sweep(point, point, &mut swept) {
                continue;
            }
            part.probe(&swept, |meeting, _| {
                let (deep, place) = depth(meeting);
                if deep > TOUCH {
                    tally.raise(Cause::ToolChange(new), place, Some(deep));
                }
            });
            for (_, fixture) in fixtures {
                if let Some((deep, place)) = swept.overlap(fixture)
                    && deep > TOUCH
                {
                    tally.raise(Cause::ToolChange(new), place, Some(deep));
                }
            }
        }
    }
}
