//! Bodies made of triangles.

use nalgebra::Vector3;
use serde::Serialize;

use super::column;
use crate::text::Text;

/// What a body or curve is, which says its colour: the page has a colour of each for light and dark.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Paint {
    /// The part.
    Metal,
    /// A blade.
    Blade,
    /// A splitter blade.
    Splitter,
    /// Another part of the assembly, through which one sees.
    Ghost,
    /// Chuck, jaws, tailstock.
    Fixture,
    /// A line to be cut.
    Line,
}

/// A body: points in mm and triangles of their indices, counter-clockwise seen from outside.
#[derive(Clone, Debug, Serialize)]
pub struct Mesh {
    /// What it is.
    pub name: Text,
    /// Its colour.
    pub paint: Paint,
    /// The corners, mm.
    #[serde(serialize_with = "column::points")]
    pub points: Vec<[f64; 3]>,
    /// Three indices of corners each.
    #[serde(serialize_with = "column::wholes")]
    pub triangles: Vec<u32>,
}

impl Mesh {
    /// A body without triangles.
    #[must_use]
    pub const fn new(name: Text, paint: Paint) -> Self {
        Self { name, paint, points: Vec::new(), triangles: Vec::new() }
    }

    /// Adds a net of points, rows by columns, its quadrilaterals parted along a diagonal. Its outside is where columns
    /// turned counter-clockwise by a right angle are rows. `closed`: the last row is joined to the first.
    pub fn net(&mut self, rows: &[Vec<Vector3<f64>>], closed: bool) {
        let columns = rows.iter().map(Vec::len).min().unwrap_or(0);
        let Ok(first) = u32::try_from(self.points.len()) else { return };
        let (Ok(width), Ok(height)) = (u32::try_from(columns), u32::try_from(rows.len())) else { return };
        for row in rows {
            self.points.extend(row.iter().take(columns).map(|point| [point.x, point.y, point.z]));
        }
        let steps = if closed { height } else { height.saturating_sub(1) };
        for row in 0..steps {
            let next = (row + 1) % height;
            for column in 0..width.saturating_sub(1) {
                let corner = |row: u32, column: u32| first + row * width + column;
                let [a, b, c, d] =
                    [corner(row, column), corner(row, column + 1), corner(next, column + 1), corner(next, column)];
                self.triangles.extend([a, b, c, a, c, d]);
            }
        }
    }

    /// Adds facets of four corners, counter-clockwise seen from outside, of points of their own. Where two corners are one, what
    /// is left is a triangle.
    pub fn facets<'a>(
        &mut self,
        points: impl IntoIterator<Item = Vector3<f64>>,
        facets: impl IntoIterator<Item = &'a [usize; 4]>,
    ) {
        let first = self.points.len();
        self.points.extend(points.into_iter().map(<[f64; 3]>::from));
        let index = |corner: usize| u32::try_from(first + corner).unwrap_or(u32::MAX);
        for &[a, b, c, d] in facets {
            for [one, two, three] in [[a, b, c], [a, c, d]] {
                if one != two && two != three && three != one {
                    self.triangles.extend([index(one), index(two), index(three)]);
                }
            }
        }
    }
}
