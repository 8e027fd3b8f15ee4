//! What a piece is that a cut has separated from the held part: a part, a core, or a nib that counts as chips.

use super::outline::Part;
use super::path::Piece;
use super::tool::Cutter;
use crate::geometry::exact::region::Ring;
use crate::number::trig::hypot;

/// A piece that nothing holds any more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loose {
    /// A small remnant in front of the cutter's own edge, such as the nib in the middle of a face: it counts as chips.
    Nib,
    /// The core inside a groove cut along Z, or a ring or cone that is too large for a chip: it falls out, and the part stays in the chuck.
    Core,
    /// A piece parted off.
    Piece,
}

/// The largest section of what counts as chips, mm².
const NIB: f64 = 5.0;

/// What a piece is that comes off while a tool moves in a straight line; lengths are on the grid, mm.
///
/// # Derivation
/// A cutter clears the strip that it covers across its path, or would if its edge were square to the path. A nose, or a
/// leaning main edge, reaches the axis or the edge of a bore with its point first; the metal still in front of the rest of the
/// edge comes off as a nib or a ring, which is inside the strip. A piece that is parted off is beside the strip: a piece
/// of a bar or a tube for a blade along X, the ring round the bore for a bar that bores into a groove. The middle of the piece's
/// section decides. A blade that cuts into a face parts off the ring round its groove; the metal inside is a core.
///
/// Facing leaves in front of an edge no more than its nose and its lean make over the depth of cut: with a nose of 1.6 mm and an
/// edge that leans 15°, over 3 mm, a section of less than 5 mm². A larger ring or cone is no chip, however it came off: it falls out like
/// a core.
#[must_use]
pub fn judged(cutter: &Cutter, parts: &[Part], [from, to]: Piece, ring: &Ring) -> Loose {
    let long = hypot(to[0] - from[0], to[1] - from[1]);
    let Some(([z, r], section)) = middle(ring).filter(|_| long > 0.0) else { return Loose::Piece };
    let way = [(to[0] - from[0]) / long, (to[1] - from[1]) / long];
    // To the left of the path.
    let aside = |[z, r]: [f64; 2]| way[0] * r - way[1] * z;
    let at = aside([z - from[0], r - from[1]]);
    let corners = parts.iter().flat_map(|part| part.polygon.corners()).map(|corner| aside(corner.mm()));
    let [low, high] = corners.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)]);
    match cutter {
        _ if (low..=high).contains(&at) && section <= NIB => Loose::Nib,
        _ if (low..=high).contains(&at) => Loose::Core,
        Cutter::Groover { face: true, .. } if r < from[1].abs() => Loose::Core,
        _ => Loose::Piece,
    }
}

/// The centroid of a contour's area, `[z, r]`: the mean, weighted by area, of the centroids of the triangles between its first
/// corner and its edges; and the area, mm². `None` if that is 0.
fn middle(ring: &Ring) -> Option<([f64; 2], f64)> {
    let &[z0, r0] = ring.first()?;
    let (mut twice, mut sum) = (0.0, [0.0; 2]);
    for pair in ring.windows(2) {
        let [[z1, r1], [z2, r2]] = [pair[0], pair[1]].map(|[z, r]| [z - z0, r - r0]);
        let area = z1 * r2 - z2 * r1;
        twice += area;
        sum = [sum[0] + area * (z1 + z2), sum[1] + area * (r1 + r2)];
    }
    (twice != 0.0).then(|| ([z0 + sum[0] / (3.0 * twice), r0 + sum[1] / (3.0 * twice)], twice.abs() / 2.0))
}
