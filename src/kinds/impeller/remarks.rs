//! What the impeller's job has to say: refusals and remarks for a person.

use crate::finding::{Finding, Place, Raise, Size};
use crate::kinds::impeller::design::{Design, Style};
use crate::kinds::impeller::operation::Operation;
use crate::kinds::impeller::programs::Programs;
use crate::kinds::impeller::rules::{
    AnnexIsRepeated, AnnexStartsAnywhere, AnnexWithoutFeed, BlankForFagor, CalibrationAgrees, CalibrationDiffers,
    FeedReduced, FeedWordAtItsEnd, NoRoomForSplitter, NotNumbered, NothingCrosses, SlotsContradict, SpeedNotChecked,
    SplitterWithoutPoint, TravelNotChecked,
};
use crate::kinds::impeller::splitter::NoSplitter;
use crate::kinds::impeller::start::start;
use crate::machine::calibration::Axis as Calibrated;
use crate::number::shown;
use crate::text::t;

pub(super) fn no_splitter(why: NoSplitter) -> Finding {
    let place = Place::Parameters(vec!["splitters", "N", "e", "d_t"]);
    match why {
        NoSplitter::NoCrossing => NothingCrosses {}.at(place),
        NoSplitter::AtFirstPoint => SplitterWithoutPoint {}.at(place),
        NoSplitter::NoRoom => NoRoomForSplitter {}.at(place),
    }
}

pub(super) fn no_calibration() -> Finding {
    SlotsContradict {}.at(Place::Parameters(vec!["calibration/x0", "calibration/z0", "calibration/H"]))
}

/// What a person should know of the design and its programs.
pub(super) fn remarks(design: &Design, made: &Programs, calibrated: Option<Calibrated>) -> Vec<Finding> {
    let mut findings = Vec::new();
    let at = |keys: &[&'static str]| Place::Parameters(keys.to_vec());
    if design.style == Style::Annex {
        findings.push(AnnexWithoutFeed {}.at(at(&["style", "F", "S"])));
        findings.push(AnnexStartsAnywhere {}.at(at(&["style"])));
        if design.splitters {
            let half = Size { value: 180.0 / f64::from(design.N), unit: "°", decimals: 3 };
            findings.push(AnnexIsRepeated { N: design.N, half }.at(at(&["style", "splitters"])));
        }
    }
    findings.extend(start(design));
    let unchecked: Vec<&'static str> =
        [("X_min", 0, 0), ("X_max", 0, 1), ("Y_min", 1, 0), ("Y_max", 1, 1), ("Z_min", 2, 0), ("Z_max", 2, 1)]
            .into_iter()
            .filter(|&(_, axis, end)| design.travel[axis].1[end].is_none())
            .map(|(key, ..)| key)
            .collect();
    if !unchecked.is_empty() {
        findings.push(TravelNotChecked { limits: unchecked.join(", ") }.at(at(&unchecked)));
    }
    if design.F_max.is_none() {
        findings.push(SpeedNotChecked {}.at(at(&["F_max"])));
    }
    let moves = made.limited.by_axis;
    if moves > 0 {
        let most = Size::number(design.F_max.unwrap_or(0.0), 3);
        findings.push(FeedReduced { moves, most }.at(at(&["F", "F_max"])));
    }
    let moves = made.limited.by_format;
    if moves > 0 {
        let (key, longer) = match design.clear {
            None => ("n", t("un n menor", "a smaller n")),
            Some(_) => ("tol", t("una tol mayor", "a larger tol")),
        };
        let told = FeedWordAtItsEnd { moves, longer }.at(at(&["F", key]));
        let greatest = shown(design.control.feed.law.greatest(), 3);
        findings.push(told.with(moves.to_string(), format!("0.0001 … {greatest}")));
    }
    for key in &made.unnumbered {
        let told = NotNumbered { greatest: design.control.text.greatest_number };
        findings.push(told.at(Place::Block { program: key, line: 1 }));
    }
    findings.push(BlankForFagor {}.at(Place::Block { program: Operation::Blank.key(), line: 1 }));
    findings.extend(calibrated.map(|axis| calibration_remark(design, axis)));
    findings
}

/// Holds the calibrated spindle height against the one in use. Beyond 0.01 mm, the tenth part of what a slot shows to
/// the eye, a person must judge it.
fn calibration_remark(design: &Design, axis: Calibrated) -> Finding {
    let difference = axis.R_B - design.R_B;
    let [found, R_B] = [axis.R_B, design.R_B].map(|height| Size { decimals: 4, ..Size::mm(height) });
    let B = Size { value: axis.B.to_degrees(), unit: "°", decimals: 5 };
    let place = Place::Parameters(vec!["R_B"]);
    let told = if difference.abs() > 0.01 {
        CalibrationDiffers { found, B, R_B, better: Size::number(axis.R_B, 4) }.at(place)
    } else {
        CalibrationAgrees { found, B, R_B }.at(place)
    };
    told.with(format!("{} mm", shown(difference, 4)), "0.01 mm")
}
