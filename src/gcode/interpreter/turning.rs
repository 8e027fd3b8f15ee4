//! Turning cycles of one call: from words to the parameters of the pure cycles, from their moves to motions.
//!
//! # References
//! Fanuc Series 0i-T operator's manual, multiple repetitive cycles G70 to G76: two blocks each but for G70, the words of the first
//! stay in force; after G70 the program goes on with the next block, after G71 to G73 behind the contour.

use crate::gcode::code::{G, Group, Turning};
use crate::gcode::interpreter::Interpreter;
use crate::gcode::interpreter::block::letter;
use crate::gcode::interpreter::contour::Contour;
use crate::gcode::interpreter::fault::{Fault, Outcome};
use crate::gcode::motion::Feed;
use crate::text::Text;

/// The words of the first block of a cycle of two, as they were programmed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct First {
    pub(super) p: Option<f64>,
    pub(super) q: Option<f64>,
    pub(super) r: Option<f64>,
    pub(super) u: Option<f64>,
    pub(super) w: Option<f64>,
}

impl Interpreter<'_> {
    /// The turning cycle of the block in hand.
    pub(super) fn turning(&mut self, cycle: Turning) -> Outcome<()> {
        match cycle {
            Turning::Finish => {
                let contour = self.named_contour(cycle)?;
                let feed = self.feed()?;
                self.not_yet(cycle, &contour, feed)
            }
            Turning::Axial | Turning::Radial | Turning::Repeat => {
                if !self.block.has(letter::P) && !self.block.has(letter::Q) {
                    self.keep_first(cycle);
                    return Ok(());
                }
                let first = self.first(cycle)?;
                let contour = self.named_contour(cycle)?;
                self.go_behind(cycle.number(), &contour)?;
                let feed = self.feed()?;
                let _ = first;
                self.not_yet(cycle, &contour, feed)
            }
            Turning::GrooveFace | Turning::GrooveOutside | Turning::Thread => {
                if !self.has_axes() {
                    self.keep_first(cycle);
                    return Ok(());
                }
                self.first(cycle)?;
                Err(self.refused(cycle))
            }
            Turning::Fagor(_) => Err(self.refused(cycle)),
        }
    }

    /// True where the block has a turning cycle of one call.
    pub(super) fn has_turning_cycle(&self) -> bool {
        matches!(self.block.g(Group::NonModal), Some(G::Turning(_)))
    }

    fn not_yet(&mut self, cycle: Turning, contour: &Contour, _: Feed) -> Outcome<()> {
        let _ = contour;
        Err(self.refused(cycle))
    }

    fn refused(&self, cycle: Turning) -> Box<Fault> {
        let number = cycle.number();
        Fault::at(
            &[self.block.g_column(Group::NonModal)],
            Text::new(
                format!("G{number} no está implementado: ciclos de torneado"),
                format!("G{number} is not supported: turning cycles"),
            ),
            Text::fixed(
                "quítelo o sustitúyalo: un programa que lo lleva no se puede comprobar",
                "take it out or replace it: a program with it cannot be verified",
            ),
        )
    }

    fn named_contour(&mut self, cycle: Turning) -> Outcome<Contour> {
        let ends = self.contour_ends(cycle.number(), [letter::P, letter::Q])?;
        self.contour(cycle.number(), ends)
    }

    /// Keeps the words of the first block of a cycle.
    fn keep_first(&mut self, cycle: Turning) {
        let get = |letter| self.block.get(letter);
        let first =
            First { p: get(letter::P), q: get(letter::Q), r: get(letter::R), u: get(letter::U), w: get(letter::W) };
        self.modal.first.retain(|(of, _)| *of != cycle);
        self.modal.first.push((cycle, first));
    }

    /// The words of the first block of a cycle.
    fn first(&self, cycle: Turning) -> Outcome<First> {
        let number = cycle.number();
        self.modal.first.iter().find(|(of, _)| *of == cycle).map(|(_, first)| *first).ok_or_else(|| {
            Fault::at(
                &[self.block.g_column(Group::NonModal)],
                Text::new(
                    format!("falta el primer bloque de G{number}"),
                    format!("the first block of G{number} is missing"),
                ),
                Text::new(
                    format!("G{number} se escribe en dos bloques seguidos; lo que no dé el primero lo pone el control"),
                    format!("G{number} is written in two blocks; what the first does not give is the control's own"),
                ),
            )
        })
    }
}
