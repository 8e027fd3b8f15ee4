//! What the impeller's job has to say: refusals and remarks for a person.

use crate::finding::{Bare, Finding, Key, Limit, Place, Raise, Size};
use crate::kinds::impeller::clear::fields::OFFSET_F;
use crate::kinds::impeller::design::{Design, Style};
use crate::kinds::impeller::operation::Operation;
use crate::kinds::impeller::parameters as form;
use crate::kinds::impeller::programs::Programs;
use crate::kinds::impeller::rules::{
    AnnexIsRepeated, AnnexStartsAnywhere, AnnexWithoutFeed, BlankForFagor, CalibrationAgrees, CalibrationDiffers,
    FeedReduced, FeedWordAtItsEnd, LengthByOffset, NoRoomForSplitter, NothingCrosses, SlotsContradict, SpeedNotChecked,
    SplitterWithoutPoint, TravelNotChecked,
};
use crate::kinds::impeller::splitter::NoSplitter;
use crate::kinds::impeller::start::start;
use crate::machine::calibration::Axis as Calibrated;
use crate::number::shown;
use crate::parameter::at;
use crate::text::{Text, all_of, many, t};

pub(super) fn no_splitter(why: NoSplitter) -> Finding {
    let place = at([form::SPLITTERS.key(), form::N.key(), form::E.key(), form::D_T.key()]);
    match why {
        NoSplitter::NoCrossing => NothingCrosses {}.at(place),
        NoSplitter::AtFirstPoint => SplitterWithoutPoint {}.at(place),
        NoSplitter::NoRoom => NoRoomForSplitter {}.at(place),
    }
}

pub(super) fn no_calibration() -> Finding {
    SlotsContradict {}.at(at([form::CALIBRATION_X0.key(), form::CALIBRATION_Z0.key(), form::CALIBRATION_H.key()]))
}

/// What a person should know of the design and its programs.
pub(super) fn remarks(design: &Design, made: &Programs, calibrated: Option<Calibrated>) -> Vec<Finding> {
    let mut findings = Vec::new();
    if design.style == Style::Annex {
        findings.push(AnnexWithoutFeed {}.at(at([form::STYLE.key(), form::F.key(), form::S.key()])));
        findings.push(AnnexStartsAnywhere {}.at(at([form::STYLE.key()])));
        if design.splitters {
            let half = Size::degrees(180.0 / f64::from(design.N), 3);
            findings.push(AnnexIsRepeated { N: design.N, half }.at(at([form::STYLE.key(), form::SPLITTERS.key()])));
        }
    }
    findings.extend(start(design));
    if design.style == Style::Full && design.post.writing.tool.may_bring_length() {
        let own = [(design.D, form::D.key())].into_iter();
        let finishing = design.clear.as_ref().map(|asked| (asked.finish.D, OFFSET_F.key()));
        // One tool for both is called with one offset, whose cell is the first.
        let called: Vec<(u32, Key)> = own.chain(finishing.filter(|(D, _)| *D != design.D)).collect();
        let offsets = all_of(called.iter().map(|(D, _)| Text::same(format!("D{D}"))));
        let (may, those) = match called.len() {
            1 => (t("puede", "may"), t("ese corrector", "this offset")),
            _ => (t("pueden", "may"), t("esos correctores", "these offsets")),
        };
        let place = Place::Parameters(called.into_iter().map(|(_, key)| key).collect());
        findings.push(LengthByOffset { offsets, may, those }.at(place));
    }
    let ends = design.travel.iter().flat_map(|travel| travel.ends.into_iter().zip(travel.keys));
    let unchecked: Vec<Key> = ends.filter(|(end, _)| end.is_none()).map(|(_, key)| key).collect();
    if !unchecked.is_empty() {
        findings.push(TravelNotChecked { limits: unchecked.join(", ") }.at(Place::Parameters(unchecked)));
    }
    if design.F_max.is_none() {
        findings.push(SpeedNotChecked {}.at(at([form::F_MAX.key()])));
    }
    let counted = |moves| many(moves, ["movimiento", "movimientos"], ["move", "moves"]);
    let moves = made.limited.by_axis;
    if moves > 0 {
        let most = Size::feed(design.F_max.unwrap_or(0.0), 3);
        findings.push(FeedReduced { counted: counted(moves), moves, most }.at(at([form::F.key(), form::F_MAX.key()])));
    }
    let moves = made.limited.by_format;
    if moves > 0 {
        let (key, longer) = match design.clear {
            None => (form::INTERVALS_N.key(), t("un n menor", "a smaller n")),
            Some(_) => (form::TOL.key(), t("una tol mayor", "a larger tol")),
        };
        let told = FeedWordAtItsEnd { counted: counted(moves), moves, longer }.at(at([form::F.key(), key]));
        let greatest = shown(design.post.control.feed.law.greatest(), 3);
        findings.push(told.with(moves.to_string(), format!("0.0001 … {greatest}")));
    }
    findings.push(BlankForFagor {}.at(Place::Block { program: Operation::Blank.key(), line: 1 }));
    findings.extend(calibrated.map(|axis| calibration_remark(design, axis)));
    findings
}

/// Holds the calibrated spindle height against the one in use. Beyond 0.01 mm, the tenth part of what a slot shows to
/// the eye, a person must judge it.
fn calibration_remark(design: &Design, axis: Calibrated) -> Finding {
    let difference = axis.R_B - design.R_B;
    let [found, R_B] = [axis.R_B, design.R_B].map(|height| Size::length(height, 4));
    let B = Size::degrees(axis.B.to_degrees(), 5);
    let place = at([form::R_B.key()]);
    let told = if difference.abs() > 0.01 {
        CalibrationDiffers { found, B, R_B, better: Bare::mm(axis.R_B, 4) }.at(place)
    } else {
        CalibrationAgrees { found, B, R_B }.at(place)
    };
    let limit = Limit::Between { least: Some(-0.01), most: Some(0.01) };
    told.with(format!("{} mm", shown(difference, 4)), "0.01 mm").measuring(difference, limit)
}
