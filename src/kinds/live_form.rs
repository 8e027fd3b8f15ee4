//! What the live forms of several kinds say alike.

use crate::gcode::control::MILLING;
use crate::gcode::program::Style;
use crate::kind::live_form::{LiveRow, holds, says};
use crate::text::Text;

/// The row of the style, with the limit that programs as they are published have no feed: not every control moves without one.
pub(crate) fn feed_needed(style: LiveRow) -> LiveRow {
    MILLING.into_iter().filter(|control| control.feed.missing.refused()).fold(style, |row, control| {
        let name = control.name;
        row.wrong(
            format!("AND({},{})", holds("style", Style::Annex), says("dialect", name)),
            Text::new(
                format!("anexo no lleva avance, y {name} lo necesita"),
                format!("annex has no feed, and {name} needs one"),
            ),
            "style",
        )
    })
}
