//! What the live forms of several kinds say alike.

use crate::gcode::control::{Control, MILLING};
use crate::gcode::program::Style;
use crate::kind::live_form::{LiveRow, holds, says};
use crate::text::Text;

/// The controls that do not move at feed without F.
fn needing_feed() -> impl Iterator<Item = &'static Control> {
    MILLING.into_iter().filter(|control| control.feed.missing.refused())
}

/// The row of the style, with the limit that programs as they are published have no feed: not every control moves without one.
pub(crate) fn feed_needed(style: LiveRow) -> LiveRow {
    needing_feed().fold(style, |row, control| {
        row.wrong(
            format!("AND({},{})", holds("style", Style::Annex), says("dialect", control.name)),
            Text::new(
                format!("anexo no lleva avance, y {} lo necesita", control.name),
                format!("annex has no feed, and {} needs one", control.name),
            ),
            "style",
        )
    })
}

#[cfg(test)]
mod tests {
    use super::{feed_needed, needing_feed};
    use crate::kind::live_form::LiveRow;
    use crate::kinds::KINDS;
    use crate::parameter::{FieldKind, Parameter};
    use crate::text::t;

    /// AND and OR compute all that they hold, so a text in a cell must not come to arithmetic inside them: only a branch of IF, or N,
    /// keeps it out.
    #[test]
    fn no_formula_computes_with_the_text_of_a_cell_that_is_no_input() {
        let mut seen = 0;
        for kind in KINDS {
            let Some(form) = kind.live() else { continue };
            let own = kind.form().parameters().map(|(_, one)| one).filter(|one| !form.inputs.contains(&one.name));
            let numbers: Vec<&Parameter> =
                own.filter(|one| matches!(one.kind, FieldKind::Real { .. } | FieldKind::Whole { .. })).collect();
            let rows = form
                .rows
                .iter()
                .flat_map(|row| std::iter::once(&row.formula).chain(row.wrong.iter().map(|wrong| &wrong.when)));
            let all = rows.chain(form.unsound.iter().map(|one| &one.when)).chain(form.view.columns.iter().flatten());
            for formula in all {
                for name in numbers.iter().map(|one| one.name) {
                    let letter = |one: char| one.is_alphanumeric() || one == '_';
                    let around = |(at, _)| (&formula[..at], &formula[at + name.len()..]);
                    let own =
                        |(before, behind): &(&str, &str)| !before.ends_with(letter) && !behind.starts_with(letter);
                    let mut places = formula.match_indices(name).map(around).filter(own).peekable();
                    seen += usize::from(places.peek().is_some());
                    let sign = |one: char| "+-*/^".contains(one);
                    let computed = places.any(|(before, behind)| before.ends_with(sign) || behind.starts_with(sign));
                    let kept = [format!("IF(ISNUMBER({name})"), "IF(COUNT(".to_owned()];
                    let kept = kept.iter().any(|guard| formula.contains(guard));
                    assert!(!computed || kept, "{}: {name}: {formula}", kind.form().kind);
                }
            }
        }
        assert!(seen > 10, "{seen} formulas");
    }

    #[test]
    fn the_words_name_the_control_that_needs_a_feed() {
        let row = feed_needed(LiveRow::length("style", "live_style", t("a", "a"), "style&\"\""));
        assert!(needing_feed().count() > 0 && row.wrong.len() == needing_feed().count());
        for (wrong, control) in row.wrong.iter().zip(needing_feed()) {
            assert!([&wrong.words.es, &wrong.words.en].iter().all(|words| words.contains(control.name)), "{wrong:?}");
        }
    }
}
