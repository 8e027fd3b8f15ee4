//! Arcs and helices.
//!
//! # References
//! LinuxCNC, G2/G3: centre and radius form, turns P; its tolerances: in radius form half the chord may exceed R by 0.00005
//! inch, in centre form the radii at start and end may differ by 0.0283 mm or 0.1 % (the greater), and never by more than
//! 2.83 mm.

use std::f64::consts::{SQRT_2, TAU};

use crate::finding::Grade;
use crate::gcode::code::G;
use crate::gcode::control::Across;
use crate::gcode::interpreter::block::{AXES, letter};
use crate::gcode::interpreter::expression::whole;
use crate::gcode::interpreter::fault::{Fault, Outcome};
use crate::gcode::interpreter::{Interpreter, doubt};
use crate::gcode::motion::{Arc, MotionKind, Plane};
use crate::machine::axis::Pose;
use crate::machine::length_unit::LengthUnit;
use crate::number::{shown, trig};
use crate::text::Text;

/// Least radius, and what half the chord may exceed R by; mm.
const LEAST: f64 = 0.000_05 * 25.4;
/// Part of a radius by which the radii at start and end may differ.
const RELATIVE: f64 = 0.001;
/// A half chord this near to R makes a half circle.
const TINY: f64 = 1e-12;

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

impl Interpreter<'_> {
    /// An arc of the block in hand.
    pub(super) fn arc(&mut self, clockwise: bool) -> Outcome<()> {
        let plane = self.modal.plane;
        self.arc_form()?;
        let feed = self.feed()?;
        self.arc_letters()?;
        let turns = self.turns()?;
        self.modal.motion = G::Arc(clockwise);
        let (centre, to) = self.arc_centre(clockwise)?;
        let [a, b, c] = plane.axes();
        let turns = if clockwise { -turns } else { turns };
        let [x, y] = [self.current.get(a) - centre[0], self.current.get(b) - centre[1]];
        let [to_x, to_y] = [to.get(a) - centre[0], to.get(b) - centre[1]];
        let between = trig::atan2(x * to_y - y * to_x, x * to_x + y * to_y);
        let (radius, rotation) = ((x * x + y * y).sqrt(), self.frame.work.rotation);
        let arc = Arc { plane, centre, turns, radius, sweep: sweep(turns, between), rotation };
        let seconds = if self.by_revolution(feed) {
            self.turned_arc_seconds(&arc, feed)
        } else {
            self.seconds(arc.length(to.get(c) - self.current.get(c)), feed)
        };
        self.emit(MotionKind::Arc(arc, feed), to, seconds);
        Ok(())
    }

    /// The centre of the block's arc along the plane's first and second axis, and its end; the block's words are checked.
    pub(super) fn arc_geometry(&mut self, clockwise: bool) -> Outcome<([f64; 2], Pose)> {
        self.arc_form()?;
        self.arc_letters()?;
        self.arc_centre(clockwise)
    }

    /// Refuses an arc with neither a centre nor a radius, or with both.
    fn arc_form(&self) -> Outcome<()> {
        let centred = self.modal.plane.centre_letters().into_iter().any(|letter| self.block.has(letter));
        match (self.block.has(letter::R), centred) {
            (false, false) => Err(Fault::block(
                Text::fixed("arco sin centro (I J K) ni radio R", "arc without a centre (I J K) or radius R"),
                Text::fixed("dé el centro o el radio", "give the centre or the radius"),
            )),
            (true, true) => Err(Fault::at(
                &[self.block.column(letter::R)],
                Text::fixed("arco con centro y con radio R", "arc with a centre and with radius R"),
                Text::fixed("deje uno de los dos", "leave one of the two"),
            )),
            _ => Ok(()),
        }
    }

    /// Refuses a centre word of another plane, but for a 0 that comes to nothing whatever it means.
    fn arc_letters(&mut self) -> Outcome<()> {
        let plane = self.modal.plane;
        let [first, second, across] = plane.centre_letters();
        let Some(value) = self.block.get(across) else { return Ok(()) };
        let column = self.block.column(across);
        let (word, name) = (name(across), plane.name());
        let [_, _, axis] = plane.axes();
        let planar = self.end_point().get(axis) == self.current.get(axis);
        let refused = |what, remedy| Err(Fault::at(&[column], what, remedy));
        match self.control.arcs.across {
            Across::Pitch if value > 0.0 => refused(
                Text::new(
                    format!("{word} es en {name} el paso de una hélice, que no está implementado"),
                    format!("{word} is the pitch of a helix in {name}, which is not supported"),
                ),
                Text::new(
                    format!("escriba la hélice vuelta a vuelta, con su {} y sin {word}", axis.letter()),
                    format!("write the helix turn by turn, with its {} and without {word}", axis.letter()),
                ),
            ),
            Across::Pitch => refused(
                Text::new(
                    format!("{word}{value}: en {name} {word} es el paso de una hélice, mayor que 0 (error 0054)"),
                    format!("{word}{value}: {word} is the pitch of a helix in {name}, above 0 (error 0054)"),
                ),
                Text::new(format!("quite {word}"), format!("take {word} out")),
            ),
            Across::Unknown if value == 0.0 && planar => {
                let line = self.line;
                self.remarks.add(
                    Grade::Caution,
                    line,
                    Some(column),
                    Text::new(
                        format!(
                            "{word}0 en un arco de {name}: leído como si no estuviera; lo que hace el control no se ha \
                             podido consultar"
                        ),
                        format!(
                            "{word}0 in an arc of {name}: read as if it were not there; what the control does could not \
                             be looked up"
                        ),
                    ),
                    Text::new(format!("quite {word}"), format!("take {word} out")),
                );
                Ok(())
            }
            Across::Foreign | Across::Unknown => refused(
                Text::new(
                    format!("{word} no pertenece al plano {name}"),
                    format!("{word} does not belong to the plane {name}"),
                ),
                Text::new(
                    format!("use {} y {}, o cambie de plano", self::name(first), self::name(second)),
                    format!("use {} and {}, or change the plane", self::name(first), self::name(second)),
                ),
            ),
        }
    }

    fn arc_centre(&mut self, clockwise: bool) -> Outcome<([f64; 2], Pose)> {
        let plane = self.modal.plane;
        let to = self.end_point();
        let [a, b, _] = plane.axes();
        let [first, second, _] = plane.centre_letters();
        let start = [self.current.get(a), self.current.get(b)];
        let end = [to.get(a), to.get(b)];
        let centre = match self.block.get(letter::R) {
            Some(R) => {
                let named = [a, b].into_iter().any(|axis| self.block.has(AXES[axis as usize]));
                // U and W of a lathe stand for X and Z.
                let incremental =
                    self.control.axes.by_letters() && (self.block.has(letter::U) || self.block.has(letter::W));
                if !named && !incremental {
                    return Err(Fault::at(
                        &[self.block.column(letter::R)],
                        Text::new(
                            format!("arco con R sin {} ni {}", a.letter(), b.letter()),
                            format!("arc with R without {} or {}", a.letter(), b.letter()),
                        ),
                        Text::fixed("dé el punto final", "give the end point"),
                    ));
                }
                self.centre_by_radius(start, end, self.modal.unit.to_mm(R), clockwise)
            }
            None => self.centre_by_offsets(start, end, [first, second]),
        };
        let centre = centre.map_err(|fault| fault.hanging_on(doubt::axis(a) | doubt::axis(b) | doubt::MODES))?;
        Ok((centre, to))
    }

    /// P, the number of turns.
    fn turns(&self) -> Outcome<i32> {
        let Some(P) = self.block.get(letter::P) else { return Ok(1) };
        whole(P).filter(|&turns| turns >= 1).and_then(|turns| i32::try_from(turns).ok()).ok_or_else(|| {
            Fault::at(
                &[self.block.column(letter::P)],
                Text::new(format!("P{P} no es un número de vueltas"), format!("P{P} is no number of turns")),
                Text::fixed("P es un número entero de 1 en adelante", "P is a whole number from 1 on"),
            )
        })
    }

    fn centre_by_offsets(&self, start: [f64; 2], end: [f64; 2], letters: [usize; 2]) -> Outcome<[f64; 2]> {
        let unit = self.modal.unit;
        let mut centre = [0.0; 2];
        for (along, letter) in letters.into_iter().enumerate() {
            centre[along] = match (self.block.get(letter), self.modal.centre_absolute) {
                (Some(word), true) => unit.to_mm(word),
                (Some(word), false) => start[along] + unit.to_mm(word),
                (None, false) => start[along],
                (None, true) => {
                    return Err(Fault::block(
                        Text::new(
                            format!("falta {} en un arco de centro absoluto", name(letter)),
                            format!("{} is missing in an arc with absolute centre", name(letter)),
                        ),
                        Text::fixed("dé las dos coordenadas del centro", "give both coordinates of the centre"),
                    ));
                }
            };
        }
        let distance = |point: [f64; 2]| trig::hypot(point[0] - centre[0], point[1] - centre[1]);
        check_radii(distance(start), distance(end), unit).map(|()| centre)
    }

    /// The centre of an arc with a radius: to the left of the chord for a counter-clockwise arc up to half a circle.
    fn centre_by_radius(&self, start: [f64; 2], end: [f64; 2], R: f64, clockwise: bool) -> Outcome<[f64; 2]> {
        let chord = [end[0] - start[0], end[1] - start[1]];
        let half = (chord[0] * chord[0] + chord[1] * chord[1]).sqrt() / 2.0;
        let column = self.block.column(letter::R);
        let unit = self.modal.unit;
        let text = |value: f64| format!("{} {}", shown(unit.from_mm(value), 4), unit.symbol());
        let radius = R.abs();
        if half == 0.0 {
            return Err(Fault::at(
                &[column],
                Text::fixed("arco con R cuyo final es su principio", "arc with R that ends where it starts"),
                Text::fixed("programe el círculo con I, J o K", "program the circle with I, J or K"),
            ));
        }
        if half - radius > LEAST || radius == 0.0 {
            return Err(Fault::at(
                &[column],
                Text::new(
                    format!("radio {} demasiado pequeño: media cuerda {}", text(radius), text(half)),
                    format!("radius {} too small to reach the end: half the chord is {}", text(radius), text(half)),
                ),
                Text::new(format!("R de al menos {}", text(half)), format!("R of at least {}", text(half))),
            ));
        }
        let offset = if half / radius > 1.0 - TINY { 0.0 } else { (radius * radius - half * half).sqrt() };
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
fn check_radii(start: f64, end: f64, unit: LengthUnit) -> Outcome<()> {
    let tolerance = radii_tolerance(unit);
    let difference = (start - end).abs();
    let text = |value: f64| format!("{} {}", shown(unit.from_mm(value), 4), unit.symbol());
    if start < LEAST || end < LEAST {
        return Err(Fault::block(
            Text::new(
                format!("arco de radio cero: r1 {}, r2 {}", text(start), text(end)),
                format!("zero-radius arc: r1 {}, r2 {}", text(start), text(end)),
            ),
            Text::fixed("compruebe el centro", "check the centre"),
        ));
    }
    if difference > 100.0 * tolerance || (difference > tolerance && difference > RELATIVE * start.max(end)) {
        return Err(Fault::block(
            Text::new(
                format!(
                    "el final no está en el círculo: r1 {}, r2 {}, diferencia {}",
                    text(start),
                    text(end),
                    text(difference)
                ),
                format!(
                    "the end is not on the circle: r1 {}, r2 {}, difference {}",
                    text(start),
                    text(end),
                    text(difference)
                ),
            ),
            Text::fixed("compruebe el final y el centro", "check the end and the centre"),
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
