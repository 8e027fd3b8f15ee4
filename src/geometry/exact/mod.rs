//! Regions of a plane from which convex polygons are taken away, exactly.
//!
//! Every polygon that is taken away has its corners on one grid of nanometres. The region that is left never has its
//! corners rounded: it is held as the *lines* that bound it, each through two points of the grid, and its corners are
//! where these lines meet. Every question that an algorithm asks (on which side of a line is the corner where two other
//! lines meet, which of two directions comes first) is the sign of an integer expression that fits in 128 bits, so that
//! each answer is right. Corners in floating point are worked out from the lines only to be handed out.
//!
//! What follows from it: a region is exactly the set that was there less the sets taken away. Hence
//! - taking away the same polygon once more changes nothing, however often it is done;
//! - the order of two polygons makes no difference;
//! - nothing is ever added;
//! - lines that carry on one another are one edge, so that the number of edges depends on the shape alone and no
//!   simplification with a tolerance is needed: there is nothing that could grow from pass to pass.
//!
//! This is why no library of polygons does it. Those that are robust round each new corner onto a grid, and they go over all
//! of the contour at each cut: taken one by one, motions cost the more, the longer the contour has become, and all at once their
//! overlaps do. `benches/turning.rs` holds one, `i_overlay`, against this: 3.7 times the time at 1,000 motions that all cut,
//! 12 times at 20,000, with the same area to 10⁻⁹ mm². It repeats the removal of every program of some thousands of
//! cuts, and judges it in the tests: what is left is the same to 10⁻⁸ mm² after forty motions of a tool.
//!
//! The only errors are those of the polygons themselves: their corners are at most half a nanometre off in each
//! direction, and arcs are chords within a stated tolerance.

pub mod convex;
pub mod cut;
pub mod grid;
mod index;
pub mod meeting;
pub mod region;
