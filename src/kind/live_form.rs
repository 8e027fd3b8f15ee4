//! What a form computes while it is being filled in: derived limits, whether they hold, and a view of the part.
//!
//! Formulas stand over the defined names of the form's cells. They know the closed limits alone: what is searched for, the
//! solids and the motions are judged by `rodete check`.

use crate::parameter::Choice;
use crate::parameter::field::Chosen;
use crate::table::{Formula, Unit};
use crate::text::Text;

/// What a form computes on its own sheet while it is filled in, without rodete.
#[derive(Clone, Debug)]
pub struct LiveForm {
    /// The defined names of the inputs that must be numbers within their ranges before anything is computed.
    pub inputs: &'static [&'static str],
    /// What must not be between them before anything is computed.
    pub unsound: Vec<Wrong>,
    /// When limits stand here that do not decide, and what is said then in place of their holding.
    pub undecided: Option<(&'static str, Text)>,
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
    /// The unit that stands behind the value.
    pub unit: Unit,
    /// What it is, while it is right.
    pub meaning: Text,
    /// What it is computed by.
    pub formula: Formula,
    /// True where it is computed even while inputs are missing: it says itself what is missing.
    pub always: bool,
    /// When something is wrong with it; the first one that is true is told.
    pub wrong: Vec<Wrong>,
    /// When it decides nothing, and what is said then: it is not green, whether it is wrong or not.
    pub undecided: Option<(&'static str, Text)>,
}

impl LiveRow {
    /// A value of millimetres, computed as soon as the inputs are there, with no limit.
    #[must_use]
    pub fn length(symbol: &'static str, name: &'static str, meaning: Text, formula: impl Into<Formula>) -> Self {
        let (formula, unit) = (formula.into(), Unit::Millimetre);
        Self { symbol, name, unit, meaning, formula, always: false, wrong: Vec::new(), undecided: None }
    }

    /// The same in another unit.
    #[must_use]
    pub fn unit(self, unit: Unit) -> Self {
        Self { unit, ..self }
    }

    /// The same, computed even while inputs are missing.
    #[must_use]
    pub fn always(self) -> Self {
        Self { always: true, ..self }
    }

    /// The same with a limit: when it is broken, the words for it, and the input that is to be changed.
    #[must_use]
    pub fn wrong(mut self, when: impl Into<Formula>, words: Text, input: &'static str) -> Self {
        self.wrong.push(Wrong::new(when, words, input));
        self
    }

    /// The same where it decides nothing under some condition, with the words that say so.
    #[must_use]
    pub fn undecided(self, when: &'static str, words: Text) -> Self {
        Self { undecided: Some((when, words)), ..self }
    }
}

/// The text of a cell as a formula, every blank in it a plain one: TRIM takes no notice of those that do not break, of tabs and of
/// line breaks, which part words, too.
#[must_use]
pub fn parted(cell: &str) -> String {
    ["\"\u{a0}\"", "CHAR(9)", "CHAR(10)", "CHAR(13)"]
        .iter()
        .fold(cell.to_owned(), |text, blank| format!("SUBSTITUTE({text},{blank},\" \")"))
}

/// True as a formula where a cell holds a word, in small letters, as `rodete check` reads it: capitals and blanks around it do not
/// count, and a number is its digits.
#[must_use]
pub fn says(cell: &str, word: &str) -> String {
    // TRIM makes two blanks between words one, and those count.
    if word.contains(' ') {
        format!("AND(TRIM({cell})=\"{word}\",ISNUMBER(FIND(\"{word}\",LOWER({cell}))))")
    } else {
        format!("TRIM({cell})=\"{word}\"")
    }
}

/// True as a formula where a cell holds a choice, by any of its words, with their accents.
#[must_use]
pub fn holds<T: Chosen + PartialEq>(cell: &str, choice: T) -> String {
    let words = T::CHOICES.iter().filter(|one| T::of(one.key) == Some(choice)).flat_map(Choice::words);
    let mut words: Vec<String> = words.map(str::to_lowercase).collect();
    words.sort();
    words.dedup();
    let said: Vec<String> = words.iter().map(|word| says(cell, word)).collect();
    match said.as_slice() {
        [one] => one.clone(),
        _ => format!("OR({})", said.join(",")),
    }
}

/// A limit that is broken.
#[derive(Clone, Debug)]
pub struct Wrong {
    /// The formula that is true where it is.
    pub when: Formula,
    /// What is said of it.
    pub words: Text,
    /// The defined name of the input that is to be changed.
    pub input: &'static str,
}

impl Wrong {
    /// A limit that is broken where a formula is true, with the words for it and the input that is to be changed.
    #[must_use]
    pub fn new(when: impl Into<Formula>, words: Text, input: &'static str) -> Self {
        Self { when: when.into(), words, input }
    }
}

/// A view of the part on a hidden sheet, scaled so that it is 2 wide about the origin.
#[derive(Clone, Debug)]
pub struct LiveView {
    /// Its title.
    pub title: Text,
    /// How high it is for its width.
    pub height: f64,
    /// The formula that is true where there is something to draw.
    pub drawn: &'static str,
    /// The columns of the sheet, from A; each a formula a row, from row 1. Formulas may refer to cells of this sheet, and to all
    /// cells of a list's column as `[tools.Q_x]`.
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
    /// The part, in a strong line.
    Part,
    /// What stands between.
    Dashed,
    /// An outline, thin and grey.
    Faint,
}
