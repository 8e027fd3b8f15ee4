//! What the plan of an impeller leaves or spoils, reported with figures and places: for a person to judge before the work.

use crate::finding::{Finding, Limit, Raise, Said, Size};
use crate::kinds::impeller::clear::rules::{GapBelowRule, Largest};
use crate::kinds::impeller::clear::tool::Tool;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::floor_depth::{self, deepest};
use crate::kinds::impeller::gap::Limits;
use crate::kinds::impeller::parameters as form;
use crate::kinds::impeller::part::Part;
use crate::kinds::impeller::programs::Tracks;
use crate::kinds::impeller::ribs::ribs;
use crate::kinds::impeller::rules::{FloorTooDeep, GapBelowPublished, IntoOwnFaces, RibsLeft, ToolDoesNotPass};
use crate::kinds::impeller::sweep::Sweep;
use crate::kinds::impeller::track::Track;
use crate::kinds::impeller::undercut::{self, Undercut, undercut};
use crate::number::shown;
use crate::parameter::at;
use crate::text::{Language, Text, t};

/// Below this nothing is said of a depth, mm: it is what the output grid moves the tool.
const UNSAID: f64 = 0.01;

/// What the passes leave and spoil, from the positions that the programs go through.
pub(super) fn shortfalls(design: &Design, tracks: &Tracks) -> Vec<Finding> {
    let part = Part::new(design);
    let height = undercut::height(design.a_p, design.d_t);
    let sweeps: Vec<Sweep> =
        Track::ALL.into_iter().filter_map(|track| Sweep::new(design, tracks, track, height)).collect();
    let (left, (deep, faces)) = rayon::join(
        || left_standing(design, &part, &sweeps),
        || rayon::join(|| too_deep(design, &sweeps), || into_faces(design, &part, &sweeps)),
    );
    [left, deep, faces].into_iter().flatten().collect()
}

/// A length that is not more, in mm: rounded up.
fn at_most(value: f64) -> Size {
    Size::mm((value * 1000.0).ceil() / 1000.0)
}

fn left_standing(design: &Design, part: &Part, sweeps: &[Sweep]) -> Option<Finding> {
    let ribs = ribs(part, design.N, design.d_t, sweeps);
    let from = Size::percent((ribs.from? * 100.0).floor(), 0);
    let most = Size::percent((ribs.share * 1000.0).ceil() / 10.0, 1);
    let across = at_most(ribs.width * design.torus.r / design.torus.R);
    let told = RibsLeft { most, from, width: at_most(ribs.width), across };
    let place = at([form::D_T.key(), form::N.key(), form::E.key(), form::SPLITTERS.key()]);
    Some(told.at(place).with(most.said(Language::En), "0 %").measuring(100.0 * ribs.share, Limit::AtMost(0.0)))
}

fn too_deep(design: &Design, sweeps: &[Sweep]) -> Option<Finding> {
    let deepest = deepest(design.torus, design.a_p, Tool::flat(design.d_t), sweeps, floor_depth::CLOSE)?;
    if deepest.most <= UNSAID {
        return None;
    }
    let law = at_most(floor_depth::law(design.torus, design.a_p, design.e, design.d_t));
    let (most, point) = (at_most(deepest.most), Size::number(deepest.x, 1));
    let told = FloorTooDeep { most, track: deepest.track.name().clone(), point, law };
    let told = told.at(at([form::D_T.key(), form::A_P.key(), form::E.key()])).with(most.said(Language::En), "0 mm");
    Some(told.measuring(deepest.most, Limit::AtMost(0.0)))
}

fn into_faces(design: &Design, part: &Part, sweeps: &[Sweep]) -> Option<Finding> {
    let found: Vec<(Track, Undercut)> =
        sweeps.iter().filter_map(|sweep| undercut(part, sweep, design.d_t).map(|found| (sweep.track, found))).collect();
    let law = at_most(undercut::law(design.torus, design.a_p, design.d_t));
    let most = found.iter().map(|(_, found)| found.most).fold(0.0, f64::max);
    if most <= UNSAID {
        return None;
    }
    let list = |language: Language, at: &str| {
        let one = |(track, found): &(Track, Undercut)| {
            let name = track.name().get(language);
            format!("{name} {} ({at} {})", at_most(found.most).said(language), shown(found.x, 1))
        };
        found.iter().map(one).collect::<Vec<_>>().join(", ")
    };
    let faces = Text::new(list(Language::Es, "punto"), list(Language::En, "point"));
    let told = IntoOwnFaces { most: at_most(most), faces, law }.at(at([
        form::A_P.key(),
        form::D_T.key(),
        form::INTERVALS_N.key(),
        form::E.key(),
    ]));
    Some(told.with(at_most(most).said(Language::En), "0 mm").measuring(most, Limit::AtMost(0.0)))
}

/// The caution, or with a clear cut the note, for blades that are nearer to each other than the published limits say.
pub(super) fn too_narrow(design: &Design, limits: &Limits) -> Option<Finding> {
    if limits.beside >= limits.least {
        return None;
    }
    // The largest tool that passes goes to another depth than the design's own, which the rule is asked of.
    let width = if limits.gap.width < limits.least { limits.gap.width } else { limits.beside };
    let (gap, least, tool) = (Size::mm(width), Size::mm(limits.least), Size::mm(design.d_t));
    let station = Size::percent(limits.gap.station * 100.0, 1);
    let largest = Largest((gap.value >= 0.001).then_some(gap));
    let blades = match limits.N_max {
        Some(N) => Text::new(
            format!("N_max real = {N} (publicado: {})", published(design)),
            format!("true N_max = {N} (published: {})", published(design)),
        ),
        None => {
            t("N_max real: ninguno, ni un solo álabe deja sitio", "true N_max: none, not even one blade leaves room")
        }
    };
    let thickness = match limits.e_max {
        Some(e) => Text::new(
            format!("e_max real = {} mm con {} álabes", shown(e, 3), design.N),
            format!("true e_max = {} mm for {} blades", shown(e, 3), design.N),
        ),
        None => Text::new(
            format!("e_max real: ninguno, {} álabes no dejan sitio por delgados que sean", design.N),
            format!("true e_max: none, {} blades leave no room however thin they are", design.N),
        ),
    };
    let place = at([form::N.key(), form::E.key(), form::D_T.key()]);
    let told = if limits.gap.width < design.d_t {
        ToolDoesNotPass { tool, largest, at: station, blades, thickness }.at(place)
    } else if design.clear.is_some() {
        // Whether the tools of a clear cut pass is judged of their own passes.
        GapBelowRule { gap, tool, least }.at(place)
    } else {
        GapBelowPublished { gap, tool, least, at: station, blades, thickness }.at(place)
    };
    let told = told.with(largest.said(Language::En), least.said(Language::En));
    Some(told.measuring(width, Limit::AtLeast(limits.least)))
}

fn published(design: &Design) -> String {
    shown(crate::kinds::impeller::blade_count::N_max(design.torus, design.a_p, design.e, design.d_t), 0)
}
