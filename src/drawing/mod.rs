//! Drawings at 1:1: a figure in millimetres as DXF, as SVG, and as a PDF tiled over sheets of paper.
//!
//! What comes in is a [`Figure`] whose unit is the millimetre, x right and y up; what goes out is bytes. A millimetre of
//! the figure is a millimetre of each file: nothing is scaled, moved points are moved together, and coordinates are given
//! to 0.0001 mm. Titles of axes are not drawn, since a graph has no 1:1. The same figure gives the same bytes.

pub mod dxf;
mod layer;
pub mod rules;
mod sheet;
pub mod svg;
pub mod template;
pub mod tiles;

use thiserror::Error;

use crate::figure::{Arc, Figure};
use crate::finding::rules::NotDrawable;
use crate::finding::{Finding, Place, Raise};
use crate::kind::Provenance;
use crate::limits::PRINTED_SHEETS;
use crate::text::{Language, Text};

/// Height of a label's letters in mm.
const LETTERS: f64 = 3.3;

/// A figure to be drawn at 1:1, with what identifies it.
#[derive(Clone, Copy, Debug)]
pub struct Drawing<'a> {
    /// What is drawn.
    pub figure: &'a Figure,
    /// What of it is arcs of circles; none on paper.
    pub arcs: &'a [Arc],
    /// What it is.
    pub title: &'a Text,
    /// The part's name.
    pub part: &'a str,
    /// Where it comes from.
    pub source: &'a Provenance,
    /// The language of titles, labels and layers.
    pub language: Language,
}

/// Why a figure cannot be drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum NotDrawn {
    /// It has no stroke of two points or more.
    #[error("there is nothing to draw")]
    Empty,
    /// A coordinate is not finite.
    #[error("a coordinate is not finite")]
    NotFinite,
    /// It takes more sheets of paper than [`PRINTED_SHEETS`].
    #[error("it takes more than {most} sheets", most = PRINTED_SHEETS)]
    TooManySheets,
}

impl NotDrawn {
    /// The reason as a finding on the drawing with a title.
    #[must_use]
    pub fn finding(self, title: &Text) -> Finding {
        let title = title.clone();
        match self {
            Self::Empty | Self::NotFinite => NotDrawable { title }.at(Place::File),
            Self::TooManySheets => self::rules::TooManySheets { title, most: PRINTED_SHEETS }.at(Place::File),
        }
    }
}

/// Least and greatest x, then y, of the strokes and arcs and of the boxes that labels take up; in mm.
///
/// # Errors
/// Where there is nothing to draw, or a coordinate is not finite.
fn bounds(figure: &Figure, arcs: &[Arc], language: Language) -> Result<[[f64; 2]; 2], NotDrawn> {
    if !figure.strokes.iter().any(|stroke| stroke.points.len() > 1) {
        return Err(NotDrawn::Empty);
    }
    let labels = figure.labels.iter().flat_map(|label| {
        let [x, y] = label.at;
        // Half an em a letter is more than the fonts take.
        let half = label.text.get(language).chars().fold(0.0, |width, _| width + LETTERS / 4.0);
        [[x - half, y - LETTERS], [x + half, y + LETTERS]]
    });
    let mut found = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    let arcs = arcs.iter().flat_map(Arc::reach);
    for point in figure.strokes.iter().flat_map(|stroke| &stroke.points).copied().chain(arcs).chain(labels) {
        for ([least, greatest], value) in found.iter_mut().zip(point) {
            if !value.is_finite() {
                return Err(NotDrawn::NotFinite);
            }
            (*least, *greatest) = (least.min(value), greatest.max(value));
        }
    }
    Ok(found)
}

/// A length in mm to 0.0001 mm, never as −0.
fn number(value: f64) -> String {
    let text = format!("{value:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{Ink, Label, Stroke};

    fn figure(points: Vec<[f64; 2]>) -> Figure {
        Figure {
            letters: Figure::LETTERS,
            key: "f",
            height: Figure::HEIGHT,
            caption: Text::same("f"),
            axes: None,
            strokes: vec![Stroke { ink: Ink::Cut, points, filled: false, arrow: false }],
            labels: Vec::new(),
            legend: Vec::new(),
        }
    }

    #[test]
    fn lengths_are_plain_decimals_without_minus_zero() {
        assert_eq!([-0.00001, 12.5, 100.0, -3.123_46].map(number), ["0", "12.5", "100", "-3.1235"]);
    }

    #[test]
    fn bounds_hold_strokes_and_the_boxes_of_labels() {
        let mut figure = figure(vec![[0.0, 0.0], [10.0, -5.0]]);
        assert_eq!(bounds(&figure, &[], Language::En), Ok([[0.0, 10.0], [-5.0, 0.0]]));
        figure.labels.push(Label { at: [10.0, 0.0], text: Text::same("abcd") });
        let [[_, right], [_, top]] = bounds(&figure, &[], Language::En).unwrap();
        assert!((right - 13.3).abs() < 1e-9 && (top - LETTERS).abs() < 1e-9);
    }

    #[test]
    fn what_cannot_be_drawn_says_so() {
        assert_eq!(bounds(&figure(vec![[0.0, 0.0]]), &[], Language::En), Err(NotDrawn::Empty));
        assert_eq!(bounds(&figure(vec![[0.0, 0.0], [f64::NAN, 0.0]]), &[], Language::En), Err(NotDrawn::NotFinite));
    }
}
