//! What the live forms of several kinds say alike.

use crate::gcode::control::{Control, MILLING};
use crate::gcode::program::Style;
use crate::kind::live_form::{LiveRow, holds, says};
use crate::text::t;

/// The controls that do not move at feed without F.
fn needing_feed() -> impl Iterator<Item = &'static Control> {
    MILLING.into_iter().filter(|control| control.feed.missing.refused())
}

/// The row of the style, with the limit that programs as they are published have no feed: not every control moves without one.
pub(crate) fn feed_needed(style: LiveRow) -> LiveRow {
    needing_feed().fold(style, |row, control| {
        row.wrong(
            format!("AND({},{})", holds("style", Style::Annex), says("dialect", control.name)),
            t("anexo no lleva avance, y LinuxCNC lo necesita", "annex has no feed, and LinuxCNC needs one"),
            "style",
        )
    })
}

#[cfg(test)]
mod tests {
    use super::needing_feed;

    #[test]
    fn the_control_that_needs_a_feed_is_the_one_that_the_words_name() {
        assert_eq!(needing_feed().map(|control| control.name).collect::<Vec<_>>(), ["linuxcnc"]);
    }
}
