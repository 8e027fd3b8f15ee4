//! What a person must know before an impeller's program is started: rotary axes, clamps, spindle, coolant, and where the tool stands.

use crate::finding::{Finding, Raise, Size};
use crate::gcode::control::RotaryMode;
use crate::gcode::word::{Distance, Word};
use crate::kinds::impeller::design::{Design, Style};
use crate::kinds::impeller::parameters as form;
use crate::kinds::impeller::rules::{
    AnnexByIncrements, ClampsMissing, ClampsOfBuilder, IncrementsFromZero, NoCoolant, NoRetract, OnLinearAxes,
    OnLinearAxesUnproved, RetractByProgram, RetractElsewhere, RetractIsAssumed, SpindleNotStarted, TurnsByIncrements,
};
use crate::kinds::rules::corners_between_blocks;
use crate::parameter::at;

fn holds(words: &[Word], letter: char, number: u32) -> bool {
    words.iter().any(|word| *word == Word::whole(letter, number))
}

/// The remarks on how the programs begin.
pub(super) fn start(design: &Design) -> Vec<Finding> {
    let mut findings = vec![rotary_axes(design)];
    findings.extend(clamps(design));
    if !holds(&design.start_codes, 'M', 3) && !holds(&design.start_codes, 'M', 4) {
        findings.push(SpindleNotStarted {}.at(at([form::START_CODES.key()])));
    }
    if design.coolant.is_empty() {
        findings.push(NoCoolant {}.at(at([form::COOLANT.key()])));
    }
    if design.style == Style::Full {
        findings.extend(retract(design));
    }
    findings.extend(corners_between_blocks(design.post.control));
    findings
}

fn rotary_axes(design: &Design) -> Finding {
    let place = at([form::ROTARY.key(), form::DISTANCE.key()]);
    if design.style == Style::Annex {
        AnnexByIncrements {}.at(place)
    } else if design.turns_by_increments() {
        TurnsByIncrements {}.at(place)
    } else if design.distance == Distance::Incremental {
        IncrementsFromZero {}.at(place)
    } else {
        match design.post.control.rotary.delivered {
            RotaryMode::Rollover => OnLinearAxesUnproved {}.at(place),
            RotaryMode::Linear => OnLinearAxes {}.at(place),
        }
    }
}

/// What is to be known of the codes that release the clamps of the rotary axes in programs that were published for the control.
fn clamps(design: &Design) -> Option<Finding> {
    let published = design.post.writing.clamps;
    let missing: Vec<String> = published
        .iter()
        .filter(|&&number| !holds(&design.start_codes, 'M', number))
        .map(|number| format!("M{number}"))
        .collect();
    let place = at([form::START_CODES.key()]);
    let told = if missing.is_empty() {
        ClampsOfBuilder {}.at(place)
    } else {
        ClampsMissing { missing: missing.join(", ") }.at(place)
    };
    (!published.is_empty()).then_some(told)
}

fn retract(design: &Design) -> Vec<Finding> {
    let place = || at([form::RETRACT.key()]);
    if design.retract.0.is_empty() {
        return vec![NoRetract {}.at(place())];
    }
    let Some(z) = design.retract.z() else { return Vec::new() };
    if !design.retract.by_machine() {
        return vec![RetractByProgram { z: Size::mm(z) }.at(place())];
    }
    let mut findings = Vec::new();
    if design.post.writing.zero.told_of() {
        findings.push(RetractIsAssumed {}.at(place()));
    }
    if z != 0.0 {
        findings.push(RetractElsewhere { z: Size::mm(z) }.at(place()));
    }
    findings
}
