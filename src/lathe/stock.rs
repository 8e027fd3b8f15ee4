//! The blank, how it is held, and where the work zeros are.

use super::machine::{Lathe, Tailstock};
use crate::finding::{Finding, Place};
use crate::geometry::exact::grid::Point;
use crate::geometry::exact::region::Ring;
use crate::number::shown;
use crate::number::trig::tan;
use crate::text::Text;

/// A round blank in the chuck, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stock {
    /// D: its diameter.
    pub diameter: f64,
    /// L: its length.
    pub length: f64,
    /// The diameter of its bore; 0 for a solid bar.
    pub bore: f64,
    /// L3: how far it stands out of the jaws. The rest, L4, is clamped.
    pub overhang: f64,
    /// L5: what is to be faced off its right end; the work zero W1 lies that far inside.
    pub facing: f64,
}

/// The greatest length along either axis: half the grid, so that tools fit beside the part.
const MOST: f64 = 500.0;

impl Stock {
    /// A solid bar with a fifth of its length clamped and 1 mm to face off.
    #[must_use]
    pub fn bar(diameter: f64, length: f64) -> Self {
        Self { diameter, length, bore: 0.0, overhang: length * 0.8, facing: 1.0 }
    }

    /// Everything about the blank that cannot be, each with the remedy.
    #[must_use]
    pub fn faults(&self) -> Vec<Finding> {
        let mut faults = Vec::new();
        let mut ask = |fine: bool, es: &'static str, en: &'static str, value: f64, limit: String| {
            if !fine {
                let remedy = Text::fixed("cambie las medidas de la pieza en bruto", "change the sizes of the blank");
                let value = format!("{} mm", shown(value, 3));
                faults.push(Finding::stop(Place::File, Text::fixed(es, en), remedy).with(value, limit));
            }
        };
        let Self { diameter, length, bore, overhang, facing } = *self;
        let within = |value: f64, low: f64, high: f64| value > low && value <= high;
        ask(
            within(diameter, 0.0, MOST),
            "el diámetro D de la pieza en bruto no es posible",
            "the blank's diameter D is not possible",
            diameter,
            format!("0 < D ≤ {MOST} mm"),
        );
        ask(
            within(length, 0.0, MOST),
            "la longitud L de la pieza en bruto no es posible",
            "the blank's length L is not possible",
            length,
            format!("0 < L ≤ {MOST} mm"),
        );
        ask(
            (0.0..diameter).contains(&bore),
            "el agujero de la pieza en bruto no es posible",
            "the blank's bore is not possible",
            bore,
            format!("0 ≤ d < {} mm", shown(diameter, 3)),
        );
        ask(
            within(overhang, 0.0, length),
            "el voladizo L3 no es posible",
            "the overhang L3 is not possible",
            overhang,
            format!("0 < L3 ≤ {} mm", shown(length, 3)),
        );
        ask(
            (0.0..overhang).contains(&facing),
            "el refrentado L5 no es posible",
            "the facing allowance L5 is not possible",
            facing,
            format!("0 ≤ L5 < {} mm", shown(overhang, 3)),
        );
        faults
    }

    /// Where the blank's left and right end are in machine coordinates, mm: it stands out of the jaws by L3.
    #[must_use]
    pub fn ends(&self, lathe: &Lathe) -> [f64; 2] {
        let right = lathe.chuck.body + lathe.chuck.jaws + self.overhang;
        [right - self.length, right]
    }

    /// The work zero W1 (G54) in machine coordinates along Z, mm; it is on the axis. The other five are the user's.
    #[must_use]
    pub fn zero(&self, lathe: &Lathe) -> f64 {
        self.ends(lathe)[1] - self.facing
    }

    /// Whether the tailstock supports the blank: where L3 is more than 3 diameters, or as many as the lathe says.
    #[must_use]
    pub fn supported(&self, lathe: &Lathe) -> bool {
        self.overhang > lathe.tailstock.beyond * self.diameter
    }

    /// The blank's half section in machine coordinates, counter-clockwise, `[z, r]` mm.
    #[must_use]
    pub fn contour(&self, lathe: &Lathe) -> Ring {
        let ([left, right], low, high) = (self.ends(lathe), self.bore / 2.0, self.diameter / 2.0);
        vec![[left, low], [right, low], [right, high], [left, high]]
    }
}

/// A part turned about for its second set-up: mirrored along Z about the middle of the original blank, then shifted; the
/// work zeros stay. Contours as [`Stock::contour`] and the removal give them, counter-clockwise again.
#[must_use]
pub fn turned_about(rings: &[Ring], stock: &Stock, lathe: &Lathe, shift: f64) -> Vec<Ring> {
    let [left, right] = stock.ends(lathe);
    let image = |&[z, r]: &[f64; 2]| [left + right - z + shift, r];
    rings.iter().map(|ring| ring.iter().rev().map(image).collect()).collect()
}

/// Rings on the grid; `None` where one leaves it.
pub(super) fn on_grid(rings: &[Ring]) -> Option<Vec<Vec<Point>>> {
    rings.iter().map(|ring| ring.iter().map(|&point| Point::near(point)).collect()).collect()
}

/// The corners of the quill with its centre in the work's end at a z, mm.
pub(super) fn quill(tailstock: &Tailstock, end: f64) -> Vec<[f64; 2]> {
    let (tip, radius) = (end - tailstock.depth, tailstock.diameter / 2.0);
    let cone = radius / tan(30_f64.to_radians());
    let back = tip + tailstock.length.max(cone + 1.0);
    vec![[tip, 0.0], [tip + cone, radius], [back, radius], [back, -radius], [tip + cone, -radius]]
}
