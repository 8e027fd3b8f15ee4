//! The wanted profile of a turning's workbook, and how the part compares with it.

use crate::finding::{Finding, Place, Raise, Size};
use crate::geometry::exact::region::Ring;
use crate::kinds::lathe::parameters::{Element, PROFILE_G, PROFILE_KEY, PROFILE_R, PROFILE_X, PROFILE_Z};
use crate::kinds::lathe::rules::{
    ArcFallsShort, ArcWithoutChord, ArcWithoutRadius, Compared, ComparisonTooMuchWork, NothingToCompare,
    ProfileOfOnePoint,
};
use crate::number::shown;
use crate::number::trig::hypot;
use crate::parameter::Parameter;
use crate::parameter::field::{Entry, Fields};
use crate::removal::turning::deviation::{Profile, Span, Unmeasured, deviation};
use crate::table::{Quantity, Unit};
use crate::text::t;

/// The wanted profile of the sheet; `None` where there is none.
///
/// # Errors
/// The cells of a profile that has one point only, and of an arc without a radius or one that does not reach its end.
pub(super) fn wanted(fields: &Fields) -> Result<Option<Profile>, Box<Finding>> {
    let mut rows = fields.rows(PROFILE_KEY).peekable();
    let point = |row: &Entry<'_>| [row.get(&PROFILE_Z), row.get(&PROFILE_X) / 2.0];
    let stop =
        |row: &Entry<'_>, column: &Parameter, told: &dyn Raise| Err(Box::new(told.at(Place::Cells(row.cell(column)))));
    let Some(first) = rows.next() else { return Ok(None) };
    if rows.peek().is_none() {
        return stop(&first, &PROFILE_G.row, &ProfileOfOnePoint {});
    }
    let mut profile = Profile { start: point(&first), spans: Vec::new() };
    let mut from = profile.start;
    for row in rows {
        let to = point(&row);
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
    Ok(Some(profile))
}

/// How the part compares with the wanted profile, as quantities and a finding, and whether that was left undone for want of
/// work; `most_work` is how many steps of it are left.
pub(super) fn compared(
    contours: &[Ring],
    profile: &Profile,
    most_work: u64,
    quantities: &mut Vec<Quantity>,
) -> (Finding, bool) {
    let found = match deviation(contours, profile, most_work) {
        Ok(found) => found,
        Err(Unmeasured::Gone) => {
            return (NothingToCompare {}.at(Place::File), false);
        }
        Err(Unmeasured::Work) => {
            let corners: usize = contours.iter().map(Vec::len).sum();
            let spans = profile.spans.len();
            return (ComparisonTooMuchWork { corners, spans }.at(Place::File), true);
        }
    };
    let [over, under] = [found.over, found.under].map(|one| one.map_or(0.0, |(by, _)| by));
    for (symbol, meaning, value) in [
        ("dev_plus", t("Material de más sobre el perfil", "Metal left on the profile"), over),
        ("dev_minus", t("Material de menos en el perfil", "Metal missing from the profile"), under),
    ] {
        let source = t("contorno contra la hoja del perfil", "contour against the sheet of the profile");
        quantities.push(Quantity { symbol, meaning, value, unit: Unit::Millimetre, source, cell: None });
    }
    let place = |one: Option<(f64, [f64; 2])>| {
        one.map_or(String::new(), |(_, [z, r])| format!(" (X{} Z{})", shown(2.0 * r, 3), shown(z, 3)))
    };
    let [most, least] = [found.over, found.under].map(place);
    let [over, under] = [over, under].map(|by| Size { decimals: 4, ..Size::mm(by) });
    (Compared { over, most, under, least }.at(Place::File), false)
}
