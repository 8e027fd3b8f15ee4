//! The contour that a turning cycle works to, as its blocks describe it.

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
