//! What the tests share: the published design and designs like it.
#![allow(dead_code, reason = "each test binary uses a part of it")]

use rodete::finding::Finding;
use rodete::gcode::dialect::FeedLaw;
use rodete::gcode::motion::{Feed, Kind, Motion};
use rodete::gcode::program::Program;
use rodete::impeller::blade::Blade;
use rodete::impeller::cases::CASES;
use rodete::impeller::design::Design;
use rodete::impeller::parameters::FORM;
use rodete::job::{self, Outcome, Source};
use rodete::machine::axis::{Axis, Pose, Position};
use rodete::number::grid::Milli;
use rodete::parameter::{Value, Values};
use rodete::text::Language;

/// The values of a shipped case, some of them replaced.
pub fn values(case: &str, changes: &[(&'static str, Value)]) -> Values {
    let case = CASES.iter().find(|one| one.name == case).expect("a shipped case");
    let mut values = Values { language: Language::En, ..Values::default() };
    values.values.extend(case.values(Language::En));
    values.values.extend(changes.iter().cloned());
    values
}

pub fn source() -> Source {
    Source { workbook: "impeller.xlsx".to_owned(), sha256: "0123456789abcdef".repeat(4), version: "0.0.0" }
}

/// The outcome of a shipped case, some of its values replaced.
pub fn outcome(case: &str, changes: &[(&'static str, Value)]) -> Outcome {
    match job::run(&FORM, values(case, changes), source()) {
        Ok(outcome) => outcome,
        Err(refusal) => panic!("refused: {:?}", refusal.findings),
    }
}

/// The text of a program of an outcome.
pub fn program(outcome: &Outcome, key: &str) -> String {
    outcome.programs.iter().find(|program| program.key == key).expect("the program").text()
}

/// The blade of a design.
pub fn blade(design: &Design) -> Blade {
    Blade::new(design.torus, design.n, design.eps_v, design.machine)
}

/// The positions that a program's text goes through, read word by word on the output grid: a second opinion on the
/// text, independent of what wrote it.
pub fn read_back(text: &str, start: Position) -> Vec<Position> {
    let mut at = start;
    let mut absolute = true;
    let mut positions = Vec::new();
    for line in text.lines().filter(|line| !line.starts_with([';', '(', '%'])) {
        let mut moves = false;
        for word in line.split_whitespace() {
            let (letter, number) = word.split_at(1);
            match (letter, number) {
                ("G", "90") => absolute = true,
                ("G", "91") => absolute = false,
                _ => {}
            }
            let Some(axis) = Axis::ALL.into_iter().find(|axis| letter.starts_with(axis.letter())) else { continue };
            let size = Milli::round(number.parse().expect("a number")).expect("on the grid");
            at = if absolute { at.with(axis, size) } else { at.moved(axis, size) };
            moves = true;
        }
        if moves {
            positions.push(at);
        }
    }
    positions
}

/// The motions that a program's text gives, from all axes at 0: a small reader of its own, word by word.
pub fn motions(text: &str, program: &Program) -> Vec<Result<Motion, Box<Finding>>> {
    let mut at = Pose::default();
    let (mut absolute, mut rapid, mut per_minute, mut F) = (true, false, true, None);
    let mut motions = Vec::new();
    for (index, line) in text.lines().enumerate().filter(|(_, line)| !line.starts_with([';', '(', '%'])) {
        let (from, mut n, mut moves) = (at, None, false);
        for word in line.split_whitespace() {
            let (letter, number) = word.split_at(1);
            let Ok(value) = number.parse::<f64>() else { continue };
            match (letter, number) {
                ("N", _) => n = number.parse().ok(),
                ("G", "90") => absolute = true,
                ("G", "91") => absolute = false,
                ("G", "0") => rapid = true,
                ("G", "1") => rapid = false,
                ("G", "93") => per_minute = false,
                ("G", "94") => per_minute = true,
                ("F", _) => F = Some(value),
                _ => {}
            }
            if let Some(axis) = Axis::ALL.into_iter().find(|axis| letter.starts_with(axis.letter())) {
                at.set(axis, if absolute { value } else { at.get(axis) + value });
                moves = true;
            }
        }
        if moves {
            let way = at.differences(&from).iter().map(|by| by * by).sum::<f64>().sqrt();
            let law = if per_minute { FeedLaw::Resultant } else { program.dialect.feed };
            let seconds = F.filter(|_| !rapid).map(|F| law.seconds(F, way));
            let kind = if rapid { Kind::Rapid } else { Kind::Feed(Feed::default()) };
            motions.push(Ok(Motion { line: index + 1, n, kind, from, to: at, machine: at, seconds }));
        }
    }
    motions
}
