//! Along both flanks of a splitter and round its nose, in one pass.
//!
//! # Derivation
//! The nose is half a cylinder about the ruling at v_s. A tool whose axis is parallel to that ruling, along N(v_s), cuts it
//! exactly, where the own-normal tool of the contour leans towards it by its distance over r. So the pass comes in on the
//! fitted axis of the obverse to v_s, turns its axis onto N(v_s) on the spot, goes round the nose at the distance D from its
//! ruling, in the direction −cos f·t + sin f·b, D such that the axis is a from the splitter, and leaves along the reverse
//! likewise. Between two axes beside a nearly plane face, both clear of it, all are clear.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::kinds::impeller::clear::body::{Body, Obstacles, turned};
use crate::kinds::impeller::clear::contact::closing;
use crate::kinds::impeller::clear::fit::FADES;
use crate::kinds::impeller::clear::flank::{FlankWay, as_metal, passing, stand};
use crate::kinds::impeller::clear::table::Table;
use crate::kinds::impeller::clear::tool::Tool;
use crate::kinds::impeller::clearance::Stand;
use crate::kinds::impeller::nearest::Axis;
use crate::kinds::impeller::part::{Part, RIM};
use crate::machine::rotary::Rotary;
use crate::number::trig::sin_cos;

/// How close the distance from the nose's ruling is kept, mm.
const TABLE: f64 = 1e-5;
/// Places at which each piece of the way is looked at for its room.
const LOOKS: u8 = 24;

/// The way round a splitter.
#[derive(Clone, Debug)]
pub struct Round<'a> {
    part: &'a Part,
    tool: Tool,
    /// Along its obverse and along its reverse.
    ways: [&'a FlankWay; 2],
    v_s: f64,
    /// D over f.
    distance: Table<1>,
}

impl<'a> Round<'a> {
    /// The way of a tool along two flanks, cut equally deep, of the splitter that begins at v_s.
    #[must_use]
    pub fn new(part: &'a Part, tool: Tool, ways: [&'a FlankWay; 2], v_s: f64) -> Self {
        let mut round = Self { part, tool, ways, v_s, distance: Table::new(&[0.0, 0.0], [1.0], |_| [0.0]) };
        let body = Body::new(part, v_s, 0.0, tool.a());
        round.distance = Table::new(&[-FRAC_PI_2, 0.0, FRAC_PI_2], [TABLE], |f| [round.clear_of(&body, f)]);
        round
    }

    /// The least D at which the axis is a from the splitter.
    fn clear_of(&self, body: &Body, f: f64) -> f64 {
        let a = self.tool.a();
        let off = |D: f64| body.apart(&self.seen(&self.beside(f, D))) - a;
        let low = self.part.e / 2.0 + a;
        if off(low) >= 0.0 {
            return low;
        }
        if let Some((D, _)) = closing(low, 1.0, a, off).filter(|(D, _)| *D > low) {
            return D;
        }
        let (mut low, mut high) = (low, low + a);
        for _ in 0..40 {
            let middle = f64::midpoint(low, high);
            if off(middle) < 0.0 { low = middle } else { high = middle }
        }
        high
    }

    /// An axis as high as metal stands beside the tool.
    fn seen(&self, axis: &Axis) -> Axis {
        let reach = self.tool.a() + self.part.overhang();
        as_metal(axis, self.part.circle.torus, reach, self.part.circle.u(self.v_s))
    }

    /// The axis along N(v_s), D from the nose's ruling.
    fn beside(&self, f: f64, D: f64) -> Axis {
        let (P, frame) = self.part.frame(self.v_s);
        let (sin, cos) = sin_cos(f);
        let foot = P + (frame.b * sin - frame.t * cos) * D;
        let near = self.part.circle.u(self.v_s);
        let pass = passing(&foot, &frame.N, self.part.circle.torus.R, near);
        let r_f = self.ways[0].r_f();
        let tip = pass.at - self.tool.below(r_f, pass.m).unwrap_or(r_f);
        Axis { foot, along: frame.N, range: [tip, r_f.max(tip)] }
    }

    /// The axis at x, of blade 0: along the obverse up to 1, onto N(v_s) up to 2, round the nose up to 3, off N(v_s) up to
    /// 4, along the reverse up to 5.
    fn axis(&self, x: f64) -> Axis {
        let nose = |f: f64| self.beside(f, self.distance.at(f)[0]);
        let between = |from: &Axis, to: &Axis, part: f64| {
            let tip = |axis: &Axis| axis.foot + axis.along * axis.range[0];
            let along = from.along + (to.along - from.along) * part;
            let foot = tip(from) + (tip(to) - tip(from)) * part;
            Axis { foot, along: along / along.norm(), range: [0.0, self.ways[0].r_f()] }
        };
        let [obverse, reverse] = self.ways;
        if x < 1.0 {
            obverse.axis(self.v_at(0, 1.0 - x))
        } else if x < 2.0 {
            between(&obverse.axis(self.v_s), &nose(FRAC_PI_2), x - 1.0)
        } else if x <= 3.0 {
            nose(FRAC_PI_2 * (5.0 - 2.0 * x))
        } else if x <= 4.0 {
            between(&nose(-FRAC_PI_2), &reverse.axis(self.v_s), x - 3.0)
        } else {
            reverse.axis(self.v_at(1, x - 4.0))
        }
    }

    /// v on a flank, from v_s on to where its way is clear of the rim.
    fn v_at(&self, side: usize, part: f64) -> f64 {
        self.v_s + (self.ways[side].v[1] - self.v_s) * part
    }

    /// Where its pieces end.
    #[must_use]
    pub fn pieces(&self) -> Vec<f64> {
        let breaks = |side: usize| {
            let end = self.ways[side].v[1];
            [RIM - FADES[0], RIM - FADES[1], RIM]
                .into_iter()
                .filter(|&v| v > self.v_s)
                .map(move |v| (v - self.v_s) / (end - self.v_s))
        };
        let mut pieces = vec![0.0];
        pieces.extend(breaks(0).rev().map(|part| 1.0 - part));
        pieces.extend([1.0, 2.0, 3.0, 4.0]);
        pieces.extend(breaks(1).map(|part| 4.0 + part));
        pieces.push(5.0);
        pieces
    }

    /// Where the machine's axes stand at x, the splitter turned about the axis of the part.
    #[must_use]
    pub fn stand(&self, machine: Rotary, x: f64, turn: f64) -> Stand {
        if x < 1.0 {
            return self.ways[0].stand(machine, self.v_at(0, 1.0 - x), turn);
        }
        if x > 4.0 {
            return self.ways[1].stand(machine, self.v_at(1, x - 4.0), turn);
        }
        let axis = self.axis(x);
        stand(machine, &axis, &axis.along, self.part.circle.u(self.v_s) - TAU, turn)
    }

    /// True where the whole way keeps clear of both blades of the channel, the splitter turned about the axis of the part, and
    /// the end of the tool fits into the tube.
    #[must_use]
    pub fn is_clear(&self, pitch: f64, turn: f64) -> bool {
        let a = self.tool.a();
        let obstacles = Obstacles::new(self.part, pitch, a, None);
        let fits = |way: &&FlankWay| {
            (0..=LOOKS).all(|look| way.fits(self.v_s + (RIM - self.v_s) * f64::from(look) / f64::from(LOOKS)))
        };
        self.ways.iter().all(fits)
            && (0..5 * u16::from(LOOKS)).all(|look| {
                let axis = turned(&self.seen(&self.axis(f64::from(look) / f64::from(LOOKS))), turn);
                obstacles.keeps_obverse(&axis, a) && obstacles.keeps_reverse(&axis, a)
            })
    }
}
