//! The drawings of an impeller for the report: the part, its geometry, the machine's positions and the tool paths.
//!
//! Everything is drawn from the same geometry that the tables show; nothing is traced by hand.

mod channel;
mod depths;
mod geometry;
mod graphs;
mod machine;
mod setup;
mod solid;

use crate::figure::{Figure, Ink, Label, Stroke};
use crate::kinds::impeller::Model;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::track::Track;
use crate::text::{Text, t};

/// Points of a curve that a drawing needs at most: finer is not seen on paper.
const FINE: usize = 240;

/// How far the tip goes into the metal along a track, to be drawn.
#[derive(Clone, Debug)]
pub struct Curve {
    /// The track whose blocks were measured.
    pub track: Track,
    /// Point index and depth in mm, positive into the metal.
    pub points: Vec<[f64; 2]>,
}

/// All figures, by the keys that the report's templates know. Those of the published passes are left out where the part is cut
/// clear, and the other way round.
#[must_use]
pub fn figures(design: &Design, model: &Model, deviation: &[Curve]) -> Vec<Figure> {
    let Model { blade, passes, splitter, clear, .. } = model;
    let splitter = splitter.as_ref();
    let mut figures = vec![
        solid::cover(design, blade, splitter, clear.as_ref()),
        geometry::villarceau(blade),
        geometry::plan(design, blade, splitter, clear.as_ref()),
        geometry::frame(blade),
        graphs::angles(blade),
        machine::positions(design, blade),
        machine::blank(design),
        graphs::deviation(deviation),
        setup::side(design),
        setup::above(design, blade),
    ];
    match clear {
        Some(plan) => figures.extend(channel::channel(design, blade, plan)),
        None => figures.extend([
            geometry::tool_paths(design, blade),
            machine::safe_points(passes),
            machine::safe_ends(design, blade, passes),
        ]),
    }
    figures.extend(depths::depths(design, model));
    if let Some(splitter) = splitter {
        figures.push(geometry::crossing(design, blade, splitter));
        figures.push(graphs::fraction(splitter));
    }
    figures
}

fn line(ink: Ink, points: Vec<[f64; 2]>) -> Stroke {
    Stroke::line(ink, points)
}

fn arrow(ink: Ink, from: [f64; 2], to: [f64; 2]) -> Stroke {
    Stroke { ink, points: vec![from, to], filled: false, arrow: true }
}

fn label(at: [f64; 2], text: Text) -> Label {
    Label { at, text }
}

/// Indices of at most about `most` points of `count`, first and last among them.
fn sampled(count: usize, most: usize) -> impl Iterator<Item = usize> {
    let step = (count / most.max(1)).max(1);
    let last = count.saturating_sub(1);
    (0..last).step_by(step).chain((count > 0).then_some(last))
}

/// The ends of `count` equal steps, both `from` and `to` among them.
fn steps(from: f64, to: f64, count: u16) -> impl Iterator<Item = f64> + Clone {
    (0..=count).map(move |at| from + (to - from) * f64::from(at) / f64::from(count.max(1)))
}
