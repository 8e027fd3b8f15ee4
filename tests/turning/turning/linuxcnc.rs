//! The figures of LinuxCNC's lathe programs, said in both languages and run by both interpreters.
//!
//! LinuxCNC works in its radius mode (but where a figure is given in diameters), Fanuc's X is a diameter. The figures come
//! from LinuxCNC's `nc_files` and from its own tests. Where an `rs274` may be older than the repair that a test of its own is
//! for (`g71-endless-loop`, `g71-endless-loop_2`, `g72-missing-iteration`), the figures of that test's file `expected` are held.
//!
//! # Translated
//! - Roughing and finishing (`linuxcnc_roughing`): `g71-with-g70` and `lathe_g70_71_demo` (one figure), `lathe_g7x_quadrants`,
//!   `lathe_g7x_face_boring`, `g72-facing`, `g72-missing-iteration`, `g71-endless-loop`, `g71-endless-loop2`,
//!   `g71-endless-loop_2`.
//! - Threads (`linuxcnc_threads`): `g76only`, `g76`, `lathe-g76` (one thread), `g76base` and `g76diam` (their given values),
//!   `g33_simple`, `g33_blend`.
//! - Nose compensation (`linuxcnc_nose`): `ccomp/lathe-comp`, `lathecomp`, `taper-od` (its given values).
//! - Holes (`linuxcnc_holes`): `g81/g17/g99` along the centre line, `macros/lathe/drill` (its given values).
//!
//! # Not translated
//! - `lathe_pawn`: its finishing is the figure of `g71-with-g70`; the rest are plain blocks, and plain blocks by chance are judged
//!   in `judged`.
//! - `g81/g18`, `g84/g18`: in G18 LinuxCNC drills along Y, which a lathe of two axes lacks. `g81/g17/g98`: Fanuc's system A
//!   has no return to the plane before; there G98 is the feed per minute.
//! - `g33.1`, `rigidtap_test`, `tapping`, `tap-discrimant-error-orig`: tapping (G84) is none of the codes that are read.
//! - G73 of LinuxCNC breaks chips in a hole; Fanuc's G73 repeats a contour.
//! - `macros/lathe/threading`: a degression of 1.5, between the constant area and the constant depth that Fanuc knows.
//! - `od`, `id`, `macros/lathe/turning`, `boring`, `facing`, `chamfer`, `radius` and their copies of `gmoccapy`: loops of
//!   O-words over plain blocks, no cycle. `bad_spirals_lathe`: plain blocks.
//! - The rounding of the point of `g76`: work offsets set anew for each of its plain passes.

use std::fmt::Write;

use rodete::gcode::motion;
use rodete::machine::axis::Axis;
use rodete::number::trig::{atan2, hypot, sin_cos};

use super::common::rs274;
use super::lines::read;

/// By how much a coordinate may be off, mm: what rs274 rounds to, and what an arc's end is off its circle.
pub const NEAR: f64 = 2e-4;
/// The same where rs274 prints inches.
pub const NEAR_INCH: f64 = 1.4e-3;

/// A motion of either: points are `[X, Z]`, X a radius, mm.
#[derive(Clone, Copy, Debug)]
pub struct TracedMotion {
    pub rapid: bool,
    pub from: [f64; 2],
    pub to: [f64; 2],
    /// Of an arc its centre and whether it is counter-clockwise.
    pub arc: Option<([f64; 2], bool)>,
}

impl TracedMotion {
    pub fn length(&self) -> f64 {
        hypot(self.to[0] - self.from[0], self.to[1] - self.from[1])
    }

    /// Points along it.
    pub fn points(&self) -> Vec<[f64; 2]> {
        let Some((centre, counter)) = self.arc else { return vec![self.from, self.to] };
        let angle = |p: [f64; 2]| atan2(p[0] - centre[0], p[1] - centre[1]);
        let radius = hypot(self.from[0] - centre[0], self.from[1] - centre[1]);
        let sign = if counter { 1.0 } else { -1.0 };
        let sweep = (sign * (angle(self.to) - angle(self.from))).rem_euclid(std::f64::consts::TAU);
        let at = |share: f64| {
            let (sin, cos) = sin_cos(angle(self.from) + sign * sweep * share);
            [centre[0] + radius * sin, centre[1] + radius * cos]
        };
        (0..=400).map(|step| at(f64::from(step) / 400.0)).collect()
    }
}

pub fn near(a: [f64; 2], b: [f64; 2], tolerance: f64) -> bool {
    (a[0] - b[0]).abs() < tolerance && (a[1] - b[1]).abs() < tolerance
}

/// Asserts that two ways are one: kinds, ends and centres, moves to where the tool is left out.
pub fn assert_same(ours: &[TracedMotion], theirs: &[TracedMotion], tolerance: f64, of: &str) {
    let real = |cuts: &[TracedMotion]| -> Vec<TracedMotion> {
        cuts.iter().filter(|cut| cut.length() > tolerance).copied().collect()
    };
    let (ours, theirs) = (real(ours), real(theirs));
    assert_eq!(ours.len(), theirs.len(), "{of}\n{ours:?}\n{theirs:?}");
    for (our, their) in ours.iter().zip(&theirs) {
        let arcs = match (our.arc, their.arc) {
            (None, None) => true,
            (Some((a, one)), Some((b, other))) => one == other && hypot(a[0] - b[0], a[1] - b[1]) < 1e-3,
            _ => false,
        };
        let ends = near(our.from, their.from, tolerance) && near(our.to, their.to, tolerance);
        assert!(arcs && ends && our.rapid == their.rapid, "{of}\nours {our:?}\nrs274 {their:?}");
    }
}

/// The motions of a Fanuc program.
pub fn ours(program: &str) -> Vec<TracedMotion> {
    of_motions(&read(program).motions)
}

pub fn of_motions(motions: &[motion::Motion]) -> Vec<TracedMotion> {
    motions.iter().filter(|motion| !matches!(motion.kind, motion::MotionKind::Dwell(_))).map(of_motion).collect()
}

pub fn of_motion(motion: &motion::Motion) -> TracedMotion {
    let point = |pose: rodete::machine::axis::Pose| [pose.get(Axis::X), pose.get(Axis::Z)];
    let arc = match motion.kind {
        motion::MotionKind::Arc(arc, _) => Some(([arc.centre[1], arc.centre[0]], arc.sweep > 0.0)),
        _ => None,
    };
    TracedMotion {
        rapid: matches!(motion.kind, motion::MotionKind::Rapid),
        from: point(motion.from),
        to: point(motion.to),
        arc,
    }
}

/// The motions of a LinuxCNC program.
pub fn theirs(program: &str) -> Vec<TracedMotion> {
    of_canon(&canon(program, None))
}

pub fn canon(program: &str, tools: Option<&str>) -> rs274::Canon {
    rs274::run(program.as_bytes(), None, tools).unwrap_or_else(|why| panic!("{program}\n{why:?}"))
}

pub fn of_canon(canon: &rs274::Canon) -> Vec<TracedMotion> {
    let cut = |motion: &rs274::Motion| {
        let arc = match motion.kind {
            rs274::Kind::Arc { centre, turns, .. } => Some(([centre[1], centre[0]], turns > 0)),
            _ => None,
        };
        let point = |six: rs274::Six| [six[0], six[2]];
        let rapid = matches!(motion.kind, rs274::Kind::Rapid);
        TracedMotion { rapid, from: point(motion.from), to: point(motion.program), arc }
    };
    canon.motions.iter().filter(|motion| !matches!(motion.kind, rs274::Kind::Dwell(_))).map(cut).collect()
}

/// A block of a figure: `[X, Z]`, X a radius.
#[derive(Clone, Copy, Debug)]
pub enum Block {
    Line([f64; 2]),
    /// A line whose end is rounded by a radius, between it and the next line.
    Rounded([f64; 2], f64),
    /// An arc: whether it is clockwise (G2), its end, and I and K.
    Arc(bool, [f64; 2], [f64; 2]),
}
pub use Block::{Arc, Line, Rounded};

/// A figure: its first point and its blocks.
pub type Figure<'a> = ([f64; 2], &'a [Block]);

/// The blocks of a figure for LinuxCNC.
pub fn linuxcnc((first, blocks): Figure) -> String {
    let mut text = format!("G0 X{} Z{}\n", first[0], first[1]);
    for block in blocks {
        let _ = match *block {
            Line([x, z]) => writeln!(text, "G1 X{x} Z{z}"),
            Rounded([x, z], radius) => writeln!(text, "G1 X{x} Z{z} A{radius}"),
            Arc(clockwise, [x, z], [i, k]) => writeln!(text, "G{} X{x} Z{z} I{i} K{k}", if clockwise { 2 } else { 3 }),
        };
    }
    text
}

/// The blocks N10 to N20 of a figure for Fanuc; a rounded end becomes an arc, touching both lines.
pub fn fanuc((first, blocks): Figure) -> String {
    let xz = |[x, z]: [f64; 2]| format!("X{:.6} Z{z:.6}", 2.0 * x);
    let mut lines = vec![format!("G0 {}", xz(first))];
    let mut at = first;
    for (index, block) in blocks.iter().enumerate() {
        match *block {
            Line(to) => lines.push(format!("G1 {}", xz(to))),
            Rounded(to, radius) => {
                let Some(&Line(next)) = blocks.get(index + 1) else { panic!("a line follows") };
                let towards = |p: [f64; 2]| {
                    let length = hypot(p[0] - to[0], p[1] - to[1]);
                    [(p[0] - to[0]) / length, (p[1] - to[1]) / length]
                };
                let ([a, b], [c, d]) = (towards(at), towards(next));
                // The lines enclose an angle; each is shortened by r / tan of its half.
                let (cross, dot) = (b * c - a * d, a * c + b * d);
                let by = radius * (1.0 + dot) / cross.abs();
                let along = |[x, z]: [f64; 2]| [to[0] + by * x, to[1] + by * z];
                lines.push(format!("G1 {}", xz(along([a, b]))));
                let code = if cross > 0.0 { 2 } else { 3 };
                lines.push(format!("G{code} {} R{radius}", xz(along([c, d]))));
            }
            Arc(clockwise, to, [i, k]) => {
                lines.push(format!("G{} {} I{i:.6} K{k:.6}", if clockwise { 2 } else { 3 }, xz(to)));
            }
        }
        at = match *block {
            Line(to) | Rounded(to, _) | Arc(_, to, _) => to,
        };
    }
    let last = lines.len() - 1;
    lines[0] = format!("N10 {}", lines[0]);
    lines[last] = format!("N20 {}", lines[last]);
    lines.join("\n") + "\n"
}
