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

    /// The lines of the elements behind the first that go along the part in rapid, each counted from 1.
    ///
    /// Such an element leads farther from the start, towards the contour, on X or on Z, and on neither axis stays on the start's own
    /// side, where there is no part. The way to the contour may go in two, one axis each; not where the second comes in Z from the face
    /// at Z0, or from before it, into the part.
    #[must_use]
    pub fn along_in_rapid(&self) -> Vec<usize> {
        let side = [0, 1].map(|axis| {
            let beyond: f64 = self.elements.iter().map(|element| element.to[axis] - self.start[axis]).sum();
            if beyond < 0.0 { -1.0 } else { 1.0 }
        });
        let depth = |at: [f64; 2]| [0, 1].map(|axis: usize| (at[axis] - self.start[axis]) * side[axis]);
        let mut told = Vec::new();
        for (index, pair) in self.elements.windows(2).enumerate() {
            let [from, to] = [pair[0].to, pair[1].to];
            let [before, behind] = [depth(from), depth(to)];
            let deeper = (0..2).any(|axis| behind[axis] > before[axis]);
            let clear = (0..2).any(|axis| before[axis].max(behind[axis]) <= 0.0);
            let apart = |axis: usize| pair[0].to[axis] == self.start[axis] && to[1 - axis] == from[1 - axis];
            let enters = from[1] >= 0.0 && to[1] < 0.0;
            let leads = index == 0 && pair[0].rapid && (apart(0) || apart(1) && !enters);
            if pair[1].rapid && deeper && !clear && !leads {
                told.push(pair[1].line);
            }
        }
        told
    }
}

#[cfg(test)]
mod tests {
    use super::{Element, Profile};

    /// The lines told of a contour from a start: the first element has line 1; `r` is in rapid.
    fn told(start: [f64; 2], elements: &[(char, f64, f64)]) -> Vec<usize> {
        let element = |(line, &(way, x, z)): (usize, &(char, f64, f64))| Element {
            to: [x, z],
            arc: None,
            rapid: way == 'r',
            line: line + 1,
        };
        Profile { start, elements: elements.iter().enumerate().map(element).collect() }.along_in_rapid()
    }

    #[test]
    fn elements_in_rapid_that_go_along_the_part_are_told() {
        let outside = [28.0, 2.0];
        for (start, elements, lines) in [
            // Along the part before the first cut, and between two cuts.
            (
                outside,
                &[('r', 11.5, 2.0), ('r', 11.5, 0.0), ('r', 13.0, -1.5), ('r', 13.0, -25.2), ('g', 28.0, -30.0)][..],
                &[3, 4][..],
            ),
            (outside, &[('r', 8.0, 2.0), ('g', 8.0, -12.0), ('r', 8.0, -24.0), ('g', 20.0, -26.0)], &[3]),
            // Towards the axis by less than a millimetre.
            (outside, &[('r', 7.0, 2.0), ('g', 15.9, -34.0), ('r', 15.5, -34.0), ('g', 17.0, -35.0)], &[3]),
            // At the end, too.
            (outside, &[('r', 7.0, 2.0), ('g', 7.0, -34.0), ('r', 20.0, -40.0)], &[3]),
            // The way to the contour in two, before the part and into it; from beside it into its face.
            (outside, &[('r', 7.0, 2.0), ('r', 7.0, 0.0), ('g', 15.0, -34.0)], &[]),
            (outside, &[('r', 7.0, 2.0), ('r', 7.0, -3.0), ('g', 15.0, -34.0)], &[2]),
            ([18.0, -2.0], &[('r', 17.0, -2.0), ('r', 17.0, -2.5), ('g', 19.0, -4.5)], &[]),
            (outside, &[('r', 28.0, -20.0), ('r', 26.0, -20.0), ('g', 15.0, -10.0), ('g', 15.0, 0.0)], &[]),
            (outside, &[('g', 7.0, 2.0), ('r', 7.0, 0.0), ('g', 15.0, -34.0)], &[2]),
            // Away from the part, and where the start is.
            (outside, &[('r', 7.0, 2.0), ('g', 7.0, -34.0), ('r', 20.0, -34.0), ('r', 20.0, 1.0)], &[]),
            (outside, &[('g', -0.5, 0.5), ('r', -0.5, 2.0), ('r', 28.0, 2.0), ('r', 28.0, 0.0), ('g', -0.5, 0.0)], &[]),
            // In a bore.
            (
                [8.0, 2.0],
                &[('r', 20.0, 2.0), ('g', 20.0, 0.0), ('r', 20.0, -9.0), ('g', 12.0, -9.0), ('r', 8.0, 2.0)],
                &[3],
            ),
            ([8.0, 2.0], &[('r', 20.0, 2.0), ('g', 20.0, -9.0), ('r', 21.0, -9.0), ('g', 21.0, -12.0)], &[3]),
        ] {
            assert_eq!(told(start, elements), lines, "{elements:?}");
        }
    }
}
