//! How many divisions a flat cut needs to keep to its tolerance.

use nalgebra::Vector2;

use crate::gcode::program::Style;
use crate::geometry::pipe_pair::Side;
use crate::kinds::pipe::insert::cut::{Follows, cut};
use crate::kinds::pipe::insert::design::Design;
use crate::kinds::pipe::insert::outline::Outline;
use crate::kinds::pipe::insert::parameters::MOST_N;
use crate::kinds::pipe::insert::proof::{Curve, Moves, PathOnCurve, SurfacePath, limits};
use crate::number::root::golden;
use crate::number::trig::{asin, atan2};
use crate::proof::check::At;
use crate::proof::step::Interpolation;

/// The places of an arc that are looked at first: one through three points of a curve is farthest from it between them.
const SAMPLES: [f64; 6] = [0.12, 0.21, 0.32, 0.68, 0.79, 0.88];
/// As many steps more than the design has are tried.
const MORE: u32 = 1000;

/// The next greater N of a flat cut whose arcs keep to the tolerance. Where N's points fall counts, so that not every greater one does:
/// each is planned, looked at and, where no look stands against it, judged as its program would be.
pub(super) fn enough(design: &Design) -> Option<u32> {
    (design.N + 1..=design.N.saturating_add(MORE).min(MOST_N)).find(|&N| keeps(&Design { N, ..design.clone() }))
}

/// True where the moves of a design keep to its tolerance.
fn keeps(design: &Design) -> bool {
    let cut = match design.style {
        Style::Full => match cut(design) {
            Ok(cut) => Some(cut),
            Err(_) => return false,
        },
        Style::Annex => None,
    };
    let moves = Moves::new(design, cut.as_ref());
    let mut from = Vector2::from(moves.pierce);
    let ways: Vec<(SurfacePath, Follows)> = moves
        .moves
        .iter()
        .map(|one| {
            let to = Vector2::from(one.to);
            let way = way(from, to, one.interpolation);
            from = to;
            (way, one.follows)
        })
        .collect();
    let (outline, [tolerance, _]) = (design.outline(), limits(design));
    let near = |(way, follows): &(SurfacePath, Follows)| match follows {
        Follows::Curve(leg) => SAMPLES.iter().all(|part| looked_at(&outline, way, *leg, *part) <= tolerance),
        _ => true,
    };
    if !ways.iter().all(near) {
        return false;
    }
    let mut curve = Curve::new();
    let mut path = PathOnCurve::new(design, &moves, &mut curve);
    ways.iter().for_each(|(way, follows)| path.follow(way, *follows, At::line(0)));
    path.keeps()
}

/// How far a place of a way is from the torch's path between two angles.
fn looked_at(outline: &Outline, way: &SurfacePath, [from, to]: [f64; 2], part: f64) -> f64 {
    let (point, around, wide) = (way.at(part), from + (to - from) * part, (to - from) / 2.0);
    let side = if part < 0.5 { Side::After } else { Side::Before };
    let span = [around - wide, around + wide].map(|phi| phi.clamp(from.min(to), from.max(to)));
    golden(span, 25, |phi| (outline.torch(phi, side) - point).norm_squared()).0.sqrt()
}

/// The way of a move: straight, or an arc of less than half a circle.
fn way(from: Vector2<f64>, to: Vector2<f64>, interpolation: Interpolation) -> SurfacePath {
    let Interpolation::Arc { clockwise, radius } = interpolation else { return SurfacePath::Straight([from, to]) };
    let (chord, sign) = (to - from, if clockwise { -1.0 } else { 1.0 });
    let half = chord.norm() / 2.0;
    let aside = Vector2::new(-chord.y, chord.x) / (2.0 * half) * sign;
    let centre = from + chord / 2.0 + aside * (radius * radius - half * half).max(0.0).sqrt();
    let start = from - centre;
    let sweep = 2.0 * asin((half / radius).min(1.0)) * sign;
    SurfacePath::Arc { centre, angle: atan2(start.y, start.x), sweep, radii: [radius; 2] }
}
