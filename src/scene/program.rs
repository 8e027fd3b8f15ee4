//! A program with its motions, column by column.

use nalgebra::Vector3;
use serde::Serialize;

use super::column;
use super::turning::ShownTurning;
use super::{Remark, ShownTool, State};
use crate::gcode::control::Control;
use crate::gcode::in_force::InForce;
use crate::gcode::interpreter::line_feeds;
use crate::gcode::motion::{Arc, Feed, Motion, MotionKind};
use crate::machine::axis::{Axis, Pose};
use crate::machine::chain::{Chain, Stand};
use crate::machine::rapids::Rapids;
use crate::number::trig::{acos, atan2, sin_cos};
use crate::text::Text;

/// The rate of rapid moves, mm/min or °/min, where the machine's is not known: the slowest axis counts.
pub const RAPID: f64 = 6000.0;
/// The rate of feed moves whose F is not known.
pub const FEED: f64 = 300.0;

/// How far a straight piece may leave the tip's path, mm, and how far the tool's axis may turn along it.
const TOLERANCE: f64 = 0.05;
const TURN: f64 = 0.1;
/// Most pieces of a motion.
const PIECES: u8 = 96;

/// Codes of a motion.
const RAPID_CODE: u8 = 0;
const FEED_CODE: u8 = 1;
const CLOCKWISE: u8 = 2;
const COUNTER_CLOCKWISE: u8 = 3;
const THREAD: u8 = 4;
const DWELL: u8 = 5;
const STILL: u8 = 6;

/// States before the one in force that a motion may return to.
const STATES: usize = 16;

/// How a linear or rotary axis moves.
#[derive(Clone, Debug, Serialize)]
struct Column {
    letter: char,
    /// Where each motion ends, mm or degrees.
    #[serde(serialize_with = "column::numbers")]
    to: Vec<f64>,
}

/// A program as it is shown and played.
#[derive(Clone, Debug, Serialize)]
pub struct Program {
    /// What it does.
    pub title: Text,
    /// Its lines.
    pub blocks: Vec<String>,
    /// What a person should know of what is shown.
    pub notes: Vec<Text>,
    /// Alarms and findings, gravest first.
    pub remarks: Vec<Remark>,
    /// The tools.
    pub tools: Vec<ShownTool>,
    /// What is turned.
    pub turning: Option<ShownTurning>,
    /// What is added to the program coordinates (X as a radius, Y, Z) of the motions to come, so that their path stands on
    /// the part when the program shifts its coordinates; mm. The display goes on showing program coordinates.
    #[serde(skip)]
    pub shift: [f64; 3],
    /// The codes of feed per minute, per revolution, of inverse time and of seconds.
    feed_codes: [&'static str; 4],
    /// The letter of the tool's offset.
    offset_letter: char,
    /// X is shown as a diameter.
    diameter: bool,
    /// The readout shows X, Y and Z of the path; else they have columns.
    plain: bool,
    /// Axes beside those that the path says.
    axes: Vec<Column>,
    states: Vec<State>,
    /// How fast the machine is where it does not cut.
    #[serde(skip)]
    pub rapids: Rapids,
    /// Times of rapid moves are taken at [`RAPID`], since the machine's rates are not known; times of feed moves at [`FEED`].
    assumed: [bool; 2],
    /// The line of each motion.
    #[serde(serialize_with = "column::wholes")]
    line: Vec<u32>,
    /// 0 rapid, 1 feed, 2 and 3 arcs, 4 thread, 5 dwell, 6 a block without motion.
    #[serde(serialize_with = "column::bytes")]
    kind: Vec<u8>,
    #[serde(serialize_with = "column::singles")]
    seconds: Vec<f32>,
    /// F as programmed, in mm; the lead of a thread.
    #[serde(serialize_with = "column::numbers")]
    feed: Vec<f64>,
    /// The index of what is in force.
    #[serde(serialize_with = "column::wholes")]
    state: Vec<u32>,
    /// How many points of the path each motion has, the last one its end.
    #[serde(serialize_with = "column::bytes")]
    pieces: Vec<u8>,
    #[serde(serialize_with = "column::points")]
    points: Vec<[f64; 3]>,
    /// The tool's axis at each point; none where it stands along Z throughout.
    #[serde(serialize_with = "column::directions")]
    directions: Vec<[f64; 3]>,
    /// Motions that do not start where the one before ended, with their starts: point, direction, axes.
    #[serde(serialize_with = "column::wholes")]
    jumps: Vec<u32>,
    #[serde(serialize_with = "column::points")]
    jump_points: Vec<[f64; 3]>,
    #[serde(serialize_with = "column::directions")]
    jump_directions: Vec<[f64; 3]>,
    #[serde(serialize_with = "column::points")]
    jump_poses: Vec<[f64; 9]>,
    /// Motions that are arcs of the path, with plane (0 XY, 1 ZX, 2 YZ), centre, and the angle swept in radians.
    #[serde(serialize_with = "column::wholes")]
    arcs: Vec<u32>,
    #[serde(serialize_with = "column::points")]
    arc_shapes: Vec<[f64; 4]>,
    /// Motions of two pieces that bend, with the part of the motion's time at which they do.
    #[serde(serialize_with = "column::wholes")]
    bends: Vec<u32>,
    #[serde(serialize_with = "column::singles")]
    bend_parts: Vec<f32>,
    /// It is known where the machine stands before the next motion.
    #[serde(skip)]
    pub known: bool,
    #[serde(skip)]
    frame: Chain,
    #[serde(skip)]
    before: Option<(Pose, [f64; 3])>,
}

impl Program {
    /// A program without motions. `text` gives its lines.
    #[must_use]
    pub fn new(title: Text, control: &Control, frame: Chain, text: &str) -> Self {
        let letters: &[char] = match frame {
            Chain::Milling | Chain::Turning => &[],
            Chain::Tilting(_) => &['X', 'Y', 'Z', 'B', 'C'],
            Chain::Torch => &['X', 'Z', 'A', 'B', 'C'],
            Chain::Pipe(_) => &['X', 'A'],
        };
        Self {
            title,
            blocks: line_feeds(text.trim_start_matches('\u{feff}')).lines().map(block).collect(),
            notes: Vec::new(),
            remarks: Vec::new(),
            tools: Vec::new(),
            turning: None,
            shift: [0.0; 3],
            feed_codes: control.feed.codes.names(),
            offset_letter: control.length.letter(),
            diameter: frame == Chain::Turning,
            plain: frame.straight(),
            axes: letters.iter().map(|&letter| Column { letter, to: Vec::new() }).collect(),
            states: Vec::new(),
            rapids: Rapids::default(),
            assumed: [false; 2],
            line: Vec::new(),
            kind: Vec::new(),
            seconds: Vec::new(),
            feed: Vec::new(),
            state: Vec::new(),
            pieces: Vec::new(),
            points: Vec::new(),
            directions: Vec::new(),
            jumps: Vec::new(),
            jump_points: Vec::new(),
            jump_directions: Vec::new(),
            jump_poses: Vec::new(),
            arcs: Vec::new(),
            arc_shapes: Vec::new(),
            bends: Vec::new(),
            bend_parts: Vec::new(),
            known: false,
            frame,
            before: None,
        }
    }

    /// How many motions there are.
    #[must_use]
    pub const fn motions(&self) -> usize {
        self.kind.len()
    }

    /// True where axes turn that the path does not know of: it is drawn as X, Y and Z are written.
    #[must_use]
    pub fn turns_unseen(&self) -> bool {
        self.frame.straight() && self.axes.iter().any(|axis| matches!(axis.letter, 'A' | 'B' | 'C'))
    }

    /// Adds the next motion with what is in force.
    ///
    /// Where the first one is rapid it has no way, unless it is [`known`](Self::known) where the machine stood before. A motion whose time is
    /// not known, and for which [`rapids`](Self::rapids) has no rate, is given that at [`RAPID`] or [`FEED`], and the page says so.
    pub fn push(&mut self, motion: &Motion, control: &InForce) {
        let rapid = motion.kind == MotionKind::Rapid;
        let from = if !self.known && rapid { motion.to } else { motion.from };
        self.known = true;
        let (kind, feed) = match motion.kind {
            MotionKind::Rapid => (RAPID_CODE, Feed::default().value),
            MotionKind::Feed(feed) => (FEED_CODE, feed.value),
            MotionKind::Arc(arc, feed) if arc.sweep < 0.0 => (CLOCKWISE, feed.value),
            MotionKind::Arc(_, feed) => (COUNTER_CLOCKWISE, feed.value),
            MotionKind::Thread(thread) => (THREAD, thread.lead),
            MotionKind::Dwell(_) => (DWELL, 0.0),
        };
        self.columns(&from, &motion.to);
        if self.before.is_none_or(|before| before != (from, self.shift)) {
            let Stand { point, axis } = self.placed(&from);
            self.jumps.push(whole(self.kind.len()));
            self.jump_points.push(point.into());
            self.jump_poses.push(from.0);
            if !self.frame.straight() {
                self.jump_directions.push(axis.into());
            }
        }
        self.path(motion, &from);
        let state = self.state_of(control);
        self.state.push(state);
        // A motion of a subprogram's own file stands at the last line of the program that moved.
        let line = if control.file == 0 { whole(motion.line) } else { self.line.last().copied().unwrap_or(0) };
        self.line.push(line);
        self.kind.push(kind);
        self.feed.push(feed);
        let seconds = self.time(motion, &from);
        #[expect(clippy::cast_possible_truncation, reason = "for playing")]
        self.seconds.push(seconds as f32);
        self.before = Some((motion.to, self.shift));
    }

    /// Bends the straight motion that was added last, at a pose and a part of its time, above 0 and below 1: a rapid motion in which
    /// each axis keeps its own rate until it is there.
    pub fn bend(&mut self, at: &Pose, part: f64) {
        debug_assert!(self.frame.straight(), "the tool's axis stands");
        let point = self.placed(at).point.into();
        if let Some(pieces) = self.pieces.last_mut()
            && *pieces == 1
        {
            *pieces = 2;
            let end = self.points.len() - 1;
            self.points.insert(end, point);
            self.bends.push(whole(self.kind.len() - 1));
            #[expect(clippy::cast_possible_truncation, reason = "for playing")]
            self.bend_parts.push(part as f32);
        }
    }

    /// Adds a block without motion that stands at a line, 0 before the first: what it puts into force, and where the
    /// machine stands.
    pub fn stand(&mut self, line: usize, control: &InForce, at: &Pose) {
        let motion = Motion {
            line,
            n: None,
            kind: MotionKind::Dwell(0.0),
            from: *at,
            to: *at,
            machine: *at,
            seconds: Some(0.0),
        };
        let known = self.known;
        self.push(&motion, control);
        self.known = known;
        if let Some(kind) = self.kind.last_mut() {
            *kind = STILL;
        }
    }

    fn placed(&self, pose: &Pose) -> Stand {
        let Stand { point, axis } = self.frame.stand(pose);
        Stand { point: point + Vector3::from(self.shift), axis }
    }

    fn time(&mut self, motion: &Motion, from: &Pose) -> f64 {
        if let Some(seconds) = motion.seconds.filter(|seconds| seconds.is_finite() && *seconds >= 0.0) {
            return seconds;
        }
        let by = motion.to.differences(from);
        if motion.kind == MotionKind::Rapid
            && let Some(seconds) = self.rapids.seconds(&by)
        {
            return seconds;
        }
        let (rate, assumed, way) = match motion.kind {
            MotionKind::Dwell(seconds) => return seconds.max(0.0),
            MotionKind::Rapid => (RAPID, 0, by.iter().fold(0.0, |most: f64, by| most.max(by.abs()))),
            MotionKind::Arc(arc, _) => (FEED, 1, arc.length(by[arc.plane.axes()[2] as usize])),
            _ => (FEED, 1, by.iter().map(|by| by * by).sum::<f64>().sqrt()),
        };
        self.assumed[assumed] |= way > 0.0;
        way * 60.0 / rate
    }

    /// Ends of the axes that have columns. An axis that the path does not say gets one when it first moves.
    fn columns(&mut self, from: &Pose, to: &Pose) {
        if self.frame.straight() {
            for axis in Axis::ALL.into_iter().skip(3) {
                if to.get(axis) != from.get(axis) && self.axes.iter().all(|column| column.letter != axis.letter()) {
                    self.axes.push(Column { letter: axis.letter(), to: vec![from.get(axis); self.kind.len()] });
                }
            }
        }
        for column in &mut self.axes {
            let axis = Axis::ALL.into_iter().find(|axis| axis.letter() == column.letter);
            column.to.push(axis.map_or(0.0, |axis| to.get(axis)));
        }
    }

    fn state_of(&mut self, control: &InForce) -> u32 {
        let state = State { shift: self.shift, ..State::from(control) };
        let known = self.states.iter().enumerate().rev().take(STATES).find(|(_, known)| **known == state);
        let at = known.map(|(at, _)| at).unwrap_or_else(|| {
            self.states.push(state);
            self.states.len() - 1
        });
        whole(at)
    }

    /// The points of a motion beyond its start.
    fn path(&mut self, motion: &Motion, from: &Pose) {
        let to = motion.to;
        let straight = self.frame.straight();
        let mut pieces = 1;
        match motion.kind {
            MotionKind::Arc(arc, _) if straight => {
                let [x, y] = arc.centre;
                self.arcs.push(whole(self.kind.len()));
                let [first, second, _] = arc.plane.axes().map(|axis| self.shift[axis as usize]);
                self.arc_shapes.push([f64::from(arc.plane as u8), x + first, y + second, arc.sweep]);
            }
            MotionKind::Arc(arc, _) => {
                let steps = (arc.sweep.abs() / TURN).ceil().clamp(1.0, f64::from(PIECES));
                #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 to PIECES")]
                let steps = steps as u8;
                pieces = steps;
            }
            _ if straight => {}
            _ => pieces = self.pieces_of(from, &to),
        }
        for piece in 1..=pieces {
            let part = f64::from(piece) / f64::from(pieces);
            let pose = match motion.kind {
                _ if piece == pieces => to,
                MotionKind::Arc(arc, _) => along(&arc, from, &to, part),
                _ => between(from, &to, part),
            };
            let Stand { point, axis } = self.placed(&pose);
            self.points.push(point.into());
            if !straight {
                self.directions.push(axis.into());
            }
        }
        self.pieces.push(pieces);
    }

    /// Into how many pieces a motion that bends on the part is parted: what a piece leaves of its path falls with the
    /// square of their number.
    fn pieces_of(&self, from: &Pose, to: &Pose) -> u8 {
        let ends = [from, to].map(|pose| self.frame.stand(pose));
        let mut off: f64 = 0.0;
        for part in [0.25, 0.5, 0.75] {
            let point: Vector3<f64> = ends[0].point + (ends[1].point - ends[0].point) * part;
            off = off.max((self.frame.stand(&between(from, to, part)).point - point).norm());
        }
        let turn = acos(ends[0].axis.dot(&ends[1].axis).clamp(-1.0, 1.0));
        let pieces = (off / TOLERANCE).sqrt().max(turn / TURN).ceil().clamp(1.0, f64::from(PIECES));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 to PIECES")]
        let pieces = pieces as u8;
        pieces
    }
}

fn between(from: &Pose, to: &Pose, part: f64) -> Pose {
    Pose(std::array::from_fn(|axis| from.0[axis] + (to.0[axis] - from.0[axis]) * part))
}

/// A pose along an arc: the plane's axes on the circle, the others at their share of the way.
fn along(arc: &Arc, from: &Pose, to: &Pose, part: f64) -> Pose {
    let [first, second, _] = arc.plane.axes();
    let [x, y] = [from.get(first) - arc.centre[0], from.get(second) - arc.centre[1]];
    let (sin, cos) = sin_cos(atan2(y, x) + arc.sweep * part);
    let mut pose = between(from, to, part);
    pose.set(first, arc.centre[0] + arc.radius * cos);
    pose.set(second, arc.centre[1] + arc.radius * sin);
    pose
}

/// An index; the viewer takes far fewer motions than this holds.
fn whole(value: usize) -> u32 {
    u32::try_from(value).unwrap_or(u32::MAX)
}

/// Most characters of a line that are shown.
const LONGEST: usize = 400;

fn block(line: &str) -> String {
    crate::escape::excerpt(&line.trim_end().replace('\t', " "), LONGEST)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gcode::control::{FANUC_LATHE_A, LINUXCNC};
    use crate::gcode::interpreter::{Interpreter, Setting};
    use crate::machine::rotary::TiltingTable;

    fn program(text: &str, frame: Chain, shift: [f64; 3]) -> Program {
        program_of(&LINUXCNC, text, frame, shift)
    }

    fn program_of(control: &'static Control, text: &str, frame: Chain, shift: [f64; 3]) -> Program {
        let mut program = Program::new(Text::same("p"), control, frame, text);
        program.shift = shift;
        let mut interpreter = Interpreter::over(text.as_bytes(), Setting::new(control));
        while let Some(motion) = interpreter.next() {
            program.push(&motion.unwrap(), interpreter.in_force());
        }
        program
    }

    #[test]
    fn the_first_rapid_has_no_way_and_other_motions_start_where_the_last_ended() {
        let text = "G21 G90\nG0 X10 Y5 Z2\nG1 Z-1 F100\nG1 X40\nM2\n";
        let program = program(text, Chain::Milling, [0.0; 3]);
        assert_eq!(program.points, [[10.0, 5.0, 2.0], [10.0, 5.0, -1.0], [40.0, 5.0, -1.0]]);
        assert_eq!(
            (program.jumps.as_slice(), program.jump_points.as_slice()),
            ([0].as_slice(), [[10.0, 5.0, 2.0]].as_slice())
        );
        assert_eq!(program.seconds, [0.0, 1.8, 18.0]);
        assert_eq!(program.assumed, [false, false], "nothing was assumed");
    }

    #[test]
    fn rapids_take_the_time_of_the_machine_where_its_rates_are_known() {
        let text = "G21 G90\nG0 X10\nG0 X110 C90\nM2\n";
        let shown = |rapids: Rapids| {
            let mut program = Program::new(Text::same("p"), &LINUXCNC, Chain::Milling, text);
            program.rapids = rapids;
            let mut interpreter = Interpreter::over(text.as_bytes(), Setting::new(&LINUXCNC));
            while let Some(motion) = interpreter.next() {
                program.push(&motion.unwrap(), interpreter.in_force());
            }
            (program.seconds[1], program.assumed[0])
        };
        let known = Rapids { linear: Some(20_000.0), rotary: Some(3600.0), tool_change: None };
        assert_eq!(shown(known), (1.5, false), "the slower axis decides");
        assert_eq!(shown(Rapids { rotary: None, ..known }), (1.0, true), "at 6000 where an axis has no rate");
    }

    #[test]
    fn lines_are_counted_as_the_interpreter_counts_them_and_a_byte_order_mark_is_none_of_them() {
        let text = "G21 G97\rG0 X1.\r\n\r\r\nG0 X2.\nM30";
        let shown = program_of(&FANUC_LATHE_A, text, Chain::Milling, [0.0; 3]);
        assert_eq!(shown.blocks, ["G21 G97", "G0 X1.", "", "", "G0 X2.", "M30"]);
        assert_eq!(shown.line, [2, 5]);
        let marked = Program::new(Text::same("p"), &FANUC_LATHE_A, Chain::Milling, &format!("\u{feff}{text}"));
        assert_eq!(marked.blocks, shown.blocks);
    }

    #[test]
    fn a_shift_moves_the_path_and_the_centres_of_arcs() {
        let text = "G21 G90 F100\nG0 X10 Y0\nG3 X0 Y10 I-10 J0\nM2\n";
        let program = program(text, Chain::Milling, [1.0, 2.0, 3.0]);
        assert_eq!(program.points, [[11.0, 2.0, 3.0], [1.0, 12.0, 3.0]]);
        assert_eq!(program.arc_shapes[0][..3], [0.0, 1.0, 2.0]);
        assert_eq!(program.states.last().unwrap().shift, [1.0, 2.0, 3.0]);
    }

    #[test]
    fn a_motion_that_bends_has_the_point_of_its_bend_and_the_part_of_its_time_there() {
        let mut program = program("G21 G90\nG0 X1\nG0 X10 Z5\nM2\n", Chain::Milling, [1.0, 0.0, 0.0]);
        let mut at = Pose::default();
        at.set(Axis::X, 6.0);
        at.set(Axis::Z, 5.0);
        program.bend(&at, 0.4);
        assert_eq!(program.points, [[2.0, 0.0, 0.0], [7.0, 0.0, 5.0], [11.0, 0.0, 5.0]]);
        assert_eq!((program.pieces.as_slice(), program.bends.as_slice()), ([1, 2].as_slice(), [1].as_slice()));
        assert_eq!(program.bend_parts, [0.4]);
    }

    #[test]
    fn an_axis_that_the_path_does_not_say_has_its_own_column_from_its_first_move_on() {
        let text = "G21 G90 F100\nG0 X1\nG1 X2\nG1 A90\nM2\n";
        let program = program(text, Chain::Milling, [0.0; 3]);
        assert!(program.turns_unseen());
        assert_eq!((program.axes[0].letter, program.axes[0].to.as_slice()), ('A', [0.0, 0.0, 90.0].as_slice()));
    }

    #[test]
    fn a_turn_of_the_part_bends_the_path_of_the_tip_within_the_tolerance() {
        let machine = TiltingTable { L: 250.0 };
        let text = "G21 G90 G94 F100\nG0 X20 Y0 Z0 B0 C0\nG1 B60 C90\nM2\n";
        let program = program(text, Chain::Tilting(machine), [0.0; 3]);
        assert_eq!(program.pieces[0], 1);
        let count = program.pieces[1];
        assert!(count > 20, "{count} pieces");
        // Halfway between the points that are kept, the chord is as near to the path as was asked for.
        let pose = |part: f64| {
            let mut pose = Pose::default();
            pose.set(Axis::X, 20.0);
            pose.set(Axis::B, 60.0 * part);
            pose.set(Axis::C, 90.0 * part);
            pose
        };
        for piece in 1..usize::from(count) {
            let [one, two] = [piece, piece + 1].map(|at| Vector3::from(program.points[at]));
            #[expect(clippy::cast_precision_loss, reason = "a small count")]
            let part = (piece as f64 + 0.5) / f64::from(count);
            let exact = Chain::Tilting(machine).stand(&pose(part)).point;
            assert!(((one + two) / 2.0 - exact).norm() < 2.0 * TOLERANCE, "piece {piece}");
        }
    }
}
