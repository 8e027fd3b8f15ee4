//! Graphs over the point index.

use super::{FINE, line, sampled, t};
use crate::figure::{Axes, Figure, Ink};
use crate::impeller::blade::Blade;
use crate::impeller::splitter::Splitter;
use crate::text::Text;

#[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
fn over_index(count: usize, value: impl Fn(usize) -> Option<f64>) -> Vec<[f64; 2]> {
    sampled(count, FINE).filter_map(|at| Some([at as f64, value(at)?])).collect()
}

/// B and C along the blade, in degrees.
pub(super) fn angles(blade: &Blade) -> Figure {
    let degrees = |values: &[f64]| over_index(values.len(), |at| values.get(at).map(|one| one.to_degrees()));
    Figure {
        key: "angles",
        caption: t("Ángulos de giro a lo largo del álabe", "Rotary angles along the blade"),
        axes: Some(Axes { x: Text::same("i"), y: t("ángulo (°)", "angle (°)") }),
        strokes: vec![line(Ink::Obverse, degrees(&blade.B)), line(Ink::Blade, degrees(&blade.C))],
        labels: Vec::new(),
        legend: vec![(Ink::Obverse, Text::same("B")), (Ink::Blade, Text::same("C"))],
    }
}

/// The fraction of the full offset along the splitter.
pub(super) fn fraction(splitter: &Splitter) -> Figure {
    let values = &splitter.fraction;
    Figure {
        key: "fraction",
        caption: t(
            "Fracción de la separación completa a lo largo del álabe intermedio",
            "Fraction of the full offset along the splitter",
        ),
        axes: Some(Axes { x: Text::same("j"), y: Text::same("f_j") }),
        strokes: vec![line(Ink::Splitter, over_index(values.len(), |at| values.get(at).copied()))],
        labels: Vec::new(),
        legend: Vec::new(),
    }
}
