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
    use crate::text::t;

    #[test]
    fn the_words_name_the_control_that_needs_a_feed() {
        let row = feed_needed(LiveRow::length("style", "live_style", t("a", "a"), "style&\"\""));
        assert!(needing_feed().count() > 0 && row.wrong.len() == needing_feed().count());
        for (wrong, control) in row.wrong.iter().zip(needing_feed()) {
            assert!([&wrong.words.es, &wrong.words.en].iter().all(|words| words.contains(control.name)), "{wrong:?}");
        }
    }
}
