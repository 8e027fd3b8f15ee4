//! Roughing along Z (G71) and along X (G72), Fanuc system A.
//!
//! # References
//! Fanuc Series 0i-TF and 30i, operator's manual for lathe systems, multiple repetitive cycles G71 and G72, types I and II;
//! the article on the lathe simulator, figures 17 and 18.
//!
//! # The passes
//! From the starting point A the tool goes to C = A + (U, W). Each pass lies one depth of cut below the last, from the level
//! of C on; the last goes as deep as the contour moved by (U, W). It runs parallel to the axis as far as the moved contour.
//! In type I the tool then leaves at 45 degrees by the retraction R and returns at rapid. In type II it follows the moved
//! contour up to the level of the pass before, leaves across the passes by R, and returns at rapid; a pocket is entered
//! along its near wall, and is cut to its bottom before the next one. At the end the tool runs once along the moved
//! contour, and returns to A by the level of C.
//!
//! # Left open, and chosen here
//! The retraction is at rapid. The last pass of a level is as deep as is left. What a pass leaves over (less than a depth of
//! cut) falls to the pass along the contour. Between the level of C and the first point of a contour of type II the passes go
//! no deeper than that point. The way back to A goes by the level of C, so that it crosses nothing.

use crate::finding::Size;
use crate::gcode::turning::Move;
use crate::gcode::turning::profile::Profile;
use crate::gcode::turning::rules::{
    AllowanceIntoMetal, ContourBackAlongX, ContourBackAlongZ, ContourBeginsWithArc, ContourBeyondStart,
    ContourDoesNotAdvance, ContourEntersAside, ContourNotFound, CycleNotFinite, NoDepthOfCut, RetractionNegative,
    TooManyRoughingPasses,
};
use crate::gcode::turning::scan::{EPS, PassFrame, Path, Span, moved};
use crate::gcode::turning::tool::CycleMoves;
use crate::gcode::turning::trouble::Trouble;
use crate::limits::{ROUGHING_PASSES, ROUGHING_WORK};

/// The least input increment of a control, mm: by so much a contour may go back, and no pass is shorter.
const TOLERANCE: f64 = 0.001;

/// The parameters of a roughing cycle. Lengths in mm, X on the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rough {
    /// The depth of cut: U of the first block of G71, W of G72.
    pub depth: f64,
    /// R, the retraction after each pass.
    pub retract: f64,
    /// The finishing allowance along X, on the radius, signed: half of U of the second block.
    pub U: f64,
    /// The finishing allowance along Z, signed.
    pub W: f64,
    /// F of the cycle; none for the one in force.
    pub feed: Option<f64>,
    /// Whether the first block of the contour names both axes (type II); none where only its motion tells.
    pub both_axes: Option<bool>,
}

/// G71: passes parallel to Z.
///
/// # Errors
/// PS0062 for a depth of cut that is not above 0, PS0065 for a contour that begins with an arc, PS0322 for one that reaches
/// beyond the starting point, PS0064 and PS0329 for one that goes back along Z or X (X: type I alone), and refusals without a
/// number for allowances towards the metal, for a contour without extent and for more than [`ROUGHING_PASSES`] passes.
pub fn axial(profile: &Profile, rough: &Rough) -> Result<Vec<Move>, Box<Trouble>> {
    expand(profile, rough, [1, 0])
}

/// G72: passes parallel to X.
///
/// # Errors
/// As for [`axial`], with X and Z exchanged.
pub fn radial(profile: &Profile, rough: &Rough) -> Result<Vec<Move>, Box<Trouble>> {
    expand(profile, rough, [0, 1])
}

/// The alarm for a contour that goes back along X (0) or Z (1).
fn goes_back(axis: usize) -> Box<Trouble> {
    if axis == 0 { Trouble::of(&ContourBackAlongX {}) } else { Trouble::of(&ContourBackAlongZ {}) }
}

/// The alarm for a contour whose first block goes along the passes alone.
fn aside([along, _]: [usize; 2]) -> Box<Trouble> {
    let (cycle, axis, other) = if along == 1 { (71, 'X', 72) } else { (72, 'Z', 71) };
    Trouble::of(&ContourEntersAside { cycle, axis, other })
}

/// True where the first block goes along the passes alone, and no signs of the allowances put that right.
fn enters_aside(profile: &Profile, rough: &Rough, axes: [usize; 2]) -> bool {
    let Some(first) = profile.elements.first() else { return false };
    let [along, across] = axes.map(|axis| (first.to[axis] - profile.start[axis]).abs() > EPS);
    let fits = |signs: [f64; 2]| {
        let by = [signs[0] * rough.U, signs[1] * rough.W];
        let Ok(frame) = frame(profile, &Rough { U: by[0], W: by[1], ..*rough }, axes) else { return false };
        let shift = frame.inward(by);
        let [[_, right], _] = Path::of(profile, frame, shift).reach();
        shift.iter().all(|&allowance| allowance >= -EPS)
            && right <= frame.inward(profile.start)[0] + shift[0] + TOLERANCE
    };
    along && !across && ![[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]].into_iter().any(fits)
}

/// The drawing of a cycle: the axis of the passes and the axis of the depth as given, the signs from where the contour lies.
fn frame(profile: &Profile, rough: &Rough, axes: [usize; 2]) -> Result<PassFrame, Box<Trouble>> {
    let plain = PassFrame { axes, signs: [1.0; 2] };
    let (Some(first), Some(last)) = (profile.elements.first(), profile.elements.last()) else {
        return Err(Trouble::of(&ContourNotFound {}));
    };
    let path = Path::of(profile, plain, [0.0; 2]);
    let (start, from, to) = (plain.inward(profile.start), plain.inward(first.to), plain.inward(last.to));
    let [_, [low, high]] = path.reach();
    let along = to[0] - from[0];
    if profile.elements.len() < 2 || along.abs() < EPS {
        return Err(Trouble::of(&ContourDoesNotAdvance {}).at(last.line));
    }
    let allowance = plain.inward([rough.U, rough.W])[1];
    let height = if high <= start[1] + TOLERANCE && (low < start[1] - TOLERANCE || allowance >= 0.0) {
        1.0
    } else if low >= start[1] - TOLERANCE {
        -1.0
    } else {
        return Err(Trouble::of(&ContourBeyondStart {}).at(beyond(profile, plain, start[1], from[1] <= start[1])));
    };
    Ok(PassFrame { axes, signs: [if along < 0.0 { 1.0 } else { -1.0 }, height] })
}

/// A contour that goes one way along Z, or else along X, in its drawing.
fn drawn(profile: &Profile, shift: [f64; 2]) -> Option<(PassFrame, Path)> {
    let rough = Rough { depth: 0.0, retract: 0.0, U: shift[0], W: shift[1], feed: None, both_axes: None };
    [[1, 0], [0, 1]].into_iter().find_map(|axes| {
        let frame = frame(profile, &rough, axes).ok()?;
        let path = Path::of(profile, frame, [0.0; 2]);
        path.goes_back(0, TOLERANCE).is_none().then_some((frame, path))
    })
}

/// True where a contour, moved by a shift, goes below itself across the passes.
pub(super) fn into_metal(profile: &Profile, shift: [f64; 2]) -> bool {
    drawn(profile, shift).is_some_and(|(frame, _)| frame.inward(shift)[1] < -EPS)
}

/// The line of the first block of a contour into which the contour moved by a shift would be cut; none where the contour goes one way
/// along neither axis.
#[must_use]
pub fn cut_into(profile: &Profile, shift: [f64; 2]) -> Option<usize> {
    let (frame, path) = drawn(profile, shift)?;
    let element = path.cut_by(&Path::of(profile, frame, frame.inward(shift)), TOLERANCE)?;
    profile.elements.get(element).map(|element| element.line)
}

/// The line of the first element that passes the starting point across the passes.
fn beyond(profile: &Profile, frame: PassFrame, start: f64, below: bool) -> usize {
    let past = |p: [f64; 2]| if below { frame.inward(p)[1] > start } else { frame.inward(p)[1] < start };
    let last = profile.elements.last().map_or(0, |element| element.line);
    profile.elements.iter().find(|element| past(element.to)).map_or(last, |element| element.line)
}

/// A refusal for a parameter of the cycle's own block that is no number a control would take.
pub(super) fn finite(values: &[f64]) -> Result<(), Box<Trouble>> {
    if values.iter().all(|value| value.is_finite()) {
        return Ok(());
    }
    Err(Trouble::of(&CycleNotFinite {}))
}

/// A way that is to be cut: at which level, under which one, between which places.
struct RoughingPass {
    span: Span,
    level: f64,
    above: f64,
}

fn expand(profile: &Profile, rough: &Rough, axes: [usize; 2]) -> Result<Vec<Move>, Box<Trouble>> {
    finite(&[rough.depth, rough.retract, rough.U, rough.W, rough.feed.unwrap_or(0.0)])?;
    check(profile)?;
    if rough.depth <= 0.0 {
        return Err(Trouble::of(&NoDepthOfCut {}));
    }
    if rough.retract < 0.0 {
        return Err(Trouble::of(&RetractionNegative {}));
    }
    let Some(first) = profile.elements.first() else { return Err(Trouble::of(&ContourNotFound {})) };
    if first.arc.is_some() {
        return Err(Trouble::of(&ContourBeginsWithArc {}).at(first.line));
    }
    let aside = |trouble| if enters_aside(profile, rough, axes) { aside(axes).at(first.line) } else { trouble };
    let frame = frame(profile, rough, axes)?;
    let shift = frame.inward([rough.U, rough.W]);
    if shift.iter().any(|&allowance| allowance < -EPS) {
        return Err(aside(Trouble::of(&AllowanceIntoMetal {})));
    }
    let start = frame.inward(profile.start);
    let top = [start[0] + shift[0], start[1] + shift[1]];
    let path = Path::of(profile, frame, shift);
    let line = |element: usize| profile.elements.get(element).map_or(first.line, |element| element.line);
    let [[_, right], _] = path.reach();
    if right > top[0] + TOLERANCE {
        return Err(aside(Trouble::of(&ContourBeyondStart {}).at(first.line)));
    }
    if let Some(element) = path.goes_back(0, TOLERANCE) {
        return Err(goes_back(axes[0]).at(line(element)));
    }
    let pockets = rough.both_axes.unwrap_or_else(|| (profile.start[axes[0]] - first.to[axes[0]]).abs() > EPS);
    if !pockets && let Some(element) = path.goes_back(1, TOLERANCE) {
        return Err(goes_back(axes[1]).at(line(element)));
    }
    let path = path.with_lead(top[0]);
    let bottom = path.bottom(0..=path.parts.len());
    #[expect(clippy::cast_precision_loss, reason = "a count of blocks")]
    let (walls, parts) = (path.crests() as f64 + 1.0, path.parts.len() as f64);
    let passes = ((top[1] - bottom) / rough.depth - EPS).ceil().max(0.0) * walls;
    #[expect(clippy::cast_precision_loss, reason = "a small constant")]
    let most = (ROUGHING_WORK / parts).min(ROUGHING_PASSES as f64).floor();
    if passes > most {
        return Err(Trouble::of(&TooManyRoughingPasses { passes: Size::number(passes, 0), most }).beyond());
    }
    let mut tool = CycleMoves::new(frame, profile.start);
    tool.rapid(top);
    passes_over(&path, profile, rough, pockets, top, &mut tool);
    // To the start, and once along the contour.
    if pockets {
        tool.rapid([tool.at[0], top[1].max(tool.at[1])]);
    }
    tool.rapid([top[0], tool.at[1]]);
    let by = [rough.U, rough.W];
    for element in &profile.elements {
        tool.element(&moved(element, by), rough.feed);
    }
    tool.rapid([tool.at[0], top[1]]);
    tool.rapid(top);
    tool.rapid(start);
    Ok(tool.moves)
}

/// Refuses a contour with numbers that are none.
pub(super) fn check(profile: &Profile) -> Result<(), Box<Trouble>> {
    finite(&profile.start)?;
    for element in &profile.elements {
        let centre = element.arc.map_or([0.0; 2], |(centre, _)| centre);
        finite(&[element.to[0], element.to[1], centre[0], centre[1]]).map_err(|trouble| trouble.at(element.line))?;
    }
    Ok(())
}

/// All passes, each pocket to its bottom before the next.
fn passes_over(path: &Path, profile: &Profile, rough: &Rough, pockets: bool, top: [f64; 2], tool: &mut CycleMoves) {
    let Some(last) = path.parts.len().checked_sub(1) else { return };
    let below = |range: std::ops::RangeInclusive<usize>, above: f64| -> Vec<RoughingPass> {
        let bottom = path.bottom(range.clone());
        if above - bottom < EPS {
            return Vec::new();
        }
        let level = (above - rough.depth).max(bottom);
        let level = if level - bottom < EPS { bottom } else { level };
        let mut passes: Vec<RoughingPass> =
            path.spans(level, range).into_iter().map(|span| RoughingPass { span, level, above }).collect();
        passes.reverse();
        passes
    };
    let lines = &profile.elements;
    let lead_at_rapid = lines.first().is_some_and(|first| first.rapid);
    let mut left = below(0..=last, top[1]);
    while let Some(RoughingPass { span, level, above }) = left.pop() {
        let from = span.open.map_or(top[0], |open| open.at[0]);
        let to = span.close.map_or_else(|| path.end().map_or(from, |end| end[0]), |close| close.at[0]);
        if from - to < TOLERANCE {
            continue;
        }
        // Over what is cut already.
        let over = if tool.at[0] < top[0] - EPS { above + rough.retract } else { above };
        tool.rapid([tool.at[0], tool.at[1].max(over)]);
        match span.open {
            None => {
                tool.rapid([top[0], tool.at[1]]);
                if lead_at_rapid {
                    tool.rapid([top[0], level]);
                } else {
                    tool.feed([top[0], level], rough.feed);
                }
            }
            Some(open) => {
                let (entry, legs) = path.fall(open, above);
                tool.rapid([entry[0], tool.at[1]]);
                // At feed from there: under a brim that lies lower, metal stands beside the way.
                tool.rapid([entry[0], tool.at[1].min(above + rough.retract)]);
                tool.feed(entry, rough.feed);
                tool.follow(&legs, lines, rough.feed);
            }
        }
        tool.feed([to, level], rough.feed);
        if pockets {
            if let Some(close) = span.close {
                tool.follow(&path.rise(close, above), lines, rough.feed);
            }
            tool.rapid([tool.at[0], tool.at[1] + rough.retract]);
        } else {
            tool.rapid([tool.at[0] + rough.retract, tool.at[1] + rough.retract]);
        }
        let range = span.open.map_or(0, |open| open.part)..=span.close.map_or(last, |close| close.part);
        left.extend(below(range, level));
    }
}
