//! Turning the torus with the Fagor cycle G85 after facing.
//!
//! # References
//! The thesis, section 4.1: G85 X = 2R, Z = −r, Q = 2(R − r), R = 0, C = step, I = 0, K = r. Its table prints Z = −R; its
//! program has −15, which is −r.

use crate::gcode::control::FAGOR_8055_T;
use crate::gcode::program::{Part, Program};
use crate::gcode::word::{NumberFormat, Word};
use crate::geometry::torus::Torus;
use crate::kinds::impeller::parameters as form;
use crate::machine::axis::Position;
use crate::number::grid::{Milli, OutOfFormat};
use crate::parameter::field::Fields;
use crate::text::t;

/// How the blank is turned. Lengths in mm; those named "on the diameter" are programmed so.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlankTurning {
    /// C, step of the cycle, on the radius.
    pub C: f64,
    /// Feed, mm a revolution.
    pub F_b: f64,
    /// Constant surface speed, m/min.
    pub S_b: u32,
    /// Tool number.
    pub T_b: u32,
    /// Offset number.
    pub D_b: u32,
    /// Length of the stock.
    pub L_b: f64,
    /// Approach Z.
    pub Z_b: f64,
    /// Clearance for facing, on the diameter.
    pub c_f: f64,
    /// Overrun past the centre, on the diameter.
    pub c_o: f64,
    /// Clearance before the cycle, on the diameter.
    pub c_c: f64,
    /// End X, on the diameter.
    pub X_e: f64,
    /// End Z.
    pub Z_e: f64,
    /// Greatest spindle speed under constant surface speed, rpm.
    pub S_m: Option<u32>,
}

impl BlankTurning {
    /// The turning of a filled-in form.
    #[must_use]
    pub fn of(fields: &Fields) -> Self {
        Self {
            C: fields.get(&form::C),
            F_b: fields.get(&form::F_B),
            S_b: fields.get(&form::S_B),
            T_b: fields.get(&form::T_B),
            D_b: fields.get(&form::D_B),
            L_b: fields.get(&form::L_B),
            Z_b: fields.get(&form::Z_B),
            c_f: fields.get(&form::C_F),
            c_o: fields.get(&form::C_O),
            c_c: fields.get(&form::C_C),
            X_e: fields.get(&form::X_E),
            Z_e: fields.get(&form::Z_E),
            S_m: fields.get(&form::S_M),
        }
    }

    /// The turning program. In the published layout its start and end codes, `M4` and `M30`, are those of the source;
    /// the full layout adds a header, an S limit where one is given, and the speed before the spindle starts.
    ///
    /// # Errors
    /// For a dimension that no program may carry.
    pub fn program(&self, torus: Torus, format: NumberFormat, block_step: u32) -> Result<Program, OutOfFormat> {
        let Torus { R, r } = torus;
        let size = |letter: char, value: f64| Ok::<_, OutOfFormat>(Word::size(letter, Milli::round(value)?));
        let g = |number| Word::whole('G', number);
        let block = |words: Vec<Word>| Part::Block(words);
        let mut parts: Vec<Part> = Vec::new();
        let full = format == NumberFormat::Fixed;
        let state = [g(0), g(71), g(90), g(95), g(96)];
        let tool = vec![Word::whole('T', self.T_b), Word::whole('D', self.D_b)];
        if full {
            parts.push(block(state[1..4].to_vec()));
            parts.push(block(tool));
            if let Some(S_m) = self.S_m {
                parts.push(block(vec![g(92), Word::whole('S', S_m)]));
            }
            parts.push(block(vec![g(96), Word::whole('S', self.S_b), Word::whole('M', 4)]));
            parts.push(block(vec![g(0), size('X', 2.0 * R)?, size('Z', self.Z_b)?]));
        } else {
            let mut first = state.to_vec();
            first.extend([size('X', 2.0 * R)?, size('Z', self.Z_b)?, Word::whole('M', 4)]);
            parts.push(block(first));
            parts.push(block(tool));
        }
        let approach = [size('X', 2.0 * R + self.c_f)?, size('Z', 0.0)?];
        parts.push(block(if full { [vec![g(0)], approach.to_vec()].concat() } else { approach.to_vec() }));
        let mut facing = vec![g(1), size('X', -self.c_o)?, size('F', self.F_b)?];
        if !full {
            facing.push(Word::whole('S', self.S_b));
        }
        parts.push(block(facing));
        parts.push(block(vec![g(0), size('X', 2.0 * R + self.c_c)?, size('Z', 0.0)?]));
        parts.push(block(vec![
            g(85),
            size('X', 2.0 * R)?,
            size('Z', -r)?,
            size('Q', 2.0 * (R - r))?,
            size('R', 0.0)?,
            size('C', self.C)?,
            size('I', 0.0)?,
            size('K', r)?,
        ]));
        parts.push(block(vec![g(0), size('X', self.X_e)?, size('Z', self.Z_e)?]));
        parts.push(block(vec![Word::whole('M', 30)]));
        Ok(Program {
            key: "blank",
            title: t("Torneado del bruto", "Turning of the blank"),
            control: &FAGOR_8055_T,
            format,
            block_step: Some(block_step),
            start: Position::default(),
            parts,
        })
    }
}
