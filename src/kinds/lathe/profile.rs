//! The wanted profile of a turning's workbook, and how the part compares with it.

use crate::finding::{CellPlace, Finding, Limit, Place, Raise, Size};
use crate::geometry::exact::region::Ring;
use crate::kinds::lathe::parameters::{Element, PROFILE_G, PROFILE_KEY, PROFILE_R, PROFILE_X, PROFILE_Z};
use crate::kinds::lathe::rules::{
    ArcFallsShort, ArcWithoutChord, ArcWithoutRadius, Compared, ComparisonTooMuchWork, MetalMissing, NothingToCompare,
    ProfileOfOnePoint,
};
use crate::number::shown;
use crate::number::trig::hypot;
use crate::parameter::Parameter;
use crate::parameter::field::{Entry, Fields};
use crate::removal::turning::deviation::{CHORDS, Profile, Span, Unmeasured, deviation};
use crate::removal::turning::thread_groove::ThreadGroove;
use crate::table::{Quantity, Unit};
use crate::text::{Text, t};

/// The wanted profile, and where it stands on the sheet.
pub(super) struct WantedProfile {
    pub(super) profile: Profile,
    /// The cells of each span's end, X and Z.
    cells: Vec<Vec<CellPlace>>,
}

impl WantedProfile {
    /// The cells of the span that is nearest to a point, `[z, r]` in mm.
    fn row(&self, point: [f64; 2]) -> Place {
        let cells = self.profile.nearest(point).and_then(|span| self.cells.get(span));
        cells.map_or(Place::File, |cells| Place::Cells(cells.clone()))
    }
}

/// The wanted profile of the sheet; `None` where there is none.
///
/// # Errors
/// The cells of a profile that has one point only, and of an arc without a radius or one that does not reach its end.
pub(super) fn wanted(fields: &Fields) -> Result<Option<WantedProfile>, Box<Finding>> {
    let mut rows = fields.rows(PROFILE_KEY).peekable();
    let point = |row: &Entry<'_>| [row.get(&PROFILE_Z), row.get(&PROFILE_X) / 2.0];
    let stop =
        |row: &Entry<'_>, column: &Parameter, told: &dyn Raise| Err(Box::new(told.at(Place::Cells(row.cell(column)))));
    let Some(first) = rows.next() else { return Ok(None) };
    if rows.peek().is_none() {
        return stop(&first, &PROFILE_G.row, &ProfileOfOnePoint {});
    }
    let mut profile = Profile { start: point(&first), spans: Vec::new() };
    let mut cells = Vec::new();
    let mut from = profile.start;
    for row in rows {
        let to = point(&row);
        cells.push([row.cell(&PROFILE_X.row), row.cell(&PROFILE_Z.row)].concat());
        let clockwise = match row.get(&PROFILE_G) {
            Element::Clockwise => true,
            Element::CounterClockwise => false,
            Element::Line => {
                profile.spans.push(Span::Line(to));
                from = to;
                continue;
            }
        };
        let Some(radius) = row.get(&PROFILE_R) else {
            return stop(&row, &PROFILE_R.row, &ArcWithoutRadius {});
        };
        let span = Span::Arc { to, radius, clockwise };
        if (Profile { start: from, spans: vec![span] }).points().is_none() {
            let chord = hypot(to[0] - from[0], to[1] - from[1]);
            let [r, chord, half] = [radius, chord, chord / 2.0].map(Size::mm);
            let row = |told: &dyn Raise| stop(&row, &PROFILE_R.row, told);
            return if chord.value > 0.0 {
                row(&ArcFallsShort { r, chord, half })
            } else {
                row(&ArcWithoutChord { r, chord })
            };
        }
        profile.spans.push(span);
        from = to;
    }
    Ok(Some(WantedProfile { profile, cells }))
}

/// The most by which what is programmed and what is written as the profile are off for being written in thousandths of a millimetre, mm.
///
/// # Derivation
/// Each point of either is rounded by half a thousandth along Z and along X, which is a diameter: by 0.0005 and 0.00025 mm. Of both
/// together that is √(0.001² + 0.0005²).
const GRID: f64 = 0.001_12;

/// How far a surface may lie under the wanted profile without missing metal, mm, where curves are chords within a tolerance.
///
/// # Derivation
/// The nose and the arc that it follows are chords within the tolerance each, the arcs of the profile within [`CHORDS`], and the
/// words and cells have three decimals.
fn explained(tolerance: f64) -> f64 {
    2.0 * tolerance + CHORDS + GRID
}

/// A part that is compared with its profile.
pub(super) struct Comparison<'c> {
    /// Its contours, `[z, r]` in mm.
    pub(super) contours: &'c [Ring],
    /// The tolerance of its curves, mm.
    pub(super) tolerance: f64,
    /// It was turned about: they are in coordinates of the second set-up.
    pub(super) second: bool,
    /// The grooves of its threads: a profile has none, so that they explain missing metal.
    pub(super) grooves: &'c [ThreadGroove],
    /// How many steps of work are left.
    pub(super) most_work: u64,
}

/// How the part compares with the wanted profile, as quantities and findings, and whether that was left undone for want of work.
pub(super) fn compared(
    part: &Comparison<'_>,
    wanted: &WantedProfile,
    quantities: &mut Vec<Quantity>,
) -> (Vec<Finding>, bool) {
    let (contours, profile) = (part.contours, &wanted.profile);
    let found = match deviation(contours, profile, part.grooves, part.most_work) {
        Ok(found) => found,
        Err(Unmeasured::Gone) => {
            return (vec![NothingToCompare {}.at(Place::File)], false);
        }
        Err(Unmeasured::Work) => {
            let corners: usize = contours.iter().map(Vec::len).sum();
            let spans = profile.spans.len();
            return (vec![ComparisonTooMuchWork { corners, spans }.at(Place::File)], true);
        }
    };
    // All that is missing, whether a thread explains it or not.
    let all =
        [found.under, found.threaded].into_iter().flatten().reduce(|one, two| if two.0 > one.0 { two } else { one });
    let [over, under, missing] = [found.over, found.under, all].map(|one| one.map_or(0.0, |(by, _)| by));
    for (symbol, meaning, value) in [
        ("dev_plus", t("Material de más sobre el perfil", "Metal left on the profile"), over),
        ("dev_minus", t("Material de menos en el perfil", "Metal missing from the profile"), missing),
    ] {
        let source = t("contorno contra la hoja del perfil", "contour against the sheet of the profile");
        quantities.push(Quantity { symbol, meaning, value, unit: Unit::Millimetre, source, cell: None });
    }
    let place = |one: Option<(f64, [f64; 2])>| {
        one.map_or(String::new(), |(_, [z, r])| format!(" (X{} Z{})", shown(2.0 * r, 3), shown(z, 3)))
    };
    let [most, least, deepest] = [found.over, found.under, all].map(place);
    let held = if part.second {
        t(" (en cotas del segundo amarre)", " (in coordinates of the second set-up)")
    } else {
        t("", "")
    };
    let limit = explained(part.tolerance);
    let scrapped = (under > limit).then(|| {
        let told = MetalMissing { held: held.clone(), under: Size::length(under, 4), least };
        let told = told.at(found.under.map_or(Place::File, |(_, place)| wanted.row(place)));
        told.with(format!("{} mm", shown(under, 4)), format!("≤ {} mm", shown(limit, 4)))
            .measuring(under, Limit::AtMost(limit))
    });
    let held = if found.threaded.is_some() {
        let Text { es, en } = held;
        Text::new(format!("{es}, con la rosca como metal que falta"), format!("{en}, with the thread as missing metal"))
    } else {
        held
    };
    let [over, under] = [over, missing].map(|by| Size::length(by, 4));
    let note = Compared { held, over, most, under, least: deepest }.at(Place::File);
    (scrapped.into_iter().chain([note]).collect(), false)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::finding::Grade;
    use crate::removal::turning::thread_groove::OUTSIDE;

    /// A bar of radius 10 less so much, against a profile of radius 10: what is told.
    fn told(under: f64, second: bool) -> Vec<Finding> {
        let r = 10.0 - under;
        let contours = [vec![[-50.0, 0.0], [0.0, 0.0], [0.0, r], [-50.0, r]]];
        let part = Comparison { contours: &contours, tolerance: 0.0002, second, grooves: &[], most_work: 1_000_000 };
        compared(&part, &line([-40.0, 10.0]), &mut Vec::new()).0
    }

    /// A cell of the sheet.
    fn cell(cell: &str) -> CellPlace {
        CellPlace { sheet: "PROFILE".to_owned(), cell: cell.to_owned() }
    }

    /// A profile of one line.
    fn line(to: [f64; 2]) -> WantedProfile {
        let profile = Profile { start: [-1.0, 10.0], spans: vec![Span::Line(to)] };
        WantedProfile { profile, cells: vec![vec![cell("B6"), cell("C6")]] }
    }

    #[test]
    fn missing_metal_is_told_at_the_row_of_its_span() {
        // Straight at radius 10, a quarter of a circle inwards, and on at radius 8; metal is missing from one of them.
        let arc = Span::Arc { to: [-22.0, 8.0], radius: 2.0, clockwise: false };
        let spans = vec![Span::Line([-20.0, 10.0]), arc, Span::Line([-40.0, 8.0])];
        let rows = [["B6", "C6"], ["B7", "C7"], ["B8", "C8"]];
        let cells = rows.map(|row| row.map(cell).to_vec());
        let wanted = WantedProfile { profile: Profile { start: [-1.0, 10.0], spans }, cells: cells.to_vec() };
        for (at, row) in [([-10.0, 9.0], 0), ([-18.0, 10.5], 0), ([-20.6, 8.4], 1), ([-30.0, 7.0], 2)] {
            assert_eq!(wanted.row(at), Place::Cells(cells[row].clone()), "{at:?}");
        }
        assert_eq!(told(1.0, false)[0].place, Place::Cells(vec![cell("B6"), cell("C6")]));
    }

    #[test]
    fn missing_metal_is_a_caution_from_where_no_tolerance_explains_it() {
        // 2 · 0.0002 + 0.00001 + 0.00112.
        for (under, cautions) in [(0.0, 0), (0.0015, 0), (0.0016, 1), (1.0, 1), (-1.0, 0)] {
            let found = told(under, false);
            let grave = found.iter().filter(|one| one.is(MetalMissing::RULE) && one.grade == Grade::Caution).count();
            assert_eq!((grave, found.len()), (cautions, cautions + 1), "{under}: {found:?}");
        }
        let found = told(1.0, false);
        assert!(found[0].what.en.contains("up to 1 mm is missing (X20 Z-1)"), "{:?}", found[0].what);
    }

    #[test]
    fn a_thread_excuses_no_metal_missing_elsewhere() {
        // Radius 9 under the thread; behind it 10 as wanted, or 1.5 mm less in one place.
        let told = |less: f64| {
            let r = 10.0 - less;
            let thread = [[-50.0, 0.0], [0.0, 0.0], [0.0, 9.0], [-20.0, 9.0], [-20.0, 10.0], [-25.0, 10.0]];
            let contours = [thread.into_iter().chain([[-25.0, r], [-50.0, r]]).collect::<Vec<_>>()];
            let part = Comparison {
                contours: &contours,
                tolerance: 0.0002,
                second: false,
                grooves: &[OUTSIDE],
                most_work: 1_000_000,
            };
            compared(&part, &line([-40.0, 10.0]), &mut Vec::new()).0
        };
        let found = told(0.0);
        assert!(found.len() == 1 && found[0].is(Compared::RULE), "{found:?}");
        assert!(found[0].what.en.contains("with the thread as missing metal"), "{:?}", found[0].what);
        let found = told(1.5);
        assert!(found.len() == 2 && found[0].is(MetalMissing::RULE) && found[1].is(Compared::RULE), "{found:?}");
        assert!(found[0].what.en.contains("up to 1.5 mm is missing"), "{:?}", found[0].what);
    }

    #[test]
    fn it_is_said_in_which_set_up_the_profile_is_written() {
        for (second, wanted) in [(false, false), (true, true)] {
            let found = told(1.0, second);
            assert!(found.iter().all(|one| one.what.en.contains("of the second set-up") == wanted), "{found:?}");
            assert!(found.iter().all(|one| one.what.es.contains("del segundo amarre") == wanted), "{found:?}");
        }
    }
}
