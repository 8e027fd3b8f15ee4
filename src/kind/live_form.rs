//! What a form computes while it is being filled in: derived limits, whether they hold, and a view of the part.
//!
//! Formulas stand over the defined names of the form's cells. They know the closed limits alone: what is searched for, the
//! solids and the motions are judged by `rodete check`.

use crate::table::{Formula, Unit};
use crate::text::Text;

/// The live part of a form.
#[derive(Clone, Debug)]
pub struct LiveForm {
    /// The defined names of the inputs that must be numbers before anything is computed.
    pub inputs: &'static [&'static str],
    /// What must hold between them before anything is computed, and the words for it where it does not.
    pub sound: (&'static str, Text),
    /// The derived values, one a row.
    pub rows: Vec<LiveRow>,
    /// The view of the part.
    pub view: LiveView,
}

/// A derived value.
#[derive(Clone, Debug)]
pub struct LiveRow {
    /// The symbol, as in the source.
    pub symbol: &'static str,
    /// The defined name of its cell.
    pub name: &'static str,
    /// The unit.
    pub unit: Unit,
    /// What it is, while it is right.
    pub meaning: Text,
    /// What it is computed by.
    pub formula: &'static str,
    /// When something is wrong with it.
    pub wrong: Option<Wrong>,
}

/// A limit that is broken.
#[derive(Clone, Debug)]
pub struct Wrong {
    /// The formula that is true where it is.
    pub when: &'static str,
    /// What is said of it.
    pub words: Text,
    /// The defined name of the input that is to be changed.
    pub input: &'static str,
}

/// A view of the part, scaled to a circle of radius 1, on a hidden sheet.
#[derive(Clone, Debug)]
pub struct LiveView {
    /// Its title.
    pub title: Text,
    /// The columns of the sheet, from A; each a formula a row, from row 1. Formulas may refer to cells of this sheet.
    pub columns: Vec<Vec<Formula>>,
    /// The curves.
    pub curves: Vec<LiveCurve>,
}

/// A curve of a view: a line without gaps, of two columns.
#[derive(Clone, Copy, Debug)]
pub struct LiveCurve {
    /// The columns of x and y, from 0.
    pub columns: [usize; 2],
    /// What it is drawn as.
    pub look: LiveLook,
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LiveLook {
    /// The part.
    Part,
    /// What stands between.
    Dashed,
    /// An outline.
    Faint,
}
