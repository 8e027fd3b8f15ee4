//! Along both flanks of a splitter and round its nose, in one pass.
//!
//! # Derivation
//! The nose is half a cylinder about the ruling at v_s. A tool whose axis is parallel to that ruling, along N(v_s), cuts it
//! exactly, where the own-normal tool of the contour leans towards it by its distance over r. So the pass comes in on the
//! fitted axis of the obverse to v_s, turns its axis on the spot, goes round the nose at the distance D from its ruling, in
//! the direction −cos f·t + sin f·b, D such that the axis is a from the splitter, and leaves along the reverse likewise.
//!
//! Parallel to N(v_s) the end would stand high where it is beside the nose along the tube: √(r_f² − (e/2 + d)²) below K, the
//! tool being between e/2 and e/2 + d from the ruling. So the axis leans off the nose: by the angle δ about the top of the nose
//! it passes K nearer by r·δ, the end goes that much deeper and stands more level. At the foot of the nose that leaves a_p·δ. With
//! δ = (e/2 + a)/r it goes through K: leaning more takes the end away from the floor again, and B where the machine may not go.
//!
//! Between two axes beside a nearly plane face, both clear of it, all are clear.
//!
//! The half round stands out of the twisted faces by (e/2)(hτ)²/2. Near v_s the axes beside the faces are moved off along b by
//! what that takes.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::Vector3;

use crate::kinds::impeller::clear::body::{Body, Obstacles, turned};
use crate::kinds::impeller::clear::contact::closing;
use crate::kinds::impeller::clear::cut::CutStrategy;
use crate::kinds::impeller::clear::fit::FADES;
use crate::kinds::impeller::clear::flank::{FlankWay, as_metal, passing, stand};
use crate::kinds::impeller::clear::table::Table;
use crate::kinds::impeller::clear::tool::Tool;
use crate::kinds::impeller::clearance::Stand;
use crate::kinds::impeller::nearest::Axis;
use crate::kinds::impeller::part::{Part, RIM};
use crate::machine::rotary::TiltingTable;
use crate::machine::travel::{Travel, excess};
use crate::number::root::halved;
use crate::number::trig::{atan2, hypot, sin_cos};

/// The part of the ridge c_s that a flat end may leave at the foot of the nose, to leave less in the corner.
const FOOT: f64 = 0.5;
/// How close the distance from the nose's ruling is kept, mm.
const TABLE: f64 = 1e-5;
/// Nearer to the splitter than its own radius by this a tool is left where it is, mm: the fit takes as much.
const NEARER: f64 = 2e-4;
/// How often the way along a face is asked, twice as far from v_s each time, whether the nose still stands out there.
const ASKED: u8 = 6;
/// Halvings towards D where no root is found: to a billionth of the tool's radius and closer.
const HALVINGS: u8 = 40;
/// Parts of the lean that are tried where B has no room for all of it.
const LEANS: u8 = 8;
/// How far B keeps from the ends of its travel, degrees: more than the output grid and the turns on the spot take.
const LIMIT: f64 = 0.01;
/// Places at which each piece of the way is looked at for its room.
const SAMPLES: u8 = 24;

/// The way round a splitter.
#[derive(Clone, Debug)]
pub struct Round<'a> {
    part: &'a Part,
    tool: Tool,
    /// Along its obverse and along its reverse.
    ways: [&'a FlankWay; 2],
    v_s: f64,
    /// How far from an axis metal is looked for.
    reach: f64,
    /// δ, by which the axis leans off the nose.
    lean: f64,
    /// D over f.
    distance: Table<1>,
    /// By how much the axes beside the faces are moved off, over v, and up to which v.
    off: [(Table<1>, f64); 2],
}

impl<'a> Round<'a> {
    /// The way of the finishing tool along two flanks, cut equally deep, of the splitter that begins at v_s.
    #[must_use]
    pub fn new(part: &'a Part, cut: &CutStrategy, ways: [&'a FlankWay; 2], v_s: f64) -> Self {
        let none = || Table::new(&[0.0, 0.0], [1.0], |_| [0.0]);
        let tool = cut.finish;
        let through = (part.e / 2.0 + tool.a()) / part.circle.torus.r;
        let lean = (FOOT * cut.scallop / part.a_p).min(through) * tool.flat_radius() / tool.a();
        // The half round stands higher than the faces beside it.
        let reach = tool.a() + part.overhang() + part.top(v_s) - part.noses_ends(v_s)[0];
        let mut round =
            Self { part, tool, ways, v_s, reach, lean, distance: none(), off: [(none(), v_s), (none(), v_s)] };
        let body = Body::new(part, v_s, 0.0, tool.a());
        round.lean = round.within(cut.tilt);
        round.distance = Table::new(&[-FRAC_PI_2, 0.0, FRAC_PI_2], [TABLE], |f| [round.clear_of(&body, f)]);
        round.off = [0, 1].map(|side| {
            let off = |v: f64| round.off_nose(&body, side, v);
            if off(v_s) <= 0.0 {
                return (none(), v_s);
            }
            let near = (part.e / 2.0 + tool.a()) / 4.0 / part.circle.torus.R;
            let ends = (0..ASKED).map(|k| v_s + near * f64::from(1_u32 << k)).filter(|&v| v < RIM - FADES[0]);
            let end = ends.into_iter().find(|&v| off(v) <= 0.0).unwrap_or(v_s);
            if end > v_s { (Table::new(&[v_s, end], [TABLE], |v| [off(v)]), end) } else { (none(), v_s) }
        });
        round
    }

    /// As much of the lean, in steps, as takes B nowhere out of its travel round the nose; without a lean B stands there as on every
    /// upright pass.
    ///
    /// # Derivation
    /// N − δ·out has the length √(1 + δ²) for every f, and its height is N_z − δ(b_z sin f − t_z cos f): highest and lowest where
    /// (sin f, cos f) lies along (b_z, −t_z), and at the ends of the half turn.
    fn within(&self, travel: Travel) -> f64 {
        let frame = self.part.frame(self.v_s).1;
        let steepest = atan2(frame.b.z, -frame.t.z);
        let places = [-FRAC_PI_2, FRAC_PI_2, steepest - PI, steepest, steepest + PI];
        let keeps = |lean: f64| {
            places.into_iter().filter(|f| f.abs() <= FRAC_PI_2).all(|f| {
                let along = Self { lean, ..self.clone() }.beside(f, self.part.e / 2.0 + self.tool.a()).along;
                let B = atan2(hypot(along.x, along.y), along.z).to_degrees();
                [B - LIMIT, B + LIMIT].into_iter().all(|B| excess(travel, B).is_none())
            })
        };
        let parts = (0..LEANS).map(|less| self.lean * f64::from(LEANS - less) / f64::from(LEANS));
        parts.into_iter().find(|&lean| keeps(lean)).unwrap_or(0.0)
    }

    /// An axis beside a face at v, moved off it along b, its tip as deep as the floor lets it.
    fn moved(&self, side: usize, v: f64, by: f64) -> Axis {
        let axis = self.ways[side].axis(v);
        let foot = axis.foot + self.part.frame(v).1.b * (self.ways[side].face().side() * by);
        self.deep(foot, axis.along, self.part.circle.u(v))
    }

    /// By how much the axis beside a face at v must be moved off for the splitter's nose.
    fn off_nose(&self, body: &Body, side: usize, v: f64) -> f64 {
        let wanted = self.tool.a() - NEARER;
        let lacking = |by: f64| wanted - body.apart(&self.seen(&self.moved(side, v, by)));
        let mut by = 0.0_f64;
        for _ in 0..3 {
            by += lacking(by).max(0.0);
        }
        by
    }

    /// An axis through a point, with its tip as deep as the floor lets it, K being nearest near ψ.
    fn deep(&self, foot: Vector3<f64>, along: Vector3<f64>, near: f64) -> Axis {
        let r_f = self.ways[0].r_f();
        let tip = passing(&foot, &along, self.part.circle.torus.R, near).tip(&self.tool, r_f);
        Axis { foot, along, range: [tip, r_f.max(tip)] }
    }

    /// The axis beside a face at v.
    fn along(&self, side: usize, v: f64) -> Axis {
        let (off, end) = &self.off[side];
        if v < *end { self.moved(side, v, off.at(v)[0].max(0.0)) } else { self.ways[side].axis(v) }
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
        // What is no number counts as clear.
        let enters = |D: f64| off(D) < 0.0;
        halved([low + a, low], HALVINGS, |D| !enters(D))
    }

    /// An axis as high as metal stands beside the tool.
    fn seen(&self, axis: &Axis) -> Axis {
        as_metal(axis, self.part.circle.torus, self.reach, self.part.circle.u(self.v_s))
    }

    /// The axis that leans off the nose, D from its ruling.
    fn beside(&self, f: f64, D: f64) -> Axis {
        let (P, frame) = self.part.frame(self.v_s);
        let (sin, cos) = sin_cos(f);
        let out = frame.b * sin - frame.t * cos;
        let along = frame.N - out * self.lean;
        self.deep(P + out * D, along / along.norm(), self.part.circle.u(self.v_s))
    }

    /// The axis at x, of blade 0: along the obverse up to 1, turning up to 2, round the nose up to 3, turning back up to
    /// 4, along the reverse up to 5.
    fn axis(&self, x: f64) -> Axis {
        let nose = |f: f64| self.beside(f, self.distance.at(f)[0]);
        let between = |from: &Axis, to: &Axis, part: f64| {
            let tip = |axis: &Axis| axis.foot + axis.along * axis.range[0];
            let along = from.along + (to.along - from.along) * part;
            let foot = tip(from) + (tip(to) - tip(from)) * part;
            Axis { foot, along: along / along.norm(), range: [0.0, self.ways[0].r_f()] }
        };
        if x < 1.0 {
            self.along(0, self.v_at(0, 1.0 - x))
        } else if x < 2.0 {
            between(&self.along(0, self.v_s), &nose(FRAC_PI_2), x - 1.0)
        } else if x <= 3.0 {
            nose(FRAC_PI_2 * (5.0 - 2.0 * x))
        } else if x <= 4.0 {
            between(&nose(-FRAC_PI_2), &self.along(1, self.v_s), x - 3.0)
        } else {
            self.along(1, self.v_at(1, x - 4.0))
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
            [self.off[side].1, RIM - FADES[0], RIM - FADES[1], RIM]
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
    pub fn stand(&self, machine: TiltingTable, x: f64, turn: f64) -> Stand {
        let beside =
            if x < 1.0 { Some((0, self.v_at(0, 1.0 - x))) } else { (x > 4.0).then(|| (1, self.v_at(1, x - 4.0))) };
        match beside {
            Some((side, v)) if v >= self.off[side].1 => self.ways[side].stand(machine, v, turn),
            beside => {
                let (axis, v) = (self.axis(x), beside.map_or(self.v_s, |(_, v)| v));
                stand(machine, &axis, &axis.along, self.part.circle.u(v) - TAU, turn)
            }
        }
    }

    /// True where the whole way keeps clear of both blades of the channel, the splitter turned about the axis of the part, and
    /// the end of the tool fits into the tube.
    #[must_use]
    pub fn is_clear(&self, pitch: f64, turn: f64) -> bool {
        let a = self.tool.a();
        let obstacles = Obstacles::new(self.part, pitch, a, None);
        let fits = |way: &&FlankWay| {
            (0..=SAMPLES).all(|look| way.fits(self.v_s + (RIM - self.v_s) * f64::from(look) / f64::from(SAMPLES)))
        };
        self.ways.iter().all(fits)
            && (0..5 * u16::from(SAMPLES)).all(|look| {
                let axis = turned(&self.seen(&self.axis(f64::from(look) / f64::from(SAMPLES))), turn);
                obstacles.keeps_obverse(&axis, a) && obstacles.keeps_reverse(&axis, a)
            })
    }
}
