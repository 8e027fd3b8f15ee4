//! M62 to M68: digital and analog inputs and outputs. None moves the machine.
//!
//! # References
//! LinuxCNC, M-code reference, M62 to M68. What an input reads is not in the program: it is refused where a block uses it.

use crate::finding::Grade;
use crate::gcode::code::M;
use crate::gcode::interpreter::Interpreter;
use crate::gcode::interpreter::block::letter;
use crate::gcode::interpreter::expression::whole;
use crate::gcode::interpreter::fault::{Fault, Outcome};
use crate::text::Text;

/// The parameter that M66 leaves its input in.
pub(super) const INPUT: usize = 5399;

impl Interpreter<'_> {
    /// M62 to M68.
    pub(super) fn inputs_and_outputs(&mut self) -> Outcome<()> {
        match self.block.m(5) {
            Some((M::Output, _)) if !self.is_channel(letter::P) => Err(self.refuse_channel(
                Text::fixed("salida digital sin su número P", "digital output without its number P"),
                Text::fixed(
                    "P es el número de la salida, entero de 0 en adelante",
                    "P is the output's number, whole, from 0 on",
                ),
            )),
            Some((M::AnalogOutput, _)) if !self.is_channel(letter::E) || !self.block.has(letter::Q) => Err(self
                .refuse_channel(
                    Text::fixed(
                        "salida analógica sin su número E o sin Q",
                        "analog output without its number E or without Q",
                    ),
                    Text::fixed(
                        "E es el número de la salida, entero de 0 en adelante; Q, su valor",
                        "E is the output's number, whole, from 0 on; Q is its value",
                    ),
                )),
            Some((M::Input, _)) => self.input(),
            _ => Ok(()),
        }
    }

    fn is_channel(&self, letter: usize) -> bool {
        self.block.get(letter).and_then(whole).is_some_and(|channel| channel >= 0)
    }

    fn refuse_channel(&self, what: Text, remedy: Text) -> Box<Fault> {
        Fault::at(&[self.block.m_column(5)], what, remedy)
    }

    /// M66: `P` a digital input, `E` an analog one; `L` 0 to 4 what is waited for, `Q` for how many seconds at most.
    fn input(&mut self) -> Outcome<()> {
        let (digital, analog) = (self.block.has(letter::P), self.block.has(letter::E));
        if digital == analog || !(self.is_channel(letter::P) || self.is_channel(letter::E)) {
            return Err(self.refuse_channel(
                Text::fixed("M66 espera o P o E", "M66 wants either P or E"),
                Text::fixed(
                    "P es el número de una entrada digital y E el de una analógica, entero de 0 en adelante",
                    "P is the number of a digital input, E that of an analog one, whole, from 0 on",
                ),
            ));
        }
        let wait = self.block.get(letter::L).map_or(Some(0), whole);
        if !wait.is_some_and(|wait| (0..=4).contains(&wait)) {
            return Err(self.refuse_channel(
                Text::fixed("L de M66 no es un modo de espera", "L of M66 is no way to wait"),
                Text::fixed("L es 0, 1, 2, 3 o 4", "L is 0, 1, 2, 3 or 4"),
            ));
        }
        if analog && wait != Some(0) {
            return Err(self.refuse_channel(
                Text::fixed("M66 con E y una espera", "M66 with E and a wait"),
                Text::fixed("una entrada analógica solo se lee: L0", "an analog input is only read: L0"),
            ));
        }
        if wait != Some(0) && self.block.get(letter::Q).is_none_or(|seconds| seconds <= 0.0) {
            return Err(self.refuse_channel(
                Text::fixed("M66 con una espera y sin su tiempo Q", "M66 with a wait and without its time Q"),
                Text::fixed("dé Q en segundos, mayor que 0", "give Q in seconds, greater than 0"),
            ));
        }
        self.parameters.forget(INPUT);
        self.input_read = true;
        self.remarks.add(
            Grade::Note,
            self.line,
            Some(self.block.m_column(5)),
            if wait == Some(0) {
                Text::fixed(
                    "M66 lee una entrada, que no está en el programa",
                    "M66 reads an input, which is not in the program",
                )
            } else {
                Text::fixed(
                    "M66 espera a una entrada: ese tiempo no está en la suma",
                    "M66 waits for an input: that time is not in the sum",
                )
            },
            Text::fixed("", ""),
        );
        Ok(())
    }

    /// True where a parameter holds what M66 has read.
    pub(super) fn is_input(&self, number: usize) -> bool {
        number == INPUT && self.input_read && !self.parameters.known(INPUT)
    }
}
