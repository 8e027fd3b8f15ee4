//! Fanuc, turning, G-code system A: U and W are the increments, G90, G92 and G94 are cycles, G98 and G99 say what F
//! means.
//!
//! # References
//! The lathe simulator's list of codes; Fanuc Series 0i-T operator's manual, G-code system A.

use crate::gcode::code::{Cycle, G, Group, M, Name, Pass, Turning};
use crate::gcode::control::Compensation;
use crate::gcode::dialect::reading::{Codes, Comments, Letters, Reading, Turret};
use crate::gcode::motion::{FeedMode, Plane};

/// How programs of Fanuc's system A are read.
pub static LATHE_A: Reading = Reading {
    letters: Letters::of("FIKLPQRSTUWXZ"),
    refused_letters: Letters::of("ABCDEHJVY"),
    free: Letters::of("FST"),
    codes: &CODES,
    machine_code,
    comments: Comments::Parentheses,
    expressions: false,
    longest_line: 4096,
    feed_required: false,
    plane: Plane::ZX,
    return_initial: true,
    diameter: true,
    system_a: true,
    turret: Turret::Digits,
    start: (G::Rapid, FeedMode::PerRevolution),
    call_depth: 4,
    dwell: &[(b'X' - b'A', 1.0), (b'U' - b'A', 1.0), (b'P' - b'A', 0.001)],
    most_machine_codes: 3,
};

const MACRO: Name = ("macros", "macros");

static CODES: Codes = Codes::new(&[
    (0, G::Rapid),
    (10, G::Linear),
    (20, G::Arc(true)),
    (30, G::Arc(false)),
    (40, G::Dwell),
    (180, G::Plane(Plane::ZX)),
    (200, G::Inch),
    (210, G::Millimetre),
    (280, G::Reference(false)),
    (300, G::Reference(true)),
    (320, G::Thread(false)),
    (340, G::Thread(true)),
    (400, G::Compensation(Compensation::Off)),
    (410, G::Compensation(Compensation::Left)),
    (420, G::Compensation(Compensation::Right)),
    (500, G::SetPositionOrSpeed),
    (530, G::MachineCoordinates),
    (540, G::WorkOffset(1)),
    (550, G::WorkOffset(2)),
    (560, G::WorkOffset(3)),
    (570, G::WorkOffset(4)),
    (580, G::WorkOffset(5)),
    (590, G::WorkOffset(6)),
    (650, G::Refused(Group::NonModal, &MACRO)),
    (700, G::Turning(Turning::Finish)),
    (710, G::Turning(Turning::Axial)),
    (720, G::Turning(Turning::Radial)),
    (730, G::Turning(Turning::Repeat)),
    (740, G::Turning(Turning::GrooveFace)),
    (750, G::Turning(Turning::GrooveOutside)),
    (760, G::Turning(Turning::Thread)),
    (800, G::Cancel),
    (810, G::Cycle(Cycle::Drill)),
    (820, G::Cycle(Cycle::DrillDwell)),
    (830, G::Cycle(Cycle::Peck)),
    (900, G::Pass(Pass::Axial)),
    (920, G::Pass(Pass::Thread)),
    (940, G::Pass(Pass::Radial)),
    (960, G::ConstantSurfaceSpeed),
    (970, G::Rpm),
    (980, G::Feed(FeedMode::PerMinute)),
    (990, G::Feed(FeedMode::PerRevolution)),
]);

fn machine_code(number: u32) -> Option<M> {
    Some(match number {
        0 | 1 => M::Pause,
        2 | 30 => M::End,
        3 => M::Spindle(true),
        4 => M::Spindle(false),
        5 => M::SpindleOff,
        7 | 8 => M::Coolant(true),
        9 => M::Coolant(false),
        38 | 39 => M::Door,
        97 => M::CallBlock,
        98 => M::Call,
        99 => M::Return,
        _ => return None,
    })
}
