//! The removal of material made a second time, with a library of polygons, so that no part is handed over on the word of one
//! kernel.
//!
//! `i_overlay` takes the same polygons away one by one, on a grid of 64-bit integers. It goes over the whole of the contour that
//! it is given at each cut, so it is given the part in tiles with few corners each: what a polygon leaves of the part is what it
//! leaves of the tiles, and only those that the polygon meets are worked on.

use std::panic::resume_unwind;
use std::sync::mpsc::{SyncSender, sync_channel};
use std::thread::{JoinHandle, spawn};

use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay::{Overlay, ShapeType};
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::i_float::int::point::IntPoint;
use i_overlay::i_shape::flat::buffer::FlatContoursBuffer;
use rustc_hash::FxHashSet;

use crate::geometry::exact::convex::Convex;
use crate::geometry::exact::grid::{Point, UNITS};
use crate::geometry::exact::region::{Ring, twice_area};
use crate::geometry::revolution::volume;
use crate::limits::{TILE_CORNERS, WAITING_CUTS};
use crate::number::trig::hypot;

/// How far two contours may be from each other on the average, mm: both round corners to far less.
pub const AGREE: f64 = 1e-6;

/// Units of the library's grid in one of ours: picometres, about. Coordinates stay below 2⁴⁰, far below its limit of 2⁶².
const FINE: i64 = 1 << 10;

type Corner = IntPoint<i64>;

/// What the library is told, in its order.
#[derive(Debug)]
enum Told {
    /// A polygon is taken away.
    Cut(Convex),
    /// Pieces have fallen off, with these contours.
    Fell(Vec<Ring>),
}

/// The removal as the library repeats it, in a thread of its own: it takes the cuts in their order, and what it leaves is
/// awaited, so that how fast either is makes no difference.
#[derive(Debug)]
pub struct Repeat {
    told: SyncSender<Told>,
    left: JoinHandle<Tiles>,
}

impl Repeat {
    /// From contours, `[z, r]` in mm, counter-clockwise, holes clockwise.
    #[must_use]
    #[expect(
        clippy::disallowed_methods,
        reason = "its thread gets polygons in their order and is awaited: what comes out hangs on nothing else"
    )]
    pub fn new(start: &[Ring]) -> Self {
        let start = contours(start);
        let (told, waiting) = sync_channel::<Told>(WAITING_CUTS);
        let left = spawn(move || {
            let mut tiles = Tiles::default();
            tiles.divide(start);
            waiting.iter().for_each(|told| match told {
                Told::Cut(polygon) => tiles.cut(&polygon),
                Told::Fell(pieces) => tiles.drop_pieces(&pieces),
            });
            tiles
        });
        Self { told, left }
    }

    /// Takes a polygon away.
    pub fn cut(&self, polygon: &Convex) {
        // It fails where the thread has ended before its time, and then `apart` tells.
        let _ = self.told.send(Told::Cut(polygon.clone()));
    }

    /// Lets pieces fall off, given by their contours in mm, counter-clockwise, holes clockwise: the library drops its own pieces of which
    /// these have more than half. How far its pieces are from these, and how much farther to the left they reach than what it keeps, counts
    /// in [`Self::apart`].
    ///
    /// # Derivation
    /// What has fallen off is met by no later cut, and the piece that is held may lose its left end in one: so which piece is held can be
    /// said only as it falls off. Which pieces hang in a point alone is left to the caller.
    pub fn fell(&self, pieces: Vec<Ring>) {
        let _ = self.told.send(Told::Fell(pieces));
    }

    /// How far what the library leaves is from the contours that are left, mm: the area of what is in one of them alone, by the
    /// length of the contours; or how far what fell off was from its own pieces, where that is more. Of what it leaves in pieces, the one
    /// that reaches farthest to the left counts. Pieces that touch it in a corner may have stayed as well: what hangs in a point may be said
    /// to be held or not. Where nothing is left, the library keeps nothing, or what it keeps is told as its volume, mm³.
    #[must_use]
    pub fn apart(self, left: &[Ring]) -> f64 {
        drop(self.told);
        let tiles = self.left.join().unwrap_or_else(|fault| resume_unwind(fault));
        let mut pieces = pieces(&tiles.tiles);
        let begins = |piece: &Vec<Vec<Corner>>| piece.iter().flatten().map(|corner| (corner.x, corner.y)).min();
        pieces.sort_by_key(begins);
        let mut pieces = pieces.into_iter();
        let mut held = pieces.next().unwrap_or_default();
        let mut others: Vec<_> = pieces.collect();
        if left.is_empty() {
            let kept: f64 = others.iter().chain([&held]).flatten().map(|ring| volume(&millimetres(ring))).sum();
            if kept <= AGREE {
                return tiles.apart;
            }
        }
        let alone = differing(&held, left);
        while let Some(at) = others.iter().position(|other| touch(&held, other)) {
            held.append(&mut others.swap_remove(at));
        }
        tiles.apart.max(alone.min(differing(&held, left)) / length(left).max(1.0))
    }
}

/// The length of contours, mm.
fn length(rings: &[Ring]) -> f64 {
    let edges = rings.iter().flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)));
    edges.map(|(from, to)| hypot(to[0] - from[0], to[1] - from[1])).sum()
}

/// What hangs together in tiles: each piece with its holes.
fn pieces<'a>(tiles: impl IntoIterator<Item = &'a Tile>) -> Vec<Vec<Vec<Corner>>> {
    let mut all = Overlay::new(0);
    for tile in tiles {
        all.add_source(&tile.contours, ShapeType::Subject);
    }
    all.overlay(OverlayRule::Subject, FillRule::NonZero)
}

/// True where two pieces have a corner in common.
fn touch(one: &[Vec<Corner>], other: &[Vec<Corner>]) -> bool {
    let corners: FxHashSet<(i64, i64)> = one.iter().flatten().map(|at| (at.x, at.y)).collect();
    other.iter().flatten().any(|at| corners.contains(&(at.x, at.y)))
}

/// The area of what is in contours of the library or in those that are left alone, mm².
fn differing(library: &[Vec<Corner>], left: &[Ring]) -> f64 {
    between(library, &contours(left), OverlayRule::Xor)
}

/// The area of what a rule says of contours of the library and others, mm².
fn between(library: &[Vec<Corner>], others: &FlatContoursBuffer<i64>, rule: OverlayRule) -> f64 {
    let mut both = Overlay::from_subj(library);
    both.add_source(others, ShapeType::Clip);
    area(both.overlay(rule, FillRule::NonZero).iter().flatten())
}

/// The area of contours, holes clockwise, mm².
fn area<'a>(rings: impl IntoIterator<Item = &'a Vec<Corner>>) -> f64 {
    rings.into_iter().map(|ring| twice_area(&millimetres(ring))).sum::<f64>() / 2.0
}

/// A share of the part, with its extent on our grid, rounded outwards.
struct Tile {
    contours: FlatContoursBuffer<i64>,
    low: Point,
    high: Point,
}

/// The part in tiles that do not overlap, as the library has left it.
struct Tiles {
    tiles: Vec<Tile>,
    /// How far what fell off was from the library's own pieces, at most; mm.
    apart: f64,
    // Kept so as not to allocate for each cut.
    overlay: Overlay<i64>,
    out: FlatContoursBuffer<i64>,
}

impl Default for Tiles {
    fn default() -> Self {
        Self { tiles: Vec::new(), apart: 0.0, overlay: Overlay::new(0), out: FlatContoursBuffer::default() }
    }
}

impl Tiles {
    /// Takes a polygon away from the tiles that it meets.
    fn cut(&mut self, polygon: &Convex) {
        let corners = polygon.corners().iter();
        let corners: Vec<Corner> = corners.map(|corner| Corner::new(corner.z * FINE, corner.r * FINE)).collect();
        let lines = polygon.lines();
        let (low, high) = polygon.extent();
        let meets = |tile: &Tile| {
            let beside = tile.high.z <= low.z || high.z <= tile.low.z || tile.high.r <= low.r || high.r <= tile.low.r;
            !beside && !lines.iter().any(|line| line.has_right(tile.low, tile.high))
        };
        let mut met = self.take(meets).into_iter().map(|tile| tile.contours).peekable();
        while let Some(mut few) = met.next() {
            // What has become small is put together again.
            while let Some(next) = met.next_if(|next| few.points.len() + next.points.len() <= TILE_CORNERS) {
                next.ranges.into_iter().for_each(|range| few.add_contour(&next.points[range]));
            }
            let left = self.between(few, &corners, OverlayRule::Difference);
            self.divide(left);
        }
    }

    /// Takes out the tiles that something holds for, in their order along z.
    fn take(&mut self, wanted: impl Fn(&Tile) -> bool) -> Vec<Tile> {
        let (mut at, mut taken) = (0, Vec::new());
        while let Some(tile) = self.tiles.get(at) {
            if wanted(tile) {
                taken.push(self.tiles.swap_remove(at));
            } else {
                at += 1;
            }
        }
        taken.sort_by_key(|tile| tile.low);
        taken
    }

    /// Drops the pieces of which these contours, mm, have more than half, and notes how far those are from these.
    fn drop_pieces(&mut self, fallen: &[Ring]) {
        let others = contours(fallen);
        let Some((low, high)) = extent(&others.points).map(|(low, high)| on_grid(low, high)) else { return };
        // What hangs together with them lies in a tile that meets theirs, or touches it.
        let near =
            |tile: &Tile| tile.low.z <= high.z && low.z <= tile.high.z && tile.low.r <= high.r && low.r <= tile.high.r;
        let near = self.take(near);
        let mut dropped = Vec::new();
        for piece in pieces(&near) {
            if between(&piece, &others, OverlayRule::Intersect) > area(&piece) / 2.0 {
                dropped.extend(piece);
            } else {
                let mut kept = FlatContoursBuffer::default();
                piece.iter().for_each(|ring| kept.add_contour(ring));
                self.divide(kept);
            }
        }
        let off = between(&dropped, &others, OverlayRule::Xor) / length(fallen).max(1.0);
        // What is kept is what reaches farthest to the left: as far, or within what rounds away.
        let kept = self.tiles.iter().map(|tile| tile.low.z).min().unwrap_or(i64::MIN);
        #[expect(clippy::cast_precision_loss, reason = "below 2^53")]
        let beyond = kept.saturating_sub(low.z + 1).max(0) as f64 / UNITS;
        self.apart = self.apart.max(off).max(beyond);
    }

    /// Adds the tiles of contours: divided across the longer side, with as many corners on either, and again until each
    /// has few.
    fn divide(&mut self, contours: FlatContoursBuffer<i64>) {
        let Some((low, high)) = extent(&contours.points) else { return };
        let long = high.x - low.x > high.y - low.y;
        let along = |at: &Corner| if long { at.x } else { at.y };
        let mut places: Vec<i64> = contours.points.iter().map(along).collect();
        places.sort_unstable();
        let (first, half, last) = (along(&low), places[places.len() / 2], along(&high));
        let half = if first < half && half < last { half } else { i64::midpoint(first, last) };
        if contours.points.len() <= TILE_CORNERS || last - first < FINE {
            let (low, high) = on_grid(low, high);
            self.tiles.push(Tile { contours, low, high });
            return;
        }
        let (one, two) = if long {
            (Corner::new(half, high.y), Corner::new(half, low.y))
        } else {
            (Corner::new(high.x, half), Corner::new(low.x, half))
        };
        for (low, high) in [(low, one), (two, high)] {
            let rectangle = [low, Corner::new(high.x, low.y), high, Corner::new(low.x, high.y)];
            let half = self.between(contours.clone(), &rectangle, OverlayRule::Intersect);
            self.divide(half);
        }
    }

    /// What a rule says of contours and a polygon.
    fn between(
        &mut self,
        contours: FlatContoursBuffer<i64>,
        polygon: &[Corner],
        rule: OverlayRule,
    ) -> FlatContoursBuffer<i64> {
        self.overlay.clear();
        self.overlay.add_source(&contours, ShapeType::Subject);
        self.overlay.add_contour(polygon, ShapeType::Clip);
        self.overlay.overlay_into(rule, FillRule::NonZero, &mut self.out);
        // Its memory is used for what comes next.
        std::mem::replace(&mut self.out, contours)
    }
}

fn extent(corners: &[Corner]) -> Option<(Corner, Corner)> {
    let first = *corners.first()?;
    Some(corners.iter().fold((first, first), |(low, high), at| {
        (Corner::new(low.x.min(at.x), low.y.min(at.y)), Corner::new(high.x.max(at.x), high.y.max(at.y)))
    }))
}

/// An extent on our grid, rounded outwards.
const fn on_grid(low: Corner, high: Corner) -> (Point, Point) {
    let low = Point { z: low.x.div_euclid(FINE), r: low.y.div_euclid(FINE) };
    (low, Point { z: high.x.div_euclid(FINE) + 1, r: high.y.div_euclid(FINE) + 1 })
}

/// Contours in the library's units; corners on the grid come out exactly.
fn contours(rings: &[Ring]) -> FlatContoursBuffer<i64> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_precision_loss, reason = "below 2^41")]
    let units = |mm: f64| (mm * UNITS * FINE as f64).round() as i64;
    let mut all = FlatContoursBuffer::default();
    for ring in rings {
        let corners: Vec<Corner> = ring.iter().map(|[z, r]| Corner::new(units(*z), units(*r))).collect();
        all.add_contour(&corners);
    }
    all
}

#[expect(clippy::cast_precision_loss, reason = "below 2^53")]
fn millimetres(ring: &[Corner]) -> Ring {
    ring.iter().map(|at| [at.x as f64, at.y as f64].map(|units| units / (UNITS * FINE as f64))).collect()
}
