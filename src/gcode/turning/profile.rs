//! The contour that a turning cycle works to, as its blocks describe it.

use crate::gcode::turning::edge::{Broken, Edge, Square, broken};
use crate::gcode::turning::trouble::Trouble;

/// One block of a contour: a straight line or an arc to a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Element {
    /// Where to, `[X, Z]`, X the radius; mm.
    pub to: [f64; 2],
    /// Of an arc its centre, `[X, Z]`, and whether it runs clockwise (G2).
    pub arc: Option<([f64; 2], bool)>,
    /// Programmed at rapid (G0).
    pub rapid: bool,
    /// The line of its block in the program, counted from 1.
    pub line: usize,
}

/// A contour, from the point where the tool stands when the cycle is called.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Profile {
    /// The point where the cycle starts, `[X, Z]`, X the radius; mm.
    pub start: [f64; 2],
    /// The blocks that move, in their order; the first leads from the start to the contour.
    pub elements: Vec<Element>,
}

impl Profile {
    /// Breaks the corner between the last element, a line, and a line from its end to a point: the last element is cut short, and
    /// the edge put behind it with the number of its block. The line to the point is not put in.
    ///
    /// # Errors
    /// Those of [`broken`].
    pub fn break_edge(&mut self, point: [f64; 2], edge: Edge, square: Option<Square>) -> Result<(), Box<Trouble>> {
        let (before, last) = match self.elements.as_mut_slice() {
            [] => return Ok(()),
            [last] => (self.start, last),
            [.., before, last] => (before.to, last),
        };
        let Some(Broken { from, to, arc }) = broken([before, last.to, point], edge, square)? else { return Ok(()) };
        let line = last.line;
        last.to = from;
        if from == before && self.elements.len() > 1 {
            // The corner takes all of the line; the element that leads to the contour stays.
            self.elements.pop();
        }
        self.elements.push(Element { to, arc, rapid: false, line });
        Ok(())
    }
}
