//! Outputs that a control has a use of its own for.

use crate::gcode::word::Word;

/// How a program holds the height control of a torch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HeightHold {
    /// By codes of the machine's builder, which the workbook names.
    Builder,
    /// By a digital output that goes on and off with the motion (M62, M63), by its number.
    Output(u32),
}

impl HeightHold {
    /// The block that holds the height, or lets it go; `None` where only the machine's builder knows it.
    #[must_use]
    pub fn words(self, on: bool) -> Option<Vec<Word>> {
        match self {
            Self::Builder => None,
            Self::Output(number) => Some(vec![Word::whole('M', if on { 62 } else { 63 }), Word::whole('P', number)]),
        }
    }
}
