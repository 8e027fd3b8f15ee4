//! The speeds that a cut asks of the axes, held against the rapid rates of the form: no axis feeds faster than at rapid.
//!
//! The speed of an axis is its way over the time of the move, the mean over it.
//!
//! # Units
//! mm/min and °/min; times in seconds, angles in radians.

use std::f64::consts::TAU;

use crate::finding::{Finding, Raise, Size};
use crate::gcode::fields::{RAPID_LINEAR, RAPID_ROTARY};
use crate::kinds::pipe::rules::FasterThanRapid;
use crate::machine::axis::Axis;
use crate::machine::rapids::Rapids;
use crate::number::shown;
use crate::parameter::at;
use crate::text::{Text, t};

/// One move of a cut.
#[derive(Clone, Debug, PartialEq)]
pub struct CutMove {
    /// How far each axis goes, mm or degrees.
    pub by: Vec<(Axis, f64)>,
    /// How long that takes, s.
    pub seconds: f64,
    /// The symbol of the angle along the curve and its value where the move begins, radians; `None` beside the curve.
    pub at: Option<(&'static str, f64)>,
}

/// What is told of moves that ask more of an axis than its rapid rate: once for linear and once for rotary axes, with the fastest
/// and its place. Nothing is told where the form says no rate.
#[must_use]
pub fn faster_than_rapid(rapids: &Rapids, runs: &[CutMove]) -> Vec<Finding> {
    let kinds = [(false, rapids.linear, RAPID_LINEAR.key()), (true, rapids.rotary, RAPID_ROTARY.key())];
    let told = kinds.into_iter().filter_map(|(rotary, rate, key)| {
        let rate = rate?;
        let fastest = runs
            .iter()
            .flat_map(|run| run.by.iter().map(move |(axis, by)| (run, *axis, by.abs() * 60.0 / run.seconds)))
            .filter(|(_, axis, _)| axis.rotary() == rotary)
            .reduce(|most, one| if one.2 > most.2 { one } else { most });
        let (run, axis, speed) = fastest.filter(|(_, _, speed)| *speed > rate * (1.0 + 1e-9))?;
        let unit = if rotary { "°/min" } else { "mm/min" };
        let size = |value| Size { value, unit, decimals: 3 };
        let near = run.at.map_or(t(" al lado de la curva", " beside the curve"), |(symbol, angle)| {
            let angle = shown((angle % TAU).to_degrees(), 1);
            Text::new(format!(" cerca de {symbol} = {angle}°"), format!(" near {symbol} = {angle}°"))
        });
        let axis = Text::same(axis.letter().to_string());
        let told = FasterThanRapid { axis, near, speed: size((speed * 1e3).ceil() / 1e3), key, rate: size(rate) };
        Some(told.at(at([key])).measuring(speed, crate::finding::Limit::AtMost(rate)))
    });
    told.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axis_that_would_feed_faster_than_at_rapid_is_told_with_its_place() {
        let run = |turn: f64, angle| CutMove {
            by: vec![(Axis::A, turn), (Axis::X, 1.0)],
            seconds: 0.5,
            at: Some(("φ", angle)),
        };
        let runs = [run(1.0, 0.0), run(-20.0, 1.0), run(3.0, 2.0)];
        let rapids = |rotary| Rapids { linear: Some(120.0), rotary, tool_change: None };
        assert!(
            faster_than_rapid(&rapids(None), &runs).is_empty()
                && faster_than_rapid(&rapids(Some(2400.0)), &runs).is_empty()
        );
        let told = faster_than_rapid(&rapids(Some(1800.0)), &runs);
        let [one] = &told[..] else { panic!("{told:?}") };
        assert_eq!((one.code(), one.figures().missed()), ("P2130", [Some(2400.0), Some(1800.0)]));
        assert!(one.what.en.contains("near φ = 57.3°"), "{}", one.what.en);
    }
}
