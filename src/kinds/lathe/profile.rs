//! The wanted profile of a turning's workbook, and how the part compares with it.

use crate::finding::{Finding, Place};
use crate::geometry::exact::region::Ring;
use crate::kinds::lathe::parameters::{Element, PROFILE_G, PROFILE_KEY, PROFILE_R, PROFILE_X, PROFILE_Z};
use crate::number::shown;
use crate::number::trig::hypot;
use crate::parameter::Parameter;
use crate::parameter::field::{Entry, Fields};
use crate::removal::turning::deviation::{Profile, Span, Unmeasured, deviation};
use crate::table::{Quantity, Unit};
use crate::text::{Text, t};

/// The wanted profile of the sheet; `None` where there is none.
///
/// # Errors
/// The cells of a profile that has one point only, and of an arc without a radius or one that does not reach its end.
pub(super) fn wanted(fields: &Fields) -> Result<Option<Profile>, Box<Finding>> {
    let mut rows = fields.rows(PROFILE_KEY).peekable();
    let point = |row: &Entry<'_>| [row.get(&PROFILE_Z), row.get(&PROFILE_X) / 2.0];
    let stop = |row: &Entry<'_>, column: &Parameter, what, remedy| {
        Err(Box::new(Finding::stop(Place::Cells(row.cell(column)), what, remedy)))
    };
    let Some(first) = rows.next() else { return Ok(None) };
    if rows.peek().is_none() {
        return stop(
            &first,
            &PROFILE_G.row,
            t("el perfil tiene un solo punto", "the profile has one point only"),
            t("escriba también dónde termina, o borre la fila", "write where it ends too, or delete the row"),
        );
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
            return stop(
                &row,
                &PROFILE_R.row,
                t("el arco del perfil no tiene radio", "the arc of the profile has no radius"),
                t("escriba el radio", "write the radius"),
            );
        };
        let span = Span::Arc { to, radius, clockwise };
        if (Profile { start: from, spans: vec![span] }).points().is_none() {
            let chord = hypot(to[0] - from[0], to[1] - from[1]);
            let [r, c, half] = [radius, chord, chord / 2.0].map(|value| shown(value, 3));
            return stop(
                &row,
                &PROFILE_R.row,
                Text::new(
                    format!("el arco del perfil tiene {r} mm de radio y su cuerda mide {c} mm: no llega a su final"),
                    format!(
                        "the arc of the profile has a radius of {r} mm and a chord of {c} mm: it does not reach its end"
                    ),
                ),
                if chord > 0.0 {
                    Text::new(
                        format!("dé un radio de al menos {half} mm"),
                        format!("give a radius of at least {half} mm"),
                    )
                } else {
                    t("corrija X y Z: el arco termina donde empieza", "correct X and Z: the arc ends where it begins")
                },
            );
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
            let finding = Finding::caution(
                Place::File,
                t(
                    "de la pieza no queda nada que comparar con el perfil de la hoja PERFIL del libro",
                    "nothing is left of the part to hold against the profile on the workbook's sheet PROFILE",
                ),
                t("corrija el programa, o borre el perfil", "correct the program, or delete the profile"),
            );
            return (finding, false);
        }
        Err(Unmeasured::Work) => {
            let corners: usize = contours.iter().map(Vec::len).sum();
            let lines = profile.spans.len();
            let finding = Finding::stop(
                Place::File,
                Text::new(
                    format!(
                        "comparar la pieza ({corners} esquinas) con el perfil de la hoja PERFIL del libro ({lines} tramos) pide más trabajo del que se hace"
                    ),
                    format!(
                        "to hold the part ({corners} corners) against the profile on the workbook's sheet PROFILE ({lines} spans) takes more work than is done"
                    ),
                ),
                t(
                    "elija una tolerancia eps mayor, o un perfil de menos tramos",
                    "choose a greater tolerance eps, or a profile of fewer spans",
                ),
            );
            return (finding, true);
        }
    };
    let [over, under] = [found.over, found.under].map(|one| one.map_or(0.0, |(by, _)| by));
    for (symbol, meaning, value) in [
        ("dev_plus", t("Material de más sobre el perfil", "Metal left on the profile"), over),
        ("dev_minus", t("Material de menos en el perfil", "Metal missing from the profile"), under),
    ] {
        let source = t("contorno contra la hoja del perfil", "contour against the sheet of the profile");
        quantities.push(Quantity { symbol, meaning, value, unit: Unit::Millimetre, source });
    }
    let place = |one: Option<(f64, [f64; 2])>| {
        one.map_or(String::new(), |(_, [z, r])| format!(" (X{} Z{})", shown(2.0 * r, 3), shown(z, 3)))
    };
    let (plus, minus) = (place(found.over), place(found.under));
    let (over, under) = (shown(over, 4), shown(under, 4));
    let finding = Finding::note(
        Place::File,
        Text::new(
            format!(
                "frente al perfil de la hoja PERFIL del libro sobran hasta {over} mm{plus} y faltan hasta {under} mm{minus}"
            ),
            format!(
                "against the profile on the workbook's sheet PROFILE up to {over} mm are left{plus} and up to {under} mm are missing{minus}"
            ),
        ),
    );
    (finding, false)
}
