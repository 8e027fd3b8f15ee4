//! How fine the steps must be for the tip to keep to its path.
//!
//! The deviation falls with 1/n², so that n·√(deviation/tolerance) is nearly right at once; since positions are rounded
//! to the grid it is then computed, and n moved until the deviation at n is within the tolerance and that at n − 1 is
//! not. Below what the grid leaves no n helps.

use crate::kinds::impeller::blade::Blade;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::ideal::Ideal;
use crate::kinds::impeller::programs::Tracks;
use crate::kinds::impeller::proof::tip_path::{Along, limits};
use crate::kinds::impeller::splitter::Splitter;
use crate::kinds::impeller::tables::ToolPaths;
use crate::kinds::impeller::track::Track;
use crate::limits::{TRIED_BLOCKS, TRIED_STEPS};
use crate::machine::axis::Pose;
use crate::number::grid::Milli;

/// What the deviation of the tip along any track of a design cut in n steps, from the positions on the grid, is nowhere greater
/// than; mm. Where the tracks of the blade alone exceed `enough` those of the splitter, whose fade takes far longer to find, are
/// left out.
///
/// `None` where a position does not fit into a program.
#[must_use]
pub fn greatest(design: &Design, n: usize, enough: f64) -> Option<f64> {
    let design = Design { n, ..design.clone() };
    let blade = Blade::new(design.torus, n, design.eps_v, design.machine);
    let of_blade = greatest_of(&design, &blade, None)?;
    if of_blade > enough || !design.splitters {
        return Some(of_blade);
    }
    let Ok(splitter) = Splitter::new(&design, &blade) else { return Some(of_blade) };
    greatest_of(&design, &blade, Some(&splitter)).map(|of_splitter| of_blade.max(of_splitter))
}

/// The same of the tracks of a splitter, or of those of a blade.
fn greatest_of(design: &Design, blade: &Blade, splitter: Option<&Splitter>) -> Option<f64> {
    let tracks = Tracks::new(blade, &ToolPaths::new(design, blade), splitter).ok()?;
    let mut most = 0.0_f64;
    for track in Track::ALL.into_iter().filter(|track| track.of_splitter() == splitter.is_some()) {
        let Some(ideal) = Ideal::new(design, splitter, track) else { continue };
        let mut along = Along::new(ideal, design.n, limits(design));
        let positions = tracks.positions(track).unwrap_or_default();
        for (i, pair) in positions.windows(2).enumerate() {
            let ends = [pair[0], pair[1]].map(Pose::from);
            along.block(design.machine, [&ends[0], &ends[1]], [i, i + 1], Milli::ZERO, (0, None));
        }
        most = most.max(along.at_most()[0]);
    }
    Some(most)
}

/// The least n about which the deviation falls to a tolerance, when it is `deviation` at the design's own n; mm.
///
/// `None` where no n within reach brings it there.
#[must_use]
pub fn needed(design: &Design, deviation: f64, tolerance: f64) -> Option<usize> {
    let mut left = TRIED_BLOCKS;
    let mut at = |n: usize| {
        left = left.checked_sub(n)?;
        greatest(design, n, tolerance)
    };
    let next = |n: usize, deviation: f64| {
        #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
        let next = (n as f64 * (deviation / tolerance).sqrt()).ceil();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "held within a small range")]
        let next = next.clamp(2.0, TRIED_STEPS as f64 + 1.0) as usize;
        next
    };
    let mut n = next(design.n, deviation);
    if n > TRIED_STEPS {
        return None;
    }
    let mut found = at(n)?;
    // One more step of the same rule, so that a start far away is forgotten.
    if found > tolerance || n > 2 * design.n {
        n = next(n, found).min(TRIED_STEPS);
        found = at(n)?;
    }
    while found > tolerance {
        n += 1;
        if n > TRIED_STEPS {
            return None;
        }
        found = at(n)?;
    }
    while n > 2 && at(n - 1)? <= tolerance {
        n -= 1;
    }
    Some(n)
}
