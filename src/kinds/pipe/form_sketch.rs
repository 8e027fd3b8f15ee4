//! What the sketches of both pipe forms share: the two pipes in elevation and from the end.

use std::f64::consts::PI;

use crate::figure::{Ink, Sketch, arc};
use crate::geometry::pipe_pair::PipePair;
use crate::number::trig::sin_cos;
use crate::text::t;

/// Radii, walls, eccentricity and angle, mm of paper and degrees.
const BRANCH: f64 = 9.0;
const HEADER: f64 = 16.0;
const WALL: f64 = 2.6;
const THETA: f64 = 62.0;
const ECCENTRICITY: f64 = 4.0;
/// How far the branch is drawn along its axis.
const END: f64 = 50.0;
/// Half the length of the header.
const HALF: f64 = 34.0;
/// The middle of the view from the end.
const FROM_LEFT: f64 = 76.0;

/// The pair of the sketches.
pub(super) fn pair() -> PipePair {
    PipePair::new(BRANCH, HEADER, THETA, ECCENTRICITY)
}

/// Both views with the dimensions of pipes and joint. The elevation has the header's axis on the x axis.
pub(super) fn pipes(sketch: &mut Sketch) {
    elevation(sketch);
    from_left(sketch);
}

/// The point of the branch beside its axis and along it, in elevation.
fn on_branch(beside: f64, along: f64) -> [f64; 2] {
    let (sin, cos) = sin_cos(THETA.to_radians());
    [along * cos + beside * sin, along * sin - beside * cos]
}

fn elevation(sketch: &mut Sketch) {
    const PARTS: u8 = 24;
    sketch.rectangle(Ink::Outline, [-HALF, -HEADER], [HALF, HEADER]);
    let curve = (0..=PARTS).map(|at| {
        let point = pair().point(PI * f64::from(at) / f64::from(PARTS));
        [point.x, point.z]
    });
    sketch.shape(Ink::Outline, curve.chain([on_branch(-BRANCH, END), on_branch(BRANCH, END)]).collect::<Vec<_>>());
    for side in [1.0, -1.0] {
        sketch.line(Ink::Safe, [[-HALF, side * (HEADER - WALL)], [HALF, side * (HEADER - WALL)]]);
        sketch.line(Ink::Safe, [on_branch(side * (BRANCH - WALL), 24.0), on_branch(side * (BRANCH - WALL), END)]);
    }
    sketch.line(Ink::Centre, [[-HALF - 3.0, 0.0], [HALF + 4.0, 0.0]]);
    sketch.line(Ink::Centre, [on_branch(0.0, -4.0), on_branch(0.0, END + 3.0)]);
    sketch.dimension([-HALF, -HEADER], [-HALF, HEADER], 4.0, "D_header");
    sketch.dimension([HALF, HEADER], [HALF, HEADER - WALL], 9.0, "t_header");
    sketch.dimension(on_branch(-BRANCH, END), on_branch(BRANCH, END), 5.0, "D_branch");
    let wall = on_branch(-BRANCH + WALL / 2.0, 40.0);
    sketch.pointer([wall[0] - 17.0, wall[1] + 2.0], wall, "t_branch");
    sketch.angle([0.0, 0.0], 15.0, [0.0, THETA], "theta");
}

/// What is seen from the left, as the first-angle method draws it: a branch with e > 0 stands to the right.
fn from_left(sketch: &mut Sketch) {
    let (x, e) = (FROM_LEFT, ECCENTRICITY);
    let top = on_branch(0.0, END)[1];
    let (left, right) = (x + e - BRANCH, x + e + BRANCH);
    let foot = |beside: f64| (HEADER * HEADER - beside * beside).sqrt();
    sketch.shape(Ink::Outline, [[left, foot(e - BRANCH)], [left, top], [right, top], [right, foot(e + BRANCH)]]);
    sketch.shape(Ink::Outline, arc([x, 0.0], HEADER, [0.0, 360.0]));
    sketch.line(Ink::Safe, arc([x, 0.0], HEADER - WALL, [0.0, 360.0]));
    sketch.line(Ink::Centre, [[x - HEADER - 3.0, 0.0], [x + HEADER + 3.0, 0.0]]);
    sketch.line(Ink::Centre, [[x, -HEADER - 3.0], [x, top + 3.0]]);
    sketch.line(Ink::Centre, [[x + e, -3.0], [x + e, top + 3.0]]);
    sketch.dimension([x, top + 3.0], [x + e, top + 3.0], 3.0, "e");
    sketch.word([x, -HEADER - 5.0], t("desde la izquierda, e > 0", "from the left, e > 0"));
}
