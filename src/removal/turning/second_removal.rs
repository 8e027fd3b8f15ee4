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

/// The removal as the library repeats it, in a thread of its own: it takes the cuts in their order, and what it leaves is
/// awaited, so that how fast either is makes no difference.
#[derive(Debug)]
pub struct Repeat {
    cuts: SyncSender<Convex>,
    left: JoinHandle<Tiles>,
    /// What has fallen off, mm³.
    fallen: f64,
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
        let (cuts, waiting) = sync_channel::<Convex>(WAITING_CUTS);
        let left = spawn(move || {
            let mut tiles = Tiles::default();
            tiles.divide(start);
            waiting.iter().for_each(|polygon| tiles.cut(&polygon));
            tiles
        });
        Self { cuts, left, fallen: 0.0 }
    }

    /// Takes a polygon away.
    pub fn cut(&self, polygon: &Convex) {
        // It fails where the thread has ended before its time, and then `apart` tells.
        let _ = self.cuts.send(polygon.clone());
    }

    /// Notes that pieces of a volume, mm³, have fallen off: the library keeps them.
    pub fn fell(&mut self, volume: f64) {
        self.fallen += volume;
    }

    /// How far what the library leaves is from the contours that are left, mm: the area of what is in one of them alone, by the
    /// length of the contours. Of what it leaves in pieces, the one that reaches farthest to the left counts, as pieces that are
    /// held no longer fall off. Pieces that touch it in a corner may have stayed as well: what hangs in a point may be said to be held or not.
    /// Where nothing is left, all that the library keeps must have fallen off.
    #[must_use]
    pub fn apart(self, left: &[Ring]) -> f64 {
        drop(self.cuts);
        let tiles = self.left.join().unwrap_or_else(|fault| resume_unwind(fault));
        let mut all = Overlay::new(0);
        for tile in &tiles.tiles {
            all.add_source(&tile.contours, ShapeType::Subject);
        }
        let mut pieces: Vec<Vec<Vec<Corner>>> = all.overlay(OverlayRule::Subject, FillRule::NonZero);
        let begins = |piece: &Vec<Vec<Corner>>| piece.iter().flatten().map(|corner| corner.x).min();
        pieces.sort_by_key(begins);
        let mut pieces = pieces.into_iter();
        let mut held = pieces.next().unwrap_or_default();
        let mut others: Vec<_> = pieces.collect();
        if left.is_empty() {
            let kept: f64 = others.iter().chain([&held]).flatten().map(|ring| volume(&millimetres(ring))).sum();
            if kept <= self.fallen * (1.0 + AGREE) + AGREE {
                return 0.0;
            }
        }
        let alone = differing(&held, left);
        while let Some(at) = others.iter().position(|other| touch(&held, other)) {
            held.append(&mut others.swap_remove(at));
        }
        let edges = left.iter().flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)));
        let length: f64 = edges.map(|(from, to)| hypot(to[0] - from[0], to[1] - from[1])).sum();
        alone.min(differing(&held, left)) / length.max(1.0)
    }
}

/// True where two pieces have a corner in common.
fn touch(one: &[Vec<Corner>], other: &[Vec<Corner>]) -> bool {
    let corners: FxHashSet<(i64, i64)> = one.iter().flatten().map(|at| (at.x, at.y)).collect();
    other.iter().flatten().any(|at| corners.contains(&(at.x, at.y)))
}

/// The area of what is in contours of the library or in those that are left alone, mm².
fn differing(library: &[Vec<Corner>], left: &[Ring]) -> f64 {
    let mut both = Overlay::from_subj(library);
    both.add_source(&contours(left), ShapeType::Clip);
    let apart = both.overlay(OverlayRule::Xor, FillRule::NonZero);
    apart.iter().flatten().map(|ring| twice_area(&millimetres(ring))).sum::<f64>() / 2.0
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
    // Kept so as not to allocate for each cut.
    overlay: Overlay<i64>,
    out: FlatContoursBuffer<i64>,
}

impl Default for Tiles {
    fn default() -> Self {
        Self { tiles: Vec::new(), overlay: Overlay::new(0), out: FlatContoursBuffer::default() }
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
        let (mut at, mut met) = (0, Vec::new());
        while let Some(tile) = self.tiles.get(at) {
            if meets(tile) {
                met.push(self.tiles.swap_remove(at));
            } else {
                at += 1;
            }
        }
        met.sort_by_key(|tile| tile.low);
        let mut met = met.into_iter().map(|tile| tile.contours).peekable();
        while let Some(mut few) = met.next() {
            // What has become small is put together again.
            while let Some(next) = met.next_if(|next| few.points.len() + next.points.len() <= TILE_CORNERS) {
                next.ranges.into_iter().for_each(|range| few.add_contour(&next.points[range]));
            }
            let left = self.between(few, &corners, OverlayRule::Difference);
            self.divide(left);
        }
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
            let grid = |at: Corner, out| Point { z: at.x.div_euclid(FINE) + out, r: at.y.div_euclid(FINE) + out };
            self.tiles.push(Tile { contours, low: grid(low, 0), high: grid(high, 1) });
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
