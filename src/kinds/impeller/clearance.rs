//! How near a tool that moves comes to the faces of blades: a lower and an upper bound, never a sample.
//!
//! The tool is a cylinder with a flat end that reaches on for ever. Of a face only what lies above the plane of its end
//! counts; the clearance is the distance of that from the tool's axis, less the radius: exact in its sign, and where it is
//! negative the radial overlap. Motions are straight in X, Y, Z, B and C, as a control makes them without following the
//! tip.
//!
//! # The bound
//! Distance D to a closed set is semiconcave: along a path of speed ≤ V and acceleration ≤ W its second derivative is at
//! most V²/D + W. So over an interval it is nowhere below the straight line between its end values by more than
//! (V²/D + W)·s(1 − s)/2, D being any lower bound. This is used over time, for a point of the face seen from the tool, and
//! over v, for the rulings: a cell is a piece of time and a piece of a face, and four distances of a ruling from the axis,
//! each in closed form, bound it. The rulings are clipped to what is above the end and in the blank, by limits of h that
//! are straight between the corners of the cell and that the same lemma moves outwards until nothing that counts is beyond.
//!
//! The cell with the least bound is halved first, in time or in v; cells above the least distance that was seen are
//! dropped. Long runs of short blocks are first taken as one straight motion and the most that they leave it by. When the
//! work is done before the bounds have met, the lower one still holds.
//!
//! # References
//! Semiconcavity of the distance: P. Cannarsa and C. Sinestrari, "Semiconcave Functions, Hamilton–Jacobi Equations, and
//! Optimal Control", 2004, proposition 2.2.2. Its use is derived above, under "The bound".
//!
//! # Units
//! Millimetres and radians.

use std::collections::BinaryHeap;
use std::sync::{Mutex, PoisonError};

use nalgebra::{Vector2, Vector3};
use rustc_hash::FxHashMap;

use crate::kinds::impeller::corners::{Clip, Corners, STEEP, from_tip, least_between};
use crate::kinds::impeller::limit::Limit;
use crate::kinds::impeller::part::{Face, HUB, Part, Piece, RIM, Ruling};
use crate::limits::PASS_CELLS;
use crate::machine::axis::{Axis, Pose};
use crate::machine::rotary::{TiltingTable, Turned};
use crate::number::queue::Waiting;
use crate::number::trig::hypot;
use crate::number::{greater, lesser};

/// How close the bounds are brought to each other, mm.
pub const CLOSE: f64 = 2e-5;
/// Cells that are evaluated at most for a pass; a usual one takes some hundreds.
pub const WORK: usize = PASS_CELLS;
/// Below this part of the radius the distance from the axis is known well enough to this part of it.
const DEEP: f64 = 0.2;
const COARSE: f64 = 0.01;
/// What the arithmetic may lose, mm.
const ARITHMETIC: f64 = 1e-9;
/// How far limits of h may run beyond the rulings, in parts of their length.
const BEYOND: f64 = 0.25;

/// Where all axes stand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stand {
    /// X, Y and Z.
    pub at: Vector3<f64>,
    /// B, radians; 0 where the part stands upright.
    pub B: f64,
    /// C, radians.
    pub C: f64,
}

impl From<&Pose> for Stand {
    fn from(pose: &Pose) -> Self {
        let at = Vector3::new(pose.get(Axis::X), pose.get(Axis::Y), pose.get(Axis::Z));
        Self { at, B: pose.get(Axis::B).to_radians(), C: pose.get(Axis::C).to_radians() }
    }
}

impl Stand {
    /// The position at a part of the way to another.
    #[must_use]
    pub fn towards(&self, to: &Self, part: f64) -> Self {
        let linear = |from: f64, to: f64| from + (to - from) * part;
        Self { at: self.at + (to.at - self.at) * part, B: linear(self.B, to.B), C: linear(self.C, to.C) }
    }
}

/// Where a tool is nearest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The position along the way: the block, and the part of it.
    pub along: f64,
    /// v of the ruling on the face, radians.
    pub v: f64,
}

/// What is known of a clearance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// It is nowhere less; infinite where no face is ever above the tool's end.
    pub lower: f64,
    /// Somewhere it is no more.
    pub upper: f64,
    /// Where the tool comes as near as `upper`; `None` where no face is ever above the tool's end.
    pub place: Option<Place>,
    /// How many cells were evaluated.
    pub work: usize,
}

/// When a search may end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Until {
    /// The bounds are closer than this.
    Within(f64),
    /// It is known whether the clearance is at least this.
    Decided(f64),
}

/// The faces that a tool must keep clear of.
#[derive(Debug)]
pub struct Walls {
    part: Part,
    machine: TiltingTable,
    radius: f64,
    pieces: Vec<Piece>,
    turns: Vec<f64>,
    /// What searches have found out about pieces of them; the next search goes on from there.
    spans: Mutex<Spans>,
}

/// What is known of pieces of the faces.
#[derive(Debug, Default)]
struct Spans {
    /// Where each is, by the piece and its v.
    at: FxHashMap<(usize, [u64; 2]), usize>,
    all: Vec<Span>,
}

/// Which motion: blocks of the way and, of a single one, the part of it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Time {
    first: usize,
    last: usize,
    part: [f64; 2],
}

/// A piece of time and a piece of a face of one blade.
#[derive(Clone, Copy, Debug)]
struct Cell {
    time: Time,
    /// The tool at both ends of the time: where it is in the search.
    ends: [usize; 2],
    turn: usize,
    piece: usize,
    v: [f64; 2],
    /// What is known of the face between both v: where it is among the spans.
    span: usize,
}

/// A position of the tool, with the axes turned to it: most cells take it from the one that they are a half of.
#[derive(Clone, Copy, Debug)]
struct End {
    stand: Stand,
    turned: Turned,
}

/// The least distance of the points from − h·along, h between two limits, from the origin of a plane; and the h.
fn from_axis(from: Vector2<f64>, along: Vector2<f64>, limits: [f64; 2]) -> (f64, f64) {
    let square = along.norm_squared();
    let free = if square > 0.0 { from.dot(&along) / square } else { limits[0] };
    let (low, high) = (lesser(limits[0], limits[1]), greater(limits[0], limits[1]));
    let h = lesser(greater(low, free), high);
    ((from - along * h).norm(), h)
}

/// The rulings between two v of a piece.
#[derive(Clone, Copy, Debug)]
struct Span {
    rulings: [Ruling; 2],
    tops: [f64; 2],
    /// From and to which h they may count.
    top: f64,
    bottom: f64,
    /// As far as limits of h may run.
    beyond: [f64; 2],
    /// What the points move by between the two v, how far that is from straight, and what the rulings turn by.
    moves: [f64; 3],
    /// No point of it is farther from the part's axis.
    rho: f64,
    floors: Limit,
    /// Above which h nothing lies in the blank.
    trim: Option<Limit>,
    /// All of it lies outside the blank.
    outside: bool,
}

/// The work on one way.
struct Search<'a> {
    walls: &'a Walls,
    way: &'a [Stand],
    /// By how much runs of blocks leave the straight motion.
    runs: FxHashMap<(usize, usize), f64>,
    ends: Vec<End>,
    spans: Spans,
    /// The least distance from the axis that was seen, and where.
    seen: (f64, Option<Place>),
    work: usize,
}

impl Walls {
    /// The faces of blades that stand turned by some angles about the axis of the part, each from some v on.
    #[must_use]
    pub fn new(part: Part, machine: TiltingTable, radius: f64, turns: Vec<f64>, from: f64) -> Self {
        let pieces = Face::ALL.into_iter().flat_map(|face| part.pieces(face)).filter_map(|piece| {
            let v = [piece.v[0].max(from), piece.v[1]];
            (v[0] < v[1]).then_some(Piece { v, ..piece })
        });
        Self { part, machine, radius, pieces: pieces.collect(), turns, spans: Mutex::default() }
    }

    /// One face of each of them alone: of blades without thickness both are the same.
    #[must_use]
    pub fn one_face(mut self) -> Self {
        self.pieces.retain(|piece| piece.face == Face::Obverse);
        self
    }

    /// The clearance of the tool along a way.
    #[must_use]
    pub fn clearance(&self, way: &[Stand], until: Until, budget: usize) -> Bounds {
        let mut search = Search {
            walls: self,
            way,
            runs: FxHashMap::default(),
            ends: Vec::new(),
            // Another search at the same time begins with none: what it finds is the same.
            spans: std::mem::take(&mut *self.spans.lock().unwrap_or_else(PoisonError::into_inner)),
            seen: (f64::INFINITY, None),
            work: 0,
        };
        let lower = search.run(until, budget);
        *self.spans.lock().unwrap_or_else(PoisonError::into_inner) = std::mem::take(&mut search.spans);
        let (upper, place) = search.seen;
        let lower = lower.min(upper) - self.radius - ARITHMETIC;
        Bounds { lower, upper: upper - self.radius, place, work: search.work }
    }
}

impl Search<'_> {
    /// Halves the worst cell until the end; the least bound that is left.
    fn run(&mut self, until: Until, budget: usize) -> f64 {
        let Some(last) = self.way.len().checked_sub(1) else { return f64::INFINITY };
        let (mut heap, mut cells) = (BinaryHeap::new(), Vec::new());
        let radius = self.walls.radius;
        let enough = |seen: f64| match until {
            // Of a face that reaches nearly to the axis only that is worth knowing.
            Until::Within(tolerance) if seen < radius * DEEP => seen - tolerance.max(radius * COARSE),
            Until::Within(tolerance) => seen - tolerance,
            Until::Decided(asked) => asked + radius + ARITHMETIC,
        };
        let whole = Time { first: 0, last, part: [0.0, 1.0] };
        // A way of one place is a block of no length.
        let whole = if last == 0 { Time { last: 0, ..whole } } else { whole };
        for turn in 0..self.walls.turns.len() {
            let ends = [self.end(&whole, 0, turn), self.end(&whole, 1, turn)];
            for (piece, of) in self.walls.pieces.iter().enumerate() {
                let cell = Cell { time: whole, ends, turn, piece, v: of.v, span: self.span(piece, of.v) };
                if let Some((bound, in_time)) = self.evaluate(&cell) {
                    heap.push(Waiting { bound, order: cells.len(), what: in_time });
                    cells.push(cell);
                }
            }
        }
        while let Some(Waiting { bound, order: cell, what: in_time }) = heap.pop() {
            let lost = matches!(until, Until::Decided(asked) if self.seen.0 - radius < asked);
            if bound >= enough(self.seen.0) || lost || self.work >= budget {
                return bound;
            }
            for cell in self.halves(&cells[cell], in_time) {
                if let Some((bound, in_time)) = self.evaluate(&cell)
                    && bound < self.seen.0
                {
                    heap.push(Waiting { bound, order: cells.len(), what: in_time });
                    cells.push(cell);
                }
            }
        }
        f64::INFINITY
    }

    /// Notes where the tool is at one end of a span of time, beside the walls of one turn; returns the number of the note.
    fn end(&mut self, time: &Time, side: usize, turn: usize) -> usize {
        let Time { first, last, part } = *time;
        let (from, to) = (&self.way[first], &self.way[last]);
        let stand = if last == first + 1 { from.towards(to, part[side]) } else { [*from, *to][side] };
        self.ends.push(End { stand, turned: Turned::to(stand.B, stand.C - self.walls.turns[turn]) });
        self.ends.len() - 1
    }

    /// The two halves of a cell, by time or, where it is one moment or `in_time` is false, by v.
    fn halves(&mut self, cell: &Cell, in_time: bool) -> [Cell; 2] {
        let Cell { time: Time { first, last, part }, ends, turn, piece, v, .. } = *cell;
        if !in_time || first == last {
            let middle = (v[0] + v[1]) / 2.0;
            let mut half = |v: [f64; 2]| Cell { v, span: self.span(piece, v), ..*cell };
            return [half([v[0], middle]), half([middle, v[1]])];
        }
        let [before, after] = if last > first + 1 {
            let middle = first + (last - first) / 2;
            [Time { first, last: middle, part }, Time { first: middle, last, part }]
        } else {
            let middle = (part[0] + part[1]) / 2.0;
            [Time { first, last, part: [part[0], middle] }, Time { first, last, part: [middle, part[1]] }]
        };
        let middle = self.end(&before, 1, turn);
        [
            Cell { time: before, ends: [ends[0], middle], ..*cell },
            Cell { time: after, ends: [middle, ends[1]], ..*cell },
        ]
    }

    /// The most by which a run of blocks moves a point of the part otherwise than straight from its beginning to its end.
    fn strays(&mut self, first: usize, last: usize) -> f64 {
        if last <= first + 1 {
            return 0.0;
        }
        if let Some(known) = self.runs.get(&(first, last)) {
            return *known;
        }
        let R = self.walls.part.circle.torus.R;
        let L = self.walls.machine.L.abs();
        let reach = hypot(R, L.max(2.0 * R));
        #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
        let strays = (first + 1..last)
            .map(|at| {
                let part = (at - first) as f64 / (last - first) as f64;
                let (straight, here) = (self.way[first].towards(&self.way[last], part), &self.way[at]);
                (here.at - straight.at).norm() + (here.B - straight.B).abs() * reach + (here.C - straight.C).abs() * R
            })
            .fold(0.0, f64::max);
        self.runs.insert((first, last), strays);
        strays
    }

    /// What is known of the rulings between two v of a piece, whatever the tool does.
    fn span(&mut self, piece: usize, v: [f64; 2]) -> usize {
        let (walls, Spans { at, all }) = (self.walls, &mut self.spans);
        let new = || {
            let of = &walls.pieces[piece];
            let rulings = v.map(|v| walls.part.ruling(of.face, v));
            let tops = v.map(|v| walls.part.top(v));
            // h_0 does not grow with v.
            let (top, bottom) = (tops[1], of.bottom);
            // Limits of h may run a little beyond the rulings; what follows holds for that too.
            let beyond = [top - (bottom - top) * BEYOND, bottom + (bottom - top) * BEYOND];
            let change = walls.part.change(v, beyond[1].max(-beyond[0]));
            let floors = Limit::through([walls.part.floors(of, v, &rulings, &change); 2]);
            let span = v[1] - v[0];
            let moves = [change.speed * span, change.acceleration * span * span, change.turn * span];
            let mut square = 0.0_f64;
            for point in rulings.iter().flat_map(|ruling| beyond.map(|h| ruling.at(h))) {
                square = square.max(point.x * point.x + point.y * point.y);
            }
            let rho = square.sqrt() + moves[0] / 2.0;
            let cut = Trim::of(walls, of, &rulings, (top + bottom) / 2.0);
            let outside = cut.as_ref().is_some_and(|cut| cut.greatest([top, bottom]) + moves[1] / 8.0 < 0.0);
            let trim = cut.and_then(|cut| cut.limit(moves[1], moves[2]));
            all.push(Span { rulings, tops, top, bottom, beyond, moves, rho, floors, trim, outside });
            all.len() - 1
        };
        *at.entry((piece, [v[0].to_bits(), v[1].to_bits()])).or_insert_with(new)
    }

    /// The lower bound of a cell, and whether to halve it in time; `None` where nothing of it counts.
    ///
    /// Of a point of the part, seen from the tip, y' = ΔB·J(y + Q) + ΔC·U − Δp and
    /// y'' = ΔB²·J²(y + Q) + 2ΔBΔC·JU + ΔC²·U₂, Q being the tip seen from the pivot, J the quarter turn about the B axis,
    /// |U| = |U₂| the distance ρ from the part's axis.
    ///
    /// This is where most of the time of a check goes. What is needed four times is written four times: `map` of an array is
    /// a call for each of its elements.
    fn evaluate(&mut self, cell: &Cell) -> Option<(f64, bool)> {
        self.work += 1;
        let Cell { time: Time { first, last, part }, piece, v, .. } = *cell;
        let walls = self.walls;
        let strays = self.strays(first, last);
        let tools = [&self.ends[cell.ends[0]], &self.ends[cell.ends[1]]];
        let ends = [tools[0].stand, tools[1].stand];
        let by = ends[1].at - ends[0].at;
        let (B, C) = ((ends[1].B - ends[0].B).abs(), (ends[1].C - ends[0].C).abs());
        if B >= 1.0 {
            return Some((0.0, true));
        }
        let known = &self.spans.all[cell.span];
        if known.outside {
            return None;
        }
        let Span { rulings, tops, top, beyond, rho, .. } = *known;
        let [v_speed, v_bend, v_turn] = known.moves;

        let pivot = Vector3::new(0.0, 0.0, walls.machine.L);
        let Q = [ends[0].at + pivot, ends[1].at + pivot];
        let from_pivot = |ruling: &Ruling| Ruling { foot: ruling.foot + pivot, N: ruling.N };
        let from_pivot = [from_pivot(&rulings[0]), from_pivot(&rulings[1])];
        let seen = from_tip([&tools[0].turned, &tools[1].turned], &Q, &from_pivot);
        let corners = Corners::new(&seen, beyond, [top, known.bottom]);
        let step = ends[1].B - ends[0].B;
        let slide = |Q: &Vector3<f64>| (Vector3::new(-Q.z, 0.0, Q.x) * step - by).norm();
        let slide = greater(slide(&Q[0]), slide(&Q[1]));
        let far = (corners.far + v_speed / 2.0 + (slide + C * rho) / 2.0) / (1.0 - B / 2.0);
        let speed = slide + C * rho + B * far;
        let bend = |axis: usize| B * B * (greater(Q[0][axis].abs(), Q[1][axis].abs()) + far) + (2.0 * B + C) * C * rho;
        let (bend, rise_bend) = (bend(0), bend(2));

        // Nothing of it above the plane of the tool's end.
        if corners.highest + (rise_bend + v_bend) / 8.0 + strays < 0.0 {
            return None;
        }

        let (mut low, mut high) = (Limit::level(top), known.floors);
        let end = corners.end(v_turn + B + C, |[in_time, in_v]| {
            (rise_bend + 2.0 * (B + C) * in_time + v_bend + 2.0 * v_turn * in_v) / 8.0 + strays
        });
        match end {
            Some(Clip::Above(limit)) if limit.sum() < high.sum() && limit.within(beyond) => high = limit,
            Some(Clip::Below(limit)) if limit.sum() > low.sum() && limit.within(beyond) => low = limit,
            _ => {}
        }
        if let Some(limit) = known.trim
            && limit.sum() > low.sum()
            && limit.within(beyond)
        {
            low = limit;
        }
        // Both limits are straight between the corners: where they have crossed at all of them, they have in between.
        let crossed = |time: usize, v: usize| low.h[time][v] > high.h[time][v];
        if crossed(0, 0) && crossed(0, 1) && crossed(1, 0) && crossed(1, 1) {
            return None;
        }
        let apart = |time: usize, v: usize| {
            let Ruling { foot, N } = &seen[time][v];
            from_axis(foot.xy(), N.xy(), [low.h[time][v], high.h[time][v]]).0
        };
        let d = [[apart(0, 0), apart(0, 1)], [apart(1, 0), apart(1, 1)]];
        for time in 0..2 {
            for at in 0..2 {
                if d[time][at] < self.seen.0 {
                    let along = if last == first + 1 { part[time] } else { [0.0, 1.0][time] };
                    self.look(
                        &walls.pieces[piece],
                        &rulings[at],
                        &seen[time][at],
                        tops[at],
                        Place { along: along_way(first, last, along), v: v[at] },
                    );
                }
            }
        }

        let change = |side: usize| greater(low.changes[side], high.changes[side]);
        let (in_time, in_v) = (change(0), change(1));
        let (speed, v_speed) = (speed + in_time, v_speed + in_v);
        let (bend, v_bend) = (bend + 2.0 * (B + C) * in_time, v_bend + 2.0 * v_turn * in_v);
        let (bound, k) = least_between(&d, [speed, v_speed], [bend, v_bend]);
        let in_time =
            if k[1] > 0.0 { k[0] + rise_bend + 16.0 * strays > k[1] + v_bend } else { speed + 2.0 * strays > v_speed };
        Some(((bound - strays).max(0.0), in_time))
    }

    /// Takes a ruling's distance from the axis, of what truly counts of it.
    fn look(&mut self, piece: &Piece, ruling: &Ruling, seen: &Ruling, top: f64, place: Place) {
        let (mut low, mut high) = (top, self.walls.part.floor(ruling, top));
        if seen.N.z > 0.0 {
            high = high.min(seen.foot.z / seen.N.z);
        } else if seen.N.z < 0.0 {
            low = low.max(seen.foot.z / seen.N.z);
        } else if seen.foot.z < 0.0 {
            return;
        }
        let R = self.walls.part.circle.torus.R;
        if inner(piece) {
            let inside = |h: f64| self.walls.part.trimmed(&ruling.at(h));
            if !inside(low) {
                // Where the ruling comes into the blank: through the hub plane, or through the rim.
                let (plan, N) = (ruling.foot.xy(), ruling.N.xy());
                let (square, along) = (N.norm_squared(), plan.dot(&N));
                let rest = (along * along - square * (plan.norm_squared() - R * R)).max(0.0).sqrt();
                let entry =
                    if piece.face == Face::Reverse { ruling.foot.z / ruling.N.z } else { (along - rest) / square };
                low = low.max(entry + ARITHMETIC);
                if !inside(low) {
                    return;
                }
            }
        }
        if low <= high {
            let (distance, _) = from_axis(seen.foot.xy(), seen.N.xy(), [low, high]);
            if distance < self.seen.0 {
                self.seen = (distance, Some(place));
            }
        }
    }
}

/// True for the piece between the ends, where the blank cuts rulings short.
fn inner(piece: &Piece) -> bool {
    piece.v[0] >= HUB && piece.v[1] <= RIM
}

#[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
fn along_way(first: usize, last: usize, part: f64) -> f64 {
    first as f64 + (last - first) as f64 * part
}

/// What the blank takes from the rulings of a cell: a + h·along must not be negative, at both of its v. Of the rim
/// cylinder this is the plane that touches it nearby, beyond which nothing of the blank lies.
struct Trim {
    a: [f64; 2],
    along: [f64; 2],
}

impl Trim {
    fn of(walls: &Walls, piece: &Piece, rulings: &[Ruling; 2], depth: f64) -> Option<Self> {
        if !inner(piece) {
            return None;
        }
        Some(match piece.face {
            Face::Reverse => Self { a: rulings.map(|ruling| -ruling.foot.z), along: rulings.map(|ruling| ruling.N.z) },
            Face::Obverse => {
                let out = (rulings[0].at(depth) + rulings[1].at(depth)).xy().try_normalize(0.0)?;
                let R = walls.part.circle.torus.R;
                Self {
                    a: rulings.map(|ruling| R - ruling.foot.xy().dot(&out)),
                    along: rulings.map(|ruling| ruling.N.xy().dot(&out)),
                }
            }
        })
    }

    fn greatest(&self, depths: [f64; 2]) -> f64 {
        let at = |side: usize| depths.map(|h| self.a[side] + h * self.along[side]);
        at(0).into_iter().chain(at(1)).fold(f64::MIN, f64::max)
    }

    /// Above which h nothing lies in the blank.
    fn limit(&self, bend: f64, turn: f64) -> Option<Limit> {
        let least = self.along[0].min(self.along[1]) - turn / 2.0;
        if least <= STEEP {
            return None;
        }
        let h = [0, 1].map(|side: usize| -self.a[side] / self.along[side]);
        let limit = Limit::through([h; 2]);
        Some(limit.moved(-(bend + 2.0 * turn * limit.changes[1]) / 8.0 / least))
    }
}
