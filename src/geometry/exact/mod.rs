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
//! A library of polygons that is robust, as `i_overlay`, rounds each new corner onto a grid. It takes every program's polygons
//! away beside, and a program stops where what it leaves is another contour ([`crate::removal::turning::second_removal`]); what is handed out are
//! the corners of the lines, which nothing has rounded.
//!
//! The only errors are those of the polygons themselves: their corners are at most half a nanometre off in each
//! direction, and arcs are chords within a stated tolerance.

pub mod convex;
pub mod cut;
pub mod grid;
mod index;
pub mod meeting;
pub mod region;
