//! The blank, how it is held, and what stands about it.
//!
//! # Coordinates
//! `[z, r]` in mm from the work zero W1, which lies on the axis at the blank's right end less the facing allowance.

use super::machine::{Lathe, Tailstock};
use super::rules::{StockBore, StockDiameter, StockFacing, StockLength, StockOverhang};
use crate::finding::{Finding, Limit, Place, Raise};
use crate::geometry::exact::region::Ring;
use crate::limits::STOCK_SIZE;
use crate::number::shown;
use crate::number::trig::tan;

/// Whether the tailstock supports the blank.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Support {
    /// Where the overhang asks for it.
    #[default]
    ByOverhang,
    /// In any case.
    Always,
    /// In no case.
    Never,
}

/// A round blank in the chuck, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stock {
    /// D: the diameter of the bar.
    pub diameter: f64,
    /// L: the length of the bar, with what is clamped and what is faced off.
    pub length: f64,
    /// The diameter of its bore; 0 for a solid bar.
    pub bore: f64,
    /// L3: how far it stands out of the jaws. The rest, L4, is clamped.
    pub overhang: f64,
    /// L5: what is to be faced off its right end; the work zero W1 lies that far inside.
    pub facing: f64,
    /// When the tailstock supports it.
    pub support: Support,
}

impl Stock {
    /// A solid bar with a fifth of its length clamped, nothing to face off, and the tailstock where it is needed.
    #[must_use]
    pub const fn bar(diameter: f64, length: f64) -> Self {
        Self { diameter, length, bore: 0.0, overhang: length * 0.8, facing: 0.0, support: Support::ByOverhang }
    }

    /// Everything about the blank that cannot be, each with the remedy.
    #[must_use]
    pub fn faults(&self) -> Vec<Finding> {
        let Self { diameter, length, bore, overhang, facing, .. } = *self;
        let within = |value: f64, low: f64, high: f64| value > low && value <= high;
        let told = |row: &dyn Raise, value: f64, most: f64| {
            let told =
                row.at(Place::File).with(format!("{} mm", shown(value, 3)), format!("0 – {} mm", shown(most, 3)));
            told.measuring(value, Limit::Between { least: Some(0.0), most: Some(most) })
        };
        let mut found = Vec::new();
        if !within(diameter, 0.0, STOCK_SIZE) {
            found.push(told(&StockDiameter {}, diameter, STOCK_SIZE));
        }
        if !within(length, 0.0, STOCK_SIZE) {
            found.push(told(&StockLength {}, length, STOCK_SIZE));
        }
        if !(bore >= 0.0 && bore < diameter) {
            found.push(told(&StockBore {}, bore, diameter));
        }
        if !within(overhang, 0.0, length) {
            found.push(told(&StockOverhang {}, overhang, length));
        }
        if !(facing >= 0.0 && facing < overhang) {
            found.push(told(&StockFacing {}, facing, overhang));
        }
        found
    }

    /// Where W1 (G54) is in machine coordinates along Z, mm; it is on the axis. The other five zeros are the user's.
    #[must_use]
    pub fn zero(&self, lathe: &Lathe) -> f64 {
        lathe.chuck.body + lathe.chuck.jaws + self.overhang - self.facing
    }

    /// The blank's left and right end.
    #[must_use]
    pub fn ends(&self) -> [f64; 2] {
        [self.facing - self.length, self.facing]
    }

    /// Whether the tailstock supports the blank: by the overhang where L3 is more than 3 diameters, or as many as the lathe
    /// says.
    #[must_use]
    pub fn supported(&self, lathe: &Lathe) -> bool {
        match self.support {
            Support::ByOverhang => self.overhang > lathe.tailstock.beyond * self.diameter,
            Support::Always => true,
            Support::Never => false,
        }
    }

    /// The blank's half section, counter-clockwise.
    #[must_use]
    pub fn contour(&self) -> Ring {
        let ([left, right], low, high) = (self.ends(), self.bore / 2.0, self.diameter / 2.0);
        vec![[left, low], [right, low], [right, high], [left, high]]
    }

    /// Between which Z the jaws hold: along their length, or along L4 where they have none.
    #[must_use]
    pub fn held(&self, lathe: &Lathe) -> [f64; 2] {
        let face = self.facing - self.overhang;
        let long = if lathe.chuck.jaws > 0.0 { lathe.chuck.jaws } else { self.length - self.overhang };
        [face - long, face]
    }

    /// How the jaws hold a part, contours from W1: they close on the greatest diameter of what lies between them, and hold it
    /// where the contour is within 0.02 mm of it. `None` where no metal lies between them.
    #[must_use]
    pub fn grip(&self, lathe: &Lathe, part: &[Ring]) -> Option<Grip> {
        let [left, right] = self.held(lathe);
        // What of each edge lies between the jaws.
        let edges: Vec<[[f64; 2]; 2]> = part
            .iter()
            .flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)))
            .filter_map(|(&from, &to)| within([from, to], 0, left, right))
            .collect();
        let top = edges.iter().flatten().map(|point| point[1]).fold(0.0, f64::max);
        let along =
            |edge: [[f64; 2]; 2]| within(edge, 1, top - FLAT, top).map_or(0.0, |[from, to]| (to[0] - from[0]).abs());
        (top > 0.0).then(|| Grip { diameter: 2.0 * top, length: edges.into_iter().map(along).sum() })
    }

    /// What stands still about the work, as convex polygons of `[z, r]`: body of the chuck, jaws closed on a diameter, and
    /// the quill where it supports the blank.
    #[must_use]
    pub fn fixtures(&self, lathe: &Lathe, gripped: f64) -> Vec<(Fixture, Ring)> {
        let (chuck, work) = (&lathe.chuck, gripped / 2.0);
        let face = self.facing - self.overhang;
        let front = face - chuck.jaws;
        let boxed = |z: [f64; 2], r: [f64; 2]| vec![[z[0], r[0]], [z[1], r[0]], [z[1], r[1]], [z[0], r[1]]];
        let half = chuck.diameter / 2.0;
        let mut fixtures = vec![(Fixture::Chuck, boxed([front - chuck.body, front], [-half, half]))];
        if chuck.jaws > 0.0 {
            let top = work + chuck.jaw_height;
            // A jaw comes round on both sides of the axis.
            fixtures.push((Fixture::Jaws, boxed([front, face], [work, top])));
            fixtures.push((Fixture::Jaws, boxed([front, face], [-top, -work])));
        }
        if self.supported(lathe) {
            fixtures.push((Fixture::Tailstock, quill(&lathe.tailstock, self.facing)));
        }
        fixtures
    }
}

/// How the jaws hold a part, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grip {
    /// The diameter that they close on.
    pub diameter: f64,
    /// How much of their length they hold it along.
    pub length: f64,
}

/// How far below the greatest diameter, in radius, the jaws still hold, mm: what jaws and part give way.
const FLAT: f64 = 0.02;

/// The part of an edge on which one of its coordinates is within bounds; `None` where there is none.
fn within([from, to]: [[f64; 2]; 2], axis: usize, low: f64, high: f64) -> Option<[[f64; 2]; 2]> {
    let step = to[axis] - from[axis];
    if step == 0.0 {
        return (from[axis] >= low && from[axis] <= high).then_some([from, to]);
    }
    let [one, two] = [low, high].map(|bound| (bound - from[axis]) / step);
    let (start, end) = (one.min(two).max(0.0), one.max(two).min(1.0));
    (start <= end).then(|| [start, end].map(|part| [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * part)))
}

/// What stands still about the work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fixture {
    /// The body of the chuck, without its jaws.
    Chuck,
    /// The jaws, closed on the part.
    Jaws,
    /// The quill of the tailstock with its centre.
    Tailstock,
}

/// A part, of a bar the piece that was parted off, turned about for its second set-up: mirrored along Z about the middle of
/// the original blank, then shifted; the work zeros stay. Contours counter-clockwise, holes clockwise, as the removal gives them and takes them.
#[must_use]
pub fn turned_about(rings: &[Ring], stock: &Stock, shift: f64) -> Vec<Ring> {
    let [left, right] = stock.ends();
    let image = |&[z, r]: &[f64; 2]| [left + right - z + shift, r];
    rings.iter().map(|ring| ring.iter().rev().map(image).collect()).collect()
}

/// The corners of the quill with its centre in the work's end at a z, mm.
fn quill(tailstock: &Tailstock, end: f64) -> Vec<[f64; 2]> {
    let (tip, radius) = (end - tailstock.depth, tailstock.diameter / 2.0);
    let cone = radius / tan(30_f64.to_radians());
    let back = tip + tailstock.length.max(cone + 1.0);
    vec![[tip, 0.0], [tip + cone, radius], [back, radius], [back, -radius], [tip + cone, -radius]]
}
