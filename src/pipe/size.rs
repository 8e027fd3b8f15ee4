//! stand-in until the table lands
use crate::parameter::{Choice, t};
pub const NPS: &[Choice] = &[Choice { key: "3", label: t("3", "3") }, Choice { key: "4", label: t("4", "4") }];
pub const SCHEDULES: &[Choice] = &[Choice { key: "40", label: t("40", "40") }];
#[must_use]
pub fn wall(nps: &str, schedule: &str) -> Option<(f64, f64)> {
    match (nps, schedule) {
        ("3", "40") => Some((88.9, 5.49)),
        ("4", "40") => Some((114.3, 6.02)),
        _ => None,
    }
}
