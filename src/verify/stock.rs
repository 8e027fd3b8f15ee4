//! Clearance to the stock where the tool does not cut: at the safe points, while it crosses from one side to the other,
//! and in rapid moves.
//!
//! The tool is a cylinder of its diameter and length; its holder and what holds the part are not known here. The stock
//! is the turned blank before anything is milled. It is a body of revolution about the axis of C, so that C does not
//! matter. The distance of the tool from it is the least of points over end, rim and side of the tool, then sought down
//! to its minimum. Along a move it changes by no more than the way W of the farthest point, so that after a distance c
//! nothing nearer than the least known one can come within (c − least)/W of the move: steps of that length, and a
//! twentieth of the safety distance more, miss the true least by less than that twentieth.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::TAU;

use crate::gcode::program::Program;
use crate::impeller::design::Design;
use crate::impeller::solids::Stock;
use crate::machine::axis::{Axis, Pose};
use crate::number::shown;
use crate::number::trig::{hypot, sin_cos};
use crate::text::Text;
use crate::verify::check::{At, Check, Verdict, mm};
use crate::verify::step::{Judge, Step};
use crate::verify::tip_path::between;

/// By what part of the safety distance the least clearance of a move may be missed.
pub const FINE: f64 = 0.05;

/// Directions about the tool and heights along it that are looked at first.
const DIRECTIONS: u8 = 24;
const HEIGHTS: [f64; 9] = [0.0, 0.01, 0.03, 0.06, 0.12, 0.25, 0.45, 0.7, 1.0];

/// The tool and the stock on a machine.
#[derive(Clone, Copy, Debug)]
pub struct Room {
    stock: Stock,
    L: f64,
    radius: f64,
    length: f64,
    fine: f64,
}

impl Room {
    /// The room of a design.
    #[must_use]
    pub const fn new(design: &Design) -> Self {
        Self {
            stock: Stock { torus: design.torus, length: design.blank.L_b },
            L: design.machine.L,
            radius: design.d_t / 2.0,
            length: design.tool_reach(),
            fine: design.d_s * FINE,
        }
    }

    /// The distance of the tool from the stock; negative where they meet.
    #[must_use]
    pub fn distance(&self, pose: &Pose) -> f64 {
        let (sin_B, cos_B) = sin_cos(pose.get(Axis::B).to_radians());
        let [x, y, z] = [Axis::X, Axis::Y, Axis::Z].map(|axis| pose.get(axis));
        // A point of the tool by direction, part of the radius and height, in the part but for the turn of C.
        let at = |angle: f64, part: f64, height: f64| {
            let (sin, cos) = sin_cos(angle);
            let (x, y) = (x + self.radius * part * cos, y + self.radius * part * sin);
            let z = z + self.L + self.length * height;
            self.stock.distance(
                {
                    let out = x * cos_B + z * sin_B;
                    (out * out + y * y).sqrt()
                },
                z * cos_B - x * sin_B - self.L,
            )
        };
        let mut best = (f64::INFINITY, [0.0, 0.0, 0.0]);
        let mut take = |point: [f64; 3]| {
            let distance = at(point[0], point[1], point[2]);
            if distance < best.0 {
                best = (distance, point);
            }
        };
        take([0.0, 0.0, 0.0]);
        for direction in 0..DIRECTIONS {
            let angle = TAU * f64::from(direction) / f64::from(DIRECTIONS);
            take([angle, 0.5, 0.0]);
            for height in HEIGHTS {
                take([angle, 1.0, height]);
            }
        }
        // Down to the minimum about the nearest point, one after the other in each of its three coordinates.
        let mut steps = [TAU / f64::from(DIRECTIONS), 0.25, best.1[2].max(0.02) * 0.5];
        for _ in 0..12 {
            for coordinate in 0..3 {
                for sign in [1.0, -1.0] {
                    let mut point = best.1;
                    point[coordinate] += sign * steps[coordinate];
                    point[1] = point[1].clamp(0.0, 1.0);
                    point[2] = point[2].clamp(0.0, 1.0);
                    // Only the end has points inside the radius.
                    let on_tool = point[2] <= 0.0 || point[1] >= 1.0;
                    let distance = at(point[0], point[1], point[2]);
                    if on_tool && distance < best.0 {
                        best = (distance, point);
                    }
                }
            }
            steps = steps.map(|step| step * 0.5);
        }
        best.0
    }

    /// The least distance along a straight move of all axes.
    #[must_use]
    pub fn least(&self, from: &Pose, to: &Pose) -> f64 {
        let by = to.differences(from);
        let linear = hypot(hypot(by[Axis::X as usize], by[Axis::Y as usize]), by[Axis::Z as usize]);
        let way = linear + by[Axis::B as usize].to_radians().abs() * self.stock.reach(self.L);
        let mut least = self.distance(from).min(self.distance(to));
        let mut fraction = 0.0;
        while way > 0.0 && fraction < 1.0 {
            let here = self.distance(&between(from, to, fraction));
            least = least.min(here);
            fraction += (here - least + self.fine) / way;
        }
        least
    }
}

/// A move without C, and its least distance.
type Known = ([f64; 8], f64);

/// Watches the moves outside the part. Moves that differ in C alone are judged once, over all programs.
#[derive(Debug)]
pub struct Clear<'a> {
    room: Room,
    d_s: f64,
    known: &'a mut Vec<Known>,
    safe: Option<(f64, At)>,
    moves: Option<(f64, At)>,
}

impl<'a> Clear<'a> {
    /// The judge of a design's programs, with what is known from other programs.
    #[must_use]
    pub const fn new(design: &Design, known: &'a mut Vec<Known>) -> Self {
        Self { room: Room::new(design), d_s: design.d_s, known, safe: None, moves: None }
    }

    fn distance(&mut self, from: &Pose, to: &Pose) -> f64 {
        let mut key = [0.0; 8];
        let axes = [Axis::X, Axis::Y, Axis::Z, Axis::B];
        for (place, value) in key.iter_mut().zip([from, to].iter().flat_map(|pose| axes.map(|axis| pose.get(axis)))) {
            // On the grid, so that sums of increments are one with absolute positions.
            *place = (value * 1000.0).round();
        }
        if let Some((_, distance)) = self.known.iter().find(|(known, _)| *known == key) {
            return *distance;
        }
        let distance = self.room.least(from, to);
        self.known.push((key, distance));
        distance
    }
}

fn lower(least: &mut Option<(f64, At)>, distance: f64, at: At) {
    if least.is_none_or(|(known, _)| distance < known) {
        *least = Some((distance, at));
    }
}

impl Judge for Clear<'_> {
    fn see(&mut self, step: &Step<'_>) {
        let (motion, at) = (&step.motion, At::motion(&step.motion));
        if step.clear() {
            let distance = self.distance(&motion.from, &motion.to);
            lower(&mut self.moves, distance, at);
        } else if let Some(cut) = step.cut() {
            let safe = match cut.points {
                [None, Some(_)] => &motion.from,
                [None, None] => &motion.to,
                _ => return,
            };
            let distance = self.distance(safe, safe);
            lower(&mut self.safe, distance, at);
        }
    }

    fn checks(&mut self, program: &Program) -> Vec<Check> {
        let rows = [
            (
                "safe-points",
                Text::fixed("Holgura al bruto en los puntos de seguridad", "Clearance to the stock at the safe points"),
                self.safe,
            ),
            (
                "clear-moves",
                Text::fixed(
                    "Holgura al bruto al cruzar y en rápido",
                    "Clearance to the stock in crossing and rapid moves",
                ),
                self.moves,
            ),
        ];
        rows.into_iter().filter_map(|(key, name, found)| Some((key, name, found?))).map(|(key, name, (least, at))| {
            let check = Check::passed(key, name, program, Text::same(mm(least)), Text::same(mm(self.d_s)));
            let check = check.at(Some(at));
            // A twentieth is what the search may miss, and more than safe points lose to rounding.
            if least >= self.d_s - self.room.fine {
                return check;
            }
            let (distance, line) = (shown(least.abs(), 3), at.line);
            if least < 0.0 {
                check.found(
                    Verdict::Stop,
                    Text::new(
                        format!("la herramienta entra {distance} mm en el bruto, fuera de las pasadas, en la línea {line} de «{}»", program.title.es),
                        format!("the tool runs {distance} mm into the stock, outside the passes, at line {line} of \"{}\"", program.title.en),
                    ),
                    Text::fixed("una distancia de seguridad d_s mayor, o un retroceso eps_v menor", "a greater safety distance d_s, or a smaller back-off eps_v"),
                )
            } else {
                check.found(
                    Verdict::Caution,
                    Text::new(
                        format!("la herramienta pasa a {distance} mm del bruto, menos que d_s, en la línea {line} de «{}»", program.title.es),
                        format!("the tool passes the stock at {distance} mm, less than d_s, at line {line} of \"{}\"", program.title.en),
                    ),
                    Text::fixed("una distancia de seguridad d_s mayor, o un retroceso eps_v menor", "a greater safety distance d_s, or a smaller back-off eps_v"),
                )
            }
        }).collect()
    }
}
