//! Arcs and helices.
//!
//! # References
//! LinuxCNC, G2/G3: centre and radius form, turns P; its tolerances: in radius form half the chord may exceed R by 0.00005
//! inch, in centre form the radii at start and end may differ by 0.0283 mm or 0.1 % (the greater), and never by more than
//! 2.83 mm.

use std::f64::consts::{SQRT_2, TAU};

use crate::finding::Size;
use crate::gcode::code::G;
use crate::gcode::control::{Across, Radii};
use crate::gcode::interpreter::block::{AXES, letter};
use crate::gcode::interpreter::expression::whole;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::interpreter::{Reader, doubt};
use crate::gcode::motion::{Arc, MotionKind, Plane};
use crate::gcode::rules::geometry::{
    AbsoluteCentreHalf, ArcOfAnotherPlane, ArcOfNoRadius, ArcTwoForms, ArcWithoutCentre, CentreWordForeign,
    CentreWordOfOtherPlane, EndOffCircle, HelixPitch, HelixPitchNotPositive, RadiiDiffer, RadiusNegative,
    RadiusOfFullCircle, RadiusOfHalfCircle, RadiusTooSmall, RadiusWithoutEnd, TurnsNotWhole,
};
use crate::machine::axis::{Axis, Pose};
use crate::machine::length_unit::LengthUnit;
use crate::number::trig;

/// Least radius, and what half the chord may exceed R by; mm.
const LEAST: f64 = 0.000_05 * 25.4;
/// Part of a radius by which the radii at start and end may differ.
const RELATIVE: f64 = 0.001;
/// A half chord this near to R makes a half circle.
const TINY: f64 = 1e-12;
/// More than this, mm, is told where the control's own limit is not known.
const TOLD: f64 = 0.01;

impl Plane {
    /// The letters of the centre along the first and second axis, and the one across.
    const fn centre_letters(self) -> [usize; 3] {
        match self {
            Self::XY => [letter::I, letter::J, letter::K],
            Self::ZX => [letter::K, letter::I, letter::J],
            Self::YZ => [letter::J, letter::K, letter::I],
        }
    }
}

fn name(letter: usize) -> char {
    char::from(b'A' + u8::try_from(letter).unwrap_or(0))
}

impl Reader<'_, '_> {
    /// An arc of the block in hand.
    pub(super) fn arc(&mut self, clockwise: bool) -> Result<()> {
        let plane = self.state.modal.plane;
        self.arc_form()?;
        let feed = self.feed()?;
        self.arc_letters()?;
        let turns = self.turns()?;
        self.state.modal.motion = G::Arc(clockwise);
        let (centre, to) = self.arc_centre(clockwise)?;
        let [a, b, c] = plane.axes();
        let turns = if clockwise { -turns } else { turns };
        let [x, y] = [self.state.at.get(a) - centre[0], self.state.at.get(b) - centre[1]];
        let [to_x, to_y] = [to.get(a) - centre[0], to.get(b) - centre[1]];
        let between = trig::atan2(x * to_y - y * to_x, x * to_x + y * to_y);
        let (radius, rotation) = ((x * x + y * y).sqrt(), self.state.frame.work.rotation);
        let arc = Arc { plane, centre, turns, radius, sweep: sweep(turns, between), rotation };
        let seconds = if self.by_revolution(feed) {
            self.turned_arc_seconds(&arc, feed)
        } else {
            self.seconds(arc.length(to.get(c) - self.state.at.get(c)), feed)
        };
        self.emit(MotionKind::Arc(arc, feed), to, seconds);
        Ok(())
    }

    /// The centre of the block's arc along the plane's first and second axis, and its end; the block's words are checked.
    pub(super) fn arc_geometry(&mut self, clockwise: bool) -> Result<([f64; 2], Pose)> {
        self.arc_form()?;
        self.arc_letters()?;
        self.arc_centre(clockwise)
    }

    /// Refuses an arc with neither a centre nor a radius, or with both.
    fn arc_form(&self) -> Result<()> {
        let centred = self.state.modal.plane.centre_letters().into_iter().any(|letter| self.block.has(letter));
        match (self.block.has(letter::R), centred) {
            (false, false) => Err(Refused::of(&ArcWithoutCentre {}, &[])),
            (true, true) => Err(Refused::of(&ArcTwoForms {}, &[self.block.column(letter::R)])),
            _ => Ok(()),
        }
    }

    /// Refuses a centre word of another plane, but for a 0 that comes to nothing whatever it means.
    fn arc_letters(&mut self) -> Result<()> {
        let plane = self.state.modal.plane;
        let [first, second, across] = plane.centre_letters();
        let Some(value) = self.block.get(across) else { return Ok(()) };
        let column = self.block.column(across);
        let (word, name) = (name(across), plane.name());
        let [_, _, axis] = plane.axes();
        let planar = self.end_point().get(axis) == self.state.at.get(axis);
        let foreign = CentreWordForeign { word, plane: name, first: self::name(first), second: self::name(second) };
        // An arc in the plane of this letter and one of the others: its block says both of its axes, and neither axis nor centre of the
        // third.
        let says = |axis: Axis, letter: usize| self.block.has(AXES[axis as usize]) || self.block.has(letter);
        let [one, other, _] = plane.axes();
        let of_another = self.block.has(AXES[axis as usize]) && !(says(one, first) && says(other, second));
        if of_another {
            return Err(Refused::of(&foreign, &[column]));
        }
        match self.memory.control.arcs.across {
            Across::Pitch if value > 0.0 => {
                Err(Refused::of(&HelixPitch { word, plane: name, axis: axis.letter() }, &[column]))
            }
            Across::Pitch => Err(Refused::of(&HelixPitchNotPositive { word, value, plane: name }, &[column])),
            Across::Unknown if value == 0.0 && planar => {
                let spot = self.block.spot;
                self.memory.remarks.row(&CentreWordOfOtherPlane { word, plane: name }, spot, Some(column));
                Ok(())
            }
            Across::Foreign | Across::Unknown => Err(Refused::of(&foreign, &[column])),
        }
    }

    /// Remarks an arc with a radius whose block says the axis across the plane, and not both of the plane's, out of G17.
    fn see_plane(&mut self, to: &Pose) {
        let plane = self.state.modal.plane;
        let [a, b, across] = plane.axes();
        let said = |axis: Axis| self.block.has(AXES[axis as usize]);
        let Some(missing) = [a, b].into_iter().find(|axis| !said(*axis)) else { return };
        let helix = said(across) && to.get(across) != self.state.at.get(across);
        if helix && plane != Plane::XY && !self.memory.control.turns() && !self.in_doubt(doubt::PLANE) {
            let row = ArcOfAnotherPlane { plane: plane.name(), axis: across.letter(), missing: missing.letter() };
            self.memory.remarks.row(&row, self.block.spot, Some(self.block.column(AXES[across as usize])));
        }
    }

    fn arc_centre(&mut self, clockwise: bool) -> Result<([f64; 2], Pose)> {
        let plane = self.state.modal.plane;
        let to = self.end_point();
        let [a, b, _] = plane.axes();
        let [first, second, _] = plane.centre_letters();
        let start = [self.state.at.get(a), self.state.at.get(b)];
        let end = [to.get(a), to.get(b)];
        let centre = match self.block.get(letter::R) {
            Some(R) => {
                if R < 0.0 && self.memory.control.arcs.negative.refused() {
                    return Err(Refused::of(&RadiusNegative { radius: R }, &[self.block.column(letter::R)]));
                }
                let named = [a, b].into_iter().any(|axis| self.block.has(AXES[axis as usize]));
                // U and W of a lathe stand for X and Z.
                let incremental =
                    self.memory.control.axes.by_letters() && (self.block.has(letter::U) || self.block.has(letter::W));
                if !named && !incremental {
                    return Err(Refused::of(
                        &RadiusWithoutEnd { first: a.letter(), second: b.letter() },
                        &[self.block.column(letter::R)],
                    ));
                }
                self.see_plane(&to);
                self.centre_by_radius(start, end, self.state.modal.unit.to_mm(R), clockwise)
            }
            None => self.centre_by_offsets(start, end, [first, second]),
        };
        let centre = centre.map_err(|fault| fault.hanging_on(doubt::axis(a) | doubt::axis(b) | doubt::MODES))?;
        Ok((centre, to))
    }

    /// P, the number of turns.
    fn turns(&self) -> Result<i32> {
        let Some(P) = self.block.get(letter::P) else { return Ok(1) };
        whole(P)
            .filter(|&turns| turns >= 1)
            .and_then(|turns| i32::try_from(turns).ok())
            .ok_or_else(|| Refused::of(&TurnsNotWhole { turns: P }, &[self.block.column(letter::P)]))
    }

    fn centre_by_offsets(&mut self, start: [f64; 2], end: [f64; 2], letters: [usize; 2]) -> Result<[f64; 2]> {
        let unit = self.state.modal.unit;
        let mut centre = [0.0; 2];
        for (along, letter) in letters.into_iter().enumerate() {
            centre[along] = match (self.block.get(letter), self.state.modal.centre_absolute) {
                (Some(word), true) => unit.to_mm(word),
                (Some(word), false) => start[along] + unit.to_mm(word),
                (None, false) => start[along],
                (None, true) => {
                    return Err(Refused::of(&AbsoluteCentreHalf { word: name(letter) }, &[]));
                }
            };
        }
        let distance = |point: [f64; 2]| trig::hypot(point[0] - centre[0], point[1] - centre[1]);
        let radii = [distance(start), distance(end)];
        check_radii(radii[0], radii[1], unit)?;
        let difference = (radii[0] - radii[1]).abs();
        match self.memory.control.arcs.radii {
            Radii::Parameter if difference > TOLD => {
                self.memory.remarks.row(&RadiiDiffer { difference: unit.size(difference) }, self.block.spot, None);
            }
            Radii::Parameter | Radii::LinuxCnc => {}
        }
        Ok(centre)
    }

    /// The centre of an arc with a radius: to the left of the chord for a counter-clockwise arc up to half a circle.
    fn centre_by_radius(&self, start: [f64; 2], end: [f64; 2], R: f64, clockwise: bool) -> Result<[f64; 2]> {
        let chord = [end[0] - start[0], end[1] - start[1]];
        let half = (chord[0] * chord[0] + chord[1] * chord[1]).sqrt() / 2.0;
        let column = self.block.column(letter::R);
        let unit = self.state.modal.unit;
        let radius = R.abs();
        if half == 0.0 {
            return Err(Refused::of(&RadiusOfFullCircle {}, &[column]));
        }
        if half - radius > LEAST || radius == 0.0 {
            let [radius, half] = [radius, half].map(|length| unit.size(length));
            // Not every control takes a half circle: the next that a program can say is more than one.
            let thousandths = half.value * 1000.0;
            let more = self.memory.control.arcs.negative.refused();
            let least = if more { thousandths.floor() + 1.0 } else { (thousandths - 1e-6).ceil() };
            let least = Size { value: least / 1000.0, ..half };
            return Err(Refused::of(&RadiusTooSmall { radius, half, least }, &[column]));
        }
        let half_circle = half / radius > 1.0 - TINY;
        if half_circle && self.memory.control.arcs.negative.refused() {
            return Err(Refused::of(&RadiusOfHalfCircle { radius: unit.from_mm(R) }, &[column]));
        }
        let offset = if half_circle { 0.0 } else { (radius * radius - half * half).sqrt() };
        let side = if clockwise == (R > 0.0) { -offset } else { offset };
        let scale = side / (2.0 * half);
        Ok([f64::midpoint(start[0], end[0]) - chord[1] * scale, f64::midpoint(start[1], end[1]) + chord[0] * scale])
    }
}

/// By how much the radii of an arc at its start and its end may differ whatever its size, in the unit whose tolerance
/// counts; mm.
#[must_use]
pub const fn radii_tolerance(unit: LengthUnit) -> f64 {
    match unit {
        LengthUnit::Inch => 2.0 * 0.001 * SQRT_2 * 25.4,
        LengthUnit::Millimetre => 2.0 * 0.01 * SQRT_2,
    }
}

/// LinuxCNC's rule for the radii at start and end of an arc with a centre; mm, in the unit whose tolerance counts.
///
/// # Errors
/// With both radii and their difference.
fn check_radii(start: f64, end: f64, unit: LengthUnit) -> Result<()> {
    let tolerance = radii_tolerance(unit);
    let difference = (start - end).abs();
    if start < LEAST || end < LEAST {
        return Err(Refused::of(&ArcOfNoRadius { start: unit.size(start), end: unit.size(end) }, &[]));
    }
    if difference > 100.0 * tolerance || (difference > tolerance && difference > RELATIVE * start.max(end)) {
        return Err(Refused::of(
            &EndOffCircle { start: unit.size(start), end: unit.size(end), difference: unit.size(difference) },
            &[],
        ));
    }
    Ok(())
}

/// The angle that an arc of some turns sweeps, positive counter-clockwise, from the angle between the directions of its
/// start and its end, −π to π; radians.
pub(super) fn sweep(turns: i32, between: f64) -> f64 {
    let whole = f64::from(turns.abs() - 1) * TAU;
    // An arc whose end is its start is a full circle. A hair of rounding must not make it none.
    if turns > 0 {
        (if between <= 1e-12 { between + TAU } else { between }) + whole
    } else {
        (if between >= -1e-12 { between - TAU } else { between }) - whole
    }
}
