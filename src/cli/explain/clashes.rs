//! The codes of a binary: each is one row's alone, with the letter of a room.

use super::every;
use super::findings::ROOMS;
use crate::finding::{Exit, Finding, Place, Raise, Refusal, Rule};
use crate::kind::Kind;
use crate::kind::rules::{CodeTwice, CodeWithoutRoom};
use crate::text::Text;

/// Whether the codes of a binary with these kinds can be told apart: `explain` knows a row by its code alone.
///
/// # Errors
/// A refusal with each code that is two rows', and each that is not the letter of a room and four digits.
pub fn codes(kinds: &[&dyn Kind]) -> Result<(), Refusal> {
    let rows = every(kinds);
    let twice = rows.windows(2).filter(|pair| pair[0].code == pair[1].code && !alike(pair[0], pair[1])).map(|pair| {
        let [one, other] = [pair[0], pair[1]].map(named);
        CodeTwice { code: pair[0].code, one, other }.at(Place::File)
    });
    let letters = || ROOMS.iter().map(|(letter, _)| *letter).collect::<Vec<_>>().join(", ");
    let astray = rows
        .iter()
        .filter(|rule| !with_room(rule.code))
        .map(|rule| CodeWithoutRoom { code: rule.code, letters: letters() }.at(Place::File));
    let findings: Vec<Finding> = twice.chain(astray).collect();
    if findings.is_empty() { Ok(()) } else { Err(Refusal { exit: Exit::Fault, findings }) }
}

/// A row by its name and what it says.
fn named(rule: &Rule) -> Text {
    let (name, Text { es, en }) = (rule.name(), rule.unfilled_what());
    Text::new(format!("{name} («{es}»)"), format!("{name} (\"{en}\")"))
}

/// True for one row that several kinds list.
fn alike(rule: &Rule, other_rule: &Rule) -> bool {
    rule.ident == other_rule.ident && rule.what == other_rule.what && rule.fields == other_rule.fields
}

/// True for the letter of a room and four digits.
fn with_room(code: &str) -> bool {
    let digits = |rest: &str| rest.len() == 4 && rest.bytes().all(|byte| byte.is_ascii_digit());
    ROOMS.iter().any(|(letter, _)| code.strip_prefix(letter).is_some_and(digits))
}
