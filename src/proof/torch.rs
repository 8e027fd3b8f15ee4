//! The torch: on over the feed moves and over no rapid move, from the text.

use crate::finding::Raise;
use crate::gcode::program::Program;
use crate::gcode::word::Word;
use crate::proof::check::{At, Check, Question};
use crate::proof::rules::TorchNotAsDue;
use crate::proof::step::{Judge, Step};
use crate::text::{Text, many, t};

/// Asks whether the torch burns in the cut only, by the codes that turn it on and off.
#[derive(Clone, Copy, Debug)]
pub struct Torch<'a>(pub Option<[&'a [Word]; 2]>);

impl Judge for Torch<'_> {
    fn see(&mut self, _: &Step<'_>) {}

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        vec![check(program, self.0)]
    }
}

/// The check that the torch burns over the feed moves and over no rapid move. Of a program without the codes that turn it on
/// and off, as the published one, the moves are only counted.
#[must_use]
pub fn check(program: &Program, codes: Option<[&[Word]; 2]>) -> Check {
    let name = t("Antorcha: encendida solo en el corte", "Torch: on in the cut only");
    let written = |codes: &[Word]| {
        let mut block = String::new();
        codes.iter().for_each(|word| word.write(program.format, &mut block));
        block
    };
    let codes = codes.map(|codes| codes.map(written));
    let (mut burning, mut line, mut cuts, mut wrong) = (false, 0, 0, None);
    let mut lines = program.lines();
    while let Some((_, text)) = lines.next() {
        line += 1;
        let text = unnumbered(text);
        let first = text.split(' ').next().unwrap_or_default();
        let rapid = matches!(first, "G0");
        let feed = matches!(first, "G1" | "G2" | "G3" | "G01" | "G02" | "G03");
        if let Some([on, off]) = &codes {
            burning = text == on || burning && text != off;
        }
        cuts += usize::from(feed);
        if feed != burning && (feed || rapid) {
            wrong.get_or_insert(line);
        }
    }
    if burning {
        wrong.get_or_insert(line);
    }
    let value = many(cuts, ["movimiento de corte", "movimientos de corte"], ["cutting move", "cutting moves"]);
    let asked = Question::new("torch", name, program).showing(value, Text::same("")).seen(cuts);
    if codes.is_none() {
        return asked.informs();
    }
    asked.at(wrong.map(At::line)).unless(wrong.map(|line| move |place| TorchNotAsDue { line }.at(place)))
}

/// A block without the number that a line may carry as it stands.
fn unnumbered(block: &str) -> &str {
    let numbered = |(number, rest)| number_of(number).then_some(rest);
    block.split_once(' ').and_then(numbered).unwrap_or(block)
}

/// True for a block number.
fn number_of(word: &str) -> bool {
    word.strip_prefix('N')
        .is_some_and(|digits| !digits.is_empty() && digits.bytes().all(|digit| digit.is_ascii_digit()))
}
