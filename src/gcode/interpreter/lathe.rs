//! What lathes do in their own way: coordinate systems, reference points, times by revolutions.
//!
//! # References
//! The lathe simulator's description of G50, G53 to G59 and G96; Fanuc Series 0i-T operator's manual, G-code system A, for G28,
//! G30 and G50 with U and W.
//!
//! # Where the two differ
//! `G54 X30.5 Z15` without G0 or G1 beside it shifts the system, as the simulator has it, and gets a Caution: on a Fanuc it is a
//! motion. With G0 or G1 in the block it is a motion for both.

use crate::finding::Grade;
use crate::gcode::code::{G, Group};
use crate::gcode::control::Letters;
use crate::gcode::interpreter::Interpreter;
use crate::gcode::interpreter::block::letter;
use crate::gcode::interpreter::fault::{Fault, Outcome};
use crate::gcode::motion::{Arc, Feed, FeedMode, MotionKind, Thread};
use crate::gcode::turning::pace::Pace;
use crate::machine::axis::{Axis, Pose};
use crate::machine::length_unit::LengthUnit;
use crate::machine::work_offset::{ACTIVE, ActiveOffsets, G28_FIRST, G30_FIRST, WorkOffset};
use crate::text::Text;

/// The axes of a lathe with the letters of their absolute and their incremental words.
const WORDS: [(Axis, usize, usize); 2] = [(Axis::X, letter::X, letter::U), (Axis::Z, letter::Z, letter::W)];

/// How far beyond the axis facing may end, mm on the diameter.
const FACING: f64 = 6.0;

impl Interpreter<'_> {
    /// Refuses X with U and Z with W, and increments in machine coordinates.
    pub(super) fn one_word_an_axis(&self) -> Outcome<()> {
        let at_once = self.block.g(Group::NonModal);
        if at_once == Some(G::Dwell) {
            return Ok(());
        }
        for (axis, absolute, incremental) in WORDS {
            let column = self.block.column(incremental);
            if self.block.has(absolute) && self.block.has(incremental) {
                let (name, step) = (axis.letter(), if axis == Axis::X { 'U' } else { 'W' });
                return Err(Fault::at(
                    &[self.block.column(absolute), column],
                    Text::new(
                        format!("{name} y {step} en un bloque: las dos mueven el eje {name}"),
                        format!("{name} and {step} in one block: both move the axis {name}"),
                    ),
                    Text::fixed("deje una de las dos", "leave one of the two"),
                ));
            }
            if at_once == Some(G::MachineCoordinates) && self.block.has(incremental) {
                return Err(Fault::at(
                    &[column],
                    Text::fixed("G53 con cotas incrementales", "G53 with incremental coordinates"),
                    Text::fixed("dé X y Z", "give X and Z"),
                ));
            }
        }
        Ok(())
    }

    /// G91, which system A does not have: told where it stands without axes, else refused.
    pub(super) fn no_increments(&mut self) -> Outcome<()> {
        if self.block.g(Group::Distance) != Some(G::Incremental) {
            return Ok(());
        }
        let column = self.block.g_column(Group::Distance);
        if self.has_axes() {
            return Err(self.unknown('G', 91.0, column));
        }
        self.remarks.add(
            Grade::Caution,
            self.line,
            Some(column),
            Text::fixed(
                "G91 no es un código del sistema A: leído como si no estuviera, X y Z siguen absolutas",
                "G91 is no code of system A: read as if it were not there, X and Z stay absolute",
            ),
            Text::fixed("escriba los incrementos con U y W", "write increments with U and W"),
        );
        Ok(())
    }

    /// G20 and G21, G70 and G71.
    pub(super) fn take_unit(&mut self) {
        match self.block.g(Group::Units) {
            Some(G::Inch) => self.set_unit(LengthUnit::Inch),
            Some(G::Millimetre) => self.set_unit(LengthUnit::Millimetre),
            _ => {}
        }
    }

    /// What a lathe keeps in mind when a motion begins.
    pub(super) fn lathe_motion(&mut self, motion: G) {
        if !matches!(motion, G::Pass(_) | G::Cancel) {
            self.modal.pass = None;
        }
        if matches!(motion, G::Cycle(_)) && !matches!(self.modal.motion, G::Cycle(_)) {
            self.modal.under = self.modal.motion;
        }
    }

    /// True where the block shifts a coordinate system: G54 to G59 with X or Z and no motion code.
    pub(super) fn shifts_system(&self) -> bool {
        self.control.offsets.shifts()
            && self.block.g(Group::WorkOffset).is_some()
            && self.block.g(Group::Motion).is_none()
            && self.block.g(Group::NonModal).is_none()
            && self.block.present & Letters::of("XZUW").mask() != 0
    }

    /// G54 to G59 with X and Z: the origin lies that far from the zero of the first system.
    pub(super) fn shift_system(&mut self, system: u8) {
        let mut origin = self.system(1).origin;
        for axis in [Axis::X, Axis::Z] {
            origin.set(axis, origin.get(axis) + self.axis_word(axis).unwrap_or(0.0));
        }
        let line = self.line;
        self.remarks.add(
            Grade::Caution,
            line,
            Some(self.block.g_column(Group::WorkOffset)),
            Text::fixed(
                "G54 a G59 con X o Z y sin G0 ni G1: se desplaza el sistema desde el cero W1, sin movimiento; un Fanuc se movería",
                "G54 to G59 with X or Z and without G0 or G1: the system is shifted from the zero W1, without motion; a Fanuc would move",
            ),
            Text::fixed("escriba G0 o G1 en el bloque si ha de ser un movimiento", "write G0 or G1 in the block if it is to move"),
        );
        self.modal.system = system;
        self.modal.shifted = true;
        self.parameters.set(ACTIVE as usize, f64::from(system));
        self.reframe(ActiveOffsets { work: WorkOffset { origin, rotation: 0.0 }, ..self.frame });
    }

    /// G50 with axis words: this position gets the coordinates X and Z, or its own and U and W more.
    pub(super) fn set_lathe_position(&mut self) {
        let to = self.end_point();
        let mut g92 = self.frame.g92;
        for axis in [Axis::X, Axis::Z] {
            g92.set(axis, self.current.get(axis) + g92.get(axis) - to.get(axis));
        }
        self.current = to;
        self.frame.g92 = g92;
        self.keep_g92(true, Some(g92));
    }

    /// G28 and G30: over the point of the words to the reference point, in the axes named.
    pub(super) fn return_to_reference(&mut self, second: bool) -> Outcome<()> {
        let column = self.block.g_column(Group::NonModal);
        let number = if second { 30 } else { 28 };
        let named: Vec<Axis> = WORDS
            .into_iter()
            .filter(|&(_, absolute, incremental)| self.block.has(absolute) || self.block.has(incremental))
            .map(|(axis, ..)| axis)
            .collect();
        if let Some(P) = self.block.get(letter::P).filter(|&P| second && P != 2.0) {
            return Err(Fault::at(
                &[self.block.column(letter::P)],
                Text::new(
                    format!("G30 P{P}: el tercer y el cuarto punto de referencia no están implementados"),
                    format!("G30 P{P}: the third and fourth reference points are not supported"),
                ),
                Text::fixed("use G30 P2 o G53", "use G30 P2, or G53"),
            ));
        }
        if named.is_empty() {
            return Err(Fault::at(
                &[column],
                Text::new(format!("G{number} sin ejes"), format!("G{number} without axes")),
                Text::new(format!("programe G{number} U0 W0"), format!("program G{number} U0 W0")),
            ));
        }
        let first = if second { G30_FIRST } else { G28_FIRST };
        if !self.setting.var_file.iter().any(|(parameter, _)| (first..first + 3).contains(&parameter)) {
            let line = self.line;
            self.remarks.add(
                Grade::Caution,
                line,
                Some(column),
                Text::new(
                    format!("punto de referencia de G{number} no conocido: se toma el cero de la máquina"),
                    format!("reference point of G{number} not known: the machine's zero is taken"),
                ),
                Text::new(
                    format!("dé los parámetros {first} y {} (X como radio, Z)", first + 2),
                    format!("give the parameters {first} and {} (X as radius, Z)", first + 2),
                ),
            );
        }
        let over = self.end_point();
        if over != self.current {
            self.emit(MotionKind::Rapid, over, None);
        }
        let reference = self.frame.to_program(&self.pose_of(first));
        let mut to = self.current;
        for axis in named {
            to.set(axis, reference.get(axis));
        }
        self.emit(MotionKind::Rapid, to, None);
        Ok(())
    }

    /// The program has gone on with a feed from before F changed its meaning.
    pub(super) fn remark_stale_feed(&mut self) {
        let line = self.line;
        self.remarks.add(
            Grade::Caution,
            line,
            None,
            Text::fixed(
                "el avance por minuto o por vuelta ha cambiado y F no se ha vuelto a dar: vale el número de antes",
                "feed per minute or per revolution has changed and F was not given again: its old number holds",
            ),
            Text::fixed("dé F con el cambio", "give F with the change"),
        );
    }

    /// X has been given below the axis. Facing ends a little beyond it, by the nose of the tool; farther is a slip of the
    /// sign.
    pub(super) fn remark_beyond_axis(&mut self, to: &Pose) {
        let line = self.line;
        let Some(word) = [letter::X, letter::U].into_iter().find(|&word| self.block.has(word)) else { return };
        let facing = 2.0 * to.get(Axis::X) >= -FACING;
        self.remarks.add(
            if facing { Grade::Note } else { Grade::Caution },
            line,
            Some(self.block.column(word)),
            Text::fixed(
                "X negativo: el punto programado pasa del eje de giro",
                "negative X: the programmed point is beyond the axis",
            ),
            Text::fixed("compruebe el signo y que X es un diámetro", "check the sign, and that X is a diameter"),
        );
    }

    /// True for a feed per revolution of a lathe, whose spindle's speed may change along the motion.
    pub(super) fn by_revolution(&self, feed: Feed) -> bool {
        self.control.spindle.turns.part() && feed.mode == FeedMode::PerRevolution
    }

    fn pace(&self) -> Option<Pace> {
        Pace::of(&self.modal.in_force())
    }

    /// The time of a straight motion at a feed per revolution.
    pub(super) fn turned_seconds(&self, to: &Pose, feed: Feed) -> Option<f64> {
        let by = to.differences(&self.current);
        let length = by.iter().map(|by| by * by).sum::<f64>().sqrt();
        self.pace()?.straight([self.current.get(Axis::X), to.get(Axis::X)], length, feed.value)
    }

    /// The time of an arc from here at a feed per revolution.
    pub(super) fn turned_arc_seconds(&self, arc: &Arc, feed: Feed) -> Option<f64> {
        self.pace()?.arc(arc, [self.current.get(Axis::X), self.current.get(Axis::Z)], feed.value)
    }

    /// The time of a thread.
    pub(super) fn thread_seconds(&self, to: &Pose, thread: &Thread) -> Option<f64> {
        let by = |axis: Axis| (to.get(axis) - self.current.get(axis)).abs();
        let distance = by(Axis::X).max(by(Axis::Z));
        self.pace()?.thread([self.current.get(Axis::X), to.get(Axis::X)], distance, thread)
    }
}
