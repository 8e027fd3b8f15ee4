//! What the passes cut of the channels, in plan: how deep, beside what is wanted.
//!
//! # Derivation
//! Cells over v and the angle about the axis, counted from the blade's mean line. From the middle of each, a line goes straight
//! into the metal; a pose of the tool cuts it where it passes the tool's cylinder, if that begins above what the poses before it
//! have left. Poses lie so close that a cusp between them is less than [`NEAR`]²/(8a) high. A picture, not a judgement.
//!
//! # Units
//! Millimetres and radians, in the part frame.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::Vector3;

use super::{line, steps};
use crate::figure::{Figure, Ink, Stroke};
use crate::geometry::torus::Torus;
use crate::kinds::impeller::Model;
use crate::kinds::impeller::bodies::{Bodies, Steps, about_axis};
use crate::kinds::impeller::clear::programs::position;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::part::{HUB, Part};
use crate::kinds::impeller::proof::clear::OVER;
use crate::kinds::impeller::sweep::Sweep;
use crate::kinds::impeller::track::Track;
use crate::machine::axis::Position;
use crate::number::trig::{asin, atan2, hypot, sin_cos};
use crate::number::{greater, lesser, shown};
use crate::text::Text;

/// Cells along the blade, and about the whole axis.
const ALONG: u16 = 96;
const ABOUT: u32 = 720;
/// Poses are no farther apart, mm.
const NEAR: f64 = 0.3;
/// Up to so many poses of a stretch.
const POSES: f64 = 400.0;
/// Less is not cut at all, mm.
const UNCUT: f64 = 0.02;
/// So far off at least, the depth is another than what is wanted, mm: with a greater tolerance of the form, farther than the proof
/// lets it pass.
const OFF: f64 = 0.05;
/// What the arithmetic of a quick look may be off by, mm and mm².
const TOUCH: f64 = 1e-6;
/// Steps along the axis of the tool, where it is seen which cells lie beside it.
const AXIS: u16 = 8;
const OUTLINES: Steps = Steps { along: 64, deep: 1, across: 8 };

/// The depths that the passes of a design cut; `None` where a tool is not flat, or a position does not fit the output grid.
pub(super) fn depths(design: &Design, model: &Model) -> Option<Figure> {
    let mut map = Map::new(design);
    let off = design.clear.as_ref().map_or(OFF, |asked| greater(OFF, asked.tolerance + OVER));
    match (&model.clear, &design.clear) {
        (Some(plan), Some(asked)) => {
            for pass in &plan.passes {
                let tool = asked.cut.tool(pass.tool);
                if tool.r_c > 0.0 {
                    return None;
                }
                let points: Vec<Position> = pass.points.iter().map(position).collect::<Result<_, _>>().ok()?;
                map.sweep(&Sweep::through((), design.machine, &points, design.a_p), tool.a(), 0.0);
            }
        }
        _ => {
            let tracks = model.tracks.as_ref().ok()?;
            for track in Track::ALL {
                let Some(sweep) = Sweep::new(design, tracks, track, design.a_p) else { continue };
                let turn = match track {
                    Track::Obverse | Track::Reverse => 0.0,
                    Track::Out | Track::Back => -PI / f64::from(design.N),
                };
                map.sweep(&sweep, design.d_t / 2.0, turn);
            }
        }
    }
    let mut strokes = map.strokes(design, off);
    let bodies = Bodies::new(design, &model.blade, model.splitter.as_ref(), model.clear.as_ref(), OUTLINES);
    for number in 0..design.N {
        let turn = TAU * f64::from(number) / f64::from(design.N);
        for body in [Some(&bodies.blade), bodies.splitter.as_ref()].into_iter().flatten() {
            let top = body.outlines[0].iter().map(|point| about_axis(point, turn)).map(|at| [at.x, at.y]);
            strokes.push(line(Ink::Outline, top.collect()));
        }
    }
    let torus = design.torus;
    for radius in [torus.R, torus.R - torus.r] {
        let round = steps(0.0, TAU, 180).map(sin_cos).map(|(sin, cos)| [radius * cos, radius * sin]);
        strokes.push(line(Ink::Outline, round.collect()));
    }
    let mm = shown(off, 3);
    Some(Figure {
        letters: Figure::LETTERS,
        key: "depths",
        height: 110.0,
        caption: Text::new(
            format!(
                "Lo que cortan las pasadas, en planta. Blanco: sin cortar; gris claro: quedan más de {mm} mm hasta el fondo; gris oscuro: el fondo pedido; rojo: más de {mm} mm por debajo. Las líneas son los álabes del diseño"
            ),
            format!(
                "What the passes cut, in plan. White: not cut; light grey: more than {mm} mm left above the floor; dark grey: the floor as wanted; red: more than {mm} mm below it. The lines are the blades of the design"
            ),
        ),
        axes: None,
        strokes,
        labels: Vec::new(),
        legend: Vec::new(),
    })
}

/// The middle of a row of cells.
struct Row {
    v: f64,
    /// Sine and cosine of v.
    turn: (f64, f64),
    /// The distance from the axis there, and the angle of the blade's mean line.
    rho: f64,
    u: f64,
}

/// How deep each cell of a channel is cut.
struct Map {
    part: Part,
    pitch: f64,
    columns: usize,
    /// Sine and cosine of the angle from one column to the next.
    step: (f64, f64),
    rows: Vec<Row>,
    /// From the hub to the rim, each row from the blade's mean line on towards lower angles.
    depths: Vec<f64>,
}

impl Map {
    fn new(design: &Design) -> Self {
        let columns = usize::try_from((ABOUT / design.N).max(24)).unwrap_or(24);
        let (part, pitch) = (Part::new(design), TAU / f64::from(design.N));
        let rows = (0..ALONG).map(|row| {
            let v = Self::v(f64::from(row) + 0.5);
            Row { v, turn: sin_cos(v), rho: part.circle.torus.rho(v), u: part.circle.u(v) }
        });
        let rows = rows.collect();
        #[expect(clippy::cast_precision_loss, reason = "a small count")]
        let step = sin_cos(pitch / columns as f64);
        Self { part, pitch, columns, step, rows, depths: vec![0.0; usize::from(ALONG) * columns] }
    }

    /// v in the middle of a row, or at its edges.
    fn v(row: f64) -> f64 {
        HUB + FRAC_PI_2 * row / f64::from(ALONG)
    }

    fn sweep<T>(&mut self, sweep: &Sweep<T>, a: f64, turn: f64) {
        for stretch in &sweep.stretches {
            let count = (stretch.pace(sweep.height).speed / NEAR).ceil().clamp(1.0, POSES);
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "held between two small counts"
            )]
            let last = count as u16;
            for k in 0..=last {
                let (tip, axis) = stretch.tool(f64::from(k) / count);
                self.cut(&about_axis(&tip, turn), &about_axis(&axis, turn), a);
            }
        }
    }

    /// Cuts with one pose: whatever channel it is in, all are alike.
    fn cut(&mut self, tip: &Vector3<f64>, axis: &Vector3<f64>, a: f64) {
        let Torus { R, r } = self.part.circle.torus;
        // No point of the metal that the tool cuts is farther from its tip.
        let deep = 1.5 * self.part.a_p;
        let reach = a + deep;
        // Such a point is within a of the axis, there where that is no nearer to K than r − a: seen from K and from the axis of
        // the part it lies no farther aside of it than the sine says.
        let (mut v, mut psi) = ([f64::INFINITY, f64::NEG_INFINITY], [f64::INFINITY, f64::NEG_INFINITY]);
        let first = atan2(tip.y, tip.x);
        for part in steps(0.0, 1.0, AXIS) {
            let at = tip + axis * (reach * part);
            let out = hypot(at.x, at.y) - R;
            let here =
                [atan2(at.z, out).rem_euclid(TAU), first + (atan2(at.y, at.x) - first + PI).rem_euclid(TAU) - PI];
            for (hull, here) in [&mut v, &mut psi].into_iter().zip(here) {
                *hull = [lesser(hull[0], here), greater(hull[1], here)];
            }
            let from = hypot(out, at.z);
            if part == 0.0 && from < r - self.part.a_p {
                return;
            }
            if from < r - a {
                break;
            }
        }
        let angle = |far: f64| if a < far { asin(a / far) } else { PI };
        let aside = angle(r);
        #[expect(clippy::cast_precision_loss, reason = "a small count")]
        let columns = self.columns as f64;
        for (row, cells) in self.rows.iter().zip(self.depths.chunks_mut(self.columns)) {
            if row.v < v[0] - aside || row.v > v[1] + aside {
                continue;
            }
            let (sin_v, cos_v) = row.turn;
            let inner = (row.rho - deep * cos_v.abs()).max(0.2 * row.rho);
            let wide = angle(inner);
            let of = |angle: f64| ((row.u - angle) / self.pitch * columns).floor();
            let (first, last) = (of(psi[1] + wide), of(psi[0] - wide));
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "within a channel, and some hundreds"
            )]
            let (mut column, count) = (first.rem_euclid(columns) as usize, (last - first + 1.0).max(0.0) as usize);
            // From column to column the angle falls by the same step.
            let mut turn = sin_cos(row.u - (first + 0.5) / columns * self.pitch);
            for _ in 0..count {
                let (sin, cos) = turn;
                turn = (sin * self.step.1 - cos * self.step.0, cos * self.step.1 + sin * self.step.0);
                let Some(depth) = cells.get_mut(column) else { continue };
                column = if column + 1 == self.columns { 0 } else { column + 1 };
                let into = Vector3::new(cos_v * cos, cos_v * sin, sin_v);
                let from = Vector3::new(R * cos, R * sin, 0.0) - tip;
                // It cuts what has been left where it takes its upper end.
                let top = from + into * (r + *depth);
                let up = top.dot(axis);
                if up < -TOUCH || top.norm_squared() - up * up > a * a + TOUCH {
                    continue;
                }
                if let Some([enter, leave]) = passed(&from, &into, axis, a)
                    && enter <= r + *depth
                {
                    *depth = depth.max(leave - r);
                }
            }
        }
    }

    /// The cells of every channel that are cut, neighbours of one kind as one.
    fn strokes(&self, design: &Design, off: f64) -> Vec<Stroke> {
        let kind = |depth: f64| {
            if depth < UNCUT {
                None
            } else if depth < self.part.a_p - off {
                Some(Ink::Face(170))
            } else if depth <= self.part.a_p + off {
                Some(Ink::Face(40))
            } else {
                Some(Ink::Obverse)
            }
        };
        #[expect(clippy::cast_precision_loss, reason = "a small count")]
        let x = |column: usize| column as f64 / self.columns as f64 * self.pitch;
        let mut strokes = Vec::new();
        for (row, cells) in (0..ALONG).zip(self.depths.chunks(self.columns)) {
            let edges = [f64::from(row), f64::from(row) + 1.0].map(Self::v);
            let mut begin = 0;
            for run in cells.chunk_by(|one, other| kind(*one) == kind(*other)) {
                let end = begin + run.len();
                let span = [x(begin), x(end)];
                begin = end;
                let Some(ink) = run.first().and_then(|&depth| kind(depth)) else { continue };
                for number in 0..design.N {
                    let turn = f64::from(number) * self.pitch;
                    // A row ends a little within the next, so that no white line is seen between both.
                    let side = |v: f64, [from, to]: [f64; 2]| {
                        let (u, torus) = (self.part.circle.u(v) + turn, self.part.circle.torus);
                        steps(from, to, 8).map(move |x| torus.point(u - x, v)).map(|at| [at.x, at.y])
                    };
                    let points = side(edges[0], span).chain(side(edges[1] + 0.002, [span[1], span[0]])).collect();
                    strokes.push(Stroke { filled: true, ..line(ink, points) });
                }
            }
        }
        strokes
    }
}

/// From where to where a line passes a tool, from its beginning beside the tip on; `None` where it does not.
fn passed(from: &Vector3<f64>, into: &Vector3<f64>, axis: &Vector3<f64>, a: f64) -> Option<[f64; 2]> {
    let (along, up) = (into.dot(axis), from.dot(axis));
    let (across, beside) = (into - axis * along, from - axis * up);
    let (square, half, rest) = (across.norm_squared(), across.dot(&beside), beside.norm_squared() - a * a);
    let root = half * half - square * rest;
    if root < 0.0 || along > -1e-9 {
        return None;
    }
    let [enter, leave] = if square > 1e-12 {
        [-1.0, 1.0].map(|side| (-half + side * root.sqrt()) / square)
    } else if rest <= 0.0 {
        [f64::NEG_INFINITY, f64::INFINITY]
    } else {
        return None;
    };
    let leave = leave.min(up / -along);
    (leave > enter).then_some([enter, leave])
}
