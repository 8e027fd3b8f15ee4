//! Whether the beams of neighbouring places cross within the wall.
//!
//! # Derivation
//! The face of the cut is made of lines: through the root r(α) along the torch's direction a(α), to the header's outside at
//! λ(α). While α grows, the place at λ on its line moves by v = r′ + λ a′. Both are square to a, and r′ runs along the curve:
//! along it v is |r′|(1 − k) with
//!
//! k = −λ a′·r′ / r′².
//!
//! Neighbouring lines cross at λ/k from the root. Where that is within the wall, k ≥ 1, they stand in the wrong order from
//! there on, and each cuts into what its neighbour should leave.
//!
//! Square to the face, towards the waste w, v is λ a′·w. The beam's axis runs half a kerf m beside the line, through X = r + m w: with
//! e along the curve it moves by
//!
//! c = (X′ + λ a′)·e along the curve, and q = λ a′·w square to it.
//!
//! Seen along the beams, with the frame of e and w kept from turning, the axes draw a line from that of the place itself: at each of
//! its places it goes at the angle ψ, tan ψ = q/c, turned towards the waste by what the curve has bent to there. Where the curve
//! bends away from the waste, X′·e > r′·e, it turns the other way, by no more than G = (X′·e − r′·e)/c over a way of m, and half as
//! much again where the line is slanted. So while c > 0 that line stays within Ψ = ψ + G of the direction along the curve, and
//! what is d behind the face, m + d from the axis of its own place, is (m + d) cos Ψ from all of it at least: the beams cut no
//! deeper than
//!
//! d = m (1/cos Ψ − 1).
//!
//! At the header's outside that opens the bevel, in the section square to the root, by atan(d/λ). The bound is told up to Ψ = 45°,
//! d = 0.41 m. Beyond that, and where lines cross, an axis may come near from the other side of its neighbours, and nothing is
//! told but the greatest opening seen, which is no bound.
//!
//! λ counts on the neighbour's line, where the place behind the face lies within 1.5 m of it both along e and along w and within
//! the header: by convexity no more than (1.5 m (|N·e| + |N·w|) + 4.5 m²/R_o)/(N·a) beyond where that line leaves the header,
//! N being the direction out of it there. ψ grows with λ: so much is added to it.
//!
//! Only neighbours are compared. Lines that stand farther apart are tangent to the grown branch at different sides of it, or
//! lean away from it.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::TAU;

use nalgebra::Vector3;

use crate::finding::{Figures, Limit, Raise, Said, Size};
use crate::gcode::program::Program;
use crate::kinds::pipe::form::E;
use crate::kinds::pipe::hole::parameters::GAMMA;
use crate::kinds::pipe::hole::proof::rules::BeamsCross;
use crate::kinds::pipe::hole::station::{Groove, Station};
use crate::limits::CUT_LOOKS;
use crate::number::interval::Interval;
use crate::number::jet::{Jet, Vector, dot};
use crate::number::trig::{atan, cos};
use crate::proof::check::{At, Check, Question};
use crate::proof::enclosed::Enclosed;
use crate::text::{Language, Text, t};

/// How the lines of the face stand to their neighbours over the cut.
#[derive(Clone, Copy, Debug)]
pub struct Crossing {
    groove: Groove,
    /// k, and the angle by which the face opens.
    found: Enclosed<2>,
    /// Where k is greatest of what was looked at: α, λ and k.
    nearest: [f64; 3],
}

impl Crossing {
    /// Of no motion yet. `opening` is the angle up to which an opening must be known, radians.
    #[must_use]
    pub const fn new(groove: Groove, opening: f64) -> Self {
        let found = Enclosed::new([1e-3, 1e-4], [1.0, opening], CUT_LOOKS);
        Self { groove, found, nearest: [0.0, 0.0, f64::NEG_INFINITY] }
    }

    /// Takes the part of the cut between two angles in.
    pub fn take(&mut self, at: At, [from, to]: [f64; 2]) {
        let (groove, nearest) = (self.groove, &mut self.nearest);
        let mut look = |alpha: f64| {
            let [k, opening, lambda] = lines(&groove, alpha, alpha);
            if k > nearest[2] {
                *nearest = [alpha, lambda, k];
            }
            (alpha, [k, opening])
        };
        let first = [from, to].map(&mut look);
        self.found.take(
            at,
            &first,
            |(_, values)| *values,
            |one, other| {
                let [k, opening, _] = lines(&groove, one.0, other.0);
                [k, opening]
            },
            |one, other| look(f64::midpoint(one.0, other.0)),
        );
    }

    /// The angle by which the face opens at most, radians; `None` where that is not bounded.
    #[must_use]
    pub fn opening(&self) -> Option<f64> {
        let most = self.found.at_most(1);
        (self.found.at_most(0) < 1.0 && most < UNBOUNDED).then_some(most)
    }

    /// The greatest angle, radians, by which the beams open the face of the places looked at, and α of that place: it may be greater
    /// between them. Zero where no place can be looked at.
    #[must_use]
    pub fn seen(&self) -> [f64; 2] {
        let groove = &self.groove;
        let count = (TAU * groove.pair.r / (0.25 * groove.beside)).clamp(720.0, 7200.0).ceil();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small count")]
        let count = count as usize;
        let bare = Groove { beside: 0.0, ..*groove };
        let station = |i: usize| bare.at(TAU * i as f64 / count as f64);
        let Some(stations) = (0..count).map(station).collect::<Option<Vec<_>>>() else { return [0.0; 2] };
        let opened = stations.iter().enumerate().step_by(count.div_ceil(720)).map(|(i, own)| {
            let lambda = (own.face - own.root).dot(&own.pose.axis);
            let mut deep = 0.0_f64;
            // What is cut behind the face is one stretch from it on, found from the nearest beams outwards.
            for by in 1..count / 5 {
                for other in [&stations[(i + by) % count], &stations[(i + count - by) % count]] {
                    if let Some([from, to]) = behind(own, other, groove.beside)
                        && from <= deep + 1e-9
                    {
                        deep = deep.max(to);
                    }
                }
            }
            [atan(deep / lambda), own.alpha]
        });
        opened.fold([0.0; 2], |most, one| if one[0] > most[0] { one } else { most })
    }

    /// The check that no neighbouring lines cross within the wall.
    #[must_use]
    pub fn check(&self, program: &Program) -> Check {
        let name = t("Cruce de chorros vecinos, desde la raíz", "Crossing of neighbouring beams, from the root");
        let most = self.found.at_most(0);
        let [alpha, lambda, _] = self.nearest;
        let [height, length] = rounded(lambda, most).map(Size::mm);
        let value = if most <= 1e-3 {
            t("no se cruzan", "they do not cross")
        } else {
            Text::same(format!("≥ {}", height.said(Language::En)))
        };
        let limit = Text::same(length.said(Language::En).into_owned());
        let asked = Question::new("crossing", name, program).showing(value, limit);
        let asked = self.found.put(asked.of_parameters([GAMMA.key(), E.key()]), 0).measuring(most);
        // The lines may cross no nearer than they are long.
        let asked = asked.comparing(Figures::of(lambda / most, Some(Limit::AtLeast(lambda))));
        let alpha = Size::degrees(alpha.to_degrees(), 0);
        asked.holds(most < 1.0, |place| BeamsCross { alpha, height, length }.at(place))
    }
}

/// The height at which lines λ long cross and λ itself, rounded to 0.001 mm: no nearer than the height, which is rounded down,
/// and no shorter than the length, which is rounded up.
fn rounded(lambda: f64, k: f64) -> [f64; 2] {
    [(lambda / k * 1e3).floor() / 1e3, (lambda * 1e3).ceil() / 1e3]
}

/// From where to where the beam of one place cuts what lies behind the face of another at the header's outside, mm; `None` where it
/// does not come there.
fn behind(own: &Station, other: &Station, m: f64) -> Option<[f64; 2]> {
    let axis = other.pose.axis;
    let across = |way: Vector3<f64>| way - axis * way.dot(&axis);
    let (from, by) = (across(own.face - other.root - other.waste * m), across(-own.waste));
    let (a, b, c) = (by.norm_squared(), from.dot(&by), from.norm_squared() - m * m);
    let inside = b * b - a * c;
    (a > 1e-12 && inside >= 0.0).then(|| [-b - inside.sqrt(), -b + inside.sqrt()].map(|end| end / a))
}

/// An opening that is not bounded, radians: more than any is.
const UNBOUNDED: f64 = std::f64::consts::FRAC_PI_2;

/// The greatest Ψ for which the opening is bounded, radians.
const SLANTED: f64 = std::f64::consts::FRAC_PI_4;

/// k, the angle by which the face opens, and λ, none of them less than anywhere between two angles.
fn lines(groove: &Groove, from: f64, to: f64) -> [f64; 3] {
    let beam = Groove { beside: 0.0, ..*groove }.beam(Jet::parameter(from, to));
    let waste = Groove { beside: 1.0, ..*groove }.beam(Jet::parameter(from, to)).root;
    let (root, axis) = (beam.root, beam.axis);
    let a = axis[1].square() + axis[2].square();
    let b = root[1] * axis[1] + root[2] * axis[2];
    let c = root[1].square() + root[2].square() - Jet::of(groove.R_o * groove.R_o);
    let lambda = (((b.square() - a * c).sqrt() - b) * a.inverse()).value;
    let moves = |place: Vector| place.map(|part| Jet { value: part.first, ..Jet::of(0.0) });
    let (turns, along) = (moves(axis), moves(root));
    let beams = moves(groove.beam(Jet::parameter(from, to)).root);
    let across: [Jet; 3] = std::array::from_fn(|part| waste[part] - root[part]);
    let value = |one, other| dot(one, other).value;
    let (square, turned) = (value(along, along), value(turns, along));
    let k = -(lambda * turned * square.inverse());
    // R_o N·a, R_o N·e and R_o N·w.
    let leaves = (b.square() - a * c).sqrt().value;
    let out: Vector = std::array::from_fn(|part| {
        if part == 0 {
            Jet::of(0.0)
        } else {
            Jet { value: root[part].value + lambda * axis[part].value, ..Jet::of(0.0) }
        }
    });
    let (m, length) = (groove.beside, square.sqrt());
    let slope = (value(out, along) * length.inverse()).size() + value(out, across).size();
    let reach = lambda.high + (1.5 * m * slope + 4.5 * m * m) / leaves.low;
    let lambda_over = lambda.hull(Interval::of(reach));
    let order = value(beams, along) + lambda_over * turned;
    if !(leaves.low > 0.0 && order.low > 0.0 && k.high < 1.0 && lambda.low > 0.0) {
        return [k.high, UNBOUNDED, lambda.high];
    }
    let slant = (lambda_over * value(turns, across) * length * order.inverse()).size();
    let bends = ((value(beams, along) - square) * order.inverse()).high.max(0.0);
    let psi = atan(slant) + 1.5 * bends;
    let opening = if psi <= SLANTED { atan(m * (1.0 / cos(psi) - 1.0) / lambda.low) } else { UNBOUNDED };
    [k.high, opening, lambda.high]
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::geometry::pipe_pair::PipePair;
    use crate::kinds::pipe::hole::height::Torch;

    fn groove(pair: PipePair, R_o: f64, gamma: f64) -> Groove {
        Groove {
            pair,
            R_o,
            R_i: pair.R,
            gamma,
            beside: 0.8,
            torch: Torch { r_g: 6.0, R_g: 15.0, Psi: 0.5, d0: 4.0, g0: 2.0 },
        }
    }

    /// Root, direction and length of the line at an angle.
    fn line(groove: &Groove, alpha: f64) -> Option<(Vector3<f64>, Vector3<f64>, f64)> {
        let station = Groove { beside: 0.0, ..*groove }.at(alpha)?;
        let axis = station.pose.axis;
        Some((station.root, axis, (station.face - station.root).dot(&axis)))
    }

    proptest! {
        #[test]
        fn a_span_encloses_where_neighbouring_lines_cross(
            R in 30.0..300.0_f64, part in 0.1..0.8_f64, theta in 50.0..130.0_f64, off in -0.8..0.8_f64, gamma in 0.0..0.8_f64,
            alpha in 0.0..TAU, wide in 0.0..0.02_f64, share in 0.0..1.0_f64,
        ) {
            let groove = groove(PipePair::new(R * part, R, theta, R * (1.0 - part) * off), R * 1.1, gamma);
            let (at, step) = (alpha + wide * share, 1e-5);
            let (Some(before), Some(here), Some(after)) =
                (line(&groove, at - step), line(&groove, at), line(&groove, at + step)) else { return Ok(()) };
            let (along, turns) = ((after.0 - before.0) / (2.0 * step), (after.1 - before.1) / (2.0 * step));
            let k = -here.2 * turns.dot(&along) / along.norm_squared();
            let [most, opening, lambda] = lines(&groove, alpha, alpha + wide);
            let slack = 1e-4 * (1.0 + k.abs());
            prop_assert!(k <= most + slack && here.2 <= lambda + 1e-6 * R, "{k} {most}");
            // The beams of neighbours cut no more than the opening.
            if opening < UNBOUNDED {
                let bare = Groove { beside: 0.0, ..groove };
                let own = bare.at(at).expect("a place");
                for by in [-0.3, -0.1, -0.03, -0.01, -0.003, -0.001, 0.001, 0.003, 0.01, 0.03, 0.1, 0.3] {
                    let Some(other) = bare.at(at + by) else { continue };
                    let [_, there, _] = lines(&groove, at.min(at + by), at.max(at + by));
                    let deep = behind(&own, &other, groove.beside).map_or(0.0, |[_, to]| to);
                    prop_assert!(atan(deep / here.2) <= there.max(opening) + 1e-6, "{by} {deep} {opening} {there}");
                }
            }
            let [exact, ..] = lines(&groove, at, at);
            prop_assert!((exact - k).abs() <= slack, "{exact} {k}");
        }
    }

    /// A small branch near the header's side, cut without a groove angle: computed apart from this code, on 2,880 lines.
    #[test]
    fn lines_that_cross_at_a_third_of_the_wall_are_found() {
        let groove = groove(PipePair::new(12.65, 101.37, 90.0, -79.7), 109.55, 0.0);
        let mut crossing = Crossing::new(groove, 0.02);
        for piece in 0..32_u8 {
            crossing.take(At::line(1), [f64::from(piece), f64::from(piece + 1)].map(|at| TAU * at / 32.0));
        }
        let [alpha, lambda, k] = crossing.nearest;
        assert!((alpha.to_degrees() - 270.0).abs() < 0.5 && (lambda - 17.128).abs() < 0.01, "{alpha} {lambda}");
        assert!((k - 2.991).abs() < 2e-3 && crossing.found.at_most(0) - k <= 2e-3, "{k}");
        assert!(crossing.opening().is_none() && crossing.seen()[0] > 0.1, "{:?}", crossing.seen());
    }

    /// Neighbouring beams that come near to crossing and then cross, as the wall grows: what they open was computed apart from this code,
    /// with beams as cylinders.
    #[test]
    fn the_opening_goes_on_where_beams_cross() {
        let opened = |wall: f64| {
            let pair = PipePair::new(18.285, 57.15 - wall, 65.0, 13.72);
            let groove = Groove { R_i: pair.R, ..groove(pair, 57.15, 15.0_f64.to_radians()) };
            let mut crossing = Crossing::new(groove, 1.0_f64.to_radians());
            for piece in 0..32_u8 {
                crossing.take(At::line(1), [f64::from(piece), f64::from(piece + 1)].map(|at| TAU * at / 32.0));
            }
            (crossing.opening().map(f64::to_degrees), crossing.seen()[0].to_degrees())
        };
        for (wall, due) in [(16.0, 4.19), (16.1, 4.46)] {
            let (most, seen) = opened(wall);
            assert!(most.is_none() && (seen - due).abs() < 0.05, "{wall}: {most:?} {seen}");
        }
        for wall in [6.0, 8.0, 10.0, 12.0, 14.0, 15.0] {
            let (most, seen) = opened(wall);
            assert!(most.is_none_or(|most| seen <= most + 1e-6 && most < 2.0), "{wall}: {most:?} {seen}");
        }
    }

    /// A height that is nearer to the hundredth above than to the one below.
    #[test]
    fn the_height_of_a_crossing_is_told_once_and_no_higher_than_it_may_be() {
        let program = Program::sample("hole");
        let mut crossing = Crossing::new(groove(PipePair::new(12.65, 101.37, 90.0, -79.7), 109.55, 0.0), 0.02);
        crossing.take(At::line(1), [0.0, TAU]);
        crossing.nearest = [1.0, 10.000_4, 1.0];
        let check = crossing.check(&program);
        let ratio = 10.000_4 / crossing.found.at_most(0);
        let height = check.value().en.trim_start_matches("≥ ").trim_end_matches(" mm").to_owned();
        let value: f64 = height.parse().expect("a number");
        assert!(value <= ratio && ratio - value < 1e-3, "{height} {ratio}");
        assert_eq!(check.limit().en, "10.001 mm");
        let said = check.finding().expect("they cross").what.en.to_string();
        assert!(said.contains(&format!("cross {height} mm from")) && said.contains("measures 10.001 mm"), "{said}");
        // 25.9367 beside 30.0001, as it was told: 25.94 and ≥ 25.93.
        assert_eq!(rounded(30.000_1, 30.000_1 / 25.936_7), [25.936, 30.001]);
    }
}
