//! The way of the tool along a flank: the fitted axis at every v, with the tip as deep as the floor lets it.
//!
//! # Derivation
//! The tip slides along the axis until its end lies in the ball of radius r_f about c, the point of K nearest to the axis:
//! with m the distance of the axis from c and l_c the abscissa of c, the tip is at l_c − r_t(m). As with the own-normal
//! tool the floor is never deeper than a_p.
//!
//! Beyond the ends of the blade the face goes straight on along t, and the tool with it, until it is clear of the blank.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::TAU;

use nalgebra::Vector3;

use crate::geometry::torus::Torus;
use crate::kinds::impeller::clear::fit::{Beyond, FADED, FADES, Fit, Flank};
use crate::kinds::impeller::clear::table::Table;
use crate::kinds::impeller::clear::tool::Tool;
use crate::kinds::impeller::clearance::Stand;
use crate::kinds::impeller::gap::over_tops;
use crate::kinds::impeller::nearest::Axis;
use crate::kinds::impeller::part::{Face, HUB, Part, Piece, RIM};
use crate::machine::rotary::TiltingTable;
use crate::number::root::quadratic;
use crate::number::trig::{atan2, hypot, sin_cos};

/// How close the table is: o and the tip in mm, β and η in mm over 1 mm.
const TABLE: [f64; 4] = [2e-6, 2e-6, 2e-5, 2e-5];
/// Nearer to the rim than this the direction of the axis about the part is that of here, radians.
const POLE: f64 = 1e-6;
/// A tip goes no lower than one whose end reaches this part of the tube's radius to the side.
const WIDEST: f64 = 0.9;
/// The last step towards the place nearest to K, radians: its error goes with the square.
const LAST: f64 = 1e-8;

/// An axis beside the tube's circle K.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Passing {
    /// m, how far from K it passes.
    pub m: f64,
    /// The abscissa of the point of K that is nearest to it.
    pub at: f64,
    /// The sine of its lean along K there.
    pub lean: f64,
}

impl Passing {
    /// The abscissa of a tool's tip, as deep as the floor of radius r_f lets it.
    #[must_use]
    pub fn tip(&self, tool: &Tool, r_f: f64) -> f64 {
        self.at - tool.below(r_f, self.m.min(widest(tool, r_f))).unwrap_or(r_f)
    }
}

/// The greatest m for which a tip is deep enough to cut.
fn widest(tool: &Tool, r_f: f64) -> f64 {
    WIDEST * (r_f - tool.r_c) - tool.flat_radius()
}

/// The line through a point along a unit vector beside the circle of radius R in the centre plane, nearest near ψ.
#[must_use]
pub fn passing(through: &Vector3<f64>, along: &Vector3<f64>, R: f64, psi: f64) -> Passing {
    passing_near(through, along, R, sin_cos(psi))
}

/// The same, the sine and the cosine of ψ being known.
#[must_use]
pub fn passing_near(through: &Vector3<f64>, along: &Vector3<f64>, R: f64, (mut sin, mut cos): (f64, f64)) -> Passing {
    let across = |vector: Vector3<f64>| vector - along * vector.dot(along);
    for _ in 0..30 {
        let (point, tangent) = (Vector3::new(R * cos, R * sin, 0.0), Vector3::new(-R * sin, R * cos, 0.0));
        let away = across(point - through);
        let bend = across(tangent).norm_squared() - away.dot(&point);
        let step = away.dot(&tangent) / bend.max(R * R * 1e-3);
        if step.abs() < LAST {
            // So does what is missed by turning straight on by it.
            (sin, cos) = (sin - step * cos, cos + step * sin);
            break;
        }
        // By 2·atan(step/2), which is as near as the step itself and takes no sine.
        let half = step.clamp(-0.3, 0.3) / 2.0;
        let (sin_by, cos_by) = (2.0 * half / (1.0 + half * half), (1.0 - half * half) / (1.0 + half * half));
        (sin, cos) = (sin * cos_by - cos * sin_by, cos * cos_by + sin * sin_by);
    }
    let from = Vector3::new(R * cos, R * sin, 0.0) - through;
    Passing { m: across(from).norm(), at: from.dot(along), lean: along.y * cos - along.x * sin }
}

/// An axis from the tip to as high as metal stands within a distance from it, K being nearest near ψ.
#[must_use]
pub fn as_metal(axis: &Axis, torus: Torus, reach: f64, psi: f64) -> Axis {
    let Passing { m, at, lean } = passing(&axis.foot, &axis.along, torus.R, psi);
    // Metal is r away from K's nearest point at least, and below it: in the blank nothing is farther out or higher up. By its
    // lean along K an axis has metal above, too.
    let (reach, up) = (m + reach, lean.abs() * (m + reach));
    let low = over_tops(torus.r, reach) - torus.r;
    let high = at + if low + up < 0.0 { low } else { up };
    Axis { range: [axis.range[0], high.max(axis.range[0])], ..*axis }
}

/// Where the machine's axes stand for a tool's axis, turned about the axis of the part; C is that of the direction `round`,
/// in the turn that is near to some angle.
#[must_use]
pub fn stand(machine: TiltingTable, axis: &Axis, round: &Vector3<f64>, near: f64, turn: f64) -> Stand {
    let Axis { foot, along, range } = axis;
    let B = atan2(hypot(along.x, along.y), along.z);
    let C = atan2(round.y, round.x);
    let C = C - ((C - near) / TAU).round() * TAU;
    Stand { at: machine.to_machine(&(foot + along * range[0]), B, C), B, C: C + turn }
}

/// The way of a tool along a face of blade 0.
#[derive(Clone, Debug)]
pub struct FlankWay {
    part: Part,
    face: Face,
    tool: Tool,
    r_f: f64,
    flank: Flank,
    table: Table<4>,
    /// Where it begins and ends, clear of the blank; v runs straight on beyond the ends of the blade.
    pub v: [f64; 2],
}

impl FlankWay {
    /// The way of a tool along a face, fitted between two depths and cutting down to the lower one, clear of the blank by
    /// d_s at both ends.
    #[must_use]
    pub fn new(part: &Part, face: Face, tool: Tool, span: [f64; 2], d_s: f64) -> Self {
        let flank = Flank::new(part, face, tool.a(), span);
        let h = span[1];
        let r_f = part.circle.torus.r + h;
        let mut way = Self {
            part: *part,
            face,
            tool,
            r_f,
            flank,
            table: Table::new(&[0.0, 0.0], [1.0; 4], |_| [0.0; 4]),
            v: [HUB, RIM],
        };
        way.v = way.ends(d_s);
        let pieces = [way.v[0], HUB, RIM - FADES[0], RIM - FADES[1], RIM, way.v[1]];
        let close = [TABLE[0], TABLE[1] / h.max(1.0), TABLE[2] / h.max(1.0), TABLE[3]];
        way.table = Table::new(&pieces, close, |v| {
            let fit = way.flank.lifted(v);
            [fit.o, fit.beta, fit.eta, way.tip(v, &fit)]
        });
        way
    }

    /// The face that the tool runs along.
    #[must_use]
    pub const fn face(&self) -> Face {
        self.face
    }

    /// The tool that was given to [`Self::new`].
    #[must_use]
    pub const fn tool(&self) -> Tool {
        self.tool
    }

    /// The part that the face belongs to.
    #[must_use]
    pub const fn part(&self) -> &Part {
        &self.part
    }

    /// The fit behind it.
    #[must_use]
    pub const fn flank(&self) -> &Flank {
        &self.flank
    }

    /// A point of the axis, and its direction.
    fn line(&self, v: f64, fit: &Fit) -> [Vector3<f64>; 2] {
        let [through, along] = self.flank.line(v, fit, Beyond::Straight);
        [through, along / along.norm()]
    }

    /// How an axis passes K.
    #[must_use]
    pub fn passing(&self, v: f64, fit: &Fit) -> Passing {
        let [through, along] = self.line(v, fit);
        passing(&through, &along, self.part.circle.torus.R, self.part.circle.u(v.clamp(HUB, RIM)))
    }

    /// How the axis at v passes K.
    #[must_use]
    pub fn passing_at(&self, v: f64) -> Passing {
        self.passing(v, &self.fit(v).0)
    }

    /// True where the tool's end fits into the tube at v.
    #[must_use]
    pub fn fits(&self, v: f64) -> bool {
        self.passing_at(v).m <= widest(&self.tool, self.r_f)
    }

    /// How far along the axis its tip is from the middle of the fit, mm, for the fit at v; negative down into the
    /// metal.
    #[must_use]
    pub fn tip(&self, v: f64, fit: &Fit) -> f64 {
        self.passing(v, fit).tip(&self.tool, self.r_f)
    }

    /// v on both sides from which the tool is clear of the blank by d_s. Out there its tilt away from the face has faded.
    fn ends(&self, d_s: f64) -> [f64; 2] {
        let (R, a) = (self.part.circle.torus.R, self.tool.a());
        // Out of the hub plane: the lowest of the axis as far out as the rim.
        let out = HUB - FADED / R;
        let fit = self.flank.lifted(out);
        let [through, along] = self.line(out, &fit);
        let reach = [self.tip(out, &fit), 2.0 * R + a].map(|l| (through + along * l).z);
        let fall = self.part.frame(HUB).1.t.z;
        let hub = FADED + (d_s + a - reach[0].min(reach[1])) / -fall;
        // Out of the rim: upright there.
        let fit = self.flank.lifted(RIM + FADED / R);
        let [through, _] = self.line(RIM, &fit);
        let t = self.part.frame(RIM).1.t;
        let far = R + a + d_s;
        let roots =
            quadratic(t.xy().norm_squared(), 2.0 * t.xy().dot(&through.xy()), through.xy().norm_squared() - far * far);
        [HUB - hub.max(0.0) / R, RIM + roots.map_or(far, |roots| roots[1]).max(0.0) / R]
    }

    /// The fit at v, from the table, and the abscissa of the tip.
    fn fit(&self, v: f64) -> (Fit, f64) {
        let [o, beta, eta, tip] = self.table.at(v);
        (Fit { o, beta, eta, E: 0.0 }, tip)
    }

    /// The tool's axis at v, from the tip to above the tops.
    #[must_use]
    pub fn axis(&self, v: f64) -> Axis {
        let (fit, tip) = self.fit(v);
        let [through, along] = self.line(v, &fit);
        Axis { foot: through, along, range: [tip, self.r_f.max(tip)] }
    }

    /// The same as high as metal stands beside the tool.
    #[must_use]
    pub fn beside(&self, v: f64) -> Axis {
        let psi = self.part.circle.u(v.clamp(HUB, RIM));
        as_metal(&self.axis(v), self.part.circle.torus, self.tool.a() + self.part.overhang(), psi)
    }

    /// Where the machine's axes stand at v, the blade turned about the axis of the part.
    #[must_use]
    pub fn stand(&self, machine: TiltingTable, v: f64, turn: f64) -> Stand {
        // At the pole the axis is upright and says nothing of C: it comes there from one side.
        let round = self.axis(v.min(RIM - POLE)).along;
        stand(machine, &self.axis(v), &round, self.part.circle.u(v.clamp(HUB, RIM)) - TAU, turn)
    }

    /// The radius of the tube that it may not leave.
    #[must_use]
    pub const fn r_f(&self) -> f64 {
        self.r_f
    }

    /// Between which v the face may be in the blank.
    #[must_use]
    pub fn in_blank(&self) -> [f64; 2] {
        let pieces = self.part.pieces(self.face);
        let end = |at: Option<&Piece>, k: usize, v: f64| at.map_or(v, |piece| piece.v[k]);
        [end(pieces.first(), 0, HUB), end(pieces.last(), 1, RIM)]
    }

    /// What the way leaves of the face at v at most, mm.
    #[must_use]
    pub fn rest(&self, v: f64) -> f64 {
        self.flank.rest(v, &self.fit(v).0)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    /// Check designs: R, r, e, a_p; d is 6.
    const DESIGNS: [(f64, f64, f64, f64); 3] = [(25.0, 15.0, 2.0, 2.0), (25.0, 17.0, 1.0, 4.0), (50.0, 30.0, 2.0, 3.0)];

    fn flanks(face: Face) -> impl Iterator<Item = (Part, Flank, f64)> {
        DESIGNS.into_iter().map(move |(R, r, e, a_p)| {
            let part = Part::with(Torus { R, r }, e, a_p);
            (part, Flank::new(&part, face, 3.0, [0.0, a_p]), a_p)
        })
    }

    fn greatest(value: impl Fn(f64) -> f64) -> f64 {
        (1..16).map(|k| value(PI + f64::from(k) * PI / 32.0)).fold(0.0, f64::max)
    }

    #[test]
    fn the_errors_of_the_three_axes_are_those_of_the_check_values() {
        for (face, checks) in [
            (
                Face::Obverse,
                [
                    [0.045_591, 0.003_561, 0.000_097],
                    [0.255_232, 0.033_132, 0.000_625],
                    [0.023_747, 0.001_263, 0.000_039],
                ],
            ),
            (
                Face::Reverse,
                [
                    [0.050_382, 0.005_729, 0.000_113],
                    [0.285_887, 0.044_993, 0.000_793],
                    [0.024_830, 0.001_695, 0.000_042],
                ],
            ),
        ] {
            for ((part, flank, a_p), [normal, closed, fitted]) in flanks(face).zip(checks) {
                let whole = [0.0, a_p];
                let none = Fit { o: 0.0, beta: 0.0, eta: 0.0, E: 0.0 };
                let found = greatest(|v| -flank.error(v, &none, whole)[0]);
                assert!((found - normal).abs() < 2e-6, "{face:?} {found} {normal}");
                // That one goes through the point at the tops, from where the depth is counted.
                let found = greatest(|v| {
                    let fit = flank.closed_form(v);
                    let [through, along] = flank.line(v, &fit, Beyond::Straight);
                    let t = part.frame(v).1.t;
                    let looks = (0..=64).map(|look| a_p * (f64::from(look) / 64.0 - 0.5));
                    let apart = looks.map(|lambda| {
                        let point = through + along * lambda - t * (fit.eta * a_p / 2.0);
                        flank.nearest(&point, v, Beyond::Straight).distance - 3.0
                    });
                    -apart.fold(f64::INFINITY, f64::min)
                });
                assert!((found - closed).abs() < 2e-6, "{face:?} {found} {closed}");
                let found = greatest(|v| {
                    let [least, most] = flank.error(v, &flank.full(v), whole);
                    most.max(-least)
                });
                assert!((found - fitted).abs() < 2e-6, "{face:?} {found} {fitted}");
            }
        }
    }

    #[test]
    fn fits_are_those_of_the_check_values() {
        for (face, checks) in [
            (
                Face::Obverse,
                [
                    [0.004_011, -0.004_087, 0.079_987, 0.000_002_705],
                    [0.016_833, -0.008_608, 0.079_396, -0.000_052_096],
                    [0.002_411, -0.001_626, 0.041_047, 0.000_001_955],
                ],
            ),
            (
                Face::Reverse,
                [
                    [0.006_147, -0.005_849, -0.094_143, 0.000_010_288],
                    [0.024_278, -0.011_625, -0.091_887, -0.000_023_135],
                    [0.002_956, -0.001_932, -0.044_313, 0.000_003_412],
                ],
            ),
        ] {
            for ((_, flank, _), [o, beta, eta, E]) in flanks(face).zip(checks) {
                let fit = flank.full(PI * 1.25);
                assert!((fit.o - o).abs() < 5.1e-7, "{face:?} {fit:?}");
                assert!((fit.beta - beta).abs() < 5.1e-7, "{face:?} {fit:?} {beta}");
                assert!((fit.eta - eta).abs() < 5.1e-7, "{face:?} {fit:?} {eta}");
                assert!((fit.E - E).abs() < 5.1e-10, "{face:?} {fit:?} {E}");
            }
        }
    }

    #[test]
    fn tips_are_those_of_the_check_values() {
        for (face, checks) in [
            (
                Face::Obverse,
                [
                    ([-15.477_697, 5.352_570, -13.348_325], 3.937_179, 1.949_606),
                    ([-12.440_613, 3.114_606, -15.987_406], 3.497_800, 3.937_615),
                    ([-28.421_525, 7.854_152, -25.114_166], 3.947_438, 2.968_639),
                ],
            ),
            (
                Face::Reverse,
                [
                    ([-11.883_645, -0.169_474, -8.798_353], 4.005_663, 1.916_691),
                    ([-9.136_296, -2.003_072, -12.408_327], 3.587_943, 3.902_246),
                    ([-24.902_790, 2.239_457, -20.616_132], 3.977_874, 2.959_890),
                ],
            ),
        ] {
            for ((part, flank, a_p), (tip, m, deepest)) in flanks(face).zip(checks) {
                let way = FlankWay::new(&part, face, Tool::flat(6.0), [0.0, a_p], 5.0);
                let (v, fit) = (PI * 1.25, flank.full(PI * 1.25));
                let [through, along] = way.line(v, &fit);
                let found = through + along * way.tip(v, &fit);
                assert!((found - Vector3::from(tip)).norm() < 2e-6, "{face:?} {found} {tip:?}");
                assert!((way.passing(v, &fit).m - m).abs() < 1e-6);
                let across = along.cross(&Vector3::z()).try_normalize(1e-9).unwrap();
                let other = along.cross(&across);
                let rim = (0..3600).map(|turn| {
                    let (sin, cos) = sin_cos(f64::from(turn) * TAU / 3600.0);
                    part.depth(&(found + (across * cos + other * sin) * 3.0))
                });
                let most = rim.fold(f64::MIN, f64::max);
                // The check values were found on fewer points of the rim.
                assert!((most - deepest).abs() < 3e-5 && most <= a_p, "{most} {deepest}");
            }
        }
    }

    #[test]
    fn the_faded_tilt_is_that_of_the_check_values() {
        let v = RIM - 5.0_f64.to_radians();
        for (face, checks) in [
            (
                Face::Obverse,
                [
                    [17.823_945, 7.937_816, 0.000_435],
                    [14.576_960, 7.068_452, 0.001_295],
                    [10.605_462, 4.220_629, 0.000_270],
                ],
            ),
            (
                Face::Reverse,
                [
                    [-34.408_036, -10.668_363, 0.000_598],
                    [-26.367_014, -8.930_341, 0.001_634],
                    [-15.259_919, -4.929_136, 0.000_316],
                ],
            ),
        ] {
            for ((part, flank, a_p), [full, faded, error]) in flanks(face).zip(checks) {
                let turn = |fit: &Fit| {
                    let [_, along] = flank.line(v, fit, Beyond::Straight);
                    let off = atan2(along.y, along.x) - part.circle.u(v);
                    (off - (off / TAU).round() * TAU).to_degrees()
                };
                assert!((turn(&flank.full(v)) - full).abs() < 2e-5, "{face:?} {} {full}", turn(&flank.full(v)));
                assert!((turn(&flank.faded(v)) - faded).abs() < 2e-5, "{face:?} {} {faded}", turn(&flank.faded(v)));
                let [least, most] = flank.error(v, &flank.faded(v), [0.0, a_p]);
                assert!((most.max(-least) - error).abs() < 2e-6, "{least} {most} {error}");
            }
        }
    }

    #[test]
    fn a_way_is_smooth_up_to_the_pole_leaves_no_undercut_and_ends_clear_of_the_blank() {
        let (R, r, e, a_p) = DESIGNS[0];
        let part = Part::with(Torus { R, r }, e, a_p);
        let machine = TiltingTable { L: 242.9 };
        for face in Face::ALL {
            let way = FlankWay::new(&part, face, Tool::flat(3.0), [0.0, a_p], 5.0);
            let steps = 400;
            let stands: Vec<Stand> = (0..=steps)
                .map(|step| way.v[0] + (way.v[1] - way.v[0]) * f64::from(step) / f64::from(steps))
                .map(|v| way.stand(machine, v, 0.0))
                .collect();
            for pair in stands.windows(2) {
                let moved = (pair[1].at - pair[0].at).norm();
                assert!(moved < 2.5 && (pair[1].B - pair[0].B).abs() < 0.02 && (pair[1].C - pair[0].C).abs() < 0.03);
            }
            let worst =
                (-10..=100).map(|step| HUB + (RIM - HUB) * f64::from(step) / 90.0).fold([0.0_f64; 2], |worst, v| {
                    let least = way.flank.error(v, &way.fit(v).0, [0.0, a_p])[0];
                    [worst[0].max(-least), worst[1].max(way.rest(v))]
                });
            assert!(worst[0] < 2e-5 && worst[1] < 0.007, "{worst:?}");
            for v in way.v {
                let axis = way.axis(v);
                for step in 0..=30 {
                    let l = axis.range[0] + f64::from(step);
                    let point = axis.foot + axis.along * l;
                    let outside = point.z - 1.5 >= 5.0 - 1e-3 || hypot(point.x, point.y) - 1.5 >= 25.0 - 1e-9;
                    assert!(outside, "{face:?} {v} {l} {point}");
                }
            }
        }
    }
}
