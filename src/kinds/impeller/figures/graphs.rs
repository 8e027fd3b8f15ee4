//! Graphs over the point index.

use super::{Curve, FINE, line, sampled, t};
use crate::figure::{Axes, Figure, Ink};
use crate::kinds::impeller::blade::Blade;
use crate::kinds::impeller::fade::Fade;
use crate::kinds::impeller::splitter::Splitter;
use crate::kinds::impeller::track::Track;
use crate::text::Text;

#[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
fn over_index(count: usize, value: impl Fn(usize) -> Option<f64>) -> Vec<[f64; 2]> {
    sampled(count, FINE).filter_map(|at| Some([at as f64, value(at)?])).collect()
}

/// B and C along the blade, in degrees.
pub(super) fn angles(blade: &Blade) -> Figure {
    let degrees = |values: &[f64]| over_index(values.len(), |at| values.get(at).map(|one| one.to_degrees()));
    Figure {
        letters: Figure::LETTERS,
        key: "angles",
        height: Figure::HEIGHT,
        caption: t("Ángulos de giro a lo largo del álabe", "Rotary angles along the blade"),
        axes: Some(Axes { x: Text::same("i"), y: t("ángulo (°)", "angle (°)") }),
        strokes: vec![line(Ink::Obverse, degrees(&blade.B)), line(Ink::Blade, degrees(&blade.C))],
        labels: Vec::new(),
        legend: vec![(Ink::Obverse, Text::same("B")), (Ink::Blade, Text::same("C"))],
    }
}

/// The fraction of the full offset along the splitter: one for both sides as published, or one for each.
pub(super) fn fraction(splitter: &Splitter) -> Figure {
    let curve = |track: Track| {
        let values = splitter.side(track).map_or(&[][..], |side| &side.fraction);
        line(ink(track), over_index(values.len(), |at| values.get(at).copied()))
    };
    let tracks: &[Track] = match splitter.fade {
        Fade::Published => &[Track::Out],
        Fade::EachSide => &[Track::Out, Track::Back],
    };
    Figure {
        letters: Figure::LETTERS,
        key: "fraction",
        height: Figure::HEIGHT,
        caption: t(
            "Fracción de la separación completa a lo largo del álabe intermedio",
            "Fraction of the full offset along the splitter",
        ),
        axes: Some(Axes { x: Text::same("j"), y: Text::same("f_j") }),
        strokes: tracks.iter().map(|&track| curve(track)).collect(),
        labels: Vec::new(),
        legend: match splitter.fade {
            Fade::Published => Vec::new(),
            Fade::EachSide => tracks.iter().map(|&track| (ink(track), track.name().clone())).collect(),
        },
    }
}

const fn ink(track: Track) -> Ink {
    match track {
        Track::Obverse => Ink::Obverse,
        Track::Reverse => Ink::Reverse,
        Track::Out => Ink::Splitter,
        Track::Back => Ink::Blade,
    }
}

/// How far the tip goes into the metal in the middle of each block, along each track.
pub(super) fn deviation(curves: &[Curve]) -> Figure {
    Figure {
        letters: Figure::LETTERS,
        key: "deviation",
        height: Figure::HEIGHT,
        caption: t(
            "Desviación de la punta en mitad de cada bloque, positiva hacia el metal",
            "Deviation of the tip in the middle of each block, positive into the metal",
        ),
        axes: Some(Axes { x: Text::same("i"), y: t("hacia el metal (µm)", "into the metal (µm)") }),
        strokes: curves
            .iter()
            .map(|curve| line(ink(curve.track), curve.points.iter().map(|&[x, y]| [x, y * 1000.0]).collect()))
            .collect(),
        labels: Vec::new(),
        legend: curves.iter().map(|curve| (ink(curve.track), curve.track.name().clone())).collect(),
    }
}
