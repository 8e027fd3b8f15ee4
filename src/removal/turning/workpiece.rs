//! The part as it is at a moment, and what a cutter takes away from it.

use std::collections::BTreeSet;

use super::detached::Loose;
use super::second_removal::Repeat;
use crate::geometry::exact::convex::Convex;
use crate::geometry::exact::cut::CutEffect;
use crate::geometry::exact::grid::Point;
use crate::geometry::exact::meeting::{Meeting, Stretch};
use crate::geometry::exact::region::{Labelled, Region, Ring};
use crate::geometry::revolution::{frustum, volume};

/// A piece with less than this, in mm³, is a chip and no part that falls off.
pub const CHIP: f64 = 1.0;

/// The steps of one turn of a thread, wherever it is.
pub const TURN: usize = 16;
/// How many times as many steps a rib of a thread counts as another cut: the outline that it meets is made of ribs, and of the
/// tiles of the other library that it lies on every one has to be gone through. As measured.
const RIB: usize = 12;

/// What a cut took away.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Removed {
    /// Cut to chips, mm³.
    pub volume: f64,
    /// Cut off as pieces that are held no longer, mm³.
    pub parted: f64,
}

impl Removed {
    /// Adds what a further cut took away.
    pub fn add(&mut self, more: Self) {
        self.volume += more.volume;
        self.parted += more.parted;
    }
}

/// The part: the half of its section at r ≥ 0, turned about the axis.
#[derive(Debug, Default)]
pub struct Workpiece {
    region: Region,
    meeting: Meeting,
    /// A cut has come through, and what is loose has not fallen off yet.
    apart: bool,
    /// The piece that was parted off last.
    fallen: Vec<Labelled>,
    /// How many pieces were parted off.
    partings: usize,
    /// The labels of all else that fell off.
    gone: BTreeSet<u32>,
    /// Kept so as not to allocate for each cut.
    labels: Vec<u32>,
    repeat: Option<Repeat>,
    /// The steps of work done, and the most of them.
    work: u64,
    most: u64,
}

impl Clone for Workpiece {
    /// The part as it is; no library takes away the same beside.
    fn clone(&self) -> Self {
        let Self { region, fallen, gone, partings, .. } = self;
        let (region, fallen, gone, partings) = (region.clone(), fallen.clone(), gone.clone(), *partings);
        let (apart, work, most) = (self.apart, self.work, self.most);
        Self { region, fallen, gone, partings, apart, work, most, ..Self::default() }
    }
}

impl Workpiece {
    /// The part inside contours on the grid, counter-clockwise, holes clockwise; with the labels of their edges, see
    /// [`Region::labelled`]. `most` is how many steps of work it takes; from there on it stays as it is.
    #[must_use]
    pub fn new(rings: &[Vec<Point>], labels: &[Vec<u32>], most: u64) -> Self {
        Self { region: Region::labelled(rings, labels), most, ..Self::default() }
    }

    /// The steps of work done so far.
    #[must_use]
    pub const fn work(&self) -> u64 {
        self.work
    }

    /// True where there are no steps left: what has come since was not done.
    #[must_use]
    pub const fn is_spent(&self) -> bool {
        self.work > self.most
    }

    /// As [`Self::cut`], of a rib of a thread: it counts as more work, for the outline that it meets is made of ribs.
    pub fn cut_rib(&mut self, polygon: &Convex, seen: impl FnMut(&Meeting, bool, &mut [u32])) -> Removed {
        let before = self.work;
        let removed = self.cut(polygon, seen);
        let done = usize::try_from(self.work.saturating_sub(before)).unwrap_or(usize::MAX);
        self.spend(done.saturating_mul(RIB - 1));
        removed
    }

    /// Counts steps before they are done; false where they are too many to be done.
    pub fn spend(&mut self, steps: usize) -> bool {
        self.work = self.work.saturating_add(u64::try_from(steps).unwrap_or(u64::MAX));
        !self.is_spent()
    }

    /// Finds what a polygon and the part have in common, and counts what that took and what it takes to judge it, to cut it out
    /// and to repeat that: the edges looked at and the stretches found; both outlines against each other; and what goes over all
    /// of the contour, as the walk along it and the other library's tiles, sixteen edges to a step. False where they have nothing in common, or too few steps are left.
    fn find(&mut self, polygon: &Convex) -> bool {
        self.meeting.find(&self.region, polygon);
        let Meeting { looked, removed, inserted, .. } = &self.meeting;
        let found = removed.len() + inserted.len() + removed.len().saturating_mul(inserted.len());
        let all = if self.meeting.is_empty() { 0 } else { self.region.len() / 16 };
        self.spend((1 + looked + all).saturating_add(found)) && !self.meeting.is_empty()
    }

    /// Its contours, mm; see [`Region::rings`].
    #[must_use]
    pub fn rings(&self) -> Vec<Ring> {
        self.region.rings()
    }

    /// Its least and greatest `[z, r]`, mm; `None` where nothing is left.
    pub fn extent(&mut self) -> Option<([f64; 2], [f64; 2])> {
        self.spend(self.region.len());
        self.region.extent()
    }

    /// The volume of the part as a body of revolution, mm³.
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.region.rings().iter().map(|ring| volume(ring)).sum()
    }

    /// The same, with the labels of their edges.
    #[must_use]
    pub fn labelled_rings(&self) -> Vec<Labelled> {
        self.region.labelled_rings()
    }

    /// The contours of the piece that was parted off last, mm; none where nothing was. What fell off beside others, or as a core, is none.
    #[must_use]
    pub fn fallen(&self) -> &[Labelled] {
        &self.fallen
    }

    /// How many pieces were parted off.
    #[must_use]
    pub const fn partings(&self) -> usize {
        self.partings
    }

    /// From now on a library of polygons takes away the same beside.
    pub fn repeat(&mut self) {
        self.repeat = Some(Repeat::new(&self.region.rings()));
    }

    /// How far the library that takes the same away is from the contours, mm, as it stands now; see [`Repeat::apart`]. `None`
    /// where none does. It ends with this.
    pub fn repeated(&mut self) -> Option<f64> {
        self.repeat.take().map(|repeat| repeat.apart(&self.region.rings()))
    }

    /// The labels of what has fallen off but for [`Self::fallen`].
    pub fn gone(&self) -> impl Iterator<Item = u32> + '_ {
        self.gone.iter().copied()
    }

    /// How many edges its contours have.
    #[must_use]
    pub fn edges(&self) -> usize {
        self.region.len()
    }

    /// Shows what a polygon and the part have in common, on either side of the axis, and takes nothing away. What comes
    /// from the other side is shown as mirrored, with `true`.
    pub fn probe(&mut self, polygon: &Convex, mut seen: impl FnMut(&Meeting, bool)) {
        self.both_sides(polygon, |part, polygon, mirrored| {
            if part.find(polygon) {
                seen(&part.meeting, mirrored);
            }
        });
    }

    /// True where [`Self::cut`] would take something away.
    pub fn meets(&mut self, polygon: &Convex) -> bool {
        let mut met = false;
        self.both_sides(polygon, |part, polygon, _| {
            let through = polygon.through_axis();
            met |= part.find(through.as_ref().unwrap_or(polygon));
        });
        met
    }

    /// Takes away what a polygon covers while the part turns: both what lies on this side of the axis and what comes round
    /// from the other. What is held no longer stays until [`Self::drop_loose`]. What sees it may label the stretches inserted;
    /// they come without a label, 0.
    pub fn cut(&mut self, polygon: &Convex, mut seen: impl FnMut(&Meeting, bool, &mut [u32])) -> Removed {
        let mut removed = Removed::default();
        self.both_sides(polygon, |part, polygon, mirrored| {
            // A nose that faces down to the axis touches it with one corner: what it has gone round hangs together there
            // with no thickness at all, and is apart.
            let through = polygon.through_axis();
            let polygon = through.as_ref().unwrap_or(polygon);
            if !part.find(polygon) {
                return;
            }
            if let Some(repeat) = &part.repeat {
                repeat.cut(polygon);
            }
            part.labels.clear();
            part.labels.resize(part.meeting.inserted.len(), 0);
            seen(&part.meeting, mirrored, &mut part.labels);
            removed.volume += taken(&part.meeting);
            part.apart |= part.region.cut(polygon, &part.meeting, &part.labels) == CutEffect::Apart;
        });
        removed
    }

    /// Lets fall off what is held no longer: of several pieces the one that reaches farthest to the left, into the chuck,
    /// stays. Called once a cut is judged, for until it comes through the tool is beside both. `judged` says what a piece
    /// is by its contour.
    pub fn drop_loose(&mut self, judged: impl Fn(&Ring) -> Loose) -> Removed {
        let mut removed = Removed::default();
        if std::mem::take(&mut self.apart) && self.spend(self.region.len()) {
            let mut fallen = self.region.keep_first();
            let all: f64 = fallen.iter().map(|(ring, _)| volume(ring)).sum();
            if let Some(repeat) = self.repeat.as_ref().filter(|_| !fallen.is_empty()) {
                repeat.fell(fallen.iter().map(|(ring, _)| ring.clone()).collect());
            }
            // Holes run clockwise; they stay with the piece that they are in.
            fallen.retain(|(ring, _)| volume(ring) < 0.0 || judged(ring) != Loose::Nib);
            let pieces: f64 = fallen.iter().map(|(ring, _)| volume(ring)).sum();
            if pieces < CHIP {
                removed.volume += all;
            } else {
                removed.volume += all - pieces;
                removed.parted += pieces;
                let mut parts = fallen.iter().map(|(ring, _)| ring).filter(|ring| volume(ring) >= CHIP);
                let whole = parts.next().is_some_and(|ring| judged(ring) == Loose::Piece) && parts.next().is_none();
                self.partings += usize::from(whole);
                // A core or a ring that falls out later does not take the piece's place.
                let gone = if whole { std::mem::replace(&mut self.fallen, fallen) } else { fallen };
                self.gone.extend(gone.into_iter().flat_map(|(_, labels)| labels));
            }
        }
        removed
    }

    fn both_sides(&mut self, polygon: &Convex, mut act: impl FnMut(&mut Self, &Convex, bool)) {
        let (low, high) = polygon.extent();
        if self.is_spent() {
            return;
        }
        if high.r > 0 {
            act(self, polygon, false);
        }
        if low.r < 0 {
            act(self, &polygon.mirrored(), true);
        }
    }
}

/// The section of what a polygon takes away from the part where it meets it, mm².
#[must_use]
pub fn section(meeting: &Meeting) -> f64 {
    let below = |one: &Stretch| (one.from[0] - one.to[0]) * f64::midpoint(one.from[1], one.to[1]);
    meeting.removed.iter().map(below).sum::<f64>() - meeting.inserted.iter().map(|(one, _)| below(one)).sum::<f64>()
}

/// What a polygon takes away from the part where it meets it, mm³.
#[must_use]
pub fn taken(meeting: &Meeting) -> f64 {
    let outer: f64 = meeting.removed.iter().map(|one| frustum(one.from, one.to)).sum();
    let inner: f64 = meeting.inserted.iter().map(|(one, _)| frustum(one.from, one.to)).sum();
    outer - inner
}
