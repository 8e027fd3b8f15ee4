//! Turning the torus with a cycle of a curved section, G85, after facing.
//!
//! # References
//! The thesis, section 4.1: G85 X = 2R, Z = −r, Q = 2(R − r), R = 0, C = step, I = 0, K = r. Its table prints Z = −R; its
//! program has −15, which is −r.

use crate::gcode::code::LetterCycle;
use crate::gcode::control::Post;
use crate::gcode::program::Program;
use crate::gcode::turning::fagor::Along;
use crate::gcode::word::{NumberFormat, Word};
use crate::gcode::writer::Writer;
use crate::geometry::torus::Torus;
use crate::kinds::impeller::operation::Operation;
use crate::kinds::impeller::parameters as form;
use crate::machine::axis::Position;
use crate::number::grid::{Milli, OutOfFormat};
use crate::parameter::field::Fields;
use crate::text::t;

/// How far from the stock the tool ends where the form does not say it, on the diameter: the published end X of 80 for R = 25.
const END_CLEARANCE: f64 = 30.0;

/// The cycle of the thesis.
const QUARTER: LetterCycle = LetterCycle::Curved(Along::Face);

/// The lathe that the program is written for, whatever the mill's control: one that has the cycle.
pub const POST: Post = Post::turning_with(QUARTER);

/// How the blank is turned. Lengths in mm; those named "on the diameter" are programmed so.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlankTurning {
    /// C, step of the cycle along Z, and the facing allowance.
    pub C: f64,
    /// Feed, mm a revolution.
    pub F_b: f64,
    /// Constant surface speed, m/min.
    pub S_b: u32,
    /// Tool number.
    pub T_b: u32,
    /// Offset number.
    pub D_b: u32,
    /// Length of the stock, mm, from the turned face (Z 0) down: the facing takes C off beside it.
    pub L_b: f64,
    /// Z of the approach, mm over the turned face (Z 0).
    pub Z_b: f64,
    /// Clearance for facing, on the diameter.
    pub c_f: f64,
    /// Overrun past the centre, on the diameter.
    pub c_o: f64,
    /// Clearance before the cycle, on the diameter.
    pub c_c: f64,
    /// End X, on the diameter: that of the form, else 2·R + 30.
    pub X_e: f64,
    /// Z at which the tool ends, mm over the turned face.
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
            X_e: fields.get(&form::X_E).unwrap_or_else(|| 2.0 * fields.get(&form::R) + END_CLEARANCE),
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
        let mut writer = Writer::new(POST, Vec::new());
        let size = |letter: char, value: f64| Ok::<_, OutOfFormat>(Word::size(letter, Milli::round(value)?));
        let g = |number| Word::whole('G', number);
        let full = format == NumberFormat::Fixed;
        let state = [g(71), g(90), g(95)];
        let turning = [Word::whole('S', self.S_b), Word::whole('M', 4)];
        let start = [writer.diameter(2.0 * R)?, size('Z', self.Z_b)?];
        let approach = [writer.diameter(2.0 * R + self.c_f)?, size('Z', 0.0)?];
        let mut facing = vec![g(1), writer.diameter(-self.c_o)?, size('F', self.F_b)?];
        if full {
            writer.block(state);
            writer.tool(self.T_b, self.D_b);
            if let Some(S_m) = self.S_m {
                writer.block([g(92), Word::whole('S', S_m)]);
            }
            writer.block([&[g(96)], turning.as_slice()].concat());
            writer.rapid(start);
            writer.rapid(approach);
        } else {
            let [speed, spindle] = turning;
            writer.rapid([state.as_slice(), &[g(96)], &start, &[spindle]].concat());
            writer.tool(self.T_b, self.D_b);
            writer.block(approach);
            facing.push(speed);
        }
        writer.block(facing);
        writer.rapid([writer.diameter(2.0 * R + self.c_c)?, size('Z', 0.0)?]);
        writer.block([
            g(QUARTER.number().into()),
            writer.diameter(2.0 * R)?,
            size('Z', -r)?,
            size('Q', 2.0 * (R - r))?,
            size('R', 0.0)?,
            size('C', self.C)?,
            size('I', 0.0)?,
            size('K', r)?,
        ]);
        writer.rapid([writer.diameter(self.X_e)?, size('Z', self.Z_e)?]);
        writer.block([Word::whole('M', 30)]);
        Ok(Program {
            key: Operation::Blank.key(),
            title: t("Torneado del bruto", "Turning of the blank"),
            control: writer.control(),
            law: writer.law(),
            format,
            block_step: Some(block_step),
            start: Position::default(),
            parts: writer.finish(),
        })
    }
}
