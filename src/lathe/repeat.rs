//! The removal of material repeated with a library of polygons, so that no part is handed over on the word of one kernel.
//!
//! `i_overlay` takes the same polygons away one by one on a grid of 64-bit integers, over the whole contour each time, which is
//! why it judges up to some thousands of cuts and does not work instead; see [`crate::geometry::exact`].

use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::single::SingleFloatOverlay;

use crate::geometry::exact::region::{Ring, twice_area};
use crate::number::trig::hypot;

/// Most cuts that are repeated: some tenths of a second.
pub const MOST: usize = 3_000;

/// How far two contours may be from each other on the average, mm: both round corners to far less.
pub const AGREE: f64 = 1e-6;

/// What is to be repeated.
#[derive(Clone, Debug, Default)]
pub struct Repeat {
    start: Vec<Ring>,
    /// `None` once there were too many.
    cuts: Option<Vec<Ring>>,
}

impl Repeat {
    /// From contours, `[z, r]` in mm, counter-clockwise, holes clockwise.
    #[must_use]
    pub const fn new(start: Vec<Ring>) -> Self {
        Self { start, cuts: Some(Vec::new()) }
    }

    /// Notes the corners of a polygon that was taken away, mm.
    pub fn note(&mut self, corners: impl Iterator<Item = [f64; 2]>) {
        if let Some(cuts) = self.cuts.as_mut().filter(|cuts| cuts.len() < MOST) {
            cuts.push(corners.collect());
        } else {
            self.cuts = None;
        }
    }

    /// How far what the library leaves is from the contours that are left, mm: the area of what is in one of them alone, by the
    /// length of the contours. Of what it leaves in pieces, the one that reaches farthest to the left counts, as pieces that are
    /// held no longer fall off. `None` where there were more than [`MOST`] cuts.
    #[must_use]
    pub fn apart(&self, left: &[Ring]) -> Option<f64> {
        let cuts = self.cuts.as_ref()?;
        let mut shapes = vec![self.start.clone()];
        for cut in cuts {
            shapes = shapes.overlay_as::<i64>(cut, OverlayRule::Difference, FillRule::NonZero);
        }
        let begins = |shape: &[Ring]| shape.iter().flatten().map(|point| point[0]).fold(f64::INFINITY, f64::min);
        let first = shapes.into_iter().min_by(|one, two| begins(one).total_cmp(&begins(two)));
        let other = first.unwrap_or_default().overlay_as::<i64>(&left.to_vec(), OverlayRule::Xor, FillRule::EvenOdd);
        let area = other.iter().flatten().map(|ring| twice_area(ring)).sum::<f64>().abs() / 2.0;
        let edges = left.iter().flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)));
        let length: f64 = edges.map(|(from, to)| hypot(to[0] - from[0], to[1] - from[1])).sum();
        Some(area / length.max(1.0))
    }
}
