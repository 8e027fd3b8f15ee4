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
//! Square to the face, towards the waste w, v is λ a′·w. The beam's axis runs half a kerf m beside the line. So the beams beside
//! pass a place of the line at m cos ψ, with tan ψ = λ a′·w / (|r′|(1 − k)): they cut m(1 − cos ψ), no more than m tan² ψ / 2,
//! beyond the face, and open it by that over λ. k and ψ grow with λ: the header's outside is where both are greatest.
//!
//! Only neighbours are compared. Lines that stand farther apart are tangent to the grown branch at different sides of it, or
//! lean away from it.
//!
//! # Units
//! Millimetres and radians.

use crate::finding::{Figures, Limit, Raise, Said, Size};
use crate::gcode::program::Program;
use crate::kinds::pipe::form::E;
use crate::kinds::pipe::hole::parameters::GAMMA;
use crate::kinds::pipe::hole::proof::rules::BeamsCross;
use crate::kinds::pipe::hole::station::Groove;
use crate::limits::CUT_LOOKS;
use crate::number::interval::Interval;
use crate::number::jet::{Jet, dot};
use crate::number::trig::asin;
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

    /// The angle by which the face opens at most, radians; none where its lines cross.
    #[must_use]
    pub fn opening(&self) -> f64 {
        if self.found.at_most(0) < 1.0 { self.found.at_most(1) } else { 0.0 }
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

/// k, the angle by which the face opens, and λ, none of them less than anywhere between two angles.
fn lines(groove: &Groove, from: f64, to: f64) -> [f64; 3] {
    let beam = Groove { beside: 0.0, ..*groove }.beam(Jet::parameter(from, to));
    let waste = Groove { beside: 1.0, ..*groove }.beam(Jet::parameter(from, to)).root;
    let (root, axis) = (beam.root, beam.axis);
    let a = axis[1].square() + axis[2].square();
    let b = root[1] * axis[1] + root[2] * axis[2];
    let c = root[1].square() + root[2].square() - Jet::of(groove.R_o * groove.R_o);
    let lambda = (((b.square() - a * c).sqrt() - b) * a.inverse()).value;
    let turns = axis.map(|part| Jet { value: part.first, ..Jet::of(0.0) });
    let along = root.map(|part| Jet { value: part.first, ..Jet::of(0.0) });
    let across: [Jet; 3] = std::array::from_fn(|part| waste[part] - root[part]);
    let value = |one, other| dot(one, other).value;
    let (square, turned) = (value(along, along), value(turns, along));
    let k = -(lambda * turned * square.inverse());
    let opens = lambda * value(turns, across);
    let order = Interval::of(1.0) - k;
    if order.low.is_nan() || order.low <= 0.0 {
        return [k.high, std::f64::consts::FRAC_PI_2, lambda.high];
    }
    // m tan² ψ / (2 λ).
    let tan_square = opens.square() * (square * order.square()).inverse();
    let beyond = tan_square * lambda.inverse() * (0.5 * groove.beside);
    [k.high, asin(beyond.high.clamp(0.0, 1.0)), lambda.high]
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use nalgebra::Vector3;
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
            // Where they come nearest the half kerf reaches farther than the face by no more than the opening.
            if k < 0.9 {
                let by = along + turns * here.2;
                let cos = by.dot(&along) / (along.norm() * by.norm());
                prop_assert!(asin((groove.beside * (1.0 - cos) / here.2).min(1.0)) <= opening + slack, "{cos} {opening}");
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
        assert!(crossing.opening() == 0.0);
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
