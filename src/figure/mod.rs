//! A drawing: strokes and labels in millimetres of the thing drawn, to be scaled by whoever shows it.

mod sketch;

use std::f64::consts::{FRAC_PI_2, TAU};

pub use self::sketch::{Side, Sketch, arc, on_circle, sized};

use crate::number::trig::atan2;
use crate::parameter::field::choices;
use crate::text::Text;

/// How a stroke looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ink {
    /// Outline of the part.
    Outline,
    /// Line to cut along.
    Cut,
    /// Where the ends of a wrapped template meet: long dashes.
    Seam,
    /// The outline that a part is wanted to have.
    Profile,
    /// Hidden or constructional line: thin and grey.
    Thin,
    /// Centre line: dash-dotted.
    Centre,
    /// Dimension line.
    Dimension,
    /// Mean line of a blade.
    Blade,
    /// Path along the obverse.
    Obverse,
    /// Path along the reverse.
    Reverse,
    /// Splitter blade.
    Splitter,
    /// Rapid or safe move: dashed.
    Safe,
    /// The first, second and third vector of a frame.
    Axis(u8),
    /// A face of metal in some light, from 0 (shadow) to 255 (full light): for filled strokes.
    Face(u8),
}

/// A polyline, in mm of the thing drawn or in the units of a graph's axes.
#[derive(Clone, Debug)]
pub struct Stroke {
    /// How it looks.
    pub ink: Ink,
    /// The points (x right, y up).
    pub points: Vec<[f64; 2]>,
    /// Closed and filled with a light tint of its ink, without an outline: edges are strokes of their own.
    pub filled: bool,
    /// Ends in an arrow head.
    pub arrow: bool,
}

impl Stroke {
    /// An open polyline.
    #[must_use]
    pub const fn line(ink: Ink, points: Vec<[f64; 2]>) -> Self {
        Self { ink, points, filled: false, arrow: false }
    }
}

/// An arc of a circle, drawn as one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    /// How it looks.
    pub ink: Ink,
    /// The centre, x right and y up, mm.
    pub centre: [f64; 2],
    /// The radius, mm.
    pub radius: f64,
    /// Where it begins and ends, anticlockwise.
    pub ends: [[f64; 2]; 2],
}

impl Arc {
    /// The angles of its ends from the x axis, rad; the second is the greater one, by less than a whole turn.
    #[must_use]
    pub fn angles(&self) -> [f64; 2] {
        let [first, last] = self.ends.map(|[x, y]| atan2(y - self.centre[1], x - self.centre[0]));
        [first, first + (last - first).rem_euclid(TAU)]
    }

    /// Its ends, and where it reaches farthest along x and y.
    #[must_use]
    pub fn reach(&self) -> Vec<[f64; 2]> {
        let [first, last] = self.angles();
        let [x, y] = self.centre;
        let sides = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]].into_iter().zip([0.0, 1.0, 2.0, 3.0]);
        let farthest = sides
            .filter(|(_, quarter)| (quarter * FRAC_PI_2 - first).rem_euclid(TAU) < last - first)
            .map(|([dx, dy], _)| [x + dx * self.radius, y + dy * self.radius]);
        self.ends.into_iter().chain(farthest).collect()
    }
}

/// A word on a drawing.
#[derive(Clone, Debug)]
pub struct Label {
    /// The middle of the foot of its letters.
    pub at: [f64; 2],
    /// The word; `_` sets what follows as a subscript.
    pub text: Text,
}

/// Titles of a graph's axes; a figure without is a drawing of shapes with one scale both ways.
#[derive(Clone, Debug)]
pub struct Axes {
    /// Title of the abscissa with its unit.
    pub x: Text,
    /// Title of the ordinate with its unit.
    pub y: Text,
}

/// Mean width of a letter of a label in print, mm.
pub const LETTER: f64 = 1.6;

/// How many letters of its width a label takes; what is set as a subscript takes less, and is counted whole.
#[must_use]
pub fn letters(label: &str) -> f64 {
    f64::from(u32::try_from(label.chars().filter(|letter| *letter != '_').count()).unwrap_or(u32::MAX))
}

/// A drawing or graph.
#[derive(Clone, Debug)]
pub struct Figure {
    /// Its name in the report's data, as `cover`.
    pub key: &'static str,
    /// Greatest height in print, mm: what its page leaves beside the table that it belongs to. A graph has that of its
    /// plot.
    pub height: f64,
    /// How high the letters of its labels are, mm on its own paper: [`Self::LETTERS`], or [`Self::SKETCHED`].
    pub letters: f64,
    /// The caption under the figure.
    pub caption: Text,
    /// Titles of the axes, for a graph.
    pub axes: Option<Axes>,
    /// Strokes, the first drawn first.
    pub strokes: Vec<Stroke>,
    /// Words on the drawing, drawn over the strokes.
    pub labels: Vec<Label>,
    /// Legend: ink and meaning.
    pub legend: Vec<(Ink, Text)>,
}

impl Figure {
    /// The height of a figure that shares its page with a table, mm.
    pub const HEIGHT: f64 = 62.0;
    /// The letters of a figure that a page of the report sets at down to 64 %: 7.5 pt or more on paper, mm.
    pub const LETTERS: f64 = 4.2;
    /// The letters of a sketch, which the set-up sheet shows as it is, mm.
    pub const SKETCHED: f64 = 3.3;
}

choices! {
    /// A sheet of paper to print on.
    pub enum Paper {
        /// 210 mm × 297 mm.
        A4 = "a4" ("A4", "A4"),
        /// 297 mm × 420 mm.
        A3 = "a3" ("A3", "A3"),
    }
}

impl Paper {
    /// Short and long side in mm (ISO 216).
    #[must_use]
    pub const fn sides(self) -> [f64; 2] {
        match self {
            Self::A4 => [210.0, 297.0],
            Self::A3 => [297.0, 420.0],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_arc_reaches_beyond_its_ends_where_it_passes_an_axis() {
        let arc = |ends| Arc { ink: Ink::Profile, centre: [1.0, 2.0], radius: 5.0, ends };
        assert_eq!(arc([[6.0, 2.0], [1.0, 7.0]]).angles(), [0.0, FRAC_PI_2]);
        assert_eq!(arc([[4.0, 6.0], [-2.0, 6.0]]).reach(), [[4.0, 6.0], [-2.0, 6.0], [1.0, 7.0]]);
        assert_eq!(arc([[-2.0, 6.0], [4.0, 6.0]]).reach().len(), 5, "the long way round");
    }
}
