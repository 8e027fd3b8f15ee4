//! Passes: every blade and splitter is cut once on both sides.

use crate::finding::Raise;
use crate::gcode::program::Program;
use crate::kinds::impeller::proof::rules::PassesDiffer;
use crate::kinds::impeller::proof::track_step::TrackStep;
use crate::kinds::impeller::track::Track;
use crate::proof::check::{Check, Question};
use crate::proof::step::{Judge, Step};
use crate::text::{Text, t};

/// How many passes of each track there are.
pub type PassCount = [usize; 4];

/// Counts the passes of a program.
#[derive(Debug)]
pub struct Passes {
    due: PassCount,
    made: PassCount,
}

impl Passes {
    /// The judge of a program that should make these passes.
    #[must_use]
    pub const fn new(due: PassCount) -> Self {
        Self { due, made: [0; 4] }
    }
}

impl Judge for Passes {
    fn see(&mut self, step: &Step<'_>) {
        if let Some(cut) = TrackStep::of(step)
            && cut.leaves()
            && let Some(made) = Track::ALL.iter().position(|track| *track == cut.track)
        {
            self.made[made] += 1;
        }
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        let Self { due, made } = *self;
        let list = |passes: PassCount| passes.map(|count| count.to_string()).join(" + ");
        let name = t(
            "Pasadas: anverso + reverso + intermedio, ida + vuelta",
            "Passes: obverse + reverse + splitter, out + back",
        );
        let asked = Question::new("passes", name, program).showing(Text::same(list(made)), Text::same(list(due)));
        // What is due is looked for: a program without a pass has too few.
        vec![asked.seen(due.iter().sum()).holds(made == due, |place| {
            PassesDiffer { program: program.title.clone(), made: list(made), due: list(due) }.at(place)
        })]
    }
}
