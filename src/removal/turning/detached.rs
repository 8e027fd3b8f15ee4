//! What a piece is that a cut has left without hold: a part, a core, or a nib that goes with the chips.

use super::outline::Part;
use super::path::Piece;
use super::tool::Cutter;
use crate::geometry::exact::region::Ring;
use crate::number::trig::hypot;

/// A piece that is held no longer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loose {
    /// What a cutter leaves standing before its own edge, as the nib in the middle of a face: it is chips.
    Nib,
    /// What stood inside a groove cut along Z: it falls out, and the part stays in the chuck.
    Core,
    /// A piece parted off.
    Piece,
}

/// What a piece is that falls off while a tool goes straight from one place to another, all on the grid in mm.
///
/// # Derivation
/// A cutter clears the strip that it covers across its way, or would if its edge were square to it. A nose, or a main edge
/// that leans, reaches the axis or the edge of a bore with its point first, and what is still before the rest of the edge
/// comes off as a nib or a ring: it lies in the strip. What a cut parts off lies beside it: by a blade along X a piece of a
/// bar or a tube, by a bar that bores into a groove the ring round it. Which it is, the middle of the piece's section tells.
/// A blade that cuts into a face parts off what lies round its groove, and what it leaves inside is a core.
#[must_use]
pub fn judged(cutter: &Cutter, parts: &[Part], [from, to]: Piece, ring: &Ring) -> Loose {
    let long = hypot(to[0] - from[0], to[1] - from[1]);
    let Some([z, r]) = middle(ring).filter(|_| long > 0.0) else { return Loose::Piece };
    let way = [(to[0] - from[0]) / long, (to[1] - from[1]) / long];
    // To the left of the way.
    let aside = |[z, r]: [f64; 2]| way[0] * r - way[1] * z;
    let at = aside([z - from[0], r - from[1]]);
    let corners = parts.iter().flat_map(|part| part.polygon.corners()).map(|corner| aside(corner.mm()));
    let [low, high] = corners.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)]);
    match cutter {
        _ if (low..=high).contains(&at) => Loose::Nib,
        Cutter::Groover { face: true, .. } if r < from[1].abs() => Loose::Core,
        _ => Loose::Piece,
    }
}

/// The middle of a contour's area, `[z, r]`: the mean of the middles of the triangles between its first corner and its
/// edges, by their areas. `None` where it has none.
fn middle(ring: &Ring) -> Option<[f64; 2]> {
    let &[z0, r0] = ring.first()?;
    let (mut twice, mut sum) = (0.0, [0.0; 2]);
    for pair in ring.windows(2) {
        let [[z1, r1], [z2, r2]] = [pair[0], pair[1]].map(|[z, r]| [z - z0, r - r0]);
        let area = z1 * r2 - z2 * r1;
        twice += area;
        sum = [sum[0] + area * (z1 + z2), sum[1] + area * (r1 + r2)];
    }
    (twice != 0.0).then(|| [z0 + sum[0] / (3.0 * twice), r0 + sum[1] / (3.0 * twice)])
}
